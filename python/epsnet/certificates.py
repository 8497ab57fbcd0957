"""The results of the checker."""
from __future__ import annotations

import html
from typing import Any, NamedTuple, Optional, Union

from . import _epsnet
from .intervals import Interval

__all__ = ["Certificate", "Rule"]


class Rule(NamedTuple):
    """The result of one rule for a document."""

    name: str
    verdict: str
    text: str


class _Record(NamedTuple):
    """What a certificate says, for a pickle."""

    verdict: str
    claim: str
    rule: str
    message: str
    rules: list[tuple[str, str, str]]
    counts: dict[str, int]
    enclosures: dict[str, tuple[float, float]]
    ties: list[int]
    line: str


class Certificate:
    """The result of the checker, which shares no code with the generator of the net.

    >>> import epsnet
    >>> net = epsnet.Surface.octagon(seed=123).net("0.3")
    >>> certificate = net.certificate
    >>> certificate.verdict
    'VERIFIED'
    >>> certificate.claim
    'an epsilon-net'
    >>> certificate.counts["vertices"], certificate.counts["genus"]
    (94, 2)
    >>> certificate.enclosures["largest_circumradius"].upper <= 0.3
    True
    """

    def __init__(self, core: Union["_epsnet.Certificate", _Record]) -> None:
        self._core = core

    @property
    def verdict(self) -> str:
        """"VERIFIED", "REFUTED" (a rule is proved to fail), "UNDECIDED" (within the precision and the work allowed), or "MALFORMED"."""
        return self._core.verdict

    @property
    def verified(self) -> bool:
        """Whether the verdict is "VERIFIED"."""
        return self._core.verdict == "VERIFIED"

    @property
    def claim(self) -> str:
        """The statement that the verdict "VERIFIED" proves."""
        return self._core.claim

    @property
    def rule(self) -> str:
        """The rule that decided a verdict other than "VERIFIED"; else empty."""
        return self._core.rule

    @property
    def message(self) -> str:
        """The message of that rule."""
        return self._core.message

    @property
    def rules(self) -> list[Rule]:
        """The rules that were evaluated, in their order."""
        return [Rule(*rule) for rule in self._core.rules]

    @property
    def counts(self) -> dict[str, int]:
        """The sizes of the document, and the cost of the check."""
        return self._core.counts

    @property
    def enclosures(self) -> dict[str, Interval]:
        """Intervals that contain ``epsilon``, ``area``, ``largest_circumradius``, ``longest_edge``, and, where there are any,
        ``shortest_edge`` (between different vertices), ``shortest_loop``, ``shortest_core`` (of the collars of a pseudo net).

        They hold for the triangles of the document, and for the surface if the verdict is "VERIFIED"."""
        return {name: Interval(lower, upper, proved=self.verified) for name, (lower, upper) in self._core.enclosures.items()}

    @property
    def ties(self) -> list[int]:
        """The edges whose four corners are exactly cocircular, each by its smaller dart."""
        return self._core.ties

    def _record(self) -> _Record:
        return _Record(*(getattr(self._core, name) for name in _Record._fields))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Certificate) and self._record() == other._record()

    def __hash__(self) -> int:
        return hash(self._core.line)

    def __reduce__(self) -> tuple[Any, ...]:
        return Certificate, (self._record(),)

    def __str__(self) -> str:
        return self._core.line

    def __repr__(self) -> str:
        return f"<Certificate {self._core.line}>"

    def _repr_html_(self) -> str:
        colour = "#2f9468" if self.verified else "#d0402b"
        rows = "".join(f"<tr><td>{rule.name}</td><td>{rule.verdict}</td><td style='text-align:left'>{html.escape(rule.text)}</td></tr>" for rule in self.rules)
        return f"<b style='color:{colour}'>{html.escape(str(self))}</b><table>{rows}</table>"


class Proof:
    """A document and its certificate, which is computed on first use."""

    def __init__(self, document: Any, certificate: Optional[Certificate]) -> None:
        self.document = document
        self._certificate = certificate

    @property
    def certificate(self) -> Certificate:
        if self._certificate is None:
            self._certificate = Certificate(self.document.check())
        return self._certificate

    @property
    def proved(self) -> bool:
        """Whether the document was checked and verified."""
        return self._certificate is not None and self._certificate.verified
