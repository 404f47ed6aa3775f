# `make demo` and `make test` work on a fresh clone with Python >= 3.11, pip, make and a C compiler.
# pip's own configuration decides where packages come from.

PYTHON ?= python3
JOBS ?= 2
# Neighbouring tests stay in one process, which derives their models once.
PYTEST_JOBS := -n $(JOBS) --dist worksteal
VENV := .venv
PY := $(VENV)/bin/python
PIP_INSTALL := -m pip install --quiet --disable-pip-version-check
# The released PyDy that benchmarks compare with; it needs an environment of its own.
REFERENCE := .venv-reference
REFERENCE_PY := $(REFERENCE)/bin/python
# heyoka, CasADi, JAX, Pinocchio, MuJoCo and diffsol, which are compared with ours.
PEERS := .venv-peers
PEERS_PY := $(PEERS)/bin/python
# adam-robotics, which needs an older JAX than the others.
ADAM := .venv-adam
ADAM_PY := $(ADAM)/bin/python

# Processes that tests start read what is compiled already, as users' do, whatever the surroundings
# say: compiling is a third of what it takes to import the package.
export PYTHONDONTWRITEBYTECODE :=

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.PHONY: help demo test test-near test-slow test-whole times test-browser test-fuzz test-mechanisms test-mutations test-lowest test-newest test-pyright test-arm64 test-undefined docs bench bench-analysis bench-calls bench-control bench-million bench-pages bench-peers bench-solvers bench-states solvers-ir three clean

help:
	@echo "make demo   install into $(VENV), run the bicycle demo, plot and animate it into build/"
	@echo "make test   lint, format check, types, tests and doctests"
	@echo "make test-near FILE=src/pydy/…  in under a minute: the tests nearest to one file, and the contracts"
	@echo "make test-slow  two of the 48 parts of the slow tests, of which make test tries one"
	@echo "make test-whole  all tests, with every slow case"
	@echo "make times  all tests; writes how long the slow ones take into tests/slow.txt"
	@echo "make test-browser  open the animation pages in Chromium and check them"
	@echo "make test-fuzz  every public argument with every bad value; make test tries a part of them"
	@echo "make test-mechanisms SEEDS=0:600  random mechanisms against an oracle; failures shrink to a script"
	@echo "make test-mutations  random changes of the source that the tests should notice"
	@echo "make test-lowest  a selection of tests on the oldest Python and packages supported"
	@echo "make test-newest  the same on the newest Python that is here"
	@echo "make test-pyright  the types as pyright reads them (needs npm and a network)"
	@echo "make test-arm64  bits and a part of the tests on AArch64 under emulation (needs apt-get)"
	@echo "make test-undefined  tests of solvers, in a process that ends where their C is undefined"
	@echo "make docs   build the documentation into build/docs; a warning is an error"
	@echo "make bench  ratios against the released pydy 0.9.4"
	@echo "make bench-peers  ratios against heyoka, CasADi, JAX and Pinocchio; operation counts; trees"
	@echo "make bench-control  optimal control and identification against opty and CasADi"
	@echo "make bench-pages  pages that simulate: times real time, and how long a drag takes"
	@echo "make bench-analysis  Jacobians over their functions; linear models, trims and fits; sensitivities against other packages'"
	@echo "make bench-solvers  solvers against other packages', at equal error, and against odeint"
	@echo "make bench-million  a million bicycles with constraints and events: threads, a Dask cluster"
	@echo "make bench-calls  calls that differ in one thing from the last; events and contacts that never happen"
	@echo "make bench-states  calls with many states, over their kernels in the cache"
	@echo "make solvers-ir  write the compiled loops of the solvers as LLVM IR, after a change of them"
	@echo "make three  bundle three.js for the animation page anew (needs npm and a network)"
	@echo "make clean  remove the environments and caches"

demo: $(VENV)/.installed-plot
	$(PY) -m pydy demo

