#!/usr/bin/env python3
"""Mutation score: changes one place of the code at a time and counts how many changes the relevant tests notice.

    python3 tests/mutants.py [--count 120] [--seed N] [--show | --again]

Three areas share the mutants: ranking, drags, readers of files. Seed and count name the mutants of a given tree; without a
seed it is today's date, which no test was written for. A mutant that does not compile is replaced by the next one. Needs
build/release with its objects (scripts/build release). The changed file alone is compiled with sanitizers, as scripts/test
runs all tests with them. Its tests run in turn, and stop at the first that fails.

tests/mutants/N.jsonl holds a line that says of which sources, then one for each result. A second run goes on where the first
ended; where the sources have changed since, it begins anew. --show prints what the survivors changed. --again asks the tests
of now about them, and notes it beside the first answer, which is the score. Status 1 when less than four of five are noticed.
"""
import argparse
import datetime
import functools
import glob
import hashlib
import json
import os
import pathlib
import random
import re
import resource
import shlex
import signal
import subprocess
import sys
import tempfile

RESULTS = pathlib.Path("tests/mutants")
LEAST = 0.8  # share of the mutants that must be noticed
CPU_LIMIT = 15  # s of the processor that a test may take; the slowest takes 2. One that computes for ever has noticed
WALL_LIMIT = 1200  # s until one that waits for ever has
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
                 "test_alternatives", "test_golden_features", "test_joint_inference", "test_no_body", "test_huge_weights", "test_pull",
                 "test_choice", "test_object"]),
    "drag": (["sdk/drag/drag*.c", "sdk/drag/release_*.c", "sdk/drag/follow.c", "sdk/drag/hypothesis_tracker.c", "sdk/drag/joint_hypothesis.c",
              "sdk/drag/pull_fit.c", "sdk/drag/axis_refine.c", "sdk/drag/pose_blend.c", "sdk/drag/part_links.c"],
             ["test_axis_refine", "test_part_links", "test_follow", "test_drag_corners", "test_drag_flight", "test_drag_snaps", "test_drag_feel",
              "test_drag_latch", "test_drag_hands", "test_drag_events", "test_drag_bounds", "test_pose_blend", "test_hypothesis_tracker",
              "test_drag_release", "test_drag_words", "test_hands", "test_drag", "test_drag_rules", "test_every_word",
              "test_drag_boundary", "test_boundary", "test_replay_hands", "test_pull", "test_part_state",
              "test_no_alloc"]),
    "readers": (["sdk/kinematics/object/dmo_*.c", "sdk/nn/weights.c", "sdk/mesh/mask.c", "sdk/mesh/mesh_read.c",
                 "sdk/gltf/*.c"],
                ["test_mask", "test_mesh", "test_weights", "test_gltf_surface", "test_gltf_hints", "test_gltf_tree",
                 "test_gltf_export", "test_gltf", "test_gltf_fields", "test_gltf_edges", "test_gltf_documents", "test_gltf_scenes", "test_gltf_skins",
                 "test_gltf_folder", "test_gltf_copies", "test_gltf_props", "test_reader_bounds", "test_boundary", "test_dmo",
                 "test_object_hints", "test_huge_weights", "test_object"]),
}

# Tests that take long, and what of the area's sources they are for. The others are asked about all of them.
ONLY_FOR = {"test_pull": "ranking/|pull_fit|axis_refine|hypothesis|follow", "test_choice": "ranking/", "test_part_state": "drag_|release_|drag\\.c",
            "test_no_alloc": "drag\\.c", "test_dmo": "dmo_", "test_object": "ranking/|dmo_|mesh_read", "test_object_hints": "dmo_",
            "test_huge_weights": "ranking/|weights"}

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
    """The text with comments, strings, directives, sizes of arrays and what Windows alone compiles blanked, of the same length."""
    blank = lambda found: re.sub(r"[^\n]", "~", found.group())
    text = re.sub(r"/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\])'", blank, text, flags=re.S)
    text = re.sub(r"^#if defined\(_WIN32\)\n.*?^(?=#else|#endif)", blank, text, flags=re.S | re.M)
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


@functools.cache
def joined(area, work):
    """Objects of a program that runs the test that its argument names: linking one for all takes less than running them."""
    tests, renamed = AREAS[area][1], []
    for test in tests:
        renamed.append(work / f"{area}_{test}.o")
        subprocess.run(["objcopy", f"--redefine-sym=main={test}", f"build/obj/{test}/release/{test}.o", renamed[-1]], check=True)
    main = work / f"{area}_main.c"
    main.write_text("#include <string.h>\n" + "".join(f"int {test}(int, char**);\n" for test in tests)
                    + "int main(int count, char** arguments) {\n"
                    + "".join(f'    if (!strcmp(arguments[1], "{test}")) return {test}(1, arguments);\n' for test in tests)
                    + "    return 2;\n}\n")
    subprocess.run(["gcc", "-w", "-c", main, "-o", main.with_suffix(".o")], check=True)
    return [main.with_suffix(".o"), *renamed]


