"""Files that training writes: whole, or what was there stays."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "..", "bindings", "python"))
from dragmesh.whole_file import whole_file, write_together, write_whole  # noqa: E402

__all__ = ["save_arrays", "whole_file", "write_together", "write_whole"]


def save_arrays(path, *arrays, compressed=False, **named):
    """An archive of arrays. As numpy does, it adds .npz to a name without it."""
    with whole_file(path if str(path).endswith(".npz") else f"{path}.npz") as file:
        (np.savez_compressed if compressed else np.savez)(file, *arrays, **named)
