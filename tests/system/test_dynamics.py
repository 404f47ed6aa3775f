"""Inverse dynamics and its terms, and how frames move: against the forward equations and SymPy."""

import re

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy import System
from pydy._mechanics import inverse
from pydy.errors import PyDyUserWarning, SingularMatrixError
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from zoo import inertial_frame, joints, loops
from zoo.by_hand import MECHANISMS
from zoo.cases import close, system_of

T = me.dynamicsymbols._t
OWN = (
    "camera", "mixed_speeds", "gimbals", "burning_rocket", "own_velocities", "coupler", "wheel",
    "given_accelerations", "towed_sledge", "driven_crane",
)  # fmt: skip
MODELS = {**zoo.MODELS, **{name: MECHANISMS[name] for name in OWN}}


def consistent(name):
    """A System, its state and the accelerations there."""
    system = system_of(MODELS[name]())
    if len(system.constraints):
        system.set_dependent_initial_conditions()
    x = np.array([system.initial_conditions.get(s, 0.1) for s in system.states])
    n = len(system.coordinates)
    q, v = x[:n], x[n : n + len(system.speeds)]
    return system, q, v, system.evaluate_ode(x)[n : n + len(v)]


def four_bar():
    """A four-bar of pins that a torque T drives at its first pin, standing."""
    method, torque = joints.four_bar(), me.dynamicsymbols("T")
    link = method.bodies[1].frame
    method.add_loads((link, torque * link.z))
    system = System(method)
    numbers = {"l1": 1.9, "l2": 0.8, "l3": 1.4, "l4": 1.3, "rho": 2.0, "g": 9.7}
    system.constants = {s: numbers[s.name] for s in system.constants_symbols}
    system.initial_conditions = {"q1": 1.2, "q2": -0.9, "q3": -1.4, "u1": 0.7}
    system.set_dependent_initial_conditions()
    x = np.array([system.initial_conditions[s] for s in system.states])
    return system, x[:3], x[3:]


@pytest.mark.parametrize("name", MODELS)
def test_the_motion_that_loads_cause_takes_no_further_forces(name):
    system, q, v, a = consistent(name)
    forces = system.inverse_dynamics(q, v, a)
    size = np.abs(system.mass_matrix(q)) @ np.abs(a) + np.abs(system.bias(q, v))
    for rates in (a, a[: len(a) - system.num_velocity_constraints]):
        left = system.inverse_dynamics(q, v, rates, at="independent")
        assert np.abs(left).max() <= 1e-12 * size.max()
    assert len(forces) == len(a)


@pytest.mark.parametrize("name", [name for name in MODELS if name != "added_mass"])
def test_inverse_dynamics_is_mass_times_acceleration_and_bias(name):
    system, q, v, _ = consistent(name)
    a = np.random.default_rng(2).normal(size=len(v))
    matrix = system.mass_matrix(q)
    found = system.inverse_dynamics(q, v, a)
    parts = matrix @ a, system.bias(q, v)
    assert np.abs(found - sum(parts)).max() <= 1e-12 * np.abs(parts).max()
    close(matrix, system.inverse_dynamics(q, v, a, wrt="accelerations"), 1e-12)
    if name != "towed_sledge":  # its loads hold accelerations
        np.testing.assert_array_equal(matrix, matrix.T)


def test_loads_that_hold_accelerations_are_part_of_the_mass_matrix():
    system = system_of(zoo.MODELS["added_mass"]())
    q, v = np.array([0.3, 0.4]), np.array([0.5, -0.2])
    close(
        system.inverse_dynamics(q, v, [1.0, 0.0]) - system.bias(q, v),
        system.inverse_dynamics(q, v, [0.3, 2.0], wrt="accelerations")[:, 0],
    )


def test_forces_of_all_speeds_are_what_multipliers_do_there():
    system, q, v, a = consistent("fourbar")
    system.outputs = system.constraint_forces
    x = np.concatenate([q, v])
    multipliers = system.evaluate_outputs(x)[:2]
    slopes = system.evaluate_jacobian(x, wrt=system.speeds, of="velocity")
    forces = system.inverse_dynamics(q, v, a)
    assert np.abs(forces - slopes.T @ multipliers).max() <= 1e-12 * np.abs(forces).max()


