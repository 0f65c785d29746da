#!/usr/bin/env bash
# tests/e2e/writes.sh BUILD — every program that writes a file, with each step of the writing failing in turn: what was
# there before stays whole, the error says why, and nothing is left behind. Then a full disk, a file system that can't be
# written, writers at once, and an end by a signal.
set -euo pipefail
build=$(realpath "$1")
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'umount "$work/disk" 2> /dev/null || true; rm -rf "$work"' EXIT
gcc -std=gnu17 -Wall -Wextra -shared -fPIC tests/e2e/failing_files.c -o "$work/failing.so" -ldl

"$build/dragmesh_generate" --category door --seed 1 -o "$work/set/door"
"$build/dragmesh_generate" --category lever --seed 1 -o "$work/wrong/lever" # whose joint is not found without weights
object=$work/set/door/object.glb
drag=$(tr -d ' \n\t' < "$work/set/door/joints.json" | grep -o '"drags":\[{"point":\[[^]]*\],"vector":\[[^]]*\]' | head -1)
part="--models none --moving door"
hand="--drag-point $(sed 's/.*"point":\[\([^]]*\)\].*/\1/' <<< "$drag") --drag-vector $(sed 's/.*"vector":\[\([^]]*\)\].*/\1/' <<< "$drag")"
replayed=tests/replay/drawer
sed '/ end$/d' $replayed/hand.session > "$work/save.session"
printf '9000 key S\n9001 end\n' >> "$work/save.session"
viewer="$build/dragmesh_viewer $replayed/object.glb --dmo $replayed/object.dmo --models none --replay"
tool=$build/dragmesh

# What writes: a name; the files in the order of their creation, @ being the folder that they go to; the command.
commands=(
    "animate|@/out.glb|$tool animate $object $part -o @/out.glb --frames 3"
    "film|@/out.png|$tool film $object $part -o @/out.png --frames 2 --size 16,16"
    "prepare|@/out.dmo|$tool prepare $object --models none -o @/out.dmo"
    "infer --mask-out|@/out.json|$tool infer $object $part --mask-out @/out.json"
    "eval --mistakes|@/index.txt @/001.png @/sheet_01.png|$tool eval $work/wrong --models none --no-drag --turn --mistakes @"
    "dragbot --poses|@/out.jsonl|$tool dragbot $work/set --models none --cameras 1 --poses @/out.jsonl"
    "demo|@/out.png @/out.glb|$tool demo $work/set/door --models none --size 16 -o @/out"
    "rig|@/rigged.usda @/rigged.glb @/film.png @/rig.json|$tool rig $object --models none --min-moves 0.001 -o @ --formats usda,glb"
    "generate|@/object.glb @/joints.json|$build/dragmesh_generate --category door --seed 1 -o @"
    "generate --sheet|@/out.png|$build/dragmesh_generate --sheet --category door --columns 1 -o @/out.png"
    "sample 05|@/out.dmo|$build/samples/sample_prepare_offline $object body @/out.dmo"
    "sample 12|@/out.glb|$build/samples/sample_latch house_door --glb @/out.glb"
)
if [ -x "$build/dragmesh_viewer" ]; then
    commands+=("viewer --poses|@/out.txt|$viewer $replayed/hand.session --poses @/out.txt"
        "viewer, key S|@/out.dmo @/out.parts.npy|$viewer $work/save.session --save @/out.dmo")
    if $viewer $replayed/hand.session --png "$work" > "$work/out" 2>&1; then
        commands+=("viewer --png|@/frame_000.png|$viewer $replayed/hand.session --png @"
            "viewer --apng|@/out.png|$viewer $replayed/hand.session --apng @/out.png --frames 2")
    else
        echo "writes.sh: the viewer's pictures are skipped: no OpenGL"
    fi
else
    echo "writes.sh: the viewer is skipped: it is not built"
fi

fail() {
    echo "writes.sh: $*" >&2
    sed 's/^/    /' "$work/err" >&2
    exit 1
}

