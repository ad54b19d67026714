#!/usr/bin/env python3
"""A hand on the drawing board that finds instant centres: by lines of its own choice, exactly or as a pencil does, and with one wrong operation on purpose.

    python3 center_boards.py KINEGON [--scenes N] [--honest N] [--each N] [--mistake NAME] [--faults FOLDER] [--limits]

Mechanisms are those of centers.py; each centre is found over two third links by lot. A drawing with a mistake counts where the wrong line misses its centre, or the wrong
number its value, plainly. *first*: the first operation that is called wrong is the one that was put in; *named*: its mistake is told besides. Honest drawings, exact and by
pencil, must have no operation called wrong. What a student may have meant by a line is not asked: each mistake is put into one operation."""
import itertools
import json
import math
import random
import sys
import tempfile
from collections import Counter
from pathlib import Path

from centers import (KINDS, Stuck, cross, distance, exact_centres, is_far, lines_for, order, pair, place, point, sine)
from survey import arguments, check, keep

MISTAKES = {
    "wrong-third-link": "lines-without-common-link", "line-of-another-centre": "lines-without-common-link", "centre-along-guide": "centre-along-guide",
    "centre-at-slider": "centre-at-slider", "ratio-inverted": "ratio-inverted", "sense-by-centre": "sense-by-centre",
    "distance-from-wrong-centre": "distance-from-wrong-centre", "measured-elsewhere": "distance-from-wrong-centre",
}
MM = 0.3


def named(two, lot):
    """A centre by its links, as a hand writes it."""
    a, b = two if lot.random() < 0.7 else two[::-1]
    frame = lambda link: link if link != "0" else ("ground" if lot.random() < 0.7 else "0")
    return f"P({frame(a)},{frame(b)})"


def own_ways(mechanism, exact, wanted, lot):
    """An order of the centres that are wanted, each over two third links by lot."""
    links, known, ways, found = list(mechanism.links), dict(exact), {}, []

    def finite(at):
        return not is_far(at) and math.hypot(*place(at)) < 1500

    for _ in range(40):
        missing = [t for t in itertools.combinations(sorted(links), 2) if t not in known]
        lot.shuffle(missing)
        # What is wanted comes first, and nothing more than that where it can be had.
        missing.sort(key=lambda t: t not in wanted)
        for target in missing:
            pairs = [(a, b) for a, b in itertools.combinations(lines_for(known, links, target), 2) if sine(a[1], b[1]) > 0.3]
            pairs = [two for two in pairs if finite(cross(two[0][1], two[1][1]))]
            if pairs:
                one, two = lot.choice(pairs)
                known[target], ways[target] = cross(one[1], two[1]), (one[0], two[0])
                found.append(target)
                break
        if all(t in known for t in wanted):
            needed = []

            def need(t):
                if t in exact or t in needed:
                    return
                for k in ways[t]:
                    need(pair(t[0], k))
                    need(pair(t[1], k))
                needed.append(t)

            for t in wanted:
                need(t)
            return [(t, ways[t]) for t in needed], {t: at for t, at in known.items() if t in exact or t in needed}
    raise Stuck


