"""What the second hand is given: an exercise with its lengths, and positions by Newton's method. See `second.py`."""

import json
import math
import random
import re
import subprocess
from pathlib import Path

TURN = math.pi / 2


class Absurd(Exception):
    """What was drawn cannot be gone on with: parallel rays, a plan that leaves every sheet."""


# Plane geometry

def angle(a, b):
    return math.atan2(b[1] - a[1], b[0] - a[0])


def away(p, direction, size):
    return (p[0] + size * math.cos(direction), p[1] + size * math.sin(direction))


def distance(a, b):
    return math.hypot(b[0] - a[0], b[1] - a[1])


def across(direction, a, b):
    """The part of a to b along the normal of a direction, counter-clockwise positive."""
    return -math.sin(direction) * (b[0] - a[0]) + math.cos(direction) * (b[1] - a[1])


def along(direction, a, b):
    return math.cos(direction) * (b[0] - a[0]) + math.sin(direction) * (b[1] - a[1])


def meet(p, pd, q, qd):
    """Where two lines meet."""
    sine = math.sin(qd - pd)
    if abs(sine) < 0.02:
        raise Absurd("rays are nearly parallel")
    return away(p, pd, (math.cos(qd - TURN) * (q[0] - p[0]) + math.sin(qd - TURN) * (q[1] - p[1])) / math.cos(qd - TURN - pd))


def solve(rows, right):
    """Linear equations by elimination."""
    n = len(right)
    m = [list(row) + [r] for row, r in zip(rows, right)]
    for i in range(n):
        best = max(range(i, n), key=lambda k: abs(m[k][i]))
        if abs(m[best][i]) < 1e-12:
            raise Absurd("the equations do not tell the rates")
        m[i], m[best] = m[best], m[i]
        for k in range(n):
            if k != i:
                f = m[k][i] / m[i][i]
                m[k] = [x - f * y for x, y in zip(m[k], m[i])]
    return [m[i][n] / m[i][i] for i in range(n)]


def significant(x, digits):
    if x == 0 or not math.isfinite(x):
        return 0.0
    return round(x, digits - 1 - math.floor(math.log10(abs(x))))


# Exercises

