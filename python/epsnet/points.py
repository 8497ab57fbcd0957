"""Points of surfaces."""
from __future__ import annotations

from fractions import Fraction
from numbers import Real
from typing import TYPE_CHECKING, Any, List, NamedTuple, Sequence, Tuple, Union

import numpy as np

from ._arguments import argument, as_fraction, as_index, refuse
from .isometries import Gaussian

if TYPE_CHECKING:
    from . import _epsnet

__all__ = ["Point"]


class Point(NamedTuple):
    """A point of a surface: a tile, and rational coordinates in the Poincaré disk of that tile.

    It is printed with 12 significant digits. ``x`` and ``y`` are exact fractions, and ``z`` is x + iy, exactly.

    >>> import epsnet
    >>> p = epsnet.Surface.octagon(1).point(0, "1/10", "-1/3")
    >>> p, p.y
    (Point(0, 0.1, -0.333333333333), Fraction(-1, 3))
    """

    tile: int
    x: Fraction
    y: Fraction

    @property
    def z(self) -> Gaussian:
        """x + iy, exactly."""
        return Gaussian(self.x, self.y)

    def __repr__(self) -> str:
        return f"Point({self.tile}, {_rounded(self.x)}, {_rounded(self.y)})"


def _rounded(x: Any) -> str:
    """A coordinate in decimals. (Whoever makes a Point without ``surface.point`` may put anything there that stands for a number.)"""
    return f"{float(x):.12g}" if isinstance(x, Real) else repr(x)


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


def random_points(surface: "_epsnet.Surface", count: int, seed: int) -> List[Point]:
    """Points that are uniformly distributed by area: in the triangles from corner 0 of each tile."""
    corners = [np.array([complex(x, y) for x, y in tile]) for tile in surface.tiles]
    tile = np.concatenate([np.full(len(tile) - 2, k) for k, tile in enumerate(corners)])
    a = np.concatenate([np.full(len(tile) - 2, tile[0]) for tile in corners])
    b, c = np.concatenate([tile[1:-1] for tile in corners]), np.concatenate([tile[2:] for tile in corners])
    # With a at 0: b and c in their directions, the angles, the length of ab.
    u, v = (b - a) / (1 - a.conj() * b), (c - a) / (1 - a.conj() * c)
    alpha, beta = np.angle(v / u), np.angle((v - u) / (1 - u.conj() * v) / -u)
    side = 2 * np.arctanh(abs(u))
    areas = np.maximum(_area(np.abs(alpha), np.abs(beta), side), 0)
    draw = np.random.default_rng(seed)
    chosen = draw.choice(len(areas), size=count, p=areas / areas.sum())
    tile, a, u, alpha, beta, side = (part[chosen] for part in (tile, a, u, np.abs(alpha), np.abs(beta), side))
    # The part of the triangle up to the angle t at a has the share of the area that is drawn.
    low: Any = np.zeros(count)
    high: Any = alpha
    wanted = draw.random(count) * areas[chosen]
    for _ in range(60):
        middle = (low + high) / 2
        is_less = _area(middle, beta, side) < wanted
        low, high = np.where(is_less, middle, low), np.where(is_less, high, middle)
    # On the way from a in this direction the area up to the distance r is proportional to cosh r − 1.
    opposite = _third_angle(low, beta, side)
    longest = np.sinh(side) * np.sin(beta) / np.where(np.sin(opposite) > 0, np.sin(opposite), 1)
    growth = draw.random(count) * (np.hypot(longest, 1) - 1)
    radius = np.sqrt(growth / (growth + 2))  # tanh(r/2), where cosh r = 1 + growth.
    w = radius * np.exp(1j * low) * u / abs(u)
    z = (w + a) / (1 + a.conj() * w)
    return [Point(int(k), Fraction(x), Fraction(y)) for k, x, y in zip(tile, z.real, z.imag)]


def _third_angle(alpha: Any, beta: Any, side: Any) -> Any:
    """The angle opposite to a side of a hyperbolic triangle, with the angles at its ends."""
    return np.arccos(np.clip(np.sin(alpha) * np.sin(beta) * np.cosh(side) - np.cos(alpha) * np.cos(beta), -1, 1))


def _area(alpha: Any, beta: Any, side: Any) -> Any:
    return np.pi - alpha - beta - _third_angle(alpha, beta, side)
