"""The paper's three ablation tables and its efficiency table, row by row (see ../ablate)."""
import csv
import io
import json
import math
import os
import subprocess
import time
from dataclasses import replace

import numpy as np
import torch
from torch import nn

from . import config, data, evaluate, losses, train
from .files import save_arrays, write_whole
from .networks import KPP_SIZES, VAE_SIZES, Attention, DqVae, KppNet

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "ablations")
CACHE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "runs", "ablation_data")
TEST_CASES = 1024
SEED = 5
RATE = 1e-3
PHYSICS = ("axis", "qd0", "qr1", "drag")


def vae_row(parts=(), physics=True, free_bits=True):
    """A DQ-VAE with these parts of the network."""
    base = config.VaeTraining()
    weights = {name: 0.0 if name in PHYSICS and not physics else value for name, value in base.weights.items()}
    return replace(base, seed=SEED, parts={name: int(name in parts) for name in base.parts}, weights=weights,
                   free_nats=base.free_nats if free_bits else 0.0)


def kpp_row(*parts):
    base = config.KppTraining()
    return replace(base, seed=SEED, weights={**base.weights, "choice": 0.0}, parts={name: int(name in parts) for name in base.parts})


PARTS = ("transformer", "fusion", "local_film", "decoder_film", "correction")
TABLES = {
    "architecture": {
        "M1 VAE, MLP decoder": vae_row((), physics=False),
        "M2 + Transformer decoder": vae_row(PARTS[:1], physics=False),
        "M3 + local sampler and gate": vae_row(PARTS[:2], physics=False),
        "M4 + FiLM of the local sampler": vae_row(PARTS[:3], physics=False),
        "M5 + FiLM in the decoder": vae_row(PARTS[:4], physics=False),
        "M6 + physics correction": vae_row(PARTS, physics=False),
        "M7 + physics losses (ours)": vae_row(PARTS),
    },
    "loss": {
        "(1) reconstruction, plain KL": vae_row(PARTS, physics=False, free_bits=False),
        "(2) + physics losses": vae_row(PARTS, free_bits=False),
        "(3) + free bits": vae_row(PARTS, physics=False),
        "(4) both (ours)": vae_row(PARTS),
    },
    "kpp": {
        "PointNet": kpp_row(),
        "+ mask": kpp_row("mask"),
        "+ drag": kpp_row("mask", "drag"),
        "+ attention encoders": kpp_row("mask", "drag", "attention"),
        "+ decoupled heads": kpp_row("mask", "drag", "attention", "decoupled"),
        "+ shape numbers (ours)": kpp_row("mask", "drag", "attention", "decoupled", "shape"),
    },
    "efficiency": {},
}
COLUMNS = {
    "architecture": ("cd", "axis_constraint", "qr1", "rev_trans", "kl", "value_rms"),
    "loss": ("axis_constraint", "rev_trans", "cd", "kl", "value_rms"),
    "kpp": ("axis_mean", "axis_median", "origin_l1", "line", "type"),
    "efficiency": ("parameters", "bytes", "gflop", "ms_pytorch", "ms_library"),
}


def path_of(table, kind="csv"):
    return os.path.join(FOLDER, f"{table}.{kind}")


def read(table):
    if not os.path.exists(path_of(table)):
        return {}
    with open(path_of(table), newline="") as file:
        return {row["row"]: row for row in csv.DictReader(file)}


def write(table, rows):
    os.makedirs(FOLDER, exist_ok=True)
    names = ["row", *dict.fromkeys(name for row in rows.values() for name in row if name != "row")]
    text = io.StringIO()
    writer = csv.DictWriter(text, names, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows.values())
    write_whole(path_of(table), text.getvalue().encode())


def cases(lab, network, split, count):
    """Made once and kept: data of a table's rows is the same."""
    os.makedirs(CACHE, exist_ok=True)
    path = os.path.join(CACHE, f"{network}_{split}_{count}.npz")
    if not os.path.exists(path):
        chunks = [data.make_batch(lab, network, SEED * 7919 + i, min(512, count - i), data.trained_categories(lab), split)
                  for i in range(0, count, 512)]
        save_arrays(path, **{name: np.concatenate([c[name] for c in chunks]) for name in chunks[0]})
    with np.load(path) as kept:
        return dict(kept)


