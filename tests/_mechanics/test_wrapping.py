"""SymPy turns forces along a wrapping pathway around: told however they come in."""

import warnings

import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.errors import PyDyUserWarning
from pydy.mechanics import Definition
from pydy.system import System

Q, U = me.dynamicsymbols("q u", real=True)
M, R, K, L0 = sm.symbols("m r k L0", positive=True)
T = me.dynamicsymbols._t
NUMBERS = {M: 2.0, R: 0.5, K: 3.0, L0: 0.2}
TOLD = r"along a WrappingPathway pushes where it should pull.*ForceActuator\(-actuator\.force"


class Bead:
    """A bead on a cylinder that a spring over its surface holds; the force is right or as SymPy's.

    At q = 1.3 the spring's length 0.65 pulls the bead back: u' = −3 · 0.45 / (2 · 0.5) = −1.35.
    """

    def __init__(self, kind):
        N, O = self.N, self.O = me.ReferenceFrame("N"), me.Point("O")
        O.set_vel(N, 0)
        A = N.orientnew("A", "Axis", (Q, N.z))
        start, end = O.locatenew("start", R * N.x), O.locatenew("end", R * A.x)
        start.set_vel(N, 0)
        end.set_vel(N, R * U * A.y)
        path = me.WrappingPathway(start, end, me.WrappingCylinder(R, O, N.z))
        made = {
            "spring": lambda: me.LinearSpring(K, path, equilibrium_length=L0),
            "damper": lambda: me.LinearDamper(K, path),
        }
        wrong = made[kind.removeprefix("right ")]()
        self.actuator = me.ForceActuator(-wrong.force, path) if "right" in kind else wrong
        self.body = me.Particle("bead", end, M)

    def called(self, loads):
        kane = me.KanesMethod(self.N, [Q], [U], kd_eqs=[Q.diff(T) - U])
        kane.kanes_equations([self.body], loads)
        return kane

    def system(self, formed):
        system = me.System(frame=self.N, fixed_point=self.O)
        system.q_ind, system.u_ind, system.kdes = [Q], [U], [Q.diff(T) - U]
        system.add_bodies(self.body)
        system.add_actuators(self.actuator)
        if formed:
            system.form_eoms()
        return system

    def defined(self, loads):
        return Definition(self.N, [Q], [U], bodies=[self.body], loads=loads)


WAYS = {
    "Definition": lambda bead: bead.defined([bead.actuator]),
    "Definition of loads": lambda bead: bead.defined(bead.actuator.to_loads()),
    "KanesMethod": lambda bead: me.KanesMethod(
        bead.N, [Q], [U], kd_eqs=[Q.diff(T) - U], bodies=[bead.body], forcelist=[bead.actuator]
    ),
    "kanes_equations": lambda bead: bead.called(bead.actuator.to_loads()),
    "System": lambda bead: bead.system(formed=False),
    "form_eoms": lambda bead: bead.system(formed=True),
}


@pytest.mark.parametrize("way", WAYS)
def test_a_spring_that_pushes_where_it_should_pull_is_told_once(way):
    with pytest.warns(PyDyUserWarning, match=TOLD) as told:
        System(WAYS[way](Bead("spring")))
    assert len(told) == 1


@pytest.mark.parametrize("way", ["Definition of loads", "kanes_equations", "form_eoms"])
def test_a_damper_that_drives_is_told(way):
    with pytest.warns(PyDyUserWarning, match=TOLD):
        System(WAYS[way](Bead("damper")))


@pytest.mark.parametrize("kind", ["right spring", "right damper"])
@pytest.mark.parametrize("way", WAYS)
def test_a_force_whose_sign_was_chosen_is_not_told(way, kind):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        system = System(WAYS[way](Bead(kind)), constants={k: NUMBERS[k] for k in (M, R, K)})
        system.constants = {k: v for k, v in NUMBERS.items() if k in system.constants_symbols}
    expected = -1.35 if "spring" in kind else -3.0 * 0.4 / 2.0
    assert system.evaluate_ode([1.3, 0.4])[1] == pytest.approx(expected, rel=1e-12)
