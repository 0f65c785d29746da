"""blender -b --factory-startup --python run.py -- FILE.glb OUT_FOLDER ADDON.zip [--render PICTURE]: installs the add-on, makes
an imported asset openable, and checks what comes of it. BLENDER_USER_SCRIPTS: where it is installed."""
import json
import math
import os
import sys

import bpy
import numpy as np
from mathutils import Vector

if not hasattr(np, "bool"):
    np.bool = bool  # Debian 12's glTF importer is older than its numpy

source, out, addon = sys.argv[sys.argv.index("--") + 1:][:3]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.preferences.addon_install(filepath=addon)
bpy.ops.preferences.addon_enable(module="dragmesh_openable")

import dragmesh  # noqa: E402  pylint: disable=wrong-import-position
from dragmesh_openable import rig  # noqa: E402  pylint: disable=wrong-import-position

picture = sys.argv[sys.argv.index("--render") + 1] if "--render" in sys.argv else None


def must(holds, what):
    if not holds:
        raise AssertionError(what)


def vertex(part, index):
    """Where a vertex of the part is in the world."""
    return part.matrix_world @ part.data.vertices[index].co


def far_vertex(part):
    """Index of the vertex that is farthest from the joint."""
    at = part.dragmesh.rest.matrix_world.translation
    return max(range(len(part.data.vertices)), key=lambda index: (vertex(part, index) - at).length)


def select(parts, active):
    bpy.ops.object.select_all(action="DESELECT")
    for thing in (*parts, active):
        thing.select_set(True)
    bpy.context.view_layer.objects.active = active


def check_motion(part, index, before):
    """At the open frame the part has moved as its joint says."""
    kept, scene = part.dragmesh, bpy.context.scene
    axis = kept.rest.matrix_world.col[2].xyz.normalized()
    origin = kept.rest.matrix_world.translation.copy()
    start = vertex(part, index)
    scene.frame_set(rig.OPEN)
    now = vertex(part, index)
    scene.frame_set(rig.CLOSED)
    must((vertex(part, index) - start).length < 1e-4, part.name + " does not come back")
    must((start - before).length < 1e-4, part.name + " has moved at rest")
    value = rig.open_end(kept)
    if rig.turns(part["dragmesh_type"].upper()):
        arm = lambda point: (point - origin) - (point - origin).dot(axis) * axis  # noqa: E731
        must(abs(arm(now).length - arm(start).length) < 1e-3, part.name + " does not turn about its axis")
        must(abs(arm(start).angle(arm(now)) - abs(value)) < 1e-2, part.name + " does not turn by its limit")
    else:
        must((now - start - value * axis).length < 1e-3, part.name + " does not slide by its limit")


def limited(part):
    """The motion stops at the limits."""
    kept = part.dragmesh
    kept.motion.animation_data_clear()
    path = "rotation_euler" if rig.turns(part["dragmesh_type"].upper()) else "location"
    getattr(kept.motion, path)[2] = kept.upper + 0.3
    bpy.context.view_layer.update()
    matrix = kept.rest.matrix_world.inverted() @ kept.motion.matrix_world
    value = matrix.to_euler().z if path == "rotation_euler" else matrix.translation.z
    must(math.isclose(value, kept.upper, abs_tol=1e-3), f"{part.name} is not limited: {value}, {kept.upper}")


