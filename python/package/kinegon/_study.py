"""Studies: many mechanisms that differ from one scene in some numbers."""

from __future__ import annotations

import operator
import os
from collections.abc import Mapping
from typing import Any

from . import _files, _kinegon
from ._errors import KinegonError, SceneError
from ._files import Source
from ._table import Table

#: Rows that a file keeps together.
_ROWS = 1 << 16


class Study:
    """Many mechanisms that differ from one scene in some numbers, each moved through a cycle.

    ``len(study)`` is how many. A row hangs on the study and its index alone, so any process may compute any rows; a study
    can be pickled, its scene with it::

        study = kinegon.Study("study.json")
        table = study.rows()                        # all, on all cores
        parts = client.map(study.rows, starts, ends)     # Dask; likewise with Ray and Spark

    Args:
        source: The text of a study file, a dict of the same keys, or the path of a study file. A str is a text if it has
            a brace or a line break, else a path.
        folder: Where a scene that the study names by its path lies; without it the folder of the study's file, or the
            current one.

    Raises:
        SceneError: The study or its scene is not understood; ``message``, ``path``, ``line``, ``column``, ``hint`` say
            what and where.
        StructureError, AssemblyError, CycleError: The scene cannot be moved.
        OSError: A file cannot be read.
    """

    def __init__(self, source: Source, *, folder: str | os.PathLike[str] | None = None) -> None:
        text = _files.source_text(source, "study")
        is_seen = not isinstance(source, Mapping)
        if folder is None:
            folder = "" if isinstance(source, Mapping) or _files.is_text(source) else os.path.dirname(os.fspath(source))
        path = _kinegon.scene_of_study(text, is_seen)
        scene = None if path is None else _scene_text(os.path.join(os.fspath(folder), path))
        self._origin = (text, is_seen, scene)
        self._native = _kinegon.Study(*self._origin)

    @property
    def names(self) -> list[str]:
        """The names of the table's columns: ``index``, the varied numbers, ``status``, ``reach_from``, ``reach_to``, the
        figures, as ``omega(3).max`` and ``omega(3).max_at``."""
        return self._native.names()

    @property
    def origin(self) -> dict[str, str]:
        """What files of its rows say of where they come from, so that they can be made again: ``kinegon.version``,
        ``kinegon.seed``, ``kinegon.study`` with the study's text, ``kinegon.scene`` with that of a scene in a file of its own."""
        return self._native.origin()

    def __len__(self) -> int:
        return self._native.count()

    def rows(self, start: int = 0, stop: int | None = None, *, huge: bool = False) -> Table:
        """The rows from ``start`` to before ``stop``, to the bit the same in every process; without ``stop`` to the end.

        A table with a row for each mechanism; Ctrl-C ends it. ``huge`` lets it take more than a gigabyte.
        """
        return Table(self._native.rows(*self._ends(start, stop), huge))

    def save(self, path: str | os.PathLike[str], start: int = 0, stop: int | None = None) -> None:
        """Writes rows to a Parquet file, with the columns of ``kinegon study``; needs pyarrow. The file is complete or not
        there, and may be larger than memory. Its metadata say where the rows come from: :attr:`origin`."""
        if not os.fsdecode(path).lower().endswith(".parquet"):
            raise KinegonError(f"{os.fsdecode(path)} is no name of a Parquet file", "as results.parquet; `kinegon study` writes CSV")
        first, last = self._ends(start, stop)
        pyarrow, parquet = (_files.needed(module, "parquet") for module in ("pyarrow", "pyarrow.parquet"))
        schema = pyarrow.table(self.rows(first, first)).schema.with_metadata(self._native.origin())

        def write(file: Any) -> None:
            with parquet.ParquetWriter(file, schema) as writer:
                for row in range(first, last, _ROWS):
                    rows = pyarrow.table(self.rows(row, min(row + _ROWS, last)))
                    writer.write_table(rows.replace_schema_metadata(schema.metadata))

        _files.write_by({os.fsdecode(path): write})

    def _ends(self, start: int, stop: int | None) -> tuple[int, int]:
        first, last = operator.index(start), len(self) if stop is None else operator.index(stop)
        if not 0 <= first <= last <= len(self):
            raise KinegonError(f"there are no rows from {first} to {last}", f"the study has rows from 0 to {len(self)}")
        return first, last

    def __eq__(self, other: object) -> bool:
        """Whether study and scene have the same texts: then all rows are the same."""
        return self._origin == other._origin if isinstance(other, Study) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._origin)

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, self._origin

    def __repr__(self) -> str:
        return f"<kinegon.Study: {len(self)} rows × {len(self.names)} columns>"


def _scene_text(path: str) -> str:
    """The text of a scene in a file of its own; what is wrong with it is told with the file's name."""
    text = _files.read(path, "scene")
    try:
        _kinegon.Scene(text, True)
    except SceneError as error:
        raise SceneError(f"in {path}: {error.message}", error.hint, error.path, error.line, error.column) from None
    return text


def _restored(text: str, is_seen: bool, scene: str | None) -> Study:
    study = Study.__new__(Study)
    study._origin = (text, is_seen, scene)
    study._native = _kinegon.Study(text, is_seen, scene)
    return study
