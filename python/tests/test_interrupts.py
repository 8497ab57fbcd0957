"""Long work: Ctrl-C ends the wait for it, wherever it is, and other threads run meanwhile."""
import pathlib
import re
import signal
import subprocess
import sys
import threading

import pytest

from epsnet import Surface

BINDING = pathlib.Path(__file__).parents[1] / "binding"

PREAMBLE = """
import epsnet, os, signal, sys, threading
signal.signal(signal.SIGINT, signal.default_int_handler)  # A shell may have told its background jobs to ignore it.
def begun(what, share):
    print(what, flush=True)
def soon():
    threading.Timer(0.3, print, ("begun",), dict(flush=True)).start()
surface = epsnet.Surface.octagon(seed=1)
thin = epsnet.Surface.fenchel_nielsen([1, "1e-3", 2], [0, "0.5", 1], [(0, 0), (0, 1), (1, 1)])
try:
    {work}
except KeyboardInterrupt:
    print("interrupted")
    sys.exit(7)
"""

# Work of minutes; and work that never ends, as it waits for a pipe that nobody writes to, and does not look at its progress.
WORK = [
    'surface.net("0.001", progress=begun)',
    'surface.net("0.001", sparse=True, progress=begun)',
    'surface.spectrum("13", progress=begun)',
    "thin.diameter(1e-9, progress=begun)",
    'surface.radius("1e-5", progress=begun)',
    'surface.net("0.05").distances(progress=begun)',
    'epsnet.map(lambda s: s.net("0.001", progress=begun), [surface, thin])',
    'os.mkfifo("pipe"); soon(); epsnet.load("pipe")',
    'os.mkfifo("pipe"); soon(); epsnet.map(lambda s: epsnet.load("pipe"), [surface])',
]


@pytest.mark.parametrize("work", WORK)
def test_an_interrupt_ends_the_work(work, tmp_path):
    program = subprocess.Popen([sys.executable, "-c", PREAMBLE.format(work=work)], stdout=subprocess.PIPE, text=True, cwd=tmp_path)
    try:
        assert program.stdout.readline()
        program.send_signal(signal.SIGINT)
        rest, _ = program.communicate(timeout=60)
    finally:
        program.kill()
    assert program.returncode == 7 and rest.endswith("interrupted\n")
    assert [path.name for path in tmp_path.iterdir()] in ([], ["pipe"])


def test_whatever_takes_time_can_be_interrupted():
    """Every function of the library that computes without Python's lock is waited for by `interruptible`."""
    text = "".join(path.read_text(encoding="utf-8") for path in sorted(BINDING.glob("*.cpp")))
    assert text.count("interruptible(") > 30
    # JobState itself, which waits, and waits once more for what it abandons.
    waits = re.findall(r"^void JobState::(?:wait|abandon)\(.*?^}", text, re.MULTILINE | re.DOTALL)
    assert [wait.count("gil_scoped_release") for wait in waits] == [1, 1]
    # And one that takes microseconds, and waits for a mutex.
    assert text.count("gil_scoped_release") == 3


def test_other_threads_run_meanwhile(octagon):
    # The work takes hundreds of turns, so that a machine that is busy otherwise does not matter.
    done = threading.Event()
    nets = []

    def work():
        nets.append(octagon.net("0.005"))
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    turns = 0
    while not done.wait(0.001):
        turns += 1
    thread.join()
    assert turns > 10 and nets[0].proved


def test_many_threads_give_the_same_nets(octagon):
    nets = [None] * 4

    def work(k):
        nets[k] = Surface.octagon(seed=123).net("0.1")

    threads = [threading.Thread(target=work, args=(k,)) for k in range(len(nets))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(net == nets[0] for net in nets)


def test_progress_is_told_in_the_thread_that_waits(octagon):
    told = set()
    octagon.net("0.01", progress=lambda what, share: told.add(threading.get_ident()))
    assert told == {threading.get_ident()}
