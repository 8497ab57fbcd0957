"""Closed geodesics: lengths, words, matrices, multiplicities."""
import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import epsnet
from epsnet import Surface


def length_of(isometry):
    """In an interval, by cosh(l/2) = |trace|/2, from a matrix in intervals."""
    matrix = isometry.sl2r()
    low, high = (abs(x) for x in (matrix[0][0].lower + matrix[1][1].lower, matrix[0][0].upper + matrix[1][1].upper))
    return 2 * math.acosh(min(low, high) / 2), 2 * math.acosh(max(low, high) / 2)


def test_the_systole_of_the_bolza_surface(bolza):
    systole = bolza.systole()
    # 2 arcosh(1 + √2), Jenni 1984.
    assert 2 * math.acosh(1 + math.sqrt(2)) in systole and systole.width < 1e-15 and systole.proved
    assert systole.certificate.verified and systole.geodesic.simple and systole.geodesic.length == epsnet.Interval(*systole.ends)


def test_words_and_matrices_have_these_lengths(octagon, bolza, pants):
    for surface, up_to in ((octagon, "3"), (bolza, "4.9"), (pants, "3")):
        spectrum = surface.spectrum(up_to)
        assert len(spectrum) > 1 and spectrum.proved
        for geodesic in spectrum:
            low, high = length_of(geodesic.isometry)
            assert low - 1e-9 <= geodesic.length.mid <= high + 1e-9


def test_the_spectrum_of_the_bolza_surface(bolza):
    multiplicities = bolza.spectrum("6.7").multiplicities()
    # 4 cosh²(l/2) = (m + n√2)²; Aurich and Steiner's table counts both orientations: 24, 24, 48, 96.
    assert [m.count for m in multiplicities] == [12, 12, 24, 48] and all(m.equal for m in multiplicities)
    for m, (whole, root) in zip(multiplicities, [(1, 1), (3, 2), (5, 3), (7, 5)]):
        assert 2 * math.acosh(whole + root * math.sqrt(2)) == pytest.approx(m.length.mid, abs=1e-12)


def test_a_spectrum_is_a_sequence(octagon):
    spectrum = octagon.spectrum("3")
    assert list(spectrum) == [spectrum[k] for k in range(len(spectrum))] and spectrum[-1] is spectrum[len(spectrum) - 1]
    assert [g.number for g in spectrum[1:3]] == [1, 2] and spectrum[0] in spectrum
    lengths = [g.length.mid for g in spectrum]
    assert lengths == sorted(lengths)
    assert sum(m.count for m in spectrum.multiplicities()) == len(spectrum)


def test_columns_are_arrays(bolza):
    spectrum = bolza.spectrum("6.7")
    assert spectrum.lengths.shape == (len(spectrum), 2) and (spectrum.lengths == epsnet.ends(g.length for g in spectrum)).all()
    groups = spectrum.multiplicities()
    assert groups.counts.tolist() == [12, 12, 24, 48] and groups.equal.all() and groups.lengths.shape == (4, 2)
    assert (groups.lengths[:, 0] <= spectrum.lengths[[0, 12, 24, 48], 0]).all() and (np.diff(groups.lengths.ravel()) > 0).all()
    assert bolza.spectrum(1).lengths.shape == (0, 2) and bolza.spectrum(1).multiplicities().counts.shape == (0,)


def test_small_curves_and_pieces():
    thin = Surface.fenchel_nielsen([1, "1/100", 2], 0, [(0, 0), (0, 1), (1, 1)]).thick_thin()
    assert thin.proved and thin[0].simple and 0.01 in epsnet.Interval(thin[0].length.lower - 1e-12, thin[0].length.upper + 1e-12)
    # cosh w = coth(l/2)
    assert thin[0].collar_half_width.mid == pytest.approx(math.asinh(1 / math.sinh(0.005)))
    assert sum(2 - 2 * piece.genus - len(piece.boundaries) for piece in thin.pieces) == -2


def test_files(tmp_path, bolza, octagon):
    path = tmp_path / "g.json"
    bolza.systole().save(path)
    assert isinstance(epsnet.load(path), epsnet.Systole) and epsnet.load(path) == bolza.systole()
    spectrum = octagon.spectrum("3")
    spectrum.save(path)
    loaded = epsnet.load(path)
    assert [g.length for g in loaded] == [g.length for g in spectrum] and loaded.proved and loaded.surface == octagon
    loaded = epsnet.load(path, check=False)
    assert not loaded.proved and not loaded[0].length.proved and not any(m.equal for m in loaded.multiplicities())
    text = path.read_text()
    path.write_text(text.replace('"simple":true', '"simple":false', 1))
    assert text != path.read_text()
    with pytest.raises(epsnet.NotVerifiedError) as caught:
        epsnet.load(path)
    assert caught.value.place == "simple"


@pytest.mark.parametrize("up_to", ["0", "-2", "two", float("inf")])
def test_lengths_are_lengths(octagon, up_to):
    with pytest.raises(epsnet.ArgumentError):
        octagon.spectrum(up_to)


def test_what_is_too_long_is_refused(octagon):
    with pytest.raises(epsnet.NetError, match="more than the limit"):
        octagon.spectrum(40)


@settings(max_examples=10)
@given(st.integers(0, 10**6))
def test_the_systole_is_the_start_of_the_spectrum(seed):
    surface = Surface.octagon(seed)
    systole = surface.systole()
    assert systole.lower > 0
    spectrum = surface.spectrum(math.nextafter(systole.upper, math.inf))
    assert len(spectrum) >= 1 and spectrum[0].length.overlaps(systole)
