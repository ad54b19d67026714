"""A second hand: a student's work on the exercises of `kinegon exercise`, from the scene's given numbers alone.

Positions by Newton's method on the lengths, plans drawn with a set square that is off by an angle and an offset, lengths read from a
ruler, rates computed with a slip and rounded. Nothing here is shared with Kinegon, with `hand.py` or with the students in Rust.

    second.py --self-test KINEGON [SEEDS]    exact drawings against the keys of the exercises
    second.py KIND SEED KINEGON              one sheet, as a form
"""

import json
import math
import random
import re
import sys

from second_mechanisms import MECHANISMS
from second_task import TURN, Absurd, Task, angle, away, distance, exercises, key, meet, significant


class Hand:
    """How well somebody draws: standard deviations of a direction (degrees) and of a place (mm), what a ruler is read to (mm), the
    standard deviation of a computed number (a share of it), and the digits of written rates."""

    def __init__(self, name, degrees, place, read, slip, digits):
        self.name, self.degrees, self.place, self.read, self.slip, self.digits = name, degrees, place, read, slip, digits


HANDS = {h.name: h for h in (
    Hand("exact", 0, 0, 1e-4, 0, 6),
    Hand("careful", 0.1, 0.1, 0.1, 0, 4),
    Hand("usual", 0.15, 0.15, 0.5, 0.001, 3),
    Hand("shaky", 0.3, 0.3, 0.5, 0.002, 3),
    Hand("rounder", 0.15, 0.15, 0.5, 0, 2),
)}


# The sheet

class Sheet:
    """A student's sheet in the making. Every act goes through `act`, where a mistake may change what is done."""

    def __init__(self, task, hand, seed, mistakes=()):
        self.task, self.hand, self.seed, self.mistakes = task, hand, seed, mistakes
        self.mu = dict(task.mu)
        self.plans = {"v": {"p": (0.0, 0.0)}, "a": {"π": (0.0, 0.0)}}
        self.still = {g.lower() for g in task.ground} | {"p", "π"}
        for plan in self.plans.values():
            plan.update({g: (0.0, 0.0) for g in self.still})
        self.acts, self.read, self.computed, self.rates, self.measured = [], {}, {}, {}, {}
        self.position, self.omega, self.blank = None, task.omega, set()
        for m in mistakes:
            m.begin(self)
        self.position = self.position or task.position()

    def error(self, what, deviation):
        if deviation == 0:
            return 0.0
        rng = random.Random(f"{self.seed} {what}")
        return max(-2.5, min(2.5, rng.gauss(0, 1))) * deviation

    def act(self, kind, where, fields):
        for m in self.mistakes:
            m.touch(self, kind, where, fields)
        self.acts.append((kind, where, dict(fields)))
        return fields

    def point(self, plan, name):
        return self.plans[plan][name]

    def place(self, plan, name, xy):
        if math.hypot(*xy) > 600:
            raise Absurd("leaves the sheet")
        self.plans[plan][name] = xy

    def angle(self, a, b):
        return angle(self.position[a], self.position[b])

    def length(self, a, b):
        """A length that is given, or measured on the scheme where it is not."""
        try:
            return self.task.length(a, b)
        except KeyError:
            return self.measure_length(a, b)

    def measure_length(self, a, b):
        key = f"{a},{b}"
        if key not in self.measured:
            size = distance(self.position[a], self.position[b]) / self.mu["l"] + self.error("L" + key, self.hand.place)
            f = self.act("length", f"L:{key}", {"a": a, "b": b, "value": self.ruler(size)})
            self.measured[key] = f["value"] * self.mu["l"]
        return self.measured[key]

    def ruler(self, mm):
        return round(mm / self.hand.read) * self.hand.read

    def vector(self, plan, a, b, direction, size, reason, **info):
        """Lays off a vector of so many units from a to b."""
        where = f"{plan}:vector:{a}>{b}"
        f = self.act("vector", where, {"plan": plan, "from": a, "to": b, "direction": direction, "size": size, "reason": reason, **info})
        mm = f["size"] / self.mu[plan]
        self.computed[plan, self.same(a), self.same(b)] = self.ruler(abs(mm))
        start = self.point(plan, f["from"])
        if f["size"] == 0:
            return self.place(plan, b, start)
        d = f["direction"] + math.radians(self.error(where + " direction", self.hand.degrees))
        end = away(start, d, mm + self.error(where + " size", self.hand.place))
        return self.place(plan, b, away(end, d + TURN, self.error(where + " place", self.hand.place)))

    def ray(self, plan, through, to, direction, **info):
        where = f"{plan}:ray:{through}>{to}"
        f = self.act("ray", where, {"plan": plan, "from": through, "to": to, "direction": direction, "shift": 0.0, **info})
        d = f["direction"] + math.radians(self.error(where + " direction", self.hand.degrees))
        return away(self.point(plan, f["from"]), d + TURN, f["shift"] + self.error(where + " place", self.hand.place)), d

    def mark(self, plan, to, one, two):
        f = self.act("mark", f"{plan}:mark:{to}", {"plan": plan, "to": to, "xy": meet(*one, *two)})
        self.place(plan, to, f["xy"])

    def divide(self, plan, a, b, to, ratio):
        f = self.act("divide", f"{plan}:divide:{to}", {"plan": plan, "a": a, "b": b, "to": to, "ratio": ratio})
        p, q = self.point(plan, a), self.point(plan, b)
        xy = (p[0] + f["ratio"] * (q[0] - p[0]), p[1] + f["ratio"] * (q[1] - p[1]))
        self.place(plan, to, away(xy, angle(p, q), self.error(f"{plan}{to} divide", self.hand.place)))

    def same(self, name):
        return "0" if name in self.still else name

    def segment(self, plan, a, b):
        """The length of a segment in mm, as it is read, once."""
        key = (plan, *sorted((self.same(a), self.same(b))))
        if key not in self.read:
            mm = distance(self.point(plan, a), self.point(plan, b)) + self.error(f"segment {key}", self.hand.place)
            f = self.act("segment", f"{plan}:segment:{a}-{b}", {"plan": plan, "a": a, "b": b, "value": self.ruler(abs(mm))})
            self.read[key] = f["value"]
        return self.read[key]

    def rate(self, box, plan, a, b, length, sense):
        """A rate from a measured segment."""
        seg = self.segment(plan, a, b) * self.mu[plan]
        fields = {"box": box, "plan": plan, "ends": (a, b), "segment": seg, "length": length, "sense": math.copysign(1, sense), "value": None}
        return self.settle(box, fields)

    def settle(self, box, fields):
        f = self.act("rate", f"rate:{box}", fields)
        value = f["value"]
        if value is None:
            value = f["sense"] * f["segment"] / f["length"]
        value *= 1 + self.error("slip " + box, self.hand.slip)
        self.rates[box] = significant(value, self.hand.digits)
        return self.rates[box]

    def filled(self):
        """The values of the form: lengths in mm of paper, the rest in units. What cannot be read is left out."""
        values = {}
        for box in self.task.boxes:
            kind, arguments = re.fullmatch(r"(\w+)\((.*)\)", box).groups()
            if kind in ("vplan", "aplan"):
                a, b = arguments.split(",")
                x, y = self.same(a), self.same(b)
                if {(a, b), (b, a)} & self.blank:
                    values[box] = None
                    continue
                known = self.computed.get((kind[0], x, y), self.computed.get((kind[0], y, x)))
                values[box] = self.segment(kind[0], a, b) if known is None else known
            elif kind == "L":
                values[box] = self.measured[arguments] / self.mu["l"]
            else:
                values[box] = self.rates[box]
        for m in self.mistakes:
            m.end(self, values)
        return values


