"""Closed geodesics: systole, length spectrum, small curves."""
from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Callable, Iterator, List, NamedTuple, Optional, Sequence, Union, overload

import numpy as np

from . import _epsnet
from ._annotations import Surface
from ._arguments import Number, Path, as_index, as_threads, length_text
from ._documents import Document
from ._pictures import Drawn
from ._progress import Progress, Shower
from .certificates import Certificate
from .intervals import Interval, ends
from .isometries import Isometry
from .nets import Net

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["ClosedGeodesic", "ClosedGeodesics", "Multiplicities", "Multiplicity", "Piece", "Systole", "ThickThin"]


@dataclass(frozen=True)
class Multiplicity:
    """Closed geodesics whose lengths the enclosures cannot distinguish."""

    #: An interval that contains all of their lengths.
    length: Interval
    #: How many there are.
    count: int
    #: Whether their lengths are exactly equal, which is decided exactly; False claims nothing.
    equal: bool
    #: The geodesics.
    geodesics: list["ClosedGeodesic"]


class Multiplicities(List[Multiplicity]):
    """A list of closed geodesics, grouped by length: a list of Multiplicity, and its columns as arrays."""

    @property
    def lengths(self) -> "NDArray[np.float64]":
        """The lengths, rounded outward: a row (lower, upper) for each group."""
        return ends(multiplicity.length for multiplicity in self)

    @property
    def counts(self) -> "NDArray[np.int64]":
        """The number of geodesics of each group."""
        return np.array([multiplicity.count for multiplicity in self], dtype=np.int64)

    @property
    def equal(self) -> "NDArray[np.bool_]":
        """Whether the lengths in each group are exactly equal; False claims nothing."""
        return np.array([multiplicity.equal for multiplicity in self], dtype=np.bool_)


class Piece(NamedTuple):
    """A component of the surface without its small curves."""

    genus: int
    #: The small curves around it, by their numbers, with the side on which the piece lies, "left" or "right".
    boundaries: list[tuple[int, str]]


class ClosedGeodesic(Drawn):
    """A primitive closed geodesic, up to orientation."""

    def __init__(self, geodesics: "ClosedGeodesics", number: int, vertex: int, tile: int, word: Sequence[int], length: tuple[float, float], simple: bool) -> None:
        self._geodesics = geodesics
        self._vertex = vertex
        #: Its number in the list.
        self.number = number
        #: The tile where its word starts and ends.
        self.tile = tile
        #: The sides that a loop crosses that is freely homotopic to it.
        self.word = tuple(word)
        self._length = length
        #: Whether it has no self-intersections.
        self.simple = simple

    @property
    def length(self) -> Interval:
        """Its length."""
        return Interval(*self._length, proved=self._geodesics.proved)

    @property
    def isometry(self) -> Isometry:
        """The element of the group that translates along a lift of it: matrices, exact and enclosed."""
        return Isometry(self._geodesics.surface, self.word)

    @property
    def collar_half_width(self) -> Interval:
        """w with sinh w = 1/sinh(ℓ/2): the collar of that half-width is embedded if the geodesic is simple (Keen's collar theorem)."""
        return Interval(*_epsnet.collar_half_width((self.length.lower, self.length.upper)), proved=self.length.proved)

    def svg(self, size: int = 600) -> str:
        """The geodesic on the triangulation of a net of the surface, with a vertex near it in the centre."""
        return self._geodesics.net.svg(centre=self._vertex, vertices=False, size=size, show=[self])

    def _layers_on(self, net: "_epsnet.Net") -> list["_epsnet.Layer"]:
        return [net.geodesic_layer(self._geodesics._core, self.number)]

    def __eq__(self, other: object) -> bool:
        """Whether both are the same entry of equal lists."""
        return isinstance(other, ClosedGeodesic) and self.number == other.number and self._geodesics == other._geodesics

    def __hash__(self) -> int:
        return hash((self.number, self.word))

    def __reduce__(self) -> tuple[Any, ...]:
        return ClosedGeodesics.__getitem__, (self._geodesics, self.number)

    def __repr__(self) -> str:
        return f"<ClosedGeodesic of length {self.length}{'' if self.simple else ', not simple'}>"


class ClosedGeodesics(Drawn, Document, Sequence[ClosedGeodesic]):
    """A list of closed geodesics that is proved to be complete, ordered by length."""

    _core: "_epsnet.Geodesics"

    def __init__(self, core: "_epsnet.Geodesics", surface: Optional["Surface"], certificate: Optional[Certificate]) -> None:
        self._hold(core, surface, certificate)
        self._list = [ClosedGeodesic(self, number, *row) for number, row in enumerate(core.geodesics)]

    @property
    def up_to(self) -> str:
        """The length up to which a spectrum is complete, as it was given."""
        return self._core.up_to

    @cached_property
    def net(self) -> Net:
        """The net on which the list is proved."""
        return Net(self._core.net, self._surface, None)

    @property
    def lengths(self) -> "NDArray[np.float64]":
        """The lengths as an array, rounded outward: a row (lower, upper) for each geodesic.

        >>> import epsnet
        >>> epsnet.Surface.regular(2).spectrum("3.1").lengths.shape
        (12, 2)
        """
        return ends(geodesic.length for geodesic in self)

    def multiplicities(self) -> Multiplicities:
        """The list, grouped by length.

        >>> import epsnet
        >>> epsnet.Surface.regular(2).spectrum("4.9").multiplicities().counts
        array([12, 12])
        """
        result = Multiplicities()
        for first, count, equal in self._core.clusters:
            run = self._list[first:first + count]
            length = Interval(min(g.length.ends[0] for g in run), max(g.length.ends[1] for g in run), proved=self.proved)
            result.append(Multiplicity(length, count, equal and self.proved, run))
        return result

    @overload
    def __getitem__(self, index: int) -> ClosedGeodesic: ...

    @overload
    def __getitem__(self, index: slice) -> list[ClosedGeodesic]: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[ClosedGeodesic, list[ClosedGeodesic]]:
        return self._list[index]

    def __len__(self) -> int:
        return len(self._list)

    def __iter__(self) -> Iterator[ClosedGeodesic]:
        return iter(self._list)

    def svg(self, size: int = 600) -> str:
        """All of them, the shortest 200 at most, in a Dirichlet domain of the surface."""
        return self._core.svg(as_index(size, "size", 50, 20000))

    def _layers_on(self, net: "_epsnet.Net") -> list["_epsnet.Layer"]:
        return net.geodesics_layers(self._core)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ClosedGeodesics) and bool(self._core == other._core)

    def __hash__(self) -> int:
        return hash((len(self), self.up_to))

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {len(self)} up to length {self.up_to}{'' if self.proved else ', not proved'}>"


