"""What goes wrong is told as the library tells it."""

from __future__ import annotations

import json

import kinegon
import pytest
from conftest import ROOT

# A case begins with `== NAME`; `-- MESSAGE` ends it.
BAD = (ROOT / "tests" / "bad_scenes.txt").read_text().split("\n== ")[1:]


def test_bad_scenes(tmp_path):
    assert len(BAD) > 100
    for case in BAD:
        name, rest = case.split("\n", 1)
        text, message = rest.rsplit("-- ", 1)
        scene = tmp_path / f"{name}.json"
        scene.write_text(text)
        with pytest.raises(kinegon.SceneError) as refused:
            kinegon.Scene.read(scene).solve()
        error = refused.value
        assert str(error) == message.rstrip(), name
        assert isinstance(error, ValueError) and error.message in str(error)
        if error.line is not None:
            assert str(error).startswith(f"{error.line}:{error.column}: ")


def test_a_dict_has_no_lines():
    scene = kinegon.Scene.kind("four-bar").to_dict()
    del scene["links"]["2"]["lengths"]
    with pytest.raises(kinegon.SceneError) as refused:
        kinegon.Scene(scene)
    error = refused.value
    assert (error.line, error.path) == (None, "links.2") and "points B and C" in error.message and error.hint.startswith("add ")
    assert str(error).startswith("links.2: ")


def test_each_stage_has_its_class():
    scene = kinegon.Scene.kind("four-bar")
    with pytest.raises(kinegon.QuantityError, match="there is no link `9`"):
        scene.solve().quantity("omega(9)")
    far = scene.to_dict()
    far["links"]["2"]["lengths"]["BC"] = 20
    with pytest.raises(kinegon.AssemblyError):
        kinegon.Scene(far).solve()
    flat = {
        "kinegon": 1,
        "units": {"length": "mm", "time": "s"},
        "ground": ["A", "D"],
        "points": {"A": [0, 0], "B": [60, 0], "C": [110, 0], "D": [160, 0]},
        "links": {"1": {"points": ["A", "B"], "drive": {"omega": 10}}, "2": ["B", "C"], "3": ["C", "D"]},
    }
    with pytest.raises(kinegon.MotionError, match="BC and CD lie in one line"):
        kinegon.Scene(flat).solve()
    with pytest.raises(kinegon.KinegonError, match="the nearest is `four-bar`"):
        kinegon.Scene.kind("fourbar")
    with pytest.raises(kinegon.CheckError):
        scene.solve().check({"omega(9)": 1})
    with pytest.raises(ValueError, match="mode cannot be 0; hint: a whole number from 1 on"):
        scene.solve(mode=0)


def test_files(tmp_path):
    with pytest.raises(FileNotFoundError):
        kinegon.Scene(tmp_path / "none.json")
    with pytest.raises(FileNotFoundError):
        kinegon.Scene("none.json")
    (tmp_path / "latin.json").write_bytes('{ "title": "Quérétaro" }'.encode("latin-1"))
    with pytest.raises(kinegon.SceneError, match="not text in UTF-8: byte 14"):
        kinegon.Scene(tmp_path / "latin.json")
    for text in ["", " ", "[]\n", "{"]:
        with pytest.raises(kinegon.SceneError):
            kinegon.Scene(text)


def test_figures():
    solution = kinegon.Scene.kind("four-bar").solve()
    for options, message in [
        ({"format": "bmp"}, "the formats are svg, png, pdf, tikz, html"),
        ({"format": "pdf", "layered": True}, "only SVG has layers"),
        ({"dpi": 1e9, "format": "png"}, "dpi must be from 10 to 2400"),
        ({"sheet": 2}, "sheets 1 to 1"),
        ({"step": 99}, "there is no step 99"),
        ({"language": "xx"}, "figure.language"),
        ({"colour": "red"}, "figure.colour: unknown key"),
        ({"trace": ["Z"]}, "figure.trace"),
        ({"style": "papr"}, "figure.style"),
        ({"style": {"kinegon_style": 1, "pens": {"rays": {}}}}, "did you mean `ray`"),
    ]:
        with pytest.raises(kinegon.KinegonError, match=message):
            solution.draw(**options)


