"""Scenes: mechanisms as text; and their exercises, to be drawn by hand."""

from __future__ import annotations

import itertools
import json
import os
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, overload

from . import _files, _kinegon
from ._errors import KinegonError
from ._files import BytesFormat, FormFormat, Format, SheetBytes, SheetFormat, SheetText, Source, TextFormat
from ._solution import Solution
from ._table import Table
from ._wanted import asked, counted, warn_of

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._options import DrawOptions, SheetOptions
    from .types import FigureOptions, Key, SceneFile


class Mode(NamedTuple):
    """A way to assemble a scene."""

    number: int
    """Its number, as ``kinegon modes`` counts; ``scene.solve(mode=…)`` takes it."""
    points: dict[str, tuple[float, float]]
    """The places of moving points that are sought, ``(x, y)`` in the scene's unit of length."""
    angles: dict[str, float]
    """The angles of links in degrees from +x, in (−180, 180]."""
    is_own: bool
    """Whether it is the one that the scene's ``near`` picks."""
    text: str
    """The same in words."""

    def __str__(self) -> str:
        return f"{self.number}. {self.text}"


class Scene:
    """A mechanism as its scene file describes it.

    Args:
        source: The text of a scene, a dict of the same keys, or the path of a scene file. A str is a text if it has a
            brace or a line break, else a path.

    Raises:
        SceneError: It is not understood; ``message``, ``path``, ``line``, ``column``, ``hint`` say what and where.
        OSError: The file cannot be read.
    """

    def __init__(self, source: Source) -> None:
        is_path = isinstance(source, (str, os.PathLike)) and not _files.is_text(source)
        self._native = _kinegon.Scene(_files.source_text(source, "scene"), isinstance(source, (str, os.PathLike)))
        self.name = _files.stem(source) if is_path else "scene"
        """The name of its exercises: the kind, or the file's name without its ending."""

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Scene:
        """The scene of a file."""
        scene = cls(_files.read(path, "scene"))
        scene.name = _files.stem(path)
        return scene

    @classmethod
    def kind(cls, name: str) -> Scene:
        """The starting scene of a kind of mechanism, as ``four-bar``; ``kinegon.KINDS`` has all names."""
        scene = cls(_kinegon.kind(name))
        scene.name = name
        return scene

    @property
    def text(self) -> str:
        """The text of its scene file."""
        return self._native.text

    @property
    def title(self) -> str | None:
        """Its title, if it has one."""
        return self._native.title()

    def to_dict(self) -> dict[str, Any]:
        """The scene as a dict, to be changed and read again."""
        scene: dict[str, Any] = json.loads(self.text.removeprefix("\ufeff"))
        return scene

    def _plain(self) -> dict[str, Any]:
        """What stands for it where it is a part of a dict that is written as JSON."""
        return self.to_dict()

    def with_figure(self, **figure: Unpack[FigureOptions]) -> Scene:
        """The same scene with these keys of its ``figure``; None takes one out."""
        scene = Scene.__new__(Scene)
        scene._native, scene.name = self._native.with_figure(_files.figure_keys(figure)), self.name
        return scene

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes its text to a file, which is complete or not there."""
        _files.write_all({os.fspath(path): self.text.encode("utf-8")})

    def solve(self, *, mode: int | None = None) -> Solution:
        """Position, velocities and accelerations; in the assembly mode of that number, else in the one nearest to ``near``.

        Raises:
            StructureError, AssemblyError, MotionError: It is no mechanism, cannot be assembled, or is in a singular position.
        """
        solution = Solution(self._native.solve(counted("mode", mode, 1)))
        solution._origin = (self.text, mode)
        return solution

    def structure(self) -> str:
        """The Assur groups in solving order, as ``kinegon structure`` prints them."""
        return self._native.structure()

    def modes(self) -> list[Mode]:
        """Every way to assemble it; of more than 4096 the first."""
        modes = json.loads(self._native.modes()[1])
        return [Mode(**{**mode, "points": {name: tuple(at) for name, at in mode["points"].items()}}) for mode in modes]

    def sweep(
        self,
        start: float | None = None,
        stop: float | None = None,
        step: float | None = None,
        *,
        want: list[str] | None = None,
        drive: str | None = None,
        alone: bool = False,
        errors: bool = False,
        huge: bool = False,
        mode: int | None = None,
    ) -> Table:
        """A table of the motion while a drive moves: see :meth:`Solution.sweep`. The scene's own position may be singular."""
        table = Table(self._native.sweep(counted("mode", mode, 1), asked(start, stop, step, want, drive, alone, errors, huge)))
        warn_of(table.cut)
        return table

    def exercises(self, seed: int, **figure: Unpack[FigureOptions]) -> Iterator[Exercise]:
        """Exercises without end: variants with round numbers that a hand draws well, the same ones for the same seed.

        Args:
            seed: Which exercises, from 0.
            figure: Keys of the scene's ``figure`` in place of its own, as ``language="es"``, ``page="a3"``.
        """
        keys = _files.figure_keys(figure)
        options: _kinegon.ExerciseOptions = {"figure": keys, "has_page": figure.get("page") is not None}
        found = self._native.exercises(counted("seed", seed, 0), options)
        return (Exercise(found.next(), f"{self.name}-{seed}-{number}") for number in itertools.count(1))

    def exercise(self, seed: int, number: int = 1, **figure: Unpack[FigureOptions]) -> Exercise:
        """The exercise of that number, from 1, of a seed."""
        return next(itertools.islice(self.exercises(seed, **figure), counted("number", number, 1) - 1, None))

    @overload
    def draw(self, format: TextFormat = "svg", *, sheet: int = 1, **options: Unpack[DrawOptions]) -> str: ...
    @overload
    def draw(self, format: BytesFormat, *, sheet: int = 1, **options: Unpack[DrawOptions]) -> bytes: ...
    @overload
    def draw(self, format: Format, *, sheet: int = 1, **options: Unpack[DrawOptions]) -> str | bytes: ...
    def draw(self, format: Format = "svg", *, sheet: int = 1, **options: Unpack[DrawOptions]) -> str | bytes:
        """Its figure: see :meth:`Solution.draw`."""
        return self.solve().draw(format, sheet=sheet, **options)

    def _meaning(self) -> str:
        """Its text without what does not matter: spaces, and how numbers are written."""
        return json.dumps(json.loads(self.text.removeprefix("\ufeff"), parse_int=float))

    def __eq__(self, other: object) -> bool:
        """Whether their files say the same in the same order; names of exercises do not count."""
        return self._meaning() == other._meaning() if isinstance(other, Scene) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._meaning())

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self.text, self.name)

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        return {"text/plain": repr(self), "image/svg+xml": self.draw("svg", outlines=True)}

    def __repr__(self) -> str:
        return f"<kinegon.Scene: {self.title or self.name}>"


