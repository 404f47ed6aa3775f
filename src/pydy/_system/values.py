"""What the evaluating methods of System do: Kernels at one state or several."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from pydy._assembly.model import CompiledModel
from pydy._assembly.specifieds import driven
from pydy._errors import SingularMatrixError
from pydy._kernel import Kernel
from pydy._system.causes import cause_of, explain
from pydy._system.energy import Energy
from pydy._system.evaluation import row_names, samples, specified_rows, warn_not_finite
from pydy._system.products import prepare_product
from pydy._system.snapshot import Snapshot

__all__ = ["evaluate_block", "evaluate_energy", "evaluate_product"]


def evaluate_block(
    now: Snapshot, block: str, x: Any, t: Any, r: Any, p: Any, wrt: Any = None
) -> np.ndarray:
    """Evaluate a block of the equations, or its Jacobian by `wrt`, as `variables` returns it."""

    def kernel(model: CompiledModel) -> Kernel:
        return model.compiled_jacobian(block, wrt) if wrt else model.compiled(block)

    perturbed = wrt == "r" or (isinstance(wrt, tuple) and any(g == "r" for g, _ in wrt))
    names = partial(row_names, now.definition, block)
    return _sweep(now, kernel, names, x, t, r, p, perturbed=perturbed)


def evaluate_product(
    now: Snapshot, kind: str, of: Any, wrt: Any, v: Any, x: Any, t: Any, r: Any, p: Any
) -> np.ndarray:
    """Evaluate a product with derivatives; see `prepare_product`."""
    made = prepare_product(now.definition, kind, of, wrt, v, x)
    out = _sweep(
        now,
        made.kernel,
        lambda: made.names,
        x,
        t,
        r,
        p,
        perturbed=made.perturbed,
        vectors=made.vectors,
    )
    return out[..., 0] if made.squeeze else out


def evaluate_energy(now: Snapshot, x: Any, t: Any, r: Any, p: Any) -> Energy:
    """Evaluate the kinetic, the potential and the total energy."""
    names = partial(row_names, now.definition, "energy")
    values = _sweep(now, now.energies.kernel, names, x, t, r, p)
    return Energy(*(values.tolist() if values.ndim == 1 else values.T.copy()))


def _sweep(
    now: Snapshot,
    kernel: Callable[[CompiledModel], Kernel],
    names: Callable[[], Sequence[str]],
    x: Any,
    t: Any,
    r: Any,
    p: Any,
    *,
    perturbed: bool = False,
    vectors: np.ndarray | None = None,
) -> np.ndarray:
    """Evaluate a Kernel at one state or several, with the defaults of the evaluations.

    `names` returns those of the result's rows; `vectors`, (1, k) or (m, k), are inputs after r.
    """
    model, layout = now.model, now.model.layout
    states, instants, single = samples(
        now.x_with(x), t, lambda: now.x, now.times, len(layout.states)
    )
    if r is None or callable(r) or isinstance(r, Mapping):
        plan = now.plan_with(r)
        plan.check_times(instants, "times" if t is None else "t")
        rows = plan.rows(states, instants)
        model = driven(model, now.definition, plan, perturbed=perturbed)
    else:
        rows = specified_rows(r, instants, len(layout.specifieds))
    constants = now.p_with(p)
    made = kernel(model)
    if vectors is not None:
        shapes = [(len(states), part.shape[1]) for part in (rows, vectors)]
        rows = np.hstack([np.broadcast_to(rows, shapes[0]), np.broadcast_to(vectors, shapes[1])])
    try:
        out = model.evaluate(made, instants, states, rows, constants)
    except SingularMatrixError as error:
        k = int((states == error.state).all(axis=1).argmax()) % len(rows)
        explain(error, now.definition, model, lambda x, t: rows[k], constants)
        raise
    out = out.reshape(len(out), *made.program.blocks[0].shape)
    if not np.isfinite(out).all():

        def cause(k: int) -> str | None:
            row = rows[k if len(rows) > 1 else 0]
            instant = float(instants[k])
            return cause_of(now.definition, model, instant, states[k], row, constants)

        warn_not_finite(out, (instants, states, rows, constants), layout, names(), cause)
    result: np.ndarray = out[0] if single else out
    return result
