"""q' from kinematic equations."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy._mechanics.rates import solve_rates
from pydy.mechanics import Definition
from zoo import inertial_frame

X, Y, Z, H = Q = me.dynamicsymbols("x, y, z, h")
RATES = [s.diff() for s in Q]
SPEEDS = me.dynamicsymbols("u1:5")


def plane(equations, method):
    frame, origin = inertial_frame()
    centre = origin.locatenew("P", X * frame.x + Y * frame.y + Z * frame.z)
    turned = frame.orientnew("A", "Axis", (H, frame.z))
    body = me.RigidBody("b", centre, turned, 2, (me.inertia(turned, 1, 1, 3), centre))
    if method is Definition:
        return Definition(frame, Q, SPEEDS, kinematic_equations=equations, bodies=[body])
    return me.KanesMethod(frame, Q, SPEEDS, kd_eqs=equations, bodies=[body], forcelist=[])


SIN, COS = sm.sin(H), sm.cos(H)
# Regular at h = 0, where the first pivot is zero: in blocks of two and one, and as a whole.
COUPLED = {
    "blocks": [[SIN, -COS, 0, 0], [COS, SIN, 0, 0], [0, 1, 0, 1], [0, 0, 1, 1]],
    "whole": [[SIN, -COS, 0, 1], [COS, SIN, 1, 0], [1, 0, 1, 3], [0, 2, 1, 1]],
    "numbers": [[1, 2, 0, 1], [2, 4, 1, 0], [1, 0, 1, 3], [0, 2, 1, 1]],
}


@pytest.mark.parametrize("method", [Definition, me.KanesMethod])
@pytest.mark.parametrize("coupled", COUPLED)
def test_no_pivot_of_coupled_equations_is_zero_where_they_are_regular(coupled, method):
    matrix = sm.Matrix(COUPLED[coupled])
    equations = list(matrix * sm.Matrix(RATES) - sm.Matrix(SPEEDS))
    system = System(plane(equations, method))
    for h in (0.0, 1e-9, 0.3):
        found = system.evaluate_ode([0.0, 0.0, 0.0, h, 1.0, 0.5, 0.2, 0.1])
        given = np.array(matrix.subs(H, h).evalf(), dtype=float)
        np.testing.assert_allclose(given @ found[:4], [1.0, 0.5, 0.2, 0.1], atol=1e-14)
        assert np.isfinite(found).all()


def test_many_equations_that_depend_on_each_other_are_refused():
    matrix = sm.Matrix(COUPLED["whole"][:3])
    matrix = matrix.col_join(matrix[0, :] * COS - matrix[1, :] + matrix[2, :])
    equations = list(matrix * sm.Matrix(RATES) - sm.Matrix(SPEEDS))
    with pytest.raises(ValueError, match=r"`kd_eqs` cannot be solved .* depend on each other"):
        solve_rates(equations, RATES, "kd_eqs")


def test_nothing_is_divided_by_where_the_determinant_is_one():
    """That of three rotations, one after the other, which SymPy multiplies out for minutes."""
    frames = [me.ReferenceFrame("N")]
    for name in "ABC":
        angles = me.dynamicsymbols(f"{name}:3")
        frames.append(frames[-1].orientnew(name, "Body", angles, "ZXY"))
    rates, speeds = RATES[:3], SPEEDS[:3]
    vector = sum((r * a for r, a in zip(rates, frames[0], strict=True)), me.Vector(0))
    equations = [vector.dot(a) - u for a, u in zip(frames[-1], speeds, strict=True)]
    found = solve_rates(equations, rates, "kd_eqs")
    assert not any(power.exp.is_negative for e in found for power in e.atoms(sm.Pow))