def draw(task, hand, seed, mistakes=()):
    """A finished sheet and the values that are read from it."""
    sheet = Sheet(task, hand, seed, mistakes)
    MECHANISMS[task.kind](sheet)
    return sheet, sheet.filled()


def in_units(task, box, value):
    """A value as it stands in the form, in the units of the scene."""
    scale = {"L": "l", "v": "v", "a": "a"}.get(box[0]) if box.startswith(("L(", "vplan", "aplan")) else None
    return value * task.mu[scale] if scale else value


def text(box, value, hand):
    if value is None:
        return ""
    if isinstance(value, str):
        return value
    if box.startswith(("L(", "vplan", "aplan")):
        return f"{value:.6g}" if hand.digits >= 6 else f"{value:.1f}"
    value = significant(value, hand.digits)
    decimals = max(0, hand.digits - 1 - math.floor(math.log10(abs(value)))) if value else 0
    return f"{value:.{decimals}f}"


def form(task, values, hand, name=""):
    """The form that is handed in."""
    out = {"kinegon_measured": 1, "name": name, "exercise": task.name, "positive": "counter-clockwise",
           "mu_l": task.mu["l"], "mu_v": task.mu["v"], "mu_a": task.mu["a"], "in": "mm"}
    out["values"] = {box: text(box, v, hand) for box, v in values.items()}
    return out


def self_test(kinegon, seeds, folder):
    """Exact drawings against the keys: the worst difference in a thousandth of the largest value of its plan."""
    worst_all = 0.0
    for kind in MECHANISMS:
        for seed in range(1, seeds + 1):
            for path in exercises(kinegon, kind, seed, 1, folder):
                task = Task(path)
                _, values = draw(task, HANDS["exact"], seed)
                for box, entry in key(path).items():
                    off = abs(in_units(task, box, values[box]) - entry["value"])
                    share = off / max(abs(entry["value"]), 0.02 * entry.get("allowed", 1))
                    worst_all = max(worst_all, share)
                    if share > 1e-3 and off > 0.01 * entry.get("allowed", 0):
                        print(f"{path.name} {box}: {in_units(task, box, values[box])} for {entry['value']}")
                        return 1
    print(f"exact drawings agree with the keys: {len(MECHANISMS)} mechanisms, {seeds} exercises each")
    return 0


if __name__ == "__main__":
    if len(sys.argv) > 2 and sys.argv[1] == "--self-test":
        sys.exit(self_test(sys.argv[2], int(sys.argv[3]) if len(sys.argv) > 3 else 3, "/tmp/second-exercises"))
    if len(sys.argv) == 4:
        task = Task(exercises(sys.argv[3], sys.argv[1], int(sys.argv[2]), 1, "/tmp/second-exercises")[0])
        print(json.dumps(form(task, draw(task, HANDS["usual"], 1)[1], HANDS["usual"]), indent=1, ensure_ascii=False))
    else:
        print(__doc__)
