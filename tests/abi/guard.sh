#!/usr/bin/env bash
# tests/abi/guard.sh BUILD_FOLDER — the library keeps what each frozen version (tests/abi/frozen/VERSION, made by
# `scripts/describe --freeze`) has promised:
#
# 1. abidiff finds no change of a frozen version's functions and types but additions. A struct that has grown at its end is
#    named in tests/abi/grown.txt; where its old fields lie, the layout table says.
# 2. Every line of the frozen layout table still holds.
# 3. Programs: one of then, with the header of then; today's, with today's header; and one of a later version, whose structs
#    have fields that the library does not know. All three print the same.
# 4. Each .dmo of tests/abi/corpus is read as it was: the numbers beside it.
# 5. The weights of then are here, and load.
#
# Without any frozen version, what would be frozen now stands for it. Changed headers show that 1 and 2 notice.
set -euo pipefail
build=$(realpath "$1")
cd "$(dirname "$0")/../.."
header=dragmesh/dragmesh.h cc=${CC:-gcc}
later_fields=4
same_numbers=1e-6 # relative; what a reader may do otherwise than the version that wrote a file
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
complain() {
    echo "guard: $*" >&2
    failed=1
}

frozen=(tests/abi/frozen/*/)
if [ ! -d "${frozen[0]}" ]; then
    scripts/describe --freeze "$work/frozen" "$build" > /dev/null
    frozen=("$work/frozen/")
fi

# ---- 1 and 2: types, functions, layout ----

sized=$(sed -n '/define DM_SIZED_STRUCTS/,/[^\\]$/s/^ *X(\(dm_[a-z_0-9]*\)).*/\1/p' plugin_api/include/$header)
grown=$(grep -v '^#' tests/abi/grown.txt || true)
for name in $grown; do grep -qx "${name%.*}" <<< "$sized" || complain "grown.txt: $name may not grow"; done
{
    for name in $grown; do [[ $name = *.* ]] || printf '[suppress_type]\ntype_kind = struct\nname = %s\nhas_data_member_inserted_at = end\nhas_size_change = yes\n' "$name"; done
    printf '[suppress_type]\nname = dm_context\n' # callers know a pointer to it alone
} > "$work/allowed.ini"

# interface_differs FROZEN LIBRARY — prints what has changed.
interface_differs() {
    local rc=0
    abidiff --no-added-syms --suppressions "$work/allowed.ini" "$1/libdragmesh.abi" "$2" > "$work/abidiff.txt" 2>&1 || rc=$?
    [ $rc != 0 ] && cat "$work/abidiff.txt"
}

# layout_differs FROZEN TABLE — lines of the frozen table that TABLE lacks, sizes of grown structs and fields left out.
layout_differs() {
    local fields
    fields=$(grep -F . <<< "${grown:-}" | sed 's/\./\\./' | paste -sd'|' || true)
    local unsized="s/^(${fields:-none}) at ([0-9]+), [0-9]+ bytes/\1 at \2/"
    comm -23 <(sed -E "$unsized" "$1/lp64.txt" | sort) <(sed -E "$unsized" "$2" | sort) | grep -vxE "($(paste -sd'|' <<< "${grown:-none}")) [0-9]+ bytes"
}

for version in "${frozen[@]}"; do
    ! interface_differs "$version" "$build/libdragmesh.so" || complain "the library is not that of $version any more"
    ! layout_differs "$version" tests/abi/golden/lp64.txt || complain "the layout is not that of $version any more"
done

newest=${frozen[-1]}
# with_headers NAME SED_SCRIPT — builds an empty library with headers changed so; it stands for one that was built with them.
with_headers() {
    rm -rf "$work/include"
    cp -r "$newest/include" "$work/include"
    sed -i "$2" "$work/include/$header"
    tests/abi/empty_library.sh "$work/include" "$build/libdragmesh.so" "$work/empty.so"
}
with_headers unchanged ''
! interface_differs "$newest" "$work/empty.so" || complain "an unchanged header counts as changed"
with_headers more 's/^    X(uint32_t, version,/    X(uint32_t, version_of_more, (void)) &/; s/^DM_API uint32_t DM_CALL dm_version(void);/DM_API uint32_t DM_CALL dm_version_of_more(void); &/'
! interface_differs "$newest" "$work/empty.so" || complain "a new function counts as a change"
noticed=0
notice() {
    with_headers "$@"
    ! cmp -s "$newest/include/$header" "$work/include/$header" || complain "\"$1\" changes nothing"
    interface_differs "$newest" "$work/empty.so" > /dev/null || complain "\"$1\" was not noticed"
    noticed=$((noticed + 1))
}
notice "a frozen struct that grows" 's/^} dm_link;/    float later;\n&/'
notice "a struct that grows and is not in grown.txt" 's/^} dm_camera;/    float later;\n&/'
notice "a field of another type" 's/^    float fov_y;/    int32_t fov_y;/'
notice "two fields swapped" 's/^    float x, y, z;/    float y, x, z;/'
notice "a callback with one more argument" 's/(DM_CALL\* dm_progress_callback)(void\* user,/& int32_t more,/'
notice "a function less" 's/^DM_API uint32_t DM_CALL dm_version(void);//; s/^    X(uint32_t, version, (void))/   /'
sed 's/^\(dm_camera.eye at \)[0-9]*/\10/' tests/abi/golden/lp64.txt > "$work/moved.txt"
layout_differs "$newest" "$work/moved.txt" > /dev/null || complain "a field that has moved was not noticed"
noticed=$((noticed + 1))

# ---- 3: programs of then, of now and of later ----

weights=sdk/models
# run_caller NAME SOURCES INCLUDE FLAG… — builds a host with a header and runs it with the library at hand.
run_caller() {
    local name=$1 sources=$2 include=$3
    shift 3
    $cc -std=c17 -O1 -w "$@" -I"$include" -I"$sources" "$sources/caller.c" -o "$work/$name" -L"$build" -ldragmesh -lpthread \
        "-Wl,-rpath,$build"
    "$work/$name" "$weights" > "$work/$name.txt" 2> "$work/log" || { complain "the program of $name failed"; cat "$work/log" >&2; }
}
mkdir "$work/sources"
cp tests/abi/caller.c samples/common/{cabinet,weights}.h "$work/sources"
run_caller now "$work/sources" plugin_api/include
for version in "${frozen[@]}"; do
    run_caller then "$version/host" "$version/include"
    cmp "$work/then.txt" "$work/now.txt" || complain "a program of $version gets other answers"
done
cp -r plugin_api/include "$work/headers_later"
for name in $sized; do # a part's state ends with its joint, and grows with it
    [ "$name" = dm_part_state ] || sed -i "s/^} $name;/    uint32_t later[$later_fields];\n&/" "$work/headers_later/$header"
done
[ "$(grep -c '^    uint32_t later' "$work/headers_later/$header")" = $(($(wc -w <<< "$sized") - 1)) ] || complain "not every struct has grown"
run_caller later "$work/sources" "$work/headers_later" -DCALLER_LATER=$later_fields
cmp "$work/later.txt" "$work/now.txt" || complain "a program of a later version gets other answers"

# ---- 4: prepared objects of every version ----

objects=0
for file in tests/abi/corpus/*.dmo; do
    "$work/now" --read "$file" > "$work/read.txt" || complain "$file is not read any more"
    /usr/bin/python3 tests/cross/compare.py $same_numbers "${file%.dmo}.txt" "$work/read.txt" > "$work/log" ||
        { complain "$file is read as another object"; cat "$work/log" >&2; }
    objects=$((objects + 1))
done

# ---- 5: weights ----

for version in "${frozen[@]}"; do
    mkdir -p "$work/weights"
    while read -r hash name rest; do
        for file in "$weights/$name" "$version/weights/$name"; do
            [ ! -e "$file" ] || [ "$(sha256sum < "$file" | cut -d' ' -f1)" != "$hash" ] || cp "$file" "$work/weights/$name"
        done
        [ -e "$work/weights/$name" ] ||
            complain "$name of $version ($rest) has changed: keep the old one in ${version}weights, from git's history"
    done < "$version/weights.txt"
    "$work/now" "$work/weights" > /dev/null || complain "weights of $version do not load"
done

[ $failed != 0 ] || echo "guard: ${#frozen[@]} frozen, $noticed changes noticed, programs of then, now and later print the same $(wc -l < "$work/now.txt") lines, $objects old objects read"
exit $failed
