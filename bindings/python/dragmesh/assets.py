"""Objects of files that are taken as whole assets."""
from typing import List, Optional

from . import native as n
from .context import Context
from .gltf import Gltf
from .objects import Model, Object
from .rigs import Asset, rig_gltf


def prepare_gltf(context: Context, gltf: Gltf, model: Optional[Model] = None, label: Optional[str] = None) -> Object:
    """Prepares a file as `dragmesh prepare` does: the asset says which nodes move, and which of them as one. rig_gltf gives
    the asset itself, whose parts these are: part id = index of the part + 1. label: of the whole, such as the file's name.
    DM_ERROR_EMPTY_MASK: nothing moves."""
    with rig_gltf(context, gltf, model, label) as asset:
        return asset.make_object()


def part_names(asset: Asset, gltf: Gltf) -> List[str]:
    """What the parts of a file's asset are called: as the highest of a part's nodes above the one with the most triangles."""
    nodes, count = gltf.asset()
    names, parts = gltf.asset_nodes(), asset.node_parts()
    size = [nodes[index].mesh.contents.index_count if nodes[index].mesh else 0 for index in range(count)]
    found = []
    for part in range(len(asset.parts())):
        top = max(asset.part_nodes(part), key=lambda node: (size[node], -node))
        while nodes[top].parent != n.DM_ASSET_NO_NODE and parts[nodes[top].parent] == part:
            top = nodes[top].parent
        found.append(names[top][0])
    return found
