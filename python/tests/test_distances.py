"""Distances, eccentricities, diameters."""
import json
import math
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import epsnet
from epsnet import Interval, Surface

coordinates = st.fractions(min_value=-0.25, max_value=0.25, max_denominator=10**6)
points = st.tuples(st.just(0), coordinates, coordinates)


def in_the_disk(p, q):
    z, w = complex(p[1], p[2]), complex(q[1], q[2])
    return 2 * math.asinh(abs(z - w) / math.sqrt((1 - abs(z) ** 2) * (1 - abs(w) ** 2)))


@settings(max_examples=15)
@given(points, points)
def test_distances_are_symmetric_and_at_most_those_of_lifts(p, q):
    surface = Surface.octagon(seed=123)
    there, back = surface.distance(p, q), surface.distance(q, p)
    assert there.overlaps(back) and there.proved and there.lower <= in_the_disk(p, q) + 1e-12
    assert len(there.paths) == len(back.paths) >= 1


@settings(max_examples=10)
@given(points, points, points)
def test_the_triangle_inequality(p, q, r):
    surface = Surface.octagon(seed=123)
    assert surface.distance(p, r).lower <= surface.distance(p, q).upper + surface.distance(q, r).upper


def test_between_vertices_of_a_net(net):
    distances = [net.surface.distance(net.point(5), net.point(v)) for v in (5, 6, 7)]
    assert (distances[0].lower, distances[0].upper) == (0, 0) and all(d.lower >= 0.25 for d in distances[1:])
    with pytest.raises(epsnet.NetError, match="vertex 1000 does not exist"):
        net.point(1000)


def test_paths_lead_from_p_to_q(bolza, octagon):
    p, q = (0, "1/3", "1/5"), (0, "-0.6", "1/7")
    d = bolza.distance(p, q)
    for surface, p, q in ((bolza, p, q), (octagon, (0, 0.1, 0.3), (0, -0.25, -0.2))):
        d = surface.distance(p, q)
        for word in d.paths:
            # The path ends at the lift of q that the inverse of the word's value takes into the disk of p's tile.
            end = surface.element(word).inverse()(complex(float(surface.point(*q).x), float(surface.point(*q).y)))
            assert in_the_disk((0, surface.point(*p).x, surface.point(*p).y), (0, end.real, end.imag)) == pytest.approx(d.mid)


def test_paths_turn_around_with_their_ends(octagon):
    corner = (0, octagon.tiles[0][0].re, octagon.tiles[0][0].im)
    inside = (0, 0.1, 0.2)
    there, back = octagon.distance(inside, corner), octagon.distance(corner, inside)
    assert abs(there.mid - back.mid) < 1e-12 and len(there.paths) == len(back.paths)
    partner = octagon.partner
    assert sorted(back.paths) == sorted(tuple(partner(s) for s in reversed(word)) for word in there.paths)
    assert octagon.distance(corner, corner).upper == 0


def test_equal_paths(octagon, bolza):
    assert 2 * math.atanh(0.5) == pytest.approx(bolza.distance((0, 0, 0), (0, "1/2", 0)).mid)
    # z ↦ −z takes each corner to another one, which is the same point of the surface.
    corner = octagon.tiles[0][0]
    d = octagon.distance((0, 0, 0), (0, corner.re, corner.im))
    assert len(d.paths) == 2 and d.equal


def test_points_that_are_none(octagon):
    for wrong in ((3, 0, 0), (0, 2, 0), (0, 1, 0)):
        with pytest.raises(epsnet.SurfaceError):
            octagon.distance((0, 0.1, 0), wrong)
    for wrong in ("v3", (0, 1), None):
        with pytest.raises(epsnet.ArgumentError):
            octagon.distance((0, 0.1, 0), wrong)


def test_diameters_of_regular_polygons():
    for genus in (2, 3):
        diameter = Surface.regular(genus).diameter("1e-8")
        assert math.acosh(1 / math.tan(math.pi / (4 * genus)) ** 2) in Interval(diameter.lower - 1e-14, diameter.upper + 1e-14)
        assert diameter.width <= 1e-8 and diameter.proved and diameter.cells > 0 and diameter.triangulations > 0


