"""Which motions have one linear model all along, and which warning others get."""

import warnings

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.optimize import brentq

import zoo
from pydy.analysis.equilibrium_residual import EquilibriumResidual
from pydy.examples import whipple_bicycle
from pydy.mechanics import Definition, Implicit
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.system import System
from pydy.vehicles import CARS, MagicFormula, single_track
from zoo import inertial_frame
from zoo.cases import system_of
from zoo.tires import TABLE_A31

X, V, F = me.dynamicsymbols("x v F")
CHANGES = r"no equilibrium: the derivative of .* changes along the motion"


def on_a_line(force, x, **options):
    """A mass of 1 at x, at rest."""
    frame, origin = inertial_frame()
    place = origin.locatenew("P", X * frame.x)
    made = Definition(
        frame, [X], [V], bodies=[me.Particle("P", place, 1)], loads=[(place, force * frame.x)]
    )
    return System(made, initial_conditions={X: x}, **options)


def driven_arm(weight):
    """An arm on a motor, whose current i is a state of first order: θ, i, filter z, ω."""
    theta, current, z, omega, voltage = me.dynamicsymbols("theta i z omega V")
    frame, arm, origin = inertial_frame()[0], me.ReferenceFrame("A"), me.Point("O")
    origin.set_vel(frame, 0)
    arm.orient_axis(frame, theta, frame.z)
    arm.set_ang_vel(frame, omega * frame.z)
    rotor = me.RigidBody("rotor", origin, arm, 1, (me.inertia(arm, 0, 0, 1), origin))
    torque = current - sm.Rational(1, 10) * omega - weight * sm.sin(theta)
    motor = Definition(
        frame, [theta, current, z], [omega], bodies=[rotor], loads=[(arm, torque * frame.z)],
        kinematic_equations=[
            theta.diff() - omega, current.diff() + current + omega - voltage, z.diff() + z - theta,
        ],
    )  # fmt: skip
    return System(motor)


@pytest.mark.parametrize("free_speed", [False, True])
def test_a_car_in_a_steady_turn_has_one_model_all_along(free_speed):
    """Its place and heading advance; that its velocity over the road turns with it is no change."""
    car = single_track(CARS["bmw_320i"], free_speed=free_speed)
    car.specifieds = {"delta": 0.05}
    unknowns, speed = (["v", "r", "F_x"], {"u": 20.0}) if free_speed else (None, None)
    turn = car.find_equilibrium(unknowns, speed, moving=["x", "y", "psi"])
    car.initial_conditions = turn.initial_conditions
    car.specifieds = {"delta": 0.05, **turn.specifieds}
    model = car.linearize()  # a warning would be an error
    later = car.linearize({"psi": 1.0})
    assert np.sort_complex(model.eigenvalues) == pytest.approx(np.sort_complex(later.eigenvalues))


def test_a_steady_motion_is_recognized_without_the_terms_of_its_rates(monkeypatch):
    """The sizes of all terms take a hundred times as long; a departure alone needs them."""
    calls, terms = [], EquilibriumResidual.terms
    monkeypatch.setattr(EquilibriumResidual, "terms", lambda *a: calls.append(a) or terms(*a))
    car = single_track(CARS["bmw_320i"], MagicFormula(TABLE_A31))
    car.linearize()  # straight ahead
    assert not calls
    car.specifieds = {"delta": 0.05}
    with pytest.warns(UserWarning, match=CHANGES):
        car.linearize()
    assert calls


@pytest.mark.parametrize(
    "force", [1 - 3 * V**2, 1 + X**2, 1 + X * V, 1e9 * (1 - 1e-9 * V**3)], ids=str
)
@pytest.mark.parametrize("times", [None, [0.0, 1e-6]])
def test_a_model_without_a_time_of_its_own_is_warned_of(force, times):
    """All its eigenvalues are zero at rest. What it falls through begins to act as it moves."""
    falling = on_a_line(force, 0.0, times=times)
    with pytest.warns(UserWarning, match=CHANGES):
        falling.linearize()


def test_a_body_that_falls_without_drag_has_one_model_all_along():
    assert not on_a_line(9.81, 0.0).linearize().eigenvalues.any()


def test_a_car_that_begins_to_turn_is_warned_of():
    """The slip angles of its tires change from those at v = r = 0, and their slopes with them."""
    car = single_track(CARS["bmw_320i"], MagicFormula(TABLE_A31))
    car.specifieds = {"delta": 0.05}
    with pytest.warns(UserWarning, match=CHANGES):
        begin = car.linearize()
    after = car.linearize(car.find_equilibrium(moving=["x", "y", "psi"]))
    assert np.abs(begin.A - after.A).max() > 0.1


