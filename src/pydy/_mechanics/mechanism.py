"""What a method's equations were made from: bodies and loads in an inertial frame."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, field
from typing import Any

import sympy as sm
from sympy.physics.mechanics import Particle, ReferenceFrame

from pydy._forks import cached_property

__all__ = ["Mechanism"]


@dataclass(frozen=True, eq=False)
class Mechanism:
    """Bodies and loads as the user gave them; nothing is derived before it is asked for.

    Attributes
    ----------
    frame : ReferenceFrame
        The inertial frame.
    bodies : tuple of Particle and RigidBody
    loads : tuple of (Point, force Vector) and (ReferenceFrame, torque Vector)
    known_energy : expression or None
        The kinetic energy, where it was formed already.
    joints : tuple of Joint
        Those of SymPy that connect the bodies, where they are known.
    lagrangian : expression or None
        The kinetic energy less the potential one of all that is not among the loads.
    """

    frame: Any
    bodies: tuple[Any, ...]
    loads: tuple[tuple[Any, Any], ...] = ()
    known_energy: Any = None
    joints: tuple[Any, ...] = ()
    lagrangian: Any = None
    _rotations: dict[Any, Any] = field(default_factory=dict, repr=False)

    @cached_property
    def kinetic_energy(self) -> Any:
        """The kinetic energy with the velocities as they were written, q' and all."""
        with warnings.catch_warnings():
            # SymPy makes up velocities that nobody set, and warns where there are several ways.
            warnings.simplefilter("ignore", UserWarning)
            return self._written_energy()

    @property
    def energy(self) -> Any:
        """The kinetic energy as it is computed: as it was formed, where it was."""
        return self.kinetic_energy if self.known_energy is None else self.known_energy

    def _written_energy(self) -> Any:
        terms = []
        for body in self.bodies:
            velocity = body.masscenter.vel(self.frame)
            terms.append(body.mass * self._square(velocity) / 2)
            if not isinstance(body, Particle):
                rate = body.frame.ang_vel_in(self.frame)
                for size, left, right in body.central_inertia.args:
                    terms.append(size * self.dot(rate, left) * self.dot(rate, right) / 2)
        return sm.Add(*terms)

    @cached_property
    def symbols(self) -> set[Any]:
        """The symbols in the bodies and loads, whether the equations of motion hold them or not."""
        parts = [body.mass for body in self.bodies]
        vectors = [vector for _, vector in self.loads]
        for body in self.bodies:
            vectors.append(body.masscenter.vel(self.frame))
            if not isinstance(body, Particle):
                parts += [size for size, _, _ in body.central_inertia.args]
        parts += [part for vector in vectors for own, _ in vector.args for part in own]
        return set().union(*(sm.sympify(part).free_symbols for part in parts))

    def _square(self, vector: Any) -> Any:
        if len(vector.args) == 1:
            return sum(part**2 for part in vector.args[0][0])
        # SymPy's dot pairs every frame with every other, which for a chain of n links is n³ dots.
        return sum(part**2 for part in self.components(vector, self.frame))

    def components(self, vector: Any, frame: ReferenceFrame) -> Any:
        """Return the column matrix of a vector's components in a frame."""
        column = sm.zeros(3, 1)
        for part, own in vector.args:
            column += part if own == frame else self._rotation(frame, own) * part
        return column

    def dot(self, a: Any, b: Any) -> Any:
        """Return the scalar product; `b` has its parts in few frames."""
        return sum((self.components(a, frame).T * part)[0] for part, frame in b.args)

    def _rotation(self, to: ReferenceFrame, own: ReferenceFrame) -> Any:
        key = (to, own)
        if key not in self._rotations:
            self._rotations[key] = to.dcm(own)
        return self._rotations[key]
