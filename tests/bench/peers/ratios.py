"""Puts ours and the peers' times side by side: ratios.py FOLDER (run's)."""
import json
import sys
from pathlib import Path


def read(path):
    return [json.loads(line) for line in path.read_text().splitlines()]


def main(folder):
    rows = read(folder / "ours.jsonl") + read(folder / "onednn.jsonl") + read(folder / "pytorch.jsonl")
    times = {(row["who"], row["what"]): row["median_ns"] for row in rows}
    networks = read(folder / "networks.jsonl")
    best = networks[-1]["isa"]
    for row in networks:
        if row["isa"] == best:
            times["dragmesh", "network: " + row["name"]] = 1e3 * row["median_us"]
    pairs = [("motion", "motion", [("pytorch", "motion, same network"), ("pytorch", "motion, reference size")]),
             ("kinematics call, 100k triangles, one part", "kinematics", [("pytorch", "kinematics, reference size")]),
             ("KPP-Net alone", "network: kinematics", [("pytorch", "kinematics, same network alone")]),
             ("pick, 1M triangles", "pick", [("embree, instances, robust", "pick"), ("embree, instances", "pick"),
                                             ("embree, one mesh", "pick")]),
             ("100k points", "points", [("memcpy", "points"), ("cglm", "points")])]
    pairs += [(f"layer {name[5:]}, 16 rows", f"network: {name}", [("onednn", name)])
              for name in ("gemm_96_288", "gemm_96_96", "gemm_96_384", "gemm_384_96")]
    print(f"| work ({best}, one thread) | dragmesh | peer | its time | its time / ours |\n|---|---|---|---|---|")
    for title, ours, peers in pairs:
        for peer in peers:
            mine, its = times["dragmesh", ours], times[peer]
            label = peer[0] + peer[1][peer[1].find(","):] if "," in peer[1] else peer[0]
            print(f"| {title} | {mine / 1e3:,.2f} µs | {label} | {its / 1e3:,.2f} µs | {its / mine:.2f} |")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
