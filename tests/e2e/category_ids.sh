#!/usr/bin/env bash
# tests/e2e/category_ids.sh — checks that a kind added to training/generator/categories.h, at any place, changes nothing else:
# all other kinds keep their objects, splits and sets to the bit, and training cases drawn from them stay the same; nor does
# the order of rows matter. Checks too that no id was given to another kind: tests/e2e/category_ids.txt has every id that was ever
# given, and marks those of kinds that are no more as retired. Needs a release build; takes about 20 s on one core.
set -euo pipefail
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
table=training/generator/categories.h lib=build/release/lib
flags="-std=gnu17 -O1 -ffp-contract=off -fno-math-errno -fno-trapping-math -Iplugin_api/include -Isdk -Itraining/generator -Itraining/lab -Itests/include -Ithird_party"
grep -o '^ *X([a-z0-9_]*, [0-9][0-9]*, [A-Z_]*)' $table | tr -d ' ' > "$work/rows"
next=$(($(cut -d' ' -f2 tests/e2e/category_ids.txt | sort -n | tail -1) + 1))

# hashes NAME: what a generator says whose table has the rows on standard input.
hashes() {
    mkdir "$work/$1"
    {
        sed '/^#define DMG_CATEGORIES(X)/,$d' $table
        sed '1i #define DMG_CATEGORIES(X)' | sed '$!s/$/ \\/'
        echo
        sed -n '/^#define DMG_DECLARE/,$p' $table
    } > "$work/$1/categories.h"
    cp training/generator/generator.c "$work/$1"
    # The library's own generator.o stays out: what it defines is there already.
    gcc $flags -I"$work/$1" "$work/$1/generator.c" "$work"/*.o $lib/libdragmesh_generator.a $lib/libdragmesh_core.a \
        -ldl -lm -o "$work/$1/hashes"
    "$work/$1/hashes" "$next" | sort > "$work/$1/all"
    grep -v '^kind added_kind ' "$work/$1/all" > "$work/$1/others"
}

for source in tests/e2e/category_hashes.c training/lab/{case,random,augment_case}.c; do
    gcc $flags -c "$source" -o "$work/$(basename "$source" .c).o"
done
half=$(($(wc -l < "$work/rows") / 2))
hashes today < "$work/rows"
{ echo "X(added_kind,$next,TRAINED)"; cat "$work/rows"; } | hashes first
sed "${half}a X(added_kind,$((next + 1000)),TEST_ONLY)" "$work/rows" | hashes middle
{ tac "$work/rows"; echo "X(added_kind,$next,TEST_ONLY)"; } | hashes last_of_reversed
for name in first middle last_of_reversed; do
    [ "$(grep -c '^kind added_kind ' "$work/$name/all")" = 1 ]
    cmp "$work/today/all" "$work/$name/others" || { echo "category ids: another kind changed in table '$name'" >&2; exit 1; }
done
grep '^kind ' "$work/today/all" | cut -d' ' -f2,3 | sort > "$work/ids"
grep -v retired tests/e2e/category_ids.txt | sort > "$work/given"
gone=$(comm -23 "$work/given" "$work/ids")
[ -z "$gone" ] || { echo "category ids: these changed or went: $gone" >&2; exit 1; }
again=$(grep retired tests/e2e/category_ids.txt | cut -d' ' -f2 | sort | comm -12 - <(cut -d' ' -f2 "$work/ids" | sort))
[ -z "$again" ] || { echo "category ids: these are retired: $again" >&2; exit 1; }
echo "category ids: $(wc -l < "$work/ids") kinds keep their objects, splits and sets whatever is added"
