"""Plots of tires show what the tires compute."""

import numpy as np
import pytest
import sympy as sm

from optional import optional
from pydy.vehicles import BrushTire, MagicFormula, plot_tire, plot_tire_carpet
from zoo.tires import TABLE_A31

plt = optional("matplotlib.pyplot")
TIRE = MagicFormula(TABLE_A31)


@pytest.fixture(autouse=True)
def _closed_figures():
    plt.switch_backend("agg")
    yield
    plt.close("all")


def test_characteristics_have_a_curve_for_each_load():
    ax = plot_tire(TIRE, "Fx")
    assert ax.get_xlabel() == r"$\kappa$"
    assert [line.get_label() for line in ax.lines] == ["2000 N", "4000 N", "6000 N", "8000 N"]
    x, y = ax.lines[1].get_data()
    np.testing.assert_allclose(y, TIRE.forces(4000, x, 0.0).Fx)


def test_angles_are_shown_in_degrees():
    ax = plot_tire(TIRE, "Mz", [3000], over="gamma", alpha=0.05, largest=0.1)
    x, y = ax.lines[0].get_data()
    assert x[-1] == pytest.approx(np.degrees(0.1))
    np.testing.assert_allclose(y, TIRE.forces(3000, 0.0, 0.05, np.radians(x)).Mz)
    assert ax.get_ylabel() == "Mz (N m)"


def test_a_carpet_has_lines_of_constant_slips():
    ax = plot_tire_carpet(TIRE, 3000, kappas=[-0.1, 0.0, 0.1], alphas=[0.0, 0.1])
    assert len(ax.lines) == 5
    expected = TIRE.forces(3000, 0.1, 0.1)
    x, y = ax.lines[1].get_data()  # of the larger angle
    assert (x[-1], y[-1]) == pytest.approx((expected.Fx, expected.Fy))
    x, y = ax.lines[-1].get_data()  # of the largest κ
    assert (x[-1], y[-1]) == pytest.approx((expected.Fx, expected.Fy))
    given = plt.subplots()[1]
    assert plot_tire_carpet(TIRE, ax=given) is given


def test_what_cannot_be_drawn_is_refused():
    with pytest.raises(ValueError, match="The parameter friction of the tire is an expression"):
        plot_tire(BrushTire(4000, 7e4, sm.Symbol("mu")))
    with pytest.raises(ValueError, match="`loads` must be given"):
        plot_tire(BrushTire(sm.Symbol("F"), 7e4, 1.0))
    with pytest.raises(ValueError, match="`force` must be one of 'Fx'"):
        plot_tire(TIRE, "Fz")
