"""What stands behind a generated function: kernels, the orders of arrays, and the parsing of r, p.

The function tries the compiled code first, with its arguments as they are. The code answers −1
when they are not float64 vectors of the right length; only then are they converted and checked.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from copy import copy
from dataclasses import dataclass
from functools import cached_property
from inspect import Parameter, signature
from typing import Any

import numpy as np

from pydy._assembly.assembly import Assembly
from pydy._assembly.stored import stored_program
from pydy._backends.registry import refusal
from pydy._checks import number, vector
from pydy._errors import SingularMatrixError
from pydy._graph.program import Program
from pydy._kernel import Kernel, KernelCall
from pydy._names import nearest
from pydy.codegen.arguments import (
    ConstantsArgument,
    SpecifiedsArgument,
    SpecifiedsPlan,
    real_array,
)
from pydy.codegen.docstring import rhs_docstring
from pydy.codegen.external_solve import Solver, with_external_solver
from pydy.inputs import SampledInput

__all__ = ["Layout", "RightHandSide", "raise_singular"]

_NOTHING = np.empty(0)


@dataclass(frozen=True)
class Layout:
    """The orders of the arrays x, r and p.

    Attributes
    ----------
    states, specifieds, constants : tuple of symbols
    """

    states: tuple[Any, ...]
    specifieds: tuple[Any, ...]
    constants: tuple[Any, ...]


class RightHandSide:
    """The implementation of a generated function.

    Parameters
    ----------
    assembly : Assembly
    layout : Layout
    backend : class
    generator : str or class
        How the user named the back end.
    options : dict
        Its options.
    solver : callable, optional
        Solves for the accelerations outside the compiled code.
    constants_arg_type, specifieds_arg_type : str, optional
    time_first : bool, optional
    """

    def __init__(
        self,
        assembly: Assembly,
        layout: Layout,
        backend: type,
        generator: Any,
        options: dict[str, Any],
        *,
        solver: Solver | None = None,
        constants_arg_type: str | None = None,
        specifieds_arg_type: str | None = None,
        time_first: bool = False,
    ) -> None:
        self.layout = layout
        self.time_first = time_first
        self.generator = generator
        self.num_outputs = len(assembly.ordinary)
        self.constants = ConstantsArgument(layout.constants, constants_arg_type)
        self.specifieds = SpecifiedsArgument(layout.specifieds, specifieds_arg_type, time_first)
        options = dict(options)
        # Only the Cython generator has this option; here it decides what is refused.
        self.refuse_strided = generator == "cython" and not options.pop("force_c_contiguous", False)
        self.assembly = assembly
        self._compiler = _compiler(backend, generator, options)
        if not hasattr(self._compiler, "compile"):
            raise refusal(backend)
        self._solver = solver
        self._blocks = ("rates", "ordinary") if self.num_outputs else ("rates",)
        self._kernels: dict[tuple[Any, ...], Kernel] = {}
        self._changed: dict[Any, RightHandSide] = {}
        self.function_of_user: Any = None  # what `make_function` made of this

    def __getstate__(self) -> dict[str, Any]:
        state = dict(self.__dict__)
        state["_kernels"] = {k: v for k, v in self._kernels.items() if k == self._blocks}
        state["_changed"] = {}
        state["function_of_user"] = None  # it pickles as this object: no circles
        return state

    def taking_strided(self) -> RightHandSide:
        """Return the same, with the same code, for states in any layout."""
        other = copy(self)
        other.refuse_strided, other._changed = False, {}
        other.function_of_user = None
        return other

    @property
    def kernel(self) -> Kernel:
        """The Kernel of what the function returns."""
        return self.compiled(*self._blocks)

    def changed(self, key: Any, change: Callable[[Assembly], Assembly]) -> RightHandSide:
        """Return the same with other equations, made at most once for each key.

        Parameters
        ----------
        key : hashable
            The latest eight are kept.
        change : callable
            Makes the other equations from these; sizes and layout stay.
        """
        other = self._changed.pop(key, None)
        if other is None:
            other = copy(self)
            other.assembly = change(self.assembly)
            other._kernels, other._changed = {}, {}
            other.function_of_user = None
        self._changed[key] = other
        while len(self._changed) > 8:
            del self._changed[next(iter(self._changed))]
        return other

    def compiled(self, *blocks: str) -> Kernel:
        """Return the Kernel of some blocks of the assembly, compiled at most once.

        ``compiled('kinetic_hessian')`` is the mass matrix of all speeds, before any constraint
        reduces it; it is assembled only when asked for, as is ``'kinetic_energy'``.
        """
        kernel = self._kernels.get(blocks)
        if kernel is None:
            kernel = self._compiler.compile(self._program(*blocks))
            if self._solver is not None:
                matrices = self._system_kernel()
                kernel = with_external_solver(kernel.program, matrices, self._solver, kernel)
            self._kernels[blocks] = kernel
        return kernel

    def _program(self, *blocks: str) -> Program:
        assembly = self.assembly
        if any(name.startswith("kinetic") for name in blocks):
            return assembly.program(*blocks)  # made from the bodies, which have no fingerprint
        return stored_program(assembly, ", ".join(blocks), lambda: assembly.program(*blocks))

    def compiled_jacobian(self, block: str, by: str | tuple[tuple[str, int], ...]) -> Kernel:
        """Return the Kernel of a Jacobian; see `Assembly.jacobian_program`."""
        assembly = self.assembly
        return self.compiled_by(
            (block, "by", by),
            lambda: stored_program(
                assembly, f"{block} by {by}", lambda: assembly.jacobian_program(block, by)
            ),
        )

    def compiled_bounded(self, block: str) -> Kernel:
        """Return the Kernel of a block and its rounding bounds; see `Assembly.bounded_program`."""
        assembly = self.assembly
        return self.compiled_by(
            (block, "bounded"),
            lambda: stored_program(
                assembly, f"{block}, bounded", lambda: assembly.bounded_program(block)
            ),
        )

    def compiled_expressions(
        self, name: str, shape: tuple[int, ...], expressions: tuple[Any, ...]
    ) -> Kernel:
        """Return the Kernel of further expressions; see `Assembly.expression_program`."""
        return self.compiled_by(
            (name, shape, *expressions),
            lambda: self.assembly.expression_program(name, shape, expressions),
        )

    def compiled_by(self, key: tuple[Any, ...], build: Callable[[], Program]) -> Kernel:
        """Return the Kernel of a Program that `build` makes, at most once for each key."""
        kernel = self._kernels.get(key)
        if kernel is None:
            kernel = self._kernels[key] = self._compiler.compile(build())
        return kernel

    def _system_kernel(self) -> Kernel:
        key = ("mass_matrix", "forcing")
        if key not in self._kernels:
            # Its r is the user's own, without the solution at the end.
            assembly = self.assembly
            n = len(assembly.forcing)
            whole = assembly.sizes
            assembly.sizes = (whole[0], whole[1] - n, whole[2])
            try:
                self._kernels[key] = self._compiler.compile(self._program(*key))
            finally:
                assembly.sizes = whole
        return self._kernels[key]

    def docstring(self) -> str:
        """Return the docstring that users read with help()."""
        return rhs_docstring(
            self.layout.states,
            self.layout.specifieds,
            self.layout.constants,
            self.num_outputs,
            specifieds_arg_type=self.specifieds.arg_type,
            constants_arg_type=self.constants.arg_type,
            time_first=self.time_first,
        )

    def function(self) -> Any:
        """Return the function that evaluates, with the fast path inlined in its closure."""
        call, slow = self.kernel.call, self._convert_and_call
        n, total = len(self.layout.states), len(self.layout.states) + self.num_outputs
        empty, nothing, swapped = np.empty, _NOTHING, self.time_first
        plain_p, plain_r = self.constants.plain, self.specifieds.plain
        if self.layout.specifieds:

            def evaluate(args: tuple[Any, ...]) -> np.ndarray:
                try:
                    x, t, r, p = args
                except ValueError:
                    raise self._wrong_count(args) from None
                if swapped:
                    x, t = t, x
                s = plain_r(r) if type(r) is dict else r
                c = plain_p(p) if type(p) is dict else p
                out = empty(total)
                if call(x, t, s, c, out):
                    slow(x, t, r, p, out)
                return out

        else:

            def evaluate(args: tuple[Any, ...]) -> np.ndarray:
                try:
                    x, t, p = args
                except ValueError:
                    raise self._wrong_count(args) from None
                if swapped:
                    x, t = t, x
                c = plain_p(p) if type(p) is dict else p
                out = empty(total)
                if call(x, t, nothing, c, out):
                    slow(x, t, nothing, p, out)
                return out

        if self.num_outputs:

            def rhs(*args):  # type: ignore[no-untyped-def]
                out = evaluate(args)
                return out[:n], out[n:]

        else:

            def rhs(*args):  # type: ignore[no-untyped-def]
                return evaluate(args)

        rhs.native = self.native  # type: ignore[attr-defined]
        return rhs

    def rates_function(self, plan: SpecifiedsPlan) -> Any:
        """Return ``f(x, t, r, p)`` for solvers: the derivatives alone, from arrays r and p.

        Native solvers find a `KernelCall` through its attribute ``native``.

        Parameters
        ----------
        plan : SpecifiedsPlan
            Unless it is constant, it gives r at each state and time, in place of the argument.
        """
        kernel = self.compiled("rates")
        call, empty, n = kernel.call, np.empty, len(self.layout.states)
        convert = self._convert_arrays

        def f(x: Any, t: Any, r: Any, p: Any) -> np.ndarray:
            out = empty(n)
            if call(x, t, r, p, out):
                convert(kernel, x, t, r, p, out)
            return out

        def f_with_functions(x: Any, t: Any, r: Any, p: Any) -> np.ndarray:
            x = self._state(x)
            return f(x, t, plan(x, float(t)), p)

        chosen: Any = f if plan.constant else f_with_functions

        def native(args: tuple[Any, ...]) -> KernelCall:
            r, p = args
            return self._native_call(kernel, plan, self._r(r) if plan.constant else plan.values, p)

        chosen.native = native
        return chosen

    def _r(self, r: Any) -> np.ndarray:
        return vector(r, len(self.layout.specifieds), "`r`, the specifieds,")

    def _p(self, p: Any) -> np.ndarray:
        return vector(p, len(self.layout.constants), "`p`, the constants,")

    def _native_call(
        self, kernel: Kernel, plan: SpecifiedsPlan, r: np.ndarray, p: Any
    ) -> KernelCall:
        return KernelCall(
            kernel,
            self._p(p),
            r,
            plan.sampled,
            plan if plan.functions else None,
            lambda: tuple(map(str, self.layout.states)),
            None if self._solver else lambda: self.compiled_jacobian("rates", "x"),
        )

    def native(self, args: tuple[Any, ...]) -> KernelCall | None:
        """Return how native solvers call the generated function with `args` after x and t.

        None where it has to be called itself: it returns more than derivatives, takes time first,
        or the specifieds are a function.
        """
        symbols = self.layout.specifieds
        if self.time_first or self.num_outputs or len(args) != (2 if symbols else 1):
            return None
        p, plan = self.constants(args[-1]), self._no_plan
        values = plan.values
        if symbols:
            r = args[0]
            if isinstance(r, SampledInput):
                r = {symbols: r}
            if isinstance(r, Mapping):
                plan = SpecifiedsPlan(r, symbols, complete=True)
                values = plan.values
                if plan.expressions:
                    return None
            elif callable(r):
                return None
            else:
                values = self.specifieds(r, _NOTHING, 0.0)
        return self._native_call(self.kernel, plan, values, p)

    @cached_property
    def _no_plan(self) -> SpecifiedsPlan:
        return SpecifiedsPlan({}, self.layout.specifieds)

    # -- the slow path ----------------------------------------------------------------------------

    def _wrong_count(self, args: tuple[Any, ...]) -> TypeError:
        first = "t, x" if self.time_first else "x, t"
        names = f"{first}, r, p" if self.layout.specifieds else f"{first}, p"
        return TypeError(f"rhs({names}) takes {names.count(',') + 1} arguments, got {len(args)}.")

    def _state(self, x: Any) -> np.ndarray:
        n = len(self.layout.states)
        if self.refuse_strided and isinstance(x, np.ndarray) and not x.flags.c_contiguous:
            raise ValueError(
                "`x` must be a C-contiguous array, because `force_c_contiguous` is False: pass "
                "np.ascontiguousarray(x), or generate the function with force_c_contiguous=True."
            )
        array = real_array(x, "`x`")
        if array.shape != (n,):
            raise ValueError(
                f"`x` must have the shape ({n},), one value for each state, got {array.shape}."
            )
        return array

    def _convert_and_call(self, x: Any, t: Any, r: Any, p: Any, out: np.ndarray) -> None:
        x, t = self._state(x), number(t, "`t`")
        if self.layout.specifieds:
            r = self.specifieds(r, x, t)
        self._call_strict(self.kernel, x, t, r, self.constants(p), out)

    def _convert_arrays(
        self, kernel: Kernel, x: Any, t: Any, r: Any, p: Any, out: np.ndarray
    ) -> None:
        self._call_strict(kernel, self._state(x), number(t, "`t`"), self._r(r), self._p(p), out)

    def _call_strict(
        self,
        kernel: Kernel,
        x: np.ndarray,
        t: float,
        r: np.ndarray,
        p: np.ndarray,
        out: np.ndarray,
    ) -> None:
        status = kernel.call(x, t, r, p, out)
        if status > 0:
            raise_singular(self.layout, t, x)
        if status < 0:
            values, failed = kernel.evaluate(np.array([t]), x[None], r[None], p)
            if failed[0]:
                raise_singular(self.layout, t, x)
            out[:] = values[0]


def _compiler(backend: type, generator: Any, options: dict[str, Any]) -> Any:
    """Return a back end with its options, or say which options it has."""
    try:
        taken = signature(backend).parameters
    except ValueError:  # a class that is not written in Python may have none
        return backend(**options)
    open_ended = any(p.kind is Parameter.VAR_KEYWORD for p in taken.values())
    unknown = [] if open_ended else [name for name in options if name not in taken]
    if unknown:
        known = [*taken, *(["force_c_contiguous"] if generator == "cython" else [])]
        raise TypeError(
            f"generate_ode_function() has no option `{unknown[0]}` for the generator "
            f"{generator!r}. {nearest(unknown[0], known)}"
        )
    return backend(**options)


def raise_singular(layout: Layout, t: float, x: np.ndarray) -> None:
    """Raise the error of a singular mass matrix, with the state by name."""
    state = ", ".join(f"{s} = {v:.6g}" for s, v in zip(layout.states, x, strict=True))
    raise SingularMatrixError(
        f"The mass matrix is singular at t = {t!r} with the state {state}. Check that no mass or "
        "inertia is zero, that no constraint is redundant there, and that the configuration is not "
        "a singular one.",
        float(t),
        np.array(x, dtype=float),
    )
