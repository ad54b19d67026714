#!/usr/bin/env python3
"""What `kinegon check` makes of photographs of figures of instant centres that Kinegon did not take.

    python3 center_photos.py KINEGON FOLDER [--count 30] [--first 0] [--edge 2600]

Mechanisms and hands are those of centers.py: each draws the pole lines on the printed sheet of its scene (pencil.py), two of three with a mistake in its lines, and the sheet is
photographed (camera.py). Told are: photographs that are read; centres proposed within 0.5 mm of where they are, elsewhere, and left to the student; circles that hold their
centre; what is said of honest sheets; and how many mistakes are named from all centres, those that are left tapped. Needs numpy, Pillow and pdftoppm."""
import argparse
import json
import math
import os
import random
import re
import subprocess
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np
from PIL import Image

from camera import Camera
from centers import KINDS, Sheet, Stuck, distance, drawable, is_far, place
from pencil import Page
from survey import check

PER_MM = 14
SAME, WRONG = 0.5, 1.5
MISTAKES = [None, "lines-without-common-link", "centre-along-guide", None, "not-extended", "centre-at-slider"]


class Drawn(Sheet):
    """A hand's sheet that keeps its lines with the centre that each leads to; joints are printed, so a ruler lies at them as well as a hand can see."""

    def __init__(self, *args, **named):
        self.drawn = []
        super().__init__(*args, **named)

    def find(self, target, over):
        before = len(self.segments)
        super().find(target, over)
        for ends, line in self.segments[before:]:
            on = [place(p) for p in ends if p is not None]
            self.drawn.append((on, line, place(self.known[target]) if not is_far(self.known[target]) else None))


def origin(svg, mechanism, mu):
    """The page's size and where the scene's point (0, 0) is on it, in mm, by a printed joint."""
    size = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', svg)
    for name, (x, y) in mechanism.points.items():
        at = re.search(rf'id="centers-point-{name}"[^>]* cx="([\d.]+)" cy="([\d.]+)"', svg)
        if at:
            return (float(size[1]), float(size[2])), (float(at[1]) - x / mu, float(at[2]) + y / mu)
    return (float(size[1]), float(size[2])), None


def draw(page, sheet, at, lot):
    """Draws the pole lines and marks the centres."""
    def on(xy):
        return at[0] + xy[0], at[1] - xy[1]

    for ends, (a, b, c), crossing in sheet.drawn:
        length = math.hypot(a, b)
        along = (-b / length, a / length)
        # Lines that are not drawn far enough end where they should be crossed.
        is_on = crossing is not None and abs(a * crossing[0] + b * crossing[1] + c) / length < 2
        marks = [p for p in [*ends, crossing if is_on else None] if p is not None]
        start = marks[0]
        reach = [(p[0] - start[0]) * along[0] + (p[1] - start[1]) * along[1] for p in marks]
        low, high = min(reach) - lot.uniform(1, 7), max(reach) + lot.uniform(3, 12)
        page.line(on((start[0] + low * along[0], start[1] + low * along[1])), on((start[0] + high * along[0], start[1] + high * along[1])), pressure=lot.uniform(0.65, 0.95))
    for target, found in sheet.known.items():
        if target not in sheet.pins and not is_far(found):
            spot = on(place(found))
            if lot.random() < 0.6:
                page.dot(spot)
            page.written("".join(target), spot)


