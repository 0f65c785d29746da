"""The ranker of candidate joints: features of generated cases in, sdk/models/ranker.safetensors out.

    python -m dragmesh_training.ranker make OUT.npz --seed 1 --count 4000 [--split 0] [--only trained|held|test_only]
    python -m dragmesh_training.ranker train A.npz B.npz --trees A.npz C.npz --drags D.npz --validate V.npz
        --prefilter PREFILTER --limits LIMITS -o ranker.safetensors

Cases are made with the prefilter (prefilter.py) that the library will have, so that the candidates are those which the ranker
will see.

A case's candidates share a probability of one by exp(-cost): their cost is what a player would see (the pose error) and what
a programmer would read (type, axis, line). The softmax over the candidates learns to share it that way, in a network and in
boosted trees (boosted_trees.py), whose mean is the score. They learn from careful drags. More trees correct that score where
there is a drag, and learn from pulls as people make them. Two numbers, and two more where there is no drag, turn the
probability that an answer gathers into the probability that it is right.
"""
import argparse
import ctypes
import os
import subprocess
import sys
import time

import numpy as np

from . import boosted_trees, prefilter
from .cases import KEPT_BEST, case_files, costs, load, log_weights, make
from .config import HELD_OUT
from .features import HIDDEN_GROUPS, NETWORK, PRISMATIC
from .files import save_arrays, write_whole
from .lab import LAB, PULLS, chosen_kinds, names_by_id, open_lab, options_of

GOOD = 0.02
ONLY = ("trained", "held", "paper", "test_only", "later")  # of config.kinds_of
# What ships is trained on so many cases of each seed: with the features of an earlier KPP-Net (EARLIER_COMMIT), and with
# the shipped one's.
CASES, STEPS, LEAST = 6000, 9000, 20
LEAST_SLOPE = 0.1  # of the calibration: the library takes none that falls, which a few cases might give
UNCALIBRATED = np.array([[1, 0], [1, 0]], np.float32)  # slope and offset without a drag, and with one
# KPP-Net after a third of its run, of fewer kinds. On the kinds that both were trained on the shipped one is right more often
# than elsewhere, and a ranker that saw no other would trust it too far. The earlier one, whose candidate-scoring head had only
# begun, errs there about as often as the shipped one does on what it does not know.
EARLIER_COMMIT = "613e580"
# The last KPP-Net that knew none of HELD_OUT: with it the held-out ranker says how sure an answer is where nothing knows the kind.
HELD_OUT_COMMIT = "60987f0"
NETWORK_SEEDS = (101, 103, 211), (102, 104)
TREE_SEEDS = (101, 103, 301, 302, 305, 306, 307, 308), (102, 104, 303, 304, 315, 316, 317, 318)
DRAG_SEEDS, DRAG_CASES, DRAG_ROWS = (tuple(range(501, 507)), tuple(range(601, 607))), 2000, 80  # of the trees of drags
PREFILTER_SEEDS, PREFILTER_CASES = (301, 302), 6000  # of the one network and of the other
SAMPLED, TREES_SAMPLED = 96, 56  # rows of a case in a training step, and for the trees


def run_make(arguments):
    lab = open_lab(arguments.lab)
    chosen = chosen_kinds(lab, arguments.only)
    weights, prefilter_weights = (open(path, "rb").read() if path else None
                                  for path in (arguments.weights, arguments.prefilter))
    start, parts = time.time(), []
    for first in range(0, arguments.count, 100):
        count = min(100, arguments.count - first)
        part = make(lab, arguments.seed * 1000003 + first, count, arguments.rows, arguments.split, chosen,
                    arguments.noise, weights, prefilter_weights, arguments.with_drag, pull=arguments.pull)
        part["features"] = part["features"].astype(np.float16)
        parts.append(part)
    data = {name: np.concatenate([p[name] for p in parts]) for name in parts[0]}
    save_arrays(arguments.out, names=np.array(names_by_id(lab)), **data)
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


