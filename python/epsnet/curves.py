"""Closed curves up to free homotopy: how they meet, their classes in homology, whether they fill."""
from __future__ import annotations

from functools import cached_property
from typing import Any, Iterator, Optional, Sequence, Union, overload

from . import _epsnet
from ._annotations import Surface
from ._arguments import argument, as_index, as_items, as_threads, refuse
from ._documents import Document
from ._immutable import Immutable
from ._progress import Progress, Shower
from .certificates import Certificate
from .errors import ArgumentError, SurfaceError
from .groups import as_word
from .intervals import Interval
from .nets import Net

__all__ = ["ClosedCurve", "ClosedCurves", "Curve"]


class Curve(Immutable):
    """A closed curve up to free homotopy, with a direction: what its word says of it. Immutable.

    All numbers but those of ``angles`` and ``twist_derivative`` are integers that words alone decide, exactly, in any hyperbolic metric of the
    surface. No checker looks at them; ``Surface.curves`` has the proof.

    >>> import epsnet
    >>> surface = epsnet.Surface.octagon(123)
    >>> a, b = surface.curve([0]), surface.curve([1])
    >>> a.simple, a.separating, a.intersections(b), a.algebraic_intersections(b)
    (True, False, 1, 1)
    >>> commutator = surface.curve([0, 1, 4, 5])
    >>> commutator.separating, commutator.genera, commutator.homology
    (True, (1, 1), (0, 0, 0, 0))
    """

    def __init__(self, surface: "Surface", word: Sequence[int], core: "_epsnet.ClosedCurve") -> None:
        self._core = core
        #: The surface.
        self.surface = surface
        #: The sides that the curve crosses, as they were given.
        self.word: tuple[int, ...] = tuple(word)

    @property
    def power(self) -> int:
        """The greatest k for which it is freely homotopic to a k-th power; 1 for a null-homotopic curve."""
        return self._core.power

    @cached_property
    def root_word(self) -> tuple[int, ...]:
        """The word of the primitive curve of which it is a power, a path from tile 0 to itself. Curves of one class have the same; that of a
        null-homotopic curve is empty."""
        return tuple(self.surface._curve_topology.root_word(self._core))

    @property
    def self_intersections(self) -> int:
        """The least number of double points of a curve of its class in general position."""
        return self._core.self_intersections

    @property
    def simple(self) -> bool:
        """Whether a curve without self-intersections is freely homotopic to it. A null-homotopic one is simple."""
        return self.self_intersections == 0

    @property
    def separating(self) -> bool:
        """Whether it is simple, not null-homotopic, and cuts the surface into two pieces."""
        return self._core.genus_on_the_left is not None

    @property
    def genera(self) -> Optional[tuple[int, int]]:
        """The genera of the pieces on its left and on its right, if it is ``separating``; else None."""
        left = self._core.genus_on_the_left
        return None if left is None else (left, self.surface.genus - left)

    @property
    def homology(self) -> tuple[int, ...]:
        """Its class in the first homology group: 2g coefficients in the basis ``surface.homology_basis()``."""
        return tuple(self._core.homology)

    def intersections(self, other: Any) -> int:
        """The geometric intersection number: the least number of points where two curves of these classes meet in general position.

        >>> import epsnet
        >>> surface = epsnet.Surface.octagon(123)
        >>> surface.curve([0, 0]).intersections([1, 1, 1])
        6
        """
        return self._numbers(other)[0]

    def algebraic_intersections(self, other: Any) -> int:
        """The algebraic intersection number: each point counts 1 where the other curve crosses this one from right to left, else −1."""
        return self._numbers(other)[1]

    def _numbers(self, other: Any) -> tuple[int, int]:
        return self.surface._curve_topology.intersections(self._core, self._other(other, "other")._core)

    def homotopic_to(self, other: Any) -> bool:
        """Whether both are freely homotopic, with their directions: for two curves of one surface this is ``==``."""
        return self == self._other(other, "other")

    def angles(self, other: Any) -> list[Interval]:
        """The angles in radians at which the closed geodesics cross of which the two curves are powers, each from the direction of this one
        counterclockwise to that of the other one: positive where the other one crosses from right to left. For one geodesic, where it crosses
        itself, each point once.

        Enclosed with balls, from the exact numbers of the surface; no checker looks at them, so the intervals say ``proved=False``. LimitError
        for curves that are too long for that.

        >>> import epsnet
        >>> bolza = epsnet.Surface.regular(2)
        >>> bolza.curve([0]).angles([1])               # π/4
        [<Interval [0.78539816339744827, 0.7853981633974484] (not proved)>]
        """
        return [Interval(*ends) for ends in self.surface._curve_topology.angles(self._core, self._other(other, "other")._core)]

    def twist_derivative(self, along: Any) -> Interval:
        """The derivative of the length of its closed geodesic with respect to a twist along a simple closed curve, as ``Surface.twist`` moves the
        other side to the left: −Σ cos θ over the crossings, θ the angle from the simple one to this one, directed so that it crosses from right
        to left (Wolpert's formula).

        Enclosed as ``angles`` are, with ``proved=False``. ArgumentError unless ``along`` is simple and not null-homotopic.

        >>> import epsnet
        >>> bolza = epsnet.Surface.regular(2)
        >>> bolza.curve([1]).twist_derivative([0])     # −cos π/4
        <Interval [-0.7071067811865476, -0.70710678118654746] (not proved)>
        """
        simple = self._other(along, "along")
        if not simple.simple or not simple._core.root:
            refuse("a simple closed curve that is not null-homotopic", along, "along")
        return Interval(*self.surface._curve_topology.twist_derivative(self._core, simple._core))

    def _other(self, other: Any, name: str) -> "Curve":
        if not isinstance(other, Curve):
            return curve(self.surface, other, name)
        if other.surface is not self.surface and other.surface != self.surface:
            refuse("a curve of the same surface", other, name)
        return other

    def __eq__(self, other: object) -> bool:
        """Whether both are freely homotopic, with their directions, on one surface."""
        return isinstance(other, Curve) and (self.power, self._core.root, self.surface) == (other.power, other._core.root, other.surface)

    def __hash__(self) -> int:
        return hash((self.power, tuple(self._core.root)))

    def __reduce__(self) -> tuple[Any, ...]:
        return curve, (self.surface, self.word)

    def __repr__(self) -> str:
        word = " ".join(map(str, self.word[:12])) + (" …" if len(self.word) > 12 else "")
        return f"<Curve of the word {word}>" if self.word else "<Curve of the empty word>"


