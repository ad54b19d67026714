"""What a notebook shows, the notebooks of examples, and the guide's page: all of their code runs."""

from __future__ import annotations

import ast
import json
import xml.etree.ElementTree as ElementTree
from html.parser import HTMLParser

import kinegon
import pytest
from conftest import ROOT

NOTEBOOKS = sorted((ROOT / "python" / "examples").glob("*.ipynb"))


def test_figures_show_themselves():
    scene = kinegon.Scene.kind("four-bar")
    for shown in [scene, scene.solve(), scene.exercise(seed=1)]:
        bundle = shown._repr_mimebundle_()
        assert ElementTree.fromstring(bundle["image/svg+xml"]).tag.endswith("}svg")
        assert bundle["text/plain"] == repr(shown)
        # Letters are outlines: a notebook lacks the font.
        assert "<text" not in bundle["image/svg+xml"]


def test_the_workbench_stands_in_a_frame():
    class Frames(HTMLParser):
        frames: list[dict[str, str]] = []

        def handle_starttag(self, tag, attributes):
            self.frames.append({"tag": tag, **dict(attributes)})

    scene = kinegon.Scene.kind("four-bar").to_dict()
    scene["title"] = '"></iframe><script>alert(1)</script>'
    solution = kinegon.Scene(scene).solve()
    parser = Frames()
    parser.feed(solution.interactive(height=500)._repr_mimebundle_()["text/html"])
    (frame,) = parser.frames
    assert frame["tag"] == "iframe" and frame["srcdoc"] == solution.draw("html").replace(',"step":1}', ',"step":null}')
    assert "height: 500px" in frame["style"] and "allow-same-origin" not in frame["sandbox"]


def run(source: str, names: dict[str, object]) -> None:
    """Runs a cell, and shows the value of its last expression as a notebook does."""
    tree = ast.parse(source)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    if last is not None:
        shown = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
        getattr(shown, "_repr_mimebundle_", shown.__repr__)()


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebooks(path, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    names: dict[str, object] = {"__name__": "__main__"}
    for cell in cells:
        if cell["cell_type"] == "code":
            assert not cell["outputs"] and cell["execution_count"] is None, "notebooks are committed without outputs"
            run("".join(cell["source"]), names)


@pytest.mark.parametrize("page", ["docs/python.md", "docs/courses.md", "python/README.md", "README.md"])
def test_pages(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    before, *blocks = (ROOT / page).read_text(encoding="utf-8").split("```python\n")
    assert blocks
    names: dict[str, object] = {}
    for block in blocks:
        if not before.rstrip().rpartition("\n")[2].startswith("<!-- not run"):
            run(block.partition("```")[0], names)
        before = block


def test_stubs_name_what_there_is():
    stub = ast.parse((ROOT / "python/package/kinegon/_kinegon.pyi").read_text())
    from kinegon import _kinegon

    functions = [node.name for node in stub.body if isinstance(node, ast.FunctionDef)]
    assert all(callable(getattr(_kinegon, name)) for name in functions)
    typed = {"Form", "CheckOptions", "ExerciseOptions", "Wanted", "Notes"}
    for node in stub.body:
        if isinstance(node, ast.ClassDef) and node.name not in typed:
            told = {part.name for part in node.body if isinstance(part, ast.FunctionDef)} | {
                part.target.id for part in node.body if isinstance(part, ast.AnnAssign)
            }
            there = {name for name in vars(getattr(_kinegon, node.name)) if not name.startswith("_")}
            assert there == {name for name in told if not name.startswith("_")}, node.name
