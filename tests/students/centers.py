"""A hand for instant centres: finds them by Kennedy's lines on mechanisms of its own, errs as a pencil does, and makes one mistake on purpose.

Its author's Kennedy works with homogeneous coordinates on paper, looks for its own order of centres and knows of Kinegon the forms alone.

    centers.py KINEGON [--scenes N] [--honest N] [--each N] [--mistake NAME] [--faults FOLDER] [--limits]

Each scene is a random mechanism whose centres a hand draws well. `survey.py` says how sheets are counted.
"""

import itertools
import json
import math
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from survey import Survey, arguments

MM, DEGREES = 0.3, 0.3


# Points and lines of the projective plane, as triples

def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def norm(a):
    size = math.hypot(*a[:2]) if abs(a[2]) < 1e-12 else math.hypot(*a)
    return tuple(x / size for x in a)


def point(xy):
    return (xy[0], xy[1], 1.0)


def is_far(p):
    return abs(p[2]) <= 1e-9 * math.hypot(p[0], p[1])


def place(p):
    return p[0] / p[2], p[1] / p[2]


def sine(a, b):
    """Of the angle between two lines; 1 where one is the line at infinity."""
    sizes = math.hypot(*a[:2]) * math.hypot(*b[:2])
    return 1.0 if sizes < 1e-12 else abs(a[0] * b[1] - a[1] * b[0]) / sizes


def distance(a, b):
    return math.hypot(a[0] - b[0], a[1] - b[1])


def pair(i, j):
    return tuple(sorted((i, j)))


# Mechanisms

class Mechanism:
    """Places in mm, links with their points, guides as (link, at, on, direction); `0` is the frame."""

    def __init__(self, name, points, links, guides, ground, velocity, omega):
        self.name, self.points, self.links, self.guides = name, points, {"0": ground, **links}, guides
        self.velocity, self.omega = velocity, omega

    def permanent(self):
        """Centres in joints: pins, and points at infinity normal to guides."""
        known = {}
        for name, xy in self.points.items():
            holders = [link for link, own in self.links.items() if name in own]
            for a, b in itertools.combinations(holders, 2):
                known[pair(a, b)] = ("pin", name)
        for index, (link, _, on, _) in enumerate(self.guides):
            known[pair(link, on)] = ("guide", index)
        return known

    def scene(self, mu, wanted):
        name = lambda link: "ground" if link == "0" else link
        links = {link: {"points": own} for link, own in self.links.items() if link != "0"}
        links["1"]["drive"] = {"omega": self.omega, "alpha": 0}
        centers = wanted if wanted == "all" else [f"P({name(b)},{name(a)})" if a == "0" else f"P({a},{b})" for a, b in wanted]
        sliders = [{"link": link, "at": at, "on": name(on), "along": list(along)} for link, at, on, along in self.guides]
        scene = {"kinegon": 1, "title": self.name, "units": {"length": "mm", "time": "s"}, "ground": self.links["0"],
                 "points": {name: list(xy) for name, xy in self.points.items()}, "links": links,
                 "figure": {"panels": ["scheme", "centers"], "centers": centers, "velocities": [self.velocity], "mu_c": mu}}
        return scene | ({"sliders": sliders} if sliders else {})


def polar(xy, angle, length):
    return round(xy[0] + length * math.cos(math.radians(angle)), 1), round(xy[1] + length * math.sin(math.radians(angle)), 1)


def four_bar(rng):
    a, d = (0.0, 0.0), (float(rng.randrange(80, 160, 5)), float(rng.randrange(-20, 25, 5)))
    b = polar(a, rng.uniform(20, 340), rng.uniform(35, 70))
    c = polar(d, rng.uniform(20, 340), rng.uniform(50, 120))
    return Mechanism("four-bar", {"A": a, "B": b, "C": c, "D": d}, {"1": ["A", "B"], "2": ["B", "C"], "3": ["D", "C"]}, [], ["A", "D"], "C",
                     rng.choice([5, 8, 10, -6, -10])), "all"


def slider_crank(rng):
    a, b = (0.0, 0.0), polar((0, 0), rng.uniform(20, 340), rng.uniform(35, 60))
    c = (round(b[0] + rng.uniform(70, 140), 1), float(rng.randrange(-20, 25, 5)))
    return Mechanism("slider-crank", {"A": a, "B": b, "C": c}, {"1": ["A", "B"], "2": ["B", "C"], "3": ["C"]}, [("3", "C", "0", (1, 0))], ["A"],
                     "C", rng.choice([5, 8, 10, -6, -10])), "all"


