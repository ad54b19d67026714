"""A hand for cams: plans of velocities and accelerations of round and flat profiles that touch, by the equivalent linkage, with a pencil's errors and one mistake on purpose.

    cams.py KINEGON [--scenes N] [--honest N] [--each N] [--mistake NAME] [--faults FOLDER] [--limits]

Its author's truth is the closing of the linkage in complex numbers, with differences of a small turn for the rates; it knows of Kinegon the forms alone.
"""

import cmath
import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

from survey import Survey, arguments

MM, DEGREES = 0.3, 0.3
MISTAKES = ["roller-radius-left-out", "wrong-centre-of-curvature", "sliding-left-out", "face-along-wrong-line"]


class Stuck(Exception):
    """It does not close, or the mistake cannot be made here."""


def dot(a, b):
    return (a.conjugate() * b).real


def cross(a, b):
    return (a.conjugate() * b).imag


def unit(a):
    if abs(a) < 1e-9:
        raise Stuck
    return a / abs(a)


class Cam:
    """A disc about K, 1, that turns about A at the origin; a follower: `slides` along a guide, `rocks` about D, or is `flat` and rocks about B."""

    def __init__(self, rng):
        self.kind = rng.choice(["slides", "rocks", "flat"])
        self.eccentric, self.disc = float(rng.randrange(12, 31)), float(rng.randrange(28, 61))
        self.turn, self.omega, self.alpha = float(rng.randrange(0, 360, 5)), rng.choice([-12, -8, 6, 10, 15]), rng.choice([0, 0, 20, -30])
        self.roller = float(rng.randrange(8, 26))
        self.is_roller = rng.random() < 0.7
        self.offset, self.along = float(rng.randrange(-12, 13, 2)), 90.0
        self.pivot = complex(rng.randrange(-130, -70, 2), rng.randrange(-30, 60, 2))
        self.arm = float(rng.randrange(60, 130, 2))
        self.length = float(rng.randrange(120, 190, 2))
        self.center()

    def crank(self, turn=None):
        return self.eccentric * cmath.exp(1j * math.radians(self.turn if turn is None else turn))

    def center(self, turn=None, distance=None):
        """The roller's centre, or the end of the flat face."""
        k = self.crank(turn)
        distance = distance or self.disc + self.roller
        if self.kind == "slides":
            square = distance ** 2 - (self.offset - k.real) ** 2
            if square <= 0:
                raise Stuck
            return complex(self.offset, k.imag + math.sqrt(square))
        b = k - self.pivot
        if self.kind == "rocks":
            cosine = (self.arm ** 2 + abs(b) ** 2 - distance ** 2) / (2 * self.arm * abs(b))
            if abs(cosine) > 0.97:
                raise Stuck
            return self.pivot + self.arm * unit(b) * cmath.exp(1j * math.acos(cosine))
        sine = self.disc / abs(b)
        if sine > 0.97:
            raise Stuck
        return self.pivot + self.length * unit(b) * cmath.exp(1j * math.asin(sine))

    def truth(self):
        """Velocity and acceleration of the roller's centre or of the face's end, by differences over the turn of the cam."""
        step = 0.02
        before, here, after = (self.center(self.turn + by) for by in (-step, 0.0, step))
        h = math.radians(step)
        first, second = (after - before) / (2 * h), (after - 2 * here + before) / h ** 2
        return first * self.omega, second * self.omega ** 2 + first * self.alpha

    def scene(self):
        scene = {"kinegon": 1, "title": self.kind, "units": {"length": "mm", "time": "s"}, "ground": {"A": [0, 0]},
                 "links": {"1": {"points": ["A", "K"], "lengths": {"AK": self.eccentric}, "drive": {"angle": self.turn, "omega": self.omega, "alpha": self.alpha}}},
                 "figure": {"panels": ["scheme", "velocity", "acceleration"]}}
        c = self.center()
        contact = {"links": ["1", "3"], "centers": ["K", "C"], "radii": [self.disc, self.roller], "roller": self.is_roller, "circular": True, "name": "2"}
        if self.kind == "slides":
            scene["links"]["3"] = {"points": ["C"]}
            scene["sliders"] = [{"link": "3", "at": "C", "on": "ground", "through": [self.offset, 0], "along": 90}]
            scene["near"] = {"C": [c.real, c.imag]}
        elif self.kind == "rocks":
            scene["ground"]["D"] = [self.pivot.real, self.pivot.imag]
            scene["links"]["3"] = {"points": ["D", "C"], "lengths": {"CD": self.arm}}
            scene["near"] = {"C": [c.real, c.imag]}
        else:
            scene["ground"]["B"] = [self.pivot.real, self.pivot.imag]
            scene["links"]["2"] = {"points": ["B", "E"], "lengths": {"BE": self.length}}
            scene["near"] = {"E": [c.real, c.imag]}
            contact = {"links": ["1", "2"], "centers": ["K"], "radii": [self.disc], "along": "BE", "circular": True}
        scene["contacts"] = [contact]
        return scene


