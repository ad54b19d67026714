"""The constructions of the textbooks, as entries of a drawing: cranks, groups of two links, images, special points. `scenes.py` says
which of them make the plans of each mechanism.

A construction can be carried out in many ways, all of them right; each `Draft` takes its own by lot. An `Op` is an entry together with
what it is for, which is what a mistake needs to know (`mistakes.py`). Order, hands and detours come later (`ways.py`)."""

import math
from dataclasses import dataclass, field, replace

import paper

VELOCITY, ACCELERATION = "velocity", "acceleration"
PLANS = (VELOCITY, ACCELERATION)
POLE = paper.POLES
SEGMENT = {VELOCITY: "vplan", ACCELERATION: "aplan"}
TURN = {VELOCITY: "omega", ACCELERATION: "alpha"}
SLIDE = {VELOCITY: "v_r", ACCELERATION: "a_r"}
EXACT = 1e-9


@dataclass(frozen=True)
class Amount:
    """A number that is worked out: sign · factor · rate^power · length, or segment² / length, and what is added to it."""

    rate: str
    length: str | None = None
    power: int = 1
    sign: int = 1
    factor: str = ""
    segment: str | None = None
    style: int = 0
    more: tuple = ()

    def text(self):
        parts = [self.factor] if self.factor else []
        if self.segment:
            parts.append(f"{self.segment}^2/{self.length}")
        else:
            rate = self.rate if self.power == 1 else f"{self.rate}*{self.rate}" if self.style & 1 and self.power == 2 else \
                f"{self.rate}^{self.power}"
            parts += [self.length, rate] if self.style & 2 and self.length else [rate] + ([self.length] if self.length else [])
        text = ("-" if self.sign < 0 else "") + "*".join(parts)
        for amount in self.more:
            other = amount.text()
            text += f" - {other[1:]}" if other.startswith("-") else f" + {other}"
        return text

    def but(self, **changes):
        return replace(self, **changes)


@dataclass
class Op:
    entry: dict
    role: str
    info: dict = field(default_factory=dict)
    typed: bool = False

    @property
    def kind(self):
        return next(iter(self.entry))

    def but(self, entry, **info):
        return Op(entry, self.role, {**self.info, **info}, self.typed)


