"""A system's equations and simulations as differentiable functions of JAX and PyTorch."""

from pydy.layers.layer import Layer

__all__ = ["Layer"]
