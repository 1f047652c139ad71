#!/usr/bin/env bash
# commands_test.sh FLYING CHAPTERS: every command that a text tells a reader to type, and every file that it names. Commands of the
# program and of the chapters' programs run as typed, one after the other in a folder of their own; of those that build, open a
# window or take minutes, the words are checked: the command, its parts, its options.
set -euo pipefail

flying=$1
built=$(readlink -f "$2") # the chapters' programs, CHAPTERS/NAME/PROGRAM_NN
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$top"
failures=0
count=0
ran=0

fault() { # place command what was found
    printf '%s: `%s`: %s\n' "$@"
    failures=$((failures + 1))
}

# docs/CHANGELOG.md tells of what was; docs/USING.md and docs/BOOKS.md have tests of their own in tests/library besides
texts=(README.md docs/[ABUHw]*.md docs/CONTRIBUTING.md chapters/*.md chapters/*/chapter.md chapters/*/exercises/*/*.md)

# PLACE<tab>quoted or inline<tab>COMMAND, in order
commands() {
    awk '
        FNR == 1 { fence = "" }
        /^```/ { fence = fence == "" ? (length($0) > 3 ? substr($0, 4) : "plain") : ""; next }
        function say(kind, text) { sub(/ +# .*$/, "", text); printf "%s:%d\t%s\t%s\n", FILENAME, FNR, kind, text }
        fence == "plain" || fence == "sh" || fence == "text" {
            if ($0 ~ /^(\.\/course|flying|cmake|ninja|\.ci\/run|cp|mkdir) /) say("quoted", $0)
            next
        }
        fence != "" { next }
        {
            rest = $0
            while (match(rest, /`(\.\/course|flying|cmake|ninja|\.ci\/run|docs\/exercise\.sh)( [^`]*)?`/)) {
                text = substr(rest, RSTART + 1, RLENGTH - 2)
                if (text ~ / / || text == ".ci/run") say("inline", text)
                rest = substr(rest, RSTART + RLENGTH)
            }
        }' "${texts[@]}"
    awk '
        /^\[\[chapter\]\]/ { ++chapter }
        /^appendix = / { split($0, part, "\""); chapter = part[2] }
        /^runs = \[/ { inside = 1; next }
        inside && /^\]/ { inside = 0 }
        inside { split($0, part, "\""); printf "chapters/book.toml:%d\tinline\t./course chapter %s %s\n", FNR, chapter, part[2] }
    ' chapters/book.toml
}

# A text in TOML that README has saved under a name
saved() {
    local name
    name=$(grep -o -m 1 'Saved as `[a-z-]*\.toml`' README.md | sed 's/.*`\(.*\)`/\1/')
    [[ -n $name ]] || return 0
    awk '/^```toml/ { inside = 1; next } /^```/ { if (inside) exit } inside' README.md >"$work/$name"
}

run_as_typed() { # place command
    ran=$((ran + 1))
    (cd "$work" && PATH=$work/bin:$PATH timeout 600 bash -c "$2" >out.txt 2>&1) || fault "$1" "$2" "$(tail -n 3 "$work/out.txt")"
}

# Each option of a command of the driver is written somewhere in what reads it
options_known() { # place typed files... -- words...
    local place=$1 typed=$2 files=() word
    shift 2
    while [[ $1 != -- ]]; do files+=("$1") && shift; done
    for word in "${@:2}"; do
        [[ $word != --* ]] || grep -q -s -r -F -e "$word" "${files[@]}" || fault "$place" "$typed" "no option $word"
    done
}

course_knows() { # place words...
    local place=$1 typed="./course ${*:2}" folder own
    ./course help | grep -q -E "^\./course $2( |\$)" || { fault "$place" "$typed" "./course help has no such command"; return; }
    shift
    case $1 in
    chapter | start | check)
        [[ ${2:-} =~ ^([0-9]+|[A-Z])$ ]] || return 0 # NN
        [[ $2 == [A-Z] ]] || set -- "$1" "$(printf '%02d' "$((10#$2))")" "${@:3}"
        folder=$(awk -f docs/chapters.awk chapters/book.toml | sed -n "s/^$2 //p")
        [[ -n $folder ]] || { fault "$place" "$typed" "no such chapter"; return; }
        own=$(sed -n 's,^chapters/\([^/]*\)/exercises/.*,\1,p' <<<"$place")
        [[ -z $own || $own == "$folder" ]] || fault "$place" "$typed" "that is $folder; the exercise is one of $own"
        [[ -n ${3:-} ]] || return 0
        [[ -f chapters/$folder/$3.cpp ]] || { fault "$place" "$typed" "no chapters/$folder/$3.cpp"; return; }
        [[ -z ${4:-} ]] || run_as_typed "$place" "$built/$folder/$3_${folder%%-*} ${*:4}"
        ;;
    run | play)
        [[ -z ${2:-} || $2 =~ [A-Z]{2} || -f $2 || -f chapters/scenes/$2.toml ]] || fault "$place" "$typed" "no such scene"
        ;;
    test | book) options_known "$place" "$typed" course -- "$@" ;;
    bench)
        options_known "$place" "$typed" tests/bench -- "$@"
        for word in "${@:2}"; do
            [[ $word == --* || $word =~ ^[0-9.]+$ ]] || grep -q -r -F -e "\"$word" tests/bench || fault "$place" "$typed" "no scene $word"
        done
        ;;
    stress)
        options_known "$place" "$typed" course tests/stress tests/fuzz tests/ui -- "$@"
        [[ -z ${2:-} || $2 == --* ]] || ./course help | grep -q "^\./course stress $2\b" ||
            grep -q -r -F -e "\"$2\"" tests/stress || fault "$place" "$typed" "no part $2"
        ;;
    esac
}

