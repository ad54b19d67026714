#!/usr/bin/env python3
"""Velocity and acceleration plans of five mechanisms as a student draws them: with ruler, protractor and pocket calculator.

    python3 hand.py --self-test KINEGON      draws the exercises of KINEGON without any error and compares with their keys

The constructions are those of the textbooks, written out once more: they share nothing with Kinegon but the names in its forms.
A drawing goes wrong in two ways. A `Hand` errs a little in every act: what it draws, lays off, measures, computes. A mistake changes
one named act altogether: `Drawing.act(name, value)` hands the value to the mistake of that name, if there is one (mistakes.py, cases.py).

Units: lengths, velocities and accelerations in the scene's; places in a plan in mm of paper from its pole, as complex numbers, x to the
right and y up; angles in radians, counter-clockwise from x; rates in rad/s and rad/s², counter-clockwise positive.

The acts, with links 1 (crank), 2, 3 …, for a link or a joint in their place:
  scales      "mu_l", "mu_v", "mu_a": units per mm of paper; a wrong size may ask for another scale than the exercise's
  scheme      "scheme crank angle" (degrees), "scheme BC" (a length as it is drawn), "scheme near C" (which of two positions),
              "scheme guide through" (a place of the slider's guide)
  crank       "crank length", "crank omega", "crank alpha" (as they enter the equations), "v_B", "v_B direction", "a_B normal",
              "a_B direction", "a_B tangential"
  rays        "velocity ray 2", "acceleration ray 2" (direction), "velocity ray 2 from" … (where it starts); "guide" and "slot" in place
              of the link for the rays along a guide on the ground and along a slot
  parts       "normal 2", "normal 2 omega", "normal 2 length", "normal 2 direction", "normal 2 from" (where it is laid off from);
              "coriolis", "coriolis omega", "coriolis direction", "guide coriolis"
  images      "image velocity e", "image acceleration e": (image of E less that of one end) : (image of the other end less the same)
  measuring   "measure vplan(b,c)": a segment, in units of velocity or acceleration
  rates       "omega(2)", "alpha(2)", "v_r(3/ground)", "a_r(3/ground)": as gone on with; "omega(2) length", "alpha(2) length"
  the form    "write omega(2)": only what is written
"""
import cmath
import json
import math
import random
import subprocess
import sys
import tempfile
from decimal import Decimal
from pathlib import Path

DEGREE = math.pi / 180
QUARTER = math.pi / 2
# Of a vector that lies less than 6° off the link nobody can say in which sense it turns it.
ACROSS = 0.1


# ---------------------------------------------------------------- geometry

def unit(angle):
    """The vector of length 1 in a direction."""
    return cmath.exp(1j * angle)


def direction(vector):
    """The angle of a vector."""
    return cmath.phase(vector)


def crossing(p, along_p, q, along_q):
    """Where the line through p and the line through q cross, given their directions."""
    u, w = unit(along_p), unit(along_q)
    return p + u * (((q - p).conjugate() * w).imag / (u.conjugate() * w).imag)


def meeting(p, radius_p, q, radius_q, near):
    """Where the circles about p and q meet, of the two places the one nearer to `near`; the nearest they come where they do not meet."""
    distance = abs(q - p)
    along = (distance**2 + radius_p**2 - radius_q**2) / (2 * distance)
    aside = math.sqrt(max(radius_p**2 - along**2, 0))
    u = (q - p) / distance
    return min((p + u * complex(along, aside), p + u * complex(along, -aside)), key=lambda z: abs(z - near))


# ---------------------------------------------------------------- the hand

