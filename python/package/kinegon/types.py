"""The types of Kinegon's files and answers, for type checkers and editors. Made by `python/make_types.py` from the schemas; not to be changed here.

Scenes, styles, marking schemes and studies are what people write: a dict of these types is taken wherever their text is.
Results, keys and checks are what :meth:`Solution.result`, :meth:`Exercise.key` and ``Check.result`` give.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Literal, TypedDict, Union

if TYPE_CHECKING:
    from typing_extensions import NotRequired


#: A unit of length.
LengthUnit = Literal["m", "mm", "cm", "in", "ft"]


#: A unit of time.
TimeUnit = Literal["s", "min"]


#: A unit of mass.
MassUnit = Literal["kg", "g", "t", "lb", "slug", "blob"]


#: A unit of force.
ForceUnit = Literal["N", "kN", "mN", "kgf", "lbf"]


class Units(TypedDict):
    """Units of every length and time of the scene, and of masses and forces where it has some."""

    length: LengthUnit
    """Unit of length."""
    time: TimeUnit
    """Unit of time."""
    mass: NotRequired[MassUnit]
    """Unit of mass, where links have masses."""
    force: NotRequired[ForceUnit]
    """Unit of force, where there are masses, forces or springs."""
    note: NotRequired[object]
    """For people; ignored"""


class SizeAngle(TypedDict):
    """A vector by size and angle."""

    size: float
    """Size, not negative."""
    angle: float
    """Angle from +x, in degrees."""
    note: NotRequired[object]
    """For people; ignored"""


#: [x, y], or size and angle
Vector = Union[Sequence[float], SizeAngle]


Ground = Union[Mapping[str, Vector], Sequence[str]]


class PointMotion(TypedDict):
    """Known motion of a point."""

    velocity: Vector
    """Velocity, in length per time."""
    acceleration: NotRequired[Vector]
    """Acceleration, in length per time squared; left out: zero."""
    note: NotRequired[object]
    """For people; ignored"""


#: Coordinates in the link's own frame; a lone number is the distance along the link's axis
ShapePoint = Union[Vector, float]


class LinkDrive(TypedDict):
    """A drive: it turns the link (angle, omega or rpm, alpha), or pushes a sliding link (position, speed, acceleration)."""

    angle: NotRequired[float]
    """Angle of the link's axis from +x, in degrees."""
    omega: NotRequired[float]
    """Angular velocity, in radians per unit of time."""
    rpm: NotRequired[float]
    """Speed of rotation in turns per minute, in place of omega."""
    alpha: NotRequired[float]
    """Angular acceleration, in radians per unit of time squared; left out: zero."""
    position: NotRequired[float]
    """Of a sliding link: distance along its guide from the guide's `through`."""
    speed: NotRequired[float]
    """Of a sliding link: speed along its guide."""
    acceleration: NotRequired[float]
    """Of a sliding link: acceleration along its guide; left out: zero."""
    note: NotRequired[object]
    """For people; ignored"""


#: The name of a point, or coordinates
NameOrPlace = Union[str, Vector]


class LinkMotion(TypedDict):
    """Known motion of a link."""

    at: NameOrPlace
    """The point or the place where the link has the velocity and the acceleration given here."""
    velocity: Vector
    """Velocity there, in length per time."""
    acceleration: NotRequired[Vector]
    """Acceleration there, in length per time squared; left out: zero."""
    omega: NotRequired[float]
    """Angular velocity, in radians per unit of time; left out: zero."""
    alpha: NotRequired[float]
    """Angular acceleration, in radians per unit of time squared; left out: zero."""
    note: NotRequired[object]
    """For people; ignored"""


#: A point of the link; coordinates in its own frame, in a drawn configuration in the fixed frame; or a distance along its axis
LinkPlace = Union[str, Vector, float]


class LinkFields(TypedDict):
    """A rigid link. Its axis runs from its first to its second point."""

    points: NotRequired[Sequence[str]]
    """Names of its points."""
    lengths: NotRequired[Mapping[str, float]]
    """Distances between its points, as { "AB": 100 } or { "A-B": 100 }: one for two points, three for three."""
    shape: NotRequired[Mapping[str, ShapePoint]]
    """Coordinates of its points in its own frame, whose x axis is the link's axis."""
    drive: NotRequired[LinkDrive]
    """The drive that turns the link about its ground pivot."""
    angle: NotRequired[float]
    """Angle of the link's axis from +x in degrees, in place of that of a drive: one link may give it where one drive does not."""
    motion: NotRequired[LinkMotion]
    """Known motion of the link, in a drawn configuration."""
    mass: NotRequired[float]
    """Its mass, in the scene's unit of mass."""
    weight: NotRequired[float]
    """Its weight, in the scene's unit of force, in place of its mass."""
    inertia: NotRequired[float]
    """Its moment of inertia about the centre of mass, in mass · length²; left out: zero."""
    center: NotRequired[LinkPlace]
    """Its centre of mass: a point, coordinates in the link's own frame (in a drawn configuration in the fixed frame), or a distance along its axis."""
    note: NotRequired[object]
    """For people; ignored"""


Link = Union[LinkFields, Sequence[str]]


#: Two points of the guide's carrier as "BE" or "B-E"; or degrees; or [dx, dy]
Direction = Union[str, float, Vector]


class SliderDrive(TypedDict):
    """A drive that pushes a slider along its guide."""

    position: NotRequired[float]
    """Distance along the guide from `through`."""
    speed: float
    """Speed along the guide."""
    acceleration: NotRequired[float]
    """Acceleration along the guide; left out: zero."""
    note: NotRequired[object]
    """For people; ignored"""


class Slider(TypedDict):
    """A link, by its point `at`, slides on a guide of `on`; or a pin rides in a slot of `on`."""

    link: NotRequired[str]
    """The sliding link."""
    at: NotRequired[str]
    """The point of the sliding link that is on the guide."""
    pin: NotRequired[str]
    """A pin of another link that rides in the slot, in place of link and at."""
    on: str
    """What carries the guide: a link, or "ground"."""
    through: NotRequired[NameOrPlace]
    """A place on the guide: a point of `on`, or [x, y] on the ground or in the shape of `on`. Left out: the first point of `along`, else of `on`."""
    along: NotRequired[Direction]
    """The direction of the guide; left out: 0. Degrees count from +x on the ground, from the axis of `on` otherwise."""
    turned: NotRequired[float]
    """Degrees from the guide to the slider's axis; left out: 0."""
    travel: NotRequired[Sequence[float]]
    """The least and the greatest position along the guide at which the guide still holds what slides: the ends of a slot. Not in a drawn configuration."""
    drive: NotRequired[SliderDrive]
    """The drive that pushes the slider."""
    note: NotRequired[object]
    """For people; ignored"""


#: A number of teeth, that of a ring negative; or "rack" 
Teeth = Union[float, Literal["rack"]]


#: How a belt, a rope or a chain runs around two wheels.
Belt = Literal["open", "crossed"]


