"""Plots of trajectories and ensembles."""

import sys

import numpy as np
import pytest
import sympy as sm

import zoo
from optional import optional
from pydy._names import label_parts, latex_of
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.plot import (
    plot_constraints,
    plot_coordinates,
    plot_energy,
    plot_outputs,
    plot_phase,
    plot_quantities,
    plot_sensitivities,
    plot_speeds,
    plot_states,
)
from pydy.trajectory import Trajectory
from zoo.cases import system_of

plt = optional("matplotlib.pyplot")

TIMES = np.linspace(0.0, 1.0, 21)


@pytest.fixture(autouse=True)
def _no_figures_are_left():
    yield
    plt.close("all")


def simulated(name, **options):
    return system_of(zoo.MODELS[name](), times=TIMES, **options).simulate(rtol=1e-10, atol=1e-10)


def ensemble(*trajectories):
    xarray = pytest.importorskip("xarray")
    sets = [t.to_xarray(derivatives=True, energy=True) for t in trajectories]
    return xarray.concat(sets, "sample", combine_attrs="override")


def labels(ax):
    return [text.get_text() for text in ax.get_legend().get_texts()]


def assert_drawn(ax, columns):
    lines = ax.get_lines()
    assert len(lines) == len(columns)
    for line, column in zip(lines, columns, strict=True):
        np.testing.assert_array_equal(line.get_xdata(), TIMES)
        np.testing.assert_array_equal(line.get_ydata(), column)


def test_coordinates_and_speeds_are_drawn_with_labels_and_units():
    trajectory = simulated("fourbar")
    q1, q2, q3 = trajectory.coordinates_symbols
    ax = plot_coordinates(trajectory, units=dict.fromkeys((q1, q2, q3), "rad"), time_unit="s")
    assert_drawn(ax, trajectory.states[:, :3].T)
    assert labels(ax) == ["$q_{1}$", "$q_{2}$", "$q_{3}$"]
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("time (s)", "coordinates (rad)")
    ax = plot_speeds(trajectory, units={"u1": "rad/s", sm.Symbol("mass"): "kg"})
    assert_drawn(ax, trajectory.states[:, 3:].T)
    assert labels(ax) == ["$u_{1}$ (rad/s)", "$u_{2}$", "$u_{3}$"]
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("time", "speeds")


def test_each_unit_has_an_axis_of_its_own():
    trajectory = simulated("fourbar")
    ax = plot_coordinates(trajectory, units={"q1": "rad", "q2": "m", "q3": "rad"})
    first, second = ax.figure.axes
    assert first is ax
    assert [one.get_ylabel() for one in (first, second)] == ["coordinates (rad)", "coordinates (m)"]
    assert_drawn(first, trajectory.states[:, [0, 2]].T)
    assert_drawn(second, trajectory.states[:, [1]].T)
    assert labels(ax) == ["$q_{1}$ (rad)", "$q_{2}$ (m)", "$q_{3}$ (rad)"]
    lines = [*first.get_lines(), *second.get_lines()]
    assert len({line.get_color() for line in lines}) == 3
    _, (above, _) = plt.subplots(2)
    assert plot_speeds(trajectory, ax=above, units={"u1": "1/s", "u2": "m/s"}) is above
    assert len(above.figure.axes) == 4  # also one for what has no unit


def test_the_axes_of_selected_quantities_are_labelled_with_their_names():
    trajectory = simulated("fourbar")
    units = {"q1": "rad", "q3": "rad", "u2": "1/s", "u1": "m/s"}
    ax = plot_quantities(trajectory, ["q1", "q3", "u2", "u1"], units=units)
    found = [one.get_ylabel() for one in ax.figure.axes]
    assert found == ["$q_{1}$, $q_{3}$ (rad)", "$u_{2}$ (1/s)", "$u_{1}$ (m/s)"]
    assert trajectory.plot(["u1", "q1"]).get_ylabel() == "$u_{1}$, $q_{1}$"
    assert trajectory.plot(["u1", "q1", "q2", "q3"]).get_ylabel() == "values"


@pytest.mark.parametrize("layout", ["constrained", None])
def test_numbers_and_labels_of_further_axes_do_not_overlap(layout):
    system = multi_mass_spring_damper(2)
    system.times, system.initial_conditions = TIMES, {"x0": 7e5, "v1": -3e-5}
    _, ax = plt.subplots(layout=layout)
    units = {"x0": "m", "x1": "mm", "v0": "m/s", "v1": "mm/s"}
    plot_quantities(system.simulate(), [*units], ax=ax, units=units)
    ax.figure.canvas.draw()
    second, third, fourth = (one.yaxis.get_tightbbox() for one in ax.figure.axes[1:])
    assert second.x1 < third.x0 < third.x1 < fourth.x0


