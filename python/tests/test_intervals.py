"""The arithmetic of intervals, compared with exact fractions; their comparisons, copies, arrays."""
import copy
import math
import operator
import pickle
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given, strategies as st

import epsnet
from epsnet import Interval

numbers = st.fractions(min_value=-10, max_value=10, max_denominator=1000)
shares = st.fractions(min_value=0, max_value=1, max_denominator=20)
OPERATIONS = [operator.add, operator.sub, operator.mul, operator.truediv]


@st.composite
def intervals(draw, proved=True):
    return Interval(*sorted((draw(numbers), draw(numbers))), proved=proved)


def inside(x, share):
    """A number of the interval, exactly."""
    lower, upper = x.ends
    return lower + share * (upper - lower)


@pytest.mark.parametrize("operation", OPERATIONS)
@given(x=intervals(), y=intervals(), s=shares, t=shares)
def test_results_contain_those_of_the_numbers_inside(operation, x, y, s, t):
    if operation is operator.truediv:
        assume(0 not in y)
    result = operation(x, y)
    assert operation(inside(x, s), inside(y, t)) in result and result.proved
    # No larger than need be: both ends are those of some corner.
    corners = [operation(a, b) for a in x.ends for b in y.ends]
    assert result.ends == (min(corners), max(corners))
    # Rounded, it contains them, too.
    assert Fraction(result.lower) <= result.ends[0] and result.ends[1] <= Fraction(result.upper)


@pytest.mark.parametrize("operation", OPERATIONS)
@given(x=intervals(), a=numbers, s=shares)
def test_a_number_may_be_either_operand(operation, x, a, s):
    if operation is not operator.truediv or a != 0:
        assert operation(inside(x, s), a) in operation(x, a)
    if operation is not operator.truediv or 0 not in x:
        assert operation(a, inside(x, s)) in operation(a, x)


@given(intervals(), st.integers(-5, 5), shares)
def test_powers_and_absolute_values(x, n, s):
    if n >= 0 or 0 not in x:
        power = x**n
        assert inside(x, s) ** n in power
        ends = [end**n for end in x.ends] + ([Fraction(0)] if 0 in x and n > 0 else [])
        assert n == 0 or power.ends == (min(ends), max(ends))
    assert abs(inside(x, s)) in abs(x) and abs(x).ends[0] >= 0 and (abs(x).ends[0] == 0) == (0 in x)
    assert (-x).ends == (-x.ends[1], -x.ends[0]) and +x == x


@given(intervals(), st.integers(1, 80))
def test_rounding_and_roots_are_outward(x, bits):
    rounded = x.rounded(bits)
    assert x in rounded
    for end, exact in zip(rounded.ends, x.ends):
        mantissa = end.numerator
        while mantissa and mantissa % 2 == 0:
            mantissa //= 2
        assert abs(mantissa) < 2**bits and (end.denominator & (end.denominator - 1)) == 0
        assert abs(end - exact) <= abs(exact) * Fraction(2) ** (1 - bits)
    square = abs(x)
    root = square.sqrt(bits)
    assert root.ends[0] ** 2 <= square.ends[0] and square.ends[1] <= root.ends[1] ** 2
    assert root.ends[1] ** 2 <= square.ends[1] * (1 + Fraction(2) ** (2 - bits))


def test_other_kinds_of_numbers():
    mpmath = pytest.importorskip("mpmath")
    sympy = pytest.importorskip("sympy")
    x = Interval(1, 2, proved=True)
    for one in (1, 1.0, Fraction(1), Decimal(1), np.float64(1), np.float32(1), np.int64(1), mpmath.mpf(1), sympy.Rational(1)):
        for result in (x + one, one + x):
            assert result == Interval(2, 3) and result.proved
        assert (x - one, one - x, x * one, x / one) == (Interval(0, 1), Interval(-1, 0), x, x)
        assert one in x and x >= one and not x < one
    # A float is its binary value here.
    assert (x * 0.1).ends[0] == Fraction(0.1)
    assert not (x + Interval(0, 0)).proved
    for no_number in ("1", None, True, 1j, [1], math.nan, math.inf):
        for operation in OPERATIONS:
            with pytest.raises(TypeError):
                operation(x, no_number)
    with pytest.raises(TypeError):
        2**x


