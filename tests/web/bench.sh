#!/usr/bin/env bash
# tests/web/bench.sh [BUILD_FOLDER] — times the module in node against the native library in the same run; fails where a budget is missed.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/release}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
gcc -std=gnu17 -O2 -Wall -Wextra -Iplugin_api/include -Isamples/common tests/web/bench.c -o "$work/native" -L"$build" -ldragmesh -Wl,-rpath,"$PWD/$build"
node tests/web/bench.mjs "$work/native" "$work/cabinet.mesh"
