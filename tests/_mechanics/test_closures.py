"""Forces at joints inside closed loops, by auxiliary speeds, against Newton's and Euler's laws."""

import functools

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System

CRANK, COUPLER, ROCKER, GROUND, DENSITY, GRAVITY = 0.3, 0.9, 0.6, 0.8, 1.2, 9.81
Q = q1, q2, q3 = me.dynamicsymbols("q1:4")
U = u1, u2, u3 = me.dynamicsymbols("u1:4")
UX, UY, UZ, RX, RY = me.dynamicsymbols("u_x u_y u_z R_x R_y")
T = me.dynamicsymbols._t
LENGTHS = (CRANK, COUPLER, ROCKER)
RATES = [q.diff(T) - u for q, u in zip(Q, U, strict=True)]


class FourBar:
    """Uniform bars; the pin between crank and coupler opens by two auxiliary speeds."""

    def __init__(self, named_ends=True):
        N = self.N = me.ReferenceFrame("N")
        frames = [N.orientnew(f"F{k}", "Axis", (q, N.z)) for k, q in enumerate(Q)]
        for frame, u in zip(frames, U, strict=True):
            frame.set_ang_vel(N, u * N.z)
        origin, far = self.origin, _ = me.Point("O"), me.Point("D")
        origin.set_vel(N, 0)
        far.set_pos(origin, GROUND * N.x)
        far.set_vel(N, 0)
        pin = origin.locatenew("P", CRANK * frames[0].x)
        pin.v2pt_theory(origin, N, frames[0])
        opened = pin.locatenew("Pb", 0 * N.x)
        opened.set_vel(N, pin.vel(N) + UX * N.x + UY * N.y)
        starts = [origin, opened, far]
        self.bodies, self.loads = [], [(opened, RX * N.x + RY * N.y), (pin, -RX * N.x - RY * N.y)]
        for start, frame, length in zip(starts, frames, LENGTHS, strict=True):
            centre = start.locatenew(f"G{frame}", length / 2 * frame.x)
            centre.v2pt_theory(start, N, frame)
            mass = DENSITY * length
            inertia = me.inertia(frame, 0, 0, mass * length**2 / 12)
            body = me.RigidBody(str(frame), centre, frame, mass, (inertia, centre))
            self.bodies.append(body)
            self.loads.append((centre, -mass * GRAVITY * N.y))
        if named_ends:
            tip = opened.locatenew("Q", COUPLER * frames[1].x)
            tip.v2pt_theory(opened, N, frames[1])
            end = far.locatenew("Qc", ROCKER * frames[2].x)
            end.v2pt_theory(far, N, frames[2])
            gap, slip = tip.pos_from(end), tip.vel(N) - end.vel(N)
            self.loop = [gap.dot(N.x), gap.dot(N.y)]
            self.velocity = [slip.dot(N.x), slip.dot(N.y)]
        else:
            signs = (1, 1, -1)
            self.loop = [
                sum(s * c * f(q) for s, c, q in zip(signs, LENGTHS, Q, strict=True)) - shift
                for f, shift in ((sm.cos, GROUND), (sm.sin, 0))
            ]

    def definition(self, order=(0, 1, 2), **options):
        q, u = ([symbols[k] for k in order] for symbols in (Q, U))
        return Definition(
            self.N, q, u, bodies=self.bodies, loads=self.loads, auxiliary_speeds=[UX, UY],
            holonomic_constraints=self.loop, dependent_coordinates=[q2, q3],
            dependent_speeds=[u2, u3], **options,
        )  # fmt: skip

    def kane(self, called):
        still = [e.subs({UX: 0, UY: 0}) for e in self.velocity]
        method = me.KanesMethod(
            self.N, [q1], [u1], RATES, q_dependent=[q2, q3], u_dependent=[u2, u3],
            configuration_constraints=self.loop, velocity_constraints=still,
            u_auxiliary=[UX, UY], bodies=self.bodies, forcelist=self.loads,
            constraint_solver="CRAMER",
        )  # fmt: skip
        if called:
            method.kanes_equations(self.bodies, self.loads)
        return method

    def system(self, formed):
        system = me.System(frame=self.N, fixed_point=self.origin)
        system.q_ind, system.q_dep, system.u_ind, system.u_dep = [q1], [q2, q3], [u1], [u2, u3]
        system.u_aux, system.kdes = [UX, UY], RATES
        system.add_bodies(*self.bodies)
        system.add_loads(*(me.Force(*load) for load in self.loads))
        system.holonomic_constraints = self.loop
        if formed:
            system.form_eoms()
        return system


