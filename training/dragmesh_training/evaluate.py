"""Scores of both networks on generated objects (paper.md §C): categories that were trained on and test-only ones apart.

`python -m dragmesh_training.evaluate kpp|vae WEIGHTS [--split test] [--count N] [--json]` scores exported weights.
"""
import argparse
import json
import math

import numpy as np
import torch
import torch.nn.functional as F

from . import config, data, export
from .loaders.batches import Loaded
from .losses import (CONTINUOUS, PRISMATIC, REVOLUTE, SCREW, axis_error, chamfer, joint_poses, kl_divergence, rotate,
                     split_pose)
from .networks import DqVae, KppNet

BATCH = 128
THREADED = ("valve", "bottle", "jar", "pen")  # where screws are: under 1 % of all cases, too few to be scored among them
QUICK = {"kpp": ("type", "axis_mean", "axis_median", "line"),
         "vae": ("cd", "axis_constraint", "rev_trans", "qr1", "kl", "value_rms")}


def predict(network, model, arrays, device):
    """The network's outputs for all cases, and the cases as tensors, on the CPU."""
    outputs, inputs = [], []
    model.eval()
    with torch.no_grad():
        for begin in range(0, len(arrays["type"]), BATCH):
            batch = data.to_tensors({name: a[begin:begin + BATCH] for name, a in arrays.items()}, device)
            if network == "kpp":
                outputs.append(model.answer(batch["global_points"], batch["global_centres"], batch["local_points"],
                                            batch["local_centres"], batch["shape"]))
                batch = {name: value for name, value in batch.items() if "points" not in name}
            else:
                raw, mean, log_variance = model(batch)
                outputs.append({"raw": raw, "mean": mean, "log_variance": log_variance})
            inputs.append(batch)
    model.train()
    join = lambda parts: {name: torch.cat([p[name] for p in parts]).cpu() for name in parts[0]}  # noqa: E731
    return join(outputs), join(inputs)


def mean_of(values, mask=None):
    values = values if mask is None else values[mask]
    return float(values.mean()) if values.numel() else math.nan


def kpp_scores(output, truth):
    """Axis in mrad, unsigned as the paper's and signed where there is a drag; line distance and origin L1 x 1000 of the
    object's size, for turning joints."""
    kind = truth["type"]
    turning = kind != PRISMATIC
    dragged = truth["has_drag"] == 1
    raw = torch.where(turning.unsqueeze(-1), output["turn_axis"], output["slide_axis"])
    cosine = (F.normalize(raw, dim=-1) * truth["axis"]).sum(-1)
    angle = 1000 * torch.acos(cosine.abs().clamp(max=1.0))
    error = (output["origin"] - truth["origin"]) * truth["size"].unsqueeze(-1)
    line = 1000 * torch.linalg.cross(error, truth["axis"]).norm(dim=-1)
    guess = output["type_logits"].argmax(-1)
    scores = {"cases": len(kind), "type": mean_of((guess == kind).float()),
              "type_drag": mean_of((guess == kind).float(), dragged),
              "type_no_drag": mean_of((guess == kind).float(), ~dragged),
              "axis_mean": mean_of(angle), "axis_median": float(angle.median()),
              "axis_mean_drag": mean_of(angle, dragged), "axis_mean_no_drag": mean_of(angle, ~dragged),
              "axis_within_45": mean_of((angle < 45).float()), "sign": mean_of((cosine > 0).float(), dragged),
              "line": mean_of(line, turning), "line_drag": mean_of(line, turning & dragged),
              "line_median": float(line[turning].median()) if turning.any() else math.nan,
              "origin_l1": mean_of(1000 * error.abs().mean(-1), turning)}
    for name, index in (("revolute", REVOLUTE), ("prismatic", PRISMATIC), ("screw", SCREW), ("continuous", CONTINUOUS)):
        scores[f"type_{name}"] = mean_of((guess == kind).float(), kind == index)
        scores[f"axis_{name}"] = mean_of(angle, kind == index)
    return scores


def projected_values(kind, axis, values, rotation, translation, limits):
    """The joint value nearest to each pose, turns unwrapped over the frames: what the library plays (dmi_motion_project)."""
    turn = 2 * torch.atan2((rotation[..., :3] * axis.unsqueeze(1)).sum(-1), rotation[..., 3])
    unwrapped = torch.from_numpy(np.unwrap(turn.numpy(), axis=1)).float()
    unwrapped = unwrapped - 2 * math.pi * torch.round(unwrapped[:, :1] / (2 * math.pi))
    slide = (translation * axis.unsqueeze(1)).sum(-1)
    chosen = torch.where((kind == PRISMATIC).unsqueeze(-1), slide, unwrapped)
    chosen = torch.minimum(torch.maximum(chosen, limits[:, :1]), limits[:, 1:])
    chosen[:, 0] = 0
    return chosen


def moved_points(truth, rotation, translation):
    points = truth["xyz"][:, :256:4] - truth["origin"].unsqueeze(1)
    return rotate(rotation.unsqueeze(2), points.unsqueeze(1)) + translation.unsqueeze(2)


