use super::force_name::{ForceOf, LinePart, LoadOf};
use super::name::{AccelerationPart, Pole, PoleOf, QuantityRequest, Spot, What};
use super::ways::Corners;
use crate::construction::{Construction, Rate};
use crate::geometry::{with_turns, without_sense};
use crate::mechanism::Mechanism;
use crate::scene::Component;
use crate::sheet::{Order, QuantityKind, Sheet};
use crate::words::{Notation, SlidePart, SlideSymbol};

/// The parts of a symbol: letter, upper and lower index, text behind them.
struct Symbol {
    letter: &'static str,
    upper: &'static str,
    lower: String,
    after: String,
}

impl QuantityRequest {
    /// The kind of its value; a vector's size and components are of the vector's kind, its angle is an angle.
    #[must_use]
    pub fn kind(&self) -> QuantityKind {
        self.written.kind()
    }

    /// Whether its value is a vector.
    #[must_use]
    pub fn is_vector(&self) -> bool {
        self.written.component.is_none() && self.is_of_vectors()
    }

    pub(super) fn is_of_vectors(&self) -> bool {
        matches!(self.what, What::Coriolis(..) | What::Motion(..) | What::Part(..) | What::Pole(_))
            || matches!(&self.what, What::Force(of, _) if of.is_vector())
    }

    /// Whether it is a place: a vector without a size.
    #[must_use]
    pub fn is_place(&self) -> bool {
        matches!(self.what, What::Pole(_))
    }

    /// Whether it can be evaluated without the places and motions of points.
    #[must_use]
    pub fn is_of_links_alone(&self) -> bool {
        self.is_rate() || matches!(self.what, What::Angle(_) | What::Coriolis(..) | What::SlidePosition(_))
    }

    /// Whether special points or plans are needed to evaluate it.
    #[must_use]
    pub fn needs_construction(&self) -> bool {
        let special = |spot: &Spot| matches!(spot, Spot::Special(_));
        match &self.what {
            What::Segment(..) => true,
            What::Corners(corners) => corners.way.is_none(),
            What::Coordinate(_, spot) | What::PathRadius(spot) => special(spot),
            What::Length(a, b) | What::Part(_, a, b, _) => special(a) || special(b),
            What::Motion(_, a, b) => special(a) || b.as_ref().is_some_and(special),
            What::Force(of, _) => of.about().is_some_and(special),
            _ => false,
        }
    }

    /// The plan from which it is read; `None` where the scheme is enough.
    #[must_use]
    pub fn order(&self) -> Option<Order> {
        match &self.what {
            What::Rate(rate) => Some(rate.order()),
            What::RelativeRate(order, _) => Some(*order),
            What::SpeedRatio(_) | What::Rpm(..) => Some(Order::Velocity),
            What::Motion(order, ..) | What::Segment(order, _) => Some(*order),
            What::Part(..) | What::Coriolis(..) => Some(Order::Acceleration),
            What::Angle(_)
            | What::SlidePosition(_)
            | What::Coordinate(..)
            | What::Length(..)
            | What::Pole(_)
            | What::InflectionDiameter(_)
            | What::PathRadius(_)
            | What::Corners(_)
            | What::Force(..) => None,
        }
    }

    /// The sheet from which it is read, where the figure has its plan.
    #[must_use]
    pub fn sheet(&self) -> Sheet {
        match &self.what {
            What::Pole(_)
            | What::InflectionDiameter(_)
            | What::Length(Spot::Pole(_), _)
            | What::Length(_, Spot::Pole(_)) => Sheet::Centers,
            What::Force(ForceOf::Power(_), _) => Sheet::Lever,
            What::Force(ForceOf::Arm(..), _) => Sheet::Scheme,
            What::Force(..) | What::Corners(_) => Sheet::Forces,
            _ => self.order().map_or(Sheet::Scheme, Order::sheet),
        }
    }

    /// The sheet from which it is read where a hand draws: rates and velocities without a plan are found by instant centres.
    #[must_use]
    pub fn sheet_by_hand(&self, construction: &Construction) -> Sheet {
        let own = self.sheet();
        if own == Sheet::Forces {
            return if construction.by_hand.contains(&own) { own } else { Sheet::Lever };
        }
        let has_plan = own.order().is_none() || construction.by_hand.contains(&own);
        if has_plan { own } else { Sheet::Centers }
    }

    /// The instant centres in its name.
    pub(crate) fn centers(&self) -> impl Iterator<Item = &Pole> {
        let poles = match &self.what {
            What::Pole(pole) => [Some(pole), None],
            What::Length(a, b) => [a, b].map(|spot| match spot {
                Spot::Pole(pole) => Some(pole),
                _ => None,
            }),
            _ => [None, None],
        };
        poles.into_iter().flatten().filter(|pole| matches!(pole.of, PoleOf::Center(..)))
    }

    /// Whether it is a length on its sheet; rates are computed from lengths.
    #[must_use]
    pub fn is_length_on_sheet(&self) -> bool {
        !self.turns() && !self.is_rate() && !self.is_computed()
    }

