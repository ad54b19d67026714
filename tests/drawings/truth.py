"""Positions, velocities and accelerations of a scene, by Newton's method on points and by linear equations of the bodies.

Nothing here is shared with Kinegon: it is what the drawings of `plans.py` are measured by. It reads what the scenes here use: lengths
or coordinates, drives of cranks and sliders, known points and motions, guides on the ground and on links.

Places, velocities and accelerations are complex numbers in the scene's units; rates in rad, counter-clockwise positive."""

import cmath
import itertools
import math
import random


class Impossible(Exception):
    """The scene cannot be put together, or does not say how it moves."""


def unit(degrees):
    return cmath.exp(1j * math.radians(degrees))


def dot(p, q):
    return (p.conjugate() * q).real


def vector(entry):
    """A vector of a scene: [x, y], or its size and angle."""
    return complex(*entry) if isinstance(entry, list) else entry["size"] * unit(entry["angle"])


def pair(key):
    """The two points of a key such as AB or A1-B1."""
    return tuple(key.split("-")) if "-" in key else (key[:1], key[1:])


def noted(entries):
    return {key: value for key, value in entries.items() if key != "note"}


def eliminate(rows, unknowns):
    """Solves a consistent system that may have more rows than unknowns: each row is a dict of coefficients and the right side."""
    m = [[row.get(u, 0.0) for u in unknowns] + [right] for row, right in rows]
    for column in range(len(unknowns)):
        best = max(range(column, len(m)), key=lambda i: abs(m[i][column]), default=None)
        if best is None or abs(m[best][column]) < 1e-11:
            raise Impossible(f"nothing tells {unknowns[column]}")
        m[column], m[best] = m[best], m[column]
        top = m[column] = [x / m[column][column] for x in m[column]]
        for i, row in enumerate(m):
            if i != column and row[column]:
                m[i] = [x - row[column] * y for x, y in zip(row, top)]
    return {u: m[i][-1] for i, u in enumerate(unknowns)}


class Slider:
    def __init__(self, entry, mechanism):
        self.on, self.entry = entry["on"], entry
        self.link, self.point = entry.get("link"), entry.get("at") or entry["pin"]
        self.name = f"{self.link or self.point}/{self.on}"
        along = entry.get("along", 0)
        ends = pair(along) if isinstance(along, str) else None
        carrier = mechanism.links.get(self.on)
        self.ends, self.along = ends, along
        self.axis = carrier[:2] if carrier and len(carrier) > 1 else None
        self.through = entry.get("through") or (ends[0] if ends else (carrier or [None])[0])
        self.drive = entry.get("drive") or mechanism.drives.get(self.link)

    def direction(self, at):
        if self.ends:
            way = at[self.ends[1]] - at[self.ends[0]]
        elif isinstance(self.along, list):
            way = complex(*self.along)
        else:
            way = unit(self.along)
            if self.on != "ground":
                way *= at[self.axis[1]] - at[self.axis[0]]
        return way / abs(way)

    def place(self, at):
        return at[self.through] if isinstance(self.through, str) else complex(*self.through)


