"""Tables of the motion, and of studies."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _kinegon

if TYPE_CHECKING:
    import numpy
    import pandas


class Table:
    """A table of the motion: a row for each position of the drive, a column for each number.

    The first column is the drive's value. A vector has two columns, as ``v(D).x`` and ``v(D).y``. Where a position is
    singular or a quantity has no value stands NaN, which is null for readers of Arrow. The numbers lie in one piece of
    memory that cannot be written to; NumPy, pandas and Arrow read it as it lies there, without a copy.

    The table of a study has a row for each mechanism: its index, the varied numbers, what became of it (``status``), how
    far it goes, the figures. The status is a word; in :meth:`to_numpy` it is the word's place in ``kinegon.STATUSES``::

        table.to_numpy()            # rows × columns
        table["omega(4)"]           # a column
        pyarrow.table(table)        # likewise polars.DataFrame(table), duckdb, …
    """

    def __init__(self, native: _kinegon.Table) -> None:
        self._native = native
        self._notes = native.notes()

    @property
    def names(self) -> list[str]:
        """The names of the columns."""
        return self._native.names

    @property
    def units(self) -> dict[str, str]:
        """The unit of each column, as ``rad/s²``; angles are in degrees (°)."""
        return dict(zip(self._native.names, self._native.units, strict=True))

    @property
    def events(self) -> list[str]:
        """Extreme positions and change points on the way, in words."""
        return list(self._notes["events"])

    @property
    def limits(self) -> list[str]:
        """Limit positions that end the motion, in words."""
        return list(self._notes["limits"])

    @property
    def cut(self) -> str | None:
        """That only a part of the range that was asked for can be reached, in words; None if all of it can."""
        return self._notes["cut"]

    @property
    def is_complete(self) -> bool:
        """Whether all of the range that was asked for can be reached."""
        return self.cut is None

    def __len__(self) -> int:
        return self._native.rows

    def to_numpy(self) -> numpy.ndarray:
        """All numbers: an array of float64, shape (rows, columns), read-only, not copied."""
        import numpy

        return numpy.asarray(self._native)

    def __getitem__(self, name: str) -> numpy.ndarray:
        """The column of that name: an array of float64, shape (rows,), read-only, not copied; ``status`` of words."""
        import numpy

        try:
            column = self.names.index(name)
        except ValueError:
            raise KeyError(name) from None
        numbers = self.to_numpy()[:, column]
        return numpy.array(_kinegon.STATUSES)[numbers.astype(int)] if column == self._native.status else numbers

    def to_pandas(self) -> pandas.DataFrame:
        """The table as a pandas DataFrame; of a table of the motion numbers are not copied."""
        import pandas

        frame = pandas.DataFrame(self.to_numpy(), columns=self.names, copy=False)
        if self._native.status is None:
            return frame
        status = self.names[self._native.status]
        codes = pandas.Categorical.from_codes(frame[status].astype(int), _kinegon.STATUSES)
        return frame.assign(**{self.names[0]: frame[self.names[0]].astype("uint64"), status: codes})

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        return self._native.__arrow_c_stream__(requested_schema)

    def __reduce__(self) -> tuple[Any, ...]:
        native = self._native
        return _restored, (native.names, native.units, native.rows, native.status, native.bytes(), native.notes())

    def __repr__(self) -> str:
        return f"<kinegon.Table: {len(self)} rows × {len(self.names)} columns: {', '.join(self.names[:6])}{', …' * (len(self.names) > 6)}>"


def _restored(names: list[str], units: list[str], rows: int, status: int | None, data: bytes, notes: _kinegon.Notes) -> Table:
    return Table(_kinegon.Table(names, units, rows, status, data, notes))
