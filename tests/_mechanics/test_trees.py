"""Every form of the equations of random mechanisms against Newton's and Euler's laws in numbers."""

import numpy as np
import pytest

from mechanisms.build import definition
from mechanisms.generate import BODIES, draw, settle
from mechanisms.oracle import World
from pydy._graph.linear_system import LinearSystem
from pydy._graph.lowering import lower
from pydy._mechanics.formulations import forms
from pydy._program.interpret import run

LARGE = [seed for seed in range(70) if BODIES[seed % len(BODIES)] == 8]


def tree(seed):
    """A mechanism of numbers alone, without loops and prescribed motion."""
    data = draw(seed) | {"named": [], "inputs": [], "loops": [], "auxiliary": []}
    for body in data["bodies"]:
        body["joint"] = "weld" if body["joint"] == "driven" else body["joint"]
    settle(data)
    return data


@pytest.mark.parametrize("seed", LARGE[:6])
def test_every_form_moves_as_the_oracle_says(seed):
    model = definition(tree(seed))
    q, u, time = model.real["q"], model.real["u"], model.real["time"]
    world = World(model.real, q, u)
    x = np.array([[*q, *u]])
    for in_bodies in (True, False):
        for formed in forms(model.method.multibody, in_bodies=in_bodies).equations:
            graph, solved = formed.graph, formed.dynamics.accelerations
            matrix, forcing = formed.dynamics.matrix, formed.dynamics.forcing
            n = len(forcing)
            if solved is None:
                solved = LinearSystem(graph, matrix, "ldl").solve(forcing)
            program = lower(graph, (x.size, 0, 0), [("a", (n,), solved)])
            out, failed = run(program, np.array([time]), x, np.empty((1, 0)), np.empty(0))
            assert not failed.any()
            error = np.abs(out[0] - world.a).astype(float)
            np.testing.assert_array_less(error, 1e-11 * world.a_bound.astype(float))
