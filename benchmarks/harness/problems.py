"""The systems that are simulated, as KanesMethods with numbers. Needs SymPy only."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from sympy.physics.mechanics import dynamicsymbols
from sympy.physics.mechanics.models import n_link_pendulum_on_cart

from harness.driver import ROOT
from harness.serve import module_at

BICYCLE = ROOT / "src" / "pydy" / "examples" / "whipple_bicycle.py"


@dataclass
class Problem:
    """A KanesMethod, and values for its constants and for its states at the start."""

    kane: Any
    constants: dict[Any, float]
    initial_conditions: dict[Any, float]


def problem(name: str) -> Problem:
    """Derive "bicycle", or an n-link pendulum on a cart by n, as in "10"."""
    return _bicycle() if name == "bicycle" else _pendulum(int(name))


def _pendulum(n: int) -> Problem:
    kane = n_link_pendulum_on_cart(n, cart_force=True, joint_torques=False)
    symbols = kane.mass_matrix.free_symbols | kane.forcing.free_symbols
    # A chain of 1 m and 1 kg on a cart of as much as one link.
    constants = {s: 9.81 if s.name == "g" else 1.0 / n for s in symbols if s.name != "t"}
    return Problem(kane, constants, dict.fromkeys(kane.q[1:], 1.0))


def _bicycle() -> Problem:
    module = module_at(BICYCLE)
    model = module.derive()
    model.kane.kanes_equations(model.bodies, model.kane.loads)  # which others need
    initial = module.equilibrium(model, 5.0)
    initial[model["u_phi"]] = 0.5  # rolling upright at 5 m/s, and pushed
    return Problem(model.kane, module.benchmark_parameters(model), initial)


def drop_auxiliary_speeds(kane: Any) -> None:
    """Set the auxiliary speeds in a KanesMethod's equations to zero, which they are in motion."""
    t = dynamicsymbols._t
    zero = dict.fromkeys((*kane._uaux, *(u.diff(t) for u in kane._uaux)), 0)
    for name in ("_k_d", "_f_d", "_k_nh", "_f_nh", "_k_dnh", "_f_dnh"):
        setattr(kane, name, getattr(kane, name).xreplace(zero))
