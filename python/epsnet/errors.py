"""The exceptions of epsnet: one family. Each names the place and the reason of the error."""
from __future__ import annotations

import re
from typing import Any, Optional

from ._annotations import Certificate

__all__ = [
    "ArgumentError", "EpsnetError", "FileError", "FormatError", "LimitError", "NetError", "NotVerifiedError", "SurfaceError", "UndecidedError",
]

_FILE = re.compile(r'("(?:[^"\\]|\\.)*"|standard input|[^:"]+(?=:\d+: )): ?', re.S)
_PATH = re.compile(r"(.+?): ", re.S)  # As files that cannot be written are called.
_PLACE = re.compile(r"([A-Za-z_ ]+(?:\.[a-z_]+|\[\d+\])*): ")  # As surface.gluing[0] and triangles[3].label.
_LINE = re.compile(r"(\d+): ")


class EpsnetError(Exception):
    """Something cannot be done; ``str(error)`` is one line that says what was wrong, and what was expected.

    All exceptions of epsnet are of this class, so that ``except epsnet.EpsnetError`` catches each of them.

    >>> import epsnet
    >>> try:
    ...     epsnet.Surface.regular(1)
    ... except epsnet.EpsnetError as error:
    ...     print(error.reason)
    the genus of a regular 4g-gon must be at least 2 and at most 1000, not 1
    """

    #: The file that is to blame, as the message calls it; None if there is none.
    file: Optional[str]
    #: The part of the file or of the arguments that is to blame: a member and row, a line, the name of an argument, a rule.
    place: Optional[str]
    #: What is wrong with it.
    reason: str

    def __init__(self, message: str, *, place: Optional[str] = None) -> None:
        super().__init__(message if place is None else f"{place}: {message}")
        self.file = None
        self.place = place
        self.reason = message
        found = _FILE.match(message) or (_PATH.match(message) if isinstance(self, FileError) else None)
        if place is not None or not found:
            return
        self.file = found.group(1).strip('"')
        self.reason = message[found.end():]
        inside = _LINE.match(self.reason) or (_PLACE.match(self.reason) if isinstance(self, FormatError) else None)
        if inside:
            self.place = inside.group(1)
            self.reason = self.reason[inside.end():]


class ArgumentError(EpsnetError, ValueError):
    """An invalid argument, such as a negative length or a width that is too small."""


class SurfaceError(EpsnetError, ValueError):
    """The data is not a closed hyperbolic surface, or a point or a path is not on this surface."""


class FormatError(EpsnetError, ValueError):
    """A text violates its format; ``file`` and ``place`` locate the error."""


class FileError(EpsnetError, OSError):
    """A file cannot be read or written."""

    def __str__(self) -> str:
        return str(self.args[0])


class NetError(EpsnetError):
    """No net, closed geodesic or distance was found that could be proved. The arguments are valid."""


class LimitError(EpsnetError):
    """The surface is beyond the numbers that the generator computes with."""


class UndecidedError(EpsnetError, ArithmeticError):
    """Intervals overlap, so that they do not decide a comparison; or a divisor may be 0."""


class NotVerifiedError(EpsnetError):
    """The checker did not say VERIFIED, so there is no result. ``certificate`` is the checker's result."""

    def __init__(self, message: str, certificate: "Certificate") -> None:
        super().__init__(message)
        self.certificate = certificate
        self.place = certificate.rule or None
        self.reason = certificate.message

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.args[0], self.certificate)
