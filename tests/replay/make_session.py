#!/usr/bin/env python3
"""Writes a session for the viewer: a hand that drags a part of an object (object.glb, joints.json) along its true way.

    make_session.py DIR OUT.session [--joint N] [--drag N] [--yaw A] [--pitch A] [--zoom F] [--size WxH] [--share S]
                    [--frames N] [--events "FRAME WHAT,..."] [--back] [--all-parts] [--aim] [--still] [--start FRAME]
                    [--straight | --axis | --by X,Y] [--jostle PX] [--offset PX] [--pause] [--regrab N]
                    [--wander SHARE] [--tremor PX] [--point X,Y,Z] [--meant OUT.meant]

The pointer goes from the drag's point, or another, on the screen to where the true joint would take that point, with a hand's ease.
Or as `dragmesh dragbot` has it: straight on the screen, straight along the axis of the file nearest to the true way, a
few pixels the wrong way first, beside the point, with a stop half-way, letting go and grabbing again on the way,
unsteadily. Or so many pixels on the screen, whatever the joint.

--meant writes what the hand means: the part, its true joint, the point and the value that it is pulled to.
"""
import argparse
import json
import math
import os
import random
import struct


def sub(a, b): return [x - y for x, y in zip(a, b)]
def add(a, b): return [x + y for x, y in zip(a, b)]
def mul(a, s): return [x * s for x in a]
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def cross(a, b): return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
def unit(a): return mul(a, 1 / math.sqrt(dot(a, a)))


def box_of(glb):
    """Bounds of all vertices; nodes are identity, as both the generator and the evaluation set write them."""
    data = open(glb, "rb").read()
    size = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20:20 + size])
    low, high = [math.inf] * 3, [-math.inf] * 3
    for mesh in document["meshes"]:
        for primitive in mesh["primitives"]:
            accessor = document["accessors"][primitive["attributes"]["POSITION"]]
            low = [min(a, b) for a, b in zip(low, accessor["min"])]
            high = [max(a, b) for a, b in zip(high, accessor["max"])]
    return low, high


class Camera:
    """As samples/10_viewer/camera.c has it."""

    def __init__(self, low, high, z_up, width, height, yaw, pitch, zoom, target=None):
        self.fov, self.width, self.height = 0.6, width, height
        self.yaw, self.pitch = yaw, pitch
        self.target = target or mul(add(low, high), 0.5)
        self.distance = zoom * 1.15 * 0.5 * math.dist(low, high) / math.sin(0.3) / min(1, width / height)
        level = math.cos(pitch)
        forward = [-math.sin(yaw) * level, -math.sin(pitch), -math.cos(yaw) * level]
        self.forward = [forward[0], -forward[2], forward[1]] if z_up else forward
        up = [0, 0, 1] if z_up else [0, 1, 0]
        self.side = unit(cross(self.forward, up))
        self.up = cross(self.side, self.forward)
        self.eye = sub(self.target, mul(self.forward, self.distance))

    def pixel(self, p):
        off = sub(p, self.eye)
        scale = self.height / 2 / math.tan(self.fov / 2) / dot(off, self.forward)
        return self.width / 2 + dot(off, self.side) * scale, self.height / 2 - dot(off, self.up) * scale

    def line(self):
        return "0 camera " + " ".join(f"{v:.6g}" for v in [self.yaw, self.pitch, self.distance, *self.target])


def moved(joint, p, q):
    """The point p when the joint stands at q."""
    axis = joint["axis"]
    if joint["type"] == "prismatic":
        return add(p, mul(axis, q))
    off = sub(p, joint["origin"])
    c, s = math.cos(q), math.sin(q)
    turned = add(add(mul(off, c), mul(cross(axis, off), s)), mul(axis, dot(axis, off) * (1 - c)))
    return add(joint["origin"], turned)


def travel(joint, size):
    """How far the hand means to go: the limit in the drag's direction, or what seems much."""
    sign = joint.get("drag_sign", 1)
    limit = joint["upper"] if sign > 0 else joint["lower"]
    if limit is None or abs(limit) < 1e-9 or joint.get("continuous"):
        limit = sign * (0.3 * size if joint["type"] == "prismatic" else math.pi / 2)
    return limit if joint["type"] == "prismatic" else max(-2.6, min(2.6, limit))


