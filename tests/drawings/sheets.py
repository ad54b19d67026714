"""Drawings to be judged: honest ones, and such with one or two planted mistakes, of which the entry and the kind are known."""

import random
from collections import Counter
from dataclasses import dataclass, field, replace

import mistakes_computed
import mistakes_drawn
import paper
import ways
from mistakes import KINDS, plant
from paper import Refused
from truth import Impossible, dot

MODULES = (mistakes_computed, mistakes_drawn)
# What moves no value by more than this share of the largest of its kind is no mistake in this scene.
MOVES = 1e-6


@dataclass
class Sheet:
    """A drawing and what is planted in it.

    planted  the entry and the kind of each mistake, in the order of the entries
    also     entries that may be called the first wrong one as well
    moved    how far a value is moved, as a share of the largest of its kind
    alone    how far each mistake is off when all before it is right, and what a hand may be off there
    alike    names that the first one has besides"""

    case: object
    seed: str
    hand: object
    drawing: dict
    planted: list = field(default_factory=list)
    also: set = field(default_factory=set)
    moved: float = 0.0
    alone: list = field(default_factory=list)
    alike: set = field(default_factory=set)


class Counts(Counter):
    """How many mistakes were put in and not counted, and why."""


def scale_of(case, ops):
    """The exercise's scales, else some by which the plans fit a sheet."""
    own, figure = ways.scales(case.mechanism, ops), case.scene.get("figure", {})
    return {sheet: figure.get(f"mu_{sheet[0] if sheet != 'scheme' else 'l'}", own[sheet]) for sheet in own}


def right_alone(case, scale, right, new, wrong, free):
    """By how much a wrong operation is off when everything before it is right, and what a hand of 3 × (0.3 mm, 0.3°) may be off there: both in
    mm, or as shares where it gives numbers."""
    sheets = ways.carry_out(case.mechanism, right, scale)
    have = set(sheets.lines) | set(sheets.numbers) | {f"{s}:{n}" for s, points in sheets.points.items() for n in points}
    for op in new[:new.index(wrong)]:
        if not set(paper.makes(op.entry)) <= have:
            sheets.do(op.entry)
    entry, name, kind = wrong.entry, wrong.entry[wrong.kind], wrong.kind
    if "askew" in wrong.info or "off_mm" in wrong.info:
        return None
    if "reading" in wrong.info:
        mu = sheets.scales[entry["on"]]
        true = sheets.point(entry["on"], entry["to"]) - sheets.point(entry["on"], entry["from"])
        return abs(wrong.info.get("slip", lambda v: v)(abs(wrong.info["reading"](true))) - abs(true)) / mu, 0.9
    if "slip" in wrong.info:
        value = sheets.value(entry.get("as") or entry["size"])
        change, used = abs(wrong.info["slip"](value) - value), laid_on(wrong, new)
        if used:
            return change / sheets.scales[used], 0.9 + 0.03 * abs(value) / sheets.scales[used]
        return change / abs(value) if value else 0.0, 0.03
    if kind in ("line", "join"):
        sheets.lines.pop(name, None)
        sheets.do(entry)
        sheet, place, way = sheets.lines[name]
        target = next((op.entry["cross"] for op in new if op.kind == "cross" and name in op.entry["of"]), None)
        if target is None:
            return None
        to = (sheets.points[sheet][target] - place) / sheets.scales[sheet]
        return abs(dot(way * 1j, to)), 3 * (0.3 + 0.0052 * abs(to))
    if kind in ("cross", "lay_off", "like"):
        sheet = entry["on"]
        before = sheets.points[sheet].pop(name, None)
        if before is None:
            return None
        sheets.do(entry)
        start = sheets.point(sheet, entry.get("from", name))
        reach = max(abs(sheets.points[sheet][name] - start), abs(before - start)) / sheets.scales[sheet]
        return abs(sheets.points[sheet][name] - before) / sheets.scales[sheet], 3 * (0.3 + 0.0052 * reach)
    before = dict(sheets.numbers)
    sheets.do(entry)
    changes = [(abs(x - before[n]), abs(before[n])) for n, x in sheets.numbers.items() if n in before]
    if kind == "measure":
        mu = sheets.scales[entry["on"]]
        return max(c for c, _ in changes) / mu, 0.9
    if used := laid_on(wrong, new):
        change, size = max(changes)
        return change / sheets.scales[used], 0.9 + 0.03 * size / sheets.scales[used]
    # A rate comes from a segment, of which 0.9 mm may be off.
    mm = abs(sheets.number(wrong.info["segment"])) / sheets.scales[wrong.info["sheet"]] if wrong.info.get("segment") else 20
    return max((c / size if size else c) for c, size in changes), 0.03 + (0.9 / max(mm, 0.9) if free else 0)


