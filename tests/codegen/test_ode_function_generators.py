"""generate_ode_function on its own: forms, generators, kinds of arguments, refusals."""

import inspect

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from oracles.oracle import oracle
from pydy.codegen.ode_function_generators import generate_ode_function
from zoo.cases import arrays, close, given

T = zoo.T
GENERATORS = ["llvm", "lambdify"]
X, V = me.dynamicsymbols("x v")
M, K = sm.symbols("m k")

# Forms [2] and [3]; models whose forcing holds no accelerations and no auxiliary speeds.
ANY = ["chain", "pendulum", "free_pendulum", "free_body", "disc", "sleigh", "fourbar", "timed"]
ANY += ["shaken", "bare", "track", "gyro", "lifted"]
# Form [1] needs the symbolic solution.
SMALL = ["undamped_chain", "pendulum", "sleigh", "timed", "shaken", "bare", "gyro", "lifted"]


CASES = [("[1]", n) for n in SMALL] + [(f, n) for f in ("[2]", "[3]") for n in ANY]


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize(("form", "name"), CASES)
def test_every_form_agrees_with_sympy(form, name, generator):
    model = zoo.MODELS[name]()
    rhs = generate_ode_function(generator=generator, **given(model, form))
    for seed in range(2):
        x, t = model.sample(seed)
        close(rhs(x, t, *arrays(model)), oracle(model).xdot(x, t))


@pytest.mark.parametrize(
    "form",
    [
        *(sm.Matrix, sm.ImmutableMatrix, sm.SparseMatrix, np.array, tuple),
        *(lambda q: sm.Matrix(q).T, lambda q: sm.BlockMatrix([[sm.Matrix(q)]])),
    ],
)
def test_symbols_may_stand_in_any_sequence_or_matrix_of_one_column(form):
    model = zoo.MODELS["chain"]()
    parts = given(model, "[3]")
    names = [n for n in ("coordinates", "speeds", "constants", "specifieds") if parts.get(n)]
    expected = generate_ode_function(**parts)
    made = generate_ode_function(**{**parts, **{name: form(parts[name]) for name in names}})
    x, t = model.sample(0)
    np.testing.assert_array_equal(made(x, t, *arrays(model)), expected(x, t, *arrays(model)))


def test_matrices_of_symbols_with_several_columns_are_refused():
    with pytest.raises(TypeError, match="`coordinates` must be a sequence of symbols, got Matrix"):
        generate_ode_function([V, X], sm.eye(2), [V])


@pytest.mark.parametrize(
    "of",
    [lambda m: sm.BlockMatrix([[m]]), lambda m: sm.MatAdd(m, sm.zeros(*m.shape)), sm.SparseMatrix],
)
def test_matrix_expressions_are_mass_matrices(of):
    model = zoo.MODELS["chain"]()
    parts = given(model, "[3]")
    made = generate_ode_function(**{**parts, "mass_matrix": of(parts["mass_matrix"])})
    x, t = model.sample(0)
    close(made(x, t, *arrays(model)), oracle(model).xdot(x, t))
    size = sm.Symbol("n", integer=True)
    with pytest.raises(
        ValueError, match="`mass_matrix` must be a matrix of expressions, got the M"
    ):
        generate_ode_function(**{**parts, "mass_matrix": sm.MatrixSymbol("A", size, size)})


@pytest.mark.parametrize("form", ["[1]", "[2]", "[3]"])
def test_llvm_is_the_default_generator(form):
    default = inspect.signature(generate_ode_function).parameters["generator"].default
    assert default == "llvm"
    model = zoo.timed()
    x, t = model.sample()
    close(
        generate_ode_function(**given(model, form))(x, t, *arrays(model)), oracle(model).xdot(x, t)
    )


# the linear solver

SOLVERS = ["numpy", "scipy", "sympy", "sympy:LU", "sympy:CRAMER", np.linalg.solve]


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("form", ["[2]", "[3]"])
@pytest.mark.parametrize("solver", SOLVERS, ids=lambda s: getattr(s, "__name__", s))
def test_every_linear_solver_gives_the_same(solver, form, generator):
    model = zoo.sleigh()
    rhs = generate_ode_function(generator=generator, linear_sys_solver=solver, **given(model, form))
    x, t = model.sample()
    close(rhs(x, t, *arrays(model)), oracle(model).xdot(x, t))


def test_a_solver_of_the_users_sees_the_numbers():
    model = zoo.pendulum()
    x, t = model.sample()
    seen = []

    def solve(a, b):
        seen.append((np.array(a), np.array(b)))
        return np.linalg.solve(a, b)

    rhs = generate_ode_function(linear_sys_solver=solve, **given(model, "[3]"))
    close(rhs(x, t, *arrays(model)), oracle(model).xdot(x, t))
    a, b = seen[-1]
    close(a.ravel(), oracle(model).evaluate(list(model.kane.mass_matrix), x, t))
    close(np.ravel(b), oracle(model).evaluate(list(model.kane.forcing), x, t))


def test_the_error_of_a_users_solver_shows():
    def solve(a, b):
        raise ZeroDivisionError("my own trouble")

    model = zoo.timed()
    rhs = generate_ode_function(linear_sys_solver=solve, **given(model, "[3]"))
    with pytest.raises(ZeroDivisionError, match="my own trouble"):
        rhs(*model.sample(), *arrays(model))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda x: x + 0j, "must hold real numbers"),
        (lambda x: x[:1], r"must return the shape \(3,\) or \(3, 1\), got \(1,\)"),
        (lambda x: x[None], r"must return the shape \(3,\) or \(3, 1\), got \(1, 3\)"),
    ],
)
def test_a_solution_of_a_users_solver_that_does_not_fit_is_refused(change, message):
    model = zoo.pendulum()
    rhs = generate_ode_function(
        linear_sys_solver=lambda a, b: change(np.linalg.solve(a, b)), **given(model, "[3]")
    )
    with pytest.raises(ValueError, match=f"`linear_sys_solver`.* {message}"):
        rhs(*model.sample(), *arrays(model))


