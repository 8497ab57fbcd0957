"""The group of a surface: generators, relations, matrices of every kind."""
import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import epsnet
from epsnet import Gaussian, Interval, Surface


def product(surface, relation, polygon):
    element = surface.element([])
    for k in relation:
        element = element * polygon.sides[k].isometry
    return element


def test_relations_hold_exactly(octagon, pants):
    for surface in (octagon, pants):
        polygon = surface.fundamental_polygon()
        assert len(polygon.relations()) >= 1
        for relation in polygon.relations():
            assert len(relation) >= 2 and product(surface, relation, polygon).is_identity()
            assert not product(surface, relation[1:], polygon).is_identity()


def test_side_pairings_take_sides_to_sides(octagon, pants):
    for surface in (octagon, pants):
        polygon = surface.fundamental_polygon()
        z = polygon.vertices
        n = len(z)
        for k, side in enumerate(polygon.sides):
            # γ⁻¹ takes side k to its partner, end to start.
            back = side.isometry.inverse()
            assert back(z[k]) == z[(side.partner + 1) % n] and back(z[(k + 1) % n]) == z[side.partner]
            assert polygon.sides[side.partner].partner == k


def test_the_euler_characteristic_of_the_polygon(octagon, pants, bolza):
    for surface in (octagon, pants, bolza):
        polygon = surface.fundamental_polygon()
        assert len(polygon.relations()) - len(polygon.sides) // 2 + 1 == 2 - 2 * surface.genus
        assert len(surface.generators()) == len(polygon.sides) // 2
        assert sorted(k for relation in polygon.relations() for k in relation) == list(range(len(polygon.sides)))


def test_one_tile_is_its_own_polygon(octagon):
    assert octagon.fundamental_polygon().vertices == octagon.tiles[0]


def times(m, n):
    return tuple(tuple(m[i][0] * n[0][j] + m[i][1] * n[1][j] for j in (0, 1)) for i in (0, 1))


def test_exact_matrices_multiply(pants):
    f, g = pants.generators()[:2]
    for kind in ("exact", "exact_real"):
        x, y, z = (getattr(h, kind)() for h in (f, g, f * g))
        xy = times(x, y)
        # Up to the common factor that is taken out.
        assert xy[0][0] * z[1][1] == z[0][0] * xy[1][1] and xy[0][1] * z[1][0] == z[0][1] * xy[1][0] and xy[0][0] * z[0][1] == z[0][0] * xy[0][1]
    assert f.determinant == f.exact_real()[0][0] * f.exact_real()[1][1] - f.exact_real()[0][1] * f.exact_real()[1][0]


@settings(max_examples=25)
@given(st.lists(st.integers(0, 7), max_size=12), st.integers(1, 300))
def test_enclosures_contain_the_exact_matrix(letters, bits):
    surface = Surface.octagon(seed=123)
    f = surface.element(letters)
    a, b = f.enclosure(bits)
    for exact, enclosed in ((f.a, a), (f.b, b)):
        for x, interval in ((exact.re, enclosed.re), (exact.im, enclosed.im)):
            # x/√D lies in the interval: x² and D·end² compare as x and √D·end do, signs minded.
            low, high = interval.ends
            square = lambda t: t * t if t > 0 else -t * t
            same, other = square(x), square(-x)
            inside = square(low) * f.determinant <= same <= square(high) * f.determinant
            assert inside or square(low) * f.determinant <= other <= square(high) * f.determinant
            assert high - low <= Fraction(2) ** -bits * (abs(a.re.ends[1]) + abs(a.im.ends[1]) + 1)


def test_determinants_of_enclosures(bolza, octagon):
    for surface in (bolza, octagon):
        for f in surface.generators():
            m = f.sl2r()
            mids = [[entry.mid for entry in row] for row in m]
            assert mids[0][0] * mids[1][1] - mids[0][1] * mids[1][0] == pytest.approx(1)
            assert all(entry.proved and entry.error < 1e-14 for row in m for entry in row)
            (a, b), (c, d) = f.su11()
            assert abs(a.mid) ** 2 - abs(b.mid) ** 2 == pytest.approx(1) and c.mid == b.mid.conjugate() and d.mid == a.mid.conjugate()


