"""A hand for friction: the force plans of `forces.py` with friction in guides and pins, which its author finds by solving the whole equilibrium again and again, and one
mistake with it on purpose.

    friction.py KINEGON [--scenes N] [--honest N] [--each N] [--mistake NAME] [--faults FOLDER] [--limits]
"""

import copy
import json
import math
import random
import sys
import tempfile
from pathlib import Path

import forces
from forces import Mechanism, Sheet, Stuck, drawable, dot, left, scaled, size, text, unit
from survey import Survey, arguments

MISTAKES = ["friction-sense", "angle-for-coefficient", "normal-without-lean", "friction-circle-diameter", "friction-left-out"]
TIMES = 60

# How a hand comes to its friction that does not know it.
WAYS = ["anew", "corrected", "leaning"]


class Rough(Mechanism):
    """A mechanism whose `rubs` are (joint, angle of friction in degrees, radius of the journal); a joint is a pin's name or the index of a guide. `factors` has, by joint,
    by what a hand takes its friction wrongly."""

    rubs, factors, rub = [], {}, {}

    def across(self, joint, reactions, guides):
        """What presses in a joint."""
        if isinstance(joint, int):
            return abs(guides[self.guides[joint][0]][0])
        return size(next(force for (pin, _), force in reactions.items() if pin == joint))

    def resisting(self, joint, degrees, radius, pressing):
        """Forces and couples on links by the friction of a joint that is pressed so."""
        factor = self.factors.get(joint, 1.0)
        if isinstance(joint, int):
            link, at, along = self.guides[joint]
            speed = dot(self.velocity(link, self.points[at]), unit(along))
            return [(link, at, scaled(unit(along), -math.copysign(math.tan(math.radians(degrees)) * pressing * factor, speed)), 0.0)]
        couple = radius * math.sin(math.radians(degrees)) * pressing * factor
        _, a, b = next(pin for pin in self.pins() if pin[0] == joint)
        turning = [0.0 if link == "0" else self.motion[link][1] for link in (a, b)]
        sense = math.copysign(couple, turning[0] - turning[1])
        return [(a, joint, (0.0, 0.0), -sense), (b, joint, (0.0, 0.0), sense)]

    def loads(self):
        found = super().loads()
        for joint, parts in self.rub.items():
            for link, at, force, couple in parts:
                if link == "0":
                    continue
                if size(force) > 1e-9:
                    found[link][0].append((f"Ff{joint}", self.points[at], force))
                if abs(couple) > 1e-9:
                    found[link][1].append((f"Mf{joint}", couple))
        return found

    def found(self, reactions, guides):
        return {joint: self.resisting(joint, degrees, radius, self.across(joint, reactions, guides)) for joint, degrees, radius in self.rubs}

    def truth(self):
        """Forces and friction in turn, until nothing changes."""
        self.rub = {}
        before = None
        for _ in range(TIMES):
            reactions, guides, torque = super().truth()
            if before is not None and abs(torque - before) < 1e-10 * max(abs(torque), 1.0):
                return reactions, guides, torque
            before = torque
            self.rub = self.found(reactions, guides)
        raise Stuck

    def scene(self, panels, mu):
        scene = super().scene(panels, mu)
        scene["friction"] = [{"guide": f"{self.guides[joint][0]}/ground", self.key: self.given(degrees)} if isinstance(joint, int) else
                             {"pin": joint, self.key: self.given(degrees), "radius": radius} for joint, degrees, radius in self.rubs]
        return scene

    def given(self, degrees):
        return degrees if self.key == "angle" else math.tan(math.radians(degrees))


def rough(kind):
    def made(rng):
        m = kind(rng)
        m.__class__ = Rough
        m.key = rng.choice(["angle", "coefficient"])
        joints = list(range(len(m.guides))) + [name for name, *_ in m.pins()]
        m.rubs = [(joint, float(rng.choice([8, 10, 12, 15, 18, 22, 28, 35])), float(rng.choice([10, 12, 15, 18, 20, 30, 40]))) for joint in joints if rng.random() < 0.6]
        if not m.rubs:
            raise Stuck
        return m
    made.__name__ = kind.__name__
    return made


def mistaken(m, mistake, rng):
    """The mechanism as somebody takes it who errs: friction that is wrong in one joint or in all, and the others' after it or as it was."""
    wrong = copy.copy(m)
    joints = [joint for joint, _, _ in m.rubs]
    if mistake == "friction-circle-diameter":
        joints = [joint for joint in joints if not isinstance(joint, int)]
    if not joints:
        raise Stuck
    chosen = joints if rng.random() < 0.5 else [rng.choice(joints)]
    degrees = {joint: phi for joint, phi, _ in m.rubs}
    if mistake == "normal-without-lean":
        smooth = copy.copy(m)
        smooth.rub = {}
        reactions, guides, _ = Mechanism.truth(smooth)
        of_smooth = m.found(reactions, guides)
        wrong.rub = {joint: of_smooth[joint] if joint in chosen else own for joint, own in m.rub.items()}
        return wrong

    def factor(joint):
        phi = math.radians(degrees[joint])
        right = math.tan(phi) if isinstance(joint, int) else math.sin(phi)
        if mistake == "angle-for-coefficient":
            angle = phi if m.key == "angle" else math.tan(math.tan(phi)) if isinstance(joint, int) else math.sin(math.tan(phi))
            other = math.sin(phi) if isinstance(joint, int) else math.tan(phi)
            return rng.choice([angle, other]) / right
        return {"friction-sense": -1.0, "friction-circle-diameter": 2.0, "friction-left-out": 0.0}[mistake]

    wrong.factors = {joint: factor(joint) for joint in chosen}
    if rng.random() < 0.6:
        wrong.truth()
    else:
        wrong.rub = {joint: [(link, at, scaled(force, wrong.factors.get(joint, 1.0)), couple * wrong.factors.get(joint, 1.0)) for link, at, force, couple in own]
                     for joint, own in m.rub.items()}
    return wrong


