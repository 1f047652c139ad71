#!/usr/bin/env bash
# exercise.sh start NN            puts the beginnings of chapter NN's exercises into my/, and leaves what is there
# exercise.sh check NN BUILD      builds the answers in my/ in the build folder BUILD and tries them
# exercise.sh progress            which exercises are begun, and which passed when they were last checked
# Status: 0 done, all answers pass; 1 an answer fails; 2 no such chapter, or nothing to check.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
passed=$root/my/passed.txt # a line for each answer that passed: chapter/name, checksum

usage() {
    sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}" >&2
    exit 2
}

chapters() { # a line for each: what the book calls it, its folder
    awk -f "$root/docs/chapters.awk" "$root/chapters/book.toml"
}

find_chapter() { # NN, or a letter: sets label, chapter, and number, which targets are named by
    [[ ${1:-} =~ ^([0-9]{1,2}|[A-Z])$ ]] || usage
    label=$1
    [[ $label == [A-Z] ]] || label=$(printf '%02d' "$((10#$1))")
    chapter=$(chapters | sed -n "s/^$label //p")
    [[ -n $chapter ]] || { echo "no chapter $label in chapters/book.toml" >&2; exit 2; }
    number=${chapter%%-*}
}

title() { # file.md: its first line as plain words
    sed -n '1s/^# *//p' "$1" 2>/dev/null
}

sum_of() { # file
    cksum <"$1" | tr -d ' '
}

# ---- Begin ---------------------------------------------------------------------------------------------------------------

