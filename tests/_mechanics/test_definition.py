"""Equations from a plain definition, against those of the KanesMethod with the same content."""

import pickle

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.errors import SingularMatrixError
from pydy.mechanics import Definition
from pydy.system import System
from zoo import inertial_frame
from zoo.by_hand import MECHANISMS
from zoo.cases import close

T = me.dynamicsymbols._t
x, y, vx, vy = me.dynamicsymbols("x y vx vy")
MODELS = {**zoo.MODELS, **MECHANISMS}
del MODELS["given_accelerations"]  # a Definition takes those of its velocity constraints


def content(kane):
    """What a Definition takes of a KanesMethod, without its choice of what depends on what."""
    return {
        "frame": kane._inertial,
        "coordinates": list(kane.q),
        "speeds": list(kane.u),
        "bodies": kane.bodies,
        "loads": kane.loads or (),
        "kinematic_equations": [a - b for a, b in kane.kindiffdict().items()],
        "holonomic_constraints": list(kane._f_h),
        "velocity_constraints": list(kane._k_nh * kane.u + kane._f_nh) if kane._k_nh else None,
        "auxiliary_speeds": list(kane._uaux),
    }


def rates(system, model, seed=1):
    """The derivatives of the states by name, at a state that is consistent for none."""
    x, t = model.sample(seed)
    x = dict(zip(model.states, x, strict=True))
    p = {s: model.constants[s] for s in system.constants_symbols}
    r = {s: model.specifieds[s] for s in system.specifieds_symbols}
    found = system.evaluate_ode([x[s] for s in system.states], t, r=r or None, p=p)
    return np.array([dict(zip(system.states, found, strict=True))[s] for s in model.states])


@pytest.mark.parametrize("name", MODELS)
def test_the_equations_are_those_of_kanes_method(name):
    model = MODELS[name]()
    definition = Definition(
        **content(model.kane),
        dependent_coordinates=list(model.kane._qdep) or None,
        dependent_speeds=list(model.kane._udep) or None,
    )
    found = rates(System(definition), model)
    close(found, rates(System(model.kane, equations="graph"), model), 1e-12)


@pytest.mark.parametrize("name", ["fourbar", "track", "lifted", "disc", "satellite"])
def test_what_depends_is_chosen(name):
    model = MODELS[name]()
    system = System(Definition(**content(model.kane)))
    system.constants = {s: model.constants[s] for s in system.constants_symbols}
    free = set(system.speeds) - set(system._equations.dependents.speeds)
    assert len(free) == len(model.kane.u) - len(model.kane._udep)
    system.initial_conditions = {s: v for s, v in model.start.items() if s in system.states}
    other = System(model.kane, system.constants)
    x = [model.start.get(s, 0.0) for s in system.states]
    found = dict(zip(system.states, system.evaluate_ode(x), strict=True))
    expected = other.evaluate_ode([model.start.get(s, 0.0) for s in other.states])
    close([found[s] for s in other.states], expected, 1e-10)


def bead(**options):
    """A bead on a parabola, in the plane."""
    m, g = sm.symbols("m g")
    frame, origin, end = me.ReferenceFrame("N"), me.Point("O"), me.Point("P")
    origin.set_vel(frame, 0)
    end.set_pos(origin, x * frame.x + y * frame.y)
    options = {"holonomic_constraints": [y - x**2], "coordinates": [x, y], "speeds": [vx, vy]} | (
        options
    )
    bodies = [me.Particle("bead", end, m)]
    return Definition(frame, bodies=bodies, loads=[(end, -m * g * frame.y)], **options)


def test_what_depends_is_preferably_what_a_constraint_is_linear_in():
    # By x the surface could not be solved where it is level, nor when the cosine vanishes.
    made = bead(holonomic_constraints=[y - x**2 * sm.cos(sm.Symbol("w") * T)])
    assert made.multibody.dependents.coordinates == (y,)
    made = bead(holonomic_constraints=[x - y**2 * sm.cos(sm.Symbol("w") * T)])
    assert made.multibody.dependents.coordinates == (x,)
    assert made.multibody.dependents.speeds == (vx,)
    assert System(made).states == [x, y, vx, vy]  # which stay where the user put them


