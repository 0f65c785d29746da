"""check_text.py FOLDER… — reads rigged.usda, rigged.tscn and rigged.glb of each folder back by readers of its own, and compares
bodies, masses, joints, limits, boxes and where meshes are with rigged.urdf, which check_mujoco compares with the answer. USD and
Godot have no loader in Debian, and no loader tells what it made of a glTF extension; so this is a check of what the files say,
not of what a consumer does with them. Prints a line a folder, and exits with 1 where one differs by more than 1e-4 of the size."""
import json
import math
import pathlib
import re
import struct
import sys
import xml.etree.ElementTree as ElementTree

import numpy as np

TOLERANCE = 1e-4


def numbers(text):
    return np.array([float(word) for word in re.split(r"[,\s]+", text.strip())])


def turned(q, v):
    """A vector turned by a quaternion x, y, z, w."""
    q, v = np.asarray(q, float), np.asarray(v, float)
    return v + 2 * np.cross(q[:3], np.cross(q[:3], v) + q[3] * v)


def z_up(v):
    return np.array([v[0], -v[2], v[1]])


class Body:
    """In the asset's frame, Z up, m."""

    def __init__(self):
        self.origin = np.zeros(3)
        self.mass = self.centre = self.inertia = self.joint = None
        self.meshes, self.boxes = [], []  # places; centres with sides


def joint_of(parent, kind, axis, origin, limits):
    return {"parent": parent, "kind": kind, "axis": np.asarray(axis, float), "origin": np.asarray(origin, float),
            "limits": limits}


def read_urdf(folder):
    root = ElementTree.parse(folder / "rigged.urdf").getroot()
    bodies = {}
    for link in root.findall("link"):
        body = bodies[link.get("name")] = Body()
        body.mass = float(link.find("inertial/mass").get("value"))
        body.centre = numbers(link.find("inertial/origin").get("xyz"))
        row = {key: float(value) for key, value in link.find("inertial/inertia").attrib.items()}
        body.inertia = np.array([[row["i" + "".join(sorted(a + b))] for b in "xyz"] for a in "xyz"])
        body.meshes = [numbers(item.find("origin").get("xyz")) for item in link.findall("visual")]
        body.boxes = [np.concatenate([numbers(item.find("origin").get("xyz")), numbers(item.find("geometry/box").get("size"))])
                      for item in link.findall("collision")]
    for joint in root.findall("joint"):
        parent, name = joint.find("parent").get("link"), joint.find("child").get("link")
        bodies[name].origin = bodies[parent].origin + numbers(joint.find("origin").get("xyz"))
        kind, limit = joint.get("type"), joint.find("limit")
        limits = None if limit.get("lower") is None else (float(limit.get("lower")), float(limit.get("upper")))
        bodies[name].joint = joint_of(parent, "slide" if kind == "prismatic" else "hinge", numbers(joint.find("axis").get("xyz")),
                                      bodies[name].origin, limits)
    for body in bodies.values():
        body.centre = body.centre + body.origin
        body.meshes = [place + body.origin for place in body.meshes]
        body.boxes = [np.concatenate([box[:3] + body.origin, box[3:]]) for box in body.boxes]
    return bodies


# ---- USD ----

def read_prims(text):
    """Prims as (type, name, [children], {property: text}), without what is between the parentheses of their heads."""
    root, stack, at = ("", "", [], {}), [], 0
    stack.append(root)
    pattern = re.compile(r'\s*(?:(?:def|class|over)\s+(?:(\w+)\s+)?"([^"]*)"|([\w:]+(?:\[\])?)\s+([\w:]+)\s*=\s*|(\})|(rel|uniform)\s+)')
    while found := pattern.match(text, at):
        at = found.end()
        if found.group(5):
            stack.pop()
        elif found.group(2) is not None:
            prim = (found.group(1) or "", found.group(2), [], {})
            stack[-1][2].append(prim)
            stack.append(prim)
            head = re.compile(r'\s*(\((?:[^()"]|"(?:\\.|[^"\\])*")*\))?\s*\{').match(text, at)
            prim[3]["head"] = head.group(1) or ""
            at = head.end()
        elif found.group(4):
            end = text.index("\n", at)
            stack[-1][3][found.group(4)] = text[at:end]
            at = end
        if stack[-1] is root and not text[at:].strip():
            break
        if found.group(6):  # `rel name =` has no type
            named = re.compile(r"([\w:]+)\s+([\w:]+)?\s*=\s*").match(text, at)
            if found.group(6) == "rel":
                named = re.compile(r"([\w:]+)\s*=\s*").match(text, at)
                end = text.index("\n", at)
                stack[-1][3][named.group(1)] = text[named.end():end]
                at = end
    return root


