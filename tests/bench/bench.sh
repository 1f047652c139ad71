#!/usr/bin/env bash
# What ./course bench runs once all is built: measures, then draws.
#
#   bench.sh FOLDER_OF_PROGRAMS [options]     those of flying_diagrams, or of flying_bench; results go to out/bench
set -euo pipefail
# Every engine has one thread; the one that a peer's library would start does nothing but spin
export LC_ALL=C.UTF-8 OPENBLAS_NUM_THREADS=1

here=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
if [[ ${1:-} == --help ]]; then
    cat <<'TEXT'
./course bench [options]    measure this engine beside Box2D, Chipmunk and Siconos; results go to out/bench

Time against error, a diagram for each scene; growth with the number of bodies; what each skip saves:
  (no option)        all of it: an hour and more. A run that was stopped goes on where it was
  --quick            all plots coarsely, in less than five minutes
  --only NAME...     only these diagrams (a wrong name lists them)
  --fresh            forget the earlier run and begin anew
  --most S           seconds of computing that one run may take (0.2; quick: 0.1)

Tables of speed at one step:
  --all              the long set: every scene over its full time, all sizes, the parts one by one
  --scene NAME...    only scenes of these names
  --part NAME...     only these parts: scenes, growth, piles (at rest: 1000 bodies, with --all 5000)
  --hertz F          steps a second of the peers (60)
  --until T          simulated seconds instead of each scene's own

With either, --repeats N: of each run, the median counts.
TEXT
    exit 0
fi
programs=$(cd "$1" && pwd)
shift
for option in "$@"; do
    case $option in
    --out | --out=*) echo "bench.sh: results go to out/bench; call flying_bench itself to put them elsewhere" >&2; exit 2 ;;
    esac
done

out=$here/../../out/bench
mkdir -p "$out"
out=$(cd "$out" && pwd)
status=0

# Tables of speed are asked for by one of their own options; all else are diagrams
kind=diagrams
for option in "$@"; do
    case $option in
    --all | --scene | --scene=* | --part | --part=* | --hertz | --hertz=* | --until | --until=*) kind=tables ;;
    esac
done
if [[ $kind == diagrams ]]; then
    "$programs/flying_diagrams" --out "$out" --scenes "$here/../../chapters/scenes" "$@" |
        { grep -v -e '^Initializing cpSpace' -e '^Compile with -DNDEBUG' || true; } || status=${PIPESTATUS[0]}
    ((status <= 1)) || exit $((status >= 100 ? 2 : status)) # bad usage is 2 everywhere
    echo
    echo "In $out:"
    (cd "$out" && ls -- *.jsonl work-*.svg growth-*.svg skips.svg 2>/dev/null | sed 's/^/    /') || true
    exit "$status"
fi

# Chipmunk greets on the standard output
"$programs/flying_bench" --out "$out" "$@" |
    { grep -v -e '^Initializing cpSpace' -e '^Compile with -DNDEBUG' || true; } || status=${PIPESTATUS[0]}
((status <= 1)) || exit $((status >= 100 ? 2 : status)) # bad usage is 2 everywhere

# The parts one by one belong to the long set
case " $* " in
*" --all "*)
    "$programs/flying_bench_parts" --benchmark_out="$out/parts.json" --benchmark_out_format=json \
        --benchmark_repetitions=5 --benchmark_report_aggregates_only=true
    ;;
esac

# Draw what was measured, in this run or before
if [[ -f $out/machine.ini ]] && command -v gnuplot >/dev/null; then
    (cd "$out" && gnuplot "$here/plots.gp")
fi
echo
echo "In $out:"
(cd "$out" && ls -- *.json *.txt *.svg *.png 2>/dev/null | sed 's/^/    /') || true
exit "$status"
