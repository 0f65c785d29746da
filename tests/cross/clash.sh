#!/usr/bin/env bash
# tests/cross/clash.sh — tests/abi/clash.sh under wine: what a host exports changes nothing. Needs build/windows
# (tests/cross/run.sh).
#
# 1. A host that exports every name that dragmesh.dll has inside, and every function of Embree, each of which ends the
#    process: sample 01 prints what it prints without.
# 2. A host that has cJSON of its own links the archive, and each calls its own.
# 3. Two copies and another version of the DLL in one process (tests/abi/clash/two_copies.c).
set -euo pipefail
cd "$(dirname "$0")/../.."
built=$PWD/build/windows
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export WINEPREFIX=$built/wine WINEDEBUG=-all WINEDLLOVERRIDES="mscoree,mshtml,winemenubuilder.exe="
cc=x86_64-w64-mingw32-gcc
includes="-Iplugin_api/include -Isdk -Ithird_party -Itests/include"
flags="-std=gnu17 -O1 -static-libgcc $includes"
hello=samples/01_hello_drag/main.c

cp "$built/dragmesh.dll" "$work"
$cc $flags $hello "$built/libdragmesh.a" -o "$work/plain.exe"
run() { wine "$work/$1.exe" "${@:2}" | tr -d '\r'; }
run plain sdk/models > "$work/plain.txt"
grep -q '^hinge' "$work/plain.txt"

# 1
{
    x86_64-w64-mingw32-nm "$built"/lib/*.a 2> /dev/null | awk '$2 == "T" && $3 !~ /^(dm_|\.)/ { print $3 }'
    sed -n 's/^    X(.*, \([A-Z][A-Za-z]*\), (.*/rtc\1/p' sdk/pick/embree_abi.h
    echo rtcIntersect1
    sed -n 's/^#define \(cJSON_[A-Za-z_]*\) .*/\1/p' third_party/cjson/cJSON.h
} | sort -u > "$work/names"
for name in cJSON_ParseWithOpts rtcNewDevice rtcIntersect1 meshopt_decodeVertexBuffer dmi_alloc; do
    grep -qx "$name" "$work/names" || { echo "clash: $name is not among the names" >&2; exit 1; }
done
{
    echo '.text'
    while read -r name; do printf '.globl "%s"\n.def "%s"; .scl 2; .type 32; .endef\n"%s":\n' "$name" "$name" "$name"; done < "$work/names"
    echo '.byte 0x0f, 0x0b' # ud2
} > "$work/host.s"
{ echo EXPORTS; sed 's/.*/    "&"/' "$work/names"; } > "$work/host.def"
$cc $flags $hello "$work/host.s" "$work/host.def" "$built/libdragmesh.a" -o "$work/exports.exe"
x86_64-w64-mingw32-objdump -p "$work/exports.exe" > "$work/headers"
grep -q ' rtcIntersect1$' "$work/headers"
run exports sdk/models | cmp - "$work/plain.txt"

# 2
echo 'void* cJSON_Parse(const char* t) { (void)t; __builtin_trap(); } int cJSON_Delete = 1; char cJSON_malloc[8], rtcNewDevice[8];' > "$work/own.c"
$cc $flags -DDM_STATIC $hello "$work/own.c" "$built/lib/libdragmesh_core.a" -o "$work/own.exe"
run own sdk/models | cmp - "$work/plain.txt"

# 3
cp "$built/dragmesh.dll" "$work/copy.dll"
mkdir -p "$work/next/dragmesh"
sed 's/\(define DM_VERSION_MINOR\) .*/\1 9/' plugin_api/include/dragmesh/dragmesh.h > "$work/next/dragmesh/dragmesh.h"
version=$(grep -lw dm_version plugin_api/src/*.c)
$cc -DDM_BUILDING -I"$work/next" $flags -shared plugin_api/src/interface.c $version "$built/lib/libdragmesh_core.a" -o "$work/next.dll"
$cc $flags tests/abi/clash/two_copies.c "$built/libdragmesh.a" -o "$work/two_copies.exe"
run two_copies copy.dll next.dll
run two_copies next.dll copy.dll
echo "clash: $(wc -l < "$work/names") names of the host's, its own cJSON and other copies change nothing under wine"
