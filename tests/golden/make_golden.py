#!/usr/bin/env python3
"""Writes what PyTorch answers with the shipped weights, for test_golden_kpp.c and test_golden_vae.c to compare with.

    /usr/bin/python3 tests/golden/make_golden.py [--models sdk/models] [--out tests/golden/data]

Run it after every change of the weights. The features of a drag are computed here anew, in double precision and from
the words of docs/networks.md, so that the C code is not compared with itself.
"""
import argparse
import json
import math
import sys
from pathlib import Path

import numpy as np
import torch

REPO = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPO / "training"))
from dragmesh_training.choice import line_numbers  # noqa: E402
from dragmesh_training.networks import DqVae, KppNet  # noqa: E402

PART, NEAR, BODY = 2048, 1024, 1024  # of a cloud, as sdk/mesh/cloud.h lays them out


def read_safetensors(path):
    data = path.read_bytes()
    length = int.from_bytes(data[:8], "little")
    header = json.loads(data[8:8 + length])
    header.pop("__metadata__", None)
    body = data[8 + length:]
    kinds = {"F32": "<f4", "F16": "<f2"}
    return {name: np.frombuffer(body[slice(*entry["data_offsets"])], kinds[entry["dtype"]]).astype("f4")
            .reshape(entry["shape"]) for name, entry in header.items()}


def fingerprint(path):
    """FNV-1a of a file, by which a golden file names its weights."""
    value = 0xCBF29CE484222325
    for byte in path.read_bytes():
        value = (value ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return f"{value:016x}"


def write_safetensors(path, tensors, architecture, **metadata):
    header, body = {"__metadata__": {"architecture": architecture, "version": "1", **metadata}}, b""
    for name, tensor in tensors.items():
        stored = np.ascontiguousarray(tensor, "<f4").tobytes()
        header[name] = {"dtype": "F32", "shape": list(np.shape(tensor)),
                        "data_offsets": [len(body), len(body) + len(stored)]}
        body += stored
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 8)
    path.write_bytes(len(text).to_bytes(8, "little") + text + body)


def load(module, path):
    module.load_state_dict({name: torch.from_numpy(value.copy()) for name, value in read_safetensors(path).items()})
    return module.eval()


