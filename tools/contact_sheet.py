"""Pictures of mechanisms without a shape given, tiled into one image.

``python tools/contact_sheet.py sheet.webp`` draws each model of ``tests/zoo/pictured.py`` as its
page shows it in Chromium, wide and as narrow as a phone, light and dark, at one instant. It needs
Playwright and Pillow. ``--only`` and ``--folder`` are for looking at single pictures.
"""

from __future__ import annotations

import argparse
import io
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
sys.path[:0] = [str(ROOT / "tests")]

SIZES = {"wide": (1280, 800), "phone": (390, 760)}
THEMES = ("light", "dark")
TILE = 200  # height of a picture in the sheet


def pages(folder: Path, only: str) -> Iterator[tuple[str, Path]]:
    """Write the page of each model; yield its title and the file."""
    from zoo import pictured

    for k, title in enumerate(pictured.MODELS):
        if only.lower() not in title.lower():
            continue
        path = folder / f"{k:02d}.html"
        states = pictured.system_of(title).states
        live = dict.fromkeys(states[1:3], (-9.0, 9.0)) if title.startswith(LIVE) else None
        scene = pictured.animated(title, title=title, series=states[:1])
        yield title, scene.to_html(path, live=live)


LIVE = ("Pendulums on a cart", "Planar double")
"""What has sliders."""


def photographs(files: list[tuple[str, Path]], share: float) -> Iterator[tuple[str, list[bytes]]]:
    """Yield the pictures of each page: all sizes in one theme, then in the other."""
    from playwright.sync_api import sync_playwright

    import chromium
    from waiting import until

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=chromium.program(), args=chromium.ARGUMENTS
        )
        for title, path in files:
            made = []
            for theme in THEMES:
                for width, height in SIZES.values():
                    context = browser.new_context(
                        viewport={"width": width, "height": height}, color_scheme=theme
                    )
                    page = context.new_page()
                    page.goto(path.resolve().as_uri())
                    until(page, "window.pydy && window.pydy.ready")
                    page.evaluate("part => pydy.seek(part * pydy.times.at(-1))", share)
                    page.wait_for_timeout(150)
                    made.append(page.screenshot())
                    context.close()
            yield title, made
        browser.close()


def sheet(pictures: list[tuple[str, list[bytes]]], columns: int) -> Any:
    """Return the pictures of all models as one image."""
    from PIL import Image

    tiles = []
    for _, images in pictures:
        parts = [Image.open(io.BytesIO(data)).convert("RGB") for data in images]
        parts = [p.resize((round(p.width * TILE / p.height), TILE), Image.LANCZOS) for p in parts]
        tile = Image.new("RGB", (sum(p.width + 2 for p in parts), TILE), "white")
        x = 0
        for part in parts:
            tile.paste(part, (x, 0))
            x += part.width + 2
        tiles.append(tile)
    width, gap = tiles[0].width, 10
    rows = -(-len(tiles) // columns)
    whole = Image.new("RGB", (columns * (width + gap), rows * (TILE + gap)), "white")
    for k, tile in enumerate(tiles):
        whole.paste(tile, ((k % columns) * (width + gap), (k // columns) * (TILE + gap)))
    return whole


def main(arguments: list[str]) -> None:
    """Write the sheet that the command line asks for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("image", type=Path, help="where the sheet is written: .webp or .png")
    parser.add_argument("--only", default="", help="a part of the titles of the models to draw")
    parser.add_argument("--folder", type=Path, help="where single pictures are kept too")
    parser.add_argument("--columns", type=int, default=2)
    parser.add_argument("--share", type=float, default=0.3, help="of the motion that is over")
    parser.add_argument("--quality", type=int, default=55)
    given = parser.parse_args(arguments)
    with tempfile.TemporaryDirectory() as place:
        files = list(pages(Path(place), given.only))
        pictures = list(photographs(files, given.share))
    if given.folder is not None:
        given.folder.mkdir(parents=True, exist_ok=True)
        names = [f"{theme}-{size}" for theme in THEMES for size in SIZES]
        for k, (_, images) in enumerate(pictures):
            for name, data in zip(names, images, strict=True):
                (given.folder / f"{k:02d}-{name}.png").write_bytes(data)
    sheet(pictures, given.columns).save(given.image, quality=given.quality)


if __name__ == "__main__":
    main(sys.argv[1:])