class Mechanism:
    """A scene in its position, with everything that moves."""

    def __init__(self, scene):
        self.scene, self.drawn = scene, "points" in scene
        ground = scene.get("ground", {})
        self.ground = list(ground) if isinstance(ground, list) else [name for name in ground if name != "note"]
        self.links, self.lengths, self.drives, self.motions = {}, {}, {}, {}
        for name, link in noted(scene["links"]).items():
            link = {"points": link} if isinstance(link, list) else link
            self.links[name] = link["points"]
            self.lengths.update({pair(key): size for key, size in noted(link.get("lengths", {})).items()})
            if "drive" in link:
                self.drives[name] = link["drive"]
            if "motion" in link:
                self.motions[name] = link["motion"]
        self.sliders = [Slider(entry, self) for entry in scene.get("sliders", [])]
        self.known = noted(scene.get("known", {}))
        sliding = {s.link for s in self.sliders}
        self.stubs = {name for name, points in self.links.items() if name not in sliding and all(p in self.known for p in points)}
        self.at = self._drawn() if self.drawn else self._assembled()
        self.guides = {s.name: s.direction(self.at) for s in self.sliders}
        self.omega, self.alpha, self.v, self.a, self.v_r, self.a_r = {}, {}, {}, {}, {}, {}
        self._motion(self.omega, self.v, self.v_r, False)
        self._motion(self.alpha, self.a, self.a_r, True)

    # ------------------------------------------------------------ positions

    def _drawn(self):
        return {name: complex(*at) for name, at in noted(self.scene["points"]).items()}

    def _assembled(self):
        fixed = {name: complex(*at) for name, at in noted(self.scene["ground"]).items()}
        near = {name: complex(*at) for name, at in noted(self.scene.get("near", {})).items() if isinstance(at, list)}
        size = max(self.lengths.values())
        for name, drive in self.drives.items():
            if "angle" in drive:
                a, b = self.links[name][:2]
                if a not in self.ground:
                    raise Impossible("a driven link begins at its pivot here")
                fixed[b] = fixed[a] + self.length(a, b) * unit(drive["angle"])
        names = [n for n in dict.fromkeys(itertools.chain(*self.links.values())) if n not in fixed]
        rng, found = random.Random(11), []
        for trial in range(60):
            spread = 0 if trial == 0 else size * (0.15 if trial < 20 else 1.5)
            start = {n: near.get(n, size * (0.3 + 0.4j)) + complex(rng.uniform(-1, 1), rng.uniform(-1, 1)) * spread for n in names}
            if trial == 0:
                start = {n: z if n in near else z + 0.1 * size * complex(rng.random(), rng.random()) for n, z in start.items()}
            at = self._newton({**fixed, **start}, names, near)
            if at and all(max(abs(at[n] - o[n]) for n in names) > 1e-6 * size for o in found):
                found.append(at)
        if not found:
            raise Impossible("cannot be put together")
        return min(found, key=lambda at: sum(abs(at[n] - near[n])**2 for n in names if n in near))

    def length(self, p, q):
        return self.lengths.get((p, q)) or self.lengths[q, p]

    def _conditions(self, near):
        """What must be nothing, as functions of the places."""
        conditions = []
        for points in self.links.values():
            if len(points) >= 2 and all(self._has(p, q) for p, q in itertools.combinations(points, 2)):
                a, b = points[:2]
                conditions.append(lambda at, a=a, b=b, s=self.length(a, b): abs(at[a] - at[b]) - s)
                for c in points[2:]:
                    conditions += self._third(a, b, c, near)
        for s in self.sliders:
            conditions.append(lambda at, s=s: ((at[s.point] - s.place(at)) * s.direction(at).conjugate()).imag)
            if s.link and len(self.links[s.link]) > 1:
                turned = unit(s.entry.get("turned", 0))
                p, q = self.links[s.link][:2]
                conditions.append(lambda at, s=s, p=p, q=q, t=turned: ((at[q] - at[p]) * (s.direction(at) * t).conjugate()).imag)
            if s.drive:
                conditions.append(lambda at, s=s: dot(s.direction(at), at[s.point] - s.place(at)) - s.drive["position"])
        return conditions

    def _has(self, p, q):
        return (p, q) in self.lengths or (q, p) in self.lengths

    def _third(self, a, b, c, near):
        """The third point of a link, on the side where it is in `near`."""
        base, one, two = self.length(a, b), self.length(a, c), self.length(b, c)
        x = (base**2 + one**2 - two**2) / (2 * base)
        y = math.sqrt(max(one**2 - x**2, 0))
        sides = {n: near.get(n, complex(*self.scene["ground"][n]) if n in self.ground else None) for n in (a, b, c)}
        if None not in sides.values() and ((sides[c] - sides[a]) * (sides[b] - sides[a]).conjugate()).imag < 0:
            y = -y
        ratio = complex(x, y) / base
        return [lambda at, part=part: part(at[c] - at[a] - ratio * (at[b] - at[a])) for part in (lambda z: z.real, lambda z: z.imag)]

    def _newton(self, at, names, near):
        conditions = self._conditions(near)
        unknowns = [(n, part) for n in names for part in (1, 1j)]
        for _ in range(50):
            off = [c(at) for c in conditions]
            if max(map(abs, off), default=0) < 1e-11 * max(map(abs, self.lengths.values())):
                return at if self._right_way_round(at) else None
            rows = []
            step = 1e-7 * max(self.lengths.values())
            columns = {u: [(c({**at, u[0]: at[u[0]] + step * u[1]}) - c({**at, u[0]: at[u[0]] - step * u[1]})) / (2 * step)
                           for c in conditions] for u in unknowns}
            for i, value in enumerate(off):
                rows.append(({u: columns[u][i] for u in unknowns}, -value))
            try:
                move = eliminate(rows, unknowns)
            except (Impossible, OverflowError):
                return None
            if not all(math.isfinite(x) and abs(x) < 1e6 * max(self.lengths.values()) for x in move.values()):
                return None
            at = dict(at)
            for (n, part), x in move.items():
                at[n] += part * x
        return None

    def _right_way_round(self, at):
        """Blocks that have an axis point along their guide, not against it; blocks on a slot lie towards the end that it is named by."""
        for s in self.sliders:
            if s.link and len(self.links[s.link]) > 1:
                p, q = self.links[s.link][:2]
                if dot((at[q] - at[p]), s.direction(at) * unit(s.entry.get("turned", 0))) < 0:
                    return False
            elif s.on != "ground" and s.ends and not s.drive and dot(at[s.point] - s.place(at), s.direction(at)) < 0:
                return False
        return True

    # ------------------------------------------------------------ motion

    def _arm(self, link, place):
        return place - self.at[self.links[link][0]]

    def _rows(self, rows, coefficients, right):
        """A vector equation as two rows; the coefficients are complex."""
        rows.append(({u: c.real for u, c in coefficients.items()}, right.real))
        rows.append(({u: c.imag for u, c in coefficients.items()}, right.imag))

    def _of(self, link, place, sign=1):
        """The coefficients of the motion of a link's point at a place."""
        return {(link, "x"): sign * 1 + 0j, (link, "y"): sign * 1j, (link, "turn"): sign * 1j * self._arm(link, place)}

    def _pull(self, link, place, second):
        """The normal part of the acceleration of a link's point, less that of its first point."""
        return -self.omega[link]**2 * self._arm(link, place) if second else 0j

    def _motion(self, turn, moves, slides, second):
        size, rate = ("acceleration", "alpha") if second else ("velocity", "omega")
        bodies = [n for n in self.links if n not in self.stubs]
        rows = []
        given = {p: vector(k[size]) if size in k else 0j for p, k in self.known.items()}
        given.update({p: 0j for p in self.ground})
        for name in bodies:
            for p in self.links[name]:
                if p in given:
                    self._rows(rows, self._of(name, self.at[p]), given[p] - self._pull(name, self.at[p], second))
            if name in self.drives and ("omega" in self.drives[name] or "rpm" in self.drives[name]):
                drive = self.drives[name]
                speed = drive.get("omega", drive.get("rpm", 0) * math.pi / 30)
                rows.append(({(name, "turn"): 1.0}, drive.get("alpha", 0) if second else speed))
            if name in self.motions:
                motion = self.motions[name]
                place = self.at[motion["at"]]
                self._rows(rows, self._of(name, place), vector(motion.get(size, [0, 0])) - self._pull(name, place, second))
                rows.append(({(name, "turn"): 1.0}, motion.get(rate, 0)))
        for one, other in itertools.combinations(bodies, 2):
            for p in set(self.links[one]) & set(self.links[other]):
                right = self._pull(other, self.at[p], second) - self._pull(one, self.at[p], second)
                self._rows(rows, {**self._of(one, self.at[p]), **self._of(other, self.at[p], -1)}, right)
        for s in self.sliders:
            rows += self._slide(s, bodies, given, second)
        unknowns = [(n, part) for n in bodies for part in ("x", "y", "turn")]
        used = {u for row, _ in rows for u in row}
        found = eliminate(rows, [u for u in unknowns if u in used])
        for n in bodies:
            turn[n] = found.get((n, "turn"), 0.0)
            for p in self.links[n]:
                moves[p] = self._point(found, n, self.at[p], second)
        moves.update(given)
        self._found = found
        for s in self.sliders:
            u, under = self.guides[s.name], 0j if s.on == "ground" else self._point(found, s.on, self.at[s.point], second)
            slides[s.name] = dot(u, moves[s.point] - under)

    def _point(self, found, link, place, second):
        move = complex(found[link, "x"], found[link, "y"]) + 1j * found.get((link, "turn"), 0.0) * self._arm(link, place)
        return move + self._pull(link, place, second)

    def _slide(self, s, bodies, given, second):
        u, place, rows = self.guides[s.name], self.at[s.point], []
        body = s.link or next((n for n in bodies if s.point in self.links[n]), None)
        coefficients, right = {}, 0j
        if s.point in given:
            right -= given[s.point]
        else:
            coefficients.update(self._of(body, place))
            right -= self._pull(body, place, second)
        if s.on != "ground":
            for key, c in self._of(s.on, place, -1).items():
                coefficients[key] = coefficients.get(key, 0) + c
            right += self._pull(s.on, place, second)
        across, along = u * 1j, u
        coriolis = 2 * self.omega.get(s.on, 0) * self.v_r[s.name] if second else 0.0
        rows.append(({k: dot(across, c) for k, c in coefficients.items()}, dot(across, right) + coriolis))
        if s.drive:
            speed = s.drive.get("acceleration", 0) if second else s.drive["speed"]
            rows.append(({k: dot(along, c) for k, c in coefficients.items()}, dot(along, right) + speed))
        if s.link:
            rows.append(({(s.link, "turn"): 1.0, **({(s.on, "turn"): -1.0} if s.on != "ground" else {})}, 0.0))
        return rows

    def of_link(self, link, place, second):
        """Velocity or acceleration of the point of a link that is at a place."""
        first = self.links[link][0]
        start, rate = (self.a, self.alpha) if second else (self.v, self.omega)
        arm = place - self.at[first]
        return start[first] + 1j * rate[link] * arm - (self.omega[link]**2 * arm if second else 0)
