"""The kinetic energy of the method's bodies, and the mass matrix that it gives."""

import copy
import pickle

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.system import System
from zoo.cases import close, system_of, wide

UNCONSTRAINED = [
    *("chain", "undamped_chain", "pendulum", "free_pendulum"),
    *("free_body", "timed", "shaken", "bare"),
]


def numbers(model, x, t):
    still = dict.fromkeys(model.kane._uaux, 0)
    states = dict(zip(model.states, x, strict=True))
    return {**model.constants, **model.specifieds, **states, **still, zoo.T: t}


def hessian(system, x, t):
    """The mass matrix of all speeds, as a solver gets it."""
    system.generate_ode_function()
    kernel = system.model.compiled("kinetic_hessian")
    r = np.array([system.specifieds.get(s, 0.0) for s in system.specifieds_symbols])
    p = np.array([system.constants[s] for s in system.constants_symbols])
    out, _ = kernel.evaluate(np.array([t]), x[None], r[None], p)
    return out.reshape(kernel.program.signature.blocks[0].shape)


@pytest.mark.parametrize("name", zoo.MODELS)
def test_the_kinetic_energy_is_sympys(name):
    model = zoo.MODELS[name]()
    x, t = model.sample()
    rates = model.kane.kindiffdict()
    expected = me.kinetic_energy(model.kane._inertial, *model.kane.bodies).xreplace(rates)
    actual = system_of(model).kinetic_energy
    assert not actual.has(*(q.diff(zoo.T) for q in model.kane.q), *model.kane._uaux)
    values = numbers(model, x, t)
    assert float(actual.xreplace(values)) == pytest.approx(float(expected.xreplace(values)))


@pytest.mark.parametrize("name", UNCONSTRAINED)
def test_the_hessian_of_an_unconstrained_system_is_its_mass_matrix(name):
    model = zoo.MODELS[name]()
    x, t = model.sample()
    expected = model.kane.mass_matrix.xreplace(numbers(model, x, t))
    close(hessian(system_of(model), x, t), expected.tolist(), 1e-13)


@pytest.mark.parametrize("name", ["disc", "disc_contact", "sleigh", "fourbar", "track", "lifted"])
def test_the_hessian_of_a_constrained_system_is_that_of_sympys_energy(name):
    model = zoo.MODELS[name]()
    x, t = model.sample()
    system = system_of(model)
    energy = me.kinetic_energy(model.kane._inertial, *model.kane.bodies)
    energy = energy.xreplace(model.kane.kindiffdict())
    expected = sm.hessian(energy, list(model.kane.u)).xreplace(numbers(model, x, t))
    matrix = hessian(system, wide(system, x), t)
    close(matrix, expected.tolist(), 1e-13)
    np.testing.assert_array_equal(matrix, matrix.T)


@pytest.mark.parametrize("way", [copy.deepcopy, lambda s: pickle.loads(pickle.dumps(s))])
def test_a_copy_of_a_system_still_knows_its_bodies(way):
    model = zoo.disc()
    x, t = model.sample()
    system = system_of(model)
    expected = hessian(system, x, t)
    close(hessian(way(system), x, t), expected, 1e-14)


def test_a_method_without_bodies_has_no_energy():
    x, v = me.dynamicsymbols("x v")
    frame = me.ReferenceFrame("N")
    kane = me.KanesMethod(frame, [x], [v], kd_eqs=[x.diff() - v])
    point = me.Point("P")
    point.set_vel(frame, v * frame.x)
    kane.kanes_equations([me.Particle("A", point, 1)], [(point, -x * frame.x)])
    kane._bodylist = None
    with pytest.raises(ValueError, match="has no bodies"):
        System(kane).kinetic_energy


def test_a_lagrangian_without_bodies_has_no_potential_energy_of_zero():
    x, g = me.dynamicsymbols("x"), sm.Symbol("g")
    lagrange = me.LagrangesMethod(x.diff() ** 2 / 2 - g * x, [x])
    lagrange.form_lagranges_equations()
    system = System(lagrange)
    with pytest.raises(ValueError, match=r"has no bodies, .* bodies=\[…\], frame=N"):
        system.potential_energy
    system.potential_energy = g * x
    assert system.potential_energy == g * x


def test_the_hessian_holds_specifieds_that_are_expressions():
    """The pivot's rate, driven by the speed, moves the bob but is no speed itself."""
    model = zoo.shaken()
    _, u = model.states
    y = me.dynamicsymbols("y")
    rate = y.diff(zoo.T)
    system = system_of(model, specifieds={rate: 0.3 * u, y: 0.1, rate.diff(zoo.T): 0.0})
    x, t = model.sample()
    now = system._now()
    kernel = now.code.compiled("kinetic_hessian")
    p = np.array([system.constants[s] for s in system.constants_symbols])
    out, _ = kernel.evaluate(np.array([t]), x[None], np.zeros((1, 3)), p)
    m, n = sm.symbols("m l")
    assert out[0, 0] == pytest.approx(float((m * n**2).xreplace(model.constants)))
