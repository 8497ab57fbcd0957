"""Meshes for other programs, as those programs read them."""
import json

import numpy as np
import pytest

import epsnet


def angles(corners):
    turns = (np.roll(corners, -2, axis=1) - corners) / (np.roll(corners, -1, axis=1) - corners)
    return np.angle(turns)


def test_centred_corners_have_no_small_angles(net):
    z = net.centred_corners
    assert np.allclose(abs(z), np.tanh(net.circumradii / 2)[:, None])
    least = np.arcsin(1 / (2 * np.cosh(0.25 / 2)))
    assert angles(z).min() >= least - 1e-12 and np.allclose(angles(z).sum(axis=1), np.pi)
    u, v = z, np.roll(z, -1, axis=1)
    lengths = 2 * np.arcsinh(abs(u - v) / np.sqrt((1 - abs(u) ** 2) * (1 - abs(v) ** 2)))
    assert np.allclose(lengths.reshape(-1)[net.edge_darts], net.edge_lengths)


@pytest.mark.parametrize("format, name", [("gmsh-glued", "net.msh"), ("vtu", "net.vtu")])
def test_meshio_reads_the_glued_mesh(tmp_path, net, format, name):
    meshio = pytest.importorskip("meshio")
    net.export(format, tmp_path / name)
    mesh = meshio.read(tmp_path / name)
    (cells,) = mesh.cells
    assert cells.type == "triangle"
    if format == "gmsh-glued":
        assert len(mesh.points) == len(net) and (cells.data == net.triangles).all()
    else:
        assert (mesh.cell_data["vertices"][0] == net.triangles).all()
        assert (mesh.point_data["vertex"][cells.data] == net.triangles).all()
    corners = mesh.cell_data["corners"][0].reshape(-1, 3, 3)
    assert np.allclose(corners[:, :, 0] + 1j * corners[:, :, 1], net.centred_corners) and (corners[:, :, 2] == 0).all()
    assert np.allclose(np.ravel(mesh.cell_data["circumradius"][0]), net.circumradii)


def test_meshio_reads_the_planar_mesh(tmp_path, net):
    meshio = pytest.importorskip("meshio")
    net.export("gmsh", tmp_path / "net.msh")
    mesh = meshio.read(tmp_path / "net.msh")
    triangles, vertex = mesh.cells_dict["triangle"], mesh.point_data["vertex"].astype(int)
    assert (vertex[triangles] == net.triangles).all()
    x, y = mesh.points.T[:2]
    assert np.allclose(mesh.point_data["weight"], 4 / (1 - x**2 - y**2) ** 2)
    a, b, c = (x + 1j * y)[triangles].T
    assert (((b - a).conj() * (c - a)).imag > 0).all()
    lines = mesh.cells_dict["line"]
    ends = [tuple(sorted(vertex[line])) for line in lines]
    assert ends and all(ends.count(pair) % 2 == 0 for pair in ends)
    # FreeFEM's file has the same triangles.
    net.export("medit", tmp_path / "net.mesh")
    medit = meshio.read(tmp_path / "net.mesh")
    assert np.allclose(medit.points[medit.cells_dict["triangle"]], mesh.points[triangles][:, :, :2])
    assert (medit.point_data["medit:ref"][medit.cells_dict["triangle"]] == net.triangles + 1).all()


def test_formats(net, tmp_path):
    assert net.export("edges").startswith(b"u\tv\tlength\n") and net.export("off").startswith(b"OFF\n")
    assert net.export("json", tmp_path / "mesh.json") is None and (tmp_path / "mesh.json").read_bytes() == net.export("json")
    with pytest.raises(epsnet.ArgumentError, match='"gmsh", "gmsh-glued", "medit"'):
        net.export("stl")
    with pytest.raises(epsnet.FileError):
        net.export("off", tmp_path)


def test_distances_are_data_at_points(tmp_path, net):
    meshio = pytest.importorskip("meshio")
    net.export("vtu", tmp_path / "net.vtu", distance_from=17)
    mesh = meshio.read(tmp_path / "net.vtu")
    expected = net.distances(17).mid[0]
    assert np.allclose(mesh.point_data["distance"], expected[mesh.point_data["vertex"]]) and expected[17] == 0 < expected.max()
    assert "distance" not in meshio.read(tmp_path / "net.vtu").cell_data and b"distance" not in net.export("vtu")


@pytest.mark.parametrize(
    "surface", [epsnet.Surface.octagon(123), epsnet.Surface.fenchel_nielsen(genus=3, seed=5), epsnet.Surface.regular(2), epsnet.Surface.regular(5)]
)
def test_the_json_mesh_is_the_net_with_its_gluing(surface):
    net = surface.net("0.3")
    mesh = json.loads(net.export("json"))
    points = np.array([complex(x, y) for x, y, vertex in mesh["points"]])
    faces = np.array(mesh["triangles"])
    assert (np.array([vertex for x, y, vertex in mesh["points"]])[faces] == net.triangles).all()
    assert np.allclose(mesh["circumradii"], net.circumradii) and (np.array(mesh["opposite"]) == net.opposite).all()
    assert (np.array(mesh["corner_labels"]) == net.corner_labels).all()
    assert [label["word"] for label in mesh["labels"]] == [[]] + [word for _, _, word in net.labels]

    def ends(dart):
        return points[faces[dart // 3, dart % 3]], points[faces[dart // 3, (dart + 1) % 3]]

    assert mesh["pairings"]
    for dart, other, ax, ay, bx, by in mesh["pairings"]:
        a, b = complex(ax, ay), complex(bx, by)
        (start, end), (start2, end2) = ends(dart), ends(other)
        moved = [(a * z + b) / (b.conjugate() * z + a.conjugate()) for z in (start2, end2)]
        assert abs(a) ** 2 - abs(b) ** 2 == pytest.approx(1, rel=1e-6) and np.allclose(moved, [end, start], atol=1e-6)
    # Labels take corners to the chart of corner 0.
    for t in range(0, len(net.triangles), 7):
        for corner, label in enumerate(net.corner_labels[t], 1):
            ax, ay, bx, by = mesh["labels"][label]["isometry"]
            z = net.vertices[net.triangles[t, corner]]
            a, b = complex(ax, ay), complex(bx, by)
            assert (a * z + b) / (b.conjugate() * z + a.conjugate()) == pytest.approx(net.corners[t, corner])