@pytest.mark.parametrize("solver", ["nmupy", "sympy:NOPE", 5])
def test_an_unknown_linear_solver_is_named(solver):
    with pytest.raises((ValueError, NotImplementedError, TypeError), match=str(solver)):
        generate_ode_function(linear_sys_solver=solver, **given(zoo.timed(), "[3]"))


SINGULAR = sm.Matrix([[M, K], [M, K]])


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("solver", [None, "numpy", "scipy"])
def test_a_singular_matrix_is_a_linear_algebra_error(solver, generator):
    options = {} if solver is None else {"linear_sys_solver": solver}
    rhs = generate_ode_function(
        sm.Matrix([V, X]), [X], [V], [M, K], mass_matrix=SINGULAR, generator=generator, **options
    )
    with pytest.raises(np.linalg.LinAlgError):
        rhs([0.3, 0.4], 1.5, [2.0, 3.0])


# outputs


@pytest.mark.parametrize(
    ("kind", "generator"),
    [*((kind, name) for kind in (list, sm.Matrix) for name in GENERATORS), (tuple, "cython")],
)
def test_outputs_come_second(kind, generator):
    model = zoo.timed()
    x, t = model.sample()
    outputs = [M * V**2 / 2, sm.sin(T) * X]
    rhs = generate_ode_function(generator=generator, outputs=kind(outputs), **given(model, "[3]"))
    xdot, y = rhs(x, t, *arrays(model))
    close(xdot, oracle(model).xdot(x, t))
    close(y, oracle(model).evaluate(outputs, x, t))


@pytest.mark.parametrize("generator", GENERATORS)
def test_every_call_returns_its_own_array(generator):
    model = zoo.pendulum()
    rhs = generate_ode_function(generator=generator, **given(model, "[3]"))
    xs, ts = model.sample(0, 3)
    kept = [rhs(x, t, *arrays(model)) for x, t in zip(xs, ts, strict=True)]
    for x, t, got in zip(xs, ts, kept, strict=True):
        assert got.flags.writeable
        close(got, oracle(model).xdot(x, t))


def test_the_order_of_the_constants_is_the_users():
    matrix = sm.Matrix([V, -K * X / M])
    one = generate_ode_function(matrix, [X], [V], [M, K])
    other = generate_ode_function(matrix, [X], [V], [K, M])
    close(one([0.3, 0.4], 0.0, [2.0, 5.0]), [0.4, -0.75])
    close(other([0.3, 0.4], 0.0, [2.0, 5.0]), [0.4, -0.12])


def test_positional_arguments_come_in_the_documented_order():
    force = me.dynamicsymbols("f")
    rhs = generate_ode_function(
        sm.Matrix([force - K * X]), [X], [V], [K, M], sm.Matrix([[M]]), sm.Matrix([V]), [force]
    )
    close(rhs([0.3, 0.4], 0.0, [7.0], [5.0, 2.0]), [0.4, 2.75])


def test_constants_that_do_not_occur_are_arguments_all_the_same():
    rhs = generate_ode_function(sm.Matrix([V, -X]), [X], [V], [M, K])
    close(rhs([0.3, 0.4], 0.0, [2.0, 5.0]), [0.4, -0.3])


def test_without_constants_p_is_empty():
    rhs = generate_ode_function(sm.Matrix([V, -X]), [X], [V])
    close(rhs([0.3, 0.4], 0.0, []), [0.4, -0.3])


# sizes at which the solve is a loop


def large(n, twin=False):
    """A dense unsymmetric n by n system M u' = F in n speeds; with `twin`, two rows are equal."""
    u = me.dynamicsymbols(f"u:{n}")
    matrix = sm.Matrix(n, n, lambda i, j: sm.sin(i * i + 3 * j + u[j]) + K * int(i == (j + 3) % n))
    if twin:
        matrix[n - 1, :] = matrix[2, :]
    side = sm.Matrix([sm.cos(i + u[i]) for i in range(n)])
    rates = sm.Matrix([u[0]])
    return {
        "right_hand_side": side,
        "coordinates": [X],
        "speeds": u,
        "constants": [K],
        "mass_matrix": matrix,
        "coordinate_derivatives": rates,
    }


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("n", [5, 13, 30])
def test_a_dense_system_of_any_size_is_solved(n, generator):
    rhs = generate_ode_function(generator=generator, **large(n))
    u = np.random.default_rng(n).uniform(-1, 1, n)
    i = np.arange(n)
    matrix = np.sin(i[:, None] ** 2 + 3 * i + u) + 4.0 * (i[:, None] == (i + 3) % n)
    expected = np.linalg.solve(matrix, np.cos(i + u))
    close(rhs([0.3, *u], 0.0, [4.0]), [u[0], *expected], 1e-9)


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("n", [5, 13, 30])
def test_a_dense_singular_system_of_any_size_is_an_error(n, generator):
    rhs = generate_ode_function(generator=generator, **large(n, twin=True))
    u = np.random.default_rng(n).uniform(-1, 1, n)
    with pytest.raises(np.linalg.LinAlgError):
        rhs([0.3, *u], 0.0, [4.0])
