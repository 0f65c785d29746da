"""The ranker of candidate joints: evidence of generated cases in, sdk/models/ranker.safetensors out.

    python -m dragmesh_training.ranker make OUT.npz --seed 1 --count 4000 [--split 0] [--only trained|held|test_only]
    python -m dragmesh_training.ranker train A.npz B.npz --forest A.npz C.npz --validate V.npz --sieve SIEVE --limits LIMITS
        -o ranker.safetensors

Cases are made with the sieve (sieve.py) that the library will have, so that the candidates are those which the ranker will see.

A case's candidates share a probability of one by exp(-cost): their cost is what a player would see (the pose error),
what a programmer would read (type, axis, line). The softmax over the candidates learns to share it that way, in a
network and in a forest (forest.py), whose mean is the score. Two numbers, and two more where there is no drag, turn the
probability an answer gathers into the chance that it is right.
"""
import argparse
import ctypes
import os
import subprocess
import sys
import time

import numpy as np

from . import forest, sieve
from .cases import GROUPS, KEPT_BEST, NETWORK, SLIDES, case_file, costs, load, log_weights, make
from .config import HELD_OUT
from .lab import LAB, chosen_kinds, names_by_id, open_lab, options_of

GOOD = 0.02
ONLY = ("trained", "first", "held", "paper", "test_only", "later")  # of config.kinds_of
# What ships is trained on so many cases of each seed: with the evidence of an earlier KPP-Net (EARLIER_COMMIT), and with
# the shipped one's.
CASES, STEPS, LEAST = 6000, 9000, 20
LEAST_SLOPE = 0.1  # of confidence by trust: the library takes none that falls, as few cases may say
# KPP-Net after a third of its run, of fewer kinds. On the kinds that both were trained on the shipped one is right more often
# than elsewhere, and a ranker that saw no other would trust it too far; the earlier one, whose choice head had only begun, errs
# there about as often as the shipped one does on what it does not know.
EARLIER_COMMIT = "613e580"
# The last KPP-Net that knew none of HELD_OUT: with it the ranker's twin says how sure an answer is where nothing knows the kind.
UNKNOWING_COMMIT = "60987f0"
NETWORK_SEEDS = (101, 103, 211), (102, 104)
FOREST_SEEDS = (101, 103, 301, 302, 305, 306, 307, 308), (102, 104, 303, 304, 315, 316, 317, 318)
SIEVE_SEEDS, SIEVE_CASES = (301, 302), 6000  # of the one network and of the other
SAMPLED, FOREST_SAMPLED = 96, 56  # rows of a case in a training step, and for the forest


def run_make(arguments):
    lab = open_lab(arguments.lab)
    chosen = chosen_kinds(lab, arguments.only)
    weights, sieve_weights = (open(path, "rb").read() if path else None for path in (arguments.weights, arguments.sieve))
    start, parts = time.time(), []
    for first in range(0, arguments.count, 100):
        count = min(100, arguments.count - first)
        part = make(lab, arguments.seed * 1000003 + first, count, arguments.rows, arguments.split, chosen,
                    arguments.noise, weights, sieve_weights)
        part["evidence"] = part["evidence"].astype(np.float16)
        parts.append(part)
    data = {name: np.concatenate([p[name] for p in parts]) for name in parts[0]}
    np.savez(arguments.out, names=np.array(names_by_id(lab)), **data)
    print(f"{arguments.count} cases in {time.time() - start:.0f} s; best candidate under 2 %: "
          f"{(data['best'] < GOOD).mean():.3f}; candidates {data['total'].mean():.0f}")


def build(columns, hidden, dropout):
    import torch
    return torch.nn.Sequential(torch.nn.Linear(columns, hidden), torch.nn.ReLU(), torch.nn.Dropout(dropout),
                               torch.nn.Linear(hidden, hidden), torch.nn.ReLU(), torch.nn.Linear(hidden, 1))


def answer(probability, slides, pose):
    """The best candidate of the likelier type, and the probability of all that move the part alike."""
    sliding = probability[slides].sum() > probability[~slides].sum()
    best = np.where(slides == sliding, probability, -1).argmax()
    return best, probability[np.abs(pose - pose[best]) < 0.01].sum()


