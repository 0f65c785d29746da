"""Prints hashes of what a build answers, to compare two builds that must answer the same.

    python3 tests/e2e/fingerprint.py BUILD DATASET_DIR [--answers OUT.jsonl]

BUILD is a folder such as build/release. DATASET_DIR holds folders with object.glb and joints.json. Hashed are the tool's
answers to every drag and to every part without a drag (times left out), the prepared objects (.dmo) and the objects that
the generator makes. --answers keeps the answers, to look at a difference.
"""
import argparse
import hashlib
import json
import pathlib
import subprocess
import sys
import tempfile

GENERATED_SEEDS = (1, 2)


def jobs_of(folder):
    for path in sorted(folder.glob("*/joints.json")):
        for joint in json.loads(path.read_text())["joints"]:
            job = {"file": str(path.parent / "object.glb"), "moving": joint["moving_nodes"]}
            name = f"{path.parent.name}/{joint['name']}"
            yield {"id": name + "/none", **job}
            for number, drag in enumerate(joint["drags"]):
                yield {"id": f"{name}/{number}", **job, "drag_point": drag["point"], "drag_vector": drag["vector"]}


def answers_of(tool, folder):
    """Answers as the tool prints them, without times."""
    with tempfile.NamedTemporaryFile("w", suffix=".jsonl") as jobs:
        for job in jobs_of(folder):
            jobs.write(json.dumps(job) + "\n")
        jobs.flush()
        lines = subprocess.run([tool, "infer", "--jobs", jobs.name], stdout=subprocess.PIPE, text=True).stdout.splitlines()
    for line in lines:
        answer = json.loads(line)
        answer.pop("ms", None)
        yield json.dumps(answer, sort_keys=True)


def prepared_of(tool, folder):
    with tempfile.TemporaryDirectory() as work:
        out = pathlib.Path(work) / "object.dmo"
        for path in sorted(folder.glob("*/object.glb")):
            out.unlink(missing_ok=True)
            subprocess.run([tool, "prepare", str(path), "-o", str(out)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            yield path.parent.name + " " + (hashlib.sha256(out.read_bytes()).hexdigest() if out.exists() else "refused")


def generated_of(generate):
    for name in sorted(subprocess.run([generate, "--list"], stdout=subprocess.PIPE, text=True).stdout.split()):
        for seed in GENERATED_SEEDS:
            with tempfile.TemporaryDirectory() as work:
                messy = ["--messy"] if seed % 2 == 0 else []
                subprocess.run([generate, "--category", name, "--seed", str(seed), *messy, "-o", work], check=True,
                               stdout=subprocess.DEVNULL)
                for path in sorted(pathlib.Path(work).rglob("*")):
                    if path.is_file():
                        yield f"{name} {seed} {path.name} {hashlib.sha256(path.read_bytes()).hexdigest()}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("dataset", type=pathlib.Path)
    parser.add_argument("--answers", type=pathlib.Path)
    arguments = parser.parse_args()
    tool, generate = str(arguments.build / "dragmesh"), str(arguments.build / "dragmesh_generate")
    for name, lines in (("generated", generated_of(generate)), ("answers", answers_of(tool, arguments.dataset)),
                        ("prepared", prepared_of(tool, arguments.dataset))):
        lines = list(lines)
        text = "\n".join(lines)
        print(f"{name:10} {len(lines):6} {hashlib.sha256(text.encode()).hexdigest()}", flush=True)
        if name == "answers" and arguments.answers:
            arguments.answers.write_text(text + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