# fill FOLDER FILES — the files that are there before.
fill() {
    local file
    mkdir -p "$1"
    for file in $2; do printf 'what was there before: %s\n' "${file##*/}" > "$file"; done
}

# check NAME FILES FIRST — of the files, those from the FIRST on are as they were, no part is left in their folder, and
# the command has said why. Those before it have been put into their places.
check() {
    local name=$1 files=($2) first=$3 i
    for i in "${!files[@]}"; do
        [ -s "${files[i]}" ] || fail "$name: ${files[i]} is lost"
        [ "$i" -lt "$first" ] || grep -qa '^what was there before' "${files[i]}" || fail "$name: ${files[i]} is changed"
    done
    [ -z "$(find "$(dirname "${files[0]}")" -name '.dragmesh-*')" ] || fail "$name: a part is left"
    grep -q "can't write.*: \($expected\)" "$work/err" || fail "$name: the reason is not '$expected'"
    ! grep -q NOT_FOUND "$work/err" || fail "$name: a write that fails is no NOT_FOUND"
}

# run NAME COMMAND — which must not succeed; a viewer's key may fail while the viewer goes on. Errors come through a pipe,
# where a limit on the size of files does not count.
run() {
    local status=0
    "${before[@]}" $2 2>&1 > /dev/null | cat > "$work/err" || status=$?
    [ "$status" = 1 ] || [ "$1" = "viewer, key S" ] || fail "$1: ended with $status"
}

cases=0
begun=$SECONDS
for entry in "${commands[@]}"; do
    IFS='|' read -r name files command <<< "$entry"
    folder=$work/here count=0
    for file in $files; do
        count=$((count + 1))
        for step in open write flush sync close rename; do
            rm -rf "$folder"
            fill "$folder" "${files//@/$folder}"
            before=(env "FAIL_STEP=$step" "FAIL_FILE=$count" "LD_PRELOAD=$work/failing.so")
            expected='Disk quota exceeded\|File too large' first=0
            kept=$files
            # Pictures of mistakes are files of their own; what else belongs together is renamed one after the other.
            if [ "$name" = "eval --mistakes" ]; then kept=$file; elif [ $step = rename ]; then first=$((count - 1)); fi
            run "$name" "${command//@/$folder}"
            check "$name, $step of file $count" "${kept//@/$folder}" $first
            cases=$((cases + 1))
        done
    done
done
echo "writes.sh: ${#commands[@]} commands, $cases files and steps"

# ---- a disk that is full, and one that can't be written ----

