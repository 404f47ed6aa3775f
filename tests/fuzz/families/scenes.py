"""Shapes, visuals, scenes and what is made of them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from fuzz.kinds import Kind, RefusedError, anything, array, choice, integer, nothing, real, text
from fuzz.table import empty_or_none, flags, is_number, key, monotonic, number, one_of, target
from fuzz.values import HUGE
from fuzz.world import TIMES, world
from pydy import viz


def _length(value: Any) -> Any:
    """Return a length: a positive number, or an expression of symbols."""
    if isinstance(value, sm.Expr) and value.free_symbols:
        return value
    if isinstance(value, bool):
        raise RefusedError
    return real(above=0.0).read(value)


length = Kind(_length, number.groups)
_shapes: dict[str, tuple[Callable[..., Any], tuple[str, ...]]] = {
    "Sphere": (viz.Sphere, ("radius",)),
    "Box": (viz.Box, ("x", "y", "z")),
    "Cylinder": (viz.Cylinder, ("length", "radius")),
    "Torus": (viz.Torus, ("radius", "tube")),
}
for _name, (_shape, _fields) in _shapes.items():
    for _field in _fields:

        @target(f"{_name}.{_field}", length)
        def _(v, shape=_shape, fields=_fields, field=_field):
            return getattr(shape(**{**dict.fromkeys(fields, 1.0), field: v}), field)


_ENDS = [me.Point("A"), me.Point("B")]


@target("Spring.coils", integer(1, viz.shapes.MOST_COILS))
def _(v):
    return viz.Spring(_ENDS, coils=v).coils


for _line in (viz.Bar, viz.Spring, viz.Damper):

    @target(f"{_line.__name__}.radius", Kind(_length, number.groups).or_none())
    def _(v, line=_line):
        return line(_ENDS, v).radius


@target("Sphere.colour", array((3,), check=lambda a: ((a >= 0) & (a <= 1)).all()).or_none())
def _(v):
    return viz.Sphere(1.0, colour=v).colour


@target("Sphere.opacity", real(least=0.0, most=1.0))
def _(v):
    return float(viz.Sphere(1.0, opacity=v).opacity)


@target("Sphere.name", text().or_none())
def _(v):
    return viz.Sphere(1.0, name=v).name


@target("Tube.points", nothing("symbols"))
def _(v):
    return viz.Tube(0.1, v)


@target("Cylinder.axis", choice("x", "y", "z"))
def _(v):
    return viz.Cylinder(1.0, 1.0, axis=v).axis


@target("Arrow.vector", nothing("symbols", "arrays"))
def _(v):
    return viz.Arrow(v)


@target("Arrow.scale", number.or_none())
def _(v):
    scale = viz.Arrow(world().o.N.x, scale=v).scale
    return None if scale is None else float(scale)


@target("Line.points", nothing("symbols", "arrays"))
def _(v):
    return viz.Line(v)


@target("Trace.duration", length.or_none())
def _(v):
    return viz.Trace(duration=v).duration


@target("Mesh.source", nothing("paths", "arrays"), "`source", "`faces", "'abc'", "files")
def _(v):
    return viz.Mesh(v)


@target("Mesh.faces", nothing("arrays"))
def _(v):
    return viz.Mesh((np.eye(3), v))


@target("Visual.shape", key, "shape")
def _(v):
    return viz.Visual(v, world().o.P)


@target("Visual.where", key, "Visual")
def _(v):
    return viz.Visual(viz.Sphere(1.0), v)


@target("Visual.name", text().or_none())
def _(v):
    return viz.Visual(viz.Sphere(1.0), world().o.P, name=v).name


@target("Visual.trail", flags)
def _(v):
    return viz.Visual(viz.Sphere(1.0), world().o.P, trail=v).trail


# -- scenes ---------------------------------------------------------------------------------------


def _empty(value: Any) -> bool:
    return isinstance(value, (list, tuple, dict, np.ndarray)) and len(value) == 0


def _scene(**changes: Any) -> Any:
    o = world().o
    given = {"reference_frame": o.N, "origin": o.O, "visuals": _ball(), **changes}
    scene = viz.Scene(
        given.pop("reference_frame"), given.pop("origin"), *given.pop("visuals"), **given
    )
    return scene.animate(TIMES, np.sin(TIMES)[:, None], symbols=[o.x])


def _ball() -> list[Any]:
    return [viz.Visual(viz.Sphere(0.1), world().o.P)]


for _name in ("reference_frame", "origin"):

    @target(f"Scene.{_name}", key)
    def _(v, name=_name):
        return _scene(**{name: v})


@target("Scene.visuals", key, "Scene")
def _(v):
    return _scene(visuals=[v])


_direction = array((3,), check=lambda a: 0 < np.linalg.norm(a) < np.inf)

for _name, _kind in (("up", _direction), ("view", _direction.or_none())):

    @target(f"Scene.{_name}", _kind, own=HUGE)
    def _(v, name=_name):
        return _scene(**{name: v}).html()


def _height(value: Any) -> Any:
    return bool(value) if isinstance(value, (bool, np.bool_)) else number.read(value)


@target("Scene.ground", Kind(_height, (*number.groups, "flags")).or_none(), own=HUGE)
def _(v):
    return _scene(ground=v).html()


@target("Scene.follow", flags.or_none())
def _(v):
    return _scene(follow=v).html()


def _series(value: Any) -> bool:
    """Whether a value lists numbers, which are lines in a plot."""
    if empty_or_none(value):
        return value is not None
    if isinstance(value, dict):
        value = list(value.values())
    size = getattr(value, "size", 0)
    if isinstance(value, (str, bytes, range)) or (isinstance(size, int) and size > 2**27):
        return False
    try:
        return all(is_number(e) and isinstance(e, (sm.Expr, int, float)) for e in value)
    except TypeError:
        return False


@target("Scene.series", nothing("symbols", "texts", allowed=_series), "series", own=HUGE)
def _(v):
    return _scene(series=v).html()


@target("Scene.title", text())
def _(v):
    return _scene(title=v).html()


def _dictionary(value: Any) -> bool:
    """Whether a value is None or a dictionary without entries."""
    return value is None or (isinstance(value, dict) and not value)


@target("Scene.units", nothing("symbols", "texts", "arrays", allowed=_dictionary))
def _(v):
    return _scene(units=v).html()


@target("Scene.units[value]", text(), "`units")
def _(v):
    return _scene(series={"x": world().o.x}, units={"x": v}).html()


@target("Scene.cameras", nothing("symbols", "texts", "arrays", allowed=_empty))
def _(v):
    return _scene(cameras=v).html()


@target("Scene.system", nothing("symbols", "texts", allowed=one_of(None)))
def _(v):
    return _scene(system=v)


for _name in ("reference_frame", "origin"):

    @target(f"System.scene.{_name}", nothing("symbols", "texts", allowed=one_of(None)))
    def _(v, name=_name):
        return repr(world().o.system.scene(**{name: v}))


@target("Scene.cameras[0]", nothing("symbols", "texts"), "cameras")
def _(v):
    return _scene(cameras=[v]).html()


@target("PerspectiveCamera.point", key, "PerspectiveCamera")
def _(v):
    return viz.PerspectiveCamera("first", world().o.N, v)


@target("VisualizationFrame.shape", key, "VisualizationFrame")
def _(v):
    return viz.VisualizationFrame("ball", world().o.N, world().o.P, v)


@target("system.scene.loads", flags)
def _(v):
    return len(world().o.system.scene(loads=v).visuals)


@target("animate.compare", nothing("symbols", "texts", "arrays", allowed=empty_or_none))
def _(v):
    return world().o.system.scene().animate(world().o.trajectory, compare=v).poses


@target("animate.compare[label]", nothing("symbols", "texts", "arrays"), "`compare")
def _(v):
    return world().o.system.scene().animate(world().o.trajectory, compare={"other": v}).poses


@target("generate_visualization_json_system.system", nothing("symbols", "texts"))
def _(v):
    viz.Scene(world().o.N, world().o.O, *_ball()).generate_visualization_json_system(v)


for _method in ("display_ipython", "display_jupyter"):

    @target(f"{_method}.window_size", anything("arrays"))
    def _(v, method=_method):
        return getattr(world().scene, method)(v)

    @target(f"{_method}.axes_arrow_length", real(above=0.0, most=1e300).or_none())
    def _(v, method=_method):
        return getattr(_scene(), method)(axes_arrow_length=v)._settings.axes


def _json(**changes: Any) -> Any:
    o, states = world().o, np.sin(TIMES)[:, None]
    given = {
        **{"dynamic_variables": [o.x], "constant_variables": [o.k]},
        **{"dynamic_values": states, "constant_values": [2.0], **changes},
    }
    scene = viz.Scene(o.N, o.O, *_ball())
    scene.generate_visualization_json(**given)
    return scene.poses


@target("generate_visualization_json.constant_values", array((1,)), "`constant", "k`")
def _(v):
    return _json(constant_values=v)


@target(
    "generate_visualization_json.dynamic_values",
    array((None, 1), check=lambda a: np.isfinite(a).all()),
    *("`dynamic", "`states", "`times"),
)
def _(v):
    return _json(dynamic_values=v)


for _name in ("dynamic_variables", "constant_variables"):
    # Constants that nothing drawn needs are left out, whatever they are.
    _any = ("symbols", "texts", "arrays")

    @target(
        f"generate_visualization_json.{_name}",
        nothing(*_any) if _name == "dynamic_variables" else anything(*_any),
        "variables",
        *("`symbols", "`states", "no value", "`constant"),
    )
    def _(v, name=_name):
        return _json(**{name: v})


@target("generate_visualization_json.outfile_prefix", anything("paths"))
def _(v):
    return _json(outfile_prefix=v)


@target("generate_visualization_json.fps", real(least=1e-3, most=1e3))
def _(v):
    return _json(fps=v)


def _animated(**changes: Any) -> Any:
    o = world().o
    given = {"trajectory": TIMES, "states": np.sin(TIMES)[:, None], "symbols": [o.x], **changes}
    return viz.Scene(o.N, o.O, *_ball()).animate(**given).poses


@target(
    "animate.times",
    array((3,), check=monotonic),
    "`times",
    "`states",
)
def _(v):
    return _animated(trajectory=v)


@target("animate.states", array((3, 1)), "`states", "animate")
def _(v):
    return _animated(states=v)


@target("animate.trajectory", nothing("arrays", "symbols"), "`animate`")
def _(v):
    return viz.Scene(world().o.N, world().o.O, *_ball()).animate(v)


@target("animate.symbols", nothing("symbols", "texts", "arrays"), "`symbols", "`states", "no value")
def _(v):
    return _animated(symbols=v)


def _numbers(value: Any) -> bool:
    """Whether a value is a dictionary of numbers, needed or not."""
    return empty_or_none(value) or (
        isinstance(value, dict) and all(is_number(v) for v in value.values())
    )


for _name in ("constants", "specifieds", "series"):

    @target(
        f"animate.{_name}",
        nothing("symbols", "arrays", allowed=empty_or_none if _name == "series" else _numbers),
    )
    def _(v, name=_name):
        return _animated(**{name: v})


@target("animate.constants[value]", real(finite=False))
def _(v):
    return _animated(constants={world().o.k: v})


@target(
    "animate.specifieds[value]",
    array((), (3,), check=lambda a: np.isfinite(a).all()),
    "`specifieds",
    "there is nothing to draw",
)
def _(v):
    return _animated(specifieds={world().o.f: v})


@target("animate.fps", real(finite=False, above=0.0).or_none())
def _(v):
    return _animated(fps=v)


@target("animate.speed", real(above=0.0).or_none())
def _(v):
    return _animated(speed=v)


# -- pages, pictures and films --------------------------------------------------------------------


@target("to_html.theme", choice("auto", "light", "dark"))
def _(v):
    return world().scene.html(theme=v)


def _a_file(value: Any) -> bool:
    return isinstance(value, (str, Path)) and str(value) in ("abc", "damaged.nc", "empty.nc")


@target("to_html.path", nothing("paths", allowed=_a_file))
def _(v):
    return world().scene.to_html(v)


@target("to_matplotlib.t", number.or_none())
def _(v):
    world().scene.to_matplotlib(v)


@target("to_matplotlib.axes", nothing("texts", "arrays", allowed=one_of(None)))
def _(v):
    return world().scene.to_matplotlib(axes=v)


@target("save.path", nothing("paths"))
def _(v):
    return world().scene.save(v)


@target("save.fps", real(least=1e-3, most=1e3))
def _(v):
    return world().still.save("film.gif", fps=v, dpi=20) and None


@target("Scene.save.progress", flags)
def _(v):
    return world().still.save("film.gif", dpi=20, progress=v) and None


@target("save.dpi", real(least=10.0, most=1e3))
def _(v):
    return world().scene.save("picture.png", dpi=v) and None


@target("save.size", array((2,), check=lambda a: (a >= 0.5).all() and (a < 100).all()))
def _(v):
    return world().scene.save("picture.png", size=v, dpi=20) and None
