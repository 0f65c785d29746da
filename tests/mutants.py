#!/usr/bin/env python3
"""Mutation score: changes one place of the code at a time and counts how many changes the relevant tests notice.

    python3 tests/mutants.py [--count 120] [--seed 36] [--log FILE] [--show | --again]

Three areas share the mutants: ranking, drags, readers of files. Seed and count name the mutants of a given tree. A mutant
that does not compile is replaced by the next one. Needs build/release with its objects (scripts/build release). Each
result is a line of FILE (build/mutants.jsonl); a second run goes on where the first one ended. The changed file alone is
compiled with sanitizers, as scripts/test runs all tests with them. --show prints what the survivors changed, --again asks
the tests of now about them. Status 1 when less than four of five are noticed.
"""
import argparse
import glob
import json
import os
import pathlib
import random
import re
import shlex
import subprocess
import sys
import tempfile

BUILD = pathlib.Path("build/release")
LEAST = 0.8  # share of the mutants that must be noticed
TIMEOUT = 60  # s a test may take; the slowest takes 6 on an idle machine. One that hangs has noticed
FLAGS = shlex.split("-O1 -fPIC -fvisibility=hidden -ffp-contract=off -fno-math-errno -fno-trapping-math -w -D_GNU_SOURCE -DNDEBUG "
                    "-Iplugin_api/include -Isdk -Ithird_party")
SANITIZERS = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all"]
os.environ["ASAN_OPTIONS"] = "detect_leaks=1:allocator_may_return_null=1"
LIBRARIES = shlex.split("-lcmocka build/release/lib/libdragmesh_generator.a build/release/lib/libdragmesh_core.a "
                        "build/release/lib/libmeshoptimizer.a -ldraco -lstdc++ -ldl -lm")

# area: (sources, tests in the order in which they are asked)
AREAS = {
    "ranking": (["sdk/kinematics/ranking/*.c"],
                ["test_ranker", "test_boosted_trees", "test_consensus_refine", "test_candidate_prefilter", "test_twin_leaves",
                 "test_golden_features", "test_joint_inference", "test_no_body", "test_pull", "test_choice", "test_object"]),
    "drag": (["sdk/motion/drag*.c", "sdk/motion/follow*.c", "sdk/motion/hypothesis_tracker.c", "sdk/motion/joint_hypothesis.c",
              "sdk/motion/pull_fit.c", "sdk/motion/axis_refine.c", "sdk/motion/pose_blend.c", "sdk/motion/part_links.c"],
             ["test_axis_refine", "test_part_links", "test_drag_flight", "test_drag_snaps", "test_drag_feel", "test_drag_latch",
              "test_drag_hands", "test_drag_events", "test_drag_bounds", "test_pose_blend", "test_hypothesis_tracker",
              "test_drag_release", "test_drag_words", "test_hands", "test_drag", "test_drag_rules", "test_every_word",
              "test_drag_boundary", "test_boundary", "test_pull", "test_part_state", "test_no_alloc"]),
    "readers": (["sdk/kinematics/object/dmo_*.c", "sdk/nn/weights.c", "sdk/mesh/mask.c", "sdk/mesh/mesh_read.c",
                 "sdk/mesh/gltf/*.c"],
                ["test_mask", "test_mesh", "test_weights", "test_gltf_surface", "test_gltf_hints", "test_gltf_export", "test_gltf",
                 "test_gltf_props", "test_boundary", "test_dmo", "test_object"]),
}

# Each way to be wrong: what is looked for, and what stands in its place.
CHANGES = [
    (r" < (?!=)", (" <= ", " >= ")), (r" > (?!=)", (" >= ", " <= ")), (r" <= ", (" < ", " > ")), (r" >= ", (" > ", " < ")),
    (r" == ", (" != ",)), (r" != ", (" == ",)), (r" && ", (" || ",)), (r" \|\| ", (" && ",)),
    (r" \+ ", (" - ",)), (r" - ", (" + ",)), (r" \* ", (" / ",)), (r" / ", (" * ",)),
    (r" \+= ", (" -= ",)), (r" -= ", (" += ",)),
    (r"\bif \((?=[^;{}]*\)[ ;{])", ("if (!",)),  # closed below
    (r"\btrue\b", ("false",)), (r"\bfalse\b", ("true",)),
    (r"(?<=[ (\[-])[0-9]+(?=[;,) \]])", ("+1",)),  # one more
    (r"^ {4,}[a-z_A-Z>.\[\]*-]+(?: [-+*|&]?= [^;]*|\([^;]*\));$", ("",)),  # a statement less
]


# Sizes of arrays: one element more changes nothing.
DECLARATION = r"^ *(?:static |const |_Alignas\(\w+\) )*(?:float|double|bool|char|int|size_t|u?int\d+_t|dm_\w+|dmi_\w+) \**\w+\[[^=\n]*"


def code_of(text):
    """The text with comments, strings, directives and sizes of arrays blanked, of the same length."""
    blank = lambda found: re.sub(r"[^\n]", "~", found.group())
    text = re.sub(r"/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\])'", blank, text, flags=re.S)
    text = re.sub(r"^#(?:.*\\\n)*.*$", blank, text, flags=re.M)
    return re.sub(DECLARATION, blank, text, flags=re.M)


