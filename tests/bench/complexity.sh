#!/usr/bin/env bash
# tests/bench/complexity.sh [FAMILY…] — counts with callgrind the instructions of each family of bench_complexity at a
# size and at twice that size. Fails where the second count is more than 2.6 times the first: work that grows with the
# square of its input takes 4 times as many, n log n at most 2.3 times.
set -euo pipefail
cd "$(dirname "$0")/../.."
export program=$PWD/build/release/bench/bench_complexity most=2.6
scratch=$(mktemp -d)
export scratch
trap 'rm -rf "$scratch"' EXIT

count() {
    local family=$1
    valgrind --tool=callgrind --callgrind-out-file="$scratch/$family" --toggle-collect='counted_*' \
        "$program" "$family" > "$scratch/$family.log" 2>&1 || { cat "$scratch/$family.log"; return 1; }
    callgrind_annotate --inclusive=yes --threshold=100 --auto=no "$scratch/$family" | tr -d , |
        awk -v family="$family" -v most="$most" '
            /counted_once/  { once = $1 }
            /counted_twice/ { twice = $1 }
            END { if (once == 0 || twice == 0) { print family " was not counted"; exit 1 }
                  bad = twice > most * once
                  printf "%-20s %12.0f %12.0f %6.2f%s\n", family, once, twice, twice / once, bad ? "  <- over " most : ""
                  exit bad }'
}
export -f count
families=${*:-$("$program")}
printf '%s\n' $families | xargs -P "$(nproc)" -I{} bash -c 'count {}'
