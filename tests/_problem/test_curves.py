"""Coefficients of muscles' curves that have no value are told of once."""

import warnings

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from sympy.physics.biomechanics import (
    FiberForceLengthActiveDeGroote2016,
    FiberForceLengthPassiveDeGroote2016,
    FiberForceVelocityDeGroote2016,
    MusculotendonDeGroote2016,
    ZerothOrderActivation,
)

from pydy.errors import PyDyUserWarning
from pydy.mechanics import Definition
from pydy.system import System

Q, U = me.dynamicsymbols("q u")
PUBLISHED = {  # De Groote et al. 2016, as SymPy has them
    "fl_M_pas": FiberForceLengthPassiveDeGroote2016,
    "fl_M_act": FiberForceLengthActiveDeGroote2016,
    "fv_M": FiberForceVelocityDeGroote2016,
}


def arm(make):
    """A forearm that a muscle with a rigid tendon flexes."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    A = N.orientnew("A", "Axis", (Q, N.z))
    shoulder, insertion = O.locatenew("S", 0.3 * N.y), O.locatenew("W", 0.05 * A.x)
    muscle = make(
        "b", me.LinearPathway(shoulder, insertion), ZerothOrderActivation("b"),
        peak_isometric_force=sm.Integer(500), optimal_fiber_length=sm.Rational(1, 4),
        tendon_slack_length=sm.Rational(1, 20), maximal_fiber_velocity=sm.Integer(10),
        optimal_pennation_angle=sm.Integer(0), fiber_damping_coefficient=sm.Rational(1, 10),
    )  # fmt: skip
    body = me.RigidBody("arm", O, A, 1, (me.inertia(A, 0, 0, 0.01), O))
    (excitation,) = muscle.r
    definition = Definition(N, [Q], [U], bodies=[body], loads=[muscle])
    return System(definition, specifieds={excitation: 0.5}, initial_conditions={Q: 0.4})


def test_coefficients_without_values_are_told_of_once():
    system = arm(MusculotendonDeGroote2016)
    with pytest.warns(
        PyDyUserWarning, match=r"no value for c_0_fl_M_act_b,.* and 15 more.*`with_defaults`"
    ):
        system.evaluate_ode()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        system.evaluate_ode()


def test_coefficients_with_values_or_numbers_are_not_told_of():
    system = arm(MusculotendonDeGroote2016)
    usual = arm(MusculotendonDeGroote2016.with_defaults)
    published = {}
    for name, curve in PUBLISHED.items():
        for k, value in enumerate(curve.with_defaults(sm.Symbol("x")).args[1:]):
            published[f"c_{k}_{name}_b"] = float(value)
    system.constants = {k: published[k] for k in map(str, system.constants_symbols)}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert np.isclose(system.evaluate_ode()[1], usual.evaluate_ode()[1], rtol=1e-12)
    del system.constants["c_3_fv_M_b"]
    with pytest.warns(PyDyUserWarning, match="no value for c_3_fv_M_b, coefficients"):
        system.evaluate_ode()
