"""The stub of the extension module names everything in it, and nothing else."""
import ast
import pathlib

from epsnet import _epsnet

STUB = pathlib.Path(__file__).parents[1] / "epsnet/_epsnet.pyi"


def public(names):
    return {name for name in names if not name.startswith("_")}


def members(classes, name):
    """The names of a class of the stub, with those of its bases."""
    found = {node.name if isinstance(node, ast.FunctionDef) else node.target.id for node in classes[name].body
             if isinstance(node, (ast.FunctionDef, ast.AnnAssign))}
    return found.union(*(members(classes, base.id) for base in classes[name].bases))


def test_the_stub_is_complete():
    body = ast.parse(STUB.read_text(encoding="utf-8")).body
    classes = {node.name: node for node in body if isinstance(node, ast.ClassDef)}
    others = {node.name for node in body if isinstance(node, ast.FunctionDef)} | {node.target.id for node in body if isinstance(node, ast.AnnAssign)}
    assert public(classes) | public(others) == public(dir(_epsnet))
    for name in public(classes):
        assert public(members(classes, name)) == public(dir(getattr(_epsnet, name))), name
