"""Eigenvalues of the Laplacian."""
from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, Iterable, List, Optional, Sequence, Tuple, Union, overload

import numpy as np

from . import _epsnet
from ._annotations import Surface
from ._arguments import Number, as_choice, as_fraction, as_index, as_items, as_threads, length_text, refuse
from ._documents import Document
from ._immutable import Immutable
from ._pictures import Drawn
from ._progress import Progress, Shower
from .certificates import Certificate
from .errors import ArgumentError
from .intervals import Interval
from .nets import Net

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

__all__ = ["Bands", "Eigenfunction", "EigenvalueEnclosure", "Eigenvalues"]


@dataclass(frozen=True)
class EigenvalueEnclosure:
    """Eigenvalues that follow each other, counted with multiplicity: λ_first and those after it, ``count`` in all, are in ``interval``."""

    #: Contains them.
    interval: Interval
    #: The number of the first one; 1 is that of the least eigenvalue of the surface but 0. With phases 0 is that of the least one.
    first: int
    #: There are so many.
    count: int


class Eigenfunction(Drawn, Immutable):
    """A function around each vertex of a net, which nearly fit together: near an eigenfunction. Its values are rounded, not proved."""

    def __init__(self, eigenvalues: "Eigenvalues", index: int) -> None:
        try:
            lower, upper, values = eigenvalues._core.eigenfunction(index)
        except IndexError as error:
            raise ArgumentError(str(error), place="index") from None
        self._eigenvalues = eigenvalues
        self._index = index
        self._interval = Interval(lower, upper, proved=eigenvalues.proved)
        self._values: "Floats" = np.array(values)
        self._values.flags.writeable = False

    @property
    def index(self) -> int:
        """The number of its eigenvalue, from 1 on."""
        return self._index

    @property
    def interval(self) -> Interval:
        """Contains its eigenvalue."""
        return self._interval

    @property
    def net(self) -> Net:
        """The net around whose vertices it is given."""
        return self._eigenvalues.net

    @property
    def at_vertices(self) -> "Floats":
        """Its values at the vertices of the net, rounded; read-only. The function may be multiplied by any number."""
        return self._values

    def svg(self, *, centre: int = 0, order: str = "weight", size: int = 600) -> str:
        """A picture: one lift of every triangle of the net in the Poincaré disk, coloured by the values, with the lines where it is 0.

        ``centre``: the vertex in the centre; ``order``: "weight" or "breadth first", as for ``Net.lifts``; ``size``: in pixels.
        """
        breadth_first = as_choice(order, "order", ("weight", "breadth first")) == "breadth first"
        core = self._eigenvalues._core
        return core.eigenfunction_svg(self._index, as_index(centre, "centre"), breadth_first, as_index(size, "size", 50, 20000))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Eigenfunction) and self._index == other._index and self._eigenvalues == other._eigenvalues

    def __hash__(self) -> int:
        return hash((self._eigenvalues, self._index))

    def __repr__(self) -> str:
        return f"<Eigenfunction of λ_{self._index} in {self._interval}>"


class Eigenvalues(Drawn, Document, Sequence[EigenvalueEnclosure]):
    """The first eigenvalues of the Laplacian, with multiplicity, in increasing order. 0, of the constant functions, is left out; with phases
    all are counted."""

    _core: "_epsnet.Eigenvalues"

    def __init__(self, core: "_epsnet.Eigenvalues", surface: Optional["Surface"], certificate: Optional[Certificate]) -> None:
        self._hold(core, surface, certificate)

    @cached_property
    def _rows(self) -> List[EigenvalueEnclosure]:
        proved, rows, first = self.proved, [], 0 if self.phases else 1
        for ends, count in self._core.enclosures:
            rows.append(EigenvalueEnclosure(Interval(*ends, proved=proved), first, count))
            first += count
        return rows

    @property
    def next(self) -> float:
        """All eigenvalues after those of the rows are at least this number."""
        return self._core.next

    @cached_property
    def phases(self) -> Tuple[Fraction, ...]:
        """The phase of each side of the surface, in turns; empty for the eigenvalues of functions on the surface."""
        return tuple(Fraction(phase) for phase in self._core.phases)

    @cached_property
    def box(self) -> Optional[Fraction]:
        """The intervals hold for all phases that are at most so many turns from these, each of the 2g; None: for these alone."""
        return None if self._core.box is None else Fraction(self._core.box)

    def count_below(self, x: Number) -> Tuple[int, Optional[int]]:
        """At least and at most so many eigenvalues are less than x, which is rounded to a float; None if nothing is known of how many at most."""
        return self._core.count_below(float(min(max(as_fraction(x, "x"), Fraction(-(10**9))), Fraction(10**9))))

    @cached_property
    def net(self) -> Net:
        """The net on which the eigenvalues are counted."""
        return Net(self._core.net, self._surface, None)

    def eigenfunction(self, index: int) -> Eigenfunction:
        """The eigenfunction of λ_index, from 1 on. Where several eigenvalues are in one interval, its functions are those of a basis, in no order.
        ArgumentError if there is none: what was computed with at most 2 digits has no eigenfunctions."""
        return Eigenfunction(self, as_index(index, "index", 1))

    def svg(self, size: int = 600) -> str:
        """The intervals, and how many eigenvalues are below each place, at least and at most, as SVG of this width."""
        return self._core.svg(as_index(size, "size", 50, 20000))

    def __len__(self) -> int:
        return len(self._rows)

    @overload
    def __getitem__(self, place: int) -> EigenvalueEnclosure: ...
    @overload
    def __getitem__(self, place: slice) -> List[EigenvalueEnclosure]: ...
    def __getitem__(self, place: Union[int, slice]) -> Union[EigenvalueEnclosure, List[EigenvalueEnclosure]]:
        return self._rows[place]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Eigenvalues) and bool(self._core == other._core)

    def __hash__(self) -> int:
        return hash((self.next, len(self)))

    def __repr__(self) -> str:
        counts = ", ".join(str(row.count) for row in self)
        others = f"{'; all others' if counts else 'all'} at least {self.next}"
        return f"<Eigenvalues: {counts}{others}{'' if self.proved else ' (not proved)'}>"


