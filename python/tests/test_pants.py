"""Pants decompositions and Dehn twists."""
import json
import pathlib
import pickle

import pytest

import epsnet
from epsnet import ArgumentError, FormatError, NotVerifiedError, PantsDecomposition, Surface, SurfaceError

DATA = pathlib.Path(__file__).parents[2] / "tests/data/pants"


def test_coordinates_are_read_back():
    lengths, twists = [1, 2.5, 3], [0.25, -0.5, 1]
    pants = Surface.fenchel_nielsen(lengths, twists, "0-0 0-1 1-1").pants()
    assert pants.own and pants.edges == [(0, 0), (0, 1), (1, 1)]
    for cuff, length, twist in zip(pants.cuffs, lengths, twists):
        assert abs(cuff.length.mid - length) < 1e-12 and abs(cuff.twist.mid - twist) < 1e-12
        assert cuff.length.proved and cuff.twist.proved and cuff.exp_half_length > 1
    assert repr(pants) == "<PantsDecomposition: 2 pairs of pants, 3 cuffs>"


def test_proof(octagon, bolza, tmp_path):
    found = octagon.pants()
    assert found.proved and found.certificate.verified and found.surface is octagon and found.net.surface == octagon
    assert [rule.name for rule in found.certificate.rules][-4:] == ["pants", "glued", "lengths", "twists"]
    path = tmp_path / "pants.json"
    found.save(path)
    assert epsnet.certify(path).verdict == "VERIFIED" and str(epsnet.certify(path)) == str(found.certificate)
    loaded = epsnet.load(path)
    assert isinstance(loaded, PantsDecomposition) and loaded.proved and loaded == found and hash(loaded) == hash(found)
    assert repr(loaded) == repr(found) and found.own is False and loaded.own is None
    assert loaded.surface == octagon and loaded.pants == found.pants and loaded.edges == found.edges and loaded.cuffs == found.cuffs
    assert [str(x) for x in loaded.lengths + loaded.twists] == [str(x) for x in found.lengths + found.twists]
    assert loaded.fenchel_nielsen() == found.fenchel_nielsen()
    assert found != bolza.pants() and found.cuffs[0] != found.cuffs[1] and found.cuffs[0] != 0
    assert all(curve.word == loaded.pants[p][k] for curve in loaded.cuffs for p, k in curve.ends[:1])
    with pytest.raises(ArgumentError, match="only nets have a compact form"):
        found.save(tmp_path / "pants.epsn")


def test_what_is_not_checked_is_not_proved(octagon, tmp_path):
    path = DATA / "octagon-5.json"
    loose = epsnet.load(path, check=False)
    assert not loose.proved and not loose.cuffs[0].length.proved and "not proved" in repr(loose) and "not proved" in repr(loose.cuffs[0])
    assert loose.certificate.verified and loose.proved and loose.lengths[0].proved and loose.cuffs[0].twist.proved
    found = octagon.pants()
    again, cuff = pickle.loads(pickle.dumps((found, found.cuffs[1])))
    assert not again.proved and again == found and again.own is False and cuff == found.cuffs[1] and cuff.word == found.cuffs[1].word


def test_false_files(tmp_path):
    document = json.loads((DATA / "octagon-5.json").read_text())
    path = tmp_path / "pants.json"

    def write(**changes):
        path.write_text(json.dumps({**document, **changes}))

    row = document["cuffs"][0]
    write(cuffs=[{**row, "length": [x + 1 for x in row["length"]]}, *document["cuffs"][1:]])
    assert epsnet.certify(path).rule == "lengths"
    with pytest.raises(NotVerifiedError, match="lengths") as caught:
        epsnet.load(path)
    assert caught.value.certificate.verdict == "REFUTED"
    for problem, changes in (("expected three for two", {"pants": document["pants"][:1]}), ("999", {"pants": [[[999], [0]], *document["pants"][1:]]})):
        write(**changes)
        with pytest.raises(FormatError, match=problem):
            epsnet.load(path, check=False)
    write(cuffs=[{**row, "ends": [[0, 0]]}, *document["cuffs"][1:]])
    with pytest.raises(FormatError, match="ends"):
        epsnet.load(path, check=False)


def test_marks_need_cuffs_in_order(tmp_path):
    # The same pants, their cuffs in another order: true, and no coordinates of a graph.
    document = json.loads((DATA / "octagon-5.json").read_text())
    document["cuffs"].reverse()
    path = tmp_path / "pants.json"
    path.write_text(json.dumps(document))
    other = epsnet.load(path)
    assert other.proved
    with pytest.raises(ArgumentError, match=r"^cuffs\[0\]: cuffs of a pair of pants are not in the order 0, 1, 2$"):
        other.fenchel_nielsen()


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


def test_twists_in_a_marking_are_real_numbers():
    surface = Surface.octagon(5).mapping_class("a1 A1").marking()     # In triangles, whose gluing a twist keeps.
    pants = surface.pants()
    cuff = pants.cuffs[0]
    marked = surface.dehn_twist(cuff, -4).pants(marking=pants)
    assert marked.proved and marked.cuffs[0].length.mid == pytest.approx(cuff.length.mid, abs=1e-12)
    assert marked.cuffs[0].twist.mid == pytest.approx(cuff.twist.mid - 4 * cuff.length.mid, abs=1e-10)
    assert [one.twist.mid for one in marked.cuffs[1:]] == pytest.approx([one.twist.mid for one in pants.cuffs[1:]], abs=1e-10)
    with pytest.raises(SurfaceError, match="other tiles"):
        Surface.octagon(5).pants(marking=pants)
    with pytest.raises(ArgumentError, match="marking"):
        surface.pants(marking=7)
    with pytest.raises(ArgumentError, match="the curves are those of the marking"):
        surface.pants([cuff], marking=pants)
