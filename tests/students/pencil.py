"""A pencil on printed sheets: what a hand has constructed (hand.py) as grey on paper.

Lines waver and their pressure changes; the grain of the paper shows in them. Rays are drawn past their crossings, vectors have arrowheads with legs of
unequal length, points a dot, and letters stand beside them; some lines were begun wrongly and rubbed out. Needs numpy.

A `Page` is darkness by pixel, 0 white to 1 black, `per_mm` pixels for a millimetre; places are millimetres from the upper left corner, y down.
"""
import math
import random

import numpy as np

# Strokes of letters, in a box of width 0.7 and height 1, y down.
LETTERS = {
    "b": [[(0.1, 0), (0.1, 1), (0.45, 1), (0.6, 0.8), (0.45, 0.55), (0.1, 0.6)]],
    "c": [[(0.6, 0.55), (0.35, 0.45), (0.1, 0.7), (0.3, 1), (0.6, 0.9)]],
    "d": [[(0.6, 0), (0.6, 1)], [(0.6, 0.6), (0.3, 0.5), (0.1, 0.75), (0.3, 1), (0.6, 0.9)]],
    "e": [[(0.1, 0.75), (0.6, 0.7), (0.4, 0.45), (0.1, 0.7), (0.3, 1), (0.6, 0.9)]],
    "f": [[(0.6, 0.1), (0.4, 0), (0.3, 0.2), (0.3, 1)], [(0.1, 0.5), (0.55, 0.45)]],
    "g": [[(0.6, 0.5), (0.3, 0.45), (0.1, 0.65), (0.3, 0.85), (0.6, 0.75)], [(0.6, 0.45), (0.6, 1.1), (0.3, 1.25), (0.1, 1.1)]],
    "k": [[(0.1, 0), (0.1, 1)], [(0.5, 0.4), (0.1, 0.7), (0.55, 1)]],
    "n": [[(0.1, 0.45), (0.1, 1)], [(0.1, 0.65), (0.35, 0.45), (0.55, 0.6), (0.55, 1)]],
}
OTHER = [[(0.1, 0.5), (0.5, 0.5), (0.1, 1), (0.5, 1)]]


