#!/usr/bin/env bash
# tests/abi/description.sh — the committed description and what each binding is generated from it say what the public headers say,
# and a changed struct, constant or function passes in none of them.
set -euo pipefail
cd "$(dirname "$0")/../.."
scripts/describe --check
# What each binding is checked by: LuaJIT reads dragmesh_ffi.h itself, Unity has the files of C#, Blender those of Python.
everyone="description:dragmesh_api.json LuaJIT:dragmesh_ffi.h C++:cpp/dragmesh_check.hpp C#:csharp/DragMesh/Native.cs
Rust:rust/dragmesh-sys/src/generated.rs Python:python/dragmesh/native.py"
core="$everyone JavaScript:js/abi.js" # the module has no extensions
layout="$core C#:csharp/DragMesh/Layout.cs"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# rejected NAME SED_SCRIPT BINDINGS — the check of each of them must fail after this change of the headers.
rejected() {
    local binding
    rm -rf "$work/include"
    cp -r plugin_api/include "$work/include"
    sed -i "$2" "$work"/include/dragmesh/*.h "$work"/include/dragmesh/ext/*.h
    ! diff -rq plugin_api/include "$work/include" > /dev/null || { echo "description: \"$1\" changes nothing" >&2; exit 1; }
    ! scripts/describe --check "$work/include" 2> "$work/log" || { echo "description: \"$1\" passed" >&2; exit 1; }
    for binding in $3; do
        grep -q "bindings/${binding#*:} differs from the public headers" "$work/log" ||
            { echo "description: \"$1\" passed in ${binding%%:*}, bindings/${binding#*:}" >&2; cat "$work/log" >&2; exit 1; }
    done
    # The C++ binding is of the header itself: the compiler must notice.
    ! g++ -std=c++17 -fsyntax-only -I"$work/include" -x c++ bindings/cpp/dragmesh_check.hpp 2> "$work/log" ||
        { echo "description: g++ took \"$1\"" >&2; exit 1; }
    grep -q 'static assertion failed\|was not declared' "$work/log" || { cat "$work/log" >&2; exit 1; }
}
rejected "a field of another type" 's/^    float start_value;/    double start_value;/' "$layout"
rejected "a field more" 's/^    dm_vec3 grab_point; .*/&\n    float tenfold;/' "$layout"
rejected "another value" 's/DM_ERROR_TOO_LARGE = -17/DM_ERROR_TOO_LARGE = -71/' "$core"
rejected "a parameter of another type" 's/dm_model model, dm_object\* out_object/uint32_t model, dm_object* out_object/' "$core"
rejected "another result" 's/^DM_API uint32_t DM_CALL dm_version(void);/DM_API int32_t DM_CALL dm_version(void);/' "$core"
rejected "a function less" 's/^DM_API uint32_t DM_CALL dm_version(void);//' "$core"
rejected "a field of an extension" 's/^    uint32_t carrier;/    uint64_t carrier;/' "$everyone C#:csharp/DragMesh/Layout.cs"
rejected "another name of another function" 's/^#define dm_drag_override dm_drag_take/#define dm_drag_override dm_drag_step/' "$everyone"