def _restored(text: str, name: str) -> Scene:
    scene = Scene(text)
    scene.name = name
    return scene


class Exercise:
    """An exercise: its scene, the student's sheet, the empty form, and the key for the teacher."""

    def __init__(self, native: _kinegon.Exercise, name: str) -> None:
        self._native = native
        self.name = name
        """Its name, as ``four-bar-7-1``: kind, seed, number."""

    @property
    def scene(self) -> Scene:
        """Its scene."""
        return Scene(self._native.text())

    @overload
    def sheet(self, format: SheetText = "svg", **options: Unpack[SheetOptions]) -> str: ...
    @overload
    def sheet(self, format: SheetBytes, **options: Unpack[SheetOptions]) -> bytes: ...
    @overload
    def sheet(self, format: SheetFormat, **options: Unpack[SheetOptions]) -> str | bytes: ...
    def sheet(self, format: SheetFormat = "svg", **options: Unpack[SheetOptions]) -> str | bytes:
        """The student's sheet: the scheme, what is given, boxes for the results; svg, png, pdf or tikz.

        A PDF has the sheets for the plans, too, as further pages.
        """
        return self.sheets(format, **options)[0]

    @overload
    def sheets(self, format: SheetText = "svg", **options: Unpack[SheetOptions]) -> list[str]: ...
    @overload
    def sheets(self, format: SheetBytes, **options: Unpack[SheetOptions]) -> list[bytes]: ...
    @overload
    def sheets(self, format: SheetFormat, **options: Unpack[SheetOptions]) -> list[str] | list[bytes]: ...
    def sheets(self, format: SheetFormat = "svg", **options: Unpack[SheetOptions]) -> list[str] | list[bytes]:
        """The student's sheets: that with the scheme, then those for the plans; as PDF one file with all of them."""
        files = self._native.draw(self.name, _files.form_of(format, **options))
        return files if format in _files.BYTES else [file.decode("utf-8") for file in files]

    @overload
    def key_sheet(self, format: SheetText = "svg", **options: Unpack[SheetOptions]) -> str: ...
    @overload
    def key_sheet(self, format: SheetBytes, **options: Unpack[SheetOptions]) -> bytes: ...
    @overload
    def key_sheet(self, format: SheetFormat, **options: Unpack[SheetOptions]) -> str | bytes: ...
    def key_sheet(self, format: SheetFormat = "svg", **options: Unpack[SheetOptions]) -> str | bytes:
        """The drawn key: scheme, plans, all values with what a careful hand is allowed; svg, png, pdf or tikz."""
        return _files.opened(self._native.draw_key(_files.form_of(format, **options)), format)

    def key(self) -> Key:
        """The values of the key by the names of their quantities, each with its unit, what is allowed, and its step."""
        key: Key = json.loads(self._native.key())
        return key

    def form(self, format: FormFormat = "json") -> str:
        """The empty form, to be filled in and checked: ``json``, or ``csv`` for a spreadsheet."""
        return self._native.form(self.name, _files.form_is_table(format))

    def save(self, folder: str | os.PathLike[str]) -> str:
        """Writes the files of ``kinegon exercise`` into ``folder/NAME``, which must not be there yet; its path."""
        own = os.path.join(os.fspath(folder), self.name)
        if os.path.exists(own):
            raise KinegonError(f"{own} is there already and is not overwritten", "choose another folder or another seed, or remove it")
        files: dict[str, str | bytes] = {"scene.json": self._native.text()}
        formats: tuple[SheetFormat, ...] = ("svg", "pdf")
        for format in formats:
            files[f"key.{format}"] = self.key_sheet(format)
            sheets: Sequence[str | bytes] = self.sheets(format)
            for number, sheet in enumerate(sheets, 1):
                files[f"sheet.{format}" if number == 1 else f"sheet-{number}.{format}"] = sheet
        files |= {"form.json": self.form(), "form.csv": self.form("csv"), "key.json": self._native.key_file()}
        files["key-drawing.json"] = self._native.key_drawing()
        os.makedirs(own)
        _files.write_all({os.path.join(own, name): data if isinstance(data, bytes) else data.encode() for name, data in files.items()})
        return own

    def __eq__(self, other: object) -> bool:
        """Whether name and scene are the same."""
        return (self.name, self.scene) == (other.name, other.scene) if isinstance(other, Exercise) else NotImplemented

    def __hash__(self) -> int:
        return hash((self.name, self.scene))

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        return {"text/plain": repr(self), "image/svg+xml": self.sheet("svg", outlines=True)}

    def __repr__(self) -> str:
        return f"<kinegon.Exercise: {self.name}>"
