"""How many functions of the package, in how many files, a public call enters: the same each time.

A call is made again, so that nothing is imported or compiled for it. What it enters tells how much
is interpreted, checked or built anew that depends on no number.
"""

import sys
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import pydy
from pydy.contact import Contacts, Unilateral
from pydy.solvers import Event
from pydy.system import System
from zoo import inertial_frame

PACKAGE = f"{Path(pydy.__file__).parent}/"


class Route:
    """The functions that a call enters, and the longest detour: the deepest chain of them."""

    def __init__(self, action):
        self.entered, self.deepest, stack = Counter(), [], []

        def note(frame, event, argument):
            code = frame.f_code
            if not code.co_filename.startswith(PACKAGE):
                return
            name = code.co_filename.removeprefix(PACKAGE), code.co_qualname
            if event == "call":
                self.entered[name] += 1
                stack.append(name)
                if len(stack) > len(self.deepest):
                    self.deepest = stack.copy()
            elif event == "return" and stack:
                stack.pop()

        sys.setprofile(note)
        try:
            action()
        finally:
            sys.setprofile(None)

    @property
    def files(self):
        files = Counter()
        for file, _ in self.entered:
            files[file] += 1
        return files

    def __str__(self):
        files = ", ".join(f"{number} in {file}" for file, number in self.files.most_common())
        chain = "\n    ".join(f"{file}: {function}" for file, function in self.deepest)
        return (
            f"{len(self.entered)} functions in {len(self.files)} files: {files}\n"
            f"the longest detour, {len(self.deepest)} calls deep:\n    {chain}"
        )


def kane():
    """A pendulum, before its equations are derived."""
    q, u = me.dynamicsymbols("q u")
    m, g, l = sm.symbols("m g l")
    frame, origin = inertial_frame()
    rod = frame.orientnew("A", "Axis", (q, frame.z))
    rod.set_ang_vel(frame, u * frame.z)
    bob = origin.locatenew("P", -l * rod.y)
    bob.v2pt_theory(origin, frame, rod)
    method = me.KanesMethod(frame, [q], [u], [q.diff() - u])
    method.kanes_equations([me.Particle("bob", bob, m)], [(bob, -m * g * frame.y)])
    return method


def pendulum():
    system = System(kane(), constants={"m": 1.0, "g": 9.81, "l": 1.0})
    system.initial_conditions = {"q": 0.3}
    system.times, system.ode_solver = np.linspace(0.0, 1.0, 11), "dop853"
    return system


def on_a_circle(force=0):
    """The same in Cartesian coordinates."""
    x, y, u, v = me.dynamicsymbols("x y u v")
    frame, origin, bob = me.ReferenceFrame("N"), me.Point("O"), me.Point("P")
    origin.set_vel(frame, 0)
    bob.set_pos(origin, x * frame.x + y * frame.y)
    bob.set_vel(frame, u * frame.x + v * frame.y)
    rates, circle = [x.diff() - u, y.diff() - v], x**2 + y**2 - 1
    method = me.KanesMethod(
        frame, [x], [u], rates, q_dependent=[y], configuration_constraints=[circle],
        u_dependent=[v], velocity_constraints=[2 * x * u + 2 * y * v],
    )  # fmt: skip
    loads = [(bob, force * frame.x - 9.81 * frame.y)]
    method.kanes_equations([me.Particle("bob", bob, 1)], loads)
    system = System(method, initial_conditions={x: 0.6, y: -0.8}, ode_solver="dop853")
    system.times = np.linspace(0.0, 1.0, 11)
    return system


def integrate():
    return pendulum().integrate


def simulate():
    system = on_a_circle()
    events = [Event(system.states[0], name="bottom")]
    return lambda: system.simulate(events=events, constraints="project")


def with_event():
    """Its event never happens: what is beyond `simulate` is what such an event costs."""
    system = pendulum()
    (q,) = system.coordinates
    events = [Event(sm.cos(q) + 3, terminal=True, name="never")]
    return lambda: system.simulate(events=events)


def with_contacts():
    """Its contact stays open: what is beyond `simulate` is what an inactive contact costs."""
    system = pendulum()
    (q,) = system.coordinates
    return Contacts(system, [Unilateral(sm.cos(q) + 3)]).simulate


def ensemble():
    system = pendulum()
    return lambda: system.integrate_ensemble(initial_conditions={"q": [0.1, 0.2, 0.3]})


def stiff_ensemble():
    system = pendulum()
    system.ode_solver = "radau"
    return lambda: system.integrate_ensemble(initial_conditions={"q": [0.1, 0.2, 0.3]})


def construct():
    methods = [kane(), kane(), kane()]
    return lambda: System(methods.pop())


@pytest.mark.parametrize(
    ("make", "functions", "files"),
    [
        (construct, 663, 63),
        (integrate, 31, 16),
        (simulate, 113, 32),
        (with_contacts, 129, 36),
        (ensemble, 97, 28),
        (stiff_ensemble, 102, 28),
    ],
    ids=lambda value: getattr(value, "__name__", ""),
)
def test_a_repeated_call_takes_a_short_path(make, functions, files):
    call = make()
    for _ in range(2 if make is construct else 70):  # until what is checked has been compiled
        call()
    path = Route(call)
    assert len(path.entered) <= functions, str(path)
    assert len(path.files) <= files, str(path)


@pytest.mark.parametrize(("make", "most"), [(with_event, 12), (with_contacts, 103)])
def test_what_never_happens_makes_few_calls_more(make, most):
    """Calls, not functions: each takes time, however often it is the same."""
    calls = []
    for call in (pendulum().simulate, make()):
        for _ in range(70):
            call()
        calls.append(Route(call).entered.total())
    without, inactive = calls
    assert inactive - without <= most, calls


def pushed():
    """It drifts off the circle: what forces do to that is looked at after each motion."""
    force = me.dynamicsymbols("F")
    system = on_a_circle(force)
    system.specifieds = {force: 0.1}
    return system


@pytest.mark.parametrize(
    ("make", "call"),
    [
        (pendulum, lambda system: system.integrate()),
        (pendulum, lambda system: system.simulate(sensitivities=["l"])),
        (pendulum, lambda system: system.adjoint_gradient(["l"], final=system.states[0])),
        (pendulum, lambda system: system.integrate_ensemble(constants={"l": [1.0, 1.1]})),
        (with_contacts, lambda simulate: simulate()),
        (pushed, lambda system: system.integrate(rtol=1e-5, atol=1e-5)),
        (
            pushed,
            lambda system: system.integrate_ensemble(
                specifieds={"F": [0.0, 0.1]}, rtol=1e-5, atol=1e-5
            ),
        ),
    ],
)
def test_a_repeated_call_compares_and_differentiates_no_symbols(make, call):
    """SymPy's comparisons are dear, and searches for a symbol make as many as there are states."""
    system, called = make(), Counter()
    for _ in range(12):
        call(system)

    def note(frame, event, argument):
        code = frame.f_code
        dear = code.co_name in ("__eq__", "diff") and "sympy" in code.co_filename
        dear = dear or code.co_name == "lower_nodes"
        if event == "call" and dear and frame.f_back.f_code.co_filename.startswith(PACKAGE):
            called[code.co_qualname] += 1

    sys.setprofile(note)
    try:
        call(system)
    finally:
        sys.setprofile(None)
    assert not called