class Gear(TypedDict):
    """Two wheels that mesh: their pitch circles roll on each other without slip; or a wheel that rolls on a rack; or two wheels with a belt."""

    mesh: Sequence[str]
    """The two wheels: links, or "ground" for a wheel that is fixed to the frame."""
    teeth: Sequence[Teeth]
    """Their numbers of teeth, in the same order; that of a ring with inner teeth is negative. Wheels that only roll, and those of belts, have whole numbers in the ratio of their radii. "rack" stands for a straight rack, which slides on the carrier, or on which the carrier slides."""
    on: str
    """The carrier on whose pins both turn: a link (the arm of a planetary train), or "ground"."""
    belt: NotRequired[Belt]
    """How a belt or a chain runs around the wheels, in place of teeth that mesh."""
    radius: NotRequired[float]
    """The radius of the wheel's pitch circle on a rack; of wheels with a belt that of the first, which is only drawn."""
    position: NotRequired[float]
    """The rack's position along its guide, or the carrier's along the rack, where the wheel's axis stands at 0 from the carrier's; left out: 0. Not in a drawn configuration."""
    phase: NotRequired[float]
    """The angle of the second wheel's axis when that of the first stands at 0, both from the carrier's axis, in degrees; left out: 0. Not in a drawn configuration."""
    pressure: NotRequired[float]
    """The pressure angle in degrees, with which the teeth push each other apart; left out: 0, only the tangential force counts."""
    note: NotRequired[object]
    """For people; ignored"""


class Contact(TypedDict):
    """Two profiles that touch, as those of a cam and its follower."""

    links: Sequence[str]
    """The two bodies that touch: links, or "ground"."""
    centers: Sequence[str]
    """The centres of curvature of their profiles at the contact, a point of each, in the same order; only that of the first where the second profile is flat."""
    radii: NotRequired[Sequence[float]]
    """The radii of curvature in the same order, that of a hollow profile negative. In a drawn configuration they may be left out."""
    along: NotRequired[Direction]
    """The direction of the flat profile of the second body, as that of a guide; the first body lies to its right, below a face that runs to +x."""
    through: NotRequired[NameOrPlace]
    """A place on the flat profile: a point of the second body, or [x, y] on the ground or in its shape. Left out: the first point of `along`, else of the body."""
    roller: NotRequired[bool]
    """Whether the second body touches with a roller about its centre; left out: false."""
    circular: NotRequired[bool]
    """Whether both profiles are circles about these centres, or a circle and a straight line, so that the linkage is equivalent in every position; left out: false, in this position alone."""
    name: NotRequired[str]
    """The name of the equivalent link; left out: E1, E2 … in the order of the contacts."""
    note: NotRequired[object]
    """For people; ignored"""


#: A place and the factor there
TableLine = Sequence[float]


#: Lines, or the path of a CSV file that the program reads
LoadTable = Union[Sequence[TableLine], str]


class Over(TypedDict):
    """How a load changes over the motion, in the file."""

    of: str
    """What it depends on: `angle(1)`, the angle of a link, or `position(3/ground)`, the position of a slider."""
    table: LoadTable
    """Pairs: an angle in degrees or a position, and how many times the given force and couple act there; or a file with them."""
    note: NotRequired[object]
    """For people; ignored"""


class Load(TypedDict):
    """A force or a couple on a link, in the file."""

    name: NotRequired[str]
    """Its name in tables and figures; left out: F1, F2 … for forces; M1 for a couple on link 1, M2 for one on link 2 …."""
    on: str
    """The link on which it acts."""
    at: NotRequired[LinkPlace]
    """Where the force acts."""
    force: NotRequired[Vector]
    """The force, in the scene's unit of force."""
    couple: NotRequired[float]
    """The couple, in force · length, counter-clockwise positive."""
    turns: NotRequired[bool]
    """Whether the force turns with the link: then its components are along the link's axis and normal to it."""
    over: NotRequired[Over]
    """How often the force and the couple act over the motion; left out: once everywhere."""
    note: NotRequired[object]
    """For people; ignored"""


#: An end of a spring in the file: a link or "ground", and a place of it.
SpringEnd = Sequence[Union[str, LinkPlace]]


class Spring(TypedDict):
    """A spring between two places, in the file."""

    name: NotRequired[str]
    """Its name in tables and figures; left out: K1, K2 …"""
    between: Sequence[SpringEnd]
    """Its two ends, each a link or "ground" and a place of it."""
    rate: float
    """Force per length of extension."""
    length: float
    """Its length without a force."""
    note: NotRequired[object]
    """For people; ignored"""


class Friction(TypedDict):
    """Friction in the joints at a pin or in a guide, in the file."""

    pin: NotRequired[str]
    """The point of a pin."""
    guide: NotRequired[str]
    """The name of a slider, as "3/ground" or "P/3"."""
    coefficient: NotRequired[float]
    """The coefficient of friction."""
    angle: NotRequired[float]
    """The angle of friction in degrees, in place of the coefficient."""
    radius: NotRequired[float]
    """The radius of the pin's journal, in the scene's unit of length; of a pin alone."""
    fixed_in: NotRequired[str]
    """The link in which the pin is fixed, or "ground"; of a pin through three or more links, which all turn on it, alone."""
    note: NotRequired[object]
    """For people; ignored"""


#: Whether inertia counts among the loads.
Analysis = Literal["dynamic", "static"]


#: Approximate coordinates of a point; under a key like angle(3), degrees
NearValue = Union[Vector, float]


#: A part of the figure.
Panel = Literal["scheme", "velocity", "acceleration", "centers", "forces", "lever", "speeds"]


#: The plans for which scales are chosen that the scene does not give.
ScalesFor = Literal["position", "sheet", "cycle"]


#: A drawing style that comes with the program.
StyleName = Literal["paper", "print", "lecture", "board"]


#: Notation of poles, images and parts of accelerations. Names of quantities stay the same.
Notation = Literal["paper", "english", "russian", "german"]


#: How the motion along a guide is written.
Sliding = Literal["slider", "points"]


#: The index of the Coriolis part of an acceleration.
Coriolis = Literal["c", "C", "k", "cor"]


#: The letter of instant centres.
Center = Literal["P", "I", "CIR"]


#: The number of the frame, in place of the word for it.
Frame = Literal["0", "1"]


#: The sense in which the velocity plan is turned by 90°.
Turned = Literal["counter-clockwise", "clockwise"]


#: A language of headings and captions.
Language = Literal["en", "es", "de", "pt"]


#: Decimal mark of the numbers on figures and in the text of steps; results always have points.
Decimal = Literal["point", "comma"]


#: Whether construction lines are shown; "paper": shown, and the plans end where the source paper's end
Construction = Union[bool, Literal["paper"]]


#: Whether values stand at vectors and links; a unit of length: in this unit, as "m" for m/s
Values = Union[bool, Literal["m", "mm", "cm", "in", "ft"]]


#: "all", or centres by their links, as ["P(2,ground)", "P(1,3)"]
Centers = Union[Literal["all"], Sequence[str]]