WAYS = {
    "Definition": lambda bar: bar.definition(),
    "dependent ones first": lambda bar: bar.definition(order=(2, 1, 0)),
    "dependent ones around": lambda bar: bar.definition(order=(1, 0, 2)),
    "KanesMethod": lambda bar: bar.kane(called=False),
    "kanes_equations": lambda bar: bar.kane(called=True),
    "System": lambda bar: bar.system(formed=False),
    "form_eoms": lambda bar: bar.system(formed=True),
}


def closed_at(system):
    system.initial_conditions = {q1: 0.9, q2: 0.4, q3: 1.6, u1: 2.0}
    system.set_dependent_initial_conditions([q2, q3, u2, u3])
    return np.array([system.initial_conditions.get(s, 0.0) for s in (*Q, *U)])


def by_newton(q, w):
    """The force on the coupler at the crank: all joint forces are unknowns, none is left out.

    Of each bar, m a = forces + weight and I α = moments; the joints O, P, Q, D hold them.
    """
    along = np.array([np.cos(q), np.sin(q)]).T
    across = np.array([-np.sin(q), np.cos(q)]).T
    matrix, right = np.zeros((11, 11)), np.zeros(11)
    held = [((0, 1), (1, -1)), ((1, 1), (2, -1)), ((2, 1), (3, 1))]
    for k, length in enumerate(LENGTHS):
        mass, rows = DENSITY * length, slice(3 * k, 3 * k + 2)
        moved = [(k, length / 2)] if k != 1 else [(0, CRANK), (1, COUPLER / 2)]
        for i, arm in moved:
            matrix[rows, i] += mass * arm * across[i]
            right[rows] += mass * arm * along[i] * w[i] ** 2
        right[3 * k + 1] -= mass * GRAVITY
        matrix[3 * k + 2, k] = mass * length**2 / 12
        ends = (-1, 1) if k != 2 else (1, -1)  # the rocker begins at D, where its angle counts from
        for (joint, sign), end in zip(held[k], ends, strict=True):
            columns = slice(3 + 2 * joint, 5 + 2 * joint)
            matrix[rows, columns] -= sign * np.eye(2)
            x, y = end * length / 2 * along[k]
            matrix[3 * k + 2, columns] -= sign * np.array([-y, x])
    for i, length in enumerate((CRANK, COUPLER, -ROCKER)):
        matrix[9:, i] = length * across[i]
        right[9:] += length * along[i] * w[i] ** 2
    return np.linalg.solve(matrix, right)[5:7]


@functools.cache
def forces(way):
    system = System(WAYS[way](FourBar()), noncontributing_forces=[RX, RY])
    x = closed_at(system)
    names = list(system.outputs_symbols)
    values = np.ravel(system.evaluate_outputs())
    return x, np.array([values[names.index(force)] for force in (RX, RY)])


@pytest.mark.parametrize("way", WAYS)
def test_the_force_at_an_inner_pin_holds_the_share_of_the_loop(way):
    x, found = forces(way)
    np.testing.assert_allclose(found, by_newton(x[:3], x[3:]), rtol=1e-9)
    np.testing.assert_allclose(found, [2.73602297, 3.10384078], rtol=1e-8)


