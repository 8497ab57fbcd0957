#!/usr/bin/env python3
"""lines_test.py ROOT: certify/lines accepts docs/trusted-base.md and notices each row that is wrong, missing or stray."""

import pathlib
import subprocess
import sys
import tempfile

root = pathlib.Path(sys.argv[1])
good = (root / "docs/trusted-base.md").read_text(encoding="utf-8").splitlines()
failures = []


def said_of(lines):
    """The exit status of certify/lines, and what it prints."""
    with tempfile.NamedTemporaryFile("w", encoding="utf-8", suffix=".md") as file:
        file.write("\n".join(lines) + "\n")
        file.flush()
        run = subprocess.run([sys.executable, root / "certify/lines", file.name], capture_output=True, text=True)
        return run.returncode, run.stdout


def expect(what, lines, code, text=""):
    found = said_of(lines)
    if found[0] != code or text not in found[1]:
        failures.append(f"{what}: status {found[0]}, {found[1]!r}")


expect("the document", good, 0)
rows = [number for number, line in enumerate(good) if line.startswith("| ") and line.rstrip("| ")[-1:].isdigit()]
other = next(number for number, line in enumerate(good) if line.startswith("| relied on"))
if len(rows) < 20 or other in rows:
    failures.append(f"only {len(rows)} rows")
for number in rows:
    row = good[number]
    without = good[:number] + good[number + 1:]
    expect(f"without {row}", without, 1, "not there once, as a whole")
    expect(f"one more in {row}", good[:number] + [row.rstrip("| ") + "1 |"] + good[number + 1:], 1, "is a stray row")
    # In a table of something else: behind the tables, and instead of where it belongs.
    expect(f"twice {row}", good[:other + 1] + [row] + good[other + 1:], 1, f"line {other + 2} is a stray row")
    expect(f"elsewhere {row}", without[:other] + [row] + without[other:], 1, "not there once, as a whole")
expect("a row of a part that is none", good[:other] + ["| ghosts: nothing | 17 |"] + good[other:], 1, "is a stray row")
expect("the tables twice", good + good, 1)
expect("nothing", [], 1)

print("\n".join(failures), end="\n" if failures else "")
sys.exit(bool(failures))
