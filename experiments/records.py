"""The record files of sweeps (record_file.h): reading, checking, writing, joining."""

import csv
import os
import tempfile
import zlib
from pathlib import Path


class RecordError(Exception):
    """A file is not a complete record file; the text is one line that starts with the path."""


def _trailer(before: bytes, count: int) -> bytes:
    return f"# complete: {count} records, CRC-32 {zlib.crc32(before):08x}\n".encode()


def read(path: Path) -> list[dict]:
    """Returns the records of a finished file: a dictionary for each, numbers as int or float, empty fields as None."""
    try:
        content = Path(path).read_bytes()
    except OSError as error:
        raise RecordError(f"{path}: {error.strerror}") from error
    lines = content.decode("utf-8", "replace").splitlines()
    records = lines[1:-1]
    if len(lines) < 3 or not content.endswith(_trailer(content[: content.rfind(b"# complete: ")], len(records) - 1)):
        raise RecordError(f"{path}: incomplete or damaged")
    return [{key: _value(text) for key, text in record.items()} for record in csv.DictReader(records)]


def is_finished(path: Path, head: str, columns: str | None = None) -> bool:
    """Whether there is a complete file with this head, and with these columns."""
    try:
        read(path)
        return Path(path).read_text(encoding="utf-8").startswith(f"{head}\n" + (f"{columns}\n" if columns else ""))
    except (RecordError, OSError, UnicodeDecodeError):
        return False


def _value(text: str):
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text or None


def parameter_line(version: str, surface: Path, insertion: str, walk: str, triangle_list: str, epsilons: list[str]) -> str:
    """Returns the line that sweep.cpp writes for the same parameters. `version` is the output of `epsnet --version`."""
    checksum = zlib.crc32(Path(surface).read_bytes())
    return f"# {version}, sweep 1, surface {Path(surface).stem} {checksum:08x}, {_way(insertion, walk, triangle_list, epsilons)}"


def table_head(version: str, genus: int | None, seeds, insertion: str, walk: str, triangle_list: str, epsilons: list[str]) -> str:
    """Returns the head of the table of a batch or of a whole sweep."""
    kind = "octagons" if genus is None else f"genus {genus}"
    return f"# {version}, table 1, {kind}, seeds {seeds}, {_way(insertion, walk, triangle_list, epsilons)}"


def _way(insertion: str, walk: str, triangle_list: str, epsilons: list[str]) -> str:
    return f"insertion {insertion}, walk {walk}, list {triangle_list}, epsilon {' '.join(epsilons)}"


def gather(parameters: str, single_records: list[Path], output: Path) -> None:
    """Makes the record file of a surface, atomically, from the files of `epsnet net --record`, one for each epsilon."""
    tables = [Path(path).read_text().splitlines() for path in single_records]
    if any(len(table) != 2 or table[0] != tables[0][0] for table in tables):
        raise RecordError(f"{output}: the records are not one line each with the same columns")
    write(output, parameters, tables[0][0], [table[1] for table in tables])


def join(output: Path, head: str, parts: dict[Path, str]) -> None:
    """Joins the records of several files, which must be finished and have these heads, into one file. Leaves out the seconds, so
    that the file is the same wherever and however often it is made."""
    columns, lines = "", []
    for path, part_head in parts.items():
        if not is_finished(path, part_head):
            raise RecordError(f"{path}: not finished, or with other parameters")
        rows = [line.split(",") for line in Path(path).read_text(encoding="utf-8").splitlines()[1:-1]]
        kept = [i for i, column in enumerate(rows[0]) if not column.endswith("_seconds")]
        names, *values = [",".join(row[i] for i in kept) for row in rows]
        if columns not in ("", names):
            raise RecordError(f"{path}: other columns")
        columns = names
        lines += values
    write(output, head, columns, lines)


def write(output: Path, head: str, columns: str, lines: list[str]) -> None:
    """Writes a finished record file, atomically. `head` is a comment with everything that the records depend on."""
    before = "".join(line + "\n" for line in [head, columns, *lines]).encode()
    output = Path(output)
    descriptor, temporary = tempfile.mkstemp(dir=output.parent, prefix=f".{output.name}.")
    try:
        with os.fdopen(descriptor, "wb") as out:
            out.write(before + _trailer(before, len(lines)))
        os.chmod(temporary, 0o644)
        os.replace(temporary, output)
    except BaseException:
        os.unlink(temporary)
        raise
