#!/usr/bin/env bash
# The window of `flying window` under Xvfb: keys, mouse and controls by xdotool, then what the window says of itself (F8).
# Usage: window_test.sh PROGRAM [FOLDER FOR SCREENSHOTS]. Last line: "N actions did what they say, M did not".
# A file is dropped from the program window_drag_source, which lies beside PROGRAM.
set -euo pipefail
export LC_ALL=C.UTF-8 NO_AT_BRIDGE=1 GTK_A11Y=none
program=$(readlink -f "$1")
dragged=$(dirname "$program")/window_drag_source
shots=${2:+$(mkdir -p "$2" && readlink -f "$2")}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
good=0
bad=0

exec 7>"$work/display"
Xvfb -displayfd 7 -screen 0 1280x800x24 -nolisten tcp >"$work/xvfb" 2>&1 &
server=$!
window=
finish() {
    [[ -z $window ]] || kill "$window" 2>/dev/null || true
    kill "$server" 2>/dev/null || true
    wait 2>/dev/null || true
    rm -rf "$work"
}
trap finish EXIT
for _ in $(seq 100); do [[ -s $work/display ]] && break; sleep 0.05; done
DISPLAY=:$(cat "$work/display")
export DISPLAY

open_window() { # arguments of flying window
    (cd "$work" && exec "$program" window "$@" --state "$work/state.json" --size 1280x800 >"$work/log" 2>&1) &
    window=$!
    id=$(timeout 20 xdotool search --sync --onlyvisible --name 'Flying Polygons' | head -n 1)
    xdotool windowfocus "$id"
    # The first answer may be asked for before the window listens
    for _ in $(seq 50); do look && return 0; sleep 0.1; done
    echo "the window did not answer: $(cat "$work/log")"
    exit 1
}

look() { # a fresh state
    rm -f "$work/state.json"
    xdotool key F8
    for _ in $(seq 60); do [[ -e $work/state.json ]] && return 0; sleep 0.02; done
    return 1
}

value() { # expression in s, the state: prints it
    node -p "const s = JSON.parse(require('fs').readFileSync('$work/state.json')); $1"
}

expect() { # what expression: true of a fresh state
    look || { echo "no answer after: $1"; bad=$((bad + 1)); return 0; }
    if [[ $(value "$2") == true ]]; then
        good=$((good + 1))
    else
        bad=$((bad + 1))
        echo "WRONG: $1: not true: $2"
        value 'delete s.bodies, delete s.controls, JSON.stringify(s)' | cut -c 1-600
    fi
}

judge() { # what expression: true of the state that was looked at last
    if [[ $(value "$2") == true ]]; then
        good=$((good + 1))
    else
        bad=$((bad + 1))
        echo "WRONG: $1: not true: $2"
    fi
}

keys() { xdotool key --delay 15 "$@"; }
shot() { [[ -z $shots ]] || { sleep 0.3; import -window root "$shots/$1.png"; }; }
at() { # world x, y: where they lie on the screen
    value "(() => { const [w, h] = s.surface, v = s.map; return [v[1] + v[0] * ($1), v[2] - v[0] * ($2)].map(Math.round).join(' ') })()"
}
# shellcheck disable=SC2046
point() { xdotool mousemove $(at "$1" "$2"); }
# A control of the panel, by its text
press_control() {
    local place
    place=$(value "(s.controls['$1'] || []).map(Math.round).join(' ')")
    [[ -n $place ]] || { echo "WRONG: no control '$1'"; bad=$((bad + 1)); return 0; }
    # shellcheck disable=SC2086
    xdotool mousemove $place click 1
    sleep 0.1
}

cat >"$work/three.toml" <<'TOML'
title = "three bodies"
[world]
field = { kind = "uniform", gravity = [0.0, -1.0] }
box = { min = [0.0, 0.0], max = [10.0, 8.0] }
[[body]]
name = "ball"
shape = { kind = "disc", radius = 0.5 }
position = [2.0, 4.0]
velocity = [1.0, 0.0]
[[body]]
name = "box"
shape = { kind = "rectangle", width = 1.0, height = 0.6 }
position = [5.0, 2.0]
[[body]]
shape = { kind = "regular", sides = 3, radius = 0.6 }
position = [7.0, 5.0]
spin = 1.0
TOML

