"""Tire property files: sections, units, versions, sides, tables, comments, encodings."""

import re
from importlib.resources import files

import numpy as np
import pytest

from pydy.errors import PyDyUserWarning, TireFileError
from pydy.vehicles import MagicFormula, read_tir
from zoo.tires import TABLE_A31

SMALL = """
[MODEL]
FITTYP = 61
[DIMENSION]
UNLOADED_RADIUS = 0.3
"""


@pytest.fixture
def written(tmp_path):
    def write(text, name="car.tir", encoding="utf-8"):
        path = tmp_path / name
        path.write_bytes(text.encode(encoding))
        return path

    return write


def test_the_packages_file_has_the_published_numbers():
    file = read_tir(files("pydy.examples") / "passenger_car.tir")
    assert (file.version, file.side, file.use_mode) == ("6.1", "left", 4)
    assert {k: file.coefficients[k] for k in TABLE_A31} == TABLE_A31
    assert file.coefficients["MASS"] == 9.3
    assert repr(file).endswith(f"Magic Formula 6.1, {len(file.coefficients)} numbers>")
    tire = MagicFormula(file)
    assert tire.forces(4000, 0.1, 0.1) == MagicFormula(TABLE_A31).forces(4000, 0.1, 0.1)


def test_units_are_converted(written):
    file = read_tir(
        written("""
[UNITS]
LENGTH = 'mm'
FORCE = 'kN'
ANGLE = 'degrees'
MASS = 'gram'
TIME = 'ms'
[MODEL]
FITTYP = 61
LONGVL = 16.7
[DIMENSION]
UNLOADED_RADIUS = 313
[OPERATING_CONDITIONS]
NOMPRES = 0.00022
[INERTIA]
MASS = 9300
IYY = 8e8
[VERTICAL]
FNOMIN = 4
VERTICAL_STIFFNESS = 0.2
VERTICAL_DAMPING = 0.05
YAW_STIFFNESS = 7
FREQ_LONG = 0.08
[SLIP_ANGLE_RANGE]
ALPMAX = 90
[LATERAL_COEFFICIENTS]
PKY3 = 0.4
[SHAPE]
{pen fz}
1 2
""")
    )
    expected = {
        "LONGVL": 16.7, "UNLOADED_RADIUS": 0.313, "NOMPRES": 2.2e5, "MASS": 9.3, "IYY": 0.8,
        "FNOMIN": 4000.0, "VERTICAL_STIFFNESS": 2e5, "VERTICAL_DAMPING": 50.0,
        "YAW_STIFFNESS": 7 * 180 / np.pi,  # kN mm = N m, for each degree
        "FREQ_LONG": 80.0, "ALPMAX": np.pi / 2, "PKY3": 0.4,
    }  # fmt: skip
    assert {k: file.coefficients[k] for k in expected} == pytest.approx(expected, rel=1e-14)
    assert file.sections["DIMENSION"]["UNLOADED_RADIUS"] == 313.0
    assert {k: v.item() for k, v in file.tables["SHAPE"].items()} == pytest.approx(
        {"pen": 0.001, "fz": 2000.0}
    )


def test_a_unit_of_pressure_is_read_where_there_is_one(written):
    text = "[UNITS]\nLENGTH = 'mm'\nPRESSURE = 'bar'\n[OPERATING_CONDITIONS]\nNOMPRES = 2.2\n"
    assert read_tir(written(text)).coefficients["NOMPRES"] == pytest.approx(2.2e5)


@pytest.mark.parametrize(
    ("model", "version"),
    [
        ("FITTYP = 5", "5.2"),
        ("FITTYP = 6", "5.2"),
        ("FITTYP = 21", "5.2"),
        ("FITTYP = 60", "6.1"),
        ("FITTYP = 51\nPCY1 = 1.2", None),  # of motorcycles
        ("FITTYP = 52\nPCY1 = 1.2", None),
        ("FITTYP = 63\nPCY1 = 1.2\nPKY6 = 1", None),  # not known here
        ("PROPERTY_FILE_FORMAT = 'MF-MCTyre'", None),
        ("FITTYP = 61", "6.1"),
        ("FITTYP = 62", "6.2"),
        ("PROPERTY_FILE_FORMAT = 'PAC2002'", "PAC2002"),
        ("PROPERTY_FILE_FORMAT = 'MF_05'", "5.2"),
        ("PROPERTY_FILE_FORMAT = 'PAC_MC'", None),
        ("PROPERTY_FILE_FORMAT = 'FIALA'", None),
        ("PROPERTY_FILE_FORMAT = 'USER'\nFITTYP = 61.0", "6.1"),
        ("PCY1 = 1.2", "5.2"),
        ("PCY1 = 1.2\nPKY6 = 1", "6.1"),
    ],
)
def test_versions_are_recognised(written, model, version):
    assert read_tir(written(f"[MODEL]\n{model}\n")).version == version


def test_a_file_for_another_model_needs_a_version(written):
    file = read_tir(written("[MODEL]\nPROPERTY_FILE_FORMAT = 'FIALA'\n"))
    with pytest.raises(ValueError, match="is for another tire model"):
        MagicFormula(file)


def test_a_tire_of_a_motorcycle_is_named(written):
    file = read_tir(written("[MODEL]\nFITTYP = 52\n[LATERAL]\nPCY1 = 1.2\n"))
    with pytest.raises(ValueError, match=r"another tire model \(FITTYP = 52, MF-MCTyre 1.1\)"):
        MagicFormula(file)


