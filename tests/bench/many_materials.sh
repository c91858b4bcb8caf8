#!/usr/bin/env bash
# Wall and processor time of one process that bakes N two-pick materials to N textures (and manifests): picks that are
# numbers of bands, and picks that are colours.
#
#   tests/bench/many_materials.sh NACRE [N...]        default: 1000 10000
set -euo pipefail
nacre=${1:?which program?}
shift
(($#)) || set -- 1000 10000
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for count; do
    for picks in bands colours; do
        awk -v count="$count" -v picks="$picks" 'BEGIN {
            srand(1)
            for (i = 0; i < count; ++i) {
                printf "[material.m%d]\npicks = [ ", i
                for (angle = 0; angle <= 40; angle += 40) {
                    printf "{ angle_deg = %d, ", angle
                    if (picks == "bands")
                        printf "peak_nm = %d, width_nm = %d, height = %.3f }, ", 400 + 300 * rand(), 40 + 160 * rand(), rand()
                    else
                        printf "colour = \"#%02x%02x%02x\" }, ", 256 * rand(), 256 * rand(), 256 * rand()
                }
                print "]"
            }
        }' > "$folder/$picks.toml"
        TIMEFORMAT="$count materials, picks as $picks: %R s wall, %U s user, %S s system"
        time "$nacre" bake "$folder/$picks.toml" -o "$folder/$picks" --quiet
        printf '%s files\n' "$(find "$folder/$picks" -name '*.exr' | wc -l)"
        rm -r -- "$folder/$picks"
    done
done
