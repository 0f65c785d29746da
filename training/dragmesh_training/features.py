"""The table of candidate features (sdk/kinematics/features/feature_table.def), as features.json there has it: which columns of a
row of features are which. Everything here that chooses columns is derived from it."""
import json
import os

import numpy as np

PATH = os.path.join(os.path.dirname(__file__), "..", "..", "sdk", "kinematics", "features", "features.json")
NOT_HIDDEN = ("type", "drag", "pull", "network")  # groups that training never hides as a whole: the type always counts, a drag is
# either there or not, and the network's features are hidden by their source (NETWORK)

with open(PATH, encoding="utf-8") as file:
    TABLE = json.load(file)  # dictionaries in the order of the columns

NAMES = [feature["name"] for feature in TABLE]


def columns_where(field, value):
    """Columns whose `field` (group, pass or source) is `value`, rising."""
    return np.array([feature["column"] for feature in TABLE if feature[field] == value])


def group_slices():
    """{name: slice} of all groups, in order. A group's columns lie side by side."""
    slices = {}
    for name in dict.fromkeys(feature["group"] for feature in TABLE):
        columns = columns_where("group", name)
        if len(columns) != columns[-1] + 1 - columns[0]:
            raise ValueError(f"{PATH}: the columns of group '{name}' do not lie side by side")
        slices[name] = slice(int(columns[0]), int(columns[-1]) + 1)
    return slices


GROUPS = group_slices()
HIDDEN_GROUPS = [columns for name, columns in GROUPS.items() if name not in NOT_HIDDEN]
PRISMATIC = NAMES.index("prismatic")  # 1 for a slide, 0 for a turn
NETWORK = columns_where("source", "network")  # of KPP-Net
CHEAP = columns_where("pass", "cheap")  # the prefilter's