def test_redundant_constraints_do_no_harm():
    single = System(bead())
    double = System(bead(holonomic_constraints=[y - x**2, 3 * x**2 - 3 * y]))
    assert double.states == single.states
    close(double.evaluate_ode([0.3, 0.09, 1.0, 0.6]), single.evaluate_ode([0.3, 0.09, 1.0, 0.6]))


def test_a_row_without_coordinates_that_is_zero_constrains_nothing():
    m, w = sm.symbols("m w")
    rows = [m - m, sm.Float(0.0), sm.sin(w) ** 2 + sm.cos(w) ** 2 - 1, y - x**2]
    at = {x: 0.3, y: 0.09, vx: 1.0, vy: 0.6}
    single = System(bead(), initial_conditions=at)
    for more in ({"holonomic_constraints": rows}, {"nonholonomic_constraints": [0, *rows[:3]]}):
        made = System(bead(**more), initial_conditions=at, times=[0.0, 0.1])
        assert made.states == single.states
        assert made.num_constraints == 1
        close(made.evaluate_ode(), single.evaluate_ode())
        made.integrate()


def test_a_row_of_constants_that_does_not_hold_is_told():
    made = System(bead(holonomic_constraints=[y - x**2, sm.Symbol("l") - 2]), times=[0.0, 0.1])
    with pytest.raises(ValueError, match="l - 2, which depends on constants alone: it is -1"):
        made.integrate()
    made.constants = {"l": 2.0}
    made.integrate()


@pytest.mark.parametrize("configuration", [{}, {x: 0.3, y: 0.09}])
def test_a_row_of_roundings_constrains_nothing(configuration):
    # What SymPy leaves of a gap along the axis of a linkage in an oblique plane.
    noise = 5.4e-20 * sm.sin(x) + 2.7e-19 * sm.cos(y) - 8.5e-19
    rows = [noise, 0.7 * (y - x**2), noise * 0.3 + 1e-19 * sm.sin(y)]
    made = System(bead(holonomic_constraints=rows, configuration=configuration))
    at = {x: 0.3, y: 0.09, vx: 1.0, vy: 0.6}
    made.initial_conditions, made.times = at, [0.0, 0.1]
    single = System(bead(), initial_conditions=at)
    assert made.states == single.states
    close(made.evaluate_ode(), single.evaluate_ode())
    close(made.linearize({}).A, single.linearize({}).A)
    made.integrate()
    made.ode_solver = "dop853"
    made.integrate(constraints="baumgarte", gain=3.0)
    made.integrate(constraints="project")


@pytest.mark.parametrize("metre", [1e-9, 1.0, 1e6])
def test_a_row_of_roundings_that_has_a_root_locks_nothing(metre):
    noise = 1e-17 * metre * (sm.cos(x) - sm.Float(0.9))
    made = bead(holonomic_constraints=[noise, y - metre * sm.sin(x)])
    constraints = made.multibody.constraints
    assert len(constraints.holonomic) == len(constraints.velocity) == 1
    alone = bead(holonomic_constraints=[1e-17 * (sm.cos(x) - sm.Float(0.9))])
    assert len(alone.multibody.constraints.holonomic) == 1


def across(angle, other):
    """A hinge's axis in a body that turned about one parallel to it, along what is across both."""
    frame = me.ReferenceFrame("F")
    axis, way = 0.16 * frame.x + 0.32 * frame.y - 0.87 * frame.z, -0.87 * frame.y - 0.32 * frame.z
    first = frame.orientnew("first", "Axis", (angle, axis.normalize()))
    second = frame.orientnew("second", "Axis", (other, axis.normalize()))
    return way.express(first).dot(second.x * 0.16 + second.y * 0.32 - second.z * 0.87).evalf()


