#!/usr/bin/env bash
# tests/isa/accuracy.sh DIR — the same accuracy from the scalar kernels as from the machine's best: scores DIR (a folder of
# object.glb + joints.json) with both and shows the lines that differ. The one difference is the kernels chosen.
set -euo pipefail
directory=$(realpath "$1")
cd "$(dirname "$0")/../.."
out=build/scalar
mkdir -p "$out"
gcc -std=c17 -O2 -fPIC -Isdk -c tests/isa/cpu_scalar.c -o "$out/cpu_scalar.o"
gcc -shared -o "$out/libdragmesh.so.0" build/obj/dragmesh/release/interface.o "$out/cpu_scalar.o" \
    build/release/lib/libdragmesh_core.a -Wl,--wrap=dmi_cpu_best_isa -Wl,--version-script=plugin_api/dragmesh.map \
    -ldl -lm
cp build/release/dragmesh{,-evaluate} build/release/libdragmesh_gltf.so.0 "$out"
score() { # PROGRAM: without the time taken
    "$1" eval "$directory" --models sdk/models | sed -E '/^answered/s/ in [0-9.]+ s$//'
}
score "$out/dragmesh" > "$out/scalar.txt"
score build/release/dragmesh > "$out/best.txt"
echo "$(wc -l < "$out/best.txt") lines of scores; scalar (<) and the machine's best (>) differ in:"
diff "$out/scalar.txt" "$out/best.txt" || true
