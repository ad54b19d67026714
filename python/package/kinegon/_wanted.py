"""The motion as it is asked for."""

from __future__ import annotations

import operator
import warnings
from typing import overload

from . import _kinegon
from ._errors import KinegonError, PartialWarning


def asked(
    start: float | None = None,
    stop: float | None = None,
    step: float | None = None,
    want: list[str] | None = None,
    drive: str | None = None,
    alone: bool = False,
    errors: bool = False,
    huge: bool = False,
) -> _kinegon.Wanted:
    """What of the motion is asked for."""
    if isinstance(want, str):
        raise KinegonError("want is a list of names", f'write want=["{want}"]')
    names = None if want is None else list(want)
    if any(not isinstance(name, str) for name in [*(names or []), drive or ""]):
        raise KinegonError("names of quantities and drives are texts", 'write want=["omega(3)"], drive="1"')
    return {
        "start": number(start),
        "stop": number(stop),
        "step": number(step),
        "want": names,
        "drive": drive,
        "alone": alone,
        "errors": errors,
        "huge": huge,
    }


def number(given: float | None) -> float | None:
    """A number, also one of NumPy or in a text."""
    return None if given is None else float(given)


@overload
def counted(what: str, given: int, least: int) -> int: ...
@overload
def counted(what: str, given: int | None, least: int) -> int | None: ...
def counted(what: str, given: int | None, least: int) -> int | None:
    """A whole number from `least` on."""
    if given is not None and not least <= operator.index(given) < 1 << 64:
        raise KinegonError(f"{what} cannot be {given}", f"a whole number from {least} on")
    return given


def warn_of(cut: str | None) -> None:
    """Warns whoever has called a method that calls this function, if not all of the range can be reached."""
    if cut is not None:
        warnings.warn(cut, PartialWarning, stacklevel=3)
