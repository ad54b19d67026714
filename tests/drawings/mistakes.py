"""Mistakes that students make: each is a change of one operation. A kind is a function over a `Place`; it gives the operations that
stand in place of the right one, the wrong one last, or None where it cannot be made there. `names` are the ids of docs/mistakes.md that
name it rightly; kinds without names are of no catalogue, so that the judge may name none. The kinds themselves are in
`mistakes_drawn.py` and `mistakes_computed.py`."""

import json
import re

from paper import Refused
from plans import Op

KINDS = {}


class Unfit(Exception):
    """The mistake cannot be made here."""


class Kind:
    """`names` must be told, of `may` one may be told besides, or none."""

    def __init__(self, name, names, roles, may, change):
        self.name, self.names, self.roles, self.may, self.change = name, set(names), set(roles), set(may), change


def kind(name, names, *roles, may=""):
    def register(change):
        KINDS[name] = Kind(name, names.split(), roles, may.split(), change)
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
        if "amount" not in self.op.info:
            raise Unfit
        return self.op.info["amount"]

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
        if k > i and (entry := json.loads(word.sub(start, json.dumps(op.entry, ensure_ascii=False)))) != op.entry:
            op = Op(entry, op.role, op.info, op.typed)
            if "measure" in op.entry and "(" in op.entry["measure"] and op.entry["from"] == op.entry["to"]:
                return None
        out.append(op)
    return (out, wrong) if wrong is not None else None


def plant(ops, i, chosen, sheets, own, rng, snap):
    """Puts a mistake of a kind in at an operation: the new operations and which of them is wrong; None where it cannot be."""
    if ops[i].role not in chosen.roles:
        return None
    place = Place(ops, i, sheets, own, rng, snap)
    try:
        new = chosen.change(place)
    except (Unfit, KeyError, Refused, ZeroDivisionError):
        return None
    if new == "forgotten":
        return leave_out(ops, i) if ops[i].kind == "lay_off" else None
    return (ops[:i] + new + ops[i + 1:], i + len(new) - 1) if new else None