def usd_numbers(text):
    return numbers(text.strip("()"))


def usd_turn(text):
    w, x, y, z = usd_numbers(text)
    return np.array([x, y, z, w])


def read_usda(folder):
    text = (folder / "rigged.usda").read_text()
    header, rest = re.match(r'#usda 1\.0\n(\((?:[^()"]|"[^"]*")*\))(.*)', text, re.S).groups()
    assert 'upAxis = "Z"' in header and "metersPerUnit = 1\n" in header
    top = read_prims(rest)[2]
    assert len(top) == 1 and f'defaultPrim = "{top[0][1]}"' in header
    children = {prim[1]: prim for prim in top[0][2]}
    meshes = {prim[1]: prim for prim in children["Meshes"][2]}
    bodies = {}
    for kind, name, below, values in top[0][2]:
        if kind != "Xform":
            continue
        body = bodies[name] = Body()
        body.origin = usd_numbers(values["xformOp:translate"])
        body.mass = float(values["physics:mass"])
        body.centre = body.origin + usd_numbers(values["physics:centerOfMass"])
        axes = np.array([turned(usd_turn(values["physics:principalAxes"]), axis) for axis in np.eye(3)]).T
        body.inertia = axes @ np.diag(usd_numbers(values["physics:diagonalInertia"])) @ axes.T
        for part, _, _, own in below:
            place = body.origin + usd_numbers(own["xformOp:translate"])
            if part == "Mesh":
                assert re.search(r"references = </[^/]+/Meshes/(\w+)>", own["head"]).group(1) in meshes
                body.meshes.append(place)
            else:
                body.boxes.append(np.concatenate([place, 2 * usd_numbers(own["xformOp:scale"])]))
    for kind, _, _, values in top[0][2]:
        if not kind.startswith("Physics") or "physics:body0" not in values:
            continue
        parent, name = [values[f"physics:body{side}"].strip("<>").rsplit("/", 1)[1] for side in "01"]
        places = [bodies[body].origin + usd_numbers(values[f"physics:localPos{side}"]) for side, body in zip("01", (parent, name))]
        assert np.allclose(*places, atol=1e-6)
        slides, unit = kind == "PhysicsPrismaticJoint", 1 if kind == "PhysicsPrismaticJoint" else math.pi / 180
        limits = (None if "physics:lowerLimit" not in values else
                  (unit * float(values["physics:lowerLimit"]), unit * float(values["physics:upperLimit"])))
        bodies[name].joint = joint_of(parent, "slide" if slides else "hinge",
                                      turned(usd_turn(values["physics:localRot1"]), [1, 0, 0]), places[0], limits)
    return bodies


# ---- Godot ----

