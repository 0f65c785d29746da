"""python3 -m dragmesh.batch FOLDER -- prepares every .glb and .gltf of a folder and those below.

Every node of a file is a part, but the one with the largest box; names and pivots are hints. Writes OUT/FILE.dmo and
OUT/FILE.json for each file, and OUT/report.json. With --rig each file is a whole asset, and OUT/FILE.rig.json says which
nodes move, as rig.json of `dragmesh rig` does. A run that was ended goes on where it was; files that changed are done
again. Ends with 1 when a file has failed.
"""
import argparse
import os
import sys
from functools import partial
from typing import List

from .folder import Results, find_files
from .progress import Progress
from .runners import run_here, run_on_cluster
from .task import RigOptions, prepare_file, rig_file


def _arguments(words: List[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser("python3 -m dragmesh.batch", description=__doc__.split("\n\n", 1)[1],
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("-o", "--out", help="where to write; FOLDER/dmo without it")
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count() or 1, help="processes on this machine")
    parser.add_argument("--scheduler", metavar="ADDRESS",
                        help="run on the workers of this Dask scheduler, which see the files under the same paths")
    parser.add_argument("--rig", action="store_true", help="rig whole assets; -o is FOLDER/rig without it")
    parser.add_argument("--names", choices=("on", "off"), default="on", help="of --rig: whether names count")
    parser.add_argument("--no-clips", action="store_true", help="of --rig: animations say nothing")
    parser.add_argument("--min-moves", type=float, default=RigOptions().min_moves,
                        help="of --rig: probability from which on a part moves")
    parser.add_argument("--again", action="store_true", help="do everything again")
    given = parser.parse_args(words)
    if not os.path.isdir(given.folder):
        parser.error(f"{given.folder} is no folder")
    if given.jobs < 1:
        parser.error("--jobs must be 1 or more")
    return given


def main(words: List[str]) -> int:
    """Runs the command."""
    given = _arguments(words)
    source = os.path.abspath(given.folder)
    options = RigOptions(given.names == "on", not given.no_clips, given.min_moves)
    out = os.path.abspath(given.out or os.path.join(given.folder, "rig" if given.rig else "dmo"))
    results = Results(source, out, ".rig.json", str(options)) if given.rig else Results(source, out)
    work = partial(rig_file, options=options) if given.rig else prepare_file
    names = find_files(source)
    done = {} if given.again else {name: entry for name in names if (entry := results.entry(name))}
    paths = [os.path.join(source, name) for name in names if name not in done]
    progress = Progress(len(paths))
    run = run_on_cluster(paths, given.scheduler, work) if given.scheduler else run_here(paths, given.jobs, work)
    for path, result in run:
        name = os.path.relpath(path, source)
        done[name] = results.keep(name, result)
        progress.step(name, "error" in done[name])
    report = results.report([done[name] for name in names])
    for entry in report["entries"]:
        if "error" in entry:
            print(f"{entry['file']}: {entry['error']}: {entry['text']}")
    print(f"{report['files']} files, {len(paths)} of them now; {report['parts']} parts, {report['failed']} failed; "
          f"{os.path.join(results.out, 'report.json')}")
    return 1 if report["failed"] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
