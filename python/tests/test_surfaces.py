"""Surfaces, and the numbers that describe them."""
import copy
import pickle
import re
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import epsnet
from epsnet import Gaussian, Interval, Surface


def test_a_seed_gives_the_same_surface():
    assert Surface.octagon(321) == Surface.octagon(seed=321) != Surface.octagon(322)


def test_symmetries_that_the_order_of_cuffs_may_lose_are_a_warning(recwarn):
    length, twist = "3.9359462488303282", "0.491993281103791025"  # Klein's quartic, if cuffs are in order.
    Surface.fenchel_nielsen(length, twist, "0-1 0-2 1-3 0-3 1-2 2-3")
    assert not recwarn
    with pytest.warns(UserWarning, match="^note: the pants graph, lengths and twists stay the same if edges .* are exchanged"):
        Surface.fenchel_nielsen(length, twist, "0-1 0-2 0-3 1-2 1-3 2-3")


def test_tiles_and_gluing_make_the_surface_again(octagon, pants):
    for surface in (octagon, pants):
        assert Surface(surface.tiles, surface.gluing) == surface


def test_tiles_are_exact(octagon):
    z = octagon.tiles[0]
    # Opposite corners of a symmetric octagon are opposite points, exactly.
    assert all(z[k] == -z[k + 4] for k in range(4))
    assert isinstance(z[0].re, Fraction)


def test_a_half_makes_the_octagon(octagon):
    assert Surface.octagon(half=octagon.tiles[0][:4]) == octagon


def test_what_is_no_surface_says_why(octagon):
    tiles = octagon.tiles
    tiles[0][2] = tiles[0][2] * Fraction(9, 10)
    with pytest.raises(epsnet.SurfaceError, match="paired but differ"):
        Surface(tiles, octagon.gluing)
    with pytest.raises(epsnet.SurfaceError, match="not paired"):
        Surface(octagon.tiles, octagon.gluing[:3])


@pytest.mark.parametrize(
    "arguments, place",
    [
        (dict(lengths=[1, 2], twists=0, graph="chain", genus=2), "lengths"),
        (dict(lengths="a", twists=0, graph="chain", genus=2), "lengths"),
        (dict(lengths=-1, twists=0, graph="chain", genus=2), "lengths"),
        (dict(lengths=float("nan"), twists=0, graph="chain", genus=2), "lengths"),
        (dict(lengths=1, twists=0, graph="circle", genus=2), "graph"),
        (dict(lengths=1, twists=0, graph=[(0, 1), (0, 2)]), "graph"),
        (dict(lengths=1, twists=0, graph="chain"), "genus"),
        (dict(genus=2), "seed"),
    ],
)
def test_wrong_coordinates_are_blamed(arguments, place):
    with pytest.raises(epsnet.EpsnetError) as caught:
        Surface.fenchel_nielsen(**arguments)
    assert caught.value.place == place


def test_numbers_may_be_of_any_exact_type():
    graph = [(0, 1), (0, 1), (0, 1)]
    half = [Surface.fenchel_nielsen(1, x, graph) for x in ("0.1", "1/10", Fraction(1, 10), 0.1)]
    assert half[0] == half[1] == half[2] == half[3]
    assert Surface.fenchel_nielsen([1, 1, 1], [0.1] * 3, "0-1 0-1 0-1") == half[0]


def test_files_and_pickles(tmp_path, octagon, pants, bolza):
    for surface in (octagon, pants, bolza):
        path = tmp_path / "s.json"
        surface.save(path)
        assert Surface.load(path) == epsnet.load(path) == surface
        assert pickle.loads(pickle.dumps(surface)) == surface
        assert hash(pickle.loads(pickle.dumps(surface))) == hash(surface)


def test_exchange_with_cgal(tmp_path, octagon):
    path = tmp_path / "domain.txt"
    octagon.export("domain", path)
    assert Surface.load(path) == octagon
    assert octagon.export("triangulation").startswith("yes") or octagon.export("triangulation")
    with pytest.raises(ValueError, match='"domain", "triangulation", "edges"'):
        octagon.export("obj")


def test_named_surfaces_and_maps():
    assert all(text for text in Surface.names().values())
    klein = Surface.named("klein")
    assert (klein.genus, len(klein.tiles), klein.is_regular) == (3, 24, True)
    assert pickle.loads(pickle.dumps(klein)) == klein
    assert Surface.named("wiman-2") != Surface.regular(2) == Surface.named("bolza")
    assert Surface.named("R2.6", 2).identify() == Surface.named("bolza").identify() == ["bolza", "R2.1", "R2.3", "R2.6"]
    with pytest.raises(epsnet.SurfaceError, match='there is no surface "R2.7"'):
        Surface.named("R2.7")
    with pytest.raises(epsnet.SurfaceError, match="edges: dart 0 is its own image"):
        Surface.map([1, 2, 0], [0, 2, 1])
    systole = klein.systole()
    assert 3.9359 < systole.lower <= systole.upper < 3.936


