"""The part finder's two small networks, fitted on generated objects: whether a piece of surface belongs to the part that
was grabbed, and which of the proposals that growing by it makes is the part.

    PYTHONPATH=training python3 -m dragmesh_training.growth -o sdk/segmentation/part_weights.h

makes weights like the shipped ones from its defaults alone (docs/accuracy.md says what was otherwise then). The categories
held out (config.py) are not trained on: they are for the score. Cases can be kept between runs (--cache FOLDER).
"""
import argparse
import ctypes
import functools
import os
import textwrap
import time

import numpy as np
import torch

from .config import HELD_OUT
from .lab import Options, category_weights, chosen_kinds, kinds, open_lab

BATCH = 50  # cases
CAPACITY = 200000  # pieces of a batch
FOUND = 0.8  # overlap with the true part from which it counts as found
CUT = 6  # the feature of a proposal that says whether the grabbed sheet was cut for it
CUT_SHARE = 0.2  # weight of a case whose part no proposal of whole sheets is: most people's meshes keep parts apart
HEADER = """/* Weights of the part finder's two networks: whether a piece belongs to a growing part, and which proposal is the part.
 * Fitted on generated objects alone by training/dragmesh_training/growth.py: not to be edited. */
#ifndef DMI_KINEMATICS_PART_WEIGHTS_H
#define DMI_KINEMATICS_PART_WEIGHTS_H

#include "kinematics/part_growth.h"

/* clang-format off */
"""


class Batch(ctypes.Structure):
    _fields_ = [("capacity", ctypes.c_uint32)] + [
        (name, ctypes.c_void_p) for name in ("features", "belongs", "weight", "category", "count")]


class Net(ctypes.Structure):
    _fields_ = [("inputs", ctypes.c_uint32), ("hidden", ctypes.c_uint32)] + [
        (name, ctypes.c_void_p) for name in ("weights", "biases", "outputs")] + [("bias", ctypes.c_float)]


class Choice(ctypes.Structure):
    _fields_ = [(name, ctypes.c_void_p) for name in ("features", "overlap", "used", "category")]


def cases(seed, first, count, mask, messy):
    return Options(seed * 1000003 + first, count, 0, mask.ctypes.data, messy, 0, 1, 1, 8, 0, 0)


def make_pieces(lab, seed, first, count, mask, messy):
    """Features, labels, weights, category of the pieces that touched growing parts of a few cases."""
    arrays = [np.zeros((CAPACITY, lab.dm_lab_growth_columns()), np.float32), np.zeros(CAPACITY, np.float32),
              np.zeros(CAPACITY, np.float32), np.zeros(CAPACITY, np.int32)]
    rows = ctypes.c_uint32()
    batch = Batch(CAPACITY, *[a.ctypes.data for a in arrays], ctypes.addressof(rows))
    options = cases(seed, first, count, mask, messy)
    result = lab.dm_lab_growth_batch(ctypes.byref(options), ctypes.byref(batch))
    if result != 0:
        raise RuntimeError(f"dm_lab_growth_batch: {result}")
    return [a[:rows.value].copy() for a in arrays]


def make_proposals(lab, model, seed, first, count, mask, messy):
    """Features, overlaps, numbers and category of the proposals of a few cases."""
    weights = [np.ascontiguousarray(a, np.float32) for a in model[:3]]
    net = Net(weights[0].shape[1], weights[0].shape[0], *[a.ctypes.data for a in weights], float(model[3]))
    most, columns = lab.dm_lab_choice_most(), lab.dm_lab_choice_columns()
    arrays = [np.zeros((count, most, columns), np.float32), np.zeros((count, most), np.float32),
              np.zeros(count, np.int32), np.zeros(count, np.int32)]
    options = cases(seed, first, count, mask, messy)
    choice = Choice(*[a.ctypes.data for a in arrays])
    result = lab.dm_lab_choice_batch(ctypes.byref(options), ctypes.byref(net), ctypes.byref(choice))
    if result != 0:
        raise RuntimeError(f"dm_lab_choice_batch: {result}")
    return arrays


