"""URDF folders, as GAPartNet and PartNet-Mobility ship them, to object.glb + joints.json.

One node a link, in the frame of the URDF's root with all joints at 0. semantics.txt (PartNet-Mobility: link, kind of
joint, name of the part) and meta.json (model_cat) are read where they are.
"""
import json
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np

from ..files import write_together
from . import glb, meshes

KINDS = {"revolute": "revolute", "continuous": "revolute", "prismatic": "prismatic"}
DRAGS, DRAG_LENGTH, LEAST_ARM = 3, 0.1, 0.3  # of the size; of the part's largest distance to the axis


class UrdfError(ValueError):
    """A file that is no URDF tree; the message says what is wrong."""


def numbers(element, name, default):
    text = element.get(name) if element is not None else None
    return np.array([float(word) for word in text.split()]) if text else np.array(default, float)


def rotation(roll, pitch, yaw):
    """Fixed axes x, y, z, as URDF has it."""
    (a, b, c), (d, e, f) = np.cos([roll, pitch, yaw]), np.sin([roll, pitch, yaw])
    return np.array([[c * b, c * e * d - f * a, c * e * a + f * d],
                     [f * b, f * e * d + c * a, f * e * a - c * d],
                     [-e, b * d, b * a]])


def origin_of(element):
    """4 x 4, of an element's <origin>."""
    origin = element.find("origin")
    out = np.eye(4)
    out[:3, :3] = rotation(*numbers(origin, "rpy", (0, 0, 0)))
    out[:3, 3] = numbers(origin, "xyz", (0, 0, 0))
    return out


def geometry(folder, visual):
    shape = visual.find("geometry")
    shape = shape[0] if shape is not None and len(shape) else None
    if shape is None:
        return None
    if shape.tag == "mesh":
        name = shape.get("filename", "").split("://")[-1]
        positions, faces = meshes.read(folder / name)
        return positions * numbers(shape, "scale", (1, 1, 1)), faces
    if shape.tag == "box":
        return meshes.box(numbers(shape, "size", (1, 1, 1)))
    if shape.tag == "cylinder":
        return meshes.cylinder(float(shape.get("radius")), float(shape.get("length")))
    if shape.tag == "sphere":
        return meshes.sphere(float(shape.get("radius")))
    raise UrdfError(f"geometry '{shape.tag}' is not known")


def link_mesh(folder, link, pose):
    """All visuals of a link in the root's frame; None without any."""
    positions, faces, first = [], [], 0
    for visual in link.findall("visual"):
        shape = geometry(folder, visual)
        if shape is None:
            continue
        at = pose @ origin_of(visual)
        positions.append(shape[0] @ at[:3, :3].T + at[:3, 3])
        faces.append(shape[1] + first)
        first += len(shape[0])
    return (np.concatenate(positions), np.concatenate(faces)) if positions else None


def link_poses(root, joints):
    """Of every link, joints at 0. Errors name links that hang in a circle, or nowhere."""
    links = [link.get("name") for link in root.findall("link")]
    parent = {joint.find("child").get("link"): joint for joint in joints}
    roots = [name for name in links if name not in parent]
    if len(roots) != 1:
        raise UrdfError(f"{len(roots)} links have no parent, not one")
    poses, waiting = {roots[0]: np.eye(4)}, [name for name in links if name in parent]
    while waiting:
        ready = [name for name in waiting if parent[name].find("parent").get("link") in poses]
        if not ready:
            raise UrdfError(f"links hang on nothing or in a circle: {', '.join(waiting[:3])}")
        for name in ready:
            poses[name] = poses[parent[name].find("parent").get("link")] @ origin_of(parent[name])
        waiting = [name for name in waiting if name not in poses]
    return poses


def links_below(joints, link):
    below = [link]
    for name in below:
        below += [joint.find("child").get("link") for joint in joints if joint.find("parent").get("link") == name]
    return below


def limits(joint):
    """lower, upper; None where there are none, or placeholders."""
    found = joint.find("limit")
    if joint.get("type") == "continuous" or found is None:
        return None, None
    lower, upper = float(found.get("lower", 0)), float(found.get("upper", 0))
    return (lower, upper) if upper > lower and upper - lower < 1e3 else (None, None)


def rest_at(lower, upper):
    if lower is None:
        return "unknown"
    near = 0.07 * (upper - lower)
    if lower - near > 0 or upper + near < 0:
        return "outside"
    return "lower" if abs(lower) <= near else "upper" if abs(upper) <= near else "inside"


def surface_points(mesh, count, random):
    positions, faces = mesh
    corners = positions[faces]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    chosen = corners[random.choice(len(faces), count, p=area / area.sum())]
    root, share = np.sqrt(random.random(count))[:, None], random.random(count)[:, None]
    return chosen[:, 0] * (1 - root) + chosen[:, 1] * root * (1 - share) + chosen[:, 2] * root * share


