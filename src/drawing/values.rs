//! The layer of values: symbols with numbers and units at vectors, links and lengths where there is room; the results
//! stand in a list, too, beside the panels.

use super::canvas::{Canvas, Wanted, ascii};
use super::context::{SheetContext, Value, ValueOf};
use super::forces;
use super::labels::LabelRequest;
use super::layout::{Aside, Item, Layout};
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::style::Style;
use super::table::{Cells, Heading, Table};
use super::text::{CAPTION, PlacedText, RichText};
use crate::construction::{NOTHING, Plan, PlanVector, PointRole, Solution, VectorPart, image_name, rate_symbol};
use crate::mechanism::{BodyId, Role};
use crate::motion::BodyMotion;
use crate::quantity::QuantityKind;
use crate::scene::{Figure, QuantityName, Shape as Given, Units, ValuesShown};
use crate::sheet::{Order, Sheet};
use crate::words::{Medium, NumberStyle};
use kurbo::{Point, Rect, Vec2};
use nalgebra::Vector2;
use std::collections::BTreeSet;

/// Number style of values.
pub(super) const VALUE: NumberStyle = NumberStyle::significant(3).rounded().in_full(-3, 6).on(Medium::Figure);
/// Number style of given lengths.
const GIVEN: NumberStyle = NumberStyle::shortest().on(Medium::Figure);
/// Largest part of a sheet's height for the list of results.
const MOST: f64 = 0.2;
/// Height of a line of listed values, in mm.
const LINE: f64 = 6.6;
/// White inside the frame of listed values, in mm.
const PAD: f64 = 3.0;
/// White between two listed values in a line, in mm.
const BETWEEN: f64 = 6.0;

impl SheetContext<'_> {
    /// This context with the values that its figure shows.
    pub(super) fn with_values(self) -> Self {
        let figure = self.figure();
        let usual = || match figure.usual_values.unwrap_or_else(|| Style::named(figure.style).shows_values()) {
            true => ValuesShown::Shown(None),
            false => ValuesShown::Hidden,
        };
        self.with_values_as(figure.values.unwrap_or_else(usual))
    }

    /// This context with these values.
    pub(super) fn with_values_as(&self, shown: ValuesShown) -> Self {
        Self { values: values(self, shown).into(), ..self.clone() }
    }
}

/// All values of a figure, in the order of the panels; none where it shows none.
fn values(context: &SheetContext<'_>, shown: ValuesShown) -> Vec<Value> {
    let own = context.solution.scene.units;
    let ValuesShown::Shown(unit) = shown else {
        let list = List { context, units: own, factor: 1.0 };
        return list.of_forces();
    };
    let length = unit.unwrap_or(own.length);
    let list = List { context, units: Units { length, ..own }, factor: own.length.metres() / length.metres() };
    let of_panel = |&panel: &Sheet| match panel {
        Sheet::Scheme => list.of_scheme(),
        Sheet::Forces => list.of_forces(),
        plan => list.of_plan(plan),
    };
    context.figure().shown_panels().iter().flat_map(of_panel).collect()
}

/// Makes the values of a figure.
struct List<'a> {
    context: &'a SheetContext<'a>,
    /// The units of velocities and accelerations.
    units: Units,
    /// The scene's unit of length in theirs.
    factor: f64,
}