def render(parts, path):
    """A picture of the opened asset with its joints."""
    scene = bpy.context.scene
    box = [thing.matrix_world @ Vector(corner) for thing in bpy.data.objects if thing.type == "MESH" for corner in thing.bound_box]
    low, high = (Vector([pick(point[k] for point in box) for k in range(3)]) for pick in (min, max))
    size, centre = (high - low).length, (low + high) / 2
    colours = [(0.55, 0.62, 0.5), (0.5, 0.58, 0.66), (0.72, 0.58, 0.4), (0.66, 0.45, 0.4)]
    for thing in bpy.data.objects:
        if thing.type not in ("MESH", "CURVE"):
            continue
        material = bpy.data.materials.new(thing.name)
        material.use_nodes = True
        shader = material.node_tree.nodes["Principled BSDF"]
        joint = thing.type == "CURVE"
        colour = (1, 0.35, 0.02) if joint else colours[parts.index(thing) % 4] if thing in parts else (0.75, 0.73, 0.68)
        shader.inputs["Base Color"].default_value = (*colour, 1)
        shader.inputs["Roughness"].default_value = 0.5
        if joint:
            shader.inputs["Emission"].default_value = (*colour, 1)
        thing.data.materials.clear()
        thing.data.materials.append(material)
    bpy.ops.mesh.primitive_plane_add(size=20 * size, location=(centre.x, centre.y, low.z))
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location = centre + Vector((0.95, -1.75, 0.85)) * size
    camera.rotation_euler = (centre - camera.location).to_track_quat("-Z", "Y").to_euler()
    lamp = bpy.data.objects.new("lamp", bpy.data.lights.new("lamp", "AREA"))
    lamp.data.energy, lamp.data.size = 22 * size * size, size
    lamp.location = centre + Vector((1.2, -1.0, 1.8)) * size
    lamp.rotation_euler = (centre - lamp.location).to_track_quat("-Z", "Y").to_euler()
    for thing in (camera, lamp):
        scene.collection.objects.link(thing)
    scene.camera = camera
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs[0].default_value = (0.3, 0.33, 0.36, 1)
    scene.render.engine, scene.cycles.samples, scene.cycles.device = "CYCLES", 48, "CPU"
    scene.cycles.use_denoising = False  # Debian builds without OpenImageDenoise
    scene.render.resolution_x, scene.render.resolution_y = 720, 480
    scene.render.filepath = path
    scene.view_settings.view_transform = "Standard"
    scene.frame_set(rig.OPEN * 2 // 3)
    bpy.ops.render.render(write_still=True)


def box(name, low, high):
    """A box as an object of its own."""
    bpy.ops.mesh.primitive_cube_add(size=1, location=[(a + b) / 2 for a, b in zip(low, high)])
    thing = bpy.context.active_object
    thing.name, thing.scale = name, [b - a for a, b in zip(low, high)]
    return thing


def whole_asset():
    """A cupboard of boards, a door and a knob: the door is one part with its knob, and the boards stay."""
    boards = [box(f"board{number}", low, high) for number, (low, high) in enumerate((
        ((-0.4, -0.23, 0), (-0.38, 0.25, 0.8)), ((0.38, -0.23, 0), (0.4, 0.25, 0.8)), ((-0.38, -0.23, 0), (0.38, 0.25, 0.02)),
        ((-0.38, -0.23, 0.78), (0.38, 0.25, 0.8)), ((-0.38, 0.23, 0.02), (0.38, 0.25, 0.78))))]
    door = box("door", (-0.4, -0.25, 0), (0.4, -0.232, 0.8))
    knob = box("knob", (0.32, -0.28, 0.36), (0.35, -0.25, 0.44))
    bpy.ops.object.select_all(action="DESELECT")
    bpy.context.view_layer.update()
    must(bpy.ops.dragmesh.rig() == {"FINISHED"}, "rig")
    moving = [thing for thing in bpy.data.objects if thing.type == "MESH" and len(thing.dragmesh.hypotheses) > 0]
    must(moving == [door], f"{[thing.name for thing in moving]} move")
    must(door.dragmesh.hypotheses[0].type == "REVOLUTE", "the door has no hinge")
    must(door.dragmesh.body in boards, "the body is no board")
    select([door], door)
    must(bpy.ops.dragmesh.apply() == {"FINISHED"}, "apply")
    apart = lambda: door.matrix_world.inverted() @ knob.matrix_world  # noqa: E731
    closed, seen, scene = apart(), knob.matrix_world.translation.copy(), bpy.context.scene
    must((seen - Vector((0.335, -0.265, 0.4))).length < 1e-4, "the knob has moved at rest")
    scene.frame_set(rig.OPEN)
    must(max(abs(a - b) for x, y in zip(apart(), closed) for a, b in zip(x, y)) < 1e-4, "the knob does not go with the door")
    must((knob.matrix_world.translation - seen).length > 0.3, "the door stays")
    scene.frame_set(rig.CLOSED)
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)


