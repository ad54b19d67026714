#!/usr/bin/env python3
"""A hand on the drawing board that finds forces: moments with arms that it constructs on the scheme, polygons in an order of its own, and one wrong operation on purpose.

    python3 force_boards.py KINEGON [--scenes N] [--honest N] [--each N] [--mistake NAME] [--faults FOLDER] [--limits]

Mechanisms and their truth are those of forces.py: three equations of equilibrium for each link. A drawing with a mistake counts where the wrong operation leads plainly elsewhere. *first*: the
first operation that is called wrong is the one that was put in (of an arm also the sum in which it stands; of a force that is missing where the polygon is closed); *named*: its mistake is told
besides. Honest drawings, exact and by pencil, must have no operation called wrong."""
import json
import math
import random
import re
import sys
import tempfile
from collections import Counter
from pathlib import Path

from forces import KINDS, Stuck, add, angle, cross, dot, drawable, left, scaled, size, unit
from survey import arguments, check, keep

MISTAKES = {
    # In a sum with nothing else it is the same which of both is reversed: the size of a tangential part has no sign.
    "inertia-along-a": {"inertia-along-a"}, "inertia-couple-along-alpha": {"inertia-couple-along-alpha", "percussion-on-wrong-side", "inertia-along-a"},
    "couple-forgotten": {"couple-forgotten"}, "arm-to-point": {"arm-to-point"}, "arm-in-paper-mm": {"arm-in-paper-mm"},
    "a-of-joint-for-centre": {"a-of-joint-for-centre"}, "mass-for-weight": {"mass-for-weight"}, "factor-of-thousand": {"mass-for-weight"},
    "reaction-not-reversed": {"reaction-not-reversed"}, "negative-tangential-kept": {"negative-tangential-kept"},
    "normal-across": {"normal-across"}, "guide-reaction-along-rod": {"guide-reaction-along-rod"}, "force-missing-in-polygon": {"force-missing-in-polygon"},
    "twice": {"twice"}, "moment-about-wrong-point": {"moment-about-wrong-point"}, "torque-sense": {"torque-sense"},
}
MM, K = 0.3, 0.001


class Force:
    """A force on a link: its vector, where it acts on the scheme, and how an entry writes its size and its direction."""

    def __init__(self, name, vector, at, place, text, value, along, kind):
        self.name, self.vector, self.at, self.place = name, vector, at, place
        self.text, self.value, self.along, self.kind = text, value, along, kind


class Paper:
    """What the hand has on its sheets and in its head, with its own errors: only so are its readings its own."""

    def __init__(self, m, mu_l):
        self.m = m
        self.places = {"scheme": dict(m.points), "forces": {f"o{n}": (0.0, 0.0) for n in range(1, 20)}}
        self.numbers, self.lines, self.directions = {"mu_l": mu_l}, {}, {}
        for link, (forces, couples) in m.loads().items():
            for symbol, at, force in forces:
                name = f"weight({link})" if symbol == f"W{link}" else f"inertia({link})" if symbol == f"Fi{link}" else symbol
                self.numbers[f"load({name})"], self.directions[f"load({name})"] = size(force), unit(force)
                self.places["scheme"].setdefault(symbol if name == symbol else f"G{link}", at)
            for symbol, value in couples:
                self.numbers[f"M_i({link})"] = value
        for link, at, along in m.guides:
            self.directions[f"{link}/ground"] = unit(along)

    def reference(self, sheet, name):
        if name in self.lines:
            return self.lines[name][1]
        if name in self.directions:
            return self.directions[name]
        ends = name.split(",") if "," in name else self.m.links[name]
        on = next(s for s in ("scheme", sheet, "forces") if all(end in self.places[s] for end in ends))
        return unit(add(self.places[on][ends[1]], self.places[on][ends[0]], -1))

    def direction(self, sheet, along):
        if "angle" in along:
            return math.cos(math.radians(along["angle"])), math.sin(math.radians(along["angle"]))
        return self.reference(sheet, along["parallel"]) if "parallel" in along else left(self.reference(sheet, along["normal"]))

    def value(self, text):
        def number(found):
            name = found.group(0)
            if name.startswith("L("):
                a, b = name[2:-1].split(",")
                return repr(size(add(self.m.points[a], self.m.points[b], -1)))
            return repr(self.numbers[name])
        return eval(re.sub(r"[A-Za-z_][A-Za-z_0-9]*(?:\((?:[^()]|\([^()]*\))*\))?", number, text).replace("--", "- -"))

    def carry_out(self, entry):
        if "line" in entry:
            self.lines[entry["line"]] = (self.places[entry["on"]][entry["through"]], self.direction(entry["on"], entry["along"]), entry["on"])
        elif "join" in entry:
            a, b = (self.places[entry["on"]][p] for p in entry["points"])
            self.lines[entry["join"]] = (a, unit(add(b, a, -1)), entry["on"])
        elif "cross" in entry:
            (p, u, on), (q, v, _) = (self.lines[line] for line in entry["of"])
            if abs(cross(u, v)) < 1e-6:
                raise Stuck
            self.places[on][entry["cross"]] = add(p, u, cross(add(q, p, -1), v) / cross(u, v))
        elif "lay_off" in entry:
            at = self.places[entry["on"]][entry["from"]]
            self.places[entry["on"]][entry["lay_off"]] = add(at, self.direction(entry["on"], entry["along"]), self.value(entry["size"]))
        elif "measure" in entry:
            a, b = (self.places[entry["on"]][entry[end]] for end in ("from", "to"))
            self.numbers[entry["measure"]] = entry.get("read", size(add(a, b, -1)))
        elif "compute" in entry:
            self.numbers[entry["compute"]] = self.value(entry["as"])
        elif "solve" in entry:
            left_, right = entry["equations"][0].split(" = ")
            self.numbers[entry["solve"][0]] = self.value(right) / self.value(left_.rsplit(" * ", 1)[0])


