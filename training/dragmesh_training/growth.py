"""The part finder's two networks, fitted on generated objects: one rates whether a piece of surface belongs to the part that was
grabbed, the other which of the proposals that growing by it makes is the part.

    PYTHONPATH=training python3 -m dragmesh_training.growth -o sdk/models/part_finder.safetensors

makes weights like the shipped ones from its defaults alone. The kinds of HELD_OUT (config.py) are not trained on: they are for
the score. Cases can be kept between runs (--cache FOLDER). The library embeds the file: build it again (scripts/build).
"""
import argparse
import copy
import ctypes
import functools
import os
import time

import numpy as np
import torch

from .config import HELD_OUT
from .export import commit, perceptron_tensors, write_safetensors
from .files import save_arrays
from .lab import Options, category_weights, chosen_kinds, kinds, open_lab

BATCH = 50  # cases
CAPACITY = 200000  # neighbours of a batch
FOUND = 0.8  # overlap with the true part from which it counts as found
CUT_SHARE = 0.2  # weight of a case whose part no proposal of whole sheets is: most people's meshes keep parts apart
# As in sdk/segmentation/part_networks.c. Networks that choose by the mean of their scores are written as one.
GROWTH_HIDDEN, CHOICE_HIDDEN, CHOICE_MEMBERS = 16, 48, 3


class Batch(ctypes.Structure):
    _fields_ = [("capacity", ctypes.c_uint32)] + [
        (name, ctypes.c_void_p) for name in ("features", "belongs", "weight", "category", "count")]


class Choice(ctypes.Structure):
    _fields_ = [(name, ctypes.c_void_p) for name in ("features", "overlap", "used", "category")]


def cases(seed, first, count, mask, messy):
    return Options(seed * 1000003 + first, count, 0, mask.ctypes.data, messy, 0, 1, 1, 8, 0, 0)


def make_neighbours(lab, seed, first, count, mask, messy):
    """Features, labels, weights and categories of the neighbours of growing regions in a few cases."""
    arrays = [np.zeros((CAPACITY, lab.dm_lab_growth_columns()), np.float32), np.zeros(CAPACITY, np.float32),
              np.zeros(CAPACITY, np.float32), np.zeros(CAPACITY, np.int32)]
    rows = ctypes.c_uint32()
    batch = Batch(CAPACITY, *[a.ctypes.data for a in arrays], ctypes.addressof(rows))
    options = cases(seed, first, count, mask, messy)
    result = lab.dm_lab_growth_batch(ctypes.byref(options), ctypes.byref(batch))
    if result != 0:
        raise RuntimeError(f"dm_lab_growth_batch: {result}")
    return [a[:rows.value].copy() for a in arrays]


def make_proposals(lab, weights, seed, first, count, mask, messy):
    """Features, overlaps, numbers and categories of the proposals of a few cases. weights: bytes of the growth network's file."""
    most, columns = lab.dm_lab_choice_most(), lab.dm_lab_choice_columns()
    arrays = [np.zeros((count, most, columns), np.float32), np.zeros((count, most), np.float32),
              np.zeros(count, np.int32), np.zeros(count, np.int32)]
    options = cases(seed, first, count, mask, messy)
    choice = Choice(*[a.ctypes.data for a in arrays])
    result = lab.dm_lab_choice_batch(ctypes.byref(options), weights, ctypes.c_size_t(len(weights)), ctypes.byref(choice))
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
            save_arrays(path, *parts[-1])
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
    """The network for features that are not standardised."""
    out = copy.deepcopy(net)
    with torch.no_grad():
        out[0].weight /= scale
        out[0].bias -= out[0].weight @ mean
    return out


def fit_growth(data, epochs):
    features, belongs, weight = (torch.tensor(array) for array in data[:3])
    mean, scale = features.mean(0), features.std(0) + 1e-3
    features = (features - mean) / scale
    net = network(features.shape[1], GROWTH_HIDDEN)

    def loss(rows):
        noisy = features[rows] + 0.05 * torch.randn(len(rows), features.shape[1])
        losses = torch.nn.functional.binary_cross_entropy_with_logits(net(noisy)[:, 0], belongs[rows], reduction="none")
        return (losses * weight[rows]).sum() / weight[rows].sum()

    descend(net, len(features), epochs, 512, loss)
    return folded(net, mean, scale)


