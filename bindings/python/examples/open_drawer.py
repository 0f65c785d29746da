"""Prepares a glTF file, pulls its first part open, and writes the opening as an animated .glb: FILE.glb OUT.glb"""
import sys

import numpy as np

import dragmesh

source, target = sys.argv[1:]
with dragmesh.Context() as context, dragmesh.Gltf(source) as gltf:
    asset = dragmesh.rig_gltf(context, gltf, context.load_shipped_model())  # which nodes move, and which of them as one
    thing = asset.make_object()
    part = thing.parts()[0]
    centre = np.array(list(part.centre))
    drag = thing.drag(part.id, centre, rules={})  # at a hit's object_point
    pull = np.array(list(thing.joint(part.id).axis)) * 0.3
    eye = centre + [1.0, 1.0, 2.0]
    poses, times, events = [], [], dragmesh.Event(0)
    for frame in range(60):  # every frame, with the pointer's ray in the object's frame
        state = drag.update(eye, centre + pull * frame / 60 - eye, 1 / 60)
        events |= dragmesh.Event(state.events)
        poses.append(state.pose)
        times.append(frame / 60)
    kept = drag.end()  # what the instance saves
    faces = np.zeros(gltf.face_count(), np.uint8)
    gltf.mark_faces([f"#{gltf.asset_nodes()[node][1]}" for node in asset.part_nodes(part.id - 1)], 1, faces)
    dragmesh.write_whole(target, gltf.export([{"face_ids": faces, "value": 1, "poses": poses, "times": times}]))
    print(f"{dragmesh.JointType(kept.joint.type).name} at {kept.value:.2f}, {events!r}")
