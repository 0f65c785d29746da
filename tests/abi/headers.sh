#!/usr/bin/env bash
# tests/abi/headers.sh — every public header compiles alone as C11, C17, C++11, C++17 and C++20, with gcc and clang, all
# warnings on. No struct that grows ends with padding on any machine: a new field would get an old caller's garbage there.
set -euo pipefail
cd "$(dirname "$0")/../.."
flags="-Wall -Wextra -Wpedantic -Wconversion -Werror -fsyntax-only -Iplugin_api/include"
failed=0
for header in plugin_api/include/dragmesh/*.h plugin_api/include/dragmesh/ext/*.h; do
    name=${header#plugin_api/include/}
    for compiler in gcc clang; do
        for standard in c11 c17 c++11 c++17 c++20; do
            language=c
            [ "${standard#c++}" = "$standard" ] || language=c++
            printf '#include "%s"\n#include "%s"\n' "$name" "$name" |
                "$compiler" -x $language -std=$standard $flags - || { echo "$name: $compiler -std=$standard" >&2; failed=1; }
        done
    done
done
for target in x86_64-linux-gnu aarch64-linux-gnu armv7a-linux-gnueabihf i386-linux-gnu x86_64-windows-gnu wasm32; do
    padded=$(clang --target=$target -std=c17 -ffreestanding -Wpadded -fsyntax-only -Iplugin_api/include -x c \
        plugin_api/include/dragmesh/dragmesh.h 2>&1 | grep 'padding size of' || true)
    [ -z "$padded" ] || { echo "on $target: $padded" >&2; failed=1; }
done
exit $failed