class Hand:
    """One sheet."""

    def __init__(self, cam, scales, rng, mistake=None, size=1.0):
        self.cam, self.mu, self.rng, self.size, self.mistake = cam, scales, rng, size, mistake
        self.chance, self.made, self.sines, self.short = rng.random(), False, [], []
        self.read = {}
        if (mistake == "face-along-wrong-line") != (cam.kind == "flat") and mistake not in (None, "sliding-left-out"):
            raise Stuck
        (self.flat if cam.kind == "flat" else self.round)()
        if mistake and not self.made:
            raise Stuck

    # Acts

    def error(self, limit):
        return self.rng.uniform(-limit, limit) * self.size

    def off(self, p, sheet):
        return p + complex(self.error(MM), self.error(MM)) * self.mu[sheet]

    def direction(self, along):
        return unit(along) * cmath.exp(1j * math.radians(self.error(DEGREES)))

    def lay(self, start, along, amount, sheet):
        return start + self.direction(along) * (amount + self.error(MM) * self.mu[sheet])

    def cross(self, p, u, q, v, sheet):
        u, v = self.direction(u), self.direction(v)
        sine = cross(u, v)
        self.sines.append(abs(sine))
        if abs(sine) < 0.1:
            raise Stuck
        return self.off(p + u * cross(q - p, v) / sine, sheet)

    def measured(self, names, a, b, sheet):
        """A segment, as it is read and written."""
        value = max(abs(b - a) + (self.error(MM) + self.error(MM)) * self.mu[sheet], 0.0)
        value = float(f"{value:.4g}") if self.size else value
        self.read[names] = value
        return value

    def rate(self, x):
        return float(f"{x:.4g}") if self.size else x

    def crank(self):
        """The velocity and the acceleration of K."""
        cam, k = self.cam, self.k
        radius, w = cam.eccentric, cam.omega
        v = self.lay(0, 1j * k, w * radius, "v")
        a = self.lay(0, -k, w * w * radius, "a")
        if cam.alpha:
            a = self.lay(a, 1j * k, cam.alpha * radius, "a")
        return v, a

    # Mechanisms

    def round(self):
        cam, mistake = self.cam, self.mistake
        length = cam.disc + cam.roller
        distance = length
        if mistake == "roller-radius-left-out":
            self.made = True
            length = cam.disc if cam.is_roller or self.chance < 0.7 else cam.roller
            distance = length if self.rng.random() < 0.6 else distance
        self.k, self.c = self.off(cam.crank(), "l"), self.off(cam.center(distance=distance), "l")
        normal = self.c - self.k
        if mistake == "wrong-centre-of-curvature":
            self.made = True
            if cam.kind == "slides" or self.chance < 0.6:
                normal = self.c - 0
            else:
                normal = cam.pivot - self.k
            if self.rng.random() < 0.5:
                length = float(f"{abs(normal):.4g}")
        arm = self.c - cam.pivot
        ray = 1j if cam.kind == "slides" else 1j * arm
        v_k, a_k = self.crank()
        if mistake == "sliding-left-out":
            self.made, v_c = True, v_k
        else:
            v_c = self.cross(0, ray, v_k, 1j * normal, "v")
        other = "d" if cam.kind == "rocks" else "p"
        pc, kc = self.measured((other, "c"), 0, v_c, "v"), self.measured(("k", "c"), v_k, v_c, "v")
        if mistake == "sliding-left-out":
            kc = self.read["k", "c"] = 0.0
        w2 = self.rate(math.copysign(kc, dot(v_c - v_k, 1j * normal)) / length)
        along = math.copysign(pc, dot(v_c, ray))
        self.w = {"omega(2)": w2}
        n_k = self.lay(a_k, -normal, w2 * w2 * length, "a") if w2 else a_k
        if cam.kind == "slides":
            self.w["v_r(3/ground)"] = along
            begin = 0
        else:
            w3 = self.w["omega(3)"] = self.rate(along / cam.arm)
            begin = self.lay(0, -arm, w3 * w3 * cam.arm, "a") if w3 else 0
        a_c = self.cross(begin, ray, n_k, 1j * normal, "a")
        last = self.measured(("n_dC", "c") if cam.kind == "rocks" else ("π", "c"), begin, a_c, "a")
        nc = self.measured(("n_kC", "c"), n_k, a_c, "a")
        self.w["alpha(2)"] = self.rate(math.copysign(nc, dot(a_c - n_k, 1j * normal)) / length)
        last = math.copysign(last, dot(a_c - begin, ray))
        if cam.kind == "slides":
            self.w["a_r(3/ground)"] = last
        else:
            self.w["alpha(3)"] = self.rate(last / cam.arm)
        self.v = {"p": 0, "d": 0, "k": v_k, "c": v_c}
        self.a = {"π": 0, "d": 0, "k": a_k, "c": a_c, "n_kC": n_k, "n_dC": begin}
        self.found = v_c, a_c

    def flat(self):
        cam, mistake = self.cam, self.mistake
        self.k, e = self.off(cam.crank(), "l"), self.off(cam.center(), "l")
        b = cam.pivot
        face, arm = unit(e - b), self.k - b
        if mistake == "face-along-wrong-line":
            self.made = True
            way = int(self.chance * 4)
            wrong = unit([arm, self.k - 0, 1j * self.k, self.k - e][way])
            if dot(wrong, face) < 0:
                wrong = -wrong
            if abs(cross(wrong, face)) < 0.08 or abs(dot(wrong, face)) < 0.08:
                raise Stuck
            face = wrong
        length = self.rate(abs(arm) + (self.error(MM) + self.error(MM)) * self.mu["l"])
        v_k, a_k = self.crank()
        if mistake == "sliding-left-out":
            self.made, v_2 = True, v_k
        else:
            v_2 = self.cross(0, 1j * arm, v_k, face, "v")
        bk, kk = self.measured(("b", "k_2"), 0, v_2, "v"), self.measured(("k", "k_2"), v_k, v_2, "v")
        if mistake == "sliding-left-out":
            kk = self.read["k", "k_2"] = 0.0
        w2 = self.rate(math.copysign(bk, dot(v_2, 1j * arm)) / length)
        slide = math.copysign(kk, dot(v_k - v_2, face))
        n_b = self.lay(0, -arm, w2 * w2 * length, "a") if w2 else 0
        coriolis = 2 * w2 * slide
        k_k2 = self.lay(a_k, -1j * face, coriolis, "a") if coriolis else a_k
        a_2 = self.cross(n_b, 1j * arm, k_k2, face, "a")
        nt = self.measured(("n_bK_2", "k_2"), n_b, a_2, "a")
        kr = self.measured(("k_k2", "k_2"), k_k2, a_2, "a")
        e2 = self.rate(math.copysign(nt, dot(a_2 - n_b, 1j * arm)) / length)
        self.w = {"omega(2)": w2, "v_r(K/2)": slide, "alpha(2)": e2, "a_r(K/2)": math.copysign(kr, dot(k_k2 - a_2, face))}
        v_e = self.off(1j * w2 * (e - b), "v")
        a_e = self.off((1j * e2 - w2 * w2) * (e - b), "a")
        self.v = {"p": 0, "b": 0, "k": v_k, "k_2": v_2, "e": v_e}
        self.a = {"π": 0, "b": 0, "k": a_k, "k_2": a_2, "e": a_e, "n_bK_2": n_b, "k_k2": k_k2, "n_bE": self.off(-w2 * w2 * (e - b), "a"),
                  "n_k_2E": self.off(a_2 - w2 * w2 * (e - self.k), "a")}
        self.found = v_e, a_e

    # The form

    def values(self, names):
        written = {}
        for name in names:
            head, ends = name.partition("(")[0], tuple(name[name.index("(") + 1:-1].split(","))
            if head in ("vplan", "aplan"):
                sheet = head[0]
                plan = self.v if sheet == "v" else self.a
                a, b = ends
                known = self.read.get((a, b)) if sheet == ("v" if (a, b) in (("k", "c"), ("b", "k_2"), ("k", "k_2"), ("d", "c"), ("p", "c")) else "a") else None
                value = known if known is not None else max(abs(plan[b] - plan[a]) + (self.error(MM) + self.error(MM)) * self.mu[sheet], 0.0)
            else:
                value = self.w[name]
            written[name] = f"{value:.4g}"
        return written


