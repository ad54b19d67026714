"""Prints the times of one position, by job, with their ratios to Kinegon's best."""

import itertools
import platform

import four_bar
import kinegon
import paper
import programs


def main():
    sources = (paper, four_bar, programs, kinegon)
    rows = sorted(itertools.chain.from_iterable(source.measure() for source in sources))
    print(f"{platform.processor() or platform.machine()}, Python {platform.python_version()}\n")
    print("| job | who | time of one position | times Kinegon's best |\n|---|---|---|---|")
    for job, group in itertools.groupby(rows, key=lambda row: row[0]):
        group = sorted(group, key=lambda row: row[2])
        own = min((time for _, who, time in group if who.startswith("Kinegon")), default=float("nan"))
        for _, who, time in group:
            print(f"| {job} | {who} | {shown(time)} | {time / own:.3g} |")


def shown(nanoseconds):
    for unit, size in (("ns", 1.0), ("µs", 1e3)):
        if nanoseconds < 1000 * size:
            return f"{nanoseconds / size:.3g} {unit}"
    return f"{nanoseconds / 1e6:.3g} ms"


main()
