"""Tries to get marks for nothing: forms of invented numbers, and forms that play tricks.

    cheat.py KINEGON [--forms N] [--seed S] [--faults DIR] [--limits]

Forms for exercises of six kinds are checked as a teacher checks a class, `kinegon check EXERCISES FORMS --marks`, one mark for each value.
Each family of tricks has a line: marks earned, what the numbers deserve, the marks for following through, the best form, how many forms were
passed or refused, and of how many a cause was told.
Numbers deserve their marks that lie within what the key allows, which chance and the given numbers bring about. Where some are invented and
the others computed from these as they should be, the others deserve theirs, too: a mistake costs the value in which it was made, and an
invented point has two numbers.
No form may pass; a family must not earn more than it deserves by more than two of a hundred marks.
"""

import argparse
import collections
import json
import math
import random
import subprocess
import sys
import tempfile
import time
from decimal import Decimal, InvalidOperation
from pathlib import Path

from second import HANDS, draw, in_units
from second_task import Absurd, Task, exercises, key

KINDS = ("four-bar", "slider-crank", "slotted-lever", "watt-1", "fourth-class", "hydraulic-boom")
FAMILIES = {}


def family(f):
    FAMILIES[f.__name__.replace("_", "-")] = f
    return f


class Target:
    """An exercise to cheat in: what everybody sees of it, and the key to reckon with afterwards."""

    def __init__(self, folder):
        self.task, self.key, self.folder = Task(folder), key(folder), folder
        scene = json.loads((folder / "scene.json").read_text())
        self.given = sorted(set(numbers(scene)) - {0})
        self.rivals = []

    def head(self, **other):
        f = {"kinegon_measured": 1, "name": "cheat", "exercise": self.task.name, "positive": "counter-clockwise", "in": "mm"}
        f |= {f"mu_{k}": self.task.mu[k] for k in "lva"}
        return f | other

    def is_length(self, box):
        return box.startswith(("L(", "vplan", "aplan"))

    def crank(self):
        """What the given numbers say at once: the crank's velocity and acceleration, in millimetres."""
        t = self.task
        if not t.omega:
            return {}
        v = abs(t.omega) * t.lengths["AB"]
        return {"vplan(p,b)": v / t.mu["v"], "aplan(π,b)": v * abs(t.omega) / t.mu["a"]}

    def random(self, rng, box):
        """A number of the right order, as any book would have it."""
        if self.is_length(box):
            return round(rng.uniform(5, 160), 1)
        w = abs(self.task.omega or 0.2)
        size = w if box.startswith("omega") else w * w if box.startswith("alpha") else w * 60 if box.startswith("v_r") else w * w * 60
        return float(f"{rng.choice((1, -1)) * size * rng.uniform(0.05, 1.5):.3g}")

    def deserved(self, values, invented=None):
        """How many values of the form lie within what the key allows, or are worked out as they should be from those that are invented:
        `invented` has the boxes of what one invention costs, and how many of them."""
        if invented is not None:
            wrong = [b for b in values if not self.deserved({b: values[b]})]
            charged = sum(min(n, sum(b in wrong for b in boxes)) for boxes, n in invented)
            return len(values) - charged
        n = 0
        for box, value in values.items():
            try:
                half, value = in_units(self.task, box, half_digit(value)), in_units(self.task, box, float(value))
                off = abs(abs(value) - abs(self.key[box]["value"])) if self.is_length(box) else abs(value - self.key[box]["value"])
            except (TypeError, ValueError, KeyError, InvalidOperation):
                continue
            expected, allowed = abs(self.key[box]["value"]), self.key[box]["allowed"]
            n += off <= max(allowed, half) and expected > allowed and half <= max(expected / 4, allowed)
        return n


def half_digit(value):
    """Half a unit of the last digit of a text; of numbers nothing."""
    return 0.5 * 10.0 ** Decimal(value).as_tuple().exponent if isinstance(value, str) else 0.0


