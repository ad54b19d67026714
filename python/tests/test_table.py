"""Tables: one piece of memory for NumPy, pandas and Arrow."""

from __future__ import annotations

import json
import multiprocessing
import pickle
import sys
import threading
import time

import kinegon
import numpy
import pytest
from conftest import ROOT

SCENE = kinegon.Scene.kind("four-bar")


def test_numpy_and_pandas_share_the_memory():
    pandas = pytest.importorskip("pandas")
    table = SCENE.sweep()
    numbers = table.to_numpy()
    assert numbers.shape == (361, len(table.names)) and numbers.dtype == numpy.float64
    assert numpy.shares_memory(numbers, table.to_numpy()) and not numbers.flags.writeable
    frame = table.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and list(frame.columns) == table.names
    assert numpy.shares_memory(frame["omega(3)"].to_numpy(), numbers)
    column = table["omega(3)"]
    del table, frame, numbers
    assert numpy.isfinite(column).all()


def test_arrow_shares_the_memory():
    pyarrow = pytest.importorskip("pyarrow")
    table = SCENE.sweep()
    arrow = pyarrow.table(table)
    assert arrow.column_names == table.names and arrow.num_rows == 361
    assert arrow.schema.field("omega(3)").metadata == {b"unit": b"rad/s"}
    values = arrow["omega(3)"].chunk(0).to_numpy(zero_copy_only=True)
    assert numpy.shares_memory(values, table.to_numpy())
    del table
    assert numpy.isfinite(values).all() and arrow.validate(full=True) is None


def test_where_there_is_no_number():
    """A parallelogram linkage has change points at 0° and 180°."""
    scene = SCENE.to_dict()
    scene["links"]["2"]["lengths"]["BC"], scene["links"]["3"]["lengths"]["CD"] = 160, 60
    scene["near"] = {"C": [190, 52]}
    table = kinegon.Scene(scene).sweep(0, 360, 10, want=["omega(3)"])
    holes = numpy.flatnonzero(numpy.isnan(table["omega(3)"]))
    assert table["angle(1)"][holes].tolist() == [0, 180, 360]
    numpy.testing.assert_allclose(numpy.delete(table["omega(3)"], holes), 10, rtol=1e-12)
    pyarrow = pytest.importorskip("pyarrow")
    assert pyarrow.table(table)["omega(3)"].null_count == 3


def test_a_limit_is_told():
    """A crank of 90 mm in the same frame cannot turn around: 90 + 160 > 140 + 110 − 0.1."""
    scene = SCENE.to_dict()
    scene["links"]["1"]["lengths"]["AB"] = 95
    with pytest.warns(kinegon.PartialWarning, match="only a part of the range") as told:
        table = kinegon.Scene(scene).sweep(0, 360)
    assert not table.is_complete and table.limits and told[0].filename == __file__
    # There coupler and rocker lie in line: 140 + 110 from B to D.
    cosine = (95**2 + 160**2 - 250**2) / (2 * 95 * 160)
    end = numpy.degrees(numpy.arccos(cosine))
    assert table["angle(1)"][-1] == numpy.floor(end)


def test_pickles():
    table = SCENE.sweep(want=["omega(3)"])
    again = pickle.loads(pickle.dumps(table))
    assert again.names == table.names and again.units == table.units and again.events == table.events
    numpy.testing.assert_array_equal(again.to_numpy(), table.to_numpy())
    solution = SCENE.solve(mode=1)
    assert pickle.loads(pickle.dumps(solution)).result() == solution.result()
    assert pickle.loads(pickle.dumps(SCENE)).name == "four-bar"
    with pytest.raises(kinegon.SceneError) as bad:
        kinegon.Scene("{}")
    again = pickle.loads(pickle.dumps(bad.value))
    assert str(again) == str(bad.value) and again.line == bad.value.line


def test_too_much_is_refused():
    with pytest.raises(kinegon.KinegonError, match="36000001 rows and"):
        SCENE.sweep(0, 360, 1e-5)
    with pytest.raises(kinegon.KinegonError, match=r"want=\[\"omega\(3\)\"\]"):
        SCENE.sweep(want="omega(3)")
    with pytest.raises(kinegon.CycleError):
        SCENE.sweep(0, 360, 0)
    with pytest.raises(KeyError):
        SCENE.sweep()["omega(9)"]


