"""Systems whose equations of motion are formed from bodies and loads."""

import copy
import pickle

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from sympy.physics.mechanics import models as sympy_models

import zoo
from oracles.oracle import Oracle, oracle
from pydy.system import System
from zoo import T, by_hand, inertial_frame
from zoo.by_hand import MECHANISMS, derived, state
from zoo.cases import close, system_of, wide


def numbered(system, model):
    for name in ("constants", "specifieds"):
        own = getattr(system, f"{name}_symbols")
        setattr(system, name, {k: v for k, v in getattr(model, name).items() if k in own})
    return system


def graph_system(model, **options):
    """A System of the model's bodies, with its numbers for what occurs in the equations."""
    system = System(model.kane, equations="graph", noncontributing_forces=model.forces or None)
    numbered(system, model)
    system.initial_conditions = dict(model.start)
    for name, value in options.items():
        setattr(system, name, value)
    return system


def undone(name):
    """A mechanism on which `kanes_equations()` was not called."""
    return MECHANISMS[name].__wrapped__()


@pytest.mark.parametrize("name", MECHANISMS)
def test_a_method_without_equations_is_formed_from_its_bodies(name):
    model = undone(name)
    system = numbered(System(model.kane), model)
    x, t = state(model, 5)
    found = system.evaluate_ode(x, t)
    assert model.kane._fr is None
    close(found, Oracle(derived(model)).xdot(x, t), 1e-12)


@pytest.mark.parametrize("name", ["pendulum", "disc_contact", "skate", "shaken", "added_mass"])
@pytest.mark.parametrize("generator", ["llvm", "lambdify"])
def test_every_generator_gives_the_numbers_of_sympys_equations(name, generator):
    model = zoo.MODELS[name]()
    system = graph_system(model)
    system.generate_ode_function(generator=generator)
    x, t = model.sample(4)
    found = system.evaluate_ode(wide(system, x), t)
    close(found[: len(x)], oracle(model).xdot(x, t), 1e-12)
    if model.forces:
        close(found[len(x) :], oracle(model).forces(x, t), 1e-12)


@pytest.mark.parametrize("name", zoo.MODELS)
def test_the_symbols_are_those_of_sympys_equations(name):
    model = zoo.MODELS[name]()
    formed, method = System(model.kane, equations="graph"), System(model.kane)
    assert formed.constants_symbols == method.constants_symbols
    assert formed.specifieds_symbols == method.specifieds_symbols


@pytest.mark.parametrize(
    "how", [{"constraints": "project"}, {"constraints": "baumgarte", "gain": 20.0}]
)
@pytest.mark.parametrize("name", ["disc", "fourbar"])
def test_constraints_are_held(name, how):
    model = zoo.MODELS[name]()
    results = []
    for system in (graph_system(model), system_of(model)):
        system.ode_solver = "dop853"
        system.times = np.linspace(0.0, 0.5, 6)
        results.append(system.integrate(**how))
    close(results[0], results[1], 1e-7)


@pytest.mark.parametrize("name", ["pendulum", "disc", "skate"])
def test_a_solver_of_the_users_gets_the_mass_matrix(name):
    model = zoo.MODELS[name]()
    seen = []

    def solver(a, b):
        seen.append(np.array(a))
        return np.linalg.solve(a, b)

    system = graph_system(model)
    system.generate_ode_function(linear_sys_solver=solver)
    x, t = model.sample(2)
    found = system.evaluate_ode(wide(system, x), t)[: len(x)]
    close(found, oracle(model).xdot(x, t), 1e-12)
    n = len(model.kane.u)
    expected = oracle(model).evaluate(model.kane.mass_matrix, x, t)
    close(seen[0], expected.reshape(n, n), 1e-12)


def test_outputs_linear_in_the_accelerations_are_solved_with_them():
    model = zoo.free_pendulum()
    u, a, b = model.kane.u, sm.Symbol("a"), sm.Symbol("b")
    outputs = {a: a - 2 * u[0].diff(T), b: u[1].diff(T) + sm.sin(model.kane.q[0])}
    system = graph_system(model, outputs=outputs)
    x, t = model.sample(1)
    rates = oracle(model).xdot(x, t)
    n = len(model.kane.q)
    close(system.evaluate_ode([*x, 0.3], t), [*rates, 2 * rates[n]], 1e-12)
    close(system.evaluate_outputs([*x, 0.3], t), [2 * rates[n], rates[n + 1] + np.sin(x[0])], 1e-12)


