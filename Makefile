# `make demo` and `make test` work on a fresh clone with Python >= 3.11, pip, make and a C compiler.
# pip's own configuration decides where packages come from.

PYTHON ?= python3
JOBS ?= 2
VENV := .venv
PY := $(VENV)/bin/python
PIP_INSTALL := -m pip install --quiet --disable-pip-version-check
# The released PyDy that benchmarks compare with; it needs an environment of its own.
REFERENCE := .venv-reference
REFERENCE_PY := $(REFERENCE)/bin/python
# heyoka, CasADi, JAX and diffsol, whose generated code and solvers are compared with ours.
PEERS := .venv-peers
PEERS_PY := $(PEERS)/bin/python

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.PHONY: help demo test bench bench-peers bench-solvers clean

help:
	@echo "make demo   install into $(VENV), run the bicycle demo, plot it into build/"
	@echo "make test   lint, format check, types, tests and doctests"
	@echo "make bench  ratios against the released pydy 0.9.4"
	@echo "make bench-peers  ratios against heyoka, CasADi and JAX; operation counts"
	@echo "make bench-solvers  solvers against other packages', at equal error, and against odeint"
	@echo "make clean  remove the environments and caches"

demo: $(VENV)/.installed-plot
	$(PY) -m pydy demo

test: $(VENV)/.installed-test
	$(PY) -m ruff check
	$(PY) -m ruff format --check
	$(PY) -m mypy src
	$(PY) -m pytest -n $(JOBS)

bench: $(VENV)/.installed-test $(REFERENCE)/.installed
	$(PY) benchmarks/run.py --reference $(REFERENCE_PY)
	$(PY) benchmarks/imports.py

bench-peers: $(VENV)/.installed-test $(PEERS)/.installed
	$(PY) benchmarks/operations.py
	$(PY) benchmarks/peers.py --peer-python $(PEERS_PY)

bench-solvers: $(VENV)/.installed-test $(PEERS)/.installed $(REFERENCE)/.installed
	$(PY) benchmarks/solvers.py --peer-python $(PEERS_PY) --reference $(REFERENCE_PY)

clean:
	rm -rf $(VENV) $(REFERENCE) $(PEERS) build .mypy_cache .pytest_cache .ruff_cache .hypothesis

# A stamp for each extra, older than pyproject.toml when the dependencies may have changed.
$(VENV)/.installed-%: pyproject.toml | $(PY)
	$(PY) $(PIP_INSTALL) --editable '.[$*]'
	@touch $@

$(REFERENCE)/.installed: | $(REFERENCE_PY)
	$(REFERENCE_PY) $(PIP_INSTALL) 'pydy==0.9.4' Cython setuptools
	@touch $@

$(PEERS)/.installed: benchmarks/requirements.txt | $(PEERS_PY)
	$(PEERS_PY) $(PIP_INSTALL) --requirement benchmarks/requirements.txt
	@touch $@

$(PY) $(REFERENCE_PY) $(PEERS_PY): %/bin/python:
	@$(PYTHON) -c 'import sys; v = sys.version.split()[0]; sys.version_info >= (3, 11) or sys.exit("pydy needs Python 3.11 or newer, $(PYTHON) is " + v + "; try make PYTHON=python3.12")'
	$(PYTHON) -m venv $*