class Hand:
    """A hand that errs evenly between limits.

    mm, degrees            limits of the error of a place, a length, a direction
    read_mm, read_degrees  what ruler and protractor are read to; 0: no rounding
    slip                   limit of the relative error of a computed number
    digits                 significant digits of computed and written numbers; None: all
    seed                   a string or number; the same one draws the same
    """

    def __init__(self, mm=0.0, degrees=0.0, read_mm=0.0, read_degrees=0.0, slip=0.0, digits=None, seed=0):
        self.mm, self.degrees, self.read_mm, self.read_degrees = mm, degrees, read_mm, read_degrees
        self.slip, self.digits, self.random = slip, digits, random.Random(seed)

    def error(self, limit):
        return self.random.uniform(-limit, limit)

    def drawn(self, angle):
        """The direction of a line that is drawn in a direction."""
        angle += self.error(self.degrees) * DEGREE
        return round(angle / DEGREE / self.read_degrees) * self.read_degrees * DEGREE if self.read_degrees else angle

    def laid_off(self, length):
        """The length of a segment that is laid off, mm."""
        length += self.error(self.mm)
        return round(length / self.read_mm) * self.read_mm if self.read_mm else length

    def placed(self, place):
        """Where a point is marked that lies at a place."""
        return place + complex(self.error(self.mm), self.error(self.mm)) / math.sqrt(2)

    def measured(self, vector):
        """The length that is read off a segment, mm."""
        return max(self.laid_off(abs(vector)), 0.0)

    def computed(self, number):
        """A number from the pocket calculator."""
        return self.rounded(number * (1 + self.error(self.slip)))

    def sense(self, vector, towards):
        """+1 where a vector points along a direction, -1 where it points against it; a guess where it lies across."""
        along = (vector * unit(-towards)).real
        return self.random.choice((1, -1)) if abs(along) < ACROSS * abs(vector) else 1 if along >= 0 else -1

    def rounded(self, number):
        return number if self.digits is None else float(f"{number:.{self.digits}g}")


HANDS = {
    "exact": dict(digits=5),
    "fine": dict(mm=0.2, degrees=0.2, read_mm=0.1, digits=3),
    "pencil": dict(mm=0.25, degrees=0.25, read_mm=0.5, digits=4),
    "ordinary": dict(mm=0.5, degrees=0.5, read_mm=0.5, digits=3),
    "sloppy": dict(mm=1.0, degrees=1.0, read_mm=0.5, digits=3),
}


# ---------------------------------------------------------------- the sheet

class Plan:
    """A velocity or acceleration plan: its name, the head of its segments' names, its pole, its scale (units per mm) and the images in
    it, in mm of paper from the pole. What is at rest has its image in the pole. What the pencil draws (camera.py): rays by where they
    start and their direction, and vectors and sides of similar figures by their ends."""

    def __init__(self, name, head, pole, scale):
        self.name, self.head, self.pole, self.scale, self.images = name, head, pole, scale, {pole: 0j}
        self.rays, self.vectors, self.sides = [], [], []

    def at(self, image):
        return self.images.get(image, 0j)


class Drawing:
    """A sheet with scheme and plans, the rates found from it and the form that is filled in."""

    def __init__(self, scene, hand, mistakes=None):
        self.hand, self.mistakes, self.made = hand, mistakes or {}, set()
        figure, links = scene["figure"], scene["links"]
        self.scales = {mu: self.act(mu, figure[mu]) for mu in ("mu_l", "mu_v", "mu_a")}
        self.velocity = Plan("velocity", "vplan", "p", self.scales["mu_v"])
        self.acceleration = Plan("acceleration", "aplan", "π", self.scales["mu_a"])
        self.plans = (self.velocity, self.acceleration)
        drive = links["1"]["drive"]
        self.crank_angle = drive["angle"]
        self.rates = {"omega(1)": drive["omega"], "alpha(1)": drive.get("alpha", 0)}
        self.lengths, self.measured_lengths = {}, {}
        for link in links.values():
            for name, length in link.get("lengths", {}).items():
                if name != "note":
                    self.lengths[name] = self.lengths[name[::-1]] = length
        self.points = {name: complex(*at) for name, at in scene["ground"].items() if name != "note"}
        self.near = {name: complex(*at) for name, at in scene.get("near", {}).items() if name != "note"}
        self.guide = next((s for s in scene.get("sliders", []) if s["on"] == "ground"), None)
        self.values = {}

    def act(self, name, value):
        """What comes of an act: the value, or what a mistake makes of it."""
        if name not in self.mistakes:
            return value
        self.made.add(name)
        return self.mistakes[name](value, self)

    def find(self, name, value):
        """Finds a rate and goes on with it."""
        self.rates[name] = self.act(name, self.hand.computed(value))

    def write(self, quantity, value):
        """Fills in a line of the form."""
        self.values[quantity] = self.act(f"write {quantity}", value)

    def measure(self, plan, start, end):
        """Measures a segment of a plan and writes it down; its size in units."""
        quantity = f"{plan.head}({start},{end})"
        if start == plan.pole:
            plan.vectors.append((0j, plan.at(end)))
        size = self.act(f"measure {quantity}", self.hand.measured(plan.at(end) - plan.at(start)) * plan.scale)
        self.write(quantity, self.hand.computed(size))
        return size

    def distance(self, p, q):
        """The distance of two points, as it is given."""
        return abs(self.points[q] - self.points[p])

    def scheme_distance(self, p, q):
        """The distance of two points, measured on the scheme once and then used wherever it is needed."""
        if p + q not in self.measured_lengths:
            on_paper = self.hand.measured((self.points[q] - self.points[p]) / self.scales["mu_l"])
            self.measured_lengths[p + q] = on_paper * self.scales["mu_l"]
        return self.measured_lengths[p + q]

    def along(self, p, q):
        """The direction from a point to another."""
        return direction(self.points[q] - self.points[p])

    def across(self, p, q):
        """The direction in which a counter-clockwise turn about p moves q."""
        return self.along(p, q) + QUARTER