def across_axis(axis, translation):
    """Squared translation across the axis."""
    return torch.linalg.cross(translation, axis.unsqueeze(1).expand_as(translation)).pow(2).sum(-1)


def axis_constraint(kind, axis, rotation, translation, chosen):
    """As the paper's numbers: 2 (1 - |cos|) + sin^2 / 2 of turning samples that turn; |t x a|^2 of sliding ones. chosen: cases."""
    vector = rotation[..., :3]
    size = vector.norm(dim=-1)
    cosine = ((vector * axis.unsqueeze(1)).sum(-1) / size.clamp(min=1e-9)).abs().clamp(max=1.0)
    turning = 2 * (1 - cosine) + 0.5 * (1 - cosine ** 2)
    moves = (kind != PRISMATIC).unsqueeze(-1) & (size > math.sin(math.radians(0.5)))
    values = torch.where((kind == PRISMATIC).unsqueeze(-1), across_axis(axis, translation), turning)
    return mean_of(values, (moves | (kind == PRISMATIC).unsqueeze(-1)) & chosen.unsqueeze(-1))


def vae_scores(output, truth):
    """The raw network's penalties and Chamfer distance, its latent, and its joint values after projection beside the
    closed form's, both against the motion meant."""
    kind, axis = truth["type"], truth["axis"]
    rotation, translation, _ = split_pose(output["raw"])
    moved = moved_points(truth, rotation, translation)
    meant = moved_points(truth, *joint_poses(kind, axis, truth["pitch"], truth["values"]))
    values = projected_values(kind, axis, truth["values"], rotation, translation, truth["limits"])
    by_value = moved_points(truth, *joint_poses(kind, axis, truth["pitch"], values))
    by_closed = moved_points(truth, *joint_poses(kind, axis, truth["pitch"], truth["closed_form"]))
    kl = kl_divergence(output["mean"], output["log_variance"])
    turns_alone = (kind == REVOLUTE) | (kind == CONTINUOUS)
    steps = truth["values"].diff(dim=1)
    amplitude = truth["values"].abs().amax(-1).clamp(min=1e-6)

    def amplitude_error(v):
        return mean_of((v[:, -1] - truth["values"][:, -1]).abs() / amplitude)

    def timing_error(v):
        return mean_of((v.diff(dim=1) - steps).abs().mean(-1) / amplitude)

    return {"cases": len(kind), "cd": mean_of(chamfer(moved, meant)),
            "cd_projected": mean_of(chamfer(by_value, meant)), "cd_closed_form": mean_of(chamfer(by_closed, meant)),
            "axis_constraint": axis_constraint(kind, axis, rotation, translation, kind >= 0),
            "rev_trans": mean_of(translation[turns_alone].pow(2).sum(-1)),
            "qr1": mean_of((2 * torch.atan2(rotation[..., :3].norm(dim=-1), rotation[..., 3].abs())).pow(2)[kind == PRISMATIC]),
            **{f"axis_{name}": axis_constraint(kind, axis, rotation, translation, kind == index) for name, index in
               (("revolute", REVOLUTE), ("prismatic", PRISMATIC), ("screw", SCREW), ("continuous", CONTINUOUS))},
            "slide_screw": mean_of(across_axis(axis, translation)[kind == SCREW]),
            "kl": mean_of(kl.sum(-1)), "active_dims": int((output["mean"].var(dim=0) > 0.01).sum()),
            "value_rms": float(((values - truth["values"]) / amplitude.unsqueeze(-1)).pow(2).mean().sqrt()),
            "value_rms_closed_form": float(((truth["closed_form"] - truth["values"]) / amplitude.unsqueeze(-1)).pow(2).mean().sqrt()),
            "amplitude": amplitude_error(values), "amplitude_closed_form": amplitude_error(truth["closed_form"]),
            "timing": timing_error(values), "timing_closed_form": timing_error(truth["closed_form"]),
            "vertex_end": mean_of((by_value[:, -1] - meant[:, -1]).norm(dim=-1).mean(-1)),
            "vertex_end_closed_form": mean_of((by_closed[:, -1] - meant[:, -1]).norm(dim=-1).mean(-1))}


def score(network, model, arrays, device="cpu"):
    output, truth = predict(network, model, arrays, device)
    return kpp_scores(output, truth) if network == "kpp" else vae_scores(output, truth)


_validation = {}


def quick_scores(network, model, device):
    """A few scores on 512 validation cases of the trained categories."""
    if network not in _validation:
        lab = data.Lab()
        _validation[network] = data.make_batch(lab, network, 7, 512, data.trained_categories(lab), "validation")
    scores = score(network, model, _validation[network], device)
    return {name: scores[name] for name in QUICK[network]}