def test_derivatives_have_the_units_of_their_quotients():
    trajectory = zoo_with_sensitivities()
    ax = plot_sensitivities(trajectory, "x0", units={"x0": "m", "m0": "kg", "k0": "N/m"})
    assert labels(ax) == ["$m_{0}$ (m/kg)", "$k_{0}$ (m/(N/m))"]
    assert len(ax.figure.axes) == 2
    alone = plot_sensitivities(trajectory, "x0")
    assert len(alone.figure.axes) == 1
    assert alone.get_legend().get_title().get_text() == "derivatives of x0 with respect to"


def zoo_with_sensitivities():
    system = multi_mass_spring_damper()
    system.times, system.initial_conditions = TIMES, {"x0": 1.0}
    return system.simulate(sensitivities=["m0", "k0"])


@pytest.mark.parametrize(
    ("name", "parts", "latex"),
    [
        ("alpha", ["α", ""], r"\alpha"),
        ("theta_1", ["θ", "1"], r"\theta_{1}"),
        ("q1", ["q", "1"], "q_{1}"),
        ("x_foot", ["x", "foot"], "x_{foot}"),
        ("thetadot", ["θ\u0307", ""], r"\dot{\theta}"),
        ("length", ["length", ""], r"\mathrm{length}"),
        ("hand_x", ["hand_x", ""], r"\mathrm{hand\_x}"),
        ("lamda_2", ["λ", "2"], r"\lambda_{2}"),
        ("varphi", ["φ", ""], r"\varphi"),
        ("Fx", ["Fx", ""], "Fx"),
    ],
)
def test_a_symbol_and_its_name_look_alike_on_pages_and_in_plots(name, parts, latex):
    assert label_parts(name) == parts
    assert latex_of(name) == latex_of(sm.Symbol(name)) == latex
    q = sm.Function(name)(sm.Symbol("t"))
    assert latex_of(q) == latex
    trajectory = Trajectory([0, 1], [[1.0], [2.0]], {"coordinate": [q]})
    assert labels(plot_coordinates(trajectory)) == [f"${latex}$"]


def test_some_can_be_chosen_by_symbol_or_name():
    trajectory = simulated("fourbar")
    ax = plot_coordinates(trajectory, [trajectory.coordinates_symbols[2], "q1"])
    assert_drawn(ax, trajectory.states[:, [2, 0]].T)
    assert_drawn(plot_coordinates(trajectory, "q2"), [trajectory["q2"]])
    with pytest.raises(KeyError, match="`nothing` is not one of the trajectory's quantities"):
        plot_coordinates(trajectory, ["nothing"])


def test_axes_that_are_given_are_drawn_into():
    trajectory = simulated("bare")
    _, (above, below) = plt.subplots(2, sharex=True)
    assert plot_coordinates(trajectory, ax=above) is above
    assert plot_speeds(trajectory, ax=below) is below
    assert len(plt.get_fignums()) == 1
    assert above.get_legend() is not None


def test_states_share_the_time_axis():
    trajectory = simulated("disc_contact")
    axes = plot_states(trajectory)
    assert [ax.get_ylabel() for ax in axes] == ["coordinates", "speeds", "auxiliary states"]
    assert [ax.get_xlabel() for ax in axes] == ["", "", "time"]
    axes[0].set_xlim(0.2, 0.4)
    assert axes[2].get_xlim() == (0.2, 0.4)
    with pytest.raises(ValueError, match="`axes` must be 3, one for each of coordinate, speed"):
        plot_states(trajectory, axes=axes[:2])
    with pytest.raises(TypeError, match="`ax` is for one plot, but without `names`"):
        trajectory.plot(ax=axes[0])


def test_outputs_and_forces_are_drawn_without_residuals():
    energy = sm.Symbol("E")
    trajectory = simulated("disc_contact", outputs={energy: zoo.disc_contact().energy})
    ax = plot_outputs(trajectory)
    assert_drawn(ax, [trajectory["E"], trajectory["Fx"], trajectory["Fz"]])


def test_sizes_of_residuals_are_drawn_on_a_logarithmic_scale():
    trajectory = simulated("fourbar")
    ax = plot_constraints(trajectory)
    assert ax.get_yscale() == "log"
    assert_drawn(ax, np.abs(trajectory.constraints).T)
    with pytest.raises(ValueError, match="`result` has no constraints to plot"):
        plot_constraints(simulated("bare"))


