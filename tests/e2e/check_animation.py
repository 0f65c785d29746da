#!/usr/bin/env python3
"""Measures, from a written .glb alone, how far the animated part leaves its joint.

  check_animation.py TOOL OBJECT_FOLDER [OBJECT_FOLDER ...] [--joint N] [--keep DIR]

For each folder of object.glb + joints.json it runs `TOOL infer --json` and `TOOL animate` with the first drag of joint N,
then moves the animated nodes' vertices by every key of the file, in double precision, and compares them with where the
inferred joint takes the original vertices at the joint value that fits best. Prints the largest residual over the object's
size; fails above 1e-5. Needs numpy."""
import argparse, json, subprocess, sys, tempfile
from pathlib import Path

import numpy as np

SIZES = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
WIDTHS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}


class Glb:
    def __init__(self, path):
        data = Path(path).read_bytes()
        size = int.from_bytes(data[12:16], "little")
        self.json = json.loads(data[20:20 + size])
        self.bin = data[20 + size + 8:]

    def accessor(self, index):
        a = self.json["accessors"][index]
        view = self.json["bufferViews"][a["bufferView"]]
        dtype, width = np.dtype(SIZES[a["componentType"]]), WIDTHS[a["type"]]
        start = view.get("byteOffset", 0) + a.get("byteOffset", 0)
        stride = view.get("byteStride", dtype.itemsize * width)
        raw = np.frombuffer(self.bin, np.uint8)
        rows = np.lib.stride_tricks.as_strided(raw[start:], (a["count"], dtype.itemsize * width), (stride, 1))
        return rows.copy().view(dtype).reshape(a["count"], width)

    def matrix(self, node, trs=None):
        n = dict(self.json["nodes"][node], **(trs or {}))
        if "matrix" in n:
            return np.array(n["matrix"], float).reshape(4, 4).T
        m = np.eye(4)
        x, y, z, w = np.array(n.get("rotation", [0, 0, 0, 1]), float) / np.linalg.norm(n.get("rotation", [0, 0, 0, 1]))
        m[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
        m[:3, :3] *= np.array(n.get("scale", [1, 1, 1]), float)
        m[:3, 3] = n.get("translation", [0, 0, 0])
        return m

    def vertices_below(self, node, above):
        """Vertices used by triangles of a node and its children, each in the frame `above` stands in."""
        n = self.json["nodes"][node]
        out = []
        for p in self.json["meshes"][n["mesh"]]["primitives"] if "mesh" in n else []:
            v = self.accessor(p["attributes"]["POSITION"]).astype(float)
            if "indices" in p:
                v = v[np.unique(self.accessor(p["indices"]))]
            out.append(v @ above[:3, :3].T + above[:3, 3])
        for c in n.get("children", []):
            out += self.vertices_below(c, above @ self.matrix(c))
        return out


def turn(axis, angle):
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * (k @ k)


def residual(rest, now, joint):
    """Largest distance of `now` from the joint's motion of `rest` at the value that fits best."""
    axis, origin = np.array(joint["axis"]), np.array(joint["origin"])
    axis = axis / np.linalg.norm(axis)
    if joint["type"] == "prismatic":
        return np.linalg.norm(rest + ((now - rest).mean(0) @ axis) * axis - now, axis=1).max()
    a, b = rest - origin, now - origin
    pitch = joint.get("pitch", 0.0)
    angle = np.arctan2((np.cross(a, b) @ axis).sum(), ((a * b).sum(1) - (a @ axis) * (b @ axis)).sum())
    best = np.inf
    for k in (-1, 0, 1):
        full = angle + 2 * np.pi * k
        best = min(best, np.linalg.norm(a @ turn(axis, full).T + origin + pitch * full * axis - now, axis=1).max())
    return best


def check(tool, folder, which, keep):
    meta = json.loads((folder / "joints.json").read_text())
    joint = meta["joints"][which]
    drag = joint["drags"][0]
    arguments = [str(folder / "object.glb"), "--moving", ",".join(joint["moving_nodes"]),
                 "--drag-point", ",".join(map(repr, drag["point"])), "--drag-vector", ",".join(map(repr, drag["vector"]))]
    found = json.loads(subprocess.run([tool, "infer", *arguments, "--json"], capture_output=True, text=True, check=True).stdout)
    path = Path(keep) / f"{folder.name}.glb"
    subprocess.run([tool, "animate", *arguments, "-o", str(path)], capture_output=True, check=True)
    glb = Glb(path)
    every = np.concatenate([v for r in Glb(folder / "object.glb").json["scenes"][0]["nodes"]
                            for v in Glb(folder / "object.glb").vertices_below(r, Glb(folder / "object.glb").matrix(r))])
    size = (every.max(0) - every.min(0)).max()
    animation = glb.json["animations"][0]
    channels = {c["target"]["path"]: animation["samplers"][c["sampler"]] for c in animation["channels"]}
    node = animation["channels"][0]["target"]["node"]
    values = {path: glb.accessor(s["output"]).astype(float) for path, s in channels.items()}
    frames = [np.concatenate(glb.vertices_below(node, glb.matrix(node, {p: v[k] for p, v in values.items()})))
              for k in range(len(values["rotation"]))]
    worst = max(residual(frames[0], f, found) for f in frames) / size
    travel = max(np.linalg.norm(f - frames[0], axis=1).max() for f in frames) / size
    print(f"{folder.name:50s} {found['type']:10s} keys {len(frames):4d}  travel {travel:.3f}  off the joint {worst:.2e}")
    return worst


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tool")
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--joint", type=int, default=0)
    parser.add_argument("--keep", help="folder for the animated files")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        worst = max(check(arguments.tool, f, arguments.joint, arguments.keep or scratch) for f in arguments.folders)
    print(f"worst {worst:.2e} of the object's size")
    sys.exit(1 if worst > 1e-5 else 0)


if __name__ == "__main__":
    main()
