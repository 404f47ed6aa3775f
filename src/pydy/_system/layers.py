"""A System's functions for libraries that differentiate; they are made in `pydy.layers`."""

from __future__ import annotations

from typing import Any

from pydy._simulation.events_and_constraints import native_solver
from pydy._system.setup import Setup
from pydy.layers.functions import Functions
from pydy.layers.layer import Layer


class Layers(Setup):
    """Differentiable functions for other libraries."""

    def _layer_functions(self, contacts: Any, options: dict[str, Any]) -> Functions:
        """Return the functions of the System as it is now."""
        if contacts is not None:
            self._checked_contacts(contacts)
        problem = self._now(options.get("events"), contacts=contacts)
        return Functions(problem, native_solver(self.ode_solver), options)

    def as_jax(self, *, contacts: Any = None, **solver_kwargs: Any) -> Layer:
        """Return the equations and simulations as functions of JAX.

        They are compiled as for `evaluate_ode` and `simulate`. They work under `jax.jit`,
        `jax.vmap` (one call for all samples; simulations as an ensemble), `jax.grad`, `jax.vjp` and
        `jax.jvp`. Second derivatives are refused.

        Parameters
        ----------
        contacts : pydy.contact.Contacts, optional
            Contacts of this System, which simulations are done with; their constants are arguments
            too.
        **solver_kwargs
            Options of the `ode_solver` for simulations, as in `simulate`; ``'dop853'`` is used if
            it is not native.

        Returns
        -------
        Layer
            ``ode``, ``outputs``, ``simulate`` and ``final``, of the system as it is now.

        Raises
        ------
        ImportError
            A package is missing: ``pip install 'pydy[jax]'``.
        TypeError
            JAX computes with float32: ``jax.config.update('jax_enable_x64', True)``.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> import jax  # doctest: +SKIP
        >>> jax.config.update('jax_enable_x64', True)  # doctest: +SKIP
        >>> layer = system.as_jax()  # doctest: +SKIP
        >>> jax.jit(layer.ode)([1.0, 0.0])  # doctest: +SKIP
        Array([ 0., -1.], dtype=float64)
        """
        from pydy.layers.of_jax import JaxArrays

        return Layer(self._layer_functions(contacts, solver_kwargs), JaxArrays(), "JAX")

    def as_torch(self, *, contacts: Any = None, **solver_kwargs: Any) -> Layer:
        """Return the equations and simulations as functions of PyTorch.

        They take and return tensors of float64, and work with autograd, and with `torch.func`:
        `grad`, `vjp`, `jvp` and `vmap`. Second derivatives are refused.

        Parameters
        ----------
        contacts, **solver_kwargs
            As in `as_jax`.

        Returns
        -------
        Layer
            As of `as_jax`.

        Raises
        ------
        ImportError
            A package is missing: ``pip install 'pydy[torch]'``.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> layer = multi_mass_spring_damper().as_torch()  # doctest: +SKIP
        >>> layer.ode([1.0, 0.0])  # doctest: +SKIP
        tensor([ 0., -1.], dtype=torch.float64)
        """
        from pydy.layers.of_torch import TorchArrays

        return Layer(self._layer_functions(contacts, solver_kwargs), TorchArrays(), "PyTorch")
