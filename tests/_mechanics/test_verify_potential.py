"""Whether an energy is that of some loads, told from powers of known systems."""

import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._mechanics.kane import equations_of_kane
from pydy._mechanics.verify_potential import has_momenta_of, is_potential_of
from zoo import inertial_frame

M, G, L = sm.symbols("m g l", positive=True)


def bead(holonomic=()):
    """A particle in the plane, free or on a circle."""
    q, u = me.dynamicsymbols("x y"), me.dynamicsymbols("u v")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", q[0] * frame.x + q[1] * frame.y)
    place.set_vel(frame, u[0] * frame.x + u[1] * frame.y)
    options = {"q_ind": q, "u_ind": u}
    if holonomic:
        circle = q[0] ** 2 + q[1] ** 2 - L**2
        options = {
            "q_ind": q[:1], "q_dependent": q[1:], "u_ind": u[:1], "u_dependent": u[1:],
            "configuration_constraints": [circle],
            "velocity_constraints": [2 * q[0] * u[0] + 2 * q[1] * u[1]],
        }  # fmt: skip
    rates = [a.diff() - b for a, b in zip(q, u, strict=True)]
    body = me.Particle("P", place, M)
    kane = me.KanesMethod(frame, kd_eqs=rates, bodies=[body], forcelist=None, **options)
    return equations_of_kane(kane), q, u


def test_weight_is_that_of_height():
    equations, q, u = bead()
    assert is_potential_of(equations, M * G * q[1], [-M * G * u[1]])


@pytest.mark.parametrize("factor", [1 - 1e-6, -1, 2])
def test_another_factor_is_told(factor):
    equations, q, u = bead()
    assert not is_potential_of(equations, factor * M * G * q[1], [-M * G * u[1]])


def test_several_powers_add_up():
    equations, q, u = bead()
    parts = [-M * G * u[1], G * q[0] * u[1], G * q[1] * u[0]]
    assert is_potential_of(equations, M * G * q[1] - G * q[0] * q[1], parts)


def test_a_velocity_that_was_simplified_with_the_constraint_counts_as_it_is_there():
    equations, q, u = bead(holonomic=True)
    along = -q[0] * u[0] / q[1]  # v on the circle
    assert is_potential_of(equations, M * G * q[1], [-M * G * along])
    free, q, u = bead()
    assert not is_potential_of(free, M * G * q[1], [-M * G * along])


@pytest.mark.parametrize("depth", [0, L, 100])
@pytest.mark.parametrize("holonomic", [False, True])
def test_both_sides_of_a_switch_count(depth, holonomic):
    equations, q, u = bead(holonomic)
    depth = depth if not holonomic else L / 2
    push = G * sm.Max(0, -depth - q[1])
    assert not is_potential_of(equations, sm.S.Zero, [push * u[1]])
    energy = G * sm.Max(0, -depth - q[1]) ** 2 / 2
    assert is_potential_of(equations, energy, [push * u[1]])
    assert not is_potential_of(equations, 2 * energy, [push * u[1]])


@pytest.mark.parametrize("size", [1e-9, 1.0, 1e24])
def test_a_small_load_is_told_beside_large_ones(size):
    equations, q, u = bead()
    energy, power = size * q[0] ** 2 / 2, -size * q[0] * u[0]
    assert is_potential_of(equations, energy, [power])
    assert not is_potential_of(equations, energy, [power, -1e-9 * size * u[0] ** 2])


@pytest.mark.parametrize("size", [1e-9, 1.0, 1e24])
def test_a_light_bodys_momentum_is_told_beside_that_of_a_heavy_one(size):
    equations, q, u = bead()
    kinetic = size * (u[0] ** 2 + 1e-9 * u[1] ** 2)
    assert has_momenta_of(equations, kinetic - G * q[1], kinetic)
    assert not has_momenta_of(equations, size * u[0] ** 2, kinetic)
