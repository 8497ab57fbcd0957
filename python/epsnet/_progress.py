"""The progress of long computations, and what ends them early."""
from __future__ import annotations

import sys
import threading
import time
from contextlib import contextmanager
from types import TracebackType
from typing import Any, Callable, Iterator, Optional, Type, Union

from ._arguments import refuse

#: ``callback(what, share)``: what is being done, and the share of it that is done, from 0 to 1.
ProgressCallback = Callable[[str, float], object]
Progress = Union[None, bool, ProgressCallback]

_QUIET_SECONDS = 2.0
_thread = threading.local()


class Stopped(BaseException):
    """The work of a thread is no longer wanted."""


@contextmanager
def part_of(stop: threading.Event) -> Iterator[None]:
    """In this thread nothing shows its progress by itself, and computations end with Stopped once the event is set."""
    _thread.stop = stop
    try:
        yield
    finally:
        del _thread.stop


def poll() -> None:
    """The library calls this some twenty times a second while it computes for a thread."""
    stop = getattr(_thread, "stop", None)
    if stop is not None and stop.is_set():
        raise Stopped


class Shower:
    """A bar of tqdm, or a line on a terminal. It appears once a computation has taken two seconds.

    Used as ``with Shower(progress) as callback``; the callback goes to the library, or None.
    """

    def __init__(self, progress: Progress) -> None:
        self._callback: Optional[ProgressCallback] = None
        self._bar: Any = None
        self._start = time.monotonic()
        if callable(progress):
            self._callback = progress
        elif progress is not None and not isinstance(progress, bool):
            refuse("True, False, None or a function of what is being done and the share done", progress, "progress")
        elif progress or (progress is None and _somebody_looks()):
            self._callback = self._show

    def __enter__(self) -> Optional[ProgressCallback]:
        return self._callback

    def __exit__(self, kind: Optional[Type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]) -> None:
        if self._bar is not None:
            self._bar.close()

    def _show(self, what: str, share: float) -> None:
        if self._bar is None:
            if time.monotonic() - self._start < _QUIET_SECONDS:
                return
            self._bar = _new_bar()
        self._bar.set_description_str(what, refresh=False)
        self._bar.n = round(100 * min(max(share, 0.0), 1.0))
        self._bar.refresh()


def _somebody_looks() -> bool:
    if hasattr(_thread, "stop"):
        return False
    return "ipykernel" in sys.modules or (sys.stderr is not None and sys.stderr.isatty())


def _new_bar() -> Any:
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return _Line()
    return tqdm(total=100, leave=False, bar_format="{desc}: {percentage:3.0f} %|{bar}| {elapsed}")


class _Line:
    """A bar without tqdm: one line of a terminal."""

    def __init__(self) -> None:
        self.n = 0
        self._what = ""

    def set_description_str(self, what: str, refresh: bool = True) -> None:
        self._what = what

    def refresh(self) -> None:
        sys.stderr.write(f"\r\x1b[K{self._what}: {self.n} %")
        sys.stderr.flush()

    def close(self) -> None:
        sys.stderr.write("\r\x1b[K")
        sys.stderr.flush()
