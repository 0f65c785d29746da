#!/usr/bin/env bash
# tests/bench/instructions.sh [--update] — how many instructions each call of a frame takes, counted by callgrind, must
# be within 5 % of tests/bench/instructions.txt. Times depend on the machine and what else it does; counts do not.
# Valgrind shows every machine as one with AVX2 at most, so that the same kernels are counted everywhere. Counts are of
# one compiler: another one (or a machine without AVX2) skips the check.
set -euo pipefail
cd "$(dirname "$0")/../.."
file=tests/bench/instructions.txt rounds=20
grep -qw avx2 /proc/cpuinfo || { echo "no AVX2 here: skipped"; exit 0; }
compiler="gcc $(gcc -dumpversion), $(getconf GNU_LIBC_VERSION)"
if [ "${1:-}" != --update ] && ! grep -qxF "# $compiler" "$file"; then
    echo "counted for another compiler, not for $compiler: skipped"
    exit 0
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
valgrind --tool=callgrind --callgrind-out-file="$scratch/out" --toggle-collect='frame_*' \
    build/release/bench/bench_frame $rounds > "$scratch/log" 2>&1 || { cat "$scratch/log" >&2; exit 1; }
callgrind_annotate --inclusive=yes --threshold=100 --auto=no "$scratch/out" |
    sed -nE 's/^ *([0-9,]+) .*bench_frame\.c:frame_([a-z_]+).*/\2 \1/p' | tr -d , |
    awk -v rounds=$rounds '{ printf "%s %d\n", $1, $2 / rounds }' | sort > "$scratch/counts"
[ "$(wc -l < "$scratch/counts")" -gt 5 ] || { echo "found too few counts:"; cat "$scratch/counts"; exit 1; }
if [ "${1:-}" = --update ]; then
    { echo "# $compiler"; cat "$scratch/counts"; } > "$file"
    cat "$file"
    exit 0
fi
awk 'NR == FNR { if ($1 != "#") wanted[$1] = $2; next }
    { change = $1 in wanted ? 100 * ($2 / wanted[$1] - 1) : 999; seen[$1] = 1; bad = change > 5 || change < -5
      printf "%-24s %9d %9d %+6.1f %%%s\n", $1, wanted[$1], $2, change, bad ? "  <- outside 5 %" : ""; worst += bad }
    END { for (name in wanted) if (!(name in seen)) { print name " was not counted"; worst++ }
          if (worst) print "Faster or slower on purpose? tests/bench/instructions.sh --update"; exit worst > 0 }' \
    "$file" "$scratch/counts"
