"""Closed curves: what their words say of them, and curves files."""
import itertools
import json
import math
import pickle

import numpy as np
import pytest

import epsnet
from epsnet import ArgumentError, ClosedCurve, ClosedCurves, Curve, FormatError, NotVerifiedError, Surface, SurfaceError


@pytest.fixture(scope="module")
def shortest(bolza):
    """The twelve shortest closed geodesics of the Bolza surface. Each passes through two of the six Weierstrass points, and four of them through
    each of these points. They meet nowhere else, so six pairs of them cross at each."""
    return bolza.spectrum("3.1")


@pytest.fixture(scope="module")
def document(bolza, shortest):
    return bolza.curves(shortest)


def test_the_systoles_of_the_bolza_surface(bolza, shortest):
    curves = [bolza.curve(geodesic) for geodesic in shortest]
    assert len(curves) == 12
    assert all(curve.simple and curve.power == 1 and curve.self_intersections == 0 and not curve.separating and curve.genera is None for curve in curves)
    numbers = [(a.intersections(b), a.algebraic_intersections(b), len(a.angles(b))) for a, b in itertools.combinations(curves, 2)]
    assert all(geometric in (0, 1) and abs(algebraic) == geometric == angles for geometric, algebraic, angles in numbers)
    assert sum(geometric for geometric, _, _ in numbers) == 36
    assert bolza.fills(curves) and bolza.fills(shortest) and not bolza.fills(shortest[:2]) and not bolza.fills([])


def test_their_document(bolza, shortest, document):
    assert isinstance(document, ClosedCurves) and document.proved and document.surface is bolza and document.net.surface == bolza
    assert [rule.name for rule in document.certificate.rules][-5:] == ["lengths", "powers", "intersections", "homology", "filling"]
    assert len(document) == 16 and document.basis == [12, 13, 14, 15] and document.filling == [tuple(range(12))]
    for row, geodesic in zip(document, shortest):
        assert row.simple and not row.separating and row.power == 1 and row.length.proved and row.length.overlaps(geodesic.length)
        assert row.homology == bolza.curve(geodesic).homology and bolza.curve(geodesic).homotopic_to(row)
    assert sum(document.intersections(i, j) for i, j in itertools.combinations(range(12), 2)) == 36
    for i, j in itertools.product(range(16), repeat=2):
        first, second = bolza.curve(document[i]), bolza.curve(document[j])
        assert document.intersections(i, j) == first.intersections(second)
        assert document.algebraic_intersections(i, j) == first.algebraic_intersections(second)
    assert [document.surface.curve(word).homology for word in bolza.homology_basis()] == [document[k].homology for k in document.basis]
    assert document[1:3] == [document[1], document[2]] and document[-1].number == 15 and repr(document).startswith("<ClosedCurves: 16, the basis")


def test_angles_through_the_centre_of_the_octagon(bolza):
    # Opposite sides' midpoints are joined by geodesics through the centre, at multiples of π/4.
    first = bolza.curve([0])
    for k in (1, 2, 3, 5, 6, 7):
        (angle,) = first.angles([k])
        expected = math.remainder(k * math.pi / 4, 2 * math.pi)
        assert abs(angle.mid - expected) < 1e-15 and angle.width < 1e-13 and not angle.proved
        assert first.algebraic_intersections([k]) == (1 if k < 4 else -1)
        # A length does not depend on the direction of its curve: side k + 4 is the way back.
        derivative = bolza.curve([k]).twist_derivative(first)
        assert abs(derivative.mid + math.cos(math.pi * (k % 4) / 4)) < 1e-15 and not derivative.proved


