//! Willis' table beside the panels: how fast the wheels of each train turn, as the sum of two motions.

use super::context::SheetContext;
use super::layout::{Aside, Item, Layout};
use super::sheet::Drawing;
use super::table::{Cells, Heading, Table};
use super::text::RichText;
use crate::accuracy::bounds;
use crate::construction::Solution;
use crate::geometry::Ball;
use crate::mechanism::{BodyId, GROUND};
use crate::motion::Train;
use crate::quantity::QuantityKind;
use crate::words::{Medium, NumberStyle};
use kurbo::Rect;

const VALUE: NumberStyle = NumberStyle::significant(5).trimmed().in_full(-4, 7).on(Medium::Figure);

/// The table, if the figure asks for it: for each train its carrier, then its wheels. All turn with the carrier; the carrier is held and the
/// first wheel turned, the others as often as their teeth say; both together.
pub(super) fn table(context: &SheetContext<'_>) -> Option<Table> {
    if !context.figure().willis {
        return None;
    }
    let language = context.words.language;
    let rows: Vec<Cells> = Train::all(context.mechanism()).iter().flat_map(|train| rows(context, train)).collect();
    let unit = QuantityKind::AngularVelocity.unit(context.solution.scene.units);
    let head = [
        (language.column_quantity().to_owned(), "name", false),
        (language.willis_all().to_owned(), "all", true),
        (language.willis_turns().to_owned(), "turns", true),
        (language.willis_held().to_owned(), "held", true),
        (format!("{} ({unit})", language.willis_together()), "together", true),
    ];
    let head = head.map(|(text, name, is_number)| Heading::new(RichText::plain(&text), name, is_number)).to_vec();
    (!rows.is_empty()).then(|| Table::new(head, rows))
}

/// The table on the figure's sheet, where it is legible.
pub(super) struct WillisTable(pub Table);

impl Item for WillisTable {
    fn asides(&self, room: Rect) -> Vec<Aside> {
        self.0.asides_at_full_size(room)
    }

    fn draw(&self, drawing: &mut Drawing, layout: &Layout, aside: Option<Rect>) {
        self.0.draw(drawing, layout, aside);
    }
}

fn rows(context: &SheetContext<'_>, train: &Train) -> Vec<Cells> {
    let Solution { scene, mechanism, pose, motion, .. } = context.solution;
    let bounds = bounds(scene, mechanism, pose, motion);
    let omega = |body: BodyId| {
        let [within, _] = bounds.angular_rates(body);
        Ball::within(motion.body(body).omega, within)
    };
    let carrier = omega(train.carrier);
    let first = train.wheels.first().map_or(Ball::default(), |wheel| omega(wheel.body) - carrier);
    let symbol = |body: BodyId| match body {
        GROUND => "0".to_owned(),
        _ => context.shown(&context.mechanism().body(body).name, None),
    };
    // What is zero within its error is zero: a sum of fractions mostly is not in floating point.
    let number = |value: Ball| {
        let known = if value.high.abs() <= value.error() { 0.0 } else { value.high };
        RichText::plain(&context.words.write(known + 0.0, VALUE))
    };
    let row = |body: BodyId, turns: &str, held: Ball| {
        let name = symbol(body);
        let texts = vec![
            RichText::math(&format!("ω_{{{name}}}")),
            number(carrier),
            RichText::plain(turns),
            number(held),
            number(carrier + held),
        ];
        Cells::new(texts, format!("willis-{}-{name}", symbol(train.carrier)))
    };
    let wheels = train.wheels.iter().map(|wheel| {
        let [over, under] = wheel.turns;
        let sign = if over < 0 { "−" } else { "" };
        let under = if under == 1 { String::new() } else { format!("/{under}") };
        row(
            wheel.body,
            &format!("{sign}{}{under}", over.unsigned_abs()),
            whole(wheel.turns[0]) / whole(wheel.turns[1]) * first,
        )
    });
    std::iter::once(row(train.carrier, "0", Ball::default())).chain(wheels).collect()
}

/// A whole number, with what a floating-point number leaves of a very large one.
fn whole(number: i128) -> Ball {
    let near = number as f64;
    Ball::within(near, (number - near as i128).unsigned_abs() as f64)
}
