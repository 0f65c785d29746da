#!/usr/bin/env bash
# tests/bindings/run.sh BUILD_FOLDER — the common scenario prints the same through every binding as in C; each binding's own tests
# and examples run.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=$(realpath "${1:-build/release}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
warnings="-Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion -Werror"
link="-L$build -ldragmesh -Wl,-rpath,$build"
failed=0

# same NAME COMMAND… — the command prints what the C program has printed.
same() {
    local name=$1; shift
    if ! "$@" > "$work/$name.txt" || ! cmp -s "$work/c.txt" "$work/$name.txt"; then
        echo "bindings: $name differs from C" >&2
        diff "$work/c.txt" "$work/$name.txt" | head -10 >&2 || true
        failed=1
    else
        echo "$name: the same $(wc -l < "$work/c.txt") lines as C"
    fi
}

# passes NAME COMMAND… — the command ends well; its output is shown where it does not.
passes() {
    local name=$1; shift
    "$@" > "$work/log.txt" 2>&1 && { tail -n 1 "$work/log.txt"; return; }
    echo "bindings: $name failed" >&2
    tail -n 20 "$work/log.txt" >&2
    failed=1
}

# guides NAME FIRST_DOOR HANDOVER — two commands, the examples of docs/engines, say of the same cabinet what those of C++ say.
guides() {
    if ! $2 > "$work/first_door.txt" || ! $3 > "$work/handover.txt" || ! cmp "$work/first_door.txt" "$work/guide_door.txt" ||
        ! cmp "$work/handover.txt" "$work/guide_handover.txt"; then
        echo "bindings: the examples of $1 say something else than those of C++" >&2
        failed=1
    fi
}

gcc -std=c17 $warnings -Iplugin_api/include -Isamples/common bindings/scenario/scenario.c -o "$work/c" $link
"$work/c" > "$work/c.txt"
grep -q '^error DM_ERROR_EMPTY_MASK$' "$work/c.txt" || { echo "bindings: the C program did not come to its end" >&2; exit 1; }
cabinet=$work/cabinet.dmo
"$build/dragmesh_generate" --category kitchen_cabinet --seed 100 -o "$work/generated"
cmp samples/cabinet.glb "$work/generated/object.glb" || failed=1 # the cabinet of the guides is one of the generator
"$build/dragmesh" prepare samples/cabinet.glb -o "$cabinet" > "$work/log.txt"
for compiler in g++ clang++; do
    "$compiler" -std=c++17 $warnings -Iplugin_api/include -fsyntax-only -x c++ bindings/cpp/dragmesh_check.hpp
    "$compiler" -std=c++17 -fno-exceptions -fno-rtti $warnings -Iplugin_api/include -Ibindings/cpp bindings/cpp/scenario.cpp -o "$work/$compiler" $link
    same "$compiler" "$work/$compiler"
    "$compiler" -std=c++17 -fno-rtti $warnings -fsanitize=address,undefined -Iplugin_api/include -Ibindings/cpp bindings/cpp/misuse.cpp \
        -o "$work/misuse" $link
    passes "the misuse of C++, by $compiler" "$work/misuse" tests/replay/hands/object.dmo
    for example in first_door handover; do
        "$compiler" -std=c++17 -fno-rtti $warnings -Iplugin_api/include -Ibindings/cpp "bindings/cpp/examples/$example.cpp" -o "$work/$example" $link
    done
    "$work/first_door" "$cabinet" > "$work/guide_door.txt" && "$work/handover" "$cabinet" > "$work/guide_handover.txt"
    # The door comes to where its constraint ends.
    [ "$(sed 's/.* open at//' "$work/guide_door.txt")" = "$(sed -n 's/.* opens to//p' "$work/guide_handover.txt")" ] ||
        { echo "bindings: the example of C++ did not open the door" >&2; failed=1; }
done
LUA_PATH="$PWD/bindings/lua/?.lua;;" same lua luajit bindings/lua/scenario.lua "$build/libdragmesh.so" sdk/models
LUA_PATH="$PWD/bindings/lua/?.lua;;" passes "reloads from LuaJIT" luajit bindings/lua/reload.lua "$build/libdragmesh.so" sdk/models \
    tests/replay/hands/object.dmo
LUA_PATH="$PWD/bindings/lua/?.lua;;" passes "the misuse of LuaJIT" luajit bindings/lua/misuse.lua "$build/libdragmesh.so" \
    tests/replay/hands/object.dmo tests/replay/drawer/object.glb "$build/libdragmesh_gltf.so"
luajit_runs() { LUA_PATH="$PWD/bindings/lua/?.lua;;" luajit "bindings/lua/examples/$1.lua" "$build/libdragmesh.so" "$cabinet"; }
guides LuaJIT "luajit_runs first_door" "luajit_runs handover"
love_room() {
    bindings/lua/love/make "$work/room" "$build" &&
        SDL_AUDIODRIVER=dummy ALSOFT_DRIVERS=null timeout 300 xvfb-run -a -s "-screen 0 1280x800x24" love "$work/room" --play "$work/room.png" &&
        [ -s "$work/room.png" ]
}
passes "the room of LÖVE" love_room

