"""A function of many surfaces."""
from __future__ import annotations

import math
import os
import threading
from concurrent.futures import Future, ThreadPoolExecutor
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING, Any, Callable, Iterable, Mapping, Optional, Sequence, Union

import numpy as np

from ._arguments import as_choice, as_index, as_items, refuse
from ._progress import Progress, Shower, part_of
from .errors import EpsnetError
from .intervals import Interval
from .surfaces import Surface

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["map", "table"]

_INTERVAL = np.dtype([("lower", "f8"), ("upper", "f8"), ("proved", "?")])
_SECONDS = 0.1


def map(
    function: Callable[[Surface], Any], surfaces: Iterable[Surface], *, workers: Optional[int] = None, on_error: str = "raise",
    progress: Progress = None,
) -> "NDArray[Any]":
    """What a function says of many surfaces, as a structured array of NumPy, a row for each surface in their order.

    The function returns a dict or a named tuple, whose names are the fields; anything else is the field ``value``. An interval becomes the
    fields ``lower``, ``upper`` (rounded outward) and ``proved``.

    >>> import epsnet
    >>> surfaces = [epsnet.Surface.octagon(seed) for seed in range(3)]
    >>> table = epsnet.map(lambda surface: {"genus": surface.genus, "systole": surface.systole()}, surfaces)
    >>> table["genus"], bool((table["systole"]["lower"] > 0.2).all()), bool(table["systole"]["proved"].all())
    (array([2, 2, 2]), True, True)

    ``workers`` threads call it at the same time, as many as there are cores by default: the library computes without Python's lock, and the
    function need not be pickled. There is one bar for all of it. An exception of the function ends the map; an EpsnetError then says which
    surface it was about. So does Ctrl-C, which stops the computations of all threads. With ``on_error="record"`` the map goes on: the array has the
    field ``error``, a text, which is empty where there was none; the other fields of such a row are nan, empty or None.
    """
    if not callable(function):
        refuse("a function of a surface", function, "function")
    items = as_items(surfaces, "surfaces", "surfaces")
    for surface in items:
        if not isinstance(surface, Surface):
            refuse("surfaces", surface, "surfaces")
    record = as_choice(on_error, "on_error", ("raise", "record")) == "record"
    count = len(os.sched_getaffinity(0)) if workers is None else as_index(workers, "workers", 1, 1024)
    return _array(_rows(function, items, count, record, progress), record)


def table(found: "NDArray[Any]") -> "dict[str, NDArray[Any]]":
    """The columns of what ``map`` returned, without fields in fields: ``pandas.DataFrame(epsnet.table(found))``.

    An interval x becomes the three columns of floats ``x``, its midpoint, which proves nothing, ``x_lower`` and ``x_upper``, rounded outward.

    >>> import epsnet
    >>> found = epsnet.map(lambda surface: {"genus": surface.genus, "systole": surface.systole()}, [epsnet.Surface.regular(g) for g in (2, 3)])
    >>> list(epsnet.table(found))
    ['genus', 'systole', 'systole_lower', 'systole_upper']
    """
    if not isinstance(found, np.ndarray) or found.dtype.names is None:
        refuse("an array that epsnet.map returned", found, "found")
    columns: "dict[str, NDArray[Any]]" = {}
    for name in found.dtype.names:
        column = found[name]
        if column.dtype == _INTERVAL:
            columns[name] = (column["lower"] + column["upper"]) / 2
            columns[f"{name}_lower"], columns[f"{name}_upper"] = column["lower"], column["upper"]
        else:
            columns[name] = column
    return columns


def _rows(
    function: Callable[[Surface], Any], surfaces: Sequence[Surface], workers: int, record: bool, progress: Progress
) -> list[Union[dict[str, Any], Exception]]:
    stop = threading.Event()

    def row(number: int) -> Union[dict[str, Any], Exception]:
        with part_of(stop):
            try:
                return _fields(function(surfaces[number]))
            except Exception as error:
                if record:
                    return error
                if isinstance(error, EpsnetError):
                    error.args = (f"surfaces[{number}]: {error}", *error.args[1:])
                raise

    pool = ThreadPoolExecutor(workers)
    with Shower(progress) as callback:
        try:
            futures = [pool.submit(row, number) for number in range(len(surfaces))]
            _wait_for(futures, callback)
        except BaseException:
            stop.set()
            pool.shutdown(wait=False, cancel_futures=True)
            raise
    pool.shutdown()
    return [future.result() for future in futures]


def _wait_for(futures: Sequence["Future[Any]"], callback: Optional[Callable[[str, float], object]]) -> None:
    """Returns when all are done; raises what the first one raises.

    It waits for a queue, not for the futures: Ctrl-C while their locks are taken would leave one of them locked, and its thread waiting for ever.
    """
    ended: "SimpleQueue[Future[Any]]" = SimpleQueue()
    for future in futures:
        future.add_done_callback(ended.put)
    done = 0
    while done < len(futures):
        try:
            ended.get(timeout=_SECONDS).result()
            done += 1
        except Empty:
            pass
        if callback is not None and (ended.empty() or done == len(futures)):
            callback(f"{done} of {len(futures)} surfaces", done / len(futures))


def _fields(value: Any) -> dict[str, Any]:
    if isinstance(value, Mapping):
        return {str(name): item for name, item in value.items()}
    if isinstance(value, tuple) and hasattr(value, "_asdict"):
        return dict(value._asdict())
    return {"value": value}


def _array(rows: Sequence[Union[dict[str, Any], Exception]], record: bool) -> "NDArray[Any]":
    fields = [row for row in rows if not isinstance(row, Exception)]
    names = list(fields[0]) if fields else []
    for row in fields:
        if list(row) != names:
            refuse(f"a function that returns the fields {names} for each surface", list(row), "function")
    columns = {name: _column([None if isinstance(row, Exception) else row[name] for row in rows]) for name in names}
    if record:
        if "error" in columns:
            refuse('a function without a field "error", where that records errors', names, "function")
        columns["error"] = np.array([f"{type(row).__name__}: {row}" if isinstance(row, Exception) else "" for row in rows], dtype=str)
    table = np.empty(len(rows), dtype=[(name, column.dtype) for name, column in columns.items()])
    for name, column in columns.items():
        table[name] = column
    return table


def _column(values: Sequence[Any]) -> "NDArray[Any]":
    """A column of the best type. None, of a surface with an error, becomes nan, or an empty text."""
    known = [x for x in values if x is not None]
    if known and all(isinstance(x, Interval) for x in known):
        return np.array([(math.nan, math.nan, False) if x is None else (x.lower, x.upper, x.proved) for x in values], dtype=_INTERVAL)
    if known and all(isinstance(x, (bool, int, float, complex, str, np.generic)) for x in known):
        missing = "" if all(isinstance(x, str) for x in known) else math.nan
        return np.array([missing if x is None else x for x in values])
    column = np.empty(len(values), dtype=object)
    for k, x in enumerate(values):
        column[k] = x
    return column