def alike(case, scale, right, new, wrong):
    """Names that the same line has as well: the normal to a lever through the pin on it is both, drawn from the wrong point and, as the
    other ray, turned."""
    if wrong.kind != "line" or "askew" in wrong.info:
        return set()
    sheets = ways.carry_out(case.mechanism, right, scale)
    before = sheets.lines.pop(wrong.entry["line"], None)
    cross = next((op for op in right if op.kind == "cross" and wrong.entry["line"] in op.entry["of"]), None)
    if not cross or not before:
        return set()
    sheets.do(wrong.entry)
    _, place, way = sheets.lines[wrong.entry["line"]]
    other = next(name for name in cross.entry["of"] if name != wrong.entry["line"])
    _, there, along = sheets.lines[other]
    same = abs(dot(way, along)) < 1e-6 and abs(dot(way * 1j, there - place)) < 1e-6 * scale[cross.entry["on"]]
    return {"turned-ray", "ray-from-wrong-point"} if same else set()


def laid_on(op, ops):
    """The sheet on which a number is laid off."""
    if "size" in op.entry:
        return op.entry["on"]
    return next((other.entry["on"] for other in ops if other.entry.get("size") == op.entry[op.kind]), None)


def planted(case, ops, own, scale, hand, rng, count, only, tally):
    """Operations with so many mistakes: (operations, [(operation, kind)], how far they move a value, how far each is off alone)."""
    right = ways.values(ways.carry_out(case.mechanism, ops, scale), own)
    new, wrongs, alones, also_named = ops, [], [], set()
    for _ in range(60):
        by_kind = {}
        for i, op in enumerate(new):
            for kind in KINDS.values():
                if op.role in kind.roles and (not only or kind.name in only) and all(op is not w for w, _ in wrongs):
                    by_kind.setdefault(kind.name, []).append(i)
        if not by_kind:
            break
        kind = KINDS[rng.choice(sorted(by_kind))]
        i = rng.choice(by_kind[kind.name])
        try:
            before = ways.carry_out(case.mechanism, new[:i], scale)
            made = plant(new, i, kind, before, own, rng, hand.snap)
            if made is None:
                continue
            changed, at = made
            if not all(any(op is w for op in changed) for w, _ in wrongs):
                continue
            wrong = changed[at]
            after = ways.values(ways.Drawing(case.mechanism, scale, ways.EXACT, random.Random(0)).all(changed), own)
            names = alike(case, scale, ops, changed, wrong) if not wrongs else set()
            alone = right_alone(case, scale, ops, changed, wrong, hand.snap != "all")
        except (Refused, Impossible, ZeroDivisionError, OverflowError, ValueError, KeyError):
            tally["cannot be drawn on"] += 1
            continue
        moved = ways.largest_move(right, after)
        tally["put in"] += 1
        if moved < MOVES or alone and alone[0] < 1e-6 * max(alone[0], 1):
            tally["moves no value"] += 1
            continue
        free = hand.snap != "all" or hand.reads or any(op.typed for op in ops)
        if alone and alone[0] < (1.3 * alone[1] if free else 0):
            tally["within what the hand may be off"] += 1
            continue
        also_named |= names
        new, wrongs, alones = changed, wrongs + [(wrong, kind)], alones + [alone]
        if len(wrongs) == count:
            return new, wrongs, moved, alones, also_named
    return None


