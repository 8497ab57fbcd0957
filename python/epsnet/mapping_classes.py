"""Mapping classes: products of Dehn twists, and what they do to curves and to homology."""
from __future__ import annotations

import re
from functools import cached_property
from typing import Any, Iterable, Optional

from . import _epsnet
from ._annotations import Surface
from ._arguments import argument, as_index, as_items, refuse
from ._immutable import Immutable
from ._names import shown
from .curves import Curve, curve
from .groups import as_word
from .pants import as_power
from .symmetries import SurfaceIsometry

__all__ = ["MappingClass"]

#: A curve in letters of the group: the library reads sides.
_IN_LETTERS = re.compile(r"\(([^()]*[A-Za-z][^()]*)\)")


class MappingClass(Immutable):
    """An isotopy class of homeomorphisms of a surface to itself that preserve the orientation: a product of Dehn twists, of which the last one acts
    first. Immutable.

    ``f * g`` lets g act first, ``f ** n`` and ``f.inverse()`` are powers, ``f(curve)`` is the image of a curve, and ``f == g`` is decided by words
    alone, exactly. No checker looks at it.

    >>> import epsnet
    >>> surface = epsnet.Surface.octagon(123)
    >>> f = surface.mapping_class("a1 b1 c1 b2")
    >>> f.order, (f * f).order, surface.mapping_class("a1 B1").order
    (10, 5, None)
    >>> surface.mapping_class("a1 b1 a1") == surface.mapping_class("b1 a1 b1")
    True
    """

    def __init__(self, surface: "Surface", twists: Iterable[tuple[Any, int]]) -> None:
        #: The surface.
        self.surface = surface
        #: The factors: pairs of a word and a power.
        self.twists: tuple[tuple[tuple[int, ...], int], ...] = tuple((tuple(word), power) for word, power in twists)

    def __mul__(self, other: "MappingClass") -> "MappingClass":
        """What the other one does, and then this one."""
        if not isinstance(other, MappingClass):
            return NotImplemented
        if other.surface != self.surface:
            refuse("a mapping class of the same surface", other, "other")
        return MappingClass(self.surface, self.twists + other.twists)

    def inverse(self) -> "MappingClass":
        """What undoes it."""
        return MappingClass(self.surface, [(word, -power) for word, power in reversed(self.twists)])

    def __pow__(self, exponent: int) -> "MappingClass":
        count = as_index(exponent, "exponent", -1000, 1000)
        base = self if count >= 0 else self.inverse()
        return MappingClass(self.surface, base.twists * abs(count))

    def __call__(self, closed_curve: Any) -> Curve:
        """The image of a closed curve, up to free homotopy. ArgumentError for a twist along a curve that is not simple; LimitError if words become too
        long, as they may grow exponentially with the number of twists.

        >>> import epsnet
        >>> surface = epsnet.Surface.octagon(123)
        >>> involution = surface.mapping_class("a1 b1 c1 b2 a2 a2 b2 c1 b1 a1")
        >>> curve = surface.curve([0])
        >>> involution(curve) == curve, involution(curve) == surface.curve([4])     # Side 4 is the other side of 0.
        (False, True)
        """
        given = closed_curve if isinstance(closed_curve, Curve) else curve(self.surface, closed_curve, "closed_curve")
        return curve(self.surface, self._group.image(self.twists, given._core))

    @cached_property
    def homology(self) -> tuple[tuple[int, ...], ...]:
        """What it does to the first homology group, as the rows of a symplectic matrix: column k has the coefficients of the image of curve k of
        ``surface.homology_basis()``."""
        return tuple(tuple(row) for row in self._group.homology(self.twists))

    @property
    def is_identity(self) -> bool:
        """Whether it is isotopic to the identity."""
        return self._group.is_identity(self.twists)

    @cached_property
    def order(self) -> Optional[int]:
        """The least n > 0 for which its n-th power is the identity; None if there is none."""
        return self._group.order(self.twists)

    @cached_property
    def isometry(self) -> Optional[SurfaceIsometry]:
        """The isometry of the surface in this class, of ``surface.isometries()``, if there is one.

        >>> import epsnet
        >>> surface = epsnet.Surface.octagon(123)
        >>> surface.mapping_class("a1 b1 c1 b2 a2 a2 b2 c1 b1 a1").isometry
        <SurfaceIsometry that preserves orientation>
        """
        if self.order is None:
            return None
        for isometry in self.surface.isometries():
            if self._group.is_isometry(self.twists, isometry.preserves_orientation, [list(element.word) for element in isometry.images]):
                return isometry
        return None

    def marking(self) -> "Surface":
        """The surface with another marking, as ``Surface.dehn_twist`` makes it: the isometry to this surface takes the path of a word to its image.
        SurfaceError for regular tiles."""
        return self.surface._derived(_epsnet.with_marking(self.surface._core, self.twists), "marking", shown(self.twists))

    @property
    def _group(self) -> "_epsnet.MappingClassGroup":
        return self.surface._mapping_class_group

    def __eq__(self, other: object) -> bool:
        """Whether both are isotopic, on one surface."""
        return isinstance(other, MappingClass) and self.surface == other.surface and (self * other.inverse()).is_identity

    def __hash__(self) -> int:
        return hash(self.homology)

    def __reduce__(self) -> tuple[Any, ...]:
        return MappingClass, (self.surface, self.twists)

    def __repr__(self) -> str:
        count = len(self.twists)
        return f"<MappingClass of {count} {'twist' if count == 1 else 'twists'}>"


def mapping_class(surface: "Surface", product: Any) -> MappingClass:
    if isinstance(product, str):
        text = _IN_LETTERS.sub(lambda found: f"({' '.join(map(str, as_word(surface, found[1], 'product')))})", product)
        with argument("product"):
            return MappingClass(surface, surface._mapping_class_group.parse(text))
    twists = []
    for factor in as_items(product, "product", "pairs (word, power)"):
        try:
            word, power = factor
        except (TypeError, ValueError):
            refuse("pairs (word, power)", factor, "product")
        twists.append((as_word(surface, word, "product"), as_power(power)))
    return MappingClass(surface, twists)
