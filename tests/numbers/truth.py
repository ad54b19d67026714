"""Where a pin-jointed mechanism truly stands and how it moves, with 70 digits, from distances between points alone.

Nothing of the library is used but the places to begin from: no loops, no angles of links, no groups of its own finding.
Numbers are decimal texts, read with all their digits.
"""

from mpmath import mp, mpf

mp.dps = 70


def number(text):
    return mpf(text)


def cos_sin(degrees):
    """Cosine and sine of a decimal text of degrees; whole turns are taken off exactly, in whole numbers."""
    mantissa, _, power = degrees.lower().partition("e")
    whole, _, decimals = mantissa.partition(".")
    digits, power = int(whole + decimals), int(power or 0) - len(decimals)
    if power >= 0:
        rest = mpf(digits % 360 * pow(10, power, 360) % 360)
    else:
        turn = 360 * 10**-power
        rest = mpf(digits % turn) / mpf(10) ** -power
    angle = rest * mp.pi / 180
    return mp.cos(angle), mp.sin(angle)


def sub(a, b):
    return a[0] - b[0], a[1] - b[1]


def add(a, b):
    return a[0] + b[0], a[1] + b[1]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def scaled(a, s):
    return a[0] * s, a[1] * s


def quarter(a):
    return -a[1], a[0]


class Distance:
    """Two points at a distance that may change at a given rate."""

    def __init__(self, p, q, length, speed=mpf(0), acceleration=mpf(0)):
        self.p, self.q, self.length, self.speed, self.acceleration = p, q, length, speed, acceleration

    def points(self):
        return [self.p, self.q]

    def gap(self, at):
        d = sub(at[self.p], at[self.q])
        return (dot(d, d) - self.length**2) / 2

    def gradient(self, at):
        d = sub(at[self.p], at[self.q])
        return {self.p: d, self.q: (-d[0], -d[1])}

    def rate(self):
        return self.length * self.speed

    def second(self, v):
        d = sub(v[self.p], v[self.q])
        return self.speed**2 + self.length * self.acceleration - dot(d, d)


class Line:
    """A point on a straight line that stands still."""

    def __init__(self, p, through, along):
        self.p, self.through, self.along = p, through, along

    def points(self):
        return [self.p]

    def gap(self, at):
        return cross(self.along, sub(at[self.p], self.through))

    def gradient(self, at):
        return {self.p: quarter(self.along)}

    def rate(self):
        return mpf(0)

    def second(self, v):
        return mpf(0)


class Carried:
    """A third point of a link by its three distances, on the side of `side`; beside points a, b that are found before."""

    def __init__(self, p, a, b, ab, ap, bp, side):
        self.p, self.a, self.b = p, a, b
        self.x = (ab**2 + ap**2 - bp**2) / (2 * ab) / ab
        square = (ap / ab) ** 2 - self.x**2
        self.y = side * mp.sqrt(square if square > 0 else 0)

    def carry(self, r):
        return add(scaled(r, self.x), scaled(quarter(r), self.y))


class Truth:
    """`known` has place, velocity and acceleration of points; `groups` lists of (points, constraints), or a Carried."""

    def __init__(self, known, groups, begin):
        self.at = {name: motion[0] for name, motion in known.items()}
        self.v = {name: motion[1] for name, motion in known.items()}
        self.a = {name: motion[2] for name, motion in known.items()}
        for group in groups:
            if isinstance(group, Carried):
                r = sub(self.at[group.b], self.at[group.a])
                self.at[group.p] = add(self.at[group.a], group.carry(r))
                for rates in (self.v, self.a):
                    rates[group.p] = add(rates[group.a], group.carry(sub(rates[group.b], rates[group.a])))
                continue
            self.find(*group, begin)

    def find(self, points, constraints, begin):
        for p in points:
            self.at[p] = (mpf(begin[p][0]), mpf(begin[p][1]))
        size = max(abs(x) for p in points for x in self.at[p]) + 1
        for _ in range(60):
            step = self.solved(points, constraints, [-c.gap(self.at) for c in constraints])
            for p in points:
                self.at[p] = add(self.at[p], step[p])
            if max(abs(x) for p in points for x in step[p]) < size * mpf(10) ** -60:
                break
        else:
            raise ArithmeticError("no position")
        self.v.update({p: (mpf(0), mpf(0)) for p in points})
        self.v.update(self.solved(points, constraints, [self.left(c, c.rate(), points, self.v) for c in constraints]))
        self.a.update({p: (mpf(0), mpf(0)) for p in points})
        sides = [self.left(c, c.second(self.v), points, self.a) for c in constraints]
        self.a.update(self.solved(points, constraints, sides))

    def left(self, constraint, rate, points, rates):
        known = {p: g for p, g in constraint.gradient(self.at).items() if p not in points}
        return rate - sum(dot(g, rates[p]) for p, g in known.items())

    def solved(self, points, constraints, sides):
        matrix = mp.matrix(len(constraints), 2 * len(points))
        for row, constraint in enumerate(constraints):
            for p, g in constraint.gradient(self.at).items():
                if p in points:
                    matrix[row, 2 * points.index(p)], matrix[row, 2 * points.index(p) + 1] = g
        x = mp.lu_solve(matrix, mp.matrix(sides))
        return {p: (x[2 * k], x[2 * k + 1]) for k, p in enumerate(points)}

    def link(self, p, q):
        """ω and α of a link with two of its points."""
        r, v, a = (sub(of[q], of[p]) for of in (self.at, self.v, self.a))
        omega = cross(r, v) / dot(r, r)
        # Of a cylinder the distance changes, too.
        return omega, (cross(r, a) - 2 * omega * dot(r, v)) / dot(r, r)