def test_what_is_no_film():
    solution = kinegon.Scene.kind("four-bar").solve()
    for options, message in [
        ({"seconds": 0}, "cannot last 0 seconds"),
        ({"fps": 51}, "cannot have 51 pictures a second"),
        ({"drive": "9"}, "there is no drive `9`"),
        ({"dpi": 5}, "dpi must be from 10 to 2400"),
        ({"step": 3}, "a film shows the finished figure"),
    ]:
        with pytest.raises(kinegon.KinegonError, match=message):
            solution.draw("gif", **options)


def test_nothing_half_written(tmp_path):
    solution = kinegon.Scene.kind("four-bar").solve()
    with pytest.raises(kinegon.KinegonError, match="no format for files ending in `.bmp`"):
        solution.save(tmp_path / "figure.bmp")
    with pytest.raises(FileNotFoundError):
        solution.save(tmp_path / "none" / "figure.svg")
    (tmp_path / "folder.svg").mkdir()
    with pytest.raises(OSError):
        solution.save(tmp_path / "folder.svg")
    assert [path.name for path in tmp_path.iterdir()] == ["folder.svg"]


def test_numpy_in_a_scene():
    import numpy

    scene = kinegon.Scene.kind("four-bar").to_dict()
    plain = kinegon.Scene(scene).solve().result()
    scene["ground"]["D"] = numpy.array([160, 0])
    scene["links"]["1"]["lengths"]["AB"] = numpy.float32(60)
    assert kinegon.Scene(scene).solve().result() == plain
    scene["links"]["1"]["lengths"]["AB"] = object()
    with pytest.raises(kinegon.KinegonError, match="object cannot stand in JSON"):
        kinegon.Scene(scene)
    scene["links"]["1"]["lengths"]["AB"] = float("nan")
    with pytest.raises(kinegon.SceneError):
        kinegon.Scene(scene)
    assert json.loads(kinegon.Scene.kind("four-bar").text)["kinegon"] == 1


def test_what_is_no_json():
    within: dict[str, object] = {}
    within["links"] = within
    for odd in [within, {("a", "b"): 1}, {"kinegon": 10**5000}]:
        with pytest.raises(kinegon.KinegonError, match="cannot be written as JSON"):
            kinegon.Scene(odd)
    with pytest.raises(kinegon.SceneError, match="half of one"):
        kinegon.Scene('{ "title": "\ud800" }')
    solution = kinegon.Scene.kind("four-bar").solve()
    with pytest.raises(kinegon.KinegonError, match="figure.mu_v: nan is not a number"):
        solution.draw(mu_v=float("nan"))
    with pytest.raises(kinegon.KinegonError):
        solution.draw(trace=[float("nan")])


def test_a_number_is_no_file(tmp_path):
    """Python would read the file that is open with that number."""
    (tmp_path / "scene.json").write_text(kinegon.Scene.kind("four-bar").text)
    with open(tmp_path / "scene.json") as file:
        for read in [kinegon.Scene, kinegon.Scene.read, kinegon.Study]:
            with pytest.raises(TypeError):
                read(file.fileno())


def test_numbers_of_modes_sheets_and_exercises():
    scene = kinegon.Scene.kind("four-bar")
    solution = scene.solve()
    for refused, message in [
        (lambda: scene.sweep(mode=0), "mode cannot be 0"),
        (lambda: scene.solve(mode=-1), "mode cannot be -1"),
        (lambda: scene.exercise(seed=-1), "seed cannot be -1"),
        (lambda: scene.exercise(seed=1, number=0), "number cannot be 0"),
        (lambda: solution.check({"omega(3)": 1}, depth=-1), "depth is from 1 to 6"),
        (lambda: solution.check({"omega(3)": 1}).draw(sheet=7), "there is no sheet 7"),
        (lambda: solution.form("xml"), "there is no form `xml`"),
        (lambda: solution.save("a.svg", format="pdf"), "ending gives the format"),
        (lambda: scene.sweep(want=[3]), "names of quantities and drives are texts"),
    ]:
        with pytest.raises(kinegon.KinegonError, match=message):
            refused()
