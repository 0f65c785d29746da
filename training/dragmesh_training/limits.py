"""The limits' network (sdk/kinematics/limit_net.c): what a sweep tells of generated joints in, its weights out.

    python -m dragmesh_training.limits make OUT.npz --weights KPP --seed 5 --count 8000 [--split train]
    python -m dragmesh_training.limits fit A.npz B.npz --validate V.npz -o limits.safetensors

It learns how probable each range is; the library answers with the range whose expected overlap with the true one is largest.
"""
import argparse
import ctypes
import os

import numpy as np
import torch

from .config import KNOWN
from .ranker import case_file, category_names, export, load, open_lab, options_of

ARRAYS = (("lower", np.float32), ("upper", np.float32), ("free", np.int32), ("category", np.int32))
# Of what ships. Half of the cases are of the kinds up to here: the later ones are machines and robots for the most part, whose
# ranges would say too much about a kitchen's.
SEEDS, VALIDATION_SEED, CASES, FIRST_KINDS = (5, 15, 25), 6, 8000, 195
# Sizes of either side of a range, in rad or in the part's extent along the slide, and how many kinds of ranges there are.
SIZES = np.array([0, .01, .02, .035, .055, .08, .12, .17, .24, .32, .42, .55, .7, .85, 1, 1.2, 1.4, 1.571, 1.8, 2.1, 2.5,
                  3, 3.6, 4.7, 6.5], np.float32)
RANGE_KINDS = 8


def make(lab, kinematics, seed, count, split, chosen):
    columns = lab.dm_lab_limits_columns()
    data = {"features": np.zeros((count, columns), np.float32)}
    data.update({name: np.zeros(count, dtype) for name, dtype in ARRAYS})
    options, keep = options_of(lab, seed, count, split, chosen)
    pointers = (ctypes.c_void_p * 5)(*[array.ctypes.data for array in data.values()])
    if lab.dm_lab_limits_batch(ctypes.byref(options), kinematics, ctypes.c_size_t(len(kinematics)), pointers) != 0:
        raise RuntimeError("dm_lab_limits_batch failed")
    del keep
    return data


def size_shares(sizes):
    """Each size shared among the nearest of SIZES, on a logarithmic scale."""
    logs = (torch.from_numpy(SIZES) + 0.01).log()
    return torch.softmax(-(((sizes.clamp(min=0) + 0.01).log()[:, None] - logs) / 0.15) ** 2, 1)


def range_logs(outputs):
    """Of the limits' network: free's logit, log shares of the kinds of ranges, and each kind's of either side's sizes."""
    sides = outputs[:, 1 + RANGE_KINDS:].view(len(outputs), 2, RANGE_KINDS, len(SIZES))
    return (outputs[:, 0], torch.log_softmax(outputs[:, 1:1 + RANGE_KINDS], 1), torch.log_softmax(sides[:, 0], 2),
            torch.log_softmax(sides[:, 1], 2))


def mean_overlap(outputs, lower, upper):
    """Intersection over union of the ranges answered with the true ones, as sdk/kinematics/limit_net.c answers."""
    _, kinds, down, up = (part.exp() for part in range_logs(outputs))
    probability = torch.einsum("nk,nkd,nku->ndu", kinds, down, up).flatten(1)
    pairs = torch.cartesian_prod(torch.from_numpy(SIZES), torch.from_numpy(SIZES))
    overlap = torch.minimum(pairs[:, None], pairs).sum(2) / (torch.maximum(pairs[:, None], pairs).sum(2) + 1e-4)
    best = pairs[(probability @ overlap).argmax(1)]
    truth = torch.stack([-lower.clamp(max=0), upper.clamp(min=0)], 1)
    return (torch.minimum(best, truth).sum(1) / (torch.maximum(best, truth).sum(1) + 1e-4)).mean().item()