@pytest.mark.parametrize("metre", [1e-9, 1.0, 1e9])
def test_a_row_of_terms_that_cancel_constrains_nothing(metre):
    row = across(x, y)
    assert {x, y} <= row.atoms(sm.Function)
    for rows in ([row, y - metre * sm.sin(x)], [metre * row, y - sm.sin(x), 3 * row]):
        made = bead(holonomic_constraints=rows)
        constraints = made.multibody.constraints
        assert len(constraints.holonomic) == len(constraints.velocity) == 1
        assert not constraints.redundant.velocity
    alone = bead(holonomic_constraints=[row])
    assert not alone.multibody.constraints.holonomic


def test_a_row_of_large_terms_is_kept():
    far = sm.Float(1e15)
    made = bead(holonomic_constraints=[sm.sqrt((far + y) ** 2 + x**2) - far])
    assert len(made.multibody.constraints.holonomic) == 1


def test_speeds_keep_constraints_of_different_units():
    rows = {"holonomic_constraints": [1e-17 * (y - x**2)], "nonholonomic_constraints": [vx - 1]}
    assert len(bead(**rows).multibody.constraints.velocity) == 2


def test_constraints_of_different_units_are_stabilised_alike():
    frame, origin, end = me.ReferenceFrame("N"), me.Point("O"), me.Point("P")
    origin.set_vel(frame, 0)
    z, vz = me.dynamicsymbols("z vz")
    end.set_pos(origin, x * frame.x + y * frame.y + z * frame.z)
    found = []
    for unit in (1.0, 1e-13):
        rows = [y - x**2, unit * (z - sm.sin(x))]
        body, forces = me.Particle("bead", end, 1), [(end, -9.81 * frame.y)]
        made = Definition(
            frame, [x, y, z], [vx, vy, vz], bodies=[body], loads=forces, holonomic_constraints=rows
        )
        system = System(made, times=np.linspace(0.0, 0.5, 3), ode_solver="dop853")
        system.initial_conditions = {x: 0.3, y: 0.091, z: 0.29, vx: 0.1, vy: 0.06, vz: 0.095}
        options = {"constraints": "baumgarte", "gain": 4.0, "rtol": 1e-10, "atol": 1e-10}
        found.append(system.integrate(**options)[:, [system.states.index(s) for s in (x, y, z)]])
    close(found[1], found[0], 1e-7)
    assert abs(found[0][-1, 2] - np.sin(found[0][-1, 0])) < 0.005


def test_the_derivatives_of_the_coordinates_are_the_speeds_by_default():
    system = System(bead(speeds=None, dependent_coordinates=[y], dependent_speeds=[y.diff(T)]))
    assert system.speeds == [x.diff(T), y.diff(T)]
    other = System(bead(dependent_coordinates=[y], dependent_speeds=[vy]))
    at = [0.3, 0.09, 1.0, 0.6]
    close(system.evaluate_ode(at), other.evaluate_ode(at))
    assert other.speeds == [vx, vy]


def test_a_definition_can_be_pickled_with_its_system():
    system = pickle.loads(pickle.dumps(System(bead())))
    assert system.eom_method.bodies[0].name == "bead"
    assert np.isfinite(system.evaluate_ode([0.3, 0.09, 1.0, 0.6])).all()


def test_energy_is_found_and_kept():
    system = System(bead())
    system.initial_conditions = {x: 1.0, y: 1.0}
    system.times = np.linspace(0.0, 2.0, 21)
    system.ode_solver = "dop853"
    motion = system.simulate(rtol=1e-10, atol=1e-10, constraints="project")
    total = system.evaluate_energy(motion.states, motion.times).total
    assert np.ptp(total) < 1e-8


