"""Ranker examples from folders of object.glb + joints.json, in the file that dragmesh_training/ranker.py trains on.

  PYTHONPATH=training python3 -m dragmesh_training.loaders.examples DIR -o OUT.npz [--weights KPP.safetensors]
"""
import argparse
import ctypes
import sys

import numpy as np

from .. import cases
from ..files import save_arrays
from ..lab import open_lab
from . import objects
from .batches import given


def make_one(lab, case, drag, rows, with_drag, weights):
    """Features and labels of one case; None with the library's error on a case it refuses."""
    data = {"features": np.zeros((1, rows, lab.dm_lab_ranker_columns()), np.float32)}
    for name, dtype, each_row in cases.ARRAYS:
        data[name] = np.zeros((1, rows) if each_row else 1, dtype)
    batch = cases.Batch(rows, *[data[name].ctypes.data for name in ("features", *[a[0] for a in cases.ARRAYS])])
    size = ctypes.c_size_t(len(weights) if weights else 0)
    result = lab.dm_lab_ranker_given(ctypes.byref(given(case, drag)), with_drag, weights, size, ctypes.byref(batch))
    if result != 0:
        print(f"{case.name}: refused with {result}", file=sys.stderr)
        return None
    return data


def make(lab, folder, rows, with_drag, weights, seed=1):
    """All joints of a folder, a drag each; `with_drag` of them see it. The categories' names, and the arrays."""
    random, parts, names = np.random.default_rng(seed), [], []
    for case in objects.all_cases(folder):
        if not case.drags:
            continue
        drag = int(random.integers(len(case.drags)))
        data = make_one(lab, case, drag, rows, int(random.random() < with_drag), weights)
        if data is None:
            continue
        if case.category not in names:
            names.append(case.category)
        data["category"][:] = names.index(case.category)
        data["features"] = data["features"].astype(np.float16)
        parts.append(data)
    return names, {name: np.concatenate([part[name] for part in parts]) for name in parts[0]} if parts else {}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("-o", required=True, metavar="OUT.npz")
    parser.add_argument("--lab", default="build/release/libdragmesh_lab.so")
    parser.add_argument("--weights", help="KPP-Net whose predictions go into the features")
    parser.add_argument("--rows", type=int, default=32)
    parser.add_argument("--with-drag", type=float, default=0.7, help="share of the examples")
    options = parser.parse_args()
    weights = open(options.weights, "rb").read() if options.weights else None
    names, data = make(open_lab(options.lab), options.folder, options.rows, options.with_drag, weights)
    if not data:
        sys.exit(f"{options.folder}: no joint that the library takes")
    save_arrays(options.o, names=np.array(names), **data)
    print(f"{len(data['type'])} examples of {len(names)} categories")


if __name__ == "__main__":
    main()
