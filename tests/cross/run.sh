#!/usr/bin/env bash
# tests/cross/run.sh windows|linux-arm64|linux-arm32 — builds for another machine and runs there, under wine or qemu: the unit
# tests that tests/cross/MACHINE.txt names, the samples, the tool's own tests, and, against this machine, joints, drags and
# motions. Drags have the same bits everywhere; joints where the kernels are the same. Needs build/release.
set -euo pipefail
cd "$(dirname "$0")/../.."
target=$1 built=$PWD/build/$1
work=$(mktemp -d)
clean_up() {
    rm -rf "$work"
    [ "$target" != windows ] || wineserver -k > /dev/null 2>&1 || true
}
trap clean_up EXIT
failed=0
joints_apart=0     # most that an inferred joint may be off, relative; 0: the same bits
scene_apart=0      # the same of the fixed scene's answers, where a network runs (tests/e2e/determinism.sh)
tool_tests=()      # of tests/e2e, run here against the tool there
has_gltf=1         # and so the tools
laboratory=dragmesh-evaluate # the program that plays drags: qemu does not run what another program becomes
prepared=kitchen_cabinet:7 # kind and seed of the objects whose joints are found on both

complain() {
    echo "$target: $*" >&2
    failed=1
}

case $target in
windows)
    # A prefix of its own, without the parts of wine that no program of ours asks for.
    export LC_ALL=C.UTF-8 WINEPREFIX=$built/wine WINEDEBUG=-all WINEDLLOVERRIDES="mscoree,mshtml,winemenubuilder.exe=" WINEPATH=$built
    runner=wine suffix=.exe compiler=x86_64-w64-mingw32-gcc tool_tests=(test_cli_bad_input test_cli_infer test_cli_outputs)
    prepared="kitchen_cabinet:7 oven:3 toilet:5" laboratory=dragmesh
    mkdir -p "$WINEPREFIX"
    # One server for all programs. One that ends with each program meets the next one while it ends, and closes that
    # one's connection: seldom, a program then ends at once, without a word and with status 0.
    wineserver -k > /dev/null 2>&1 || true
    wineserver -p
    wineboot --init > /dev/null 2>&1
    ;;
linux-arm64) runner="qemu-aarch64 -L /usr/aarch64-linux-gnu" suffix='' compiler=aarch64-linux-gnu-gcc joints_apart=1e-3 scene_apart=1e-3 ;;
linux-arm32) runner="qemu-arm -L /usr/arm-linux-gnueabihf" suffix='' compiler=arm-linux-gnueabihf-gcc has_gltf=0 scene_apart=1e-3 ;;
*)
    echo "tests/cross/run.sh: no machine '$target'" >&2
    exit 2
    ;;
esac
mapfile -t tests < <(grep -v '^#' "tests/cross/$target.txt")
samples="hello_drag dynamic_load host_memory_and_jobs host_pick" libraries="dragmesh caller"
[ "$has_gltf" = 0 ] || samples="$samples prepare_offline many_objects" libraries="$libraries dragmesh_gltf dragmesh_cli dragmesh_evaluate"
scripts/build "$target" $libraries "${tests[@]}" $(printf 'sample_%s ' $samples)

# ---- unit tests ----

run_test() { # NAME
    $runner "$built/tests/$1$suffix" > "$work/$1.log" 2>&1 || touch "$work/$1.failed"
    echo "== $target $1"
    cat "$work/$1.log"
}
export -f run_test
export runner built work target suffix
printf '%s\0' "${tests[@]}" | xargs -0 -P "$(nproc)" -I{} bash -c 'run_test {}'
for name in "${tests[@]}"; do
    [ ! -e "$work/$name.failed" ] || complain "$name failed"
done

# ---- joints, drags and motions, there and here ----