    /// Whether it follows from what is measured on several sheets.
    fn is_computed(&self) -> bool {
        let is_offset = matches!(&self.what, What::Force(ForceOf::Offset(_), _));
        is_offset || matches!(self.kind(), QuantityKind::Moment | QuantityKind::Power)
    }

    /// Whether it is the distance of two places: a length of the scheme, an arm, or a segment of a plan.
    #[must_use]
    pub fn is_distance(&self) -> bool {
        let is_between = matches!(self.what, What::Segment(..) | What::Corners(_) | What::Length(..));
        (is_between && self.written.component.is_none()) || self.is_arm()
    }

    /// Whether it is a rate that is solved for or given, or follows from such rates alone: its sense is written as a sign, or not at all.
    #[must_use]
    pub fn is_rate(&self) -> bool {
        matches!(self.what, What::Rate(_) | What::RelativeRate(..) | What::SpeedRatio(_) | What::Rpm(..))
    }

    /// The rate of a link or a slider that it is.
    pub(crate) fn as_rate(&self) -> Option<Rate> {
        match self.what {
            What::Rate(rate) => Some(rate),
            _ => None,
        }
    }

    /// Whether it is an angle or an angular rate: its sign depends on the positive sense of rotation.
    #[must_use]
    pub fn turns(&self) -> bool {
        matches!(
            self.kind(),
            QuantityKind::Angle
                | QuantityKind::AngularVelocity
                | QuantityKind::AngularAcceleration
                | QuantityKind::RotationalSpeed
        )
    }

    /// Whether it is the direction of a line, which has no sense: of a centre at infinity.
    #[must_use]
    pub fn is_line(&self) -> bool {
        matches!(self.what, What::Pole(_)) && self.kind() == QuantityKind::Angle
    }

    /// A difference of two of its values: of angles the shorter way round.
    #[must_use]
    pub fn turned(&self, difference: f64) -> f64 {
        match self.kind() {
            QuantityKind::Angle if self.is_line() => without_sense(difference, 0.0),
            QuantityKind::Angle => with_turns(difference, 0.0),
            _ => difference,
        }
    }

    /// Whether it is the velocity of a joint, ω of a link or v_r of a slider, whose zeros are dead centres.
    #[must_use]
    pub fn has_dead_centres(&self) -> bool {
        matches!(self.what, What::Rate(rate) if rate.order() == Order::Velocity)
    }

