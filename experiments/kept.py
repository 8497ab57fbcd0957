"""What programs find out about surfaces, kept in files: finished work is not repeated. Every experiment with nets or distances
computes through here."""

import json
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path
from typing import Any, Callable, NamedTuple

import documents


class Failure(Exception):
    """The work cannot go on; the text is one line."""


class Output(NamedTuple):
    """What a program said, and its processor time."""
    code: int
    out: str
    err: str
    seconds: float


def run(*command) -> Output:
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        try:
            process = subprocess.Popen([str(word) for word in command], stdin=subprocess.DEVNULL, stdout=out, stderr=err)
        except OSError as error:
            raise Failure(f"{command[0]}: {error.strerror}") from error
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        err.seek(0)
        return Output(process.returncode, out.read().decode(), err.read().decode(), round(used.ru_utime + used.ru_stime, 6))


def output_of(*command) -> str:
    """The standard output of a program, which must succeed."""
    result = run(*command)
    if result.code != 0:
        said = (result.err or result.out).strip().splitlines()
        raise Failure(f"{Path(command[0]).name}: exit code {result.code}: {said[-1] if said else ''}")
    return result.out


class Store:
    """Files of surfaces in DIR/surfaces, and of facts about them in DIR/records/NAME. A file of facts has all that they depend
    on: the version of the program, the surface, and the way in which they were found. It counts only if this fits."""

    def __init__(self, programs: Path, directory: Path) -> None:
        self.programs = programs
        self.directory = directory
        self.version = output_of(programs / "epsnet", "--version").strip()

    def surfaces(self, surfaces, threads: int) -> list[Path]:
        """The files of surfaces, given by their names and the arguments of `epsnet surface`; made every time, in milliseconds."""
        folder = self.directory / "surfaces"
        folder.mkdir(parents=True, exist_ok=True)

        def make(surface) -> Path:
            name, arguments = surface
            path = folder / f"{name}.json"
            output_of(self.programs / "epsnet", "surface", *arguments, "-o", path)
            return path

        with ThreadPoolExecutor(threads or os.cpu_count()) as pool:
            return list(pool.map(make, surfaces))

    def facts(self, name: str, surfaces: list[Path], way: list[str], find: Callable[[Path], Any], threads: int) -> list[Any]:
        """What `find` finds out about each surface, in their order: anything that JSON can say. Only what is not finished is found
        again. One surface that fails does not stop the others."""
        folder = self.directory / "records" / name
        folder.mkdir(parents=True, exist_ok=True)
        files = [folder / surface.name for surface in surfaces]
        keys = [{"version": self.version, "way": way, "surface": surface.read_text(encoding="utf-8")} for surface in surfaces]
        kept = [_kept(file, key) for file, key in zip(files, keys)]
        jobs = [number for number, record in enumerate(kept) if record is None]
        print(f"{name}: {len(surfaces)} surfaces, {len(surfaces) - len(jobs)} finished before", flush=True)

        def work(number: int) -> None:
            kept[number] = {"key": keys[number], "facts": find(surfaces[number])}
            documents.write_atomically(files[number], json.dumps(kept[number]))

        _all(work, jobs, [surface.stem for surface in surfaces], threads)
        return [record["facts"] for record in kept]


def _kept(file: Path, key: dict) -> dict | None:
    try:
        record = json.loads(file.read_text(encoding="utf-8"))
    except (FileNotFoundError, ValueError):
        return None
    return record if isinstance(record, dict) and record.get("key") == key and "facts" in record else None


def _all(work: Callable[[int], None], jobs: list[int], names: list[str], threads: int) -> None:
    pool = ThreadPoolExecutor(threads or os.cpu_count())
    failures = []
    try:
        futures = {pool.submit(work, number): number for number in jobs}
        for done, future in enumerate(as_completed(futures), 1):
            try:
                future.result()
            except Failure as failure:
                failures.append(f"{names[futures[future]]}: {failure}")
            if sys.stderr.isatty():
                print(f"\r{done} of {len(jobs)} surfaces", end="\n" if done == len(jobs) else "", file=sys.stderr, flush=True)
    finally:
        pool.shutdown(cancel_futures=True)
    if failures:
        raise Failure(f"{len(failures)} of {len(names)} surfaces failed, the first one {min(failures)}")
