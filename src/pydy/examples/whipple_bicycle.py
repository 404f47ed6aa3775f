r"""The Carvallo-Whipple bicycle, nonlinear, with the parameters of the 2007 benchmark.

Four rigid bodies: a rear frame B that carries a rigid rider, a front frame H (fork and handlebar)
hinged to it at the steer axis, and two knife-edged wheels, R behind and F in front, that roll
without slipping on level ground.  It is the model behind most of what is known about why a bicycle
balances itself, and a small but demanding test of a multibody code: one configuration constraint
with no handy closed solution, and rolling constraints that cannot be integrated at all.

::

              \   <- steer axis, leans back by lam
     B    _____\
      ___/      \ H                      o--> x: forward
     / \         \                       |
   .-----.      .-\---.                  v    z: down
  |   R   |    |   F   |                 y: to the rider's right
   '-----'      '--\--'
  ----P------------Pf-*------ ground
      |<---- w --->|<c>|                 P, Pf: contact points

Frames
    Each one turns about a single axis of the one before, so every rotation is a 2 x 2 affair::

        N --psi, z--> A --phi, x--> E --theta, y--> B --lam, y--> S --delta, z--> K --(-lam), y--> H
          yaw           roll          pitch         (constant)     steer           (constant)

    S and K are the rear and the front frame seen along the steer axis.  B and H are the same two
    bodies seen along the axes of the upright bicycle: the published products of inertia and centres
    of mass refer to those, and therefore enter exactly as they were printed.

Coordinates and speeds
    Eight coordinates: the rear contact point (x, y), yaw, roll, pitch, steer, and the angle of each
    wheel relative to its frame.  The speeds are the rates of the four angles of the frames, the
    velocity of the rear contact point forward and sideways *along the heading*, and the spin of
    each wheel about its axle *as seen from the ground*.  These last two choices cost a line of
    kinematics each; one keeps the yaw angle out of the dynamics, the other keeps the terms of the
    wheels short.

Constraints
    ==============  ===================================  ====================
    kind            statement                            dependent variable
    ==============  ===================================  ====================
    configuration   front wheel touches the ground       theta
    its rate        front contact does not rise          u_theta
    no slip         front contact, along the axle        u_psi
    no slip         front contact, along the heading     omega_F
    no slip         rear contact, along the heading      u_x
    no slip         rear contact, sideways               u_y
    ==============  ===================================  ====================

    In this order the matrix of the dependent speeds is lower triangular, so that solving for them
    adds little to the equations.  Three speeds stay free: roll, steer and rear wheel.

Contact forces
    The ground's vertical push does no work and does not show in the equations of motion.  So each
    contact point is given a fictitious upward speed (u_r, u_f) that is zero in truth; with one more
    equation for each, Kane's method yields the two forces N_r and N_f ([2]_).

The parameters, their names and the axes are those of the benchmark [1]_, and so are the eigenvalues
that `PUBLISHED_EIGENVALUES` repeats.

References
----------
.. [1] J. P. Meijaard, J. M. Papadopoulos, A. Ruina and A. L. Schwab, "Linearized dynamics equations
   for the balance and steer of a bicycle: a benchmark and review", Proc. R. Soc. A 463 (2007)
   1955-1982, tables 1 and 2.
.. [2] T. R. Kane and D. A. Levinson, "Dynamics: Theory and Applications", McGraw-Hill 1985,
   section 4.9 (bringing noncontributing forces into evidence).

Examples
--------
>>> from pydy.examples import whipple_bicycle
>>> bicycle = whipple_bicycle.derive()
>>> bicycle.speeds
(u_phi(t), u_delta(t), omega_R(t), u_theta(t), u_psi(t), omega_F(t), u_x(t), u_y(t))
>>> values = whipple_bicycle.benchmark_parameters(bicycle)
>>> values[bicycle["w"]]
1.02
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING

import sympy as sm
import sympy.physics.mechanics as me

from pydy._forks import cached_property
from pydy.mechanics import Definition

if TYPE_CHECKING:
    from sympy import Expr

    from pydy._sympy_types import Body

__all__ = [
    "BENCHMARK",
    "PUBLISHED_EIGENVALUES",
    "Bicycle",
    "benchmark_parameters",
    "derive",
    "energy",
    "equilibrium",
]
__dir__ = __all__.copy

BENCHMARK: Mapping[str, float] = {
    "w": 1.02,  # wheel base
    "c": 0.08,  # trail
    "lam": pi / 10,  # steer axis tilt, back from the vertical (head angle 72 degrees)
    "g": 9.81,
    "r_R": 0.3,  # rear wheel R
    "m_R": 2.0,
    "I_Rxx": 0.0603,
    "I_Ryy": 0.12,
    "x_B": 0.3,  # rear frame and rider B
    "z_B": -0.9,
    "m_B": 85.0,
    "I_Bxx": 9.2,
    "I_Bxz": 2.4,
    "I_Byy": 11.0,
    "I_Bzz": 2.8,
    "x_H": 0.9,  # front frame H: handlebar and fork
    "z_H": -0.7,
    "m_H": 4.0,
    "I_Hxx": 0.05892,
    "I_Hxz": -0.00756,
    "I_Hyy": 0.06,
    "I_Hzz": 0.00708,
    "r_F": 0.35,  # front wheel F
    "m_F": 3.0,
    "I_Fxx": 0.1405,
    "I_Fyy": 0.28,
}
"""Value of every constant by its name, from table 1 of the benchmark, in SI units; exact."""

PUBLISHED_EIGENVALUES: Mapping[float, tuple[complex, ...]] = {
    5.0: (
        complex(-0.775341882195845, 4.46486771378823),  # weave
        complex(-0.775341882195845, -4.46486771378823),
        complex(-0.322866429004087),  # capsize
        complex(-14.0783896927982),  # castering
    ),
}
"""Eigenvalues in 1/s of upright straight riding, by forward speed in m/s, from its table 2."""


@dataclass(frozen=True)
class Bicycle:
    """The derived bicycle: its equations and the symbols they are written in.

    ``bicycle[name]`` is the symbol called `name`, be it a state (``"phi"``, ``"omega_R"``), a
    constant (``"I_Bxx"``), an input (``"F_y"``) or a contact force (``"N_f"``).

    Attributes
    ----------
    definition : pydy.mechanics.Definition
        What `System` forms the equations of motion from.
    coordinates : tuple of 8 functions of time
        x, y, psi, phi, delta, theta_R, theta_F, and the dependent pitch theta, in m and rad.
    speeds : tuple of 8 functions of time
        u_phi, u_delta, omega_R, and the dependent u_theta, u_psi, omega_F, u_x, u_y, in m/s, rad/s.
        A wheel that rolls forward spins the negative way about its axle, for y points to the right.
    auxiliary_speeds : tuple of 2 functions of time
        u_r, u_f: the fictitious upward speeds of the contact points, always zero in m/s.
    contact_forces : tuple of 2 functions of time
        N_r, N_f: the ground's upward push on the rear and on the front wheel, in N.
    push : function of time
        F_y: a level force on the rear frame's mass centre, to the right of the heading, in N.
    roll_torque : function of time
        T_phi: an outer torque on the rear frame about the heading, leaning it to the right, in N m.
    steer_torque : function of time
        T_delta: the rider's torque on the front frame about the steer axis, to the right, in N m;
        its reaction acts on the rear frame.
    constants : tuple of 26 symbols
        In the order of `BENCHMARK`.
    bodies : tuple of 4 RigidBody
        Rear wheel, rear frame, front frame, front wheel; each with its potential energy set.
    frames : mapping of str to ReferenceFrame
        N, A, E, B, S, K, H of the module's drawing, and R and F, which turn with the wheels.
    points : mapping of str to Point
        The origin O, the mass centres Ro, Bo, Ho, Fo and the contact points P and Pf, each with its
        position, for drawing.
    symbols : mapping of str to symbol or function of time
        What ``bicycle[name]`` looks up.
    """

    definition: Definition
    coordinates: tuple[Expr, ...]
    speeds: tuple[Expr, ...]
    auxiliary_speeds: tuple[Expr, ...]
    contact_forces: tuple[Expr, ...]
    push: Expr
    roll_torque: Expr
    steer_torque: Expr
    constants: tuple[Expr, ...]
    bodies: tuple[Body, ...]
    frames: Mapping[str, me.ReferenceFrame]
    points: Mapping[str, me.Point]
    symbols: Mapping[str, Expr]

    @cached_property
    def kane(self) -> me.KanesMethod:
        """The same as SymPy's KanesMethod, constructed when it is first used."""
        definition = self.definition
        return me.KanesMethod(
            *(
                definition.frame,
                self.coordinates[:7],
                self.speeds[:3],
                definition.kinematic_equations,
            ),
            *(self.coordinates[7:], definition.holonomic_constraints),
            *(self.speeds[3:], definition.velocity_constraints, None),
            *(self.auxiliary_speeds, self.bodies, definition.loads),
        )

    def __getitem__(self, name: str) -> Expr:
        """Return the symbol called `name`."""
        try:
            return self.symbols[name]
        except KeyError:
            names = ", ".join(self.symbols)
            raise KeyError(f"the bicycle has no symbol {name!r}; it has {names}") from None