def numbers(x):
    if isinstance(x, dict):
        return [n for k, v in x.items() if k not in ("note", "figure", "kinegon") for n in numbers(v)]
    if isinstance(x, list):
        return [n for v in x for n in numbers(v)]
    return [x] if isinstance(x, (int, float)) else []


def plain(t, values, **head):
    return t.head(**head) | {"values": values}


def in_mm(t, values):
    """Values that are written in units of the scene, as they would be in millimetres of paper."""
    return {b: v / in_units(t.task, b, 1) for b, v in values.items()}


@family
def zeros(t, rng):
    zero = rng.choice(("0", "0.0", 0, "-0", "0 mm/s", "00", ".0"))
    return plain(t, {b: zero for b in t.task.boxes}), {}


@family
def exponents(t, rng):
    pool = rng.choice((["0e4"], ["1e300"], ["1e-300"], ["0e300"], ["0E9", "0e-9"], ["1e2"], ["1e1", "1e2", "1e3"], ["5e1", "2e2", "0e3"], ["0.0e5"],
                       ["1e2", "0e2"], ["0e1"], ["0e2", "-0e2"], ["9e99"]))
    values = {b: rng.choice(pool) for b in t.task.boxes}
    return plain(t, values), {b: v for b, v in values.items() if float(v) != 0}


@family
def absurd_scales(t, rng):
    k = 10 ** rng.choice((1, 2, 3, 5, 9, 100, 300))
    which = rng.choice(("lva", "v", "a", "va"))
    head = {f"mu_{c}": t.task.mu[c] * k for c in which}
    kind = rng.choice(("mm", "units"))
    values = {b: t.random(rng, b) for b in t.task.boxes}
    meant = in_mm(t, values) if kind == "units" else {b: v * k if t.is_length(b) and b[0].lower() in which else v for b, v in values.items()}
    return plain(t, values, **head, **{"in": kind}), meant


@family
def other_scales(t, rng):
    k = rng.choice((2, 2.5, 4, 5, 10, 0.1))
    values = {b: t.random(rng, b) for b in t.task.boxes}
    for box, v in t.crank().items():
        values[box] = round(v / k, 1)
    return plain(t, values, mu_v=t.task.mu["v"] * k, mu_a=t.task.mu["a"] * k), {b: v for b, v in t.crank().items()}


@family
def odd_scales(t, rng):
    odd = rng.choice((0, -1, "1e9", "", "2 mm", 1e-12, "inf", None, "nan", [2], 5e-324))
    return plain(t, {b: t.random(rng, b) for b in t.task.boxes}, **{rng.choice(("mu_l", "mu_v", "mu_a")): odd}), {}


@family
def blanks(t, rng):
    blank = rng.choice(("", " ", None, "-", "?", "n/a", "\u00a0"))
    return plain(t, {b: blank for b in t.task.boxes}), {}


@family
def removed_lines(t, rng):
    crank = {b: round(v, 1) for b, v in t.crank().items()}
    keep = rng.choice((crank, {}, dict(list(crank.items())[:1])))
    return plain(t, keep), keep


@family
def only_the_crank(t, rng):
    crank = {b: round(v, 1) for b, v in t.crank().items()}
    rest = rng.choice(("", "0", "0e2", "random", "1e1"))
    values = {b: crank.get(b, t.random(rng, b) if rest == "random" else rest) for b in t.task.boxes}
    return plain(t, values), values if rest == "random" else crank


@family
def copied_tolerances(t, rng):
    word = rng.choice(("{}", "±{}", "0±{}", "+-{}"))
    values = {b: word.format(float(f"{t.key[b]['allowed'] / (in_units(t.task, b, 1) or 1):.3g}")) for b in t.task.boxes}
    return plain(t, values), values


@family
def intervals(t, rng):
    word = rng.choice(("{}±{}", "{}..{}", "{}-{}", "{} to {}", "{} +- {}", "{},{}", "{};{}", "{}/{}", "[{}, {}]"))
    values = {b: word.format(rng.randint(1, 60), rng.randint(60, 300)) for b in t.task.boxes}
    return plain(t, values), {b: v.replace(",", ".") for b, v in values.items()}


