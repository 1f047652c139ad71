#!/usr/bin/env bash
# The window of `flying window` under Xvfb: keys, mouse and controls by xdotool, then what the window says of itself (F8).
# Usage: window_test.sh PROGRAM [FOLDER FOR SCREENSHOTS]. Last line: "N actions did what they say, M did not".
# A file is dropped from the program window_drag_source, which lies beside PROGRAM. At the end, keys of the table in keys.cpp and
# controls of the panel that nothing has pressed count as wrong. Nothing waits for a time: what is expected may take its while.
set -Eeuo pipefail
export LC_ALL=C.UTF-8 NO_AT_BRIDGE=1 GTK_A11Y=none
program=$(readlink -f "$1")
dragged=$(dirname "$program")/window_drag_source
shots=${2:+$(mkdir -p "$2" && readlink -f "$2")}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
good=0
bad=0

# A server that began anew whenever its last client leaves would turn away a window that is just coming when a search ends
exec 7>"$work/display"
Xvfb -displayfd 7 -screen 0 1280x800x24 -nolisten tcp -noreset >"$work/xvfb" 2>&1 &
server=$!
window=
finish() {
    [[ -z $window ]] || kill "$window" 2>/dev/null || true
    [[ -z $window ]] || kill -CONT "$window" 2>/dev/null || true # it may stand still for a throw
    kill "$server" 2>/dev/null || true
    wait 2>/dev/null || true
    rm -rf "$work"
}
trap finish EXIT
for _ in $(seq 1200); do [[ -s $work/display ]] && break; sleep 0.05; done
DISPLAY=:$(cat "$work/display")
export DISPLAY

wrong() { # what...
    bad=$((bad + 1))
    echo "WRONG: $*"
}

# A command that fails where nothing asks whether it does: said, and the end
trap 'wrong "line $LINENO: $BASH_COMMAND"; finished' ERR

finished() { # the last line
    trap - ERR
    echo "$good actions did what they say, $bad did not"
    ((bad == 0)) && exit 0 || exit 1
}

# A window that goes while xdotool looks at all of them ends its search with an error of X, so it is searched again
shown() { # what xdotool searches for: their numbers
    local k
    for ((k = 0; k < 20; ++k)); do
        xdotool search --onlyvisible "$@" >"$work/shown" 2>"$work/complaint" || true
        [[ -s $work/complaint ]] || break
    done
    cat "$work/shown"
}
window_named() { # name: the first one's number. The program may take its while; what hangs has none for ten minutes
    local k one
    for ((k = 0; k < 6000; ++k)); do
        one=$(shown --name "$1" | sed -n 1p)
        [[ -z $one ]] || { echo "$one"; return 0; }
        kill -0 "$window" 2>/dev/null || { echo "the program is gone" >&2; return 1; }
        sleep 0.1
    done
    ps -o pid,stat,time,pcpu,wchan:20 -p "$window" >&2
    return 1
}

open_window() { # arguments of flying window
    (cd "$work" && exec env PATH="${path:-$PATH}" "$program" window "$@" --state "$work/state.json" --size "${extent:-1280x800}" >"$work/log" 2>&1) &
    window=$!
    if ! id=$(window_named 'Flying Polygons'); then
        wrong "no window after 'flying window $*': $(cat "$work/log")"
        finished
    fi
    xdotool windowfocus "$id"
    # The first answer may be asked for before the window listens
    for _ in $(seq 60); do look 10 && return 0; done
    wrong "the window did not answer: $(cat "$work/log")"
    finished
}

close_window() { # by a key
    xdotool windowfocus "$id"
    keys "$1"
    for _ in $(seq 300); do kill -0 "$window" 2>/dev/null || break; sleep 0.1; done
    if kill -0 "$window" 2>/dev/null; then
        wrong "$1 did not quit"
        kill -9 "$window"
    else
        local status=0
        wait "$window" || status=$?
        ((status == 0)) && good=$((good + 1)) || wrong "status $status: $(cat "$work/log")"
    fi
    window=
    if grep -E 'CRITICAL|WARNING|ERROR' "$work/log" | grep -v -E 'dconf|portal|at-spi|a11y|Vulkan|settings' >&2; then
        wrong "the window complained"
    fi
}

look() { # a fresh state, within so many tenths of a second
    local k
    rm -f "$work/state.json"
    xdotool key F8
    for ((k = 0; k < 5 * ${1:-300}; ++k)); do [[ ! -e $work/state.json ]] || return 0; sleep 0.02; done
    return 1
}

