"""The part finder's growing: a small network that says whether a piece belongs to a part, fitted on generated objects.

    PYTHONPATH=training python3 -m dragmesh_training.growth [--count 4000] [-o sdk/kinematics/part_weights.h]

The held-out categories (config.py) are for the score; with --all they are trained on too.
"""
import argparse
import ctypes
import time

import numpy as np
import torch

from . import ranker
from .config import HELD_OUT

CAPACITY = 200000
HEADER = """/* Weights of the network that says whether a piece belongs to a growing part. Fitted on generated objects alone by
 * training/dragmesh_training/growth.py: not to be edited. */
#ifndef DMI_KINEMATICS_PART_WEIGHTS_H
#define DMI_KINEMATICS_PART_WEIGHTS_H

"""


class Batch(ctypes.Structure):
    _fields_ = [("capacity", ctypes.c_uint32)] + [
        (name, ctypes.c_void_p) for name in ("features", "belongs", "weight", "category", "count")]


def make(lab, seed, count, messy=0.5):
    """Features, labels, weights, category names of about `count` cases, in batches of 50."""
    names, parts = ranker.category_names(lab), []
    mask = np.ones(len(names), np.uint8)
    for first in range(0, count, 50):
        columns = lab.dm_lab_growth_columns()
        arrays = [np.zeros((CAPACITY, columns), np.float32), np.zeros(CAPACITY, np.float32),
                  np.zeros(CAPACITY, np.float32), np.zeros(CAPACITY, np.int32)]
        rows = ctypes.c_uint32()
        batch = Batch(CAPACITY, *[a.ctypes.data for a in arrays], ctypes.addressof(rows))
        options = ranker.Options(seed * 1000003 + first, min(50, count - first), 0, mask.ctypes.data, messy, 0, 1, 1, 8, 0, 0)
        result = lab.dm_lab_growth_batch(ctypes.byref(options), ctypes.byref(batch))
        if result != 0:
            raise RuntimeError(f"dm_lab_growth_batch: {result}")
        parts.append([a[:rows.value].copy() for a in arrays])
    features, belongs, weight, category = (np.concatenate(arrays) for arrays in zip(*parts))
    return features, belongs, weight, np.array(names)[category]


def fit(data, hidden, epochs):
    features, belongs, weight = (torch.tensor(array) for array in data[:3])
    mean, scale = features.mean(0), features.std(0) + 1e-6
    features = (features - mean) / scale
    network = torch.nn.Sequential(torch.nn.Linear(features.shape[1], hidden), torch.nn.ReLU(), torch.nn.Linear(hidden, 1))
    optimizer = torch.optim.AdamW(network.parameters(), 4e-3, weight_decay=1e-2)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimizer, epochs)
    for _ in range(epochs):
        for rows in torch.randperm(len(features)).split(512):
            noisy = features[rows] + 0.05 * torch.randn(len(rows), features.shape[1])
            losses = torch.nn.functional.binary_cross_entropy_with_logits(network(noisy)[:, 0], belongs[rows], reduction="none")
            loss = (losses * weight[rows]).sum() / weight[rows].sum()
            optimizer.zero_grad()
            loss.backward()
            optimizer.step()
        schedule.step()
    first, last = network[0], network[2]
    folded = first.weight.detach() / scale
    return [a.detach().numpy() for a in (folded, first.bias - folded @ mean, last.weight[0], last.bias)]


def right(model, data):
    features, belongs, weight = data[:3]
    score = np.maximum(features @ model[0].T + model[1], 0) @ model[2] + model[3]
    return float((((score > 0) == (belongs > 0.5)) * weight).sum() / weight.sum())


def literals(values):
    texts = [f"{float(value):.6g}" for value in values]
    return ", ".join((text if set(".e") & set(text) else text + ".0") + "f" for text in texts)


def write(path, model):
    rows = ",\n".join("    {" + literals(row) + "}" for row in model[0])
    with open(path, "w") as out:
        out.write(HEADER + f"#define DMI_PART_HIDDEN {len(model[0])}\n\n")
        out.write(f"static const float dmi_part_hidden[DMI_PART_HIDDEN][{model[0].shape[1]}] = {{\n{rows}}};\n")
        out.write(f"static const float dmi_part_hidden_bias[DMI_PART_HIDDEN] = {{{literals(model[1])}}};\n")
        out.write(f"static const float dmi_part_output[DMI_PART_HIDDEN] = {{{literals(model[2])}}};\n")
        out.write(f"static const float dmi_part_bias = {literals(model[3])};\n\n#endif\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=4000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--hidden", type=int, default=12)
    parser.add_argument("--epochs", type=int, default=12)
    parser.add_argument("--all", action="store_true", help="train on the held-out categories too")
    parser.add_argument("--lab", default="build/release/libdragmesh_lab.so")
    parser.add_argument("-o", help="the header to write")
    options = parser.parse_args()
    torch.manual_seed(options.seed)
    torch.set_num_threads(1)
    start = time.time()
    data = make(ranker.open_lab(options.lab), options.seed, options.count)
    held = np.isin(data[3], HELD_OUT)
    train = [array[~held | options.all] for array in data]
    print(f"{len(data[0])} pieces, {data[1].mean():.2f} of them belong; {time.time() - start:.0f} s")
    model = fit(train, options.hidden, options.epochs)
    print(f"right: {right(model, train):.3f}, in held-out categories {right(model, [a[held] for a in data]):.3f}")
    if options.o:
        write(options.o, model)


if __name__ == "__main__":
    main()