def test_the_diameter_is_the_greatest_eccentricity(octagon):
    diameter = octagon.diameter("1e-6")
    at = octagon.eccentricity(diameter.point)
    assert diameter.lower - 1e-9 <= at.upper and at.lower <= diameter.upper and at.proved and at.net.proved
    assert octagon.eccentricity((0, 0.1, 0.2)).lower <= diameter.upper


def test_the_largest_embedded_disk(octagon):
    disk = octagon.embedded_disk("1e-6")
    assert isinstance(disk, epsnet.EmbeddedDisk) and disk.proved
    assert 2 * disk.upper >= octagon.systole().lower


def test_the_radius(octagon, bolza):
    for surface in (bolza, octagon):
        radius = surface.radius("0.05")
        assert isinstance(radius, epsnet.Radius) and radius.proved and radius.width <= 0.05 and radius.cells > 0
        # The least eccentricity: at most any one, and at least half of the diameter.
        for point in (surface.centre(), (0, 0.1, 0.2)):
            assert radius.lower <= surface.eccentricity(point).upper
        assert surface.diameter("1e-3").lower <= 2 * radius.upper
    # There the eccentricity is at most the upper end.
    radius = bolza.radius("0.05")
    at = bolza.eccentricity(radius.point)
    assert radius.lower <= at.upper and at.lower <= radius.upper


def test_where_bounds_are_attained(octagon, bolza):
    for surface in (octagon, bolza):
        for bound in (surface.diameter("1e-6"), surface.eccentricity((0, 0.1, 0.2)), surface.radius("0.1")):
            farthest, d = bound.farthest_points(), bound.distance()
            at = surface.eccentricity(bound.point)
            assert d.proved and len(farthest) >= 1 and d.lower - 1e-9 <= at.upper and at.lower <= d.upper + 1e-9
            assert all(surface.distance(bound.point, q).upper + 1e-9 >= d.lower for q in farthest)
    assert not hasattr(epsnet.EmbeddedDisk, "farthest_points")


def test_tables_of_distances(octagon, net):
    table = net.distances([5, 6], [5, 7, 100])
    assert list(table.rows) == [5, 6] and list(table.columns) == [5, 7, 100] and table.bounds.shape == (2, 3, 2)
    for i, u in enumerate(table.rows):
        for k, v in enumerate(table.columns):
            proved = octagon.distance(net.point(u), net.point(v))
            assert table[i, k].overlaps(proved) and table[i, k].ends == (Fraction(table.lower[i, k]), Fraction(table.upper[i, k]))
            assert abs(table.mid[i, k] - proved.mid) <= table.error + proved.error < 1e-12
            assert not table[i, k].proved  # There is no certificate.
    assert table[0, 0].ends == (0, 0)


def test_one_to_many_and_all_pairs(net):
    told = []
    every = net.distances(threads=2, progress=lambda what, share: told.append(what))
    assert every.mid.shape == (len(net), len(net)) and (every.lower <= every.mid).all() and (every.mid <= every.upper).all() and told
    one = net.distances(7)
    assert (one.bounds[0] == every.bounds[7]).all() and list(one.rows) == [7] and len(one.columns) == len(net)
    assert (net.distances(columns=7).bounds[:, 0] == every.bounds[:, 7]).all()
    assert (net.distances(range(3), np.array([1])).mid == every.mid[:3, 1:2]).all()
    # Intervals of d(u, v) and d(v, u) overlap, edges are at least as long, and ends share the memory.
    assert (every.lower <= every.upper.T).all() and (every.lower[net.edges[:, 0], net.edges[:, 1]] <= net.edge_lengths + 1e-12).all()
    assert np.shares_memory(every.lower, every.bounds) and not every.bounds.flags.writeable and every.bounds.shape[2] == 2
    assert net.distances([]).mid.shape == (0, len(net)) and net.distances([]).error == 0
    with pytest.raises(epsnet.ArgumentError):
        every[0, len(net)]


