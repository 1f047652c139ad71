#!/usr/bin/env bash
# What each number of the resting integrator is for: halves and doubles one after the other in a copy of the program, runs
# the tests that know it, and prints which of them notices first. Hours; those named do for some.
# Usage: ablate.sh FOLDER [NAME...]     (the copy and its build; names of constants in src/rest/rest_tolerance.hpp)
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=${1:?"ablate.sh FOLDER [NAME...]"}
shift
jobs=${FLYING_JOBS:-$(nproc 2>/dev/null || echo 2)}
header=src/rest/rest_tolerance.hpp

# A copy in which each number is multiplied by a factor that the environment names: FLYING_SPOIL='k_rest_speed*2'
mkdir -p "$folder/sources"
(cd "$root" && git ls-files -z | xargs -0 cp --parents -u -p -t "$folder/sources")
{
    cat <<'CPP'
#include <cstdlib>
#include <cstring>
#include <string>
inline double spoilt(const char* name, double value)
{
    const char* what = std::getenv("FLYING_SPOIL");
    const char* factor = what ? std::strchr(what, '*') : nullptr;
    return factor && std::string(what, factor) == name ? std::strtod(factor + 1, nullptr) * value : value;
}
CPP
    sed -E 's/inline constexpr (double|int|std::size_t) (k_\w+) = ([^;]*);/inline const \1 \2 = static_cast<\1>(spoilt("\2", static_cast<double>(\3)));/' \
        "$root/$header"
} >"$folder/spoilt.hpp"
cmp -s "$folder/spoilt.hpp" "$folder/sources/$header" || cp "$folder/spoilt.hpp" "$folder/sources/$header"
cmake -S "$folder/sources" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release >"$folder/configure.log"
cmake --build "$folder/build" --parallel "$jobs" --target chapter_11 chapter_17 flying_regressions stress >"$folder/build.log" || {
    tail -n 40 "$folder/build.log"
    exit 1
}
programs=("$folder/build/chapters/11-coming-to-rest/chapter_11" "$folder/build/chapters/17-heaps/chapter_17"
    "$folder"/build/tests/regressions/flying_regressions
    "$folder/build/tests/stress/stress --test-case=*rest*")

# The first test that fails, of the first program that has one
noticed() { # constant*factor
    local program text
    for program in "${programs[@]}"; do
        # shellcheck disable=SC2086 # a program and its options
        text=$(FLYING_SPOIL=$1 timeout 600 $program --abort-after=1 2>&1) && continue
        grep -m 1 -A 1 '^TEST CASE:' <<<"$text" | sed -n 's/^TEST CASE: *//p' | cut -c1-70 || echo "stopped: $program"
        return 0
    done
    echo "-"
}

names=("$@")
((${#names[@]})) || mapfile -t names < <(sed -nE 's/^inline constexpr \S+ (k_\w+) = .*/\1/p' "$root/$header")
[[ $(noticed 'none*1') == - ]] || {
    echo "a test fails with every number as it is: $(noticed 'none*1')"
    exit 1
}
found=0
for name in "${names[@]}"; do
    halved=$(noticed "$name*0.5")
    doubled=$(noticed "$name*2")
    printf '%-24s halved:  %s\n%-24s doubled: %s\n' "$name" "$halved" "" "$doubled"
    [[ $halved == - && $doubled == - ]] || found=$((found + 1))
done
echo "$found numbers noticed, $((${#names[@]} - found)) not"