def derive() -> Bicycle:
    """Derive the nonlinear equations of motion of the bicycle.

    Returns
    -------
    Bicycle
        The equations and their symbols.  It takes half a second.

    Notes
    -----
    Two devices keep the equations small.  Every vector is written in the frame where it is shortest
    and is turned one axis at a time, which nests the sums instead of multiplying them out.  And the
    velocity of each wheel's centre is written as that of a wheel that rolls, from its own angular
    velocity alone: the constraints make it equal to what the chain of frames would give, and Kane's
    method needs velocities that agree only where the constraints hold.
    """
    w, c, lam, g = sm.symbols("w c lam g")
    r_R, m_R, I_Rxx, I_Ryy = sm.symbols("r_R m_R I_Rxx I_Ryy")
    x_B, z_B, m_B, I_Bxx, I_Bxz, I_Byy, I_Bzz = sm.symbols("x_B z_B m_B I_Bxx I_Bxz I_Byy I_Bzz")
    x_H, z_H, m_H, I_Hxx, I_Hxz, I_Hyy, I_Hzz = sm.symbols("x_H z_H m_H I_Hxx I_Hxz I_Hyy I_Hzz")
    r_F, m_F, I_Fxx, I_Fyy = sm.symbols("r_F m_F I_Fxx I_Fyy")

    x, y, psi, phi, delta = me.dynamicsymbols("x y psi phi delta")
    theta, theta_R, theta_F = me.dynamicsymbols("theta theta_R theta_F")
    u_x, u_y, u_psi, u_phi, u_delta = me.dynamicsymbols("u_x u_y u_psi u_phi u_delta")
    u_theta, omega_R, omega_F = me.dynamicsymbols("u_theta omega_R omega_F")
    u_r, u_f = me.dynamicsymbols("u_r u_f")
    N_r, N_f, F_y, T_phi, T_delta = me.dynamicsymbols("N_r N_f F_y T_phi T_delta")

    # --- Frames ---------------------------------------------------------------------------------

    N, A, E, B, S, K, H, R, F = (me.ReferenceFrame(name) for name in "NAEBSKHRF")
    A.orient_axis(N, N.z, psi)
    E.orient_axis(A, A.x, phi)
    B.orient_axis(E, E.y, theta)
    # From E rather than from B: sin(theta + lam) instead of products of two angles' sines.
    S.orient_axis(E, E.y, theta + lam)
    K.orient_axis(S, S.z, delta)
    H.orient_axis(K, K.y, -lam)
    R.orient_axis(B, B.y, theta_R)
    F.orient_axis(H, H.y, theta_F)

    def in_front_frame(vector: me.Vector) -> me.Vector:
        # One axis at a time: SymPy's direct way from E to K multiplies the two rotations out.
        return vector.express(S).express(K)

    # --- Angular velocities, in terms of the speeds ---------------------------------------------

    w_E = u_phi * E.x + u_psi * A.z.express(E)
    w_B = w_E + u_theta * E.y
    w_H = in_front_frame(w_B) + u_delta * K.z
    for frame, angular_velocity in (
        (A, u_psi * A.z),
        (E, w_E),
        (B, w_B),
        (S, w_B),
        (K, w_H),
        (H, w_H),
        # A wheel moves with its frame and spins about the axle, with a speed of its own.
        (R, w_E + (omega_R - w_E.dot(E.y)) * E.y),
        (F, w_H + (omega_F - w_H.dot(K.y)) * K.y),
    ):
        frame.set_ang_vel(N, angular_velocity)
    # E keeps the rear axle, K the front axle: said outright, it shows SymPy at a glance that a
    # wheel's inertia, written in a frame that does not spin, is constant in the wheel.
    R.set_ang_vel(E, (omega_R - w_E.dot(E.y)) * E.y)
    F.set_ang_vel(K, (omega_F - w_H.dot(K.y)) * K.y)
    w_R, w_F = R.ang_vel_in(N), F.ang_vel_in(N)

    # --- Geometry -------------------------------------------------------------------------------

    # Upright, the wheel centres are at (0, -r_R) and (w, -r_F) in (x, z), and the steer axis goes
    # through (w + c, 0) in the direction (sin lam, cos lam).  Hence the arms seen along that axis:
    rear_arm = (w + c) * sm.cos(lam) - r_R * sm.sin(lam)  # rear wheel centre to steer axis
    axis_length = w * sm.sin(lam) + (r_R - r_F) * sm.cos(lam)  # along the axis
    front_arm = r_F * sm.sin(lam) - c * sm.cos(lam)  # steer axis to front wheel centre
    to_B = x_B * B.x + (z_B + r_R) * B.z  # from the rear wheel centre
    to_H = (x_H - w) * H.x + (z_H + r_F) * H.z  # from the front wheel centre

    # The vertical, and the direction in each wheel's plane that leads down to the contact point:
    # for R simply E.z; for F the vertical less its part along the axle, made a unit vector.
    down_E = A.z.express(E)
    down_K = in_front_frame(down_E)
    sin_lean = down_K.dot(K.y)
    cos_lean = sm.sqrt(1 - sin_lean**2)
    to_contact_F = down_K.dot(K.x) / cos_lean * K.x + down_K.dot(K.z) / cos_lean * K.z
    heading_F = K.y.cross(to_contact_F)  # level, along the front wheel's track

    O, P, Ro, Bo, Ho, Fo, Pf = (me.Point(name) for name in ("O", "P", "Ro", "Bo", "Ho", "Fo", "Pf"))
    P.set_pos(O, x * N.x + y * N.y)
    Ro.set_pos(P, -r_R * E.z)
    Bo.set_pos(Ro, to_B)
    Fo.set_pos(Ro, rear_arm * S.x + axis_length * S.z + front_arm * K.x)
    Ho.set_pos(Fo, to_H)
    Pf.set_pos(Fo, r_F * to_contact_F)

    height_R = r_R * down_E.dot(E.z)
    height_B = height_R - to_B.express(E).dot(down_E)
    height_F = (
        height_R
        - (rear_arm * S.x + axis_length * S.z).express(E).dot(down_E)
        - front_arm * down_K.dot(K.x)
    )
    height_H = height_F - to_H.express(K).dot(down_K)
    height_Pf = height_F - r_F * cos_lean

    # --- Velocities -----------------------------------------------------------------------------

    # Of two wheels that roll; all above a contact point rises with it.
    rising_R = -u_r * A.z
    rising_F = -u_f * A.z
    v_Ro = w_R.cross(-r_R * E.z)
    v_Fo = w_F.cross(-r_F * to_contact_F)
    P.set_vel(N, rising_R)
    Ro.set_vel(N, v_Ro + rising_R)
    Bo.set_vel(N, v_Ro + w_B.cross(to_B.express(E)) + rising_R)
    Fo.set_vel(N, v_Fo + rising_F)
    Ho.set_vel(N, v_Fo + w_H.cross(to_H.express(K)) + rising_F)
    Pf.set_vel(N, rising_F)

    # --- Kinematics and constraints -------------------------------------------------------------

    rates = {
        x: u_x * sm.cos(psi) - u_y * sm.sin(psi),
        y: u_x * sm.sin(psi) + u_y * sm.cos(psi),
        psi: u_psi,
        phi: u_phi,
        delta: u_delta,
        theta_R: omega_R - w_B.dot(E.y),
        theta_F: omega_F - w_H.dot(K.y),
        theta: u_theta,
    }
    t = me.dynamicsymbols._t
    rate_of = {coordinate.diff(t): rate for coordinate, rate in rates.items()}

    # What the chain of frames, starting from the rolling rear wheel, makes of the velocity of the
    # front wheel's centre; seen from there, the particle that touches the ground moves along the
    # track with r_F * omega_F.  Together they must leave no more than the fictitious speeds allow.
    along_axis = (rear_arm * S.x + axis_length * S.z).express(E)
    chain_Fo = in_front_frame(v_Ro + w_B.cross(along_axis)) + w_H.cross(front_arm * K.x)
    turning_F = w_F.cross(r_F * to_contact_F)

    velocity_constraints = [
        height_Pf.diff(t).xreplace(rate_of) + u_r - u_f,
        (chain_Fo + turning_F).dot(K.y) + (u_f - u_r) * sin_lean,
        chain_Fo.dot(heading_F) + r_F * omega_F,
        # The contact point P moves on as the wheel turns against E, which holds the axle.
        u_x + r_R * (omega_R - w_E.dot(E.y)),
        u_y,
    ]

    # --- Bodies and loads -----------------------------------------------------------------------

    inertia_R = me.inertia(E, I_Rxx, I_Ryy, I_Rxx)
    inertia_B = me.inertia(B, I_Bxx, I_Byy, I_Bzz, izx=I_Bxz)
    # In K, like the angular velocity it multiplies: the turn by lam is then constant numbers only.
    inertia_H = me.inertia(H, I_Hxx, I_Hyy, I_Hzz, izx=I_Hxz).express(K)
    inertia_F = me.inertia(K, I_Fxx, I_Fyy, I_Fxx)
    bodies = (
        me.RigidBody("rear wheel", Ro, R, m_R, (inertia_R, Ro)),
        me.RigidBody("rear frame", Bo, B, m_B, (inertia_B, Bo)),
        me.RigidBody("front frame", Ho, H, m_H, (inertia_H, Ho)),
        me.RigidBody("front wheel", Fo, F, m_F, (inertia_F, Fo)),
    )
    for body, height in zip(bodies, (height_R, height_B, height_H, height_F), strict=True):
        body.potential_energy = body.mass * g * height
    loads = [
        (Ro, m_R * g * down_E),
        (Bo, m_B * g * down_E + F_y * A.y),
        (Ho, m_H * g * down_K),
        (Fo, m_F * g * down_K),
        (B, T_phi * E.x - T_delta * S.z),
        (H, T_delta * K.z),
        (P, -N_r * A.z),
        (Pf, -N_f * A.z),
    ]

    # --- Equations ------------------------------------------------------------------------------

    coordinates = (x, y, psi, phi, delta, theta_R, theta_F, theta)
    speeds = (u_phi, u_delta, omega_R, u_theta, u_psi, omega_F, u_x, u_y)
    definition = Definition(
        *(N, coordinates, speeds),
        bodies=bodies,
        loads=loads,
        kinematic_equations=[q.diff(t) - rate for q, rate in rates.items()],
        holonomic_constraints=[height_Pf],
        velocity_constraints=velocity_constraints,
        dependent_coordinates=coordinates[7:],
        dependent_speeds=speeds[3:],
        auxiliary_speeds=[u_r, u_f],
    )

    constants = sm.symbols(tuple(BENCHMARK))
    functions = (*coordinates, *speeds, u_r, u_f, N_r, N_f, F_y, T_phi, T_delta)
    return Bicycle(
        definition=definition,
        coordinates=coordinates,
        speeds=speeds,
        auxiliary_speeds=(u_r, u_f),
        contact_forces=(N_r, N_f),
        push=F_y,
        roll_torque=T_phi,
        steer_torque=T_delta,
        constants=constants,
        bodies=bodies,
        frames={frame.name: frame for frame in (N, A, E, B, S, K, H, R, F)},
        points={point.name: point for point in (O, P, Ro, Bo, Ho, Fo, Pf)},
        symbols={symbol.name: symbol for symbol in (*constants, *functions)},
    )


