"""Curves and plans on matplotlib's axes."""

from __future__ import annotations

import kinegon
import pytest
from kinegon import _plot

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402


@pytest.fixture(autouse=True)
def closed():
    yield
    pyplot.close("all")


def test_curves_have_symbols_and_units():
    table = kinegon.Scene.kind("four-bar").sweep(0, 360, 1, want=["omega(2)", "omega(3)", "alpha(3)"], errors=True)
    ax = table.plot("omega(3)", color="C3")
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("$φ_{1}$ (°)", "$ω_{3}$ (rad/s)")
    (line,) = ax.get_lines()
    assert line.get_xdata().tolist() == table["angle(1)"].tolist() and line.get_ydata().tolist() == table["omega(3)"].tolist()
    assert line.get_color() == "C3" and set(ax.get_xticks()) >= {0, 90, 180, 270, 360}
    both = table.plot("omega(2)", "omega(3)", ax=pyplot.figure().gca())
    assert [text.get_text() for text in both.get_legend().get_texts()] == ["$ω_{2}$", "$ω_{3}$"] and both.get_ylabel() == "(rad/s)"
    with pytest.raises(kinegon.KinegonError, match="omega.3. in rad/s, alpha.3. in rad/s²"):
        table.plot("omega(3)", "alpha(3)")
    with pytest.raises(kinegon.KinegonError, match="no column `omega.9.`"):
        table.plot("omega(9)")


def test_plans_are_true_to_scale():
    solution = kinegon.Scene.kind("four-bar").solve()
    ax = solution.plot_plan("velocity")
    ax.figure.canvas.draw()
    assert ax.get_aspect() == 1 and ax.get_xlabel() == "$v_x$ (mm/s)"
    # Every arrow head is at a velocity, or between two.
    heads = [note.xy for note in ax.texts if note.arrow_patch is not None]
    for point in "BC":
        assert tuple(solution.quantity(f"v({point})").value) in [pytest.approx(head) for head in heads]
    tails = [note.xyann for note in ax.texts if note.arrow_patch is not None]
    relative = [(b[0] - a[0], b[1] - a[1]) for a, b in zip(tails, heads, strict=True)]
    assert tuple(solution.quantity("v(C/B)").value) in [pytest.approx(one) for one in relative]
    assert "$b$" in [note.get_text() for note in ax.texts]
    accelerations = solution.plot_plan("acceleration")
    accelerations.figure.canvas.draw()
    assert accelerations.get_ylabel() == "$a_y$ (mm/s²)"
    with pytest.raises(kinegon.KinegonError, match="there is no plan `force`"):
        solution.plot_plan("force")


def test_every_kind_is_drawn():
    """Symbols are such that matplotlib can set them."""
    for kind in kinegon.KINDS:
        solution = kinegon.Scene.kind(kind).solve()
        figure, axes = pyplot.subplots(1, 3)
        for ax, which in zip(axes, ("velocity", "acceleration")):
            solution.plot_plan(which, ax=ax)
        # A drawn configuration stands still.
        if "points" not in kinegon.Scene.kind(kind).to_dict():
            table = solution.sweep(step=30)
            table.plot(*[name for name in table.names[1:] if table.units[name] == table.units[table.names[1]]], ax=axes[2])
        figure.canvas.draw()
        pyplot.close(figure)


def test_names_of_strangers_are_set_as_they_are():
    for odd in ["a_", "^", "v_{$x^2$}", "\\frac", "#%&~", "}{", "_{a}_{b}", "v_{D_2}", "p' 2", "a^n^t"]:
        pyplot.figure().text(0, 0, _plot.mathtext(odd))
        pyplot.gcf().canvas.draw()
