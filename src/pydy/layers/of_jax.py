"""Functions of a system in JAX: primitives with rules for vmap and for both ways to differentiate.

`jax.pure_callback` would do with a custom_vjp, but moves its arguments through JAX's Python twice:
a call costs 150 µs where the callback that XLA makes by itself takes 10. A primitive also has
derivatives in both directions, which custom_vjp has not.
"""

from __future__ import annotations

from functools import cache, lru_cache
from typing import Any

import numpy as np

from pydy._checks import check_copied, real_array, shown
from pydy._optional import require
from pydy.layers.layer import Function


class JaxArrays:
    """Arrays of JAX."""

    def __init__(self) -> None:
        self.jax = require("jax", "jax", "`as_jax`")
        _primitives()
        self._check()

    def __reduce__(self) -> Any:
        return JaxArrays, ()  # a module does not pickle

    def _check(self) -> None:
        if not self.jax.config.jax_enable_x64:
            raise TypeError(
                "JAX computes with float32 unless it is told otherwise, which would lose half of "
                "the digits of a simulation. Call jax.config.update('jax_enable_x64', True) before "
                "anything else is done with JAX."
            )

    def array(self, value: Any, argument: str) -> Any:
        """Return an array of float64; numbers and arrays of integers are converted."""
        self._check()
        jnp = self.jax.numpy
        check_copied(value, argument)
        try:
            leaves = self.jax.tree.leaves(value)
            traced = any(isinstance(leaf, self.jax.Array) for leaf in leaves)
        except RecursionError:
            traced = False
        plain = value if traced else _plain(value, argument)
        try:
            array = jnp.asarray(plain)
        except (TypeError, ValueError, OverflowError, RecursionError):
            # JAX names neither the argument nor what it may be; its tracers raise other errors.
            raise TypeError(
                f"{argument} must be an array of JAX, of float64, or numbers, got {shown(value)}."
            ) from None
        if jnp.issubdtype(array.dtype, jnp.integer):
            array = array.astype(jnp.float64)
        if array.dtype != np.float64:
            raise TypeError(
                f"{argument} must be of float64, got {array.dtype}. Create it as such: "
                "jax.numpy.asarray(values, dtype='float64')."
            )
        return array

    def together(self, columns: list[Any]) -> Any:
        """Return arrays (…, k) side by side."""
        return self.jax.numpy.concatenate(self.alike(columns), axis=-1)

    def alike(self, arrays: list[Any]) -> list[Any]:
        """Return arrays with their leading axes broadcast."""
        jnp = self.jax.numpy
        lead = np.broadcast_shapes(*(a.shape[:-1] for a in arrays))
        return [jnp.broadcast_to(a, (*lead, a.shape[-1])) for a in arrays]

    def call(self, function: Function, given: list[Any]) -> Any:
        """Return the value of a Function."""
        value, _, _ = _primitives()
        return value.bind(*given, function=function)


def _plain(value: Any, argument: str) -> np.ndarray:
    """Return numbers as an array, or name the argument that holds others.

    An array of fewer digits stays one, which is refused: they may have been lost by mistake.
    """
    numbers = real_array(value, argument)
    narrow = getattr(getattr(value, "dtype", None), "kind", "") == "f"
    return np.asarray(value) if narrow else numbers


