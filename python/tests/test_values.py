"""Everything can be pickled, copied and compared; and mapped by processes and threads."""
import concurrent.futures
import copy
import multiprocessing
import os
import pickle
import threading

import numpy as np
import pytest

import epsnet
from epsnet import Interval, Surface


@pytest.fixture(scope="module")
def values(octagon, pants, bolza, net):
    """One of everything that the module hands out."""
    spectrum, thin = octagon.spectrum(3), pants.thick_thin()
    domain, polygon = octagon.dirichlet_domain((0, 0, 0)), pants.fundamental_polygon()
    f = octagon.generators()[0]
    pseudo = Surface.fenchel_nielsen([1, "1e-3", 2], 0, "0-0 0-1 1-1").net("0.3", pseudo=True)
    return [
        octagon, pants, bolza, net, pseudo, pseudo.collars, net.certificate, net.certificate.rules, net.certificate.enclosures, net.lifts(), net.view(),
        net.point(3), net.locate(net.point(3)), net.distances(0), spectrum, spectrum[1], spectrum.multiplicities(), thin, thin.pieces, octagon.systole(),
        octagon.distance((0, 0.1, 0), 0), octagon.distance((0, octagon.tiles[0][0].re, octagon.tiles[0][0].im), 0), octagon.diameter("0.01"),
        octagon.radius("0.1"), octagon.embedded_disk("0.01"), octagon.eccentricity(0), domain, domain.sides, polygon, polygon.sides, f, bolza.element([0]),
        f.axis(), f.su11(), f.a, Interval(1, "4/3", proved=True), octagon.pants(), octagon.pants().cuffs[1],
        octagon.curve([0, 1]), octagon.curves([[0]]), octagon.curves([[0]])[0],
        octagon.isometries(), octagon.isometries()[1], octagon.isometries().proof, octagon.fundamental_group(), octagon.graph(), octagon.area, octagon.loops_at(octagon.centre(), 3)[0],
    ]


def parts(thing):
    yield thing
    if isinstance(thing, (list, tuple)):
        for one in thing:
            yield from parts(one)


def test_pickles_and_copies_are_equal(values):
    for value in values:
        for again in (pickle.loads(pickle.dumps(value)), copy.copy(value), copy.deepcopy(value)):
            assert type(again) is type(value) and again == value, value
            if not isinstance(value, (list, dict, epsnet.Lifts, epsnet.DistanceTable)):
                assert hash(again) == hash(value), value
            if isinstance(value, Interval):
                assert again.ends == value.ends


def test_different_values_are_different(values, octagon):
    for k, x in enumerate(values):
        assert [j for j, y in enumerate(values) if type(y) is type(x) and y == x] == [k]
        assert x != 17 and not x == "x"
    assert octagon.spectrum(3)[0] != octagon.spectrum(2)[0] and octagon.distance(0, (0, 0.1, 0)) != octagon.distance(0, (0, 0.2, 0))


def test_a_pickle_of_a_document_is_not_proved(octagon, net):
    for value in (net, octagon.spectrum(3), octagon.diameter("0.01"), octagon.systole(), octagon.distance((0, 0.1, 0), 0), octagon.pants(),
                  octagon.curves([[0]])):
        assert value.proved and copy.copy(value).proved and copy.deepcopy(value).proved
        again = pickle.loads(pickle.dumps(value))
        assert not again.proved
        assert again.certificate.verified and again.proved
        if isinstance(value, Interval):
            assert str(again) == str(value) and (again + 1).proved


def test_paths_of_pickles(octagon):
    distances = [octagon.distance((0, corner.re, corner.im), (0, 0.1, 0.2)) for corner in octagon.tiles[0]]
    assert any(d.paths[0] for d in distances)
    assert all(pickle.loads(pickle.dumps(d)).paths == d.paths for d in distances)


def test_exceptions_are_pickled(octagon, tmp_path, net):
    path = tmp_path / "net.json"
    net.save(path)
    path.write_text(path.read_text().replace('"epsilon":"0.25"', '"epsilon":"0.24"'))
    for cause in (lambda: octagon.net("abc"), lambda: epsnet.load(path), lambda: epsnet.load(tmp_path / "none"), lambda: Interval(1, 2) < 1.5):
        with pytest.raises(epsnet.EpsnetError) as caught:
            cause()
        again = pickle.loads(pickle.dumps(caught.value))
        assert type(again) is type(caught.value) and str(again) == str(caught.value)
        assert (again.file, again.place, again.reason) == (caught.value.file, caught.value.place, caught.value.reason)
    assert again.args and pickle.loads(pickle.dumps(net.certificate)).verdict == "VERIFIED"


def all_of(surface):
    """For another process."""
    return surface.systole(), surface.spectrum(1), surface.diameter("0.1"), surface.net("0.5")


def test_processes_hand_over_everything():
    surfaces = [Surface.octagon(seed) for seed in (1, 2)]
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        for surface, found in zip(surfaces, pool.map(all_of, surfaces)):
            assert all(x == y for x, y in zip(found, all_of(surface)))


