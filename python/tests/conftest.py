"""What the tests share. They try the package as it is installed, not as it lies here."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

#: The repository.
ROOT = Path(__file__).parents[2]
#: The program that was installed with the package.
PROGRAM = Path(sys.executable).with_name("kinegon" + (".exe" if os.name == "nt" else ""))


class Program:
    """The program of the wheel."""

    def __call__(self, *arguments: object, code: int = 0, **options: object) -> bytes:
        """What a command prints; it is to end with that code."""
        done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, check=False, **options)
        assert done.returncode == code, done.stderr.decode()
        return done.stdout


@pytest.fixture
def program() -> Program:
    return Program()


@pytest.fixture
def figure_2() -> Path:
    return ROOT / "examples" / "figure-2.json"
