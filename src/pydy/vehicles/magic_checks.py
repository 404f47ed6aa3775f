"""What the coefficients and options of a Magic Formula tire must be."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from typing import Any

from pydy._checks import choice, number, positive
from pydy._errors import warn_user
from pydy._names import nearest, some
from pydy.vehicles.algebra import checked_quantity, is_symbolic
from pydy.vehicles.coefficients import ALL_NAMES, DEFAULTS, OTHERS_IN_FILES, VERSIONS
from pydy.vehicles.equations import FORMS, FormulaVariant
from pydy.vehicles.tir import OTHER_FITTYP, SETTINGS, TireFile

# What each use mode computes: longitudinal, lateral, combined.
MODES = {0: (), 1: ("x",), 2: ("y",), 3: ("x", "y"), 4: ("x", "y", "combined")}
ESSENTIAL = {
    "x": ("longitudinal force",),
    "y": ("lateral force", "aligning moment"),
    "combined": ("combined longitudinal force", "combined lateral force"),
}


def form_of(
    version: str,
    equations: str | None,
    slip: str | None,
    saturation: float | None,
    relaxation_sign: float | None,
) -> tuple[str, FormulaVariant]:
    """Return the name of the equations and their form, with what the user chooses otherwise."""
    forms = FORMS[version]
    source = choice(next(iter(forms)) if equations is None else equations, forms, "`equations`")
    form = forms[source]
    if slip is not None:
        chosen = choice(slip, ("tangent", "angle"), "`slip`")
        form = replace(form, tangent=chosen == "tangent")
    if saturation is not None:
        A = positive(saturation, "`friction_saturation`", finite=True)
        form = replace(form, saturation=A)
    if relaxation_sign is not None:
        sign = choice(
            number(relaxation_sign, "`relaxation_sign`"), (-1.0, 1.0), "`relaxation_sign`"
        )
        form = replace(form, relaxation_sign=sign)
    return source, form


def checked_values(
    values: Mapping[str, Any], missing: Collection[str], form: FormulaVariant
) -> dict[str, Any]:
    """Return all coefficients, numbers or expressions, or raise an error that names one."""
    checked = {
        name: checked_quantity(value, f"`{name}`", arrays=False) for name, value in values.items()
    }
    for name in ("FNOMIN", "UNLOADED_RADIUS", "LFZO", "LCZ", "LONGVL", "VXLOW"):
        value = checked[name]
        if is_symbolic(value) or value > 0.0:
            continue
        if name != "VXLOW":
            problem = "is missing" if name in missing else f"must be positive, got {value}"
            raise ValueError(f"The coefficient {name} {problem}.")
        checked[name] = DEFAULTS[name]
    if form.pressure and checked["NOMPRES"] == 0.0:
        by_pressure = ("PP", "QSY8", "PCFX3", "PCFY3")
        acting = [
            n for n, v in checked.items() if n.startswith(by_pressure) and (is_symbolic(v) or v)
        ]
        if acting:
            raise ValueError(
                f"The coefficient NOMPRES is missing, the pressure that {some(acting)} refer to."
            )
    return checked


def check_vertical(values: Mapping[str, Any]) -> None:
    """Refuse a normal force without a stiffness, and a parabola that has it nowhere."""
    k, bend = values["VERTICAL_STIFFNESS"], values.get("Q_FZ2", 0.0)
    if k == 0.0:
        raise ValueError("The coefficient VERTICAL_STIFFNESS is missing.")
    size, load = values["UNLOADED_RADIUS"], values["FNOMIN"]
    if any(map(is_symbolic, (k, bend, size, load))):
        return
    most = (k * size / load) ** 2 / 4
    if bend > most:
        raise ValueError(
            f"The coefficient Q_FZ2 must be at most (VERTICAL_STIFFNESS R_0/F_z0)²/4 = {most:g}, "
            f"got {bend:g}: a parabola that is bent more has this stiffness at no load."
        )


def check_rolling_radius(values: Mapping[str, Any]) -> None:
    """Refuse an effective rolling radius without coefficients."""
    falls = [n for n in ("DREFF", "FREFF") if is_symbolic(values[n]) or values[n]]
    lacking = [n for n in ("VERTICAL_STIFFNESS", "BREFF") if values[n] == 0.0]
    if "DREFF" not in falls:
        lacking = [n for n in lacking if n != "BREFF"]
    if not falls:
        lacking += ["DREFF", "FREFF"]
    if lacking:
        raise ValueError(
            f"The tire has no effective rolling radius: {some(lacking)} "
            f"{'is' if len(lacking) == 1 else 'are'} missing. Give values with `replace`."
        )


def checked_combination(
    combined: str | None, file: TireFile | None, use_mode: int, absent: Collection[str]
) -> str:
    """Return how combined slip is computed; without coefficients the user must say so."""
    if combined is not None:
        combined = choice(combined, ("coefficients", "ellipse", "none"), "`combined`")
    elif file and str(file.sections.get("MODEL", {}).get("FE_METHOD", "")).upper() == "YES":
        combined = "ellipse"
    both = not {ESSENTIAL["x"][0], ESSENTIAL["y"][0]} & {*absent}
    lacking = [group for group in ESSENTIAL["combined"] if group in absent]
    if combined in (None, "coefficients") and use_mode % 10 == 4 and both and lacking:
        raise ValueError(
            f"The tire has no coefficients of the {' and the '.join(lacking)} (RBX1, RCX1, RBY1, "
            "RCY1 …). Choose `combined='ellipse'` for friction ellipses, `combined='none'` for "
            "forces that do not reduce each other, or a `use_mode` of pure slip."
        )
    return combined or "coefficients"


def warn_of_absent_groups(use_mode: int, absent: Collection[str]) -> None:
    """Warn of a force or an aligning moment that is zero, because it has no coefficients."""
    parts = [part for part in MODES[use_mode % 10] if part != "combined"]
    lacking = [group for part in parts for group in ESSENTIAL[part] if group in absent]
    if lacking:
        warn_user(
            f"The tire has no coefficients of the {' and the '.join(lacking)}: "
            f"{'it is' if len(lacking) == 1 else 'they are'} zero. `MagicFormula.missing` lists "
            "all that are missing."
        )


def version_of(version: str | None, file: TireFile | None) -> str:
    """Return the version of the Magic Formula: the user's, or that of the file."""
    if version is not None:
        return choice(version, VERSIONS, "`version`")
    if file is None:
        return "6.1"
    if file.version is None:
        kind = file.coefficients.get("FITTYP")
        named = "" if kind is None else f" (FITTYP = {kind:g}{OTHER_FITTYP.get(kind, '')})"
        raise ValueError(
            f"{file.path} is for another tire model{named} than the Magic Formula of these "
            f"versions: {', '.join(VERSIONS)}. Say which one its coefficients belong to: "
            "`version=`."
        )
    return file.version


