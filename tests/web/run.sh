#!/usr/bin/env bash
# tests/web/run.sh [BUILD_FOLDER] — the WebAssembly module, its binding in node, and the page in Chromium.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/release}
most=620000      # bytes of the module gzipped
scene_apart=1e-3 # relative, of the fixed scene's answers where a network runs
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
fail() { echo "web: $*" >&2; failed=1; }

scripts/build web > "$work/log" 2>&1 || { tail -20 "$work/log" >&2; exit 1; }
size=$(gzip -9 -c build/web/dragmesh.wasm | wc -c)
echo "module: $(stat -c %s build/web/dragmesh.wasm) bytes, $size gzipped"
[ "$size" -le "$most" ] || fail "the module has $size bytes gzipped, more than $most"

# The same bits as C, compiled for the same machine; close to the native library.
emcc -O1 -sTOTAL_STACK=1MB -std=c17 -msimd128 -Iplugin_api/include -Isamples/common bindings/scenario/scenario.c build/web/lib/libdragmesh_core.a \
    -sNODERAWFS=1 -sSINGLE_FILE=1 -sALLOW_MEMORY_GROWTH=1 -sWASM_BIGINT -o "$work/scenario.js"
node "$work/scenario.js" sdk/models > "$work/c.txt"
node bindings/js/scenario.mjs build/web/dragmesh.wasm sdk/models > "$work/js.txt"
grep -q '^error DM_ERROR_EMPTY_MASK$' "$work/c.txt" || fail "the C program did not come to its end"
if cmp -s "$work/c.txt" "$work/js.txt"; then echo "javascript: the same $(wc -l < "$work/c.txt") lines as C"
else fail "JavaScript differs from C"; diff "$work/c.txt" "$work/js.txt" | head -10 >&2 || true; fi
gcc -std=c17 -Iplugin_api/include -Isamples/common bindings/scenario/scenario.c -o "$work/native" -L"$build" -ldragmesh -Wl,-rpath,"$PWD/$build"
"$work/native" > "$work/native.txt"
node tests/web/compare.mjs "$work/native.txt" "$work/js.txt" || fail "JavaScript is far from the native library"

emcc -O1 -sTOTAL_STACK=1MB -std=c17 -msimd128 -ffp-contract=off -Iplugin_api/include -Isamples/common tests/abi/caller.c build/web/lib/libdragmesh_core.a \
    -sNODERAWFS=1 -sSINGLE_FILE=1 -sALLOW_MEMORY_GROWTH=1 -sWASM_BIGINT -o "$work/caller.js"
tests/e2e/determinism.sh against web $scene_apart node "$work/caller.js" || fail "the fixed scene has other answers"

node bindings/js/example.mjs > "$work/example.txt"
grep -q '^left open at 0.9' "$work/example.txt" || fail "the example of the README did not open the door"

node --test tests/web/test_binding.mjs tests/web/test_misuse.mjs > "$work/tests" 2>&1 || failed=1
grep -E '^(not ok|# (tests|pass|fail) )' "$work/tests"

# The page, with nothing from elsewhere.
node samples/11_web/build.mjs
echo '{"type": "module"}' > build/web/package.json # node 18 takes the page's .js files for CommonJS otherwise
node --test tests/web/test_parts.mjs > "$work/parts" 2>&1 || { fail "what the page keeps of a part"; grep -E '^not ok' "$work/parts" >&2 || true; }
node tests/web/page.mjs build/web/site || fail "the page"

# The package that npm makes: it holds what it exports, and nothing of this folder stays behind.
(cd bindings/js && npm pack --silent --pack-destination "$work" > /dev/null)
tar tzf "$work"/dragmesh-*.tgz | sort > "$work/packed"
for file in dragmesh.js dragmesh.d.ts abi.js abi.d.ts memory.js dragmesh.wasm models/kpp_net.safetensors LICENSE README.md package.json; do
    grep -qx "package/$file" "$work/packed" || fail "the npm package lacks $file"
done
[ -z "$(git status --porcelain --ignored bindings/js)" ] || fail "npm pack leaves files in bindings/js"
mkdir "$work/host" && tar xzf "$work"/dragmesh-*.tgz -C "$work/host"
echo 'import { load } from "dragmesh"; console.log((await load()).createContext().memory.bytes > 0);' > "$work/host/use.mjs"
mkdir "$work/host/node_modules" && mv "$work/host/package" "$work/host/node_modules/dragmesh"
[ "$(node "$work/host/use.mjs")" = true ] || fail "the npm package does not load"
# The examples of docs/engines/web.md, with this package and three.js as npm lays them out.
"$build/dragmesh" prepare samples/cabinet.glb -o "$work/host/cabinet.dmo" --json > "$work/host/cabinet.json"
cp bindings/js/examples/* samples/cabinet.glb "$work/host/"
cp -r build/web/npm/node_modules/three "$work/host/node_modules/"
grep -q 'stands open at' <(cd "$work/host" && node first_door.mjs cabinet.dmo) || fail "the guide's first_door.mjs"
grep -q '^grabbed again at 1.20$' <(cd "$work/host" && node handover.mjs cabinet.dmo) || fail "the guide's handover.mjs"
node tests/web/first_door.mjs "$work/host" || fail "the guide's first_door.html"
exit $failed