class Figure(TypedDict):
    """What the figure shows, and how large."""

    panels: NotRequired[Sequence[Panel]]
    """The panels, in order; left out: the scheme and both plans."""
    mu_l: NotRequired[float]
    """Scale of the scheme: units of length per millimetre of paper."""
    mu_v: NotRequired[float]
    """Scale of the velocity plan: units of velocity per millimetre of paper."""
    mu_a: NotRequired[float]
    """Scale of the acceleration plan: units of acceleration per millimetre of paper."""
    mu_c: NotRequired[float]
    """Scale of the figure of instant centres: units of length per millimetre of paper."""
    mu_f: NotRequired[float]
    """Scale of the force plan: units of force per millimetre of paper."""
    mu_h: NotRequired[float]
    """Scale of the lever: units of velocity per millimetre of paper."""
    mu_k: NotRequired[float]
    """Scale of the speed diagram: units of length per millimetre of paper."""
    scales: NotRequired[ScalesFor]
    """For which plans scales are chosen that are not given; left out: "position"."""
    focus: NotRequired[Panel]
    """The panel that takes most of the sheet; a plan has the scheme as a small companion. Left out: the panels share the sheet."""
    page: NotRequired[Literal["a4", "a4-landscape", "a4-portrait", "a3", "a3-landscape", "a3-portrait", "letter", "letter-landscape", "letter-portrait", "16x9", "16x9-landscape", "16x9-portrait"]]
    """The sheet: "a4", "a3", "letter" or, for the projector, "16x9", with "-portrait" where it does not lie; left out: "a4"."""
    worksheet: NotRequired[bool]
    """Whether it is a work sheet: with a table of all measured lengths and a ruler to test the printer; left out: false."""
    willis: NotRequired[bool]
    """Whether Willis' table of the trains of wheels stands beside the panels; not on a work sheet. Left out: false."""
    style: NotRequired[StyleName]
    """How lines and letters look; left out: "paper"."""
    notation: NotRequired[Notation]
    """How poles, images and parts of accelerations are written; left out: "paper". Names of quantities stay the same."""
    sliding: NotRequired[Sliding]
    """How motions along guides are written: "slider" as v_r(3/2), "points" as v_B3B2; left out: "slider"."""
    coriolis: NotRequired[Coriolis]
    """The index of Coriolis accelerations; left out: that of the notation."""
    center_letter: NotRequired[Center]
    """How instant centres are written: P_13, I_13 or CIR_13; left out: "P"."""
    frame: NotRequired[Frame]
    """The number that the frame is called by, unless `labels` has a text for `ground`; left out: a word."""
    turned: NotRequired[Turned]
    """The sense in which figures and steps show the velocity plan turned by 90°; sheets to be drawn on, keys and checks have it as it is. Left out: not turned."""
    language: NotRequired[Language]
    """Language of headings and captions; left out: "en"."""
    decimal: NotRequired[Decimal]
    """Decimal mark of the numbers on figures and in the text of steps; left out: "point"."""
    labels: NotRequired[Mapping[str, str]]
    """Text to show in place of a name: { "B'": "B₁" }."""
    special_points: NotRequired[bool]
    """Whether special points are shown; left out: true."""
    construction: NotRequired[Construction]
    """Whether construction lines are shown; "paper": shown, and the plans end where the source paper's end; left out: true."""
    values: NotRequired[Values]
    """Whether values stand at vectors and links, in which unit of length; left out: as the style says, "lecture" alone does."""
    step: NotRequired[int]
    """The step of the construction up to which the figure is drawn, from 1; left out: finished."""
    trace: NotRequired[Sequence[str]]
    """Points of links whose paths over the whole cycle of the drive are drawn in the scheme."""
    beyond_limits: NotRequired[bool]
    """Whether these paths go on, dashed, beyond limits of the drive, in the other assembly modes that the mechanism reaches there if another link moves it; left out: false."""
    centrodes: NotRequired[Sequence[str]]
    """Links whose centrodes over that cycle are drawn in the scheme: the curves of the instant centre of the link and the frame, in the frame and in the link."""
    inflection: NotRequired[Sequence[str]]
    """Links whose inflection circles are drawn in the scheme, through instant centre and inflection pole."""
    ghosts: NotRequired[int]
    """Number of equally spaced positions over that cycle in which the links are drawn pale; left out: none."""
    centers: NotRequired[Centers]
    """The instant centres on the panel "centers", besides those that lead to them: "all", or a list of names, as ["P(2,ground)"]. Left out: all of a mechanism with at most four links, of a larger one those of all links with the frame."""
    velocities: NotRequired[Sequence[str]]
    """Points of links whose velocities that panel shows, found by centres from the one drive."""
    curvature: NotRequired[Sequence[str]]
    """Points of links for whose paths that panel shows the centres of curvature, by Bobillier's construction."""
    markers: NotRequired[bool]
    """Whether sheets to be drawn on, work sheets and those of exercises, have markers along their edges by which a photograph of them is read; left out: true."""
    note: NotRequired[object]
    """For people; ignored"""


_SceneFileKeys = TypedDict("_SceneFileKeys", {"$schema": "NotRequired[str]"})


class SceneFile(_SceneFileKeys):
    """A planar mechanism: x right, y up, counter-clockwise positive, angles in degrees."""

    kinegon: Literal[1]
    """Version of the scene format."""
    title: NotRequired[str]
    """Title of the mechanism, for example the publication it is from."""
    units: Units
    """Units of every length and time of the scene. They are labels; nothing is converted."""
    ground: NotRequired[Ground]
    """The frame's points with their coordinates; in a drawn configuration their names are enough."""
    points: NotRequired[Mapping[str, Vector]]
    """A drawn configuration: coordinates of every point. Then there are no lengths, shapes or angles."""
    known: NotRequired[Mapping[str, PointMotion]]
    """Points of known motion, in a drawn configuration."""
    links: Mapping[str, Link]
    """The links by name. A point named in two links is a revolute joint between them."""
    sliders: NotRequired[Sequence[Slider]]
    """Links that slide along straight guides, and pins that ride in slots."""
    gears: NotRequired[Sequence[Gear]]
    """Pairs of wheels that mesh."""
    contacts: NotRequired[Sequence[Contact]]
    """Profiles that touch, as those of a cam and its follower."""
    gravity: NotRequired[Vector]
    """The acceleration of free fall, in length per time²; left out: zero."""
    forces: NotRequired[Sequence[Load]]
    """Forces and couples on links."""
    springs: NotRequired[Sequence[Spring]]
    """Springs between links."""
    friction: NotRequired[Sequence[Friction]]
    """Coulomb friction in joints, which counts where loads press on them."""
    analysis: NotRequired[Analysis]
    """Whether inertia counts among the loads; left out: dynamic."""
    near: NotRequired[Mapping[str, NearValue]]
    """Approximate coordinates of some points, and angles of links as "angle(3)", to choose the assembly mode. The one with the least sum of squared distances from them is taken; an angle counts as its chord at a radius of the mechanism's size. A slotted lever with one point has its slider on the positive side of `through`, unless its angle stands here."""
    figure: NotRequired[Figure]
    """What the figure shows, and how large."""
    want: NotRequired[Sequence[str]]
    """Names of the quantities asked for, as "omega(2)" or "a(S3)"; left out: everything."""
    form: NotRequired[Mapping[str, float]]
    """The quantities for which the forms and sheets of students have boxes, as "omega(2)" or "vplan(p,b)", with the marks that each is worth; left out: all that the steps of the construction give, one mark each. What no step gives has no box."""
    hints: NotRequired[int]
    """How many stages of a hint somebody may open who solves this as an exercise in the workbench: 1 the plan, 2 the first wrong value, 3 the step, 4 what was done; left out: all."""
    note: NotRequired[object]
    """For people; ignored"""


_MarksFileKeys = TypedDict("_MarksFileKeys", {"$schema": "NotRequired[str]"})


