#!/usr/bin/env python3
"""Draws how cost grows, from bench_growth's lines: growth.py FOLDER OUT (triangles.jsonl, parts.jsonl, drags.jsonl -> *.png)."""
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


def main(folder, out):
    out.mkdir(parents=True, exist_ok=True)
    draw_objects(read(folder / "triangles.jsonl"), "triangles", "One part, more and more triangles", out / "triangles.png")
    draw_objects(read(folder / "parts.jsonl"), "parts", "100,000 triangles, more and more parts", out / "parts.png")
    drags = read(folder / "drags.jsonl")
    live = column(drags, "live")
    draw(out / "drags.png", "More and more drags and motions alive", "alive", [
        ("µs a frame, all", [("dm_drag_update", live, column(drags, "update_us")),
                             ("dm_motion_sample", live, column(drags, "sample_us"))]),
        ("bytes each", [("drag + motion", live, column(drags, "bytes_each"))])])


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
