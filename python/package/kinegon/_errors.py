"""What goes wrong: one message, its place, what to try."""

from __future__ import annotations


class KinegonError(ValueError):
    """Why something cannot be done.

    Attributes:
        message: What is wrong.
        hint: What to try, or None.
        path: The JSON path in the scene, as ``links.4.lengths.GD``; empty for the whole.
        line: Line in the text, counted from 1, or None.
        column: Column in characters, counted from 1, or None.
    """

    def __init__(
        self,
        message: str,
        hint: str | None = None,
        path: str = "",
        line: int | None = None,
        column: int | None = None,
    ) -> None:
        super().__init__(message, hint, path, line, column)
        self.message = message
        self.hint = hint
        self.path = path
        self.line = line
        self.column = column

    def __str__(self) -> str:
        place = f"{self.line}:{self.column}: " if self.line is not None else ""
        path = f"{self.path}: " if self.path else ""
        hint = f"; hint: {self.hint}" if self.hint else ""
        return f"{place}{path}{self.message}{hint}"


class SceneError(KinegonError):
    """The scene, a style or a form is not understood; it says where."""


class StructureError(KinegonError):
    """The scene is no mechanism that can be solved."""


class AssemblyError(KinegonError):
    """The links do not reach each other."""


class MotionError(KinegonError):
    """The position is singular."""


class CycleError(KinegonError):
    """The mechanism cannot be moved as was asked for."""


class QuantityError(KinegonError):
    """There is no such quantity, or it has no value here."""


class CheckError(KinegonError):
    """Measured values are not understood."""


class ExerciseError(KinegonError):
    """There is no further exercise."""


class PartialWarning(UserWarning):
    """A limit position comes before the end of the range that was asked for."""