WRONG = {
    r"`nonholonomic_constraints\[1\]` must restrict speeds, got t.* by `holonomic_c": {
        "nonholonomic_constraints": [vx - vy, x**2 - 1 + T]
    },
    "contradict each other: .*holonomic constraint 1, `1`, is left at 1": {
        "holonomic_constraints": [y - x**2, sm.Integer(1)]
    },
    "contradict each other: .*velocity constraint 1, `1`, is left at 1": {
        "nonholonomic_constraints": [sm.Integer(1)]
    },
    r"`holonomic_constraints`.*got 'y'": {"holonomic_constraints": "y"},
    r"`coordinates` must hold functions of time.*got z": {"coordinates": [x, sm.Symbol("z")]},
    "must differ from each other, got x": {"coordinates": [x, x]},
    r"`kinematic_equations` are needed with 2 coordinates and 1": {"speeds": [vx]},
    "do not give Derivative": {"kinematic_equations": [x.diff(T) - vx]},
    "depend on each other": {"kinematic_equations": [x.diff(T) + y.diff(T) - vx] * 2},
    "must be linear": {"kinematic_equations": [x.diff(T) ** 2 - vx, y.diff(T) - vy]},
    "each coordinate's derivative once": {
        "kinematic_equations": [x.diff(T) - vx, x.diff(T) - vy, y.diff(T)]
    },
    r"contradict each other: .*holonomic constraint 0, `x.* - 1`, .*holonomic constraint 2, `x": {
        "holonomic_constraints": [x - 1, y - x**2, x - 2]
    },
    "contradict each other: .*velocity constraint": {"nonholonomic_constraints": [vx - 1, vx - 2]},
    r"velocity constraint 1, `vx.*`, is not linear in the speeds": {
        "nonholonomic_constraints": [vx * vy - 1]
    },
    r"holonomic constraint 0, `-?.*vx.*`, holds speeds or derivatives": {
        "holonomic_constraints": [x - vx]
    },
    "`holonomic_constraints` must hold expressions that are zero, got True": {
        "holonomic_constraints": [True]
    },
    "`nonholonomic_constraints` must hold expressions that are zero, got False": {
        "nonholonomic_constraints": [False]
    },
    "must have 1 coordinates": {"dependent_coordinates": [x, y]},
    r"do not give the speeds vx": {
        "holonomic_constraints": [],
        "nonholonomic_constraints": [vy - vx * 0],
        "dependent_speeds": [vx],
    },
    r"`dependent_speeds` must be some of the speeds, got x": {"dependent_speeds": [x]},
    "there are no constraints": {"holonomic_constraints": [], "dependent_speeds": [vx]},
}


@pytest.mark.parametrize("message", WRONG)
def test_what_does_not_fit_is_named(message):
    with pytest.raises((TypeError, ValueError), match=message):
        System(bead(**WRONG[message]))


def test_the_rates_of_a_quaternion_follow_from_its_angular_velocity_and_its_length():
    e, w = me.dynamicsymbols("e0:4"), me.dynamicsymbols("w1:4")
    frame, body, origin = me.ReferenceFrame("N"), me.ReferenceFrame("A"), me.Point("O")
    body.orient_quaternion(frame, e)
    origin.set_vel(frame, 0)
    top = me.RigidBody("top", origin, body, 1, (me.inertia(body, 1, 2, 3), origin))
    rows = [body.ang_vel_in(frame).dot(axis) - rate for axis, rate in zip(body, w, strict=True)]
    with pytest.raises(ValueError, match=r"quaternion, add e0\*e0' \+ e1\*e1' \+ e2\*e2' \+ e3"):
        System(Definition(frame, e, w, bodies=[top], kinematic_equations=rows))
    textbook = me.kinematic_equations(w, e, "quaternion")
    state = np.array([0.1, 0.7, -0.1, 0.7, 0.3, -0.2, 0.5])
    rates = [
        System(Definition(frame, e, w, bodies=[top], kinematic_equations=k)).evaluate_ode(state)
        for k in ([*rows, sum(s * s.diff() for s in e)], textbook)
    ]
    np.testing.assert_allclose(*rates, rtol=1e-14, atol=1e-15)


def test_other_arguments_are_checked():
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    with pytest.raises(TypeError, match=r"`frame` must be a ReferenceFrame"):
        Definition("N", [x], [vx], bodies=[me.Particle("p", point, 1)])
    with pytest.raises(ValueError, match=r"`bodies` must have at least one"):
        Definition(frame, [x], [vx], bodies=[])
    with pytest.raises(TypeError, match=r"`bodies` must hold Particle"):
        Definition(frame, [x], [vx], bodies=[point])
    with pytest.raises(ValueError, match=r"`equations='method'` needs a method object"):
        System(bead(), equations="method")


