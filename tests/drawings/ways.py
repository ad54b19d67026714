"""From planned operations to a drawing: an order, a hand, lines that nothing uses, detours that are taken back."""

import cmath
import math
import re
from dataclasses import dataclass

import paper
from paper import Paper, Refused

SHEET_MM = {"scheme": 90, "velocity": 110, "acceleration": 130}


@dataclass(frozen=True)
class Hand:
    """What the board allows and how well somebody draws on it.

    snap     "all": all is exact; "points": lines are drawn free; "none": points, too
    mm, degrees   limits of the error of what is free
    stated   whether `through` and `along` stand at lines that are drawn free
    reads    whether lengths are read off and rounded, as with a ruler
    digits   of typed numbers
    inserts  how often a quantity of a formula is written as its number
    protractor   how often a direction is given in degrees, to a tenth
    marks    how often a crossing is marked with nothing said of the lines, where points are free"""

    snap: str = "all"
    mm: float = 0.3
    degrees: float = 0.3
    stated: bool = True
    reads: bool = False
    digits: int = 3
    inserts: float = 0.0
    protractor: float = 0.0
    marks: float = 0.0


EXACT = Hand(digits=12)


def hand_of(rng):
    snap = rng.choice(["all", "points", "none"])
    return Hand(snap, stated=rng.random() < 0.5, reads=rng.random() < (0.3 if snap == "all" else 0.6), digits=rng.choice([3, 3, 4]),
                inserts=rng.choice([0, 0, 0, 0, 0, 0.5]), protractor=rng.choice([0, 0, 0, 0, 0.4]), marks=rng.choice([0, 0, 0.3]))


# ---------------------------------------------------------------- order

def ordered(ops, rng):
    """The operations in an order in which each finds what it rests on: by lot, or much as they were planned."""
    makers = {}
    for i, op in enumerate(ops):
        for name in paper.makes(op.entry):
            if name in makers:
                raise Refused(f"{name} is made twice")
            makers[name] = i
    waits = [{makers[name] for name in paper.needs(op.entry) if name in makers} - {i} for i, op in enumerate(ops)]
    spread = rng.choice([1.5, 8, len(ops)])
    wish = [i + rng.uniform(0, spread) for i in range(len(ops))]
    done, out = set(), []
    while len(out) < len(ops):
        ready = [i for i in range(len(ops)) if i not in done and waits[i] <= done]
        if not ready:
            raise Refused("operations wait for each other")
        i = min(ready, key=wish.__getitem__)
        done.add(i)
        out.append(ops[i])
    return out


# ---------------------------------------------------------------- scales

def nice(x):
    """The next of 1, 2, 2.5, 5, 10 … that is not less."""
    power = 10.0**math.floor(math.log10(x))
    return next(m * power for m in (1, 2, 2.5, 5, 10) if m * power >= x * (1 - 1e-9))


def scales(mechanism, ops):
    """Scales by which the plans are about as large as a hand draws them."""
    sheets = carry_out(mechanism, ops, {s: 1.0 for s in paper.SHEETS})
    out = {}
    for sheet, points in sheets.points.items():
        places = list(points.values())
        extent = max(abs(p - q) for p in places for q in places)
        out[sheet] = nice(extent / SHEET_MM[sheet]) if extent else 1.0
    return out


def carry_out(mechanism, ops, of):
    sheets = Paper(mechanism, of)
    for op in ops:
        sheets.do(op.entry)
    return sheets


# ---------------------------------------------------------------- the hand

