#!/usr/bin/env python3
"""Whether `kinegon check scene.json drawing.json` names the first wrong operation, on plans that Kinegon did not draw.

    judge.py KINEGON [--seeds N] [--honest N] [--two]    draws, has it judged, prints how right that is
    judge.py KINEGON --self-test                         what is drawn honestly is right, what is planted moves a value

Seeds are counted by scene. The exit code is 1 where a limit is not kept (`--limits`), 2 where a check gave no answer."""

import argparse
import json
import random
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import paper
import scenes
import sheets
import ways
from mistakes import KINDS

# A judge that does not tell a cause says so, or nothing.
NO_NAME = (None, "", "unknown")


class Verdict:
    """What the check says of a drawing, beside what is planted in it."""

    def __init__(self, sheet, said):
        self.sheet, self.said = sheet, said
        self.entries = {e["index"]: e for e in said["entries"]}
        self.first = said.get("first_wrong")
        self.entry, self.kind = sheet.planted[0] if sheet.planted else (None, None)
        self.strictly = self.first == self.entry
        self.right = self.strictly or self.first in sheet.also
        self.name = self.entries.get(self.first, {}).get("mistake") if self.first is not None else None
        self.named = self.right and self.kind is not None and self.name in self.kind.names | sheet.alike
        self.misnamed = self.right and self.kind is not None and self.name not in (*NO_NAME, *self.kind.names, *self.kind.may, *sheet.alike)


def check(kinegon, folder, sheet, number):
    """Has a drawing judged; its verdict, or what went wrong."""
    path = Path(folder) / f"drawing-{number}.json"
    path.write_text(json.dumps(sheet.drawing, ensure_ascii=False), "utf-8")
    run = subprocess.run([kinegon, "check", str(sheet.case.path), str(path), "--json"], capture_output=True, text=True)
    path.unlink()
    try:
        return Verdict(sheet, json.loads(run.stdout)["drawing"])
    except (json.JSONDecodeError, KeyError, TypeError):
        return f"exit {run.returncode}: {(run.stderr or run.stdout).strip()[:400]}"


# ---------------------------------------------------------------- tables

def percent(part, whole):
    return f"{100 * part / whole:5.1f}" if whole else "    –"


def table(title, verdicts, key):
    rows = defaultdict(list)
    for v in verdicts:
        rows[key(v)].append(v)
    print(f"\n| {title} | drawings | first wrong right | itself, not its user | named right | misnamed | nothing found | earlier accused |")
    print("|---|---|---|---|---|---|---|---|")
    for name, some in [*sorted(rows.items()), ("all", verdicts)]:
        nameable = [v for v in some if v.kind.names]
        print(f"| {name} | {len(some)} | {percent(sum(v.right for v in some), len(some))} | "
              f"{percent(sum(v.strictly for v in some), len(some))} | "
              f"{percent(sum(v.named for v in nameable), len(nameable))} | {percent(sum(v.misnamed for v in some), len(some))} | "
              f"{percent(sum(v.first is None for v in some), len(some))} | "
              f"{percent(sum(v.first is not None and v.first < v.entry for v in some), len(some))} |")


def keep_miss(folder, number, verdict, why):
    """A drawing to look at: the scene, the drawing, what is planted and what was said."""
    sheet = verdict.sheet
    place = Path(folder) / f"{number:05}-{sheet.case.name}-{verdict.kind.name if verdict.kind else 'honest'}"
    place.mkdir(parents=True, exist_ok=True)
    (place / "scene.json").write_text(json.dumps(sheet.case.scene, ensure_ascii=False, indent=1), "utf-8")
    head = {k: v for k, v in sheet.drawing.items() if k != "did"}
    did = ",\n  ".join(json.dumps(e, ensure_ascii=False) for e in sheet.drawing["did"])
    text = json.dumps(head, ensure_ascii=False)[:-1] + f', "did": [\n  {did} ] }}\n'
    (place / "drawing.json").write_text(text, "utf-8")
    lines = [f"{why}; hand {sheet.hand}; moved {sheet.moved:.2g}; alone off by (mm or share, hand): {sheet.alone}"]
    for index, kind in sheet.planted:
        lines.append(f"planted {kind.name} at {index}: {json.dumps(sheet.drawing['did'][index], ensure_ascii=False)}")
    if verdict.first is not None:
        lines.append(f"said {verdict.first} ({verdict.name}): {json.dumps(sheet.drawing['did'][verdict.first], ensure_ascii=False)}")
        lines.append(f"     {verdict.entries[verdict.first].get('says')}")
    (place / "why.txt").write_text("\n".join(lines) + "\n", "utf-8")


