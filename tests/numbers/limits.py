#!/usr/bin/env python3
"""Holds what `kinegon sweep` and `kinegon solve` say of limits, change points and extreme positions to the truth.

    python3 tests/numbers/limits.py target/release/kinegon          # some of each family: a minute
    python3 tests/numbers/limits.py target/release/kinegon --all    # 1 000 near-parallelograms in five ranges each, and as many others

Four-bars and slider-cranks have their limits and extreme positions in closed form, found here with 60 digits from the decimals of
the scene. Families: near-parallelograms, whose limits lie next to a change point; parallelograms; four-bars and slider-cranks of
any kind, whose motion begins anywhere, also 1e-4 to 1e-13 degrees from a limit. Exit code 1 where a printed digit is wrong, a limit
is missing or one too many, or two ranges of one scene tell different stories. Needs mpmath.
"""

import json
import random
import re
import subprocess
import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

from mpmath import acos, asin, atan2, cos, degrees, mp, mpf, radians, sin, sqrt

mp.dps = 60
TOLD = re.compile(r"(limit position|change point|extreme position|singular position)(?: near| at)? ?(?:at )?angle\(1\) = (-?[\d.]+(?:e-?\d+)?)°(?:: (.*))?")


def number(text):
    return mpf(text)


class Case:
    """A scene, and the angles at which its dyad is stretched or folded; whether branches cross there."""

    def __init__(self, scene, limits, changes, extremes, closest=1):
        self.scene, self.limits, self.changes, self.extremes, self.closest = scene, limits, changes, extremes, closest


def four_bar(a, b, c, f, angle, mode, omega="1"):
    """Lengths and angle as texts; the mode is the side of C from B to D."""
    A, B, C, F = map(number, (a, b, c, f))
    t = radians(number(angle))
    px, py = A * cos(t), A * sin(t)
    dx, dy = F - px, -py
    r = sqrt(dx * dx + dy * dy)
    along = (r * r + B * B - C * C) / (2 * r)
    across = sqrt(max(B * B - along * along, mpf(0))) * mode
    cx, cy = px + (along * dx - across * dy) / r, py + (along * dy + across * dx) / r
    limits, changes, extremes = [], [], []
    # How nearly crank, frame and dyad come to lie in one line, in parts of their lengths.
    closest = min(abs(abs(reach) - abs(ends)) for reach in (B + C, B - C) for ends in (F - A, F + A)) / (A + B + C + F)
    for reach in (B + C, abs(B - C)):
        near, far = reach * reach - (F - A) ** 2, (F + A) ** 2 - reach * reach
        if near == 0:
            changes.append(mpf(0))
        if far == 0:
            changes.append(mpf(180))
        if near > 0 and far > 0:
            half = degrees(atan2(sqrt(near), sqrt(far)))
            limits += [2 * half, -2 * half]
    # The rocker stops where crank and coupler lie in line: at ±γ for AC = a + b, and half a turn on for b − a.
    for reach, turn in ((A + B, 0), (B - A, 180)):
        if abs(reach) > 0 and abs(F - C) < abs(reach) < F + C:
            gamma = degrees(acos((reach * reach + F * F - C * C) / (2 * abs(reach) * F)))
            extremes += [s * gamma + (turn if reach > 0 else 180 + turn) for s in (1, -1)]
    scene = {
        "kinegon": 1, "units": {"length": "mm", "time": "s"}, "ground": {"A": [0, 0], "D": [f, 0]},
        "links": {"1": {"points": ["A", "B"], "lengths": {"AB": a}, "drive": {"angle": angle, "omega": omega}},
                  "2": {"points": ["B", "C"], "lengths": {"BC": b}}, "3": {"points": ["D", "C"], "lengths": {"CD": c}}},
        "near": {"C": [float(cx), float(cy)]},
    }
    return Case(scene, limits, changes, extremes, closest)


