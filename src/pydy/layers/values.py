"""A block of the equations as a function, with products of its Jacobian and vectors."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from itertools import accumulate

import numpy as np

from pydy._assembly import singular_mass_matrix
from pydy._checks import describe
from pydy._graph import inputs_of
from pydy._kernel import Kernel
from pydy._problem import Problem
from pydy.layers.layer import ArgumentPart, Arrays, replaced_specifieds


def _rows(
    base: np.ndarray, part: ArgumentPart | None, values: np.ndarray | None, m: int
) -> np.ndarray:
    """Return m copies of `base` (n,), or a copy of (m, n), with the entries of a part replaced."""
    rows: np.ndarray = np.array(np.broadcast_to(base, (m, base.shape[-1])), order="C")
    if part is not None:
        rows[:, list(part.indices)] = values
    return rows


def _runs(rows: np.ndarray) -> Iterator[slice]:
    """Return the slices of consecutive equal rows."""
    ends = np.flatnonzero((rows[1:] != rows[:-1]).any(axis=1)) + 1
    for start, stop in zip([0, *ends], [*ends, len(rows)], strict=True):
        yield slice(start, stop)


class BlockFunction:
    """A block of the equations as a function of x, t, r and p: a `LayerFunction`."""

    def __init__(self, problem: Problem, block: str, parts: tuple[ArgumentPart, ...]) -> None:
        self.problem, self.block, self.parts = problem, block, parts
        self._part_of = {part.group: part for part in parts}
        self._plan = problem.plan.with_zeros(replaced_specifieds(parts))
        self._code = problem.model.with_compiled_inputs(self._plan)
        self._check_unknowns()
        self._kernel = self._code.compiled(block)
        self.shape: tuple[int, ...] = (self._kernel.program.signature.num_outputs,)
        self._products: dict[tuple[str, tuple[int, ...]], tuple[Kernel, list[ArgumentPart]]] = {}

    def _check_unknowns(self) -> None:
        """Raise an error if an argument would change the unknowns of an `Implicit`."""
        blocks = self.problem.definition.equations.constraints.residuals.blocks
        if not blocks or ("x" in self._part_of and self._part_of["x"].is_full):
            return
        assembly, states = self._code.assembly, self.problem.definition.states
        g, holonomic = assembly.graph, assembly.blocks.holonomic
        rows = [holonomic[k] for block, _ in blocks for k in block]
        inputs = {*inputs_of(g, rows).values()}
        if any((part.group, k) in inputs for part in self.parts for k in part.indices):
            unknowns = [states[k] for _, columns in blocks for k in columns]
            raise ValueError(
                f"`x` must be an array of whole states where the values of a call change what the "
                f"residuals of `implicit` give, {describe(unknowns)}: layers solve for that in "
                "`simulate` and `final` alone. `evaluate_ode` and `evaluate_outputs` solve for it."
            )

    def _evaluate(
        self, kernel: Kernel, arrays: Arrays, extra_inputs: np.ndarray | None = None
    ) -> np.ndarray:
        """Return the outputs of a Kernel, (…, o); `extra_inputs` follow r."""
        lead = arrays[0].shape[:-1]
        if not lead:
            return self._at(kernel, arrays, extra_inputs)
        if 0 in lead:
            return np.empty((*lead, kernel.program.signature.num_outputs))
        flat = [array.reshape(-1, array.shape[-1]) for array in arrays]
        values = {part.group: array for part, array in zip(self.parts, flat, strict=True)}
        m, problem, part_of = len(flat[0]), self.problem, self._part_of
        x = _rows(problem.x, part_of.get("x"), values.get("x"), m)
        t = np.ascontiguousarray(values["t"][:, 0]) if "t" in values else np.full(m, problem.t)
        self._plan.check_times(t, "t")
        r = _rows(self._plan.inputs.rows(x, t), part_of.get("r"), values.get("r"), m)
        if extra_inputs is not None:
            r = np.hstack([r, extra_inputs.reshape(m, -1)])
        p = _rows(problem.p, part_of.get("p"), values.get("p"), m)
        outputs = [self._code.evaluate(kernel, t[k], x[k], r[k], p[k.start]) for k in _runs(p)]
        table = outputs[0] if len(outputs) == 1 else np.concatenate(outputs)
        return table.reshape(*lead, -1)

    def _at(self, kernel: Kernel, arrays: Arrays, extra_inputs: np.ndarray | None) -> np.ndarray:
        """Return the outputs of a Kernel at one state, with less overhead than `_evaluate`."""
        problem, plan = self.problem, self._plan
        values = {"x": problem.x, "p": problem.p}
        t = problem.t
        for part, array in zip(self.parts, arrays, strict=True):
            group = part.group
            if group == "t":
                t = float(array[0])
            elif part.is_full:
                values[group] = array
            elif group != "r":
                values[group] = values[group].copy()
                values[group][list(part.indices)] = array
        x, p = values["x"], values["p"]
        r = values.get("r")
        if r is None:
            if plan.inputs.sampled:
                plan.check_times(np.array([t]), "t")
            r = plan.inputs(x, t)
            if "r" in self._part_of:
                r[list(self._part_of["r"].indices)] = arrays[self.parts.index(self._part_of["r"])]
        if extra_inputs is not None:
            r = np.concatenate([r, extra_inputs])
        out = np.empty(kernel.program.signature.num_outputs)
        if kernel.at(x, t, r, p, out):
            raise singular_mass_matrix(self._code.layout, t, x)
        return out

    def value(self, *arrays: np.ndarray) -> np.ndarray:
        """Return the values."""
        return self._evaluate(self._kernel, arrays)

    def _product(self, kind: str, wrt: tuple[int, ...]) -> tuple[Kernel, list[ArgumentPart]]:
        """Return the Kernel of a product with the Jacobian, and the parts of its inputs."""
        compiled = self._products.get((kind, wrt))
        if compiled is not None:
            return compiled
        for _, function in self._plan.inputs.functions:
            raise ValueError(
                f"Derivatives need those of the specifieds, but {function.label} is a Python "
                "function, which has none. Give it as a SymPy expression of states, time and "
                "constants, as samples, pydy.inputs.SampledInput(times, values), or in `r`."
            )
        parts = [self.parts[k] for k in wrt]
        s = len(self.problem.definition.specifieds)
        if self._plan.inputs.sampled and any(part.group == "t" for part in parts):
            parts.append(
                ArgumentPart("r", (*range(s),), (1,) * s, True)
            )  # samples change with time
        inputs = tuple((part.group, k) for part in parts for k in part.indices)
        code, block = self._code, self.block
        program = partial(code.programs.product, block, inputs, kind)
        kernel = code.compiled_by(("product", kind, block, (), inputs, 1), program)
        self._products[kind, wrt] = kernel, parts
        return kernel, parts

    def _slopes(self, wrt: tuple[int, ...], arrays: Arrays) -> np.ndarray:
        """Return the time derivatives of sampled specifieds, (…, s).

        The plan has no samples for those that an argument replaces.
        """
        t = np.full(arrays[0].shape[:-1], self.problem.t)
        for part, array in zip(self.parts, arrays, strict=True):
            t = array[..., 0] if part.group == "t" else t
        slopes = np.zeros((*t.shape, len(self.problem.definition.specifieds)))
        for columns, samples in self._plan.inputs.sampled:
            rows = [samples.slopes_at(float(instant)) for instant in t.ravel()]
            slopes[..., columns] = np.reshape(rows, (*t.shape, len(columns)))
        return slopes

    def forward(self, wrt: tuple[int, ...], arrays: Arrays, directions: Arrays) -> np.ndarray:
        """Return the Jacobian-vector product, with a direction for each argument of `wrt`."""
        kernel, parts = self._product("jacobian-vector", wrt)
        inputs = [*directions]
        if len(parts) > len(wrt):
            k = next(k for k, part in enumerate(parts) if part.group == "t")
            inputs.append(directions[k] * self._slopes(wrt, arrays))
        return self._evaluate(kernel, arrays, np.concatenate(inputs, axis=-1))

    def backward(self, wrt: tuple[int, ...], arrays: Arrays, weights: np.ndarray) -> Arrays:
        """Return the vector-Jacobian products of the weights, one for each argument of `wrt`."""
        kernel, parts = self._product("vector-jacobian", wrt)
        products = self._evaluate(kernel, arrays, weights)
        stops = [*accumulate(part.size for part in parts)]
        columns = [products[..., a:b] for a, b in zip([0, *stops], stops, strict=False)]
        if len(parts) > len(wrt):
            k = next(k for k, part in enumerate(parts) if part.group == "t")
            extra = (columns.pop() * self._slopes(wrt, arrays)).sum(axis=-1, keepdims=True)
            columns[k] = columns[k] + extra
        return tuple(columns)
