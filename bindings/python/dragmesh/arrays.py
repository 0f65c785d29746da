"""Arrays of numpy as the library reads them. No value is changed: what does not fit is an error."""
from typing import Any, Optional, Tuple

import numpy as np

from . import native as n

_POSITIONS = {np.dtype(np.float32): n.DM_FLOAT32, np.dtype(np.float64): n.DM_FLOAT64}
_INDICES = {np.dtype(np.uint32): n.DM_UINT32, np.dtype(np.uint16): n.DM_UINT16, np.dtype(np.uint8): n.DM_UINT8}
_PART_IDS = {**_INDICES, np.dtype(np.int32): n.DM_INT32}


def positions_of(values: Any, name: str = "positions") -> np.ndarray:
    """n x 3 floats, in single or double precision."""
    array = np.asarray(values)
    if array.dtype.kind not in "fiu" or array.dtype.itemsize > 8:
        raise TypeError(f"{name} are {array.dtype}, they must be real numbers")
    if array.dtype not in _POSITIONS:  # integers and half precision: double holds what indices can reach
        wide = array.astype(np.float64)
        if array.dtype.itemsize == 8 and not np.array_equal(wide.astype(array.dtype), array):
            raise ValueError(f"{name} have integers that floating point does not hold")
        array = wide
    if array.size % 3 or (array.ndim > 1 and array.shape[-1] != 3):
        raise ValueError(f"{name} have the shape {array.shape}, it must be (n, 3)")
    return np.ascontiguousarray(array.reshape(-1, 3))


def integers_of(values: Any, name: str, allowed: Any) -> np.ndarray:
    """A flat array of one of the allowed types; others are converted where every value fits."""
    array = np.asarray(values)
    if array.dtype.kind == "b":
        array = array.astype(np.uint8)
    if array.dtype.kind not in "iu" and array.size > 0:
        raise TypeError(f"{name} are {array.dtype}, they must be integers")
    array = array.reshape(-1)
    if array.dtype not in allowed:
        array = _converted(array, name, allowed)
    return np.ascontiguousarray(array)


def _converted(array: np.ndarray, name: str, allowed: Any) -> np.ndarray:
    """The same integers in an allowed type: int32 where it may be and one is negative, else uint32."""
    low, high = (int(array.min()), int(array.max())) if array.size > 0 else (0, 0)
    kind = np.int32 if low < 0 and np.dtype(np.int32) in allowed else np.uint32
    limits = np.iinfo(kind)
    if low < limits.min or high > limits.max:
        wrong = low if low < limits.min else high
        raise ValueError(f"{name} have the value {wrong} at {int(np.flatnonzero(array == wrong)[0])}, "
                         f"it must be {limits.min} to {limits.max}")
    return array.astype(kind)


def describe_mesh(positions: Any, indices: Any, part_ids: Any = None) -> Tuple[n.MeshDesc, Any]:
    """A dm_mesh_desc and the arrays that it points into, to be kept. part_ids: one a vertex or one a triangle."""
    points = positions_of(positions)
    corners = integers_of(indices, "indices", _INDICES)
    mesh = n.MeshDesc(
        positions=points.ctypes.data, vertex_count=len(points), position_bytes=points.nbytes,
        position_format=_POSITIONS[points.dtype], indices=corners.ctypes.data, index_count=len(corners),
        index_bytes=corners.nbytes, index_format=_INDICES[corners.dtype])
    ids: Optional[np.ndarray] = None
    if part_ids is not None:
        ids = integers_of(part_ids, "part_ids", _PART_IDS)
        if len(ids) not in (len(points), len(corners) // 3):
            raise ValueError(f"{len(ids)} part ids for {len(points)} vertices and {len(corners) // 3} triangles")
        mesh.part_ids, mesh.part_id_bytes, mesh.part_id_format = ids.ctypes.data, ids.nbytes, _PART_IDS[ids.dtype]
        mesh.part_id_scope = n.DM_PER_VERTEX if len(ids) == len(points) else n.DM_PER_FACE
    return mesh, (points, corners, ids)
