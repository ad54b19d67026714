"""A hand for the forces between teeth, and for racks: trains of wheels on the frame that a couple or a force on the last wheel loads, found by moments and polygons from the
last wheel to the first, with a pencil's errors and one mistake on purpose.

    teeth.py KINEGON [--scenes N] [--honest N] [--each N] [--mistake NAME] [--faults FOLDER] [--limits]

Its author's truth: the moments of each wheel about its pin, by its teeth alone.
"""

import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

from forces import add, angle, cross, left, scaled, size, turned, unit
from survey import Survey, arguments

MM, DEGREES = 0.3, 0.3
MISTAKES = ["radial-force-left-out", "diameter-for-radius"]


class Stuck(Exception):
    """The mistake cannot be made here."""


class Train:
    """Wheels with centres, pitch radii and teeth; the last one has a couple and perhaps a force at a point of it."""

    def __init__(self, rng):
        self.alpha = rng.choice([14.5, 20, 20, 25])
        module = rng.choice([2, 2.5, 3])
        count = rng.choice([2, 2, 3, 3, 4])
        self.teeth = [rng.randrange(17, 44) for _ in range(count)]
        self.radii = [module * z / 2 for z in self.teeth]
        self.centers, turn = [(0.0, 0.0)], rng.uniform(0, 360)
        for before, after in zip(self.radii, self.radii[1:]):
            turn += rng.uniform(-70, 70)
            self.centers.append(add(self.centers[-1], turned((before + after, 0.0), turn)))
        self.couple = rng.choice([-1, 1]) * float(rng.randrange(2000, 7000, 100))
        self.omega = rng.choice([-8, -5, 4, 6])
        self.spot = turned((self.radii[-1] * 0.8, 0.0), rng.uniform(0, 360))
        self.force = turned((float(rng.randrange(20, 80, 5)), 0.0), rng.uniform(0, 360)) if rng.random() < 0.4 else None

    def name(self, wheel):
        return "ACDEF"[wheel]

    def scene(self):
        last = len(self.radii) - 1
        points = {self.name(i): list(p) for i, p in enumerate(self.centers)}
        points["Q"] = list(add(self.centers[last], self.spot))
        points["B"] = [self.radii[0] * 0.7, 0.0]
        links = {str(i + 1): {"points": [self.name(i)]} for i in range(last + 1)}
        links["1"] = {"points": ["A", "B"], "drive": {"omega": self.omega, "alpha": 0}}
        links[str(last + 1)] = {"points": [self.name(last), "Q"]}
        loads = [{"name": "M", "on": str(last + 1), "couple": self.couple}]
        if self.force:
            loads.append({"name": "P", "on": str(last + 1), "at": "Q", "force": list(self.force)})
        return {"kinegon": 1, "title": "teeth", "units": {"length": "mm", "time": "s", "force": "N"}, "ground": [self.name(i) for i in range(last + 1)], "points": points,
                "links": links, "gears": [{"mesh": [str(i + 1), str(i + 2)], "teeth": self.teeth[i:i + 2], "on": "ground", "pressure": self.alpha} for i in range(last)],
                "forces": loads, "analysis": "static", "figure": {"panels": ["scheme", "forces"]}}


