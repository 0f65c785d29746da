"""Batches of both networks from folders of object.glb + joints.json: what training/train --data mixes in."""
import ctypes
import functools
from pathlib import Path

import numpy as np

from . import objects

STROKES = 4  # of a hand, of every joint drawn: as the lab makes of generated objects
KEPT = 256  # objects in memory


class Given(ctypes.Structure):
    """dm_lab_given of training/lab/lab_ranker.h."""
    _fields_ = [(name, ctypes.c_void_p) for name in ("positions", "indices", "face_part")] + [
        ("vertex_count", ctypes.c_uint32), ("face_count", ctypes.c_uint32), ("type", ctypes.c_int32)] + [
        (name, ctypes.c_float * 3) for name in ("axis", "origin")] + [
        (name, ctypes.c_float) for name in ("lower", "upper")] + [
        (name, ctypes.c_float * 3) for name in ("drag_point", "drag_vector")]


def given(case, drag):
    arrays = [np.ascontiguousarray(a) for a in (case.positions, case.indices, case.face_part)]
    vectors = [(ctypes.c_float * 3)(*v) for v in (case.axis, case.origin, *case.drags[drag])]
    out = Given(*[a.ctypes.data for a in arrays], len(case.positions), len(case.indices), case.type, *vectors[:2],
                case.lower, case.upper, *vectors[2:])
    out.arrays = arrays  # live as long as the pointers
    return out


@functools.lru_cache(maxsize=KEPT)
def cases_of(path):
    return [case for case in objects.cases(path) if case.drags]


class Loaded:
    """The objects of a folder's sub-folders. A batch depends on its seed alone."""

    def __init__(self, folder):
        self.paths = sorted(str(path.parent) for path in Path(folder).glob("*/joints.json"))
        if not self.paths:
            raise SystemExit(f"training: {folder} has no sub-folder with a joints.json")

    def one(self, lab, network, random, mix):
        """Arrays of a joint drawn; None when it has no drag, or the library refuses it."""
        path = self.paths[random.integers(len(self.paths))]
        cases = cases_of(path)
        if not cases:
            return None
        case = cases[random.integers(len(cases))]
        drag = int(random.integers(len(case.drags)))
        return lab.given(network, given(case, drag), int(random.integers(2**32)), STROKES, **mix)

    def batch(self, lab, network, seed, count, mix):
        random, parts, made = np.random.default_rng(seed), [], 0
        for _ in range(64 * count):
            if made >= count:
                break
            arrays = self.one(lab, network, random, mix)
            if arrays is not None:
                parts.append(arrays)
                made += len(arrays["type"])
        if made < count:
            raise RuntimeError(f"training: of {len(self.paths)} objects the library takes hardly a joint")
        return {name: np.concatenate([part[name] for part in parts])[:count] for name in parts[0]}
