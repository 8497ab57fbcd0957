"""What a program took: elapsed and processor time, memory. For the benchmarks beside this file."""

import os
import subprocess
import tempfile
import time
from dataclasses import dataclass

OWN_MEGABYTES = 30  # A child's peak memory includes that of this process when it starts the child, so less cannot be measured.


class Failure(Exception):
    """A program failed; the text is one line."""


@dataclass(frozen=True)
class Run:
    """One run of a program. Processor seconds are user and system time."""
    elapsed: float
    processor: float
    megabytes: float
    output: str
    exit_code: int


def run(*command, allowed: tuple[int, ...] = (0,)) -> Run:
    """Runs a program; throws Failure unless its exit code is allowed."""
    words = [str(word) for word in command]
    with tempfile.TemporaryFile("w+") as output:
        start = time.monotonic()
        process = subprocess.Popen(words, stdout=output, stderr=subprocess.STDOUT)
        _, status, used = os.wait4(process.pid, 0)
        elapsed = time.monotonic() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        said = output.read()
    if process.returncode not in allowed:
        raise Failure(f"{' '.join(words)}: exit code {process.returncode}: {said.strip().splitlines()[-1:]}")
    return Run(elapsed, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024, said, process.returncode)


def memory(megabytes: float) -> str:
    return f"{megabytes:,.0f}" if megabytes > OWN_MEGABYTES else f"< {OWN_MEGABYTES}"


def table(head: list[str], rows: list[list[str]], left: int = 1) -> str:
    """Returns a table in Markdown with numbers aligned to the right, after `left` columns of text."""
    lines = [head, ["---" if i < left else "--:" for i in range(len(head))], *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)
