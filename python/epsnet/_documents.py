"""What nets, lists of closed geodesics, distances and other claims have in common: each is the contents of a file that the checker can prove."""
from __future__ import annotations

import re
from typing import Any, ClassVar, Optional, Type, TypeVar, Union

from . import _epsnet
from ._annotations import Surface
from ._arguments import Path, as_path
from ._immutable import Immutable
from ._progress import Shower
from .certificates import Certificate, Proof
from .errors import ArgumentError, NotVerifiedError

Core = Union[
    "_epsnet.Net", "_epsnet.Geodesics", "_epsnet.Distance", "_epsnet.Cover", "_epsnet.Eigenvalues", "_epsnet.IsometryProof", "_epsnet.PantsDecomposition",
    "_epsnet.Comparison", "_epsnet.Curves",
]
Self = TypeVar("Self", bound="Document")


class Document(Immutable):
    """The contents of a file, its certificate, its surface. Immutable."""

    #: surfaces.py, which needs all the documents, puts Surface here.
    _surface_class: ClassVar[Type["Surface"]]
    _core: Any
    _surface: Optional["Surface"]
    _proof: Proof

    def _hold(self, core: Core, surface: Optional["Surface"], certificate: Optional[Certificate]) -> None:
        self._core = core
        self._surface = surface
        self._proof = Proof(core, certificate)

    @property
    def certificate(self) -> Certificate:
        """The result of the checker. What was computed or loaded has it already; after ``load(check=False)``, and after a pickle, it is
        computed on first use."""
        return self._proof.certificate

    @property
    def proved(self) -> bool:
        """Whether the checker has verified it."""
        return self._proof.proved

    @property
    def surface(self) -> "Surface":
        """The surface."""
        if self._surface is None:
            self._surface = self._surface_class._of(self._surface_core())
        return self._surface

    def _surface_core(self) -> "_epsnet.Surface":
        core: "_epsnet.Surface" = self._core.net.surface
        return core

    def save(self, path: Path) -> None:
        """Writes its file, completely or not at all: for ``epsnet.load``, and for the program ``certify``."""
        name = as_path(path)
        if name.endswith(".epsn"):
            raise ArgumentError("only nets have a compact form; expected another name, such as one that ends in .json", place="path")
        self._core.save(name)

    def __reduce__(self) -> tuple[Any, ...]:
        return unpickled, (type(self), self._core.text(), *self._more())

    def _more(self) -> tuple[Any, ...]:
        """What a pickle has besides the document: further arguments of the class."""
        return ()


def unpickled(kind: Type[Self], text: bytes, *more: Any) -> Self:
    """The document again. It is not proved: somebody may have changed the pickle."""
    return kind(_epsnet.parse_claim(text, "pickle"), None, None, *more)  # type: ignore[call-arg]


def read(path: Path) -> tuple[str, Union[Core, "_epsnet.Surface"]]:
    """The name of a file in messages, and its contents."""
    file = as_path(path)
    name = _epsnet.display_name(file)
    text = _epsnet.read(file)
    if text[:8] == _COMPACT:
        return name, _epsnet.parse_claim(text, name)
    form = _format_of(text)
    if form is None:
        return name, _epsnet.Surface.parse_exchange(text, name.strip('"'))
    if form == "epsnet-surface":
        return name, _epsnet.Surface.parse(text, name)
    return name, _epsnet.parse_claim(text, name)


_COMPACT = b"\x89EPSNET\n"


def _format_of(text: bytes) -> Optional[str]:
    """The member "format" of a text; None if the text is not JSON. (Inside a string its quotation marks would be escaped.)"""
    if not text.lstrip()[:1] in (b"{", b"["):
        return None
    found = re.search(rb'"format"\s*:\s*"([^"\\]*)"', text)
    return found.group(1).decode(errors="replace") if found else ""


def certified(core: Core, name: str, shower: Shower) -> Certificate:
    """The certificate of a file. Raises NotVerifiedError unless it is verified."""
    with shower as callback:
        certificate = Certificate(core.check(0, callback))
    if not certificate.verified:
        raise NotVerifiedError(f"{name}: not verified: {certificate}", certificate, name)
    return certificate