def test_the_map_is_a_structured_array():
    surfaces = [Surface.octagon(seed) for seed in range(6)]

    def describe(surface):
        return {"genus": surface.genus, "systole": surface.systole(), "name": f"surface {surface.genus}", "simple": surface.systole().geodesic.simple,
                "ratio": 0.5, "point": surface.centre()}

    for workers in (1, 3, None):
        table = epsnet.map(describe, surfaces, workers=workers)
        assert table.shape == (6,) and table.dtype.names == ("genus", "systole", "name", "simple", "ratio", "point")
        for row, surface in zip(table, surfaces):
            systole = surface.systole()
            assert row["genus"] == 2 and (row["systole"]["lower"], row["systole"]["upper"]) == (systole.lower, systole.upper) and row["systole"]["proved"]
            assert row["name"] == "surface 2" and row["simple"] and row["ratio"] == 0.5 and row["point"] == surface.centre()
    assert table["genus"].dtype.kind == "i" and table["name"].dtype.kind == "U" and table["simple"].dtype == bool
    assert list(epsnet.map(lambda surface: surface.genus, surfaces[:2])["value"]) == [2, 2] and len(epsnet.map(describe, [])) == 0
    assert epsnet.map(lambda surface: surface.centre(), surfaces[:2]).dtype.names == ("tile", "x", "y")


def test_the_map_runs_side_by_side():
    # Each waits for all the others.
    barrier = threading.Barrier(4, timeout=60)
    surfaces = [Surface.octagon(1)] * 4
    assert sorted(epsnet.map(lambda surface: barrier.wait(), surfaces, workers=4)["value"]) == [0, 1, 2, 3]


def test_one_bar_for_all(capsys):
    told = []
    surfaces = [Surface.octagon(seed) for seed in range(5)]
    epsnet.map(lambda surface: surface.systole(), surfaces, progress=lambda what, share: told.append((what, share)))
    assert told[-1] == ("5 of 5 surfaces", 1) and all("of 5 surfaces" in what for what, _ in told)
    assert [share for _, share in told] == sorted(share for _, share in told)


def test_an_error_ends_the_map_and_says_where():
    surfaces = [Surface.octagon(seed) for seed in range(3)]
    with pytest.raises(epsnet.ArgumentError, match=r"^surfaces\[\d\]: epsilon: "):
        epsnet.map(lambda surface: surface.net("abc"), surfaces)
    with pytest.raises(ZeroDivisionError):
        epsnet.map(lambda surface: 1 / 0, surfaces)
    fields = iter([{"a": 1}, {"b": 1}])
    with pytest.raises(epsnet.ArgumentError) as caught:
        epsnet.map(lambda surface: next(fields), surfaces[:2], workers=1)
    assert caught.value.place == "function"
    # The others are stopped: these would take many minutes.
    heavy = Surface.octagon(1)

    def work(surface):
        if surface is heavy:
            surface.net("0.001")
        raise KeyError

    with pytest.raises(KeyError):
        epsnet.map(work, [heavy, surfaces[0]], workers=2)
    assert not [thread for thread in threading.enumerate() if thread.name.startswith("ThreadPool") and not joined(thread)]


def test_errors_can_be_recorded():
    surfaces = [Surface.octagon(seed) for seed in range(3)]

    def describe(surface):
        if surface == surfaces[1]:
            surface.net("abc")
        return {"systole": surface.systole(), "genus": surface.genus, "text": "x", "point": [1]}

    found = epsnet.map(describe, surfaces, on_error="record")
    assert list(found["error"]) == ["", found["error"][1], ""] and found["error"][1].startswith("ArgumentError: epsilon: ")
    assert np.isnan(found["systole"]["lower"][1]) and not found["systole"]["proved"][1] and found["systole"]["proved"][[0, 2]].all()
    assert np.isnan(found["genus"][1]) and found["genus"][0] == 2 and list(found["text"]) == ["x", "", "x"] and list(found["point"]) == [[1], None, [1]]
    assert list(epsnet.map(lambda surface: 1 / 0, surfaces, on_error="record").dtype.names) == ["error"]
    assert list(epsnet.map(lambda surface: surface.genus, surfaces, on_error="record")["error"]) == [""] * 3
    with pytest.raises(epsnet.ArgumentError):
        epsnet.map(lambda surface: {"error": 1}, surfaces, on_error="record")


def test_the_table_has_columns_of_floats():
    surfaces = [Surface.octagon(seed) for seed in range(3)]
    found = epsnet.map(lambda surface: {"genus": surface.genus, "systole": surface.systole()}, surfaces)
    columns = epsnet.table(found)
    assert list(columns) == ["genus", "systole", "systole_lower", "systole_upper"]
    assert all(column.shape == (3,) for column in columns.values()) and columns["systole"].dtype == float
    assert (columns["systole_lower"] <= columns["systole"]).all() and (columns["systole"] <= columns["systole_upper"]).all()
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(columns)
    assert list(frame.dtypes.astype(str)) == ["int64", "float64", "float64", "float64"] and frame["systole"].mean() > 0


def test_intervals_become_arrays_of_floats():
    values = [Interval(1, 2), Interval("1/3", "1/3")]
    assert epsnet.mids(values).tolist() == [1.5, 1 / 3] and epsnet.mids([]).dtype == float
    # A float that nobody asked for would look proved: SymPy, for one, takes what float() returns.
    with pytest.raises(TypeError, match=r"epsnet\.mids"):
        np.asarray(values, float)


def joined(thread):
    thread.join(60)
    return not thread.is_alive()


def test_the_recipe_with_futures():
    """docs/using-from-python.md has it."""
    surfaces = [Surface.octagon(seed) for seed in range(4)]
    with concurrent.futures.ThreadPoolExecutor() as pool:
        systoles = list(pool.map(Surface.systole, surfaces))
    assert np.array_equal(epsnet.ends(systoles), epsnet.ends(surface.systole() for surface in surfaces)) and all(x.proved for x in systoles)
