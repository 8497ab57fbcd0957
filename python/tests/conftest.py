"""What the tests share."""
import os
import pathlib

import hypothesis
import pytest

import epsnet

# As many cases as properties of the C++ tests have (tests/support/scale.h).
CASES = max(1, round(100 * float(os.environ.get("EPSNET_TEST_MULTIPLIER") or 1)))
hypothesis.settings.register_profile("fixed", derandomize=True, database=None, deadline=None, max_examples=CASES)
hypothesis.settings.load_profile("fixed")

DATA = pathlib.Path(__file__).parents[2] / "tests/data"


@pytest.fixture(scope="session")
def octagon():
    return epsnet.Surface.octagon(seed=123)


@pytest.fixture(scope="session")
def bolza():
    return epsnet.Surface.regular(2)


@pytest.fixture(scope="session")
def pants():
    """Genus 3, of several tiles."""
    return epsnet.Surface.fenchel_nielsen(genus=3, seed=5)


@pytest.fixture(scope="session")
def net(octagon):
    return octagon.net("0.25")


@pytest.fixture(scope="session")
def data():
    return DATA
