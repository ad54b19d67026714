"""A camera over a sheet of paper: a lens with distortion, paper that is a little bent, light, shadow, blur, noise, JPEG.

It shares nothing with the program that reads its pictures, nor with the camera of that program's own tests. Needs numpy and Pillow.
"""
import io
import math
import random

import numpy as np
from PIL import Image, ImageFilter

# Every so many pixels the way of light is traced; between, it is interpolated.
COARSE = 16


class Camera:
    """How a picture is taken, by lot.

    edge  pixels of the picture's longer side
    """

    def __init__(self, seed, size_mm, edge=2600):
        lot = self.lot = random.Random(f"camera {seed}")
        self.seed, self.size_mm = seed, size_mm
        width, height = (edge, edge * 3 // 4) if size_mm[0] >= size_mm[1] else (edge * 3 // 4, edge)
        self.size = width, height
        self.focal = lot.uniform(0.68, 0.95) * edge
        self.distortion = lot.uniform(-0.06, 0.05), lot.uniform(-0.02, 0.02)
        self.axis = width / 2 + lot.gauss(0, 0.008) * edge, height / 2 + lot.gauss(0, 0.008) * edge
        # Curved about one axis by so many mm at the edge; sheets on a table seldom are.
        self.bow, self.bow_angle = lot.choice((0, 0, lot.uniform(-2, 2))), lot.uniform(0, math.pi)
        tilt, towards, roll = math.radians(lot.uniform(0, 18)), lot.uniform(0, 2 * math.pi), math.radians(lot.gauss(0, 4))
        self.turn = rotation(tilt * math.cos(towards), tilt * math.sin(towards), roll)
        # As near as the whole sheet, with an edge of table round it, is in the picture.
        self.away = 200.0
        while not self.sees_all():
            self.away *= 1.02

    def in_space(self, x, y):
        """Places on the sheet in mm to space; the camera is at the origin and looks along z."""
        x, y = x - self.size_mm[0] / 2, y - self.size_mm[1] / 2
        half = math.hypot(*self.size_mm) / 2
        u = (x * math.cos(self.bow_angle) + y * math.sin(self.bow_angle)) / half
        z = self.bow * u * u
        return [row[0] * x + row[1] * y + row[2] * z + (self.away if i == 2 else 0) for i, row in enumerate(self.turn)]

    def pixel(self, x, y):
        """Where places on the sheet, in mm, are in the picture."""
        a, b, c = self.in_space(x, y)
        u, v = a / c, b / c
        r = u * u + v * v
        bent = self.focal * (1 + r * (self.distortion[0] + r * self.distortion[1]))
        return self.axis[0] + bent * u, self.axis[1] + bent * v

    def sees_all(self):
        w, h = self.size_mm
        corners = [self.pixel(x, y) for x in (0, w / 2, w) for y in (0, h / 2, h)]
        return all(0.015 < x / self.size[0] < 0.985 and 0.015 < y / self.size[1] < 0.985 for x, y in corners)

    def paper(self, u, v):
        """Where the pixels are on the sheet, in mm, by Newton's steps."""
        x, y = np.full(u.shape, self.size_mm[0] / 2), np.full(u.shape, self.size_mm[1] / 2)
        for _ in range(12):
            pu, pv = self.pixel(x, y)
            ax, ay = self.pixel(x + 0.1, y)
            bx, by = self.pixel(x, y + 0.1)
            a, b, c, d = (ax - pu) * 10, (bx - pu) * 10, (ay - pv) * 10, (by - pv) * 10
            det = a * d - b * c
            x, y = x + (d * (u - pu) - b * (v - pv)) / det, y + (a * (v - pv) - c * (u - pu)) / det
        return x, y

    def take(self, dark, per_mm):
        """The picture of a page, darkness by pixel, as the bytes of a JPEG."""
        lot, noise = self.lot, np.random.default_rng(self.lot.randrange(1 << 30))
        width, height = self.size
        across, down = -(-width // COARSE) + 1, -(-height // COARSE) + 1
        u, v = np.meshgrid(np.arange(across) * COARSE, np.arange(down) * COARSE)
        x, y = (fine(part, COARSE)[:height, :width] * per_mm for part in self.paper(u.astype(float), v.astype(float)))
        rows, columns = dark.shape
        inside = (x >= 0) & (y >= 0) & (x < columns - 1) & (y < rows - 1)
        left, top = np.clip(x, 0, columns - 2).astype(np.int32), np.clip(y, 0, rows - 2).astype(np.int32)
        a, b = (np.clip(x - left, 0, 1), np.clip(y - top, 0, 1))
        seen = ((1 - b) * ((1 - a) * dark[top, left] + a * dark[top, left + 1])
                + b * ((1 - a) * dark[top + 1, left] + a * dark[top + 1, left + 1]))
        table = 0.35 + 0.04 * np.sin(np.arange(width) / 17)[None, :] + 0.02 * noise.standard_normal((height, width))
        light = np.where(inside, 0.93 - 0.85 * seen, table)
        # A lamp at one side, the corners darker, a shadow with a soft edge.
        gx, gy = np.meshgrid(np.linspace(-1, 1, width), np.linspace(-1, 1, height))
        angle = lot.uniform(0, 2 * math.pi)
        light *= 1 + lot.uniform(0, 0.22) * (gx * math.cos(angle) + gy * math.sin(angle)) - lot.uniform(0.02, 0.14) * (gx**2 + gy**2)
        if lot.random() < 0.4:
            angle, edge, soft = lot.uniform(0, 2 * math.pi), lot.uniform(-0.3, 0.9), lot.uniform(0.02, 0.15)
            light *= 1 - lot.uniform(0.1, 0.35) / (1 + np.exp(-(gx * math.cos(angle) + gy * math.sin(angle) - edge) / soft))
        picture = Image.fromarray(np.clip(255 * light * lot.uniform(0.85, 1.05), 0, 255).astype(np.uint8))
        picture = picture.filter(ImageFilter.GaussianBlur(lot.uniform(0.5, 1.1)))
        grey = np.asarray(picture).astype(np.float32)
        grey += noise.standard_normal(grey.shape, dtype=np.float32) * (lot.uniform(0.8, 2.0) + 0.12 * np.sqrt(grey))
        warm = (1.0, lot.uniform(0.96, 1.0), lot.uniform(0.86, 1.0))
        colour = np.stack([np.clip(grey * part, 0, 255) for part in warm], 2).astype(np.uint8)
        sharpened = Image.fromarray(colour).filter(ImageFilter.UnsharpMask(1.2, lot.randint(20, 90), 2))
        out = io.BytesIO()
        sharpened.save(out, "JPEG", quality=lot.randint(76, 94))
        return out.getvalue()


def rotation(a, b, c):
    """A turn about x, y and z."""
    def about(axis, angle):
        i, j = [k for k in range(3) if k != axis]
        turn = np.eye(3)
        turn[i, i] = turn[j, j] = math.cos(angle)
        turn[i, j], turn[j, i] = -math.sin(angle), math.sin(angle)
        return turn
    return about(0, a) @ about(1, b) @ about(2, c)


def fine(coarse, step):
    """Values at every pixel from those at every so many, linearly."""
    rows, columns = coarse.shape
    share = (np.arange(step) / step)[None, :]
    wide = (coarse[:, :-1, None] * (1 - share) + coarse[:, 1:, None] * share).reshape(rows, -1)
    return (wide[:-1, None, :] * (1 - share.T[None]) + wide[1:, None, :] * share.T[None]).reshape(-1, wide.shape[1])
