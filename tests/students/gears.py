"""A hand for wheels: finds how trains of its own turn, by ratios of teeth or by velocities of pitch points, errs as a pencil does, and makes one
mistake on purpose.

Its author's trains keep to Willis' formula, (ω_j − ω_k) = −z_i/z_j (ω_i − ω_k), solved by elimination; it knows of Kinegon the forms alone.

    gears.py KINEGON [--scenes N] [--honest N] [--each N] [--mistake NAME] [--faults FOLDER] [--limits]
"""

import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

from survey import Survey, arguments

MM = 0.3
MISTAKES = ["mesh-sense", "ratio-inverted", "arm-forgotten", "relative-for-absolute", "idler-counted", "pitch-point-on-wrong-side",
            "rim-of-compound-swapped", "accelerations-equal-at-P"]


class Stuck(Exception):
    """The mistake cannot be made here, or the train does not move."""


class Train:
    """Bodies `0` (the frame) and others with points; meshes as (i, j, z_i, z_j, carrier), a ring's z negative; given rates [ω, α]."""

    def __init__(self, name, points, bodies, meshes, given):
        self.name, self.points, self.bodies, self.meshes, self.given = name, points, bodies, meshes, given

    def center(self, body, carrier):
        return next(p for p in self.bodies[body] if p in self.bodies[carrier])

    def scene(self):
        name = lambda body: "ground" if body == "0" else body
        links = {body: {"points": own} for body, own in self.bodies.items() if body != "0"}
        for body, (omega, alpha) in self.given.items():
            links[body]["drive"] = {"omega": omega, "alpha": alpha}
        gears = [{"mesh": [name(i), name(j)], "teeth": [z, w], "on": name(k)} for i, j, z, w, k in self.meshes]
        return {"kinegon": 1, "title": self.name, "units": {"length": "mm", "time": "s"}, "ground": self.bodies["0"],
                "points": {p: list(xy) for p, xy in self.points.items()}, "links": links, "gears": gears}

    def pitch(self, mesh):
        i, j, z, w, k = mesh
        a, b = self.points[self.center(i, k)], self.points[self.center(j, k)]
        return tuple(p + (q - p) * z / (z + w) for p, q in zip(a, b))


def polar(xy, angle, length):
    return round(xy[0] + length * math.cos(math.radians(angle)), 1), round(xy[1] + length * math.sin(math.radians(angle)), 1)


def teeth(rng):
    return rng.randrange(17, 61)


def rates(rng):
    return [rng.choice([4, 5, 6, 8, 10, -5, -6, -8]), rng.choice([0, 0, 10, 20, -15])]


def external(rng):
    """Two wheels on the frame."""
    z, w = teeth(rng), teeth(rng)
    d = polar((0, 0), rng.uniform(0, 360), 1.5 * (z + w))
    points = {"A": (0.0, 0.0), "D": d, "B": polar((0, 0), rng.uniform(0, 360), 40), "C": polar(d, rng.uniform(0, 360), 45)}
    return Train("pair", points, {"0": ["A", "D"], "1": ["A", "B"], "2": ["D", "C"]}, [("1", "2", z, w, "0")], {"1": rates(rng)})


def idler(rng):
    """Three wheels on the frame, one after another."""
    z, w, x = teeth(rng), teeth(rng), teeth(rng)
    turn = rng.uniform(0, 360)
    d = polar((0, 0), turn, 1.2 * (z + w))
    f = polar(d, turn + rng.uniform(-60, 60), 1.2 * (w + x))
    points = {"A": (0.0, 0.0), "D": d, "F": f, "B": polar((0, 0), rng.uniform(0, 360), 40), "C": polar(f, rng.uniform(0, 360), 45)}
    bodies = {"0": ["A", "D", "F"], "1": ["A", "B"], "2": ["D"], "3": ["F", "C"]}
    return Train("idler", points, bodies, [("1", "2", z, w, "0"), ("2", "3", w, x, "0")], {"1": rates(rng)})