class Drawing:
    """Carries operations out by a hand and writes them down. `index` tells where each operation stands."""

    def __init__(self, mechanism, scale, hand, rng):
        self.hand, self.rng, self.scale = hand, rng, scale
        self.sheets = Paper(mechanism, scale)
        self.did, self.index, self.spare = [], {}, 0

    def error(self, limit):
        return self.rng.uniform(-limit, limit)

    def round(self, value):
        return 0.0 if value == 0 else round(value, self.hand.digits - 1 - math.floor(math.log10(abs(value))))

    def inserted(self, text, unknown=()):
        """A formula with some of its quantities written as numbers."""
        def number(token):
            if token in unknown or self.rng.random() > self.hand.inserts:
                return token
            value = self.round(self.sheets.number(token))
            return f"({value})" if value < 0 else f"{value}"
        return re.sub(r"[^\W\d][\w']*\([^()]*\)", lambda m: number(m[0]) if m[0].split("(")[0] not in paper.FUNCTIONS else m[0], text)

    def entries(self, op):
        """What is written down for an operation: mostly one entry; equations that are solved elsewhere give numbers."""
        if op.kind == "solve" and op.typed:
            after = self.exact(op.entry)
            return [{"compute": name, "value": self.round(after.numbers[name])} for name in op.entry["solve"]]
        return [self.drawn_entry(op)]

    def drawn_entry(self, op):
        """The entry of an operation as this hand does it; numbers come from what stands on the sheets, right or not."""
        entry, kind, hand = dict(op.entry), op.kind, self.hand
        if hand.inserts:
            entry.update({key: self.inserted(entry[key]) for key in ("size", "as") if key in entry})
            if "equations" in entry:
                entry["equations"] = [self.inserted(e, entry["solve"]) for e in entry["equations"]]
        if kind == "lay_off" and op.typed:
            entry["size"] = op.info.get("slip", lambda v: v)(self.round(self.sheets.value(entry["size"])))
        if kind == "compute" and op.typed and "as" in entry:
            value = self.round(self.sheets.value(entry["as"]))
            value = abs(value) if "sense" in entry else value
            entry = {"compute": entry["compute"], "value": op.info.get("slip", lambda v: v)(value),
                     **{k: v for k, v in entry.items() if k == "sense"}}
        if kind == "measure" and "read" not in entry and (hand.reads or "reading" in op.info):
            entry["read"] = self.read(op, entry)
        if hand.snap != "all" and kind == "line":
            entry["drawn"] = self.free_line(op, entry)
            if not hand.stated and "askew" not in op.info:
                del entry["through"], entry["along"]
        if kind == "line" and hand.snap == "all" and "askew" in op.info:
            entry["along"] = {"angle": round(math.degrees(cmath.phase(self.exact(entry).lines[entry["line"]][2])) + op.info["askew"], 3)}
        elif kind == "line" and hand.snap == "all" and self.rng.random() < hand.protractor:
            entry["along"] = {"angle": round(math.degrees(cmath.phase(self.exact(entry).lines[entry["line"]][2])), 1)}
        if hand.snap == "none" and kind in ("cross", "lay_off"):
            entry["drawn"] = self.free_point(op, entry)
            if kind == "cross" and self.rng.random() < hand.marks:
                entry = {"mark": entry["cross"], "on": entry["on"], "drawn": entry["drawn"]}
        return entry

    def exact(self, entry):
        """The sheets as they are after an entry that is carried out exactly."""
        saved = self.copy()
        self.sheets.do(entry)
        after, self.sheets = self.sheets, saved
        return after

    def copy(self):
        copy = Paper.__new__(Paper)
        copy.__dict__.update(self.sheets.__dict__)
        copy.points = {sheet: dict(points) for sheet, points in self.sheets.points.items()}
        copy.lines, copy.numbers = dict(self.sheets.lines), dict(self.sheets.numbers)
        return copy

    def read(self, op, entry):
        mu = self.scale[entry["on"]]
        p, q = (self.sheets.point(entry["on"], entry[key]) for key in ("from", "to"))
        size = abs(op.info["reading"](q - p)) if "reading" in op.info else abs(q - p)
        free = self.error(self.hand.mm) if self.hand.snap != "all" else 0.0
        size = max(size / mu + free, 0.0)
        size = float(f"{round(size, 1 if size > 5 else 2) * mu:.10g}") if self.hand.reads else size * mu
        return op.info.get("slip", lambda v: v)(size)

    def free_line(self, op, entry):
        sheet, place, way = self.exact(entry).lines[entry["line"]]
        aside = self.error(self.hand.mm) * self.scale[sheet] * way * 1j
        at = self.sheets.mm(sheet, place + aside + self.rng.uniform(-20, 20) * self.scale[sheet] * way)
        # It is turned about the place that it goes through, not about where it is written down.
        turn = self.error(self.hand.degrees) + op.info.get("askew", 0)
        pivot = self.sheets.mm(sheet, place + aside)
        at = pivot + (at - pivot) * cmath.exp(1j * math.radians(turn))
        return [round(at.real, 3), round(at.imag, 3), round(math.degrees(cmath.phase(way)) + turn, 3)]

    def free_point(self, op, entry):
        kind = next(iter(entry))
        after = self.exact(entry)
        sheet = after.sheet({**entry, "on": entry["on"]})
        end = after.points[sheet][entry[kind]]
        if kind == "lay_off":
            start = self.sheets.point(sheet, entry["from"])
            end = start + (end - start) * cmath.exp(1j * math.radians(self.error(self.hand.degrees)))
        end += cmath.rect(self.hand.mm * math.sqrt(self.rng.random()), self.rng.uniform(0, 2 * math.pi)) * self.scale[sheet]
        end += cmath.rect(op.info.get("off_mm", 0), op.info.get("off_way", 0)) * self.scale[sheet]
        at = self.sheets.mm(sheet, end)
        return [round(at.real, 3), round(at.imag, 3)]

    def put(self, entry):
        self.sheets.do(entry)
        self.did.append(entry)

    def do(self, op):
        self.index[id(op)] = len(self.did)
        for entry in self.entries(op):
            self.put(entry)

    def all(self, ops):
        for op in ops:
            self.do(op)
        return self.sheets

    # what nobody needs

    def detour(self, ops):
        """Does some operations and takes them back."""
        saved, before = self.copy(), len(self.did)
        for op in ops:
            try:
                for entry in self.entries(op):
                    self.put(entry)
            except Refused:
                continue
        count = len(self.did) - before
        self.sheets = saved
        if count:
            self.did += [{"undo": count}] if self.rng.random() < 0.6 else [{"undo": 1}] * count

    def extra(self, own):
        """A line, a length or a number that nothing uses."""
        sheet = self.rng.choice(paper.SHEETS)
        points = sorted(p for p in self.sheets.points[sheet] if p != "pi")
        places = self.sheets.points[sheet]
        apart = [(p, q) for p in points for q in points if abs(places[p] - places[q]) > 2 * self.scale[sheet]]
        if not apart:
            return
        p, q = self.rng.choice(apart)
        way = self.rng.randrange(4)
        if way == 0:
            self.put({"join": own("x"), "on": sheet, "points": [p, q]})
        elif way == 1:
            along = {self.rng.choice(["parallel", "normal"]): self.rng.choice(sorted(self.sheets.mechanism.guides) or [f"{p},{q}"])}
            self.put({"line": own("x"), "on": sheet, "through": p, "along": along})
        elif way == 2:
            self.put({"measure": own("m"), "on": sheet, "from": p, "to": q})
        else:
            self.put({"compute": own("z"), "as": f"{self.rng.choice(['2*', ''])}{'L' if sheet == 'scheme' else sheet[0] + 'plan'}({p},{q})"})


