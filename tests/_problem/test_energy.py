"""Kinetic, potential and total energy along the motion."""

import copy
import pickle

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from sympy.physics.mechanics.models import n_link_pendulum_on_cart

import zoo
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper
from pydy.system import System
from zoo import inertial_frame
from zoo.cases import close, system_of
from zoo.singular import defined_windows

TIMES = np.linspace(0.0, 1.0, 5)
TIGHT = {"rtol": 1e-11, "atol": 1e-11, "mxstep": 5000}
T = me.dynamicsymbols._t


def particle(load, **options):
    """A particle in the plane, x and y, under a load on its point P; O stands still."""
    x, y, vx, vy = me.dynamicsymbols("x y vx vy")
    frame, origin, point = me.ReferenceFrame("N"), me.Point("O"), me.Point("P")
    origin.set_vel(frame, 0)
    point.set_pos(origin, x * frame.x + y * frame.y)
    point.set_vel(frame, vx * frame.x + vy * frame.y)
    kane = me.KanesMethod(frame, [x, y], [vx, vy], kd_eqs=[x.diff(T) - vx, y.diff(T) - vy])
    body = me.Particle("A", point, sm.Symbol("m"))
    loads = load(frame, origin, point, x, y)
    body.potential_energy = options.pop("potential_energy", 0)
    kane.kanes_equations([body], loads)
    start = {x: 0.7, y: -0.4, vx: 0.3, vy: 0.5}
    return System(kane, initial_conditions=start, times=TIMES, **options)


def is_conserved(system):
    energy = system.evaluate_energy(system.integrate(**TIGHT))
    np.testing.assert_allclose(energy.total, energy.total[0], rtol=1e-8, atol=1e-9)
    assert np.ptp(energy.kinetic) > 1e-3
    return energy


@pytest.mark.parametrize("name", sorted(zoo.CONSERVATIVE))
def test_total_energy_is_conserved(name):
    model = zoo.MODELS[name]()
    system = system_of(model, times=TIMES)
    x = system.integrate(**TIGHT)
    total = system.evaluate_energy(x).total
    np.testing.assert_allclose(total, total[0], rtol=1e-8)
    values = [dict(zip(system.states, row, strict=True)) | model.constants for row in x]
    energies = [float(sm.sympify(model.energy).xreplace(v)) for v in values]
    np.testing.assert_allclose(total - total[0], np.array(energies) - energies[0], atol=1e-8)


def test_one_state_gives_floats_and_a_trajectory_arrays():
    system = system_of(zoo.bare())
    one = system.evaluate_energy([0.3, 2.0])
    assert one == pytest.approx((2.0, -9 * np.cos(0.3), 2.0 - 9 * np.cos(0.3)))
    assert all(isinstance(value, float) for value in one)
    many = system.evaluate_energy([[0.3, 2.0], [0.0, 0.0]])
    np.testing.assert_allclose(many.potential, [-9 * np.cos(0.3), -9.0])
    assert many.total.shape == (2,)


def test_constants_can_be_overridden_for_one_call():
    system = multi_mass_spring_damper()
    assert system.evaluate_energy([1.0, 0.0], p={sm.Symbol("k0"): 6.0}).potential == 3.0


@pytest.mark.parametrize("generator", ["llvm", "lambdify"])
def test_every_generator_evaluates_energies(generator):
    system = system_of(zoo.free_pendulum())
    x, _ = zoo.free_pendulum().sample()
    expected = system.evaluate_energy(x)
    system.generate_ode_function(generator=generator)
    assert system.evaluate_energy(x) == pytest.approx(expected, rel=1e-13)


@pytest.mark.parametrize("solver", ["numpy", "sympy"])
def test_energies_need_no_linear_solver(solver):
    system = system_of(zoo.pendulum())
    x, t = zoo.pendulum().sample()
    expected = system.evaluate_energy(x, t)
    system.generate_ode_function(linear_sys_solver=solver)
    assert system.evaluate_energy(x, t) == pytest.approx(expected, rel=1e-13)


# -- which loads have a potential -----------------------------------------------------------------