def test_the_homology_basis_is_symplectic(octagon, bolza, pants):
    for surface in (octagon, bolza, pants, Surface.named("klein")):
        basis = [surface.curve(word) for word in surface.homology_basis()]
        assert len(basis) == 2 * surface.genus
        for (i, a), (j, b) in itertools.product(enumerate(basis), repeat=2):
            assert a.algebraic_intersections(b) == ((j == i + 1) - (j == i - 1) if i // 2 == j // 2 else 0)
            assert a.homology[j] == (i == j)


def test_powers_inverses_and_conjugates(octagon, bolza):
    for surface in (octagon, bolza):
        for word in ([0], [0, 1], [0, 1, 4, 4, 1]):
            curve, cube = surface.curve(word), surface.curve(3 * word)
            inverse = surface.curve([surface.partner(side) for side in reversed(word)])
            assert cube.word == tuple(3 * word) and (cube.power, curve.power) == (3, 1) and cube.root_word == curve.root_word
            assert curve.homotopic_to(curve.root_word) and not cube.homotopic_to(curve)
            assert cube.self_intersections == 9 * curve.self_intersections + 2 and cube.homology == tuple(3 * x for x in curve.homology)
            assert curve.intersections(curve) == 2 * curve.self_intersections == len(curve.angles(inverse)) * 2
            assert not curve.homotopic_to(inverse) and inverse.homology == tuple(-x for x in curve.homology)
            conjugate = surface.curve([2, *word, surface.partner(2)])
            assert curve.homotopic_to(conjugate) and curve == conjugate and hash(curve) == hash(conjugate) and conjugate.word != curve.word
            rotated = word[1:] + word[:1]
            assert curve.homotopic_to(rotated)
            assert curve.algebraic_intersections([3]) == -surface.curve([3]).algebraic_intersections(curve)
    # The document counts a curve and its copy, too.
    figure_eight = octagon.curve([0, 0, 1])
    squares = octagon.curves([[0, 0, 1, 0, 0, 1, 0, 0, 1], [0, 0, 1]])
    for i, curve in enumerate([octagon.curve(row) for row in squares[:2]]):
        assert squares.intersections(i, i) == curve.intersections(curve) and squares.algebraic_intersections(i, i) == 0
    assert squares[0].power == 3 and squares.intersections(0, 1) == 6 * figure_eight.self_intersections and squares.filling == []


def test_a_curve_that_crosses_itself(octagon):
    curve = octagon.curve([0, 1, 4, 4, 1])
    assert curve.self_intersections > 0 and not curve.simple and not curve.separating and curve.genera is None
    row = octagon.curves([curve])[0]
    assert row.self_intersections == curve.self_intersections and "self-intersections" in repr(row)


def test_separating_curves_have_genera(pants):
    octagon = Surface.octagon(123)
    commutator = octagon.curve([0, 1, 4, 5])
    assert commutator.simple and commutator.separating and commutator.genera == (1, 1) and commutator.homology == (0, 0, 0, 0)
    rows = octagon.curves([commutator, 2 * commutator.word])
    assert rows[0].separating and "separating" in repr(rows[0])
    # Its square bounds as well, and is not simple.
    square = octagon.curve(rows[1])
    assert not any(square.homology) and not square.separating and square.genera is None
    assert not any(rows[1].homology) and not rows[1].separating and "power 2" in repr(rows[1])
    # Genus 3: what is on the left of the curve is on the right of its inverse.
    surface = Surface.fenchel_nielsen(2, "1/3", "0-0 0-1 1-2 2-3 2-3 1-3")
    cuff = surface.pants().cuffs[1]
    (p, _), (q, _) = cuff.ends
    curve = surface.curve(cuff)
    assert (p, q) == (0, 1) and curve.separating and curve.genera == (1, 2)
    assert surface.curve([surface.partner(side) for side in reversed(cuff.word)]).genera == (2, 1)
    assert not surface.curve(surface.pants().cuffs[0]).separating


def test_twist_derivatives_are_difference_quotients():
    lengths, step = [2, 3, 4], "1/1000000"
    surface = Surface.fenchel_nielsen(lengths, ["1/2", 0, 1], "theta")
    cuff = surface.pants().cuffs[0]
    moved = [Surface.fenchel_nielsen(lengths, [twist, 0, 1], "theta") for twist in ("0.499999", "0.500001")]
    geodesics = [g for g in surface.spectrum(6) if surface.curve(g).intersections(cuff)]
    assert len(geodesics) > 2
    for geodesic in geodesics:
        before, after = (other.element(geodesic.word).translation_length.mid for other in moved)
        derivative = surface.curve(geodesic).twist_derivative(cuff)
        assert abs((after - before) / 2e-6 - derivative.mid) < 1e-6
    assert surface.curve(cuff).twist_derivative(cuff).ends == (0, 0)


def test_null_homotopic_curves(octagon):
    trivial = octagon.curve([0, octagon.partner(0)])
    assert trivial.power == 1 and trivial.simple and not trivial.separating and trivial.genera is None and trivial.homology == (0,) * 4
    assert trivial.root_word == () and trivial.word == (0, octagon.partner(0)) and trivial.homotopic_to([]) and trivial == octagon.curve(())
    assert trivial.intersections([0]) == trivial.algebraic_intersections([0]) == 0 and trivial.angles([0]) == []
    assert trivial.twist_derivative([0]).ends == (0, 0) and not trivial.homotopic_to([0]) and not octagon.fills([trivial])
    assert repr(octagon.curve([])) == "<Curve of the empty word>" and repr(trivial) == "<Curve of the word 0 4>"
    with pytest.raises(ArgumentError, match="^curve 1: null-homotopic") as caught:
        octagon.curves([[0], trivial])
    assert caught.value.place == "curve 1"


def test_wrong_curves(octagon, bolza, document):
    with pytest.raises(SurfaceError, match="^word: letter 0 is side 99") as caught:
        octagon.curve([99])
    assert caught.value.place == "word"
    with pytest.raises(SurfaceError, match="^other: letter 1 is side 8"):
        octagon.curve([0]).intersections([0, 8])
    with pytest.raises(ArgumentError, match="^curve 1: letter 0 is side 99"):
        octagon.curves([[0], [99]])
    with pytest.raises(ArgumentError, match="^curve 1: letter 0 is side 99"):
        octagon.fills([[0], [99]])
    for along in ([], [0, 0], [0, 1, 4, 4, 1]):
        with pytest.raises(ArgumentError, match="^along: expected a simple closed curve"):
            octagon.curve([1]).twist_derivative(along)
    with pytest.raises(ArgumentError, match="^other: expected a curve of the same surface"):
        octagon.curve([1]).intersections(bolza.curve([1]))
    assert octagon.curve(bolza.curve([1])) == octagon.curve([1]) and bolza.curve([1]) != octagon.curve([1])
    for i, j in ((16, 0), (0, -1)):
        with pytest.raises(ArgumentError, match=f"^{'i' if i else 'j'}: expected an integer from 0 to 15"):
            document.intersections(i, j)


def test_files_and_pickles(bolza, document, tmp_path):
    path = tmp_path / "curves.json"
    document.save(path)
    assert epsnet.certify(path).verdict == "VERIFIED" and str(epsnet.certify(path)) == str(document.certificate)
    loaded = epsnet.load(path)
    assert isinstance(loaded, ClosedCurves) and loaded.proved and loaded == document and hash(loaded) == hash(document) and repr(loaded) == repr(document)
    assert loaded.surface == bolza == Surface.load(path) and list(loaded) == list(document) and loaded[3] != document[4] and loaded != bolza.curves([[0]])
    loose = epsnet.load(path, check=False)
    assert not loose.proved and not loose[0].length.proved and "not proved" in repr(loose) and "not proved" in repr(loose[0])
    assert loose.certificate.verified and loose.proved and loose[0].length.proved
    again, row, curve = pickle.loads(pickle.dumps((document, document[2], bolza.curve([0, 0]))))
    assert not again.proved and again == document and isinstance(row, ClosedCurve) and row == document[2]
    assert isinstance(curve, Curve) and curve == bolza.curve([0, 0]) and curve.word == (0, 0)
    with pytest.raises(ArgumentError, match="only nets have a compact form"):
        document.save(tmp_path / "curves.epsn")


def test_false_files(octagon, tmp_path):
    path = tmp_path / "curves.json"
    octagon.curves([[0], [1], [2], [3], [0, 0]]).save(path)
    text = json.loads(path.read_text())
    first, pair = text["curves"][0], text["pairs"][0]
    others = text["curves"][1:]
    for rule, changes in (
        ("lengths", {"curves": [{**first, "length": [x + 1 for x in first["length"]]}, *others]}),
        ("powers", {"curves": [{**first, "power": 2}, *others]}),
        ("intersections", {"pairs": [{**pair, "intersections": pair["intersections"] + 2}, *text["pairs"][1:]]}),
        ("homology", {"curves": [{**first, "homology": [7, 0, 0, 0]}, *others]}),
        ("filling", {"filling": [[0, 1]]}),
    ):
        path.write_text(json.dumps({**text, **changes}))
        certificate = epsnet.certify(path)
        assert (certificate.verdict, certificate.rule) == ("REFUTED", rule)
        with pytest.raises(NotVerifiedError, match=rule):
            epsnet.load(path)
    path.write_text(json.dumps({**text, "pairs": text["pairs"][1:]}))
    with pytest.raises(FormatError, match="pairs"):
        epsnet.load(path, check=False)


def test_mapping_classes(octagon):
    f, g = octagon.mapping_class("a1 b1^2"), octagon.mapping_class([(octagon.mapping_class_generators()["c1"], -1)])
    assert g == octagon.mapping_class("C1") and g != octagon.mapping_class("c1")
    assert (f * g).inverse() == g.inverse() * f.inverse() and f * f.inverse() == octagon.mapping_class()
    assert f ** -2 == (f * f).inverse() and (f ** 0).is_identity
    curve = octagon.curve([1, 2])
    assert (f * g)(curve) == f(g(curve)) and f(curve) != g(curve)
    assert np.array_equal(np.array((f * g).homology), np.array(f.homology) @ np.array(g.homology))
    assert np.array_equal(np.array(f.homology) @ curve.homology, f(curve).homology)
    assert pickle.loads(pickle.dumps(f)) == f and len({f, f * g * g.inverse()}) == 1
    assert f.order is None and f.isometry is None
    assert f.marking().isometric_to(octagon)
    with pytest.raises(epsnet.ArgumentError, match="at character 4 of \"a1 d1\": expected a name from a1 to c1"):
        octagon.mapping_class("a1 d1")
    with pytest.raises(epsnet.ArgumentError, match="curve 1: not simple|curve 1: power 2"):
        octagon.mapping_class([([0], 1), ([0, 0], 1)])(curve)


@pytest.mark.parametrize("surface, error", [(Surface.fenchel_nielsen(graph="0-0 0-1 1-1", seed=4), 1e-12), (Surface.octagon(5), 1e-9)])
def test_gradients(surface, error):
    curve = surface.spectrum(6)[7]
    found = surface.gradient(curve, second=True)
    assert curve.length.mid == pytest.approx(found.length.mid, abs=error)
    cuffs = surface.pants().cuffs
    assert [x.mid for x in found.by_twists] == pytest.approx([surface.curve(curve).twist_derivative(cuff).mid for cuff in cuffs], abs=error)
    assert len(found.by_lengths) == 3 and np.shape([[x.mid for x in row] for row in found.second]) == (6, 6)
    assert not surface.gradient(curve).second and not found.length.proved
    with pytest.raises(SurfaceError, match="null-homotopic"):
        surface.gradient([])
    with pytest.raises(SurfaceError, match="99"):
        surface.gradient([99])


def test_a_local_maximum_of_the_systole(octagon, bolza, tmp_path):
    maximum = bolza.local_maximum()
    assert repr(maximum) == "<LocalMaximum: 12 systoles>" and maximum.proved and maximum.systoles == list(maximum)
    maximum.save(tmp_path / "maximum.json")
    loaded = epsnet.load(tmp_path / "maximum.json")
    assert isinstance(loaded, epsnet.LocalMaximum) and loaded.up_to == maximum.up_to == "3.0573"
    with pytest.raises(epsnet.NetError, match="1 shortest closed geodesic, fewer than 6g - 5 = 7"):
        octagon.local_maximum()


def test_the_greatest_systole(octagon, bolza):
    found = octagon.maximize_systole()
    assert found.systole.mid == pytest.approx(bolza.systole().mid, abs=1e-12) and found.systole.proved
    assert len(found.systoles) == 12 and found.maximum_within < 1e-11 and found.slope > 0
    assert found.surface.systole().lower == found.systole.lower
    assert octagon.maximize_systole(steps=1).maximum_within is None
    with pytest.raises(ArgumentError, match="steps"):
        octagon.maximize_systole(steps=0)
