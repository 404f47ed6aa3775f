"""Sample systems of any size, for examples, tests and benchmarks."""

from __future__ import annotations

import sympy as sm
import sympy.physics.mechanics as me

from pydy._checks import flag, shown
from pydy._mechanics import Definition
from pydy.system import System

_MOST = 10**6  # far beyond what can be derived; more would fill the memory before that is seen

__all__ = ["multi_mass_spring_damper", "n_link_pendulum_on_cart"]
__dir__ = __all__.copy


def _check_size(n: object) -> None:
    if isinstance(n, bool) or not isinstance(n, int) or not 1 <= n <= _MOST:
        raise ValueError(f"`n` must be a positive integer up to {_MOST}, got {shown(n)}.")


def multi_mass_spring_damper(
    n: int = 1,
    apply_gravity: bool = False,
    apply_external_forces: bool = False,
    external_force_as_sin_of_t: bool = False,
) -> System:
    r"""Return a chain of masses, springs and dampers that hangs from a ceiling.

    ::

        -----------------  ceiling
          |          |
          / k0      ┴ c0     x0: stretch of spring 0
          |          |
        [      m0      ]  ↓ f0
          |          |
          / k1      ┴ c1     x1: stretch of spring 1
          |          |
        [      m1      ]  ↓ f1     g ↓

    Mass i hangs at :math:`x_0 + \dots + x_i` below the ceiling.

    Parameters
    ----------
    n : int, optional
        Number of masses.
    apply_gravity : bool, optional
        Whether gravity acts on each mass, with the constant ``g``.
    apply_external_forces : bool, optional
        Whether a specified force ``f_i(t)`` pulls each mass down.
    external_force_as_sin_of_t : bool, optional
        Whether the external forces are ``sin(t)`` instead of specifieds.

    Returns
    -------
    System
        Coordinates ``x0, ...`` (m), speeds ``v0, ...`` (m/s), constants ``m_i`` (kg), ``k_i``
        (N/m), ``c_i`` (N s/m) and ``g`` (m/s²), specifieds ``f_i`` (N).

    Raises
    ------
    ValueError
        `n` is not a positive integer.

    Examples
    --------
    >>> from pydy.models import multi_mass_spring_damper
    >>> system = multi_mass_spring_damper(2, apply_gravity=True)
    >>> system.constants_symbols
    {c0, c1, g, k0, k1, m0, m1}
    >>> system.states
    [x0(t), x1(t), v0(t), v1(t)]
    """
    _check_size(n)
    apply_gravity = flag(apply_gravity, "`apply_gravity`")
    apply_external_forces = flag(apply_external_forces, "`apply_external_forces`")
    as_sine = flag(external_force_as_sin_of_t, "`external_force_as_sin_of_t`")
    m, k, c = (sm.symbols(f"{letter}:{n}") for letter in "mkc")
    g = sm.Symbol("g")
    x, v, f = (me.dynamicsymbols(f"{letter}:{n}") for letter in "xvf")
    t = me.dynamicsymbols._t

    ceiling = me.ReferenceFrame("N")
    above = me.Point("O")
    above.set_vel(ceiling, 0)
    particles = []
    loads = []
    for i in range(n):
        point = above.locatenew(f"P{i}", x[i] * ceiling.x)
        pull = -k[i] * x[i] - c[i] * v[i]
        if i + 1 < n:
            pull += k[i + 1] * x[i + 1] + c[i + 1] * v[i + 1]
        if apply_gravity:
            pull += m[i] * g
        if apply_external_forces or as_sine:
            pull += sm.sin(t) if as_sine else f[i]
        particles.append(me.Particle(f"mass{i}", point, m[i]))
        loads.append((point, pull * ceiling.x))
        above = point

    return _system(Definition(ceiling, x, v, bodies=particles, loads=loads))


def _system(definition: Definition) -> System:
    definition.as_method = _kanes_method
    return System(definition)


def _kanes_method(definition: Definition) -> me.KanesMethod:
    """Return the KanesMethod for `eom_method`, on demand: SymPy is slow, and few need it."""
    kane = me.KanesMethod(
        definition.frame,
        q_ind=definition.coordinates,
        u_ind=definition.speeds,
        kd_eqs=definition.kinematic_equations,
        kd_eqs_solver=lambda _, rates: rates,  # SymPy's own would eliminate, in n³ steps
    )
    kane.kanes_equations(definition.bodies, definition.loads)
    return kane


def n_link_pendulum_on_cart(
    n: int = 1, cart_force: bool = True, joint_torques: bool = False
) -> System:
    """Return a planar pendulum of n links on a cart that slides along a line.

    Each link is massless with a particle at its end. All angles are measured from the upright
    direction. The equations are those of `sympy.physics.mechanics.models.n_link_pendulum_on_cart`,
    formed from the bodies.

    Parameters
    ----------
    n : int, optional
        Number of links.
    cart_force : bool, optional
        Whether a specified force ``F(t)`` pushes the cart.
    joint_torques : bool, optional
        Whether specified torques ``T1(t), ...`` act in the joints.

    Returns
    -------
    System
        Coordinates ``q0`` (cart, m) and ``q1, ...`` (rad), speeds ``u0, ...``, constants ``g``
        (m/s²), ``l_i`` (m) and ``m_i`` (kg), specifieds ``F`` (N) and ``T_i`` (N m).

    Raises
    ------
    ValueError
        `n` is not a positive integer.

    Examples
    --------
    >>> from pydy.models import n_link_pendulum_on_cart
    >>> system = n_link_pendulum_on_cart(2, joint_torques=True)
    >>> system.specifieds_symbols
    {F(t), T1(t), T2(t)}
    """
    _check_size(n)
    forced, driven = flag(cart_force, "`cart_force`"), flag(joint_torques, "`joint_torques`")
    q, u = me.dynamicsymbols(f"q:{n + 1}"), me.dynamicsymbols(f"u:{n + 1}")
    m, l, g = sm.symbols(f"m:{n + 1}"), sm.symbols(f"l:{n}"), sm.Symbol("g")
    torques = [*me.dynamicsymbols(f"T1:{n + 1}"), 0] if driven else [0] * (n + 1)
    ground, rest = me.ReferenceFrame("I"), me.Point("O")
    rest.set_vel(ground, 0)
    end = rest.locatenew("P0", q[0] * ground.x)
    push = me.dynamicsymbols("F") if forced else 0
    particles = [me.Particle("Pa0", end, m[0])]
    loads = [(end, push * ground.x - m[0] * g * ground.y)]
    for i in range(n):
        link = ground.orientnew(f"B{i}", "Axis", [q[i + 1], ground.z])
        link.set_ang_vel(ground, u[i + 1] * ground.z)
        end = end.locatenew(f"P{i + 1}", l[i] * link.y)
        particles.append(me.Particle(f"Pa{i + 1}", end, m[i + 1]))
        loads.append((end, -m[i + 1] * g * ground.y))
        loads.append((link, (torques[i] - torques[i + 1]) * ground.z))
    return _system(Definition(ground, q, u, bodies=particles, loads=loads))
