"""Fits of tires to forces, and what they say of data that do not determine a parameter."""

import numpy as np
import pytest
import sympy as sm

from pydy.errors import PyDyUserWarning
from pydy.vehicles import BrushTire, LinearTire, MagicFormula, fit_tire
from zoo.tires import TABLE_A31

ALPHA = np.radians(np.linspace(-12, 12, 25))
TIRE = MagicFormula(TABLE_A31)


def measured(tire=TIRE, names=("Fy", "Mz")):
    Fz, alpha = (v.ravel() for v in np.meshgrid([2000.0, 4000.0, 6000.0], ALPHA))
    forces = tire.forces(Fz, 0.0, alpha)
    return {"Fz": Fz, "kappa": 0.0, "alpha": alpha, **{n: getattr(forces, n) for n in names}}


def test_coefficients_are_recovered_from_forces_and_moments():
    free = ["PDY1", "PDY2", "PEY1", "PKY1", "PKY2", "QDZ1", "QBZ1"]
    start = TIRE.replace(**{n: 0.85 * TIRE.parameters[n] for n in free})
    fit = fit_tire(measured(), start, free)
    assert fit.success
    for name in free:
        assert fit.estimates[name] == pytest.approx(TABLE_A31[name], rel=1e-6), name
    assert fit.tire.forces(4000, 0, 0.05).Fy == pytest.approx(TIRE.forces(4000, 0, 0.05).Fy)
    assert set(fit.errors) == {"Fy", "Mz"}
    assert max(fit.errors.values()) < 1e-7
    assert "remaining errors Fy 0.0%" in repr(fit)


def test_standard_errors_are_those_of_linear_regression():
    random = np.random.default_rng(1)
    alpha = np.linspace(-0.05, 0.05, 50)
    noise = 20.0 * random.standard_normal(50)
    data = {"Fz": 4000.0, "kappa": 0.0, "alpha": alpha, "Fy": -6e4 * alpha + noise}
    fit = fit_tire(data, LinearTire(4000, 5e4), ["cornering_stiffness"])
    residuals = fit.residuals["Fy"]
    expected = np.sqrt((residuals**2).sum() / 49 / (alpha**2).sum())
    assert fit.standard_errors["cornering_stiffness"] == pytest.approx(expected, rel=1e-5)


def test_samples_that_were_not_measured_are_left_out():
    data = measured(BrushTire(4000, 7e4, 0.9), ("Fy",))
    data["Fy"][::3] = np.nan
    fit = fit_tire(data, BrushTire(4000, 5e4, 1.1), ["stiffness", "friction"])
    assert fit.estimates == pytest.approx({"stiffness": 7e4, "friction": 0.9}, rel=1e-6)
    assert np.isnan(fit.residuals["Fy"][0])


def test_parameters_without_effect_are_told():
    with pytest.warns(PyDyUserWarning, match="do not determine PDX3"):
        fit = fit_tire(measured(), TIRE, ["PDX3", "PDY1"])
    assert np.isinf(fit.standard_errors["PDX3"])
    assert np.isfinite(fit.standard_errors["PDY1"])


def test_bounds_hold():
    data = measured(BrushTire(4000, 7e4, 0.9), ("Fy",))
    fit = fit_tire(data, BrushTire(4000, 5e4, 0.7), ["friction"], bounds={"friction": (None, 0.8)})
    assert fit.estimates["friction"] == pytest.approx(0.8)
    with pytest.raises(ValueError, match="`bounds` of 'friction' must contain the tire's own"):
        fit_tire(data, BrushTire(4000, 5e4, 1.1), ["friction"], bounds={"friction": (0, 0.8)})


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"Fz": None}, "`measurements` lacks 'Fz'"),
        ({"Fy": None, "Mz": None}, "`measurements` lacks a force"),
        ({"fy": np.zeros(75)}, "has 'fy', which is no quantity of tires. Did you mean `Fy`"),
        ({"gamma": [0.0, 1.0]}, "arrays of one length"),
        ({"alpha": np.full(75, np.nan)}, "`measurements\\['alpha'\\]` must be finite"),
    ],
)
def test_measurements_are_checked(change, message):
    data = {k: v for k, v in {**measured(), **change}.items() if v is not None}
    with pytest.raises(ValueError, match=message):
        fit_tire(data, TIRE, ["PDY1"])


def test_what_is_free_is_checked():
    with pytest.raises(ValueError, match="'PDY9' is no parameter of the tire"):
        fit_tire(measured(), TIRE, ["PDY9"])
    with pytest.raises(ValueError, match="`free` is empty"):
        fit_tire(measured(), TIRE, [])
    with pytest.raises(ValueError, match="which is the expression mu in the tire"):
        fit_tire(measured(), TIRE.replace(LMUY=sm.Symbol("mu")), ["LMUY"])