def noticed_by(path, changed, area, work):
    """The first test that fails with the changed object, or None."""
    program = work / "test"
    others = [name for name in glob.glob("build/obj/dragmesh_gltf/release/gltf*.o")
              if pathlib.Path(name).name != pathlib.Path(path).stem + ".o"]
    subprocess.run(["gcc", *SANITIZERS, *(["-fuse-ld=lld"] if os.path.exists("/usr/bin/ld.lld") else []), "-o", program,
                    *joined(area, work), *([changed] if changed else []), *others, *LIBRARIES], check=True)
    for test in AREAS[area][1]:
        if path and not re.search(ONLY_FOR.get(test, ""), path):
            continue
        try:
            run = subprocess.run([program, test], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=WALL_LIMIT,
                                 preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (CPU_LIMIT, CPU_LIMIT)))
        except subprocess.TimeoutExpired:
            return test + " (waits)"
        if run.returncode != 0:
            return test + (" (hangs)" if run.returncode in (-signal.SIGXCPU, -signal.SIGKILL) else "")
    return None


def difference(path, place):
    start, end, replacement = place
    text = pathlib.Path(path).read_text()
    line = text.count("\n", 0, start) + 1
    first, last = text.rfind("\n", 0, start) + 1, text.find("\n", end)
    return f"{path}:{line}\n  - {text[first:last].strip()}\n  + {(text[first:start] + replacement + text[end:last]).strip()}"


def sources_of():
    """A hash of the sources that are changed: the same mutants have the same."""
    every = sorted({path for patterns, _ in AREAS.values() for pattern in patterns for path in glob.glob(pattern)})
    return hashlib.sha256(b"".join(path.encode() + pathlib.Path(path).read_bytes() for path in every)).hexdigest()[:16]


def cpu_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def write(log, header, done):
    log.parent.mkdir(exist_ok=True)
    log.write_text("".join(json.dumps(line) + "\n" for line in [header, *(done[i] for i in sorted(done))]))


def show(results):
    """Prints the score; returns it."""
    for name in [*AREAS, "all"]:
        of_area = [r for r in results if name in (r["area"], "all")]
        killed = sum(r["by"] is not None for r in of_area)
        later = sum("later" in r for r in of_area)
        if of_area:
            print(f"{name:8} {killed:3} of {len(of_area):3} noticed, {100 * killed / len(of_area):.1f} %"
                  + (f"; {later} more by tests written since" if later else ""))
    print(f"{sum(r['cpu'] for r in results):.0f} s of one core")
    return killed / max(1, len(results))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=120)
    parser.add_argument("--seed", type=int, default=int(datetime.date.today().strftime("%Y%m%d")))
    parser.add_argument("--show", action="store_true")
    parser.add_argument("--again", action="store_true")
    arguments = parser.parse_args()
    os.chdir(pathlib.Path(__file__).resolve().parent.parent)
    log = RESULTS / f"{arguments.seed}.jsonl"
    lines = [json.loads(line) for line in log.read_text().splitlines()] if log.exists() else []
    if arguments.show:
        for r in lines[1:]:
            if r["by"] is None:
                print(f"{r['number']} {r['what']}" + (f"\n  since noticed by {r['later']}" if "later" in r else "") + "\n")
        show(lines[1:])
        return
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True).stdout.strip()
    header = {"seed": arguments.seed, "sources": sources_of(), "date": str(datetime.date.today()), "commit": commit}
    if lines and lines[0]["sources"] != header["sources"]:
        if arguments.again:
            sys.exit(f"{log} is of other sources")
        print(f"the sources have changed since {lines[0]['date']}: begins anew")
        lines = []
    header, done = lines[0] if lines else header, {r["number"]: r for r in lines[1:]}
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        for area in AREAS:
            failing = noticed_by("", None, area, work)
            if failing:
                sys.exit(f"{failing} fails without any change")
        again = {number for number, r in done.items() if r["by"] is None and "later" not in r} if arguments.again else set()
        last = max(done, default=-1)
        for number, (area, path, place) in enumerate(candidates(arguments.seed)):
            if number > max(again, default=-1) and (arguments.again or len(done) >= arguments.count):
                break
            if number <= last and number not in again:
                continue
            text = pathlib.Path(path).read_text()
            changed, before = work / (pathlib.Path(path).stem + ".o"), cpu_seconds()
            if not compiled(path, text[:place[0]] + place[2] + text[place[1]:], changed):
                continue
            by = noticed_by(path, changed, area, work)
            if number not in again:
                done[number] = {"number": number, "area": area, "what": difference(path, place), "by": by,
                                "cpu": round(cpu_seconds() - before, 1)}
            elif by:
                done[number]["later"] = by
            print(f"{number:4} {area:8} {by or 'NOT NOTICED  ' + done[number]['what']}", flush=True)
            write(log, header, done)
    share = show([done[i] for i in sorted(done)])
    sys.exit(f"less than {LEAST:.0%} are noticed" if share < LEAST else 0)


main()
