#!/usr/bin/env python3
"""Holds every stated error and every printed digit of `kinegon solve` to the truth, found apart with 70 digits.

    python3 tests/numbers/judge.py target/release/kinegon             # some of each family: minutes
    python3 tests/numbers/judge.py target/release/kinegon --all       # as many as it takes: an hour
    python3 tests/numbers/judge.py target/release/kinegon straight polar
    python3 tests/numbers/judge.py target/release/kinegon --data > tests/files/numbers.jsonl   # a few of each, for the tests

Families are mechanisms that are hard on the way from the text to the number: decimals of up to 30 digits, vectors by size
and angle, links that are nearly straight, very short links, huge angles, far origins, long chains, cylinders; and
ordinary ones of classes II, III and IV. Needs mpmath. Exit code 1 where an error is larger than stated, a printed digit
wrong, or an ordinary position refused.
"""

import json
import random
import subprocess
import sys
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from statistics import median

from mpmath import mp, mpf

from truth import Carried, Distance, Line, Truth, add, cos_sin, number, quarter, scaled

ZERO = (mpf(0), mpf(0))


class Text(str):
    """A number as its text."""


def dumped(value):
    if isinstance(value, Text):
        return str(value)
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(str(k))}: {dumped(v)}" for k, v in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(dumped(v) for v in value) + "]"
    return json.dumps(value)


class Dice(random.Random):
    def text(self, low, high, digits=6):
        """A decimal of so many digits."""
        whole = str(self.randint(int(low), int(high) - 1))
        decimals = "".join(self.choice("0123456789") for _ in range(max(digits - len(whole.lstrip("-")), 1)))
        return Text(f"{whole}.{decimals}")

    def spread(self, low, high):
        return Text(f"{self.uniform(low, high):.6g}")


def number_pair(place):
    return number(place[0]), number(place[1])


class Case:
    """A scene with what its truth needs. Points begin at places in `near`, of which the lengths are taken."""

    def __init__(self, family, dice, digits=6):
        self.family, self.dice, self.digits = family, dice, digits
        self.scene = {"kinegon": 1, "units": {"length": "mm", "time": "s"}, "ground": {}, "links": {}, "sliders": [], "near": {}}
        self.known, self.groups, self.links, self.places, self.signs = {}, [], {}, {}, [1]
        self.crank = None

    def ground(self, name, x, y):
        self.scene["ground"][name] = [x, y]
        self.known[name] = (number_pair((x, y)), ZERO, ZERO)
        self.places[name] = float(x), float(y)

    def turn(self, a, b, length, angle, omega, alpha="0", **given):
        drive = {"angle": Text(angle), "omega": Text(omega), "alpha": Text(alpha), **given}
        self.scene["links"]["1"] = {"points": [a, b], "lengths": {f"{a}-{b}": length}, "drive": drive}
        r = scaled(cos_sin(angle), number(length))
        w = number(omega) if "rpm" not in given else number(given["rpm"]) * mp.pi / 30
        v, dw = scaled(quarter(r), w), number(alpha)
        acceleration = add(scaled(quarter(r), dw), scaled(r, -w * w))
        self.known[b] = (add(self.known[a][0], r), v, acceleration)
        self.places[b] = tuple(float(x) for x in self.known[b][0])
        self.links["1"] = (a, b)

    def place(self, name, x, y):
        self.places[name] = (x, y)
        self.scene["near"][name] = [Text(f"{x:.8g}"), Text(f"{y:.8g}")]

    def length_text(self, p, q):
        (a, b), (c, d) = self.places[p], self.places[q]
        length = ((a - c) ** 2 + (b - d) ** 2) ** 0.5
        text = f"{length:.5f}" if length > 1e-3 else f"{length:.9e}"
        if self.digits > 8 and "e" not in text:
            text = f"{length:.4f}" + "".join(self.dice.choice("0123456789") for _ in range(self.digits - 7))
        return Text(text)

    def bar(self, name, *points, lengths=None):
        """A link with two or three points and all its distances, which it returns."""
        pairs = [(points[0], points[1])] if len(points) == 2 else [points[:2], points[1:], (points[0], points[2])]
        texts = lengths or [self.length_text(*pair) for pair in pairs]
        given = {f"{p}-{q}": text for (p, q), text in zip(pairs, texts)}
        self.scene["links"][name] = {"points": list(points), "lengths": given}
        self.links[name] = (points[0], points[1])
        return [Distance(p, q, number(text)) for (p, q), text in zip(pairs, texts)]


