"""Velocity and acceleration plans of planar mechanisms, true to scale, and the numbers behind them.

>>> import kinegon
>>> solution = kinegon.Scene.kind("paper-figure-2").solve()
>>> print(solution.quantity("omega(4)"))
omega(4) = -0.4746637548935638 ± 2e-16 rad/s
>>> solution.save("figure-2.pdf")

x is right, y is up, counter-clockwise is positive. Lengths and times are in the scene's units, angles in degrees, rates in
rad per unit of time. Whatever cannot be done raises a :class:`KinegonError`, a ValueError, with message, place and hint.
"""

from ._builder import Builder
from ._check import Check
from ._errors import (
    AssemblyError,
    CheckError,
    CycleError,
    ExerciseError,
    KinegonError,
    MotionError,
    PartialWarning,
    QuantityError,
    SceneError,
    StructureError,
)
from ._kinegon import KINDS as _kinds
from ._kinegon import STATUSES as _statuses
from ._kinegon import __version__
from ._scene import Exercise, Mode, Scene
from ._solution import Extremes, Interactive, Quantity, Solution, Step, Steps
from ._study import Study
from ._table import Table

KINDS: tuple[str, ...] = tuple(_kinds)
"""The names of the starting scenes."""
STATUSES: tuple[str, ...] = tuple(_statuses)
"""What may become of a mechanism of a study."""

__all__ = [
    "KINDS",
    "STATUSES",
    "AssemblyError",
    "Builder",
    "Check",
    "CheckError",
    "CycleError",
    "Exercise",
    "ExerciseError",
    "Extremes",
    "Interactive",
    "KinegonError",
    "Mode",
    "MotionError",
    "PartialWarning",
    "Quantity",
    "QuantityError",
    "Scene",
    "SceneError",
    "Solution",
    "Step",
    "Steps",
    "StructureError",
    "Study",
    "Table",
    "__version__",
]
