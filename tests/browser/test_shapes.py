"""Every shape in the page, beside the same shape in NumPy."""

from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sm
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from pydy.viz import (
    Arrow,
    Box,
    Capsule,
    Cone,
    Cylinder,
    Damper,
    Line,
    Mesh,
    Plane,
    Scene,
    Sphere,
    Spring,
    Torus,
    Trace,
    Visual,
)
from waiting import until
from zoo import pictured

q, x = dynamicsymbols("q, x")
EVIL = "</script><img src=x onerror=alert(1)>"


@pytest.fixture(scope="module")
def zoo(tmp_path_factory):
    """One of each shape along each axis, all turning."""
    N, O = ReferenceFrame("N"), Point("O")
    B = N.orientnew("B", "Axis", (q, N.x + 2 * N.y + 3 * N.z))
    P = O.locatenew("P", x * N.x)
    tetrahedron = (
        [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
        [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
    )
    shapes = [Sphere(0.3), Box(0.3, 0.5, 0.7, opacity=0.5), Mesh(tetrahedron, scale=0.5)]
    for axis in "xyz":
        shapes += [
            Cylinder(0.8, 0.2, axis),
            Cone(0.8, 0.2, axis),
            Capsule(0.8, 0.2, axis),
            Torus(0.4, 0.1, axis),
            Plane(0.8, 0.4, axis),
        ]
    visuals = [
        Visual(shape, B, P.locatenew("s", (k % 6) * N.x + (k // 6) * N.y), name=f"{k} {EVIL}")
        for k, shape in enumerate(shapes)
    ]
    solids = len(visuals)
    Q = P.locatenew("Q", sm.sin(q) * N.z - N.y)
    visuals += [
        Visual(Arrow(x * B.y + N.z, scale=0.5, radius=0.02), P),
        Visual(Line([O, P, Q], radius=0.03)),
        Visual(Line([O, Q])),
        Visual(Trace(duration=0.5), Q),
        Visual(Trace(), P),
    ]
    times = np.linspace(0, 2, 41)
    states = np.stack([2 * times, np.sin(3 * times)], 1)
    scene = Scene(N, O, *visuals, title=EVIL, series={EVIL: x, "q": q})
    scene.animate(times, states, symbols=[q, x])
    path = scene.to_html(tmp_path_factory.mktemp("zoo") / "zoo.html")
    return SimpleNamespace(scene=scene, path=path, solids=solids)


def test_shapes_are_as_large_and_lie_as_in_numpy(zoo, open_page):
    page = open_page(zoo.path)
    page.evaluate("pydy.seek(0.95)")
    boxes = page.evaluate("pydy.boxes()")
    k = 19
    for item, box in zip(zoo.scene._animation.items, boxes, strict=True):
        triangles = item.surface(k)
        if triangles is None:
            assert box is None
            continue
        vertices = triangles[0]
        # Round shapes have more corners in the page: they reach a little further.
        expected = np.stack([vertices.min(0), vertices.max(0)])
        assert np.array(box) == pytest.approx(expected, abs=0.035), item.visual


def test_poses_are_numpys(zoo, open_page):
    page = open_page(zoo.path)
    for k in (0, 7, 40):
        page.evaluate(f"pydy.seek({zoo.scene.times[k]})")
        matrices = np.array(page.evaluate("pydy.matrices()")).reshape(-1, 4, 4)
        poses = matrices.transpose(0, 2, 1)[: zoo.solids]
        assert poses == pytest.approx(zoo.scene.poses[k, : zoo.solids], abs=1e-6)


def test_a_page_with_every_shape_shows_colours_and_no_text_escapes(zoo, open_page, screenshot):
    page = open_page(zoo.path, 1200, 800)
    page.evaluate("pydy.seek(1.3)")
    pixels = screenshot(page, "shapes")
    assert (np.ptp(pixels, axis=2) > 60).mean() > 0.01
    assert page.locator("#heading").inner_text() == EVIL
    assert page.locator("#legend-rows li span").first.inner_text() == f"0 {EVIL}"
    assert page.locator("#strip-labels li").first.inner_text().startswith(EVIL)
    assert page.evaluate("document.querySelectorAll('img').length") == 0


def test_an_iframe_as_in_a_notebook_shows_the_same(zoo, browser, tmp_path):
    outer = tmp_path / "notebook.html"
    outer.write_text(f"<!DOCTYPE html><body>{zoo.scene._repr_html_()}", encoding="utf-8")
    page = browser.new_page()
    errors = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(outer.as_uri())
    inner = page.frames[1]
    until(inner, "window.pydy && window.pydy.ready")
    assert len(inner.evaluate("pydy.positions()")) == len(zoo.scene.visuals)
    assert errors == []
    page.close()


@pytest.mark.parametrize("unit", [1e-25, 1e-9, 1e9, 1e11, 1e25])
def test_a_scene_looks_the_same_in_every_unit(unit, tmp_path, open_page, screenshot):
    def picture(unit):
        N, O = ReferenceFrame("N"), Point("O")
        B = N.orientnew("B", "Axis", (q, N.z))
        P = O.locatenew("P", x * N.x)
        Q = P.locatenew("Q", unit * B.y)
        shapes = [
            Visual(Box(0.1 * unit, 0.3 * unit, 0.2 * unit), B, Q),
            Visual(Arrow(x * B.y - unit * N.x, scale=0.5, radius=0.02 * unit), P),
            Visual(Line([O, P, Q], radius=0.03 * unit)),
            Visual(Trace(duration=0.5), Q),
        ]
        scene = Scene(N, O, *shapes, up="y")
        times = np.linspace(0, 2, 41)
        states = np.stack([2 * times, unit * np.sin(3 * times)], 1)
        scene.animate(times, states, symbols=[q, x])
        page = open_page(scene.to_html(tmp_path / f"{unit}.html"))
        page.evaluate("pydy.seek(0.95)")
        return screenshot(page, f"unit-{unit:g}", "#stage")

    differs = np.abs(picture(unit) - picture(1.0)).max(axis=-1) > 30
    assert differs.mean() < 3e-4  # pixels at edges


def test_dark_colours_are_seen_on_the_dark_page_and_others_stay(open_page, tmp_path):
    def luminance(colour):
        levels = np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)]) / 255
        linear = np.where(levels <= 0.04045, levels / 12.92, ((levels + 0.055) / 1.055) ** 2.4)
        return float(linear @ [0.2126, 0.7152, 0.0722])

    N, O = ReferenceFrame("N"), Point("O")
    x = dynamicsymbols("x")
    colours = ["#000080", "#000000", "#4c8bd9"]
    points = [O.locatenew(f"P{k}", (x + k) * N.x) for k, _ in enumerate(colours)]
    balls = [Visual(Sphere(0.1, colour=c), p) for c, p in zip(colours, points, strict=True)]
    scene = Scene(N, O, *balls).animate([0.0, 1.0], [[0.0], [1.0]], symbols=[x])
    dark_page = open_page(scene.to_html(tmp_path / "dark.html", theme="dark"))
    dark = dark_page.evaluate("pydy.colours()")
    dark_page.close()  # its animation would hold up the other
    page = open_page(scene.to_html(tmp_path / "light.html", theme="light"))
    light = page.evaluate("pydy.colours()")
    assert light == colours
    assert dark[2] == colours[2]
    paper = luminance("#171b21")
    for colour in dark[:2]:
        assert (luminance(colour) + 0.05) / (paper + 0.05) == pytest.approx(2.0, rel=0.05)


def test_springs_and_dampers_reach_from_point_to_point(open_page, tmp_path):
    scene = pictured.animated("Quarter of a car")
    page = open_page(scene.to_html(tmp_path / "car.html"))
    axle, car = scene.poses[-1, 0, 1, 3], scene.poses[-1, 1, 1, 3]
    page.evaluate(f"pydy.seek({scene.times[-1]})")
    boxes = page.evaluate("pydy.boxes()")
    for box, item in zip(boxes, scene._animation.items, strict=True):
        if isinstance(item.shape, (Spring, Damper)) and item.shape.points[1].name == "B":
            wire = 0.18 * item.shape.radius if isinstance(item.shape, Spring) else 0.0
            assert [box[0][1], box[1][1]] == pytest.approx([axle, car], abs=2 * wire + 1e-6)