def closing(text, opening):
    depth = 0
    for at in range(opening, len(text)):
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        if depth == 0:
            return at
    return None


def places(path):
    """All (start, end, replacement) of a file."""
    text = pathlib.Path(path).read_text()
    code = code_of(text)
    for pattern, replacements in CHANGES:
        for found in re.finditer(pattern, code, flags=re.M):
            start, end = found.span()
            for replacement in replacements:
                if replacement == "if (!":
                    close = closing(code, end - 1)
                    if close:
                        yield start, close, "if (!(" + text[end:close] + ")"
                elif replacement == "+1":
                    yield start, end, str(int(found.group()) + 1)
                else:
                    yield start, end, replacement


def candidates(seed):
    """Endless (area, path, place): the areas in turn, files as likely as they have places."""
    chance = random.Random(seed)
    every = {}
    for area, (patterns, _) in AREAS.items():
        files = sorted({path for pattern in patterns for path in glob.glob(pattern)})
        every[area] = [(path, place) for path in files for place in places(path)]
        chance.shuffle(every[area])
    while True:
        for area in AREAS:
            yield area, *every[area].pop()


def compiled(path, text, out):
    source = out.with_suffix(".c")
    source.write_text(text)
    command = ["gcc", "-std=gnu17", *FLAGS, *SANITIZERS, f"-I{pathlib.Path(path).parent}", "-c", source, "-o", out]
    return subprocess.run(command, stderr=subprocess.DEVNULL).returncode == 0


def noticed_by(path, changed, tests, work):
    """The first test that fails with the changed object, or None."""
    others = [name for name in glob.glob("build/obj/dragmesh_gltf/release/gltf*.o")
              if pathlib.Path(name).name != pathlib.Path(path).stem + ".o"]
    program = work / "test"
    for test in tests:
        link = ["gcc", *SANITIZERS, *(["-fuse-ld=lld"] if os.path.exists("/usr/bin/ld.lld") else []), "-o", program,
                f"build/obj/{test}/release/{test}.o", *([changed] if changed else []), *others, *LIBRARIES]
        subprocess.run(link, check=True)
        try:
            run = subprocess.run([program], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=TIMEOUT)
        except subprocess.TimeoutExpired:
            return test + " (hangs)"
        if run.returncode != 0:
            return test
    return None


def difference(path, place):
    start, end, replacement = place
    text = pathlib.Path(path).read_text()
    line = text.count("\n", 0, start) + 1
    first, last = text.rfind("\n", 0, start) + 1, text.find("\n", end)
    return f"{path}:{line}\n  - {text[first:last].strip()}\n  + {(text[first:start] + replacement + text[end:last]).strip()}"


def show(results):
    for area in AREAS:
        of_area = [r for r in results if r["area"] == area]
        killed = sum(r["by"] is not None for r in of_area)
        if of_area:
            print(f"{area:8} {killed:3} of {len(of_area):3} noticed, {100 * killed / len(of_area):.0f} %")
    killed = sum(r["by"] is not None for r in results)
    share = killed / max(1, len(results))
    print(f"all      {killed:3} of {len(results):3} noticed, {100 * share:.0f} %")
    return share


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=120)
    parser.add_argument("--seed", type=int, default=36)
    parser.add_argument("--log", type=pathlib.Path, default=pathlib.Path("build/mutants.jsonl"))
    parser.add_argument("--show", action="store_true")
    parser.add_argument("--again", action="store_true")
    arguments = parser.parse_args()
    os.chdir(pathlib.Path(__file__).resolve().parent.parent)
    done = {}
    if arguments.log.exists():
        done = {r["number"]: r for r in map(json.loads, arguments.log.read_text().splitlines())}
    if arguments.show:
        for r in done.values():
            if r["by"] is None:
                print(f"{r['number']} {r['what']}\n")
        show(list(done.values()))
        return
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        for _, tests in AREAS.values():
            failing = noticed_by("", None, tests, work)
            if failing:
                sys.exit(f"{failing} fails without any change")
        again = {number for number, r in done.items() if r["by"] is None} if arguments.again else set()
        last = max(done, default=-1)
        for number, (area, path, place) in enumerate(candidates(arguments.seed)):
            if len(done) >= arguments.count and number > max(again, default=-1):
                break
            if number <= last and number not in again:
                continue
            text = pathlib.Path(path).read_text()
            changed = work / (pathlib.Path(path).stem + ".o")
            if not compiled(path, text[:place[0]] + place[2] + text[place[1]:], changed):
                continue
            by = noticed_by(path, changed, AREAS[area][1], work)
            result = {"number": number, "area": area, "what": difference(path, place), "by": by}
            print(f"{number:4} {area:8} {by or 'NOT NOTICED'}  {result['what'] if by is None else ''}", flush=True)
            done[number] = result
            arguments.log.write_text("".join(json.dumps(done[i]) + "\n" for i in sorted(done)))
    share = show([done[i] for i in sorted(done)])
    sys.exit(f"less than {LEAST:.0%} are noticed" if share < LEAST else 0)


main()
