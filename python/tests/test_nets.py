"""Nets, their arrays, their certificates."""
import pickle

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import epsnet
from epsnet import Net, Surface


def test_a_net_is_proved(net):
    assert net.proved and net.certificate.verified and net.certificate.verdict == "VERIFIED"
    assert [rule.name for rule in net.certificate.rules] == ["surface", "map", "gluing", "orientation", "delaunay", "covering", "packing"]
    counts = net.certificate.counts
    assert (counts["vertices"], counts["edges"], counts["triangles"]) == (len(net), len(net.edges), len(net.triangles))
    assert len(net) - len(net.edges) + len(net.triangles) == 2 - 2 * net.surface.genus


def test_what_is_proved(net):
    enclosures = net.certificate.enclosures
    assert all(x.proved for x in enclosures.values())
    assert enclosures["largest_circumradius"].upper <= 0.25 <= enclosures["shortest_edge"].lower
    assert 4 * np.pi in enclosures["area"] and 0.25 in enclosures["epsilon"]
    # The rounded numbers agree with it.
    assert net.circumradii.max() == pytest.approx(enclosures["largest_circumradius"].mid)
    assert net.edge_lengths.max() == pytest.approx(enclosures["longest_edge"].mid)


def test_arrays_share_the_memory_of_the_net(net):
    for array in (net.vertices, net.vertex_charts, net.triangles, net.opposite, net.corner_labels, net.lifts().corners):
        assert not array.flags.owndata and not array.flags.writeable
    assert np.shares_memory(net.vertices, net.vertices) and np.shares_memory(net.triangles, net.triangles)
    assert net.vertices.dtype == complex and net.triangles.dtype == np.uint32


def test_arrays_outlive_the_net():
    vertices = Surface.octagon(1).net("0.5").vertices
    lifts = Surface.octagon(1).net("0.5").lifts().corners
    assert abs(vertices).max() < 1 and abs(lifts).max() < 1


def test_the_triangulation_is_a_closed_surface(net):
    darts = np.arange(3 * len(net.triangles))
    opposite = net.opposite.reshape(-1)
    assert (opposite[opposite] == darts).all() and (opposite != darts).all()
    starts = net.triangles.reshape(-1)
    ends = np.roll(net.triangles, -1, axis=1).reshape(-1)
    assert (starts[opposite] == ends).all()
    assert (net.edges == np.stack([starts, ends], axis=1)[net.edge_darts]).all()


def test_corners_are_triangles_of_that_size(net):
    z = net.corners
    u, v = z, np.roll(z, -1, axis=1)
    lengths = 2 * np.arcsinh(abs(u - v) / np.sqrt((1 - abs(u) ** 2) * (1 - abs(v) ** 2)))
    assert np.allclose(lengths.reshape(-1)[net.edge_darts], net.edge_lengths)
    assert np.allclose(z[:, 0], net.vertices[net.triangles[:, 0]])


def test_lifts(net):
    for order in ("weight", "breadth first"):
        lifts = net.lifts(3, order=order)
        assert sorted(lifts.triangles) == list(range(len(net.triangles))) and len(lifts) == len(net.triangles)
        assert (lifts.triangles[lifts.places] == np.arange(len(lifts))).all()
        # Vertex 3 is in the centre of the disk.
        first = lifts.triangles[0]
        assert abs(lifts.corners[0][list(net.triangles[first]).index(3)]) < 1e-12
    with pytest.raises(ValueError, match='"weight" or "breadth first"'):
        net.lifts(order="depth first")
    with pytest.raises(epsnet.NetError, match="vertex 100000"):
        net.lifts(100000)


def test_files_are_read_back(tmp_path, net):
    path = tmp_path / "net.json"
    net.save(path)
    loaded = epsnet.load(path)
    assert loaded == net and loaded.proved and loaded.surface == net.surface
    assert Net.load(path) == net and Surface.load(path) == net.surface
    assert epsnet.certify(path).verified
    unchecked = epsnet.load(path, check=False)
    assert not unchecked.proved and "not checked" in repr(unchecked)
    assert unchecked.certificate.verified and unchecked.proved
    assert pickle.loads(pickle.dumps(net)) == net and not pickle.loads(pickle.dumps(net)).proved


def test_the_name_of_a_file_says_its_form(tmp_path, net):
    compact, plain = tmp_path / "net.epsn", tmp_path / "net.json"
    net.save(compact)
    net.save(plain)
    assert compact.read_bytes().startswith(b"\x89EPSNET\n") and plain.read_bytes().startswith(b"{")
    assert compact.stat().st_size < plain.stat().st_size
    for path in (compact, plain):
        assert epsnet.load(path) == net and epsnet.certify(path).verified and Surface.load(path) == net.surface and Net.load(path).proved
    with pytest.raises(epsnet.FileError):
        net.save(tmp_path / "no folder" / "net.epsn")


def test_sparse_nets_have_few_points(bolza):
    assert len(bolza.net("0.3", sparse=True)) < 0.8 * len(bolza.net("0.3")) and bolza.net("0.3", sparse=True).proved


def test_given_points_are_the_first_vertices(octagon, bolza):
    points = [octagon.point(0, "1/10", "1/7"), octagon.point(0, -0.2, 0), octagon.centre()]
    net = octagon.net("0.15", points=points)
    assert [net.point(k) for k in range(3)] == points and net.proved
    net = octagon.net("0.15", base=(0, 0.3, 0.1), points=iter(points))
    assert [net.point(k) for k in range(4)] == [octagon.point(0, 0.3, 0.1), *points]
    with pytest.raises(epsnet.NetError, match="points 0 and 1"):
        octagon.net("0.5", points=[(0, 0, 0), (0, 0.1, 0)])
    with pytest.raises(epsnet.SurfaceError):
        octagon.net("0.5", points=[(0, 1, 0)])