# ---------------------------------------------------------------- the scheme

def place_crank(d):
    angle = d.act("scheme crank angle", d.crank_angle) * DEGREE
    d.points["B"] = d.points["A"] + d.act("scheme AB", d.lengths["AB"]) * unit(angle)


def place_pin(d, p, q, c):
    """Places the joint c by its distances from p and q."""
    radius_p, radius_q = (d.act(f"scheme {end}{c}", d.lengths[end + c]) for end in (p, q))
    d.points[c] = meeting(d.points[p], radius_p, d.points[q], radius_q, d.act(f"scheme near {c}", d.near[c]))


def place_on_guide(d, p, c):
    """Places the joint c on the guide on the ground, by its distance from p."""
    through = d.guide["through"]
    through = d.points[through] if isinstance(through, str) else complex(*through)
    through = d.act("scheme guide through", through)
    u = unit(guide_direction(d))
    foot = (d.points[p] - through) / u
    reach = math.sqrt(max(d.act(f"scheme {p}{c}", d.lengths[p + c])**2 - foot.imag**2, 0))
    places = [through + u * (foot.real + side * reach) for side in (1, -1)]
    d.points[c] = min(places, key=lambda z: abs(z - d.near[c]))


def guide_direction(d):
    return d.guide["along"] * DEGREE


# ---------------------------------------------------------------- the plans

def crank(d):
    """Lays off velocity and acceleration of the crank's pin B from the poles."""
    length, omega = d.act("crank length", d.distance("A", "B")), d.act("crank omega", d.rates["omega(1)"])
    speed = d.act("v_B", d.hand.computed(omega * length))
    laid = d.hand.laid_off(abs(speed) / d.velocity.scale)
    towards = d.hand.drawn(d.act("v_B direction", d.across("A", "B")))
    d.velocity.images["b"] = laid * math.copysign(1, speed) * unit(towards)
    d.velocity.vectors.append((0j, d.velocity.at("b")))
    d.write("vplan(p,b)", d.hand.computed(d.act("measure vplan(p,b)", laid * d.velocity.scale)))

    normal = d.hand.computed(d.act("a_B normal", omega**2 * length))
    laid = d.hand.laid_off(normal / d.acceleration.scale)
    end = laid * unit(d.hand.drawn(d.act("a_B direction", d.along("B", "A"))))
    d.acceleration.vectors.append((0j, end))
    alpha = d.act("crank alpha", d.rates["alpha(1)"])
    tangential = d.act("a_B tangential", d.hand.computed(alpha * length))
    if tangential:
        aside = d.hand.laid_off(abs(tangential) / d.acceleration.scale) * math.copysign(1, tangential)
        end += aside * unit(d.hand.drawn(d.across("A", "B")))
        d.acceleration.vectors += [(d.acceleration.vectors[-1][1], end), (0j, end)]
        laid = d.hand.measured(end)
    d.acceleration.images["b"] = end
    d.write("aplan(π,b)", d.hand.computed(d.act("measure aplan(π,b)", laid * d.acceleration.scale)))