class MarksFile(_MarksFileKeys):
    """How many marks the values of a form earn. A value that is right or within the tolerance earns the marks of its quantity; one that is off earns none, or where it follows from a mistake made at an earlier step and is consistent with it, the part `follow_through` of them. Every mistake is charged once: in the value in which it was made, whatever else that follows from, or where no value of its step shows it, as that of a line, in the first that does. From a mistake that has no name nothing follows where it leaves more than half as many wrong values open as it explains. A value that tells nothing earns none, and a rate without its sense earns none. What is too small on the sheet to be judged does not count."""

    kinegon_marks: Literal[1]
    """Version of the format."""
    each: NotRequired[float]
    """Marks of every quantity of the scene's form that `values` does not name. Left out: what the scene's `form` says, else 1, where `values` is left out, too, else only the quantities in `values` count."""
    values: NotRequired[Mapping[str, float]]
    """Marks of single quantities by their names, as in the form."""
    follow_through: NotRequired[float]
    """Which part of its marks a wrong value earns that follows from an earlier mistake and is consistent with it; left out: 1."""
    missing: NotRequired[float]
    """Which part of its marks a quantity earns whose value is not there; left out: 0."""
    note: NotRequired[object]
    """For people; ignored"""


#: Red, green and blue
StyleColour = str


#: Dashes and gaps in turn, in mm; [] for a full line
StyleDash = Sequence[float]


StyleMeasure = Union[float, str]


class StyleSizes(TypedDict):
    """Sizes of letters and signs on a sheet: in mm, or as "3.6 %" of the sheet's shorter side."""

    letters: NotRequired[StyleMeasure]
    """Size of letters, one em; subscripts are smaller."""
    arrowheads: NotRequired[StyleMeasure]
    """Length of the arrowheads of long vectors."""
    points: NotRequired[StyleMeasure]
    """Diameter of the dots in plans."""
    joints: NotRequired[StyleMeasure]
    """Diameter of the circles of joints."""
    note: NotRequired[object]
    """For people; ignored"""


#: A colour; or the style's ink, the background, the colour, the tint or a pale shade of the mark's link, the colour of its curve
StylePaint = Union[StyleColour, Literal["none", "ink", "background", "link", "tint", "pale", "curve"]]


StyleMillimetres = float


StyleDashes = Union[StyleDash, Literal["curve"]]


#: How a line ends.
StyleCap = Literal["flat", "round"]


class StylePen(TypedDict):
    """How one kind of mark looks."""

    stroke: NotRequired[StylePaint]
    """Colour of lines and arrowheads."""
    width: NotRequired[StyleMillimetres]
    """Width of lines, in mm."""
    dash: NotRequired[StyleDashes]
    """Dashes and gaps in turn, in mm; [] for full lines."""
    fill: NotRequired[StylePaint]
    """Colour inside polygons and circles."""
    cap: NotRequired[StyleCap]
    """How lines end: "flat" at the very end, "round" beyond it."""
    ink: NotRequired[StylePaint]
    """Colour of letters; left out: that of lines, else the style's ink."""
    halo: NotRequired[StyleMillimetres]
    """Width of the line in the background's colour around letters that stand on lines, in mm; 0 for none."""
    note: NotRequired[object]
    """For people; ignored"""


class StyleFilePens(TypedDict):
    """How each kind of mark looks."""

    frame: NotRequired[StylePen]
    """The border of a panel, axes, the bar of a scale."""
    ground: NotRequired[StylePen]
    """The line of the frame that a pivot or a guide stands on."""
    hatch: NotRequired[StylePen]
    """The short strokes under a ground line."""
    link: NotRequired[StylePen]
    """A link drawn as a line, or the outline of one drawn as an area."""
    link_fill: NotRequired[StylePen]
    """The tinted area of a link."""
    slider: NotRequired[StylePen]
    """A sliding block, or a pivot's foot: outlined."""
    guide: NotRequired[StylePen]
    """The straight guide that a block slides on."""
    joint: NotRequired[StylePen]
    """A revolute joint: a small circle."""
    trace: NotRequired[StylePen]
    """The path of a point over a cycle."""
    beyond: NotRequired[StylePen]
    """The rest of such a path, beyond the limits of the drive."""
    ghost: NotRequired[StylePen]
    """A link in another position of the cycle."""
    equivalent: NotRequired[StylePen]
    """A link, or a pin on its guide, that moves as profiles that touch do."""
    construction: NotRequired[StylePen]
    """A helping line of the scheme."""
    ray: NotRequired[StylePen]
    """A line of known direction in a plan."""
    vector: NotRequired[StylePen]
    """A vector that is neither of the kinds below."""
    velocity: NotRequired[StylePen]
    """A velocity."""
    acceleration: NotRequired[StylePen]
    """A total acceleration."""
    normal: NotRequired[StylePen]
    """A normal part of an acceleration, known before the plan is closed."""
    tangential: NotRequired[StylePen]
    """A tangential part, found by closing the plan."""
    coriolis: NotRequired[StylePen]
    """A Coriolis part."""
    pole: NotRequired[StylePen]
    """The pole of a plan."""
    image: NotRequired[StylePen]
    """The outline of the image of a link in a plan."""
    image_fill: NotRequired[StylePen]
    """The area of such an image."""
    image_point: NotRequired[StylePen]
    """The end of a vector in a plan, the image of a point: a small dot."""
    special: NotRequired[StylePen]
    """A special (Assur) point and what belongs to it."""
    turning: NotRequired[StylePen]
    """The sense of turning: curved arrows of ω and α."""
    leader: NotRequired[StylePen]
    """The line from a label to what it names when it had to stand apart."""
    label: NotRequired[StylePen]
    """The name of a point, a link or a vector; haloed, so that it reads across lines."""
    hint: NotRequired[StylePen]
    """What a step is about, in that step alone: a broad pale line under a length or a direction."""
    caption: NotRequired[StylePen]
    """Running text: scales, equations, captions."""
    heading: NotRequired[StylePen]
    """The heading of a panel or a sheet."""
    grid: NotRequired[StylePen]
    """A line at a round value of an axis."""
    zero: NotRequired[StylePen]
    """The line at zero."""
    curve: NotRequired[StylePen]
    """A quantity over the cycle, its name, and the dots at its greatest and least values."""
    dead: NotRequired[StylePen]
    """A dead centre of the link or slider: a small circle on the line at zero."""
    limit: NotRequired[StylePen]
    """Where a drive can go no further."""
    change: NotRequired[StylePen]
    """Where the motion could go on in another assembly mode too."""
    stand: NotRequired[StylePen]
    """Where the drive stands in the scene."""
    student: NotRequired[StylePen]
    """A line of a student's drawing over the right one."""
    student_point: NotRequired[StylePen]
    """A point of such a drawing, a small cross, and its name."""
    wrong: NotRequired[StylePen]
    """A line or a vector of a hand's drawing that is wrong by itself."""
    wrong_point: NotRequired[StylePen]
    """Such a point, its name, and the cross by which a wrong line is struck."""
    note: NotRequired[object]
    """For people; ignored"""


_StyleFileKeys = TypedDict("_StyleFileKeys", {"$schema": "NotRequired[str]"})


