#!/usr/bin/env bash
# exercise.sh start NN            puts the beginnings of chapter NN's exercises into my/, and leaves what is there
# exercise.sh check NN BUILD      builds the answers in my/ in the build folder BUILD and tries them
# Status: 0 done, all answers pass; 1 an answer fails; 2 no such chapter, or nothing to check.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

usage() {
    sed -n '2,3s/^# //p' "${BASH_SOURCE[0]}" >&2
    exit 2
}

[[ ${1:-} == start || ${1:-} == check ]] && [[ ${2:-} =~ ^[0-9]{1,2}$ ]] || usage
number=$(printf '%02d' "$((10#$2))")
folders=("$root"/chapters/"$number"-*/)
[[ -d ${folders[0]} ]] || { echo "no chapter $number in chapters/" >&2; exit 2; }
chapter=$(basename "${folders[0]}")

start() {
    local stub name answer found=0
    for stub in "$root/chapters/$chapter"/exercises/*/stub.hpp; do
        [[ -f $stub ]] || continue
        found=1
        name=$(basename "$(dirname "$stub")")
        answer=$root/my/$chapter/$name.hpp
        if [[ -e $answer ]]; then
            echo "my/$chapter/$name.hpp: there already, left as it is"
        else
            mkdir -p "$(dirname "$answer")"
            cp "$stub" "$answer"
            echo "my/$chapter/$name.hpp: yours to write; the task is in chapters/$chapter/exercises/$name/text.md"
        fi
    done
    ((found)) || { echo "chapter $number has no exercise in code" >&2; exit 2; }
    echo "When you have an answer: ./course check $number"
}

check() {
    local build=${1:-} answer name status=0 found=0
    [[ -f $build/CMakeCache.txt ]] || usage
    log=$(mktemp)
    trap 'rm -f "$log"' EXIT
    cmake -S "$root" -B "$build" >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
    for answer in "$root/my/$chapter"/*.hpp; do
        [[ -f $answer ]] || continue
        found=1
        name=$(basename "$answer" .hpp)
        if ! cmake --build "$build" --target "exercise_${number}_${name}_mine" >"$log" 2>&1; then
            grep -E ': (fatal )?(error|warning):' "$log" | head -n 20 || tail -n 20 "$log"
            echo "$name: does not compile"
            status=1
        elif "$build/chapters/$chapter/exercise_${number}_${name}_mine" --no-colors=1 >"$log" 2>&1; then
            echo "$name: passes"
            solution=chapters/$chapter/exercises/$name/solution.hpp
            if [[ -f $root/$solution ]] && ! cmp -s "$root/$solution" "$answer"; then
                printf '%s: the book does it like this (%s)\n\n' "$name" "$solution"
                sed 's/^/    /' "$root/$solution"
            fi
        else
            grep -vE '^\[doctest\] (doctest version|run with)' "$log" | head -n 40
            echo "$name: not yet; the hint is in chapters/$chapter/exercises/$name/hint.md"
            status=1
        fi
    done
    ((found)) || { echo "nothing in my/$chapter; begin with: ./course start $number" >&2; exit 2; }
    return "$status"
}

case $1 in
start) start ;;
check) check "${3:-$root/build/release}" ;;
esac