# ---- Keys --------------------------------------------------------------------------------------------------------------

open_window "$work/three.toml" --paused
expect "--paused" 's.paused && s.time === 0'
keys period
expect "." 's.paused && Math.abs(s.time - 1 / 60) < 1e-9'
keys period period comma
expect "," 'Math.abs(s.time - 2 / 60) < 1e-9'
keys greater
expect ">" 'Math.abs(s.time - 22 / 60) < 1e-9'
keys less
expect "<" 'Math.abs(s.time - 2 / 60) < 1e-9'
keys p
sleep 0.4
expect "P lets time run" '!s.paused && s.time > 0.1'
keys space
expect "space holds it" 's.paused'
keys plus
expect "+" 's.speed === 2'
keys minus minus
expect "-" 's.speed === 0.5'
keys r Left Left
expect "R, left" 's.restitution === 0.98 && s.arrow_keys === "restitution"'
keys shift+Down
expect "R, Shift+down" 's.restitution === 0.88'
keys g Left Up
expect "G, left and up" 'Math.abs(s.field.gravity[0] + 0.1) < 1e-9 && Math.abs(s.field.gravity[1] + 0.9) < 1e-9'
shot gravity
keys shift+g
expect "Shift+G" 's.field.kind === "central" && s.field.radius === 0.5'
keys Up Right
expect "G, up and right in a central field" 's.field.radius > 0.5 && s.field.mu > 0'
keys ctrl+z
expect "Ctrl+Z" 's.field.kind === "uniform" && s.can_redo'
keys ctrl+shift+z
expect "Ctrl+Shift+Z" 's.field.kind === "central" && s.field.radius > 0.5 && !s.can_redo'
keys ctrl+z ctrl+y
expect "Ctrl+Y" 's.field.kind === "central" && !s.can_redo'
keys ctrl+z ctrl+z
expect "Ctrl+Z again" 's.field.kind === "uniform" && s.generation > 8'
keys Home
expect "Home" 's.time === 0 && s.restitution === 1'
for pair in 's:speed arrows' 'c:contact points' n:normals i:impulses 'x:bounding boxes' k:cells o:islands 'e:next events' t:trails \
    'm:centroid, inertia' l:labels 'h:energy and momentum' 'w:what the plan skips' 'f:cost figures' F1:help; do
    keys "${pair%%:*}"
    expect "${pair%%:*} on" "s.layers.includes('${pair#*:}') && s.layers.length === 1"
    [[ ${pair%%:*} != F1 ]] || shot help
    keys "${pair%%:*}"
done
expect "layers off" 's.layers.length === 0'
keys a
expect "A" 's.colouring === "mover"'
keys u
expect "U" 's.colouring === "random"'
keys u y d
expect "U, Y, D" 's.colouring === "number" && !s.faces_turn && s.dark'
shot dark
keys d j
expect "J" 's.box_follows'
keys j F9
expect "F9" 's.surface[0] === 1280'
keys F9
expect "F9 again" 's.surface[0] < 1100'
keys b b
expect "B" 's.selected === 1'
keys shift+b v
expect "Shift+B, V" 's.selected === 0 && s.ship.body === 0'
keys ctrl+Left ctrl+Up ctrl+Up
expect "Ctrl+arrows" 'Math.abs(s.ship.heading - Math.PI / 2 - Math.PI / 18) < 1e-9 && s.ship.thrust === 0.5'
keys b Delete
expect "Delete" 's.bodies.length === 2 && s.bodies[1].name === ""'
keys ctrl+z 2 bracketright
expect "2, ]" 's.tool === "add a disc" && s.bodies.length === 3 && s.size > 0.45'
keys Escape 3 Prior Prior Next
expect "3, page up and down" 's.tool === "add a polygon" && s.sides === 6'
keys ctrl+plus
expect "Ctrl +" 's.view[1][1] - s.view[0][1] < 7'
keys z
expect "Z" 's.view[1][1] === 8'
keys F7 period period F7
sleep 0.1
expect "F7" 's.notice.includes("lines")'
[[ $(head -c 8 "$work/three.ndjson") == '{"time":' ]] && good=$((good + 1)) || { bad=$((bad + 1)); echo "WRONG: no trace"; }

