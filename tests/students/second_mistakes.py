"""What students of the second hand do wrong: mistakes of the list in docs/checking.md as its words are understood, and mistakes that are in
no list. Each is put in at one act of the sheet, or at the whole of it; see `Sheet.act`.
"""

import math
import random

from second import text
from second_task import TURN, Absurd, angle, distance

KINDS = {}


class Kind:
    """A kind of mistake: at which acts it can be made, what it does there, and by which names a report tells it rightly."""

    def __init__(self, name, at, accept, change, only, scope):
        self.name, self.at, self.accept, self.change, self.only, self.scope = name, at, accept, change, only, scope
        self.listed = scope == "listed"

    def sites(self, sheet):
        """The acts of a right sheet at which it can be made."""
        if self.at == "whole":
            return ["whole"]
        return [where for kind, where, f in sheet.acts if kind == self.at and (self.only is None or self.only(f))]


class Mistake:
    """One mistake at one place of one sheet. `places` are the acts at which it is made."""

    def __init__(self, kind, site, seed):
        self.kind, self.site, self.seed, self.places = kind, site, seed, []

    def begin(self, sheet):
        if self.kind.at == "whole":
            self.kind.change(sheet, None, random.Random(self.seed))

    def touch(self, sheet, kind, where, f):
        if where == self.site or (isinstance(self.site, tuple) and where in self.site):
            self.kind.change(sheet, f, random.Random(self.seed))
            self.places.append(where)
            if kind == "rate":  # the segment is taken by its scale there
                self.places += [f"{f['plan']}:segment:{a}-{b}" for a, b in [f.get("ends") or (None, None)] if a]
            if kind in ("ray", "vector"):  # lengths do not tell it from the vector at whose end it begins
                start = ">" + where.split(":")[2].split(">")[0]
                self.places += [w for k, w, g in sheet.acts if k == "vector" and w[0] == f["plan"] and w.endswith(start)]
            if kind == "mark":  # a point is where its rays are
                self.places += [w for k, w, _ in sheet.acts if k == "ray" and w.startswith(f["plan"]) and w.endswith(">" + f["to"])]

    def end(self, sheet, values):
        if self.kind.at == "values":
            self.kind.change(sheet, values, random.Random(self.seed))


class AtTheEnd(Kind):
    """Mistakes in writing down: the change gets all values of the form, and says in which it was made."""

    def sites(self, sheet):
        return ["values"]


def kind(name, at, accept="", only=None):
    """Registers a kind. `accept` lists names of docs/checking.md that tell it rightly; a kind that is in no list has none."""
    listed = accept.split(" ")[0] == name

    def register(change):
        maker = AtTheEnd if at == "values" else Kind
        KINDS[name] = maker(name, at, set(accept.split()), change, only, "listed" if listed else "outside")
        return change
    return register


def is_ray(f):
    return not f.get("image")


def of(*reasons):
    return lambda f: f["reason"] in reasons


def is_omega(f):
    return f["box"].startswith("omega") and f["segment"] is not None


def is_alpha(f):
    return f["box"].startswith("alpha") and f["segment"] is not None


def is_turning(f):
    return f["box"].startswith(("omega", "alpha"))


def velocity_of(s, name):
    """The size of a point's velocity, as the sheet shows it."""
    return distance((0, 0), s.plans["v"][name]) * s.mu["v"] if name in s.plans["v"] else 0.0


def another(rng, s, plan, *not_these):
    """Another point of the plan that can be told from these."""
    here = [s.point(plan, n) for n in not_these]
    names = [n for n in s.plans[plan] if n == s.same(n) or n in ("p", "π")]
    names = [n for n in names if all(distance(s.point(plan, n), h) > 8 for h in here)]
    if not names:
        raise Absurd("no other point")
    return rng.choice(sorted(names))


def other_length(rng, s, size):
    lengths = sorted(x for x in set(s.task.lengths.values()) if not 0.92 < x / size < 1.08)
    if not lengths:
        raise Absurd("no other length")
    return rng.choice(lengths)


def forget(s, f, rng):
    """A part left out: its box is written 0, or left blank."""
    f["size"] = 0.0
    if rng.random() < 0.5:
        s.blank.add((f["from"], f["to"]))


# In the list

@kind("turned-ray", "ray", "turned-ray", is_ray)
def _(s, f, rng):
    f["direction"] += TURN


@kind("ray-from-wrong-point", "ray", "ray-from-wrong-point", is_ray)
def _(s, f, rng):
    f["from"] = another(rng, s, f["plan"], f["from"])