def test_other_threads_run_meanwhile():
    """Python's lock is free: another thread runs a hundred times while a table is made."""
    done = threading.Event()
    table = threading.Thread(target=lambda: (SCENE.sweep(0, 360, 0.0002, want=["omega(3)"]), done.set()))
    table.start()
    beats = 0
    while not done.wait(0.0005):
        beats += 1
    table.join()
    assert beats > 20


def _rows(step: float) -> int:
    return len(SCENE.sweep(0, 360, step, want=["omega(3)"]))


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="no fork here")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_forked_process_has_threads_of_its_own():
    assert _rows(0.01) == 36001
    with multiprocessing.get_context("fork").Pool(1) as pool:
        assert pool.apply_async(_rows, [0.01]).get(timeout=20) == 36001


def test_ctrl_c_ends_a_long_table():
    """A signal's handler runs between blocks of rows."""
    import signal

    def late(*_: object) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGINT, late)
    timer = threading.Timer(0.2, signal.raise_signal, [signal.SIGINT])
    try:
        timer.start()
        began = time.monotonic()
        with pytest.raises(KeyboardInterrupt):
            for _ in range(1000):
                SCENE.sweep(0, 360, 1e-5, want=["omega(3)"])
        assert time.monotonic() - began < 5
    finally:
        timer.cancel()
        signal.signal(signal.SIGINT, before)


def test_files_by_ending(tmp_path, program):
    scene = SCENE.to_dict()
    scene["links"]["2"]["lengths"]["BC"], scene["links"]["3"]["lengths"]["CD"] = 160, 60
    scene["near"] = {"C": [190, 52]}
    (tmp_path / "scene.json").write_text(json.dumps(scene))
    table = kinegon.Scene(scene).sweep(0, 360, 10, want=["omega(3)", "v(C)"], errors=True)
    table.save(tmp_path / "own.csv")
    motion = ["--from", 0, "--to", 360, "--step", 10, "--want", "omega(3), v(C)", "--errors"]
    program("sweep", tmp_path / "scene.json", *motion, "-o", tmp_path / "program.csv")
    assert (tmp_path / "own.csv").read_bytes() == (tmp_path / "program.csv").read_bytes()
    study = kinegon.Study(ROOT / "examples" / "studies" / "four-bar.json")
    study.rows(5, 20).save(tmp_path / "study.csv")
    program("study", ROOT / "examples" / "studies" / "four-bar.json", "--rows", "5..20", "-o", tmp_path / "theirs.csv")
    assert (tmp_path / "study.csv").read_bytes() == (tmp_path / "theirs.csv").read_bytes()
    with pytest.raises(kinegon.KinegonError, match="files ending in `.xlsx`; hint: known endings: .csv, .parquet, .arrow"):
        table.save(tmp_path / "own.xlsx")
    pyarrow = pytest.importorskip("pyarrow")
    from pyarrow import feather, parquet

    table.save(tmp_path / "own.parquet")
    table.save(tmp_path / "own.arrow")
    whole = pyarrow.table(table)
    assert parquet.read_table(tmp_path / "own.parquet").equals(whole) and feather.read_table(tmp_path / "own.arrow").equals(whole)
    assert whole["omega(3)"].null_count == 3


@pytest.mark.parametrize(
    ("module", "extra", "use"),
    [
        ("pandas", "pandas", lambda table: table.to_pandas()),
        ("numpy", "numpy", lambda table: table.to_numpy()),
        ("pyarrow", "parquet", lambda table: table.save("table.parquet")),
        ("matplotlib", "plot", lambda table: table.plot("omega(3)")),
    ],
)
def test_what_is_not_installed_is_named(module, extra, use, monkeypatch):
    table = SCENE.sweep(0, 90, 10, want=["omega(3)"])
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(kinegon.KinegonError) as refused:
        use(table)
    assert module in refused.value.message and refused.value.hint == f"pip install 'kinegon[{extra}]'"
    assert f"\n{extra} = [" in (ROOT / "pyproject.toml").read_text("utf-8")
