"""Tables of the motion, and of studies."""

from __future__ import annotations

import os
from typing import IO, TYPE_CHECKING, Any

from . import _files, _kinegon, _plot
from ._errors import KinegonError

if TYPE_CHECKING:
    import numpy
    import pandas
    from matplotlib.axes import Axes

#: Rows that a file's writer keeps together.
_ROWS = 1 << 16


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

    @property
    def symbols(self) -> dict[str, str]:
        """The symbol of each column as text of matplotlib, as ``$ω_{3}$``; empty where there is none."""
        return {name: _plot.mathtext(symbol) for name, symbol in zip(self.names, self._native.symbols, strict=True)}

    def __len__(self) -> int:
        return self._native.rows

    def __eq__(self, other: object) -> bool:
        """Whether names, units and all numbers are the same; NaN is the same as NaN."""
        if not isinstance(other, Table):
            return NotImplemented
        own, their = self._native, other._native
        heads = [(table.names, table.units, table.rows, table.status) for table in (own, their)]
        return heads[0] == heads[1] and own.bytes() == their.bytes()

    __hash__ = None  # type: ignore[assignment]

    def to_numpy(self) -> numpy.ndarray:
        """All numbers: an array of float64, shape (rows, columns), read-only, not copied."""
        numbers: numpy.ndarray = _files.needed("numpy", "numpy").asarray(self._native)
        return numbers

    def __getitem__(self, name: str) -> numpy.ndarray:
        """The column of that name: an array of float64, shape (rows,), read-only, not copied; ``status`` of words."""
        try:
            column = self.names.index(name)
        except ValueError:
            raise KeyError(name) from None
        numbers = self.to_numpy()[:, column]
        if column != self._native.status:
            return numbers
        words: numpy.ndarray = _files.needed("numpy", "numpy").array(_kinegon.STATUSES)[numbers.astype(int)]
        return words

    def to_pandas(self) -> pandas.DataFrame:
        """The table as a pandas DataFrame; of a table of the motion numbers are not copied."""
        pandas = _files.needed("pandas", "pandas")
        frame = pandas.DataFrame(self.to_numpy(), columns=self.names, copy=False)
        if self._native.status is None:
            return frame
        status = self.names[self._native.status]
        codes = pandas.Categorical.from_codes(frame[status].astype(int), _kinegon.STATUSES)
        return frame.assign(**{self.names[0]: frame[self.names[0]].astype("uint64"), status: codes})

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the table to a file, by its ending: ``.csv``, with the bytes that the program writes; ``.parquet`` or
        ``.arrow``, by pyarrow. The file is complete or not there."""
        place = os.fsdecode(path)
        ending = os.path.splitext(place)[1].lower()
        if ending == ".csv":
            # At least once, for the names.
            starts = range(0, max(len(self), 1), _ROWS)
            _files.write_by({place: lambda file: [file.write(self._native.csv(row, row + _ROWS).encode()) for row in starts]})
            return
        if ending not in (".parquet", ".arrow"):
            raise KinegonError(f"no format for tables in files ending in `{ending}`", "known endings: .csv, .parquet, .arrow")
        pyarrow = _files.needed("pyarrow", "parquet")
        whole = pyarrow.table(self)

        def write(file: IO[bytes]) -> None:
            if ending == ".parquet":
                from pyarrow import parquet

                parquet.write_table(whole, file)
            else:
                from pyarrow import ipc

                with ipc.new_file(file, whole.schema) as writer:
                    writer.write_table(whole)

        _files.write_by({place: write})

    def plot(self, *names: str, ax: Axes | None = None, **line: Any) -> Axes:
        """Curves of these columns over the drive, with symbols and units, on axes of matplotlib; without names all columns.
        A gap is where a quantity has no value.

        Args:
            names: Columns of one unit, as ``"omega(3)"``.
            ax: Axes to draw on; without it new ones.
            line: How the lines look, as for ``ax.plot``: ``color="C3"``, ``linestyle="--"``, ``label="…"``.
        """
        if self._native.status is not None:
            raise KinegonError("the table of a study has no curves over a drive", "take table.to_pandas().plot")
        return _plot.curves(self, self._native.symbols, names or self.names[1:], ax, line)

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        return self._native.__arrow_c_stream__(requested_schema)

    def __reduce__(self) -> tuple[Any, ...]:
        native = self._native
        return _restored, (native.names, native.units, native.rows, native.status, native.symbols, native.bytes(), native.notes())

    def __repr__(self) -> str:
        return f"<kinegon.Table: {len(self)} rows × {len(self.names)} columns: {', '.join(self.names[:6])}{', …' * (len(self.names) > 6)}>"


def _restored(
    names: list[str], units: list[str], rows: int, status: int | None, symbols: list[str], data: bytes, notes: _kinegon.Notes
) -> Table:
    return Table(_kinegon.Table(names, units, rows, status, symbols, data, notes))
