#!/usr/bin/env python3
"""What one sheet earns in different systems: `kinegon check`, the page (SCORM), Moodle, Canvas and Python.

    python3 tests/courses/marks_compared.py target/release/kinegon             the table of docs/courses.md; some minutes
    python3 tests/courses/marks_compared.py KINEGON --sheets 10 --limit 5      fewer, and an exit code of 1 where a mean difference is larger

Sheets of four kinds are drawn by the hands of tests/students, which share nothing with Kinegon: a quarter without mistakes, half with one,
a quarter with two, none of them made for a catalogue. Each is marked by the same scheme, the exercise's own, and in per cent: by the
program, by the numbers in the files for Moodle and Canvas, read back by the importers' rules (read.py) and applied as these systems do, by
the package for Python where it is installed, and by the page's engine where $KINEGON_WASM is a folder with it and node is there.

For each system: the mean and the largest of the differences from `kinegon check`, and the share of sheets that differ by more than 10 points.
"""
import argparse
import json
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).parent
sys.path[:0] = [str(HERE), str(HERE.parent / "students")]
import mistakes as m
import read
from hand import HANDS, Hand, draw, form

KINDS = ["four-bar", "slider-crank", "slotted-lever", "watt-1"]
SEED = 11
SCHEME = '{ "kinegon_marks": 1 }'
PER_EXERCISE = 10

# What a student does wrong, by act. Acts that a mechanism does not have are left out.
ACTS = {
    "crank omega": [m.times(m.RPM), m.times(6.283), m.wrong_sense],
    "crank length": [m.times(2), m.times(0.5)],
    "v_B direction": [m.quarter_back, m.opposite, m.turned(15)],
    "a_B normal": [m.without_square("omega(1)"), m.times(2), m.digits_exchanged],
    "a_B direction": [m.opposite, m.quarter_back],
    "velocity ray 2": [m.quarter_back, m.turned(12)],
    "velocity ray 3": [m.quarter_back, m.turned(-12)],
    "velocity ray guide": [m.turned(90), m.turned(10)],
    "acceleration ray 2": [m.quarter_back, m.turned(12)],
    "acceleration ray 3": [m.quarter_back],
    "acceleration ray 2 from": [m.at("acceleration", "b")],
    "measure vplan(b,c)": [m.in_mm("velocity"), m.times(0.9), m.ruler("velocity", 10)],
    "measure vplan(b,b_3)": [m.times(0.9), m.ruler("velocity", 10)],
    "omega(2)": [m.times(0.7), m.wrong_sense, m.times(1 / m.RPM)],
    "omega(3)": [m.times(0.7), m.wrong_sense, m.digits_exchanged],
    "omega(4)": [m.times(1.4), m.wrong_sense],
    "omega(2) length": [m.times(2), m.instead(1000)],
    "normal 2": [m.forgotten, m.without_square("omega(2)"), m.digits_exchanged, m.times(2)],
    "normal 3": [m.forgotten, m.without_square("omega(3)"), m.times(0.5)],
    "normal 2 direction": [m.opposite, m.quarter_back],
    "normal 3 direction": [m.opposite],
    "coriolis": [m.forgotten, m.times(0.5), m.times(2)],
    "coriolis direction": [m.opposite],
    "alpha(2) length": [m.times(2), m.instead(1000)],
    "write alpha(2)": [m.wrong_sense, m.times(1e-3)],
    "write alpha(3)": [m.wrong_sense, m.digits_exchanged],
    "write omega(3)": [m.times(m.DEGREES_PER_RADIAN), m.times(1 / m.RPM)],
    "write v_r(3/ground)": [m.wrong_sense],
}


def sheet(kind, scene, number):
    """The form of a sheet, and the mistakes in it."""
    chance = random.Random(f"{kind} {scene['title']} {number}")
    wanted = [0, 1, 1, 2][number % 4]
    hand = Hand(**HANDS[chance.choice(["fine", "pencil"])], seed=chance.random())
    while True:
        acts = {act: chance.choice(ACTS[act]) for act in chance.sample(list(ACTS), wanted)}
        try:
            return form(draw(kind, scene, hand, acts)), list(acts)
        except (ValueError, ZeroDivisionError, OverflowError, StopIteration):
            # This mechanism has no such act, or it cannot be gone on with.
            continue


def run(kinegon, *arguments, codes=(0,)):
    done = subprocess.run([kinegon, *map(str, arguments)], capture_output=True, text=True, encoding="utf-8", check=False)
    if done.returncode not in codes:
        raise SystemExit(f"kinegon {arguments[0]}: {done.stderr}")


def percent(earned, of):
    return 100 * earned / of if of else 100.0


def in_fields(fields, values):
    """What numbers earn in fields of (weight, answers): of each the first answer that is near enough."""
    earned = 0.0
    for name, weight, answers in fields:
        if name in values:
            near = [a for a in answers if abs(values[name] - a["value"]) <= a["tolerance"] * (1 + 1e-9)]
            earned += weight * (near[0]["percent"] / 100 if near else 0)
    return percent(earned, sum(weight for _, weight, _ in fields))


