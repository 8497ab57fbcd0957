"""ε-nets."""
from __future__ import annotations

import html
import json
import os
from functools import cached_property
from typing import TYPE_CHECKING, Any, Iterable, NamedTuple, Optional, Sequence, Union

import numpy as np

from . import _epsnet
from ._annotations import Surface
from ._arguments import (
    Number, Path, as_choice, as_flag, as_fraction, as_index, as_indices, as_items, as_optional_path, as_path, as_string, as_threads, length_text,
    refuse,
)
from ._documents import Document, certified, read
from ._pictures import Drawn
from ._progress import Progress, Shower
from .certificates import Certificate
from .errors import FormatError, LimitError, NotVerifiedError
from .intervals import Interval
from .points import Point, PointLike, base_point, point_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Complexes = NDArray[np.complex128]
    Floats = NDArray[np.float64]
    Indices = NDArray[np.uint32]

__all__ = ["Collar", "DistanceTable", "Lifts", "Location", "Net", "Page"]

_COLOURS = ("none", "circumradius", "chart", "distance")
_FORMATS = ("gmsh", "gmsh-glued", "medit", "mfem", "vtu", "off", "edges", "adjacency", "face-adjacency", "json", "triangulation")


class Collar(NamedTuple):
    """The collar of a short closed geodesic that a pseudo net leaves empty."""

    #: The closed geodesic, as a word.
    core: list[int]
    #: Its length.
    length: Interval
    #: The vertices of the two loops around the collar.
    vertices: tuple[int, int]
    #: The two triangles between them.
    triangles: tuple[int, int]


class Lifts:
    """One lift of every triangle of a net to the Poincaré disk, as in pictures; their union is connected. Rounded to binary64, not proved."""

    def __init__(self, triangles: "Indices", corners: "Complexes", places: "Indices") -> None:
        #: The number of each triangle, in the order of lifting.
        self.triangles = triangles
        #: The corners, counterclockwise, in the order of lifting: an array with three columns.
        self.corners = corners
        #: By triangle: its index in that order. ``lifts.corners[lifts.places]`` has the triangles in the order of the net.
        self.places = places

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Lifts) and np.array_equal(self.triangles, other.triangles) and np.array_equal(self.corners, other.corners)

    __hash__ = None  # type: ignore[assignment]

    def __len__(self) -> int:
        return len(self.triangles)


class Location(NamedTuple):
    """A triangle of a net that contains a point, and the position of the point in it."""

    #: "inside", "side" or "corner": decided exactly. A point on a side lies in several triangles, of which this is one.
    place: str
    #: The number of the triangle.
    triangle: int
    #: The number of the side (from this corner to the next one) or of the corner; 0 if the point is inside.
    number: int
    #: The sides that a path crosses from the tile of the point to that of the triangle's chart: the lift that contains the point.
    word: tuple[int, ...]
    #: By corner: the weights that ``net.point_of_triangle`` takes, scaled to the sum 1. Rounded, not proved.
    weights: tuple[float, float, float]
    #: By corner: its hyperbolic distance from the point within the triangle. Rounded, not proved.
    distances: tuple[float, float, float]
    #: The vertex at the nearest corner. If a triangle is obtuse, a vertex of another triangle may be nearer.
    nearest: int


