#!/usr/bin/env python3
"""verdict_sweep.py FOLDER-OF-PROGRAMS [OPTIONS]: what epsnet calls VERIFIED, plain `certify FILE` verifies.

Each row is a surface and a claim about it. epsnet makes the file; if it writes one, `certify FILE`, without options,
has to call it VERIFIED, and certify-exact must not refute it. The table of rows goes to standard output, a line for each,
with seconds of processor time and bytes; the exit code is 1 if a file is not verified, or if a program ends in a way that
it does not declare. With --quick: a few rows that take some seconds.
"""
import argparse
import collections
import json
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
arguments.add_argument("programs", help="the folder of epsnet, certify and certify-exact")
arguments.add_argument("--quick", action="store_true", help="only the rows that take some seconds together")
arguments.add_argument("--surfaces", default="", help="a regular expression: only these surfaces")
arguments.add_argument("--claims", default="", help="a regular expression: only these claims")
arguments.add_argument("--make-limit", type=int, default=60, help="seconds for epsnet [60]")
arguments.add_argument("--check-limit", type=int, default=60, help="seconds for each checker [60]")
arguments.add_argument("--jobs", type=int, default=1, help="rows at the same time [1]")
arguments.add_argument("--keep", help="a folder for the files that are not verified")
options = arguments.parse_args()

EPSNET, CERTIFY, EXACT = (os.path.join(os.path.abspath(options.programs), name)
                          for name in ("epsnet", "certify", "certify-exact"))
VERDICTS = {0: "VERIFIED", 1: "REFUTED", 2: "UNDECIDED", 3: "MALFORMED"}
TOO_LONG = "too long"

Run = collections.namedtuple("Run", "code seconds output errors")


def run(program, *command, limit):
    """Runs a program; the code is None if it takes more seconds of processor time than the limit."""
    limited = ["sh", "-c", 'ulimit -t "$0" && exec "$@"', str(limit), program, *command]
    with tempfile.TemporaryFile("w+") as output, tempfile.TemporaryFile("w+") as errors:
        with subprocess.Popen(limited, stdout=output, stderr=errors) as process:
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        errors.seek(0)
        code = None if process.returncode in (-signal.SIGKILL, -signal.SIGXCPU) else process.returncode
        return Run(code, usage.ru_utime + usage.ru_stime, output.read(), errors.read())


# Surfaces: by name, how epsnet makes them. A tuple is another surface, a list the name and the text of a file.

BOLZA_MATRICES = "\n".join(
    ["model su11"] + [f"1+sqrt(2) 0 sqrt(2+2*sqrt(2))*cos({k}*pi/4) sqrt(2+2*sqrt(2))*sin({k}*pi/4)" for k in range(4)])

SURFACES = {
    "bolza": ["named", "bolza"],
    "octagon-1": ["octagon", "--seed", "1"],
    "octagon-5": ["octagon", "--seed", "5"],
    "octagon-123": ["octagon", "--seed", "123"],
    **{f"random-{g}": ["fenchel-nielsen", "--genus", str(g), "--seed", "1"] for g in (2, 3, 5, 10, 20, 50)},
    "random-2-b": ["fenchel-nielsen", "--genus", "2", "--seed", "7"],
    **{f"thin-2-{x}": ["fenchel-nielsen", "--genus", "2", "--lengths", f"{x},1,2", "--seed", "1", "--pants-graph",
                       "0-1 0-1 0-1"]
       for x in ("1e-2", "1e-4", "1e-8", "1e-16", "1e-24")},
    **{f"dumbbell-{x}": ["fenchel-nielsen", "--pants-graph", "0-0 0-1 1-1", "--lengths", f"{x},{x},{x}", "--seed", "1"]
       for x in ("0.1", "0.011", "1e-4", "1e-8")},
    **{f"thin-{g}-{x}": ["fenchel-nielsen", "--genus", str(g), "--lengths", x, "--seed", "1"]
       for g, x in ((3, "0.1"), (3, "1e-4"), (5, "0.02"), (10, "0.1"), (10, "1e-6"), (20, "0.5"))},
    "far-twists": ["fenchel-nielsen", "--genus", "2", "--lengths", "1,1.5,2", "--twists", "1000,-30.25,7"],
    "klein": ["named", "klein"],
    "bring": ["named", "bring"],
    "fricke-macbeath": ["named", "fricke-macbeath"],
    "fermat-quartic": ["named", "fermat-quartic"],
    **{name: ["named", name] for name in ("wiman-5", "wiman-20", "accola-maclachlan-10", "accola-maclachlan-30",
                                          "accola-maclachlan-46", "R2.4", "R5.1", "R9.1", "R10.1")},
    **{f"regular-{g}": ["regular", "--genus", str(g)] for g in (5, 20, 50)},
    "cover-octagon-5": ["cover", ("octagon-5",), "--degree", "5", "--seed", "1"],
    "cover-bolza-3": ["cover", ("bolza",), "--degree", "3", "--seed", "2"],
    "cover-random-20": ["cover", ("random-2",), "--degree", "20", "--seed", "1"],
    "twisted-octagon": ["dehn-twist", ("octagon-5",), "--word", "a1^2 b1^-1 c1"],
    "twisted-thin": ["dehn-twist", ("thin-2-1e-4",), "--word", "a1 b1"],
    "twisted-random-3": ["dehn-twist", ("random-3",), "--word", "a1 b1 c1 b2^2"],
    "field-bolza": ["matrices", ["bolza.txt", BOLZA_MATRICES]],
    "irrational-theta": ["fenchel-nielsen", "--pants-graph", "theta", "--lengths", "2*arcosh(3/2)", "--twists", "0"],
}


