"""Draws sheets with the second hand, has `kinegon check` judge them, and says how right it is.

    second_judge.py KINEGON [--sheets N] [--honest N] [--seed S] [--kinds a,b] [--tasks a,b] [--faults DIR] [--jobs N]

A sheet has one mistake of `second_mistakes.py` or `second_outside.py` at a place by lot, two of the list, or none. Only sheets count on
which the mistake moves some value to at least 1.5 times (shaky hands: 2.5 times) what the key allows. A sheet is

named      every mistake is told by its name at its place, nothing false beside it
located    told is `unknown` at its place, or as beginning to show at the first value that it moves, nothing false beside it
pointed    nothing is told, and the first value that is off is the first that the mistake moves
honest     nothing is told, and values are off
misnamed   a wrong name at the right place
wrong      something told where no mistake was made
silent     nothing is told and no value is off

The place of a mistake is the step at which it was made, and any step up to that of the first value which it moves, back to the value
before that, except steps whose own value is right.
"""

import argparse
import collections
import concurrent.futures
import json
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import second_outside  # noqa: F401 - registers its kinds
from second import HANDS, draw, form, in_units
from second_mechanisms import MECHANISMS
from second_mistakes import KINDS, Mistake
from second_task import Absurd, Task, exercises, key

BINS = (0.5, 0.65, 0.78, 0.89, 0.95, 1.0001)
OUTCOMES = ("named", "located", "pointed", "honest", "misnamed", "wrong", "silent")


class Steps:
    """Where the acts of a sheet stand among the numbered steps of the construction."""

    def __init__(self, kinegon, task):
        printed = subprocess.run([kinegon, "steps", str(task.folder / "scene.json")], capture_output=True, text=True, check=True).stdout
        self.key = key(task.folder)
        self.of = {f"rate:{b}": e["step"] for b, e in self.key.items()}
        self.of |= {f"box:{b}": e["step"] for b, e in self.key.items()}
        plan, number = "L", 0
        for line in printed.splitlines():
            if line.startswith("Velocity plan"):
                plan = "v"
            elif line.startswith("Acceleration plan"):
                plan = "a"
            elif m := re.match(r" *(\d+)\. (.*)", line):
                number = int(m[1])
                self.step(plan, number, m[2])
            elif m := re.match(r" +(\S+) (\S+) = ", line):
                self.of.setdefault(f"{plan}:vector:{m[1]}>{m[2]}", number)
                self.of.setdefault(f"{plan}:vector:{m[2]}>{m[1]}", number)

    def step(self, plan, number, words):
        for pattern, where in ((r"Draw the ray through (\S+) .*; (\S+) lies on it", "{}:ray:{}>{}"), (r"Mark (\S+) where", "{}:mark:{}"),
                               (r"Divide .* there is (\w+)\.", "{}:divide:{}"), (r"Measure the segment from (\S+) to ([^.]+)", "{}:segment:{}-{}"),
                               (r"Measure the length from (\S+) to ([^.]+)", "{}:{},{}"), (r"(S\d+), special point", "{}:special:{}")):
            if m := re.match(pattern, words):
                self.of.setdefault(where.format(plan, *m.groups()), number)

    def place(self, where):
        if m := re.fullmatch(r"([va]):segment:(.*)-(.*)", where):
            for a, b in ((m[2], m[3]), (m[3], m[2])):
                box = f"{m[1]}plan({a},{b})"
                if box in self.key:
                    return self.key[box]["step"]
        return self.of.get(where)


