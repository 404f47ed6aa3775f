"""CommonRoad's multi-body model against the package of its authors, and laws of mechanics."""

from functools import cache
from pathlib import Path

import numpy as np
import pytest

from pydy.vehicles import CARS, commonroad_car
from pydy.vehicles.commonroad import suspension, tires

# The states in CommonRoad's order, and derivatives by commonroad-vehicle-models 3.0.2 with inputs
# 0.15 rad/s and −3 m/s². `benchmarks/vehicle_models.py` compares manoeuvres.
NAMES = (
    *("x", "y", "delta", "u", "psi", "r", "phi", "p", "theta", "q", "v", "z", "w"),
    *("phi_f", "p_f", "v_f", "z_f", "w_f", "phi_r", "p_r", "v_r", "z_r", "w_r"),
    *("omega_fl", "omega_fr", "omega_rl", "omega_rr", "y_f", "y_r"),
)
STATE = [
    *(1.0, 2.0, 0.05, 15.0, 0.3, 0.2, 0.04, -0.1, -0.02, 0.15, -0.6, 0.01, -0.08),
    *(0.02, 0.3, -0.4, 0.021, 0.05, 0.01, -0.2, -0.9, 0.018, -0.04),
    *(42.0, 45.0, 41.0, 46.0, 0.005, -0.004),
]
INPUTS = {"v_delta": 0.15, "a_long": -3.0}
RATES = {
    "ford_escort": [
        14.507359460880894, 3.85960120644473, 0.15, 3.49647265375032,
        0.2, -4.980056701660896, -0.1, -16.710822745194847,
        0.15, 2.890216074011379, 2.0969220506283675, -0.08,
        1.6776650500841725, 0.3, -189.52171552296204, 98.99220093798486,
        0.05, -15.975462472501102, -0.2, -44.291540936711804,
        6.0230728423575055, -0.04, -53.778885461330056, -141.5637231888866,
        -968.5297799420906, 274.5077987762092, -883.2783363435193, -0.023215999999999903,
        -0.0017519999999999758,
    ],
    "bmw_320i": [
        14.507359460880894, 3.85960120644473, 0.15, 3.2805363631677027,
        0.2, -2.3241811580502594, -0.1, -17.55825128981723,
        0.15, 1.8517872811028186, 2.2179090072469094, -0.08,
        1.6212271013866904, 0.3, -179.37853717150625, 88.45482848361587,
        0.05, -20.281565771194657, -0.2, -25.300935215878432,
        -8.170060943521081, -0.04, -29.256290201775116, -97.61038056107087,
        -809.357471533159, 199.38965635164342, -772.2521675884884, 0.03123914128000005,
        0.015456581280000048,
    ],
    "vw_vanagon": [
        14.507359460880894, 3.85960120644473, 0.15, 3.7647006324872874,
        0.2, -2.4607713515520215, -0.1, -16.290992239939843,
        0.15, 2.825432491336427, 2.4807187953962533, -0.08,
        2.127878286957775, 0.3, -155.9094740291693, 80.62871303833715,
        0.05, -23.928402213065034, -0.2, -17.51636062095817,
        -1.614942769155997, -0.04, -35.75626652506639, -164.86052046625545,
        -1123.7407448400277, 230.9489556795778, -1088.093247992341, 0.030158320480000056,
        0.03577272048000002,
    ],
}  # fmt: skip
WHEELS = ("fl", "fr", "rl", "rr")
model = cache(commonroad_car)


def names_of(system):
    return [str(s).removesuffix("(t)") for s in system.states]


def state_of(system, **changed):
    """Return the state above with other values of some coordinates and speeds."""
    values = dict(zip(NAMES, STATE, strict=True)) | changed
    return np.array([values[name] for name in names_of(system)])


def rates_of(system, state, **inputs):
    rates = system.evaluate_ode(state, r={**INPUTS, **inputs})
    return dict(zip(names_of(system), rates, strict=True))


