"""The base class of all shapes: data that is validated on creation and at every change."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any, ClassVar, Self

import numpy as np
import sympy as sm

from pydy._checks import choice, number, shown
from pydy._errors import warn_user
from pydy._names import nearest
from pydy.viz.colours import hex_colour

__all__ = ["Shape", "check_axis", "real_number"]


class _Spelling(type):
    """Takes the other spellings of a shape's arguments that scripts written elsewhere use."""

    def ignore_material(cls) -> None:
        warn_user(
            f"`material` of {cls.__name__} is ignored: all shapes have one material. Choose a "
            "`color` and an `opacity`."
        )

    if not TYPE_CHECKING:

        def __call__(cls, *args: Any, **options: Any) -> Any:
            for name, own in cls.spellings.items():
                if name in options:
                    if own in options:
                        raise TypeError(
                            f"{cls.__name__} got `{own}` and `{name}`, which mean the same. Keep "
                            "one of them."
                        )
                    options[own] = options.pop(name)
            if options.pop("material", None) is not None:
                cls.ignore_material()
            return super().__call__(*args, **options)


@dataclass(kw_only=True, unsafe_hash=True)
class Shape(metaclass=_Spelling):
    """Attributes common to all shapes.

    Attributes
    ----------
    colour or color : str or sequence of 3 numbers, optional
        A CSS name, ``"#rrggbb"``, or red, green and blue from 0 to 1; by default the next of a
        cycle of colours.
    opacity : float
        From 0 (invisible) to 1 (opaque).
    name : str, optional
        Label in the legend, where visuals with the same name share a row.
    """

    colour: Any = None
    opacity: float = 1.0
    name: str | None = None

    if TYPE_CHECKING:
        color: Any = None

    lengths: ClassVar[tuple[str, ...]] = ()
    spellings: ClassVar[dict[str, str]] = {"color": "colour"}
    changes: ClassVar[int] = 0

    def __post_init__(self) -> None:
        kind = type(self).__name__
        optional = {entry.name for entry in fields(self) if entry.default is None}
        for attribute in self.lengths:
            value = getattr(self, attribute)
            if value is not None or attribute not in optional:
                self._set(attribute, _length(value, f"`{attribute}` of {kind}"))
        if self.colour is not None:
            self._set("colour", hex_colour(self.colour, f"`colour` of {kind}"))
        opacity = real_number(self.opacity)
        if opacity is None or not 0 <= opacity <= 1:
            raise ValueError(f"`opacity` of {kind} must be from 0 to 1, got {shown(self.opacity)}.")
        self._set("opacity", opacity)
        if self.name is not None and not isinstance(self.name, str):
            raise TypeError(f"`name` of {kind} must be a string, got {self.name!r}.")

    def _set(self, attribute: str, value: Any) -> None:
        object.__setattr__(self, attribute, value)  # the shape is still in the making

    if not TYPE_CHECKING:

        def __setattr__(self, name: str, value: Any) -> None:
            own = self.spellings.get(name, name)
            if own == "material":
                type(self).ignore_material()
            elif own not in (names := [f.name for f in fields(self) if f.init]):
                raise AttributeError(
                    f"{type(self).__name__} has no attribute `{name}`. {nearest(name, names)}"
                )
            elif own not in self.__dict__:
                self._set(own, value)  # in __init__, which checks it afterwards
            else:
                changed = vars(replace(self, **{own: value}))
                self.__dict__.update(changed, changes=self.changes + 1)

        def __getattr__(self, name: str) -> Any:
            if name in self.spellings:
                return getattr(self, self.spellings[name])
            raise AttributeError(f"{type(self).__name__} has no attribute `{name}`.")

    def measured(self, values: Mapping[Any, Any]) -> Self:
        """Return this shape with numbers for lengths.

        Parameters
        ----------
        values : mapping of symbols to numbers

        Raises
        ------
        ValueError
            A symbol has no value, or the length comes out as no positive number.
        """
        numbers: dict[str, Any] = {}
        kind = type(self).__name__
        for attribute in self.lengths:
            expression = getattr(self, attribute)
            if not isinstance(expression, sm.Basic):
                continue
            # By name too: a trajectory from a file has names in the place of symbols.
            known = {s: values.get(s, values.get(s.name)) for s in expression.free_symbols}
            missing = sorted(s.name for s, value in known.items() if value is None)
            if missing:
                raise ValueError(
                    f"`{attribute}` of {kind} is `{expression}`, but `{missing[0]}` has no value: "
                    "shapes may depend on constants only. Give its value in `constants`."
                )
            value = real_number(expression.xreplace({s: sm.Float(v) for s, v in known.items()}))
            if value is None or not 0 < value < np.inf:
                raise ValueError(
                    f"`{attribute}` of {kind} is `{expression}`, which must be positive, but comes "
                    f"out as {value} with the constants' values."
                )
            numbers[attribute] = value
        return replace(self, **numbers) if numbers else self

    def scaled(self, factor: float) -> Self:
        """Return this shape, which has been measured, with lengths multiplied by a number."""
        lengths = {name: getattr(self, name) for name in self.lengths}
        return replace(self, **{k: factor * v for k, v in lengths.items() if v is not None})

    def dimensions(self) -> Iterator[tuple[str, Any]]:
        """Yield the shape's own fields: what says how it looks, but for colour and name."""
        common = {f.name for f in fields(Shape)}
        for entry in fields(self):
            if entry.name not in common:
                yield entry.name, getattr(self, entry.name)


def real_number(value: Any) -> float | None:
    """Return a value as a float, or None where it is no real number."""
    try:
        return number(value, "")
    except ValueError:
        return None


def _length(value: Any, what: str) -> Any:
    """Return a length as a float, or as an expression when it has symbols."""
    if isinstance(value, sm.Expr) and value.free_symbols:
        return value
    length = None if isinstance(value, bool) else real_number(value)
    if length is None or not 0 < length < np.inf:
        raise ValueError(
            f"{what} must be a positive number or a SymPy expression of constants, got "
            f"{shown(value)}."
        )
    return length


def check_axis(value: Any, kind: str) -> None:
    """Refuse what is not one of the three axes."""
    choice(value, ("x", "y", "z"), f"`axis` of {kind}")
