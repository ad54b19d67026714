"""Kinegon's own times, from `cargo bench -p kinegon-benches`."""

import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Job, who, the bench's name as its lines are nested, how many positions it computes. What the benches do not have is left out.
BENCHES = [
    ("paper", "Kinegon: many, all links", "batch_of_links/2/paper", 32_000),
    ("paper", "Kinegon: many, with all joints", "batch_with_joints/2/paper", 32_000),
    ("paper", "Kinegon: one by one", "thousand/2/paper", 1000),
    ("paper", "Kinegon: one after another, wherever the drive goes", "one_after_another/mover", 2000),
    ("paper", "Rust, for this mechanism alone: one after another", "one_after_another/by-hand", 2000),
    ("paper, v and a alone", "Kinegon: many, all links", "batch_of_links/1/paper", 32_000),
    ("paper, v and a alone", "Kinegon: one by one", "thousand/1/paper", 1000),
    ("four-bar", "Kinegon: many, all links", "batch_of_links/2/four-bar", 32_000),
    ("four-bar", "Kinegon: many, with all joints", "batch_with_joints/2/four-bar", 32_000),
    ("four-bar", "Kinegon: one by one", "thousand/2/four-bar", 1000),
]

UNITS = {"ns": 1.0, "µs": 1e3, "ms": 1e6, "s": 1e9}
# Branches before the name, then fastest │ slowest │ median and more.
LINE = re.compile(r"^(?P<tree>[│├╰─ ]*)(?P<name>\S+)\s+(?P<value>[\d.]+) (?P<unit>ns|µs|ms|s)\s*│|^(?P<branch>[│├╰─ ]*)(?P<group>\S+)\s+│")


def parsed(text):
    """The fastest time of each bench in nanoseconds, by its path."""
    times, path = {}, []
    for line in text.splitlines():
        found = LINE.match(line)
        if not found:
            continue
        tree = found["tree"] if found["name"] else found["branch"]
        del path[max(len(tree) // 3 - 1, 0) :]
        path.append(found["name"] or found["group"])
        if found["name"]:
            times["/".join(path)] = float(found["value"]) * UNITS[found["unit"]]
    return times


def measure():
    """Rows of the table: job, who, nanoseconds."""
    command = ["cargo", "bench", "--quiet", "--locked", "-p", "kinegon-benches", "--bench", "speed"]
    names = sorted({path.split("/")[0] for _, _, path, _ in BENCHES})
    done = subprocess.run([*command, "--", *names], cwd=ROOT, check=True, capture_output=True, text=True)
    times = parsed(done.stdout)
    for job, who, path, positions in BENCHES:
        if path in times:
            yield job, who, times[path] / positions