class DistanceTable:
    """Distances (hyperbolic lengths) from some vertices of a net, the rows, to others, the columns.

    The bounds hold by an error analysis (docs/distances.md, "One to many") for triangles that are proved to triangulate the surface, which
    the checker has verified. There is no certificate for the numbers themselves, so the intervals say ``proved=False``;
    ``surface.distance`` makes a certificate for a pair.

    >>> import epsnet
    >>> net = epsnet.Surface.octagon(seed=123).net("0.25")
    >>> table = net.distances([0, 17])
    >>> table.mid.shape, table.error < 1e-12
    ((2, 143), True)
    >>> bool(table[1, 5].lower == table.lower[1, 5])
    True
    """

    def __init__(self, rows: "Indices", columns: "Indices", bounds: "Floats") -> None:
        #: The vertex of each row.
        self.rows = rows
        #: The vertex of each column.
        self.columns = columns
        #: Both bounds of each distance: an array of the shape (rows, columns, 2).
        self.bounds = bounds

    @property
    def lower(self) -> "Floats":
        """The lower bounds, an array with a row for each vertex of ``rows``. Shares memory."""
        return self.bounds[:, :, 0]

    @property
    def upper(self) -> "Floats":
        """The upper bounds. Shares memory."""
        return self.bounds[:, :, 1]

    @cached_property
    def mid(self) -> "Floats":
        """A number near each distance, by at most ``error``."""
        middle: "Floats" = self.lower + (self.upper - self.lower) / 2
        middle.flags.writeable = False
        return middle

    @cached_property
    def error(self) -> float:
        """A bound for the errors of all of ``mid``."""
        if self.mid.size == 0:
            return 0.0
        return float(np.nextafter(max((self.upper - self.mid).max(), (self.mid - self.lower).max()), np.inf))

    def __getitem__(self, place: tuple[int, int]) -> Interval:
        """The distance in a row and a column, in an interval."""
        try:
            row, column = place
        except (TypeError, ValueError):
            refuse("a row and a column", place, "place")
        least, most = self.bounds[as_index(row, "row", 0, len(self.rows) - 1), as_index(column, "column", 0, len(self.columns) - 1)]
        return Interval(float(least), float(most))

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, DistanceTable) and np.array_equal(self.rows, other.rows) and np.array_equal(self.columns, other.columns)
            and np.array_equal(self.bounds, other.bounds)
        )

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"<DistanceTable: {len(self.rows)} x {len(self.columns)}, error at most {self.error:.2g}>"


