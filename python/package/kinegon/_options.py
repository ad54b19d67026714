"""Keywords of what draws, for type checkers and editors alone: nothing imports them when a program runs."""

from __future__ import annotations

import os
from typing import TypedDict

from .types import FigureKeys, StyleFile, StyleName


class SheetOptions(TypedDict, total=False):
    """How a sheet is written."""

    outlines: bool
    """Letters of an SVG as outlines, for programs that lack the font."""
    dpi: float
    """Resolution of a PNG or a film in dots per inch, 10 to 2400."""


class DrawOptions(FigureKeys, SheetOptions, total=False):
    """What a figure shows, and how it is written."""

    coarse: bool
    """Count steps as a lecturer shows them together."""
    layered: bool
    """An SVG with a group for each step, for slide programs."""
    style: StyleName | os.PathLike[str] | StyleFile | None
    """The name of a style, or a style file: its path, a dict. A path as a str is taken, too, but no type checker knows it from a misspelt name."""
    seconds: float | None
    """How long a turn of a film lasts, or going to and fro once; 5 without it."""
    fps: int | None
    """Pictures of a film in a second, 1 to 50; 20 without it."""
    drive: str | None
    """The drive that a film follows, if not the first; others run along in proportion to their speeds."""
