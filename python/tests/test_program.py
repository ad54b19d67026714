"""Package and program of the wheel write the same bytes; what the program writes is tested with it."""

from __future__ import annotations

import csv
import io
import json
import os
import subprocess
import sys

import kinegon
import numpy
import pytest
from conftest import ROOT


def test_version(program):
    assert program("--version").decode() == f"kinegon {kinegon.__version__}\n"
    run = subprocess.run([sys.executable, "-m", "kinegon", "--version"], capture_output=True, check=True)
    assert run.stdout == program("--version")


def test_exit_codes(program, tmp_path):
    program("draw", tmp_path / "none.json", code=2)
    program("no-such-command", code=2)


@pytest.mark.parametrize("format", ["svg", "png", "pdf", "tikz", "html"])
def test_figures(program, figure_2, tmp_path, format):
    ending = {"tikz": "tex"}.get(format, format)
    # A page has the scene's text inside, to which options are added in the program's order or in that of the keywords.
    options, keywords = ([], {}) if format == "html" else (["--language", "es", "--page", "a3"], {"language": "es", "page": "a3"})
    program("draw", figure_2, "-o", tmp_path / f"program.{ending}", *options)
    kinegon.Scene.read(figure_2).solve().save(tmp_path / f"package.{ending}", **keywords)
    own, other = [(tmp_path / f"{name}.{ending}").read_bytes() for name in ["package", "program"]]
    assert own == other


@pytest.mark.parametrize("format", ["gif", "apng"])
def test_films(program, tmp_path, format):
    kinegon.Scene.kind("four-bar").save(tmp_path / "scene.json")
    own, other = [tmp_path / f"{name}.{format}" for name in ["package", "program"]]
    program("draw", tmp_path / "scene.json", "-o", other, "--seconds", 1, "--fps", 5, "--dpi", 40, "--style", "lecture")
    solution = kinegon.Scene.read(tmp_path / "scene.json").solve()
    solution.save(own, seconds=1, fps=5, dpi=40, style="lecture")
    assert own.read_bytes() == other.read_bytes()
    assert solution.draw(format, seconds=1, fps=5, dpi=40, style="lecture") == other.read_bytes()


def test_steps_styles_and_work_sheets(program, figure_2, tmp_path):
    solution = kinegon.Scene.read(figure_2).solve()
    program("draw", figure_2, "-o", tmp_path / "a.svg", "--upto", 14)
    assert solution.draw(step=14) == (tmp_path / "a.svg").read_text()
    program("draw", figure_2, "-o", tmp_path / "b.svg", "--layered", "--outlines")
    assert solution.draw(layered=True, outlines=True) == (tmp_path / "b.svg").read_text()
    style = {"kinegon_style": 1, "based_on": "board", "background": "#000000"}
    (tmp_path / "own.json").write_text(json.dumps(style))
    program("draw", figure_2, "-o", tmp_path / "c.svg", "--style", tmp_path / "own.json")
    assert solution.draw(style=style) == (tmp_path / "c.svg").read_text()
    assert solution.draw(style=tmp_path / "own.json") == (tmp_path / "c.svg").read_text()
    program("draw", figure_2, "-o", tmp_path / "d.svg", "--worksheet", "--style", "print")
    solution.save(tmp_path / "e.svg", worksheet=True, style="print")
    sheets = sorted(path.name for path in tmp_path.glob("[de]*.svg"))
    assert sheets == ["d-2.svg", "d.svg", "e-2.svg", "e.svg"] or sheets == ["d.svg", "e.svg"]
    for name in [name for name in sheets if name.startswith("d")]:
        assert (tmp_path / name).read_bytes() == (tmp_path / f"e{name[1:]}").read_bytes()


def test_numbers_and_texts(program, figure_2):
    scene = kinegon.Scene(figure_2)
    solution = scene.solve()
    assert solution.result() == json.loads(program("solve", figure_2))
    assert solution.digits() == program("solve", figure_2, "--digits").decode()
    steps = solution.steps()
    assert str(steps) == program("steps", figure_2).decode()
    assert [step.number for step in steps] == list(range(1, len(steps) + 1)) and steps[0].panel == "scheme"
    assert solution.steps(pencil_mm=0.1).text == program("steps", figure_2, "--pencil-mm", 0.1).decode()
    assert scene.structure() == program("structure", figure_2).decode()
    listed = program("modes", figure_2).decode()
    assert all(mode.text.splitlines()[0] in listed for mode in scene.modes())


