"""A wheel on a plane: where it touches, how it slips, and the loads of its tire."""

from __future__ import annotations

import copy
from collections.abc import Callable
from typing import TYPE_CHECKING, Self

import sympy as sm
from sympy.physics.mechanics import Point, ReferenceFrame, RigidBody, Vector

from pydy._checks import instance, shown
from pydy.contact import Stick
from pydy.solvers import Event
from pydy.vehicles.algebra import SymbolicAlgebra, is_symbolic
from pydy.vehicles.forces import Tire, TireForces, checked_parameters
from pydy.vehicles.relaxation import SlidingSpeeds, camber_equation, transient_slips
from pydy.vehicles.tread import WheelMotion, touch_of_cylinder, touch_of_torus
from pydy.vehicles.vectors import cross, dot
from pydy.vehicles.wheel_arguments import (
    Law,
    check_unit,
    normal_force_of,
    rolling_radius_of,
    turning_of,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    from pydy._sympy_types import Expression, Load, TimeFunction


class WheelContact:
    """A wheel, a thin disc, a torus or a cylinder, that touches a plane.

    The contact point C lies on the plane, in the vertical plane through the wheel's axle. Axes at C
    are those of `MagicFormula`: forward along the intersection of the wheel plane with the ground,
    left, and up along the normal. With the deflection ρ, the velocity of the wheel's centre V and
    the sliding velocity V_s, that of the wheel's material at C, ::

        κ = −V_sx/|V_x|    tan α = V_sy/|V_x|    sin γ = axis · normal

    A wheel without drive slip thus rolls on its loaded radius. The effective rolling radius R_e of
    a tire file, a few per cent larger, is used with `rolling_radius`: V_sx = V_x − R_e Ω, with the
    speed of revolution Ω. Forces act at C in either case: their arm is the loaded radius. With a
    crown or a width, C moves sideways with the camber, while the
    Magic Formula's M_x (QSX2) refers to the wheel plane: leave QSX2 out.

    A wheel that rolls without slip needs no tire: give its `nonholonomic_constraints` to the
    model. Without a `force` it is rigid, too, and `holonomic_constraints` keep it on the plane.

    Below `low_speed` that speed replaces the size of V_x: at rest a tire acts as a damper, and a
    wheel on a slope creeps, unless its slips have relaxation, see `with_relaxation`.

    Parameters
    ----------
    body : RigidBody
        The wheel. Its mass centre is its centre, with a velocity in `frame`.
    axis : Vector
        Unit vector along the axle, to the left: a positive rotation about it rolls forward.
    radius : number or expression
        Largest radius of the wheel without load (m).
    plane : Point
        A point of the plane, which moves with it, without turning; mostly at rest in `frame`.
    normal : Vector
        Unit normal of the plane, towards the wheel: constant in `frame`, or that of a `RoadSurface`
        whose `point` is the `plane`.
    frame : ReferenceFrame
        The inertial frame.
    force : callable, optional
        ``force(gap, rate)`` returns the normal force (N), such as a law of `pydy.contact`. The gap
        is the distance to the plane (m), negative where the tire is deflected. Where the law is
        negative there is no force. A law that is negative for some gaps and rates, or grows with a
        positive gap, acts at negative gaps only; another one, such as a smooth one, acts at all
        gaps. By default the wheel is rigid and stays on the plane.
    crown_radius : number or expression, optional
        Radius of the cross section (m): that of a torus, 0 for a thin disc.
    width : number or expression, optional
        Width of a cylinder's flat tread (m). Across it the deflection is a trapezoid, or a triangle
        where camber lifts an edge: `force` gets the mean of it as the gap, C is in its centroid.
        By default the wheel has no width.
    rolling_radius : callable, number or expression, optional
        ``rolling_radius(normal_force)`` returns R_e (m), such as that of `MagicFormula`. By default
        the distance to C within the wheel plane.
    low_speed : number or expression, optional
        Smallest speed that slips are relative to (m/s).
    name : str, optional
        Name of the event.

    Attributes
    ----------
    gap, rate : expression
        Distance of the undeformed wheel to the plane (m), and its time derivative. With a `width`,
        where the wheel touches, the negative mean of the deflection over the width.
    normal_force : expression or None
        Load F_z (N), None for a rigid wheel.
    loaded_radius : expression
        Distance from the centre to the plane within the wheel plane (m).
    contact : Vector
        From the centre to C.
    forward, left : Vector
        Unit vectors.
    speed : expression
        V_x (m/s).
    kappa, alpha, gamma : expression
        Slips and camber, as a tire reads them.
    events : list of Event
        Where the wheel lifts off and touches; none of a rigid wheel.
    holonomic_constraints : list of expressions
        The gap of a rigid wheel; otherwise none.
    nonholonomic_constraints : list of expressions
        Sliding velocity (m/s), forward and to the left: zero if the wheel rolls without slip. It is
        that of the wheel's material at C; with `rolling_radius` the first one is V_x − R_e Ω, where
        R_e is that of the static load, ``force(gap, 0)``. A `KanesMethod` takes them after `rate`,
        among its `velocity_constraints`.
    deflections : tuple of functions of time
        Coordinates that the slips with relaxation need, otherwise none.
    kinematic_equations : list of expressions
        Their equations.

    Notes
    -----
    A wheel that lies on its side has no forward direction: the expressions are singular there.

    References
    ----------
    H. B. Pacejka, Tire and Vehicle Dynamics, 3rd ed., Butterworth-Heinemann, 2012, sections 2.2,
    9.3 and 11.2.

    G. Rill, Road Vehicle Dynamics: Fundamentals and Modeling, CRC Press, 2012, chapter 3, for the
    deflection of a tread that is cambered, and its static contact point.

    Examples
    --------
    A wheel is set on the road at 10 m/s without spin, and ends at two thirds of that speed:

    >>> import numpy as np
    >>> import sympy as sm
    >>> import sympy.physics.mechanics as me
    >>> from pydy import System
    >>> from pydy.contact import kelvin_voigt
    >>> from pydy.mechanics import Definition
    >>> from pydy.vehicles import BrushTire, WheelContact
    >>> x, z, q, vx, vz, w = me.dynamicsymbols('x z q v_x v_z omega')
    >>> N, W, O = me.ReferenceFrame('N'), me.ReferenceFrame('W'), me.Point('O')
    >>> W.orient_axis(N, N.y, q)
    >>> W.set_ang_vel(N, w*N.y)
    >>> O.set_vel(N, 0)
    >>> G = O.locatenew('G', x*N.x + z*N.z)
    >>> G.set_vel(N, vx*N.x + vz*N.z)
    >>> m, r, g = 10, 0.3, 9.81
    >>> disc = me.RigidBody('disc', G, W, m, (me.inertia(W, 0, m*r**2/2, 0), G))
    >>> contact = WheelContact(disc, N.y, r, O, N.z, N,
    ...                        lambda gap, rate: kelvin_voigt(gap, rate, 1e8, 1e4))
    >>> loads = contact.loads(BrushTire(100, stiffness=1000, friction=0.8))
    >>> system = System(Definition(N, [x, z, q], [vx, vz, w], bodies=[disc],
    ...                            loads=[(G, -m*g*N.z), *loads]), ode_solver='radau',
    ...                 initial_conditions={vx: 10, z: r}, times=np.linspace(0, 2, 21))
    >>> round(float(system.simulate()['v_x'][-1]), 2)
    6.67

    The same disc is rigid and rolls without slip. A torque of 3 N m accelerates it by
    τ/(r (m + I/r²)) = 2/3 m/s²:

    >>> rolling = WheelContact(disc, N.y, r, O, N.z, N)
    >>> system = System(Definition(N, [x, z, q], [vx, vz, w], bodies=[disc],
    ...                            loads=[(G, -m*g*N.z), (W, 3*N.y)],
    ...                            holonomic_constraints=rolling.holonomic_constraints,
    ...                            nonholonomic_constraints=rolling.nonholonomic_constraints),
    ...                 initial_conditions={z: r})
    >>> round(float(system.evaluate_ode()[3]), 9)
    0.666666667
    """

    def __init__(
        self,
        body: RigidBody,
        axis: Vector,
        radius: Expression | float,
        plane: Point,
        normal: Vector,
        frame: ReferenceFrame,
        force: Law | None = None,
        *,
        crown_radius: Expression | float = 0.0,
        width: Expression | float | None = None,
        rolling_radius: Callable[[Expression], Expression | float]
        | Expression
        | float
        | None = None,
        low_speed: Expression | float = 0.1,
        name: str = "touch",
    ) -> None:
        instance(body, RigidBody, "`body`")
        instance(plane, Point, "`plane`")
        instance(frame, ReferenceFrame, "`frame`")
        for label, vector in (("axis", axis), ("normal", normal)):
            check_unit(label, vector)
        if not (force is None or callable(force)):
            raise TypeError(f"`force` must be a function or None, got {shown(force)}.")
        given = {"radius": radius, "crown_radius": crown_radius, "low_speed": low_speed}
        sizes = checked_parameters(
            given if width is None else {**given, "width": width},
            positive=("radius", "width", "low_speed"),
            not_negative=("crown_radius",),
        )
        r, crown = sizes["radius"], sizes["crown_radius"]
        if not (is_symbolic(r) or is_symbolic(crown) or crown < r):
            raise ValueError(
                f"`crown_radius` must be smaller than `radius`, got {crown!r} and {r!r}."
            )
        if width is not None and (force is None or crown != 0.0):
            raise ValueError(
                "`width` is that of a flat tread, which is deflected unevenly: give a `force`, and "
                "no `crown_radius`."
            )
        m = SymbolicAlgebra()
        self.body, self.normal = body, normal
        self._axis, self._frame = axis, frame
        centre = body.masscenter
        turning = turning_of(normal, plane, frame)
        wheel = WheelMotion(
            centre.pos_from(plane),
            centre.vel(frame) - plane.vel(frame),
            body.frame.ang_vel_in(frame),
            axis,
            normal,
            turning,
        )
        lean = wheel.lean
        upright = sm.sqrt(1 - lean**2)  # cos γ
        self.forward = cross(axis, normal) / upright
        self.left = cross(normal, self.forward)
        down = cross(axis, self.forward)
        if width is None:
            touch = touch_of_torus(wheel, r, crown, upright, down)
        else:
            touch = touch_of_cylinder(wheel, r, sizes["width"], upright, down)
        self.gap, self.rate = touch.gap, touch.rate
        self.normal_force = None if force is None else normal_force_of(force, self.gap, self.rate)
        self.loaded_radius = dot(wheel.position, normal) / upright
        self.contact = touch.rim if force is None else touch.contact
        velocity, rotation = wheel.velocity, wheel.rotation
        sliding = velocity + cross(rotation, self.contact)
        self.speed = dot(velocity, self.forward)
        sliding_forward = rolling_forward = dot(sliding, self.forward)
        if rolling_radius is not None:
            arm, spin = dot(cross(self.contact, axis), self.forward), dot(rotation, axis)
            radius_now = rolling_radius_of(rolling_radius, self.normal_force)
            sliding_forward += (arm - radius_now) * spin
            # A load that depends on the rate would make the constraint nonlinear in the speeds.
            static = None if force is None else normal_force_of(force, self.gap, sm.S.Zero)
            rolling_forward += (arm - rolling_radius_of(rolling_radius, static)) * spin
        self._sliding = SlidingSpeeds(r, self.speed, sliding_forward, dot(sliding, self.left))
        size = m.maximum(m.abs(self.speed), sizes["low_speed"])
        self.kappa = -self._sliding.forward / size
        self.alpha = sm.sympify(m.atan(self._sliding.left / size))
        self.gamma = sm.sympify(m.asin(lean))
        self.events = [] if force is None else [Event(touch.clearance, name=name)]
        self.holonomic_constraints = [self.gap] if force is None else []
        self.nonholonomic_constraints = [rolling_forward, self._sliding.left]
        self.deflections: tuple[TimeFunction, ...] = ()
        self.kinematic_equations: list[Expression] = []

    def with_relaxation(
        self,
        lengths: Sequence[Expression | float],
        deflections: Sequence[TimeFunction],
        *,
        damping: Expression | float = 0.05,
        low_speed: Expression | float = 1.0,
        sliding_slip: Expression | float = 0.2,
        camber: TimeFunction | None = None,
    ) -> Self:
        """Return the contact with slips that follow with a lag, and that hold at standstill.

        The contact patch is displaced by u forward and by v to the right of the wheel: ::

            u' = −V_sx − D u/σ_κ    κ' = (G u − w T V_sx)/σ_κ
            v' =  V_sy − D v/σ_α    tan α' = (G v + w T V_sy)/σ_α
            D = max(|V_x|, |V_s|/s)    G = D/max(|V_x|, w |V_s|/s)

        with ``w = (1 + cos(π |V_x|/V_low))/2`` below V_low, otherwise 0. κ' and α' become `kappa`
        and `alpha`. Above V_low they are equal to the usual slips in steady motion; below the slip
        s, where G = 1, they follow over the distances σ. At rest the tire is a spring and a damper,
        which a wheel that slides stretches up to the slip s.

        Parameters
        ----------
        lengths : pair of numbers or expressions
            Relaxation lengths σ_κ and σ_α (m), such as those of `MagicFormula.relaxation_lengths`
            at one load, or at `normal_force`. Expressions are at least a 32nd of the radius.
        deflections : pair of functions of time
            u and v (m). They are coordinates of the model, with the `kinematic_equations` of the
            result.
        damping : number or expression, optional
            T (s), the ratio of damping to stiffness of the tire at rest.
        low_speed : number or expression, optional
            V_low (m/s).
        sliding_slip : number or expression, optional
            s, not smaller than the slip of the largest force.
        camber : function of time, optional
            γ' (rad), one more coordinate of the model: the tire's forces follow the camber over
            σ_α, too, with the rate ``|V_x| (γ − γ')/σ_α``, and γ' becomes `gamma`. By default
            camber acts at once.

        Returns
        -------
        WheelContact

        References
        ----------
        H. B. Pacejka, Tyre and Vehicle Dynamics, 2nd ed., Butterworth-Heinemann, 2006, sections
        7.2 and 8.6.

        R. S. Sharp, The stability and control of motorcycles, J. Mech. Eng. Sci. 13 (1971)
        316-329, for the lag of the camber.

        C. Canudas de Wit, P. Tsiotras, E. Velenis, M. Basset, G. Gissinger, Dynamic friction models
        for road/tire longitudinal interaction, Vehicle System Dynamics 39(3), 2003, pp. 189–226.
        """
        values = {"damping": damping, "low_speed": low_speed, "sliding_slip": sliding_slip}
        slips = transient_slips(self._sliding, lengths, deflections, values)
        result = copy.copy(self)
        result.kappa, result.alpha = slips.kappa, slips.alpha
        result.deflections, result.kinematic_equations = tuple(deflections), slips.equations
        if camber is not None:
            equation = camber_equation(self._sliding, lengths, camber, deflections, self.gamma)
            result.gamma = camber
            result.deflections = (*result.deflections, camber)
            result.kinematic_equations = [*slips.equations, equation]
        return result

    def brake(
        self,
        torque: Expression | float,
        carrier: ReferenceFrame | None = None,
        *,
        name: str = "brake",
    ) -> Stick:
        """Return a brake that holds, dry friction between the wheel and its carrier.

        While the wheel turns the torque acts against it. At rest as much of it acts as holds the
        wheel: with relaxation a car with a brake stands still on a slope, and starts when the
        torque falls short. `pydy.contact.Contacts` simulates a System with brakes; its outputs
        ``brake_friction`` and ``brake_sliding`` are the torque and the angular speed.

        Parameters
        ----------
        torque : number or expression
            Of the brake (N m), not negative: of states, time and constants. A simulation in which
            it becomes negative ends with an error: give ``Max(0, torque)``.
        carrier : ReferenceFrame, optional
            What the brake is fixed to, such as the frame of the axle. By default the inertial one.
        name : str, optional
            Name of the brake, for outputs and transitions.

        Returns
        -------
        pydy.contact.Stick

        Examples
        --------
        >>> import sympy as sm
        >>> import sympy.physics.mechanics as me
        >>> from pydy.vehicles import WheelContact
        >>> z, q = me.dynamicsymbols('z q')
        >>> N, W, O = me.ReferenceFrame('N'), me.ReferenceFrame('W'), me.Point('O')
        >>> W.orient_axis(N, N.y, q)
        >>> O.set_vel(N, 0)
        >>> G = O.locatenew('G', z*N.z)
        >>> wheel = me.RigidBody('wheel', G, W, 20, (me.inertia(W, 0, 1, 0), G))
        >>> WheelContact(wheel, N.y, 0.3, O, N.z, N).brake(sm.Symbol('T'), name='front')
        <Stick front>
        """
        if carrier is not None:
            instance(carrier, ReferenceFrame, "`carrier`")
        checked = checked_parameters({"torque": torque}, not_negative=("torque",))
        turning = self.body.frame.ang_vel_in(carrier or self._frame)
        return Stick(dot(turning, self._axis), mu=1, normal=checked["torque"], name=name)

    def forces(self, tire: Tire, pressure: Expression | float | None = None) -> TireForces:
        """Return the forces and moments of a tire on this wheel, for outputs.

        Parameters
        ----------
        tire : tire
            Such as a `MagicFormula`.
        pressure : number or expression, optional
            As for `MagicFormula.forces`.

        Returns
        -------
        TireForces
        """
        if not hasattr(tire, "forces") or isinstance(tire, type):
            raise TypeError(f"`tire` must be a tire, such as MagicFormula, got {shown(tire)}.")
        if self.normal_force is None:
            raise ValueError(
                "`tire` needs a normal force, and this wheel is rigid: give the WheelContact a "
                "`force`, or use its constraints without a tire."
            )
        inputs = (self.normal_force, self.kappa, self.alpha, self.gamma)
        return tire.forces(*inputs, speed=self.speed, pressure=pressure)

    def loads(
        self, tire: Tire | None = None, pressure: Expression | float | None = None
    ) -> list[Load]:
        """Return the force at the wheel's centre and the torque, with what acts at C moved there.

        Parameters
        ----------
        tire : tire, optional
            As for `forces`. Without one the normal force alone acts at C, none on a rigid wheel:
            for wheels that roll without slip.
        pressure : number or expression, optional
            As for `forces`.

        Returns
        -------
        list of pairs
            For `pydy.mechanics.Definition`, or a method of SymPy: of the centre and the force, with
            the normal force, and of the wheel's frame and the torque. A rigid wheel has none.
        """
        if tire is None and pressure is not None:
            raise ValueError("`pressure` is that of a tire, and `tire` is None.")
        if tire is None and self.normal_force is None:
            return []
        forces = TireForces(0, 0, 0, 0, 0) if tire is None else self.forces(tire, pressure)
        force = forces.Fx * self.forward + forces.Fy * self.left + self.normal_force * self.normal
        moment = forces.Mx * self.forward + forces.My * self.left + forces.Mz * self.normal
        torque = moment + cross(self.contact, force)
        return [(self.body.masscenter, force), (self.body.frame, torque)]
