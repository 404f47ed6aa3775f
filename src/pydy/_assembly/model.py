"""What a definition compiles to, Programs that are stored, and linear solvers of the user's."""

from __future__ import annotations

import hashlib
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeVar, cast

import numpy as np
import sympy as sm

import pydy._assembly
import pydy._graph
import pydy._program
from pydy import _cache_folder
from pydy._assembly.assembly import Assembly, every_input
from pydy._assembly.definition import Definition, Layout
from pydy._backends import compile_program, compiled_by, strict
from pydy._checks import real_array, shown
from pydy._errors import SingularMatrixError
from pydy._forks import cached_property
from pydy._graph import passes_are_shipped
from pydy._kernel import Kernel
from pydy._names import numbers_of, some, unique_names
from pydy._program import (
    OPERATIONS,
    Program,
    ScipyOperation,
    Tangent,
    program_from_bytes,
    program_to_bytes,
    run,
)

# How often a Program is interpreted before it is compiled: an operation takes about a microsecond
# each time, and some 50 to be compiled. Who waits for both waits twice as long as need be at most.
_INTERPRETED = 64
# Small systems are simplified sooner than a file is read.
_WORTH_STORING = 300
_S = TypeVar("_S")
_T = TypeVar("_T", bound="Program | Tangent")


LinearSolver = Callable[[np.ndarray, np.ndarray], np.ndarray]


def resolve_solver(solver: Any) -> LinearSolver | str | None:
    """Return `linear_sys_solver` as None (built in), a function, or 'sympy[:METHOD]'."""
    if solver is None or callable(solver):
        found: LinearSolver | None = solver
        return found
    name = solver if isinstance(solver, str) else ""
    if name == "scipy":
        import scipy.linalg

        return scipy.linalg.solve  # type: ignore[no-any-return]
    if name.partition(":")[0] == "sympy":
        return name
    if name not in ("builtin", "numpy"):
        raise ValueError(
            f"`linear_sys_solver` is {shown(solver)}, but it must be 'builtin', 'numpy', 'scipy', "
            "'sympy', 'sympy:METHOD' or a function solve(A, b)."
        )
    return None if name == "builtin" else np.linalg.solve


def solve_symbolically(matrix: Any, column: Sequence[Any], solver: str) -> list[Any]:
    """Return the symbolic solution for 'sympy' or 'sympy:METHOD'."""
    method = solver.partition(":")[2] or "LU"
    try:
        return list(matrix.solve(sm.Matrix(column), method=method))
    except ValueError as error:
        raise ValueError(
            f"`linear_sys_solver` is {solver!r}, of which SymPy says: {error}"
        ) from error


