"""The trees that group an asset's nodes (sdk/assets), fitted on generated assets. One ensemble rates whether two nodes are
one body; one which of the sets that merging by it makes are bodies that move, by the set alone; two the same, each in view of how
the one before rated the asset's other sets. A last one says which body carries which (carriers.py).

    PYTHONPATH=training python3 -m dragmesh_training.assets -o sdk/models/asset_parts.safetensors

makes the shipped weights from its defaults alone. Each sees assets of its own, so that it learns from what those before
it answer where they were not fitted. Kinds that are for tests alone are held out; the score at the end is theirs. Rows can be kept between
runs (--cache FOLDER). The library embeds the file: build it again (scripts/build).
"""
import argparse
import ctypes
import multiprocessing
import os

import numpy as np

from . import carriers
from .boosted_trees import Rule, bin_edges, grow_trees, put_into_bins
from .config import EVERYDAY
from .export import commit, write_safetensors
from .files import save_arrays
from .lab import Options, category_weights, chosen_kinds, kinds, open_lab

ARCHITECTURE = "dragmesh-asset-parts"
PAIR_TREES, SET_TREES, CONTEXT_TREES, LEAVES = 300, 800, 300, 32  # as in sdk/assets/asset_models.c and asset_models.h
TREES = {"pairs": PAIR_TREES, "sets": SET_TREES, "context": CONTEXT_TREES, "context_again": CONTEXT_TREES,
         "carriers": carriers.TREES}
ROUNDS = ("context", "context_again")  # ensembles of DMI_CONTEXT_ROUNDS
PAIR_RATE, SET_RATE = 0.06, 0.03  # shrinkage of each tree's leaves, on kinds held out
FOUND = 0.9  # overlap with the true body from which a set counts as found
STATED = (0, 0.25, 0.5, 1), (0, 0.5, 0.58, 1)  # as state() of sdk/assets/asset_grouping.c; what is rated below .25 stays
EVERYDAY_FACTOR = 4  # by hand
BATCH = 50  # assets
CAPACITY = 60000  # rows of a batch
EDGE_ROWS = 200000  # from which the bins' edges are taken


class AssetRows(ctypes.Structure):
    """dm_lab_asset_rows."""
    _fields_ = [("capacity", ctypes.c_uint32)] + [
        (name, ctypes.c_void_p) for name in ("features", "target", "children", "first", "movers")]


def asset_weights(lab, which):
    """How often each kind is drawn: as usual, the EVERYDAY ones four times as often."""
    mask = category_weights(lab, chosen_kinds(lab, which))
    for kind in kinds(lab):
        if kind.name in EVERYDAY:
            mask[kind.id] *= EVERYDAY_FACTOR
    return mask


def make_batch(lab, weights, rounds, which, seed):
    """Features, targets, children, first rows and numbers of movers of BATCH assets. weights: bytes of the trees so far; None: the
    rows are of pairs. rounds: times that sets are seen in context."""
    columns = lab.dm_lab_asset_pair_columns() if weights is None else lab.dm_lab_asset_set_columns()
    mask = asset_weights(lab, which)
    options = Options(seed, BATCH, 0, mask.ctypes.data, 0.3)
    features, target = np.zeros((CAPACITY, columns), np.float32), np.zeros(CAPACITY, np.float32)
    children, first, movers = np.zeros((CAPACITY, 2), np.int32), np.zeros(BATCH + 1, np.uint32), np.zeros(BATCH, np.uint32)
    rows = AssetRows(CAPACITY, *[array.ctypes.data for array in (features, target, children, first, movers)])
    result = (lab.dm_lab_asset_pairs(ctypes.byref(options), ctypes.byref(rows)) if weights is None else
              lab.dm_lab_asset_sets(ctypes.byref(options), weights, ctypes.c_size_t(len(weights)), rounds, ctypes.byref(rows)))
    if result != 0:
        raise RuntimeError(f"dm_lab_asset rows: {result}")
    used = first[-1]
    return features[:used].astype(np.float16), target[:used], children[:used], first, movers