class StyleFile(_StyleFileKeys):
    """How a figure looks: colours, widths and dashes of its pens. What is left out is as in the style that this one is based on."""

    kinegon_style: Literal[1]
    """Version of the style format."""
    based_on: NotRequired[StyleName]
    """The style that this one differs from; left out: "paper"."""
    background: NotRequired[StyleColour]
    """Colour of the paper, and of the halos around letters."""
    ink: NotRequired[StyleColour]
    """Colour of everything that has no other."""
    accent: NotRequired[StyleColour]
    """Colour of what comes with the step that a sheet shows."""
    links: NotRequired[Sequence[StyleColour]]
    """Colours of the links in their order, again from the first where there are more links; [] for none."""
    tints: NotRequired[Sequence[StyleColour]]
    """Tints of the links' areas, likewise."""
    curves: NotRequired[Sequence[StyleColour]]
    """Colours of the curves in a panel, likewise."""
    curve_dashes: NotRequired[Sequence[StyleDash]]
    """Dashes of the curves: all colours with the first, then all with the second, and so on."""
    sizes: NotRequired[StyleSizes]
    """Sizes of letters and signs; everything else on a sheet is in proportion to its letters."""
    values: NotRequired[bool]
    """Whether figures show values where the scene does not say so; left out: as the style that this one is based on."""
    pens: NotRequired[StyleFilePens]
    """How each kind of mark looks."""
    note: NotRequired[object]
    """For people; ignored"""


_StudyRangeKeys = TypedDict("_StudyRangeKeys", {"from": "NotRequired[float]"})


class StudyRange(_StudyRangeKeys):
    """The values that a number takes: a grid with `count`, all equally likely between `from` and `to` without it; about the scene's number within `plus_minus`, all equally likely; or about it with the standard deviation `sigma`."""

    to: NotRequired[float]
    """Last value."""
    count: NotRequired[int]
    """Number of values of a grid, both ends among them."""
    nominal: NotRequired[float]
    """The middle of `plus_minus` or `sigma`; left out: the scene's number."""
    plus_minus: NotRequired[float]
    """Largest distance from the middle."""
    sigma: NotRequired[float]
    """Standard deviation of a normal distribution."""
    note: NotRequired[object]
    """For people; ignored"""


_StudyCycleKeys = TypedDict("_StudyCycleKeys", {"from": "float"})


class StudyCycle(_StudyCycleKeys):
    """The motion of a drive in equal steps."""

    drive: NotRequired[str]
    """The drive that moves, if not the first."""
    to: float
    """Last value of the drive."""
    step: float
    """Distance from one position to the next; a whole number of steps leads from `from` to `to`."""
    alone: NotRequired[bool]
    """Whether other drives stand still; left out: they run along in proportion to their speeds."""
    note: NotRequired[object]
    """For people; ignored"""


#: What is said of a quantity over the cycle.
StudyFigure = Literal["max", "min", "max_abs", "range", "mean", "fluctuation", "at_scene"]


_StudyFileKeys = TypedDict("_StudyFileKeys", {"$schema": "NotRequired[str]"})


class StudyFile(_StudyFileKeys):
    """Many mechanisms that differ from one scene in some numbers, each moved through a cycle."""

    kinegon_study: Literal[1]
    """Version of the format."""
    title: NotRequired[str]
    """What the study is for; not used."""
    scene: Union[str, SceneFile]
    """The scene: the path of its file from the study's folder, or the scene itself."""
    vary: Mapping[str, StudyRange]
    """The numbers of the scene that vary, by name: "2.BC" a length of link 2, "D.x" a coordinate of a ground point, "2.E.y" one in a link's shape, "1.omega" a number of a drive; or by their places in the scene, as "links.2.lengths.BC"."""
    count: NotRequired[int]
    """How many mechanisms are drawn by lot at each point of the grid; needed where a number varies at random."""
    seed: NotRequired[int]
    """Chooses the random numbers; left out: 1."""
    bounds: NotRequired[bool]
    """Whether `max`, `min`, `max_abs` and `at_scene` each have a column with the bound of the error of the value there, as "omega(3).max_error"; left out: not. It takes some hundred times as long."""
    at_steps: NotRequired[bool]
    """Whether extremes of a mechanism that goes round smoothly are those of the positions at the steps, and are not looked for between them; left out: they are. It takes less time, and misses the true extremes by up to the height of the curve between two steps."""
    cycle: StudyCycle
    """The motion of each mechanism."""
    want: Mapping[str, Sequence[StudyFigure]]
    """By the name of a quantity, as "omega(3)": which figures of it; of vectors they are figures of the size."""
    note: NotRequired[object]
    """For people; ignored"""


class ResultUnits(TypedDict):
    """Units of the numbers."""

    length: str
    """Unit of length."""
    time: str
    """Unit of time."""
    mass: NotRequired[Union[str, None]]
    """Unit of mass."""
    force: NotRequired[Union[str, None]]
    """Unit of force; moments are in force · length."""


class LinkResult(TypedDict):
    """The motion of a link."""

    angle: NotRequired[Union[float, None]]
    """Angle of its axis from +x in degrees, in (−180, 180]."""
    angle_error: NotRequired[Union[float, None]]
    """Bound on the error of `angle`, in degrees."""
    omega: float
    """Angular velocity, counter-clockwise positive."""
    omega_error: NotRequired[Union[float, None]]
    """Bound on the error of `omega`."""
    omega_error_at_position: float
    """Bound on its error where the positions of this file and the rates of the scene count as exact."""
    alpha: NotRequired[Union[float, None]]
    """Angular acceleration."""
    alpha_error: NotRequired[Union[float, None]]
    """Bound on the error of `alpha`."""
    alpha_error_at_position: NotRequired[Union[float, None]]
    """Bound on its error where the positions of this file and the rates of the scene count as exact."""


class PointResult(TypedDict):
    """The motion of a point."""

    position: NotRequired[Union[list[float], None]]
    """Where it is."""
    position_error: NotRequired[Union[float, None]]
    """Bound on the error of both coordinates."""
    at_infinity: NotRequired[Union[list[float], None]]
    """The direction in which it lies at infinity, in place of a position."""
    velocity: NotRequired[Union[list[float], None]]
    """Its velocity."""
    velocity_error: NotRequired[Union[float, None]]
    """Bound on the error of both components of `velocity`."""
    acceleration: NotRequired[Union[list[float], None]]
    """Its acceleration."""
    acceleration_error: NotRequired[Union[float, None]]
    """Bound on the error of both components of `acceleration`."""
    on: NotRequired[Union[str, None]]
    """The link of which it is a point, where its name does not say so."""


class SliderResult(TypedDict):
    """The motion of a slider along its guide, seen from the body that carries the guide."""

    on: str
    """The body that carries the guide."""
    position: NotRequired[Union[float, None]]
    """Its position along the guide, counted from the guide's `through`."""
    position_error: NotRequired[Union[float, None]]
    """Bound on the error of `position`."""
    engaged: NotRequired[Union[bool, None]]
    """Whether the guide holds it there; only of a guide with ends."""
    velocity: float
    """Sliding velocity, positive along the guide."""
    velocity_error: NotRequired[Union[float, None]]
    """Bound on the error of `velocity`."""
    velocity_error_at_position: float
    """Bound on its error where the positions of this file and the rates of the scene count as exact."""
    acceleration: NotRequired[Union[float, None]]
    """Sliding acceleration."""
    acceleration_error: NotRequired[Union[float, None]]
    """Bound on the error of `acceleration`."""
    acceleration_error_at_position: NotRequired[Union[float, None]]
    """Bound on its error where the positions of this file and the rates of the scene count as exact."""
    coriolis: NotRequired[Union[list[float], None]]
    """Coriolis acceleration 2 ω ẑ × v_r, a vector."""
    coriolis_error: NotRequired[Union[float, None]]
    """Bound on the error of both components of `coriolis`."""


_GroupResultKeys = TypedDict("_GroupResultKeys", {"class": "str"})