def fit_choice(data, cut_column, steps):
    """The softmax over a case's proposals puts its mass on those that are the part. cut_column: the feature that says whether the
    grabbed sheet was cut for a proposal."""
    features, overlap, used = (torch.tensor(array) for array in data[:3])
    there = torch.arange(features.shape[1])[None] < used[:, None]
    known = (((overlap >= FOUND) & there).any(1)).nonzero()[:, 0]  # cases that have an answer
    features, overlap, there = features[known], overlap[known], there[known]
    whole = ((overlap >= FOUND) & there & (features[:, :, cut_column] == 0)).any(1)
    weight = torch.where(whole, torch.ones(()), torch.full((), CUT_SHARE))
    mean, scale = features[there].mean(0), features[there].std(0) + 1e-3
    features = (features - mean) / scale
    good = torch.where(there, ((overlap - 0.7) / 0.2).clamp(0, 1), torch.zeros(()))
    net = network(features.shape[2], CHOICE_HIDDEN)

    def loss(rows):
        noisy = features[rows] + 0.5 * torch.randn(features[rows].shape)
        share = torch.softmax(net(noisy)[..., 0].masked_fill(~there[rows], -1e9), 1)
        losses = -((share * good[rows]).sum(1) + 1e-4).log()
        return (losses * weight[rows]).sum() / weight[rows].sum()

    descend(net, len(features), 1 + steps * 128 // len(features), 128, loss, 0.1)
    return folded(net, mean, scale)


def side_by_side(nets):
    """One network that answers the mean of several."""
    out = network(nets[0][0].in_features, sum(net[0].out_features for net in nets))
    with torch.no_grad():
        out[0].weight.copy_(torch.cat([net[0].weight for net in nets]))
        out[0].bias.copy_(torch.cat([net[0].bias for net in nets]))
        out[2].weight.copy_(torch.cat([net[2].weight for net in nets], 1) / len(nets))
        out[2].bias.copy_(torch.stack([net[2].bias for net in nets]).mean(0))
    return out


def score(net, features):
    with torch.no_grad():
        return net(torch.from_numpy(features))[..., 0].numpy()


def right(net, data):
    features, belongs, weight = data[:3]
    return float((((score(net, features) > 0) == (belongs > 0.5)) * weight).sum() / weight.sum())


def found(net, data):
    """Shares of cases in which the chosen proposal, and in which any, is the part."""
    features, overlap, used = data[:3]
    there = np.arange(features.shape[1])[None] < used[:, None]
    best = np.where(there, score(net, features), -np.inf).argmax(1)
    hit = overlap[np.arange(len(best)), best] >= FOUND
    return float(hit[used > 0].sum() / len(used)), float(((overlap >= FOUND) & there).any(1).mean())


def write(path, networks, metadata):
    tensors = {}
    for name, net in networks.items():
        tensors.update(perceptron_tensors(name, net))
    write_safetensors(path, tensors, {"architecture": "dragmesh-part-finder", "version": "1", "commit": commit(), **metadata})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=1500, help="cases for growing")
    parser.add_argument("--choices", type=int, default=7000, help="cases for choosing")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--epochs", type=int, default=10)
    parser.add_argument("--steps", type=int, default=1000, help="of fitting one of the networks that choose")
    parser.add_argument("--cache", help="folder to keep the cases in")
    parser.add_argument("--lab", default="build/release/libdragmesh_lab.so")
    parser.add_argument("-o", "--out", required=True, help="the weights file to write")
    options = parser.parse_args()
    torch.manual_seed(options.seed)
    torch.set_num_threads(1)
    lab = open_lab(options.lab)
    held = [kind.id for kind in kinds(lab) if kind.name in HELD_OUT]
    metadata = {"seed": str(options.seed),
                "trained": f"{options.count} generated cases for growing, {options.choices} for choosing"}

    pieces = gather(lab, options.cache, "pieces", options.count, functools.partial(make_neighbours, lab, options.seed))
    new = np.isin(pieces[3], held)
    growth = fit_growth([a[~new] for a in pieces], options.epochs)
    print(f"growing, right: {right(growth, [a[~new] for a in pieces]):.3f} of the pieces, "
          f"{right(growth, [a[new] for a in pieces]):.3f} in the categories held out", flush=True)

    write(options.out, {"growth": growth}, metadata)
    with open(options.out, "rb") as file:
        weights = file.read()
    proposals = gather(lab, options.cache, "proposals", options.choices,
                       functools.partial(make_proposals, lab, weights, options.seed + 1))
    new = np.isin(proposals[3], held)
    choice = side_by_side([fit_choice([a[~new] for a in proposals], lab.dm_lab_choice_cut_column(), options.steps)
                           for _ in range(CHOICE_MEMBERS)])
    for name, rows in (("trained on", ~new), ("held out", new)):
        print("choosing, found, and among the proposals: {:.3f} {:.3f}".format(*found(choice, [a[rows] for a in proposals])),
              f"in the categories {name}", flush=True)
    write(options.out, {"growth": growth, "choice": choice}, metadata)


if __name__ == "__main__":
    main()