def gather(lab, folder, name, count, make, messy=0.6):
    """Arrays of `count` cases, in batches that are kept in the folder when there is one."""
    mask = category_weights(lab, chosen_kinds(lab, "trained"))
    parts, start = [], time.time()
    for first in range(0, count, BATCH):
        path = folder and os.path.join(folder, f"{name}_{first}.npz")
        if path and os.path.exists(path):
            with np.load(path) as held:
                parts.append([held[key] for key in held.files])
            continue
        parts.append(make(first, min(BATCH, count - first), mask, messy))
        if path:
            np.savez(path, *parts[-1])
    data = [np.concatenate(arrays) for arrays in zip(*parts)]
    print(f"{name}: {len(data[0])} rows of {count} cases, {time.time() - start:.0f} s", flush=True)
    return data


def network(inputs, hidden):
    return torch.nn.Sequential(torch.nn.Linear(inputs, hidden), torch.nn.ReLU(), torch.nn.Linear(hidden, 1))


def descend(net, rows, epochs, batch, loss_of, decay=1e-2):
    optimizer = torch.optim.AdamW(net.parameters(), 4e-3, weight_decay=decay)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimizer, epochs)
    for _ in range(epochs):
        for chosen in torch.randperm(rows).split(batch):
            loss = loss_of(chosen)
            optimizer.zero_grad()
            loss.backward()
            optimizer.step()
        schedule.step()


def folded(net, mean, scale):
    """Weights for features as they are."""
    first, last = net[0], net[2]
    weights = first.weight.detach() / scale
    return [a.detach().numpy() for a in (weights, first.bias - weights @ mean, last.weight[0], last.bias[0])]


def fit_growth(data, hidden, epochs):
    features, belongs, weight = (torch.tensor(array) for array in data[:3])
    mean, scale = features.mean(0), features.std(0) + 1e-3
    features = (features - mean) / scale
    net = network(features.shape[1], hidden)

    def loss(rows):
        noisy = features[rows] + 0.05 * torch.randn(len(rows), features.shape[1])
        losses = torch.nn.functional.binary_cross_entropy_with_logits(net(noisy)[:, 0], belongs[rows], reduction="none")
        return (losses * weight[rows]).sum() / weight[rows].sum()

    descend(net, len(features), epochs, 512, loss)
    return folded(net, mean, scale)


