#!/usr/bin/env bash
# tests/pick_choices.sh [BUILD_FOLDER] — what scripts/build --pick=embree, portable and none leave out: the library links
# without it, and the tests of picking pass with what is left. Compiles the room `pick` alone; all else is the build's.
set -euo pipefail
build=$(realpath "${1:-"$(dirname "$0")/../build/release"}")
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cc=gcc
command -v ccache > /dev/null && cc="ccache gcc"
flags="-std=gnu17 -O2 -fPIC -fvisibility=hidden -ffp-contract=off -D_GNU_SOURCE -Wall -Wextra -Werror"
flags="$flags -Iplugin_api/include -Isdk -Itraining/generator -Itests/include -Isamples/common -Ithird_party"

# choice NAME MACROS TEST…
choice() {
    local name=$1 macros=$2 out=$work/$1 source test
    shift 2
    mkdir "$out"
    for source in sdk/pick/*.c; do $cc $flags $macros -c "$source" -o "$out/$(basename "$source" .c).o"; done
    # The rest comes from the archive, whose own `pick` stays out: what it defines is there already.
    gcc -shared -Wl,-z,defs -Wl,--version-script=plugin_api/dragmesh.map build/obj/dragmesh/release/interface.o "$out"/*.o \
        "$build/lib/libdragmesh_core.a" -ldl -lm -o "$out/libdragmesh.so"
    for test; do
        $cc $flags $macros -DDM_TEST_ROOM='"pick"' -c "tests/unit/$test.c" -o "$out/$test.test"
        gcc "$out/$test.test" "$out"/*.o "$build/lib/libdragmesh_core.a" -lcmocka -ldl -lm -o "$out/$test"
        CMOCKA_MESSAGE_OUTPUT=stdout "$out/$test" > "$out/log" 2>&1 || { cat "$out/log" >&2; echo "--pick=$name: $test" >&2; exit 1; }
    done
    echo "--pick=$name: the library links, $* pass"
}
choice embree "-DDMI_NO_PORTABLE" test_pick test_object
choice portable "-DDMI_NO_EMBREE" test_pick test_object
choice none "-DDMI_NO_EMBREE -DDMI_NO_PORTABLE" test_pick test_drag_boundary
