#!/usr/bin/env python3
"""coverage_table.py LINES BRANCHES MISSING: the table of .ci/coverage from what llvm-cov exports, on standard input.

A branch is one of the two outcomes of a condition in the source. What several instances of a template, or several
programs, run through counts once. Fails below so many per cent of lines or branches; with MISSING = yes every outcome
that never came is listed first, and every line in which something begins that was never run.
"""
import collections
import json
import os
import sys


def outcomes(file):
    """{(line, column, end line, end column, outcome): how often}."""
    counts = collections.Counter()
    for line, column, end_line, end_column, yes, no, *_ in file.get("branches", []):
        counts[line, column, end_line, end_column, True] += yes
        counts[line, column, end_line, end_column, False] += no
    return counts


def lines_not_run(file):
    """Those in which something begins that was never run."""
    return sorted({line for line, _, count, has_count, is_entry, *_ in file["segments"] if has_count and is_entry and count == 0})


def row(name, lines, line, branches, branch):
    share = [100 * part / whole if whole else 100 for part, whole in ((line, lines), (branch, branches))]
    print(f"{name:44} {line:5} of {lines:5} lines {share[0]:6.1f} %   {branch:5} of {branches:5} branches {share[1]:6.1f} %")
    return share


def main():
    least_lines, least_branches, missing = float(sys.argv[1]), float(sys.argv[2]), sys.argv[3] == "yes"
    rows = []
    for file in sorted(json.load(sys.stdin)["data"][0]["files"], key=lambda file: file["filename"]):
        name = os.path.relpath(file["filename"])
        if not name.startswith("certify/"):
            continue
        counts = outcomes(file)
        if missing:
            with open(name, encoding="utf-8") as source:
                text = source.read().split("\n")
            for line, column, end_line, end_column, outcome in sorted(place for place in counts if counts[place] == 0):
                condition = text[line - 1][column - 1 : end_column - 1 if end_line == line else None]
                print(f"{name}:{line}: never {outcome}: {condition}")
            for line in lines_not_run(file):
                print(f"{name}:{line}: not run: {text[line - 1].strip()}")
        of_lines = file["summary"]["lines"]
        rows.append((name, of_lines["count"], of_lines["covered"], len(counts), sum(n > 0 for n in counts.values())))
    for entry in rows:
        row(*entry)
    share = row("all", *(sum(entry[i] for entry in rows) for i in range(1, 5)))
    sys.exit(share[0] < least_lines or share[1] < least_branches)


main()
