"""The limit networks (sdk/kinematics/limits/limit_network.c): the sweeps of generated joints, and the candidate features that
they are ranked by, in; weights out.

    python -m dragmesh_training.limits make OUT.npz --weights KPP --prefilter PREFILTER --seed 5 --count 8000 [--split 1]
    python -m dragmesh_training.limits fit A.npz B.npz --validate V.npz -o limits.safetensors

They learn how probable each range is; the library answers with the range whose expected overlap with the true one is largest.
The candidate features say what kind of thing this is. They are hidden in slides and in half of the turns, or a network would
know the ranges of the kinds that it was shown and no others. The ensemble's members differ by chance alone, and err less
together than one.
"""
import argparse
import ctypes

import numpy as np
import torch

from .cases import case_files, load
from .descent import descend
from .export import perceptron_tensors, write_joint_models
from .features import PRISMATIC
from .files import save_arrays
from .lab import LAB, chosen_kinds, names_by_id, open_lab, options_of

ARRAYS = (("lower", np.float32), ("upper", np.float32), ("free", np.int32), ("category", np.int32), ("pose", np.float32),
          ("has_drag", np.int32))
# Of what ships.
SEEDS, VALIDATION_SEED, CASES, STEPS = range(5, 165, 10), 6, 8000, 20000
# Sizes of either side of a range, in rad or in the part's extent along the slide: in rad, the round angles are among them.
SIZES = np.array([0, .01, .02, .035, .055, .08, .12, .175, .262, .349, .436, .524, .65, .785, .9, 1.047, 1.2, 1.38, 1.571,
                  1.833, 2.094, 2.5, 3.142, 4.2, 6.283], np.float32)
RANGE_KINDS = 8  # components of the mixture of ranges, as in limit_network.h
MEMBERS = 3  # of the ensemble, as in limit_network.h
# Degrees that people write limits in multiples of, and how many do (0: as the mechanism has it). Set by hand.
ROUND_DEGREES, ROUND_SHARES = (0, 15, 45), (0.3, 0.3, 0.4)
AT_ONCE = 500  # cases
WITHOUT_CANDIDATE = 0.5  # share of turning cases whose candidate features are hidden; the library hides those of slides


def make(lab, kinematics, prefilter, seed, count, split, chosen):
    data = {"features": np.zeros((count, lab.dm_lab_limits_columns()), np.float32),
            "candidate": np.zeros((count, lab.dm_lab_limits_candidate_columns()), np.float32)}
    data.update({name: np.zeros(count, dtype) for name, dtype in ARRAYS})
    options, keep = options_of(lab, seed, count, split, chosen, pull="careful")
    pointers = (ctypes.c_void_p * len(data))(*[array.ctypes.data for array in data.values()])
    sizes = [ctypes.c_size_t(len(weights)) for weights in (kinematics, prefilter)]
    if lab.dm_lab_limits_batch(ctypes.byref(options), kinematics, sizes[0], prefilter, sizes[1], pointers) != 0:
        raise RuntimeError("dm_lab_limits_batch failed")
    del keep
    data["candidate"] = data["candidate"].astype(np.float16)
    return data


def as_written(lower, upper, turns, random):
    """The limits of turns as people write them down, most of them in round degrees: the generator's are wherever a mechanism
    ends. A side stays as it is when rounding would leave nothing of it, a range when rounding would cost it much."""
    step = np.radians(random.choice(ROUND_DEGREES, len(lower), p=ROUND_SHARES)) * turns

    def rounded(side):
        nearest = np.round(side / np.maximum(step, 1e-6)) * step
        return np.where((step == 0) | (nearest == 0), side, nearest).astype(np.float32)

    low, high = rounded(lower), rounded(upper)
    keeps = high - low >= 0.6 * (upper - lower)
    return np.where(keeps, low, lower), np.where(keeps, high, upper)


def slides_of(data):
    return data["candidate"][:, PRISMATIC] > 0.5


