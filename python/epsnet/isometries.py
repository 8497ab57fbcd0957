"""Elements of the group of a surface, exactly and in intervals."""
from __future__ import annotations

import importlib.util
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from ._annotations import Surface
from ._arguments import Number, as_choice, as_index, exact, refuse
from .errors import ArgumentError
from .intervals import Interval, arcosh

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Axis", "ComplexInterval", "Gaussian", "Isometry"]


class Gaussian:
    """A Gaussian rational number ``re + im·i``, exactly; ``re`` and ``im`` are fractions.Fraction. Immutable.

    >>> from epsnet import Gaussian
    >>> z = Gaussian(3, 4) / Gaussian(0, 1)
    >>> z, z.conjugate(), z.norm()
    (4 - 3i, 4 + 3i, Fraction(25, 1))
    >>> complex(Gaussian("1/2", "-1/4"))
    (0.5-0.25j)
    """

    __slots__ = ("re", "im")
    re: Fraction
    im: Fraction

    def __init__(self, re: Number = 0, im: Number = 0) -> None:
        object.__setattr__(self, "re", exact(re, "re"))
        object.__setattr__(self, "im", exact(im, "im"))

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("a Gaussian does not change")

    def __reduce__(self) -> tuple[Any, ...]:
        return Gaussian, (self.re, self.im)

    def conjugate(self) -> "Gaussian":
        """re − im·i."""
        return Gaussian(self.re, -self.im)

    def norm(self) -> Fraction:
        """re² + im²."""
        return self.re * self.re + self.im * self.im

    def __add__(self, other: object) -> "Gaussian":
        w = _gaussian(other)
        if w is None:
            return NotImplemented
        return Gaussian(self.re + w.re, self.im + w.im)

    __radd__ = __add__

    def __neg__(self) -> "Gaussian":
        return Gaussian(-self.re, -self.im)

    def __sub__(self, other: object) -> "Gaussian":
        w = _gaussian(other)
        if w is None:
            return NotImplemented
        return Gaussian(self.re - w.re, self.im - w.im)

    def __rsub__(self, other: object) -> "Gaussian":
        return (-self).__add__(other)

    def __mul__(self, other: object) -> "Gaussian":
        w = _gaussian(other)
        if w is None:
            return NotImplemented
        return Gaussian(self.re * w.re - self.im * w.im, self.re * w.im + self.im * w.re)

    __rmul__ = __mul__

    def __truediv__(self, other: object) -> "Gaussian":
        w = _gaussian(other)
        if w is None:
            return NotImplemented
        norm = w.norm()
        quotient = self * w.conjugate()
        return Gaussian(quotient.re / norm, quotient.im / norm)

    def __rtruediv__(self, other: object) -> "Gaussian":
        w = _gaussian(other)
        if w is None:
            return NotImplemented
        return w / self

    def __eq__(self, other: object) -> bool:
        w = _gaussian(other)
        return w is not None and self.re == w.re and self.im == w.im

    def __hash__(self) -> int:
        return hash(self.re) if self.im == 0 else hash((self.re, self.im))

    def __complex__(self) -> complex:
        return complex(self.re, self.im)

    def __repr__(self) -> str:
        if self.im == 0:
            return f"{self.re}"
        return f"{self.re} {'-' if self.im < 0 else '+'} {abs(self.im)}i"


def _gaussian(x: object) -> Optional[Gaussian]:
    if isinstance(x, Gaussian):
        return x
    return Gaussian(x) if isinstance(x, (int, Fraction)) else None


class ComplexInterval:
    """Intervals that contain the real and the imaginary part of a complex number."""

    __slots__ = ("re", "im")

    def __init__(self, re: Interval, im: Interval) -> None:
        for name, part in (("re", re), ("im", im)):
            if not isinstance(part, Interval):
                refuse("an interval", part, name)
        self.re = re
        self.im = im

    @property
    def mid(self) -> complex:
        """The midpoint, rounded. It is only near the true number."""
        return complex(self.re.mid, self.im.mid)

    @property
    def error(self) -> float:
        """A bound for the error of ``mid`` in each of its two parts."""
        return max(self.re.error, self.im.error)

    def conjugate(self) -> "ComplexInterval":
        """Of the conjugate number."""
        return ComplexInterval(self.re, -self.im)

    def __contains__(self, z: Union[complex, Gaussian]) -> bool:
        if isinstance(z, Gaussian):
            return z.re in self.re and z.im in self.im
        return z.real in self.re and z.imag in self.im

    def __eq__(self, other: object) -> bool:
        """Whether the ends are equal. This says nothing about the numbers inside."""
        return isinstance(other, ComplexInterval) and (self.re, self.im) == (other.re, other.im)

    def __hash__(self) -> int:
        return hash((self.re, self.im))

    def __repr__(self) -> str:
        return f"<ComplexInterval {self.re.text} + {self.im.text}i>"


