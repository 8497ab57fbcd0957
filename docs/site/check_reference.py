#!/usr/bin/env python3
"""check_reference.py XML REFERENCE HEADER...: the reference is complete.

Every public class, enumeration, type and function of the headers is documented, in the XML that Doxygen makes of them. Not asked for: operators,
defaulted and deleted functions, constants that specialise a template, and data members, of which the class says what they are. And every header
has a place in the pages of the folder REFERENCE.
"""

import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

KINDS = {"function", "enum", "typedef"}


def documented(element):
    return any("".join(part.itertext()).strip() for name in ("briefdescription", "detaileddescription") for part in element.findall(name))


def undocumented(folder):
    for path in sorted(folder.glob("*.xml")):
        for compound in ElementTree.parse(path).iter("compounddef"):
            name = compound.findtext("compoundname")
            if compound.get("kind") in ("class", "struct") and compound.get("prot") == "public" and not documented(compound):
                yield compound.find("location"), name
            for member in compound.iter("memberdef"):
                text = member.findtext("name")
                arguments = member.findtext("argsstring") or ""
                if member.get("kind") not in KINDS or member.get("prot") == "private" or documented(member):
                    continue
                if text.startswith("operator") or arguments.endswith(("=default", "=delete")) or "<" in text:
                    continue
                yield member.find("location"), f"{name}::{text}"


def main():
    folder, reference, *headers = sys.argv[1:]
    problems = {f"{place.get('file')}:{place.get('line')}: {name} is not documented" for place, name in undocumented(pathlib.Path(folder))}
    pages = "".join(page.read_text(encoding="utf-8") for page in pathlib.Path(reference).glob("*.md"))
    shown = re.findall(r"\{doxygenfile\} (\S+)", pages)
    for header in headers:
        if header != "epsnet.h" and shown.count(header) != 1:
            problems.add(f"docs/site/reference: {header} is shown {shown.count(header)} times")
    problems.update(f"docs/site/reference: {header} is no public header" for header in shown if header not in headers)
    print("\n".join(sorted(problems)), end="\n" if problems else "")
    return 1 if problems else 0


sys.exit(main())