def test_summaries(net, bolza):
    assert net.info()["vertices"] == len(net) and net.surface.info()["genus"] == 2
    assert bolza.dirichlet_domain((0, 0, 0)).info()


def test_a_false_net_is_not_handed_out(tmp_path, net):
    path = tmp_path / "net.json"
    net.save(path)
    path.write_text(path.read_text().replace('"epsilon":"0.25"', '"epsilon":"0.24"'))
    with pytest.raises(epsnet.NotVerifiedError) as caught:
        epsnet.load(path)
    assert caught.value.certificate.verdict == "REFUTED" and caught.value.place == "covering" and str(path) in str(caught.value)
    certificate = epsnet.certify(path)
    assert certificate.rule == "covering" and "REFUTED" in str(certificate) and "covering" in certificate._repr_html_()
    assert not any(x.proved for x in certificate.enclosures.values())


@pytest.mark.parametrize(
    "text, place, expected",
    [
        ("{", "net", "the name of a member"),
        ('{"format": "epsnet-net"}', "net", None),
        ('{"format": "epsnet-net", "version": 2}', "net", "1"),
        ("[]", "document", "an object"),
        (
            '{"format": "epsnet-surface", "version": 1, "surface": {"kind": "tiles", "tiles": [], "gluing": [[0, 0, "x", 0]]}}',
            "surface.gluing[0]", "an index: an integer >= 0 without sign, fraction or exponent",
        ),
        (
            '{"format": "epsnet-surface", "version": 1, "surface": {"kind": "tiles", "tiles": [], "gluing": [[0, 0, 1, 0]]}}',
            "surface.tiles", "at least one",
        ),
        ("yes", "1", None),
        ("\xff\xfe", None, None),
        ("", None, None),
    ],
)
def test_nonsense_is_named_with_its_file(tmp_path, text, place, expected):
    path = tmp_path / "no net.json"
    path.write_text(text, encoding="latin-1")
    with pytest.raises(epsnet.FormatError) as caught:
        epsnet.load(path)
    assert caught.value.file == str(path) and caught.value.reason
    assert (caught.value.place, caught.value.expected) == (place, expected) or place is None
    assert expected is None or caught.value.reason.endswith(f", expected {expected}")
    assert str(caught.value).endswith(caught.value.reason)


def test_files_that_are_not_there(tmp_path, net):
    with pytest.raises(epsnet.FileError) as caught:
        epsnet.load(tmp_path / "none.json")
    assert caught.value.file == str(tmp_path / "none.json") and caught.value.reason == "no such file"
    with pytest.raises(OSError):
        epsnet.certify(tmp_path)
    with pytest.raises(epsnet.FileError):
        net.save(tmp_path / "no folder" / "net.json")
    with pytest.raises(epsnet.FileError) as caught:
        net.export("off", tmp_path / "no folder" / "net.off")
    assert caught.value.file == str(tmp_path / "no folder" / "net.off") and caught.value.reason
    with pytest.raises(epsnet.FormatError, match="expected a net file, not Surface"):
        net.surface.save(tmp_path / "s.json")
        Net.load(tmp_path / "s.json")


@pytest.mark.parametrize("epsilon", ["0", "-1", "x", "", 0.0, -0.1, float("nan"), float("inf")])
def test_epsilon_is_a_positive_length(octagon, epsilon):
    with pytest.raises(epsnet.ArgumentError):
        octagon.net(epsilon)


def test_epsilon_is_exact(octagon):
    assert octagon.net(0.5).epsilon == "0.5" and octagon.net("1/2").epsilon == "1/2" and octagon.net("5e-1").epsilon == "5e-1"
    assert octagon.net(0.5).vertices.tobytes() == octagon.net("1/2").vertices.tobytes()


def test_pseudo_nets():
    thin = Surface.fenchel_nielsen(["1e-8", 1, 2], [0, 0, "0.5"], [(0, 0), (0, 1), (1, 1)])
    net = thin.net("0.25", pseudo=True)
    (collar,) = net.collars
    assert net.proved and 1e-8 in epsnet.Interval(collar.length.lower * 0.999, collar.length.upper * 1.001) and collar.length.proved
    assert thin.regular(2).net(1).collars is None
    with pytest.raises(epsnet.ArgumentError, match="ln sqrt"):
        thin.net("0.5", pseudo=True)


def test_a_net_starts_from_a_base(octagon):
    base = octagon.point(0, "1/10", "-1/7")
    assert octagon.net(1, base=base).point(0) == base
    with pytest.raises(epsnet.SurfaceError, match="unit disk"):
        octagon.net(1, base=(0, 1, 0))


def test_tiles_as_a_net(octagon, net, tmp_path):
    net.export("triangulation", tmp_path / "net.txt")
    same = Net.of_tiles(Surface.load(tmp_path / "net.txt"), "0.25")
    assert len(same) == len(net) and same.certificate.verified
    assert not Net.of_tiles(Surface.load(tmp_path / "net.txt"), "0.2").certificate.verified


def test_progress_is_told(octagon):
    told = []
    octagon.net("0.02", progress=lambda what, share: told.append((what, share)))
    assert told and all(isinstance(what, str) and 0 <= share <= 1 for what, share in told)


def test_what_progress_raises_ends_the_computation(octagon):
    def stop(what, share):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        octagon.net("0.02", progress=stop)


@settings(max_examples=15)
@given(st.integers(0, 10**6), st.sampled_from(["0.3", "0.45", "3/5"]))
def test_nets_of_random_surfaces(seed, epsilon):
    net = Surface.octagon(seed).net(epsilon)
    assert net.proved and len(net) - len(net.edges) + len(net.triangles) == -2