#: A matrix with two rows of two.
Matrix = Tuple[Tuple[Any, Any], Tuple[Any, Any]]


class Axis(NamedTuple):
    """The ends of the axis of a hyperbolic isometry: points of the unit circle, in intervals."""

    #: The end from which it translates.
    repelling: ComplexInterval
    #: The end towards which it translates.
    attracting: ComplexInterval


class Isometry:
    """An element of the group Γ of a surface: the isometry of a word, a path across sides of the tiles that starts and ends in the same tile.

    An isometry of the Poincaré disk, ``z ↦ (a z + b)/(b̄ z + ā)``, in the coordinates of that tile. It is known exactly, by its word, and
    handed out as a matrix in the form that you ask for.

    >>> import epsnet
    >>> f = epsnet.Surface.octagon(seed=123).generators()[0]
    >>> f.word
    (4,)
    >>> (f * f.inverse()).word
    ()
    >>> matrix = f.sl2r()             # Intervals, rounded outward.
    >>> matrix[0][0].error < 1e-12
    True

    A surface of rational tiles has its elements over the Gaussian integers, up to a real factor that ``determinant`` says:

    >>> a, b = f.a, f.b
    >>> a.re.denominator, a.norm() - b.norm() == f.determinant
    (1, True)
    """

    def __init__(self, surface: "Surface", word: Sequence[int]) -> None:
        self.surface = surface
        #: The sides that the path crosses, in its order; side numbers of the surface.
        self.word: tuple[int, ...] = tuple(word)
        self._exact: Optional[tuple[Gaussian, Gaussian]] = None

    @property
    def is_exact(self) -> bool:
        """Whether ``a`` and ``b`` exist: true if the tiles are rational: not for regular ones, and not over a number field."""
        return self.surface.is_rational

    def _pair(self) -> tuple[Gaussian, Gaussian]:
        if self._exact is None:
            a, b = self.surface._core.exact_isometry(self.word)
            self._exact = Gaussian(*a), Gaussian(*b)
        return self._exact

    @property
    def a(self) -> Gaussian:
        """A Gaussian integer; ``a`` and ``b`` have no common integer factor. SurfaceError unless ``is_exact``."""
        return self._pair()[0]

    @property
    def b(self) -> Gaussian:
        """A Gaussian integer, as ``a``."""
        return self._pair()[1]

    @property
    def determinant(self) -> Fraction:
        """|a|² − |b|², a positive integer."""
        return self.a.norm() - self.b.norm()

    def exact(self) -> Matrix:
        """The matrix ((a, b), (b̄, ā)) of Gaussian integers; its determinant is ``determinant``."""
        return ((self.a, self.b), (self.b.conjugate(), self.a.conjugate()))

    def exact_real(self) -> Matrix:
        """The same isometry of the upper half-plane: a matrix of integers (as Fraction) with the determinant ``determinant``.

        The map z ↦ (z − i)/(z + i) identifies the half-plane with the disk."""
        a, b = self.a, self.b
        return ((a.re + b.re, a.im - b.im), (-a.im - b.im, a.re - b.re))

    def enclosure(self, bits: int = 53) -> tuple[ComplexInterval, ComplexInterval]:
        """Intervals that contain a and b for |a|² − |b|² = 1, at most |a|/2^bits wide: exact numbers, rounded outward. Their ends are exact: ``.ends``."""
        pairs = self.surface._core.enclosed_isometry(self.word, as_index(bits, "bits", 1, 2**20))
        a, b = (ComplexInterval(*(Interval(*ends, proved=True) for ends in pair)) for pair in pairs)
        return a, b

    def su11(self, bits: Optional[int] = None, kind: Optional[str] = None) -> Matrix:
        """The matrix ((a, b), (b̄, ā)) in SU(1,1), as ``enclosure`` has it.

        ``kind`` is "interval" (ComplexInterval), "flint" (flint.acb) or "mpmath" (mpmath.mpc intervals). Without it, ``bits`` gives what is
        installed, in the order flint, mpmath, interval; and without both it is intervals of 53 bits.
        """
        a, b = self.enclosure(53 if bits is None else bits)
        rows = ((a, b), (b.conjugate(), a.conjugate()))
        return _converted(rows, bits, kind)

    def sl2r(self, bits: Optional[int] = None, kind: Optional[str] = None) -> Matrix:
        """The same isometry of the upper half-plane, in SL(2,R), as ``su11``; z ↦ (z − i)/(z + i) maps the half-plane to the disk."""
        a, b = self.enclosure(53 if bits is None else bits)

        return _converted(((a.re + b.re, a.im - b.im), (-a.im - b.im, a.re - b.re)), bits, kind)

    def matrix(self, model: str = "disk") -> "NDArray[Any]":
        """The matrix of determinant 1 as an array of NumPy: complex, of the "disk", or real, of the "half-plane". Rounded, not proved."""
        if as_choice(model, "model", ("disk", "half-plane")) == "disk":
            return np.array([[entry.mid for entry in row] for row in self.su11()], dtype=np.complex128)
        return np.array([[entry.mid for entry in row] for row in self.sl2r()], dtype=np.float64)

    def trace(self, bits: int = 53) -> Interval:
        """The trace of the matrix that ``su11`` and ``sl2r`` return, in an interval. The isometry determines it up to its sign.

        >>> import epsnet
        >>> f = epsnet.Surface.regular(2).generators()[0]
        >>> abs(f.trace())                # 2 + 2√2
        <Interval [4.8284271247461898, 4.828427124746191]>
        """
        return 2 * self.enclosure(bits)[0].re

    @property
    def translation_length(self) -> Interval:
        """The hyperbolic length by which it translates along its axis, in an interval: that of the closed geodesic in its free homotopy
        class. 0 for the identity.

        >>> import epsnet
        >>> f = epsnet.Surface.regular(2).generators()[0]
        >>> f.translation_length, (f ** 2).translation_length
        (<Interval [3.0571418389619959, 3.0571418389619965]>, <Interval [6.1142836779239919, 6.114283677923993]>)
        """
        if self.is_identity():
            return Interval(0, 0, proved=True)
        a, _, determinant = self._entries(128)
        return arcosh(2 * a.re**2 / determinant - 1)

    def axis(self, bits: int = 53) -> Axis:
        """The ends of its axis on the unit circle of the tile's disk, in intervals of about that many bits.

        >>> import epsnet
        >>> f = epsnet.Surface.octagon(seed=123).generators()[0]
        >>> end = f.axis().attracting
        >>> end.error < 1e-14, abs(abs(end.mid) - 1) < 1e-14, abs(f(end.mid) - end.mid) < 1e-12
        (True, True, True)
        """
        bits = as_index(bits, "bits", 1, 2**16)
        if self.is_identity():
            raise ArgumentError("the identity has no axis")
        # The fixed points z of (az + b)/(b̄z + ā) have b̄z = i Im a ± s with s² = Re(a)² − |a|² + |b|²; there b̄z + ā is Re a ± s, and where that is
        # larger the isometry contracts.
        a, b, determinant = self._entries(bits + 64)
        s = (a.re**2 - determinant).sqrt(bits + 32)
        if a.re < 0:
            s = -s
        norm = b.re**2 + b.im**2

        def end(s: Interval) -> ComplexInterval:
            re, im = (s * b.re - a.im * b.im) / norm, (s * b.im + a.im * b.re) / norm
            return ComplexInterval(re.rounded(bits + 8), im.rounded(bits + 8))

        return Axis(end(-s), end(s))

    def _entries(self, bits: int) -> tuple[ComplexInterval, ComplexInterval, Interval]:
        """a, b and |a|² − |b|²: exactly, if the tiles are rational; else with so many bits that the square of a has that many after the point."""
        if not self.is_exact:
            size = sum(abs(part).ends[1] for part in (self.enclosure(8)[0].re, self.enclosure(8)[0].im))
            return (*self.enclosure(bits + 2 * int(size).bit_length()), Interval(1, 1, proved=True))
        a, b = (ComplexInterval(Interval(z.re, z.re, proved=True), Interval(z.im, z.im, proved=True)) for z in self._pair())
        return a, b, Interval(self.determinant, self.determinant, proved=True)

    def __mul__(self, other: "Isometry") -> "Isometry":
        """f·g: g first, then f. Their paths start in the same tile."""
        if not isinstance(other, Isometry):
            return NotImplemented
        if not self._same_surface(other):
            raise ArgumentError("the two isometries are elements of different surfaces")
        return Isometry(self.surface, self.surface.reduced(other.word + self.word))

    def __pow__(self, exponent: int) -> "Isometry":
        """The isometry applied so many times; its inverse, if the exponent is negative."""
        n = as_index(exponent, "exponent", -(10**6), 10**6)
        return Isometry(self.surface, self.surface.reduced((self if n >= 0 else self.inverse()).word * abs(n)))

    def _same_surface(self, other: "Isometry") -> bool:
        return other.surface is self.surface or other.surface == self.surface

    def __eq__(self, other: object) -> bool:
        """Whether both are the same element of the group of one surface, decided exactly. Elements of paths that start in different tiles are
        different, but for the identity."""
        if not isinstance(other, Isometry) or not self._same_surface(other):
            return False
        if self.word == other.word:
            return True
        if self.is_identity() or other.is_identity():
            return self.is_identity() and other.is_identity()
        return self.surface._tile_of[self.word[0]] == self.surface._tile_of[other.word[0]] and (self * other.inverse()).is_identity()

    def __hash__(self) -> int:
        if self.is_exact:
            return hash((self.a * self.a, self.a * self.b))  # The sign of (a, b) is arbitrary.
        circulation = self.surface._circulation
        return hash(sum(circulation[side] for side in self.word))

    def inverse(self) -> "Isometry":
        """The path backwards."""
        return Isometry(self.surface, [self.surface.partner(side) for side in reversed(self.word)])

    def is_identity(self) -> bool:
        """Whether it is 1, decided exactly."""
        if self.is_exact:
            return self.b == 0 and self.a.im == 0
        # It takes the centre of the tile to that of another one, at least 2r away, where cosh r = cos(π/q)/sin(π/p) is least for {3, 7}, 1.04…; and
        # |a| = cosh(d/2) for its distance d.
        a, _ = self.enclosure(16)
        return a.re**2 + a.im**2 < Fraction(21, 20)

    def __call__(self, z: Union[Gaussian, complex]) -> Union[Gaussian, complex]:
        """The image of a point of the disk: exactly for a Gaussian, rounded, and not proved, for a complex number."""
        if not isinstance(z, (Gaussian, complex, float, int, np.number)):
            refuse("a Gaussian or a complex number", z, "z")
        if isinstance(z, Gaussian):
            return (self.a * z + self.b) / (self.b.conjugate() * z + self.a.conjugate())
        a, b = (part.mid for part in self.enclosure(64))
        return (a * z + b) / (b.conjugate() * z + a.conjugate())

    def __repr__(self) -> str:
        word = " ".join(map(str, self.word[:12])) + (" …" if len(self.word) > 12 else "")
        return f"<Isometry of the word {word}>" if self.word else "<Isometry 1>"


def _converted(rows: Matrix, bits: Optional[int], kind: Optional[str]) -> Matrix:
    if kind is None:
        kind = "interval" if bits is None else _best_kind()
    if as_choice(kind, "kind", ("interval", "flint", "mpmath")) == "interval":
        return rows
    convert = _flint if kind == "flint" else _mpmath
    (a, b), (c, d) = ((convert(x, bits or 53), convert(y, bits or 53)) for x, y in rows)
    return (a, b), (c, d)


def _best_kind() -> str:
    return next((name for name in ("flint", "mpmath") if importlib.util.find_spec(name)), "interval")


def _flint(entry: Union[Interval, ComplexInterval], bits: int) -> Any:
    import flint

    if isinstance(entry, Interval):
        return entry.flint(bits + 8)
    return flint.acb(entry.re.flint(bits + 8), entry.im.flint(bits + 8))


def _mpmath(entry: Union[Interval, ComplexInterval], bits: int) -> Any:
    import mpmath

    before = mpmath.iv.prec
    try:
        mpmath.iv.prec = max(bits + 8, 53)
        return entry.mpmath() if isinstance(entry, Interval) else mpmath.iv.mpc(entry.re.mpmath(), entry.im.mpmath())
    finally:
        mpmath.iv.prec = before
