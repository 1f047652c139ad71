#!/usr/bin/env bash
# The programs of docs/USING.md, as they stand there, print what the program itself reports.
#
#   using.sh cpp BUILD            install the library of a build, configure a program that finds it, run
#   using.sh python MODULE_DIR PROGRAM
#   using.sh javascript WASM_BIN PROGRAM
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

block() { # language file: the first block of that language
    awk -v fence="\`\`\`$1" '$0 == fence { found = 1; next } found && /^```/ { exit } found' "$root/$2"
}

expected() { # program: the line that each of them has to print
    "$1" simulate "$work/meeting.toml" --quiet --report "$work/report.json"
    printf '%s collisions, hash %s\n' "$(sed -n 's/^  "collisions": \(.*\),$/\1/p' "$work/report.json")" \
        "$(sed -n 's/^  "hash": "\(.*\)",$/\1/p' "$work/report.json")"
}

compare() { # wanted found
    echo "$2"
    [[ $1 == "$2" ]] || { echo "expected: $1" >&2; exit 1; }
}

block toml README.md >"$work/meeting.toml"
cd "$work"
case $1 in
cpp)
    build=$2
    cmake --install "$build" --component library --prefix "$work/there" >/dev/null
    [[ ! -e there/include/flying/rest && ! -e there/include/flying/events ]] || { echo "internal headers installed" >&2; exit 1; }
    block cmake docs/USING.md >CMakeLists.txt
    echo 'add_executable(example example.cpp)
target_link_libraries(example PRIVATE flying::flying)' >>CMakeLists.txt
    block cpp docs/USING.md >main.cpp
    block 'cpp example' docs/USING.md >example.cpp
    compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")
    cmake -G Ninja -B out -DCMAKE_PREFIX_PATH="$work/there" -DCMAKE_CXX_COMPILER="$compiler" \
        -DCMAKE_CXX_FLAGS='-Wall -Wextra -Wpedantic -Werror' >log 2>&1 || { cat log; exit 1; }
    cmake --build out >log 2>&1 || { cat log; exit 1; }
    compare "$(expected "$build/bin/flying")" "$(out/meeting)"

    # From 3 m, with half of each speed kept, it has come to rest by the fourth second, on its lower side
    out/example
    [[ $(out/example | tail -n 1) == '4 s  height 0.500 m  speed 0.000 m/s' ]]

    # A scene with a fault: told, with status 2
    sed -i 's/side = 1.0/side = -1.0/' meeting.toml
    status=0
    out/meeting 2>errors || status=$?
    [[ $status == 2 ]] && grep -q 'side: found -1' errors
    ;;
python)
    block python docs/USING.md >main.py
    compare "$(expected "$3")" "$(PYTHONPATH=$2 /usr/bin/python3 main.py)"
    PYTHONPATH=$2 FLYING_PROGRAM=$3 PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$root/tests/library/module_test.py"
    ;;
javascript)
    cp "$2/engine.js" "$2/flying.wasm" .
    block javascript docs/USING.md >main.js
    compare "$(expected "$3")" "$(node main.js)"
    ;;
*)
    echo "using.sh: no part '$1'" >&2
    exit 2
    ;;
esac
