"""glTF in and out, through libdragmesh_gltf."""
import ctypes as c
import os
import threading
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import native as n
from .arrays import integers_of, positions_of
from .base import Unique, bytes_of, integer, text_of
from .library import open_library
from .values import check

_LOG = dict(n.Log._fields_)["message"]
_FLOATS, _BYTES = c.POINTER(c.c_float), c.POINTER(c.c_uint8)


def _load() -> c.CDLL:
    return open_library("libdragmesh_gltf.so", n.GLTF_FUNCTIONS)


class Node(NamedTuple):
    """What moves as one: a node with a mesh, or a bone."""
    name: str
    node: int  # index in the file's nodes array
    carrier: Optional[int]  # the Node above it, by index
    vertices: slice
    faces: slice
    colour: Tuple[float, ...]


class Surface(NamedTuple):
    """Faces with one material."""
    faces: slice
    colour: Tuple[float, ...]
    image: Optional[bytes]  # as it is stored: PNG, JPEG
    wrap: Tuple[int, int]


class Gltf(Unique):
    """A glTF file as one merged mesh in the scene's frame. Threads take turns."""

    def __init__(self, source: Union[bytes, str, "os.PathLike[str]"]) -> None:
        """source: the path of a .glb or .gltf, read with the files beside it; or the bytes of one that needs none."""
        self.library, self._said, self._turn = _load(), "", threading.RLock()
        self._on_message = _LOG(self._remember)
        self.pointer: Any = c.c_void_p()
        desc = n.GltfDesc(log=n.Log(None, self._on_message))
        if not isinstance(source, (str, os.PathLike)):
            data = bytes_of(source, "source")
            kept = c.c_char_p(data)
            desc.data, desc.size = c.cast(kept, c.c_void_p), len(data)
            self._check(self.library.dm_gltf_open(c.byref(desc), c.byref(self.pointer)))
        else:
            path = os.fsencode(source)
            if 0 in path:
                raise ValueError("source has a zero character")
            self._check(self.library.dm_gltf_open_file(path, c.byref(desc), c.byref(self.pointer)))

    def _remember(self, _: Any, level: int, _code: int, text: bytes) -> None:
        if level == n.DM_LOG_ERROR:
            self._said = text.decode(errors="replace")

    def _check(self, result: int) -> None:
        message, self._said = self._said, ""
        check(result, message)

    def _call(self, name: str, *arguments: Any) -> Any:
        """What dm_gltf_<name>(file, ...) answers."""
        with self._turn:
            if not self.pointer:
                raise ValueError("the file is closed")
            return getattr(self.library, "dm_gltf_" + name)(self.pointer, *arguments)

    def _do(self, name: str, *arguments: Any) -> None:
        """dm_gltf_<name>(file, ...), an Error when it fails."""
        with self._turn:
            self._check(self._call(name, *arguments))

    def close(self) -> None:
        """Ends it. A second time does nothing."""
        with self._turn:
            if self.pointer:
                self.library.dm_gltf_close(self.pointer)
                self.pointer = c.c_void_p()

    def __enter__(self) -> "Gltf":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def __del__(self) -> None:
        if getattr(self, "pointer", None):
            self.close()

    def nodes(self) -> List[Node]:
        """All nodes with a mesh, and bones."""
        with self._turn:
            nodes = []
            for index in range(self._call("node_count")):
                row = n.GltfNode()
                self._do("get_node", index, c.byref(row))
                nodes.append(Node(row.name.decode(), row.node, None if row.carrier == n.DM_GLTF_NO_CARRIER else row.carrier,
                                  slice(row.first_vertex, row.first_vertex + row.vertex_count),
                                  slice(row.first_face, row.first_face + row.face_count), tuple(row.colour)))
            return nodes

    def mesh(self) -> Tuple[np.ndarray, np.ndarray]:
        """Positions (n x 3, float32) and triangles (m x 3, uint32) of the merged mesh."""
        with self._turn:
            mesh = n.MeshDesc()
            self._do("get_mesh", c.byref(mesh))
            points = np.ctypeslib.as_array(c.cast(mesh.positions, _FLOATS), (mesh.vertex_count, 3))
            corners = np.ctypeslib.as_array(c.cast(mesh.indices, c.POINTER(c.c_uint32)), (mesh.index_count // 3, 3))
            return points.copy(), corners.copy()

    def face_count(self) -> int:
        """Triangles of the merged mesh."""
        mesh = n.MeshDesc()
        self._do("get_mesh", c.byref(mesh))
        return mesh.index_count // 3

    def origin(self) -> np.ndarray:
        """Where the merged mesh's origin is in the scene."""
        out = (c.c_double * 3)()
        self._call("get_origin", out)
        return np.array(out)

    def mark_faces(self, names: Sequence[str], value: int, face_ids: np.ndarray) -> None:
        """Sets value for every face of the named nodes and of what they carry, in an array of uint8. "#12" means node
        12."""
        if not isinstance(face_ids, np.ndarray) or face_ids.dtype != np.uint8:
            raise TypeError("face_ids must be an array of uint8")
        if not face_ids.flags.c_contiguous or not face_ids.flags.writeable:
            raise ValueError("face_ids must be contiguous and writeable")
        texts = (c.c_char_p * len(names))(*(text_of(name, "a name") for name in names))
        self._do("mark_faces", texts, len(names), integer(c.c_uint8, value, "value"), face_ids.ctypes.data_as(_BYTES),
                 face_ids.size)

    def hints(self, name: str) -> Tuple[str, Tuple[np.ndarray, np.ndarray]]:
        """(label, pivot) of a node, as Context.prepare takes them. "#12" means node 12."""
        label, pivot = c.create_string_buffer(n.DM_MAX_LABEL + 1), n.Pivot()
        self._do("get_hints", text_of(name, "name"), label, len(label), c.byref(pivot))
        return label.value.decode(), (np.array(tuple(pivot.origin)), np.array(pivot.axes).reshape(3, 3))

    def asset(self) -> Tuple[Any, int]:
        """The nodes as dm_asset_desc takes them, and their count. They end with the file."""
        nodes, count = c.POINTER(n.AssetNode)(), c.c_uint32()
        self._do("get_asset", 0, c.byref(nodes), c.byref(count))
        return nodes, count.value

    def asset_nodes(self) -> List[Tuple[str, int]]:
        """Name, and index in the file's nodes array, of each node of an asset."""
        with self._turn:
            nodes, count = self.asset()
            found = []
            for index in range(count):
                number = c.c_uint32()
                self._do("get_asset_node", index, c.byref(number))
                found.append(((nodes[index].name or b"").decode(), number.value))
            return found

    @property
    def left_out(self) -> bool:
        """Whether triangles of the file are not in the mesh: they could not be read."""
        return bool(self._call("left_out"))

    @property
    def pivots_are_lost(self) -> bool:
        """Whether pivots tell nothing: the origins of all nodes, of which there are several, are one point."""
        return bool(self._call("pivots_are_lost"))

    def read_mask(self, data: bytes, value: Optional[int] = None) -> np.ndarray:
        """Part ids from the bytes of a .npy or JSON mask, one a vertex or one a face. value: what moves; None:
        non-zero."""
        mesh, scope = n.MeshDesc(), c.c_int32()
        self._do("get_mesh", c.byref(mesh))
        counts = {n.DM_PER_VERTEX: mesh.vertex_count, n.DM_PER_FACE: mesh.index_count // 3}
        ids = np.zeros(max(counts.values()), np.uint8)
        chosen = c.byref(c.c_int64(integer(c.c_int64, value, "value"))) if value is not None else None
        data = bytes_of(data, "data")
        self._do("read_mask", data, len(data), chosen, ids.ctypes.data_as(_BYTES), c.byref(scope), None)
        return ids[:counts[scope.value]]

    def surfaces(self) -> List[Surface]:
        """Faces by material."""
        with self._turn:
            found = []
            for index in range(self._call("surface_count")):
                row = n.GltfSurface()
                self._do("get_surface", index, c.byref(row))
                image = c.string_at(row.image, row.image_size) if row.image else None
                found.append(Surface(slice(row.first_face, row.first_face + row.face_count), tuple(row.colour), image,
                                     (row.wrap_u, row.wrap_v)))
            return found

    def texture_coordinates(self, surface: int) -> np.ndarray:
        """u and v of each corner (faces x 3 x 2) of a surface."""
        faces = self.surfaces()[surface].faces
        out = np.zeros((faces.stop - faces.start, 3, 2), np.float32)
        self._do("get_texture_coordinates", surface, out.ctypes.data_as(_FLOATS), out.size // 2)
        return out

    def export(self, tracks: Sequence[Dict[str, Any]]) -> bytes:
        """The bytes of a .glb with animated parts: dicts of face_ids, value, poses, times (s, rising) and, as wanted,
        name."""
        rows, kept = [], []
        faces = self.face_count()
        for track in tracks:
            ids = integers_of(track["face_ids"], "face_ids", {np.dtype(np.uint8): 0})
            times, poses = track["times"], track["poses"]
            if len(times) != len(poses):
                raise ValueError(f"{len(times)} times for {len(poses)} poses")
            if len(ids) != faces or ids.dtype != np.uint8:
                raise ValueError(f"face_ids are {len(ids)} of {ids.dtype}, they must be {faces} of uint8")
            kept.append(ids)
            name = text_of(track.get("name", "moving_part"), "name")
            rows.append(n.GltfTrack(name=name, face_ids=ids.ctypes.data_as(_BYTES), value=track["value"],
                                    poses=(n.Pose * len(poses))(*poses), times=(c.c_float * len(times))(*times),
                                    key_count=len(times)))
        data, size = c.c_void_p(), c.c_size_t()
        with self._turn:
            self._do("export", (n.GltfTrack * len(rows))(*rows), len(rows), c.byref(data), c.byref(size))
            bytes_ = c.string_at(data, size.value)
            self._call("release_bytes", data, size)
        return bytes_


def write_glb(parts: Sequence[Dict[str, Any]]) -> bytes:
    """The bytes of a static .glb with one node a part: dicts of positions, indices and, as wanted, name, colour."""
    rows, kept, library = [], [], _load()
    for part in parts:
        points = positions_of(part["positions"]).astype(np.float32)
        corners = integers_of(part["indices"], "indices", {np.dtype(np.uint32): 0})
        kept += [points, corners]
        rows.append(n.GltfPart(name=text_of(part.get("name", "part"), "name"), positions=points.ctypes.data_as(_FLOATS),
                               indices=corners.ctypes.data_as(c.POINTER(c.c_uint32)), vertex_count=len(points),
                               index_count=len(corners), colour=(c.c_float * 4)(*part.get("colour", (1, 1, 1, 1)))))
    allocate, release, blocks = _allocator()
    allocator = n.Allocator(None, allocate, release)
    data, size = c.c_void_p(), c.c_size_t()
    check(library.dm_gltf_write((n.GltfPart * len(rows))(*rows), len(rows), c.byref(allocator), None, c.byref(data),
                                c.byref(size)))
    written = c.string_at(data, size.value)
    blocks.clear()
    return written


def _allocator() -> Tuple[Any, Any, Dict[int, Any]]:
    """An allocator whose blocks Python frees."""
    blocks: Dict[int, Any] = {}
    fields = dict(n.Allocator._fields_)

    def allocate(_: Any, size: int, alignment: int) -> int:
        block = c.create_string_buffer(size + alignment)
        address = -(-c.addressof(block) // alignment) * alignment
        blocks[address] = block
        return address

    def release(_: Any, memory: int, _size: int) -> None:
        blocks.pop(memory, None)

    return fields["allocate"](allocate), fields["release"](release), blocks
