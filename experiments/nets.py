"""Nets of many surfaces in the ways of the thesis, by the program `variant`, which proves each: its exit code is 0 only if all are
verified."""

import csv
from pathlib import Path

import kept
import plan


def measure(store: kept.Store, sweep: plan.Sweep, surfaces: list[Path], threads: int) -> list[dict]:
    """The records of all surfaces, in their order, an epsilon after the other: the columns of `variant` and their texts."""
    way = ["--epsilons", ",".join(sweep.epsilons), "--insert", sweep.insertion, "--locate", sweep.walk, "--list", sweep.triangle_list]

    def records(surface: Path) -> list[dict]:
        found = list(csv.DictReader(kept.output_of(store.programs / "variant", surface, *way).splitlines()))
        if len(found) != len(sweep.epsilons) or any(record["verdict"] != "VERIFIED" for record in found):
            raise kept.Failure("a net is missing or not verified")
        return [{"surface": surface.stem, **record} for record in found]

    return [record for found in store.facts(sweep.name, surfaces, ["variant", *way], records, threads) for record in found]


def numbers(records: list[dict]) -> list[dict]:
    """Records with numbers as int or float, and None for what does not exist."""
    return [{name: _value(text) for name, text in record.items()} for record in records]


def table(records: list[dict]) -> str:
    """All records as one CSV, without the seconds: the same bytes wherever and however often it is made."""
    names = [name for name in records[0] if not name.endswith("_seconds")]
    return "".join(",".join(line) + "\n" for line in [names, *([record[name] for name in names] for record in records)])


def _value(text: str):
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text or None
