"""Studies against a four-bar linkage worked out here, and against the program of the same wheel."""

from __future__ import annotations

import csv
import io
import json
import multiprocessing
import pickle

import kinegon
import numpy
import pytest
from conftest import ROOT
from test_numbers import BASE, CRANK, OMEGA, ROCKER

EXAMPLE = ROOT / "examples" / "studies" / "four-bar.json"

STUDY = {
    "kinegon_study": 1,
    "scene": kinegon.Scene.kind("four-bar"),
    "vary": {"2.BC": {"from": 130, "to": 150, "count": 5}, "3.CD": {"plus_minus": 0.5}},
    "count": 20,
    "cycle": {"from": 0, "to": 360, "step": 5},
    "want": {"omega(3)": ["max", "min"], "angle(3)": ["range"]},
}


#: Nothing at random, and not every mechanism whole.
GRID = {key: value for key, value in STUDY.items() if key != "count"} | {"vary": {"2.BC": {"from": 20, "to": 140, "count": 4}}}


def omega(degrees, coupler, rocker):
    """Angular velocity of the rocker: Freudenstein's equation, differentiated."""
    crank = numpy.radians(degrees)
    place = CRANK * numpy.exp(1j * crank)
    diagonal = BASE - place
    length = numpy.abs(diagonal)
    direction = numpy.angle(diagonal) + numpy.arccos((coupler**2 + length**2 - rocker**2) / (2 * coupler * length))
    swing = numpy.angle(place + coupler * numpy.exp(1j * direction) - BASE)
    return OMEGA * CRANK * numpy.sin(direction - crank) / (rocker * numpy.sin(direction - swing)), swing


def test_figures_are_those_of_the_closed_form():
    study = kinegon.Study(STUDY)
    assert len(study) == 100 and study.names[:4] == ["index", "2.BC", "3.CD", "status"]
    table = study.rows()
    assert table.names == study.names and table.units["omega(3).max"] == "rad/s"
    assert [table.units[name] for name in ["index", "2.BC", "status", "reach_to", "omega(3).max_at"]] == ["", "mm", "", "°", "°"]
    assert table["index"].tolist() == list(range(100)) and set(table["status"]) == {"whole"}
    assert table["2.BC"].tolist() == numpy.repeat([130, 135, 140, 145, 150], 20).tolist()
    assert (abs(table["3.CD"] - ROCKER) <= 0.5).all() and len(set(table["3.CD"])) == 100
    degrees = numpy.linspace(0, 360, 72001)
    for row in range(0, 100, 7):
        rate, swing = omega(degrees, table["2.BC"][row], table["3.CD"][row])
        height = numpy.ptp(rate)
        assert table["omega(3).max"][row] == pytest.approx(rate.max(), abs=2e-6 * height)
        assert table["omega(3).min"][row] == pytest.approx(rate.min(), abs=2e-6 * height)
        assert table["omega(3).max_at"][row] == pytest.approx(degrees[rate.argmax()], abs=0.2)
        assert table["angle(3).range"][row] == pytest.approx(numpy.degrees(numpy.ptp(swing)), abs=1e-4)


def test_rows_are_the_same_anywhere(program):
    study = kinegon.Study(EXAMPLE)
    whole = study.rows().to_numpy()
    for first, last in [(0, 1), (31, 33), (500, 700), (999, 1000), (7, 7)]:
        numpy.testing.assert_array_equal(study.rows(first, last).to_numpy(), whole[first:last])
    again = pickle.loads(pickle.dumps(study))
    numpy.testing.assert_array_equal(again.rows(100, 200).to_numpy(), whole[100:200])
    header, *lines = csv.reader(io.StringIO(program("study", EXAMPLE).decode()))
    assert header == study.names and [line[4] for line in lines] == study.rows()["status"].tolist()
    numbers = [line[:4] + line[5:] for line in lines]
    numpy.testing.assert_array_equal(numpy.array(numbers, float), numpy.delete(whole, 4, axis=1))


def _shard(study, first, last):
    return study.rows(first, last).to_numpy()


def test_other_processes_compute_shards():
    study = kinegon.Study(STUDY)
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        parts = pool.starmap(_shard, [(study, first, first + 25) for first in range(0, 100, 25)])
    numpy.testing.assert_array_equal(numpy.concatenate(parts), study.rows().to_numpy())


