"""Mistakes that students make, each a change of one operation. A kind is a function over a `Place`; it gives the operations that
stand in place of the right one, the wrong one last, or None where it cannot be made there. `names` are the ids of docs/mistakes.md that
name it rightly; kinds without names are of no catalogue, so that the judge may name none."""

import json
import math
import re

import paper
from paper import Refused
from plans import ACCELERATION, POLE, SEGMENT, VELOCITY, Op, equation

KINDS = {}
AMOUNTS = {"crank-velocity", "crank-normal", "crank-tangential", "normal", "relative", "tangential", "coriolis", "drive", "part"}


class Kind:
    def __init__(self, name, names, roles, change):
        self.name, self.names, self.roles, self.change = name, set(names), set(roles), change


def kind(name, names, *roles):
    def register(change):
        KINDS[name] = Kind(name, names.split(), roles, change)
        return change
    return register


class Place:
    """An operation in an order, with what stands on the sheets before it."""

    def __init__(self, ops, i, sheets, own, rng, snap):
        self.ops, self.i, self.op, self.sheets, self.own, self.rng, self.snap = ops, i, ops[i], sheets, own, rng, snap

    @property
    def entry(self):
        return self.op.entry

    @property
    def sheet(self):
        return self.entry["on"]

    @property
    def amount(self):
        return self.op.info.get("amount")

    def but(self, **changes):
        return [self.op.but({**self.entry, **changes})]

    def sized(self, text):
        return self.but(**{"size" if "size" in self.entry else "as": text})

    def amounts(self, **changes):
        return self.sized(self.amount.but(**changes).text())

    def points(self, sheet, *but):
        """Points that are on a sheet, elsewhere than those that are not wanted."""
        places = self.sheets.points[sheet]
        apart = 1e-3 * max((abs(z) for z in places.values()), default=1)
        return sorted(n for n, z in places.items() if n != "pi" and all(abs(z - places[b]) > apart for b in but))

    def axes(self):
        """References for the directions of links."""
        return [name if len(points) == 2 else ",".join(points[:2])
                for name, points in self.sheets.mechanism.links.items() if len(points) > 1]

    def pick(self, options):
        options = list(options)
        return self.rng.choice(options) if options else None

    def rates(self, head, *but):
        """Rates of other links that are known already, with another size."""
        known = {**self.sheets.given, **self.sheets.numbers}
        sizes = [abs(known[b]) for b in but if b in known]
        return sorted(n for n, x in known.items() if n.startswith(f"{head}(") and all(abs(abs(x) - s) > 1e-3 * s for s in sizes) and x)

    def lengths(self, but):
        """Other lengths: given ones, and those of other pairs of joints."""
        size = self.sheets.value(but)
        return sorted(n for n, x in self.sheets.given.items() if n.startswith("L(") and abs(x - size) > 1e-2 * size)


# ---------------------------------------------------------------- rays

@kind("turned-ray", "turned-ray", "ray", "guide-ray", "image-ray")
def turned_ray(p):
    (key, ref), = p.entry["along"].items()
    return p.but(along={"parallel" if key == "normal" else "normal": ref})


@kind("ray-from-wrong-point", "ray-from-wrong-point", "ray", "guide-ray", "image-ray")
def ray_from_wrong_point(p):
    other = p.pick(n for n in p.points(p.sheet, p.entry["through"]) if n not in p.own and n != p.op.info.get("plain"))
    return other and p.but(through=other)


@kind("ray-before-the-normal-part", "ray-from-wrong-point normal-forgotten coriolis-forgotten", "ray", "guide-ray")
def ray_before_normal(p):
    """The normal or Coriolis part is laid off, but the ray drawn through the point before it."""
    plain = p.op.info.get("plain")
    return p.but(through=plain) if plain else None


@kind("ray-of-another-link", "", "ray", "image-ray")
def ray_of_another_link(p):
    way = p.sheets.along(p.sheet, p.entry["along"])
    def apart(ref):
        other = p.sheets.way("scheme", ref)
        return abs((way.conjugate() * other * 1j).imag) > 0.05 * abs(other)

    other = p.pick(n for n in p.axes() if apart(n))
    return other and p.but(along={"normal": other})


@kind("ray-askew", "", "ray", "guide-ray", "image-ray", "turned-image-ray")
def ray_askew(p):
    """The set square has slipped by some degrees."""
    return [p.op.but(dict(p.entry), askew=p.rng.choice((1, -1)) * p.rng.uniform(5, 25))]


