"""blender -b --python draw_blender.py -- RIGGED.glb OUT.png — imports a rigged GLB by Blender's own importer and draws it in the
middle of its clip, when all parts are open. scripts/pictures calls it."""
import sys

import bpy
import numpy
from mathutils import Vector

OPEN_AT, SAMPLES, SIZE = 2.0, 64, (400, 320)  # s; rays a pixel; pixels


def add(name, data, place, target):
    thing = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(thing)
    thing.location = place
    thing.rotation_euler = (target - thing.location).to_track_quat("-Z", "Y").to_euler()
    return thing


def main():
    source, out = sys.argv[-2:]
    numpy.bool = bool  # Blender 3.4's importer asks for it, and numpy has it no more
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=source)
    scene = bpy.context.scene
    scene.frame_set(round(OPEN_AT * scene.render.fps))
    corners = [thing.matrix_world @ Vector(corner) for thing in scene.objects if thing.type == "MESH" for corner in thing.bound_box]
    low, high = [Vector([pick(corner[k] for corner in corners) for k in range(3)]) for pick in (min, max)]
    middle, size = (low + high) / 2, (high - low).length
    scene.camera = add("camera", bpy.data.cameras.new("camera"), middle + size * Vector((0.8, -1.2, 0.5)), middle)
    sun = bpy.data.lights.new("sun", "SUN")
    sun.energy = 3
    add("sun", sun, middle + Vector((1, -1, 3)), middle)
    scene.world = bpy.data.worlds.new("world")
    scene.world.color = (0.6, 0.6, 0.6)
    scene.render.engine, scene.cycles.samples, scene.cycles.use_denoising = "CYCLES", SAMPLES, False
    scene.render.resolution_x, scene.render.resolution_y = SIZE
    scene.render.filepath = out
    bpy.ops.render.render(write_still=True)


main()
