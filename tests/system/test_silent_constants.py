"""Constants that the equations do not hold: of events, and of energies that they cancel in."""

import copy
import pickle

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.analysis import Trial
from pydy.errors import PyDyUserWarning
from pydy.mechanics import Definition
from pydy.solvers import Event
from pydy.system import System
from zoo import inertial_frame
from zoo.cases import close

Q, U = me.dynamicsymbols("q u")
E, G, H, K, M = sm.symbols("e g h k m")
TIGHT = {"rtol": 1e-11, "atol": 1e-11}
TIMES = np.linspace(0.0, 0.8, 9)
BOUNCE = Event(Q, direction=-1, reset={U: -E * U}, name="bounce")


def particle(force, place, rate=U):
    """A particle at some place in q, and what acts on it."""
    frame, origin = inertial_frame()
    point = origin.locatenew("P", sum(p * a for p, a in zip(place, frame, strict=True)))
    load = point, sum(p * a for p, a in zip(force, frame, strict=True))
    return System(
        Definition(
            frame,
            [Q],
            [U],
            bodies=[me.Particle("bob", point, M)],
            loads=[load],
            kinematic_equations=[Q.diff() * U / rate - U],
        )
    )


@pytest.fixture
def ball():
    """A ball that falls from 1 m; it hits the ground at 0.447 s with 4.47 m/s, and at 0.894 s."""
    system = particle((0, -M * G, 0), (0, Q, 0))
    system.constants = {G: 10.0}
    system.initial_conditions = {Q: 1.0}
    system.times, system.ode_solver = TIMES, "dop853"
    return system


def bounced(e, g=10.0, t=TIMES[-1]):
    """The height after the first bounce, and its derivative by e."""
    speed, since = np.sqrt(2.0 * g), t - np.sqrt(2.0 / g)
    return e * speed * since - g * since**2 / 2, speed * since


def test_a_symbol_of_a_reset_is_a_constant(ball):
    height, slope = bounced(1.0)
    close(ball.simulate(events=[BOUNCE], **TIGHT)["q"][-1], height, 1e-9)
    ball.constants[E] = 0.5
    run = ball.simulate(events=[BOUNCE], sensitivities=["e"], **TIGHT)
    height, slope = bounced(0.5)
    close(run["q"][-1], height, 1e-9)
    close(run.sensitivity["q", E][-1], slope, 1e-8)
    assert run.constants[E] == 0.5
    close(ball.integrate(events=BOUNCE, **TIGHT)[-1, 0], height, 1e-9)
    assert ball.constants_symbols == {E, G, M}
    ball.constants = {"e": 0.6, "g": 10.0}
    close(ball.evaluate_ode(), [0.0, -10.0])
    for other in (copy.deepcopy(ball), pickle.loads(pickle.dumps(ball))):
        close(other.simulate(events=[BOUNCE], **TIGHT)["q"][-1], bounced(0.6)[0], 1e-9)


def test_a_symbol_of_an_events_expression_is_a_constant(ball):
    ball.constants["h"] = 0.2
    (event,) = ball.simulate(events=[Event(Q - H, name="low")], **TIGHT).events
    close(event.time, np.sqrt(2 * 0.8 / 10.0), 1e-9)


def test_constants_of_events_are_told(ball):
    with pytest.raises(ValueError, match=r"in events only, .* `system.constants\['e'\] = ...`"):
        ball.constants = {E: 0.5}
    with pytest.raises(ValueError, match=r"in events only, .* `system.constants\['e'\] = ...`"):
        System(ball.eom_method, constants={"e": 0.5})
    with pytest.raises(ValueError, match=r"Did you mean `m`\?$"):
        ball.constants = {"M": 0.5}
    ball.constants[E] = 0.5
    assert "  elsewhere  e = 0.5\n" in repr(ball)
    with pytest.raises(ValueError, match="in events only"):
        ball.evaluate_ode()
    del ball.constants[E]
    assert "elsewhere" not in repr(ball)
    ball.simulate(events=[BOUNCE])
    assert "  elsewhere  e = (1.0)\n" in repr(ball)
    ball.constants["e"] = 0.7
    assert "  elsewhere  e = 0.7\n" in repr(ball)


def test_a_system_may_be_told_the_constants_of_its_events(ball):
    values = {E: 0.5, "g": 10.0}
    told = System(ball.eom_method, values, constants_symbols=[E, G, M], ode_solver="dop853")
    told.initial_conditions, told.times = {Q: 1.0}, TIMES
    assert told.constants_symbols == {E, G, M}
    assert "elsewhere" not in repr(told)
    close(told.evaluate_ode(), [0.0, -10.0])
    close(told.simulate(events=[BOUNCE], **TIGHT)["q"][-1], bounced(0.5)[0], 1e-9)