def four_bar(family, dice, digits=6, drive=None, scale=1.0):
    case = Case(family, dice, digits)
    case.ground("A", dice.text(-9, 9, digits), dice.text(-9, 9, digits))
    case.ground("D", dice.text(120, 180, digits), dice.text(-20, 20, digits))
    angle = drive or dice.text(-180, 180, digits)
    case.turn("A", "B", dice.text(20, 60, digits), angle, dice.text(1, 20, digits), dice.text(-9, 9, digits))
    case.place("C", case.places["B"][0] + dice.uniform(40, 120), case.places["B"][1] + dice.uniform(50, 140))
    constraints = case.bar("2", "B", "C") + case.bar("3", "D", "C")
    case.groups.append((["C"], constraints))
    return case


def ordinary(dice):
    return four_bar("four-bar", dice)


def long_decimals(dice):
    return four_bar("decimals", dice, dice.randint(17, 30))


def rpm(dice):
    case = Case("rpm", dice)
    case.ground("A", Text("0"), Text("0"))
    case.ground("D", dice.text(120, 180), Text("0"))
    case.turn("A", "B", dice.text(20, 60), dice.text(-180, 180), "0")
    del case.scene["links"]["1"]["drive"]["omega"]
    rate = dice.text(10, 999)
    case.scene["links"]["1"]["drive"]["rpm"] = rate
    place = case.known["B"][0]
    r = (place[0], place[1])
    w = number(rate) * mp.pi / 30
    case.known["B"] = (place, scaled(quarter(r), w), scaled(r, -w * w))
    case.place("C", case.places["B"][0] + dice.uniform(40, 120), case.places["B"][1] + dice.uniform(50, 140))
    case.groups.append((["C"], case.bar("2", "B", "C") + case.bar("3", "D", "C")))
    return case


def straight(dice):
    """A coupler with a third point, which is beside its line by nothing or nearly nothing; and a dyad that hangs there."""
    case = Case("straight", dice)
    case.ground("A", Text("0"), Text("0"))
    case.ground("D", Text("160"), Text("0"))
    case.ground("F", Text("260"), dice.text(-90, -40, 4))
    case.turn("A", "B", Text("60"), dice.text(20, 100, 5), "10")
    case.place("C", 157, 110)
    bc, cd = dice.choice(["140", "140.3", "139.97"]), "110"
    part = dice.choice(["90", "50.1", "33.37"])
    rest = number(bc) - number(part)
    off = mpf(10) ** -dice.randint(10, 24) * dice.randint(1, 99) if dice.random() < 0.7 else mpf(0)
    lengths = [Text(bc), Text(mp.nstr(rest + off, 35, strip_zeros=True)), Text(part)]
    case.groups.append((["C"], [Distance("B", "C", number(bc)), *case.bar("3", "D", "C", lengths=[Text(cd)])]))
    case.bar("2", "B", "C", "P", lengths=lengths)
    case.scene["links"]["2"]["lengths"] = {"B-C": lengths[0], "C-P": lengths[1], "B-P": lengths[2]}
    case.scene["near"]["P"] = [Text("111"), Text("89")]
    share = float(part) / float(bc)
    bx, by = case.places["B"]
    case.place("E", bx + share * 100 + 90, by + 60)
    case.places["P"] = (bx + (157 - bx) * share, by + (110 - by) * share)
    case.carried = (number(bc), number(part), number(lengths[1]))
    case.signs = [1, -1]
    case.hanging = (["E"], case.bar("4", "P", "E") + case.bar("5", "F", "E"))
    return case


