"""Functions of a system in PyTorch: autograd.Functions of values and both Jacobian products."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np

from pydy._checks import real_array
from pydy._optional import require
from pydy.layers.layer import LayerFunction

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from torch import Tensor
    from torch.autograd import Function
    from torch.autograd.function import FunctionCtx


class TorchArrays:
    """The adapter of PyTorch's tensors."""

    def __init__(self) -> None:
        self.torch = require("torch", "torch", "`as_torch`")

    def __reduce__(self) -> tuple[type[TorchArrays], tuple[()]]:
        return TorchArrays, ()  # a module does not pickle

    def array(self, value: object, argument: str) -> Tensor:
        """Return a tensor of float64; numbers and arrays are converted."""
        torch = self.torch
        if not isinstance(value, torch.Tensor):
            if isinstance(value, (list, tuple)) and self._has_tensors(value):
                return self._stacked(value, argument)
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

    def _has_tensors(self, entries: Sequence[object]) -> bool:
        """Return whether a list contains tensors, at any depth."""
        return any(
            isinstance(entry, self.torch.Tensor)
            or (isinstance(entry, (list, tuple)) and self._has_tensors(entry))
            for entry in entries
        )

    def _stacked(self, value: Sequence[object], argument: str) -> Tensor:
        """Return a list of numbers and tensors as one tensor, which keeps their derivatives."""
        entries = [self.array(entry, argument) for entry in value]
        shapes = list(dict.fromkeys(tuple(entry.shape) for entry in entries))
        if len(shapes) > 1:
            raise ValueError(
                f"{argument} must hold entries of one shape, got {', '.join(map(str, shapes))}."
            )
        return self.torch.stack(entries)

    def concatenate(self, columns: Sequence[Tensor]) -> Tensor:
        """Return tensors (…, k), broadcast and concatenated along the last axis."""
        return self.torch.cat(self.broadcast(columns), dim=-1)

    def broadcast(self, arrays: Sequence[Tensor]) -> list[Tensor]:
        """Return tensors with their leading axes broadcast."""
        lead = np.broadcast_shapes(*(tuple(a.shape[:-1]) for a in arrays))
        return [a.expand(*lead, a.shape[-1]) for a in arrays]

    def call(self, function: LayerFunction, arrays: Sequence[Tensor]) -> Tensor:
        """Return the value of a LayerFunction."""
        direct, call, transformed = _calls()
        return (call if transformed() else direct).apply(function, *arrays)


