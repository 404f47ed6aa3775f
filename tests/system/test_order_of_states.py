"""States come in the order in which the user gave coordinates and speeds, whatever is dependent.

The reference is the order with the dependent ones last, in which equations are formed.
"""

from itertools import permutations

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System, robots
from pydy.analysis import Trial
from pydy.contact import Contacts, Unilateral
from pydy.mechanics import Definition, Implicit
from pydy.trajectory import Trajectory
from zoo import T, inertial_frame
from zoo.cases import close
from zoo.joints import cart_pendulum
from zoo.loops import system_of as closed_loop

x, y, z = me.dynamicsymbols("x y z")
vx, vy, vz = me.dynamicsymbols("vx vy vz")
m, g, h, a, b = sm.symbols("m g h a b")
SPEED = {x: vx, y: vy, z: vz}
LAST, FIRST = (x, y, z), (z, y, x)  # where the dependent ones are
CONSTANTS = {m: 1.5, g: 10.0, h: 2.0, a: 0.5, b: 0.8}
START = {x: 0.6, y: -0.4, vx: 0.3, vy: 0.7}


def definition(order, speeds=None, push=0, **options):
    """A bead in a bowl z = a x² + b y², of which z and its rate are dependent, with side wind."""
    frame, origin = inertial_frame()
    end = origin.locatenew("P", x * frame.x + y * frame.y + z * frame.z)
    force = m * h * frame.x - m * g * frame.z + push * frame.x
    return Definition(
        frame,
        order,
        [SPEED[q] for q in order] if speeds is None else speeds,
        bodies=[me.Particle("bead", end, m)],
        loads=[(end, force)],
        holonomic_constraints=[z - a * x**2 - b * y**2],
        **options,
    )


def bowl(order):
    """The bead in motion, with the states in an order."""
    system = System(definition(order), dict(CONSTANTS), initial_conditions=START)
    system.times, system.ode_solver = np.linspace(0.0, 0.5, 6), "dop853"
    assert system.states == [*order, *(SPEED[q] for q in order)]
    system.set_dependent_initial_conditions()
    return system


def accelerations(at):
    """u' of the bead by Newton's law and the constraint twice differentiated."""
    slope = np.array([-2 * 0.5 * at[x], -2 * 0.8 * at[y], 1.0])
    pull = np.array([2.0, 0.0, -10.0])
    bend = -2 * 0.5 * at[vx] ** 2 - 2 * 0.8 * at[vy] ** 2
    found = pull - slope * (slope @ pull + bend) / (slope @ slope)
    return dict(zip((vx, vy, vz), found, strict=True))


@pytest.mark.parametrize("chosen", [True, False])
@pytest.mark.parametrize("order", list(permutations(LAST)))
def test_the_dependent_ones_may_stand_anywhere(order, chosen):
    own = {} if chosen else {"dependent_coordinates": [z], "dependent_speeds": [vz]}
    speeds = [SPEED[q] for q in (order[2], order[0], order[1])]  # speeds in an order of their own
    rates = [q.diff(T) - SPEED[q] for q in order]
    system = System(
        definition(order, speeds, kinematic_equations=rates, **own),
        CONSTANTS,
        initial_conditions=START,
    )
    assert system.states == [*order, *speeds]
    assert set(system._equations.dependents.speeds) == {vz}
    system.set_dependent_initial_conditions()
    at = dict(system.initial_conditions)
    found = dict(zip(system.states, system.evaluate_ode(), strict=True))
    assert at[z] == pytest.approx(0.5 * 0.36 + 0.8 * 0.16, rel=1e-12)
    expected = accelerations(at)
    close([found[u] for u in (vx, vy, vz)], [expected[u] for u in (vx, vy, vz)], 1e-12)
    close([found[q] for q in LAST], [at[SPEED[q]] for q in LAST], 1e-14)


