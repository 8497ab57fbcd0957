"""Reading and checking the files of epsnet."""
from __future__ import annotations

from typing import Union

from . import _epsnet
from ._arguments import Path, as_flag, as_path, as_threads
from ._documents import certified, read
from ._progress import Progress, Shower
from .certificates import Certificate
from .curves import ClosedCurves
from .distances import Cover, Distance, cover_of
from .eigenvalues import Eigenvalues
from .geodesics import ClosedGeodesics, LocalMaximum, Systole, ThickThin, list_of
from .nets import Net
from .pants import PantsDecomposition
from .surfaces import Surface, loaded_name
from .symmetries import Comparison, IsometryProof

__all__ = ["certify", "load"]

Loaded = Union[Surface, Net, ClosedGeodesics, Systole, ThickThin, LocalMaximum, Distance, Cover, Eigenvalues, IsometryProof, PantsDecomposition, Comparison, ClosedCurves]


def load(path: Path, *, check: bool = True, progress: Progress = None) -> Loaded:
    """The contents of a file: a Surface, a Net, ClosedGeodesics (Systole, ThickThin, LocalMaximum), a Distance, a Diameter, a Radius or an EmbeddedDisk,
    Eigenvalues, an IsometryProof, a PantsDecomposition, a Comparison, or ClosedCurves.

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
    check, shower = as_flag(check, "check"), Shower(progress)
    name, core = read(path)
    if isinstance(core, _epsnet.Surface):
        return Surface._of(core, loaded_name(path))
    certificate = certified(core, name, shower) if check else None
    if isinstance(core, _epsnet.Net):
        return Net(core, None, certificate)
    if isinstance(core, _epsnet.Distance):
        return Distance(core, None, certificate)
    if isinstance(core, _epsnet.Cover):
        return cover_of(core, None, certificate)
    if isinstance(core, _epsnet.Eigenvalues):
        return Eigenvalues(core, None, certificate)
    if isinstance(core, _epsnet.IsometryProof):
        return IsometryProof(core, None, certificate)
    if isinstance(core, _epsnet.PantsDecomposition):
        return PantsDecomposition(core, None, certificate)
    if isinstance(core, _epsnet.Comparison):
        return Comparison(core, None, certificate)
    if isinstance(core, _epsnet.Curves):
        return ClosedCurves(core, None, certificate)
    if core.claim == "systole":
        return Systole(ClosedGeodesics(core, None, certificate))
    return list_of(core, None, certificate)


def certify(path: Path, *, threads: int = 0, progress: Progress = None) -> Certificate:
    """The certificate of a file of any kind: compare ``verdict``. Raises FormatError if the text is not a file of epsnet.

    >>> import epsnet, tempfile, os
    >>> path = os.path.join(tempfile.mkdtemp(), "net.json")
    >>> epsnet.Surface.octagon(seed=123).net("0.3").save(path)
    >>> epsnet.certify(path).verdict
    'VERIFIED'
    """
    file, threads, shower = as_path(path), as_threads(threads), Shower(progress)
    core = _epsnet.parse_claim(_epsnet.read(file), _epsnet.display_name(file))
    with shower as callback:
        return Certificate(core.check(threads, callback))
