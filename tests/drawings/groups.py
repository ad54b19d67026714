"""Groups that two rays do not open, and mechanisms with a driven cylinder. See `plans.py`."""

from dataclasses import dataclass

from plans import ACCELERATION, SLIDE, TURN, Amount, Draft
from truth import dot


@dataclass
class Side:
    """One of the two rays of a special point: from the known joint `a` over the joint `c` of the link that hangs in it; or, where a
    slider stands for `c`, along its guide."""

    a: str
    c: str | None
    link: str
    point: str
    floating: str
    slider: str | None = None


class Special(Draft):
    """Special points of groups of four links and their equations."""

    def special_points(self, sides):
        """Sides in pairs; the special points are put into the mechanism's places for the lengths that are measured to them."""
        lines = {}
        for one, two in zip(sides[::2], sides[1::2]):
            crossing = []
            for side in (one, two):
                key = (side.a, side.c)
                if key not in lines or self.chance(0.5):
                    lines[key] = self.cut_line(side)
                crossing.append(lines[key])
            self.cross("scheme", one.point, crossing, role="cross-special")
            (p, u), (q, w) = (self.cut(side) for side in (one, two))
            self.m.at[one.point] = p + u * (dot(w * 1j, q - p) / dot(w * 1j, u))

    def cut(self, side):
        p = self.m.at[side.a]
        return p, self.m.guides[side.slider] * 1j if side.slider else self.m.at[side.c] - p

    def cut_line(self, side):
        name = self.own(self.letters)
        if side.slider:
            self.add("cut-guide", {"line": name, "on": "scheme", "through": side.a, "along": {"normal": side.slider}}, sheet="scheme",
                     start=side.a)
        elif self.chance(0.6):
            points = self.rng.sample([side.a, side.c], 2)
            self.add("cut", {"join": name, "on": "scheme", "points": points}, sheet="scheme", side=side)
        else:
            entry = {"line": name, "on": "scheme", "through": self.rng.choice([side.a, side.c]),
                     "along": {"parallel": self.ref(side.a, side.c, sense=False)}}
            self.add("cut", entry, sheet="scheme", side=side)
        return name

    def reach(self, side):
        """The length from the side's joint to its special point, and whether it leads on or back."""
        at = self.m.at
        if side.slider:
            u = self.m.guides[side.slider]
            return self.length(side.a, side.point), 1 if dot(u, 1j * (at[side.point] - at[side.a])) >= 0 else -1
        onwards = dot(at[side.c] - at[side.a], at[side.point] - at[side.c]) >= 0
        return self.length(side.c, side.point), 1 if onwards else -1

    def normals(self, side):
        """Lays off the known parts of the acceleration of a special point; where they end."""
        start = self.image(ACCELERATION, side.a)
        length, on = self.reach(side)
        name = f"n_{side.a.lower()}{side.point[1:]}"
        if side.slider:
            k = self.coriolis(f"k_{side.a.lower()}{side.floating}", start, side.link, side.slider, 1, side.a)
            amount = Amount(f"omega({side.link})", length, power=2, style=self.style)
            towards = {"parallel": f"{side.point},{side.a}"}
            name = self.aux(ACCELERATION, name)
            self.lay_off("normal", ACCELERATION, name, k, amount, towards, link=side.link, of=side.point, at=None)
            return name, start
        name = self.aux(ACCELERATION, name)
        towards = {"parallel": self.ref(side.c, side.a)}
        one = Amount(f"omega({side.link})", self.length(side.a, side.c), power=2, style=self.style)
        two = Amount(f"omega({side.floating})", length, power=2, sign=on, style=self.style)
        if self.chance(0.3):
            half = self.own("h")
            self.lay_off("normal", ACCELERATION, half, start, one, towards, link=side.link, of=side.c, at=None)
            self.lay_off("normal", ACCELERATION, name, half, two, towards, link=side.floating, of=side.point, at=None)
        else:
            self.lay_off("normal", ACCELERATION, name, start, one.but(more=(two,)), towards, link=side.link, of=side.c, at=None)
        return name, start

    def special(self, sheet, sides, same=None):
        """Rays, images of the special points, equations. `same`: (block, carrier) that turn together."""
        second, rows = sheet == ACCELERATION, []
        called = {same[0]: same[1]} if same else {}
        for one, two in zip(sides[::2], sides[1::2]):
            own, starts, lines = one.point.lower(), [], []
            for side in (one, two):
                start, plain = self.normals(side) if second else (self.image(sheet, side.a), None)
                starts.append(start)
                along = {"parallel": side.slider} if side.slider else self.across(side.a, side.c)
                role = "guide-ray" if side.slider else "ray"
                lines.append(self.ray(role, sheet, start, along, plain=plain, link=side.link, part="normal", slider=side.slider))
            self.cross(sheet, own, lines)
            self.expect_special(sheet, own, one)
            for side, start in zip((one, two), starts):
                rows.append(self.row(sheet, side, start, own, called))
        for name in {n for terms, *_ in rows for _, n, _ in terms}:
            self.expected[name] = self.true_rate(name)
        self.solved(sheet, rows)
        if same:
            self.same_rate(sheet, *same)

    def true_rate(self, name):
        head, inner = name[:-1].split("(")
        return getattr(self.m, head)[inner]

    def expect_special(self, sheet, own, side):
        self.expect(sheet, own, side.floating, self.m.at[side.point])

    def row(self, sheet, side, start, own, called):
        """The equation of a measured segment: ω L, and what the floating link or the slider adds."""
        head = TURN[sheet]
        length, on = self.reach(side)
        if side.slider:
            terms = [(on, f"{head}({side.link})", length), (1, f"{SLIDE[sheet]}({side.slider})", None)]
        else:
            floating = called.get(side.floating, side.floating)
            terms = [(1, f"{head}({side.link})", self.length(side.a, side.c)), (on, f"{head}({floating})", length)]
        value = sum(s * self.true_rate(name) * (self.sizes[ll] if ll else 1) for s, name, ll in terms)
        return terms, 1 if value >= 0 else -1, self.segment(sheet, start, own)


class Cylinder(Special):
    """A cylinder `link` that hangs in a, with a rod that is pinned in c of a link that hangs in o; the piston d is driven."""

    def cylinder(self, sheet, a, c, o, barrel, rod, arm, slider):
        second, own = sheet == ACCELERATION, c.lower()
        start = plain = self.image(sheet, a)
        first = self.aux(sheet, f"r_{a.lower()}{rod}")
        self.lay_off("drive", sheet, first, start, Amount(f"{SLIDE[sheet]}({slider})"), {"parallel": slider}, slider=slider)
        start = first
        if second:
            start = self.coriolis(f"k_{a.lower()}{rod}", start, barrel, slider, 1, a)
            start = self.normal_part(a, c, barrel, start=start, at=None)
        one = self.ray("ray", sheet, start, self.across(a, c), plain=None if second else plain, link=barrel, part="drive")
        arm_start, two = self.side(sheet, o, c, arm, own)
        self.cross(sheet, own, [one, two])
        self.expect(sheet, own, arm, self.m.at[c])
        self.turns(sheet, [(barrel, start, own, a, c), (arm, arm_start, own, o, c)])
        self.same_rate(sheet, rod, barrel)
