"""Points of surfaces."""
from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, Sequence, Tuple, Union

import numpy as np

from ._arguments import argument, as_fraction, as_index, refuse
from .isometries import Gaussian

if TYPE_CHECKING:
    from . import _epsnet

__all__ = ["Point"]


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

#: The same for the library.
BasePoint = Tuple[int, Tuple[Fraction, Fraction]]


def point_of(base: BasePoint) -> Point:
    """The point that the library means."""
    tile, (x, y) = base
    return Point(tile, x, y)


def base_point(surface: "_epsnet.Surface", p: PointLike, name: str) -> BasePoint:
    """The point that the argument ``name`` means."""
    if isinstance(p, (int, np.integer)):
        with argument(name):
            return surface.centre_of_tile(as_index(p, name))
    try:
        tile, x, y = p
    except (TypeError, ValueError):
        refuse("a Point, (tile, x, y) or a tile", p, name)
    return as_index(tile, name), (as_fraction(x, name), as_fraction(y, name))