# ---- Mouse -------------------------------------------------------------------------------------------------------------

keys 1 Home
look
point 5 2
xdotool mousedown 1
point 6 3
sleep 0.1
expect "a body is carried" 's.holds === 1 && Math.abs(s.bodies[1].x - 6) < 0.05 && Math.abs(s.bodies[1].y - 3) < 0.05'
xdotool mouseup 1
sleep 0.1
# Where it is, and the way to throw it, while time stands still: a busy machine may take long to say so
look
start=$(value 's.bodies[1].x + " " + s.bodies[1].y')
# As dense as a hand's moves are: what rests before it is let go isn't thrown
path=$(value "(() => { const [m, x0, y0] = s.map, out = []; for (let k = 1; k <= 15; ++k) out.push('mousemove', Math.round(x0 + m * (${start% *} - 0.1 * k)), Math.round(y0 - m * (${start#* } + 0.04 * k)), 'sleep', 0.012); return out.join(' ') })()")
# shellcheck disable=SC2086
point $start
keys p
# shellcheck disable=SC2086
xdotool mousedown 1 $path mouseup 1
keys p
expect "a body is thrown" 's.holds === -1 && Math.hypot(s.bodies[1].vx, s.bodies[1].vy) > 0.5' # it may have met a wall since
keys 2
look
point 8 1.2
xdotool click 1
sleep 0.1
expect "a click adds a disc" 's.bodies.length === 4 && Math.abs(s.bodies[3].x - 8) < 0.05'
keys 4
for corner in '3 6' '5 6' '5 7.5' '4.4 6.4'; do
    # shellcheck disable=SC2086
    point $corner
    xdotool click 1
    sleep 0.05
done
expect "a drawing" 's.points === 4'
point 3.9 6.9
shot drawing
xdotool click 3
sleep 0.1
expect "the right button closes it" 's.points === 0 && s.bodies.length === 5'
keys 5
point 8 1.2
xdotool click 1
sleep 0.1
expect "a click removes" 's.bodies.length === 4'
keys 1
xdotool click 6 click 6 click 4
sleep 0.1
expect "scrolling steers" 's.ship.body >= 0 && s.ship.thrust > 0'
xdotool keydown ctrl click 4 click 4 keyup ctrl
sleep 0.1
expect "Ctrl and scrolling zooms" 's.view[1][1] - s.view[0][1] < 7'
keys z

# ---- Controls ----------------------------------------------------------------------------------------------------------

look
press_control Pause
expect "button Pause" '!s.paused'
press_control Pause
expect "button Pause again" 's.paused'
press_control Reset
expect "button Reset" 's.time === 0 && s.bodies.length === 3'
press_control '▶'
expect "button of one frame" 's.time > 0'
for tool in 'Disc:add a disc' 'Polygon:add a polygon' 'Draw:draw a polygon' Remove:remove 'Grab:grab and throw'; do
    press_control "${tool%%:*}"
    expect "button ${tool%%:*}" "s.tool === '${tool#*:}'"
done
press_control Restitution
expect "scale of restitution" 's.restitution > 0.2 && s.restitution < 0.8'
press_control Undo
expect "button Undo" 's.restitution === 1'
press_control Redo
expect "button Redo" 's.restitution < 0.8'
press_control Undo
press_control Friction
expect "scale of friction" 's.friction > 0.3'
press_control 'trails'
expect "check of a layer" "s.layers.includes('trails')"
press_control 'dark'
expect "check of the dark" 's.dark'
press_control 'dark'
press_control 'Trace'
press_control 'Trace'
expect "buttons of the trace" 's.notice.includes("lines")'
keys Tab Tab Tab
xdotool mousemove 500 400 click 1
keys period
expect "keys after the controls" 's.paused'
shot panel

