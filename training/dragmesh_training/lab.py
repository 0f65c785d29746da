"""The lab library as the training modules use it: its path, the generator's kinds, and the options that cases are drawn by."""
import os
import sys

import numpy as np

from .config import kinds_of

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "..", "bindings", "python"))
from dragmesh.lab import PULLS, VAE_FEATURES, Lab, Options, kinds, load  # noqa: E402

__all__ = ["PULLS", "VAE_FEATURES", "LAB", "Lab", "Options", "kinds", "open_lab", "names_by_id", "chosen_kinds", "category_weights",
           "options_of"]

LAB = os.path.join(os.path.dirname(__file__), "..", "..", "build", "release", "libdragmesh_lab.so")


def open_lab(path=LAB):
    return load(path)


def names_by_id(lab):
    """The kinds' names at their ids, as `category` of the lab's arrays gives them; "" where an id has no kind."""
    names = [""] * lab.dm_lab_category_id_limit()
    for kind in kinds(lab):
        names[kind.id] = kind.name
    return names


def chosen_kinds(lab, which):
    """Names of the kinds that config.kinds_of chooses."""
    return kinds_of(kinds(lab), which)


def category_weights(lab, chosen):
    """How often each id is drawn, for dm_lab_options. A category counts the more the more kinds of joints it has (up to 12), so that
    each of these gets its share."""
    weights = np.zeros(lab.dm_lab_category_id_limit(), np.uint8)
    for row, kind in enumerate(kinds(lab)):
        if kind.name in chosen:
            weights[kind.id] = 2 + min(lab.dm_lab_category_kinds(row), 12)
    return weights


def options_of(lab, seed, count, split, chosen, clean=False, pull="mixed"):
    """Options of cases as the ranker is trained on them (cases.make), with drags 8 degrees off, or of clean ones: clean objects,
    exact masks, drags without errors. pull: one of PULLS. The weights of the categories, returned with them, must live as long as
    the options."""
    weights = category_weights(lab, chosen)
    messy, mask_noise, noise_degrees = (0, 0, 0) if clean else (0.5, 0.3, 8.0)
    options = Options(seed, count, split, weights.ctypes.data, messy, mask_noise, 1.0, 0.7, noise_degrees, 0, 0, PULLS[pull])
    return options, weights
