"""Folders of object.glb + joints.json as cases: a mesh, which of its faces move, and the joint."""
import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from . import glb

REVOLUTE, PRISMATIC, CONTINUOUS = 1, 2, 4  # DM_JOINT_*


@dataclass
class Case:
    name: str
    category: str
    weight: float
    positions: np.ndarray  # (V, 3) float32
    indices: np.ndarray    # (F, 3) uint32
    face_part: np.ndarray  # (F,) uint32: 1 moves
    type: int              # DM_JOINT_*
    axis: np.ndarray
    origin: np.ndarray
    lower: float           # equal limits: none
    upper: float
    drags: list            # of (point, vector)


def joint_type(joint):
    if joint["type"] == "prismatic":
        return PRISMATIC
    return CONTINUOUS if joint.get("continuous") or joint.get("lower") is None else REVOLUTE


def cases(folder):
    """Those of one object."""
    folder = Path(folder)
    meta = json.loads((folder / "joints.json").read_text())
    parts = glb.read(folder / "object.glb")
    first = np.cumsum([0] + [len(positions) for positions, _ in parts.values()])
    positions = np.concatenate([p for p, _ in parts.values()]).astype(np.float32)
    indices = np.concatenate([f + at for (_, f), at in zip(parts.values(), first)]).astype(np.uint32)
    for number, joint in enumerate(meta["joints"]):
        moving = [np.full(len(f), name in joint["moving_nodes"], np.uint32) for name, (_, f) in parts.items()]
        lower, upper = joint.get("lower"), joint.get("upper")
        yield Case(f"{folder.name}/{number}", meta.get("category", "?"), joint.get("weight", 1.0), positions, indices,
                   np.concatenate(moving), joint_type(joint), np.array(joint["axis"]), np.array(joint["origin"]),
                   lower or 0.0, upper or 0.0, [(np.array(d["point"]), np.array(d["vector"])) for d in joint["drags"]])


def all_cases(folder):
    """Those of every object in the sub-folders of `folder`, in order of their names."""
    for path in sorted(Path(folder).iterdir()):
        if (path / "joints.json").is_file():
            yield from cases(path)
