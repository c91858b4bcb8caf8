#!/usr/bin/env bash
# Peak memory of ten thousand different layers at 256 angles and 401 wavelengths, beside the same program with one film.
# Exit 1 if they take more than 64 MB.
#
#   tests/bench/layer_memory.sh NACRE_BENCH
set -euo pipefail
bench=${1:?which nacre_bench?}
most_more_kilobytes=65536

# peak BENCHMARK: kilobytes. Python, because time(1) is not installed everywhere.
peak() {
    python3 - "$bench" "--benchmark_filter=^$1" << 'END'
import os, sys
child = os.fork()
if child == 0:
    nothing = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nothing, 1)
    os.dup2(nothing, 2)
    os.execv(sys.argv[1], sys.argv[1:])
_, status, usage = os.wait4(child, 0)
if status != 0:
    sys.exit(f"layer_memory.sh: {sys.argv[1]} ended with status {status}")
print(usage.ru_maxrss)
END
}

idle=$(peak spectra_1_film)
layers=$(peak ten_thousand_different)
more=$((layers - idle))
printf '10000 layers: peak %d MB, %d MB more than one film (%d MB)\n' $((layers / 1024)) $((more / 1024)) $((idle / 1024))
if ((more > most_more_kilobytes)); then
    echo "more than $((most_more_kilobytes / 1024)) MB" >&2
    exit 1
fi
