#!/usr/bin/env python3
"""What `kinegon check` makes of photographs that Kinegon did not take.

    python3 photos.py KINEGON FOLDER          takes photographs into FOLDER, and has them checked; what is there already is not taken again
    python3 photos.py KINEGON FOLDER --count 20 --only four-bar

By turns each of five mechanisms is drawn on the sheets of an exercise (hand.py, pencil.py), three of four with a mistake in the drawing, and photographed
(camera.py). Told are: photographs that are read; points of the plans proposed within 0.5 mm of where they are, elsewhere, and left to the student; circles that hold
their point; and of the sheets with mistakes, how many are named from the typed form and from the points in place of the plans' segments, those that are left
tapped; and how many with a mistake are "all correct". Needs numpy, Pillow and pdftoppm."""
import argparse
import json
import os
import random
import re
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np
from PIL import Image

import cases
import judge
from camera import Camera
from hand import MECHANISMS, Hand, draw, form
from mistakes import at, forgotten, opposite, quarter_back, times, turned
from pencil import Page, draw_plan

PER_MM = 14
# A tap that meets no crossing is within so many mm, and says so.
TAPPED = 0.5
SAME, WRONG = 0.5, 1.5
HANDS = [dict(mm=0.2, degrees=0.2, read_mm=0.1, digits=4), dict(mm=0.3, degrees=0.3, read_mm=0.5, digits=4), dict(mm=0.5, degrees=0.5, read_mm=0.5, digits=3)]
# Mistakes in what is drawn, for mechanisms of which cases.py has none.
ACTS = [
    {"v_B direction": opposite}, {"v_B direction": quarter_back}, {"a_B direction": opposite}, {"a_B direction": turned(-20)},
    {"v_B": times(0.6)}, {"a_B normal": times(1.4)}, {"normal 3": forgotten}, {"normal 3 direction": opposite}, {"normal 3": times(0.7)},
    {"velocity ray 3": turned(25)}, {"velocity ray 3": quarter_back}, {"acceleration ray 3": turned(-30)}, {"acceleration ray 3": quarter_back},
    {"coriolis": forgotten}, {"coriolis direction": opposite}, {"coriolis": times(0.5)}, {"velocity ray slot": turned(15)},
    {"acceleration ray slot": quarter_back}, {"normal 2 direction": opposite}, {"normal 4": forgotten}, {"normal 5 direction": opposite},
    {"velocity ray 4": turned(20)}, {"acceleration ray 5": turned(-25)}, {"acceleration ray 3 from": at("acceleration", "π")},
]


class Sheet:
    """A student's drawing of an exercise."""

    def __init__(self, number, mechanism, folder):
        self.number, self.mechanism, self.folder = number, mechanism, folder
        self.lot = random.Random(f"sheet {number}")
        self.hand = HANDS[number % 3]
        self.case = None
        self.scene = json.loads((folder / "scene.json").read_text("utf-8"))
        self.acts, self.drawing = {}, self.drawn({})
        if self.lot.random() < 0.75:
            self.make_mistake()

    def drawn(self, acts):
        return draw(self.mechanism, self.scene, Hand(**self.hand, seed=self.number), acts)

    def make_mistake(self):
        """Draws with the first mistake, by lot, that this mechanism can have, that moves points, and with which the plans stay on their sheets."""
        own = [case for case in cases.CASES if case.mechanism == self.mechanism and self.folder.name.startswith(case.scenes) and changes_plans(case.acts)]
        planned = [(case, case.acts) for case in own] or [(None, acts) for acts in ACTS]
        for case, acts in self.lot.sample(planned, len(planned)):
            try:
                drawing = self.drawn(acts)
            except (ValueError, ZeroDivisionError, KeyError):
                continue
            if farthest(self.drawing, drawing) > 3.0 and not off_sheet(self.folder, drawing):
                self.case, self.acts, self.drawing = case, acts, drawing
                return


def farthest(one, other):
    """How far images of two drawings are from each other at most, in mm."""
    return max(abs(one_plan.at(name) - other_plan.at(name)) for one_plan, other_plan in zip(one.plans, other.plans) for name in one_plan.images)


def changes_plans(acts):
    """Whether acts change what is drawn, and not only what is read, written or computed; scales stay as they are printed."""
    return not any(act.startswith(("mu_", "write", "measure", "alpha")) for act in acts)


