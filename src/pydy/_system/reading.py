"""The equations of motion of a System to read."""

from __future__ import annotations

from pydy._checks import flag
from pydy._mechanics.equations_of_motion import EquationsOfMotion, equations_to_read
from pydy._simulation.missing_derivatives import warn_of_missing_derivatives
from pydy._system.setup import Setup


class Reading(Setup):
    """The equations of motion to read."""

    def equations_of_motion(self, short: bool = True) -> EquationsOfMotion:
        """Return the equations of motion as SymPy expressions, to print and to work with.

        With up to three coordinates they are written as in a textbook: terms cancel, sums of angles
        are used where that is shorter, and common factors are factored out. With more, they are
        the compiled equations, with names for subexpressions that occur more than once.

        Parameters
        ----------
        short : bool, optional
            Whether sines and cosines are named as usual in robotics: s1 for the sine of q1, c12
            for the cosine of q1 + q2, s1m2 for the sine of q1 − q2.

        Returns
        -------
        EquationsOfMotion
            ``mass_matrix``, ``forcing`` and ``kinematics`` are matrices: ``M u' = F``, ``q' = …``,
            for all speeds. With constraints ``constraint_jacobian`` is J of ``M u' = F + Jᵀ λ``.
            ``names`` maps the short names to expressions, ``written_out(M)`` substitutes them. It
            is shown as LaTeX in notebooks.

        Raises
        ------
        ValueError
            There are constraints, and the method has no bodies.

        Examples
        --------
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1, cart_force=False)
        >>> print(system.equations_of_motion())
        M u' = F, with u = (u0, u1)
        M11 = m0 + m1
        M12 = -c1*l0*m1
        M22 = l0**2*m1
        F1 = -l0*m1*s1*u1**2
        F2 = g*l0*m1*s1
        q'1 = u0
        q'2 = u1
        c1 = cos(q1)
        s1 = sin(q1)
        """
        if self._equations.forgotten:
            warn_of_missing_derivatives(self._now())
        made = equations_to_read(self._equations, tuple(self._forces))
        return made if flag(short, "`short`") else made.without_names()
