#!/usr/bin/env bash
# tests/abi/symbols.sh BUILD_FOLDER — the shared libraries export what they promise and nothing else, and the core calls
# nothing that a library must not: no thread, no print, no exit; the archive for static linking keeps to its own names.
set -euo pipefail
folder=$1
cd "$(dirname "$0")/../.."
failed=0 major=$(sed -n "s/^#define DM_VERSION_MAJOR //p" plugin_api/include/dragmesh/dragmesh.h)

complain() {
    printf '%s\n' "$@" >&2
    failed=1
}

exported() {
    nm -D --defined-only "$1" | awk '{ print $NF }' | sort
}

# libdragmesh.so: every function of dragmesh.h, and each of them in the version script.
promised=$( (echo dm_get_interface && sed -n 's/^ *X([^,]*, \([a-z_]*\),.*/dm_\1/p' plugin_api/include/dragmesh/dragmesh.h) | sort)
listed=$(sed -n 's/^ *\(dm_[a-z_]*\);$/\1/p' plugin_api/dragmesh.map | sort)
actual=$(exported "$folder/libdragmesh.so")
[ "$promised" = "$listed" ] ||
    complain "plugin_api/dragmesh.map (>) is not DM_CORE_FUNCTIONS (<):" "$(diff <(echo "$promised") <(echo "$listed"))"
[ "$promised" = "$actual" ] ||
    complain "the exports of libdragmesh.so (>) are not DM_CORE_FUNCTIONS (<):" "$(diff <(echo "$promised") <(echo "$actual"))"

# libdragmesh_gltf.so: dm_gltf_* alone, so that no C++ leaks out.
actual=$(exported "$folder/libdragmesh_gltf.so")
[ -n "$actual" ] || complain "libdragmesh_gltf.so exports nothing"
others=$(echo "$actual" | grep -v '^dm_gltf_' || true)
[ -z "$others" ] || complain "libdragmesh_gltf.so also exports:" "$others"

# What they need at run time: the C library alone. Embree is opened by name.
for library in libdragmesh libdragmesh_gltf; do
    needed=$(readelf -d "$folder/$library.so" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' |
        grep -vxE 'lib(c|m|dl)\.so\.[0-9]+|ld-linux.*' || true)
    [ -z "$needed" ] || complain "$library.so needs:" "$needed"
    name=$(readelf -d "$folder/$library.so" | sed -n 's/.*(SONAME).*\[\(.*\)\]/\1/p')
    [ "$name" = "$library.so.$major" ] || complain "$library.so calls itself $name"
done

# The archive for static linking: no name that the host or another library could have too.
others=$(nm --extern-only --defined-only "$folder/lib/libdragmesh_core.a" | awk 'NF == 3 { print $3 }' | grep -v '^dmi\?_' || true)
[ -z "$others" ] || complain "libdragmesh_core.a also defines:" "$others"

calls=$(nm -A --undefined-only "$folder/lib/libdragmesh_core.a" |
    grep -E ' (pthread_create|thrd_create|printf|fprintf|puts|putchar|abort|exit|_exit|fork|system)$' || true)
[ -z "$calls" ] || complain "the core must not call:" "$calls"

# Every C library rounds these in its own way: sdk/math/elementary.h has them with the same bits everywhere.
calls=$(nm -A --undefined-only "$folder/lib/libdragmesh_core.a" |
    grep -E ' (exp2?|log|log2|log10|pow|sin|cos|sincos|tan|asin|acos|atan|atan2|hypot|fmax|fmin)f?$' || true)
[ -z "$calls" ] || complain "the core must compute by sdk/math/elementary.h, not by:" "$calls"
exit $failed
