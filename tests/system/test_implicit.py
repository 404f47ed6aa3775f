"""Quantities that residuals give, in loads, constraints, outputs and all that is done with them."""

import copy
import pickle

import numpy as np
import pytest
import scipy
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy._judges.discontinuities import Discontinuities
from pydy.analysis import Trial
from pydy.contact import Contacts, Unilateral
from pydy.control import OptimalControl
from pydy.errors import IntegrationError, PyDyUserWarning
from pydy.mechanics import Definition, Implicit
from pydy.solvers import Event
from registry import ADAPTIVE_NAMES
from zoo import inertial_frame

T = me.dynamicsymbols._t
X, Y, V, W, E = me.dynamicsymbols("x, y, v, w, E")
M, K, A, B, R, G = sm.symbols("m, k, a, b, R, g")
TIGHT = {"rtol": 1e-11, "atol": 1e-11}
# The point (a cos E, b sin E) of an ellipse that is nearest to (x, y).
NEAR = (A * sm.cos(E), B * sm.sin(E))
RESIDUAL = (X - NEAR[0]) * A * sm.sin(E) - (Y - NEAR[1]) * B * sm.cos(E)
DISTANCE = sm.sqrt((X - NEAR[0]) ** 2 + (Y - NEAR[1]) ** 2)


def point(loads=(), constraints=()):
    """A particle in a plane."""
    frame, origin = inertial_frame()
    place = origin.locatenew("P", X * frame.x + Y * frame.y)
    place.set_vel(frame, V * frame.x + W * frame.y)
    forces = [(place, f[0] * frame.x + f[1] * frame.y) for f in loads]
    return frame, [me.Particle("P", place, M)], forces, constraints


def definition(*parts, **options):
    frame, bodies, loads, constraints = point(*parts)
    return Definition(
        frame, [X, Y], [V, W], bodies=bodies, loads=loads, holonomic_constraints=constraints,
        **options,
    )  # fmt: skip


def pulled(**options):
    """A particle that a spring pulls to the nearest point of an ellipse."""
    spring = (-K * (X - NEAR[0]), -K * (Y - NEAR[1]))
    settings = {
        "initial_conditions": {X: 3.0, Y: 1.0, W: 1.0},
        "times": np.linspace(0.0, 3.0, 31),
        "ode_solver": "dop853",
        "outputs": {"d": DISTANCE},
        "implicit": Implicit({E: RESIDUAL}, start={E: 0.3}),
    }
    values = {M: 1.0, K: 4.0, A: 2.0, B: 1.0}
    return System(definition([spring]), values, **settings | options)


residual_at = sm.lambdify((X, Y, E, A, B), RESIDUAL)


def test_residuals_are_rounding_at_all_outputs():
    trajectory = pulled().simulate()
    left = residual_at(trajectory["x"], trajectory["y"], trajectory["E"], 2.0, 1.0)
    assert abs(left).max() < 2e-14
    assert trajectory["x"][0] == 3.0


def test_nearest_point_is_that_of_a_search():
    trajectory = pulled().simulate(**TIGHT)
    for k in (0, 10, 30):
        x, y = trajectory["x"][k], trajectory["y"][k]
        found = scipy.optimize.minimize_scalar(
            lambda e, x=x, y=y: (x - 2.0 * np.cos(e)) ** 2 + (y - np.sin(e)) ** 2,
            bracket=(trajectory["E"][k] - 0.1, trajectory["E"][k] + 0.1),
        )
        assert trajectory["d"][k] == pytest.approx(np.sqrt(found.fun), rel=1e-9)


def test_motion_about_a_circle_is_that_of_a_central_force():
    """With b = a the nearest point is known: the force is −k (r − a) along the radius."""
    system = pulled()
    system.constants[B] = 2.0
    radius = sm.sqrt(X**2 + Y**2)
    force = tuple(-K * (1 - A / radius) * c for c in (X, Y))
    other = System(
        definition([force]), {M: 1.0, K: 4.0, A: 2.0},
        initial_conditions={X: 3.0, Y: 1.0, W: 1.0}, times=system.times, ode_solver="dop853",
    )  # fmt: skip
    ours, theirs = system.simulate(**TIGHT), other.simulate(**TIGHT)
    np.testing.assert_allclose(ours["x"], theirs["x"], rtol=0, atol=1e-9)
    np.testing.assert_allclose(
        ours["E"], np.unwrap(np.arctan2(theirs["y"], theirs["x"])), atol=1e-9
    )