def test_a_table_needs_triangles_of_the_surface(tmp_path, net):
    path = tmp_path / "net.json"
    net.save(path)
    text = path.read_text()
    # Not an epsilon-net, but a triangulation.
    path.write_text(text.replace('"epsilon":"0.25"', '"epsilon":"0.24"'))
    coarse = epsnet.load(path, check=False)
    assert coarse.certificate.verdict == "REFUTED" and (coarse.distances(0).bounds == net.distances(0).bounds).all()
    # No triangulation: a vertex is somewhere else.
    document = json.loads(text)
    chart, x, y = document["vertices"][3]
    document["vertices"][3] = [chart, -x, -y]
    path.write_text(json.dumps(document))
    with pytest.raises(epsnet.NotVerifiedError, match="triangulate"):
        epsnet.load(path, check=False).distances(0)


def test_a_table_beyond_the_memory_is_refused(net):
    with pytest.raises(epsnet.LimitError, match="the machine has"):
        net.distances(np.zeros(10**7, dtype=int).tolist(), np.zeros(10**6, dtype=int).tolist())


def test_location(octagon, net):
    for vertex in (0, 17, 142):
        at = net.locate(net.point(vertex))
        assert at.place == "corner" and at.nearest == vertex == net.triangles[at.triangle, at.number] and at.weights[at.number] == 1
    for triangle in (0, 100, 289):
        middle = net.point_of_triangle(triangle)
        at = net.locate(middle)
        assert (at.place, at.triangle) == ("inside", triangle) and np.allclose(at.weights, 1 / 3)
        for corner, distance in enumerate(at.distances):
            proved = octagon.distance(middle, net.point(net.triangles[triangle, corner]))
            assert proved.lower <= distance + 1e-12
        assert net.point_of_triangle(triangle, (0, 2, 0)) == net.point(net.triangles[triangle, 1])
    with pytest.raises(epsnet.SurfaceError):
        net.locate((0, 2, 0))
    with pytest.raises(epsnet.NetError):
        net.point_of_triangle(10**6)
    with pytest.raises(epsnet.NetError):
        net.point_of_triangle(0, (-1, 1, 1))