class Net(Drawn, Document):
    """An ε-net of a surface with its Delaunay triangulation.

    >>> import epsnet
    >>> net = epsnet.Surface.octagon(seed=123).net("0.25")
    >>> len(net.vertices), len(net.edges), len(net.triangles)
    (143, 435, 290)
    >>> str(net.certificate)
    'VERIFIED'

    Arrays are read-only and share the memory of the net. A vertex is a point of the disk of a chart; a triangle has its corners
    counterclockwise in the chart of its first one. Dart 3t + i is the edge of triangle t from corner i to the next one.
    The vertices are exact; ``corners``, ``edge_lengths``, ``circumradii`` and ``lifts`` are rounded to binary64 and not proved:
    what is proved is in ``certificate.enclosures``.
    """

    _core: "_epsnet.Net"

    def __init__(
        self, core: "_epsnet.Net", surface: Optional["Surface"], certificate: Optional[Certificate], statistics: Optional[dict[str, Any]] = None
    ) -> None:
        self._hold(core, surface, certificate)
        #: What was counted while the net was made; None for a net of a file.
        self.statistics = statistics

    @classmethod
    def _computed(
        cls, surface: "Surface", epsilon: Number, *, base: Optional[PointLike], points: Iterable[PointLike], pseudo: bool, sparse: bool,
        threads: int, progress: Progress,
    ) -> "Net":
        start = None if base is None else base_point(surface._core, base, "base")
        given = [base_point(surface._core, p, "points") for p in as_items(points, "points", "points")]
        for name, chosen in (("pseudo", as_flag(pseudo, "pseudo")), ("sparse", as_flag(sparse, "sparse"))):
            if chosen and given:
                refuse("False with points, as it would move or remove them", chosen, name)
        options = _epsnet.NetOptions(start, given, pseudo, sparse, as_threads(threads))
        text = length_text(epsilon, "epsilon")
        with Shower(progress) as callback:
            core, certificate, statistics = _epsnet.Net.compute(surface._core, text, options, callback)
        return cls(core, surface, Certificate(certificate), statistics)

    @classmethod
    def of_tiles(cls, surface: "Surface", epsilon: Number) -> "Net":
        """The tiles of a surface as the triangles of a net, unchanged. All must be triangles. ``certificate`` decides whether this is an ε-net."""
        if not isinstance(surface, cls._surface_class):
            refuse("a Surface", surface, "surface")
        return cls(_epsnet.Net.of_tiles(surface._core, length_text(epsilon, "epsilon")), surface, None)

    @classmethod
    def load(cls, path: Path, *, check: bool = True, progress: Progress = None) -> "Net":
        """The net of a net file. Raises FormatError, or NotVerifiedError unless it is verified. With ``check=False`` the check is
        delayed until the first use of ``certificate``."""
        check, shower = as_flag(check, "check"), Shower(progress)
        name, core = read(path)
        if not isinstance(core, _epsnet.Net):
            raise FormatError(f"expected a net file, not {type(core).__name__}", file=name, place="format")
        return cls(core, None, certified(core, name, shower) if check else None)

    def save(self, path: Path) -> None:
        """Writes a net file, completely or not at all: for ``epsnet.load``, and for the program ``certify``. A file whose name ends in .epsn
        gets the compact form, any other JSON."""
        name = as_path(path)
        if name.endswith(".epsn"):
            self._core.save_compact(name)
        else:
            self._core.save(name)

    def _surface_core(self) -> "_epsnet.Surface":
        return self._core.surface

    def _more(self) -> tuple[Any, ...]:
        return (self.statistics,)

    # What it is.

    @property
    def epsilon(self) -> str:
        """ε, as given: a decimal or a quotient."""
        return self._core.epsilon

    @property
    def vertices(self) -> "Complexes":
        """The vertices, each in the disk of its chart; exact."""
        return self._core.vertices

    @property
    def vertex_charts(self) -> "Indices":
        """The chart of each vertex."""
        return self._core.vertex_charts

    @property
    def charts(self) -> list[Point]:
        """Each chart is the disk of a tile with the origin moved to this point."""
        return [point_of(base) for base in self._core.charts]

    @property
    def triangles(self) -> "Indices":
        """The vertices of each triangle, counterclockwise: three columns."""
        return self._core.triangles

    @property
    def opposite(self) -> "Indices":
        """The dart on the other side of each dart: three columns, a row for each triangle."""
        return self._core.opposite

    @property
    def corner_labels(self) -> "Indices":
        """The labels of corners 1 and 2 of each triangle, which take them to the chart of corner 0; label 0 is the identity."""
        return self._core.corner_labels

    @property
    def labels(self) -> list[tuple[int, int, list[int]]]:
        """Label k + 1 as (from chart, to chart, word)."""
        return self._core.labels

    @cached_property
    def edge_darts(self) -> "Indices":
        """One dart of each edge, the smaller one of two."""
        return self._core.edge_darts()

    @cached_property
    def edges(self) -> "Indices":
        """The two vertices of each edge, in the order of ``edge_darts``. There may be loops, and several edges between two vertices."""
        darts = self.edge_darts
        ends: "Indices" = np.stack([self.triangles[darts // 3, darts % 3], self.triangles[darts // 3, (darts + 1) % 3]], axis=1)
        ends.flags.writeable = False
        return ends

    @property
    def collars(self) -> Optional[list[Collar]]:
        """The collars of a pseudo net; None for any other net."""
        collars = self._core.collars
        if collars is None:
            return None
        return [Collar(core, Interval(*length, proved=self.proved), (vertices[0], vertices[1]), (triangles[0], triangles[1])) for core, length, vertices, triangles in collars]

    # Rounded numbers.

    @cached_property
    def _geometry(self) -> tuple["Complexes", "Floats", "Floats", "Complexes"]:
        return self._core.geometry()

    @property
    def corners(self) -> "Complexes":
        """The corners of each triangle in the chart of its corner 0: three columns. Rounded, not proved."""
        return self._geometry[0]

    @property
    def centred_corners(self) -> "Complexes":
        """The corners of each triangle after an isometry that takes its circumcentre to 0: three columns. Rounded, not proved.

        For finite elements: the Euclidean triangle has the same circumcircle, and no angle α with sin α < 1/(2 cosh(ε/2)), which is about 30°,
        as edges are at least ε long and circumradii at most ε (loops apart). The hyperbolic metric there is 4|dz|²/(1 − |z|²)².
        """
        return self._geometry[3]

    @property
    def circumradii(self) -> "Floats":
        """The hyperbolic circumradius of each triangle. Rounded, not proved; ``certificate.enclosures`` has a proved bound."""
        return self._geometry[1]

    @property
    def edge_lengths(self) -> "Floats":
        """The hyperbolic length of each edge, in the order of ``edges``. Rounded, not proved."""
        lengths: "Floats" = self._geometry[2].reshape(-1)[self.edge_darts]
        return lengths

    def lifts(self, centre: int = 0, *, order: str = "weight") -> Lifts:
        """One lift of every triangle to the disk, with a vertex at 0; the order is "weight", as in pictures, or "breadth first"."""
        breadth_first = as_choice(order, "order", ("weight", "breadth first")) == "breadth first"
        core = self._core.lifts(breadth_first, as_index(centre, "centre"))
        return Lifts(core.triangles, core.corners, core.places)

    def info(self) -> dict[str, Any]:
        """A summary: counts against the bounds of the thesis, edges, circumradii, and so on. Rounded, not proved."""
        facts: dict[str, Any] = json.loads(self._core.info())
        return facts

    # Points and distances.

    def point(self, vertex: int) -> Point:
        """A vertex as a point of the tile in which it lies, exactly: for ``surface.distance``.

        >>> import epsnet
        >>> net = epsnet.Surface.octagon(seed=123).net("0.25")
        >>> d = net.surface.distance(net.point(3), net.point(17))
        >>> d.proved
        True
        """
        return point_of(self._core.point_of_vertex(self.surface._core, as_index(vertex, "vertex")))

    def point_of_triangle(self, triangle: int, weights: Sequence[Number] = (1, 1, 1)) -> Point:
        """The point of a triangle with these weights on its corners in the hyperboloid model; (1, 1, 1) is the centroid. Its coordinates are
        exact for one weight that is not 0, else rounded to multiples of 2⁻¹⁰⁰: the point that is returned is exact all the same."""
        numbers = [as_fraction(x, "weights") for x in as_items(weights, "weights", "three weights")]
        if len(numbers) != 3:
            refuse("three weights", weights, "weights")
        return point_of(self._core.point_of_triangle(self.surface._core, as_index(triangle, "triangle"), numbers))

    @cached_property
    def _locator(self) -> "_epsnet.Locator":
        return _epsnet.Locator(self._core)

    def locate(self, p: PointLike) -> Location:
        """A triangle that contains a point, decided exactly, and where in it the point is.

        The first call prepares the net; after it, a call takes some 10 µs. A point is a ``Point``, (tile, x, y), or a tile, for its centre.

        >>> import epsnet
        >>> net = epsnet.Surface.octagon(seed=123).net("0.25")
        >>> at = net.locate(net.point(17))
        >>> at.place, at.nearest, at.distances[at.number]
        ('corner', 17, 0.0)
        """
        return Location(*self._locator.locate(base_point(self.surface._core, p, "p")))

    def distances(
        self, rows: Union[int, Iterable[int], None] = None, columns: Union[int, Iterable[int], None] = None, *, threads: int = 0,
        progress: Progress = None,
    ) -> DistanceTable:
        """The distances between vertices, with bounds: from one (``net.distances(0)``), from many, or between all pairs (``net.distances()``).

        ``rows``: the vertices from which, ``columns``: those to which; one vertex, or many, or None for all. It takes one search of the net
        for each row. Raises NotVerifiedError unless the triangles are proved to triangulate the surface.

        >>> import epsnet
        >>> net = epsnet.Surface.octagon(seed=123).net("0.25")
        >>> net.distances(0, range(10, 20)).bounds.shape
        (1, 10, 2)
        """
        start, end = self._vertices(rows, "rows"), self._vertices(columns, "columns")
        threads = as_threads(threads)
        _require_memory(len(start), len(end))
        verdicts = {rule.name: rule.verdict for rule in self.certificate.rules}
        if any(verdicts.get(name) != "VERIFIED" for name in ("surface", "map", "gluing", "orientation")):
            raise NotVerifiedError(f"the triangles are not proved to triangulate the surface: {self.certificate}", self.certificate)
        with Shower(progress) as callback:
            bounds = self._core.distances(start, end, threads, callback)
        return DistanceTable(np.array(start, dtype=np.uint32), np.array(end, dtype=np.uint32), bounds)

    def _vertices(self, chosen: Union[int, Iterable[int], None], name: str) -> list[int]:
        if chosen is None:
            return list(range(len(self)))
        if isinstance(chosen, (int, np.integer)):
            chosen = [int(chosen)] if not isinstance(chosen, bool) else refuse("a vertex", chosen, name)
        return as_indices(chosen, name, len(self) - 1)

    # Pictures and files.

    def svg(
        self,
        *,
        centre: int = 0,
        triangles: bool = True,
        vertices: bool = True,
        dirichlet: bool = False,
        combinatorial_dirichlet: bool = False,
        tiles: bool = False,
        disks: bool = False,
        half_disks: bool = False,
        colour: str = "none",
        legend: bool = False,
        order: str = "weight",
        size: int = 600,
        show: Iterable[Any] = (),
    ) -> str:
        """A picture: one lift of every triangle in the Poincaré disk.

        ``centre``: the vertex in the centre; ``dirichlet``: its Dirichlet domain; ``combinatorial_dirichlet``: the outline of the triangles
        lifted breadth first from it; ``tiles``: the sides of the tiles; ``disks``, ``half_disks``: disks of radius ε and ε/2 around the
        vertices; ``colour``: "none", "circumradius", "chart" or "distance", that from the centre; ``order``: "weight" or "breadth first", as
        for ``lifts``; ``size``: in pixels; ``show``: closed geodesics, distances or spectra of the same surface to be drawn on top.
        """
        return self._core.svg(_epsnet.DrawOptions(
            centre=as_index(centre, "centre"), triangles=as_flag(triangles, "triangles"), vertices=as_flag(vertices, "vertices"),
            dirichlet=as_flag(dirichlet, "dirichlet"), combinatorial_dirichlet=as_flag(combinatorial_dirichlet, "combinatorial_dirichlet"),
            tiles=as_flag(tiles, "tiles"), disks=as_flag(disks, "disks"), half_disks=as_flag(half_disks, "half_disks"),
            colour=as_choice(colour, "colour", _COLOURS), legend=as_flag(legend, "legend"),
            breadth_first=as_choice(order, "order", ("weight", "breadth first")) == "breadth first", size=as_index(size, "size", 50, 20000),
        ), self._layers(show))

    def _layers(self, show: Iterable[Any]) -> list["_epsnet.Layer"]:
        layers = []
        for shown in as_items(show, "show", "things to draw"):
            if not hasattr(shown, "_layers_on"):
                refuse("closed geodesics, distances or spectra", shown, "show")
            layers += shown._layers_on(self._core)
        return layers

    def view(self, title: str = "", *, show: Iterable[Any] = (), height: int = 640) -> "Page":
        """A page to travel in the surface, with the verdict of the net: in a notebook, or ``.save("view.html")``."""
        heading = as_string(title, "title") or repr(self)
        height = as_index(height, "height", 50, 20000)
        return Page(self._core.page(heading, self.certificate._core, self._layers(show)), height)

    def export(self, format: str, path: Optional[Path] = None, *, distance_from: Optional[int] = None) -> Optional[bytes]:
        """The net in another format, for programs that compute with meshes (docs/exchange-formats.md); written to the path, or returned.

        For finite elements (docs/finite-elements.md) "gmsh" and "medit": one lift of each triangle, a planar mesh with its sides glued in
        pairs; "mfem" and "gmsh-glued": the glued surface. "vtu" and "off": one lift; "edges": a table; "adjacency" and "face-adjacency": the
        matrix of the graph of vertices or triangles, for MatrixMarket; "json": all of it; rounded.
        "triangulation": CGAL's, exactly. ``distance_from``, for "vtu": also the distance of every vertex from this one, as the array
        ``distance`` at points.
        """
        form = as_choice(format, "format", _FORMATS)
        file = as_optional_path(path)
        if distance_from is not None:
            as_index(distance_from, "distance_from", 0, len(self) - 1)
            if form != "vtu":
                refuse('None unless the format is "vtu"', distance_from, "distance_from")
        text = self._core.exported(form, distance_from)
        if file is None:
            return text
        _epsnet.write_text(text, file)
        return None

    def __len__(self) -> int:
        """The number of vertices."""
        return len(self._core.vertices)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Net) and self._core == other._core

    def __hash__(self) -> int:
        return hash((len(self), self.epsilon))

    def __repr__(self) -> str:
        verdict = self.certificate.verdict if self._proof._certificate is not None else "not checked"
        kind = "Net" if self._core.collars is None else "Pseudo net"
        return f"<{kind}: {len(self)} vertices, epsilon {self.epsilon}, genus {self.surface.genus}, {verdict}>"


def _require_memory(rows: int, columns: int) -> None:
    """Raises LimitError if the table is larger than the machine's memory: before the work, not after it."""
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    if 16 * rows * columns > 0.8 * memory:
        raise LimitError(f"{rows} x {columns} distances take {16e-9 * rows * columns:.3g} GB, the machine has {1e-9 * memory:.3g} GB")


class Page:
    """A self-contained HTML page; a notebook shows it in a frame."""

    def __init__(self, text: str, height: int) -> None:
        #: The page.
        self.html = text
        self._height = height

    def save(self, path: Path) -> None:
        """Writes the page to a file, completely or not at all."""
        _epsnet.write_text(self.html.encode(), as_path(path))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Page) and self.html == other.html

    def __hash__(self) -> int:
        return hash(self.html)

    def _repr_html_(self) -> str:
        return f'<iframe srcdoc="{html.escape(self.html)}" width="100%" height="{self._height}" style="border:0"></iframe>'

    def __repr__(self) -> str:
        return f"<Page of {len(self.html)} characters>"
