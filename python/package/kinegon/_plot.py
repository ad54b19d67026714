"""Curves and plans on axes of matplotlib."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from ._errors import KinegonError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

    from ._table import Table

#: What mathtext would obey.
_SIGNS = {"\\": r"\backslash ", "$": r"\$", "#": r"\#", "%": r"\%", "{": r"\{", "}": r"\}", "~": r"\sim ", " ": r"\ "}
#: Colours of a plan's vectors, as on the library's own sheets: what is known before, what is found.
_COLOURS = {"whole": "C0", "relative": "C2", "normal": "C3", "tangential": "C2", "sliding": "C4", "coriolis": "C1"}


def mathtext(markup: str) -> str:
    """A symbol in markup as mathtext.

    >>> mathtext("ω_{4}"), mathtext("a^{n}_{CB}"), mathtext("D_2"), mathtext("a_")
    ('$ω_{4}$', '$a^{n}_{CB}$', '$D_{2}$', '$a\\\\_$')
    """
    return f"${_set(markup)}$" if markup else ""


def _set(markup: str) -> str:
    """Markup as mathtext without its dollars."""
    text, before, rest = "", "", markup
    while rest:
        script = re.match(r"([_^])(?:\{((?:[^{}]|\{[^{}]*\})*)\}|([^{}_^]))", rest)
        if script:
            mark = script[1]
            # Of one letter a second script of the same kind would be refused.
            text += ("{}" if mark in before else "") + f"{mark}{{{_set(script[2] if script[2] is not None else script[3])}}}"
            before, rest = before + mark, rest[script.end() :]
        else:
            sign = rest[0]
            text += {"_": r"\_", "^": r"\wedge "}.get(sign) or _SIGNS.get(sign, sign)
            before, rest = "", rest[1:]
    return text


def axes(given: Axes | None) -> Axes:
    """The axes that are given, or new ones."""
    if given is not None:
        return given
    try:
        from matplotlib import pyplot
    except ImportError:
        raise KinegonError("plots need matplotlib, which is not installed", "pip install 'kinegon[plot]'") from None
    return pyplot.subplots(layout="constrained")[1]


def curves(table: Table, symbols: Sequence[str], names: Sequence[str], given: Axes | None, line: dict[str, Any]) -> Axes:
    """Columns of a table of the motion over its first."""
    units = table.units
    for name in names:
        if name not in units:
            raise KinegonError(f"the table has no column `{name}`", f"its columns are {', '.join(table.names)}")
    kinds = list(dict.fromkeys(units[name] for name in names))
    if len(kinds) > 1:
        told = ", ".join(f"{name} in {units[name] or '1'}" for name in names)
        raise KinegonError(f"one axis has one unit, and here are {told}", f'plot them one by one, as table.plot("{names[0]}", ax=axes[0])')
    symbol = dict(zip(table.names, (mathtext(symbol) for symbol in symbols), strict=True))
    own = axes(given)
    drive = table.names[0]
    for name in names:
        own.plot(table[drive], table[name], **{"label": symbol[name] or name, **line})
    own.set_xlabel(f"{symbol[drive] or drive} ({units[drive]})")
    of = f"{symbol[names[0]] or names[0]} " if len(names) == 1 else ""
    own.set_ylabel(f"{of}({kinds[0]})" if kinds[0] else of)
    if units[drive] == "°":
        from matplotlib.ticker import MaxNLocator

        # Parts of a turn.
        own.xaxis.set_major_locator(MaxNLocator(nbins=9, steps=[1, 1.5, 3, 4.5, 6, 9, 10]))
    if len(names) > 1:
        own.legend()
    own.grid(visible=True, alpha=0.3)
    own.margins(x=0)
    return own


def plan(plan: dict[str, Any], letter: str, given: Axes | None) -> Axes:
    """A plan true to scale: its vectors from the pole and between its points, each point with its name."""
    own = axes(given)
    drawn: list[tuple[list[float], list[float]]] = []
    for vector in plan["vectors"]:
        start, end = vector["from"], vector["to"]
        # Relative to a point at rest a vector is that from the pole, which comes first.
        if start == end or (start, end) in drawn:
            continue
        drawn.append((start, end))
        colour = _COLOURS[vector["part"]]
        arrow = {"arrowstyle": "-|>", "color": colour, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 12}
        own.annotate("", xy=end, xytext=start, arrowprops=arrow, zorder=2)
        if vector["part"] != "whole":
            middle = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
            own.annotate(mathtext(vector["symbol"]), xy=middle, xytext=(3, 3), textcoords="offset points", color=colour, fontsize="small")
    # Points in one place share their names.
    places: dict[tuple[float, float], list[str]] = {}
    size = max((abs(x) for point in plan["points"] for x in point["at"]), default=1.0) or 1.0
    for point in plan["points"]:
        key = (round(point["at"][0] / size, 6), round(point["at"][1] / size, 6))
        names = places.setdefault(key, [])
        if point["symbol"] not in names:
            names.append(point["symbol"])
    for (x, y), names in places.items():
        own.plot(x * size, y * size, "o", color="black", markersize=3, zorder=3)
        text = ", ".join(mathtext(name) for name in names)
        own.annotate(text, xy=(x * size, y * size), xytext=(4, -10), textcoords="offset points")
    own.set_xlabel(f"${letter}_x$ ({plan['unit']})")
    own.set_ylabel(f"${letter}_y$ ({plan['unit']})")
    own.set_aspect("equal", adjustable="datalim")
    own.margins(0.15)
    own.grid(visible=True, alpha=0.3)
    return own