class Board:
    def __init__(self, m, mu_l, mu_f, lot, route, by_pencil, mistake=None):
        self.m, self.mu_l, self.mu_f, self.lot, self.route, self.by_pencil, self.mistake = m, mu_l, mu_f, lot, route, by_pencil, mistake
        self.did, self.wrong, self.names, self.sums, self.polygons = [], None, Counter(), 0, 0
        self.reactions, self.guides, self.torque = m.truth()
        self.loads = m.loads()
        self.known = {link: [self.load(link, *own) for own in self.loads[link][0]] for link in m.links}
        self.couples = {link: [(self.couple(link, name), value, name) for name, value in self.loads[link][1]] for link in m.links}
        self.lines, self.paper = {}, Paper(m, mu_l)
        for group in reversed(m.groups):
            {"RRR": self.rrr, "RRP": self.rrp, "III": self.third, "IV": self.fourth}[group[0]](*group[1:])
        self.crank()

    # Entries

    def add(self, **entry):
        self.did.append({key.rstrip("_"): value for key, value in entry.items()})
        self.paper.carry_out(self.did[-1])
        return len(self.did) - 1

    def own(self, letter):
        self.names[letter] += 1
        return f"{letter}{self.names[letter]}"

    def err(self, what, weight=0.5):
        """Whether the mistake is made here."""
        return self.mistake == what and self.wrong is None and self.lot.random() < weight

    def spoil(self, *indices):
        self.wrong = set(indices)

    def load(self, link, symbol, at, force):
        name = {"W": f"load(weight({link}))", "F": f"load(inertia({link}))"}.get(symbol[0] if symbol[1:] == link or symbol[:2] == "Fi" else "", f"load({symbol})")
        place = next((p for p, xy in self.m.points.items() if size(add(xy, at, -1)) < 1e-9), None)
        place = place or (f"G{link}" if symbol[0] in "WF" and name != f"load({symbol})" else symbol)
        typed = self.lot.random() < (0.4 if self.by_pencil else 0.1)
        text = f"{size(force):.5g}" if typed else name
        along = {"angle": round(angle(force), 3)} if typed and self.lot.random() < 0.5 else {"parallel": name}
        return Force(symbol, force, at, place, text, size(force), along, name)

    def couple(self, link, name):
        return f"M_i({link})" if name.startswith("Mi") else None

    # Moments

    def line_of(self, force):
        key = (force.name, force.place)
        if key not in self.lines:
            self.lines[key] = self.own("r")
            self.add(line=self.lines[key], on="scheme", through=force.place, along=force.along)
        return self.lines[key]

    def moment(self, forces, couples, about, at):
        """The sum of the moments of what is known, as a formula and its value; with the entries whose numbers may be blamed."""
        self.sums += 1
        terms, total, blamed = [], 0.0, []
        elsewhere = None
        if self.err("moment-about-wrong-point", 0.6):
            others = [p for p, xy in self.m.points.items() if size(add(xy, at, -1)) > 25]
            elsewhere = self.lot.choice(others) if others else None
        center, spot = (elsewhere, self.m.points[elsewhere]) if elsewhere else (about, at)
        right, paper = 0.0, self.err("arm-in-paper-mm", 0.6) and self.mu_l != 1
        for force in forces:
            along = unit(force.vector)
            right += cross(add(force.at, at, -1), force.vector)
            mm = cross(add(force.at, spot, -1), along)
            far = size(add(force.at, spot, -1))
            if abs(mm) < 1e-6:
                continue
            line, normal, foot, arm = self.line_of(force), self.own("n"), self.own("f"), self.own("m")
            self.add(line=normal, on="scheme", through=center, along={"normal": line})
            self.add(cross=foot, of=[line, normal])
            length = abs(mm)
            if far > abs(mm) + 0.06 * far + 4 and abs(mm) > 4 and force.place != center and self.err("arm-to-point", 0.6):
                blamed.append(self.add(measure=arm, on="scheme", from_=center, to=force.place))
                length = far
            else:
                self.measure(arm, "scheme", center, foot, length, self.mu_l)
            sense = math.copysign(1, mm) * math.copysign(1, force.value)
            terms.append((sense, f"{force.text} * {arm}" + (" / mu_l" if paper else "")))
            total += math.copysign(1, mm) * size(force.vector) * length / (self.mu_l if paper else 1)
        for text, value, name in couples:
            right += value
            if self.err("couple-forgotten", 0.6):
                blamed.append(None)
                continue
            sign = 1
            if name.startswith("Mi") and self.err("inertia-couple-along-alpha", 0.7):
                sign = -1
                blamed.append(None)
            if text:
                terms.append((sign, text))
            else:
                terms.append((sign * math.copysign(1, value), f"{abs(value):g}"))
            total += sign * value
        if elsewhere:
            blamed.append(None)
        if paper:
            blamed.append(None)
        if blamed:
            # What does not move the sum plainly is no mistake.
            if abs(total - right) < 0.06 * abs(right):
                raise Stuck
            self.spoil(*[index for index in blamed if index is not None])
        if elsewhere:
            self.elsewhere = elsewhere
        return terms, right, bool(blamed)

    elsewhere = None

    def measure(self, name, sheet, a, b, length, mu):
        entry = dict(measure=name, on=sheet, from_=a, to=b)
        if self.by_pencil:
            places = self.paper.places[sheet]
            entry["read"] = round(size(add(places[b], places[a], -1)) + self.lot.uniform(-MM, MM) * mu, 3)
        return self.add(**entry)

    def written(self, terms, sign=1):
        text = ""
        for own, term in terms:
            text += (" + " if own * sign > 0 else " - ") + term if text else ("" if own * sign > 0 else "-") + term
        return text or "0"

    def by_moments(self, name, forces, couples, about, at, joint, along, arm_text=None, arm_value=None):
        """A force along a line through a joint by moments: its value along `along`."""
        terms, right, blamed = self.moment(forces, couples, about, at)
        if not terms and not blamed:
            return None
        arm = cross(add(self.m.points[joint], at, -1), along)
        value = -right / arm
        if self.elsewhere:
            # The hand takes the unknown's arm about its wrong point, too.
            wrong = self.m.points[self.elsewhere]
            arm = cross(add(self.m.points[joint], wrong, -1), along)
            if abs(arm) < 10:
                raise Stuck
            arm_text, center, self.elsewhere = None, self.elsewhere, None
        else:
            center = about
        if arm_text is None:
            line, normal, foot, arm_text = self.own("r"), self.own("n"), self.own("f"), self.own("m")
            self.add(line=line, on="scheme", through=joint, along=self.along_text)
            self.add(line=normal, on="scheme", through=center, along={"normal": line})
            self.add(cross=foot, of=[line, normal])
            self.measure(arm_text, "scheme", center, foot, abs(arm), self.mu_l)
        negative = self.lot.random() < 0.5 and value < 0
        # With a positive number the hand draws against the direction.
        sign = -math.copysign(1, arm) * (-1 if negative else 1)
        formula = f"({self.written(terms, sign)}) / {arm_text}"
        if self.lot.random() < 0.25 and not blamed:
            sum_ = self.written(terms, sign)
            index = self.add(solve=[name], equations=[f"{arm_text} * {name} = {sum_}"])
        else:
            index = self.add(compute=name, as_=formula)
        if blamed:
            self.spoil(index, *self.wrong)
        return value, (-value if negative else value), negative

    # Polygons

    def start(self):
        self.polygons += 1
        return f"o{self.polygons}"

    def wrong_force(self, force, name):
        """A changed entry for a force, where a mistake with it is made."""
        is_inertia, is_weight = "inertia" in str(force.kind), "weight" in str(force.kind)
        if is_inertia and self.err("inertia-along-a"):
            return dict(size=f"-{force.text}", along=force.along)
        if is_weight and self.err("mass-for-weight", 0.8):
            return dict(size=f"{force.value / 9.81:.5g}", along=force.along)
        if (is_weight or is_inertia) and self.err("factor-of-thousand", 0.8):
            return dict(size=f"1000 * {force.text}", along=force.along)
        if is_inertia and self.err("a-of-joint-for-centre", 0.8):
            link = name_of(force.kind)
            joints = [p for p in self.m.links[link] if size(add(self.m.points[p], force.at, -1)) > 5]
            mass = self.m.masses[link][0]
            for joint in joints:
                wrong = scaled(self.m.acceleration(link, self.m.points[joint]), -K * mass)
                if size(wrong) > 1 and size(add(wrong, force.vector, -1)) > 0.15 * size(force.vector):
                    return dict(size=f"{size(wrong):.5g}", along={"angle": round(angle(wrong), 2)})
        if force.kind == "reaction" and self.others and self.err("reaction-not-reversed", 0.8):
            return dict(size=f"-({force.text})", along=force.along)
        if force.kind == "tangential" and self.others and self.err("negative-tangential-kept", 0.8):
            return dict(size=f"-({force.text})", along=force.along)
        return None

    def chain(self, start, forces, may_go_back=True):
        """Lays forces off; the corners, from the start on."""
        self.others = len(forces) > 1
        left_out = None
        if self.err("force-missing-in-polygon", 0.7):
            fit = [i for i, f in enumerate(forces) if size(f.vector) > 6 * self.mu_f]
            left_out = self.lot.choice(fit) if fit and len(forces) > 1 else None
        twice = None
        if self.err("twice", 0.7):
            fit = [i for i, f in enumerate(forces) if size(f.vector) > 4 * self.mu_f]
            twice = self.lot.choice(fit) if fit else None
        corners = [start]
        back = may_go_back and self.mistake is None and self.route == 2 and self.lot.random() < 0.4
        order = list(reversed(list(enumerate(forces)))) if back else list(enumerate(forces))
        for index, force in order:
            if index == left_out:
                corners.append(corners[-1])
                continue
            changed = self.wrong_force(force, force.name)
            for _ in range(2 if index == twice else 1):
                name = self.own("h")
                text, along = f"-({force.text})" if back else force.text, force.along
                made = self.add(lay_off=name, on="forces", from_=corners[-1] if _ == 0 else last, size=text, along=along)
                if changed:
                    self.did[made].update(changed)
                    self.paper.carry_out(self.did[made])
                    self.spoil(made)
                last = name
            if index == twice:
                self.spoil(made)
            corners.append(name)
        self.lacks = left_out is not None
        self.back = back
        return corners

    lacks = back = False

    def direction(self, name, through, along, across_along=None, mistake=None):
        wrong = mistake and self.err(mistake, 0.6)
        index = self.add(line=name, on="forces", through=through, along=across_along if wrong else along)
        if wrong:
            self.spoil(index)

    def close(self, corners, last, first):
        """Lines through the end and through the start; the corner where they cross. Each: how it is written, and how it is written across, with its mistake."""
        one, two, corner = self.own("r"), self.own("r"), self.own("h")
        ends = [(one, corners[-1], last), (two, corners[0], first)]
        if self.back:
            ends = [(one, corners[-1], first), (two, corners[0], last)]
        for name, through, (along, across_, mistake) in (ends if self.lot.random() < 0.5 else ends[::-1]):
            self.direction(name, through, along, across_, mistake)
        index = self.add(cross=corner, of=[one, two] if self.lot.random() < 0.5 else [two, one])
        if self.lacks:
            self.spoil(index)
        return corner

    def link_line(self, a, b, link=None):
        ends = [a, b] if self.lot.random() < 0.5 else [b, a]
        name = link if link and len(self.m.links[link]) == 2 and self.lot.random() < 0.4 else ",".join(ends)
        return ({"parallel": name}, {"normal": name}, "normal-across")

    def across(self, joint, to, link, name):
        """The part across the line of two joints: moments of a link about the other one."""
        forces, couples = list(self.known[link]), self.couples[link]
        if not forces and not couples:
            return None
        if self.route:
            self.lot.shuffle(forces)
        a, b = self.m.points[joint], self.m.points[to]
        along = left(unit(add(b, a, -1)))
        self.along_text = {"normal": f"{joint},{to}"}
        found = self.by_moments(name, forces, couples, to, b, joint, along, f"L({joint},{to})", size(add(b, a, -1)))
        if found is None:
            return None
        value, number, negative = found
        direction = {"normal": f"{to},{joint}"} if negative else {"normal": f"{joint},{to}"}
        if abs(value) < 1e-9:
            return None
        return Force(name, scaled(along, value), a, joint, name, number, direction, "tangential")

    def of(self, force):
        return [force] if force else []

    def whole(self, pin, link, parts, corners):
        """What a pin does to a link: measured between two corners, or from its parts."""
        name = f"R({pin},{link})"
        vector = self.reactions[pin, link]
        if corners and corners[0] != corners[1]:
            self.measure(name, "forces", *corners, size(vector), self.mu_f)
            return Force(name, vector, self.m.points[pin], pin, name, size(vector), {"parallel": ",".join(corners)}, "reaction")
        return None

    def hand_on(self, pin, link, whole, parts):
        """Reversed, what a pin does to a link is what it does to the other."""
        for other, points in self.m.links.items():
            if pin not in points or other == link:
                continue
            if whole:
                ends = whole.along["parallel"].split(",")
                if self.lot.random() < 0.5:
                    text, value, along = f"-{whole.text}", -whole.value, whole.along
                else:
                    text, value, along = whole.text, whole.value, {"parallel": ",".join(reversed(ends))}
                self.known[other].append(Force(f"R({pin},{other})", scaled(whole.vector, -1), whole.at, pin, text, value, along, "reaction"))
            else:
                for part in parts:
                    if part:
                        self.known[other].append(Force(part.name + other, scaled(part.vector, -1), part.at, pin, f"-{part.text}", -part.value, part.along, "part"))

    def normal_part(self, name, pin, to, link, vector, ends):
        """The part along a link, measured: its vector is what is left of the reaction."""
        a, b = self.m.points[pin], self.m.points[to]
        u = unit(add(b, a, -1))
        value = dot(vector, u)
        if abs(value) < 4 * self.mu_f:
            raise Stuck
        self.measure(name, "forces", *ends, abs(value), self.mu_f)
        along = {"parallel": f"{pin},{to}" if value > 0 else f"{to},{pin}"}
        return Force(name, scaled(u, value), a, pin, name, abs(value), along, "normal")

    def shuffled(self, forces):
        forces = list(forces)
        if self.route:
            self.lot.shuffle(forces)
        return forces

    def rrr(self, p, a, c, b, q):
        first, last = self.across(p, c, a, f"R_t({p},{a})"), self.across(q, c, b, f"R_t({q},{b})")
        rp, rq = self.reactions[p, a], self.reactions[q, b]
        start = self.start()
        if self.route < 2:
            forces = self.of(first) + self.shuffled(self.known[a]) + self.shuffled(self.known[b]) + self.of(last)
        else:
            forces = self.shuffled(self.of(first) + self.known[a] + self.known[b] + self.of(last))
        corners = self.chain(start, forces)
        corner = self.close(corners, self.link_line(q, c, b), self.link_line(p, c, a))
        ends_q, ends_p = ([corners[-1], corner], [corner, corners[0]]) if not self.back else ([corners[0], corner], [corner, corners[-1]])
        np, nq = self.normal_part(f"R_n({p},{a})", p, c, a, rp, ends_p), self.normal_part(f"R_n({q},{b})", q, c, b, rq, ends_q)
        wp = wq = None
        if self.route < 2:
            wp = self.whole(p, a, None, [corner, corners[1] if first else corners[0]])
            wq = self.whole(q, b, None, [corners[-2] if last else corners[-1], corner])
            middle = corners[(1 if first else 0) + len(self.known[a])]
            if not self.lacks:
                self.measure(f"R({c},{a})", "forces", middle, corner, size(self.reactions[c, a]), self.mu_f)
        self.hand_on(p, a, wp, [first, np])
        self.hand_on(q, b, wq, [last, nq])

    def guide_line(self, b):
        name = f"{b}/ground"
        return ({"normal": name}, {"parallel": name}, "guide-reaction-along-rod")

    def rrp(self, p, a, c, b, guide):
        first = self.across(p, c, a, f"R_t({p},{a})")
        start, rp = self.start(), self.reactions[p, a]
        if self.route < 2:
            forces = self.of(first) + self.shuffled(self.known[a]) + self.shuffled(self.known[b])
        else:
            forces = self.shuffled(self.of(first) + self.known[a] + self.known[b])
        corners = self.chain(start, forces)
        corner = self.close(corners, self.guide_line(b), self.link_line(p, c, a))
        ends_n, ends_p = ([corners[-1], corner], [corner, corners[0]]) if not self.back else ([corners[0], corner], [corner, corners[-1]])
        normal, couple = self.guides[b]
        if abs(normal) < 4 * self.mu_f:
            raise Stuck
        self.measure(f"N({b}/ground)", "forces", *ends_n, abs(normal), self.mu_f)
        np = self.normal_part(f"R_n({p},{a})", p, c, a, rp, ends_p)
        whole = self.whole(p, a, None, [corner, corners[1] if first else corners[0]]) if self.route < 2 else None
        far = [f for f in self.known[b] if size(add(f.at, self.m.points[c], -1)) > 1e-9]
        if abs(couple) > 1:
            terms, right, blamed = self.moment(far, self.couples[b], c, self.m.points[c])
            if self.elsewhere:
                raise Stuck
            index = self.add(compute=f"M({b}/ground)", as_=self.written(terms, -1))
            if blamed:
                self.spoil(index, *self.wrong)
            self.add(compute=f"h({b}/ground)", as_=f"{'-' if normal < 0 else ''}M({b}/ground) / N({b}/ground)")
        self.hand_on(p, a, whole, [first, np])

    def crossing(self, legs):
        """Where the lines of two legs cross, drawn on the scheme; its name and place."""
        names = []
        for outer, inner in legs:
            names.append(self.own("r"))
            if self.lot.random() < 0.5:
                self.add(join=names[-1], on="scheme", points=[outer, inner])
            else:
                self.add(line=names[-1], on="scheme", through=outer, along={"parallel": f"{outer},{inner}"})
        (p, u), (q, v) = [(self.m.points[o], unit(add(self.m.points[i], self.m.points[o], -1))) for o, i in legs]
        sine = cross(u, v)
        if abs(sine) < 0.25:
            raise Stuck
        at = add(p, u, cross(add(q, p, -1), v) / sine)
        if size(at) > 500:
            raise Stuck
        name = self.own("k")
        self.add(cross=name, of=names)
        return name, at

    def along_line(self, name, forces, couples, legs, joint, to):
        spot, at = self.crossing(legs)
        u = unit(add(self.m.points[to], self.m.points[joint], -1))
        self.along_text = {"parallel": f"{joint},{to}"}
        if abs(cross(add(self.m.points[joint], at, -1), u)) < 15:
            raise Stuck
        found = self.by_moments(name, forces, couples, spot, at, joint, u)
        if found is None:
            return None
        value, number, negative = found
        along = {"parallel": f"{to},{joint}" if negative else f"{joint},{to}"}
        return Force(name, scaled(u, value), self.m.points[joint], joint, name, number, along, "normal")

    def third(self, central, legs):
        parts = {outer: self.across(outer, inner, link, f"R_t({outer},{link})") for outer, link, inner in legs}
        order = list(range(3))
        self.lot.shuffle(order)
        i, j, k = order
        outer, link, inner = legs[k]
        links = [central] + [leg[1] for leg in legs]
        forces = [f for own in links for f in self.known[own]] + [p for p in parts.values() if p]
        couples = [c for own in links for c in self.couples[own]]
        rest = self.along_line(f"R_n({outer},{link})", self.shuffled(forces), couples, [(legs[n][0], legs[n][2]) for n in (i, j)], outer, inner)
        (oi, li, ii), (oj, lj, ij) = legs[i], legs[j]
        inside = self.known[li] + self.known[central] + self.known[link] + self.of(parts[outer]) + self.of(rest) + self.known[lj]
        start = self.start()
        corners = self.chain(start, self.of(parts[oi]) + self.shuffled(inside) + self.of(parts[oj]))
        corner = self.close(corners, self.link_line(oj, ij, lj), self.link_line(oi, ii, li))
        ends_j, ends_i = ([corners[-1], corner], [corner, corners[0]]) if not self.back else ([corners[0], corner], [corner, corners[-1]])
        ni = self.normal_part(f"R_n({oi},{li})", oi, ii, li, self.reactions[oi, li], ends_i)
        nj = self.normal_part(f"R_n({oj},{lj})", oj, ij, lj, self.reactions[oj, lj], ends_j)
        for o, l, n in ((oi, li, ni), (oj, lj, nj), (outer, link, rest)):
            self.hand_on(o, l, None, [parts[o], n])

    def fourth(self, b, drag, closures, other, e):
        links = [drag, other] + [c[1] for c in closures]
        forces = [f for link in links for f in self.known[link]]
        couples = [c for link in links for c in self.couples[link]]
        a, z = self.m.points[b], self.m.points[e]
        self.along_text = {"normal": f"{b},{e}"}
        found = self.by_moments(f"R_t({b},{drag})", self.shuffled(forces), couples, e, z, b, left(unit(add(z, a, -1))), f"L({b},{e})")
        whole = None
        if found:
            value, number, negative = found
            along = {"normal": f"{e},{b}" if negative else f"{b},{e}"}
            whole = Force(f"R_t({b},{drag})", scaled(left(unit(add(z, a, -1))), value), a, b, f"R_t({b},{drag})", number, along, "tangential")
        parts = {}
        for c, link, d in closures:
            part = self.across(c, d, link, f"R_t({c},{link})")
            # On the drag link it is reversed.
            parts[c] = part and Force(part.name, scaled(part.vector, -1), part.at, part.place, f"-{part.text}", -part.value, part.along, "part")
        far = {b: e, **{c[0]: c[2] for c in closures}}
        names = [b] + [c[0] for c in closures]
        self.lot.shuffle(names)
        x, y, z_ = names
        own = {b: whole, **parts}
        link_of = lambda n: drag if n == b else next(c[1] for c in closures if c[0] == n)
        given = list(self.known[drag]) + [p for p in own.values() if p]
        rest = self.along_line(f"R_n({z_},{link_of(z_)})", self.shuffled(given), self.couples[drag], [(x, far[x]), (y, far[y])], z_, far[z_])
        if rest is None:
            raise Stuck
        if z_ != b:
            # The sum was taken of the drag link, so the size is that on it; the name's sense does not matter to a length.
            pass
        start = self.start()
        corners = self.chain(start, self.of(own[x]) + self.shuffled(self.known[drag] + self.of(own[z_]) + [rest]) + self.of(own[y]))
        corner = self.close(corners, self.link_line(y, far[y]), self.link_line(x, far[x]))
        ends_y, ends_x = ([corners[-1], corner], [corner, corners[0]]) if not self.back else ([corners[0], corner], [corner, corners[-1]])
        found = {}
        for n, ends in ((x, ends_x), (y, ends_y)):
            found[n] = self.normal_part(f"R_n({n},{link_of(n)})", n, far[n], drag, self.reactions[n, drag], ends)
        found[z_] = rest
        self.hand_on_of(b, drag, [whole, found[b]])
        on_other = []
        for c, link, d in closures:
            start = self.start()
            inside = [Force(f.name + link, scaled(f.vector, -1), f.at, f.place, f"-({f.text})", -f.value, f.along, "part") for f in self.of(parts[c]) + [found[c]]]
            corners = self.chain(start, self.shuffled(inside + self.known[link]), False)
            if corners[-1] == corners[0]:
                raise Stuck
            index = self.measure(f"R({d},{link})", "forces", corners[-1], corners[0], size(self.reactions[d, link]), self.mu_f)
            if self.lacks:
                self.spoil(index)
            if size(self.reactions[d, link]) < 4 * self.mu_f:
                raise Stuck
            on_other.append((d, link, [corners[-1], corners[0]]))
        start = self.start()
        inside = [Force(f"R({d},{other})", self.reactions[d, other], self.m.points[d], d, f"R({d},{link})", size(self.reactions[d, other]), {"parallel": f"{ends[1]},{ends[0]}"}, "reaction")
                  for d, link, ends in on_other]
        corners = self.chain(start, self.shuffled(inside + self.known[other]), False)
        if corners[-1] != corners[0]:
            index = self.measure(f"R({e},{other})", "forces", corners[-1], corners[0], size(self.reactions[e, other]), self.mu_f)
            if self.lacks:
                self.spoil(index)

    def hand_on_of(self, pin, link, parts):
        self.hand_on(pin, link, None, parts)

    def crank(self):
        known = self.known["1"]
        a = self.m.points["A"]
        forces = [f for f in known if size(add(f.at, a, -1)) > 1e-9]
        terms, right, blamed = self.moment(forces, self.couples["1"], "A", a)
        self.elsewhere = None
        sign = -1
        wrong = self.err("torque-sense", 1)
        index = self.add(compute="T(1)", as_=self.written(terms, -sign if wrong else sign))
        if wrong:
            self.spoil(index)
        if blamed:
            self.spoil(index, *self.wrong)
        if known:
            corners = self.chain(self.start(), self.shuffled(known), False)
            if corners[-1] != corners[0]:
                index = self.measure("R(A,1)", "forces", corners[-1], corners[0], size(self.reactions["A", "1"]), self.mu_f)
                if self.lacks:
                    self.spoil(index)


