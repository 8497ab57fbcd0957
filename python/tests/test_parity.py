"""All that the program `epsnet` can do, the module can do: its commands and options, as --help lists them, by their names in Python."""
import inspect
import os
import pathlib
import re
import subprocess

import pytest

import epsnet
from epsnet import Net, Surface

ROWS = pathlib.Path(__file__).parents[2] / "cmake/help/rows.awk"

# Options that are other things in Python, or nothing, and why.
EVERYWHERE = {
    "--help": "help(epsnet)",
    "--json": "values are objects",
    "--progress": "progress=f of what takes long",
    "--output": "save, or what the method returns",
    "--svg": "svg of what the method returns",
    "--ends": "distance of what the method returns",
    "--no-certify": "the module hands out nothing that is not verified",
}
NOT_IN_PYTHON = {
    ("net", "--stats"): "Net.statistics",
    ("systole", "--epsilon"): "any gives the same geodesic",
    ("spectrum", "--epsilon"): "any gives the same list",
    ("thick-thin", "--epsilon"): "any gives the same list",
    ("local-maximum", "--epsilon"): "any gives the same list",
    ("curves", "--angles"): "Curve.angles",
    ("mapping-class", "--on"): "MappingClass is a function of curves",
    ("mapping-class", "--threads"): "isometries(threads=n)",
    ("surface dehn-twist", "--word"): "MappingClass.marking",
    ("export", "--model"): "Surface.matrices(model)",
    ("convert", "--surface"): "Surface.load(path).save",
    ("draw", "--eigenfunction"): "Eigenvalues.eigenfunction(index).svg",
    ("bands", "--keep"): "Surface.eigenvalues(phases=point).save",
    ("gap", "--keep"): "Surface.eigenvalues(below=x, phases=centre, box=radius).save",
    ("draw", "--png"): "a browser or a notebook shows SVG; the module does not link the library that the program draws with",
}
# Commands that are other things in Python, and what.
COMMANDS_NOT_IN_PYTHON = {"help": "help(epsnet)"}
# The function of a command, and its parameters that are called otherwise.
FUNCTIONS = {
    "surface octagon": (Surface.octagon, {"--coordinates": "half"}),
    "surface fenchel-nielsen": (Surface.fenchel_nielsen, {"--pants-graph": "graph", "--from": None}),
    "surface regular": (Surface.regular, {}),
    "surface named": (Surface.named, {"--list": None}),
    "surface map": (Surface.map, {}),
    "surface cover": (Surface.cover, {}),
    "surface dehn-twist": (Surface.dehn_twist, {}),
    "surface twist": (Surface.twist, {}),
    "surface matrices": (Surface.from_matrices, {}),
    "surface import": (Surface.load, {"--format": None}),
    "net": (Surface.net, {}),
    "import-net": (Net.of_tiles, {"--threads": None}),
    "dirichlet": (Surface.dirichlet_domain, {"--base": "p"}),
    "distance": (Surface.distance, {}),
    "locate": (Net.locate, {"--points": "p"}),
    "distances": (Net.distances, {"--from": "rows", "--to": "columns", "--bounds": None}),
    "eccentricity": (Surface.eccentricity, {}),
    "diameter": (Surface.diameter, {}),
    "radius": (Surface.radius, {}),
    "embedded-disk": (Surface.embedded_disk, {}),
    "systole": (Surface.systole, {}),
    "spectrum": (Surface.spectrum, {}),
    "thick-thin": (Surface.thick_thin, {}),
    "local-maximum": (Surface.local_maximum, {}),
    "eigenvalues": (Surface.eigenvalues, {}),
    "bands": (Surface.bands, {"--between": "path"}),
    "gap": (Surface.gap, {}),
    "lattice": (Surface.lattice, {}),
    "isometries": (Surface.isometries, {}),
    "isometric": (Surface.isometric_to, {}),
    "identify": (Surface.identify, {}),
    "pants": (Surface.pants, {}),
    "curves": (Surface.curves, {"--curves": "words"}),
    "mapping-class": (Surface.mapping_class, {}),
    "maximize systole": (Surface.maximize_systole, {}),
    "draw": (Net.svg, {"--show": ("triangles", "vertices", "dirichlet", "combinatorial_dirichlet", "tiles", "disks", "half_disks"),
                       "--geodesics": "show", "--distance": "show"}),
    "view": (Net.view, {"--geodesics": "show", "--distance": "show", "--threads": None}),
    "info": (Net.info, {}),
    "export": (Net.export, {}),
    "convert": (Net.save, {}),
}