def normal_part(d, p, c, link, length):
    """Lays off ω² L of a link from the image of p, in the direction from c to p; the name of its end. `c` may be a point B_3 of the
    slotted lever under B."""
    plan, start, end = d.acceleration, p.lower(), f"n_{p.lower()}{c}"
    omega = d.act(f"normal {link} omega", d.rates[f"omega({link})"])
    length = d.act(f"normal {link} length", length)
    size = d.hand.computed(d.act(f"normal {link}", omega**2 * length))
    laid = d.hand.laid_off(size / plan.scale)
    towards = d.hand.drawn(d.act(f"normal {link} direction", d.along(c[0], p)))
    start_at = d.act(f"normal {link} from", plan.at(start))
    plan.images[end] = start_at + laid * unit(towards)
    plan.vectors.append((start_at, plan.at(end)))
    d.write(f"aplan({start},{end})", d.hand.computed(d.act(f"measure aplan({start},{end})", laid * plan.scale)))
    return end


def ray(d, plan, name, start, towards):
    """A ray: the place that it is drawn from, and its direction."""
    start = d.act(f"{plan.name} ray {name} from", plan.at(start))
    plan.rays.append((start, d.hand.drawn(d.act(f"{plan.name} ray {name}", towards))))
    return plan.rays[-1]


def turning(d, plan, link, size, vector, across, length):
    """Finds ω or α of a link from the size of a segment, the segment as a vector for its sense, and the length of the link; its name."""
    name = f"{'omega' if plan is d.velocity else 'alpha'}({link})"
    d.find(name, d.hand.sense(vector, across) * size / d.act(f"{name} length", length))
    return name


def pins(d, plan, p, q, c, link_p, link_q):
    """The joint c of two links that are pinned at p and q (RRR)."""
    image, ends = c.lower(), []
    for joint, link in ((p, link_p), (q, link_q)):
        start = joint.lower() if plan is d.velocity else normal_part(d, joint, c, link, d.distance(joint, c))
        ends.append((joint, link, start, ray(d, plan, link, start, d.across(joint, c))))
    plan.images[image] = d.hand.placed(crossing(*ends[0][3], *ends[1][3]))
    d.measure(plan, plan.pole, image)
    sizes = [d.measure(plan, start, image) for _, _, start, _ in ends]
    rates = [turning(d, plan, link, size, plan.at(image) - plan.at(start), d.across(joint, c), d.distance(joint, c))
             for (joint, link, start, _), size in zip(ends, sizes)]
    for name in rates:
        d.write(name, d.rates[name])


def guided(d, plan, p, c, link, slider):
    """The joint c of a link pinned at p and a slider on the ground (RRP)."""
    image, ground, along = c.lower(), f"{c.lower()}_ground", guide_direction(d)
    start, rest, slide = p.lower(), ground, "v_r"
    if plan is d.acceleration:
        start = normal_part(d, p, c, link, d.distance(p, c))
        rest, slide = f"n_{ground}{c}", "a_r"
        # The guide is at rest, so there is no Coriolis part; a mistake may add one.
        coriolis = d.act("guide coriolis", 0.0)
        if coriolis:
            plan.images[rest] = coriolis / plan.scale * unit(along + QUARTER)
            plan.vectors.append((0j, plan.at(rest)))
            d.write(f"aplan({ground},{rest})", d.hand.computed(abs(coriolis)))
        else:
            rest = ground
    first = ray(d, plan, link, start, d.across(p, c))
    plan.images[image] = d.hand.placed(crossing(*first, *ray(d, plan, "guide", rest, along)))
    along_guide = d.measure(plan, plan.pole, image)
    about_p = d.measure(plan, start, image)
    if plan.at(rest):
        along_guide = d.measure(plan, rest, image)
    else:
        d.write(f"{plan.head}({rest},{image})", d.hand.computed(along_guide))
    name = turning(d, plan, link, about_p, plan.at(image) - plan.at(start), d.across(p, c), d.distance(p, c))
    d.write(name, d.rates[name])
    slide = f"{slide}({slider}/ground)"
    d.find(slide, d.hand.sense(plan.at(image), along) * along_guide)
    d.write(slide, d.rates[slide])


