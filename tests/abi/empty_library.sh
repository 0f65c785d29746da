#!/usr/bin/env bash
# tests/abi/empty_library.sh INCLUDE LIBRARY OUT — builds a library of empty functions from the public headers in INCLUDE, under
# the name that LIBRARY has for the linker. Its debugging information has every type of the headers, whatever a build of the
# library leaves out.
set -euo pipefail
include=$1 library=$2 out=$3
soname=$(readelf -d "$library" | sed -n 's/.*(SONAME).*\[\(.*\)\]/\1/p')
${CC:-gcc} -std=c17 -g -w -shared -fPIC -fvisibility=hidden -DDM_BUILDING "-Wl,-soname,$soname" -I"$include" -x c - -o "$out" << END
#include "dragmesh/dragmesh.h"
#define EMPTY(result, name, arguments) result DM_CALL dm_##name arguments { __builtin_trap(); }
DM_CORE_FUNCTIONS(EMPTY)
const void* DM_CALL dm_get_interface(const char* id) { (void)id; __builtin_trap(); }
END
