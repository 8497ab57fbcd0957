"""Eigenvalues of the Laplacian."""
import copy
import pickle
import xml.etree.ElementTree as ElementTree
from fractions import Fraction

import numpy as np
import pytest

import epsnet

# A. Strohmaier, V. Uski, arXiv:1110.2150.
BOLZA = [(1, 3, 3.8388872588421995), (4, 4, 5.353601341189)]


@pytest.fixture(scope="module")
def found(bolza):
    """The first seven of the Bolza surface, with eigenfunctions."""
    return bolza.eigenvalues(7)


@pytest.fixture(scope="module")
def rough(bolza):
    """The same without."""
    return bolza.eigenvalues(7, digits=2)


def test_of_the_bolza_surface_are_those_of_the_literature(found, rough):
    for eigenvalues, width in ((found, 1e-7), (rough, 0.5)):
        assert eigenvalues.proved and eigenvalues.next > BOLZA[1][2]
        assert [(row.first, row.count) for row in eigenvalues] == [(first, count) for first, count, _ in BOLZA]
        for row, (_, _, value) in zip(eigenvalues, BOLZA):
            assert row.interval.proved and value in row.interval and row.interval.width < width


def test_numbers_below_a_bound(found, bolza):
    assert found.count_below(0.25) == found.count_below("1/4") == found.count_below(-1) == (0, 0)
    assert found.count_below(4) == (3, 3) and found.count_below(5.5)[0] == 7
    assert found.count_below(10**30)[1] is None
    least, most = found.count_below(found[0].interval.mid)
    assert least == 0 and most == 3
    none = bolza.eigenvalues(below="0.25")
    assert none.count_below(0.25) == (0, 0) and none.next >= 0.25
    assert bolza.eigenvalues(below=4, digits=4).count_below(4) == (3, 3)


def test_eigenfunctions_take_all_values(found):
    for index in (1, 2, 7):
        function = found.eigenfunction(index)
        assert function.index == index and function.interval.proved and function.net == found.net
        row = found[0] if index <= 3 else found[1]
        assert row.interval.lower <= function.interval.lower <= function.interval.upper <= row.interval.upper
        values = function.at_vertices
        assert values.shape == (len(found.net),) and values.dtype == np.float64 and not values.flags.writeable
        assert values.min() < 0 < values.max()  # It is orthogonal to the constants.
        assert f"λ_{index}" in repr(function)
    # Those of one eigenvalue are independent.
    values = np.array([found.eigenfunction(index).at_vertices for index in (1, 2, 3)])
    assert np.linalg.matrix_rank(values, tol=1e-3 * np.abs(values).max()) == 3


def test_the_picture_of_an_eigenfunction(found):
    function = found.eigenfunction(1)
    svg = function.svg(size=300)
    groups = [group.get("class") for group in ElementTree.fromstring(svg)]
    assert "values" in groups and "nodal-lines" in groups
    assert len({svg, function.svg(size=200), function.svg(size=300, centre=2), function.svg(size=300, order="breadth first"),
                found.eigenfunction(2).svg(size=300)}) == 5
    assert function._repr_mimebundle_()["image/svg+xml"] == function.svg()
    with pytest.raises(epsnet.NetError):
        function.svg(centre=10**6)


def test_what_there_is_no_eigenfunction_of(found, rough):
    for eigenvalues, index, message in ((found, 8, "no eigenfunction of lambda_8: the file has 7, those of lambda_1 to lambda_7"),
                                        (rough, 1, "no eigenfunction of lambda_1: the file has no eigenfunctions")):
        with pytest.raises(epsnet.ArgumentError, match=message) as caught:
            eigenvalues.eigenfunction(index)
        assert caught.value.place == "index"
    with pytest.raises(epsnet.ArgumentError):
        found.eigenfunction(0)


def test_of_a_file_are_the_same(found, tmp_path):
    path = str(tmp_path / "eigenvalues.json")
    found.save(path)
    loaded = epsnet.load(path)
    assert loaded == found and hash(loaded) == hash(found) and loaded[:] == found[:] and repr(loaded) == repr(found)
    assert loaded.eigenfunction(1) == found.eigenfunction(1) != found.eigenfunction(2)
    assert hash(loaded.eigenfunction(1)) == hash(found.eigenfunction(1))
    assert not epsnet.load(path, check=False)[0].interval.proved
    assert copy.copy(found) is found and pickle.loads(pickle.dumps(found)) == found


def test_the_picture_has_a_band_for_each_row(found):
    root = ElementTree.fromstring(found.svg(700))
    assert (root.get("width"), root.get("height")) == ("700", "434")
    bands = next(group for group in root if group.get("class") == "enclosures")
    assert len(bands) == len(found)
    assert found._repr_mimebundle_()["image/svg+xml"] == found.svg() != found.svg(700)
    with pytest.raises(epsnet.ArgumentError):
        found.svg(1)