def drawable(rng, kinegon, work):
    """A cam that a hand draws well, with its form; the hand's method without errors gives what differences do."""
    while True:
        try:
            cam = Cam(rng)
            v, a = cam.truth()
            (work / "scene.json").write_text(json.dumps(cam.scene()))
            done = subprocess.run([kinegon, "check", str(work / "scene.json"), "--template"], capture_output=True, text=True)
            if done.returncode:
                raise SystemExit(f"{done.stderr}\n{json.dumps(cam.scene())}")
            form = json.loads(done.stdout)
            scales = {"l": form["mu_l"], "v": form["mu_v"], "a": form["mu_a"]}
            perfect = Hand(cam, scales, random.Random(1), size=0.0)
        except Stuck:
            continue
        if abs(perfect.found[0] - v) > 1e-4 * abs(v) + 1e-3 or abs(perfect.found[1] - a) > 1e-4 * abs(a) + 1:
            raise SystemExit(f"{cam.kind}: the hand's method and differences are apart: {perfect.found}, {v}, {a}\n{json.dumps(cam.scene())}")
        segments = [float(perfect.values([name])[name]) / scales[name[0]] for name in form["values"] if "plan" in name]
        if min(perfect.sines) > 0.3 and min(segments) > 8:
            return cam, scales, form


def run(options):
    rng = random.Random(options.seed)
    survey = Survey(options, MISTAKES, lambda told, mistake: bool(told) and all(t == mistake for t in told))
    for index in range(options.scenes):
        with tempfile.TemporaryDirectory() as work:
            work = Path(work)
            cam, scales, form = drawable(rng, options.kinegon, work)
            names = list(form["values"])
            sheets = [(None, n) for n in range(-(-options.honest // options.scenes))]
            sheets += [(mistake, n) for mistake in survey.wanted for n in range(-(-options.each // options.scenes * 2))]
            for mistake, number in sheets:
                try:
                    form["values"] = Hand(cam, scales, rng, mistake).values(names)
                except Stuck:
                    continue
                key = f"{mistake or 'honest'}-{number}"
                form["name"], form["positive"] = key, "counter-clockwise"
                (work / f"{key}.json").write_text(json.dumps(form))
                survey.judge(work / "scene.json", work / f"{key}.json", cam.kind, mistake, cam.kind, f"{cam.kind}-{index}-{key}")
    return survey.report(least=90)


if __name__ == "__main__":
    sys.exit(run(arguments(__doc__)))