@cache
def _primitives() -> tuple[Any, Any, Any]:
    """Return the primitives of values, and of products with the Jacobian from both sides.

    The operands of all have the same leading axes. After the arguments of the function, `forward`
    takes a direction for each that is wanted, and `backward` one array of weights.
    """
    from jax.core import ShapedArray
    from jax.extend.core import Primitive
    from jax.interpreters import ad, batching, mlir

    value, forward, backward = (Primitive(f"pydy_{name}") for name in _HOSTS)
    backward.multiple_results = True

    def rules(primitive: Any, host: Any, back: bool) -> None:
        def shaped(*given: Any, function: Function, wanted: tuple[int, ...] = ()) -> Any:
            if back:
                return [given[k].update() for k in wanted]
            return ShapedArray((*given[0].shape[:-1], *function.shape), np.dtype(float))

        def lowered(ctx: Any, *given: Any, **told: Any) -> Any:
            def called(*arrays: Any) -> Any:
                found = host(tuple(map(np.asarray, arrays)), **told)
                return found if back else (found,)

            result, _, _ = mlir.emit_python_callback(
                ctx, called, None, given, ctx.avals_in, ctx.avals_out, has_side_effect=False
            )
            return result

        def batched(given: Any, axes: Any, **told: Any) -> Any:
            sizes = [a.shape[k] for a, k in zip(given, axes, strict=True) if k is not None]
            found = primitive.bind(
                *(batching.bdim_at_front(a, k, sizes[0]) for a, k in zip(given, axes, strict=True)),
                **told,
            )
            return found, ([0] * len(found) if back else 0)

        primitive.def_abstract_eval(shaped)
        primitive.def_impl(
            lambda *given, **told: _jit(primitive, tuple(sorted(told.items())))(*given)
        )
        mlir.register_lowering(primitive, lowered)
        batching.primitive_batchers[primitive] = batched

    for primitive, host in zip((value, forward, backward), _HOSTS.values(), strict=True):
        rules(primitive, host, primitive is backward)

    def differentiated(given: Any, along: Any, function: Function) -> Any:
        wanted = tuple(k for k, d in enumerate(along) if not isinstance(d, ad.Zero))
        directions = [ad.instantiate_zeros(along[k]) for k in wanted]
        slope = forward.bind(*given, *directions, function=function, wanted=wanted)
        return value.bind(*given, function=function), slope

    def moved(primitive: Any) -> Any:
        """Return the rule for a function that is linear in its tangents."""

        def rule(given: Any, along: Any, function: Function, wanted: tuple[int, ...]) -> Any:
            k = len(function.parts)
            if not all(isinstance(d, ad.Zero) for d in along[:k]):
                raise NotImplementedError(
                    "Functions of as_jax have first derivatives only. For second ones of a "
                    "quantity use system.evaluate_hessian_vector."
                )
            linear = [ad.instantiate_zeros(d) for d in along[k:]]
            told = {"function": function, "wanted": wanted}
            return primitive.bind(*given, **told), primitive.bind(*given[:k], *linear, **told)

        return rule

    def turned(weights: Any, *given: Any, function: Function, wanted: tuple[int, ...]) -> Any:
        k = len(function.parts)
        if isinstance(weights, ad.Zero):
            return [None] * len(given)
        found = backward.bind(*given[:k], weights, function=function, wanted=wanted)
        return [None] * k + [*found]

    def turned_back(along: Any, *given: Any, function: Function, wanted: tuple[int, ...]) -> Any:
        k = len(function.parts)
        directions = [ad.instantiate_zeros(d) for d in along]
        return [None] * k + [
            forward.bind(*given[:k], *directions, function=function, wanted=wanted)
        ]

    ad.primitive_jvps[value] = differentiated
    ad.primitive_jvps[forward], ad.primitive_jvps[backward] = moved(forward), moved(backward)
    ad.primitive_transposes[forward] = turned
    ad.primitive_transposes[backward] = turned_back
    return value, forward, backward


@lru_cache(maxsize=64)
def _jit(primitive: Any, told: tuple[tuple[str, Any], ...]) -> Any:
    """Return the compiled form for a call that nothing traces."""
    import jax

    return jax.jit(lambda *given: primitive.bind(*given, **dict(told)))


_HOSTS = {
    "value": lambda given, function: function.value(*given),
    "forward": lambda given, function, wanted: function.forward(
        wanted, given[: len(function.parts)], given[len(function.parts) :]
    ),
    "backward": lambda given, function, wanted: function.backward(wanted, given[:-1], given[-1]),
}
