"""Tires with published data, and the published equations of tires at 30 digits.

The equations are written down as in their sources, with forces and not with forces per load, so
that they share neither form nor code with the package.
"""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import mpmath as mp
import numpy as np

# Pacejka, Tyre and Vehicle Dynamics, 2nd ed., 2006, Table A3.1: 205/60R15 91V at 2.2 bar, ISO.
TABLE_A31 = {
    "FNOMIN": 4000.0, "UNLOADED_RADIUS": 0.313, "LONGVL": 16.67, "NOMPRES": 220000.0,
    "PCX1": 1.685, "PDX1": 1.210, "PDX2": -0.037, "PEX1": 0.344, "PEX2": 0.095, "PEX3": -0.020,
    "PEX4": 0.0, "PKX1": 21.51, "PKX2": -0.163, "PKX3": 0.245, "PHX1": -0.002, "PHX2": 0.002,
    "PVX1": 0.0, "PVX2": 0.0,
    "RBX1": 12.35, "RBX2": -10.77, "RBX3": 0.0, "RCX1": 1.092, "RHX1": 0.007,
    "PCY1": 1.193, "PDY1": -0.990, "PDY2": 0.145, "PDY3": -11.23, "PEY1": -1.003, "PEY2": -0.537,
    "PEY3": -0.083, "PEY4": -4.787, "PKY1": -14.95, "PKY2": 2.130, "PKY3": -0.028, "PKY4": 2.0,
    "PKY5": 0.0, "PKY6": -0.92, "PKY7": -0.24, "PHY1": 0.003, "PHY2": -0.001, "PVY1": 0.045,
    "PVY2": -0.024, "PVY3": -0.532, "PVY4": 0.039,
    "RBY1": 6.461, "RBY2": 4.196, "RBY3": -0.015, "RBY4": 0.0, "RCY1": 1.081, "RHY1": 0.009,
    "RVY1": 0.053, "RVY2": -0.073, "RVY3": 0.517, "RVY4": 35.44, "RVY5": 1.9, "RVY6": -10.71,
    "QBZ1": 8.964, "QBZ2": -1.106, "QBZ3": -0.842, "QBZ5": -0.227, "QBZ9": 18.47, "QBZ10": 0.0,
    "QCZ1": 1.180, "QDZ1": 0.100, "QDZ2": -0.001, "QDZ3": 0.007, "QDZ4": 13.05, "QDZ6": -0.008,
    "QDZ7": 0.0, "QDZ8": -0.296, "QDZ9": -0.009, "QEZ1": -1.609, "QEZ2": -0.359, "QEZ4": 0.174,
    "QEZ5": -0.896, "QHZ1": 0.007, "QHZ2": -0.002, "QHZ3": 0.147, "QHZ4": 0.004,
    "SSZ1": 0.043, "SSZ2": 0.001, "SSZ3": 0.731, "SSZ4": -0.238, "QSY1": 0.01,
}  # fmt: skip