def inclined(rng):
    """A slider on an inclined guide."""
    mechanism, wanted = slider_crank(rng)
    along = rng.choice([(1, 0.5), (1, -0.5), (0.5, 1), (0, 1)])
    return Mechanism("inclined", mechanism.points, mechanism.links, [("3", "C", "0", along)], ["A"], "C", mechanism.omega), wanted


def slotted_lever(rng):
    a, d = (0.0, 0.0), (float(rng.randrange(-30, 35, 5)), -float(rng.randrange(80, 130, 5)))
    b = polar(a, rng.uniform(-40, 220), rng.uniform(35, 60))
    angle = math.degrees(math.atan2(b[1] - d[1], b[0] - d[0]))
    c = polar(d, angle, distance(b, d) + rng.uniform(20, 60))
    along = (round(b[0] - d[0], 1), round(b[1] - d[1], 1))
    return Mechanism("slotted-lever", {"A": a, "B": b, "C": c, "D": d}, {"1": ["A", "B"], "2": ["B"], "3": ["D", "C"]},
                     [("2", "B", "3", along)], ["A", "D"], "C", rng.choice([5, 8, -6])), "all"


def toggle(rng):
    """Five links, three of them in the pin C."""
    d = (0.0, 0.0)
    c = polar(d, rng.uniform(-160, -100), rng.uniform(60, 100))
    e = (0.0, round(c[1] - rng.uniform(60, 110), 1))
    b = polar(c, rng.uniform(130, 230), rng.uniform(70, 120))
    a = polar(b, rng.uniform(20, 340), rng.uniform(30, 55))
    wanted = [("1", "5"), ("0", "2"), ("0", "4")]
    return Mechanism("toggle", {"A": a, "B": b, "C": c, "D": d, "E": e},
                     {"1": ["A", "B"], "2": ["B", "C"], "3": ["D", "C"], "4": ["C", "E"], "5": ["E"]}, [("5", "E", "0", (0, 1))], ["A", "D"], "E",
                     rng.choice([5, 8, -6])), rng.choice([wanted, wanted[:2], [("1", "4"), ("0", "4")]])


def six_bar(rng):
    """A four-bar with a dyad on its coupler."""
    a, d = (0.0, 0.0), (float(rng.randrange(80, 130, 5)), 0.0)
    b = polar(a, rng.uniform(20, 200), rng.uniform(30, 55))
    c = polar(d, rng.uniform(30, 150), rng.uniform(50, 100))
    e = polar(((b[0] + c[0]) / 2, (b[1] + c[1]) / 2), rng.uniform(0, 360), rng.uniform(30, 70))
    g = (float(rng.randrange(140, 220, 5)), float(rng.randrange(-30, 60, 5)))
    f = polar(g, rng.uniform(40, 200), rng.uniform(45, 90))
    return Mechanism("six-bar", {"A": a, "B": b, "C": c, "D": d, "E": e, "F": f, "G": g},
                     {"1": ["A", "B"], "2": ["B", "C", "E"], "3": ["D", "C"], "4": ["E", "F"], "5": ["G", "F"]}, [], ["A", "D", "G"], "F",
                     rng.choice([5, 8, -6])), [("0", "2"), ("1", "5")]


KINDS = [four_bar, slider_crank, inclined, slotted_lever, toggle, six_bar]


# The order: fewest crossings, then the steepest

class Stuck(Exception):
    """No lines lead on, or a hand does not draw them well."""


def lines_for(known, links, target):
    """The lines over third links to a centre, those whose two centres are apart: link, line."""
    i, j = target
    found = []
    for k in links:
        if k in target or pair(i, k) not in known or pair(j, k) not in known:
            continue
        a, b = known[pair(i, k)], known[pair(j, k)]
        if not is_far(a) and not is_far(b) and distance(place(a), place(b)) < 6:
            continue
        line = cross(a, b)
        if math.hypot(*line) > 1e-9:
            found.append((k, line))
    return found


