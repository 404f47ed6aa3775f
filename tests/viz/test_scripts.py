"""Scripts written for PyDy's viz package: they run to the end, and open our page.

Each builds a model, simulates and shows it as published examples do, in other words and numbers.
"""

import copy

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.codegen.ode_function_generators import generate_ode_function
from pydy.errors import PyDyUserWarning
from pydy.models import n_link_pendulum_on_cart
from pydy.system import System
from pydy.viz import (
    OrthoGraphicCamera,
    PerspectiveCamera,
    PointLight,
    Scene,
    Visual,
    VisualizationFrame,
)
from pydy.viz.shapes import (
    Box,
    Circle,
    Cone,
    Cube,
    Cylinder,
    Icosahedron,
    Mesh,
    Octahedron,
    Plane,
    Sphere,
    Tetrahedron,
    Torus,
    TorusKnot,
    Tube,
)
from pydy.viz.surfaces import surface

N, O = me.ReferenceFrame("N"), me.Point("O")
TIMES = np.linspace(0.0, 1.0, num=31)


@pytest.fixture(autouse=True)
def opened(monkeypatch):
    """The pages that a script opened in the browser."""
    pages = []
    monkeypatch.setattr("webbrowser.open", pages.append)
    return pages


@pytest.fixture
def rod():
    """A scene of a rod that turns, and its symbols."""
    q, length = me.dynamicsymbols("q"), sm.Symbol("l")
    frame = N.orientnew("R", "Axis", (q, N.z))
    visual = VisualizationFrame("rod", frame, O, Cylinder(length, length / 20))
    return Scene(N, O, visual), q, length


def test_a_block_on_a_spring(opened):
    x, v = me.dynamicsymbols("x, v")
    m, c, k = sm.symbols("m, c, k")
    wall, hook, end = me.ReferenceFrame("W"), me.Point("H"), me.Point("E")
    hook.set_vel(wall, 0)
    end.set_pos(hook, x * wall.x)
    end.set_vel(wall, v * wall.x)
    block = me.Particle("block", end, m)
    kane = me.KanesMethod(wall, q_ind=[x], u_ind=[v], kd_eqs=[x.diff() - v])
    kane.kanes_equations([block], [(end, -(k * x + c * v) * wall.x)])
    sys = System(kane, constants={m: 0.5, c: 0.1, k: 12.0}, initial_conditions={x: 0.4})
    sys.times = TIMES
    shape = Cube(0.2, color="olive", name="body")
    frames = [
        VisualizationFrame("block", wall, block, shape),
        VisualizationFrame("wall", wall, hook, Plane(1, 2, color="grey")),
    ]
    scene = Scene(wall, hook, *frames, system=sys)
    scene.display()
    assert len(opened) == 1
    np.testing.assert_allclose(scene.poses[:, 0, 0, 3], sys.integrate()[:, 0], atol=1e-12)


def test_a_chain_with_arrays_set_by_hand(opened):
    q1, q2 = me.dynamicsymbols("q1, q2")
    l = sm.Symbol("l")
    frame, top = me.ReferenceFrame("I"), me.Point("T")
    A, B = (frame.orientnew(name, "Axis", (q, frame.z)) for name, q in (("A", q1), ("B", q2)))
    joint = top.locatenew("J", -l * A.y)
    links = [
        VisualizationFrame(A, top.locatenew("a", -l / 2 * A.y), Cylinder(l, 0.05, color="red")),
        VisualizationFrame(B, joint.locatenew("b", -l / 2 * B.y), Cylinder(l, l / 20)),
    ]
    scene = Scene(frame, top)
    scene.visualization_frames = links
    scene.times = TIMES
    scene.states_symbols = [q1, q2]
    scene.constants = {l: 0.7}
    scene.states_trajectories = np.column_stack([np.cos(TIMES), np.sin(TIMES)])
    scene.display()
    assert len(opened) == 1
    assert scene.times is not TIMES
    # The axis of a Cylinder is the y axis of its frame.
    np.testing.assert_allclose(scene.poses[-1, 1, :2, 1], [-np.sin(np.sin(1)), np.cos(np.sin(1))])
    scene.states_trajectories = np.zeros((31, 2))
    np.testing.assert_allclose(scene.poses[-1, 1, :3, :3], np.eye(3))


