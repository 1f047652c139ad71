#!/usr/bin/env bash
# Shows that compare_hashes.sh passes where programs agree, and fails where one differs, fails or says nothing.
set -euo pipefail

script=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/compare_hashes.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/scenes"
echo 'title = "one"' >"$work/scenes/one.toml"
echo 'title = "two"' >"$work/scenes/two.toml"

# A stand-in for `flying`: simulate SCENE --report FILE --quiet writes the hash that its own name asks for
cat >"$work/flying" <<'TEXT'
#!/usr/bin/env bash
kind=$(basename "$0")
if [[ $1 == generate ]]; then
    [[ $kind != other-scene ]] || echo "# another"
    echo "title = \"$*\""
    exit 0
fi
hash=1f2e3d4c5b6a7988
[[ $kind != other-hash || $2 != *two.toml ]] || hash=1f2e3d4c5b6a7989
[[ $kind != fails ]] || exit 1
[[ $kind != silent ]] || hash=
printf '{ "time": 1.5, "events": 12,\n "hash": "%s" }\n' "$hash" >"$4"
TEXT
chmod +x "$work/flying"
for kind in one another other-hash other-scene fails silent; do cp "$work/flying" "$work/$kind"; done

failures=0
expect() { # status last-line programs...
    local status=0 said
    said=$(cd "$work" && FLYING_SCENES=$work/scenes FLYING_GENERATED=2 "$script" "${@:3}" 2>&1) || status=$?
    if [[ $status != "$1" || ${said##*$'\n'} != "$2" ]]; then
        echo "programs ${*:3}: expected status $1 and '$2', found status $status and:"
        echo "$said"
        failures=$((failures + 1))
    fi
}
expect 0 "4 scenes agree, 0 differ" ./one ./another
expect 1 "3 scenes agree, 1 differ" ./one ./another ./other-hash
expect 1 "2 scenes agree, 2 differ" ./one ./other-scene
expect 1 "0 scenes agree, 4 differ" ./one ./fails
expect 1 "0 scenes agree, 4 differ" ./fails ./fails
expect 1 "0 scenes agree, 4 differ" ./silent ./silent
expect 2 "compare_hashes.sh: at least two programs; found 1" ./one
expect 2 "compare_hashes.sh: not a program: ./none" ./one ./none
((failures == 0))
