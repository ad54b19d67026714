"""The paper's mechanism (examples/figure-2.json) by loop equations, as one writes them with numba and with scipy.

Unknowns: angle of link 2, distance s of the block from B along it, angles of links 4 and 5.
    A→B→D = A→G→D        B + s u(θ2) = G + GD u(θ4)
    A→B→E = A→G→F→E      B + BE u(θ2) = G + GF u(θ4 + γ) + FE u(θ5)
"""

import math

import numpy as np
import scipy.optimize
from numba import njit

from clock import nanoseconds

AB, BE, GD, GF, DF, FE = 100.0, 500.0, 300.0, 150.0, 180.0, 300.0
GX, GY = 275.0, 0.0
# F lies clockwise of D, seen from G.
GAMMA = -math.acos((GD * GD + GF * GF - DF * DF) / (2 * GD * GF))
COS_GAMMA, SIN_GAMMA = math.cos(GAMMA), math.sin(GAMMA)
OMEGA = -1.0
LOW, HIGH, COUNT = math.radians(-135), math.radians(135), 1000
NEWTON = 3


@njit(error_model="numpy")
def matrix_and_gaps(bx, by, x, m, gap, trig):
    """The Jacobian of the loops, their gaps, and sines and cosines for later; B from the crank."""
    t2, s, t4, t5 = x[0], x[1], x[2], x[3]
    c2, s2 = math.cos(t2), math.sin(t2)
    c4, s4 = math.cos(t4), math.sin(t4)
    c6, s6 = c4 * COS_GAMMA - s4 * SIN_GAMMA, s4 * COS_GAMMA + c4 * SIN_GAMMA
    c5, s5 = math.cos(t5), math.sin(t5)
    trig[0], trig[1], trig[2], trig[3] = c2, s2, c4, s4
    trig[4], trig[5], trig[6], trig[7] = c6, s6, c5, s5
    gap[0] = bx + s * c2 - GX - GD * c4
    gap[1] = by + s * s2 - GY - GD * s4
    gap[2] = bx + BE * c2 - GX - GF * c6 - FE * c5
    gap[3] = by + BE * s2 - GY - GF * s6 - FE * s5
    m[0, 0], m[0, 1], m[0, 2], m[0, 3] = -s * s2, c2, GD * s4, 0.0
    m[1, 0], m[1, 1], m[1, 2], m[1, 3] = s * c2, s2, -GD * c4, 0.0
    m[2, 0], m[2, 1], m[2, 2], m[2, 3] = -BE * s2, 0.0, GF * s6, FE * s5
    m[3, 0], m[3, 1], m[3, 2], m[3, 3] = BE * c2, 0.0, -GF * c6, -FE * c5


@njit(error_model="numpy")
def factor(m, order):
    """LU with partial pivoting, in place."""
    for k in range(4):
        order[k] = k
    for k in range(4):
        pivot = k
        for i in range(k + 1, 4):
            if abs(m[i, k]) > abs(m[pivot, k]):
                pivot = i
        if pivot != k:
            order[k], order[pivot] = order[pivot], order[k]
            for j in range(4):
                m[k, j], m[pivot, j] = m[pivot, j], m[k, j]
        inverse = 1.0 / m[k, k]
        for i in range(k + 1, 4):
            m[i, k] *= inverse
            for j in range(k + 1, 4):
                m[i, j] -= m[i, k] * m[k, j]


@njit(error_model="numpy")
def solve(m, order, b, x):
    for i in range(4):
        sum_ = b[order[i]]
        for j in range(i):
            sum_ -= m[i, j] * x[j]
        x[i] = sum_
    for i in range(3, -1, -1):
        sum_ = x[i]
        for j in range(i + 1, 4):
            sum_ -= m[i, j] * x[j]
        x[i] = sum_ / m[i, i]


@njit(error_model="numpy")
def velocity_side(bx, by, side):
    side[0] = side[2] = OMEGA * by
    side[1] = side[3] = -OMEGA * bx


@njit(error_model="numpy")
def acceleration_side(bx, by, x, v, trig, side):
    s = x[1]
    w2, sv, w4, w5 = v[0], v[1], v[2], v[3]
    c2, s2, c4, s4, c6, s6, c5, s5 = trig[0], trig[1], trig[2], trig[3], trig[4], trig[5], trig[6], trig[7]
    x1, y1 = OMEGA * OMEGA * bx, OMEGA * OMEGA * by
    side[0] = x1 + w2 * w2 * s * c2 + 2 * w2 * sv * s2 - w4 * w4 * GD * c4
    side[1] = y1 + w2 * w2 * s * s2 - 2 * w2 * sv * c2 - w4 * w4 * GD * s4
    side[2] = x1 + w2 * w2 * BE * c2 - w4 * w4 * GF * c6 - w5 * w5 * FE * c5
    side[3] = y1 + w2 * w2 * BE * s2 - w4 * w4 * GF * s6 - w5 * w5 * FE * s5


