"""The Zarr store of an ensemble: one chunk for each block, so that any process may write its own.

A block is there when its `status` is, which is written last; anything else of it may be half
written and is written again.
"""

from __future__ import annotations

import hashlib
import pickle
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from pydy._optional import require
from pydy._version import __version__
from pydy.ensemble.labels import Form, Variable, check_forms
from pydy.ensemble.samples import Block, Samples
from pydy.ensemble.work import Work
from pydy.solvers.outcome import NOT_COMPUTED

__all__ = ["check", "create", "missing", "token_of", "write"]

_TOKEN, _READY, _VARIABLES = "pydy_ensemble", "pydy_ready", "pydy_variables"


def token_of(work: Work, samples: Samples, sizes: Sequence[int]) -> str:
    """Return what tells one ensemble from another: equations, options, numbers and blocks."""
    model, digest = work.model, hashlib.sha256()
    programs = [p.digest for p in (model.rates, model.outputs, model.jacobian) if p is not None]
    options = {k: v for k, v in vars(model.options).items() if k not in ("events", "constraints")}
    reductions = [_identity(r) for r in (*work.reductions, *(f for _, f in model.functions))]
    events, constraints = model.options.events, model.options.constraints
    if events is not None:
        kernels = [events.values, *(k for k in events.resets if k is not None)]
        programs += [k.program.digest for k in kernels]
        reductions += [repr((events.names, events.directions, events.terminal))]
    if constraints is not None:
        programs.append(constraints.kernel.program.digest)
    about = (
        __version__,
        programs,
        model.states,
        model.output_names,
        model.method,
        options,
        reductions,
    )
    digest.update(repr((*about, samples.dims, tuple(sizes))).encode())
    for part in (model.times, *samples.x, *samples.r, *samples.p):
        digest.update(repr(part.shape).encode() + np.ascontiguousarray(part).tobytes())
    for columns, sampled in model.sampled:
        digest.update(columns.tobytes() + pickle.dumps(sampled))
    return digest.hexdigest()


def _identity(thing: Any) -> str:
    """Return a text that tells functions, and the records of other reductions, apart."""
    code = getattr(thing, "__code__", None)
    if code is None:
        return repr(thing)
    return f"{thing.__module__}.{thing.__qualname__} {hashlib.sha256(code.co_code).hexdigest()}"


def check(path: str, token: str, resume: bool) -> bool:
    """Tell whether there is a store to go on with.

    Raises
    ------
    ValueError
        Something else is there.
    """
    if not Path(path).exists():
        return False
    if not resume:
        raise ValueError(
            f"`store` must be a path where nothing is yet, got '{path}'. Pass resume=True to "
            "compute only what is missing there, or remove it."
        )
    zarr = require("zarr", "ensemble", "`store`")
    try:
        attrs = dict(zarr.open_group(path, mode="r").attrs)
    except Exception:  # noqa: BLE001 - whatever is there, it cannot be read
        attrs = {}
    if attrs.get(_TOKEN) != token:
        raise ValueError(
            f"`store` '{path}' was written by another ensemble: its equations, numbers, options, "
            "`reduce` or `chunks` differ, or it is no store of an ensemble. Give another path."
        )
    return bool(attrs.get(_READY))


def create(path: str, token: str, example: Any, samples: Samples, sizes: Sequence[int]) -> None:
    """Make a store with all coordinates and no results yet.

    Parameters
    ----------
    example : xarray.Dataset
        Of one sample, with all attributes and coordinates; its own sizes do not count.
    """
    zarr = require("zarr", "ensemble", "`store`")
    about = {_TOKEN: token, _VARIABLES: list(map(str, example.data_vars))}
    group = zarr.open_group(path, mode="w", attributes=about)
    dims = tuple(samples.dims)
    for name, variable in example.variables.items():
        attrs = {**variable.attrs}
        if name in example.coords:
            values = (
                np.asarray(samples.coordinates[name].values)
                if name in samples.coordinates
                else (np.asarray(variable))
            )
            made = _array(
                group, name, values.shape, values.shape, values.dtype, variable.dims, attrs
            )
            made[...] = values
            continue
        rest = tuple(variable.sizes[d] for d in variable.dims if d not in dims)
        shape, chunks = (*samples.shape, *rest), (*sizes, *rest)
        fill = NOT_COMPUTED if name == "status" else None
        _array(group, name, shape, chunks, variable.dtype, variable.dims, attrs, fill)
    group.attrs.update({**example.attrs, "coordinates": " ".join(map(str, samples.coordinates))})
    group.attrs[_READY] = True


def _array(
    group: Any,
    name: Any,
    shape: tuple[int, ...],
    chunks: tuple[int, ...],
    dtype: Any,
    dims: Any,
    attrs: Mapping[str, Any],
    fill: Any = None,
) -> Any:
    if fill is None:
        fill = np.nan if np.dtype(dtype).kind == "f" else 0
    return group.create_array(
        str(name),
        shape=shape,
        chunks=tuple(max(1, c) for c in chunks) if shape else "auto",
        dtype=dtype,
        dimension_names=tuple(map(str, dims)),
        attributes=dict(attrs),
        fill_value=fill,
    )


def missing(path: str, blocks: Sequence[Block]) -> list[Block]:
    """Return the blocks that the store does not have."""
    zarr = require("zarr", "ensemble", "`store`")
    status = zarr.open_group(path, mode="r")["status"]
    return [block for block in blocks if not _has(status, block)]


def _has(status: Any, block: Block) -> bool:
    try:
        return not (np.asarray(status[block]) == NOT_COMPUTED).any()
    except Exception:  # noqa: BLE001 - a chunk that was half written reads like this
        return False


def write(path: str, block: Block, found: Mapping[str, Variable]) -> None:
    """Write the results of a block."""
    zarr = require("zarr", "ensemble", "`store`")
    group = zarr.open_group(path, mode="r+")
    arrays = {name: group[name] for name in group.attrs[_VARIABLES]}
    forms = {
        name: Form.of(a.metadata.dimension_names, a.shape, a.dtype, len(block))
        for name, a in arrays.items()
    }
    check_forms(found, forms, block)
    for name, variable in found.items():
        if name != "status":
            group[name][block] = variable.values
    group["status"][block] = found["status"].values