def test_energies_are_drawn():
    trajectory = simulated("free_pendulum")
    ax = plot_energy(trajectory, unit="J")
    assert_drawn(ax, trajectory.energy.T)
    assert labels(ax) == ["kinetic", "potential", "total"]
    assert ax.get_ylabel() == "energy (J)"
    ax = plot_energy(trajectory, unit=("kJ", 1e-3))
    assert_drawn(ax, 1e-3 * trajectory.energy.T)
    assert ax.get_ylabel() == "energy (kJ)"


def test_the_phase_is_a_coordinate_and_its_rate():
    trajectory = simulated("disc")
    q2 = trajectory.coordinates_symbols[1]
    ax = plot_phase(trajectory, q2, units={q2: "rad", "q2'": "rad/s"})
    orbit, start = ax.get_lines()
    np.testing.assert_array_equal(orbit.get_xdata(), trajectory[q2])
    np.testing.assert_array_equal(orbit.get_ydata(), trajectory.derivatives[:, 1])
    np.testing.assert_array_equal(start.get_xdata(), trajectory[q2][:1])
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("$q_{2}$ (rad)", r"$\dot{q}_{2}$ (rad/s)")
    orbit, _ = plot_phase(trajectory, "q1", "u3").get_lines()
    np.testing.assert_array_equal(orbit.get_ydata(), trajectory["u3"])
    with pytest.raises(ValueError, match="`y` must be given"):
        plot_phase(trajectory, "c0")


def test_an_ensemble_is_drawn_as_bands():
    model = zoo.free_pendulum()
    runs = [
        simulated("free_pendulum", initial_conditions={**model.start, model.kane.q[1]: a})
        for a in (2.4, 2.5, 2.6, 2.8)
    ]
    few = ensemble(*runs)
    ax = plot_coordinates(few)
    assert_drawn(ax, [column for k in range(4) for column in (run.states[:, k] for run in runs)])
    assert not ax.collections
    assert ax.get_legend().get_title().get_text() == "4 samples"
    assert labels(ax)[1] == "$q_{1}$"
    assert len(ax.get_legend().get_texts()) == 4
    runs = [*runs, *runs, *runs, *runs[1:]]
    dataset = ensemble(*runs)
    ax = plot_coordinates(dataset)
    values = np.array([run.states[:, :4] for run in runs])
    low, middle, high = np.quantile(values, [0.05, 0.5, 0.95], axis=0)
    assert_drawn(ax, middle.T)
    edges = ax.collections[1].get_paths()[0].vertices
    for edge in (low, high):
        for point in zip(TIMES, edge[:, 1], strict=True):
            assert np.isclose(edges, point).all(axis=1).any()
    assert ax.get_legend().get_title().get_text() == "median, 5 to 95 %"
    assert labels(ax)[1] == "$q_{1}$"
    assert len(plot_energy(dataset).collections) == 3
    assert len(plot_states(dataset)) == 2
    assert len(plot_phase(few, "q1").get_lines()) == 5


def test_a_dataset_of_several_sample_dimensions_with_failures():
    xarray = pytest.importorskip("xarray")
    values = np.random.default_rng(0).normal(size=(21, 3, 5))
    values[15:, 1, 2] = np.nan
    values[20] = np.nan
    dataset = xarray.Dataset({"q": (("time", "m", "k"), values)}, {"time": TIMES})
    ax = plot_coordinates(dataset, ["q"])
    middle = ax.get_lines()[0].get_ydata()
    np.testing.assert_allclose(middle[:20], np.nanmedian(values[:20].reshape(20, 15), axis=1))
    assert np.isnan(middle[20])
    assert labels(ax) == ["$q$"]
    with pytest.raises(ValueError, match=r"no variables whose attribute 'role'.*of q"):
        plot_coordinates(dataset)
    with pytest.raises(KeyError, match="`p` is not one of the dataset's variables: q"):
        plot_coordinates(dataset, ["p"])
    with pytest.raises(ValueError, match="kinetic_energy is missing"):
        plot_energy(dataset)
    with pytest.raises(ValueError, match="derivative of `q` is not known"):
        plot_phase(dataset, "q")


def test_a_loaded_trajectory_looks_the_same(tmp_path):
    pytest.importorskip("xarray")
    trajectory = simulated("fourbar")
    trajectory.save(tmp_path / "run.nc")
    loaded = Trajectory.load(tmp_path / "run.nc")
    assert labels(plot_coordinates(loaded)) == labels(plot_coordinates(trajectory))
    phase = plot_phase(loaded, "q1")
    assert phase.get_ylabel() == plot_phase(trajectory, "q1").get_ylabel()


