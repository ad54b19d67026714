"""How the second hand constructs the plans of each mechanism. See `second.py`."""

import math

from second_task import TURN, across, along, angle, meet, solve


# Groups of two links

def dyad_velocity(s, a, b, c, links):
    """c between two links that end in a and b."""
    p, q, t = a.lower(), b.lower(), c.lower()
    one = s.ray("v", p, t, s.angle(a, c) + TURN, link=(a, c))
    two = s.ray("v", q, t, s.angle(b, c) + TURN, link=(b, c))
    s.mark("v", t, one, two)
    for end, x, link in ((a, p, links[0]), (b, q, links[1])):
        s.rate(f"omega({link})", "v", x, t, s.length(end, c), across(s.angle(end, c), s.point("v", x), s.point("v", t)))


def normal(s, a, b, link, plan_from=None, name=None):
    """Lays off the normal part of b about a, and says where it ends."""
    start = plan_from or a.lower()
    name = name or f"n_{a.lower()}{b}"
    w, size = s.rates[f"omega({link})"], s.length(a, b)
    s.vector("a", start, name, s.angle(b, a), w * w * size, "normal", omega=w, length=size, link=link, about=a, of=b)
    return name


def dyad_acceleration(s, a, b, c, links):
    t = c.lower()
    n, m = normal(s, a, c, links[0]), None
    one = s.ray("a", n, t, s.angle(a, c) + TURN, link=(a, c))
    m = normal(s, b, c, links[1])
    two = s.ray("a", m, t, s.angle(b, c) + TURN, link=(b, c))
    s.mark("a", t, one, two)
    for end, x, link in ((a, n, links[0]), (b, m, links[1])):
        s.rate(f"alpha({link})", "a", x, t, s.length(end, c), across(s.angle(end, c), s.point("a", x), s.point("a", t)))


def slider_velocity(s, b, c, link, slider, guide):
    x, t = b.lower(), c.lower()
    one = s.ray("v", x, t, s.angle(b, c) + TURN, link=(b, c))
    two = s.ray("v", "p", t, guide, guide=True)
    s.mark("v", t, one, two)
    s.rate(f"omega({link})", "v", x, t, s.length(b, c), across(s.angle(b, c), s.point("v", x), s.point("v", t)))
    s.rate(f"v_r({slider})", "v", "p", t, 1, along(guide, (0, 0), s.point("v", t)))


def slider_acceleration(s, b, c, link, slider, guide):
    t, n = c.lower(), normal(s, b, c, link)
    one = s.ray("a", n, t, s.angle(b, c) + TURN, link=(b, c))
    two = s.ray("a", "π", t, guide, guide=True)
    s.mark("a", t, one, two)
    s.rate(f"alpha({link})", "a", n, t, s.length(b, c), across(s.angle(b, c), s.point("a", n), s.point("a", t)))
    s.rate(f"a_r({slider})", "a", "π", t, 1, along(guide, (0, 0), s.point("a", t)))


def slot_velocity(s, guide):
    """Block 2 on the crank's pin B in lever 3 about D."""
    d = s.angle("D", "B")
    one = s.ray("v", "d", "b_3", d + TURN, link=("D", "B"))
    two = s.ray("v", "b", "b_3", guide, guide=True)
    s.mark("v", "b_3", one, two)
    s.rate("omega(3)", "v", "d", "b_3", s.length("D", "B"), across(d, (0, 0), s.point("v", "b_3")))
    s.rate("v_r(2/3)", "v", "b", "b_3", 1, along(guide, s.point("v", "b_3"), s.point("v", "b")))


def slot_acceleration(s, guide):
    d, w, v = s.angle("D", "B"), s.rates["omega(3)"], s.rates["v_r(2/3)"]
    n = normal(s, "D", "B", "3", name="n_dB_3")
    one = s.ray("a", n, "b_3", d + TURN, link=("D", "B"))
    slide = guide if v > 0 else guide + math.pi
    coriolis = slide + (TURN if w > 0 else -TURN)
    s.vector("a", "b", "k_b3", coriolis + math.pi, 2 * abs(w * v), "coriolis", omega=w, slide=v, guide=guide)
    two = s.ray("a", "k_b3", "b_3", guide, guide=True)
    s.mark("a", "b_3", one, two)
    s.rate("alpha(3)", "a", n, "b_3", s.length("D", "B"), across(d, s.point("a", n), s.point("a", "b_3")))
    s.rate("a_r(2/3)", "a", "k_b3", "b_3", 1, along(guide, s.point("a", "b_3"), s.point("a", "k_b3")))


