"""The example for Dask, Ray and Spark, with those that are installed: the rows of one machine, and where they come from."""

from __future__ import annotations

import importlib.util
import json
import shutil
import subprocess
import sys

import kinegon
import pytest
from conftest import ROOT
from test_studies import STUDY

EXAMPLE = ROOT / "examples" / "studies" / "in_python.py"


@pytest.mark.parametrize(("system", "module"), [("dask", "distributed"), ("ray", "ray"), ("spark", "pyspark")])
def test_rows_are_those_of_one_machine(system, module, tmp_path):
    if importlib.util.find_spec(module) is None or (system == "spark" and shutil.which("java") is None):
        pytest.skip(f"{module} is not installed")
    parquet = pytest.importorskip("pyarrow.parquet")
    (tmp_path / "four-bar.json").write_text(kinegon.Scene.kind("four-bar").text)
    # Three tasks.
    (tmp_path / "study.json").write_text(json.dumps({**STUDY, "scene": "four-bar.json", "count": 2000, "seed": 7}))
    done = subprocess.run([sys.executable, EXAMPLE, system, "study.json", "all.parquet"], cwd=tmp_path, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr.decode()[-2000:]
    study = kinegon.Study(tmp_path / "study.json")
    study.save(tmp_path / "own.parquet")
    own, all_rows = (parquet.read_table(tmp_path / name).to_pandas() for name in ("own.parquet", "all.parquet"))
    assert len(own) == 10000
    assert own.astype({"status": str}).equals(all_rows.astype({"status": str}))
    said = parquet.read_metadata(tmp_path / "all.parquet").metadata
    assert {key: said[key.encode()].decode() for key in study.origin} == study.origin
