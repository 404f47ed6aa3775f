"""The coefficients of the Magic Formula: names, versions, and values where a file has none.

Names are those of tire property files. A scaling factor that is missing is 1, other coefficients
are 0, with the exceptions of `DEFAULTS`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

VERSIONS = ("5.2", "6.1", "6.2", "PAC2002")


def _numbered(prefix: str, *numbers: int) -> tuple[str, ...]:
    return tuple(f"{prefix}{k}" for k in numbers)


def _upto(prefix: str, last: int) -> tuple[str, ...]:
    return _numbered(prefix, *range(1, last + 1))


# What each force or moment is computed from, in the versions that have it.
_BASIC = {
    "longitudinal force": (
        *_upto("PCX", 1), *_upto("PDX", 3), *_upto("PEX", 4), *_upto("PKX", 3), *_upto("PHX", 2),
        *_upto("PVX", 2),
    ),
    "lateral force": (
        *_upto("PCY", 1), *_upto("PDY", 3), *_upto("PEY", 4), *_upto("PKY", 3), *_upto("PHY", 2),
        *_upto("PVY", 4),
    ),
    "aligning moment": (
        *_upto("QBZ", 5), *_numbered("QBZ", 9, 10), *_upto("QCZ", 1), *_upto("QDZ", 4),
        *_numbered("QDZ", 6, 7, 8, 9), *_upto("QEZ", 5), *_upto("QHZ", 4),
    ),
    "combined longitudinal force": (
        *_upto("RBX", 2), *_upto("RCX", 1), *_upto("REX", 2), *_upto("RHX", 1),
    ),
    "combined lateral force": (
        *_upto("RBY", 3), *_upto("RCY", 1), *_upto("REY", 2), *_upto("RHY", 2), *_upto("RVY", 6),
    ),
    "combined aligning moment": _upto("SSZ", 4),
    "overturning moment": _upto("QSX", 3),
    "rolling resistance": _upto("QSY", 4),
    "normal force": ("VERTICAL_STIFFNESS", "VERTICAL_DAMPING"),
    "effective rolling radius": ("BREFF", "DREFF", "FREFF"),
}  # fmt: skip
_OLD = {
    "lateral force": ("PHY3",),
    "relaxation lengths": (*_upto("PTX", 3), *_upto("PTY", 2)),
}
_PRESSURE = {
    "longitudinal force": _upto("PPX", 4),
    "lateral force": _upto("PPY", 4),
    "aligning moment": _upto("PPZ", 2),
}
_NEW = {
    "lateral force": ("PEY5", *_numbered("PKY", 4, 5, 6, 7), "PPY5"),
    "aligning moment": ("QBZ6", "QDZ10", "QDZ11"),
    "combined longitudinal force": ("RBX3",),
    "combined lateral force": ("RBY4",),
    "overturning moment": (*_numbered("QSX", *range(4, 12)), "PPMX1"),
    "rolling resistance": _numbered("QSY", 5, 6, 7, 8),
    "relaxation lengths": (
        "LONGITUDINAL_STIFFNESS", "LATERAL_STIFFNESS", *_upto("PCFX", 3), *_upto("PCFY", 3),
    ),
}  # fmt: skip
_SPRING: dict[str, tuple[str, ...]] = {
    "normal force": ("Q_FZ2",),
    "effective rolling radius": ("Q_RE0",),
}
_NEWEST = {"overturning moment": _numbered("QSX", 12, 13, 14)}
_SCALING = (
    "LFZO", "LMUX", "LMUY", "LCX", "LEX", "LKX", "LHX", "LVX", "LCY", "LEY", "LKY", "LHY", "LVY",
    "LTR", "LRES", "LXAL", "LYKA", "LVYKA", "LS", "LMX", "LVMX", "LMY", "LCZ",
)  # fmt: skip
_SCALING_OF = {
    "5.2": ("LGAX", "LGAY", "LGAZ", "LSGKP", "LSGAL"),
    "PAC2002": ("LGAX", "LGAY", "LGAZ", "LKYC", "LSGKP", "LSGAL"),
    "6.1": ("LKYC", "LKZC", "LMUV"),
    "6.2": ("LKYC", "LKZC", "LMUV"),
}
_PARTS: dict[str, tuple[dict[str, tuple[str, ...]], ...]] = {
    "5.2": (_BASIC, _OLD),
    "PAC2002": (_BASIC, _OLD, _PRESSURE),
    "6.1": (_BASIC, _PRESSURE, _NEW, _SPRING),
    "6.2": (_BASIC, _PRESSURE, _NEW, _SPRING, _NEWEST),
}
_GENERAL = ("FNOMIN", "UNLOADED_RADIUS", "LONGVL", "VXLOW", "NOMPRES", "INFLPRES")

# Values of what is missing, where it is neither a scaling factor (1) nor 0.
DEFAULTS = {
    "PKY4": 2.0,  # the sine of twice an arctangent, as in the older versions
    "Q_RE0": 1.0,  # the measured radius without load is UNLOADED_RADIUS
    "QSY7": 1.0,  # rolling resistance in proportion to the load, as in the older versions
    "LMUV": 0.0,  # a scaling factor by name; 0 is friction that does not depend on speed
    "LONGVL": 16.7,
    "VXLOW": 1.0,
}

# Other spellings, in files of other programs.
ALIASES = {
    "LFZ0": "LFZO",
    "LKYG": "LKYC",
    "LKZG": "LKZC",
    "IP": "INFLPRES",
    "IP_NOM": "NOMPRES",
    "QPZ1": "PPZ1",
    "QPZ2": "PPZ2",
}

# A group without any of these coefficients gives nothing.
NEEDED = {
    "longitudinal force": ("PCX1", "PDX1", "PKX1"),
    "lateral force": ("PCY1", "PDY1", "PKY1", "PKY2"),
    "combined longitudinal force": ("RBX1", "RCX1"),
    "combined lateral force": ("RBY1", "RCY1"),
}


def groups(version: str) -> dict[str, tuple[str, ...]]:
    """Return the names of the coefficients of a version, by what they are for."""
    collected: dict[str, tuple[str, ...]] = {}
    for part in _PARTS[version]:
        for group, names in part.items():
            collected[group] = (*collected.get(group, ()), *names)
    return {
        **collected,
        "scaling factors": (*_SCALING, *_SCALING_OF[version]),
        "general": _GENERAL,
    }


def names_of(version: str) -> tuple[str, ...]:
    """Return the names of all coefficients that a version reads."""
    return tuple(name for names in groups(version).values() for name in names)


ALL_NAMES = frozenset(name for version in VERSIONS for name in names_of(version))


# Numbers of tire property files that no force depends on: of rims and belts, bottoming, vibration,
# the contact patch, integration, and ranges. Source: the sections of MF-Tyre 6's files.
OTHERS_IN_FILES = frozenset(
    (
        "WIDTH", "RIM_RADIUS", "RIM_WIDTH", "ASPECT_RATIO", "MASS", "IXX", "IYY", "BELT_MASS",
        "BELT_IXX", "BELT_IYY", "GRAVITY", "MC_CONTOUR_A", "MC_CONTOUR_B", "Q_V1", "Q_V2",
        "Q_FCX", "Q_FCY", "Q_CAM", "PFZ1", "BOTTOM_OFFST", "BOTTOM_STIFF", "YAW_STIFFNESS",
        "FREQ_LONG", "FREQ_LAT", "FREQ_YAW", "FREQ_WINDUP", "DAMP_LONG", "DAMP_LAT", "DAMP_YAW",
        "DAMP_WINDUP", "DAMP_RESIDUAL", "DAMP_VLOW", "Q_BVX", "Q_BVT", "Q_RA1", "Q_RA2",
        "Q_RB1", "Q_RB2", "ELLIPS_SHIFT", "ELLIPS_LENGTH", "ELLIPS_HEIGHT", "ELLIPS_ORDER",
        "ELLIPS_MAX_STEP", "ELLIPS_NWIDTH", "ELLIPS_NLENGTH", "ROAD_INCREMENT",
        "ROAD_DIRECTION", "HMAX_LOCAL", "TIME_SWITCH_INTEG", "USER_SUB_ID", "N_TIRE_STATES",
        "PRESMIN", "PRESMAX", "FZMIN", "FZMAX", "KPUMIN", "KPUMAX", "ALPMIN", "ALPMAX",
        "CAMMIN", "CAMMAX",
    )
)  # fmt: skip


def default(name: str) -> float:
    """Return the value of a coefficient that is missing."""
    scaling = name in _SCALING or any(name in names for names in _SCALING_OF.values())
    return DEFAULTS.get(name, 1.0 if scaling else 0.0)


class Coefficients:
    """The values of all coefficients as attributes; those of other versions have their defaults."""

    def __init__(self, values: Mapping[str, Any]) -> None:
        self.__dict__.update(values)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):  # for `copy` and `pickle`
            raise AttributeError(name)
        return default(name)


def absent_groups(version: str, values: Mapping[str, Any]) -> Iterator[str]:
    """Yield the groups that are missing: what is essential in them is absent or zero."""

    def is_absent(name: str) -> bool:
        value = values.get(name, 0.0)
        return not hasattr(value, "free_symbols") and value == 0.0

    for group, names in groups(version).items():
        if group in ("scaling factors", "general"):
            continue
        needed = NEEDED.get(group)
        if any(map(is_absent, needed)) if needed else all(map(is_absent, names)):
            yield group
