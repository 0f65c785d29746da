"""Contexts and what they make."""
import ctypes as c
import os
import threading
import weakref
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import native as n
from .arrays import describe_mesh
from .base import Unique, bytes_of, integer, text_of
from .library import models_folder
from .objects import Model, Object, Owned, Scene
from .turns import Turns
from .values import Axes, Hint, JointType, Picking, Vector, check, hint_of, load, vec3

Weights = Union[None, bytes, str, "os.PathLike[str]"]

_LOG = dict(n.Log._fields_)["message"]
_FIELDS = dict(n.ObjectDesc._fields_)


def pivot_of(pivot: Tuple[Vector, Any]) -> n.Pivot:
    """(origin, axes) as the struct; axes: three rows, or None: unknown."""
    origin, axes = pivot
    numbers = np.zeros(9) if axes is None else np.asarray(axes, float).reshape(9)
    return n.Pivot(vec3(origin), (c.c_float * 9)(*numbers))


class Context(Unique):
    """A context and everything made with it. Use as a context manager, or call close()."""

    def __init__(self, axes: Axes = Axes.GLTF, unit_in_metres: float = 1.0, picking: Picking = Picking.AUTO,
                 custom_axes: Any = None, log: Optional[Callable[[int, str], None]] = None,
                 progress: Optional[Callable[[float], Any]] = None) -> None:
        """custom_axes: with Axes.CUSTOM, a 3 x 3 matrix that takes the host's vectors to glTF's. log(level, text): gets
        the messages; level 0 is an error. It must not call this context. progress(done): of calls that take long for a
        large mesh, preparations with one of their own aside; gets 0 to 1, returns False to cancel."""
        self.library = load()
        self._turns = Turns()
        self._said = threading.local()
        self._on_message = _listener(self._said, log)  # kept: the library calls it
        desc = n.ContextDesc(axes=axes, unit_in_metres=unit_in_metres, picking=picking, log=n.Log(None, self._on_message))
        self._on_progress = _watcher(self._said, progress) if progress is not None else None
        if self._on_progress is not None:
            desc.progress = self._on_progress
        if custom_axes is not None:
            desc.custom_axes = (c.c_float * 9)(*np.asarray(custom_axes, float).reshape(9))
        self.pointer: Any = c.c_void_p()
        self._check(self.library.dm_context_create(c.byref(desc), c.byref(self.pointer)))
        self._finalizer = weakref.finalize(self, _destroy, self._turns, self.library, self.pointer, False,
                                           self._on_message, self._on_progress)

    def _check(self, result: int) -> None:
        message, self._said.text = getattr(self._said, "text", ""), ""
        failure, self._said.failure = getattr(self._said, "failure", None), None
        if failure is not None:
            raise failure
        check(result, message)

    def call(self, name: str, *arguments: Any) -> None:
        """dm_<name>(context, ...), an Error when it fails. Such calls take turns."""
        function = getattr(self.library, "dm_" + name)
        self._check(self._turns.run(lambda: function(self.pointer, *arguments)))

    def make(self, name: str, used: Any, *arguments: Any) -> None:
        """The same for calls that take long; used: a Model or None."""
        function = getattr(self.library, "dm_" + name)
        self._check(self._turns.run(lambda: function(self.pointer, *arguments), used, beside=True))

    def end(self, owned: "Owned", name: str, *arguments: Any) -> None:
        """dm_<name>(context, ...), which ends something."""
        function = getattr(self.library, "dm_" + name)
        self._turns.end(owned, lambda: function(self.pointer, *arguments))

    def forget(self, name: str, *arguments: Any) -> None:
        """The same for what nothing refers to, now or soon."""
        function = getattr(self.library, "dm_" + name)
        self._turns.forget(lambda: function(self.pointer, *arguments))

    def close(self) -> None:
        """Ends it and everything made with it. A second time does nothing. An error while a call of it runs, which its
        callbacks are part of."""
        if self.pointer and not _destroy(self._turns, self.library, self.pointer, True):
            raise RuntimeError("the context is in use")

    def __enter__(self) -> "Context":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def memory(self) -> n.MemoryInfo:
        """What the context holds."""
        info = n.MemoryInfo()
        self.call("context_get_memory", c.byref(info))
        return info

    def load_model(self, kinematics: Weights = None, motion: Weights = None, ranker: Weights = None) -> "Model":
        """A model from the bytes (or the paths) of the safetensors files; each may be absent."""
        desc, kept = n.ModelDesc(), []
        for name, data in (("kinematics", kinematics), ("motion", motion), ("ranker", ranker)):
            if isinstance(data, (str, os.PathLike)):
                with open(data, "rb") as file:
                    data = file.read()
            if data is not None:
                data = bytes_of(data, name)
                kept.append(c.c_char_p(data))
                setattr(desc, name, c.cast(kept[-1], c.c_void_p))
                setattr(desc, name + "_size", len(data))
        handle = c.c_uint64()
        self.make("model_load", None, c.byref(desc), c.byref(handle))
        return Model(self, handle.value)

    def load_shipped_model(self) -> "Model":
        """The weights that come with the package."""
        folder = models_folder()
        return self.load_model(*(os.path.join(folder, name + ".safetensors") for name in ("kpp_net", "dq_vae", "ranker")))

    def prepare(self, positions: Any, indices: Any, part_ids: Any, parts: Optional[Sequence[Dict[str, Any]]] = None,
                model: Optional["Model"] = None, seed: int = 0, picking: bool = False, label: Optional[str] = None,
                up: Optional[Vector] = None, choose: Optional[Callable[..., Optional[int]]] = None,
                progress: Optional[Callable[[float], Any]] = None,
                intent: Optional[Callable[[int, Vector, Vector], Optional[JointType]]] = None) -> "Object":
        """An object from vertices (n x 3), triangles (m x 3) and one part id a vertex or a triangle (0 = the body).

        parts: dicts with id and, as wanted, parent, joint_type, drag=(point, vector), label (names of the asset for the
        part, joined by "/"), pivot=(origin, axes) (axes: three rows or None); None: every id. label, up: of the object;
        see dm_object_desc. choose(part, hypotheses): picks one for each part, by its index, or None to keep the library's
        answer; a PartInfo and a list of Hypothesis. progress(done): gets 0 to 1; returns False to
        cancel. intent(part_id, box_min, box_max): a joint type, or None."""
        mesh, arrays = describe_mesh(positions, indices, part_ids)
        rows, kept = _part_rows(parts or [])
        desc = n.ObjectDesc(flags=0 if picking else n.DM_PREPARE_WITHOUT_PICKING, mesh=c.pointer(mesh),
                            parts=rows if parts else None, part_count=len(rows), model=model.handle if model else 0,
                            seed=seed, label=text_of(label, "label") if label else None,
                            up=vec3(up) if up is not None else n.Vec3())
        failures: List[BaseException] = []
        callbacks = {
            "choose": (lambda _, choice: choose(*_shown(choice.contents)), n.DM_CHOICE_KEEP)
            if choose else None,
            "progress": (lambda _, done: int(progress(done) is False), 1) if progress else None,
            "intent": (lambda _, part, low, high: intent(part, tuple(low), tuple(high)), n.DM_JOINT_UNKNOWN)
            if intent else None}
        for name, callback in callbacks.items():
            if callback is not None:
                setattr(desc, name, _FIELDS[name](guarded(*callback, failures)))
        handle = c.c_uint64()
        try:
            self.make("object_prepare", model, c.byref(desc), c.byref(handle))
        finally:
            del arrays, kept
            if failures:
                if handle.value:
                    self.call("object_destroy", handle.value)
                raise failures[0]
        return Object(self, handle.value, model)

    def load_object(self, data: bytes, model: Optional["Model"] = None) -> "Object":
        """An object from the bytes that Object.save gave."""
        handle, data = c.c_uint64(), bytes_of(data, "data")
        self.make("object_load", model, data, len(data), model.handle if model else 0, c.byref(handle))
        return Object(self, handle.value, model)

    def find_part(self, positions: Any, indices: Any, drag: Hint, pieces: Any = None) -> np.ndarray:
        """1 for every triangle of the part that a point of the surface belongs to, else 0. drag: where it was grabbed,
        and how it was pulled (zeros: no direction). pieces: ids of what is known to be rigid, a vertex or a triangle."""
        mesh, arrays = describe_mesh(positions, indices, pieces)
        faces = np.zeros(len(arrays[1]) // 3, np.uint8)
        self.make("mesh_find_part", None, c.byref(mesh), c.byref(hint_of(drag)), faces.ctypes.data_as(c.POINTER(c.c_uint8)),
                  len(faces))
        return faces

    def scene(self) -> "Scene":
        """An empty scene."""
        handle = c.c_uint64()
        self.call("scene_create", c.byref(n.SceneDesc()), c.byref(handle))
        return Scene(self, handle.value)

    def camera_ray(self, camera: n.Camera, x: float, y: float) -> n.Ray:
        """The ray through a pixel, (0, 0) the top left corner."""
        ray = n.Ray()
        self.call("camera_ray", c.byref(camera), x, y, c.byref(ray))
        return ray


def _watcher(said: Any, progress: Callable[[float], Any]) -> Any:
    """The progress callback. An exception of it cancels the call, which raises it."""

    def watch(_: Any, done: float) -> int:
        try:
            return int(progress(done) is False)
        except BaseException as failure:  # pylint: disable=broad-except
            said.failure = failure
            return 1

    return _FIELDS["progress"](watch)


def _listener(said: Any, log: Optional[Callable[[int, str], None]]) -> Any:
    """The log callback. It holds nothing of the context, which could never end else."""

    def remember(_: Any, level: int, _code: int, text: bytes) -> None:
        message = text.decode(errors="replace")
        if level == n.DM_LOG_ERROR:
            said.text = message
        if log is not None:
            log(level, message)

    return _LOG(remember)


def _destroy(turns: Turns, library: Any, pointer: Any, waits: bool, *_callbacks: Any) -> bool:
    """False: a call runs. At the interpreter's exit, that is one of a thread which nobody waits for."""

    def destroy() -> None:
        library.dm_context_destroy(pointer)
        pointer.value = None

    return turns.close(destroy, waits)


def guarded(function: Callable[..., Any], otherwise: int, failures: List[BaseException]) -> Callable[..., int]:
    """A function for the library to call. Nothing may pass through it, so the first exception is kept."""

    def answer(*arguments: Any) -> int:
        if failures:
            return otherwise
        try:
            result = function(*arguments)
            return otherwise if result is None else integer(c.c_int32, result, "the answer of a callback")
        except BaseException as failure:  # pylint: disable=broad-except
            failures.append(failure)
            return otherwise

    return answer


def _shown(choice: n.Choice) -> Tuple[n.PartInfo, List[n.Hypothesis]]:
    """Copies, for the host may keep them."""
    hypotheses = []
    for i in range(choice.count):
        hypotheses.append(n.Hypothesis.from_buffer_copy(choice.hypotheses[i].contents))
        hypotheses[-1].joint = c.pointer(n.Joint.from_buffer_copy(hypotheses[-1].joint.contents))
    return n.PartInfo.from_buffer_copy(choice.part.contents), hypotheses


def _part_rows(parts: Sequence[Dict[str, Any]]) -> Tuple[Any, List[Any]]:
    """The array of dm_part_desc and what its rows point to."""
    rows, kept = (n.PartDesc * len(parts))(), []
    for row, part in zip(rows, parts):
        unknown = set(part) - {"id", "parent", "joint_type", "drag", "label", "pivot"}
        if unknown:
            raise TypeError(f"a part has no {', '.join(sorted(unknown))}")
        row.struct_size, row.id, row.parent = c.sizeof(n.PartDesc), part["id"], part.get("parent", 0)
        row.joint_type = part.get("joint_type", 0)
        if part.get("drag") is not None:
            kept.append(hint_of(part["drag"]))
            row.drag = c.pointer(kept[-1])
        if part.get("label") is not None:
            row.label = text_of(part["label"], "label")
        if part.get("pivot") is not None:
            kept.append(pivot_of(part["pivot"]))
            row.pivot = c.pointer(kept[-1])
    return rows, kept
