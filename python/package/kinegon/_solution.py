"""A solved scene."""

from __future__ import annotations

import decimal
import json
import math
import os
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, overload

from . import _files, _kinegon, _plot
from ._check import Check, form_text
from ._errors import KinegonError
from ._files import BytesFormat, FormFormat, Format, Source, TextFormat
from ._table import Table
from ._wanted import asked, warn_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from typing_extensions import Unpack

    from ._options import DrawOptions
    from .types import FigureKeys, FigureOptions, MarksFile, Result


def rounded_up(bound: float) -> str:
    """A bound with one digit, never smaller than it is.

    >>> [rounded_up(bound) for bound in (0.0, 1.2e-16, 3e-05, 0.0999)]
    ['0', '2e-16', '4e-05', '0.1']
    """
    # 3e-05 as it is kept is a little more than what it is written as.
    upward = decimal.Context(prec=1, rounding=decimal.ROUND_CEILING)
    return f"{float(upward.create_decimal_from_float(bound)):.1g}"


class Quantity(NamedTuple):
    """A quantity with its unit and a bound of its error."""

    name: str
    """Its name, as ``omega(4)``."""
    value: float | tuple[float, float]
    """A number; of a vector ``(x, y)`` in the fixed frame, x right, y up."""
    unit: str
    """Its unit, as ``rad/s²``; angles are in degrees (°)."""
    error: float | None
    """How far the value can be from what follows exactly from the scene's numbers, of a vector each component; None
    where that is not known."""

    def __float__(self) -> float:
        if isinstance(self.value, tuple):
            raise KinegonError(f"`{self.name}` is a vector", f"take a number of it: {self.name}.x .y .size .angle")
        return self.value

    def __str__(self) -> str:
        bound = " (no bound of its error)" if self.error is None else f" ± {rounded_up(self.error)}"
        return f"{self.name} = {self.value}{bound} {self.unit}"


def _few(value: float, error: float | None) -> str:
    """Six digits, or as many as are certain."""
    if error is None:
        return "?"
    return f"{value:.6g}" if error <= 4e-7 * abs(value) or error == 0 else f"{value:.3g} ± {rounded_up(error)}"


def _certain(value: float, error: float | None, most: int) -> str:
    """So many significant digits, or those that are certain, one at least.

    >>> [_certain(143.8177127788, error, 9) for error in (0.0, 2e-12, 3e-5, 500.0, None)]
    ['143.817713', '143.817713', '143.8177', '1e+02', '1e+02']
    """
    if value == 0 or error == 0:
        return f"{value:.{most}g}"
    certain = 1 if error is None or math.isinf(error) else math.floor(math.log10(abs(value) / (2 * error))) + 1
    return f"{value:.{max(1, min(most, certain))}g}"


class Extremes(NamedTuple):
    """Least and greatest value of a quantity over a range of the drive; None where it grows without bound.

    Printed are the digits that are certain, of values nine at most, of their places six.
    """

    name: str
    """Its name, as ``omega(4)``."""
    unit: str
    """Its unit, as ``rad/s²``."""
    min_at: float | None
    """The drive's value where it is least: an angle in degrees, or a position."""
    min: float | None
    """The least value."""
    max_at: float | None
    """The drive's value where it is greatest."""
    max: float | None
    """The greatest value."""
    min_at_error: float | None
    """How far the place can be from ``min_at``."""
    min_error: float | None
    """How far the least value can be from ``min``: proved, but at a limit position and next to a change point."""
    max_at_error: float | None
    """How far the place can be from ``max_at``."""
    max_error: float | None
    """How far the greatest value can be from ``max``, likewise."""

    def __str__(self) -> str:
        def told(value: float | None, error: float | None, at: float | None, at_error: float | None) -> str:
            if value is None or at is None:
                return "without bound"
            return f"{_certain(value, error, 9)} {self.unit} at {_certain(at, at_error, 6)}"

        least = told(self.min, self.min_error, self.min_at, self.min_at_error)
        greatest = told(self.max, self.max_error, self.max_at, self.max_at_error)
        return f"{self.name}: least {least}, greatest {greatest}"


class Step(NamedTuple):
    """A step of the construction."""

    number: int
    """Counted from 1."""
    caption: str
    """What is done."""
    equation: str
    """Its equation in plain text, or empty."""
    panel: str
    """Where it is drawn: ``scheme``, ``velocity``, ``acceleration``."""