def outputs_of(system, state, *names):
    values = system.evaluate_outputs(state, r=INPUTS)
    by_name = dict(zip(map(str, system.outputs_symbols), values, strict=True))
    return np.array([[by_name[f"{name}_{wheel}"] for wheel in WHEELS] for name in names])


def constants_of(system):
    return {str(symbol): value for symbol, value in system.constants.items()}


@pytest.mark.parametrize("vehicle", CARS)
def test_derivatives_are_those_of_the_package(vehicle):
    system = model(vehicle, "MB")
    rates = rates_of(system, state_of(system))
    assert [rates[name] for name in NAMES] == pytest.approx(RATES[vehicle], rel=1e-11, abs=1e-12)


def test_internal_forces_cancel():
    # What springs, dampers and joints exert on the sprung mass, they exert on the axles.
    system = model("bmw_320i", "MB")
    c, state = constants_of(system), state_of(system)
    rates = rates_of(system, state)
    Fx, Fy, Fz = outputs_of(system, state, "Fx", "Fy", "Fz")
    sin, cos = np.sin(STATE[2]), np.cos(STATE[2])
    across = Fx[:2].sum() * sin + Fy[:2].sum() * cos + Fy[2:].sum()
    masses = {"": c["m_s"], "_f": c["m_uf"], "_r": c["m_ur"]}
    accelerated = sum(m * (rates[f"v{part}"] + 15.0 * 0.2) for part, m in masses.items())
    assert accelerated == pytest.approx(across, rel=1e-11)
    lowered = sum(m * (rates[f"w{part}"] - c["g"]) for part, m in masses.items())
    assert lowered == pytest.approx(-Fz.sum(), rel=1e-11)


@pytest.mark.parametrize("vehicle", CARS)
def test_the_car_stands_level_where_springs_and_tires_carry_its_weight(vehicle):
    system = model(vehicle, "MB")
    c = constants_of(system)
    L = c["a"] + c["b"]
    loads = [c["g"] * (c["m_s"] * c[arm] / L + c[m]) for arm, m in (("b", "m_uf"), ("a", "m_ur"))]
    z_f, z_r = (load / (2 * c["K_zt"]) for load in loads)
    rest = dict.fromkeys(NAMES, 0.0) | {
        **{"u": 20.0, "z_f": z_f, "z_r": z_r},
        **{"theta": (z_r - z_f) / L, "z": (z_f * c["b"] + z_r * c["a"]) / L},
        **{f"omega_{wheel}": 20.0 / c["R"] for wheel in WHEELS},
    }
    state = state_of(system, **rest)
    rates = rates_of(system, state, v_delta=0.0, a_long=0.0)
    for name in ("v", "w", "p", "r", "w_f", "w_r", "p_f", "p_r", "v_f", "v_r"):
        assert rates[name] == pytest.approx(0.0, abs=1e-10)
    (Fz,) = outputs_of(system, state, "Fz")
    assert Fz == pytest.approx(np.repeat(loads, 2) / 2)
    # Pitch is turned by the forces that the shift of the longitudinal slip makes.
    (Fx,) = outputs_of(system, state, "Fx")
    assert c["I_y"] * rates["q"] == pytest.approx(Fx.sum() * (c["h"] - rest["z"]), abs=1e-9)


def test_without_tire_forces_and_dampers_heave_and_pitch_conserve_energy(monkeypatch):
    # Not zero: the model would lack the lateral compliance of the tires.
    monkeypatch.setattr(suspension, "tire_forces", lambda Fz, *_: (0, 1e-99 * Fz))
    system = commonroad_car("ford_escort", "MB", speed=15.0)
    for damping in ("K_sdf", "K_sdr"):
        system.constants[damping] = 0.0
    motion = system.simulate(rtol=1e-11, atol=1e-11)
    c = constants_of(system)
    z, theta, w, q = (motion[name] for name in ("z", "theta", "w", "q"))
    energy = c["m_s"] * w**2 / 2 + c["I_y"] * q**2 / 2 - c["m_s"] * c["g"] * z
    L = c["a"] + c["b"]
    for end, ahead, share in (("f", c["a"], c["b"] / L), ("r", -c["b"], c["a"] / L)):
        z_u, w_u, m_u = motion[f"z_{end}"], motion[f"w_{end}"], c[f"m_u{end}"]
        travel = z_u - z + ahead * theta
        springs = c[f"K_s{end}"] * travel**2 - share * c["m_s"] * c["g"] * travel
        energy = energy + springs + c["K_zt"] * z_u**2 + m_u * (w_u**2 / 2 - c["g"] * z_u)
    assert np.ptp(z) > 0.03
    assert energy == pytest.approx(np.full_like(energy, energy[0]), rel=1e-7)
    assert motion["u"] == pytest.approx(np.full_like(z, 15.0))