def test_kepler_s_equation_gives_the_orbit():
    """The eccentric anomaly gives the place on an orbit that is integrated as well."""
    n, e = sm.symbols("n, e")
    pull = -(n**2) / (X**2 + Y**2) ** sm.Rational(3, 2)
    system = System(
        definition([(M * pull * X, M * pull * Y)]),
        {n: 1.3, e: 0.6},
        initial_conditions={X: 0.4, W: 1.3 * np.sqrt(1.6 / 0.4)},
        times=np.linspace(0.0, 10.0, 41),
        ode_solver="dop853",
        implicit=Implicit({E: E - e * sm.sin(E) - n * T}),
        outputs={"off_x": sm.cos(E) - e - X, "off_y": sm.sqrt(1 - e**2) * sm.sin(E) - Y},
    )
    trajectory = system.simulate(rtol=1e-13, atol=1e-13)
    assert abs(trajectory["off_x"]).max() < 1e-10
    assert abs(trajectory["off_y"]).max() < 1e-10


def test_several_unknowns_are_solved_together():
    """The feet of the common perpendicular of two skew lines."""
    p, q = me.dynamicsymbols("p, q")
    gap = sm.Matrix([p - X, p - q * Y, 1 - q])
    first, second = sm.Matrix([1, 1, 0]), sm.Matrix([0, Y, 1])
    residuals = {p: gap.dot(first), q: gap.dot(second)}
    system = System(
        definition([(-X, -Y)]), initial_conditions={X: 1.0, Y: 0.5, W: 1.0},
        times=np.linspace(0.0, 2.0, 5), ode_solver="tsit5", implicit=Implicit(residuals),
    )  # fmt: skip
    trajectory = system.simulate()
    rows = sm.lambdify((X, Y, p, q), [*residuals.values()])
    left = rows(*(trajectory[name] for name in ("x", "y", "p", "q")))
    assert np.abs(left).max() < 1e-14


# The wheelset of the Test Set for IVP Solvers: cones on rails of circular profile. Conditions of
# contact (14) to (17) of B. Simeon, C. Führer, P. Rentrop, "Introduction to differential-algebraic
# equations in vehicle system dynamics", Surv. Math. Ind. 1 (1991) 1-37; numbers and solutions are
# those of `wheel.f`: positions, then angle and place of contact right and left, at 0 and 10 s.
WHEELSET = {
    0.0: [0.14941e-02, 0.40089e-06, 0.11241e-05, -0.28573e-03, 0.26459e-03,
          -7.4122380357667139e-06, -0.1521364296121248,
          7.5634406395172940e-06, 0.1490635714733819],
    10.0: [0.86355386965811e-02, 0.13038281022727e-04, -0.93635784016818e-04,
           -0.13642299804033e-01, 0.15292895005422e-02,
           -0.33666751972196e-03, -0.15949425684022,
           0.37839614386969e-03, 0.14173214964613],
}  # fmt: skip


def contact(side, x, y, theta, phi, psi, xi):
    """Conditions that the normals are parallel, and the gap; `side` is 1 on the left, or −1."""
    cone, radius, half, rail = 0.0262, 0.1, 0.1506, 0.06
    s, c = sm.sin, sm.cos
    wheel, slope = radius + np.tan(cone) * (half - side * xi), -side * np.tan(cone)
    across = x + xi * c(theta) * c(phi)
    across += wheel * (c(theta) * s(phi) * c(psi) - s(theta) * s(psi))
    beside = side * across - half - np.sin(cone) * rail
    depth = sm.sqrt(rail**2 - beside**2)
    tilt = -side * beside / depth
    parallel = tilt * (slope * s(phi) + c(phi) * c(psi)) + slope * c(theta) * c(phi)
    parallel += s(theta) * s(psi) - c(theta) * s(phi) * c(psi)
    along = slope * s(theta) * c(phi) - s(theta) * s(phi) * c(psi) - c(theta) * s(psi)
    height = depth - radius - np.cos(cone) * rail
    return parallel, along, height - y - xi * s(phi) + wheel * c(phi) * c(psi)


def test_a_wheel_touches_a_rail_where_the_ivp_test_set_says():
    places = me.dynamicsymbols("x, y, z, theta, phi")
    speeds = me.dynamicsymbols("v_x, v_y, v_z, v_theta, v_phi")
    unknowns = me.dynamicsymbols("psi_r, xi_r, psi_l, xi_l")
    x, y, z, theta, phi = places
    frame, origin = inertial_frame()
    axle = frame.orientnew("A", "body", (theta, phi, 0), "yzx")
    centre = origin.locatenew("C", x * frame.x + y * frame.y + z * frame.z)
    inertia = me.inertia(axle, 1, 1, 1)
    right = contact(-1, x, y, theta, phi, *unknowns[:2])
    left = contact(1, x, y, theta, phi, *unknowns[2:])
    wheelset = Definition(
        frame, places, speeds, bodies=[me.RigidBody("W", centre, axle, 1, (inertia, centre))],
        configuration=dict(zip(places, WHEELSET[10.0], strict=False)),
    )  # fmt: skip
    system = System(
        wheelset,
        implicit=Implicit(
            dict(zip(unknowns, (*right[:2], *left[:2]), strict=True)),
            {unknowns[1]: -0.15, unknowns[3]: 0.15},
        ),
        outputs={**dict(zip("abcd", unknowns, strict=True)), "right": right[2], "left": left[2]},
    )
    for values in WHEELSET.values():
        found = system.evaluate_outputs(dict(zip(places, values, strict=False)))
        np.testing.assert_allclose(found[:4], values[5:], rtol=1e-6)
        assert abs(found[4:6]).max() < 1e-8


