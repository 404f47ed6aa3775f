"""A scene in a notebook, run by a kernel."""

from optional import optional

nbclient = optional("nbclient")
nbformat = optional("nbformat")
optional("ipykernel")

CELLS = [
    """
import warnings
warnings.simplefilter("error")
import numpy as np
from pydy.models import n_link_pendulum_on_cart
system = n_link_pendulum_on_cart(1)
system.initial_conditions = {"q1": 0.5}
system.times = np.linspace(0.0, 1.0, num=31)
system""",
    "system.animate()",
    "system.scene().animate(system.simulate()).show()",
    "system.scene().animate(system.simulate()).display_jupyter(axes_arrow_length=1.0)",
    "system.simulate()",
]


def test_scenes_are_displayed_inline_without_warnings():
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(c) for c in CELLS])
    nbclient.NotebookClient(notebook, timeout=300).execute()
    kinds = [[output.output_type for output in cell.outputs] for cell in notebook.cells]
    assert kinds == [["execute_result"]] * 2 + [["display_data"]] + [["execute_result"]] * 2
    for cell in notebook.cells[1:4]:
        (output,) = cell.outputs
        assert output.data["text/html"].startswith("<iframe")
