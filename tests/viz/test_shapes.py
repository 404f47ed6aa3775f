"""Shapes: checked when made, measured with the constants' values."""

import copy
import pickle

import numpy as np
import pytest
import sympy as sm
from sympy.physics.mechanics import Point

from pydy.errors import PyDyUserWarning
from pydy.viz import (
    Box,
    Capsule,
    Cone,
    Cylinder,
    Damper,
    Mesh,
    Octahedron,
    Plane,
    Sphere,
    Spring,
    Torus,
    Trace,
)
from pydy.viz.surfaces import arrow, coil, piston, rods, surface


def volume(vertices, faces):
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


def test_a_shape_can_be_changed_and_is_checked_again():
    ball, ring = Sphere(1), Torus(1, 0.1)
    ball.radius, ball.color, ball.name = 2, "navy", "ball"
    ring.tube_radius = 0.2
    assert ball == Sphere(2.0, colour="navy", name="ball")
    assert (ball.color, ring.tube, ring.tube_radius) == ("#000080", 0.2, 0.2)
    with pytest.raises(ValueError, match="`radius` of Sphere must be a positive number"):
        ball.radius = -1
    with pytest.raises(AttributeError, match=r"Sphere has no attribute `radios`\. Did you mean"):
        ball.radios = 1
    with pytest.warns(PyDyUserWarning, match="`material` of Sphere is ignored"):
        ball.material = "metal"
    mesh = Mesh(([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
    mesh.source = ([[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    assert mesh.vertices.max() == 2.0
    for copied in (copy.deepcopy(ball), pickle.loads(pickle.dumps(ball))):
        assert copied == ball


def test_arguments_of_a_shape_are_named_with_its_own_name():
    with pytest.raises(TypeError, match=r"Sphere has no argument `radios`; .* mean `radius`\?"):
        Sphere(radios=1)
    with pytest.raises(TypeError, match=r"Cone: missing a required argument: 'radius'. Its ar"):
        Cone(1)
    with pytest.raises(TypeError, match=r"Damper: too many positional arguments. Its ar"):
        Damper(1, 2, 3, 4, 5, 6, 7, 8, 9)


def test_scripts_may_leave_out_sizes():
    assert Sphere().radius == Octahedron().radius == 10.0
    assert (Plane().length, Plane().width) == (10.0, 5.0)


def test_lengths_may_be_expressions_of_constants():
    l, r = sm.symbols("l, r")
    shape = Cylinder(2 * l, r / 3).measured({l: 0.5, r: 0.3})
    assert (shape.length, shape.radius) == pytest.approx((1.0, 0.1))


def test_a_length_with_an_unknown_symbol_names_it_and_the_remedy():
    with pytest.raises(ValueError, match=r"`radius` of Sphere is `2\*k`, but `k`.*`constants`"):
        Sphere(2 * sm.Symbol("k")).measured({})


def test_a_length_that_comes_out_negative_is_refused():
    k = sm.Symbol("k")
    with pytest.raises(ValueError, match=r"must be positive, but comes out as -1\.0"):
        Sphere(k).measured({k: -1.0})


@pytest.mark.parametrize(
    ("colour", "expected"),
    [("navy", "#000080"), ("#0AF", "#00aaff"), ("#123456", "#123456"), ((1, 0, 0.5), "#ff0080")],
)
def test_colours_are_names_hexadecimal_or_levels(colour, expected):
    assert Sphere(1, colour=colour).colour == expected


def test_a_trace_lasts_forever_or_some_seconds():
    assert Trace().duration is None
    assert Trace(2).duration == 2.0


@pytest.mark.parametrize(
    ("shape", "expected"),
    [
        (Sphere(0.5), 4 / 3 * np.pi * 0.5**3),
        (Box(1, 2, 3), 6.0),
        (Cylinder(2, 0.5), 2 * np.pi * 0.25),
        (Cone(2, 0.5), 2 / 3 * np.pi * 0.25),
        (Capsule(2, 0.5), 2 * np.pi * 0.25 + 4 / 3 * np.pi * 0.125),
        (Torus(1, 0.25), 2 * np.pi**2 * 0.0625),
    ],
    ids=lambda value: type(value).__name__,
)
def test_surfaces_enclose_the_volume_of_their_shape_and_face_outwards(shape, expected):
    assert volume(*surface(shape)) == pytest.approx(expected, rel=0.06)


@pytest.mark.parametrize("axis", ["x", "y", "z"])
@pytest.mark.parametrize("kind", [Cylinder, Cone, Capsule])
def test_round_shapes_lie_along_their_axis(kind, axis):
    vertices = surface(kind(4, 0.5, axis=axis))[0]
    reach = np.ptp(vertices, axis=0)
    assert reach.argmax() == "xyz".index(axis)
    assert vertices[np.abs(vertices).max(axis=1).argmax()]["xyz".index(axis)] > 0


@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_a_torus_is_flat_along_its_axis(axis):
    reach = np.ptp(surface(Torus(1, 0.1, axis=axis))[0], axis=0)
    k = "xyz".index(axis)
    assert reach[k] == pytest.approx(0.2)
    assert np.delete(reach, k) == pytest.approx([2.2, 2.2])


@pytest.mark.parametrize(("axis", "reach"), [("x", [0, 2, 1]), ("y", [2, 0, 1]), ("z", [2, 1, 0])])
def test_a_plane_has_its_length_along_the_first_of_the_other_axes(axis, reach):
    assert np.ptp(surface(Plane(2, 1, axis=axis))[0], axis=0).tolist() == reach


def test_rods_and_arrows_go_from_their_start_along_their_vector():
    start, vector = np.array([1.0, 2.0, 3.0]), np.array([0.0, 0.0, -2.0])
    ends = np.stack([start, start + vector])
    for vertices, faces in (rods(ends, 0.1), arrow(start, vector, 0.05)):
        assert vertices[:, 2].max() == pytest.approx(3.0)
        assert vertices[:, 2].min() == pytest.approx(1.0)
        assert volume(vertices, faces) > 0


@pytest.mark.parametrize("length", [4.0, 0.9, 0.12])  # the head is 6 radii long, and shrinks
def test_an_arrow_is_a_cylinder_and_a_cone_about_its_vector(length):
    radius, start, direction = 0.05, np.array([1.0, 2.0, 3.0]), np.array([2.0, -1.0, 2.0]) / 3
    vertices, faces = arrow(start, length * direction, radius)
    head = min(6 * radius, length)
    widest = 2.5 * radius * min(1.0, length / (6 * radius))
    away = np.linalg.norm(np.cross(vertices - start, direction), axis=1)
    along = (vertices - start) @ direction
    assert away.max() == pytest.approx(widest)
    assert along.min() == pytest.approx(0.0, abs=1e-12)
    assert along.max() == pytest.approx(length)
    exact = np.pi * radius**2 * (length - head) + np.pi * widest**2 * head / 3
    assert 0.85 < volume(vertices, faces) / exact < 1.0


@pytest.mark.parametrize("radius", [0.01, 0.2])  # with few corners around, and with many
def test_each_of_several_rods_is_a_cylinder_about_its_way(radius):
    points = np.array([[0.0, 0, 0], [1, 2, 2], [1, 2, 5], [-3, 2, 5], [-3, 0, 5]])
    vertices, faces = rods(points, radius)
    assert len(vertices) % 4 == 0
    assert len(faces) % 4 == 0
    per = len(vertices) // 4
    for k, corners in enumerate(vertices.reshape(4, per, 3)):
        start, way = points[k], points[k + 1] - points[k]
        length = np.linalg.norm(way)
        along = (corners - start) @ way / length
        away = np.linalg.norm(np.cross(corners - start, way), axis=1) / length
        assert along.min() == pytest.approx(0.0, abs=1e-12)
        assert along.max() == pytest.approx(length)
        assert away.max() == pytest.approx(radius)
        own = faces.reshape(4, -1, 3)[k] - k * per
        assert 0.85 < volume(corners, own) / (np.pi * radius**2 * length) < 1.0


def test_a_mesh_takes_arrays_and_checks_them():
    vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    assert Mesh((vertices, [[0, 1, 2]])).faces.shape == (1, 3)
    with pytest.raises(ValueError, match="each the index of one of the 3 vertices"):
        Mesh((vertices, [[0, 1, 3]]))
    with pytest.raises(ValueError, match=r"vertices of shape \(n, 3\)"):
        Mesh(([[0, 0]], [[0, 0, 0]]))
    with pytest.raises(ValueError, match="`source` of Mesh must be the path"):
        Mesh(7)


# -- STL and OBJ files, as CAD programs write them and as nobody should ----------------------------


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


@pytest.mark.parametrize("kind", [Spring, Damper])
def test_springs_and_dampers_have_two_ends_and_a_surface_between_them(kind):
    ends = [Point(name) for name in "ABC"]
    with pytest.raises(ValueError, match=f"`points` of {kind.__name__} must be two points"):
        kind(ends)
    start, way = np.array([1.0, 2.0, 3.0]), np.array([2.0, -1.0, 2.0])  # three long
    points = np.stack([start, start + way])
    made = coil(points, 0.1, 8) if kind is Spring else piston(points, 0.1, 1.5)
    along = (made[0] - start) @ (way / 3.0)
    assert [along.min(), along.max()] == pytest.approx([0.0, 3.0], abs=0.04)
    away = np.linalg.norm(made[0] - start - np.outer(along, way / 3.0), axis=1)
    assert away.max() == pytest.approx(0.118 if kind is Spring else 0.18, rel=0.01)


def test_a_spring_has_one_coil_or_more():
    ends = [Point("A"), Point("B")]
    assert Spring(ends, coils=np.int64(3)).coils == 3
    with pytest.raises(ValueError, match="`coils` of Spring"):
        Spring(ends, coils=0)
    with pytest.raises(ValueError, match="`coils` of Spring must be at most 1000, got 1000000000"):
        Spring(ends, coils=10**9)