def inputs_of(data):
    return torch.from_numpy(np.concatenate([data["features"], data["candidate"].astype(np.float32)], 1))


def hide_candidate(x, rows, data):
    """Sets the candidate features of these rows to their means; x: standardised inputs_of data, is changed."""
    x[np.flatnonzero(rows), data["features"].shape[1]:] = 0
    return x


def size_shares(sizes):
    """Each size shared among the nearest of SIZES, on a logarithmic scale."""
    logs = (torch.from_numpy(SIZES) + 0.01).log()
    return torch.softmax(-(((sizes.clamp(min=0) + 0.01).log()[:, None] - logs) / 0.15) ** 2, 1)


def range_logs(outputs):
    """Of a limit network: free's logit, log shares of the kinds of ranges, and each kind's of either side's sizes."""
    sides = outputs[:, 1 + RANGE_KINDS:].view(len(outputs), 2, RANGE_KINDS, len(SIZES))
    return (outputs[:, 0], torch.log_softmax(outputs[:, 1:1 + RANGE_KINDS], 1), torch.log_softmax(sides[:, 0], 2),
            torch.log_softmax(sides[:, 1], 2))


def probabilities(outputs):
    _, kinds, down, up = (part.exp() for part in range_logs(outputs))
    return torch.einsum("nk,nkd,nku->ndu", kinds, down, up).flatten(1)


def mean_overlap(probability, lower, upper):
    """Intersection over union of the ranges answered with the true ones, as sdk/kinematics/limits/limit_network.c answers."""
    pairs = torch.cartesian_prod(torch.from_numpy(SIZES), torch.from_numpy(SIZES))
    overlap = torch.minimum(pairs[:, None], pairs).sum(2) / (torch.maximum(pairs[:, None], pairs).sum(2) + 1e-4)
    best = pairs[(probability @ overlap).argmax(1)]
    truth = torch.stack([-lower.clamp(max=0), upper.clamp(min=0)], 1)
    return (torch.minimum(best, truth).sum(1) / (torch.maximum(best, truth).sum(1) + 1e-4)).mean().item()


def build(inputs):
    hidden = 160
    return torch.nn.Sequential(torch.nn.Linear(inputs, hidden), torch.nn.ReLU(), torch.nn.Dropout(0.1),
                               torch.nn.Linear(hidden, hidden), torch.nn.ReLU(),
                               torch.nn.Linear(hidden, 1 + RANGE_KINDS * (1 + 2 * len(SIZES))))


def overlaps(nets, data, mean, scale):
    """Of the limited cases with a drag and without one."""
    out = []
    for drag in (1, 0):
        limited = np.flatnonzero((data["free"] == 0) & (data["has_drag"] == drag))[:4000]
        part = {name: array[limited] for name, array in data.items()}
        x = hide_candidate((inputs_of(part) - mean) * scale, slides_of(part), part)
        probability = sum(probabilities(net(x)) for net in nets) / len(nets)
        out.append(mean_overlap(probability, torch.from_numpy(part["lower"]), torch.from_numpy(part["upper"])))
    return out


def fit_one(data, x, mean, scale, steps, seed):
    """How probable each range is, by the likelihood of the true ones."""
    torch.manual_seed(seed)
    net, slides = build(x.shape[1]), slides_of(data)
    down, up = size_shares(-torch.from_numpy(data["lower"])), size_shares(torch.from_numpy(data["upper"]))
    free, random = torch.from_numpy(data["free"]), np.random.default_rng(seed)

    def loss_of(_):
        index = random.integers(0, len(x), 256)
        noisy = (x[index] - mean) * scale + 0.6 * torch.randn(256, x.shape[1])
        hide_candidate(noisy, slides[index] | (random.random(256) < WITHOUT_CANDIDATE), data)
        stops, kinds, downs, ups = range_logs(net(noisy))
        known = (downs * down[index, None]).sum(2) + (ups * up[index, None]).sum(2)
        likelihood = torch.logsumexp(kinds + known, 1)[free[index] == 0]
        return torch.nn.functional.binary_cross_entropy_with_logits(stops, free[index].float()) - 0.3 * likelihood.mean()

    descend(net, steps, 2e-3, 1e-5, 3e-2, 0.001, loss_of)
    return net.eval()


