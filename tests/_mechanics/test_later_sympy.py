"""Methods with the attributes that SymPy 1.15 gives them, whose old names raise.

Everywhere else `conftest.py` has the old names of bodies and loads raise as well.
"""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.system import System
from zoo import inertial_frame

T = me.dynamicsymbols._t


class Later(me.LagrangesMethod):
    """Constraints have the names that KanesMethod gives them."""

    def __init__(self, *args, **options):
        super().__init__(*args, **options)
        self.holonomic_constraints = self.__dict__.pop("_hol_coneqs")
        self.velocity_constraints = self.__dict__.pop("coneqs")

    def __getattr__(self, name):
        raise DeprecationWarning(name) if name == "coneqs" else AttributeError(name)


class LaterKane(me.KanesMethod):
    """Nonholonomic constraints alone; the rates of the others are derived."""

    def __init__(
        self, *args, nonholonomic_constraints, configuration_constraints, kd_eqs, **options
    ):
        rates = sm.Matrix(configuration_constraints).diff(T)
        rates = rates.xreplace(sm.solve(kd_eqs, [e.atoms(sm.Derivative).pop() for e in kd_eqs]))
        super().__init__(
            *args,
            kd_eqs=kd_eqs,
            configuration_constraints=configuration_constraints,
            velocity_constraints=rates.col_join(sm.Matrix(nonholonomic_constraints)),
            **options,
        )
        self.nonholonomic_constraints = sm.Matrix(nonholonomic_constraints)


def particle():
    frame, origin = inertial_frame()
    x, y, z = me.dynamicsymbols("x y z")
    point = origin.locatenew("P", x * frame.x + y * frame.y + z * frame.z)
    return frame, (x, y, z), me.Particle("p", point, 2.0), [(point, -9.0 * frame.y)]


def test_constraints_of_a_lagrangian_have_new_names():
    frame, (x, y, z), body, loads = particle()
    states = {}
    for method in (me.LagrangesMethod, Later):
        made = method(
            me.Lagrangian(frame, body), [x, y, z], forcelist=loads, bodies=[body], frame=frame,
            hol_coneqs=[x**2 + y**2 - 4], nonhol_coneqs=[z.diff(T) - x * x.diff(T)],
        )  # fmt: skip
        system = System(made)
        assert system.num_nonholonomic_constraints == 1
        values = dict(zip([x, y, z], [1.2, -1.6, 0.3], strict=True))
        values |= {x.diff(T): 0.8, y.diff(T): 0.6, z.diff(T): 0.96}
        states[method] = system.evaluate_ode([values[s] for s in system.states])
    np.testing.assert_array_equal(*states.values())


def test_a_kanes_method_with_nonholonomic_constraints_alone_is_read():
    frame, q, body, loads = particle()
    u = me.dynamicsymbols("u v w")
    made = LaterKane(
        frame, [q[0], q[2]], [u[0]], kd_eqs=[a.diff(T) - b for a, b in zip(q, u, strict=True)],
        q_dependent=[q[1]], u_dependent=[u[1], u[2]],
        configuration_constraints=[q[1] - 2 * q[0]],
        nonholonomic_constraints=[u[2] - q[0] * u[0]], bodies=[body], forcelist=loads,
    )  # fmt: skip
    system = System(made)
    assert system.num_nonholonomic_constraints == 1
    # m (1 + 4 + x²) u' + m x u² = −2·9
    rates = dict(
        zip(system.states, system.evaluate_ode([0.7, 0.1, 1.4, 0.5, 1.0, 0.35]), strict=True)
    )
    assert rates[u[0]] == pytest.approx((-9.0 - 0.7 * 0.25) / (5 + 0.49), rel=1e-13)
