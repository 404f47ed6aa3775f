"""The implementation of a generated function: kernels, the orders of arrays, the parsing of r, p.

The function tries the compiled code first, with its arguments as they are. The code answers −1
when they are not float64 vectors of the right length; only then are they converted and checked.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from inspect import Parameter, signature
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef

from pydy._assembly import CompiledModel, singular_mass_matrix
from pydy._backends import refusal, resolve
from pydy._checks import number, real_array, vector
from pydy._forks import cached_property
from pydy._kernel import Inputs, Kernel, KernelCall
from pydy._names import distinguished, nearest
from pydy.codegen.arguments import ConstantsArgument, SpecifiedsArgument, SpecifiedsPlan
from pydy.inputs import SampledInput

if TYPE_CHECKING:
    from pydy._sympy_types import SymbolOrName

# -- The docstring of a generated function: which numbers, in which order --------------------------


_HEAD = """\
Returns the derivatives of the states, i.e. numerically evaluates the right
hand side of the first order differential equation.

x' = f({arguments})

Parameters
==========
"""

_STATES = """\
x : ndarray, shape({n},)
    The state vector is ordered as such:
{states}
"""

_TIME = """\
t : float
    The current time.
"""

_SPECIFIEDS = {
    None: """\
r : dictionary; ndarray, shape({s},); function

    There are three options for this argument. (1) is more flexible but
    (2) and (3) are much more efficient.

    (1) A dictionary that maps the specified functions of time to floats,
    ndarrays, or functions that produce ndarrays. The keys can be a single
    specified symbolic function of time or a tuple of symbols. The total
    number of symbols must be equal to {s}. If the value is a
    function it must be of the form {g}, where x is the current state
    vector ndarray and t is the current time float and it must return an
    ndarray of the correct shape. For example::

      r = {{a: 1.0,
           (d, b) : np.array([1.0, 2.0]),
           (e, f) : lambda {xt}: np.array(x[0], x[1]),
           c: lambda {xt}: np.array(x[2])}}

    (2) A ndarray with the specified values in the correct order and of the
    correct shape.

    (3) A function that must be of the form {g}, where x is the current
    state vector and t is the current time and it must return an ndarray of
    the correct shape.

    The specified inputs are, in order:
{specifieds}
""",
    "dictionary": """\
r : dictionary
    Maps the specified functions of time, or tuples of them, to floats,
    ndarrays or functions of the form {g} that return them. The total
    number of symbols must be equal to {s}:
{specifieds}
""",
    "array": """\
r : ndarray, shape({s},)
    The values of the specified inputs, in order:
{specifieds}
""",
    "function": """\
r : function
    A function of the form {g} that returns an ndarray, shape({s},), of
    the specified inputs, in order:
{specifieds}
""",
}

_CONSTANTS = {
    None: """\
p : dictionary len({k}) or ndarray shape({k},)
    Either a dictionary that maps the constants symbols to their numerical
    values or an array with the constants in the following order:
{constants}
""",
    "dictionary": """\
p : dictionary len({k})
    Maps the constants symbols to their numerical values:
{constants}
""",
    "array": """\
p : ndarray shape({k},)
    The numerical values of the constants, in order:
{constants}
""",
}

_RETURNS = """
Returns
=======
dx : ndarray, shape({n},)
    The derivative of the state vector.
