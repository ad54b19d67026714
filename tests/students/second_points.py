"""Sheets of the second hand handed in by the places of their points, beside the same sheets with typed lengths.

    second_points.py KINEGON [--sheets N] [--honest N] [--faults DIR]

Directions count in places: a vector laid off turned by 180° or 90°, an image on the wrong side, a plan drawn mirrored. The rates are typed
in both. Each kind has two lines, judged as in `second_judge.py`; a mirrored plan is named where the report says so.
"""

import argparse
import cmath
import collections
import json
import random
import sys
import tempfile
from pathlib import Path

import second_outside  # noqa: F401 - registers its kinds
from second import HANDS
from second_judge import OUTCOMES, Drawn, check, judge, line, lot, tasks, told_of
from second_mechanisms import MECHANISMS

DIRECTED = ("turned-vector", "reversed-vector", "normal-outward", "coriolis-turned", "coriolis-along-guide", "mirrored-image", "turned-ray",
            "vector-from-wrong-point", "ray-from-wrong-point", "normal-forgotten", "image-turned-90", "vector-askew", "sign-of-x",
            "sine-for-cosine", "protractor-misread", "crossing-misplaced")


def by_places(drawn, sheet, rng, turned=0.0, mirrored=None, radius=0.25):
    """The form with places of points in place of lengths."""
    form = {k: v for k, v in drawn.form.items() if k != "values"}
    form["values"] = {b: v for b, v in drawn.form["values"].items() if not b.startswith(("vplan", "aplan"))}
    form["points"] = {}
    for plan, name, pole in (("v", "velocity", "p"), ("a", "acceleration", "π")):
        wanted = {n for b in drawn.task.boxes if b.startswith(plan + "plan") for n in b[6:-1].split(",")}
        wanted = [n for n in sorted(wanted) if sheet.same(n) != "0"] + [pole]
        origin = complex(rng.uniform(80, 200), rng.uniform(80, 150))
        turn = cmath.rect(1, turned)
        places = {}
        for n in wanted:
            z = complex(*sheet.point(plan, n))
            z = origin + (z.conjugate() if mirrored == plan else z) * turn + complex(rng.gauss(0, 0.1), rng.gauss(0, 0.1))
            places[n] = [round(z.real, 2), round(z.imag, 2)] + ([radius] if radius else [])
        form["points"][name] = places
    return form


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kinegon")
    parser.add_argument("--sheets", type=int, default=10)
    parser.add_argument("--honest", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kinds")
    parser.add_argument("--hands", default="careful,usual,usual,shaky")
    parser.add_argument("--faults", type=Path)
    parser.add_argument("--exercises", default="/tmp/second-exercises")
    options = parser.parse_args()
    table, hands = tasks(options.kinegon, list(MECHANISMS), options.exercises), options.hands.split(",")
    if options.faults:
        options.faults.mkdir(parents=True, exist_ok=True)
    totals = {"typed": collections.Counter(), "places": collections.Counter()}
    print(f"{'in per cent':34} {'sheets':>5} " + " ".join(f"{o:>8}" for o in OUTCOMES))
    with tempfile.TemporaryDirectory() as folder:
        for name in options.kinds.split(",") if options.kinds else DIRECTED:
            rng, rows = random.Random(f"{options.seed} {name} places"), {w: collections.Counter() for w in totals}
            for _ in range(options.sheets * 25):
                if sum(rows["typed"].values()) == options.sheets:
                    break
                drawn = lot(rng, table, hands, [name])
                if not drawn:
                    continue
                sheet = drawn.sheet
                typed, places = drawn.form, by_places(drawn, sheet, rng)
                for way, form in (("typed", typed), ("places", places)):
                    drawn.form = form
                    report = check(options.kinegon, drawn, folder, way)
                    outcome, _ = judge(drawn, report)
                    rows[way][outcome] += 1
                    if way == "places" and outcome not in ("named", "located"):
                        told = " + ".join(f"{t['mistake']}@{t['step']}" for t in told_of(report)) or "nothing"
                        p = report["diagnosis"]["probability"]
                        print(f"    {outcome}: {drawn.task.kind} {drawn.hand.name}: {told} ({p:.2f}); made {drawn.mistakes[0].places}")
                        if options.faults:
                            n = len(list(options.faults.glob(f"places-{outcome}-{name}-*")))
                            note = f"{outcome}; made: {drawn.mistakes[0].places}; told: {told}"
                            path = options.faults / f"places-{outcome}-{name}-{n}.json"
                            path.write_text(json.dumps({**form, "name": note}, ensure_ascii=False, indent=1))
            for way, row in rows.items():
                totals[way] += row
                print(line(f"  {name} {way}", row))
        for way, row in totals.items():
            print(line(way, row))
        honest(options, table, hands, folder)


def honest(options, table, hands, folder):
    """Right sheets by places, lying turned or not; and right plans drawn mirrored."""
    rng = random.Random(f"{options.seed} places honest")
    rows = collections.defaultdict(collections.Counter)
    for i in range(options.honest):
        task, steps = rng.choice(table)
        drawn = Drawn(task, steps, HANDS[rng.choice(hands)], rng.randrange(1 << 30), [])
        kind = ("straight", "turned by 6°", "turned by 90°", "velocity mirrored", "acceleration mirrored", "without radius")[i % 6]
        turned = {"turned by 6°": 0.1, "turned by 90°": 1.5708}.get(kind, 0.0)
        mirrored = kind[0] if "mirrored" in kind else None
        drawn.form = by_places(drawn, drawn.sheet, rng, turned, mirrored, None if kind == "without radius" else 0.25)
        report = check(options.kinegon, drawn, folder, "honest")
        off = sum(v["verdict"] == "off" for v in report["values"])
        told = " + ".join(f"{t['mistake']}@{t['step']}" for t in told_of(report))
        rows[kind].update(sheets=1, told=bool(told), off=bool(off), passed=report["passed"], mirrored=bool(report.get("mirrored")))
        rows[kind][told] += bool(told)
    for kind, row in rows.items():
        print(f"{kind:24}", ", ".join(f"{k} {v}" for k, v in row.items() if k))


if __name__ == "__main__":
    sys.exit(main())
