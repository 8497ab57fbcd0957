"""The graph of the tiles of a surface."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from . import _epsnet

__all__ = ["SurfaceGraph"]


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
