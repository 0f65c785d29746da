#!/usr/bin/env bash
# tests/abi/readme.sh — the README's C compiles as it stands there, with gcc and clang.
set -euo pipefail
cd "$(dirname "$0")/../.."
code=$(sed -n '/^```c$/,/^```$/p' README.md | grep -v '^```')
[ "$(grep -c dm_ <<< "$code")" -gt 10 ] || { echo "README.md holds no C any more" >&2; exit 1; }
for compiler in gcc clang; do
    "$compiler" -std=c11 -Wall -Wextra -Wpedantic -Wconversion -Werror -fsyntax-only -Iplugin_api/include -x c - <<< "$code"
done
