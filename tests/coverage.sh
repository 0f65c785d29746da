#!/usr/bin/env bash
# tests/coverage.sh [list] — the share of the lines of plugin_api and sdk that the tests run, by gcov: those of tests/unit,
# golden and abi, and the tool's. Fails below 92 %. `list` writes tests/uncovered.txt anew, with the reasons that it has. Takes
# build/debug, and leaves it so compiled.
set -euo pipefail
cd "$(dirname "$0")/.."
least=92
export CFLAGS=--coverage CXXFLAGS=--coverage LDFLAGS=--coverage CMOCKA_MESSAGE_OUTPUT=stdout
mapfile -t tests < <(find tests/{unit,golden,abi} tests/e2e/test_cli*.c -name 'test_*.c' -printf '%f\n' | sed 's/\.c$//' | sort)
echo "coverage: ${#tests[@]} test programs"
scripts/build debug dragmesh_cli dragmesh_evaluate dragmesh_generate dragmesh_lab caller "${tests[@]}"
find build/obj -path '*/debug/*.gcda' -delete
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
printf '%s\0' "${tests[@]}" | xargs -0 -P "${JOBS:-$(nproc)}" -I{} sh -c "build/debug/tests/{} > $work/{} 2>&1 || { echo 'coverage: {} failed' >&2; cat $work/{} >&2; exit 255; }"
python3 tests/coverage.py $least "${1:-check}"
