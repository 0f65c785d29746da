"""Objects of a scene as one mesh of the library, in the frame of the scene: z up, metres."""
import numpy as np

import dragmesh

from .properties import NAMES


def _triangles(thing, depsgraph):
    """World positions and triangles of an object as it is shown, modifiers included."""
    evaluated = thing.evaluated_get(depsgraph)
    mesh = evaluated.to_mesh()
    try:
        mesh.calc_loop_triangles()
        points = np.empty(3 * len(mesh.vertices), np.float32)
        corners = np.empty(3 * len(mesh.loop_triangles), np.int32)
        mesh.vertices.foreach_get("co", points)
        mesh.loop_triangles.foreach_get("vertices", corners)
    finally:
        evaluated.to_mesh_clear()
    matrix = np.array(evaluated.matrix_world)
    return points.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3], corners.reshape(-1, 3)


def _label(thing):
    """The object's names, outermost first: collection, parents, object, mesh."""
    names = [thing.name, thing.data.name]
    above = thing.parent
    while above is not None:
        names.insert(0, above.name)
        above = above.parent
    return "/".join([thing.users_collection[0].name, *names] if thing.users_collection else names)


def _pivots_are_lost(things):
    """Whether all objects have one origin, as after an export that has applied their transforms."""
    return len({tuple(thing.matrix_world.translation) for thing in things}) == 1


def _describe(thing, number, numbers, has_pivot):
    matrix = thing.matrix_world
    carrier = thing.parent
    while carrier is not None and carrier not in numbers:
        carrier = carrier.parent
    axes = [list(matrix.col[k][:3]) for k in range(3)]
    return {"id": number, "parent": numbers.get(carrier, 0), "label": _label(thing),
            "pivot": (list(matrix.translation), axes) if has_pivot else None}


def _with_what_it_carries(thing, others, depsgraph):
    """World positions and triangles of an object and of the meshes below it that are none of the others."""
    pieces, start, below = [_triangles(thing, depsgraph)], 0, list(thing.children)
    while below:
        child = below.pop()
        if child in others:
            continue
        below += child.children
        if child.type == "MESH":
            pieces.append(_triangles(child, depsgraph))
    points, corners = [], []
    for found, faces in pieces:
        points.append(found)
        corners.append(faces + start)
        start += len(found)
    return np.concatenate(points), np.concatenate(corners)


def prepare(context, body, parts, depsgraph, progress=None):
    """A prepared object of a body and its parts, whose ids are 1 and up in this order."""
    numbers = {part: index + 1 for index, part in enumerate(parts)}
    pieces = [_with_what_it_carries(thing, {body, *parts}, depsgraph) for thing in (body, *parts)]
    starts = np.cumsum([0] + [len(points) for points, _ in pieces])
    points = np.concatenate([points for points, _ in pieces])
    corners = np.concatenate([faces + start for (_, faces), start in zip(pieces, starts)])
    ids = np.concatenate([np.full(len(faces), number) for number, (_, faces) in enumerate(pieces)])
    has_pivot = not _pivots_are_lost((body, *parts))
    return context.prepare(points, corners, ids, [_describe(part, numbers[part], numbers, has_pivot) for part in parts],
                           context.load_shipped_model(), label=body.name, progress=progress)


def ask(context, things, depsgraph, progress=None):
    """A whole asset of mesh objects: dragmesh.Asset, whose nodes are the objects in this order."""
    places, lost, nodes = {thing: index for index, thing in enumerate(things)}, _pivots_are_lost(things), []
    for thing in things:
        points, corners = _triangles(thing, depsgraph)
        above = thing.parent
        while above is not None and above not in places:
            above = above.parent
        matrix = thing.matrix_world
        nodes.append({"name": thing.name, "mesh_name": thing.data.name, "parent": places.get(above), "positions": points,
                      "indices": corners, "pivot": (list(matrix.translation), [list(matrix.col[k][:3]) for k in range(3)]),
                      "no_pivot": lost})
    return dragmesh.rig(context, nodes, context.load_shipped_model(), progress=progress)


def parts_of(asset, things):
    """What moves: a list of (number, main object, its other objects). What has the most faces is the main one."""
    found = []
    for index, part in enumerate(asset.parts()):
        own = [things[node] for node in asset.part_nodes(index)]
        main = max(own, key=lambda thing: len(thing.data.polygons))
        if part.part_id:
            found.append((part.part_id, main, [thing for thing in own if thing != main]))
    return found


def keep(part, number, body, prepared):
    """Writes what was found into the part's properties."""
    kept = part.dragmesh
    kept.id, kept.body, kept.chosen = number, body, 0
    kept.hypotheses.clear()
    for joint in prepared.hypotheses(number):
        row = kept.hypotheses.add()
        row.type, row.axis, row.origin = NAMES[joint.type], tuple(joint.axis), tuple(joint.origin)
        row.lower, row.upper, row.pitch, row.confidence = joint.lower, joint.upper, joint.pitch, joint.joint_confidence


def joint_of(part):
    """The joint that is in force, as the rig stands now: the user may have moved it."""
    kept = part.dragmesh
    row = kept.hypotheses[kept.chosen]
    joint = dragmesh.Joint(type=NAMES.index(row.type), lower=kept.lower, upper=kept.upper, pitch=row.pitch)
    matrix = kept.rest.matrix_world
    joint.axis = dragmesh.Vec3(*matrix.col[2].xyz.normalized())
    joint.origin = dragmesh.Vec3(*matrix.translation)
    return joint