UNITS = {"L": ("mm", "cm", "m", "in", "ft"), "vplan": ("mm/s", "m/s", "in/s", "ft/min", "cm/min"), "aplan": ("mm/s²", "m/s²", "in/min²", "ft/s²"),
         "omega": ("rad/s", "rpm", "deg/s"), "alpha": ("rad/s²", "deg/s²"), "v_r": ("mm/s", "ft/min"), "a_r": ("mm/s²", "m/min²")}
SIZES = {"mm": 1, "cm": 10, "m": 1000, "in": 25.4, "ft": 304.8, "rad": 1, "deg": math.pi / 180, "s": 1, "min": 1 / 60, "s²": 1, "min²": 1 / 3600}


def size_of(unit):
    over, _, under = unit.replace("rpm", "deg/s").partition("/")
    return SIZES[over] * (SIZES[under] if under else 1) * (6 if unit == "rpm" else 1)


@family
def unit_tricks(t, rng):
    values = {}
    for b in t.task.boxes:
        unit = rng.choice(UNITS[b.split("(")[0]])
        n = rng.choice((rng.randint(1, 200), 0, f"{rng.randint(1, 9)}e{rng.randint(0, 3)}", round(rng.uniform(0.1, 9), 1)))
        values[b] = {"value": n, "unit": unit}
    kind = rng.choice(("mm", "units"))
    meant = in_mm(t, {b: float(v["value"]) * size_of(v["unit"]) for b, v in values.items()})
    return plain(t, values, **{"in": kind}), meant


@family
def duplicate_keys(t, rng):
    head = json.dumps(t.head(), ensure_ascii=False)[:-1]
    lines = [f'{json.dumps(b, ensure_ascii=False)}: {rng.randint(1, 180)}' for b in t.task.boxes for _ in range(rng.choice((2, 5, 30)))]
    return head + ', "values": {' + ", ".join(lines) + "}}", {}


@family
def duplicate_lines(t, rng):
    rows = ["quantity,value,unit", f"exercise,{t.task.name},", *(f"mu_{k},{t.task.mu[k]}," for k in "lva"), "in,mm,"]
    rows += [f'"{b}",{rng.randint(1, 180)},' for b in t.task.boxes for _ in range(rng.choice((1, 2, 20)))]
    return "\n".join(rows), {}


@family
def synonyms(t, rng):
    """Many guesses at one value, by its other names."""
    values = {}
    for b in t.task.boxes:
        values[b] = t.random(rng, b)
        if t.is_length(b) and "," in b:
            kind, rest = b[:-1].split("(")
            x, y = rest.split(",")
            for name in (f"{kind}({y},{x})", f"{b}/mu", f"{kind}({y},{x})/mu", f"{kind}( {x} , {y} )", b.replace("π", "pi")):
                values[name] = t.random(rng, b)
    return plain(t, values), {b: values[b] for b in t.task.boxes}


@family
def extra_values(t, rng):
    """Right values that nobody asked for, beside invented ones."""
    values = {b: t.random(rng, b) for b in t.task.boxes}
    values |= {"omega(1)": t.task.omega or 0, "alpha(1)": 0} if t.task.omega else {}
    for pair, size in t.task.lengths.items():
        values[f"L({pair[0]},{pair[1]})"] = size / t.task.mu["l"]
    for g in t.task.ground:
        values |= {f"v({g}).size": 0, f"a({g}).size": 0, f"x({g})": t.task.ground[g][0]}
    return plain(t, values), {b: values[b] for b in t.task.boxes}


@family
def given_numbers(t, rng):
    values, kind = {b: rng.choice(t.given) for b in t.task.boxes}, rng.choice(("mm", "units"))
    return plain(t, values, **{"in": kind}), values if kind == "mm" else in_mm(t, values)