def evaluate(net, data, mean, scale, without_network):
    """Of the network alone: whether each answer is good, and how far it is trusted."""
    import torch
    good, confidence, everything = [], [], np.arange(data["pose"].shape[1])[None]
    net.eval()
    with torch.no_grad():
        for i, used in enumerate(data["used"]):
            features = data["features"][i, :used].astype(np.float32)
            if without_network:
                features[:, NETWORK] = 0
            extra = log_weights(everything[:, :used], data["used"][i:i + 1], data["total"][i:i + 1])
            logits = net((torch.from_numpy(features) - mean) * scale)[:, 0] + torch.from_numpy(extra[0])
            best, trust = answer(torch.softmax(logits, 0).numpy(), features[:, PRISMATIC] > 0.5, data["pose"][i, :used])
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
    """A training step's features, log weights and costs."""
    index = random.integers(0, len(cost), batch)
    used, total = data["used"][index], data["total"][index]
    others = random.integers(KEPT_BEST, np.maximum(used, KEPT_BEST + 1)[:, None], (batch, SAMPLED - KEPT_BEST))
    rows = np.concatenate([np.tile(np.arange(KEPT_BEST), (batch, 1)), others], 1)
    features = data["features"][index[:, None], rows].astype(np.float32)
    hidden = np.flatnonzero(random.random(batch) < without_network)
    features[hidden[:, None, None], np.arange(SAMPLED)[:, None], NETWORK] = 0
    for group in HIDDEN_GROUPS:
        features[random.random(batch) < without_group, :, group] = mean[group]
    extra = log_weights(rows, np.maximum(used, SAMPLED), total)
    extra[rows >= used[:, None]] = -1e9
    return features, extra, cost[index[:, None], rows]


def fit(data, validation, names, arguments):
    import torch
    from .descent import descend, listwise_loss
    torch.manual_seed(arguments.seed)
    torch.set_num_threads(1)
    real = data["used"][:800, None] > np.arange(data["pose"].shape[1])
    flat = data["features"][:800].astype(np.float32)[real]
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
        features, extra, cases = map(torch.from_numpy, draw(data, cost, random, arguments.batch,
                                                            arguments.without_network, arguments.without_group,
                                                            mean.numpy()))
        loss = listwise_loss(net((features - mean) * scale)[..., 0], extra, cases)
        tell(step, loss.item())
        return loss

    descend(net, arguments.steps, arguments.rate, 2e-5, 1e-2, 0.002, loss_of)
    return net, mean, scale


def tree_cases(data, without_network, random):
    """Of each case its best rows and some others: their features, log weights and target probabilities."""
    cost = costs(data)
    for case, used in enumerate(data["used"]):
        others = KEPT_BEST + random.permutation(max(used - KEPT_BEST, 0))[:TREES_SAMPLED - KEPT_BEST]
        rows = np.concatenate([np.arange(min(KEPT_BEST, used)), others])
        features = data["features"][case, rows]
        if random.random() < without_network:
            features[:, NETWORK] = 0
        weights = log_weights(rows[None], data["used"][case:case + 1], data["total"][case:case + 1])[0]
        target = np.exp(weights - cost[case, rows] - (weights - cost[case, rows]).max())
        yield features, weights, target / target.sum()


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


def answers(lab, kinematics, ranker, seed, count, split, chosen, clean=False, pull="mixed"):
    """What the whole library answers on fresh cases."""
    data = {name: np.zeros(count, dtype) for name, dtype in ANSWER_ARRAYS}
    options, keep = options_of(lab, seed, count, split, chosen, clean, pull)
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
    from .export import write_joint_models
    write_joint_models(path, {**tensors, "ranker.calibration": UNCALIBRATED}, metadata)
    with open(path, "rb") as file:
        ranker = file.read()
    found = answers(lab, kinematics, ranker, 77, count, 1, HELD_OUT, pull="careful")
    good = found["pose"] < GOOD
    return np.array([calibrate(good[with_drag], found["confidence"][with_drag])
                     for with_drag in (found["has_drag"] == 0, found["has_drag"] != 0)], np.float32)