def order(mechanism, exact, wanted):
    """The centres to be found one after another, each with the links of its two lines."""
    links = list(mechanism.links)
    known, ways = dict(exact), {}
    while True:
        new = {}
        for target in itertools.combinations(sorted(links), 2):
            if target in known:
                continue
            pairs = itertools.combinations(lines_for(known, links, target), 2)
            best = max(pairs, key=lambda two: sine(two[0][1], two[1][1]), default=None)
            if best is not None and sine(best[0][1], best[1][1]) > 0.34:
                new[target] = best
        if not new:
            break
        for target, (one, two) in new.items():
            known[target] = cross(one[1], two[1])
            ways[target] = (one[0], two[0])
    needed = []

    def need(target):
        if target in exact or target in needed:
            return
        if target not in ways:
            raise Stuck
        for k in ways[target]:
            need(pair(target[0], k))
            need(pair(target[1], k))
        needed.append(target)

    for target in wanted:
        need(target)
    return [(target, ways[target]) for target in needed]


# The sheet

class Sheet:
    """What one hand draws, in mm of paper with y up; `mistake` may change it, and says so in `made`."""

    def __init__(self, mechanism, mu, ways, rng, mistake=None, size=1.0, right=()):
        self.mechanism, self.mu, self.rng, self.size = mechanism, mu, rng, size
        self.mistake, self.made = mistake, None
        self.at = {name: self.off((x / mu, y / mu)) for name, (x, y) in mechanism.points.items()}
        self.links, self.segments, self.right = list(mechanism.links), [], right
        self.known, self.pins = {}, {}
        self.choose()
        for target, (kind, what) in mechanism.permanent().items():
            if kind == "pin":
                self.known[target], self.pins[target] = point(self.at[what]), what
            else:
                self.known[target] = self.towards_guide(what)
        for target, over in ways:
            self.find(target, over)

    def error(self, limit):
        return self.rng.uniform(-limit, limit) * self.size

    def off(self, xy):
        return xy[0] + self.error(MM), xy[1] + self.error(MM)

    def choose(self):
        """What the mistake is made at."""
        m = self.mechanism
        self.guide = self.rng.randrange(len(m.guides)) if m.guides else None
        self.chance = self.rng.random()

    def direction(self, guide):
        link, at, on, (x, y) = self.mechanism.guides[guide]
        return math.atan2(y, x)

    def towards_guide(self, guide):
        along = self.direction(guide)
        if self.mistake == "centre-along-guide" and guide == self.guide:
            self.made = True
            return (math.cos(along), math.sin(along), 0.0)
        if self.mistake == "centre-at-slider" and guide == self.guide:
            self.made = True
            return point(self.at[self.mechanism.guides[guide][1]])
        return (-math.sin(along), math.cos(along), 0.0)

    def line(self, target, k):
        """The line of a centre over a third link, drawn by the hand."""
        ends = [pair(i, k) for i in target]
        a, b = (self.known[end] for end in ends)
        if self.mistake == "pin-of-three" and self.missed in ends and self.elsewhere:
            a, b = (self.elsewhere if end == self.missed else self.known[end] for end in ends)
            self.made = True
        if not is_far(a) and not is_far(b) and distance(place(a), place(b)) < 1:
            # Two places in one: he sees that, and takes the right direction.
            guide = next(i for i, (link, _, on, _) in enumerate(self.mechanism.guides) if pair(link, on) in ends)
            along = self.direction(guide)
            b = (-math.sin(along), math.cos(along), 0.0)
        if is_far(a) and is_far(b):
            return None, (0.0, 0.0, 1.0)
        if is_far(a) or is_far(b):
            far, near = (a, b) if is_far(a) else (b, a)
            turn = math.atan2(far[1], far[0]) + math.radians(self.error(DEGREES))
            far = (math.cos(turn), math.sin(turn), 0.0)
            return (near, None), cross(near, far)
        return (a, b), cross(a, b)

    missed, elsewhere = None, None

    def find(self, target, over):
        if self.mistake == "pin-of-three" and self.missed is None:
            self.miss(target, over)
        drawn = [self.line(target, k) for k in over]
        lines = [line for _, line in drawn]
        at = self.crossing(target, drawn, lines)
        if at is None:
            at = cross(*lines)
            if is_far(at) or math.hypot(*place(at)) > 3000:
                if abs(at[2]) > 1e-6 * math.hypot(*at[:2]):
                    raise Stuck
            else:
                at = point(self.off(place(at)))
        # He would see that a new centre is an old one; in the pin of a block he seeks it.
        if self.mistake not in (None, "centre-at-slider") and not is_far(at):
            marked = list(self.at.values()) + [place(p) for p in self.known.values() if not is_far(p)]
            if any(distance(place(at), other) < 5 for other in marked):
                raise Stuck
        self.known[target] = at
        self.segments += [d for d in drawn if d[0] is not None]

    def miss(self, target, over):
        """The third pair of a pin of three, sought where two lines of the sheet cross."""
        for k in over:
            for end in (pair(i, k) for i in target):
                pin = self.pins.get(end)
                same = [own for own, name in self.pins.items() if name == pin]
                if pin is not None and len(same) > 2:
                    lines = [line for _, line in self.segments]
                    lines += [cross(point(self.at[a]), point(self.at[b]))
                              for own in self.mechanism.links.values() for a, b in itertools.combinations(own, 2)]
                    places = self.free_crossings(itertools.combinations(lines, 2))
                    if places:
                        self.missed, self.elsewhere = end, point(self.rng.choice(places))
                        return

    def free_crossings(self, pairs):
        """Crossings that are on the sheet and on no point of it."""
        found = []
        for a, b in pairs:
            if sine(a, b) < 0.2:
                continue
            at = cross(a, b)
            if is_far(at):
                continue
            xy = place(at)
            if self.free(xy) and math.hypot(*xy) < 300:
                found.append(xy)
        return found

    def crossing(self, target, drawn, lines):
        """Where the mistake marks a centre in place of the crossing of its lines."""
        if self.made is not None:
            return None
        if self.mistake == "lines-without-common-link" and self.segments and self.chance < 0.9:
            others = [line for _, line in self.segments]
            pairs = [(own, other) for own in lines for other in others]
            places = self.free_crossings(pairs)
            if places and self.rng.random() < 0.6:
                self.made = target
                return point(self.off(self.rng.choice(places)))
        if self.mistake == "not-extended":
            ends = [e for e, _ in drawn]
            if all(e is not None and e[1] is not None for e in ends):
                (a, b), (c, d) = [[place(p) for p in e] for e in ends]
                for one, two in ((a, c), (b, d)), ((a, d), (b, c)):
                    xy = inside(one, two)
                    if xy and self.free(xy):
                        self.made = target
                        return point(self.off(xy))
        return None

    def free(self, xy):
        marked = list(self.at.values()) + [place(p) for p in self.known.values() if not is_far(p)] + list(self.right)
        return all(distance(xy, other) > 8 for other in marked)

    # Numbers

    def measure(self, a, b):
        return round(distance(a, b) + self.error(MM), 1)

    def spot(self, name):
        """A point by its name in a form: a joint, or a centre."""
        if name.startswith("P("):
            i, j = ("0" if part == "ground" else part for part in name[2:-1].split(","))
            at = self.known[pair(i, j)]
            if is_far(at):
                raise Stuck
            return place(at)
        return self.at[name]

    def values(self, names):
        written, rates = {}, {"1": self.mechanism.omega}
        scale = self.mu
        unscaled = self.mistake == "lengths-without-scale"
        if unscaled:
            self.made, scale = True, 1.0
        for name in names:
            head, _, tail = name.partition("(")
            if head == "P":
                own = self.spot(name[:-2])
                mm = round(own["xy".index(name[-1])] + self.error(MM), 1)
                written[name] = mm * (self.mu if unscaled and self.chance < 0.5 else scale)
            elif head == "L":
                written[name] = self.length(name) * scale
            elif head == "omega":
                link = tail[:-1]
                rates[link] = self.rate(link, written, rates)
                written[name] = rates[link]
            elif head == "v" and name.endswith(".size"):
                speed, way = self.speed(names, written, rates)
                written[name] = speed
            elif head == "v":
                written[name] = way
        return {name: text(name, value) for name, value in written.items()}

    def length(self, name):
        a, b = split(name[2:-1])
        found = self.measure(self.spot(a), self.spot(b))
        if found < 5:
            raise Stuck
        return found

    def rate(self, link, written, rates):
        common, own, first = (self.known[pair(*two)] for two in (("1", link), ("0", link), ("0", "1")))
        if is_far(common):
            return rates["1"]
        find = lambda a: next(value for name, value in written.items() if name.startswith(f"L(P({a},ground)") and "ground),P(" in name)
        mine, given = find(link), find("1")
        (x, y), (a, b), (c, d) = place(common), place(own), place(first)
        sense = math.copysign(1, (x - a) * (x - c) + (y - b) * (y - d))
        ratio = given / mine
        if self.mistake == "ratio-inverted":
            self.made, ratio = True, 1 / ratio
        if self.mistake == "sense-by-centre":
            self.made, sense = True, -sense
        return rates["1"] * ratio * sense

    def speed(self, names, written, rates):
        """Size and direction of the velocity."""
        arm = [name for name in names if name.startswith("L(") and name in written][-1]
        a, b = split(arm[2:-1])
        link = a[2:-1].split(",")[0]
        length, start = written[arm], self.spot(a)
        end = self.at[self.mechanism.velocity]
        translates = b.startswith("P(")
        if translates:
            end = self.spot(b)
        ray, rate = math.degrees(math.atan2(end[1] - start[1], end[0] - start[0])), rates[link]
        if self.mistake == "distance-from-wrong-centre":
            wrong = [place(p) for two, p in self.known.items() if link in two and "0" not in two and not is_far(p)]
            wrong = [p for p in wrong if distance(p, start) > 10 and distance(p, end) > 10]
            if wrong:
                self.made, centre = True, self.rng.choice(wrong)
                length = self.measure(centre, end) * self.mu
                written[arm] = length
                if self.chance < 0.5:
                    ray = math.degrees(math.atan2(end[1] - centre[1], end[0] - centre[0]))
        way = ray + math.copysign(90, rate)
        if self.mistake == "velocity-along-ray":
            self.made, way = True, ray + (0 if self.chance < 0.5 else 180)
        way += self.error(DEGREES) + self.error(DEGREES)
        return abs(rate) * length, (way + 180) % 360 - 180