def make_drags(moving, kind, axis, origin, sign, size, random):
    """Points on the part, far enough from a hinge, and the directions in which they start to move."""
    points = surface_points(moving, 64, random)
    way = np.tile(axis, (len(points), 1)) if kind == "prismatic" else np.cross(axis, points - origin)
    arm = np.linalg.norm(way, axis=1)
    good = np.flatnonzero(arm >= LEAST_ARM * arm.max())[:DRAGS]
    return [{"point": points[i].tolist(), "vector": (sign * DRAG_LENGTH * size * way[i] / arm[i]).tolist()} for i in good]


def describe_joint(joint, joints, parts, poses, names, size, random):
    """The joint's entry in joints.json; None when nothing moves by it or nothing stays."""
    child, kind = joint.find("child").get("link"), KINDS[joint.get("type")]
    moving = [name for name in links_below(joints, child) if name in parts]
    if not moving or len(moving) == len(parts):
        return None
    axis = poses[child][:3, :3] @ numbers(joint.find("axis"), "xyz", (1, 0, 0))
    if not np.linalg.norm(axis) > 0:
        raise UrdfError(f"joint '{joint.get('name')}' has no axis")
    axis, origin = axis / np.linalg.norm(axis), poses[child][:3, 3]
    lower, upper = limits(joint)
    sign = -1 if lower is not None and abs(upper) <= 0.1 * (upper - lower) else 1
    first = np.cumsum([0] + [len(parts[name][0]) for name in moving])
    mesh = (np.concatenate([parts[name][0] for name in moving]),
            np.concatenate([parts[name][1] + at for name, at in zip(moving, first)]))
    entry = {"name": joint.get("name"), "part": names.get(child, child), "type": kind,
             "parent": joint.find("parent").get("link"), "child": child, "moving_nodes": moving,
             "axis": axis.tolist(), "origin": origin.tolist(), "lower": lower, "upper": upper,
             "rest_at": rest_at(lower, upper), "weight": 1.0, "drag_sign": sign,
             "drags": make_drags(mesh, kind, axis, origin, sign, size, random)}
    if joint.get("type") == "continuous":
        entry["continuous"] = True
    return entry


def read_names(folder):
    """Link -> name of its part, of PartNet-Mobility's semantics.txt."""
    path = folder / "semantics.txt"
    lines = [line.split() for line in path.read_text().splitlines()] if path.is_file() else []
    return {words[0]: words[-1] for words in lines if len(words) >= 2}


def read_category(folder):
    path = folder / "meta.json"
    return json.loads(path.read_text()).get("model_cat") if path.is_file() else None


def find_urdf(path):
    """The file itself, or the one in a folder; GAPartNet's annotation is preferred over the plain one."""
    path = Path(path)
    if path.is_file():
        return path
    found = sorted(path.glob("*.urdf"), key=lambda p: ("gapartnet" not in p.name, p.name))
    if not found:
        raise UrdfError(f"{path}: no .urdf file")
    return found[0]


def convert(path, out, category=None, up="z", seed=1):
    """Writes out/object.glb and out/joints.json; answers the number of joints."""
    path, out = find_urdf(path), Path(out)
    try:
        root = ElementTree.parse(path).getroot()
    except ElementTree.ParseError as error:
        raise UrdfError(f"{path}: {error}") from error
    joints = [j for j in root.findall("joint") if j.find("parent") is not None and j.find("child") is not None]
    poses, folder = link_poses(root, joints), path.parent
    parts = {link.get("name"): link_mesh(folder, link, poses[link.get("name")]) for link in root.findall("link")}
    parts = {name: mesh for name, mesh in parts.items() if mesh is not None}
    if not parts:
        raise UrdfError(f"{path}: no link has anything to see")
    points = np.concatenate([mesh[0] for mesh in parts.values()])
    size, names, random = float(np.ptp(points, axis=0).max()), read_names(folder), np.random.default_rng(seed)
    entries = [describe_joint(joint, joints, parts, poses, names, size, random)
               for joint in joints if joint.get("type") in KINDS]
    entries = [entry for entry in entries if entry is not None]
    if not entries:
        raise UrdfError(f"{path}: no joint moves one part against another")
    out.mkdir(parents=True, exist_ok=True)
    description = {"object": folder.name, "source": "urdf", "path": path.name, "license": "as its source states",
                   "category": category or read_category(folder) or root.get("name") or "?", "family": folder.name,
                   "up": up, "units": "m", "largest_dimension": size, "joints": entries}
    write_together({str(out / "object.glb"): glb.encode(parts),
                    str(out / "joints.json"): json.dumps(description, indent=1).encode()})
    return len(entries)