def test_tables(program, figure_2):
    table = kinegon.Scene.read(figure_2).sweep(60, 80, 0.5)
    rows = list(csv.reader(io.StringIO(program("sweep", figure_2, "--from", 60, "--to", 80, "--step", 0.5).decode())))
    assert rows[0] == table.names
    numpy.testing.assert_array_equal(numpy.array(rows[1:], float), table.to_numpy())


def test_checks(program, figure_2, tmp_path):
    form = ROOT / "examples" / "paper-as-student.json"
    solution = kinegon.Scene.read(figure_2).solve()
    check = solution.check(form, depth=5)
    printed = program("check", figure_2, form, "--depth", 5, "--json", code=0 if check.is_passed else 1)
    assert check.result == json.loads(printed)
    assert str(check) == program("check", figure_2, form, "--depth", 5, code=0 if check.is_passed else 1).decode()
    assert solution.form() == program("check", figure_2, "--template").decode()
    assert solution.form("csv") == program("check", figure_2, "--template", "csv").decode()
    program("check", figure_2, form, "--depth", 5, "--draw", tmp_path, code=0 if check.is_passed else 1)
    assert check.draw() == (tmp_path / "paper-as-student-check.svg").read_text()
    assert check.draw("png", sheet=2) == (tmp_path / "paper-as-student-check-values.png").read_bytes()
    assert "<!DOCTYPE html>" in check.feedback()[:20]
    right = solution.check({"omega(4)": -0.4747, "omega(2)": float(solution.quantity("omega(2)"))})
    wrong = solution.check({"omega(4)": 0.9})
    verdicts = [[value["verdict"] for value in check.result["values"]] for check in (right, wrong)]
    assert verdicts == [["right", "within-tolerance"], ["off"]]
    # Two values are not all that the scene asks for.
    assert not right.is_passed and not wrong.is_passed and "omega(5)" in right.result["missing"]
    four_bar = kinegon.Scene.kind("four-bar").solve()
    (value,) = four_bar.check({"omega(3)": float(four_bar.quantity("omega(3)"))}).result["values"]
    assert four_bar.quantity("omega(3)").value > 0 and value["verdict"] == "right"


def test_exercises(program, tmp_path):
    program("exercise", "four-bar", "--seed", 7, "--count", 2, "-o", tmp_path / "program", "--language", "es")
    found = kinegon.Scene.kind("four-bar").exercises(7, language="es")
    for exercise, _ in zip(found, range(2)):
        folder = exercise.save(tmp_path / "package")
        for path in (tmp_path / "program" / exercise.name).iterdir():
            assert path.read_bytes() == (tmp_path / "package" / exercise.name / path.name).read_bytes(), path.name
        with pytest.raises(kinegon.KinegonError, match="is not overwritten"):
            exercise.save(tmp_path / "package")
        assert exercise.scene.solve().check(json.loads(exercise.form()) | values(exercise)).is_passed
    assert exercise.name == "four-bar-7-2" and folder.endswith("four-bar-7-2")


def values(exercise):
    """A form filled in with the key."""
    return {"values": {name: entry["value"] for name, entry in exercise.key()["values"].items()}}


def test_importing_takes_no_time():
    def seconds(code):
        """Of the processor, not of the clock: others work on the machine, too."""
        before = os.times()
        subprocess.run([sys.executable, "-c", code], check=True)
        after = os.times()
        return after.children_user + after.children_system - before.children_user - before.children_system

    own, bare = (min(seconds(code) for _ in range(5)) for code in ["import kinegon", "pass"])
    assert own - bare < 0.1


def test_drawings(program, tmp_path):
    scene, drawing = tmp_path / "scene.json", tmp_path / "drawing.json"
    kinegon.Scene.kind("four-bar").save(scene)
    solution = kinegon.Scene.read(scene).solve()
    own = solution.drawing()
    assert own.encode() == program("steps", scene, "--drawing")
    assert solution.check(own).is_passed
    wrong = json.loads(own)
    ray = next(entry for entry in wrong["did"] if entry.get("line") == "r1")
    ray["along"] = {"parallel": "B,C"}
    drawing.write_text(json.dumps(wrong))
    check = solution.check(wrong)
    assert json.loads(program("check", scene, drawing, "--json", code=1)) == check.result
    first = check.drawing["first_wrong"]
    assert check.drawing["entries"][first]["mistake"] == "turned-ray" and not check.is_passed
    assert str(check) == program("check", scene, drawing, code=1).decode()
