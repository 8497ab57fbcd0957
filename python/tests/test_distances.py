"""Distances, eccentricities, diameters."""
import math

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
    assert there == back and len(there.paths) == len(back.paths)
    partner = octagon.partner
    assert sorted(back.paths) == sorted(tuple(partner(s) for s in reversed(word)) for word in there.paths)
    with pytest.raises(epsnet.SurfaceError, match="both points are on the boundary"):
        octagon.distance(corner, corner)


def test_equal_paths(octagon, bolza):
    assert 2 * math.atanh(0.5) == pytest.approx(bolza.distance((0, 0, 0), (0, "1/2", 0)).mid)
    # z ↦ −z takes each corner to another one, which is the same point of the surface.
    corner = octagon.tiles[0][0]
    d = octagon.distance((0, 0, 0), (0, corner.re, corner.im))
    assert len(d.paths) == 2 and d.equal


def test_points_that_are_none(octagon):
    for wrong in ((3, 0, 0), (0, 2, 0), (0, "0.999", 0)):
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
    ):
        path = tmp_path / "file.json"
        measured.save(path)
        loaded = epsnet.load(path)
        assert isinstance(loaded, kind) and loaded == measured and loaded.proved and loaded.surface == octagon
        assert not epsnet.load(path, check=False).proved and epsnet.certify(path).verified
        assert loaded.net.surface.genus == 2
