"""Eigenvalues of the Laplacian."""
import pytest

import epsnet

# A. Strohmaier, V. Uski, arXiv:1110.2150.
BOLZA = [(3, 3.8388872588421995), (4, 5.353601341189)]


def test_of_the_bolza_surface_are_those_of_the_literature(bolza):
    found = bolza.eigenvalues(9, count=7)
    assert found.proved and found.up_to == "9" and len(found) == 2 and found.bound > 7
    for window, (count, value) in zip(found, BOLZA):
        assert window.least == window.most == count
        assert window.interval.lower == window.smallest.lower < value < window.greatest.upper == window.interval.upper
        assert window.greatest.lower < value < window.smallest.upper


def test_a_simple_one_is_in_both_enclosures():
    (window,) = epsnet.Surface.octagon(seed=5).eigenvalues(8)
    assert (window.least, window.most) == (1, 1) and window.interval.ends == (window.greatest.lower, window.smallest.upper)


def test_of_a_file_are_the_same(bolza, tmp_path):
    found = bolza.eigenvalues(9, count=3)
    path = str(tmp_path / "eigenvalues.json")
    found.save(path)
    loaded = epsnet.load(path)
    assert loaded == found and hash(loaded) == hash(found) and loaded[:] == found[:] and repr(loaded) == repr(found)
    assert not epsnet.load(path, check=False)[0].interval.proved


def test_what_cannot_be_said_is_an_error(bolza):
    with pytest.raises(epsnet.NetError, match="nothing can be said"):
        bolza.eigenvalues(1)
    with pytest.raises(epsnet.ArgumentError, match="at most 30"):
        bolza.eigenvalues(31)
