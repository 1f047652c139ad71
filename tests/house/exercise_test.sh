#!/usr/bin/env bash
# What a reader sees of an exercise: the beginning, the first check that fails, the hint, and how far one has come.
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failures=0

same() { # what expected found
    [[ $2 == "$3" ]] && return
    printf '%s: expected\n%s\nfound\n%s\n' "$1" "$2" "$3"
    failures=$((failures + 1))
}

says() { # what pattern text
    grep -q -e "$2" <<<"$3" && return
    printf "%s: expected '%s', found\n%s\n" "$1" "$2" "$3"
    failures=$((failures + 1))
}

# ---- The first check that fails, as doctest tells it and as we do --------------------------------------------------------

feedback() { awk -f "$top/docs/feedback.awk"; }

same "a comparison" "    the test:  a frame and a plate
    tried:     frame.mass + inside.mass
    expected:  30.0
    got:       18.75
    with:      k := 3, n := 4" "$(feedback <<'T'
TEST CASE:  a frame and a plate

tests.cpp:14: ERROR: CHECK( frame.mass + inside.mass == doctest::Approx(whole.mass).epsilon(1e-14) ) is NOT correct!
  values: CHECK( 18.75 == Approx( 30.0 ) )
  logged: k := 3
          n := 4

tests.cpp:15: ERROR: CHECK( 1 == 2 ) is NOT correct!
  values: CHECK( 1 == 2 )

T
)"
same "a bound" "    the test:  misses
    tried:     std::abs(f(1, \"a < b\") - 2)
    expected:  less than 1e-05
    got:       0.25" "$(feedback <<'T'
TEST CASE:  misses

tests.cpp:3: ERROR: CHECK( std::abs(f(1, "a < b") - 2) < 1e-5 ) is NOT correct!
  values: CHECK( 0.25 <  1e-05 )

T
)"
same "digits that aren't shown" "    the test:  weighs
    tried:     mass()
    expected:  4
    got:       4, the same in the digits shown but not in all" "$(feedback <<'T'
TEST CASE:  weighs

tests.cpp:3: ERROR: CHECK( mass() == doctest::Approx(4.0) ) is NOT correct!
  values: CHECK( 4 == Approx( 4 ) )

T
)"
same "a truth" "    the test:  inside
    tried:     is_inside(p)
    expected:  false
    got:       true" "$(feedback <<'T'
TEST CASE:  inside

tests.cpp:3: ERROR: CHECK_FALSE( is_inside(p) ) is NOT correct!
  values: CHECK_FALSE( true )

T
)"
same "a crash" "    the test:  deep
    it crashed: SIGSEGV - Segmentation violation signal" "$(feedback <<'T'
TEST CASE:  deep

tests.cpp:3: FATAL ERROR: test case CRASHED: SIGSEGV - Segmentation violation signal
T
)"

same "an exception" "    the test:  marches
    it stopped: f was asked a million times" "$(feedback <<'T'
TEST CASE:  marches

tests.cpp:3: ERROR: test case THREW exception: f was asked a million times
T
)"

same "no end, as tests/support/steps.cpp says it" "    the test:  all pairs
    it stopped: it was not done after 500 million steps" "$(feedback <<'T'
TEST CASE:  all pairs

ERROR: test case THREW exception: it was not done after 500 million steps

T
)"
same "an exception within a check" "    the test:  marches
    tried:     march(f)
    it stopped: f was asked a million times
    with:      k := 3" "$(feedback <<'T'
TEST CASE:  marches

tests.cpp:3: ERROR: CHECK( march(f) == 2 ) THREW exception: "f was asked a million times"
  logged: k := 3

T
)"
same "a list" "    the test:  pairs
    tried:     found
    expected:  [(0, 1), (2, 3)]
    got:       [(0, 1)]" "$(feedback <<'T'
TEST CASE:  pairs

tests.cpp:3: ERROR: CHECK( found == expected ) is NOT correct!
  values: CHECK( [(0, 1)] == [(0, 1), (2, 3)] )

T
)"

# ---- Begin, and how far one has come -------------------------------------------------------------------------------------

mkdir -p "$tree/docs" "$tree/chapters/07-springs/exercises"/{e1,e2}
cp "$top/docs/exercise.sh" "$top/docs/feedback.awk" "$top/docs/chapters.awk" "$tree/docs"
# The second chapter of the book, in a folder that was given the number 07
printf '[[chapter]]\nname = "%s"\n' 01-balls 07-springs >"$tree/chapters/book.toml"
echo '# Springs' >"$tree/chapters/07-springs/chapter.md"
echo '// yours' >"$tree/chapters/07-springs/exercises/e2/stub.hpp"

says "nothing begun" '^02  Springs  *e2 -$' "$("$tree/docs/exercise.sh" progress)"
says "to begin with" '^Next: ./course start 02$' "$("$tree/docs/exercise.sh" progress)"
says "a beginning" '^my/07-springs/e2.hpp: yours to write' "$("$tree/docs/exercise.sh" start 2)"
says "left alone" 'there already, left as it is' "$("$tree/docs/exercise.sh" start 02)"
says "not begun by that" 'e2 -$' "$("$tree/docs/exercise.sh" progress)"
echo '// an answer' >>"$tree/my/07-springs/e2.hpp"
says "begun" 'e2 begun$' "$("$tree/docs/exercise.sh" progress)"
echo "07-springs/e2 $(cksum <"$tree/my/07-springs/e2.hpp" | tr -d ' ')" >"$tree/my/passed.txt"
says "passed" 'e2 passes$' "$("$tree/docs/exercise.sh" progress)"
says "counted" '^1 of 1 exercises' "$("$tree/docs/exercise.sh" progress)"
echo '// changed' >>"$tree/my/07-springs/e2.hpp"
says "changed since" 'e2 begun$' "$("$tree/docs/exercise.sh" progress)"

((failures == 0))
