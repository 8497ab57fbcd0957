"""Pictures and pages: well-formed, and of what they should be."""
import base64
import re
import warnings
import xml.etree.ElementTree as ElementTree

import pytest

import epsnet


def paths(svg):
    root = ElementTree.fromstring(svg)
    assert root.tag.endswith("svg")
    return svg.count("<path") + svg.count("<line") + svg.count("<circle")


def test_everything_shows_itself(octagon, bolza, pants, net):
    systole = octagon.systole()
    shown = [
        net, octagon, pants, bolza, octagon.fundamental_polygon(), bolza.dirichlet_domain(), octagon.dirichlet_domain((0, 0.1, 0.1)),
        systole, systole.geodesic, octagon.spectrum("3"), octagon.distance((0, 0.1, 0.3), (0, -0.25, -0.2)),
        octagon.diameter("0.1"), octagon.radius("0.1"), octagon.embedded_disk("0.1"), octagon.eccentricity(0),
        octagon.eigenvalues(1, digits=2), octagon.eigenvalues(1, digits=4).eigenfunction(1),
    ]
    for thing in shown:
        assert paths(thing._repr_mimebundle_()["image/svg+xml"]) > 1


def test_notebooks_become_pages_with_their_pictures(octagon):
    """Also where nbconvert removes SVG."""
    nbformat = pytest.importorskip("nbformat.v4")
    nbconvert = pytest.importorskip("nbconvert")
    output = nbformat.new_output("display_data", octagon._repr_mimebundle_())
    notebook = nbformat.new_notebook(cells=[nbformat.new_code_cell("octagon", outputs=[output])])
    page, _ = nbconvert.HTMLExporter(template_name="basic").from_notebook_node(notebook)
    source = re.search('<img alt="&lt;Surface octagon[^"]*" src="data:image/svg.xml;base64,([^"]+)"', page)
    assert source and base64.b64decode(source[1]).decode() == octagon.svg()


def test_options_change_the_picture(net):
    plain = net.svg()
    for option in (dict(dirichlet=True), dict(tiles=True), dict(colour="circumradius"), dict(legend=True, tiles=True), dict(centre=3), dict(size=300),
                   dict(triangles=False), dict(colour="distance"), dict(disks=True), dict(half_disks=True), dict(combinatorial_dirichlet=True),
                   dict(order="breadth first"), dict(colour="chart")):
        svg = net.svg(**option)
        ElementTree.fromstring(svg)
        assert svg != plain
    assert net.svg() == plain
    with pytest.raises(ValueError, match='"none", "circumradius", "chart" or "distance"'):
        net.svg(colour="red")
    with pytest.raises(epsnet.NetError):
        net.svg(centre=10**6)


def test_distances_are_colours(net):
    near, far = net.svg(colour="distance", legend=True), net.svg(colour="distance", legend=True, centre=17)
    assert "distance" in near and near != far and net.svg(colour="circumradius") != near


def test_thin_nets_are_drawn():
    surface = epsnet.Surface.fenchel_nielsen([1, "1e-8", 2], [0, 0, "0.5"], graph="0-0 0-1 1-1")
    net = surface.net("0.25", pseudo=True)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert paths(net.svg(tiles=True, dirichlet=True)) > 1
        assert "left out" not in net.view().html
        assert paths(surface.systole()._repr_mimebundle_()["image/svg+xml"]) > 1


def test_geodesics_are_drawn_on_nets(octagon, net):
    spectrum = octagon.spectrum("3")
    one, two, both = (net.svg(show=shown) for shown in ([spectrum[0]], [spectrum[1]], [spectrum]))
    assert len({net.svg(), one, two, both}) == 4
    assert net.svg(show=[octagon.distance((0, 0.1, 0.3), (0, -0.25, -0.2)), octagon.systole()]) != net.svg()
    with pytest.raises(epsnet.NetError, match="surface"):
        net.svg(show=[epsnet.Surface.octagon(1).systole()])


def test_the_page(tmp_path, net, octagon):
    page = net.view("A title & more", show=[octagon.spectrum("3")])
    assert "VERIFIED" in page.html and "A title &amp; more" in page.html and "<iframe srcdoc=" in page._repr_html_()
    assert re.search(r'"distances": "[A-Za-z0-9+/]', page.html)  # As a colouring.
    page.save(tmp_path / "view.html")
    assert (tmp_path / "view.html").read_text(encoding="utf-8") == page.html
    # What is between the quotation marks of the frame is the page again.
    import html

    assert html.unescape(re.search(r'srcdoc="([^"]*)"', page._repr_html_()).group(1)) == page.html