objects="$work/Küche 戸" # paths are UTF-8 everywhere
mkdir "$objects"
there() { $runner "$built/dragmesh$suffix" "$@"; }
for object in $prepared; do
    kind=${object%:*}
    build/release/dragmesh_generate --category "$kind" --seed "${object#*:}" -o "$objects/$kind" > /dev/null
    glb=$objects/$kind/object.glb
    build/release/dragmesh prepare "$glb" -o "$work/$kind.here.dmo" --json > "$work/$kind.here.json"
    [ "$has_gltf" = 1 ] || continue
    there prepare "$glb" -o "$work/$kind.there.dmo" --json > "$work/$kind.there.json"
    if [ "$joints_apart" = 0 ]; then
        cmp "$work/$kind.here.dmo" "$work/$kind.there.dmo" && echo "$target: $kind is prepared to the same bytes" ||
            complain "$kind is prepared to other bytes"
    else
        echo "$target: joints of $kind: $(python3 tests/cross/compare.py $joints_apart "$work/$kind".{here,there}.json)" ||
            complain "$kind has other joints"
    fi
done
if [ "$has_gltf" = 1 ]; then
    build/release/dragmesh dragbot "$objects" --given-joint --poses "$work/here.jsonl" > /dev/null
    $runner "$built/$laboratory$suffix" dragbot "$objects" --given-joint --poses "$work/there.jsonl" > /dev/null
    cmp "$work/here.jsonl" "$work/there.jsonl" || complain "drags differ"
    echo "$target: $(wc -l < "$work/there.jsonl") states of drags"
fi

tests/e2e/determinism.sh against "$target" $scene_apart $runner "$built/tests/caller$suffix" || complain "the fixed scene has other answers"

# ---- Draco, which no build for another machine has ----

if [ "$has_gltf" = 1 ]; then
    gcc -std=gnu17 -O1 -Iplugin_api/include -Isdk -Ithird_party -Itests/include tests/abi/clash/write_props.c \
        build/release/lib/lib{cjson,meshoptimizer}.a -lstdc++ -lm -o "$work/write_props"
    "$work/write_props" "$work"
    ! there infer "$work/draco.glb" --moving door > "$work/props.txt" 2>&1 || complain "Draco's prop is read"
    grep -q KHR_draco_mesh_compression "$work/props.txt" || complain "the refusal of Draco does not name it"
fi

# ---- samples ----

for sample in $samples; do
    arguments=
    case $sample in
    dynamic_load) arguments=$([ -z "$suffix" ] && echo "$built/libdragmesh.so" || echo dragmesh.dll) ;;
    prepare_offline) arguments=$work/kitchen_cabinet.there.dmo ;;
    many_objects) arguments="--props 400 --frames 120 --reach 6 --fps 0 $work/kitchen_cabinet.there.dmo" ;;
    esac
    $runner "$built/samples/sample_$sample$suffix" $arguments > "$work/sample.txt" 2>&1 && tail -n 1 "$work/sample.txt" ||
        { complain "sample_$sample failed"; cat "$work/sample.txt" >&2; }
done

# ---- the tool, by the tests that run here ----

for name in ${tool_tests[@]+"${tool_tests[@]}"}; do
    DM_TEST_TOOL="$runner $built/dragmesh$suffix" build/release/tests/$name || complain "$name failed"
done

# ---- what leaves the binaries, and what they ask for ----

if [ "$target" = windows ]; then
    for name in dragmesh.dll dragmesh_gltf.dll dragmesh.exe dragmesh-evaluate.exe; do
        x86_64-w64-mingw32-objdump -p "build/windows/$name" > "$work/headers"
        asked=$(sed -n 's/^\tDLL Name: //p' "$work/headers" | grep -vixE 'kernel32.dll|msvcrt.dll|shell32.dll|dragmesh(_gltf)?.dll' || true)
        [ -z "$asked" ] || complain "$name asks for $asked"
        case $name in dragmesh.dll) own='dm_' ;; dragmesh_gltf.dll) own='dm_gltf_' ;; *) own='dm_' ;; esac
        others=$(sed -n '/Name Pointer. Table/,/^$/s/^\t\[ *[0-9]*\] //p' "$work/headers" | grep -v "^+base\|^$own" || true)
        [ -z "$others" ] || complain "$name also exports" $others
    done
    tests/cross/msvc.sh || complain "the check of Microsoft's rules failed"
    tests/cross/clash.sh || complain "a host's names, or another copy, change something"
else
    for library in $libraries; do
        [ -e "$built/lib$library.so" ] || continue # a program
        others=$("${compiler%gcc}nm" -D --defined-only "$built/lib$library.so" | awk '$3 !~ /^dm_/ { print $3 }')
        [ -z "$others" ] || complain "lib$library.so also exports" $others
    done
fi
exit $failed