@kind("wrong-lines", "special", "wrong-lines")
def _(s, f, rng):
    others = [("B", "C"), ("F", "D"), ("G", "E")] if s.task.kind == "third-class" else [("B", "C"), ("E", "D"), ("B", "G"), ("E", "F")]
    others = [o for o in others if o not in f["lines"] and not set(o) & set(f["lines"][0])]
    if not others:
        raise Absurd("no other line")
    f["lines"] = [f["lines"][0], rng.choice(others)]


@kind("reversed-vector", "vector", "reversed-vector normal-outward wrong-sense", of("relative", "tangential", "drive", "crank"))
def _(s, f, rng):
    f["direction"] += math.pi


@kind("turned-vector", "vector", "turned-vector", of("crank", "relative", "tangential"))
def _(s, f, rng):
    f["direction"] += rng.choice((TURN, -TURN))


@kind("vector-from-wrong-point", "vector", "vector-from-wrong-point", of("normal", "coriolis"))
def _(s, f, rng):
    if s.same(f["from"]) == "0":
        f["from"] = another(rng, s, "a", f["from"])
    else:
        f["from"] = "π"


@kind("normal-outward", "vector", "normal-outward reversed-vector", of("normal"))
def _(s, f, rng):
    f["direction"] += math.pi


@kind("omega-not-squared", "vector", "omega-not-squared", lambda f: f["reason"] in ("normal", "crank") and f["plan"] == "a")
def _(s, f, rng):
    f["size"] = abs(f["omega"]) * f["length"] + f.get("other", 0)


@kind("omega-of-another-link", "vector", "omega-of-another-link", of("normal", "coriolis"))
def _(s, f, rng):
    pool = [v for k, v in s.rates.items() if k.startswith("omega") and abs(abs(v / f["omega"]) - 1) > 0.1]
    pool += [s.omega] if s.omega else []
    w = rng.choice(pool)
    f["size"] = w * w * f["length"] + f.get("other", 0) if f["reason"] == "normal" else abs(2 * w * f["slide"])


@kind("diameter", "vector", "diameter", lambda f: f["reason"] == "normal" and "other" not in f)
def _(s, f, rng):
    f["size"] *= 2


@kind("normal-from-absolute", "vector", "normal-from-absolute", lambda f: f["reason"] == "normal" and "other" not in f)
def _(s, f, rng):
    v = velocity_of(s, f["of"].lower())
    f["size"] = v * v / f["length"]


@kind("normal-forgotten", "vector", "normal-forgotten", of("normal"))
def _(s, f, rng):
    forget(s, f, rng)


@kind("coriolis-forgotten", "vector", "coriolis-forgotten", of("coriolis"))
def _(s, f, rng):
    forget(s, f, rng)


@kind("coriolis-without-2", "vector", "coriolis-without-2", of("coriolis"))
def _(s, f, rng):
    f["size"] /= 2


@kind("coriolis-turned", "vector", "coriolis-turned", of("coriolis"))
def _(s, f, rng):
    f["direction"] += math.pi


@kind("coriolis-along-guide", "vector", "coriolis-along-guide", of("coriolis"))
def _(s, f, rng):
    f["direction"] = f["guide"] + rng.choice((0, math.pi))


@kind("coriolis-wrong-velocity", "vector", "coriolis-wrong-velocity", of("coriolis"))
def _(s, f, rng):
    f["size"] = abs(2 * f["omega"]) * velocity_of(s, rng.choice([n for n in ("b", "b_3", "c") if n in s.plans["v"]]))


@kind("mirrored-image", "mark", "mirrored-image", lambda f: f["to"] in "efg")
def _(s, f, rng):
    for t in s.task.triangles:
        names = [x.lower() for x in t]
        if f["to"] == names[2] and all(n in s.plans[f["plan"]] for n in names[:2]):
            b, c = (s.point(f["plan"], n) for n in names[:2])
            d, size = angle(b, f["xy"]), distance(b, f["xy"])
            d = 2 * angle(b, c) - d
            f["xy"] = (b[0] + size * math.cos(d), b[1] + size * math.sin(d))
            return
    raise Absurd("no image here")


@kind("wrong-ratio", "divide", "wrong-ratio")
def _(s, f, rng):
    f["ratio"] = rng.choice((1 / f["ratio"], 1 - f["ratio"]))


@kind("wrong-segment", "segment", "wrong-segment")
def _(s, f, rng):
    keep, other = (f["a"], f["b"]) if rng.random() < 0.5 else (f["b"], f["a"])
    f["value"] = s.ruler(distance(s.point(f["plan"], keep), s.point(f["plan"], another(rng, s, f["plan"], keep, other))))


@kind("component", "segment", "component")
def _(s, f, rng):
    a, b = s.point(f["plan"], f["a"]), s.point(f["plan"], f["b"])
    f["value"] = s.ruler(abs(b[0] - a[0]) if rng.random() < 0.5 else abs(b[1] - a[1]))


