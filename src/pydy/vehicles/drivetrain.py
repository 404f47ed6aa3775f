"""What drives wheels: motors, gears, and how a differential divides a torque."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from pydy._checks import positive, real_array, shown
from pydy.vehicles.algebra import (
    Operand,
    Quantity,
    algebra_of,
    checked_quantity,
    is_symbolic,
)
from pydy.vehicles.forces import checked_parameters, direction


def motor_torque(
    speed: Quantity, speeds: Sequence[float], torques: Sequence[float], *, ratio: float = 1.0
) -> Quantity:
    """Return the torque of a motor at the shaft that it drives by a gear, from a table.

    Torques between the speeds of the table lie on straight lines; beyond its ends they keep the
    values there. With the gear ratio i the shaft has the torque i T(i ω).

    Parameters
    ----------
    speed : number, array or expression
        Angular speed ω of the shaft (rad/s).
    speeds : sequence of float
        Angular speeds of the motor (rad/s), at least two, ascending.
    torques : sequence of float
        Torques of the motor (N m) at these.
    ratio : float, optional
        i, the speed of the motor by that of the shaft.

    Returns
    -------
    number, array or expression
        Torque (N m) at full load. Multiply it by the position of the pedal, from 0 to 1.

    Examples
    --------
    An electric motor of 100 N m up to 300 rad/s, with a gear of 8:

    >>> from pydy.vehicles.machines import motor_torque
    >>> motor_torque(25.0, [0, 300, 900], [100, 100, 0], ratio=8.0)
    800.0

    >>> from sympy.physics.mechanics import dynamicsymbols
    >>> omega, pedal = dynamicsymbols('omega pedal')
    >>> torque = pedal*motor_torque(omega, [0, 300, 900], [100, 100, 0], ratio=8.0)
    """
    omega = checked_quantity(speed, "`speed`")
    nodes, values = _table(speeds, torques)
    i = positive(ratio, "`ratio`", finite=True)
    m = algebra_of(omega)
    turning = m.constant(i) * (m.constant(omega) if m.symbolic else omega)
    torque: Operand = values[0] + 0 * turning
    for start, end, low, high in zip(nodes, nodes[1:], values, values[1:], strict=False):
        if high != low:
            share = m.minimum(m.maximum((turning - start) / (end - start), 0), 1)
            torque = torque + (high - low) * share
    result: Operand = i * torque
    return result if m.symbolic or isinstance(omega, np.ndarray) else float(result)


def _table(speeds: Any, torques: Any) -> tuple[list[float], list[float]]:
    nodes, values = real_array(speeds, "`speeds`"), real_array(torques, "`torques`")
    if nodes.ndim != 1 or len(nodes) < 2 or not np.isfinite(nodes).all():
        raise ValueError(f"`speeds` must be at least two finite numbers, got {shown(speeds)}.")
    if not (np.diff(nodes) > 0.0).all():
        raise ValueError(f"`speeds` must ascend, got {shown(speeds)}.")
    if values.shape != nodes.shape or not np.isfinite(values).all():
        raise ValueError(
            f"`torques` must be {len(nodes)} finite numbers, one for each of `speeds`, got "
            f"{shown(torques)}."
        )
    return nodes.tolist(), values.tolist()


def power_limited_torque(
    speed: Quantity, torque: Quantity, power: Quantity, *, ratio: Quantity = 1.0
) -> Quantity:
    """Return the largest torque of an electric motor, limited by a torque and by a power.

    At the shaft, behind a gear with the ratio i, it is ``min(i T, P/|ω|)``: constant up to the base
    speed P/(i T) of the shaft, then at constant power.

    Parameters
    ----------
    speed : number, array or expression
        Angular speed ω of the shaft (rad/s), in either direction.
    torque : number or expression
        T (N m), the largest torque of the motor.
    power : number or expression
        P (W), its largest power.
    ratio : number or expression, optional
        i, the speed of the motor by that of the shaft, positive.

    Returns
    -------
    number, array or expression
        Torque (N m), not negative. Multiply it by a share of the load from −1 to 1.

    References
    ----------
    R. Rajamani, Vehicle Dynamics and Control, 2nd ed., Springer, 2012, chapter 4, for the balance
    of torques along a drivetrain.

    Examples
    --------
    >>> from pydy.vehicles.machines import power_limited_torque
    >>> power_limited_torque(20.0, 250.0, 80e3, ratio=8.0)
    2000.0
    >>> power_limited_torque(80.0, 250.0, 80e3, ratio=8.0)
    1000.0
    """
    omega = checked_quantity(speed, "`speed`")
    limits = {"torque": torque, "power": power, "ratio": ratio}
    values = checked_parameters(limits, positive=tuple(limits))
    m = algebra_of(omega, *values.values())
    T, P, i = (m.constant(values[name]) for name in limits)
    turning = m.constant(omega) if m.symbolic and not is_symbolic(omega) else omega
    result: Operand = P / m.maximum(m.abs(turning), P / (i * T))
    return result if m.symbolic or isinstance(omega, np.ndarray) else float(result)


def gear_ratio(gear: Quantity, ratios: Sequence[float], *, final: float = 1.0) -> Quantity:
    """Return the ratio of a gearbox in a gear, with the final drive.

    Gears are numbered from 1. The nearest gear is engaged, and the last one for larger numbers.
    Below ½ the gearbox is in neutral: its ratio is 0, and so are the torque at its output and the
    speed of a motor that follows it.

    Parameters
    ----------
    gear : number, array or expression
        Such as a specified that a driver sets.
    ratios : sequence of float
        Speed of the input by that of the output in each gear, not zero; negative for reverse.
    final : float, optional
        Ratio of the final drive, positive.

    Returns
    -------
    number, array or expression
        i, the speed of the motor by that of the driven shaft.

    Examples
    --------
    >>> from pydy.vehicles.machines import gear_ratio
    >>> gear_ratio(2, [3.5, 2.0, 1.3, 1.0], final=4.0)
    8.0
    >>> gear_ratio(0, [3.5, 2.0, 1.3, 1.0], final=4.0)
    0.0
    """
    selected = checked_quantity(gear, "`gear`")
    steps = real_array(ratios, "`ratios`")
    if steps.ndim != 1 or not len(steps) or not (np.isfinite(steps) & (steps != 0.0)).all():
        raise ValueError(f"`ratios` must be finite numbers that are not zero, got {shown(ratios)}.")
    last = positive(final, "`final`", finite=True)
    m = algebra_of(selected)
    values = [0.0, *(steps * last).tolist()]
    result: Operand = values[-1]
    for k in reversed(range(len(steps))):
        result = m.where_negative(selected - (k + 0.5), values[k], result)
    return result if m.symbolic or isinstance(selected, np.ndarray) else float(result)


def gear_torque(
    torque: Quantity,
    speed: Quantity,
    ratio: Quantity,
    *,
    efficiency: Quantity = 1.0,
    transition: Quantity = 0.1,
) -> Quantity:
    """Return the torque at the output of a gear, with its losses in either direction of the power.

    With the ratio i, the efficiency η and the speed ω of the output ::

        T_out = i T η    if i T ω > 0: the motor drives
        T_out = i T/η    if i T ω < 0: it is driven

    so that a gear never gives more power than it receives.

    Parameters
    ----------
    torque : number, array or expression
        T (N m), at the input.
    speed : number, array or expression
        ω (rad/s), of the output.
    ratio : number, array or expression
        i, the speed of the input by that of the output.
    efficiency : number or expression, optional
        η, above 0 and up to 1.
    transition : number or expression, optional
        Speed of the output (rad/s) below which the losses fade, so that the torque is continuous.

    Returns
    -------
    number, array or expression
        T_out (N m).

    References
    ----------
    M. Guiggiani, The Science of Vehicle Dynamics, 2nd ed., Springer, 2018, section 3.13, for the
    efficiency of a differential, which is that of any gear.

    Examples
    --------
    >>> from pydy.vehicles.machines import gear_torque
    >>> gear_torque(100.0, 50.0, 8.0, efficiency=0.95)
    760.0
    """
    inputs = {"torque": torque, "speed": speed, "ratio": ratio}
    T, omega, i = (checked_quantity(value, f"`{name}`") for name, value in inputs.items())
    law = checked_parameters(
        {"efficiency": efficiency, "transition": transition}, positive=("efficiency", "transition")
    )
    if isinstance(law["efficiency"], float) and law["efficiency"] > 1.0:
        raise ValueError(f"`efficiency` must be at most 1, got {law['efficiency']!r}.")
    m = algebra_of(T, omega, i, *law.values())
    if m.symbolic:
        T, omega, i = (m.constant(value) for value in (T, omega, i))
    eta, smooth = m.constant(law["efficiency"]), m.constant(law["transition"])
    ideal = i * T
    # Both losses vanish with ω and with T, so that the jump of their coefficient changes nothing.
    lost = m.where_negative(ideal * omega, 1 / eta - 1, 1 - eta)
    result: Operand = ideal - m.abs(ideal) * direction(m, omega / smooth) * lost
    if m.symbolic or any(isinstance(value, np.ndarray) for value in (T, omega, i)):
        return result
    return float(result)


def differential_torques(
    torque: Quantity,
    left: Quantity,
    right: Quantity,
    *,
    preload: Quantity = 0.0,
    bias: Quantity = 0.0,
    viscosity: Quantity = 0.0,
    transition: Quantity = 0.1,
) -> tuple[Quantity, Quantity]:
    """Return the torques at both shafts of a differential, open or with limited slip.

    Friction and oil take torque from the shaft that is faster and give it to the other. With the
    difference Δ = ω_l − ω_r of the speeds ::

        T_l = (T − T_s)/2    T_r = (T + T_s)/2    T_s = (T_0 + b |T|) sgn Δ + c Δ

    Without T_0, b and c the differential is open. A locked one is a constraint, ω_l − ω_r = 0,
    among the `nonholonomic_constraints` of a Definition. Plates that lock and slip without a
    `transition` are a `clutch` between the shafts of an open differential, with half of the torque
    that they transfer: ``clutch(left, right, (preload + bias*Abs(torque))/2)``.

    Parameters
    ----------
    torque : number, array or expression
        T (N m), of the drive.
    left, right : number, array or expression
        Speeds ω_l and ω_r of the shafts (rad/s).
    preload : number or expression, optional
        T_0 (N m).
    bias : number or expression, optional
        b, from 0 to 1: one shaft has up to (1 + b)/(1 − b) times the torque of the other.
    viscosity : number or expression, optional
        c (N m s/rad).
    transition : number or expression, optional
        Difference of the speeds (rad/s) up to which the sign is a smooth function.

    Returns
    -------
    tuple of two
        T_l and T_r (N m).

    References
    ----------
    M. Guiggiani, The Science of Vehicle Dynamics, 2nd ed., Springer, 2018, section 3.13.

    Examples
    --------
    >>> from pydy.vehicles.machines import differential_torques
    >>> differential_torques(600.0, 40.0, 50.0, bias=0.5)
    (450.0, 150.0)
    """
    inputs = {"torque": torque, "left": left, "right": right}
    T, fast_left, fast_right = (checked_quantity(v, f"`{k}`") for k, v in inputs.items())
    law = checked_parameters(
        {"preload": preload, "bias": bias, "viscosity": viscosity, "transition": transition},
        positive=("transition",),
        not_negative=("preload", "bias", "viscosity"),
    )
    if isinstance(law["bias"], float) and law["bias"] > 1.0:
        raise ValueError(f"`bias` must be at most 1, got {law['bias']!r}.")
    m = algebra_of(T, fast_left, fast_right, *law.values())
    if m.symbolic:
        T, fast_left, fast_right = (m.constant(v) for v in (T, fast_left, fast_right))
    T_0, b, c, smooth = (m.constant(law[k]) for k in ("preload", "bias", "viscosity", "transition"))
    difference = fast_left - fast_right
    moved = (T_0 + b * m.abs(T)) * direction(m, difference / smooth) + c * difference
    results = (T - moved) / 2, (T + moved) / 2
    if m.symbolic or any(isinstance(v, np.ndarray) for v in (T, fast_left, fast_right)):
        return results
    return float(results[0]), float(results[1])
