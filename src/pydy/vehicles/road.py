"""Roads that are not plane: a surface given by an expression."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import Point, ReferenceFrame, Vector, dynamicsymbols

from pydy._checks import instance, shown
from pydy.vehicles.algebra import checked_quantity
from pydy.vehicles.vectors import dot
from pydy.vehicles.wheel import WheelContact
from pydy.vehicles.wheel_arguments import SurfacePoint

if TYPE_CHECKING:
    from pydy._sympy_types import Expression, TimeFunction


class RoadSurface:
    """A smooth surface z(x, y), as one wheel touches it.

    The wheel touches the tangent plane of the surface at C, the point of the surface that is below
    the axle in the wheel plane. Two functions of time are the place of C on the surface; they
    follow from two equations, which a System solves as an `Implicit`. Each wheel needs a surface
    with functions of its own.

    Parameters
    ----------
    height : expression
        z (m), of the two functions; without kinks, and curved less than the wheel.
    place : pair of functions of time
        x and y of the contact point (m).
    origin : Point
        Where x, y and z begin, at rest.
    frame : ReferenceFrame
        The inertial frame, whose axes x, y and z are along.

    Attributes
    ----------
    point : Point
        The contact point C.
    normal : Vector
        The unit normal of the surface there, up.
    place : tuple of functions of time

    References
    ----------
    G. Rill, Road Vehicle Dynamics: Fundamentals and Modeling, CRC Press, 2012, chapter 3.

    Examples
    --------
    A wheel rolls through a valley, and comes up again to the height where it began:

    >>> import numpy as np
    >>> import sympy as sm
    >>> import sympy.physics.mechanics as me
    >>> from pydy import System
    >>> from pydy.mechanics import Definition, Implicit
    >>> from pydy.vehicles import RoadSurface, WheelContact
    >>> x, z, q, vx, vz, w, X, Y = me.dynamicsymbols('x z q v_x v_z omega X Y')
    >>> N, W, O = me.ReferenceFrame('N'), me.ReferenceFrame('W'), me.Point('O')
    >>> W.orient_axis(N, N.y, q)
    >>> W.set_ang_vel(N, w*N.y)
    >>> O.set_vel(N, 0)
    >>> G = O.locatenew('G', x*N.x + z*N.z)
    >>> G.set_vel(N, vx*N.x + vz*N.z)
    >>> m, r, g = 10, 0.3, 9.81
    >>> disc = me.RigidBody('disc', G, W, m, (me.inertia(W, 0, m*r**2/2, 0), G))
    >>> valley = RoadSurface(0.1*X**2, (X, Y), O, N)
    >>> wheel = WheelContact(disc, N.y, r, valley.point, valley.normal, N)
    >>> system = System(Definition(N, [x, z, q], [vx, vz, w], bodies=[disc], loads=[(G, -m*g*N.z)],
    ...                            holonomic_constraints=wheel.holonomic_constraints,
    ...                            nonholonomic_constraints=wheel.nonholonomic_constraints[:1],
    ...                            dependent_coordinates=[z], dependent_speeds=[vz, w]),
    ...                 implicit=Implicit(valley.residuals(wheel)), ode_solver='dop853',
    ...                 initial_conditions={x: 1.0}, times=np.linspace(0, 4, 401))
    >>> system.set_dependent_initial_conditions()
    >>> motion = system.simulate(rtol=1e-10, atol=1e-10)
    >>> motion['x'].min().round(3)
    np.float64(-1.0)
    """

    def __init__(
        self,
        height: Expression,
        place: Sequence[TimeFunction],
        origin: Point,
        frame: ReferenceFrame,
    ) -> None:
        instance(origin, Point, "`origin`")
        instance(frame, ReferenceFrame, "`frame`")
        self.place = _place(place)
        z = sm.sympify(checked_quantity(height, "`height`", arrays=False))
        x, y = self.place
        self.point = SurfacePoint("C")
        self.point.set_pos(origin, x * frame.x + y * frame.y + z * frame.z)
        # The ground is at rest; the point of it that is touched moves along.
        self.point.set_vel(frame, 0)
        slope_x, slope_y = (sm.diff(z, s) for s in self.place)
        size = sm.sqrt(1 + slope_x**2 + slope_y**2)
        self.normal: Vector = (frame.z - slope_x * frame.x - slope_y * frame.y) / size
        self.point.normal = self.normal
        self._tangents = (frame.x + slope_x * frame.z, frame.y + slope_y * frame.z)

    def residuals(self, wheel: WheelContact) -> dict[TimeFunction, Expression]:
        """Return the equations of the place of the contact point, for `Implicit`.

        Parameters
        ----------
        wheel : WheelContact
            The wheel on this surface. Several wheels: join the dictionaries of their surfaces.

        Returns
        -------
        dict of functions of time to expressions
        """
        instance(wheel, WheelContact, "`wheel`")
        if wheel.normal != self.normal:
            raise ValueError(
                "`wheel` must touch this surface: make it with its `point` and `normal`."
            )
        offset = wheel.body.masscenter.pos_from(self.point) + wheel.contact
        return {s: dot(offset, t) for s, t in zip(self.place, self._tangents, strict=True)}


def _place(place: object) -> tuple[TimeFunction, TimeFunction]:
    t = dynamicsymbols._t
    if (
        not isinstance(place, (tuple, list))
        or len(place) != 2
        or not all(isinstance(s, AppliedUndef) and s.args == (t,) for s in place)
        or place[0] == place[1]
    ):
        raise TypeError(
            "`place` must be two functions of time, such as dynamicsymbols('X Y'), got "
            f"{shown(place)}."
        )
    return place[0], place[1]
