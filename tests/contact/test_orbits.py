"""Periodic motions through transitions and impacts, and their Floquet multipliers."""

import math

import mpmath
import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.contact import Contacts, Stick, Unilateral
from pydy.mechanics import Definition
from pydy.solvers import Event
from zoo import inertial_frame
from zoo.touching import J, N, O, a, ball, e, falling_body, k, m, mu, slope, vx, vy, w, x, y

a0 = sm.Symbol("a0")


@pytest.mark.parametrize("inertia", [0.3, 1e-4])
def test_the_gait_of_a_rimless_wheel(inertia):
    half, tilt = math.pi / 8, 0.08
    spokes = [(math.sin(2 * half * j), -math.cos(2 * half * j)) for j in range(2)]
    system, feet = falling_body(spokes, tilt=slope, mu=mu)
    system.constants[J], system.constants[slope] = inertia, -tilt
    contacts = Contacts(system, feet, {mu: 5.0})
    system.initial_conditions = {y: 1.0, w: -0.5, vx: 0.5}  # in the middle of a step, too slow
    orbit = system.find_periodic_orbit(
        1.0, contacts=contacts, moving=[x, a], until=Event(a + 2 * half, direction=-1)
    )
    # ω² after an impact is r² (ω² + gain): so are small changes. For J = 0 it is 1.0954628396.
    ratio = (inertia + math.cos(2 * half)) / (inertia + 1)
    gain = 4 * 9.81 * math.sin(half) * math.sin(tilt) / (inertia + 1)
    impact = next(one for one in orbit.trajectory.events if one.name.endswith("closes"))
    assert -impact.after[5] == pytest.approx(math.sqrt(ratio**2 * gain / (1 - ratio**2)), abs=1e-10)
    assert orbit.multipliers[0] == pytest.approx(ratio**2, abs=1e-8)
    assert abs(orbit.multipliers[1:]).max() < 1e-8
    assert orbit.stable
    # The start that is returned is one that a simulation takes as it is.
    system.initial_conditions, system.times = orbit.initial_conditions, [0.0, orbit.period]
    again = contacts.simulate(rtol=1e-11, atol=1e-12)
    assert again["w"] == pytest.approx(orbit.initial_conditions[w] * np.ones(2), abs=1e-9)


def test_stick_and_slip_on_a_belt():
    belt, static = sm.symbols("belt static")
    P = O.locatenew("P", x * N.x)
    P.set_vel(N, vx * N.x)
    numbers = {k: 20.0, belt: 0.1, mu: 0.3, static: 0.6}
    system = System(
        Definition(N, [x], [vx], bodies=[me.Particle("P", P, m)], loads=[(P, -k * x * N.x)]),
        {k: 20.0}, {}, "dop853", {vx: 0.1},
    )  # fmt: skip
    rub = Stick(vx - belt, mu=mu, mu_static=static, normal=9.81, name="belt")
    contacts = Contacts(system, [rub], numbers)
    # In 30 digits: from one end of the slide to the other with the belt, and back on an arc.
    with mpmath.workdps(30):
        rate, load, speed = mpmath.sqrt(20), mpmath.mpf("9.81") / 20, mpmath.mpf("0.1")
        reach = load * (mpmath.mpf("0.6") - mpmath.mpf("0.3"))
        angle = mpmath.atan2(speed / rate, reach)
        period = 2 * reach / speed + (mpmath.pi + 2 * angle) / rate
    orbit = system.find_periodic_orbit(3.0, contacts=contacts)
    assert orbit.autonomous
    assert orbit.period == pytest.approx(float(period), abs=1e-10)
    # Sticking forgets all but the phase.
    assert orbit.multipliers == pytest.approx([1.0, 0.0], abs=1e-8)


RATIO, PERIOD = 0.8, 0.5