def fields_of(kinegon, kind, count, folder, names):
    """By system and exercise: the fields as its importer has them."""
    for system, ending in (("moodle", "xml"), ("canvas", "zip")):
        run(kinegon, "exercise", kind, "--seed", SEED, "--count", count, "--lms", system, "-o", folder / f"{kind}.{ending}")
    moodle = read.moodle(folder / f"{kind}.xml")["questions"]
    canvas = read.canvas(folder / f"{kind}.zip")["quizzes"]
    for asked, question, quiz in zip(names, moodle, canvas):
        items = [item for item in quiz["items"] if item["answers"]]
        assert len(asked) == len(question["fields"]) == len(items), (len(asked), len(question["fields"]), len(items))
        points = [(float(item["metadata"]["points_possible"]), item["answers"]) for item in items]
        yield {
            "Moodle": [(name, field["weight"], field["answers"]) for name, field in zip(asked, question["fields"])],
            "Canvas": [(name, *own) for name, own in zip(asked, points)],
        }


def by_page(jobs):
    """The marks that the page's engine gives; none where it is not there."""
    engine = os.environ.get("KINEGON_WASM")
    if engine is None:
        return None
    told = json.dumps([[scene, json.dumps(filled)] for scene, filled in jobs])
    done = subprocess.run(["node", HERE / "page_marks.mjs", engine, SCHEME], input=told, capture_output=True, text=True, encoding="utf-8", check=True)
    return [percent(*pair) for pair in json.loads(done.stdout)]


def by_python(jobs):
    """The marks that the package for Python gives; none where it is not installed."""
    try:
        import kinegon
    except ImportError:
        return None
    marks = (kinegon.Scene(scene).solve().check(json.dumps(filled), marks=SCHEME).result["marks"] for scene, filled in jobs)
    return [percent(own["earned"], own["of"]) for own in marks]


def compared(kinegon, kind, sheets):
    """By system: the marks of all sheets of a kind, in per cent; with the mistakes on each."""
    found = {"check": [], "Moodle": [], "Canvas": []}
    jobs, acts = [], []
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        count = -(-sheets // PER_EXERCISE)
        run(kinegon, "exercise", kind, "--seed", SEED, "--count", count, "-o", folder)
        own = [folder / f"{kind}-{SEED}-{number}" for number in range(1, count + 1)]
        keys = [list(json.loads((each / "key.json").read_text("utf-8"))["values"]) for each in own]
        scheme = folder / "marks.json"
        scheme.write_text(SCHEME, "utf-8")
        for each, names, fields in zip(own, keys, fields_of(kinegon, kind, count, folder, keys)):
            scene = (each / "scene.json").read_text("utf-8")
            forms = each / "forms"
            forms.mkdir()
            for number in range(min(PER_EXERCISE, sheets - len(jobs))):
                filled, made = sheet(kind, json.loads(scene), number)
                # What is not asked for has no box.
                filled["values"] = {name: filled["values"][name] for name in names}
                filled["exercise"] = each.name
                (forms / f"{number:03}.json").write_text(json.dumps(filled), "utf-8")
                values = {name: float(value) for name, value in filled["values"].items()}
                for system in ("Moodle", "Canvas"):
                    found[system].append(in_fields(fields[system], values))
                jobs.append((scene, filled))
                acts.append(made)
            run(kinegon, "check", each / "scene.json", forms, "--marks", scheme, "-o", each / "report.json", codes=(0, 1))
            report = json.loads((each / "report.json").read_text("utf-8"))
            found["check"] += [percent(row["marks"]["earned"], row["marks"]["of"]) for row in report["rows"]]
    for system, marks in (("page", by_page(jobs)), ("Python", by_python(jobs))):
        if marks is not None:
            found[system] = marks
    return found, acts


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kinegon")
    parser.add_argument("--sheets", type=int, default=200, help="of each kind")
    parser.add_argument("--limit", type=float, help="largest mean difference of Moodle and Canvas")
    parser.add_argument("--show", type=int, default=0, help="this many of the largest differences of each system, with the acts that were wrong")
    args = parser.parse_args()
    is_near = True
    print("| sheets of | marks by `check` | system | mean | largest | over 10 points |\n|---|---|---|---|---|---|")
    for kind in KINDS:
        found, acts = compared(args.kinegon, kind, args.sheets)
        right = found.pop("check")
        for system, marks in found.items():
            differences = [own - check for own, check in zip(marks, right)]
            mean = sum(map(abs, differences)) / len(differences)
            largest = max(differences, key=abs)
            far = 100 * sum(abs(difference) > 10 for difference in differences) / len(differences)
            print(f"| {kind} | {sum(right) / len(right):.0f} % | {system} | {mean:.1f} | {largest:+.0f} | {far:.0f} % |")
            if args.limit is not None and mean > (args.limit if system in ("Moodle", "Canvas") else 0.05):
                is_near = False
            for index in sorted(range(len(marks)), key=lambda i: -abs(differences[i]))[:args.show]:
                print(f"    {index}: check {right[index]:.0f}, {system} {marks[index]:.0f}: {', '.join(acts[index])}", file=sys.stderr)
    return 0 if is_near else 1


if __name__ == "__main__":
    sys.exit(main())
