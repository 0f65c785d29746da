"""glTF binaries with one mesh a node, all nodes at identity: what object.glb is."""
import json
import struct
from pathlib import Path

import numpy as np

MAGIC, JSON, BIN = 0x46546C67, 0x4E4F534A, 0x004E4942
FLOAT, UINT32, ARRAY, ELEMENTS = 5126, 5125, 34962, 34963
TYPES = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}


def encode(parts):
    """The bytes of a file. parts: {node name: (positions (V, 3), triangles (F, 3))}."""
    tree = {"asset": {"version": "2.0", "generator": "dragmesh"}, "scene": 0,
            "scenes": [{"nodes": list(range(len(parts)))}], "nodes": [], "meshes": [], "accessors": [],
            "bufferViews": [], "buffers": []}
    data = bytearray()
    for number, (name, (positions, faces)) in enumerate(parts.items()):
        positions, faces = np.asarray(positions, np.float32), np.asarray(faces, np.uint32)
        for array, target in ((positions, ARRAY), (faces, ELEMENTS)):
            tree["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": array.nbytes, "target": target})
            data += array.tobytes()
        tree["accessors"] += [
            {"bufferView": 2 * number, "componentType": FLOAT, "type": "VEC3", "count": len(positions),
             "min": positions.min(0).tolist(), "max": positions.max(0).tolist()},
            {"bufferView": 2 * number + 1, "componentType": UINT32, "type": "SCALAR", "count": faces.size}]
        tree["meshes"].append({"primitives": [{"attributes": {"POSITION": 2 * number}, "indices": 2 * number + 1}]})
        tree["nodes"].append({"name": name, "mesh": number})
    tree["buffers"].append({"byteLength": len(data)})
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    body = struct.pack("<II", len(text), JSON) + text + struct.pack("<II", len(data), BIN) + bytes(data)
    return struct.pack("<III", MAGIC, 2, 12 + len(body)) + body


def chunks(data):
    at = 12
    while at + 8 <= len(data):
        size, kind = struct.unpack_from("<II", data, at)
        yield kind, data[at + 8:at + 8 + size]
        at += 8 + size


def read(path):
    """{node name: (positions float64, triangles)} of a file whose nodes are all at identity."""
    data = Path(path).read_bytes()
    if len(data) < 12 or struct.unpack_from("<I", data)[0] != MAGIC:
        raise ValueError(f"{path}: no glTF binary")
    found = dict(chunks(data))
    tree, blob = json.loads(found[JSON]), found.get(BIN, b"")
    moved = [node.get("name") for node in tree["nodes"] if {"matrix", "translation", "rotation", "scale"} & set(node)]
    if moved:
        raise ValueError(f"{path}: node '{moved[0]}' is not at identity")

    def array(index, width):
        accessor = tree["accessors"][index]
        view, dtype = tree["bufferViews"][accessor["bufferView"]], np.dtype(TYPES[accessor["componentType"]])
        stride = view.get("byteStride", dtype.itemsize * width)
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        return np.ndarray((accessor["count"], width), dtype, blob, start, (stride, dtype.itemsize))

    parts = {}
    for node in tree["nodes"]:
        positions, faces, first = [], [], 0
        for primitive in tree["meshes"][node["mesh"]]["primitives"] if "mesh" in node else []:
            points = array(primitive["attributes"]["POSITION"], 3).astype(np.float64)
            corners = array(primitive["indices"], 1) if "indices" in primitive else np.arange(len(points))
            positions.append(points)
            faces.append(corners.reshape(-1, 3).astype(np.int64) + first)
            first += len(points)
        if positions:
            parts[node["name"]] = np.concatenate(positions), np.concatenate(faces)
    return parts
