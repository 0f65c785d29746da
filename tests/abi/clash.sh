#!/usr/bin/env bash
# tests/abi/clash.sh BUILD_FOLDER — what a host exports changes nothing.
#
# 1. A host that exports every name that our libraries have inside (cJSON, meshoptimizer, Draco, the C++ runtime, our own)
#    and every function of Embree, each of which ends the process: the tool and the samples print what they print without.
# 2. A host that has cJSON of its own links the archive, and each calls its own.
# 3. Two copies and another version of the library in one process (tests/abi/clash/two_copies.c).
set -euo pipefail
folder=$(realpath "$1")
cd "$(dirname "$0")/../.."
cc=${CC:-gcc} work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
includes="-Iplugin_api/include -Isdk -Ithird_party -Itests/include"
flags="-std=gnu17 -O1 $includes"

# Names of all functions inside the libraries, and of those that they open; the C library's own are not a host's to export.
ldd "$folder/libdragmesh.so" | awk '$2 == "=>" { print $3 }' | xargs nm -D --defined-only | awk '{ sub(/@.*/, "", $3); print $3 }' |
    sort -u > "$work/system"
{
    nm "$folder"/libdragmesh.so "$folder"/libdragmesh_gltf.so | awk '$2 ~ /^[tTwW]$/ { print $3 }'
    sed -n 's/^    X(.*, \([A-Z][A-Za-z]*\), (.*/rtc\1/p' sdk/pick/embree_abi.h
    echo rtcIntersect1
    sed -n 's/^#define \(cJSON_[A-Za-z_]*\) .*/\1/p' third_party/cjson/cJSON.h
    printf '%s\n' stbi_write_png stbi_load_from_memory tinygltf_load
} | grep -vE '^(dm_.*|_init|_fini|_start|frame_dummy|(de)?register_tm_clones|__do_global_.*|__wrap_.*|.*\..*)$' |
    sort -u | comm -23 - "$work/system" > "$work/names"
for name in cJSON_ParseWithOpts rtcNewDevice rtcIntersect1 meshopt_decodeVertexBuffer __cxa_throw _Znwm; do
    grep -qx "$name" "$work/names" || { echo "clash: $name is not among the names" >&2; exit 1; }
done
{
    echo '.text'
    while read -r name; do printf '.globl "%s"\n.type "%s", @function\n"%s":\n' "$name" "$name" "$name"; done < "$work/names"
    echo '.byte 0x0f, 0x0b' # ud2: SIGILL
    echo '.section .note.GNU-stack,"",@progbits'
} > "$work/host.s"
"$cc" -shared -nostdlib "$work/host.s" -o "$work/libhost.so"

$cc $flags tests/abi/clash/write_props.c "$folder"/lib/libcjson.a "$folder"/lib/libmeshoptimizer.a -lstdc++ -lm -o "$work/write_props"
"$work/write_props" "$work"
same() { # COMMAND…
    "$@" > "$work/alone" 2>&1 || { cat "$work/alone" >&2; return 1; }
    LD_PRELOAD=$work/libhost.so "$@" > "$work/beside" 2>&1 || { echo "clash: $* ended with $?" >&2; cat "$work/beside" >&2; exit 1; }
    sed -i 's/[0-9.]* [mµn]*s\b//g' "$work/alone" "$work/beside" # times
    diff "$work/alone" "$work/beside" || exit 1
}
export DRAGMESH_MODELS=$PWD/sdk/models
for way in plain meshopt draco; do same "$folder/dragmesh" infer "$work/$way.glb" --moving door; done
same "$folder/samples/sample_hello_drag"
same "$folder/dragmesh" pick "$work/plain.glb" --ray 0,0.3,5,0,0,-1
same "$folder/samples/sample_host_pick"

echo 'void* cJSON_Parse(const char* t) { (void)t; __builtin_trap(); } int cJSON_Delete = 1; char cJSON_malloc[8], rtcNewDevice[8];' > "$work/own.c"
$cc -c "$work/own.c" -o "$work/own.o"
$cc $flags samples/01_hello_drag/main.c "$work/own.o" "$folder/lib/libdragmesh_core.a" -ldl -lm -o "$work/hello"
"$work/hello" > "$work/static"
"$folder/samples/sample_hello_drag" | cmp - "$work/static"

cp "$folder/libdragmesh.so" "$work/libcopy.so"
mkdir -p "$work/next/dragmesh"
sed 's/\(define DM_VERSION_MINOR\) .*/\1 9/' plugin_api/include/dragmesh/dragmesh.h > "$work/next/dragmesh/dragmesh.h"
version=$(grep -lw dm_version plugin_api/src/*.c)
for source in plugin_api/src/interface.c $version; do
    $cc -std=gnu17 -O1 -fPIC -DDM_BUILDING -fvisibility=hidden -I"$work/next" $includes -c "$source" -o "$work/$(basename "$source" .c).o"
done
$cc -shared -o "$work/libnext.so" "$work"/{interface,$(basename "$version" .c)}.o "$folder/lib/libdragmesh_core.a" -ldl -lm \
    -Wl,--version-script=plugin_api/dragmesh.map -Wl,-Bsymbolic
$cc $flags -rdynamic tests/abi/clash/two_copies.c "$folder/libdragmesh.so" -Wl,-rpath,"$folder" -ldl -o "$work/two_copies"
"$work/two_copies" "$work/libcopy.so" "$work/libnext.so"
"$work/two_copies" "$work/libnext.so" "$work/libcopy.so"
echo "clash: $(wc -l < "$work/names") names of the host's, its own cJSON and other copies change nothing"
