"""Adds up what gcov counted: coverage.py LEAST check|list. Called by tests/coverage.sh, from the root of the repository.

tests/uncovered.txt has a line for each function with lines that no test runs: file, function, how many lines, and the
reason. Functions that are not there, or with more lines than there, are printed.
"""
import collections
import json
import pathlib
import subprocess
import sys

ROOMS = ("sdk/", "plugin_api/src/")
LISTED = pathlib.Path("tests/uncovered.txt")
HEADER = "# file | function | lines that no test runs | why. Written by tests/coverage.sh list, but for the reasons.\n"


def counted():
    """{file: {line: [times, function]}} over all objects that hold the file."""
    files = collections.defaultdict(dict)
    here = pathlib.Path.cwd()
    notes = sorted(map(str, here.glob("build/obj/dragmesh*/debug/*.gcno")))
    reports = subprocess.run(["gcov", "--json-format", "--stdout", *notes], check=True, stdout=subprocess.PIPE,
                             stderr=subprocess.DEVNULL).stdout
    for report in map(json.loads, reports.splitlines()):
        for file in report["files"]:
            name = (pathlib.Path(report["current_working_directory"]) / file["file"]).resolve()
            if not name.is_relative_to(here) or not str(name.relative_to(here)).startswith(ROOMS):
                continue
            lines = files[str(name.relative_to(here))]
            for line in file["lines"]:
                entry = lines.setdefault(line["line_number"], [0, line.get("function_name", "")])
                entry[0] += line["count"]
    return files


def listed():
    rows = [line.split(" | ") for line in LISTED.read_text().splitlines() if not line.startswith("#")] if LISTED.exists() else []
    return {(file, function): (int(lines), why) for file, function, lines, why in rows}


def main():
    least, what = float(sys.argv[1]), sys.argv[2]
    files, known = counted(), listed()
    missing = collections.Counter((name, function) for name, lines in files.items()
                                  for times, function in lines.values() if times == 0)
    total = sum(len(lines) for lines in files.values())
    share = 100 * (1 - sum(missing.values()) / total)
    for room in sorted({pathlib.Path(name).parent for name in files}):
        lines = [entry for name in files if pathlib.Path(name).parent == room for entry in files[name].values()]
        print(f"{str(room):32} {len(lines):6} lines, {100 * sum(times > 0 for times, _ in lines) / len(lines):5.1f} % run")
    print(f"{'all':32} {total:6} lines, {share:5.1f} % run")
    if what == "list":
        with LISTED.open("w") as out:
            out.write(HEADER)
            for key, lines in sorted(missing.items()):
                out.write(" | ".join([*key, str(lines), known.get(key, (0, "?"))[1]]) + "\n")
        return
    more = [f"{file}: {function}: {lines} lines" for (file, function), lines in sorted(missing.items())
            if lines > known.get((file, function), (0, ""))[0]]
    if more:
        print("no test runs, and tests/uncovered.txt does not say why:\n" + "\n".join(more))
    if share < least:
        sys.exit(f"less than {least} % of the lines are run")


main()