impl List<'_> {
    fn value(&self, panel: Sheet, symbol: String, number: f64, kind: QuantityKind, since: u16, of: ValueOf) -> Value {
        let words = &self.context.words;
        let (written, unit) = match kind {
            QuantityKind::Length if panel != Sheet::Forces => {
                (words.write(number, GIVEN), kind.unit(self.context.solution.scene.units))
            }
            QuantityKind::Velocity | QuantityKind::Acceleration => {
                (words.write(number * self.factor, VALUE), kind.unit(self.units))
            }
            _ => (words.write(number, VALUE), kind.unit(self.units)),
        };
        let name = format!("value-{}", symbol.replace(['{', '}'], ""));
        Value { panel, name, symbol, number, kind, written, unit, since, of }
    }

    /// Rates of links and given lengths.
    fn of_scheme(&self) -> Vec<Value> {
        // Rates that are computed from a plan belong to it; angular velocities are shown without it, too.
        let shown = self.context.figure().shown_panels();
        let has_rates = |order: &Order| {
            let is_shown = || shown.contains(&order.sheet()) && self.context.construction().plan(*order).is_some();
            *order == Order::Velocity || is_shown()
        };
        let mut values: Vec<Value> =
            Order::ALL.into_iter().filter(has_rates).flat_map(|order| self.rates(order)).collect();
        let mechanism = self.context.mechanism();
        for (_, body) in mechanism.links() {
            let link = self.context.solution.scene.links.get(&body.name);
            let Some(Given::Lengths(lengths)) = link.map(|link| &link.shape) else { continue };
            for length in lengths {
                if let (Some(a), Some(b)) = (mechanism.point(&length.from), mechanism.point(&length.to)) {
                    let symbol = length.key.replace('-', " ");
                    let of = ValueOf::Length([a, b]);
                    values.push(self.value(Sheet::Scheme, symbol, length.value, QuantityKind::Length, 0, of));
                }
            }
        }
        values
    }

    /// Angular velocities or accelerations of the links, those of drives first and zero last; links that turn together
    /// share a value.
    fn rates(&self, order: Order) -> Vec<Value> {
        let Solution { mechanism, motion, .. } = self.context.solution;
        type Rate = (&'static str, QuantityKind, fn(&BodyMotion) -> f64);
        let (name, kind, rate): Rate = match order {
            Order::Velocity => ("omega", QuantityKind::AngularVelocity, |motion| motion.omega),
            Order::Acceleration => ("alpha", QuantityKind::AngularAcceleration, |motion| motion.alpha),
        };
        let all = || mechanism.links().map(|(link, body)| (link, body, rate(motion.body(link))));
        let largest = all().map(|(.., value)| value.abs()).fold(0.0, f64::max);
        let shown = |value: f64| if value.abs() < NOTHING * largest { 0.0 } else { value };
        let mut links: Vec<_> = all().filter(|(.., value)| *value != 0.0).collect();
        links.sort_by_key(|(_, body, value)| (shown(*value) == 0.0, !matches!(body.role, Role::Driver { .. })));
        let mut values: Vec<Value> = Vec::new();
        for (link, body, value) in links {
            let quantity = format!("{name}({})", body.name);
            let symbol = rate_symbol(&quantity);
            let number = shown(value);
            if let Some(same) = values.iter_mut().find(|other| other.number == number && number != 0.0) {
                same.symbol = format!("{} = {symbol}", same.symbol);
                continue;
            }
            let since =
                if mechanism.is_known(link) { 0 } else { self.context.facts.plan_steps[order.sheet()].rate(&quantity) };
            values.push(self.value(Sheet::Scheme, symbol, number, kind, since, ValueOf::Rate(link)));
        }
        values
    }

    /// What joints carry and drives need, where there is a force plan: its results, which no length of the plan shows at once.
    fn of_forces(&self) -> Vec<Value> {
        let all = forces::values::results(self.context).into_iter();
        let since = self.context.construction().step_count() as u16;
        all.map(|(symbol, number, kind)| self.value(Sheet::Forces, symbol, number, kind, since, ValueOf::Force))
            .collect()
    }

    /// Sizes of a plan's vectors; equal vectors share a value.
    fn of_plan(&self, panel: Sheet) -> Vec<Value> {
        let Some(plan) = self.context.plan(panel) else {
            return Vec::new();
        };
        let kind = panel.facts().drawn;
        let largest = plan.points.values().map(|point| point.vector.norm()).fold(0.0, f64::max);
        let steps = &self.context.facts.plan_steps[panel];
        let hides = |name: &String| is_hidden(self.context.figure(), plan, name);
        let mut values: Vec<Value> = Vec::new();
        let (mut drawn, mut symbols) = (Vec::new(), BTreeSet::new());
        for vector in self.context.teller().vectors(plan) {
            let Some(segment) = plan.segment(&vector.ends[0], &vector.ends[1]) else { continue };
            let is_whole = vector.ends[0] == plan.order.pole();
            let is_nothing = segment.norm() <= NOTHING * largest;
            if vector.ends.iter().any(hides) || (is_nothing && !is_whole) {
                continue;
            }
            let [a, b] = vector.ends.each_ref().map(|name| plan.points[name].vector);
            let same = |[c, d]: &[Vector2<f64>; 2]| (a - c).norm().max((b - d).norm()) <= NOTHING * largest;
            if let Some(same) = drawn.iter().position(same) {
                // A motion relative to a point at rest needs no second symbol.
                if is_whole {
                    let both = format!("{} = {}", values[same].symbol, vector.symbol);
                    symbols.remove(&std::mem::replace(&mut values[same].symbol, both.clone()));
                    symbols.insert(both);
                }
                continue;
            }
            // The motion along a guide is drawn at every point that passes it.
            if !symbols.insert(vector.symbol.clone()) {
                continue;
            }
            drawn.push([a, b]);
            let number = if is_nothing { 0.0 } else { segment.norm() };
            let since = steps.point(&vector.made);
            values.push(self.value(panel, vector.symbol.clone(), number, kind, since, ValueOf::Vector(vector)));
        }
        values
    }
}

