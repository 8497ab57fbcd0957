#!/usr/bin/env python3
"""proof_table_test.py ROOT: what docs/proof.md and its parts, the pages of docs/proof, name is there.

* The functions in the table of each part are in the files that it names. A cell is a list of names, each group of them
  followed by its file, a path in certify/.
* Its lemmas and theorems are numbered without gaps, and a lemma that a file refers to is one of them.
"""

import pathlib
import re
import sys

FOLDERS = ("certify", "docs", "fuzz", "kernel", "netgen", "python", "tests", "triangulation")
SUFFIXES = (".cpp", ".g", ".h", ".json", ".md", ".py", ".sh")
STATEMENT = re.compile(r"^\*\*(Lemma|Proposition|Theorem) (\d+)(?:\.(\d+))?[. ]", re.MULTILINE)
REFERENCE = re.compile(r"\bLemmas? (\d+(?:\.\d+)?)((?:(?:, | and | to )\d+(?:\.\d+)?)*)")
CELL = re.compile(r"`([A-Za-z_:]+)`|\(([a-z0-9_/]+\.(?:h|cpp))\)")


def number_problems(text):
    """Propositions are numbered among the lemmas, theorems by themselves; n.k follows n."""
    last = {"Lemma": (0, 0), "Theorem": (0, 0)}
    for kind, number, part in STATEMENT.findall(text):
        counter = "Theorem" if kind == "Theorem" else "Lemma"
        whole, parts = last[counter]
        this = (int(number), int(part or 0))
        if this != ((whole, parts + 1) if part else (whole + 1, 0)):
            yield f"{kind} {number}{'.' + part if part else ''} follows {counter} {whole}.{parts}"
        last[counter] = this


def reference_problems(root, text):
    known = {number + ("." + part if part else "") for kind, number, part in STATEMENT.findall(text) if kind == "Lemma"}
    if len(known) < 30:
        yield f"only {len(known)} lemmas"
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix not in SUFFIXES:
                continue
            for first, others in REFERENCE.findall(file.read_text(encoding="utf-8", errors="ignore")):
                yield from (f"{file.relative_to(root)}: there is no Lemma {number}"
                            for number in [first, *re.findall(r"\d+(?:\.\d+)?", others)] if number not in known)


def parts(root):
    """The texts of the parts, in the order of the table in docs/proof.md, which names every page."""
    names = re.findall(r"\]\(proof/([a-z-]+\.md)\)", (root / "docs/proof.md").read_text(encoding="utf-8"))
    if sorted(names) != sorted(path.name for path in (root / "docs/proof").iterdir()):
        sys.exit(f"docs/proof.md does not name each page of docs/proof once: {names}")
    return [(root / "docs/proof" / name).read_text(encoding="utf-8") for name in names]


def table_problems(root, text):
    section = text.split("\n## Which function checks what\n")[1]
    rows = [re.split(r"(?<!\\)\|", line) for line in section.splitlines() if line.startswith("| ")][2:]
    if len(rows) < 5:
        yield f"only {len(rows)} rows: {section[:200]}"
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


root = pathlib.Path(sys.argv[1])
pages = parts(root)
proof = "\n".join([(root / "docs/proof.md").read_text(encoding="utf-8"), *pages])
found = [problem for page in pages for problem in table_problems(root, page)]
found += [*number_problems(proof), *reference_problems(root, proof)]
print("\n".join(found), end="\n" if found else "")
sys.exit(bool(found))
