"""Files of the Python package appear whole or not at all, whichever step of the writing fails."""
import builtins
import errno
import os
import stat
import sys
import tempfile
import threading
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bindings/python"))
from dragmesh.whole_file import whole_file, write_together, write_whole  # noqa: E402

NO_SPACE = OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
real_open = builtins.open


class Failing:
    """A file whose write, flush or close fails."""

    def __init__(self, file, step):
        self.file, self.step = file, step

    def __getattr__(self, name):
        return getattr(self.file, name)

    def write(self, data):
        self.file.write(data[:3])
        if self.step == "write":
            raise NO_SPACE

    def flush(self):
        if self.step == "flush":
            raise NO_SPACE
        self.file.flush()

    def close(self):
        self.file.close()
        if self.step == "close":
            raise NO_SPACE


def failing(step, number=1):
    """What makes a step fail for the n-th file that is created."""
    seen = []

    def create(path, mode="r", *arguments, **named):
        if mode != "xb":
            return real_open(path, mode, *arguments, **named)
        seen.append(path)
        if len(seen) != number:
            return real_open(path, mode)
        if step == "open":
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), path)
        return Failing(real_open(path, mode), step)

    def call(real):
        calls = []

        def replacement(*arguments):
            calls.append(arguments)
            if len(calls) == number:
                raise NO_SPACE
            return real(*arguments)
        return replacement

    patches = [mock.patch("builtins.open", create)]
    if step in ("fsync", "replace"):
        patches = [mock.patch(f"os.{step}", call(getattr(os, step)))]
    return patches[0]


class Writes(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(lambda: __import__("shutil").rmtree(self.folder))
        self.path = self.folder / "file"
        self.path.write_bytes(b"what was there before")

    def left(self):
        return sorted(path.name for path in self.folder.iterdir())

    def test_every_step(self):
        for step in ("open", "write", "flush", "fsync", "close", "replace"):
            with self.subTest(step), failing(step):
                with self.assertRaises(OSError) as raised:
                    write_whole(self.path, b"new content")
                self.assertEqual(raised.exception.errno, errno.ENOSPC)
                self.assertIn(str(self.path), str(raised.exception))
                self.assertNotIn(".dragmesh-", str(raised.exception))
                self.assertEqual(self.path.read_bytes(), b"what was there before")
                self.assertEqual(self.left(), ["file"])

    def test_files_that_belong_together(self):
        other = self.folder / "other"
        for step in ("open", "write", "flush", "fsync", "close", "replace"):
            for number in (1, 2):
                self.path.write_bytes(b"old")
                other.write_bytes(b"old")
                with self.subTest(step=step, file=number), failing(step, number):
                    with self.assertRaises(OSError):
                        write_together({str(self.path): b"new", str(other): b"new"})
                    first = b"new" if (step, number) == ("replace", 2) else b"old"
                    self.assertEqual((self.path.read_bytes(), other.read_bytes()), (first, b"old"))
                    self.assertEqual(self.left(), ["file", "other"])

    def test_a_block_that_raises(self):
        for error in (ValueError, KeyboardInterrupt):
            with self.assertRaises(error), whole_file(self.path) as file:
                file.write(b"half")
                raise error
            self.assertEqual(self.path.read_bytes(), b"what was there before")
        self.assertEqual(self.left(), ["file"])

    def test_links_and_modes(self):
        self.path.chmod(0o640)
        (self.folder / "link").symlink_to("file")
        (self.folder / "new").symlink_to("made")
        for name in ("link", "new"):
            write_whole(self.folder / name, b"new")
            self.assertTrue((self.folder / name).is_symlink())
        self.assertEqual(self.path.read_bytes(), b"new")
        self.assertEqual((self.folder / "made").read_bytes(), b"new")
        self.assertEqual(stat.S_IMODE(self.path.stat().st_mode), 0o640)

    def test_a_pipe(self):
        os.mkfifo(self.folder / "pipe")
        heard = []
        reader = threading.Thread(target=lambda: heard.append((self.folder / "pipe").read_bytes()))
        reader.start()
        write_whole(self.folder / "pipe", b"through")
        reader.join()
        self.assertEqual(heard, [b"through"])

    def test_what_can_not_be_written(self):
        (self.folder / "folder").mkdir()
        for name, error in (("folder", IsADirectoryError), ("nowhere/file", FileNotFoundError)):
            with self.assertRaises(error) as raised:
                write_whole(self.folder / name, b"new")
            self.assertEqual(raised.exception.filename, str(self.folder / name))
        self.assertEqual(self.left(), ["file", "folder"])


if __name__ == "__main__":
    unittest.main()
