#!/usr/bin/env bash
# Peak memory of ten thousand different layers at 256 angles and 401 wavelengths, beside the same program with one film.
# Exit 1 if they take more than 64 MB.
#
#   tests/bench/layer_memory.sh NACRE_BENCH
set -euo pipefail
bench=${1:?which nacre_bench?}
most_more_kilobytes=65536

# peak BENCHMARK: kilobytes, as the kernel has them while the program runs.
peak() {
    local most=0 now
    "$bench" "--benchmark_filter=^$1" > /dev/null 2>&1 &
    while now=$(awk '/^VmHWM:/ { print $2 }' "/proc/$!/status" 2> /dev/null) && [[ -n $now ]]; do
        most=$now
        sleep 0.02
    done
    wait $!
    echo "$most"
}

idle=$(peak spectra_1_film)
layers=$(peak ten_thousand_different)
more=$((layers - idle))
printf '10000 layers: peak %d MB, %d MB more than one film (%d MB)\n' $((layers / 1024)) $((more / 1024)) $((idle / 1024))
if ((more > most_more_kilobytes)); then
    echo "more than $((most_more_kilobytes / 1024)) MB" >&2
    exit 1
fi