@njit(error_model="numpy")
def cycle(angles, start, positions, velocities, accelerations):
    """Positions by Newton steps from the position before, velocities and accelerations by the same matrix."""
    m, trig = np.empty((4, 4)), np.empty(8)
    order = np.empty(4, np.int64)
    gap, step = np.empty(4), np.empty(4)
    x = start.copy()
    for n in range(angles.size):
        bx, by = AB * math.cos(angles[n]), AB * math.sin(angles[n])
        for _ in range(NEWTON):
            matrix_and_gaps(bx, by, x, m, gap, trig)
            factor(m, order)
            solve(m, order, gap, step)
            for i in range(4):
                x[i] -= step[i]
        matrix_and_gaps(bx, by, x, m, gap, trig)
        factor(m, order)
        velocity_side(bx, by, gap)
        solve(m, order, gap, velocities[n])
        acceleration_side(bx, by, x, velocities[n], trig, gap)
        solve(m, order, gap, accelerations[n])
        positions[n] = x


@njit(error_model="numpy")
def rates(angles, positions, velocities, accelerations):
    """Velocities and accelerations where positions are known."""
    m, trig = np.empty((4, 4)), np.empty(8)
    order = np.empty(4, np.int64)
    side = np.empty(4)
    for n in range(angles.size):
        bx, by = AB * math.cos(angles[n]), AB * math.sin(angles[n])
        matrix_and_gaps(bx, by, positions[n], m, side, trig)
        factor(m, order)
        velocity_side(bx, by, side)
        solve(m, order, side, velocities[n])
        acceleration_side(bx, by, positions[n], velocities[n], trig, side)
        solve(m, order, side, accelerations[n])


def by_scipy(angles, start, positions, velocities, accelerations):
    m, gap, trig = np.empty((4, 4)), np.empty(4), np.empty(8)

    def crank(phi):
        return AB * math.cos(phi), AB * math.sin(phi)

    def gaps(x, phi):
        matrix_and_gaps(*crank(phi), x, m, gap, trig)
        return gap.copy()

    def jacobian(x, phi):
        matrix_and_gaps(*crank(phi), x, m, gap, trig)
        return m.copy()

    x = start
    for n, phi in enumerate(angles):
        x = scipy.optimize.fsolve(gaps, x, (phi,), jacobian, xtol=1e-13)
        matrix_and_gaps(*crank(phi), x, m, gap, trig)
        velocity_side(*crank(phi), gap)
        velocities[n] = np.linalg.solve(m, gap)
        acceleration_side(*crank(phi), x, velocities[n], trig, gap)
        accelerations[n] = np.linalg.solve(m, gap)
        positions[n] = x


def start_at(phi):
    """The position of the figure (crank at 70°) carried to `phi`."""
    x = np.array([math.radians(42), 307.0, math.radians(92), math.radians(76)])
    path = np.linspace(math.radians(70), phi, 500)
    tables = [np.empty((path.size, 4)) for _ in range(3)]
    cycle(path, x, *tables)
    return tables[0][-1]


def true_rates(degrees=70.0):
    """ω and α of links 2, 4, 5 and of the block along its guide, for other programs to be checked against."""
    angles = np.array([math.radians(degrees)])
    tables = [np.empty((1, 4)) for _ in range(3)]
    cycle(angles, start_at(angles[0]), *tables)
    return tables[1][0], tables[2][0]


def measure():
    """Rows of the table: job, who, nanoseconds."""
    angles = np.linspace(LOW, HIGH, COUNT)
    tables = [np.empty((COUNT, 4)) for _ in range(3)]
    start = start_at(LOW)
    # As in Kinegon's tests: the paper's position.
    assert abs(true_rates()[0][2] - -0.474663754894) < 1e-10
    yield "paper", "numba: Newton, LU", nanoseconds(lambda: cycle(angles, start, *tables), COUNT)
    known = tables[0].copy()
    few = angles[::10]
    scipy_tables = [np.empty((few.size, 4)) for _ in range(3)]
    by_scipy(few, start, *scipy_tables)
    assert np.allclose(scipy_tables[2], tables[2][::10], rtol=1e-7)
    yield "paper", "scipy: fsolve", nanoseconds(lambda: by_scipy(few, start, *scipy_tables), few.size, 5)
    yield "paper, v and a alone", "numba: LU", nanoseconds(lambda: rates(angles, known, *tables[1:]), COUNT)
