"""What an argument means, and the error that names it if it means nothing."""
from __future__ import annotations

import decimal
import math
import numbers
import operator
import os
import re
from contextlib import contextmanager
from fractions import Fraction
from typing import Any, Iterator, NoReturn, Optional, Sequence, Union

import numpy as np

from . import _epsnet
from .errors import ArgumentError, EpsnetError

#: A length or a coordinate: exact for all of these types but floats, which stand for the shortest decimal that reads back as the same float,
#: so that 0.1 is 1/10. An ``mpf`` of mpmath and a ``Float`` of SymPy are exact, too.
Number = Union[int, float, str, Fraction, numbers.Rational, decimal.Decimal, "np.floating[Any]", "np.integer[Any]"]
Path = Union[str, "os.PathLike[str]"]

_MOST_DIGITS = 10**6  # As many as the library reads.
_EXPONENT = re.compile(r"[eE]([+-]?\d+)\s*$")


def refuse(expected: str, x: object, name: str) -> NoReturn:
    """Raises the error for an argument that cannot be meant."""
    text = repr(x)
    raise ArgumentError(f"expected {expected}, not {text if len(text) <= 200 else text[:200] + '…'}", place=name, expected=expected) from None


@contextmanager
def argument(name: str) -> Iterator[None]:
    """An error of the library inside is one about this argument."""
    try:
        yield
    except EpsnetError as error:
        if error.place is not None or error.file is not None:
            raise
        raise type(error)(error.reason, place=name, expected=error.expected) from None


def exact(x: Any, name: str) -> Fraction:
    """The number itself: a float, too, is its binary value."""
    try:
        if isinstance(x, (bool, np.bool_)):
            raise TypeError
        if isinstance(x, np.floating):
            return Fraction(*x.as_integer_ratio())
        if hasattr(x, "_mpf_"):
            return _of_mpf(x._mpf_)
        if isinstance(x, str):
            exponent = _EXPONENT.search(x)
            if len(x) > _MOST_DIGITS or (exponent and abs(int(exponent[1])) > _MOST_DIGITS):
                raise ValueError
            return Fraction(x)
        if isinstance(x, (numbers.Rational, float, decimal.Decimal)) or not hasattr(x, "numerator"):
            return Fraction(x)
        return Fraction(int(x.numerator), int(x.denominator))
    except (ValueError, TypeError, OverflowError, ZeroDivisionError, AttributeError):
        refuse("a number such as 0.1, Fraction(1, 3) or '1/3'", x, name)


def _of_mpf(parts: Any) -> Fraction:
    """(sign, mantissa, exponent, …), as mpmath and SymPy have it; without a mantissa, an exponent stands for what is not finite."""
    sign, mantissa, exponent = (int(part) for part in parts[:3])
    if (mantissa == 0 and exponent != 0) or abs(exponent) > 4 * _MOST_DIGITS:
        raise ValueError
    return Fraction(-mantissa if sign else mantissa) * Fraction(2) ** exponent


def as_fraction(x: Any, name: str) -> Fraction:
    """The number that is meant: a float is the shortest decimal that reads back as it."""
    if isinstance(x, (float, np.floating)):
        if not math.isfinite(x):
            refuse("a finite number", x, name)
        return exact(str(x), name)
    return exact(x, name)


def as_text(x: Any, name: str) -> str:
    """The same for the library, which reads decimals and quotients."""
    return x if isinstance(x, str) else str(as_fraction(x, name))


def length_text(x: Any, name: str) -> str:
    """The same for a positive length, which is written into files as it is given."""
    with argument(name):
        if isinstance(x, float):
            return _epsnet.length_text(float(x))
        return _epsnet.length_text(str(x) if isinstance(x, np.floating) else as_text(x, name))


def as_index(x: Any, name: str, least: int = 0, most: int = 2**32 - 1) -> int:
    """The integer, if it is in this range."""
    try:
        value = least - 1 if isinstance(x, bool) else operator.index(x)
    except TypeError:
        value = least - 1
    if not least <= value <= most:
        refuse(f"an integer from {least} to {most}", x, name)
    return value


def as_indices(x: Any, name: str, most: int = 2**32 - 1) -> list[int]:
    """Integers from 0 to ``most``."""
    return [as_index(item, name, 0, most) for item in as_items(x, name, "a sequence of integers")]


def as_items(x: Any, name: str, expected: str) -> list[Any]:
    """The items of an iterable that is no text."""
    if isinstance(x, (str, bytes)):
        refuse(expected, x, name)
    try:
        return list(x)
    except TypeError:
        refuse(expected, x, name)


def as_threads(x: Any) -> int:
    """The number of threads; 0 stands for one for each core."""
    return as_index(x, "threads", 0, 1024)


def as_flag(x: Any, name: str) -> bool:
    """Whether; nothing but True and False is either."""
    if not isinstance(x, (bool, np.bool_)):
        refuse("True or False", x, name)
    return bool(x)


def as_choice(x: Any, name: str, choices: Sequence[str]) -> str:
    """One of the names."""
    if not isinstance(x, str) or x not in choices:
        names = [f'"{choice}"' for choice in choices]
        given = f'"{x}"' if isinstance(x, str) else repr(x)
        raise ArgumentError(f"expected the {name} {', '.join(names[:-1])} or {names[-1]}, not {given}", place=name)
    return x


def as_string(x: Any, name: str) -> str:
    """A text."""
    if not isinstance(x, str):
        refuse("a text", x, name)
    return x


def as_path(x: Any, name: str = "path") -> str:
    """The name of a file."""
    try:
        return os.fsdecode(x)
    except TypeError:
        refuse("the path of a file", x, name)


def as_optional_path(x: Optional[Path]) -> Optional[str]:
    """The same, or None."""
    return None if x is None else as_path(x)
