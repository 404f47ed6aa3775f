"""Which velocity constraints are genuinely nonholonomic, told for systems where that is known."""

import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._mechanics.kane import equations_of_kane
from zoo import inertial_frame

Q, U = me.dynamicsymbols("x y a"), me.dynamicsymbols("u v w")
L = sm.symbols("l", positive=True)
CIRCLE = Q[0] ** 2 + Q[1] ** 2 - L**2
ALONG = Q[0] * U[0] + Q[1] * U[1]  # half the circle's rate
SKATE = U[0] * sm.sin(Q[2]) - U[1] * sm.cos(Q[2])


def classified(holonomic, velocity):
    """A blade in the plane: it has a place and a direction."""
    frame, origin = inertial_frame()
    blade = frame.orientnew("B", "axis", (Q[2], frame.z))
    blade.set_ang_vel(frame, U[2] * frame.z)
    place = origin.locatenew("P", Q[0] * frame.x + Q[1] * frame.y)
    place.set_vel(frame, U[0] * frame.x + U[1] * frame.y)
    inertia = (me.inertia(blade, 0, 0, sm.Symbol("I")), place)
    body = me.RigidBody("blade", place, blade, sm.Symbol("m"), inertia)
    free = 3 - len(holonomic)
    speeds = 3 - len(velocity)
    kane = me.KanesMethod(
        frame,
        Q[3 - free :],
        U[3 - speeds :],
        kd_eqs=[a.diff() - b for a, b in zip(Q, U, strict=True)],
        q_dependent=Q[: 3 - free],
        u_dependent=U[: 3 - speeds],
        configuration_constraints=holonomic,
        velocity_constraints=velocity,
        bodies=[body],
        forcelist=None,
    )
    return equations_of_kane(kane).constraints


def test_the_rate_of_a_holonomic_constraint_is_none():
    found = classified([CIRCLE], [2 * ALONG])
    assert found.nonholonomic == ()
    assert found.implied_holonomic == (0,)


@pytest.mark.parametrize("unit", [1e-18, 1e-12, 1e9])
def test_what_is_enforced_is_so_in_any_unit(unit):
    found = classified([unit * CIRCLE], [ALONG, SKATE])
    assert found.implied_holonomic == (0,)
    assert found.nonholonomic == (SKATE,)


def test_a_rate_may_be_scaled_and_simplified_with_the_constraint():
    found = classified([CIRCLE], [(Q[0] ** 2 + Q[1] ** 2) / L**2 * ALONG])
    assert found.nonholonomic == ()


def test_without_holonomic_constraints_all_are():
    assert classified([], [SKATE]).nonholonomic == (SKATE,)


@pytest.mark.parametrize("order", [1, -1])
def test_rows_that_mix_both_kinds_hold_one(order):
    rows = [ALONG + SKATE, ALONG - SKATE][::order]
    found = classified([CIRCLE], rows)
    assert len(found.nonholonomic) == 1
    assert found.implied_holonomic == (0,)


def test_a_holonomic_constraint_without_its_rate_is_not_enforced():
    found = classified([CIRCLE], [SKATE])
    assert len(found.nonholonomic) == 1
    assert found.implied_holonomic == ()
