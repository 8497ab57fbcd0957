"""The imports of the package run one way, also those for annotations alone (TYPE_CHECKING), but for those of `_annotations`."""
import ast
import graphlib
import os
import pathlib
import shutil
import subprocess
import sys

PACKAGE = pathlib.Path(__file__).parents[1] / "epsnet"


def imports_of(tree, annotations=False):
    """The modules of the package that a module imports when it runs, in functions, too; and those that it imports for annotations, if asked for."""
    found = set()
    waiting = [tree]
    while waiting:
        node = waiting.pop()
        if not annotations and isinstance(node, ast.If) and isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING":
            waiting += node.orelse
            continue
        if isinstance(node, ast.ImportFrom) and node.level == 1:
            found |= {node.module} if node.module else {alias.name for alias in node.names}
        waiting += ast.iter_child_nodes(node)
    return found


def order_of(sources):
    """The modules, each after those that it imports. CycleError names a circle."""
    imports = {name: imports_of(ast.parse(text), annotations=name != "_annotations") & set(sources) for name, text in sources.items()}
    return list(graphlib.TopologicalSorter(imports).static_order())


def test_there_is_no_circle():
    sources = {path.stem: path.read_text(encoding="utf-8") for path in PACKAGE.glob("*.py")}
    assert len(sources) > 10
    order = order_of(sources)
    # Whoever knows all the others comes last.
    assert order[-1] == "__init__" and order.index("nets") < order.index("geodesics") < order.index("surfaces") < order.index("files")


def test_a_circle_would_be_found():
    for text in ("from .b import x", "from . import b", "def f():\n    from .b import x", "if TYPE_CHECKING:\n    from .b import x"):
        try:
            order_of({"a": text, "b": "from .a import y"})
        except graphlib.CycleError:
            continue
        assert False, text
    assert order_of({"_annotations": "if TYPE_CHECKING:\n    from .b import x", "b": "from ._annotations import y"}) == ["_annotations", "b"]


def test_a_module_that_is_not_built_says_how_to_build_it(tmp_path):
    shutil.copytree(PACKAGE, tmp_path / "epsnet")
    result = subprocess.run([sys.executable, "-c", "import epsnet"], cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(tmp_path)}, capture_output=True, text=True)
    last = result.stderr.strip().splitlines()[-1]
    assert result.returncode == 1 and last.startswith("ImportError: epsnet's compiled module") and "./run python" in last and "circular" not in last.split("Python part")[1]
