"""The prefilter before the ranker (sdk/kinematics/ranking/candidate_prefilter.c): features of cases whose candidates were all
evaluated in, its weights out.

    python -m dragmesh_training.prefilter ALL.npz MORE.npz -o prefilter.safetensors

It learns from the cheap features to share a probability as the ranker does, but more sharply: one candidate that is right has
to come through, those like it need not. It is scored on one case in ten, and on the held-out kinds: how many of the right
joints are among the best.
"""
import argparse
import time

import numpy as np

from .cases import KEPT_BEST, costs, load, log_weights
from .config import HELD_OUT
from .features import CHEAP, NETWORK

HIDDEN, KEPT = 16, 256  # as in candidate_prefilter.h
STEPS = 2500
SHARPER = 0.3  # of the ranker's costs: what differs by a third of a tolerance is told apart
WITHOUT_NETWORK = 0.2  # share of cases without KPP-Net's features


def fit(data, cost, steps, batch, rate, seed):
    """net((cheap features - mean) * scale) is a candidate's score."""
    import torch
    from .descent import descend, listwise_loss
    torch.manual_seed(seed)
    torch.set_num_threads(1)
    random, every_row = np.random.default_rng(seed), np.arange(data["pose"].shape[1])
    flat = data["features"][:800][data["used"][:800, None] > every_row].astype(np.float32)
    mean, scale = torch.from_numpy(flat.mean(0)), 1 / (torch.from_numpy(flat.std(0)) + 0.05)
    net = torch.nn.Sequential(torch.nn.Linear(len(CHEAP), HIDDEN), torch.nn.ReLU(),
                              torch.nn.Linear(HIDDEN, 1, bias=False))
    of_network = np.isin(CHEAP, NETWORK)

    def loss_of(_):
        index = random.integers(0, len(cost), batch)
        features = data["features"][index].astype(np.float32)
        features[np.ix_(random.random(batch) < WITHOUT_NETWORK, every_row, of_network)] = 0
        extra = log_weights(np.tile(every_row, (batch, 1)), data["used"][index], data["total"][index])
        score = net((torch.from_numpy(features) - mean) * scale)[..., 0]
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
        features = torch.from_numpy(data["features"].astype(np.float32))
        score = np.where(real, net((features - mean) * scale)[..., 0].numpy(), -np.inf)
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
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", nargs="+")
    parser.add_argument("--steps", type=int, default=STEPS)
    parser.add_argument("--batch", type=int, default=64)
    parser.add_argument("--rate", type=float, default=3e-3)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-o", "--out", required=True)
    arguments = parser.parse_args(words)
    from .export import perceptron_tensors, write_joint_models
    start = time.time()
    data, names = load(arguments.data), np.load(arguments.data[0])["names"]
    data["cost"] = costs(data) / SHARPER
    data["features"] = data["features"][:, :, CHEAP]
    held = np.isin(names[data["category"]], HELD_OUT)
    tenth = ~held & (np.arange(len(held)) % 10 == 0)
    part = {name: {key: array[mask] for key, array in data.items()}
            for name, mask in (("trained", ~held & ~tenth), ("validation", tenth), ("held-out kinds", held))}
    trained = part["trained"]
    net, mean, scale = fit(trained, trained["cost"], arguments.steps, arguments.batch, arguments.rate, arguments.seed)
    for name in ("validation", "held-out kinds"):
        report(net, mean, scale, part[name], name)
    tensors = {"prefilter.mean": mean.numpy(), "prefilter.scale": scale.numpy(), **perceptron_tensors("prefilter", net)}
    write_joint_models(arguments.out, tensors, {"architecture": "dragmesh-prefilter", "version": "1",
                                                "seed": str(arguments.seed),
                                                "trained": f"{len(trained['used'])} generated cases"})
    print(f"{time.time() - start:.0f} s", flush=True)


if __name__ == "__main__":
    run()