def image_velocity(s, b, c, e):
    x, y, t = b.lower(), c.lower(), e.lower()
    one = s.ray("v", x, t, s.angle(b, e) + TURN, link=(b, e), image=True)
    two = s.ray("v", y, t, s.angle(c, e) + TURN, link=(c, e), image=True)
    s.mark("v", t, one, two)


def image_acceleration(s, b, c, e):
    x, y, t = b.lower(), c.lower(), e.lower()
    base = angle(s.point("a", x), s.point("a", y))
    one = s.ray("a", x, t, base + s.angle(b, e) - s.angle(b, c), image=True, base=base)
    two = s.ray("a", y, t, base + s.angle(c, e) - s.angle(b, c), image=True, base=base)
    s.mark("a", t, one, two)


def crank(s, plan):
    d = s.angle("A", "B") + (math.copysign(TURN, s.omega) if plan == "v" else math.pi)
    size = s.task.length("A", "B")
    amount = abs(s.omega) * size if plan == "v" else s.omega ** 2 * size
    s.vector(plan, "p" if plan == "v" else "π", "b", d, amount, "crank", omega=s.omega, length=size, link="1", about="A", of="B")


# Groups of four links: special points

def special(s, sides):
    """Rates of links 2 to 5 from two special points. A side is (fixed joint A, moving joint C, its link, special point S, the floating
    link): S lies on AC and moves with the floating link."""
    for plan, word in (("v", "omega"), ("a", "alpha")):
        if plan == "a":
            crank(s, "a")
        rows, right = [], []
        for first, second in (sides[:2], sides[2:]):
            rays, starts = [], []
            for (a, c, link, point, floating) in (first, second):
                start = a.lower()
                if plan == "a":
                    w, o = s.rates[f"omega({link})"], s.rates[f"omega({floating})"]
                    d = s.angle(a, c)
                    stretch = s.measured[f"{c},{point}"] * math.copysign(1, along(d, s.position[c], s.position[point]))
                    size = w * w * s.task.length(a, c) + o * o * stretch
                    name = f"n_{start}{point[1:]}"
                    s.vector("a", start, name, d + math.pi, size, "normal", omega=w, length=s.task.length(a, c), link=link, about=a, of=c,
                             other=o * o * stretch)
                    start = name
                rays.append(s.ray(plan, start, point.lower(), s.angle(a, c) + TURN, link=(a, c)))
                starts.append(start)
            s.mark(plan, first[3].lower(), *rays)
            for (a, c, link, point, floating), start in zip((first, second), starts):
                d = s.angle(a, c)
                sign = math.copysign(1, across(d, s.point(plan, start), s.point(plan, point.lower())))
                right.append(sign * s.segment(plan, start, point.lower()) * s.mu[plan])
                row = [0.0] * 4
                row[int(link) - 2] = s.task.length(a, c)
                row[int(floating) - 2] = s.measured[f"{c},{point}"] * math.copysign(1, along(d, s.position[c], s.position[point]))
                rows.append(row)
        for i, value in enumerate(solve(rows, right)):
            box = f"{word}({i + 2})"
            s.settle(box, {"box": box, "plan": plan, "segment": None, "length": None, "sense": 1, "value": value})
        if plan == "v":
            yield  # joints of the velocity plan
    yield


def image(s, plan, b, c, e, link):
    """The image of e, a third point of the link: on the line where the link is straight, by the link's rates where the form asks for
    these parts, as on flat triangles, and else where the rays from b and c meet."""
    q = s.position
    for start in (b, c):
        part = f"aplan({start.lower()},n_{start.lower()}{e})" if plan == "a" else f"vplan({start.lower()},{e.lower()})"
        if part in s.task.boxes:
            return (turn_acceleration if plan == "a" else turn)(s, start, e, link)
    if abs(math.sin(angle(q[b], q[e]) - angle(q[b], q[c]))) < 0.03:
        side = math.copysign(1, along(angle(q[b], q[c]), q[b], q[e]))
        return s.divide(plan, b.lower(), c.lower(), e.lower(), side * s.task.length(b, e) / s.task.length(b, c))
    return (image_acceleration if plan == "a" else image_velocity)(s, b, c, e)


