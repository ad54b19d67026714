/// A mistake of the catalogue.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Mistake {
    /// A ray drawn parallel in place of perpendicular, or the other way round.
    TurnedRay,
    /// A cut line drawn along the guide in place of normal to it.
    TurnedCutLine,
    /// A ray drawn from the wrong plan point.
    RayFromWrongPoint,
    /// A special point taken from the wrong pair of lines.
    WrongLines,
    /// A vector laid off reversed.
    ReversedVector,
    /// A vector laid off in another direction: across, or off by an angle as from a misread protractor.
    TurnedVector,
    /// A normal part or a Coriolis acceleration laid off from the wrong point.
    VectorFromWrongPoint,
    /// A normal acceleration that points outward.
    NormalOutward,
    /// A normal part with ω in place of ω².
    OmegaNotSquared,
    /// The ω of another link in a normal part or a Coriolis acceleration.
    OmegaOfAnotherLink,
    /// A normal part, or all products of a crank, with the diameter in place of the radius.
    Diameter,
    /// All products of a crank with half its radius.
    HalfTheRadius,
    /// A normal part from an absolute velocity, or from that of another link.
    NormalFromAbsolute,
    /// A normal part forgotten.
    NormalForgotten,
    /// A tangential part of a crank that turns evenly.
    TangentialWhereNone,
    /// The Coriolis part forgotten.
    CoriolisForgotten,
    /// The Coriolis part without its 2.
    CoriolisWithoutTwo,
    /// The Coriolis part turned the wrong way.
    CoriolisTurned,
    /// The Coriolis part laid off along the guide.
    CoriolisAlong,
    /// The Coriolis part with another velocity than the sliding one.
    CoriolisVelocity,
    /// A Coriolis part where nothing slides.
    CoriolisWhereNone,
    /// A Coriolis part at a guide that is at rest.
    CoriolisAtRest,
    /// The image of a link mirrored.
    MirroredImage,
    /// The line between two images divided from its wrong end.
    WrongRatio,
    /// A segment measured from the wrong point.
    WrongSegment,
    /// A component taken for a length.
    Component,
    /// A wrong length, once or throughout.
    WrongLength,
    /// An angular velocity found with another link's length.
    OmegaFromWrongLength,
    /// An angular acceleration found with another link's length.
    AlphaFromWrongLength,
    /// A rate of rotation without division by the length.
    NotDividedByLength,
    /// A rate taken with the wrong sense.
    WrongSense,
    /// All rates of rotation written with the wrong sense.
    SensesReversed,
    /// Revolutions per minute taken for radians per second, or the other way round.
    RevolutionsForRadians,
    /// Revolutions per second taken for radians per second, or the other way round.
    RevolutionsPerSecond,
    /// Degrees taken for radians, or the other way round.
    DegreesForRadians,
    /// A segment taken with the wrong scale.
    WrongScale,
    /// The other assembly mode.
    OtherMode,
    /// The mechanism drawn at another angle of its crank.
    CrankAngle,
    /// Two numbers swapped.
    Swapped,
    /// Digits transposed.
    DigitsTransposed,
    /// A decimal slipped.
    DecimalSlipped,
    /// All values cut off in place of rounded.
    Truncated,
    /// The wrong unit written beside a value.
    WrongUnit,
    /// A value in another unit of length than the scene's, and no unit beside it.
    OtherUnit,
    /// A value wrong for a reason that the catalogue does not know, and used in later operations.
    Unknown,
}
