"""The isometries of a surface, and from one surface to another."""
from __future__ import annotations

from functools import cached_property
from typing import Any, List, Optional, Sequence, Tuple, Union, overload

from . import _epsnet
from ._annotations import Surface
from ._arguments import Path, as_index, as_threads, refuse
from ._documents import Document
from ._immutable import Immutable
from ._progress import Progress, Shower
from .certificates import Certificate
from .errors import NetError, UndecidedError
from .isometries import Isometry
from .nets import Net
from .points import Point, point_of

__all__ = ["Comparison", "IsometryGroup", "IsometryProof", "SurfaceIsometry"]


class SurfaceIsometry(Immutable):
    """An isometry from a surface to another or to itself, as what it does with the group. That it is one is decided exactly."""

    def __init__(self, surface: "Surface", target: "Surface", core: Tuple[bool, List[List[int]]]) -> None:
        self._target = target
        #: The surface that it maps.
        self.surface = surface
        #: Whether it preserves the orientation.
        self.preserves_orientation = core[0]
        #: By generator of ``surface.generators()``: the word of the element of the other group to which it goes.
        self.words = tuple(tuple(word) for word in core[1])

    @property
    def images(self) -> List[Isometry]:
        """The elements of the other group to which ``surface.generators()`` go."""
        return [self._target.element(word) for word in self.words]

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, SurfaceIsometry):
            return NotImplemented
        return (self.surface, self._target, self.preserves_orientation, self.words) == (
            other.surface, other._target, other.preserves_orientation, other.words,
        )

    def __hash__(self) -> int:
        return hash((self.preserves_orientation, self.words))

    def __repr__(self) -> str:
        return f"<SurfaceIsometry that {'preserves' if self.preserves_orientation else 'reverses'} orientation>"


class IsometryProof(Document):
    """How many isometries a surface has, and some that generate all, with what proves it: the contents of an isometries file."""

    _core: "_epsnet.IsometryProof"

    def __init__(self, core: "_epsnet.IsometryProof", surface: Optional["Surface"], certificate: Optional[Certificate]) -> None:
        self._hold(core, surface, certificate)

    @property
    def order(self) -> int:
        """How many isometries there are."""
        return self._core.order

    @property
    def orientation_preserving(self) -> int:
        """How many of them preserve the orientation."""
        return self.order if all(self._core.preserving) else self.order // 2

    @property
    def up_to(self) -> str:
        """The length up to which closed geodesics prove it."""
        return self._core.up_to

    @cached_property
    def net(self) -> Net:
        """The net on which the list of closed geodesics is proved."""
        return Net(self._core.net, self._surface, None)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, IsometryProof) and bool(self._core == other._core)

    def __hash__(self) -> int:
        return hash((self.order, self.up_to))

    def __repr__(self) -> str:
        return f"<IsometryProof of order {self.order}{'' if self.proved else ' (not proved)'}>"


class Comparison(Document):
    """That two surfaces are isometric, or that they are not, with what proves it: the contents of a comparison file."""

    _core: "_epsnet.Comparison"

    def __init__(
        self, core: "_epsnet.Comparison", surface: Optional["Surface"], certificate: Optional[Certificate],
        other: Optional["Surface"] = None, isometry: Optional[SurfaceIsometry] = None,
    ) -> None:
        self._hold(core, surface, certificate)
        self._other = other
        #: The isometry, if they are isometric and this was not loaded from a file; else None.
        self.isometry = isometry

    @property
    def isometric(self) -> bool:
        """Whether they are isometric."""
        return self._core.isometric

    @property
    def other(self) -> "Surface":
        """The other surface."""
        if self._other is None:
            self._other = self._surface_class._of(self._core.other_net.surface)
        return self._other

    @cached_property
    def net(self) -> Net:
        """The net of the first surface on which it is proved."""
        return Net(self._core.net, self._surface, None)

    @cached_property
    def other_net(self) -> Net:
        """The net of the other surface."""
        return Net(self._core.other_net, self._other, None)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Comparison) and bool(self._core == other._core)

    def __hash__(self) -> int:
        return hash((self.isometric, self.surface, self.other))

    def __repr__(self) -> str:
        return f"<Comparison: {'isometric' if self.isometric else 'different'}{'' if self.proved else ' (not proved)'}>"