@cache
def _calls() -> tuple[type[Function], type[Function], Callable[[], bool]]:
    """Return two autograd.Functions of a value, and the function that selects one of them.

    The second one supports the transformations of torch.func. It is slower: PyTorch binds its
    arguments to its signature at each call, which takes longer than most evaluations.
    """
    import torch

    # Whether a transformation of torch.func is active; True if PyTorch has no such function.
    transformed = getattr(torch._C, "_are_functorch_transforms_active", lambda: True)
    tangent_of = torch.autograd.forward_ad.unpack_dual

    def numbers(tensors: Iterable[Tensor]) -> tuple[np.ndarray, ...]:
        return tuple(a.detach().cpu().numpy() for a in tensors)

    def tensor(array: np.ndarray, like: Tensor) -> Tensor:
        return torch.from_numpy(np.ascontiguousarray(array)).to(like.device)

    def batched_in_front(
        tensors: Sequence[Tensor], axes: Sequence[int | None], size: int
    ) -> list[Tensor]:
        return [
            a.movedim(k, 0) if k is not None else a.expand(size, *a.shape)
            for a, k in zip(tensors, axes, strict=True)
        ]

    def products(
        function: LayerFunction, wrt: tuple[int, ...], *tensors: Tensor
    ) -> tuple[Tensor, ...]:
        *arrays, weights = numbers(tensors)
        gradients = function.backward(wrt, tuple(arrays), weights)
        return tuple(tensor(gradient, tensors[0]) for gradient in gradients)

    def keep(ctx: FunctionCtx, function: LayerFunction, tensors: Sequence[Tensor]) -> None:
        ctx.function = function
        ctx.save_for_backward(*tensors)
        ctx.save_for_forward(*tensors)

    class Value(torch.autograd.Function):  # type: ignore[misc]
        """The value of a LayerFunction."""

        @staticmethod
        def backward(ctx: FunctionCtx, weights: Tensor) -> tuple[Tensor | None, ...]:
            wrt = tuple(k for k, need in enumerate(ctx.needs_input_grad[1:]) if need)
            tensors = ctx.saved_tensors
            # If the product may be differentiated again, it is a Function, which raises an error.
            differentiated = torch.is_grad_enabled() or transformed()
            if not differentiated:
                differentiated = any(tangent_of(a).tangent is not None for a in (*tensors, weights))
            product = BackwardProduct.apply if differentiated else products
            gradients = product(ctx.function, wrt, *tensors, weights)
            result: list[Tensor | None] = [None] * (1 + len(tensors))
            for k, gradient in zip(wrt, gradients, strict=True):
                result[1 + k] = gradient
            return tuple(result)

        @staticmethod
        def jvp(ctx: FunctionCtx, _: object, *tangents: Tensor | None) -> Tensor:
            wrt = tuple(k for k, d in enumerate(tangents) if d is not None)
            return ForwardProduct.apply(
                ctx.function, wrt, *ctx.saved_tensors, *(tangents[k] for k in wrt)
            )

    class Direct(Value):
        """The value outside of torch.func."""

        @staticmethod
        def forward(ctx: FunctionCtx, function: LayerFunction, *tensors: Tensor) -> Tensor:
            keep(ctx, function, tensors)
            return tensor(function.value(*numbers(tensors)), tensors[0])

    class Call(Value):
        """The value within transformations of torch.func."""

        @staticmethod
        def forward(function: LayerFunction, *tensors: Tensor) -> Tensor:
            return tensor(function.value(*numbers(tensors)), tensors[0])

        @staticmethod
        def setup_context(ctx: FunctionCtx, inputs: tuple[Any, ...], output: Tensor) -> None:
            keep(ctx, inputs[0], inputs[1:])

        @staticmethod
        def vmap(
            info: Any, axes: tuple[int | None, ...], function: LayerFunction, *tensors: Tensor
        ) -> tuple[Tensor, int]:
            return Call.apply(function, *batched_in_front(tensors, axes[1:], info.batch_size)), 0

    class Product(torch.autograd.Function):  # type: ignore[misc]
        """A product with the Jacobian of a LayerFunction."""

        @staticmethod
        def setup_context(ctx: FunctionCtx, inputs: object, output: object) -> None:
            pass

        @staticmethod
        def backward(ctx: FunctionCtx, *_: object) -> NoReturn:
            raise NotImplementedError(
                "Functions of as_torch have first derivatives only. For second ones of a quantity "
                "use system.evaluate_hessian_vector."
            )

    class ForwardProduct(Product):
        """The Jacobian-vector product; the directions are the last arguments."""

        @staticmethod
        def forward(function: LayerFunction, wrt: tuple[int, ...], *tensors: Tensor) -> Tensor:
            arrays, k = numbers(tensors), len(function.parts)
            return tensor(function.forward(wrt, arrays[:k], arrays[k:]), tensors[0])

        @staticmethod
        def vmap(
            info: Any,
            axes: tuple[int | None, ...],
            function: LayerFunction,
            wrt: tuple[int, ...],
            *tensors: Tensor,
        ) -> tuple[Tensor, int]:
            return ForwardProduct.apply(
                function, wrt, *batched_in_front(tensors, axes[2:], info.batch_size)
            ), 0

    class BackwardProduct(Product):
        """The vector-Jacobian product; the weights are the last argument."""

        @staticmethod
        def forward(
            function: LayerFunction, wrt: tuple[int, ...], *tensors: Tensor
        ) -> tuple[Tensor, ...]:
            return products(function, wrt, *tensors)

        @staticmethod
        def vmap(
            info: Any,
            axes: tuple[int | None, ...],
            function: LayerFunction,
            wrt: tuple[int, ...],
            *tensors: Tensor,
        ) -> tuple[tuple[Tensor, ...], tuple[int, ...]]:
            gradients = BackwardProduct.apply(
                function, wrt, *batched_in_front(tensors, axes[2:], info.batch_size)
            )
            return gradients, (0,) * len(gradients)

    return Direct, Call, transformed