class GroupResult(_GroupResultKeys):
    """An Assur group and how well its motion is determined."""

    links: list[str]
    """Its links."""
    joints: str
    """Kinds of its joints, R revolute or P prismatic; of a fourth-class group B C D E F G."""
    special_points: list[str]
    """Its special points."""
    condition: float
    """Condition number of its loop equations, at least 1: errors of the vectors between its joints, each in parts of itself, grow by about this factor at most in its rates, each counted with the size of its link, in parts of the largest. A place's error is a large part of a short vector, and the rate of a short link alone may lose more: its bound says how much."""
    disagreement: NotRequired[Union[float, None]]
    """The largest difference between the two routes to its rates, relative to the largest rate; `null`, never left out, where a special point at infinity or a higher class leaves only one route."""
    disagreement_allowed: NotRequired[Union[float, None]]
    """The difference that rounding and the crossings' angles allow; `null` together with `disagreement`."""
    proved: bool
    """Whether its errors are proved: that one and only one assembly of it lies within those of its places, and that its rates lie within theirs. Where nothing is proved its errors are `null`."""
    mode: NotRequired[Union[int, None]]
    """Number of this assembly mode; none in a drawn configuration. Where a link's angle is given in place of a drive's, it is that of the whole mechanism."""
    modes: NotRequired[Union[int, None]]
    """How many assembly modes there are; of a group of higher class, how many were found. None where there are too many to count."""
    at_most: NotRequired[Union[int, None]]
    """How many assembly modes it can have at most, as far as that is known: of links joined by pins alone as many as there are complex ones."""
    may_move: NotRequired[bool]
    """Whether it has assemblies besides in which it may move at fixed drives; these are no modes. Left out where none was found."""


#: The value of a quantity: a number, or a vector.
QuantityResult = Union[float, list[float]]


class ForceResult(TypedDict):
    """A force."""

    force: list[float]
    """Its components."""
    force_error: NotRequired[Union[float, None]]
    """Bound on the error of both components."""
    friction: NotRequired[Union[float, None]]
    """The couple of friction that it receives beside; left out at a pin without friction."""
    friction_error: NotRequired[Union[float, None]]
    """Bound on the error of `friction`."""


class GuideForceResult(TypedDict):
    """What a sliding link receives from its guide."""

    normal: float
    """The force across the guide, along its direction turned by +90°."""
    normal_error: NotRequired[Union[float, None]]
    """Bound on the error of `normal`."""
    couple: float
    """The couple, about the slider's point."""
    couple_error: NotRequired[Union[float, None]]
    """Bound on the error of `couple`."""
    offset: NotRequired[Union[float, None]]
    """How far from the slider's point along the guide the line of the force runs; left out where there is no force across the guide."""
    offset_error: NotRequired[Union[float, None]]
    """Bound on the error of `offset`."""
    friction: NotRequired[Union[float, None]]
    """The friction along the guide, in its direction; left out of a guide without friction."""
    friction_error: NotRequired[Union[float, None]]
    """Bound on the error of `friction`."""


class MeshForceResult(TypedDict):
    """What a wheel receives from the teeth of another one, at the pitch point."""

    pitch_point: list[float]
    """The pitch point."""
    tangential: float
    """The force along the tangent: along the direction from the first wheel's centre to the second's, or from the wheel's centre to its rack, turned by +90°."""
    tangential_error: NotRequired[Union[float, None]]
    """Bound on the error of `tangential`."""
    force: list[float]
    """The whole force, with the part by which teeth push each other apart."""
    force_error: NotRequired[Union[float, None]]
    """Bound on the error of both components of `force`."""


class DriveResult(TypedDict):
    """What a drive needs."""

    torque: NotRequired[Union[float, None]]
    """The torque on the link that it turns."""
    force: NotRequired[Union[float, None]]
    """The force along the guide on the sliding link that it pushes."""
    error: NotRequired[Union[float, None]]
    """Bound on the error of the torque or force."""
    powers: dict[str, float]
    """By load: its power while this drive runs at rate 1 and the others stand. The torque or force is the negative sum."""


class InertiaResult(TypedDict):
    """The inertia of a link."""

    center: list[float]
    """Where the centre of mass is."""
    acceleration: list[float]
    """The acceleration of the centre of mass."""
    force: list[float]
    """The inertia force, −m a."""
    force_error: NotRequired[Union[float, None]]
    """Bound on the error of both components of `force`."""
    couple: float
    """The inertia couple, −J α."""
    couple_error: NotRequired[Union[float, None]]
    """Bound on the error of `couple`."""


class FrameResult(TypedDict):
    """What the links do to the frame."""

    force: list[float]
    """The force."""
    force_error: NotRequired[Union[float, None]]
    """Bound on the error of both components."""
    moment: float
    """The moment about the frame's first point."""
    moment_error: NotRequired[Union[float, None]]
    """Bound on the error of `moment`."""


class ForcesResult(TypedDict):
    """What joints carry and what drives need, in the scene's unit of force; moments in force · length, counter-clockwise positive."""

    reactions: dict[str, dict[str, ForceResult]]
    """By pin, then by link or `ground`: the force that it receives there from all others; those of a pin add up to zero."""
    sliders: dict[str, GuideForceResult]
    """By slider: what its sliding link receives from the guide."""
    meshes: dict[str, MeshForceResult]
    """By pair of wheels, as `1/2`, or of a wheel and its rack: what the first of the two receives from the other one's teeth. Left out without such pairs."""
    drives: dict[str, DriveResult]
    """By drive: what it needs."""
    inertia: dict[str, InertiaResult]
    """By link: its inertia, where it has a mass."""
    frame: FrameResult
    """What the links and springs do to the frame: the shaking force, and the moment about the frame's first point."""
    disagreement: float
    """The largest difference between the two routes to the drives' torques, equilibrium of the links and virtual power, in parts of the largest power of a load."""
    disagreement_allowed: float
    """The difference that rounding allows."""


class ContactResult(TypedDict):
    """Two profiles that touch."""

    equivalent: str
    """What moves as they do: the name of a link, or of a slider where the second profile is flat."""
    here_alone: bool
    """Whether it does so in this position alone."""
    position: NotRequired[Union[list[float], None]]
    """Where they touch; left out where no radii say it."""
    position_error: NotRequired[Union[float, None]]
    """Bound on the error of both coordinates."""
    normal: list[float]
    """The common normal, of length 1: from the first centre of curvature towards the second, or into the flat profile."""
    normal_error: NotRequired[Union[float, None]]
    """Bound on the error of both components of `normal`."""
    sliding: NotRequired[Union[float, None]]
    """The velocity of the first profile on the second where they touch, positive along the normal turned by +90°."""
    sliding_error: NotRequired[Union[float, None]]
    """Bound on the error of `sliding`."""
    roller_omega: NotRequired[Union[float, None]]
    """The angular velocity of the roller, which rolls on the first profile."""
    roller_omega_error: NotRequired[Union[float, None]]
    """Bound on the error of `roller_omega`."""
    force: NotRequired[Union[float, None]]
    """The force with which the profiles press on each other along the normal, in the scene's unit of force; negative where they would have to pull. Only of a scene with loads."""
    force_error: NotRequired[Union[float, None]]
    """Bound on the error of `force`."""


#: An instant centre: its place, or the direction in which it lies at infinity.
CenterResult = SceneFile


