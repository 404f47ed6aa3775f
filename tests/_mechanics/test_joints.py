"""Equations read from systems of joints, against those that SymPy's form_eoms() gives."""

import warnings

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.system import System
from zoo import joints
from zoo.cases import close
from zoo.joints import SYSTEMS

T = me.dynamicsymbols._t


def formed(system, *method):
    """SymPy's own equations."""
    with warnings.catch_warnings():
        # Deprecated classes; and points that hang on several others.
        warnings.simplefilter("ignore")
        system.form_eoms(*method)
    return system


def compared(own, other, tolerance=1e-12):
    """Both right-hand sides at one random state, in the order of the first."""
    rng = np.random.default_rng(4)
    x = {s: rng.uniform(0.2, 0.9) for s in own.states}
    p = {s: rng.uniform(0.5, 1.5) for s in own.constants_symbols}
    r = {s: rng.uniform(0.5, 1.5) for s in own.specifieds_symbols} or None
    found = own.evaluate_ode([x[s] for s in own.states], 0.3, r=r, p=p)
    expected = other.evaluate_ode([x[s] for s in other.states], 0.3, r=r, p=p)
    expected = dict(zip(other.states, expected, strict=True))
    close(found, [expected[s] for s in own.states], tolerance)


@pytest.mark.parametrize("name", SYSTEMS)
def test_the_equations_are_those_of_form_eoms(name):
    own = System(SYSTEMS[name]())
    other = System(formed(SYSTEMS[name]()), equations="method")
    assert set(own.states) == set(other.states)
    compared(own, other)


@pytest.mark.parametrize("name", ["tied_cart_pendulum", "double_pendulum"])
def test_a_system_whose_equations_were_formed_can_be_formed_on_the_graph_too(name):
    system = formed(SYSTEMS[name]())
    compared(System(system, equations="graph"), System(system, equations="method"))


@pytest.mark.parametrize("name", ["four_bar", "tied_cart_pendulum", "sleigh"])
def test_dependent_coordinates_and_speeds_need_not_be_named(name):
    named, system = SYSTEMS[name](), SYSTEMS[name]()
    q, u = system.q, system.u
    system.q_dep, system.u_dep = [], []
    system.q_ind, system.u_ind = q, u
    own, other = System(system), System(named)
    assert own.num_constraints == other.num_constraints
    # Not all of one size: a rhombus can fold.
    other.constants = {s: 1.0 + 0.07 * k for k, s in enumerate(other.constants_symbols)}
    own.constants = other.constants
    rng = np.random.default_rng(2)
    other.initial_conditions = {s: rng.uniform(0.4, 0.8) for s in other.states}
    other.set_dependent_initial_conditions()
    x = other.initial_conditions
    found = own.evaluate_ode([x[s] for s in own.states])
    expected = dict(zip(other.states, other.evaluate_ode(), strict=True))
    close(found, [expected[s] for s in own.states], 1e-9)


def test_speeds_that_are_derivatives_make_lagranges_equations():
    own = System(joints.cart_pendulum("q'"))
    other = System(formed(joints.cart_pendulum("q'"), me.LagrangesMethod), equations="method")
    assert own.speeds == [q.diff(T) for q in own.coordinates]
    compared(own, other)


def test_the_object_that_was_given_is_kept():
    system = joints.pin()
    assert System(system).eom_method is system


def test_energies_are_those_of_the_bodies():
    system = System(joints.pin())
    system.constants = dict.fromkeys(system.constants_symbols, 0.7)
    system.initial_conditions = {system.coordinates[0]: 0.5}
    system.times = np.linspace(0.0, 1.0, 11)
    system.ode_solver = "dop853"
    motion = system.simulate(rtol=1e-11, atol=1e-11)
    assert np.ptp(system.evaluate_energy(motion.states, motion.times).total) < 1e-9


def test_what_cannot_be_read_is_named():
    with pytest.raises(ValueError, match=r"call its `form_eoms\(\)`"):
        System(joints.pin(), equations="method")
    q, u = me.dynamicsymbols("q u")
    wall, first, second = (me.RigidBody(name) for name in ("wall", "first", "second"))
    system = me.System.from_newtonian(wall)
    system.add_joints(
        me.PinJoint("a", wall, first, q, q.diff(T)),
        me.PinJoint("b", first, second, sm.Function("p")(T), u),
    )
    with pytest.raises(ValueError, match=r"give all joints speeds of one kind"):
        System(system)