# Scaling factors, none of which is 1, and coefficients that are 0 in the table.
SCALING = {
    "LFZO": 0.9, "LMUX": 0.93, "LMUY": 0.95, "LCX": 1.02, "LEX": 0.97, "LKX": 1.05, "LHX": 0.8,
    "LVX": 0.7, "LCY": 0.98, "LEY": 1.1, "LKY": 0.94, "LHY": 0.9, "LVY": 1.2, "LTR": 1.07,
    "LRES": 0.85, "LXAL": 1.03, "LYKA": 0.96, "LVYKA": 1.15, "LS": 0.88, "LMX": 1.13, "LVMX": 0.75,
    "LMY": 0.92,
}  # fmt: skip
_FURTHER = {
    "PDX3": 0.4, "PEX4": 0.02, "PVX1": 0.003, "PVX2": -0.002, "RHY2": 0.002, "REX1": -0.3,
    "REX2": 0.1, "REY1": 0.2, "REY2": -0.05, "QBZ4": 0.12, "QBZ10": 0.1, "QDZ7": 0.004,
    "QEZ3": 0.05, "QSX1": 0.02, "QSX2": 0.9, "QSX3": 0.03, "QSY2": 0.05, "QSY3": 0.002,
    "QSY4": 0.001,
}  # fmt: skip
_PRESSURE = {
    "PPX1": -0.35, "PPX2": 0.38, "PPX3": -0.09, "PPX4": 0.06, "PPY1": -0.6, "PPY2": -0.06,
    "PPY3": -0.16, "PPY4": 0.27, "PPZ1": -0.4, "PPZ2": 0.3,
}  # fmt: skip
_NEW = {
    "PKY4": 1.9, "PKY5": 0.6, "PEY5": 0.3, "PPY5": 0.2, "QDZ10": 0.5, "QDZ11": -0.2, "RBX3": 6.0,
    "RBY4": 3.0, "QSX4": 0.03, "QSX5": 1.2, "QSX6": 1.1, "QSX7": 0.7, "QSX8": 0.6, "QSX9": 1.4,
    "QSX10": 0.2, "QSX11": 0.8, "PPMX1": -0.1, "QSY5": 0.1, "QSY6": -0.05, "QSY7": 0.85,
    "QSY8": -0.4, "LKYC": 1.04, "LKZC": 0.91, "LMUV": 0.06,
}  # fmt: skip
_OLD = {
    "PHY3": 0.031, "LGAX": 0.9, "LGAY": 1.08, "LGAZ": 0.95, "PTX1": 2.37, "PTX2": 1.41,
    "PTX3": 0.57, "PTY1": 2.14, "PTY2": 1.98, "LSGKP": 0.9, "LSGAL": 1.1,
}  # fmt: skip
COMMON = {**TABLE_A31, **SCALING, **_FURTHER}
# Name: version, source of the equations, coefficients.
TIRES: dict[str, tuple[str, str | None, dict[str, float]]] = {
    "Table A3.1": ("6.1", None, TABLE_A31),
    "6.1, book": ("6.1", "pacejka", {**COMMON, **_PRESSURE, **_NEW, "QBZ6": 0.4}),
    "6.2, paper": (
        "6.2",
        "besselink",
        {**COMMON, **_PRESSURE, **_NEW, "QSX12": 0.3, "QSX13": 0.02, "QSX14": -0.05},
    ),
    "5.2": ("5.2", None, {**COMMON, **_OLD}),
    "PAC2002": ("PAC2002", None, {**COMMON, **_OLD, **_PRESSURE, "LKYC": 1.06}),
}
_IS_ONE = ("LGAX", "LGAY", "LGAZ", "LKYC", "LKZC", "LSGKP", "LSGAL", *SCALING)


NAMES = ("Fx", "Fy", "Mx", "My", "Mz")


def slip_states():
    """Return twenty states: load, κ, α, γ, speed, pressure."""
    random = np.random.default_rng(54)
    low = [1000.0, -0.3, -0.25, -0.15, 5.0, 1.8e5]
    high = [8000.0, 0.3, 0.25, 0.15, 40.0, 2.6e5]
    return random.uniform(low, high, (20, 6))


class Published(SimpleNamespace):
    """Coefficients at 30 digits; those that are missing as the sources say."""

    def __getattr__(self, name: str) -> Any:
        return mp.mpf({"PKY4": 2, "QSY7": 1}.get(name, int(name in _IS_ONE)))