def swung(*more, loads=()):
    """A particle on a massless arm, and what may be wrong with it; `more` makes further bodies."""
    ground, arm, rest = me.ReferenceFrame("N"), me.ReferenceFrame("A"), me.Point("O")
    arm.orient_axis(ground, ground.z, x)
    rest.set_vel(ground, 0)
    end = rest.locatenew("P", 2 * arm.x)
    bodies = [me.Particle("bob", end, sm.Symbol("m")), *(make(ground, rest) for make in more)]
    return Definition(ground, [x, y], [vx, vy], bodies=bodies, loads=loads)


LOST = {
    "The point L, the mass centre of the body ball, has no velocity": (
        lambda ground, rest: me.Particle("ball", me.Point("L"), 1)
    ),
    "The frame B has no orientation in the inertial frame N": (
        lambda ground, rest: me.RigidBody("ball", rest, me.ReferenceFrame("B"), 1)
    ),
    "The frame C has no orientation": (
        lambda ground, rest: me.Particle("b", rest.locatenew("Q", me.ReferenceFrame("C").x), 1)
    ),
}


@pytest.mark.parametrize("message", LOST)
def test_a_body_that_hangs_on_nothing_is_named(message):
    with pytest.raises(ValueError, match=message):
        System(swung(LOST[message]))


def test_a_load_at_a_point_that_nothing_places_is_named():
    with pytest.raises(ValueError, match="The point L, which a load acts at, has no velocity"):
        System(swung(loads=[(me.Point("L"), me.ReferenceFrame("N").x)]))


def test_a_definition_without_speeds_is_named():
    frame, origin = inertial_frame()
    still = Definition(frame, [], bodies=[me.Particle("p", origin, 1)])
    with pytest.raises(ValueError, match="has no speeds: nothing in it can move"):
        System(still)


def test_a_speed_that_moves_nothing_is_named():
    with pytest.raises(ValueError, match=r"The speed `vy\(t\)` moves no mass and no inertia"):
        System(swung())


def turned(order, angles):
    """A particle on an arm that turns about three axes, of which two are enough."""
    turns = list(me.dynamicsymbols("w1:4"))
    ground, arm, rest = me.ReferenceFrame("N"), me.ReferenceFrame("A"), me.Point("O")
    arm.orient_body_fixed(ground, angles, order)
    rest.set_vel(ground, 0)
    end = rest.locatenew("P", arm.x)
    inertia = me.inertia(arm, 1, 2, 3) if order == "xyz" else me.inertia(arm, 0, 0, 0)
    body = me.RigidBody("b", end, arm, sm.Symbol("m"), (inertia, end))
    return System(Definition(ground, angles, turns, bodies=[body]))


def test_speeds_that_move_nothing_together_are_named():
    system = turned("zyz", list(me.dynamicsymbols("a1:4")))
    with pytest.raises(SingularMatrixError, match=r"in every configuration: .*Give the bodies"):
        system.evaluate_ode([0.1, 0.2, 0.3, 0.0, 0.0, 0.0])


def test_gimbal_lock_of_the_mass_matrix_is_told_from_a_mechanism_without_inertia():
    system = turned("xyz", list(me.dynamicsymbols("a1:4")))
    with pytest.raises(SingularMatrixError, match=r"in this configuration: w1\(t\), w3\(t\) can"):
        system.evaluate_ode([0.1, np.pi / 2, 0.3, 0.0, 0.0, 0.0])
    assert np.isfinite(system.evaluate_ode([0.1, 0.2, 0.3, 0.0, 0.0, 0.0])).all()


def wrapped(function):
    """A bead on a curve in the plane, as one particle on a place and as a constrained one."""
    N, O = inertial_frame()
    free = O.locatenew("P", x * N.x + y * N.y)
    bound = O.locatenew("P", x * N.x + function * N.y)
    pull = 3 * N.x - 2 * N.y
    constrained = Definition(
        N,
        [x, y],
        [vx, vy],
        bodies=[me.Particle("bead", free, 2)],
        loads=[(free, pull)],
        holonomic_constraints=[y - function],
        dependent_coordinates=[y],
        dependent_speeds=[vy],
    )
    placed = me.Particle("bead", bound, 2)
    bound.vel(N)  # SymPy's derivative of the place
    return constrained, Definition(N, [x], [vx], bodies=[placed], loads=[(bound, pull)])


