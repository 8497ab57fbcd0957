"""Distances between points, eccentricities, the diameter, the radius, the largest embedded disk."""
from __future__ import annotations

from functools import cached_property
from typing import Any, Optional

from . import _epsnet
from ._annotations import Surface
from ._arguments import Number, as_fraction, as_index, as_threads, refuse
from ._documents import Core, Document
from ._pictures import Drawn
from ._progress import Progress, Shower
from .certificates import Certificate
from .intervals import Interval, arcosh
from .isometries import Isometry
from .nets import Net
from .points import BasePoint, Point, PointLike, base_point, point_of

__all__ = ["Cover", "Diameter", "Distance", "Eccentricity", "EmbeddedDisk", "PointLoop", "Radius"]


class _Measured(Document, Interval):
    """A number of a surface as an interval, with the document that proves it."""

    def __init__(self, core: Core, surface: Optional["Surface"], certificate: Optional[Certificate]) -> None:
        self._hold(core, surface, certificate)
        Interval.__init__(self, *self._core.value)

    @cached_property
    def net(self) -> Net:
        """The one-vertex net on which the number is proved."""
        return Net(self._core.net, self._surface, None)


class Distance(Drawn, _Measured):
    """The distance between two points p and q, as an interval, with all geodesics between them of length up to its upper end.

    >>> import epsnet
    >>> bolza = epsnet.Surface.regular(2)
    >>> d = bolza.distance((0, "0.5", 0), (0, "-0.5", 0))
    >>> d
    <Distance [0.85991726162577686, 0.859917261625777]>
    >>> d.paths
    [(0,)]
    """

    _core: "_epsnet.Distance"

    def __init__(self, core: "_epsnet.Distance", surface: Optional["Surface"], certificate: Optional[Certificate], reverse: bool = False) -> None:
        super().__init__(core, surface, certificate)
        self._reverse = reverse

    def _more(self) -> tuple[Any, ...]:
        return (self._reverse,)

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
        return self._core.equal and self.proved

    def svg(self, size: int = 600) -> str:
        """The paths in the Dirichlet domain of p, which is in the centre."""
        return self._core.svg(as_index(size, "size", 50, 20000))

    def _layers_on(self, net: "_epsnet.Net") -> list["_epsnet.Layer"]:
        return [net.distance_layer(self._core)]


class Cover(Drawn, _Measured):
    """The maximum of a function on a surface, or the minimum, as an interval, proved cell by cell."""

    _core: "_epsnet.Cover"

    @property
    def cells(self) -> int:
        """The number of cells into which the surface was cut."""
        return self._core.cells

    @property
    def triangulations(self) -> int:
        """The number of triangulations that bound the function on the cells."""
        return self._core.triangulations

    @property
    def point(self) -> Point:
        """A point where the function is at least the lower end; for a radius, at most the upper end."""
        return point_of(self._core.net.charts[0])

    def svg(self, size: int = 600) -> str:
        """Where it is attained, in the Dirichlet domain of ``point``."""
        return self._core.svg(as_index(size, "size", 50, 20000))


class _Attained(Cover):
    """A bound that is the distance of ``point`` from those that are farthest from it."""

    def farthest_points(self) -> list[Point]:
        """The points farthest from ``point``; their coordinates are rounded to multiples of 2⁻¹⁰⁰."""
        return farthest_points(self.surface, self.point)

    def distance(self) -> Distance:
        """The distance of ``point`` from one of the points farthest from it, proved, with its paths.

        >>> import epsnet
        >>> epsnet.Surface.regular(2).diameter("1e-6").distance().proved
        True
        """
        return distance(self.surface, self.point, self.farthest_points()[0], 1e-6)


class Diameter(_Attained):
    """The greatest distance of two points of a surface, as an interval."""


class Radius(_Attained):
    """The least r such that a disk of radius r covers the surface, as an interval: the least eccentricity, that of about ``point``."""


class EmbeddedDisk(Cover):
    """The radius of the largest embedded disk of a surface, as an interval; its centre is near ``point``."""


