"""The ranker of candidate joints: evidence of generated cases in, sdk/models/ranker.safetensors out.

    python -m dragmesh_training.ranker make OUT.npz --seed 1 --count 4000 [--split train] [--only held|trained]
    python -m dragmesh_training.ranker train A.npz B.npz --validate V.npz -o ranker.safetensors

Each candidate's target is exp(-pose / 0.01), its pose error being what a player would see; the softmax over a case's
candidates learns to share its probability that way. A temperature fitted on validation cases calibrates it.
"""
import argparse
import ctypes
import json
import os
import struct
import subprocess
import time

import numpy as np

from .config import HELD_OUT
KEPT_BEST = 8
SHARPNESS = float(os.environ.get('SHARP','0.01'))
GOOD = 0.02


class Options(ctypes.Structure):
    _fields_ = [("seed", ctypes.c_uint64), ("count", ctypes.c_uint32), ("split", ctypes.c_int32),
                ("categories", ctypes.c_void_p)] + [
        (name, ctypes.c_float) for name in ("messy", "mask_noise", "rotated", "with_drag", "drag_noise_degrees",
                                            "joint_noise", "hand_noise")]


ARRAYS = (("pose", np.float32, True), ("used", np.int32, False), ("total", np.int32, False), ("type", np.int32, False),
          ("has_drag", np.int32, False), ("category", np.int32, False), ("best", np.float32, False),
          ("axis_error", np.float32, True), ("line_error", np.float32, True))


class Batch(ctypes.Structure):
    _fields_ = [("rows", ctypes.c_uint32), ("evidence", ctypes.c_void_p)] + [
        (name, ctypes.c_void_p) for name, _, _ in ARRAYS]


def open_lab(path):
    lab = ctypes.CDLL(path)
    lab.dm_lab_category_name.restype = ctypes.c_char_p
    return lab


def category_names(lab):
    return [lab.dm_lab_category_name(i).decode() for i in range(lab.dm_lab_category_count())]


def make(lab, seed, count, rows, split, chosen, noise_degrees, weights=None, with_drag=0.7, mask_noise=0.15):
    """Evidence and labels of `count` cases drawn from the chosen categories."""
    columns = lab.dm_lab_ranker_columns()
    mask = np.array([name in chosen for name in category_names(lab)], np.uint8)
    data = {"evidence": np.zeros((count, rows, columns), np.float32)}
    for name, dtype, each_row in ARRAYS:
        data[name] = np.zeros((count, rows) if each_row else count, dtype)
    options = Options(seed, count, split, mask.ctypes.data, 0.5, mask_noise, 1.0, with_drag, noise_degrees, 0, 0)
    batch = Batch(rows, *[data[name].ctypes.data for name in ("evidence", *[a[0] for a in ARRAYS])])
    size = ctypes.c_size_t(len(weights) if weights else 0)
    result = lab.dm_lab_ranker_batch(ctypes.byref(options), weights, size, ctypes.byref(batch))
    if result != 0:
        raise RuntimeError(f"dm_lab_ranker_batch: {result}")
    return data


def run_make(arguments):
    lab = open_lab(arguments.lab)
    names = category_names(lab)
    chosen = {"all": names, "held": [n for n in names if n in HELD_OUT],
              "trained": [n for n in names if n not in HELD_OUT]}[arguments.only]
    weights = open(arguments.weights, "rb").read() if arguments.weights else None
    start, parts = time.time(), []
    for first in range(0, arguments.count, 100):
        count = min(100, arguments.count - first)
        part = make(lab, arguments.seed * 1000003 + first, count, arguments.rows, arguments.split, chosen,
                    arguments.noise, weights)
        part["evidence"] = part["evidence"].astype(np.float16)
        parts.append(part)
    data = {name: np.concatenate([p[name] for p in parts]) for name in parts[0]}
    np.savez(arguments.out, names=np.array(names), **data)
    print(f"{arguments.count} cases in {time.time() - start:.0f} s; best candidate under 2 %: "
          f"{(data['best'] < GOOD).mean():.3f}; candidates {data['total'].mean():.0f}")


def load(paths, without=()):
    """Cases of all files, those of the categories `without` left out."""
    parts = [np.load(path) for path in paths]
    data = {name: np.concatenate([p[name] for p in parts]) for name in parts[0].files if name != "names"}
    keep = ~np.isin(parts[0]["names"][data["category"]], without)
    return {name: array[keep] for name, array in data.items()}


def log_weights(data):
    """Rows after the best few are a sample: each stands for several."""
    rows = data["pose"].shape[1]
    sampled = np.maximum(data["used"] - KEPT_BEST, 1)
    weight = np.log(np.maximum(data["total"] - KEPT_BEST, 1) / sampled)
    out = np.where(np.arange(rows)[None] < KEPT_BEST, 0, weight[:, None])
    return np.where(np.arange(rows)[None] < data["used"][:, None], out, -1e9).astype(np.float32)


def build(columns):
    import torch
    return torch.nn.Sequential(torch.nn.Linear(columns, 64), torch.nn.ReLU(), torch.nn.Linear(64, 64), torch.nn.ReLU(),
                               torch.nn.Linear(64, 1))


def evaluate(net, data, mean, scale, temperature=1.0):
    """Share of good answers, and how far stated confidence is from it."""
    import torch
    good, confidence = [], []
    extra = log_weights(data)
    with torch.no_grad():
        for i in range(len(data["used"])):
            n = data["used"][i]
            x = (torch.from_numpy(data["evidence"][i, :n].astype(np.float32)) - mean) * scale
            logits = (net(x)[:, 0] + torch.from_numpy(extra[i, :n])) / temperature
            p = torch.softmax(logits, 0).numpy()
            best = p.argmax()
            near = (np.abs(data["pose"][i, :n] - data["pose"][i, best]) < 0.01)
            good.append(data["pose"][i, best] < GOOD)
            confidence.append(p[near].sum())
    return np.array(good), np.array(confidence)


