"""Closed hyperbolic surfaces."""
from __future__ import annotations

import decimal
import json
import random
import warnings
from fractions import Fraction
from functools import cached_property
from typing import Any, Iterable, Optional, Sequence, Tuple, Type, TypeVar, Union

import numpy as np

from . import _epsnet
from ._arguments import (
    Number, Path, argument, as_choice, as_fraction, as_index, as_indices, as_items, as_optional_path, as_path, as_text, refuse,
)
from ._documents import Document, read
from ._immutable import Immutable
from ._names import call, keywords, shown
from ._pictures import Drawn
from ._progress import Progress
from .curves import ClosedCurves, Curve, curve, curves, fills
from .distances import Diameter, Distance, Eccentricity, EmbeddedDisk, PointLoop, Radius, cover, distance, eccentricity, injectivity_radius
from .domains import DirichletDomain, FundamentalPolygon
from .eigenvalues import Bands, Eigenvalues, bands, eigenvalues, gap, side_phases, torus_point
from .geodesics import ClosedGeodesics, LocalMaximum, Systole, ThickThin, local_maximum, spectrum, systole, thick_thin
from .graphs import Lattice, SurfaceGraph, graph_of, lattice
from .groups import FundamentalGroup, as_word
from .intervals import Interval
from .isometries import Gaussian, Isometry
from .nets import Net
from .points import Point, PointLike, base_point, point_of, random_points
from .lengths import LengthDerivatives, SystoleMaximum, gradient, maximize_systole
from .mapping_classes import MappingClass, mapping_class
from .pants import PantsDecomposition, dehn_twist, dehn_twist_words, pants, twist
from .symmetries import Comparison, IsometryGroup, SurfaceIsometry, compare, comparison, identify, isometries

__all__ = ["Surface"]

_Kind = TypeVar("_Kind")

#: π to 60 digits.
_PI = Interval("3.14159265358979323846264338327950288419716939937510582097494", "3.14159265358979323846264338327950288419716939937510582097495", proved=True)


def _matrix_text(x: Any) -> str:
    """A number of a matrix: a float stays a decimal, which says that it is rounded."""
    if isinstance(x, (float, np.floating)):
        as_fraction(x, "generators")
        return repr(float(x))
    return str(x) if isinstance(x, decimal.Decimal) else as_text(x, "generators")


