"""A solution found in another way than by solving its system, and what compiled code does where
that way fails."""

import numpy as np
import pytest

from graphs import on_tape
from pydy._backends.c.cython_ import CythonBackend
from pydy._backends.llvm import jit, sources
from pydy._backends.llvm.functions import LinkedFunctions
from pydy._backends.llvm.native import LLVMBackend
from pydy._backends.numpy_ import NumPyBackend
from pydy._graph.adjoint import adjoints
from pydy._graph.derivative import jacobian
from pydy._graph.linear_system import LinearSystem
from pydy._graph.node import Graph
from pydy._graph.simplification import operation_count, simplify
from pydy._program.interpret import run
from pydy._program.tuning import INDEPENDENT

BACKENDS = {
    "llvm": LLVMBackend(lanes=1),
    "llvm, 2 lanes": LLVMBackend(lanes=2),
    "llvm, 8 lanes": LLVMBackend(lanes=8),
    "numpy": NumPyBackend(),
}


def by_hand(n):
    """A bordered system: the last unknowns are eliminated one by one, each by its own equation.

    The matrix is diag(x) but for its first row and column of constants; nothing else than the
    fallback needs the right-hand side of the first equation less a constant.
    """
    g = Graph()
    x, b, edge = ([g.input("x", k + n * i) for k in range(n)] for i in range(3))
    p = g.input("p", 0)
    zero = g.zero
    rows = [[zero] * n for _ in range(n)]
    for k in range(n):
        rows[k][k] = g.add(x[k], p)
        if k:
            rows[0][k] = rows[k][0] = edge[k]
    column = [g.add(b[0], g.call("sin", b[0])), *b[1:]]
    pivot, force, sound = rows[0][0], column[0], g.boolean(True)
    for k in range(1, n):
        inverse = g.powi(rows[k][k], -1)
        pivot = g.sub(pivot, g.mul(edge[k], edge[k], inverse))
        force = g.sub(force, g.mul(edge[k], b[k], inverse))
        sound = g.call("and", sound, g.call("lt", zero, rows[k][k]))
    sound = g.call("and", sound, g.call("lt", g.mul(g.const(1e-12), rows[0][0]), pivot))
    first = g.div(force, pivot)
    rest = [g.div(g.sub(b[k], g.mul(edge[k], first)), rows[k][k]) for k in range(1, n)]
    return g, LinearSystem(g, rows).guarded(column, sound, [first, *rest]), (3 * n, 0, 1)


def exact(x, p, n):
    matrix = np.diag(x[:n] + p)
    matrix[0, 1:] = matrix[1:, 0] = x[2 * n + 1 :]
    right = x[n : 2 * n].copy()
    right[0] += np.sin(right[0])
    return np.linalg.solve(matrix, right)


def states(n, m=19):
    rng = np.random.default_rng(n)
    x = np.column_stack([rng.uniform(9, 12, (m, n)), rng.normal(size=(m, 2 * n))])
    x[::3, :n] *= rng.choice([-1.0, 1.0], (len(x[::3]), n))  # no longer definite
    return x, np.array([0.7])


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("n", [1, 3, 9, 30])
def test_lanes_whose_pivots_are_not_sound_are_solved_by_pivoting(n, backend):
    graph, nodes, sizes = by_hand(n)
    program = on_tape(graph, nodes, sizes)
    x, p = states(n)
    x[4, n - 1] = -p[0]  # a pivot of zero
    x[1, 0] = -p[0] if n > 1 else x[1, 0]
    good = [k for k in range(19) if n > 1 or k != 4]
    found, failed = (
        BACKENDS[backend].compile(program).evaluate(np.zeros(19), x, np.empty((19, 0)), p)
    )
    assert list(np.nonzero(failed)[0]) == ([] if n > 1 else [4])
    for k in good:
        np.testing.assert_allclose(found[k], exact(x[k], p, n), rtol=1e-9)


def test_cython_solves_by_pivoting_too():
    graph, nodes, sizes = by_hand(4)
    x, p = states(4)
    kernel = CythonBackend().compile(on_tape(graph, nodes, sizes))
    found, failed = kernel.evaluate(np.zeros(19), x, np.empty((19, 0)), p)
    assert not failed.any()
    np.testing.assert_allclose(found, [exact(row, p, 4) for row in x], rtol=1e-9)


@pytest.fixture
def compiled(monkeypatch):
    """What is compiled, with nothing cached and all fallbacks left out at first."""
    monkeypatch.setenv("PYDY_CACHE_DIR", "off")
    jit.memory.clear()
    monkeypatch.setattr(sources, "MOST_WITHOUT_FALLBACKS", 2.0)
    compiled, load = [], jit.load
    monkeypatch.setattr(jit, "load", lambda s, c=(): compiled.append(s.identity) or load(s, c))
    return compiled


