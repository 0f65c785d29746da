"""Rigged assets as files of engines and simulators, through libdragmesh_gltf."""
import ctypes as c
import os
from typing import Any, Callable, Dict, Iterable, List, Optional

from . import native as n
from .base import text_of
from .gltf import Gltf
from .rigs import Asset
from .values import check
from .whole_file import write_together

_LOG = dict(n.Log._fields_)["message"]
RIG_FORMATS = {name: getattr(n, f"DM_GLTF_RIG_{name.upper()}") for name in ("glb", "urdf", "mjcf", "sdf", "usda", "tscn")}


def _bits(formats: Iterable[str]) -> int:
    bits = 0
    for name in [formats] if isinstance(formats, str) else formats:
        if name not in RIG_FORMATS:
            raise ValueError(f"{name!r} is none of the formats {', '.join(RIG_FORMATS)}")
        bits |= RIG_FORMATS[name]
    return bits


def _listener(said: List[str], log: Optional[Callable[[int, str], None]]) -> Any:
    def on_message(_: Any, level: int, _code: int, text: bytes) -> None:
        message = text.decode(errors="replace")
        if level == n.DM_LOG_ERROR:
            said.append(message)
        if log is not None:
            log(level, message)

    return _LOG(on_message)


def _read(library: Any, rig: Any) -> Dict[str, bytes]:
    files = {}
    for index in range(library.dm_gltf_rig_file_count(rig)):
        row = n.GltfRigFile()
        check(library.dm_gltf_rig_get_file(rig, index, c.byref(row)))
        files[row.path.decode()] = c.string_at(row.data, row.size)
    return files


def export_rig(asset: Asset, gltf: Gltf, formats: Iterable[str], name: str = "asset", density: float = 0, thickness: float = 0,
               friction: float = 0, damping_time: float = 0, log: Optional[Callable[[int, str], None]] = None) -> Dict[str, bytes]:
    """The files, by their paths below one folder, of an asset that rig_gltf has made of the file in a context with glTF's axes and
    metres. formats: of RIG_FORMATS. density: kg/m³; thickness: m, of open surfaces; friction: share of a part's weight;
    damping_time: s; 0: as dm_gltf_rig_desc says. log(level, text) gets warnings of what a format can't hold."""
    said: List[str] = []
    nodes, count = gltf.asset()
    parts = asset.parts()
    node_parts = [n.DM_ASSET_NO_PART if part is None else part for part in asset.node_parts()]
    if len(node_parts) != count:
        raise ValueError(f"the asset has {len(node_parts)} nodes, the file has {count}")
    on_message = _listener(said, log)
    desc = n.GltfRigDesc(formats=_bits(formats), nodes=nodes, node_count=count, parts=(n.AssetPart * len(parts))(*parts),
                         joints=(n.Joint * len(parts))(*[asset.joint(index) for index in range(len(parts))]),
                         part_count=len(parts), node_parts=(c.c_uint32 * count)(*node_parts), name=text_of(name, "name"),
                         gltf=gltf.pointer, density=density, thickness=thickness, friction=friction, damping_time=damping_time,
                         log=n.Log(None, on_message))
    rig = c.c_void_p()
    with gltf._turn:
        check(gltf.library.dm_gltf_rig_make(c.byref(desc), c.byref(rig)), said[-1] if said else "")
    try:
        return _read(gltf.library, rig)
    finally:
        gltf.library.dm_gltf_rig_destroy(rig)


def write_rig(folder: "os.PathLike[str] | str", files: Dict[str, bytes]) -> None:
    """Writes what export_rig has made into a folder, which is made: all of it or nothing of it."""
    paths = {os.path.join(folder, *path.split("/")): data for path, data in files.items()}
    for parent in {os.path.dirname(path) for path in paths}:
        os.makedirs(parent, exist_ok=True)
    write_together(paths)