class BandResult(TypedDict):
    """What an honest hand drawing gives for a quantity."""

    value: float
    """Its value, of lengths and segments without a sign."""
    band: float
    """At least 95 of 100 drawings are at most this far from it."""
    unit: str
    """Unit of both."""
    rough: NotRequired[bool]
    """Present and true where errors are so large against the quantity that the band is only a rough one."""


class PencilResult(TypedDict):
    """How far hand drawings at the figure's scales are from the numbers, by quantity name."""

    mm: float
    """Limit of the error of a point set, along x and along y, and of a length laid off or measured: millimetres of paper."""
    degrees: float
    """Limit of the error of a direction drawn or read: degrees."""
    mu_l: NotRequired[Union[float, None]]
    """Scale of the scheme: units of length per millimetre of paper."""
    mu_v: NotRequired[Union[float, None]]
    """Scale of the velocity plan."""
    mu_a: NotRequired[Union[float, None]]
    """Scale of the acceleration plan."""
    mu_c: NotRequired[Union[float, None]]
    """Scale of the figure of instant centres: units of length per millimetre of paper."""
    mu_f: NotRequired[Union[float, None]]
    """Scale of the force plan: units of force per millimetre of paper."""
    mu_h: NotRequired[Union[float, None]]
    """Scale of the lever: units of velocity per millimetre of paper."""
    mu_k: NotRequired[Union[float, None]]
    """Scale of the speed diagram: units of length per millimetre of paper."""
    bands: dict[str, BandResult]
    """By quantity name: what an honest drawing gives. A vector stands here by its `.size` and its `.angle`."""
    without: NotRequired[dict[str, str]]
    """By quantity name: why a drawing gives no such value. Given values and points at rest are left out."""


class Result(TypedDict):
    """The result of `kinegon solve`: every number at full precision, in the scene's units. A `…_error` bounds the whole error of the number beside it, against what follows exactly from the numbers of the scene as they are written: positions found from lengths, drive angles found from a link's angle, rounded turns per minute and roundings of every kind count in. Of a vector it bounds each component. It is zero for a number that the scene gives, and null where no bound can be proved: at a limit position or a singular one."""

    kinegon: int
    """Version of this format."""
    units: ResultUnits
    """The scene's units; rates are in rad per unit of time, angles in degrees."""
    links: dict[str, LinkResult]
    """By link name."""
    points: dict[str, PointResult]
    """By point name; also special points (`S3`) and the points of guides under sliders (`D_2`)."""
    sliders: dict[str, SliderResult]
    """By slider name, as in `3/2`; of further sliders between the same two, in scene order, `3/2#2`."""
    proved: bool
    """Whether all errors of this file are proved; see `groups`."""
    groups: list[GroupResult]
    """The Assur groups in solving order."""
    quantities: dict[str, QuantityResult]
    """The quantities that the scene's `want` asks for."""
    quantity_errors: dict[str, Union[float, None]]
    """By quantity name: bound on its error, of a vector that of each component, of an angle in degrees."""
    forces: NotRequired[Union[ForcesResult, None]]
    """What joints carry and drives need; only of a scene with loads."""
    contacts: NotRequired[dict[str, ContactResult]]
    """By the bodies that touch, as `1/3`; of further contacts of the same two, `1/3#2`."""
    centers: NotRequired[dict[str, Union[CenterResult, None]]]
    """By name, as in `P(1,3)`: the instant centres that the scene's `want` asks for; null where the links rest on one another, or no place can be found."""
    pencil: NotRequired[Union[PencilResult, None]]
    """How far hand drawings are from these numbers; only where it is asked for."""
    warnings: list[str]
    """What the reader should know of these numbers."""
    notes: NotRequired[list[str]]
    """Links and sliders that stop and turn back in this position; the part of a turn in which a slot is engaged."""


class ValueResult(TypedDict):
    """A value with its verdict."""

    quantity: str
    """The quantity's name."""
    step: int
    """The number of the step that gives it."""
    value: float
    """The value in the scene's units and senses."""
    expected: float
    """The exact value."""
    unit: str
    """Unit of both."""
    difference: float
    """The value less the exact one."""
    difference_mm: NotRequired[float]
    """The same in millimetres of paper."""
    percent: NotRequired[float]
    """The same in per cent of the exact value."""
    allowed: NotRequired[float]
    """Largest difference that is within the tolerance; left out where the scene gives the value."""
    coarse: NotRequired[bool]
    """Whether that is a coarse tolerance, as no construction by hand gives the value."""
    verdict: str
    """"right", "within-tolerance", "sense-missing" (the size is right, the sense is not told), "off", "too-coarse" (its digits tell nothing) or "unjudged" (it is too small on its sheet)."""


class MistakeResult(TypedDict):
    """A mistake that was probably made."""

    mistake: str
    """Its name in the catalogue."""
    step: int
    """The number of its step; 0 for the whole drawing."""
    done: str
    """What was probably done."""
    should_be: str
    """What it should be."""
    written: NotRequired[list[str]]
    """Values written otherwise than meant."""
    follows: list[str]
    """Values that follow from it and are consistent with it."""


class ExplanationResult(TypedDict):
    """Mistakes that explain the values together."""

    mistakes: list[MistakeResult]
    """The mistakes in the order of the construction."""
    probability: float
    """The probability that these were made, or others that the values alone cannot tell from them, from 0 to 1; an honest share is left for mistakes that the catalogue does not have. Causes are told from 0.6 on. Without mistakes: the probability that none was made that the catalogue has."""
    indistinguishable: NotRequired[bool]
    """Whether the given values alone cannot tell it from the diagnosis."""
    within: NotRequired[bool]
    """Whether it is one way in which what the diagnosis tells as "unknown", only by its place, may have happened: its probability is a part of the diagnosis's."""


class AccuracyResult(TypedDict):
    """How accurate somebody draws and computes. Within the limits every error is equally likely."""

    mm: float
    """Limit of the errors in lengths and places, in mm of paper."""
    degrees: float
    """Limit of the errors in directions, in degrees."""
    percent: float
    """Limit of the errors of computed numbers, in per cent; 0 where no slips are seen."""


class TurnedResult(TypedDict):
    """A plan that lies turned to the scheme."""

    plan: str
    """The plan: "velocity", "acceleration"."""
    degrees: float
    """By how many degrees, positive counter-clockwise."""


class ScaleResult(TypedDict):
    """A scale of a form that is not the one asked for, or at which no sheet can be drawn."""

    scale: str
    """Its name in the form: `mu_l`, `mu_v`, `mu_a`."""
    stated: float
    """What the form states, in units per millimetre."""
    asked: NotRequired[float]
    """What the scene's figure states."""
    used: float
    """The scale by which the values are judged."""


class CommonErrorResultScale(TypedDict):
    """They are so many times as large as they should be, less one: 0.031 is 3.1 % too large."""

    scale: float


class CommonErrorResultZero(TypedDict):
    """They are so many millimetres of paper too long."""

    zero: float


#: An error that all measured lengths have in common.
CommonErrorResult = Union[CommonErrorResultScale, CommonErrorResultZero]


class Awarded(TypedDict):
    """The marks that somebody's values earn."""

    earned: float
    """Marks earned."""
    of: float
    """Marks that could be earned."""
    follow_through: float
    """Those of the earned ones that are for values which follow from an earlier mistake."""