def magic_formula(name: str, Fz: Any, kappa: Any, alpha: Any, gamma: Any, V: Any, pressure: Any):
    """Return Fx, Fy, Mx, My, Mz of one of `TIRES` that rolls forward, of combined slip."""
    version, _, values = TIRES[name]
    c = Published(**{k: mp.mpf(repr(v)) for k, v in values.items()})
    Fz, kappa, alpha, gamma, V, pressure = map(mp.mpf, (Fz, kappa, alpha, gamma, V, pressure))
    book = name in ("Table A3.1", "6.1, book")
    new = version.startswith("6")
    old = not new
    sin, cos, tan, atan, sqrt, sgn = mp.sin, mp.cos, mp.tan, mp.atan, mp.sqrt, mp.sign
    R0, Fz0 = c.UNLOADED_RADIUS, c.FNOMIN
    Fz0s = c.LFZO * Fz0
    dfz = (Fz - Fz0s) / Fz0s
    dpi = mp.mpf(0) if version == "5.2" else (pressure - c.NOMPRES) / c.NOMPRES
    a, g = (tan(alpha), sin(gamma)) if book else (alpha, gamma)
    Vs = V * sqrt(kappa**2 + tan(alpha) ** 2)
    mux_star = c.LMUX / (1 + c.LMUV * Vs / c.LONGVL)
    muy_star = c.LMUY / (1 + c.LMUV * Vs / c.LONGVL)
    A = 10 if book else 1
    mux_dash = A * mux_star / (1 + (A - 1) * mux_star)
    muy_dash = A * muy_star / (1 + (A - 1) * muy_star)

    # Pure longitudinal slip.
    gx = g * c.LGAX
    Cx = c.PCX1 * c.LCX
    mux = (c.PDX1 + c.PDX2 * dfz) * (1 + c.PPX3 * dpi + c.PPX4 * dpi**2)
    mux *= (1 - c.PDX3 * gx**2) * mux_star
    Dx = mux * Fz
    Kx = Fz * (c.PKX1 + c.PKX2 * dfz) * mp.exp(c.PKX3 * dfz) * (1 + c.PPX1 * dpi + c.PPX2 * dpi**2)
    Kx *= c.LKX
    Bx = Kx / (Cx * Dx)
    kx = kappa + (c.PHX1 + c.PHX2 * dfz) * c.LHX
    Ex = (c.PEX1 + c.PEX2 * dfz + c.PEX3 * dfz**2) * (1 - c.PEX4 * sgn(kx)) * c.LEX
    Ex = min(Ex, 1)
    SVx = Fz * (c.PVX1 + c.PVX2 * dfz) * c.LVX * mux_dash
    Fx0 = Dx * sin(Cx * atan(Bx * kx - Ex * (Bx * kx - atan(Bx * kx)))) + SVx

    # Pure side slip, with the camber and upright.
    def side(g):
        gy = g * c.LGAY
        Cy = c.PCY1 * c.LCY
        muy = (c.PDY1 + c.PDY2 * dfz) * (1 + c.PPY3 * dpi + c.PPY4 * dpi**2)
        muy *= (1 - c.PDY3 * gy**2) * muy_star
        Dy = muy * Fz
        Ky = c.PKY1 * Fz0s * (1 + c.PPY1 * dpi) * (1 - c.PKY3 * abs(gy))
        inner = Fz / Fz0s / ((c.PKY2 + c.PKY5 * gy**2) * (1 + c.PPY2 * dpi))
        Ky *= sin(c.PKY4 * atan(inner)) * c.LKY
        By = Ky / (Cy * Dy)
        SVyg = Fz * (c.PVY3 + c.PVY4 * dfz) * gy * c.LKYC * muy_dash
        SVy = Fz * (c.PVY1 + c.PVY2 * dfz) * c.LVY * muy_dash + SVyg
        SHy = (c.PHY1 + c.PHY2 * dfz) * c.LHY
        if new:
            Kyg0 = Fz * (c.PKY6 + c.PKY7 * dfz) * (1 + c.PPY5 * dpi) * c.LKYC
            SHy += (Kyg0 * gy - SVyg) / Ky
        else:
            SHy += c.PHY3 * gy * c.LKYC
        ay = a + SHy
        Ey = (c.PEY1 + c.PEY2 * dfz) * c.LEY
        Ey *= 1 + c.PEY5 * gy**2 - (c.PEY3 + c.PEY4 * gy) * sgn(ay)
        Ey = min(Ey, 1)
        Fy0 = Dy * sin(Cy * atan(By * ay - Ey * (By * ay - atan(By * ay)))) + SVy
        return Fy0, muy, Ky, SHy, SVy, By * Cy

    Fy0, muy, Ky, SHy, SVy, ByCy = side(g)

    # Combined slip.
    Bxa = (c.RBX1 + c.RBX3 * g**2) * cos(atan(c.RBX2 * kappa)) * c.LXAL
    Exa = min(c.REX1 + c.REX2 * dfz, 1)

    def Gx(x):
        return cos(c.RCX1 * atan(Bxa * x - Exa * (Bxa * x - atan(Bxa * x))))

    Fx = Fx0 * Gx(a + c.RHX1) / Gx(c.RHX1)
    SHyk = c.RHY1 + c.RHY2 * dfz
    Eyk = min(c.REY1 + c.REY2 * dfz, 1)

    def Gyk(g):
        B = (c.RBY1 + c.RBY4 * g**2) * cos(atan(c.RBY2 * (a - c.RBY3))) * c.LYKA

        def G(x):
            return cos(c.RCY1 * atan(B * x - Eyk * (B * x - atan(B * x))))

        return G(kappa + SHyk) / G(SHyk)

    DVyk = muy * Fz * (c.RVY1 + c.RVY2 * dfz + c.RVY3 * g) * cos(atan(c.RVY4 * a))
    SVyk = DVyk * sin(c.RVY5 * atan(c.RVY6 * kappa)) * c.LVYKA
    Fy = Gyk(g) * Fy0 + SVyk

    # Aligning moment.
    gz = g * c.LGAZ
    at = a + c.QHZ1 + c.QHZ2 * dfz + (c.QHZ3 + c.QHZ4 * dfz) * gz
    ar = a + SHy + SVy / Ky
    Bt = (c.QBZ1 + c.QBZ2 * dfz + c.QBZ3 * dfz**2) * c.LKY / muy_star
    Bt *= 1 + c.QBZ4 * gz + c.QBZ5 * abs(gz) + c.QBZ6 * gz**2
    Dt = Fz * R0 / (Fz0s if new else Fz0) * (c.QDZ1 + c.QDZ2 * dfz) * (1 - c.PPZ1 * dpi) * c.LTR
    Dt *= 1 + c.QDZ3 * (abs(gz) if book else gz) + c.QDZ4 * gz**2
    Et = c.QEZ1 + c.QEZ2 * dfz + c.QEZ3 * dfz**2
    Et *= 1 + (c.QEZ4 + c.QEZ5 * gz) * 2 / mp.pi * atan(Bt * c.QCZ1 * at)
    Et = min(Et, 1)
    Br = c.QBZ9 * c.LKY / muy_star + c.QBZ10 * ByCy
    Dr = (c.QDZ8 + c.QDZ9 * dfz) * (1 + c.PPZ2 * dpi) + (c.QDZ10 + c.QDZ11 * dfz) * abs(gz)
    Dr = (c.QDZ6 + c.QDZ7 * dfz) * c.LRES + Dr * gz * c.LKZC
    Dr *= Fz * R0 * muy_star * cos(alpha)

    def equivalent(x):
        if book:
            return sqrt(x**2 + (Kx / Ky) ** 2 * kappa**2) * sgn(x)
        return atan(sqrt(tan(x) ** 2 + (Kx / Ky) ** 2 * kappa**2)) * sgn(x)

    ate = equivalent(at)
    t = Dt * cos(c.QCZ1 * atan(Bt * ate - Et * (Bt * ate - atan(Bt * ate)))) * cos(alpha)
    if old:
        Fy_dash = Fy - SVyk
    else:
        Fy_dash = Gyk(mp.mpf(0) if book else g) * side(mp.mpf(0))[0]
    s = c.SSZ1 + c.SSZ2 * Fy / (Fz0s if book else Fz0) + (c.SSZ3 + c.SSZ4 * dfz) * g
    Mz = -t * Fy_dash + Dr * cos(atan(Br * equivalent(ar))) + s * R0 * c.LS * Fx

    # Overturning and rolling resistance.
    Mx = -c.QSX2 * gamma * (1 + c.PPMX1 * dpi) + c.QSX3 * Fy / Fz0 - c.QSX12 * gamma * abs(gamma)
    Mx += (
        c.QSX4
        * cos(c.QSX5 * atan((c.QSX6 * Fz / Fz0) ** 2))
        * sin(c.QSX7 * gamma + c.QSX8 * atan(c.QSX9 * Fy / Fz0))
    )
    Mx += c.QSX10 * atan(c.QSX11 * Fz / Fz0) * gamma
    offset = c.QSX1 * c.LVMX
    Mx = offset + c.LMX * Mx if version == "5.2" else c.LMX * (offset + Mx)
    Mx = R0 * (Fz * Mx + c.LMX * Fy * (c.QSX13 + c.QSX14 * abs(gamma)))
    v = V / c.LONGVL
    My = c.QSY1 + c.QSY2 * Fx / Fz0 + c.QSY3 * abs(v) + c.QSY4 * v**4
    My += (c.QSY5 + c.QSY6 * Fz / Fz0) * gamma**2
    My *= -R0 * Fz0 * (Fz / Fz0) ** c.QSY7 * (1 + dpi) ** c.QSY8 * c.LMY
    return Fx, Fy, Mx, My, Mz