def help_of(*command):
    program = os.environ.get("EPSNET_PROGRAM")
    if program is None:
        pytest.skip("EPSNET_PROGRAM is not set; ctest sets it")
    return subprocess.run([program, *command, "--help"], check=True, capture_output=True, text=True).stdout


def rows_of(text):
    """The rows (kind, head) of the text of --help, as the manual pages have them."""
    rows = subprocess.run(["awk", "-f", ROWS], input=text, check=True, capture_output=True, text=True).stdout
    return [tuple(line.split("\t")[:2]) for line in rows.splitlines()]


def commands_of(text):
    return [head for kind, head in rows_of(text) if kind == "subcommand"]


def options_of(text):
    """The first long name of each option."""
    return [re.search(r"--[a-z-]+", head)[0] for kind, head in rows_of(text) if kind == "option"]


def missing(command, options):
    """What the module does not have of a command."""
    if command not in FUNCTIONS:
        return [f"{command}: no function"]
    function, names = FUNCTIONS[command]
    parameters = inspect.signature(function).parameters
    found = []
    for option in options:
        if option in EVERYWHERE or (command, option) in NOT_IN_PYTHON:
            continue
        name = names.get(option, option[2:].replace("-", "_"))
        expected = [] if name is None else [name] if isinstance(name, str) else name
        found += [f"{command} {option}: {function.__qualname__} has no parameter {one}" for one in expected if one not in parameters]
    return found


def all_commands():
    for command in commands_of(help_of()):
        if command in COMMANDS_NOT_IN_PYTHON:
            continue
        inner = commands_of(help_of(command))
        yield from ([command, one] for one in inner) if inner else [[command]]


def test_nothing_is_missing():
    commands = list(all_commands())
    assert len(commands) >= 20
    problems = []
    for command in commands:
        options = options_of(help_of(*command))
        assert "--help" in options, command
        problems += missing(" ".join(command), options)
    assert not problems, "\n".join(problems)
    # The table has no rows of commands that are gone.
    assert set(FUNCTIONS) == {" ".join(command) for command in commands}
    assert all(option in help_of(*command.split()) for command, option in NOT_IN_PYTHON)


def test_choices_are_those_of_the_program(net, bolza):
    def values(command, option):
        heads = [head for kind, head in rows_of(help_of(*command.split())) if kind == "option"]
        return next(head.split()[1].split("|") for head in heads if option in re.split("[ ,]", head))

    names = {"bfs": "breadth first"}
    for colour in values("draw", "--colour"):
        assert net.svg(colour=colour)
    for order in values("draw", "--order"):
        assert net.svg(order=names.get(order, order))
    for form in values("export", "--format"):
        if form == "domain":
            assert net.surface.export(form)
        elif form == "matrices":
            assert net.surface.matrices()["relation"]
        else:
            assert (bolza.net("0.25") if form == "mfem" else net).export(form)  # MFEM knows edges by their ends.


def test_what_is_missing_is_named():
    assert missing("teleport", []) == ["teleport: no function"]
    assert missing("systole", ["--json", "--threads", "--faster"]) == ["systole --faster: Surface.systole has no parameter faster"]
    text = "A program.\n\nSubcommands:\n  one     the first\n  two     the other\n\nOptions:\n  -h,--help   x\n  --up-to L   y --not\n"
    assert commands_of(text) == ["one", "two"] and commands_of(text.replace("Subcommands", "Lengths and distances")) == ["one", "two"]
    assert options_of(text) == ["--help", "--up-to"]