def test_a_pendulum_displayed_in_a_notebook_with_axes():
    system = n_link_pendulum_on_cart(2)
    system.times = TIMES
    system.initial_conditions = {"q1": 0.3}
    bobs = [body.point for body in system.eom_method.bodies]
    scene = system.scene(*[Visual(Sphere(0.1, color="blue"), p) for p in bobs])
    scene.system = system
    assert scene.display_jupyter(axes_arrow_length=2.5) is scene
    assert '"axes":2.5' in scene.html()
    assert scene._repr_html_().startswith("<iframe")


def test_a_tumbling_box_with_cameras_and_lights(opened):
    w = me.dynamicsymbols("w1:4")
    q = me.dynamicsymbols("e1:4")
    side, m = sm.symbols("side, m")
    C, G = N.orientnew("C", "Body", q, "123"), me.Point("G")
    rates = [a - (C.ang_vel_in(N) & e) for a, e in zip(w, C, strict=True)]
    C.set_ang_vel(N, sum((a * e for a, e in zip(w, C, strict=True)), 0 * C.x))
    G.set_vel(N, 0)
    brick = me.RigidBody("brick", G, C, m, (me.inertia(C, 1, 2, 3), G))
    kane = me.KanesMethod(N, q, w, kd_eqs=rates)
    kane.kanes_equations([brick], [])
    system = System(kane, initial_conditions={w[1]: 3.0, w[0]: 0.02}, times=TIMES)
    eye = G.locatenew("eye", 4 * N.x + 3 * N.z)
    camera = PerspectiveCamera("camera", N, eye, fov=40, near=0.1, far=100)
    scene = Scene(
        N, G, VisualizationFrame(brick, Box(width=side, height=2 * side, depth=0.5)),
        cameras=[camera], lights=[PointLight("sun", N, eye)], width=800, height=600, system=system,
    )  # fmt: skip
    scene.constants = {side: 0.25}
    system.constants = {}
    with pytest.raises(ValueError, match="`side` has no value"):
        Scene(N, G, VisualizationFrame(brick, Box(side, 1, 1)), system=system).display()
    scene.animate(system.simulate(), constants=scene.constants)
    scene.display()
    assert len(opened) == 1
    np.testing.assert_allclose(scene._settings.view, [0.8, 0, 0.6])
    assert OrthoGraphicCamera(brick).origin is G


def test_a_generated_function_and_plain_arrays(opened):
    x, y, v, w = me.dynamicsymbols("x, y, v, w")
    g = sm.Symbol("g")
    rhs = generate_ode_function(sm.Matrix([0, -g]), [x, y], [v, w], [g], mass_matrix=sm.eye(2),
                                coordinate_derivatives=sm.Matrix([v, w]))  # fmt: skip
    from scipy.integrate import odeint

    states = odeint(rhs, [0.0, 1.0, 2.0, 3.0], TIMES, args=([9.8],))
    ball = O.locatenew("ball", x * N.x + y * N.y)
    scene = Scene(N, O, VisualizationFrame(N, ball, Sphere(0.05)))
    scene.states_symbols, scene.constants = [x, y, v, w], {g: 9.8}
    scene.states_trajectories, scene.times = states, TIMES
    scene.display()
    assert len(opened) == 1
    np.testing.assert_allclose(scene.poses[:, 0, :2, 3], states[:, :2])


def test_times_left_out_are_thirty_a_second(rod, opened):
    scene, q, length = rod
    angles = np.linspace(0.0, 2.0, num=61)[:, None]
    scene.states_symbols, scene.constants = [q], {length: 0.7}
    scene.states_trajectories = angles
    scene.display()
    assert len(opened) == 1
    np.testing.assert_allclose(scene.times, np.arange(61) / 30)
    frames = scene.visualization_frames
    given = {"constants": {length: 0.7}, "states_symbols": [q], "states_trajectories": angles}
    again = Scene(N, O, *frames, **given, frames_per_second=20.0, name="rod")
    np.testing.assert_allclose(again.times, np.arange(61) / 20)
    np.testing.assert_allclose(Scene(N, O, *frames, times=2 * again.times, **given).times[-1], 6.0)