def compound(rng):
    """Two stages on the frame, with two rims on the wheel between."""
    z, w, y, x = (teeth(rng) for _ in range(4))
    turn = rng.uniform(0, 360)
    d = polar((0, 0), turn, 1.2 * (z + w))
    f = polar(d, turn + rng.uniform(-60, 60), 1.2 * (y + x))
    points = {"A": (0.0, 0.0), "D": d, "F": f, "B": polar((0, 0), rng.uniform(0, 360), 40), "C": polar(f, rng.uniform(0, 360), 45)}
    bodies = {"0": ["A", "D", "F"], "1": ["A", "B"], "2": ["D"], "3": ["F", "C"]}
    return Train("compound", points, bodies, [("1", "2", z, w, "0"), ("2", "3", y, x, "0")], {"1": rates(rng)})


def planetary(rng):
    """Sun 3, planet 2 and ring 4 on arm 1, one of the three others driven and one fixed, or two driven."""
    while True:
        z, w = teeth(rng), teeth(rng)
        if z + 2 * w <= 120 and (2 * z + 2 * w) % 3 == 0:
            break
    driven, fixed = rng.sample(["1", "3", "4"], 2)
    both = rng.random() < 0.3
    b = polar((0, 0), rng.uniform(0, 360), 1.2 * (z + w))
    points = {"A": (0.0, 0.0), "B": b, "Q": polar(b, rng.uniform(0, 360), 35), "E": polar((0, 0), rng.uniform(0, 360), 40),
              "R": polar((0, 0), rng.uniform(0, 360), 90)}
    bodies = {"0": ["A"], "1": ["A", "B"], "2": ["B", "Q"], "3": ["A", "E"], "4": ["A", "R"]}
    given = {driven: rates(rng)}
    if both:
        given[fixed] = rates(rng)
    body = {own: own for own in bodies}
    if not both and fixed == "1":
        del bodies["1"]
        body["1"], bodies["0"] = "0", ["A", "B"]
    elif not both:
        point = {"3": "E", "4": "R"}[fixed]
        del bodies[fixed], points[point]
        body[fixed] = "0"
    meshes = [(body["3"], "2", z, w, body["1"]), ("2", body["4"], w, -(z + 2 * w), body["1"])]
    return Train("differential" if both else "planetary", points, bodies, meshes, given)


def reverted(rng):
    """Two suns on a planet with two rims: the first fixed, the arm driven, or the second driven."""
    while True:
        z, w, x = teeth(rng), teeth(rng), teeth(rng)
        y = z + w - x
        if 17 <= y <= 60 and abs(z * x - w * y) > 0.05 * z * x and w != x:
            break
    b = polar((0, 0), rng.uniform(0, 360), 1.2 * (z + w))
    points = {"A": (0.0, 0.0), "B": b, "Q": polar(b, rng.uniform(0, 360), 35), "E": polar((0, 0), rng.uniform(0, 360), 40)}
    bodies = {"0": ["A"], "1": ["A", "B"], "2": ["B", "Q"], "3": ["A", "E"]}
    return Train("reverted", points, bodies, [("0", "2", z, w, "1"), ("2", "3", x, y, "1")], {rng.choice(["1", "3"]): rates(rng)})


KINDS = [external, planetary, idler, planetary, compound, planetary, reverted]


def solved(rows, right):
    """Linear equations by elimination with pivots."""
    n = len(rows)
    table = [list(row) + [side] for row, side in zip(rows, right)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda k: abs(table[k][i]))
        if abs(table[pivot][i]) < 1e-9:
            raise Stuck
        table[i], table[pivot] = table[pivot], table[i]
        for k in range(n):
            if k != i:
                part = table[k][i] / table[i][i]
                table[k] = [a - part * b for a, b in zip(table[k], table[i])]
    return [table[i][n] / table[i][i] for i in range(n)]