@kind("image-turned-wrong-way", "mirrored-image turned-ray", "turned-image-ray")
def image_turned_wrong_way(p):
    along = p.entry["along"]
    return p.but(along={**along, "turned": along["turned"][::-1]})


@kind("normal-forgotten", "normal-forgotten ray-from-wrong-point vector-from-wrong-point", "normal", "normal-laid")
def normal_forgotten(p):
    return "forgotten"


@kind("coriolis-forgotten", "coriolis-forgotten ray-from-wrong-point vector-from-wrong-point", "coriolis",
      "coriolis-laid")
def coriolis_forgotten(p):
    return "forgotten"


# ---------------------------------------------------------------- the scheme, crossings

@kind("wrong-cut-line", "wrong-lines", "cut")
def wrong_cut_line(p):
    side = p.op.info["side"]
    others = [n for n in p.points("scheme") if n not in (side.a, side.c) and not re.match(r"S\d", n)]
    other = p.pick(others)
    if not other:
        return None
    keep = p.rng.choice([side.a, side.c])
    return [p.op.but({"join": p.entry.get("join") or p.entry["line"], "on": "scheme", "points": [keep, other]})]


@kind("turned-cut-line", "turned-cut-line", "cut-guide")
def turned_cut_line(p):
    return p.but(along={"parallel": p.entry["along"]["normal"]})


@kind("wrong-lines", "wrong-lines", "cross-special")
def wrong_lines(p):
    return other_lines(p)


@kind("wrong-rays-crossed", "", "cross")
def wrong_rays(p):
    return other_lines(p)


def other_lines(p):
    keep = p.rng.choice(p.entry["of"])
    way = p.sheets.lines[keep][2]
    others = [n for n, (sheet, _, w) in p.sheets.lines.items()
              if sheet == p.sheet and n not in p.entry["of"] and abs((w.conjugate() * way).imag) > 0.1]
    other = p.pick(others)
    return other and p.but(of=[keep, other])


@kind("crossing-marked-beside", "", "cross", "cross-special")
def marked_beside(p):
    if p.snap != "none":
        return None
    return [p.op.but(dict(p.entry), off_mm=p.rng.uniform(5, 20), off_way=p.rng.uniform(0, 2 * math.pi))]


# ---------------------------------------------------------------- vectors

def reversed_along(p):
    (key, ref), = p.entry["along"].items()
    if isinstance(ref, str) and "," in ref:
        return p.but(along={key: ",".join(ref.split(",")[::-1])})
    return p.but(size=f"-({p.entry['size']})")


@kind("reversed-vector", "reversed-vector", "crank-velocity", "crank-velocity-laid", "crank-tangential", "relative", "relative-laid",
      "tangential", "tangential-laid", "drive", "known")
def reversed_vector(p):
    return reversed_along(p) if "lay_off" in p.entry else None


@kind("normal-outward", "normal-outward reversed-vector", "normal", "crank-normal", "normal-laid", "crank-normal-laid")
def normal_outward(p):
    return reversed_along(p) if "lay_off" in p.entry else None


@kind("turned-vector", "turned-vector", "crank-velocity", "crank-normal", "relative", "tangential", "normal", "crank-velocity-laid",
      "normal-laid", "drive")
def turned_vector(p):
    if "lay_off" not in p.entry:
        return None
    (key, ref), = p.entry["along"].items()
    return p.but(along={"parallel" if key == "normal" else "normal": ref})


@kind("vector-from-wrong-point", "vector-from-wrong-point", "normal", "coriolis", "tangential", "relative", "normal-laid",
      "coriolis-laid", "tangential-laid")
def vector_from_wrong_point(p):
    if "lay_off" not in p.entry:
        return None
    other = p.pick(n for n in p.points(p.sheet, p.entry["from"]) if n not in p.own)
    return other and p.but(**{"from": other})


@kind("vector-along-another-link", "", "normal", "tangential", "relative", "crank-velocity")
def vector_of_another_link(p):
    if "lay_off" not in p.entry:
        return None
    (key, ref), = p.entry["along"].items()
    other = p.pick(n for n in p.axes() if abs((p.sheets.way("scheme", n).conjugate() * p.sheets.way(p.sheet, ref)).imag)
                   > 0.05 * abs(p.sheets.way("scheme", n) * p.sheets.way(p.sheet, ref)))
    return other and p.but(along={key: other})


@kind("coriolis-turned", "coriolis-turned", "coriolis")
def coriolis_turned(p):
    return p.amounts(sign=-p.amount.sign)


