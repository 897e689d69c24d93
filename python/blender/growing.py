# SPDX-License-Identifier: GPL-3.0-or-later
"""A growth on a thread of its own, which can be watched and stopped."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

Progress = Callable[[str, float], None]


class _StoppedError(Exception):
    """The growth was stopped."""


class Growing:
    """A growth that has begun."""

    def __init__(self, work: Callable[[Progress], Any]) -> None:
        """Begin ``work`` on a thread of its own; it gets a function to which it reports its stage and share."""
        self.progress = ("plan", 0.0)
        self._stops = threading.Event()
        self._result: Any = None
        self._error: Exception | None = None
        self._thread = threading.Thread(target=self._run, args=(work,), daemon=True)
        self._thread.start()

    def _run(self, work: Callable[[Progress], Any]) -> None:
        try:
            self._result = work(self._report)
        except _StoppedError:
            pass
        except Exception as error:
            self._error = error

    def _report(self, stage: str, share: float) -> None:
        self.progress = (stage, share)
        if self._stops.is_set():
            raise _StoppedError

    def cancel(self) -> None:
        """Stop it at its next report."""
        self._stops.set()

    def is_alive(self) -> bool:
        """Return whether it still grows."""
        return self._thread.is_alive()

    def wait(self) -> None:
        """Wait until it has grown or failed."""
        self._thread.join()

    def result(self) -> Any:
        """Return what has grown, or None if it was stopped; raises the error with which it has failed."""
        if self._error is not None:
            raise self._error
        return self._result
