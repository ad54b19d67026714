"""A sheet on which the entries of a drawing are carried out, as docs/drawings.md says. It knows nothing of right or wrong.

Points are complex numbers: places of the scheme in units of length, of the plans in units from their pole. Lines are a place and a
direction. `needs` and `makes` say what an entry rests on and what it gives, as `velocity:b` for points and plain names for lines and
numbers."""

import math
import re

from truth import dot, eliminate, unit

SHEETS = ("scheme", "velocity", "acceleration")
POLES = {"velocity": "p", "acceleration": "π"}
HEADS = {"vplan": "velocity", "aplan": "acceleration", "L": "scheme"}
FUNCTIONS = {"sqrt": math.sqrt, "abs": abs, "sin": lambda x: math.sin(math.radians(x)), "cos": lambda x: math.cos(math.radians(x)),
             "tan": lambda x: math.tan(math.radians(x))}
TOKEN = re.compile(r"\s*(?:(?P<number>\d+\.?\d*(?:e[-+]?\d+)?|\.\d+)|(?P<name>[^\W\d][\w']*)(?P<arguments>\([^()]*\))?|(?P<sign>[-+*/^()]))")


class Refused(Exception):
    """An entry that cannot be carried out: a name that is not there, lines that do not cross."""


def tokens(text):
    """What a formula is made of; a quantity such as omega(2) is one token."""
    at, out = 0, []
    text = str(text).strip()
    while at < len(text):
        m = TOKEN.match(text, at)
        if not m:
            raise Refused(f"formula {text!r} at {at}")
        if m["name"] and m["arguments"] and m["name"] not in FUNCTIONS:
            out.append(("quantity", f"{m['name']}{m['arguments'].replace(' ', '')}"))
            at = m.end()
        elif m["name"]:
            out.append(("name", m["name"]))
            at = m.start("name") + len(m["name"])
        else:
            kind = "number" if m["number"] else "sign"
            out.append((kind, m[kind]))
            at = m.end()
    return out


def names_in(text):
    """Names and quantities of a formula."""
    return [token for kind, token in tokens(text) if kind == "quantity" or kind == "name" and token not in FUNCTIONS]


class Formula:
    """Works a formula out; `linear` are the unknowns that may stand in it, so a value is {unknown or 1: coefficient}."""

    def __init__(self, text, value_of, linear=()):
        self.left, self.value_of, self.linear = tokens(text), value_of, linear

    def take(self, *signs):
        if self.left and self.left[0][0] == "sign" and self.left[0][1] in signs:
            return self.left.pop(0)[1]
        return None

    def value(self):
        out = self.sum()
        if self.left:
            raise Refused(f"formula goes on with {self.left[0][1]}")
        return out

    def sum(self):
        out = self.product()
        while sign := self.take("+", "-"):
            more = self.product()
            out = {k: out.get(k, 0) + (1 if sign == "+" else -1) * more.get(k, 0) for k in {**out, **more}}
        return out

    def product(self):
        out = self.signed()
        while sign := self.take("*", "/"):
            more = self.signed()
            if sign == "/":
                out = {k: x / more[1] for k, x in out.items()}
            elif set(more) == {1}:
                out = {k: x * more[1] for k, x in out.items()}
            else:
                out = {k: x * out[1] for k, x in more.items()}
        return out

    def signed(self):
        if self.take("-"):
            return {k: -x for k, x in self.signed().items()}
        self.take("+")
        out = self.atom()
        if self.take("^"):
            out = {1: out[1]**self.signed()[1]}
        return out

    def atom(self):
        if self.take("("):
            out = self.sum()
            self.take(")")
            return out
        kind, token = self.left.pop(0)
        if kind == "number":
            return {1: float(token)}
        if token in FUNCTIONS:
            return {1: FUNCTIONS[token](self.atom()[1])}
        return {token: 1.0} if token in self.linear else {1: self.value_of(token)}


def ends(quantity):
    """Sheet and points of a segment such as vplan(b,c); None for another quantity."""
    m = re.fullmatch(r"(vplan|aplan|L)\(([^,()]+),([^,()]+)\)", quantity)
    return (HEADS[m[1]], m[2], m[3]) if m else None