def test_a_constant_force_in_a_frame_that_turns_about_it_is_constant():
    """The upright axis of a yawing frame stands still."""

    def load(frame, origin, point, x, y):
        yawed = frame.orientnew("Y", "Axis", [x, frame.z])
        tilted = frame.orientnew("T", "Axis", [sm.Symbol("slope"), frame.z])
        return [(point, 3 * yawed.z + 2 * tilted.x)]

    system = particle(load)
    x, y = system.coordinates
    slope = sm.Symbol("slope")
    expected = -2 * (sm.cos(slope) * x + sm.sin(slope) * y)
    assert sm.expand(system.potential_energy - expected) == 0
    is_conserved(system)


def test_a_force_that_turns_with_the_body_is_not_recognised():
    def load(frame, origin, point, x, y):
        return [(point, 3 * frame.orientnew("Y", "Axis", [x, frame.z]).x)]

    with pytest.raises(ValueError, match=r"the force on the point P, `3\*Y.x`"):
        particle(load).evaluate_energy()


def test_a_circulatory_force_is_not_recognised():
    def load(frame, origin, point, x, y):
        return [(point, x * frame.y - y * frame.x)]

    with pytest.raises(ValueError, match="not clear whether these loads have one"):
        particle(load).potential_energy


K, D, P = sm.symbols("K d p")
LAWS = {
    "sine": (lambda x: -K * sm.sin(2 * x), lambda x: -np.cos(2 * x) / 2),
    "contact": (
        lambda x: sm.Piecewise((K * (D - x) ** sm.Rational(3, 2), x < D), (0, True)),
        lambda x: np.where(x < 0.5, 0.4 * np.abs(0.5 - x) ** 2.5, 0.0),
    ),
    "stop": (lambda x: -K * sm.Max(0, x - D), lambda x: np.maximum(x - 0.5, 0.0) ** 2 / 2),
    "friction of rest": (lambda x: -K * sm.sign(x), np.abs),
    "modulus": (lambda x: -K * x * sm.Abs(x), lambda x: np.abs(x) ** 3 / 3),
    "hardening": (lambda x: -K * sm.sinh(x), np.cosh),
    "band": (
        lambda x: sm.Piecewise((-K * x, (x > -1) & (x < 1)), (0, True)),
        lambda x: np.minimum(x**2, 1.0) / 2,
    ),
}


@pytest.mark.parametrize("law", LAWS)
def test_the_force_along_one_coordinate_is_integrated(law):
    force, expected = LAWS[law]

    def load(frame, origin, point, x, y):
        return [(point, force(x) * frame.x - sm.Symbol("w") * frame.y)]

    system = particle(load)
    if D in system.constants_symbols:
        system.constants = {D: 0.5}
    states = np.zeros((9, 4))
    states[:, 0] = np.linspace(-1.3, 1.9, 9)
    energy = system.evaluate_energy(states, np.zeros(9)).potential
    wanted = expected(states[:, 0])
    np.testing.assert_allclose(energy - energy[3], wanted - wanted[3], atol=1e-12)
    if law != "friction of rest":
        is_conserved(system)


def test_a_force_between_two_coordinates_is_integrated_with_its_counterpart():
    def load(frame, origin, point, x, y):
        pull = K * sm.sin(x - y)
        return [(point, -pull * frame.x), (point, pull * frame.y)]

    system = particle(load)
    x, y = system.coordinates
    assert sm.simplify(system.potential_energy + K * sm.cos(x - y)) == 0
    is_conserved(system)


def test_the_work_of_a_bell_curve_is_an_error_function():
    system = particle(lambda frame, origin, point, x, y: [(point, sm.exp(-(x**2)) * frame.x)])
    x = system.coordinates[0]
    assert sm.simplify(system.potential_energy + sm.sqrt(sm.pi) / 2 * sm.erf(x)) == 0
    is_conserved(system)