def summary(good, data, names):
    drag = data["has_drag"] > 0
    text = f"pose<2% drag {good[drag].mean():.3f} none {good[~drag].mean():.3f} |"
    for c in np.unique(data["category"]):
        text += f" {names[c]} {good[data['category'] == c].mean():.2f}"
    return text


def fit(data, validation, names, seconds, seed):
    import torch
    torch.manual_seed(seed)
    torch.set_num_threads(1)
    flat = data["evidence"][:800].astype(np.float32)[data["used"][:800, None] > np.arange(data["pose"].shape[1])]
    mean = torch.from_numpy(flat.mean(0))
    scale = 1 / (torch.from_numpy(flat.std(0)) + 0.05)
    extra, target = torch.from_numpy(log_weights(data)), torch.from_numpy(-data["pose"] / SHARPNESS)
    net = build(len(mean))
    optimiser = torch.optim.AdamW(net.parameters(), 2e-3, weight_decay=1e-2)
    random, start, steps, total = np.random.default_rng(seed), time.time(), 0, 0.0
    best, best_good = None, -1
    next_check = seconds / 8
    while time.time() - start < seconds:
        rate = 1 - (time.time() - start) / seconds
        for group in optimiser.param_groups:
            group["lr"] = 2e-3 * rate + 2e-5
        index = random.integers(0, len(extra), 24)
        x = (torch.from_numpy(data["evidence"][index].astype(np.float32)) - mean) * scale
        logits = net(x)[..., 0] + extra[index]
        wanted = torch.softmax(target[index] + extra[index], 1)
        loss = -(wanted * torch.log_softmax(logits, 1)).sum(1).mean()
        optimiser.zero_grad()
        loss.backward()
        optimiser.step()
        steps, total = steps + 1, 0.98 * total + 0.02 * loss.item()
        if time.time() - start > next_check or rate <= 0:
            good, _ = evaluate(net, validation, mean, scale)
            print(f"{time.time() - start:5.0f} s {steps} steps loss {total:.3f} {summary(good, validation, names)}",
                  flush=True)
            next_check += seconds / 8
            if good.mean() >= best_good:
                best, best_good = {k: v.clone() for k, v in net.state_dict().items()}, good.mean()
    net.load_state_dict(best)
    return net, mean, scale


def calibrate(net, validation, mean, scale):
    """The temperature whose confidences are nearest to the truth (least squared error)."""
    best = (np.inf, 1.0)
    for temperature in np.exp(np.linspace(np.log(0.2), np.log(4), 31)):
        good, confidence = evaluate(net, validation, mean, scale, temperature)
        best = min(best, (((confidence - good) ** 2).mean(), temperature))
    return best[1]


def export(path, tensors, metadata):
    header, offset = {"__metadata__": metadata}, 0
    for name, array in tensors.items():
        size = array.astype("<f4").nbytes
        header[name] = {"dtype": "F32", "shape": list(array.shape), "data_offsets": [offset, offset + size]}
        offset += size
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 8)
    with open(path, "wb") as file:
        file.write(struct.pack("<Q", len(text)) + text)
        for array in tensors.values():
            file.write(array.astype("<f4").tobytes())


def run_train(arguments):
    names = list(np.load(arguments.data[0])["names"])
    data = load(arguments.data, () if arguments.everything else HELD_OUT)
    validation = load([arguments.validate])
    net, mean, scale = fit(data, validation, names, arguments.seconds, arguments.seed)
    temperature = arguments.temperature or calibrate(net, validation, mean, scale)
    good, confidence = evaluate(net, validation, mean, scale, temperature)
    print(f"validation: {good.mean():.3f} good at mean confidence {confidence.mean():.3f}, temperature {temperature:.2f}")
    tensors = {"mean": mean.numpy(), "scale": scale.numpy(), "temperature": np.array([temperature], np.float32)}
    tensors.update({name: value.numpy() for name, value in net.state_dict().items()})
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True).stdout.strip()
    export(arguments.out, tensors, {"architecture": "dragmesh-ranker", "version": "1", "commit": commit,
                                    "seed": str(arguments.seed), "trained": f"{len(data['used'])} generated cases"})


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(required=True)
    default_lab = os.path.join(os.path.dirname(__file__), "..", "..", "build", "release", "libdragmesh_lab.so")
    one = commands.add_parser("make")
    one.add_argument("out")
    one.add_argument("--lab", default=default_lab)
    one.add_argument("--seed", type=int, default=1)
    one.add_argument("--count", type=int, default=2000)
    one.add_argument("--rows", type=int, default=384)
    one.add_argument("--split", type=int, default=0)
    one.add_argument("--noise", type=float, default=12.0)
    one.add_argument("--only", choices=("all", "held", "trained"), default="all")
    one.add_argument("--weights")
    one.set_defaults(run=run_make)
    two = commands.add_parser("train")
    two.add_argument("data", nargs="+")
    two.add_argument("--validate", required=True)
    two.add_argument("--seconds", type=float, default=120)
    two.add_argument("--seed", type=int, default=1)
    two.add_argument("--everything", action="store_true", help="train on the held-out categories too")
    two.add_argument("--temperature", type=float, help="as a run without the held-out categories found it")
    two.add_argument("-o", "--out", required=True)
    two.set_defaults(run=run_train)
    arguments = parser.parse_args()
    arguments.run(arguments)


if __name__ == "__main__":
    main()