class Task:
    """An exercise as the student gets it: what is given, and the empty form."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.name = self.folder.name
        self.kind = self.name.rsplit("-", 2)[0]
        scene = json.loads((self.folder / "scene.json").read_text())
        self.form = json.loads((self.folder / "form.json").read_text())
        self.boxes = list(self.form["values"])
        self.mu = {"l": self.form["mu_l"], "v": self.form["mu_v"], "a": self.form["mu_a"]}
        self.ground = {k: tuple(v) for k, v in scene["ground"].items() if k != "note"}
        self.near = {k: tuple(v) for k, v in scene.get("near", {}).items() if k != "note"}
        self.lengths, self.triangles = {}, []
        for link in scene["links"].values():
            for pair, size in link.get("lengths", {}).items():
                if pair != "note":
                    self.lengths[pair] = size
            if len(link["points"]) == 3:
                self.triangles.append(tuple(link["points"]))
        self.guides = scene.get("sliders", [])
        drive = scene["links"].get("1", {}).get("drive") or self.guides[0]["drive"]
        if drive.get("alpha"):
            raise Absurd("this hand draws cranks that turn evenly")
        self.crank_degrees, self.omega = drive.get("angle"), drive.get("omega")
        self.drive = drive
        self._modes = {}

    def length(self, a, b):
        return self.lengths.get(a + b) or self.lengths[b + a]

    def modes(self, degrees=None):
        """All positions that Newton's method finds, the one nearest to `near` first."""
        degrees = self.crank_degrees if degrees is None else degrees
        if degrees not in self._modes:
            self._modes[degrees] = self._assemble(degrees)
        return self._modes[degrees]

    def position(self, degrees=None, mode=0):
        modes = self.modes(degrees)
        if mode >= len(modes):
            raise Absurd("no such position")
        return modes[mode]

    def _assemble(self, degrees):
        known = dict(self.ground)
        if degrees is not None:
            known["B"] = away(known["A"], math.radians(degrees), self.lengths["AB"])
        names = sorted({x for pair in self.lengths for x in pair} | set(self.near) - set(known))
        names = [n for n in names if n not in known and not (self.kind == "hydraulic-boom" and n in "BD")]
        conditions = []
        for pair, size in self.lengths.items():
            if any(x in names for x in pair) and all(x in names or x in known for x in pair):
                conditions.append(lambda q, a=pair[0], b=pair[1], s=size: distance(q[a], q[b]) - s)
        for g in self.guides:
            if g["on"] == "ground":
                through = known[g["through"]] if isinstance(g["through"], str) else tuple(g["through"])
                d = math.radians(g["along"]) if not isinstance(g["along"], list) else angle((0, 0), g["along"])
                conditions.append(lambda q, at=g["at"], t=through, d=d: across(d, t, q[at]))
            elif self.kind == "hydraulic-boom":
                reach = self.drive["position"] + self.lengths["DC"]
                conditions.append(lambda q, s=reach: distance(q["A"], q["C"]) - s)
            else:
                x, y = g["along"]
                z = g.get("through", x)
                conditions.append(lambda q, x=x, y=y, z=z: across(angle(q[x], q[y]), q[z], q["B"]))
        rng, found = random.Random(4711), []
        size = max(self.lengths.values())
        for trial in range(24):
            q = dict(known)
            spread = 0 if trial == 0 else size * (0.2 if trial < 6 else 1.5)
            for n in names:
                x, y = self.near.get(n, (size / 3, size / 3))
                q[n] = (x + rng.uniform(-1, 1) * spread, y + rng.uniform(-1, 1) * spread)
            if self._newton(q, names, conditions) and self._sides(q):
                if all(max(distance(q[n], o[n]) for n in names) > 1e-3 for o in found):
                    found.append(q)
        if not found:
            raise Absurd("cannot be assembled")
        near = [n for n in names if n in self.near]
        found.sort(key=lambda q: sum(distance(q[n], self.near[n]) ** 2 for n in near))
        for q in found:
            if self.kind == "hydraulic-boom":
                d = angle(q["A"], q["C"])
                q["B"], q["D"] = away(q["A"], d, self.lengths["AB"]), away(q["A"], d, self.drive["position"])
        return found

    @staticmethod
    def _newton(q, names, conditions):
        for _ in range(40):
            f = [c(q) for c in conditions]
            if max(map(abs, f)) < 1e-10:
                return True
            columns = []
            for n in names:
                for k in (0, 1):
                    x = q[n]
                    q[n] = (x[0] + 1e-6, x[1]) if k == 0 else (x[0], x[1] + 1e-6)
                    columns.append([(c(q) - g) / 1e-6 for c, g in zip(conditions, f)])
                    q[n] = x
            try:
                step = solve(list(zip(*columns)), [-x for x in f])
            except Absurd:
                return False
            if max(map(abs, step)) > 1e5:
                return False
            for i, n in enumerate(names):
                q[n] = (q[n][0] + step[2 * i], q[n][1] + step[2 * i + 1])
        return False

    def _sides(self, q):
        """Third points of links lie on the side where `near` has them; a block on a lever lies towards its end."""
        rough = {**self.ground, **self.near, "B": self.near.get("B", q.get("B"))}
        for a, b, c in self.triangles:
            if all(x in rough for x in (a, b, c)):
                if across(angle(rough[a], rough[b]), rough[a], rough[c]) * across(angle(q[a], q[b]), q[a], q[c]) < 0:
                    return False
        return self.kind != "slotted-lever" or along(angle(q["D"], q["C"]), q["D"], q["B"]) > 0


def key(folder):
    """The key of an exercise, by the names of its form: a point of the ground under a slider is the pole there."""
    entries = json.loads((Path(folder) / "key.json").read_text())["values"]
    return {re.sub(r"\w+_ground", "p" if box.startswith("v") else "π", box): entry for box, entry in entries.items()}


def exercises(kinegon, kind, seed, count, folder):
    """The folders of the exercises, made where they are not there."""
    folder = Path(folder)
    names = [folder / f"{kind}-{seed}-{i + 1}" for i in range(count)]
    if not all((n / "scene.json").exists() for n in names):
        subprocess.run([kinegon, "exercise", kind, "--seed", str(seed), "--count", str(count), "-o", str(folder)], check=True,
                       capture_output=True)
    return names
