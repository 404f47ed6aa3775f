"""Models are derived once in a session, and anew when what they are derived from changes."""

import sys
from types import ModuleType

import pytest
import sympy as sm

import derivations


@pytest.fixture
def module(tmp_path, monkeypatch):
    """A module of models, and the function that loads it as another process would."""
    monkeypatch.setenv("PYDY_CACHE_DIR", str(tmp_path))
    file = tmp_path / "some_models.py"
    text = "derived = []\ndef spring(n=1):\n    derived.append(n)\n    return sm.Symbol('k') * n\n"

    def load(text=text):
        file.write_text(text)
        derivations.sources.cache_clear()
        made = ModuleType("some_models")
        made.__file__, made.sm = str(file), sm
        monkeypatch.setitem(sys.modules, "some_models", made)
        exec(text, vars(made))
        made.spring = derivations.derived_once(made.spring)
        return made

    return load


def test_another_process_reads_what_the_first_one_has_derived(module):
    first, second = module(), None
    assert first.spring() is first.spring()
    assert first.derived == [1]
    second = module()
    assert second.spring() == sm.Symbol("k")
    assert second.derived == []


def test_arguments_and_sources_tell_models_apart(module):
    assert module().spring(2) == 2 * sm.Symbol("k")
    assert module().spring(3) == 3 * sm.Symbol("k")
    changed = module("derived = []\ndef spring(n=1):\n    return sm.Symbol('c') * n\n")
    assert changed.spring(2) == 2 * sm.Symbol("c")


def test_another_version_of_sympy_derives_anew(module, monkeypatch):
    module().spring()
    monkeypatch.setattr(sm, "__version__", "9.9")
    again = module()
    again.spring()
    assert again.derived == [1]


def test_a_fresh_copy_can_be_changed(module):
    models = module()
    assert models.spring.__wrapped__() is not None
    assert models.spring() is models.spring()
