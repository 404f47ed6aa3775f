"""Numerical right-hand sides ``x' = f(x, t, r, p)`` from symbolic equations."""

from __future__ import annotations

import itertools
import weakref
from collections.abc import Callable, Sequence
from types import FunctionType
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols

from pydy._assembly import (
    CompiledModel,
    Form,
    Layout,
    assemble_form,
    resolve_solver,
    solve_symbolically,
)
from pydy._backends import resolve
from pydy._checks import describe, flag, listed, resolved, shown, typed
from pydy._graph import rewriting
from pydy._mechanics import find_symbols
from pydy.codegen.arguments import checked_expression
from pydy.codegen.right_hand_side import RightHandSide, make_backend

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, SymbolOrName

__all__ = ["generate_ode_function"]
__dir__ = __all__.copy

_GENERATORS = {
    "ODEFunctionGenerator": "your own class",
    "LambdifyODEFunctionGenerator": "'lambdify'",
    "CythonODEFunctionGenerator": "'cython'",
    "TheanoODEFunctionGenerator": "'llvm'",
}


def __getattr__(name: str) -> Any:
    if name in _GENERATORS:  # an AttributeError would lose its message in `from … import`
        raise ImportError(
            f"There is no `{name}`: use generate_ode_function(..., generator={_GENERATORS[name]}). "
            'See "Run scripts written for PyDy 0.9 and other versions" in the documentation.',
            name=__name__,
        )
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


# Expressions in order, and those of a matrix, as users give them.
Column: TypeAlias = sm.MatrixBase | sm.MatrixExpr | np.ndarray | Sequence[sm.Expr | float]
Matrix: TypeAlias = sm.MatrixBase | sm.MatrixExpr | np.ndarray | Sequence[Sequence[sm.Expr | float]]