def box_surface(rng, low, high, count):
    """Points and normals on a box, by area."""
    low, high = np.array(low), np.array(high)
    size = high - low
    areas = np.repeat([size[1] * size[2], size[0] * size[2], size[0] * size[1]], 2)
    faces = rng.choice(6, count, p=areas / areas.sum())
    points = low + size * rng.random((count, 3))
    normals = np.zeros((count, 3))
    rows = np.arange(count)
    points[rows, faces // 2] = np.where(faces % 2, high[faces // 2], low[faces // 2])
    normals[rows, faces // 2] = np.where(faces % 2, 1.0, -1.0)
    return points, normals


def cabinet(rng):
    """A cloud of a cabinet with a door in front: part, near, body."""
    door = ((-0.38, -0.48, 0.25), (0.02, 0.45, 0.28))
    body = ((-0.4, -0.5, -0.25), (0.4, 0.5, 0.25))
    part = box_surface(rng, *door, PART)
    near = box_surface(rng, (-0.4, -0.5, 0.1), (0.1, 0.5, 0.25), NEAR)
    rest = box_surface(rng, *body, BODY)
    return [np.concatenate(pair) for pair in zip(part, near, rest)]


# KPP-Net ---------------------------------------------------------------------------------------------------------


def farthest_points(points, count):
    chosen, distance = [0], np.full(len(points), np.inf)
    for _ in range(count - 1):
        distance = np.minimum(distance, ((points - points[chosen[-1]]) ** 2).sum(1))
        chosen.append(int(distance.argmax()))
    return chosen


def grouped(rng, y, normals, mask, drag, centres):
    """Groups of 16 points with their 17 channels, and the centres."""
    groups = []
    for centre in centres:
        near = np.argsort(((y - y[centre]) ** 2).sum(1), kind="stable")[:16]
        groups.append(np.concatenate([y[near], mask[near, None], np.tile(drag, (16, 1)), 2 * (y[near] - y[centre]),
                                      normals[near], rng.random((16, 1))], axis=1))
    return np.array(groups, "f4"), np.array(y[centres], "f4")


def directions(rng):
    """Nine unit vectors, as the part, the body and the principal axes give them."""
    vectors = rng.normal(0, 1, (9, 3))
    return (vectors / np.linalg.norm(vectors, axis=1, keepdims=True)).flatten()


CANDIDATES = 40


def candidates(net, rng, known, shape):
    """Candidates as the library has them (in a frame of the object's, whose way into the network's frame is given), and their
    scores."""
    rotation = np.linalg.qr(rng.normal(0, 1, (3, 3)))[0]
    rotation *= np.sign(np.linalg.det(rotation))
    start, scale = rng.normal(0, 0.2, 3), 2.5
    axis = rng.normal(0, 1, (CANDIDATES, 3))
    axis /= np.linalg.norm(axis, axis=1, keepdims=True)
    origin, slides = rng.normal(0, 0.7, (CANDIDATES, 3)), np.arange(CANDIDATES) % 4 == 0
    given = [torch.from_numpy(v.astype("f4"))[None] for v in (axis, origin)]
    scores = net.choice(known, line_numbers(torch.from_numpy(slides)[None], *given, shape))[0]
    return {"frame": np.array([*rotation.flatten(), *start, scale], "f4"), "candidate_slides": slides.astype("f4"),
            "candidate_axis": axis @ rotation, "candidate_origin": start + origin @ rotation / scale, "scores": scores}


def kpp_case(net, rng, points, normals, drag):
    """A plausible input: as sdk/kinematics/kpp/kpp_input.c makes it, but for the choice of the frame."""
    pick = np.concatenate([np.arange(512), PART + np.arange(256), PART + NEAR + np.arange(256)])
    x, n = points[pick], normals[pick]
    centre = x[:512].mean(0)
    y = (x - centre) / np.linalg.norm(x[:512] - centre, axis=1).max()
    mask = np.arange(1024) < 512
    inputs = {}
    inputs["global_points"], inputs["global_centres"] = grouped(rng, y, n, mask, drag, farthest_points(y, 48))
    inputs["local_points"], inputs["local_centres"] = grouped(rng, y[:512], n[:512], mask[:512], drag,
                                                              farthest_points(y[:512], 24))
    inputs["shape"] = np.array([*directions(rng), *rng.normal(0, 0.3, 3), 0.9, 0.8, 0.1, *rng.normal(0, 0.3, 3), 1, 1, 1,
                                *drag, 0.4, 0.9, 0.7, 0.8, *rng.normal(0, 0.3, 6), 0.4], "f4")
    batch = {name: torch.from_numpy(value)[None] for name, value in inputs.items()}
    outputs = {name: value[0] for name, value in net.answer(*batch.values()).items()}
    chosen = candidates(net, rng, outputs.pop("known")[None], batch["shape"])
    pooled = {"between.global": net._modules["global"](batch["global_points"], batch["global_centres"])[0],
              "between.local": net.local(batch["local_points"], batch["local_centres"])[0]}
    for name in ("global_points", "local_points"):
        inputs[name] = inputs[name].reshape(-1, 17)
    return {**inputs, **outputs, **pooled, **chosen}


# DQ-VAE ----------------------------------------------------------------------------------------------------------

JOINTS = {  # type index, axis, origin, pitch, lower, upper
    "revolute": (0, (0.0, 1.0, 0.0), (-0.38, 0.0, 0.25), 0.0, 0.0, 1.9),
    "prismatic": (1, (0.1, -0.2, 0.97), (-0.18, 0.0, 0.26), 0.0, 0.0, 0.4),
    "screw": (2, (0.0, 0.1, 1.0), (-0.1, 0.05, 0.26), 0.08, -1.0, 6.0),
    "continuous": (3, (0.0, 0.0, 1.0), (-0.2, 0.1, 0.26), 0.0, 0.0, 0.0),
}
TRAVEL = {"revolute": 1.4, "prismatic": 0.35, "screw": 4.0, "continuous": 9.5}
DRAG_POINT = np.array([0.01, -0.1, 0.28])


def moved(kind, axis, origin, pitch, point, value):
    if kind == "prismatic":
        return point + value * axis
    arm = point - origin
    turned = (arm * math.cos(value) + np.cross(axis, arm) * math.sin(value)
              + axis * (axis @ arm) * (1 - math.cos(value)))
    return origin + turned + pitch * value * axis


def path_features(kind, axis, origin, pitch, path):
    """(P_i - p, q_i, r_i) by trying out joint values near the last one."""
    rows, value = [], 0.0
    for point in path:
        if kind == "prismatic":
            value = (point - path[0]) @ axis
        else:
            across = [v - axis * (axis @ v) for v in (path[0] - origin, point - origin)]
            angle = math.atan2(axis @ np.cross(*across), across[0] @ across[1])
            value = min((angle + 2 * math.pi * turn for turn in range(-4, 5)), key=lambda q: abs(q - value))
        residual = np.linalg.norm(point - moved(kind, axis, origin, pitch, path[0], value))
        rows.append([*(point - path[0]), value, residual])
    return np.array(rows)


def features(kind, axis, origin, scalars, vector, path):
    rotation = np.cross(path[0] - origin, vector)
    rows = path_features(kind, axis, origin, scalars[0], path)
    return {
        "joint_scalars": np.zeros(3) if kind == "continuous" else np.clip(scalars, -4, 4),
        "rotation_direction": rotation / np.linalg.norm(rotation),
        "mean_velocity": (path[15] - path[0]) / 15 * 16,
        "chords": np.concatenate([path[i] - path[0] for i in (5, 10, 15)]),
        "amplitude": np.array([rows[15, 3], np.linalg.norm(np.diff(path, axis=0), axis=1).sum()]),
        "path": rows,
    }


def nearest(xyz, centre):
    return np.argsort(((xyz - centre.astype("f4")) ** 2).sum(1), kind="stable")[:4]


def vae_case(net, rng, points, kind):
    index, axis, origin, *scalars = JOINTS[kind]
    axis, origin = np.array(axis) / np.linalg.norm(axis), np.array(origin)
    values = TRAVEL[kind] * np.linspace(0, 1, 16) ** 1.3
    path = np.array([moved(kind, axis, origin, scalars[0], DRAG_POINT, value) for value in values])
    path[1:] += rng.normal(0, 0.01, (15, 3))  # a hand's
    vector = path[4] - path[0]
    made = features(kind, axis, origin, scalars, vector, path)
    xyz = (np.floor(points[::64] * 65536 + 0.5) / 65536).astype("f4")  # as a prepared object keeps them
    mask = (np.arange(4096)[::64] < PART).astype("f4")
    inputs = {"xyz": xyz, "mask": mask, "axis": axis, "origin": origin, **made}
    batch = {name: torch.from_numpy(np.array(value, "f4"))[None] for name, value in inputs.items()}
    batch["type"] = torch.tensor([index])
    near = {"near_origin": nearest(xyz, origin), "near_drag": nearest(xyz, path[0])}
    batch.update({name: torch.from_numpy(value)[None] for name, value in near.items()})
    raw, mean, log_variance = net(batch)
    f_joint, _, _, _ = net.encode(batch)
    return {**inputs, **near, "type": np.array([index + 1]), "scalars": np.array(scalars),
            "drag_point": path[0], "drag_vector": vector, "drawn": path, "raw": raw[0], "mean": mean[0], "log_variance": log_variance[0],
            "between.f_joint": f_joint[0]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--models", type=Path, default=REPO / "sdk/models")
    parser.add_argument("--out", type=Path, default=REPO / "tests/golden/data")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    torch.set_num_threads(1)
    rng = np.random.default_rng(7)
    points, normals = cabinet(rng)
    with torch.no_grad():
        weights = arguments.models / "kpp_net.safetensors"
        net, mark = load(KppNet(), weights), fingerprint(weights)
        for name, drag in {"drag": (0.8, 0.1, 0.2, 1, 0, 0), "free": (0, 0, 0, 0, 0, 0)}.items():
            write_safetensors(arguments.out / f"kpp_{name}.safetensors", kpp_case(net, rng, points, normals, drag),
                              "dragmesh-golden-kpp", weights=mark)
        weights = arguments.models / "dq_vae.safetensors"
        net, mark = load(DqVae(), weights), fingerprint(weights)
        for kind in JOINTS:
            write_safetensors(arguments.out / f"vae_{kind}.safetensors", vae_case(net, rng, points, kind),
                              "dragmesh-golden-vae", weights=mark)


if __name__ == "__main__":
    main()