def test_kanes_method_takes_them_as_a_definition_does():
    frame, bodies, loads, _ = point([(-K * (X - NEAR[0]), -K * (Y - NEAR[1]))])
    kane = me.KanesMethod(
        frame, [X, Y], [V, W], [X.diff() - V, Y.diff() - W], forcelist=loads, bodies=bodies
    )
    kane.kanes_equations()
    ours = pulled()
    theirs = System(
        kane, ours.constants, initial_conditions=ours.initial_conditions, times=ours.times,
        ode_solver="dop853", implicit=Implicit({E: RESIDUAL}, {"E": 0.3}),
    )  # fmt: skip
    assert theirs.states == ours.states
    np.testing.assert_allclose(theirs.evaluate_ode(), ours.evaluate_ode(), rtol=1e-14)


def rolled(b=2.0, **options):
    """A particle at the distance R from an ellipse, with gravity: a bead on its parallel curve."""
    settings = {
        "initial_conditions": {X: 0.3, Y: -2.5, V: 0.2},
        "times": np.linspace(0.0, 4.0, 21),
        "ode_solver": "dop853",
        "implicit": Implicit({E: RESIDUAL}, start={E: -1.5}),
    }
    constraint = (X - NEAR[0]) ** 2 + (Y - NEAR[1]) ** 2 - R**2
    system = System(
        definition([(0, -M * G)], [constraint], dependent_coordinates=[Y]),
        {M: 1.0, A: 2.0, B: b, R: 0.5, G: 9.81},
        **settings | options,
    )
    system.set_dependent_initial_conditions()
    return system


def test_a_constraint_holds_what_a_residual_gives():
    """At a distance from a circle a particle is a pendulum."""
    system = rolled()
    trajectory = system.simulate(**TIGHT)
    angle = np.arctan2(trajectory["x"], -trajectory["y"])
    rate = system.initial_conditions[V] * np.cos(angle[0]) + system.initial_conditions[W] * np.sin(
        angle[0]
    )
    reference = scipy.integrate.solve_ivp(
        lambda t, s: [s[1], -9.81 / 2.5 * np.sin(s[0])], (0.0, 4.0), [angle[0], rate / 2.5],
        t_eval=system.times, method="DOP853", rtol=1e-12, atol=1e-12,
    )  # fmt: skip
    np.testing.assert_allclose(angle, reference.y[0], rtol=0, atol=1e-9)


def test_constraints_and_energy_are_kept_with_an_ellipse():
    trajectory = rolled(b=1.5, initial_conditions={X: 0.3, Y: -2.0, V: 0.2}).simulate(**TIGHT)
    x, y, e = (trajectory[name] for name in ("x", "y", "E"))
    assert abs(residual_at(x, y, e, 2.0, 1.5)).max() < 1e-14
    away = (x - 2.0 * np.cos(e)) ** 2 + (y - 1.5 * np.sin(e)) ** 2
    assert abs(away - 0.25).max() < 1e-14
    total = 0.5 * (trajectory["v"] ** 2 + trajectory["w"] ** 2) + 9.81 * y
    assert np.ptp(total) < 1e-9


@pytest.mark.parametrize("make", [pulled, rolled])
def test_sensitivities_are_those_of_differences(make):
    system = make()
    system.outputs = {"d": E}
    system.times = np.linspace(0.0, 2.0, 5)
    trajectory = system.simulate(sensitivities=[A, X], **TIGHT)
    step = 1e-5
    for column, key in enumerate((A, X)):
        sides = []
        for sign in (1, -1):
            other = copy.copy(system)
            values = other.constants if key == A else other.initial_conditions
            changed = {**values, key: values[key] + sign * step}
            if key == A:
                other.constants = changed
            else:
                other.initial_conditions = changed
            if make is rolled:
                other.set_dependent_initial_conditions([Y, E, *system.speeds[1:]])
            sides.append(other.simulate(**TIGHT)["E"])
        expected = (sides[0] - sides[1]) / (2 * step)
        found = trajectory.sensitivity["E"][:, column]
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-7)


