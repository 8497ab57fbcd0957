#!/usr/bin/env python3
"""rooms_test.py ROOT: every #include of the project is one that the table of docs/rooms.md allows.

And no row allows the generator a rule of the checker.

Also: every include of an own file is spelled as its path from ROOT, and that file exists; and the public headers, which the rooms' CMakeLists.txt
name, are those that epsnet.h leads to. And no two files define a type of the same name in the same namespace: no compiler sees both, and the linker
takes the functions of one for the other.
"""

import pathlib
import posixpath
import re
import sys

CLOSED = {"netgen/program", "certify/program", "python", "experiments", "fuzz", "tests", "wasm"}  # Only who names these includes them.
# What the generator may include of certify (docs/rooms.md): nothing here decides whether a claim is true.
GENERATOR = ("kernel", "triangulation", "netgen")
NO_RULES = re.compile(r"certify/(base|check|claims|claims/[^/]+/document|documents|file|net/(document|numbering)|numbers|verdict)")
INCLUDE = re.compile(r'\s*#\s*include\s*(["<])([^">]+)[">]')


def read_table(text):
    rooms = {}
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if len(cells) == 5 and cells[1] not in ("room", "---"):
            rooms[cells[1]] = set(cells[3].split())
    return rooms


def room_of(path, rooms):
    """The longest room whose name the path starts with, at the end of a folder or of the name of a file."""
    fits = [room for room in rooms if path.startswith((room + "/", room + "."))]
    return max(fits, key=len, default=None)


def with_folders(rooms, folders, files):
    """The table in which PARENT/* stands for each folder in PARENT that has no row of its own, and PARENT/*/NAME for each
    file of that name in such a folder."""
    rows = {}
    for room, allowed in rooms.items():
        parent, star, rest = room.partition("/*")
        names = [room]
        if star:
            names = [name + rest for name in folders if posixpath.dirname(name) == parent and name + rest not in rooms]
            names = [name for name in names if not rest or name in files]
        rows[room] = (names, allowed)
    return {
        name: {one for other in allowed for one in rows.get(other, ([other],))[0]} for names, allowed in rows.values() for name in names
    }


def may_include(room, other, rooms, files):
    """Whether files of a room may include those of another; `files` are the names of headers."""
    # A file with a row of its own in the folder of a room is open to that room, and to whoever may include it.
    others = {other, posixpath.dirname(other)} if other in files else {other}
    return room in others or bool(rooms[room] & (others if other in CLOSED else others | {"*"}))


def generator_violations(rooms):
    """Rows that allow the generator a rule of the checker."""
    for room, allowed in sorted(rooms.items()):
        if room.split("/")[0] not in GENERATOR:
            continue
        for other in sorted(allowed):
            of_checker = other == "*" or other.startswith("certify/")
            if of_checker and not NO_RULES.fullmatch(other):
                yield f"docs/rooms.md: {room} is of the generator, and may not be allowed {other}, which has rules of the checker"


def wrong_includes(path, text, rooms, folders, files, is_file):
    """What is wrong with the includes of a file."""
    room = room_of(path, rooms)
    for number, line in enumerate(text.splitlines(), 1):
        include = INCLUDE.match(line)
        if not include:
            continue
        quote, target = include.groups()
        place = f"{path}:{number}: {target}"
        ours = target.split("/")[0] in folders | {"epsnet"}
        if quote == '"' and not is_file(target):
            yield f"{place}: no such file; own files are spelled as their path from the top folder"
        elif quote == "<" and ours:
            yield f"{place}: own files are included with quotation marks, as their path from the top folder"
        elif quote == '"':
            other = room_of(target, rooms)
            if not may_include(room, other, rooms, files):
                yield f"{place}: {room} may not include {other} (docs/rooms.md)"


def violations(root, rooms, headers):
    names = {name for allowed in rooms.values() for name in allowed if name != "*"}
    for name in sorted(names - rooms.keys()):
        yield f"docs/rooms.md: {name} is allowed to somebody, but is no room"
    folders = {room.split("/")[0] for room in rooms}
    files = sorted(path for folder in folders for path in (root / folder).rglob("*") if path.suffix in (".h", ".cpp"))
    if len(files) < 100:
        yield f"{root}: only {len(files)} sources found"
    used = set()
    for file in files:
        path = file.relative_to(root).as_posix()
        if path.startswith("tests/install/"):  # A user's project.
            continue
        used.add(room_of(path, rooms))
        text = file.read_text(encoding="utf-8")
        yield from wrong_includes(path, text, rooms, folders, headers, lambda target: (root / target).is_file())
    for room in sorted(rooms.keys() - used):
        yield f"docs/rooms.md: {room} has no source"


def own_includes(file):
    matches = (INCLUDE.match(line) for line in file.read_text(encoding="utf-8").splitlines())
    return [match.group(2) for match in matches if match and match.group(1) == '"']


def named_public(text, folder):
    """The headers after epsnet_public_headers(ROOM, as paths from ROOT."""
    names = " ".join(re.findall(r"epsnet_public_headers\(\w+([^)]*)\)", text)).split()
    return {posixpath.normpath(posixpath.join(folder, name)) for name in names}


