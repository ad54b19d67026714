"""Examples in which a course's system computes: their grader is the check."""

from __future__ import annotations

import importlib.util
import json
import sys

import pytest
from conftest import ROOT

HAND = ROOT / "tests" / "students"


def module(path, name):
    spec = importlib.util.spec_from_file_location(name, path)
    made = importlib.util.module_from_spec(spec)
    sys.modules[name] = made
    spec.loader.exec_module(made)
    return made


hand = module(HAND / "hand.py", "hand")
server = module(ROOT / "examples" / "prairielearn" / "server.py", "prairielearn_server")


class Variant:
    """A variant of the question, with the dictionary that PrairieLearn hands to its functions."""

    def __init__(self, seed=7):
        self.data = {"params": {}, "correct_answers": {}, "submitted_answers": {}, "format_errors": {}, "partial_scores": {}, "feedback": {}}
        self.data |= {"score": 0.0, "variant_seed": seed, "options": {}}
        server.generate(self.data)
        # PrairieLearn keeps it as JSON.
        self.data["params"] = json.loads(json.dumps(self.data["params"]))
        self.scene = json.loads(self.data["params"]["scene"])

    def drawn(self, acts=None):
        """The values of a sheet that somebody else draws, exact but for mistakes."""
        drawing = hand.draw("four-bar", self.scene, hand.Hand(digits=4), acts)
        return hand.form(drawing)["values"]

    def submit(self, values):
        boxes = self.data["params"]["boxes"]
        self.data["submitted_answers"] = {box["box"]: values.get(box["quantity"], "") for box in boxes}
        self.data["feedback"] = {}
        server.parse(self.data)
        if not self.data["format_errors"]:
            server.grade(self.data)
        return self.data["score"]


def test_a_right_sheet_has_all_marks():
    variant = Variant()
    assert variant.submit(variant.drawn()) == 1
    assert variant.data["feedback"]["mistakes"] == []
    decimal_comma = {name: text.replace(".", ",") for name, text in variant.drawn().items()}
    assert variant.submit(decimal_comma) == 1


def test_a_mistake_costs_the_value_in_which_it_was_made():
    variant = Variant()
    worth = variant.scene["form"]
    assert list(worth) and set(worth.values()) == {1, 2}
    # ω of the coupler not squared in its normal part: all accelerations behind it are wrong, and follow.
    wrong = variant.drawn({"normal 2": lambda value, drawing: value / abs(drawing.rates["omega(2)"])})
    right = variant.drawn()
    assert sum(wrong[name] != right[name] for name in worth) > 3
    all_marks = sum(worth.values())
    assert variant.submit(wrong) == pytest.approx((all_marks - worth["aplan(b,n_bC)"]) / all_marks)
    assert "ω_2" in variant.data["feedback"]["mistakes"][0]


def test_what_is_blank_earns_nothing():
    variant = Variant()
    assert variant.submit({}) == 0
    right, worth = variant.drawn(), variant.scene["form"]
    half = {name: text for name, text in right.items() if name.startswith("omega")}
    assert variant.submit(half) == pytest.approx(sum(worth[name] for name in half) / sum(worth.values()))


def test_what_is_no_number_is_told_and_not_marked():
    variant = Variant()
    variant.submit({**variant.drawn(), "omega(2)": "three"})
    names = {box["quantity"]: box["box"] for box in variant.data["params"]["boxes"]}
    assert list(variant.data["format_errors"]) == [names["omega(2)"]]
    assert variant.data["score"] == 0


def test_variants_have_numbers_of_their_own_and_their_sheets():
    one, again, other = Variant(3), Variant(3), Variant(4)
    assert one.scene == again.scene != other.scene
    sheet = server.file({**one.data, "filename": "sheet.svg"})
    assert "<svg" in sheet
    assert server.file({**one.data, "filename": "sheet.pdf"}).startswith(b"%PDF")


def test_the_page_has_a_box_for_each_value():
    page = (ROOT / "examples" / "prairielearn" / "question.html").read_text("utf-8")
    boxes = Variant().data["params"]["boxes"]
    assert len({box["box"] for box in boxes}) == len(boxes) > 8
    assert all("{{" + key + "}}" in page for key in boxes[0])
    assert json.loads((ROOT / "examples" / "prairielearn" / "info.json").read_text("utf-8"))["type"] == "v3"


def marked(tmp_path, change=None):
    """What nbgrader gives for the notebook, as it is, or with the values changed."""
    nbclient = pytest.importorskip("nbclient")
    nbformat = pytest.importorskip("nbformat")
    pytest.importorskip("ipykernel")
    notebook = nbformat.read(ROOT / "python" / "examples" / "nbgrader.ipynb", as_version=4)
    nbformat.validate(notebook)
    if change is not None:
        cell = next(cell for cell in notebook.cells if cell.id == "values")
        cell.source = change(cell.source)
    nbclient.NotebookClient(notebook, timeout=120, resources={"metadata": {"path": str(tmp_path)}}).execute()
    assert (tmp_path / "four-bar-7-1.pdf").read_bytes().startswith(b"%PDF")
    marks = notebook.cells[-1]
    # nbgrader takes the cell's value; where it is installed, it is asked.
    given = float(next(output for output in marks.outputs if output.output_type == "execute_result")["data"]["text/plain"])
    if importlib.util.find_spec("nbgrader") is not None:
        from nbgrader.utils import determine_grade

        assert determine_grade(marks) == (given, 10)
    return given


def test_a_notebook_is_graded(tmp_path):
    assert marked(tmp_path) == 10
    # α of the rocker with the other sign: two of 16 marks.
    wrong = marked(tmp_path, lambda source: source.replace('"alpha(3)": 22.7', '"alpha(3)": -22.7'))
    scene = json.loads(server.exercise({"variant_seed": 7}).scene.text)
    assert wrong == pytest.approx(10 * (1 - scene["form"]["alpha(3)"] / sum(scene["form"].values())), abs=0.01)
    # As the student gets it: a cell that fails earns nothing.
    with pytest.raises(Exception, match="the form is empty: it has no values to check"):
        marked(tmp_path, lambda source: source.partition("    ### BEGIN")[0] + "}")
