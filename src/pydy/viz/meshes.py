"""Readers for the two mesh formats that every CAD program writes: STL and OBJ."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np

__all__ = ["read_mesh"]

# Binary STL: 80 bytes of anything, a count, then for each triangle a normal, three corners and two
# spare bytes, all little-endian.
_STL_HEADER = 84
_STL_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("spare", "<u2")])


def read_mesh(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Return the vertices (n, 3) and the triangles (k, 3) of an STL or OBJ file.

    Raises
    ------
    ValueError
        The suffix is neither, the file is broken, or it holds no triangle.
    OSError
        The file cannot be read.
    """
    readers = {".stl": _read_stl, ".obj": _read_obj}
    reader = readers.get(path.suffix.lower())
    if reader is None:
        raise ValueError(
            f"`source` of Mesh is '{path}', but only STL and OBJ files can be read: export the "
            "part in one of these formats."
        )
    try:
        vertices, faces = reader(path.read_bytes())
    except (ValueError, IndexError) as error:
        raise ValueError(
            f"`source` of Mesh is '{path}', which is not a valid {path.suffix[1:].upper()} file: "
            f"{error}."
        ) from None
    if not len(faces):
        raise ValueError(f"`source` of Mesh is '{path}', which holds no triangle.")
    if not np.isfinite(vertices).all():
        raise ValueError(f"`source` of Mesh is '{path}', which has a vertex that is not finite.")
    return vertices, faces


def _read_stl(data: bytes) -> tuple[np.ndarray, np.ndarray]:
    # Binary files may begin with "solid" too, so it is the length that tells.
    count = int.from_bytes(data[80:84], "little") if len(data) >= _STL_HEADER else -1
    if len(data) == _STL_HEADER + count * _STL_TRIANGLE.itemsize:
        corners = np.frombuffer(data, _STL_TRIANGLE, count, _STL_HEADER)["corners"]
    elif data.lstrip()[:5].lower() == b"solid":
        lines = (line.split() for line in data.decode("ascii", "replace").splitlines())
        rows = [line[1:] for line in lines if line and line[0].lower() == "vertex"]
        flat = np.array(rows, dtype=float).reshape(-1, 3)
        if len(flat) % 3:
            raise ValueError(f"it has {len(flat)} vertices, which is not a multiple of three")
        corners = flat.reshape(-1, 3, 3)
    else:
        raise ValueError(
            f"it is {len(data)} bytes long, which does not fit its {max(count, 0)} triangles"
        )
    # Shared corners once: half the size or less.
    vertices, places = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    return vertices.astype(float), places.reshape(-1, 3)


def _read_obj(data: bytes) -> tuple[np.ndarray, np.ndarray]:
    vertices: list[list[float]] = []
    faces: list[tuple[int, int, int]] = []
    text = data.decode("utf-8", "replace").replace("\\\n", " ")
    for line in text.splitlines():
        words = line.split("#")[0].split()
        if not words:
            continue
        if words[0] == "v":
            x, y, z = map(float, words[1:4])
            vertices.append([x, y, z])
        elif words[0] == "f":
            # "f v/vt/vn ...", from one; negative counts back from the last vertex so far.
            numbers = [int(word.split("/")[0]) for word in words[1:]]
            places = [n - 1 if n > 0 else len(vertices) + n for n in numbers]
            if len(places) < 3 or not all(0 <= k < len(vertices) for k in places):
                raise ValueError(f"the face `{line.strip()}` does not fit the vertices before it")
            faces += [(places[0], b, c) for b, c in pairwise(places[1:])]
    return np.array(vertices, dtype=float).reshape(-1, 3), np.array(faces, dtype=int).reshape(-1, 3)