def slider_crank(r, l, e, angle, mode):
    R, L, E = map(number, (r, l, e))
    t = radians(number(angle))
    rise = R * sin(t) - E
    cx = R * cos(t) + mode * sqrt(max(L * L - rise * rise, mpf(0)))
    limits, changes = [], []
    for reach in (L, -L):
        height = E + reach
        if abs(height) == R:
            changes.append(mpf(90) if height > 0 else mpf(-90))
        elif abs(height) < R:
            base = degrees(asin(height / R))
            limits += [base, 180 - base]
    extremes = []
    for reach, turn in ((R + L, 0), (L - R, 180)):
        if abs(reach) > abs(E):
            # Crank and rod in line: the slider is as far as they reach.
            base = degrees(asin(E / reach))
            extremes += [base + turn, 180 - base + turn]
    scene = {
        "kinegon": 1, "units": {"length": "mm", "time": "s"}, "ground": {"A": [0, 0]},
        "links": {"1": {"points": ["A", "B"], "lengths": {"AB": r}, "drive": {"angle": angle, "omega": "1"}},
                  "2": {"points": ["B", "C"], "lengths": {"BC": l}}, "3": {"points": ["C"]}},
        "sliders": [{"link": "3", "at": "C", "on": "ground", "through": [0, e], "along": 0}],
        "near": {"C": [float(cx), float(e)]},
    }
    return Case(scene, limits, changes, extremes)


def text_of(value):
    """JSON with numbers as they are written."""
    if isinstance(value, dict):
        # A link's name may look like a number.
        told = {key: json.dumps(one) if key == "link" else text_of(one) for key, one in value.items()}
        return "{" + ", ".join(f"{json.dumps(key)}: {one}" for key, one in told.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(text_of, value)) + "]"
    if isinstance(value, str) and re.fullmatch(r"-?\d+(\.\d+)?(e-?\d+)?", value):
        return value
    return json.dumps(value)


def scene_text(scene):
    return text_of(scene)


def run(program, scene, *arguments):
    done = subprocess.run([program, arguments[0], "-", *arguments[1:]], input=scene_text(scene), capture_output=True, text=True, timeout=120)
    return done.stderr


def unit(text):
    digits, _, power = text.partition("e")
    decimals = len(digits.partition(".")[2])
    return mpf(10) ** (int(power or 0) - decimals)


def off(text, truths):
    """The distance of a printed angle from the nearest of some, whole turns apart."""
    value = number(text)
    return min((abs((value - truth + 180) % 360 - 180) for truth in truths), default=mpf(1000))


