"""Finds the shared objects: beside the package, or in this repository's build."""
import os


def find_library(name):
    """Path of a library; the environment variable DRAGMESH_LIBRARY_PATH names a folder that comes first."""
    here = os.path.dirname(os.path.abspath(__file__))
    repository = os.path.dirname(os.path.dirname(os.path.dirname(here)))
    folders = [os.environ.get("DRAGMESH_LIBRARY_PATH"), here]
    folders += [os.path.join(repository, "build", config) for config in ("release", "debug")]
    for folder in filter(None, folders):
        path = os.path.join(folder, name)
        if os.path.exists(path):
            return path
    raise ImportError(f"{name} not found; run scripts/build, or set DRAGMESH_LIBRARY_PATH to its folder")
