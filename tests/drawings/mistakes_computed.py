"""Mistakes with numbers: amounts, readings, rates, equations. See `mistakes.py`."""

import math

import paper
from mistakes import kind
from plans import POLE, SEGMENT, VELOCITY, Op, equation


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


@kind("alpha-of-another-link", "", "tangential", may="omega-of-another-link")
def another_alpha(p):
    other = p.pick(p.rates("alpha", p.amount.rate))
    return other and p.amounts(rate=other)


@kind("rate-of-another-link", "", "relative", may="omega-of-another-link")
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
    return other and not p.amount.segment and p.amounts(length=other) or None


@kind("wrong-length-below-a-velocity", "wrong-length omega-from-wrong-length", "normal", "crank-normal")
def wrong_length_below(p):
    """v² / L with another length; as well ω v with ω from it."""
    other = p.pick(p.lengths(p.amount.length))
    return other and p.amount.segment and p.amounts(length=other) or None


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


# ---------------------------------------------------------------- lengths, rates

def other_segment(p, sheet, start, end):
    size = abs(p.sheets.point(sheet, start) - p.sheets.point(sheet, end))
    pairs = [(keep, n) for keep in (start, end) for n in p.points(sheet, keep) if n not in p.own
             and abs(abs(p.sheets.point(sheet, keep) - p.sheets.point(sheet, n)) - size) > 0.02 * size]
    return p.pick(pairs)


@kind("wrong-length-measured", "wrong-length wrong-segment", "measure")
def wrong_length_measured(p):
    return wrong_segment(p) if p.sheet == "scheme" else None


@kind("wrong-segment", "wrong-segment", "measure")
def wrong_segment_of_a_plan(p):
    return wrong_segment(p) if p.sheet != "scheme" else None


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
    segment = p.sheets.point(p.sheet, p.entry["to"]) - p.sheets.point(p.sheet, p.entry["from"])
    # Nobody reads a part that is nearly nothing.
    return [p.op.but(dict(p.entry), reading=part)] if abs(part(segment)) > 0.15 * abs(segment) else None


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


@kind("block-turns-otherwise", "", "same", may="omega-of-another-link")
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


@kind("wrong-sign-in-equation", "", "equations", may="wrong-sense")
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
