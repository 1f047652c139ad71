#!/usr/bin/env bash
# Random hands at the window of `flying window` under Xvfb: keys, mouse, scrolling, resizing, for so many seconds. The window
# must neither crash, nor hang, nor grow, nor say that anything is wrong; built with sanitizers, they look on. Sanitizers make
# a window that has got into a scene of a thousand bodies answer slowly, so what hangs is what gives no answer for ten minutes.
# Usage: window_random.sh PROGRAM SECONDS [SEED]. Last line: "no crash, no hang, ..." with status 0, or what went wrong.
set -euo pipefail
export LC_ALL=C.UTF-8 NO_AT_BRIDGE=1 GTK_A11Y=none
program=$(readlink -f "$1")
seconds=$2
seed=${3:-1}
RANDOM=$seed
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
# What libraries keep until the end is no leak of ours; what grows is seen by the size
export ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1

# Without -noreset, the server would begin anew when its last client leaves, and turn away a window that is just coming
exec 7>"$work/display"
Xvfb -displayfd 7 -screen 0 1400x900x24 -nolisten tcp -noreset >"$work/xvfb" 2>&1 &
server=$!
window=
finish() {
    [[ -z $window ]] || kill -9 "$window" 2>/dev/null || true
    kill "$server" 2>/dev/null || true
    wait 2>/dev/null || true
    rm -rf "$work"
}
trap finish EXIT
for _ in $(seq 1200); do [[ -s $work/display ]] && break; sleep 0.05; done
DISPLAY=:$(cat "$work/display")
export DISPLAY

fail() {
    ! command -v import >/dev/null || [[ -z ${SHOT:-} ]] || import -window root "$SHOT" || true
    [[ -z $window ]] || ps -o pid,stat,time,pcpu,rss -p "$window" || true
    echo "seed $seed, after $((SECONDS - start)) s: $*"
    [[ ! -e $work/last.json ]] || { echo "what it answered last, after $rounds rounds:"; head -c 3000 "$work/last.json"; }
    tail -n 60 "$work/log"
    exit 1
}
ask() { # for the state; a dialog that has come up is closed first: without a window manager nobody gives it the keys
    local other
    for other in $(xdotool search --onlyvisible --name '.' 2>/dev/null); do
        [[ $other == "$id" ]] || xdotool windowfocus "$other" key Escape 2>/dev/null || true
    done
    xdotool windowfocus "$id" key Escape key Escape key F8 || true
}
longest=0
answer() { # the window says what it knows
    local asked=$SECONDS k
    for ((k = 0; SECONDS - asked < 600; ++k)); do
        # A dialog takes the keys from it, but keys that wait to be answered need no company
        ((k % 100)) || ask
        if [[ -e $work/state.json ]]; then
            ((SECONDS - asked <= longest)) || longest=$((SECONDS - asked))
            mv "$work/state.json" "$work/last.json"
            return 0
        fi
        kill -0 "$window" 2>/dev/null || return 1
        sleep 0.1
    done
    return 1
}
size() { awk '/^VmRSS/ { print int($2 / 1024) }' "/proc/$window/status"; } # [MB]

start=$SECONDS
rounds=0
cp "$root"/chapters/scenes/{balls-and-polygons,cradle,bowl}.toml "$work"
(cd "$work" && exec "$program" window balls-and-polygons.toml --state state.json >"$work/log" 2>&1) &
window=$!
id=
for ((k = 0; k < 6000; ++k)); do
    id=$(xdotool search --onlyvisible --name 'Flying Polygons' 2>/dev/null | sed -n 1p) || true
    [[ -z $id ]] || break
    kill -0 "$window" 2>/dev/null || fail "the window is gone before it was seen"
    sleep 0.1
done
[[ -n $id ]] || fail "no window"
xdotool windowfocus "$id"
answer || fail "no first answer"

keys=(p space period comma greater less plus minus ctrl+z Home r g shift+g Left Right Up Down shift+Left shift+Right shift+Up
    shift+Down Return 1 1 2 3 4 5 bracketright bracketleft Prior Next BackSpace Delete b shift+b Escape ctrl+plus ctrl+minus z s c n i x
    k o e t m l h w f a u y v ctrl+Left ctrl+Right ctrl+Up ctrl+Down d j F1 F9 F7 Tab shift+Tab space Return)
burst() { # some dozens of things to do, as lines for xdotool
    local k
    for ((k = 0; k < 40; ++k)); do
        case $((RANDOM % 12)) in
        0 | 1 | 2 | 3) echo "key ${keys[RANDOM % ${#keys[@]}]}" ;;
        4 | 5) echo "mousemove $((RANDOM % 1280)) $((RANDOM % 800))" ;;
        6) echo "mousemove $((60 + RANDOM % 900)) $((60 + RANDOM % 680)) click 1" ;;
        7) printf 'mousemove %d %d\nmousedown 1\nmousemove_relative -- %d %d\nsleep 0.03\nmousemove_relative -- %d %d\nmouseup 1\n' \
            $((60 + RANDOM % 900)) $((60 + RANDOM % 680)) $((RANDOM % 200 - 100)) $((RANDOM % 200 - 100)) $((RANDOM % 200 - 100)) $((RANDOM % 200 - 100)) ;;
        8) echo "click $((4 + RANDOM % 4))" ;;
        9) echo "click 3" ;;
        10) echo "sleep 0.0$((RANDOM % 9))" ;;
        11) ((RANDOM % 10)) || echo "windowsize $id $((500 + RANDOM % 800)) $((400 + RANDOM % 450))" ;;
        esac
    done
}

first=0
most=0
while ((SECONDS - start < seconds)); do
    burst | timeout 60 xdotool - >/dev/null 2>&1 || true
    rounds=$((rounds + 1))
    kill -0 "$window" 2>/dev/null || fail "the window is gone"
    ((rounds % 10)) || answer || fail "the window hangs"
    now=$(size)
    # What it needs at first is not known before it has done a little of everything
    ((rounds != 20)) || first=$now
    ((now <= most)) || most=$now
    ((now < 4000)) || fail "the window has grown to $now MB"
done
answer || fail "the window hangs at the end"
generation=$(sed -n 's/^"generation":\([0-9]*\),$/\1/p' "$work/last.json")
xdotool key q
for ((k = 0; k < 6000; ++k)); do kill -0 "$window" 2>/dev/null || break; sleep 0.1; done
! kill -0 "$window" 2>/dev/null || fail "Q does not quit"
status=0
wait "$window" || status=$?
window=
((status == 0)) || fail "the window ended with status $status"
! grep -E 'ERROR|runtime error|CRITICAL' "$work/log" || fail "something was wrong"
echo "no crash, no hang, nothing wrong: seed $seed, $((SECONDS - start)) s, $((40 * rounds)) strokes, $generation changes, longest answer $longest s, $first MB after 20 rounds, at most $most MB"
