"""The four-bar linkage of templates/four-bar.json: pylinkage's compiled path, and its closed form with numba."""

import math

import numpy as np
from numba import njit
from pylinkage import Ground, RRRDyad
from pylinkage.actuators import Crank
from pylinkage.simulation import Linkage

from clock import nanoseconds

AB, BC, CD, AD = 60.0, 140.0, 110.0, 160.0
OMEGA = 10.0
COUNT = 1000


@njit(error_model="numpy")
def closed_form(angles, table):
    """C from two circles, then velocities and accelerations of the rods by crossing with each other."""
    for n in range(angles.size):
        c, s = math.cos(angles[n]), math.sin(angles[n])
        bx, by = AB * c, AB * s
        dx, dy = AD - bx, -by
        square = dx * dx + dy * dy
        along = 0.5 + 0.5 * (BC * BC - CD * CD) / square
        across = math.sqrt(BC * BC / square - along * along)
        # Arms B→C and D→C.
        px, py = along * dx - across * dy, along * dy + across * dx
        qx, qy = px - dx, py - dy
        inverse = 1.0 / (px * qy - py * qx)
        vx, vy = -OMEGA * by, OMEGA * bx
        w2 = -(vx * qx + vy * qy) * inverse
        w3 = -(vx * px + vy * py) * inverse
        ax = -OMEGA * OMEGA * bx - w2 * w2 * px + w3 * w3 * qx
        ay = -OMEGA * OMEGA * by - w2 * w2 * py + w3 * w3 * qy
        row = table[n]
        row[0], row[1] = bx + px, by + py
        row[2], row[3] = w2, w3
        row[4], row[5] = -(ax * qx + ay * qy) * inverse, -(ax * px + ay * py) * inverse
        row[6], row[7] = -w3 * qy, w3 * qx
        row[8] = -row[5] * qy - w3 * w3 * qx
        row[9] = row[5] * qx - w3 * w3 * qy


def by_pylinkage():
    a, d = Ground(0.0, 0.0, name="A"), Ground(AD, 0.0, name="D")
    b = Crank(anchor=a, radius=AB, angular_velocity=2 * math.pi / COUNT, initial_angle=0.0, name="B")
    c = RRRDyad(anchor1=b.output, anchor2=d, distance1=BC, distance2=CD, name="C")
    linkage = Linkage([a, d, b, c])
    linkage.set_input_velocity(b, OMEGA)
    linkage.compile()
    return linkage


def measure():
    """Rows of the table: job, who, nanoseconds."""
    angles = np.linspace(0.0, 2 * math.pi, COUNT, endpoint=False)
    table = np.empty((COUNT, 10))
    yield "four-bar", "numba: closed form", nanoseconds(lambda: closed_form(angles, table), COUNT)
    # Velocities and accelerations are the derivatives of positions.
    for first, second, size in [(0, 6, 1e-2), (6, 8, 1e-2)]:
        change = (np.roll(table, -1, 0) - np.roll(table, 1, 0))[:, first : first + 2] * OMEGA * COUNT / (4 * math.pi)
        assert np.abs(change - table[:, second : second + 2]).max() < size * np.abs(change).max()
    linkage = by_pylinkage()
    positions, velocities, accelerations = linkage.step_fast_with_kinematics(COUNT)
    # Its first step is the second position.
    shown = np.roll(table, -1, 0)
    names = [part.name for part in linkage.components]
    at = names.index("C")
    for got, want in [(positions, 0), (velocities, 6), (accelerations, 8)]:
        assert np.allclose(got[:, at], shown[:, want : want + 2], rtol=1e-6, atol=1e-6 * np.abs(shown).max())
    yield "four-bar", "pylinkage, compiled", nanoseconds(lambda: linkage.step_fast_with_kinematics(COUNT), COUNT)
