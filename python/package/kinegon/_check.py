"""Verdicts on values that were measured on a hand drawing."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, overload

from . import _files, _kinegon
from ._files import SheetBytes, SheetFormat, SheetText, Source

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._options import SheetOptions
    from .types import CheckResult


class Check:
    """The verdict on a form, and what probably went wrong. ``print(check)`` shows the report of ``kinegon check``."""

    def __init__(self, solution: _kinegon.Solution, form: str, options: _kinegon.CheckOptions) -> None:
        self._solution, self._form, self._options = solution, form, options
        result, self.report, self.is_passed = solution.check(form, options)
        self.result: CheckResult = json.loads(result)
        """As ``kinegon check --json`` prints it."""
        self.drawing: dict[str, Any] | None = json.loads(result).get("drawing")
        """Of a drawing: the verdicts on its ``entries``, and ``first_wrong``, the index of the first wrong one; else None."""

    def feedback(self) -> str:
        """The page for the student, HTML, as ``kinegon check --feedback`` writes it."""
        return self._solution.feedback(self._form, self._options)

    @overload
    def draw(self, format: SheetText = "svg", *, sheet: int = 1, **options: Unpack[SheetOptions]) -> str: ...
    @overload
    def draw(self, format: SheetBytes, *, sheet: int = 1, **options: Unpack[SheetOptions]) -> bytes: ...
    @overload
    def draw(self, format: SheetFormat, *, sheet: int = 1, **options: Unpack[SheetOptions]) -> str | bytes: ...
    def draw(self, format: SheetFormat = "svg", *, sheet: int = 1, **options: Unpack[SheetOptions]) -> str | bytes:
        """The student's drawing over the right one: sheet 1; the table of values: the sheets behind it."""
        sheets = self._solution.correction(self._form, self._options, _files.form_of(format, **options))
        return _files.sheet_of(sheets, sheet, format)

    def __eq__(self, other: object) -> bool:
        """Whether verdicts and reports are the same."""
        return (self.result, self.report) == (other.result, other.report) if isinstance(other, Check) else NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def __str__(self) -> str:
        return self.report

    def __repr__(self) -> str:
        return f"<kinegon.Check: {'passed' if self.is_passed else 'not passed'}>"


def form_text(form: Source | Mapping[str, float]) -> tuple[str, bool]:
    """The text of a form, and whether it is known to be a table. A dict of values by names is a form, too, with the
    senses of this library."""
    if isinstance(form, Mapping):
        senses = {"kinegon_measured": 1, "positive": "counter-clockwise"}
        is_file = "kinegon_measured" in form or "kinegon_drawing" in form
        return _files.dumped(form if is_file else {**senses, "values": form}), False
    is_file = not _files.is_text(form)
    is_table = is_file and os.fsdecode(form).lower().endswith(".csv")
    return _files.source_text(form, "form"), is_table
