"""Eigenvalues of the Laplacian."""
from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import List, Optional, Sequence, Union, overload

from . import _epsnet
from ._annotations import Surface
from ._arguments import Number, as_flag, as_fraction, as_index, as_threads, length_text, refuse
from ._documents import Document
from ._progress import Progress, Shower
from .certificates import Certificate, checked
from .intervals import Interval
from .nets import Net

__all__ = ["EigenvalueWindow", "Eigenvalues"]


@dataclass(frozen=True)
class EigenvalueWindow:
    """Eigenvalues that lie in one interval, and no other does. They are counted with multiplicity."""

    #: Contains them; for a single one as narrow as it was proved.
    interval: Interval
    #: There are at least so many.
    least: int
    #: There are at most so many.
    most: int
    #: Contains the smallest one; the whole interval where least and most differ.
    smallest: Interval
    #: Contains the greatest one; the whole interval where least and most differ.
    greatest: Interval


class Eigenvalues(Document, Sequence[EigenvalueWindow]):
    """Windows with all eigenvalues of the Laplacian up to a bound, in increasing order. 0, of the constant functions, is left out."""

    _core: "_epsnet.Eigenvalues"

    def __init__(self, core: "_epsnet.Eigenvalues", surface: Optional["Surface"], certificate: Optional[Certificate]) -> None:
        self._hold(core, surface, certificate)

    @cached_property
    def _windows(self) -> List[EigenvalueWindow]:
        proved = self.proved

        def interval(ends: tuple[float, float]) -> Interval:
            return Interval(*ends, proved=proved)

        return [
            EigenvalueWindow(interval((greatest[0], smallest[1]) if least == most == 1 else ends), least, most, interval(smallest), interval(greatest))
            for ends, least, most, smallest, greatest in self._core.windows
        ]

    @property
    def up_to(self) -> str:
        """The length up to which closed geodesics prove it, as it was given."""
        return self._core.up_to

    @property
    def bound(self) -> float:
        """All eigenvalues up to this number, which is included, lie in the windows."""
        return self._core.eigenvalues_up_to

    @cached_property
    def net(self) -> Net:
        """The net on which the list of closed geodesics is proved."""
        return Net(self._core.net, self._surface, None)

    def svg(self, size: int = 600) -> str:
        """A bound for the number of eigenvalues at each place of the axis, and the windows, as SVG of this width."""
        return self._core.svg(as_index(size, "size", 50, 20000))

    def _repr_svg_(self) -> str:
        return self.svg()

    def __len__(self) -> int:
        return len(self._windows)

    @overload
    def __getitem__(self, place: int) -> EigenvalueWindow: ...
    @overload
    def __getitem__(self, place: slice) -> List[EigenvalueWindow]: ...
    def __getitem__(self, place: Union[int, slice]) -> Union[EigenvalueWindow, List[EigenvalueWindow]]:
        return self._windows[place]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Eigenvalues) and bool(self._core == other._core)

    def __hash__(self) -> int:
        return hash((self.up_to, self.bound, len(self)))

    def __repr__(self) -> str:
        counts = ", ".join(str(w.least) if w.least == w.most else f"{w.least} to {w.most}" for w in self)
        return f"<Eigenvalues up to {self.bound}: windows of {counts or 'none'}{'' if self.proved else ' (not proved)'}>"


def _positive(x: Optional[Number], name: str, expected: str) -> Optional[float]:
    if x is None:
        return None
    value = float(min(as_fraction(x, name), Fraction(10**9)))  # More makes no difference.
    if value <= 0:
        refuse(expected, x, name)
    return value


def eigenvalues(
    surface: "Surface", up_to: Optional[Number], count: Optional[int], width: Optional[Number], time: Optional[Number], fast: bool, threads: int, progress: Progress
) -> Eigenvalues:
    text = None if up_to is None else length_text(up_to, "up_to")
    most = 0 if count is None else as_index(count, "count", 1, 10**6)
    size = _positive(width, "width", "a positive number")
    seconds = _positive(time, "time", "a positive number of seconds")
    threads = as_threads(threads)
    if up_to is not None and as_fraction(up_to, "up_to") > 30:
        refuse("a length of at most 30", up_to, "up_to")
    with Shower(progress) as callback:
        core = _epsnet.Eigenvalues.find(surface._core, text, most, size, seconds, as_flag(fast, "fast"), threads, callback)
    return Eigenvalues(core, surface, checked(core, progress, threads, subject="eigenvalues"))
