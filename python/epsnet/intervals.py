"""Intervals that contain real numbers."""
from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, Optional, Union

__all__ = ["Interval"]

Rational = Union[int, float, Fraction]


def _rounded(x: Fraction, towards: float) -> float:
    """The nearest binary64 number that is not on the wrong side of x."""
    try:
        result = float(x)
    except OverflowError:
        result = math.inf if x > 0 else -math.inf
    if towards < 0:
        if result == math.inf or (math.isfinite(result) and Fraction(result) > x):
            result = math.nextafter(result, -math.inf)
    elif result == -math.inf or (math.isfinite(result) and Fraction(result) < x):
        result = math.nextafter(result, math.inf)
    return result


class Interval:
    """A closed interval that contains a real number. Immutable.

    ``proved`` says whether the checker has proved that it does. What epsnet computes is always proved; only what was loaded with
    ``check=False`` is not.

    >>> from epsnet import Interval
    >>> x = Interval(1, "1.5")
    >>> x.lower, x.upper, x.width
    (1.0, 1.5, 0.5)
    >>> 1.25 in x, 2 in x
    (True, False)

    An interval is no number: there is no ``float(x)``, and no ``<`` that could be meant in two ways.
    Say which number you want: ``x.lower``, ``x.upper``, or ``x.mid``, which is a guess.
    """

    __slots__ = ("_lower", "_upper", "_proved")

    def __init__(self, lower: Union[Rational, str], upper: Union[Rational, str], *, proved: bool = False) -> None:
        self._lower = Fraction(lower)
        self._upper = Fraction(upper)
        self._proved = proved
        if self._lower > self._upper:
            raise ValueError(f"an interval has its lower end first, not [{lower}, {upper}]")

    @property
    def lower(self) -> float:
        """The lower end, rounded down."""
        return _rounded(self._lower, -math.inf)

    @property
    def upper(self) -> float:
        """The upper end, rounded up."""
        return _rounded(self._upper, math.inf)

    @property
    def ends(self) -> tuple[Fraction, Fraction]:
        """Both ends, exactly."""
        return self._lower, self._upper

    @property
    def proved(self) -> bool:
        """Whether it is proved that the number lies in the interval."""
        return self._proved

    @property
    def mid(self) -> float:
        """The number in the middle, rounded: near the true one, and nothing more. ``error`` bounds how far it is off."""
        return float((self._lower + self._upper) / 2)

    @property
    def error(self) -> float:
        """The distance of the true number from ``mid`` is at most this."""
        mid = Fraction(self.mid)
        return _rounded(max(self._upper - mid, mid - self._lower), math.inf)

    @property
    def width(self) -> float:
        """The length of the interval, rounded up."""
        return _rounded(self._upper - self._lower, math.inf)

    def __contains__(self, x: Union[Rational, "Interval"]) -> bool:
        if isinstance(x, Interval):
            return self._lower <= x._lower and x._upper <= self._upper
        if isinstance(x, float) and not math.isfinite(x):
            return False
        return self._lower <= Fraction(x) <= self._upper

    def overlaps(self, other: "Interval") -> bool:
        """Whether the two have a point in common: if not, the numbers differ."""
        return self._lower <= other._upper and other._lower <= self._upper

    def __eq__(self, other: object) -> bool:
        """Whether the ends are the same: that says nothing of the numbers in between."""
        return isinstance(other, Interval) and self.ends == other.ends

    def __hash__(self) -> int:
        return hash(self.ends)

    def __bool__(self) -> bool:
        raise TypeError("an interval is neither true nor false")

    def __float__(self) -> float:
        raise TypeError("an interval is no number; say which you want: .lower, .upper, or .mid, which is not proved")

    @property
    def text(self) -> str:
        """Both ends as decimals: ``[lower, upper]``, each the shortest that reads back as the same binary64 number."""
        return f"[{_shortest(self.lower)}, {_shortest(self.upper)}]"

    def __str__(self) -> str:
        return self.text if self._proved else f"{self.text} (not proved)"

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self}>"

    def mpmath(self) -> Any:
        """As an interval of mpmath (``mpmath.iv.mpf``) with the same ends, rounded outward to the precision of ``mpmath.iv``."""
        import mpmath

        def end(x: Fraction) -> Any:
            return mpmath.iv.mpf(x.numerator) / mpmath.iv.mpf(x.denominator)

        return mpmath.iv.mpf([end(self._lower).a, end(self._upper).b])

    def flint(self, bits: Optional[int] = None) -> Any:
        """As a ball of python-flint (``flint.arb``) that contains the interval."""
        import flint

        before = flint.ctx.prec
        try:
            if bits is not None:
                flint.ctx.prec = bits
            ends = [flint.arb(flint.fmpq(x.numerator, x.denominator)) for x in self.ends]
            return ends[0].union(ends[1])
        finally:
            flint.ctx.prec = before


def _shortest(x: float) -> str:
    """As the library writes it."""
    return repr(int(x)) if math.isfinite(x) and x == int(x) and abs(x) < 1e15 else repr(x)
