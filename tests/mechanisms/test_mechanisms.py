"""Random mechanisms do by every front end what the oracle says."""

import pytest

from mechanisms.check import check
from mechanisms.generate import BODIES
from mechanisms.run import checked

# Small ones: most of the time of large ones is SymPy's and the compiler's.
SEEDS = [s for s in range(87) if BODIES[s % len(BODIES)] < 4][:60]


@pytest.mark.parametrize("seed", SEEDS)
def test_a_mechanism_does_what_the_oracle_says(seed):
    _, _, failure = checked(seed)
    assert failure is None, failure


def test_rolling_that_implies_a_height_shares_its_forces_with_it():
    """Of three rows for two, that of the height is first, and each has a multiplier of its own."""
    body = {
        "on": -1, "joint": "ball", "at": [0.0, 0.0, 0.0], "tilt": [1.0, 0.0, 0.0],
        "centre": [1.0, 1.0, 0.0], "mass": 2.69, "about": "hinge",
        "inertia": [0.0, 1.0, 1.0, 0.0, 0.0, 0.0],
    }  # fmt: skip
    roll = {"kind": "roll", "body": 0, "radius": 0.23, "height": -0.6602037852093628}
    data = {
        "seed": 179, "units": [1.0, 1.0, 1.0], "time": 0.56, "gravity": [0.0, 0.0, 0.0],
        "said": False, "bodies": [body], "speeds": [], "loads": [], "loops": [roll],
        "auxiliary": [], "plane": None, "q": [-0.754183, 0.40065, -0.52896],
        "u": [0.5120447809919315, 0.0981005597726956, -0.26627365775764317], "named": [],
        "inputs": [], "fixed_inputs": [],
    }  # fmt: skip
    check(data, ["joints"], ["outputs"])
