#!/usr/bin/env python3
"""lines_test.py ROOT: certify/lines accepts docs/trusted-base.md and notices each row that is wrong, missing or stray."""

import pathlib
import subprocess
import sys
import tempfile

root = pathlib.Path(sys.argv[1])
good = (root / "docs/trusted-base.md").read_text(encoding="utf-8").splitlines()
cases = []
failures = []


def said_of(paths):
    """The exit status of certify/lines, and what it prints."""
    run = subprocess.run([sys.executable, root / "certify/lines", *paths], capture_output=True, text=True)
    return run.returncode, run.stdout


def expect(what, lines, text):
    """A case: a text that certify/lines says of these lines."""
    cases.append((what, lines, text))


if said_of([root / "docs/trusted-base.md"]) != (0, ""):
    failures.append("the document is not accepted")
rows = [number for number, line in enumerate(good) if line.startswith("| ") and line.rstrip("| ")[-1:].isdigit()]
other = next(number for number, line in enumerate(good) if line.startswith("| relied on"))
if len(rows) < 20 or other in rows:
    failures.append(f"only {len(rows)} rows")
for number in rows:
    row = good[number]
    without = good[:number] + good[number + 1:]
    expect(f"without {row}", without, "not there once, as a whole")
    expect(f"one more in {row}", good[:number] + [row.rstrip("| ") + "1 |"] + good[number + 1:], "is a stray row")
    # In a table of something else: behind the tables, and instead of where it belongs.
    expect(f"twice {row}", good[:other + 1] + [row] + good[other + 1:], f"line {other + 2} is a stray row")
    expect(f"elsewhere {row}", without[:other] + [row] + without[other:], "not there once, as a whole")
expect("a row of a part that is none", good[:other] + ["| ghosts: nothing | 17 |"] + good[other:], "is a stray row")
expect("the tables twice", good + good, "not there once, as a whole")
expect("nothing", [], "not there once, as a whole")

with tempfile.TemporaryDirectory() as folder:
    paths = [pathlib.Path(folder) / f"{number}.md" for number in range(len(cases))]
    for path, (_, lines, _) in zip(paths, cases):
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    status, said = said_of(paths)
    if (status, said_of(paths[:1])[0]) != (1, 1):
        failures.append(f"status {status}, expected 1 for all and for the first alone")
    for path, (what, _, text) in zip(paths, cases):
        # What is said of a document: its name, and the problem, which may have several lines.
        problems = [part for part in said.split(f"{folder}/") if part.startswith(f"{path.name}: ")]
        if not any(text in problem for problem in problems):
            failures.append(f"{what}: {problems}")

print("\n".join(failures), end="\n" if failures else "")
sys.exit(bool(failures))