@pytest.mark.parametrize("way", [copy.deepcopy, lambda s: pickle.loads(pickle.dumps(s))])
@pytest.mark.parametrize("name", ["pendulum", "disc_contact"])
def test_a_formed_system_survives_a_copy(name, way):
    model = zoo.MODELS[name]()
    system = graph_system(model, times=[0.0, 0.1])
    x, t = model.sample()
    expected = system.evaluate_ode(wide(system, x), t)
    twin = way(system)
    close(twin.evaluate_ode(wide(twin, x), t), expected, 1e-14)
    close(twin.integrate(), system.integrate(), 1e-14)


def test_an_indefinite_mass_matrix_is_solved_by_pivoting():
    model = zoo.free_pendulum()
    numbers = {**model.constants, sm.Symbol("m1"): -0.2, sm.Symbol("m3"): -0.1}
    system = graph_system(model, constants=numbers)
    x, t = model.sample(3)
    close(system.evaluate_ode(x, t), oracle(model).xdot(x, t, numbers), 1e-10)


def test_coinciding_hinges_are_singular():
    q, u = list(me.dynamicsymbols("q1:4")), list(me.dynamicsymbols("u1:4"))
    frame, point = inertial_frame()
    inner, turned, outer = (me.ReferenceFrame(name) for name in "ABC")
    for f, base, axis, k in (
        (inner, frame, "z", 0),
        (turned, inner, "x", 1),
        (outer, turned, "z", 2),
    ):
        f.orient_axis(base, getattr(base, axis), q[k])
        f.set_ang_vel(base, u[k] * getattr(base, axis))
    body = me.RigidBody("b", point, outer, 1, (me.inertia(outer, *sm.symbols("I1:7")), point))
    kd = [a.diff(T) - b for a, b in zip(q, u, strict=True)]
    kane = me.KanesMethod(frame, q, u, kd_eqs=kd, bodies=[body])
    system = System(kane)
    numbers = [2.1, 1.9, 2.5, 0.2, -0.3, 0.1]
    system.constants = dict(zip(sm.symbols("I1:7"), numbers, strict=True))
    assert np.isfinite(system.evaluate_ode([0.3, 0.4, 0.5, 1.0, 2.0, 3.0])).all()
    # Gimbal lock: the first and the last axis coincide.
    with pytest.raises(np.linalg.LinAlgError, match="singular"):
        system.evaluate_ode([0.3, 0.0, 0.5, 1.0, 2.0, 3.0])


def test_the_method_is_taken_only_where_it_has_equations():
    model = undone("gimbals")
    with pytest.raises(ValueError, match=r"equations='method'.*kanes_equations\(bodies, loads\)"):
        System(model.kane, equations="method")


def test_a_method_with_neither_equations_nor_bodies_names_both_remedies():
    q, u = me.dynamicsymbols("q u")
    kane = me.KanesMethod(me.ReferenceFrame("N"), [q], [u], kd_eqs=[q.diff(T) - u])
    for way in (None, "graph"):
        with pytest.raises(ValueError, match=r"`bodies=` and `forcelist=`.*kanes_equations"):
            System(kane, equations=way)


def test_another_source_of_equations_is_refused():
    with pytest.raises(
        ValueError, match="`equations` must be one of 'graph', 'method', got 'lagrange'"
    ):
        System(zoo.bare().kane, equations="lagrange")


def test_a_symbolic_solver_takes_the_matrices_of_the_method():
    model = zoo.timed()
    system = graph_system(model)
    system.generate_ode_function(linear_sys_solver="sympy")
    x, t = model.sample(3)
    close(system.evaluate_ode(x, t), oracle(model).xdot(x, t), 1e-12)


def test_a_symbolic_solver_names_the_remedy():
    system = System(undone("camera").kane)
    with pytest.raises(NotImplementedError, match=r"Call `kanes_equations\(\)`"):
        system.generate_ode_function(linear_sys_solver="sympy")


def test_a_symbol_left_out_by_the_user_is_named():
    model = zoo.timed()
    system = System(
        model.kane, equations="graph", constants_symbols=[sm.Symbol("m")], specifieds_symbols=[]
    )
    with pytest.raises(ValueError, match="no argument provides it"):
        system.evaluate_ode([0.1, 0.2], 0.0)


def test_accelerations_may_not_occur_squared_in_loads():
    with pytest.raises(
        ValueError, match=r"nonlinear .* in the term .*Derivative\(v\(t\), t\)\*\*2"
    ):
        System(zoo.squared_acceleration().kane, equations="graph")


def test_a_scene_is_drawn_from_the_same_bodies(tmp_path):
    model = by_hand.gimbals.__wrapped__()
    system = System(model.kane, times=np.linspace(0.0, 0.2, 5))
    scene = system.scene()
    scene.animate(system.times, np.full((5, 6), 0.2))
    scene.to_html(tmp_path / "page.html")
    assert (tmp_path / "page.html").stat().st_size > 1000