def generate_ode_function(
    right_hand_side: Column,
    coordinates: Sequence[SymbolOrName],
    speeds: Sequence[SymbolOrName],
    constants: Sequence[SymbolOrName] = (),
    mass_matrix: Matrix | None = None,
    coordinate_derivatives: Column | None = None,
    specifieds: Sequence[SymbolOrName] | None = None,
    outputs: Column | None = None,
    linear_sys_solver: str | Callable[..., np.ndarray] | None = "builtin",
    constants_arg_type: str | None = None,
    specifieds_arg_type: str | None = None,
    time_first: bool = False,
    generator: str | type = "llvm",
    **generator_options: Any,
) -> Callable[..., Any]:
    """Return a function that evaluates the derivatives of the states.

    The equations are given in one of three forms::

        [1]  x' = F(x, t, r, p)
        [2]  M(x, t, r, p) x' = F(x, t, r, p)
        [3]  M(q, t, r, p) u' = F(x, t, r, p),  q' = G(q, u, t, r, p)

    where the states x are the coordinates q and then the speeds u, t is time, r are the specifieds
    and p the constants.

    Parameters
    ----------
    right_hand_side : Matrix, shape (n, 1), or sequence of expressions
        F; n is the number of states for [1] and [2], the number of speeds for [3].
    coordinates : sequence of functions of time, or a Matrix with one column
        The generalized coordinates q.
    speeds : sequence of functions of time, or a Matrix with one column
        The generalized speeds u.
    constants : sequence of Symbol, optional
        In the order of the array p.
    mass_matrix : Matrix, shape (n, n), optional
        M, for [2] and [3].
    coordinate_derivatives : Matrix, shape (m, 1), or sequence of expressions, optional
        G, for [3].
    specifieds : sequence of functions of time, optional
        In the order of the array r. Without any, the function is called without r.
    outputs : Matrix or sequence of expressions, optional
        Evaluated together with the derivatives. They may contain the derivatives of the states.
    linear_sys_solver : {'builtin', 'numpy', 'scipy', 'sympy', 'sympy:METHOD'} or callable, optional
        What solves for the derivatives in [2] and [3]: by default LU with partial pivoting in the
        compiled code. 'sympy' solves symbolically first. A callable is used as ``solve(A, b)``.
    constants_arg_type : {None, 'array', 'dictionary'}, optional
        How p will be given; None looks at each call.
    specifieds_arg_type : {None, 'array', 'dictionary', 'function'}, optional
        How r will be given; None looks at each call.
    time_first : bool, optional
        Whether the function is called ``rhs(t, x, ...)``, and functions in r ``g(t, x)``.
    generator : {'llvm', 'lambdify', 'cython'} or class, optional
        What turns the equations into code: LLVM in this process (default, no compiler needed),
        NumPy, C through Cython, or a class of your own with a method ``compile(program)`` (see
        `pydy._backends.base`).
    **generator_options
        Keyword arguments of the generator. All take ``cse``; 'cython' takes ``prefix``,
        ``tmp_dir``, ``verbose`` and ``force_c_contiguous`` too.

    Returns
    -------
    rhs : function
        ``rhs(x, t, r, p)``, without r when there are no specifieds. It returns the derivatives,
        shape (n,), or the derivatives and the outputs, shapes (n,) and (o,). The arrays are fresh
        at every call. Its docstring lists the orders.

    Raises
    ------
    ValueError
        The shapes do not fit the form, a symbol occurs that no argument provides, or an option has
        no such value.
    NotImplementedError
        The generator is not known, or the expressions hold a function that cannot be translated.

    Notes
    -----
    A singular mass matrix raises a subclass of `numpy.linalg.LinAlgError` that tells time and
    state, when the function is called.

    Examples
    --------
    A pendulum of length l, in the first form:

    >>> import sympy as sm
    >>> from sympy.physics.mechanics import dynamicsymbols
    >>> from pydy.codegen.ode_function_generators import generate_ode_function
    >>> q, u = dynamicsymbols('q, u')
    >>> g, l = sm.symbols('g, l')
    >>> rhs = generate_ode_function([u, -g/l*sm.sin(q)], [q], [u], [g, l])
    >>> rhs([sm.pi.evalf()/2, 1.0], 0.0, [9.81, 2.0])
    array([ 1.   , -4.905])
    """
    time = dynamicsymbols._t
    time_first = flag(time_first, "`time_first`")
    force = _column("right_hand_side", right_hand_side)
    if mass_matrix is not None:
        mass_matrix = _explicit("mass_matrix", mass_matrix)
    first = None
    if coordinate_derivatives is not None:
        first = _column("coordinate_derivatives", coordinate_derivatives)
    parts = (force, first or (), () if mass_matrix is None else mass_matrix)
    q = _symbols("coordinates", coordinates, parts, time)
    u = _symbols("speeds", speeds, parts, time)
    p = _symbols("constants", constants, parts, time)
    r = _symbols("specifieds", () if specifieds is None else specifieds, parts, time)
    _refuse_repeated([*q, *u, *r, *p])
    matrix = _check_form(force, q, u, mass_matrix, first)
    solver = resolve_solver(linear_sys_solver)
    if isinstance(solver, str) and matrix is not None:
        solved = solve_symbolically(matrix, force, solver)
        force, matrix, first = [*(first or []), *solved], None, None
    if matrix is None:
        solver = None
    values = [] if outputs is None else _column("outputs", outputs)
    backend = resolve(generator)
    if hasattr(backend, "generate") and not hasattr(backend, "compile"):
        # A class in the manner of PyDy 0.9 gets the symbolic arguments as they came.
        function: Callable[..., Any] = backend(
            right_hand_side,
            coordinates,
            speeds,
            constants,
            mass_matrix=mass_matrix,
            coordinate_derivatives=coordinate_derivatives,
            specifieds=specifieds,
            linear_sys_solver=linear_sys_solver,
            constants_arg_type=constants_arg_type,
            specifieds_arg_type=specifieds_arg_type,
            **generator_options,
        ).generate()
        return function
    off = frozenset() if flag(generator_options.get("cse", True), "`cse`") else rewriting()
    external = callable(solver)
    form = Form(force, q, u, p, r, time, matrix, first, values)
    assembly = assemble_form(form, external=external, off=off)
    return make_function(
        RightHandSide(
            CompiledModel(
                Layout((*q, *u), tuple(r), tuple(p)),
                assembly,
                make_backend(generator, generator_options),
                solver if callable(solver) else None,
            ),
            constants_arg_type=constants_arg_type,
            specifieds_arg_type=specifieds_arg_type,
            time_first=time_first,
        )
    )


