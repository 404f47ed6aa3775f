"""Trees of any joints, bodies, loads and given velocities: Newton, Euler and SymPy say the same."""

import numpy as np
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from mechanisms import derived
from oracle import Oracle
from pydy._mechanics.form import forms
from pydy._mechanics.kane import multibody_of_kane
from pydy.system import System
from random_trees import Link, accelerations, as_kane, imbalance
from zoo import Model

NUMBERS = st.integers(-20, 20).map(lambda k: k / 16)
VECTORS = st.lists(NUMBERS, min_size=3, max_size=3).map(np.array)


def quiet(examples):
    return settings(
        max_examples=examples,
        derandomize=True,
        database=None,
        deadline=None,
        phases=[Phase.generate, Phase.shrink],
        suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
    )


@st.composite
def links(draw, most):
    """Bodies on hinges and slides, each on any that came before."""
    found = []
    for k in range(draw(st.integers(1, most))):
        slides, axis = draw(st.booleans()), draw(st.integers(0, 2))
        half = np.array([draw(VECTORS) for _ in range(3)])
        centre = draw(VECTORS)
        # Off its own axis, so that a particle there has inertia about it.
        centre[(axis + 1) % 3] += 2.0
        found.append(
            Link(
                parent=draw(st.integers(-1, k - 1)),
                axis=axis,
                slides=slides,
                joint=draw(VECTORS),
                centre=centre,
                mass=draw(st.integers(1, 32)) / 16,
                inertia=half @ half.T + np.eye(3),
                torque=0.0 if slides else draw(NUMBERS),
                push=draw(VECTORS),
                said=draw(st.booleans()),
                referred=draw(st.booleans()),
                skewed=draw(st.booleans()),
                particle=draw(st.booleans()),
            )
        )
    _give_inertia(found)
    return found


def _give_inertia(found):
    """Make rigid what other bodies hang on: particles alone may leave a hinge without inertia."""
    held = {link.parent for link in found}
    for k, link in enumerate(found):
        on = found[link.parent] if link.parent >= 0 else None
        link.particle &= k not in held and (on is None or not on.particle)


def state(n, seed):
    return np.random.default_rng(seed).uniform(-1.0, 1.0, 2 * n)


@quiet(12)
@given(links(10), st.integers(0, 99))
def test_any_tree_obeys_newtons_and_eulers_equations(tree, seed):
    n = len(tree)
    body, x = multibody_of_kane(as_kane(tree, set_velocities=n < 6)), state(n, seed)
    for in_bodies in (True, False):
        for formed in forms(body, in_bodies=in_bodies):
            missing, size = imbalance(tree, x[:n], x[n:], accelerations(formed, x))
            np.testing.assert_array_less(abs(missing), 1e-10 * (size.max() + 1.0))


@quiet(6)
@given(links(2), st.integers(0, 99))
def test_any_small_tree_moves_as_sympys_equations_say(tree, seed):
    kane = as_kane(tree, set_velocities=True)
    x = state(len(tree), seed)
    found = System(kane).evaluate_ode(x)
    expected = Oracle(derived(Model(kane))).xdot(x)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12 * abs(expected).max())


def test_the_trees_are_of_all_kinds():
    seen = set()

    @quiet(12)
    @given(links(10))
    def look(tree):
        seen.update((k, getattr(t, k)) for t in tree for k in ("slides", "said", "particle"))

    look()
    assert len(seen) == 6