class Steps(tuple[Step, ...]):
    """The steps of the construction. ``print(steps)`` shows the text of ``kinegon steps``."""

    text: str

    def __str__(self) -> str:
        return self.text


class Interactive:
    """The workbench with a scene open, for a notebook whose HTML is trusted; else its figure."""

    def __init__(self, page: str, figure: str, height: int) -> None:
        self._page, self._figure, self._height = page, figure, height

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        import html

        # The page may run, load nothing, and see nothing of the notebook.
        frame = (
            f'<iframe srcdoc="{html.escape(self._page)}" sandbox="allow-scripts allow-downloads allow-modals" '
            f'style="width: 100%; height: {self._height}px; border: 0"></iframe>'
        )
        return {"text/plain": repr(self), "image/svg+xml": self._figure, "text/html": frame}

    def __repr__(self) -> str:
        return "<kinegon.Interactive: the workbench; a trusted notebook shows it>"


class Solution:
    """A mechanism in one position with its motion and its plans: x right, y up, counter-clockwise positive.

    Lengths and times are in the scene's units, angles in degrees, rates in rad per unit of time.
    """

    def __init__(self, native: _kinegon.Solution) -> None:
        self._native = native
        self._origin: tuple[str, int | None] = ("", None)
        """The text of its scene, and the assembly mode."""

    def result(self) -> Result:
        """Every number with a bound of its error, as ``kinegon solve`` prints them: ``units``, ``links`` (angle, omega,
        alpha), ``points`` (position, velocity, acceleration: ``[x, y]``), ``sliders``, ``groups``, ``quantities``,
        ``warnings``."""
        result: Result = json.loads(self._native.result())
        return result

    def quantity(self, name: str) -> Quantity:
        """The quantity of that name: ``omega(4)``, ``v(D)``, ``a_n(D/G).size``, ``position(3/2)``, ``vplan(b,s3)`` …; of instant centres
        ``P(1,3)`` and ``P(2,ground).x``, at infinity ``.angle``, of inflection circles ``W(2)`` and ``d_i(2)``.

        Crank and rocker have their centre on the line of the frame's pivots:

            >>> import kinegon
            >>> centre = kinegon.Scene.kind("four-bar").solve().quantity("P(1,3)")
            >>> abs(centre.value[1]) < 1e-9 * abs(centre.value[0])
            True
        """
        numbers, unit, error = self._native.quantity(name)
        return Quantity(name, (numbers[0], numbers[1]) if len(numbers) == 2 else numbers[0], unit, error)

    def digits(self) -> str:
        """The table of ``kinegon solve --digits``: rates, velocities and accelerations with those digits that are certain."""
        return self._native.digits()

    @property
    def warnings(self) -> list[str]:
        """What should be known of these numbers."""
        return self._native.warnings()

    def steps(self, *, pencil_mm: float | None = None, pencil_degrees: float | None = None) -> Steps:
        """The construction step by step. The text has lengths on paper and what a hand drawing comes to; the limits of
        the hand's errors are in mm of paper and in degrees, 0.3 without them."""
        text, told = self._native.steps(pencil_mm, pencil_degrees)
        steps = Steps(Step(**step) for step in json.loads(told))
        steps.text = text
        return steps

    @overload
    def draw(self, format: TextFormat = "svg", *, sheet: int = 1, **options: Unpack[DrawOptions]) -> str: ...
    @overload
    def draw(self, format: BytesFormat, *, sheet: int = 1, **options: Unpack[DrawOptions]) -> bytes: ...
    @overload
    def draw(self, format: Format, *, sheet: int = 1, **options: Unpack[DrawOptions]) -> str | bytes: ...
    def draw(self, format: Format = "svg", *, sheet: int = 1, **options: Unpack[DrawOptions]) -> str | bytes:
        """The figure: a str of SVG, TikZ or HTML (the workbench with the scene open), bytes of PNG or PDF; or as a film,
        bytes of GIF or APNG, while a drive turns once, or goes to and fro.

        Args:
            format: ``svg``, ``png``, ``pdf``, ``tikz``, ``html``, ``gif``, ``apng``.
            sheet: Which sheet, from 1; a work sheet's table without room beside the panels is on the second.
            coarse: Count steps as a lecturer shows them together.
            layered: An SVG with a group for each step, for slide programs.
            outlines: Letters of an SVG as outlines, for programs that lack the font.
            dpi: Resolution of a PNG or a film in dots per inch, 10 to 2400.
            style: ``paper``, ``print``, ``lecture``, ``board``, or a style file: its path, a dict, its text. Type checkers
                take a ``pathlib.Path`` for a path: no other tells it from a misspelt name.
            seconds: How long a turn of a film lasts, or going to and fro once; 5 without it.
            fps: Pictures of a film in a second, 1 to 50; 20 without it.
            drive: The drive that a film follows, if not the first; others run along in proportion to their speeds.
            options: Further keywords are keys of a scene's ``figure`` in place of its own: ``step=14``, ``language="es"``, ``page="a3"``,
                ``panels=["velocity"]``, ``mu_v=0.5`` (units per mm of paper), ``values="m"``, ``trace=["M"]`` … The figure of instant centres is
                ``panels=["scheme", "centers"]``, with ``centers="all"`` or ``centers=["P(1,3)"]``, ``velocities=["C"]``, ``inflection=["2"]``.

        All instant centres, with the lines that lead to them:

            >>> import kinegon
            >>> svg = kinegon.Scene.kind("four-bar").solve().draw(panels=["centers"], centers="all")
            >>> "<svg" in svg
            True
        """
        return _files.sheet_of(self._sheets(format, **options), sheet, format)

    def save(self, path: str | os.PathLike[str], **options: Unpack[DrawOptions]) -> None:
        """Writes the figure to a file; its ending gives the format: .svg, .png, .pdf, .tex, .html; .gif and .apng are films. Options are those of
        :meth:`draw`. A second sheet has ``-2`` before the ending. Files are complete or not there."""
        if "format" in options:
            raise KinegonError("the file's ending gives the format", f"known endings: {', '.join(_files.ENDINGS)}")
        _files.write_all(_files.numbered(path, self._sheets(_files.of_path(path), **options)))

    def interactive(self, *, height: int = 720, **figure: Unpack[FigureOptions]) -> Interactive:
        """The workbench with this scene open, in a notebook; its output takes three megabytes. ``height`` is in pixels."""
        native = self._native.with_figure(_files.figure_keys(figure)) if figure else self._native
        form: _kinegon.Form = {"format": "workbench", "outlines": True, "layered": False, "dpi": 100.0}
        (page,) = native.draw(form, False, None)
        return Interactive(page.decode("utf-8"), self.draw("svg", outlines=True, **figure), int(height))

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
    ) -> Table:
        """A table of the motion from this position while a drive moves.

        Args:
            start: First value of the drive: an angle in degrees, or a slider's position. With neither start nor stop:
                once around, or from end to end.
            stop: Last value; may be less than the first. Without start the first is that of the scene.
            step: From one row to the next; without it 1°, or about a two-hundredth of a slider's range.
            want: Names of quantities; without it those that the scene wants, else all.
            drive: The drive that moves, if not the first; other drives run along in proportion to their speeds.
            alone: Other drives stand still.
            errors: Behind each quantity a column with the bound of its error, as ``omega(4)_error``.
            huge: Make a table of more than a gigabyte, too.

        A limit position before the end of the range gives a :class:`PartialWarning`; the table has what can be reached.
        """
        table = Table(self._native.sweep(asked(start, stop, step, want, drive, alone, errors, huge)))
        warn_of(table.cut)
        return table

    def extremes(
        self,
        start: float | None = None,
        stop: float | None = None,
        *,
        want: list[str] | None = None,
        drive: str | None = None,
        alone: bool = False,
    ) -> dict[str, Extremes]:
        """The least and greatest values of quantities while a drive moves, by their names, exact to rounding where the
        motion is smooth, as ``kinegon curves`` marks them. Arguments are those of :meth:`sweep`; without ``want`` and
        without wishes of the scene: ω of all links that move. Of a vector it is its size; angles run on past 180°.
        """
        found, cut = self._native.extremes(asked(start, stop, want=want, drive=drive, alone=alone))
        warn_of(cut)
        none = (None, None, None, None)
        pairs = [(name, unit, least or none, greatest or none) for name, unit, least, greatest in found]
        return {name: Extremes(name, unit, *a[:2], *b[:2], *a[2:], *b[2:]) for name, unit, a, b in pairs}

    def form(self, format: FormFormat = "json") -> str:
        """The empty form of measured values: ``json``, or ``csv`` for a spreadsheet."""
        return self._native.form(_files.form_is_table(format))

    def drawing(self) -> str:
        """Kinegon's own construction as a drawing: JSON, as the drawing board reads it and :meth:`check` judges it."""
        return self._native.drawing()

    def check(
        self,
        form: Source,
        *,
        marks: Source | MarksFile | None = None,
        pencil_mm: float | None = None,
        pencil_degrees: float | None = None,
        depth: int = 5,
    ) -> Check:
        """Checks values read from a hand drawing, or a drawing made on the drawing board, operation by operation.

        Args:
            form: Values by names, counter-clockwise positive, as ``{"omega(4)": -0.474, "v(D).size": 71.2}``; or a
                filled form: a dict, its text (JSON or CSV), its path. Or a drawing, likewise: then ``check.drawing`` has
                the verdicts on its operations. A form with ``mu_c`` may name instant centres (``P(1,3).x``) of a scene
                whose figure shows none.
            marks: A marking scheme, as for ``kinegon check --marks``.
            pencil_mm: Limit of the hand's errors in mm of paper; without both limits what the scatter of the values shows.
            pencil_degrees: The same in degrees.
            depth: How many mistakes at once are looked for, 1 to 6; 5 is usual, as for ``kinegon check``.
        """
        if not 1 <= depth <= 6:
            raise KinegonError("depth is from 1 to 6")
        text, is_table = form_text(form)
        scheme = None if marks is None else _files.source_text(marks, "marking scheme")
        options: _kinegon.CheckOptions = {
            "marks": scheme,
            "mm": pencil_mm,
            "degrees": pencil_degrees,
            "depth": depth,
            "is_table": is_table,
        }
        return Check(self._native, text, options)

    def _sheets(
        self,
        format: str,
        *,
        coarse: bool = False,
        layered: bool = False,
        outlines: bool = False,
        dpi: float = 100.0,
        style: str | Source | None = None,
        seconds: float | None = None,
        fps: int | None = None,
        drive: str | None = None,
        **figure: Unpack[FigureKeys],
    ) -> list[bytes]:
        form = _files.form_of(format, outlines=outlines, layered=layered, dpi=dpi)
        still = [name for name in ("step", "worksheet") if figure.get(name)]
        if format in _files.FILMS and still:
            raise KinegonError("a film shows the finished figure in motion", f"leave out {still[0]}")
        keys: dict[str, Any] = {**figure}
        file = None
        if style is not None:
            # A name has no ending, a path has one.
            if isinstance(style, str) and not _files.is_text(style) and not any(c in style for c in "./\\"):
                keys["style"] = style
            elif format == "html":
                raise KinegonError("a page has the styles that a scene can name, not that of a file")
            else:
                file = _files.source_text(style, "style")
        native = self._native.with_figure(_files.figure_keys(keys)) if keys else self._native
        if format in _files.FILMS:
            return [native.film(form, seconds, fps, drive, file)]
        return native.draw(form, coarse, file)

    def plot_plan(self, which: Literal["velocity", "acceleration"] = "velocity", *, ax: Axes | None = None) -> Axes:
        """The velocity plan, or that of accelerations, on axes of matplotlib true to scale: values can be read along both, in
        the scene's units. For a construction step by step take :meth:`draw`.

        Args:
            which: ``velocity`` or ``acceleration``.
            ax: Axes to draw on; without it new ones.
        """
        if which not in ("velocity", "acceleration"):
            raise KinegonError(f"there is no plan `{which}`", "the plans are velocity, acceleration")
        return _plot.plan(json.loads(self._native.plan(which == "acceleration")), which[0], ax)

    def __eq__(self, other: object) -> bool:
        """Whether they are of scenes with the same text, in the same assembly mode: then all numbers are the same."""
        return self._origin == other._origin if isinstance(other, Solution) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._origin)

    def __reduce__(self) -> tuple[Any, ...]:
        return _solved, self._origin

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        return {"text/plain": repr(self), "image/svg+xml": self.draw("svg", outlines=True)}

    def __repr__(self) -> str:
        links = self.result()["links"]
        rates = ", ".join(f"omega({name}) {_few(link['omega'], link['omega_error'])}" for name, link in list(links.items())[:6])
        return f"<kinegon.Solution: {rates}{', …' * (len(links) > 6)}>"


def _solved(text: str, mode: int | None) -> Solution:
    """Of a pickle."""
    from ._scene import Scene

    return Scene(text).solve(mode=mode)