class Hand:
    """One sheet, from the last wheel to the first."""

    def __init__(self, train, scales, rng, mistake=None, size_=1.0):
        self.t, self.mu_l, self.mu_f, self.rng, self.size, self.mistake, self.made = train, *scales, rng, size_, mistake, False
        self.values, self.pick, self.everywhere = {}, rng.random(), rng.random() < 0.6
        count = len(train.radii)
        meshes = count - 1
        sums = 2 * meshes
        self.here = int(self.pick * (meshes if mistake == "radial-force-left-out" else sums))
        self.sum = 0
        at = [self.off(scaled(p, 1 / self.mu_l)) for p in train.centers]
        given = [(self.off(scaled(add(train.centers[-1], train.spot), 1 / self.mu_l)), train.force)] if train.force else []
        known, couple = given, train.couple
        for wheel in range(count - 1, 0, -1):
            inward = unit(add(at[wheel - 1], at[wheel], -1))
            share = train.radii[wheel] / (train.radii[wheel] + train.radii[wheel - 1])
            pitch = add(at[wheel], add(at[wheel - 1], at[wheel], -1), share)
            tangent = left(inward)
            moment = couple + sum(self.moment(place, force, at[wheel], place_is_pitch) for place_is_pitch, (place, force) in self.marked(known, given))
            arm = self.arm(pitch, tangent, at[wheel])
            tangential = self.written(-moment / arm)
            radial = abs(tangential) * math.tan(math.radians(train.alpha))
            if mistake == "radial-force-left-out" and (self.everywhere or wheel - 1 == self.here):
                radial, self.made = 0.0, True
            # Away from the other wheel.
            corner = self.lay(self.lay((0.0, 0.0), tangent, tangential), scaled(inward, -1), radial)
            mesh = self.read((0.0, 0.0), corner)
            total = corner
            for _, force in known:
                total = self.lay(total, unit(force), size(force))
            self.bearing(wheel, self.read(total, (0.0, 0.0)))
            known, couple = [(pitch, scaled(mesh, -1))], 0.0
            given = []
        moment = sum(self.moment(place, force, at[0], True) for place, force in known)
        self.values["T(1)"] = round(-moment) if self.size else -moment
        total = (0.0, 0.0)
        for _, force in known:
            total = self.lay(total, unit(force), size(force))
        self.bearing(0, self.read(total, (0.0, 0.0)))

    @staticmethod
    def marked(known, given):
        return [(own not in given, own) for own in known]

    def error(self, limit):
        return self.rng.uniform(-limit, limit) * self.size

    def off(self, p):
        return p[0] + self.error(MM), p[1] + self.error(MM)

    def written(self, x):
        return round(x, 1) if self.size else x

    def lay(self, start, along, amount):
        if not amount:
            return start
        return add(start, turned(along, self.error(DEGREES)), amount / self.mu_f + self.error(MM))

    def read(self, a, b):
        v = add(b, a, -1)
        return scaled(unit(v), self.written(size(v) + self.error(MM)) * self.mu_f)

    def bearing(self, wheel, force):
        name = f"R({self.t.name(wheel)},{wheel + 1})"
        self.values[f"{name}.size"] = size(force)
        self.values[f"{name}.angle"] = angle(turned(force, self.error(DEGREES)))

    def arm(self, place, along, about):
        """The arm of a force between teeth."""
        own, self.sum = self.sum, self.sum + 1
        mm = cross(add(place, about, -1), turned(along, self.error(DEGREES)))
        arm = self.written(mm + self.error(MM)) * self.mu_l
        if self.mistake == "diameter-for-radius" and (self.everywhere or own == self.here):
            arm, self.made = 2 * arm, True
        return arm

    def moment(self, place, force, about, is_of_teeth):
        if is_of_teeth:
            return size(force) * self.arm(place, unit(force), about)
        mm = cross(add(place, about, -1), turned(unit(force), self.error(DEGREES)))
        return size(force) * self.written(mm + self.error(MM)) * self.mu_l