def hand(t):
    return t * t * t * (10 - 15 * t + 6 * t * t)


# Frames, as tools/evaluate/dragbot_plan.c has them.
JOSTLE_OUT, JOSTLE_BACK, PAUSE, REGRAB, REGRAB_AT = 6, 10, 45, 12, 10
REST = 30  # frames that a hand which takes hold beside the point keeps still


def along_axis(point, first, end):
    """How far the end lies along the axis of the file nearest to the first direction."""
    k = max(range(3), key=lambda i: abs(first[i] - point[i]))
    return [end[i] - point[i] if i == k else 0 for i in range(3)]


def path(o, camera, joint, point, goal):
    """The pointer's pixels, frame by frame."""
    shares = [hand(i / o.frames) if not o.back else math.sin(math.pi * hand(i / o.frames)) for i in range(o.frames + 1)]
    end = moved(joint, point, goal)
    if o.by:
        (x, y), (dx, dy) = camera.pixel(point), (float(v) for v in o.by.split(","))
        return [(x + t * dx, y + t * dy) for t in shares]
    if o.axis:
        way = along_axis(point, moved(joint, point, 0.001 * goal), end)
        return [camera.pixel(add(point, mul(way, t))) for t in shares]
    if o.straight:
        (x, y), (to_x, to_y) = camera.pixel(point), camera.pixel(end)
        return [(x + t * (to_x - x), y + t * (to_y - y)) for t in shares]
    return [camera.pixel(moved(joint, point, goal * t)) for t in shares]


def jostled(pixels, far):
    """The path with a push of `far` pixels the wrong way first."""
    (x, y) = pixels[0]
    there = next(p for p in pixels if math.dist(p, pixels[0]) >= 2)
    gone = math.dist(there, pixels[0])
    out = [-far * (there[0] - x) / gone, -far * (there[1] - y) / gone]
    push = [(x + out[0] * i / JOSTLE_OUT, y + out[1] * i / JOSTLE_OUT) for i in range(JOSTLE_OUT)]
    rest = [max(0, 1 - i / JOSTLE_BACK) for i in range(len(pixels))]
    return push + [(px + out[0] * r, py + out[1] * r) for (px, py), r in zip(pixels, rest)]


def beside(pixels, far):
    """The path at `far` pixels to the lower left, after a rest."""
    shift = far * math.sqrt(0.5)
    return [(x - shift, y + shift) for x, y in [pixels[0]] * REST + pixels]


def unsteady(pixels, wander, tremor):
    """The path with half a sine wave across the way, a share of it, and a tremor of normally distributed pixels."""
    draw = random.Random(1)
    (x, y), (to_x, to_y) = pixels[0], pixels[-1]
    out = []
    for i, (px, py) in enumerate(pixels):
        bow = wander * math.sin(math.pi * i / (len(pixels) - 1))
        dx, dy = (draw.gauss(0, tremor), draw.gauss(0, tremor)) if i else (0, 0)
        out.append((px - bow * (to_y - y) + dx, py + bow * (to_x - x) + dy))
    return out


