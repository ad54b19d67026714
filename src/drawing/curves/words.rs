use super::Sheet;
use super::panel::Panel;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Drawing, Pen};
use crate::drawing::text::{PlacedText, RichText};
use crate::mechanism::{Role, SliderId};
use crate::quantity::Kind;
use crate::words::Language;
use kurbo::{Point, Rect};

/// Holds a symbol's place in a sentence.
pub(super) const SYMBOL: &str = "\u{fffc}";

/// A line of text in which symbols are slanted and words are upright.
pub(super) struct Line(Vec<RichText>);

impl Line {
    /// White between its parts, in em.
    const SPACE: f64 = 0.28;

    /// A sentence that has [`SYMBOL`] where its symbol stands.
    pub(super) fn around(sentence: &str, symbol: RichText) -> Line {
        let (before, behind) = sentence.split_once(SYMBOL).unwrap_or((sentence, ""));
        let words = |text: &str| (!text.trim().is_empty()).then(|| RichText::plain(text.trim()));
        Line(words(before).into_iter().chain([symbol]).chain(words(behind)).collect())
    }

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

    /// Draws it from a point of its baseline; the box of its ink.
    pub(super) fn starting(self, drawing: &mut Drawing, from: Point, size: f64) -> Rect {
        let mut at = from;
        let mut ink = Rect::from_points(from, from);
        for part in self.0 {
            let step = part.width(size) + Self::SPACE * size;
            let text = PlacedText::new(part, size, at);
            ink = ink.union(text.ink_box());
            drawing.draw(Pen::Caption, Shape::Text(text));
            at.x += step;
        }
        ink
    }
}

/// What a panel shows.
pub(super) fn kind(language: &Language, kind: Kind) -> &str {
    match kind {
        Kind::Angle => language.angle(),
        Kind::AngularVelocity => language.angular_velocity(),
        Kind::AngularAcceleration => language.angular_acceleration(),
        Kind::Position => language.position(),
        Kind::Length => language.length(),
        Kind::Velocity => language.velocity(),
        Kind::Acceleration => language.acceleration(),
    }
}

/// What the drive's axis shows.
pub(super) fn drive(sheet: &Sheet) -> Line {
    let (drive, language) = (&sheet.curves.path.drive, sheet.words.language);
    let link = sheet.shown(&drive.name);
    let length = sheet.scene.units.length.as_str();
    if drive.is_angle() {
        Line::around(&language.drive_angle(SYMBOL), RichText::math(&format!("φ_{{{link}}}")))
    } else {
        Line(vec![RichText::plain(&language.drive_position(&link, length))])
    }
}

/// How the drives run.
pub(super) fn speeds(sheet: &Sheet) -> Line {
    let (mechanism, units) = (sheet.curves.path.mechanism, sheet.scene.units);
    let mut parts: Vec<[String; 2]> = Vec::new();
    let mut add = |symbol: String, value: f64, kind: Kind| {
        let value = format!("= {} {}", sheet.number(value, 4), kind.unit(units));
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
            add(format!("a_{{{name}}}"), drive.acceleration, Kind::Acceleration);
        }
    }
    let count = parts.len();
    let texts = parts.iter().enumerate().flat_map(|(index, [symbol, value])| {
        let comma = if index + 1 < count { "," } else { "" };
        [RichText::math(symbol), RichText::plain(&(value.clone() + comma))]
    });
    Line(texts.collect())
}

/// The figure in sentences, for those who cannot see it.
pub(super) fn description(sheet: &Sheet, panels: &[Panel]) -> String {
    let (curves, units, language) = (sheet.curves, sheet.scene.units, sheet.words.language);
    let drive = &curves.path.drive;
    let amount = |value: f64| sheet.words.number(drive.amount(value));
    let [from, to] = curves.range.map(amount);
    let mut text = language.over(&drive.quantity(), &from, &to);
    for panel in panels {
        let unit = panel.kind.unit(units);
        let value = |value: f64| format!("{} {unit}", sheet.number(value, 6));
        for curve in panel.members.iter().map(|i| &curves.curves[*i]) {
            let names: Vec<&str> = curve.asked.iter().map(|a| a.name()).collect();
            let names = names.join(" = ");
            if let Some(constant) = curve.constant {
                let sentence = language.is_constant(&names, &value(constant));
                text.push_str(&format!(" {sentence};"));
                continue;
            }
            let extreme = |greatest: bool, sentence: fn(&Language, &str, &str) -> String, none: &str| {
                let mut extremes = curve.extremes.iter();
                match extremes.find(|e| e.greatest == greatest) {
                    Some(e) => sentence(language, &value(e.value), &amount((e.at * 1e4).round() / 1e4)),
                    None => none.to_owned(),
                }
            };
            let least = extreme(false, Language::least, language.no_least());
            let greatest = extreme(true, Language::greatest, language.no_greatest());
            text.push_str(&format!(" {names}, {least}, {greatest};"));
        }
    }
    text.pop();
    text.push('.');
    text
}
