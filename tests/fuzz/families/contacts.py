"""Laws of contact, and contacts that open, close, stick and slide."""

from __future__ import annotations

import inspect
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
import sympy as sm
from sympy.physics.mechanics import (
    Particle,
    RigidBody,
    dynamicsymbols,
    inertia,
)

from fuzz.kinds import Kind, RefusedError, choice, nothing, real
from fuzz.table import empty_or_none, expression, flags, key, mapping, target
from pydy.analysis import Trial
from pydy.contact import (
    Clearance,
    CompliantContact,
    Contacts,
    Roll,
    Stick,
    Unilateral,
)
from pydy.mechanics import Definition
from pydy.system import System
from registry import LAWS
from zoo import inertial_frame


@cache
def _block() -> SimpleNamespace:
    """A block above a floor, and its contacts."""
    x, y, v, w = dynamicsymbols("x, y, v, w")
    m, g, mu = sm.symbols("m, g, mu")
    N, O = inertial_frame()
    P = O.locatenew("P", x * N.x + y * N.y)
    P.set_vel(N, v * N.x + w * N.y)
    block = Definition(
        N, [x, y], [v, w], bodies=[Particle("block", P, m)], loads=[(P, -m * g * N.y)]
    )
    floor = Unilateral(y, restitution=0.5, name="floor")
    return SimpleNamespace(**locals())


def _system() -> System:
    b = _block()
    return System(
        b.block,
        {b.m: 2.0, b.g: 9.81},
        initial_conditions={b.v: 1.0, b.y: 0.1},
        times=np.linspace(0.0, 0.5, 3),
        ode_solver="dop853",
    )


def _run(*contacts: Any, constants: Any = None, **options: Any) -> Any:
    return Contacts(_system(), list(contacts), constants).simulate(**options).states


def _parameter(value: Any) -> Any:
    """Return a number or an expression that may stand for one."""
    found = expression(value)
    if isinstance(found, sm.Basic) and (found.is_Relational or not isinstance(found, sm.Expr)):
        raise RefusedError
    return found


def _amount(most: float = np.inf) -> Kind:
    def read(value: Any) -> Any:
        found = _parameter(value)
        if isinstance(found, sm.Expr) and not found.is_number:
            return found
        return real(least=0.0, most=most).read(found)

    return Kind(read, ("common", "numbers", "symbols"), compare=False)


_gap = Kind(_parameter, ("common", "numbers", "symbols"), compare=False)


def _moving_gap(value: Any) -> Any:
    found = _parameter(value)
    if not isinstance(found, sm.Expr) or found.is_number:
        raise RefusedError
    return found


# What a law is called with where its argument has this name, else 0.3.
_PLAIN = {"gap": -0.1, "rate": 0.1, "stiffness": 1e3, "exponent": 1.5, "normal": 2.0}
_PLAIN |= {"mu_static": 0.4, "transition": 0.1, "viscous": 0.0}

_SIGNED = ("gap", "rate", "speed", "normal")  # all others must not be negative


def _plain(law: Any) -> dict[str, Any]:
    """Return values for the arguments that a law must be given."""
    parameters = inspect.signature(law).parameters.values()
    return {p.name: _PLAIN.get(p.name, 0.3) for p in parameters if p.default is p.empty}


for _law in LAWS:
    for _parameter_of_law in inspect.signature(_law).parameters.values():
        _kind = _gap if _parameter_of_law.name in _SIGNED else _amount()
        if isinstance(_parameter_of_law.default, bool):
            _kind = flags
        if _parameter_of_law.default is None:
            _kind = _kind.or_none()

        @target(f"{_law.__name__}.{_parameter_of_law.name}", _kind)
        def _(v, law=_law, name=_parameter_of_law.name):
            return repr(law(**{**_plain(law), name: v}))


def _sliding(value: Any) -> Any:
    if isinstance(value, (list, tuple)) and len(value) in (1, 2):
        return [_parameter(part) for part in value]
    return _parameter(value)


@target("Unilateral.gap", Kind(_moving_gap, _gap.groups, compare=False))
def _(v):
    return repr(Unilateral(v))