@pytest.mark.parametrize("torque", [0.0, 1.7])
def test_the_torque_that_drives_a_loop_is_found_again(torque):
    system, q, v = four_bar()
    a = system.evaluate_ode(np.concatenate([q, v]), r={"T": torque})[3:]
    close(system.inverse_dynamics(q, v, a, at=["u1"]), [torque], 1e-12)
    close(system.inverse_dynamics(q, v, a[:1], at=["u1"]), [torque], 1e-12)
    close(system.inverse_dynamics(q, v, {"u1": a[0]}, at="independent"), [torque], 1e-12)
    power = system.inverse_dynamics(q, v, a, at=["u3"]) * v[2]
    close(power, [torque * v[0]], 1e-12)  # at another pin: the same power


def test_accelerations_of_any_speeds_that_leave_nothing_free_bring_the_others_along():
    system, q, v = four_bar()
    a = system.evaluate_ode(np.concatenate([q, v]), r={"T": 1.7})[3:]
    whole = system.inverse_dynamics(q, v, a)
    for k, speed in enumerate(system.speeds):
        close(system.inverse_dynamics(q, v, {speed: a[k]}), whole, 1e-11)
        close(system.inverse_dynamics(q, v, {speed: a[k]}, at=["u1"]), [1.7], 1e-11)
    slope = system.inverse_dynamics(q, v, {"u2": a[1]}, wrt="accelerations")
    rise = [system.inverse_dynamics(q, v, {"u2": a[1] + step}) for step in (-1.0, 1.0)]
    close(slope[:, 0], (rise[1] - rise[0]) / 2, 1e-12)


def test_accelerations_that_the_others_do_not_follow_from_are_refused():
    system, q, v = four_bar()
    with pytest.raises(ValueError, match=r"of 1 of the 3 speeds.*got 2: u1\(t\), u3\(t\)"):
        system.inverse_dynamics(q, v, {"u1": 1.0, "u3": 2.0})
    with pytest.raises(ValueError, match="accelerations of all 3 speeds"):
        system.regressor(q, v, {"u3": 2.0})


def test_states_given_in_part_that_break_the_constraints_are_told(recwarn):
    system, q, v = four_bar()
    close(system.inverse_dynamics({"q1": q[0]}, {"u1": v[0]}), system.inverse_dynamics(q, v))
    system.frame_position("link1", {"q1": 0.3})  # depends on no other
    system.inverse_dynamics(q + 0.1, v)  # a whole state is what the user says
    assert not recwarn.list
    with pytest.warns(PyDyUserWarning, match=r"the initial conditions for .*: q2\(t\), q3\(t\)"):
        system.gravity({"q1": 0.3})
    with pytest.warns(PyDyUserWarning, match=r"u2\(t\), u3\(t\)\. The residuals"):
        system.bias(q, {"u1": 2.0})
    with pytest.warns(PyDyUserWarning, match="velocity constraint"):
        system.inverse_dynamics(q, {"u1": [2.0][0]}, at=["u1"])


def test_a_loop_that_no_force_at_a_speed_can_drive_is_told():
    made, start = loops.parallelogram()
    system = System(made, {"g": 9.7}, initial_conditions=start)
    free = len(system.speeds) - system.num_velocity_constraints
    with pytest.raises(ValueError, match=rf"`at` must be 'independent' or {free} different speeds"):
        system.inverse_dynamics(at=system.speeds)
    sliders, (x, y) = me.ReferenceFrame("N"), me.dynamicsymbols("x y")
    origin = me.Point("O")
    origin.set_vel(sliders, 0)
    bob = me.Particle("bob", origin.locatenew("P", x * sliders.x + y * sliders.y), 2.0)
    circle = Definition(
        sliders, [x, y], bodies=[bob], holonomic_constraints=[x**2 + y**2 - 1],
        dependent_coordinates=[y], dependent_speeds=[y.diff(T)],
    )  # fmt: skip
    system = System(circle)
    with pytest.raises(SingularMatrixError, match="`at` and `a` leave") as found:
        system.inverse_dynamics([1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], at=[x.diff(T)])
    np.testing.assert_array_equal(found.value.state, [1.0, 0.0, 0.0, 1.0])  # the states alone


