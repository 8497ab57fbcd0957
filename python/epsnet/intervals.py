"""Intervals that contain real numbers."""
from __future__ import annotations

import decimal
import math
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Callable, Iterable, Optional, Union, cast

import numpy as np

from . import _epsnet
from ._arguments import Number, as_flag, as_index, as_items, exact, refuse
from ._immutable import Immutable
from .errors import ArgumentError, UndecidedError

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Interval", "ends", "mids"]


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


class Interval(Immutable):
    """A closed interval that contains a real number. Immutable.

    ``proved`` says whether it is proved that it does: by the checker, or, for isometries and arithmetic, by this module, which rounds exact
    numbers outward (docs/trusted-base.md, "Who proves what"). What epsnet computes is proved, unless its documentation says otherwise; what was
    loaded with ``check=False`` is not.

    >>> from epsnet import Interval
    >>> x = Interval(1, "1.5", proved=True)
    >>> x.lower, x.upper, x.width
    (1.0, 1.5, 0.5)
    >>> 1.25 in x, 2 in x
    (True, False)

    ``+``, ``-``, ``*``, ``/``, ``abs`` and ``**`` with an integer give the least interval that contains the result, exactly: the ends are
    fractions. The other operand is an interval or a number, of which a float is its binary value. The result is proved if all operands are.

    >>> (2 * x - 1) / 3, x ** 2
    (<Interval [0.3333333333333333, 0.66666666666666675]>, <Interval [1, 2.25]>)

    Two occurrences of one number are two numbers here: ``x - x`` contains 0, and is not 0. Ends grow with each operation;
    ``x.rounded()`` has short ones.

    ``<``, ``<=``, ``>``, ``>=`` compare the numbers inside. They are decided by the ends, or raise UndecidedError:

    >>> x < 1.75, x > 3
    (True, False)
    >>> x < 1.25
    Traceback (most recent call last):
    epsnet.errors.UndecidedError: [1, 1.5] < [1.25, 1.25] is not decided: the intervals overlap

    ``==`` compares the ends alone, and says nothing about the numbers inside. An interval does not convert to a float: say which number you
    want, ``x.lower``, ``x.upper``, or ``x.mid``, which is a guess. Arrays are ``epsnet.ends(intervals)`` and, for plots, ``epsnet.mids(intervals)``.

    ``sorted(intervals)`` and ``max(intervals)`` raise unless every comparison is decided. ``sorted(intervals, key=Interval.key)`` sorts by the
    lower ends, and equal ones by the upper ends, which is the order of the numbers wherever intervals do not overlap; ``Interval.maximum`` is
    an interval that contains the greatest number, whichever it is.

    What is printed is rounded outward: the decimals are true bounds. That holds for ``str``, ``repr`` and ``f"{x:.4f}"``, but not for
    ``print(x.lower)``: Python rounds a float to nearest.
    """

    __slots__ = ("_lower", "_upper", "_proved")
    __sympy__ = False  # Rational + Interval is left to this class: since SymPy 1.13 it would ask for a float instead.

    def __init__(self, lower: Number, upper: Number, *, proved: bool = False) -> None:
        self._lower = exact(lower, "lower")
        self._upper = exact(upper, "upper")
        self._proved = as_flag(proved, "proved")
        if self._lower > self._upper:
            raise ArgumentError(f"an interval has its lower end first, not [{lower}, {upper}]", place="upper")

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

    def __float__(self) -> float:
        raise TypeError(
            "an interval is no number; say which you want: .lower, .upper, or .mid, which is not proved; for an array of many, "
            "epsnet.ends(intervals) or epsnet.mids(intervals)"
        )

    def __contains__(self, x: Union[Number, "Interval"]) -> bool:
        if isinstance(x, Interval):
            return self._lower <= x._lower and x._upper <= self._upper
        if isinstance(x, (float, np.floating)) and not math.isfinite(x):
            return False
        return self._lower <= exact(x, "x") <= self._upper

    def overlaps(self, other: "Interval") -> bool:
        """Whether the two intervals intersect. If they do not, the numbers differ."""
        if not isinstance(other, Interval):
            refuse("an interval", other, "other")
        return self._lower <= other._upper and other._lower <= self._upper

    def rounded(self, bits: int = 53) -> "Interval":
        """A slightly larger interval; its ends are the nearest outward numbers with at most that many bits.

        >>> from epsnet import Interval
        >>> Interval("1/3", "2/3").rounded(4).ends
        (Fraction(5, 16), Fraction(11, 16))
        """
        bits = as_index(bits, "bits", 1, 2**20)
        return Interval(_short(self._lower, bits), -_short(-self._upper, bits), proved=self.proved)

    # Arithmetic.

    def __add__(self, other: Any) -> "Interval":
        return self._with(other, lambda y: (self._lower + y._lower, self._upper + y._upper))

    __radd__ = __add__

    def __neg__(self) -> "Interval":
        return Interval(-self._upper, -self._lower, proved=self.proved)

    def __pos__(self) -> "Interval":
        return Interval(self._lower, self._upper, proved=self.proved)

    def __sub__(self, other: Any) -> "Interval":
        return self._with(other, lambda y: (self._lower - y._upper, self._upper - y._lower))

    def __rsub__(self, other: Any) -> "Interval":
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> "Interval":
        return self._with(other, lambda y: _hull(a * b for a in self.ends for b in y.ends))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> "Interval":
        return self._with(other, lambda y: _hull(a / b for a in self.ends for b in y._divisor().ends))

    def __rtruediv__(self, other: Any) -> "Interval":
        return self._divisor()._with(other, lambda y: _hull(b / a for a in self.ends for b in y.ends))

    def __pow__(self, exponent: int) -> "Interval":
        if isinstance(exponent, Interval):
            return NotImplemented
        n = as_index(exponent, "exponent", -(10**6), 10**6)
        if n < 0:
            inverse: Interval = 1 / self**-n
            return inverse
        if n == 0:
            return Interval(1, 1, proved=self.proved)
        base = abs(self) if n % 2 == 0 else self
        return Interval(base._lower**n, base._upper**n, proved=self.proved)

    def __abs__(self) -> "Interval":
        return Interval(max(self._lower, -self._upper, Fraction(0)), max(-self._lower, self._upper), proved=self.proved)

    def sqrt(self, bits: int = 64) -> "Interval":
        """The square root, its ends with that many bits. The interval must have no negative number."""
        bits = as_index(bits, "bits", 1, 2**20)
        if self._lower < 0:
            raise UndecidedError(f"the square root of {self.text}: the number may be negative")
        return Interval(_root(self._lower, bits)[0], _root(self._upper, bits)[1], proved=self.proved)

    def _divisor(self) -> "Interval":
        if self._lower == self._upper == 0:
            raise ZeroDivisionError("division by an interval that is 0")
        if self._lower <= 0 <= self._upper:
            raise UndecidedError(f"division by {self.text}, which contains 0")
        return self

    def _with(self, other: Any, ends: Callable[["Interval"], tuple[Fraction, Fraction]]) -> "Interval":
        y = _operand(other)
        if y is None:
            return cast(Interval, NotImplemented)
        return Interval(*ends(y), proved=self.proved and y.proved)

    @staticmethod
    def maximum(intervals: Iterable["Interval"]) -> "Interval":
        """An interval that contains the greatest of the numbers in these intervals.

        >>> from epsnet import Interval
        >>> Interval.maximum([Interval(1, 4), Interval(2, 3)]).ends
        (Fraction(2, 1), Fraction(4, 1))
        """
        found = _some(intervals)
        return Interval(max(x._lower for x in found), max(x._upper for x in found), proved=all(x.proved for x in found))

    @staticmethod
    def minimum(intervals: Iterable["Interval"]) -> "Interval":
        """An interval that contains the least of the numbers in these intervals."""
        return -Interval.maximum([-x for x in _some(intervals)])

    # Comparisons.

    def key(self) -> tuple[Fraction, Fraction]:
        """``ends``, to sort by: ``sorted(intervals, key=Interval.key)``. Proves nothing about the order of numbers in intervals that overlap."""
        return self.ends

    def __lt__(self, other: Any) -> bool:
        return self._decided("<", other, lambda y: self._upper < y._lower, lambda y: self._lower >= y._upper)

    def __le__(self, other: Any) -> bool:
        return self._decided("<=", other, lambda y: self._upper <= y._lower, lambda y: self._lower > y._upper)

    def __gt__(self, other: Any) -> bool:
        return self._decided(">", other, lambda y: self._lower > y._upper, lambda y: self._upper <= y._lower)

    def __ge__(self, other: Any) -> bool:
        return self._decided(">=", other, lambda y: self._lower >= y._upper, lambda y: self._upper < y._lower)

    def _decided(self, sign: str, other: Any, holds: Callable[["Interval"], bool], fails: Callable[["Interval"], bool]) -> bool:
        y = _operand(other)
        if y is None:
            return cast(bool, NotImplemented)
        if holds(y):
            return True
        if fails(y):
            return False
        raise UndecidedError(f"{self.text} {sign} {y.text} is not decided: the intervals overlap")

    def __eq__(self, other: object) -> bool:
        """Whether the ends are equal. This says nothing about the numbers inside."""
        return isinstance(other, Interval) and self.ends == other.ends

    def __hash__(self) -> int:
        return hash(self.ends)

    def __bool__(self) -> bool:
        raise TypeError("an interval is neither true nor false")

    def __reduce__(self) -> Union[str, tuple[Any, ...]]:
        return _unpickled, (self._lower, self._upper, self._proved)

    # In other forms.

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
        return text if self.proved else f"{text} (not proved)"

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
        precision = None if bits is None else as_index(bits, "bits", 2, 2**24)
        import flint

        before = flint.ctx.prec
        try:
            if precision is not None:
                flint.ctx.prec = precision
            ends = [flint.arb(flint.fmpq(x.numerator, x.denominator)) for x in self.ends]
            return ends[0].union(ends[1])
        finally:
            flint.ctx.prec = before


