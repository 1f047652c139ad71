#!/usr/bin/env bash
# What each number of the resting integrator is for: multiplies one after the other in a copy of the program, by 16, 2, 1.01
# and what is one over these, runs the tests that know it, and says which notices the least change. Hours; those named
# do for some.
# Usage: ablate.sh FOLDER [NAME...]     (the copy and its build; names of constants in src/rest/rest_tolerance.hpp)
# FLYING_SPOIL='k_a*2,k_b*0.5' is what programs of that build understand, too.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=${1:?"ablate.sh FOLDER [NAME...]"}
shift
jobs=${FLYING_JOBS:-$(nproc 2>/dev/null || echo 2)}
header=src/rest/rest_tolerance.hpp

# A copy in which each number is multiplied by a factor that the environment names. A number that is no constant may be
# compared with a size, of which the compiler would complain
mkdir -p "$folder/sources"
(cd "$root" && git ls-files -z | xargs -0 cp --parents -u -p -t "$folder/sources")
{
    cat <<'CPP'
#pragma once
#pragma GCC diagnostic ignored "-Wsign-compare"
#include <cstdlib>
#include <string>
inline double spoilt(const std::string& name, double value)
{
    const char* what = std::getenv("FLYING_SPOIL");
    const std::string text = what ? "," + std::string(what) : "";
    const std::size_t place = text.find("," + name + "*");
    return place == std::string::npos ? value : value * std::strtod(text.c_str() + place + name.size() + 2, nullptr);
}
CPP
    sed -E 's/inline constexpr (double|int|std::size_t) (k_\w+) = ([^;]*);/inline const \1 \2 = static_cast<\1>(spoilt("\2", static_cast<double>(\3)));/' \
        "$root/$header"
} >"$folder/spoilt.hpp"
cmp -s "$folder/spoilt.hpp" "$folder/sources/$header" || cp "$folder/spoilt.hpp" "$folder/sources/$header"
cmake -S "$folder/sources" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release >"$folder/configure.log"
cmake --build "$folder/build" --parallel "$jobs" \
    --target chapter_11 chapter_17 unit_world unit_rest flying_regressions stress >"$folder/build.log" || {
    tail -n 40 "$folder/build.log"
    exit 1
}
# Those that are done soonest come first
programs=(chapters/11-coming-to-rest/chapter_11 tests/unit/unit_world chapters/17-heaps/chapter_17 tests/unit/unit_rest
    tests/regressions/flying_regressions "tests/stress/stress --test-case=*rest*,*broke*,*crowds*,*pile*")

# The first test that fails, of the first program that has one, as "program: test"; "-" where none does
noticed() { # constant*factor
    local program text
    for program in "${programs[@]}"; do
        # shellcheck disable=SC2086 # a program and its options
        text=$(FLYING_SPOIL=$1 timeout 900 "$folder/build"/$program --abort-after=1 2>&1) && continue
        program=${program%% *}
        # A test that only tells something has a head, too
        text=$(awk '/^TEST CASE:/ { test = $0 } / ERROR: / { sub(/^TEST CASE: */, "", test); print test; exit }' <<<"$text")
        echo "${program##*/}: ${text:-comes to no end}"
        return 0
    done
    echo "-"
}

# Whether that test fails, by itself
notices() { # "program: test" constant*factor
    local program test=${1#*: }
    for program in "${programs[@]}"; do
        program=${program%% *}
        [[ ${program##*/} == "${1%%:*}" ]] || continue
        if FLYING_SPOIL=$2 timeout 900 "$folder/build/$program" "--test-case=${test//,/\\,}" >/dev/null 2>&1; then return 1; fi
        return 0
    done
    return 1
}

# The least change that is noticed in this direction. What 16 doesn't show 2 won't; and what doesn't know 2 is not asked
# about a hundredth
least() { # constant factors, greatest first
    local factor found="-" by="" test
    for factor in "${@:2}"; do
        if [[ -n $by ]] && notices "$by" "$1*$factor"; then
            found="*$factor"
            continue
        fi
        [[ $factor != 1.01 && $factor != 0.99 ]] || break
        test=$(noticed "$1*$factor")
        [[ $test != - ]] || break
        found="*$factor"
        by=$test
    done
    echo "$found ${by}"
}

names=("$@")
((${#names[@]})) || mapfile -t names < <(sed -nE 's/^inline constexpr \S+ (k_\w+) = .*/\1/p' "$root/$header")
[[ $(noticed 'none*1') == - ]] || {
    echo "a test fails with every number as it is: $(noticed 'none*1')"
    exit 1
}
printf '# Run of %s at %s: each number, and the least change of it that a test notices\n' \
    "$(date +%F)" "$(git -C "$root" rev-parse --short HEAD)"
for name in "${names[@]}"; do
    printf '%-24s less: %s\n' "$name" "$(least "$name" 0.0625 0.5 0.99)"
    printf '%-24s more: %s\n' "" "$(least "$name" 16 2 1.01)"
done
