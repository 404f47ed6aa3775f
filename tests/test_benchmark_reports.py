"""Results of benchmarks say on which processor they were taken."""

from __future__ import annotations

import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))

from harness import report


def test_results_hold_the_processors_name_features_and_caches(tmp_path, monkeypatch):
    monkeypatch.setattr(report, "BUILD", tmp_path)
    monkeypatch.setenv("PYDY_CPU", "x86-64-v3")
    about = json.loads(report.save("any", [1]).read_text())["about"]
    assert about["target"] == "x86-64-v3"
    assert about["processor"]["name"]
    assert isinstance(about["processor"]["features"], list)
    assert isinstance(about["processor"]["caches"], dict)


def test_caches_are_told_by_level_and_kind(tmp_path):
    for k, (level, kind, size) in enumerate([("1", "Data", "32K"), ("2", "Unified", "1024K")]):
        place = tmp_path / f"index{k}"
        place.mkdir()
        for name, value in (("level", level), ("type", kind), ("size", size)):
            (place / name).write_text(value + "\n")
    assert report._caches(tmp_path) == {"L1 Data": "32K", "L2 Unified": "1024K"}


def test_caches_that_nobody_tells_are_none(tmp_path):
    assert report._caches(tmp_path / "nothing") == {}
