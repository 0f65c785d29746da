#!/usr/bin/env bash
# tests/e2e/exports.sh BUILD [--generated N] [--most N] [--keep FOLDER] [FOLDER…] — rigs assets in all formats and loads them:
# URDF by urdfdom and MuJoCo, MJCF by MuJoCo, SDF by libsdformat; USDA, Godot's scenes and the GLB are read back. Every joint is
# driven, and where all triangles are is compared with what rig.json says.
# FOLDER: of assets, as `dragmesh rig` takes it, of which --most N are taken. --generated N: so many generated ones, of as many
# kinds. Neither: an asset of all kinds of joints and hostile names, the chest of docs/exports.md, and the cabinet. --keep: where files and reports stay.
# Consumers that are not installed are named and left out.
set -euo pipefail
build=$(realpath "$1"); shift
generated=0 most=1000000 keep= folders=()
while [ $# -gt 0 ]; do
    case $1 in
    --generated) generated=$2; shift ;;
    --most) most=$2; shift ;;
    --keep) keep=$(realpath -m "$2"); shift ;;
    *) folders+=("$(realpath "$1")") ;;
    esac
    shift
done
cd "$(dirname "$0")/../.."
work=${keep:-$(mktemp -d)}
[ -n "$keep" ] || trap 'rm -rf "$work"' EXIT
mkdir -p "$work/in" "$work/out"
tool=$build/dragmesh formats=glb,urdf,mjcf,sdf,usda,tscn failed=0

# link NAME FILE — takes a file into the assets, under a name of its own.
link() {
    ln -sfn "$2" "$work/in/$1.glb"
}

for folder in "${folders[@]}"; do
    find -L "$folder" -maxdepth 2 \( -name '*.glb' -path "$folder/*.glb" -o -name object.glb \) | sort | sed -n "1,${most}p" |
        while read -r file; do
            name=${file#"$folder/"}
            name=${name%/object.glb}
            link "${name%.glb}" "$file"
        done
done
if [ "$generated" -gt 0 ]; then
    "$build/dragmesh_generate" --list --asset | awk '{ print $1 }' | sort | awk -v n="$generated" '{ kinds[NR] = $0 } END { for (i = 0; i < n; i++) print kinds[int(i * NR / n) + 1] }' |
        while read -r kind; do
            "$build/dragmesh_generate" --category "$kind" --asset --seed 7 -o "$work/generated/$kind" > /dev/null
            link "generated_$kind" "$work/generated/$kind/object.glb"
        done
fi
if [ ${#folders[@]} = 0 ] && [ "$generated" = 0 ]; then
    /usr/bin/python3 tests/e2e/exports/odd_asset.py "$work/odd.glb"
    /usr/bin/python3 tests/e2e/exports/odd_asset.py "$work/chest.glb" chest
    link odd "$work/odd.glb"
    link chest "$work/chest.glb"
    link cabinet "$PWD/samples/cabinet.glb"
fi

"$tool" rig "$work/in" -o "$work/out" -j "$(nproc)" --min-moves 0.05 --formats $formats > "$work/rig.txt" 2> "$work/warnings.txt" ||
    { grep failed "$work/rig.txt" >&2; failed=1; }
tail -n 1 "$work/rig.txt"
pairs=() rigs=()
for rig in "$work"/out/*/rig.json; do
    folder=${rig%/rig.json}
    pairs+=("$work/in/${folder##*/}.glb" "$folder")
    rigs+=("$folder")
done

[ -e "${rigs[0]}/rig.json" ] || { echo "exports.sh: nothing was rigged" >&2; exit 1; }

# load NAME COMMAND… — runs a check whose last line is its result; shows what has failed.
load() {
    local name=$1; shift
    if ! "$@" > "$work/$name.txt" 2>&1; then
        grep -B 3 FAILED "$work/$name.txt" >&2 || true
        failed=1
    fi
    tail -n 1 "$work/$name.txt"
}

# each FILE COMMAND… — runs a command on that file of each asset, and counts those that fail.
each() {
    local file=$1 bad=0 folder; shift
    for folder in "${rigs[@]}"; do
        "$@" "$folder/$file" > "$work/said" 2>&1 || { echo "$folder/$file: FAILED"; cat "$work/said"; bad=$((bad + 1)); }
    done
    echo "$1 $file: ${#rigs[@]} assets, $bad failed"
    [ $bad = 0 ]
}

if command -v check_urdf > /dev/null; then load urdf each rigged.urdf check_urdf; else echo "exports.sh: no check_urdf"; fi
if command -v ign > /dev/null; then load sdf each rigged.sdf ign sdf -k; else echo "exports.sh: no ign sdf"; fi
for check in check_mujoco check_sdf; do
    if [ -x "$build/tests/$check" ]; then load $check "$build/tests/$check" "${pairs[@]}"; else echo "exports.sh: no $check"; fi
done
load check_text /usr/bin/python3 tests/e2e/exports/check_text.py "${rigs[@]}"
[ ! -e "$work/in/chest.glb" ] || load page /usr/bin/python3 tests/e2e/exports/check_page.py docs/exports.md "$work/out/chest"
exit $failed
