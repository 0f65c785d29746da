#!/usr/bin/env bash
# bindings/godot/run_in_sid.sh FOLDER [BUILD_FOLDER] — as root: makes a Debian sid in FOLDER/sid (Debian 12 has Godot 3 alone),
# installs its Godot 4, packs the extension and runs it there. What it prints is in bindings/godot/sid_output.txt.
set -euo pipefail
[ $# -ge 1 ] || { sed -n '2,3s/^# \{0,1\}//p' "$0" >&2; exit 2; }
mkdir -p "$1"
cd "$(dirname "$0")/../.."
out=$(realpath "$1") build=$(realpath "${2:-build/release}")
sid=$out/sid project=$out/sid/project mirror=${MIRROR:-http://deb.debian.org/debian}
[ -e "$sid/usr/bin/godot" ] ||
    debootstrap --variant=minbase --include=godot,xvfb,xauth,libgl1-mesa-dri,libegl1,libfontconfig1 sid "$sid" "$mirror" > "$out/debootstrap.log"
mkdir -p "$sid/proc" "$sid/tmp/home"
mountpoint -q "$sid/proc" || mount -t proc proc "$sid/proc"
trap 'umount "$sid/proc"' EXIT

in_sid() { LIBGL_ALWAYS_SOFTWARE=1 timeout 600 chroot "$sid" env HOME=/tmp/home "$@"; }
# godot ARGUMENT… — without a screen, in the project.
godot() { in_sid godot --headless --path /project "$@"; }

rm -rf "$project"
bindings/godot/demo/make "$project" "$build"
cp bindings/godot/tests/*.gd "$project/"
# imported_with NAME OPTION — a copy of the cabinet that is imported with an option.
imported_with() {
    cp "$project/props/kitchen_cabinet.glb" "$project/props/$1.glb"
    printf '[remap]\n\nimporter="scene"\nimporter_version=1\ntype="PackedScene"\n\n[params]\n\n%s\n' "$2" > "$project/props/$1.glb.import"
}
imported_with openable dragmesh/openable=true
imported_with rooted 'nodes/root_type="DragMeshBody3D"'
echo "Godot $(in_sid godot --version)"
# Godot 4.6 crashes at the end of a headless import that sees an extension for the first time (godotengine/godot issue 111048).
mkdir -p "$project/.godot"
echo res://addons/dragmesh/dragmesh.gdextension > "$project/.godot/extension_list.cfg"
godot --import > "$out/import.log" 2>&1 || { tail "$out/import.log" >&2; exit 1; }

echo "== the common scenario, compared with C"
gcc -std=c17 -Iplugin_api/include -Isamples/common bindings/scenario/scenario.c -o "$out/scenario" -L"$build" -ldragmesh -Wl,-rpath,"$build"
"$out/scenario" > "$out/c.txt"
godot --script scenario.gd 2> "$out/scenario.log" | sed '/^Godot Engine/,/^$/d' > "$out/godot.txt"
cmp "$out/c.txt" "$out/godot.txt"
echo "the same $(wc -l < "$out/c.txt") lines as C"

echo "== the room, played by a hand"
godot --fixed-fps 60 -- --play 2> "$out/room.log" | sed '/^Godot Engine/,/^$/d' | tee "$out/room.txt"
grep -q '; 0 failures$' "$out/room.txt"

echo "== saving, networking, physics"
godot --fixed-fps 60 --script handover.gd 2> "$out/handover.log" | sed '/^Godot Engine/,/^$/d'

echo "== scenes in which nothing is marked"
godot --script whole.gd 2> "$out/whole.log" | sed '/^Godot Engine/,/^$/d' | tee "$out/whole.txt"
! grep -q '^FAILED' "$out/whole.txt" && grep -q '^ok: cancelled' "$out/whole.txt"

echo "== reloads"
godot --editor --script reload.gd > "$out/reload.log" 2>&1 || { grep -v '^.\[\|^\[' "$out/reload.log" | tail -n 20 >&2; exit 1; }
grep ' rounds: ' "$out/reload.log"

echo "== its picture"
in_sid xvfb-run -a -s "-screen 0 1280x800x24" godot --rendering-driver opengl3 --audio-driver Dummy --fixed-fps 60 --path /project -- \
    --play /project/room.png > "$out/picture.log" 2>&1 || { tail "$out/picture.log" >&2; exit 1; }
cp "$project/room.png" "$out/"
echo room.png

echo "== imported scenes"
godot --script imported.gd 2> "$out/imported.log" | sed '/^Godot Engine/,/^$/d'

echo "== the editor"
rm -f "$project"/editor*.png
in_sid xvfb-run -a -s "-screen 0 1600x900x24" godot --editor --rendering-driver opengl3 --audio-driver Dummy --resolution 1600x900 \
    --path /project --script editor.gd -- /project > "$out/editor.log" 2>&1 || { grep -v '^.\[' "$out/editor.log" | tail >&2; exit 1; }
grep '^ok: ' "$out/editor.log"
cp "$project"/editor*.png "$out/"

echo "== the first door"
godot --script first_door.gd 2> "$out/door.log" | sed '/^Godot Engine/,/^$/d' | tee "$out/door.txt"
grep -q ' has opened$' "$out/door.txt"
