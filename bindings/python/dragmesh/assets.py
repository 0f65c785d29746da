"""Objects from files whose nodes are their parts."""
from typing import Any, Dict, List, Optional

import numpy as np

from . import native as n
from .context import Context
from .gltf import Gltf, Node
from .objects import Model, Object
from .values import Error


def _largest(nodes: List[Node], points: np.ndarray) -> int:
    """The node with the largest box, most likely the body."""
    sides = [np.ptp(points[node.vertices], axis=0) if node.vertices.start < node.vertices.stop else np.zeros(3)
             for node in nodes]
    return int(np.argmax([float(side @ side) for side in sides]))


def _firsts(nodes: List[Node]) -> List[int]:
    """For each entry the first one of the same node or bone: a bone may have several."""
    seen: Dict[int, int] = {}
    return [seen.setdefault(node.node, index) for index, node in enumerate(nodes)]


def _parts(gltf: Gltf, nodes: List[Node], body: int, label: Optional[str]) -> List[Dict[str, Any]]:
    """Every node but the body is a part, with its name, pivot and carrier as hints."""
    first = _firsts(nodes)
    parts = []
    for index, node in enumerate(nodes):
        if first[index] != index or first[body] == index:
            continue
        carrier = None if node.carrier is None else first[node.carrier]
        names, pivot = gltf.hints(f"#{node.node}")
        parts.append({"id": index + 1, "parent": 0 if carrier in (None, first[body]) else carrier + 1,
                      "label": _cut(f"{label}/{names}" if label else names),
                      "pivot": None if gltf.pivots_are_lost else pivot})
    return parts


def _ids(nodes: List[Node], body: int, face_count: int) -> np.ndarray:
    """One part id a face: 1 + the node's place, 0 for the body."""
    ids, first = np.zeros(face_count, np.uint32), _firsts(nodes)
    for index, node in enumerate(nodes):
        ids[node.faces] = 0 if first[index] == first[body] else first[index] + 1
    return ids


def _cut(label: str) -> str:
    """As much of a label as the library takes, without half a character."""
    return label.encode()[:n.DM_MAX_LABEL].decode(errors="ignore")


def prepare_gltf(context: Context, gltf: Gltf, model: Optional[Model] = None, label: Optional[str] = None) -> Object:
    """Prepares a file: every node is a part but the one with the largest box, which is the body; part id = index of the
    Node + 1. Names, pivots and what carries what are hints. label: of the whole, such as the file's name."""
    nodes = gltf.nodes()
    points, faces = gltf.mesh()
    body = _largest(nodes, points)
    parts = _parts(gltf, nodes, body, label)
    if not parts:
        raise Error("DM_ERROR_FULL_MASK", n.DM_ERROR_FULL_MASK, "the file has one node: nothing moves against it")
    return context.prepare(points, faces, _ids(nodes, body, len(faces)), parts, model, picking=True)
