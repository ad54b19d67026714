"""Which constructions make the plans of each mechanism, and where its scenes come from: `kinegon exercise`, templates/, examples/ and
the lecture scenes beside this file."""

import json
import subprocess
from pathlib import Path

from groups import Cylinder, Side
from plans import ACCELERATION, PLANS, POLE, VELOCITY, Amount
from truth import Mechanism

HERE = Path(__file__).parent
ROOT = HERE.parent.parent


def four_bar(d):
    d.crank("1")
    for sheet in PLANS:
        d.two_links(sheet, "B", "D", "C", "2", "3")


def four_bar_with_point(d):
    four_bar(d)
    for sheet in PLANS:
        d.third(sheet, "B", "C", "K", "2")


def slider_crank(d):
    d.crank("1")
    for sheet in PLANS:
        d.guided(sheet, "B", "C", "2", "3/ground")


def slider_crank_with_point(d):
    slider_crank(d)
    for sheet in PLANS:
        d.third(sheet, "B", "C", "K", "2")


def slotted_lever(d):
    d.crank("1")
    for sheet in PLANS:
        d.slot(sheet, "D", "B", "3", "2/3", block="2")
        d.third(sheet, "D", "B", "C", "3", image_c="b_3")


def whitworth(d):
    d.crank("1")
    for sheet in PLANS:
        d.slot(sheet, "D", "B", "3", "2/3", block="2")
        d.third(sheet, "D", "B", "E", "3", image_c="b_3")
        d.guided(sheet, "E", "F", "4", "5/ground")


def shaper(d):
    d.crank("1")
    for sheet in PLANS:
        d.slot(sheet, "D", "B", "3", "2/3", block="2")
        d.third(sheet, "D", "B", "C", "3", image_c="b_3")
        d.guided(sheet, "C", "F", "4", "5/ground")


def inverted(d):
    d.crank("1")
    for sheet in PLANS:
        d.slot(sheet, "B", "D", "2", "3/2", block="3")
        d.third(sheet, "B", "D", "E", "2", image_c="d_2")


def watt(d):
    d.crank("1")
    for sheet in PLANS:
        d.two_links(sheet, "B", "D", "C", "2", "3")
        d.third(sheet, "B", "C", "E", "2")
        d.third(sheet, "D", "C", "F", "3")
        d.two_links(sheet, "E", "F", "G", "4", "5")


def stephenson(d):
    d.crank("1")
    for sheet in PLANS:
        d.two_links(sheet, "B", "D", "C", "2", "3")
        d.third(sheet, "B", "C", "E", "2")
        d.two_links(sheet, "E", "G", "F", "4", "5")


def five_bar(d):
    d.crank("1")
    d.crank("4")
    for sheet in PLANS:
        d.two_links(sheet, "B", "D", "C", "2", "3")


def toggle_press(d):
    d.crank("1")
    for sheet in PLANS:
        d.two_links(sheet, "B", "D", "C", "2", "3")
        d.guided(sheet, "C", "E", "4", "5/ground")


def two_sliders(d):
    d.crank("1")
    for sheet in PLANS:
        d.guided(sheet, "B", "C", "2", "3/ground")
        d.third(sheet, "B", "C", "E", "2")
        d.guided(sheet, "E", "F", "4", "5/ground")


def dyad_rrr(d):
    d.known("B")
    d.known("D")
    for sheet in PLANS:
        d.two_links(sheet, "B", "D", "C", "2", "3")


def dyad_rrp(d):
    d.known("B")
    for sheet in PLANS:
        d.guided(sheet, "B", "C", "2", "3/ground")


def dyad_rpr(d):
    d.known("B")
    d.known("D")
    for sheet in PLANS:
        d.slot(sheet, "D", "B", "3", "2/3", block="2")
        d.third(sheet, "D", "B", "C", "3", image_c="b_3")


