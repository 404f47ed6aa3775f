"""Languages are tables: what is written in them computes what the Program does."""

import math
import re

import numpy as np
import pytest

from graphs import everything, solves
from pydy._assembly.programs import block_program
from pydy._backends.c.source import C
from pydy._backends.writer import Writer, stages
from pydy._program.interpret import run
from pydy.export.model import resource
from pydy.export.writing import DIALECTS, python_function
from pydy.models import n_link_pendulum_on_cart

MATRIX = [[0, 2, 1], [2, 0, 3], [1, 3, -1]]


def samples(program):
    rng = np.random.default_rng(8)
    x, r, p = (rng.uniform(0.1, 0.9, (5, size)) for size in program.signature.sizes)
    if program.signature.num_states == 15:  # nine entries of a matrix, and two columns
        x[:, :9] = np.ravel(MATRIX)
    return np.full(5, 0.3), x, r, p[0]


def solved(n, entries, column):
    matrix, right = np.broadcast_arrays(*entries), np.broadcast_arrays(*column)
    return np.linalg.solve(np.stack(matrix, -1).reshape(-1, n, n), np.stack(right, -1)[..., None])[
        ..., 0
    ]


def guarded(solve, n, sound, entries, column, fast):
    fast = np.stack(np.broadcast_arrays(*fast), -1)
    return np.where(np.asarray(sound)[..., None], fast, solve(n, entries, column))


@pytest.mark.parametrize("program", [everything(), solves()], ids=["everything", "solves"])
def test_the_whole_program_in_numpy(program):
    t, x, r, p = samples(program)
    writer = Writer(program, DIALECTS["numpy"])
    names = {"np": np, "t": t, "x": x, "r": r, "p": p, "_solve": solved, "_guarded": guarded}
    names |= {f.__name__: np.vectorize(f, otypes=[float]) for f in (math.erf, math.erfc)}
    setup, running = stages(program)
    with np.errstate(all="ignore"):
        exec("\n".join(writer.lines(sorted(setup + running))), names)
    found = [np.broadcast_to(eval(writer.names[n], names), 5) for n in program.outputs]
    np.testing.assert_allclose(np.stack(found, -1), run(program, t, x, r, p)[0], rtol=1e-13)


def test_each_stage_is_written_by_itself_and_reads_what_the_other_has_computed():
    program = block_program(n_link_pendulum_on_cart(2).model.assembly, "rates")
    setup, running = stages(program)
    assert setup
    assert not {program.setup[n] for n in running} & {True}
    for nodes, carried, place in ((setup, False, "p["), (running, True, "c[")):
        writer = Writer(program, C, carried)
        text = "\n".join(writer.lines(nodes))
        read = set(re.findall(r"[ (-](\w\[)", text))
        assert place in read
        assert len(read & {"p[", "c["}) == 1


@pytest.mark.parametrize(
    "value", [0.1, -0.0, -2.5e-300, 1e22, np.inf, -np.inf, np.nan, True, False]
)
def test_literals_are_exact(value):
    names = {"np": np}
    found = eval(DIALECTS["numpy"].literal(value), names)
    assert np.array_equal(found, value, equal_nan=True)
    assert np.signbit(found) == np.signbit(value)
    assert type(found) is type(value)


def test_casadis_module_has_the_same_values():
    casadi = pytest.importorskip("casadi")
    pendulum = block_program(n_link_pendulum_on_cart(3).model.assembly, "rates")
    for program in (everything(), solves(), pendulum):
        parts = {
            "HEAD": "",
            "STATES": dict.fromkeys(range(program.signature.num_states)),
            "INPUTS": dict.fromkeys(range(program.signature.num_specifieds)),
            "CONSTANTS": dict.fromkeys(range(program.signature.num_constants)),
            "OUTPUTS": (),
            "NAMES": {},
            "FUNCTIONS": python_function(program, "rates", "casadi"),
        }
        text, names = resource("casadi_module.py.txt"), {}
        exec(re.sub(r"\{\{([A-Z]+)\}\}", lambda m, parts=parts: str(parts[m[1]]), text), names)
        t, x, r, p = samples(program)
        assert isinstance(names["rates"], casadi.Function)
        found = np.array(names["rates"](t[0], x[0], r[0], p)).ravel()
        np.testing.assert_allclose(found, run(program, t, x, r, p)[0][0], rtol=1e-12)
