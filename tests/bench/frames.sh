#!/usr/bin/env bash
# What a frame of the window costs under Xvfb: 500 polygons at 1280 x 800, as the window itself measures it. Under load of
# other programs frames are late whatever they cost: --urgent runs both by the real-time scheduler (as root), as if alone.
# Usage: frames.sh PROGRAM [--urgent] [--layers] [SCENE]      --layers shows all of them but the help
set -euo pipefail
export LC_ALL=C.UTF-8 NO_AT_BRIDGE=1 GTK_A11Y=none
program=$(readlink -f "$1")
shift
first=()
[[ ${1:-} != --urgent ]] || { first=(chrt -r 5); shift; }
layers=()
[[ ${1:-} != --layers ]] || { layers=(s c n i x k o e t m l h w f); shift; }
work=$(mktemp -d)
scene=${1:-$work/gas.toml}
[[ -n ${1:-} ]] || "$program" generate gas --count 500 --shape polygon --seed 1 >"$work/gas.toml"
exec 7>"$work/display"
"${first[@]}" Xvfb -displayfd 7 -screen 0 1280x800x24 -nolisten tcp -noreset >"$work/xvfb" 2>&1 &
server=$!
window=
finish() {
    [[ -z $window ]] || kill "$window" 2>/dev/null || true
    kill "$server" 2>/dev/null || true
    wait 2>/dev/null || true
    rm -rf "$work"
}
trap finish EXIT
for _ in $(seq 1200); do [[ -s $work/display ]] && break; sleep 0.05; done
DISPLAY=:$(cat "$work/display")
export DISPLAY
"${first[@]}" "$program" window "$scene" --state "$work/state.json" --size 1280x800 >"$work/log" 2>&1 &
window=$!
id=$(timeout 20 xdotool search --sync --onlyvisible --name 'Flying Polygons' | head -n 1)
xdotool windowfocus "$id"
((${#layers[@]} == 0)) || xdotool key --delay 50 "${layers[@]}"
sleep 10
xdotool key F8
for _ in $(seq 100); do [[ -s $work/state.json ]] && break; sleep 0.05; done
node -p "const ms = c => c.map(x => (1e3 * x).toFixed(2)).join(' / '), s = JSON.parse(require('fs').readFileSync('$work/state.json')).costs;
    Object.entries(s).map(([what, c]) => what + ' ' + ms([c.median, c.p95]) + ' ms').join(', ') + ' (median / 95 %)'"
