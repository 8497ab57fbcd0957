"""Closed hyperbolic surfaces."""
from __future__ import annotations

import operator
import os
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Iterable, NamedTuple, Optional, Sequence, Union

from . import _epsnet
from .isometries import Gaussian, Isometry

if TYPE_CHECKING:
    from ._progress import Progress
    from .distances import Cover, Distance, Eccentricity
    from .domains import DirichletDomain, FundamentalPolygon
    from .geodesics import ClosedGeodesics, Systole, ThickThin
    from .nets import Net

__all__ = ["Point", "Surface"]

#: A length or a coordinate: exact for all of these types but float, which is the shortest decimal that reads back as it, so that 0.1 is 1/10.
Number = Union[int, float, str, Fraction]
Path = Union[str, "os.PathLike[str]"]


class Point(NamedTuple):
    """A point of a surface: a tile, and rational coordinates in the Poincaré disk of that tile."""

    tile: int
    x: Fraction
    y: Fraction

    @property
    def z(self) -> Gaussian:
        """x + iy."""
        return Gaussian(self.x, self.y)

    def __repr__(self) -> str:
        return f"Point({self.tile}, {self.x}, {self.y})"


#: What stands for a point: a Point or (tile, x, y); a tile alone, for its centre.
PointLike = Union[Point, Sequence[Any], int]


def as_fraction(x: Number, name: str) -> Fraction:
    """The number that is meant."""
    try:
        return Fraction(repr(float(x))) if isinstance(x, float) else Fraction(x)
    except (ValueError, TypeError, OverflowError, ZeroDivisionError):
        from .errors import ArgumentError

        raise ArgumentError(f"expected a number such as 0.1, Fraction(1, 3) or '1/3', not {x!r}", place=name) from None


def as_text(x: Number, name: str) -> str:
    """The same for the library, which reads decimals and quotients."""
    return x if isinstance(x, str) else str(as_fraction(x, name))


def length_text(x: Number, name: str) -> str:
    """The same for a length, which is written into files as it is given."""
    return _epsnet.length_text(x) if isinstance(x, float) else as_text(x, name)


def as_index(x: int, name: str, least: int = 0, most: int = 2**32 - 1) -> int:
    """The integer, if it is one that can be meant."""
    try:
        value = operator.index(x)
    except TypeError:
        value = least - 1
    if not least <= value <= most:
        from .errors import ArgumentError

        raise ArgumentError(f"expected an integer from {least} to {most}, not {x!r}", place=name)
    return value


