"""A folder is prepared on this machine and on a cluster: python3 tests/python/test_batch.py (after scripts/build)."""
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bindings/python"))
import dragmesh  # noqa: E402
from dragmesh.batch import runners  # noqa: E402
from dragmesh.batch.task import Result  # noqa: E402

ASSETS = ("drawer", "cabinet_door", "chest_lid", "faucet")
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(ROOT / "bindings/python")}
COPIES_ON_CLUSTER = 40
PATIENCE = 60  # s


def die(path):
    """A task that takes its process along where the file says so."""
    if "deadly" in path:
        os._exit(1)
    return Result({"parts": []}, path.encode())


class Batch(unittest.TestCase):
    """python3 -m dragmesh.batch."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        for name in ASSETS:
            self.copy(name, f"{name}.glb")

    def copy(self, name, to):
        (self.folder / to).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / f"tests/replay/{name}/object.glb", self.folder / to)

    def command(self, *words):
        return [sys.executable, "-m", "dragmesh.batch", str(self.folder), "-j", "2", *words]

    def run_batch(self, *words, status=0):
        done = subprocess.run(self.command(*words), env=ENVIRONMENT, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, status, done.stderr)
        self.output = done.stdout
        return json.loads((self.folder / ("rig" if "--rig" in words else "dmo") / "report.json").read_text())

    def test_prepares_a_folder_and_those_below(self):
        self.copy("drawer", "room/kitchen.glb")
        report = self.run_batch()
        self.assertEqual([entry["file"] for entry in report["entries"]],
                         sorted([f"{name}.glb" for name in ASSETS] + ["room/kitchen.glb"]))
        self.assertEqual((report["files"], report["failed"]), (5, 0))
        self.assertEqual(sum(report["types"].values()), report["parts"])
        drawer = next(entry for entry in report["entries"] if entry["file"] == "drawer.glb")
        self.assertIn(("drawer", "prismatic"), [(part["name"], part["type"]) for part in drawer["parts"]])
        with dragmesh.Context() as context:
            thing = context.load_object((self.folder / "dmo/room/kitchen.glb.dmo").read_bytes())
            self.assertEqual([part.id for part in thing.parts()], [part["id"] for part in drawer["parts"]])

    def test_rigs_whole_assets_as_the_tool_does(self):
        self.run_batch("--rig", "--names", "off")
        rigged = json.loads((self.folder / "rig/drawer.glb.rig.json").read_text())
        out = self.folder / "tool.json"
        tool = os.environ.get("DRAGMESH_LIBRARY_PATH", str(ROOT / "build/release")) + "/dragmesh"
        subprocess.run([tool, "rig", str(self.folder / "drawer.glb"), "-o", str(out), "--names", "off"], check=True,
                       capture_output=True)
        expected = json.loads(out.read_text())["parts"]
        self.assertEqual(len(rigged["parts"]), len(expected))
        for ours, theirs in zip(rigged["parts"], expected):
            self.assertEqual(set(ours), set(theirs))
            for key, value in theirs.items():
                if isinstance(value, float) or key in ("axis", "origin"):
                    np.testing.assert_allclose(ours[key], value, atol=1e-4)
                else:
                    self.assertEqual(ours[key], value, key)
        self.run_batch("--rig", "--names", "off")
        self.assertIn("4 files, 0 of them now", self.output)
        self.run_batch("--rig")
        self.assertIn("4 files, 4 of them now", self.output)

    def test_goes_on_where_it_was_and_redoes_what_changed(self):
        (self.folder / "junk.glb").write_bytes(b"no file")
        report = self.run_batch(status=1)
        self.assertEqual(report["failed"], 1)
        self.assertIn("junk.glb: DM_ERROR_BAD_DATA", self.output)
        report = self.run_batch(status=1)
        self.assertIn("5 files, 0 of them now", self.output)
        shutil.copy(ROOT / "tests/replay/drawer/object.glb", self.folder / "junk.glb")
        (self.folder / "dmo/faucet.glb.dmo").unlink()
        (self.folder / "dmo/chest_lid.glb.json").write_text("{")
        self.assertEqual(self.run_batch()["failed"], 0)
        self.assertIn("5 files, 3 of them now", self.output)
        self.run_batch("--again")
        self.assertIn("5 files, 5 of them now", self.output)

    def test_a_run_that_is_killed_is_finished_by_the_next(self):
        for copy in range(20):
            self.copy("cabinet_door", f"copy{copy:02}.glb")
        run = subprocess.Popen(self.command(), env=ENVIRONMENT, stderr=subprocess.DEVNULL, start_new_session=True)
        end = time.monotonic() + PATIENCE
        while not list(self.folder.glob("dmo/*.json")) and time.monotonic() < end:
            time.sleep(0.01)
        os.killpg(run.pid, signal.SIGKILL)
        run.wait()
        before = len(list(self.folder.glob("dmo/*.json")))
        self.assertEqual(self.run_batch()["failed"], 0)
        self.assertTrue(0 < before < 24, before)
        self.assertIn(f"24 files, {24 - before} of them now", self.output)

    def test_names_the_file_that_ends_its_process(self):
        paths = [f"{number}{'deadly' if number == 3 else ''}" for number in range(8)]
        done = dict(runners.run_here(paths, 2, die))
        self.assertEqual(set(done), set(paths))
        self.assertEqual([path for path in paths if "error" in done[path].entry], ["3deadly"])

    def start(self, *command):
        process = subprocess.Popen(command, env=ENVIRONMENT, stderr=subprocess.DEVNULL, start_new_session=True)
        self.addCleanup(process.wait)
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def end(process):
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass  # it has ended by itself

    def test_on_a_cluster_one_of_whose_workers_dies(self):
        expected = {entry["file"]: entry["parts"] for entry in self.run_batch()["entries"]}
        bytes_here = {path.name: path.read_bytes() for path in self.folder.glob("dmo/*.dmo")}
        shutil.rmtree(self.folder / "dmo")
        for copy in range(COPIES_ON_CLUSTER):
            self.copy("cabinet_door", f"copy{copy:02}.glb")
        where = self.folder / "scheduler.json"
        self.start(sys.executable, "-m", "distributed.cli.dask_scheduler", "--port", "0", "--no-dashboard",
                   "--scheduler-file", str(where))
        workers = [self.start(sys.executable, "-m", "distributed.cli.dask_worker", "--scheduler-file", str(where), "--nthreads",
                              "1", "--no-nanny", "--no-dashboard", "--local-directory", str(self.folder / "work"))
                   for _ in range(2)]
        end = time.monotonic() + PATIENCE
        while not where.exists() and time.monotonic() < end:
            time.sleep(0.1)
        address = json.loads(where.read_text())["address"]
        run = self.start(*self.command("--scheduler", address))
        while len(list(self.folder.glob("dmo/*.json"))) < 4 and time.monotonic() < end:
            time.sleep(0.02)
        workers[0].kill()
        self.assertEqual(run.wait(PATIENCE), 0)
        report = json.loads((self.folder / "dmo/report.json").read_text())
        self.assertEqual((report["files"], report["failed"]), (len(ASSETS) + COPIES_ON_CLUSTER, 0))
        self.assertEqual({entry["file"]: entry["parts"] for entry in report["entries"] if entry["file"] in expected}, expected)
        self.assertEqual({name: (self.folder / "dmo" / name).read_bytes() for name in bytes_here}, bytes_here)


if __name__ == "__main__":
    unittest.main()
