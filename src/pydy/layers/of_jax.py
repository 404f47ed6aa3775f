"""Functions of a system in JAX: primitives with rules for vmap, forward and reverse derivatives.

The alternative, `jax.pure_callback` with a custom_vjp, passes its arguments through JAX's Python
code twice: a call takes 150 µs, and XLA's own callback 10 µs. A custom_vjp also has no forward
derivatives.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._checks import check_copied, real_array, shown
from pydy._optional import require
from pydy.layers.layer import LayerFunction

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from jax import Array
    from jax.extend.core import Primitive


class JaxArrays:
    """The adapter of JAX's arrays."""

    def __init__(self) -> None:
        self.jax = require("jax", "jax", "`as_jax`")
        _primitives()
        self._check()

    def __reduce__(self) -> tuple[type[JaxArrays], tuple[()]]:
        return JaxArrays, ()  # a module does not pickle

    def _check(self) -> None:
        if not self.jax.config.jax_enable_x64:
            raise TypeError(
                "JAX computes with float32 unless it is told otherwise, which would lose half of "
                "the digits of a simulation. Call jax.config.update('jax_enable_x64', True) before "
                "anything else is done with JAX."
            )

    def array(self, value: object, argument: str) -> Array:
        """Return an array of float64; numbers and arrays of integers are converted."""
        self._check()
        jnp = self.jax.numpy
        check_copied(value, argument)
        try:
            leaves = self.jax.tree.leaves(value)
            traced = any(isinstance(leaf, self.jax.Array) for leaf in leaves)
        except RecursionError:
            traced = False
        numbers = value if traced else _checked_numbers(value, argument)
        try:
            array: Array = jnp.asarray(numbers)
        except (TypeError, ValueError, OverflowError, RecursionError):
            # JAX's message does not name the argument; its tracers raise other errors.
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

    def concatenate(self, columns: Sequence[Array]) -> Array:
        """Return arrays (…, k), broadcast and concatenated along the last axis."""
        joined: Array = self.jax.numpy.concatenate(self.broadcast(columns), axis=-1)
        return joined

    def broadcast(self, arrays: Sequence[Array]) -> list[Array]:
        """Return arrays with their leading axes broadcast."""
        jnp = self.jax.numpy
        lead = np.broadcast_shapes(*(a.shape[:-1] for a in arrays))
        return [jnp.broadcast_to(a, (*lead, a.shape[-1])) for a in arrays]

    def call(self, function: LayerFunction, arrays: Sequence[Array]) -> Array:
        """Return the value of a LayerFunction."""
        value, _, _ = _primitives()
        result: Array = value.bind(*arrays, function=function)
        return result


def _checked_numbers(value: object, argument: str) -> np.ndarray:
    """Return numbers as an array; raise an error that names the argument for other objects.

    The type of a float32 array is not changed, so that the caller rejects it: digits may have been
    lost by mistake.
    """
    numbers = real_array(value, argument)
    narrow = getattr(getattr(value, "dtype", None), "kind", "") == "f"
    return np.asarray(value) if narrow else numbers