def turning(train, order, formulas):
    """Rates of all bodies from the given ones; a formula is a list of (body, factor) with the sum zero."""
    known = {"0": 0.0, **{body: given[order] for body, given in train.given.items()}}
    unknown = [body for body in train.bodies if body not in known]
    rows = [[sum(f for b, f in own if b == body) for body in unknown] for own in formulas]
    right = [-sum(f * known[b] for b, f in own if b in known) for own in formulas]
    return {**known, **dict(zip(unknown, solved(rows, right)))}


def formula(mesh):
    i, j, z, w, k = mesh
    return [(j, 1.0), (k, -1.0), (i, z / w), (k, -z / w)]


def inner(name):
    return tuple(name[name.index("(") + 1:-1].split(","))


def image(mesh):
    """The image of a pitch point, by its wheels, the frame last."""
    return "p" + "".join(sorted(mesh[:2], key=lambda body: (body == "0", body)))


class Hand:
    """One sheet: rates by teeth or by pitch points, plans with a pencil's errors."""

    def __init__(self, train, scales, names, rng, mistake=None, size=1.0):
        self.train, self.mu, self.rng, self.size, self.mistake = train, scales, rng, size, mistake
        self.names, self.read = names, {}
        # Who errs with teeth counts teeth.
        self.by_teeth = rng.random() < 0.5 or mistake not in (None, "mesh-sense", "accelerations-equal-at-P") or \
            mistake == "mesh-sense" and any(mesh[4] != "0" for mesh in train.meshes)
        right = [turning(train, order, [formula(mesh) for mesh in train.meshes]) for order in (0, 1)]
        self.omega, self.alpha = (dict(rates) for rates in right)
        self.equal = None
        if mistake:
            self.err()
            if mistake not in ("accelerations-equal-at-P",) and all(abs(self.omega[b] - right[0][b]) < 1e-9 for b in self.omega):
                raise Stuck
        self.v = {"p": (0.0, 0.0)}
        if not self.by_teeth:
            self.measure()
        self.velocities()
        self.accelerations()

    def err(self):
        train, rng = self.train, self.rng
        formulas = [formula(mesh) for mesh in train.meshes]
        which = rng.randrange(len(formulas))
        i, j, z, w, k = train.meshes[which]
        turned = turning(train, 0, formulas)
        kind = self.mistake
        if kind == "mesh-sense":
            formulas[which] = [(j, 1.0), (k, -1.0), (i, -z / w), (k, z / w)]
        elif kind == "ratio-inverted":
            formulas[which] = [(j, 1.0), (k, -1.0), (i, w / z), (k, -w / z)]
        elif kind == "arm-forgotten":
            if k == "0" or abs(turned[k]) < 1e-9:
                raise Stuck
            formulas[which] = [(j, 1.0), (i, z / w)]
        elif kind == "relative-for-absolute":
            body = rng.choice([own for own in (i, j) if own != "0" and own not in train.given] or [None])
            if body is None or k == "0" or abs(turned[k]) < 1e-9:
                raise Stuck
            for rates, order in ((self.omega, 0), (self.alpha, 1)):
                rates[body] -= rates[k]
            return
        elif kind == "idler-counted":
            if len(train.meshes) < 2 or train.meshes[0][3] != train.meshes[1][2] or train.meshes[0][1] != train.meshes[1][0]:
                raise Stuck
            (a, b, z1, z2, k), (_, c, _, z3, _) = train.meshes
            if a in train.given:
                first = 1
            elif c in train.given:
                a, c, z1, z3, first = c, a, z3, z1, 0
            if "0" in (a, c) or (a in train.given) == (c in train.given):
                raise Stuck
            wrong = rng.choice([abs(z1) / z2, z2 / abs(z3)]) * (1 if z1 * z3 > 0 else -1) * (1 if rng.random() < 0.7 else -1)
            formulas[first] = [(c, 1.0), (k, -1.0), (a, -wrong), (k, wrong)]
        elif kind == "pitch-point-on-wrong-side":
            if w > 0:
                raise Stuck
            # The planet's velocity line: its centre, and the ring's velocity at the near side.
            ring, planet = abs(w), z
            speed = rng.choice([ring - 2 * planet, ring])
            formulas[which] = [(i, planet), (j, speed), (k, -(ring - planet))]
        elif kind == "rim-of-compound-swapped":
            if len(train.meshes) < 2 or train.meshes[0][1] != train.meshes[1][0] or train.meshes[0][3] == train.meshes[1][2]:
                raise Stuck
            (a, b, z1, z2, k), (_, c, z3, z4, _) = train.meshes
            if rng.random() < 0.5:
                formulas[0] = formula((a, b, z1, z3, k))
            if formulas[0] == formula(train.meshes[0]) or rng.random() < 0.5:
                formulas[1] = formula((b, c, z2, z4, k))
        elif kind == "accelerations-equal-at-P":
            if k == "0":
                raise Stuck
            self.equal = train.meshes[which]
            return
        self.omega, self.alpha = (turning(train, order, formulas) for order in (0, 1))

    # The plans

    def error(self, limit):
        return self.rng.uniform(-limit, limit) * self.size

    def measure(self):
        """Angular velocities that are not given come from segments of the plan, as the form names them."""
        for body, rate in list(self.omega.items()):
            if body == "0" or body in self.train.given or not rate:
                continue
            ends = self.ends(body)
            pair = next((inner(name) for name in self.names if name.startswith("vplan") and all(p in ends for p in inner(name))), None)
            if pair is None:
                continue
            far = max(((a, b) for a in ends[pair[0]] for b in ends[pair[1]]), key=lambda two: self.distance(*two))
            length = self.distance(*far)
            value = float(f"{abs(rate) * length + (self.error(MM) + self.error(MM)) * self.mu['v']:.4g}")
            self.read[pair] = value
            self.omega[body] = math.copysign(value / length, rate)

    def ends(self, body):
        """The images of a body's centres and pitch points with their places; what rests is at p."""
        train, found = self.train, {}
        for mesh in train.meshes:
            i, j, *_, k = mesh
            if body in (i, j):
                name = image(mesh) if "0" not in (i, j) else "p"
                found.setdefault(name, []).append(train.pitch(mesh))
            for point in (train.center(i, k), train.center(j, k)):
                if body in (i, j, k) and point in train.bodies[body]:
                    found.setdefault("p" if point in train.bodies["0"] else point.lower(), []).append(train.points[point])
        return found

    @staticmethod
    def distance(a, b):
        return math.hypot(a[0] - b[0], a[1] - b[1])

    def off(self, xy, mu):
        return tuple(x + self.error(MM) * mu for x in xy)

    def arm(self, a, b):
        a, b = (self.train.points.get(p) or self.pitches[p] for p in (a, b))
        return b[0] - a[0], b[1] - a[1]

    def velocities(self):
        train, mu = self.train, self.mu["v"]
        self.pitches = {}
        for mesh in train.meshes:
            self.pitches[image(mesh).upper()] = train.pitch(mesh)
            if self.mistake == "pitch-point-on-wrong-side" and mesh[3] < 0:
                (x, y), (a, b) = train.pitch(mesh), train.points[train.center("2", mesh[4])]
                self.pitches[image(mesh).upper()] = 2 * a - x, 2 * b - y
        for p in train.bodies["0"]:
            self.v[p.lower()] = (0.0, 0.0)
        left = [(body, own) for body, own in train.bodies.items() if body != "0"]
        for body, own in sorted(left, key=lambda item: not any(p in train.bodies["0"] for p in item[1])):
            base = next(p for p in own if p.lower() in self.v)
            for p in own:
                if p.lower() not in self.v:
                    x, y = self.arm(base, p)
                    rate, from_ = self.omega[body], self.v[base.lower()]
                    self.v[p.lower()] = self.off((from_[0] - rate * y, from_[1] + rate * x), mu)
        for mesh in train.meshes:
            i, j, *_, k = mesh
            name = image(mesh).upper()
            # By the wheel of which more is known: one that is given or rests.
            body = next((b for b in (i, j) if b == "0" or b in train.given), "2")
            center = train.center(body, k)
            x, y = self.arm(center, name)
            rate, from_ = self.omega[body], self.v[center.lower()]
            self.v[name.lower()] = (from_[0] - rate * y, from_[1] + rate * x) if body == "0" else \
                self.off((from_[0] - rate * y, from_[1] + rate * x), mu)

    def accelerations(self):
        train, mu = self.train, self.mu["a"]
        self.a = {"π": (0.0, 0.0), **{p.lower(): (0.0, 0.0) for p in train.bodies["0"]}}
        left = [(body, own) for body, own in train.bodies.items() if body != "0"]
        for body, own in sorted(left, key=lambda item: not any(p in train.bodies["0"] for p in item[1])):
            base = next(p for p in own if p.lower() in self.a)
            for p in own:
                if p.lower() in self.a:
                    continue
                x, y = self.arm(base, p)
                w, e = self.omega[body], self.alpha[body]
                squared = w * w
                if self.equal and p in train.bodies[self.equal[1]] and p in train.bodies[self.equal[0]] + train.bodies["2"] and body == self.equal[4]:
                    i, j, z, t, k = self.equal
                    outer = i if j == "2" else j
                    share = (z if outer == i else t) / (z + t)
                    squared = self.omega[outer] ** 2 * share + self.omega["2"] ** 2 * (1 - share)
                from_ = self.a[base.lower()]
                n = self.off((from_[0] - squared * x, from_[1] - squared * y), mu)
                self.a[f"n_{base.lower()}{p}"] = n
                self.a[p.lower()] = self.off((n[0] - e * y, n[1] + e * x), mu) if e else n

    # The form

    def values(self, names):
        written = {}
        for name in names:
            head, ends = name.partition("(")[0], inner(name)
            if head == "omega":
                value = self.omega[ends[0]]
            elif head == "alpha":
                value = self.alpha[ends[0]]
            else:
                plan, mu = (self.v, self.mu["v"]) if head == "vplan" else (self.a, self.mu["a"])
                a, b = (plan[point] for point in ends)
                value = self.read.get(ends) or max(self.distance(a, b) + self.error(MM) * mu, 0.0)
            written[name] = f"{value:.4g}"
        return written