def test_states_in_rows_give_the_same_as_one_by_one():
    system = n_link_pendulum_on_cart(2)
    q, v, a = np.random.default_rng(5).normal(size=(3, 7, 3))
    found = system.inverse_dynamics(q, v, a)
    slopes = system.inverse_dynamics(q, v, a, wrt=["coordinates", "m1"])
    assert found.shape == (7, 3)
    assert slopes.shape == (7, 3, 4)
    for k in range(7):
        np.testing.assert_array_equal(found[k], system.inverse_dynamics(q[k], v[k], a[k]))
        np.testing.assert_array_equal(
            slopes[k], system.inverse_dynamics(q[k], v[k], a[k], wrt=["coordinates", "m1"])
        )
    np.testing.assert_array_equal(  # one for all
        system.inverse_dynamics(q[0], v, a[0]),
        system.inverse_dynamics(np.tile(q[0], (7, 1)), v, np.tile(a[0], (7, 1))),
    )
    assert system.mass_matrix(q).shape == (7, 3, 3)
    assert system.gravity(q).shape == system.bias(q, v).shape == (7, 3)


def test_derivatives_are_those_of_the_values():
    system = n_link_pendulum_on_cart(2)
    q, v, a = np.random.default_rng(6).normal(size=(3, 3))
    step = 1e-6
    for k, which in enumerate(("coordinates", "speeds", "accelerations")):
        slopes = system.inverse_dynamics(q, v, a, wrt=which)
        for j in range(3):
            ahead, back = [[q.copy(), v.copy(), a.copy()] for _ in range(2)]
            ahead[k][j] += step
            back[k][j] -= step
            rise = system.inverse_dynamics(*ahead) - system.inverse_dynamics(*back)
            close(slopes[:, j], rise / (2 * step), 1e-7)
    body = system.eom_method.bodies[2]
    close(
        system.frame_position(body, q, wrt=system.coordinates),
        system.frame_jacobian(body, q),  # here speeds are the rates of the coordinates
        1e-15,
    )


def test_specifieds_and_constants_of_one_call_count():
    system = n_link_pendulum_on_cart(1)
    close(system.inverse_dynamics([0.0, 0.0], r={"F": 3.0}), [-3.0, 0.0])
    close(system.mass_matrix([0.0, 0.0], p={"m0": 4.0})[0, 0], 5.0)
    system.specifieds = {"F": -2.0 * system.coordinates[0]}
    close(system.bias([0.5, 0.0], [0.0, 0.0])[0], 1.0)
    close(system.bias([0.5, 0.0], [0.0, 0.0], wrt=["q0"])[0, 0], 2.0)


def test_gravity_is_the_slope_of_the_potential_energy():
    system = n_link_pendulum_on_cart(3)
    q = np.array([0.2, 0.5, -0.8, 1.1])
    slope = system.evaluate_gradient(system.potential_energy, [*q, *[0.0] * 4], wrt=system.states)
    close(system.gravity(q), slope[:4], 1e-14)
    frame = system._equations.mechanism.frame
    close(system.gravity(q, acceleration=-sm.Symbol("g") * frame.y), slope[:4], 1e-14)
    sideways = system.gravity(q, acceleration=2.0 * frame.x)
    close(sideways[0], -2.0 * 4)  # four unit masses