def scaled(n):
    """The same with a fallback that needs a value of the setup stage for itself."""
    graph, nodes, sizes = by_hand(n)
    _, entries, column, sound, fast = graph.args[graph.args[nodes[0]][0]]
    scale = graph.call("exp", graph.input("p", 0))
    entries, column = ([graph.mul(scale, k) for k in part] for part in (entries, column))
    rows = [entries[k * n : k * n + n] for k in range(n)]
    return on_tape(graph, LinearSystem(graph, rows).guarded(column, sound, fast), sizes)


def test_fallbacks_are_compiled_when_one_is_needed(compiled):
    n = 5
    program = scaled(n)
    x, p = states(n)
    kernel = BACKENDS["llvm"].compile(program)
    weak = [k for k in range(19) if (x[k, :n] < 0.0).any()]
    sound = np.delete(x, weak, axis=0)
    found, failed = kernel.evaluate(np.zeros(len(sound)), sound, np.empty((1, 0)), p)
    assert not failed.any()
    assert [what for what in compiled if program.digest in what] == [
        f"kernel {program.digest} without fallbacks"
    ]
    every, failed = kernel.evaluate(np.zeros(19), x, np.empty((1, 0)), p)
    assert not failed.any()
    assert len([what for what in compiled if program.digest in what]) == 2
    np.testing.assert_allclose(every, [exact(row, p, n) for row in x], rtol=1e-9)
    np.testing.assert_array_equal(np.delete(every, weak, axis=0), found)


def test_one_state_has_its_fallback_computed_with_the_constants_that_are_bound(compiled):
    n = 5
    program = scaled(n)
    x, p = states(n)
    x[3, n - 1] = -5.0
    kernel = BACKENDS["llvm"].compile(program)
    r, out = np.empty(0), np.empty(n)
    assert kernel.at(x[1], 0.0, r, p, out) == 0
    for _ in range(2):
        out[:] = np.nan
        assert kernel.gate(x[3], 0.0, r, p, out) == 0
        np.testing.assert_allclose(out, exact(x[3], p, n), rtol=1e-9)
    assert len([what for what in compiled if program.digest in what]) == 2


def test_fallbacks_are_there_after_an_interrupt_while_code_was_linked(compiled, monkeypatch):
    n = 5
    program = scaled(n)
    kernel = BACKENDS["llvm"].compile(program)
    use = LinkedFunctions.use

    def interrupted(self, code):
        monkeypatch.setattr(LinkedFunctions, "use", use)
        use(self, code)
        raise KeyboardInterrupt

    monkeypatch.setattr(LinkedFunctions, "use", interrupted)
    with pytest.raises(KeyboardInterrupt):
        kernel.link()
    x, p = states(n)
    found, failed = kernel.evaluate(np.zeros(19), x, np.empty((1, 0)), p)
    assert not failed.any()
    np.testing.assert_allclose(found, [exact(row, p, n) for row in x], rtol=1e-9)


def test_a_singular_system_is_one_where_fallbacks_were_left_out(compiled):
    program = on_tape(*by_hand(1))
    kernel = BACKENDS["llvm"].compile(program)
    state, p = np.array([-0.7, 1.0, 0.0]), np.array([0.7])
    assert kernel.at(state, 0.0, np.empty(0), p, np.empty(1)) == 1


def test_simplification_leaves_the_system_of_a_guard_alone():
    graph, nodes, sizes = by_hand(5)
    new = simplify(graph, nodes)
    x, p = states(5)
    values = [
        run(on_tape(graph, part, sizes), np.zeros(19), x, np.empty((19, 0)), p)[0]
        for part in (nodes, new)
    ]
    np.testing.assert_allclose(values[0], values[1], rtol=1e-12)
    assert operation_count(graph, new) <= operation_count(graph, nodes)
    before, after = (
        next(graph.args[n] for n in graph.reachable(part) if graph.ops[n] == "guard")
        for part in (nodes, new)
    )
    assert before[:3] == after[:3]


def test_what_only_the_fallback_needs_is_not_computed_at_every_call():
    graph, nodes, sizes = by_hand(3)
    n, entries, column, sound, fast = graph.args[graph.args[nodes[0]][0]]
    column = (graph.call("exp", column[0]), *column[1:])
    entries = (graph.call("log", entries[0]), *entries[1:])
    guard = graph.make("guard", (n, entries, column, sound, fast))
    program = on_tape(graph, [graph.make("item", (guard, k)) for k in range(n)], sizes)
    assert not {"exp", "log"} & set(program.operation_count["run"])
    assert {"exp", "log"} <= set(program.ops)


