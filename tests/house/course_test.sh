#!/usr/bin/env bash
# What the driver says to wrong or unfinished requests: status 2, a sentence on stderr, nothing built.
set -euo pipefail

course=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/course
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
failures=0

expect() { # status pattern arguments...: the status, and a line of output or error that matches
    local status=0 said
    said=$("$course" "${@:3}" 2>&1 </dev/null) || status=$?
    if [[ $status != "$1" ]] || ! grep -q -e "$2" <<<"$said"; then
        echo "course ${*:3}: expected status $1 and '$2', found status $status and: $said"
        failures=$((failures + 1))
    fi
}

expect 0 '^./course run' help
expect 0 '^./course run' --help
expect 0 '^./course test --matrix'
expect 2 "no command 'fly'" fly
expect 2 "no command 'fly'" fly --help
expect 2 "no command 'fly'" help fly
for name in run play test build chapter start check progress book; do
    expect 0 "^./course $name" "$name" --help
    expect 0 "^./course $name" "$name" -h
    expect 0 "^./course $name" help "$name"
done
expect 2 'no such scene: .*/none.toml' run none.toml
expect 2 'one scene at most' run a.toml b.toml
expect 2 'no such scene: .*/none.toml' play none.toml
expect 2 'one scene at most' play a.toml b.toml
expect 2 '--matrix only; found: --all' test --all
expect 2 'no arguments; found: fast' build fast
expect 0 '^./course stress' help
expect 2 'numbers over 0; found: --count fast' stress window --count fast
expect 2 'knows --seed N and --count SECONDS; found: --until' stress window --until 5
expect 2 'book knows --open or --pdf; found: fast' book fast
expect 2 'found: --pdf --open' book --pdf --open
expect 2 "chapter 03 has no program 'figures'; expected one of: breaks demo" chapter 03 figures
expect 2 'progress takes no arguments; found: now' progress now
for name in chapter start check; do
    expect 2 'expected the number of a chapter, such as 02; found: nothing' "$name"
    expect 2 'expected the number of a chapter, such as 02; found: two' "$name" two
    expect 2 'no chapter 99' "$name" 99
    expect 2 'no appendix Z' "$name" z
done

# Whoever is not root but may do all by sudo without a password gets the packages. `sudo -v` asks for one all the same where another
# rule does, as on Debian's images for the cloud; so does this sudo.
bare=$(mktemp -d)
trap 'rm -rf "$work" "$bare"' EXIT
mkdir "$bare/bin" "$bare/clone"
cp "$course" "$bare/clone"
printf '#!/bin/sh\n[ "$1" != -v ] && exec "$@"\n' >"$bare/bin/sudo"
printf '#!/bin/sh\n[ -e %s/installed ] && echo installed\n' "$bare" >"$bare/bin/dpkg-query"
printf '#!/bin/sh\ncase "$*" in *" install "*) touch %s/installed ;; esac\n' "$bare" >"$bare/bin/apt-get"
printf '#!/bin/sh\nexit 1\n' >"$bare/bin/cmake"
chmod -R a+rwX,a+x "$bare"
plain=()
((EUID != 0)) || plain=(setpriv --reuid 65534 --clear-groups)
said=$(env -u FLYING_SETUP PATH="$bare/bin:$PATH" "${plain[@]}" "$bare/clone/course" build 2>&1 </dev/null) || true
grep -q '^Installing [0-9]* packages: done' <<<"$said" || {
    echo "course build, by one who is not root: expected packages to be installed, found: $said"
    failures=$((failures + 1))
}

[[ -z $(ls -A "$work") ]] || {
    echo "files were left behind: $(ls -A "$work")"
    failures=$((failures + 1))
}
((failures == 0))
