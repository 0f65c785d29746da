#!/usr/bin/env bash
# tests/e2e/compilers.sh — gcc and clang make the same objects of every kind: no two random numbers are drawn in an order
# that C leaves open. (Rounding may differ in the last bit.)
set -euo pipefail
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
flags="-std=c17 -D_GNU_SOURCE -O1 -Iplugin_api/include -Isdk -Itraining/generator"
for compiler in gcc clang; do
    mkdir "$work/$compiler"
    find training/generator sdk/base tests/e2e/generated_sums.c -name '*.c' -print0 |
        xargs -0 -P "$(nproc)" -I{} sh -c "$compiler $flags -c {} -o $work/$compiler/\$(basename {} .c).o"
    "$compiler" "$work/$compiler"/*.o -lm -o "$work/$compiler/sums"
    "$work/$compiler/sums" > "$work/$compiler.txt"
done
[ -s "$work/gcc.txt" ]
diff "$work/gcc.txt" "$work/clang.txt"
echo "gcc and clang: the same objects of $(wc -l < "$work/gcc.txt") kinds"
