"""Closed geodesics: systole, length spectrum, small curves."""
from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Iterator, NamedTuple, Optional, Sequence, Union, overload

from . import _epsnet
from ._progress import Progress, Shower
from .certificates import Certificate, Proof, checked
from .intervals import Interval
from .isometries import Isometry
from .surfaces import Number, Path, Surface, as_index, length_text

if TYPE_CHECKING:
    from .nets import Net

__all__ = ["ClosedGeodesic", "ClosedGeodesics", "Multiplicity", "Piece", "Systole", "ThickThin"]


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


class Piece(NamedTuple):
    """A component of the surface without its small curves."""

    genus: int
    #: The small curves around it, by their numbers, with the side on which the piece lies, "left" or "right".
    boundaries: list[tuple[int, str]]


class ClosedGeodesic:
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
        #: Its length.
        self.length = Interval(*length, proved=geodesics.proved)
        #: Whether it has no self-intersections.
        self.simple = simple

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
        core = self._geodesics._core
        return core.net.svg(self._vertex, True, False, False, False, "none", False, size, self._layers_on(core.net))

    def _layers_on(self, net: "_epsnet.Net") -> list["_epsnet.Layer"]:
        return [net.geodesic_layer(self._geodesics._core, self.number)]

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        return f"<ClosedGeodesic of length {self.length}{'' if self.simple else ', not simple'}>"


class ClosedGeodesics(Sequence[ClosedGeodesic]):
    """A list of closed geodesics that is proved to be complete, ordered by length."""

    def __init__(self, core: "_epsnet.Geodesics", surface: Optional[Surface], certificate: Optional[Certificate]) -> None:
        self._core = core
        self._surface = surface
        self._proof = Proof(core, certificate)
        self._list = [ClosedGeodesic(self, number, *row) for number, row in enumerate(core.geodesics)]

    @property
    def certificate(self) -> Certificate:
        """The certificate of the list."""
        return self._proof.certificate

    @property
    def proved(self) -> bool:
        """Whether the list was checked and verified."""
        return self._proof.proved

    @property
    def surface(self) -> Surface:
        """The surface."""
        if self._surface is None:
            self._surface = Surface._of(self._core.net.surface)
        return self._surface

    @property
    def up_to(self) -> str:
        """The length up to which a spectrum is complete, as it was given."""
        return self._core.up_to

    @property
    def net(self) -> "Net":
        """The net on which the list is proved."""
        from .nets import Net

        return Net(self._core.net, self._surface, None, None)

    def save(self, path: Path) -> None:
        """Writes a geodesics file, completely or not at all: for ``epsnet.load``, and for the program ``certify``."""
        self._core.save(os.fspath(path))

    def multiplicities(self) -> list[Multiplicity]:
        """The list, grouped by length."""
        result = []
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
        """All of them on the triangulation of a net of the surface."""
        centre = self._list[0]._vertex if self._list else 0
        return self._core.net.svg(centre, True, False, False, False, "none", False, size, self._layers_on(self._core.net))

    def _layers_on(self, net: "_epsnet.Net") -> list["_epsnet.Layer"]:
        return net.geodesics_layers(self._core)

    def _repr_svg_(self) -> str:
        return self.svg()

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


class Systole(Interval):
    """The length of a shortest closed geodesic, as an interval, with the geodesic."""

    __slots__ = ("_geodesics",)

    def __init__(self, geodesics: ClosedGeodesics) -> None:
        ends = geodesics[0].length.ends
        super().__init__(*ends, proved=geodesics.proved)
        self._geodesics = geodesics

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

    def _layers_on(self, net: "_epsnet.Net") -> list["_epsnet.Layer"]:
        return self._geodesics._layers_on(net)

    def _repr_svg_(self) -> str:
        return self._geodesics._repr_svg_()


_EPSILON = "1"  # Of the net from which a search starts; any gives the same list.


def _found(surface: Surface, progress: Progress, threads: int, what: str, find: Callable[[Any], "_epsnet.Geodesics"]) -> tuple["_epsnet.Geodesics", Certificate]:
    with Shower(progress) as callback:
        core = find(callback)
    return core, checked(core, progress, threads, subject=what)


def systole(surface: Surface, threads: int, progress: Progress) -> Systole:
    core, certificate = _found(
        surface, progress, threads, "systole", lambda callback: _epsnet.Geodesics.systole(surface._core, _EPSILON, as_index(threads, "threads", 0, 1024), callback)
    )
    return Systole(ClosedGeodesics(core, surface, certificate))


def spectrum(surface: Surface, up_to: Number, threads: int, progress: Progress) -> ClosedGeodesics:
    text = length_text(up_to, "up_to")
    core, certificate = _found(
        surface, progress, threads, "spectrum", lambda callback: _epsnet.Geodesics.spectrum(surface._core, text, _EPSILON, as_index(threads, "threads", 0, 1024), callback)
    )
    return ClosedGeodesics(core, surface, certificate)


def thick_thin(surface: Surface, threads: int, progress: Progress) -> ThickThin:
    core, certificate = _found(
        surface, progress, threads, "thick-thin decomposition", lambda callback: _epsnet.Geodesics.thick_thin(surface._core, _EPSILON, as_index(threads, "threads", 0, 1024), callback)
    )
    return ThickThin(core, surface, certificate)
