"""Values that never change."""
from __future__ import annotations

from typing import TypeVar

Self = TypeVar("Self", bound="Immutable")


class Immutable:
    """Its copy is itself."""

    __slots__ = ()

    def __copy__(self: Self) -> Self:
        return self

    def __deepcopy__(self: Self, memo: object) -> Self:
        return self
