"""A system's equations and simulations as differentiable functions of JAX and PyTorch."""

import lazy_loader

__getattr__, _, _ = lazy_loader.attach_stub(__name__, __file__)
__all__ = [
    "Layer",
]

__dir__ = __all__.copy  # the stub lists what other rooms take, too