def make_kept(task):
    """One batch, from the cache when it is there."""
    library, weights, rounds, which, seed, path = task
    if path and os.path.exists(path):
        with np.load(path) as held:
            return [held[key] for key in held.files]
    arrays = make_batch(open_lab(library), weights, rounds, which, seed)
    if path:
        save_arrays(path, *arrays)
    return arrays


def gather(options, weights, rounds, which, count, seed):
    """Arrays of `count` assets, made side by side."""
    name = f"{'pairs' if weights is None else 'sets'}_{which}_{seed}"
    paths = [options.cache and os.path.join(options.cache, f"{name}_{batch}.npz") for batch in range(count // BATCH)]
    tasks = [(options.lab, weights, rounds, which, seed * 1000003 + batch, path) for batch, path in enumerate(paths)]
    with multiprocessing.Pool(options.workers) as pool:
        parts = pool.map(make_kept, tasks, chunksize=1)
    starts = np.cumsum([0] + [len(part[0]) for part in parts])
    first = np.concatenate([part[3][:-1] + start for part, start in zip(parts, starts)] + [starts[-1:]])
    children = np.concatenate([np.where(part[2] < 0, -1, part[2] + start) for part, start in zip(parts, starts)])
    return (np.concatenate([part[0] for part in parts]), np.concatenate([part[1] for part in parts]), children,
            first.astype(np.uint32), np.concatenate([part[4] for part in parts]))


def row_weights(first):
    """Weights of the rows: every asset counts as much as any other."""
    sizes = np.diff(first.astype(np.int64))
    weights = np.repeat(1 / np.maximum(sizes, 1), sizes)
    return weights / weights.mean()


def grow(lab, features, target, first, count, rate, seed):
    """(columns, values) of the trees that give each row's log odds."""
    edges = bin_edges(features[::max(1, len(features) // EDGE_ROWS)])
    arrays = (first, put_into_bins(features, edges), np.log(row_weights(first)).astype(np.float32), target.astype(np.float32))
    return grow_trees(lab, arrays, edges, Rule(count, LEAVES, 8, rate, 2, 5, 0.6, 0.4, seed, 1), ", loss of an asset")


def probabilities(trees, features):
    """What dmi_tree_ensemble_probability answers for each row."""
    column, value = (array.astype(np.float32) for array in trees)
    features, total = features.astype(np.float32), np.zeros(len(features))
    every = np.arange(len(features))
    for columns, values in zip(column.astype(int), value):
        splits = columns >= 0
        left = np.where(splits, 1 + 2 * (np.cumsum(splits) - 1), np.arange(len(columns)))
        at = np.zeros(len(features), int)
        while splits[at].any():
            on = left[at] + (features[every, np.maximum(columns[at], 0)] > values[at])
            at = np.where(splits[at], on, at)
        total += values[at]
    return 1 / (1 + np.exp(-total))


def choose(moves, children, begin, end):
    """Rows of the chosen sets of one asset, as choose_bodies of asset_grouping.c takes them."""
    stated = np.interp(moves[begin:end], *STATED)
    worth, chosen, top = np.zeros(end - begin), [None] * (end - begin), np.ones(end - begin, bool)
    for row in range(begin, end):
        kids = [kid - begin for kid in children[row] if kid >= 0]
        top[kids] = False
        inside, own = sum(worth[kid] for kid in kids), stated[row - begin] - 0.5
        better = own > 0 and own >= inside
        worth[row - begin] = max(0, own, inside)
        chosen[row - begin] = [row] if better else sum((chosen[kid] for kid in kids), [])
    return sum((chosen[row] for row in np.flatnonzero(top)), [])


def score(trees, data):
    """Mean F1 of the movers of an asset, phantoms an asset, and how many assets in which nothing moves get a part."""
    features, overlap, children, first, movers = data
    moves, f1, phantoms, alarms = probabilities(trees, features), [], 0, []
    for begin, end, true in zip(first[:-1].astype(int), first[1:].astype(int), movers):
        rows = choose(moves, children, begin, end)
        found = int((overlap[rows] >= FOUND).sum()) if rows else 0
        phantoms += len(rows) - found
        if true or rows:
            f1.append(2 * found / (found + len(rows) - found + true))
        if not true:
            alarms.append(bool(rows))
    return f"F1 {np.mean(f1):.3f}, phantoms {phantoms / len(movers):.2f}, alarms {np.mean(alarms):.3f}"


def write(path, metadata, **ensembles):
    """Writes a file of ensembles; returns its bytes."""
    tensors = {f"{name}.{what}": array for name, pair in ensembles.items() for what, array in zip(("column", "value"), pair)}
    write_safetensors(path, tensors, metadata)
    with open(path, "rb") as file:
        return file.read()


def untrained(grown):
    """Trees that answer 0, of the ensembles that are not grown yet: a file needs all."""
    return {name: (np.full((count, 2 * LEAVES - 1), -1, np.float16), np.zeros((count, 2 * LEAVES - 1), np.float16))
            for name, count in TREES.items() if name not in grown}


def train_carriers(options, lab, metadata, grown):
    """Adds the trees that tell which body carries which to a file of the others, or replaces them."""
    grown = {name: pair for name, pair in grown.items() if name != "carriers"}
    weights, seed = write(options.out, metadata, **grown, **untrained(grown)), options.seed + 5
    mask, half = asset_weights(lab, "trained"), options.carriers // 2
    data = carriers.join([carriers.gather(options, mask, *of) for of in ((weights, half, seed), (None, half, seed + 1))])
    print(f"{len(data[0])} candidates for carriers", flush=True)
    grown["carriers"] = carriers.grow(lab, data, options.seed)
    write(options.out, metadata, **grown)
    held_out = carriers.gather(options, asset_weights(lab, "test_only"), weights, options.held_out, options.seed + 1005)
    print("kinds held out, carriers:", carriers.score(probabilities(grown["carriers"], held_out[0]), held_out), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--out", required=True)
    parser.add_argument("--pairs", type=int, default=5000, help="assets that the pairs are from")
    parser.add_argument("--sets", type=int, default=30000, help="assets that the sets are from")
    parser.add_argument("--context", type=int, default=8000, help="assets that the sets of each round in context are from")
    parser.add_argument("--carriers", type=int, default=8000, help="assets that the carriers are from")
    parser.add_argument("--only-carriers", action="store_true", help="keep the file but for its trees of carriers")
    parser.add_argument("--held-out", type=int, default=400, help="assets of the kinds that are not trained on")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--cache", help="folder that keeps the rows between runs")
    parser.add_argument("--lab", help="path of libdragmesh_lab.so")
    options = parser.parse_args()
    if options.cache:
        os.makedirs(options.cache, exist_ok=True)
    lab = open_lab(*([options.lab] if options.lab else []))
    if not options.lab:
        options.lab = lab._name
    if options.only_carriers:
        return train_carriers(options, lab, *carriers.read_ensembles(options.out))
    metadata = {"architecture": ARCHITECTURE, "version": "1", "commit": commit()}
    features, target, _, first, _ = gather(options, None, 0, "trained", options.pairs, options.seed)
    print(f"{len(features)} pairs", flush=True)
    grown = {"pairs": grow(lab, features, target, first, PAIR_TREES, PAIR_RATE, options.seed)}
    weights = write(options.out, metadata, **grown, **untrained(grown))
    own = lab.dm_lab_asset_set_columns() - lab.dm_lab_asset_context_columns()
    for stage, name in enumerate(("sets", *ROUNDS)):
        count, rounds = (options.sets, 1) if stage == 0 else (options.context, stage)
        features, overlap, _, first, _ = gather(options, weights, rounds, "trained", count, options.seed + 1 + stage)
        print(f"{len(features)} sets for {name}", flush=True)
        features = features[:, :own] if stage == 0 else features
        grown[name] = grow(lab, features, overlap >= FOUND, first, TREES[name], SET_RATE, options.seed)
        weights = write(options.out, metadata, **grown, **untrained(grown))
    for stage, name in enumerate(ROUNDS):
        held_out = gather(options, weights, stage + 1, "test_only", options.held_out, options.seed + 1000 + stage)
        print(f"kinds held out, {name}:", score(grown[name], held_out), flush=True)
    train_carriers(options, lab, metadata, grown)


if __name__ == "__main__":
    main()
