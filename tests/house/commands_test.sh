#!/usr/bin/env bash
# commands_test.sh FLYING: every command that README, the chapters and the manual for authors tell a reader to type. Those of the
# program run as typed, one after the other in a folder of their own; of those that build or take long, the words are checked.
set -euo pipefail

flying=$1
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$top"
failures=0
count=0

fault() { # place command what was found
    printf '%s: `%s`: %s\n' "$@"
    failures=$((failures + 1))
}

texts=(README.md docs/AUTHORS.md chapters/*/chapter.md chapters/*/exercises/*/*.md)

# PLACE<tab>quoted or inline<tab>COMMAND, in order
commands() {
    awk '
        FNR == 1 { fence = "" }
        /^```/ { fence = fence == "" ? (length($0) > 3 ? substr($0, 4) : "plain") : ""; next }
        function say(kind, text) { sub(/ +# .*$/, "", text); printf "%s:%d\t%s\t%s\n", FILENAME, FNR, kind, text }
        fence == "plain" || fence == "sh" || fence == "text" {
            if ($0 ~ /^(\.\/course|flying) /) say("quoted", $0)
            next
        }
        fence != "" { next }
        {
            rest = $0
            while (match(rest, /`(\.\/course|flying) [^`]*`/)) {
                say("inline", substr(rest, RSTART + 1, RLENGTH - 2))
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

course_knows() { # place words...
    local place=$1 typed="./course ${*:2}" folder
    ./course help | grep -q -E "^\./course $2( |\$)" || { fault "$place" "$typed" "./course help has no such command"; return; }
    shift
    case $1 in
    chapter | start | check)
        [[ ${2:-} =~ ^([0-9]+|[A-Z])$ ]] || return 0 # NN
        [[ $2 == [A-Z] ]] || set -- "$1" "$(printf '%02d' "$((10#$2))")" "${@:3}"
        folder=$(awk -f docs/chapters.awk chapters/book.toml | sed -n "s/^$2 //p")
        [[ -n $folder ]] || { fault "$place" "$typed" "no such chapter"; return; }
        [[ -z ${3:-} || -f chapters/$folder/$3.cpp ]] || fault "$place" "$typed" "no chapters/$folder/$3.cpp"
        ;;
    run | play)
        [[ -z ${2:-} || $2 =~ [A-Z]{2} || -f $2 || -f chapters/scenes/$2.toml ]] || fault "$place" "$typed" "no such scene"
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

saved
mkdir -p "$work/bin"
ln -s "$(readlink -f "$flying")" "$work/bin/flying"
ln -s "$top/chapters" "$work/chapters" # paths are as typed in the folder of the project
while IFS=$'\t' read -r place kind typed; do
    count=$((count + 1))
    read -r -a words <<<"$typed"
    if [[ ${words[0]} == ./course ]]; then
        course_knows "$place" "${words[@]:1}"
    elif [[ $kind == inline || $typed == *--video* ]]; then
        flying_knows "$place" "${words[@]:1}"
    elif ! (cd "$work" && PATH=$work/bin:$PATH timeout 60 bash -c "$typed" >out.txt 2>&1); then
        fault "$place" "$typed" "$(tail -n 3 "$work/out.txt")"
    fi
done < <(commands)

((count > 10)) || { echo "only $count commands found: is the text where it was?"; failures=1; }
((failures == 0)) && echo "$count commands"