def test_division_by_zero():
    x = Interval(1, 2)
    with pytest.raises(ZeroDivisionError):
        x / 0
    for divisor in (Interval(-1, 1), Interval(0, 1), Interval(-1, 0)):
        with pytest.raises(epsnet.UndecidedError, match="contains 0"):
            x / divisor
        with pytest.raises(epsnet.UndecidedError):
            1 / divisor
        with pytest.raises(epsnet.UndecidedError):
            divisor**-1


COMPARISONS = [operator.lt, operator.le, operator.gt, operator.ge]


@pytest.mark.parametrize("comparison", COMPARISONS)
@given(x=intervals(), y=intervals() | numbers, s=shares, t=shares)
def test_comparisons_are_decided_or_raise(comparison, x, y, s, t):
    low, high = y.ends if isinstance(y, Interval) else (y, y)
    answers = {comparison(a, b) for a in x.ends for b in (low, high)}
    if len(answers) == 1:
        assert comparison(x, y) == answers.pop() == comparison(inside(x, s), inside(Interval(low, high), t))
    else:
        with pytest.raises(epsnet.UndecidedError, match="not decided"):
            comparison(x, y)
    with pytest.raises(TypeError):
        comparison(x, "1")


def test_maximum_and_sorting():
    a, b, c = Interval(0, 1, proved=True), Interval(2, 3, proved=True), Interval("2.5", 4)
    assert max([a, b]) is b and min(a, b) is a and sorted([b, a]) == [a, b]
    for decide in (max, min, sorted):
        with pytest.raises(epsnet.UndecidedError):
            decide([b, c])
    assert sorted([c, b, a], key=Interval.key) == [a, b, c]
    assert Interval.maximum([a, b, c]) == Interval("2.5", 4) and Interval.minimum([c, b]) == Interval(2, 3)
    assert Interval.maximum([a, b]).proved and not Interval.maximum([a, c]).proved
    for wrong in ([], [1], "x", None):
        with pytest.raises(epsnet.ArgumentError) as caught:
            Interval.maximum(wrong)
        assert caught.value.place == "intervals"


def test_arrays_of_ends():
    x = [Interval("1/3", "2/3"), Interval(-2, "-1/3")]
    array = epsnet.ends(x)
    assert array.shape == (2, 2) and array.dtype == float and epsnet.ends([]).shape == (0, 2)
    for (lower, upper), interval in zip(array, x):
        assert Fraction(lower) <= interval.ends[0] and interval.ends[1] <= Fraction(upper)
        assert Fraction(np.nextafter(lower, np.inf)) > interval.ends[0] and Fraction(np.nextafter(upper, -np.inf)) < interval.ends[1]


def test_results_are_formatted_outward():
    x = Interval(1, 2, proved=True) / 3
    assert f"{x:.4f}" == "[0.3333, 0.6667]" and f"{-x:.4f}" == "[-0.6667, -0.3333]" and f"{x + Interval(0, 0):.1f}" == "[0.3, 0.7] (not proved)"


@given(intervals(), st.booleans())
def test_copies_and_pickles(x, proved):
    x = Interval(*x.ends, proved=proved)
    for again in (copy.copy(x), copy.deepcopy(x), pickle.loads(pickle.dumps(x))):
        assert again == x and again.proved == proved and hash(again) == hash(x)


def test_infinite_ends_are_refused():
    for wrong in (math.nan, math.inf, "one", None, True, "1e9999999999"):
        with pytest.raises(epsnet.ArgumentError) as caught:
            Interval(wrong, 1)
        assert caught.value.place == "lower"
    with pytest.raises(epsnet.ArgumentError, match="lower end first"):
        Interval(2, 1)
