#!/usr/bin/python3
"""The limits that the limits' networks learn (training/dragmesh_training/limits.py): the generator's as people write them."""
import os
import sys
import unittest

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "training"))
from dragmesh_training.limits import ROUND_DEGREES, as_written  # noqa: E402

COUNT = 4000


class AsWritten(unittest.TestCase):
    def setUp(self):
        self.random = np.random.default_rng(3)
        self.lower = -self.random.uniform(0, 0.6, COUNT).astype(np.float32)
        self.upper = self.random.uniform(0.2, 3, COUNT).astype(np.float32)

    def test_turns_become_round(self):
        lower, upper = as_written(self.lower, self.upper, np.ones(COUNT, bool), self.random)
        steps = np.degrees(upper) / 15
        round_ones = np.abs(steps - np.round(steps)) < 1e-3
        self.assertTrue(0.5 < round_ones.mean() < 0.8)
        self.assertTrue((np.abs(upper - self.upper) <= np.radians(max(ROUND_DEGREES)) / 2 + 1e-5).all())
        self.assertTrue((lower <= 0).all() and (upper > 0).all())
        self.assertTrue((upper - lower >= 0.6 * (self.upper - self.lower) - 1e-5).all())

    def test_slides_stay(self):
        lower, upper = as_written(self.lower, self.upper, np.zeros(COUNT, bool), self.random)
        self.assertTrue((lower == self.lower).all() and (upper == self.upper).all())


if __name__ == "__main__":
    unittest.main()
