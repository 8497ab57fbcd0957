"""Systoles, largest embedded disks, radii and diameters of many surfaces, by `epsnet --json`. Nothing is proved a second time
here, since epsnet certifies its results: its exit code is 0 only if the certificate is VERIFIED."""

import csv
import io
import json
import math
import os
import subprocess
import sys
import tempfile
import zlib
from concurrent.futures import ThreadPoolExecutor, as_completed
from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal
from pathlib import Path

import plan
import records

QUANTITIES = ("systole", "disk", "radius", "diameter")
COLUMNS = ("surface", "verdict", "genus",
           *(f"{quantity}_{end}" for quantity in QUANTITIES for end in ("lower", "upper")),
           "disk_cells", "radius_cells", "diameter_cells", *(f"{quantity}_seconds" for quantity in QUANTITIES), "error")
HEAD_FORMAT = 1  # Version of the record format; if it changes, finished files are made again.
NOT_ENCLOSED = (1, 2)  # Exit codes of epsnet if it failed or could not decide; any other code but 0 ends the measurements.


class MeasurementError(Exception):
    """The measurements cannot go on; the text is one line."""


def disk_bound(genus: int) -> float:
    """Bavard's bound on the radius of an embedded disk (Disques extrémaux et surfaces modulaires, 1996), rounded."""
    return math.acosh(1 / (2 * math.sin(math.pi / (12 * genus - 6))))


def radius_bound(genus: int) -> float:
    """The least radius of a disk that can cover a surface, rounded: the circumradii of the 4g - 2 Delaunay triangles of its
    centre are at most the radius, so these triangles have the greatest area if they are equilateral."""
    return math.acosh(1 / (math.sqrt(3) * math.tan(math.pi / (12 * genus - 6))))


def has_all(record: dict) -> bool:
    return record["error"] is None


def middle(record: dict, quantity: str) -> float:
    return (record[f"{quantity}_lower"] + record[f"{quantity}_upper"]) / 2


def measure(programs: Path, output: Path, measurement: plan.Measurement, surfaces: list[Path], threads: int) -> list[dict]:
    """Returns the records of all surfaces, in their order. Makes those that are not finished yet."""
    directory = output / "records" / measurement.name
    directory.mkdir(parents=True, exist_ok=True)
    version = _run([programs / "epsnet", "--version"])[1].strip()
    columns = ",".join(COLUMNS)
    files = [directory / f"{surface.stem}.csv" for surface in surfaces]
    heads = [_head(version, surface, measurement) for surface in surfaces]
    jobs = [(surface, file, head) for surface, file, head in zip(surfaces, files, heads)
            if not records.is_finished(file, head, columns)]
    print(f"{measurement.name}: {len(surfaces)} surfaces, {len(surfaces) - len(jobs)} finished before", flush=True)

    def work(surface: Path, file: Path, head: str) -> None:
        record = _record(programs, surface, measurement)
        check_together(record)
        records.write(file, head, columns, [_line(record)])

    pool = ThreadPoolExecutor(threads or os.cpu_count())
    try:
        for done, future in enumerate(as_completed([pool.submit(work, *job) for job in jobs]), 1):
            future.result()
            if sys.stderr.isatty():
                print(f"\r{done} of {len(jobs)} surfaces", end="\n" if done == len(jobs) else "", file=sys.stderr, flush=True)
    finally:
        pool.shutdown(cancel_futures=True)
    return [record for file in files for record in records.read(file)]


def check_together(record: dict) -> None:
    """Checks that intervals proved separately agree: the enclosed numbers must satisfy these inequalities (a <= b)."""
    def ends(quantity, factor=1.0):
        lower, upper = record[f"{quantity}_lower"], record[f"{quantity}_upper"]
        return None if lower is None else (factor * lower, factor * upper)

    rounding = 1e-12  # The bounds are computed in floating point.
    largest_disk, least_radius = (bound(record["genus"]) for bound in (disk_bound, radius_bound))
    for name, a, b in (("systole/2 <= disk", ends("systole", 0.5), ends("disk")),
                       ("disk <= Bavard's bound", ends("disk"), (largest_disk, largest_disk)),
                       ("least radius <= radius", (least_radius, least_radius), ends("radius")),
                       ("radius <= diameter", ends("radius"), ends("diameter")),
                       ("diameter <= 2 radius", ends("diameter"), ends("radius", 2))):
        if a and b and a[0] > b[1] + rounding:
            raise MeasurementError(f"{record['surface']}: not {name}: {list(a)}, {list(b)}")