class Surface(Drawn, Immutable):
    """A closed hyperbolic surface, exactly: convex polygons (tiles) in the Poincaré disk, glued side to side by isometries. Immutable.

    Surfaces are made by ``octagon``, ``fenchel_nielsen``, ``regular``, ``named``, ``map``, ``load``, or of tiles and their gluing:

    >>> import epsnet
    >>> surface = epsnet.Surface.octagon(seed=123)
    >>> surface
    <Surface octagon(seed=123), genus 2>

    Then ask it: ``net`` for ε-nets; ``systole``, ``spectrum``, ``thick_thin`` for closed geodesics; ``distance``, ``diameter``, ``radius``,
    ``eccentricity``, ``embedded_disk``; ``pants``, ``curve`` and ``curves``; ``generators``, ``fundamental_polygon``, ``dirichlet_domain``.

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
        polygons = [[_corner(z, "tiles") for z in as_items(tile, "tiles", "polygons")] for tile in as_items(tiles, "tiles", "polygons")]
        rows = [as_indices(row, "gluing") for row in as_items(gluing, "gluing", "rows of four integers")]
        if any(len(row) != 4 for row in rows):
            refuse("rows of four integers", gluing, "gluing")
        self._core = _epsnet.Surface(polygons, rows)
        self._name = ""

    @classmethod
    def _of(cls, core: "_epsnet.Surface", name: str = "") -> "Surface":
        surface = cls.__new__(cls)
        surface._core = core
        surface._name = name
        return surface

    def _derived(self, core: "_epsnet.Surface", method: str, *arguments: str) -> "Surface":
        """What a method makes of this surface."""
        return self._of(core, call(f"{self._name or 'surface'}.{method}", *arguments))

    @classmethod
    def octagon(cls, seed: Optional[int] = None, *, half: Optional[Sequence[Any]] = None) -> "Surface":
        """The random surface of genus 2 of a seed: a symmetric octagon, opposite sides glued; the same on every machine.

        With ``half``, four corners z0, z1, z2, z3, the octagon z0, z1, z2, z3, −z0, −z1, −z2, −z3, whose area must be 4π.

        >>> import epsnet
        >>> epsnet.Surface.octagon(321).genus
        2
        """
        if half is not None:
            corners = [_corner(z, "half") for z in as_items(half, "half", "four corners")]
            if len(corners) != 4:
                refuse("four corners", half, "half")
            return cls._of(_epsnet.Surface.symmetric(corners))
        if seed is None:
            refuse("a seed, as in Surface.octagon(seed=1), or half, four corners", seed, "seed")
        number = as_index(seed, "seed", -(2**31), 2**31 - 1)
        return cls._of(_epsnet.Surface.octagon(number), f"octagon(seed={number})")

    @classmethod
    def regular(cls, genus: int) -> "Surface":
        """The regular 4g-gon with the angles π/2g, opposite sides glued; the Bolza surface for genus 2. Its coordinates are algebraic.

        >>> import epsnet
        >>> epsnet.Surface.regular(2)
        <Surface regular(2), genus 2>
        """
        number = as_index(genus, "genus")
        with argument("genus"):
            return cls._of(_epsnet.Surface.regular(number), f"regular({number})")

    @classmethod
    def named(cls, name: str, genus: Optional[int] = None) -> "Surface":
        """A surface that has a name, exactly: those of ``Surface.names()``, such as ``"klein"``, ``"R3.1"`` or ``"wiman-7"``, also as ``"wiman", 7``.

        >>> import epsnet
        >>> epsnet.Surface.named("klein")
        <Surface klein, genus 3>
        """
        if not isinstance(name, str):
            refuse("a string", name, "name")
        number = None if genus is None else as_index(genus, "genus", 2)
        with argument("name"):
            core = _epsnet.Surface.named(name, number)
        return cls._of(core, name if genus is None or name.endswith(f"-{number}") or name in cls.names() else f"{name}-{number}")

    @classmethod
    def names(cls) -> dict[str, str]:
        """What ``named`` knows: a sentence for each name. A G in a name stands for a genus. Names such as R2.1 are those of regular maps.

        >>> import epsnet
        >>> list(epsnet.Surface.names())[:9]
        ['bolza', 'klein', 'fermat-quartic', 'bring', 'fricke-macbeath', 'wiman-G', 'accola-maclachlan-G', 'R2.1', 'R2.2']
        >>> epsnet.Surface.names()["R3.1"]
        'A regular map {3, 7} of genus 3 with 168 rotations and as many reflections.'
        """
        return dict(_epsnet.Surface.names())

    @classmethod
    def map(cls, rotation: Iterable[int], edges: Iterable[int]) -> "Surface":
        """The surface of a map: all its faces are made regular, with equal angles at all vertices.

        Two permutations of the darts 0, 1, … give the map: ``rotation`` leads to the next dart around the face, counterclockwise, ``edges`` to the
        other dart of the edge. All faces must have the same number of sides, and all vertices the same number of corners.

        >>> import epsnet
        >>> octagon = [(k + 1) % 8 for k in range(8)], [(k + 4) % 8 for k in range(8)]
        >>> epsnet.Surface.map(*octagon) == epsnet.Surface.regular(2)
        True
        """
        return cls._of(_epsnet.Surface.map(as_indices(rotation, "rotation"), as_indices(edges, "edges")))

    @classmethod
    def from_matrices(
        cls,
        generators: Iterable[Any],
        relation: Union[str, Iterable[int], None] = None,
        *,
        model: str = "sl2r",
        tiles: Union[tuple[int, int], Sequence[int], None] = None,
        algebra: Optional[Sequence[Any]] = None,
    ) -> "Surface":
        """The surface of the group that matrices generate (docs/matrices.md).

        ``generators``: for the model ``"sl2r"`` matrices ((a, b), (c, d)) with a positive determinant, up to scale; for ``"su11"`` the first row
        ((Re a, Im a), (Re b, Im b)). Integers, fractions and texts such as ``"1/3"`` are exact, and then the group is exactly that of the matrices.
        Floats and decimals are rounded numbers: unless they fulfil the relations of the group exactly, the surface is a rational one nearest to
        them, and ``about`` says how far it is. Texts such as ``"(1+sqrt(2))/2"``, ``"cos(pi/7)"`` and ``"root(x^3-x-1,1.3)"`` are exact numbers of
        a real number field, and so is the surface. With ``tiles``, the pair (p, q), the numbers are those of maps of this type, as
        ``"s*cos(pi/7)"``. With ``algebra``, a pair (a, b), the generators are quaternions x + yi + zj + wij, i² = a, j² = b, as ((x, y), (z, w)).
        ``relation``: ``"abAB"`` or ``[1, 2, -1, -2]``, a product that is 1; it is checked.
        Raises SurfaceError, with the element that shows it, for groups that are not discrete, not cocompact, or have torsion.

        >>> import epsnet
        >>> surface = epsnet.Surface.octagon(3)
        >>> matrices = surface.matrices()
        >>> same = epsnet.Surface.from_matrices(matrices["generators"], matrices["relation"])
        >>> bool(surface.isometric_to(same))
        True
        >>> units = [((2.5, -0.5), (-1, 0)), ((2.5, -0.5), (1, 0)), ((1.5, -0.5), (-1.5, -0.5)), ((1.5, -0.5), (-1.5, 0.5)),
        ...          ((1.5, -0.5), (1.5, -0.5)), ((1.5, -0.5), (1.5, 0.5)), ((3, 0), (-2, 0))]
        >>> shimura = epsnet.Surface.from_matrices(units, algebra=(13, 2))
        >>> shimura.genus, len(shimura.isometries())
        (2, 8)
        >>> matrices = epsnet.Surface.named("klein").matrices()
        >>> epsnet.Surface.from_matrices(matrices["generators"], matrices["relation"], tiles=matrices["tiles"]).genus
        3
        """
        rows = [
            [[_matrix_text(x) for x in as_items(row, "generators", "rows of two numbers")] for row in as_items(m, "generators", "matrices")]
            for m in as_items(generators, "generators", "matrices")
        ]
        text: dict[str, Any] = {"model": as_choice(model, "model", ("sl2r", "su11")), "generators": rows}
        if relation is not None:
            letters = relation if isinstance(relation, str) else [int(k) for k in as_items(relation, "relation", "integers")]
            text["relation"] = letters
        if tiles is not None:
            text["tiles"] = as_indices(tiles, "tiles")
        if algebra is not None:
            text["algebra"] = [_matrix_text(x) for x in as_items(algebra, "algebra", "two numbers")]
        name = call("from_matrices", f"{len(rows)} matri{'x' if len(rows) == 1 else 'ces'}", *keywords(tiles=tiles, algebra=algebra))
        return cls._of(_epsnet.Surface.from_matrices(json.dumps(text)), name)

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
        "random" with a genus; the default for genus 2, where lengths and twists are given, is "theta", 0-1 0-1 0-1. Missing values are
        drawn with the seed. Lengths and twists of the surface differ from decimals by a factor within 1 ± 2⁻⁵⁰; twists by 0 and by half of
        the length, and texts such as "2*arcosh(3/2)", "2*log(3)" or "arcosh(1+sqrt(2))", are exact (docs/fenchel-nielsen.md). A UserWarning
        says which symmetries of the coordinates the surface may lack.

        >>> import epsnet
        >>> thin = epsnet.Surface.fenchel_nielsen(["1/1000", 1, 2], 0, [(0, 0), (0, 1), (1, 1)])
        >>> thin
        <Surface fenchel_nielsen(lengths=('1/1000', 1, 2), twists=0, graph='0-0 0-1 1-1'), genus 2>
        >>> epsnet.Surface.fenchel_nielsen(lengths=2, twists="1/2", graph="ring", genus=5).genus
        5
        >>> len(epsnet.Surface.fenchel_nielsen("2*arcosh(3/2)", "arcosh(3/2)", "theta").isometries())
        24
        """
        if not (graph is None or isinstance(graph, str)):
            edges = as_items(graph, "graph", "a name or edges")
            graph = " ".join("-".join(map(str, as_indices(edge, "graph"))) for edge in edges)
        genus = None if genus is None else as_index(genus, "genus")
        seed = None if seed is None else as_index(seed, "seed", 0, 2**64 - 1)
        lengths, twists = _numbers(lengths, "lengths"), _numbers(twists, "twists")
        coordinates = _epsnet.Coordinates(graph or "", genus, seed, _texts(lengths, "lengths"), _texts(twists, "twists"))
        for remark in _epsnet.Surface.symmetry_remarks(coordinates):
            warnings.warn(remark, stacklevel=2)
        name = call("fenchel_nielsen", *keywords(lengths=lengths, twists=twists, graph=graph, genus=genus, seed=seed))
        return cls._of(_epsnet.Surface.fenchel_nielsen(coordinates), name)

    @classmethod
    def load(cls, path: Path) -> "Surface":
        """The surface of a file: a surface file, the surface of a net file or another file of epsnet, or CGAL's text formats."""
        core = read(path)[1]
        if not isinstance(core, _epsnet.Surface):
            core = core.surface if isinstance(core, _epsnet.Net) else core.net.surface
        return cls._of(core, loaded_name(path))

    def save(self, path: Path) -> None:
        """Writes a surface file, completely or not at all."""
        name = as_path(path)
        if name.endswith(".epsn"):
            refuse("the name of a surface file, such as s.json: only nets have a compact form", name, "path")
        self._core.save(name)

    def export(self, format: str, path: Optional[Path] = None) -> Optional[str]:
        """The surface as a text for other programs; written to the path, or returned (docs/exchange-formats.md).

        Exactly, for CGAL: "domain" (one tile) or "triangulation". The graph of its tiles: "edges", a table of the two vertices, the two tiles and the
        length of each edge; "adjacency" and "face-adjacency", matrices of the graphs of vertices and of tiles, for MatrixMarket.
        """
        form = as_choice(format, "format", ("domain", "triangulation", "edges", "adjacency", "face-adjacency"))
        file = as_optional_path(path)
        if form == "domain":
            text = self._core.domain_text()
        else:
            text = self._core.triangulation_text() if form == "triangulation" else self._core.graph_text(form)
        if file is None:
            return text
        _epsnet.write_text(text.encode(), file)
        return None

    def info(self) -> dict[str, Any]:
        """A summary: sides, vertices, the size of the coordinates, area, perimeter. Rounded, not proved."""
        facts: dict[str, Any] = json.loads(self._core.info())
        return facts

    # What it is.

    @property
    def genus(self) -> int:
        """The genus, at least 2."""
        return self._core.genus

    @property
    def area(self) -> Interval:
        """4π(g − 1), in the least interval of floats.

        >>> import epsnet
        >>> epsnet.Surface.regular(2).area
        <Interval [12.566370614359172, 12.566370614359175]>
        """
        return (_PI * (4 * (self.genus - 1))).rounded()

    @property
    def name(self) -> str:
        """How it was made here, such as ``"klein"`` or ``"octagon(seed=5)"``, shortened by … where it is long; empty, if that is not known. It is
        not part of the surface.

        >>> import epsnet
        >>> theta = epsnet.Surface.fenchel_nielsen(lengths=(1, 2, 3), twists=(0, 0, 0))
        >>> theta.name
        'fenchel_nielsen(lengths=(1, 2, 3), twists=(0, 0, 0))'
        """
        return self._name

    @property
    def about(self) -> str:
        """A free text about the origin of the surface; it is not part of the surface."""
        return self._core.about

    @property
    def is_regular(self) -> bool:
        """Whether its tiles are regular, as ``regular``, ``named`` and ``map`` make them. Then they are rounded, and elements of its group are algebraic."""
        return self._core.is_regular

    @property
    def is_rational(self) -> bool:
        """Whether its tiles and the elements of its group are rational: neither of regular tiles nor over a number field."""
        return self._core.is_rational

    @property
    def tiles(self) -> list[list[Gaussian]]:
        """The polygons, counterclockwise, each in its own coordinates. Exact if the surface ``is_rational``, else rounded to 256 bits."""
        return [[Gaussian(x, y) for x, y in tile] for tile in self._core.tiles]

    @property
    def gluing(self) -> list[tuple[int, int, int, int]]:
        """Rows (tile, side, other tile, other side): side k goes from corner k to corner k + 1."""
        return [(row[0], row[1], row[2], row[3]) for row in self._core.gluing]

    def partner(self, side: int) -> int:
        """The number of the side that a side is glued to."""
        return self._core.partner(as_index(side, "side", 0, self._core.side_count - 1))

    def _checked_word(self, word: Any) -> list[int]:
        """The numbers of sides of a path."""
        sides = as_word(self, word, "word")
        with argument("word"):
            self._core.enclosed_isometry(sides, 1)  # Whether it is a path.
        return sides

    def reduced(self, word: Any) -> tuple[int, ...]:
        """The sides of a path with each crossing that is undone at once removed."""
        result: list[int] = []
        for side in as_indices(as_word(self, word, "word"), "word", self._core.side_count - 1):
            if result and self.partner(result[-1]) == side:
                result.pop()
            else:
                result.append(side)
        return tuple(result)

    def point(self, tile: int, x: Number, y: Number) -> Point:
        """A point of a tile, exactly.

        >>> import epsnet
        >>> epsnet.Surface.octagon(1).point(0, 0.1, "-1/3")
        Point(0, 0.1, -0.333333333333)
        """
        return Point(as_index(tile, "tile"), as_fraction(x, "x"), as_fraction(y, "y"))

    def graph(self) -> SurfaceGraph:
        """The graph that the sides of the tiles are on the surface, with its faces, the tiles: of a map or a cover, say, for models on it.

        >>> import epsnet
        >>> graph = epsnet.Surface.named("klein").graph()
        >>> graph
        <SurfaceGraph: 56 vertices, 84 edges, 24 faces>
        >>> graph.faces[0], graph.edges[0], graph.face_edges[0]
        ((0, 1, 2, 3, 4, 5, 6), array([0, 1], dtype=uint32), array([0, 1], dtype=uint32))
        """
        return graph_of(self._core)

    def lattice(self, phases: Optional[Sequence[Number]] = None, *, nodes: str = "vertices") -> Lattice:
        """The matrix of this graph for functions with f(γz) = χ(γ) f(z), χ given by ``phases`` as for ``bands``: at the vertices, or with ``nodes``
        "faces" at the tiles, joined where they have a side in common. Without phases it is the adjacency matrix; a loop counts twice.

        >>> import epsnet
        >>> bolza = epsnet.Surface.regular(2)
        >>> bolza.lattice(("1/3", 0, "1/2", 0)).matrix()
        array([[-1.+0.j]])
        >>> [round(value.mid, 6) for value in epsnet.Surface.named("klein").lattice(nodes="faces").eigenvalues()][::4]
        [-2.645751, -2.645751, -1.0, -1.0, 2.645751, 2.645751]
        """
        turns = None if phases is None else torus_point(self, phases, "phases")
        return lattice(self._core, as_choice(nodes, "nodes", ("vertices", "faces")), turns)

    def centre(self, tile: int = 0) -> Point:
        """A point with few digits, strictly inside a tile."""
        return point_of(base_point(self._core, as_index(tile, "tile"), "tile"))

    def random_points(self, n: int, seed: int) -> list[Point]:
        """n points that are independent and uniformly distributed by area; the coordinates are floats.

        >>> import epsnet
        >>> len(epsnet.Surface.octagon(1).random_points(10, seed=1))
        10
        """
        return random_points(self._core, as_index(n, "n", 0, 10**8), as_index(seed, "seed", 0, 2**64 - 1))

    def exponential(self, p: PointLike, direction: float, length: Number) -> Point:
        """The end of the geodesic of this length (at most 300) that leaves p in a direction, the angle with the x-axis in the disk of the tile
        of p. Rounded to multiples of 2⁻¹⁰⁰, not proved.

        >>> import epsnet
        >>> surface = epsnet.Surface.octagon(1)
        >>> q = surface.exponential(surface.centre(), 0.5, "0.1")
        >>> surface.distance(surface.centre(), q).overlaps(epsnet.Interval("0.0999999999", "0.1000000001"))
        True
        """
        size = as_fraction(length, "length")
        if not 0 <= size <= 300:
            refuse("a length from 0 to 300", length, "length")
        return point_of(_epsnet.point_along(self._core, base_point(self._core, p, "p"), float(as_fraction(direction, "direction")), float(size)))

    def loops_at(self, p: PointLike, up_to: Number) -> list[PointLoop]:
        """The geodesic loops at p that are at most this long, up to their direction, the shortest first; p must be strictly inside its tile.

        The length of each is proved; that there are no others is computed with 1024 bits.

        >>> import epsnet
        >>> bolza = epsnet.Surface.regular(2)
        >>> [f"{loop.length:.6f}" for loop in bolza.loops_at(bolza.centre(), 4)]
        ['[3.057141, 3.057142]', '[3.057141, 3.057142]', '[3.057141, 3.057142]', '[3.057141, 3.057142]']
        """
        length = as_fraction(up_to, "up_to")
        base = base_point(self._core, p, "p")
        with argument("p"):
            found = _epsnet.loops_at(self._core, base, float(length))
        return [PointLoop(Isometry(self, self.reduced(word)), base) for word, _ in found]

    def injectivity_radius(self, p: PointLike) -> Interval:
        """Half the length of a shortest loop at p, in a proved interval; p must be strictly inside its tile (docs/distances.md).

        >>> import epsnet
        >>> bolza = epsnet.Surface.regular(2)
        >>> bolza.injectivity_radius(bolza.centre())
        <Interval [1.5285709194809975, 1.5285709194809987]>
        """
        return injectivity_radius(self, p)

    @cached_property
    def _tile_of(self) -> list[int]:
        """By side: its tile."""
        return [tile for tile, corners in enumerate(self._core.tiles) for _ in corners]

    @cached_property
    def _circulation(self) -> list[int]:
        """By side: a number for crossing it, the opposite one for crossing back, and 0 around each vertex. So the sum over a word depends on the
        element alone; numbers are large and drawn, so that it tells the homology of elements."""
        sides = range(self._core.side_count)
        partner = [self.partner(side) for side in sides]
        following = [side + 1 for side in sides]
        first = 0
        for tile in self._core.tiles:
            first += len(tile)
            following[first - 1] = first - len(tile)
        start = [-1] * len(partner)
        leaving: list[list[int]] = []
        for side in sides:
            if start[side] < 0:
                cycle = []
                while start[side] < 0:
                    start[side] = len(leaving)
                    cycle.append(side)
                    side = following[partner[side]]
                leaving.append(cycle)
        # The sides are the edges of a graph of the vertices. Those of a tree make good for all others.
        draw = random.Random(1)
        up: dict[int, int] = {0: -1}
        order = [0]
        for vertex in order:
            for side in leaving[vertex]:
                if start[partner[side]] not in up:
                    up[start[partner[side]]] = partner[side]
                    order.append(start[partner[side]])
        tree = set(up.values())
        number = [0] * len(partner)
        for side in sides:
            if side < partner[side] and not tree & {side, partner[side]}:
                number[side] = draw.getrandbits(60)
                number[partner[side]] = -number[side]
        for vertex in reversed(order[1:]):
            number[up[vertex]] = -sum(number[side] for side in leaving[vertex])
            number[partner[up[vertex]]] = -number[up[vertex]]
        return number

    # Its group.

    def generators(self) -> list[Isometry]:
        """Generators of the group of the surface: the side pairings of ``fundamental_polygon()``, one of each pair.

        >>> import epsnet
        >>> [g.word for g in epsnet.Surface.octagon(1).generators()]
        [(4,), (5,), (6,), (7,)]
        """
        return self.fundamental_polygon().generators()

    def matrices(self, model: str = "sl2r") -> dict[str, Any]:
        """2g matrices that generate the group, and the relation between them: what ``epsnet export --format matrices`` writes.

        The members ``generators`` (exact, texts, up to scale: integers, or for regular tiles numbers of their field), ``rounded`` (of determinant 1),
        ``relation``, ``words``, ``pairings`` and, of regular tiles, ``tiles``, as docs/exchange-formats.md has them.

        They are matrices of ``generators()``, in their order: of all, if those have one relation, so that letters are the same as those of
        ``fundamental_group()``; else of 2g of them. ``words`` says which those are, and ``pairings`` has for each of ``generators()`` the product
        of the matrices that it is, the first one on the left, numbered as in ``relation``.

        >>> import epsnet
        >>> surface = epsnet.Surface.octagon(3)
        >>> surface.matrices()["relation"], surface.fundamental_group().relations
        ([1, -2, 3, -4, -1, 2, -3, 4], ((1, -2, 3, -4, -1, 2, -3, 4),))
        >>> theta = epsnet.Surface.fenchel_nielsen(lengths=2, twists=0, graph="theta")
        >>> matrices, group = theta.matrices(), theta.fundamental_group()
        >>> [group.text(word) for word in matrices["words"]], matrices["pairings"]
        (['b', 'd', 'e', 'f'], [[1], [1], [1, 3, -4, -1, -3], [2], [3], [4]])
        """
        text = self._core.matrices(as_choice(model, "model", ("sl2r", "su11")) == "su11")
        return dict(json.loads(text))

    def element(self, word: Any) -> Isometry:
        """The element of the group for a path across sides, each the number of a side of the tile in which the path is; or for a text such as
        ``"abAB"`` in the letters of ``fundamental_group()``.

        >>> import epsnet
        >>> surface = epsnet.Surface.octagon(1)
        >>> surface.element([0, 4]).is_identity(), surface.element("ab") == surface.generators()[0] * surface.generators()[1]
        (True, True)
        """
        return Isometry(self, self._checked_word(word))

    def fundamental_polygon(self) -> FundamentalPolygon:
        """All tiles as one polygon in the coordinates of tile 0, with its side pairings and relations, exactly."""
        return FundamentalPolygon(self)

    def dirichlet_domain(self, p: Optional[PointLike] = None) -> DirichletDomain:
        """The Dirichlet domain of a point. The default is the first vertex of the tiles, or the centre of a regular surface.

        Which sides there are and how they are paired is read off the dual triangulation, to which the checker says VERIFIED; its vertices are
        rounded.

        >>> import epsnet
        >>> epsnet.Surface.regular(2).dirichlet_domain()
        <DirichletDomain with 8 sides>
        """
        return DirichletDomain(self, None if p is None else base_point(self._core, p, "p"))

    def fundamental_group(self) -> FundamentalGroup:
        """The group by generators and relations, with letters for its elements.

        >>> import epsnet
        >>> epsnet.Surface.regular(2).fundamental_group()
        <FundamentalGroup with 4 generators, 1 relation>
        """
        return self._fundamental_group

    @cached_property
    def _fundamental_group(self) -> FundamentalGroup:
        return FundamentalGroup(self)

    def cover(
        self, permutations: Optional[Iterable[Iterable[int]]] = None, *, degree: Optional[int] = None, seed: Optional[int] = None
    ) -> "Surface":
        """A connected unbranched cover: copies of the tiles, exactly (docs/covers.md).

        ``permutations``: one for each of ``generators()``, the images of the sheets 0, 1, …: where one gets across the first of the two sides
        of the fundamental polygon. Or, with ``degree`` (at most 50) and ``seed``, random: ``random_sheets``.

        >>> import epsnet
        >>> octagon = epsnet.Surface.octagon(1)
        >>> octagon.cover([(1, 0), (0, 1), (0, 1), (0, 1)]).genus
        3
        >>> octagon.cover(degree=10, seed=1).genus
        11
        """
        if permutations is None:
            sheets = self.random_sheets(degree, seed)  # type: ignore[arg-type]
        elif degree is not None or seed is not None:
            refuse("no degree and no seed where permutations are given", degree if seed is None else seed, "permutations")
        else:
            sheets = [tuple(as_indices(p, "permutations")) for p in as_items(permutations, "permutations", "permutations")]
        with argument("permutations"):
            return Surface._of(self._core.cover(sheets), f"cover of degree {len(sheets[0])} of {self.name}" if self.name else "")

    def random_sheets(self, degree: int, seed: int) -> list[tuple[int, ...]]:
        """Permutations for ``cover``, drawn uniformly from those of connected covers of this degree with numbered sheets.

        >>> import epsnet
        >>> epsnet.Surface.octagon(1).random_sheets(3, 1)
        [(2, 1, 0), (2, 1, 0), (1, 2, 0), (2, 0, 1)]
        """
        number = as_index(degree, "degree", 1, 50)
        return [tuple(p) for p in self._core.random_sheets(number, as_index(seed, "seed", 0, 2**64 - 1))]

    # Nets.

    def net(
        self,
        epsilon: Number,
        *,
        base: Optional[PointLike] = None,
        points: Iterable[PointLike] = (),
        pseudo: bool = False,
        sparse: bool = False,
        threads: int = 0,
        progress: Progress = None,
    ) -> Net:
        """An ε-net, proved: every point of the surface is within ε of a vertex, and different vertices are at least ε apart.

        Never returns a net that is not verified: raises NotVerifiedError instead. Takes about 0.54 · 16(g − 1)/ε² vertices. Ctrl-C interrupts it;
        ``progress`` may be False, or a function of what is being done and the share done.

        ``base``: start from this point. ``points``: these are vertices, exactly, the first ones after ``base``; each is strictly inside its
        tile, and any two are farther than ε from each other. ``pseudo``: leave the collars of closed geodesics no longer than ε empty (ε at
        most ln √2). ``sparse``: a net with few points, 1.4 to 1.5 times the lower bound of the thesis' Theorem III.2 instead of 2.15 times,
        at about eight times the cost.

        >>> import epsnet
        >>> surface = epsnet.Surface.octagon(seed=123)
        >>> surface.net("0.2")
        <Net: 227 vertices, epsilon 0.2, genus 2, VERIFIED>
        >>> net = surface.net("0.2", points=[(0, 0.1, 0.2), (0, 0, "-1/3")])
        >>> net.point(1)
        Point(0, 0, -0.333333333333)
        """
        return Net._computed(
            self, epsilon, base=base, points=points, pseudo=pseudo, sparse=sparse, threads=threads, progress=progress,
        )

    # Closed geodesics.

    def systole(self, *, threads: int = 0, progress: Progress = None) -> Systole:
        """The length of a shortest closed geodesic, in a proved interval, with the geodesic.

        >>> import epsnet
        >>> systole = epsnet.Surface.regular(2).systole()
        >>> systole
        <Systole [3.0571418389619959, 3.057141838961997]>
        >>> systole.geodesic.simple
        True
        """
        return systole(self, threads, progress)

    def spectrum(self, up_to: Number, *, threads: int = 0, progress: Progress = None) -> ClosedGeodesics:
        """All primitive closed geodesics up to a length, up to orientation, by length. The list is proved complete. Takes time proportional to e^L.

        >>> import epsnet
        >>> spectrum = epsnet.Surface.regular(2).spectrum("4.9")
        >>> [(multiplicity.length.text, multiplicity.count, multiplicity.equal) for multiplicity in spectrum.multiplicities()]
        [('[3.0571418389619959, 3.057141838961997]', 12, True), ('[4.89690489535615, 4.8969048953561521]', 12, True)]
        """
        return spectrum(self, up_to, threads, progress)

    def thick_thin(self, *, threads: int = 0, progress: Progress = None) -> ThickThin:
        """The small curves, of length at most 2 arsinh 1, their collars, and the pieces into which they cut the surface: proved.

        >>> import epsnet
        >>> thin = epsnet.Surface.fenchel_nielsen(["1/10", 4, 4], 0, [(0, 0), (0, 1), (1, 1)]).thick_thin()
        >>> len(thin), thin.pieces
        (1, [Piece(genus=1, boundaries=[(0, 'left'), (0, 'right')])])
        """
        return thick_thin(self, threads, progress)

    def local_maximum(self, *, threads: int = 0, progress: Progress = None) -> LocalMaximum:
        """Proves that the systole is greater than that of any other surface nearby. Raises NetError, which says what fails, if that is not proved,
        as where lengths are not exactly equal.

        >>> import epsnet
        >>> epsnet.Surface.named("klein").local_maximum()
        <LocalMaximum: 21 systoles>
        """
        return local_maximum(self, threads, progress)

    # Symmetries.

    def isometries(self, *, threads: int = 0, progress: Progress = None) -> IsometryGroup:
        """The isometries of the surface, also those that reverse the orientation. Each is decided exactly; that there are no others is proved
        when ``proof`` of the group is asked for. LimitError on surfaces with very thin parts.

        >>> import epsnet
        >>> group = epsnet.Surface.regular(2).isometries()
        >>> len(group), sum(f.preserves_orientation for f in group)
        (96, 48)
        """
        return isometries(self, threads, progress)

    def isometric_to(self, other: "Surface", *, threads: int = 0, progress: Progress = None) -> Optional[SurfaceIsometry]:
        """An isometry to another surface, decided exactly; None if it is proved that there is none. UndecidedError if neither is found, or the
        exact numbers of the two surfaces are too large. ``compare`` returns the proof.

        >>> import epsnet
        >>> bolza = epsnet.Surface.regular(2)
        >>> bolza.isometric_to(bolza), bolza.isometric_to(epsnet.Surface.octagon(1))
        (<SurfaceIsometry that preserves orientation>, None)
        """
        return compare(self, other, threads, progress)[0]

    def compare(self, other: "Surface", *, threads: int = 0, progress: Progress = None) -> Comparison:
        """Whether another surface is isometric to this one, with the proof, a file. UndecidedError if neither is proved.

        >>> import epsnet
        >>> bolza = epsnet.Surface.regular(2)
        >>> bolza.compare(epsnet.Surface.octagon(1))
        <Comparison: different>
        >>> bolza.compare(bolza).isometry
        <SurfaceIsometry that preserves orientation>
        """
        return comparison(self, other, threads, progress)

    def identify(self, *, threads: int = 0, progress: Progress = None) -> list[str]:
        """All names (``Surface.names``) of the known surface to which it is isometric, decided exactly; none if it is isometric to none of its genus.
        The first is the one to say; those of regular maps follow, that with the most rotations first. UndecidedError if that is undecided for some.

        >>> import epsnet
        >>> epsnet.Surface.regular(2).identify(), epsnet.Surface.octagon(1).identify()
        (['bolza', 'R2.1', 'R2.3', 'R2.6'], [])
        """
        return identify(self, threads, progress)

    # Pants.

    def pants(self, curves: Optional[Sequence[Any]] = None, *, find: bool = False, marking: Optional[PantsDecomposition] = None, threads: int = 0, progress: Progress = None) -> PantsDecomposition:
        """A pants decomposition, and the Fenchel–Nielsen coordinates, proved: along ``curves``, words or closed geodesics, which short ones
        complete; or along the cuffs of which ``Surface.fenchel_nielsen`` made the surface, unless short ones are to be found; or along
        short closed geodesics. ArgumentError for curves that are not simple, disjoint and different. Twists are known modulo the lengths.

        With ``marking``, pants of a surface with the same tiles, glued alike: along its curves, and twists are real numbers, as its words say.
        SurfaceError if the tiles are others.

        >>> import epsnet
        >>> pants = epsnet.Surface.fenchel_nielsen([2, 3, 4], ["1/2", 0, 1], "0-1 0-1 0-1").pants()
        >>> [round(length.mid, 12) for length in pants.lengths], [round(twist.mid, 12) + 0 for twist in pants.twists]
        ([2.0, 3.0, 4.0], [0.5, 0.0, 1.0])
        """
        return pants(self, curves, find, marking, threads, progress)

    def dehn_twist(self, curve: Any, power: int = 1) -> "Surface":
        """The same surface with another marking, that of a Dehn twist along a simple closed curve, to the left, or to the right for a negative
        power: its tiles as triangles, glued alike, so that a word of sides stands for the element that the twist makes of it
        (docs/fenchel-nielsen.md). SurfaceError for regular tiles.

        >>> import epsnet
        >>> surface = epsnet.Surface.octagon(123)
        >>> surface.dehn_twist(surface.pants().cuffs[0]).isometric_to(surface)
        <SurfaceIsometry that preserves orientation>
        """
        return self._derived(dehn_twist(self, curve, power), "dehn_twist", _curve_name(curve), *keywords(power=power))

    def dehn_twist_words(self, curve: Any, power: int = 1) -> list[tuple[int, ...]]:
        """By side: the path that a Dehn twist makes of the path across it. For surfaces of regular tiles, too."""
        return dehn_twist_words(self, curve, power)

    def twist(self, curve: Any, by: Number) -> "Surface":
        """The surface cut along the geodesic of a simple closed curve and glued anew, the other side moved to the left by a hyperbolic length, as
        seen from either side: made by ``Surface.fenchel_nielsen``, with its rounding.

        >>> import epsnet
        >>> surface = epsnet.Surface.octagon(123)
        >>> curve = surface.pants().cuffs[0]
        >>> abs(surface.twist(curve, "1/10").systole().mid - surface.systole().mid) < 1e-12
        True
        """
        return self._derived(twist(self, curve, by), "twist", _curve_name(curve), shown(by))

    # Closed curves.

    def curve(self, word: Any) -> Curve:
        """A closed curve up to free homotopy, of a word, a closed geodesic, a cuff, an element of the group or another curve: whether it is simple,
        how often it meets others, its class in homology. Its direction is that of the word; it may be null-homotopic.

        A word is one of sides, or a text such as ``"abAB"`` in the letters of ``fundamental_group()``.

        >>> import epsnet
        >>> surface = epsnet.Surface.octagon(123)
        >>> curve = surface.curve([0, 0])
        >>> curve.power, curve.self_intersections, curve.homology
        (2, 1, (0, 0, 0, 2))
        >>> surface.curve("abAB").genera, surface.curve("ab") == surface.curve(surface.element("ab"))
        ((1, 1), True)
        """
        return curve(self, word)

    def homology_basis(self) -> list[tuple[int, ...]]:
        """The words of 2g closed paths from tile 0, a₁, b₁, a₂, b₂, …, that generate the fundamental group with the relation [a₁, b₁][a₂, b₂]… = 1.
        They are simple; b_i crosses a_i once from right to left, and no others meet: their classes are a symplectic basis of the first homology group.

        >>> import epsnet
        >>> len(epsnet.Surface.named("klein").homology_basis())
        6
        """
        return [tuple(word) for word in self._curve_topology.homology_basis]

    @cached_property
    def _curve_topology(self) -> "_epsnet.CurveTopology":
        return _epsnet.CurveTopology(self._core)

    def gradient(self, word: Any, *, second: bool = False, threads: int = 0) -> LengthDerivatives:
        """The derivatives of the length of a closed geodesic with respect to the Fenchel–Nielsen coordinates of ``surface.pants()``, its lengths
        and twists; with ``second`` those of second order, too. The word is one of the sides of the tiles, as closed geodesics have it. Unless
        ``Surface.fenchel_nielsen`` made the surface, the path is found again in tiles that it makes, with 512 bits. SurfaceError for a path that is
        not closed, or null-homotopic; LimitError if the path is too long, or not found again. Derivatives with respect to a length are for a fixed
        twist, which is taken from −½ to less than ½ of the length: another marking has others.

        >>> import epsnet
        >>> surface = epsnet.Surface.fenchel_nielsen(graph="theta", lengths=[2, 2, 2], twists=[0, 0, 0])
        >>> cuff = surface.pants().cuffs[0]
        >>> [round(x.mid, 9) + 0 for x in surface.gradient(cuff).by_lengths]
        [1.0, 0.0, 0.0]
        >>> octagon = epsnet.Surface.octagon(seed=5)
        >>> octagon.gradient(octagon.spectrum(3)[0]).length.width < 1e-9
        True
        """
        return gradient(self, word, second, threads)

    def maximize_systole(self, *, steps: int = 200, threads: int = 0, progress: Progress = None) -> SystoleMaximum:
        """Climbs from this surface, in its Fenchel–Nielsen coordinates, to a local maximum of the systole, and proves that one is near. ``steps`` is
        the number of surfaces that are looked at, at most.

        >>> import epsnet
        >>> found = epsnet.Surface.octagon(123).maximize_systole()
        >>> abs(found.systole.mid - epsnet.Surface.named("bolza").systole().mid) < 1e-12, len(found.systoles)
        (True, 12)
        """
        return maximize_systole(self, steps, threads, progress)

    def mapping_class(self, product: Any = "") -> MappingClass:
        """A product of Dehn twists, of which the last one acts first: a text such as ``"a1 b2^-1 C1 (1 6)^2"``, with names of
        ``mapping_class_generators()``, in upper case for inverses, or simple closed curves as words in parentheses, of sides or of letters as
        ``"(abAB)^2"``; or pairs of a curve and a power.

        >>> import epsnet
        >>> surface = epsnet.Surface.octagon(123)
        >>> surface.mapping_class("a1 b1").homology
        ((0, -1, 0, 0), (1, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))
        """
        return mapping_class(self, product)

    def mapping_class_generators(self) -> dict[str, tuple[int, ...]]:
        """Names and words of simple closed curves a1, …, b1, …, c1, …: b_i meets a_i, and c_i meets b_i and b_{i+1}, once, and no others meet. Twists
        along a1, a2, all b_i and all c_i generate the mapping class group (Humphries).

        >>> import epsnet
        >>> list(epsnet.Surface.octagon(123).mapping_class_generators())
        ['a1', 'a2', 'b1', 'b2', 'c1']
        """
        return {name: tuple(word) for name, word in self._mapping_class_group.generators}

    @cached_property
    def _mapping_class_group(self) -> "_epsnet.MappingClassGroup":
        return _epsnet.MappingClassGroup(self._core)

    def curves(self, words: Iterable[Any], *, threads: int = 0, progress: Progress = None) -> ClosedCurves:
        """What ``curve`` says of many closed curves, proved: their lengths, powers, self-intersections, intersection numbers, classes in homology;
        and, if they fill the surface, that they do. The curves of ``homology_basis()`` follow the given ones. ArgumentError for a null-homotopic one.

        >>> import epsnet
        >>> surface = epsnet.Surface.octagon(123)
        >>> curves = surface.curves([[0], [1], [2], [3]])
        >>> curves
        <ClosedCurves: 8, the basis of homology [4, 5, 6, 7]>
        >>> curves[0].simple, curves.intersections(0, 1), curves.filling
        (True, 1, [(0, 1, 2, 3)])
        """
        return curves(self, words, threads, progress)

    def fills(self, curves: Iterable[Any]) -> bool:
        """Whether closed curves fill the surface: whether all components of the complement of their closed geodesics are disks. Decided by words
        alone, exactly; no checker looks at it, ``curves`` proves it of those that do. LimitError for curves that are too long for that.

        >>> import epsnet
        >>> surface = epsnet.Surface.octagon(123)
        >>> surface.fills([[0], [1], [2], [3]]), surface.fills([[0], [1]])
        (True, False)
        """
        return fills(self, curves)

    # The Laplacian.

    def eigenvalues(
        self, count: Optional[int] = None, *, below: Optional[Number] = None, digits: Optional[int] = None, epsilon: Optional[Number] = None,
        phases: Optional[Sequence[Number]] = None, box: Optional[Number] = None, threads: int = 0, progress: Progress = None
    ) -> Eigenvalues:
        """The first ``count`` eigenvalues of the Laplacian, 10 by default and at most 1000, with multiplicity, in proved intervals, and those
        that cannot be told apart from the last one; or, with ``below``, all that are less than this number, at most 10000.

        ``digits``: about so many of each, from 1 to 10; by default 9, and with ``below`` 3, and no more than their number needs. Up to 2 take
        much less time; from 3 on there are eigenfunctions. ``epsilon``: of the net on which they are counted; by default at most 0.6.

        ``phases``: 2g numbers of turns, the phases of a character χ of the group on the sides ``character_sides``. The eigenvalues are then those
        of functions f on the plane with f(γz) = χ(γ) f(z), from λ_0 on, with up to 3 digits, 2 by default. ``box``: the intervals hold for all
        phases that are at most so many turns from these, each of the 2g.

        NetError if they are not found, LimitError if it takes too many triangles.

        >>> import epsnet
        >>> first = epsnet.Surface.regular(2).eigenvalues(7, digits=6)
        >>> [(row.first, row.count, value in row.interval) for row, value in zip(first, (3.8388872588, 5.3536013412))]
        [(1, 3, True), (4, 4, True)]
        """
        return eigenvalues(self, count, below, digits, epsilon, phases, box, threads, progress)

    @property
    def character_sides(self) -> Tuple[int, ...]:
        """The 2g sides whose phases determine a character of the group, as ``eigenvalues`` and ``bands`` take them: the first ones of the pairs of
        sides of the fundamental polygon, without the pairs of a spanning tree if its corners are several vertices of the surface."""
        return tuple(_epsnet.character_sides(self._core))

    def side_phases(self, phases: Sequence[Number]) -> Tuple[Fraction, ...]:
        """The phase θ of each side, in (−1/2, 1/2], from the 2g of ``character_sides``, in turns. A function with these phases, in the coordinates
        of each tile, is multiplied by e^{2πiθ} where the side is crossed.

        For a lattice with a site in each tile, this is the matrix of its hops, Hermitian:

        >>> import numpy as np, epsnet
        >>> surface = epsnet.Surface.named("klein")
        >>> tile = [t for t, polygon in enumerate(surface.tiles) for _ in polygon]
        >>> hops = np.zeros((24, 24), dtype=complex)
        >>> for side, phase in enumerate(surface.side_phases(("1/3", 0, 0, 0, 0, "1/2"))):
        ...     hops[tile[side], tile[surface.partner(side)]] += np.exp(-2j * np.pi * float(phase))
        >>> bool(np.allclose(hops, hops.conj().T)), bool(np.linalg.eigvalsh(hops)[-1] < 7)
        (True, True)
        """
        return side_phases(self, phases)

    def bands(
        self, path: Iterable[Sequence[Number]], *, steps: int = 1, count: int = 4, digits: Optional[int] = None, epsilon: Optional[Number] = None,
        threads: int = 0, progress: Progress = None
    ) -> Bands:
        """The first ``count`` eigenvalues with phases, λ_0 and so on, at points of the torus of characters, in proved intervals.

        ``path``: points, each 2g numbers of turns, the phases on the sides ``character_sides``; ``steps``: so many between two of them;
        ``digits``: about so many of each eigenvalue, from 1 to 3, by default 2; ``epsilon``: of the net, which all points share.

        NetError if they are not found, LimitError if it takes too many triangles.

        >>> import epsnet
        >>> bands = epsnet.Surface.regular(2).bands([(0, 0, 0, 0), ("1/2", 0, 0, 0)], steps=2, count=2, digits=1)
        >>> bands
        <Bands: 2 at 3 points>
        >>> [0.77 in bands.interval(point, 0) for point in range(3)]
        [False, False, True]
        """
        return bands(self, path, steps, count, digits, epsilon, threads, progress)

    def gap(
        self, outside: Number, at_least: Number, *, most: int = 1_000_000, epsilon: Optional[Number] = None, threads: int = 0,
        progress: Progress = None
    ) -> int:
        """Proves that λ_0 with phases is at least a number wherever one of the 2g phases is farther than ``outside`` turns from an integer: by boxes
        of phases, each with a proof as that of ``eigenvalues(phases=…, box=…)``. Returns how many boxes cover half of the torus; the inverse
        characters have the same eigenvalues.

        ``most``: no more boxes than that; their number grows as a power 2g of how near the bound is. ``epsilon``: of the net, by default 0.4.

        NetError if it is not proved, LimitError for genus 5 and more.

        >>> import epsnet
        >>> epsnet.Surface.regular(2).gap("3/8", "0.001", most=100)
        Traceback (most recent call last):
        epsnet.errors.NetError: it takes more than 100 boxes: the bound is near the least value, or the radius small
        """
        return gap(self, outside, at_least, most, epsilon, threads, progress)

    # Distances.

    def distance(self, p: PointLike, q: PointLike, *, width: Number = 1e-12) -> Distance:
        """The distance between two points in a proved interval, with all shortest geodesics between them.

        A point is a ``Point``, (tile, x, y), or a tile, for its centre; of a net, ``net.point(17)``. One of the two must be strictly inside of
        its tile. The interval is as narrow as floats allow; NetError if it is wider than ``width``.

        >>> import epsnet
        >>> d = epsnet.Surface.regular(2).distance((0, "1/3", "1/5"), (0, "-0.6", "1/7"))
        >>> d.width < 1e-12, len(d.paths)
        (True, 1)
        """
        return distance(self, p, q, width)

    def diameter(self, width: Number = 1e-6, *, threads: int = 0, progress: Progress = None) -> Diameter:
        """The greatest distance of two points, in a proved interval at most ``width`` wide.

        >>> import epsnet
        >>> diameter = epsnet.Surface.regular(2).diameter("1e-9")
        >>> diameter.proved, diameter.width <= 1e-9, round(diameter.mid, 8)
        (True, True, 2.44845245)
        """
        return _of_kind(cover(self, "diameter", width, threads, progress), Diameter)

    def radius(self, width: Number = 1e-2, *, threads: int = 0, progress: Progress = None) -> Radius:
        """The least r such that a disk of radius r covers the surface, the least eccentricity, in a proved interval at most ``width`` wide.
        It takes much longer than the diameter: the time grows as 1/width.

        >>> import epsnet
        >>> radius = epsnet.Surface.regular(2).radius("0.1")
        >>> radius.proved, radius.width <= 0.1, 1.8 < radius.lower < radius.upper < 2.1
        (True, True, True)
        """
        return _of_kind(cover(self, "radius", width, threads, progress), Radius)

    def embedded_disk(self, width: Number = 1e-6, *, threads: int = 0, progress: Progress = None) -> EmbeddedDisk:
        """The radius of the largest embedded disk, the greatest injectivity radius, in a proved interval at most ``width`` wide."""
        return _of_kind(cover(self, "embedded-disk", width, threads, progress), EmbeddedDisk)

    def eccentricity(self, p: PointLike) -> Eccentricity:
        """The greatest distance of a point of the surface from p, in a proved interval; p must be strictly inside its tile."""
        return eccentricity(self, p)

    # As a value.

    def __eq__(self, other: object) -> bool:
        """Whether tiles and gluing are equal. Isometric surfaces may have different tiles and gluings."""
        return isinstance(other, Surface) and self._core == other._core

    def __hash__(self) -> int:
        return hash((self.genus, self._core.side_count))

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled, (self._core.text(), self._name)

    def __repr__(self) -> str:
        return f"<Surface {self._name or self._kind()}, genus {self.genus}>"

    def _kind(self) -> str:
        """What its tiles are, in words."""
        if self._core.is_regular_polygon:
            return f"regular({self.genus})"
        if self._core.regular_tile is not None:
            p, q = self._core.regular_tile
            return f"that is a map of type {{{p}, {q}}}"
        tiles = len(self._core.tiles)
        return f"of {tiles} tile{'' if tiles == 1 else 's'}"

    def svg(self, size: int = 600) -> str:
        """The tiles, laid out around one of them; sides that are glued to each other have one colour."""
        return self._core.svg(as_index(size, "size", 50, 20000))