# ---- Files -------------------------------------------------------------------------------------------------------------

keys Home ctrl+o
sleep 1
xdotool type --delay 5 "$root/chapters/scenes/cradle.toml"
sleep 0.3
keys Return
sleep 1
expect "Ctrl+O opens a scene" 's.scene.endsWith("cradle.toml") && s.bodies.length !== 3'

# Saved, the scene is one that has every body where it is
keys period period
look
seen=$(value 'JSON.stringify(s.bodies.map(b => [b.x, b.y, b.vx, b.vy]))')
keys ctrl+s
sleep 1
xdotool key ctrl+a
xdotool type --delay 5 "$work/saved.toml"
sleep 0.3
keys Return
sleep 1
expect "Ctrl+S says what it has written" 's.notice.includes("saved.toml")'
"$program" simulate "$work/saved.toml" --until 0 --report "$work/saved.json" --quiet || true
judge "the scene that was saved has the bodies where they were" \
    "JSON.stringify(JSON.parse(require('fs').readFileSync('$work/saved.json')).bodies.map(b => [...b.position, ...b.velocity])) === '$seen'"

# Filmed, each frame is what was seen
keys p F6
sleep 1.5
keys F6
sleep 0.5
expect "F6 counts its frames" 's.notice.includes("frames")'
film=$(printf '%s\n' "$work"/*.mp4)
facts=$(ffprobe -v error -count_frames -select_streams v -show_entries stream=codec_name,width,height,nb_read_frames -of csv=p=0 "$film" || true)
judge "the film has the window's size, and as many frames as it says" \
    "(f => f[0] === 'h264' && +f[1] === s.surface[0] - s.surface[0] % 2 && +f[2] === s.surface[1] - s.surface[1] % 2 && +f[3] > 5 && s.notice.includes(': ' + f[3] + ' frames'))('$facts'.split(','))"
ffmpeg -v error -y -sseof -0.1 -i "$film" -frames:v 1 "$work/film.png" || true
judge "a frame of it shows bodies on paper" "require('fs').statSync('$work/film.png').size > 4000"
[[ -z $shots ]] || cp "$work/film.png" "$shots/film.png"

# Dropped, a file is opened
look
if [[ -x $dragged ]]; then
    "$dragged" "$work/three.toml" >"$work/drag_log" 2>&1 &
    drag=$!
    from=$(timeout 20 xdotool search --sync --onlyvisible --name 'a file to drag' | head -n 1)
    eval "$(xdotool getwindowgeometry --shell "$from")"
    xdotool mousemove $((X + WIDTH / 2)) $((Y + HEIGHT / 2)) mousedown 1
    for k in $(seq 20); do xdotool mousemove $((X + WIDTH / 2 + 15 * k)) $((Y + HEIGHT / 2 + 15 * k)) sleep 0.03; done
    xdotool mouseup 1
    sleep 1
    kill "$drag" 2>/dev/null || true
    xdotool windowfocus "$id"
    expect "a file that is dropped is opened" 's.scene.endsWith("three.toml") && s.bodies.length === 3'
fi

xdotool windowfocus "$id"
keys q
for _ in $(seq 50); do kill -0 "$window" 2>/dev/null || break; sleep 0.1; done
if kill -0 "$window" 2>/dev/null; then
    bad=$((bad + 1))
    echo "WRONG: Q did not quit"
else
    status=0
    wait "$window" || status=$?
    ((status == 0)) && good=$((good + 1)) || { bad=$((bad + 1)); echo "WRONG: status $status: $(cat "$work/log")"; }
fi
window=
if grep -E 'CRITICAL|WARNING|ERROR' "$work/log" | grep -v -E 'dconf|portal|at-spi|a11y|Vulkan|settings' >&2; then
    bad=$((bad + 1))
    echo "WRONG: the window complained"
fi
echo "$good actions did what they say, $bad did not"
((bad == 0))