@pytest.mark.parametrize("make", [pulled, rolled])
def test_gradients_back_are_those_forward(make):
    system = make()
    system.outputs = {"d": E * X}
    system.times = np.linspace(0.0, 2.0, 5)
    # Coarse steps leave the constraints farther, so that projections move more.
    loose = {"rtol": 1e-8, "atol": 1e-8}
    forward = system.simulate(sensitivities=[A, X], **loose).sensitivity["d"][-1]
    back = system.adjoint_gradient(final="d", wrt=[A, X], **loose)
    np.testing.assert_allclose([back[A], back[X]], forward, rtol=1e-8)


def test_samples_of_an_ensemble_start_on_their_own_residuals():
    system, values = pulled(), np.linspace(1.7, 2.2, 9)
    found = system.integrate_ensemble(constants={A: values}, **TIGHT)
    assert (found["x"].values[:, 0] == 3.0).all()
    for k in (0, 8):
        system.constants[A] = values[k]
        np.testing.assert_allclose(found["E"].values[k], system.simulate(**TIGHT)["E"], atol=1e-10)


def test_odeint_keeps_residuals_as_well_as_its_tolerances():
    trajectory = pulled(ode_solver=None).simulate(**TIGHT)
    left = residual_at(trajectory["x"], trajectory["y"], trajectory["E"], 2.0, 1.0)
    assert abs(left).max() < 1e-8


def test_values_of_one_call_are_solved_for():
    system = pulled()
    assert system.evaluate_outputs({X: 7.0, Y: 0.0})[0] == pytest.approx(5.0)
    rates = system.evaluate_ode({X: 5.0, Y: 0.0})
    np.testing.assert_allclose(rates[-2:], [-12.0, 0.0], atol=1e-12)


def test_values_of_one_call_are_solved_for_with_the_numbers_of_the_call():
    system, other = pulled(), pulled()
    other.constants[A] = 1.5
    for x in (None, {X: 7.0}):
        for theme in ("evaluate_ode", "evaluate_outputs", "evaluate_jacobian"):
            found, expected = (getattr(system, theme)(x, p={A: 1.5}), getattr(other, theme)(x))
            np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-9)
    whole = np.array([2.5, 1.0, 0.4, 0.1, -0.3])  # is taken as it is
    assert system.evaluate_constraints(whole, p={A: 1.5}) == pytest.approx(
        residual_at(2.5, 1.0, 0.4, 1.5, 1.0)
    )
    along = system.eigenvalues({A: [1.5, 2.0]}, at={X: 2.5}).eigenvalues
    np.testing.assert_allclose(along[0], other.linearize({X: 2.5}).eigenvalues, atol=1e-9)


def test_terms_of_the_equations_are_those_at_what_residuals_give():
    system = pulled()
    other = pulled(initial_conditions={X: 7.0, Y: 1.0})
    other.constants[A] = 1.5
    start = other.simulate(**TIGHT).states[0]
    expected = other.bias(start[:3], start[3:])
    np.testing.assert_allclose(system.bias({X: 7.0}, {W: 0.0}, p={A: 1.5}), expected)


def test_the_unknowns_are_those_of_the_time_of_the_call():
    frame, bodies, _, _ = point()
    time = me.dynamicsymbols._t
    loads = [(bodies[0].masscenter, -E * frame.x)]
    late = System(
        Definition(frame, [X, Y], [V, W], bodies=bodies, loads=loads), {M: 1.0},
        implicit=Implicit({E: E + E**3 - X - time}), initial_conditions={X: 1.0},
    )  # fmt: skip
    assert late.evaluate_ode({X: 7.0}, t=3.0)[-2] == pytest.approx(-2.0)
    slope = late.linearize({X: 7.0}, t=3.0).A[2]
    np.testing.assert_allclose(slope, [-1 / 13, 0, 0, 0], atol=1e-9)


def test_linear_models_leave_out_what_follows():
    model = pulled(initial_conditions={X: 2.0}).linearize()
    assert model.states == ("x", "y", "v", "w")
    assert model.eigenvalues[0].real == pytest.approx(0.0, abs=1e-9)


def test_events_see_what_residuals_give():
    (record,) = pulled().simulate(events=[Event(E - 1.0, name="one")], **TIGHT).events
    assert record.before[2] == pytest.approx(1.0, abs=1e-10)


@pytest.mark.parametrize("direction", [0, -1, 1])
def test_a_reset_may_lead_what_residuals_give_to_the_other_side(direction):
    frame, bodies, _, _ = point()
    moved = System(
        Definition(frame, [X, Y], [V, W], bodies=bodies), {M: 1.0}, ode_solver="dop853",
        implicit=Implicit({E: E + E**3 - X}), initial_conditions={V: 1.0}, times=[0.0, 3.0, 4.75],
    )  # fmt: skip
    back = Event(E - 1.0, direction=direction, reset={X: X - 1.5})
    trajectory = moved.simulate(events=[back], **TIGHT)
    times = [] if direction < 0 else [2.0, 3.5]
    assert [e.time for e in trajectory.events] == pytest.approx(times)
    assert trajectory["x"][-1] == pytest.approx(4.75 - 1.5 * len(times))