def evaluate(net, data, mean, scale, blind):
    """Of the network alone: whether each answer is good, and how far it is trusted."""
    import torch
    good, confidence, everything = [], [], np.arange(data["pose"].shape[1])[None]
    net.eval()
    with torch.no_grad():
        for i, used in enumerate(data["used"]):
            evidence = data["evidence"][i, :used].astype(np.float32)
            if blind:
                evidence[:, NETWORK] = 0
            extra = log_weights(everything[:, :used], data["used"][i:i + 1], data["total"][i:i + 1])
            logits = net((torch.from_numpy(evidence) - mean) * scale)[:, 0] + torch.from_numpy(extra[0])
            best, trust = answer(torch.softmax(logits, 0).numpy(), evidence[:, SLIDES] > 0.5, data["pose"][i, :used])
            good.append(data["pose"][i, best] < GOOD)
            confidence.append(trust)
    net.train()
    return np.array(good), np.array(confidence)


def summary(good, data, names):
    drag, held = data["has_drag"] > 0, np.isin(names[data["category"]], HELD_OUT)
    return "pose<2% " + " ".join(f"{kind} {good[mask].mean():.3f}" for kind, mask in (
        ("trained, drag", drag & ~held), ("none", ~drag & ~held), ("held out, drag", drag & held),
        ("none", ~drag & held)) if mask.any())


def draw(data, cost, random, batch, without_network, without_group, mean):
    """A training step's evidence, log weights and costs."""
    index = random.integers(0, len(cost), batch)
    used, total = data["used"][index], data["total"][index]
    others = random.integers(KEPT_BEST, np.maximum(used, KEPT_BEST + 1)[:, None], (batch, SAMPLED - KEPT_BEST))
    rows = np.concatenate([np.tile(np.arange(KEPT_BEST), (batch, 1)), others], 1)
    evidence = data["evidence"][index[:, None], rows].astype(np.float32)
    blind = np.flatnonzero(random.random(batch) < without_network)
    evidence[blind[:, None, None], np.arange(SAMPLED)[:, None], NETWORK] = 0
    for group in GROUPS:
        evidence[random.random(batch) < without_group, :, group] = mean[group]
    extra = log_weights(rows, np.maximum(used, SAMPLED), total)
    extra[rows >= used[:, None]] = -1e9
    return evidence, extra, cost[index[:, None], rows]


