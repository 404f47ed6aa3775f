"""What all tires share: the state of the contact that forces depend on, and the forces."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields, replace
from typing import ClassVar, NamedTuple, Protocol, Self, cast

import numpy as np

from pydy._checks import shown
from pydy._names import nearest
from pydy.vehicles.algebra import (
    Algebra,
    Operand,
    Quantity,
    SymbolicAlgebra,
    algebra_of,
    checked_quantity,
    is_symbolic,
)


class TireForces(NamedTuple):
    """Forces and moments of the road on a tire, at the contact point C, in ISO axes.

    x points forward in the plane of the wheel and along the road, z up, normal to the road, and
    y to the left. The normal force Fz is an input of a tire and not among them.

    Attributes
    ----------
    Fx, Fy : float, ndarray or expression
        Longitudinal and lateral force (N).
    Mx, My, Mz : float, ndarray or expression
        Overturning moment, rolling resistance moment and aligning moment (N m).
    """

    Fx: Quantity
    Fy: Quantity
    Mx: Quantity
    My: Quantity
    Mz: Quantity


@dataclass(frozen=True)
class TireInputs:
    """The inputs of a tire: numbers, arrays of one shape, or expressions."""

    Fz: Operand
    kappa: Operand
    alpha: Operand
    gamma: Operand
    speed: Operand
    pressure: Operand


class Tire(Protocol):
    """What fits and plots need of a tire."""

    @property
    def parameters(self) -> Mapping[str, Operand]:
        """The parameters by name."""

    def replace(self, **parameters: Operand) -> Self:
        """Return a tire with some other parameters."""

    def forces(
        self,
        Fz: Operand,
        kappa: Operand,
        alpha: Operand,
        gamma: Operand = 0.0,
        *,
        speed: Operand = None,
        pressure: Operand = None,
    ) -> TireForces:
        """Return the forces at the road."""


class TireEquations(ABC):
    """A tire that is given by the equations of its forces, written once for all kinds of inputs."""

    @property
    @abstractmethod
    def parameters(self) -> Mapping[str, Operand]:
        """The parameters by name."""

    @abstractmethod
    def _equations(self, m: Algebra, state: TireInputs) -> tuple[Operand, ...]:
        """Return F_x, F_y, M_x, M_y and M_z."""

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

        All arguments are numbers, arrays of shapes that match, or SymPy expressions; the results
        are of the same kind. The signs are those of the class.

        Parameters
        ----------
        Fz : number, array or expression
            Normal force (N). If it is not positive, there are no forces.
        kappa : number, array or expression
            Longitudinal slip.
        alpha : number, array or expression
            Slip angle (rad), from −π/2 to π/2.
        gamma : number, array or expression, optional
            Camber angle to the road (rad).
        speed : number, array or expression, optional
            Longitudinal speed V_x of the wheel's centre (m/s), negative if it rolls backwards. By
            default the speed of the measurement, LONGVL.
        pressure : number, array or expression, optional
            Inflation pressure (Pa). By default INFLPRES, otherwise NOMPRES. The version 5.2 and
            tires that are no `MagicFormula` do not depend on it.

        Returns
        -------
        TireForces
        """
        inputs: dict[str, Operand] = {"Fz": Fz, "kappa": kappa, "alpha": alpha, "gamma": gamma}
        results = evaluate(
            self._equations, self.parameters, **inputs, speed=speed, pressure=pressure
        )
        return TireForces(*results)


class TireParameters(TireEquations):
    """A tire whose parameters are the fields of a dataclass: numbers or expressions."""

    _POSITIVE: ClassVar[tuple[str, ...]]
    _NOT_NEGATIVE: ClassVar[tuple[str, ...]] = ()

    def __post_init__(self) -> None:
        checked = checked_parameters(
            self.parameters, positive=self._POSITIVE, not_negative=self._NOT_NEGATIVE
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
        changed: Operand = self  # a dataclass
        return cast("Self", replace(changed, **parameters))


_OPTIONAL = ("speed", "pressure")
Equations = Callable[[Algebra, Operand], tuple[Operand, ...]]


def evaluate(
    equations: Equations,
    parameters: Mapping[str, Operand],
    kind: type = TireInputs,
    /,
    **inputs: Operand,
) -> tuple[Operand, ...]:
    """Return what equations give for inputs that users passed, which are checked here.

    The equations get them as a `kind`, the class of a state. Numbers give numbers, arrays give
    arrays of their common shape, expressions give expressions.
    """
    read = {
        name: None if value is None and name in _OPTIONAL else checked_quantity(value, f"`{name}`")
        for name, value in inputs.items()
    }
    algebra = algebra_of(*read.values(), *parameters.values())
    arrays = {name: v for name, v in read.items() if isinstance(v, np.ndarray)}
    if algebra.symbolic and arrays:
        name, value = next(iter(arrays.items()))
        raise TypeError(
            f"`{name}` must be a number or an expression, because another input or a parameter of "
            f"the tire is an expression; got {shown(value)}."
        )
    try:
        shape = np.broadcast_shapes(*(v.shape for v in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"`{name}` {v.shape}" for name, v in arrays.items())
        raise ValueError(f"The inputs must have shapes that match, got {shapes}.") from None
    if algebra.symbolic:
        read = {k: v if v is None else algebra.constant(v) for k, v in read.items()}
    with np.errstate(over="ignore", invalid="ignore"):  # of loads that no tire carries
        results = equations(algebra, kind(**read))
    if isinstance(algebra, SymbolicAlgebra):
        return tuple(map(algebra.sympy.sympify, results))
    if not arrays:
        return tuple(map(float, results))
    return tuple(np.array(np.broadcast_to(r, shape), dtype=float) for r in results)


def direction(m: Algebra, x: Operand) -> Operand:
    """Return the sign of x, by a polynomial with continuous derivatives between −1 and 1."""
    x = m.maximum(m.minimum(x, 1), -1)
    return x * (3 - x**2) / 2


def fields_of(tire: Operand) -> dict[str, Operand]:
    """Return the fields of a tire that is a dataclass, by name."""
    return {field.name: getattr(tire, field.name) for field in fields(tire)}


def checked_parameters(
    parameters: Mapping[str, Operand],
    *,
    positive: tuple[str, ...] = (),
    not_negative: tuple[str, ...] = (),
) -> dict[str, Operand]:
    """Return parameters of a tire, numbers or expressions, or raise an error that names one."""
    checked = {}
    for name, value in parameters.items():
        result = checked_quantity(value, f"`{name}`", arrays=False)
        if not is_symbolic(result):
            if name in positive and not result > 0.0:
                raise ValueError(f"`{name}` must be positive, got {result!r}.")
            if name in not_negative and not result >= 0.0:
                raise ValueError(f"`{name}` must not be negative, got {result!r}.")
        checked[name] = result
    return checked


def unknown_parameter(name: str, known: Mapping[str, Operand]) -> ValueError:
    """Return an error that names a parameter that a tire does not have."""
    return ValueError(f"{name!r} is no parameter of the tire. {nearest(name, list(known))}")


def check_known(parameters: Mapping[str, Operand], tire: Tire) -> None:
    """Refuse names that are no parameters of a tire."""
    for name in parameters:
        if name not in tire.parameters:
            raise unknown_parameter(name, tire.parameters)