def test_points(octagon):
    p = octagon.point(0, 0.1, "-1/3")
    assert p == (0, Fraction(1, 10), Fraction(-1, 3)) and p.z == Gaussian("1/10", "-1/3")
    assert octagon.centre().tile == 0
    with pytest.raises(epsnet.SurfaceError, match="no tile 7"):
        octagon.centre(7)
    with pytest.raises(epsnet.ArgumentError) as caught:
        octagon.point(0, "one", 0)
    assert caught.value.place == "x"


@pytest.mark.parametrize(
    "make, place",
    [
        (lambda s: Surface.octagon(2**31), "seed"),
        (lambda s: Surface.octagon("one"), "seed"),
        (lambda s: Surface.regular(-2), "genus"),
        (lambda s: Surface.regular(2.5), "genus"),
        (lambda s: Surface.fenchel_nielsen(genus=2, seed=-1), "seed"),
        (lambda s: s.point(-1, 0, 0), "tile"),
        (lambda s: s.centre(-1), "tile"),
        (lambda s: s.partner(8), "side"),
        (lambda s: s.net(1, threads=-1), "threads"),
        (lambda s: s.systole(threads=5000), "threads"),
        (lambda s: s.net(1).svg(size=10**9), "size"),
        (lambda s: s.net(1).lifts(-1), "centre"),
        (lambda s: s.net(1).point(-1), "vertex"),
        (lambda s: s.element([0]).enclosure(-5), "bits"),
    ],
)
def test_integers_that_cannot_be_meant(octagon, make, place):
    with pytest.raises(epsnet.ArgumentError, match="expected an integer from") as caught:
        make(octagon)
    assert caught.value.place == place


def test_errors_are_one_family():
    kinds = [getattr(epsnet, name) for name in epsnet.errors.__all__]
    assert all(issubclass(kind, epsnet.EpsnetError) for kind in kinds)
    assert issubclass(epsnet.SurfaceError, ValueError) and issubclass(epsnet.FileError, OSError)


gaussians = st.builds(Gaussian, st.fractions(), st.fractions())


@given(gaussians, gaussians, gaussians)
def test_gaussians_are_a_field(x, y, z):
    assert (x + y) * z == x * z + y * z
    assert x - y == -(y - x)
    assert (x * y).norm() == x.norm() * y.norm()
    if y != 0:
        assert x / y * y == x
    assert (x * y).conjugate() == x.conjugate() * y.conjugate()
    assert pickle.loads(pickle.dumps(x)) == x


@given(st.fractions(), st.fractions())
def test_ends_are_rounded_outward(a, b):
    x = Interval(min(a, b), max(a, b))
    lower, upper = x.ends
    assert Fraction(x.lower) <= lower <= upper <= Fraction(x.upper)
    assert lower in x and upper in x and x.mid in Interval(x.lower, x.upper)
    for end in (lower, upper):
        assert abs(end - Fraction(x.mid)) <= Fraction(x.error)
    assert Fraction(x.width) >= upper - lower


def printed_ends(text):
    return [Fraction(end) for end in text.partition(" (")[0].strip("[]").split(", ")]


@given(st.fractions() | st.floats(allow_nan=False, allow_infinity=False).map(Fraction), st.fractions(min_value=0, max_value=1),
       st.sampled_from(["", ".4f", ".3g", ".2e", ".0f", ".17g", ".60f", "e"]))
def test_printed_ends_are_rounded_outward(a, width, spec):
    x = Interval(a, a + width)
    for text in (str(x), repr(x).partition(" ")[2], format(x, spec)):
        lower, upper = printed_ends(text)
        assert lower <= a and a + width <= upper
    lower, upper = printed_ends(str(x))
    assert float(lower) == x.lower and float(upper) == x.upper  # Both round to nearest.


def test_printed_ends_are_the_nearest_of_their_length():
    x = Interval(Fraction(1, 3), Fraction(2, 3), proved=True)
    assert f"{x:.4f}" == "[0.3333, 0.6667]" and f"{x:.1e}" == "[3.3e-1, 6.7e-1]" and f"{Interval(-2, '-1/3'):.3g}" == "[-2, -0.333] (not proved)"
    assert f"{x}" == str(x) == "[0.3333333333333333, 0.66666666666666675]"
    # The binary64 below 12 pi = 37.6991118430775188..., which is less than its shortest decimal.
    assert str(Interval(37.69911184307752, 38)) == "[37.699111843077517, 38] (not proved)"