def inside(one, two):
    """Where two segments cross within both."""
    (a, b), (c, d) = one, two
    u, v, w = (b[0] - a[0], b[1] - a[1]), (d[0] - c[0], d[1] - c[1]), (c[0] - a[0], c[1] - a[1])
    area = u[0] * v[1] - u[1] * v[0]
    if abs(area) < 1e-9:
        return None
    s, t = (w[0] * v[1] - w[1] * v[0]) / area, (w[0] * u[1] - w[1] * u[0]) / area
    return (a[0] + s * u[0], a[1] + s * u[1]) if 0.02 < s < 0.98 and 0.02 < t < 0.98 else None


def split(inner):
    depth = 0
    for i, c in enumerate(inner):
        depth += (c == "(") - (c == ")")
        if c == "," and depth == 0:
            return inner[:i], inner[i + 1:]
    raise ValueError(inner)


def text(name, value):
    if name.startswith(("P", "L")):
        return f"{value:.1f}"
    if name.endswith(".angle"):
        return f"{value:.1f}"
    return f"{value:.4g}"


# Scenes

def exact_centres(mechanism):
    exact = {}
    for target, (kind, what) in mechanism.permanent().items():
        if kind == "pin":
            exact[target] = point(mechanism.points[what])
        else:
            x, y = mechanism.guides[what][3]
            exact[target] = (-y, x, 0.0)
    return exact