def strokes(o, pixels):
    """Events of the hand from frame 0 on: the press, the way with its stops, new grabs."""
    stops = {len(pixels) // 2: "pause"} if o.pause else {}
    stops.update({len(pixels) * (i + 1) // (o.regrab + 1): "regrab" for i in range(o.regrab)})
    events, frame = [(-1, "move %.2f %.2f" % pixels[0]), (0, "press left")], 0
    for i, pixel in enumerate(pixels[1:], 1):
        frame += 1
        events.append((frame, "move %.2f %.2f" % pixel))
        if stops.get(i) == "pause":
            frame += PAUSE
        if stops.get(i) == "regrab":
            events += [(frame + REGRAB_AT, "release left"), (frame + REGRAB_AT + 1, "press left")]
            frame += REGRAB
    return events, frame


def part_lines(known, joint, all_parts):
    """The joints' parts, each with all that moves with it; the one in question alone, or all."""
    parts, seen = [], set()
    for other in known["joints"] if all_parts else [joint]:
        nodes = ",".join(other["moving_nodes"])
        if nodes not in seen:
            seen.add(nodes)
            parts.append(f"part {nodes}")
    return parts


def write_meant(path, joint, point, goal, size):
    numbers = lambda *values: " ".join("inf" if v is None else f"{v:.7g}" for v in values)
    lower = -math.inf if joint["lower"] is None else joint["lower"]
    with open(path, "w") as file:
        file.write(f"part {','.join(joint['moving_nodes'])}\n"
                   f"{joint['type']} {numbers(*joint['axis'], *joint['origin'], lower, joint['upper'])}\n"
                   f"point {numbers(*point)}\ngoal {numbers(goal)}\nsize {numbers(size)}\n")


def session(folder, o):
    known = json.load(open(os.path.join(folder, "joints.json")))
    joint = known["joints"][o.joint]
    low, high = box_of(os.path.join(folder, "object.glb"))
    width, height = (int(v) for v in o.size.split("x"))
    z_up = known.get("up", "y") == "z"
    point = [float(v) for v in o.point.split(",")] if o.point else joint["drags"][o.drag]["point"]
    camera = Camera(low, high, z_up, width, height, o.yaw, o.pitch, o.zoom, point if o.aim else None)
    goal = travel(joint, max(sub(high, low))) * o.share
    lines = ["dragmesh-session 1", f"size {width} {height}", f"up {'z' if z_up else 'y'}"]
    lines += part_lines(known, joint, o.all_parts)
    events = [(0, camera.line()[2:])]
    start = o.start
    pixels = path(o, camera, joint, point, goal)
    if o.wander or o.tremor:
        pixels = unsteady(pixels, o.wander, o.tremor)
    if o.jostle:
        pixels = jostled(pixels, o.jostle)
    if o.offset:
        pixels = beside(pixels, o.offset)
    if o.meant:
        write_meant(o.meant, joint, point, goal, max(sub(high, low)))
    events_of_hand, frames = strokes(o, pixels)
    events += [(start + frame, what) for frame, what in events_of_hand]
    events.append((start + frames + 10, "release left"))
    for word in filter(None, o.events.split(",")):
        frame, what = word.strip().split(" ", 1)
        events.append((int(frame), what))
    events.append((start + frames + o.after, "end"))
    if o.still:  # the pointer stays where it is; what happens comes with --events alone
        events = [e for e in events if e[0] in (0, start) and "press" not in e[1] or e[1] == "end" or e[1] in o.events]
    events.sort(key=lambda e: e[0])
    return lines + [f"{frame} {what}" for frame, what in events]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder")
    parser.add_argument("out")
    for name, kind, value in [("joint", int, 0), ("drag", int, 0), ("yaw", float, 0.6), ("pitch", float, 0.38),
                              ("zoom", float, 1.0), ("size", str, "640x400"), ("share", float, 0.95),
                              ("frames", int, 60), ("start", int, 6), ("events", str, ""), ("after", int, 20), ("jostle", float, 0),
                              ("offset", float, 0), ("wander", float, 0), ("tremor", float, 0), ("regrab", int, 0),
                              ("by", str, ""), ("point", str, ""), ("meant", str, "")]:
        parser.add_argument("--" + name, type=kind, default=value)
    parser.add_argument("--back", action="store_true", help="there and back again")
    parser.add_argument("--all-parts", action="store_true", help="all joints' parts may move, not this one alone")
    parser.add_argument("--still", action="store_true", help="point, but don't drag")
    parser.add_argument("--aim", action="store_true", help="look at the drag's point, not at the object's middle")
    parser.add_argument("--straight", action="store_true", help="straight on the screen")
    parser.add_argument("--axis", action="store_true", help="straight along an axis of the file")
    parser.add_argument("--pause", action="store_true", help="stop half-way and go on")
    o = parser.parse_args()
    with open(o.out, "w") as file:
        file.write("\n".join(session(o.folder, o)) + "\n")


if __name__ == "__main__":
    main()
