"""A question for PrairieLearn that is marked by `kinegon check`: every variant has numbers of its own, a mistake costs the value in which it
was made and not what follows, and the student hears what probably went wrong.

The course needs `pip install kinegon` where questions run. KIND is any kind of `kinegon new`, or give a scene of your own.
"""

import json

import kinegon

KIND = "four-bar"
# Every box is worth what the exercise says: a rate two marks, what leads to it one.
SCHEME = '{ "kinegon_marks": 1 }'


def exercise(data):
    return kinegon.Scene.kind(KIND).exercise(int(data["variant_seed"]))


def generate(data):
    own = exercise(data)
    form = json.loads(own.form())
    units = [value["unit"] for value in own.key()["values"].values()]
    named = enumerate(zip(form["values"], units), 1)
    data["params"]["scene"] = own.scene.text
    data["params"]["form"] = own.form()
    data["params"]["boxes"] = [{"box": f"box{number}", "quantity": name, "unit": unit} for number, (name, unit) in named]


def file(data):
    """The student's sheets, as the page asks for them: sheet.svg, sheet.pdf."""
    return exercise(data).sheet(data["filename"].rpartition(".")[2], outlines=True)


def written(data):
    """What stands in the boxes, by the names of the quantities; digits stay as they are, for they say how surely something was read."""
    answers = data["submitted_answers"]
    return {box["quantity"]: (answers.get(box["box"]) or "").strip().replace(",", ".") for box in data["params"]["boxes"]}


def parse(data):
    for box, text in zip(data["params"]["boxes"], written(data).values()):
        try:
            float(text or "0")
        except ValueError:
            data["format_errors"][box["box"]] = "This is no number."


def grade(data):
    form = {**json.loads(data["params"]["form"]), "values": written(data)}
    data["score"] = 0
    if not any(form["values"].values()):
        return
    result = kinegon.Scene(data["params"]["scene"]).solve().check(json.dumps(form), marks=SCHEME).result
    marks = result["marks"]
    data["score"] = marks["earned"] / marks["of"]
    data["feedback"]["marks"] = f"{marks['earned']:g} of {marks['of']:g} marks"
    data["feedback"]["mistakes"] = [mistake["done"] for mistake in result["diagnosis"]["mistakes"]]
