"""Models as files, and pages that simulate."""

from __future__ import annotations

from importlib.resources import files
from pathlib import Path
from typing import Any

from fuzz.kinds import choice, nothing, real, text
from fuzz.table import empty_or_none, flags, number, target
from fuzz.world import world
from pydy._evaluation.exporting import exported_model
from pydy.export.writing import check_options, write
from pydy.robots import read
from pydy.viz import Live, Slider

_ROBOT = files("pydy.examples") / "pendulum.urdf"


def _exported(path: str = "model.py", **options: Any) -> str:
    """Return what an export writes first."""
    return world().o.system.export(path, **options).path.read_bytes().hex()


@target("export.target", choice("numpy", "jax"))
def _(v):
    return _exported(target=v)


@target("export.fmi", choice("3.0", "2.0"))
def _(v):
    return _exported("model.fmu", fmi=v, binary=False)


@target("export.binary", flags)
def _(v):
    return check_options(Path("model.fmu"), {"binary": v})


@target("export.progress", flags)
def _(v):
    return _exported(progress=v)


@target("export.name", text().or_none())
def _(v):
    return _exported(name=v)


def _none_of_them(value: Any) -> bool:
    return empty_or_none(value) or getattr(value, "size", 1) == 0


@target("export.events", nothing("symbols", "texts", "arrays", allowed=_none_of_them))
def _(v):
    return _exported(events=v)


@target("export.inputs", nothing("symbols", "arrays", allowed=_none_of_them))
def _(v):
    return _exported(inputs=v)


@target("export.path", nothing("texts"))
def _(v):
    return _exported(v)


@target("read.floating", flags)
def _(v):
    return len(read(_ROBOT, floating=v).joints)


@target("write.model", nothing("symbols", "texts"))
def _(v):
    return write(v, Path("model.py"))


@target("write.path", nothing("paths", "texts"))
def _(v):
    return write(exported_model(world().o.system._now(), name="model"), v)


# -- pages that simulate --------------------------------------------------------------------------


def _live(live: Any) -> str:
    o = world().o
    return o.native.scene(reference_frame=o.N, origin=o.O).animate(o.trajectory).html(live=live)


def _no_sliders(value: Any) -> bool:
    return isinstance(value, dict) and not value


@target("Slider.low", real(most=0.9))
def _(v):
    return Slider(v, 1.0).low


@target("Slider.high", real(least=0.1))
def _(v):
    return Slider(0.0, v).high


@target("Slider.value", number.or_none())
def _(v):
    return Slider(0.0, 1.0, v).value


@target("Slider.unit", text())
def _(v):
    return Slider(0.0, 1.0, unit=v).unit


@target("Slider.label", text())
def _(v):
    return Slider(0.0, 1.0, label=v).label


@target("Slider.sets", nothing("symbols", "arrays", allowed=lambda v: isinstance(v, dict)))
def _(v):
    return Slider(0.0, 1.0, sets=v)


for _name in ("rtol", "atol"):

    @target(f"Live.{_name}", real(above=0.0))
    def _(v, name=_name):
        return getattr(Live({}, **{name: v}), name)


# `live` may be the sliders themselves.
@target("Live.sliders", nothing("symbols", "texts", "arrays", allowed=_no_sliders), "`live")
def _(v):
    return _live(Live(v))


@target("Live.events", nothing("symbols", "texts", allowed=empty_or_none))
def _(v):
    return _live(Live({}, events=v))


@target("Live.max_step", real(above=0.0).or_none())
def _(v):
    return Live({}, max_step=v).max_step


@target("Live.constraints", choice("auto", "project", None))
def _(v):
    return Live({}, constraints=v).constraints


@target("to_html.live", nothing("symbols", "texts", "arrays", allowed=empty_or_none))
def _(v):
    return _live(v)


# -- robots from files ----------------------------------------------------------------------------


@target("read.path", nothing("paths", "texts"), "`path", "does not read this file")
def _(v):
    return read(v)


@target("read.parameters", choice("symbols", "numbers"))
def _(v):
    return [str(s) for s in read(_ROBOT, parameters=v).values]


@target("read.friction_speed", real(above=0.0).or_none())
def _(v):
    return read(_ROBOT, friction_speed=v).left_out


@target("Robot.system.constants", nothing("texts", allowed=_none_of_them), "constants")
def _(v):
    return read(_ROBOT).system(constants=v)
