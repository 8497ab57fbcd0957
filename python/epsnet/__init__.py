"""ε-nets of closed hyperbolic surfaces, closed geodesics, distances. Numbers are intervals, which say whether they are proved.

An ε-net is a finite set of points such that every point of the surface is within hyperbolic distance ε of one of them, and no two are closer
than ε. What is computed is checked by an independent checker in ball arithmetic before you see it.

>>> import epsnet
>>> surface = epsnet.Surface.octagon(seed=123)          # A random surface of genus 2, exact.
>>> net = surface.net("0.25")
>>> net.certificate.verdict, len(net)
('VERIFIED', 143)
>>> surface.systole()
<Systole [0.5476464113685658, 0.5476464113685661]>

In a notebook a net, a closed geodesic, a domain shows itself as a picture, and ``net.view()`` is a page to travel in.

Surface         octagon, fenchel_nielsen, regular, named, map, load: surfaces; and what they are asked for
Net             vertices, edges, triangles, lifts as arrays of NumPy; certificate; pictures; files
ClosedGeodesics systole, spectrum, thick-thin decomposition, local maximum of the systole, each with its proof
Eigenvalues     of the Laplacian: the first ones in intervals, proved, with eigenfunctions
Distance        and Diameter, Radius, EmbeddedDisk, Eccentricity: numbers as intervals, with their proofs
Interval        lower and upper ends, and whether it is proved; arithmetic and comparisons
PantsDecomposition  Fenchel–Nielsen coordinates of any surface, with their proof
ClosedCurves    how closed curves meet, their classes in homology, whether they fill, with their proof; Curve: one, from its word
MappingClass    a product of Dehn twists: its order, what it does to curves and to homology
LengthDerivatives  of a closed geodesic, with respect to Fenchel–Nielsen coordinates; SystoleMaximum: the greatest systole near a surface
IsometryGroup   the symmetries of a surface, with their proof
Isometry        an element of the group: exact, or in SU(1,1) and SL(2,R) in intervals
load, certify   files, and what the checker says of them
FundamentalGroup  generators, relations, letters
map             a function of many surfaces, on all cores, as a structured array; table: its columns as floats, for pandas
EpsnetError     the exceptions
"""
try:
    from . import _epsnet
except ImportError as error:
    import pathlib
    import sys

    raise ImportError(
        f"epsnet's compiled module _epsnet cannot be imported by {sys.executable} (Python {sys.version_info[0]}.{sys.version_info[1]}): {error}. "
        f"{pathlib.Path(__file__).parent} is only its Python part, unless it was built for this Python: ./run python builds the module and starts "
        "Python with it; pip install . installs it (docs/using-from-python.md)", name="epsnet._epsnet") from None

from . import errors
from .certificates import Certificate, Rule
from .curves import ClosedCurve, ClosedCurves, Curve
from .distances import Cover, Diameter, Distance, Eccentricity, EmbeddedDisk, PointLoop, Radius
from .domains import DirichletDomain, DirichletSide, FundamentalPolygon, PolygonSide
from .eigenvalues import Bands, Eigenfunction, EigenvalueEnclosure, Eigenvalues
from .errors import ArgumentError, EpsnetError, FileError, FormatError, LimitError, NetError, NotVerifiedError, SurfaceError, UndecidedError
from .files import certify, load
from .geodesics import ClosedGeodesic, ClosedGeodesics, LocalMaximum, Multiplicities, Multiplicity, Piece, Systole, ThickThin
from .graphs import Lattice, SurfaceGraph
from .groups import FundamentalGroup
from .intervals import Interval, ends, mids
from .isometries import Axis, ComplexInterval, Gaussian, Isometry
from .lengths import LengthDerivatives, SystoleMaximum
from .many import map as map, table  # Not in __all__, where it would hide Python's own.
from .mapping_classes import MappingClass
from .nets import Collar, DistanceTable, Lifts, Location, Net, Page
from .pants import Cuff, PantsDecomposition
from .points import Point
from .surfaces import Surface
from .symmetries import Comparison, IsometryGroup, IsometryProof, SurfaceIsometry

__version__: str = _epsnet.__version__

__all__ = [
    "ArgumentError", "Axis", "Bands", "Certificate", "ClosedCurve", "ClosedCurves", "ClosedGeodesic", "ClosedGeodesics", "Collar", "Comparison", "ComplexInterval", "Cover", "Cuff", "Curve", "Diameter",
    "DirichletDomain", "DirichletSide", "Distance", "DistanceTable", "Eccentricity", "Eigenfunction", "EigenvalueEnclosure", "Eigenvalues", "EmbeddedDisk", "EpsnetError", "FileError", "FormatError",
    "FundamentalGroup", "FundamentalPolygon", "Gaussian", "Interval", "Isometry", "IsometryGroup", "IsometryProof", "Lattice", "LengthDerivatives", "Lifts", "LimitError", "LocalMaximum", "Location", "MappingClass", "Multiplicities", "Multiplicity", "Net",
    "NetError", "NotVerifiedError", "Page", "PantsDecomposition", "Piece", "Point", "PointLoop", "PolygonSide", "Radius", "Rule", "Surface", "SurfaceError", "SurfaceGraph", "SurfaceIsometry", "Systole", "SystoleMaximum",
    "ThickThin", "UndecidedError", "certify", "ends", "errors", "load", "mids", "table",
]
