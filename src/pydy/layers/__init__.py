"""A system's equations and simulations as differentiable functions of JAX and PyTorch."""

import lazy_loader

__getattr__, __dir__, _ = lazy_loader.attach_stub(__name__, __file__)
__all__ = [
    "Layer",
]