def test_with_phases_they_begin_with_the_number_0(bolza, rough, tmp_path):
    found = bolza.eigenvalues(2, phases=("1/3", 0, 0.25, Fraction(-5, 2)))
    assert found.proved and found[0].first == 0 and found[0].interval.lower > 0
    assert found.phases == (Fraction(1, 3), 0, Fraction(1, 4), Fraction(1, 2), Fraction(-1, 3), 0, Fraction(-1, 4), Fraction(1, 2))
    assert found.phases == bolza.side_phases(("1/3", 0, "1/4", "1/2"))
    assert rough.phases == () and bolza.character_sides == (0, 1, 2, 3)
    path = str(tmp_path / "phases.json")
    found.save(path)
    assert epsnet.load(path) == found and epsnet.load(path).phases == found.phases
    # Those of functions, and 0.
    zero = bolza.eigenvalues(8, phases=(0, 0, 0, 0))
    assert [row.count for row in zero] == [1, 3, 4] and zero[0].interval.lower == 0 and zero[0].interval.upper < 1e-5
    for row, other in zip(zero[1:], rough):
        assert row.first == other.first and row.interval.lower <= other.interval.upper and other.interval.lower <= row.interval.upper


def test_bands_are_the_eigenvalues_at_points_of_a_path(bolza):
    bands = bolza.bands([(0, 0, 0, 0), ("1/2", 0, 0, 0)], steps=2, count=2, digits=1)
    assert bands.points == ((0, 0, 0, 0), (Fraction(1, 4), 0, 0, 0), (Fraction(1, 2), 0, 0, 0)) and len(bands) == 3
    assert bands.lower.shape == bands.upper.shape == (3, 2) and not bands.lower.flags.writeable
    assert (bands.lower < bands.upper).all() and bands.lower[0, 0] == 0
    assert bands.interval(1, 0).proved and bands.interval(1, 0).upper == bands.upper[1, 0]
    alone = bolza.eigenvalues(2, phases=("1/2", 0, 0, 0))
    for row, band in zip(alone, (0, 1)):
        assert bands.lower[2, band] <= row.interval.upper and row.interval.lower <= bands.upper[2, band]
    assert bands == bolza.bands([(0, 0, 0, 0), ("1/2", 0, 0, 0)], steps=2, count=2, digits=1, threads=1) and copy.copy(bands) is bands
    groups = [path.get("class") for path in ElementTree.fromstring(bands.svg(300))]
    assert groups.count("band") == 2 and bands.svg(300) != bands.svg()


def test_a_box_holds_for_phases_near_these(bolza, rough, tmp_path):
    box = bolza.eigenvalues(2, digits=2, phases=("1/2", 0, 0, 0), box="0.01")
    alone = bolza.eigenvalues(2, digits=2, phases=("0.49", "0.01", "-0.01", 0))
    assert box.proved and box.box == Fraction(1, 100) and alone.box is None and rough.box is None
    assert box[0].interval.lower < alone[0].interval.lower and alone[0].interval.upper < box[0].interval.upper
    path = str(tmp_path / "box.json")
    box.save(path)
    assert epsnet.load(path) == box and epsnet.load(path).box == box.box
    with pytest.raises(epsnet.ArgumentError, match="^box: only with phases"):
        bolza.eigenvalues(2, box="0.01")
    for wrong in (0, "51/100", -1, "x"):
        with pytest.raises(epsnet.ArgumentError, match="^box: "):
            bolza.eigenvalues(2, phases=(0, 0, 0, 0), box=wrong)


def test_a_gap_that_is_not_there_is_an_error(bolza):
    with pytest.raises(epsnet.NetError, match="^not proved at the phases "):
        bolza.gap("3/8", 2, epsilon=1)
    for wrong in ({"outside": 0}, {"outside": "1/2"}, {"at_least": 0}, {"at_least": "1e5"}, {"most": 0}):
        with pytest.raises(epsnet.ArgumentError, match=f"^{next(iter(wrong))}: "):
            bolza.gap(**{"outside": "3/8", "at_least": 0.1, **wrong})


def test_points_that_are_none_are_errors(bolza):
    with pytest.raises(epsnet.ArgumentError, match="^phases: expected 4 phases, those of the sides 0, 1, 2, 3, not "):
        bolza.eigenvalues(phases=(0, 0))
    with pytest.raises(epsnet.ArgumentError, match="^digits: "):
        bolza.eigenvalues(phases=(0, 0, 0, 0), digits=4)
    with pytest.raises(epsnet.ArgumentError, match="^path: "):
        bolza.bands([])
    with pytest.raises(epsnet.ArgumentError, match="^path: "):
        bolza.bands([(0, 0, 0, 0), (0, 0, 0, "x")])
    for name in ("steps", "count", "digits"):
        with pytest.raises(epsnet.ArgumentError, match=f"^{name}: "):
            bolza.bands([(0, 0, 0, 0)], **{name: 0})


def test_what_cannot_be_meant_is_an_error(bolza):
    for wrong in (0, 1001, 1.5):
        with pytest.raises(epsnet.ArgumentError, match="^count: "):
            bolza.eigenvalues(wrong)
    for wrong in (0, -1, 10001, float("nan"), "1e-1000"):
        with pytest.raises(epsnet.ArgumentError, match="^below: "):
            bolza.eigenvalues(below=wrong)
    with pytest.raises(epsnet.ArgumentError, match="^below: not together with count"):
        bolza.eigenvalues(3, below=4)
    for wrong in (0, 11):
        with pytest.raises(epsnet.ArgumentError, match="^digits: "):
            bolza.eigenvalues(digits=wrong)
