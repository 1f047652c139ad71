#!/usr/bin/env bash
# Counts the instructions of a handful of fixed scenes under callgrind and compares them with instructions.json.
#
#   tests/bench/instructions.sh                    fails, with the scene's name, where one takes over 5 % more
#   tests/bench/instructions.sh --update REASON    measures anew and writes the new counts, with date and reason
#
# Builds flying_instructions in build/instructions, for any x86-64, so that the counts don't depend on the machine. They
# still depend on the compiler's version, which stands beside them.
set -euo pipefail
export LC_ALL=C.UTF-8

here=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
root=$(cd "$here/../.." && pwd)
baseline=$here/instructions.json
allowed=1.05

reason=${2:-}
if (($# != 0)) && [[ $# != 2 || $1 != --update || -z $reason ]]; then
    echo "use: instructions.sh [--update REASON]" >&2
    exit 2
fi

build=$root/build/instructions
mkdir -p "$build"
if ! (cd "$root" && cmake --preset instructions &&
    cmake --build "$build" --parallel "${FLYING_JOBS:-$(nproc)}" --target flying_instructions) >"$build/build.log" 2>&1; then
    tail -n 30 "$build/build.log" >&2
    exit 1
fi
program=$build/bin/flying_instructions

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

count() { # scene: prints the number of instructions in measured_run and all that it calls
    valgrind --tool=callgrind --callgrind-out-file="$folder/$1.out" --collect-atstart=no --toggle-collect=measured_run \
        "$program" "$1" >"$folder/$1.log" 2>&1 || { cat "$folder/$1.log" >&2; return 1; }
    sed -n 's/^summary: *//p; s/^totals: *//p' "$folder/$1.out" | tail -n 1
}

mapfile -t scenes < <("$program")
compiler=$(g++ -dumpfullversion)
pids=()
for scene in "${scenes[@]}"; do
    count "$scene" >"$folder/$scene.count" &
    pids+=($!)
    # Two at a time
    ((${#pids[@]} % 2)) || wait "${pids[-2]}" "${pids[-1]}"
done
for pid in "${pids[@]}"; do wait "$pid"; done

if [[ -n $reason ]]; then
    {
        printf '{\n  "date": "%s",\n  "reason": "%s",\n  "compiler": "g++ %s, -O3, generic x86-64",\n  "instructions": {\n' \
            "$(date -u +%F)" "${reason//\"/\'}" "$compiler"
        for k in "${!scenes[@]}"; do
            printf '    "%s": %s%s\n' "${scenes[k]}" "$(<"$folder/${scenes[k]}.count")" \
                "$( ((k + 1 < ${#scenes[@]})) && echo ,)"
        done
        printf '  }\n}\n'
    } >"$folder/new.json"
    mv "$folder/new.json" "$baseline"
    cat "$baseline"
    exit 0
fi

failed=0
for scene in "${scenes[@]}"; do
    now=$(<"$folder/$scene.count")
    before=$(sed -n "s/^ *\"$scene\": *\([0-9]*\),*$/\1/p" "$baseline")
    if [[ -z $before ]]; then
        echo "$scene: $now instructions, none in the baseline"
        failed=$((failed + 1))
        continue
    fi
    verdict=$(awk -v now="$now" -v before="$before" -v allowed="$allowed" \
        'BEGIN { printf "%+.2f %% %s", 100 * (now / before - 1), (now > allowed * before) ? "TOO MANY" : "" }')
    echo "$scene: $now instructions, $verdict"
    [[ $verdict != *MANY* ]] || failed=$((failed + 1))
done
if ((failed)); then
    echo "The baseline is of $(sed -n 's/^ *"date": "\(.*\)",$/\1/p' "$baseline") ($(sed -n 's/^ *"compiler": "\(.*\)",$/\1/p' "$baseline")), here g++ $compiler."
    echo "Where more work is meant: tests/bench/instructions.sh --update \"why\""
fi
echo "$((${#scenes[@]} - failed)) scenes within 5 %, $failed not"
((failed == 0))