def test_a_bicycle_in_a_steady_turn_has_one_model_all_along():
    made = whipple_bicycle.derive()
    ride = System(made.definition, constants=whipple_bicycle.benchmark_parameters(made))
    ride.initial_conditions = whipple_bicycle.equilibrium(made, 5.0) | {"phi": 0.1}
    moving = ["x", "y", "psi", "theta_R", "theta_F"]
    turn = ride.find_equilibrium(given={"phi": 0.1}, moving=moving)
    ride.initial_conditions = turn.initial_conditions
    rates = dict(zip(map(str, ride.states), ride.evaluate_ode(), strict=True))
    assert abs(rates["psi(t)"]) > 0.01
    ride.linearize()
    ride.initial_conditions = {**ride.initial_conditions, "u_delta": 0.3}
    ride.set_dependent_initial_conditions()
    with pytest.warns(UserWarning, match=CHANGES):
        ride.linearize()


def test_a_disc_that_rolls_in_a_circle_has_one_model_all_along():
    """The velocity of its contact turns with the yaw; its two components follow from the others.

    At a lean and a spin there is a yaw rate that keeps them, which is searched for.
    """
    model = zoo.disc()
    disc = system_of(model)
    start = {str(s): v for s, v in zip(model.states, model.sample()[0], strict=True)}
    lean, spin = 0.2, 3.0

    def at(turn):
        disc.initial_conditions = dict(start) | {
            "q2(t)": lean, "u1(t)": 0.0, "u2(t)": spin, "u3(t)": turn,
        }  # fmt: skip
        disc.set_dependent_initial_conditions(dep_vars=disc.speeds[3:])
        return disc.evaluate_ode()[5]

    turn = brentq(at, -1.2, 0.0, xtol=1e-15, rtol=1e-15)
    at(turn)
    rates = np.abs(disc.evaluate_ode())
    assert rates[5:8].max() < 1e-10
    assert rates[[0, 2, 3, 4, 8, 9]].min() > 1e-3  # what advances
    disc.linearize()
    at(turn + 0.5)
    with pytest.warns(UserWarning, match=CHANGES):
        disc.linearize()


@pytest.mark.parametrize("weight", [0, 3])
def test_states_of_first_order_neither_hide_a_change_nor_are_one(weight):
    arm = driven_arm(weight)
    arm.initial_conditions = {"theta": 1.0}
    if weight:
        with pytest.warns(UserWarning, match=CHANGES):
            arm.linearize()
    else:  # linear equations
        arm.specifieds, arm.initial_conditions = {"V": 2.0}, {"omega": 1.0, "i": 0.5}
        arm.linearize()


def test_auxiliary_states_are_left_out():
    a = sm.Symbol("a")
    for links, is_warned in (
        (multi_mass_spring_damper(2), False),
        (n_link_pendulum_on_cart(2), True),
    ):
        speed = links.speeds[0]
        links.outputs = {a: a - speed.diff(zoo.T)}
        links.initial_conditions = {links.coordinates[1]: 1.2}
        assert links.num_auxiliaries == 1
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            links.linearize()
        assert ["changes along" in str(w.message) for w in caught] == [True] * is_warned


def test_a_function_is_not_called_at_states_ahead():
    """The torque of a controller is defined near the initial state alone."""
    system = n_link_pendulum_on_cart(1)

    def force(x, t):
        if abs(x[1] - 1.2) > 0.1:
            raise RuntimeError("out of range")
        return -x[1]

    system.specifieds = {"F": force}
    system.initial_conditions = {"q1": 1.2}
    with pytest.warns(UserWarning, match=CHANGES):
        system.linearize()


@pytest.mark.parametrize("unit", [1e-6, 1.0, 1e6])
def test_no_unit_of_length_or_time_matters(unit):
    """A hardening spring −x (1 + (x/unit)²), and one that is linear, with speeds of any size."""
    for rate in (1e-6, 1.0, 1e6):
        linear = on_a_line(-(rate**2) * X, 2.0 * unit)
        linear.linearize()
        hardening = on_a_line(-(rate**2) * X * (1 + (X / unit) ** 2), 2.0 * unit)
        with pytest.warns(UserWarning, match=CHANGES):
            hardening.linearize()


def test_a_model_that_is_singular_ahead_raises_nothing():
    """The force ends at x = 1.05, beyond which its root is not real."""
    system = on_a_line(10 * sm.sqrt(1.05 - X) + 40, 1.0)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        system.linearize()


def test_unknowns_of_an_implicit_are_solved_ahead():
    """s = sin x gives the force −3 s of a pendulum, s = 2 x that of a spring."""
    s = me.dynamicsymbols("s")
    pendulum = on_a_line(-3 * s, 1.0, implicit=Implicit({s: s - sm.sin(X)}))
    with pytest.warns(UserWarning, match=CHANGES):
        pendulum.linearize()
    on_a_line(-3 * s, 1.0, implicit=Implicit({s: s - 2 * X})).linearize()
