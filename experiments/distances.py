"""Systoles, largest embedded disks, radii and diameters of many surfaces, by `epsnet --json`. Nothing is proved a second time
here, since epsnet certifies its results: its exit code is 0 only if the certificate is VERIFIED."""

import csv
import io
import json
import math
from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal
from pathlib import Path

import kept
import plan

QUANTITIES = ("systole", "disk", "radius", "diameter")
COLUMNS = ("surface", "verdict", "genus",
           *(f"{quantity}_{end}" for quantity in QUANTITIES for end in ("lower", "upper")),
           "disk_cells", "radius_cells", "diameter_cells", *(f"{quantity}_seconds" for quantity in QUANTITIES), "error")
NOT_ENCLOSED = (1, 2)  # Exit codes of epsnet if it failed or could not decide; any other code but 0 ends the measurements.


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


def measure(store: kept.Store, measurement: plan.Measurement, surfaces: list[Path], threads: int) -> list[dict]:
    """The records of all surfaces, in their order: a value for each of COLUMNS, or None."""
    def record(surface: Path) -> dict:
        found = _record(store.programs, surface, measurement)
        check_together(found)
        return found

    way = [f"{quantity} {' '.join(_command(quantity, measurement))}" for quantity in measurement.quantities]
    return store.facts(measurement.name, surfaces, way, record, threads)


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
            raise kept.Failure(f"not {name}: {list(a)}, {list(b)}")


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


def _command(quantity: str, measurement: plan.Measurement) -> list[str]:
    return {"systole": ["systole", "--threads", "1"],
            "disk": ["embedded-disk", "--width", measurement.disk_width],
            "radius": ["radius", "--width", measurement.radius_width],
            "diameter": ["diameter", "--width", measurement.diameter_width]}[quantity]


def _record(programs: Path, surface: Path, measurement: plan.Measurement) -> dict:
    """Returns one row. If a command fails, its cells are empty and the column `error` has the reason."""
    record: dict = dict.fromkeys(COLUMNS)
    record["surface"] = surface.stem
    shape, _, _ = _facts(programs, surface, ["info"])
    record["genus"] = shape["genus"]
    errors = []
    for quantity in measurement.quantities:
        command = _command(quantity, measurement)
        facts, message, record[f"{quantity}_seconds"] = _facts(programs, surface, command)
        if facts is None:
            errors.append(f"{quantity}: {message}")
            continue
        if facts["verdict"] != "VERIFIED":
            raise kept.Failure(f"epsnet {command[0]}: verdict {facts['verdict']}, expected VERIFIED")
        if quantity == "systole":
            ends = facts["geodesics"][0]["length"]
        else:
            ends = facts["embedded_disk_radius" if quantity == "disk" else quantity]
            record[f"{quantity}_cells"] = facts["cells"]
        record[f"{quantity}_lower"], record[f"{quantity}_upper"] = ends
    record["verdict"] = "incomplete" if errors else "VERIFIED"
    record["error"] = "; ".join(errors) or None
    return record


def _facts(programs: Path, surface: Path, command: list[str]) -> tuple[dict | None, str, float]:
    """Returns the output of a command about a surface with --json, or None and its message; and the processor seconds."""
    code, out, err, seconds = kept.run(programs / "epsnet", command[0], surface, *command[1:], "--json")
    message = " ".join(err.removeprefix("epsnet: ").split())
    if code == 0:
        return json.loads(out), message, seconds
    if code not in NOT_ENCLOSED or command[0] == "info":
        raise kept.Failure(f"epsnet {command[0]}: exit code {code}: {message}")
    return None, message, seconds
