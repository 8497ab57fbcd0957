"""Arguments: numbers of every kind, and errors that name the argument that is wrong."""
import decimal
import inspect
import math
import numbers
from fractions import Fraction

import numpy as np
import pytest

import epsnet
from epsnet import Gaussian, Interval, Net, Surface


def numbers_that_are_a_tenth():
    mpmath = pytest.importorskip("mpmath")
    sympy = pytest.importorskip("sympy")

    class Tenth(numbers.Rational):
        """A rational number of somebody else."""
        numerator, denominator = 1, 10

        def _no(self, *others):
            raise NotImplementedError

        __abs__ = __add__ = __ceil__ = __eq__ = __floor__ = __floordiv__ = __le__ = __lt__ = __mod__ = __mul__ = __neg__ = __pos__ = __pow__ = _no
        __radd__ = __rfloordiv__ = __rmod__ = __rmul__ = __round__ = __rpow__ = __rtruediv__ = __truediv__ = __trunc__ = _no
        __hash__ = object.__hash__

    with mpmath.workprec(60):
        binary = mpmath.mpf(3) / 32
    return [
        *((Fraction(1, 10), x) for x in ("0.1", "1/10", 0.1, np.float64(0.1), np.float32(0.1), np.float16(0.1), np.longdouble("0.1"),
                                         decimal.Decimal("0.1"), sympy.Rational(1, 10), Tenth(), Fraction(1, 10))),
        (Fraction(3, 32), binary), (Fraction(3, 32), sympy.Float(0.09375)), (Fraction(3), np.int8(3)), (Fraction(3), sympy.Integer(3)),
    ]


def test_numbers_of_every_kind(octagon):
    for value, x in numbers_that_are_a_tenth():
        assert octagon.point(0, x, 0).x == value, repr(x)
        assert Surface.fenchel_nielsen(1, x, "0-1 0-1 0-1") == Surface.fenchel_nielsen(1, value, "0-1 0-1 0-1"), repr(x)
        if value < 1:
            assert Fraction(octagon.net(x + 1 if isinstance(x, float) else str(value + 1)).epsilon) == value + 1
    for x in (np.float32(0.75), np.float64(0.75), Fraction(3, 4), decimal.Decimal("0.75")):
        assert Fraction(octagon.net(x).epsilon) == Fraction(3, 4)
    # An mpf is exact, as a Fraction is; a float is a decimal.
    mpmath = pytest.importorskip("mpmath")
    assert octagon.point(0, mpmath.mpf(0.1), 0).x == Fraction(0.1) != octagon.point(0, 0.1, 0).x


def test_what_is_no_number_is_refused(octagon):
    mpmath = pytest.importorskip("mpmath")
    for x in (True, np.bool_(True), "1/0", "1e999999999", "0" * 2 * 10**6, None, 1j, math.nan, math.inf, np.float32("inf"), mpmath.inf, mpmath.nan,
              mpmath.ldexp(1, 10**8), b"1", object(), [1]):
        with pytest.raises(epsnet.ArgumentError) as caught:
            octagon.point(0, 0, x)
        assert caught.value.place == "y" and len(str(caught.value)) < 400


class Nonsense:
    """It is not a number, not a text, not a path, nothing that can be called or iterated over."""

    def __repr__(self):
        return "<nonsense>"


