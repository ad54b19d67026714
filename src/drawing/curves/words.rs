use super::Sheet;
use super::axis::digits;
use super::panel::Panel;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Drawing, Pen};
use crate::drawing::text::{PlacedText, RichText};
use crate::mechanism::{Role, SliderId};
use crate::plan::Kind;
use kurbo::Point;

/// A line of text in which symbols are slanted and words are upright.
pub(super) struct Line(Vec<RichText>);

impl Line {
    /// White between its parts, in em.
    const SPACE: f64 = 0.28;

    pub(super) fn width(&self, size: f64) -> f64 {
        let spaces = self.0.len().saturating_sub(1) as f64 * Self::SPACE * size;
        spaces + self.0.iter().map(|part| part.width(size)).sum::<f64>()
    }

    /// Draws it with its middle at a point of its baseline.
    pub(super) fn centred(self, drawing: &mut Drawing, middle: Point, size: f64) {
        let from = Point::new(middle.x - 0.5 * self.width(size), middle.y);
        self.starting(drawing, from, size);
    }

    /// Draws it with its end at a point of its baseline.
    pub(super) fn ending(self, drawing: &mut Drawing, end: Point, size: f64) {
        let from = Point::new(end.x - self.width(size), end.y);
        self.starting(drawing, from, size);
    }

    fn starting(self, drawing: &mut Drawing, from: Point, size: f64) {
        let mut at = from;
        for part in self.0 {
            let step = part.width(size) + Self::SPACE * size;
            let text = PlacedText::new(part, size, at);
            drawing.draw(Pen::Caption, Shape::Text(text));
            at.x += step;
        }
    }
}

/// What a panel shows.
pub(super) fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::Angle => "Angle",
        Kind::AngularVelocity => "Angular velocity",
        Kind::AngularAcceleration => "Angular acceleration",
        Kind::Position => "Position",
        Kind::Length => "Length",
        Kind::Velocity => "Velocity",
        Kind::Acceleration => "Acceleration",
    }
}

/// What the drive's axis shows.
pub(super) fn drive(sheet: &Sheet) -> Line {
    let drive = &sheet.curves.path.drive;
    let link = sheet.shown(&drive.name);
    let length = sheet.scene.units.length.as_str();
    let plain = RichText::plain;
    Line(if drive.is_angle() {
        let symbol = RichText::math(&format!("φ_{{{link}}}"));
        vec![plain("Angle"), symbol, plain("of the drive in °")]
    } else {
        let words = format!("Position of drive {link} in {length}");
        vec![plain(&words)]
    })
}

/// How the drives run.
pub(super) fn speeds(sheet: &Sheet) -> Line {
    let (mechanism, units) = (sheet.curves.path.mechanism, sheet.scene.units);
    let mut parts: Vec<[String; 2]> = Vec::new();
    let mut add = |symbol: String, value: f64, kind: Kind| {
        let value = format!("= {} {}", digits(value, 4), kind.unit(units));
        parts.push([symbol, value]);
    };
    for (_, body) in mechanism.links() {
        let name = sheet.shown(&body.name);
        if let Role::Driver { omega, alpha, .. } = body.role {
            add(format!("ω_{{{name}}}"), omega, Kind::AngularVelocity);
            if alpha != 0.0 {
                add(format!("α_{{{name}}}"), alpha, Kind::AngularAcceleration);
            }
        }
    }
    for (index, slider) in mechanism.sliders.iter().enumerate() {
        let Some(drive) = slider.drive else { continue };
        let name = sheet.shown(&mechanism.push_name(SliderId(index)));
        add(format!("v_{{{name}}}"), drive.speed, Kind::Velocity);
        if drive.acceleration != 0.0 {
            add(
                format!("a_{{{name}}}"),
                drive.acceleration,
                Kind::Acceleration,
            );
        }
    }
    let count = parts.len();
    let texts = parts
        .iter()
        .enumerate()
        .flat_map(|(index, [symbol, value])| {
            let comma = if index + 1 < count { "," } else { "" };
            [
                RichText::math(symbol),
                RichText::plain(&(value.clone() + comma)),
            ]
        });
    Line(texts.collect())
}

/// The figure in sentences, for those who cannot see it.
pub(super) fn description(sheet: &Sheet, panels: &[Panel]) -> String {
    let (curves, units) = (sheet.curves, sheet.scene.units);
    let drive = &curves.path.drive;
    let [from, to] = curves.range.map(|v| drive.amount(v));
    let mut text = format!("Over {} from {from} to {to}:", drive.quantity());
    for panel in panels {
        let unit = panel.kind.unit(units);
        for curve in panel.members.iter().map(|i| &curves.curves[*i]) {
            let names: Vec<&str> = curve.asked.iter().map(|a| a.name()).collect();
            text.push_str(&format!(" {}", names.join(" = ")));
            if let Some(value) = curve.constant {
                text.push_str(&format!(" is {} {unit};", digits(value, 6)));
                continue;
            }
            for (greatest, word) in [(false, "least"), (true, "greatest")] {
                let mut extremes = curve.extremes.iter();
                match extremes.find(|e| e.greatest == greatest) {
                    Some(e) => text.push_str(&format!(
                        ", {word} {} {unit} at {}",
                        digits(e.value, 6),
                        drive.amount((e.at * 1e4).round() / 1e4)
                    )),
                    None => text.push_str(&format!(", {word} without bound")),
                }
            }
            text.push(';');
        }
    }
    text.pop();
    text.push('.');
    text
}