class Paper:
    def __init__(self, mechanism, scales):
        self.mechanism, self.scales = mechanism, scales
        self.origin = {"scheme": next(iter(mechanism.at.values())), "velocity": 0j, "acceleration": 0j}
        self.points = {"scheme": dict(mechanism.at)}
        for sheet, pole in POLES.items():
            self.points[sheet] = {pole: 0j, **{name.lower(): 0j for name in mechanism.ground}}
        self.points["acceleration"]["pi"] = 0j
        self.lines, self.numbers, self.given = {}, {}, given(mechanism)

    # what names mean

    def point(self, sheet, name):
        if name not in self.points[sheet]:
            raise Refused(f"no point {name} on {sheet}")
        return self.points[sheet][name]

    def way(self, sheet, ref):
        """The direction of a reference, as a vector."""
        if "," in ref:
            p, q = ref.split(",")
            on = sheet if p in self.points[sheet] and q in self.points[sheet] else "scheme"
            return self.point(on, q) - self.point(on, p)
        if ref in self.lines:
            return self.lines[ref][2]
        if ref in self.mechanism.guides:
            return self.mechanism.guides[ref]
        if len(self.mechanism.links.get(ref, ())) != 2:
            raise Refused(f"no direction {ref}")
        p, q = self.mechanism.links[ref]
        return self.mechanism.at[q] - self.mechanism.at[p]

    def along(self, sheet, along):
        if "parallel" in along:
            way = self.way(sheet, along["parallel"])
        elif "normal" in along:
            way = self.way(sheet, along["normal"]) * 1j
        elif "turned" in along:
            one, other = (self.way(sheet, ref) for ref in along["turned"])
            way = self.way(sheet, along["base"]) * other / one
        else:
            return unit(along["angle"])
        if way == 0:
            raise Refused("no direction")
        return way / abs(way)

    def number(self, name):
        if name in self.numbers:
            return self.numbers[name]
        if name in self.given:
            return self.given[name]
        if segment := ends(name):
            sheet, p, q = segment
            return abs(self.point(sheet, q) - self.point(sheet, p))
        raise Refused(f"no number {name}")

    def value(self, text):
        return Formula(text, self.number).value().get(1, 0.0)

    def mm(self, sheet, place):
        return (place - self.origin[sheet]) / self.scales[sheet]

    def from_mm(self, sheet, x, y):
        return complex(x, y) * self.scales[sheet] + self.origin[sheet]

    # entries

    def sheet(self, entry):
        if "on" in entry:
            return entry["on"]
        if "of" in entry:
            return self.lines[entry["of"][0]][0]
        names = [entry.get("from"), entry.get("to"), entry.get("through"), *entry.get("ends", []), *entry.get("points", [])]
        for name in names:
            found = [s for s in SHEETS if name in self.points[s]]
            if len(found) == 1:
                return found[0]
        raise Refused(f"which sheet? {entry}")

    def do(self, entry):
        kind = next(iter(entry))
        getattr(self, f"do_{kind}")(entry)

    def place(self, sheet, name, place):
        if name in self.points[sheet]:
            raise Refused(f"{name} is there already")
        self.points[sheet][name] = place

    def do_join(self, e):
        sheet = self.sheet(e)
        p, q = (self.point(sheet, name) for name in e["points"])
        self.rule(e["join"], sheet, p, q - p)

    def rule(self, name, sheet, place, way):
        if name in self.lines or abs(way) == 0:
            raise Refused(f"line {name}")
        self.lines[name] = (sheet, place, way / abs(way))

    def do_line(self, e):
        sheet = self.sheet(e)
        if "drawn" in e:
            x, y, degrees = e["drawn"]
            return self.rule(e["line"], sheet, self.from_mm(sheet, x, y), unit(degrees))
        return self.rule(e["line"], sheet, self.point(sheet, e["through"]), self.along(sheet, e["along"]))

    def do_cross(self, e):
        sheet = self.sheet(e)
        (s1, p, u), (s2, q, w) = (self.lines[name] for name in e["of"])
        if s1 != s2 or abs(dot(u * 1j, w)) < 1e-9:
            raise Refused("these lines do not cross")
        place = p + u * (dot(w * 1j, q - p) / dot(w * 1j, u))
        self.place(sheet, e["cross"], self.from_mm(sheet, *e["drawn"]) if "drawn" in e else place)

    def do_mark(self, e):
        self.place(self.sheet(e), e["mark"], self.from_mm(self.sheet(e), *e["drawn"]))

    def do_lay_off(self, e):
        sheet = self.sheet(e)
        end = self.point(sheet, e["from"]) + self.value(e["size"]) * self.along(sheet, e["along"])
        self.place(sheet, e["lay_off"], self.from_mm(sheet, *e["drawn"]) if "drawn" in e else end)

    def do_like(self, e):
        sheet = self.sheet(e)
        p, q = (self.point(sheet, name) for name in e["ends"])
        a, b, c = (self.point("scheme", name) for name in e["points"])
        ratio = (c - a) / (b - a)
        self.place(sheet, e["like"], p + (q - p) * (ratio.conjugate() if e.get("mirrored") else ratio))

    def do_measure(self, e):
        sheet = self.sheet(e)
        read = abs(self.point(sheet, e["to"]) - self.point(sheet, e["from"]))
        self.numbers[e["measure"]] = e.get("read", read)

    def do_compute(self, e):
        value = e["value"] if "value" in e else self.value(e["as"])
        if "sense" in e:
            value = abs(value) * (1 if e["sense"] == "ccw" else -1)
        self.numbers[e["compute"]] = value

    def do_solve(self, e):
        names, rows = e["solve"], []
        for equation in e["equations"]:
            left, right = (Formula(side, self.number, names).value() for side in equation.split("="))
            rows.append(({n: left.get(n, 0) - right.get(n, 0) for n in names}, right.get(1, 0) - left.get(1, 0)))
        self.numbers.update(eliminate(rows, names))


