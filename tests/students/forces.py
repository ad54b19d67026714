"""A hand for force plans: finds what joints carry by moments and polygons on mechanisms of its own, errs as a pencil does, and makes one mistake on purpose.

Its author's truth is one system of equations: three of equilibrium for each link, with motions from a system of its own. The hand itself
takes moments with arms that it measures, and draws polygons, as the books do; of Kinegon it knows the forms alone.

    forces.py KINEGON [--scenes N] [--honest N] [--each N] [--mistake NAME] [--faults FOLDER] [--limits]

`survey.py` says how sheets are counted.
"""

import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

from survey import Survey, arguments

MM, DEGREES = 0.3, 0.3
G = 9810.0
K = 0.001  # N for kg mm/s²


class Stuck(Exception):
    """A hand does not draw this, or the mistake cannot be made here."""


def add(a, b, k=1.0):
    return a[0] + k * b[0], a[1] + k * b[1]


def scaled(a, k):
    return a[0] * k, a[1] * k


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def size(a):
    return math.hypot(*a)


def unit(a):
    s = size(a)
    if s < 1e-12:
        raise Stuck
    return a[0] / s, a[1] / s


def left(a):
    return -a[1], a[0]


def turned(a, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return a[0] * c - a[1] * s, a[0] * s + a[1] * c


def angle(a):
    return math.degrees(math.atan2(a[1], a[0]))


def solve(rows, right):
    n = len(right)
    m = [list(row) + [b] for row, b in zip(rows, right)]
    for i in range(n):
        p = max(range(i, n), key=lambda r: abs(m[r][i]))
        if abs(m[p][i]) < 1e-9:
            raise Stuck
        m[i], m[p] = m[p], m[i]
        for r in range(n):
            if r != i and m[r][i]:
                f = m[r][i] / m[i][i]
                m[r] = [x - f * y for x, y in zip(m[r], m[i])]
    return [m[i][n] / m[i][i] for i in range(n)]


# Mechanisms

class Mechanism:
    """Places in mm; links with their points; guides on the frame as (link, at, direction); the crank is link 1 about A."""

    def __init__(self, name, points, links, guides, ground, groups, omega):
        self.name, self.points, self.links, self.guides, self.ground = name, points, links, guides, ground
        self.groups, self.omega = groups, omega
        self.masses, self.forces, self.couples, self.static, self.gravity = {}, [], [], False, False

    def pins(self):
        """Joints: (place name, link, other link or 0)."""
        found = []
        for name in self.points:
            holders = [link for link, own in self.links.items() if name in own] + (["0"] if name in self.ground else [])
            if len(holders) == 2:
                found.append((name, *holders))
            elif len(holders) > 2:
                raise Stuck
        return found

    def rates(self):
        """By link: (v0, ω, a0, α) of the body's point at the origin."""
        links = list(self.links)
        index = {link: 3 * i for i, link in enumerate(links)}
        motion = {}
        for order in (0, 1):
            rows, right = [], []

            def equal(link, other, p, axis):
                row, b = [0.0] * (3 * len(links)), 0.0
                for own, sign in ((link, 1.0), (other, -1.0)):
                    if own == "0":
                        continue
                    i = index[own]
                    row[i] += sign * axis[0]
                    row[i + 1] += sign * axis[1]
                    row[i + 2] += sign * dot(left(p), axis)
                    if order:
                        w = motion[own][1]
                        b += sign * w * w * dot(p, axis)
                rows.append(row)
                right.append(b)

            for name, a, b in self.pins():
                for axis in ((1.0, 0.0), (0.0, 1.0)):
                    equal(a, b, self.points[name], axis)
            for link, at, along in self.guides:
                equal(link, "0", self.points[at], left(unit(along)))
                row = [0.0] * (3 * len(links))
                row[index[link] + 2] = 1.0
                rows.append(row)
                right.append(0.0)
            row = [0.0] * (3 * len(links))
            row[index["1"] + 2] = 1.0
            rows.append(row)
            right.append(self.omega if order == 0 else 0.0)
            x = solve(rows, right)
            for link in links:
                i = index[link]
                motion[link] = motion.get(link, ()) + ((x[i], x[i + 1]), x[i + 2])
        return motion

    def velocity(self, link, p):
        v0, w, _, _ = self.motion[link]
        return add(v0, left(p), w)

    def acceleration(self, link, p):
        _, w, a0, e = self.motion[link]
        return add(add(a0, left(p), e), p, -w * w)

    def loads(self):
        """By link: a list of (symbol, place, force), and a list of (symbol, couple)."""
        found = {link: ([], []) for link in self.links}
        for link, (m, j, at) in self.masses.items():
            if self.gravity:
                found[link][0].append((f"W{link}", at, (0.0, -K * m * G)))
            if not self.static:
                found[link][0].append((f"Fi{link}", at, scaled(self.acceleration(link, at), -K * m)))
                if self.motion[link][3]:
                    found[link][1].append((f"Mi{link}", -K * j * self.motion[link][3]))
        for name, link, at, force in self.forces:
            found[link][0].append((name, at, force))
        for name, link, couple in self.couples:
            found[link][1].append((name, couple))
        return {link: ([l for l in forces if size(l[2]) > 1e-9], [c for c in couples if abs(c[1]) > 1e-9]) for link, (forces, couples) in found.items()}

    def truth(self):
        """Reactions on links at pins, normal forces and couples of guides, the torque."""
        links, loads = list(self.links), self.loads()
        pins = self.pins()
        count = 2 * len(pins) + 2 * len(self.guides) + 1
        rows, right = [], []
        for link in links:
            forces, couples = loads[link]
            fx, fy, mo = [0.0] * count, [0.0] * count, [0.0] * count
            for i, (name, a, b) in enumerate(pins):
                p = self.points[name]
                for sign in [1.0] if a == link else [-1.0] if b == link else []:
                    fx[2 * i] += sign
                    fy[2 * i + 1] += sign
                    mo[2 * i] += -sign * p[1]
                    mo[2 * i + 1] += sign * p[0]
            for i, (own, at, along) in enumerate(self.guides):
                if own == link:
                    n, p, j = left(unit(along)), self.points[at], 2 * len(pins) + 2 * i
                    fx[j], fy[j], mo[j], mo[j + 1] = n[0], n[1], cross(p, n), 1.0
            if link == "1":
                mo[-1] = 1.0
            rows += [fx, fy, mo]
            total = [sum(f[i] for _, _, f in forces) for i in (0, 1)]
            moment = sum(cross(at, f) for _, at, f in forces) + sum(c for _, c in couples)
            right += [-total[0], -total[1], -moment]
        x = solve(rows, right)
        reactions = {}
        for i, (name, a, b) in enumerate(pins):
            reactions[name, a] = (x[2 * i], x[2 * i + 1])
            reactions[name, b] = (-x[2 * i], -x[2 * i + 1])
        guides = {link: (x[2 * len(pins) + 2 * i], x[2 * len(pins) + 2 * i + 1]) for i, (link, _, _) in enumerate(self.guides)}
        return reactions, guides, x[-1]

    def scene(self, panels, mu):
        links = {link: {"points": own} for link, own in self.links.items()}
        links["1"]["drive"] = {"omega": self.omega, "alpha": 0}
        for link, (m, j, at) in self.masses.items():
            links[link] |= {"mass": m, "center": list(at)} | ({"inertia": j} if j else {})
        scene = {"kinegon": 1, "title": self.name, "units": {"length": "mm", "time": "s", "mass": "kg", "force": "N"}, "ground": self.ground,
                 "points": {name: list(xy) for name, xy in self.points.items()}, "links": links,
                 "analysis": "static" if self.static else "dynamic",
                 "forces": [{"name": name, "on": link, "at": list(at), "force": list(force)} for name, link, at, force in self.forces]
                 + [{"name": name, "on": link, "couple": couple} for name, link, couple in self.couples],
                 "figure": {"panels": panels} | mu}
        if self.gravity:
            scene["gravity"] = [0, -G]
        if self.guides:
            scene["sliders"] = [{"link": link, "at": at, "on": "ground", "along": list(along)} for link, at, along in self.guides]
        return scene


def polar(xy, degrees, length):
    return round(xy[0] + length * math.cos(math.radians(degrees)), 1), round(xy[1] + length * math.sin(math.radians(degrees)), 1)


def between(a, b, part, aside=0.0):
    along = (b[0] - a[0], b[1] - a[1])
    at = add(add(a, along, part), left(unit(along)), aside)
    return round(at[0], 1), round(at[1], 1)


def some_force(rng, low=60, high=200):
    return tuple(round(x) * 1.0 for x in turned((rng.uniform(low, high), 0), rng.uniform(-180, 180)))


def mass(rng, mechanism, link, a, b):
    at = between(mechanism.points[a], mechanism.points[b], rng.uniform(0.3, 0.7), rng.choice([0, 0, 8, -8]))
    mechanism.masses[link] = (round(rng.uniform(2, 6), 1), round(rng.uniform(8000, 40000), -3), at)


def four_bar(rng):
    a, d = (0.0, 0.0), (float(rng.randrange(100, 200, 5)), float(rng.randrange(-20, 25, 5)))
    b = polar(a, rng.uniform(20, 340), rng.uniform(40, 70))
    c = polar(d, rng.uniform(20, 340), rng.uniform(70, 140))
    m = Mechanism("four-bar", {"A": a, "B": b, "C": c, "D": d}, {"1": ["A", "B"], "2": ["B", "C"], "3": ["D", "C"]}, [], ["A", "D"],
                  [("RRR", "B", "2", "C", "3", "D")], rng.choice([10, 15, 20, -10, -15]))
    return loaded(rng, m, [("2", "B", "C"), ("3", "C", "D")])


def slider_crank(rng):
    a, b = (0.0, 0.0), polar((0, 0), rng.uniform(20, 340), rng.uniform(40, 65))
    c = (round(b[0] + rng.uniform(90, 160), 1), float(rng.randrange(-20, 25, 5)))
    along = rng.choice([(1, 0), (1, 0), (1, 0.25), (1, -0.25)])
    m = Mechanism("slider-crank", {"A": a, "B": b, "C": c}, {"1": ["A", "B"], "2": ["B", "C"], "3": ["C"]}, [("3", "C", along)], ["A"],
                  [("RRP", "B", "2", "C", "3", 0)], rng.choice([10, 15, 20, -10, -15]))
    m = loaded(rng, m, [("2", "B", "C")])
    m.forces = [f for f in m.forces if f[1] != "3"]
    at = rng.choice([c, c, (c[0], c[1] + 20.0), (c[0], c[1] - 15.0)])
    m.forces.append(("Q", "3", at, tuple(round(x) * 1.0 for x in scaled(unit(along), rng.choice([-1, 1]) * rng.uniform(100, 250)))))
    return m


def six_bar(rng):
    """A four-bar whose rocker pushes a slider: two groups."""
    m = four_bar(rng)
    d, c = m.points["D"], m.points["C"]
    e = between(d, c, rng.uniform(0.6, 1.0), rng.choice([-25, 25, 20, -20]))
    f = (round(e[0] + rng.uniform(80, 130), 1), round(e[1] + rng.uniform(-30, 30), 0))
    m.name = "six-bar"
    m.points |= {"E": e, "F": f}
    m.links |= {"3": ["D", "C", "E"], "4": ["E", "F"], "5": ["F"]}
    m.guides = [("5", "F", (1, 0))]
    m.groups = m.groups + [("RRP", "E", "4", "F", "5", 0)]
    m.forces.append(("Q", "5", rng.choice([f, (f[0], f[1] + 15.0)]), (-round(rng.uniform(100, 200)) * 1.0, 0.0)))
    return m


def third_class(rng):
    """A central link on three legs."""
    a = (0.0, 0.0)
    b = polar(a, rng.uniform(0, 360), rng.uniform(35, 50))
    c = polar((90, 60), rng.uniform(0, 360), rng.uniform(0, 25))
    e = polar((160, 40), rng.uniform(0, 360), rng.uniform(0, 20))
    g = polar((130, 110), rng.uniform(0, 360), rng.uniform(0, 20))
    f = polar((175, -40), rng.uniform(0, 360), rng.uniform(0, 25))
    h = polar((210, 130), rng.uniform(0, 360), rng.uniform(0, 25))
    m = Mechanism("third-class", {"A": a, "B": b, "C": c, "E": e, "F": f, "G": g, "H": h},
                  {"1": ["A", "B"], "2": ["B", "C"], "3": ["C", "E", "G"], "4": ["F", "E"], "5": ["H", "G"]}, [], ["A", "F", "H"],
                  [("III", "3", [("B", "2", "C"), ("F", "4", "E"), ("H", "5", "G")])], rng.choice([8, 10, -10]))
    return loaded(rng, m, [("3", "C", "E"), ("2", "B", "C"), ("5", "H", "G")])


def fourth_class(rng):
    """Two links with three joints each, joined by two others; the crank drives one of them."""
    a, e = (0.0, 0.0), polar((200, 10), rng.uniform(0, 360), rng.uniform(0, 20))
    b = polar(a, rng.uniform(0, 360), rng.uniform(30, 45))
    c = polar((60, 80), rng.uniform(0, 360), rng.uniform(0, 20))
    g = polar((80, -50), rng.uniform(0, 360), rng.uniform(0, 20))
    d = polar((150, 95), rng.uniform(0, 360), rng.uniform(0, 20))
    f = polar((165, -65), rng.uniform(0, 360), rng.uniform(0, 20))
    m = Mechanism("fourth-class", {"A": a, "B": b, "C": c, "D": d, "E": e, "F": f, "G": g},
                  {"1": ["A", "B"], "2": ["B", "C", "G"], "3": ["C", "D"], "4": ["D", "E", "F"], "5": ["G", "F"]}, [], ["A", "E"],
                  [("IV", "B", "2", [("C", "3", "D"), ("G", "5", "F")], "4", "E")], rng.choice([8, 10, -10]))
    return loaded(rng, m, [("4", "D", "F"), ("2", "C", "G"), ("3", "C", "D")])


def loaded(rng, m, where):
    way = rng.random()
    if way < 0.25:
        m.static = True
        link, a, b = where[0] if len(where) == 1 else rng.choice(where[:2])
        m.forces.append(("P", link, between(m.points[a], m.points[b], rng.uniform(0.25, 0.75)), some_force(rng)))
        if rng.random() < 0.4:
            link = rng.choice(where)[0]
            m.couples.append(("M1", link, rng.choice([-1, 1]) * round(rng.uniform(3000, 9000), -2)))
        return m
    for link, a, b in where[:2]:
        if rng.random() < 0.75 or not m.masses:
            mass(rng, m, link, a, b)
    m.gravity = rng.random() < 0.5
    link, a, b = where[-1]
    if rng.random() < 0.6:
        m.forces.append(("P", link, between(m.points[a], m.points[b], rng.uniform(0.25, 0.9)), some_force(rng, 50, 120)))
    return m


KINDS = [four_bar, slider_crank, six_bar, third_class, fourth_class]

MISTAKES = ["inertia-along-a", "inertia-couple-along-alpha", "couple-forgotten", "percussion-on-wrong-side", "a-of-joint-for-centre",
            "centripetal-part-left-out", "arm-to-point", "arm-in-paper-mm", "reaction-not-reversed", "negative-tangential-kept",
            "normal-across", "force-missing-in-polygon", "twice", "guide-reaction-along-rod", "guide-reaction-through-pin",
            "mass-for-weight", "moment-about-wrong-point", "lever-not-turned", "couple-on-lever-unscaled", "torque-sense"]

ON_LEVER = ["inertia-along-a", "lever-not-turned", "couple-on-lever-unscaled", "torque-sense", "mass-for-weight", "arm-in-paper-mm"]

# Without the couple's own value on the form nobody can tell these apart.
SAME = [{"inertia-couple-along-alpha", "percussion-on-wrong-side"}]


# The sheet

class Force:
    """A force as the hand knows it: where it acts on paper, its direction, its size in N."""

    def __init__(self, symbol, at, along, amount):
        self.symbol, self.at, self.along, self.amount = symbol, at, along, amount

    def reversed(self, symbol=None):
        return Force(symbol or self.symbol, self.at, self.along, -self.amount)


class Sheet:
    """What one hand draws. `route` chooses among the ways of the books; `mistake` may change one act, and says so in `made`."""

    def __init__(self, m, mu_l, mu_f, rng, mistake=None, route=0, size_=1.0):
        self.m, self.mu_l, self.mu_f, self.rng, self.size = m, mu_l, mu_f, rng, size_
        self.mistake, self.made, self.route = mistake, None, route
        self.chance, self.pick = rng.random(), rng.random()
        self.at = {name: self.off(scaled(xy, 1 / mu_l)) for name, xy in m.points.items()}
        self.values, self.sines, self.short = {}, [], []
        self.known = {link: [] for link in m.links}
        self.couples = {link: [] for link in m.links}
        self.take_loads()
        self.sums = []
        for group in reversed(m.groups):
            {"RRR": self.rrr, "RRP": self.rrp, "III": self.third, "IV": self.fourth}[group[0]](*group[1:])
        self.crank()
        if mistake and any(0 < value / mu_f < 5 for name, value in self.values.items() if name.startswith("R(") and name.endswith(".size")):
            # He would see that nothing is left of a force.
            raise Stuck

    def error(self, limit):
        return self.rng.uniform(-limit, limit) * self.size

    def off(self, xy):
        return xy[0] + self.error(MM), xy[1] + self.error(MM)

    def draw(self, along):
        """A direction as the set square gives it."""
        return turned(along, self.error(DEGREES))

    def written(self, x, digits=1):
        return round(x, digits) if self.size else x

    # Loads

    def take_loads(self):
        targets = [link for link in self.m.masses]
        target = targets[int(self.pick * len(targets))] if targets else None
        loads = self.m.loads()
        for link, (forces, couples) in loads.items():
            for symbol, at, force in forces:
                force = self.wrong_load(symbol, link, at, force, link == target)
                amount = self.written(size(force), 1)
                if amount:
                    self.known[link].append(Force(symbol, self.off(scaled(at, 1 / self.mu_l)), unit(force), amount))
            for symbol, couple in couples:
                if self.mistake in ("inertia-couple-along-alpha", "percussion-on-wrong-side") and symbol.startswith("Mi") and link == target:
                    couple, self.made = -couple, True
                if self.mistake == "couple-forgotten" and not self.made:
                    self.made = True
                    continue
                self.couples[link].append((symbol, self.written(couple, 0)))

    def wrong_load(self, symbol, link, at, force, is_target):
        if not is_target:
            return force
        m, _, _ = self.m.masses[link]
        if symbol.startswith("Fi"):
            if self.mistake == "inertia-along-a":
                self.made = True
                return scaled(force, -1)
            joints = [name for name in self.m.links[link] if size(add(self.m.points[name], at, -1)) > 5]
            if not joints:
                raise Stuck
            joint = joints[int(self.chance * len(joints))]
            if self.mistake == "a-of-joint-for-centre":
                self.made = True
                return scaled(self.m.acceleration(link, self.m.points[joint]), -K * m)
            if self.mistake == "centripetal-part-left-out":
                self.made = True
                w = self.m.motion[link][1]
                without = add(self.m.acceleration(link, at), add(at, self.m.points[joint], -1), w * w)
                return scaled(without, -K * m)
        if symbol.startswith("W") and self.mistake == "mass-for-weight":
            self.made = True
            return (0.0, -m)
        if symbol.startswith("Fi") and self.mistake == "mass-for-weight" and not self.m.gravity:
            self.made = True
            return scaled(force, 1000 if self.chance < 0.5 else 0.001)
        return force

    # Moments

    def arm(self, force, about, paper=False):
        """Signed arm in mm of the mechanism, of a line drawn through where the force acts."""
        along = self.draw(force.along)
        mm = cross(add(force.at, about, -1), along)
        if self.to_point and not self.made and size(add(force.at, about, -1)) > abs(mm) + 2 and abs(mm) > 1:
            mm, self.made = math.copysign(size(add(force.at, about, -1)), mm), True
        if abs(mm) < 1e-9:
            return 0.0
        mm = self.written(mm + self.error(MM), 1)
        return mm * (1.0 if paper else self.mu_l)

    to_point = False

    def moment(self, forces, couples, about, paper=False):
        return sum(f.amount * self.arm(f, about, paper) for f in forces) + sum(c for _, c in couples)

    def begin(self, name):
        """Begins a sum of moments: the mistake may be made in it."""
        self.sums.append(name)
        wanted = int(self.pick * self.total) if self.total else 0
        is_here = len(self.sums) - 1 >= wanted and not self.made
        self.to_point = self.mistake == "arm-to-point" and is_here
        self.paper = self.mistake == "arm-in-paper-mm" and is_here and self.mu_l != 1
        self.elsewhere = self.mistake == "moment-about-wrong-point" and is_here

    total = 0

    def across(self, joint, to, links, name):
        """The part across the line of two joints, by moments of one link about the other one."""
        forces = [f for link in links for f in self.known[link]]
        couples = [c for link in links for c in self.couples[link]]
        if not forces and not couples:
            return None
        self.begin(name)
        along = left(unit(add(self.at[to], self.at[joint], -1)))
        about = self.at[to]
        if self.elsewhere:
            others = [p for n, p in self.at.items() if n not in (to, joint) and size(add(p, about, -1)) > 8]
            others = [p for p in others if abs(cross(add(self.at[joint], p, -1), along)) > 8]
            if others:
                about, self.made = others[int(self.chance * len(others))], True
        moment = self.moment(forces, couples, about, self.paper)
        arm = self.arm(Force(name, self.at[joint], along, 1.0), about)
        if self.paper and forces:
            self.made = True
        self.to_point = False
        if abs(arm) < 4 * self.mu_l:
            raise Stuck
        amount = self.written(-moment / arm, 1)
        self.values[name] = abs(amount)
        if not self.size and 0 < abs(amount) / self.mu_f < 4:
            self.short.append(name)
        if self.mistake == "negative-tangential-kept" and amount < 0 and not self.made and self.pick < 0.7:
            self.made, amount = True, -amount
        return Force(name, self.at[joint], along, amount) if amount else None

    # Polygons

    def chain(self, forces):
        """Corners of a polygon, the forces laid off one after another."""
        corners = [(0.0, 0.0)]
        spoil = None
        if self.mistake in ("force-missing-in-polygon", "twice") and not self.made and forces and self.chance < 0.8:
            spoil = int(self.pick * len(forces))
            # He would see that a polygon of nothing is none.
            rest = sum(abs(f.amount) for i, f in enumerate(forces) if i != spoil) / self.mu_f
            if abs(forces[spoil].amount) / self.mu_f < 4 or rest < 15:
                spoil = None
        for index, force in enumerate(forces):
            times = 1
            if index == spoil:
                times, self.made = (0 if self.mistake == "force-missing-in-polygon" else 2), True
            end = corners[-1]
            for _ in range(times):
                mm = force.amount / self.mu_f
                end = add(end, self.draw(force.along), mm + self.error(MM))
            corners.append(end)
        return corners

    def close(self, corners, last, first):
        """Where the direction `last` through the end and `first` through the start cross; the corner, and both as vectors of paper."""
        u, v = self.draw(last), self.draw(first)
        sine = cross(u, v)
        self.sines.append(abs(sine))
        if abs(sine) < 0.15:
            raise Stuck
        start, end = corners[0], corners[-1]
        t = cross(add(start, end, -1), v) / sine
        return self.off(add(end, u, t))

    def measured(self, a, b):
        """A segment of the polygon as it is read: vector in N."""
        v = add(b, a, -1)
        mm = size(v)
        if mm < 1e-6:
            return (0.0, 0.0)
        amount = self.written(mm + self.error(MM), 1) * self.mu_f
        if not self.size and mm < 8:
            self.short.append("polygon")
        return scaled(unit(v), amount)

    def reaction(self, pin, link, vector):
        """Notes what a pin does to a link, and hands it on to the other one."""
        self.values[f"R({pin},{link}).size"] = size(vector)
        if size(vector):
            self.values[f"R({pin},{link}).angle"] = angle(turned(unit(vector), self.error(DEGREES)))
        holders = [own for own, points in self.m.links.items() if pin in points and own != link]
        for other in holders:
            self.values[f"R({pin},{other}).size"] = size(vector)
            if size(vector):
                self.values[f"R({pin},{other}).angle"] = angle(scaled(turned(unit(vector), self.error(DEGREES)), -1))
        return vector

    def hand_on(self, pin, link, vector):
        for other, points in self.m.links.items():
            if pin in points and other != link and size(vector):
                sign = -1
                if self.mistake == "reaction-not-reversed" and not self.made:
                    sign, self.made = 1, True
                self.known[other].append(Force(f"R({pin},{other})", self.at[pin], scaled(unit(vector), sign), size(vector)))

    def order(self, forces):
        forces = list(forces)
        if self.route:
            self.rng.shuffle(forces)
        return forces

    def along_line(self, name, a, b):
        """The direction of a normal part."""
        along = unit(add(self.at[b], self.at[a], -1))
        if self.mistake == "normal-across" and not self.made and self.pick < 0.75:
            self.made = True
            return left(along)
        return along

    def rrr(self, p, a, c, b, q):
        first, last = self.across(p, c, [a], f"R_t({p},{a})"), self.across(q, c, [b], f"R_t({q},{b})")
        of_a, of_b = self.order(self.known[a]), self.order(self.known[b])
        if self.route == 2:
            # The other way round: from the last joint.
            corner_q, corner_p, between_, nq, np = self.dyad(last, of_b, of_a, first, (q, c, f"R_n({q},{b})"), (p, c, f"R_n({p},{a})"))
            rq, rp = corner_q, corner_p
            inner = scaled(between_, -1)
        else:
            rp, rq, inner, np, nq = self.dyad(first, of_a, of_b, last, (p, c, f"R_n({p},{a})"), (q, c, f"R_n({q},{b})"))
        self.values[f"R_n({p},{a})"], self.values[f"R_n({q},{b})"] = np, nq
        self.reaction(p, a, rp)
        self.reaction(q, b, rq)
        self.reaction(c, a, inner)
        self.hand_on(p, a, rp)
        self.hand_on(q, b, rq)

    def dyad(self, first, of_first, of_last, last, one, two):
        """The polygon of a dyad: both outer reactions, what the inner pin does to the first link, and both normal parts."""
        forces = ([first] if first else []) + of_first + of_last + ([last] if last else [])
        if not forces:
            raise Stuck
        corners = self.chain(forces)
        u1, u2 = self.along_line(one[2], one[0], one[1]), self.along_line(two[2], two[0], two[1])
        corner = self.close(corners, u2, u1)
        begin = corners[1] if first else corners[0]
        end = corners[-2] if last else corners[-1]
        middle = corners[(1 if first else 0) + len(of_first)]
        n1, n2 = size(self.measured(corner, corners[0])), size(self.measured(corners[-1], corner))
        return self.measured(corner, begin), self.measured(end, corner), self.measured(middle, corner), n1, n2

    def rrp(self, p, a, c, b, guide):
        link, at, along = self.m.guides[guide]
        name = f"R_t({p},{a})"
        first = self.across(p, c, [a], name)
        of_a, of_b = self.order(self.known[a]), self.order(self.known[b])
        forces = ([first] if first else []) + of_a + of_b
        if not forces:
            raise Stuck
        corners = self.chain(forces)
        normal = left(unit(along))
        if self.mistake == "guide-reaction-along-rod" and not self.made:
            self.made, normal = True, unit(along)
        corner = self.close(corners, normal, self.along_line(f"R_n({p},{a})", p, c))
        begin = corners[1] if first else corners[0]
        middle = corners[(1 if first else 0) + len(of_a)]
        rp, inner = self.measured(corner, begin), self.measured(middle, corner)
        n = self.measured(corners[-1], corner)
        self.values[f"R_n({p},{a})"] = size(self.measured(corner, corners[0]))
        amount = math.copysign(size(n), dot(n, normal))
        self.values[f"N({b}/ground)"] = amount
        self.reaction(p, a, rp)
        self.reaction(c, a, inner)
        # Where the guide's force acts: moments of the block about its pin.
        couple = 0.0
        if [f for f in self.known[b] if size(add(f.at, self.at[c], -1)) > 2] or self.couples[b]:
            self.begin(f"M({b}/ground)")
            self.elsewhere = False
            far = [f for f in self.known[b] if size(add(f.at, self.at[c], -1)) > 2]
            couple = -self.moment(far, self.couples[b], self.at[c], self.paper)
            if self.paper and far:
                self.made = True
            self.to_point = False
        if self.mistake == "guide-reaction-through-pin" and couple and not self.made:
            self.made, couple = True, 0.0
        self.values[f"M({b}/ground)"] = self.written(couple, 0)
        if amount:
            self.values[f"h({b}/ground)"] = self.written(couple / amount, 1)
        self.hand_on(p, a, rp)

    def third(self, central, legs):
        parts = {}
        for outer, link, inner in legs:
            parts[outer] = self.across(outer, inner, [link], f"R_t({outer},{link})")
        lines = {outer: (self.at[outer], unit(add(self.at[inner], self.at[outer], -1))) for outer, _, inner in legs}
        pairs = [(i, j) for i in range(3) for j in range(i + 1, 3)]
        i, j = max(pairs, key=lambda ij: abs(cross(lines[legs[ij[0]][0]][1], lines[legs[ij[1]][0]][1])))
        if self.route == 1:
            steep = [ij for ij in pairs if abs(cross(lines[legs[ij[0]][0]][1], lines[legs[ij[1]][0]][1])) > 0.45]
            i, j = self.rng.choice(steep) if steep else (i, j)
        k = 3 - i - j
        links = [central] + [leg[1] for leg in legs]
        forces = [f for link in links for f in self.known[link]] + [p for p in parts.values() if p]
        couples = [c for link in links for c in self.couples[link]]
        outer_k, link_k, inner_k = legs[k]
        rest = self.along_by_moments(f"R_n({outer_k},{link_k})", forces, couples, lines[legs[i][0]], lines[legs[j][0]],
                                     (self.at[outer_k], lines[outer_k][1]), [lines[o] for o in lines])
        (oi, li, ii), (oj, lj, ij) = legs[i], legs[j]
        order = [parts[oi], *self.order(self.known[li]), *self.order(self.known[central]), *self.order(self.known[link_k]), parts[outer_k], rest,
                 *self.order(self.known[lj]), parts[oj]]
        marks, chain = {}, []
        for index, force in enumerate(order):
            if force is not None:
                chain.append(force)
        corners = self.chain(chain)
        position = lambda force: corners[chain.index(force)] if force in chain else None
        corner = self.close(corners, self.along_line(f"R_n({oj},{lj})", oj, ij), self.along_line(f"R_n({oi},{li})", oi, ii))
        begin = corners[1] if parts[oi] else corners[0]
        end = corners[-2] if parts[oj] else corners[-1]
        self.values[f"R_n({oi},{li})"] = size(self.measured(corner, corners[0]))
        self.values[f"R_n({oj},{lj})"] = size(self.measured(corners[-1], corner))
        ri, rj = self.measured(corner, begin), self.measured(end, corner)
        of_k = [f for f in (parts[outer_k], rest) if f]
        if of_k:
            s = corners[chain.index(of_k[0])]
            e = corners[chain.index(of_k[-1]) + 1]
            rk = self.measured(s, e)
        else:
            rk = (0.0, 0.0)
        for (outer, link, inner), r in ((legs[i], ri), (legs[j], rj), (legs[k], rk)):
            self.reaction(outer, link, r)
            total = r
            for f in self.known[link]:
                total = add(total, f.along, f.amount)
            # What the inner pin does to the leg closes its own polygon.
            drawn = self.measured((0.0, 0.0), scaled(total, -1 / self.mu_f)) if size(total) else (0.0, 0.0)
            self.reaction(inner, link, drawn)
            self.hand_on(outer, link, r)

    def along_by_moments(self, name, forces, couples, one, two, unknown, lines):
        """A force along a line, by moments about the crossing of two others."""
        self.begin(name)
        pairs = [(one, two)]
        if self.elsewhere:
            others = [(a, b) for a in lines for b in lines if a is not b and {id(a), id(b)} != {id(one), id(two)}]
            extra = [p for n, p in self.at.items()]
            spots = [p for p in extra if abs(cross(add(unknown[0], p, -1), unknown[1])) > 12]
            if spots:
                about = spots[int(self.chance * len(spots))]
                self.made = True
                pairs = []
        if pairs:
            (p, u), (q, v) = pairs[0]
            u, v = self.draw(u), self.draw(v)
            sine = cross(u, v)
            self.sines.append(abs(sine))
            if abs(sine) < 0.2:
                raise Stuck
            about = self.off(add(p, u, cross(add(q, p, -1), v) / sine))
            if size(about) > 400:
                raise Stuck
        moment = self.moment(forces, couples, about, self.paper)
        arm = self.arm(Force(name, unknown[0], unknown[1], 1.0), about)
        if self.paper:
            self.made = True
        self.to_point = False
        if abs(arm) < 8 * self.mu_l:
            raise Stuck
        amount = self.written(-moment / arm, 1)
        self.values[name] = abs(amount)
        return Force(name, unknown[0], unknown[1], amount) if amount else None

    def fourth(self, b, drag, closures, other, e):
        """Links 2 (B, C, G) and 4 (D, E, F), closures CD and GF."""
        links = [drag, other] + [c[1] for c in closures]
        whole = self.across_of(b, e, links, f"R_t({b},{drag})")
        parts = {}
        for c, link, d in closures:
            found = self.across(c, d, [link], f"R_t({c},{link})")
            parts[c] = found.reversed() if found else None
        lines = {b: (self.at[b], unit(add(self.at[e], self.at[b], -1)))}
        for c, link, d in closures:
            lines[c] = (self.at[c], unit(add(self.at[d], self.at[c], -1)))
        names = [b] + [c[0] for c in closures]
        pairs = [(x, y) for i, x in enumerate(names) for y in names[i + 1:]]
        x, y = max(pairs, key=lambda xy: abs(cross(lines[xy[0]][1], lines[xy[1]][1])))
        if self.route == 1:
            steep = [xy for xy in pairs if abs(cross(lines[xy[0]][1], lines[xy[1]][1])) > 0.45]
            x, y = self.rng.choice(steep) if steep else (x, y)
        z = next(n for n in names if n not in (x, y))
        own = {b: whole, **parts}
        of_part = lambda n: f"R_n({n},{drag})" if n == b else f"R_n({n},{next(c[1] for c in closures if c[0] == n)})"
        forces = list(self.known[drag]) + [p for p in own.values() if p]
        rest = self.along_by_moments(of_part(z), forces, self.couples[drag], lines[x], lines[y], lines[z], list(lines.values()))
        chain = [own[x], *self.order(self.known[drag]), own[z], rest, own[y]]
        chain = [f for f in chain if f]
        corners = self.chain(chain)
        far = {b: e, **{c[0]: c[2] for c in closures}}
        corner = self.close(corners, self.along_line(of_part(y), y, far[y]), self.along_line(of_part(x), x, far[x]))
        begin = corners[1] if own[x] else corners[0]
        end = corners[-2] if own[y] else corners[-1]
        self.values[of_part(x)] = size(self.measured(corner, corners[0]))
        self.values[of_part(y)] = size(self.measured(corners[-1], corner))
        of_z = [f for f in (own[z], rest) if f]
        rz = self.measured(corners[chain.index(of_z[0])], corners[chain.index(of_z[-1]) + 1]) if of_z else (0.0, 0.0)
        on_drag = {x: self.measured(corner, begin), y: self.measured(end, corner), z: rz}
        for n in names:
            self.reaction(n, drag, on_drag[n])
        total = (0.0, 0.0)
        for c, link, d in closures:
            inside = scaled(on_drag[c], -1)
            for f in self.known[link]:
                inside = add(inside, f.along, f.amount)
            drawn = self.measured((0.0, 0.0), scaled(inside, -1 / self.mu_f)) if size(inside) else (0.0, 0.0)
            self.reaction(d, link, drawn)
            total = add(total, drawn, -1)
        for f in self.known[other]:
            total = add(total, f.along, f.amount)
        self.reaction(e, other, self.measured((0.0, 0.0), scaled(total, -1 / self.mu_f)))
        self.hand_on(b, drag, on_drag[b])

    def across_of(self, joint, to, links, name):
        return self.across(joint, to, links, name)

    def crank(self):
        known = self.known["1"]
        self.begin("T(1)")
        self.elsewhere = False
        moment = self.moment([f for f in known if size(add(f.at, self.at["A"], -1)) > 1], self.couples["1"], self.at["A"], self.paper)
        if self.paper:
            self.made = True
        self.to_point = False
        torque = -moment
        if self.mistake == "torque-sense":
            self.made, torque = True, -torque
        self.values["T(1)"] = self.written(torque, 0)
        if known:
            corners = self.chain(known)
            self.reaction("A", "1", self.measured(corners[-1], corners[0]))


class Lever:
    """Zhukovsky's lever as one hand draws it."""

    def __init__(self, m, mu_h, rng, mistake=None, size_=1.0):
        self.m, self.mu_h, self.rng, self.size, self.mistake, self.made = m, mu_h, rng, size_, mistake, None
        self.pick, self.chance = rng.random(), rng.random()
        self.values = {}
        total, loads = 0.0, m.loads()
        masses = list(m.masses)
        target = masses[int(self.pick * len(masses))] if masses else None
        for link, (forces, couples) in loads.items():
            powers = {}
            for symbol, at, force in forces:
                if symbol.startswith("Fi") and mistake == "inertia-along-a" and link == target:
                    self.made, force = True, scaled(force, -1)
                if symbol.startswith("W") and mistake == "mass-for-weight" and link == target:
                    self.made, force = True, (0.0, -m.masses[link][0])
                powers[symbol] = self.power(m.velocity(link, at), force)
            for symbol, couple in couples:
                own = "Fi" + symbol[2:] if symbol.startswith("Mi") else symbol
                powers[own] = powers.get(own, 0.0) + self.of_couple(link, couple)
            for symbol, power in powers.items():
                name = {"W": f"power(weight({link}))", "F": f"power(inertia({link}))"}.get(symbol[0] if symbol[1:] == link or symbol[:2] == "Fi" else "", f"power({symbol})")
                self.values[name] = float(f"{power:.4g}") if self.size else power
                total += self.values[name]
        torque = -total / m.omega
        if mistake == "torque-sense":
            self.made, torque = True, -torque
        self.values["T(1)"] = round(torque, 0) if self.size else torque

    def error(self, limit):
        return self.rng.uniform(-limit, limit) * self.size

    def image(self, velocity):
        if self.mistake == "lever-not-turned":
            self.made = True
        else:
            velocity = turned(velocity, -90)
        return velocity[0] / self.mu_h + self.error(MM), velocity[1] / self.mu_h + self.error(MM)

    def power(self, velocity, force):
        at = self.image(velocity)
        along = turned(unit(force), self.error(DEGREES))
        mm = cross(at, along)
        mm = round(mm + self.error(MM), 1) if self.size else mm
        if self.mistake == "arm-in-paper-mm":
            self.made = True
            return size(force) * mm
        return size(force) * mm * self.mu_h

    def of_couple(self, link, couple):
        if self.mistake == "couple-on-lever-unscaled":
            self.made = True
            return couple * (1.0 if self.chance < 0.5 else self.mu_h)
        points = [self.m.points[name] for name in self.m.links[link]]
        if link in self.m.masses:
            points.append(self.m.masses[link][2])
        a, b = max(((p, q) for p in points for q in points), key=lambda pq: size(add(*pq, -1)))
        l = size(add(b, a, -1))
        if l < 10:
            raise Stuck
        normal = left(unit(add(b, a, -1)))
        force = scaled(normal, couple / l)
        return self.power(self.m.velocity(link, b), force) + self.power(self.m.velocity(link, a), scaled(force, -1))


# Scenes

def drawable(kind, rng, kinegon, folder, on_lever):
    for _ in range(4000):
        try:
            m = kind(rng)
            m.motion = m.rates()
            reactions, guides, torque = m.truth()
        except Stuck:
            continue
        if on_lever and m.static and not m.forces:
            continue
        sizes = [size(r) for r in reactions.values()] + [abs(n) for n, _ in guides.values()] + [size(f[1]) for f in []]
        largest = max(sizes)
        if largest > 1500 or largest < 40 or abs(torque) < 300:
            continue
        mu_l = 2
        mu_f = next(x for x in (1, 2, 2.5, 4, 5, 10, 20) if largest / x < 110)
        speeds = [size(m.velocity(link, m.points[p])) for link, own in m.links.items() for p in own]
        mu_h = next((x for x in (2, 2.5, 4, 5, 10, 20, 25, 40, 50, 100) if max(speeds) / x < 110), None)
        if mu_h is None:
            continue
        try:
            if on_lever:
                perfect = Lever(m, mu_h, random.Random(1), size_=0.0)
            else:
                perfect = Sheet(m, mu_l, mu_f, random.Random(1), size_=0.0)
        except Stuck:
            continue
        if not on_lever:
            if any(abs(size(reactions[key]) - perfect.values[f"R({key[0]},{key[1]}).size"]) > 1e-6 * largest
                   for key in reactions if key[1] != "0" and f"R({key[0]},{key[1]}).size" in perfect.values):
                raise SystemExit(f"{m.name}: the hand's method and the equations differ")
            if any(s < 0.27 for s in perfect.sines) or perfect.short:
                continue
            if abs(perfect.values["T(1)"] - torque) > 1e-6 * abs(torque) or abs(torque) < 0.08 * largest * 50:
                continue
        elif abs(perfect.values["T(1)"] - torque) > 1e-6 * max(abs(torque), 1):
            raise SystemExit(f"{m.name}: the lever and the equations differ")
        elif max(abs(v) for n, v in perfect.values.items() if n != "T(1)") > 6 * abs(torque * m.omega):
            continue
        panels = ["scheme", "lever"] if on_lever else ["scheme", "forces"]
        mu = {"mu_l": mu_l} | ({"mu_h": mu_h} if on_lever else {"mu_f": mu_f})
        (folder / "scene.json").write_text(json.dumps(m.scene(panels, mu)))
        done = subprocess.run([kinegon, "check", str(folder / "scene.json"), "--template"], capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(f"{done.stderr}\n{(folder / 'scene.json').read_text()}")
        form = json.loads(done.stdout)
        names = list(form["values"])
        missing = [name for name in names if name not in perfect.values]
        if len(missing) > len(names) / 3:
            raise SystemExit(f"{m.name}: the hand has no {missing} of {names}: {sorted(perfect.values)}")
        return m, mu_l, mu_f, mu_h, form, names, len(getattr(perfect, "sums", []))
    raise SystemExit(f"no {kind.__name__} that a hand draws well")


def text(name, value):
    if name.startswith(("T", "M", "power")):
        return f"{value:.5g}" if abs(value) < 1e5 else f"{value:.0f}"
    return f"{value:.1f}"


def is_named(told, mistake):
    same = next((own for own in SAME if mistake in own), {mistake})
    return bool(told) and all(t in same for t in told)


def run(options):
    rng = random.Random(options.seed)
    survey = Survey(options, MISTAKES, is_named)
    for index in range(options.scenes):
        on_lever = index % 5 == 4
        kind = KINDS[(index // 5 if on_lever else index - index // 5) % len(KINDS)]
        with tempfile.TemporaryDirectory() as work:
            work = Path(work)
            m, mu_l, mu_f, mu_h, form, names, total = drawable(kind, rng, options.kinegon, work, on_lever)
            planted = {}

            def sheet(mistake, route):
                if on_lever:
                    return Lever(m, mu_h, rng, mistake)
                Sheet.total = total
                return Sheet(m, mu_l, mu_f, rng, mistake, route)

            def save(key, drawn, mistake, route):
                form["values"] = {name: text(name, drawn.values[name]) for name in names if name in drawn.values}
                form["name"] = key
                form["positive"] = "counter-clockwise"
                (work / f"{key}.json").write_text(json.dumps(form))
                planted[key] = (mistake, route)

            for number in range(-(-options.honest // options.scenes)):
                try:
                    route = rng.randrange(3)
                    save(f"honest-{number}", sheet(None, route), None, route)
                except Stuck:
                    pass
            for mistake in survey.wanted:
                if on_lever and mistake not in ON_LEVER or not on_lever and mistake in ("lever-not-turned", "couple-on-lever-unscaled"):
                    continue
                each = options.each // options.scenes * (5 if mistake in ("lever-not-turned", "couple-on-lever-unscaled") else 2)
                for number in range(max(each, 1)):
                    try:
                        route = rng.randrange(3)
                        drawn = sheet(mistake, route)
                    except (Stuck, ZeroDivisionError, IndexError):
                        continue
                    if drawn.made:
                        save(f"{mistake}-{number}", drawn, mistake, route)
            of = kind.__name__ + (" on a lever" if on_lever else "")
            for key, (mistake, route) in planted.items():
                route = "lever" if on_lever else f"route {route}"
                survey.judge(work / "scene.json", work / f"{key}.json", of, mistake, route, f"{kind.__name__}-{index}-{key}")
    return survey.report(least=85)


if __name__ == "__main__":
    sys.exit(run(arguments(__doc__)))