def judge(options, folder):
    cases = scenes.cases(options.kinegon, options.exercises, options.per_kind, options.only)
    tally = sheets.Counts()
    jobs = [(case, f"{options.seed}-{n}", 0) for case in cases for n in range(options.honest)]
    jobs += [(case, f"{options.seed}-{n}", 2 if options.two else 1) for case in cases for n in range(options.seeds)]

    def work(job):
        number, (case, seed, count) = job
        sheet = sheets.sheet(case, seed, count, options.kinds, tally, symbolic=options.symbolic)
        return number, sheet, check(options.kinegon, folder, sheet, number) if sheet else None

    honest, planted, failed = [], [], Counter()
    with ThreadPoolExecutor(options.jobs) as pool:
        for number, sheet, verdict in pool.map(work, enumerate(jobs)):
            if verdict is None:
                tally["no mistake could be put in"] += 1
            elif isinstance(verdict, str):
                failed[verdict] += 1
                if options.misses:
                    place = Path(options.misses) / f"{number:05}-{sheet.case.name}-failed"
                    place.mkdir(parents=True, exist_ok=True)
                    (place / "scene.json").write_text(json.dumps(sheet.case.scene, ensure_ascii=False), "utf-8")
                    (place / "drawing.json").write_text(json.dumps(sheet.drawing, ensure_ascii=False), "utf-8")
                    (place / "why.txt").write_text(verdict + "\n", "utf-8")
            else:
                (planted if verdict.kind else honest).append(verdict)
                why = miss(verdict)
                if why and options.misses:
                    keep_miss(options.misses, number, verdict, why)
    return honest, planted, failed, tally


def miss(v):
    """Why a drawing is one to look at."""
    if v.kind is None:
        return None if v.first is None else "an honest drawing is accused"
    if not v.right:
        return "nothing found" if v.first is None else "another operation is named first"
    if v.kind.names and not v.named:
        return f"named {v.name}"
    return "misnamed" if v.misnamed else None


def report(honest, planted, failed, tally, options):
    if planted:
        table("kind of mistake", planted, lambda v: v.kind.name)
        table("scene", planted, lambda v: f"{v.sheet.case.group}: {v.sheet.case.name.rsplit('-3-', 1)[0]}")
        table("snap", planted, lambda v: f"{v.sheet.hand.snap}{'' if v.sheet.hand.snap == 'all' or v.sheet.hand.stated else ', not stated'}")
    accused = sum(v.first is not None for v in honest)
    if honest:
        print(f"\nOf {len(honest)} honest drawings {accused} are accused.")
    print("\nMistakes " + ", ".join(f"{what}: {count}" for what, count in sorted(tally.items())) + ".")
    for message, count in failed.most_common(10):
        print(f"{count} drawings without an answer: {message}")
    right = sum(v.right for v in planted)
    nameable = [v for v in planted if v.kind.names]
    least = 0.90 if options.two else 0.95
    kept = not accused and right >= least * len(planted) and (options.two or sum(v.named for v in nameable) >= 0.90 * len(nameable))
    return 2 if failed else 1 if options.limits and not kept else 0


def every_prefix(options, folder):
    """Whether each beginning of a drawing is judged, and honest ones are not accused."""
    asked, failed, accused = 0, Counter(), Counter()
    for case in scenes.cases(options.kinegon, options.exercises, options.per_kind, options.only):
        for n in range(options.prefixes):
            sheet = sheets.sheet(case, f"{options.seed}-{n}", n % 2) or sheets.sheet(case, f"{options.seed}-{n}", 0)
            stays = {i for i, _ in paper.standing(sheet.drawing["did"])}
            for end in range(len(sheet.drawing["did"]) + 1):
                begun = sheets.Sheet(case, sheet.seed, sheet.hand, {**sheet.drawing, "did": sheet.drawing["did"][:end]})
                said = check(options.kinegon, folder, begun, 0)
                asked += 1
                if isinstance(said, str):
                    failed[f"{case.name} {n}, {end} entries: {said}"] += 1
                elif said.first in stays and not sheet.planted:
                    accused[f"{case.name} {n}: entry {said.first}"] += 1
                    if options.misses:
                        keep_miss(options.misses, asked, said, f"an honest beginning of {end} entries is accused")
    print(f"{asked} beginnings of drawings, {sum(failed.values())} without an answer, {sum(accused.values())} of honest ones accused")
    print("\n".join(list(failed)[:10] + list(accused)[:10]))
    return 2 if failed else 1 if accused else 0


def garble(text, rng):
    """A drawing with some of its parts lost, doubled, exchanged or made absurd."""
    drawing = json.loads(text)
    did = drawing["did"]
    for _ in range(rng.randint(1, 4)):
        i, k = rng.randrange(len(did)), rng.randrange(len(did))
        way, keys = rng.randrange(7), list(did[i])
        key = rng.choice(keys)
        if way == 0:
            del did[i]
        elif way == 1:
            did[i], did[k] = did[k], did[i]
        elif way == 2:
            did.insert(k, dict(did[i]))
        elif way == 3:
            did[i] = {**did[i], key: rng.choice([0, -1e300, "", "p", "b(", [], {}, ["b"], None, "1/0", "omega(99)", 1e17])}
        elif way == 4:
            did[i].pop(key)
        elif way == 5:
            did[i] = {**did[i], key: rng.choice(list(did[k].values()))}
        else:
            did.insert(i, {"undo": rng.choice([1, 2, 5, 10**9])})
        if not did:
            break
    return json.dumps(drawing, ensure_ascii=False)