def slot(d, plan, pivot, pin, block, lever):
    """The point of a slotted lever under the pin b that slides in it; the pin's image is there already (RPR)."""
    b, q, under = pin.lower(), pivot.lower(), f"{pin}_{lever}"
    image, along, across = f"{b}_{lever}", d.along(pivot, pin), d.across(pivot, pin)
    turn_start, slide_start, slide = q, b, "v_r"
    if plan is d.acceleration:
        turn_start = normal_part(d, pivot, under, lever, d.scheme_distance(pivot, pin))
        slide_start, slide = coriolis_part(d, pin, under, block, lever, across), "a_r"
    first = ray(d, plan, lever, turn_start, across)
    plan.images[image] = d.hand.placed(crossing(*first, *ray(d, plan, "slot", slide_start, along)))
    turns = d.measure(plan, plan.pole, image)
    if plan is d.velocity:
        d.write(f"vplan({q},{image})", d.values[f"vplan(p,{image})"])
    else:
        turns = d.measure(plan, turn_start, image)
    slides = d.measure(plan, slide_start, image)
    name = turning(d, plan, lever, turns, plan.at(image) - plan.at(turn_start), across, d.scheme_distance(pivot, pin))
    own = name.replace(f"({lever})", f"({block})")
    d.rates[own] = d.rates[name]
    d.write(own, d.rates[own])
    d.write(name, d.rates[name])
    slide = f"{slide}({block}/{lever})"
    d.find(slide, d.hand.sense(plan.at(slide_start) - plan.at(image), along) * slides)
    d.write(slide, d.rates[slide])
    if plan is d.velocity:
        d.write(f"vplan({image},{b})", d.values[f"vplan({b},{image})"])


def coriolis_part(d, pin, under, block, lever, across):
    """Lays off 2 ω v_r of a pin in a slot, from the pin's image back to the lever's point under it; the name of its end."""
    plan, b = d.acceleration, pin.lower()
    end = f"k_{b}{lever}"
    omega = d.act("coriolis omega", d.rates[f"omega({lever})"])
    part = d.hand.computed(d.act("coriolis", 2 * omega * d.rates[f"v_r({block}/{lever})"]))
    laid = d.hand.laid_off(abs(part) / plan.scale)
    towards = d.hand.drawn(d.act("coriolis direction", across))
    plan.images[end] = plan.at(b) - math.copysign(laid, part) * unit(towards)
    plan.vectors.append((plan.at(b), plan.at(end)))
    d.write(f"aplan({b},{end})", d.hand.computed(laid * plan.scale))
    return end


def image(d, plan, p, c, e, image_c=None):
    """The image of a point e of the link through p and c, by similarity: turned with the link and true to its shape."""
    own, start = e.lower(), plan.at(p.lower())
    ratio = (d.points[e] - d.points[p]) / (d.points[c] - d.points[p])
    ratio = d.act(f"image {plan.name} {own}", ratio)
    ratio = abs(ratio) * (1 + d.hand.error(d.hand.mm) / 100) * unit(d.hand.drawn(direction(ratio)))
    plan.images[own] = d.hand.placed(start + (plan.at(image_c or c.lower()) - start) * ratio)
    # In line with the others it is marked on their line, else a triangle is drawn.
    plan.sides += [(end, plan.at(own)) for end in (start, plan.at(image_c or c.lower())) if abs(ratio.imag) > 0.01 * abs(ratio)]
    d.measure(plan, plan.pole, own)


# ---------------------------------------------------------------- the mechanisms

