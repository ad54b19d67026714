"""A million four-bars over a whole turn, extremes of ω and α: `kinegon study` on one core, on two, over Dask with two workers, and a numba
loop of the closed form at the same positions. All in one run; quote ratios.

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


def study(rows):
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
    }


@njit
def closed_form(couplers, rockers, out):
    for i in range(couplers.size):
        b, c = couplers[i], rockers[i]
        w_max = a_max = -math.inf
        w_min = a_min = math.inf
        for k in range(POSITIONS):
            t = 2 * math.pi * k / POSITIONS
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


def timed(name, rows, work, results):
    start = time.perf_counter()
    work()
    seconds = time.perf_counter() - start
    results[name] = rows / seconds
    print(f"{name:28} {seconds:8.2f} s  {rows / seconds:10.0f} mechanisms/s", flush=True)


def main(program, rows):
    os.environ["KINEGON"] = str(Path(program).resolve())
    folder = Path(tempfile.mkdtemp())
    os.chdir(folder)
    Path("study.json").write_text(json.dumps(study(rows)))
    results = {}

    def kinegon(output, cores):
        environment = {**os.environ, "RAYON_NUM_THREADS": str(cores)}
        subprocess.run([os.environ["KINEGON"], "study", "study.json", "-o", output], env=environment, check=True, capture_output=True)

    def dask():
        import on_dask

        os.environ["RAYON_NUM_THREADS"] = "1"
        with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
            timed("kinegon, Dask, two workers", rows, lambda: on_dask.run("study.json", "dask.csv", client), results)

    from dask.distributed import Client, LocalCluster

    random = np.random.default_rng(1)
    couplers, rockers = random.uniform(135, 145, rows), random.uniform(105, 115, rows)
    out = np.empty((rows, 4))
    closed_form(couplers[:1], rockers[:1], out)
    timed("numba, closed form, one core", rows, lambda: closed_form(couplers, rockers, out), results)
    timed("kinegon, one core", rows, lambda: kinegon("one.csv", 1), results)
    timed("kinegon, two cores", rows, lambda: kinegon("two.csv", 2), results)
    dask()
    files = [Path(name).read_bytes() for name in ["one.csv", "two.csv", "dask.csv"]]
    print("same bytes:", files[0] == files[1] == files[2])
    for name, speed in results.items():
        print(f"{name:28} {speed / results['kinegon, one core']:6.2f} of kinegon on one core")
    shutil.rmtree(folder)


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 1_000_000)