@pytest.mark.parametrize("mass", [2, sm.Symbol("m")])
def test_a_weight_along_turning_axes_is_gravity(mass):
    q, u = me.dynamicsymbols("q:2"), me.dynamicsymbols("u:2")
    frame, origin, g = me.ReferenceFrame("N"), me.Point("O"), sm.Symbol("g")
    origin.set_vel(frame, 0)
    arm = frame.orientnew("B", "Body", (*q, 0), "zxz")
    arm.set_ang_vel(frame, u[0] * frame.z + u[1] * arm.x)
    tip = origin.locatenew("P", arm.x + arm.y)
    tip.v2pt_theory(origin, frame, arm)
    body = me.RigidBody("arm", tip, arm, mass, (me.inertia(arm, 1, 2, 3), tip))
    weight = (-mass * g * frame.y).express(arm)
    rates = [a.diff() - b for a, b in zip(q, u, strict=True)]
    system = System(me.KanesMethod(frame, q, u, rates, bodies=[body], forcelist=[(tip, weight)]))
    state = [0.3, 0.4], [0.0, 0.0]
    held = system.inverse_dynamics(*state, [0.0, 0.0])
    assert held.all()
    close(system.gravity(state[0]), held)
    parameters = [*system.inertial_parameters().values()]
    close(system.regressor(*state, [0.0, 0.0]) @ parameters, held)
    if mass == 2:  # in one vector with a drag it may be another force
        drag = -sm.Symbol("c") * tip.vel(frame)
        loads = [(tip, weight + drag)]
        system = System(me.KanesMethod(frame, q, u, rates, bodies=[body], forcelist=loads))
        with pytest.raises(ValueError, match="which way gravity pulls"):
            system.gravity(state[0])


def test_gravity_that_no_load_tells_is_asked_for():
    with pytest.raises(ValueError, match="Give it: `acceleration=-g"):
        consistent("towed_sledge")[0].gravity()
    with pytest.raises(TypeError, match=r"`acceleration` must be a Vector, .* got the float 9\.8"):
        multi_mass_spring_damper().gravity(acceleration=9.8)
    close(multi_mass_spring_damper().gravity([1.0]), [0.0])


@pytest.mark.parametrize("apart", [True, False])
def test_a_weight_in_numbers_beside_other_forces_in_one_vector_is_not_taken_for_none(apart):
    x, y, u, v = me.dynamicsymbols("x y u v")
    c = sm.Symbol("c")
    frame, origin = inertial_frame()
    bodies, loads = [], []
    for k, (place, speed, mass) in enumerate([(x, u, 2.0), (y, v, 3.0)]):
        point = origin.locatenew(f"P{k}", place * frame.y)
        point.set_vel(frame, speed * frame.y)
        bodies.append(me.Particle(f"p{k}", point, mass))
        weight, drag = -9.81 * mass * frame.y, -c * speed * frame.y
        loads += [(point, weight), (point, drag)] if apart else [(point, weight + drag)]
    system = System(Definition(frame, [x, y], [u, v], bodies=bodies, loads=loads))
    if apart:
        close(system.gravity([0.0, 0.0]), [19.62, 29.43])
        return
    for asked in (system.gravity, system.regressor):
        with pytest.raises(ValueError, match="gravity"):
            asked()
    close(system.gravity([0.0, 0.0], acceleration=-9.81 * frame.y), [19.62, 29.43])


X, Y = me.dynamicsymbols("x y")
M, G, K, RHO, L, M0, M1 = sm.symbols("m g k rho L m0 m1")


def falling(mass, forces, beside="itself"):
    """A particle with forces, each a pair of components, at its place or at one that coincides."""
    frame, origin = inertial_frame()
    point = origin.locatenew("P", X * frame.x + Y * frame.y)
    again = origin.locatenew("Q", X * frame.x + Y * frame.y)
    where = {"itself": point, "joined": point.locatenew("Q", 0), "again": again}[beside]
    loads = [(where, a * frame.x + b * frame.y) for a, b in forces]
    system = System(Definition(frame, [X, Y], bodies=[me.Particle("b", point, mass)], loads=loads))
    values = {M: 2.0, G: 10.0, K: 3.0, RHO: 4.0, L: 0.5, M0: 0.5, M1: 1.5}
    system.constants = {s: values[s] for s in system.constants_symbols}
    return system


