"""Eigenvalues of the Laplacian."""
import xml.etree.ElementTree as ElementTree

import pytest

import epsnet

# A. Strohmaier, V. Uski, arXiv:1110.2150.
BOLZA = [(3, 3.8388872588421995), (4, 5.353601341189)]


@pytest.fixture(scope="module")
def found(bolza):
    """The first seven of the Bolza surface, with eigenfunctions: ten seconds."""
    return bolza.eigenvalues(9, count=7)


def test_of_the_bolza_surface_are_those_of_the_literature(found):
    assert found.proved and found.up_to == "9" and len(found) == 2 and found.bound > 7
    for window, (count, value) in zip(found, BOLZA):
        assert window.least == window.most == count
        assert window.interval.lower == window.smallest.lower < value < window.greatest.upper == window.interval.upper
        assert window.greatest.lower < value < window.smallest.upper


def test_a_simple_one_is_in_both_enclosures(data):
    (window,) = epsnet.load(str(data / "eigenvalues/octagon-5-to-8-digits.json"))
    assert (window.least, window.most) == (1, 1) and window.interval.ends == (window.greatest.lower, window.smallest.upper)


def test_a_width_is_reached_or_an_error():
    octagon = epsnet.Surface.octagon(seed=5)
    (window,) = octagon.eigenvalues(width="0.1", count=1, fast=True)
    assert window.interval.width < 0.1 and window.least == window.most == 1
    with pytest.raises(epsnet.NetError, match="at most 8.5, expected 0.03"):
        octagon.eigenvalues("8.5", count=1, width=0.03, fast=True)
    for wrong in (0, -1, float("nan")):
        with pytest.raises(epsnet.ArgumentError):
            octagon.eigenvalues(width=wrong)
        with pytest.raises(epsnet.ArgumentError):
            octagon.eigenvalues(time=wrong)


def test_a_time_is_for_longer_and_longer_geodesics():
    assert epsnet.Surface.octagon(seed=5).eigenvalues(7, time=1000, fast=True).up_to == "7"


def test_of_a_file_are_the_same(found, tmp_path):
    path = str(tmp_path / "eigenvalues.json")
    found.save(path)
    loaded = epsnet.load(path)
    assert loaded == found and hash(loaded) == hash(found) and loaded[:] == found[:] and repr(loaded) == repr(found)
    assert not epsnet.load(path, check=False)[0].interval.proved


def test_few_geodesics_bound_the_first_one(bolza):
    (window,) = bolza.eigenvalues(1, fast=True)
    assert window.interval.lower == 0 and window.least == 1 < window.most and window.interval.upper > BOLZA[0][1]


def test_the_picture_has_a_band_for_each_window(found):
    root = ElementTree.fromstring(found.svg(700))
    assert (root.get("width"), root.get("height")) == ("700", "434")
    bands = next(group for group in root if group.get("class") == "windows")
    assert len(bands) == len(found)
    assert found._repr_svg_() == found.svg() != found.svg(700)
    with pytest.raises(epsnet.ArgumentError):
        found.svg(1)


def test_what_cannot_be_said_is_an_error(bolza):
    with pytest.raises(epsnet.NetError, match="nothing can be said.*a length of 1 or more"):
        bolza.eigenvalues("1e-3")
    with pytest.raises(epsnet.ArgumentError, match="at most 30"):
        bolza.eigenvalues(31)
