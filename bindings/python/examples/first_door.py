"""Finds the joints of a glTF file, pulls its first part open with a pointer, and lets it swing: FILE.glb"""
import sys

import dragmesh

with dragmesh.Context() as context, dragmesh.Gltf(sys.argv[1]) as gltf:
    thing = dragmesh.prepare_gltf(context, gltf, context.load_shipped_model())
    part = thing.parts()[0]
    x, y, z = part.centre
    drag = thing.drag(part.id, (x, y, z), rules={})  # at a hit's object_point
    for frame in range(60):  # every frame, with the pointer's ray in the object's frame
        state = drag.update((x, y, z + 2), (-0.003 * frame, 0, -2), 1 / 60)
    drag.release(dragmesh.Go.OPEN)
    while state.phase != dragmesh.Phase.AT_REST:
        state = drag.advance(1 / 60)
    kept = drag.end()  # joint, value and pose: what the instance saves
    print(f"part {part.id} stands open at {kept.value:.2f}")