def test_bolza_is_algebraic(bolza):
    f = bolza.generators()[0]
    assert not f.is_exact
    with pytest.raises(epsnet.SurfaceError, match="not rational"):
        f.a
    a, b = f.enclosure(200)
    # cot(π/8) = 1 + √2, so that (a − 1)² = 2.
    low, high = a.re.ends
    assert (low - 1) ** 2 < 2 < (high - 1) ** 2 and high - low < Fraction(2) ** -190


def test_mpmath(octagon, bolza):
    mpmath = pytest.importorskip("mpmath")
    for surface in (octagon, bolza):
        f = surface.generators()[0]
        (a, b), (c, d) = f.su11(bits=200, kind="mpmath")
        mpmath.iv.prec = 400
        determinant = a * d - b * c
        assert 1 in determinant.real and 0 in determinant.imag and determinant.real.delta < mpmath.mpf(2) ** -150
        m = f.sl2r(200, "mpmath")
        assert 1 in m[0][0] * m[1][1] - m[0][1] * m[1][0]


def test_flint(octagon, bolza):
    flint = pytest.importorskip("flint")
    for surface in (octagon, bolza):
        f = surface.generators()[0]
        flint.ctx.prec = 300
        m = f.sl2r(bits=200, kind="flint")
        determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0]
        assert determinant.contains(1) and determinant.rad() < flint.arb(2) ** -150


def test_kinds(octagon):
    f = octagon.generators()[0]
    with pytest.raises(ValueError, match='"interval", "flint" or "mpmath"'):
        f.sl2r(kind="float")
    assert f.sl2r(100, "interval")[0][0].ends[0].denominator > 2**60