def short(dice):
    case = Case("short", dice)
    case.ground("A", Text("0"), Text("0"))
    length = 10.0 ** -dice.randint(3, 13) * dice.uniform(1, 9)
    case.ground("D", Text("150"), Text("0"))
    case.turn("A", "B", dice.text(20, 60), dice.text(-180, 180), "3")
    bx, by = case.places["B"]
    turned = dice.uniform(0, 6.28)
    mp_turn = (mp.cos(turned), mp.sin(turned))
    case.places["C"] = (150.0, 0.0)
    case.scene["near"]["angle(3)"] = Text(f"{mp.degrees(turned)}"[:8])
    cd = Text(f"{length:.9e}")
    place = add((mpf(150), mpf(0)), scaled(mp_turn, number(cd)))
    bc = mp.sqrt((place[0] - case.known["B"][0][0]) ** 2 + (place[1] - case.known["B"][0][1]) ** 2)
    text = Text(mp.nstr(bc, 30))
    case.links["3"] = ("D", "C")
    constraints = case.bar("2", "B", "C", lengths=[text]) + case.bar("3", "D", "C", lengths=[cd])
    case.groups.append((["C"], constraints))
    case.turned = ("C", "D", "3", cd)
    return case


def angles(dice):
    power = dice.randint(3, 100)
    text = dice.choice([f"{dice.randint(1, 999)}e{power}", f"{dice.randint(1, 9)}{'0' * (power - 3)}{dice.randint(0, 999):03d}"])
    return four_bar("angles", dice, drive=text)


