"""The folder of results: a .dmo and an entry of the report for each file, and the report."""
import json
import os
from typing import Any, Dict, List, Optional

from ..values import version
from ..whole_file import write_whole
from .task import Result

_ENDINGS = (".glb", ".gltf")


def find_files(folder: str) -> List[str]:
    """Paths of all glTF files in a folder and those below, relative to it, in order."""
    found = []
    for where, folders, names in os.walk(folder):
        folders.sort()
        found += [os.path.relpath(os.path.join(where, name), folder) for name in names if name.lower().endswith(_ENDINGS)]
    return sorted(found)


def _write(path: str, data: bytes) -> None:
    os.makedirs(os.path.dirname(path), exist_ok=True)
    write_whole(path, data)


class Results:
    """What has been done, on disk: a run that was ended goes on from there."""

    def __init__(self, source: str, out: str, ending: str = ".dmo", question: str = "") -> None:
        """ending: of what each file becomes. question: other answers stand for another one."""
        self.source, self.out, self.ending, self.question = source, out, ending, question
        self._version = ".".join(map(str, version()))

    def _path(self, name: str, ending: str) -> str:
        return os.path.join(self.out, name + ending)

    def _stamp(self, name: str) -> Dict[str, Any]:
        """What an entry must agree with to stand for the file as it is now."""
        stat = os.stat(os.path.join(self.source, name))
        stamp = {"file": name, "bytes": stat.st_size, "changed": stat.st_mtime_ns, "dragmesh": self._version}
        return {**stamp, "question": self.question} if self.question else stamp

    def entry(self, name: str) -> Optional[Dict[str, Any]]:
        """The entry of a file that is done and has not changed since, else None. What the library has refused is done;
        other failures may not come again."""
        try:
            with open(self._path(name, ".json"), encoding="utf-8") as file:
                entry = json.load(file)
        except (OSError, ValueError):
            return None
        stamp = self._stamp(name)
        current = isinstance(entry, dict) and all(entry.get(key) == value for key, value in stamp.items())
        whole = current and (entry.get("error", "").startswith("DM_ERROR_") or os.path.exists(self._path(name, self.ending)))
        return entry if whole else None

    def keep(self, name: str, result: Result) -> Dict[str, Any]:
        """Writes what became of a file: the entry last, because it stands for both."""
        entry = {**self._stamp(name), **result.entry}
        if result.dmo is not None:
            _write(self._path(name, self.ending), result.dmo)
        elif os.path.exists(self._path(name, self.ending)):
            os.remove(self._path(name, self.ending))
        _write(self._path(name, ".json"), json.dumps(entry, indent=1).encode())
        return entry

    def report(self, entries: List[Dict[str, Any]]) -> Dict[str, Any]:
        """Writes and returns the report of all files."""
        failed = [entry for entry in entries if "error" in entry]
        types: Dict[str, int] = {}
        for entry in entries:
            for part in entry.get("parts", []):
                types[part["type"]] = types.get(part["type"], 0) + 1
        report = {"dragmesh": self._version, "files": len(entries), "failed": len(failed),
                  "parts": sum(types.values()), "types": dict(sorted(types.items())),
                  "seconds": round(sum(entry.get("seconds", 0) for entry in entries), 3), "entries": entries}
        _write(os.path.join(self.out, "report.json"), json.dumps(report, indent=1).encode())
        return report