"""

_OUTPUTS = """\
y : ndarray, shape({o},)
    Values of the provided outputs.
{outputs}
"""


def _items(names: Sequence[SymbolOrName]) -> str:
    labels = distinguished(names, [_name(name) for name in names])
    return "\n".join(f"        - {name}" for name in labels)


def _name(symbol: SymbolOrName) -> str:
    """Return a symbol's name, a hundred times faster than SymPy's printer."""
    if isinstance(symbol, sm.Symbol):
        return str(symbol.name)
    if isinstance(symbol, AppliedUndef):
        return f"{symbol.func.__name__}({', '.join(map(_name, symbol.args))})"
    return str(symbol)


# -- The function ----------------------------------------------------------------------------------


_NOTHING = np.empty(0)
# The arguments of a generated function, as users pass them.
Arguments: TypeAlias = tuple[Any, ...]


class RightHandSide:
    """The implementation of a generated function: a model, and how its arguments are read."""

    def __init__(
        self,
        model: CompiledModel,
        *,
        constants_arg_type: str | None = None,
        specifieds_arg_type: str | None = None,
        time_first: bool = False,
        any_layout: bool = False,
        judge: Callable[[object], None] | None = None,
    ) -> None:
        self.model = model
        # Called with the state of the first call alone, the start of most integrations: the states
        # of later calls may be stages of a step, which need not satisfy anything.
        self.judge = judge
        self.layout = model.layout
        self.time_first = time_first
        self.num_outputs = len(model.assembly.blocks.ordinary)
        self.constants = ConstantsArgument(model.layout.constants, constants_arg_type)
        self.specifieds = SpecifiedsArgument(
            model.layout.specifieds, specifieds_arg_type, time_first
        )
        forced = getattr(model.backend, "force_c_contiguous", True)
        self.refuse_strided = not (any_layout if forced is None else forced)

    @cached_property
    def kernel(self) -> Kernel:
        """The Kernel of the function's values."""
        return self.model.compiled(*self.model.assembly.blocks.of_function)

    def docstring(self) -> str:
        """Return the docstring that users read with help()."""
        layout, outputs = self.layout, self.num_outputs
        xt = "t, x" if self.time_first else "x, t"
        values = {
            "arguments": ", ".join([xt, *(["r"] if layout.specifieds else []), "p"]),
            "xt": xt,
            "g": f"g({xt})",
            "n": len(layout.states),
            "s": len(layout.specifieds),
            "k": len(layout.constants),
            "o": outputs,
            "states": _items(layout.states),
            "specifieds": _items(layout.specifieds),
            "constants": _items(layout.constants),
            "outputs": _items([f"y{i}(t)" for i in range(outputs)]),
        }
        parts = [_HEAD, *((_TIME, _STATES) if self.time_first else (_STATES, _TIME))]
        if layout.specifieds:
            parts.append(_SPECIFIEDS[self.specifieds.arg_type])
        parts += [_CONSTANTS[self.constants.arg_type], _RETURNS]
        if outputs:
            parts.append(_OUTPUTS)
        return "".join(part.format(**values) for part in parts)

    def function(self) -> Any:
        """Return the function of r.h.s. values, with the fast path inlined in its closure."""
        kernel, slow = self.kernel, self._convert_and_call
        call = kernel.gate  # `slow` compiles it if needed: solvers may use the optimised code only
        n, total = len(self.layout.states), len(self.layout.states) + self.num_outputs
        empty, nothing, swapped = np.empty, _NOTHING, self.time_first
        plain_p, plain_r = self.constants.numeric_array, self.specifieds.numeric_array
        if self.layout.specifieds:

            def evaluate(args: Arguments) -> np.ndarray:
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

            def evaluate(args: Arguments) -> np.ndarray:
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

        function: Any = rhs if self.judge is None else self._judged(rhs, self.judge)
        function.native = self.native
        return function

    def _judged(
        self, evaluate: Callable[..., Any], judge: Callable[[object], None]
    ) -> Callable[..., Any]:
        """Return the function with a check of the state of its first call."""
        pending, state = [judge], int(self.time_first)

        def rhs(*args: Any) -> Any:
            out = evaluate(*args)
            while pending:
                pending.pop()(args[state])
            return out

        return rhs

    def native(self, args: Arguments) -> KernelCall | None:
        """Return how native solvers call the function with these `args`, or None."""
        symbols = self.layout.specifieds
        if self.time_first or self.num_outputs or len(args) != (2 if symbols else 1):
            return None
        p, inputs = self.constants(args[-1]), self._no_inputs
        if symbols:
            r = args[0]
            if isinstance(r, SampledInput):
                r = {symbols: r}
            if isinstance(r, Mapping):
                plan = SpecifiedsPlan(r, symbols, complete=True)
                if plan.expressions:
                    return None
                inputs = plan.inputs
            elif callable(r):
                return None
            else:
                inputs = Inputs(self.specifieds(r, _NOTHING, 0.0))
        return native_call(self.model, self.kernel, inputs, p)

    @cached_property
    def _no_inputs(self) -> Inputs:
        return Inputs(np.zeros(len(self.layout.specifieds)))

    # -- the slow path ----------------------------------------------------------------------------

    def _wrong_count(self, args: Arguments) -> TypeError:
        first = "t, x" if self.time_first else "x, t"
        names = f"{first}, r, p" if self.layout.specifieds else f"{first}, p"
        return TypeError(f"rhs({names}) takes {names.count(',') + 1} arguments, got {len(args)}.")

    def _convert_and_call(self, x: object, t: object, r: Any, p: object, out: np.ndarray) -> None:
        if self.refuse_strided and isinstance(x, np.ndarray) and not x.flags.c_contiguous:
            raise ValueError(
                "`x` must be a C-contiguous array, because `force_c_contiguous` is False: pass "
                "np.ascontiguousarray(x), or generate the function with force_c_contiguous=True."
            )
        x, t = _state(self.model, x), number(t, "`t`")
        if self.layout.specifieds:
            r = self.specifieds(r, x, t)
        if self.kernel.at(x, t, r, self.constants(p), out):
            raise singular_mass_matrix(self.layout, t, x)


