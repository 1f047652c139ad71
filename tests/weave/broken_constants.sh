#!/usr/bin/env bash
# Spoils one constant of the engine at a time, in a copy of the sources: the receipts of the page, without which it isn't
# made, must then stop the build, and name the equation. Prints a line for each; the last one is `N broken constants found, M missed`.
# Usage: broken_constants.sh [FOLDER]     (the copy and its build; default build/broken)
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=${1:-$root/build/broken}
jobs=${FLYING_JOBS:-$(nproc 2>/dev/null || echo 2)}

# file | what stands there, as a fixed string | what is put in its place | page | the equation that must be named
breaks=(
    'src/motion/flight.hpp|(0.5 * t) * g|(0.5005 * t) * g|01|flight.position'
    'src/motion/kepler.cpp|Twofold(2.0 * mu)|Twofold(2.002 * mu)|16|kepler'
    'src/toi/discs.hpp|std::max(outside /|std::max(1.001 * outside /|18|toi.discs'
    'chapters/18-two-balls/discs.hpp|const double j = -(1.0 + e)|const double j = -(0.999 + e)|18|impulse.newton'
    'chapters/02-rectangle/rectangle.hpp|(width * width + height * height) / 12.0|(width * width + height * height) / 12.012|02|rectangle.inertia'
    'src/mass/disc.cpp|0.5 * m * (radius * radius)|0.5005 * m * (radius * radius)|02|rectangle.disc'
    'chapters/02-rectangle/rectangle.hpp|0.5 * m * (inner * inner|0.5005 * m * (inner * inner|02|rectangle.annulus'
    'chapters/03-regular-polygon/regular_polygon.hpp|half.sine / 3.0|half.sine / 3.003|03|regular.inertia'
    'src/geometry/moments.cpp|Twofold(0.5) * sums.twice_area|Twofold(0.5005) * sums.twice_area|04|polygon.area'
    'src/geometry/moments.cpp|sums.second / Twofold(12.0)|sums.second / Twofold(12.012)|04|polygon.inertia'
    'src/collide/manifold.cpp|const double part = (along|const double part = 1.001 * (along|05|axis.cut'
    'chapters/06-vertex-collision/vertex_edge.hpp|along = 0.5 * (low + high)|along = 0.5005 * (low + high)|06|corner.middle'
    'src/response/newton.hpp|return -(1.0 + e) * v_n|return -(1.001 + e) * v_n|07|impulse.normal'
    'src/response/one_point.cpp|const double newton = (1.0 + e)|const double newton = (1.001 + e)|07|impulse'
    'src/toi/bend.hpp|turn * turn * arm) *|1.001 * turn * turn * arm) *|08|toi.bend'
    'src/math/safe_step.hpp|? 2.0 * f / denominator|? 2.002 * f / denominator|08|toi.step'
)

# Copies what the project keeps; what has not changed keeps its time, so that little is compiled again
refresh() {
    mkdir -p "$folder/sources"
    (cd "$root" && git ls-files -z | xargs -0 cp --parents -u -p -t "$folder/sources")
}

# chapter: collects its receipts. A wrong constant can keep a program from ending: discs that gain energy with each collision
# collide ever more often.
receipts() {
    timeout 300 cmake --build "$folder/build" --parallel "$jobs" --target "receipts_$1" >"$folder/page.log" 2>&1
}

refresh
cmake -S "$folder/sources" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DFLYING_OPTIMISE=-O1 \
    >"$folder/configure.log"
for page in 01 18 02 03 04 05 06 07 08 16; do
    receipts "$page" || {
        tail -n 40 "$folder/page.log"
        echo "the receipts of page $page can't be had even with every constant right"
        exit 1
    }
done

found=0
missed=0
for line in "${breaks[@]}"; do
    IFS='|' read -r file right wrong page equation <<<"$line"
    text=$(<"$root/$file")
    if [[ $text != *"$right"* ]]; then
        echo "MISSED  $file no longer says: $right"
        missed=$((missed + 1))
        continue
    fi
    printf '%s\n' "${text/"$right"/"$wrong"}" >"$folder/sources/$file"
    if receipts "$page"; then
        echo "MISSED  $file: $wrong  (page $page has its receipts)"
        missed=$((missed + 1))
    elif named=$(grep -o -m 1 "equation [a-z_.]*$equation[a-z_.]*" "$folder/page.log"); then
        echo "found   $file: $wrong  ($named)"
        found=$((found + 1))
    else
        echo "MISSED  $file: $wrong  (page $page stopped without naming $equation; it named:" \
            "$(grep -o 'equation [a-z_.]*' "$folder/page.log" | sort -u | tr '\n' ' '))"
        missed=$((missed + 1))
    fi
    cp "$root/$file" "$folder/sources/$file"
done
echo "$found broken constants found, $missed missed"
((missed == 0))