def perform(mechanism, ops, scale, hand, rng, own, wrong_of=None, extras=0.0, detours=0.0, watch=None):
    """Carries ordered operations out. `wrong_of(i)` is a wrong way to do one, for detours; `watch` is told the sheets so far."""
    d = Drawing(mechanism, scale, hand, rng)
    for i, op in enumerate(ops):
        if watch:
            watch[0] = d.sheets
        if rng.random() < extras:
            d.extra(own)
        if rng.random() < detours:
            wrong = wrong_of(i) if wrong_of and rng.random() < 0.6 else None
            d.detour([wrong] if wrong else ops[i:i + rng.choice((1, 1, 2, 3))])
        d.do(op)
    return d


def head(drawing, exercise=""):
    return {"kinegon_drawing": 1, **({"exercise": exercise} if exercise else {}), "snap": drawing.hand.snap,
            "mu_l": drawing.scale["scheme"], "mu_v": drawing.scale["velocity"], "mu_a": drawing.scale["acceleration"],
            "did": drawing.did}


def spelt(did, rng):
    """The same entries as somebody else writes them: `pi` for π, no `on` where a name or the lines of a crossing say it."""
    pi, short = rng.random() < 0.3, rng.random() < 0.5
    decides = {"p": "velocity", "π": "acceleration"}

    def entry(e):
        e = dict(e)
        named = [e.get("from"), e.get("to"), e.get("through")]
        if "cross" in e or short and "drawn" not in e and any(decides.get(n) == e.get("on") for n in named if n in decides):
            e.pop("on", None)
        if pi:
            for key in ("from", "to", "through"):
                e[key] = "pi" if e.get(key) == "π" else e.get(key)
            for key in ("size", "as"):
                e[key] = e[key].replace("(π,", "(pi,").replace(",π)", ",pi)") if isinstance(e.get(key), str) else e.get(key)
            e = {k: v for k, v in e.items() if v is not None}
        return e

    return [entry(e) for e in did]


# ---------------------------------------------------------------- values

def values(sheets, own):
    """All that has a name of the plans or of a quantity, and not one's own."""
    out = {f"{sheet}:{name}": z for sheet, points in sheets.points.items() for name, z in points.items() if name not in own}
    out.update({name: x for name, x in sheets.numbers.items() if name not in own})
    return out


def kind_of(name):
    return name.split(":")[0] if ":" in name else name.split("(")[0]


def largest_move(before, after):
    """By how much the values move, relative to the largest of their kind."""
    most = {}
    for name, x in before.items():
        most[kind_of(name)] = max(most.get(kind_of(name), 0), abs(x))
    return max((abs(after[name] - x) / (most[kind_of(name)] or 1) for name, x in before.items() if name in after), default=0.0)
