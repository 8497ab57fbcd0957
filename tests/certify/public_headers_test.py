#!/usr/bin/env python3
"""public_headers_test.py ROOT: the public headers of certify (certify/CMakeLists.txt) include no other one of the project.

Plain data and three functions are what a user sees: FLINT is not needed to include them.
"""

import pathlib
import re
import sys

FOREIGN = {"gmpxx.h"}  # The one header that is neither ours nor of the standard library, whose headers have no suffix.
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]', re.MULTILINE)


def violations(root):
    listed = re.search(r"epsnet_public_headers\(certify\s([^)]*)\)", (root / "certify/CMakeLists.txt").read_text())
    public = {f"certify/{name}" for name in listed[1].split()}
    for header in sorted(public):
        for quote, target in INCLUDE.findall((root / header).read_text(encoding="utf-8")):
            known = target in public if quote == '"' else "." not in target or target in FOREIGN
            if not known:
                yield f"{header}: {target} is no public header"


problems = list(violations(pathlib.Path(sys.argv[1])))
print("\n".join(problems), end="\n" if problems else "")
sys.exit(bool(problems))