def turn(s, a, b, link):
    """The joint b from a by a link's rates: tangential parts."""
    w = s.rates[f"omega({link})"]
    s.vector("v", a.lower(), b.lower(), s.angle(a, b) + TURN, w * s.task.length(a, b), "relative", link=link)


def turn_acceleration(s, a, b, link, start=None):
    n = normal(s, a, b, link, plan_from=start)
    s.vector("a", n, b.lower(), s.angle(a, b) + TURN, s.rates[f"alpha({link})"] * s.task.length(a, b), "tangential", link=link)


# Mechanisms

def four_bar(s):
    for plan, dyad in (("v", dyad_velocity), ("a", dyad_acceleration)):
        crank(s, plan)
        dyad(s, "B", "D", "C", "23")


def guide_of(s, index):
    return math.radians(s.task.guides[index]["along"])


def slider_crank(s):
    g = guide_of(s, 0)
    crank(s, "v")
    slider_velocity(s, "B", "C", "2", "3/ground", g)
    crank(s, "a")
    slider_acceleration(s, "B", "C", "2", "3/ground", g)


def slotted_lever(s):
    g = s.angle("D", "C")
    ratio = s.task.length("C", "D") / s.length("D", "B")
    crank(s, "v")
    slot_velocity(s, g)
    s.divide("v", "d", "b_3", "c", ratio)
    crank(s, "a")
    slot_acceleration(s, g)
    s.divide("a", "d", "b_3", "c", ratio)


def whitworth(s):
    g = s.angle("E", "D")
    line = guide_of(s, 1)
    side = math.copysign(1, along(s.angle("D", "B"), s.position["D"], s.position["E"]))
    ratio = side * s.task.length("D", "E") / s.length("D", "B")
    crank(s, "v")
    slot_velocity(s, g)
    s.divide("v", "d", "b_3", "e", ratio)
    slider_velocity(s, "E", "F", "4", "5/ground", line)
    crank(s, "a")
    slot_acceleration(s, g)
    s.divide("a", "d", "b_3", "e", ratio)
    slider_acceleration(s, "E", "F", "4", "5/ground", line)


def toggle_press(s):
    g = guide_of(s, 0)
    crank(s, "v")
    dyad_velocity(s, "B", "D", "C", "23")
    slider_velocity(s, "C", "E", "4", "5/ground", g)
    crank(s, "a")
    dyad_acceleration(s, "B", "D", "C", "23")
    slider_acceleration(s, "C", "E", "4", "5/ground", g)


def watt(s):
    for plan, dyad in (("v", dyad_velocity), ("a", dyad_acceleration)):
        crank(s, plan)
        dyad(s, "B", "D", "C", "23")
        image(s, plan, "B", "C", "E", "2")
        image(s, plan, "D", "C", "F", "3")
        dyad(s, "E", "F", "G", "45")


def stephenson(s):
    for plan, dyad in (("v", dyad_velocity), ("a", dyad_acceleration)):
        crank(s, plan)
        dyad(s, "B", "D", "C", "23")
        image(s, plan, "B", "C", "E", "2")
        dyad(s, "E", "G", "F", "45")


def special_point(s, name, a, b, c, d):
    q = s.position
    f = s.act("special", f"L:special:{name}", {"name": name, "lines": [(a, b), (c, d)]})
    (a, b), (c, d) = f["lines"]
    s.position = {**q, name: meet(q[a], angle(q[a], q[b]), q[c], angle(q[c], q[d]))}


def third_class(s):
    special_point(s, "S24", "B", "C", "F", "D")
    special_point(s, "S25", "B", "C", "G", "E")
    for a, b in ("C", "S24"), ("D", "S24"), ("C", "S25"), ("E", "S25"):
        s.measure_length(a, b)
    crank(s, "v")
    steps = special(s, [("B", "C", "2", "S24", "3"), ("F", "D", "4", "S24", "3"), ("B", "C", "2", "S25", "3"), ("G", "E", "5", "S25", "3")])
    next(steps)
    turn(s, "B", "C", "2")
    turn(s, "F", "D", "4")
    turn(s, "G", "E", "5")
    next(steps)
    turn_acceleration(s, "B", "C", "2")
    turn_acceleration(s, "C", "D", "3")
    turn_acceleration(s, "C", "E", "3")