@cache
def _primitives() -> tuple[Primitive, Primitive, Primitive]:
    """Return the primitives of values, Jacobian-vector and vector-Jacobian products.

    The operands of all have the same leading axes. After the arguments of the function, `forward`
    takes a direction for each argument of `wrt`, and `backward` takes one array of weights.
    """
    import jax.numpy as jnp
    from jax.core import ShapedArray
    from jax.extend.core import Primitive
    from jax.interpreters import ad, batching, mlir

    value, forward, backward = (Primitive(f"pydy_{name}") for name in _HOSTS)
    backward.multiple_results = True

    def rules(primitive: Primitive, host: Any, back: bool) -> None:
        def abstract_value(
            *operands: ShapedArray, function: LayerFunction, wrt: tuple[int, ...] = ()
        ) -> ShapedArray | list[ShapedArray]:
            if back:
                return [operands[k].update() for k in wrt]
            return ShapedArray((*operands[0].shape[:-1], *function.shape), np.dtype(float))

        def lowering(ctx: Any, *operands: Any, **params: object) -> Any:
            def callback(*arrays: object) -> Any:
                try:
                    outputs = host(tuple(map(np.asarray, arrays)), **params)
                except Exception as error:
                    # XLA prints all frames before the message: those of this package say nothing.
                    error.__traceback__ = None
                    raise
                return outputs if back else (outputs,)

            result, _, _ = mlir.emit_python_callback(
                ctx, callback, None, operands, ctx.avals_in, ctx.avals_out, has_side_effect=False
            )
            return result

        def batching_rule(
            operands: Sequence[Array], axes: Sequence[int | None], **params: object
        ) -> tuple[object, object]:
            sizes = [a.shape[k] for a, k in zip(operands, axes, strict=True) if k is not None]
            outputs = primitive.bind(
                *(
                    batching.bdim_at_front(a, k, sizes[0])
                    for a, k in zip(operands, axes, strict=True)
                ),
                **params,
            )
            return outputs, ([0] * len(outputs) if back else 0)

        primitive.def_abstract_eval(abstract_value)

        def impl(*operands: Array, **params: object) -> object:
            """Evaluate without XLA, whose callback would turn any error into one of its own."""
            outputs = host(tuple(map(np.asarray, operands)), **params)
            return [jnp.asarray(array) for array in outputs] if back else jnp.asarray(outputs)

        primitive.def_impl(impl)
        mlir.register_lowering(primitive, lowering)
        batching.primitive_batchers[primitive] = batching_rule

    for primitive, host in zip((value, forward, backward), _HOSTS.values(), strict=True):
        rules(primitive, host, primitive is backward)

    def value_jvp(
        operands: Sequence[Array], tangents: Sequence[Array | ad.Zero], function: LayerFunction
    ) -> tuple[Array, Array]:
        wrt = tuple(k for k, d in enumerate(tangents) if not isinstance(d, ad.Zero))
        directions = [ad.instantiate_zeros(tangents[k]) for k in wrt]
        slope = forward.bind(*operands, *directions, function=function, wrt=wrt)
        return value.bind(*operands, function=function), slope

    def linear_rule(primitive: Primitive) -> Callable[..., tuple[object, object]]:
        """Return the JVP rule of a primitive that is linear in its last operands."""

        def rule(
            operands: Sequence[Array],
            tangents: Sequence[Array | ad.Zero],
            function: LayerFunction,
            wrt: tuple[int, ...],
        ) -> tuple[object, object]:
            k = len(function.parts)
            if not all(isinstance(d, ad.Zero) for d in tangents[:k]):
                raise NotImplementedError(
                    "Functions of as_jax have first derivatives only. For second ones of a "
                    "quantity use system.evaluate_hessian_vector."
                )
            linear = [ad.instantiate_zeros(d) for d in tangents[k:]]
            params = {"function": function, "wrt": wrt}
            return primitive.bind(*operands, **params), primitive.bind(
                *operands[:k], *linear, **params
            )

        return rule

    def transpose_forward(
        weights: Array | ad.Zero, *operands: object, function: LayerFunction, wrt: tuple[int, ...]
    ) -> Sequence[object]:
        k = len(function.parts)
        if isinstance(weights, ad.Zero):
            return [None] * len(operands)
        cotangents = backward.bind(*operands[:k], weights, function=function, wrt=wrt)
        return [None] * k + [*cotangents]

    def transpose_backward(
        cotangents: Sequence[Array | ad.Zero],
        *operands: object,
        function: LayerFunction,
        wrt: tuple[int, ...],
    ) -> Sequence[object]:
        k = len(function.parts)
        directions = [ad.instantiate_zeros(d) for d in cotangents]
        return [None] * k + [forward.bind(*operands[:k], *directions, function=function, wrt=wrt)]

    ad.primitive_jvps[value] = value_jvp
    ad.primitive_jvps[forward], ad.primitive_jvps[backward] = (
        linear_rule(forward),
        linear_rule(backward),
    )
    ad.primitive_transposes[forward] = transpose_forward
    ad.primitive_transposes[backward] = transpose_backward
    return value, forward, backward


_HOSTS = {
    "value": lambda operands, function: function.value(*operands),
    "forward": lambda operands, function, wrt: function.forward(
        wrt, operands[: len(function.parts)], operands[len(function.parts) :]
    ),
    "backward": lambda operands, function, wrt: function.backward(wrt, operands[:-1], operands[-1]),
}
