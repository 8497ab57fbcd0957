"""How a surface was made, as a short text: its name."""
from __future__ import annotations

import numbers
from typing import Any, Iterable

_MOST = 100  # Characters of a name.


def call(function: str, *arguments: str) -> str:
    """The text of a call."""
    return _elided(f"{function}({', '.join(arguments)})", _MOST)


def keywords(**arguments: Any) -> list[str]:
    """The arguments that are not None, by name."""
    return [f"{name}={shown(x)}" for name, x in arguments.items() if x is not None]


def shown(x: Any) -> str:
    """An argument: a number, a text, or a sequence of such, of which the middle is left out if it is long."""
    if isinstance(x, (numbers.Integral, float)):
        return str(x)
    if isinstance(x, str) or not isinstance(x, Iterable):
        return repr(_elided(str(x), 40))
    items = [shown(item) for item in x]
    if len(items) > 6:
        items[3:-2] = ["…"]
    return f"({items[0]},)" if len(items) == 1 else f"({', '.join(items)})"


def _elided(text: str, most: int) -> str:
    if len(text) <= most:
        return text
    end = most // 2
    return f"{text[:most - 1 - end]}…{text[-end:]}"