def test_shapes_and_frames_can_be_changed_after_the_motion_is_set(rod):
    scene, q, length = rod
    scene.animate(TIMES, TIMES[:, None], symbols=[q], constants={length: 0.7})
    frame = scene.visualization_frames[0]
    assert '"kind":"Cylinder"' in scene.html()
    frame.shape.color = "teal"
    assert "#008080" in scene.html()
    frame.shape, frame.name = Sphere(0.2), "bob"
    assert '"name":"bob","kind":"Sphere"' in scene.html()
    place = O.locatenew("place", 3 * N.x)
    frame.origin, frame.reference_frame = place, N
    assert frame.origin is place
    np.testing.assert_allclose(
        scene.poses[-1, 0, :3], np.eye(4)[:3] + [[0, 0, 0, 3]] * np.eye(3)[:, :1]
    )
    with pytest.raises(TypeError, match="`origin` of a Visual must be a Point"):
        frame.origin = N
    with pytest.raises(AttributeError, match="Visual has no attribute `colour`"):
        frame.colour = "red"


def test_cameras_and_lights_keep_what_they_were_given():
    camera = PerspectiveCamera("camera", N, O, fov=40.0)
    assert (camera.fov, camera.near, camera.origin) == (40.0, 1.0, O)
    light = PointLight(N, O, color="blue")
    assert light.color == "blue"
    with pytest.raises(TypeError, match=r"A PointLight takes .* got N"):
        PointLight(N)
    with pytest.raises(TypeError, match=r"`cameras` must hold PerspectiveCameras, .* as `lights`"):
        Scene(N, O, cameras=[camera, light])


# -- shapes ----------------------------------------------------------------------------------------

SOLIDS = {
    "Cube": (Cube(2.0), 8.0, 1.0),
    "Tetrahedron": (Tetrahedron(radius=3**0.5), 8 / 3, 1.0),
    "Octahedron": (Octahedron(1.0), 4 / 3, 1.0),
    "Icosahedron": (Icosahedron(1.0), 2.5361507, 0.8506508),
    "Tube": (Tube(0.1, [[0, 0, 0], [0, 1, 0], [0, 2, 0]]), 0.06, 2.0),
    "TorusKnot": (TorusKnot(radius=1.0, tube_radius=0.1), 0.03 * 15.704, 1.6),
    "Mesh": (Mesh(points=[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]), 1 / 6, 1.0),
}


@pytest.mark.parametrize("name", SOLIDS)
def test_a_solid_has_its_volume_and_its_faces_look_outwards(name):
    shape, expected, reach = SOLIDS[name]
    vertices, faces = surface(shape.measured({}))
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    assert np.einsum("ij,ij->", a, np.cross(b, c)) / 6 == pytest.approx(expected, rel=2e-2)
    assert np.abs(vertices).max() == pytest.approx(reach, rel=5e-2)


def test_circles_and_planes_lie_in_x_and_y():
    for shape in (Circle(0.5), Plane(2.0, 1.0)):
        vertices, _ = surface(shape)
        assert not vertices[:, 2].any()
    assert np.ptp(surface(Plane(2.0, 1.0))[0], axis=0).tolist() == [2.0, 1.0, 0.0]


def test_a_length_may_be_a_symbol_and_a_colour_has_two_spellings():
    l = sm.Symbol("l")
    for made in (Cube(l), Circle(l), Octahedron(l), TorusKnot(l, l / 4), Tube(l, np.eye(3))):
        assert made.measured({l: 2.0}).lengths
    assert Cone(1, 2, color="navy") == Cone(1, 2, colour="navy")
    assert Torus(1.0, tube_radius=0.2, color=(1, 0, 0)).color == "#ff0000"
    with pytest.raises(TypeError, match="Sphere got `colour` and `color`, which mean the same"):
        Sphere(1.0, color="red", colour="blue")
    with pytest.warns(PyDyUserWarning, match="`material` of Sphere is ignored"):
        Sphere(1.0, material="metal")