def drawable(kind, rng, kinegon, folder):
    """A random mechanism of a kind whose centres a hand draws well, with its form."""
    for _ in range(4000):
        mechanism, wanted = kind(rng)
        mu = rng.choice([1, 2, 0.5]) if mechanism.name in ("four-bar", "slider-crank") else rng.choice([1, 2])
        exact = exact_centres(mechanism)
        everything = list(itertools.combinations(sorted(mechanism.links), 2))
        targets = [t for t in everything if t not in exact] if wanted == "all" else wanted
        follow = follow_of(mechanism)
        try:
            ways = order(mechanism, exact, list(dict.fromkeys(targets + follow)))
            perfect = Sheet(mechanism, mu, ways, random.Random(1), size=0.0)
        except Stuck:
            continue
        near = [place(p) for p in perfect.known.values() if not is_far(p)]
        marked = {(round(x, 6), round(y, 6)) for x, y in near} | {tuple(map(lambda v: round(v, 6), xy)) for xy in perfect.at.values()}
        if any(math.hypot(*xy) > 260 for xy in marked) or any(distance(a, b) < 6 for a, b in itertools.combinations(marked, 2)):
            continue
        (folder / "scene.json").write_text(json.dumps(mechanism.scene(mu, wanted)))
        done = subprocess.run([kinegon, "check", str(folder / "scene.json"), "--template"], capture_output=True, text=True)
        steps = subprocess.run([kinegon, "steps", str(folder / "scene.json")], capture_output=True, text=True)
        if done.returncode != 0 or steps.returncode != 0:
            continue
        _, _, steps = steps.stdout.partition("Instant centres")
        if any(float(angle) < 20 for angle in re.findall(r"angle of crossing ([\d.]+)", steps)):
            continue
        form = json.loads(done.stdout)
        names = list(form["values"])
        try:
            asked = [pair(*("0" if part == "ground" else part for part in name[2:name.index(")")].split(","))) for name in names if name.startswith("P(")]
            ways = order(mechanism, exact, list(dict.fromkeys(asked + targets + follow)))
            perfect = Sheet(mechanism, mu, ways, random.Random(1), size=0.0)
            lengths = [perfect.length(name) for name in names if name.startswith("L(")]
        except (Stuck, KeyError):
            continue
        if any(length < 15 for length in lengths) or not names:
            continue
        marked = re.findall(r"Mark (P_\d\d) on (P_\d\d) (P_\d\d) and (P_\d\d) (P_\d\d)", steps)
        theirs = {frozenset(m[0][2:]): frozenset(frozenset(p[2:]) for p in m[1:]) for m in marked}
        own = {frozenset(t): frozenset(frozenset((i, k)) for i in t for k in over) for t, over in ways}
        return mechanism, mu, ways, form, names, all(theirs.get(t) == through for t, through in own.items())
    raise SystemExit(f"no {kind.__name__} that a hand draws well")


