"""Finds the shared objects: beside the package, or in this repository's build."""
import ctypes as c
import os
from typing import Any, Dict, Tuple

from .native import ALIASES

HERE = os.path.dirname(os.path.abspath(__file__))
REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(HERE)))
_loaded: Dict[str, c.CDLL] = {}


def find_library(name: str) -> str:
    """Path of a library; the environment variable DRAGMESH_LIBRARY_PATH names a folder that comes first."""
    folders = [os.environ.get("DRAGMESH_LIBRARY_PATH"), HERE]
    folders += [os.path.join(REPOSITORY, "build", config) for config in ("release", "debug")]
    for folder in filter(None, folders):
        path = os.path.join(folder, name)
        if os.path.exists(path):
            return path
    raise ImportError(f"{name} not found; run scripts/build, or set DRAGMESH_LIBRARY_PATH to its folder")


def models_folder() -> str:
    """The folder of the shipped weights."""
    for folder in (os.path.join(HERE, "models"), os.path.join(REPOSITORY, "sdk", "models")):
        if os.path.exists(os.path.join(folder, "kpp_net.safetensors")):
            return folder
    raise ImportError("the shipped weights are not beside the package")


def open_library(name: str, functions: Dict[str, Tuple[Any, Any]]) -> c.CDLL:
    """A library with the prototypes of its functions; opened once."""
    if name not in _loaded:
        library = c.CDLL(find_library(name))
        for function, (result, arguments) in functions.items():
            entry = getattr(library, function)
            entry.restype, entry.argtypes = result, arguments
        for alias, function in ALIASES.items():
            if function in functions:
                setattr(library, alias, getattr(library, function))
        _loaded[name] = library
    return _loaded[name]
