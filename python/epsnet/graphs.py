"""The graph of the tiles of a surface, and its matrices with phases: hyperbolic lattices."""
from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, Optional

import numpy as np

from . import _epsnet
from ._arguments import Path, as_path
from ._immutable import Immutable
from .intervals import Interval

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Lattice", "SurfaceGraph"]


class SurfaceGraph(NamedTuple):
    """A graph on a surface, with its faces. Loops, and several edges between two nodes, are included.

    For NetworkX: ``networkx.MultiGraph(graph.edges.tolist())``, and ``graph.face_edges`` for the graph of the faces, the dual one.
    """

    #: How many vertices there are.
    vertices: int
    #: The two vertices of each edge: from the first to the second, the first face of ``face_edges`` is on the left.
    edges: "NDArray[np.uint32]"
    #: The vertices around each face, counterclockwise.
    faces: tuple[tuple[int, ...], ...]
    #: The two faces on both sides of each edge.
    face_edges: "NDArray[np.uint32]"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, SurfaceGraph) and self.faces == other.faces and np.array_equal(self.edges, other.edges)

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __hash__(self) -> int:
        return hash(self.faces)

    def __repr__(self) -> str:
        return f"<SurfaceGraph: {self.vertices} vertices, {len(self.edges)} edges, {len(self.faces)} faces>"


def graph_of(core: "_epsnet.Surface") -> SurfaceGraph:
    """The graph of the sides of the tiles."""
    vertex = core.vertex_classes
    faces: list[tuple[int, ...]] = []
    ends: list[tuple[int, int, int]] = []  # By side: its two vertices and its tile.
    for tile, corners in enumerate(core.tiles):
        around = tuple(vertex[len(ends) : len(ends) + len(corners)])
        ends += [(around[k], around[(k + 1) % len(around)], tile) for k in range(len(around))]
        faces.append(around)
    first = [side for side in range(len(ends)) if side < core.partner(side)]
    edges: Any = np.array([ends[side][:2] for side in first], dtype=np.uint32)
    face_edges: Any = np.array([(ends[side][2], ends[core.partner(side)][2]) for side in first], dtype=np.uint32)
    return SurfaceGraph(core.vertex_count, edges, tuple(faces), face_edges)


class Lattice(Immutable):
    """The Hermitian matrix that takes a function at the nodes of a graph, with phases, to the sum of its values at the neighbours of each node."""

    def __init__(self, core: "_epsnet.Surface", faces: bool, turns: list[Fraction]) -> None:
        self._core = _epsnet.lattice_matrix(core, faces, turns)

    @property
    def size(self) -> int:
        """The number of nodes."""
        return self._core.size

    def matrix(self) -> "NDArray[np.complex128]":
        """The matrix, dense and read-only; ``scipy.sparse.csr_array(lattice.matrix())`` or ``save`` for sparse ones."""
        result = np.zeros((self.size, self.size), dtype=np.complex128)
        for row, column, value in self._core.entries:
            result[column, row] = value.conjugate()
            result[row, column] = value
        result.flags.writeable = False
        return result

    def eigenvalues(self) -> list[Interval]:
        """An interval for each eigenvalue, in increasing order, with multiplicity. The module alone proves them (docs/eigenvalues.md). LimitError for
        more than 1500 nodes."""
        return [Interval(*ends, proved=True) for ends in self._core.eigenvalues()]

    def save(self, path: Path) -> None:
        """Writes the matrix as a MatrixMarket file, which ``scipy.io.mmread`` reads."""
        _epsnet.write_text(self._core.text.encode(), as_path(path))

    def __repr__(self) -> str:
        return f"<Lattice of {self.size} nodes>"


def lattice(core: "_epsnet.Surface", nodes: str, turns: Optional[list[Fraction]]) -> Lattice:
    return Lattice(core, nodes == "faces", turns or [])
