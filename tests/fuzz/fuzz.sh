#!/usr/bin/env bash
# Lets the fuzzer look for broken promises: in scene files, and in what scenes do. What it finds is kept.
#
#   fuzz.sh BIN FOLDER [--seconds N] [--seed N] [text|world]
#
# BIN      folder of fuzz_text and fuzz_world (preset fuzz)
# FOLDER   where new inputs that reach new lines are kept, for the next time, and findings; runs.txt has a line for each run
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
bin=$1
folder=$2
shift 2
seconds=600
seed=0 # the fuzzer's own choice
kinds=(text world)
while (($#)); do
    case $1 in
    --seconds | --seed)
        [[ ${2:-} =~ ^[0-9]+$ ]] || { echo "fuzz: $1 expects a whole number; found: ${2:-nothing}" >&2; exit 2; }
        [[ $1 == --seed ]] && seed=$2 || seconds=$2
        shift 2
        ;;
    text | world) kinds=("$1"); shift ;;
    --help | -h)
        echo "./course stress fuzz [--seconds N] [--seed N] [text|world]: a fuzzer that sees which lines its inputs reach; 600 s each"
        exit 0
        ;;
    *) echo "fuzz: expected --seconds N, --seed N, text or world; found: $1" >&2; exit 2 ;;
    esac
done

good=0
bad=0
for kind in "${kinds[@]}"; do
    kept=$folder/$kind
    found=$folder/findings/
    mkdir -p "$kept" "$found"
    options=(-max_total_time="$seconds" -seed="$seed" -timeout=600 -rss_limit_mb=3000 -print_final_stats=1 -artifact_prefix="$found$kind-")
    [[ $kind != text ]] || options+=(-dict="$here/toml.dict" -max_len=4000)
    [[ $kind != world ]] || options+=(-max_len=400)
    log=$folder/$kind.log
    begun=$SECONDS
    verdict=well
    if "$bin/fuzz_$kind" "${options[@]}" "$kept" "$here/corpus/$kind" >"$log" 2>&1 </dev/null; then
        echo "$kind: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") inputs in $seconds s, no promise broken"
        good=$((good + 1))
    else
        echo "$kind: FAILED: $(grep -m1 -E 'a broken promise|ERROR: |runtime error' "$log" || tail -n 1 "$log")"
        grep -E 'Test unit written to' "$log" || true
        verdict=finding
        # Its watch goes on while others have the machine: what it calls too slow is no finding before it was run again alone
        ! grep -q 'libFuzzer: timeout' "$log" || verdict=slow
        bad=$((bad + 1))
    fi
    # What a run that was stopped tried is the number of its last line
    inputs=$(sed -n -E 's/^#([0-9]+).*/\1/p; s/^stat::number_of_executed_units: *//p' "$log" | tail -n 1)
    echo "$kind ${inputs:-0} $((SECONDS - begun)) $verdict" >>"$folder/runs.txt"
done
echo "$good passed, $bad failed"
((bad == 0))
