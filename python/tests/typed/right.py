"""A user's program, which type checkers take as it stands."""

import pathlib
from typing import Literal

import kinegon
from kinegon.types import Result, SceneFile, StudyFile

scene = kinegon.Scene.kind("four-bar")
solution = scene.solve()

svg: str = solution.draw(style="lecture", language="es", notation="german", values="m", panels=["velocity"], mu_v=None)
page: str = scene.draw("html", step=3)
png: bytes = solution.draw("png", dpi=200, sheet=1)
own: bytes = solution.draw("pdf", style=pathlib.Path("own.json"))
by_dict: str = solution.draw("tikz", style={"kinegon_style": 1, "ink": "#112233", "pens": {"link": {"width": 0.5}}})
schools: str = solution.draw(sliding="points", coriolis="C", frame="0", turned="clockwise")
film: bytes = solution.draw("gif", seconds=2, fps=10, drive="1")
solution.save("figure.svg", layered=True, coarse=True, outlines=False, page="a3")


def drawn(format: Literal["svg", "pdf"]) -> str | bytes:
    return scene.draw(format)


result: Result = solution.result()
omega: float = result["links"]["3"]["omega"]
error: float | None = result["links"]["3"].get("omega_error")
classes: list[str] = [group["class"] for group in result["groups"]]
unit: str = result["units"]["length"]

exercise = scene.exercise(seed=7, language="en", worksheet=False)
allowed: float | None = exercise.key()["values"]["omega(3)"].get("allowed")
sheet: str = exercise.sheet()
sheets: list[bytes] = exercise.sheets("png", dpi=100)
key_sheet: bytes = exercise.key_sheet("pdf")

check = solution.check({"omega(3)": 2.5}, marks={"kinegon_marks": 1, "each": 2})
earned: float | None = check.result["marks"]["earned"] if "marks" in check.result else None
said: list[str] = [mistake["done"] for mistake in check.result["diagnosis"]["mistakes"]]
over: str = check.draw(outlines=True)

file: SceneFile = {
    "kinegon": 1,
    "units": {"length": "mm", "time": "s"},
    "ground": {"A": [0, 0], "D": (160, 0)},
    "links": {
        "1": {"points": ["A", "B"], "lengths": {"AB": 60}, "drive": {"angle": 60, "omega": 10}},
        "2": {"points": ["B", "C"], "lengths": {"BC": 140}},
        "3": {"points": ["D", "C"], "lengths": {"CD": 110}},
    },
    "near": {"C": [155, 110]},
}
study: StudyFile = {
    "kinegon_study": 1,
    "scene": file,
    "vary": {"2.BC": {"plus_minus": 5}},
    "count": 3,
    "cycle": {"from": 0, "to": 360, "step": 5},
    "want": {"omega(3)": ["max", "min"]},
}
rows: int = len(kinegon.Study(study).rows())
again: kinegon.Scene = kinegon.Scene(file).with_figure(language="es", style="board")