@pytest.mark.parametrize(
    "function",
    [
        sm.sin(sm.Mod(x + sm.pi, 2 * sm.pi) - sm.pi),
        sm.Piecewise((sm.cos(sm.Mod(x, sm.pi / 3)), sm.Mod(x, sm.pi) < 2), (1, True)),
        sm.floor(x) + sm.frac(x) ** 2,
        sm.Abs(x) ** 3,
    ],
    ids=str,
)
def test_places_may_hold_functions_that_sympy_cannot_differentiate(function):
    smooth = {
        sm.Mod(x + sm.pi, 2 * sm.pi): x + sm.pi - 2 * sm.pi,
        sm.Mod(x, sm.pi / 3): x - sm.pi,
        sm.Mod(x, sm.pi): x - sm.pi,
        sm.floor(x): 3,
        sm.frac(x): x - 3,
        sm.Abs(x): x,
    }
    at, rate = 3.7, 0.6
    f = function.subs(smooth)
    s0, s1, s2 = (float(f.diff(x, n).subs(x, at)) for n in range(3))
    acceleration = ((3 - 2 * s1) / 2 - s1 * s2 * rate**2) / (1 + s1**2)
    constrained, placed = map(System, wrapped(function))
    found = placed.evaluate_ode([at, rate])
    assert found == pytest.approx([rate, acceleration], rel=1e-12)
    rows = acceleration, s2 * rate**2 + s1 * acceleration
    state = {x: at, y: s0, vx: rate, vy: s1 * rate}
    found = constrained.evaluate_ode([state[s] for s in constrained.states])
    assert found == pytest.approx([rate, s1 * rate, *rows], rel=1e-12)
    placed.potential_energy = 0  # where a place jumps, that of its load is refused
    energy = placed.evaluate_energy([at, rate])
    assert energy.kinetic == pytest.approx(rate**2 * (1 + s1**2), rel=1e-12)


def test_constraints_are_differentiated_by_the_graph():
    # SymPy's derivative of |x| is x x' sign(x)/x where x is not known to be real: NaN at zero.
    constrained, _ = wrapped(sm.Abs(x) ** 3)
    system = System(constrained)
    state = {x: 0.0, y: 0.0, vx: 0.5, vy: 0.0}
    found = system.evaluate_ode([state[s] for s in system.states])
    assert found == pytest.approx([0.5, 0.0, 1.5, 0.0], rel=1e-12)
    curve = y - sm.sin(x) * x
    constrained, _ = wrapped(y - curve)
    (rate,) = constrained.velocity_constraints
    assert rate == curve.diff(T)


NAMES_OF_SYMPY = {
    "kd_eqs": "`kinematic_equations`", "kdes": "`kinematic_equations`", "q_ind": "`coordinates`",
    "q_dependent": "`dependent_coordinates`", "u_ind": "`speeds`",
    "u_dependent": "`dependent_speeds`", "u_auxiliary": "`auxiliary_speeds`",
    "forcelist": "`loads`",
    "configuration_constraints": "`holonomic_constraints`",
    "nonhol_coneqs": "`nonholonomic_constraints`",
}  # fmt: skip


@pytest.mark.parametrize("name", NAMES_OF_SYMPY)
def test_a_name_of_sympys_methods_is_refused_with_the_argument_that_is_meant(name):
    with pytest.raises(TypeError, match=f"no argument `{name}`: .*{NAMES_OF_SYMPY[name]}"):
        Definition(me.ReferenceFrame("N"), bodies=[], **{name: []})


def test_what_belongs_to_a_method_is_refused_by_a_system_with_the_remedy():
    with pytest.raises(TypeError, match="`forcelist`: it belongs to the method, pass a"):
        System(forcelist=[])