def fourth_class(s):
    special_point(s, "S3", "B", "C", "E", "D")
    special_point(s, "S5", "B", "G", "E", "F")
    for a, b in ("C", "S3"), ("D", "S3"), ("G", "S5"), ("F", "S5"):
        s.measure_length(a, b)
    crank(s, "v")
    steps = special(s, [("B", "C", "2", "S3", "3"), ("E", "D", "4", "S3", "3"), ("B", "G", "2", "S5", "5"), ("E", "F", "4", "S5", "5")])
    next(steps)
    turn(s, "B", "C", "2")
    turn(s, "E", "D", "4")
    turn(s, "B", "G", "2")
    turn(s, "E", "F", "4")
    next(steps)
    turn_acceleration(s, "B", "C", "2")
    turn_acceleration(s, "B", "G", "2")
    turn_acceleration(s, "C", "D", "3")
    turn_acceleration(s, "E", "F", "4")


def hydraulic_boom(s):
    d, ac = s.angle("A", "C"), s.task.drive["position"] + s.task.length("D", "C")
    speed, gain = s.task.drive["speed"], s.task.drive.get("acceleration", 0)
    s.vector("v", "a", "r_a3", d, speed, "drive")
    s.mark("v", "c", s.ray("v", "r_a3", "c", d + TURN, link=("A", "C")), s.ray("v", "o", "c", s.angle("O", "C") + TURN, link=("O", "C")))
    w = s.rate("omega(2)", "v", "r_a3", "c", ac, across(d, s.point("v", "r_a3"), s.point("v", "c")))
    s.rates["omega(3)"] = w
    s.rate("omega(4)", "v", "o", "c", s.length("O", "C"), across(s.angle("O", "C"), (0, 0), s.point("v", "c")))
    turn(s, "A", "B", "2")
    turn(s, "C", "D", "3")
    image(s, "v", "O", "C", "E", "4")
    s.vector("a", "a", "r_a3", d, gain, "drive")
    coriolis = d + (TURN if w * speed > 0 else -TURN)
    s.vector("a", "r_a3", "k_a3", coriolis, 2 * abs(w * speed), "coriolis", omega=w, slide=speed, guide=d)
    s.vector("a", "k_a3", "n_aC", d + math.pi, w * w * ac, "normal", omega=w, length=ac, link="2", about="A", of="C")
    one = s.ray("a", "n_aC", "c", d + TURN, link=("A", "C"))
    n = normal(s, "O", "C", "4")
    s.mark("a", "c", one, s.ray("a", n, "c", s.angle("O", "C") + TURN, link=("O", "C")))
    s.rate("alpha(2)", "a", "n_aC", "c", ac, across(d, s.point("a", "n_aC"), s.point("a", "c")))
    s.rates["alpha(3)"] = s.rates["alpha(2)"]
    s.rate("alpha(4)", "a", n, "c", s.length("O", "C"), across(s.angle("O", "C"), s.point("a", n), s.point("a", "c")))
    at = s.task.drive["position"]
    s.vector("a", "π", "n_aD_2", d + math.pi, w * w * at, "normal", omega=w, length=at, link="2", about="A", of="D")
    s.vector("a", "n_aD_2", "d_2", d + TURN, s.rates["alpha(2)"] * at, "tangential", link="2")
    turn_acceleration(s, "C", "D", "3")
    s.divide("a", "a", "d_2", "b", s.task.length("A", "B") / at)
    image(s, "a", "O", "C", "E", "4")


MECHANISMS = {
    "four-bar": four_bar, "slider-crank": slider_crank, "slotted-lever": slotted_lever, "whitworth": whitworth, "toggle-press": toggle_press,
    "watt-1": watt, "stephenson-3": stephenson, "third-class": third_class, "fourth-class": fourth_class, "hydraulic-boom": hydraulic_boom,
}