@pytest.mark.parametrize(
    "force", [sm.sin(sm.sin(sm.Symbol("X"))), sm.exp(sm.cos(sm.Symbol("X"))), sm.Symbol("X") ** P]
)
def test_a_force_without_an_integral_says_so_and_not_that_a_point_must_stand_still(force):
    def load(frame, origin, point, x, y):
        return [(point, force.xreplace({sm.Symbol("X"): x}) * frame.x)]

    if force.is_Pow:  # q**p has one, whatever p is
        assert particle(load).potential_energy.has(P)
        return
    with pytest.raises(ValueError, match="must be one that SymPy can integrate") as caught:
        particle(load).potential_energy
    assert "set_pos" not in str(caught.value)
    assert "`system.potential_energy = ...`" in str(caught.value)


def test_springs_along_coordinates_are_recognised_together():
    def load(frame, origin, point, x, y):
        k, c = sm.symbols("k c")
        return [(point, -k * (x - y) * frame.x), (point, (k * (x - y) - c * y**3) * frame.y)]

    system = particle(load)
    x, y = system.coordinates
    k, c = sm.symbols("k c")
    assert sm.expand(system.potential_energy - k * (x - y) ** 2 / 2 - c * y**4 / 4) == 0
    is_conserved(system)


@pytest.mark.parametrize("fixed", [True, False])
def test_a_spring_between_points_is_recognised(fixed):
    k, free = sm.symbols("k l")

    def load(frame, origin, point, x, y):
        hook = origin.locatenew("H", 2 * frame.y)
        hook.set_vel(frame, 0)
        path = me.LinearPathway(hook, point)
        loads = me.LinearSpring(k, path, free).to_loads()
        return loads if fixed else [load for load in loads if load.location is point]

    system = particle(load)
    x, y = system.coordinates
    length = sm.sqrt(x**2 + (y - 2) ** 2)
    expected = k * (length - free) ** 2 / 2
    at = {x: 0.3, y: 0.4, k: 1.3, free: 0.6}
    more = {**at, x: 0.9}
    gained = system.potential_energy.xreplace(more) - system.potential_energy.xreplace(at)
    assert float(gained) == pytest.approx(float(expected.xreplace(more) - expected.xreplace(at)))
    is_conserved(system)


def test_a_pull_that_falls_with_the_square_of_the_distance_is_recognised():
    def load(frame, origin, point, x, y):
        line = point.pos_from(origin)
        return [(point, -sm.Symbol("G") / line.magnitude() ** 3 * line)]

    system = particle(load)
    x, y = system.coordinates
    assert sm.simplify(system.potential_energy + sm.Symbol("G") / sm.sqrt(x**2 + y**2)) == 0
    is_conserved(system)


def test_springs_between_two_bodies_that_both_move():
    q = me.dynamicsymbols("x1 y1 x2 y2")
    u = me.dynamicsymbols("u1 v1 u2 v2")
    k, free, m = sm.symbols("k l m")
    frame, origin = inertial_frame()
    points = []
    for i in (0, 2):
        points.append(origin.locatenew(f"P{i}", q[i] * frame.x + q[i + 1] * frame.y))
        points[-1].set_vel(frame, u[i] * frame.x + u[i + 1] * frame.y)
    kane = me.KanesMethod(frame, q, u, kd_eqs=[a.diff(T) - b for a, b in zip(q, u, strict=True)])
    spring = me.LinearSpring(k, me.LinearPathway(*points), free)
    damper = me.LinearDamper(sm.Symbol("c"), me.LinearPathway(*points))
    bodies = [me.Particle(f"A{i}", p, m) for i, p in enumerate(points)]
    kane.kanes_equations(bodies, [*spring.to_loads(), *damper.to_loads()])
    start = dict(zip([*q, *u], [0.0, 0.1, 1.1, 0.2, 0.3, -0.2, 0.1, 0.4], strict=True))
    system = System(kane, constants={sm.Symbol("c"): 0.0}, initial_conditions=start, times=TIMES)
    is_conserved(system)
    system.constants = {sm.Symbol("c"): 0.7}
    assert (np.diff(system.evaluate_energy(system.integrate(**TIGHT)).total) < 0.0).all()


