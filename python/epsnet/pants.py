"""Pants decompositions and Dehn twists."""
from __future__ import annotations

from fractions import Fraction
from typing import Any, Optional, Sequence

from . import _epsnet
from ._annotations import Surface
from ._arguments import as_flag, as_fraction, as_index, as_indices, as_items, as_threads
from ._progress import Progress, Shower
from .intervals import Interval

__all__ = ["Cuff", "PantsDecomposition"]


class Cuff:
    """A cuff of a pants decomposition: a simple closed geodesic between two pairs of pants, an edge of the graph."""

    def __init__(self, row: tuple[list[int], tuple[float, float], tuple[float, float], Optional[Fraction], list[int]]) -> None:
        word, length, twist, exp_half_length, across = row
        #: The sides that a loop crosses that is freely homotopic to it, with the pants of the edge's first end on the left.
        self.word = tuple(word)
        #: Its length, proved.
        self.length = Interval(*length, proved=True)
        #: The twist modulo the length, proved: the number nearest to 0. Positive to the left (docs/fenchel-nielsen.md).
        self.twist = Interval(*twist, proved=True)
        #: e^(length/2), exactly, where it is rational; else None.
        self.exp_half_length = exp_half_length
        #: The sides that a path across it crosses, from the words of the first pants to those of the second.
        self.across = tuple(across)

    def __repr__(self) -> str:
        return f"<Cuff of length {self.length}, twist {self.twist}>"


class PantsDecomposition:
    """Pairs of pants of which a surface is glued, with its Fenchel–Nielsen coordinates. Proved."""

    def __init__(self, surface: "Surface", core: tuple[Any, ...]) -> None:
        edges, cuffs, pants, own = core
        #: The surface.
        self.surface = surface
        #: The edges of the graph, of which the nodes are the pairs of pants, as ``Surface.fenchel_nielsen`` takes them.
        self.edges: list[tuple[int, int]] = list(edges)
        #: By edge.
        self.cuffs: list[Cuff] = [Cuff(row) for row in cuffs]
        #: By pair of pants the words of its three cuffs, from one tile, with the pants on their left. Their product is 1.
        self.pants: list[tuple[tuple[int, ...], ...]] = [tuple(tuple(word) for word in words) for words in pants]
        #: Whether they are the pants of which ``Surface.fenchel_nielsen`` made the surface.
        self.own: bool = own

    @property
    def lengths(self) -> list[Interval]:
        """The lengths of the cuffs."""
        return [cuff.length for cuff in self.cuffs]

    @property
    def twists(self) -> list[Interval]:
        """The twists, modulo the lengths."""
        return [cuff.twist for cuff in self.cuffs]

    def fenchel_nielsen(self, twists: Optional[Sequence[Any]] = None) -> "Surface":
        """The surface of these coordinates, with the middles of the intervals: isometric to the given one up to rounding. ``twists``: others.

        >>> import epsnet
        >>> pants = epsnet.Surface.octagon(5).pants()
        >>> again = pants.fenchel_nielsen()
        >>> abs(again.systole().mid - pants.surface.systole().mid) < 1e-12
        True
        """
        return type(self.surface).fenchel_nielsen(
            [length.mid for length in self.lengths], [twist.mid for twist in self.twists] if twists is None else twists, self.edges
        )

    def __repr__(self) -> str:
        return f"<PantsDecomposition: {len(self.pants)} pairs of pants, {len(self.cuffs)} cuffs>"


def as_word(curve: Any, name: str = "curve") -> list[int]:
    """The word of a curve: of side numbers, or of what has one, as a closed geodesic or a cuff."""
    return as_indices(getattr(curve, "word", curve), name)


def pants(surface: "Surface", curves: Optional[Sequence[Any]], find: bool, threads: int, progress: Progress) -> PantsDecomposition:
    words = [] if curves is None else [as_word(curve, "curves") for curve in as_items(curves, "curves", "words")]
    find, threads = as_flag(find, "find"), as_threads(threads)
    with Shower(progress) as callback:
        return PantsDecomposition(surface, _epsnet.pants(surface._core, words, find, threads, callback))


def as_power(power: Any) -> int:
    return as_index(power, "power", -1000, 1000)


def dehn_twist(surface: "Surface", curve: Any, power: int) -> "_epsnet.Surface":
    return _epsnet.dehn_twist(surface._core, as_word(curve), as_power(power))


def dehn_twist_words(surface: "Surface", curve: Any, power: int) -> list[tuple[int, ...]]:
    return [tuple(word) for word in _epsnet.dehn_twist_words(surface._core, as_word(curve), as_power(power))]


def twist(surface: "Surface", curve: Any, by: Any) -> "_epsnet.Surface":
    return _epsnet.twist(surface._core, as_word(curve), as_fraction(by, "by"))