start() {
    local stub name answer found=0
    for stub in "$root/chapters/$chapter"/exercises/*/stub.hpp; do
        [[ -f $stub ]] || continue
        found=1
        name=$(basename "$(dirname "$stub")")
        answer=$root/my/$chapter/$name.hpp
        if [[ -e $answer ]]; then
            echo "my/$chapter/$name.hpp: there already, left as it is"
        else
            mkdir -p "$(dirname "$answer")"
            cp "$stub" "$answer"
            echo "my/$chapter/$name.hpp: yours to write; the task is in chapters/$chapter/exercises/$name/text.md"
        fi
    done
    ((found)) || { echo "chapter $label has no exercise in code" >&2; exit 2; }
    echo "When you have an answer: ./course check $label"
}

# ---- Check ---------------------------------------------------------------------------------------------------------------

# What the first error of the compiler is, with paths from the project's folder
compiler_says() { # log
    grep -E -m 1 -A 3 ': (fatal )?error:' "$1" | sed "s|$root/||g; s/^/    /" || tail -n 8 "$1"
}

# Formulas as a terminal can show them
plain_formulas() {
    sed -E 's/\\t?frac\{([^{}]*)\}\{([^{}]*)\}/\1\/\2/g; s/\\t?frac([0-9])([0-9])/\1\/\2/g; s/\\sqrt ?\{([^{}]*)\}/√(\1)/g; s/\\sqrt ?/√/g
        s/\\varepsilon/ε/g; s/\\varphi/φ/g; s/\\alpha/α/g; s/\\theta/θ/g; s/\\omega/ω/g; s/\\rho/ρ/g; s/\\tau/τ/g; s/\\pi/π/g; s/\\cdot/·/g
        s/\\(cos|sin|tan|ln|ldots)/\1/g; s/\\,//g; s/\$//g'
}

# The hint as a terminal shows it: references by number are only on the page
hint() { # name
    local file=$root/chapters/$chapter/exercises/$1/hint.md
    [[ -f $file ]] || return 0
    echo
    sed -E '1d; s/\{\{eq:([^}|]*)\}\}/equation \1/g; s/\{\{ch:([^}|]*)(\|[^}]*)?\}\}/the chapter \1/g; s/\{\{(given|file):([^}]*)\}\}/\2/g' "$file" |
        plain_formulas |
        sed -e '/./,$!d' -e 's/^/    hint: /;' | sed -E '2,$s/^    hint: /          /'
    echo
}

# An answer is begun once it differs from what `start` has put there
is_begun() { # name
    [[ -f $root/my/$chapter/$1.hpp ]] && ! cmp -s "$root/chapters/$chapter/exercises/$1/stub.hpp" "$root/my/$chapter/$1.hpp"
}

remember() { # name: that its answer passed as it is now
    mkdir -p "$(dirname "$passed")"
    touch "$passed"
    { grep -v "^$chapter/$1 " "$passed" || true; echo "$chapter/$1 $(sum_of "$root/my/$chapter/$1.hpp")"; } >"$passed.new"
    mv "$passed.new" "$passed"
}

check() { # build folder
    local build=${1:-} answer name status=0 found=0 begun=0 code target
    [[ -f $build/CMakeCache.txt ]] || usage
    log=$(mktemp)
    trap 'rm -f "$log"' EXIT
    cmake -S "$root" -B "$build" >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
    for answer in "$root/my/$chapter"/*.hpp; do
        [[ -f $answer ]] || continue
        found=1
        name=$(basename "$answer" .hpp)
        target=exercise_${number}_${name}_mine
        echo "$name $(title "$root/chapters/$chapter/exercises/$name/text.md")"
        if ! is_begun "$name"; then
            echo "$name: not begun; my/$chapter/$name.hpp is yours to write"
            continue
        fi
        begun=1
        if ! cmake --build "$build" --target "$target" >"$log" 2>&1; then
            compiler_says "$log"
            echo "$name: does not compile"
            status=1
            continue
        fi
        code=0
        timeout 60 "$build/chapters/$chapter/$target" --no-colors=1 --abort-after=1 --no-skipped-summary=1 >"$log" 2>&1 || code=$?
        if ((code == 0)); then
            echo "$name: passes"
            remember "$name"
            solution=chapters/$chapter/exercises/$name/solution.hpp
            if [[ -f $root/$solution ]] && ! cmp -s "$root/$solution" "$answer"; then
                printf '%s: the book does it like this (%s)\n\n' "$name" "$solution"
                sed 's/^/    /' "$root/$solution"
            fi
        elif ((code == 124)); then
            echo "    it ran for a minute without an end"
            hint "$name"
            echo "$name: not yet"
            status=1
        else
            awk -f "$root/docs/feedback.awk" "$log"
            hint "$name"
            echo "$name: not yet"
            status=1
        fi
    done
    ((found)) || { echo "nothing in my/$chapter; begin with: ./course start $label" >&2; exit 2; }
    ((begun)) || exit 2
    return "$status"
}

# ---- Progress ------------------------------------------------------------------------------------------------------------

progress() {
    local stub name folder answer state line all=0 pass=0 next=""
    while read -r label chapter; do
        folder=$root/chapters/$chapter/
        line=""
        for stub in "$folder"exercises/*/stub.hpp; do
            [[ -f $stub ]] || continue
            name=$(basename "$(dirname "$stub")")
            answer=$root/my/$chapter/$name.hpp
            all=$((all + 1))
            state="-"
            if is_begun "$name"; then
                state="begun"
                if grep -qxF "$chapter/$name $(sum_of "$answer")" "$passed" 2>/dev/null; then
                    state="passes"
                    pass=$((pass + 1))
                fi
            fi
            [[ $state == passes || -n $next ]] || next=$label
            line+=$(printf '  %s %-7s' "$name" "$state")
        done
        [[ -z $line ]] || printf '%-4s%-26s%s\n' "$label" "$(title "${folder}chapter.md")" "${line%"${line##*[! ]}"}"
    done < <(chapters)
    echo "$pass of $all exercises in code pass as they are. Those on paper only you can tick."
    [[ -z $next ]] || echo "Next: ./course start $next"
}

case ${1:-} in
start)
    find_chapter "${2:-}"
    start
    ;;
check)
    find_chapter "${2:-}"
    check "${3:-$root/build/release}"
    ;;
progress) progress ;;
*) usage ;;
esac