def test_what_depends_on_speeds_time_or_specifieds_has_none():
    system = multi_mass_spring_damper(2, apply_gravity=True, apply_external_forces=True)
    x0, x1 = system.coordinates
    k0, k1, g, m0, m1 = sm.symbols("k0 k1 g m0 m1")
    expected = k0 * x0**2 / 2 + k1 * x1**2 / 2 - g * (m0 * x0 + m1 * (x0 + x1))
    assert sm.expand(system.potential_energy - expected) == 0


def test_the_work_of_the_other_loads_is_the_gain_of_the_total():
    power = sm.Symbol("P")
    system = multi_mass_spring_damper(1, apply_external_forces=True)
    (v0,), (f0,) = system.speeds, system.specifieds_symbols
    c0 = sm.Symbol("c0")
    system.specifieds = {f0: 1.3}
    system.outputs = {power: (f0 - c0 * v0) * v0}
    times = np.linspace(0.0, 1.0, 2001)
    system.times = times
    x = system.integrate(**TIGHT)
    work = np.trapezoid(system.evaluate_outputs(x)[:, 0], times)
    total = system.evaluate_energy(x).total
    assert total[-1] - total[0] == pytest.approx(work, rel=1e-6)


def test_forces_that_do_no_work_do_not_matter():
    """The pivot's side force acts on an auxiliary motion only, whatever it depends on."""
    q, u, side, force = me.dynamicsymbols("q u us S")
    m, g, l = sm.symbols("m g l")
    frame, origin, point = me.ReferenceFrame("N"), me.Point("O"), me.Point("P")
    arm = frame.orientnew("R", "axis", (q, frame.z))
    arm.set_ang_vel(frame, u * frame.z)
    ground = me.Point("G")
    ground.set_vel(frame, 0)
    origin.set_pos(ground, 0)
    origin.set_vel(frame, side * frame.y)
    point.set_pos(origin, l * arm.x)
    point.set_vel(frame, side * frame.y + l * u * arm.y)
    kane = me.KanesMethod(frame, [q], [u], kd_eqs=[q.diff(T) - u], u_auxiliary=[side])
    kane.kanes_equations(
        [me.Particle("bob", point, m)], [(point, m * g * frame.x), (origin, force * frame.y)]
    )
    system = System(kane, noncontributing_forces=[force])
    assert system.potential_energy == -g * l * m * sm.cos(q)


def test_gravity_along_a_long_chain():
    system = System(n_link_pendulum_on_cart(8), times=[0.0, 0.5])
    system.initial_conditions = dict.fromkeys(system.coordinates[1:], 0.4)
    is_conserved(system)


# -- what the user says ---------------------------------------------------------------------------


def test_the_bodies_own_potential_energy_is_not_counted_twice():
    g, m = sm.symbols("g m")
    y = me.dynamicsymbols("y")

    def load(frame, origin, point, x, y):
        return [(point, -m * g * frame.y)]

    assert particle(load, potential_energy=m * g * y).potential_energy == g * m * y


def test_the_bodies_own_potential_energy_stands_for_loads_that_are_not_recognised():
    x, y = me.dynamicsymbols("x y")
    g, m = sm.symbols("g m")

    def load(frame, origin, point, x, y):
        return [(point, -sm.sin(x) * frame.x), (point, -m * g * frame.y)]

    assert particle(load, potential_energy=-sm.cos(x)).potential_energy == g * m * y - sm.cos(x)
    whole = g * m * y - sm.cos(x)
    system = particle(load, potential_energy=whole)
    assert system.potential_energy == whole
    is_conserved(system)


def test_the_bodies_own_potential_energy_must_agree_with_loads_that_are_not_recognised():
    x = me.dynamicsymbols("x")

    def load(frame, origin, point, x, y):
        return [(point, -sm.exp(-(x**2)) * sm.sin(x) * frame.x)]

    with pytest.raises(ValueError, match="not clear whether"):
        particle(load, potential_energy=sm.cos(x)).potential_energy


