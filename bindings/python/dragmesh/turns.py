"""Keeps the calls of one context apart: no order of calls, ends, threads and callbacks may free what a call uses."""
import threading
from typing import Any, Callable, List, Optional


class Turns:
    """Short calls take turns. Long ones, which make something, run side by side with all others."""

    def __init__(self) -> None:
        self._gate = threading.Lock()  # held by the short call that runs
        self._counts = threading.Lock()  # of the three below, and of Owned.uses
        self._running = 0
        self._closed = False
        self._forgotten: List[Callable[[], Any]] = []
        self._thread = threading.local()

    def run(self, call: Callable[[], Any], used: Any = None, beside: bool = False) -> Any:
        """Calls, and answers what it answers. used: what must not end meanwhile; beside: a long call."""
        if self._is_inside():
            raise RuntimeError("a callback must not call the context that calls it")
        self._begin(used)
        self._thread.inside = True
        try:
            if beside:
                return call()
            with self._gate:
                return call()
        finally:
            self._thread.inside = False
            self._end(used)

    def end(self, owned: Any, call: Callable[[], Any]) -> None:
        """Ends something, unless a long call uses it."""

        def unless_used() -> None:
            with self._counts:
                if owned.uses:
                    raise RuntimeError(f"the {type(owned).__name__} is in use")
                call()

        self.run(unless_used)

    def forget(self, call: Callable[[], Any]) -> None:
        """Ends something that nothing refers to. The collector comes at any time, also in callbacks: then after the call
        that runs."""
        if self._is_inside() or not self._gate.acquire(blocking=False):
            self._forgotten.append(call)
            return
        try:
            if not self._closed:
                call()
        finally:
            self._gate.release()

    def close(self, destroy: Callable[[], Any], waits: bool) -> bool:
        """Ends the context. False: a call runs. waits: for short calls of other threads."""
        if self._is_inside() or not self._gate.acquire(blocking=waits):
            return False
        try:
            with self._counts:
                if self._running:
                    return False
                self._closed = True
                destroy()
                return True
        finally:
            self._gate.release()

    def _is_inside(self) -> bool:
        return getattr(self._thread, "inside", False)

    def _begin(self, used: Optional[Any]) -> None:
        with self._counts:
            if self._closed:
                raise ValueError("the context is closed")
            self._running += 1
            if used is not None:
                used.uses += 1

    def _end(self, used: Optional[Any]) -> None:
        with self._counts:
            self._running -= 1
            if used is not None:
                used.uses -= 1
        while self._forgotten:
            self.forget(self._forgotten.pop())
