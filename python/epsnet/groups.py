"""The group of a surface, with letters."""
from __future__ import annotations

import string
from typing import Any, Iterable, Sequence, Union

from ._annotations import Surface
from ._arguments import as_indices, as_items
from ._immutable import Immutable
from .domains import FundamentalPolygon
from .errors import ArgumentError
from .isometries import Isometry

__all__ = ["FundamentalGroup"]

_LETTERS = string.ascii_lowercase


class FundamentalGroup(Immutable):
    """The fundamental group of a surface, by generators and relations. Immutable.

    The generators are ``surface.generators()``, called a, b, c, …, or 1, 2, 3, …; A and −1 are the inverse of a; beyond 26 of them a text has
    spaces, as ``x1 X27``. Products are those of isometries: in ``ab`` the isometry b comes first.

    Wherever a path or a closed curve is given by the sides that it crosses, a text in these letters stands for the path of that element, too, as
    in ``surface.curve("abAB")``. ``surface.matrices()`` has some of these generators: all of them, if there is one relation.

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

    def letters(self, word: Any) -> tuple[int, ...]:
        """An element as a product of generators: of an isometry, of a closed geodesic or another thing with a ``word``, or of a path as the numbers
        of the sides that it crosses. A path from another tile than tile 0 counts as if it came from there and went back within the polygon."""
        result: list[int] = []
        for side in reversed(self.surface._checked_word(word)):
            letter = self._letter.get(side)
            if letter is None:  # A side inside the polygon.
                continue
            if result and result[-1] == -letter:
                result.pop()
            else:
                result.append(letter)
        return tuple(result)

    def element(self, letters: Union[str, Iterable[int]]) -> Isometry:
        """The element of a product: ``"abAB"`` or ``[1, 2, -1, -2]``. ArgumentError for a letter that is none."""
        return self._element(letters, "letters")

    def _element(self, letters: Union[str, Iterable[int]], name: str) -> Isometry:
        product = self.surface.element([])
        for letter in self._parsed(letters, name):
            generator = self.generators[abs(letter) - 1]
            product = product * (generator if letter > 0 else generator.inverse())
        return product

    def text(self, word: Any) -> str:
        """The same as ``letters``, as a text; also of letters themselves, a tuple of numbers. 1 is the empty text.

        Beyond 26 generators these are words such as ``x1 X27``.
        """
        letters = word if isinstance(word, tuple) and not hasattr(word, "word") else self.letters(word)
        if len(self.generators) <= len(_LETTERS):
            return "".join(_LETTERS[k - 1] if k > 0 else _LETTERS[-k - 1].upper() for k in self._parsed(letters, "word"))
        return " ".join(f"x{k}" if k > 0 else f"X{-k}" for k in self._parsed(letters, "word"))

    def _parsed(self, letters: Union[str, Iterable[int]], name: str) -> list[int]:
        """The numbers of the letters. ArgumentError names one that is wrong, its place, from 0, and those that there are."""
        count = len(self.generators)
        tokens: Sequence[Any]
        if not isinstance(letters, str):
            expected = f"an integer from 1 to {count}, or from -{count} to -1 for an inverse"
            tokens = numbers = as_items(letters, name, 'a text such as "abAB" or numbers such as [1, 2, -1, -2]')
        elif count <= len(_LETTERS):
            expected = f"a letter from a to {_LETTERS[count - 1]}, or from A to {_LETTERS[count - 1].upper()} for an inverse"
            tokens = letters.replace(" ", "")
            numbers = [_number(token) for token in tokens]
        else:
            expected = f"x1 to x{count}, or X1 to X{count} for an inverse, with spaces between them"
            tokens = letters.split()
            numbers = [_number(token) for token in tokens]
        for place, (token, k) in enumerate(zip(tokens, numbers)):
            if isinstance(k, bool) or not isinstance(k, int) or not 1 <= abs(k) <= count:
                raise ArgumentError(f"letter {place} of the word is {token!r}, expected {expected}", place=name, expected=expected)
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


def as_word(surface: "Surface", word: Any, name: str) -> list[int]:
    """The sides that a path or a closed curve crosses: of their numbers; of letters of the fundamental group; or of what has a word, as a closed
    geodesic, a cuff, an isometry or a curve."""
    if isinstance(word, str):
        return list(surface.fundamental_group()._element(word, name).word)
    return as_indices(getattr(word, "word", word), name)
