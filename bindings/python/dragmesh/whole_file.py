"""Files that appear whole or not at all: written beside their place, flushed to the disk, and renamed when complete."""
import contextlib
import itertools
import os
import stat
from typing import IO, Any, Dict, Iterator, Optional

_numbers = itertools.count()
_OPEN_ALREADY = ("/dev/stdout", "/dev/stderr", "/dev/fd/", "/proc/")


def _is_stream(path: str) -> bool:
    """Whether what lies at the path can't be replaced: a pipe, a device, or what this process has open."""
    if path.startswith(_OPEN_ALREADY):
        return True
    try:
        return not (stat.S_ISREG(os.stat(path).st_mode) or stat.S_ISDIR(os.stat(path).st_mode))
    except OSError:
        return False


class _Part:
    """The file beside the place of another."""

    def __init__(self, path: str) -> None:
        self.target = os.path.realpath(path)
        old = self._old()
        while True:
            self.path = os.path.join(os.path.dirname(self.target), f".dragmesh-{os.getpid()}-{next(_numbers)}")
            try:
                self.file: IO[Any] = open(self.path, "xb")
                break
            except FileExistsError:
                continue
        if old is not None:
            self._take_mode(old)

    def _old(self) -> Optional[os.stat_result]:
        """What is there; an error where it may not be written."""
        if not os.path.exists(self.target):
            return None
        with open(self.target, "r+b"):
            return os.stat(self.target)

    def _take_mode(self, old: os.stat_result) -> None:
        with contextlib.suppress(OSError, AttributeError):
            os.fchown(self.file.fileno(), old.st_uid, old.st_gid)
        with contextlib.suppress(OSError, AttributeError):
            os.fchmod(self.file.fileno(), stat.S_IMODE(old.st_mode))

    def seal(self) -> None:
        self.file.flush()
        os.fsync(self.file.fileno())
        self.file.close()

    def publish(self) -> None:
        os.replace(self.path, self.target)

    def discard(self) -> None:
        with contextlib.suppress(OSError):
            self.file.close()
        with contextlib.suppress(OSError):
            os.remove(self.path)


@contextlib.contextmanager
def _named(path: str) -> Iterator[None]:
    """Errors name the file that was asked for, not the one beside it."""
    try:
        yield
    except OSError as error:
        if error.errno is not None:
            error.filename, error.filename2 = path, None
        raise


@contextlib.contextmanager
def whole_file(path: "os.PathLike[str] | str") -> Iterator[IO[Any]]:
    """A binary file to write to. It takes its place when the block has ended; where the block raises, or the write fails,
    what was there stays. A link is followed; a pipe or a device is written at once."""
    path = os.fspath(path)
    if _is_stream(path):
        with open(path, "wb") as stream:
            yield stream
        return
    with _named(path):
        part = _Part(path)
        try:
            yield part.file
            part.seal()
            part.publish()
        except BaseException:
            part.discard()
            raise


def write_whole(path: "os.PathLike[str] | str", data: bytes) -> None:
    """Writes a file, all of it or nothing of it."""
    with whole_file(path) as file:
        file.write(data)


def write_together(files: Dict[str, bytes]) -> None:
    """Writes files that belong together: the disk has all of them before the first one takes its place."""
    parts = []
    try:
        for path, data in files.items():
            with _named(path):
                parts.append(_Part(path))
                parts[-1].file.write(data)
                parts[-1].seal()
        for path, part in zip(files, parts):
            with _named(path):
                part.publish()
    except BaseException:
        for part in parts:
            part.discard()
        raise
