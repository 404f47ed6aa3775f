"""Equilibria, relative equilibria and trims."""

import pickle

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.errors import EquilibriumError, PyDyUserWarning
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.system import System
from zoo import inertial_frame, loops
from zoo.cases import system_of
from zoo.hoop import bead_on_a_hoop


@pytest.fixture
def pendulum():
    return n_link_pendulum_on_cart(2)


def test_a_pendulum_hangs_and_its_cart_may_stand_anywhere(pendulum):
    q0, q1, q2 = pendulum.coordinates
    pendulum.initial_conditions = {q0: 0.7, q1: 3.0, q2: 3.3}
    found = pendulum.find_equilibrium()
    assert found.values[q0] == pytest.approx(0.7, abs=1e-9)
    assert found.values[q1] == pytest.approx(np.pi, abs=1e-12)
    assert found.values[q2] == pytest.approx(np.pi, abs=1e-12)
    assert found.free == ("q0",)
    assert found.residual < 1e-14


def test_the_result_fits_the_systems_attributes(pendulum):
    pendulum.initial_conditions = {pendulum.coordinates[1]: 3.0, pendulum.coordinates[2]: 3.1}
    pendulum.initial_conditions = pendulum.find_equilibrium().initial_conditions
    assert np.abs(pendulum.evaluate_ode()).max() < 1e-14


def test_inputs_may_be_unknown(pendulum):
    force = next(iter(pendulum.specifieds_symbols))
    _, q1, q2 = pendulum.coordinates
    with pytest.raises(EquilibriumError, match=r"Nearest, at q2 = .* the derivative of u"):
        pendulum.find_equilibrium([q2], {q1: 0.2})
    found = pendulum.find_equilibrium([force, q1, q2])
    assert found.specifieds[force] == pytest.approx(0.0, abs=1e-14)


def test_where_there_is_none_the_unknowns_at_a_bound_are_named():
    """x'' = -1 - x is zero at x = -1 alone, beyond the bounds of x; y hangs on a spring at 2 m."""
    x, y = me.dynamicsymbols("x y")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", x * frame.x + y * frame.y)
    load = (point, (-1 - x) * frame.x + (2 - y) * frame.y)
    made = Definition(frame, [x, y], bodies=[me.Particle("mass", point, 1)], loads=[load])
    system = System(made, initial_conditions={x: 2.0})
    for bounds in ({x: (0.5, 3.0)}, {x: (0.5, np.inf)}):
        with pytest.raises(EquilibriumError, match=r"At a bound: x\. ") as told:
            system.find_equilibrium(bounds=bounds)
        assert told.value.values[:2] == pytest.approx([0.5, 2.0], abs=1e-9)
    system = System(made, {}, initial_conditions={x: 2.0})
    with pytest.raises(EquilibriumError) as told:
        system.find_equilibrium([y])
    assert "At a bound" not in str(told.value)


def test_constants_may_be_unknown():
    system = multi_mass_spring_damper(apply_gravity=True)
    found = system.find_equilibrium(["k0"], {"x0": 0.25, "g": 9.81, "m0": 2.0})
    assert found.constants[sm.Symbol("k0")] == pytest.approx(2.0 * 9.81 / 0.25, rel=1e-14)
    assert list(found.constants) == [sm.Symbol("k0")]


@pytest.mark.parametrize("rate", [5.0, 8.0])
def test_a_bead_on_a_turning_hoop_rests_where_the_closed_form_says(rate):
    system, angle, turn = bead_on_a_hoop()
    found = system.find_equilibrium([angle], {turn: rate, angle: 1.0})
    assert np.cos(found.values[angle]) == pytest.approx(9.81 / (0.5 * rate**2), rel=1e-13)


def test_the_rate_that_holds_a_bead_is_found_within_bounds():
    system, angle, turn = bead_on_a_hoop()
    for low, high, sign in ((0.1, 20.0, 1), (-20.0, -0.1, -1), (0.1, None, 1), (None, 0.0, -1)):
        found = system.find_equilibrium(
            [turn], {angle: 1.1, turn: sign * 3.0}, bounds={turn: (low, high)}
        )
        rate = np.sqrt(9.81 / (0.5 * np.cos(1.1)))
        assert found.specifieds[turn] == pytest.approx(sign * rate, rel=1e-13)


