"""Pants decompositions and Dehn twists."""
from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from typing import Any, Optional, Sequence

from . import _epsnet
from ._annotations import Surface
from ._arguments import argument, as_flag, as_fraction, as_index, as_items, as_threads, refuse
from ._documents import Document
from ._pictures import Drawn
from ._progress import Progress, Shower
from .certificates import Certificate
from .errors import ArgumentError
from .groups import as_word
from .intervals import Interval
from .nets import Net

__all__ = ["Cuff", "PantsDecomposition"]

_Ends = tuple[tuple[int, int], tuple[int, int]]


class Cuff:
    """A cuff of a pants decomposition: a simple closed geodesic between two pairs of pants, an edge of the graph."""

    def __init__(
        self, decomposition: "PantsDecomposition", number: int, ends: Sequence[Sequence[int]], length: tuple[float, float], twist: tuple[float, float],
        exp_half_length: Optional[Fraction], across: Sequence[int]
    ) -> None:
        self._decomposition = decomposition
        self._length, self._twist = length, twist
        #: Its number in the decomposition.
        self.number = number
        (p, k), (q, l) = ends
        #: What is on its two sides: (p, k), cuff k of pair of pants p, on its left, and (q, l) on its right.
        self.ends: _Ends = ((p, k), (q, l))
        #: e^(length/2), exactly, where it is rational; else None.
        self.exp_half_length = exp_half_length
        #: The sides that a path across it crosses, from the words of the first pants to those of the second.
        self.across = tuple(across)

    @property
    def length(self) -> Interval:
        """Its length."""
        return Interval(*self._length, proved=self._decomposition.proved)

    @property
    def twist(self) -> Interval:
        """The twist modulo the length: the number nearest to 0. Positive to the left (docs/fenchel-nielsen.md)."""
        return Interval(*self._twist, proved=self._decomposition.proved)

    @property
    def word(self) -> tuple[int, ...]:
        """The sides that a loop crosses that is freely homotopic to it, with the pants of the edge's first end on the left."""
        p, k = self.ends[0]
        return self._decomposition.pants[p][k]

    def __eq__(self, other: object) -> bool:
        """Whether both are the same cuff of equal decompositions."""
        return isinstance(other, Cuff) and self.number == other.number and self._decomposition == other._decomposition

    def __hash__(self) -> int:
        return hash((self.number, self.across, self._length))

    def __reduce__(self) -> tuple[Any, ...]:
        return _cuff, (self._decomposition, self.number)

    def __repr__(self) -> str:
        return f"<Cuff of length {self.length}, twist {self.twist}>"


def _cuff(decomposition: "PantsDecomposition", number: int) -> Cuff:
    """A cuff again, from its pickle."""
    return decomposition.cuffs[number]


