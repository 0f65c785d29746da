#!/usr/bin/env python3
"""Draws how cost grows, from the lines of bench_growth and bench_pick: growth.py FOLDER OUT draws those of triangles.jsonl,
parts.jsonl, drags.jsonl and pick.jsonl that are in the folder."""
import json
import sys
from pathlib import Path

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def read(path):
    return [json.loads(line) for line in path.read_text().splitlines()]


def column(rows, name, scale=1.0):
    return [scale * row[name] for row in rows]


def draw(out, title, x_label, panels):
    """panels: [(y label, [(label, xs, ys)])], side by side on logarithmic axes."""
    figure, axes = plt.subplots(1, len(panels), figsize=(4.2 * len(panels), 3.2), dpi=90)
    for axis, (y_label, lines) in zip(axes, panels):
        for label, xs, ys in lines:
            axis.plot(xs, ys, marker="o", markersize=3, label=label)
        axis.set_xscale("log")
        axis.set_yscale("log")
        axis.set_xlabel(x_label)
        axis.set_ylabel(y_label)
        axis.grid(True, which="major", alpha=0.3)
        axis.legend(fontsize=7)
    figure.suptitle(title, fontsize=10)
    figure.tight_layout()
    figure.savefig(out)
    plt.close(figure)


def draw_objects(rows, x_name, title, out):
    xs = column(rows, x_name)
    draw(out, title, x_name, [
        ("ms", [("prepare, no picking", xs, column(rows, "prepare_ms")),
                ("prepare, with its BVH", xs, column(rows, "prepare_with_picking_ms"))]),
        ("µs", [("move a part and commit", xs, column(rows, "move_commit_us")), ("pick", xs, column(rows, "pick_us"))]),
        ("MB", [("object", xs, column(rows, "bytes", 1e-6)), ("BVH", xs, column(rows, "pick_bytes", 1e-6)),
                (".dmo with triangles", xs, column(rows, "dmo_bytes", 1e-6))])])


def draw_drags(rows, out):
    live = column(rows, "live")
    draw(out, "More and more drags and motions alive", "alive", [
        ("µs a frame, all", [("dm_drag_update", live, column(rows, "update_us")),
                             ("dm_motion_sample", live, column(rows, "sample_us"))]),
        ("bytes each", [("drag + motion", live, column(rows, "bytes_each"))])])


def draw_instances(rows, out):
    commits = [row for row in rows if row["what"] == "commit"]
    count = column(commits, "instances")
    picks = {}
    for row in rows:
        words = row["what"].split()
        if words[0] == "pick," and words[-1] == "instances":
            xs, ys = picks.setdefault(row["who"], ([], []))
            xs.append(int(words[1]))
            ys.append(row["ns"])
    draw(out, "More and more instances of 2,000 triangles", "instances", [
        ("pick, most rays miss, ns", [({"embree, instances, robust": "bare Embree"}.get(who, who), xs, ys) for who, (xs, ys) in picks.items()]),
        ("move one and commit, µs", [("dragmesh", count, column(commits, "move_commit_us"))]),
        ("ms", [("place all of them", count, column(commits, "place_all_ms")),
                ("remove all of them", count, column(commits, "remove_all_ms"))])])


def main(folder, out):
    out.mkdir(parents=True, exist_ok=True)
    drawings = {
        "triangles": lambda rows, to: draw_objects(rows, "triangles", "One part, more and more triangles", to),
        "parts": lambda rows, to: draw_objects(rows, "parts", "100,000 triangles, more and more parts", to),
        "drags": draw_drags,
    }
    for name, draw_rows in drawings.items():
        if (folder / f"{name}.jsonl").exists():
            draw_rows(read(folder / f"{name}.jsonl"), out / f"{name}.png")
    if (folder / "pick.jsonl").exists():
        draw_instances(read(folder / "pick.jsonl"), out / "instances.png")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
