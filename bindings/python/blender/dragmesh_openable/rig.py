"""The joint in the viewport: an arrow that stands on the joint (rest), and below it an
empty (motion) whose rotation or location about its own z is the joint value. The part hangs on that."""
import math

import bpy
from mathutils import Matrix, Vector

CLOSED, OPEN = 1, 60  # frames of the animation
ARC_STEPS = 24
ARROW_SIZE, THICKNESS = 0.35, 0.009  # of the part's size


def turns(joint_type):
    """Whether the joint value is an angle."""
    return joint_type in ("REVOLUTE", "SCREW", "CONTINUOUS")


def _empty(name, display, size, matrix, collection):
    empty = bpy.data.objects.new(name, None)
    empty.empty_display_type, empty.empty_display_size = display, size
    empty.matrix_world = matrix
    collection.objects.link(empty)
    return empty


def _frame(axis, origin, towards):
    """A frame whose z is the axis and whose x points to the part, so that the arc is drawn beside it."""
    z = Vector(axis).normalized()
    x = towards - Vector(origin)
    x -= x.dot(z) * z
    x = x.normalized() if x.length > 1e-6 else z.orthogonal().normalized()
    y = z.cross(x)
    frame = Matrix((x, y, z)).transposed().to_4x4()
    frame.translation = origin
    return frame


def _centre(part):
    corners = [part.matrix_world @ Vector(corner) for corner in part.bound_box]
    return sum(corners, Vector()) / len(corners)


def _arc(name, points, thickness, collection):
    """A line that is rendered, too."""
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions, curve.bevel_depth = "3D", thickness
    for line in points:
        spline = curve.splines.new("POLY")
        spline.points.add(len(line) - 1)
        for point, place in zip(spline.points, line):
            point.co = (*place, 1)
    shown = bpy.data.objects.new(name, curve)
    collection.objects.link(shown)
    return shown


def _range_lines(kept, row, radius):
    """The axis, and the range as an arc with its two ends or as a line."""
    axis = [(0, 0, -radius), (0, 0, radius)]
    if not turns(row.type):
        return [[(0, 0, kept.lower), (0, 0, kept.upper)]]
    steps = [kept.lower + (kept.upper - kept.lower) * step / ARC_STEPS for step in range(ARC_STEPS + 1)]
    arc = [(radius * math.cos(angle), radius * math.sin(angle), 0) for angle in steps]
    return [axis, [(0, 0, 0), *arc, (0, 0, 0)]]


def hang(thing, main):
    """Lets an object go where the main one of its part goes."""
    matrix = thing.matrix_world.copy()
    thing.parent = main
    thing.matrix_world = matrix


def remove(part):
    """Takes the rig away; the part stays where it is at rest."""
    kept = part.dragmesh
    if kept.motion is not None:
        kept.motion.animation_data_clear()
        kept.motion.location, kept.motion.rotation_euler = (0, 0, 0), (0, 0, 0)
        bpy.context.view_layer.update()
        if part.parent == kept.motion:
            matrix = part.matrix_world.copy()
            part.parent = kept.rest.parent
            part.matrix_world = matrix
    for thing in (kept.motion, kept.rest):
        if thing is not None:
            for child in [child for child in thing.children if child.type == "CURVE"]:
                bpy.data.objects.remove(child)
            bpy.data.objects.remove(thing)
    kept.motion = kept.rest = None


def build(part):
    """Makes the rig of the chosen hypothesis."""
    remove(part)
    kept = part.dragmesh
    row = kept.hypotheses[kept.chosen]
    kept.lower, kept.upper = row.lower, row.upper
    collection = part.users_collection[0]
    size = max(part.dimensions)
    carrier = part.parent
    kept.rest = _empty(part.name + " joint", "SINGLE_ARROW", ARROW_SIZE * size,
                       _frame(row.axis, row.origin, _centre(part)), collection)
    if carrier is not None:
        stands = kept.rest.matrix_world.copy()
        kept.rest.parent = carrier
        kept.rest.matrix_world = stands
    kept.motion = _empty(part.name + " motion", "PLAIN_AXES", 0.3 * ARROW_SIZE * size, Matrix.Identity(4), collection)
    kept.motion.parent = kept.rest
    arc = _arc(part.name + " range", _range_lines(kept, row, ARROW_SIZE * size), THICKNESS * size, collection)
    arc.parent = kept.rest
    bpy.context.view_layer.update()


def attach(part):
    """Hangs the part on its motion. Until then the user may move and turn the arrow, and the part stays."""
    kept = part.dragmesh
    if part.parent == kept.motion:
        return
    matrix = part.matrix_world.copy()
    part.parent = kept.motion
    part.matrix_parent_inverse = Matrix.Identity(4)
    part.matrix_world = matrix
    bpy.context.view_layer.update()


def set_origin(part):
    """Puts the object's own origin on the joint. The mesh does not move, and what hangs on the object does not either."""
    hanging = [(child, child.matrix_world.copy()) for child in part.children]
    place = part.dragmesh.rest.matrix_world.translation
    part.data = part.data.copy() if part.data.users > 1 else part.data
    local = part.matrix_world.inverted() @ place
    part.data.transform(Matrix.Translation(-local))
    part.matrix_world = part.matrix_world @ Matrix.Translation(local)
    bpy.context.view_layer.update()
    for child, matrix in hanging:
        child.matrix_world = matrix
    bpy.context.view_layer.update()


def limit(part):
    """Lets the motion only be what the joint allows."""
    kept = part.dragmesh
    joint_type = kept.hypotheses[kept.chosen].type
    motion = kept.motion
    motion.constraints.clear()
    motion.lock_location, motion.lock_rotation = (True, True, turns(joint_type)), (True, True, not turns(joint_type))
    if joint_type == "CONTINUOUS":
        return
    constraint = motion.constraints.new("LIMIT_ROTATION" if turns(joint_type) else "LIMIT_LOCATION")
    constraint.owner_space = "LOCAL"
    if turns(joint_type):
        constraint.use_limit_z, constraint.min_z, constraint.max_z = True, kept.lower, kept.upper
    else:
        constraint.use_min_z = constraint.use_max_z = True
        constraint.min_z, constraint.max_z = kept.lower, kept.upper


def open_end(kept):
    """The limit that is farther from rest."""
    return kept.upper if abs(kept.upper) >= abs(kept.lower) else kept.lower


def animate(part):
    """Keys the opening: rest, then open."""
    kept = part.dragmesh
    row = kept.hypotheses[kept.chosen]
    path = "rotation_euler" if turns(row.type) else "location"
    value = 2 * math.pi if row.type == "CONTINUOUS" else open_end(kept)
    for frame, at in ((CLOSED, 0.0), (OPEN, value)):
        vector = getattr(kept.motion, path)
        vector[2] = at
        kept.motion.keyframe_insert(path, index=2, frame=frame)
        if row.type == "SCREW":
            kept.motion.location[2] = at * row.pitch
            kept.motion.keyframe_insert("location", index=2, frame=frame)


def write_properties(part, joint):
    """The joint as custom properties, which glTF takes along as extras."""
    kept = part.dragmesh
    part["dragmesh_type"] = kept.hypotheses[kept.chosen].type.lower()
    part["dragmesh_axis"], part["dragmesh_origin"] = list(joint.axis), list(joint.origin)
    part["dragmesh_lower"], part["dragmesh_upper"] = joint.lower, joint.upper
    part["dragmesh_confidence"] = kept.hypotheses[kept.chosen].confidence