class Draft:
    def __init__(self, mechanism, rng):
        self.m, self.rng, self.ops, self.lines_of = mechanism, rng, [], {}
        self.names, self.still, self.numbers = set(), set(mechanism.ground), set(paper.given(mechanism))
        self.own_points, self.typing = rng.choice([0, 0, 0, 0.3]), rng.choice([0, 0, 0.3, 0.9])
        self.wrapping, self.style = rng.choice([0.1, 0.6]), rng.randrange(4)
        self.letters = rng.choice(["r", "g", "l", "Linie", "ray_", "hilfs"])
        self.rest, self.measured, self.sizes = {sheet: set() for sheet in PLANS}, {}, {}
        self.expected = {}
        # Auxiliary points that Kinegon's own construction may lack, so that their names mean nothing to it.
        self.loose = set()

    # ------------------------------------------------------------ names, chances

    def chance(self, p):
        return self.rng.random() < p

    def own(self, letters):
        number = 1
        while f"{letters}{number}" in self.names:
            number += 1
        self.names.add(f"{letters}{number}")
        return f"{letters}{number}"

    def add(self, role, entry, **info):
        self.ops.append(Op(entry, role, info))
        return self.ops[-1]

    def image(self, sheet, point):
        """The name of a point's image: of fixed ones the pole's or their own."""
        if point in self.rest[sheet] or point in self.still and self.chance(0.5):
            return POLE[sheet]
        return point.lower()

    def aux(self, sheet, name):
        """The name of an auxiliary point of a plan, or one's own."""
        return self.own(self.rng.choice(["u", "w", "k_", "N"])) if self.chance(self.own_points) else name

    def link_of(self, p, q):
        for name, points in self.m.links.items():
            if len(points) == 2 and tuple(points) == (p, q):
                return name
        return None

    def ref(self, p, q, sense=True):
        """A reference for the direction from p to q on the scheme; either way round where only a line is wanted."""
        ways = [f"{p},{q}"] + ([f"{q},{p}"] if not sense else [])
        ways += [name for a, b in ([(p, q)] if sense else [(p, q), (q, p)]) if (name := self.link_of(a, b))]
        if self.chance(0.12):
            if (p, q) not in self.lines_of:
                self.lines_of[p, q] = self.own(self.letters)
                self.add("auxiliary", {"join": self.lines_of[p, q], "on": "scheme", "points": [p, q]})
            ways = [self.lines_of[p, q]]
        return self.rng.choice(ways)

    def expect(self, sheet, image, link, place):
        self.expected[f"{sheet}:{image}"] = self.m.of_link(link, place, sheet == ACCELERATION)

    def size(self, amount, role, **info):
        """A number ready for the dividers: worked out at once, or before and with a name."""
        if self.chance(self.wrapping):
            name = self.own(self.rng.choice(["n", "amount", "v", "mm_"]))
            op = self.add(role, {"compute": name, "as": amount.text()}, amount=amount, **info)
            op.typed = self.chance(self.typing)
            return name, {}
        return amount.text(), {"amount": amount, **info}

    def length(self, p, q):
        """A length: the scene's, or measured on the scheme, with or without an entry that says so."""
        name = f"L({p},{q})" if self.chance(0.5) else f"L({q},{p})"
        pair = frozenset((p, q))
        if name not in self.numbers and pair not in self.measured:
            self.measured[pair] = None
            if self.chance(0.4):
                self.measured[pair] = name if self.chance(0.5) else self.own(f"{p}{q}_")
                self.add("measure", {"measure": self.measured[pair], "on": "scheme", "from": p, "to": q}, sheet="scheme")
        name = self.measured.get(pair) or name
        self.sizes[name] = abs(self.m.at[q] - self.m.at[p])
        return name

    def lay_off(self, role, sheet, name, start, amount, along, **info):
        text, info = self.size(amount, role, **info)
        entry = {"lay_off": name, "on": sheet, "from": start, "size": text, "along": along}
        op = self.add(role if info else f"{role}-laid", entry, **info, start=start, sheet=sheet)
        op.typed = bool(info) and self.chance(self.typing)
        return op

    def ray(self, role, sheet, through, along, **info):
        name = self.own(self.letters)
        self.add(role, {"line": name, "on": sheet, "through": through, "along": along}, sheet=sheet, start=through, **info)
        return name

    def cross(self, sheet, name, lines, role="cross"):
        lines = list(lines)
        self.rng.shuffle(lines)
        self.add(role, {"cross": name, "on": sheet, "of": lines}, sheet=sheet)

    def segment(self, sheet, p, q):
        """A measured segment: the quantity itself, or a number of one's own."""
        if self.chance(0.5):
            p, q = q, p
        quantity = f"{SEGMENT[sheet] if sheet in SEGMENT else 'L'}({p},{q})"
        way = self.rng.randrange(3)
        if way == 0 or quantity in self.numbers:
            return quantity
        name = quantity if way == 1 else self.own(f"{p}{q}s".replace("π", "o").replace("_", "").lower())
        self.numbers.add(quantity)
        self.add("measure", {"measure": name, "on": sheet, "from": p, "to": q}, sheet=sheet)
        return name

    # ------------------------------------------------------------ rates from segments

    def turns(self, sheet, found):
        """Rates from segments: each (link, start image, end image, joint, joint)."""
        rows = []
        for link, start, end, p, c in found:
            name = f"{TURN[sheet]}({link})"
            value = (self.m.omega if sheet == VELOCITY else self.m.alpha)[link]
            self.expected[name] = value
            rows.append((name, self.segment(sheet, start, end), self.length(p, c), 1 if value >= 0 else -1, link, (start, end)))
        if self.chance(0.2):
            return self.solved(sheet, [([(1, name, length)], sign, segment) for name, segment, length, sign, *_ in rows])
        for name, segment, length, sign, link, ends in rows:
            if self.chance(0.6):
                entry = {"compute": name, "as": f"{segment}/{length}", "sense": "ccw" if sign > 0 else "cw"}
            else:
                entry = {"compute": name, "as": f"{'-' if sign < 0 else ''}{segment}/{length}"}
            self.add("rate", entry, sheet=sheet, segment=segment, length=length, sign=sign, link=link, ends=ends).typed = self.chance(self.typing)
        return None

    def slides(self, sheet, name, start, end, value):
        """A sliding velocity or acceleration along a guide from its segment."""
        quantity = f"{SLIDE[sheet]}({name})"
        self.expected[quantity] = value
        segment, sign = self.segment(sheet, start, end), 1 if value >= 0 else -1
        entry = {"compute": quantity, "as": ("-" if sign < 0 else "") + segment}
        self.add("slide", entry, sheet=sheet, segment=segment, length=None, sign=sign, ends=(start, end)).typed = self.chance(self.typing)

    def solved(self, sheet, rows):
        """Linear equations: each row is terms (sign, rate, length or None), and the sign and the name of a segment."""
        names = list(dict.fromkeys(name for terms, *_ in rows for _, name, _ in terms))
        self.rng.shuffle(names)
        rows = list(rows)
        self.rng.shuffle(rows)
        rows = [([(s * turn, n, ll) for s, n, ll in terms], sign * turn, segment)
                for (terms, sign, segment), turn in zip(rows, [self.rng.choice((1, -1)) for _ in rows])]
        op = self.add("equations", {"solve": names, "equations": [equation(row) for row in rows]}, sheet=sheet, rows=rows)
        op.typed = self.chance(self.typing)

    # ------------------------------------------------------------ what is known

    def crank(self, link):
        a, b = self.m.links[link][:2]
        omega, alpha = self.m.omega[link], self.m.alpha[link]
        pole, own = self.rng.choice([POLE[VELOCITY], a.lower()]), b.lower()
        amount = Amount(f"omega({link})", self.length(a, b), style=self.style)
        along = {"normal": self.ref(a, b)}
        if omega < 0 and self.chance(0.5):
            amount, along = amount.but(rate=f"abs(omega({link}))"), {"normal": self.ref(b, a)}
        speed = None
        if self.chance(0.4) and "-" not in amount.text() and (omega > 0 or "abs" in amount.rate):
            speed = f"v({b})"
            op = self.add("crank-velocity", {"compute": speed, "as": amount.text()}, amount=amount, link=link)
            op.typed = self.chance(self.typing)
            self.add("crank-velocity-laid", {"lay_off": own, "on": VELOCITY, "from": pole, "size": speed, "along": along}, sheet=VELOCITY)
        else:
            self.lay_off("crank-velocity", VELOCITY, own, pole, amount, along, link=link)
        self.expect(VELOCITY, own, link, self.m.at[b])

        pole = self.rng.choice([POLE[ACCELERATION], a.lower()])
        normal = Amount(f"omega({link})", self.length(a, b), power=2, style=self.style)
        if self.chance(0.25):
            normal = normal.but(segment=speed or f"vplan({POLE[VELOCITY]},{own})")
        inward, across = {"parallel": self.ref(b, a)}, {"normal": self.ref(a, b)}
        tangential = Amount(f"alpha({link})", self.length(a, b), style=self.style)
        if alpha == 0:
            self.lay_off("crank-normal", ACCELERATION, own, pole, normal, inward, link=link)
        elif self.chance(0.5):
            half = self.own("n")
            self.lay_off("crank-normal", ACCELERATION, half, pole, normal, inward, link=link)
            self.lay_off("crank-tangential", ACCELERATION, own, half, tangential, across, link=link)
        else:
            half = self.own("t")
            self.lay_off("crank-tangential", ACCELERATION, half, pole, tangential, across, link=link)
            self.lay_off("crank-normal", ACCELERATION, own, half, normal, inward, link=link)
        self.expect(ACCELERATION, own, link, self.m.at[b])

    def known(self, point):
        """Lays off what the scene gives of a point, by size and angle or by its parts."""
        for sheet, moves, letter in ((VELOCITY, self.m.v, "v"), (ACCELERATION, self.m.a, "a")):
            value, own = moves[point], point.lower()
            if value == 0:
                self.rest[sheet].add(point)
                continue
            self.expected[f"{sheet}:{own}"] = value
            entry = self.m.known.get(point, self.m.motions.get(self.motion_at(point), {})).get(
                "acceleration" if sheet == ACCELERATION else "velocity")
            if isinstance(entry, list) and all(entry) and self.chance(0.5):
                half = self.own("h")
                self.add("known", {"lay_off": half, "on": sheet, "from": POLE[sheet], "size": f"{entry[0]}", "along": {"angle": 0}})
                self.add("known", {"lay_off": own, "on": sheet, "from": half, "size": f"{entry[1]}", "along": {"angle": 90}}, sheet=sheet)
                continue
            angle = entry["angle"] if isinstance(entry, dict) else math.degrees(math.atan2(value.imag, value.real))
            size = f"{letter}({point})" if self.chance(0.6) else repr(abs(value))
            self.add("known", {"lay_off": own, "on": sheet, "from": POLE[sheet], "size": size, "along": {"angle": angle}}, sheet=sheet)

    def motion_at(self, point):
        return next((name for name, motion in self.m.motions.items() if motion["at"] == point), None)

    # ------------------------------------------------------------ two points of a link

    def normal_part(self, p, c, link, start=None, name=None, towards=None, at=None):
        """Lays off ω² L towards p; the name of its end. `at` is the image of c in the velocity plan, if the way over v² / L may be taken."""
        start = start or self.image(ACCELERATION, p)
        name = self.aux(ACCELERATION, name or f"n_{p.lower()}{c}")
        amount = Amount(f"omega({link})", self.length(p, c), power=2, style=self.style)
        if at and self.chance(0.25):
            amount = amount.but(segment=f"vplan({self.image(VELOCITY, p)},{at})")
        self.lay_off("normal", ACCELERATION, name, start, amount, towards or {"parallel": self.ref(c, p)}, link=link, of=c, at=at)
        return name

    def across(self, p, c):
        return {"normal": self.ref(p, c, sense=False)}

    def side(self, sheet, p, c, link, at):
        """A ray on which c lies, of a link that hangs in p; where its tangential part begins."""
        start, plain = self.image(sheet, p), None
        if sheet == ACCELERATION:
            plain, start = start, self.normal_part(p, c, link, start=start, at=at)
        return start, self.ray("ray", sheet, start, self.across(p, c), plain=plain, link=link, part="normal")

    def relative(self, sheet, p, c, link):
        """The image of c from that of p by the link's rates: normal and tangential part, in either order."""
        own, start = c.lower(), self.image(sheet, p)
        amount = Amount(f"{TURN[sheet]}({link})", self.length(p, c), style=self.style)
        across = {"normal": self.ref(p, c)}
        if sheet == VELOCITY:
            self.lay_off("relative", sheet, own, start, amount, across, link=link)
        elif self.chance(0.6):
            half = self.normal_part(p, c, link, start=start, at=own)
            self.loose.add(half)
            self.lay_off("tangential", sheet, own, half, amount, across, link=link)
        else:
            half = self.own("t")
            self.lay_off("tangential", sheet, half, start, amount, across, link=link)
            normal = Amount(f"omega({link})", self.length(p, c), power=2, style=self.style)
            self.lay_off("normal", sheet, own, half, normal, {"parallel": self.ref(c, p)}, link=link, of=c, at=own)
        self.expect(sheet, own, link, self.m.at[c])

    def third(self, sheet, p, c, e, link, image_c=None):
        """The image of a third point of a link whose images of p and c are there: by similarity or by its rates."""
        ends = [self.image(sheet, p), image_c or self.image(sheet, c)]
        own, at = e.lower(), self.m.at
        ratio = (at[e] - at[p]) / (at[c] - at[p])
        flat = abs(ratio.imag) < 1e-6 * abs(ratio)
        self.expect(sheet, own, link, at[e])
        ways = ["like", "like", "rates", *(["part"] if flat else ["rays", "rays"])]
        way = self.rng.choice(ways)
        if way == "like":
            points = [p, c, e]
            if self.chance(0.5):
                points, ends = [c, p, e], ends[::-1]
            self.add("like", {"like": own, "on": sheet, "ends": ends, "points": points}, sheet=sheet, flat=flat)
        elif way == "rates":
            self.relative(sheet, p, e, link)
        elif way == "part":
            amount = Amount(f"{SEGMENT[sheet]}({ends[0]},{ends[1]})", f"L({p},{e})/L({p},{c})", sign=1 if ratio.real > 0 else -1)
            self.lay_off("part", sheet, own, ends[0], amount, {"parallel": ",".join(ends)}, link=link, points=(p, c, e), ends=ends)
        else:
            lines = []
            for (a, b), (x, y) in (((p, c), ends), ((c, p), ends[::-1])):
                if sheet == VELOCITY and self.chance(0.5):
                    lines.append(self.ray("image-ray", sheet, x, self.across(a, e), link=link, part=None, plain=None))
                else:
                    along = {"turned": [f"{a},{b}", f"{a},{e}"], "base": f"{x},{y}"}
                    lines.append(self.ray("turned-image-ray", sheet, x, along, link=link, part=None, plain=None))
            self.cross(sheet, own, lines)

    # ------------------------------------------------------------ groups of two links

    def two_links(self, sheet, p, q, c, link_p, link_q):
        own = c.lower()
        sides = [self.side(sheet, joint, c, link, own) for joint, link in ((p, link_p), (q, link_q))]
        self.cross(sheet, own, [line for _, line in sides])
        self.expect(sheet, own, link_p, self.m.at[c])
        self.turns(sheet, [(link, start, own, joint, c) for (start, _), joint, link in zip(sides, (p, q), (link_p, link_q))])

    def guided(self, sheet, p, c, link, slider):
        """c on a link that hangs in p and on a slider on the ground."""
        own, pole = c.lower(), POLE[sheet]
        start, one = self.side(sheet, p, c, link, own)
        two = self.ray("guide-ray", sheet, pole, {"parallel": slider}, plain=None, part=None, slider=slider)
        self.cross(sheet, own, [one, two])
        self.expect(sheet, own, link, self.m.at[c])
        self.turns(sheet, [(link, start, own, p, c)])
        self.slides(sheet, slider, pole, own, (self.m.v_r if sheet == VELOCITY else self.m.a_r)[slider])

    def slot(self, sheet, q, b, lever, slider, block=None):
        """The lever's point under the pin b that slides in it; the lever hangs in q."""
        own, pin, under = f"{b.lower()}_{lever}", self.image(sheet, b), f"{b}_{lever}"
        turn_start, slide_start, plain, k = self.image(sheet, q), pin, None, None
        if sheet == ACCELERATION:
            plain = turn_start
            turn_start = self.normal_part(q, b, lever, start=turn_start, name=f"n_{q.lower()}{under}", at=own)
            k = slide_start = self.coriolis(f"k_{b.lower()}{lever}", pin, lever, slider, -1, b, (own, self.image(VELOCITY, b)))
        one = self.ray("ray", sheet, turn_start, self.across(q, b), plain=plain, link=lever, part="normal")
        two = self.ray("guide-ray", sheet, slide_start, {"parallel": slider}, plain=pin if k else None, part="coriolis", slider=slider)
        self.cross(sheet, own, [one, two])
        self.expect(sheet, own, lever, self.m.at[b])
        self.turns(sheet, [(lever, turn_start, own, q, b)])
        self.slides(sheet, slider, slide_start, own, (self.m.v_r if sheet == VELOCITY else self.m.a_r)[slider])
        if block and self.chance(0.5):
            self.same_rate(sheet, block, lever)

    def same_rate(self, sheet, block, lever):
        name = f"{TURN[sheet]}({block})"
        self.expected[name] = (self.m.omega if sheet == VELOCITY else self.m.alpha)[block]
        self.add("same", {"compute": name, "as": f"{TURN[sheet]}({lever})"}, sheet=sheet)

    def coriolis(self, name, start, link, slider, sign, pin, along=None):
        """Lays off ±2 ω v_r across a guide; the name of its end. `along` are the ends of v_r in the velocity plan."""
        name = self.aux(ACCELERATION, name)
        amount = Amount(f"omega({link})", f"v_r({slider})", sign=sign, factor="2", style=self.style & 2)
        if along and self.chance(0.25):
            amount = amount.but(length=f"vplan({along[0]},{along[1]})", sign=sign if self.m.v_r[slider] >= 0 else -sign)
        self.lay_off("coriolis", ACCELERATION, name, start, amount, {"normal": slider}, link=link, slider=slider, pin=pin)
        return name


def equation(row):
    """A row of `solved` as text."""
    terms, sign, segment = row
    text = ""
    for s, name, length in terms:
        term = f"{name}*{length}" if length else name
        text += ("-" if s < 0 else "") + term if not text else f" {'-' if s < 0 else '+'} {term}"
    return f"{text} = {'-' if sign < 0 else ''}{segment}"
