#!/usr/bin/env bash
# samples/07_many_objects/make_props.sh OUT [SEEDS] — draws furniture and prepares it offline: OUT/CATEGORY_SEED.dmo, SEEDS (3) of
# each category.
set -euo pipefail
cd "$(dirname "$0")/../.."
out=${1:?make_props.sh OUT [SEEDS]} seeds=${2:-3} tools=build/release work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"
for category in kitchen_cabinet cabinet drawers table wardrobe nightstand showcase slab_cabinet desk_hutch sliding_cabinet oven \
    refrigerator dishwasher washing_machine safe chest; do
    for seed in $(seq 1 "$seeds"); do
        "$tools/dragmesh_generate" --category "$category" --seed "$seed" -o "$work/object" > "$work/log"
        "$tools/dragmesh" prepare "$work/object/object.glb" -o "$out/${category}_$seed.dmo" > "$work/log"
    done
done