def test_contacts_close_on_a_curved_surface():
    """A particle falls on the crest of an ellipse: the gap is the distance to it."""
    normal = sm.Matrix([sm.cos(E) / A, sm.sin(E) / B])
    gap = ((X - NEAR[0]) * normal[0] + (Y - NEAR[1]) * normal[1]) / normal.norm()
    system = System(
        definition([(0, -M * G)]),
        {M: 1.0, A: 2.0, B: 1.0, G: 9.81},
        initial_conditions={X: 0.2, Y: 1.5},
        times=np.linspace(0.0, 0.6, 13),
        ode_solver="dop853",
        implicit=Implicit({E: RESIDUAL}, {E: 1.5}),
    )
    trajectory = Contacts(system, [Unilateral(gap, name="hill")]).simulate(**TIGHT)
    fall = np.sqrt(2 * (1.5 - np.sqrt(1 - 0.01)) / 9.81)
    assert trajectory.modes[0][1] == pytest.approx(fall, abs=1e-9)
    after = trajectory.times > fall
    height = trajectory["x"] ** 2 / 4 + trajectory["y"] ** 2 - 1
    assert abs(height[after]).max() < 1e-8  # it slides down


def test_exports_have_the_state_that_follows(tmp_path):
    system, names = pulled(), {}
    system.export(tmp_path / "model.py")
    exec((tmp_path / "model.py").read_text(), names)
    state = np.array([2.5, 1.0, 0.4, 0.1, -0.3])
    np.testing.assert_allclose(names["rates"](0.0, state), system.evaluate_ode(state), rtol=1e-12)


def test_exports_refuse_resets_that_residuals_would_follow(tmp_path):
    system = pulled()
    system.export(tmp_path / "model.py", events=Event(X - 2.5, reset={V: -V}))
    for state in (X, E):
        with pytest.raises(
            ValueError, match=r"`step` resets .*, which the residuals of `implicit`"
        ):
            system.export(tmp_path / "model.js", events=Event(X, reset={state: 0.1}, name="step"))


def test_a_system_is_pickled_with_them():
    system = pulled()
    other = pickle.loads(pickle.dumps(system.simulate()))
    assert (other["E"] == system.simulate()["E"]).all()


# -- residuals with speeds ------------------------------------------------------------------------

D, C = me.dynamicsymbols("D"), sm.Symbol("c")
DRAG = Implicit({D: D + C * D**3 - V}, {D: 0.3})  # a force that its own law does not give


def dragged(**options):
    settings = {
        "initial_conditions": {X: 1.0, V: 0.5},
        "times": np.linspace(0.0, 3.0, 7),
        "ode_solver": "dop853",
        "outputs": {"e": D * X},
        "implicit": DRAG,
    }
    return System(definition([(-K * X - D, 0)]), {K: 4.0, C: 2.0}, **settings | options)


def swung(implicit=DRAG):
    """The same force on a pendulum."""
    bob = definition([(-D, -G)], [X**2 + Y**2 - R**2], dependent_coordinates=[Y])
    system = System(
        bob, {R: 1.0, C: 2.0, G: 9.81}, initial_conditions={X: 0.6, Y: -0.8, V: 0.4},
        times=np.linspace(0.0, 3.0, 7), ode_solver="dop853", outputs={"e": D * X},
        implicit=implicit,
    )  # fmt: skip
    system.set_dependent_initial_conditions()
    return system


def force_of(v):
    return scipy.optimize.brentq(lambda d: d + 2.0 * d**3 - v, -9.0, 9.0, xtol=1e-15)


@pytest.mark.parametrize("solver", ["dop853", "radau"])
def test_a_force_that_a_residual_gives_of_speeds_is_that_of_a_search(solver):
    trajectory = dragged(ode_solver=solver).simulate(**TIGHT)
    found = scipy.integrate.solve_ivp(
        lambda t, s: [s[1], -4.0 * s[0] - force_of(s[1])], (0.0, 3.0), [1.0, 0.5],
        t_eval=trajectory.times, method="DOP853", **TIGHT,
    )  # fmt: skip
    np.testing.assert_allclose(trajectory["x"], found.y[0], rtol=0, atol=1e-9)
    left = trajectory["D"] + 2.0 * trajectory["D"] ** 3 - trajectory["v"]
    assert abs(left).max() < 1e-14


