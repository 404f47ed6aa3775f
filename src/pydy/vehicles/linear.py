"""The linear tire: forces in proportion to slips."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from pydy.vehicles.algebra import Algebra, Operand
from pydy.vehicles.forces import TireInputs, TireParameters, direction


@dataclass(frozen=True)
class LinearTire(TireParameters):
    """A tire whose forces are in proportion to slip and load, for small slips.

    With n = F_z/F_z0 and the axes and signs of `MagicFormula` it is ::

        F_x = n C_κ κ    F_y = −n (C_α α + C_γ γ)    M_z = n t C_α α    M_y = −f_r r F_z sgn V_x

    Below `low_speed` a polynomial of V_x with a continuous derivative replaces the sign. The
    pressure has no effect. F_x, F_y and M_z at the nominal load are those of linear single-track
    models. They have no limit: at large slips this is no tire.

    Parameters
    ----------
    nominal_load : number or expression
        F_z0 (N), the load that the stiffnesses belong to.
    cornering_stiffness : number or expression
        C_α (N/rad), positive.
    slip_stiffness : number or expression, optional
        C_κ (N).
    camber_stiffness : number or expression, optional
        C_γ (N/rad).
    trail : number or expression, optional
        Pneumatic trail t (m).
    rolling_resistance : number or expression, optional
        f_r r (m): the coefficient of rolling resistance times the radius.
    low_speed : number or expression, optional
        Speed (m/s) below which the rolling resistance is reduced.

    References
    ----------
    H. B. Pacejka, Tire and Vehicle Dynamics, 3rd ed., Butterworth-Heinemann, 2012, section 1.3.

    Examples
    --------
    >>> from pydy.vehicles import LinearTire
    >>> tire = LinearTire(4000, cornering_stiffness=60e3, trail=0.03)
    >>> forces = tire.forces(4000, 0.0, 0.01)
    >>> forces.Fy, forces.Mz
    (-600.0, 18.0)
    """

    nominal_load: Operand
    cornering_stiffness: Operand
    slip_stiffness: Operand = 0.0
    camber_stiffness: Operand = 0.0
    trail: Operand = 0.0
    rolling_resistance: Operand = 0.0
    low_speed: Operand = 1.0

    _POSITIVE: ClassVar[tuple[str, ...]] = ("nominal_load", "low_speed")
    _NOT_NEGATIVE: ClassVar[tuple[str, ...]] = (
        "cornering_stiffness",
        "slip_stiffness",
        "rolling_resistance",
    )

    def _equations(self, m: Algebra, state: TireInputs) -> tuple[Operand, ...]:
        Fz = m.maximum(state.Fz, 0)
        n = Fz / m.constant(self.nominal_load)
        side = n * m.constant(self.cornering_stiffness) * state.alpha
        Fy = -side - n * m.constant(self.camber_stiffness) * state.gamma
        speed = state.speed
        sign = 1 if speed is None else direction(m, speed / m.constant(self.low_speed))
        return (
            n * m.constant(self.slip_stiffness) * state.kappa,
            Fy,
            m.constant(0.0),
            -m.constant(self.rolling_resistance) * Fz * sign,
            m.constant(self.trail) * side,
        )