def test_words_and_whole_numbers(program, tmp_path):
    pyarrow, parquet, pandas = (pytest.importorskip(name) for name in ["pyarrow", "pyarrow.parquet", "pandas"])

    study = kinegon.Study(GRID)
    table = study.rows()
    words = ["not assembled", "part", "part", "whole"]
    # At 60° B is 140 mm from D: 20 + 110 mm are too short; 60 and 100 mm reach it, and not B's farthest place, 220 mm from D.
    assert table["status"].tolist() == words
    frame = table.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and frame["status"].tolist() == words and frame["index"].dtype == numpy.uint64
    arrow = pyarrow.table(table)
    assert arrow["status"].to_pylist() == words and arrow["index"].to_pylist() == [0, 1, 2, 3]
    assert arrow["omega(3).max"].null_count == numpy.isnan(table["omega(3).max"]).sum() >= 1
    assert pickle.loads(pickle.dumps(table))["status"].tolist() == words
    # So has a file, and that of the program if it is built to write one.
    study.save(tmp_path / "own.parquet")
    assert parquet.read_table(tmp_path / "own.parquet").to_pydict() == arrow.to_pydict()
    (tmp_path / "study.json").write_text(json.dumps({**GRID, "scene": kinegon.Scene.kind("four-bar").to_dict()}))
    if b"parquet" in program("study", "--help"):
        program("study", tmp_path / "study.json", "-o", tmp_path / "program.parquet")
        assert parquet.read_table(tmp_path / "program.parquet").to_pydict() == arrow.to_pydict()
    with pytest.raises(kinegon.KinegonError, match="is no name of a Parquet file"):
        study.save(tmp_path / "own.xls")
    with pytest.raises(FileNotFoundError):
        study.save(tmp_path / "none" / "own.parquet")
    assert not list(tmp_path.glob(".kinegon*"))


def test_a_scene_in_a_file_of_its_own(tmp_path):
    scene = tmp_path / "scenes" / "own.json"
    scene.parent.mkdir()
    kinegon.Scene.kind("four-bar").save(scene)
    study = {**STUDY, "scene": "scenes/own.json"}
    (tmp_path / "study.json").write_text(json.dumps(study))
    rows = kinegon.Study(STUDY).rows().to_numpy()
    for found in [kinegon.Study(tmp_path / "study.json"), kinegon.Study(study, folder=tmp_path)]:
        numpy.testing.assert_array_equal(found.rows().to_numpy(), rows)
    with pytest.raises(FileNotFoundError):
        kinegon.Study(study)
    scene.write_text('{ "kinegon": 1,\n  "unit": {} }')
    with pytest.raises(kinegon.SceneError, match="own.json: unknown key `unit`") as refused:
        kinegon.Study(tmp_path / "study.json")
    assert (refused.value.line, refused.value.column) == (2, 3)


def test_what_is_refused():
    study = kinegon.Study(STUDY)
    for rows in [(-1, 3), (5, 4), (0, 101)]:
        with pytest.raises(kinegon.KinegonError, match="the study has rows from 0 to 100"):
            study.rows(*rows)
    with pytest.raises(TypeError):
        study.rows(0.5)
    for change, message in [
        ({"vary": {"2.BD": {"plus_minus": 1}}}, "did you mean `2.BC`"),
        ({"want": {"omega(9)": ["max"]}}, "there is no link `9`"),
        ({"vary": {}}, "nothing varies"),
        ({"vary": GRID["vary"]}, "nothing varies at random"),
    ]:
        with pytest.raises(kinegon.SceneError, match=message) as refused:
            kinegon.Study({**STUDY, **change})
        assert refused.value.line is None and refused.value.path
    with pytest.raises(kinegon.SceneError) as refused:
        kinegon.Study(json.dumps({**STUDY, "scene": {}, "wants": 1}, indent=1))
    assert refused.value.line > 1
    many = {**STUDY, "count": 50_000_000}
    with pytest.raises(kinegon.KinegonError, match="250000000 rows and 22 GB"):
        kinegon.Study(many).rows()


def test_a_file_says_where_its_rows_come_from(tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    study = kinegon.Study({**STUDY, "seed": 9})
    assert study.origin["kinegon.seed"] == "9" and study.origin["kinegon.version"] == kinegon.__version__
    assert "kinegon.scene" not in study.origin and kinegon.Study(STUDY).origin["kinegon.seed"] == "1"
    study.save(tmp_path / "some.parquet", 3, 40)
    said = parquet.read_metadata(tmp_path / "some.parquet").metadata
    # The rows can be made again from what stands in the file.
    again = kinegon.Study(said[b"kinegon.study"].decode())
    assert parquet.read_table(tmp_path / "some.parquet")["omega(3).max"].to_pylist() == again.rows(3, 40)["omega(3).max"].tolist()
    (tmp_path / "bar.json").write_text(kinegon.Scene.kind("four-bar").text)
    apart = kinegon.Study({**STUDY, "scene": "bar.json"}, folder=tmp_path)
    assert kinegon.Scene(apart.origin["kinegon.scene"]) == kinegon.Scene.kind("four-bar")
