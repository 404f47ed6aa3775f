"""The command line, in process; the demo runs once for all tests."""

import re
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

import pydy
import pydy.examples
from pydy.cli import main
from pydy.examples import bicycle_ride


@pytest.fixture(scope="module")
def demo(tmp_path_factory):
    """The demo's exit code, output, directory, and what the ride found."""
    output = tmp_path_factory.mktemp("demo") / "made" / "on demand"
    rides = []
    honest = bicycle_ride.ride
    with pytest.MonkeyPatch.context() as patch, pytest.MonkeyPatch.context() as capture:
        patch.setattr(pydy.examples, "ride", lambda: rides.append(honest()) or rides[0])
        lines = []
        capture.setattr("builtins.print", lambda *a, **k: lines.append(" ".join(map(str, a))))
        code = main(["demo", "--output", str(output)])
    return code, "\n".join(lines), output, rides[0]


@pytest.fixture
def same_ride(demo, monkeypatch):
    """Let the demo find at once what it found before, but for what is given."""

    def change(**values):
        monkeypatch.setattr(pydy.examples, "ride", lambda: replace(demo[3], **values))

    change()
    return change


def number_after(label, text):
    found = re.search(re.escape(label) + r"\s+(-?[\d.]+(?:e[+-]\d+)?)", text)
    assert found, label
    return float(found[1])


def test_the_demo_succeeds(demo):
    code, text, _, _ = demo
    assert code == 0
    assert text.count(" ok") == 3
    assert "FAILED" not in text


@pytest.mark.parametrize(
    ("label", "value"),
    [
        ("weave, real", -0.775341882195845),
        ("weave, imag. +/-", 4.46486771378823),
        ("capsize", -0.322866429004087),
        ("castering", -14.0783896927982),
    ],
)
def test_the_demo_prints_the_published_eigenvalues_beside_its_own(demo, label, value):
    row = next(line for line in demo[1].splitlines() if line.strip().startswith(label))
    computed, published, difference = map(float, row.replace(label, "").split())
    assert published == value
    assert abs(computed - value) < 1e-9
    assert abs(difference) < 1e-9


def test_the_other_motions_of_the_bicycle_are_neutral(demo):
    assert len(demo[3].other_eigenvalues) == 8
    assert np.abs(demo[3].other_eigenvalues).max() < 1e-6


def test_the_demo_keeps_energy_and_constraints(demo):
    text = demo[1]
    assert number_after("energy drift, relative", text) < 1e-6
    assert number_after("holonomic residual, relative to wheel base", text) < 1e-6
    assert number_after("holonomic residual, largest", text) < 1e-6
    assert number_after("velocity residual, largest", text) < 1e-6


def test_the_static_contact_forces_are_those_of_a_lever(demo):
    # Moments about the rear contact: m_B x_B + m_H x_H + m_F w = N_f w / g.
    front = (85 * 0.3 + 4 * 0.9 + 3 * 1.02) / 1.02 * 9.81
    assert number_after("front wheel, N_f", demo[1]) == pytest.approx(front, abs=1e-3)
    assert number_after("both (the weight)", demo[1]) == pytest.approx(94 * 9.81, abs=1e-3)


def test_the_push_leans_the_bicycle_and_it_recovers(demo):
    ride = demo[3]
    assert ride.force.max() == pytest.approx(bicycle_ride.PUSH)
    before, after = ride.times < bicycle_ride.PUSH_START, ride.times > bicycle_ride.PUSH_END
    assert np.abs(ride.roll[after]).max() > 1.5 * np.abs(ride.roll[before]).max()
    assert np.abs(ride.roll[-100:]).max() < 0.4 * np.abs(ride.roll).max()


def test_the_demo_prints_the_time_of_each_stage(demo):
    stages = ("derive", "extract", "generate", "initial conditions", "simulate", "linearise")
    seconds = [number_after(f"\n  {stage}", demo[1]) for stage in stages]
    assert sum(seconds) <= number_after("\n  total", demo[1]) + 0.01


def test_the_demo_saves_its_plot_and_says_where(demo):
    _, text, output, _ = demo
    path = output / "bicycle.png"
    assert str(path) in text
    assert path.read_bytes().startswith(b"\x89PNG")


def test_the_demo_saves_its_animation_and_says_where(demo):
    _, text, output, ride = demo
    path = output / "bicycle.html"
    assert str(path) in text
    assert path.read_text(encoding="utf-8") == ride.scene.html()


def test_the_demo_ends_with_a_page_that_simulates(demo):
    _, text, output, _ = demo
    path = output / "bicycle-live.html"
    assert text.rindex(str(path)) > text.rindex("bicycle.html")
    assert "liveModel" in path.read_text(encoding="utf-8")
    assert {p.name for p in output.iterdir()} == {"bicycle.png", "bicycle.html", path.name}


def test_the_output_is_ascii_for_any_terminal(demo):
    assert demo[1].replace(str(demo[2]), "").isascii()


def test_no_plot_makes_no_directory(same_ride, tmp_path, capsys):
    assert main(["demo", "--no-plot", "--output", str(tmp_path / "new")]) == 0
    assert not (tmp_path / "new").exists()
    assert "Plot" not in capsys.readouterr().out


def test_without_matplotlib_the_demo_goes_on_and_says_what_to_install(
    same_ride, tmp_path, monkeypatch, capsys
):
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    assert main(["demo", "--output", str(tmp_path)]) == 0
    assert "pip install matplotlib" in capsys.readouterr().out
    assert {p.name for p in tmp_path.iterdir()} == {"bicycle.html", "bicycle-live.html"}