def test_names_that_matplotlib_cannot_set_are_drawn_as_they_are():
    trajectory = Trajectory([0, 1], [[1.0], [2.0]], {"coordinate": [sm.Symbol(r"\odd{x$")]})
    ax = plot_coordinates(trajectory)
    assert labels(ax) == [r"\odd{x\$"]
    ax.figure.canvas.draw()


def test_something_else_is_refused():
    with pytest.raises(TypeError, match=r"`result` must be a Trajectory.*got ndarray"):
        plot_states(np.zeros((3, 2)))


def test_missing_matplotlib_is_named(monkeypatch):
    trajectory = simulated("bare")
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(ImportError, match=r"needs matplotlib.*pip install 'pydy\[plot\]'"):
        plot_coordinates(trajectory)


def test_several_runs_are_compared_by_colour_or_by_line():
    first, second = (simulated("bare", initial_conditions={"q": q}) for q in (0.1, 0.2))
    ax = plot_coordinates({"soft": first, "stiff": second})
    assert labels(ax) == ["soft", "stiff"]
    assert_drawn(ax, [first["q"], second["q"]])
    ax = plot_quantities([first, second], ["q", "u"])
    assert labels(ax) == ["$q$, run 1", "$u$, run 1", "$q$, run 2", "$u$, run 2"]
    a, b, c, _ = ax.get_lines()
    assert a.get_color() == c.get_color() != b.get_color()
    assert (a.get_linestyle(), c.get_linestyle()) == ("-", "--")
    assert labels(plot_energy({"soft": first, "stiff": second}))[3] == "kinetic, stiff"
    assert labels(plot_phase({"soft": first, "stiff": second}, "q")) == ["soft", "stiff"]
    assert len(plot_states([first, second])) == 2


def test_a_run_to_compare_must_be_one():
    with pytest.raises(TypeError, match="a list or dictionary of these, got float"):
        plot_coordinates([simulated("bare"), 5.0])
    with pytest.raises(TypeError, match="a label in `result` must be a string, got 1"):
        plot_coordinates({1: simulated("bare")})


def test_a_unit_with_a_factor_converts_values_rates_and_sensitivities():
    system = multi_mass_spring_damper()
    x0, v0 = system.states
    system.initial_conditions, system.times = {x0: 0.5}, np.linspace(0.0, 1.0, 5)
    system.ode_solver = "dop853"
    motion = system.simulate(sensitivities=["m0"])
    units = {"x0": ("mm", 1000), "x0'": ("mm/s", 1000.0), "m0": ("t", 0.001)}
    (line,) = plot_coordinates(motion, units=units).lines
    np.testing.assert_allclose(line.get_ydata()[0], 500.0)
    ax = plot_phase(motion, x0, units=units)
    np.testing.assert_allclose(ax.lines[0].get_ydata()[-1], 1000.0 * motion[v0][-1])
    assert (ax.get_xlabel(), ax.get_ylabel()[-6:]) == ("$x_{0}$ (mm)", "(mm/s)")
    # One m/kg is a thousand mm by a thousandth of a tonne.
    ax = plot_sensitivities(motion, x0, units=units)
    np.testing.assert_allclose(
        ax.lines[0].get_ydata()[-1], 1e6 * motion.sensitivity["x0", "m0"][-1], rtol=1e-14
    )
    dataset = plot_coordinates(motion.to_xarray(), units=units)
    np.testing.assert_allclose(dataset.lines[0].get_ydata()[0], 500.0)


def test_degrees_of_a_state_need_their_factor():
    system = n_link_pendulum_on_cart(1)
    system.outputs = {sm.Symbol("tilt"): 180 / sm.pi * system.coordinates[1]}
    system.initial_conditions, system.times = {"q1": np.pi / 2}, [0.0, 0.1]
    motion = system.simulate()
    for key, unit in {"q1": "deg", "u1": "deg/s", "q1'": "°/s"}.items():
        message = rf"`units\[{key}\]` is '{unit}'.* pass `\('{unit}', 180/"
        with pytest.raises(ValueError, match=message):
            plot_states(motion, units={key: unit})
    assert plot_outputs(motion, units={"tilt": "deg"}).lines[0].get_ydata()[0] == 90.0
    ax = plot_quantities(motion, ["q1"], units={"q1": ("deg", 180 / np.pi)})
    assert ax.lines[0].get_ydata()[0] == 90.0
    with pytest.raises(ValueError, match=r"`units\[q1\]\[1\]`"):
        plot_quantities(motion, ["q1"], units={"q1": ("deg", "180")})