def poles(svg):
    """The page's size and the places of the poles on it, in mm, by plan."""
    size = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', svg)
    found = re.findall(r'id="(velocity|acceleration)-point-(?:p|pi)" cx="([\d.]+)" cy="([\d.]+)"', svg)
    return (float(size[1]), float(size[2])), {plan: (float(x), float(y)) for plan, x, y in found}


def take(sheet, folder, edge):
    """The photographs of a student's sheets with plans: their paths."""
    paths = []
    for number, svg in enumerate(sorted(sheet.folder.glob("sheet*.svg"), key=lambda path: (len(path.name), path.name)), 1):
        size, at_poles = poles(svg.read_text("utf-8"))
        if not at_poles:
            continue
        path = folder / f"{sheet.number:03d}-{len(paths) + 1}.jpg"
        paths.append(path)
        if path.exists():
            continue
        printed = folder / f"{sheet.folder.name}-{svg.stem}.png"
        if not printed.exists():
            own = printed.with_name(f"{printed.stem}-{os.getpid()}")
            page = ["-f", str(number), "-l", str(number), "-singlefile"]
            subprocess.run(["pdftoppm", "-png", "-gray", "-r", str(25.4 * PER_MM), *page, str(sheet.folder / "sheet.pdf"), str(own)], check=True)
            Path(f"{own}.png").rename(printed)
        dark = 0.92 * (1 - np.asarray(Image.open(printed).convert("L")).astype(np.float32) / 255)
        page = Page(dark, PER_MM, 10 * sheet.number + len(paths))
        for plan in sheet.drawing.plans:
            if plan.name in at_poles:
                draw_plan(page, plan, at_poles[plan.name])
        path.write_bytes(Camera(f"{sheet.number} {len(paths)}", size, edge).take(page.dark, PER_MM))
    return paths


def off_sheet(folder, drawing):
    """Whether a plan leaves its sheet."""
    for svg in folder.glob("sheet*.svg"):
        (width, height), at_poles = poles(svg.read_text("utf-8"))
        for plan in drawing.plans:
            if plan.name in at_poles:
                x, y = at_poles[plan.name]
                for place in plan.images.values():
                    if not (17 < x + place.real < width - 17 and 17 < y - place.imag < height - 17):
                        return True
    return False


def run(kinegon, number, args):
    mechanism = args.kinds[number % len(args.kinds)]
    exercise = f"{mechanism}-7-{1 + number // len(args.kinds) % 4}"
    sheet = Sheet(number, mechanism, args.folder / "exercises" / exercise)
    told = dict(number=number, mechanism=mechanism, mistake=sheet.case.text if sheet.case else ", ".join(sheet.acts), points=[], read=0, photographs=0, refused="")
    photos = take(sheet, args.folder, args.edge)
    told["photographs"] = len(photos)
    scene = sheet.folder / "scene.json"
    out = args.folder / args.forms / f"{number:03d}"
    out.mkdir(parents=True, exist_ok=True)
    ran = subprocess.run([kinegon, "check", str(scene), *map(str, photos), "-o", str(out)], capture_output=True, text=True, encoding="utf-8")
    if ran.returncode not in (0, 1):
        told["refused"] = ran.stderr.strip().split("\n")[0]
        return told
    told["read"] = len(photos)
    proposed = json.loads((out / f"{number:03d}.json").read_text("utf-8"))
    exact = {plan.name: plan for plan in draw(mechanism, json.loads(scene.read_text("utf-8")), Hand()).plans}
    typed = form(sheet.drawing)
    tapped = dict(typed, values={name: value for name, value in typed["values"].items() if "plan(" not in name}, points={})
    for plan in sheet.drawing.plans:
        found, own, taps = proposed.get("points", {}).get(plan.name, {}), {}, sheet.lot
        for name, place in plan.images.items():
            if name == plan.pole or place == 0:
                continue
            where, right = found.get(name), exact[plan.name].at(name)
            told["points"].append(dict(
                plan=plan.name, name=name, off=abs(complex(*where[:2]) - place) if where else None, band=where[2] if where else None,
                moved=abs(place - right), beside_right=abs(complex(*where[:2]) - right) if where else None))
            own[name] = where or [round(place.real + taps.uniform(-0.35, 0.35), 2), round(place.imag + taps.uniform(-0.35, 0.35), 2), TAPPED]
        own[plan.pole] = found.get(plan.pole, [0, 0, 0.1])
        tapped["points"][plan.name] = own
    if sheet.acts:
        for key, filled in (("typed", typed), ("tapped", tapped), ("accepted", proposed)):
            if key == "accepted" and not any(len(points) > 1 for points in filled.get("points", {}).values()):
                told[key], told[key + " correct"] = "not flagged", False
                continue
            result = judge.check(kinegon, scene, filled)
            told[key] = judge.judge(sheet.case, result) if sheet.case else ""
            told[key + " correct"] = result["passed"] and not result.get("missing")
    return told


