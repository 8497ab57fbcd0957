#!/usr/bin/env python3
"""public_headers_test.py ROOT: the public headers of certify include no other header of the project.

Plain data and three functions are what a user sees: neither FLINT nor simdjson is needed to include them.
"""

import pathlib
import re
import sys

PUBLIC = {
    "certify/check.h",
    "certify/document/document.h",
    "certify/document/geodesics_document.h",
    "certify/document/interval.h",
    "certify/document/report.h",
    "certify/file/reader.h",
    "certify/file/writer.h",
    "certify/geodesics/geodesics_check.h",
}
FOREIGN = {"gmpxx.h"}  # The one header that is neither ours nor of the standard library, whose headers have no suffix.
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]', re.MULTILINE)


def violations(root):
    for header in sorted(PUBLIC):
        for quote, target in INCLUDE.findall((root / header).read_text(encoding="utf-8")):
            known = target in PUBLIC if quote == '"' else "." not in target or target in FOREIGN
            if not known:
                yield f"{header}: {target} is no public header"


problems = list(violations(pathlib.Path(sys.argv[1])))
print("\n".join(problems), end="\n" if problems else "")
sys.exit(bool(problems))