class ThickThin(ClosedGeodesics):
    """The small curves of a surface, of length at most 2 arsinh 1, and the pieces into which they cut it."""

    @property
    def pieces(self) -> list[Piece]:
        """The components of the surface without the small curves."""
        return [Piece(genus, [(geodesic, "right" if side else "left") for geodesic, side in boundaries]) for genus, boundaries in self._core.pieces]

    def __repr__(self) -> str:
        return f"<ThickThin: {len(self)} small curves{'' if self.proved else ', not proved'}>"


class LocalMaximum(ClosedGeodesics):
    """That the systole of a surface is greater than those of all other surfaces nearby: its shortest closed geodesics, and those hardly longer."""

    @property
    def systoles(self) -> list[ClosedGeodesic]:
        """The shortest closed geodesics, of exactly equal length."""
        return self._list[:self._core.clusters[0][1]]

    def __repr__(self) -> str:
        return f"<LocalMaximum: {len(self.systoles)} systoles{'' if self.proved else ', not proved'}>"


_KINDS = {"thick-thin": ThickThin, "local-maximum": LocalMaximum}


def list_of(core: "_epsnet.Geodesics", surface: Optional["Surface"], certificate: Optional[Certificate]) -> ClosedGeodesics:
    """The list of a file, by its claim."""
    return _KINDS.get(core.claim, ClosedGeodesics)(core, surface, certificate)


class Systole(Drawn, Interval):
    """The length of a shortest closed geodesic, as an interval, with the geodesic."""

    __slots__ = ("_geodesics",)

    def __init__(self, geodesics: ClosedGeodesics) -> None:
        super().__init__(*geodesics[0].length.ends)
        self._geodesics = geodesics

    @property
    def proved(self) -> bool:
        """Whether the checker has verified it."""
        return self._geodesics.proved

    @property
    def surface(self) -> "Surface":
        """The surface."""
        return self._geodesics.surface

    @property
    def geodesic(self) -> ClosedGeodesic:
        """A closed geodesic of that length: its word, its matrices, its picture."""
        return self._geodesics[0]

    @property
    def certificate(self) -> Certificate:
        """The certificate."""
        return self._geodesics.certificate

    def save(self, path: Path) -> None:
        """Writes a geodesics file, completely or not at all: for ``epsnet.load``, and for the program ``certify``."""
        self._geodesics.save(path)

    def svg(self, size: int = 600) -> str:
        """The geodesic in a Dirichlet domain of the surface."""
        return self._geodesics.svg(size)

    def _layers_on(self, net: "_epsnet.Net") -> list["_epsnet.Layer"]:
        return self._geodesics._layers_on(net)

    def __reduce__(self) -> tuple[Any, ...]:
        return Systole, (self._geodesics,)


_EPSILON = "1"  # Of the net from which a search starts; any gives the same list.


def _found(surface: "Surface", progress: Progress, find: Callable[[Any], tuple["_epsnet.Geodesics", "_epsnet.Certificate"]]) -> ClosedGeodesics:
    with Shower(progress) as callback:
        core, certificate = find(callback)
    return list_of(core, surface, Certificate(certificate))


def systole(surface: "Surface", threads: int, progress: Progress) -> Systole:
    threads = as_threads(threads)
    return Systole(_found(surface, progress, lambda callback: _epsnet.Geodesics.systole(surface._core, _EPSILON, threads, callback)))


def spectrum(surface: "Surface", up_to: Number, threads: int, progress: Progress) -> ClosedGeodesics:
    text = length_text(up_to, "up_to")
    threads = as_threads(threads)
    return _found(surface, progress, lambda callback: _epsnet.Geodesics.spectrum(surface._core, text, _EPSILON, threads, callback))


def thick_thin(surface: "Surface", threads: int, progress: Progress) -> ThickThin:
    threads = as_threads(threads)
    found = _found(surface, progress, lambda callback: _epsnet.Geodesics.thick_thin(surface._core, _EPSILON, threads, callback))
    assert isinstance(found, ThickThin)
    return found


def local_maximum(surface: "Surface", threads: int, progress: Progress) -> LocalMaximum:
    threads = as_threads(threads)
    found = _found(surface, progress, lambda callback: _epsnet.Geodesics.local_maximum(surface._core, _EPSILON, threads, callback))
    assert isinstance(found, LocalMaximum)
    return found
