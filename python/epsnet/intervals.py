"""Intervals that contain real numbers."""
from __future__ import annotations

import decimal
import math
from fractions import Fraction
from typing import Any, Optional, Union

from . import _epsnet

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

    What is printed is rounded outward: the decimals are true bounds. That holds for ``str``, ``repr`` and ``f"{x:.4f}"``, but not for
    ``print(x.lower)``: Python rounds a float to nearest.
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
        """The midpoint, rounded. It is only near the true number; ``error`` bounds the difference."""
        return float((self._lower + self._upper) / 2)

    @property
    def error(self) -> float:
        """A bound for the distance of the true number from ``mid``."""
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
        """Whether the two intervals intersect. If they do not, the numbers differ."""
        return self._lower <= other._upper and other._lower <= self._upper

    def __eq__(self, other: object) -> bool:
        """Whether the ends are equal. This says nothing about the numbers inside."""
        return isinstance(other, Interval) and self.ends == other.ends

    def __hash__(self) -> int:
        return hash(self.ends)

    def __bool__(self) -> bool:
        raise TypeError("an interval is neither true nor false")

    def __float__(self) -> float:
        raise TypeError("an interval is no number; say which you want: .lower, .upper, or .mid, which is not proved")

    @property
    def text(self) -> str:
        """``[lower, upper]`` as decimals that contain the interval; each is the shortest that reads back as ``lower`` or ``upper``."""
        return f"[{_epsnet.decimal_below(self.lower)}, {_epsnet.decimal_above(self.upper)}]"

    def __str__(self) -> str:
        return self._marked(self.text)

    def __format__(self, spec: str) -> str:
        """Both ends as ``format`` writes a ``decimal.Decimal``, rounded outward: ``f"{x:.4f}"`` contains the interval, too.

        >>> from epsnet import Interval
        >>> f"{Interval('1/3', '2/3', proved=True):.4f}"
        '[0.3333, 0.6667]'
        """
        if not spec:
            return str(self)
        return self._marked(f"[{_formatted(self._lower, spec, decimal.ROUND_FLOOR)}, {_formatted(self._upper, spec, decimal.ROUND_CEILING)}]")

    def _marked(self, text: str) -> str:
        return text if self._proved else f"{text} (not proved)"

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


def _formatted(x: Fraction, spec: str, rounding: str) -> str:
    """A decimal on that side of x."""
    digits = 40  # Rounded twice, in the same direction.
    with decimal.localcontext(decimal.Context(prec=digits, rounding=rounding)):
        return format(decimal.Decimal(x.numerator) / decimal.Decimal(x.denominator), spec)