def public_violations(root):
    reached = {"epsnet.h"}
    pending = ["epsnet.h"]
    while pending:
        for name in own_includes(root / pending.pop()):
            if name not in reached and (root / name).is_file():
                reached.add(name)
                pending.append(name)
    named = set()
    for file in sorted(root.glob("*/CMakeLists.txt")):
        named |= named_public(file.read_text(encoding="utf-8"), file.parent.name)
    for name in sorted(reached - named):
        yield f"{name}: epsnet.h leads to it, so name it after epsnet_public_headers in {name.split('/')[0]}/CMakeLists.txt"
    for name in sorted(named - reached):
        yield f"{name}: is installed (epsnet_public_headers), but epsnet.h does not lead to it"


NAMESPACE = re.compile(r"(inline )?namespace (([\w:]+) )?{$")
TYPE = re.compile(r"(?:struct|class|enum class|union) (\w+)(?: final)?(?: :[^:].*)? ?\{")


def types_of(text):
    """The types with linkage that a file defines, (namespace, name): as clang-format has them, at the beginning of a line."""
    namespaces = []
    for line in text.splitlines():
        opened = NAMESPACE.match(line)
        found = TYPE.match(line)
        if opened:
            namespaces.append(opened.group(3))
        elif line.startswith("}  // namespace"):
            namespaces.pop()
        elif found and None not in namespaces:
            yield "::".join(namespaces), found.group(1)


def twice_defined(root, folders):
    places = {}
    for file in sorted(path for folder in folders for path in (root / folder).rglob("*") if path.suffix in (".h", ".cpp")):
        path = file.relative_to(root).as_posix()
        # Programs of their own.
        if path.startswith(("tests/install/", "tests/benchmark/")):
            continue
        for namespace, name in types_of(file.read_text(encoding="utf-8")):
            places.setdefault((namespace, name), set()).add(path)
    if len(places) < 100:
        yield f"{root}: only {len(places)} types found"
    for (namespace, name), files in sorted(places.items()):
        if namespace and len(files) > 1:
            yield f"{namespace}::{name} is defined in {', '.join(sorted(files))}"


def self_test():
    """A table and paths of which the answers are known."""
    rooms = read_table("| room | owns | may include |\n| --- | --- | --- |\n| a | x | a/b |\n| a/b | y | |\n| a/check | z | * |\n")
    assert rooms == {"a": {"a/b"}, "a/b": set(), "a/check": {"*"}}, rooms
    assert named_public("epsnet_public_headers(a\n  ../epsnet.h\n  b/x.h)", "a") == {"epsnet.h", "a/b/x.h"}
    assert room_of("a/x.h", rooms) == "a" and room_of("a/b/x.h", rooms) == "a/b"
    every = with_folders({"a/*": {"b"}, "a/c": {"a/*"}}, ["a/c", "a/d", "a/e", "f/g"], set())
    assert every == {"a/d": {"b"}, "a/e": {"b"}, "a/c": {"a/d", "a/e"}}, every
    every = with_folders({"a/*": {"b"}, "a/*/x": {"c"}, "d": {"a/*/x"}}, ["a/e", "a/f"], {"a/e/x"})
    assert every == {"a/e": {"b"}, "a/f": {"b"}, "a/e/x": {"c"}, "d": {"a/e/x"}}, every
    # A file of its own in the folder of a room.
    few = {"certify/net": set(), "certify/net/document": set(), "certify/claim": {"certify/net"}, "netgen/x": {"certify/net/document"}}
    files = {"certify/net/document"}

    def wrong(path, target):
        return list(wrong_includes(path, f'#include "{target}"', few, {"certify", "netgen"}, files, lambda _: True))

    assert not wrong("certify/net/rule.cpp", "certify/net/document.h") and not wrong("certify/claim/rule.cpp", "certify/net/document.h")
    assert not wrong("netgen/x/y.cpp", "certify/net/document.h") and wrong("certify/net/document.h", "certify/net/rule.h")
    # The generator and a rule: there is no row that allows it, nor may there be one.
    found = wrong("netgen/x/y.cpp", "certify/net/rule.h")
    assert found == ["netgen/x/y.cpp:1: certify/net/rule.h: netgen/x may not include certify/net (docs/rooms.md)"], found
    assert not list(generator_violations(few | {"wasm": {"*"}}))
    for allowed in ("certify/net", "certify/claims/eigenvalues", "certify/claims/*", "certify/lifted", "certify/exact", "*"):
        assert len(list(generator_violations({"netgen/x": {allowed, "certify/numbers"}}))) == 1, allowed
    types = "namespace a {\nstruct X {\n};\nnamespace {\nstruct Y {\n}  // namespace\nclass Z : public X {\nstruct X;\n}  // namespace a\n"
    assert list(types_of(types)) == [("a", "X"), ("a", "Z")], list(types_of(types))
    assert room_of("a/check.h", rooms) == "a/check" and room_of("a/checks.h", rooms) == "a" and room_of("c.h", rooms) is None


def main():
    self_test()
    root = pathlib.Path(sys.argv[1])
    table = read_table((root / "docs/rooms.md").read_text(encoding="utf-8"))
    parents = {room.partition("/*")[0] for room in table if "/*" in room}
    folders = [path.relative_to(root).as_posix() for parent in parents for path in (root / parent).iterdir() if path.is_dir()]
    headers = {path.relative_to(root).with_suffix("").as_posix() for path in (root / "certify").rglob("*.h")}
    found = list(twice_defined(root, sorted({room.split("/")[0] for room in table})))
    found += list(generator_violations(table)) + list(public_violations(root))
    found += list(violations(root, with_folders(table, folders, headers), headers))
    print("\n".join(found))
    return 1 if found else 0


sys.exit(main())