@family
def typical_values(t, rng):
    values = dict(draw(rng.choice(t.rivals), HANDS["careful"], rng.random())[1])
    values = {b: round(values.get(b, 0) or 0, 2) for b in t.task.boxes}
    values |= {b: round(v, 1) for b, v in t.crank().items()}
    return plain(t, values), values


@family
def random_values(t, rng):
    values = {b: t.random(rng, b) for b in t.task.boxes}
    return plain(t, values), values


@family
def right_order(t, rng):
    """Each value right to a factor: known how large, no more."""
    values = {}
    for b in t.task.boxes:
        mm = t.key[b]["value"] / in_units(t.task, b, 1)
        values[b] = float(f"{mm * math.exp(rng.gauss(0, 0.5)):.3g}")
    return plain(t, values), values


@family
def one_digit(t, rng):
    digits = {b: f"{t.random(rng, b):.0e}" for b in t.task.boxes}
    return plain(t, {b: d if rng.random() < 0.5 else f"{float(d):g}" for b, d in digits.items()}), digits


class Invented:
    """Marks points anywhere, and does all the rest as it should be done."""

    def __init__(self, rng, which):
        self.rng, self.which = rng, which

    def begin(self, sheet):
        pass

    def end(self, sheet, values):
        pass

    def touch(self, sheet, kind, where, f):
        if kind == "mark" and f["plan"] in self.which:
            d, r = self.rng.uniform(0, 2 * math.pi), self.rng.uniform(20, 120)
            f["xy"] = (r * math.cos(d), r * math.sin(d))


@family
def points_invented(t, rng):
    """Points anywhere, everything computed from them: all but the construction."""
    which = rng.choice(("v", "a", "va"))
    sheet, values = draw(t.task, HANDS["careful"], rng.random(), [Invented(rng, which)])
    values = {b: round(v, 1) if t.is_length(b) else v for b, v in values.items() if v is not None}
    return plain(t, values), values, inventions(t, sheet, which)


def inventions(t, sheet, which):
    """Of each point that was put anywhere the boxes that are read from it: two numbers."""
    made = []
    for kind, _, f in sheet.acts:
        if kind == "mark" and f["plan"] in which:
            point, plan = f["to"], f["plan"]
            read = {b for b in t.task.boxes if b.startswith(plan + "plan") and point in b[6:-1].split(",")}
            read |= {r["box"] for k, _, r in sheet.acts if k == "rate" and r.get("plan") == plan and point in r.get("ends", ())}
            made.append((read, 2))
    return made


@family
def rates_invented(t, rng):
    """Rates anywhere; segments, normal parts and rates that agree with them by v = ω L, a = ω² L. No drawing at all."""
    values = {b: t.random(rng, b) for b in t.task.boxes} | {b: round(v, 1) for b, v in t.crank().items()}
    omegas = {b[6:-1]: values[b] for b in t.task.boxes if b.startswith("omega")}
    computed = set(t.crank())
    for where, kind, f in [(w, k, f) for k, w, f in draw(t.task, HANDS["exact"], 1)[0].acts]:
        if kind == "rate" and f["segment"] is not None and f["box"] in values:
            a, b = f["ends"]
            size = abs(values[f["box"]]) * f["length"] / t.task.mu[f["plan"]]
            for name in (f"{f['plan']}plan({a},{b})", f"{f['plan']}plan({b},{a})"):
                if name in values:
                    values[name] = round(size, 1)
                    computed.add(name)
        if kind == "vector" and f["reason"] == "normal" and f["link"] in omegas:
            name = f"aplan({f['from']},{f['to']})"
            if name in values:
                values[name] = round(omegas[f["link"]] ** 2 * f["length"] / t.task.mu["a"], 1)
                computed.add(name)
    return plain(t, values), values, [({b}, 1) for b in values if b not in computed]