def test_velocity_constraints_alone_leave_the_order():
    # A skate with its mass centre above the blade turns at a steady rate and slides down.
    theta, omega = me.dynamicsymbols("theta omega")
    speed = {x: vx, y: vy, theta: omega}
    for order in permutations(speed):
        frame, origin = inertial_frame()
        blade = frame.orientnew("B", "Axis", [theta, frame.z])
        centre = origin.locatenew("P", x * frame.x + y * frame.y)
        body = me.RigidBody("skate", centre, blade, m, (me.inertia(blade, 0, 0, h), centre))
        made = Definition(
            frame,
            order,
            [speed[q] for q in order],
            bodies=[body],
            loads=[(centre, -m * g * frame.y)],
            nonholonomic_constraints=[vy * sm.cos(theta) - vx * sm.sin(theta)],
        )
        system = System(made, {m: 1.5, g: 10.0, h: 0.3}, ode_solver="dop853", times=[0.0, 1.0])
        system.initial_conditions = {theta: 0.4, omega: 0.7, vx: 0.5}
        assert system.states == [*order, *(speed[q] for q in order)]
        system.set_dependent_initial_conditions()
        motion = system.simulate(**TIGHT)
        # v' = −g sin θ along the blade
        v = 0.5 / np.cos(0.4) + 10.0 / 0.7 * (np.cos(1.1) - np.cos(0.4))
        last = [motion[s][-1] for s in (theta, omega, vx, vy)]
        close(last, [1.1, 0.7, v * np.cos(1.1), v * np.sin(1.1)], 1e-9)


@pytest.mark.parametrize("named", [True, False])
def test_a_system_of_sympy_keeps_its_own_order(named):
    system = cart_pendulum(tied=True)
    if not named:  # SymPy's own order has what is named as dependent last
        q, u = system.q, system.u
        system.q_dep, system.u_dep = [], []
        system.q_ind, system.u_ind = q[::-1], u[::-1]
    made = System(system)
    assert made.states == [*system.q, *system.u]


def test_lagranges_method_keeps_its_own_order():
    for order in permutations(LAST):
        frame, origin = inertial_frame()
        end = origin.locatenew("P", x * frame.x + y * frame.y + z * frame.z)
        end.set_vel(frame, sum(q.diff(T) * axis for q, axis in zip(LAST, frame, strict=True)))
        bead = me.Particle("bead", end, m)
        bead.potential_energy = m * g * z - m * h * x
        method = me.LagrangesMethod(
            me.Lagrangian(frame, bead), order, hol_coneqs=[z - a * x**2 - b * y**2]
        )
        system = System(method, CONSTANTS)
        assert system.states == [*order, *(q.diff(T) for q in order)]
        at = {x: 0.6, y: -0.4, z: 0.308, vx: 0.3, vy: 0.7, vz: -0.268}
        given = [at[q] for q in order] + [at[SPEED[q]] for q in order]
        found = dict(zip(order, system.evaluate_ode(given)[3:], strict=True))
        expected = accelerations(at)
        close([found[q] for q in LAST], [expected[SPEED[q]] for q in LAST], 1e-12)


def test_a_coordinate_that_a_residual_gives_comes_after_those_of_the_definition():
    w = me.dynamicsymbols("w")
    system = System(
        definition(FIRST), CONSTANTS, implicit=Implicit({w: w + sm.sin(w) / 2 - x}),
        initial_conditions=START,
    )  # fmt: skip
    assert system.states == [z, y, x, w, vz, vy, vx]
    system.set_dependent_initial_conditions()
    at = system.initial_conditions
    rates = dict(zip(system.states, system.evaluate_ode(), strict=True))
    assert rates[w] == pytest.approx(at[vx] / (1 + np.cos(at[w]) / 2), rel=1e-12)
    assert rates[vz] == pytest.approx(accelerations(at)[vz], rel=1e-12)


ROBOT = """<mujoco><default><geom type="capsule" size="0.02"/></default><worldbody>
<body name="crank"><joint name="a" axis="0 1 0"/><geom fromto="0 0 0 0 0 0.3"/>
  <body name="coupler" pos="0 0 0.3"><joint name="b" axis="0 1 0"/>
  <geom fromto="0 0 0 1 0 0.2"/></body></body>
<body name="rocker" pos="1 0 0"><joint name="c" axis="0 1 0"/>
  <geom fromto="0 0 0 0 0 0.5"/></body>
</worldbody>
<equality><connect body1="coupler" body2="rocker" anchor="1 0 0.2"/></equality></mujoco>"""