@pytest.mark.parametrize(
    ("mass", "forces"),
    [
        (M, [(0, -M * G)]),
        (M, [(0, -M * G), (-K * M * G * sm.sign(X.diff(T)), 0)]),
        (M, [(0, -K * Y - M * G)]),
        (2 * M0 + M0 + M1 - M0, [(0, -(2 * M0 + M1) * G)]),
        (4 * M0, [(0, -4 * M0 * G - K * Y)]),
        (RHO * L, [(0, -RHO * L * G - K * Y)]),
        (RHO * L, [(0, -RHO * L * G), (0, -K * (Y - L))]),
        (M0 + M1, [(0, -(M0 + M1) * G)]),
        (M0 + M1, [(0, -M0 * G), (0, -M1 * G)]),
        (M, [(-M * G * sm.cos(K), 0), (0, -M * G * sm.sin(K))]),
    ],
)
@pytest.mark.parametrize("beside", ["itself", "joined", "again"])
def test_what_is_a_weight_for_certain_is_gravity(mass, forces, beside):
    system = falling(mass, forces, beside)
    rest = {X: 0, Y: 0, X.diff(T): 0, **system.constants}
    weight = [float(sum(sm.sympify(f[k]).subs(rest) for f in forces)) for k in range(2)]
    if len(forces) == 2 and forces[1][1] == -K * (Y - L):
        weight[1] -= 1.5  # the spring's
    close(system.gravity([0.0, 0.0]), -np.array(weight))
    forces = system.regressor([0.0, 0.0], [0.0, 0.0], [0.0, 0.0])
    close(forces @ [*system.inertial_parameters().values()], -np.array(weight))


@pytest.mark.parametrize(
    ("mass", "forces"),
    [
        (M, [(-K * M * G * sm.sign(X.diff(T)), -M * G)]),
        (M, [(0, M * (me.dynamicsymbols("f") - G))]),
        (M, [(M * K**2 * X, -M * G)]),
        (M0 + M1, [(0, -M0 * G)]),
        (RHO * L, [(0, -RHO * L * G - K * (Y - L))]),
        (2, [(0, -2 * G), (3, 0)]),
    ],
)
def test_what_may_be_a_weight_or_another_load_is_asked_for(mass, forces):
    system = falling(mass, forces)
    state = np.zeros((3, 4, 2))
    for ask in (system.gravity, system.regressor, lambda: system.base_parameters(*state)):
        with pytest.raises(ValueError, match="which way gravity pulls"):
            ask()


def test_a_weight_that_is_at_no_mass_centre_is_asked_for():
    frame, origin = inertial_frame()
    points = [origin.locatenew(n, s * frame.y) for n, s in (("A", X), ("B", Y))]
    bodies = [me.Particle(p.name, p, m) for p, m in zip(points, (M0, M1), strict=True)]
    together = origin.locatenew("C", (M0 * X + M1 * Y) / (M0 + M1) * frame.y)
    system = System(
        Definition(frame, [X, Y], bodies=bodies, loads=[(together, -(M0 + M1) * G * frame.y)])
    )
    system.constants = {M0: 2.0, M1: 3.0, G: 10.0}
    for ask in (system.gravity, system.regressor):
        with pytest.raises(ValueError, match="which way gravity pulls"):
            ask()
    close(system.gravity(acceleration=-G * frame.y), [20.0, 30.0])


def test_places_of_weights_are_compared_in_one_go(monkeypatch):
    """Bodies by loads, each pair by itself, took 4 s for a pendulum of 60 links."""
    counted, whole = [], inverse.signatures
    monkeypatch.setattr(inverse, "signatures", lambda *a: counted.append(1) or whole(*a))
    system = n_link_pendulum_on_cart(8)
    system.constants = dict.fromkeys(system.constants_symbols, 1.5)
    system.gravity(np.zeros(9))
    assert len(counted) == 1


def test_a_lagrangian_has_inverse_dynamics_too():
    theta, x = me.dynamicsymbols("theta x")
    frame, origin = inertial_frame()
    arm = frame.orientnew("A", "Axis", (theta, frame.z))
    cart = origin.locatenew("C", x * frame.x)
    cart.set_vel(frame, x.diff(T) * frame.x)
    bob = cart.locatenew("P", -2 * arm.y)
    bob.v2pt_theory(cart, frame, arm)
    bodies = [me.Particle("cart", cart, 3), me.Particle("bob", bob, 1.5)]
    bodies[1].potential_energy = 1.5 * 10 * bob.pos_from(origin).dot(frame.y)
    for rows in ((), [x - sm.sin(theta)]):
        lagrange = me.LagrangesMethod(
            me.Lagrangian(frame, *bodies), [x, theta], hol_coneqs=rows, bodies=bodies, frame=frame
        )
        lagrange.form_lagranges_equations()
        system = System(lagrange)
        values = {x: np.sin(0.4), theta: 0.4, x.diff(T): 0.9 * np.cos(0.4), theta.diff(T): 0.9}
        system.initial_conditions = values
        tau = system.inverse_dynamics(a=system.evaluate_ode()[2:], at="independent")
        assert np.abs(tau).max() < 1e-13
        order = [system.coordinates.index(s) for s in (x, theta)]
        across = 3.0 * np.cos(0.4)
        close(system.mass_matrix()[np.ix_(order, order)], [[4.5, across], [across, 6.0]])
        with pytest.raises(ValueError, match="Give it"):
            system.gravity()