class Drawn:
    """A sheet that was drawn, with what is true of it."""

    def __init__(self, task, steps, hand, seed, mistakes, one_digit=0):
        self.task, self.steps, self.hand, self.mistakes = task, steps, hand, mistakes
        _, right = draw(task, hand, seed)
        self.sheet, wrong = draw(task, hand, seed, mistakes)
        self.form = form(task, wrong, hand, "second hand")
        if one_digit:
            self.form["values"] = {b: f"{float(v):.{one_digit}g}" if v else v for b, v in self.form["values"].items()}
            self.form["values"] = {b: f"{float(v):.10g}" if v else v for b, v in self.form["values"].items()}
        self.moved = {}
        for box, value in wrong.items():
            off = 0.0 if value is None else abs(in_units(task, box, float(value)) - in_units(task, box, float(right[box])))
            self.moved[box] = off / steps.key[box]["allowed"] if steps.key[box].get("allowed") else 0.0
        self.scale = 1.7 if hand.name == "shaky" else 1.0

    def shows(self):
        return max(self.moved.values()) >= 1.5 * self.scale

    def first(self):
        """The first value that is plainly moved."""
        return next((b for b, m in self.moved.items() if m >= self.scale), None)

    def whole(self):
        return any(not m.places for m in self.mistakes)

    def truth(self, mistake):
        """The steps at which this mistake may rightly be told."""
        shown = getattr(mistake, "shown", None) or self.first()
        first = self.steps.key[shown]["step"] if shown else 0
        if not mistake.places:
            return range(0, first + 1)
        before = [self.steps.key[b]["step"] for b in self.moved if self.steps.key[b]["step"] < first]
        begins = [p for p in map(self.steps.place, mistake.places) if p is not None] + [max(before, default=0) + 1]
        return range(min(begins), max(first, min(begins)) + 1)

    def at_place(self, told, mistake):
        step = told["step"]
        if step in map(self.steps.place, mistake.places):
            return True
        if step == 0:
            return (told["mistake"] in mistake.kind.accept or not mistake.places or self.first() == next(iter(self.moved))
                    or str(mistake.site).startswith("L:"))
        if not mistake.places and step <= self.steps.of.get("v:vector:p>b", 0):
            return True
        if step not in self.truth(mistake):
            return False
        own = [b for b, e in self.steps.key.items() if e["step"] == step and b in self.moved]
        return not own or max(self.moved[b] for b in own) > 0.3

    def one(self, told, mistake):
        """How one told mistake answers one that was made."""
        here = self.at_place(told, mistake)
        if here and told["mistake"] in mistake.kind.accept:
            return "named"
        if here:
            return "located" if told["mistake"] == "unknown" else "misnamed"
        return "located" if told["mistake"] == "unknown" and self.shows_first(told) else "wrong"

    def shows_first(self, told):
        """Whether an unknown mistake is told to begin to show at the first value that is moved."""
        shown = [plain_name(q) for q in told.get("written", []) + told["follows"]]
        steps = [self.steps.key[q]["step"] for q in shown if q in self.steps.key]
        return bool(steps) and self.first() and min(steps) == self.steps.key[self.first()]["step"]

    def answers(self, told):
        """What each told mistake is, against the best of those made."""
        order = ("named", "located", "misnamed", "wrong")
        return [min((self.one(t, m) for m in self.mistakes), key=order.index) if self.mistakes else "wrong" for t in told]


def plain_name(quantity):
    """A quantity as the form calls it: a point of the ground under a slider is the pole, and places give directions, too."""
    return re.sub(r"\w+_ground", "p" if quantity[0] == "v" else "π", quantity).removesuffix(".angle")


def told_of(report):
    told = list(report["diagnosis"]["mistakes"])
    common = report.get("common")
    if common:
        told.insert(0, {"mistake": "common-scale" if "scale" in common else "common-zero", "step": 0, "done": str(common), "follows": []})
    return told


def judge(drawn, report):
    """The outcome of a sheet, and whether what was told with its probability is true."""
    told = told_of(report)
    off = [v["quantity"] for v in report["values"] if v["verdict"] == "off"]
    off = [plain_name(q) for q in off]
    if not told:
        if not off:
            return "silent" if not report.get("missing") else "honest", None
        first = next(v["step"] for v in report["values"] if v["verdict"] == "off")
        pointed = off[0] == drawn.first() or all(drawn.at_place({"mistake": "", "step": first}, m) for m in drawn.mistakes)
        return ("pointed" if pointed else "honest"), None
    alternatives = [told] + [list(o["mistakes"]) for o in report["others"] if o.get("indistinguishable")]
    best = None
    for alternative in alternatives:
        answers = drawn.answers(alternative)
        named = {m.kind.name for m in drawn.mistakes if any(drawn.one(t, m) == "named" for t in alternative)}
        if "wrong" in answers:
            outcome = "wrong"
        elif "misnamed" in answers:
            outcome = "misnamed"
        elif len(named) == len(drawn.mistakes):
            outcome = "named"
        else:
            outcome = "located"
        if best is None or OUTCOMES.index(outcome) < OUTCOMES.index(best):
            best = outcome
    return best, best in ("named", "located")