@kind("coriolis-along-guide", "coriolis-along-guide", "coriolis", "coriolis-laid")
def coriolis_along_guide(p):
    return p.but(along={"parallel": p.entry["along"]["normal"]}) if "lay_off" in p.entry else None


@kind("angle-of-a-given-vector", "", "known")
def given_angle(p):
    angle = p.entry["along"]["angle"]
    return p.but(along={"angle": p.rng.choice([-angle, 90 - angle])}) if angle else None


@kind("given-parts-swapped", "swapped", "known")
def parts_swapped(p):
    angle = p.entry["along"]["angle"]
    return p.but(along={"angle": 90 - angle}) if angle in (0, 90) else None


# ---------------------------------------------------------------- amounts

@kind("omega-not-squared", "omega-not-squared", "normal", "crank-normal")
def not_squared(p):
    if p.amount.segment:
        return None
    if p.amount.more and p.rng.random() < 0.5:
        return p.amounts(more=(p.amount.more[0].but(power=1),))
    return p.amounts(power=1)


@kind("velocity-not-squared", "", "normal", "crank-normal")
def velocity_not_squared(p):
    return p.sized(f"{p.amount.segment}/{p.amount.length}") if p.amount.segment else None


@kind("omega-of-another-link", "omega-of-another-link", "normal", "coriolis")
def another_omega(p):
    other = p.pick(p.rates("omega", p.amount.rate))
    return other and not p.amount.segment and p.amounts(rate=other) or None


@kind("alpha-of-another-link", "", "tangential")
def another_alpha(p):
    other = p.pick(p.rates("alpha", p.amount.rate))
    return other and p.amounts(rate=other)


@kind("rate-of-another-link", "", "relative")
def another_rate(p):
    other = p.pick(p.rates("omega", p.amount.rate))
    return other and p.amounts(rate=other)


@kind("diameter", "diameter", "normal", "crank-normal", "crank-velocity")
def diameter(p):
    return None if p.amount.more else p.amounts(factor="2")


@kind("half-the-radius", "half-the-radius", "crank-velocity", "crank-normal")
def half(p):
    return p.amounts(factor="0.5")


@kind("wrong-length", "wrong-length", "normal", "crank-velocity", "crank-normal", "relative", "tangential", "crank-tangential")
def wrong_length(p):
    other = p.pick(p.lengths(p.amount.length))
    return other and p.amounts(length=other)


@kind("length-forgotten", "", "normal", "relative", "tangential")
def length_forgotten(p):
    return None if p.amount.segment else p.amounts(length=None)


@kind("normal-from-absolute", "normal-from-absolute", "normal")
def from_absolute(p):
    at = p.op.info.get("at")
    return p.amounts(segment=f"vplan({POLE[VELOCITY]},{at})") if at and at in p.sheets.points[VELOCITY] and not p.amount.more else None


@kind("coriolis-without-2", "coriolis-without-2", "coriolis")
def without_2(p):
    return p.amounts(factor="")


@kind("coriolis-wrong-velocity", "coriolis-wrong-velocity", "coriolis")
def wrong_velocity(p):
    pin = p.op.info["pin"].lower()
    return p.amounts(length=f"vplan({POLE[VELOCITY]},{pin})") if pin in p.sheets.points[VELOCITY] and p.sheets.points[VELOCITY][pin] else None


@kind("revolutions-for-radians", "revolutions-for-radians", "crank-velocity")
def revolutions(p):
    return p.amounts(factor="9.549297" if p.rng.random() < 0.5 else "0.1047198")


@kind("scale-forgotten", "wrong-scale decimal-slipped", "crank-velocity", "crank-normal", "normal", "coriolis", "drive")
def scale_forgotten(p):
    """A tenth or ten times as long as the scale makes it."""
    return p.sized(f"{p.rng.choice(['10', '0.1'])}*({p.entry.get('size') or p.entry['as']})") if "size" in p.entry else None


@kind("tangential-where-none", "tangential-where-none", "crank-normal")
def tangential_where_none(p):
    link = p.op.info["link"]
    if p.sheets.given.get(f"alpha({link})") or "lay_off" not in p.entry:
        return None
    half = f"tn{len(p.ops)}"
    a, b = p.sheets.mechanism.links[link][:2]
    first = Op({**p.entry, "lay_off": half}, "auxiliary")
    return [first, Op({**p.entry, "from": half, "size": f"omega({link})*L({a},{b})", "along": {"normal": f"{a},{b}"}}, p.op.role)]


