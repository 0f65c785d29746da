"""Puts ours and the peers' times side by side: ratios.py FOLDER (run's) [PAGE]. Prints tables; with a page, rewrites what
stands there between the markers."""
import json
import platform
import sys
import textwrap
from pathlib import Path

LINE = 110  # characters of a page's line
BEGIN, END = "<!-- peers: written by tests/bench/peers/run --write -->", "<!-- peers: end -->"


def read(path):
    return [json.loads(line) for line in path.read_text().splitlines()]


def times_of(rows, folder):
    """By who and what, ns; and the instruction set of our networks."""
    times = {(row["who"], row["what"]): row["median_ns"] for row in rows if "what" in row}
    networks = read(folder / "networks.jsonl")
    best = networks[-1]["isa"]
    for row in networks:
        if row["isa"] == best:
            times["dragmesh", "network: " + row["name"]] = 1e3 * row["median_us"]
    return times, best


PAIRS = [("motion", "motion", [("pytorch", "motion, same network"), ("pytorch", "motion, reference size")]),
         ("kinematics call, 100,000 triangles, one part", "kinematics", [("pytorch", "kinematics, reference size")]),
         ("KPP-Net alone", "network: kinematics", [("pytorch", "kinematics, same network alone")]),
         ("pick, 1 M triangles", "pick", [("embree, instances, robust", "pick"), ("embree, instances", "pick"),
                                          ("embree, one mesh", "pick")]),
         ("100,000 points", "points", [("memcpy", "points"), ("cglm", "points")])]
PAIRS += [(f"product 16 × {name[5:].replace('_', ' × ')}", f"network: {name}", [("onednn", name)])
          for name in ("gemm_96_288", "gemm_96_96", "gemm_96_384", "gemm_384_96")]
NAMES = {"dragmesh": "dragmesh", "embree": "bare Embree", "pytorch": "PyTorch", "onednn": "oneDNN, weights packed",
         "memcpy": "memcpy of the same bytes", "cglm": "cglm's `glm_mat4_mulv3` in a loop"}


def name_of(peer):
    who, what = peer
    if who == "pytorch":
        return "PyTorch, " + what.split(", ", 1)[1].replace("same network", "the same network").replace(" alone", "")
    return NAMES.get(who, who.replace("embree", "bare Embree"))


def shown(ns):
    for unit, size in (("s", 1e9), ("ms", 1e6), ("µs", 1e3)):
        if ns >= size:
            return f"{ns / size:.3g} {unit}" if ns < 1e3 * size else f"{ns / size:,.0f} {unit}"
    return f"{ns:.0f} ns"


def table_of_work(times):
    yield "| work | dragmesh | peer | its time | its time / ours |"
    yield "|---|---|---|---|---|"
    for title, ours, peers in PAIRS:
        for peer in peers:
            mine, its = times["dragmesh", ours], times[peer]
            yield f"| {title} | {shown(mine)} | {name_of(peer)} | {shown(its)} | {its / mine:.2f} |"


def table_of_first_use(rows):
    """The least of the processes: what else the machine did costs all of them."""
    least = {}
    for row in rows:
        if "first" in row:
            before = least.get((row["who"], row["first"]), (float("inf"), float("inf")))
            least[row["who"], row["first"]] = (min(before[0], row["first_ns"]), min(before[1], row["again_ns"]))
    yield "| first use | | the first time | the second |"
    yield "|---|---|---|---|"
    for (who, what), (first, again) in sorted(least.items(), key=lambda item: list(NAMES).index(item[0][0])):
        yield f"| {NAMES[who]} | {what} | {shown(first)} | {shown(again) if again > 0 else '–'} |"


def table_of_sizes(rows, sizes):
    yield "| size | |"
    yield "|---|---|"
    for name, size in sizes:
        yield f"| {name} | {size / 1024:,.0f} KB |"
    weights = {(row["who"], row["memory"]): row["bytes_a_triangle"] for row in rows if "memory" in row}
    for (who, what), size in weights.items():
        of = f"dragmesh, {what}" if who == "dragmesh" else "bare Embree, its copy of the mesh included"
        yield f"| memory a triangle: {of} | {size:.0f} bytes |"


def machine():
    model = next((line.split(":")[1].strip() for line in Path("/proc/cpuinfo").read_text().splitlines()
                  if line.startswith("model name")), platform.processor())
    system = dict(line.split("=", 1) for line in Path("/etc/os-release").read_text().splitlines() if "=" in line)
    return f"{model}, {system['PRETTY_NAME'].strip(chr(34))}"


def rewrite(page, text):
    before, rest = page.read_text().split(BEGIN)
    after = rest.split(END)[1]
    page.write_text(f"{before}{BEGIN}\n\n{text}\n\n{END}{after}")


def main(folder, page=None):
    rows = [row for name in ("ours", "onednn", "pytorch", "first_use") for row in read(folder / f"{name}.jsonl")]
    facts = json.loads((folder / "facts.json").read_text())
    times, best = times_of(rows, folder)
    head = textwrap.fill(f"One thread of {machine()}, {best.upper()}, {facts['compiler']}, version {facts['version']} of "
                         f"{facts['date']}. Times are processor time, as medians of one run; those of first uses are the least "
                         f"of {facts['processes']} processes.", LINE)
    parts = [head, *("\n".join(table) for table in (table_of_work(times), table_of_first_use(rows),
                                                    table_of_sizes(rows, facts["sizes"])))]
    text = "\n\n".join(parts)
    print(text)
    if page is not None:
        rewrite(page, text)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:3]))
