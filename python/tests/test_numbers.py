"""Numbers against a four-bar linkage worked out here, from its triangle and its loop equations."""

from __future__ import annotations

import kinegon
import numpy
import pytest

CRANK, COUPLER, ROCKER, BASE, OMEGA = 60.0, 140.0, 110.0, 160.0, 10.0


def linkage(degrees):
    """Angles (degrees), angular velocities and accelerations of coupler and rocker, by crank angle."""
    crank = CRANK * numpy.exp(1j * numpy.radians(degrees))
    diagonal = BASE - crank
    length = numpy.abs(diagonal)
    at_crank = numpy.arccos((COUPLER**2 + length**2 - ROCKER**2) / (2 * COUPLER * length))
    coupler = COUPLER * numpy.exp(1j * (numpy.angle(diagonal) + at_crank))
    rocker = crank + coupler - BASE
    # i ω₁ r₁ + i ω₂ r₂ = i ω₃ r₃, and once more by time.
    matrix = numpy.stack([[coupler.real, -rocker.real], [coupler.imag, -rocker.imag]]).transpose(2, 0, 1)
    solve = lambda z: numpy.linalg.solve(matrix, numpy.stack([z.real, z.imag], -1)[..., None])[..., 0].T
    omega = solve(-OMEGA * crank)
    accelerations = OMEGA**2 * crank + omega[0] ** 2 * coupler - omega[1] ** 2 * rocker
    alpha = solve(accelerations / 1j)
    return numpy.degrees(numpy.angle([coupler, rocker])), omega, alpha, crank + coupler


def test_a_position():
    solution = kinegon.Scene.kind("four-bar").solve()
    angle, omega, alpha, place = linkage(numpy.array([60.0]))
    result = solution.result()
    for index, link in enumerate(["2", "3"]):
        assert result["links"][link]["angle"] == pytest.approx(angle[index, 0], rel=1e-12)
        assert float(solution.quantity(f"omega({link})")) == pytest.approx(omega[index, 0], rel=1e-12)
        assert float(solution.quantity(f"alpha({link})")) == pytest.approx(alpha[index, 0], rel=1e-12)
    assert result["points"]["C"]["position"] == pytest.approx([place[0].real, place[0].imag], rel=1e-12)


def test_the_whole_cycle():
    table = kinegon.Scene.kind("four-bar").sweep(0, 360, 0.5, want=["omega(2)", "omega(3)", "alpha(3)", "v(C)"])
    assert table.names == ["angle(1)", "omega(2)", "omega(3)", "alpha(3)", "v(C).x", "v(C).y"]
    assert list(table.units.values()) == ["°", "rad/s", "rad/s", "rad/s²", "mm/s", "mm/s"]
    assert len(table) == 721 and table.is_complete
    _, omega, alpha, place = linkage(table["angle(1)"])
    velocity = 1j * omega[1] * (place - BASE)
    wanted = numpy.stack([omega[0], omega[1], alpha[1], velocity.real, velocity.imag], 1)
    numpy.testing.assert_allclose(table.to_numpy()[:, 1:], wanted, rtol=1e-11, atol=1e-9)


def test_errors_hold_what_they_bound():
    """The paper's mechanism in numbers of 50 digits is a test of the library; here they come over as numbers."""
    solution = kinegon.Scene.kind("four-bar").solve()
    _, omega, _, place = linkage(numpy.array([60.0]))
    quantity = solution.quantity("omega(3)")
    assert quantity.unit == "rad/s" and 0 < quantity.error < 1e-12
    assert abs(quantity.value - omega[1, 0]) < 1e-12
    vector = solution.quantity("v(C)")
    velocity = 1j * omega[1, 0] * (place[0] - BASE)
    assert vector.value == pytest.approx((velocity.real, velocity.imag)) and vector.unit == "mm/s"
    table = kinegon.Scene.kind("four-bar").sweep(0, 90, 30, want=["omega(3)"], errors=True)
    assert table.names == ["angle(1)", "omega(3)", "omega(3)_error"] and table.units["omega(3)_error"] == "rad/s"
    assert (table["omega(3)_error"] > 0).all()


def test_both_modes():
    scene = kinegon.Scene.kind("four-bar")
    modes = scene.modes()
    assert [mode.number for mode in modes] == [1, 2] and sum(mode.is_own for mode in modes) == 1
    _, _, _, place = linkage(numpy.array([60.0]))
    own, other = sorted(modes, key=lambda mode: not mode.is_own)
    assert own.points["C"] == pytest.approx((place[0].real, place[0].imag))
    # The other is its mirror image in the line from B to D.
    b, d, c = CRANK * numpy.exp(1j * numpy.pi / 3), BASE, place[0]
    mirrored = b + (d - b) * numpy.conj((c - b) / (d - b))
    assert other.points["C"] == pytest.approx((mirrored.real, mirrored.imag))
    assert scene.solve(mode=other.number).result()["points"]["C"]["position"] == pytest.approx([mirrored.real, mirrored.imag])


def test_extremes():
    """The rocker's ends are where crank and coupler lie in line; there it is at rest."""
    found = kinegon.Scene.kind("four-bar").solve().extremes(want=["omega(3)", "angle(3)", "omega(1)"])
    degrees = numpy.linspace(0, 360, 36001)
    _, omega, _, _ = linkage(degrees)
    rate = found["omega(3)"]
    assert rate.unit == "rad/s" and rate.max_at == pytest.approx(degrees[omega[1].argmax()], abs=0.01)
    assert rate.max >= omega[1].max() > rate.max - 1e-6 and rate.min <= omega[1].min() < rate.min + 1e-6

    def rocker(reach):
        return numpy.degrees(numpy.arccos((BASE**2 + ROCKER**2 - reach**2) / (2 * BASE * ROCKER)))

    swing = found["angle(3)"]
    assert swing.max == pytest.approx(180 - rocker(COUPLER - CRANK), rel=1e-12)
    assert swing.min == pytest.approx(180 - rocker(COUPLER + CRANK), rel=1e-12)
    at = numpy.degrees(numpy.arccos((BASE**2 + (COUPLER + CRANK) ** 2 - ROCKER**2) / (2 * BASE * (COUPLER + CRANK))))
    assert swing.min_at == pytest.approx(at, abs=1e-5)
    assert (found["omega(1)"].min, found["omega(1)"].max) == (OMEGA, OMEGA)
    assert abs(swing.min - (180 - rocker(COUPLER + CRANK))) <= swing.min_error + 1e-13 and swing.min_error < 1e-9
    assert abs(swing.min_at - at) <= swing.min_at_error + 1e-13


def test_what_grows_without_bound_has_no_extreme():
    """With a crank of 95 mm coupler and rocker come to lie in line, where the rocker would have to jump."""
    scene = kinegon.Scene.kind("four-bar").to_dict()
    scene["links"]["1"]["lengths"]["AB"] = 95
    with pytest.warns(kinegon.PartialWarning, match="only a part of the range") as told:
        found = kinegon.Scene(scene).solve().extremes(0, 360, want=["alpha(3)"])
    assert found["alpha(3)"].max is None or found["alpha(3)"].min is None
    assert told[0].filename == __file__
