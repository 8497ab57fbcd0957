#!/usr/bin/env python3
"""samples_test.py BIN DOCUMENT...: runs the commands of the samples in the documents, and compares what they print.

A sample is a block (indented, or fenced by ```console) whose first line starts with "$ ". Lines with "$ " are run in a shell, those of one
document in one empty folder, with the folders BIN (separated by colons) first in PATH; the other lines are what they print, with standard
error. "…" at a line's end stands for its rest, alone on a line for any lines. How a sample came to its files is in a comment before it,
<!-- sample: COMMANDS -->, that is run before.
"""

import os
import re
import subprocess
import sys
import tempfile
import textwrap


def samples(text):
    """Yields (line, [command, ...]) of what is run silently, and (line, [command, output]) of the samples."""
    pattern = r"<!-- sample: (?P<before>.*?) -->|^```console\n(?P<fenced>.*?)^```$|(?P<indented>(?:^    [^\n]*\n|^\n(?=    ))+)"
    for match in re.finditer(pattern, text, re.MULTILINE | re.DOTALL):
        line = text.count("\n", 0, match.start()) + 1
        if match["before"] is not None:
            yield line, match["before"], None
            continue
        block = match["fenced"] or textwrap.dedent(match["indented"])
        if not block.lstrip("\n").startswith("$ "):
            continue
        for part in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]:
            command, _, output = part.partition("\n")
            yield line, command, output.rstrip("\n")


def matches(expected, actual):
    lines = [re.escape(line) for line in expected.split("\n")]
    lines = [r"(?:.*\n)*?" if line == "…" else re.sub("…$", ".*", line) + r"\n" for line in lines]
    return re.fullmatch("".join(lines) if expected else "", actual) is not None


def run(command, folder, binaries):
    path = binaries + os.pathsep + os.environ["PATH"]
    return subprocess.run(command, shell=True, cwd=folder, env={**os.environ, "PATH": path, "LC_ALL": "C.UTF-8"}, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def check(document, binaries):
    with open(document, encoding="utf-8") as file:
        text = file.read()
    compared, failed = 0, False
    with tempfile.TemporaryDirectory() as folder:
        for line, command, expected in samples(text):
            result = run(command, folder, binaries)
            if expected is None:
                if result.returncode != 0:
                    sys.exit(f"{document}:{line}: {command}: exit status {result.returncode}\n{result.stdout}")
                continue
            compared += 1
            if not matches(expected, result.stdout):
                print(f"{document}:{line}: $ {command}\nexpected:\n{expected}\nprinted:\n{result.stdout}")
                failed = True
    if compared == 0:
        sys.exit(f"{document}: no samples")
    return failed


if __name__ == "__main__":
    binaries = os.pathsep.join(map(os.path.abspath, sys.argv[1].split(os.pathsep)))
    sys.exit(1 if [document for document in sys.argv[2:] if check(document, binaries)] else 0)
