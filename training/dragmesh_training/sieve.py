"""The sieve before the ranker (sdk/kinematics/ranking/candidate_prefilter.c): evidence of cases whose candidates all were judged in, its weights out.

    python -m dragmesh_training.sieve ALL.npz MORE.npz -o sieve.safetensors

It learns from the columns that a glance fills to share a probability as the ranker does, but more sharply: one candidate that
is right has to come through, its like need not. One case in ten, and the kinds held out, say how many of the right
joints are among the best.
"""
import argparse
import ctypes
import time

import numpy as np

from .cases import KEPT_BEST, NETWORK, costs, load, log_weights
from .config import HELD_OUT
from .lab import LAB, open_lab

HIDDEN, KEPT = 16, 256  # as in sieve.h
STEPS = 2500
SHARPER = 0.3  # of the ranker's costs: what differs by a third of a tolerance is told apart
WITHOUT_NETWORK = 0.2


def glance_columns(lab):
    columns = np.zeros(lab.dm_lab_sieve_columns(None), np.uint8)
    lab.dm_lab_sieve_columns(columns.ctypes.data_as(ctypes.POINTER(ctypes.c_uint8)))
    return columns.astype(np.int64)


def fit(data, columns, steps, batch, rate, seed):
    """net((glance - mean) * scale) is a candidate's score."""
    import torch
    from .descent import descend, listwise_loss
    torch.manual_seed(seed)
    torch.set_num_threads(1)
    random, cost, everything = np.random.default_rng(seed), costs(data) / SHARPER, np.arange(data["pose"].shape[1])
    flat = data["evidence"][:800][data["used"][:800, None] > everything].astype(np.float32)
    mean, scale = torch.from_numpy(flat.mean(0)), 1 / (torch.from_numpy(flat.std(0)) + 0.05)
    net = torch.nn.Sequential(torch.nn.Linear(len(columns), HIDDEN), torch.nn.ReLU(),
                              torch.nn.Linear(HIDDEN, 1, bias=False))
    of_network = np.isin(columns, NETWORK)

    def loss_of(_):
        index = random.integers(0, len(cost), batch)
        evidence = data["evidence"][index].astype(np.float32)
        evidence[np.ix_(random.random(batch) < WITHOUT_NETWORK, everything, of_network)] = 0
        extra = log_weights(np.tile(everything, (batch, 1)), data["used"][index], data["total"][index])
        score = net((torch.from_numpy(evidence) - mean) * scale)[..., 0]
        return listwise_loss(score, torch.from_numpy(extra), torch.from_numpy(cost[index]))

    descend(net, steps, rate, 2e-5, 1e-2, 0.005, loss_of)
    return net, mean, scale


def ranks(net, mean, scale, data, good):
    """How many candidates of each case come before the first that is good to `good`; NaN where none is. The rows that were
    drawn stand for all."""
    import torch
    used, total = data["used"][:, None], data["total"]
    real = np.arange(data["pose"].shape[1]) < used
    with torch.no_grad():
        evidence = torch.from_numpy(data["evidence"].astype(np.float32))
        score = np.where(real, net((evidence - mean) * scale)[..., 0].numpy(), -np.inf)
    right = (data["pose"] < good) & real
    before = score > np.where(right, score, -np.inf).max(1, keepdims=True)
    each = np.maximum(total - KEPT_BEST, 1) / np.maximum(used[:, 0] - KEPT_BEST, 1)
    rank = before[:, :KEPT_BEST].sum(1) + each * before[:, KEPT_BEST:].sum(1)
    return np.where(right.any(1), rank, np.nan)


def report(net, mean, scale, data, what):
    for good in (0.02, 0.01):
        rank = ranks(net, mean, scale, data, good)
        rank = rank[~np.isnan(rank)]
        print(f"{what}: of the joints with a candidate within {100 * good:.0f} % one is among the best " +
              ", ".join(f"{kept} in {(rank < kept).mean():.4f}" for kept in (KEPT // 2, KEPT, 3 * KEPT // 2)), flush=True)


def run(words=None):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("data", nargs="+")
    parser.add_argument("--lab", default=LAB)
    parser.add_argument("--steps", type=int, default=STEPS)
    parser.add_argument("--batch", type=int, default=64)
    parser.add_argument("--rate", type=float, default=3e-3)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-o", "--out", required=True)
    arguments = parser.parse_args(words)
    from .export import write_ranker_tensors
    columns, start = glance_columns(open_lab(arguments.lab)), time.time()
    everything, names = load(arguments.data), np.load(arguments.data[0])["names"]
    everything["evidence"] = everything["evidence"][:, :, columns]  # the first is the type, as before
    held = np.isin(names[everything["category"]], HELD_OUT)
    tenth = ~held & (np.arange(len(held)) % 10 == 0)
    part = {name: {key: array[mask] for key, array in everything.items()}
            for name, mask in (("trained", ~held & ~tenth), ("validation", tenth), ("held-out kinds", held))}
    net, mean, scale = fit(part["trained"], columns, arguments.steps, arguments.batch, arguments.rate, arguments.seed)
    for name in ("validation", "held-out kinds"):
        report(net, mean, scale, part[name], name)
    state = net.state_dict()
    tensors = {"mean": mean, "scale": scale, "0.weight": state["0.weight"], "0.bias": state["0.bias"],
               "2.weight": state["2.weight"]}
    write_ranker_tensors(arguments.out, {f"sieve.{name}": tensor.numpy() for name, tensor in tensors.items()},
           {"architecture": "dragmesh-sieve", "version": "1", "seed": str(arguments.seed),
            "trained": f"{len(part['trained']['used'])} generated cases"})
    print(f"{time.time() - start:.0f} s", flush=True)


if __name__ == "__main__":
    run()
