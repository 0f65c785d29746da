#!/usr/bin/env bash
# tests/e2e/smoke_training.sh — trains both networks and the ranker for a moment from nothing (some minutes). Fails when a
# loss does not fall, when a run or the whole command does not go on from where it was, when the same run twice gives other weights, when exported
# weights can't be scored, when the networks of the paper's size can't take a step, or when the library with a ranker of 400
# cases finds less than half of the joints.
set -euo pipefail
cd "$(dirname "$0")/../.."
python=${PYTHON:-/usr/bin/python3}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Steps 1-100, then 101-200 by a second process; the mean loss of the last 50 against that of the first 50.
smoke() {
    local network=$1 weights=$2; shift 2
    "$python" training/train "$network" --run "$work/$network" --out "$work" --set steps=200 "$@" --until 100
    "$python" training/train "$network" --run "$work/$network" --out "$work" --set steps=200 "$@"
    awk -F, -v name="$network" '
        NR == 1 { for (i = 1; i <= NF; i++) if ($i == "total") column = i }
        NR == 2 { first = $column }
        { last = $column; step = $1 }
        END {
            printf "%s: loss %.4f, then %.4f at step %d\n", name, first, last, step
            exit !(NR == 5 && step == 200 && last < 0.9 * first)
        }' "$work/$network/log.csv" || { echo "smoke training: the loss of $network did not fall, or its run did not resume" >&2; exit 1; }
    (cd training && "$python" -m dragmesh_training.evaluate "$network" "$work/$weights" --count 64 > /dev/null)
}

smoke kpp kpp_net.safetensors --set batch=16 --set pool=1024 --set choice_from=0
smoke vae dq_vae.safetensors --set batch=32 --set pool=1024
for way in "" --plain; do
    for run in first second; do
        "$python" training/train kpp $way --run "$work/$run$way" --out "$work/$run$way" --set steps=20 --set batch=8 --set pool=256
    done
    cmp "$work/first$way/kpp_net.safetensors" "$work/second$way/kpp_net.safetensors" || { echo "smoke training: the same run gave other weights" >&2; exit 1; }
done
for network in kpp vae; do
    "$python" training/train "$network" --run "$work/$network-paper" --set size=paper --set steps=1 --set batch=2 --set pool=256
done

# The whole command, stopped and gone on with, ends with all three files.
mkdir -p "$work/whole/ranker"
for name in earlier held_out; do
    cp sdk/models/kpp_net.safetensors "$work/whole/ranker/kpp_$name.safetensors"
done
whole=("$python" training/train --run "$work/whole" --set steps=40 --set batch=8 --set pool=256 --share 0.002)
"${whole[@]}" --until 20
"${whole[@]}" > "$work/whole/log"
for file in kpp_net dq_vae ranker; do
    [ -s "$work/whole/$file.safetensors" ] || { echo "smoke training: the whole command left no $file" >&2; exit 1; }
done

# A clone may lack the commits of the networks of before (dragmesh_training/ranker.py): the shipped one stands in for them.
mkdir "$work/ranker"
for name in earlier held_out; do
    cp sdk/models/kpp_net.safetensors "$work/ranker/kpp_$name.safetensors"
done
"$python" training/train ranker --run "$work/ranker" --out "$work" --share 0.004 > "$work/ranker/log"
(cd training && "$python" -m dragmesh_training.ranker answer --ranker "$work/ranker.safetensors" --only trained --count 200) |
    awk '{ print "ranker of 400 cases:", $0 } /with a drag/ { right = $9 } END { exit !(right > 0.5) }' ||
    { echo "smoke training: the ranker finds less than half of the joints" >&2; exit 1; }