def test_all_of_them_are_on_the_page():
    shapes = [shape for shape, _, _ in SOLIDS.values()] + [Circle(1.0)]
    scene = Scene(N, O, *[VisualizationFrame(N, O, shape) for shape in shapes])
    scene.animate([0.0, 1.0], np.zeros((2, 0)), symbols=[])
    assert scene.html().count('"vertices"') == len(shapes)


@pytest.mark.parametrize("given", [(), (N, O), (N, Sphere(1)), ("name", Sphere(1))])
def test_what_is_no_visualization_frame_is_refused(given):
    with pytest.raises(TypeError, match=r"VisualizationFrame takes|A Visual must be attached"):
        VisualizationFrame(*given)


def test_a_camera_needs_a_place_and_a_scene_knows_its_arguments():
    with pytest.raises(TypeError, match=r"A PerspectiveCamera takes \[name,\] frame, point"):
        PerspectiveCamera("camera", N)
    with pytest.raises(TypeError, match=r"Scene has no argument `tittle`. Did you mean `title`"):
        Scene(N, O, tittle="Pendulum")


def test_the_old_modules_hand_out_the_same_classes():
    from pydy.viz import camera, light, visualization_frame

    assert camera.PerspectiveCamera is PerspectiveCamera
    assert camera.OrthoGraphicCamera is OrthoGraphicCamera
    assert light.PointLight is PointLight
    assert visualization_frame.VisualizationFrame is VisualizationFrame


def test_generate_visualization_json_sets_the_motion_and_display_shows_it(rod, opened):
    scene, q, length = rod
    angles = np.linspace(0.0, 2.0, num=61)[:, None]
    scene.generate_visualization_json([q], [length], angles, [0.7], fps=20, outfile_prefix="rod")
    np.testing.assert_allclose(scene.times, np.arange(61) / 20)
    np.testing.assert_allclose(scene.poses[:, 0, 0, 0], np.cos(angles[:, 0]), atol=1e-15)
    scene.display()
    assert len(opened) == 1
    assert scene.display_ipython() is scene
    with pytest.raises(ValueError, match=r"`constant_values` must have 1 numbers.* got 2"):
        scene.generate_visualization_json([q], [length], angles, [0.7, 1.0])
    with pytest.raises(ValueError, match="`fps` must be"):
        scene.generate_visualization_json([q], [length], angles, [0.7], fps=0)


def test_generate_visualization_json_system_simulates():
    system = n_link_pendulum_on_cart(1)
    system.times = TIMES
    system.initial_conditions = {"q1": 0.4}
    bodies = system.eom_method.bodies
    shown = system.scene()
    scene = Scene(shown.reference_frame, shown.origin, *bodies)
    scene.generate_visualization_json_system(system, outfile_prefix="cart")
    assert len(scene.times) == len(TIMES)
    system.initial_conditions = {"q1": 0.8}
    before = scene.poses.copy()
    scene.generate_visualization_json_system(system)
    assert not np.array_equal(before, scene.poses)


@pytest.mark.parametrize(
    ("name", "remedy"),
    [
        ("create_static_html", r"Scene has no attribute .*: call `scene\.to_html\(path\)`"),
        ("remove_static_html", "one file, which you may delete"),
        ("generate_simulation_dict", r"`scene\.poses` holds the 4 x 4 matrices"),
        ("to_png", r"Scene has no attribute `to_png`: call `scene\.save\(path\)`"),
        ("no_such_thing", "Scene has no attribute `no_such_thing`.$"),
    ],
)
def test_methods_without_a_counterpart_name_the_remedy(rod, name, remedy):
    scene, _, _ = rod
    with pytest.raises(AttributeError, match=remedy):
        getattr(scene, name)


def test_transformation_matrices_are_those_of_the_scene(rod):
    scene, _, _ = rod
    visual = scene.visualization_frames[0]
    with pytest.raises(AttributeError, match=r"Visual has no attribute .*`scene\.poses`"):
        visual.generate_transformation_matrix(N, O)
    assert copy.copy(visual).name == "rod"
