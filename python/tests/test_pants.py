"""Pants decompositions and Dehn twists."""
import pytest

from epsnet import ArgumentError, Surface, SurfaceError


def test_coordinates_are_read_back():
    lengths, twists = [1, 2.5, 3], [0.25, -0.5, 1]
    pants = Surface.fenchel_nielsen(lengths, twists, "0-0 0-1 1-1").pants()
    assert pants.own and pants.edges == [(0, 0), (0, 1), (1, 1)]
    for cuff, length, twist in zip(pants.cuffs, lengths, twists):
        assert abs(cuff.length.mid - length) < 1e-12 and abs(cuff.twist.mid - twist) < 1e-12
        assert cuff.length.proved and cuff.twist.proved and cuff.exp_half_length > 1
    assert repr(pants) == "<PantsDecomposition: 2 pairs of pants, 3 cuffs>"


def test_short_curves_and_given_ones(octagon):
    pants = octagon.pants()
    assert not pants.own and pants.lengths[0].overlaps(octagon.systole())
    again = octagon.pants([pants.cuffs[2], octagon.systole().geodesic])
    assert again.lengths[0] == pants.lengths[2] and again.lengths[1] == pants.lengths[0]
    with pytest.raises(ArgumentError, match="^curve 1: homotopic to curve 0"):
        octagon.pants([pants.cuffs[0].word, pants.cuffs[0]])
    with pytest.raises(ArgumentError, match="^curve 0: letter 0 is side 99"):
        octagon.pants([[99]])
    fed = pants.fenchel_nielsen()
    assert fed.pants().own and abs(fed.pants().twists[1].mid - pants.twists[1].mid) < 1e-12
    other = pants.fenchel_nielsen(twists=[0, 0, 0])
    assert [abs(round(twist.mid, 12)) for twist in other.pants().twists] == [0, 0, 0]


def test_dehn_twists(octagon):
    curve = octagon.pants().cuffs[0]
    start = octagon.dehn_twist(curve, 0)
    along = start.pants().cuffs[0]
    twisted = start.dehn_twist(along)
    assert twisted.isometric_to(octagon) is not None
    assert twisted.gluing == start.gluing and twisted != start
    images = start.dehn_twist_words(along)
    assert len(images) == sum(len(tile) for tile in start.tiles)
    # A word of the new surface stands for the image of the word.
    for generator in start.generators():
        image = [letter for side in generator.word for letter in images[side]]
        assert twisted.element(generator.word).translation_length.overlaps(start.element(image).translation_length)
    assert twisted.dehn_twist(along, -1).pants().lengths[0].overlaps(along.length)
    with pytest.raises(SurfaceError, match="rational"):
        Surface.regular(2).dehn_twist([0])
    assert len(Surface.regular(2).dehn_twist_words([0])) == 8
    with pytest.raises(ArgumentError, match="power"):
        octagon.dehn_twist(curve, 1001)
    with pytest.raises(ArgumentError, match="curve"):
        octagon.dehn_twist("1 2")


def test_the_flow_of_twists(octagon):
    cuff = octagon.pants().cuffs[0]
    here = octagon.twist(cuff, 0).pants()
    there = octagon.twist(cuff, "1/8").pants()
    assert abs(there.twists[0].mid - here.twists[0].mid - 0.125) < 1e-12
    assert abs(there.lengths[0].mid - here.lengths[0].mid) < 1e-12
