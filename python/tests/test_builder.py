"""Scenes put together in Python are those of files, with the same messages."""

from __future__ import annotations

import json

import kinegon
import pytest
from conftest import ROOT


def crank() -> kinegon.Builder:
    builder = kinegon.Builder("mm", "s", title="Offset slider-crank").ground("A", [0, 0])
    builder.link("1", ["A", "B"], lengths={"AB": 50}, drive={"omega": 10, "angle": 60})
    builder.link("2", ["B", "C"], lengths={"BC": 150}).link("3", ["C"])
    return builder.slider("3", "C", on="ground", through=[0, -20], along=0).near("C", [160, -20])


def test_a_slider_crank_moves_as_its_closed_form():
    from math import cos, radians, sin, sqrt

    scene = crank().scene()
    x, y = 50 * cos(radians(60)), 50 * sin(radians(60))
    vx, vy = -10 * y, 10 * x
    run = sqrt(150**2 - (y + 20) ** 2)
    speed = vx - (y + 20) * vy / run
    found = scene.solve().quantity("v(C).x")
    assert found.value == pytest.approx(speed, rel=1e-12) and found.unit == "mm/s"


def test_it_is_the_scene_of_its_file():
    text = """{ "kinegon": 1, "title": "Offset slider-crank", "units": { "length": "mm", "time": "s" },
        "ground": { "A": [0, 0] },
        "links": {
            "1": { "points": ["A", "B"], "lengths": { "AB": 50.0 }, "drive": { "omega": 10, "angle": 60 } },
            "2": { "points": ["B", "C"], "lengths": { "BC": 150 } },
            "3": { "points": ["C"] } },
        "sliders": [{ "link": "3", "at": "C", "on": "ground", "through": [0, -20], "along": 0 }],
        "near": { "C": [160, -20] } }"""
    own, file = crank(), json.loads(text)
    assert own.to_dict() == file
    assert kinegon.Scene(file) == kinegon.Scene(file) != kinegon.Scene.kind("four-bar")
    # Builders write their keys in an order of their own.
    assert kinegon.Scene(own.to_dict()) == own.scene() and hash(own.scene()) == hash(crank().scene())


def test_all_keys():
    """A pin in a slot that is driven, shapes, rough angles, a drawn configuration."""
    slotted = kinegon.Builder("m", "s").ground("A", [0, 0]).ground("D", [0, -2])
    slotted.link("1", ["A", "B"], lengths={"AB": 1}, drive={"omega": 2, "angle": 30}).link("3", shape={"D": 0, "E": [4, 0]})
    slotted.pin("B", on="3", along="DE").near_angle("3", 80).figure(language="es").figure(page="a3").want("omega(3)").form({"omega(3)": 2})
    scene = slotted.scene()
    assert scene.to_dict()["figure"] == {"language": "es", "page": "a3"} and scene.to_dict()["form"] == {"omega(3)": 2}
    # The lever points from D to B: tan φ₃ = (2 + sin φ₁) / cos φ₁.
    assert scene.solve().quantity("omega(3)").value == pytest.approx(2 * (1 + 2 * 0.5) / (1 + 4 + 4 * 0.5), rel=1e-12)

    drawn = kinegon.Builder("mm", "s").ground("A").ground("D").point("A", [0, 0]).point("B", [30, 0]).point("C", [60, 40]).point("D", [90, 0])
    drawn.link("1", ["A", "B"], motion={"at": "A", "velocity": [0, 0], "omega": 1}).link("2", ["B", "C"]).link("3", ["C", "D"])
    assert drawn.scene().solve().quantity("v(B).y").value == pytest.approx(30)


def test_messages_are_those_of_files():
    with pytest.raises(kinegon.SceneError) as refused:
        crank().near("K", [0, 0]).scene()
    assert refused.value.path == "near.K"
    slip = kinegon.Builder("mm", "s").ground("A", [0, 0])
    slip.link("1", ["A", "B"], lengths={"AB": 50}, drive={"omga": 10, "angle": 60})
    with pytest.raises(kinegon.SceneError, match="did you mean `omega`") as refused:
        slip.scene()
    assert refused.value.path == "links.1.drive.omga" and refused.value.line is None
    with pytest.raises(kinegon.SceneError, match="links.2: key `2` stands twice; hint: keep one of them"):
        crank().link("2", ["B", "C"])
    with pytest.raises(TypeError, match="lenghts"):
        crank().link("4", ["C", "E"], lenghts={"CE": 3})


def test_what_is_equal():
    scene = kinegon.Scene.kind("four-bar")
    again = kinegon.Scene(scene.to_dict())
    assert scene == again and hash(scene) == hash(again) and scene.name != again.name and scene != "four-bar"
    assert scene.with_figure(language="es") != scene
    assert scene.solve() == scene.solve() != scene.solve(mode=1) and len({scene.solve(), scene.solve()}) == 1
    assert scene.exercise(seed=1) == scene.exercise(seed=1) != scene.exercise(seed=2)
    table, check = scene.sweep(want=["omega(3)"]), scene.solve().check({"omega(3)": 2.5})
    assert table == scene.sweep(want=["omega(3)"]) != scene.sweep(want=["omega(2)"])
    assert check == scene.solve().check({"omega(3)": 2.5}) != scene.solve().check({"omega(3)": 2.6})
    for odd in (table, check):
        with pytest.raises(TypeError, match="unhashable"):
            hash(odd)
    study = ROOT / "examples" / "studies" / "four-bar.json"
    assert kinegon.Study(study) == kinegon.Study(study) and hash(kinegon.Study(study)) == hash(kinegon.Study(study))
