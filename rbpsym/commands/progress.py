"""A progress bar on stderr for what takes longer than a second, and nothing for what does not."""

from __future__ import annotations

import sys
from threading import Lock, Timer
from types import TracebackType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.progress import Progress as Bar

PATIENCE = 1.0  # seconds


class Progress:
    """A bar of `total` parts that appears after a second, if stderr is a terminal."""

    def __init__(self, label: str, total: int | None = None) -> None:
        self.label, self.total, self.done, self.told = label, total, 0, 0
        self._lock, self._over = Lock(), False
        self._bar: Bar | None = None
        self._timer = Timer(PATIENCE, self._show)
        self._timer.daemon = True

    def __enter__(self) -> Progress:
        if sys.stderr.isatty():
            self._timer.start()
        return self

    def __exit__(self, kind: type | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self._timer.cancel()
        with self._lock:
            self._over = True
            if self._bar:
                self._bar.stop()

    def step(self, label: str) -> None:
        """Tell what is done now; what was told before is finished."""
        with self._lock:
            self.done, self.label = self.told, label
            self.told += 1
            if self._bar:
                self._bar.update(self._bar.task_ids[0], description=label, completed=self.done)

    def counted(self, what: str, done: int, total: int) -> None:
        """So many of all are done: “12 of 40 students”."""
        with self._lock:
            self.done = self.told = done
            self.total, self.label = total, f"{done} of {total} {what}"
            if self._bar:
                self._bar.update(self._bar.task_ids[0], description=self.label, completed=done, total=total)

    def _show(self) -> None:
        from rich.console import Console
        from rich.progress import BarColumn, SpinnerColumn, TextColumn, TimeElapsedColumn
        from rich.progress import Progress as Bar

        with self._lock:
            if self._over:
                return
            columns = (SpinnerColumn(), TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn())
            self._bar = Bar(*columns, console=Console(stderr=True), transient=True)
            self._bar.add_task(self.label, total=self.total, completed=self.done)
            self._bar.start()