mounted=0
mkdir "$work/disk"
if mount -t tmpfs -o size=32k none "$work/disk" 2> /dev/null; then
    for entry in "${commands[@]}"; do
        IFS='|' read -r name files command <<< "$entry"
        before=() expected='No space left on device\|Read-only file system'
        fill "$work/disk" "${files//@/$work/disk}"
        head -c 64K /dev/zero > "$work/disk/full" 2> /dev/null || true
        run "$name" "${command//@/$work/disk}"
        check "$name, full disk" "${files//@/$work/disk}" 0
        mount -o remount,ro "$work/disk"
        run "$name" "${command//@/$work/disk}"
        check "$name, read-only disk" "${files//@/$work/disk}" 0
        mount -o remount,rw "$work/disk"
        rm -rf "${work:?}/disk"/*
        mounted=$((mounted + 2))
    done
    umount "$work/disk"
    echo "writes.sh: $mounted on a full and on a read-only disk"
else
    echo "writes.sh: the full and the read-only disk are skipped: mount is not permitted here"
fi

# ---- standard output ----

for command in "infer $object $part" "infer $object $part --json" "pick $object --ray 0,1,5,0,0,-1" \
    "prepare $object --models none -o $work/out.dmo --json" "eval $work/set --models none --json" \
    "dragbot $work/set --models none --cameras 1 --json"; do
    status=0
    "$tool" $command > /dev/full 2> "$work/err" || status=$?
    [ $status = 1 ] && grep -q 'standard output' "$work/err" || fail "$command > /dev/full: $status"
done

# ---- the source itself, links, modes, streams ----

cp "$object" "$work/own.glb"
before=(env FAIL_STEP=write "LD_PRELOAD=$work/failing.so")
run "the source" "$tool animate $work/own.glb $part -o $work/own.glb"
cmp -s "$object" "$work/own.glb" || fail "a failed write destroyed the source"
chmod 640 "$work/own.glb"
ln -s own.glb "$work/link.glb"
ln -s made.glb "$work/dangling.glb"
for name in link dangling; do
    "$tool" animate "$object" $part -o "$work/$name.glb" > "$work/out" 2> "$work/err" || fail "through a link"
    [ -L "$work/$name.glb" ] || fail "a link was replaced by a file"
done
[ "$(stat -c %a "$work/own.glb")" = 640 ] || fail "the mode has changed"
cmp -s "$work/own.glb" "$work/made.glb" || fail "links lead elsewhere"
"$tool" prepare "$object" --models none -o "$work/expected.dmo" > "$work/out"
"$tool" prepare "$object" --models none -o /dev/stdout > "$work/streamed"
head -c "$(stat -c %s "$work/expected.dmo")" "$work/streamed" | cmp -s - "$work/expected.dmo" || fail "/dev/stdout"
mkfifo "$work/pipe"
cat "$work/pipe" > "$work/piped" &
"$tool" prepare "$object" --models none -o "$work/pipe" > "$work/out"
wait $!
cmp -s "$work/piped" "$work/expected.dmo" || fail "a pipe"
mkdir "$work/folder.dmo"
before=() expected='Is a directory'
run "a folder" "$tool prepare $object --models none -o $work/folder.dmo"
grep -q "'$work/folder.dmo': Is a directory" "$work/err" || fail "a folder"
run "no folder" "$tool prepare $object --models none -o $work/nowhere/x.dmo"
grep -q "'$work/nowhere/x.dmo': No such file or directory" "$work/err" || fail "no folder"

# ---- twelve writers at once: a reader finds a whole file at any time ----

cp "$work/expected.dmo" "$work/shared.dmo"
writers=()
for _ in 1 2 3 4 5 6 7 8 9 10 11 12; do
    "$tool" prepare "$object" --models none -o "$work/shared.dmo" > "$work/out" &
    writers+=($!)
done
reads=0
while [ -n "$(jobs -rp)" ]; do
    cmp -s "$work/shared.dmo" "$work/expected.dmo" || fail "a reader met another file"
    reads=$((reads + 1))
done
for writer in "${writers[@]}"; do wait "$writer" || fail "a writer failed"; done
[ -z "$(find "$work" -name '.dragmesh-*')" ] || fail "a writer left a part"

# ---- a signal in the middle of it ----

for signal in INT TERM HUP KILL; do
    mkdir -p "$work/signal"
    echo before > "$work/signal/out.dmo"
    : > "$work/err" # or the last signal's "waits" would count
    # A shell makes its background programs ignore SIGINT; python3 gives it back.
    FAIL_STEP=wait LD_PRELOAD=$work/failing.so /usr/bin/python3 -c 'import os, signal, sys
for each in signal.SIGINT, signal.SIGTERM, signal.SIGHUP: signal.signal(each, signal.SIG_DFL)
os.execv(sys.argv[1], sys.argv[1:])' "$tool" prepare "$object" --models none -o "$work/signal/out.dmo" > "$work/out" 2> "$work/err" &
    writer=$!
    until grep -q waits "$work/err" || ! kill -0 $writer 2> /dev/null; do sleep 0.05; done
    kill -$signal $writer
    wait $writer 2> /dev/null || true
    [ "$(cat "$work/signal/out.dmo")" = before ] || fail "SIG$signal: the file is changed"
    [ $signal = KILL ] || [ "$(ls -A "$work/signal")" = out.dmo ] || fail "SIG$signal: a part is left"
    rm -rf "$work/signal"
done
echo "writes.sh: $reads reads beside twelve writers, four signals"