def name_of(kind):
    return kind.rsplit("(", 1)[1].rstrip(")")


def run(options):
    lot = random.Random(options.seed)
    wanted = options.mistake or list(MISTAKES)
    honest, found, told = Counter(), {m: Counter() for m in MISTAKES}, {m: Counter() for m in MISTAKES}
    for index in range(options.scenes):
        kind = KINDS[index % len(KINDS)]
        with tempfile.TemporaryDirectory() as work:
            work = Path(work)
            m, mu_l, mu_f, *_ = drawable(kind, lot, options.kinegon, work, False)
            planned = [(None, n % 2) for n in range(-(-options.honest // options.scenes))]
            planned += [(mistake, int(lot.random() < 0.3)) for mistake in wanted for _ in range(max(1, -(-options.each // options.scenes)) * 2)]
            for number, (mistake, by_pencil) in enumerate(planned):
                board = None
                for _ in range(20):
                    try:
                        route = lot.randrange(3)
                        board = Board(m, mu_l, mu_f, lot, route, by_pencil, mistake)
                    except (Stuck, ZeroDivisionError, IndexError):
                        board = None
                        continue
                    if mistake is None or board.wrong:
                        break
                    board = None
                if board is None:
                    continue
                drawing = {"kinegon_drawing": 1, "mu_l": mu_l, "mu_f": mu_f, "did": board.did}
                path = work / f"{number}.json"
                path.write_text(json.dumps(drawing))
                result, refused = check(options.kinegon, work / "scene.json", path)
                fault = f"{mistake or 'honest'}-{kind.__name__}-{index}-{number}"
                if result is None:
                    honest["refused" if mistake is None else "refused wrong"] += 1
                    keep(options, work / "scene.json", f"refused-{fault}", drawing=path.read_text(), said=json.dumps(refused))
                    continue
                result = result["drawing"]
                first = result.get("first_wrong")
                entry = result["entries"][first] if first is not None else None
                if mistake is None:
                    honest["right" if first is None else "accused by pencil" if by_pencil else "accused exact"] += 1
                    if first is not None:
                        keep(options, work / "scene.json", fault, drawing=path.read_text(), said=json.dumps(dict(route=board.route, **entry)))
                    continue
                own = entry.get("mistake") if entry else None
                outcome = "silent" if first is None else "first" if first in board.wrong else "elsewhere"
                found[mistake][outcome] += 1
                told[mistake][f"{outcome}: {own or '-'}"] += 1
                if outcome == "first" and own in MISTAKES[mistake]:
                    found[mistake]["named"] += 1
                else:
                    keep(options, work / "scene.json", fault, drawing=path.read_text(), said=json.dumps(dict(route=board.route, wrong=sorted(board.wrong), told=entry)))
    print("honest:", sum(honest.values()), dict(honest))
    all_first, all_named, everything = 0, 0, 0
    for mistake in wanted:
        own = found[mistake]
        count = own["first"] + own["elsewhere"] + own["silent"]
        all_first, all_named, everything = all_first + own["first"], all_named + own["named"], everything + count
        if count:
            print(f"{mistake:28} {count:5} first {100 * own['first'] / count:5.1f} %, named {100 * own['named'] / count:5.1f} %  {dict(told[mistake].most_common(5))}")
    accused = sum(count for what, count in honest.items() if what not in ("right", "refused wrong"))
    print(f"all {everything}: first {100 * all_first / max(everything, 1):.1f} %, named {100 * all_named / max(everything, 1):.1f} %; honest accused or refused {accused} of {sum(honest.values())}")
    return 1 if options.limits and (all_first < 0.9 * everything or all_named < 0.85 * everything or accused) else 0


if __name__ == "__main__":
    sys.exit(run(arguments(__doc__, honest=360)))