def curve_words(surface, limit):
    """Returns words of closed curves: of the cuffs of a pants decomposition, and of the systole."""
    words = []
    for command in ("pants", "systole"):
        made = run(EPSNET, command, surface, "--json", limit=limit)
        if made.code != 0:
            continue
        report = json.loads(made.output)
        rows = report["cuffs"] if command == "pants" else report["geodesics"][:1]
        words += [",".join(map(str, row["word"])) for row in rows]
    return words


def spectrum_words(surface, limit):
    """Returns the words of the first 30 closed geodesics up to a length."""
    made = run(EPSNET, "spectrum", surface, "--up-to", "4", "--json", limit=limit)
    rows = json.loads(made.output)["geodesics"] if made.code == 0 else []
    return [",".join(map(str, row["word"])) for row in rows[:30]]


def phases(surface, limit):
    """Returns as many phases as the surface has pairs of generators."""
    made = run(EPSNET, "info", surface, "--json", limit=limit)
    genus = json.loads(made.output)["genus"]
    generator = random.Random(genus)
    return ",".join(f"{generator.randrange(12)}/12" for _ in range(2 * genus))


# Claims: by name, the command; a function gives arguments that depend on the surface.
CLAIMS = {
    "systole": ["systole"],
    "thick-thin": ["thick-thin"],
    "net-0.5": ["net", "--epsilon", "0.5"],
    "net-0.1": ["net", "--epsilon", "0.1"],
    "net-0.03": ["net", "--epsilon", "0.03"],
    "net-pseudo": ["net", "--epsilon", "0.3", "--pseudo"],
    "net-sparse": ["net", "--epsilon", "0.3", "--sparse"],
    "distance": ["distance", "0", "0,0.1,0.07"],
    "eccentricity": ["eccentricity", "0"],
    "pants": ["pants"],
    "pants-found": ["pants", "--find"],
    "curves": ["curves", curve_words],
    "curves-spectrum": ["curves", spectrum_words, "--angles"],
    "spectrum-3": ["spectrum", "--up-to", "3"],
    "spectrum-5": ["spectrum", "--up-to", "5"],
    "spectrum-7": ["spectrum", "--up-to", "7"],
    "isometries": ["isometries"],
    "isometric-itself": ["isometric", "SURFACE"],
    "isometric-no": ["isometric", ("octagon-1", "random-3", "random-5", "random-10")],
    "radius": ["radius"],
    "diameter-1e-3": ["diameter", "--width", "1e-3", "--ends", "ENDS"],
    "diameter": ["diameter"],
    "embedded-disk": ["embedded-disk"],
    "eigenvalues-1": ["eigenvalues", "--count", "4", "--digits", "1"],
    "eigenvalues-below": ["eigenvalues", "--below", "0.25"],
    "eigenvalues-phases": ["eigenvalues", "--count", "2", "--digits", "1", "--phases", phases],
    "eigenvalues-box": ["eigenvalues", "--count", "2", "--digits", "1", "--phases", phases, "--box", "1/100"],
    "eigenvalues-4": ["eigenvalues", "--count", "4", "--digits", "4"],
    "eigenvalues": ["eigenvalues"],
}

QUICK = [("bolza", "isometries"), ("octagon-5", "curves"), ("octagon-5", "pants"), ("random-2", "isometric-itself"),
         ("thin-2-1e-4", "systole"), ("thin-2-1e-8", "thick-thin"), ("random-10", "net-0.5"), ("bolza", "distance"),
         ("bolza", "eigenvalues-1"), ("bolza", "radius")]


