#!/usr/bin/python3
"""The table of candidate features and the files of weights, as training reads and writes them: python3
tests/python/test_features.py (after scripts/build)."""
import ctypes
import os
import sys
import tempfile
import unittest

import numpy as np

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path.insert(0, os.path.join(ROOT, "training"))
from dragmesh_training import export, features  # noqa: E402
from dragmesh_training.lab import open_lab  # noqa: E402

MODELS = os.path.join(ROOT, "sdk", "models")


class Features(unittest.TestCase):
    def test_columns_that_training_hides(self):
        """Those that the shipped ranker was trained with."""
        bounds = ((1, 2), (2, 9), (9, 16), (16, 23), (23, 37), (37, 42), (42, 54), (54, 65), (65, 68), (68, 72), (72, 75),
                  (98, 109), (109, 125), (125, 149), (149, 153), (153, 157), (157, 165), (165, 171), (171, 177), (177, 190),
                  (190, 202))
        self.assertEqual([(group.start, group.stop) for group in features.HIDDEN_GROUPS], list(bounds))
        np.testing.assert_array_equal(features.NETWORK, np.r_[86:98, 108, 124, 171:177])
        self.assertEqual(features.PRISMATIC, 0)

    def test_columns_are_in_order(self):
        self.assertEqual([feature["column"] for feature in features.TABLE], list(range(len(features.TABLE))))
        self.assertEqual(len(set(features.NAMES)), len(features.NAMES))

    def test_the_library_has_the_same_table(self):
        lab = open_lab()
        self.assertEqual(lab.dm_lab_ranker_columns(), len(features.TABLE))
        columns = np.zeros(lab.dm_lab_prefilter_columns(None), np.uint8)
        lab.dm_lab_prefilter_columns(columns.ctypes.data_as(ctypes.c_void_p))
        np.testing.assert_array_equal(columns, features.CHEAP)


class Export(unittest.TestCase):
    def again(self, name, write):
        """The bytes of a shipped file, and those of its tensors written anew."""
        path = os.path.join(MODELS, name)
        tensors, metadata = export.load_safetensors(path)
        with tempfile.TemporaryDirectory() as folder:
            copy = os.path.join(folder, name)
            write(copy, {key: tensor.numpy() for key, tensor in tensors.items()}, metadata)
            with open(path, "rb") as shipped, open(copy, "rb") as written:
                return shipped.read(), written.read()

    def test_shipped_files_are_written_again(self):
        for name, write in (("ranker.safetensors", export.write_joint_models),
                            ("part_finder.safetensors", export.write_safetensors)):
            shipped, written = self.again(name, write)
            self.assertTrue(shipped == written, name)


if __name__ == "__main__":
    unittest.main()
