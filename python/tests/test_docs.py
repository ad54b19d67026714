"""The examples in docstrings do what they show, to the digit."""

import doctest
import importlib
import importlib.util
import pathlib
import pkgutil

import kinegon
import pytest
from conftest import ROOT


def test_examples_of_docstrings(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names = ["kinegon", *(f"kinegon.{module.name}" for module in pkgutil.iter_modules(kinegon.__path__) if module.name != "__main__")]
    results = {name: doctest.testmod(importlib.import_module(name)) for name in names}
    assert sum(result.failed for result in results.values()) == 0
    assert results["kinegon"].attempted >= 4 and results["kinegon._solution"].attempted >= 1
    assert pathlib.Path("figure-2.pdf").read_bytes().startswith(b"%PDF")


def test_a_printed_bound_is_no_smaller_than_the_bound():
    for kind in ("paper-figure-2", "four-bar", "slotted-lever"):
        solution = kinegon.Scene.kind(kind).solve()
        for name in solution.result()["quantities"]:
            quantity = solution.quantity(name)
            printed = float(str(quantity).split("± ")[1].split()[0])
            assert quantity.error is not None and quantity.error <= printed <= 10 * quantity.error + 5e-324, str(quantity)


def test_the_reference_is_that_of_the_docstrings():
    pytest.importorskip("griffe")
    spec = importlib.util.spec_from_file_location("make_api", ROOT / "python" / "make_api.py")
    make_api = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(make_api)
    assert make_api.PAGE.read_text("utf-8") == make_api.page(), "python python/make_api.py makes it anew"