@target("Unilateral.restitution", _amount(1.0))
def _(v):
    return repr(Unilateral(_block().y, restitution=v))


@target("Unilateral.name", nothing("texts", allowed=lambda v: isinstance(v, str)))
def _(v):
    return repr(Unilateral(_block().y, name=v))


@target("Stick.on", nothing("symbols", "texts"))
def _(v):
    return repr(Stick(_block().v, on=v, mu=0.2))


@target("Stick.mu", _amount())
def _(v):
    return repr(Stick(_block().v, on=_block().floor, mu=v))


@target("Stick.mu_static", _amount().or_none(), "`mu_static`")
def _(v):
    return repr(Stick(_block().v, on=_block().floor, mu=0.0, mu_static=v))


@target("Stick.name", nothing("texts", allowed=lambda v: isinstance(v, str)))
def _(v):
    return repr(Stick(_block().v, on=_block().floor, mu=0.2, name=v))


@target("Stick.normal", _amount(), "`normal`")
def _(v):
    return repr(Stick(_block().v, normal=v, mu=0.2))


@target("Stick.point", Kind(_sliding, _gap.groups, compare=False), "`point`", "`along`")
def _(v):
    return repr(Stick(v, on=_block().floor, mu=0.2))


@target("Stick.along", nothing("symbols", "texts", "arrays"))
def _(v):
    return repr(Stick(_block().P, on=_block().floor, mu=0.2, along=v))


@target("Stick.against", nothing("symbols", "texts", allowed=lambda v: v is None))
def _(v):
    b = _block()
    return repr(Stick(b.P, on=b.floor, mu=0.2, along=b.N.x, against=v))


def _roll(**given: Any) -> str:
    b = _block()
    ball = RigidBody("ball", b.P, b.N, b.m, (inertia(b.N, 0, 0, 1), b.P))
    usual = {
        "body": ball, "radius": 0.1, "on": b.O, "normal": b.N.y, "along": b.N.x, "mu": 0.0
    }  # fmt: skip
    return repr(Roll(**{**usual, **given}).on)


def _clearance(**given: Any) -> str:
    b = _block()
    usual = {
        "pin": b.P, "bush": b.O, "radius": 0.1, "play": 0.1, "axis": b.N.z,
        "frames": (b.N, b.N), "mu": 0.0,
    }  # fmt: skip
    return repr(Clearance(**{**usual, **given}).on)


def _size(value: Any) -> Any:
    found = _amount().read(value)
    if not isinstance(found, sm.Expr) and not found > 0.0:
        raise RefusedError
    return found


_sizes = Kind(_size, ("common", "numbers", "symbols"), compare=False)
_objects = nothing("symbols", "texts")
_of_contact = {
    "mu": _amount(),
    "mu_static": _amount().or_none(),
    "restitution": _amount(1.0),
    "name": nothing("texts", allowed=lambda v: isinstance(v, str)),
}
_GEOMETRIES: dict[Any, dict[str, Kind]] = {
    _roll: {
        **dict.fromkeys(("body", "on", "normal", "along"), _objects),
        "radius": _sizes,
        "axis": nothing("symbols", "texts", allowed=lambda v: v is None),
        **_of_contact,
    },
    _clearance: {
        **_of_contact,
        **dict.fromkeys(("pin", "bush", "axis", "frames"), _objects),
        **dict.fromkeys(("radius", "play"), _sizes),
    },
}

for _make, _arguments in _GEOMETRIES.items():
    for _name, _kind in _arguments.items():

        @target(f"{_make.__name__[1:].capitalize()}.{_name}", _kind)
        def _(v, make=_make, name=_name):
            return make(**{name: v})


def _compliant(**given: Any) -> list[str]:
    b = _block()
    usual = {
        "point": b.P, "plane": b.O, "normal": b.N.y, "frame": b.N,
        "force": lambda gap, rate: gap, "friction": lambda speed, normal: speed,
        "along": [b.N.x, b.N.z], "smoothing": 0.1,
    }  # fmt: skip
    return [str(load) for load in CompliantContact(**{**usual, **given}).loads]


