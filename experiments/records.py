"""The record files of sweeps (record_file.h): reading, checking, and, for the Snakemake workflow, writing."""

import csv
import os
import tempfile
import zlib
from pathlib import Path


class RecordError(Exception):
    """Not a complete record file; the text is one line that starts with the path."""


def _trailer(before: bytes, count: int) -> bytes:
    return f"# complete: {count} records, CRC-32 {zlib.crc32(before):08x}\n".encode()


def read(path: Path) -> list[dict]:
    """The records of a finished file: a dictionary for each, numbers as int or float, empty fields as None."""
    try:
        content = Path(path).read_bytes()
    except OSError as error:
        raise RecordError(f"{path}: {error.strerror}") from error
    lines = content.decode("utf-8", "replace").splitlines()
    records = lines[1:-1]
    if len(lines) < 3 or not content.endswith(_trailer(content[: content.rfind(b"# complete: ")], len(records) - 1)):
        raise RecordError(f"{path}: incomplete or damaged")
    return [{key: _value(text) for key, text in record.items()} for record in csv.DictReader(records)]


def is_finished(path: Path, head: str, columns: str) -> bool:
    """Whether there is a complete file with this head and these columns."""
    try:
        read(path)
        return Path(path).read_text(encoding="utf-8").startswith(f"{head}\n{columns}\n")
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
    """What sweep.cpp writes for the same parameters. `version` as `epsnet --version` prints it."""
    checksum = zlib.crc32(Path(surface).read_bytes())
    return (f"# {version}, sweep 1, surface {Path(surface).stem} {checksum:08x}, insertion {insertion}, walk {walk}, "
            f"list {triangle_list}, epsilon {' '.join(epsilons)}")


def gather(parameters: str, single_records: list[Path], output: Path) -> None:
    """Makes the record file of a surface out of the files of `epsnet net --record`, one for each epsilon; atomically."""
    tables = [Path(path).read_text().splitlines() for path in single_records]
    if any(len(table) != 2 or table[0] != tables[0][0] for table in tables):
        raise RecordError(f"{output}: the records are not one line each with the same columns")
    write(output, parameters, tables[0][0], [table[1] for table in tables])


def write(output: Path, head: str, columns: str, lines: list[str]) -> None:
    """A finished record file, atomically. `head` is a comment: all that the records depend on."""
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
