#!/usr/bin/env bash
# A second book, of two chapters on the pendulum, made with the installed weave: nothing of this project is at hand but that.
#
#   tiny_book.sh BUILD    the build whose weave is installed for it
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --component weave --prefix "$work/there" >/dev/null
cp -r "$here/pendulum" "$work/book"
cd "$work/book"
cmake -G Ninja -B build -DCMAKE_PREFIX_PATH="$work/there" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
cmake --build build --target all book >"$work/log" 2>&1 || { tail -n 40 "$work/log"; exit 1; }
tail -n 1 "$work/log"

# What the pages owe: receipts, figures, what the programs printed
fail() { echo "$1" >&2; exit 1; }
html=build/book/html
[[ -f $html/index.html && -f $html/chapter_02.html ]] || fail "no pages"
grep -q 'cases, worst relative error' $html/chapter_01.html || fail "no receipt in chapter 1"
grep -q 'evaluated as printed' $html/chapter_02.html || fail "the integral of chapter 2 was not evaluated"
grep -q 'A weight on a string was the first good clock' $html/index.html || fail "the first page lacks the book's words"
! grep -qi 'polygon\|playground' $html/index.html || fail "the first page speaks of another book"
[[ -f $html/figures/02-large-swings/late.svg ]] || fail "no figure"
ctest --test-dir build >"$work/log" 2>&1 || { tail -n 20 "$work/log"; exit 1; }

# A constant that is wrong stops the book, which names the equation; chapter 2 has it, too, and may be the first to stop
sed -i 's/return 2.0 \* std::numbers::pi/return 2.002 * std::numbers::pi/' src/pendulum/small.hpp
if cmake --build build --target book -- -k 0 >"$work/log" 2>&1; then fail "a wrong constant made a book"; fi
grep -q 'small.period' "$work/log" ||
    { tail -n 40 "$work/log"; fail "the equation with the wrong constant was not named"; }
echo "a book of two chapters was made, and a wrong constant stopped it"
