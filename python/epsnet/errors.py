"""The exceptions of epsnet: one family. Each names the place and the reason of the error."""
from __future__ import annotations

from typing import Any, Optional

from ._annotations import Certificate

__all__ = [
    "ArgumentError", "EpsnetError", "FileError", "FormatError", "LimitError", "NetError", "NotVerifiedError", "SurfaceError", "UndecidedError",
]


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
    #: What is wrong with it, and what was expected.
    reason: str
    #: What was expected, where the reason ends with it; otherwise None.
    expected: Optional[str]

    def __init__(
        self, reason: str, *, file: Optional[str] = None, place: Optional[str] = None, expected: Optional[str] = None, text: Optional[str] = None,
    ) -> None:
        super().__init__(text or ": ".join(part for part in (file, place, reason) if part))
        self.file = file and file.strip('"')
        self.place = place
        self.reason = reason
        self.expected = expected


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

    def __init__(self, text: str, certificate: "Certificate", file: Optional[str] = None) -> None:
        super().__init__(certificate.message, file=file, place=certificate.rule or None, text=text)
        self.certificate = certificate

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.args[0], self.certificate, self.file)