def fit_choice(data, hidden, steps):
    """The softmax over a case's proposals puts its mass on those that are the part."""
    features, overlap, used = (torch.tensor(array) for array in data[:3])
    there = torch.arange(features.shape[1])[None] < used[:, None]
    known = (((overlap >= FOUND) & there).any(1)).nonzero()[:, 0]  # cases that have an answer
    features, overlap, there = features[known], overlap[known], there[known]
    whole = ((overlap >= FOUND) & there & (features[:, :, CUT] == 0)).any(1)
    weight = torch.where(whole, torch.ones(()), torch.full((), CUT_SHARE))
    mean, scale = features[there].mean(0), features[there].std(0) + 1e-3
    features = (features - mean) / scale
    good = torch.where(there, ((overlap - 0.7) / 0.2).clamp(0, 1), torch.zeros(()))
    net = network(features.shape[2], hidden)

    def loss(rows):
        noisy = features[rows] + 0.5 * torch.randn(features[rows].shape)
        share = torch.softmax(net(noisy)[..., 0].masked_fill(~there[rows], -1e9), 1)
        losses = -((share * good[rows]).sum(1) + 1e-4).log()
        return (losses * weight[rows]).sum() / weight[rows].sum()

    descend(net, len(features), 1 + steps * 128 // len(features), 128, loss, 0.1)
    return folded(net, mean, scale)


def side_by_side(models):
    """One network that answers the mean of several."""
    weights, biases, outputs, bias = zip(*models)
    return [np.concatenate(weights), np.concatenate(biases), np.concatenate(outputs) / len(models),
            np.mean(bias, dtype=np.float32)]


def score(model, features):
    return np.maximum(features @ model[0].T + model[1], 0) @ model[2] + model[3]


def right(model, data):
    features, belongs, weight = data[:3]
    return float((((score(model, features) > 0) == (belongs > 0.5)) * weight).sum() / weight.sum())


def found(model, data):
    """Shares of cases in which the chosen proposal, and in which any, is the part."""
    features, overlap, used = data[:3]
    there = np.arange(features.shape[1])[None] < used[:, None]
    best = np.where(there, score(model, features), -np.inf).argmax(1)
    hit = overlap[np.arange(len(best)), best] >= FOUND
    return float(hit[used > 0].sum() / len(used)), float(((overlap >= FOUND) & there).any(1).mean())


def literals(values):
    texts = [f"{float(value):.5g}" for value in values]
    return ", ".join((text if set(".e") & set(text) else text + ".0") + "f" for text in texts)


def write_array(out, name, values):
    out.write(f"static const float {name}[] = {{\n")
    out.write(textwrap.fill(literals(values), 120, initial_indent="    ", subsequent_indent="    ") + "};\n")


def write(path, models):
    with open(path, "w") as out:
        out.write(HEADER)
        for name, model in models.items():
            hidden, inputs = model[0].shape
            for part, values in zip(("weights", "biases", "outputs"), model):
                write_array(out, f"dmi_part_{name}_{part}", np.ravel(values))
            out.write(f"static const dmi_part_net dmi_part_{name}_net = {{\n    {inputs}, {hidden}, dmi_part_{name}_weights, "
                      f"dmi_part_{name}_biases, dmi_part_{name}_outputs, {literals([model[3]])}}};\n\n")
        out.write("/* clang-format on */\n#endif\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=1500, help="cases for growing")
    parser.add_argument("--choices", type=int, default=7000, help="cases for choosing")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--hidden", type=int, default=16)
    parser.add_argument("--epochs", type=int, default=10)
    parser.add_argument("--choosers", type=int, default=3, help="networks that choose by the mean of their scores")
    parser.add_argument("--choice-hidden", type=int, default=48)
    parser.add_argument("--steps", type=int, default=1000, help="of fitting one of them")
    parser.add_argument("--cache", help="folder to keep the cases in")
    parser.add_argument("--lab", default="build/release/libdragmesh_lab.so")
    parser.add_argument("-o", help="the header to write")
    options = parser.parse_args()
    torch.manual_seed(options.seed)
    torch.set_num_threads(1)
    lab = open_lab(options.lab)
    held = [kind.id for kind in kinds(lab) if kind.name in HELD_OUT]

    pieces = gather(lab, options.cache, "pieces", options.count, functools.partial(make_pieces, lab, options.seed))
    new = np.isin(pieces[3], held)
    growth = fit_growth([a[~new] for a in pieces], options.hidden, options.epochs)
    print(f"growing, right: {right(growth, [a[~new] for a in pieces]):.3f} of the pieces, "
          f"{right(growth, [a[new] for a in pieces]):.3f} in the categories held out", flush=True)

    proposals = gather(lab, options.cache, "proposals", options.choices,
                       functools.partial(make_proposals, lab, growth, options.seed + 1))
    new = np.isin(proposals[3], held)
    choice = side_by_side([fit_choice([a[~new] for a in proposals], options.choice_hidden, options.steps)
                           for _ in range(options.choosers)])
    for name, rows in ("trained on", ~new), ("held out", new):
        print("choosing, found, and among the proposals: {:.3f} {:.3f}".format(*found(choice, [a[rows] for a in proposals])),
              f"in the categories {name}", flush=True)
    if options.o:
        write(options.o, {"growth": growth, "choice": choice})


if __name__ == "__main__":
    main()
