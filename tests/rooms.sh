#!/usr/bin/env bash
# tests/rooms.sh — checks that the build keeps the rooms of sdk apart: a header of a room that a file may not use is not
# found. It reads the include paths in the makefiles and the symbols in the objects that scripts/build has made (build/make,
# build/obj), and takes a few seconds.
#
# 1. A copy of one file of a room compiles; the same copy with an include of a forbidden header does not.
# 2. No two rooms can include from each other, and no room from plugin_api/src, samples, training or tests.
# 3. No file of sdk or tools has "../" in an include, which would go round the include paths.
# 4. Each room includes from the rooms in its row of premake5.lua, and from every one of them.
# 5. No header includes itself by way of others.
# 6. A tool includes from itself, tools/common, samples/common and the public headers; nothing outside includes from tools.
# 7. No two source files of the library or of a program call each other, and no longer circle of calls leads from a file
#    back to it, so that every file is below those that call it.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
problems=0
problem() { echo "rooms: $*" >&2; problems=$((problems + 1)); }

# The rows of a table of premake5.lua, a room and those that it may include a line.
rows() { sed -n "/^local $1 = {/,/^}/p" premake5.lua | tr '\n' ' ' | grep -oE '\{ "[a-z/]+", \{[^}]*\} \}' | tr -d '{},"'; }
rooms=$(rows rooms | awk '{ print $1 }')
[ "$(wc -w <<< "$rooms")" -ge 15 ] || { echo "rooms: premake5.lua's table of rooms was not read" >&2; exit 1; }
for room in $rooms; do
    [ -e "build/make/dragmesh_${room//\//_}.make" ] || { echo "rooms: no makefile for $room, run scripts/build" >&2; exit 1; }
done

# The macros and include paths of a project's release build. Runs in build/make, which the paths are relative to.
flags() {
    awk '/ifeq \(\$\(config\),release/ { on = 1 } /^endif/ { on = 0 }
        on && match($0, /(DEFINES|INCLUDES) *\+= */) { print substr($0, RSTART + RLENGTH) }' "$1.make"
}
project() { echo "dragmesh_${1//\//_}"; } # ROOM