def rates_function(model: CompiledModel, inputs: Inputs) -> Any:
    """Return ``f(x, t, r, p)`` for solvers; if inputs are not constant, r is computed from them."""
    kernel = model.compiled("rates")
    empty, n = np.empty, len(model.layout.states)
    call = kernel.gate

    def f(x: Any, t: float, r: Any, p: Any) -> np.ndarray:
        out = empty(n)
        if call(x, t, r, p, out):
            x, t = _state(model, x), number(t, "`t`")
            if kernel.at(x, t, _specifieds(model, r), _constants(model, p), out):
                raise singular_mass_matrix(model.layout, t, x)
        return out

    def f_with_functions(x: object, t: float, r: object, p: object) -> np.ndarray:
        x = _state(model, x)
        return f(x, t, inputs(x, float(t)), p)

    chosen: Any = f if inputs.constant else f_with_functions

    def native(args: Arguments) -> KernelCall:
        r, p = args
        numbers = Inputs(_specifieds(model, r)) if inputs.constant else inputs
        return native_call(model, kernel, numbers, p)

    chosen.native = native
    return chosen


def native_call(model: CompiledModel, kernel: Kernel, inputs: Inputs, p: object) -> KernelCall:
    """Return how native solvers call a Kernel of the derivatives."""
    return KernelCall(
        kernel,
        _constants(model, p),
        inputs,
        lambda: tuple(map(str, model.layout.states)),
        None if model.solver else lambda: model.compiled_jacobian("rates", "x"),
    )


def _specifieds(model: CompiledModel, r: object) -> np.ndarray:
    return vector(r, len(model.layout.specifieds), "`r`, the specifieds,")


def _constants(model: CompiledModel, p: object) -> np.ndarray:
    return vector(p, len(model.layout.constants), "`p`, the constants,")


def _state(model: CompiledModel, x: object) -> np.ndarray:
    n = len(model.layout.states)
    array = real_array(x, "`x`")
    if array.shape != (n,):
        raise ValueError(
            f"`x` must have the shape ({n},), one value for each state, got {array.shape}."
        )
    return array


def make_backend(generator: object, options: dict[str, Any]) -> Any:
    """Return a back end with its options, or say which options it has."""
    backend = resolve(generator)
    try:
        parameters = list(signature(backend).parameters.values())
    except ValueError:  # a class that is not written in Python may have none
        parameters = [Parameter("options", Parameter.VAR_KEYWORD)]
    option_names = [p.name for p in parameters]
    open_ended = any(p.kind is Parameter.VAR_KEYWORD for p in parameters)
    unknown = [] if open_ended else [name for name in options if name not in option_names]
    if unknown:
        raise TypeError(
            f"generate_ode_function() has no option `{unknown[0]}` for the generator "
            f"{generator!r}. {nearest(unknown[0], option_names)}"
        )
    configured = backend(**options)
    if not hasattr(configured, "compile"):
        raise refusal(backend)
    return configured