def test_velocity_constraints_with_auxiliary_speeds_are_taken_as_they_are():
    bar = FourBar(named_ends=False)
    bar.velocity = FourBar().velocity
    method = bar.definition(velocity_constraints=bar.velocity)
    system = System(method, noncontributing_forces=[RX, RY])
    x = closed_at(system)
    found = np.ravel(system.evaluate_outputs())[-2:]
    np.testing.assert_allclose(found, by_newton(x[:3], x[3:]), rtol=1e-9)


def test_a_loop_that_connects_no_points_is_refused_where_its_forces_are_asked_for():
    system = System(FourBar(named_ends=False).definition())
    closed_at(system)
    assert np.isfinite(system.evaluate_ode()).all()
    with pytest.raises(ValueError, match=r"closes a loop.*Pass `velocity_constraints` that are"):
        system.noncontributing_forces = [RX, RY]


def test_a_row_of_constants_and_a_sloping_axis_is_found():
    """The loop in axes that slope by a constant, and as a multiple of what closes it."""
    bar, slope, scale = FourBar(), sm.Symbol("slope"), sm.Symbol("scale")
    x, y = bar.loop
    bar.loop = [x * sm.cos(slope) + y * sm.sin(slope), scale * y]
    system = System(bar.definition(), {slope: 0.3, scale: 2.0}, noncontributing_forces=[RX, RY])
    state = closed_at(system)
    found = np.ravel(system.evaluate_outputs())[-2:]
    np.testing.assert_allclose(found, by_newton(state[:3], state[3:]), rtol=1e-9)


@pytest.mark.parametrize("size", [1e-9, 1.0, 1e9])
def test_a_rolling_disc_is_held_up_by_its_weight_alone(size):
    """x = r θ says nothing about the force that holds the disc up, whatever the unit of length."""
    x, a, v, w = me.dynamicsymbols("x a v w")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    B = N.orientnew("B", "Axis", (a, N.z))
    B.set_ang_vel(N, w * N.z)
    O.set_vel(N, 0)
    centre = O.locatenew("C", x * N.x)
    centre.set_vel(N, v * N.x + UY * N.y)
    disc = me.RigidBody("disc", centre, B, 2.0, (me.inertia(B, 0, 0, size**2), centre))
    load = (centre, RY * N.y - 2.0 * 9.81 * size * N.y)
    method = Definition(
        N, [x, a], [v, w], bodies=[disc], loads=[load], auxiliary_speeds=[UY],
        holonomic_constraints=[x + size * a],
    )  # fmt: skip
    system = System(method, noncontributing_forces=[RY])
    found = np.ravel(system.evaluate_outputs())[-1]
    np.testing.assert_allclose(found, 2.0 * 9.81 * size, rtol=1e-9)


def slider_crank():
    """Masses at both ends of a rod without inertia, and at the slider, which a guide holds up.

    The height of the rod's end does not say whether the slider or the ground holds it; that both
    rows connect the same points does.
    """
    q, p, s, u, w, v = me.dynamicsymbols("q p s u w v")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    A, B = N.orientnew("A", "Axis", (q, N.z)), N.orientnew("B", "Axis", (p, N.z))
    A.set_ang_vel(N, u * N.z)
    B.set_ang_vel(N, w * N.z)
    pin = O.locatenew("P", 0.3 * A.x)
    pin.v2pt_theory(O, N, A)
    tip = pin.locatenew("Q", 0.8 * B.x)
    tip.v2pt_theory(pin, N, B)
    slider = O.locatenew("S", s * N.x)
    slider.set_vel(N, v * N.x + UY * N.y)
    bodies = [me.Particle(n, p, 1.5) for n, p in (("a", pin), ("b", tip), ("c", slider))]
    loads = [(b.masscenter, -1.5 * 9.81 * N.y) for b in bodies]
    loads[-1] = (slider, (RY - 1.5 * 9.81) * N.y)
    gap = tip.pos_from(slider)
    method = Definition(
        N, [q, p, s], [u, w, v], bodies=bodies, loads=loads, auxiliary_speeds=[UY],
        holonomic_constraints=[gap.dot(N.x), gap.dot(N.y)], configuration={q: 0.7, p: -0.2, s: 1},
    )  # fmt: skip
    return method, (q, p, s, u, w, v)


