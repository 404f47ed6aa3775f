"""Pictures on pages: run the code of a page and keep what each block draws or animates.

``python docs/illustrate.py results static/pages`` writes the files and prints, as JSON, a pair of
the last line of the block and the file's name for each of them.
"""

from __future__ import annotations

import contextlib
import doctest
import io
import json
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE))


def blocks(text: str) -> list[tuple[int, str]]:
    """Return the fenced blocks of a page with the index of the line that ends each."""
    found, begin = [], None
    lines = text.splitlines()
    for k, line in enumerate(lines):
        if line.startswith("```"):
            if begin is not None:
                found.append((k, "\n".join(lines[begin:k])))
            begin = None if begin is not None else k + 1
    return found


def drawing() -> set[str]:
    """Return the pages whose code draws or animates, but for the tutorial, which shows its own."""
    found = set()
    for path in HERE.rglob("*.md"):
        code = "\n".join(block for _, block in blocks(path.read_text(encoding="utf-8")))
        if re.search(r"^(>>>|\.\.\.) .*(\banimate\(|plot)", code, re.MULTILINE):
            found.add(path.relative_to(HERE).with_suffix("").as_posix())
    return found - {"tutorial"}


PAGES = drawing()


def draw(name: str, folder: Path) -> list[tuple[int, str]]:
    """Run a page in this process; return the pictures that it makes."""
    import generated
    import matplotlib.pyplot as plt

    generated.watch_scenes()
    stem, made, names = name.replace("/", "-"), [], {"__name__": "__main__"}
    for line, block in blocks((HERE / f"{name}.md").read_text(encoding="utf-8")):
        for example in doctest.DocTestParser().get_examples(block):
            try:
                exec(compile(example.source, name, "exec"), names)
            except Exception:
                if example.exc_msg is None:
                    raise
        for number in plt.get_fignums():
            path = folder / f"{stem}-{len(made)}.svg"
            plt.figure(number).savefig(path)
            made.append((line, path.name))
        plt.close("all")
        scene = generated.take_scene()
        if scene is not None:
            path = folder / f"{stem}-{len(made)}.html"
            scene[0].to_html(path, live=scene[1])
            made.append((line, path.name))
            generated.take_scene()
    return made


_RUNS: dict[str, Future[list[tuple[int, str]]]] = {}


def start(app: Any, env: Any, names: list[str]) -> None:
    """Start to run the pages that are about to be read."""
    pool = ThreadPoolExecutor(max_workers=2)
    _RUNS.update({name: pool.submit(run, name) for name in names if name in PAGES})
    pool.shutdown(wait=False)


def run(name: str) -> list[tuple[int, str]]:
    """Run a page in a process of its own, and in a folder where its examples may write files."""
    folder = HERE / "static" / "pages"
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as elsewhere:
        done = subprocess.run(
            [sys.executable, str(HERE / "illustrate.py"), name, str(folder)],
            cwd=elsewhere,
            env={**os.environ, "MPLBACKEND": "agg"},
            check=True,
            stdout=subprocess.PIPE,
            encoding="utf-8",
        )
    pictures: list[tuple[int, str]] = json.loads(done.stdout)
    return pictures


def illustrate(app: Any, name: str, source: list[str]) -> None:
    """Add to the text of a page what its blocks draw and animate."""
    if name in _RUNS:
        source[0] = with_pictures(source[0], name, _RUNS.pop(name).result())


def with_pictures(text: str, name: str, pictures: list[tuple[int, str]]) -> str:
    """Return the text of a page with pictures after the lines that end their blocks."""
    lines = text.splitlines()
    up = "../" * name.count("/")
    for line, file in reversed(pictures):
        if file.endswith(".svg"):
            shown = f"```{{image}} /static/pages/{file}\n:alt: What this code draws\n"
            shown += ":class: on-white\n```"
        else:
            shown = (
                '```{raw} html\n<iframe class="animation" loading="lazy" '
                f'title="What this code animates" src="{up}_static/pages/{file}"></iframe>\n```'
            )
        lines[line + 1 : line + 1] = ["", *shown.splitlines()]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    with contextlib.redirect_stdout(io.StringIO()):
        pictures = draw(sys.argv[1], Path(sys.argv[2]))
    sys.stdout.write(json.dumps(pictures))