def fit(data, validation, steps, seed):
    lower, upper = as_written(data["lower"], data["upper"], ~slides_of(data), np.random.default_rng(seed))
    data, x = {**data, "lower": lower, "upper": upper}, inputs_of(data)
    mean, scale = x.mean(0), 1 / (x.std(0) + 0.02)
    nets = [fit_one(data, x, mean, scale, steps, seed + member) for member in range(MEMBERS)]
    with torch.no_grad():
        for name, part in (("trained", data), ("validation", validation)):
            for some in (nets[:1], nets):
                print("limits: overlap with the truth {:.3f} with a drag, {:.3f} without,".format(
                    *overlaps(some, part, mean, scale)), name, f"by {len(some)}", flush=True)
    tensors = {"limits.mean": mean.numpy(), "limits.scale": scale.numpy(), "limits.sizes": SIZES}
    for member, net in enumerate(nets):
        tensors.update(perceptron_tensors(f"limits.{member}", net))
    return tensors


def run_make(arguments):
    lab = open_lab(arguments.lab)
    kinematics, prefilter = (open(path, "rb").read() for path in (arguments.weights, arguments.prefilter))
    chosen = chosen_kinds(lab, "trained")
    parts = [make(lab, kinematics, prefilter, arguments.seed * 1000003 + first, min(AT_ONCE, arguments.count - first),
                  arguments.split, chosen)
             for first in range(0, arguments.count, AT_ONCE)]
    save_arrays(arguments.out, names=np.array(names_by_id(lab)),
             **{name: np.concatenate([part[name] for part in parts]) for name in parts[0]})


def run_fit(arguments):
    torch.set_num_threads(1)
    data = load(arguments.data)
    tensors = fit(data, load([arguments.validate]), arguments.steps, arguments.seed)
    write_joint_models(arguments.out, tensors, {"architecture": "dragmesh-limits", "version": "3", "seed": str(arguments.seed),
                                                "trained": f"{len(data['free'])} generated cases"})


def ship(folder, kinematics, prefilter, out, some=str):
    """The limit networks that ship; goes on where it was stopped. some: how many of so many cases and steps, as a word."""
    def cases(name, seed, count, *more):
        return f"limits_{name}{seed}", kinematics, seed, "--prefilter", prefilter, "--count", some(count), *more

    validation, *files = case_files(run, folder, [
        cases("validation", VALIDATION_SEED, CASES // 2, "--split", "1"),
        *(cases("train", seed, CASES) for seed in SEEDS)])
    run(["fit", *files, "--validate", validation, "--steps", some(STEPS), "-o", out])


def run(words=None):
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(required=True)
    one = commands.add_parser("make")
    one.add_argument("out")
    one.add_argument("--lab", default=LAB)
    one.add_argument("--weights", required=True, help="the KPP-Net that ships")
    one.add_argument("--prefilter", required=True, help="the prefilter that ships")
    one.add_argument("--seed", type=int, default=5)
    one.add_argument("--count", type=int, default=CASES)
    one.add_argument("--split", type=int, default=0)
    one.set_defaults(run=run_make)
    two = commands.add_parser("fit")
    two.add_argument("data", nargs="+")
    two.add_argument("--validate", required=True)
    two.add_argument("--steps", type=int, default=STEPS)
    two.add_argument("--seed", type=int, default=1)
    two.add_argument("-o", "--out", required=True)
    two.set_defaults(run=run_fit)
    arguments = parser.parse_args(words)
    arguments.run(arguments)


if __name__ == "__main__":
    run()
