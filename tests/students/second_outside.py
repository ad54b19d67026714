"""Mistakes that are in no list: slips of hand, head and calculator as a second hand makes them. See `second_mistakes.py`."""

import math

from second_mistakes import (KINDS, Kind, another, changed, factor, is_alpha, is_omega, is_ray, is_turning, kind, need_crank, of, pick, written)
from second_task import TURN, Absurd, angle, distance


@kind("protractor-misread", "ray", only=is_ray)
def _(s, f, rng):
    f["direction"] += math.radians(rng.choice((5, -5, 8, -8, 10, -10, 15, -15)))


@kind("protractor-other-scale", "ray", only=is_ray)
def _(s, f, rng):
    f["direction"] = math.pi - f["direction"]


@kind("set-square-60", "ray", only=is_ray)
def _(s, f, rng):
    f["direction"] += math.radians(rng.choice((30, -30)))


@kind("set-square-45", "ray", only=is_ray)
def _(s, f, rng):
    f["direction"] += math.radians(rng.choice((45, -45)))


@kind("set-square-slipped", "ray")
def _(s, f, rng):
    f["shift"] = rng.choice((4, 5, 6, 8, -4, -6, -10))


@kind("along-the-other-link", "ray", only=lambda f: "link" in f and not f.get("image"))
def _(s, f, rng):
    others = sorted({g["link"] for k, w, g in s.acts if k == "ray" and "link" in g} - {f["link"]})
    others = [o for o in others if abs(math.sin(s.angle(*o) + TURN - f["direction"])) > 0.1]
    if not others:
        raise Absurd("no other link")
    f["direction"] = s.angle(*rng.choice(others)) + TURN


@kind("crossing-misplaced", "mark")
def _(s, f, rng):
    d, r = rng.uniform(0, 2 * math.pi), rng.uniform(6, 14)
    f["xy"] = (f["xy"][0] + r * math.cos(d), f["xy"][1] + r * math.sin(d))


@kind("mirrored-x", "mark")
def _(s, f, rng):
    f["xy"] = (-f["xy"][0], f["xy"][1])


def divide(f, ratio):
    """Another ratio than the right one, and than one turned about, which the list has."""
    if min(abs(ratio - f["ratio"]), abs(ratio - 1 / f["ratio"]), abs(ratio - 1 + f["ratio"])) < 0.1:
        raise Absurd("the ratio turned about")
    f["ratio"] = ratio


@kind("image-at-the-middle", "divide")
def _(s, f, rng):
    divide(f, 0.5)


@kind("image-by-a-guess", "divide")
def _(s, f, rng):
    divide(f, f["ratio"] * rng.choice((0.75, 0.8, 1.2, 1.3)))


def image_point(s, f):
    for t in s.task.triangles:
        names = [x.lower() for x in t]
        if f["to"] == names[2] and all(n in s.plans[f["plan"]] for n in names[:2]):
            return tuple(s.point(f["plan"], n) for n in names[:2])
    raise Absurd("no image here")


@kind("image-turned-90", "mark", only=lambda f: f["to"] in "efg")
def _(s, f, rng):
    b, _ = image_point(s, f)
    d, size = angle(b, f["xy"]) + rng.choice((TURN, -TURN)), distance(b, f["xy"])
    f["xy"] = (b[0] + size * math.cos(d), b[1] + size * math.sin(d))


@kind("image-equilateral", "mark", only=lambda f: f["to"] in "efg")
def _(s, f, rng):
    b, c = image_point(s, f)
    d = angle(b, c) + math.copysign(math.pi / 3, math.sin(angle(b, f["xy"]) - angle(b, c)))
    f["xy"] = (b[0] + distance(b, c) * math.cos(d), b[1] + distance(b, c) * math.sin(d))


@kind("vector-by-chance", "vector")
def _(s, f, rng):
    f["size"] *= rng.choice((0.6, 0.7, 0.8, 1.25, 1.4, 1.6))


@kind("vector-askew", "vector")
def _(s, f, rng):
    f["direction"] += math.radians(rng.choice((12, 25, 40, -12, -25, -40, 60)))


@kind("sine-for-cosine", "vector", only=of("crank", "normal", "drive"))
def _(s, f, rng):
    f["direction"] = TURN - f["direction"]


@kind("sign-of-x", "vector", only=of("crank", "normal", "coriolis", "drive"))
def _(s, f, rng):
    f["direction"] = math.pi - f["direction"]


