"""Results of benchmarks say on which processor they were taken."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))

import beside
from harness import report


def test_results_hold_the_processors_name_features_and_caches(tmp_path, monkeypatch):
    monkeypatch.setattr(report, "BUILD", tmp_path)
    monkeypatch.setenv("PYDY_CPU", "x86-64-v3")
    about = json.loads(report.save("any", [1]).read_text())["about"]
    assert about["target"] == "x86-64-v3"
    assert about["processor"]["name"]
    assert isinstance(about["processor"]["features"], list)
    assert isinstance(about["processor"]["caches"], dict)


def about(features, target="native"):
    return {"processor": {"name": "Some", "features": features}, "target": target}


@pytest.mark.parametrize(
    ("features", "target", "vectors"),
    [
        (["avx", "avx2", "avx512vl", "fma"], "native", "AVX-512"),
        (["avx", "avx2", "avx512vl", "fma"], "x86-64-v3", "AVX2"),
        (["avx", "avx2", "fma"], "native", "AVX2"),
        (["asimd"], "native", "NEON"),
        (["avx2"], "generic", "generic"),
    ],
)
def test_columns_are_named_by_processor_and_vectors(features, target, vectors):
    assert report.label(about(features, target)) == f"Some, {vectors}"


def test_results_of_other_targets_and_machines_are_kept_beside(tmp_path, monkeypatch):
    monkeypatch.setattr(report, "BUILD", tmp_path)
    monkeypatch.delenv("PYDY_CPU", raising=False)
    report.save("any", "here")
    report.save("any", "here again")
    monkeypatch.setenv("PYDY_CPU", "generic")
    report.save("any", "generic")
    monkeypatch.delenv("PYDY_CPU")
    monkeypatch.setattr(report, "processor", lambda: {"name": "other", "features": []})
    report.save("any", "there")
    found = {results for _, results in report.read_beside("any", tmp_path)}
    assert found == {"here again", "generic", "there"}


def test_results_side_by_side_have_a_column_for_each_processor(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(report, "BUILD", tmp_path)
    line = {"model": "a", "kind": "scalar", "seconds": {"ours": [1.0], "x": [4.0], "y": [2.0]}}
    report.save("peers", [line])
    monkeypatch.setattr(report, "processor", lambda: {"name": "other", "features": ["avx2"]})
    line["seconds"]["ours"] = [3.0]
    report.save("peers", [line])
    monkeypatch.setattr(sys, "argv", ["beside.py", "--folder", str(tmp_path)])
    beside.main()
    printed = capsys.readouterr().out
    assert "other, AVX2" in printed
    assert re.search(r"scalar, a +1\.50 +0\.50", printed)


def test_every_script_writes_its_results_with_where_they_were_taken():
    for script in (Path(__file__).parents[1] / "benchmarks").glob("*.py"):
        assert not re.search(r"json\.dump\(|\.write_text\(", script.read_text(encoding="utf-8")), (
            script
        )


def test_scripts_call_what_there_is():
    """They measure internals, too, and nobody runs them for months."""
    folder = Path(__file__).parents[1] / "benchmarks"
    scripts = [*folder.glob("*.py"), *folder.glob("workers/*ours*.py")]
    options = [
        "--ignore-missing-imports", "--follow-imports=silent", "--explicit-package-bases",
        "--cache-dir", str(folder.parent / ".mypy_cache" / "benchmarks"),
        "--config-file", os.devnull,
    ]  # fmt: skip
    found = subprocess.run(
        [sys.executable, "-m", "mypy", *options, *map(str, scripts)],
        cwd=folder, env=os.environ | {"MYPYPATH": f"{folder.parent / 'src'}:{folder}"},
        check=False, capture_output=True, text=True,
    )  # fmt: skip
    assert "source files" in found.stdout, found
    wrong = re.findall(r".*\[(?:attr-defined|call-arg|import-not-found)\]", found.stdout)
    assert not wrong


def test_caches_are_told_by_level_and_kind(tmp_path):
    for k, (level, kind, size) in enumerate([("1", "Data", "32K"), ("2", "Unified", "1024K")]):
        place = tmp_path / f"index{k}"
        place.mkdir()
        for name, value in (("level", level), ("type", kind), ("size", size)):
            (place / name).write_text(value + "\n")
    assert report._caches(tmp_path) == {"L1 Data": "32K", "L2 Unified": "1024K"}


def test_caches_that_nobody_tells_are_none(tmp_path):
    assert report._caches(tmp_path / "nothing") == {}