def use_mode_of(use_mode: int | None, file: TireFile | None) -> int:
    """Return a use mode; turn slip (5) is not among what can be computed, and is left away.

    The sign of a file's mode, which mirrors the tire, is not part of it.
    """
    if use_mode is None:
        mode = abs(file.use_mode) if file and file.use_mode is not None else 4
        if mode % 10 == 5:
            mode -= 1
        if mode % 10 not in MODES:
            raise ValueError(
                f"{file.path if file else 'The file'} has the unknown use mode {mode}. Choose a "
                "`use_mode` of 0 to 4."
            )
        return mode
    value = number(use_mode, "`use_mode`")
    if isinstance(use_mode, bool) or value not in range(1000) or value % 10 not in MODES:
        raise ValueError(
            f"`use_mode` must be 0 to 4, with further digits for transients, got {use_mode!r}."
        )
    return int(value)


def check_names(coefficients: Mapping[str, object]) -> None:
    """Refuse names that no version of the Magic Formula has."""
    for name in coefficients:
        if name not in ALL_NAMES | OTHERS_IN_FILES | {*SETTINGS}:
            raise ValueError(
                f"`coefficients` has the key {name!r}, which no version of the Magic Formula has. "
                f"{nearest(name, list(ALL_NAMES), or_all=False) or 'Leave it out.'}"
            )


def warn_of_other_versions(version: str, unused: Mapping[str, Any]) -> None:
    """Warn of coefficients that the assumed version does not read."""
    acting = [name for name, value in unused.items() if is_symbolic(value) or value != 0.0]
    if acting:
        warn_user(
            f"Version {version} of the Magic Formula, which is assumed, does not read "
            f"{some(acting)}. Pass `version`, the one that the coefficients belong to."
        )
