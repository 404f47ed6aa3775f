"""Collocation schemes as data."""

import numpy as np
import pytest

from pydy.control import schemes
from pydy.control.schemes import Scheme

SCHEMES = [Scheme("radau", 1), Scheme("radau", 2), Scheme("radau", 5), Scheme("midpoint"),
           Scheme("hermite-simpson")]  # fmt: skip
MESH = np.array([0.0, 0.2, 0.5, 1.0])


def test_radau_points_of_order_3_are_those_of_hairer_and_wanner():
    root = np.sqrt(6.0)  # Solving ODEs II, table IV.5.6
    np.testing.assert_allclose(
        schemes.radau_points(3), [(4 - root) / 10, (4 + root) / 10, 1.0], rtol=1e-14
    )


@pytest.mark.parametrize("K", [1, 2, 3, 6, 9])
def test_radau_quadrature_is_exact_to_degree_2k_minus_2(K):
    c = schemes.radau_points(K)
    w = schemes.quadrature(c)
    for degree in range(2 * K - 1):
        assert w @ c**degree == pytest.approx(1.0 / (degree + 1), rel=1e-12)


def test_derivatives_of_polynomials_are_exact():
    nodes = np.append(0.0, schemes.radau_points(4))
    D = schemes.derivatives(nodes)
    np.testing.assert_allclose(D @ nodes**4, 4 * nodes**3, atol=1e-12)


def slots_of(scheme, function, slope, duration):
    times, slopes = scheme.states.times_on(MESH)
    return np.where(slopes, slope(times * duration), function(times * duration))


@pytest.mark.parametrize("scheme", SCHEMES, ids=str)
def test_points_reproduce_polynomials_of_the_schemes_degree(scheme):
    degree = {"radau": scheme.order, "midpoint": 1, "hermite-simpson": 3}[scheme.name]
    T = 1.7
    x = np.polynomial.Polynomial(np.arange(1.0, degree + 2.0))
    values = slots_of(scheme, x, x.deriv(), T)
    for points in scheme.points(MESH):
        t, h = points.fractions * T, points.lengths * T
        known = iter(points.coefficients)
        for terms, exact in ((points.state, x), (points.rate, x.deriv())):
            found = sum(
                (next(known) if c is None else c) * values[points.slots[y]] * h**p
                for y, c, p in terms
            )
            np.testing.assert_allclose(found, exact(t), rtol=1e-12)


@pytest.mark.parametrize("scheme", SCHEMES, ids=str)
def test_weights_integrate_over_the_mesh(scheme):
    degree = {"radau": 2 * scheme.order - 2, "midpoint": 1, "hermite-simpson": 3}[scheme.name]
    for k in range(degree + 1):
        found = sum((p.weights * p.fractions**k).sum() for p in scheme.points(MESH))
        assert found == pytest.approx(1.0 / (k + 1), rel=1e-12)


@pytest.mark.parametrize("scheme", SCHEMES, ids=str)
def test_interpolants_pass_through_their_slots(scheme):
    slots = scheme.states.of_intervals(len(MESH) - 1)
    times, slopes = scheme.states.times_on(MESH)
    for k in range(len(MESH) - 1):
        own = slots[:, k][~slopes[slots[:, k]]]
        s = (times[own] - MESH[k]) / (MESH[k + 1] - MESH[k])
        basis, powers = scheme.states.basis(s)
        unit = np.eye(len(own))
        np.testing.assert_allclose(basis[: len(own)], unit, atol=1e-13)
        assert not powers[: len(own)].any()
    controls = scheme.controls.of_intervals(len(MESH) - 1)
    assert sorted(set(controls.ravel())) == list(range(len(scheme.controls.times_on(MESH)[0])))


def test_the_cubic_of_hermite_simpson_has_the_given_slopes():
    scheme = Scheme("hermite-simpson")
    ends = np.array([0.0, 1.0])
    step = 1e-6
    left, right = (scheme.states.basis(np.clip(ends + d, 0, 1))[0] for d in (-step, step))
    slopes = (right - left)[2:] / step
    np.testing.assert_allclose(slopes, np.eye(2), atol=1e-5)


@pytest.mark.parametrize("scheme", SCHEMES, ids=str)
def test_constraints_hold_at_every_node_but_the_first(scheme):
    points = scheme.points(MESH, constrained=True)
    held = np.concatenate([p.fractions for p in points if p.rows in ("all", "constraints")])
    assert set(MESH[1:]) <= set(held)
    assert 0.0 not in held
    # As many multipliers as rows that determine them.
    start = sum(p.rows == "start" for p in points)
    assert len(held) + start == len(scheme.controls.times_on(MESH)[0])
    # Motion and objective are those of motions without constraints.
    motion = [p for p in points if p.rows != "constraints"]
    for name in ("fractions", "weights"):
        joined = np.concatenate([getattr(p, name) for p in motion])
        free = np.concatenate([getattr(p, name) for p in scheme.points(MESH)])
        np.testing.assert_array_equal(joined, free)