def test_words_that_are_none(octagon, pants):
    with pytest.raises(epsnet.SurfaceError, match="letter 1 of the word is side 8"):
        octagon.element([0, 8]).a
    with pytest.raises(epsnet.SurfaceError, match="letter 1 .* no side of tile"):
        pants.element([0, next(s for s in range(28) if s // 7 != pants.partner(0) // 7)]).a
    with pytest.raises(epsnet.ArgumentError, match="bits"):
        octagon.element([0]).enclosure(2**20 + 1)
    with pytest.raises(ValueError, match="different surfaces"):
        octagon.element([0]) * pants.element([])


def test_powers_and_equality(octagon, bolza, pants):
    for surface in (octagon, bolza, pants, Surface.named("bring")):
        f, g = next((f, g) for f in surface.generators() for g in surface.generators() if f * g != g * f)
        assert f**0 == surface.element([]) == f * f.inverse() and (f**0).is_identity() and not f.is_identity()
        assert f**3 == f * f * f and f**-2 == (f * f).inverse() and (f * g) ** 2 == f * g * f * g
        assert f != g and f * g != g * f and hash(f**3) == hash(f * f * f) and f != "f"
        # Different words of one element; their matrices may differ in the sign.
        polygon = surface.fundamental_polygon()
        for relation in polygon.relations():
            first, rest = product(surface, relation[:1], polygon), product(surface, relation[1:], polygon).inverse()
            assert first == rest and hash(first) == hash(rest) and product(surface, relation, polygon) == surface.element([])
        assert first.word != rest.word
    assert octagon.generators()[0] != bolza.generators()[0]


@settings(max_examples=25)
@given(st.lists(st.integers(0, 7), min_size=1, max_size=8), st.integers(0, 1))
def test_traces_lengths_axes(letters, which):
    surface = [Surface.octagon(seed=123), Surface.regular(2)][which]
    f = surface.element(surface.reduced(letters))
    if f.is_identity():
        assert f.translation_length == Interval(0, 0) and abs(f.trace()).overlaps(Interval(2, 2))
        with pytest.raises(epsnet.ArgumentError, match="no axis"):
            f.axis()
        return
    trace, length, axis = f.trace(), f.translation_length, f.axis(80)
    assert trace.proved and length.proved and length.width <= 4e-16 * length.upper
    if f.is_exact:
        # cosh l = 2 Re(a)²/D − 1 is rational. Bounds of its inverse function by Taylor's sum are exact fractions.
        c = 2 * f.a.re**2 / f.determinant - 1
        assert cosh_below(length.ends[0]) <= c <= cosh_above(length.ends[1])
        assert trace.ends[0] ** 2 * f.determinant <= 4 * f.a.re**2 <= trace.ends[1] ** 2 * f.determinant or (
            trace.ends[1] ** 2 * f.determinant <= 4 * f.a.re**2 <= trace.ends[0] ** 2 * f.determinant
        )
    assert 2 * math.cosh(length.mid / 2) == pytest.approx(abs(trace.mid))
    assert (f.inverse().translation_length, (f * f).translation_length.overlaps(2 * length)) == (length, True)
    for end in axis:
        assert 1 in end.re**2 + end.im**2 and end.re.width + end.im.width < 1e-23 and end.re.proved
    # They are fixed, and |b̄z + ā| is e^(l/2) where f contracts, e^(-l/2) where it expands; in units of what is lost by rounding.
    a, b = (part.mid for part in f.enclosure(64))
    for end, growth in ((axis.attracting, math.exp(length.mid / 2)), (axis.repelling, math.exp(-length.mid / 2))):
        z = end.mid
        assert abs(a * z + b - z * (b.conjugate() * z + a.conjugate())) < 1e-14 * abs(a)
        assert abs(b.conjugate() * z + a.conjugate()) == pytest.approx(growth, rel=1e-9, abs=1e-14 * abs(a))
    # The inverse swaps them.
    swapped = f.inverse().axis(80)
    for x, y in ((swapped.attracting, axis.repelling), (swapped.repelling, axis.attracting)):
        assert x.re.overlaps(y.re) and x.im.overlaps(y.im)


def cosh_terms(x, count):
    total = term = Fraction(1)
    for k in range(1, count):
        term *= x * x / ((2 * k - 1) * 2 * k)
        total += term
    return total, term


def cosh_below(x):
    """A partial sum of the series, whose terms are positive."""
    return cosh_terms(x, 60)[0]


def cosh_above(x):
    """The partial sum and twice its last term: from there on each term is less than half of the one before, for x at most 80."""
    total, term = cosh_terms(x, 60)
    assert x * x / (119 * 120) < Fraction(1, 2)
    return total + 2 * term


def test_lengths_are_those_of_closed_geodesics(octagon, bolza, pants):
    for surface in (octagon, bolza, pants):
        for geodesic in surface.spectrum(3.1)[:5]:
            assert geodesic.isometry.translation_length.overlaps(geodesic.length)
    # A very short one keeps its digits.
    thin = Surface.fenchel_nielsen([1, "1e-12", 2], 0, "0-0 0-1 1-1")
    short = thin.systole().geodesic
    assert short.isometry.translation_length.overlaps(short.length) and short.isometry.translation_length.width < 1e-26


def test_matrices_of_floats(octagon, bolza):
    for surface in (octagon, bolza):
        f, g = surface.generators()[:2]
        disk, plane = f.matrix(), f.matrix("half-plane")
        assert disk.dtype == complex and plane.dtype == float and disk.shape == plane.shape == (2, 2)
        assert np.linalg.det(disk) == pytest.approx(1) and np.linalg.det(plane) == pytest.approx(1)
        assert np.trace(disk).real == pytest.approx(np.trace(plane)) == pytest.approx(f.trace().mid)
        both = (f * g).matrix()
        assert np.allclose(disk @ g.matrix(), both) or np.allclose(disk @ g.matrix(), -both)


def test_images(octagon):
    f = octagon.generators()[0]
    z = Gaussian("1/3", "-1/7")
    assert complex(f(z)) == pytest.approx(f(complex(z))) and f.inverse()(f(z)) == z


def test_dirichlet_domains(octagon, bolza):
    assert len(bolza.dirichlet_domain((0, 0, 0)).sides) == 8
    domain = octagon.dirichlet_domain((0, "1/10", "-1/7"))
    assert len(domain.sides) == len(domain.vertices) <= 18
    for k, side in enumerate(domain.sides):
        assert domain.sides[side.partner].partner == k
        # The two are inverse to each other, exactly.
        assert (side.isometry * domain.sides[side.partner].isometry).is_identity()
    with pytest.raises(epsnet.SurfaceError, match="unit disk"):
        octagon.dirichlet_domain((0, 1, 0))


def test_covers(octagon):
    sheets = octagon.random_sheets(6, 2)
    cover = octagon.cover(sheets)
    assert cover == octagon.cover(degree=6, seed=2)
    assert cover.genus == 7 and cover.tiles == 6 * octagon.tiles
    # A closed geodesic of the cover lies over one of the base.
    assert octagon.systole().lower <= cover.systole().upper
    for permutations in ([(1, 0)], [(1, 0), (0, 1), (0, 1), (1, 1)], [(0, 1)] * 4):
        with pytest.raises(epsnet.SurfaceError):
            octagon.cover(permutations)
    for wrong in ({"degree": 51, "seed": 1}, {"degree": 3}, {"permutations": sheets, "degree": 6}, {"permutations": "abc"}):
        with pytest.raises(epsnet.EpsnetError):
            octagon.cover(**wrong)


def test_elements_of_maps_have_hashes_of_their_own():
    klein = Surface.named("klein")
    generators = klein.generators()
    assert len({hash(g) for g in generators}) == len(set(generators)) > 6
    for relation in klein.fundamental_polygon().relations():
        sides = klein.fundamental_polygon().sides
        rest = klein.element([])
        for k in relation[1:]:
            rest = rest * sides[k].isometry
        first = sides[relation[0]].isometry.inverse()
        assert first == rest and hash(first) == hash(rest)


def test_matrices_make_the_same_surface(octagon, pants):
    for surface in (octagon, pants):
        for model in ("sl2r", "su11"):
            text = surface.matrices(model)
            same = Surface.from_matrices(text["generators"], text["relation"], model=model)
            assert same.genus == surface.genus and surface.isometric_to(same)
            exact = [[[Fraction(x) for x in row] for row in m] for m in text["generators"]]
            assert Surface.from_matrices(exact, model=model) == same


def test_exported_matrices_fulfil_their_relation(octagon, pants):
    """What a user of Sage computes with the exported text, in fractions: the product of the relation is a multiple of 1."""

    def times(m, n):
        return [[sum(m[i][k] * n[k][j] for k in range(2)) for j in range(2)] for i in range(2)]

    for surface in (octagon, pants):
        text = surface.matrices()
        exact = [[[Fraction(x) for x in row] for row in m] for m in text["generators"]]
        one = [[1, 0], [0, 1]]
        for k in text["relation"]:
            (a, b), (c, d) = exact[abs(k) - 1]
            one = times(one, exact[k - 1] if k > 0 else [[d, -b], [-c, a]])
        assert one[0][1] == one[1][0] == 0 and one[0][0] == one[1][1] != 0
        for m, rounded in zip(exact, text["rounded"]):
            determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0]
            assert all(float(x) ** 2 == pytest.approx(float(y * y / determinant), rel=1e-9, abs=1e-9)
                       for r, s in zip(rounded, m) for x, y in zip(r, s))


def test_matrices_of_a_map_are_exact():
    """Texts of irrational numbers, and what they are rounded to."""
    klein = Surface.named("klein")
    text = klein.matrices()
    same = Surface.from_matrices(text["generators"], text["relation"], tiles=text["tiles"])
    assert klein.isometric_to(same) and len(same.isometries()) == 336
    p, q = text["tiles"]
    names = {"sqrt": math.sqrt, "cos": math.cos, "pi": math.pi,
             "s": 2 * math.sin(math.pi / q) * math.sqrt(2 * math.cos(2 * math.pi / p) + 2 * math.cos(2 * math.pi / q))}
    for m, rounded in zip(text["generators"], text["rounded"]):
        (a, b), (c, d) = ([eval(x, names) for x in row] for row in m)
        scale = math.sqrt(a * d - b * c) * (1 if a * float(rounded[0][0]) > 0 else -1)
        assert [a / scale, b / scale, c / scale, d / scale] == pytest.approx([float(x) for row in rounded for x in row], abs=1e-9)
    with pytest.raises(epsnet.SurfaceError, match=r"sqrt\(2\) is not a number of these tiles"):
        Surface.from_matrices([[["sqrt(2)", 0], [0, 1]]], tiles=(7, 3))


def test_matrices_over_a_number_field_are_exact():
    root = "sqrt(2+2*sqrt(2))"
    rows = [[["1+sqrt(2)", 0], [f"{root}*{x}", f"{root}*{y}"]]
            for x, y in [("1", "0"), ("cos(pi/4)", "sin(pi/4)"), ("0", "1"), ("-cos(pi/4)", "sin(pi/4)")]]
    bolza = Surface.from_matrices(rows, model="su11")
    assert len(bolza.isometries()) == 96 and bolza.net("0.5").certificate
    assert bolza.isometric_to(Surface.from_matrices(bolza.matrices()["generators"]))
    # Its elements are not rational, and are enclosed: translations by the systole.
    assert not bolza.is_rational and not bolza.is_regular
    element = bolza.spectrum(4)[0].isometry
    assert not element.is_exact and "Isometry" in repr(element)
    assert abs(element.trace().mid) == pytest.approx(2 + 2 * math.sqrt(2))
    with pytest.raises(epsnet.SurfaceError, match="not rational"):
        element.exact()
    with pytest.raises(epsnet.SurfaceError, match="algebra: .* expected a positive number"):
        Surface.from_matrices([[[1, 0], [0, 0]]], algebra=(-1, -3))
    with pytest.raises(epsnet.SurfaceError, match="the entries have 4 digits; about"):
        Surface.from_matrices([[[round(float(x), 2) for x in row] for row in m] for m in Surface.named("klein").matrices()["rounded"]])


def test_floats_mean_the_nearest_surface(octagon):
    rounded = [[[round(float(x), 9) for x in row] for row in m] for m in octagon.matrices()["rounded"]]
    near = Surface.from_matrices(rounded)
    assert near.genus == 2 and "entries differ by at most" in near.about
    assert not octagon.isometric_to(near)


@pytest.mark.parametrize(
    "generators, message",
    [
        ([[[1, 1], [0, 1]], [[0, -1], [1, 0]]], "torsion: the element b is elliptic, of order 2"),
        ([[[1, 2], [0, 1]], [[1, 0], [2, 1]]], "not cocompact: the element b is parabolic"),
        ([[["3/5", "4/5"], ["-4/5", "3/5"]], [[2, 0], [0, "1/2"]]], "not discrete: the element a is elliptic, of infinite order"),
        ([[[1, 2]]], "1 rows found"),
        ([], "no generators"),
    ],
)
def test_matrices_of_no_surface_are_refused(generators, message):
    with pytest.raises(epsnet.SurfaceError, match=message):
        Surface.from_matrices(generators)


def test_letters_are_products_of_generators(octagon, pants, bolza):
    for surface in (octagon, pants, bolza, Surface.named("klein"), octagon.cover(degree=3, seed=1)):
        group = surface.fundamental_group()
        assert all(group.element(relation).is_identity() for relation in group.relations)
        assert [group.letters(g) for g in group.generators] == [(k + 1,) for k in range(len(group.generators))]
        for word in surface.matrices()["words"]:
            assert group.element(group.text(word)) == surface.element(word) == group.element(group.letters(word))
        geodesic = surface.systole().geodesic
        lengths = group.element(group.text(geodesic)).translation_length, geodesic.length
        assert lengths[0].overlaps(lengths[1])
        assert surface.element(group.text(geodesic)) == group.element(group.text(geodesic)) and group.letters(group.text(geodesic)) == group.letters(geodesic)
    group = octagon.fundamental_group()
    assert group.text((1, -2)) == "aB" and group.text(octagon.element([])) == "" and group.element("").is_identity()
    assert group.element("aA").is_identity() and repr(group) == "<FundamentalGroup with 4 generators, 1 relation>"


def test_letters_of_the_group_are_those_of_the_matrices(octagon, pants, bolza):
    """All of them, where there is one relation; and else ``pairings`` leads from one to the other."""
    for surface in (octagon, bolza, pants, Surface.named("klein"), octagon.cover(degree=3, seed=1)):
        group, matrices = surface.fundamental_group(), surface.matrices()
        assert group is surface.fundamental_group() and list(group.generators) == surface.generators()
        kept = [surface.element(word) for word in matrices["words"]]
        letters = [group.letters(word) for word in matrices["words"]]
        places = [letter - 1 for letter, in letters]
        assert len(kept) == 2 * surface.genus and places == sorted(set(places)) and kept == [group.generators[k] for k in places]
        for f, product in zip(group.generators, matrices["pairings"]):
            one = surface.element([])
            for k in product:
                one = one * (kept[k - 1] if k > 0 else kept[-k - 1].inverse())
            assert one == f
        assert [matrices["pairings"][k] for k in places] == [[k + 1] for k in range(len(kept))]
        # The relation, in the letters of the group.
        assert group.element([(places[abs(k) - 1] + 1) * (1 if k > 0 else -1) for k in matrices["relation"]]).is_identity()
        if len(group.relations) == 1:
            assert kept == surface.generators() and tuple(matrices["relation"]) == group.relations[0]


def test_a_text_in_letters_is_a_path(octagon, bolza):
    for surface in (octagon, bolza, octagon.cover(degree=3, seed=1)):
        group, f = surface.fundamental_group(), surface.element("abA")
        a, b = group.generators[:2]
        assert f == a * b * a.inverse() == surface.element(f) and surface.reduced("a Aab") == (a * b).word
        assert surface.curve("ab") == surface.curve(a * b) and surface.curve("ab").word == (a * b).word
        assert surface.curve("ab").intersections("b") == surface.curve(a * b).intersections(b)
        assert surface.curves(["ab"])[0].length.overlaps((a * b).translation_length) and not surface.fills(["a", "b"])
        assert group.letters("aAb") == (2,)
    a = octagon.generators()[0]
    assert octagon.dehn_twist("a", 2) == octagon.dehn_twist(a, 2) and octagon.dehn_twist_words("a") == octagon.dehn_twist_words(a)
    assert octagon.twist("a", "1/10") == octagon.twist(a, "1/10")
    assert [cuff.length.ends for cuff in octagon.pants(["a"]).cuffs] == [cuff.length.ends for cuff in octagon.pants([a]).cuffs]
    f = octagon.mapping_class([("a", 2)])
    assert f == octagon.mapping_class([(a, 2)]) == octagon.mapping_class("(a)^2") and f("b") == f(octagon.generators()[1])
    theta = Surface.fenchel_nielsen(lengths=2, twists=0, graph="theta")
    assert theta.gradient("a").length.ends == theta.gradient(theta.generators()[0]).length.ends


def test_a_wrong_letter_is_named(octagon):
    for ask, name in (
        (octagon.element, "word"), (octagon.curve, "word"), (lambda x: octagon.twist(x, 1), "curve"), (lambda x: octagon.curves([x]), "words"),
        (lambda x: octagon.mapping_class(f"a1 ({x})"), "product"), (octagon.fundamental_group().element, "letters"),
    ):
        with pytest.raises(epsnet.ArgumentError) as caught:
            ask("abEA")
        assert caught.value.place == name and caught.value.reason == (
            "letter 2 of the word is 'E', expected a letter from a to d, or from A to D for an inverse"
        )
    with pytest.raises(epsnet.ArgumentError, match="letters: letter 1 of the word is 5, expected an integer from 1 to 4, or from -4 to -1"):
        octagon.fundamental_group().element([1, 5])
    large = Surface.regular(14)
    assert large.element("x27 X27").is_identity() and large.element("x27") == large.generators()[26]
    with pytest.raises(epsnet.ArgumentError, match="word: letter 0 of the word is 'abAB', expected x1 to x28, or X1 to X28 for an inverse, with"):
        large.element("abAB")