@family
def rest_from_one(t, rng):
    """The crank, its pole segments, and c at a place that makes one value right by chance; the second plan copied from a neighbour."""
    sheet, values = draw(t.task, HANDS["careful"], rng.random(), [Invented(rng, "v")])
    other = draw(rng.choice(t.rivals), HANDS["careful"], rng.random())[1]
    copied = {b for b in values if b.startswith(("aplan", "alpha", "a_r")) and b not in t.crank()}
    values = {b: other.get(b, v) if b in copied else v for b, v in values.items()}
    values = {b: round(v, 2) for b, v in values.items() if v is not None}
    return plain(t, values), values, inventions(t, sheet, "v") + [({b}, 1) for b in copied]


@family
def bad_hand(t, rng):
    """Guesses about the right values, so that the hand looks bad and much is allowed."""
    spread = rng.choice((0.15, 0.25, 0.4))
    values = {}
    for b in t.task.boxes:
        mm = t.key[b]["value"] / in_units(t.task, b, 1)
        values[b] = float(f"{mm * (1 + rng.gauss(0, spread)):.3g}")
    return plain(t, values), values


@family
def huge_radii(t, rng):
    radius, points, placed = rng.choice((1, 5, 50, 500, 1e6, 1e300)), {}, {}
    for plan, pole in (("velocity", "p"), ("acceleration", "π")):
        letter = "v" if plan == "velocity" else "a"
        names = {n for b in t.task.boxes if b.startswith(letter + "plan") for n in b[6:-1].split(",")}
        points[plan] = {n: [round(rng.uniform(-150, 150), 1), round(rng.uniform(-150, 150), 1), radius] for n in names | {pole}}
        points[plan][pole] = [0, 0, radius]
        if rng.random() < 0.3:
            points[plan] = {n: [0, 0, radius] for n in points[plan]}
        for b in t.task.boxes:
            if b.startswith(letter + "plan"):
                (x, y, _), (u, v, _) = (points[plan][n] for n in b[6:-1].split(","))
                placed[b] = math.hypot(x - u, y - v)
    values = rng.choice(({}, {b: t.random(rng, b) for b in t.task.boxes if not t.is_length(b)}, {b: "0e3" for b in t.task.boxes if not t.is_length(b)}))
    return plain(t, values) | {"points": points}, placed | values


@family
def another_name(t, rng):
    """The form of another exercise, or of none; and forms without sense of rotation."""
    f = plain(t, {b: t.random(rng, b) for b in t.task.boxes})
    trick = rng.choice(("none", "odd", "clockwise", "no sense", "unsigned"))
    if trick in ("none", "odd"):
        f["exercise"] = {"none": "", "odd": t.task.name + " "}[trick]
    elif trick == "clockwise":
        f["positive"] = "clockwise"
    else:
        f.pop("positive")
        f["values"] = {b: abs(v) if trick == "unsigned" else v for b, v in f["values"].items()}
    meant = {b: v if t.is_length(b) or trick != "clockwise" else -v for b, v in f["values"].items()}
    return f, meant


@family
def odd_numbers(t, rng):
    pool = ("NaN", "inf", "-inf", "1/0", "0x64", "1_00", "1.000.000", "١٠٠", "１００", "1e", "--5", "=A1", "true", "100!", "≈100", "<1000", ">0", "*", "100?")
    return plain(t, {b: rng.choice(pool) for b in t.task.boxes}), {}


