"""Clutches and brakes: dry friction between shafts, which locks and slips."""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy as sm

from pydy._checks import flag, integer, text
from pydy.contact import Stick
from pydy.vehicles.algebra import checked_quantity, is_symbolic
from pydy.vehicles.forces import checked_parameters

if TYPE_CHECKING:
    from pydy._sympy_types import Expression


def clutch(
    driving: Expression,
    driven: Expression,
    capacity: Expression | float,
    *,
    static_ratio: Expression | float = 1.0,
    name: str = "clutch",
) -> Stick:
    """Return a clutch between two shafts: dry friction that slips, locks, and slips again.

    While the speeds differ the capacity acts against their difference. Once they agree the clutch
    is locked and transmits whatever torque keeps them equal, until that exceeds the capacity.
    `pydy.contact.Contacts` simulates a System with clutches and locates both transitions; its
    outputs ``clutch_friction`` and ``clutch_sliding`` are the torque on the driving shaft and the
    difference of the speeds.

    Parameters
    ----------
    driving, driven : expression
        Angular speeds (rad/s) of the shafts, linear in the speeds of the system.
    capacity : number or expression
        Largest torque (N m) while it slips, not negative: of states, time and specifieds, such as
        that of a pedal.
    static_ratio : number or expression, optional
        Largest torque while it is locked, relative to the capacity, at least 1.
    name : str, optional
        Name of the clutch, for outputs and transitions.

    Returns
    -------
    pydy.contact.Stick

    Examples
    --------
    A flywheel is coupled to one of the same inertia, at rest:

    >>> import numpy as np
    >>> import sympy.physics.mechanics as me
    >>> from pydy import System
    >>> from pydy.contact import Contacts
    >>> from pydy.mechanics import Definition
    >>> from pydy.vehicles.machines import clutch
    >>> N, O, bodies = me.ReferenceFrame('N'), me.Point('O'), []
    >>> O.set_vel(N, 0)
    >>> q, w = me.dynamicsymbols('q1 q2'), me.dynamicsymbols('w1 w2')
    >>> for k in range(2):
    ...     W = me.ReferenceFrame(f'W{k}')
    ...     W.orient_axis(N, N.x, q[k])
    ...     W.set_ang_vel(N, w[k]*N.x)
    ...     bodies.append(me.RigidBody(f'shaft{k}', O, W, 1, (me.inertia(W, 0.2, 1, 1), O)))
    >>> system = System(Definition(N, q, w, bodies=bodies), ode_solver='dop853',
    ...                 initial_conditions={w[0]: 100.0}, times=np.linspace(0.0, 1.0, 11))
    >>> motion = Contacts(system, [clutch(w[0], w[1], 20.0)]).simulate()
    >>> round(motion.events[0].time, 9), motion.events[0].name
    (0.5, 'clutch stops')
    >>> motion.states[-1, 2:].round(9)
    array([50., 50.])
    """
    speeds = {"driving": driving, "driven": driven}
    one, other = (
        sm.sympify(checked_quantity(speed, f"`{label}`", arrays=False))
        for label, speed in speeds.items()
    )
    return _friction(one - other, capacity, static_ratio, name)


def brake(
    speed: Expression,
    capacity: Expression | float,
    *,
    static_ratio: Expression | float = 1.0,
    name: str = "brake",
) -> Stick:
    """Return a brake of a shaft: dry friction that stops it and keeps it at rest.

    A clutch to something that does not turn. `WheelContact.brake` is the same for a wheel and the
    axle that carries it.

    Parameters
    ----------
    speed : expression
        Angular speed (rad/s) of the shaft, relative to what carries the brake.
    capacity : number or expression
        Largest torque (N m) while it slips, not negative.
    static_ratio : number or expression, optional
        Largest torque at rest, relative to the capacity, at least 1.
    name : str, optional
        Name of the brake, for outputs and transitions.

    Returns
    -------
    pydy.contact.Stick

    Examples
    --------
    >>> import sympy as sm
    >>> import sympy.physics.mechanics as me
    >>> from pydy.vehicles.machines import brake
    >>> brake(me.dynamicsymbols('omega'), sm.Symbol('T'), name='handbrake')
    <Stick handbrake>
    """
    turning = sm.sympify(checked_quantity(speed, "`speed`", arrays=False))
    return _friction(turning, capacity, static_ratio, name)


def _friction(
    sliding: Expression,
    capacity: Expression | float,
    static_ratio: Expression | float,
    name: str,
) -> Stick:
    limits = checked_parameters(
        {"capacity": capacity, "static_ratio": static_ratio}, not_negative=("capacity",)
    )
    ratio = limits["static_ratio"]
    if not (is_symbolic(ratio) or ratio >= 1.0):
        raise ValueError(f"`static_ratio` must be at least 1, got {ratio!r}.")
    static = sm.sympify(ratio) if is_symbolic(ratio) or ratio != 1.0 else None
    name = text(name, "`name`", empty=False)
    return Stick(sliding, mu=1, mu_static=static, normal=limits["capacity"], name=name)


def clutch_capacity(
    force: Expression | float,
    friction: Expression | float,
    inner: Expression | float,
    outer: Expression | float,
    *,
    faces: int = 2,
    worn: bool = True,
) -> Expression | float:
    """Return the torque that a disc clutch or a multi-plate brake transmits while it slips.

    With the normal force F, the coefficient μ, the radii r_i and r_o, and n faces ::

        T = n μ F (r_i + r_o)/2                          worn: uniform wear
        T = n μ F 2 (r_o² + r_o r_i + r_i²)/(3 (r_o + r_i))    new: uniform pressure

    Parameters
    ----------
    force : number or expression
        F (N), not negative.
    friction : number or expression
        μ.
    inner, outer : number or expression
        r_i and r_o (m) of the lining.
    faces : int, optional
        n, two for one disc with a lining on both sides.
    worn : bool, optional
        Whether the wear is uniform; otherwise the pressure is.

    Returns
    -------
    number or expression
        T (N m).

    References
    ----------
    R. G. Budynas, J. K. Nisbett, Shigley's Mechanical Engineering Design, 10th ed., McGraw-Hill,
    2015, section 16-5.

    Examples
    --------
    >>> from pydy.vehicles.machines import clutch_capacity
    >>> round(clutch_capacity(4000.0, 0.3, 0.07, 0.11), 3)
    216.0
    """
    values = checked_parameters(
        {"force": force, "friction": friction, "inner": inner, "outer": outer},
        positive=("inner", "outer"),
        not_negative=("force", "friction"),
    )
    F, mu, r_i, r_o = values.values()
    if not (is_symbolic(r_i) or is_symbolic(r_o) or r_i < r_o):
        raise ValueError(f"`inner` must be smaller than `outer`, got {r_i!r} and {r_o!r}.")
    n = integer(faces, "`faces`")
    if flag(worn, "`worn`"):
        return n * mu * F * (r_i + r_o) / 2
    return n * mu * F * 2 * (r_o**2 + r_o * r_i + r_i**2) / (3 * (r_o + r_i))
