#!/usr/bin/env bash
# tests/abi/readme.sh — the README's C compiles as it stands there, as C11, C17 and C++20, with gcc and clang.
set -euo pipefail
cd "$(dirname "$0")/../.."
code=$(sed -n '/^```c$/,/^```$/p' README.md | grep -v '^```')
[ "$(grep -c dm_ <<< "$code")" -gt 10 ] || { echo "README.md holds no C any more" >&2; exit 1; }
# compiles COMPILER LANGUAGE STANDARD WARNING…
compiles() {
    "$1" -x "$2" -std="$3" -Wall -Wextra -Wpedantic -Wconversion "${@:4}" -Werror -fsyntax-only -Iplugin_api/include - <<< "$code"
}
# g++, and clang from 19 on, warn of every field that a designator leaves out, which is what zero defaults are for.
for standard in c11 c17; do
    compiles gcc c $standard
    compiles clang c $standard -Wno-missing-field-initializers
done
compiles g++ c++ c++20 -Wno-missing-field-initializers
compiles clang++ c++ c++20 -Wno-missing-field-initializers