def test_a_plot_that_cannot_be_saved_is_reported(same_ride, tmp_path, capsys):
    (tmp_path / "bicycle.png").mkdir()
    assert main(["demo", "--output", str(tmp_path)]) == 1
    assert "cannot save the plot: " in capsys.readouterr().err


def test_an_animation_that_cannot_be_saved_is_reported(same_ride, tmp_path, capsys):
    (tmp_path / "bicycle.html").mkdir()
    assert main(["demo", "--output", str(tmp_path)]) == 1
    assert "cannot save the page: " in capsys.readouterr().err


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"energy_drift": 2e-6}, "energy drift is 2e-06, must be below 1e-06"),
        ({"energy_drift": float("nan")}, "energy drift is nan, must be below 1e-06"),
        ({"drift_off_ground": 1e-3}, "holonomic residual is 0.001, must be below 1e-06"),
        ({"eigenvalues": np.zeros(4)}, "eigenvalues' difference is 14.1 1/s, must be below 1e-09"),
    ],
)
def test_a_broken_promise_fails_the_demo_with_a_message(same_ride, capsys, changes, message):
    same_ride(**changes)
    assert main(["demo", "--no-plot"]) == 1
    out, err = capsys.readouterr()
    assert message in err
    assert "FAILED" in out


def test_an_output_that_is_a_file_is_refused_before_the_work(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(pydy.examples, "ride", lambda: pytest.fail("the demo should not start"))
    (tmp_path / "file").write_text("")
    with pytest.raises(SystemExit) as stop:
        main(["demo", "--output", str(tmp_path / "file")])
    assert stop.value.code == 2
    assert "argument --output: cannot make the directory" in capsys.readouterr().err


def test_run_prints_the_coordinates_of_a_pendulum(capsys):
    arguments = ["run", "pendulum", "--links", "3", "--duration", "0.5", "--points", "2"]
    assert main(arguments) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "pendulum: 8 states, 0.5 s, every constant 1 but g = 9.81"
    assert " ".join(lines[2].split()) == "t [s] q0 [m] q1 [rad] q2 [rad] q3 [rad]"
    assert lines[3].split() == ["0.0000", "0.000000", "0.500000", "0.500000", "0.500000"]
    assert lines[4].split()[0] == "0.5000"
    assert len(lines) == 5


def test_run_hangs_a_mass_on_a_spring(capsys):
    # x'' + x' + x = g from rest, in closed form.
    assert main(["run", "springs", "--masses", "1", "--duration", "2", "--points", "3"]) == 0
    rows = [line.split() for line in capsys.readouterr().out.splitlines()[3:]]
    t, x = np.array(rows, dtype=float).T
    w = np.sqrt(0.75)
    exact = 9.81 * (1 - np.exp(-t / 2) * (np.cos(w * t) + np.sin(w * t) / (2 * w)))
    np.testing.assert_allclose(x, exact, atol=1e-6)


def test_run_that_fails_says_why_prints_no_numbers_and_exits_with_1(capsys):
    assert main(["run", "pendulum", "--duration", "1e6", "--points", "3"]) == 1
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("python -m pydy run: `dop853` took 1000000 steps")
    assert err.count("\n") == 1


def test_run_with_few_points_prints_what_it_prints_with_many(capsys):
    last = []
    for points in ("2", "51"):
        assert main(["run", "pendulum", "--links", "3", "--duration", "4", "--points", points]) == 0
        last.append(capsys.readouterr().out.splitlines()[-1].split())
    np.testing.assert_allclose(*np.array(last, dtype=float), atol=2e-6)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], "the following arguments are required: COMMAND"),
        (["fly"], "invalid choice: 'fly'"),
        (["run"], "the following arguments are required: MODEL"),
        (["run", "pendulum", "--links", "0"], "must be a whole number from 1 to 1000, got '0'"),
        (["run", "springs", "--masses", "x"], "must be a whole number from 1 to 1000, got 'x'"),
        (["run", "springs", "--points", "1"], "must be a whole number from 2 to 1000000, got '1'"),
        (["run", "springs", "--duration", "-1"], "must be a positive number of seconds, got '-1'"),
        (["run", "springs", "--duration", "inf"], "must be a positive number of seconds"),
        (["run", "springs", "--duration", "long"], "positive number of seconds, got 'long'"),
        (["run", "springs", "--links", "2"], "unrecognized arguments: --links 2"),
    ],
)
def test_wrong_arguments_are_refused(capsys, arguments, message):
    with pytest.raises(SystemExit) as stop:
        main(arguments)
    assert stop.value.code == 2
    assert message in capsys.readouterr().err


def test_help_and_version_load_nothing_heavy():
    code = (
        "import sys; from pydy.cli import main\n"
        "try: main(['--version'])\n"
        "finally: assert not {'sympy', 'numpy'} & set(sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == f"pydy {pydy.__version__}\n"


def test_the_module_runs_as_a_program():
    command = [sys.executable, "-m", "pydy", "demo", "--help"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout.startswith("usage: python -m pydy demo")


def test_a_reader_that_goes_away_ends_run_without_a_traceback():
    command = [sys.executable, "-m", "pydy", "run", "springs", "--points", "100000"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        process.stdout.readline()
        process.stdout.close()
        assert process.stderr.read() == b""
    assert process.returncode == 1
