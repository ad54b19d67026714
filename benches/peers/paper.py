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
OMEGA = -1.0
LOW, HIGH, COUNT = math.radians(-135), math.radians(135), 1000
NEWTON = 3


@njit
def matrix_and_gaps(phi, x, m, gap):
    """The Jacobian of the loops, and their gaps."""
    t2, s, t4, t5 = x
    c2, s2 = math.cos(t2), math.sin(t2)
    c4, s4 = math.cos(t4), math.sin(t4)
    c6, s6 = math.cos(t4 + GAMMA), math.sin(t4 + GAMMA)
    c5, s5 = math.cos(t5), math.sin(t5)
    bx, by = AB * math.cos(phi), AB * math.sin(phi)
    gap[0] = bx + s * c2 - GX - GD * c4
    gap[1] = by + s * s2 - GY - GD * s4
    gap[2] = bx + BE * c2 - GX - GF * c6 - FE * c5
    gap[3] = by + BE * s2 - GY - GF * s6 - FE * s5
    m[0, 0], m[0, 1], m[0, 2], m[0, 3] = -s * s2, c2, GD * s4, 0.0
    m[1, 0], m[1, 1], m[1, 2], m[1, 3] = s * c2, s2, -GD * c4, 0.0
    m[2, 0], m[2, 1], m[2, 2], m[2, 3] = -BE * s2, 0.0, GF * s6, FE * s5
    m[3, 0], m[3, 1], m[3, 2], m[3, 3] = BE * c2, 0.0, -GF * c6, -FE * c5


@njit
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


@njit
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


@njit
def velocity_side(phi, side):
    side[0] = side[2] = OMEGA * AB * math.sin(phi)
    side[1] = side[3] = -OMEGA * AB * math.cos(phi)


@njit
def acceleration_side(phi, x, v, side):
    t2, s, t4, t5 = x
    w2, sv, w4, w5 = v
    c2, s2 = math.cos(t2), math.sin(t2)
    c4, s4 = math.cos(t4), math.sin(t4)
    c6, s6 = math.cos(t4 + GAMMA), math.sin(t4 + GAMMA)
    c5, s5 = math.cos(t5), math.sin(t5)
    crank = OMEGA * OMEGA * AB
    x1, y1 = crank * math.cos(phi), crank * math.sin(phi)
    side[0] = x1 + w2 * w2 * s * c2 + 2 * w2 * sv * s2 - w4 * w4 * GD * c4
    side[1] = y1 + w2 * w2 * s * s2 - 2 * w2 * sv * c2 - w4 * w4 * GD * s4
    side[2] = x1 + w2 * w2 * BE * c2 - w4 * w4 * GF * c6 - w5 * w5 * FE * c5
    side[3] = y1 + w2 * w2 * BE * s2 - w4 * w4 * GF * s6 - w5 * w5 * FE * s5


@njit
def cycle(angles, start, positions, velocities, accelerations):
    """Positions by Newton steps from the position before, velocities and accelerations by the same matrix."""
    m = np.empty((4, 4))
    order = np.empty(4, np.int64)
    gap, step = np.empty(4), np.empty(4)
    x = start.copy()
    for n in range(angles.size):
        phi = angles[n]
        for _ in range(NEWTON):
            matrix_and_gaps(phi, x, m, gap)
            factor(m, order)
            solve(m, order, gap, step)
            for i in range(4):
                x[i] -= step[i]
        matrix_and_gaps(phi, x, m, gap)
        factor(m, order)
        velocity_side(phi, gap)
        solve(m, order, gap, velocities[n])
        acceleration_side(phi, x, velocities[n], gap)
        solve(m, order, gap, accelerations[n])
        positions[n] = x


@njit
def rates(angles, positions, velocities, accelerations):
    """Velocities and accelerations where positions are known."""
    m = np.empty((4, 4))
    order = np.empty(4, np.int64)
    side = np.empty(4)
    for n in range(angles.size):
        matrix_and_gaps(angles[n], positions[n], m, side)
        factor(m, order)
        velocity_side(angles[n], side)
        solve(m, order, side, velocities[n])
        acceleration_side(angles[n], positions[n], velocities[n], side)
        solve(m, order, side, accelerations[n])


def by_scipy(angles, start, positions, velocities, accelerations):
    m, gap = np.empty((4, 4)), np.empty(4)

    def gaps(x, phi):
        matrix_and_gaps(phi, x, m, gap)
        return gap.copy()

    def jacobian(x, phi):
        matrix_and_gaps(phi, x, m, gap)
        return m.copy()

    x = start
    for n, phi in enumerate(angles):
        x = scipy.optimize.fsolve(gaps, x, (phi,), jacobian, xtol=1e-13)
        matrix_and_gaps(phi, x, m, gap)
        velocity_side(phi, gap)
        velocities[n] = np.linalg.solve(m, gap)
        acceleration_side(phi, x, velocities[n], gap)
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