@kind("wrong-length", "vector", "wrong-length", lambda f: f["reason"] == "normal" and "other" not in f)
def _(s, f, rng):
    f["size"] *= other_length(rng, s, f["length"]) / f["length"]


@kind("omega-from-wrong-length", "rate", "omega-from-wrong-length", is_omega)
def _(s, f, rng):
    f["length"] = other_length(rng, s, f["length"])


@kind("alpha-from-wrong-length", "rate", "alpha-from-wrong-length", is_alpha)
def _(s, f, rng):
    f["length"] = other_length(rng, s, f["length"])


@kind("not-divided-by-length", "rate", "not-divided-by-length", lambda f: is_omega(f) or is_alpha(f))
def _(s, f, rng):
    f["length"] = 1


@kind("wrong-sense", "rate", "wrong-sense")
def _(s, f, rng):
    if f["value"] is None:
        f["sense"] *= -1
    else:
        f["value"] *= -1


@kind("senses-reversed", "values", "senses-reversed")
def _(s, values, rng):
    for box in values:
        if box.startswith(("omega", "alpha")):
            values[box] = -values[box]


def factor(f, by):
    if f["value"] is None:
        f["segment"] *= by
    else:
        f["value"] *= by


@kind("wrong-scale", "rate", "wrong-scale", lambda f: f["segment"] is not None)
def _(s, f, rng):
    mu = s.mu[f["plan"]]
    others = [m for m in (s.mu["v"], s.mu["a"], s.mu["l"], 1.0) if m / mu not in (1, 0.1, 0.01, 0.001, 10, 100, 1000)]
    if not others:
        raise Absurd("no other scale")
    other = rng.choice(others)
    factor(f, other / mu)


@kind("other-mode", "whole", "other-mode senses-reversed")  # a boom mirrored as a whole has the same sizes
def _(s, f, rng):
    s.position = s.task.position(mode=1)


@kind("crank-angle", "whole", "crank-angle")
def _(s, f, rng):
    need_crank(s)
    s.position = s.task.position(s.task.crank_degrees + rng.choice((10, -10, 20, -20)))


def need_crank(s):
    if s.task.crank_degrees is None:
        raise Absurd("no crank")


def changed(s, *boxes):
    for m in s.mistakes:
        if m.kind.at == "values":
            m.places += [f"box:{b}" for b in boxes]


def pick(s, values, rng, good):
    boxes = [b for b, v in values.items() if isinstance(v, float) and v and good(b, v)]
    if not boxes:
        raise Absurd("no such value")
    return rng.choice(boxes)


@kind("swapped", "values", "swapped")
def _(s, values, rng):
    a = pick(s, values, rng, lambda b, v: True)
    b = pick(s, values, rng, lambda x, v: x.split("(")[0] == a.split("(")[0] and not 0.85 < abs(v / values[a]) < 1.15)
    values[a], values[b] = values[b], values[a]
    changed(s, a, b)


def written(box, v, s):
    return text(box, v, s.hand)


@kind("digits-transposed", "values", "digits-transposed")
def _(s, values, rng):
    def places(b, v):
        t = written(b, v, s)
        return [i for i in range(len(t) - 1) if t[i:i + 2].isdigit() and t[i] != t[i + 1]][:1]
    box = pick(s, values, rng, places)
    t, i = written(box, values[box], s), places(box, values[box])[0]
    values[box] = t[:i] + t[i + 1] + t[i] + t[i + 2:]
    changed(s, box)


@kind("decimal-slipped", "values", "decimal-slipped")
def _(s, values, rng):
    box = pick(s, values, rng, lambda b, v: abs(v) > 2)
    values[box] *= rng.choice((10, 0.1))
    changed(s, box)


@kind("degrees-for-radians", "rate", "degrees-for-radians", is_turning)
def _(s, f, rng):
    factor(f, 180 / math.pi)


@kind("revolutions-for-radians", "rate", "revolutions-for-radians", lambda f: f["box"].startswith("omega"))
def _(s, f, rng):
    factor(f, 30 / math.pi)


@kind("common-scale", "values", "common-scale")
def _(s, values, rng):
    k = rng.choice((1.015, 1.02, 1.03, 1.0309, 1.04, 1.05, 1.06, 0.97, 0.95))
    for box in values:
        if box.startswith(("vplan", "aplan", "L(")):
            values[box] *= k
    changed(s, next(iter(values)))


@kind("common-zero", "values", "common-zero")
def _(s, values, rng):
    k = rng.choice((1.0, 2.0, 3.0, 5.0, -1.0, -2.0))
    for box in values:
        if box.startswith(("vplan", "aplan", "L(")) and values[box]:
            values[box] = max(values[box] + k, 0.0)
    changed(s, next(iter(values)))