def _symbols(
    argument: str, value: object, parts: Sequence[Column], time: sm.Symbol
) -> list[AnySymbol]:
    """Return a user's list of symbols, with names replaced by the symbols of the equations."""
    symbols = listed(argument, value, hashable=True)
    if any(isinstance(s, str) for s in symbols):
        equation_symbols = find_symbols([e for part in parts for e in sm.Matrix(part)])
        equation_symbols.pop(time, None)
        symbols = resolved(argument, symbols, equation_symbols, "symbols of the equations")
    if time in symbols:
        raise ValueError(
            f"`{argument}` has `{time}`, which is time in the equations: its value would be "
            "ignored. Rename the symbol, or set `dynamicsymbols._t` to another one before the "
            "equations are derived."
        )
    for symbol in symbols:
        if not isinstance(symbol, (sm.Symbol, AppliedUndef, sm.Derivative)):
            raise ValueError(
                f"`{argument}` must hold symbols or functions of time, got {shown(symbol)}."
            )
    return symbols


def _column(argument: str, value: object) -> list[sm.Expr]:
    """Return a column matrix or a sequence of expressions as a list."""
    value = _explicit(argument, value)
    if isinstance(value, sm.MatrixBase):
        if 1 not in value.shape and 0 not in value.shape:
            raise ValueError(f"`{argument}` must be a column, got the shape {value.shape}.")
        return list(value)
    if isinstance(value, (set, frozenset)):
        raise TypeError(f"`{argument}` must be in order, got {typed(value)}.")
    entries = listed(argument, value, "expressions, or a column matrix")
    # Rows of a column are taken too.
    rows = [e[0] if isinstance(e, np.ndarray) and e.shape == (1,) else e for e in entries]
    return [checked_expression(e, f"`{argument}`") for e in rows]


def _explicit(argument: str, value: Any) -> Any:
    """Return a matrix expression, such as a BlockMatrix, as a matrix; all else as it is."""
    if not isinstance(value, sm.MatrixExpr):
        return value
    try:
        return value.as_explicit()
    except (ValueError, TypeError, NotImplementedError) as error:
        raise ValueError(
            f"`{argument}` must be a matrix of expressions, got {typed(value)}, "
            f"whose entries are not known: {error}"
        ) from error


def _check_form(
    force: list[sm.Expr],
    q: list[AnySymbol],
    u: list[AnySymbol],
    mass_matrix: Matrix | None,
    first: list[sm.Expr] | None,
) -> sm.MatrixBase | None:
    """Return the mass matrix, or None for the form [1], after checking that shapes fit."""
    n = len(q) + len(u)
    if mass_matrix is None:
        if first is not None:
            raise ValueError(
                "`coordinate_derivatives` are given without `mass_matrix`: the form M u' = F with "
                "q' = G needs both."
            )
        _check_length("right_hand_side", force, n, "states (form [1], x' = F)")
        return None
    matrix = _matrix(mass_matrix)
    if first is None:
        size, form = n, "states (form [2], M x' = F)"
    else:
        size, form = len(u), "speeds (form [3], M u' = F with q' = G)"
        _check_length("coordinate_derivatives", first, len(q), "coordinates")
    _check_length("right_hand_side", force, size, form)
    if matrix.shape != (size, size):
        raise ValueError(
            f"`mass_matrix` must have the shape ({size}, {size}), one row for each of the {form}, "
            f"got {matrix.shape}."
        )
    return matrix


