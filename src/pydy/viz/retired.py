"""Names of PyDy's viz package that have no counterpart, with what to use instead."""

from __future__ import annotations

from typing import Any, NoReturn

__all__ = ["no_attribute"]

_POSES = "`scene.poses` holds the 4 x 4 matrices of all visuals at all times"
_REMEDIES = {
    "create_static_html": "call `scene.to_html(path)`, which writes one file",
    "remove_static_html": "`scene.to_html(path)` writes one file, which you may delete",
    "generate_visualization_dict": _POSES,
    "generate_scene_dict": _POSES,
    "generate_simulation_dict": _POSES,
    "generate_transformation_matrix": _POSES,
    "generate_numeric_transform_function": _POSES,
    "evaluate_transformation_matrix": _POSES,
}


def no_attribute(thing: Any, name: str) -> NoReturn:
    """Raise the AttributeError for a name, with a remedy if PyDy's viz package has it."""
    remedy = f": {_REMEDIES[name]}" if name in _REMEDIES else ""
    raise AttributeError(f"{type(thing).__name__} has no attribute `{name}`{remedy}.")