def test_a_closed_linkage_rests_on_its_constraints():
    model = zoo.fourbar()
    system = system_of(model)
    found = system.find_equilibrium()
    assert np.abs(system.evaluate_ode(found.state)).max() < 1e-10
    assert np.abs(system.evaluate_constraints(found.state)).max() < 1e-12


@pytest.mark.parametrize("angle", [0.4, 1.2, 2.8])
def test_the_torque_that_holds_an_engine_is_that_of_virtual_work(angle):
    """In SI units a millimetre of the constraint and a million rad/s² are equally far from zero."""
    system = System(loops.engine(), constants={"F": 1000.0})
    system.initial_conditions = {"q2": 0.1}
    given = {"q1": angle, "u1": 0.0, "u2": 0.0}
    found = system.find_equilibrium(["T", "q2"], given=given)
    rod = np.arcsin(0.05 * np.sin(angle) / 0.2)
    lever = 0.05 * np.sin(angle) + 0.05 * np.cos(angle) * np.tan(rod)
    assert found["T"] == pytest.approx(-1000.0 * lever, rel=1e-12)
    (place,) = (q for q in system.coordinates if q.name == "q2")
    assert found[place] == found["q2"] == pytest.approx(rod, rel=1e-12)
    with pytest.raises(KeyError, match="`q7` is not one of the unknowns: T, q2"):
        found["q7"]


def test_a_coordinate_may_move_steadily():
    system = system_of(zoo.sleigh())
    x = system.coordinates[0]
    forward = {system.speeds[0]: 2.0}
    with pytest.raises(EquilibriumError, match="the derivative of x"):
        system.find_equilibrium(given=forward)
    found = system.find_equilibrium(given=forward, moving=[x])
    assert found.initial_conditions[system.speeds[0]] == 2.0
    assert np.delete(system.evaluate_ode(found.state), 0) == pytest.approx(0.0, abs=1e-14)


@pytest.mark.parametrize("metre", [1e-9, 1.0, 1e9])
@pytest.mark.parametrize("tilt", [0.0, 1e-3, 1.0])
def test_a_motion_that_depends_on_a_coordinate_is_not_steady_while_it_moves(metre, tilt):
    """A pendulum that a torque turns round: steadily about a vertical axis, and about no other."""
    q, u, torque = me.dynamicsymbols("q u T")
    N, O = inertial_frame()
    rod = N.orientnew("R", "Axis", (q, N.z))
    bob = O.locatenew("B", -0.5 * metre * rod.y)
    weight = -9.81 * metre * (np.sin(tilt) * N.y + np.cos(tilt) * N.z)
    loads = [(bob, weight), (rod, (torque - 0.4 * metre**2 * u) * N.z)]
    body = me.Particle("bob", bob, sm.Integer(1))
    system = System(Definition(N, [q], [u], bodies=[body], loads=loads))
    system.initial_conditions = {q: 0.3, u: 12.0}
    wanted = {"unknowns": [torque], "moving": [q]}
    if tilt:
        message = "depends on, got q: as they advance, the derivative of u.* does not stay zero"
        with pytest.raises(EquilibriumError, match=message):
            system.find_equilibrium(given={u: 12.0}, **wanted)
        with pytest.raises(EquilibriumError, match=message):
            system.eigenvalues({u: [5.0, 12.0]}, **wanted)
    else:
        found = system.find_equilibrium(given={u: 12.0}, **wanted)
        assert found["T"] == pytest.approx(4.8 * metre**2, rel=1e-12)
        assert len(system.eigenvalues({u: [5.0, 12.0]}, **wanted).values) == 2


TIME = me.dynamicsymbols._t


def pushed(load=0, **more):
    """A mass on a spring, x'' = F + load - 3 x."""
    x, v, force = me.dynamicsymbols("x v F")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x)
    loads = [(place, (force + load - 3 * x) * frame.x)]
    bodies = [me.Particle("b", place, 1)]
    return System(Definition(frame, [x], [v], bodies=bodies, loads=loads), **more)


