"""Isometries of a surface, and between two."""
import pytest

import epsnet
from epsnet import Surface


def test_groups_of_permutations(bolza):
    group = bolza.isometries()
    assert len(group) == 96 and sum(f.preserves_orientation for f in group) == 48 and group.name == ""
    identity = list(range(96))
    assert group.permutation(0) == identity and group.order(0) == 1 and group.fixed_points(0) is None
    for i in group.generators:
        power = identity
        for _ in range(group.order(i)):
            power = [group.permutation(i)[k] for k in power]
        assert power == identity
        for j in (1, 17, 95):
            product = group.permutation(group.product(i, j))
            assert product == [group.permutation(i)[k] for k in group.permutation(j)]


def test_proof(bolza, octagon, tmp_path):
    group = bolza.isometries()
    proof = group.proof
    assert proof.proved and proof is group.proof and group.certificate.verified
    assert (proof.order, proof.orientation_preserving) == (96, 48) and float(proof.up_to) == 4 and proof.surface == bolza
    assert "96" in group.certificate.claim
    path = str(tmp_path / "isometries.json")
    group.save(path)
    assert epsnet.certify(path).verdict == "VERIFIED"
    loaded = epsnet.load(path)
    assert loaded == proof and hash(loaded) == hash(proof) and repr(loaded) == repr(proof) and loaded.proved
    assert loaded.surface.isometries().proof == proof and loaded.net.surface == bolza
    assert "not proved" in repr(epsnet.load(path, check=False)) or epsnet.load(path, check=False).proved
    other = octagon.isometries().proof
    assert other != proof and (other.order, other.orientation_preserving) == (2, 2)


def test_sympy_knows_the_group(bolza):
    combinatorics = pytest.importorskip("sympy.combinatorics")
    group = bolza.isometries()
    known = combinatorics.PermutationGroup([combinatorics.Permutation(group.permutation(i)) for i in group.generators])
    assert known.order() == 96


def test_images_satisfy_the_relations(octagon):
    for isometry in octagon.isometries():
        polygon = octagon.fundamental_polygon()
        first = [k for k, side in enumerate(polygon.sides) if k < side.partner]
        image = {}
        for k, element in zip(first, isometry.images):
            image[k], image[polygon.sides[k].partner] = element, element.inverse()
        for relation in polygon.relations():
            product = octagon.element([])
            for k in relation:
                product = product * image[k]
            assert product.is_identity()


def test_isometric_surfaces(octagon, bolza):
    isometry = octagon.isometric_to(octagon)
    assert isometry.preserves_orientation and isometry == octagon.isometric_to(octagon) and "preserves" in repr(isometry)
    assert hash(isometry) == hash(octagon.isometric_to(octagon))
    assert octagon.isometric_to(bolza) is None and octagon.isometric_to(Surface.named("klein")) is None


def test_a_comparison_is_a_file(octagon, bolza, tmp_path):
    for other, isometric in ((octagon, True), (bolza, False)):
        comparison = octagon.compare(other)
        assert comparison.isometric == isometric and comparison.proved and comparison.other == other
        assert comparison.isometry == octagon.isometric_to(other)
        path = tmp_path / "comparison.json"
        comparison.save(path)
        loaded = epsnet.load(path)
        assert loaded == comparison and hash(loaded) == hash(comparison) and loaded.proved and repr(loaded) == repr(comparison)
        assert (loaded.surface, loaded.other, loaded.isometry) == (octagon, other, None)
        assert loaded.net.surface == octagon and loaded.other_net.surface == other
        assert epsnet.certify(path).verdict == "VERIFIED"


def test_surfaces_of_different_kinds_are_compared(bolza):
    # GL(2,3) as it permutes the eight vectors other than 0: octagons of which three meet at each vertex.
    x, y = (3, 7, 0, 4, 5, 1, 2, 6), (2, 5, 0, 3, 6, 1, 4, 7)
    elements = [tuple(range(8))]
    for g in elements:
        for h in (x, y):
            product = tuple(h[k] for k in g)
            if product not in elements:
                elements.append(product)
    rotation, edges = ([elements.index(tuple(h[k] for k in g)) for g in elements] for h in (x, y))
    octagons = Surface.map(rotation, edges)
    assert bolza.isometric_to(octagons) and octagons.isometric_to(bolza)


def test_undecided_is_not_no(octagon):
    # A twist by some 10⁻²⁰⁰, which the checker, with 512 bits, does not see: g W g⁻¹ = gC W (gC)⁻¹ for C = W + 10²⁰⁰.
    matrices = octagon.matrices()
    generators = [[[int(x) for x in row] for row in g] for g in matrices["generators"]]

    def product(f, g):
        return [[sum(f[i][k] * g[k][j] for k in range(2)) for j in range(2)] for i in range(2)]

    def inverse(f):
        (a, b), (c, d) = f
        return [[d, -b], [-c, a]]

    assert matrices["relation"] == [1, -2, 3, -4, -1, 2, -3, 4]
    w = product(product(inverse(generators[1]), generators[2]), inverse(generators[3]))
    size = 10**200 * max(abs(x) for row in w for x in row)
    near = [[w[0][0] + size, w[0][1]], [w[1][0], w[1][1] + size]]
    twisted = Surface.from_matrices([product(generators[0], near), *generators[1:]])
    with pytest.raises(epsnet.UndecidedError):
        octagon.isometric_to(twisted)
    with pytest.raises(epsnet.UndecidedError):
        octagon.compare(twisted)
