"""ε-nets."""
from __future__ import annotations

import html
import os
from functools import cached_property
from typing import TYPE_CHECKING, Any, Iterable, NamedTuple, Optional

import numpy as np

from . import _epsnet
from ._progress import Progress, Shower
from .certificates import Certificate, Proof
from .intervals import Interval
from .surfaces import Number, Path, Point, PointLike, Surface, as_index, length_text

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .geodesics import ClosedGeodesics

    Complexes = NDArray[np.complex128]
    Floats = NDArray[np.float64]
    Indices = NDArray[np.uint32]

__all__ = ["Collar", "Lifts", "Net", "Page"]


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

    def __init__(self, core: "_epsnet.Lifts") -> None:
        self._core = core

    @property
    def triangles(self) -> "Indices":
        """The number of each triangle, in the order of lifting. Shares memory."""
        return self._core.triangles

    @property
    def corners(self) -> "Complexes":
        """The corners, counterclockwise, in the order of lifting: an array with three columns. Shares memory."""
        return self._core.corners

    @property
    def places(self) -> "Indices":
        """By triangle: its index in that order. ``lifts.corners[lifts.places]`` has the triangles in the order of the net."""
        return self._core.places

    def __len__(self) -> int:
        return len(self._core.triangles)


class Net:
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

    def __init__(self, core: "_epsnet.Net", surface: Optional[Surface], certificate: Optional[Certificate], statistics: Optional[dict[str, Any]]) -> None:
        self._core = core
        self._surface = surface
        self._proof = Proof(core, certificate)
        #: What was counted while the net was made; None for a net of a file.
        self.statistics = statistics

    @classmethod
    def _computed(cls, surface: Surface, epsilon: Number, pseudo: bool, base: Optional[PointLike], threads: int, progress: Progress) -> "Net":
        point = None if base is None else surface._base(base)
        with Shower(progress) as callback:
            core, certificate, statistics = _epsnet.Net.compute(surface._core, length_text(epsilon, "epsilon"), point, pseudo, as_index(threads, "threads", 0, 1024), callback)
        return cls(core, surface, Certificate(certificate), statistics)

    @classmethod
    def of_tiles(cls, surface: Surface, epsilon: Number) -> "Net":
        """The tiles of a surface as the triangles of a net, unchanged. All must be triangles. ``certificate`` decides whether this is an ε-net."""
        return cls(_epsnet.Net.of_tiles(surface._core, length_text(epsilon, "epsilon")), surface, None, None)

    @classmethod
    def load(cls, path: Path, *, check: bool = True) -> "Net":
        """The net of a net file. Raises FormatError, or NotVerifiedError unless it is verified. With ``check=False`` the check is
        delayed until the first use of ``certificate``."""
        from .files import load

        net = load(path, check=check)
        if not isinstance(net, Net):
            from .errors import FormatError

            raise FormatError(f"{_epsnet.display_name(os.fspath(path))}: format: expected a net file, not {type(net).__name__}")
        return net

    def save(self, path: Path) -> None:
        """Writes a net file, completely or not at all: for ``epsnet.load``, and for the program ``certify``."""
        self._core.save(os.fspath(path))

    # What it is.

    @property
    def certificate(self) -> Certificate:
        """The certificate of the net, made with the net; computed on first use if the net was loaded with ``check=False``."""
        return self._proof.certificate

    @property
    def proved(self) -> bool:
        """Whether the net was checked and verified."""
        return self._proof.proved

    @property
    def surface(self) -> Surface:
        """The surface of the net."""
        if self._surface is None:
            self._surface = Surface._of(self._core.surface)
        return self._surface

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
        return [Point(tile, x, y) for tile, (x, y) in self._core.charts]

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
        if order not in ("weight", "breadth first"):
            raise ValueError(f'expected the order "weight" or "breadth first", not "{order}"')
        return Lifts(self._core.lifts(order == "breadth first", as_index(centre, "centre")))

    def point(self, vertex: int) -> Point:
        """A vertex as a point of the tile in which it lies, exactly: for ``surface.distance``.

        >>> import epsnet
        >>> net = epsnet.Surface.octagon(seed=123).net("0.25")
        >>> d = net.surface.distance(net.point(3), net.point(17))
        >>> d.proved
        True
        """
        tile, (x, y) = self._core.point_of_vertex(self.surface._core, as_index(vertex, "vertex"))
        return Point(tile, x, y)

    # Pictures and files.

    def svg(
        self,
        *,
        centre: int = 0,
        triangles: bool = True,
        vertices: bool = True,
        dirichlet: bool = False,
        tiles: bool = False,
        colour: str = "none",
        legend: bool = False,
        size: int = 600,
        show: Iterable[Any] = (),
    ) -> str:
        """A picture: one lift of every triangle in the Poincaré disk.

        ``centre``: the vertex in the centre; ``dirichlet``: its Dirichlet domain; ``tiles``: the sides of the tiles; ``colour``: "none",
        "circumradius" or "chart"; ``show``: closed geodesics, distances or spectra of the same surface to be drawn on top.
        """
        if colour not in ("none", "circumradius", "chart"):
            raise ValueError(f'expected the colour "none", "circumradius" or "chart", not "{colour}"')
        return self._core.svg(
            as_index(centre, "centre"), triangles, vertices, dirichlet, tiles, colour, legend, as_index(size, "size", 50, 20000), self._layers(show)
        )

    def _layers(self, show: Iterable[Any]) -> list["_epsnet.Layer"]:
        return [layer for shown in show for layer in shown._layers_on(self._core)]

    def _repr_svg_(self) -> str:
        return self.svg()

    def view(self, title: str = "", *, show: Iterable[Any] = (), height: int = 640) -> "Page":
        """A page to travel in the surface, with the verdict of the net: in a notebook, or ``.save("view.html")``."""
        return Page(self._core.page(title or repr(self), self.certificate._core, self._layers(show)), height)

    def export(self, format: str, path: Optional[Path] = None) -> Optional[bytes]:
        """The net in another format, for programs that compute with meshes (docs/exchange-formats.md); written to the path, or returned.

        "gmsh" and "vtu": finite elements, the glued surface; "off": one lift of each triangle; "edges": a table; "json": all of it; rounded.
        "triangulation": CGAL's, exactly.
        """
        text = self._core.exported(format)
        if path is None:
            return text
        _epsnet.write_text(text, os.fspath(path))
        return None

    def __len__(self) -> int:
        """The number of vertices."""
        return len(self._core.vertices)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Net) and self._core == other._core

    def __hash__(self) -> int:
        return hash((len(self), self.epsilon))

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled, (self._core.text(),)

    def __repr__(self) -> str:
        verdict = self.certificate.verdict if self._proof._certificate is not None else "not checked"
        kind = "Net" if self._core.collars is None else "Pseudo net"
        return f"<{kind}: {len(self)} vertices, epsilon {self.epsilon}, genus {self.surface.genus}, {verdict}>"


def _unpickled(text: bytes) -> Net:
    return Net(_epsnet.Net.parse(text, "pickle"), None, None, None)


class Page:
    """A self-contained HTML page; a notebook shows it in a frame."""

    def __init__(self, text: str, height: int) -> None:
        #: The page.
        self.html = text
        self._height = height

    def save(self, path: Path) -> None:
        """Writes the page to a file, completely or not at all."""
        _epsnet.write_text(self.html.encode(), os.fspath(path))

    def _repr_html_(self) -> str:
        return f'<iframe srcdoc="{html.escape(self.html)}" width="100%" height="{self._height}" style="border:0"></iframe>'

    def __repr__(self) -> str:
        return f"<Page of {len(self.html)} characters>"