def main():
    whole_asset()
    bpy.ops.import_scene.gltf(filepath=source)
    meshes = [thing for thing in bpy.data.objects if thing.type == "MESH"]
    body = max(meshes, key=lambda thing: max(thing.dimensions))
    parts = sorted((thing for thing in meshes if thing != body), key=lambda thing: thing.name)
    select(parts, body)
    must(bpy.ops.dragmesh.infer() == {"FINISHED"}, "infer")
    for part in parts:
        must(len(part.dragmesh.hypotheses) > 0 and part.dragmesh.motion, part.name + " has no rig")
    far = {part: far_vertex(part) for part in parts}
    before = {part: vertex(part, far[part]) for part in parts}
    # The user takes another hypothesis, and comes back; then moves a joint and fixes a limit.
    first = parts[0]
    select([first], body)
    chosen = tuple(first.dragmesh.hypotheses[0].axis)
    for _ in range(len(first.dragmesh.hypotheses)):
        bpy.ops.dragmesh.next()
    must(first.dragmesh.chosen == 0 and tuple(first.dragmesh.hypotheses[0].axis) == chosen, "hypotheses do not go round")
    must((vertex(first, far[first]) - before[first]).length < 1e-4, "another hypothesis moves the part")
    first.dragmesh.rest.location.z += 0.01
    first.dragmesh.upper *= 0.5
    fixed = first.dragmesh.upper
    bpy.context.view_layer.update()
    select(parts, body)
    must(bpy.ops.dragmesh.apply() == {"FINISHED"}, "apply")
    must(math.isclose(first["dragmesh_upper"], fixed), "the user's limit is lost")
    for part in parts:
        must((part.matrix_world.translation - part.dragmesh.rest.matrix_world.translation).length < 1e-4, part.name + "'s origin")
        check_motion(part, far[part], before[part])
    path = os.path.join(out, "openable.glb")
    select(parts, body)
    must(bpy.ops.dragmesh.export(filepath=path) == {"FINISHED"}, "export")
    with open(path, "rb") as file:
        data = file.read()
    document = json.loads(data[20:20 + int.from_bytes(data[12:16], "little")])
    must(document.get("animations"), "the file has no animation")
    extras = [node["extras"]["dragmesh_type"] for node in document["nodes"] if "dragmesh_type" in node.get("extras", {})]
    must(len(extras) == len(parts), "the file has not all extras")
    with dragmesh.Context(axes=dragmesh.Axes.BLENDER) as context, open(os.path.join(out, "openable.dmo"), "rb") as file:
        joint = context.load_object(file.read()).joint(parts.index(first) + 1)
        must(joint.source == dragmesh.JointSource.HOST and math.isclose(joint.upper, fixed, rel_tol=1e-5), "the .dmo's joint")
        file.seek(0)
        with dragmesh.Context() as host:  # a game's own axes: z up has become y up
            axis = host.load_object(file.read()).joint(parts.index(first) + 1).axis
        must(abs(axis.y - joint.axis.z) < 1e-5 and abs(axis.z + joint.axis.y) < 1e-5, "the .dmo's axes")
    if picture:
        render(parts, picture)
    for part in parts:
        if part["dragmesh_type"] != "continuous":
            limited(part)
    bpy.ops.preferences.addon_disable(module="dragmesh_openable")
    must(not hasattr(bpy.types.Object, "dragmesh"), "the add-on stays")
    print(f"Blender {bpy.app.version_string}: {len(parts)} parts made openable: " +
          ", ".join(f"{part.name} {part['dragmesh_type']}" for part in parts))


try:
    main()
except BaseException:
    import traceback
    traceback.print_exc()
    os._exit(1)  # blender itself ends with 0