# Every function that users call, with arguments that are right.
@pytest.fixture(scope="module")
def calls(octagon, net, bolza):
    spectrum, distance, polygon = octagon.spectrum(2), octagon.distance((0, 0.1, 0), 0), octagon.dirichlet_domain((0, 0, 0))
    group, matrices, pants = octagon.isometries(), bolza.matrices(), octagon.pants()
    curve = pants.cuffs[0].word
    simple, curves = octagon.curve(curve), octagon.curves([curve])
    words = octagon.fundamental_group()
    heptagons = Surface.fenchel_nielsen(2, 0, "theta")
    bands = octagon.bands([(0, 0, 0, 0)], count=1, digits=1)
    x, element, table, eigenvalues = Interval(1, 2), octagon.element([0]), net.distances(0), octagon.eigenvalues(1, digits=4)
    return [
        (Surface, dict(tiles=octagon.tiles, gluing=octagon.gluing)),
        (Surface.octagon, dict(seed=1)), (Surface.octagon, dict(half=octagon.tiles[0][:4])), (Surface.regular, dict(genus=2)),
        (Surface.named, dict(name="wiman", genus=7)), (Surface.map, dict(rotation=[(k + 1) % 8 for k in range(8)], edges=[(k + 4) % 8 for k in range(8)])),
        (octagon.cover, dict(permutations=[(1, 0), (0, 1), (0, 1), (0, 1)])), (octagon.cover, dict(degree=2, seed=1)),
        (octagon.random_sheets, dict(degree=2, seed=1)),
        (Surface.fenchel_nielsen, dict(lengths=1, twists=0, graph="chain", genus=2, seed=1)),
        (Surface.from_matrices, dict(generators=matrices["generators"], relation=matrices["relation"], model="sl2r", tiles=matrices["tiles"])),
        (Surface.from_matrices, dict(generators=[((2, 0), (1, 0))], algebra=(13, 2))), (octagon.matrices, dict(model="su11")),
        (octagon.pants, dict(curves=[curve], find=False, threads=1, progress=False)), (octagon.pants, dict(marking=pants)),
        (heptagons.gradient, dict(word=[6], second=False, threads=1)), (octagon.maximize_systole, dict(steps=1, threads=1, progress=False)),
        (octagon.mapping_class, dict(product="a1")),
        (pants.fenchel_nielsen, dict(twists=0)), (pants.svg, dict(size=100)),
        (octagon.dehn_twist, dict(curve=curve, power=1)), (octagon.dehn_twist_words, dict(curve=curve, power=1)),
        (octagon.twist, dict(curve=curve, by=1)),
        (octagon.curve, dict(word=curve)), (octagon.curves, dict(words=[curve], threads=1, progress=False)), (octagon.fills, dict(curves=[curve])),
        (simple.intersections, dict(other=curve)), (simple.algebraic_intersections, dict(other=curve)), (simple.homotopic_to, dict(other=curve)),
        (simple.angles, dict(other=curve)), (simple.twist_derivative, dict(along=curve)),
        (curves.intersections, dict(i=0, j=1)), (curves.algebraic_intersections, dict(i=0, j=1)), (curves.save, dict(path="none")),
        (Surface.load, dict(path="none")), (octagon.save, dict(path="none")), (octagon.export, dict(format="domain", path="none")),
        (octagon.partner, dict(side=0)), (octagon.point, dict(tile=0, x=0, y=0)), (octagon.centre, dict(tile=0)),
        (octagon.element, dict(word=[0])), (octagon.dirichlet_domain, dict(p=0)), (octagon.reduced, dict(word=[0])),
        (octagon.net, dict(epsilon=1, base=0, points=[], pseudo=False, sparse=False, threads=1, progress=False)),
        (octagon.systole, dict(threads=1, progress=False)), (octagon.spectrum, dict(up_to=2, threads=1, progress=False)),
        (octagon.eigenvalues, dict(count=1, digits=2, epsilon="0.5", threads=1, progress=False)), (octagon.eigenvalues, dict(below=1)),
        (octagon.eigenvalues, dict(phases=(0, 0, 0, 0), count=1, digits=1, box="0.01")),
        (octagon.gap, dict(outside="1/3", at_least=1e-6, most=10**8, epsilon=1, threads=2, progress=False)), (octagon.side_phases, dict(phases=(0, 0, 0, 0))),
        (octagon.lattice, dict(phases=(0, 0, 0, 0), nodes="faces")), (octagon.lattice().save, dict(path="none")),
        (bolza.local_maximum, dict(threads=1, progress=False)),
        (octagon.bands, dict(path=[(0, 0, 0, 0)], steps=1, count=1, digits=1, epsilon="0.6", threads=1, progress=False)),
        (bands.interval, dict(point=0, band=0)), (bands.svg, dict(size=100)),
        (eigenvalues.svg, dict(size=100)), (eigenvalues.count_below, dict(x=1)), (eigenvalues.eigenfunction, dict(index=1)),
        (eigenvalues.eigenfunction(1).svg, dict(centre=0, order="weight", size=100)),
        (octagon.isometries, dict(threads=1, progress=False)), (octagon.isometric_to, dict(other=bolza, threads=1, progress=False)),
        (octagon.compare, dict(other=bolza, threads=1, progress=False)), (octagon.identify, dict(threads=1, progress=False)),
        (group.product, dict(i=0, j=1)), (group.order, dict(i=0)), (group.fixed_points, dict(i=0)), (group.permutation, dict(i=0)),
        (group.save, dict(path="none")), (group.proof.save, dict(path="none")),
        (octagon.thick_thin, dict(threads=1, progress=False)), (octagon.distance, dict(p=0, q=(0, 0.1, 0), width=1)),
        (octagon.diameter, dict(width=1, threads=1, progress=False)), (octagon.radius, dict(width=1, threads=1, progress=False)),
        (octagon.embedded_disk, dict(width=1, threads=1, progress=False)), (octagon.eccentricity, dict(p=0)),
        (Net.of_tiles, dict(surface=octagon, epsilon=1)), (Net.load, dict(path="none", check=True, progress=False)), (net.save, dict(path="none")),
        (net.lifts, dict(centre=0, order="weight")), (net.point, dict(vertex=0)), (net.point_of_triangle, dict(triangle=0, weights=(1, 1, 1))),
        (net.locate, dict(p=0)), (net.distances, dict(rows=0, columns=[0], threads=1, progress=False)), (table.__getitem__, dict(place=(0, 0))),
        (net.svg, dict(centre=0, triangles=True, vertices=True, dirichlet=False, combinatorial_dirichlet=False, tiles=False, disks=False,
                       half_disks=False, colour="none", legend=False, order="weight", size=100, show=[])),
        (net.view, dict(title="", show=[], height=100)), (net.export, dict(format="vtu", path="none", distance_from=0)),
        (net.view().save, dict(path="none")),
        (spectrum.save, dict(path="none")), (spectrum.svg, dict(size=100)), (spectrum[0].svg, dict(size=100)),
        (octagon.systole().svg, dict(size=100)), (octagon.systole().save, dict(path="none")),
        (distance.svg, dict(size=100)), (distance.save, dict(path="none")), (polygon.svg, dict(size=100)),
        (octagon.svg, dict(size=100)), (octagon.fundamental_polygon().svg, dict(size=100)),
        (octagon.eccentricity(0).svg, dict(size=100)), (octagon.diameter("0.1").svg, dict(size=100)), (polygon.save, dict(path="none")),
        (element.enclosure, dict(bits=2)), (element.su11, dict(bits=2, kind="interval")), (element.sl2r, dict(bits=2, kind="interval")),
        (element.matrix, dict(model="disk")), (element.trace, dict(bits=2)), (element.axis, dict(bits=2)), (element.__pow__, dict(exponent=2)),
        (element, dict(z=0j)),
        (Interval, dict(lower=1, upper=2, proved=True)), (x.overlaps, dict(other=x)), (x.rounded, dict(bits=2)), (x.sqrt, dict(bits=2)),
        (x.__pow__, dict(exponent=2)), (x.flint, dict(bits=2)), (Interval.maximum, dict(intervals=[x])), (Interval.minimum, dict(intervals=[x])),
        (epsnet.ends, dict(intervals=[x])), (epsnet.mids, dict(intervals=[x])), (Gaussian, dict(re=1, im=1)), (epsnet.ComplexInterval, dict(re=x, im=x)),
        (epsnet.load, dict(path="none", check=True, progress=False)), (epsnet.certify, dict(path="none", threads=1, progress=False)),
        (epsnet.map, dict(function=len, surfaces=[], workers=1, on_error="raise", progress=False)), (epsnet.table, dict(found=np.zeros(1, dtype=[("x", float)]))),
        (words.letters, dict(word=[0])), (octagon.random_points, dict(n=1, seed=1)), (octagon.exponential, dict(p=0, direction=0, length=1)),
        (octagon.loops_at, dict(p=0, up_to=2)), (octagon.injectivity_radius, dict(p=0)), (group.fixed_point_list, dict(i=1)), (words.text, dict(word=element)), (words.element, dict(letters="aB")),
    ]


