"""Units of tire property files, and which quantities have one."""

from __future__ import annotations

from math import pi

# Factors to SI, by the words that files use, in lower case without `_`, spaces and a final s.
_FACTORS: dict[str, dict[str, float]] = {
    "LENGTH": {
        **dict.fromkeys(("meter", "metre", "m"), 1.0),
        **dict.fromkeys(("millimeter", "millimetre", "mm"), 0.001),
        **dict.fromkeys(("centimeter", "centimetre", "cm"), 1e-2),
        **dict.fromkeys(("kilometer", "kilometre", "km"), 1e3),
        **dict.fromkeys(("inch", "inche", "in"), 0.0254),
        **dict.fromkeys(("foot", "feet", "ft"), 0.3048),
    },
    "FORCE": {
        **dict.fromkeys(("newton", "n"), 1.0),
        **dict.fromkeys(("kilonewton", "knewton", "kn"), 1e3),
        **dict.fromkeys(("kilogramforce", "kgforce", "kgf", "kp"), 9.80665),
        **dict.fromkeys(("poundforce", "lbf"), 4.4482216152605),
    },
    "ANGLE": {
        **dict.fromkeys(("radian", "rad"), 1.0),
        **dict.fromkeys(("degree", "deg"), pi / 180.0),
    },
    "MASS": {
        **dict.fromkeys(("kilogram", "kg"), 1.0),
        **dict.fromkeys(("gram", "g"), 0.001),
        **dict.fromkeys(("tonne", "megagram"), 1e3),
        **dict.fromkeys(("poundmass", "lbm", "lb", "pound"), 0.45359237),
        "slug": 14.593902937206,
    },
    "TIME": {
        **dict.fromkeys(("second", "sec", "s"), 1.0),
        **dict.fromkeys(("millisecond", "ms"), 0.001),
        **dict.fromkeys(("minute", "min"), 60.0),
        **dict.fromkeys(("hour", "h"), 3600.0),
    },
    "PRESSURE": {
        **dict.fromkeys(("pascal", "pa"), 1.0),
        **dict.fromkeys(("kilopascal", "kpa"), 1e3),
        **dict.fromkeys(("megapascal", "mpa"), 1e6),
        "bar": 1e5,
        "psi": 6894.757293168,
    },
}
UNITS = tuple(_FACTORS)

# Exponents of length, force, angle, mass, time, pressure.
_LENGTH, _FORCE, _ANGLE = (1, 0, 0, 0, 0, 0), (0, 1, 0, 0, 0, 0), (0, 0, 1, 0, 0, 0)
_MASS, _TIME, _PRESSURE = (0, 0, 0, 1, 0, 0), (0, 0, 0, 0, 1, 0), (0, 0, 0, 0, 0, 1)
_SPEED, _STIFFNESS, _DAMPING = (1, 0, 0, 0, -1, 0), (-1, 1, 0, 0, 0, 0), (-1, 1, 0, 0, 1, 0)
_ROTATIONAL, _INERTIA = (1, 1, -1, 0, 0, 0), (2, 0, 0, 1, 0, 0)
_FREQUENCY, _ACCELERATION = (0, 0, 0, 0, -1, 0), (1, 0, 0, 0, -2, 0)
_DIMENSIONS = {
    **dict.fromkeys(
        (
            "UNLOADED_RADIUS", "WIDTH", "RIM_RADIUS", "RIM_WIDTH", "BOTTOM_OFFST", "ROAD_INCREMENT",
            "PEN",
        ),
        _LENGTH,
    ),
    **dict.fromkeys(("FNOMIN", "FZMIN", "FZMAX", "FZ"), _FORCE),
    **dict.fromkeys(("ALPMIN", "ALPMAX", "CAMMIN", "CAMMAX"), _ANGLE),
    **dict.fromkeys(("MASS", "BELT_MASS", "MBELT"), _MASS),
    **dict.fromkeys(("HMAX_LOCAL", "TIME_SWITCH_INTEG"), _TIME),
    **dict.fromkeys(("NOMPRES", "INFLPRES", "IP", "IP_NOM", "PRESMIN", "PRESMAX"), _PRESSURE),
    **dict.fromkeys(("LONGVL", "VXLOW"), _SPEED),
    **dict.fromkeys(
        ("VERTICAL_STIFFNESS", "LONGITUDINAL_STIFFNESS", "LATERAL_STIFFNESS", "BOTTOM_STIFF"),
        _STIFFNESS,
    ),
    "VERTICAL_DAMPING": _DAMPING,
    "YAW_STIFFNESS": _ROTATIONAL,
    **dict.fromkeys(("IXX", "IYY", "BELT_IXX", "BELT_IYY"), _INERTIA),
    **dict.fromkeys(("FREQ_LONG", "FREQ_LAT", "FREQ_YAW", "FREQ_WINDUP"), _FREQUENCY),
    "GRAVITY": _ACCELERATION,
}  # fmt: skip


def factors(units: dict[str, str]) -> dict[str, float]:
    """Return the factors to SI of the units of a file, or raise a ValueError that names one.

    Without a unit of pressure it is that of force by that of length squared.
    """
    found = dict.fromkeys(UNITS, 1.0)
    for quantity, word in units.items():
        if quantity not in _FACTORS:
            continue
        table = _FACTORS[quantity]
        plain = word.lower().replace("_", "").replace(" ", "").replace("-", "")
        factor = table.get(plain, table.get(plain.removesuffix("s")))
        if factor is None:
            raise ValueError(f"{quantity} has the unit {word!r}, not one of {', '.join(table)}")
        found[quantity] = factor
    if "PRESSURE" not in units:
        found["PRESSURE"] = found["FORCE"] / found["LENGTH"] ** 2
    return found


def in_si(name: str, value: float, by_quantity: dict[str, float]) -> float:
    """Return a quantity of a file in SI units; coefficients without a unit stay as they are."""
    for quantity, power in zip(UNITS, _DIMENSIONS.get(name, ()), strict=False):
        if power:
            value *= by_quantity[quantity] ** power
    return value