def dyad_prp(d):
    d.known("A")
    for sheet in PLANS:
        under = "c_1"
        start, link = d.image(sheet, "A"), "1"
        end = Amount(f"{'alpha' if sheet == ACCELERATION else 'omega'}(1)", d.length("A", "C"), style=d.style)
        role = "tangential" if sheet == ACCELERATION else "relative"
        if sheet == ACCELERATION:
            start = d.normal_part("A", "C", link, start=start, name=d.own("n"), at=under)
        d.lay_off(role, sheet, under, start, end, {"normal": d.ref("A", "C")}, link=link)
        d.expect(sheet, under, "1", d.m.at["C"])
        one_start, plain = under, None
        if sheet == ACCELERATION:
            plain, one_start = under, d.coriolis("k_c_12", under, link, "2/1", 1, "C")
        one = d.ray("guide-ray", sheet, one_start, {"parallel": "2/1"}, plain=plain, part="coriolis", slider="2/1")
        two = d.ray("guide-ray", sheet, POLE[sheet], {"parallel": "3/ground"}, plain=None, part=None, slider="3/ground")
        d.cross(sheet, "c", [one, two])
        moves, slides = (d.m.v, d.m.v_r) if sheet == VELOCITY else (d.m.a, d.m.a_r)
        d.expected[f"{sheet}:c"] = moves["C"]
        d.slides(sheet, "2/1", one_start, "c", slides["2/1"])
        d.slides(sheet, "3/ground", POLE[sheet], "c", slides["3/ground"])
        d.third(sheet, "A", "C", "B", "1", image_c=under)


def dyad_rpp(d):
    d.known("B")
    for sheet in PLANS:
        one = d.ray("guide-ray", sheet, POLE[sheet], {"parallel": "3/ground"}, plain=None, part=None, slider="3/ground")
        start = d.image(sheet, "B")
        two = d.ray("guide-ray", sheet, start, {"parallel": "2/3"}, plain=None, part=None, slider="2/3")
        d.cross(sheet, "b_3", [one, two])
        slides = d.m.v_r if sheet == VELOCITY else d.m.a_r
        d.expect(sheet, "b_3", "3", d.m.at["B"])
        d.slides(sheet, "3/ground", POLE[sheet], "b_3", slides["3/ground"])
        d.slides(sheet, "2/3", start, "b_3", slides["2/3"])


def hydraulic_boom(d):
    for sheet in PLANS:
        d.cylinder(sheet, "A", "C", "O", "2", "3", "4", "3/2")
        d.relative(sheet, "A", "B", "2")
        d.relative(sheet, "C", "D", "3")
        d.third(sheet, "O", "C", "E", "4")


def third_class(d):
    d.crank("1")
    sides = [Side("B", "C", "2", "S24", "3"), Side("F", "D", "4", "S24", "3"), Side("B", "C", "2", "S25", "3"), Side("G", "E", "5", "S25", "3")]
    d.special_points(sides)
    for sheet in PLANS:
        d.special(sheet, sides)
        d.relative(sheet, "B", "C", "2")
        d.relative(sheet, *d.rng.choice([("F", "D", "4"), ("C", "D", "3")]))
        d.third(sheet, "C", "D", "E", "3")


def platform(d):
    for link in "123":
        d.crank(link)
    sides = [Side("B1", "C1", "4", "S45", "7"), Side("B2", "C2", "5", "S45", "7"),
             Side("B1", "C1", "4", "S46", "7"), Side("B3", "C3", "6", "S46", "7")]
    d.special_points(sides)
    for sheet in PLANS:
        d.special(sheet, sides)
        for joint, link in zip("123", "456"):
            d.relative(sheet, f"B{joint}", f"C{joint}", link)


FOURTH = [Side("B", "C", "2", "S3", "3"), Side("E", "D", "4", "S3", "3"), Side("B", "G", "2", "S5", "5"), Side("E", "F", "4", "S5", "5")]


