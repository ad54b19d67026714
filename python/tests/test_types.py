"""What type checkers know: types are those of the schemas, right programs are taken, slips are refused."""

from __future__ import annotations

import importlib.util
import json
import shutil
import subprocess
import sys
from pathlib import Path

import kinegon
import pytest
from conftest import ROOT

TYPED = ROOT / "python" / "tests" / "typed"


def mypy(path: Path) -> dict[int, str]:
    """By line what it refuses."""
    if importlib.util.find_spec("mypy") is None:
        pytest.skip("mypy is not installed")
    command = [sys.executable, "-m", "mypy", "--strict", "--no-incremental", "--output", "json", path.name]
    done = subprocess.run(command, cwd=path.parent, capture_output=True, text=True, check=False)
    assert not done.stderr, done.stderr
    told = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    return {error["line"]: error["message"] for error in told if error["severity"] == "error"}


def pyright(path: Path) -> dict[int, str]:
    command = shutil.which("pyright", path=str(Path(sys.executable).parent)) or shutil.which("pyright")
    if command is None:
        pytest.skip("pyright is not installed")
    arguments = ["--outputjson", "--pythonpath", sys.executable, path.name]
    done = subprocess.run([command, *arguments], cwd=path.parent, capture_output=True, text=True, check=False)
    # What PyPI calls pyright brings the checker itself when it is first called.
    if "{" not in done.stdout:
        pytest.skip(f"pyright does not start: {(done.stderr or done.stdout).strip()[-300:]}")
    told = json.loads(done.stdout[done.stdout.index("{") :])["generalDiagnostics"]
    return {error["range"]["start"]["line"] + 1: error["message"] for error in told if error["severity"] == "error"}


@pytest.mark.parametrize("checker", [mypy, pyright])
def test_a_right_program_is_taken(checker):
    assert checker(TYPED / "right.py") == {}


@pytest.mark.parametrize("checker", [mypy, pyright])
def test_slips_are_refused(checker):
    lines = (TYPED / "refused.py").read_text("utf-8").splitlines()
    slips = [number for number, line in enumerate(lines, 1) if line.endswith("# refused")]
    refused = checker(TYPED / "refused.py")
    assert sorted(refused) == slips and len(slips) > 20, refused


def test_a_right_program_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "own.json").write_text('{ "kinegon_style": 1 }')
    program = compile((TYPED / "right.py").read_text("utf-8"), "right.py", "exec")
    names: dict[str, object] = {}
    exec(program, names)
    assert names["rows"] == 3 and names["classes"] == ["II"]


def test_types_are_those_of_the_schemas():
    spec = importlib.util.spec_from_file_location("make_types", ROOT / "python" / "make_types.py")
    make_types = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(make_types)
    assert make_types.TYPES.read_text("utf-8") == make_types.module(), "python python/make_types.py makes them anew"


def test_results_have_the_keys_of_their_types():
    """Of types with required and possible keys, none is missing and none more is there."""
    from kinegon import types

    solution = kinegon.Scene.kind("slotted-lever").solve()
    result = solution.result()
    check = solution.check(dict.fromkeys(["omega(3)", "v(B).size"], 1.0)).result
    key = kinegon.Scene.kind("four-bar").exercise(seed=1).key()
    for value, kind in [
        (result, types.Result),
        *((link, types.LinkResult) for link in result["links"].values()),
        *((point, types.PointResult) for point in result["points"].values()),
        *((slider, types.SliderResult) for slider in result["sliders"].values()),
        *((group, types.GroupResult) for group in result["groups"]),
        (check, types.CheckResult),
        *((value, types.ValueResult) for value in check["values"]),
        (key, types.Key),
        *((value, types.KeyValue) for value in key["values"].values()),
    ]:
        known, possible = set(value), set(kind.__annotations__)
        needed = {name for name in possible if "NotRequired" not in str(kind.__annotations__[name])}
        assert needed <= known <= possible, (kind, known ^ possible)