def test_mirrored_states_have_mirrored_derivatives_if_tires_have_no_shifts(monkeypatch):
    for table, name in (
        (tires.COMBINED_LONGITUDINAL, "hx1"),
        (tires.COMBINED_LATERAL, "by3"),
        (tires.COMBINED_LATERAL, "vy1"),
    ):
        monkeypatch.setitem(table, name, 0.0)
    system = commonroad_car("bmw_320i", "MB")
    values = dict(zip(NAMES, STATE, strict=True))
    odd = {"y", "delta", "psi", "r", "v", "phi", "p"}
    odd |= {f"{name}_{end}" for name in ("phi", "p", "v", "y") for end in "fr"}

    def mirrored(values):
        result = {name: -value if name in odd else value for name, value in values.items()}
        for end in "fr":
            left, right = f"omega_{end}l", f"omega_{end}r"
            result[left], result[right] = values[right], values[left]
        return result

    one = rates_of(system, state_of(system))
    other = rates_of(system, state_of(system, **mirrored(values)), v_delta=-0.15)
    expected = mirrored(one)
    assert [other[name] for name in NAMES] == pytest.approx([expected[name] for name in NAMES])


def test_a_wheel_that_has_stopped_starts_again_when_the_brake_is_released():
    system = model("vw_vanagon", "MB")
    state = state_of(system, omega_rl=-1e-12)
    assert rates_of(system, state, a_long=-9.0)["omega_rl"] == 0.0
    assert rates_of(system, state, a_long=0.0)["omega_rl"] > 100.0


def test_a_wheel_that_locks_stands_still():
    system = commonroad_car("bmw_320i", "MB", speed=15.0)
    system.specifieds = {"v_delta": 0.15, "a_long": -0.5 * 9.81}
    motion = system.simulate()
    assert motion["omega_rr"][-1] == pytest.approx(0.0, abs=1e-4)
    assert motion["omega_rr"].min() > -1e-4
    assert motion["kappa_rr"][-1] == pytest.approx(-1.0, rel=1e-5)
    assert motion["omega_fl"][-1] > 20.0


def rows_of_page(columns):
    """Return the cells of rows by the names that are in their first cells."""
    page = Path(__file__).parents[3] / "docs/reference/vehicles.md"
    lines = [line for line in page.read_text().splitlines() if line.count("|") == columns + 1]
    rows = [[cell.strip(" `") for cell in line.split("|")[1:-1]] for line in lines]
    return {name: cells for name, *cells in rows if cells[0] not in ("unit", "---")}


def test_the_reference_page_has_the_values_of_the_cars():
    rows = rows_of_page(6)
    for column, vehicle in enumerate(CARS):
        printed = {name: float(cells[2 + column]) for name, cells in rows.items()}
        assert printed == pytest.approx(constants_of(model(vehicle, "MB")), rel=1e-5)


def test_the_reference_page_has_the_coefficients_of_the_tire():
    tables = {"p": (tires.LONGITUDINAL, tires.LATERAL)}
    tables["r"] = (tires.COMBINED_LONGITUDINAL, tires.COMBINED_LATERAL)
    expected = {
        f"{kind}_{name.capitalize()}": value
        for kind, pair in tables.items()
        for table in pair
        for name, value in table.items()
    }
    assert {name: float(cells[2]) for name, cells in rows_of_page(4).items()} == expected