def fit(data, validation, steps, seed):
    """How probable each range is, by the likelihood of the true ones."""
    torch.manual_seed(seed)
    hidden, x = 160, torch.from_numpy(data["features"])
    mean, scale = x.mean(0), 1 / (x.std(0) + 0.02)
    net = torch.nn.Sequential(torch.nn.Linear(x.shape[1], hidden), torch.nn.ReLU(), torch.nn.Linear(hidden, hidden),
                              torch.nn.ReLU(), torch.nn.Linear(hidden, 1 + RANGE_KINDS * (1 + 2 * len(SIZES))))
    optimiser = torch.optim.AdamW(net.parameters(), 2e-3, weight_decay=3e-2)
    down, up = size_shares(-torch.from_numpy(data["lower"])), size_shares(torch.from_numpy(data["upper"]))
    free, random = torch.from_numpy(data["free"]), np.random.default_rng(seed)
    average = {name: value.clone() for name, value in net.state_dict().items()}
    for step in range(steps):
        for group in optimiser.param_groups:
            group["lr"] = 2e-3 * (1 - step / steps) + 1e-5
        index = random.integers(0, len(x), 256)
        noisy = (x[index] - mean) * scale + 0.6 * torch.randn(256, x.shape[1])
        stops, kinds, downs, ups = range_logs(net(noisy))
        known = (downs * down[index, None]).sum(2) + (ups * up[index, None]).sum(2)
        likelihood = torch.logsumexp(kinds + known, 1)[free[index] == 0]
        loss = torch.nn.functional.binary_cross_entropy_with_logits(stops, free[index].float()) - 0.3 * likelihood.mean()
        optimiser.zero_grad()
        loss.backward()
        optimiser.step()
        for name, value in net.state_dict().items():
            average[name].lerp_(value, max(0.001, 1 / (step + 1)))
    net.load_state_dict(average)
    with torch.no_grad():
        for name, part in (("trained", data), ("validation", validation)):
            limited = np.flatnonzero(part["free"] == 0)[:4000]
            features, lower, upper = (torch.from_numpy(part[k][limited]) for k in ("features", "lower", "upper"))
            print(f"limits: overlap with the truth {mean_overlap(net((features - mean) * scale), lower, upper):.3f} {name}",
                  flush=True)
    tensors = {"limits.mean": mean.numpy(), "limits.scale": scale.numpy(), "limits.sizes": SIZES}
    for layer, name in ((0, "first"), (2, "second"), (4, "last")):
        tensors[f"limits.{name}"] = np.ascontiguousarray(net[layer].weight.detach().numpy().T)
        tensors[f"limits.{name}_bias"] = net[layer].bias.detach().numpy()
    return tensors


def run_make(arguments):
    lab = open_lab(arguments.lab)
    with open(arguments.weights, "rb") as file:
        kinematics = file.read()
    names = category_names(lab)
    np.savez(arguments.out, names=np.array(names),
             **make(lab, kinematics, arguments.seed, arguments.count, arguments.split, names[:arguments.kinds]))


def run_fit(arguments):
    torch.set_num_threads(1)
    data = load(arguments.data)
    tensors = fit(data, load([arguments.validate]), arguments.steps, arguments.seed)
    export(arguments.out, tensors, {"architecture": "dragmesh-limits", "version": "1", "seed": str(arguments.seed),
                                    "trained": f"{len(data['free'])} generated cases"})


def ship(folder, kinematics, out):
    """The limits' network that ships; goes on where it was stopped."""
    def made(name, seed, count, *more):
        return case_file(run, folder, f"limits_{name}{seed}", kinematics, seed, "--count", str(count), *more)

    validation = made("validation", VALIDATION_SEED, CASES // 4, "--split", "1")
    files = [made("first", seed, CASES, "--kinds", str(FIRST_KINDS)) for seed in SEEDS]
    files += [made("all", seed, CASES) for seed in SEEDS]
    run(["fit", *files, "--validate", validation, "-o", out])


def run(words=None):
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(required=True)
    one = commands.add_parser("make")
    one.add_argument("out")
    one.add_argument("--lab", default=os.path.join(os.path.dirname(__file__), "..", "..", "build", "release",
                                                   "libdragmesh_lab.so"))
    one.add_argument("--weights", required=True, help="the KPP-Net that ships")
    one.add_argument("--seed", type=int, default=5)
    one.add_argument("--count", type=int, default=CASES)
    one.add_argument("--split", type=int, default=0)
    one.add_argument("--kinds", type=int, default=KNOWN, help="only the first so many kinds of objects")
    one.set_defaults(run=run_make)
    two = commands.add_parser("fit")
    two.add_argument("data", nargs="+")
    two.add_argument("--validate", required=True)
    two.add_argument("--steps", type=int, default=7000)
    two.add_argument("--seed", type=int, default=1)
    two.add_argument("-o", "--out", required=True)
    two.set_defaults(run=run_fit)
    arguments = parser.parse_args(words)
    arguments.run(arguments)


if __name__ == "__main__":
    run()
