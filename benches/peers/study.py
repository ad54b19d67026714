"""A million four-bars over a whole turn, extremes of ω and α: `kinegon study` on one core, with the extremes at the steps and with the true
ones, on two, over Dask with two workers, and a numba loop of the closed form at the same positions. All in one run; quote ratios, and how
far each is from the true extremes.

    pip install "dask[distributed]" numba
    python benches/peers/study.py path/to/kinegon [ROWS]
"""

import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from numba import njit

sys.path.insert(0, str(Path(__file__).parents[2] / "examples/studies"))
os.environ["PYTHONPATH"] = sys.path[0]
POSITIONS = 72


def study(rows, at_steps=False):
    scene = {
        "kinegon": 1,
        "units": {"length": "mm", "time": "s"},
        "ground": {"A": [0, 0], "D": [160, 0]},
        "links": {
            "1": {"points": ["A", "B"], "lengths": {"AB": 60}, "drive": {"angle": 60, "omega": 10}},
            "2": {"points": ["B", "C"], "lengths": {"BC": 140}},
            "3": {"points": ["D", "C"], "lengths": {"CD": 110}},
        },
        "near": {"C": [155, 110]},
    }
    return {
        "kinegon_study": 1,
        "scene": scene,
        "vary": {"2.BC": {"plus_minus": 5}, "3.CD": {"plus_minus": 5}},
        "count": rows,
        "cycle": {"from": 0, "to": 360, "step": 360 / POSITIONS},
        "want": {"omega(3)": ["max", "min"], "alpha(3)": ["max", "min"]},
        "at_steps": at_steps,
    }


@njit
def closed_form(couplers, rockers, positions, out):
    for i in range(couplers.size):
        b, c = couplers[i], rockers[i]
        w_max = a_max = -math.inf
        w_min = a_min = math.inf
        for k in range(positions):
            t = 2 * math.pi * k / positions
            bx, by = 60 * math.cos(t), 60 * math.sin(t)
            dx, dy = 160 - bx, -by
            d = math.sqrt(dx * dx + dy * dy)
            along = (d * d + b * b - c * c) / (2 * d)
            across = math.sqrt(b * b - along * along)
            px, py = (along * dx - across * dy) / d, (along * dy + across * dx) / d
            qx, qy = bx + px - 160, by + py
            sine = qx * py - qy * px
            w = (-10 * by * px + 10 * bx * py) / sine
            vx, vy = -w * qy + 10 * by, w * qx - 10 * bx
            a = (-100 * (bx * px + by * py) + w * w * (qx * px + qy * py) - vx * vx - vy * vy) / sine
            w_max, w_min = max(w_max, w), min(w_min, w)
            a_max, a_min = max(a_max, a), min(a_min, a)
        out[i, 0], out[i, 1], out[i, 2], out[i, 3] = w_max, w_min, a_max, a_min


def missed(name, couplers, rockers, found):
    """By how much of a curve's height extremes are off, at most and in the mean; the true ones are those of samples a hundredth of a degree apart."""
    some = slice(0, None, max(1, len(couplers) // 200))
    true = np.empty((len(couplers[some]), 4))
    closed_form(couplers[some], rockers[some], 36_000, true)
    heights = np.stack([true[:, 0] - true[:, 1]] * 2 + [true[:, 2] - true[:, 3]] * 2, axis=1)
    off = abs(found[some] - true) / heights
    print(f"{name:32} off by {off.max():.1e} of a curve's height at most, {off.mean():.1e} in the mean", flush=True)


def of_file(name):
    """Couplers, rockers and extremes of some rows of a table."""
    lines = Path(name).read_text().splitlines()
    some = [lines[0], *lines[1 :: max(1, len(lines) // 200)]]
    table = np.genfromtxt(some, delimiter=",", names=True, deletechars="", dtype=None, encoding="utf-8")
    figures = ["omega(3).max", "omega(3).min", "alpha(3).max", "alpha(3).min"]
    return table["2.BC"], table["3.CD"], np.stack([table[figure] for figure in figures], axis=1)


def timed(name, rows, work, results):
    """Mechanisms a second, and a second of processor, which counts where others are at work on the machine; that of Dask's workers is not told."""
    start, before = time.perf_counter(), os.times()
    work()
    seconds, after = time.perf_counter() - start, os.times()
    # Of this process and of those that it started, user and system.
    processor = sum(after[:4]) - sum(before[:4])
    results[name] = [rows / seconds, rows / processor]
    print(f"{name:32} {seconds:8.2f} s {rows / seconds:10.0f}/s {processor:8.2f} s of processor {rows / processor:10.0f}/s", flush=True)


def main(program, rows):
    os.environ["KINEGON"] = str(Path(program).resolve())
    folder = Path(tempfile.mkdtemp())
    os.chdir(folder)
    Path("study.json").write_text(json.dumps(study(rows)))
    Path("steps.json").write_text(json.dumps(study(rows, at_steps=True)))
    results = {}

    def kinegon(output, cores, of="study.json"):
        environment = {**os.environ, "RAYON_NUM_THREADS": str(cores)}
        subprocess.run([os.environ["KINEGON"], "study", of, "-o", output], env=environment, check=True, capture_output=True)

    def dask():
        import on_dask

        os.environ["RAYON_NUM_THREADS"] = "1"
        with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
            timed("kinegon, Dask, two workers", rows, lambda: on_dask.run("study.json", "dask.csv", client), results)

    from dask.distributed import Client, LocalCluster

    random = np.random.default_rng(1)
    couplers, rockers = random.uniform(135, 145, rows), random.uniform(105, 115, rows)
    out = np.empty((rows, 4))
    closed_form(couplers[:1], rockers[:1], POSITIONS, out)
    timed("numba, closed form, one core", rows, lambda: closed_form(couplers, rockers, POSITIONS, out), results)
    timed("kinegon, one core, at steps", rows, lambda: kinegon("steps.csv", 1, "steps.json"), results)
    timed("kinegon, one core", rows, lambda: kinegon("one.csv", 1), results)
    timed("kinegon, two cores", rows, lambda: kinegon("two.csv", 2), results)
    dask()
    files = [Path(name).read_bytes() for name in ["one.csv", "two.csv", "dask.csv"]]
    print("same bytes:", files[0] == files[1] == files[2])
    numba = results["numba, closed form, one core"]
    for name, speeds in results.items():
        wall, processor = (own / other for own, other in zip(speeds, numba))
        print(f"{name:32} {wall:6.3f} of numba, {processor:6.3f} by the processor's time")
    missed("numba, closed form", couplers, rockers, out)
    missed("kinegon, at steps", *of_file("steps.csv"))
    missed("kinegon", *of_file("one.csv"))
    shutil.rmtree(folder)


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 1_000_000)