def origins(dice):
    case = Case("origins", dice)
    far = 10 ** dice.randint(6, 18) * dice.choice([1, -1])
    case.ground("A", Text(f"{far}"), Text(f"{far // 3}"))
    case.ground("D", Text(f"{far + dice.randint(120, 180)}"), Text(f"{far // 3 + dice.randint(-20, 20)}"))
    case.turn("A", "B", dice.text(20, 60), dice.text(-180, 180), dice.text(1, 20))
    r = cos_sin(case.scene["links"]["1"]["drive"]["angle"])
    length = number(case.scene["links"]["1"]["lengths"]["A-B"])
    b = (float(length * r[0]), float(length * r[1]))
    c = (b[0] + dice.uniform(40, 120), b[1] + dice.uniform(50, 140))
    d = tuple(float(number(y) - number(x)) for x, y in zip(case.scene["ground"]["A"], case.scene["ground"]["D"]))
    bc, dc = ((c[0] - e[0]) ** 2 + (c[1] - e[1]) ** 2 for e in (b, d))
    case.scene["near"] = {"C": [Text(mp.nstr(far + mpf(c[0]), 25)), Text(mp.nstr(mpf(far // 3) + mpf(c[1]), 25))]}
    constraints = case.bar("2", "B", "C", lengths=[Text(f"{bc ** 0.5:.5f}")])
    constraints += case.bar("3", "D", "C", lengths=[Text(f"{dc ** 0.5:.5f}")])
    case.groups.append((["C"], constraints))
    case.exact_begin = {"C": (far + mpf(c[0]), mpf(far // 3) + mpf(c[1]))}
    return case


def chain(dice, count=None):
    """Dyads in a row: each hangs on the last one's pin and on the ground."""
    case = Case("chain", dice)
    count = count or dice.choice([5, 10, 20, 40, 60])
    case.family = f"chain {count}"
    case.ground("A", Text("0"), Text("0"))
    case.turn("A", "P0", dice.text(20, 60), dice.text(-180, 180), "2")
    for k in range(1, count + 1):
        x, y = case.places[f"P{k - 1}"]
        place = (x + dice.uniform(60, 110), y + dice.uniform(-40, 40))
        ground = (place[0] + dice.uniform(-50, 50), place[1] - dice.uniform(50, 110))
        case.ground(f"G{k}", Text(f"{ground[0]:.3f}"), Text(f"{ground[1]:.3f}"))
        case.place(f"P{k}", *place)
        bars = case.bar(f"a{k}", f"P{k - 1}", f"P{k}") + case.bar(f"b{k}", f"G{k}", f"P{k}")
        case.groups.append(([f"P{k}"], bars))
    return case


def third(dice):
    case = Case("class III", dice)
    case.ground("A", Text("0"), Text("0"))
    case.ground("F", dice.text(130, 170), dice.text(-60, -30))
    case.ground("G", dice.text(250, 290), dice.text(-20, 20))
    case.turn("A", "B", dice.text(30, 50), dice.text(-180, 180), "10", dice.text(-20, 20))
    for name, x, y in [("C", 100, 110), ("D", 105, 60), ("E", 190, 115)]:
        case.place(name, x + dice.uniform(-25, 25), y + dice.uniform(-25, 25))
    bars = case.bar("2", "B", "C") + case.bar("3", "C", "D", "E") + case.bar("4", "F", "D") + case.bar("5", "G", "E")
    case.groups.append((["C", "D", "E"], bars))
    return case


def fourth(dice):
    case = Case("class IV", dice)
    case.ground("A", Text("0"), Text("0"))
    case.ground("E", dice.text(210, 250), dice.text(10, 50))
    case.turn("A", "B", dice.text(30, 50), dice.text(-180, 180), "10", dice.text(-20, 20))
    for name, x, y in [("C", 65, 125), ("G", 105, 10), ("D", 200, 165), ("F", 155, 110)]:
        case.place(name, x + dice.uniform(-25, 25), y + dice.uniform(-25, 25))
    bars = case.bar("2", "B", "C", "G") + case.bar("3", "C", "D") + case.bar("4", "E", "D", "F") + case.bar("5", "F", "G")
    case.groups.append((["C", "D", "F", "G"], bars))
    return case


def slider(dice):
    case = Case("slider-crank", dice)
    case.ground("A", Text("0"), Text("0"))
    case.turn("A", "B", dice.text(30, 50), dice.text(-180, 180), "10", dice.text(-20, 20))
    degrees, through = dice.text(-40, 40), [dice.text(-9, 9), dice.text(-30, 30)]
    along = cos_sin(degrees)
    bc = dice.text(120, 180)
    place = add(number_pair(through), scaled(along, mpf(dice.randint(130, 170))))
    case.place("C", float(place[0]), float(place[1]))
    case.scene["links"]["3"] = {"points": ["C"]}
    case.scene["sliders"] = [{"link": "3", "at": "C", "on": "ground", "through": through, "along": degrees}]
    case.groups.append((["C"], [*case.bar("2", "B", "C", lengths=[bc]), Line("C", number_pair(through), along)]))
    return case


def cylinder(dice):
    case = Case("cylinder", dice)
    case.ground("O", Text("0"), Text("0"))
    case.ground("A", dice.text(600, 800), dice.text(-400, -300))
    position, speed, acceleration = dice.text(400, 500), dice.text(50, 90), dice.text(10, 40)
    case.place("C", 1200 + dice.uniform(-60, 60), 900 + dice.uniform(-60, 60))
    oc = case.length_text("O", "C")
    ac = number(case.length_text("A", "C"))
    rod = Text(mp.nstr(ac - number(position), 10))
    case.scene["links"] = {
        "2": {"points": ["A", "B"], "lengths": {"A-B": Text("900")}},
        "3": {"points": ["D", "C"], "lengths": {"D-C": rod}},
        "4": {"points": ["O", "C"], "lengths": {"O-C": oc}},
    }
    drive = {"position": position, "speed": speed, "acceleration": acceleration}
    case.scene["sliders"] = [{"link": "3", "at": "D", "on": "2", "along": "A-B", "drive": drive}]
    leg = Distance("C", "A", number(position) + number(rod), number(speed), number(acceleration))
    case.groups.append((["C"], [leg, Distance("C", "O", number(oc))]))
    case.links = {"4": ("O", "C"), "2": ("A", "C"), "3": ("A", "C")}
    case.only = ["O", "A", "C"]
    return case


def polar(dice):
    """As drawn, with velocities and accelerations by size and angle, many of them nearly along an axis."""
    case = Case("polar", dice)
    case.drawn = True
    b, c, d = ([dice.text(low, low + 60, 5) for low in lows] for lows in ([-30, -30], [60, 60], [130, -40]))
    near = dice.choice(["", "e-9", "e-4"])
    angle = dice.text(-180, 180, 8)
    if near:
        angle = Text(mp.nstr(dice.choice([0, 90, 180, 270]) + dice.choice([1, -1]) * mpf(f"{dice.randint(1, 999)}{near}"), 20))
    size, second, turned = dice.text(1, 200, 8), dice.text(1, 2000, 8), dice.text(-360, 360, 8)
    case.scene = {
        "kinegon": 1, "units": {"length": "mm", "time": "s"}, "points": {"B": b, "C": c, "D": d},
        "known": {
            "B": {"velocity": {"size": size, "angle": angle}, "acceleration": {"size": second, "angle": turned}},
            "D": {"velocity": [Text("0"), Text("0")]},
        },
        "links": {"1": ["B"], "2": ["B", "C"], "3": ["D", "C"], "4": ["D"]},
    }
    place = {name: number_pair(p) for name, p in zip("BCD", (b, c, d))}
    case.known["B"] = (place["B"], scaled(cos_sin(angle), number(size)), scaled(cos_sin(turned), number(second)))
    case.known["D"] = (place["D"], ZERO, ZERO)
    lengths = [mp.sqrt(sum((x - y) ** 2 for x, y in zip(place["C"], place[p]))) for p in "BD"]
    case.groups.append((["C"], [Distance("B", "C", lengths[0]), Distance("D", "C", lengths[1])]))
    case.links = {"2": ("B", "C"), "3": ("D", "C")}
    case.exact_begin = {"C": place["C"]}
    return case


FAMILIES = {
    "ordinary": (ordinary, 100, 3000), "decimals": (long_decimals, 100, 3000), "polar": (polar, 100, 6000),
    "straight": (straight, 60, 900), "short": (short, 60, 500), "angles": (angles, 60, 1000), "rpm": (rpm, 40, 500),
    "origins": (origins, 60, 1000), "chains": (chain, 20, 300), "third": (third, 60, 2000), "fourth": (fourth, 60, 2000),
    "sliders": (slider, 60, 2000), "cylinders": (cylinder, 60, 2000),
}


class Seen:
    def __init__(self):
        self.cases = self.refused = self.proved = self.numbers = self.without = self.digits = self.exact = 0
        self.shares, self.wrong, self.certain = [], [], []


def truths(case, result):
    begin = {p: tuple(got["position"]) for p, got in result["points"].items() if got.get("position")}
    begin.update(getattr(case, "exact_begin", {}))
    if hasattr(case, "turned"):
        # The other end of a link so short that rounded places do not tell its direction.
        p, origin, link, length = case.turned
        turn = cos_sin(repr(result["links"][link]["angle"]))
        begin[p] = add(case.known[origin][0], scaled(turn, number(length)))
    for sign in case.signs:
        groups = list(case.groups)
        if hasattr(case, "hanging"):
            bc, bp, cp = case.carried
            groups += [Carried("P", "B", "C", bc, bp, cp, sign), case.hanging]
        yield Truth(case.known, groups, begin)


def judged(case, program):
    text = dumped(case.scene)
    run = lambda *more: subprocess.run([program, "solve", "-", *more], input=text, capture_output=True, text=True)
    first = run()
    if first.returncode != 0:
        return case, text, None, first.stderr, None
    return case, text, json.loads(first.stdout), first.stderr, run("--digits").stdout


def numbers_of(case, truth, result):
    """Name, stated value and error, true value."""
    numbers = []
    for link, ends in case.links.items():
        got = result["links"][link]
        for head, true in zip(("omega", "alpha"), truth.link(*ends)):
            numbers.append((f"{head}({link})", got[head], got[f"{head}_error"], true))
    for p in getattr(case, "only", truth.at):
        got = result["points"][p]
        for letter, key, of in (("place", "position", truth.at), ("v", "velocity", truth.v), ("a", "acceleration", truth.a)):
            for axis in (0, 1):
                numbers.append((f"{letter}({p}).{'xy'[axis]}", got[key][axis], got[f"{key}_error"], of[p][axis]))
        for letter, of in (("v", truth.v), ("a", truth.a)):
            numbers.append((f"{letter}({p}).size", None, None, mp.sqrt(of[p][0] ** 2 + of[p][1] ** 2)))
    return numbers


def compare(case, text, result, table, seen):
    seen.cases += 1
    seen.proved += result.get("proved", False)
    try:
        all_truths = list(truths(case, result))
    except (ArithmeticError, ZeroDivisionError) as error:
        seen.wrong.append(f"{case.family}: no truth, {error}: {text}")
        return
    faults = []
    # Where nothing says on which side a straight link's point is, one of both must be right.
    for truth in all_truths:
        fault, numbers, named = [], numbers_of(case, truth, result), {}
        for name, value, bound, true in numbers:
            named[name] = true
            if value is None:
                continue
            seen.numbers += 1
            if bound is None:
                seen.without += 1
                continue
            # As f64, and as the decimal that is printed.
            error = abs(mpf(repr(value)) - true)
            error = max(error, abs(mpf(value) - true)) if bound > 0 else error
            if error > mpf(bound) * (1 + mpf(10) ** -12) + mpf(10) ** -45:
                fault.append(f"{name} = {value}: error {mp.nstr(error, 5)}, stated {bound}")
            elif error < mpf(10) ** -40:
                seen.exact += 1
            elif bound > 0:
                seen.shares.append(float(mpf(bound) / error))
            if true != 0 and name[0] in "oav":
                seen.certain.append(float(-mp.log10(max(mpf(bound) / abs(true), mpf(10) ** -17))) if bound else 17.0)
        fault += digits(table, named, seen)
        faults.append(fault)
    if all(faults):
        seen.wrong.append(f"{case.family}: {'; '.join(faults[0][:3])}: {text}")


def digits(table, named, seen):
    fault = []
    for line in table.splitlines():
        words = line.split()
        true = named.get(words[0])
        if true is None or words[1] in ("0", "?"):
            continue
        try:
            printed = mpf(words[1])
        except ValueError:
            continue
        mantissa, _, power = words[1].partition("e")
        unit = mpf(10) ** (int(power or 0) - len(mantissa.partition(".")[2]))
        seen.digits += 1
        if abs(printed - true) > unit * (1 + mpf(10) ** -9):
            fault.append(f"{line}: truly {mp.nstr(true, 20)}")
    return fault


def data(program):
    """Prints a few cases of each family with their true numbers, of all that may be meant."""
    for name, (make, _, _) in FAMILIES.items():
        for k in range(4):
            dice = Dice(f"data {name} {k}")
            case, text, result, _, _ = judged(chain(dice, (5, 10, 20, 40)[k]) if make is chain else make(dice), program)
            if result is None:
                continue
            all_numbers = [numbers_of(case, truth, result) for truth in truths(case, result)]
            expect = [{name: mp.nstr(true, 34) for name, value, _, true in numbers if value is not None} for numbers in all_numbers]
            print(json.dumps({"family": case.family, "scene": text, "expect": expect}))


def main():
    if "--data" in sys.argv:
        return data(sys.argv[1])
    words = [word for word in sys.argv[1:] if not word.startswith("--")]
    program, chosen = words[0], words[1:] or list(FAMILIES)
    families = defaultdict(Seen)
    for name in chosen:
        make, few, many = FAMILIES[name]
        cases = [make(Dice(f"{name} {k}")) for k in range(many if "--all" in sys.argv else few)]
        with ThreadPoolExecutor(2) as pool:
            for case, text, result, said, table in pool.map(lambda case: judged(case, program), cases):
                seen = families[case.family]
                if result is None:
                    seen.refused += 1
                    seen.message = said
                else:
                    compare(case, text, result, table, seen)
    columns = ["family", "cases", "refused", "proved", "numbers", "no bound", "digits", "bound/error: median", "90 %", "certain digits: least", "wrong"]
    print(" | ".join(columns))
    wrong = 0
    for family, seen in families.items():
        shares, certain = sorted(seen.shares), sorted(seen.certain)
        middle = f"{median(shares):.3g}" if shares else "-"
        most = f"{shares[len(shares) * 9 // 10]:.3g}" if shares else "-"
        least = f"{certain[0]:.1f}" if certain else "-"
        row = [family, seen.cases, seen.refused, seen.proved, seen.numbers, seen.without, seen.digits, middle, most, least, len(seen.wrong)]
        print(" | ".join(str(cell) for cell in row))
        wrong += len(seen.wrong)
    for seen in families.values():
        for line in seen.wrong[:2]:
            print(line)
        if seen.refused:
            print("refused:", seen.message.strip()[:300])
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