class Eccentricity(Drawn, Interval):
    """The greatest distance of a point of the surface from a given one, as an interval."""

    def __init__(self, net: Net) -> None:
        #: The net with that point as its one vertex; its largest circumradius is the eccentricity.
        self.net = net
        value = net.certificate.enclosures["largest_circumradius"]
        super().__init__(*value.ends, proved=value.proved)

    @property
    def certificate(self) -> Certificate:
        """The certificate of the net."""
        return self.net.certificate

    @property
    def point(self) -> Point:
        """The point."""
        return self.net.charts[0]

    def farthest_points(self) -> list[Point]:
        """The points farthest from it; their coordinates are rounded to multiples of 2⁻¹⁰⁰."""
        return farthest_points(self.net.surface, self.point)

    def distance(self) -> Distance:
        """The distance of the point from one of those that are farthest from it, proved, with its paths."""
        return distance(self.net.surface, self.point, self.farthest_points()[0], 1e-6)

    def svg(self, size: int = 600) -> str:
        """The point in the centre of its Dirichlet domain, and those that are farthest from it."""
        return self.net._core.eccentricity_svg(as_index(size, "size", 50, 20000))

    def __reduce__(self) -> tuple[Any, ...]:
        return Eccentricity, (self.net,)


def farthest_points(surface: "Surface", p: Point) -> list[Point]:
    return [point_of(base) for base in _epsnet.farthest_points(surface._core, base_point(surface._core, p, "p"))]


class PointLoop:
    """A geodesic loop at a point."""

    def __init__(self, isometry: Isometry, base: BasePoint) -> None:
        #: The element of the group that takes a lift of the point to the other end of the loop, whose ``word`` is a path around it.
        self.isometry = isometry
        self._base = base

    @property
    def point(self) -> Point:
        """The point."""
        return point_of(self._base)

    @cached_property
    def length(self) -> Interval:
        """Its length, proved: how far the isometry moves the point."""
        # sinh²(d/2) = |b + (a − ā)p − b̄p²|²/(1 − |p|²)² for z ↦ (az + b)/(b̄z + ā) of determinant 1.
        x, y = self._base[1]
        a, b = self.isometry.enclosure(128)
        re = b.re * (1 - x * x + y * y) - 2 * a.im * y - 2 * b.im * x * y
        im = b.im * (1 + x * x - y * y) + 2 * a.im * x - 2 * b.re * x * y
        return arcosh(1 + 2 * (re**2 + im**2) / (1 - x * x - y * y) ** 2).rounded()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, PointLoop) and (self.isometry, self._base) == (other.isometry, other._base)

    def __hash__(self) -> int:
        return hash(self._base)

    def __repr__(self) -> str:
        return f"<PointLoop of length {self.length}>"


def injectivity_radius(surface: "Surface", p: PointLike) -> Interval:
    """A shortest loop at p is an edge of every Delaunay triangulation with the one vertex p: the disk over it as a diameter has no other lift of p."""
    return eccentricity(surface, p).net.certificate.enclosures["shortest_loop"] / 2


def _width(width: Number) -> float:
    value = as_fraction(width, "width")
    if value <= 0:
        refuse("a positive length", width, "width")
    return float(value)


def distance(surface: "Surface", p: PointLike, q: PointLike, width: Number) -> Distance:
    start, end = base_point(surface._core, p, "p"), base_point(surface._core, q, "q")
    core, certificate = _epsnet.Distance.measure(surface._core, start, end, _width(width))
    # Measured from q, if p is not strictly inside of its tile.
    return Distance(core, surface, Certificate(certificate), core.point == start and core.point != end)


_COVERS = {"diameter": Diameter, "radius": Radius, "embedded-disk": EmbeddedDisk}


def cover_of(core: "_epsnet.Cover", surface: Optional["Surface"], certificate: Optional[Certificate]) -> Cover:
    """The cover as the class of its claim."""
    return _COVERS[core.claim](core, surface, certificate)


def cover(surface: "Surface", claim: str, width: Number, threads: int, progress: Progress) -> Cover:
    size, threads = _width(width), as_threads(threads)
    if size < _epsnet.least_bound_width:
        refuse(f"a width of at least {_epsnet.least_bound_width}", width, "width")
    with Shower(progress) as callback:
        core, certificate = _epsnet.Cover.enclose(surface._core, claim, size, threads, callback)
    return cover_of(core, surface, Certificate(certificate))


def eccentricity(surface: "Surface", p: PointLike) -> Eccentricity:
    core, certificate = _epsnet.eccentricity_net(surface._core, base_point(surface._core, p, "p"))
    return Eccentricity(Net(core, surface, Certificate(certificate)))
