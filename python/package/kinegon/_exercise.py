"""Exercises to be drawn by hand."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any

from . import _files, _kinegon
from ._errors import KinegonError

if TYPE_CHECKING:
    from ._scene import Scene


class Exercise:
    """An exercise: its scene, the student's sheet, the empty form, and the key for the teacher."""

    def __init__(self, native: _kinegon.Exercise, name: str) -> None:
        self._native = native
        #: Its name, as ``four-bar-7-1``: kind, seed, number.
        self.name = name

    @property
    def scene(self) -> Scene:
        """Its scene."""
        from ._scene import Scene

        return Scene(self._native.text())

    def sheet(self, format: _files.Format = "svg", *, outlines: bool = False, dpi: float = 100.0) -> str | bytes:
        """The student's sheet: the scheme, what is given, boxes for the results; svg, png, pdf or tikz.

        A PDF has the sheets for the plans, too, as further pages.
        """
        return self.sheets(format, outlines=outlines, dpi=dpi)[0]

    def sheets(self, format: _files.Format = "svg", *, outlines: bool = False, dpi: float = 100.0) -> list[str | bytes]:
        """The student's sheets: that with the scheme, then those for the plans; as PDF one file with all of them."""
        form = _files.form_of(format, outlines=outlines, dpi=dpi)
        return [_files.opened(file, format) for file in self._native.draw(self.name, form)]

    def key_sheet(self, format: _files.Format = "svg", *, outlines: bool = False, dpi: float = 100.0) -> str | bytes:
        """The drawn key: scheme, plans, all values with what a careful hand is allowed; svg, png, pdf or tikz."""
        return _files.opened(self._native.draw_key(_files.form_of(format, outlines=outlines, dpi=dpi)), format)

    def key(self) -> dict[str, Any]:
        """The values of the key by the names of their quantities, each with its unit, what is allowed, and its step."""
        key: dict[str, Any] = json.loads(self._native.key())
        return key

    def form(self, format: str = "json") -> str:
        """The empty form, to be filled in and checked: ``json``, or ``csv`` for a spreadsheet."""
        return self._native.form(self.name, _files.form_is_table(format))

    def save(self, folder: str | os.PathLike[str]) -> str:
        """Writes the files of ``kinegon exercise`` into ``folder/NAME``, which must not be there yet; its path."""
        own = os.path.join(os.fspath(folder), self.name)
        if os.path.exists(own):
            raise KinegonError(f"{own} is there already and is not overwritten", "choose another folder or another seed, or remove it")
        files: dict[str, str | bytes] = {"scene.json": self._native.text()}
        for format in ("svg", "pdf"):
            files[f"key.{format}"] = self.key_sheet(format)
            for number, sheet in enumerate(self.sheets(format), 1):
                files[f"sheet.{format}" if number == 1 else f"sheet-{number}.{format}"] = sheet
        files |= {"form.json": self.form(), "form.csv": self.form("csv"), "key.json": self._native.key_file()}
        os.makedirs(own)
        _files.write_all({os.path.join(own, name): data if isinstance(data, bytes) else data.encode() for name, data in files.items()})
        return own

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        return {"text/plain": repr(self), "image/svg+xml": str(self.sheet("svg", outlines=True))}

    def __repr__(self) -> str:
        return f"<kinegon.Exercise: {self.name}>"
