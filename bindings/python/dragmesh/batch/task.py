"""The work on one file, the same in a process of this machine and on a worker of a cluster."""
import json
import os
import time
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple

from .. import native as n
from ..assets import part_names
from ..context import Context
from ..gltf import Gltf
from ..objects import Model, Object
from ..rigs import Asset, rig_gltf
from ..values import Error, JointType

_contexts: Dict[int, Tuple[Context, Model]] = {}


class Result(NamedTuple):
    """What became of a file: an entry of the report, and the bytes of its .dmo or its rig; None: there are none."""
    entry: Dict[str, Any]
    dmo: Optional[bytes]


class RigOptions(NamedTuple):
    """How whole assets are rigged."""
    names: bool = True
    clips: bool = True
    min_moves: float = 0.5


def _context() -> Tuple[Context, Model]:
    """The context and weights of this process, made at its first file."""
    key = os.getpid()
    if key not in _contexts:
        context = Context(picking=n.DM_PICK_PORTABLE)
        _contexts[key] = context, context.load_shipped_model()
    return _contexts[key]


def _describe(prepared: Object, names: List[str]) -> List[Dict[str, Any]]:
    """What was found of each part."""
    found = []
    for part in prepared.parts():
        joint = prepared.joint(part.id)
        found.append({"id": part.id, "parent": part.parent, "name": names[part.id - 1],
                      "type": JointType(joint.type).name.lower(), "axis": list(joint.axis), "origin": list(joint.origin),
                      "lower": joint.lower, "upper": joint.upper, "confidence": joint.joint_confidence})
    return found


def _prepare(path: str) -> Tuple[List[Dict[str, Any]], bytes]:
    context, model = _context()
    label = os.path.splitext(os.path.basename(path))[0]
    with Gltf(path) as gltf, rig_gltf(context, gltf, model, label) as asset, asset.make_object() as prepared:
        return _describe(prepared, part_names(asset, gltf)), prepared.save()


def _plain(joint: n.Joint, origin: Sequence[float]) -> Dict[str, Any]:
    """A joint as rig.json has it: a turn or a slide; what these lack is in dragmesh_joint."""
    name, limited = JointType(joint.type).name.lower(), joint.type != JointType.CONTINUOUS
    entry = {"type": name, "type_confidence": joint.type_confidence, "confidence": joint.joint_confidence,
             "axis": list(joint.axis), "origin": [float(a + b) for a, b in zip(joint.origin, origin)],
             "lower": joint.lower if limited else None, "upper": joint.upper if limited else None}
    if joint.type not in (JointType.SCREW, JointType.CONTINUOUS):
        return entry
    exact = {**entry, "pitch": joint.pitch} if joint.type == JointType.SCREW else dict(entry)
    return {**entry, "type": "revolute", "dragmesh_joint": exact}


def _rigged(asset: Asset, gltf: Gltf) -> List[Dict[str, Any]]:
    """The parts as rig.json of `dragmesh rig` has them."""
    nodes, origin, found = gltf.asset_nodes(), gltf.origin(), []
    for index, part in enumerate(asset.parts()):
        joint, own = asset.joint(index), asset.part_nodes(index)
        entry = {"nodes": [nodes[node][0] for node in own], "node_indices": [nodes[node][1] for node in own],
                 "parent": -1 if part.parent == n.DM_ASSET_NO_PART else part.parent,
                 "state": ("stays", "moves", "free")[part.state], "moves": part.moves,
                 "basis": ("inferred", "file", "clip")[part.basis], **_plain(joint, origin)}
        if part.duration > 0:
            entry["duration"] = part.duration
        found.append({**entry, "triangle_count": part.triangle_count})
    return found


def _rig(path: str, options: RigOptions) -> Tuple[List[Dict[str, Any]], bytes]:
    context, model = _context()
    label = os.path.splitext(os.path.basename(path))[0]
    with Gltf(path) as gltf, rig_gltf(context, gltf, model, label, *options) as asset:
        parts = _rigged(asset, gltf)
        return parts, json.dumps({"parts": parts}, indent=1).encode()


def rig_file(path: str, options: RigOptions) -> Result:
    """Rigs a file as a whole asset. Never raises, as prepare_file."""
    return _answer(lambda: _rig(path, options))


def prepare_file(path: str) -> Result:
    """Prepares a file. Never raises: what is wrong with it stands in the entry."""
    return _answer(lambda: _prepare(path))


def _answer(work: Callable[[], Tuple[List[Dict[str, Any]], bytes]]) -> Result:
    begun = time.monotonic()
    entry: Dict[str, Any] = {}
    dmo = None
    try:
        entry["parts"], dmo = work()
    except Error as error:
        entry["error"], entry["text"] = error.name, error.message
    except Exception as error:  # pylint: disable=broad-except
        entry["error"], entry["text"] = type(error).__name__, str(error)
    entry["seconds"] = round(time.monotonic() - begun, 3)
    return Result(entry, dmo)