def test_a_negative_use_mode_mirrors_the_tire(written):
    text = (files("pydy.examples") / "passenger_car.tir").read_text()
    usual, other = (
        MagicFormula(read_tir(written(text.replace("USE_MODE = 4", f"USE_MODE = {mode}"))))
        for mode in (14, -14)
    )
    assert (usual.mirrored, other.mirrored, other.use_mode) == (False, True, 14)
    here, there = usual.forces(4000, 0.05, 0.04, 0.02), other.forces(4000, 0.05, -0.04, -0.02)
    assert there == pytest.approx((here.Fx, -here.Fy, -here.Mx, here.My, -here.Mz))
    twice = text.replace("USE_MODE = 4", "USE_MODE = -4")
    assert not MagicFormula(read_tir(written(twice)), side="right").mirrored


def test_the_scaling_of_the_camber_moment_has_two_spellings(written):
    file = read_tir(written(SMALL + "[SCALING]\nLKZG = 0.7\nLCZ = 1.1\n"))
    assert (file.coefficients["LKZC"], file.coefficients["LCZ"]) == (0.7, 1.1)


def test_comments_quotes_and_spellings_are_read(written):
    file = read_tir(
        written(
            """$ A file with "quotes" in comments
! it's here, too
[MDI_HEADER]
FILE_TYPE     =  'tir'
(COMMENTS)
{comment_string}
'written by hand: x = [1]'
[MODEL]
fittyp = 61 ! a number
TYRESIDE = "Right" $ mounted 5" lower
EMPTY =
LFZ0 = 0.9
[SHAPE]
1.0, 0.0
0.9  1.0
[LATERAL_COEFFICIENTS]
PKY1 = -2.1D+01
PDY1 = +.98
"""
        )
    )
    assert file.side == "right"
    assert file.coefficients == {"FITTYP": 61.0, "LFZO": 0.9, "PKY1": -21.0, "PDY1": 0.98}
    assert file.tables["SHAPE"]["1"].tolist() == [0.0, 1.0]


def test_files_in_latin_1_are_read(written):
    path = written("! Größe\n" + SMALL, encoding="latin-1")
    assert read_tir(path).coefficients["UNLOADED_RADIUS"] == 0.3


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("[MODEL\n", "car.tir, line 1: the name of a section has no end"),
        ("[MODEL]\nPDX1 1.2\n", "line 2: 'PDX1 1.2' is neither a section"),
        ("[MODEL]\nPDX1 = 1.2 3.4\n", "line 2: PDX1 must be a number or a word"),
        ("[UNITS]\nLENGTH = 'ell'\n", "LENGTH has the unit 'ell', not one of meter"),
        ("[SHAPE]\n1 2\n3\n", r"the table of \[SHAPE\] has rows of \[1, 2\] numbers"),
    ],
)
def test_what_is_no_such_file_is_refused_with_the_line(written, text, message):
    with pytest.raises(TireFileError, match=message):
        read_tir(written(text))


def test_a_value_that_is_given_twice_is_told(written):
    path = written(SMALL + "[VERTICAL]\nUNLOADED_RADIUS = 0.31\n")
    with pytest.warns(PyDyUserWarning, match="several values of UNLOADED_RADIUS"):
        file = read_tir(path)
    assert file.coefficients["UNLOADED_RADIUS"] == 0.31


def test_the_side_of_the_vehicle_mirrors_a_tire(written):
    text = (files("pydy.examples") / "passenger_car.tir").read_text()
    left, right = (MagicFormula(read_tir(written(text)), side=s) for s in ("left", "right"))
    assert (left.mirrored, right.mirrored) == (False, True)
    turned = written(text.replace("'LEFT'", "'RIGHT'"))
    assert MagicFormula(read_tir(turned), side="left").mirrored
    assert "right side, mirrored" in repr(right)


def test_a_friction_ellipse_that_a_file_asks_for_is_taken(written):
    text = (files("pydy.examples") / "passenger_car.tir").read_text()
    text = re.sub(r"^R[^\n]*\n", "", text, flags=re.MULTILINE)
    with pytest.raises(ValueError, match="no coefficients of the combined longitudinal force"):
        MagicFormula(read_tir(written(text)))
    asked = text.replace("USE_MODE", "FE_METHOD = 'YES'\nUSE_MODE")
    assert MagicFormula(read_tir(written(asked))).combined == "ellipse"


def test_turn_slip_of_a_use_mode_is_left_away(written):
    text = (files("pydy.examples") / "passenger_car.tir").read_text()
    file = read_tir(written(text.replace("USE_MODE = 4", "USE_MODE = 115")))
    assert MagicFormula(file).use_mode == 114
    file = read_tir(written(text.replace("USE_MODE = 4", "USE_MODE = 8")))
    with pytest.raises(ValueError, match="unknown use mode 8"):
        MagicFormula(file)


def test_coefficients_of_another_version_are_listed(written):
    text = (files("pydy.examples") / "passenger_car.tir").read_text()
    old = MagicFormula(read_tir(written(text)), "5.2")
    assert set(old.unused) == {"PKY4", "PKY5", "PKY6", "PKY7", "RBX3", "RBY4"}