def follow_of(mechanism):
    """Centres by which the velocity of its point is found: of the link that is pinned to the frame, else of the first."""
    holders = [link for link, own in mechanism.links.items() if mechanism.velocity in own and link != "0"]
    pinned = [link for link in holders if any(p in mechanism.links["0"] and p != mechanism.velocity for p in mechanism.links[link])]
    link = (pinned or holders)[0]
    return [t for t in (pair("0", link), pair("1", link)) if t not in mechanism.permanent()]


MISTAKES = ["centre-along-guide", "centre-at-slider", "lines-without-common-link", "ratio-inverted", "sense-by-centre",
            "distance-from-wrong-centre", "not-extended", "velocity-along-ray", "pin-of-three", "lengths-without-scale"]


def run(options):
    rng = random.Random(options.seed)
    survey = Survey(options, MISTAKES, lambda told, mistake: bool(told) and all(t == mistake for t in told))
    for index in range(1, options.scenes + 1):
        kind = KINDS[(index - 1) % len(KINDS)]
        with tempfile.TemporaryDirectory() as work:
            work = Path(work)
            mechanism, mu, ways, form, names, is_same = drawable(kind, rng, options.kinegon, work)
            perfect = Sheet(mechanism, mu, ways, random.Random(1), size=0.0)
            right = [place(p) for p in perfect.known.values() if not is_far(p)]
            planted = {}

            def save(key, sheet, mistake):
                try:
                    form["values"] = sheet.values(names)
                except (Stuck, KeyError, ZeroDivisionError):
                    return
                if mistake is None or sheet.made:
                    form["name"] = key
                    (work / f"{key}.json").write_text(json.dumps(form))
                    planted[key] = mistake

            for number in range(-(-options.honest // options.scenes)):
                try:
                    save(f"honest-{number}", Sheet(mechanism, mu, ways, rng), None)
                except Stuck:
                    pass
            for mistake in survey.wanted:
                for number in range(-(-options.each // options.scenes * 6 // 3)):
                    try:
                        sheet = Sheet(mechanism, mu, ways, rng, mistake, right=right)
                    except (Stuck, StopIteration, ZeroDivisionError):
                        continue
                    if mistake == "lengths-without-scale" and mu == 1:
                        continue
                    save(f"{mistake}-{number}", sheet, mistake)
            for key, mistake in planted.items():
                route = "as in the steps" if is_same else "another route"
                survey.judge(work / "scene.json", work / f"{key}.json", kind.__name__, mistake, route, f"{kind.__name__}-{index}-{key}")
    return survey.report(least=90)


if __name__ == "__main__":
    sys.exit(run(arguments(__doc__)))
