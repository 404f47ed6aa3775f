"""Gradients and products with Jacobians and Hessians, against the Jacobian and complex steps."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy import System
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from zoo import by_hand

t = me.dynamicsymbols._t


@pytest.fixture(scope="module")
def cart():
    system = n_link_pendulum_on_cart(2)
    q0, q1, q2 = system.coordinates
    system.outputs = {
        me.dynamicsymbols("reach"): sm.sin(q1) + sm.sin(q2),
        me.dynamicsymbols("push"): system.speeds[1].diff() * q0**2,
    }
    return system


STATE = np.array([0.3, 0.5, -0.8, 1.1, -0.4, 0.9])


def test_the_gradient_of_an_output_is_its_row_of_the_jacobian(cart):
    for wrt in ("states", "constants", ["m1", "u2", "F"]):
        whole = cart.evaluate_jacobian(STATE, wrt=wrt, of="outputs")
        for k, name in enumerate(("reach", "push")):
            found = cart.evaluate_gradient(name, STATE, wrt=wrt)
            np.testing.assert_allclose(found, whole[k], rtol=1e-12, atol=1e-15)


def test_groups_stand_in_lists_for_their_symbols(cart):
    found = cart.evaluate_jacobian(STATE, wrt=["constants", "q1"])
    constants = cart.evaluate_jacobian(STATE, wrt="constants")
    assert np.array_equal(found[:, :-1], constants)
    assert np.array_equal(found[:, -1:], cart.evaluate_jacobian(STATE, wrt=["q1"]))


def test_a_gradient_comes_with_its_value(cart):
    value, gradient = cart.evaluate_gradient("push", STATE, value=True)
    assert value == pytest.approx(cart.evaluate_outputs(STATE)[1], rel=1e-14)
    values, gradients = cart.evaluate_gradient("push", [STATE] * 3, [0, 1, 2], value=True)
    assert values.shape == (3,)
    assert gradients.shape == (3, 6)
    np.testing.assert_allclose(gradients[2], gradient, rtol=1e-14)


def test_the_gradient_of_the_energy_gives_the_momenta(cart):
    u = cart.speeds
    momenta = cart.evaluate_gradient(cart.kinetic_energy, STATE, wrt=u)
    M = cart.evaluate_hessian_vector(np.eye(3), cart.kinetic_energy, STATE, wrt=u)
    np.testing.assert_allclose(momenta, M @ STATE[3:], rtol=1e-13)
    np.testing.assert_allclose(M, M.T, rtol=1e-13)


@pytest.mark.parametrize("name", ["fourbar", "disc", "branches", "mixed_speeds", "added_mass"])
def test_products_are_those_with_the_jacobian(name):
    if hasattr(zoo, name):
        case = getattr(zoo, name)()
        system = System(case.kane)
        system.constants = dict(case.constants)
    else:
        system = System(getattr(by_hand, name)().kane)
    rng = np.random.default_rng(3)
    n = len(system.states)
    x = rng.normal(0.3, 0.5, n)
    for wrt in ("states", "constants"):
        J = system.evaluate_jacobian(x, 0.2, wrt)
        v, w = rng.normal(size=(J.shape[1], 2)), rng.normal(size=(n, 3))
        forward = system.evaluate_jacobian_vector(v, x, 0.2, wrt)
        backward = system.evaluate_vector_jacobian(w, x, 0.2, wrt)
        scale = np.abs(J).max()
        np.testing.assert_allclose(forward, J @ v, rtol=1e-12, atol=1e-12 * scale)
        np.testing.assert_allclose(backward, J.T @ w, rtol=1e-12, atol=1e-12 * scale)
        np.testing.assert_allclose(w.T @ forward, backward.T @ v, rtol=1e-11, atol=1e-12 * scale)


def test_products_take_several_states_with_a_vector_each(cart):
    x = STATE + np.arange(4)[:, None] / 10
    J = cart.evaluate_jacobian(x, np.zeros(4))
    v = np.arange(24.0).reshape(4, 6)
    found = cart.evaluate_jacobian_vector(v, x, np.zeros(4))
    np.testing.assert_allclose(found, np.einsum("mij,mj->mi", J, v), rtol=1e-12, atol=1e-12)
    both = cart.evaluate_vector_jacobian(np.stack([v, v], axis=2), x, np.zeros(4))
    assert both.shape == (4, 6, 2)
    np.testing.assert_allclose(both[:, :, 1], np.einsum("mij,mi->mj", J, v), rtol=1e-12, atol=1e-12)
    same = cart.evaluate_jacobian_vector(v[0], x, np.zeros(4))
    np.testing.assert_allclose(same, J @ v[0], rtol=1e-12, atol=1e-12)


def test_the_hessian_of_an_output_is_that_of_its_expression():
    system = multi_mass_spring_damper()
    (x0, v0), (m, k) = (
        system.states,
        [s for s in system.constants_symbols if s.name in ("m0", "k0")],
    )
    f = m * sm.exp(x0 * v0) / k + sm.sin(x0)
    symbols, at = [x0, v0, m, k], [0.3, -0.7, 1.5, 2.5]
    expected = sm.hessian(f, symbols).subs(dict(zip(symbols, at, strict=True)))
    system.outputs = {me.dynamicsymbols("f"): f}
    system.constants = {m: 1.5, k: 2.5}
    found = system.evaluate_hessian_vector(np.eye(4), "f", at[:2], wrt=symbols)
    np.testing.assert_allclose(found, np.array(expected, dtype=float), rtol=1e-14)


def test_derivatives_go_through_specifieds_that_are_expressions():
    system = multi_mass_spring_damper(apply_external_forces=True)
    x0, v0 = system.states
    system.specifieds = {"f0": -3 * x0 * v0}
    np.testing.assert_allclose(
        system.evaluate_jacobian_vector([1.0, 0.5], [2.0, 4.0]),
        system.evaluate_jacobian([2.0, 4.0]) @ [1.0, 0.5],
    )
    assert system.evaluate_gradient("x0", wrt="v0").tolist() == [0.0]


def test_the_jacobian_is_taken_of_chosen_outputs_and_expressions(cart):
    q = cart.coordinates
    found = cart.evaluate_jacobian(STATE, of=["push", q[0] ** 2, "reach"], wrt="states")
    whole = cart.evaluate_jacobian(STATE, of="outputs")
    np.testing.assert_allclose(found[[2, 0]], whole, rtol=1e-13)
    np.testing.assert_allclose(found[1], [0.6, 0, 0, 0, 0, 0])


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda s: s.evaluate_gradient("outputs"), "`of` must be outputs of the system"),
        (lambda s: s.evaluate_gradient(["reach", "push"]), "`of` must be one output or expression"),
        (lambda s: s.evaluate_jacobian(of="nothing"), r"`of` must be one of 'ode'.*got 'nothing'"),
        (lambda s: s.evaluate_jacobian(of=[]), "at least one output or expression"),
        (lambda s: s.evaluate_jacobian_vector([1.0]), r"must have the shape \(6,\) or \(6, d\)"),
        (lambda s: s.evaluate_jacobian_vector(np.ones((4, 5)), [STATE] * 4, np.zeros(4)),
         r"\(6,\), \(4, 6\) or \(4, 6, d\)"),
        (lambda s: s.evaluate_vector_jacobian([1.0], of="holonomic"), "nothing of this kind"),
        (lambda s: s.evaluate_gradient(sm.Symbol("bogus")), "bogus"),
        (lambda s: s.evaluate_gradient("push", wrt="bogus"), "`wrt` must be one of"),
        (lambda s: s.evaluate_gradient("push", value="yes"), "`value`"),
    ],
)  # fmt: skip
def test_what_does_not_fit_is_named(cart, call, message):
    with pytest.raises((ValueError, TypeError), match=message):
        call(cart)
