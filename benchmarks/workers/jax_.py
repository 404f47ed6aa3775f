"""JAX: a jitted function in double precision; a loop of XLA for scalars, `vmap` for batches."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from harness.convert import Algebra, translate
from harness.model import Model
from harness.peer import Peer, serve_peer

jax.config.update("jax_enable_x64", True)


class JAX(Algebra):
    def __init__(self) -> None:
        super().__init__({name: getattr(jnp, name) for name in ("sin", "cos", "tan", "sqrt")})


def rates_of(model: Model) -> Callable[[Any, Any, Any], Any]:
    """Return x' as a function of x, r and p."""

    def rates(x: Any, r: Any, p: Any) -> Any:
        matrix, forcing, first = translate(model, JAX(), x, r, p)
        n = len(forcing)
        entries = [jnp.asarray(0.0 if entry is None else entry) for entry in matrix]
        m = jnp.stack(entries).reshape(n, n)
        b = jnp.stack([jnp.asarray(f, dtype=float) for f in forcing])
        return jnp.concatenate([jnp.stack(first), jnp.linalg.solve(m, b)])

    return rates


class JAXPeer(Peer):
    def build(self) -> Any:
        return jax.jit(rates_of(self.model)).lower(self.x[0], self.r[0], self.p).compile()

    def _over_all(self, function: Any) -> Any:
        arguments = [jnp.asarray(a) for a in (self.x, self.r, self.p)]
        compiled = jax.jit(function).lower(*arguments).compile()

        def evaluate() -> None:
            self._out = compiled(*arguments).block_until_ready()

        return evaluate

    def scalar(self) -> Any:
        rates = rates_of(self.model)
        return self._over_all(lambda x, r, p: jax.lax.map(lambda row: rates(*row, p), (x, r)))

    def batched(self) -> Any:
        return self._over_all(jax.vmap(rates_of(self.model), in_axes=(0, 0, None)))

    def values(self) -> np.ndarray:
        return np.asarray(self._out)


if __name__ == "__main__":
    serve_peer(JAXPeer())