class IsometryGroup(Immutable, Sequence[SurfaceIsometry]):
    """The isometries of a surface; number 0 is the identity.

    Each is decided exactly. That there are no others is computed with numbers of 256 bits, until ``proof`` is asked for.
    """

    def __init__(self, surface: "Surface", core: "_epsnet.IsometryGroup", threads: int = 0) -> None:
        self.surface = surface
        self._core = core
        self._threads = threads

    @cached_property
    def proof(self) -> IsometryProof:
        """The proof that these are isometries, and that there are no others. It is made on first use. NotVerifiedError if closed geodesics
        do not prove it.

        >>> import epsnet
        >>> epsnet.Surface.octagon(1).isometries().proof
        <IsometryProof of order 2>
        """
        with Shower(False) as callback:
            core, found = self._core.proof(self.surface._core, self._threads, callback)
        return IsometryProof(core, self.surface, Certificate(found))

    @property
    def certificate(self) -> Certificate:
        """The result of the checker for ``proof``."""
        return self.proof.certificate

    def save(self, path: Path) -> None:
        """Writes the file of ``proof``, completely or not at all: for ``epsnet.load``, and for the program ``certify``."""
        self.proof.save(path)

    @cached_property
    def _isometries(self) -> List[SurfaceIsometry]:
        return [SurfaceIsometry(self.surface, self.surface, self._core.isometry(i)) for i in range(len(self._core))]

    def __len__(self) -> int:
        return len(self._core)

    @overload
    def __getitem__(self, place: int) -> SurfaceIsometry: ...
    @overload
    def __getitem__(self, place: slice) -> List[SurfaceIsometry]: ...
    def __getitem__(self, place: Union[int, slice]) -> Union[SurfaceIsometry, List[SurfaceIsometry]]:
        return self._isometries[place]

    @property
    def generators(self) -> List[int]:
        """The numbers of isometries that generate all."""
        return list(self._core.generators)

    @property
    def name(self) -> str:
        """"C6" for a cyclic group, "D4" for the symmetries of a square, "C2 x C2"; empty for other groups."""
        return self._core.name

    def _number(self, i: int) -> int:
        return as_index(i, "i", 0, len(self) - 1)

    def product(self, i: int, j: int) -> int:
        """The number of isometry i after isometry j."""
        return self._core.product(self._number(i), as_index(j, "j", 0, len(self) - 1))

    def order(self, i: int) -> int:
        """The order of isometry i."""
        return self._core.order(self._number(i))

    def fixed_points(self, i: int) -> Optional[int]:
        """How many points isometry i fixes; None for the identity, and for those that reverse the orientation: they may fix curves."""
        return self._core.fixed_points(self._number(i))

    def fixed_point_list(self, i: int) -> List[Point]:
        """The points that isometry i fixes, which is not the identity and preserves the orientation, rounded to multiples of 2⁻¹⁰⁰: the
        Weierstrass points, if it is a hyperelliptic involution. NetError unless they are as many as ``fixed_points`` says.

        >>> import epsnet
        >>> group = epsnet.Surface.octagon(1).isometries()
        >>> len(group.fixed_point_list(1)) == group.fixed_points(1) == 6
        True
        """
        expected = self.fixed_points(i)
        if expected is None:
            refuse("an isometry other than the identity that preserves the orientation", i, "i")
        words = [generator.word for generator in self.surface.fundamental_polygon().generators()]
        found = _epsnet.fixed_points(self.surface._core, words, self[i].words)
        if len(found) != expected:
            raise NetError(f"isometry {i} fixes {expected} points, but {len(found)} are found with 1024 bits")
        return [point_of(point) for point in found]

    def permutation(self, i: int) -> List[int]:
        """Isometry i as a permutation of the numbers of isometries, by product from the left: for SymPy or GAP.

        >>> import epsnet
        >>> group = epsnet.Surface.octagon(1).isometries()
        >>> [group.permutation(i) for i in range(len(group))]
        [[0, 1], [1, 0]]
        """
        return list(self._core.permutation(self._number(i)))

    def __eq__(self, other: object) -> bool:
        """Whether these are the isometries of equal surfaces."""
        return isinstance(other, IsometryGroup) and self.surface == other.surface

    def __hash__(self) -> int:
        return hash(self.surface)

    def __reduce__(self) -> Tuple[Any, ...]:
        # The surface says it all; the group is computed anew.
        return isometries, (self.surface, self._threads, False)

    def __repr__(self) -> str:
        name = f" {self.name}" if self.name else ""
        return f"<IsometryGroup{name} of order {len(self)}>"


def isometries(surface: "Surface", threads: int, progress: Progress) -> IsometryGroup:
    threads = as_threads(threads)
    with Shower(progress) as callback:
        return IsometryGroup(surface, _epsnet.IsometryGroup(surface._core, threads, callback), threads)


def compare(
    surface: "Surface", other: "Surface", threads: int, progress: Progress
) -> Tuple[Optional[SurfaceIsometry], Optional[Comparison]]:
    """An isometry, if there is one, and the proof, unless the numbers are too large for the checker."""
    if not isinstance(other, type(surface)):
        refuse("a surface", other, "other")
    threads = as_threads(threads)
    with Shower(progress) as callback:
        decided, found, reason, proof = _epsnet.isometric(surface._core, other._core, threads, callback)
    if not decided:
        raise UndecidedError(reason)
    isometry = None if found is None else SurfaceIsometry(surface, other, found)
    return isometry, None if proof is None else Comparison(proof[0], surface, Certificate(proof[1]), other, isometry)


def comparison(surface: "Surface", other: "Surface", threads: int, progress: Progress) -> Comparison:
    proof = compare(surface, other, threads, progress)[1]
    if proof is None:
        raise UndecidedError("the exact numbers are too large for the checker")
    return proof


def identify(surface: "Surface", threads: int, progress: Progress) -> list[str]:
    threads = as_threads(threads)
    with Shower(progress) as callback:
        names, undecided = _epsnet.identify(surface._core, threads, callback)
    if not names and undecided:
        raise UndecidedError("whether it is " + ", ".join(undecided))
    return names