def name_of(function):
    return getattr(function, "__qualname__", type(function).__name__)


def test_every_wrong_argument_is_named(calls, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    problems = []
    for function, right in calls:
        for name in right:
            # A text is right for the name of a file, a title, a relation, letters and words, and no other number is.
            texts = ("path", "title", "relation", "letters", "word", "curve", "other", "along", "closed_curve")
            for wrong in [Nonsense()] + ([10**30] if name in texts else ["abc"]):
                try:
                    function(**{**right, name: wrong})
                    outcome = "returned"
                except Exception as error:
                    if isinstance(error, epsnet.EpsnetError) and error.place == name:
                        continue
                    outcome = f"{type(error).__name__}: {error}"
                problems.append(f"{name_of(function)}({name}={wrong!r}): {outcome}")
    assert not problems, "\n".join(problems)


def test_the_list_of_calls_is_complete(calls):
    tested = {(name_of(function), name) for function, right in calls for name in right}
    tested |= {(name.replace("Net.", "Document.").replace("ClosedGeodesics.", "Document."), parameter) for name, parameter in tested}
    missing = []
    for thing in [getattr(epsnet, name) for name in epsnet.__all__] + [epsnet.map]:
        if not inspect.isclass(thing):
            functions = [thing] if callable(thing) else []
        elif issubclass(thing, (Exception, tuple)) or thing in (epsnet.Cover, epsnet.Diameter, epsnet.Radius, epsnet.EmbeddedDisk, epsnet.Distance):
            continue
        else:
            functions = [getattr(thing, name) for name in vars(thing) if not name.startswith("_") and callable(getattr(thing, name))]
        for function in functions:
            for parameter in inspect.signature(function).parameters:
                if parameter not in ("self", "args", "kwargs") and (name_of(function), parameter) not in tested:
                    missing.append(f"{name_of(function)}({parameter})")
    assert not missing, missing


@pytest.mark.parametrize(
    "make, place",
    [
        (lambda s, n: s.net("abc"), "epsilon"), (lambda s, n: s.net(-1), "epsilon"), (lambda s, n: s.net(1, pseudo="yes"), "pseudo"),
        (lambda s, n: s.net(1, pseudo=1), "pseudo"), (lambda s, n: s.net(1, points=[(0, 0, 0)], sparse=True), "sparse"),
        (lambda s, n: s.net("0.3", points=[(0, 0, 0)], pseudo=True), "pseudo"),
        (lambda s, n: s.element([99]), "word"), (lambda s, n: s.element([-1]), "word"), (lambda s, n: s.element("01"), "word"),
        (lambda s, n: n.svg(colour="x"), "colour"), (lambda s, n: n.svg(show=[3]), "show"), (lambda s, n: n.svg(show=3), "show"),
        (lambda s, n: n.export("vtu", distance_from=10**6), "distance_from"), (lambda s, n: n.export("off", distance_from=0), "distance_from"),
        (lambda s, n: n.distances("v0"), "rows"), (lambda s, n: n.distances(0, [10**6]), "columns"), (lambda s, n: n.distances(True), "rows"),
        (lambda s, n: n.point_of_triangle(0, (1, 1)), "weights"), (lambda s, n: s.regular(1), "genus"), (lambda s, n: s.named("nobody"), "name"), (lambda s, n: s.named("wiman"), "name"), (lambda s, n: s.named("klein", 4), "name"),
        (lambda s, n: Surface.fenchel_nielsen(6 * [1], 6 * [0]), "graph"),
        (lambda s, n: s.distance(0, "v3"), "q"), (lambda s, n: s.distance((0, "one", 0), 0), "p"), (lambda s, n: s.centre(7), "tile"),
        (lambda s, n: s.spectrum("1/0"), "up_to"), (lambda s, n: s.eigenvalues(0), "count"), (lambda s, n: s.eigenvalues(below=10**5), "below"),
        (lambda s, n: s.eigenvalues(3, below=1), "below"), (lambda s, n: s.eigenvalues(digits=11), "digits"), (lambda s, n: s.eigenvalues(epsilon=-1), "epsilon"),
        (lambda s, n: s.diameter(0), "width"), (lambda s, n: s.save("s.epsn"), "path"),
        (lambda s, n: s.systole().save("s.epsn"), "path"), (lambda s, n: s.spectrum(1).save("s.epsn"), "path"),
        (lambda s, n: Surface([[1]], []), "tiles"), (lambda s, n: Surface(s.tiles, [(0, 0)]), "gluing"), (lambda s, n: s.octagon(half=[0]), "half"),
        (lambda s, n: Surface.fenchel_nielsen(1, 0, [(0, "1")]), "graph"), (lambda s, n: s.element([0]).sl2r(kind="float"), "kind"),
        (lambda s, n: Interval(1, 2) ** 0.5, "exponent"), (lambda s, n: s.octagon(), "seed"),
        (lambda s, n: s.fundamental_group().element("az"), "letters"), (lambda s, n: s.fundamental_group().element([0]), "letters"),
        (lambda s, n: s.fundamental_group().letters([99]), "word"),
    ],
)
def test_errors_name_the_argument(octagon, net, make, place):
    with pytest.raises(epsnet.EpsnetError) as caught:
        make(octagon, net)
    assert caught.value.place == place and str(caught.value).startswith(f"{place}: ") and caught.value.file is None
