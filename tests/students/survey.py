"""What the surveys of hands share: forms are checked, what is told of each is counted, and what was answered wrongly is kept.

A sheet with a mistake counts where that moves a value plainly, to 1.5 times what is allowed. *named*: that mistake alone is told; *located*: `unknown`,
at or before the first value that is off; *silent*: nothing is told; *beside*: it is told beside others; *wrong*: something else is told.
"""

import argparse
import json
import math
import subprocess
from collections import Counter
from pathlib import Path


def arguments(doc, honest=600):
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kinegon")
    parser.add_argument("--scenes", type=int, default=60)
    parser.add_argument("--honest", type=int, default=honest)
    parser.add_argument("--each", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--mistake", action="append")
    parser.add_argument("--faults", type=Path, help="a folder for what was answered wrongly")
    parser.add_argument("--limits", action="store_true", help="fails where less is named, or more accused, than is asked for")
    return parser.parse_args()


def check(kinegon, scene, form):
    """What the program says of a form or a drawing, and its words where it refuses it."""
    ran = subprocess.run([kinegon, "check", str(scene), str(form), "--json"], capture_output=True, text=True)
    return (json.loads(ran.stdout) if ran.stdout else None), ran.stderr


def keep(options, scene, name, **files):
    """Keeps a scene and texts beside it, `form=…` as NAME.form.json."""
    if options.faults:
        options.faults.mkdir(exist_ok=True)
        for kind, text in dict(files, scene=scene.read_text()).items():
            (options.faults / f"{name}.{kind}.json").write_text(text)


class Survey:
    """The forms of many sheets and what was told of them."""

    def __init__(self, options, mistakes, is_named):
        self.options, self.is_named, self.wanted = options, is_named, options.mistake or mistakes
        self.kinds, self.honest, self.routes, self.ways = Counter(), Counter(), Counter(), Counter()
        self.outcomes = {mistake: Counter() for mistake in mistakes}
        self.told = {mistake: Counter() for mistake in mistakes}

    def judge(self, scene, form, kind, mistake, route, name):
        """Has a form checked and counts what comes of it; `mistake` is None for an honest hand."""
        result, refused = check(self.options.kinegon, scene, form)
        if result is None:
            raise SystemExit(f"{name}: {refused}")
        told = [found["mistake"] for found in result["diagnosis"]["mistakes"]]
        off = [value for value in result["values"] if value["verdict"] == "off"]
        if mistake is None:
            self.kinds[kind] += 1
            outcome = "accused" if told else "off" if off else "passed"
            self.honest[outcome] += 1
            self.ways[route, outcome] += 1
            is_right = not told and not off
        else:
            if not any(abs(value["difference"]) > 1.5 * value.get("allowed", math.inf) for value in result["values"]):
                return
            outcome = self.outcome(mistake, told, off, result)
            self.outcomes[mistake][outcome] += 1
            self.routes[route, outcome] += 1
            is_right = outcome == "named"
            if not is_right:
                self.told[mistake][" + ".join(told) or "-"] += 1
        if not is_right:
            keep(self.options, scene, name, form=form.read_text())

    def outcome(self, mistake, told, off, result):
        if self.is_named(told, mistake):
            return "named"
        if told == ["unknown"]:
            first = off[0]["step"] if off else 0
            return "located" if result["diagnosis"]["mistakes"][0]["step"] <= first else "wrong"
        return "silent" if not told else "beside" if mistake in told else "wrong"

    def report(self, least, most=1):
        """Prints what came out; 1 where less than `least` per cent of the mistakes are named or more than `most` of the honest accused."""
        count, total = sum(self.honest.values()), Counter()
        print("honest:", count, dict(self.honest), dict(self.kinds))
        for way in sorted({own for own, _ in self.ways}):
            print(f"honest, {way}:", {outcome: n for (own, outcome), n in self.ways.items() if own == way})
        for mistake in self.wanted:
            own = self.outcomes[mistake]
            total.update(own)
            print(f"{mistake:28} {sum(own.values()):5} named {percent(own['named'], own)}  {dict(own)}  {dict(self.told[mistake].most_common(4))}")
        for route in sorted({own for own, _ in self.routes}):
            found = Counter({outcome: n for (own, outcome), n in self.routes.items() if own == route})
            print(f"{route}: {sum(found.values())}, named {percent(found['named'], found)}")
        all_of = max(sum(total.values()), 1)
        named, accused = 100 * total["named"] / all_of, 100 * self.honest["accused"] / max(count, 1)
        print(f"all {all_of}: named {named:.1f} %, wrong {100 * (total['wrong'] + total['beside']) / all_of:.1f} %; honest accused {accused:.2f} %")
        return 1 if self.options.limits and (named < least or accused > most) else 0


def percent(part, of):
    return f"{100 * part / max(sum(of.values()), 1):5.1f} %"