@pytest.mark.parametrize("times", [[], [0.0, 2.0]])
@pytest.mark.parametrize(
    ("given", "load", "what"),
    [
        (sm.cos(TIME), 0, r"F\(t\)"),
        (SampledInput([0.0, 1.0, 3.0], [1.0, 2.0, 1.0]), 0, r"F\(t\)"),
        (lambda x, t: np.cos(t), 0, r"F\(t\)"),
        (0.0, sm.exp(-TIME), "the loads"),
    ],
)
def test_what_is_an_equilibrium_at_one_time_alone_is_told(times, given, load, what):
    system = pushed(load, specifieds={"F": given}, times=times)
    if not times and not isinstance(given, float | sm.Basic):
        system.find_equilibrium()  # where it may be asked is not known
        return
    message = rf"one for {what} at t = 0 alone: at t = \S+ the derivative of v\S* is \S*\d"
    with pytest.warns(PyDyUserWarning, match=message) as told:
        found = system.find_equilibrium()
    assert found["x"] == pytest.approx(1.0 / 3.0)
    assert len(told) == 1


def test_a_sweep_is_told_once_and_a_number_in_place_of_an_input_is_not():
    k = sm.Symbol("k")
    system = pushed(k, specifieds={"F": sm.cos(TIME)})
    with pytest.warns(PyDyUserWarning, match="one for F") as told:
        system.eigenvalues({k: [1.0, 2.0, 9.0]})
    assert len(told) == 1
    system.find_equilibrium(given={"F": 1.0})
    system.find_equilibrium(["F"])
    system.eigenvalues({"F": [1.0, 2.0]})


@pytest.mark.parametrize(
    ("given", "load"),
    [
        (sm.cos(TIME) ** 2 + sm.sin(TIME) ** 2, 0),
        (0.0, sm.cos(TIME) * me.dynamicsymbols("x")),
        (sm.Heaviside(TIME - 3), 0),  # after the System's times
        (lambda x, t: 1.0 - x[0], 0),
        (SampledInput([0.0, 2.0], [1.0, 1.0]), 0),
    ],
)
def test_what_remains_an_equilibrium_is_not(given, load):
    system = pushed(load, specifieds={"F": given}, times=[0.0, 2.0])
    system.find_equilibrium()  # a warning would be an error


def test_a_search_that_starts_in_a_singular_state_names_what_is_left():
    x, y, v, w = me.dynamicsymbols("x y v w")
    ground, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(ground, v * ground.x + w * ground.y)
    pendulum = me.KanesMethod(
        ground, [x], [v],
        kd_eqs=[x.diff(zoo.T) - v, y.diff(zoo.T) - w],
        q_dependent=[y], configuration_constraints=[x**2 + y**2 - 1],
        u_dependent=[w], velocity_constraints=[x * v + y * w],
        bodies=[me.Particle("P", point, 1)], forcelist=[(point, -9 * ground.y)],
    )  # fmt: skip
    system = System(pendulum)
    with pytest.raises(EquilibriumError, match="residual of holonomic constraint 0 = -1"):
        system.find_equilibrium()
    system.initial_conditions = {x: 0.6, y: -0.8}
    assert system.find_equilibrium().values[y] == pytest.approx(-1.0)


def test_what_falls_freely_has_none_and_the_row_is_named():
    position, speed = me.dynamicsymbols("x v")
    ground, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(ground, speed * ground.x)
    kane = me.KanesMethod(ground, [position], [speed], [position.diff(zoo.T) - speed])
    kane.kanes_equations([me.Particle("P", point, 2)], [(point, 6 * ground.x)])
    with pytest.raises(EquilibriumError, match=r"the derivative of v\(t\) = 3") as caught:
        System(kane).find_equilibrium()
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.residuals.tolist() == caught.value.residuals.tolist()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"unknowns": ["nothing"]}, "`unknowns` has the key `nothing`"),
        ({"unknowns": []}, "`unknowns` must name"),
        ({"unknowns": 3}, "`unknowns` must be a sequence"),
        (
            {"unknowns": {"q1": 3}},
            r"got {'q1': 3}. To start .*find_equilibrium\(list\(guess\), given",
        ),
        ({"unknowns": ["q1", "q1"]}, "more than once"),
        ({"given": [1.0]}, "`given` must be a dict"),
        ({"bounds": [1.0]}, "`bounds` must be a dict"),
        ({"given": {"q9": 1.0}}, "`given` has the key `q9`"),
        ({"given": {"q1": "far"}}, r"`given\[q1\]`"),
        ({"moving": ["u1"]}, "`moving` must hold coordinates"),
        ({"bounds": {"g": (0, 1)}}, "`bounds` has the key `g`"),
        ({"bounds": {"q1": (1, 0)}}, "lowest and the highest"),
    ],
)
def test_bad_arguments_are_named(pendulum, arguments, message):
    with pytest.raises((ValueError, TypeError), match=message):
        pendulum.find_equilibrium(**arguments)


