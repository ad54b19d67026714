//! Instant centres by Kennedy's lines, with ruler and pencil: from the places of joints and guides alone, so that no rate enters. That makes
//! them a second route beside the centres of the computed motion, with which they are compared.
//!
//! In reading order: `order` (which lines, and how few), `chain` (where they cross, and what is done where they do not suffice), `draw`, which
//! writes the operations and steps, `velocity` (angular velocities and velocities by distances of centres), `curvature` (centres of curvature of paths), `inflection` (inflection poles), `symbol` and `told` (symbols, captions and equations).

pub mod chain;
mod curvature;
mod draw;
mod inflection;
pub mod order;
mod symbol;
mod told;
mod velocity;

pub use curvature::{Curvature, CurvatureStep, KnownRay, PoleTangent};
pub use draw::MOST_LINKS;
pub use inflection::Inflection;
pub use symbol::missing_of_centers;
pub use velocity::{CenterVelocity, Push};

use super::constructed::Agreement;
use super::operation::{Along, LineId, PlaceId};
use crate::centers::LinkPair;
use crate::geometry::Place;
use crate::mechanism::{BodyId, Mechanism, PointId, SliderId};

/// Index of a centre among [`Centers::all`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct CenterId(pub usize);

/// The instant centres that a figure shows, and how they are found.
#[derive(Clone, Debug, Default)]
pub struct Centers {
    /// The centres: first the permanent ones, then each after those it needs.
    pub all: Vec<Center>,
    /// The centres that the figure asks for.
    pub wanted: Vec<LinkPair>,
    /// The links of the circle diagram, the frame first.
    pub links: Vec<BodyId>,
    /// The centres that were asked for and that no lines lead to, with their places by the computed motion; none where the links are at rest on
    /// one another.
    pub by_rates: Vec<(LinkPair, Option<Place>)>,
    /// How the centres that lines lead to agree with those of the motion, in parts of the mechanism's size, or of the distance of
    /// those that are farther away; none without such a centre.
    pub agreement: Option<Agreement>,
    /// Velocities by centres.
    pub velocities: Vec<CenterVelocity>,
    /// The points whose velocities were asked for and do not follow from centres.
    pub without_velocity: Vec<PointId>,
    /// Whether it has more than [`MOST_LINKS`], of which no lines are sought.
    pub is_too_large: bool,
    /// Pole tangents of links, from which centres of curvature follow.
    pub tangents: Vec<PoleTangent>,
    /// Centres of curvature of the paths of points.
    pub curvatures: Vec<Curvature>,
    /// Inflection poles.
    pub inflections: Vec<Inflection>,
    /// The points for whose paths they were asked for and cannot be drawn.
    pub without_curvature: Vec<PointId>,
}

/// An instant centre on the sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Center {
    /// Its name among the places of the sheet: `P(1,3)`, and `P(1,3)'` of a centre without a link.
    pub name: String,
    /// The two links.
    pub pair: LinkPair,
    /// Where it comes from.
    pub origin: CenterOrigin,
    /// Of which figure it is the centre.
    pub figure: FigureOf,
    /// What is drawn of it.
    pub spot: Spot,
    /// Its place, in the scene's unit of length.
    pub place: Place,
}

/// What is drawn of a centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spot {
    /// A place on the sheet.
    At(PlaceId),
    /// Lines towards it: it is at infinity.
    Towards(Along),
}

/// Where a centre comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum CenterOrigin {
    /// A pin of both links, which is permanent.
    Pin(PointId),
    /// A guide: at infinity in every position, normal to the guide.
    Guide(SliderId),
    /// The crossing of two lines.
    Lines {
        /// The lines.
        lines: [CenterLine; 2],
        /// The sine of the angle between them: 0 where they are parallel, 1 where one is the line at infinity.
        sine: f64,
    },
}

/// A line on which a centre lies.
#[derive(Clone, Debug, PartialEq)]
pub struct CenterLine {
    /// The third link; none for the line of two places that the centre has without a link.
    pub over: Option<BodyId>,
    /// The centres that it runs through.
    pub through: [CenterId; 2],
    /// The line; none for that at infinity.
    pub line: Option<LineId>,
}

/// Of which figure a centre is one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FigureOf {
    /// Of the mechanism.
    Mechanism,
    /// Of the mechanism without a link, and with two neighbours glued together.
    Glued {
        /// The link that is left out.
        without: BodyId,
        /// The neighbours that are one link.
        together: LinkPair,
        /// Whether it is the second such figure for the centre.
        is_second: bool,
    },
}

impl Center {
    /// Whether it is a centre in every position.
    #[must_use]
    pub fn is_permanent(&self) -> bool {
        !matches!(self.origin, CenterOrigin::Lines { .. })
    }

    /// Names of the quantities that its place gives, where it is a centre of the mechanism itself that lines lead to: its coordinates, at infinity its direction.
    #[must_use]
    pub fn quantities(&self) -> Vec<String> {
        let axes = match self.place {
            _ if self.is_permanent() || self.figure != FigureOf::Mechanism => &[][..],
            Place::At(_) => &["x", "y"],
            Place::AtInfinity(_) => &["angle"],
        };
        axes.iter().map(|axis| format!("{}.{axis}", self.name)).collect()
    }

    /// Its lines; none of a permanent one.
    #[must_use]
    pub fn lines(&self) -> &[CenterLine] {
        match &self.origin {
            CenterOrigin::Lines { lines, .. } => lines,
            _ => &[],
        }
    }
}

impl FigureOf {
    /// How many primes follow a centre's symbol: one without a link is no centre of the mechanism.
    #[must_use]
    pub fn primes(self) -> usize {
        match self {
            FigureOf::Mechanism => 0,
            FigureOf::Glued { is_second, .. } => 1 + usize::from(is_second),
        }
    }

    /// The name of the centre of a pair of links in this figure.
    pub(super) fn center_name(self, pair: LinkPair, mechanism: &Mechanism) -> String {
        format!("{}{}", pair.name(mechanism), "'".repeat(self.primes()))
    }
}

impl Centers {
    /// A centre of the mechanism itself.
    #[must_use]
    pub fn of(&self, pair: LinkPair) -> Option<CenterId> {
        let is_it = |center: &Center| center.pair == pair && center.figure == FigureOf::Mechanism;
        self.all.iter().position(is_it).map(CenterId)
    }

    /// Whether a centre of the mechanism is found without these links.
    pub(super) fn is_without(&self, id: CenterId, links: &[BodyId]) -> bool {
        let center = self.get(id);
        center.figure == FigureOf::Mechanism
            && center.pair.links().iter().all(|link| !links.contains(link))
            && center.lines().iter().all(|line| {
                line.over.is_some_and(|over| !links.contains(&over))
                    && line.through.iter().all(|through| self.is_without(*through, links))
            })
    }

    /// The centre of that index.
    #[must_use]
    pub fn get(&self, id: CenterId) -> &Center {
        &self.all[id.0]
    }
}