test: $(VENV)/.installed-test
	$(PY) -m ruff check
	$(PY) -m ruff format --check
	$(PY) -m mypy src tests/typing/usage.py & types=$$!; $(PY) -m pytest $(PYTEST_JOBS) && wait $$types

# A folder of its own, so that pytest's default run does not need a browser.
test-browser: $(VENV)/.installed-test $(VENV)/.installed-browser
	$(PY) -m pytest tests/browser

# FILE is a file of src/pydy, or several.
test-near: $(VENV)/.installed-test
	$(PY) tools/near.py --jobs $(JOBS) $(FILE)

test-slow: $(VENV)/.installed-test
	PYDY_FURTHER_PARTS=2 $(PY) -m pytest $(PYTEST_JOBS)

test-whole: $(VENV)/.installed-test
	PYDY_PART=all $(PY) -m pytest $(PYTEST_JOBS)

times: $(VENV)/.installed-test
	PYDY_PART=all PYDY_RECORD_TIMES=1 $(PY) -m pytest $(PYTEST_JOBS)

test-fuzz: $(VENV)/.installed-test
	PYDY_PART=all $(PY) -m pytest $(PYTEST_JOBS) tests/fuzz

# A range of seeds, or one seed with every answer by every front end.
SEEDS ?= 0:600
test-mechanisms: $(VENV)/.installed-test
	$(PY) tests/mechanisms/run.py $(SEEDS) $(JOBS)

# Options of tools/mutations.py.
MUTATIONS ?= --count 30
test-mutations: $(VENV)/.installed-test build/mutations
	$(PY) tools/mutations.py try --jobs $(JOBS) $(MUTATIONS)

build/mutations:
	$(PY) tools/mutations.py record --jobs $(JOBS)

# Each in an environment of its own, .venv-lowest and .venv-newest.
test-lowest test-newest: test-%:
	$(PYTHON) tools/other_versions.py $* $(JOBS)

test-pyright: $(VENV)/.installed-test
	mkdir -p build/pyright
	cd build/pyright && npm install --no-save --no-audit --no-fund --silent pyright@1.1.414
	build/pyright/node_modules/.bin/pyright --pythonpath $(PY) tests/typing/usage.py

# On AArch64 under emulation: the same bits as here, and a core part of the tests.
test-arm64: $(VENV)/.installed-test
	tools/arm64.sh

test-undefined: $(VENV)/.installed-test
	PYTHONPATH=tools $(PY) -m pytest -q -p undefined tests/solvers tests/ensemble/test_lanes.py \
		tests/system/test_events.py tests/system/test_projection.py \
		tests/_integration/test_sensitivities.py tests/system/test_adjoint_gradients.py

docs: $(VENV)/.installed-docs
	$(PY) -m sphinx -W --keep-going --doctree-dir build/doctrees docs build/docs

bench: $(VENV)/.installed-test $(REFERENCE)/.installed
	$(PY) benchmarks/run.py --reference $(REFERENCE_PY)
	$(PY) benchmarks/imports.py
	$(PY) benchmarks/first_result.py

bench-peers: $(VENV)/.installed-test $(PEERS)/.installed $(ADAM)/.installed
	$(PY) benchmarks/operations.py
	$(PY) benchmarks/build.py
	$(PY) benchmarks/peers.py --peer-python $(PEERS_PY)
	$(PY) benchmarks/trees.py --peer-python $(PEERS_PY)
	$(PY) benchmarks/robots.py --peer-python $(PEERS_PY)
	$(PY) benchmarks/floating_robots.py --peer-python $(PEERS_PY) --adam-python $(ADAM_PY)
	$(PY) benchmarks/closed_loops.py
	$(PY) benchmarks/contacts.py
	$(PY) benchmarks/multibody.py --peer-python $(PEERS_PY)
	$(PY) benchmarks/rolling_disc.py --peer-python $(PEERS_PY)
	$(PY) benchmarks/vehicle_models.py --peer-python $(PEERS_PY)
	PYDY_CPU=x86-64-v3 $(PY) benchmarks/peers.py --peer-python $(PEERS_PY)
	$(PY) benchmarks/exported.py --peer-python $(PEERS_PY)

