"""Whole assets: which of their nodes move, how, and what carries what."""
import ctypes as c
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

import numpy as np

from . import native as n
from .arrays import describe_mesh
from .base import text_of
from .context import Context, guarded, pivot_of
from .gltf import Gltf
from .objects import Model, Object, Owned
from .values import vec3

_FIELDS = dict(n.AssetDesc._fields_)
_KEYS = {"name", "mesh_name", "parent", "positions", "indices", "transform", "pivot", "joint", "follows", "no_pivot", "clips"}


class Asset(Owned):
    """A whole asset and its parts: nodes that move as one, or might."""
    _end = "asset_destroy"

    def info(self) -> n.AssetInfo:
        """Counts, and what the answer lacks."""
        info = n.AssetInfo()
        self.call("asset_get_info", c.byref(info))
        return info

    def parts(self) -> List[n.AssetPart]:
        """All parts, those that stay included."""
        parts = []
        for index in range(self.info().part_count):
            parts.append(n.AssetPart())
            self.call("asset_get_part", index, c.byref(parts[-1]))
        return parts

    def joint(self, index: int) -> n.Joint:
        """How a part moves; of one that stays, how it would."""
        joint = n.Joint()
        self.call("asset_get_joint", index, c.byref(joint))
        return joint

    def part_nodes(self, index: int) -> List[int]:
        """The nodes of a part, rising."""
        part = n.AssetPart()
        self.call("asset_get_part", index, c.byref(part))
        nodes = (c.c_uint32 * part.node_count)()
        self.call("asset_get_part_nodes", index, nodes, len(nodes))
        return list(nodes)

    def node_parts(self) -> List[Optional[int]]:
        """The part of each node; None: the body that stays."""
        parts = (c.c_uint32 * self.info().node_count)()
        self.call("asset_get_node_parts", parts, len(parts))
        return [None if part == n.DM_ASSET_NO_PART else part for part in parts]

    def make_object(self) -> Object:
        """A prepared object of the parts that move; their ids are their indices + 1."""
        handle = c.c_uint64()
        self.call("asset_make_object", c.byref(handle))
        return Object(self.context, handle.value, self._kept)


def _create(context: Context, nodes: Any, count: int, model: Optional[Model], label: Optional[str], names: bool, clips: bool,
            min_moves: float, flags: int, up: Optional[Sequence[float]], progress: Optional[Callable[[float], Any]] = None) -> Asset:
    flags |= (0 if clips else n.DM_ASSET_WITHOUT_CLIPS) | (0 if names else n.DM_ASSET_WITHOUT_NAMES)
    desc = n.AssetDesc(flags=flags, nodes=nodes, node_count=count, model=model.handle if model else 0, min_moves=min_moves,
                       label=text_of(label, "label") if label else None, up=vec3(up) if up is not None else n.Vec3())
    failures: List[BaseException] = []
    if progress is not None:
        told = progress
        desc.progress = _FIELDS["progress"](guarded(lambda _, done: int(told(done) is False), 1, failures))
    handle = c.c_uint64()
    try:
        context.make("asset_create", model, c.byref(desc), c.byref(handle))
    finally:
        if failures:
            if handle.value:
                context.call("asset_destroy", handle.value)
            raise failures[0]
    return Asset(context, handle.value, model)


def _clip_rows(clips: Sequence[Dict[str, Any]], kept: List[Any]) -> Any:
    rows = (n.AssetClip * len(clips))()
    for row, clip in zip(rows, clips):
        times = np.ascontiguousarray(clip["times"], np.float32)
        poses = (n.Pose * len(clip["poses"]))(*clip["poses"])
        if len(times) != len(poses):
            raise ValueError(f"{len(times)} times for {len(poses)} poses")
        kept += [times, poses]
        row.times, row.poses, row.key_count = times.ctypes.data_as(c.POINTER(c.c_float)), poses, len(times)
        row.name = text_of(clip["name"], "name") if clip.get("name") is not None else None
    kept.append(rows)
    return rows


def _fill(row: n.AssetNode, node: Dict[str, Any], kept: List[Any]) -> None:
    unknown = set(node) - _KEYS
    if unknown:
        raise TypeError(f"a node has no {', '.join(sorted(unknown))}")
    row.struct_size = c.sizeof(n.AssetNode)
    row.parent = n.DM_ASSET_NO_NODE if node.get("parent") is None else node["parent"]
    row.flags = (n.DM_ASSET_NODE_FOLLOWS if "follows" in node else 0) | (n.DM_ASSET_NODE_NO_PIVOT if node.get("no_pivot") else 0)
    row.follows = n.DM_ASSET_NO_NODE if node.get("follows") is None else node["follows"]
    for name in ("name", "mesh_name"):
        if node.get(name) is not None:
            setattr(row, name, text_of(node[name], name))
    if node.get("positions") is not None:
        mesh, arrays = describe_mesh(node["positions"], node.get("indices"), None)
        kept += [mesh, arrays]
        row.mesh = c.pointer(mesh)
    if node.get("transform") is not None:
        kept.append(np.ascontiguousarray(np.asarray(node["transform"], np.float32).reshape(4, 4).T))
        row.transform = kept[-1].ctypes.data_as(c.POINTER(c.c_float))
    if node.get("pivot") is not None:
        kept.append(pivot_of(node["pivot"]))
        row.pivot = c.pointer(kept[-1])
    if node.get("joint") is not None:
        kept.append(node["joint"])
        row.joint = c.pointer(node["joint"])
    if node.get("clips"):
        row.clips, row.clip_count = _clip_rows(node["clips"], kept), len(node["clips"])


def rig(context: Context, nodes: Sequence[Dict[str, Any]], model: Optional[Model] = None, label: Optional[str] = None,
        names: bool = True, clips: bool = True, min_moves: float = 0.0, up: Optional[Sequence[float]] = None,
        progress: Optional[Callable[[float], Any]] = None) -> Asset:
    """An asset from its nodes: dicts with, as wanted, name, mesh_name, parent (index), positions (n x 3), indices (m x 3),
    transform (4 x 4, node to asset), pivot=(origin, axes), joint (that the file states), follows (index or None: neither part
    nor body), no_pivot, clips (dicts of times, poses and name). names, clips: whether they count. min_moves: probability
    from which on a part moves; 0: 0.5. progress(done): gets 0 to 1; returns False to cancel."""
    rows, kept = (n.AssetNode * len(nodes))(), []  # type: Tuple[Any, List[Any]]
    for row, node in zip(rows, nodes):
        _fill(row, node, kept)
    return _create(context, rows, len(rows), model, label, names, clips, min_moves, 0, up, progress)


def rig_gltf(context: Context, gltf: Gltf, model: Optional[Model] = None, label: Optional[str] = None, names: bool = True,
             clips: bool = True, min_moves: float = 0.0) -> Asset:
    """A file as an asset, as `dragmesh rig` takes it. label: of the whole, such as the file's name. Gltf.asset_nodes has its
    nodes."""
    nodes, count = gltf.asset()
    flags = n.DM_PREPARE_MESH_INCOMPLETE if gltf.left_out else 0
    return _create(context, nodes, count, model, label, names, clips, min_moves, flags, None)
