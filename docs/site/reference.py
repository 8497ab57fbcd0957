#!/usr/bin/env python3
"""reference.py XML PAGES OUT HEADER...: writes the pages of the reference to the folder OUT, and says what is missing in it.

A page of the folder PAGES says with a line "headers: PREFIX..." which headers it shows: those whose paths start with one of the prefixes, in this
order; a header goes where the longest prefix is. Every public class, enumeration, type and function of the headers is documented, in the XML that
Doxygen makes of them. Not asked for: operators, defaulted and deleted functions, and data members, of which the class says what they are.
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


def forget_includes(folder):
    """The pages say which header it is; Doxygen knows only the end of its path."""
    for path in [*folder.glob("class*.xml"), *folder.glob("struct*.xml")]:
        text = path.read_text(encoding="utf-8")
        path.write_text(re.sub(r"<includes [^>]*>[^<]*</includes>", "", text), encoding="utf-8")


def write_pages(pages, out, headers):
    """Returns what is wrong."""
    lines = {page: page.read_text(encoding="utf-8").splitlines() for page in sorted(pages.glob("*.md"))}
    prefixes = [prefix for text in lines.values() for line in text if line.startswith("headers: ") for prefix in line.split()[1:]]
    place = {header: max((p for p in prefixes if header.startswith(p)), key=len, default=None) for header in headers}
    out.mkdir(parents=True, exist_ok=True)
    for page, text in lines.items():
        written = []
        for line in text:
            if line.startswith("headers: "):
                shown = [header for prefix in line.split()[1:] for header in sorted(headers) if place[header] == prefix]
                written += [f"## {header}\n\n```{{doxygenfile}} {header}\n```\n" for header in shown]
            else:
                written.append(line)
        (out / page.name).write_text("\n".join(written) + "\n", encoding="utf-8")
    for header in headers:
        if place[header] is None:
            yield f"docs/site/reference: no page has a prefix of {header}"
    for prefix in prefixes:
        if prefix not in place.values():
            yield f"docs/site/reference: no public header for the prefix {prefix}"


def main():
    folder, pages, out, *headers = sys.argv[1:]
    headers.remove("epsnet.h")
    forget_includes(pathlib.Path(folder))
    problems = {f"{place.get('file')}:{place.get('line')}: {name} is not documented" for place, name in undocumented(pathlib.Path(folder))}
    problems.update(write_pages(pathlib.Path(pages), pathlib.Path(out), headers))
    print("\n".join(sorted(problems)), end="\n" if problems else "")
    return 1 if problems else 0


sys.exit(main())
