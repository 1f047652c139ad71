#!/usr/bin/env bash
# What ./course bench runs once all is built: measures, then draws.
#
#   bench.sh FOLDER_OF_PROGRAMS [options of flying_bench]     results go to out/bench
set -euo pipefail
export LC_ALL=C.UTF-8

here=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
if [[ ${1:-} == --help ]]; then
    cat <<'TEXT'
./course bench [options]    measure this engine beside Chipmunk and Box2D; results go to out/bench

  --all              the long set: every scene over its full time, all sizes, the parts one by one
  --scene NAME...    only scenes of these names
  --part NAME...     only these parts: scenes, precision, growth, piles (at rest: 1000 bodies, with --all 5000)
  --repeats N        of each run; the median counts (5)
  --hertz F          steps a second of the peers (60)
  --most S           seconds of computing after which a peer's run is given up (30)
  --until T          simulated seconds instead of each scene's own
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
