"""The brush model: elastic bristles between a rigid carcass and the road."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from pydy.vehicles.algebra import Algebra, Operand
from pydy.vehicles.forces import TireInputs, TireParameters
from pydy.vehicles.tuning import SMALLEST_LOAD, SMALLEST_SLIP


@dataclass(frozen=True)
class BrushTire(TireParameters):
    """A tire of elastic bristles, of the same stiffness in all directions, under combined slip.

    With the theoretical slips σ_x = κ/(1 + κ), σ_y = tan α/(1 + κ), their size σ, and
    q = min(C σ/(3 μ F_z), 1), ::

        F = μ F_z q (3 − 3 q + q²)          along (σ_x, −σ_y)
        M_z = −t F_y,  t = a (1 − q)³/(3 − 3 q + q²)

    At q = 1 the whole contact patch slides. Axes and signs are those of `MagicFormula`. Stiffness
    grows in proportion to the load, and the half length a of the patch with its square root.
    Camber, speed and pressure have no effect.

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

    _POSITIVE: ClassVar[tuple[str, ...]] = ("nominal_load", "stiffness", "friction")
    _NOT_NEGATIVE: ClassVar[tuple[str, ...]] = ("half_length",)

    def _equations(self, m: Algebra, state: TireInputs) -> tuple[Operand, ...]:
        Fz = m.maximum(state.Fz, 0)
        n = m.maximum(state.Fz / m.constant(self.nominal_load), SMALLEST_LOAD)
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
        trail = m.constant(self.half_length) * m.sqrt(n) * (1 - q) ** 3 / shape
        none = m.constant(0.0)
        return rise * state.kappa, Fy, none, none, -trail * Fy