def mids(intervals: Iterable[Interval]) -> "NDArray[np.float64]":
    """The midpoints of intervals as an array, for plots; they prove nothing.

    >>> import epsnet
    >>> epsnet.mids([epsnet.Interval(1, 2), epsnet.Interval(3, 3)])
    array([1.5, 3. ])
    """
    return np.array([x.mid for x in _intervals(intervals)], dtype=np.float64)


def ends(intervals: Iterable[Interval]) -> "NDArray[np.float64]":
    """The ends of intervals as an array: a row for each, with its lower end, rounded down, and its upper end, rounded up.

    >>> from epsnet import Interval, ends
    >>> ends([Interval(1, 2), Interval(3, "7/2")])
    array([[1. , 2. ],
           [3. , 3.5]])
    """
    found = _intervals(intervals)
    return np.array([(x.lower, x.upper) for x in found], dtype=np.float64).reshape(len(found), 2)


def arcosh(x: Interval) -> Interval:
    """The inverse hyperbolic cosine, rounded outward. What the interval has below 1 is left out."""
    return Interval(*_epsnet.arcosh(*x.ends), proved=x.proved)


def _unpickled(lower: Fraction, upper: Fraction, proved: bool) -> Interval:
    return Interval(lower, upper, proved=proved)


def _intervals(intervals: Iterable[Interval]) -> list[Interval]:
    found = as_items(intervals, "intervals", "intervals")
    for x in found:
        if not isinstance(x, Interval):
            refuse("intervals", x, "intervals")
    return found


