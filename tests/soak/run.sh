#!/usr/bin/env bash
# tests/soak/run.sh BUILD_FOLDER [SHARE] — compiles soak.c and lets it live; SHARE of the full numbers, 1 without it.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=$1 share=${2:-1}
${CC:-gcc} -std=gnu17 -O2 -Wall -Wextra -Wno-missing-field-initializers -Iplugin_api/include -Isamples/common tests/soak/soak.c \
    -o "$build/soak" -ldl
time "$build/soak" "./$build/libdragmesh.so" sdk/models "$share"
