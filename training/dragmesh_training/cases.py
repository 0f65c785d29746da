"""Ranker cases: generated objects' candidate joints with their features and labels, and files of them. The ranker and the
prefilter are trained on them."""
import ctypes
import multiprocessing
import os
from concurrent.futures import ProcessPoolExecutor

import numpy as np

from .features import PRISMATIC
from .lab import PULLS, Options, category_weights

KEPT_BEST = 8  # as in lab_ranker.c

ARRAYS = (("pose", np.float32, True), ("used", np.int32, False), ("total", np.int32, False), ("type", np.int32, False),
          ("has_drag", np.int32, False), ("category", np.int32, False), ("best", np.float32, False),
          ("axis_error", np.float32, True), ("line_error", np.float32, True))


class Batch(ctypes.Structure):
    _fields_ = [("rows", ctypes.c_uint32), ("features", ctypes.c_void_p)] + [
        (name, ctypes.c_void_p) for name, _, _ in ARRAYS]


def make(lab, seed, count, rows, split, chosen, noise_degrees, weights=None, prefilter=None, with_drag=0.7, mask_noise=0.3,
         pull="mixed"):
    """Features and labels of `count` cases drawn from the chosen categories. pull: one of PULLS."""
    columns = lab.dm_lab_ranker_columns()
    weights_of = category_weights(lab, chosen)
    data = {"features": np.zeros((count, rows, columns), np.float32)}
    for name, dtype, each_row in ARRAYS:
        data[name] = np.zeros((count, rows) if each_row else count, dtype)
    options = Options(seed, count, split, weights_of.ctypes.data, 0.5, mask_noise, 1.0, with_drag, noise_degrees, 0, 0,
                      PULLS[pull])
    batch = Batch(rows, *[data[name].ctypes.data for name in ("features", *[a[0] for a in ARRAYS])])
    sizes = [ctypes.c_size_t(len(data) if data else 0) for data in (weights, prefilter)]
    result = lab.dm_lab_ranker_batch(ctypes.byref(options), weights, sizes[0], prefilter, sizes[1], ctypes.byref(batch))
    if result != 0:
        raise RuntimeError(f"dm_lab_ranker_batch: {result}")
    return data


def load(paths, without=()):
    """Cases of all files, those of the categories `without` left out."""
    parts = [np.load(path) for path in paths]
    kept = [~np.isin(part["names"][part["category"]], without) for part in parts]
    return {name: np.concatenate([part[name][keep] for part, keep in zip(parts, kept)])
            for name in parts[0].files if name != "names"}


def costs(data):
    """Of each row: the pose error in hundredths of the size, a wrong type, axis and line errors in tolerances."""
    slides = np.stack([data["features"][:, row, PRISMATIC] for row in range(data["pose"].shape[1])], 1) > 0.5
    wrong_type = slides != (data["type"][:, None] == 1)
    pose = np.minimum(np.nan_to_num(data["pose"], nan=9) / 0.01, 6)
    axis, line = np.minimum(data["axis_error"] / 0.02, 3), np.minimum(data["line_error"] / 0.01, 3)
    return (pose + 6 * wrong_type + axis + line).astype(np.float32)


def log_weights(rows, used, total):
    """Rows after the best few are a sample: each stands for several. rows: (cases, k) indices."""
    sampled = np.maximum(np.minimum(used, rows.shape[1]) - KEPT_BEST, 1)
    weight = np.log(np.maximum(total - KEPT_BEST, 1) / sampled)
    out = np.where(rows < KEPT_BEST, 0, weight[:, None])
    return np.where(rows < used[:, None], out, -1e9).astype(np.float32)


def make_file(command, path, kinematics, seed, *more):
    command(["make", path + ".part.npz", "--weights", kinematics, "--seed", str(seed), *more])
    os.rename(path + ".part.npz", path)


def case_files(command, folder, files):
    """The paths of files (name, weights of the KPP-Net, seed, more words …), made by the `make` of a module's `run` unless they
    are there; one for each processor at a time."""
    paths = [os.path.join(folder, name + ".npz") for name, *_ in files]
    spawn = multiprocessing.get_context("spawn")  # a fork would lack the threads that PyTorch may have started
    with ProcessPoolExecutor(len(os.sched_getaffinity(0)), spawn) as pool:
        made = [pool.submit(make_file, command, path, *words)
                for path, (_, *words) in zip(paths, files) if not os.path.exists(path)]
        for future in made:
            future.result()
    return paths