def run_train(arguments):
    from .export import commit, load_safetensors, perceptron_tensors, write_joint_models
    lab = open_lab(arguments.lab)
    names = np.load(arguments.data[0])["names"]
    left_out = HELD_OUT if arguments.hold_out else ()
    data, validation = load(arguments.data, left_out), load([arguments.validate])
    with open(arguments.weights, "rb") as file:
        kinematics = file.read()
    net, mean, scale = fit(data, validation, names, arguments)
    good, _ = evaluate(net, validation, mean, scale, arguments.without_network >= 1)
    print(f"validation: {summary(good, validation, names)}")
    tensors = {"ranker.mean": mean.numpy(), "ranker.scale": scale.numpy(), **perceptron_tensors("ranker", net),
               "ranker.calibration": UNCALIBRATED}
    more, dragged = load(arguments.trees, left_out), load(arguments.drags, left_out)
    random = np.random.default_rng(arguments.seed)
    tensors.update(boosted_trees.grow(lab, tree_cases(more, arguments.without_network, random), arguments.seed))
    for path in (arguments.prefilter, arguments.limits):
        tensors.update({name: tensor.numpy() for name, tensor in load_safetensors(path)[0].items()})
    metadata = {"architecture": "dragmesh-joint-models", "version": "1", "commit": commit(), "seed": str(arguments.seed),
                "trained": f"{len(data['used'])} generated cases, the trees {len(more['used'])}, those of drags {len(dragged['used'])}"}
    write_joint_models(arguments.out, tensors, metadata)
    with open(arguments.out, "rb") as file:
        cases = boosted_trees.scored(lab, file.read(), tree_cases(dragged, 0, random))
    tensors.update(boosted_trees.correct(lab, tensors, cases, arguments.seed))
    if arguments.calibration_of:
        calibration = load_safetensors(arguments.calibration_of)[0]["ranker.calibration"].numpy()
    else:
        calibration = own_calibration(lab, kinematics, tensors, metadata, arguments.out, arguments.calibration_cases)
    write_joint_models(arguments.out, {**tensors, "ranker.calibration": calibration}, metadata)
    with open(arguments.out, "rb") as file:
        found = answers(lab, kinematics, file.read(), 77, len(validation["used"]), 1, chosen_kinds(lab, "trained"), pull="careful")
    print(f"whole library, validation: type {found['right_type'].mean():.3f} "
          f"{summary(found['pose'] < GOOD, found, np.array(names_by_id(lab)))}; "
          f"confidence = sigmoid(a logit(mass) + b), none, drag: {calibration.round(3).tolist()}", flush=True)


def run_answer(arguments):
    lab = open_lab(arguments.lab)
    kinematics, ranker = (open(path, "rb").read() for path in (arguments.weights, arguments.ranker))
    found = answers(lab, kinematics, ranker, arguments.seed, arguments.count, 1,
                    chosen_kinds(lab, arguments.only), arguments.clean, arguments.pull)
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
        write_whole(path, weights)
    return path


