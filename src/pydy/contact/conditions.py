"""Unilateral contacts and friction that sticks, as a user writes them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sm
from sympy.physics.mechanics import Point, ReferenceFrame, Vector

from pydy._checks import instance, listed, shown, text
from pydy.contact.laws import _axes, _expressions


class Unilateral:
    """A gap that does not become negative.

    While it is closed a normal force acts, which is not negative. Where it closes with a speed v,
    it leaves with the speed −e v (Newton's hypothesis; `Contacts` takes Poisson's too). If that is
    zero, or the rebounds have become lower than the tolerances of the solver, it stays closed until
    the normal force vanishes.

    Parameters
    ----------
    gap : expression
        Of the coordinates and time, without jumps and kinks; positive while open. The normal force
        has the unit in which its power is force times rate of the gap: N for a gap in m, N m for an
        angle.
    restitution : expression, optional
        Coefficient of restitution e, between 0 and 1.
    name : str, optional
        For results and messages.

    Examples
    --------
    >>> import sympy.physics.mechanics as me
    >>> from pydy.contact import Unilateral
    >>> Unilateral(me.dynamicsymbols('y'), restitution=0.8, name='floor')
    <Unilateral floor: y(t)>
    """

    def __init__(
        self, gap: sm.Expr, *, restitution: sm.Expr | float = 0, name: str = "contact"
    ) -> None:
        self.gap, self.restitution = _expressions(gap=gap, restitution=restitution)
        _check_range("restitution", self.restitution, 1.0)
        if self.gap.is_number:
            raise ValueError(f"`gap` must depend on coordinates, got the number {self.gap}.")
        self.name = text(name, "`name`", empty=False)

    def __repr__(self) -> str:
        return f"<Unilateral {self.name}: {self.gap}>"


class Stick:
    """Coulomb friction that holds until it is overcome.

    At rest the friction is as large as it has to be, up to mu_static N; a body that slides is
    braked by mu N against its motion.

    Parameters
    ----------
    point : Point or expression
        What slides: a point, or a speed that is linear in the speeds of the system, such as the
        relative rate of a joint. It does not jump; a belt that starts does so in a ramp.
    on : Unilateral, optional
        The contact whose normal force presses. With a point its gap is a length, where it is
        closed.
    mu : expression
        Coefficient of kinetic friction. It also limits the friction of impacts.
    mu_static : expression, optional
        Coefficient of static friction, not below `mu`, by default equal to it.
    along : Vector or two Vectors, optional
        Unit vector along which the point slides, tangential to what is touched, or two of the plane
        in which it slides, orthogonal to each other; needed with a point. In place of a point and
        these, `point` may be a pair of speeds.
    against : Point, optional
        Point of a body that the point slides on, if that moves; with a point. If the body turns,
        that of its points which is where the body is touched, with its velocity.
    normal : expression, optional
        In place of `on`: a normal force that is known, such as the preload of a brake. It is not
        negative, and depends on the state and time.
    name : str, optional
        For results and messages; by default that of `on`.

    Examples
    --------
    >>> import sympy as sm
    >>> import sympy.physics.mechanics as me
    >>> from pydy.contact import Stick
    >>> Stick(me.dynamicsymbols('v'), mu=0.2, normal=sm.Symbol('N'), name='brake')
    <Stick brake>
    """

    def __init__(
        self,
        point: Any,  # a Point, a speed or a pair of speeds
        *,
        mu: sm.Expr | float,
        on: Unilateral | None = None,
        mu_static: sm.Expr | float | None = None,
        along: Vector | Sequence[Vector] | None = None,
        against: Point | None = None,
        normal: sm.Expr | float | None = None,
        name: str = "",
    ) -> None:
        if (on is None) == (normal is None):
            raise ValueError(
                "`on` or `normal` must say what presses: give a Unilateral as `on`, or a known "
                "normal force as `normal`, and not both."
            )
        if on is not None:
            instance(on, Unilateral, "`on`")
        axes = _axes(along)
        if isinstance(point, Point) != bool(axes):
            raise TypeError(
                "`along` must be one Vector or two if `point` is a Point, and is not used with a "
                f"speed; got {shown(point)} and {shown(along)}."
            )
        if against is not None and not (isinstance(against, Point) and isinstance(point, Point)):
            raise TypeError(f"`against` must be a Point, with a Point, got {shown(against)}.")
        if not isinstance(point, Point):
            parts = point if isinstance(point, (tuple, list)) else (point,)
            if len(parts) not in (1, 2):
                raise TypeError(f"`point` must be a speed or a pair of them, got {shown(point)}.")
            point = tuple(_expressions(point=part)[0] for part in parts)
        self.point, self.on, self.along, self.against = point, on, axes, against
        self.mu, self.mu_static = _expressions(
            mu=mu, mu_static=mu if mu_static is None else mu_static
        )
        self.normal = None if normal is None else _expressions(normal=normal)[0]
        for argument in ("mu", "mu_static", "normal"):
            _check_range(argument, getattr(self, argument))
        if (self.mu_static - self.mu).is_negative:
            raise ValueError(
                f"`mu_static` must not be below `mu`, got {self.mu_static} and {self.mu}."
            )
        self.name = text(name, "`name`") or ("friction" if on is None else on.name)

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.name}>"

    @property
    def plane(self) -> bool:
        """Whether the point slides in a plane, in any direction."""
        return len(self.along or self.point) == 2

    def speeds(self, frame: ReferenceFrame) -> tuple[sm.Expr, ...]:
        """Return the sliding speed or speeds, from velocities in the inertial frame."""
        if not isinstance(self.point, Point):
            return tuple(self.point)
        velocity = self.velocity(frame)
        return tuple(velocity.dot(axis) for axis in self.along)

    def velocity(self, frame: ReferenceFrame) -> Vector:
        """Return the velocity of the point, relative to the body it slides on."""
        velocity = self.point.vel(frame)
        return velocity if self.against is None else velocity - self.against.vel(frame)


@dataclass(frozen=True, eq=False)
class Contact:
    """A Unilateral with the Stick on it, or one of them alone."""

    name: str
    unilateral: Unilateral | None
    stick: Stick | None

    @property
    def kind(self) -> str:
        """The kind of its modes: of a gap, of friction, or of both."""
        if self.unilateral is None:
            return "friction"
        return "gap" if self.stick is None else "both"

    @property
    def coefficients(self) -> dict[str, sm.Expr]:
        """The expressions that need numbers besides gap and sliding speed; neutral if absent."""
        gap, stick = self.unilateral, self.stick
        pressed = None if stick is None else stick.normal
        return {
            "restitution": sm.S.Zero if gap is None else gap.restitution,
            "mu": sm.S.One if stick is None else stick.mu,
            "mu_static": sm.S.One if stick is None else stick.mu_static,
            "normal": sm.S.Zero if pressed is None else pressed,
        }


def paired(contacts: Iterable[Unilateral | Stick]) -> tuple[Contact, ...]:
    """Return the contacts, each gap with the friction on it."""
    conditions = listed("contacts", contacts, "Unilateral and Stick objects")
    for condition in conditions:
        if not isinstance(condition, (Unilateral, Stick)):
            raise TypeError(f"`contacts` must hold Unilateral and Stick, got {shown(condition)}.")
    gaps = [condition for condition in conditions if isinstance(condition, Unilateral)]
    sticks = [condition for condition in conditions if isinstance(condition, Stick)]
    if not conditions:
        raise ValueError("`contacts` must have at least one Unilateral or Stick.")
    for stick in sticks:
        if stick.on is not None and stick.on not in gaps:
            gaps.append(stick.on)
    pairs = []
    for gap in gaps:
        sticks_on_gap = [s for s in sticks if s.on is gap]
        if len(sticks_on_gap) > 1:
            raise ValueError(
                f"`contacts` has {len(sticks_on_gap)} Sticks on {gap!r}. Give one, with two "
                "vectors as `along` if it slides in a plane."
            )
        pairs.append(Contact(gap.name, gap, sticks_on_gap[0] if sticks_on_gap else None))
    pairs += [Contact(s.name, None, s) for s in sticks if s.on is None]
    names = [c.name for c in pairs]
    if twice := [n for n in names if names.count(n) > 1]:
        raise ValueError(
            f"`contacts` must have different names, got {twice[0]!r} twice. Give them `name=`."
        )
    if len(pairs) > 8:  # up to 4⁸ combinations of modes are tried
        raise ValueError(f"`contacts` may be up to 8, got {len(pairs)}.")
    return tuple(pairs)


class InfeasibleError(ValueError):
    """No motion can start: a coefficient or a gap is out of its range."""


def check_values(contacts: Sequence[Contact], numbers: Any) -> None:
    """Check the values of gaps and coefficients."""
    columns = (numbers.gap, numbers.restitution, numbers.mu, numbers.mu_static)
    for contact, gap, e, mu, static in zip(contacts, *columns, strict=True):
        if contact.unilateral is not None and not np.isfinite(gap):
            raise InfeasibleError(
                f"The gap of {contact.name!r} must be a number at the first time, got "
                f"{gap}. Change the initial conditions, or what leaves its domain."
            )
        if not 0.0 <= e <= 1.0:
            raise InfeasibleError(
                f"`restitution` of {contact.name!r} must be from 0 to 1, got {e}."
            )
        if not mu >= 0.0:
            raise InfeasibleError(f"`mu` of {contact.name!r} must not be negative, got {mu}.")
        if not static >= mu:
            raise InfeasibleError(
                f"`mu_static` of {contact.name!r} must not be below `mu`, got {static} and {mu}."
            )


def _check_range(argument: str, value: sm.Expr | None, most: float | None = None) -> None:
    """Refuse a number that is negative, or above the limit."""
    if value is None or not value.is_number:
        return
    if not (value.is_real and value >= 0 and (most is None or value <= most)):
        range_ = "not be negative" if most is None else f"be from 0 to {most:g}"
        raise ValueError(f"`{argument}` must {range_}, got {value}.")