def garbled(options, folder):
    """Whether the program answers drawings that make no sense, in words."""
    rng, asked, bad = random.Random(options.seed), 0, Counter()
    for case in scenes.cases(options.kinegon, options.exercises, options.per_kind, options.only):
        for n in range(options.garbled):
            text = garble(json.dumps(sheets.sheet(case, f"{options.seed}-{n}", 0).drawing), rng)
            path = Path(folder) / "garbled.json"
            path.write_text(text, "utf-8")
            run = subprocess.run([options.kinegon, "check", str(case.path), str(path), "--json"], capture_output=True, text=True)
            asked += 1
            if run.returncode not in (0, 1, 2) or run.returncode == 2 and not run.stderr.startswith("error"):
                bad[f"{case.name} {n}: exit {run.returncode}: {run.stderr[:200]}"] += 1
                if options.misses:
                    Path(options.misses).mkdir(parents=True, exist_ok=True)
                    (Path(options.misses) / f"{case.name}-{n}.json").write_text(text, "utf-8")
    print(f"{asked} garbled drawings, {sum(bad.values())} without an answer in words")
    print("\n".join(list(bad)[:10]))
    return 2 if bad else 0


# ---------------------------------------------------------------- self-test

def self_test(options):
    """Exact honest drawings end in the truth; free ones near it; planted mistakes move a value."""
    cases = scenes.cases(options.kinegon, options.exercises, options.per_kind, options.only)
    bad, drawn, tally, kinds = 0, 0, sheets.Counts(), Counter()
    for case in cases:
        for seed in range(options.seeds):
            honest = sheets.sheet(case, seed, hand=ways.Hand(digits=12))
            right = ways.largest_move(expected(case, seed), ways.values(paper.replay(case.mechanism, honest.drawing), ()))
            free = sheets.sheet(case, seed, hand=ways.Hand("none", mm=0.001, degrees=0.001, digits=9, reads=False))
            near = ways.largest_move(expected(case, seed), ways.values(paper.replay(case.mechanism, free.drawing), ()))
            drawn += 2
            if right > 1e-8 or near > 0.01:
                bad += 1
                print(f"{case.name} {seed}: off by {right:.1e} drawn exactly, {near:.1e} by a hand of a thousandth")
            wrong = sheets.sheet(case, seed, 1, tally=tally)
            if wrong:
                kinds[wrong.planted[0][1].name] += 1
    print(f"{drawn} honest drawings of {len(cases)} scenes, {bad} off; {sum(kinds.values())} mistakes of {len(kinds)} of {len(KINDS)} kinds")
    print("; ".join(f"{what}: {count}" for what, count in sorted(tally.items())))
    print("never put in:", *sorted(set(KINDS) - set(kinds)))
    return 1 if bad else 0


def expected(case, seed):
    return case.draft(random.Random(f"{case.name} {seed} 0")).expected


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kinegon")
    parser.add_argument("--seeds", type=int, default=20, help="drawings with a mistake of each scene")
    parser.add_argument("--honest", type=int, default=20, help="honest drawings of each scene")
    parser.add_argument("--two", action="store_true", help="two mistakes in each drawing")
    parser.add_argument("--symbolic", action="store_true", help="no typed numbers, none in formulas")
    parser.add_argument("--seed", default="1", help="other drawings for another word")
    parser.add_argument("--only", nargs="*", default=(), help="scenes whose names hold one of these words")
    parser.add_argument("--kinds", nargs="*", default=(), help="only these kinds of mistakes")
    parser.add_argument("--per-kind", type=int, default=3, help="exercises of each kind")
    parser.add_argument("--exercises", default="", help="a folder that keeps the exercises")
    parser.add_argument("--misses", help="a folder for the drawings that were judged wrongly")
    parser.add_argument("--prefixes", type=int, default=0, help="so many drawings of each scene are judged entry by entry, too")
    parser.add_argument("--garbled", type=int, default=0, help="so many drawings of each scene with parts lost or exchanged")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--limits", action="store_true",
                        help="exit 1 where first wrong < 95 %% (two mistakes: 90 %%), name < 90 %%, or an honest one is accused")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        options.exercises = options.exercises or f"{folder}/exercises"
        Path(options.exercises).mkdir(parents=True, exist_ok=True)
        if options.self_test:
            return self_test(options)
        if options.prefixes:
            return every_prefix(options, folder)
        if options.garbled:
            return garbled(options, folder)
        return report(*judge(options, folder), options)


if __name__ == "__main__":
    sys.exit(main())
