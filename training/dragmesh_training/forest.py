"""The forest beside the ranker's network (sdk/kinematics/ranking/boosted_trees.c): evidence of generated cases in, its trees out.

Trees and a network err on different candidates, so that the mean of both scores errs less than either. The trees learn
what the network does, to share each case's probability by exp(-cost), and are grown by training/lab/boost.c.
"""
import ctypes
import itertools

import numpy as np

TREES, LEAVES = 400, 128  # as in forest.h
BINS = 64  # DM_LAB_BINS
AT_ONCE = 2000  # cases


class Rows(ctypes.Structure):
    """dm_lab_rows of training/lab/boost.h."""
    _fields_ = [("columns", ctypes.c_uint32), ("cases", ctypes.c_uint32)] + [
        (name, ctypes.c_void_p) for name in ("first", "bins", "weights", "wanted")]


class Rule(ctypes.Structure):
    """dm_lab_boost_rule."""
    _fields_ = [(name, ctypes.c_uint32) for name in ("trees", "leaves", "depth")] + [
        (name, ctypes.c_float) for name in ("rate", "damping", "least", "case_share", "column_share")] + [
        ("seed", ctypes.c_uint64)]


class Forest(ctypes.Structure):
    """dm_lab_forest."""
    _fields_ = [(name, ctypes.c_void_p) for name in ("column", "bin", "left", "score")]


def borders(evidence):
    """(columns, BINS - 1) rising numbers between which about equally many of each column's lie; unused ones are infinite.
    Halves, as the file keeps them."""
    out = np.full((evidence.shape[1], BINS - 1), np.inf, np.float16)
    for column, numbers in enumerate(evidence.astype(np.float32).T):
        different = np.unique(numbers)
        between = ((different[1:] + different[:-1]) / 2 if len(different) <= BINS
                   else np.quantile(numbers, np.linspace(0, 1, BINS + 1)[1:-1]))
        between = np.unique(between.astype(np.float16))
        out[column, :len(between)] = between
    return out


def put_into_bins(evidence, edges):
    """How many borders of its column are below each number."""
    out = np.empty(evidence.shape, np.uint8)
    for column in range(evidence.shape[1]):
        out[:, column] = np.searchsorted(edges[column].astype(np.float32), evidence[:, column].astype(np.float32))
    return out


def gather(cases):
    """All cases' rows as dm_lab_boost takes them, and the borders of their bins, which the first cases set."""
    cases, edges, parts, first = iter(cases), None, [], [0]
    while held := list(itertools.islice(cases, AT_ONCE)):
        first.extend(first[-1] + np.cumsum([len(case[0]) for case in held]))
        evidence, weights, wanted = (np.concatenate(arrays) for arrays in zip(*held))
        edges = borders(evidence) if edges is None else edges
        parts.append((put_into_bins(evidence, edges), weights.astype(np.float32), wanted.astype(np.float32)))
    return (np.array(first, np.uint32), *(np.concatenate(arrays) for arrays in zip(*parts)), edges)


def level_by_level(column, left):
    """A tree's nodes in the order that the file has them, those it does not need last: whose child a node is need not be said."""
    order = [0]
    for node in order:
        if column[node] >= 0:
            order += [left[node], left[node] + 1]
    return np.array(order + sorted(set(range(len(column))) - set(order)))


def grow(lab, cases, seed):
    """Tensors of a forest. cases: of each its rows of evidence, their log weights and their wanted probabilities."""
    first, bins, weights, wanted, edges = gather(cases)
    nodes = {name: np.zeros((TREES, 2 * LEAVES - 1), dtype) for name, dtype in (
        ("column", np.int32), ("bin", np.int32), ("left", np.int32), ("score", np.float32))}
    rows = Rows(bins.shape[1], len(first) - 1, *[array.ctypes.data for array in (first, bins, weights, wanted)])
    rule = Rule(TREES, LEAVES, 12, 0.1, 5, 2, 0.3, 0.4, seed)
    report = ctypes.CFUNCTYPE(None, ctypes.c_uint32, ctypes.c_double)(
        lambda trees, loss: print(f"{trees} trees loss {loss:.3f}", flush=True))
    result = lab.dm_lab_boost(ctypes.byref(rows), ctypes.byref(rule), report,
                              ctypes.byref(Forest(*[array.ctypes.data for array in nodes.values()])))
    if result != 0:
        raise RuntimeError(f"dm_lab_boost: {result}")
    forks = nodes["column"] >= 0
    value = np.where(forks, edges[nodes["column"], nodes["bin"]], nodes["score"])
    order = np.stack([level_by_level(*tree) for tree in zip(nodes["column"], nodes["left"])])
    return {f"forest.{name}": np.take_along_axis(array, order, 1).astype(np.float16)
            for name, array in (("column", nodes["column"]), ("value", value))}