@family
def extra_keys(t, rng):
    f = plain(t, {b: t.random(rng, b) for b in t.task.boxes})
    return f | rng.choice(({"passed": True}, {"marks": 100}, {"pencil_mm": 100}, {"tolerance": 1e9}, {"note": "all correct"}, {"in": "km"}, {"mode": 2},
                           {"accuracy": {"mm": 100}}, {"hand": "shaky"})), f["values"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kinegon")
    parser.add_argument("--forms", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--families")
    parser.add_argument("--faults", type=Path)
    parser.add_argument("--exercises", default="/tmp/second-cheat")
    parser.add_argument("--limits", action="store_true")
    options = parser.parse_args()
    targets = []
    for kind in KINDS:
        group = []
        for path in exercises(options.kinegon, kind, 21, 3, options.exercises):
            try:
                target = Target(path)
                target.task.position()
                group.append(target)
            except Absurd:
                continue
        for t in group:
            t.rivals = [o.task for o in group if o is not t]
        targets += group[:1]
    wanted = options.families.split(",") if options.families else list(FAMILIES)
    rng = random.Random(options.seed)
    with tempfile.TemporaryDirectory() as folder:
        folder, made = Path(folder), {}
        (folder / "forms").mkdir()
        for i in range(options.forms):
            name, t = wanted[i % len(wanted)], rng.choice(targets)
            try:
                form, values, *invented = FAMILIES[name](t, rng)
            except (Absurd, ZeroDivisionError):
                continue
            file = f"{i:05}-{t.task.name}." + ("json" if not isinstance(form, str) or form.startswith("{") else "csv")
            (folder / "forms" / file).write_text(form if isinstance(form, str) else json.dumps(form, ensure_ascii=False))
            made[file] = (name, t, t.deserved(values, *invented))
        (folder / "marks.json").write_text('{"kinegon_marks": 1}')
        begin = time.time()
        done = subprocess.run([options.kinegon, "check", options.exercises, str(folder / "forms"), "--marks", str(folder / "marks.json"),
                               "-o", str(folder / "report.jsonl")], capture_output=True, text=True)
        seconds = time.time() - begin
        if not (folder / "report.jsonl").exists():
            sys.exit(f"no report: exit {done.returncode}: {done.stderr[-2000:]}")
        rows = [json.loads(r) for r in (folder / "report.jsonl").read_text().splitlines()]
        print(f"{len(rows)} forms in {seconds:.1f} s, exit {done.returncode}")
        return show(rows, made, folder, options)


def show(rows, made, folder, options):
    sums, best, faults = collections.defaultdict(collections.Counter), {}, 0
    for row in rows:
        name, t, deserved = made[Path(row["file"]).name]
        s = sums[name]
        s["forms"] += 1
        if row.get("message"):
            s["refused"] += 1
            continue
        marks = row.get("marks", {"earned": 0, "of": 1, "follow_through": 0})
        of = marks["of"] or 1
        share = marks["earned"] / of
        s["earned"] += share
        s["deserved"] += deserved / of
        s["follow"] += marks["follow_through"] / of
        s["passed"] += row["passed"]
        s["told"] += "first" in row
        excess = share - deserved / of
        s["excess"] = max(s["excess"], excess)
        if row["passed"] or excess > best.get(name, (0.1,))[0]:
            best[name] = (excess + row["passed"], row["file"], marks, deserved)
    print(f"{'family, per cent of the marks':30} forms refused   earned deserved  follow   worst passed  told")
    for name, s in sums.items():
        n = max(s["forms"] - s["refused"], 1)
        print(f"{name:30} {s['forms']:5} {s['refused']:7} {s['earned'] / n * 100:8.1f} {s['deserved'] / n * 100:8.1f} {s['follow'] / n * 100:7.1f} "
              f"{s['excess'] * 100:7.0f} {s['passed']:6} {s['told'] / n * 100:5.0f}")
        faults += s["passed"] > 0 or (s["earned"] - s["deserved"]) / n > 0.02
    for name, (_, file, marks, deserved) in best.items():
        print(f"  {name}: {file}: {marks['earned']:g} of {marks['of']:g}, {marks['follow_through']:g} for following through, {deserved} deserved")
        if options.faults:
            options.faults.mkdir(parents=True, exist_ok=True)
            source = folder / "forms" / file if (folder / "forms" / file).exists() else folder / "forms" / Path(file).name
            (options.faults / f"cheat-{name}{source.suffix}").write_text(source.read_text())
    return 1 if faults and options.limits else 0


if __name__ == "__main__":
    sys.exit(main())