def read_tscn(folder):
    """Of hinges the angle is that of node_a seen from node_b; of sliders the way is that of node_b seen from node_a."""
    sections = re.findall(r"^\[(\w+)((?:\s+\w+=(?:\"[^\"]*\"|\d+))*)\]\n((?:(?!\[)[^\n]*\n?)*)", (folder / "rigged.tscn").read_text(), re.M)
    bodies, files, boxes = {}, {}, {}
    for kind, head, lines in sections:
        at = dict(re.findall(r'(\w+)="([^"]*)"', head))
        own = dict(line.split(" = ", 1) for line in lines.splitlines() if " = " in line)
        vectors = {key: numbers(re.search(r"\((.*)\)", value).group(1)) for key, value in own.items() if "3D(" in value or "Vector3(" in value}
        if kind == "ext_resource":
            files[at["id"]] = at["path"]
            assert (folder / at["path"]).is_file()
        elif at.get("type") == "BoxShape3D":
            boxes[at["id"]] = vectors["size"]
        elif at.get("type") in ("StaticBody3D", "RigidBody3D"):
            body = bodies[at["name"]] = Body()
            body.origin = vectors["transform"][9:]
            if "mass" in own:
                body.mass, body.centre = float(own["mass"]), body.origin + vectors["center_of_mass"]
        elif at.get("type") == "MeshInstance3D":
            assert re.search(r'"(\w+)"', own["mesh"]).group(1) in files
            bodies[at["parent"]].meshes.append(bodies[at["parent"]].origin + vectors["transform"][9:])
        elif at.get("type") == "CollisionShape3D":
            place = bodies[at["parent"]].origin + vectors["transform"][9:]
            bodies[at["parent"]].boxes.append(np.concatenate([place, boxes[re.search(r'"(\w+)"', own["shape"]).group(1)]]))
        elif at.get("type") in ("HingeJoint3D", "SliderJoint3D"):
            slides = at["type"] == "SliderJoint3D"
            a, b = [re.search(r'"\.\./(.*)"', own[key]).group(1) for key in ("node_a", "node_b")]
            parent, name = (a, b) if slides else (b, a)
            frame = vectors["transform"][:9].reshape(3, 3)
            assert np.allclose(frame.T @ frame, np.eye(3), atol=1e-6) and np.linalg.det(frame) > 0
            key = "linear_limit/{}_distance" if slides else "angular_limit/{}"
            limited = slides or own.get("angular_limit/enable") == "true"
            limits = tuple(float(own[key.format(end)]) for end in ("lower", "upper")) if limited else None
            bodies[name].joint = joint_of(parent, "slide" if slides else "hinge", frame[:, 0 if slides else 2],
                                          vectors["transform"][9:], limits)
    return bodies


# ---- glTF ----

def glb_document(path):
    data = path.read_bytes()
    return json.loads(data[20:20 + struct.unpack("<I", data[12:16])[0]])


def glb_joint(document, node, frames, place):
    """The joint of a node, which is in what moves: the connected node goes the other way."""
    own = node["extensions"]["KHR_physics_rigid_bodies"]["joint"]
    stated = document["extensions"]["KHR_physics_rigid_bodies"]["physicsJoints"][own["joint"]]
    free, kind, limits = {(kind, axis) for kind in ("linearAxes", "angularAxes") for axis in range(3)}, None, None
    for limit in stated["limits"]:
        (axes,) = [key for key in ("linearAxes", "angularAxes") if key in limit]
        if limit["min"] == limit["max"] == 0:
            free -= {(axes, axis) for axis in limit[axes]}
        else:
            assert limit[axes] == [0]
            limits = (limit["min"], limit["max"])
    ((kind, axis),) = free
    assert axis == 0
    seat = frames[own["connectedNode"]]
    assert np.allclose(place, seat[:3], atol=1e-4) and np.allclose(node["rotation"], document["nodes"][own["connectedNode"]]["rotation"])
    return joint_of(seat[3], "slide" if kind == "linearAxes" else "hinge", -z_up(turned(node["rotation"], [1, 0, 0])), z_up(place), limits)


def read_glb(folder):
    document = glb_document(folder / "rigged.glb")
    names = {"KHR_physics_rigid_bodies", "KHR_implicit_shapes", "KHR_node_selectability"}
    assert names <= set(document["extensionsUsed"])
    shapes = document["extensions"]["KHR_implicit_shapes"]["shapes"]
    nodes, bodies, frames, joints = document["nodes"], {}, {}, []
    owners = [node for node in nodes if "motion" in node.get("extensions", {}).get("KHR_physics_rigid_bodies", {})]
    owners += [node for node in nodes if node.get("name") == "dragmesh_body"]
    for node in owners:
        name = "body" if node.get("name") == "dragmesh_body" else node["name"]
        body, base = bodies.setdefault(name, Body()), np.array(node.get("translation", [0, 0, 0]))
        motion = node.get("extensions", {}).get("KHR_physics_rigid_bodies", {}).get("motion")
        if motion:
            assert node["extensions"]["KHR_node_selectability"] == {"selectable": True}
            axes = np.array([z_up(turned(motion["inertiaOrientation"], axis)) for axis in np.eye(3)]).T
            body.mass, body.centre = motion["mass"], z_up(base + motion["centerOfMass"])
            body.inertia = axes @ np.diag(motion["inertiaDiagonal"]) @ axes.T
        for index in node.get("children", []):
            child, below = nodes[index], nodes[index].get("extensions", {}).get("KHR_physics_rigid_bodies", {})
            place = base + np.array(child.get("translation", [0, 0, 0]))
            frames[index] = (*place, name)
            if "collider" in below:
                shape = shapes[below["collider"]["geometry"]["shape"]]
                assert shape["type"] == "box" and set(shape["box"]) == {"size"}
                sides = shape["box"]["size"]
                body.boxes.append(np.concatenate([z_up(place), [sides[0], sides[2], sides[1]]]))
            if "joint" in below:
                joints.append((name, child, place))
    for name, child, place in joints:
        bodies[name].joint = glb_joint(document, child, frames, place)
    return bodies