def fourth_class(d, start=None):
    start(d) if start else d.crank("1")
    d.special_points(FOURTH)
    for sheet in PLANS:
        d.special(sheet, FOURTH)
        d.relative(sheet, "B", "C", "2")
        d.relative(sheet, *d.rng.choice([("E", "D", "4"), ("C", "D", "3")]))
        d.third(sheet, "B", "C", "G", "2")
        d.relative(sheet, *d.rng.choice([("E", "F", "4"), ("G", "F", "5")]))


def figure_1(d):
    def start(d):
        d.known("B")
        d.known("E")
    fourth_class(d, start)


def figure_2(d):
    d.crank("1")
    sides = [Side("B", None, "2", "S3", "3", slider="3/2"), Side("G", "D", "4", "S3", "3"), Side("B", "E", "2", "S5", "5"),
             Side("G", "F", "4", "S5", "5")]
    d.special_points(sides)
    for sheet in PLANS:
        d.special(sheet, sides, same=("3", "2"))
        d.relative(sheet, "G", "D", "4")
        d.relative(sheet, "B", "E", "2")
        d.third(sheet, "G", "D", "F", "4")


KINDS = {"four-bar": four_bar, "slider-crank": slider_crank, "slotted-lever": slotted_lever, "whitworth": whitworth,
         "toggle-press": toggle_press, "hydraulic-boom": hydraulic_boom, "watt-1": watt, "stephenson-3": stephenson, "five-bar": five_bar,
         "third-class": third_class, "fourth-class": fourth_class, "platform-3rrr": platform, "dyad-rrr": dyad_rrr, "dyad-rrp": dyad_rrp,
         "dyad-rpr": dyad_rpr, "dyad-prp": dyad_prp, "dyad-rpp": dyad_rpp, "paper-figure-1": figure_1, "paper-figure-2": figure_2}
EXAMPLES = {"figure-1": figure_1, "figure-2": figure_2}
LECTURE = {"coupler-point": four_bar_with_point, "engine": slider_crank_with_point, "offset": slider_crank, "oscillating-block": inverted,
           "shaper": shaper, "watt": watt, "stephenson": stephenson, "three-legs": third_class, "two-sliders": two_sliders,
           "oscillating-cylinder": hydraulic_boom}


class Case:
    """A scene with what is drawn of it."""

    def __init__(self, group, name, path, construct):
        self.group, self.name, self.path, self.construct = group, name, Path(path), construct
        self.scene = json.loads(self.path.read_text("utf-8"))
        self.mechanism = Mechanism(self.scene)

    def draft(self, rng):
        mechanism = Mechanism.__new__(Mechanism)
        mechanism.__dict__.update(self.mechanism.__dict__, at=dict(self.mechanism.at))
        d = Cylinder(mechanism, rng)
        self.construct(d)
        return d


def cases(kinegon, folder, exercises=3, only=()):
    """All scenes: of each kind the template and some exercises, the two figures, the students' scenes, the lecture's."""
    out = []

    def add(group, name, path, construct):
        if not only or any(word in name for word in only):
            out.append(Case(group, name, path, construct))

    for kind, construct in KINDS.items():
        template = ROOT / "templates" / f"{kind}.json"
        if template.exists():
            add("template", kind, template, construct)
        if exercises:
            names = [Path(folder) / f"{kind}-3-{i + 1}" for i in range(exercises)]
            if not all((name / "scene.json").exists() for name in names):
                subprocess.run([kinegon, "exercise", kind, "--seed", "3", "--count", str(exercises), "-o", str(folder)], check=True,
                               stdout=subprocess.DEVNULL)
            for name in names:
                add("exercise", name.name, name / "scene.json", construct)
    for name, construct in EXAMPLES.items():
        add("figure", name, ROOT / "examples" / f"{name}.json", construct)
    for path in sorted((ROOT / "tests/students/scenes").glob("*/scene.json")):
        add("students", f"students-{path.parent.name}", path, KINDS[path.parent.name.rsplit("-", 2)[0]])
    for name, construct in LECTURE.items():
        add("lecture", name, HERE / "scenes" / f"{name}.json", construct)
    return out