def test_a_robot_with_a_loop_has_its_joints_in_the_order_of_the_file(tmp_path):
    pytest.importorskip("mujoco")
    (tmp_path / "robot.xml").write_text(ROBOT)
    robot = robots.read(tmp_path / "robot.xml")
    made = robot.system()
    assert [str(s.func) for s in made.states] == ["q_a", "q_b", "q_c", "u_a", "u_b", "u_c"]
    assert robot.definition.coordinates == tuple(made.coordinates)


def test_a_loop_without_dependent_speeds_keeps_its_order():
    system = closed_loop("parallelogram", [0.0, 0.3], "dop853")
    names = [s.func.__name__ for s in system.states]
    assert names == ["q1", "q2", "q3", "u1", "u2", "u3"]
    # A parallelogram of uniform rods turns as the crank does; the coupler keeps its direction.
    motion = system.simulate(**TIGHT)
    turned = motion["q1"] + motion["q2"]
    close(turned, [turned[0]] * 2, 1e-9)


# -- all answers, by names of states ---------------------------------------------------------------

TIGHT = {"rtol": 1e-11, "atol": 1e-12}
NAMES = ["x", "y", "z", "vx", "vy", "vz"]
ANSWERS = {}


def answer(function):
    ANSWERS[function.__name__] = function
    return function


def in_order(system, values):
    """The last axis, which is that of the states, in the order of the reference."""
    return np.asarray(values)[..., [system.states.index(s) for s in (x, y, z, vx, vy, vz)]]


def of_speeds(system, values):
    return np.asarray(values)[..., [system.speeds.index(u) for u in (vx, vy, vz)]]


def names_of(system):
    return [s.func.__name__ for s in system.states]


def matrix(system, values, order=in_order):
    return order(system, order(system, values).T)


@answer
def rates(system, folder):
    return in_order(system, system.evaluate_ode())


@answer
def generated(system, folder):
    rhs = system.generate_ode_function(generator="lambdify")
    start = np.array([system.initial_conditions[s] for s in system.states])
    constants = np.array([CONSTANTS[s] for s in system.constants_symbols])
    return in_order(system, rhs(start, 0.0, constants)[0])


@answer
def jacobian(system, folder):
    return matrix(system, system.evaluate_jacobian())


@answer
def residuals(system, folder):
    at = {x: 0.1, y: 0.2, z: 0.3, vx: 0.4, vy: 0.5, vz: 0.6}
    return system.evaluate_constraints([at[s] for s in system.states])


@answer
def projected(system, folder):
    return in_order(system, system.integrate(**TIGHT))


@answer
def not_projected(system, folder):
    return in_order(system, system.integrate(constraints=None, **TIGHT))


@answer
def stabilised(system, folder):
    return in_order(system, system.integrate(constraints="baumgarte", gain=5.0, **TIGHT))


@answer
def implicitly(system, folder):
    system.ode_solver = "radau"
    return in_order(system, system.integrate(**TIGHT))


@answer
def by_odeint(system, folder):
    system.ode_solver = "odeint"
    return in_order(system, system.integrate(**TIGHT))


@answer
def backwards(system, folder):
    system.times = system.times[::-1].copy()
    return in_order(system, system.integrate(**TIGHT))


@answer
def frame(system, folder):
    return system.simulate(**TIGHT).to_dataframe()[NAMES].to_numpy()


@answer
def saved(system, folder):
    system.simulate(**TIGHT).save(folder / "motion.nc")
    again = Trajectory.load(folder / "motion.nc")
    return [again[name] for name in NAMES]


@answer
def sensitivities(system, folder):
    found = system.simulate(sensitivities=[x, a], **TIGHT)
    return [found.sensitivity[name] for name in NAMES]


@answer
def adjoint(system, folder):
    found = system.adjoint_gradient([x, vx, a, m], final=x * z + vy**2, **TIGHT)
    return [*found.values, *in_order(system, found.by_state)]


@answer
def ensemble(system, folder):
    found = system.integrate_ensemble(constants={g: np.array([5.0, 12.0])}, **TIGHT)
    return [found[name].to_numpy() for name in NAMES]


REST = {x: 0.2, y: 0.0, z: 0.02, vx: 0.0, vy: 0.0, vz: 0.0}


