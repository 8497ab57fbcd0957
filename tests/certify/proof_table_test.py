#!/usr/bin/env python3
"""proof_table_test.py ROOT: the functions that section 12 of docs/proof.md names are in the files that it names.

A cell is a list of names, each group of them followed by its file, a path in certify/.
"""

import pathlib
import re
import sys

CELL = re.compile(r"`([A-Za-z_:]+)`|\(([a-z_/]+\.(?:h|cpp))\)")


def problems(root):
    text = (root / "docs/proof.md").read_text(encoding="utf-8")
    section = text.split("\n## 12.")[1].split("\n## ")[0]
    rows = [re.split(r"(?<!\\)\|", line) for line in section.splitlines() if line.startswith("| ")][2:]
    if len(rows) < 40:
        yield f"only {len(rows)} rows"
    for row in rows:
        names = []
        for name, path in CELL.findall(row[2]):
            if name:
                names.append(name)
                continue
            file = root / "certify" / path
            source = file.read_text(encoding="utf-8") if file.is_file() else ""
            yield from (f"{name} is not in certify/{path}" for name in names
                        if not all(re.search(rf"\b{part}\b", source) for part in name.split("::")))
            names = []
        yield from (f"{name} has no file" for name in names)


found = list(problems(pathlib.Path(sys.argv[1])))
print("\n".join(found), end="\n" if found else "")
sys.exit(bool(found))
