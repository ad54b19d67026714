"""Mistakes with ruler, set square, pencil and dividers. See `mistakes.py`."""

import math
import re

from mistakes import kind


# ---------------------------------------------------------------- rays

@kind("turned-ray", "turned-ray", "ray", "guide-ray", "image-ray")
def turned_ray(p):
    (key, ref), = p.entry["along"].items()
    return p.but(along={"parallel" if key == "normal" else "normal": ref})


@kind("ray-from-wrong-point", "ray-from-wrong-point", "ray", "guide-ray", "image-ray")
def ray_from_wrong_point(p):
    other = p.pick(n for n in p.points(p.sheet, p.entry["through"]) if n not in p.own and n != p.op.info.get("plain"))
    return other and p.but(through=other)


@kind("ray-before-the-normal-part", "ray-from-wrong-point normal-forgotten coriolis-forgotten", "ray", "guide-ray")
def ray_before_normal(p):
    """The normal or Coriolis part is laid off, but the ray drawn through the point before it."""
    plain = p.op.info.get("plain")
    return p.but(through=plain) if plain else None


@kind("ray-of-another-link", "", "ray", "image-ray")
def ray_of_another_link(p):
    way = p.sheets.along(p.sheet, p.entry["along"])
    def apart(ref):
        other = p.sheets.way("scheme", ref)
        return abs((way.conjugate() * other * 1j).imag) > 0.05 * abs(other)

    other = p.pick(n for n in p.axes() if apart(n))
    return other and p.but(along={"normal": other})


@kind("ray-askew", "", "ray", "guide-ray", "image-ray", "turned-image-ray")
def ray_askew(p):
    """The set square has slipped by some degrees."""
    return [p.op.but(dict(p.entry), askew=p.rng.choice((1, -1)) * p.rng.uniform(5, 25))]


@kind("image-turned-wrong-way", "mirrored-image turned-ray", "turned-image-ray")
def image_turned_wrong_way(p):
    along = p.entry["along"]
    return p.but(along={**along, "turned": along["turned"][::-1]})


@kind("normal-forgotten", "normal-forgotten ray-from-wrong-point vector-from-wrong-point", "normal", "normal-laid")
def normal_forgotten(p):
    return "forgotten"


@kind("coriolis-forgotten", "coriolis-forgotten ray-from-wrong-point vector-from-wrong-point", "coriolis",
      "coriolis-laid")
def coriolis_forgotten(p):
    return "forgotten"


# ---------------------------------------------------------------- the scheme, crossings

@kind("wrong-cut-line", "wrong-lines", "cut")
def wrong_cut_line(p):
    side = p.op.info["side"]
    others = [n for n in p.points("scheme") if n not in (side.a, side.c) and not re.match(r"S\d", n)]
    other = p.pick(others)
    if not other:
        return None
    keep = p.rng.choice([side.a, side.c])
    return [p.op.but({"join": p.entry.get("join") or p.entry["line"], "on": "scheme", "points": [keep, other]})]


@kind("turned-cut-line", "turned-cut-line", "cut-guide")
def turned_cut_line(p):
    return p.but(along={"parallel": p.entry["along"]["normal"]})


@kind("wrong-lines", "wrong-lines", "cross-special")
def wrong_lines(p):
    return other_lines(p)


@kind("wrong-rays-crossed", "", "cross", may="wrong-lines ray-from-wrong-point")
def wrong_rays(p):
    return other_lines(p)


def other_lines(p):
    keep = p.rng.choice(p.entry["of"])
    way = p.sheets.lines[keep][2]
    others = [n for n, (sheet, _, w) in p.sheets.lines.items()
              if sheet == p.sheet and n not in p.entry["of"] and abs((w.conjugate() * way).imag) > 0.1]
    other = p.pick(others)
    return other and p.but(of=[keep, other])


@kind("crossing-marked-beside", "", "cross", "cross-special")
def marked_beside(p):
    if p.snap != "none":
        return None
    return [p.op.but(dict(p.entry), off_mm=p.rng.uniform(5, 20), off_way=p.rng.uniform(0, 2 * math.pi))]