/// Which results a list has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Listed {
    /// Rates of links, motions of points, and motions along guides.
    All,
    /// The main ones: rates, what the scene wants, and how points move that are no joints.
    Main,
}

impl Listed {
    /// Those with more results first.
    pub(super) const BOTH: [Listed; 2] = [Listed::All, Listed::Main];
}

/// The list of results; none where it would take too much of the sheet. On a stepwise sheet it stands below the panels,
/// after the last step.
pub(super) fn value_list(context: &SheetContext<'_>, listed: Listed, after: Option<u16>) -> Option<ValueList> {
    let list = match listed {
        Listed::All => ValueList::of(context, context.values.iter().filter(|value| value.is_listed()), after),
        Listed::Main => ValueList::of(context, context.main_values(), after),
    };
    let fits = list.height_in(list.width) <= MOST * context.surface.dims.page[1];
    (!list.entries.is_empty() && fits).then_some(list)
}

/// The end of the id of a value in a list.
fn id(value: &Value) -> String {
    format!("{}-{}", value.panel.as_str(), value.name)
}

impl SheetContext<'_> {
    /// The [main](Listed::Main) results.
    pub(super) fn main_values(&self) -> impl Iterator<Item = &Value> {
        let wanted = self.solution.scene.want.iter().flatten().filter_map(|name| QuantityName::parse(name));
        let wanted: Vec<QuantityName> = wanted.collect();
        self.values.iter().filter(move |value| match &value.of {
            ValueOf::Rate(_) | ValueOf::Force => true,
            ValueOf::Vector(vector) if vector.part == VectorPart::Whole => {
                let is_image = |point: &str| image_name(point) == vector.ends[1];
                let is_wanted = wanted.iter().any(|name| name.arguments.first().is_some_and(|point| is_image(point)));
                let mut points = self.mechanism().point_ids();
                let point = points.find(|point| is_image(self.mechanism().point_name(*point)));
                is_wanted || point.is_some_and(|point| !self.facts.pins[point.0] && !self.facts.slides[point.0])
            }
            _ => false,
        })
    }
}

/// A table of values.
pub(super) fn table<'v>(context: &SheetContext<'_>, values: impl Iterator<Item = &'v Value>) -> Table {
    let language = context.words.language;
    let heads = [(language.column_quantity(), "name", false), (language.value(), "value", true), ("", "unit", false)];
    let rows = values.map(|value| {
        let texts = vec![RichText::math(&value.symbol), RichText::plain(&value.written), RichText::plain(&value.unit)];
        Cells::new(texts, format!("listed-{}-{}", value.panel.as_str(), ascii(&value.name)))
    });
    let heads = heads.map(|(text, id, is_number)| Heading::new(RichText::plain(text), id, is_number));
    Table::new(heads.to_vec(), rows.collect())
}

/// Requests the label of a value beside `anchor`; it is left out where there is no room. Rates come first, what is zero
/// last.
pub(super) fn label<'c>(
    context: &SheetContext<'_>,
    canvas: &'c mut Canvas<'_>,
    value: &Value,
    anchor: Point,
    prefer: Option<Vec2>,
) -> &'c mut Wanted {
    let number = match &value.of {
        ValueOf::Rate(link) => context.number(*link),
        ValueOf::Vector(_) | ValueOf::Length(..) | ValueOf::Force => None,
    };
    let request = LabelRequest {
        may_stand_apart: value.is_listed() && value.number != 0.0,
        ..LabelRequest::new(value.text(), anchor, 0.9, prefer, rank(value))
    };
    canvas.step = value.since;
    let wanted = Wanted::new(value.name.clone(), request);
    canvas.request_label(Wanted { number, optional: true, last: true, ..wanted })
}

/// Which values choose their places first: results before what leads to them, angular velocities before accelerations, what
/// is zero last.
fn rank(value: &Value) -> u8 {
    match (&value.of, value.kind) {
        _ if value.number == 0.0 => 0,
        (ValueOf::Rate(_), QuantityKind::AngularVelocity) => 4,
        (ValueOf::Rate(_), _) => 3,
        (ValueOf::Vector(PlanVector { part: VectorPart::Whole, .. }), _) => 3,
        (ValueOf::Vector(_), _) if value.is_listed() => 2,
        (ValueOf::Vector(_), _) => 1,
        (ValueOf::Length(_), _) => 0,
        (ValueOf::Force, _) => 3,
    }
}