# ---------------------------------------------------------------- images

@kind("mirrored-image", "mirrored-image", "like")
def mirrored(p):
    return None if p.op.info["flat"] else p.but(mirrored=True)


@kind("wrong-ratio", "wrong-ratio", "like", "part")
def wrong_ratio(p):
    if p.op.role == "part":
        if "as" in p.entry:
            return None
        one, two = p.amount.length.split("/")
        return p.amounts(length=f"{two}/{one}")
    return p.but(ends=p.entry["ends"][::-1])


@kind("image-on-wrong-side", "mirrored-image reversed-vector", "part")
def wrong_side(p):
    return p.amounts(sign=-p.amount.sign)


@kind("image-of-another-triangle", "", "like")
def another_triangle(p):
    a, b, c = p.entry["points"]
    other = p.pick(n for n in p.points("scheme", a, b, c))
    return other and p.but(points=[a, b, other])


# ---------------------------------------------------------------- lengths, rates

def other_segment(p, sheet, start, end):
    size = abs(p.sheets.point(sheet, start) - p.sheets.point(sheet, end))
    pairs = [(keep, n) for keep in (start, end) for n in p.points(sheet, keep) if n not in p.own
             and abs(abs(p.sheets.point(sheet, keep) - p.sheets.point(sheet, n)) - size) > 0.02 * size]
    return p.pick(pairs)


@kind("wrong-segment", "wrong-segment", "measure")
def wrong_segment(p):
    pair = other_segment(p, p.sheet, p.entry["from"], p.entry["to"])
    return pair and p.but(**{"from": pair[0], "to": pair[1]})


@kind("wrong-segment-in-formula", "wrong-segment", "rate", "slide")
def wrong_segment_in_formula(p):
    if not (found := paper.ends(p.op.info["segment"])) or p.op.typed:
        return None
    pair = other_segment(p, *found)
    return pair and p.but(**{"as": p.entry["as"].replace(p.op.info["segment"], f"{SEGMENT[found[0]]}({pair[0]},{pair[1]})")})


@kind("component", "component", "measure")
def component(p):
    part = p.rng.choice([lambda z: z.real, lambda z: z.imag])
    return [p.op.but(dict(p.entry), reading=part)]


@kind("decimal-slipped", "decimal-slipped", "rate", "slide", "measure", "crank-velocity", "normal", "coriolis")
def decimal_slipped(p):
    factor = p.rng.choice((10.0, 0.1))
    return slipped(p, lambda x: x * factor)


@kind("digits-transposed", "digits-transposed", "rate", "slide", "measure", "crank-velocity", "normal", "coriolis")
def transposed(p):
    return slipped(p, transpose)


def slipped(p, slip):
    """A number that is typed wrongly. What is worked out on the strip cannot be."""
    if p.op.kind == "measure":
        return [p.op.but(dict(p.entry), slip=slip, reading=lambda z: z)]
    return [p.op.but(dict(p.entry), slip=slip)] if p.op.typed else None


def transpose(x):
    digits = f"{abs(x):.3g}"
    if "e" in digits:
        return x
    figures = [i for i, c in enumerate(digits) if c.isdigit()]
    for i, k in zip(figures, figures[1:]):
        if digits[i] != digits[k] and float(digits.replace(".", "")) and digits.lstrip("0.") and (digits[i] != "0" or i):
            swapped = list(digits)
            swapped[i], swapped[k] = swapped[k], swapped[i]
            if abs(float("".join(swapped)) - abs(x)) > 0.02 * abs(x):
                return math.copysign(float("".join(swapped)), x)
    return x


@kind("not-divided-by-length", "not-divided-by-length", "rate")
def not_divided(p):
    return p.but(**{"as": p.entry["as"].replace(f"/{p.op.info['length']}", "")})


@kind("rate-from-wrong-length", "omega-from-wrong-length alpha-from-wrong-length wrong-length", "rate")
def rate_from_wrong_length(p):
    other = p.pick(p.lengths(p.op.info["length"]))
    return other and p.but(**{"as": p.entry["as"].replace(p.op.info["length"], other)})


@kind("wrong-sense", "wrong-sense", "rate", "slide")
def wrong_sense(p):
    if "sense" in p.entry:
        return p.but(sense="cw" if p.entry["sense"] == "ccw" else "ccw")
    text = p.entry["as"]
    return p.but(**{"as": text[1:] if text.startswith("-") else f"-{text}"})