def given(m):
    """Quantities that the scene gives: lengths, rates of drives, known velocities and accelerations."""
    out = {}
    for (p, q), size in m.lengths.items():
        out[f"L({p},{q})"] = out[f"L({q},{p})"] = size
    for link, drive in m.drives.items():
        if "omega" in drive:
            out[f"omega({link})"], out[f"alpha({link})"] = drive["omega"], drive.get("alpha", 0)
    for link, motion in m.motions.items():
        out[f"omega({link})"], out[f"alpha({link})"] = motion.get("omega", 0), motion.get("alpha", 0)
        out[f"v({motion['at']})"], out[f"a({motion['at']})"] = abs(m.v[motion["at"]]), abs(m.a[motion["at"]])
    for point in m.known:
        out[f"v({point})"], out[f"a({point})"] = abs(m.v[point]), abs(m.a[point])
    for s in m.sliders:
        if s.drive:
            out[f"v_r({s.name})"], out[f"a_r({s.name})"] = m.v_r[s.name], m.a_r[s.name]
            out[f"position({s.name})"] = s.drive.get("position", dot(m.guides[s.name], m.at[s.point] - s.place(m.at)))
    return out


def standing(did):
    """The entries that no undo has taken back, with their indices."""
    stack = []
    for index, entry in enumerate(did):
        if "undo" in entry:
            del stack[max(len(stack) - entry["undo"], 0):]
        else:
            stack.append((index, entry))
    return stack


def replay(mechanism, drawing):
    """The sheets at the end of a drawing."""
    of = {**mechanism.scene.get("figure", {}), **drawing}
    paper = Paper(mechanism, {"scheme": of["mu_l"], "velocity": of["mu_v"], "acceleration": of["mu_a"]})
    for _, entry in standing(drawing["did"]):
        paper.do(entry)
    return paper


# ---------------------------------------------------------------- what an entry rests on

def makes(entry):
    kind = next(iter(entry))
    name = entry[kind]
    if kind in ("cross", "lay_off", "like", "mark"):
        return [f"{entry['on']}:{name}"]
    return list(name) if kind == "solve" else [name]


def _formula(text):
    out = []
    for name in names_in(text):
        out.append(name)
        if segment := ends(name):
            out += [f"{segment[0]}:{segment[1]}", f"{segment[0]}:{segment[2]}"]
    return out


def needs(entry):
    """Names that an entry may rest on; those that nothing makes are given. Every entry has its `on` while it is planned."""
    on, out = entry.get("on"), []
    for key in ("from", "to", "through"):
        if key in entry:
            out.append(f"{on}:{entry[key]}")
    out += [f"{on}:{name}" for name in entry.get("ends", [])]
    out += [f"{on if 'join' in entry else 'scheme'}:{name}" for name in entry.get("points", [])]
    out += entry.get("of", [])
    for value in entry.get("along", {}).values():
        for ref in value if isinstance(value, list) else [value] if isinstance(value, str) else []:
            out.append(ref)
            if "," in ref:
                out += [f"{sheet}:{name}" for name in ref.split(",") for sheet in (on, "scheme")]
    for key in ("size", "as"):
        if key in entry:
            out += _formula(entry[key])
    for equation in entry.get("equations", []):
        out += [name for side in equation.split("=") for name in _formula(side) if name not in entry["solve"]]
    return out