# ---------------------------------------------------------------- vectors

def reversed_along(p):
    (key, ref), = p.entry["along"].items()
    if isinstance(ref, str) and "," in ref:
        return p.but(along={key: ",".join(ref.split(",")[::-1])})
    return p.but(size=f"-({p.entry['size']})")


@kind("reversed-vector", "reversed-vector", "crank-velocity", "crank-velocity-laid", "crank-tangential", "relative", "relative-laid",
      "tangential", "tangential-laid", "drive", "known")
def reversed_vector(p):
    return reversed_along(p) if "lay_off" in p.entry else None


@kind("normal-outward", "normal-outward reversed-vector", "normal", "crank-normal", "normal-laid", "crank-normal-laid")
def normal_outward(p):
    return reversed_along(p) if "lay_off" in p.entry else None


@kind("turned-vector", "turned-vector", "crank-velocity", "crank-normal", "relative", "tangential", "normal", "crank-velocity-laid",
      "normal-laid", "drive")
def turned_vector(p):
    if "lay_off" not in p.entry:
        return None
    (key, ref), = p.entry["along"].items()
    return p.but(along={"parallel" if key == "normal" else "normal": ref})


@kind("vector-from-wrong-point", "vector-from-wrong-point", "normal", "coriolis", "tangential", "relative", "normal-laid",
      "coriolis-laid", "tangential-laid")
def vector_from_wrong_point(p):
    if "lay_off" not in p.entry:
        return None
    other = p.pick(n for n in p.points(p.sheet, p.entry["from"]) if n not in p.own)
    return other and p.but(**{"from": other})


@kind("vector-along-another-link", "", "normal", "tangential", "relative", "crank-velocity")
def vector_of_another_link(p):
    if "lay_off" not in p.entry:
        return None
    (key, ref), = p.entry["along"].items()
    other = p.pick(n for n in p.axes() if abs((p.sheets.way("scheme", n).conjugate() * p.sheets.way(p.sheet, ref)).imag)
                   > 0.05 * abs(p.sheets.way("scheme", n) * p.sheets.way(p.sheet, ref)))
    return other and p.but(along={key: other})


@kind("coriolis-turned", "coriolis-turned", "coriolis")
def coriolis_turned(p):
    return p.amounts(sign=-p.amount.sign)


@kind("coriolis-along-guide", "coriolis-along-guide", "coriolis", "coriolis-laid")
def coriolis_along_guide(p):
    return p.but(along={"parallel": p.entry["along"]["normal"]}) if "lay_off" in p.entry else None


@kind("angle-of-a-given-vector", "", "known", may="turned-vector reversed-vector")
def given_angle(p):
    angle = p.entry["along"]["angle"]
    return p.but(along={"angle": p.rng.choice([-angle, 90 - angle])}) if angle else None


@kind("part-along-the-other-axis", "", "known", may="turned-vector")
def parts_swapped(p):
    angle = p.entry["along"]["angle"]
    return p.but(along={"angle": 90 - angle}) if angle in (0, 90) else None


# ---------------------------------------------------------------- images

@kind("mirrored-image", "mirrored-image", "like")
def mirrored(p):
    return None if p.op.info["flat"] else p.but(mirrored=True)


@kind("wrong-ratio", "wrong-ratio mirrored-image", "like", "part")
def wrong_ratio(p):
    if p.op.role == "part":
        if "as" in p.entry:
            return None
        one, two = p.amount.length.split("/")
        return p.amounts(length=f"{two}/{one}")
    return p.but(ends=p.entry["ends"][::-1])


@kind("image-on-wrong-side", "mirrored-image reversed-vector", "part")
def wrong_side(p):
    return p.amounts(sign=-p.amount.sign)


@kind("image-of-another-triangle", "", "like")
def another_triangle(p):
    a, b, c = p.entry["points"]
    other = p.pick(n for n in p.points("scheme", a, b, c))
    return other and p.but(points=[a, b, other])