def test_feedback_of_a_python_function_leads_to_its_equilibrium(pendulum):
    force = next(iter(pendulum.specifieds_symbols))
    pendulum.initial_conditions = {"q0": 2.0, "q1": 0.3}
    pendulum.specifieds = {force: lambda x, t: -100 * (x[0] - 1.5) - 10 * x[3]}
    found = pendulum.find_equilibrium()
    assert found.values[pendulum.coordinates[0]] == pytest.approx(1.5, abs=1e-9)
    assert found.free == ()


def test_a_modulus_of_1e11_is_found_beside_a_deflection_of_a_millimetre():
    system = multi_mass_spring_damper(apply_external_forces=True)
    system.constants = {"k0": 5e10}
    system.specifieds = {"f0": 1e8}
    found = system.find_equilibrium(["k0", "v0"], {"x0": 1e-3})
    assert found["k0"] == pytest.approx(1e11, rel=1e-12)
    assert found.free == ()


def test_a_small_column_is_not_a_free_direction():
    """A ship's ballast moves its draught by 1e-10 m/N, which is not nothing."""
    system = multi_mass_spring_damper(2, apply_external_forces=True)
    system.constants = {"m0": 1e7, "m1": 1e7, "k0": 1e8, "k1": 1e-3}
    found = system.find_equilibrium(["x0", "x1", "v0", "v1"])
    assert found.free == ()
    found = system.find_equilibrium(["x0", "f0", "f1", "v0", "v1"], {"x1": 1.0})
    assert found.free == ("1e-08 x0 + f0",)


def chaplygin_sleigh():
    frame, origin = inertial_frame()
    x, y, angle = me.dynamicsymbols("x y theta")
    along, turn, across = me.dynamicsymbols("u omega v")
    m, inertia, a = sm.symbols("m I a")
    sleigh = me.ReferenceFrame("A")
    sleigh.orient_axis(frame, frame.z, angle)
    sleigh.set_ang_vel(frame, turn * frame.z)
    blade = origin.locatenew("C", x * frame.x + y * frame.y)
    blade.set_vel(frame, along * sleigh.x + across * sleigh.y)
    centre = blade.locatenew("G", a * sleigh.x)
    centre.v2pt_theory(blade, frame, sleigh)
    motion = blade.vel(frame)
    definition = Definition(
        frame,
        [x, y, angle],
        [along, turn, across],
        bodies=[me.RigidBody("s", centre, sleigh, m, (me.inertia(sleigh, 0, 0, inertia), centre))],
        kinematic_equations=[
            x.diff() - motion.dot(frame.x),
            y.diff() - motion.dot(frame.y),
            angle.diff() - turn,
        ],
        nonholonomic_constraints=[across],
    )
    return System(definition, {m: 2.0, inertia: 0.3, a: 0.5}), (x, y, angle, along, turn)


@pytest.mark.parametrize("heading", [0.0, 0.3, -2.0])
def test_what_no_equation_tells_of_stays_and_is_named_by_itself(heading):
    # The search used to move the sleigh 23 m aside, and to name `0.736 y + theta` free.
    sleigh, (x, y, angle, along, turn) = chaplygin_sleigh()
    sleigh.initial_conditions = {x: 3.0, y: 1.0, angle: heading, along: -0.7, turn: 2.0}
    found = sleigh.find_equilibrium()
    np.testing.assert_allclose([found[s] for s in (x, y, angle)], [3.0, 1.0, heading], atol=1e-9)
    assert found.free == ("x", "y", "theta")


def test_a_combination_that_is_free_is_named_beside_what_is_free_alone():
    q, u = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    m, k = sm.symbols("m k")
    frame, origin = inertial_frame()
    ends = [origin.locatenew(f"P{i}", s * frame.x) for i, s in enumerate(q)]
    bodies = [me.Particle(f"p{i}", end, m) for i, end in enumerate(ends)]
    pull = k * (q[1] - 2 * q[0])  # of a lever
    loads = [(ends[0], 2 * pull * frame.x), (ends[1], -pull * frame.x)]
    system = System(Definition(frame, q, u, bodies=bodies, loads=loads), {k: 3.0})
    system.initial_conditions = {q[0]: 1.0, q[2]: 7.0}
    found = system.find_equilibrium()
    assert found.free == ("0.5 q1 + q2", "q3")
    assert found[q[1]] == pytest.approx(2.0 * found[q[0]], abs=1e-12)
    assert found[q[2]] == pytest.approx(7.0, abs=1e-9)