class ClosedCurve:
    """A row of ``ClosedCurves``: a closed curve up to free homotopy, with a direction."""

    def __init__(
        self, curves: "ClosedCurves", number: int, vertex: int, word: Sequence[int], length: tuple[float, float], power: int, self_intersections: int,
        homology: Sequence[int]
    ) -> None:
        self._curves = curves
        self._length = length
        #: Its number in the list.
        self.number = number
        #: The vertex of the net in the tile of which its word starts and ends.
        self.vertex = vertex
        #: The sides that a loop crosses that is freely homotopic to it.
        self.word: tuple[int, ...] = tuple(word)
        #: The greatest k for which it is a k-th power.
        self.power = power
        #: The least number of double points of a curve of its class in general position.
        self.self_intersections = self_intersections
        #: Whether a curve without self-intersections is freely homotopic to it.
        self.simple = self_intersections == 0
        #: Its class in the first homology group: a coefficient for each curve of ``ClosedCurves.basis``.
        self.homology: tuple[int, ...] = tuple(homology)
        #: Whether it is simple and cuts the surface into two pieces.
        self.separating = self.simple and not any(homology)

    @property
    def length(self) -> Interval:
        """The length of its closed geodesic, as often as it goes around."""
        return Interval(*self._length, proved=self._curves.proved)

    def __eq__(self, other: object) -> bool:
        """Whether both are the same entry of equal lists."""
        return isinstance(other, ClosedCurve) and self.number == other.number and self._curves == other._curves

    def __hash__(self) -> int:
        return hash((self.number, self.word))

    def __reduce__(self) -> tuple[Any, ...]:
        return ClosedCurves.__getitem__, (self._curves, self.number)

    def __repr__(self) -> str:
        power = "" if self.power == 1 else f", power {self.power}"
        crossings = "simple" if self.simple else f"self-intersections {self.self_intersections}"
        return f"<ClosedCurve of length {self.length}{power}, {crossings}{', separating' if self.separating else ''}>"


