#!/usr/bin/env python3
"""finite_elements_test.py EPSNET PAGE RECIPE: runs a recipe of docs/finite-elements.md on the files that the page makes, and compares the
number that it prints. Exits with 77 where the program of the recipe is not installed.

RECIPE: the heading of its section.
"""
import importlib.util
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

LAMBDA = 3.8388872588  # Strohmaier and Uski: the first eigenvalue of Bolza's surface.

# By heading: what runs its block, as a file of that name; the number in what it prints; what that is to be.
RECIPES = {
    "FreeFEM": (["FreeFem++", "-nw", "-v", "0", "recipe.edp"], r"lambda_1 = (\S+)", LAMBDA),
    "FEniCSx": ([sys.executable, "recipe.py"], r"lambda_1 = (\S+)", LAMBDA),
    "Gmsh": (["gmsh", "recipe.geo", "-parse_and_exit"], r"integral = (\S+)", 4 * math.pi),
    "MFEM": (["./recipe"], r"lambda_1 = (\S+)", LAMBDA),
    "Without a library": ([sys.executable, "recipe.py"], r"lambda_1 = (\S+)", LAMBDA),
}
NEEDS = {"FEniCSx": ("dolfinx", "meshio", "scipy"), "Without a library": ("scipy",)}


def skip(message):
    print(f"skipped: {message}")
    sys.exit(77)


def printed(command):
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    assert result.returncode == 0, f"{command}: exit status {result.returncode}\n{result.stdout}"
    return result.stdout


def main(epsnet, page, recipe):
    command, pattern, expected = RECIPES[recipe]
    if recipe == "MFEM":
        if not os.path.exists("/usr/include/mfem.hpp"):
            skip("there is no /usr/include/mfem.hpp")
    elif shutil.which(command[0]) is None:
        skip(f"there is no {command[0]}")
    for module in NEEDS.get(recipe, ()):
        if importlib.util.find_spec(module) is None:
            skip(f"{sys.executable} has no module {module}")
    if recipe == "FEniCSx" and not printed([sys.executable, "-c", "import dolfinx; print(dolfinx.__version__)"]).startswith("0.5"):
        skip("the recipe is for dolfinx 0.5")
    with open(page, encoding="utf-8") as file:
        text = file.read()
    section = re.search(rf"^## {recipe}\n(.*?)(?=^## |\Z)", text, re.S | re.M)[1]
    block = re.search(r"^```\w+\n(.*?)^```$", section, re.S | re.M)[1]
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for line in re.findall(r"^    (epsnet [^#\n]*)", text, re.M):
            printed([epsnet, *line.split()[1:]])
        name = "recipe.cpp" if recipe == "MFEM" else next(word for word in command if word.startswith("recipe."))
        with open(name, "w", encoding="utf-8") as file:
            file.write(block)
        for line in re.findall(r"^    (mpicxx .*)", section, re.M):
            printed(line.split())
        output = printed(command)
        if recipe == "Gmsh":
            printed(["gmsh", "net.msh", "-refine", "-format", "msh41", "-o", "fine.msh"])
            with open("fine.msh", encoding="utf-8") as file:
                assert "$Periodic" in file.read(), "Gmsh does not know which sides are glued"
        os.chdir("/")
    assert not re.search(r"^(Error|Warning) ", output, re.M), output
    number = float(re.search(pattern, output)[1])
    assert abs(number / expected - 1) < 0.01, f"{number}, not {expected}"
    print(f"{number}: within 1 % of {expected}")


main(*sys.argv[1:])
