"""Tables for notebooks."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape

import numpy as np


def html_table(caption: str, rows: Iterable[Sequence[str]]) -> str:
    """Return a table in HTML; the first cell of each row is its title."""
    lines = []
    for title, *cells in rows:
        text = "".join(f'<td style="text-align:left">{escape(cell)}</td>' for cell in cells)
        lines.append(f'<tr><th style="text-align:left">{escape(title)}</th>{text}</tr>')
    return f"<table><caption>{escape(caption)}</caption>{''.join(lines)}</table>"


def table_of_columns(caption: str, names: Iterable[str], values: np.ndarray) -> str:
    """Return a table of the first, last, least and greatest value of each column."""
    rows: list[tuple[str, ...]] = [("", "first", "last", "least", "greatest")]
    for name, column in zip(names, values.T, strict=True):
        numbers = (column[0], column[-1], column.min(), column.max()) if len(column) else ()
        rows.append((name, *(f"{number:.6g}" for number in numbers)))
    return html_table(caption, rows)