flying_knows() { # place words...: the command and its options
    local place=$1 typed="flying ${*:2}" known word
    known=$("$flying" "$2" --help 2>/dev/null) || { fault "$place" "$typed" "no such command"; return; }
    for word in "${@:3}"; do
        [[ $word != --* ]] || grep -q -e "$word\b" <<<"$known" || fault "$place" "$typed" "no option $word"
    done
}

builder_knows() { # place words...: presets, targets and components that CMake's files have
    local place=$1 typed="${*:2}" word before=
    for word in "${@:2}"; do
        case $before in
        --preset) grep -q "\"name\": \"$word\"" CMakePresets.json || fault "$place" "$typed" "no preset $word" ;;
        --component) grep -q -r --include=CMakeLists.txt --include=*.cmake "COMPONENT $word\b" src docs CMakeLists.txt || fault "$place" "$typed" "no component $word" ;;
        esac
        before=$word
    done
    # A bare machine has no make: the driver installs ninja
    [[ "$typed" != cmake\ *-B\ * || "$typed" == *'-G Ninja'* ]] || fault "$place" "$typed" "no -G Ninja, and no make"
    case $2 in
    ninja) grep -q -r --include=CMakeLists.txt -e "add_custom_target($before\b" docs tests src || fault "$place" "$typed" "no target $before" ;;
    cp) [[ ! ${4:-} =~ ^(tests|docs|chapters)/ || -e $4 ]] || fault "$place" "$typed" "no $4" ;;
    esac
}

saved
mkdir -p "$work/bin"
ln -s "$(readlink -f "$flying")" "$work/bin/flying"
ln -s "$top/chapters" "$work/chapters" # paths are as typed in the folder of the project
while IFS=$'\t' read -r place kind typed; do
    count=$((count + 1))
    read -r -a words <<<"$typed"
    case ${words[0]} in
    ./course) course_knows "$place" "${words[@]:1}" ;;
    flying)
        # Inline, only what is complete: it names a scene that is there, and nothing in capitals stands for something else
        if [[ $kind == inline && ! ($typed == *chapters/scenes/*.toml* && ! $typed =~ [A-Z]{3}) ]]; then
            flying_knows "$place" "${words[@]:1}"
        elif [[ $typed == *--video* ]] && ! command -v ffmpeg >/dev/null; then
            flying_knows "$place" "${words[@]:1}"
        else
            run_as_typed "$place" "$typed"
        fi
        ;;
    mkdir) run_as_typed "$place" "$typed" ;;
    .ci/run | docs/exercise.sh) [[ -x ${words[0]} ]] || fault "$place" "$typed" "no such program" ;;
    *) builder_knows "$place" "${words[@]}" ;;
    esac
done < <(commands)

# Files that are named in the text
while IFS=: read -r file line path; do
    path=${path//\`/}
    [[ -e $path || $path =~ (NN|NAME|MODULE|YOUR) || $path == out/* ]] || fault "$file:$line" "$path" "no such file"
done < <(grep -n -o -E '`(src|chapters|tests|docs)/[A-Za-z0-9_./-]+`' "${texts[@]}")

# A piece of a scene that a chapter shows stands in a scene of the course, line for line
for text in chapters/*/chapter.md; do
    piece=$(awk '/^```toml/ { inside = 1; next } /^```/ { inside = 0 } inside' "$text")
    [[ -n $piece ]] || continue
    where=
    for scene in chapters/scenes/*.toml; do [[ $(<"$scene") != *"$piece"* ]] || where=$scene; done
    [[ -n $where ]] || fault "$text" "${piece%%$'\n'*} ..." "no scene of chapters/scenes has these lines"
done

# README lists the chapters as book.toml has them
listed=$(sed -n 's/^| \([0-9A-Z]*\) | \(.*\) | \(.*\) |$/\1: \2: \3/p' README.md | sed 's/^\([0-9]\):/0\1:/')
expected=$(awk '
    function say() { if (title != "") print (label == "" ? sprintf("%02d", ++count) : label) ": " title ": " asks }
    /^\[\[chapter\]\]/ { say(); label = title = asks = "" }
    /^(appendix|title|question) = / { split($0, part, "\""); if (/^a/) label = part[2]; else if (/^t/) title = part[2]; else asks = part[2] }
    /^title = / && !inside { inside = 1; title = "" }
    END { say() }' chapters/book.toml | sort)
diff <(sort <<<"$listed") <(printf '%s\n' "$expected") >"$work/listed" ||
    fault README.md "the table of chapters" "other chapters or questions than book.toml: $(head -n 3 "$work/listed" | tr '\n' ' ')"

((count > 50 && ran > 10)) || { echo "only $count commands found, $ran run: is the text where it was?"; failures=1; }
((failures == 0)) && echo "$count commands, $ran of them run"
