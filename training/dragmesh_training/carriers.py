"""The trees that tell which body of an asset carries which (sdk/assets/carrier_choice.c): a softmax over what may carry a body.

training/dragmesh_training/assets.py fits them with its other trees, or alone (--only-carriers). Half of the assets have the bodies
that the library finds, phantoms among them; the others have the true bodies.
"""
import ctypes
import json
import multiprocessing
import os
import struct

import numpy as np

from .boosted_trees import Rule, bin_edges, grow_trees, put_into_bins
from .files import save_arrays
from .lab import Options, open_lab

TREES, LEAVES, MOST_LEAVES = 100, 16, 32  # as in sdk/assets/asset_models.c; the file has room for MOST_LEAVES
RATE = 0.05  # shrinkage of each tree's leaves, on kinds held out
STAYS_LOG_ODDS = 1.25  # by which what stays is likelier in training than in answers, where bodies that parts carry are to be found
BATCH = 50  # assets
CAPACITY, CASES = 200000, 20000  # rows and bodies of a batch
BY_BODY, BY_PART, BY_OTHERS = range(3)  # DM_LAB_CARRIED_*


class CarrierRows(ctypes.Structure):
    """dm_lab_carrier_rows."""
    _fields_ = [("capacity", ctypes.c_uint32), ("case_capacity", ctypes.c_uint32)] + [
        (name, ctypes.c_void_p) for name in ("features", "target", "first", "carried", "asset")] + [
        ("case_count", ctypes.c_uint32), ("missed", ctypes.c_uint32)]


def read_ensembles(path):
    """(metadata, {name: (columns, values)}) of a file of ensembles, with the bytes that it has."""
    with open(path, "rb") as file:
        header = json.loads(file.read(struct.unpack("<Q", file.read(8))[0]))
        data = file.read()
    metadata, ensembles = header.pop("__metadata__"), {}
    for tensor, entry in header.items():
        begin, end = entry["data_offsets"]
        array = np.frombuffer(data[begin:end], {"F16": np.float16, "F32": np.float32}[entry["dtype"]]).reshape(entry["shape"])
        ensembles.setdefault(tensor.rsplit(".", 1)[0], {})[tensor.rsplit(".", 1)[1]] = array
    return metadata, {name: (pair["column"], pair["value"]) for name, pair in ensembles.items()}


def make_batch(task):
    """Features, targets, first rows, what the bodies hang on, and their assets, of BATCH assets; from the cache when it is there.
    weights: bytes of the trees that find the bodies; None: they are the true ones."""
    library, weights, mask, seed, path = task
    if path and os.path.exists(path):
        with np.load(path) as held:
            return [held[key] for key in held.files]
    lab = open_lab(library)
    options = Options(seed, BATCH, 0, mask.ctypes.data, 0.3)
    features, target = np.zeros((CAPACITY, lab.dm_lab_carrier_columns()), np.float32), np.zeros(CAPACITY, np.float32)
    first, carried, asset = np.zeros(CASES + 1, np.uint32), np.zeros(CASES, np.uint32), np.zeros(CASES, np.uint32)
    rows = CarrierRows(CAPACITY, CASES, *[array.ctypes.data for array in (features, target, first, carried, asset)])
    result = lab.dm_lab_carriers(ctypes.byref(options), weights, ctypes.c_size_t(len(weights or b"")), ctypes.byref(rows))
    if result != 0:
        raise RuntimeError(f"dm_lab_carriers: {result}")
    cases, used = rows.case_count, first[rows.case_count]
    arrays = features[:used].astype(np.float16), target[:used], first[:cases + 1], carried[:cases], asset[:cases]
    if path:
        save_arrays(path, *arrays)
    return arrays


def gather(options, mask, weights, count, seed):
    """Arrays of `count` assets, made side by side. weights: as of make_batch."""
    name = f"carriers_{'true' if weights is None else 'found'}_{seed}"
    tasks = [(options.lab, weights, mask, seed * 1000003 + batch,
              options.cache and os.path.join(options.cache, f"{name}_{batch}.npz")) for batch in range(count // BATCH)]
    with multiprocessing.Pool(options.workers) as pool:
        return join(pool.map(make_batch, tasks, chunksize=1))


def join(parts):
    """One set of arrays of several."""
    starts = np.cumsum([0] + [len(part[0]) for part in parts])
    first = np.concatenate([part[2][:-1] + start for part, start in zip(parts, starts)] + [starts[-1:]])
    assets = np.concatenate([part[4].astype(np.int64) + BATCH * index for index, part in enumerate(parts)])
    return (*(np.concatenate([part[k] for part in parts]) for k in (0, 1)), first.astype(np.uint32),
            np.concatenate([part[3] for part in parts]), assets)


def grow(lab, data, seed):
    """(columns, values) of the trees that score each row."""
    features, target, first, _, _ = data
    edges, prior = bin_edges(features), np.zeros(len(features), np.float32)
    prior[first[1:].astype(int) - 1] = STAYS_LOG_ODDS  # what stays is a body's last candidate
    arrays = (first, put_into_bins(features, edges), prior, target)
    trees = grow_trees(lab, arrays, edges, Rule(TREES, LEAVES, 8, RATE, 5, 2, 0.6, 0.4, seed), ", loss of a body")
    room = [(0, 0), (0, 2 * (MOST_LEAVES - LEAVES))]
    return tuple(np.pad(array, room, constant_values=unused) for array, unused in zip(trees, (-1, 0)))


def score(scores, data):
    """Shares of the bodies whose carrier has the highest score: of all of an asset, and of those that a part carries. A carrier that
    is not among the bodies counts as wrong."""
    _, target, first, carried, assets = data
    right = np.array([target[begin + np.argmax(scores[begin:end])] for begin, end in zip(first[:-1], first[1:])])
    right = np.where(carried == BY_OTHERS, 0, right)

    def mean(chosen):
        return np.mean([right[chosen & (assets == asset)].mean() for asset in np.unique(assets[chosen])])

    return f"carrier right {mean(carried >= 0):.3f}, of parts carried by a part {mean(carried != BY_BODY):.3f}"