class Sweep:
    def __init__(self, folder):
        self.folder = folder
        self.surfaces = {}
        self.failures = 0  # Of surfaces.

    def surface(self, name):
        """Returns the file of a surface, which is made when it is first asked for; None if it cannot be made."""
        if name not in self.surfaces:
            path = os.path.join(self.folder, name + ".surface.json")
            command = []
            for part in SURFACES[name]:
                if isinstance(part, tuple):
                    part = self.surface(part[0])
                elif isinstance(part, list):
                    text, (name_of_file, content) = os.path.join(self.folder, part[0]), part
                    with open(text, "w", encoding="utf-8") as file:
                        file.write(content + "\n")
                    part = text
                command.append(part)
            made = run(EPSNET, "surface", *command, "-o", path, limit=600)
            if made.code != 0:
                print(f"{name}: no surface: {made.errors.strip()}", flush=True)
                self.failures += 1
            self.surfaces[name] = path if made.code == 0 else None
        return self.surfaces[name]

    def command(self, claim, surface, ends):
        """Returns the command line; None if the claim has no arguments for this surface."""
        first, *rest = CLAIMS[claim]
        command = [first, surface]
        for part in rest:
            if part == "SURFACE":
                part = surface
            elif part == "ENDS":
                part = ends
            elif isinstance(part, tuple):
                genus = json.loads(run(EPSNET, "info", surface, "--json", limit=60).output)["genus"]
                others = [other for other in part if f"-{genus}" in other] or part[:1]
                part = self.surface(others[0])
            elif callable(part):
                found = part(surface, options.make_limit)
                if not found:
                    return None
                command += found if isinstance(found, list) else [found]
                continue
            command.append(part)
        return command

    def row(self, name, claim):
        """Returns the lines of a row, and what is wrong with it."""
        surface = self.surface(name)
        if surface is None:
            return [], []
        file = os.path.join(self.folder, f"{name}.{claim}.json")
        ends = os.path.join(self.folder, f"{name}.{claim}.ends.json")
        command = self.command(claim, surface, ends)
        if command is None:
            return [f"{name}\t{claim}\tno arguments"], []
        made = run(EPSNET, *command, "-o", file, limit=options.make_limit)
        says = TOO_LONG if made.code is None else (made.errors.strip().splitlines() or [""])[-1]
        if not os.path.exists(file):
            bad = [] if made.code in (None, 1, 2) else [f"{name} {claim}: epsnet ends with {made.code}: {says}"]
            return [f"{name}\t{claim}\tnot made\t{made.seconds:.1f}\t{made.code}: {says}"], bad
        lines, bad = [], []
        for path, what in ((file, claim), (ends, claim + " --ends")):
            if not os.path.exists(path):
                continue
            line, problem = self.check(name, what, path, made.seconds)
            lines.append(line)
            bad += problem
            os.remove(path)
        return lines, bad

    def check(self, name, claim, path, seconds):
        size = os.path.getsize(path)
        checked = run(CERTIFY, path, limit=options.check_limit)
        lines = checked.output.strip().splitlines() or [""]
        verdict = TOO_LONG if checked.code is None else VERDICTS.get(checked.code, f"code {checked.code}")
        second = next((line.split(": ", 1)[1] for line in lines if line.startswith("second checker: ")), "")
        work = next((line.split(": ", 1)[1] for line in lines if line.startswith("work: ")), "")
        share = int(work) / (15e9 + 8e3 * size) if work else 0
        exact = run(EXACT, path, limit=options.check_limit)
        exact_verdict = TOO_LONG if exact.code is None else VERDICTS.get(exact.code, f"code {exact.code}")
        line = (f"{name}\t{claim}\tmade {seconds:.1f} s\t{size} bytes\t{verdict} {checked.seconds:.1f} s, "
                f"{100 * share:.1f} % of the work\tsecond: {second}\texact: {exact_verdict} {exact.seconds:.1f} s")
        bad = []
        if verdict != "VERIFIED":
            bad.append(f"{name} {claim}: certify: {verdict}: {lines[-1]}")
        if exact_verdict not in ("VERIFIED", "UNDECIDED", TOO_LONG):
            bad.append(f"{name} {claim}: certify-exact: {exact_verdict}: {exact.output.strip()}")
        if bad and options.keep:
            shutil.copy(path, options.keep)
        if exact_verdict == "UNDECIDED":
            line += ": " + re.sub(r"^UNDECIDED: ", "", exact.output.strip())
        return line, bad


def main():
    rows = QUICK if options.quick else [(surface, claim) for claim in CLAIMS for surface in SURFACES]
    rows = [(surface, claim) for surface, claim in rows
            if re.search(options.surfaces, surface) and re.search(options.claims, claim)]
    if options.keep:
        os.makedirs(options.keep, exist_ok=True)
    problems = []
    with tempfile.TemporaryDirectory() as folder:
        sweep = Sweep(folder)
        for surface, _ in rows:
            sweep.surface(surface)
        with ThreadPoolExecutor(options.jobs) as workers:
            for lines, bad in workers.map(lambda row: sweep.row(*row), rows):
                for line in lines:
                    print(line, flush=True)
                for problem in bad:
                    print("DISAGREEMENT: " + problem, flush=True)
                problems += bad
    print(f"{len(rows)} rows, {len(problems)} disagreements")
    return 1 if problems or sweep.failures or not rows else 0


sys.exit(main())
