"""A progress bar on a terminal, lines elsewhere."""
import sys
import time
from typing import TextIO

_WIDTH = 30
_SECONDS_BETWEEN_LINES = 10.0


class Progress:
    """How far a run is."""

    def __init__(self, total: int, out: TextIO = sys.stderr) -> None:
        self.total, self.done, self.failed, self.out = total, 0, 0, out
        self._begun = self._last = time.monotonic()

    def step(self, name: str, failed: bool) -> None:
        """One file more."""
        self.done, self.failed = self.done + 1, self.failed + failed
        now = time.monotonic()
        left = (now - self._begun) / self.done * (self.total - self.done)
        text = f"{self.done}/{self.total}, {self.failed} failed, {left:.0f} s left"
        if self.out.isatty():
            full = _WIDTH * self.done // self.total
            self.out.write(f"\r[{'#' * full}{'.' * (_WIDTH - full)}] {text}  {name[-40:]:<40}")
            if self.done == self.total:
                self.out.write("\n")
        elif self.done == self.total or now - self._last > _SECONDS_BETWEEN_LINES:
            self._last = now
            self.out.write(text + "\n")
        self.out.flush()