def test_an_interval_is_no_number():
    x = Interval(1, 2)
    for use in (float, bool, int, lambda x: x < "1.5"):
        with pytest.raises(TypeError):
            use(x)
    with pytest.raises(ValueError):
        Interval(2, 1)
    assert not x.proved and str(x).endswith("(not proved)") and x.overlaps(Interval(2, 3)) and not x.overlaps(Interval(3, 4))


@settings(max_examples=20)
@given(st.integers(0, 2**31 - 1))
def test_random_octagons_are_closed_surfaces(seed):
    surface = Surface.octagon(seed)
    assert surface.genus == 2 and Surface(surface.tiles, surface.gluing) == surface


def test_the_graph_of_the_tiles(octagon, pants, bolza):
    klein = Surface.named("klein")
    for surface in (octagon, pants, bolza, klein, klein.cover(degree=2, seed=1)):
        graph = surface.graph()
        assert graph.vertices - len(graph.edges) + len(graph.faces) == 2 - 2 * surface.genus
        sides = [tuple(sorted((face[k], face[(k + 1) % len(face)]))) for face in graph.faces for k in range(len(face))]
        assert sorted(sides) == sorted(2 * [tuple(sorted(edge)) for edge in graph.edges.tolist()])
        for name, nodes, edges in (("adjacency", graph.vertices, graph.edges), ("face-adjacency", len(graph.faces), graph.face_edges)):
            matrix = np.zeros((nodes, nodes), int)
            for u, v in edges:
                matrix[u, v] += 1
                matrix[v, u] += 1
            header, size, *rows = surface.export(name).splitlines()
            assert header == "%%MatrixMarket matrix coordinate integer symmetric" and size == f"{nodes} {nodes} {len(rows)}"
            read = np.zeros_like(matrix)
            for i, j, count in (map(int, row.split()) for row in rows):
                read[i - 1, j - 1] = read[j - 1, i - 1] = count
            assert (read == matrix).all()
        header, *rows = surface.export("edges").splitlines()
        assert header.split() == ["u", "v", "left", "right", "length"]
        assert [[int(x) for x in row.split()[:4]] for row in rows] == np.hstack([graph.edges, graph.face_edges]).tolist()
    assert {row.split()[4][:8] for row in klein.export("edges").splitlines()[1:]} == {"0.566256"}
    # Those of the net agree with its arrays.
    net = bolza.net("0.5")
    assert int(net.export("adjacency").split()[5]) == len(net) and int(net.export("face-adjacency").split()[5]) == len(net.triangles)
    networkx = pytest.importorskip("networkx")
    assert networkx.diameter(networkx.Graph(klein.graph().face_edges.tolist())) == 3


def test_exact_lengths_and_twists_keep_the_isometries():
    exact = Surface.fenchel_nielsen(["2*arcosh(3/2)", "2*log(3)", "arcosh(1+sqrt(2))"], 0, "theta")
    assert len(exact.isometries()) == 4 and exact.genus == 2
    unequal = Surface.fenchel_nielsen([2, 3, 4], 0, "0-0 0-1 1-1")
    assert len(unequal.isometries()) == 4 and len(unequal.tiles) == 2
    with pytest.raises(epsnet.EpsnetError, match="the log of a number that is not positive"):
        Surface.fenchel_nielsen(["log(-3)", 1, 1], 0, "theta")


def test_lists_of_coordinates_have_a_graph():
    lists = [1, 2, 3], [0, "1/2", 0]
    theta = Surface.fenchel_nielsen(*lists)
    assert theta == Surface.fenchel_nielsen(*lists, "theta") == Surface.fenchel_nielsen(*lists, "0-1 0-1 0-1") != Surface.fenchel_nielsen(*lists, "chain")
    assert Surface.fenchel_nielsen(*lists, seed=1) == Surface.fenchel_nielsen(*lists, "random", seed=1)
    assert Surface.fenchel_nielsen(6 * [1], 0, "ring").genus == 3
    with pytest.raises(epsnet.EpsnetError, match="^graph: needed for these lengths and twists: chain, ring, tree"):
        Surface.fenchel_nielsen(6 * [1], 0)


def test_families_take_a_genus():
    seven = Surface.named("wiman", 7)
    assert seven == Surface.named("wiman-7") and seven.name == "wiman-7" and Surface.named("klein", 3).name == "klein"
    with pytest.raises(epsnet.SurfaceError, match="wiman is a family, expected a genus as well, as in wiman-7"):
        Surface.named("wiman")