def test_a_potential_energy_that_is_set_is_taken():
    # On y = x² with a speed along the curve: nobody says how high the bead is.
    (x, v), (m, g) = me.dynamicsymbols("x v"), sm.symbols("m g")
    frame, _ = inertial_frame()
    bead, rate = me.Point("P"), v / sm.sqrt(1 + 4 * x**2)
    bead.set_vel(frame, rate * (frame.x + 2 * x * frame.y))
    kane = me.KanesMethod(
        frame,
        [x],
        [v],
        kd_eqs=[x.diff(T) - rate],
        bodies=[me.Particle("bead", bead, m)],
        forcelist=[(bead, -m * g * frame.y)],
    )
    system = System(kane, {m: 0.7, g: 9.81}, times=TIMES, initial_conditions={x: 0.8, v: 0.1})
    with pytest.raises(ValueError, match=r"`Point\.set_pos`.*`system\.potential_energy = \.\.\.`"):
        system.evaluate_energy()
    system.potential_energy = m * g * x**2
    is_conserved(system)
    system.potential_energy = None
    with pytest.raises(ValueError, match="Cannot determine the potential energy"):
        system.potential_energy


@pytest.mark.parametrize("way", [copy.deepcopy, lambda s: pickle.loads(pickle.dumps(s))])
def test_a_copy_keeps_the_energies(way):
    system = system_of(zoo.free_pendulum())
    x, _ = zoo.free_pendulum().sample()
    expected = system.evaluate_energy(x)
    assert way(system).evaluate_energy(x) == expected


def test_a_trajectory_knows_its_energy():
    system = system_of(zoo.free_pendulum(), times=TIMES)
    trajectory = system.simulate(**TIGHT)
    expected = system.evaluate_energy(trajectory.states)
    np.testing.assert_array_equal(trajectory.energy.T, expected)


def carried(**options):
    """A mass on a carriage that is moved by y(t): the equations hold y'' alone."""
    x, v, y = me.dynamicsymbols("x v y")
    frame, origin = inertial_frame()
    end = origin.locatenew("P", (x + y) * frame.x)
    body = me.Particle("A", end, 2)
    loads = [(end, 3 * frame.x)]
    definition = Definition(frame, [x], [v], bodies=[body], loads=loads)
    return System(definition, initial_conditions={x: 0.5, v: 0.2}, **options), y


@pytest.mark.parametrize("named", [False, True])
def test_rates_of_a_prescribed_motion_that_the_equations_do_not_hold_follow_from_it(named):
    system, y = carried()
    system.specifieds = {"y" if named else y: 0.3 * sm.sin(2 * T)}
    close(system.evaluate_ode(t=0.4), [0.2, 1.5 + 1.2 * np.sin(0.8)])
    energy = system.evaluate_energy(t=0.4)
    speed, place = 0.2 + 0.6 * np.cos(0.8), 0.5 + 0.3 * np.sin(0.8)
    close([energy.kinetic, energy.potential], [speed**2, -3 * place])


def test_rates_of_a_prescribed_motion_that_are_not_given_are_asked_for():
    system, y = carried()
    system.specifieds = {y: 0.4, y.diff(T, 2): 1.5}
    with pytest.raises(ValueError, match=r"energy holds Derivative\(y\(t\), t\).*in `specifieds`"):
        system.evaluate_energy()
    system.specifieds = {y: 0.4, y.diff(T): 0.3, y.diff(T, 2): 1.5}
    close(system.evaluate_energy().kinetic, 0.25)
    system.specifieds = {y.diff(T): 0.3}
    with pytest.raises(ValueError, match=r"energy holds y\(t\), which the equations"):
        system.evaluate_energy()


def test_a_motion_that_moves_nothing_else_counts_in_the_energy():
    x, v, y = me.dynamicsymbols("x v y")
    frame, origin = inertial_frame()
    places = {"A": x * frame.x, "B": y * frame.y}
    bodies = [me.Particle(name, origin.locatenew(name, s), 2) for name, s in places.items()]
    system = System(Definition(frame, [x], [v], bodies=bodies), initial_conditions={v: 0.2})
    with pytest.raises(ValueError, match=r"energy holds Derivative\(y\(t\), t\)"):
        system.evaluate_energy()
    system.specifieds = {y: sm.sin(3 * T)}
    close(system.evaluate_energy(t=0.1).kinetic, 0.04 + 9 * np.cos(0.3) ** 2)
    system.specifieds = {y.diff(T): 3.0}
    close(system.evaluate_energy(t=0.1).kinetic, 0.04 + 9)
    with pytest.raises(ValueError, match="z"):
        system.specifieds = {me.dynamicsymbols("z"): 3.0}