@answer
def linear_model(system, folder):
    made = system.linearize(REST)
    assert made.states == tuple(n for n in names_of(system) if n in made.states)
    order = np.argsort(made.states)
    return made.A[np.ix_(order, order)]


@answer
def modes(system, folder):
    return np.sort(system.linearize(REST).eigenvalues.imag)


@answer
def equilibrium(system, folder):
    found = system.find_equilibrium()
    return in_order(system, found.state)


@answer
def periodic_orbit(system, folder):
    system.initial_conditions = {x: 0.3, z: 0.045}
    orbit = system.find_periodic_orbit(2.0)
    return [orbit.period, *np.sort(abs(orbit.multipliers))]


@answer
def multipliers(system, folder):
    system.outputs = {"force": system.constraint_forces["lambda0"]}
    return system.evaluate_outputs()


@answer
def reaction(system, folder):
    force = system.reaction("bead", system.eom_method.bodies[0].masscenter).force
    system.outputs = dict(zip("xyz", force.to_matrix(system.eom_method.frame), strict=True))
    return system.evaluate_outputs()


@answer
def inverse_dynamics(system, folder):
    return of_speeds(system, system.inverse_dynamics(a={vx: 0.3, vy: 0.5}))


@answer
def forces_at_independent_speeds(system, folder):
    rates = {vx: 0.3, vy: 0.5}
    own = [u for u in system.speeds if u in rates]
    found = system.inverse_dynamics(a=[rates[u] for u in own], at="independent")
    return [found[own.index(u)] for u in rates]


@answer
def masses(system, folder):
    return matrix(system, system.mass_matrix(), of_speeds)


@answer
def regressor(system, folder):
    return system.regressor(a={vx: 0.3, vy: 0.2, vz: 0.1})[
        [system.speeds.index(u) for u in (vx, vy, vz)]
    ]


@answer
def contacts(system, folder):
    system.initial_conditions = {x: 0.3, y: 0.1, vx: 1.0, vy: 0.2}
    system.set_dependent_initial_conditions()
    wall = Contacts(system, [Unilateral(sm.Rational(1, 2) - x, restitution=0.3, name="wall")])
    motion = wall.simulate(**TIGHT)
    assert motion["wall_normal"].max() >= 0.0
    return in_order(system, motion.states)


@answer
def python_code(system, folder):
    names = {}
    exec(system.export(folder / "model.py").path.read_text(), names)
    start = [system.initial_conditions[s] for s in system.states]
    return in_order(system, names["rates"](0.0, start))


@answer
def casadi_code(system, folder):
    pytest.importorskip("casadi")
    names = {}
    exec(system.export(folder / "model.py", target="casadi").path.read_text(), names)
    start = [system.initial_conditions[s] for s in system.states]
    found = names["rates"](0.0, start, [], [*names["CONSTANTS"].values()])
    return in_order(system, np.array(found)[:, 0])


@answer
def optimal_control(system, folder):
    F = me.dynamicsymbols("F")
    system = System(definition(tuple(system.coordinates), push=F), dict(CONSTANTS))
    moved = system.optimize_trajectory(
        sm.Integral(F**2, T),
        0.5,
        start=dict.fromkeys(system.states, 0.0),
        end={x: 0.2},
        mesh=4,
        method="hermite-simpson",  # which holds the constraints' rows of M u' = F at its nodes
    )
    return [moved.objective, *in_order(system, moved.states[-1])]


@answer
def poses(system, folder):
    system.simulate()
    return system.animate().poses


@answer
def fit(system, folder):
    motion = bowl(LAST).simulate(**TIGHT)
    trial = Trial(motion.times, {z: motion["z"], x: motion["x"]})
    system.constants[a] = 0.45
    return system.fit([a], trial).estimates


@pytest.mark.parametrize("name", ANSWERS)
def test_every_answer_is_the_same_where_dependent_states_come_first(name, tmp_path):
    expected, found = (
        np.asarray(ANSWERS[name](bowl(order), tmp_path), dtype=float) for order in (LAST, FIRST)
    )
    assert np.isfinite(expected).all()
    assert abs(expected).max() > 0.0
    np.testing.assert_allclose(found, expected, rtol=1e-7, atol=1e-8 * abs(expected).max())