def whole_table(data: list[dict]) -> str:
    """All records as one CSV."""
    return "".join(line + "\n" for line in [",".join(COLUMNS), *map(_line, data)])


def outward(end: float, rounding: str) -> str:
    """The shortest decimal that is read as this number and is not inside of the interval that it ends, as epsnet writes it."""
    decimals = (Context(prec=digits, rounding=rounding).plus(Decimal(end)) for digits in range(1, 30))
    return format(next(decimal for decimal in decimals if float(decimal) == end), "f")


def _line(record: dict) -> str:
    cells = dict(record)
    for quantity in QUANTITIES:
        for name, rounding in (("lower", ROUND_FLOOR), ("upper", ROUND_CEILING)):
            end = record[f"{quantity}_{name}"]
            cells[f"{quantity}_{name}"] = None if end is None else outward(end, rounding)
    text = io.StringIO()
    csv.DictWriter(text, COLUMNS, lineterminator="").writerow(cells)
    return text.getvalue()


def _head(version: str, surface: Path, measurement: plan.Measurement) -> str:
    return (f"# {version}, distances {HEAD_FORMAT}, surface {surface.stem} {zlib.crc32(surface.read_bytes()):08x}, widths "
            f"disk {measurement.disk_width}, radius {measurement.radius_width}, diameter {measurement.diameter_width}")


def _run(command: list) -> tuple[int, str, str, float]:
    """Returns the exit code, standard output and error, and the processor seconds."""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        try:
            process = subprocess.Popen([str(word) for word in command], stdin=subprocess.DEVNULL, stdout=out, stderr=err)
        except OSError as error:
            raise MeasurementError(f"{command[0]}: {error.strerror}") from error
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        err.seek(0)
        return process.returncode, out.read().decode(), err.read().decode(), round(used.ru_utime + used.ru_stime, 6)


def _record(programs: Path, surface: Path, measurement: plan.Measurement) -> dict:
    """Returns one row. If a command fails, its cells are empty and the column `error` has the reason."""
    commands = {"systole": ["systole", surface, "--threads", 1],
                "disk": ["embedded-disk", surface, "--width", measurement.disk_width],
                "radius": ["radius", surface, "--width", measurement.radius_width],
                "diameter": ["diameter", surface, "--width", measurement.diameter_width]}
    record: dict = dict.fromkeys(COLUMNS)
    record["surface"] = surface.stem
    shape, _, _ = _facts(programs, ["info", surface])
    record["genus"] = shape["genus"]
    errors = []
    for quantity, command in commands.items():
        facts, message, record[f"{quantity}_seconds"] = _facts(programs, command)
        if facts is None:
            errors.append(f"{quantity}: {message}")
            continue
        if facts["verdict"] != "VERIFIED":
            raise MeasurementError(f"{surface}: epsnet {command[0]}: verdict {facts['verdict']}, expected VERIFIED")
        if quantity == "systole":
            ends = facts["geodesics"][0]["length"]
        else:
            ends = facts["embedded_disk_radius" if quantity == "disk" else quantity]
            record[f"{quantity}_cells"] = facts["cells"]
        record[f"{quantity}_lower"], record[f"{quantity}_upper"] = ends
    record["verdict"] = "incomplete" if errors else "VERIFIED"
    record["error"] = "; ".join(errors) or None
    return record


def _facts(programs: Path, command: list) -> tuple[dict | None, str, float]:
    """Returns the output of a command with --json, or None and its message; and the processor seconds."""
    code, out, err, seconds = _run([programs / "epsnet", *command, "--json"])
    message = " ".join(err.removeprefix("epsnet: ").split())
    if code == 0:
        return json.loads(out), message, seconds
    if code not in NOT_ENCLOSED or command[0] == "info":
        raise MeasurementError(f"{command[1]}: epsnet {command[0]}: exit code {code}: {message}")
    return None, message, seconds
