"""Names that are no identifiers, and the errors of `System.export`."""

import numpy as np
import pytest
import sympy as sm

from pydy.export.model import identifiers
from pydy.inputs import SampledInput
from zoo.exported_models import hostile, pendulum


def test_greek_letters_and_other_signs_become_words():
    names = ["θ_1", "∫ N_r dt", "Δx", "φ₁", "der(F)", "q'"]
    assert identifiers(names) == [
        "theta_1",
        "integral_N_r_dt",
        "Deltax",
        "phi1",
        "der_F",
        "q_prime",
    ]


def test_no_identifier_is_given_twice_or_means_something_else():
    names = ["q+1", "q-1", "m", "M", "lambda", "double", "function", "1x", "", "__init__", "日本"]
    found = identifiers(names)
    assert len(set(found)) == len(names)
    assert found[:4] == ["q_1", "q_1_2", "m", "M"]
    assert not {"lambda", "double", "function"} & set(found)
    assert all(name.isidentifier() and name.isascii() for name in found)


def test_a_name_that_is_an_identifier_keeps_it_whatever_others_are_spelled_like():
    assert identifiers(["θ", "theta", "m", "_m", "lambda", "lambda_"]) == [
        *("theta_2", "theta", "m", "m_2"),
        *("lambda__2", "lambda_"),
    ]


def test_an_input_begins_with_its_sample_at_the_first_time(tmp_path):
    system = pendulum()
    system.specifieds = {"F": SampledInput([0.0, 2.0, 3.0], [5.0, 7.0, 8.0])}
    system.times = [2.5, 3.0]
    system.export(tmp_path / "pendulum.py", inputs=["F"])
    assert "'F': 7.5" in (tmp_path / "pendulum.py").read_text()


def test_what_was_renamed_is_listed(tmp_path):
    system = hostile()
    exported = system.export(tmp_path / "mass.py")
    symbols = [system.coordinates[0].name, *map(str, system.constants_symbols)]
    assert set(exported.names) == {" ".join(name.split()) for name in symbols}
    assert exported.files == (tmp_path / "mass.py",)


def test_the_suffix_must_be_one_of_four(tmp_path):
    with pytest.raises(ValueError, match=r"`path` must have one of the suffixes \.c, \.fmu, \.js"):
        pendulum().export(tmp_path / "pendulum.cpp")


def test_an_option_of_another_kind_is_refused(tmp_path):
    with pytest.raises(
        TypeError, match=r"export\(\) to \.c has no option `fmi`. It is one of \.fmu"
    ):
        pendulum().export(tmp_path / "pendulum.c", fmi="2.0")
    with pytest.raises(TypeError, match=r"no option `tarket`. Did you mean `target`"):
        pendulum().export(tmp_path / "pendulum.py", tarket="jax")


@pytest.mark.parametrize(
    ("value", "what"),
    [(lambda x, t: t, "a Python function"), (SampledInput([0.0, 2.0], [0.0, 1.0]), "samples")],
)
def test_a_specified_that_only_python_can_compute_is_named(tmp_path, value, what):
    system = pendulum()
    system.specifieds = {"F": value}
    with pytest.raises(ValueError, match=rf"`specifieds` gives `F\(t\)` by {what}, which cannot"):
        system.export(tmp_path / "pendulum.py")
    system.export(tmp_path / "pendulum.py", inputs=["F"])
    assert "'F': 0.0" in (tmp_path / "pendulum.py").read_text()


@pytest.mark.parametrize("name", ["pendulum.py", "pendulum.c", "pendulum.js", "pendulum.fmu"])
def test_an_input_that_an_expression_gives_is_refused(tmp_path, name):
    system = pendulum()
    system.specifieds = {"F": sm.sin(3 * sm.Symbol("t"))}
    with pytest.raises(ValueError, match=r"`inputs` has F\(t\), given by a SymPy expression"):
        system.export(tmp_path / name, inputs=["F"])


def test_an_expression_becomes_part_of_the_equations(tmp_path):
    system = pendulum()
    system.specifieds = {"F": sm.sin(3 * sm.Symbol("t"))}
    system.export(tmp_path / "pendulum.py")
    names: dict[str, object] = {}
    exec((tmp_path / "pendulum.py").read_text(), names)
    assert names["INPUTS"] == {}
    x = np.linspace(0.1, 0.6, 6)
    assert names["rates"](0.4, x) == pytest.approx(system.evaluate_ode(x, t=0.4), rel=1e-13)