class Judge:
    def __init__(self, program):
        self.program, self.seen, self.wrong, self.digits = program, Counter(), [], Counter()

    def events(self, family, case, told):
        kinds = {"limit position": case.limits, "change point": case.changes, "extreme position": case.extremes}
        for kind, angle, rest in TOLD.findall(told):
            # Of extremes only those of the last link have their truth here.
            if kind == "extreme position" and not rest.startswith(("link 3", "slider 3")):
                continue
            self.seen[family, kind] += 1
            if kind == "singular position":
                # Two branches that pass each other within a 1e-10th of the lengths are not told apart, and that is said.
                if not (case.closest < 1e-10 and off(angle, [mpf(0), mpf(180)]) < mpf(10) ** -2 + unit(angle)):
                    self.wrong.append((family, "a singular position is told", case, told))
                continue
            error = off(angle, kinds[kind])
            self.digits[len(angle.partition(".")[2])] += 1
            if error > unit(angle) * (1 + mpf(10) ** -6) and error > mpf(10) ** -10 * (1 + mpf(10) ** -6):
                self.wrong.append((family, f"{kind} at {angle}, off by {mp.nstr(error, 3)}", case, told))

    def near_parallelogram(self, dice):
        a, b = dice.randint(20, 100), dice.randint(40, 200)
        gap = f"{10 ** dice.uniform(-12, -3):.3e}"
        longer = mp.nstr(mpf(b) + number(gap), 25)
        lengths = dice.choice([(a, longer, a, b), (a, b, a, longer), (mp.nstr(mpf(a) + number(gap), 25), b, a, b), (a, b, mp.nstr(mpf(a) + number(gap), 25), b)])
        case = four_bar(*map(str, lengths), str(dice.randint(20, 160)), dice.choice([1, -1]))
        stories = []
        for low, high in [(0, 60), (-1, 60), (0, 360), (-10, 10), (-30, 30)]:
            told = run(self.program, case.scene, "sweep", f"--from={low}", f"--to={high}", "--want", "omega(2)")
            self.events("near-parallelogram", case, told)
            stories.append((low, high, told))
        # One scene, one story: near 0 it is a limit, a change point or nothing, whatever the range.
        kinds = set()
        for _, _, told in stories:
            kinds |= {kind for kind, angle, _ in TOLD.findall(told) if kind != "extreme position" and abs((float(angle) + 180) % 360 - 180) < 1}
        if len(kinds) > 1:
            self.wrong.append(("near-parallelogram", f"two stories: {kinds}", case, "".join(told for *_, told in stories)))
        near = [limit for limit in case.limits if abs((limit + 180) % 360 - 180) < 1]
        if "singular position" not in kinds and bool(near) != ("limit position" in kinds):
            self.wrong.append(("near-parallelogram", f"limits {near}, told {kinds}", case, "".join(told for *_, told in stories)))
        for kind in kinds:
            places = {angle for _, _, told in stories for k, angle, _ in TOLD.findall(told) if k == kind}
            sizes = {abs((mpf(angle) + 180) % 360 - 180) for angle in places if abs((float(angle) + 180) % 360 - 180) < 1}
            if kind != "singular position" and len(sizes) > 1 and max(sizes) - min(sizes) > mpf(10) ** -9:
                self.wrong.append(("near-parallelogram", f"places differ: {places}", case, ""))

    def any(self, dice, family, make, lengths):
        """A motion that begins anywhere on its branch, or next to a limit."""
        case = make(*lengths, "0", 1)
        start = dice.uniform(-180, 180)
        if case.limits and dice.random() < 0.5:
            away = mpf(10) ** dice.uniform(-13, -4)
            limit = dice.choice(case.limits)
            inside = [side for side in (1, -1) if self.reaches(make, lengths, limit + side * away)]
            if not inside:
                return
            start = mp.nstr(limit + inside[0] * away, 25)
            family += " from next to a limit"
        elif not self.reaches(make, lengths, mpf(start)):
            return
        else:
            start = f"{start:.6f}"
        case = make(*lengths, start, dice.choice([1, -1]))
        told = run(self.program, case.scene, "sweep", "--want", "omega(2)")
        refused = "limit position" in told and "comes back" in told or "which of two ways" in told
        self.events(family, case, told)
        found = [angle for kind, angle, _ in TOLD.findall(told) if kind == "limit position"]
        if case.limits and not refused and len(found) != 2 and case.closest > 1e-10:
            self.wrong.append((family, f"{len(found)} limits", case, told))
        if not case.limits and found:
            self.wrong.append((family, "a limit where none is", case, told))

    @staticmethod
    def reaches(make, lengths, degrees_):
        t = radians(degrees_)
        if make is four_bar:
            a, b, c, f = map(number, lengths)
            r = sqrt(a * a + f * f - 2 * a * f * cos(t))
            return abs(b - c) < r < b + c
        r, l, e = map(number, lengths)
        return abs(r * sin(t) - e) < l


def main():
    program, is_all = sys.argv[1], "--all" in sys.argv
    count = 1000 if is_all else 40
    judge = Judge(program)

    def one(seed):
        dice = random.Random(seed)
        judge.near_parallelogram(dice)
        short = lambda low, high: f"{dice.uniform(low, high):.3f}"
        judge.any(dice, "four-bar", four_bar, [short(20, 120) for _ in range(4)])
        judge.any(dice, "slider-crank", slider_crank, [short(20, 120), short(20, 200), short(-60, 60)])

    with ThreadPoolExecutor(2) as pool:
        for done in [pool.submit(one, seed) for seed in range(count)]:
            done.result()
    for (family, kind), seen in sorted(judge.seen.items()):
        print(f"{family}: {seen} × {kind}")
    print("decimals printed:", dict(sorted(judge.digits.items())))
    print(f"{len(judge.wrong)} wrong")
    for family, what, case, told in judge.wrong[:10]:
        print(f"\n{family}: {what}\n{scene_text(case.scene)}\n{told}")
    sys.exit(bool(judge.wrong))


main()
