"""ctypes binding of libdragmesh_lab: batches of network inputs and labels, made by the library's own C code.

Used by training; needs a build of this repository (scripts/build) and numpy.
"""
import ctypes as c
import os
from typing import NamedTuple

import numpy as np

from .library import find_library

SPLITS = {"train": 0, "validation": 1, "test": 2}
PULLS = {name: pull for pull, name in enumerate(
    ("tangent", "exact", "chord", "room", "screen", "mixed", "careful"))}  # DM_LAB_PULL_*
SETS = ("trained", "test_only")  # DMG_SET_* of training/generator/generator.h


class Kind(NamedTuple):
    """A category of the generator. Its id never changes; the lab's arrays and weights go by it."""
    name: str
    id: int
    set: str  # one of SETS


class Options(c.Structure):
    """dm_lab_options. categories: address of a weight for each id, uint8, as many as dm_lab_category_id_limit says."""
    _fields_ = [("seed", c.c_uint64), ("count", c.c_uint32), ("split", c.c_int32), ("categories", c.c_void_p),
                ("messy", c.c_float), ("mask_noise", c.c_float), ("rotated", c.c_float), ("with_drag", c.c_float),
                ("drag_noise_degrees", c.c_float), ("joint_noise", c.c_float), ("hand_noise", c.c_float),
                ("pull", c.c_int32)]


# Name, dtype and shape of one case, in the order of the C structs.
KPP_ARRAYS = (
    ("global_points", np.float32, (48, 16, 17)), ("global_centres", np.float32, (48, 3)),
    ("local_points", np.float32, (24, 16, 17)), ("local_centres", np.float32, (24, 3)), ("shape", np.float32, (56,)),
    ("type", np.int32, ()), ("has_drag", np.int32, ()), ("category", np.int32, ()), ("axis", np.float32, (3,)),
    ("origin", np.float32, (3,)), ("limits", np.float32, (5,)), ("size", np.float32, ()))
VAE_ARRAYS = (
    ("xyz", np.float32, (64, 3)), ("mask", np.float32, (64,)), ("type", np.int32, ()),
    ("category", np.int32, ()), ("axis", np.float32, (3,)), ("origin", np.float32, (3,)), ("pitch", np.float32, ()),
    ("features", np.float32, (100,)), ("near_origin", np.int32, (4,)), ("near_drag", np.int32, (4,)),
    ("drag_point", np.float32, (3,)), ("drag_vector", np.float32, (3,)), ("limits", np.float32, (2,)),
    ("values", np.float32, (16,)), ("closed_form", np.float32, (16,)))
# dmi_vae_features in order: name, floats.
VAE_FEATURES = (("joint_scalars", 3), ("rotation_direction", 3), ("mean_velocity", 3), ("chords", 9),
                ("amplitude", 2), ("path", 80))


def load(path):
    """The lab library with the types of what it returns set."""
    lib = c.CDLL(path)
    lib.dm_lab_category_name.restype = c.c_char_p
    lib.dm_lab_category_id.restype = lib.dm_lab_category_id_limit.restype = c.c_uint32
    return lib


def kinds(lib):
    """All categories, a Kind each, in the order of the library's rows."""
    return [Kind(lib.dm_lab_category_name(row).decode(), lib.dm_lab_category_id(row), SETS[lib.dm_lab_category_set(row)])
            for row in range(lib.dm_lab_category_count())]


def numbers_of(mix):
    """The mix with the name of its pull, where it has one, as a number."""
    return {**mix, "pull": PULLS[mix.get("pull", "tangent")]}


class Lab:
    """One loaded lab library."""

    def __init__(self, path=None):
        self._lib = load(path or os.environ.get("DRAGMESH_LAB") or find_library("libdragmesh_lab.so"))
        expected = (c.sizeof(Options), 8 * len(KPP_ARRAYS), 8 * len(VAE_ARRAYS))
        for which, size in enumerate(expected):
            if self._lib.dm_lab_layout(which) != size:
                raise ImportError(f"libdragmesh_lab: struct {which} has {self._lib.dm_lab_layout(which)} bytes, "
                                  f"this binding knows {size}; rebuild")
        self.kinds = kinds(self._lib)
        self._ids = {kind.name: kind.id for kind in self.kinds}

    def kpp_batch(self, seed, count, categories, split="train", **mix):
        """Arrays of KPP_ARRAYS for `count` cases; categories: names; mix: shares of dm_lab_options."""
        return self._batch(self._lib.dm_lab_kpp_batch, KPP_ARRAYS, seed, count, categories, split, mix)

    def vae_batch(self, seed, count, categories, split="train", **mix):
        """Arrays of VAE_ARRAYS for `count` cases."""
        return self._batch(self._lib.dm_lab_vae_batch, VAE_ARRAYS, seed, count, categories, split, mix)

    def given(self, network, case, seed, count, **mix):
        """Arrays of a case that the caller has: `case` a ctypes struct dm_lab_given (training/lab/lab_ranker.h). `count` strokes
        of the DQ-VAE; KPP-Net makes one case. None when the library refuses it."""
        layout = KPP_ARRAYS if network == "kpp" else VAE_ARRAYS
        function = self._lib.dm_lab_kpp_given if network == "kpp" else self._lib.dm_lab_vae_given
        arrays, pointers = self._arrays(layout, 1 if network == "kpp" else count)
        options = Options(seed=seed, count=count, **numbers_of(mix))
        return arrays if function(c.byref(case), c.byref(options), pointers) == 0 else None

    @staticmethod
    def _arrays(layout, count):
        arrays = {name: np.zeros((count, *shape), dtype) for name, dtype, shape in layout}
        return arrays, (c.c_void_p * len(layout))(*(arrays[name].ctypes.data for name, _, _ in layout))

    def _batch(self, function, layout, seed, count, categories, split, mix):
        allowed = np.zeros(self._lib.dm_lab_category_id_limit(), np.uint8)
        allowed[[self._ids[name] for name in categories]] = 1
        options = Options(seed=seed, count=count, split=SPLITS[split], categories=allowed.ctypes.data,
                          **numbers_of(mix))
        arrays, pointers = self._arrays(layout, count)
        result = function(c.byref(options), pointers)
        if result != 0:
            raise RuntimeError(f"dm_lab: error {result} (seed {seed}, categories {', '.join(categories)})")
        return arrays
