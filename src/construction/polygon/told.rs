//! What is said of the force plan: symbols, captions and equations.

use super::{ForceOf, ForcePart, ForceStep, Found, Moment, MomentPoint, Polygon, Side, SideKind};
use crate::construction::markup::{Formula, Known, display};
use crate::construction::sentence::Teller;
use crate::construction::step::Action;
use crate::forces::Source;
use crate::geometry::Vector;
use crate::mechanism::{BodyId, SliderId};
use crate::sheet::{QuantityKind, Sheet};

impl Teller<'_> {
    /// The symbol of a force in markup: `R_{12}` of link 1 on link 2, `N_{03}` of a guide, `G_{2}` of a weight.
    #[must_use]
    pub fn force_symbol(&self, of: ForceOf) -> String {
        match of {
            ForceOf::Load(index) => {
                let load = self.construction.forces.as_ref().and_then(|plan| plan.loads.get(index));
                load.map_or_else(String::new, |load| self.load_symbol(load.source, load.body))
            }
            ForceOf::Both { joints: [outer, inner], on } => {
                let joint = self.mechanism.joint(inner);
                // The inner guide may hold another link of those that are cut free.
                let other = self.mechanism.lead(on);
                let inner_on = joint.bodies.into_iter().find(|body| self.mechanism.lead(*body) == other);
                let inner_on = inner_on.unwrap_or(joint.bodies[1]);
                let across = ForceOf::Joint { joint: outer, on, part: ForcePart::AcrossGuide };
                let normal = ForceOf::Joint { joint: inner, on: inner_on, part: ForcePart::Whole };
                format!("{} + {}", self.force_symbol(across), self.force_symbol(normal))
            }
            ForceOf::Joint { joint, on, part } => {
                let joint = self.mechanism.joint(joint);
                let by = joint.bodies.into_iter().find(|body| *body != on).unwrap_or(on);
                let letter = match (joint.rolls(), joint.slider.is_some()) {
                    (true, _) => "W",
                    (_, true) => "N",
                    _ => "R",
                };
                let letter = match joint.slider.map(|slider| self.mechanism.slider(slider).drive.is_some()) {
                    Some(true) => "R",
                    _ => letter,
                };
                let notation = &self.words.notation;
                let upper = match part {
                    ForcePart::Whole => String::new(),
                    // Of a guide nothing else is a force.
                    ForcePart::Normal if letter == "N" => String::new(),
                    // Across the tangent, as its pressure angle has it.
                    ForcePart::Normal if letter == "W" => "^{r}".to_owned(),
                    ForcePart::Normal => format!("^{{{}}}", notation.normal),
                    ForcePart::Tangential => format!("^{{{}}}", notation.tangential),
                    ForcePart::AlongGuide => "^{∥}".to_owned(),
                    ForcePart::AcrossGuide => "^{⊥}".to_owned(),
                };
                format!("{letter}{upper}{}", self.pair(by, on))
            }
        }
    }

    fn pair(&self, by: BodyId, on: BodyId) -> String {
        let names = [by, on].map(|link| self.link_in_symbol(link));
        let is_long = names.iter().any(|name| name.chars().count() > 1);
        format!("_{{{}}}", names.join(if is_long { "," } else { "" }))
    }

    /// The symbol of a load: of its force, or of a couple that stands alone.
    #[must_use]
    pub fn load_symbol(&self, source: Source, body: BodyId) -> String {
        let link = self.link_in_symbol(body);
        let loads = self.mechanism.loads.as_ref().map(|loads| &loads.0);
        match source {
            Source::Weight => format!("{}_{{{link}}}", self.words.language.weight_letter()),
            Source::Inertia => format!("F_{{i{link}}}"),
            Source::Given(index) => loads.map_or_else(String::new, |loads| display(&loads.loads[index].name)),
            Source::Spring(index) => loads.map_or_else(String::new, |loads| display(&loads.springs[index].name)),
            Source::Friction(joint) => {
                let by = self.mechanism.rubbing_bodies(joint).into_iter().find(|by| *by != body).unwrap_or(body);
                let letter = if self.mechanism.joint(joint).pin.is_some() { "M" } else { "F" };
                format!("{letter}^{{f}}{}", self.pair(by, body))
            }
        }
    }

    /// Links in words, as `links 2, 3`; the blocks of pins in slots have no name.
    #[must_use]
    pub fn links_in_words(&self, links: &[BodyId]) -> String {
        let named = links.iter().filter(|link| !self.mechanism.body(**link).is_nameless());
        let names: Vec<String> = named.map(|link| self.link_in_symbol(*link)).collect();
        let language = self.words.language;
        match names.as_slice() {
            [one] => language.one_link(one),
            _ => language.several_links(&names.join(", ")),
        }
    }

    fn side(&self, polygon: usize, side: usize) -> Option<(&Polygon, &Side)> {
        let polygon = self.construction.forces.as_ref()?.polygons.get(polygon)?;
        Some((polygon, polygon.sides.get(side)?))
    }

    fn moment(&self, index: usize) -> Option<&Moment> {
        self.construction.forces.as_ref()?.moments.get(index)
    }

    /// The symbol of a load's couple: `M_{i2}` of inertia, else its own name.
    #[must_use]
    pub fn couple_symbol(&self, source: Source, body: BodyId) -> String {
        match source {
            Source::Inertia => format!("M_{{i{}}}", self.link_in_symbol(body)),
            _ => self.load_symbol(source, body),
        }
    }

    /// The symbol of the torque of a driven link.
    #[must_use]
    pub fn torque_symbol(&self, link: BodyId) -> String {
        format!("T_{{{}}}", self.link_in_symbol(link))
    }

    /// The symbol of the couple in a guide, about the slider's point on the sliding link.
    #[must_use]
    pub fn guide_couple(&self, slider: SliderId) -> String {
        let slider = self.mechanism.slider(slider);
        format!("M{}", self.pair(slider.on, slider.link))
    }

    /// The symbol of the force across a guide, on the sliding link.
    #[must_use]
    pub fn guide_symbol(&self, slider: SliderId) -> String {
        let slider = self.mechanism.slider(slider);
        format!("N{}", self.pair(slider.on, slider.link))
    }

    /// The symbol of its distance from the slider's point.
    #[must_use]
    pub fn guide_arm(&self, slider: SliderId) -> String {
        let slider = self.mechanism.slider(slider);
        format!("h{}", self.pair(slider.on, slider.link))
    }

    /// The symbol of the drive's force along a guide.
    #[must_use]
    pub fn push_symbol(&self, slider: SliderId) -> String {
        let slider = self.mechanism.slider(slider);
        format!("F{}", self.pair(slider.on, slider.link))
    }

    fn found(&self, found: Found) -> String {
        match found {
            Found::Force(of) => self.force_symbol(of),
            Found::Couple(slider) | Found::CoupleAbout(slider, _) => self.guide_couple(slider),
            Found::Torque(link) => self.torque_symbol(link),
        }
    }

    fn moments(&self, moment: &Moment) -> String {
        let (language, links, found) =
            (self.words.language, self.links_in_words(&moment.links), self.found(moment.finds));
        match (moment.about, moment.finds) {
            (MomentPoint::Joint(point), Found::Couple(slider)) => {
                let point = display(self.mechanism.point_name(point));
                language.force_couple(&links, &point, &found, &self.slider_name(slider))
            }
            (MomentPoint::Joint(point), _) => {
                language.force_moments(&links, &display(self.mechanism.point_name(point)), &found)
            }
            (MomentPoint::Crossing(lines), _) => {
                let [a, b] = lines.map(|of| self.force_symbol(of));
                language.force_moments_crossing(&links, &a, &b, &found)
            }
        }
    }

    /// The caption of a step of the force plan; none for other steps.
    pub(in crate::construction) fn caption_of_forces(&self, action: &Action) -> Option<String> {
        let Action::Force(step) = action else { return None };
        let language = self.words.language;
        Some(match step {
            ForceStep::Moments(index) => self.moments(self.moment(*index)?),
            ForceStep::LayOff(polygon, side) => {
                let (of, own) = self.side(*polygon, *side)?;
                let force = self.force_symbol(own.of);
                match side {
                    0 => language.force_begin(
                        &self.links_in_words(&of.links),
                        Sheet::Forces.facts().scale_symbol,
                        &force,
                    ),
                    _ => language.force_lay_off(&force),
                }
            }
            ForceStep::Direction(polygon, side) => {
                language.force_direction(&self.force_symbol(self.side(*polygon, *side)?.1.of))
            }
            ForceStep::Cross(polygon, side) => {
                let [a, b] = [side, &(side + 1)].map(|side| self.side(*polygon, *side));
                language.force_cross(&self.force_symbol(a?.1.of), &self.force_symbol(b?.1.of))
            }
            ForceStep::Close(polygon, side) => {
                language.force_close(&self.force_symbol(self.side(*polygon, *side)?.1.of))
            }
            ForceStep::Join(polygon, side) => {
                let (of, side) = self.side(*polygon, *side)?;
                let force = self.force_symbol(side.of);
                match self.has_parts(of, side) {
                    true => language.force_sum(&force),
                    false => language.force_inner(&force, &self.links_in_words(&[side.on])),
                }
            }
            ForceStep::Push(slider, _) => language.force_push(&self.slider_name(*slider), &self.push_symbol(*slider)),
            ForceStep::ByNumbers(links) => language.forces_by_numbers(&self.links_in_words(links)),
        })
    }

    /// Whether parts of a force are sides of its polygon.
    fn has_parts(&self, polygon: &Polygon, of: &Side) -> bool {
        let is_part = |side: &Side| match (side.of, of.of) {
            (ForceOf::Joint { joint, part, .. }, ForceOf::Joint { joint: own, .. }) => {
                joint == own && part != ForcePart::Whole
            }
            _ => false,
        };
        polygon.sides.iter().any(is_part)
    }

    /// The equation of such a step.
    pub(in crate::construction) fn formula_of_forces(&self, action: &Action) -> Option<Formula> {
        let Action::Force(step) = action else { return None };
        Some(match step {
            ForceStep::Moments(index) => {
                let moment = self.moment(*index)?;
                let point = match moment.about {
                    MomentPoint::Joint(point) => self.mechanism.point_name(point),
                    MomentPoint::Crossing(_) => "S",
                };
                format!("Σ M_{{{point}}} = 0 :  {}", self.found(moment.finds)).into()
            }
            ForceStep::LayOff(polygon, side) | ForceStep::Join(polygon, side) => {
                let of = self.side(*polygon, *side)?.1.of;
                format!("{}{}", self.force_symbol(of), self.coulomb(of).unwrap_or_default()).into()
            }
            ForceStep::Direction(polygon, _) | ForceStep::Cross(polygon, _) => self.polygon_equation(*polygon)?,
            ForceStep::Close(polygon, side) => {
                let mut formula = self.polygon_equation(*polygon)?;
                formula.sign(&format!(",   {}", self.force_symbol(self.side(*polygon, *side)?.1.of)));
                formula
            }
            ForceStep::Push(slider, _) => self.push_symbol(*slider).into(),
            ForceStep::ByNumbers(_) => Formula::default(),
        })
    }

    /// What the friction along a guide is: the coefficient times the force across.
    fn coulomb(&self, of: ForceOf) -> Option<String> {
        let ForceOf::Load(index) = of else { return None };
        let load = self.construction.forces.as_ref()?.loads.get(index)?;
        let Source::Friction(joint) = load.source else { return None };
        let normal = ForceOf::Joint { joint, on: load.body, part: ForcePart::Normal };
        Some(format!(" = μ |{}|", self.force_symbol(normal)))
    }

    /// The equation of a polygon, in the order of its sides: those that are known underlined twice, known directions once.
    #[must_use]
    pub fn polygon_equation(&self, polygon: usize) -> Option<Formula> {
        let polygon = self.construction.forces.as_ref()?.polygons.get(polygon)?;
        let of_kind = |kind: SideKind| polygon.sides.iter().filter(move |side| side.kind == kind);
        let found: Vec<&Side> = of_kind(SideKind::Found).collect();
        let (before, after) = if found.len() == 2 { (&found[..1], &found[1..]) } else { (&found[..0], &found[..]) };
        let known = if found.len() == 2 { Known::Direction } else { Known::Nothing };
        let all = before.iter().map(|side| (*side, known));
        let all = all.chain(of_kind(SideKind::Known).map(|side| (side, Known::Entirely)));
        let mut formula = Formula::default();
        for (index, (side, known)) in all.chain(after.iter().map(|side| (*side, known))).enumerate() {
            if index > 0 {
                formula.sign(" + ");
            }
            formula.vector(self.force_symbol(side.of), known, None);
        }
        formula.sign(" = 0");
        Some(formula)
    }

    /// The caption of the steps by which a polygon is drawn.
    pub(in crate::construction) fn polygon_caption(&self, steps: &[&Action]) -> Option<String> {
        let index = steps.iter().find_map(|action| action.polygon())?;
        let plan = self.construction.forces.as_ref()?;
        let polygon = plan.polygons.get(index)?;
        let language = self.words.language;
        let symbols = |kind: SideKind| {
            let sides = polygon.sides.iter().filter(|side| side.kind == kind);
            sides.map(|side| self.force_symbol(side.of)).collect::<Vec<_>>().join(", ")
        };
        let [known, found, joined] = [SideKind::Known, SideKind::Found, SideKind::Diagonal].map(symbols);
        let mut said = vec![language.force_polygon(&self.links_in_words(&polygon.links), &known)];
        if !found.is_empty() {
            said.push(language.force_polygon_closed(&found));
        }
        if !joined.is_empty() {
            said.push(language.force_polygon_joined(&joined));
        }
        Some(said.join(" "))
    }

    /// The force that such a step shows.
    #[must_use]
    pub fn force_of_step(&self, action: &Action) -> Option<Vector> {
        match action {
            Action::Force(
                ForceStep::LayOff(polygon, side) | ForceStep::Join(polygon, side) | ForceStep::Close(polygon, side),
            ) => Some(self.side(*polygon, *side)?.1.vector),
            _ => None,
        }
    }

    /// The number that such a step finds, and its kind.
    #[must_use]
    pub fn value_of_forces(&self, action: &Action) -> Option<(f64, QuantityKind)> {
        match action {
            Action::Force(ForceStep::Moments(index)) => {
                let moment = self.moment(*index)?;
                let kind = match moment.finds {
                    Found::Force(_) => QuantityKind::Force,
                    _ => QuantityKind::Moment,
                };
                Some((moment.value, kind))
            }
            Action::Force(ForceStep::Push(_, value)) => Some((*value, QuantityKind::Force)),
            _ => None,
        }
    }
}

impl Action {
    /// The polygon to which a step of the force plan belongs.
    pub(in crate::construction) fn polygon(&self) -> Option<usize> {
        match self {
            Action::Force(
                ForceStep::LayOff(polygon, _)
                | ForceStep::Direction(polygon, _)
                | ForceStep::Cross(polygon, _)
                | ForceStep::Close(polygon, _)
                | ForceStep::Join(polygon, _),
            ) => Some(*polygon),
            _ => None,
        }
    }
}