def ship(folder, models, out, share):
    """Makes the ranker of the folder `out`, for the KPP-Net in `models`; goes on where it was stopped. About an hour.
    First the prefilter, from cases all of whose candidates are evaluated; then the ranker, from prefiltered cases. A held-out
    ranker, which has not seen the held-out kinds (nor have the prefilter and the KPP-Net that it is asked with), says how well
    kinds are answered that nothing knows, and what the probabilities of such answers are worth. share: of the cases and the
    steps, less than 1 for a try."""
    from . import limits

    def some(count, least=LEAST):
        return str(max(round(share * count), least))

    os.makedirs(folder, exist_ok=True)
    shipped = os.path.join(models, "kpp_net.safetensors")
    earlier = committed_network(folder, "kpp_earlier", EARLIER_COMMIT)
    held_out = committed_network(folder, "kpp_held_out", HELD_OUT_COMMIT)
    prefilter_file, limits_file = (os.path.join(folder, name + ".safetensors") for name in ("prefilter", "limits"))
    if not os.path.exists(prefilter_file):
        every = case_files(run, folder, [
            (f"every{seed}", kinematics, seed, "--count", some(PREFILTER_CASES), "--pull", "careful")
            for seed, kinematics in zip(PREFILTER_SEEDS, (earlier, shipped))])
        prefilter.run([*every, "--steps", some(prefilter.STEPS), "-o", prefilter_file])
    with_prefilter = "--prefilter", prefilter_file, "--pull", "careful"
    networks = {seed: kinematics for seeds in (NETWORK_SEEDS, TREE_SEEDS)
                for kinematics, of_one in zip((earlier, shipped), seeds) for seed in of_one}
    paths = dict(zip(networks, case_files(run, folder, [
        (f"cases{seed}", kinematics, seed, "--count", some(CASES), *with_prefilter) for seed, kinematics in networks.items()])))
    of_network, of_trees = ([paths[seed] for of_one in seeds for seed in of_one] for seeds in (NETWORK_SEEDS, TREE_SEEDS))
    of_drags = case_files(run, folder, [
        (f"drags{seed}", kinematics, seed, "--count", some(DRAG_CASES), "--rows", str(DRAG_ROWS), "--with-drag", "1",
         "--prefilter", prefilter_file)
        for kinematics, of_one in zip((shipped, earlier), DRAG_SEEDS) for seed in of_one])
    limits.ship(folder, shipped, prefilter_file, limits_file, some)
    validation, = case_files(run, folder, [
        ("validation", shipped, 105, "--count", some(1500), "--split", "1", *with_prefilter)])
    common = ["train", *of_network, "--trees", *of_trees, "--drags", *of_drags, "--validate", validation, *with_prefilter[:2],
              "--limits", limits_file, "--steps", some(STEPS), "--calibration-cases", some(3000, 300)]
    held_out_ranker = os.path.join(folder, "held_out_ranker.safetensors")
    run([*common, "--weights", held_out, "--hold-out", "-o", held_out_ranker])
    run([*common, "--weights", shipped, "--calibration-of", held_out_ranker, "-o", os.path.join(out, "ranker.safetensors")])


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
    one.add_argument("--with-drag", type=float, default=0.7, help="share of the cases that have a drag")
    one.add_argument("--pull", choices=PULLS, default="mixed", help="how the parts are pulled (training/lab/pull.c)")
    one.add_argument("--weights")
    one.add_argument("--prefilter", help="weights of the prefilter; without them all candidates are evaluated")
    one.set_defaults(run=run_make)
    two = commands.add_parser("train")
    two.add_argument("data", nargs="+")
    two.add_argument("--trees", nargs="+", required=True, help="cases that the boosted trees are grown on")
    two.add_argument("--drags", nargs="+", required=True, help="cases with drags that the trees of drags are grown on")
    two.add_argument("--validate", required=True)
    two.add_argument("--lab", default=LAB)
    two.add_argument("--weights", required=True, help="the KPP-Net that answers are asked with")
    two.add_argument("--prefilter", required=True, help="what the cases were made with")
    two.add_argument("--limits", required=True, help="weights of the limit networks (limits.py)")
    two.add_argument("--calibration-cases", type=int, default=3000)
    two.add_argument("--calibration-of", help="the held-out ranker, whose calibration is taken; without it, fitted on the held-out kinds")
    two.add_argument("--steps", type=int, default=STEPS)
    two.add_argument("--batch", type=int, default=48)
    two.add_argument("--hidden", type=int, default=64)
    two.add_argument("--rate", type=float, default=2e-3)
    two.add_argument("--dropout", type=float, default=0.1)
    two.add_argument("--without-network", type=float, default=0.15, help="share of cases without KPP-Net's features")
    two.add_argument("--without-group", type=float, default=0.1, help="share of cases without a group of features, for each other group")
    two.add_argument("--seed", type=int, default=1)
    two.add_argument("--hold-out", action="store_true", help="leave out the kinds that HELD_OUT names")
    two.add_argument("-o", "--out", required=True)
    two.set_defaults(run=run_train)
    models = os.path.join(os.path.dirname(__file__), "..", "..", "sdk", "models")
    three = commands.add_parser("answer", help="what the whole library answers on fresh cases of the validation split")
    three.add_argument("--lab", default=LAB)
    three.add_argument("--weights", default=os.path.join(models, "kpp_net.safetensors"))
    three.add_argument("--ranker", default=os.path.join(models, "ranker.safetensors"))
    three.add_argument("--only", choices=ONLY, default="test_only")
    three.add_argument("--clean", action="store_true", help="objects without augmentation, masks and drags without errors")
    three.add_argument("--pull", choices=PULLS, default="tangent", help="how the parts are pulled (training/lab/pull.c)")
    three.add_argument("--count", type=int, default=4000)
    three.add_argument("--seed", type=int, default=91)
    three.set_defaults(run=run_answer)
    arguments = parser.parse_args(words)
    arguments.run(arguments)


if __name__ == "__main__":
    run(sys.argv[1:])