def test_a_guide_carries_what_the_rod_of_a_slider_crank_pushes_down():
    method, (q, p, s, *_, v) = slider_crank()
    system = System(method, noncontributing_forces=[RY])
    angle = -np.arcsin(0.3 * np.sin(0.7) / 0.8)
    place = 0.3 * np.cos(0.7) + 0.8 * np.cos(angle)
    system.initial_conditions = {q: 0.7, p: angle, s: place}
    rates = dict(zip(system.states, system.evaluate_ode(), strict=True))
    found = np.ravel(system.evaluate_outputs())[-1]
    # Along a rod without inertia, its force on the masses at its end is that of 3 kg that
    # accelerate horizontally; the guide carries the rest of their weight.
    along = 3.0 * rates[v]
    np.testing.assert_allclose(found, 3.0 * 9.81 - along * np.tan(angle), rtol=1e-9)


def test_the_bearing_of_a_gear_carries_the_force_between_the_teeth():
    """Wheels of radius 0.1 and 0.2 roll on each other; the first is driven by a torque of 5 N m."""
    a, b, v, w = me.dynamicsymbols("a b v w")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    first, second = O.locatenew("C1", 0 * N.x), O.locatenew("C2", 0.3 * N.x)
    first.set_vel(N, UX * N.x + UY * N.y)
    second.set_vel(N, 0)
    bodies = []
    for name, angle, speed, centre, radius in (
        ("one", a, v, first, 0.1), ("two", b, w, second, 0.2)
    ):  # fmt: skip
        frame = N.orientnew(name, "Axis", (angle, N.z))
        frame.set_ang_vel(N, speed * N.z)
        inertia = me.inertia(frame, 0, 0, radius**2)
        bodies.append(me.RigidBody(name, centre, frame, 2.0, (inertia, centre)))
    loads = [(first, RX * N.x + RY * N.y), (bodies[0].frame, 5.0 * N.z)]
    method = Definition(
        N, [a, b], [v, w], bodies=bodies, loads=loads, auxiliary_speeds=[UX, UY],
        holonomic_constraints=[0.1 * a + 0.2 * b],
    )  # fmt: skip
    system = System(method, noncontributing_forces=[RX, RY])
    # I₁ a'' = T − r₁ F and I₂ b'' = −r₂ F with I = r² of each and r₂ b'' = −r₁ a''
    acceleration = dict(zip(system.states, system.evaluate_ode(), strict=True))[v]
    force = (5.0 - 0.01 * acceleration) / 0.1
    found = np.ravel(system.evaluate_outputs())[-2:]
    np.testing.assert_allclose(acceleration, 250.0, rtol=1e-12)
    np.testing.assert_allclose(found, [0.0, force], atol=1e-10)


def test_joints_that_are_coupled_in_a_chain_are_refused():
    """Nothing says through which bodies a finger's joint is driven by the one before it."""
    a, b, v, w = me.dynamicsymbols("a b v w")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    A, B = N.orientnew("A", "Axis", (a, N.z)), N.orientnew("B", "Axis", (b, N.z))
    A.set_ang_vel(N, v * N.z)
    B.set_ang_vel(N, w * N.z)
    base = O.locatenew("P", 0 * N.x)
    base.set_vel(N, UX * N.x + UY * N.y)
    middle = base.locatenew("Q", 0.5 * A.x)
    middle.v2pt_theory(base, N, A)
    tip = middle.locatenew("R", 0.4 * B.x)
    tip.v2pt_theory(middle, N, B)
    method = Definition(
        N, [a, b], [v, w], bodies=[me.Particle("m", middle, 1), me.Particle("n", tip, 1)],
        loads=[(base, RX * N.x + RY * N.y)], auxiliary_speeds=[UX, UY],
        holonomic_constraints=[b - 3 * a],
    )  # fmt: skip
    with pytest.raises(ValueError, match="closes a loop"):
        System(method, noncontributing_forces=[RX, RY])