def test_ensembles_fits_and_gradients_take_the_constants_of_events(ball):
    height, slope = bounced(0.5)
    heights = ball.integrate_ensemble(
        constants={"e": [0.5, 0.9]}, events=[BOUNCE], reduce="final", **TIGHT
    )
    close(heights["q"], [height, bounced(0.9)[0]], 1e-9)
    assert ball.constants_symbols == {G, M}
    gradient = ball.adjoint_gradient([E], final=Q, events=[BOUNCE], **TIGHT)
    close(gradient["e"], slope, 1e-8)  # the height is linear in e, which is 1 here
    falls = [bounced(0.7, t=t)[0] if t > 0.447 else 1.0 - 5.0 * t**2 for t in TIMES]
    found = ball.fit(["e"], Trial(TIMES, {"q": falls}, constants={E: 0.3}), events=[BOUNCE])
    close(found.estimates, [0.7], 1e-7)


def test_a_name_of_something_else_is_no_constant_of_an_event(ball):
    with pytest.raises(ValueError, match="`q` occurs in the events, but no argument provides it"):
        ball.simulate(events=[Event(sm.Symbol("q"))])
    ball.outputs = {"twice": 2 * Q}
    with pytest.raises(ValueError, match="`events` hold `twice`, the name of an output"):
        ball.simulate(events=[Event(sm.Symbol("twice"))])
    with pytest.warns(PyDyUserWarning, match="several symbols of one name: g, g .positive"):
        ball.simulate(events=[Event(Q - sm.Symbol("g", positive=True))])


def test_constants_that_cancel_from_the_equations_have_values_in_energies():
    system = particle((-K * Q, -M * G, 0), (Q, H, 0))
    assert system.constants_symbols == {K, M}
    close(system.evaluate_energy([0.3, 0.2])[1], 0.045 + 1.0)
    close(system.evaluate_energy([0.3, 0.2], p={"g": 9.81, H: 2.0})[1], 0.045 + 2 * 9.81)
    system.constants = {"g": 9.81, M: 3.0}
    system.constants[H] = 2.0
    assert system.constants_symbols == {G, H, K, M}
    close(system.evaluate_energy([0.3, 0.2])[1], 0.045 + 6 * 9.81)
    system.initial_conditions, system.times, system.ode_solver = {Q: 0.3}, TIMES, "dop853"
    run = system.simulate(sensitivities=[G])
    close(run.energy[:, 2], np.full(len(TIMES), 0.045 + 6 * 9.81), 1e-8)
    close(run.sensitivity["q", G], np.zeros(len(TIMES)))
    with pytest.raises(ValueError, match="`nothing`, which is not one of the constants"):
        system.constants = {"nothing": 1.0}


LAWS = {
    "piecewise": (-K * sm.Piecewise((Q, Q > 0), (0, True)), 2.0 * 0.3**2 / 2),
    "sine": (-K * sm.sin(Q), 2.0 * (1.0 - np.cos(0.3))),
    "linear": (-K * Q, 2.0 * 0.3**2 / 2),
}


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("rate", [U, U / 2, U / (2 * H)])
def test_a_spring_has_an_energy_whatever_the_speed_is_a_multiple_of(law, rate):
    force, expected = LAWS[law]
    system = particle((force, 0, 0), (Q, 0, 0), rate)
    system.constants[K] = 2.0
    stretched, slack = (system.evaluate_energy([q, 0.0]).potential for q in (0.3, 0.0))
    close(stretched - slack, expected, 1e-14)


def test_springs_on_two_coordinates_have_an_energy_where_speeds_are_sums():
    (x, y), (v, w) = me.dynamicsymbols("x y"), me.dynamicsymbols("v w")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", x * frame.x + y * frame.y)
    system = System(
        Definition(
            frame,
            [x, y],
            [v, w],
            bodies=[me.Particle("bob", point, M)],
            loads=[(point, -K * sm.sin(x) * frame.x - K * sm.sin(2 * y) * frame.y)],
            kinematic_equations=[x.diff() - v - w, y.diff() - v + 3 * w],
        )
    )
    found = system.evaluate_energy([0.3, 0.2, 0.0, 0.0])[1] - system.evaluate_energy(np.zeros(4))[1]
    close(found, 1.0 - np.cos(0.3) + (1.0 - np.cos(0.4)) / 2, 1e-14)