def test_a_method_without_bodies_has_what_needs_none():
    x, v = me.dynamicsymbols("x v")
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, v * frame.x)
    kane = me.KanesMethod(frame, [x], [v], kd_eqs=[x.diff(T) - v])
    kane.kanes_equations([me.Particle("A", point, 2.0)], [(point, -3.0 * x * frame.x)])
    system = System(kane, equations="method")
    close(system.inverse_dynamics([1.0], [0.0], [2.0]), [7.0])
    close(system.mass_matrix(), [[2.0]])


def test_frames_move_as_sympy_says():
    system, q, _, _ = consistent("free_body")
    body = system.eom_method.bodies[0]
    frame = system._equations.mechanism.frame
    numbers = {**dict(zip(system.coordinates, q, strict=True)), **system.constants}
    turn = np.array(body.frame.dcm(frame).T.subs(numbers), dtype=float)
    close(system.frame_rotation(body.name, q), turn, 1e-15)
    rows = [body.masscenter.vel(frame).dot(e) for e in frame]
    rows += [body.frame.ang_vel_in(frame).dot(e) for e in frame]
    slopes = sm.Matrix(rows).jacobian(system.speeds).subs(numbers)
    close(system.frame_jacobian(body, q), np.array(slopes, dtype=float), 1e-15)
    close(system.frame_jacobian(body.masscenter, q), np.array(slopes, dtype=float)[:3], 1e-15)
    close(system.frame_jacobian(body.frame, q), np.array(slopes, dtype=float)[3:], 1e-15)


def test_what_a_place_or_gravity_holds_must_be_known():
    system = n_link_pendulum_on_cart(1)
    frame, point = system._equations.mechanism.frame, system.eom_method.bodies[1].masscenter
    for strange in (me.dynamicsymbols("f"), sm.Symbol("k")):
        beside = point.locatenew("beside", strange * frame.x)
        turned = frame.orientnew("turned", "Axis", [strange, frame.z])
        for call in (
            lambda: system.frame_position(beside),  # noqa: B023
            lambda: system.frame_rotation(turned),  # noqa: B023
            lambda: system.gravity(acceleration=strange * frame.y),  # noqa: B023
        ):
            with pytest.raises(ValueError, match=rf"`{re.escape(str(strange))}` occurs in the"):
                call()
        # It moves with no speed.
        close(system.frame_jacobian(beside), system.frame_jacobian(point))
    known = point.locatenew("known", 2 * sm.Symbol("m0") * frame.x)
    close(system.frame_position(known) - system.frame_position(point), [2.0, 0.0, 0.0])


def test_a_motion_of_which_the_equations_hold_derivatives_alone_has_a_place():
    t, (q, u, f) = me.dynamicsymbols._t, me.dynamicsymbols("q u f")
    N, O = inertial_frame()
    base = O.locatenew("base", f * N.x)
    base.set_vel(N, f.diff(t) * N.x)
    A = N.orientnew("A", "Axis", [q, N.z])
    A.set_ang_vel(N, u * N.z)
    bob = base.locatenew("bob", A.x)
    bob.v2pt_theory(base, N, A)
    kane = me.KanesMethod(N, [q], [u], [q.diff(t) - u])
    kane.kanes_equations([me.Particle("bob", bob, 1)], [(bob, -9.81 * N.y)])
    system = System(kane)
    with pytest.raises(ValueError, match=r"`f\(t\)` occurs in the position"):
        system.frame_position(bob)
    system.specifieds = {f: 3.0}
    close(system.frame_position(bob), [4.0, 0.0, 0.0])


