"""Verdicts on values that were measured on a hand drawing."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import Any

from . import _files, _kinegon
from ._files import Source


class Check:
    """The verdict on a form, and what probably went wrong. ``print(check)`` shows the report of ``kinegon check``."""

    def __init__(self, solution: _kinegon.Solution, form: str, options: _kinegon.CheckOptions) -> None:
        self._solution, self._form, self._options = solution, form, options
        result, self.report, self.is_passed = solution.check(form, options)
        #: As ``kinegon check --json`` prints it.
        self.result: dict[str, Any] = json.loads(result)

    def feedback(self) -> str:
        """The page for the student, HTML, as ``kinegon check --feedback`` writes it."""
        return self._solution.feedback(self._form, self._options)

    def draw(self, format: _files.Format = "svg", *, sheet: int = 1, outlines: bool = False, dpi: float = 100.0) -> str | bytes:
        """The student's drawing over the right one: sheet 1; the table of values: the sheets behind it."""
        form = _files.form_of(format, outlines=outlines, dpi=dpi)
        sheets = self._solution.correction(self._form, self._options, form)
        return _files.sheet_of(sheets, sheet, format)

    def __str__(self) -> str:
        return self.report

    def __repr__(self) -> str:
        return f"<kinegon.Check: {'passed' if self.is_passed else 'not passed'}>"


def form_text(form: Source | Mapping[str, float]) -> tuple[str, bool]:
    """The text of a form, and whether it is known to be a table. A dict of values by names is a form, too, with the
    senses of this library."""
    if isinstance(form, Mapping):
        senses = {"kinegon_measured": 1, "positive": "counter-clockwise"}
        return _files.dumped(form if "kinegon_measured" in form else {**senses, "values": form}), False
    is_file = not _files.is_text(form)
    is_table = is_file and os.fsdecode(form).lower().endswith(".csv")
    return _files.source_text(form, "form"), is_table
