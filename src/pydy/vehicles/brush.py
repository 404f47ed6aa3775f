"""The brush model: elastic bristles between a rigid carcass and the road."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Self

from pydy.vehicles.algebra import Algebra, Operand, Quantity
from pydy.vehicles.forces import (
    TireForces,
    TireInputs,
    check_known,
    checked_parameters,
    evaluate,
    fields_of,
)
from pydy.vehicles.tuning import SMALLEST_SLIP


@dataclass(frozen=True)
class BrushTire:
    """A tire of elastic bristles, of the same stiffness in all directions, under combined slip.

    With the theoretical slips σ_x = κ/(1 + κ), σ_y = tan α/(1 + κ), their size σ, and
    q = min(C σ/(3 μ F_z), 1), ::

        F = μ F_z q (3 − 3 q + q²)          along (σ_x, −σ_y)
        M_z = −t F_y,  t = a (1 − q)³/(3 − 3 q + q²)

    At q = 1 the whole contact patch slides. Axes and signs are those of `MagicFormula`. Stiffness
    grows in proportion to the load, and the half length a of the patch with its square root.

    Parameters
    ----------
    nominal_load : number or expression
        Load (N) that the stiffness and the length belong to.
    stiffness : number or expression
        Slip stiffness C (N), equal to the cornering stiffness (N/rad): 2 c_p a².
    friction : number or expression
        Coefficient of friction μ.
    half_length : number or expression, optional
        Half the length of the contact patch, a (m). Without it there is no aligning moment.

    References
    ----------
    H. B. Pacejka, Tire and Vehicle Dynamics, 3rd ed., Butterworth-Heinemann, 2012, section 3.2.3.

    Examples
    --------
    >>> from pydy.vehicles import BrushTire
    >>> tire = BrushTire(4000, stiffness=80e3, friction=0.9, half_length=0.06)
    >>> round(tire.forces(4000, 0.0, 0.05).Fy), round(tire.forces(4000, 0.0, 0.5).Fy)
    (-2703, -3600)
    """

    nominal_load: Operand
    stiffness: Operand
    friction: Operand
    half_length: Operand = 0.0

    def __post_init__(self) -> None:
        checked = checked_parameters(
            fields_of(self),
            positive=("nominal_load", "stiffness", "friction"),
            not_negative=("half_length",),
        )
        for name, value in checked.items():
            object.__setattr__(self, name, value)

    @property
    def parameters(self) -> Mapping[str, Operand]:
        """The parameters by name."""
        return fields_of(self)

    def replace(self, **parameters: Operand) -> Self:
        """Return the tire with some other parameters.

        Parameters
        ----------
        **parameters
            By name, as for the class.
        """
        check_known(parameters, self)
        return replace(self, **parameters)

    def forces(
        self,
        Fz: Quantity,
        kappa: Quantity,
        alpha: Quantity,
        gamma: Quantity = 0.0,
        *,
        speed: Quantity | None = None,
        pressure: Quantity | None = None,
    ) -> TireForces:
        """Return the forces and moments of the road on the tire, at the contact point.

        Parameters
        ----------
        Fz, kappa, alpha, gamma, speed, pressure : number, array or expression
            As for `MagicFormula.forces`. Camber, speed and pressure have no effect.

        Returns
        -------
        TireForces
        """
        inputs = {"Fz": Fz, "kappa": kappa, "alpha": alpha, "gamma": gamma}
        return TireForces(
            *evaluate(self._equations, self.parameters, **inputs, speed=speed, pressure=pressure)
        )

    def _equations(self, m: Algebra, state: TireInputs) -> tuple[Operand, ...]:
        Fz = m.maximum(state.Fz, 0)
        n = Fz / m.constant(self.nominal_load)
        mu = m.constant(self.friction)
        tangent = m.tan(state.alpha)
        slip = m.sqrt(state.kappa**2 + tangent**2 + SMALLEST_SLIP**2)
        # q/slip: the bristles' stiffness, or full sliding. A locked wheel has 1 + κ = 0.
        theta = m.constant(self.stiffness) / (3 * mu * m.constant(self.nominal_load))
        ratio = m.minimum(theta / m.maximum(1 + state.kappa, SMALLEST_SLIP), 1 / slip)
        q = ratio * slip
        shape = 3 - 3 * q + q**2
        rise = mu * Fz * ratio * shape
        Fy = -rise * tangent
        trail = m.constant(self.half_length) * m.sqrt(n + SMALLEST_SLIP) * (1 - q) ** 3 / shape
        return rise * state.kappa, Fy, 0 * Fz, 0 * Fz, -trail * Fy
