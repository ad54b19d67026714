//! What the layers of a sheet ask: the solution with what is looked up in it once, the surface on which the sheet is
//! laid out, and what the sheet is for.

use super::dims::Dims;
use super::facts::Facts;
use super::held_layout::Pane;
use super::speeds::SpeedScales;
use super::text::RichText;
use super::view::Series;
use crate::centers::{LinkPair, link_in_index};
use crate::construction::{Construction, FigureOf, Plan, PlanVector, Solution, Special, Teller, VectorPart};
use crate::cycle::{OtherModes, Traces};
use crate::mechanism::{BodyId, GROUND, Mechanism, PointId};
use crate::quantity::QuantityKind;
use crate::scene::{Figure, Page, PageSize};
use crate::sheet::{PerSheet, Scales, Sheet};
use crate::text::Untrusted;
use crate::words::Wording;
use std::sync::Arc;

const NO_MODES: &OtherModes = &OtherModes { shown: Vec::new(), has_more: false, own: None };

/// Made once for a solution. What is looked up is shared by all copies, so another surface costs nothing.
#[derive(Clone)]
pub(super) struct SheetContext<'a> {
    pub solution: &'a Solution,
    pub facts: Arc<Facts>,
    pub words: Wording,
    pub surface: Surface,
    pub purpose: Purpose,
    /// The paths and ghosts that the figure asks for.
    pub traces: Arc<Traces>,
    /// The other assembly modes to be drawn.
    pub modes: &'a OtherModes,
    /// The values to be written at links and vectors; none on a student's sheet, where they would tell the results.
    pub values: Arc<[Value]>,
}

/// Where a sheet is laid out.
///
/// Everything that a sheet asks of its page it asks here, so that another kind of surface is made here alone.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surface {
    pub page: Page,
    pub dims: Dims,
    /// From which the scales of panels are chosen.
    pub series: Series,
    /// The scales of the panels, in units per mm of paper: given, or chosen for all sheets of a figure; a panel without
    /// one gets the finest that fits.
    pub mu: Scales,
    /// The scales on paper, where the sheet is not for paper: words of steps tell lengths at these.
    pub told: Option<Scales>,
    /// The scales of a speed diagram that stand still while its mechanism moves.
    pub speeds: Option<SpeedScales>,
    /// Whether crowds of points are drawn again, larger, in a circle: in a film that would come and go.
    pub details: bool,
}

/// What a sheet is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Purpose {
    /// To be shown: special points far from the mechanism are arrows to them.
    Figure,
    /// To be compared with a student's drawing, where these points stand at their places.
    Drawing,
    /// To be drawn on: these points have room at their places, and sliders show the sense that counts as positive.
    Exercise,
}

impl Surface {
    /// A page for a figure.
    fn of(page: Page, figure: &Figure, purpose: Purpose) -> Surface {
        let series = match purpose {
            _ if page.size == PageSize::Wide => Series::Any,
            Purpose::Figure if !figure.worksheet => Series::Ruler,
            _ => Series::Hand,
        };
        Surface {
            page,
            dims: Dims::on_page(page, figure),
            series,
            mu: figure.mu,
            told: None,
            speeds: None,
            details: true,
        }
    }

    /// A part of a screen for the same figure.
    pub(super) fn on_pane(self, pane: Pane, figure: &Figure) -> Surface {
        Surface { dims: Dims::on_pane(pane, figure), series: Series::Any, mu: PerSheet::default(), ..self }
    }
}

impl<'a> SheetContext<'a> {
    /// The context of a solution for a sheet without values.
    pub(super) fn new(solution: &'a Solution, purpose: Purpose) -> Self {
        Self::with_traces(solution, purpose, Arc::new(Traces::of(solution)))
    }

    /// The context of a solution whose paths and ghosts are known.
    pub(super) fn with_traces(solution: &'a Solution, purpose: Purpose, traces: Arc<Traces>) -> Self {
        let figure = &solution.scene.figure;
        Self {
            solution,
            facts: Arc::new(Facts::of(solution)),
            words: solution.wording(),
            surface: Surface::of(figure.page, figure, purpose),
            purpose,
            traces,
            modes: NO_MODES,
            values: Arc::new([]),
        }
    }

    /// This context for another page, at scales of its own.
    pub(super) fn on_page(&self, page: Page, mu: Scales) -> Self {
        let surface = Surface { mu, ..Surface::of(page, self.figure(), self.purpose) };
        Self { surface, ..self.clone() }
    }