@kind("times-cosine", "vector", "component", only=of("normal", "coriolis"))
def _(s, f, rng):
    f["size"] *= abs(math.cos(f["direction"]))


@kind("twice-omega", "vector", only=lambda f: f["reason"] == "normal" and "other" not in f)
def _(s, f, rng):
    f["size"] = 2 * abs(f["omega"]) * f["length"]


@kind("omega-cubed", "vector", only=lambda f: f["reason"] == "normal" and "other" not in f)
def _(s, f, rng):
    f["size"] = abs(f["omega"]) ** 3 * f["length"]


@kind("length-squared", "vector", only=lambda f: f["reason"] == "normal" and "other" not in f)
def _(s, f, rng):
    f["size"] = min(abs(f["omega"]) * f["length"] ** 2, 400 * s.mu["a"])


@kind("half-the-normal", "vector", only=lambda f: f["reason"] == "normal" and "other" not in f)
def _(s, f, rng):
    f["size"] /= 2


@kind("mu-not-squared", "vector", only=lambda f: f["reason"] == "normal" and "other" not in f)
def _(s, f, rng):
    f["size"] /= s.mu["v"]


@kind("alpha-for-omega-squared", "vector", only=lambda f: f["reason"] == "normal" and "other" not in f)
def _(s, f, rng):
    f["size"] = abs(f["omega"]) ** 1.5 * f["length"]


class Pairs(Kind):
    """Mistakes at two normal parts at once, those of links 2 and 3, or 4 and 5."""

    def sites(self, sheet):
        normals = {f["link"]: where for k, where, f in sheet.acts if k == "vector" and f["reason"] == "normal" and "other" not in f}
        if sheet.task.kind in ("third-class", "fourth-class", "hydraulic-boom"):
            return []
        return [(normals[a], normals[b]) for a, b in ("23", "45") if a in normals and b in normals]


@kind("normals-interchanged", "vector", "omega-of-another-link")
def _(s, f, rng):
    pairs = {"2": "3", "3": "2", "4": "5", "5": "4"}
    w = s.rates.get(f"omega({pairs.get(f['link'])})")
    if not w or abs(abs(w / f["omega"]) - 1) < 0.1:
        raise Absurd("no pair")
    f["size"] = w * w * f["length"]


@kind("coriolis-omega-squared", "vector", only=of("coriolis"))
def _(s, f, rng):
    f["size"] = 2 * f["omega"] ** 2 * abs(f["slide"]) if abs(f["omega"]) < 6 else f["size"] * 0.7


@kind("coriolis-four", "vector", only=of("coriolis"))
def _(s, f, rng):
    f["size"] *= 2


@kind("wrong-scale-laid-off", "vector", "wrong-scale")
def _(s, f, rng):
    f["size"] *= rng.choice((1.25, 0.8, s.mu[f["plan"]] / s.mu["v" if f["plan"] == "a" else "a"]))


@kind("ruler-by-a-centimetre", "segment", only=lambda f: f["value"] > 12)
def _(s, f, rng):
    f["value"] += rng.choice((10, -10))


@kind("from-the-edge-of-the-ruler", "segment")
def _(s, f, rng):
    f["value"] += rng.choice((5, 6, 8))


@kind("half-way", "segment")
def _(s, f, rng):
    f["value"] *= rng.choice((0.5, 0.66, 0.75))


@kind("sum-for-difference", "segment")
def _(s, f, rng):
    c = another(rng, s, f["plan"], f["a"], f["b"])
    f["value"] += s.ruler(distance(s.point(f["plan"], f["b"]), s.point(f["plan"], c)))


@kind("sizes-added", "segment", only=lambda f: s_ends_in_pole(f))
def _(s, f, rng):
    names = [w.split(":")[2].split(">") for k, w, g in s.acts if k == "vector" and g["plan"] == "a" and g["reason"] == "normal"]
    n = [end for start, end in names if end[-1].lower() == f["b"][0]]
    if f["plan"] != "a" or not n or n[0] not in s.plans["a"]:
        raise Absurd("no parts")
    m = s.point("a", n[0])
    f["value"] = s.ruler(distance((0, 0), m) + distance(m, s.point("a", f["b"])))


def s_ends_in_pole(f):
    return f["a"] in ("p", "π")


@kind("omega-from-radius", "rate", only=lambda f: is_omega(f) or is_alpha(f))
def _(s, f, rng):
    f["length"] *= rng.choice((0.5, 2))


@kind("rate-multiplied", "rate", only=is_omega)
def _(s, f, rng):
    f["value"] = f["sense"] * min(f["segment"] * f["length"], 1e5) if f["length"] < 3 else f["sense"] * f["length"] / f["segment"]


