"""Scenes put together in Python, key by key."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from . import _files
from ._errors import SceneError
from ._scene import Scene

if TYPE_CHECKING:
    from typing_extensions import Self, Unpack

    from .types import (
        Direction,
        FigureOptions,
        LengthUnit,
        LinkDrive,
        LinkMotion,
        NameOrPlace,
        SceneFile,
        ShapePoint,
        SliderDrive,
        TimeUnit,
        Vector,
    )


class Builder:
    """Puts a scene together. Each method sets the key of the same name of a scene file and gives the builder back;
    :meth:`scene` checks the whole as if it were read from that file, with the same messages.

    >>> import kinegon
    >>> scene = (
    ...     kinegon.Builder("mm", "s", title="Offset slider-crank")
    ...     .ground("A", [0, 0])
    ...     .link("1", ["A", "B"], lengths={"AB": 50}, drive={"angle": 60, "omega": 10})
    ...     .link("2", ["B", "C"], lengths={"BC": 150})
    ...     .link("3", ["C"])
    ...     .slider("3", "C", on="ground", through=[0, -20], along=0)
    ...     .near("C", [160, -20])
    ...     .scene()
    ... )
    >>> print(scene.solve().quantity("v(C).x").unit)
    mm/s

    Lengths and times are in the units that it is made with, angles in degrees, rates in rad per unit of time; x is right, y
    is up, counter-clockwise is positive.
    """

    def __init__(self, length: LengthUnit, time: TimeUnit, *, title: str | None = None) -> None:
        self._file: dict[str, Any] = {"kinegon": 1}
        if title is not None:
            self._file["title"] = title
        self._file |= {"units": {"length": length, "time": time}, "links": {}}

    def ground(self, point: str, place: Vector | None = None) -> Self:
        """Adds a point of the frame, with its coordinates in the fixed frame; in a drawn configuration :meth:`point` gives them."""
        if place is None:
            self._file.setdefault("ground", []).append(point)
            return self
        return self._add("ground", point, place)

    def point(self, point: str, place: Vector) -> Self:
        """Adds the coordinates of a moving point in the fixed frame. The scene is then a drawn configuration: every point
        has coordinates, and there are no lengths, shapes, angles or approximate places."""
        return self._add("points", point, place)

    def known(self, point: str, velocity: Vector, acceleration: Vector | None = None) -> Self:
        """Gives the motion of a point, in a drawn configuration. Vectors are ``[x, y]`` or ``{"size": …, "angle": …}``."""
        return self._add("known", point, _given(velocity=velocity, acceleration=acceleration))

    def link(
        self,
        name: str,
        points: Sequence[str] | None = None,
        *,
        lengths: Mapping[str, float] | None = None,
        shape: Mapping[str, ShapePoint] | None = None,
        drive: LinkDrive | None = None,
        angle: float | None = None,
        motion: LinkMotion | None = None,
    ) -> Self:
        """Adds a link; its axis runs from its first to its second point.

        Args:
            name: Its name.
            points: Names of its points. A point named in two links is a revolute joint between them.
            lengths: Distances of its points, as ``{"AB": 100}``, or ``{"A1-B1": 100}`` for longer names: one for two
                points, three for three.
            shape: In place of points and lengths the coordinates of its points in its own frame, whose x axis is its axis.
            drive: The drive that turns it about its ground pivot, as ``{"angle": 60, "omega": 10}``; ``rpm`` in place of
                ``omega``, ``alpha`` if it is not zero.
            angle: The angle of its axis in degrees, in place of that of another link's drive.
            motion: Its known motion, in a drawn configuration.
        """
        return self._add("links", name, _given(points=points, lengths=lengths, shape=shape, drive=drive, angle=angle, motion=motion))

    def slider(
        self,
        link: str,
        at: str,
        *,
        on: str,
        through: NameOrPlace | None = None,
        along: Direction | None = None,
        turned: float | None = None,
        drive: SliderDrive | None = None,
    ) -> Self:
        """Lets a link slide by its point ``at`` on a straight guide.

        Args:
            link: The sliding link.
            at: Its point that is on the guide.
            on: What carries the guide: a link, or ``"ground"``.
            through: A point of ``on``, or ``[x, y]`` on the ground or in the shape of ``on``; without it the first point of
                ``along``, else of ``on``.
            along: Two points of ``on`` as ``"BE"``, or degrees from +x on the ground and else from the axis of ``on``, or
                ``[dx, dy]``; without it 0.
            turned: Degrees from the guide to the link's axis; without it 0.
            drive: A drive that pushes the link along, as ``{"position": 40, "speed": 100}``.
        """
        return self._sliding(link=link, at=at, on=on, through=through, along=along, turned=turned, drive=drive)

    def pin(
        self,
        pin: str,
        *,
        on: str,
        through: NameOrPlace | None = None,
        along: Direction | None = None,
        drive: SliderDrive | None = None,
    ) -> Self:
        """Lets a pin, a point of another link, ride in a slot of ``on`` without a block; else as :meth:`slider`."""
        return self._sliding(pin=pin, on=on, through=through, along=along, drive=drive)

    def near(self, point: str, place: Vector) -> Self:
        """Gives the approximate place of a point, to choose the assembly mode."""
        return self._add("near", point, place)

    def near_angle(self, link: str, degrees: float) -> Self:
        """Gives the approximate angle of a link's axis from +x, to choose the assembly mode."""
        return self._add("near", f"angle({link})", degrees)

    def figure(self, **figure: Unpack[FigureOptions]) -> Self:
        """Sets keys of what the figure shows, as ``language="es"``."""
        self._file["figure"] = {**self._file.get("figure", {}), **_given(**figure)}
        return self

    def want(self, *names: str) -> Self:
        """Names the quantities that are asked for, as ``"omega(2)"``; without it all are computed."""
        self._file["want"] = list(names)
        return self

    def form(self, marks: Mapping[str, float]) -> Self:
        """Names the quantities for which students' forms have boxes, with the marks that each is worth."""
        self._file["form"] = dict(marks)
        return self

    def to_dict(self) -> SceneFile:
        """The scene as a dict of the keys of its file, not checked."""
        file: SceneFile = json.loads(_files.dumped(self._file))
        return file

    def scene(self) -> Scene:
        """The checked scene.

        Raises:
            SceneError: The first thing that is wrong; ``path`` says where, as ``links.2.lengths``.
        """
        return Scene(self._file)

    def _add(self, table: str, name: str, value: object) -> Self:
        entries = self._file.setdefault(table, {})
        if name in entries:
            raise SceneError(f"key `{name}` stands twice", "keep one of them", f"{table}.{name}")
        entries[name] = value
        return self

    def _sliding(self, **keys: object) -> Self:
        self._file.setdefault("sliders", []).append(_given(**keys))
        return self

    def __repr__(self) -> str:
        return f"<kinegon.Builder: links {', '.join(self._file['links']) or 'none'}>"


def _given(**keys: object) -> dict[str, object]:
    """What is not None."""
    return {key: value for key, value in keys.items() if value is not None}
