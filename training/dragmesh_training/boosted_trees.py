"""The boosted trees beside the ranker's network (sdk/kinematics/ranking/boosted_trees.c): features of generated cases in, trees
out.

Trees and a network err on different candidates, so that the mean of both scores errs less than either. The trees learn what
the network does, to share each case's probability by exp(-cost). training/lab/boost.c grows them.

The last trees, of drags, correct that mean where there is a drag. They learn from pulls as people make them
(training/lab/pull.c); all that comes before them learns from careful ones.
"""
import ctypes
import itertools

import numpy as np

TREES, DRAG_TREES, LEAVES = 400, 100, 128  # as in ranker.h, where the first number includes the second
DRAG_RATE = 0.15  # of the trees of drags
DRAG_SHARE = 0.4  # of their corrections that counts: all of it costs exact drags too much (docs/research/trials_joints.md)
BINS = 64  # DM_LAB_BINS
AT_ONCE = 2000  # cases


class Rows(ctypes.Structure):
    """dm_lab_rows of training/lab/boost.h."""
    _fields_ = [("columns", ctypes.c_uint32), ("cases", ctypes.c_uint32)] + [
        (name, ctypes.c_void_p) for name in ("first", "bins", "weights", "target", "scores")]


class Rule(ctypes.Structure):
    """dm_lab_boost_rule."""
    _fields_ = [(name, ctypes.c_uint32) for name in ("trees", "leaves", "depth")] + [
        (name, ctypes.c_float) for name in ("rate", "damping", "least", "case_share", "column_share")] + [
        ("seed", ctypes.c_uint64), ("each_row", ctypes.c_uint32)]


class Trees(ctypes.Structure):
    """dm_lab_trees."""
    _fields_ = [(name, ctypes.c_void_p) for name in ("column", "bin", "left", "score")]


def bin_edges(features):
    """(columns, BINS - 1) rising numbers that divide each column into bins of about equal counts; unused ones are infinite.
    float16, as the file keeps them."""
    out = np.full((features.shape[1], BINS - 1), np.inf, np.float16)
    for column, numbers in enumerate(features.astype(np.float32).T):
        different = np.unique(numbers)
        between = ((different[1:] + different[:-1]) / 2 if len(different) <= BINS
                   else np.quantile(numbers, np.linspace(0, 1, BINS + 1)[1:-1]))
        between = np.unique(between.astype(np.float16))
        out[column, :len(between)] = between
    return out


def put_into_bins(features, edges):
    """How many edges of its column are below each number."""
    out = np.empty(features.shape, np.uint8)
    for column in range(features.shape[1]):
        out[:, column] = np.searchsorted(edges[column].astype(np.float32), features[:, column].astype(np.float32))
    return out


def gather(cases):
    """All cases' rows as dm_lab_boost takes them: where each case begins, bins, log weights, target probabilities, and scores that
    the trees correct where the cases have them; and the edges of the bins, which the first AT_ONCE cases set."""
    cases, edges, parts, first = iter(cases), None, [], [0]
    while held := list(itertools.islice(cases, AT_ONCE)):
        first.extend(first[-1] + np.cumsum([len(case[0]) for case in held]))
        features, *others = (np.concatenate(arrays) for arrays in zip(*held))
        edges = bin_edges(features) if edges is None else edges
        parts.append((put_into_bins(features, edges), *(array.astype(np.float32) for array in others)))
    return (np.array(first, np.uint32), *(np.concatenate(arrays) for arrays in zip(*parts)), edges)


def level_by_level(column, left):
    """A tree's nodes in the order that the file has them, unused ones last: children follow from the order of the splits."""
    order = [0]
    for node in order:
        if column[node] >= 0:
            order += [left[node], left[node] + 1]
    return np.array(order + sorted(set(range(len(column))) - set(order)))


def grow_trees(lab, arrays, edges, rule, report, factor=1):
    """(columns, values) of the trees that a rule gives, float16, level by level; leaves' scores times `factor`. arrays: where each
    case begins, bins, log weights and target probabilities, and scores that the trees correct where there are any. report: the text
    between the number of trees and the loss."""
    nodes = {name: np.zeros((rule.trees, 2 * rule.leaves - 1), dtype) for name, dtype in (
        ("column", np.int32), ("bin", np.int32), ("left", np.int32), ("score", np.float32))}
    rows = Rows(arrays[1].shape[1], len(arrays[0]) - 1, *[array.ctypes.data for array in arrays])
    told = ctypes.CFUNCTYPE(None, ctypes.c_uint32, ctypes.c_double)(
        lambda trees, loss: print(f"{trees} trees{report} {loss:.3f}", flush=True))
    result = lab.dm_lab_boost(ctypes.byref(rows), ctypes.byref(rule), told,
                              ctypes.byref(Trees(*[array.ctypes.data for array in nodes.values()])))
    if result != 0:
        raise RuntimeError(f"dm_lab_boost: {result}")
    value = np.where(nodes["column"] >= 0, edges[nodes["column"], nodes["bin"]], factor * nodes["score"])
    order = np.stack([level_by_level(*tree) for tree in zip(nodes["column"], nodes["left"])])
    return tuple(np.take_along_axis(array, order, 1).astype(np.float16) for array in (nodes["column"], value))


def grow_by(lab, cases, rule, factor=1):
    """(columns, values) of the trees that a rule gives; leaves' scores times `factor`."""
    *arrays, edges = gather(cases)
    return grow_trees(lab, arrays, edges, rule, " loss", factor)


def grow(lab, cases, seed):
    """Tensors of the trees, those of drags saying nothing yet. cases: of each its rows of features, their log weights and their
    target probabilities."""
    column, value = grow_by(lab, cases, Rule(TREES, LEAVES, 12, 0.1, 5, 2, 0.3, 0.4, seed))
    none = [(0, DRAG_TREES), (0, 0)]
    return {"trees.column": np.pad(column, none, constant_values=-1), "trees.value": np.pad(value, none)}


def correct(lab, tensors, cases, seed):
    """The same tensors with the trees of drags. cases: as of `grow`, all with a drag, and the scores of the rows without these
    trees. The ranker's score is the mean of its network's and of the trees', so these count twice."""
    rule = Rule(DRAG_TREES, LEAVES, 12, DRAG_RATE, 5, 2, 0.3, 0.4, seed)
    column, value = grow_by(lab, cases, rule, 2 * DRAG_SHARE)
    return {"trees.column": np.concatenate([tensors["trees.column"][:TREES], column]),
            "trees.value": np.concatenate([tensors["trees.value"][:TREES], value])}


def scored(lab, ranker, cases):
    """The cases with a ranker's scores of their rows (up to a constant of each case) beside the rest. ranker: bytes of its file."""
    cases = iter(cases)
    while held := list(itertools.islice(cases, AT_ONCE)):
        first = np.cumsum([0] + [len(case[0]) for case in held]).astype(np.uint32)
        features = np.concatenate([case[0] for case in held]).astype(np.float32)
        scores = np.zeros(len(features), np.float32)
        result = lab.dm_lab_ranker_log_shares(ranker, ctypes.c_size_t(len(ranker)), len(held),
                                              *(ctypes.c_void_p(array.ctypes.data) for array in (first, features, scores)))
        if result != 0:
            raise RuntimeError(f"dm_lab_ranker_log_shares: {result}")
        for case, begin, end in zip(held, first, first[1:]):
            yield (*case, scores[begin:end])