def errors_of(m, rng):
    """By joint: how many times as large its friction becomes by an angle of friction that is read wrongly, or by a line that does not quite touch the circle."""
    found = {}
    for joint, degrees, radius in m.rubs:
        if isinstance(joint, int):
            found[joint] = math.tan(math.radians(degrees + rng.uniform(-forces.DEGREES, forces.DEGREES))) / math.tan(math.radians(degrees))
        else:
            circle = radius * math.sin(math.radians(degrees))
            found[joint] = (circle + rng.uniform(-forces.MM, forces.MM) * m.mu_l) / circle
    return found


def own_drawing(m, mu_l, mu_f, rng, way):
    """Friction found from what an own drawing shows, in passes from smooth joints on. `way`: `anew` draws each pass on a new sheet, `corrected` draws once and corrects
    what follows from the friction, `leaning` does so with forces that lean by an angle that is drawn and touch circles that are drawn."""
    passed = copy.copy(m)
    passed.mu_l, passed.rub = mu_l, {}
    seed, route = rng.randrange(1 << 30), rng.randrange(3)
    passed.factors = errors_of(passed, rng) if way == "leaning" else {}
    torque = None
    for _ in range(TIMES):
        pencil = rng if way == "anew" else random.Random(seed)
        drawn = Sheet(passed, mu_l, mu_f, pencil, None, route)
        before, torque = torque, drawn.values["T(1)"]
        if before is not None and abs(torque - before) < (0.03 if way == "anew" else 0.002) * max(abs(torque), 1.0):
            return drawn
        passed.rub = {joint: passed.resisting(joint, degrees, radius, pressed(passed, drawn, joint)) for joint, degrees, radius in m.rubs}
    raise Stuck


def pressed(m, drawn, joint):
    """What presses in a joint, as the drawing shows it."""
    if isinstance(joint, int):
        return abs(drawn.values[f"N({m.guides[joint][0]}/ground)"])
    return next(value for name, value in drawn.values.items() if name.startswith(f"R({joint},") and name.endswith(".size"))


def run(options):
    rng = random.Random(options.seed)
    survey = Survey(options, MISTAKES, lambda told, mistake: bool(told) and all(t == mistake for t in told))
    kinds = [rough(kind) for kind in (forces.slider_crank, forces.four_bar, forces.slider_crank, forces.six_bar, forces.third_class)]
    for index in range(options.scenes):
        kind = kinds[index % len(kinds)]
        with tempfile.TemporaryDirectory() as work:
            work = Path(work)
            m, mu_l, mu_f, _, form, names, total = drawable(guarded(kind), rng, options.kinegon, work, False)
            m.truth()
            sheets = [(None, n) for n in range(-(-options.honest // options.scenes))]
            sheets += [(mistake, n) for mistake in survey.wanted for n in range(-(-options.each // options.scenes * 2))]
            for mistake, number in sheets:
                try:
                    Sheet.total = total
                    if mistake or number % 4 == 0:
                        drawn = Sheet(mistaken(m, mistake, rng) if mistake else m, mu_l, mu_f, rng, None, rng.randrange(3))
                    else:
                        drawn = own_drawing(m, mu_l, mu_f, rng, WAYS[number % 4 - 1])
                except (Stuck, ZeroDivisionError, IndexError):
                    continue
                key = f"{mistake or 'honest'}-{number}"
                form["values"] = {name: text(name, drawn.values[name]) for name in names if name in drawn.values}
                form["name"], form["positive"] = key, "counter-clockwise"
                (work / f"{key}.json").write_text(json.dumps(form))
                route = m.key if mistake else WAYS[number % 4 - 1] if number % 4 else "known"
                survey.judge(work / "scene.json", work / f"{key}.json", kind.__name__, mistake, route, f"{kind.__name__}-{index}-{key}")
    return survey.report(least=85)


def guarded(kind):
    """Mechanisms alone that friction does not lock, and in which no joint that rubs stands still."""
    def made(rng):
        m = kind(rng)
        m.motion = m.rates()
        m.truth()
        if len(m.rub) < len(m.rubs):
            raise Stuck
        return m
    made.__name__ = kind.__name__
    return made


if __name__ == "__main__":
    sys.exit(run(arguments(__doc__)))
