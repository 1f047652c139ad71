#!/usr/bin/env bash
# Same bits from every compiler, for this machine and for WebAssembly: runs the scenes of chapters/scenes and a set of
# generated ones through several builds of `flying` and compares the hashes that their reports give.
#
#   compare_hashes.sh PROGRAM PROGRAM...
#
# Prints a line for each scene; the last line is "N scenes agree, M differ". A scene on which some program fails, or
# whose report has no hash, counts as one that differs. Status 0 if none does, 1 otherwise, 2 for bad usage.
set -euo pipefail
export LC_ALL=C.UTF-8

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scenes=${FLYING_SCENES:-$here/../../../chapters/scenes}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Generated scenes: what `flying generate` is called with, then, behind a bar, what `flying simulate` is. Seeds are part of
# the list. Event by event, by small steps, and handed over from one to the other; stacks and piles until they rest.
generated=(
    "balls --seed 11"
    "gas --seed 12"
    "gas --seed 13 --shape polygon --count 40 --until 2"
    "gas --seed 14 --shape dumbbell --count 20 --until 2"
    "polygons --seed 15"
    "polygons --seed 22 --gravity 0 -9.81 --restitution 1 --friction 0.3 --until 2 | --engine events"
    "cradle --seed 16 --count 7 --until 5"
    "billiard --seed 17 --billiard pi --exponent 3"
    "billiard --seed 18 --billiard rectangle"
    "stack --seed 19 --until 5"
    "stack --seed 23 --count 12 --mass-ratio 20 --until 10 | --engine rest"
    "pyramid --seed 20 --until 5"
    "pyramid --seed 24 --count 6 --until 5 | --engine rest --step 0.005"
    "pile --seed 21 --until 5"
    "pile --seed 25 --shape polygon --count 60 --until 8 | --engine rest"
    "pile --seed 26 --shape disc --count 80 --until 8"
    "pile --seed 28 --count 450 --restitution 0 --until 3 | --engine rest"
    "gas --seed 27 --shape polygon --count 30 --gravity 0 -9.81 --restitution 0.5 --friction 0.4 --until 10"
)

# Of these, the first few; all without
generated=("${generated[@]:0:${FLYING_GENERATED:-${#generated[@]}}}")

(($# >= 2)) || {
    echo "compare_hashes.sh: at least two programs; found $#" >&2
    exit 2
}
for program in "$@"; do
    [[ -x $program ]] || {
        echo "compare_hashes.sh: not a program: $program" >&2
        exit 2
    }
done
programs=("$@")
agree=0
differ=0

# What program number k makes of a scene, as "status hash events time", into answer.k; what it says, into said.k
answer() { # k scene [option...]
    local status=0 report=$work/report.$1.json
    rm -f "$report"
    "${programs[$1]}" simulate "$2" --report "$report" --quiet "${@:3}" >"$work/said.$1" 2>&1 </dev/null || status=$?
    local key found line="status=$status"
    for key in hash events time; do
        found=$(grep -o -E -m 1 "\"$key\": *\"?[-+0-9a-zA-Z.]+" "$report" 2>/dev/null | head -n 1 || true)
        line+=" $key=${found##*[ :\"]}"
    done
    echo "$line" >"$work/answer.$1"
}

compare() { # name scene [option...]: every program on the same file
    local first='' line k
    for k in "${!programs[@]}"; do
        # Two at a time
        ((k < 2)) || wait -n || true
        answer "$k" "${@:2}" &
    done
    wait
    for k in "${!programs[@]}"; do
        line=$(<"$work/answer.$k")
        [[ -n $first ]] || first=$line
        if [[ $line != "$first" || $line != status=0\ hash=?*\ events=* ]]; then
            differ=$((differ + 1))
            echo "DIFFERS  $1"
            echo "    $first  from ${programs[0]}"
            echo "    $line  from ${programs[k]}"
            sed 's/^/    | /' "$work/said.$k" | head -n 5
            return 0
        fi
    done
    agree=$((agree + 1))
    echo "agrees   $1  $first"
}

# Every program has to write the same scene, too
compare_generated() { # "generate's words" or "generate's words | simulate's"
    local first=$work/first.toml other=$work/other.toml program words how=()
    read -r -a words <<<"${1%%|*}"
    [[ $1 != *\|* ]] || read -r -a how <<<"${1#*|}"
    if ! "${programs[0]}" generate "${words[@]}" >"$first" 2>"$work/said"; then
        differ=$((differ + 1))
        echo "DIFFERS  generate $1: ${programs[0]} fails"
        sed 's/^/    | /' "$work/said" | head -n 5
        return 0
    fi
    for program in "${programs[@]:1}"; do
        if ! "$program" generate "${words[@]}" >"$other" 2>"$work/said" || ! cmp -s "$first" "$other"; then
            differ=$((differ + 1))
            echo "DIFFERS  generate $1: $program writes another scene than ${programs[0]}"
            return 0
        fi
    done
    compare "generate $1" "$first" "${how[@]}"
}

for scene in "$scenes"/*.toml; do
    [[ ! -e $scene ]] || compare "$(basename "$scene")" "$scene"
done
for line in "${generated[@]}"; do
    compare_generated "$line"
done

echo "$agree scenes agree, $differ differ"
((differ == 0 && agree > 0))