def test_points_on_sides_are_told_exactly(bolza):
    net = bolza.net("0.5", points=[(0, 0, 0), (0, "1/3", 0)])
    t, i = next((t, i) for t in range(len(net.triangles)) for i in range(3) if {net.triangles[t, i], net.triangles[t, (i + 1) % 3]} == {0, 1})
    at = net.locate((0, "1/6", 0))
    assert at.place == "side" and at.triangle in (t, net.opposite[t, i] // 3) and at.word == ()


def test_many_threads_locate(net):
    points = [net.point_of_triangle(t) for t in range(0, 290, 10)]
    with ThreadPoolExecutor(4) as pool:
        assert [at.triangle for at in pool.map(net.locate, points)] == list(range(0, 290, 10))


def test_widths(octagon):
    for wrong in (0, "1e-13", -1, float("nan"), "wide"):
        with pytest.raises(epsnet.ArgumentError):
            octagon.diameter(wrong)
    with pytest.raises(epsnet.NetError, match="wider than"):
        octagon.distance((0, 0.1, 0), (0, 0.2, 0), width="1e-40")


def test_files(tmp_path, octagon):
    for measured, kind in (
        (octagon.distance((0, 0.1, 0.3), (0, -0.25, -0.2)), epsnet.Distance),
        (octagon.diameter("1e-3"), epsnet.Diameter),
        (octagon.embedded_disk("1e-3"), epsnet.EmbeddedDisk),
        (octagon.radius("1e-1"), epsnet.Radius),
    ):
        path = tmp_path / "file.json"
        measured.save(path)
        loaded = epsnet.load(path)
        assert isinstance(loaded, kind) and loaded == measured and loaded.proved and loaded.surface == octagon
        assert not epsnet.load(path, check=False).proved and epsnet.certify(path).verified
        assert loaded.net.surface.genus == 2


def test_random_points_are_uniform(octagon, pants):
    for surface in (octagon, pants, epsnet.Surface.named("klein")):
        points = surface.random_points(4000, seed=3)
        assert points == surface.random_points(4000, seed=3) != surface.random_points(4000, seed=4) and surface.random_points(0, seed=1) == []
        net = surface.net("0.4")
        found = [net.locate(p) for p in points]
        assert {at.triangle for at in found} <= set(range(len(net.triangles)))
        # Each triangle has its share of the area, the excess of its angles.
        z = net.corners
        turned = [(np.roll(z, -k, axis=1) - z) / (1 - z.conj() * np.roll(z, -k, axis=1)) for k in (1, 2)]
        areas = np.pi - abs(np.angle(turned[1] / turned[0])).sum(axis=1)
        counts = np.bincount([at.triangle for at in found], minlength=len(areas))
        expected = 4000 * areas / areas.sum()
        assert abs(areas.sum() - surface.area.mid) < 1e-6
        statistic = ((counts - expected) ** 2 / expected).sum()
        assert abs(statistic - len(areas)) < 5 * np.sqrt(2 * len(areas))


def test_the_exponential_map(octagon, pants):
    for surface in (octagon, pants):
        p = surface.centre()
        for direction in (0, 1.5, "-2.5"):
            q = surface.exponential(p, direction, "0.05")
            assert abs(surface.distance(p, q).mid - 0.05) < 1e-12
        assert abs(surface.exponential(p, 0.3, 0).x - p.x) < 1e-29
        assert surface.exponential(p, 1, 40).tile < len(surface.tiles)
    # All the way around a closed geodesic through the centre of the regular octagon.
    bolza = epsnet.Surface.regular(2)
    q = bolza.exponential(bolza.centre(), 0, bolza.systole().mid)
    assert bolza.distance(bolza.centre(), q) < 1e-12


def test_loops_and_the_injectivity_radius(octagon, bolza):
    for surface, p in ((octagon, octagon.centre()), (octagon, octagon.point(0, 0.2, 0.3)), (bolza, bolza.centre())):
        radius = surface.injectivity_radius(p)
        loops = surface.loops_at(p, "5")
        assert radius.proved and radius.width < 1e-12 and all(loop.length.proved and loop.point == p for loop in loops)
        assert loops[0].length.overlaps(2 * radius) and surface.systole() <= loops[0].length + 1e-12
        lengths = [loop.length.mid for loop in loops]
        assert lengths == pytest.approx(sorted(lengths)) and lengths[-1] <= 5 and len(set(loops)) == len(loops)
        # As many as pairs of lifts of p within that distance, counted by the sides of the Dirichlet domain.
        elements, waiting = {surface.element([])}, [surface.element([])]
        sides = [side.isometry for side in surface.dirichlet_domain(p).sides]
        z = complex(float(p.x), float(p.y))
        while waiting:
            g = waiting.pop()
            for side in sides:
                h = g * side
                w = h(z)
                if h not in elements and 2 * np.arctanh(abs((w - z) / (1 - z.conjugate() * w))) < 5:
                    elements.add(h)
                    waiting.append(h)
        assert len(loops) == (len(elements) - 1) // 2
    assert octagon.embedded_disk("0.1").upper >= octagon.injectivity_radius(octagon.centre()).lower
    with pytest.raises(epsnet.LimitError):
        octagon.loops_at(octagon.centre(), 100)
    with pytest.raises(epsnet.EpsnetError):
        octagon.loops_at((0, 0.99, 0), 1)


def test_fixed_points_of_isometries(octagon, bolza):
    group = octagon.isometries()
    points = group.fixed_point_list(1)
    assert len(points) == 6 and epsnet.Point(0, 0, 0) in points  # The Weierstrass points; the octagon is symmetric.
    assert min(octagon.distance(p, q).lower for k, p in enumerate(points) for q in points[:k]) > 0.1
    group = bolza.isometries()
    for i in group.generators:
        if group.fixed_points(i) is None:
            with pytest.raises(epsnet.ArgumentError):
                group.fixed_point_list(i)
        else:
            assert len(group.fixed_point_list(i)) == group.fixed_points(i)
