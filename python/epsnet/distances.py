"""Distances between points, eccentricities, the diameter, the largest embedded disk."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Optional

from . import _epsnet
from ._progress import Progress, Shower
from ._svg import polygon_svg
from .certificates import Certificate, Proof, checked
from .domains import DirichletDomain
from .intervals import Interval
from .isometries import Gaussian, Isometry
from .surfaces import Number, Path, Point, PointLike, Surface, as_fraction

if TYPE_CHECKING:
    from .nets import Net

__all__ = ["Cover", "Diameter", "Distance", "Eccentricity", "EmbeddedDisk"]


class _Measured(Interval):
    """A number of a surface as an interval, with the document that proves it."""

    __slots__ = ("_core", "_surface", "_proof")

    def __init__(self, core: Any, surface: Optional[Surface], certificate: Optional[Certificate], value: tuple[float, float]) -> None:
        self._core = core
        self._surface = surface
        self._proof = Proof(core, certificate)
        super().__init__(*value, proved=self._proof.proved)

    @property
    def certificate(self) -> Certificate:
        """The certificate."""
        return self._proof.certificate

    @property
    def surface(self) -> Surface:
        """The surface."""
        if self._surface is None:
            self._surface = Surface._of(self._core.net.surface)
        return self._surface

    @property
    def net(self) -> "Net":
        """The one-vertex net on which the number is proved."""
        from .nets import Net

        return Net(self._core.net, self._surface, None, None)

    def save(self, path: Path) -> None:
        """Writes the file that proves it, completely or not at all: for ``epsnet.load``, and for the program ``certify``."""
        self._core.save(os.fspath(path))


class Distance(_Measured):
    """The distance between two points p and q, as an interval, with all geodesics between them of length up to its upper end.

    >>> import epsnet
    >>> bolza = epsnet.Surface.regular(2)
    >>> d = bolza.distance((0, "0.5", 0), (0, "-0.5", 0))
    >>> d
    <Distance [0.85991726162577686, 0.859917261625777]>
    >>> d.paths
    [(0,)]
    """

    __slots__ = ("_reverse",)

    def __init__(self, core: "_epsnet.Distance", surface: Optional[Surface], certificate: Optional[Certificate], reverse: bool = False) -> None:
        super().__init__(core, surface, certificate, core.value)
        self._reverse = reverse

    @property
    def paths(self) -> list[tuple[int, ...]]:
        """The geodesics, as the sides that they cross on the way from p to q."""
        paths = self._core.paths
        if self._reverse:
            paths = [_epsnet.reversed_word(self.surface._core, word) for word in paths]
        return [tuple(word) for word in paths]

    @property
    def equal(self) -> bool:
        """Whether all paths have exactly equal length, so that all are shortest; False claims nothing."""
        equal: bool = self._core.equal
        return equal and self.proved

    def svg(self, size: int = 500) -> str:
        """The paths in the Dirichlet domain of p, which is in the centre; of q, if p is not strictly inside its tile."""
        _, (x, y) = base = self._core.net.charts[0]
        centre, (_, z) = Gaussian(x, y), self._core.point
        ends = []
        for word in self._core.paths:
            lift = Isometry(self.surface, word).inverse()
            end = lift(Gaussian(*z) if lift.is_exact else complex(Gaussian(*z)))
            ends.append(complex((end - centre) / (1 - centre.conjugate() * end)) if isinstance(end, Gaussian) else _moved(end, complex(centre)))
        return polygon_svg(DirichletDomain(self.surface, base).vertices, size, ends)

    def _layers_on(self, net: "_epsnet.Net") -> list["_epsnet.Layer"]:
        return [net.distance_layer(self._core)]

    def _repr_svg_(self) -> str:
        return self.svg()


def _moved(z: complex, to_centre: complex) -> complex:
    return (z - to_centre) / (1 - to_centre.conjugate() * z)


class Cover(_Measured):
    """The maximum of a function on a surface, as an interval, proved cell by cell."""

    __slots__ = ()

    def __init__(self, core: "_epsnet.Cover", surface: Optional[Surface], certificate: Optional[Certificate]) -> None:
        super().__init__(core, surface, certificate, core.value)

    @property
    def cells(self) -> int:
        """The number of cells into which the surface was cut."""
        cells: int = self._core.cells
        return cells

    @property
    def triangulations(self) -> int:
        """The number of triangulations that bound the function on the cells."""
        triangulations: int = self._core.triangulations
        return triangulations

    @property
    def point(self) -> Point:
        """A point where the function is at least the lower end."""
        tile, (x, y) = self._core.net.charts[0]
        return Point(tile, x, y)


class Diameter(Cover):
    """The greatest distance of two points of a surface, as an interval."""

    __slots__ = ()


class EmbeddedDisk(Cover):
    """The radius of the largest embedded disk of a surface, as an interval; its centre is near ``point``."""

    __slots__ = ()


class Eccentricity(Interval):
    """The greatest distance of a point of the surface from a given one, as an interval."""

    __slots__ = ("net",)

    def __init__(self, net: "Net") -> None:
        #: The net with that point as its one vertex; its largest circumradius is the eccentricity.
        self.net = net
        value = net.certificate.enclosures["largest_circumradius"]
        super().__init__(*value.ends, proved=value.proved)

    @property
    def certificate(self) -> Certificate:
        """The certificate of the net."""
        return self.net.certificate


def distance(surface: Surface, p: PointLike, q: PointLike, width: Number) -> Distance:
    start, end = surface._base(p), surface._base(q)
    core = _epsnet.Distance.measure(surface._core, start, end, float(as_fraction(width, "width")))
    certificate = checked(core, False, subject="distance")
    # Measured from q, if p is not strictly inside of its tile.
    return Distance(core, surface, certificate, reverse=core.point == start and core.point != end)


def diameter(surface: Surface, width: Number, progress: Progress) -> Diameter:
    with Shower(progress) as callback:
        core = _epsnet.Cover.diameter(surface._core, float(as_fraction(width, "width")), callback)
    return Diameter(core, surface, checked(core, progress, subject="diameter"))


def embedded_disk(surface: Surface, width: Number, progress: Progress) -> EmbeddedDisk:
    with Shower(progress) as callback:
        core = _epsnet.Cover.embedded_disk(surface._core, float(as_fraction(width, "width")), callback)
    return EmbeddedDisk(core, surface, checked(core, progress, subject="largest embedded disk"))


def eccentricity(surface: Surface, p: PointLike) -> Eccentricity:
    from .nets import Net

    core = _epsnet.eccentricity_net(surface._core, surface._base(p))
    return Eccentricity(Net(core, surface, checked(core, False, subject="eccentricity"), None))