    /// Its symbol in markup, as `ω_{4}`; of a vector that of its size, as `|v_{D}|`. `shown` gives the text for a name;
    /// segments of plans are written by the names of their ends.
    #[must_use]
    pub fn symbol(&self, mechanism: &Mechanism, notation: &Notation, shown: &dyn Fn(&str) -> String) -> String {
        let plain = |letter, lower: String| Symbol { letter, upper: "", lower, after: String::new() };
        let relative = |letter, upper, a: &str, b: Option<&str>| Symbol {
            upper,
            ..plain(letter, shown(a) + &b.map_or(String::new(), shown))
        };
        let is_along = |axis: Component| self.written.component == Some(axis);
        let link = |id| shown(&mechanism.body(id).name);
        let names = |id| mechanism.slider_shown(id, notation, shown);
        let slide = |order, part, id| {
            let SlideSymbol { letter, upper, lower, after } = notation.slide(order, part, &names(id));
            Symbol { letter, upper, lower, after }
        };
        let symbol = match &self.what {
            What::Rate(Rate::Angular(order, id)) => plain(order.rate(), link(*id)),
            What::Rate(Rate::Slide(order, id)) => slide(*order, SlidePart::Relative, *id),
            What::RelativeRate(order, links) => plain(order.rate(), links.map(link).join("/")),
            What::SpeedRatio(links) => plain("i", links.map(link).join(",")),
            What::Rpm(id, _) => plain("n", link(*id)),
            What::Angle(id) => plain("φ", link(*id)),
            What::SlidePosition(id) => Symbol { after: format!("({})", names(*id).pair), ..plain("s", String::new()) },
            What::Coriolis(id, _) => slide(Order::Acceleration, SlidePart::Coriolis, *id),
            What::Coordinate(0, spot) => plain("x", shown(spot.name())),
            What::Coordinate(_, spot) => plain("y", shown(spot.name())),
            What::Length(a, b) if self.sheet() == Sheet::Centers => {
                let end = |spot: &Spot| match spot {
                    Spot::Pole(Pole { of: PoleOf::Center(pair, _), .. }) => pair.symbol(0, mechanism, notation, shown),
                    _ => shown(spot.name()),
                };
                Symbol { after: format!("{} {}", end(a), end(b)), ..plain("", String::new()) }
            }
            What::Length(a, b) => relative("L", "", a.name(), Some(b.name())),
            What::Pole(Pole { of: PoleOf::Center(pair, _), .. }) => Symbol {
                after: String::new(),
                upper: "",
                letter: notation.center,
                lower: pair.index(mechanism, notation, shown),
            },
            What::Pole(Pole { of: PoleOf::Inflection(id), .. }) => plain("W", link(*id)),
            What::Pole(Pole { of: PoleOf::Acceleration(id), .. }) => plain("G", link(*id)),
            What::InflectionDiameter(pole) => {
                Symbol { after: format!("({})", link(pole.of.link())), ..plain("d", "i".to_owned()) }
            }
            What::PathRadius(spot) => plain("ρ", shown(spot.name())),
            What::Force(of, _) => {
                let at_pin = |pin, body| plain("R", format!("{},{}", shown(mechanism.point_name(pin)), link(body)));
                let load = |of: &LoadOf| shown(&of.name(mechanism));
                match of {
                    ForceOf::Reaction(pin, body) => at_pin(*pin, *body),
                    ForceOf::ReactionPart(part, pin, body, _) => {
                        let upper = match part {
                            LinePart::Along => notation.normal,
                            LinePart::Across => notation.tangential,
                        };
                        Symbol { upper, ..at_pin(*pin, *body) }
                    }
                    ForceOf::Normal(id) => plain("N", names(*id).pair),
                    ForceOf::Couple(id) => plain("M", names(*id).pair),
                    ForceOf::Offset(id) => plain("h", names(*id).pair),
                    ForceOf::Torque(id) => plain("T", link(*id)),
                    ForceOf::Push(id) => plain("F", names(*id).pair),
                    ForceOf::InertiaForce(id) => plain("F", format!("i{}", link(*id))),
                    ForceOf::InertiaCouple(id) => plain("M", format!("i{}", link(*id))),
                    ForceOf::Friction(id) => Symbol { upper: "f", ..plain("F", names(*id).pair) },
                    ForceOf::FrictionCouple(pin, body) => {
                        let below = format!("{},{}", shown(mechanism.point_name(*pin)), link(*body));
                        Symbol { upper: "f", ..plain("M", below) }
                    }
                    ForceOf::CenterAcceleration(id) => plain("a", format!("cm{}", link(*id))),
                    ForceOf::LoadMoment(of, about) => plain("M", format!("{},{}", load(of), shown(about.name()))),
                    ForceOf::Arm(..) => {
                        // An index has none of its own.
                        let names = self.written.arguments.iter().map(|name| shown(name).replace(['_', '{', '}'], ""));
                        plain("h", names.collect::<Vec<_>>().join(","))
                    }
                    ForceOf::Load(of) => Symbol { after: load(of), ..plain("", String::new()) },
                    ForceOf::Power(of) => plain("P", load(of)),
                    ForceOf::Shaking => plain("F", "s".to_owned()),
                    ForceOf::ShakingMoment(about) => plain("M", format!("s,{}", shown(about.name()))),
                }
            }
            What::Motion(order, a, b) => relative(order.vector(), "", a.name(), b.as_ref().map(|b| b.name())),
            What::Part(part, a, b, _) => {
                let part = match part {
                    AccelerationPart::Normal => notation.normal,
                    AccelerationPart::Tangential => notation.tangential,
                };
                relative("a", part, a.name(), Some(b.name()))
            }
            What::Corners(Corners { ends: [from, to], .. }) if is_along(Component::X) || is_along(Component::Y) => {
                let axis = if is_along(Component::X) { "x" } else { "y" };
                Symbol { after: format!("({} {})", shown(from), shown(to)), ..plain("F", axis.to_owned()) }
            }
            What::Segment(_, [from, to]) | What::Corners(Corners { ends: [from, to], .. })
                if self.written.component.is_some() =>
            {
                Symbol { after: format!("({} {})", shown(from), shown(to)), ..plain("", String::new()) }
            }
            What::Corners(Corners { ends: [from, to], .. }) => Symbol {
                after: format!(" ({} {})", shown(from), shown(to)),
                ..plain(Sheet::Forces.facts().scale_symbol, String::new())
            },
            What::Segment(order, [from, to]) => Symbol {
                after: format!(" ({} {})", shown(from), shown(to)),
                ..plain(order.sheet().facts().scale_symbol, String::new())
            },
        };
        let axis = match self.written.component {
            _ if matches!(self.what, What::Corners(_)) => "",
            Some(Component::X) => ",x",
            Some(Component::Y) => ",y",
            _ => "",
        };
        let (upper, lower) = (script('^', symbol.upper), script('_', &(symbol.lower + axis)));
        let written = format!("{}{upper}{lower}{}", symbol.letter, symbol.after);
        match self.written.component {
            Some(Component::Angle) => format!("∠{written}"),
            Some(Component::Size) => format!("|{written}|"),
            None if self.is_vector() && !self.is_place() => format!("|{written}|"),
            _ => written,
        }
    }
}

fn script(mark: char, text: &str) -> String {
    if text.is_empty() { String::new() } else { format!("{mark}{{{text}}}") }
}