def test_names_and_areas(octagon, tmp_path):
    klein = Surface.named("klein")
    names = {
        octagon: f"octagon(seed={octagon.name[13:-1]})", klein: "klein", Surface.regular(4): "regular(4)",
        Surface.fenchel_nielsen(genus=3, seed=7): "fenchel_nielsen(genus=3, seed=7)", klein.cover(degree=2, seed=1): "cover of degree 2 of klein",
    }
    for surface, name in names.items():
        assert surface.name == name and repr(surface) == f"<Surface {name}, genus {surface.genus}>"
        assert surface.area.proved and 4 * np.pi * (surface.genus - 1) in surface.area and surface.area.width < 1e-14 * surface.genus
    assert repr(Surface(octagon.tiles, octagon.gluing)) == "<Surface of 1 tile, genus 2>"
    glued = Surface.map([(k + 1) % 8 for k in range(8)], [(k + 4) % 8 for k in range(8)])
    assert glued.name == "" and repr(glued) == "<Surface regular(2), genus 2>"


def test_names_of_what_is_made_of_numbers(octagon, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    klein, matrices = Surface.named("klein"), octagon.matrices()
    klein.save("x.json")
    klein.systole().save("systole.json")
    thin = Surface.fenchel_nielsen([1, 0.5, "2*log(3)"], "1/10", [(0, 0), (0, 1), (1, 1)])
    names = [
        (Surface.fenchel_nielsen(lengths=(1, 2, 3), twists=(0, 0, 0)), "fenchel_nielsen(lengths=(1, 2, 3), twists=(0, 0, 0))"),
        (thin, "fenchel_nielsen(lengths=(1, 0.5, '2*log(3)'), twists='1/10', graph='0-0 0-1 1-1')"),
        (Surface.fenchel_nielsen(np.arange(1, 31), 0, "ring", seed=2), "fenchel_nielsen(lengths=(1, 2, 3, …, 29, 30), twists=0, graph='ring', seed=2)"),
        (Surface.load("x.json"), "load('x.json')"), (epsnet.load("x.json"), "load('x.json')"), (Surface.load("systole.json"), "load('systole.json')"),
        (octagon.twist([0], "1/10"), "octagon(seed=123).twist((0,), '1/10')"), (octagon.twist("a", 2), "octagon(seed=123).twist('a', 2)"),
        (octagon.dehn_twist("bA", -2), "octagon(seed=123).dehn_twist('bA', power=-2)"),
        (octagon.mapping_class([("a", 1), ([1], 2)]).marking(), "octagon(seed=123).marking((((4,), 1), ((1,), 2)))"),
        (Surface(octagon.tiles, octagon.gluing).dehn_twist("a"), "surface.dehn_twist('a', power=1)"),
        (Surface.from_matrices(matrices["generators"], matrices["relation"]), "from_matrices(4 matrices)"),
        (Surface.from_matrices(klein.matrices()["generators"], tiles=(7, 3)), "from_matrices(6 matrices, tiles=(7, 3))"),
    ]
    for surface, name in names:
        assert surface.name == name and repr(surface) == f"<Surface {name}, genus {surface.genus}>"
        for again in (pickle.loads(pickle.dumps(surface)), copy.copy(surface), copy.deepcopy(surface)):
            assert again == surface and again.name == name
    assert repr(epsnet.load("systole.json").surface) == "<Surface that is a map of type {7, 3}, genus 3>"  # Where it came from is not known.
    assert octagon.pants().fenchel_nielsen().name.startswith("fenchel_nielsen(lengths=(")
    assert octagon.maximize_systole(steps=1).surface.name == "octagon(seed=123).maximize_systole()"
    # In the middle of what is long something is left out.
    long = thin
    for _ in range(20):
        long = long.dehn_twist("a", 1)
    assert len(long.name) == 100 and long.name.startswith("fenchel_nielsen(") and "…" in long.name and long.name.endswith("dehn_twist('a', power=1)")
    path = tmp_path / ("long" * 20 + ".json")
    klein.save(path)
    assert len(Surface.load(path).name) < 60 and Surface.load(path).name.endswith("long.json')")


def test_points_are_printed_with_twelve_digits(octagon, bolza):
    p = octagon.point(0, "1/3", "-1e-20")
    assert repr(p) == str(p) == "Point(0, 0.333333333333, -1e-20)" and (p.x, p.y) == (Fraction(1, 3), -Fraction(1, 10**20)) and p.z == Gaussian(p.x, p.y)
    assert repr(epsnet.Point(0, 1, 0.1)) == "Point(0, 1, 0.1)" and repr(epsnet.Point(0, "1/3", 0)) == "Point(0, '1/3', 0)"
    diameter = bolza.diameter("0.1")
    points = [diameter.point, *diameter.farthest_points(), octagon.eccentricity(0).point, *octagon.random_points(5, seed=1), octagon.net("0.5").point(3)]
    for p in points:
        assert re.fullmatch(r"Point\(\d+, -?(0|[01]\.\d{1,15}|\d(\.\d+)?e-\d+), -?(0|[01]\.\d{1,15}|\d(\.\d+)?e-\d+)\)", repr(p)), p
        assert isinstance(p.x, Fraction) and abs(p.x - Fraction(repr(p).split(", ")[1])) < 1e-12