    /// This context for another position of its mechanism, without values.
    pub(super) fn at_position<'b>(&self, solution: &'b Solution) -> SheetContext<'b> {
        let context = SheetContext::with_traces(solution, self.purpose, Arc::clone(&self.traces));
        SheetContext { surface: self.surface, ..context }
    }

    /// This context on paper for a hand, which draws and measures at its own series of scales.
    pub(super) fn for_hand(&self) -> Self {
        let mut context = self.on_paper();
        context.surface.series = Series::Hand;
        context
    }

    /// This context on paper: the same if it is, else on A4.
    pub(super) fn on_paper(&self) -> Self {
        match self.surface.page.size {
            PageSize::Wide => self.on_page(Page::default(), self.figure().mu),
            _ => self.clone(),
        }
    }

    /// This context with room for markers along the edges of a sheet to be drawn on, where it is to have them: not for a
    /// projector.
    pub(super) fn with_markers(&self) -> Self {
        let mut marked = self.clone();
        if self.figure().markers && self.surface.page.size != PageSize::Wide {
            marked.surface.dims = self.surface.dims.with_markers();
        }
        marked
    }

    pub(super) fn figure(&self) -> &'a Figure {
        &self.solution.scene.figure
    }

    pub(super) fn mechanism(&self) -> &'a Mechanism {
        &self.solution.mechanism
    }

    pub(super) fn construction(&self) -> &'a Construction {
        let is_for_hand = self.surface.series == Series::Hand || self.figure().worksheet;
        match self.purpose == Purpose::Figure && !is_for_hand {
            true => self.solution.shown_construction(),
            // What a hand draws or measures on shows velocities as they are.
            false => &self.solution.construction,
        }
    }

    /// The plan of a sheet; none for the scheme.
    pub(super) fn plan(&self, sheet: Sheet) -> Option<&'a Plan> {
        self.construction().plan_on(sheet)
    }

    /// The writer of captions in the figure's language.
    pub(super) fn teller(&self) -> Teller<'_> {
        Teller::of(self.solution, self.construction(), &self.words)
    }

    /// The heading of a sheet.
    pub(super) fn sheet_name(&self, sheet: Sheet) -> String {
        self.teller().sheet_name(sheet)
    }

    pub(super) fn title(&self) -> Untrusted {
        self.solution.scene.title.clone().unwrap_or_else(|| self.words.title_of(self.figure()).as_str().into())
    }

    /// Whether the scene takes a name's label from the figure.
    pub(super) fn is_unlabelled(&self, name: &str) -> bool {
        self.figure().labels.get(name).is_some_and(|renamed| renamed.for_setting().is_empty())
    }

    /// The markup of a point's name, on the mechanism or within a plan: the scene's own, or else that of the figure's
    /// notation. Sentences name what has no label, too.
    pub(super) fn shown(&self, name: &str, plan: Option<&Plan>) -> String {
        if let Some(renamed) = self.figure().labels.get(name).filter(|_| !self.is_unlabelled(name)) {
            return renamed.for_setting();
        }
        self.standard(name, plan)
    }

    /// The markup of a point's name in a sentence, which needs a name also where the scene shows none.
    pub(super) fn told(&self, name: &str, plan: Option<&Plan>) -> String {
        let shown = self.shown(name, plan);
        if shown.trim().is_empty() { self.standard(name, plan) } else { shown }
    }

    /// The markup of a point's name in the figure's notation.
    fn standard(&self, name: &str, plan: Option<&Plan>) -> String {
        if plan.is_none() && name == self.mechanism().body(GROUND).name {
            return self.words.ground().to_owned();
        }
        let written = self.facts.markup(name);
        match plan {
            Some(plan) => plan.shown(name, written, &self.words.notation),
            None => written,
        }
    }

    /// The symbol of the centre of two links, in markup.
    pub(super) fn center_symbol(&self, pair: LinkPair, figure: FigureOf) -> String {
        pair.symbol(figure.primes(), self.mechanism(), &self.words.notation, &|name| self.told(name, None))
    }

    /// The symbols of a link's instant centre with the frame and of its inflection pole, in markup.
    pub(super) fn ends_of_inflection_circle(&self, link: BodyId) -> [String; 2] {
        let center = LinkPair::new(link, GROUND).map(|pair| self.center_symbol(pair, FigureOf::Mechanism));
        [center.unwrap_or_default(), format!("W_{{{}}}", self.link_in_index(link))]
    }

    /// A link in the index of such a symbol.
    pub(super) fn link_in_index(&self, link: BodyId) -> String {
        link_in_index(link, self.mechanism(), &self.words.notation, &|name| self.told(name, None))
    }

    /// Number of a link, by which a style picks its colour; none for the ground and for blocks without name.
    pub(super) fn number(&self, link: BodyId) -> Option<usize> {
        self.facts.numbers[link.0]
    }

    /// The Assur points, in a figure that shows them.
    pub(super) fn special(&self) -> impl Iterator<Item = &'a Special> {
        let shown = self.figure().special_points;
        self.construction().special.iter().filter(move |special| shown && special.is_assur)
    }

    /// The values of a sheet.
    pub(super) fn values_of(&self, sheet: Sheet) -> impl Iterator<Item = &Value> {
        self.values.iter().filter(move |value| value.panel == sheet)
    }
}

/// A value to be written at a vector, a link or a length.
#[derive(Clone, Debug)]
pub(super) struct Value {
    /// Where its label belongs.
    pub panel: Sheet,
    /// Its label's id without the panel.
    pub name: String,
    /// Its symbol in markup; several with signs of equality where they have the same value.
    pub symbol: String,
    pub number: f64,
    pub kind: QuantityKind,
    /// The number as written.
    pub written: String,
    /// Its unit.
    pub unit: String,
    /// The step that finds it.
    pub since: u16,
    pub of: ValueOf,
}

/// What a value belongs to.
#[derive(Clone, Debug)]
pub(super) enum ValueOf {
    /// A vector of the panel's plan.
    Vector(PlanVector),
    /// The angular velocity or acceleration of a link.
    Rate(BodyId),
    /// A given length of a link.
    Length([PointId; 2]),
    /// What a joint carries or a drive needs; it stands in the list alone.
    Force,
}

impl Value {
    pub(super) fn text(&self) -> RichText {
        let number = format!("= {} {}", self.written, self.unit);
        RichText::math(&self.symbol).followed_by(&RichText::plain(number.trim_end()))
    }

    /// Whether it is a result that is listed; relative motions of two points of a link and given lengths are not.
    pub(super) fn is_listed(&self) -> bool {
        match &self.of {
            ValueOf::Rate(_) | ValueOf::Force => true,
            ValueOf::Vector(vector) => {
                matches!(vector.part, VectorPart::Whole | VectorPart::Sliding | VectorPart::Coriolis)
            }
            ValueOf::Length(_) => false,
        }
    }
}
