"""What a definition compiles to."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pydy._assembly.assembly import Assembly
from pydy._assembly.definition import Definition, Layout
from pydy._assembly.linear_solver import LinearSolver, with_external_solver
from pydy._assembly.programs import Programs, every_input, expression_program, lower_nodes
from pydy._backends import compile_program, compiled_by
from pydy._errors import SingularMatrixError
from pydy._forks import cached_property
from pydy._kernel import Kernel
from pydy._names import numbers_of, some, unique_names
from pydy._program import OPERATIONS, Program, ScipyOperation, Tangent, run

# How often a Program is interpreted before it is compiled: an operation takes about a microsecond
# each time, and some 50 to be compiled. Who waits for both waits twice as long as need be at most.
_INTERPRETED = 64


@dataclass(frozen=True, eq=False, repr=False)
class CompiledModel:
    """Equations and outputs of one definition, and Kernels, each compiled when first called for."""

    layout: Layout  # the orders of the arrays x, r and p, and of the outputs
    assembly: Assembly  # the blocks that Kernels are made from
    backend: Any  # has ``compile(program) -> Kernel``
    # ``solve(A, b)`` of the user's, for the accelerations in values of blocks; derivatives
    # and further expressions are compiled with the built-in one.
    solver: LinearSolver | None = None
    definition: Definition | None = None  # what it was made of, where that is a mechanical system
    # What its users made of it for their latest call, by what it is; it is never pickled.
    latest: dict[str, Any] = field(default_factory=dict)
    _kernels: dict[tuple[Any, ...], Kernel] = field(default_factory=dict)
    _variants: dict[Any, CompiledModel] = field(default_factory=dict)
    _evaluated: dict[Any, Evaluated] = field(default_factory=dict)

    def __post_init__(self) -> None:
        ScipyOperation.refuse(self.backend, self.assembly.graph.ops)

    def __getstate__(self) -> dict[str, Any]:
        kept = self.assembly.blocks.of_function
        kernels = {k: v for k, v in self._kernels.items() if k == kept}
        empty: dict[str, Any] = {name: {} for name in ("latest", "_variants", "_evaluated")}
        state = {**self.__dict__, "_kernels": kernels, **empty}
        state.pop("programs", None)
        return state

    def __deepcopy__(self, memo: dict[int, Any]) -> CompiledModel:
        return self

    def __repr__(self) -> str:
        layout, compiled = self.layout, []
        for key, kernel in self._kernels.items():
            counts = {k: sum(v.values()) for k, v in kernel.program.operation_count.items()}
            compiled.append(
                f"{_title(key)} ({counts['setup']} operations at set-up, {counts['run']} a call)"
            )
        lines = [
            ("states", _listed(layout.states)),
            ("specifieds", _listed(layout.specifieds)),
            ("constants", _listed(layout.constants)),
            ("outputs", _listed(layout.outputs)),
            ("blocks", self.assembly.blocks.summary()),
            ("back end", type(self.backend).__name__),
            ("compiled", "; ".join(compiled) or "nothing so far"),
        ]
        return "\n".join(["CompiledModel", *(f"  {name:<10}  {text}" for name, text in lines)])

    @cached_property
    def programs(self) -> Programs:
        """The Programs of the assembly's blocks and of their Jacobians."""
        return Programs(self.assembly)

    # -- Kernels, each compiled when it is first called for --------------------------------------

    def compiled(self, *blocks: str) -> Kernel:
        """Return the Kernel of some blocks of the assembly.

        ``compiled('kinetic_hessian')`` is the mass matrix of all speeds, before any constraint
        reduces it; it is assembled only when asked for.
        """
        kernel = self._kernels.get(blocks)
        if kernel is not None:
            return kernel
        if self.solver is None or not self.assembly.open.keys() & set(blocks):
            kernel = self.backend.compile(self.programs.of(*blocks))
        else:
            rest = self.programs.given_accelerations(*blocks)
            kernel = with_external_solver(
                rest,
                self.compiled("mass_matrix", "forcing"),
                self.solver,
                self.backend.compile(rest),
            )
        self._kernels[blocks] = kernel
        return kernel

    def compiled_jacobian(self, block: str, by: str | tuple[tuple[str, int], ...]) -> Kernel:
        """Return the Kernel of a Jacobian; see `programs.jacobian_program`."""
        in_parts, sizes = getattr(self.backend, "tangents", False), self.assembly.sizes
        for group, size in () if isinstance(by, str) else zip("xrp", sizes, strict=True):
            by = group if by == every_input(group, size) else by
        build = self.programs.jacobian_in_parts if in_parts else self.programs.jacobian
        return self.compiled_by((block, "by", by), lambda: build(block, by))

    def compiled_expressions(
        self, name: str, shape: tuple[int, ...], expressions: tuple[Any, ...]
    ) -> Kernel:
        """Return the Kernel of further expressions; see `programs.expression_program`."""
        return self.compiled_by(
            (name, shape, *expressions),
            lambda: expression_program(self.assembly, name, shape, expressions),
        )

    def compiled_by(self, key: tuple[Any, ...], build: Callable[[], Program | Tangent]) -> Kernel:
        """Compile the Program that `build` makes, once for each key."""
        kernel = self._kernels.get(key)
        if kernel is None:
            kernel = self._kernels[key] = compiled_by(self.backend, build())
        return kernel

    def interpreted(
        self,
        parts: Callable[[Assembly], dict[str, list[int]]],
        at: tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray],
    ) -> dict[str, np.ndarray]:
        """Return the values of some nodes, (m, o) for each name, compiled only where it pays."""
        found = self._evaluated.get(parts)
        if found is None:
            own = self.assembly.fork()
            found = self._evaluated[parts] = Evaluated(lower_nodes(own, parts(own), as_is=True))
        return found(*at)

    # -- other equations -------------------------------------------------------------------------

    def variant(self, key: Any, change: Callable[[Assembly], Assembly]) -> CompiledModel:
        """Return the variant with changed equations, made at most once for each key.

        The key must hold all that `change` depends on.
        """
        other = self._variants.pop(key, None)
        if other is None:
            changed = change(self.assembly.fork())
            other = CompiledModel(self.layout, changed, self.backend, self.solver, self.definition)
        self._variants[key] = other
        while len(self._variants) > 8:  # the latest are kept
            del self._variants[next(iter(self._variants))]
        return other

    # -- values ----------------------------------------------------------------------------------

    def evaluate(
        self, kernel: Kernel, t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray
    ) -> np.ndarray:
        """Return the flat outputs of a Kernel at m samples, shape (m, o)."""
        return self.evaluate_checked(kernel, t, x, r, p)[0]

    def evaluate_checked(
        self, kernel: Kernel, t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray
    ) -> tuple[np.ndarray, bool]:
        """Return the same, and whether all of them are finite."""
        out, failed, finite = kernel.sweep(t, x, r, p)
        if failed.any():
            k = int(np.flatnonzero(failed)[0])
            raise singular_mass_matrix(self.layout, float(t[k]), x[k])
        return out, finite