def probabilities(report):
    total = report["diagnosis"]["probability"] if report["diagnosis"]["mistakes"] else 0.0
    return total + sum(o["probability"] for o in report["others"]
                       if not o.get("indistinguishable") and not o.get("within") and o["mistakes"])


def check(kinegon, drawn, folder, number):
    path = Path(folder) / f"{number}.json"
    path.write_text(json.dumps(drawn.form, ensure_ascii=False))
    done = subprocess.run([kinegon, "check", str(drawn.task.folder / "scene.json"), str(path), "--json"], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        raise SystemExit(f"{path}: {done.stderr}")
    return json.loads(done.stdout)


def check_variants(options, table, folder):
    """Sheets with the numbers of a neighbour's exercise, checked beside the exercises of their class."""
    rng, forms, row = random.Random(f"{options.seed} variants"), Path(folder) / "variants", collections.Counter()
    forms.mkdir()
    for i in range(options.sheets * 20):
        drawn = lot(rng, table, options.hands.split(","), ["another-exercise"]) if len(list(forms.iterdir())) < options.sheets * 4 else None
        if drawn:
            (forms / f"{i}.json").write_text(json.dumps(drawn.form, ensure_ascii=False))
    out = Path(folder) / "variants.jsonl"
    subprocess.run([options.kinegon, "check", options.exercises, str(forms), "-o", str(out)], capture_output=True)
    for line in out.read_text().splitlines():
        entry = json.loads(line)
        told = [m["mistake"] for m in [entry.get("first") or {}, *entry.get("further", [])] if m]
        row["named" if entry.get("values_of") else "wrong" if told else "silent" if entry["passed"] else "honest"] += 1
    return row


def lot(rng, table, hands, kinds, two=False):
    """A sheet by lot with one mistake of these kinds, or two; None where it cannot be made or does not show."""
    task, steps = rng.choice(table)
    hand, seed = HANDS[rng.choice(hands)], rng.randrange(1 << 30)
    try:
        right, _ = draw(task, hand, seed)
        chosen = []
        for name in kinds if not two else rng.sample(kinds, 2):
            sites = KINDS[name].sites(right)
            if not sites:
                return None
            chosen.append(Mistake(KINDS[name], rng.choice(sites), rng.randrange(1 << 30)))
        if len({str(m.site) for m in chosen}) < len(chosen):
            return None
        if two:
            alone = [Drawn(task, steps, hand, seed, [Mistake(m.kind, m.site, m.seed)]) for m in chosen]
            if not all(d.shows() for d in alone):
                return None
            for m, d in zip(chosen, alone):
                m.shown = d.first()
            without = alone[0].moved
            drawn = Drawn(task, steps, hand, seed, chosen)
            if max(abs(a - b) for a, b in zip(drawn.moved.values(), without.values())) < 1.5 * drawn.scale:
                return None
            chosen.sort(key=lambda m: min([p for p in map(steps.place, m.places) if p is not None] or [0]))
            return drawn
        drawn = Drawn(task, steps, hand, seed, chosen)
        return drawn if drawn.shows() else None
    except (Absurd, IndexError, KeyError, ZeroDivisionError, ValueError, OverflowError):
        return None


def tasks(kinegon, names, folder):
    """Three exercises of each kind with their steps, each the neighbours of the others."""
    table = []
    for name in names:
        group = []
        for path in exercises(kinegon, name, 11, 3, folder):
            try:
                task = Task(path)
                task.position()
                group.append(task)
            except Absurd as why:
                print(f"note: {path.name}: {why}", file=sys.stderr)
        for task in group:
            task.neighbours = [t for t in group if t is not task]
            table.append((task, Steps(kinegon, task)))
    return table


class Survey:
    """Sheets of one group, and how they were judged."""

    def __init__(self, faults):
        self.rows = collections.defaultdict(collections.Counter)
        self.told = collections.defaultdict(collections.Counter)
        self.stated, self.over, self.first_right, self.both, self.count = [], [], 0, 0, 0
        self.faults = faults

    def add(self, group, drawn, report):
        outcome, true = judge(drawn, report)
        name = "+".join(m.kind.name for m in drawn.mistakes)
        self.rows[group, name if group != "two" else "two"][outcome] += 1
        self.count += 1
        told = told_of(report)
        if true is not None and report["diagnosis"]["mistakes"]:
            self.stated.append((report["diagnosis"]["probability"], true, outcome == "misnamed"))
        if probabilities(report) > 1.005:
            self.over.append((probabilities(report), name))
            self.save("sum", name, drawn, f"probabilities sum to {probabilities(report):.2f}")
        if group == "two":
            order = [drawn.one(told[0], drawn.mistakes[0])] if told else []
            self.first_right += bool(order and order[0] in ("named", "located"))
            self.both += outcome == "named"
        if outcome in ("wrong", "misnamed", "silent") or (outcome in ("honest","pointed") and group != "two"):
            said = " + ".join(f"{t['mistake']}@{t['step']}" for t in told) or "nothing"
            p = report["diagnosis"]["probability"]
            places = [(m.kind.name, m.places, [drawn.steps.place(x) for x in m.places]) for m in drawn.mistakes]
            self.told[group, name][f"{outcome}: {drawn.task.kind} {drawn.hand.name}: {said} ({p:.2f}); made {places[0]}"] += 1
            self.save(outcome, name, drawn, f"{outcome}; made: {places}; moved first: {drawn.first()}; told: {said} ({p:.2f})")

    def save(self, outcome, name, drawn, note):
        """Keeps two forms of a kind that were judged wrongly; the name says what is wrong."""
        n = len(list(self.faults.glob(f"{outcome}-{name}-*.json"))) if self.faults else 2
        if n < 2:
            path = self.faults / f"{outcome}-{name}-{n}.json"
            path.write_text(json.dumps({**drawn.form, "name": note[:400]}, ensure_ascii=False, indent=1))

    def shares(self, group):
        total = collections.Counter()
        for (g, _), row in self.rows.items():
            if g == group:
                total += row
        return total

    def calibration(self):
        lines = []
        for low, high in zip(BINS, BINS[1:]):
            here = [(p, t, m) for p, t, m in self.stated if low <= p < high]
            if here:
                n = len(here)
                lines.append((f"{low * 100:.0f}-{min(high, 1) * 100:.0f}", n, sum(p for p, _, _ in here) / n * 100,
                              sum(t for _, t, _ in here) / n * 100, sum(t or m for _, t, m in here) / n * 100))
        return lines


def line(name, row):
    n = sum(row.values())
    return f"{name:34} {n:5} " + " ".join(f"{row[o] * 100 / n:8.1f}" for o in OUTCOMES) if n else f"{name:34}     0"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kinegon")
    parser.add_argument("--sheets", type=int, default=8, help="sheets of each kind of mistake")
    parser.add_argument("--two", type=int, default=120, help="sheets with two mistakes of the list")
    parser.add_argument("--honest", type=int, default=240, help="sheets without a mistake")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kinds", help="only these kinds of mistakes")
    parser.add_argument("--tasks", help="only these kinds of mechanisms")
    parser.add_argument("--hands", default="careful,usual,usual,shaky")
    parser.add_argument("--faults", type=Path, help="folder for forms that were judged wrongly")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--exercises", default="/tmp/second-exercises")
    parser.add_argument("--limits", action="store_true", help="exit code 1 where a share is worse than promised")
    options = parser.parse_args()
    table = tasks(options.kinegon, options.tasks.split(",") if options.tasks else list(MECHANISMS), options.exercises)
    kinds = options.kinds.split(",") if options.kinds else list(KINDS)
    hands = options.hands.split(",")
    if options.faults:
        options.faults.mkdir(parents=True, exist_ok=True)
    surveys = {g: Survey(options.faults) for g in ("listed", "outside", "common", "two")}
    work = []
    for name in kinds:
        rng, found = random.Random(f"{options.seed} {name}"), 0
        group = "common" if name.startswith("common") else KINDS[name].scope
        for _ in range(options.sheets * 25):
            drawn = lot(rng, table, hands, [name])
            if drawn:
                work.append((group, drawn))
                found += 1
            if found == options.sheets:
                break
        if not found:
            print(f"note: {name}: no sheet", file=sys.stderr)
    listed = [k for k in kinds if KINDS[k].listed and KINDS[k].at not in ("whole", "special") and not k.startswith("common")]
    rng, found = random.Random(f"{options.seed} two"), 0
    for _ in range(options.two * 40 if len(listed) > 1 else 0):
        drawn = lot(rng, table, hands, listed, two=True) if found < options.two else None
        if drawn:
            work.append(("two", drawn))
            found += 1
    rng = random.Random(f"{options.seed} honest")
    for i in range(options.honest):
        task, steps = rng.choice(table)
        digits = (0, 0, 3, 2, 1)[i % 5]
        work.append((f"honest {digits or 'all'}", Drawn(task, steps, HANDS[rng.choice(hands)], rng.randrange(1 << 30), [], digits)))
        if i % 5 == 0:  # rates rounded to two digits wherever they are used
            work.append(("rounded", Drawn(task, steps, HANDS["rounder"], rng.randrange(1 << 30), [])))
    honest = collections.defaultdict(collections.Counter)
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        if "another-exercise" in kinds:
            print(line("another exercise of the class", check_variants(options, table, folder)))
        reports = pool.map(lambda w: check(options.kinegon, w[1][1], folder, w[0]), enumerate(work))
        for (group, drawn), report in zip(work, reports):
            if group in surveys:
                surveys[group].add(group, drawn, report)
                continue
            told, off = told_of(report), [v for v in report["values"] if v["verdict"] in ("off", "sense-missing")]
            honest[group].update(sheets=1, accused=bool(told), off=bool(off), passed=report["passed"])
            if (told or off) and options.faults:
                said = " + ".join(f"{t['mistake']}@{t['step']}" for t in told) or "nothing"
                note = f"{group}, {drawn.hand.name}: told {said}; off {[v['quantity'] for v in off]}"
                path = options.faults / f"honest-{group[7:]}-{sum(honest[group].values())}.json"
                path.write_text(json.dumps({**drawn.form, "name": note[:400]}, ensure_ascii=False, indent=1))
    return show(surveys, honest, options)


def show(surveys, honest, options):
    faults = 0
    print(f"{'in per cent':34} {'sheets':>5} " + " ".join(f"{o:>8}" for o in OUTCOMES))
    for group, survey in surveys.items():
        for (g, name), row in sorted(survey.rows.items()):
            print(line(f"  {name}", row))
        total = survey.shares(group)
        print(line(group, total))
        n = sum(total.values())
        if n and group in ("listed", "outside"):
            right = total["named"] if group == "listed" else total["named"] + total["located"]
            faults += right / n < (0.95 if group == "listed" else 0.90)
            faults += total["wrong"] / n > 0.03 or total["misnamed"] / n > 0.03
        for (_, name), told in sorted(survey.told.items()):
            for words, count in told.most_common(4):
                print(f"    {name}: {words}" + (f" x{count}" if count > 1 else ""))
    two = surveys["two"]
    if two.count:
        print(f"two at once: both named {two.both * 100 / two.count:.1f} %, first right {two.first_right * 100 / two.count:.1f} %")
        faults += two.both / two.count < 0.55 or two.first_right / two.count < 0.9
    for group, row in sorted(honest.items()):
        print(f"{group:20} sheets {row['sheets']}, accused {row['accused']}, values off {row['off']}, passed {row['passed']}")
    honest.pop("rounded", None)
    sheets, accused = (sum(r[k] for r in honest.values()) for k in ("sheets", "accused"))
    faults += bool(sheets) and accused / sheets > 0.005
    for group, survey in surveys.items():
        for name, n, stated, true, loosely in survey.calibration():
            print(f"stated, {group:8} {name:>7} %: {n:4} sheets, mean {stated:.0f}, true {true:.0f}, right value {loosely:.0f}")
            faults += n >= 40 and abs(stated - true) > 5
        if survey.over:
            worst = max(survey.over)
            print(f"{group}: the probabilities of {len(survey.over)} sheets sum to more than 1, at most {worst[0]:.2f} ({worst[1]})")
            faults += 1
    return 1 if faults and options.limits else 0


if __name__ == "__main__":
    sys.exit(main())
