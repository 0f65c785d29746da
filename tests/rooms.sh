#!/usr/bin/env bash
# tests/rooms.sh — checks that the build keeps the rooms of sdk apart: a header of a room that a file may not use is not
# found. Takes the include paths from the makefiles that scripts/build has made (build/make); takes a few seconds.
#
# 1. A copy of one file of a room compiles; the same copy with an include of a forbidden header does not.
# 2. No two rooms can include from each other, and no room from plugin_api/src, samples, training or tests.
# 3. No file of sdk has "../" in an include, which would go round the include paths.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
problems=0
problem() { echo "rooms: $*" >&2; problems=$((problems + 1)); }

rooms=$(sed -n '/^local rooms = {/,/^}/s/^ *{ "\([a-z/]*\)".*/\1/p' premake5.lua)
[ "$(wc -w <<< "$rooms")" -ge 15 ] || { echo "rooms: premake5.lua's table of rooms was not read" >&2; exit 1; }
for room in $rooms; do
    [ -e "build/make/dragmesh_${room//\//_}.make" ] || { echo "rooms: no makefile for $room, run scripts/build" >&2; exit 1; }
done

# The macros and include paths of a room's release build. Runs in build/make, which the paths are relative to.
flags() {
    awk '/ifeq \(\$\(config\),release/ { on = 1 } /^endif/ { on = 0 }
        on && match($0, /(DEFINES|INCLUDES) *\+= */) { print substr($0, RSTART + RLENGTH) }' "dragmesh_${1//\//_}.make"
}

# check ROOM FILE.c: the compiler's messages; its exit status.
check() { (cd build/make && ${CC:-gcc} -std=gnu17 -fsyntax-only $(flags "$1") "$2" 2>&1); }

# forbid ROOM/FILE.c HEADER…: each header must not be found from that file.
forbid() {
    local file=$1 room=${1%/*} copy=$work/${1##*/} header messages
    shift
    cp "sdk/$file" "$copy"
    messages=$(check "$room" "$copy") || { problem "sdk/$file does not compile alone: $messages"; return; }
    for header in "$@"; do
        { echo "#include \"$header\""; cat "sdk/$file"; } > "$copy"
        if messages=$(check "$room" "$copy"); then
            problem "sdk/$file compiles with #include \"$header\""
        elif ! grep -q "$header.*\(No such file\|not found\)" <<< "$messages"; then
            problem "sdk/$file with #include \"$header\" fails for another reason: $messages"
        fi
    done
}

forbid base/arena.c mesh/mesh.h dragmesh_cli/options.h generator/generator.h generator.h dragmesh_lab.h
forbid math/frames.c mesh/mesh.h pick/pick.h
forbid mesh/mesh.c motion/drag.h kinematics/analysis/part_analysis.h nn/layers.h
forbid pick/scene.c kinematics/object/object.h motion/drag.h
forbid nn/layers.c mesh/mesh.h math/joint.h
forbid segmentation/part_finder.c kinematics/analysis/part_analysis.h pick/pick.h
forbid kinematics/analysis/patches.c kinematics/ranking/ranker.h kinematics/kpp/kpp_net.h nn/layers.h
forbid kinematics/kpp/kpp_input.c kinematics/analysis/part_analysis.h kinematics/candidates/candidates.h
forbid kinematics/features/cheap_features.c kinematics/ranking/ranker.h kinematics/limits/limits.h
forbid kinematics/ranking/ranker.c kinematics/limits/limits.h kinematics/inference/joint_inference.h
forbid kinematics/inference/joint_inference.c kinematics/object/object.h motion/drag.h api_handles.h
forbid kinematics/object/prepare.c motion/drag.h segmentation/part_finder.h
forbid motion/drag.c segmentation/part_finder.h api_handles.h dragmesh_lab.h

# Which headers a room finds: `header LINE` in the compiler's output for each.
(cd sdk && find . -name '*.h' | sed 's|^\./||' | sort) > "$work/sdk"
(cd plugin_api/src && ls ./*.h | sed 's|^\./||'; cd ../../samples && find . -name '*.h' | sed 's|^\./||'
 cd ../training && find . -name '*.h' | sed 's|^\./||'; cd generator && find . -name '*.h' | sed 's|^\./||'
 cd "$root/tests" && find . -name '*.h' | sed 's|^\./||') | sort -u > "$work/outside"
cat "$work/sdk" "$work/outside" | sed 's/.*/#if __has_include("&")\n"&"\n#endif/' > "$work/probe.c"
for room in $rooms; do
    (cd build/make && ${CC:-gcc} -E -P $(flags "$room") "$work/probe.c") | tr -d '"' | sort -u > "$work/found"
    grep -q "^$room/" "$work/found" || problem "sdk/$room does not find its own headers"
    strangers=$(comm -12 "$work/found" "$work/outside" | comm -23 - "$work/sdk")
    [ -z "$strangers" ] || problem "sdk/$room finds headers from outside sdk:" $strangers
    for other in $rooms; do
        [ "$other" = "$room" ] || ! grep -q "^$other/[^/]*$" "$work/found" || echo "$room $other"
    done
done > "$work/edges"
while read -r room other; do
    [[ $room > $other ]] || ! grep -qx "$other $room" "$work/edges" || problem "sdk/$room and sdk/$other find each other"
done < "$work/edges"

upwards=$(grep -rnE '^ *# *include *["<]([^">]*/)?\.\./' sdk --include='*.[ch]' --include='*.cpp' --include='*.def' || true)
[ -z "$upwards" ] || problem "an include has ../: $upwards"

[ "$problems" = 0 ] || exit 1
echo "rooms: $(wc -w <<< "$rooms") rooms, $(wc -l < "$work/edges") allowed directions, none both ways"
