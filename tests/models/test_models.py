"""The two sample systems: their symbols, flags and physics."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from sympy.physics.mechanics import models as sympy_models

import zoo
from oracles.oracle import Oracle
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.system import System
from zoo.cases import close


def numbered(system, seed=0):
    """Give the system generic constants, and return a generic state."""
    rng = np.random.default_rng(seed)
    system.constants = {s: float(rng.uniform(0.5, 2.0)) for s in system.constants_symbols}
    return rng.uniform(-1.0, 1.0, system.num_states)


def constant(system, name):
    return system.constants[sm.Symbol(name)]


# multi_mass_spring_damper


def test_the_chain_is_a_system_of_one_mass_by_default():
    system = multi_mass_spring_damper()
    assert isinstance(system, System)
    assert str(system.states) == "[x0(t), v0(t)]"
    assert str(system.constants_symbols) == "{c0, k0, m0}"
    assert system.specifieds_symbols == set()


@pytest.mark.parametrize("n", [1, 2, 4])
def test_the_chain_has_the_documented_symbols(n):
    system = multi_mass_spring_damper(n, True, True)
    assert [str(s) for s in system.coordinates] == [f"x{i}(t)" for i in range(n)]
    assert [str(s) for s in system.speeds] == [f"v{i}(t)" for i in range(n)]
    names = {f"{a}{i}" for a in "mkc" for i in range(n)} | {"g"}
    assert {s.name for s in system.constants_symbols} == names
    assert {str(s) for s in system.specifieds_symbols} == {f"f{i}(t)" for i in range(n)}


@pytest.mark.parametrize("gravity", [False, True])
@pytest.mark.parametrize("forces", [False, True])
@pytest.mark.parametrize("n", [1, 3])
def test_every_mass_of_the_chain_obeys_newton(n, forces, gravity):
    system = multi_mass_spring_damper(n, apply_gravity=gravity, apply_external_forces=forces)
    state = numbered(system)
    x, v = state[:n], state[n:]
    push = {s: 0.3 + i for i, s in enumerate(system.specifieds_symbols)}
    system.specifieds = push
    m, k, c = ([constant(system, f"{a}{i}") for i in range(n)] for a in "mkc")
    g = constant(system, "g") if gravity else 0.0
    pull = [k[i] * x[i] + c[i] * v[i] for i in range(n)] + [0.0]
    outer = [0.3 + i if forces else 0.0 for i in range(n)]
    absolute = [(pull[i + 1] - pull[i] + outer[i]) / m[i] + g for i in range(n)]
    close(system.evaluate_ode(state), [*v, *np.diff(absolute, prepend=0.0)])


def test_the_chain_hangs_still_at_its_stretched_lengths():
    system = multi_mass_spring_damper(3, apply_gravity=True)
    numbered(system)
    m, k = ([constant(system, f"{a}{i}") for i in range(3)] for a in "mk")
    g = constant(system, "g")
    stretch = [sum(m[i:]) * g / k[i] for i in range(3)]
    close(system.evaluate_ode([*stretch, 0, 0, 0]), np.zeros(6))


def test_without_gravity_there_is_no_g():
    assert sm.Symbol("g") not in multi_mass_spring_damper(2).constants_symbols


@pytest.mark.parametrize("n", [1, 2])
def test_the_last_flag_puts_sin_t_in_place_of_the_forces(n):
    forced = multi_mass_spring_damper(n, False, True)
    system = multi_mass_spring_damper(n, False, True, external_force_as_sin_of_t=True)
    assert system.specifieds_symbols == set()
    state = numbered(system)
    forced.constants = dict(system.constants)
    for t in (0.0, 0.7, 4.0):
        forced.specifieds = dict.fromkeys(forced.specifieds_symbols, np.sin(t))
        close(system.evaluate_ode(state, t), forced.evaluate_ode(state, t))


def test_an_undamped_mass_swings_with_its_period():
    system = multi_mass_spring_damper()
    m, k, c = sm.symbols("m0 k0 c0")
    system.constants = {m: 2.0, k: 8.0, c: 0.0}
    system.initial_conditions = {system.states[0]: 0.7}
    system.times = np.linspace(0.0, 2.0 * np.pi, 9)
    x = system.integrate(rtol=1e-11, atol=1e-11)
    close(x[:, 0], 0.7 * np.cos(2 * system.times), 1e-8)


# n_link_pendulum_on_cart


def test_the_pendulum_is_a_system_with_one_link_and_a_force_by_default():
    system = n_link_pendulum_on_cart()
    assert isinstance(system, System)
    assert str(system.states) == "[q0(t), q1(t), u0(t), u1(t)]"
    assert str(system.constants_symbols) == "{g, l0, m0, m1}"
    assert str(system.specifieds_symbols) == "{F(t)}"


@pytest.mark.parametrize("force", [False, True])
@pytest.mark.parametrize("torques", [False, True])
@pytest.mark.parametrize("n", [1, 3])
def test_the_pendulum_is_that_of_sympy(n, torques, force):
    system = n_link_pendulum_on_cart(n, cart_force=force, joint_torques=torques)
    names = ({"F(t)"} if force else set()) | (
        {f"T{i + 1}(t)" for i in range(n)} if torques else set()
    )
    assert {str(s) for s in system.specifieds_symbols} == names
    state = numbered(system)
    system.specifieds = {s: 0.3 + i for i, s in enumerate(system.specifieds_symbols)}
    kane = sympy_models.n_link_pendulum_on_cart(n, cart_force=force, joint_torques=torques)
    model = zoo.Model(kane, dict(system.constants), dict(system.specifieds))
    close(system.evaluate_ode(state), Oracle(model).xdot(state))


def test_small_swings_of_a_hanging_link_have_the_known_frequency():
    system = n_link_pendulum_on_cart(1, cart_force=False)
    m0, m1, length, g = sm.symbols("m0 m1 l0 g")
    system.constants = {m0: 3.0, m1: 0.5, length: 0.8, g: 9.81}
    q = system.coordinates[1]
    small = 1e-5
    system.initial_conditions = {q: np.pi + small}
    period = 2 * np.pi / np.sqrt(9.81 / 0.8 * (1 + 0.5 / 3.0))
    system.times = [0.0, period / 2, period]
    x = system.integrate(rtol=1e-12, atol=1e-14)
    np.testing.assert_allclose(x[:, 1] - np.pi, [small, -small, small], rtol=1e-5)


@pytest.mark.parametrize("model", [multi_mass_spring_damper, n_link_pendulum_on_cart])
def test_a_model_can_be_integrated_at_once(model):
    system = model(2)
    system.times = [0.0, 0.1]
    assert system.integrate().shape == (2, system.num_states)


@pytest.mark.parametrize("make", [multi_mass_spring_damper, n_link_pendulum_on_cart])
def test_the_method_is_sympys_and_is_derived_when_it_is_asked_for(make, monkeypatch):
    derived = []
    kanes_equations = me.KanesMethod.kanes_equations

    def noted(kane, *args):
        derived.append(kane)
        return kanes_equations(kane, *args)

    monkeypatch.setattr(me.KanesMethod, "kanes_equations", noted)
    system = make(2)
    state = numbered(system)
    found = system.evaluate_ode(state)
    assert not derived
    kane = system.eom_method
    assert derived == [kane]
    assert system.eom_method is kane
    assert [*kane.q, *kane.u] == system.states
    close(System(kane, system.constants, equations="method").evaluate_ode(state), found, 1e-12)


def test_the_sample_systems_can_be_solved_symbolically():
    system = n_link_pendulum_on_cart(1)
    state = numbered(system)
    found = system.evaluate_ode(state)
    system.generate_ode_function(linear_sys_solver="sympy")
    close(system.evaluate_ode(state), found, 1e-12)