@pytest.fixture(scope="module")
def hanging_chain():
    """Five links between two points at one height, by the links' angles."""
    count = 5
    q, u = me.dynamicsymbols(f"q:{count}"), me.dynamicsymbols(f"u:{count}")
    m, length, g, width = constants = sm.symbols("m l g d")
    ground, start = inertial_frame()
    joint, bodies, loads = start, [], []
    for k, (angle, rate) in enumerate(zip(q, u, strict=True)):
        link = me.ReferenceFrame(f"A{k}")
        link.orient_axis(ground, ground.z, angle)
        link.set_ang_vel(ground, rate * ground.z)
        center, end = (joint.locatenew(f"P{k}", share * length * link.x) for share in (0.5, 1))
        center.v2pt_theory(joint, ground, link)
        end.v2pt_theory(joint, ground, link)
        about = me.inertia(link, 0, 0, m * length**2 / 12)
        bodies.append(me.RigidBody(f"B{k}", center, link, m, (about, center)))
        loads.append((center, -m * g * ground.y))
        joint = end
    gap = joint.pos_from(start) - width * ground.x
    held = [gap.dot(axis) for axis in (ground.x, ground.y)]
    rates = [angle.diff(zoo.T) - rate for angle, rate in zip(q, u, strict=True)]
    moved = [joint.vel(ground).dot(axis) for axis in (ground.x, ground.y)]
    kane = me.KanesMethod(
        ground, q[:-2], u[:-2], rates, q_dependent=q[-2:], configuration_constraints=held,
        u_dependent=u[-2:], velocity_constraints=moved, bodies=bodies, forcelist=loads,
    )  # fmt: skip
    return System(kane), q, constants


@pytest.mark.parametrize(("metre", "second"), [(1e9, 1.0), (1.0, 1.0), (1e-7, 1 / 3600)])
@pytest.mark.parametrize("spread", [0.5, 3.0])
def test_a_chain_far_from_rest_hangs_by_equal_forces_in_any_units(
    hanging_chain, metre, second, spread
):
    """Links of a chain that hangs change the slope of its joints' forces by equal parts."""
    system, q, constants = hanging_chain
    sizes = (1e-3, 0.25 * metre, 9.81 * metre / second**2, 0.75 * metre)
    system.constants = dict(zip(constants, sizes, strict=True))
    rng = np.random.default_rng(1)
    start = np.linspace(-1.2, 1.2, len(q)) + rng.uniform(-spread, spread, len(q))
    system.initial_conditions = dict(zip(q, start, strict=True))
    found = system.find_equilibrium()
    angles = np.array([found[angle] for angle in q])
    assert np.cos(angles).sum() == pytest.approx(3.0, rel=1e-12)
    assert np.sin(angles).sum() == pytest.approx(0.0, abs=1e-12)
    assert np.diff(np.tan(angles), n=2) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(
    ("start", "upright"),
    [
        ((0.117, 0.0717, -0.1998, 0.0272), True),
        ((-0.0517, -0.1259, -0.1837, -0.0205), True),
        ((0.2246, 0.4904, 0.0818, -0.37), False),
        ((-0.2875, 0.48, 0.0609, -0.5196), False),
        ((-0.2913, -0.3408, 0.1263, -0.3165), False),
    ],
)
@pytest.mark.parametrize("rounding", [0.0, 1e-9, 2e-9])
def test_a_chain_that_nearly_stands_comes_to_an_equilibrium(start, upright, rounding):
    system = n_link_pendulum_on_cart(3, cart_force=False)
    system.constants = {s: 1.0 + 0.1 * k for k, s in enumerate(system.constants_symbols)}
    start = np.array(start) * (1.0 + rounding * np.array([1.0, -0.7, 0.4, -1.3]))
    system.initial_conditions = dict(zip(system.coordinates, start, strict=True))
    found = system.find_equilibrium()
    angles = np.array([found.values[q] for q in system.coordinates[1:]])
    assert np.abs(np.sin(angles)).max() < 1e-9
    assert not upright or np.abs(angles).max() < 1e-9