/// Whether a value has its label at the arrow of a drive.
pub(super) fn is_at_drive(context: &SheetContext<'_>, value: &Value, link: BodyId) -> bool {
    drive_value(context, link).is_some_and(|own| own.name == value.name)
}

/// The value of a driven link's angular velocity, for the label at its arrow.
pub(super) fn drive_value<'a>(context: &'a SheetContext<'_>, link: BodyId) -> Option<&'a Value> {
    let is_driven = matches!(context.mechanism().body(link).role, Role::Driver { .. });
    let is_its = |value: &&Value| {
        value.kind == QuantityKind::AngularVelocity && matches!(value.of, ValueOf::Rate(own) if own == link)
    };
    context.values.iter().find(is_its).filter(|_| is_driven)
}

/// Values one after another in lines, in a frame between the panels and the scales or beside the panels.
pub(super) struct ValueList {
    /// Texts, and what their ids end with.
    entries: Vec<(RichText, String)>,
    /// The step after the last one, on a stepwise sheet.
    after: Option<u16>,
    /// Width below the panels, in mm.
    width: f64,
}

impl ValueList {
    fn of<'v>(context: &SheetContext<'_>, values: impl Iterator<Item = &'v Value>, after: Option<u16>) -> ValueList {
        let entry = |value: &Value| (value.text(), id(value));
        ValueList { entries: values.map(entry).collect(), after, width: context.surface.dims.width_below() }
    }

    /// Whether a value is in the list.
    pub(super) fn has(&self, value: &Value) -> bool {
        let own = id(value);
        self.entries.iter().any(|(_, id)| *id == own)
    }

    /// By entry: its column's left end and its line, for lines of this width; in columns of one width.
    fn places(&self, width: f64) -> Vec<(f64, usize)> {
        let column = self.widest() + BETWEEN;
        let columns = ((width - 2.0 * PAD + BETWEEN) / column).max(1.0) as usize;
        (0..self.entries.len()).map(|index| (PAD + column * (index % columns) as f64, index / columns)).collect()
    }

    fn widest(&self) -> f64 {
        self.entries.iter().map(|(text, _)| text.width(CAPTION)).fold(0.0, f64::max)
    }

    fn height_in(&self, width: f64) -> f64 {
        let lines = self.places(width).last().map_or(0, |(_, line)| line + 1);
        LINE * lines as f64 + 2.0
    }
}

impl Item for ValueList {
    fn height(&self) -> f64 {
        if self.after.is_some() { self.height_in(self.width) } else { 0.0 }
    }

    fn asides(&self, room: Rect) -> Vec<Aside> {
        if self.after.is_some() {
            return Vec::new();
        }
        let mut asides = vec![Aside::Below(self.height_in(room.width()))];
        let beside = self.widest() + 2.0 * PAD;
        if self.height_in(beside) <= room.height() {
            asides.push(Aside::Right(beside));
        }
        asides
    }

    fn draw(&self, drawing: &mut Drawing, layout: &Layout, aside: Option<Rect>) {
        let area = match (self.after, aside) {
            (Some(_), _) => layout.below,
            (None, Some(area)) => {
                drawing.draw(Pen::Frame, Shape::rectangle(area));
                area
            }
            (None, None) => return,
        };
        for ((text, id), (x, line)) in self.entries.iter().zip(self.places(area.width())) {
            let from = Point::new(area.x0 + x, area.y0 + 5.0 + LINE * line as f64);
            let text = Shape::Text(PlacedText::new(text.clone(), CAPTION, from));
            let mark = drawing.draw_named(format!("listed-{}", ascii(id)), Pen::Caption, text);
            (mark.since, mark.passing) = (self.after.unwrap_or_default(), self.after.is_some());
        }
    }
}

/// Whether a plan point only leads to others, in a figure that does not show such points.
pub(in crate::drawing) fn is_hidden(figure: &Figure, plan: &Plan, name: &str) -> bool {
    let role = plan.points.get(name).map(|p| p.role);
    let on_the_way = match plan.order {
        Order::Velocity => matches!(role, Some(PointRole::Special)),
        Order::Acceleration => matches!(role, Some(PointRole::Special | PointRole::Normal | PointRole::Slid)),
    };
    on_the_way && !figure.special_points
}
