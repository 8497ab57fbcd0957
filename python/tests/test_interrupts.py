"""Long work: it can be interrupted, and other threads run meanwhile."""
import signal
import subprocess
import sys
import threading

import pytest

from epsnet import Surface

PREAMBLE = """
import epsnet, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # A shell may have told its background jobs to ignore it.
def begun(what, share):
    print(what, flush=True)
surface = epsnet.Surface.octagon(seed=1)
thin = epsnet.Surface.fenchel_nielsen([1, "1e-3", 2], [0, "0.5", 1], [(0, 0), (0, 1), (1, 1)])
try:
    {work}
except KeyboardInterrupt:
    print("interrupted")
    sys.exit(7)
"""


@pytest.mark.parametrize(
    "work",
    [
        'surface.net("0.001", progress=begun)',
        'surface.spectrum("13", progress=begun)',
        "thin.diameter(1e-9, progress=begun)",
    ],
)
def test_an_interrupt_ends_the_work(work):
    program = subprocess.Popen([sys.executable, "-c", PREAMBLE.format(work=work)], stdout=subprocess.PIPE, text=True)
    try:
        assert program.stdout.readline()
        program.send_signal(signal.SIGINT)
        rest, _ = program.communicate(timeout=60)
    finally:
        program.kill()
    assert program.returncode == 7 and rest.endswith("interrupted\n")


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