class Board:
    """A drawing, entry by entry; `wrong` is the index of the entry that was made wrong."""

    def __init__(self, mechanism, mu, ways, known, lot, by_pencil, mistake=None):
        self.mechanism, self.mu, self.ways, self.known, self.lot, self.by_pencil, self.mistake = mechanism, mu, ways, known, lot, by_pencil, mistake
        self.did, self.lines, self.wrong, self.segments = [], 0, None, []
        # Where the hand has what it marks, and its lines.
        self.marked, self.drawn_lines = dict(known), {}
        for target, _ in ways:
            del self.marked[target]
        self.pins = {two: what for two, (kind, what) in mechanism.permanent().items() if kind == "pin"}
        self.guides = {two: what for two, (kind, what) in mechanism.permanent().items() if kind == "guide"}
        self.origin = mechanism.points[next(iter(mechanism.points))]
        self.turn = lot.randrange(len(ways))
        for number, (target, over) in enumerate(ways):
            self.find(target, over, number >= self.turn)
        self.rates()

    def add(self, **entry):
        self.did.append({key.rstrip("_"): value for key, value in entry.items()})
        return len(self.did) - 1

    def point(self, two):
        """The name of a finite centre: of one in a pin also the pin's."""
        if two in self.pins and self.lot.random() < 0.5:
            return self.pins[two]
        return named(two, self.lot)

    def off(self, at, mm=MM):
        return at if not self.by_pencil else at + self.lot.uniform(-mm, mm)

    def slider(self, index):
        link, at, on, _ = self.mechanism.guides[index]
        return f"{link}/{'ground' if on == '0' else on}"

    def line(self, target, k, may_err):
        ends = [pair(i, k) for i in target]
        far = [two for two in ends if is_far(self.known[two])]
        near = [two for two in ends if two not in far]
        self.lines += 1
        name = f"r{self.lines}"
        err = may_err and self.wrong is None
        if len(far) == 1 and far[0] in self.guides:
            guide = self.guides[far[0]]
            how = "normal"
            if err and self.mistake == "centre-along-guide":
                self.wrong, how = len(self.did), "parallel"
            pin = self.mechanism.guides[guide][1]
            if err and self.mistake == "centre-at-slider" and distance(self.mechanism.points[pin], place(self.known[near[0]])) > 6:
                self.wrong = len(self.did)
                self.add(join=name, on="centers", points=[self.point(near[0]), pin])
            else:
                self.add(line=name, on="centers", through=self.point(near[0]), along={how: self.slider(guide)})
        elif len(far) == 1:
            # By the parallel lines that lead there.
            raise Stuck
        elif len(far) == 2:
            raise Stuck
        else:
            points = ends
            if err and self.mistake == "wrong-third-link":
                others = [two for two in self.drawn() if two not in ends and self.misses(target, [ends[0], two])]
                if others:
                    self.wrong, points = len(self.did), [ends[0], self.lot.choice(others)]
            if points is ends and distance(*(place(self.known[two]) for two in ends)) < 6:
                raise Stuck
            self.add(join=name, on="centers", points=[self.point(two) for two in points])
        self.drawn_lines[name] = cross(*(self.marked.get(two, self.known[two]) for two in ends))
        self.segments.append((name, target))
        return name

    def drawn(self):
        """The finite centres that are there."""
        found = [target for target, _ in self.ways[:self.done]]
        return [two for two in [*self.pins, *found] if not is_far(self.known[two])]

    def misses(self, target, two):
        """Whether the line through two centres is plainly beside a third one."""
        a, b = (place(self.known[t]) for t in two)
        length = distance(a, b)
        x, y = place(self.known[target])
        return length > 10 and abs((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / length > 5 * self.mu

    done = 0

    def find(self, target, over, may_err):
        lines = [self.line(target, k, may_err) for k in over]
        if may_err and self.wrong is None and self.mistake == "line-of-another-centre":
            others = [name for name, other in self.segments[:-2] if other != target]
            if others:
                self.wrong = len(self.did)
                lines = [lines[0], self.lot.choice(others)]
        entry = dict(cross=named(target, self.lot), of=lines)
        if self.by_pencil and self.mistake is None:
            x, y = ((own - start) / self.mu for own, start in zip(place(cross(*(self.drawn_lines[line] for line in lines))), self.origin))
            x, y = entry["drawn"] = [round(self.off(x), 2), round(self.off(y), 2)]
            self.marked[target] = point((x * self.mu + self.origin[0], y * self.mu + self.origin[1]))
        self.add(**entry)
        self.done += 1

    def rates(self):
        """Angular velocities by distances, and the velocity of the point."""
        m, lot = self.mechanism, self.lot
        holders = [link for link, own in m.links.items() if m.velocity in own and link != "0"]
        pinned = [link for link in holders if any(p in m.links["0"] and p != m.velocity for p in m.links[link])]
        link = (pinned or holders)[0]
        if link == "1":
            return
        needs = [pair(*two) for two in (("1", link), ("0", link), ("0", "1"))]
        if any(two not in self.known for two in needs):
            return
        common, own, first = (self.known[two] for two in needs)
        if any(is_far(at) for at in (common, own, first)):
            return
        names = [f"L({named(('0', '1'), lot)},{named(pair('1', link), lot)})", f"L({named(('0', link), lot)},{named(pair('1', link), lot)})"]
        driven, mine = distance(place(first), place(common)), distance(place(own), place(common))
        if min(driven, mine) < 10 * self.mu:
            return
        sense = 1 if (place(common)[0] - place(own)[0]) * (place(common)[0] - place(first)[0]) + (place(common)[1] - place(own)[1]) * (place(common)[1] - place(first)[1]) > 0 else -1
        measured = lot.random() < 0.5 or self.by_pencil or self.mistake == "measured-elsewhere"
        ends = [[("0", "1"), pair("1", link)], [("0", link), pair("1", link)]]
        if measured:
            for index, (two, length) in enumerate(zip(ends, (driven, mine))):
                between = two
                if self.mistake == "measured-elsewhere" and self.wrong is None and (index == 1 or lot.random() < 0.5):
                    others = [t for t in self.drawn() if abs(distance(place(self.known[t]), place(common)) - length) > 0.08 * length and distance(place(self.known[t]), place(common)) > 10 * self.mu]
                    if others:
                        self.wrong, between = len(self.did), [lot.choice(others), two[1]]
                entry = dict(measure=names[index], from_=self.point(between[0]), to=self.point(between[1]), on="centers")
                if self.by_pencil and self.mistake is None:
                    has = [place(self.marked.get(t, self.known[t])) for t in between]
                    entry["read"] = round(self.off(distance(*has) / self.mu, 0.4) * self.mu, 2)
                self.add(**entry)
        over, under = names
        if self.mistake == "ratio-inverted" and self.wrong is None and abs(driven / mine - 1) > 0.08:
            self.wrong, (over, under) = len(self.did), (under, over)
        if self.mistake == "distance-from-wrong-centre" and self.wrong is None:
            others = [t for t in self.drawn() if t not in (("0", "1"),) and abs(distance(place(self.known[t]), place(common)) / driven - 1) > 0.08 and distance(place(self.known[t]), place(common)) > 10]
            if others:
                self.wrong = len(self.did)
                over = f"L({named(lot.choice(others), lot)},{named(pair('1', link), lot)})"
        if self.mistake == "sense-by-centre" and self.wrong is None:
            self.wrong, sense = len(self.did), -sense
        formula = f"omega(1)*{over}/{under}"
        formula = lot.choice([formula, f"omega(1)/{under}*{over}"])
        turns = sense * math.copysign(1, m.omega)
        if lot.random() < 0.5:
            self.add(compute=f"omega({link})", as_=formula, sense="ccw" if turns > 0 else "cw")
        else:
            self.add(compute=f"omega({link})", as_=formula if sense > 0 else f"-{formula}")
        end = m.points[m.velocity]
        if distance(place(own), end) > 10:
            self.add(compute=f"v({m.velocity})", as_=f"omega({link})*L({named(('0', link), lot)},{m.velocity})")


def scene_of(kind, lot):
    for _ in range(2000):
        mechanism, wanted = kind(lot)
        mu = lot.choice([1, 2])
        exact = exact_centres(mechanism)
        everything = list(itertools.combinations(sorted(mechanism.links), 2))
        targets = [t for t in everything if t not in exact] if wanted == "all" else [pair(*t) for t in wanted]
        try:
            order(mechanism, exact, targets)
            own_ways(mechanism, exact, targets, lot)
        except Stuck:
            continue
        return mechanism, wanted, mu, exact, targets
    raise SystemExit(f"no {kind.__name__}")


def run(options):
    lot = random.Random(options.seed)
    wanted_mistakes = options.mistake or list(MISTAKES)
    honest, found, told = Counter(), {m: Counter() for m in MISTAKES}, {m: Counter() for m in MISTAKES}
    kinds = Counter()
    for index in range(options.scenes):
        kind = KINDS[index % len(KINDS)]
        mechanism, wanted, mu, exact, targets = scene_of(kind, lot)
        with tempfile.TemporaryDirectory() as work:
            work = Path(work)
            (work / "scene.json").write_text(json.dumps(mechanism.scene(mu, wanted)))
            planned = [(None, n % 2) for n in range(-(-options.honest // options.scenes))]
            planned += [(m, 0) for m in wanted_mistakes for _ in range(-(-options.each // options.scenes) * 2)]
            for number, (mistake, by_pencil) in enumerate(planned):
                board = None
                for _ in range(20):
                    try:
                        ways, known = own_ways(mechanism, exact, targets, lot)
                        board = Board(mechanism, mu, ways, known, lot, by_pencil, mistake)
                    except (Stuck, KeyError, ZeroDivisionError):
                        board = None
                        continue
                    if mistake is None or board.wrong is not None:
                        break
                    board = None
                if board is None:
                    continue
                drawing = {"kinegon_drawing": 1, "mu_c": mu, "did": board.did}
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
                if mistake is None:
                    kinds[kind.__name__] += 1
                    honest["right" if first is None else "accused by pencil" if by_pencil else "accused exact"] += 1
                    if first is not None:
                        keep(options, work / "scene.json", fault, drawing=path.read_text(), said=json.dumps(result["entries"][first]))
                    continue
                if first is None:
                    outcome = "silent"
                elif first != board.wrong:
                    outcome = "elsewhere"
                else:
                    outcome = "first"
                    own = result["entries"][first].get("mistake")
                    told[mistake][own or "-"] += 1
                    if own == MISTAKES[mistake]:
                        found[mistake]["named"] += 1
                found[mistake][outcome] += 1
                if outcome != "first" or own != MISTAKES[mistake]:
                    said = dict(wrong=board.wrong, told=result["entries"][first] if first is not None else None)
                    keep(options, work / "scene.json", fault, drawing=path.read_text(), said=json.dumps(said))
    print("honest:", sum(honest.values()), dict(honest), dict(kinds))
    all_first, all_named, everything = 0, 0, 0
    for mistake in wanted_mistakes:
        own = found[mistake]
        count = own["first"] + own["elsewhere"] + own["silent"]
        all_first, all_named, everything = all_first + own["first"], all_named + own["named"], everything + count
        if count:
            print(f"{mistake:28} {count:5} first {100 * own['first'] / count:5.1f} %, named {100 * own['named'] / count:5.1f} %  {dict(own)}  {dict(told[mistake].most_common(4))}")
    accused = sum(count for what, count in honest.items() if what not in ("right", "refused wrong"))
    print(f"all {everything}: first {100 * all_first / max(everything, 1):.1f} %, named {100 * all_named / max(everything, 1):.1f} %; honest accused or refused {accused} of {sum(honest.values())}")
    return 1 if options.limits and (all_first < 0.9 * everything or all_named < 0.9 * everything or accused) else 0


if __name__ == "__main__":
    sys.exit(run(arguments(__doc__, honest=360)))