@pytest.mark.parametrize("metre", [1e-6, 1.0, 1e9])
def test_carts_hang_and_what_falls_has_no_equilibrium_in_any_units(metre):
    """In nanometres the search used to end 4e7 turns away; in megametres a free fall was rest."""
    cart = n_link_pendulum_on_cart(2)
    cart.constants = {"g": 9.81 * metre, "l0": 0.5 * metre, "l1": 0.3 * metre}
    cart.initial_conditions = {"q0": 0.7 * metre, "q1": 3.0, "q2": 3.3}
    found = cart.find_equilibrium()
    assert found["q0"] == pytest.approx(0.7 * metre, rel=1e-12)
    assert [found["q1"], found["q2"]] == pytest.approx([np.pi, np.pi], abs=1e-12)
    assert found.free == ("q0",)
    (x, y), (v, w) = me.dynamicsymbols("x y"), me.dynamicsymbols("v w")
    k, m, g = sm.symbols("k m g")
    frame, origin = inertial_frame()
    held, falls = origin.locatenew("P", x * frame.x), origin.locatenew("Q", y * frame.x)
    bodies = [me.Particle("a", held, m), me.Particle("b", falls, m)]
    loads = [(held, -k * x * frame.x), (falls, m * g * frame.x)]
    two = Definition(frame, [x, y], [v, w], bodies=bodies, loads=loads)
    system = System(two, constants={k: 1e6, m: 1e-3, g: 3.0 * metre})
    with pytest.raises(EquilibriumError, match="the derivative of w"):
        system.find_equilibrium()


@pytest.mark.parametrize("metre", [1e-9, 1.0, 1e9])
@pytest.mark.parametrize("lagrangian", [False, True])
def test_what_rods_carry_is_at_rest_in_any_units(metre, lagrangian):
    """All weight is the constraints': of the accelerations nothing but rounding is left."""
    x, y = me.dynamicsymbols("x y")
    mass, g, rod, half = sm.symbols("m g l d")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", x * frame.x + y * frame.y)
    point.set_vel(frame, x.diff() * frame.x + y.diff() * frame.y)
    bob, loads = me.Particle("bob", point, mass), [(point, -mass * g * frame.y)]
    rods = [(x - half) ** 2 + y**2 - rod**2, (x + half) ** 2 + y**2 - rod**2]
    if lagrangian:
        method = me.LagrangesMethod(
            me.Lagrangian(frame, bob), [x, y], hol_coneqs=rods, forcelist=loads, frame=frame
        )
    else:
        method = Definition(frame, [x, y], bodies=[bob], loads=loads, holonomic_constraints=rods)
    numbers = {mass: 1.0, g: 9.81 * metre, rod: metre, half: 0.6 * metre}
    system = System(method, numbers, initial_conditions={x: 0.1 * metre, y: -0.9 * metre})
    assert "1 loads" in repr(system._equations)  # which failed where a Lagrangian has no bodies
    found = system.find_equilibrium()
    assert found.state == pytest.approx([0.0, -0.8 * metre, 0.0, 0.0], abs=1e-9 * metre)
    assert found.free == ()


@pytest.mark.parametrize("metre", [1e-18, 1e-13, 1.0, 1e13, 1e18])
def test_an_angle_without_inertia_is_judged_in_no_unit(metre):
    """Below 1e-10 any height was an equilibrium; beyond 1e13 the deflection x seemed to be free."""
    x, y, angle = me.dynamicsymbols("x y theta")
    m, g, k, length = sm.symbols("m g k l")
    frame, origin = inertial_frame()
    bob = origin.locatenew("P", x * frame.x + y * frame.y)
    bob.set_vel(frame, x.diff() * frame.x + y.diff() * frame.y)
    held = [x - length * sm.sin(angle), y + length * sm.cos(angle)]
    made = Definition(
        frame, [x, y, angle], bodies=[me.Particle("b", bob, m)], holonomic_constraints=held,
        loads=[(bob, -m * g * frame.y - k * x * frame.x)], dependent_coordinates=[x, y],
    )  # fmt: skip
    system = System(made, constants={m: 1.0, g: 9.0 * metre, k: 7.0, length: metre})
    system.initial_conditions = {x: 0.3 * metre, x.diff(): 0.6 * metre, y: -0.9 * metre, angle: 0.2}
    system.set_dependent_initial_conditions([y, angle, y.diff(), angle.diff()])
    assert system.initial_conditions[angle] == pytest.approx(np.arcsin(0.3), rel=1e-12)
    speed = 0.6 / np.cos(np.arcsin(0.3))
    assert system.initial_conditions[angle.diff()] == pytest.approx(speed, rel=1e-12)
    found = system.find_equilibrium()
    assert found.free == ()
    assert found[y] == pytest.approx(-metre, rel=1e-12)
    system.initial_conditions = found.initial_conditions
    eigenvalues = system.linearize().eigenvalues
    assert np.sort(eigenvalues.imag) == pytest.approx([-4.0, 4.0], rel=1e-9)
    branch = system.follow_equilibria({k: [7.0, -12.0]}, step=0.2)
    assert [p.kind for p in branch.special] == ["branch point"]
    assert branch.special[0].value == pytest.approx(-9.0, rel=1e-6)