def test_what_holds_no_specified_calls_no_function_of_one():
    system, numbers = n_link_pendulum_on_cart(1), n_link_pendulum_on_cart(1)
    numbers.specifieds = {"F": 3.0}

    def force(x, t):
        raise RuntimeError("called")

    system.specifieds = {"F": force}
    for find in (
        lambda one: one.mass_matrix(),
        lambda one: one.mass_matrix(wrt=["q1", "F"]),
        lambda one: one.gravity(),
        lambda one: one.frame_position(one.eom_method.bodies[1]),
        lambda one: one.frame_jacobian(one.eom_method.bodies[1]),
        lambda one: one.regressor(),
    ):
        np.testing.assert_array_equal(find(system), find(numbers))
    with pytest.raises(RuntimeError, match="called"):
        system.bias()  # which the force is part of


def test_vectors_that_are_none_are_named():
    system = n_link_pendulum_on_cart(1)
    frame, point = system._equations.mechanism.frame, system.eom_method.bodies[1].masscenter
    with pytest.raises(ValueError, match="`acceleration` is NaN times a vector"):
        system.gravity(acceleration=frame.y * sm.nan)
    with pytest.raises(ValueError, match="The frame loose has no orientation in the inertial"):
        system.gravity(acceleration=me.ReferenceFrame("loose").y)
    with pytest.raises(ValueError, match="velocity or load is NaN times a vector"):
        system.frame_position(point.locatenew("nowhere", frame.x * sm.nan))
    with pytest.raises(ValueError, match=r"`up` must be an axis .* got a Vector"):
        system.scene(up=frame.x * sm.nan)
    with pytest.raises(TypeError, match="`origin` must be a Point, got the int 3"):
        system.scene(origin=3)
    with pytest.raises(TypeError, match="`reference_frame` must be a ReferenceFrame, got the int"):
        system.scene(reference_frame=3)


def test_a_place_is_known_by_the_name_that_a_definition_gives_it():
    q = me.dynamicsymbols("q")
    frame, origin = inertial_frame()
    arm = frame.orientnew("A", "Axis", (q, frame.z))
    tip = origin.locatenew("tip", 2 * arm.x)
    bob = me.Particle("bob", origin.locatenew("C", arm.x), 1.0)
    made = Definition(frame, [q], bodies=[bob], frames={"tool": (arm, tip)})
    system = System(made)
    close(system.frame_position("tool", [np.pi / 2]), [0.0, 2.0, 0.0], 1e-15)
    close(system.frame_position((arm, tip), [0.0]), [2.0, 0.0, 0.0])
    close(system.frame_jacobian("tool", [0.0])[:, 0], [0.0, 2.0, 0.0, 0.0, 0.0, 1.0])
    close(system.frame_jacobian("bob", [0.0])[:, 0], [0.0, 1.0, 0.0])
    for call in (system.frame_position, system.frame_rotation, system.frame_jacobian):
        with pytest.raises(ValueError, match=r"`where` must be a body.*tool, bob; got 'tip'"):
            call("tip")
    with pytest.raises(ValueError, match="`where` must have a point, got the frame A"):
        system.frame_position(arm)
    with pytest.raises(ValueError, match="`where` must have a frame, got tip"):
        system.frame_rotation(tip)
    with pytest.raises(ValueError, match="`where` is the point lost, whose place"):
        system.frame_position(me.Point("lost"))
    with pytest.raises(TypeError, match="`frames` must map names to pairs"):
        Definition(frame, [q], bodies=[bob], frames={"tool": tip})


@pytest.mark.parametrize(
    ("argument", "value"), [("q", [1.0, 2.0]), ("v", np.zeros((2, 3))), ("a", [[[1.0]]])]
)
def test_shapes_that_do_not_fit_are_told(argument, value):
    system = multi_mass_spring_damper()
    with pytest.raises(ValueError, match=rf"`{argument}` must have the shape \(1,\) or \(m, 1\)"):
        system.inverse_dynamics(**{argument: value})
    with pytest.raises(ValueError, match=r"as many rows.*`q` has 2, `t` has 3"):
        system.inverse_dynamics([[1.0], [2.0]], t=[0.0, 1.0, 2.0])
    with pytest.raises(ValueError, match="not one of the speeds of the system: v0"):
        system.inverse_dynamics(a={"v1": 2.0})
    with pytest.raises(ValueError, match="`wrt`"):
        system.mass_matrix(wrt="accelerations")