class PantsDecomposition(Drawn, Document):
    """Pairs of pants of which a surface is glued, with its Fenchel–Nielsen coordinates, and what proves it: the contents of a pants file."""

    _core: "_epsnet.PantsDecomposition"

    def __init__(self, core: "_epsnet.PantsDecomposition", surface: Optional["Surface"], certificate: Optional[Certificate], own: Optional[bool] = None) -> None:
        self._hold(core, surface, certificate)
        #: By edge of the graph.
        self.cuffs: list[Cuff] = [Cuff(self, number, *row) for number, row in enumerate(core.cuffs)]
        #: Whether they are the pants of which ``Surface.fenchel_nielsen`` made the surface; None for what comes from a file, which does not say.
        self.own: Optional[bool] = own

    @property
    def edges(self) -> list[tuple[int, int]]:
        """The edges of the graph, of which the nodes are the pairs of pants, as ``Surface.fenchel_nielsen`` takes them."""
        return [(cuff.ends[0][0], cuff.ends[1][0]) for cuff in self.cuffs]

    @cached_property
    def pants(self) -> list[tuple[tuple[int, ...], ...]]:
        """By pair of pants the words of its three cuffs, from one tile, with the pants on their left. Their product is 1."""
        surface = self.surface._core
        return [
            (tuple(first), tuple(second), tuple(_epsnet.reversed_word(surface, _epsnet.concatenated_words(surface, first, second))))
            for first, second in self._core.pants
        ]

    @property
    def lengths(self) -> list[Interval]:
        """The lengths of the cuffs."""
        return [cuff.length for cuff in self.cuffs]

    @property
    def twists(self) -> list[Interval]:
        """The twists, modulo the lengths."""
        return [cuff.twist for cuff in self.cuffs]

    @cached_property
    def net(self) -> Net:
        """The net of the surface in the file."""
        return Net(self._core.net, self._surface, None)

    def svg(self, size: int = 600) -> str:
        """The cuffs, 200 at most, in a Dirichlet domain of the surface."""
        return self._core.svg(as_index(size, "size", 50, 20000))

    def fenchel_nielsen(self, twists: Optional[Sequence[Any]] = None) -> "Surface":
        """The surface of these coordinates, with the middles of the intervals: isometric to the given one up to rounding. ``twists``: others.

        ArgumentError for a file that does not number the cuffs of each pair of pants in the order of the edges.

        >>> import epsnet
        >>> pants = epsnet.Surface.octagon(5).pants()
        >>> again = pants.fenchel_nielsen()
        >>> abs(again.systole().mid - pants.surface.systole().mid) < 1e-12
        True
        """
        self._require_order()
        return self._surface_class.fenchel_nielsen(
            [length.mid for length in self.lengths], [twist.mid for twist in self.twists] if twists is None else twists, self.edges
        )

    def _require_order(self) -> None:
        """Marks, from which twists are measured, depend on the numbers of the cuffs; a graph has those that its edges give."""
        count: dict[int, int] = {}
        for cuff in self.cuffs:
            for p, k in cuff.ends:
                if k != count.get(p, 0):
                    raise ArgumentError("cuffs of a pair of pants are not in the order 0, 1, 2", place=f"cuffs[{cuff.number}]")
                count[p] = k + 1

    def _more(self) -> tuple[Any, ...]:
        return (self.own,)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, PantsDecomposition) and bool(self._core == other._core)

    def __hash__(self) -> int:
        return hash(tuple(cuff._length for cuff in self.cuffs))

    def __repr__(self) -> str:
        return f"<PantsDecomposition: {2 * len(self.cuffs) // 3} pairs of pants, {len(self.cuffs)} cuffs{'' if self.proved else ' (not proved)'}>"


def pants(
    surface: "Surface", curves: Optional[Sequence[Any]], find: bool, marking: Optional[PantsDecomposition], threads: int, progress: Progress
) -> PantsDecomposition:
    if marking is not None:
        if not isinstance(marking, PantsDecomposition):
            refuse("a PantsDecomposition", marking, "marking")
        if curves is not None or find:
            raise ArgumentError("the curves are those of the marking", place="marking")
        with Shower(progress) as callback, argument("marking"):
            core, found = _epsnet.PantsDecomposition.marked(surface._core, marking._core, as_threads(threads), callback)
        return PantsDecomposition(core, surface, Certificate(found), False)
    words = [] if curves is None else [as_word(surface, curve, "curves") for curve in as_items(curves, "curves", "words")]
    find, threads = as_flag(find, "find"), as_threads(threads)
    with Shower(progress) as callback:
        core, found, own = _epsnet.PantsDecomposition.find(surface._core, words, find, threads, callback)
    return PantsDecomposition(core, surface, Certificate(found), own)


def as_power(power: Any) -> int:
    return as_index(power, "power", -1000, 1000)


def dehn_twist(surface: "Surface", curve: Any, power: int) -> "_epsnet.Surface":
    return _epsnet.dehn_twist(surface._core, as_word(surface, curve, "curve"), as_power(power))


def dehn_twist_words(surface: "Surface", curve: Any, power: int) -> list[tuple[int, ...]]:
    return [tuple(word) for word in _epsnet.dehn_twist_words(surface._core, as_word(surface, curve, "curve"), as_power(power))]


def twist(surface: "Surface", curve: Any, by: Any) -> "_epsnet.Surface":
    return _epsnet.twist(surface._core, as_word(surface, curve, "curve"), as_fraction(by, "by"))