def singular_mass_matrix(layout: Layout, t: float, x: np.ndarray) -> SingularMatrixError:
    """Return the error of a singular mass matrix; x may have more columns after the states."""
    state = numbers_of(layout.states, x)
    return SingularMatrixError(
        f"The mass matrix is singular at t = {t!r} with the state {state}. Check that no mass "
        "or inertia is zero, that no constraint is redundant there, and that the "
        "configuration is not singular.",
        float(t),
        np.array(x[: len(layout.states)], dtype=float),
    )


class Evaluated:
    """A Program that is interpreted at first, and compiled when it is wanted again and again."""

    def __init__(self, program: Program) -> None:
        self.program = program
        self._left = _INTERPRETED
        self._solves = not OPERATIONS.solves.isdisjoint(program.ops)

    @cached_property
    def _kernel(self) -> Kernel:
        return compile_program(self.program, "llvm", {})

    def __call__(
        self, t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray
    ) -> dict[str, np.ndarray]:
        if self._left or self._solves or p.ndim > 1:  # Kernels have one p for all samples
            self._left -= self._left > 0
            out, _ = run(self.program, t, x, r, p)
        else:
            out, _ = self._kernel.evaluate(t, x, r, p)
        return self.program.signature.by_block(out)


def _listed(symbols: tuple[Any, ...]) -> str:
    return some(unique_names(symbols)) or "none"


def _title(key: tuple[Any, ...]) -> str:
    """Return a Kernel's name, from its key, for messages."""
    if "by" in key[1:2]:
        wrt = key[2] if isinstance(key[2], str) else ", ".join(f"{g}[{k}]" for g, k in key[2])
        return f"{key[0]} by {wrt}"
    if key[1:] == ("bounded",):
        return f"{key[0]} and its rounding bounds"
    return ", ".join(key) if all(isinstance(part, str) for part in key) else str(key[0])