@pytest.mark.parametrize(("name", "most"), [("satellite", 280)])
def test_speeds_in_body_axes_cost_no_more_operations_than_they_did(name, most):
    system = System(undone(name).kane)
    system.generate_ode_function()
    count = system.model.compiled("rates").program.operation_count["run"]
    assert sum(count.values()) <= most


def test_the_kinetic_energy_that_is_shown_is_an_expression_of_sympys():
    model = zoo.undamped_chain()
    shown = System(model.kane, equations="graph").kinetic_energy
    assert sm.simplify(shown - System(model.kane).kinetic_energy) == 0


def test_equations_that_were_derived_are_formed_again_where_that_is_shorter():
    kane = sympy_models.n_link_pendulum_on_cart(6)
    system, own = System(kane), System(kane, equations="method")
    assert system._equations.formed is not None
    assert own._equations.formed is None
    assert system.constants_symbols == own.constants_symbols
    counts = [
        sum(s.model.compiled("rates").program.operation_count["run"].values())
        for s in (system, own)
    ]
    assert counts[0] < counts[1]
    x = np.linspace(0.2, 0.9, 14)
    close(system.evaluate_ode(x), own.evaluate_ode(x), 1e-12)


CONSTRAINED = {
    name: {**zoo.MODELS, **MECHANISMS}[name]
    for name in ("disc", "disc_contact", "sleigh", "skate", "fourbar", "track", "lifted", "coupler")
}


@pytest.mark.parametrize("name", CONSTRAINED)
def test_constrained_equations_that_were_derived_are_formed_again_too(name):
    model = derived(CONSTRAINED[name]())
    system, own = (numbered(System(model.kane, equations=way), model) for way in (None, "method"))
    assert system._equations.formed is not None
    assert own._equations.formed is None
    assert system.constants_symbols == own.constants_symbols
    x, t = state(model, 3)
    expected = oracle(model).xdot(x, t)
    counts = []
    for s in (system, own):
        close(s.evaluate_ode(x, t), expected, 1e-12)
        counts.append(sum(s.model.compiled("rates").program.operation_count["run"].values()))
    assert counts[0] < counts[1]


def test_equations_that_were_derived_hold_where_the_bodies_give_others(caplog):
    kane = sympy_models.n_link_pendulum_on_cart(3)
    kane.bodies[1].mass = 2 * kane.bodies[1].mass
    with caplog.at_level("INFO", logger="pydy"):
        system = System(kane)
    assert system._equations.formed is None
    assert "they give other numbers" in caplog.text
    assert System(kane, equations="graph")._equations.formed is not None


def test_why_the_equations_of_the_method_hold_is_logged_once(caplog):
    kane = sympy_models.n_link_pendulum_on_cart(2)
    kane.bodies[1].mass = 2 * kane.bodies[1].mass
    with caplog.at_level("INFO", logger="pydy"):
        System(kane)
        assert "they give other numbers" in caplog.text
        caplog.clear()
        System(kane)  # what was found out is kept
    assert not caplog.text


def test_a_method_that_is_derived_anew_is_looked_at_anew():
    kane = sympy_models.n_link_pendulum_on_cart(6)
    assert System(kane)._equations.formed is not None
    g, m6 = sm.symbols("g m6")
    kane.kanes_equations(kane.bodies, [(kane.bodies[6].masscenter, -3 * m6 * g * kane._inertial.y)])
    system = System(kane)
    x = np.linspace(0.2, 0.9, 14)
    close(system.evaluate_ode(x), System(kane, equations="method").evaluate_ode(x), 1e-12)


@pytest.mark.parametrize("change", ["written over", "of a subclass"])
def test_equations_that_the_user_changed_after_deriving_them_hold(change):
    model = derived(CONSTRAINED["track"].__wrapped__())
    kane = model.kane
    assert System(kane)._equations.formed is not None
    if change == "written over":
        kane._k_d = 2 * kane._k_d
    else:
        heavier = property(lambda self: sm.diag(3, 2, 1) * me.KanesMethod.mass_matrix.fget(self))
        kane.__class__ = type("Heavier", (me.KanesMethod,), {"mass_matrix": heavier})
    system, own = (numbered(System(kane, equations=way), model) for way in (None, "method"))
    assert system._equations.formed is None
    x, t = state(model, 3)
    close(system.evaluate_ode(x, t), own.evaluate_ode(x, t), 1e-15)