def train_row(row, arrays, steps, log):
    """The averaged network after `steps`, on random batches of the arrays."""
    torch.manual_seed(row.seed)
    random = np.random.default_rng(row.seed)
    model, average = train.make_network(row), train.make_network(row)
    average.load_state_dict(model.state_dict())
    optimizer = torch.optim.AdamW(model.parameters(), lr=RATE, weight_decay=row.decay)
    warm_up, total = max(1, min(100, steps // 5)), 0.0
    for step in range(steps):
        index = random.integers(0, len(arrays["type"]), row.batch)
        batch = data.to_tensors({name: array[index] for name, array in arrays.items()}, "cpu")
        loss = losses.weighted(train.batch_losses(row, model, train.prepared(row, batch)), row.weights)
        share = 0.01 + 0.99 * 0.5 * (1 + math.cos(math.pi * step / steps))
        for group in optimizer.param_groups:
            group["lr"] = RATE * min(1.0, (step + 1) / warm_up) * share
        optimizer.zero_grad(set_to_none=True)
        loss.backward()
        torch.nn.utils.clip_grad_norm_(model.parameters(), 1.0)
        optimizer.step()
        keep = min(0.99, (step + 1) / (step + 10))
        with torch.no_grad():
            for averaged, weight in zip(average.parameters(), model.parameters()):
                averaged.lerp_(weight, 1 - keep)
        total += float(loss)
        if (step + 1) % 50 == 0:
            log(step + 1, total / 50)
            total = 0.0
    return average


def same_run(name, table, row, steps):
    """The result of the same configuration in another table, when it is there."""
    for other, rows in TABLES.items():
        for other_name, other_row in rows.items():
            kept = read(other).get(other_name)
            if (other, other_name) != (table, name) and other_row == row and kept and int(kept["steps"]) == steps:
                return {**kept, "row": name}
    return None


def run_row(lab, table, name, row, steps, count):
    kept = same_run(name, table, row, steps)
    if kept:
        return kept
    arrays = cases(lab, row.network, "train", count)
    begun = time.process_time()
    os.makedirs(FOLDER, exist_ok=True)

    def log(step, loss):
        with open(path_of(table, "log.csv"), "a", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            if file.tell() == 0:
                writer.writerow(("row", "step", "loss"))
            writer.writerow((name, step, f"{loss:.5g}"))
        print(f"{table} {name}: {step}/{steps} loss {loss:.4g} ETA {(time.process_time() - begun) * (steps / step - 1):.0f} s",
              flush=True)

    model = train_row(row, arrays, steps, log)
    scores = evaluate.score(row.network, model, cases(lab, row.network, "test", TEST_CASES))
    parameters = sum(p.numel() for p in model.parameters())
    scores.pop("cases")
    return {"row": name, "steps": steps, "batch": row.batch, "training_cases": count, "test_cases": TEST_CASES, "seed": row.seed,
            "cpu_seconds": round(time.process_time() - begun), "parameters": parameters,
            **{key: f"{value:.6g}" for key, value in scores.items()}}


# ---- efficiency --------------------------------------------------------------------------------------------------

def count_flop(model, call):
    """Of all products of one call: linear layers by hooks, and attention's two."""
    total = [0]

    def linear(module, inputs, _):
        total[0] += 2 * inputs[0].numel() // module.in_features * module.in_features * module.out_features

    def attention(_, inputs, __):
        batch, tokens, dim = inputs[0].shape
        total[0] += 4 * batch * tokens * tokens * dim

    hooks = [m.register_forward_hook(linear if isinstance(m, nn.Linear) else attention) for m in model.modules()
             if isinstance(m, (nn.Linear, Attention))]
    call()
    for hook in hooks:
        hook.remove()
    return total[0]


def library_times():
    """Median milliseconds of the built library's own bench; empty without a build."""
    root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
    tool = os.path.join(root, "build", "release", "dragmesh")
    if not os.path.exists(tool):
        return {}
    found = subprocess.run([tool, "bench", "--json"], capture_output=True, text=True, cwd=root)
    if found.returncode != 0:
        return {}
    return {row["name"]: row["median_ns"] * 1e-6 for row in json.loads(found.stdout)["rows"]}


def efficiency_rows(lab):
    measured, rows = library_times(), {}
    for network, sizes, make, name in (("kpp", KPP_SIZES, KppNet, "KPP-Net"), ("vae", VAE_SIZES, DqVae, "DQ-VAE")):
        one = data.to_tensors(data.make_batch(lab, network, SEED, 1, data.trained_categories(lab), "test"), "cpu")
        for size in ("game", "paper"):
            model = make(sizes[size]).eval()
            with torch.no_grad():
                def call():
                    return train.run_network(network, model, one, False)
                flop = count_flop(model, call)
                times = []
                for _ in range(20):
                    begun = time.process_time()
                    call()
                    times.append(time.process_time() - begun)
            parameters = sum(p.numel() for p in model.parameters())
            key = "motion_generate" if network == "vae" else ""  # KPP-Net is a part of object_prepare alone
            rows[f"{name}, {size}"] = {
                "row": f"{name}, {size}", "parameters": parameters, "bytes": 2 * parameters, "gflop": f"{flop * 1e-9:.4g}",
                "ms_pytorch": f"{1000 * float(np.median(times)):.4g}",
                "ms_library": f"{measured[key]:.4g}" if size == "game" and key in measured else ""}
    return rows


def run(tables, only, steps, count, threads):
    torch.set_num_threads(threads)
    lab = data.Lab()
    for table in tables:
        if table == "efficiency":
            write(table, efficiency_rows(lab))
            continue
        for name, row in TABLES[table].items():
            rows = read(table)
            if (only is not None and name != only) or (only is None and name in rows):
                continue
            rows[name] = run_row(lab, table, name, row, steps, count)
            write(table, {key: rows[key] for key in TABLES[table] if key in rows})


def markdown(tables):
    lines = []
    for table in tables:
        lines += [f"**{table}**", "", "| | " + " | ".join(COLUMNS[table]) + " |", "|---" * (len(COLUMNS[table]) + 1) + "|"]
        for name, row in read(table).items():
            values = []
            for column in COLUMNS[table]:
                text = row.get(column, "")
                values.append(f"{float(text):.3g}" if text and "." in text else text)
            lines.append(f"| {name} | " + " | ".join(values) + " |")
        lines.append("")
    return "\n".join(lines)
