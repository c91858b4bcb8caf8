#!/usr/bin/env bash
# Wall time and memory of one process that bakes N two-pick materials to N textures (and manifests).
#
#   tests/bench/many_materials.sh NACRE [N...]        default: 1000 10000
set -euo pipefail
nacre=${1:?which program?}
shift
(($#)) || set -- 1000 10000
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for count; do
    awk -v count="$count" 'BEGIN {
        srand(1)
        for (i = 0; i < count; ++i) {
            printf "[material.m%d]\npicks = [ ", i
            for (angle = 0; angle <= 40; angle += 40)
                printf "{ angle_deg = %d, peak_nm = %d, width_nm = %d, height = %.3f }, ",
                       angle, 400 + 300 * rand(), 40 + 160 * rand(), rand()
            print "]"
        }
    }' > "$folder/$count.toml"
    TIMEFORMAT="$count materials: %R s wall, %U s user, %S s system"
    time "$nacre" bake "$folder/$count.toml" -o "$folder/$count" --quiet
    printf '%s files\n' "$(find "$folder/$count" -name '*.exr' | wc -l)"
done