def run(kinegon, number, args):
    lot = random.Random(f"centres {number}")
    kind, mistake = KINDS[number % len(KINDS)], MISTAKES[number // len(KINDS) % len(MISTAKES)]
    folder = args.folder / f"{number:03d}"
    folder.mkdir(parents=True, exist_ok=True)
    told = dict(number=number, kind=kind.__name__, mistake=mistake, points=[], refused="")
    for attempt in range(8):
        mechanism, mu, ways, form, names, _ = drawable(kind, lot, kinegon, folder)
        perfect = Sheet(mechanism, mu, ways, random.Random(1), size=0.0)
        right = [place(p) for p in perfect.known.values() if not is_far(p)]
        sheet = None
        for _ in range(30):
            try:
                sheet = Drawn(mechanism, mu, ways, lot, mistake, right=right)
            except (Stuck, StopIteration, ZeroDivisionError):
                continue
            if mistake is None or sheet.made:
                break
            sheet = None
        if sheet is not None:
            break
    if sheet is None:
        told["mistake"], sheet = None, Drawn(mechanism, mu, ways, lot)
    own = [place(p) for t, p in sheet.known.items() if not is_far(p)]
    subprocess.run([kinegon, "draw", str(folder / "scene.json"), "--worksheet=blank", "-o", str(folder / "sheet.pdf")], check=True, capture_output=True)
    subprocess.run([kinegon, "draw", str(folder / "scene.json"), "--worksheet=blank", "-o", str(folder / "sheet.svg")], check=True, capture_output=True)
    pages = sorted(folder.glob("sheet*.svg"), key=lambda path: (len(path.name), path.name))
    for index, svg in enumerate(pages, 1):
        size, at = origin(svg.read_text("utf-8"), mechanism, mu)
        if at:
            break
    else:
        told["refused"] = "no sheet for centres"
        return told
    if any(not (17 < at[0] + x < size[0] - 17 and 17 < at[1] - y < size[1] - 17) for x, y in own):
        told["refused"] = "off the sheet"
        return told
    photo = folder / "student-1.jpg"
    if not photo.exists():
        subprocess.run(["pdftoppm", "-png", "-gray", "-r", str(25.4 * PER_MM), "-f", str(index), "-l", str(index), "-singlefile", str(folder / "sheet.pdf"), str(folder / "printed")], check=True)
        dark = 0.92 * (1 - np.asarray(Image.open(folder / "printed.png").convert("L")).astype(np.float32) / 255)
        page = Page(dark, PER_MM, number)
        draw(page, sheet, at, page.random)
        photo.write_bytes(Camera(f"centres {number}", size, args.edge).take(page.dark, PER_MM))
        (folder / "printed.png").unlink()
    ran = subprocess.run([kinegon, "check", str(folder / "scene.json"), str(photo), "-o", str(folder / args.out)], capture_output=True, text=True)
    if ran.returncode not in (0, 1):
        told["refused"] = ran.stderr.strip().split("\n")[0]
        return told
    (folder / args.out / "said.txt").write_text(ran.stdout + ran.stderr)
    proposed = json.loads((folder / args.out / "student.json").read_text("utf-8"))
    found = proposed.get("points", {}).get("centers", {})
    first = next(iter(mechanism.points))
    base = [x / mu for x in mechanism.points[first]]
    places = {first: found.get(first, [0, 0, 0.1])}
    name = lambda t: f"P({t[1]},ground)" if t[0] == "0" else f"P({t[0]},{t[1]})"
    for target, drawn in sheet.known.items():
        if target in sheet.pins or is_far(drawn) or name(target) + ".x" not in names:
            continue
        x, y = (own - start for own, start in zip(place(drawn), base))
        exact = [own - start for own, start in zip(place(perfect.known[target]), base)]
        where = found.get(name(target))
        told["points"].append(dict(name=name(target), off=math.hypot(where[0] - x, where[1] - y) if where else None, band=where[2] if where else None,
                                   moved=math.hypot(exact[0] - x, exact[1] - y), beside_right=math.hypot(where[0] - exact[0], where[1] - exact[1]) if where else None))
        places[name(target)] = where or [round(x + lot.uniform(-0.35, 0.35), 2), round(y + lot.uniform(-0.35, 0.35), 2), SAME]
    for key, points in (("tapped", places), ("accepted", found)):
        if len(points) < 2:
            told[key] = "nothing"
            continue
        filled = {"kinegon_measured": 1, "mu_c": mu, "upright": True, "values": {}, "points": {"centers": points}}
        path = folder / args.out / f"{key}.json"
        path.write_text(json.dumps(filled))
        result, refused = check(kinegon, folder / "scene.json", path)
        if result is None:
            told[key] = refused.strip()
            continue
        mistakes = [m["mistake"] for m in result["diagnosis"]["mistakes"]]
        off = sum(v["verdict"] == "off" for v in result["values"])
        told[key] = "named" if mistakes and all(m == told["mistake"] for m in mistakes) else "unknown" if mistakes == ["unknown"] else " + ".join(mistakes) or ("off" if off else "right")
    return told


def percent(part, whole):
    return f"{100 * part / max(whole, 1):.1f} %"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kinegon", metavar="KINEGON")
    parser.add_argument("folder", metavar="FOLDER", type=lambda text: Path(text).resolve())
    parser.add_argument("--count", type=int, default=30)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--edge", type=int, default=2600, help="pixels of a picture's longer side (default: 2600)")
    parser.add_argument("--out", default="out")
    args = parser.parse_args()
    with ProcessPoolExecutor(min(2, os.cpu_count())) as pool:
        told = list(pool.map(run, [args.kinegon] * args.count, range(args.first, args.first + args.count), [args] * args.count))
    read = [one for one in told if not one["refused"]]
    print(f"{len(told)} students, {len(read)} read")
    for one in told:
        if one["refused"]:
            print(f"  {one['number']:03d} {one['kind']}: {one['refused']}")
    points = [(one, point) for one in read for point in one["points"]]
    found = [(one, point) for one, point in points if point["off"] is not None]
    right = [point for _, point in found if point["off"] <= SAME]
    gross = [(one, point) for one, point in found if point["off"] > WRONG]
    moved = [point for _, point in points if point["moved"] > 2.0]
    print(f"{len(points)} centres: proposed {percent(len(right), len(points))}, elsewhere {percent(len(found) - len(right), len(points))} (gross {len(gross)}, of these the right "
          f"figure's {sum(point['beside_right'] <= WRONG for _, point in gross)}), circles hold {percent(sum(point['off'] <= point['band'] for _, point in found), len(found))}; of {len(moved)} "
          f"that a mistake moved {percent(sum(point['off'] is not None and point['off'] <= SAME for point in moved), len(moved))}")
    for one, point in found:
        if point["off"] > SAME:
            print(f"  {one['number']:03d} {one['kind']} {point['name']}: {point['off']:.1f} mm off, moved {point['moved']:.1f}, beside the right {point['beside_right']:.1f}; {one['mistake']}")
    for key in ("tapped", "accepted"):
        honest = Counter(one[key] for one in read if one["mistake"] is None)
        wrong = Counter(one[key] for one in read if one["mistake"] is not None)
        print(f"{key}: honest {dict(honest)}; with a mistake {dict(wrong)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