class CheckResult(TypedDict):
    """Verdicts and diagnosis of one drawing."""

    kinegon_check: int
    """Version of the format."""
    name: NotRequired[str]
    """Whose drawing it is."""
    passed: bool
    """Whether all that the scene asks for is there and right: nothing off, missing, without a sense or without information, no plan mirrored."""
    values: list[ValueResult]
    """The values in the order of the construction."""
    diagnosis: ExplanationResult
    """What explains them best."""
    others: list[ExplanationResult]
    """What explains them, too."""
    unexplained: list[str]
    """Values that nothing explains."""
    accuracy: NotRequired[AccuracyResult]
    """How accurate the drawing is, as the scatter of all values shows; not there where too few values are drawn."""
    mirrored: NotRequired[list[str]]
    """Plans whose places on paper are the mirror image of the right ones: "velocity", "acceleration"."""
    turned: NotRequired[list[TurnedResult]]
    """Plans whose places on paper lie turned to the scheme, with all of the sheet; directions are judged without that."""
    missing: NotRequired[list[str]]
    """What the scene asks for, by its `form` or else by all its steps, and the form has no value of."""
    values_of: NotRequired[str]
    """The exercise of the class whose values these are, where they are those of another one."""
    scales: NotRequired[list[ScaleResult]]
    """Scales of the form that are not those asked for, or at which no sheet can be drawn."""
    common: NotRequired[CommonErrorResult]
    """An error that all measured lengths have in common, taken out of the values: `{ "scale": 0.031 }` where they are 3.1 % too large, `{ "zero": 2 }` where they are 2 mm too long."""
    hints: NotRequired[int]
    """How many stages of hints the student opened in the workbench."""
    marks: NotRequired[Awarded]
    """The marks that the values earn, where a marking scheme is given."""


class KeyScales(TypedDict):
    """Scales, in units of the scene per millimetre of paper."""

    mu_l: NotRequired[float]
    """Of the scheme."""
    mu_v: NotRequired[float]
    """Of the velocity plan."""
    mu_a: NotRequired[float]
    """Of the acceleration plan."""
    mu_c: NotRequired[float]
    """Of the figure of instant centres."""
    mu_f: NotRequired[float]
    """Of the force plan."""
    mu_h: NotRequired[float]
    """Of the lever."""
    mu_k: NotRequired[float]
    """Of the speed diagram."""


class KeyValue(TypedDict):
    """The value of a quantity."""

    value: float
    """The exact value."""
    unit: str
    """Its unit."""
    allowed: NotRequired[float]
    """By how much the value of a careful hand may differ, as `kinegon check` judges it; not there for what is given. A check allows half a unit of the last digit more, in which the value is written."""
    step: int
    """The number of the step that gives it."""


class Key(TypedDict):
    """The values of an exercise."""

    kinegon_key: int
    """Version of the format."""
    title: NotRequired[str]
    """The title of the scene."""
    scales: KeyScales
    """The scales of the sheets."""
    values: dict[str, KeyValue]
    """The values by the names of their quantities, in the order of the form."""


class FigureKeys(TypedDict, total=False):
    """Keys of a figure as keywords, but its style; None takes one out."""

    panels: Sequence[Panel] | None
    """The panels, in order; left out: the scheme and both plans."""
    mu_l: float | None
    """Scale of the scheme: units of length per millimetre of paper."""
    mu_v: float | None
    """Scale of the velocity plan: units of velocity per millimetre of paper."""
    mu_a: float | None
    """Scale of the acceleration plan: units of acceleration per millimetre of paper."""
    mu_c: float | None
    """Scale of the figure of instant centres: units of length per millimetre of paper."""
    mu_f: float | None
    """Scale of the force plan: units of force per millimetre of paper."""
    mu_h: float | None
    """Scale of the lever: units of velocity per millimetre of paper."""
    mu_k: float | None
    """Scale of the speed diagram: units of length per millimetre of paper."""
    scales: ScalesFor | None
    """For which plans scales are chosen that are not given; left out: "position"."""
    focus: Panel | None
    """The panel that takes most of the sheet; a plan has the scheme as a small companion. Left out: the panels share the sheet."""
    page: Literal["a4", "a4-landscape", "a4-portrait", "a3", "a3-landscape", "a3-portrait", "letter", "letter-landscape", "letter-portrait", "16x9", "16x9-landscape", "16x9-portrait"] | None
    """The sheet: "a4", "a3", "letter" or, for the projector, "16x9", with "-portrait" where it does not lie; left out: "a4"."""
    worksheet: bool | None
    """Whether it is a work sheet: with a table of all measured lengths and a ruler to test the printer; left out: false."""
    willis: bool | None
    """Whether Willis' table of the trains of wheels stands beside the panels; not on a work sheet. Left out: false."""
    notation: Notation | None
    """How poles, images and parts of accelerations are written; left out: "paper". Names of quantities stay the same."""
    sliding: Sliding | None
    """How motions along guides are written: "slider" as v_r(3/2), "points" as v_B3B2; left out: "slider"."""
    coriolis: Coriolis | None
    """The index of Coriolis accelerations; left out: that of the notation."""
    center_letter: Center | None
    """How instant centres are written: P_13, I_13 or CIR_13; left out: "P"."""
    frame: Frame | None
    """The number that the frame is called by, unless `labels` has a text for `ground`; left out: a word."""
    turned: Turned | None
    """The sense in which figures and steps show the velocity plan turned by 90°; sheets to be drawn on, keys and checks have it as it is. Left out: not turned."""
    language: Language | None
    """Language of headings and captions; left out: "en"."""
    decimal: Decimal | None
    """Decimal mark of the numbers on figures and in the text of steps; left out: "point"."""
    labels: Mapping[str, str] | None
    """Text to show in place of a name: { "B'": "B₁" }."""
    special_points: bool | None
    """Whether special points are shown; left out: true."""
    construction: Construction | None
    """Whether construction lines are shown; "paper": shown, and the plans end where the source paper's end; left out: true."""
    values: Values | None
    """Whether values stand at vectors and links, in which unit of length; left out: as the style says, "lecture" alone does."""
    step: int | None
    """The step of the construction up to which the figure is drawn, from 1; left out: finished."""
    trace: Sequence[str] | None
    """Points of links whose paths over the whole cycle of the drive are drawn in the scheme."""
    beyond_limits: bool | None
    """Whether these paths go on, dashed, beyond limits of the drive, in the other assembly modes that the mechanism reaches there if another link moves it; left out: false."""
    centrodes: Sequence[str] | None
    """Links whose centrodes over that cycle are drawn in the scheme: the curves of the instant centre of the link and the frame, in the frame and in the link."""
    inflection: Sequence[str] | None
    """Links whose inflection circles are drawn in the scheme, through instant centre and inflection pole."""
    ghosts: int | None
    """Number of equally spaced positions over that cycle in which the links are drawn pale; left out: none."""
    centers: Centers | None
    """The instant centres on the panel "centers", besides those that lead to them: "all", or a list of names, as ["P(2,ground)"]. Left out: all of a mechanism with at most four links, of a larger one those of all links with the frame."""
    velocities: Sequence[str] | None
    """Points of links whose velocities that panel shows, found by centres from the one drive."""
    curvature: Sequence[str] | None
    """Points of links for whose paths that panel shows the centres of curvature, by Bobillier's construction."""
    markers: bool | None
    """Whether sheets to be drawn on, work sheets and those of exercises, have markers along their edges by which a photograph of them is read; left out: true."""


class FigureOptions(FigureKeys, total=False):
    """Keys of a figure as keywords; None takes one out."""

    style: StyleName | None
    """How lines and letters look; left out: "paper"."""