def four_bar(d):
    place_crank(d)
    place_pin(d, "B", "D", "C")
    crank(d)
    for plan in d.plans:
        pins(d, plan, "B", "D", "C", "2", "3")


def slider_crank(d):
    place_crank(d)
    place_on_guide(d, "B", "C")
    crank(d)
    for plan in d.plans:
        guided(d, plan, "B", "C", "2", "3")


def slotted_lever(d):
    place_crank(d)
    d.points["C"] = d.points["D"] + d.act("scheme CD", d.lengths["CD"]) * unit(d.along("D", "B"))
    crank(d)
    for plan in d.plans:
        slot(d, plan, "D", "B", "2", "3")
        image(d, plan, "D", "B", "C", "b_3")


def watt_1(d):
    place_crank(d)
    for p, q, c in ("BDC", "BCE", "DCF", "EFG"):
        place_pin(d, p, q, c)
    crank(d)
    for plan in d.plans:
        pins(d, plan, "B", "D", "C", "2", "3")
        image(d, plan, "B", "C", "E")
        image(d, plan, "D", "C", "F")
        pins(d, plan, "E", "F", "G", "4", "5")


def whitworth(d):
    place_crank(d)
    d.points["E"] = d.points["D"] - d.act("scheme DE", d.lengths["DE"]) * unit(d.along("D", "B"))
    place_on_guide(d, "E", "F")
    crank(d)
    for plan in d.plans:
        slot(d, plan, "D", "B", "2", "3")
        image(d, plan, "D", "B", "E", "b_3")
        guided(d, plan, "E", "F", "4", "5")


MECHANISMS = {"four-bar": four_bar, "slider-crank": slider_crank, "slotted-lever": slotted_lever, "watt-1": watt_1,
              "whitworth": whitworth}


def draw(mechanism, scene, hand, mistakes=None):
    """A sheet of a mechanism, drawn by a hand with mistakes: {act: what it makes of the value}."""
    d = Drawing(scene, hand, mistakes)
    MECHANISMS[mechanism](d)
    never = set(d.mistakes) - d.made
    if never:
        raise ValueError(f"{mechanism} has no act named {', '.join(sorted(never))}")
    return d


def form(drawing, name=""):
    """The form for `kinegon check`, numbers as the hand writes them, slides with their sign."""
    def text(quantity, value):
        number = f"{Decimal(repr(drawing.hand.rounded(value))).normalize():f}" if value else "0"
        return "+" + number if "_r(" in quantity and value > 0 else number

    values = {quantity: text(quantity, value) for quantity, value in drawing.values.items()}
    return dict(kinegon_measured=1, name=name, **drawing.scales, positive="counter-clockwise", values=values)


# ---------------------------------------------------------------- self-test

def self_test(kinegon):
    """Whether exact drawings agree with the keys of exercises to 1e-6 of each value."""
    agree = True
    for mechanism in MECHANISMS:
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([kinegon, "exercise", mechanism, "--seed", "7", "--count", "2", "-o", folder], check=True,
                           stdout=subprocess.DEVNULL)
            for exercise in sorted(Path(folder).glob(f"{mechanism}-*")):
                scene, key = (json.loads((exercise / f"{n}.json").read_text("utf-8")) for n in ("scene", "key"))
                mine = draw(mechanism, scene, Hand()).values
                right = {quantity: entry["value"] for quantity, entry in key["values"].items()}
                largest = max(map(abs, right.values()))
                # What is nothing on the key may be a rounding error of the largest.
                errors = [abs(mine[q] - v) / (abs(v) if abs(v) > 1e-9 * largest else largest) for q, v in right.items() if q in mine]
                fine = set(mine) >= set(right) and max(errors) <= 1e-6
                agree = agree and fine
                if set(right) - set(mine):
                    print("not drawn:", *sorted(set(right) - set(mine)))
                print(f"{exercise.name}: {len(errors)} of {len(right)} values, largest difference {max(errors):.0e}"
                      f"{'' if fine else '  DISAGREES'}")
    return agree


if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] != "--self-test":
        sys.exit(__doc__)
    sys.exit(0 if self_test(sys.argv[2]) else 1)