def ball_on_a_table(share):
    """A ball on a table that moves by `share` of where its orbit of one period doubles.

    It rebounds with the table's period T: v⁺ = g T/2, v⁻ = −g T/2, v⁺ − c = −e (v⁻ − c) with the
    speed c of the table. The determinant of the changes from impact to impact is e², as the flow
    keeps areas; their trace is 1 + e² + (1 + e)² A/g with its acceleration A. (P. J. Holmes,
    The dynamics of repeated impacts with a sinusoidally vibrating table, Journal of Sound and
    Vibration 84 (1982), 173–189, has the limit of high flights.)
    """
    turns, half = 2 * math.pi / PERIOD, 9.81 * PERIOD / 2
    across = half * (1 - RATIO) / (1 + RATIO) / turns
    rise = share * math.hypot(across, 2 * 9.81 * (1 + RATIO**2) / (1 + RATIO) ** 2 / turns**2)
    angle = math.acos(across / rise)
    height = k * sm.sin(turns * (me.dynamicsymbols._t - PERIOD / 2) + a0)
    table = Unilateral(y - height, restitution=e, name="table")
    system, _ = ball()
    apex = rise * math.sin(angle) + 9.81 * PERIOD**2 / 8
    trace = 1 + RATIO**2 - (1 + RATIO) ** 2 * rise * math.sin(angle) * turns**2 / 9.81
    values = {e: RATIO, k: rise, a0: angle}
    return system, Contacts(system, [table], values), apex, trace, values


@pytest.mark.parametrize("share", [0.5, 1.0])
def test_a_ball_on_a_table_that_moves_up_and_down(share):
    system, contacts, apex, trace, _ = ball_on_a_table(share)
    system.initial_conditions = {y: apex + 0.002, vy: -0.01}
    orbit = system.find_periodic_orbit(PERIOD, contacts=contacts)
    assert not orbit.autonomous
    assert orbit.initial_conditions[y] == pytest.approx(apex, abs=1e-9)
    (impact,) = orbit.trajectory.events
    assert impact.before[1] == pytest.approx(-9.81 * PERIOD / 2, abs=1e-9)
    assert np.prod(orbit.multipliers).real == pytest.approx(RATIO**2, abs=1e-7)
    assert np.sum(orbit.multipliers).real == pytest.approx(trace, abs=1e-7)
    if share == 1.0:
        assert orbit.multipliers[0] == pytest.approx(-1.0, abs=1e-6)


def test_where_the_period_of_a_ball_on_a_table_doubles():
    each = [ball_on_a_table(share) for share in (0.97, 1.03)]
    system, contacts, *_ = each[0]
    result = system.integrate_ensemble(
        contacts=contacts, times=np.linspace(0.0, 60 * PERIOD, 3), rtol=1e-8, atol=1e-10,
        initial_conditions={y: [one[2] + 1e-3 for one in each]},
        constants={s: [one[4][s] for one in each] for s in (k, a0)}, reduce=("events", 80),
    )  # fmt: skip
    assert set(result["table closes_count"].values) == {60}
    flights = np.diff(result["table closes_times"].values[:, :60], axis=1)[:, -6:]
    assert flights[0] == pytest.approx(PERIOD, abs=1e-3)
    assert flights[1, 1:] - flights[1, :-1] == pytest.approx(
        [(-1) ** j * (flights[1, 1] - flights[1, 0]) for j in range(5)], abs=1e-3
    )
    assert abs(flights[1, 1] - flights[1, 0]) > 0.02


def test_contacts_of_another_system_are_named():
    (system, floor), (other, _) = ball(), ball()
    with pytest.raises(TypeError, match="`contacts` must be Contacts of this System, got"):
        other.find_periodic_orbit(1.0, contacts=Contacts(system, [floor]))


def test_modes_whose_constraints_name_no_dependents_say_what_to_call():
    """The message named `sensitivities`, which no argument of the search gives."""
    x, y, u, v = me.dynamicsymbols("x y u v")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x + y * frame.y)
    place.set_vel(frame, u * frame.x + v * frame.y)
    block = Definition(
        frame, [x, y], [u, v], bodies=[me.Particle("block", place, 1)],
        loads=[(place, -9 * frame.y - x * frame.x)],
    )  # fmt: skip
    system = System(block, ode_solver="dop853", initial_conditions={u: 1.0})
    system = Contacts(system, [Unilateral(y, name="floor")]).in_modes({"floor": "closed"})
    with pytest.raises(ValueError, match=r"Call `set_dependent_initial_conditions\(dep_vars"):
        system.find_periodic_orbit(6.0)
    system.set_dependent_initial_conditions(dep_vars=[y, v])
    assert system.find_periodic_orbit(6.0).period == pytest.approx(2 * np.pi, rel=1e-8)
