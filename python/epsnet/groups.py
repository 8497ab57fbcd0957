"""The group of a surface, with letters."""
from __future__ import annotations

import string
from typing import Any, Iterable, Union

from ._annotations import Surface
from ._arguments import as_items, refuse
from ._immutable import Immutable
from .domains import FundamentalPolygon
from .isometries import Isometry

__all__ = ["FundamentalGroup"]

_LETTERS = string.ascii_lowercase


class FundamentalGroup(Immutable):
    """The fundamental group of a surface, by generators and relations. Immutable.

    The generators are ``surface.generators()``, called a, b, c, …, or 1, 2, 3, …; A and −1 are the inverse of a. Products are those of
    isometries: in ``ab`` the isometry b comes first.

    >>> import epsnet
    >>> surface = epsnet.Surface.octagon(1)
    >>> group = surface.fundamental_group()
    >>> [group.text(relation) for relation in group.relations]
    ['aBcDAbCd']
    >>> group.text(surface.systole().geodesic), group.text(surface.matrices()["words"][0])
    ('dC', 'a')
    >>> group.element("abAB") == group.generators[0] * group.generators[1] * group.element("AB")
    True
    """

    def __init__(self, surface: "Surface") -> None:
        polygon = FundamentalPolygon(surface)
        #: The surface.
        self.surface = surface
        #: The isometries a, b, c, …
        self.generators = tuple(polygon.generators())
        number: dict[int, int] = {}
        for k, side in enumerate(polygon.sides):
            if k < side.partner:
                letter = len(number) // 2 + 1
                number[k], number[side.partner] = letter, -letter
        #: Products that are 1, one for each vertex of the surface that is a corner of the fundamental polygon; they imply all others.
        self.relations = tuple(tuple(number[k] for k in relation) for relation in polygon.relations())
        # A path across a side enters the polygon through its partner, beyond which lies the image of the polygon under the isometry.
        self._letter = {surface.partner(side.side): number[k] for k, side in enumerate(polygon.sides)}

    def letters(self, word: Union[Isometry, Iterable[int], Any]) -> tuple[int, ...]:
        """An element as a product of generators: of an isometry, of a closed geodesic or another thing with a ``word``, or of a path as the numbers
        of the sides that it crosses. A path from another tile than tile 0 counts as if it came from there and went back within the polygon."""
        sides = as_items(getattr(word, "word", word), "word", "an isometry, a closed geodesic or the numbers of sides")
        result: list[int] = []
        for side in reversed(self.surface._checked_word(sides)):
            letter = self._letter.get(side)
            if letter is None:  # A side inside the polygon.
                continue
            if result and result[-1] == -letter:
                result.pop()
            else:
                result.append(letter)
        return tuple(result)

    def element(self, letters: Union[str, Iterable[int]]) -> Isometry:
        """The element of a product: ``"abAB"`` or ``[1, 2, -1, -2]``."""
        product = self.surface.element([])
        for letter in self._parsed(letters):
            generator = self.generators[abs(letter) - 1]
            product = product * (generator if letter > 0 else generator.inverse())
        return product

    def text(self, word: Any) -> str:
        """The same as ``letters``, as a text; also of letters themselves, a tuple of numbers. 1 is the empty text.

        Beyond 26 generators these are words such as ``x1 X27``.
        """
        letters = word if isinstance(word, tuple) and not hasattr(word, "word") else self.letters(word)
        if len(self.generators) <= len(_LETTERS):
            return "".join(_LETTERS[k - 1] if k > 0 else _LETTERS[-k - 1].upper() for k in self._parsed(letters))
        return " ".join(f"x{k}" if k > 0 else f"X{-k}" for k in self._parsed(letters))

    def _parsed(self, letters: Union[str, Iterable[int]]) -> list[int]:
        expected = f"a product of the generators 1 to {len(self.generators)}, such as \"abAB\" or [1, 2, -1, -2]"
        if isinstance(letters, str):
            tokens = letters.split() if len(self.generators) > len(_LETTERS) else list(letters.replace(" ", ""))
            numbers = [_number(token) for token in tokens]
        else:
            numbers = as_items(letters, "letters", expected)
        for k in numbers:
            if isinstance(k, bool) or not isinstance(k, int) or not 1 <= abs(k) <= len(self.generators):
                refuse(expected, letters, "letters")
        return numbers

    def __eq__(self, other: object) -> bool:
        return isinstance(other, FundamentalGroup) and self.surface == other.surface

    def __hash__(self) -> int:
        return hash(self.surface)

    def __reduce__(self) -> tuple[Any, ...]:
        return FundamentalGroup, (self.surface,)

    def __repr__(self) -> str:
        return f"<FundamentalGroup with {len(self.generators)} generators, {len(self.relations)} relation{'' if len(self.relations) == 1 else 's'}>"


def _number(token: str) -> int:
    """1 for "a" and "x1", −1 for "A" and "X1"; 0 for anything else."""
    sign = -1 if token.isupper() else 1
    if len(token) == 1:
        return sign * (_LETTERS.find(token.lower()) + 1)
    return sign * int(token[1:]) if token[:1] in "xX" and token[1:].isdecimal() else 0
