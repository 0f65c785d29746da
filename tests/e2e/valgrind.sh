#!/usr/bin/env bash
# tests/e2e/valgrind.sh BUILD — the tools' main jobs under valgrind: no leak, no error.
set -euo pipefail
build=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
check() { # PROGRAM COMMAND…
    valgrind --quiet --leak-check=full --show-leak-kinds=definite,indirect,possible --errors-for-leak-kinds=definite,indirect \
        --error-exitcode=9 "$build/$1" "${@:2}" > "$work/out" || {
        status=$?
        [ "$status" -eq "$expected" ] || { echo "valgrind: $* ended with $status" >&2; exit 1; }
    }
}

"$build/dragmesh_generate" --category door --seed 3 -o "$work/set/door"
object=$work/set/door/object.glb
moving=$(sed -n '/"moving_nodes"/,/\]/p' "$work/set/door/joints.json" | grep -o '"[^"]*"' | sed -n 2p | tr -d '"')
drag=$(tr -d ' \n\t' < "$work/set/door/joints.json" | grep -o '"drags":\[{"point":\[[^]]*\],"vector":\[[^]]*\]' | head -1)
point=$(echo "$drag" | sed 's/.*"point":\[\([^]]*\)\].*/\1/')
vector=$(echo "$drag" | sed 's/.*"vector":\[\([^]]*\)\].*/\1/')

expected=0
check dragmesh infer "$object" --moving "$moving" --drag-point "$point" --drag-vector "$vector" --json
check dragmesh animate "$object" --moving "$moving" --drag-point "$point" --drag-vector "$vector" -o "$work/open.glb"
check dragmesh prepare "$object" -o "$work/door.dmo"
check dragmesh pick "$object" --ray 0,1,5,0,0,-1 --json
check dragmesh film "$object" --moving "$moving" -o "$work/open.png" --size 24,24 --frames 2
check dragmesh-evaluate eval "$work/set" --json
expected=1
printf '{"id":1,"file":"%s","moving":["%s"]}\nno json\n{"id":2,"file":"%s","moving":["nosuch"]}\n' \
    "$object" "$moving" "$object" > "$work/jobs"
check dragmesh infer --jobs "$work/jobs"
echo "valgrind: clean"
