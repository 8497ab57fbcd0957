"""Fundamental polygons and Dirichlet domains."""
from __future__ import annotations

import json
from typing import Any, NamedTuple, Optional

from . import _epsnet
from ._annotations import Surface
from ._arguments import Path, as_index, as_path
from ._pictures import Drawn
from .isometries import Gaussian, Isometry
from .points import BasePoint

__all__ = ["DirichletDomain", "DirichletSide", "FundamentalPolygon", "PolygonSide"]


class PolygonSide(NamedTuple):
    """A side of a fundamental polygon P. Beyond it lies γP."""

    #: γ.
    isometry: Isometry
    #: The number of the side to which γ⁻¹ takes this one.
    partner: int
    #: The side of the surface that it is.
    side: int


class FundamentalPolygon(Drawn):
    """The tiles of a surface as one polygon in the disk of tile 0. Its images under the group tile the plane (Poincaré's theorem).

    >>> import epsnet
    >>> polygon = epsnet.Surface.fenchel_nielsen(2, 0, "chain", genus=3).fundamental_polygon()
    >>> len(polygon.sides), len(polygon.generators()), len(polygon.relations())
    (22, 11, 6)
    """

    def __init__(self, surface: "Surface") -> None:
        self.surface = surface
        self._core = _epsnet.FundamentalPolygon(surface._core)
        #: The sides, counterclockwise: side k leads from vertex k to vertex k + 1.
        self.sides = [PolygonSide(Isometry(surface, word), partner, side) for word, partner, side in self._core.sides]

    @property
    def vertices(self) -> list[Gaussian]:
        """The corners, counterclockwise. Exact if the surface ``is_rational``, else rounded to 256 bits."""
        return [Gaussian(x, y) for x, y in self._core.vertices]

    def generators(self) -> list[Isometry]:
        """γ for one side of each pair: they generate the group."""
        return [side.isometry for k, side in enumerate(self.sides) if k < side.partner]

    def relations(self) -> list[list[int]]:
        """For each vertex of the surface that is a corner, the sides k₁, k₂, … around it: the product γ₁γ₂… of their isometries is 1."""
        return self._core.relations

    def __eq__(self, other: object) -> bool:
        return isinstance(other, FundamentalPolygon) and self.surface == other.surface

    def __hash__(self) -> int:
        return hash(self.surface)

    def __reduce__(self) -> tuple[Any, ...]:
        return FundamentalPolygon, (self.surface,)

    def __repr__(self) -> str:
        return f"<FundamentalPolygon with {len(self.sides)} sides>"

    def svg(self, size: int = 600) -> str:
        """The tiles, as the surface shows them."""
        return self.surface.svg(size)


class DirichletSide(NamedTuple):
    """A side of a Dirichlet domain: it consists of points as near to the base point as to its image under γ."""

    #: γ.
    isometry: Isometry
    #: The number of the side to which γ⁻¹ takes this one.
    partner: int
    #: Of the base point from the line of the side; rounded, not proved.
    distance: float


class DirichletDomain(Drawn):
    """The points that are nearer to one lift of a point than to its other lifts. Sides and pairings are read off a verified
    triangulation; vertices are rounded."""

    def __init__(self, surface: "Surface", base: Optional[BasePoint]) -> None:
        self.surface = surface
        self._base = base
        self._core = _epsnet.DirichletPolygon(surface._core, base)
        #: The sides, counterclockwise: side k leads from vertex k to vertex k + 1. Exact: the isometries, the partners, and which there are.
        self.sides = [DirichletSide(Isometry(surface, word), partner, distance) for word, partner, distance in self._core.sides]

    @property
    def vertices(self) -> list[complex]:
        """The corners, counterclockwise, in the disk with the base point at 0; rounded, not proved."""
        return self._core.vertices

    @property
    def ties(self) -> int:
        """The number of sides of length 0, which ``sides`` leaves out."""
        return self._core.ties

    def svg(self, size: int = 600) -> str:
        """The domain, with the Delaunay triangulation of its point."""
        return self._core.svg(as_index(size, "size", 50, 20000))

    def save(self, path: Path) -> None:
        """Writes the domain as JSON (docs/format.md), completely or not at all. The program ``epsnet info`` describes the file."""
        _epsnet.write_text(self._core.text(), as_path(path))

    def info(self) -> dict[str, Any]:
        """A summary: how far the sides and the vertices are from the base point. Rounded, not proved."""
        facts: dict[str, Any] = json.loads(self._core.info())
        return facts

    def __eq__(self, other: object) -> bool:
        """Whether the surfaces and the base points are equal."""
        return isinstance(other, DirichletDomain) and (self.surface, self._base) == (other.surface, other._base)

    def __hash__(self) -> int:
        return hash((self.surface, self._base))

    def __reduce__(self) -> tuple[Any, ...]:
        return DirichletDomain, (self.surface, self._base)

    def __repr__(self) -> str:
        return f"<DirichletDomain with {len(self.sides)} sides>"
