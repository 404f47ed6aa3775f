"""How Sphinx builds the documentation: `make docs`."""

from __future__ import annotations

import doctest
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

from docutils import nodes

from pydy import __version__

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE))

import generated  # noqa: E402 - beside this file
import illustrate  # noqa: E402
import try_it  # noqa: E402

project = "pydy"
author = "the pydy authors"
project_copyright = author
version = release = __version__

extensions = [
    "myst_parser",
    "numpydoc",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.mathjax",
    "sphinx_copybutton",
    "sphinx_gallery.gen_gallery",
]
# `name` in a docstring is a link where there is something to link to, and plain code elsewhere.
default_role = "py:obj"

html_theme = "furo"
html_title = f"pydy {version}"
html_static_path = ["static"]
html_css_files = ["pydy.css"]
html_show_sourcelink = False
exclude_patterns = ["static/*.md"]  # included by other pages

myst_enable_extensions = ["colon_fence", "dollarmath"]
myst_heading_anchors = 3

autodoc_member_order = "bysource"
autodoc_typehints = "none"  # numpydoc's Parameters say it in words
numpydoc_show_class_members = False  # the members are documented below their class
numpydoc_xref_param_type = False

copybutton_prompt_text = r">>> |\.\.\. |\$ "
copybutton_prompt_is_regexp = True
copybutton_only_copy_prompt_lines = True

sphinx_gallery_conf = {
    "examples_dirs": "../examples",
    "gallery_dirs": "gallery",
    "filename_pattern": r"\.py$",  # run them all
    "within_subsection_order": "generated.SimpleToRich",
    "abort_on_example_error": True,
    "download_all_examples": False,
    "show_memory": False,
    "show_signature": False,
    "image_scrapers": ("matplotlib", "generated.scrape_animation"),
    "min_reported_time": 10_000,
    # What examples print is shown; a scene's page comes from `scrape_animation`.
    "capture_repr": (),
}


def run_tutorial(app: Any) -> None:
    """Make the tutorial's pictures, by its own code."""
    text = (HERE / "tutorial.md").read_text(encoding="utf-8")
    code = "".join(example.source for example in doctest.DocTestParser().get_examples(text))
    folder = HERE / "static" / "tutorial"
    folder.mkdir(exist_ok=True)
    environment = {**os.environ, "MPLBACKEND": "agg"}
    subprocess.run([sys.executable, "-c", code], cwd=folder, env=environment, check=True)


def shorten_citations(app: Any, document: nodes.document, name: str) -> None:
    """Show [1] where numpydoc left its own [R0123456789ab-1]."""
    for text in list(document.findall(nodes.Text)):
        if match := re.fullmatch(r"\[R[0-9a-f]{12}-(\w+)\]", text.astext()):
            text.parent.replace(text, nodes.Text(f"[{match[1]}]"))


def setup(app: Any) -> None:
    """Sphinx calls this."""
    app.connect("builder-inited", run_tutorial)
    app.connect("builder-inited", generated.make, priority=100)  # before the gallery runs
    app.connect("builder-inited", generated.show_thumbnails, priority=900)  # and after it
    app.connect("env-before-read-docs", illustrate.start)
    app.connect("source-read", illustrate.illustrate)
    app.connect("doctree-resolved", shorten_citations)
    app.connect("build-finished", try_it.finish)