@kind("degrees-for-radians", "degrees-for-radians", "rate")
def degrees(p):
    return p.but(**{"as": f"{p.entry['as']}*57.29578"})


@kind("turns-per-minute", "revolutions-for-radians", "rate")
def turns_per_minute(p):
    return p.but(**{"as": f"{p.entry['as']}*9.549297"}) if p.op.info["sheet"] == VELOCITY else None


@kind("divided-twice", "", "rate")
def divided_twice(p):
    return p.but(**{"as": f"{p.entry['as']}/{p.op.info['length']}"})


@kind("block-turns-otherwise", "omega-of-another-link", "same")
def block_otherwise(p):
    head = p.entry["as"].split("(")[0]
    other = p.pick(p.rates(head, p.entry["as"]))
    return other and p.but(**{"as": other})


# ---------------------------------------------------------------- equations

def changed_row(p, change):
    if p.op.typed:
        return None
    rows = [([*terms], sign, segment) for terms, sign, segment in p.op.info["rows"]]
    i = p.rng.randrange(len(rows))
    new = change(rows[i])
    if new is None:
        return None
    rows[i] = new
    return p.but(equations=[equation(row) for row in rows])


@kind("wrong-sign-in-equation", "", "equations")
def wrong_sign(p):
    def change(row):
        terms, sign, segment = row
        k = p.rng.randrange(len(terms) + 1)
        if k == len(terms):
            return terms, -sign, segment
        return [(-s if i == k else s, n, ll) for i, (s, n, ll) in enumerate(terms)], sign, segment
    return changed_row(p, change)


@kind("wrong-length-in-equation", "wrong-length omega-from-wrong-length alpha-from-wrong-length", "equations")
def length_in_equation(p):
    def change(row):
        terms, sign, segment = row
        k = p.rng.randrange(len(terms))
        s, n, length = terms[k]
        other = length and p.pick(p.lengths(length))
        return ([*terms[:k], (s, n, other), *terms[k + 1:]], sign, segment) if other else None
    return changed_row(p, change)


@kind("wrong-segment-in-equation", "wrong-segment", "equations")
def segment_in_equation(p):
    def change(row):
        terms, sign, segment = row
        found = paper.ends(segment)
        pair = found and other_segment(p, *found)
        return (terms, sign, f"{SEGMENT[found[0]]}({pair[0]},{pair[1]})") if pair else None
    return changed_row(p, change)


# ---------------------------------------------------------------- putting them in

def leave_out(ops, i):
    """The operations without one vector; what rested on its end rests on its beginning. The first that does is the wrong one."""
    gone = ops[i].entry
    name, start, sheet = gone["lay_off"], gone["from"], gone["on"]
    word = re.compile(rf'(?<![\w]){re.escape(name)}(?![\w])')
    out, wrong = [], None
    for k, op in enumerate(ops):
        if k == i:
            continue
        named = [op.entry.get("from"), op.entry.get("through")]
        if k > i and op.entry.get("on") == sheet and name in named and op.kind in ("line", "lay_off"):
            wrong = len(out) if wrong is None else wrong
        if k > i:
            op = Op(json.loads(word.sub(start, json.dumps(op.entry, ensure_ascii=False))), op.role, op.info, op.typed)
            if "measure" in op.entry and "(" in op.entry["measure"] and op.entry["from"] == op.entry["to"]:
                return None
        out.append(op)
    return (out, wrong) if wrong is not None else None


def plant(ops, i, chosen, sheets, own, rng, snap):
    """Puts a mistake of a kind in at an operation: the new operations and which of them is wrong; None where it cannot be."""
    if ops[i].role not in chosen.roles:
        return None
    place = Place(ops, i, sheets, own, rng, snap)
    if not place.amount and chosen.change in NEED_AMOUNT:
        return None
    try:
        new = chosen.change(place)
    except (KeyError, Refused, ZeroDivisionError):
        return None
    if new == "forgotten":
        return leave_out(ops, i) if ops[i].kind == "lay_off" else None
    return (ops[:i] + new + ops[i + 1:], i + len(new) - 1) if new else None


NEED_AMOUNT = {coriolis_turned, not_squared, velocity_not_squared, another_omega, another_alpha, another_rate, diameter, half, wrong_length,
               length_forgotten, from_absolute, without_2, wrong_velocity, revolutions, wrong_side}
__all__ = ["ACCELERATION", "KINDS", "plant"]