@kind("alpha-from-omega", "rate", only=is_alpha)
def _(s, f, rng):
    f["value"] = s.rates[f["box"].replace("alpha", "omega")] ** 2 * f["sense"]


@kind("calculator-slip", "rate")
def _(s, f, rng):
    factor(f, rng.choice((0.72, 0.85, 1.19, 1.37, 1.8)))


@kind("minutes-for-seconds", "rate", only=is_turning)
def _(s, f, rng):
    factor(f, rng.choice((60, 1 / 60)))


@kind("length-of-a-neighbour", "rate", only=lambda f: is_omega(f) or is_alpha(f))
def _(s, f, rng):
    known = s.task.lengths.values()
    factors = [k for k in (0.8, 0.85, 1.15, 1.25, 1.3) if all(abs(f["length"] * k / x - 1) > 0.06 for x in known)]
    if not factors:
        raise Absurd("it is the length of another link")
    f["length"] *= rng.choice(factors)


@kind("rounded-before", "rate", only=is_omega)
def _(s, f, rng):
    v = f["sense"] * f["segment"] / f["length"]
    f["value"] = float(f"{v:.0e}")


@kind("special-length-misread", "length")
def _(s, f, rng):
    f["value"] += rng.choice((5, 10, -5, 8))


@kind("digit-misread", "values")
def _(s, values, rng):
    box = pick(s, values, rng, lambda b, v: any(c in "1374569" for c in written(b, v, s)[:2]))
    t = written(box, values[box], s)
    i = next(i for i, c in enumerate(t) if c in "1374569")
    values[box] = t[:i] + {"1": "7", "7": "1", "3": "8", "4": "9", "5": "6", "6": "0", "9": "4"}[t[i]] + t[i + 1:]
    changed(s, box)


@kind("digit-dropped", "values", "decimal-slipped")
def _(s, values, rng):
    box = pick(s, values, rng, lambda b, v: abs(v) >= 100)
    t = written(box, values[box], s)
    i = 1 if t[0] != "-" else 2
    values[box] = t[:i] + t[i + 1:]
    changed(s, box)


@kind("box-above-copied", "values", "swapped wrong-segment")
def _(s, values, rng):
    boxes = list(values)
    i = rng.randrange(1, len(boxes))
    if boxes[i].split("(")[0] != boxes[i - 1].split("(")[0]:
        raise Absurd("not alike")
    values[boxes[i]] = values[boxes[i - 1]]
    changed(s, boxes[i])


@kind("a-number-from-nowhere", "values")
def _(s, values, rng):
    box = pick(s, values, rng, lambda b, v: True)
    values[box] *= rng.uniform(0.3, 2.2)
    changed(s, box)


@kind("crank-of-a-neighbour", "whole")
def _(s, f, rng):
    need_crank(s)
    s.omega = s.omega * rng.choice((0.75, 0.8, 1.2, 1.25, 1.5))


@kind("angle-from-y", "whole", "crank-angle")
def _(s, f, rng):
    need_crank(s)
    s.position = s.task.position(90 - s.task.crank_degrees)


@kind("angle-clockwise", "whole", "crank-angle")
def _(s, f, rng):
    need_crank(s)
    s.position = s.task.position(-s.task.crank_degrees)


@kind("angle-opposite", "whole", "crank-angle")
def _(s, f, rng):
    need_crank(s)
    s.position = s.task.position(180 + s.task.crank_degrees)


@kind("angle-misread", "whole", "crank-angle")
def _(s, f, rng):
    need_crank(s)
    s.position = s.task.position(s.task.crank_degrees + rng.choice((5, -5, 15, -15, 25, 35)))


@kind("another-exercise", "whole", "other-exercise another-exercise another-variant other-variant")
def _(s, f, rng):
    s.task = rng.choice(s.task.neighbours)
    s.omega, s.position = s.task.omega, s.task.position()


@kind("both-normals-forgotten", "vector", "normal-forgotten")
def _(s, f, rng):
    f["size"] = 0.0


@kind("plan-at-another-scale", "whole", "wrong-scale common-scale")
def _(s, f, rng):
    s.mu[rng.choice("va")] *= rng.choice((0.8, 1.25, 2, 2.5))


for name in ("normals-interchanged", "both-normals-forgotten"):
    one = KINDS[name]
    KINDS[name] = Pairs(name, "vector", one.accept, one.change, None, "outside")