def _some(intervals: Iterable[Interval]) -> list[Interval]:
    found = _intervals(intervals)
    if not found:
        refuse("one interval at least", found, "intervals")
    return found


def _operand(x: Any) -> Optional[Interval]:
    """An interval, or a number as one."""
    if isinstance(x, Interval):
        return x
    if isinstance(x, (str, bytes, complex, bool)):
        return None
    try:
        value = exact(x, "operand")
    except ArgumentError:
        return None
    return Interval(value, value, proved=True)


def _hull(numbers: Iterable[Fraction]) -> tuple[Fraction, Fraction]:
    found = list(numbers)
    return min(found), max(found)


def _short(x: Fraction, bits: int) -> Fraction:
    """The greatest number of so many bits that is at most x."""
    shift = bits - (abs(x.numerator).bit_length() - x.denominator.bit_length())
    unit = Fraction(2) ** -shift
    while x and abs(x) >= unit * 2**bits:
        unit *= 2
    return math.floor(x / unit) * unit


def _root(x: Fraction, bits: int) -> tuple[Fraction, Fraction]:
    """Bounds of the square root, with at least so many bits."""
    shift = max(0, bits + 1 - (x.numerator.bit_length() - x.denominator.bit_length()) // 2)
    scaled = x * 4**shift
    below = math.isqrt(math.floor(scaled))
    above = below if below * below == scaled else below + 1
    return Fraction(below, 2**shift), Fraction(above, 2**shift)


def _formatted(x: Fraction, spec: str, rounding: str) -> str:
    """A decimal on that side of x."""
    digits = 40  # Rounded twice, in the same direction.
    with decimal.localcontext(decimal.Context(prec=digits, rounding=rounding)):
        return format(decimal.Decimal(x.numerator) / decimal.Decimal(x.denominator), spec)