def latent_effects(model, arrays):
    """What moves along each active dimension of z: every case decoded with that dimension a standard deviation (over cases) below
    and above its mean, all else held. extent: change of the last joint value, share of the stroke; pace: change of the frame
    at which half of the way is done; off_joint: mean distance of moved points from where the projected value puts them."""
    truth = data.to_tensors(arrays, "cpu")
    kind, axis = truth["type"], truth["axis"]
    rows = []
    with torch.no_grad():
        f_joint, embedded, mean, log_variance = model.encode(truth)
        active = (mean.var(dim=0) > 0.01).nonzero().flatten().tolist()

        def values_at(z):
            rotation, translation, _ = split_pose(model.decode(z, f_joint, embedded, axis))
            values = projected_values(kind, axis, truth["values"], rotation, translation, truth["limits"])
            exact = moved_points(truth, *joint_poses(kind, axis, truth["pitch"], values))
            return values, (moved_points(truth, rotation, translation) - exact).norm(dim=-1).mean()

        def half_way(values):
            return (values.abs() < 0.5 * values[:, -1:].abs()).float().sum(dim=1)

        stroke = values_at(mean)[0][:, -1].abs().clamp(min=1e-6)
        for dimension in active:
            step = torch.zeros_like(mean[0])
            step[dimension] = mean[:, dimension].std()
            (low, off_low), (high, off_high) = values_at(mean - step), values_at(mean + step)
            kl = kl_divergence(mean, log_variance)[:, dimension]
            rows.append({"dimension": dimension, "kl": mean_of(kl), "step": float(step[dimension]),
                         "extent": float(((high[:, -1] - low[:, -1]) / stroke).median()),
                         "extent_size": float(((high[:, -1] - low[:, -1]).abs() / stroke).median()),
                         "pace": mean_of(half_way(high) - half_way(low)), "off_joint": float(0.5 * (off_low + off_high))})
    return rows


def print_latent_effects(model, count):
    lab = data.Lab()
    arrays = data.make_batch(lab, "vae", 13, count, data.trained_categories(lab), "test")
    rows = sorted(latent_effects(model, arrays), key=lambda row: -row["kl"])
    print("".join(f"{name:>14}" for name in rows[0]) if rows else "no active dimension")
    for row in rows:
        print("".join(f"{value:14.4g}" for value in row.values()))


def load_model(network, path):
    model = KppNet() if network == "kpp" else DqVae()
    tensors, _ = export.load_safetensors(path)
    model.load_state_dict(tensors)
    return model


def full_scores(network, model, split, count, seed=11):
    """Trained and test-only categories apart, as in training and clean: for KPP-Net objects, masks and drags without mistakes, for
    the VAE a steady hand and the exact joint. For KPP-Net as the paper has it, too: its categories, clean, always with a drag. For
    the VAE screws apart."""
    lab = data.Lab()
    groups = {which: config.kinds_of(lab.kinds, which) for which in ("trained", "test_only")}
    clean = {**config.MIX, "mask_noise": 0.0, "drag_noise_degrees": 0.0}
    clean.update({"messy": 0.0} if network == "kpp" else {"joint_noise": 0.0, "hand_noise": 0.0})
    mixes = {"": config.MIX, "_clean": clean}
    result = {}
    for group, categories in groups.items():
        for name, mix in mixes.items():
            if categories:
                arrays = data.make_batch(lab, network, seed, count, categories, split, mix)
                result[group + name] = score(network, model, arrays)
    if network == "kpp":
        paper = config.kinds_of(lab.kinds, "paper")
        arrays = data.make_batch(lab, network, seed, count, paper, split, {**clean, "with_drag": 1.0})
        result["paper_clean_drag"] = score(network, model, arrays)
    if network == "vae":
        arrays = data.make_batch(lab, network, seed, count, THREADED, split)
        screws = arrays["type"] == SCREW
        result["screws"] = score(network, model, {name: array[screws] for name, array in arrays.items()})
    return result


def loaded_scores(network, model, folder, count, seed=11):
    """Of the joints of a folder's objects (loaders), their drags as exact as they come."""
    mix = {**config.MIX, "drag_noise_degrees": 0.0, "joint_noise": 0.0}
    arrays = Loaded(folder).batch(data.Lab(), network, seed, count, mix)
    return {"loaded": score(network, model, data.packed(network, arrays))}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("network", choices=("kpp", "vae"))
    parser.add_argument("weights")
    parser.add_argument("--split", default="test", choices=("train", "validation", "test"))
    parser.add_argument("--count", type=int, default=4096)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--data", metavar="DIR", help="score on these objects (object.glb + joints.json) instead of generated ones")
    parser.add_argument("--latent", action="store_true", help="vae: what moves along each active dimension of z, instead")
    options = parser.parse_args()
    torch.set_num_threads(1)
    if options.latent:
        print_latent_effects(load_model("vae", options.weights), options.count)
        return
    model = load_model(options.network, options.weights)
    scores = (loaded_scores(options.network, model, options.data, options.count) if options.data
              else full_scores(options.network, model, options.split, options.count))
    if options.json:
        print(json.dumps(scores, indent=1))
        return
    names = list(next(iter(scores.values())))
    print(f"{'':24}" + "".join(f"{group:>18}" for group in scores))
    for name in names:
        print(f"{name:24}" + "".join(f"{group[name]:18.5g}" for group in scores.values()))


if __name__ == "__main__":
    main()