def exercises(kinegon, folder, kinds):
    for kind in kinds:
        if not (folder / "exercises" / f"{kind}-7-1").exists():
            subprocess.run([kinegon, "exercise", kind, "--seed", "7", "--count", "4", "-o", str(folder / "exercises")], check=True, stdout=subprocess.DEVNULL)


def percent(part, whole):
    return f"{100 * part / max(whole, 1):.1f} %"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kinegon", metavar="KINEGON")
    parser.add_argument("folder", metavar="FOLDER", type=lambda text: Path(text).resolve())
    parser.add_argument("--count", type=int, default=150, help="students; most have two photographs (default: 150)")
    parser.add_argument("--first", type=int, default=0, help="number of the first student")
    parser.add_argument("--edge", type=int, default=2600, help="pixels of a picture's longer side (default: 2600)")
    parser.add_argument("--forms", default="forms", help="where in the folder forms and pictures go (default: forms)")
    parser.add_argument("--only", default="", help="only mechanisms with this in their names")
    parser.add_argument("--all", action="store_true", help="tell of each point that is elsewhere")
    parser.add_argument("--json", type=Path, help="write all of it here")
    args = parser.parse_args()
    args.kinds = [kind for kind in MECHANISMS if args.only in kind]
    args.folder.mkdir(parents=True, exist_ok=True)
    exercises(args.kinegon, args.folder, args.kinds)
    with ProcessPoolExecutor(min(2, os.cpu_count())) as pool:
        told = list(pool.map(run, [args.kinegon] * args.count, range(args.first, args.first + args.count), [args] * args.count))
    if args.json:
        args.json.write_text(json.dumps(told, ensure_ascii=False, indent=1) + "\n", "utf-8")
    report(told, args.all)


def report(told, is_long):
    photographs, read = (sum(one[key] for one in told) for key in ("photographs", "read"))
    print(f"{len(told)} students, {photographs} photographs, {read} read")
    for one in told:
        if one["refused"]:
            print(f"  {one['number']:03d} {one['refused']}")
    for kind in [*MECHANISMS, ""]:
        points = [point for one in told if kind in one["mechanism"] for point in one["points"]]
        if not points:
            continue
        found = [point for point in points if point["off"] is not None]
        right = sum(point["off"] <= SAME for point in found)
        gross = [point for point in found if point["off"] > WRONG]
        answers = sum(point["beside_right"] <= WRONG for point in gross)
        moved = [point for point in points if point["moved"] > 2.0]
        own = [point for point in moved if point["off"] is not None]
        print(f"{kind or 'all':14} {len(points):5} points: proposed {percent(right, len(points))}, elsewhere {percent(len(found) - right, len(points))} "
              f"(gross {len(gross)}, of these the right plan's {answers}), circles hold {percent(sum(p['off'] <= p['band'] for p in found), len(found))}; "
              f"of {len(moved)} that a mistake moved {percent(sum(p['off'] <= SAME for p in own), len(moved))}")
    if is_long:
        for one in told:
            for point in one["points"]:
                if point["off"] is not None and point["off"] > SAME:
                    print(f"  {one['number']:03d} {one['mechanism']} {point['plan']} {point['name']}: {point['off']:.1f} mm off, moved {point['moved']:.1f}, "
                          f"beside the right {point['beside_right']:.1f}; {one['mistake']}")
    judged = [one for one in told if one.get("typed")]
    for key in ("typed", "tapped", "accepted"):
        print(f"{key:9} of {len(judged)} with a mistake named {percent(sum(one[key] == 'named' for one in judged), len(judged))}, "
              f"wrong {percent(sum('wrong' in one[key] for one in judged), len(judged))}; "
              f"all correct with a mistake: {sum(bool(one.get(key + ' correct')) for one in told)} of {sum('typed' in one for one in told)}")


if __name__ == "__main__":
    sys.exit(main())