# ---- comparison ----

def part_of(name):
    return re.match(r"part_\d+|body", name).group()


def differences(ours, theirs, size, has_meshes):
    """Yields what is off, and by which share of the size. Bodies are told by their parts: a GLB has names of any characters."""
    theirs = {part_of(name): body for name, body in theirs.items()}
    for name, body in ours.items():
        other = theirs.get(part_of(name))
        if other is None:
            yield f"{name} is missing", math.inf
            continue
        if other.mass is not None:
            yield f"{name}: mass", abs(other.mass / body.mass - 1)
            yield f"{name}: centre of mass", np.abs(other.centre - body.centre).max() / size
        if other.inertia is not None:
            yield f"{name}: inertia", np.abs(other.inertia - body.inertia).max() / np.abs(body.inertia).max()
        for what in ("meshes", "boxes") if has_meshes else ("boxes",):
            a, b = getattr(body, what), getattr(other, what)
            yield f"{name}: number of {what}", 0 if len(a) == len(b) else math.inf
            yield f"{name}: {what}", max((np.abs(x - y).max() / size for x, y in zip(a, b)), default=0)
        if (body.joint is None) != (other.joint is None):
            yield f"{name}: one has a joint, one has none", math.inf
        elif body.joint is not None:
            yield from joint_differences(name, body.joint, other.joint, size, has_meshes)


def joint_differences(name, joint, other, size, has_meshes):
    if part_of(joint["parent"]) != part_of(other["parent"]) or joint["kind"] != other["kind"]:
        yield f"{name}: {joint['kind']} on {joint['parent']}, {other['kind']} on {other['parent']}", math.inf
    yield f"{name}: axis", np.abs(joint["axis"] - other["axis"]).max()
    yield f"{name}: origin", np.abs(joint["origin"] - other["origin"]).max() / size
    a, b = joint["limits"], other["limits"]
    made = joint["kind"] == "slide" and a is not None and a[0] == -a[1] and not has_meshes  # what a GLB need not state
    if (a is None) != (b is None) and not made:
        yield f"{name}: limits {a} and {b}", math.inf
    elif a is not None and b is not None:
        yield f"{name}: limits", max(abs(x - y) for x, y in zip(a, b)) / (size if joint["kind"] == "slide" else 1)


def main():
    failed, worst, joints = 0, 0.0, 0
    for path in sys.argv[1:]:
        folder = pathlib.Path(path)
        ours = read_urdf(folder)
        joints += sum(body.joint is not None for body in ours.values())
        places = np.array([box[:3] + sign * box[3:] / 2 for body in ours.values() for box in body.boxes for sign in (-1, 1)])
        size, off = np.ptp(places, axis=0).max(), []
        readers = {"usda": read_usda, "tscn": read_tscn, "glb": read_glb}
        for name, read in readers.items():
            if name == "glb" and not (folder / "rigged.glb").exists():
                continue  # nothing moves
            off += [(share, f"{name}: {what}") for what, share in differences(ours, read(folder), size, name != "glb")]
        most = max(share for share, _ in off)
        wrong = [f"{what} ({share:.2g})" for share, what in off if not share <= TOLERANCE]
        print(f"{folder}: off by {most:.2g} at most{''.join('; ' + text for text in wrong[:3])}{': FAILED' if wrong else ''}")
        failed, worst = failed + bool(wrong), max(worst, most)
    print(f"USDA, Godot, GLB: {len(sys.argv) - 1} assets, {joints} joints, {failed} failed, off by {worst:.2g} at most")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