def with_external_solver(
    program: Program, system: Kernel, solver: LinearSolver, rest: Kernel
) -> Kernel:
    """Chain the matrices, a solver and the values that depend on its solution into one Kernel."""
    (n,) = system.program.signature.block("forcing").shape

    def call(x: Any, t: Any, r: Any, p: Any, out: np.ndarray) -> int:
        if type(t) is not float or not strict(system.program, x, r, p):
            return -1
        matrices = np.empty(n * n + n)
        if system.at(x, t, r, p, matrices):
            return 1
        try:
            solution = solver(matrices[: n * n].reshape(n, n), matrices[n * n :])
        except np.linalg.LinAlgError:
            return 1
        except Exception as error:
            error.add_note("This came from the `linear_sys_solver`, called as solve(A, b).")
            raise
        solution = real_array(solution, "What `linear_sys_solver` returns")
        if solution.shape not in ((n,), (n, 1)):
            raise ValueError(
                f"`linear_sys_solver` must return the shape ({n},) or ({n}, 1), got "
                f"{solution.shape}."
            )
        return rest.at(x, t, np.concatenate([r, solution.ravel()]), p, out)

    def sweep(
        t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        out = np.full((len(t), program.signature.num_outputs), np.nan)
        failed = np.zeros(len(t), dtype=bool)
        for k, row in enumerate(np.broadcast_to(r, (len(t), r.shape[1]))):
            state, inputs = np.array(x[k], dtype=float), np.array(row, dtype=float)
            failed[k] = call(state, float(t[k]), inputs, p, out[k])
        return out, failed

    return Kernel(program, sweep, call, with_external_solver, (system, solver, rest))


def _made_by() -> bytes:
    """Return a digest of everything except the equations that determines a Program."""
    sha = hashlib.sha256(sys.version.encode())
    for package in (pydy._assembly, pydy._graph, pydy._program):
        for source in sorted(Path(str(package.__file__)).parent.rglob("*.py")):
            sha.update(source.read_bytes())
    return sha.digest()


# Now: the package may be replaced while this process runs, see `pydy._backends.llvm.compiling`.
_CIRCUMSTANCES = _made_by()


def _as_shipped() -> bool:
    """Return whether all operations and passes are the package's own."""
    return OPERATIONS.are_shipped() and passes_are_shipped()


def stored(
    parts: Sequence[bytes],
    make: Callable[[], _S],
    write: Callable[[_S], bytes],
    read: Callable[[bytes], _S],
) -> _S:
    """Return the cache's entry for the key `parts`, or make the object and store it."""
    if not _as_shipped():
        return make()
    key = hashlib.sha256(b"".join((_CIRCUMSTANCES, *parts))).hexdigest()
    data = _cache_folder.read(key)
    if data is not None:
        return read(data)
    made = make()
    _cache_folder.write(key, write(made))
    return made


def stored_program(assembly: Assembly, what: str, make: Callable[[], _T]) -> _T:
    """Return a Program or Tangent from the cache, or make it and put it there."""
    if len(assembly.graph) < _WORTH_STORING:
        return make()
    parts = (assembly.fingerprint(), what.encode())
    return stored(parts, make, program_to_bytes, lambda data: cast("_T", program_from_bytes(data)))


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
    _programs: dict[str, Program | Tangent] = field(default_factory=dict)
    _kernels: dict[tuple[Any, ...], Kernel] = field(default_factory=dict)
    _variants: dict[Any, CompiledModel] = field(default_factory=dict)
    _evaluated: dict[Any, Evaluated] = field(default_factory=dict)

    def __post_init__(self) -> None:
        ScipyOperation.refuse(self.backend, self.assembly.graph.ops)

    def __getstate__(self) -> dict[str, Any]:
        kept = self.function_blocks
        kernels = {k: v for k, v in self._kernels.items() if k == kept}
        empty: dict[str, Any] = {
            name: {} for name in ("latest", "_programs", "_variants", "_evaluated")
        }
        return {**self.__dict__, "_kernels": kernels, **empty}

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
            ("blocks", self.assembly.summary()),
            ("back end", type(self.backend).__name__),
            ("compiled", "; ".join(compiled) or "nothing so far"),
        ]
        return "\n".join(["CompiledModel", *(f"  {name:<10}  {text}" for name, text in lines)])

    @property
    def function_blocks(self) -> tuple[str, ...]:
        """The blocks that a generated function returns."""
        return ("rates", "ordinary") if self.assembly.ordinary else ("rates",)

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
            kernel = self.backend.compile(self.program(*blocks))
        else:
            assembly, what = self.assembly, f"{', '.join(blocks)} given accelerations"
            rest = stored_program(assembly, what, lambda: assembly.open_program(*blocks))
            kernel = with_external_solver(
                rest,
                self.compiled("mass_matrix", "forcing"),
                self.solver,
                self.backend.compile(rest),
            )
        self._kernels[blocks] = kernel
        return kernel

    def program(self, *blocks: str) -> Program:
        """Return the Program of some blocks of the assembly."""
        # What is made from the bodies has no fingerprint.
        storable = "kinetic_hessian" not in blocks
        return self._program(", ".join(blocks), lambda: self.assembly.program(*blocks), storable)

    def jacobian_program(self, block: str, by: str | tuple[tuple[str, int], ...]) -> Program:
        """Return the Program of a Jacobian; see `Assembly.jacobian_program`."""
        return self._program(f"{block} by {by}", lambda: self.assembly.jacobian_program(block, by))

    def _program(self, what: str, make: Callable[[], _T], storable: bool = True) -> _T:
        """Return the result of `make`, called at most once, or the cache's if it is `storable`."""
        known = self._programs.get(what)
        if known is None:
            known = stored_program(self.assembly, what, make) if storable else make()
            self._programs[what] = known
        return cast("_T", known)

    def compiled_jacobian(self, block: str, by: str | tuple[tuple[str, int], ...]) -> Kernel:
        """Return the Kernel of a Jacobian; see `Assembly.jacobian_program`."""
        in_parts, sizes = getattr(self.backend, "tangents", False), self.assembly.sizes
        for group, size in () if isinstance(by, str) else zip("xrp", sizes, strict=True):
            by = group if by == every_input(group, size) else by
        build = self.jacobian_in_parts if in_parts else self.jacobian_program
        return self.compiled_by((block, "by", by), lambda: build(block, by))

    def jacobian_in_parts(
        self, block: str, by: str | tuple[tuple[str, int], ...]
    ) -> Program | Tangent:
        """Return a Jacobian; see `Assembly.jacobian_in_parts`."""
        what = f"{block} by {by}, in parts"
        return self._program(what, lambda: self.assembly.jacobian_in_parts(block, by))

    def compiled_bounded(self, block: str) -> Kernel:
        """Return the Kernel of a block and its rounding bounds; see `Assembly.lowered`."""
        assembly, what = self.assembly, f"{block}, bounded"

        def make() -> Program:
            return assembly.program(block, bounded=block)

        return self.compiled_by((block, "bounded"), lambda: stored_program(assembly, what, make))

    def compiled_expressions(
        self, name: str, shape: tuple[int, ...], expressions: tuple[Any, ...]
    ) -> Kernel:
        """Return the Kernel of further expressions; see `Assembly.expression_program`."""
        return self.compiled_by(
            (name, shape, *expressions),
            lambda: self.assembly.expression_program(name, shape, expressions),
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
            found = self._evaluated[parts] = Evaluated(own.lowered(parts(own), as_is=True))
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
        out, failed = kernel.evaluate(t, x, r, p)
        if failed.any():
            k = int(np.flatnonzero(failed)[0])
            raise self.singular(float(t[k]), x[k])
        return out

    def singular(self, t: float, x: np.ndarray) -> SingularMatrixError:
        """Return the error of a singular mass matrix; x may have more columns after the states."""
        state = numbers_of(self.layout.states, x)
        return SingularMatrixError(
            f"The mass matrix is singular at t = {t!r} with the state {state}. Check that no mass "
            "or inertia is zero, that no constraint is redundant there, and that the "
            "configuration is not singular.",
            float(t),
            np.array(x[: len(self.layout.states)], dtype=float),
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
