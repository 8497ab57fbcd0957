"""Lengths of closed geodesics as functions of Fenchel–Nielsen coordinates: derivatives, and surfaces with the greatest systoles."""
from __future__ import annotations

from typing import Any, Optional, Sequence

from . import _epsnet
from ._annotations import Surface
from ._arguments import as_flag, as_index, as_threads
from ._immutable import Immutable
from ._progress import Progress, Shower
from .groups import as_word
from .intervals import Interval

__all__ = ["LengthDerivatives", "SystoleMaximum"]


class LengthDerivatives(Immutable):
    """The length of a closed geodesic, and its derivatives with respect to the lengths and twists of the cuffs, in intervals that contain them:
    enclosed in ball arithmetic by the module alone, so ``proved`` is False."""

    def __init__(self, length: Any, gradient: Sequence[Any], second: Sequence[Sequence[Any]]) -> None:
        cuffs = len(gradient) // 2
        #: The length.
        self.length = Interval(*length)
        #: The derivatives with respect to the lengths of the cuffs, ``surface.pants().cuffs``.
        self.by_lengths = [Interval(*x) for x in gradient[:cuffs]]
        #: The derivatives with respect to the twists there.
        self.by_twists = [Interval(*x) for x in gradient[cuffs:]]
        #: The second derivatives, by two coordinates, first all lengths, then all twists; empty unless asked for.
        self.second = [[Interval(*x) for x in row] for row in second]

    def __repr__(self) -> str:
        return f"<LengthDerivatives with respect to {len(self.by_lengths)} lengths and twists>"


class SystoleMaximum(Immutable):
    """A surface at which the systole seems to be greatest among those near it."""

    def __init__(self, surface: "Surface", systole: Any, systoles: Sequence[Sequence[int]], proof: Optional[tuple[float, float]]) -> None:
        #: The surface, one of ``Surface.fenchel_nielsen``.
        self.surface = surface
        #: Its systole, proved.
        self.systole = Interval(*systole, proved=True)
        #: The words of all closed geodesics that are longer by at most 10⁻⁹.
        self.systoles: list[tuple[int, ...]] = [tuple(word) for word in systoles]
        #: A local maximum of the systole is nearer than this, in every coordinate: the module alone proves it, in interval arithmetic. None if it
        #: does not.
        self.maximum_within: Optional[float] = None if proof is None else proof[0]
        #: Near the surface the systole is less by at least so much for each unit of distance, but for terms of second order; None as before.
        self.slope: Optional[float] = None if proof is None else proof[1]

    def __repr__(self) -> str:
        known = "not proved" if self.maximum_within is None else f"a maximum within {self.maximum_within:.2g}"
        return f"<SystoleMaximum {self.systole.mid:.12g}, {len(self.systoles)} systoles, {known}>"


def gradient(surface: "Surface", word: Any, second: bool, threads: int) -> LengthDerivatives:
    sides = as_word(surface, word, "word")
    return LengthDerivatives(*_epsnet.length_derivatives(surface._core, sides, as_flag(second, "second"), as_threads(threads)))


def maximize_systole(surface: "Surface", steps: int, threads: int, progress: Progress) -> SystoleMaximum:
    most, threads = as_index(steps, "steps", 1, 100000), as_threads(threads)
    with Shower(progress) as callback:
        core, systole, systoles, proof = _epsnet.maximize_systole(surface._core, most, threads, callback)
    return SystoleMaximum(surface._derived(core, "maximize_systole"), systole, systoles, proof)