def test_a_force_that_a_residual_gives_of_speeds_acts_beside_constraints():
    trajectory = swung().simulate(**TIGHT)
    assert abs(trajectory["x"] ** 2 + trajectory["y"] ** 2 - 1.0).max() < 1e-14

    def rates(t, s):
        return [s[1], -9.81 * np.sin(s[0]) - force_of(s[1] * np.cos(s[0])) * np.cos(s[0])]

    start = np.arctan2(0.6, 0.8)
    found = scipy.integrate.solve_ivp(
        rates, (0.0, 3.0), [start, 0.4 / 0.8], t_eval=trajectory.times, method="DOP853", **TIGHT
    )
    np.testing.assert_allclose(trajectory["x"], np.sin(found.y[0]), rtol=0, atol=1e-9)


@pytest.mark.parametrize("make", [dragged, swung])
def test_derivatives_of_motions_with_such_forces_are_those_of_differences(make):
    system, wanted = make(), [C, X, V]
    forward = system.simulate(sensitivities=wanted, **TIGHT).sensitivity["e"][-1]
    back = system.adjoint_gradient(final="e", wrt=wanted, **TIGHT)
    np.testing.assert_allclose([back[key] for key in wanted], forward, rtol=1e-8)
    step, sides = 1e-5, []
    for sign in (1, -1):
        system.constants = {**system.constants, C: 2.0 + sign * step}
        sides.append(system.simulate(**TIGHT)["e"][-1])
    assert forward[0] == pytest.approx((sides[0] - sides[1]) / (2 * step), rel=1e-6)


def test_only_own_switches_of_what_residuals_give_beside_constraints_are_looked_for():
    """Pivots that reduce the constraints were, at thousands of states: 17 s for a pendulum."""
    now = swung()._now()
    jumps = Discontinuities(len(now.definition.equations.coordinates))
    assert jumps(now.code.assembly.fork())["switches"] == []
    kinked = swung(Implicit({D: D + C * D**3 - sm.Abs(V)}))
    with pytest.warns(PyDyUserWarning, match="the rate of D.* jumps by"):
        kinked.simulate(sensitivities=[C])


def test_a_force_that_depends_on_speeds_nonlinearly_acts_beside_constraints():
    """Where the constraints are singular, u' is solved for with their derivatives by time."""

    def bead(force, **options):
        system = System(
            definition([(force, -M * G)], [X**2 + Y**2 - R**2], dependent_coordinates=[Y]),
            {M: 1.0, R: 1.0, G: 9.81, K: 0.5}, initial_conditions={X: 0.3, Y: -0.9},
            times=np.linspace(0.0, 2.0, 5), ode_solver="dop853", **options,
        )  # fmt: skip
        system.set_dependent_initial_conditions()
        return system.simulate(**TIGHT)

    found = bead(-D, implicit=Implicit({D: D * (1 + V**2) - K * V}))
    np.testing.assert_allclose(found["x"], bead(-K * V / (1 + V**2))["x"], rtol=0, atol=1e-9)


def test_the_search_for_starts_ends_where_all_unknowns_are_zero():
    p, q = me.dynamicsymbols("p, q")
    residuals = {p: 3 * p + q * sm.cos(p) - V, q: p + 0.7 * q + q**3 - W}
    system = System(definition(), implicit=Implicit(residuals, {p: 0.1, q: 0.02}))
    rates = system.evaluate_ode({V: 0.0, W: 0.0})
    np.testing.assert_array_equal(rates, 0.0)


def test_linear_models_hold_the_forces_slope():
    model = dragged(initial_conditions={X: 0.0, V: 0.0}).linearize()
    assert model.states == ("x", "y", "v", "w")
    found = sorted(model.eigenvalues, key=abs)[-1]
    assert found.real == pytest.approx(-0.5)
    assert abs(found.imag) == pytest.approx(np.sqrt(3.75))


def test_positions_and_constraints_hold_no_force():
    with pytest.raises(ValueError, match=r"constraint holds D\(t\), whose residuals hold speeds"):
        System(definition([(-D, 0)], [X**2 + Y**2 - R**2 + D]), implicit=DRAG)
    frame, origin = inertial_frame()
    body = me.Particle("P", origin.locatenew("P", (X + D) * frame.x), 1)
    with pytest.raises(ValueError, match=r"position, velocity .* holds D\(t\), whose residuals"):
        System(Definition(frame, [X], [V], bodies=[body]), implicit=DRAG)


# -- errors ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("solver", ADAPTIVE_NAMES)
def test_a_force_that_changes_within_a_part_of_a_step_acts_in_time(solver):
    system = System(
        definition([(-E, 0)]), {M: 1.0}, times=[0.0, 2.0], initial_conditions={},
        ode_solver=solver, implicit=Implicit({E: E - sm.tanh(1000 * (T - 1))}, start={E: -1.0}),
    )  # fmt: skip
    # Of a jump: forward and back by the same impulse.
    assert system.integrate(rtol=1e-9, atol=1e-9)[-1, 0] == pytest.approx(1.0, abs=3e-6)


