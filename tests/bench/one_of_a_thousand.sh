#!/usr/bin/env bash
# `--only` on one LUT of a thousand costs as much as a scene of that one: instructions under valgrind's callgrind, from
# main() on, and processor time, the best of five. The others are stacks of uneven layers, spheres, crystals, bases, and
# spectra out of files that do not exist; nobody asks for them. What does grow is the reading of their text as TOML. For
# the rest (seeing their names, and forgetting them) each may take 10 000 instructions: reading one material's file
# takes some ninety times that, and deciding on a LUT of one film three thousand times. Exit 1 if it is more, or if a
# byte of the LUT differs.
#
#   tests/bench/one_of_a_thousand.sh NACRE [N]        default: 1000
set -euo pipefail
nacre=$(readlink -f -- "${1:?which program?}")
luts=${2:-1000}
most_per_lut=10000
for tool in valgrind callgrind_annotate; do
    command -v "$tool" > /dev/null || { echo "$tool is missing: apt-get install valgrind" >&2; exit 3; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

one() {
    cat <<'END'
nacre = 1
[material.wanted]
mechanism = "film"
index = "chitin"
thickness_nm = 300
substrate = 1.5
[lut.wanted]
material = "wanted"
size = 256
END
}
# others COUNT: each a material and its LUT.
others() {
    awk -v count="$1" 'BEGIN {
        kind[0] = "mechanism = \"stack\"\nform = \"lamellae\"\nfilm = \"cuticle\"\nfilm_nm = 94\ngap_nm = 83\nfilms = 8\nthickness_spread_nm = 10"
        kind[1] = "mechanism = \"measured\"\nfile = \"not_there.csv\"\ntilt_deg = 5"
        kind[2] = "mechanism = \"film\"\nindex = \"not_there.yml\"\nthickness_nm = 300\nbase = { spectrum = \"not_there.csv\" }"
        kind[3] = "mechanism = \"scatter\"\nmodel = \"mie\"\nparticle = \"tio2\"\nradius_nm = 2e4\nradius_spread = 0.2"
        kind[4] = "mechanism = \"crystal\"\nsphere = \"not_there.yml\"\ndiameter_nm = 250\nthickness_spread_nm = 3\ntilt_deg = 8"
        for (i = 1; i <= count; ++i)
            printf "[material.m%d]\n%s\n[lut.m%d]\nmaterial = \"m%d\"\n", i, kind[i % 5], i, i
    }'
}
one > one.toml
{ others "$((luts - 1))"; one | sed 1d; } > many.toml  # the last one, so that all have been passed

# counts SCENE: instructions of main, of reading the scene's text, of planning, of choosing LUTs.
counts() {
    valgrind --tool=callgrind --toggle-collect=main --callgrind-out-file="$1.callgrind" "$nacre" bake "$1.toml" \
        -o "$1" --only wanted --no-preview --threads 1 --quiet > "$1.log" 2>&1 || { cat "$1.log" >&2; exit 3; }
    callgrind_annotate --inclusive=yes --threshold=100 "$1.callgrind" | awk '
        { count = $1; gsub(",", "", count) }
        function most(part) { if (count + 0 > total[part] + 0) total[part] = count }
        /:main \[/ { most("main") }
        /:nacre::read_scene_file\(/ && !/lambda/ { most("text") }
        /:nacre::plan_scene\(/ && !/lambda/ { most("plan") }
        /:nacre::choose_lut\(/ && !/lambda/ { most("choose") }
        END { printf "%.0f %.0f %.0f %.0f\n", total["main"], total["text"], total["plan"], total["choose"] }'
}

counts one > one.counts &
counts many > many.counts
wait $!
cmp one/wanted.exr many/wanted.exr || exit 1
read -r one_main one_text one_plan one_choose < one.counts
read -r many_main many_text many_plan many_choose < many.counts
if ((one_text == 0 || many_text == 0)); then
    echo 'read_scene_file was not seen: is the program stripped?' >&2
    exit 3
fi
row() {
    awk -v what="$1" -v a="$2" -v b="$3" 'BEGIN { printf "%-24s %14.0f %14.0f %9.3f\n", what, a, b, (a > 0 ? b / a : 0) }'
}
printf '%-24s %14s %14s %9s\n' instructions 'a scene of one' "one of $luts" ratio
row 'in all' "$one_main" "$many_main"
row '  reading its text' "$one_text" "$many_text"
row '  all but that' $((one_main - one_text)) $((many_main - many_text))
row '    planning' "$one_plan" "$many_plan"
row '    choosing LUTs' "$one_choose" "$many_choose"
per_lut=$(((many_main - many_text - one_main + one_text) / (luts - 1)))
printf 'of each that is not asked for: reading %d instructions, all the rest %d\n' \
    $(((many_text - one_text) / (luts - 1))) "$per_lut"

# best SCENE: milliseconds of the processor, linking and all.
best() {
    local least=999999999 took
    TIMEFORMAT='%U %S'
    for _ in 1 2 3 4 5; do
        took=$({ time "$nacre" bake "$1.toml" -o "$1" --only wanted --no-preview --threads 1 --force --quiet; } 2>&1 |
            awk '{ printf "%.0f", 1000 * ($1 + $2) }')
        if ((took < least)); then least=$took; fi
    done
    echo "$least"
}
printf 'processor time: %s ms alone, %s ms of %s\n' "$(best one)" "$(best many)" "$luts"
if ((per_lut > most_per_lut)); then
    echo "more than $most_per_lut" >&2
    exit 1
fi
