"""Texts in, files out."""

from __future__ import annotations

import importlib
import json
import math
import os
from collections.abc import Callable, Mapping
from typing import IO, Any, Literal, Union

from . import _kinegon
from ._errors import KinegonError, SceneError

#: A text, a dict, or the path of a file.
Source = Union[str, "os.PathLike[str]", Mapping[str, Any]]
#: Formats of a figure that are text.
TextFormat = Literal["svg", "tikz", "html"]
#: Formats of a figure that are not.
BytesFormat = Literal["png", "pdf", "gif", "apng"]
#: Formats of a figure.
Format = Literal[TextFormat, BytesFormat]
#: Formats of a sheet that stands for itself.
SheetText = Literal["svg", "tikz"]
SheetBytes = Literal["png", "pdf"]
SheetFormat = Literal[SheetText, SheetBytes]
#: Formats of a form.
FormFormat = Literal["json", "csv"]

ENDINGS: dict[str, Format] = {
    ".svg": "svg",
    ".png": "png",
    ".pdf": "pdf",
    ".tex": "tikz",
    ".html": "html",
    ".gif": "gif",
    ".apng": "apng",
}
#: Formats that show a motion.
FILMS = ("gif", "apng")
#: Formats that are no text.
BYTES = ("png", "pdf", *FILMS)


def needed(module: str, extra: str) -> Any:
    """A module that is not there with every installation."""
    try:
        return importlib.import_module(module)
    except ImportError:
        raise KinegonError(f"this needs {module}, which is not installed", f"pip install 'kinegon[{extra}]'") from None


def is_text(source: Source) -> bool:
    """Whether a source is a text itself, not the path of one: it has a brace or a line break, or is empty."""
    return isinstance(source, str) and (not source.strip() or "{" in source or "\n" in source)


def stem(path: Source) -> str:
    """The name of a file without its folder and its ending."""
    return "" if isinstance(path, Mapping) else os.path.splitext(os.path.basename(os.fsdecode(path)))[0]


def read(path: str | os.PathLike[str], what: str) -> str:
    """The text of a file in UTF-8."""
    # A number would be a file that is open already.
    with open(os.fspath(path), "rb") as file:
        data = file.read(_kinegon.MAX_BYTES + 1)
    if len(data) > _kinegon.MAX_BYTES:
        raise SceneError(f"{path} is larger than {_kinegon.MAX_BYTES >> 20} MB, which no {what} is", "is this the right file?")
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError as error:
        message = f"{path} is not text in UTF-8: byte {error.start} does not belong"
        raise SceneError(message, f"save the {what} as UTF-8 text") from None


def dumped(value: object) -> str:
    """A value as JSON; numbers and lists of NumPy are taken as those of Python, scenes as their dicts."""

    def plain(value: object) -> object:
        if hasattr(value, "_plain"):
            return value._plain()
        if hasattr(value, "tolist"):
            return value.tolist()
        if isinstance(value, Mapping):
            return dict(value)
        raise KinegonError(f"{type(value).__name__} cannot stand in JSON", "use numbers, strings, lists and dicts")

    try:
        return json.dumps(value, ensure_ascii=False, indent=2, default=plain)
    except KinegonError:
        raise
    except (TypeError, ValueError, RecursionError) as error:
        raise KinegonError(f"this cannot be written as JSON: {error}", "use numbers, strings, lists and dicts") from None


def figure_keys(figure: Mapping[str, Any]) -> str:
    """Keys of a scene's figure as JSON."""
    for name, value in figure.items():
        if isinstance(value, float) and not math.isfinite(value):
            raise KinegonError(f"figure.{name}: {value} is not a number", "leave it out where it is not known")
    return dumped(figure)


def source_text(source: Source, what: str) -> str:
    """The text of a source."""
    if isinstance(source, Mapping):
        text = dumped(source)
    else:
        text = source if isinstance(source, str) and is_text(source) else read(source, what)
    try:
        text.encode()
    except UnicodeEncodeError as error:
        raise SceneError(f"character {error.start} of the {what} is half of one", "write it as a text in UTF-8") from None
    return text


def form_of(format: str, *, outlines: bool = False, layered: bool = False, dpi: float = 100.0) -> _kinegon.Form:
    """How sheets are written."""
    known = list(ENDINGS.values())
    if format not in known:
        raise KinegonError(f"there is no format `{format}`", f"the formats are {', '.join(known)}")
    if layered and format != "svg":
        raise KinegonError("only SVG has layers", 'leave out layered=True, or ask for format="svg"')
    return {"format": format, "outlines": outlines, "layered": layered, "dpi": float(dpi)}


def of_path(path: str | os.PathLike[str]) -> Format:
    """The format that a file's ending asks for."""
    ending = os.path.splitext(os.fsdecode(path))[1].lower()
    if ending not in ENDINGS:
        raise KinegonError(f"no format for files ending in `{ending}`", f"known endings: {', '.join(ENDINGS)}")
    return ENDINGS[ending]


def form_is_table(format: str) -> bool:
    """Whether a form is a table, by the name of its format."""
    if format not in ("json", "csv"):
        raise KinegonError(f"there is no form `{format}`", "the forms are json, csv")
    return format == "csv"


def sheet_of(sheets: list[bytes], sheet: int, format: str) -> str | bytes:
    """One of the sheets, which count from 1."""
    if not 1 <= sheet <= len(sheets):
        raise KinegonError(f"there is no sheet {sheet}", f"the figure has sheets 1 to {len(sheets)}")
    return opened(sheets[sheet - 1], format)


def opened(data: bytes, format: str) -> str | bytes:
    """A file as a person wants it: a str if it is text."""
    return data if format in BYTES else data.decode("utf-8")


def write_all(files: Mapping[str, bytes]) -> None:
    """Writes files: each is complete or not there, and none is replaced before all are complete."""

    def writer(data: bytes) -> Callable[[IO[bytes]], object]:
        return lambda file: file.write(data)

    write_by({path: writer(data) for path, data in files.items()})


def write_by(files: Mapping[str, Callable[[IO[bytes]], object]]) -> None:
    """Writes files likewise, each by a function that takes it open."""
    import tempfile

    complete: list[tuple[str, str]] = []
    try:
        for path, write in files.items():
            try:
                handle, name = tempfile.mkstemp(dir=os.path.dirname(path) or ".", prefix=".kinegon-")
            except OSError as error:
                error.filename = path
                raise
            complete.append((name, path))
            with os.fdopen(handle, "wb") as file:
                write(file)
            mask = os.umask(0)
            os.umask(mask)
            os.chmod(name, 0o666 & ~mask)
        while complete:
            os.replace(*complete[0])
            complete.pop(0)
    finally:
        for name, _ in complete:
            os.unlink(name)


def numbered(path: str | os.PathLike[str], sheets: list[bytes]) -> dict[str, bytes]:
    """The files of a figure's sheets: the second has ``-2`` before its ending."""
    stem, ending = os.path.splitext(os.fsdecode(path))
    name = [f"{stem}{ending}", *(f"{stem}-{number}{ending}" for number in range(2, len(sheets) + 1))]
    return dict(zip(name, sheets, strict=True))