def sheet(case, seed, mistakes=0, only=(), tally=None, hand=None, symbolic=False):
    """One drawing of a scene; None where no mistake could be put in. `symbolic`: no number is typed."""
    rng = random.Random(f"{case.name} {seed} {mistakes}")
    tally = Counts() if tally is None else tally
    d = case.draft(rng)
    ops = ways.ordered(d.ops, rng)
    scale, hand = scale_of(case, ops), hand or ways.hand_of(rng)
    if symbolic:
        hand = replace(hand, inserts=0.0)
        for op in ops:
            op.typed = False
    new, wrongs, moved, alones, named = ops, [], 0.0, [], set()
    if mistakes:
        # A crossing that is marked alone would hide what is wrong with its lines.
        hand = replace(hand, marks=0.0)
        made = planted(case, ops, d.names, scale, hand, rng, mistakes, only, tally)
        if made is None:
            return None
        new, wrongs, moved, alones, named = made

    def wrong_of(i):
        kind = KINDS[rng.choice(sorted(KINDS))]
        try:
            made = plant(new, i, kind, drawn_so_far[0], d.names, rng, hand.snap)
        except (Refused, ZeroDivisionError, OverflowError):
            return None
        return made[0][made[1]] if made and len(made[0]) == len(new) else None

    drawn_so_far = [ways.carry_out(case.mechanism, [], scale)]
    try:
        drawn = ways.perform(case.mechanism, new, scale, hand, rng, d.own, wrong_of, extras=rng.choice([0, 0, 0.08]),
                             detours=rng.choice([0, 0, 0.06]), watch=drawn_so_far)
    except (Refused, Impossible, ZeroDivisionError, OverflowError):
        tally["cannot be drawn on"] += 1
        return None
    drawing = ways.head(drawn, case.name if case.group == "exercise" else "")
    drawing["did"] = ways.spelt(drawing["did"], rng)
    if rng.random() < 0.3:
        for key in ("mu_l", "mu_v", "mu_a"):
            if case.scene.get("figure", {}).get(key) == drawing[key]:
                del drawing[key]
    if rng.random() < 0.3:
        drawing["did"] = [{**e, "t": 1500 * i} for i, e in enumerate(drawing["did"])]
    places = sorted(((drawn.index[id(op)], kind) for op, kind in wrongs), key=lambda pair: pair[0])
    return Sheet(case, str(seed), hand, drawing, places, also_first(new, drawn.index, places, d.names | d.loose), moved, alones, named)


def also_first(ops, index, places, own):
    """Entries that may as well be called the first wrong one: what has a name of one's own has no right value but by the entry that
    uses it, so that may be blamed; and so on where that gives something of one's own again."""
    out, op = set(), next((op for op in ops if places and index[id(op)] == places[0][0]), None)
    while op and op.kind not in ("line", "join", "solve") and op.entry[op.kind] in own:
        made = set(paper.makes(op.entry))
        users = [other for other in ops if other is not op and made & set(paper.needs(other.entry))]
        op = min(users, key=lambda other: index[id(other)], default=None)
        if op:
            out.add(index[id(op)])
    # A part that was forgotten may as well be missing in the point of one's own before it.
    if places and places[0][1].name in ("normal-forgotten", "coriolis-forgotten"):
        wrong = next(op for op in ops if index[id(op)] == places[0][0])
        start = f"{wrong.entry['on']}:{wrong.entry.get('through') or wrong.entry.get('from')}"
        out |= {index[id(op)] for op in ops if op.kind == "lay_off" and op.entry["lay_off"] in own and start in paper.makes(op.entry)}
    return out