@pytest.mark.parametrize("backend", BACKENDS)
def test_derivatives_of_a_guarded_solution_are_those_of_its_system(backend):
    n = 3
    graph, nodes, sizes = by_hand(n)
    inputs = [graph.input("x", k) for k in range(3 * n)]
    rows = jacobian(graph, nodes, inputs)
    cells = [row.get(k, graph.zero) for row in rows for k in range(3 * n)]
    x, p = states(n)
    kernel = BACKENDS[backend].compile(on_tape(graph, simplify(graph, cells), sizes))
    found, failed = kernel.evaluate(np.zeros(19), x, np.empty((19, 0)), p)
    assert not failed.any()
    # Backwards too, and with the solution itself beside them.
    weights = [graph.const(w) for w in (0.3, -0.4, 0.7)]
    both = [*nodes, *adjoints(graph, nodes, weights, inputs)]
    back, failed = (
        BACKENDS[backend]
        .compile(on_tape(graph, both, sizes))
        .evaluate(np.zeros(19), x, np.empty((19, 0)), p)
    )
    assert not failed.any()
    whole = found.reshape(19, n, 3 * n)
    expected = np.tensordot(whole, [0.3, -0.4, 0.7], (1, 0))
    np.testing.assert_allclose(back[:, n:], expected, rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(back[:, :n], [exact(row, p, n) for row in x], rtol=1e-9)
    step = 1e-6
    for row, state in zip(found, x, strict=True):
        columns = [
            (exact(state + step * e, p, n) - exact(state - step * e, p, n)) / (2 * step)
            for e in np.eye(3 * n)
        ]
        np.testing.assert_allclose(row.reshape(n, 3 * n), np.transpose(columns), atol=1e-8)


def test_second_derivatives_of_a_guarded_solution_are_those_of_its_system():
    n = 3
    graph, nodes, sizes = by_hand(n)
    inputs = [graph.input("x", k) for k in range(3 * n)]
    gradient = adjoints(graph, nodes, [graph.one] * n, inputs)
    rows = jacobian(graph, gradient, inputs)
    cells = [row.get(k, graph.zero) for row in rows for k in range(3 * n)]
    x, p = states(n)

    def values(of, x):
        return run(on_tape(graph, of, sizes), np.zeros(len(x)), x, np.empty((len(x), 0)), p)[0]

    found = values(cells, x).reshape(19, 3 * n, 3 * n)
    np.testing.assert_allclose(found, found.swapaxes(1, 2), rtol=1e-9, atol=1e-11)
    step = 1e-5
    for k, e in enumerate(np.eye(3 * n)):
        slope = (values(gradient, x + step * e) - values(gradient, x - step * e)) / (2 * step)
        np.testing.assert_allclose(found[:, k], slope, rtol=1e-6, atol=1e-8)


@pytest.mark.parametrize("lanes", [1, 4])
def test_constraints_are_solved_for_several_right_hand_sides(lanes):
    # As one by one, on every back end; a NaN in one of them leaves the others alone.
    g = Graph()
    x = [g.input("x", k) for k in range(9)]
    mark = g.const(INDEPENDENT)
    rows = [
        [x[0], g.zero, g.neg(x[2])],
        [g.zero, x[1], g.neg(x[2])],
        [x[2], x[2], mark],
    ]
    never, nothing = g.boolean(False), [g.zero] * 3
    each = [x[3:6], x[6:9]]
    several = LinearSystem(g, rows).guarded([n for part in each for n in part], never, nothing * 2)
    single = [n for part in each for n in LinearSystem(g, rows).guarded(part, never, nothing)]
    program = on_tape(g, [*several, *single], (9, 0, 0))
    values = np.random.default_rng(1).uniform(1.0, 2.0, (7, 9))
    values[:, 2] = 1e17
    values[2, 4] = np.nan
    values[5, 0] = np.nan
    every = np.zeros(7), values, np.empty((7, 0)), np.empty(0)
    for backend in (NumPyBackend(), LLVMBackend(lanes=lanes), CythonBackend()):
        found, failed = backend.compile(program).evaluate(*every)
        assert not failed.any()
        np.testing.assert_array_equal(found[:, :6], found[:, 6:])
        assert list(np.isnan(found[:, :6]).any(axis=0)) == [True] * 6
        assert not np.isnan(found[2, 3:6]).any()
        assert not np.isnan(np.delete(found, [2, 5], axis=0)).any()
