"""blender -b --factory-startup --python first_door.py -- ADDON.zip FILE.glb OUT.glb: makes what moves in a file openable"""
import os
import sys

import bpy
import numpy

if "bool" not in vars(numpy):
    numpy.bool = bool  # Debian 12's glTF importer is older than its numpy

addon, source, target = map(os.path.abspath, sys.argv[-3:])
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.preferences.addon_install(filepath=addon)
bpy.ops.preferences.addon_enable(module="dragmesh_openable")
bpy.ops.import_scene.gltf(filepath=source)

bpy.ops.object.select_all(action="DESELECT")
bpy.ops.dragmesh.rig()  # which objects move, and which of them as one: without a selection, of all
parts = [thing for thing in bpy.data.objects if thing.type == "MESH" and thing.dragmesh.hypotheses]
for part in parts:
    part.select_set(True)
bpy.ops.dragmesh.apply()  # pivots, limits, keys of the opening at the frames 1 and 60, custom properties

bpy.context.scene.frame_set(60)
for part in parts:
    joint = part["dragmesh_type"], part["dragmesh_lower"], part["dragmesh_upper"]
    print(f"{part.name}: {joint[0]} from {joint[1]:.2f} to {joint[2]:.2f}; its pivot is at {tuple(part['dragmesh_origin'])}")
bpy.ops.dragmesh.export(filepath=target)  # the .glb with the animation, and a .dmo for the game beside it