def body_to_change():
    q, u = me.dynamicsymbols("q u")
    frame, turning, origin = me.ReferenceFrame("N"), me.ReferenceFrame("A"), me.Point("O")
    origin.set_vel(frame, 0)
    turning.orient_axis(frame, q, frame.z)
    center = origin.locatenew("C", turning.x)
    inertia = me.inertia(turning, 0, 0, 0.1), center
    bob = me.RigidBody("bob", center, turning, 2, inertia)
    loads = [(center, -19.62 * frame.y)]
    return bob, frame, q, System(Definition(frame, [q], [u], bodies=[bob], loads=loads))


@pytest.mark.parametrize("what", ["mass", "inertia", "position", "orientation"])
@pytest.mark.parametrize("ask", ["evaluate_energy", "scene", "equations_of_motion"])
def test_a_body_that_was_changed_after_the_system_was_made_is_told(what, ask):
    bob, frame, q, system = body_to_change()
    if what == "mass":
        bob.mass = 7
    elif what == "inertia":
        bob.inertia = me.inertia(bob.frame, 0, 0, 3), bob.masscenter
    elif what == "position":
        bob.masscenter.set_pos(next(iter(bob.masscenter._pos_dict)), 3 * bob.frame.x)
    else:
        bob.frame.orient_axis(frame, 2 * q, frame.z)
    with pytest.raises(ValueError, match=rf"The {what} of the body `bob` has been changed"):
        getattr(system, ask)()


def test_a_body_that_only_gains_neighbours_has_not_changed():
    bob, frame, _, system = body_to_change()
    bob.masscenter.locatenew("P", bob.frame.y)
    me.ReferenceFrame("B").orient_axis(bob.frame, 1, frame.z)
    close(system.evaluate_energy().total, 0.0)


TIME = me.dynamicsymbols._t


@pytest.mark.parametrize("g", [sm.Symbol("g"), 9.81])
@pytest.mark.parametrize(
    "mass", [2 - TIME / 4, me.dynamicsymbols("m"), 3 + 2 * me.dynamicsymbols("m")]
)
def test_the_weight_of_a_mass_that_changes_has_the_potential_of_that_mass(mass, g):
    x, u = me.dynamicsymbols("x u")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x)
    place.set_vel(frame, u * frame.x)
    bodies, loads = [me.Particle("b", place, mass)], [(place, -mass * g * frame.x)]
    system = System(me.KanesMethod(frame, [x], [u], [x.diff() - u], bodies=bodies, forcelist=loads))
    assert float(sm.cancel(system.potential_energy / (mass * g * x))) == pytest.approx(1.0)
    loads += [(place, -K * x * frame.x)]
    system = System(me.KanesMethod(frame, [x], [u], [x.diff() - u], bodies=bodies, forcelist=loads))
    weight = system.potential_energy - K * x**2 / 2
    assert float(sm.cancel(weight / (mass * g * x))) == pytest.approx(1.0)


def test_a_run_needs_no_kinetic_energy_in_sympy_where_it_was_formed(monkeypatch):
    def refused(self):
        raise AssertionError("SymPy's kinetic energy of a model that was formed from bodies")

    monkeypatch.setattr("pydy._mechanics.equations.Mechanism._written_energy", refused)
    system = System(defined_windows(2), times=[0.0, 0.1], ode_solver="dop853")
    system.initial_conditions = {
        s: (1.5 if str(s).startswith("a") else 0.0) for s in system.coordinates
    }
    motion = system.simulate(constraints="project")
    assert np.isfinite(motion.states).all()
    assert {*system._models.energies.symbols} == {*sm.symbols("g l m", positive=True)}
