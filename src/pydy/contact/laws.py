"""Laws of contact and friction as SymPy expressions.

A gap is positive while bodies are apart; its rate is its time derivative. Normal forces push the
bodies apart and are not negative. Friction acts on the body whose sliding speed is given, against
that speed.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sm
from sympy.physics.mechanics import Vector

from pydy._checks import flag, number, shown
from pydy._expressions import has_real_values
from pydy._mechanics import checked_vector
from pydy._rank import ROUNDED


def hunt_crossley(
    gap: sm.Expr | float,
    rate: sm.Expr | float,
    stiffness: sm.Expr | float,
    damping: sm.Expr | float,
    exponent: sm.Expr | float = 1.5,
) -> sm.Expr:
    """Return the normal force k δⁿ (1 + λ δ'), with δ = −gap, where bodies touch.

    It is continuous where the bodies touch and part, and differentiable there if n > 1. The bodies
    do not pull at each other: where the law is negative, because they are drawn apart faster than
    1/λ, the force is zero.

    Parameters
    ----------
    gap, rate : expression
        Distance (m) and its time derivative (m/s).
    stiffness : expression
        k, in N/mⁿ. For two spheres, of Hertz's theory.
    damping : expression
        λ, in s/m. For small impact speeds v the coefficient of restitution is 1 − 2 λ v/3. A mass
        that hits at v leaves at w, with v/λ − ln(1 + λ v)/λ² = −w/λ − ln(1 − λ w)/λ².
    exponent : expression, optional
        n; 3/2 for spheres by Hertz's theory, 1 for cylinders, roughly.

    Returns
    -------
    sympy.Expr
        Force in N.

    References
    ----------
    K. H. Hunt, F. R. E. Crossley, Coefficient of restitution interpreted as damping in vibroimpact,
    Journal of Applied Mechanics 42(2), 1975, pp. 440–445.

    Examples
    --------
    >>> import sympy as sm
    >>> from pydy.contact import hunt_crossley
    >>> gap, rate = sm.symbols('gap rate')
    >>> float(hunt_crossley(gap, rate, 2.0, 0.5, 2).subs({gap: -0.5, rate: -1.0}))
    0.75
    >>> hunt_crossley(gap, rate, 2.0, 0.5, 2).subs({gap: 0.1, rate: -1.0})
    0
    """
    depth, rate, k, damping, n = _expressions(
        gap=gap, rate=rate, stiffness=stiffness, damping=damping, exponent=exponent
    )
    return k * sm.Max(-depth, 0) ** n * sm.Max(1 - damping * rate, 0)


def kelvin_voigt(
    gap: sm.Expr | float,
    rate: sm.Expr | float,
    stiffness: sm.Expr | float,
    damping: sm.Expr | float,
    *,
    pulls: bool = False,
) -> sm.Expr:
    """Return the normal force k δ + c δ', with δ = −gap, of a spring and a damper in parallel.

    It jumps by c δ' where the bodies touch: give the solver the touch as an event.

    Parameters
    ----------
    gap, rate : expression
        Distance (m) and its time derivative (m/s).
    stiffness, damping : expression
        k (N/m) and c (N s/m).
    pulls : bool, optional
        Whether the damper may hold back bodies that part. By default a force that would be negative
        is zero.

    Returns
    -------
    sympy.Expr
        Force in N.

    References
    ----------
    W. Goldsmith, Impact: the theory and physical behaviour of colliding solids, Edward Arnold,
    1960, chapter 4.

    Examples
    --------
    >>> import sympy as sm
    >>> from pydy.contact import kelvin_voigt
    >>> gap, rate = sm.symbols('gap rate')
    >>> force = kelvin_voigt(gap, rate, 100.0, 2.0)
    >>> [float(force.subs({gap: -0.1, rate: v})) for v in (-1.0, 0.0, 6.0)]
    [12.0, 10.0, 0.0]
    """
    pulls = flag(pulls, "`pulls`")
    gap, rate, k, c = _expressions(gap=gap, rate=rate, stiffness=stiffness, damping=damping)
    force = -k * gap - c * rate
    return sm.Piecewise((0, gap > 0), (force if pulls else sm.Max(force, 0), True))


def brown_mcphee(
    speed: sm.Expr | float,
    normal: sm.Expr | float,
    mu: sm.Expr | float,
    transition: sm.Expr | float,
    *,
    mu_static: sm.Expr | float | None = None,
    viscous: sm.Expr | float = 0,
    normal_transition: sm.Expr | float | None = None,
) -> sm.Expr:
    """Return smooth Coulomb friction, with a larger coefficient where sliding begins.

    With x = speed/transition it is −N (μ tanh 4x + (μ_s − μ) x/(x²/4 + 3/4)²), which has its
    largest size, nearly μ_s N, at the transition speed. It is smooth in the speed. It does not
    stick: a body on a slope creeps, by less the smaller the transition speed. `Stick` holds it.

    Parameters
    ----------
    speed : expression
        Sliding speed, with its sign (m/s).
    normal : expression
        Normal force N (N), not negative.
    mu : expression
        Coefficient of kinetic friction.
    transition : expression
        Speed of the largest friction (m/s), positive.
    mu_static : expression, optional
        Coefficient of static friction; by default `mu`.
    viscous : expression, optional
        Coefficient of viscous friction (N s/m), whose force is added.
    normal_transition : expression, optional
        Normal force (N) from which on viscous friction is nearly whole: its coefficient is
        multiplied by tanh(4 N/normal_transition). By default it acts without a normal force.

    Returns
    -------
    sympy.Expr
        Force in N, against the speed.

    References
    ----------
    P. Brown, J. McPhee, A continuous velocity-based friction model for dynamics and control with
    physically meaningful parameters, Journal of Computational and Nonlinear Dynamics 11(5), 2016,
    054502.

    Examples
    --------
    >>> from pydy.contact import brown_mcphee
    >>> round(float(brown_mcphee(0.1, 10.0, 0.2, 0.1, mu_static=0.3)), 5)
    -2.99866
    """
    v, n, mu, slow, viscous = _expressions(
        speed=speed, normal=normal, mu=mu, transition=transition, viscous=viscous
    )
    (peak,) = _expressions(mu_static=mu if mu_static is None else mu_static)
    x = v / slow
    peak_term = (peak - mu) * x / (x**2 / 4 + sm.Rational(3, 4)) ** 2
    if normal_transition is not None:
        (light,) = _expressions(normal_transition=normal_transition)
        viscous = viscous * sm.tanh(4 * n / light)
    return -n * (mu * sm.tanh(4 * x) + peak_term) - viscous * v


def stribeck(
    speed: sm.Expr | float,
    normal: sm.Expr | float,
    mu: sm.Expr | float,
    mu_static: sm.Expr | float,
    stribeck_speed: sm.Expr | float,
    *,
    viscous: sm.Expr | float = 0,
    exponent: sm.Expr | float = 2,
    transition: sm.Expr | float | None = None,
) -> sm.Expr:
    """Return friction that falls from static to kinetic friction as the sliding speed grows.

    It is −N (μ + (μ_s − μ) exp(−|v/v_s|ⁿ)) sign v − c v.

    Parameters
    ----------
    speed : expression
        Sliding speed v, with its sign (m/s).
    normal : expression
        Normal force N (N), not negative.
    mu, mu_static : expression
        Coefficients of kinetic and static friction.
    stribeck_speed : expression
        v_s (m/s), positive.
    viscous : expression, optional
        c (N s/m).
    exponent : expression, optional
        n; 2 by default, and 1 in Tustin's law.
    transition : expression, optional
        A speed (m/s): sign v becomes tanh(v/transition), and the law is differentiable in the
        speed for even n. By default the force jumps where the speed is zero.

    Returns
    -------
    sympy.Expr
        Force in N, against the speed.

    References
    ----------
    B. Armstrong-Hélouvry, P. Dupont, C. Canudas de Wit, A survey of models, analysis tools and
    compensation methods for the control of machines with friction, Automatica 30(7), 1994,
    pp. 1083–1138, eq. 4.

    Examples
    --------
    >>> from pydy.contact import stribeck
    >>> [round(float(stribeck(v, 10.0, 0.2, 0.4, 0.01)), 6) for v in (1e-9, 0.01, 1.0)]
    [-4.0, -2.735759, -2.0]
    """
    v, n, mu, peak, slow, viscous, power = _expressions(
        speed=speed,
        normal=normal,
        mu=mu,
        mu_static=mu_static,
        stribeck_speed=stribeck_speed,
        viscous=viscous,
        exponent=exponent,
    )
    sign = sm.sign(v)
    if transition is not None:
        sign = sm.tanh(v / _expressions(transition=transition)[0])
    size = v / slow if power.is_even else sm.Abs(v / slow)
    return -n * (mu + (peak - mu) * sm.exp(-(size**power))) * sign - viscous * v


def rolling_resistance(
    rate: sm.Expr | float,
    normal: sm.Expr | float,
    arm: sm.Expr | float,
    transition: sm.Expr | float,
) -> sm.Expr:
    """Return the torque −b N tanh(ω/ω_t) against rolling; it is smooth in the rate.

    Parameters
    ----------
    rate : expression
        Angular speed ω of rolling, with its sign (rad/s).
    normal : expression
        Normal force N (N), not negative.
    arm : expression
        Coefficient of rolling friction b (m): how far the normal force is ahead of the centre.
    transition : expression
        Angular speed ω_t (rad/s), positive, at which 76 % of the torque act.

    Returns
    -------
    sympy.Expr
        Torque in N m, against the rate.

    References
    ----------
    J. Ai, J.-F. Chen, J. M. Rotter, J. Y. Ooi, Assessment of rolling resistance models in discrete
    element simulations, Powder Technology 206(3), 2011, pp. 269–282, model A, with the sign of the
    rate made smooth.

    Examples
    --------
    >>> from pydy.contact import rolling_resistance
    >>> round(float(rolling_resistance(5.0, 10.0, 0.002, 0.1)), 9)
    -0.02
    """
    w, n, b, slow = _expressions(rate=rate, normal=normal, arm=arm, transition=transition)
    return -b * n * sm.tanh(w / slow)


def joint_friction(
    rate: sm.Expr | float,
    normal: sm.Expr | float,
    mu: sm.Expr | float,
    radius: sm.Expr | float,
    transition: sm.Expr | float,
    *,
    mu_static: sm.Expr | float | None = None,
) -> sm.Expr:
    """Return the friction torque of a dry journal bearing under a given load.

    The pin touches its bearing in a line, at which the friction of `brown_mcphee` acts. With
    Coulomb's friction the load passes the axis at the radius of the friction circle,
    r μ/√(1 + μ²).

    Parameters
    ----------
    rate : expression
        Relative angular speed of the joint, with its sign (rad/s).
    normal : expression
        Size of the load that the joint carries (N), friction included: a number, or an expression.
        It must not depend on the accelerations.
    mu : expression
        Coefficient of kinetic friction.
    radius : expression
        Radius r of the pin (m).
    transition : expression
        Sliding speed of the largest friction (m/s), positive.
    mu_static : expression, optional
        Coefficient of static friction; by default `mu`.

    Returns
    -------
    sympy.Expr
        Torque in N m, against the rate.

    References
    ----------
    J. L. Meriam, L. G. Kraige, Engineering Mechanics: Statics, 7th ed., Wiley, 2012, §6/6.

    Examples
    --------
    >>> from pydy.contact import joint_friction
    >>> round(float(joint_friction(10.0, 100.0, 0.75, 0.02, 1e-3)), 9)
    -1.2
    """
    w, n, mu, r = _expressions(rate=rate, normal=normal, mu=mu, radius=radius)
    (peak,) = _expressions(mu_static=mu if mu_static is None else mu_static)
    pressing = n / sm.sqrt(1 + mu**2)
    return r * brown_mcphee(r * w, pressing, mu, transition, mu_static=peak)


_POSITIVE = {"exponent", "transition", "stribeck_speed", "normal_transition", "smoothing"}
_NOT_NEGATIVE = {
    *("stiffness", "damping", "normal", "mu", "mu_static", "viscous", "arm", "radius"),
}


def _expressions(**arguments: object) -> list[sm.Expr]:
    """Return the arguments as SymPy expressions; numbers must be finite and in their range."""
    expressions = []
    for name, value in arguments.items():
        if isinstance(value, sm.Expr) and not value.is_number:
            if not has_real_values(value):
                raise ValueError(f"`{name}` must have real values, got {shown(value)}.")
            expressions.append(value)
            continue
        if not hasattr(value, "__float__") and not isinstance(value, sm.Basic):
            raise TypeError(f"`{name}` must be an expression or a number, got {shown(value)}.")
        numeric = number(value, f"`{name}`", finite=True)
        if name in _POSITIVE and not numeric > 0.0:
            raise ValueError(f"`{name}` must be positive, got {numeric:g}.")
        if name in _NOT_NEGATIVE and numeric < 0.0:
            raise ValueError(
                f"`{name}` must not be negative, got {numeric:g}: the force would add energy."
            )
        is_exact = isinstance(value, (int, sm.Expr)) and not isinstance(value, bool)
        expressions.append(sm.sympify(value if is_exact else numeric))
    return expressions


def _check_units(argument: str, vectors: Iterable[Vector]) -> None:
    """Refuse vectors whose length is a number other than 1: it would scale the forces."""
    for vector in vectors:
        length = sm.simplify(vector.dot(vector))
        if length.is_number and not abs(length - 1) <= ROUNDED:
            raise ValueError(
                f"`{argument}` must be of unit length, got {vector}. Divide it by its length: "
                "forces are along it."
            )


def _axes(argument: Vector | Sequence[Vector] | None) -> tuple[Vector, ...]:
    vectors = () if argument is None else (argument,) if isinstance(argument, Vector) else argument
    valid = isinstance(vectors, (list, tuple)) and len(vectors) <= 2
    if not valid or not all(isinstance(v, Vector) for v in vectors):
        raise TypeError(f"`along` must be one Vector or two, got {shown(argument)}.")
    for v in vectors:
        checked_vector(v, "`along`")
    axes: tuple[Vector, ...] = tuple(vectors)
    if len(axes) == 2:
        product = sm.simplify(axes[0].dot(axes[1]))
        if product.is_number and not abs(product) <= ROUNDED:
            raise ValueError(f"`along` must be orthogonal vectors, got {axes[0]} and {axes[1]}.")
    _check_units("along", axes)
    return axes
