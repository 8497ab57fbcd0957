"""Reading and checking the files of epsnet."""
from __future__ import annotations

import os
import re
from typing import Optional, Union

from . import _epsnet
from ._progress import Progress, Shower
from .certificates import Certificate, required
from .distances import Cover, Diameter, Distance, EmbeddedDisk
from .geodesics import ClosedGeodesics, Systole, ThickThin
from .nets import Net
from .surfaces import Path, Surface

__all__ = ["certify", "load"]

Loaded = Union[Surface, Net, ClosedGeodesics, Systole, ThickThin, Distance, Cover]


def load(path: Path, *, check: bool = True, progress: Progress = None) -> Loaded:
    """The contents of a file: a Surface, a Net, ClosedGeodesics (Systole, ThickThin), a Distance, a Diameter or an EmbeddedDisk.

    The file is checked; NotVerifiedError, which has the certificate, unless it is verified. With ``check=False`` nothing is checked: then
    intervals say ``proved=False``, and ``certificate`` checks when it is asked for. FormatError and FileError say where, and what was expected.

    >>> import epsnet, tempfile, os
    >>> path = os.path.join(tempfile.mkdtemp(), "systole.json")
    >>> epsnet.Surface.regular(2).systole().save(path)
    >>> epsnet.load(path)
    <Systole [3.0571418389619959, 3.057141838961997]>
    >>> epsnet.load(path, check=False)
    <Systole [3.0571418389619959, 3.057141838961997] (not proved)>
    """
    name = _epsnet.display_name(os.fspath(path))
    text = _epsnet.read(os.fspath(path))
    if _format_of(text) in (None, "epsnet-surface"):
        return Surface._of(_parsed_surface(text, name))
    core = _epsnet.parse_claim(text, name)
    certificate = None
    if check:
        with Shower(progress) as callback:
            certificate = required(Certificate(core.check(0, False, callback)), name)
    if isinstance(core, _epsnet.Net):
        return Net(core, None, certificate, None)
    if isinstance(core, _epsnet.Distance):
        return Distance(core, None, certificate)
    if isinstance(core, _epsnet.Cover):
        return (Diameter if core.claim == "diameter" else EmbeddedDisk)(core, None, certificate)
    if core.claim == "systole":
        return Systole(ClosedGeodesics(core, None, certificate))
    return (ThickThin if core.claim == "thick-thin" else ClosedGeodesics)(core, None, certificate)


def certify(path: Path, *, threads: int = 0, progress: Progress = None) -> Certificate:
    """The certificate of a file of any kind: compare ``verdict``. Raises FormatError if the text is not a file of epsnet.

    >>> import epsnet, tempfile, os
    >>> path = os.path.join(tempfile.mkdtemp(), "net.json")
    >>> epsnet.Surface.octagon(seed=123).net("0.3").save(path)
    >>> epsnet.certify(path).verdict
    'VERIFIED'
    """
    name = _epsnet.display_name(os.fspath(path))
    core = _epsnet.parse_claim(_epsnet.read(os.fspath(path)), name)
    with Shower(progress) as callback:
        return Certificate(core.check(threads, False, callback))


def surface_of_file(path: Path) -> Surface:
    """The surface of a file of any kind."""
    name = _epsnet.display_name(os.fspath(path))
    text = _epsnet.read(os.fspath(path))
    if _format_of(text) in (None, "epsnet-surface"):
        return Surface._of(_parsed_surface(text, name))
    core = _epsnet.parse_claim(text, name)
    return Surface._of(core.surface if isinstance(core, _epsnet.Net) else core.net.surface)


def _format_of(text: bytes) -> Optional[str]:
    """The member "format" of a text; None if the text is not JSON. (Inside a string its quotation marks would be escaped.)"""
    if not text.lstrip()[:1] in (b"{", b"["):
        return None
    found = re.search(rb'"format"\s*:\s*"([^"\\]*)"', text)
    return found.group(1).decode(errors="replace") if found else ""


def _parsed_surface(text: bytes, name: str) -> "_epsnet.Surface":
    if _format_of(text) is None:
        return _epsnet.Surface.parse_exchange(text, name.strip('"'))
    return _epsnet.Surface.parse(text, name)