def _matrix(value: Matrix) -> sm.MatrixBase:
    """Return a mass matrix of any type as SymPy's."""
    if isinstance(value, sm.MatrixBase):
        return value
    rows = [listed("mass_matrix", row, "rows") for row in listed("mass_matrix", value, "rows")]
    if len({len(row) for row in rows}) > 1:
        raise ValueError("`mass_matrix` must have rows of one length.")
    return sm.Matrix([[checked_expression(e, "`mass_matrix`") for e in row] for row in rows])


def _check_length(argument: str, value: list[sm.Expr], size: int, rows: str) -> None:
    if len(value) != size:
        raise ValueError(
            f"`{argument}` must have {size} entries, one for each of the {rows}, got {len(value)}."
        )


def _refuse_repeated(symbols: list[AnySymbol]) -> None:
    repeated = sorted({str(s) for s in symbols if symbols.count(s) > 1})
    if repeated:
        raise ValueError(
            "`coordinates`, `speeds`, `specifieds` and `constants` must have each symbol once, got "
            f"more than once: {describe(repeated)}."
        )


# -- the function itself --------------------------------------------------------------------------

# A function made at run time cannot be found by name where it is unpickled. Its qualified name is
# therefore a string that pickles as "make the function again, and here is its new name", under
# which the unpickler finds it in `generated`. `type(rhs)` stays a plain function, which is what
# help() and inspect describe as users expect. (The dot in the name matters: for a name without
# one, pickle's C code writes a plain copy of the string.)
_COUNTER = itertools.count(1)


class _FunctionRegistry:
    """The generated functions that are alive, by name."""

    def __init__(self) -> None:
        self._alive: weakref.WeakValueDictionary[str, FunctionType] = weakref.WeakValueDictionary()
        self._restored: dict[str, FunctionType] = {}

    def keep(self, name: str, function: FunctionType) -> None:
        self._alive[name] = function

    def restore(self, name: str) -> None:
        # A strong reference until the unpickler has looked the name up.
        self._restored[name] = self._alive[name]

    def __getattr__(self, name: str) -> _Handle:
        if name.startswith("_"):
            raise AttributeError(name)
        function = self._restored.pop(name, None)
        if function is None:
            function = self._alive.get(name)
        if function is None:
            raise AttributeError(f"there is no generated function {name!r}")
        return _Handle(function)


class _Handle:
    """The last part of a function's qualified name; old pickle protocols get the function here."""

    def __init__(self, rhs: Any) -> None:
        self.rhs = rhs

    def __reduce__(self) -> tuple[object, ...]:
        return (_handle, (self.rhs.__qualname__.implementation,))


def _handle(implementation: RightHandSide) -> _Handle:
    return _Handle(make_function(implementation))


generated = _FunctionRegistry()


class _Name(str):
    """The qualified name of a generated function, which pickles as its implementation."""

    implementation: RightHandSide

    def __reduce__(self) -> tuple[object, ...]:
        return (_restore, (self.implementation,))


def _restore(implementation: RightHandSide) -> str:
    rhs = make_function(implementation)  # nothing else holds it as yet
    name = str.__str__(rhs.__qualname__)
    generated.restore(name.split(".")[1])
    return name


def make_function(implementation: RightHandSide) -> FunctionType:
    """Wrap an implementation as the function that users see."""
    rhs: FunctionType = implementation.function()
    name = f"rhs_{next(_COUNTER)}"
    qualified = _Name(f"generated.{name}.rhs")
    qualified.implementation = implementation
    rhs.__name__ = "rhs"
    rhs.__qualname__ = qualified
    rhs.__module__ = __name__
    rhs.__doc__ = implementation.docstring()
    generated.keep(name, rhs)
    return rhs
