"""Functions of a system in PyTorch: autograd.Functions of values and of both products."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from pydy._checks import real_array
from pydy._optional import require
from pydy.layers.layer import Function


class TorchArrays:
    """Tensors of PyTorch."""

    def __init__(self) -> None:
        self.torch = require("torch", "torch", "`as_torch`")

    def __reduce__(self) -> Any:
        return TorchArrays, ()  # a module does not pickle

    def array(self, value: Any, argument: str) -> Any:
        """Return a tensor of float64; numbers and arrays are converted."""
        torch = self.torch
        if not isinstance(value, torch.Tensor):
            return torch.as_tensor(real_array(value, argument))
        if not value.is_floating_point() and not value.is_complex():
            return value.to(torch.float64)
        if value.dtype != torch.float64:
            raise TypeError(
                f"{argument} must be of float64, got {value.dtype}: PyTorch creates tensors with "
                "half of the digits unless it is told otherwise. Create it with "
                "dtype=torch.float64, or call torch.set_default_dtype(torch.float64) first."
            )
        return value

    def together(self, columns: list[Any]) -> Any:
        """Return tensors (…, k) side by side."""
        return self.torch.cat(self.alike(columns), dim=-1)

    def alike(self, arrays: list[Any]) -> list[Any]:
        """Return tensors with their leading axes broadcast."""
        lead = np.broadcast_shapes(*(tuple(a.shape[:-1]) for a in arrays))
        return [a.expand(*lead, a.shape[-1]) for a in arrays]

    def call(self, function: Function, given: list[Any]) -> Any:
        """Return the value of a Function."""
        direct, call, transformed = _calls()
        return (call if transformed() else direct).apply(function, *given)


@cache
def _calls() -> tuple[Any, Any, Any]:
    """Return the autograd.Functions of a value, and the rule that selects one of them.

    The second one is for the transformations of torch.func. PyTorch binds the arguments of such a
    Function to its signature at each call, which takes longer than most of what is computed.
    """
    import torch

    # Whether a transformation of torch.func is at work; where PyTorch does not tell, one may be.
    transformed = getattr(torch._C, "_are_functorch_transforms_active", lambda: True)
    tangent_of = torch.autograd.forward_ad.unpack_dual

    def numbers(given: Any) -> tuple[np.ndarray, ...]:
        return tuple(a.detach().cpu().numpy() for a in given)

    def tensor(array: np.ndarray, like: Any) -> Any:
        return torch.from_numpy(np.ascontiguousarray(array)).to(like.device)

    def in_front(given: Any, axes: Any, size: int) -> list[Any]:
        return [
            a.movedim(k, 0) if k is not None else a.expand(size, *a.shape)
            for a, k in zip(given, axes, strict=True)
        ]

    def products(function: Function, wanted: tuple[int, ...], *given: Any) -> tuple[Any, ...]:
        *arrays, weights = numbers(given)
        found = function.backward(wanted, tuple(arrays), weights)
        return tuple(tensor(one, given[0]) for one in found)

    def keep(ctx: Any, function: Function, given: Any) -> None:
        ctx.function = function
        ctx.save_for_backward(*given)
        ctx.save_for_forward(*given)

    class Value(torch.autograd.Function):  # type: ignore[misc]
        """The value of a Function."""

        @staticmethod
        def backward(ctx: Any, weights: Any) -> Any:
            wanted = tuple(k for k, need in enumerate(ctx.needs_input_grad[1:]) if need)
            given = ctx.saved_tensors
            # A product that is to be differentiated in turn, and so refused, is a Function too.
            differentiated = torch.is_grad_enabled() or transformed()
            if not differentiated:
                differentiated = any(tangent_of(a).tangent is not None for a in (*given, weights))
            product = Back.apply if differentiated else products
            found = product(ctx.function, wanted, *given, weights)
            result: list[Any] = [None] * (1 + len(given))
            for k, one in zip(wanted, found, strict=True):
                result[1 + k] = one
            return tuple(result)

        @staticmethod
        def jvp(ctx: Any, _: Any, *along: Any) -> Any:
            wanted = tuple(k for k, d in enumerate(along) if d is not None)
            return Ahead.apply(
                ctx.function, wanted, *ctx.saved_tensors, *(along[k] for k in wanted)
            )

    class Direct(Value):
        """The same without torch.func."""

        @staticmethod
        def forward(ctx: Any, function: Function, *given: Any) -> Any:
            keep(ctx, function, given)
            return tensor(function.value(*numbers(given)), given[0])

    class Call(Value):
        """The same under torch.func."""

        @staticmethod
        def forward(function: Function, *given: Any) -> Any:
            return tensor(function.value(*numbers(given)), given[0])

        @staticmethod
        def setup_context(ctx: Any, inputs: Any, output: Any) -> None:
            keep(ctx, inputs[0], inputs[1:])

        @staticmethod
        def vmap(info: Any, axes: Any, function: Function, *given: Any) -> Any:
            return Call.apply(function, *in_front(given, axes[1:], info.batch_size)), 0

    class Product(torch.autograd.Function):  # type: ignore[misc]
        """A product with the Jacobian of a Function."""

        @staticmethod
        def setup_context(ctx: Any, inputs: Any, output: Any) -> None:
            pass

        @staticmethod
        def backward(ctx: Any, *_: Any) -> Any:
            raise NotImplementedError(
                "Functions of as_torch have first derivatives only. For second ones of a quantity "
                "use system.evaluate_hessian_vector."
            )

    class Ahead(Product):
        """The Jacobian of a Function times directions, which come last."""

        @staticmethod
        def forward(function: Function, wanted: tuple[int, ...], *given: Any) -> Any:
            arrays, k = numbers(given), len(function.parts)
            return tensor(function.forward(wanted, arrays[:k], arrays[k:]), given[0])

        @staticmethod
        def vmap(info: Any, axes: Any, function: Function, wanted: Any, *given: Any) -> Any:
            return Ahead.apply(function, wanted, *in_front(given, axes[2:], info.batch_size)), 0

    class Back(Product):
        """Weights, which come last, times the Jacobian of a Function."""

        @staticmethod
        def forward(function: Function, wanted: tuple[int, ...], *given: Any) -> Any:
            return products(function, wanted, *given)

        @staticmethod
        def vmap(info: Any, axes: Any, function: Function, wanted: Any, *given: Any) -> Any:
            found = Back.apply(function, wanted, *in_front(given, axes[2:], info.batch_size))
            return found, (0,) * len(found)

    return Direct, Call, transformed