# Python, Debian's own, with Debian's numpy.
PYTHONPATH=bindings/python DRAGMESH_LIBRARY_PATH=$build same Python /usr/bin/python3 bindings/python/tests/scenario.py sdk/models
python_runs() { PYTHONPATH=bindings/python DRAGMESH_LIBRARY_PATH=$build /usr/bin/python3 "bindings/python/examples/$1.py" "$2"; }
guides Python "python_runs first_door samples/cabinet.glb" "python_runs handover $cabinet"
DRAGMESH_LIBRARY_PATH=$build passes "the layer of Python" /usr/bin/python3 tests/python/test_binding.py
DRAGMESH_LIBRARY_PATH=$build passes "the misuse of Python" /usr/bin/python3 tests/python/test_misuse.py
DRAGMESH_LIBRARY_PATH=$build passes "the files of Python" /usr/bin/python3 tests/python/test_whole_file.py
passes "the wheel" tests/python/wheel.sh "$build"
blender_addon() {
    "$build/dragmesh_generate" --category kitchen_cabinet --seed 100 -o "$work" && bindings/python/blender/pack "$work/addon.zip" "$build" &&
        BLENDER_USER_SCRIPTS=$work/scripts timeout 300 blender -b --factory-startup --python bindings/python/blender/tests/run.py -- \
            "$work/object.glb" "$work" "$work/addon.zip" | grep "parts made openable"
}
passes "the add-on of Blender" blender_addon
blender_opens() {
    BLENDER_USER_SCRIPTS=$work/scripts timeout 300 blender -b --factory-startup --python bindings/python/blender/examples/first_door.py -- \
        "$work/addon.zip" samples/cabinet.glb "$work/open.glb" | grep "door_left: revolute from -\?0.00 to" && [ -s "$work/open.glb" ]
}
passes "the example of Blender" blender_opens

# Rust, by Debian's rustc. rustup's, which may stand in front, proves nothing.
rust() {
    (cd bindings/rust && PATH=/usr/bin:$PATH CARGO_HOME=$work/cargo CARGO_TARGET_DIR=$work/rust DRAGMESH_LIB_DIR=$build \
        LD_LIBRARY_PATH=$build RUSTFLAGS="-D warnings" cargo "$@")
}
rust_tests() {
    rust test --offline --features gltf && rust build --offline --examples && [ -x "$work/rust/debug/examples/scenario" ]
}
passes "the tests of Rust" rust_tests
LD_LIBRARY_PATH=$build same Rust "$work/rust/debug/examples/scenario" sdk/models
rust_runs() { LD_LIBRARY_PATH=$build "$work/rust/debug/examples/$1" "$cabinet"; }
guides Rust "rust_runs first_door" "rust_runs handover"

# C#, by Debian's mono.
sharp() { LD_LIBRARY_PATH="$build" mono "$work/$1.exe" "${@:2}"; }
mcs="mcs -nologo -unsafe -warnaserror -langversion:7.2"
$mcs -target:library -out:"$work/DragMesh.dll" bindings/csharp/DragMesh/*.cs
for source in tests/Scenario tests/Behaviour tests/Misuse tests/Reload examples/FirstDoor examples/Handover; do
    $mcs -r:"$work/DragMesh.dll" -out:"$work/$(basename $source).exe" "bindings/csharp/$source.cs"
done
same "C#" sharp Scenario sdk/models
passes "the layer of C#" sharp Behaviour tests/replay/hands/object.dmo sdk/models
passes "the misuse of C#" sharp Misuse tests/replay/hands/object.dmo sdk/models
passes "reloads from C#" sharp Reload sdk/models tests/replay/hands/object.dmo
guides "C#" "sharp FirstDoor $cabinet" "sharp Handover $cabinet"

# The Unity package, on a stub of Unity's API, from the folder that a release has.
unity() {
    local stubs=tests/bindings/unity package=$work/upm/com.dragmesh.unity
    bindings/unity/pack "$work/upm" "linux=$build/libdragmesh.so"
    /usr/bin/python3 tests/bindings/unity/layout.py "$package" &&
        $mcs -target:library -out:"$work/UnityEngine.dll" "$stubs/UnityEngine.cs" &&
        $mcs -target:library -r:"$work/UnityEngine.dll" -out:"$work/UnityEditor.dll" "$stubs/UnityEditor.cs" &&
        $mcs -target:library -r:"$work/UnityEngine.dll" -out:"$work/DragMesh.Unity.dll" "$package"/Runtime/*.cs "$package"/Runtime/*/*.cs &&
        $mcs -target:library -r:"$work/UnityEngine.dll" -r:"$work/UnityEditor.dll" -r:"$work/DragMesh.Unity.dll" \
            -out:"$work/Editor.dll" "$package"/Editor/*.cs &&
        $mcs -r:"$work/UnityEngine.dll" -r:"$work/DragMesh.Unity.dll" -out:"$work/UnityTest.exe" "$stubs/Test.cs" "$package"/Samples~/*/*.cs &&
        sharp UnityTest sdk/models "$package/Samples~/Cabinet/Cabinet.dmo.bytes"
}
passes "the Unity package" unity

# The engine-free part of the Unreal plugin. Nothing compiles what needs the engine.
unreal() {
    local compiler
    for compiler in g++ clang++; do
        "$compiler" -std=c++17 $warnings -Iplugin_api/include -Ibindings/cpp -Ibindings/unreal/DragMesh/Source/DragMesh/Public \
            tests/bindings/unreal/test.cpp -o "$work/unreal" $link && "$work/unreal" "$cabinet" || return 1
    done
}
passes "the Unreal plugin" unreal

# The extension of Godot, against the header of Godot's interface. bindings/godot/run_in_sid.sh runs it: Debian 12 has no Godot 4.
godot() {
    gcc -std=c17 $warnings -Iplugin_api/include -Ithird_party -fsyntax-only bindings/godot/src/*.c && bindings/godot/pack "$work/godot" "$build" &&
        nm -D --defined-only "$work"/godot/addons/dragmesh/*.so > "$work/names.txt" &&
        [ "$(awk '{ print $3 }' "$work/names.txt")" = dragmesh_godot_begin ] && echo "the extension of Godot: compiled, one name out"
}
passes "the extension of Godot" godot
exit $failed