@pytest.mark.parametrize(
    "call",
    [
        lambda s: s.find_equilibrium(),
        lambda s: s.eigenvalues({str(min(s.constants_symbols, key=str)): [0.5, 1.0]}),
        lambda s: s.follow_equilibria({str(min(s.constants_symbols, key=str)): (0.5, 1.0)}),
    ],
)
def test_numpys_error_state_is_the_users_own_affair(call):
    with np.errstate(all="raise"):
        assert call(System(zoo.chain().kane))


@pytest.mark.parametrize("start", [{"e0": 0.1, "e1": 0.9}, {"e0": 0.1, "e1": 0.995}, {"e1": -2.0}])
@pytest.mark.parametrize("metre", [1.0, 1e-9])
def test_the_quaternion_of_an_equilibrium_is_of_unit_length(start, metre):
    # No constraint holds the length. The rates alone are also zero at e = 0, and at e1 = 0.9.
    e, u = me.dynamicsymbols("e0:4"), me.dynamicsymbols("u1:4")
    e0, e1, e2, e3 = e
    frame, origin = inertial_frame()
    body = frame.orientnew("B", "Quaternion", e)
    body.set_ang_vel(frame, sum((w * axis for w, axis in zip(u, body, strict=True)), 0 * frame.x))
    centre = origin.locatenew("C", 0.2 * metre * body.z)
    inertia = (me.inertia(body, 0.08 * metre**2, 0.07 * metre**2, 0.03 * metre**2), origin)
    top = me.RigidBody("top", centre, body, 1.3, inertia)
    rates = sm.Matrix([[-e1, -e2, -e3], [e0, -e3, e2], [e3, e0, -e1], [-e2, e1, e0]])
    turning = list(2 * sm.Matrix(e).diff(me.dynamicsymbols._t) - rates * sm.Matrix(u))
    hanging = Definition(
        frame, e, u, bodies=[top], loads=[(centre, -1.3 * 9.81 * metre * frame.z)],
        kinematic_equations=turning,
    )  # fmt: skip
    system = System(hanging, initial_conditions=start)
    found = system.find_equilibrium()
    assert found.state[:4] @ found.state[:4] == pytest.approx(1.0, abs=1e-12)
    squares = [1.3 * 9.81 * 0.2 / inertia for inertia in (0.08, 0.07)]  # of physical pendulums
    frequencies = np.sort(np.abs(system.linearize(at=found).eigenvalues.imag))[-4::2]
    assert frequencies == pytest.approx(np.sqrt(squares), rel=1e-7)


def random_starts(system, count):
    rng = np.random.default_rng(3)
    for _ in range(count):
        yield {q: rng.uniform(-3.0, 3.0) for q in system.coordinates}


@pytest.mark.parametrize(
    "make",
    [lambda: system_of(zoo.fourbar()), lambda: n_link_pendulum_on_cart(5, cart_force=False)],
    ids=["a linkage that is not assembled", "a chain"],
)
def test_an_equilibrium_has_no_angle_more_than_half_a_revolution_from_the_start(make):
    """Twelve of forty linkages had turned twice, most chains up to five hundred times."""
    system = make()
    for start in random_starts(system, 10):
        system.initial_conditions = start
        found = system.find_equilibrium()
        system.initial_conditions = found.initial_conditions
        assert max(abs(found[q] - start[q]) for q in system.coordinates) <= np.pi + 1e-9
        assert np.abs(system.evaluate_ode()).max() < 1e-9