def rooted(solved, held, **options):
    """A particle on a spring whose force is Z/2, Z + Z³ = held + c: as a residual or a formula."""
    z, c = me.dynamicsymbols("z"), sm.Symbol("c")
    root = 2 / sm.sqrt(3) * sm.sinh(sm.asinh(3 * sm.sqrt(3) / 2 * (held + c)) / 3)
    force = z if solved else root
    frame, origin = inertial_frame()
    place = origin.locatenew("P", X * frame.x)
    push = me.dynamicsymbols("F") - K * X - force / 2
    moved = Definition(
        frame, [X], [V], bodies=[me.Particle("P", place, M)], loads=[(place, push * frame.x)]
    )
    settings = {"times": [0.0, 1.0, 2.0], "ode_solver": "dop853", "outputs": {"f": force + X}}
    if solved:
        settings["implicit"] = Implicit({z: z + z**3 - held - c})
    return System(moved, {K: 2.0, c: 0.3}, **settings | options)


@pytest.mark.parametrize("held", [X, V])
@pytest.mark.parametrize("reset", [{X: 0.1 * K}, {X: X / 2, V: -V / 2}])
def test_derivatives_go_through_resets_as_those_of_the_formula(held, reset):
    """What is solved for again after a reset has the derivatives of the state there."""
    wrt, found = ["c", K, X], []
    for solved in (True, False):
        system = rooted(solved, held, initial_conditions={X: 0.5, V: 1.0})
        options = {"events": Event(X - 0.7, reset=reset, name="hit"), **TIGHT}
        motion = system.simulate(sensitivities=wrt, **options)
        assert motion.events
        sample = system.integrate_ensemble(constants={K: [2.0]}, sensitivities=wrt, **options)
        back = system.adjoint_gradient(wrt, final="f", **options)
        there = motion.sensitivity["f"][-1]
        np.testing.assert_allclose([back[q] for q in wrt], there, rtol=1e-8)
        np.testing.assert_allclose(
            sample.sensitivity.sel(quantity="f").values[0, -1], there, rtol=1e-8
        )
        found.append(there)
    np.testing.assert_allclose(*found, rtol=1e-8)


EFFORT = sm.Integral(me.dynamicsymbols("F") ** 2, T)


@pytest.mark.parametrize("held", [X, V])
@pytest.mark.parametrize("method", ["radau", "hermite-simpson", "midpoint"])
def test_optimal_motions_keep_residuals_from_any_start(held, method):
    """The unknown at the start follows from what `start` says of the others."""
    ours = rooted(True, held)
    motion = ours.optimize_trajectory(
        EFFORT, 1.0, start={X: 0.2, V: 0.0}, end={X: 1.0, V: 0.0}, mesh=20, method=method
    )
    z = motion["z"]
    np.testing.assert_allclose(z + z**3, motion[held] + 0.3, atol=1e-10)
    theirs = rooted(False, held).optimize_trajectory(
        EFFORT, 1.0, start={X: 0.2, V: 0.0}, end={X: 1.0, V: 0.0}, mesh=40
    )
    close = 2e-2 if method == "midpoint" else 1e-5
    assert motion.objective == pytest.approx(theirs.objective, rel=close)


@pytest.mark.parametrize("held", [X, V])
@pytest.mark.parametrize("link", [{}, {V: -V / 2}, {X: X - 0.5}])
def test_unknowns_follow_after_links_of_phases(held, link):
    found = []
    for solved in (True, False):
        system = rooted(solved, held)
        there = OptimalControl(system, EFFORT, 1.0, end={X: 0.5}, mesh=4)
        back = OptimalControl(system, EFFORT, 1.0, end={X: 1.0, V: 0.0}, mesh=4)
        phases = OptimalControl.phases([there, back], [link]).solve()
        found.append(phases.objective)
        for motion in phases if solved else ():
            left = motion["z"] + motion["z"] ** 3 - motion[held] - 0.3
            np.testing.assert_allclose(left, 0.0, atol=1e-9)
    # Residuals give their unknowns and move nothing else: on four intervals, too.
    assert found[0] == pytest.approx(found[1], rel=1e-8)


@pytest.mark.parametrize("method", ["radau", "hermite-simpson"])
def test_constraints_with_unknowns_move_coordinates_as_those_with_the_formula(method):
    """On a coarse mesh: a bead on the curve y = z(x), z + z³ = x, with y in millimetres."""
    z, push = me.dynamicsymbols("z, F")
    root = 2 / sm.sqrt(3) * sm.sinh(sm.asinh(3 * sm.sqrt(3) / 2 * X) / 3)
    found = []
    for height in (z, root):
        frame, origin = inertial_frame()
        place = origin.locatenew("P", X * frame.x + Y / 1000 * frame.y)
        place.set_vel(frame, V * frame.x + W / 1000 * frame.y)
        bead = Definition(
            frame, [X, Y], [V, W], bodies=[me.Particle("P", place, 1)],
            loads=[(place, push * frame.x - 9.81 * frame.y)],
            holonomic_constraints=[Y - 1000 * height],
        )  # fmt: skip
        options = {"implicit": Implicit({z: z + z**3 - X})} if height is z else {}
        system = System(bead, **options)
        motion = system.optimize_trajectory(
            EFFORT, 1.0, end={X: 2.0, V: 0.0}, mesh=4, method=method
        )
        found.append(motion.objective)
    assert found[0] == pytest.approx(found[1], rel=1e-8)


