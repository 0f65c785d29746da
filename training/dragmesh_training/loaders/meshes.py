"""Triangles from the mesh files and primitives that URDF files refer to: OBJ, STL, boxes, cylinders, spheres."""
import struct
from pathlib import Path

import numpy as np


class MeshError(ValueError):
    """A mesh that can't be read; the message says which and why."""


def read_obj(path):
    """Positions (V, 3) and triangles (F, 3); polygons are cut into fans. Everything but v and f is left out."""
    vertices, faces = [], []
    for number, line in enumerate(Path(path).read_text(errors="replace").splitlines(), 1):
        words = line.split()
        if not words:
            continue
        try:
            if words[0] == "v":
                x, y, z = (float(word) for word in words[1:4])
                vertices.append([x, y, z])
            elif words[0] == "f":
                corners = [int(word.split("/")[0]) for word in words[1:]]
                corners = [c - 1 if c > 0 else len(vertices) + c for c in corners]
                faces += [[corners[0], corners[i], corners[i + 1]] for i in range(1, len(corners) - 1)]
        except ValueError as error:
            raise MeshError(f"{path}: line {number}: {error}") from error
    return checked(path, np.array(vertices, float).reshape(-1, 3), np.array(faces, np.int64).reshape(-1, 3))


def read_stl(path):
    """Binary or text; equal vertices are made one."""
    data = Path(path).read_bytes()
    count = struct.unpack_from("<I", data, 80)[0] if len(data) >= 84 else -1
    if len(data) == 84 + 50 * count:
        record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
        corners = np.frombuffer(data, record, count, 84)["corners"].reshape(-1, 3).astype(float)
    else:
        words = [line.split() for line in data.decode(errors="replace").splitlines()]
        try:
            corners = np.array([[float(w) for w in line[1:4]] for line in words if line[:1] == ["vertex"]], float)
        except ValueError as error:
            raise MeshError(f"{path}: {error}") from error
        corners = corners.reshape(-1, 3)
    if len(corners) % 3:
        raise MeshError(f"{path}: {len(corners)} corners are no triangles")
    positions, index = np.unique(corners, axis=0, return_inverse=True)
    return checked(path, positions, index.reshape(-1, 3))


def checked(path, positions, faces):
    if len(faces) == 0:
        raise MeshError(f"{path}: no triangles")
    if not np.isfinite(positions).all():
        raise MeshError(f"{path}: a coordinate is no number")
    if faces.min() < 0 or faces.max() >= len(positions):
        raise MeshError(f"{path}: a face names a vertex that is not there")
    return positions, faces


def read(path):
    readers = {".obj": read_obj, ".stl": read_stl}
    suffix = Path(path).suffix.lower()
    if suffix not in readers:
        raise MeshError(f"{path}: '{suffix}' is not read, only {', '.join(sorted(readers))}")
    if not Path(path).is_file():
        raise MeshError(f"{path}: there is no such file")
    return readers[suffix](path)


def box(size):
    corners = np.array([[x, y, z] for z in (-0.5, 0.5) for y in (-0.5, 0.5) for x in (-0.5, 0.5)]) * np.asarray(size)
    quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    return corners, np.array([[q[0], q[i], q[i + 1]] for q in quads for i in (1, 2)])


def cylinder(radius, length, sides=32):
    """About z, as in URDF."""
    turn = 2 * np.pi * np.arange(sides) / sides
    ring = np.stack([radius * np.cos(turn), radius * np.sin(turn)], 1)
    low, high = (np.column_stack([ring, np.full(sides, z)]) for z in (-length / 2, length / 2))
    ends = np.array([[0, 0, -length / 2], [0, 0, length / 2]])
    i = np.arange(sides)
    k = (i + 1) % sides
    faces = [np.stack([i, k, sides + k], 1), np.stack([i, sides + k, sides + i], 1),
             np.stack([k, i, np.full(sides, 2 * sides)], 1), np.stack([sides + i, sides + k, np.full(sides, 2 * sides + 1)], 1)]
    return np.concatenate([low, high, ends]), np.concatenate(faces)


def sphere(radius, rings=12, sides=24):
    rows = np.pi * np.arange(1, rings) / rings
    turn = 2 * np.pi * np.arange(sides) / sides
    grid = np.stack([np.outer(np.sin(rows), np.cos(turn)), np.outer(np.sin(rows), np.sin(turn)),
                     np.outer(np.cos(rows), np.ones(sides))], -1).reshape(-1, 3)
    positions = radius * np.concatenate([grid, [[0, 0, 1], [0, 0, -1]]])
    top, bottom, faces = len(grid), len(grid) + 1, []
    for i in range(sides):
        k = (i + 1) % sides
        faces += [[top, i, k], [bottom, (rings - 2) * sides + k, (rings - 2) * sides + i]]
        for r in range(rings - 2):
            a, b = r * sides, (r + 1) * sides
            faces += [[a + i, b + i, b + k], [a + i, b + k, a + k]]
    return positions, np.array(faces)
