"""The linear tire: forces in proportion to slips."""

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
    direction,
    evaluate,
    fields_of,
)


@dataclass(frozen=True)
class LinearTire:
    """A tire whose forces are in proportion to slip and load, for small slips.

    With n = F_z/F_z0 and the axes and signs of `MagicFormula` it is ::

        F_x = n C_κ κ    F_y = −n (C_α α + C_γ γ)    M_z = n t C_α α    M_y = −f_r r F_z sgn V_x

    F_x, F_y and M_z at the nominal load are those of linear single-track models. They have no
    limit: at large slips this is no tire.

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

    def __post_init__(self) -> None:
        checked = checked_parameters(
            fields_of(self),
            positive=("nominal_load",),
            not_negative=("cornering_stiffness", "slip_stiffness", "rolling_resistance"),
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
            As for `MagicFormula.forces`. The speed gives M_y its sign, and reduces it below 1 m/s;
            the pressure has no effect.

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
        side = n * m.constant(self.cornering_stiffness) * state.alpha
        Fy = -side - n * m.constant(self.camber_stiffness) * state.gamma
        sign = 1 if state.speed is None else direction(m, state.speed)
        return (
            n * m.constant(self.slip_stiffness) * state.kappa,
            Fy,
            0 * Fz,
            -m.constant(self.rolling_resistance) * Fz * sign,
            m.constant(self.trail) * side,
        )