# forbid_in PROJECT FILE.c HEADER…: each header must not be found from that file.
forbid_in() {
    local project=$1 file=$2 copy=$work/${2##*/} header messages
    shift 2
    compile() { # the compiler's messages; its exit status
        (cd build/make && ${CC:-gcc} -std=gnu17 -fsyntax-only $(flags "$project") -iquote "$root/${file%/*}" "$copy" 2>&1)
    }
    cp "$file" "$copy"
    messages=$(compile) || { problem "$file does not compile alone: $messages"; return; }
    for header in "$@"; do
        { echo "#include \"$header\""; cat "$file"; } > "$copy"
        if messages=$(compile); then
            problem "$file compiles with #include \"$header\""
        elif ! grep -q "$header.*\(No such file\|not found\)" <<< "$messages"; then
            problem "$file with #include \"$header\" fails for another reason: $messages"
        fi
    done
}
forbid() { forbid_in "$(project "${1%/*}")" "sdk/$1" "${@:2}"; } # ROOM/FILE.c HEADER…

forbid base/arena.c mesh/mesh.h options.h common/options.h generator/generator.h generator.h dragmesh_lab.h
forbid math/frames.c mesh/mesh.h pick/pick.h
forbid mesh/mesh.c drag/drag.h kinematics/analysis/part_analysis.h nn/layers.h
forbid gltf/gltf_json.c pick/pick.h kinematics/object/object.h
forbid pick/scene.c kinematics/object/object.h drag/drag.h
forbid nn/layers.c mesh/mesh.h math/joint.h
forbid segmentation/part_finder.c kinematics/analysis/part_analysis.h pick/pick.h
forbid kinematics/analysis/patches.c kinematics/ranking/ranker.h kinematics/kpp/kpp_net.h nn/layers.h
forbid kinematics/kpp/kpp_input.c kinematics/analysis/part_analysis.h kinematics/candidates/candidates.h
forbid kinematics/features/cheap_features.c kinematics/ranking/ranker.h kinematics/limits/limits.h
forbid kinematics/ranking/ranker.c kinematics/limits/limits.h kinematics/inference/joint_inference.h
forbid kinematics/inference/joint_inference.c kinematics/object/object.h drag/drag.h api_handles.h
forbid kinematics/object/prepare.c drag/drag.h segmentation/part_finder.h
forbid motion/motion.c drag/drag.h kinematics/object/object.h
forbid drag/drag.c kinematics/object/object.h pick/pick.h segmentation/part_finder.h api_handles.h dragmesh_lab.h
forbid_in dragmesh_tools tools/common/play.c runs.h rig_output.h evaluate.h drag/drag.h api_handles.h
forbid_in dragmesh_cli tools/dragmesh/answer.c evaluate.h dragbot.h evaluate/evaluate.h mesh/mesh.h api_handles.h
forbid_in dragmesh_evaluate tools/evaluate/box_object.c rig_output.h job_input.h dragmesh/rig_output.h mesh/mesh.h api_handles.h

# Which headers a room finds: `header LINE` in the compiler's output for each.
(cd sdk && find . -name '*.h' | sed 's|^\./||' | sort) > "$work/sdk"
(cd plugin_api/src && ls ./*.h | sed 's|^\./||'; cd ../../samples && find . -name '*.h' | sed 's|^\./||'
 cd ../tools && find . -name '*.h' | sed 's|^\./||'; cd common && ls ./*.h | sed 's|^\./||'
 cd ../../training && find . -name '*.h' | sed 's|^\./||'; cd generator && find . -name '*.h' | sed 's|^\./||'
 cd "$root/tests" && find . -name '*.h' | sed 's|^\./||') | sort -u > "$work/outside"
cat "$work/sdk" "$work/outside" | sed 's/.*/#if __has_include("&")\n"&"\n#endif/' > "$work/probe.c"
for room in $rooms; do
    (cd build/make && ${CC:-gcc} -E -P $(flags "$(project "$room")") "$work/probe.c") | tr -d '"' | sort -u > "$work/found"
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

upwards=$(grep -rnE '^ *# *include *["<]([^">]*/)?\.\./' sdk tools --include='*.[ch]' --include='*.cpp' --include='*.def' || true)
[ -z "$upwards" ] || problem "an include has ../: $upwards"

# The rooms in each row against those that the files include.
names() { find "$@" \( -name '*.[ch]' -o -name '*.cpp' -o -name '*.def' \) -print | sort; }
includes() { names "$@" | xargs grep -HE '^ *# *include *"' | sed -E 's/^([^:]*):[^"]*"([^"]*)".*/\1 \2/'; } # file, header
rows '\(gltf_\)*rooms' | awk '{ for (i = 2; i <= NF; i++) print $1, $i }' | sort > "$work/permitted"
includes sdk | sed -nE 's|^sdk/(.*)/[^/]* (.*)/[^/]*$|\1 \2|p' | awk '$1 != $2' | sort -u |
    while read -r room other; do [ ! -d "sdk/$other" ] || echo "$room $other"; done > "$work/included"
while read -r room other; do
    problem "premake5.lua lets sdk/$room include from sdk/$other, and no file does"
done < <(comm -23 "$work/permitted" "$work/included")
while read -r room other; do
    problem "sdk/$room includes from sdk/$other, which is not in its row of premake5.lua"
done < <(comm -13 "$work/permitted" "$work/included")

# refuse_circles WHAT < PAIRS: a problem for each loop that the pairs make.
refuse_circles() {
    local loops
    loops=$(tsort 2>&1 > "$work/order") || problem "a circle of $1:" $(sed 's/^tsort: *//; s/^-: //' <<< "$loops")
}

# A quoted header lies beside the file that includes it, or below one of these folders.
folders="sdk samples/common tools/common plugin_api/include tools/dragmesh tools/evaluate"
names sdk plugin_api samples tools bindings > "$work/files"
includes sdk plugin_api samples tools bindings | awk -v folders="$folders" '
    NR == FNR { exists[$1]; next }
    {
        beside = $1
        sub(/\/[^\/]*$/, "", beside)
        count = split(beside " " folders, folder)
        for (i = 1; i <= count; i++) {
            header = folder[i] "/" $2
            while (sub(/[^\/]+\/\.\.\//, "", header)) continue
            if (header in exists) { print $1, header; break }
        }
    }' "$work/files" - > "$work/uses"
refuse_circles "includes" < "$work/uses"

# The tools: what a file of each may include from, beside the public headers and what samples share.
while read -r file header; do
    case $file:$header in
    tools/*:plugin_api/include/* | tools/*:samples/common/* | tools/*:tools/common/*) continue ;;
    tools/dragmesh/*:tools/dragmesh/* | tools/evaluate/*:tools/evaluate/*) continue ;;
    tools/*:* | *:tools/*) problem "$file includes $header" ;;
    esac
done < "$work/uses"

# The pairs of objects of which the first one calls the second, or reads what it has.
calls() {
    find "$@" -name '*.o' -print0 | sort -z | xargs -0 nm -A | awk '
        { object = $0; sub(/:.*/, "", object); sub(/.*\//, "", object) }
        $(NF - 1) ~ /^[TDBR]$/ { home[$NF] = object }
        $(NF - 1) == "U" { user[++count] = object; name[count] = $NF }
        END {
            for (i = 1; i <= count; i++)
                if (name[i] in home && home[name[i]] != user[i]) print user[i], home[name[i]]
        }' | sort -u
}
objects() { for project; do echo "build/obj/$project/release"; done; }
library=(dragmesh dragmesh_core dragmesh_gltf)
for room in $rooms; do library+=("dragmesh_${room//\//_}"); done
for folder in $(objects "${library[@]}"); do
    compgen -G "$folder/*.o" > "$work/found" || { echo "rooms: no objects in $folder, run scripts/build" >&2; exit 1; }
done
calls $(objects "${library[@]}") > "$work/calls"
refuse_circles "calls in the library" < "$work/calls"
for tool in dragmesh_cli dragmesh_evaluate; do
    calls $(objects dragmesh_tools "$tool") > "$work/calls"
    refuse_circles "calls in $tool" < "$work/calls"
done
for folder in build/obj/{dragmesh_viewer,dragmesh_lab,dragmesh_generate,dragmesh_generator,sample_*}/release; do
    [ -d "$folder" ] || continue # a program whose library is missing, or one that was not asked for
    calls "$folder" > "$work/calls"
    refuse_circles "calls in $folder" < "$work/calls"
done
mkdir "$work/godot"
(cd "$work/godot" && ${CC:-gcc} -std=c17 -c -I"$root/plugin_api/include" -I"$root/third_party" "$root"/bindings/godot/src/*.c)
calls "$work/godot" > "$work/calls"
refuse_circles "calls in bindings/godot" < "$work/calls"

[ "$problems" = 0 ] || exit 1
echo "rooms: $(wc -w <<< "$rooms") rooms, $(wc -l < "$work/edges") allowed directions, none both ways, no circle of files"
