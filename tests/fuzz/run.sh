#!/usr/bin/env bash
# tests/fuzz/run.sh FOLDER — runs every input of the archives in tests/fuzz/corpus, and a fixed number of mutations of them by
# a fixed seed, through the fuzz targets in FOLDER (build/asan/fuzz), as many at once as there are processors. It takes about
# two minutes of two processors. tests/fuzz/run_long.sh is for finding more.
set -euo pipefail
folder=$1
cd "$(dirname "$0")/../.."
export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1 UBSAN_OPTIONS=print_stacktrace=1
# Mutations: as many as a target does in some seconds. A target without a line here is a mistake.
mutations="
fuzz_api 80
fuzz_compressed 20000
fuzz_dmo 6000
fuzz_gltf 20000
fuzz_jobs 150
fuzz_mask 200000
fuzz_mesh 150
fuzz_model 30
fuzz_snapshot 6000
fuzz_weights 50000
fuzz_words 600
"
run() {
    local target=$1 count=$2
    if "$folder/$target" -n "$count" "build/fuzz/corpus/$target" > "$work/$target" 2>&1; then
        echo "$target: $(tail -n 1 "$work/$target")"
    else
        cat "$work/$target"
        echo "$target FAILED"
        return 1
    fi
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
diff <(basename -s .c tests/fuzz/fuzz_*.c | sort) <(awk 'NF { print $1 }' <<< "$mutations" | sort)
tests/fuzz/corpus.sh unpack
export -f run
export folder work
awk 'NF { print $1, $2 }' <<< "$mutations" | xargs -P "$(nproc)" -L 1 bash -c 'run "$@"' run