class Page:
    """A printed sheet that is drawn on."""

    def __init__(self, dark, per_mm, seed):
        self.dark, self.per_mm = dark, per_mm
        self.random, self.noise = random.Random(f"pencil {seed}"), np.random.default_rng(seed)
        # The tooth of the paper, on which the pencil leaves more or less.
        grain = self.noise.random((256, 256), dtype=np.float32)
        self.grain = (grain + np.roll(grain, 1, 0) + np.roll(grain, 1, 1)) / 3
        self.width, self.pressure = self.random.uniform(0.28, 0.5), self.random.uniform(0.42, 0.75)
        self.arrow = self.random.uniform(2.2, 4.2)
        self.letter = self.random.uniform(3.0, 4.6)

    def piece(self, start, end, width, dark):
        """A short straight piece with round ends."""
        k = self.per_mm
        (x0, y0), (x1, y1) = ((x * k, y * k) for x, y in (start, end))
        half = width * k / 2
        height, wide = self.dark.shape
        left, right = max(0, int(min(x0, x1) - half - 2)), min(wide, int(max(x0, x1) + half + 3))
        top, bottom = max(0, int(min(y0, y1) - half - 2)), min(height, int(max(y0, y1) + half + 3))
        if left >= right or top >= bottom:
            return
        x, y = np.meshgrid(np.arange(left, right) + 0.5, np.arange(top, bottom) + 0.5)
        dx, dy = x1 - x0, y1 - y0
        share = np.clip(((x - x0) * dx + (y - y0) * dy) / max(dx * dx + dy * dy, 1e-9), 0, 1)
        away = np.hypot(x - x0 - share * dx, y - y0 - share * dy)
        tooth = self.grain[np.ix_(np.arange(top, bottom) % 256, np.arange(left, right) % 256)]
        # Less at the line's edge than in its middle.
        covered = np.clip((half - away) / max(0.6 * half, 1) + 0.2, 0, 1) * np.clip(dark * (1.6 - 1.5 * tooth), 0, 1)
        own = self.dark[top:bottom, left:right]
        np.maximum(own, covered, out=own)

    def line(self, start, end, pressure=1.0, waver=0.03, width=1.0):
        """A line by the ruler, in mm: a little off at both ends, with slow changes of pressure."""
        start, end = complex(*start), complex(*end)
        length = abs(end - start)
        if length < 1e-6:
            return
        across = 1j * (end - start) / length
        offset = [self.random.gauss(0, waver) for _ in range(2)]
        bow, phase = self.random.gauss(0, 0.6 * waver), self.random.uniform(0, 6)
        count = max(1, int(length / 0.8))

        def at(share):
            aside = offset[0] * (1 - share) + offset[1] * share + bow * math.sin(math.pi * share)
            here = start + (end - start) * share + across * (aside + 0.012 * math.sin(phase + 1.7 * share * length))
            return here.real, here.imag

        for i in range(count):
            now = self.pressure * pressure * (1 + 0.15 * math.sin(phase + 0.13 * i) + self.random.gauss(0, 0.06))
            self.piece(at(i / count), at((i + 1) / count), self.width * width * self.random.uniform(0.9, 1.1), min(now, 0.95))

    def arrowhead(self, start, end):
        """Two legs at a vector's end; where the vector is short they are, too."""
        start, end = complex(*start), complex(*end)
        length = abs(end - start)
        if length < 2:
            return
        back = (start - end) / length
        for side in (-1, 1):
            turn = side * math.radians(self.random.uniform(13, 27))
            leg = end + back * complex(math.cos(turn), math.sin(turn)) * min(self.arrow, 0.5 * length) * self.random.uniform(0.8, 1.15)
            tip = end + complex(self.random.gauss(0, 0.08), self.random.gauss(0, 0.08))
            self.line((tip.real, tip.imag), (leg.real, leg.imag), waver=0.05)

    def dot(self, at):
        self.piece(at, (at[0] + 0.01, at[1]), self.random.uniform(0.5, 0.9), min(0.95, 1.2 * self.pressure))

    def written(self, name, at):
        """A point's name beside it, in hasty letters; indices are smaller and lower."""
        turn, away = self.random.uniform(0, 2 * math.pi), self.random.uniform(1.5, 4.5)
        x, y = at[0] + away * math.cos(turn), at[1] + away * math.sin(turn) - 0.6 * self.letter
        for number, character in enumerate(name.replace("_", "")):
            size = self.letter * (1 if number == 0 else 0.65) * self.random.uniform(0.9, 1.1)
            y += 0.35 * self.letter if number == 1 else 0
            lean = self.random.uniform(-0.15, 0.15)
            for stroke in LETTERS.get(character.lower(), OTHER):
                places = [(x + size * (u - lean * v), y + size * v) for u, v in stroke]
                for start, end in zip(places, places[1:]):
                    self.line(start, end, pressure=0.9, waver=0.06, width=0.85)
            x += 0.75 * size

    def rubbed_out(self, start, end):
        """A line that was drawn and rubbed out: a trace, and a smudge along it."""
        self.line(start, end, pressure=self.random.uniform(0.12, 0.3), width=1.2)
        a, b = complex(*start), complex(*end)
        for _ in range(max(1, int(abs(b - a) / 3))):
            middle = a + (b - a) * self.random.random() + complex(self.random.gauss(0, 1), self.random.gauss(0, 1))
            self.piece((middle.real, middle.imag), (middle.real + self.random.gauss(0, 2), middle.imag), self.random.uniform(2, 5), 0.035)


def draw_plan(page, plan, pole):
    """Draws a plan of hand.py whose pole is at that place of the page."""
    lot = page.random

    def on(place):
        return pole[0] + place.real, pole[1] - place.imag

    images = list(plan.images.items())
    places = [place for _, place in images]
    for start, angle in plan.rays:
        towards = complex(math.cos(angle), math.sin(angle))
        # As far as what lies on it, and past it.
        along = [((place - start) / towards) for place in places]
        reach = [a.real for a in along if abs(a.imag) < 1.0] + [0.0]
        low, high = min(reach) - lot.uniform(0, 9), max(reach) + lot.uniform(2, 22)
        page.line(on(start + low * towards), on(start + high * towards), pressure=lot.uniform(0.65, 0.95))
    for start, end in plan.sides:
        past = (end - start) / max(abs(end - start), 1e-9)
        page.line(on(start), on(end + past * lot.uniform(0, 6)), pressure=lot.uniform(0.6, 0.9))
    seen = []
    for start, end in plan.vectors:
        if abs(end - start) < 0.3 or any(abs(end - b) + abs(start - a) < 0.2 for a, b in seen):
            continue
        seen.append((start, end))
        page.line(on(start), on(end), pressure=1.1)
        if lot.random() < 0.9:
            page.arrowhead(on(start), on(end))
    for name, place in images:
        if name != plan.pole:
            if lot.random() < 0.6:
                page.dot(on(place))
            page.written(name, on(place))
    for _ in range(lot.choice((0, 0, 1, 2))):
        start = lot.choice(places)
        end = start + lot.uniform(20, 60) * complex(math.cos(lot.uniform(0, 6)), math.sin(lot.uniform(0, 6)))
        page.rubbed_out(on(start), on(end))
