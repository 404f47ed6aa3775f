"""Options of SciPy's solvers that are no numbers: SciPy itself does not say which it was."""

import numpy as np
import pytest

from pydy.models import multi_mass_spring_damper

ODEINT = ("mxstep", "mxords", "ml", "hmax", "h0", "hmin", "rtol", "atol", "tcrit")
WRONG = [
    *(("odeint", name, "x") for name in ODEINT),
    *(("odeint", name, None) for name in ("mxstep", "hmax")),
    *((method, name, "x") for method in ("RK45", "LSODA") for name in ("first_step", "rtol")),
    *(("RK45", "max_step", value) for value in ("x", None)),
    *(("odeint", name, -1) for name in ("mxstep",)),
]


@pytest.mark.parametrize(("solver", "option", "value"), WRONG)
def test_an_option_that_is_no_number_is_named(solver, option, value):
    system = multi_mass_spring_damper()
    system.ode_solver, system.times = solver, np.linspace(0.0, 1.0, num=3)
    with pytest.raises(ValueError, match=rf"`{option}` must .*, got {value!r}"):
        system.integrate(**{option: value})


@pytest.mark.parametrize("solver", ["odeint", "RK45", "Radau", "LSODA"])
def test_states_that_are_zero_need_an_atol(solver):
    system = multi_mass_spring_damper()
    system.initial_conditions = {"x0": 1.0}
    system.ode_solver, system.times = solver, np.linspace(0.0, 1.0, num=3)
    with pytest.raises(ValueError, match=r"`atol` must be above 0 .* got 0 for x\[1\]"):
        system.integrate(atol=0.0)


def test_an_export_onto_a_folder_is_refused(tmp_path):
    (tmp_path / "here.c").mkdir()
    with pytest.raises(IsADirectoryError, match="`path` must be a file, got the folder"):
        multi_mass_spring_damper().export(tmp_path / "here.c")


@pytest.mark.parametrize("name", ["loop", "file/below.zarr"])
def test_a_store_that_cannot_be_there_is_refused(tmp_path, name):
    (tmp_path / "loop").symlink_to(tmp_path / "loop")
    (tmp_path / "file").write_text("")
    system = multi_mass_spring_damper()
    system.ode_solver, system.times = "dop853", np.linspace(0.0, 1.0, num=3)
    with pytest.raises(ValueError, match=r"`store` must be a new path, got .*, which is"):
        system.integrate_ensemble(
            initial_conditions={system.states[0]: [1.0, 2.0]}, store=tmp_path / name
        )


@pytest.mark.parametrize(
    ("common", "own", "value"),
    [("max_step", "hmax", 0.02), ("first_step", "h0", 1e-7), ("min_step", "hmin", 1e-9)],
)
def test_odeint_takes_the_names_that_its_options_have_elsewhere(common, own, value):
    system = multi_mass_spring_damper()
    system.initial_conditions = {"x0": 1.0}
    system.times = np.linspace(0.0, 1.0, num=3)
    x, info = system.integrate(full_output=True, **{common: value})
    expected, told = system.integrate(full_output=True, **{own: value})
    np.testing.assert_array_equal(x, expected)
    assert info["nst"].tolist() == told["nst"].tolist()
    plain = system.integrate(full_output=True)[1]
    assert own != "hmax" or not np.array_equal(told["nst"], plain["nst"])
    with pytest.raises(TypeError, match=f"`{common}` and `{own}` are the same option of `odeint`"):
        system.integrate(**{common: value, own: value})


def test_no_limit_is_no_limit_for_odeint_either():
    system = multi_mass_spring_damper()
    system.initial_conditions, system.times = {"x0": 1.0}, [0.0, 1.0]
    expected = system.integrate()
    np.testing.assert_array_equal(system.integrate(max_step=np.inf, first_step=None), expected)


def test_the_step_of_fixed_steps_is_named():
    system = multi_mass_spring_damper()
    system.times, system.ode_solver = [0.0, 1.0], "rk4"
    with pytest.raises(TypeError, match=r"`max_step`; .* It is called `step` there"):
        system.integrate(max_step=0.1)