def fit(data, validation, names, arguments):
    import torch
    from .descent import descend, listwise_loss
    torch.manual_seed(arguments.seed)
    torch.set_num_threads(1)
    real = data["used"][:800, None] > np.arange(data["pose"].shape[1])
    flat = data["evidence"][:800].astype(np.float32)[real]
    mean, scale = torch.from_numpy(flat.mean(0)), 1 / (torch.from_numpy(flat.std(0)) + 0.05)
    net = build(len(mean), arguments.hidden, arguments.dropout)
    random, cost, smooth, start = np.random.default_rng(arguments.seed), costs(data), 0.0, time.time()

    def tell(step, loss):
        nonlocal smooth
        smooth += (loss - smooth) * max(0.02, 1 / (step + 1))
        if (step + 1) % max(arguments.steps // 5, 1) == 0:
            good, _ = evaluate(net, validation, mean, scale, arguments.without_network >= 1)
            print(f"{time.time() - start:5.0f} s {step + 1} steps loss {smooth:.3f} {summary(good, validation, names)}",
                  flush=True)

    def loss_of(step):
        evidence, extra, cases = map(torch.from_numpy, draw(data, cost, random, arguments.batch,
                                                            arguments.without_network, arguments.without_group,
                                                            mean.numpy()))
        loss = listwise_loss(net((evidence - mean) * scale)[..., 0], extra, cases)
        tell(step, loss.item())
        return loss

    descend(net, arguments.steps, arguments.rate, 2e-5, 1e-2, 0.002, loss_of)
    return net, mean, scale


def forest_cases(data, without_network, random):
    """Of each case its best rows and some others: their evidence, log weights and wanted probabilities."""
    cost = costs(data)
    for case, used in enumerate(data["used"]):
        others = KEPT_BEST + random.permutation(max(used - KEPT_BEST, 0))[:FOREST_SAMPLED - KEPT_BEST]
        rows = np.concatenate([np.arange(min(KEPT_BEST, used)), others])
        evidence = data["evidence"][case, rows]
        if random.random() < without_network:
            evidence[:, NETWORK] = 0
        weights = log_weights(rows[None], data["used"][case:case + 1], data["total"][case:case + 1])[0]
        wanted = np.exp(weights - cost[case, rows] - (weights - cost[case, rows]).max())
        yield evidence, weights, wanted / wanted.sum()


def calibrate(good, trust):
    """(a, b) of confidence = sigmoid(a logit(trust) + b): the logistic regression of being right, by Newton's method."""
    trust = np.clip(trust, 1e-4, 1 - 1e-4)
    x = np.stack([np.log(trust / (1 - trust)), np.ones(len(trust))], 1)
    w = np.array([1.0, 0.0])
    for _ in range(30):
        p = 1 / (1 + np.exp(-x @ w))
        hessian = x.T @ (x * (p * (1 - p))[:, None]) + 1e-3 * np.eye(2)
        w += np.linalg.solve(hessian, x.T @ (good - p))
    return np.array([max(w[0], LEAST_SLOPE), w[1]])


ANSWER_ARRAYS = (("pose", np.float32), ("confidence", np.float32), ("right_type", np.int32), ("axis_error", np.float32),
                 ("line_error", np.float32), ("has_drag", np.int32), ("category", np.int32))


def answers(lab, kinematics, ranker, seed, count, split, chosen, clean=False):
    """What the whole library answers on fresh cases."""
    data = {name: np.zeros(count, dtype) for name, dtype in ANSWER_ARRAYS}
    options, keep = options_of(lab, seed, count, split, chosen, clean)
    pointers = (ctypes.c_void_p * len(data))(*[array.ctypes.data for array in data.values()])
    result = lab.dm_lab_answer(ctypes.byref(options), kinematics, ctypes.c_size_t(len(kinematics)), ranker,
                               ctypes.c_size_t(len(ranker)), pointers)
    if result != 0:
        raise RuntimeError(f"dm_lab_answer: {result}")
    del keep
    return data


def own_calibration(lab, kinematics, tensors, metadata, path, count):
    """Of a ranker that knows no held-out kind, on those kinds: real objects are none that any network has seen either. A line
    between log odds without a drag, and one with a drag."""
    from .export import write_ranker_tensors
    write_ranker_tensors(path, {**tensors, "calibration": np.array([[1, 0], [1, 0]], np.float32)}, metadata)
    with open(path, "rb") as file:
        ranker = file.read()
    found = answers(lab, kinematics, ranker, 77, count, 1, HELD_OUT)
    good = found["pose"] < GOOD
    return np.array([calibrate(good[with_drag], found["confidence"][with_drag])
                     for with_drag in (found["has_drag"] == 0, found["has_drag"] != 0)], np.float32)


def run_train(arguments):
    from .export import commit, load_safetensors, write_ranker_tensors
    lab = open_lab(arguments.lab)
    names = np.load(arguments.data[0])["names"]
    left_out = HELD_OUT if arguments.hold_out else ()
    data, validation = load(arguments.data, left_out), load([arguments.validate])
    with open(arguments.weights, "rb") as file:
        kinematics = file.read()
    net, mean, scale = fit(data, validation, names, arguments)
    good, _ = evaluate(net, validation, mean, scale, arguments.without_network >= 1)
    print(f"validation: {summary(good, validation, names)}")
    tensors, state = {"mean": mean.numpy(), "scale": scale.numpy()}, list(net.state_dict().values())
    more = load(arguments.forest, left_out)
    tensors.update(forest.grow(lab, forest_cases(more, arguments.without_network, np.random.default_rng(arguments.seed)),
                               arguments.seed))
    for layer, name in enumerate(("0", "2", "4")):
        tensors[f"{name}.weight"], tensors[f"{name}.bias"] = state[2 * layer].numpy(), state[2 * layer + 1].numpy()
    for path in (arguments.sieve, arguments.limits):
        tensors.update({name: tensor.numpy() for name, tensor in load_safetensors(path)[0].items()})
    metadata = {"architecture": "dragmesh-ranker", "version": "8", "commit": commit(), "seed": str(arguments.seed),
                "trained": f"{len(data['used'])} generated cases, the forest {len(more['used'])}"}
    if arguments.calibration_of:
        calibration = load_safetensors(arguments.calibration_of)[0]["calibration"].numpy()
    else:
        calibration = own_calibration(lab, kinematics, tensors, metadata, arguments.out, arguments.calibration_cases)
    write_ranker_tensors(arguments.out, {**tensors, "calibration": calibration}, metadata)
    with open(arguments.out, "rb") as file:
        found = answers(lab, kinematics, file.read(), 77, len(validation["used"]), 1, chosen_kinds(lab, "trained"))
    print(f"whole library, validation: type {found['right_type'].mean():.3f} "
          f"{summary(found['pose'] < GOOD, found, np.array(names_by_id(lab)))}; "
          f"confidence = sigmoid(a logit(mass) + b), none, drag: {calibration.round(3).tolist()}", flush=True)


def run_answer(arguments):
    lab = open_lab(arguments.lab)
    kinematics, ranker = (open(path, "rb").read() for path in (arguments.weights, arguments.ranker))
    found = answers(lab, kinematics, ranker, arguments.seed, arguments.count, 1,
                    chosen_kinds(lab, arguments.only), arguments.clean)
    for name, mask in (("with a drag", found["has_drag"] != 0), ("without", found["has_drag"] == 0)):
        right = mask & (found["right_type"] != 0)
        axis, line = 1000 * found["axis_error"][right], 1000 * found["line_error"][right & (found["line_error"] >= 0)]
        print(f"{arguments.only} kinds, {name}: {mask.sum()} cases, pose<2% {(found['pose'][mask] < GOOD).mean():.3f} "
              f"type {found['right_type'][mask].mean():.3f} stated {found['confidence'][mask].mean():.3f}; of the right type "
              f"axis {axis.mean():.0f} mrad in the mean, {np.median(axis):.1f} median, line {line.mean():.1f} and {np.median(line):.1f} thousandths of the size")


def committed_network(folder, name, commit):
    """A KPP-Net of before, as committed once, in the folder."""
    path = os.path.join(folder, name + ".safetensors")
    if not os.path.exists(path):
        weights = subprocess.run(["git", "show", f"{commit}:sdk/models/kpp_net.safetensors"], stdout=subprocess.PIPE, check=True,
                                 cwd=os.path.dirname(os.path.abspath(__file__))).stdout
        with open(path, "wb") as file:
            file.write(weights)
    return path


def ship(folder, models, out, share):
    """What the ranker of the folder `out` is made by, for the KPP-Net in `models`; goes on where it was stopped. About an hour
    of one core. First the sieve, from cases all of whose candidates are judged; then the ranker, from cases that were sieved.
    Its twin has not seen the held-out kinds (nor have the sieve and the KPP-Net that it is asked with): it says how well kinds
    are answered that nothing knows, and what the probabilities of such answers are worth. share: of the cases and the steps,
    less than 1 for a try."""
    from . import limits

    def some(count, least=LEAST):
        return str(max(round(share * count), least))

    os.makedirs(folder, exist_ok=True)
    shipped = os.path.join(models, "kpp_net.safetensors")
    earlier = committed_network(folder, "kpp_earlier", EARLIER_COMMIT)
    unknowing = committed_network(folder, "kpp_unknowing", UNKNOWING_COMMIT)
    sieve_file, limits_file = (os.path.join(folder, name + ".safetensors") for name in ("sieve", "limits"))
    if not os.path.exists(sieve_file):
        every = [case_file(run, folder, f"every{seed}", kinematics, seed, "--count", some(SIEVE_CASES))
                 for seed, kinematics in zip(SIEVE_SEEDS, (earlier, shipped))]
        sieve.run([*every, "--steps", some(sieve.STEPS), "-o", sieve_file])
    of_network, of_forest = (
        [case_file(run, folder, f"cases{seed}", kinematics, seed, "--count", some(CASES), "--sieve", sieve_file)
         for kinematics, of_one in zip((earlier, shipped), seeds) for seed in of_one]
        for seeds in (NETWORK_SEEDS, FOREST_SEEDS))
    limits.ship(folder, shipped, sieve_file, limits_file, some)
    validation = case_file(run, folder, "validation", shipped, 105, "--count", some(1500), "--split", "1", "--sieve", sieve_file)
    common = ["train", *of_network, "--forest", *of_forest, "--validate", validation,
              "--sieve", sieve_file, "--limits", limits_file, "--steps", some(STEPS), "--calibration-cases", some(3000, 300)]
    twin = os.path.join(folder, "twin.safetensors")
    run([*common, "--weights", unknowing, "--hold-out", "-o", twin])
    run([*common, "--weights", shipped, "--calibration-of", twin, "-o", os.path.join(out, "ranker.safetensors")])


def run(words):
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(required=True)
    one = commands.add_parser("make")
    one.add_argument("out")
    one.add_argument("--lab", default=LAB)
    one.add_argument("--seed", type=int, default=1)
    one.add_argument("--count", type=int, default=2000)
    one.add_argument("--rows", type=int, default=112)
    one.add_argument("--split", type=int, default=0)
    one.add_argument("--noise", type=float, default=14.0)
    one.add_argument("--only", choices=ONLY, default="trained")
    one.add_argument("--weights")
    one.add_argument("--sieve", help="weights of the sieve; without them all candidates are judged")
    one.set_defaults(run=run_make)
    two = commands.add_parser("train")
    two.add_argument("data", nargs="+")
    two.add_argument("--forest", nargs="+", required=True, help="cases that the forest is grown on")
    two.add_argument("--validate", required=True)
    two.add_argument("--lab", default=LAB)
    two.add_argument("--weights", required=True, help="the KPP-Net that answers are asked with")
    two.add_argument("--sieve", required=True, help="what the cases were made with")
    two.add_argument("--limits", required=True, help="weights of the limits' network (limits.py)")
    two.add_argument("--calibration-cases", type=int, default=3000)
    two.add_argument("--calibration-of", help="a ranker of its twin's calibration; without it, its own on the held-out kinds")
    two.add_argument("--steps", type=int, default=STEPS)
    two.add_argument("--batch", type=int, default=48)
    two.add_argument("--hidden", type=int, default=64)
    two.add_argument("--rate", type=float, default=2e-3)
    two.add_argument("--dropout", type=float, default=0.1)
    two.add_argument("--without-network", type=float, default=0.15, help="share of cases that do without its columns")
    two.add_argument("--without-group", type=float, default=0.1, help="and each other group of evidence")
    two.add_argument("--seed", type=int, default=1)
    two.add_argument("--hold-out", action="store_true", help="leave out the kinds that are held out of the networks' training")
    two.add_argument("-o", "--out", required=True)
    two.set_defaults(run=run_train)
    models = os.path.join(os.path.dirname(__file__), "..", "..", "sdk", "models")
    three = commands.add_parser("answer", help="what the whole library answers on fresh cases of the validation split")
    three.add_argument("--lab", default=LAB)
    three.add_argument("--weights", default=os.path.join(models, "kpp_net.safetensors"))
    three.add_argument("--ranker", default=os.path.join(models, "ranker.safetensors"))
    three.add_argument("--only", choices=ONLY, default="test_only")
    three.add_argument("--clean", action="store_true", help="no mess, masks and drags without mistakes")
    three.add_argument("--count", type=int, default=4000)
    three.add_argument("--seed", type=int, default=91)
    three.set_defaults(run=run_answer)
    arguments = parser.parse_args(words)
    arguments.run(arguments)


if __name__ == "__main__":
    run(sys.argv[1:])
