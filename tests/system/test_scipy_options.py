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