value() { # expression in s, the state: prints it
    node -p "const s = JSON.parse(require('fs').readFileSync('$work/state.json')); $1"
}

expect() { # what expression: becomes true of the state
    local k
    for ((k = 0; k < 60; ++k)); do
        look || { wrong "no answer after: $1"; finished; }
        [[ $(value "$2") != true ]] || { good=$((good + 1)); return 0; }
        sleep 0.1
    done
    wrong "$1: not true: $2"
    value 'delete s.bodies, delete s.controls, JSON.stringify(s)' | cut -c 1-1200
}

judge() { # what expression: true of the state that was looked at last
    if [[ $(value "$2") == true ]]; then good=$((good + 1)); else wrong "$1: not true: $2"; fi
}

keys() {
    printf '%s\n' "$@" >>"$work/pressed"
    xdotool key --delay 15 "$@"
}
shot() { [[ -z $shots ]] || { sleep 0.3; ffmpeg -v error -y -f x11grab -video_size 1280x800 -i "$DISPLAY" -frames:v 1 "$shots/$1.png" || true; }; }
at() { # world x, y: where they lie on the screen
    value "(() => { const v = s.map; return [v[1] + v[0] * ($1), v[2] - v[0] * ($2)].map(Math.round).join(' ') })()"
}
# shellcheck disable=SC2046
point() { xdotool mousemove $(at "$1" "$2"); }
click_at() { # world x, y [button]
    point "$1" "$2"
    xdotool click "${3:-1}"
}
# A control of the panel, by its text
press_control() {
    local place
    place=$(value "(s.controls['$1'] || []).map(Math.round).join(' ')")
    [[ -n $place ]] || { wrong "no control '$1'"; return 0; }
    echo "$1" >>"$work/controlled"
    # shellcheck disable=SC2086
    xdotool mousemove $place click 1
}
windows() { shown --class . | wc -l; }
choose() { # control keys...: of a list that drops down, in a window of its own
    local before k
    before=$(windows)
    press_control "$1"
    shift
    for ((k = 0; k < 100; ++k)); do (($(windows) <= before)) || break; sleep 0.1; done
    xdotool key --delay 100 "$@"
    for ((k = 0; k < 100; ++k)); do (($(windows) > before)) || break; sleep 0.1; done
}
dialog() { # title [path]: answer a dialog for files, or escape from it
    local other k
    other=$(window_named "$1") || { wrong "no dialog '$1'"; return 0; }
    good=$((good + 1))
    xdotool windowfocus "$other"
    # A name is given already where something is saved
    [[ $1 != Save* ]] || xdotool key ctrl+a
    [[ -z ${2:-} ]] || xdotool type --delay 5 "$2"
    for ((k = 0; k < 60; ++k)); do
        xdotool windowfocus "$other" key "$([[ -n ${2:-} ]] && echo Return || echo Escape)" 2>/dev/null || true
        sleep 0.3
        [[ -n $(shown --name "$1") ]] || break
    done
    xdotool windowfocus "$id"
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
layers=('s:speed arrows' 'c:contact points' n:normals i:impulses 'x:bounding boxes' k:cells o:islands 'e:next events' t:trails
    'm:centroid, inertia' l:labels 'h:energy and momentum' 'w:what the plan skips' 'f:cost figures' F1:help)

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
expect "P lets time run" '!s.paused && s.time > 0.1'
keys space
expect "space holds it" 's.paused'
keys plus
expect "+" 's.speed === 2'
keys minus minus
expect "-" 's.speed === 0.5'
keys r Left Left
expect "R, left" 's.restitution === 0.98 && s.arrow_keys === "restitution"'
keys Right
expect "R, right" 's.restitution === 0.99'
keys shift+Down shift+Left
expect "R, Shift+down, Shift+left" 's.restitution === 0.79'
keys shift+Up shift+Right
expect "R, Shift+up, Shift+right" 's.restitution === 0.99'
keys Escape
expect "Escape gives the arrows back" 's.arrow_keys === "pointer"'
keys g Left Up
expect "G, left and up" 'Math.abs(s.field.gravity[0] + 0.1) < 1e-9 && Math.abs(s.field.gravity[1] + 0.9) < 1e-9'
shot gravity
keys Down Right
expect "G, down and right" 's.field.gravity[0] === 0 && Math.abs(s.field.gravity[1] + 1) < 1e-9'
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
keys period F5
expect "F5" 's.time === 0'
keys period Home
expect "Home" 's.time === 0 && s.restitution === 1'
for pair in "${layers[@]}"; do
    keys "${pair%%:*}"
    expect "${pair%%:*} on" "s.layers.includes('${pair#*:}') && s.layers.length === 1"
    [[ ${pair%%:*} != F1 ]] || shot help
    keys "${pair%%:*}"
done
expect "layers off" 's.layers.length === 0'
keys F1 Escape
expect "Escape puts the help away" 's.layers.length === 0'
keys a
expect "A" 's.colouring === "mover"'
keys u
expect "U" 's.colouring === "random"'
keys u y d
expect "U, Y, D" 's.colouring === "number" && !s.faces_turn && s.dark'
shot dark
keys d j
expect "J" 's.box_follows'
xdotool windowsize "$id" 1200 700
expect "a smaller window with J" 's.box[1][0] < 9.5 && s.box[1][1] < 7.5'
xdotool windowsize "$id" 1280 800
expect "a larger one" 's.surface[1] === 800 && s.box[1][1] > 7.9'
keys j Home F9
expect "F9" 's.surface[0] === 1280 && !s.box_follows'
keys F9
expect "F9 again" 's.surface[0] < 1100'
keys b b
expect "B" 's.selected === 1'
keys shift+b v
expect "Shift+B, V" 's.selected === 0 && s.ship.body === 0'
keys ctrl+Left ctrl+Up ctrl+Up
expect "Ctrl+left, Ctrl+up" 'Math.abs(s.ship.heading - Math.PI / 2 - Math.PI / 18) < 1e-9 && s.ship.thrust === 0.5'
keys ctrl+Right ctrl+Right ctrl+Down
expect "Ctrl+right, Ctrl+down" 'Math.abs(s.ship.heading - Math.PI / 2 + Math.PI / 18) < 1e-9 && s.ship.thrust < 0.5'
keys b Delete
expect "Delete" 's.bodies.length === 2 && s.bodies[1].name === ""'
keys ctrl+z 2 bracketright
expect "2, ]" 's.tool === "add a disc" && s.bodies.length === 3 && s.size > 0.45'
keys bracketleft bracketleft
expect "[" 's.size < 0.38'
keys Escape 3 Prior Prior Next
expect "3, page up and down" 's.tool === "add a polygon" && s.sides === 6'
keys Escape
expect "Escape" 's.tool === "grab and throw"'
keys 5
expect "5" 's.tool === "remove"'
keys 1
expect "1" 's.tool === "grab and throw"'
# The keyboard's crosshair: from a body to where there is room, and a disc there
keys b b 2 shift+Up shift+Up shift+Up shift+Up
expect "arrows move the crosshair" 's.arrow_keys === "pointer" && s.pointer[1] > 3 && Math.abs(s.pointer[0] - 5) < 0.1'
keys Left Left Right Return Return
expect "Return, twice, adds a disc" 's.bodies.length === 4 && Math.abs(s.bodies[3].x - s.pointer[0]) < 1e-9'
keys ctrl+z 4 Return Up Up Return Right Return
expect "4, Return" 's.points === 3 && s.tool === "draw a polygon"'
keys BackSpace
expect "Backspace" 's.points === 2'
keys Escape Escape ctrl+plus
expect "Ctrl +" 's.view[1][1] - s.view[0][1] < 7'
keys z
expect "Z" 's.view[1][1] === 8'
keys ctrl+minus
expect "Ctrl -" 's.view[1][1] - s.view[0][1] > 9'
keys ctrl+0
expect "Ctrl+0" 's.view[1][1] === 8'
keys F7 period period F7
look
judge "F7 counts its lines" 's.notice.includes("lines")'
[[ $(head -c 8 "$work/three.ndjson") == '{"time":' ]] && good=$((good + 1)) || wrong "no trace"
"$program" simulate "$work/three.toml" --until 0 --picture "$work/face.png" --quiet
keys ctrl+f
dialog 'A picture for the balls' "$work/face.png"
expect "Ctrl+F" 's.face'
keys F11 # without a window manager nothing comes of it; that it is asked for, tests/unit/play knows
expect "F11" 's.paused'

# ---- Mouse -------------------------------------------------------------------------------------------------------------

keys 1 Home
expect "Home again" 's.time === 0 && s.bodies.length === 3'
point 5 2
xdotool mousedown 1
point 6 3
expect "a body is carried" 's.holds === 1 && Math.abs(s.bodies[1].x - 6) < 0.05 && Math.abs(s.bodies[1].y - 3) < 0.05'
xdotool mouseup 1
expect "and let go" 's.holds === -1 && s.selected === 1'
# As dense as a hand's moves are: what rests before it is let go isn't thrown. A machine that stands still meanwhile sees a
# hand that rests, so it may take some throws. A window that stands still sees the whole throw within one late frame, and by
# the times of its events the body has the hand's speed, below 9 m/s, all the same
throw_box() { # [late]
    local start path
    start=$(value 's.bodies[1].x + " " + s.bodies[1].y')
    path=$(value "(() => { const [m, x0, y0] = s.map, out = []; for (let k = 1; k <= 15; ++k) out.push('mousemove', Math.round(x0 + m * (${start% *} - 0.1 * k)), Math.round(y0 - m * (${start#* } + 0.04 * k)), 'sleep', 0.012); return out.join(' ') })()")
    # shellcheck disable=SC2086
    point $start
    keys p
    [[ -z ${1:-} ]] || kill -STOP "$window"
    # shellcheck disable=SC2086
    xdotool mousedown 1 $path mouseup 1
    [[ -z ${1:-} ]] || kill -CONT "$window"
    keys p
    look
}
thrown='(v => v > 0.5 && v < 9)(s.speed * Math.hypot(s.bodies[1].vx, s.bodies[1].vy))' # it may have met a wall since
for late in '' late; do
    for _ in $(seq 20); do
        throw_box $late
        [[ $(value "$thrown") != true ]] || break
        keys ctrl+z
        look
    done
    judge "a body is thrown${late:+ within a late frame}" "s.paused && s.holds === -1 && $thrown"
    keys Home
    expect "Home once more" 's.time === 0'
done
click_at 7 5 3
expect "the right button chooses" 's.selected === 2'
keys 2
expect "2" 's.tool === "add a disc"'
click_at 8 1.2
expect "a click adds a disc" 's.bodies.length === 4 && Math.abs(s.bodies[3].x - 8) < 0.05 && s.bodies[3].vx === 0'
point 2 1.5
xdotool mousedown 1
point 3 1.5
xdotool mouseup 1
expect "a drag adds one that flies" 's.bodies.length === 5 && s.bodies[4].vx > 0.5'
size=$(value 's.size')
xdotool click 4
expect "scrolling makes new bodies larger" "s.size > $size"
keys 4
expect "4" 's.tool === "draw a polygon"'
for corner in '3 6' '5 6' '5 7.5' '4.4 6.4'; do
    # shellcheck disable=SC2086
    click_at $corner
done
expect "a drawing" 's.points === 4'
point 3.9 6.9
shot drawing
xdotool click 3
expect "the right button closes it" 's.points === 0 && s.bodies.length === 6'
for corner in '6 6.5' '8 7.5' '8 6.5' '6 7.5'; do
    # shellcheck disable=SC2086
    click_at $corner
done
expect "a drawing whose sides cross" 's.points === 4'
shot crossing
xdotool click 3
look
judge "isn't closed, and the reason is given" 's.points === 4 && s.bodies.length === 6 && s.notice.startsWith("No polygon yet") && !/[.][0-9]{4}/.test(s.notice)'
keys BackSpace
expect "a point less" 's.points === 3'
click_at 6 6.5
expect "a click at the first corner closes it" 's.points === 0 && s.bodies.length === 7'
keys 5
click_at 8 1.2
expect "a click removes" 's.bodies.length === 6'
keys 1
xdotool click 6 click 6 click 4
expect "scrolling steers" 's.ship.body >= 0 && s.ship.thrust > 0'
xdotool keydown ctrl click 4 click 4 keyup ctrl
expect "Ctrl and scrolling zooms" 's.view[1][1] - s.view[0][1] < 7'
left=$(value 's.view[0][0]')
xdotool mousemove 400 400 mousedown 2 mousemove 450 400 mousemove 500 400 mouseup 2
expect "the middle button moves the view" "s.view[0][0] < $left - 0.1"
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
press_control '◀'
expect "button of one frame back" 's.time === 0'
keys plus plus plus plus plus
press_control Speed
expect "scale of speed" 's.speed > 0.05 && s.speed < 8'
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
choose field End Return
expect "list of fields" 's.field.kind === "central"'
choose field Home Return
expect "list of fields: none" 's.field.kind === "none"'
choose colours End Return
expect "list of colours" 's.colouring === "mover"'
choose colours Home Return
expect "list of colours: by number" 's.colouring === "number"'
for pair in "${layers[@]}"; do
    press_control "${pair#*:}"
    expect "check of ${pair#*:}" "s.layers.includes('${pair#*:}') && s.layers.length === 1"
    press_control "${pair#*:}"
    expect "check of ${pair#*:} again" "s.layers.length === 0"
done
press_control 'dark'
expect "check of the dark" 's.dark'
press_control 'dark'
turns=$(value 's.faces_turn')
press_control 'faces turn'
expect "check of turning faces" "s.faces_turn === !$turns"
press_control follows
expect "check of the box" 's.box_follows'
press_control follows
press_control 'Trace'
press_control 'Trace'
look
judge "buttons of the trace" 's.notice.includes("lines")'
for button in 'Open…:Open a scene' 'Save…:Save the scene' 'Face…:A picture for the balls'; do
    press_control "${button%%:*}"
    dialog "${button#*:}"
done
expect "dialogs that are left change nothing" 's.scene.endsWith("three.toml") && !s.box_follows'
xdotool mousemove 500 400 # away from lists and scales
keys Escape Tab Tab Tab Tab Return
expect "Tab goes to the controls: the fourth is Pause" '!s.paused'
keys Escape 2 Return Return period
expect "Escape comes back" 's.paused && s.tool === "add a disc"'
keys 1
expect "keys after the controls" 's.paused'
shot panel

# ---- Files -------------------------------------------------------------------------------------------------------------

keys Home ctrl+o
dialog 'Open a scene' "$root/chapters/scenes/cradle.toml"
expect "Ctrl+O opens a scene" 's.scene.endsWith("cradle.toml") && s.bodies.length !== 3'

# Saved, the scene is one that has every body where it is
keys period period
look
seen=$(value 'JSON.stringify(s.bodies.map(b => [b.x, b.y, b.vx, b.vy]))')
keys ctrl+s
dialog 'Save the scene' "$work/saved.toml"
for _ in $(seq 300); do [[ ! -e $work/saved.toml ]] || break; sleep 0.1; done
look
judge "Ctrl+S says what it has written" 's.notice.includes("saved.toml")'
"$program" simulate "$work/saved.toml" --until 0 --report "$work/saved.json" --quiet || true
judge "the scene that was saved has the bodies where they were" \
    "JSON.stringify(JSON.parse(require('fs').readFileSync('$work/saved.json')).bodies.map(b => [...b.position, ...b.velocity])) === '$seen'"

# Filmed, each frame is what was seen
films() { # begin and end it, by a key or a control
    "$@"
    look
    begun=$(value 's.time / s.speed - s.film / 60')
    for _ in $(seq 300); do look; (($(value 's.film') > 59)) && break; sleep 0.1; done
    judge "a film has the pace of what is seen" "Math.abs(s.time / s.speed - s.film / 60 - $begun) < 0.2"
    "$@"
    look
}
if command -v ffmpeg >/dev/null && command -v ffprobe >/dev/null; then
    keys p
    films keys F6
    judge "F6 counts its frames" 's.notice.includes("frames")'
    film=$(printf '%s\n' "$work"/*.mp4)
    facts=$(ffprobe -v error -count_frames -select_streams v -show_entries stream=codec_name,width,height,nb_read_frames -of csv=p=0 "$film" || true)
    judge "the film has the window's size, and as many frames as it says" \
        "(f => f[0] === 'h264' && +f[1] === s.surface[0] - s.surface[0] % 2 && +f[2] === s.surface[1] - s.surface[1] % 2 && +f[3] > 5 && s.notice.includes(': ' + f[3] + ' frames'))('$facts'.split(','))"
    ffmpeg -v error -y -sseof -0.1 -i "$film" -frames:v 1 "$work/film.png" || true
    judge "a frame of it shows bodies on paper" "require('fs').statSync('$work/film.png').size > 4000"
    [[ -z $shots ]] || cp "$work/film.png" "$shots/film.png"
    films press_control Video
    judge "buttons of the film" 's.notice.includes("frames")'
else
    wrong "no ffmpeg or no ffprobe here, so no film can be made and looked into (Debian: apt install ffmpeg)"
fi

# Dropped, a file is opened
look
if [[ -x $dragged ]]; then
    "$dragged" "$work/three.toml" >"$work/drag_log" 2>&1 &
    drag=$!
    from=$(window_named 'a file to drag')
    eval "$(xdotool getwindowgeometry --shell "$from")"
    xdotool mousemove $((X + WIDTH / 2)) $((Y + HEIGHT / 2)) mousedown 1
    for k in $(seq 20); do xdotool mousemove $((X + WIDTH / 2 + 15 * k)) $((Y + HEIGHT / 2 + 15 * k)) sleep 0.03; done
    xdotool mouseup 1
    xdotool windowfocus "$id"
    expect "a file that is dropped is opened" 's.scene.endsWith("three.toml") && s.bodies.length === 3'
    kill "$drag" 2>/dev/null || true
else
    wrong "no program window_drag_source beside $program"
fi
choose scene End Return
expect "list of scenes" 's.scene === "billiard"'
choose scene End Up Up Up Up Up Up Return
expect "list of scenes: a gas" 's.scene === "gas" && s.bodies.length > 2'
seen=$(value 'JSON.stringify(s.bodies.map(b => [b.x, b.y]))')
choose scene End Up Up Up Up Up Up Return
expect "list of scenes: the same kind again is another scene" "s.scene === 'gas' && JSON.stringify(s.bodies.map(b => [b.x, b.y])) !== '$seen' && s.time < 60"

close_window q

# Without ffmpeg, F6 says what is missing
path=$work open_window "$work/three.toml" --paused
keys F6
look
judge "F6 without ffmpeg names it" 's.notice.includes("ffmpeg") && s.film === 0'
close_window ctrl+q

extent=640x480 open_window "$work/three.toml" --paused
expect "a small window begins without the controls, and says how to get them" 's.surface[0] === 640 && s.notice.startsWith("F9")'
keys F9
expect "F9 in a small window" 's.surface[0] < 640'
keys F9
# What is recorded when the window goes becomes whole
keys F7 p
! command -v ffmpeg >/dev/null || keys F6
expect "a film begins" 's.film > 5'
close_window q
for what in frames lines; do
    written=$(sed -n "s/^\(.*\): [0-9]* $what\$/\1/p" "$work/log")
    [[ -n $written && -s $work/$written ]] && good=$((good + 1)) || wrong "quitting ends no record in $what: $(cat "$work/log")"
done

# In a low window, controls that don't fit are scrolled to. A list that is above the screen's edge comes back before it drops
# down: GTK would give it a place and a size that it never set, and complain
extent=1280x400 open_window "$work/three.toml" --paused
keys Escape Tab # the first control
xdotool mousemove 1276 200 click --repeat 30 5 # at the edge, where no scale takes it
expect "the panel is scrolled" 's.controls.scene[1] < 0'
before=$(windows)
comes_and_goes() { # a list that a key has called; Escape sends it away
    local k
    for ((k = 0; k < 100; ++k)); do (($(windows) <= before)) || break; sleep 0.1; done
    (($(windows) > before)) && good=$((good + 1)) || wrong "a list out of sight does not drop down"
    for ((k = 0; k < 100; ++k)); do
        keys Escape # it may have come before the list that is to have it
        (($(windows) > before)) || break
        sleep 0.1
    done
}
keys space
comes_and_goes
expect "a list that drops down is in sight" 's.controls.scene[1] > 0'
# A key right behind the wheel: what the panel shows is a frame behind what it is scrolled to
for delay in 0 0.004 0.008 0.012 0.016 0.02 0.024 0.028 0.032 0.036; do
    printf '%s\n' 'click --repeat 30 --delay 1 5' "sleep $delay" 'key space' | xdotool -
    comes_and_goes
done
expect "after the wheel, too" 's.controls.scene[1] > 0'
close_window q

# ---- What nothing has pressed ------------------------------------------------------------------------------------------

while read -r row; do
    for name in $row; do
        ! grep -qixF -e "$name" "$work/pressed" || continue 2
    done
    [[ $row == f8 || $row == q\ * ]] || wrong "no test presses $row"
done < <(sed -n 's/^    {"\([^"]*\)", .*/\1/p' "$root/src/play/keys.cpp")
while read -r control; do
    grep -qxF -e "$control" "$work/controlled" || wrong "no test presses the control '$control'"
done < <(value 'Object.keys(s.controls).join("\n")')
finished