bench-solvers: $(VENV)/.installed-test $(PEERS)/.installed $(REFERENCE)/.installed
	$(PY) benchmarks/solvers.py --peer-python $(PEERS_PY) --reference $(REFERENCE_PY)

bench-control: $(VENV)/.installed-test $(PEERS)/.installed-opty
	$(PY) benchmarks/optimal_control.py --peer-python $(PEERS_PY)

bench-pages: $(VENV)/.installed-test $(VENV)/.installed-browser
	$(PY) benchmarks/live_pages.py

bench-analysis: $(VENV)/.installed-test $(PEERS)/.installed
	$(PY) benchmarks/analysis.py
	$(PY) benchmarks/derivatives.py --peer-python $(PEERS_PY)

# A million trajectories, on threads and on a Dask cluster.
bench-million: $(VENV)/.installed-test
	$(PY) benchmarks/many_bicycles.py

bench-states: $(VENV)/.installed-test
	$(PY) benchmarks/many_states.py

bench-calls: $(VENV)/.installed-test
	$(PY) benchmarks/repeated_calls.py

# After a change of the loops in C, and after a merge of two.
solvers-ir: $(VENV)/.installed-loops
	$(PY) tools/solvers_ir.py

# Pinned: what is committed can be made again, byte for byte.
three:
	rm -rf build/three && mkdir -p build/three
	cp tools/three.entry.js build/three/
	cd build/three && npm install --no-save --no-audit --no-fund three@0.187.0 esbuild@0.28.2
	cd build/three && npx esbuild three.entry.js --bundle --minify --format=iife --global-name=THREE \
		--target=es2020 --charset=ascii --legal-comments=none --outfile=three.min.js
	cp build/three/three.min.js src/pydy/viz/assets/
	cp build/three/node_modules/three/LICENSE src/pydy/viz/assets/three.LICENSE

clean:
	rm -rf $(VENV) $(VENV)-lowest* $(VENV)-newest $(REFERENCE) $(PEERS) $(ADAM) build docs/gallery docs/static/tutorial docs/static/animations docs/static/pages docs/static/landing.html docs/static/operations.* docs/static/speeds.svg .mypy_cache .pytest_cache .ruff_cache .hypothesis

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

$(ADAM)/.installed: | $(ADAM_PY)
	$(ADAM_PY) $(PIP_INSTALL) 'adam-robotics[casadi,jax]==0.5.0'
	@touch $@

# opty needs cyipopt, which is built for the IPOPT of CasADi's wheel: all have the same solver.
$(PEERS)/.installed-opty: $(PEERS)/.installed
	$(PEERS_PY) $(PIP_INSTALL) cython numpy setuptools wheel
	folder=$$($(PEERS_PY) -c 'import casadi; print(*casadi.__path__)'); \
	mkdir -p $(PEERS)/pkgconfig; \
	printf 'Name: Ipopt\nDescription: of CasADi\nVersion: 3.14\nCflags: -I%s/include/coin-or\nLibs: -L%s -lipopt\n' \
		$$folder $$folder > $(PEERS)/pkgconfig/ipopt.pc; \
	PKG_CONFIG_PATH=$(abspath $(PEERS))/pkgconfig LDFLAGS=-Wl,-rpath,$$folder \
		$(PEERS_PY) $(PIP_INSTALL) --no-build-isolation cyipopt==1.7.0 opty==1.5.0
	@touch $@

$(PY) $(REFERENCE_PY) $(PEERS_PY) $(ADAM_PY): %/bin/python:
	@$(PYTHON) -c 'import sys; v = sys.version.split()[0]; sys.version_info >= (3, 11) or sys.exit("pydy needs Python 3.11 or newer, $(PYTHON) is " + v + "; try make PYTHON=python3.12")'
	$(PYTHON) -m venv $*