class Surface:
    """A closed hyperbolic surface, exactly: convex polygons (tiles) in the Poincaré disk, glued side to side by isometries. Immutable.

    Surfaces are made by ``octagon``, ``fenchel_nielsen``, ``regular``, ``load``, or of tiles and their gluing:

    >>> import epsnet
    >>> surface = epsnet.Surface.octagon(seed=123)
    >>> surface
    <Surface of genus 2: 1 tile, 8 sides>

    Then ask it: ``net`` for ε-nets; ``systole``, ``spectrum``, ``thick_thin`` for closed geodesics; ``distance``, ``diameter``,
    ``eccentricity``, ``embedded_disk``; ``generators``, ``fundamental_polygon``, ``dirichlet_domain``.

    Sides have numbers: those of tile 0 in order, then those of tile 1, and so on.
    """

    def __init__(self, tiles: Iterable[Iterable[Any]], gluing: Iterable[Sequence[int]]) -> None:
        """``tiles``: polygons, counterclockwise, their vertices pairs (x, y) or Gaussian; ``gluing``: rows (tile, side, tile, side).

        Everything is checked, exactly; SurfaceError says what is wrong.

        >>> from fractions import Fraction
        >>> import epsnet
        >>> one = epsnet.Surface.octagon(seed=5)
        >>> epsnet.Surface(one.tiles, one.gluing) == one
        True
        """
        polygons = [[_corner(z) for z in tile] for tile in tiles]
        self._core = _epsnet.Surface(polygons, [list(row) for row in gluing])

    @classmethod
    def _of(cls, core: "_epsnet.Surface") -> "Surface":
        surface = cls.__new__(cls)
        surface._core = core
        return surface

    @classmethod
    def octagon(cls, seed: int = 0, *, half: Optional[Sequence[Any]] = None) -> "Surface":
        """The random surface of genus 2 of a seed: a symmetric octagon, opposite sides glued; the same on every machine.

        With ``half``, four corners z0, z1, z2, z3, the octagon z0, z1, z2, z3, −z0, −z1, −z2, −z3, whose area must be 4π.

        >>> import epsnet
        >>> epsnet.Surface.octagon(321).genus
        2
        """
        if half is not None:
            return cls._of(_epsnet.Surface.symmetric([_corner(z) for z in half]))
        return cls._of(_epsnet.Surface.octagon(as_index(seed, "seed", -(2**31), 2**31 - 1)))

    @classmethod
    def regular(cls, genus: int) -> "Surface":
        """The regular 4g-gon with the angles π/2g, opposite sides glued; the Bolza surface for genus 2. Its coordinates are algebraic.

        >>> import epsnet
        >>> epsnet.Surface.regular(2)
        <Surface of genus 2: the regular 8-gon>
        """
        return cls._of(_epsnet.Surface.regular(as_index(genus, "genus")))

    @classmethod
    def fenchel_nielsen(
        cls,
        lengths: Union[Number, Sequence[Number], None] = None,
        twists: Union[Number, Sequence[Number], None] = None,
        graph: Union[str, Sequence[Sequence[int]], None] = None,
        *,
        genus: Optional[int] = None,
        seed: Optional[int] = None,
    ) -> "Surface":
        """The surface with Fenchel–Nielsen coordinates: for each edge of a trivalent graph the length of the cuff and the twist, which is a
        hyperbolic length, too. One number stands for all edges.

        ``graph``: edges, as [(0, 1), (0, 1), (0, 1)] or "0-1 0-1 0-1", of which the nodes are the pairs of pants; or "chain", "ring", "tree",
        "random" with a genus. Missing values are drawn with the seed. Exact: lengths and twists of the surface differ from those asked for
        by a factor within 1 ± 2⁻⁵⁰ (docs/fenchel-nielsen.md).

        >>> import epsnet
        >>> thin = epsnet.Surface.fenchel_nielsen(["1/1000", 1, 2], 0, [(0, 0), (0, 1), (1, 1)])
        >>> thin
        <Surface of genus 2: 2 tiles, 14 sides>
        >>> epsnet.Surface.fenchel_nielsen(lengths=2, twists="1/2", graph="ring", genus=5).genus
        5
        """
        if graph is None:
            graph = "random"
        if not isinstance(graph, str):
            graph = " ".join("-".join(str(int(node)) for node in edge) for edge in graph)
        genus = None if genus is None else as_index(genus, "genus")
        seed = None if seed is None else as_index(seed, "seed", 0, 2**64 - 1)
        coordinates = _epsnet.Coordinates(graph, genus, seed, _texts(lengths, "lengths"), _texts(twists, "twists"))
        return cls._of(_epsnet.Surface.fenchel_nielsen(coordinates))

    @classmethod
    def load(cls, path: Path) -> "Surface":
        """The surface of a file: a surface file, the surface of a net file or another file of epsnet, or CGAL's text formats."""
        from .files import surface_of_file

        return surface_of_file(path)

    def save(self, path: Path) -> None:
        """Writes a surface file, completely or not at all."""
        self._core.save(os.fspath(path))

    def export(self, format: str, path: Optional[Path] = None) -> Optional[str]:
        """The surface in an exact text format of CGAL: "domain" (one tile) or "triangulation". Written to the path, or returned."""
        if format == "domain":
            text = self._core.domain_text()
        elif format == "triangulation":
            text = self._core.triangulation_text()
        else:
            raise ValueError(f'expected the format "domain" or "triangulation", not "{format}"')
        if path is None:
            return text
        _epsnet.write_text(text.encode(), os.fspath(path))
        return None

    # What it is.

    @property
    def genus(self) -> int:
        """The genus, at least 2."""
        return self._core.genus

    @property
    def about(self) -> str:
        """A free text about the origin of the surface; it is not part of the surface."""
        return self._core.about

    @property
    def is_regular(self) -> bool:
        """Whether the surface was made by ``regular``. Then its tile is rounded, and elements of its group are algebraic."""
        return self._core.is_regular

    @property
    def tiles(self) -> list[list[Gaussian]]:
        """The polygons, counterclockwise, each in its own coordinates. Exact; for a regular surface rounded to 256 bits."""
        return [[Gaussian(x, y) for x, y in tile] for tile in self._core.tiles]

    @property
    def gluing(self) -> list[tuple[int, int, int, int]]:
        """Rows (tile, side, other tile, other side): side k goes from corner k to corner k + 1."""
        return [(row[0], row[1], row[2], row[3]) for row in self._core.gluing]

    def partner(self, side: int) -> int:
        """The number of the side that a side is glued to."""
        return self._core.partner(as_index(side, "side", 0, self._core.side_count - 1))

    def reduced(self, word: Iterable[int]) -> tuple[int, ...]:
        """The path with each crossing that is undone at once removed."""
        result: list[int] = []
        for side in word:
            if result and self.partner(result[-1]) == side:
                result.pop()
            else:
                result.append(side)
        return tuple(result)

    def point(self, tile: int, x: Number, y: Number) -> Point:
        """A point of a tile, exactly.

        >>> import epsnet
        >>> epsnet.Surface.octagon(1).point(0, 0.1, "-1/3")
        Point(0, 1/10, -1/3)
        """
        return Point(as_index(tile, "tile"), as_fraction(x, "x"), as_fraction(y, "y"))

    def centre(self, tile: int = 0) -> Point:
        """A point with few digits, strictly inside a tile."""
        number, (x, y) = self._core.centre_of_tile(as_index(tile, "tile"))
        return Point(number, x, y)

    def _base(self, p: PointLike) -> tuple[int, tuple[Fraction, Fraction]]:
        if isinstance(p, int):
            p = self.centre(p)
        if not isinstance(p, Point):
            try:
                tile, x, y = p
            except (TypeError, ValueError):
                from .errors import ArgumentError

                raise ArgumentError(f"expected a Point, (tile, x, y) or a tile, not {p!r}", place="point") from None
            p = self.point(tile, x, y)
        return p.tile, (p.x, p.y)

    # Its group.

    def generators(self) -> list[Isometry]:
        """Generators of the group of the surface: the side pairings of ``fundamental_polygon()``, one of each pair.

        >>> import epsnet
        >>> [g.word for g in epsnet.Surface.octagon(1).generators()]
        [(4,), (5,), (6,), (7,)]
        """
        return self.fundamental_polygon().generators()

    def element(self, word: Iterable[int]) -> Isometry:
        """The element of the group for a path across sides."""
        return Isometry(self, list(word))

    def fundamental_polygon(self) -> "FundamentalPolygon":
        """All tiles as one polygon in the coordinates of tile 0, with its side pairings and relations, exactly."""
        from .domains import FundamentalPolygon

        return FundamentalPolygon(self)

    def dirichlet_domain(self, p: Optional[PointLike] = None) -> "DirichletDomain":
        """The Dirichlet domain of a point. The default is the first vertex of the tiles, or the centre of a regular surface.

        Which sides there are and how they are paired is proved; its vertices are rounded.

        >>> import epsnet
        >>> epsnet.Surface.regular(2).dirichlet_domain()
        <DirichletDomain with 8 sides>
        """
        from .domains import DirichletDomain

        return DirichletDomain(self, None if p is None else self._base(p))

    # Nets.

    def net(
        self,
        epsilon: Number,
        *,
        pseudo: bool = False,
        base: Optional[PointLike] = None,
        threads: int = 0,
        progress: "Progress" = None,
    ) -> "Net":
        """An ε-net, proved: every point of the surface is within ε of a vertex, and different vertices are at least ε apart.

        ``pseudo``: leave the collars of closed geodesics no longer than ε empty (ε at most ln √2). ``base``: start from this point. Never returns
        a net that is not verified: raises NetError instead. Takes about 0.54 · 16(g − 1)/ε² vertices. Ctrl-C interrupts it; ``progress`` may be
        False, or a function of what is being done and the share done.

        >>> import epsnet
        >>> net = epsnet.Surface.octagon(seed=123).net("0.2")
        >>> net
        <Net: 227 vertices, epsilon 0.2, genus 2, VERIFIED>
        """
        from .nets import Net

        return Net._computed(self, epsilon, pseudo, base, threads, progress)

    # Closed geodesics.

    def systole(self, *, threads: int = 0, progress: "Progress" = None) -> "Systole":
        """The length of a shortest closed geodesic, in a proved interval, with the geodesic.

        >>> import epsnet
        >>> systole = epsnet.Surface.regular(2).systole()
        >>> systole
        <Systole [3.0571418389619959, 3.057141838961997]>
        >>> systole.geodesic.simple
        True
        """
        from .geodesics import systole

        return systole(self, threads, progress)

    def spectrum(self, up_to: Number, *, threads: int = 0, progress: "Progress" = None) -> "ClosedGeodesics":
        """All primitive closed geodesics up to a length, up to orientation, by length. The list is proved complete. Takes time proportional to e^L.

        >>> import epsnet
        >>> spectrum = epsnet.Surface.regular(2).spectrum("4.9")
        >>> [(multiplicity.length.text, multiplicity.count, multiplicity.equal) for multiplicity in spectrum.multiplicities()]
        [('[3.0571418389619959, 3.057141838961997]', 12, True), ('[4.89690489535615, 4.8969048953561521]', 12, True)]
        """
        from .geodesics import spectrum

        return spectrum(self, up_to, threads, progress)

    def thick_thin(self, *, threads: int = 0, progress: "Progress" = None) -> "ThickThin":
        """The small curves, of length at most 2 arsinh 1, their collars, and the pieces into which they cut the surface: proved.

        >>> import epsnet
        >>> thin = epsnet.Surface.fenchel_nielsen(["1/10", 4, 4], 0, [(0, 0), (0, 1), (1, 1)]).thick_thin()
        >>> len(thin), thin.pieces
        (1, [Piece(genus=1, boundaries=[(0, 'left'), (0, 'right')])])
        """
        from .geodesics import thick_thin

        return thick_thin(self, threads, progress)

    # Distances.

    def distance(self, p: PointLike, q: PointLike, *, width: Number = 1e-12) -> "Distance":
        """The distance between two points in a proved interval, with all shortest geodesics between them.

        A point is a ``Point``, (tile, x, y), or a tile, for its centre; of a net, ``net.point(17)``. One of the two must be strictly inside of
        its tile.

        >>> import epsnet
        >>> d = epsnet.Surface.regular(2).distance((0, "1/3", "1/5"), (0, "-0.6", "1/7"))
        >>> d.width < 1e-12, len(d.paths)
        (True, 1)
        """
        from .distances import distance

        return distance(self, p, q, width)

    def diameter(self, width: Number = 1e-6, *, progress: "Progress" = None) -> "Cover":
        """The greatest distance of two points, in a proved interval at most ``width`` wide.

        >>> import epsnet
        >>> diameter = epsnet.Surface.regular(2).diameter("1e-9")
        >>> diameter.proved, diameter.width <= 1e-9, round(diameter.mid, 8)
        (True, True, 2.44845245)
        """
        from .distances import diameter

        return diameter(self, width, progress)

    def embedded_disk(self, width: Number = 1e-6, *, progress: "Progress" = None) -> "Cover":
        """The radius of the largest embedded disk, the greatest injectivity radius, in a proved interval at most ``width`` wide."""
        from .distances import embedded_disk

        return embedded_disk(self, width, progress)

    def eccentricity(self, p: PointLike) -> "Eccentricity":
        """The greatest distance of a point of the surface from p, in a proved interval; p must be strictly inside its tile."""
        from .distances import eccentricity

        return eccentricity(self, p)

    # As a value.

    def __eq__(self, other: object) -> bool:
        """Whether tiles and gluing are equal. Isometric surfaces may have different tiles and gluings."""
        return isinstance(other, Surface) and self._core == other._core

    def __hash__(self) -> int:
        return hash((self.genus, self._core.side_count))

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled, (self._core.text(),)

    def __repr__(self) -> str:
        if self.is_regular:
            return f"<Surface of genus {self.genus}: the regular {4 * self.genus}-gon>"
        tiles = len(self._core.tiles)
        return f"<Surface of genus {self.genus}: {tiles} tile{'' if tiles == 1 else 's'}, {self._core.side_count} sides>"

    def _repr_svg_(self) -> str:
        return self.fundamental_polygon()._repr_svg_()


def _unpickled(text: bytes) -> Surface:
    return Surface._of(_epsnet.Surface.parse(text, "pickle"))


def _corner(z: Any) -> tuple[Fraction, Fraction]:
    if isinstance(z, Gaussian):
        return z.re, z.im
    x, y = (z.real, z.imag) if isinstance(z, complex) else z
    return as_fraction(x, "tiles"), as_fraction(y, "tiles")


def _texts(numbers: Union[Number, Sequence[Number], None], name: str) -> list[str]:
    if numbers is None:
        return []
    if isinstance(numbers, (int, float, str, Fraction)):
        numbers = [numbers]
    return [as_text(x, name) for x in numbers]