class ClosedCurves(Document, Sequence[ClosedCurve]):
    """Closed curves up to free homotopy, how they meet, their classes in homology, and sets of them that fill: the contents of a curves file."""

    _core: "_epsnet.Curves"

    def __init__(self, core: "_epsnet.Curves", surface: Optional["Surface"], certificate: Optional[Certificate]) -> None:
        self._hold(core, surface, certificate)
        self._list = [ClosedCurve(self, number, *row) for number, row in enumerate(core.curves)]

    @cached_property
    def _pairs(self) -> list[tuple[int, int]]:
        """The two numbers by pair of curves, (0, 1), (0, 2), …, (1, 2), …"""
        return self._core.pairs

    def _pair(self, i: int, j: int) -> tuple[int, int]:
        i, j = as_index(i, "i", 0, len(self) - 1), as_index(j, "j", 0, len(self) - 1)
        if i == j:
            # Where a primitive curve has s double points, its k-th power has k²s + k − 1, and meets a copy of itself 2k²s times.
            one = self._list[i]
            return 2 * (one.self_intersections - (one.power - 1)), 0
        least, most = min(i, j), max(i, j)
        geometric, algebraic = self._pairs[least * len(self) - least * (least + 1) // 2 + most - least - 1]
        return geometric, algebraic if i < j else -algebraic

    def intersections(self, i: int, j: int) -> int:
        """The geometric intersection number of curves i and j: the least number of points where curves of these classes meet in general position."""
        return self._pair(i, j)[0]

    def algebraic_intersections(self, i: int, j: int) -> int:
        """Their algebraic intersection number: each point counts 1 where curve j crosses curve i from right to left, else −1."""
        return self._pair(i, j)[1]

    @property
    def basis(self) -> list[int]:
        """The numbers of curves whose classes are a basis of the first homology group. Those that ``Surface.curves`` adds are symplectic: a₁, b₁,
        a₂, b₂, …, and b_i crosses a_i once from right to left."""
        return self._core.basis

    @property
    def filling(self) -> list[tuple[int, ...]]:
        """Sets of curves that fill the surface, each as their numbers: all components of the complement of their closed geodesics are disks.
        Of a set that is not here nothing is said."""
        return [tuple(numbers) for numbers in self._core.filling]

    @cached_property
    def net(self) -> Net:
        """The net of the surface in the file."""
        return Net(self._core.net, self._surface, None)

    @overload
    def __getitem__(self, index: int) -> ClosedCurve: ...

    @overload
    def __getitem__(self, index: slice) -> list[ClosedCurve]: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[ClosedCurve, list[ClosedCurve]]:
        return self._list[index]

    def __len__(self) -> int:
        return len(self._list)

    def __iter__(self) -> Iterator[ClosedCurve]:
        return iter(self._list)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ClosedCurves) and bool(self._core == other._core)

    def __hash__(self) -> int:
        return hash(tuple(one.word for one in self))

    def __repr__(self) -> str:
        return f"<ClosedCurves: {len(self)}, the basis of homology {self.basis}{'' if self.proved else ' (not proved)'}>"


def curve(surface: "Surface", word: Any, name: str = "word") -> Curve:
    sides = as_word(surface, word, name)
    with argument(name):
        return Curve(surface, sides, surface._curve_topology.curve(sides))


def _words(surface: "Surface", words: Any, name: str) -> list[list[int]]:
    return [as_word(surface, word, name) for word in as_items(words, name, "closed curves")]


def curves(surface: "Surface", words: Any, threads: int, progress: Progress) -> ClosedCurves:
    sides, threads = _words(surface, words, "words"), as_threads(threads)
    with Shower(progress) as callback:
        core, certificate = _epsnet.Curves.find(surface._core, sides, threads, callback)
    return ClosedCurves(core, surface, Certificate(certificate))


def fills(surface: "Surface", words: Any) -> bool:
    found = []
    for number, sides in enumerate(_words(surface, words, "curves")):
        try:
            found.append(surface._curve_topology.curve(sides))
        except SurfaceError as error:
            raise ArgumentError(error.reason, place=f"curve {number}") from None
    return surface._curve_topology.fill(found)