def benchmark_parameters(model: Bicycle) -> dict[Expr, float]:
    """Return the constants of the benchmark bicycle.

    Parameters
    ----------
    model : Bicycle
        What `derive` returned.

    Returns
    -------
    dict of symbol to float
        The value of each of the 26 constants, in SI units, [1]_ table 1.

    References
    ----------
    .. [1] J. P. Meijaard, J. M. Papadopoulos, A. Ruina and A. L. Schwab, Proc. R. Soc. A 463 (2007)
       1955-1982.
    """
    return {symbol: BENCHMARK[symbol.name] for symbol in model.constants}


def equilibrium(
    model: Bicycle, speed: float, parameters: Mapping[Expr, float] | None = None
) -> dict[Expr, float]:
    """Return the state of the bicycle that rides straight ahead and upright.

    Parameters
    ----------
    model : Bicycle
        What `derive` returned.
    speed : float
        Forward speed in m/s.
    parameters : mapping of symbol to float, optional
        Must give the wheel radii; the benchmark's by default.

    Returns
    -------
    dict of function of time to float
        A value for each coordinate, then each speed.  It satisfies every constraint: pitch counts
        from the upright bicycle that stands on both wheels, so it is zero here.
    """
    values = benchmark_parameters(model) if parameters is None else parameters
    state = dict.fromkeys((*model.coordinates, *model.speeds), 0.0)
    state[model["u_x"]] = float(speed)
    state[model["omega_R"]] = -speed / values[model["r_R"]]
    state[model["omega_F"]] = -speed / values[model["r_F"]]
    return state


def energy(model: Bicycle) -> tuple[Expr, Expr]:
    """Return the energy of the bicycle.

    Parameters
    ----------
    model : Bicycle
        What `derive` returned.

    Returns
    -------
    kinetic, potential : Expr
        In J, in terms of the constants, coordinates and speeds; heights count from the ground.
        Their sum is constant while no push and no torque acts.
    """
    at_rest = dict.fromkeys(model.auxiliary_speeds, 0)
    ground = model.frames["N"]
    kinetic = sum(body.kinetic_energy(ground) for body in model.bodies)
    potential = sum(body.potential_energy for body in model.bodies)
    return kinetic.xreplace(at_rest), potential
