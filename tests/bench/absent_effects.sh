#!/usr/bin/env bash
# Effects that a palette does not have cost it nothing: instructions under valgrind's callgrind of the bake of two plain
# palette LUTs, and of the same LUTs out of a scene that could have used every effect. There the palette carries the
# only effect that means anything for it, neutral, and the file holds every other mechanism with all effects that it
# has, some of which name files that do not exist. Exit 1 if anything grows by more than 1 %, or a byte of a LUT differs.
#
# Counted from main() on: the dynamic linker takes as much again, and is the same for both. Of it, `choose` is what
# decides on size and integral, and `bake` what computes texels; the rest reads the scene and the OpenColorIO config,
# converts, measures and writes.
#
#   tests/bench/absent_effects.sh NACRE
set -euo pipefail
nacre=$(readlink -f -- "${1:?which program?}")
most_per_mille=10
for tool in valgrind callgrind_annotate; do
    command -v "$tool" > /dev/null || { echo "$tool is missing: apt-get install valgrind" >&2; exit 3; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# scene [KEY]: the palette with one more key.
scene() {
    cat <<END
nacre = 1
[material.palette]
picks = [
    { angle_deg = 0, peak_nm = 460, width_nm = 70, height = 1 },
    { angle_deg = 40, peak_nm = 395, width_nm = 60, height = 0.7 },
]
shape = 0.26
${1-}
[lut.line]
material = "palette"
size = 4096
[lut.plane]
material = "palette"
y = { parameter = "shape", from = 0, to = 1 }
size = [256, 64]
END
}

# Tables of dispersion, absorption, an incoherent layer, spread, every base, tilt, polarisations, orders, radii.
everything_else() {
    cat <<'END'
[material.film]
mechanism = "film"
index = "chitin"
thickness_nm = 300
substrate = "water"
thickness_spread_nm = 20
base = { pigment = "melanin", scattering_per_um = 0.5, share = 0.01 }
tilt_deg = 8
polarisation = "both"
[material.stack]
mechanism = "stack"
layers = [
    { index = "not_there.yml", thickness_nm = 1e6, incoherent = true },
    { repeat = 20, layers = [ { index = "tio2", thickness_nm = 60 }, { index = "cuticle", thickness_nm = 95 } ] },
]
thickness_spread_nm = 10
base = { metal = "al" }
tilt_deg = 12
polarisation = "s"
[material.tilted]
shape = 0.3
tilt_deg = 15
picks = [ { angle_deg = 0, peak_nm = 550, width_nm = 80, height = 1 }, { angle_deg = 50, peak_nm = 500, width_nm = 80, height = 0.8 } ]
[material.grating]
mechanism = "grating"
period_nm = 1600
depth_nm = 120
coat = "al"
orders = [1, 2, 3]
groove_length_um = 2.5
azimuth_deg = 12
[material.crystal]
mechanism = "crystal"
sphere = "sio2"
medium = "water"
diameter_nm = 250
thickness_spread_nm = 3
base = { spectrum = "not_there.csv" }
tilt_deg = 5
polarisation = "p"
[material.scatter]
mechanism = "scatter"
model = "quasi_ordered"
particle = "air"
medium = "keratin"
radius_nm = 100
radius_spread = 0.1
polarisation = "both"
[material.measured]
mechanism = "measured"
file = "not_there.csv"
tilt_deg = 5
END
    local material
    for material in film stack tilted grating crystal scatter measured; do
        printf '[lut.%s]\nmaterial = "%s"\n' "$material" "$material"
    done
    printf '[swatch.film]\ndraw = "sphere"\nlut = "film"\n'
}

scene > plain.toml
{ scene 'tilt_deg = 0'; everything_else; } > every.toml

# counts SCENE: instructions of main, choose_lut and bake.
counts() {
    valgrind --tool=callgrind --toggle-collect=main --callgrind-out-file="$1.callgrind" "$nacre" bake "$1.toml" \
        -o "$1" --only line --only plane --no-preview --threads 1 --quiet > "$1.log" 2>&1 || { cat "$1.log" >&2; exit 3; }
    callgrind_annotate --inclusive=yes --threshold=100 "$1.callgrind" | awk '
        { count = $1; gsub(",", "", count) }
        function most(part) { if (count + 0 > total[part] + 0) total[part] = count }
        /:main \[/ { most("main") }
        /:nacre::choose_lut\(/ && !/lambda/ { most("choose") }
        /:nacre::bake\(/ && !/lambda/ { most("bake") }
        END { printf "%.0f %.0f %.0f\n", total["main"], total["choose"], total["bake"] }'
}

counts plain > plain.counts &
counts every > every.counts
wait $!
read -r -a plain < plain.counts
read -r -a every < every.counts
for lut in line plane; do
    cmp "plain/$lut.exr" "every/$lut.exr" || exit 1
done
status=0
parts=(main choose bake)
printf '%-8s %16s %16s %9s\n' instructions 'plain' 'could have all' growth
for i in 0 1 2; do
    if ((plain[i] == 0 || every[i] == 0)); then
        echo "${parts[i]} was not seen: is the program stripped?" >&2
        exit 3
    fi
    awk -v part="${parts[i]}" -v a="${plain[i]}" -v b="${every[i]}" \
        'BEGIN { printf "%-8s %20.0f %16.0f %8.3f %%\n", part, a, b, 100 * (b / a - 1) }'
    if (((every[i] - plain[i]) * 1000 > plain[i] * most_per_mille)); then status=1; fi
done
((status == 0)) || echo 'more than 1 %' >&2
exit "$status"