def operations(system, name):
    (kernel,) = (kernel for key, kernel in system.model._kernels.items() if key[0] == name)
    return sum(kernel.program.operation_count["run"].values())


def test_forces_take_fewer_operations_than_accelerations():
    system = n_link_pendulum_on_cart(6)
    forward = sum(system.model.programs.of("rates").operation_count["run"].values())
    system.inverse_dynamics()
    assert operations(system, "inverse dynamics") <= 0.65 * forward


def test_forces_that_hold_weights_take_half_of_the_operations_of_those_that_move_masses():
    # Links on hinges at odd angles, where the axes that frames are given in suit no hinge.
    frame, point = inertial_frame()
    N, angles, bodies, loads = frame, me.dynamicsymbols("q:3"), [], []
    for k, angle in enumerate(angles):
        skew = frame.orientnew(f"S{k}", "Axis", (0.4 + k, frame.x + 2 * frame.y - frame.z))
        frame = skew.orientnew(f"B{k}", "Axis", (angle, skew.x + 0.3 * skew.y - 0.7 * skew.z))
        centre = point.locatenew(f"C{k}", 0.2 * frame.x - 0.1 * frame.y + 0.3 * frame.z)
        point = point.locatenew(f"P{k}", 0.5 * frame.x + 0.2 * frame.y - 0.4 * frame.z)
        inertia = me.inertia(frame, 1.0, 1.1, 1.2, 0.1, 0.2, 0.3)
        bodies.append(me.RigidBody(f"b{k}", centre, frame, 1.5, (inertia, centre)))
        loads.append((centre, -1.5 * 9.81 * N.z))
    system = System(Definition(N, angles, bodies=bodies, loads=loads))
    q = np.array([0.3, -0.8, 1.1])
    slopes = system.evaluate_gradient(system.potential_energy, [*q, 0.0, 0.0, 0.0])[:3]
    close(system.gravity(q), slopes, 1e-14)
    close(system.gravity(q), system.inverse_dynamics(q, np.zeros(3), np.zeros(3)), 1e-14)
    assert operations(system, "gravity") <= 0.5 * operations(system, "inverse dynamics")


@pytest.mark.parametrize("between", ["nothing", "energy", "potential", "parts", "SymPy"])
def test_positions_have_the_same_origin_whatever_was_called_before(between):
    """SymPy stores velocities that it derives: a support without one becomes a point at rest."""
    x, v = me.dynamicsymbols("x v")
    m, k, a, b = sm.symbols("m k a b")
    N, O = inertial_frame()
    support = O.locatenew("A", a * N.x)
    turned = N.orientnew("B", "Axis", (0.4, N.z))
    stand = support.locatenew("S", b * turned.y)
    end = stand.locatenew("P", x * turned.x)
    pull = k * x**3 * turned.x
    definition = Definition(
        N,
        [x],
        [v],
        bodies=[me.Particle("bob", end, m)],
        loads=[(end, -pull), (stand, pull)],
        frames={"end": (turned, end)},
    )
    system = System(definition, {m: 2.0, k: 3.0, a: 0.7, b: 0.2})
    if between == "energy":
        assert system.evaluate_energy([0.5, 0.0]).potential == pytest.approx(3.0 * 0.5**4 / 4)
    elif between == "potential":
        assert system.potential_energy.has(x)
    elif between == "parts":
        assert system.kinetic_energy == m * v**2 / 2
    elif between == "SymPy":
        assert stand.vel(N) == 0
        assert end.vel(N) == x.diff() * turned.x
    c, s = np.cos(0.4), np.sin(0.4)
    expected = [0.7 + 0.5 * c - 0.2 * s, 0.5 * s + 0.2 * c, 0.0]
    assert system.frame_position("end", [0.5]) == pytest.approx(expected, abs=1e-15)
