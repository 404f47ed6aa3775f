"""The rover of the page: equilibrium, climbing, energy, and wheels that lift off."""

from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sm

from pages import ROOT, script
from pydy.mechanics import Definition, Implicit
from pydy.solvers import Event
from pydy.system import System
from pydy.vehicles import RoadSurface, WheelContact
from zoo.wheels import planar_wheel

GRAVITY, MASS, RADIUS, STIFFNESS = 3.72, 240.0, 0.25, 4e4


@cache
def page() -> dict[str, Any]:
    """Return what the code of the page defines, but for its picture."""
    code, _, _ = script(ROOT / "docs/howto/rovers.md").partition("from pydy.viz")
    names: dict[str, Any] = {}
    exec(code, names)
    return names


def test_the_wheels_carry_what_equilibrium_says():
    # The frame of the rover is inclined by the deflections of its tires, less than 1 mm over 1.1 m.
    p = page()
    ahead = 100 * GRAVITY * (0.5 + 0.1) / 1.1 + 10 * GRAVITY
    behind = 100 * GRAVITY * (0.6 - 0.1) / 1.1 + 10 * GRAVITY
    for name, load in (("fl", ahead), ("rl", behind), ("fr", ahead), ("rr", behind)):
        assert p["standing"][f"F_{name}"][-1] == pytest.approx(load, abs=0.2)
    total = sum(p["standing"][f"F_{name}"][-1] for name in p["wheels"])
    assert total == pytest.approx(MASS * GRAVITY, rel=1e-6)


def test_on_the_ramp_torques_and_loads_balance_the_weight():
    p = page()
    motion, angle = p["climbing"], np.arctan(0.3)
    loads = np.array([motion[f"F_{name}"][-1] for name in p["wheels"]])
    spins = np.array([motion[f"omega_{name}"][-1] for name in p["wheels"]])
    loaded = RADIUS - loads / STIFFNESS
    forces = 40.0 * (1 - spins / 4.0) / loaded
    assert sum(forces) == pytest.approx(MASS * GRAVITY * np.sin(angle), rel=1e-6)
    assert sum(loads) == pytest.approx(MASS * GRAVITY * np.cos(angle), rel=1e-6)
    # Each tire slips as much as its force needs.
    speed = np.hypot(motion["v_x"][-1], motion["v_z"][-1])
    slips = spins * loaded / speed - 1
    expected = [float(p["tire"].forces(n, k, 0.0).Fx) for n, k in zip(loads, slips, strict=True)]
    np.testing.assert_allclose(expected, forces, rtol=1e-5)


@pytest.mark.parametrize("start", [0.1, 0.6])
def test_a_wheel_that_slides_over_a_dome_lifts_off_where_v2_over_r_is_the_pull_of_gravity(start):
    size, radius, mass, g, stiffness = 3.0, 0.3, 10.0, 9.81, 1e7
    w = planar_wheel(mass, 0.4)
    (x, z, q), (vx, vz, spin) = w.q, w.u
    place = sm.Function("X")(sm.Symbol("t")), sm.Function("Y")(sm.Symbol("t"))
    road = RoadSurface(sm.sqrt(size**2 - place[0] ** 2), place, w.O, w.N)
    contact = WheelContact(
        w.body, w.N.y, radius, road.point, road.normal, w.N, lambda gap, rate: -stiffness * gap
    )
    path = size + radius
    speed = start * np.sqrt(g * path)
    system = System(
        Definition(
            w.N, [x, z, q], [vx, vz, spin], bodies=[w.body],
            loads=[(w.C, -mass * g * w.N.z), *contact.loads()],
        ),
        implicit=Implicit(road.residuals(contact)),
        ode_solver="dop853",
        initial_conditions={z: path - mass * (g - speed**2 / path) / stiffness, vx: speed},
        times=np.linspace(0.0, 3.0, 31),
    )  # fmt: skip
    (event,) = contact.events
    lifts = Event(event.expression, terminal=True)
    motion = system.simulate(events=[lifts], rtol=1e-9, atol=1e-9)
    height = float(motion.at(motion.events[0].time)["z"][0])
    # m v²/R = m g cos θ with v² = v₀² + 2 g R (1 − cos θ)
    assert height / path == pytest.approx((2 + start**2) / 3, abs=1e-4)