def run(options):
    rng = random.Random(options.seed)
    survey = Survey(options, MISTAKES, lambda told, mistake: bool(told) and all(t == mistake for t in told))
    for index in range(1, options.scenes + 1):
        kind = KINDS[(index - 1) % len(KINDS)]
        with tempfile.TemporaryDirectory() as work:
            work = Path(work)
            while True:
                train = kind(rng)
                try:
                    turning(train, 0, [formula(mesh) for mesh in train.meshes])
                except Stuck:
                    continue
                (work / "scene.json").write_text(json.dumps(train.scene()))
                done = subprocess.run([options.kinegon, "check", str(work / "scene.json"), "--template"], capture_output=True, text=True)
                if done.returncode == 0:
                    break
            form = json.loads(done.stdout)
            names, scales = list(form["values"]), {"v": form["mu_v"], "a": form["mu_a"]}
            sheets = [(None, n) for n in range(-(-options.honest // options.scenes))]
            sheets += [(mistake, n) for mistake in survey.wanted for n in range(-(-options.each // options.scenes * 2))]
            for mistake, number in sheets:
                try:
                    hand = Hand(train, scales, names, rng, mistake)
                    form["values"] = hand.values(names)
                except Stuck:
                    continue
                key = f"{mistake or 'honest'}-{number}"
                form["name"] = key
                (work / f"{key}.json").write_text(json.dumps(form))
                route = "by teeth" if hand.by_teeth else "by pitch points"
                survey.judge(work / "scene.json", work / f"{key}.json", kind.__name__, mistake, route, f"{kind.__name__}-{index}-{key}")
    return survey.report(least=90)


if __name__ == "__main__":
    sys.exit(run(arguments(__doc__)))
