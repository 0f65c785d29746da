"""odd_asset.py OUT.glb [chest] — writes an asset with what exporters break on: names that formats must not see, a joint of every kind, a
nested chain, a screw, a slide without limits, a fixed part, twins, a mirrored node, a sheet of two triangles, a single one, a mesh inside out, a
triangle without area, and nodes that are turned and scaled. Its joints are stated in `extras`. chest: the box with a lid of
docs/exports.md instead."""
import json
import math
import struct
import sys

import numpy as np

CUBE = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], np.float32)
SIDES = np.array([(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4),
                  (1, 5, 7), (1, 7, 3)], np.uint32)
NAMES = ['"><link name="x"/><!--', "Tür & <Öffnung>", "../../etc/passwd", "CON", "", "Дверь", "a\u0001b\n\"c\\", "x" * 300, "world",
         "9lives", "part_1_x", "body"]


def joint(kind, axis, origin, lower=0.0, upper=0.0, **more):
    return {"dragmesh_joint": {"type": kind, "axis": axis, "origin": origin, "lower": lower, "upper": upper, **more}}


def main():
    data, views, accessors, meshes = b"", [], [], []

    def add(array, kind, component, target):
        nonlocal data
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": array.nbytes, "target": target})
        accessor = {"bufferView": len(views) - 1, "componentType": component, "count": len(array), "type": kind}
        if kind == "VEC3":
            accessor |= {"min": array.min(axis=0).tolist(), "max": array.max(axis=0).tolist()}
        accessors.append(accessor)
        data += array.tobytes()
        return len(accessors) - 1

    def mesh(points, faces):
        position = add(np.asarray(points, np.float32), "VEC3", 5126, 34962)
        meshes.append({"primitives": [{"attributes": {"POSITION": position},
                                       "indices": add(np.asarray(faces, np.uint32).reshape(-1), "SCALAR", 5125, 34963)}]})
        return len(meshes) - 1

    cube, inside_out = mesh(CUBE, SIDES), mesh(CUBE, SIDES[:, ::-1])
    sheet = mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3), (0, 0, 1)])
    lid, triangle = mesh(CUBE, SIDES[:-2]), mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
    eighth = math.sin(math.pi / 8), math.cos(math.pi / 8)
    nodes = [
        {"name": "frame", "mesh": cube, "scale": [2, 2, 0.1], "children": list(range(1, 12))},
        {"name": NAMES[0], "mesh": cube, "translation": [0, 0, 1.5], "extras": joint("revolute", [0, 1, 0], [0, 0, 0], 0, 1.5)},
        {"name": NAMES[1], "mesh": sheet, "translation": [0, 1, 2], "extras": joint("prismatic", [0, 0, 1], [0, 0, 0], 0, 0.5)},
        {"name": NAMES[2], "mesh": lid, "translation": [1, 1, 2], "extras": joint("screw", [0, 0, 1], [0.5, 0.5, 0], -1, 3, pitch=0.05)},
        {"name": NAMES[3], "mesh": inside_out, "translation": [1, 0, 2], "extras": joint("continuous", [1, 1, 0], [0.5, 0.5, 0.5])},
        {"name": NAMES[4], "mesh": cube, "translation": [-1, 0, 2], "extras": joint("prismatic", [1, 0, 0], [0, 0, 0])},
        {"name": NAMES[5], "mesh": cube, "translation": [-1, 1, 2], "scale": [-0.5, 0.5, 0.5],
         "extras": joint("revolute", [0, 0, 1], [0, 0, 0], -0.5, 0.5), "children": [12]},
        {"name": NAMES[6], "mesh": sheet, "translation": [0, -1, 2], "rotation": [eighth[0], 0, 0, eighth[1]],
         "extras": joint("revolute", [1, 0, 0], [0, 0, 0], 0, 2)},
        {"name": NAMES[7], "mesh": cube, "translation": [0.2, -1, 2], "extras": joint("fixed", [1, 0, 0], [0, 0, 0])},
        {"name": NAMES[8], "mesh": cube, "translation": [3, 0, 2], "extras": joint("revolute", [-1, 0, 0], [0, 0, 0], 0, 1)},
        {"name": NAMES[9], "mesh": cube, "translation": [4.5, 0, 2], "extras": joint("revolute", [0, -1, 0], [0, 0, 0], -1, 0)},
        {"name": NAMES[10], "mesh": cube, "translation": [6, 0, 2], "extras": joint("revolute", [0, 0, -1], [0, 0, 0], -2, 1)},
        {"name": NAMES[11], "mesh": lid, "translation": [0, 2, 0], "extras": joint("prismatic", [0, 1, 0], [0, 0, 0], -0.2, 0.4),
         "children": [13]},
        {"name": "handle", "mesh": triangle, "translation": [0, 1, 1], "extras": joint("revolute", [1, 0, 0], [0, 0, 0], 0, 1)},
    ]
    if sys.argv[2:] == ["chest"]:
        nodes = [{"name": "chest", "mesh": lid, "scale": [0.6, 0.3, 0.4], "children": [1]},
                 {"name": "lid", "mesh": cube, "translation": [0, 1, 0], "scale": [1, 0.1, 1],
                  "extras": joint("revolute", [-1, 0, 0], [0, 0, 0], 0, 1.5)}]
    document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": nodes, "meshes": meshes,
                "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": len(data)}]}
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    data += b"\0" * (-len(data) % 4)
    with open(sys.argv[1], "wb") as file:
        file.write(struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(data), len(text), 0x4E4F534A) + text)
        file.write(struct.pack("<II", len(data), 0x004E4942) + data)


if __name__ == "__main__":
    main()