class Rack:
    """A wheel that drives a rack, or a rack that drives a wheel."""

    def __init__(self, rng):
        self.radius, self.side = float(rng.randrange(15, 60)), rng.choice([-1, 1])
        self.turn, self.drives = rng.uniform(0, 360), rng.choice(["wheel", "rack"])
        self.rate, self.change = rng.choice([-6, -4, 3, 5]), rng.choice([0, 10, -15])
        self.spot = turned((self.radius * 0.8, 0.0), rng.uniform(0, 360))
        self.along = turned((1.0, 0.0), self.turn)

    def scene(self):
        r = scaled(left(self.along), -self.side * self.radius)
        links = {"1": {"points": ["A", "B"]}, "2": {"points": ["R"]}}
        slider = {"link": "2", "at": "R", "on": "ground", "along": list(self.along)}
        if self.drives == "wheel":
            links["1"]["drive"] = {"omega": self.rate, "alpha": self.change}
        else:
            slider["drive"] = {"speed": self.rate * 20, "acceleration": self.change * 20}
        return {"kinegon": 1, "title": "rack", "units": {"length": "mm", "time": "s"}, "ground": ["A"], "points": {"A": [0.0, 0.0], "B": list(self.spot), "R": list(r)},
                "links": links, "sliders": [slider],
                "gears": [{"mesh": ["1", "2"], "teeth": [20, "rack"], "radius": self.radius, "on": "ground"}]}

    def values(self, names, scales, rng, mistake):
        """Lengths of segments: the rack slides with ω r, its wheel has the points' ω·AB and √(α² + ω⁴)·AB."""
        if mistake == "radial-force-left-out":
            raise Stuck
        r = self.radius * (2 if mistake else 1)
        # Counter-clockwise the wheel takes the rack along its direction, or against it: as it lies.
        per = self.side * r
        w, e, v, a = (self.rate, self.change, self.rate * per, self.change * per) if self.drives == "wheel" else \
            (self.rate * 20 / per, self.change * 20 / per, self.rate * 20.0, self.change * 20.0)
        length = size(self.spot)
        right = {"vplan(p,r)": abs(v), "vplan(p,b)": abs(w) * length, "aplan(π,r)": abs(a), "aplan(π,b)": math.hypot(w * w, e) * length, "aplan(π,n_aB)": w * w * length,
                 "aplan(n_aB,b)": abs(e) * length, "omega(1)": w, "alpha(1)": e, "v_r(2/ground)": v, "a_r(2/ground)": a}
        found = {}
        for name in names:
            if name not in right:
                raise SystemExit(f"the hand has no {name}")
            # What rests, or does not change, is in the pole itself.
            noise = 0.0 if not right[name] else (rng.uniform(-MM, MM) + rng.uniform(-MM, MM)) * scales["v" if name.startswith("v") else "a"] if "plan" in name else 0.0
            found[name] = f"{abs(right[name] + noise) if 'plan' in name else right[name]:.4g}"
        return found


def template(kinegon, scene, work):
    (work / "scene.json").write_text(json.dumps(scene))
    done = subprocess.run([kinegon, "check", str(work / "scene.json"), "--template"], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{done.stderr}\n{json.dumps(scene)}")
    return json.loads(done.stdout)


def run(options):
    rng = random.Random(options.seed)
    survey = Survey(options, MISTAKES, lambda told, mistake: bool(told) and all(t == mistake for t in told))
    for index in range(options.scenes):
        with tempfile.TemporaryDirectory() as work:
            work = Path(work)
            is_rack = index % 4 == 3
            made = Rack(rng) if is_rack else Train(rng)
            form = template(options.kinegon, made.scene(), work)
            names = list(form["values"])
            if not is_rack:
                perfect = Hand(made, (form["mu_l"], form["mu_f"]), random.Random(1), size_=0.0)
                missing = [name for name in names if name not in perfect.values]
                if missing:
                    raise SystemExit(f"the hand has no {missing}")
                ratio = math.prod(-z / w for z, w in zip(made.teeth, made.teeth[1:]))
                total = made.couple + (cross(made.spot, made.force) if made.force else 0.0)
                if abs(perfect.values["T(1)"] + total * ratio) > 1e-6 * abs(total):
                    raise SystemExit("the hand's moments and the ratio of the teeth differ")
            sheets = [(None, n) for n in range(-(-options.honest // options.scenes))]
            sheets += [(mistake, n) for mistake in survey.wanted for n in range(-(-options.each // options.scenes * 2))]
            for mistake, number in sheets:
                try:
                    if is_rack:
                        form["values"] = made.values(names, {"v": form["mu_v"], "a": form["mu_a"]}, rng, mistake)
                    else:
                        hand = Hand(made, (form["mu_l"], form["mu_f"]), rng, mistake)
                        form["values"] = {name: f"{hand.values[name]:.5g}" if name[0] == "T" else f"{hand.values[name]:.1f}" for name in names}
                except Stuck:
                    continue
                key = f"{mistake or 'honest'}-{number}"
                form["name"], form["positive"] = key, "counter-clockwise"
                (work / f"{key}.json").write_text(json.dumps(form))
                kind = "rack" if is_rack else f"train of {len(made.radii)}"
                survey.judge(work / "scene.json", work / f"{key}.json", kind, mistake, kind, f"{kind}-{index}-{key}".replace(" ", "-"))
    return survey.report(least=90)


if __name__ == "__main__":
    sys.exit(run(arguments(__doc__)))