def loaded_name(path: Path) -> str:
    """The name of a surface of a file."""
    return call("load", shown(as_path(path)))


def _curve_name(curve: Any) -> str:
    return shown(getattr(curve, "word", curve))


def _unpickled(text: bytes, name: str) -> Surface:
    return Surface._of(_epsnet.Surface.parse(text, "pickle"), name)


def _of_kind(found: Any, kind: Type[_Kind]) -> _Kind:
    assert isinstance(found, kind)
    return found


def _corner(z: Any, name: str) -> tuple[Fraction, Fraction]:
    if isinstance(z, Gaussian):
        return z.re, z.im
    parts = (z.real, z.imag) if isinstance(z, (complex, np.complexfloating)) else as_items(z, name, "pairs (x, y)")
    if len(parts) != 2:
        refuse("pairs (x, y)", z, name)
    return as_fraction(parts[0], name), as_fraction(parts[1], name)


def _numbers(numbers: Union[Number, Sequence[Number], None], name: str) -> Union[Number, Sequence[Number], None]:
    """One number, or a list of them."""
    return as_items(numbers, name, "numbers") if isinstance(numbers, Iterable) and not isinstance(numbers, str) else numbers


def _texts(numbers: Union[Number, Sequence[Number], None], name: str) -> list[str]:
    if numbers is None:
        return []
    return [as_text(x, name) for x in (numbers if isinstance(numbers, list) else [numbers])]


Document._surface_class = Surface
