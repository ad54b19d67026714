"""Scenes: mechanisms as text."""

from __future__ import annotations

import itertools
import json
import os
from collections.abc import Iterator
from typing import Any, NamedTuple

from . import _files, _kinegon
from ._exercise import Exercise
from ._files import Source
from ._solution import Solution
from ._table import Table
from ._wanted import asked, counted, warn_of


class Mode(NamedTuple):
    """A way to assemble a scene."""

    #: Its number, as ``kinegon modes`` counts; ``scene.solve(mode=…)`` takes it.
    number: int
    #: The places of moving points that are sought, ``(x, y)`` in the scene's unit of length.
    points: dict[str, tuple[float, float]]
    #: The angles of links in degrees from +x, in (−180, 180].
    angles: dict[str, float]
    #: Whether it is the one that the scene's ``near`` picks.
    is_own: bool
    #: The same in words.
    text: str

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
        #: The name of its exercises: the kind, or the file's name without its ending.
        self.name = _files.stem(source) if is_path else "scene"

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

    def with_figure(self, **figure: Any) -> Scene:
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

    def exercises(self, seed: int, **figure: Any) -> Iterator[Exercise]:
        """Exercises without end: variants with round numbers that a hand draws well, the same ones for the same seed.

        Args:
            seed: Which exercises, from 0.
            figure: Keys of the scene's ``figure`` in place of its own, as ``language="es"``, ``page="a3"``.
        """
        keys = _files.figure_keys(figure)
        options: _kinegon.ExerciseOptions = {"figure": keys, "has_page": figure.get("page") is not None}
        found = self._native.exercises(counted("seed", seed, 0), options)
        return (Exercise(found.next(), f"{self.name}-{seed}-{number}") for number in itertools.count(1))

    def exercise(self, seed: int, number: int = 1, **figure: Any) -> Exercise:
        """The exercise of that number, from 1, of a seed."""
        return next(itertools.islice(self.exercises(seed, **figure), counted("number", number, 1) - 1, None))

    def draw(self, format: _files.Format = "svg", **options: Any) -> Any:
        """Its figure: see :meth:`Solution.draw`."""
        return self.solve().draw(format, **options)

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
