"""What the tests need of each library: arrays, derivatives in both directions, vmap."""

import warnings

import numpy as np
import pytest


class Jax:
    name = "as_jax"

    def __init__(self):
        self.jax = pytest.importorskip("jax", reason="needs pydy[jax]")
        self.jax.config.update("jax_enable_x64", True)

    def layer(self, system, **options):
        return system.as_jax(**options)

    def array(self, values):
        return self.jax.numpy.asarray(values, dtype="float64")

    def grad(self, f, x):
        return np.asarray(self.jax.jit(self.jax.grad(f))(x))

    def jvp(self, f, x, v):
        return np.asarray(self.jax.jit(lambda x, v: self.jax.jvp(f, (x,), (v,))[1])(x, v))

    def vmap(self, f):
        return self.jax.jit(self.jax.vmap(f))

    def vmapped_grad(self, f):
        return self.jax.jit(self.jax.vmap(self.jax.grad(f)))


class Torch:
    name = "as_torch"

    def __init__(self):
        self.torch = pytest.importorskip("torch", reason="needs pydy[torch]")

    def layer(self, system, **options):
        return system.as_torch(**options)

    def array(self, values):
        return self.torch.tensor(np.asarray(values), dtype=self.torch.float64)

    def grad(self, f, x):
        x = x.clone().requires_grad_()
        f(x).backward()
        return x.grad.numpy()

    def jvp(self, f, x, v):
        with warnings.catch_warnings():  # PyTorch's own use of what it has deprecated
            warnings.filterwarnings("ignore", ".*torch.jit.script", DeprecationWarning)
            return self.torch.func.jvp(f, (x,), (v,))[1].numpy()

    def vmap(self, f):
        return self.torch.func.vmap(f)

    def vmapped_grad(self, f):
        return self.torch.func.vmap(self.torch.func.grad(f))
