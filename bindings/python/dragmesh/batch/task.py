"""The work on one file, the same in a process of this machine and on a worker of a cluster."""
import os
import time
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

from .. import native as n
from ..assets import prepare_gltf
from ..context import Context
from ..gltf import Gltf, Node
from ..objects import Model, Object
from ..values import Error, JointType

_contexts: Dict[int, Tuple[Context, Model]] = {}


class Result(NamedTuple):
    """What became of a file: an entry of the report, and the bytes of its .dmo; None: there is none."""
    entry: Dict[str, Any]
    dmo: Optional[bytes]


def _context() -> Tuple[Context, Model]:
    """The context and weights of this process, made at its first file."""
    key = os.getpid()
    if key not in _contexts:
        context = Context(picking=n.DM_PICK_PORTABLE)
        _contexts[key] = context, context.load_shipped_model()
    return _contexts[key]


def _describe(prepared: Object, nodes: List[Node]) -> List[Dict[str, Any]]:
    """What was found of each part."""
    found = []
    for part in prepared.parts():
        joint = prepared.joint(part.id)
        found.append({"id": part.id, "parent": part.parent, "name": nodes[part.id - 1].name,
                      "type": JointType(joint.type).name.lower(), "axis": list(joint.axis), "origin": list(joint.origin),
                      "lower": joint.lower, "upper": joint.upper, "confidence": joint.joint_confidence})
    return found


def _prepare(path: str) -> Tuple[List[Dict[str, Any]], bytes]:
    context, model = _context()
    with Gltf(path) as gltf, prepare_gltf(context, gltf, model, os.path.splitext(os.path.basename(path))[0]) as prepared:
        return _describe(prepared, gltf.nodes()), prepared.save()


def prepare_file(path: str) -> Result:
    """Prepares a file. Never raises: what is wrong with it stands in the entry."""
    begun = time.monotonic()
    entry: Dict[str, Any] = {}
    dmo = None
    try:
        entry["parts"], dmo = _prepare(path)
    except Error as error:
        entry["error"], entry["text"] = error.name, error.message
    except Exception as error:  # pylint: disable=broad-except
        entry["error"], entry["text"] = type(error).__name__, str(error)
    entry["seconds"] = round(time.monotonic() - begun, 3)
    return Result(entry, dmo)