def test_a_fit_by_collocation_finds_what_moved():
    measured = rooted(True, X, initial_conditions={X: 0.5, V: 1.0}).simulate(**TIGHT)
    system = rooted(True, X)
    system.constants = {K: 1.5, "c": 0.1}
    trial = Trial(measured.times, {"x": measured["x"], "f": measured["f"]}, {X: 0.5, V: 1.0})
    found = system.fit([K, "c"], trial, method="collocation").estimates
    np.testing.assert_allclose(found, [2.0, 0.3], rtol=1e-6)


def test_a_residual_holds_no_control():
    z, push = me.dynamicsymbols("z, F")
    system = rooted(True, X, implicit=Implicit({z: z + z**3 - X - sm.Symbol("c") * push}))
    with pytest.raises(NotImplementedError, match="as a control it would not be"):
        system.optimize_trajectory(EFFORT, 1.0, end={X: 1.0}, mesh=4)


def test_a_singular_residual_is_named():
    """On the way through the centre of curvature two nearest points meet."""
    with pytest.raises(
        IntegrationError, match=r"residuals of `implicit` cannot be solved for E\(t\)"
    ):
        System(
            definition(), {A: 2.0, B: 1.0}, initial_conditions={X: 0.3, Y: 0.2, W: -1.0},
            times=[0.0, 5.0], ode_solver="dop853", implicit=Implicit({E: RESIDUAL}, {E: 1.5}),
        ).simulate()  # fmt: skip


def test_a_start_without_solution_is_named():
    system = pulled(implicit=Implicit({E: sm.sin(E) - X}))
    with pytest.raises(ValueError, match=r"`implicit` finds no E\(t\) at t = 0.0 .* is left at"):
        system.simulate()


def test_what_is_not_possible_is_refused():
    frame, bodies, loads, _ = point()
    kane = me.KanesMethod(frame, [X, Y], [V, W], [X.diff() - V, Y.diff() - W])
    kane.kanes_equations(bodies, loads)
    with pytest.raises(ValueError, match=r"`equations='method'` is not possible with `implicit`"):
        System(kane, equations="method", implicit=Implicit({E: E - X}))
    lagrange = me.LagrangesMethod(M * X.diff() ** 2 / 2, [X])
    with pytest.raises(ValueError, match="`implicit` needs the bodies and loads"):
        System(lagrange, implicit=Implicit({E: E - X}))
    with pytest.raises(TypeError, match=r"`implicit` must be a pydy\.mechanics\.Implicit, got"):
        System(definition(), implicit={E: E - X})


def test_a_linear_model_has_what_inputs_move_through_residuals():
    x, y, z, f = me.dynamicsymbols("x y z f")
    frame, place = me.ReferenceFrame("N"), me.Point("P")
    place.set_vel(frame, x.diff() * frame.x)
    bodies, loads = [me.Particle("b", place, 1)], [(place, (-z * y - f * x) * frame.x)]
    implicit = Implicit({z: z**3 + z - K * x - f**2, y: y + sm.sin(y) / 2 - z * f})
    system = System(
        Definition(frame, [x], bodies=bodies, loads=loads), {K: 1.0}, implicit=implicit,
        initial_conditions={x: 1.0}, specifieds={f: 0.7}, outputs={"o": z * y + f},
    )  # fmt: skip
    model, step = system.linearize({}, outputs=["y", "z", "o"]), 1e-5

    def moved(force):
        load = system.evaluate_ode({x: 1.0}, r={f: force})[-1]
        return np.array([load, system.evaluate_outputs({x: 1.0}, r={f: force})[0]])

    by_input = (moved(0.7 + step) - moved(0.7 - step)) / 2.0 / step
    found = [model.B[1, 0], model.D[2, 0]]
    np.testing.assert_allclose(found, by_input, rtol=1e-8)
    held = Definition(frame, [x, E], bodies=bodies, holonomic_constraints=[E - z])
    system = System(held, {K: 1.0}, implicit=implicit, specifieds={f: 0.7})
    system.set_dependent_initial_conditions()
    with pytest.raises(
        ValueError, match=r"constraint 0: E\(t\) - z\(t\) depends on the specified `f`"
    ):
        system.linearize(inputs=[f])