def nearly_dependent(free, dependent=1):
    """Particles in a row whose last ones constraints give, less and less as e vanishes."""
    n = free + dependent
    q, u, e = me.dynamicsymbols(f"q:{n}"), me.dynamicsymbols(f"u:{n}"), sm.Symbol("e")
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    bodies, loads = [], []
    for k in range(n):
        place = origin.locatenew(f"P{k}", q[k] * frame.x + q[k - 1] * frame.y)
        place.set_vel(frame, u[k] * frame.x + u[k - 1] * frame.y)
        bodies.append(me.Particle(f"b{k}", place, 1 + sm.Rational(k, 3)))
        loads.append((place, -q[k] * frame.x + sm.sin(q[k]) * frame.y))
    rows = []
    for j in range(dependent):
        given = [
            (i > 0) * (2 + i) + e * sm.Rational((j + 1) ** (i + 1), 3) for i in range(dependent)
        ]
        row = sum((k + 1) * sm.cos(q[k] + j) * u[k] for k in range(free))
        rows.append(row + sum(c * w for c, w in zip(given, u[free:], strict=True)))
    kane = me.KanesMethod(
        frame, q, u[:free],
        kd_eqs=[a.diff(T) - b for a, b in zip(q, u, strict=True)],
        u_dependent=u[free:], velocity_constraints=rows,
    )  # fmt: skip
    kane.kanes_equations(bodies, loads)
    return kane, e, rows


def at_rest_with_the_constraints(kane, rows, numbers):
    """A state whose dependent speeds are those of the constraints."""
    n, dependent = len(kane.u), len(rows)
    x = np.linspace(0.3, 0.9, 2 * n)
    numbers = {**numbers, **dict(zip(kane.q, map(sm.Float, x), strict=False))}
    matrix = np.array(sm.Matrix(rows).jacobian(kane.u).xreplace(numbers).evalf(), dtype=float)
    free = n - dependent
    x[n + free :] = np.linalg.solve(matrix[:, free:], -matrix[:, :free] @ x[n : n + free])
    return x


def exactly(kane, numbers, x):
    """u' of the method's equations, with sixty digits."""
    states = dict(zip((*kane.q, *kane.u), map(sm.Rational, map(float, x)), strict=True))
    rates = {q.diff(T): states[u] for q, u in zip(kane.q, kane.u, strict=True)}
    values = {**states, **{k: sm.Rational(v) for k, v in numbers.items()}}
    matrix, forcing = (
        m.xreplace(rates).xreplace(values).evalf(60) for m in (kane.mass_matrix, kane.forcing)
    )
    return np.array(matrix.LUsolve(forcing), dtype=float).ravel()


@pytest.mark.parametrize(("free", "dependent"), [(1, 1), (2, 1), (3, 1), (1, 2), (2, 2), (2, 3)])
@pytest.mark.parametrize("size", [1.0, 1e-2, 1e-4, 1e-6, 1e-8])
def test_dependent_speeds_that_hardly_follow_from_the_constraint_cost_no_accuracy(
    free, dependent, size
):
    kane, e, rows = nearly_dependent(free, dependent)
    x = at_rest_with_the_constraints(kane, rows, {e: sm.Float(size)})
    expected = exactly(kane, {e: size}, x)
    system = System(kane, {e: size}, equations="graph")
    for generator in ("llvm", "lambdify"):
        system.generate_ode_function(generator=generator)
        found = system.evaluate_ode(x)[free + dependent :]
        atol = (1e-12 if dependent < 3 else 1e-11) * np.abs(expected).max()
        np.testing.assert_allclose(found, expected, rtol=0, atol=atol)


@pytest.mark.parametrize(("free", "dependent"), [(1, 3), (2, 4), (3, 4)])
@pytest.mark.parametrize("size", [1e-2, 1e-3, 1e-4, 1e-5, 1e-6])
def test_constraints_that_are_nearly_parallel_lose_only_the_digits_that_they_share(
    free, dependent, size
):
    kane, e, rows = nearly_dependent(free, dependent)
    x = at_rest_with_the_constraints(kane, rows, {e: sm.Float(size)})
    expected = exactly(kane, {e: size}, x)
    found = System(kane, {e: size}, equations="graph").evaluate_ode(x)[free + dependent :]
    atol = (2e-12 + 1e-15 / size) * np.abs(expected).max()
    np.testing.assert_allclose(found, expected, rtol=0, atol=atol)


def test_more_speeds_than_are_eliminated_one_by_one_keep_their_accuracy():
    kane, e, rows = nearly_dependent(13)
    x = at_rest_with_the_constraints(kane, rows, {e: sm.Float(1e-5)})
    expected = exactly(kane, {e: 1e-5}, x)
    found = System(kane, {e: 1e-5}, equations="graph").evaluate_ode(x)[14:]
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12 * np.abs(expected).max())
