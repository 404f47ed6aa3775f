"""STL and OBJ files, as CAD programs write them and as nobody should."""

import numpy as np
import pytest

from pydy.viz import Mesh
from pydy.viz.surfaces import surface

CORNERS = np.array([[[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0], [0, 1, 0]]], float)
ASCII = "solid part\n" + "".join(
    "facet normal 0 0 1\n outer loop\n"
    + "".join(f"  vertex {x:.0f} {y:.0f} {z:e}\n" for x, y, z in corners)
    + " endloop\nendfacet\n"
    for corners in CORNERS
)


def binary(corners, header=b"made by hand"):
    rows = b"".join(
        np.zeros(3, "<f4").tobytes() + c.astype("<f4").tobytes() + b"\0\0" for c in corners
    )
    return header.ljust(80, b" ") + len(corners).to_bytes(4, "little") + rows


@pytest.fixture
def write(tmp_path):
    def write(name, content):
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return write


@pytest.mark.parametrize(
    "content", [ASCII, binary(CORNERS), binary(CORNERS, b"solid, says the header of this one")]
)
def test_stl_files_are_read_with_each_corner_once(write, content):
    mesh = Mesh(write("part.STL", content))
    assert mesh.vertices.shape == (4, 3)
    assert mesh.vertices[mesh.faces] == pytest.approx(CORNERS)


def test_obj_files_are_read_with_polygons_comments_and_negative_places(write):
    text = """# a square and a triangle
    v 0 0 0
    v 1 0 0 # with a comment
    v 1 1 0
    v 0 1 0
    vt 0 0
    vn 0 0 1
    f 1/1/1 2/1/1 3//1 4
    f -4 \\
      -3 -2
    """
    mesh = Mesh(write("part.obj", text), scale=2.0)
    assert mesh.faces.tolist() == [[0, 1, 2], [0, 2, 3], [0, 1, 2]]
    assert surface(mesh)[0].max() == 2.0


@pytest.mark.parametrize(
    ("name", "content", "message"),
    [
        ("part.step", "", "only STL and OBJ files can be read"),
        ("part.stl", b"\x07" * 90, "not a valid STL file: it is 90 bytes long"),
        ("part.stl", binary(CORNERS)[:-3], "not a valid STL file"),
        ("part.stl", "solid\nvertex 0 0 0\nvertex 1 0 0\n", "not a multiple of three"),
        ("part.stl", "solid\nvertex a b c\n", "not a valid STL file"),
        ("part.stl", "solid empty\nendsolid\n", "holds no triangle"),
        ("part.stl", ASCII.replace("1 0 0.000000e+00", "1 0 nan"), "a vertex that is not finite"),
        ("part.obj", "v 0 0\nf 1 1 1\n", "not a valid OBJ file"),
        ("part.obj", "v 0 0 0\nf 1 2 3\n", "does not fit the vertices before it"),
        ("part.obj", "v 0 0 0\n", "holds no triangle"),
    ],
)
def test_broken_files_are_refused_by_name(write, name, content, message):
    with pytest.raises(ValueError, match=message) as error:
        Mesh(write(name, content))
    assert name in str(error.value)


def test_a_missing_file_is_said_to_be_missing(tmp_path):
    with pytest.raises(FileNotFoundError, match=r"gone\.stl"):
        Mesh(tmp_path / "gone.stl")
