"""The tests nearest to a file of src are found for every file, without a list."""

from pathlib import Path

import near
import pytest

FILES = sorted(path for path in near.SOURCE.rglob("*.py") if path.name != "__init__.py")


def chosen(name: str) -> tuple[list[str], list[str]]:
    tests, whole = near.near([near.SOURCE / name])
    return [[test.relative_to(near.TESTS).as_posix() for test in part] for part in (tests, whole)]


@pytest.mark.parametrize(
    ("file", "first"),
    [
        ("_graph/solve/lu.py", "_graph/"),
        ("analysis/orbits.py", "system/test_orbits.py"),
        ("contact/laws.py", "contact/test_laws.py"),
        ("trajectory.py", "test_trajectory.py"),
        ("_cache_folder.py", "test_cache_folder.py"),
        ("solvers/core/advance.c", "solvers/"),
        ("export/templates/integrator.js", "export/"),
    ],
)
def test_the_mirroring_tests_come_first(file, first):
    tests, _ = chosen(file)
    assert tests[0].startswith(first)


def test_all_cases_of_the_mirroring_file_are_tried():
    _, whole = chosen("contact/laws.py")
    assert whole == ["contact/test_laws.py"]


def test_a_loop_in_c_is_tested_by_the_modules_that_name_it():
    assert chosen("solvers/core/step_lanes.c")[0][0] == "ensemble/test_lanes.py"


def test_a_header_is_tested_by_the_loops_that_include_it():
    including = near.compiled([near.SOURCE / "solvers" / "core" / "lanes.h"])
    assert "step_lanes.c" in {file.name for file in including}


def test_every_file_has_near_tests_beside_the_contracts():
    lonely = []
    for file in FILES:
        tests = {test for test in near.near([file])[0] if test.name not in near.CONTRACTS}
        if not tests:
            lonely.append(file.relative_to(near.SOURCE).as_posix())
    assert lonely == ["__main__.py"], "no test is near to them"


def test_recorded_times_of_nine_files_of_ten_fit_into_the_budget():
    slow = []
    for file in FILES:
        tests, whole = near.near([file])
        total = sum(near.seconds(test, test in whole) for test in tests)
        if total > near.BUDGET + 10.0:  # the contracts' own
            slow.append((file.relative_to(near.SOURCE).as_posix(), total))
    assert len(slow) <= len(FILES) // 10, slow


def test_a_file_outside_src_is_refused(capsys, monkeypatch):
    monkeypatch.setattr("sys.argv", ["near.py", str(Path(__file__))])
    with pytest.raises(SystemExit):
        near.main()
    assert "FILE must be a file of src/pydy" in capsys.readouterr().err