def _below(x: Number, name: str) -> float:
    value = as_fraction(x, name)
    if not 0 < value <= 10**4 or float(value) == 0:
        refuse("a positive number of at most 10000", x, name)
    return float(value)


class Bands(Drawn, Immutable):
    """The first eigenvalues with phases at points of the torus of characters, each in a proved interval."""

    def __init__(self, points: List[List[Fraction]], rows: List[List[Tuple[float, float]]]) -> None:
        self._points = tuple(tuple(point) for point in points)
        self._rows = rows
        both = np.array(rows, dtype=np.float64).reshape(len(points), -1, 2)
        both.flags.writeable = False
        self._lower, self._upper = both[:, :, 0], both[:, :, 1]

    @property
    def points(self) -> Tuple[Tuple[Fraction, ...], ...]:
        """The points, each as 2g numbers of turns."""
        return self._points

    @property
    def lower(self) -> "Floats":
        """By point and band, the lower ends of the intervals; read-only. Band n is that of λ_n, from 0 on."""
        return self._lower

    @property
    def upper(self) -> "Floats":
        """The upper ends likewise."""
        return self._upper

    def interval(self, point: int, band: int) -> Interval:
        """The proved interval that contains λ_band at a point."""
        lower, upper = self._rows[as_index(point, "point", 0, len(self) - 1)][as_index(band, "band", 0, self._lower.shape[1] - 1)]
        return Interval(lower, upper, proved=True)

    def svg(self, size: int = 600) -> str:
        """The bands along the path, as SVG of this width."""
        return _epsnet.bands_svg(self._rows, as_index(size, "size", 50, 20000))

    def __len__(self) -> int:
        return len(self._points)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Bands) and self._points == other._points and self._rows == other._rows

    def __hash__(self) -> int:
        return hash(self._points)

    def __repr__(self) -> str:
        return f"<Bands: {self._lower.shape[1]} at {len(self)} points>"


def torus_point(surface: "Surface", x: Any, name: str) -> List[Fraction]:
    """2g numbers of turns."""
    point = [as_fraction(turns, name) for turns in as_items(x, name, "a sequence of numbers of turns")]
    sides = _epsnet.character_sides(surface._core)
    if len(point) != len(sides):
        refuse(f"{len(sides)} phases, those of the sides {', '.join(map(str, sides))}", x, name)
    return point


def _turns(x: Number, name: str) -> Fraction:
    """A distance of phases."""
    value = as_fraction(x, name)
    if not 0 < value <= Fraction(1, 2):
        refuse("a number of turns, more than 0 and at most 1/2", x, name)
    return value


def gap(surface: "Surface", outside: Number, at_least: Number, most: int, epsilon: Optional[Number], threads: int, progress: Progress) -> int:
    radius = _turns(outside, "outside")
    if radius == Fraction(1, 2):
        raise ArgumentError("no phase is farther than 1/2 from an integer", place="outside")
    bound = _below(at_least, "at_least")
    number = as_index(most, "most", 1, 10**8)
    length = None if epsilon is None else length_text(epsilon, "epsilon")
    threads = as_threads(threads)
    with Shower(progress) as callback:
        return _epsnet.gap_outside(surface._core, radius, bound, number, length, threads, callback)


def side_phases(surface: "Surface", phases: Sequence[Number]) -> Tuple[Fraction, ...]:
    return tuple(_epsnet.phases_of_sides(surface._core, torus_point(surface, phases, "phases")))


def bands(
    surface: "Surface", path: Iterable[Sequence[Number]], steps: int, count: int, digits: Optional[int], epsilon: Optional[Number], threads: int,
    progress: Progress
) -> Bands:
    corners = [torus_point(surface, corner, "path") for corner in as_items(path, "path", "a sequence of points")]
    if not corners:
        refuse("at least one point", path, "path")
    points = _epsnet.torus_path(corners, as_index(steps, "steps", 1, 10000))
    number = as_index(count, "count", 1, 1000)
    precision = None if digits is None else as_index(digits, "digits", 1, 3)
    length = None if epsilon is None else length_text(epsilon, "epsilon")
    threads = as_threads(threads)
    with Shower(progress) as callback:
        return Bands(points, _epsnet.bands(surface._core, points, number, precision, length, threads, callback))


def eigenvalues(
    surface: "Surface", count: Optional[int], below: Optional[Number], digits: Optional[int], epsilon: Optional[Number],
    phases: Optional[Sequence[Number]], box: Optional[Number], threads: int, progress: Progress
) -> Eigenvalues:
    number = None if count is None else as_index(count, "count", 1, 1000)
    bound = None if below is None else _below(below, "below")
    if count is not None and below is not None:
        raise ArgumentError("not together with count", place="below")
    precision = None if digits is None else as_index(digits, "digits", 1, 10 if phases is None else 3)
    length = None if epsilon is None else length_text(epsilon, "epsilon")
    point = [] if phases is None else torus_point(surface, phases, "phases")
    if box is not None and phases is None:
        raise ArgumentError("only with phases", place="box")
    around = None if box is None else _turns(box, "box")
    threads = as_threads(threads)
    with Shower(progress) as callback:
        core, certificate = _epsnet.Eigenvalues.find(surface._core, number, bound, precision, length, point, around, threads, callback)
    return Eigenvalues(core, surface, Certificate(certificate))