def _law(value: Any) -> Any:
    """Return a function of two numbers that gives an expression."""
    try:
        found = value(sm.Symbol("a"), sm.Symbol("b"))
    except Exception as error:
        raise RefusedError from error
    expression(found)
    return value


_laws = Kind(_law, ("common", "functions"), compare=False)
_COMPLIANT = {
    **dict.fromkeys(("point", "plane", "normal", "frame", "along"), _objects),
    **dict.fromkeys(("force", "friction"), _laws),
    "smoothing": _sizes,
    "reaction": flags,
    "name": _of_contact["name"],
}

for _name, _kind in _COMPLIANT.items():

    @target(f"CompliantContact.{_name}", _kind)
    def _(v, name=_name):
        return _compliant(**{name: v})


@target("Contacts.system", nothing("symbols", "texts"))
def _(v):
    return Contacts(v, [_block().floor])


@target("Contacts.contacts", nothing("symbols", "texts", "arrays"))
def _(v):
    return Contacts(_system(), v)


@target("Contacts.hypothesis", choice("newton", "poisson"))
def _(v):
    return repr(Contacts(_system(), [_block().floor], hypothesis=v))


@target("Contacts.constants", mapping)
def _(v):
    return _run(_block().floor, constants=v)


@target("Contacts.constants[key]", key, "constants", "constant")
def _(v):
    try:
        hash(v)
    except TypeError:
        v = frozenset()
    return _run(_block().floor, constants={v: 1.0})


@target("Contacts.constants[value]", real(least=0.0), "mu", "constant")
def _(v):
    b = _block()
    return _run(Stick(b.v, on=b.floor, mu=b.mu), constants={b.mu: v})


@target("Contacts.simulate.events", nothing("symbols", "texts", allowed=empty_or_none))
def _(v):
    return _run(_block().floor, events=v)


@target("Contacts.simulate.rtol", Kind(real(least=0.0).read, ("common", "numbers"), compare=False))
def _(v):
    return _run(_block().floor, rtol=v).shape


@target("Contacts.simulate.full_output", flags)
def _(v):
    return _run(_block().floor, full_output=v)


@target("Contacts.simulate.constraints", choice("project").or_none())
def _(v):
    return _run(_block().floor, constraints=v)


@target("animate.contacts", nothing("symbols", "texts", "arrays", allowed=lambda v: v is None))
def _(v):
    return _system().animate(contacts=v)


@target("plot.contacts", nothing("symbols", "texts", "arrays", allowed=lambda v: v is None))
def _(v):
    return _system().plot(contacts=v)


@target("Contacts.in_modes.modes", mapping)
def _(v):
    return Contacts(_system(), [_block().floor]).in_modes(v).evaluate_ode()


@target("Contacts.in_modes.modes[value]", choice("open", "closed"), "modes")
def _(v):
    return Contacts(_system(), [_block().floor]).in_modes({"floor": v}).evaluate_ode()


@target("integrate_ensemble.contacts", nothing("symbols", "texts", allowed=lambda v: v is None))
def _(v):
    return _system().integrate_ensemble(contacts=v, initial_conditions={_block().y: [1.0]})


@target("adjoint_gradient.contacts", nothing("symbols", "texts", allowed=lambda v: v is None))
def _(v):
    return _system().adjoint_gradient("states", final=_block().y, contacts=v).values


@target("find_periodic_orbit.contacts", nothing("symbols", "texts", allowed=lambda v: v is None))
def _(v):
    return None if v is None else _system().find_periodic_orbit(1.0, contacts=v)


@target("fit.contacts", nothing("symbols", "texts", allowed=lambda v: v is None))
def _(v):
    trial = Trial([0.0, 0.1, 0.2], {_block().y: [0.1, 0.05, -0.1]})
    return _system().fit([_block().g], trial, contacts=v).estimates


for _method in ("as_jax", "as_torch"):
    # What both hand to their libraries.
    @target(f"{_method}.contacts", nothing("symbols", "texts", allowed=lambda v: v is None))
    def _(v):
        return _system()._layer_functions(v, {}).start()
