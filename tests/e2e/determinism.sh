#!/usr/bin/env bash
# tests/e2e/determinism.sh — one fixed scene (tests/abi/caller.c: prepare, pick, drag, release, motion) has the same bits
# however the library is built and run: the hashes in tests/golden/data/scene.txt, for one worker or eight, for each
# configuration that is built. Needs build/release.
# tests/e2e/determinism.sh write — writes the hashes anew, after a change that means to change answers.
# tests/e2e/determinism.sh against NAME APART COMMAND… — the same scene by another build of caller.c: where its object is
# read from a file, prepare, pick, drag and release have the same bits. What runs a network differs by APART at most,
# relative; APART 0: all bits are the same. tests/cross, tests/web, tests/isa and tests/release call it.
# tests/e2e/determinism.sh compilers — gcc and clang, -O0 to -O3 (scripts/test long).
set -euo pipefail
cd "$(dirname "$0")/../.."
golden=tests/golden/data/scene.txt models=sdk/models here=build/release/tests/caller
sections="prepare pick drag release paced motion"
exact="prepare pick drag release" # of an object that is loaded
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
complain() {
    echo "determinism: $*" >&2
    failed=1
}

"$here" $models --save "$work/object.dmo" > "$work/here"

hashes() { # OUTPUT
    for section in $sections; do echo "$section $(grep "^$section " "$1" | sha256sum | cut -c1-16)"; done
}

same() { # NAME OUTPUT
    if cmp -s "$work/here" "$2"; then echo "$1: the same $(wc -l < "$2") lines"; return; fi
    complain "$1 differs in $(diff <(hashes "$work/here") <(hashes "$2") | sed -n 's/^> \([a-z]*\).*/\1/p' | paste -sd' ')"
}

# near NAME APART OUTPUT EXACT_SECTIONS
near() {
    local name=$1 apart=$2 output=$3 exact=" $4 " section
    for section in $sections; do
        grep "^$section " "$work/here" > "$work/a" || true
        grep "^$section " "$output" > "$work/b" || true
        if [[ $exact = *" $section "* ]]; then
            cmp -s "$work/a" "$work/b" || complain "$name: $section has other bits"
        else
            echo "$name: $section: $(python3 tests/cross/compare.py "$apart" "$work/a" "$work/b")" || complain "$name: $section is too far off"
        fi
    done
}

against() { # NAME APART COMMAND…
    local name=$1 apart=$2
    shift 2
    "$@" $models --load "$work/object.dmo" | tr -d '\r' > "$work/loaded" || complain "$name fails on a loaded object"
    "$@" $models | tr -d '\r' > "$work/whole" || complain "$name fails"
    if [ "$apart" = 0 ]; then
        same "$name" "$work/whole"
        same "$name, loaded" "$work/loaded"
    else
        near "$name, loaded" "$apart" "$work/loaded" "$exact"
        near "$name" "$apart" "$work/whole" ""
    fi
}

compilers() {
    local compiler level out
    local flags="-std=gnu17 -fvisibility=hidden -ffp-contract=off -fno-math-errno -fno-trapping-math -w -D_GNU_SOURCE -DDM_BUILDING
        -Iplugin_api/include -Isdk -Isamples/common -Ithird_party"
    for compiler in gcc clang; do
        for level in 0 1 2 3; do
            out=$work/$compiler$level
            mkdir "$out"
            find sdk plugin_api/src third_party/cjson/cJSON.c build/embed tests/abi/caller.c -name '*.c' -not -path '*/gltf/*' -print0 |
                xargs -0 -P "${JOBS:-$(nproc)}" -I{} sh -c "$compiler $(echo $flags) -O$level -c {} -o $out/\$(basename {} .c).o"
            "$compiler" "$out"/*.o -o "$out/caller" -ldl -lm -lpthread
            against "$compiler -O$level" 0 "$out/caller"
        done
    done
}

case ${1:-} in
write) hashes "$work/here" > $golden ;;
against) shift; against "$@" ;;
compilers) compilers ;;
*)
    grep -qw avx2 /proc/cpuinfo && { hashes "$work/here" | diff $golden - || complain "answers have changed ($golden is written by $0 write)"; }
    for workers in 2 3 8; do
        "$here" $models --workers $workers > "$work/workers"
        same "$workers workers" "$work/workers"
    done
    for config in debug asan tsan; do
        [ ! -x build/$config/tests/caller ] || against "$config" 0 build/$config/tests/caller
    done
    ;;
esac
exit $failed
