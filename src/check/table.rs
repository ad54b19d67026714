//! The form of measured values as a table: lines `quantity,value,unit`, with commas or semicolons.

use super::measured::{CheckError, Measured, PlacedPoint, PointsOf, Positive, WIDEST};
use super::says;
use super::written::{given, with_point, with_unit};
use crate::message::Message;
use crate::scene::says::{keep_one, key_twice};
use crate::sheet::Sheet;
use crate::text::{Untrusted, cell, quoted, shown};
use std::collections::BTreeMap;

impl Measured {
    /// The values of a table. Beside quantities it may have lines `name`, `exercise`, `mu_l`,
    /// `mu_v`, `mu_a`, `positive` and `in`. A line `velocity:b,114,-2.7` gives the place of a plan point on paper, in
    /// millimetres; a fourth cell how far it may be from there. Cells are separated by commas, semicolons or tabs; numbers
    /// may have decimal commas. Lines that are wrong are among its `faults`.
    ///
    /// # Errors
    /// The text is no table.
    pub fn read_csv(text: &str) -> Result<Measured, CheckError> {
        let text = text.trim_start_matches('\u{feff}').replace("\r\n", "\n").replace('\r', "\n");
        let mut reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .trim(csv::Trim::All)
            .delimiter(delimiter(&text))
            .from_reader(text.as_bytes());
        let mut measured = Measured::default();
        let mut first_lines: BTreeMap<String, u64> = BTreeMap::new();
        for record in reader.records() {
            let record =
                record.map_err(|error| CheckError::new(says::no_table(error.to_string()), says::write_lines()))?;
            let line = record.position().map_or(0, |p| p.line());
            let place = says::line(line);
            // A quotation mark that is never closed takes all the lines that follow into one cell.
            if record.iter().any(|cell| cell.contains('\n')) {
                measured.faults.push(CheckError::new(says::open_quotation(), says::close_quotation()).at(&place));
                continue;
            }
            let cells: Vec<&str> = record.iter().collect();
            let cells = rejoined(&cells);
            let cell = |index: usize| cells.get(index).map_or("", String::as_str);
            let name: String = cell(0).chars().filter(|c| !c.is_whitespace()).collect();
            if !(name.is_empty() || is_head(&name) || cell(1).is_empty()) {
                let first = *first_lines.entry(name.clone()).or_insert(line);
                if first < line {
                    let twice = CheckError::new(key_twice(shown(&name), first), keep_one());
                    measured.faults.push(twice.at(&place));
                    continue;
                }
            }
            if let Err(fault) = measured.cells([cell(0), cell(1), cell(2), cell(3)], &place) {
                measured.faults.push(fault.at(&place));
            }
        }
        Ok(measured)
    }

    /// Adds a line of a table.
    fn cells(&mut self, [name, value, third, fourth]: [&str; 4], place: &Message) -> Result<(), CheckError> {
        if let Some((sheet, point)) = placed_point(name) {
            let at = [value, third].map(with_point);
            if at.iter().any(|c| !c.is_empty()) {
                let [x, y] = at;
                let band = (!fourth.is_empty()).then(|| radius(&with_point(fourth))).transpose()?;
                let at = [coordinate(&x)?, coordinate(&y)?];
                let plan = self.points.iter().position(|p| p.sheet == sheet).unwrap_or_else(|| {
                    self.points.push(PointsOf::new(sheet));
                    self.points.len() - 1
                });
                self.points[plan].put(point, at, band);
            }
            return Ok(());
        }
        if is_head(name) {
            return Ok(());
        }
        if value.is_empty() {
            // Beside a blank stands its unit at most.
            return match third != "1" && with_unit(third).0.parse::<f64>().is_ok() {
                true => Err(CheckError::new(says::value_in_unit(shown(third)), says::write_lines())),
                false => Ok(()),
            };
        }
        if name.is_empty() {
            return Err(CheckError::new(says::value_without_name(shown(value)), says::write_lines()));
        }
        self.line(name, value, third, place)
    }

    fn line(&mut self, name: &str, written: &str, third: &str, place: &Message) -> Result<(), CheckError> {
        let value = with_point(written);
        if let Some(sheet) = Sheet::ALL.into_iter().find(|sheet| sheet.facts().scale_key == name) {
            self.mu[sheet] = Some(scale(name, &value)?);
            return Ok(());
        }
        match name {
            "name" => self.name = Some(written.into()),
            "exercise" => self.exercise = Some(written.into()),
            "positive" => {
                let sense = [Positive::CounterClockwise, Positive::Clockwise].into_iter().find(|p| p.as_str() == value);
                let wrong = || CheckError::new(says::no_sense(shown(&value)), says::write_sense());
                self.positive = Some(sense.ok_or_else(wrong)?);
            }
            "in" => {
                self.in_mm = match value.as_str() {
                    "mm" => true,
                    "units" => false,
                    other => {
                        return Err(CheckError::new(says::values_in(shown(other)), says::mm_or_units()));
                    }
                };
            }
            "upright" => {
                let wrong = || CheckError::new(says::not_upright(shown(&value)), says::true_or_false());
                self.upright = value.parse().map_err(|_| wrong())?;
            }
            "hints" => {
                let wrong = || CheckError::new(says::no_count(shown(&value)), says::whole_number());
                self.hints = value.parse().map_err(|_| wrong())?;
            }
            _ => {
                let unit = (!third.is_empty()).then(|| third.to_owned());
                self.values.push(given(name.to_owned(), written, unit, place.clone()));
            }
        }
        Ok(())
    }
}

/// A form as a table: its head, its values as name, digits and unit, the places of its points.
pub(super) fn written<'v>(measured: &Measured, values: impl Iterator<Item = [&'v str; 3]>) -> String {
    let blank_or_quoted = |text: &str| if text.is_empty() { String::new() } else { quoted(text) };
    let own = |text: &Untrusted| blank_or_quoted(&text.for_cell());
    let mut lines = vec!["quantity,value,unit".to_owned()];
    lines.extend(measured.name.as_ref().map(|name| format!("name,{},", own(name))));
    lines.extend(measured.exercise.as_ref().map(|exercise| format!("exercise,{},", own(exercise))));
    lines.extend(measured.mu.given().map(|(sheet, mu)| format!("{},{mu},", sheet.facts().scale_key)));
    lines.extend(measured.positive.map(|sense| format!("positive,{},", sense.as_str())));
    lines.extend(measured.in_mm.then(|| "in,mm,".to_owned()));
    lines.extend(measured.upright.then(|| "upright,true,".to_owned()));
    lines.extend((measured.hints > 0).then(|| format!("hints,{},", measured.hints)));
    lines.extend(
        values
            .map(|[name, digits, unit]| format!("{},{},{}", quoted(name), cell(digits), blank_or_quoted(&cell(unit)))),
    );
    for plan in &measured.points {
        let line = |(name, PlacedPoint { at, band }): (&String, &PlacedPoint)| {
            let numbers: String = at.iter().chain(band).map(|x| format!(",{x}")).collect();
            quoted(&format!("{}:{name}", plan.sheet.as_str())) + &numbers
        };
        lines.extend(plan.places.iter().map(line));
    }
    lines.join("\n") + "\n"
}

/// Whether a line is no value: the head of the table, or what some spreadsheets say in their first line, which separator they use.
fn is_head(name: &str) -> bool {
    name.eq_ignore_ascii_case("quantity") || name.starts_with("sep=")
}

/// The sheet and the point that the name of a place means, as `velocity:b`; `None` for other names.
fn placed_point(name: &str) -> Option<(Sheet, &str)> {
    let (sheet, point) = name.split_once(':')?;
    Some((Sheet::from_word(sheet.trim()).filter(|sheet| sheet.has_places())?, point.trim()))
}

/// What separates the cells of a table: what its first line with text has, a semicolon, a tab, or else a comma.
fn delimiter(text: &str) -> u8 {
    let first = text.lines().find(|line| !line.trim().is_empty()).unwrap_or("");
    [b';', b'\t'].into_iter().find(|&mark| first.contains(char::from(mark))).unwrap_or(b',')
}

fn coordinate(text: &str) -> Result<f64, CheckError> {
    finite(text).ok_or_else(|| CheckError::new(says::no_coordinate(shown(text)), says::write_coordinates()))
}

/// How far a point may be from its place.
fn radius(text: &str) -> Result<f64, CheckError> {
    finite(text)
        .filter(|x| (0.0..=WIDEST).contains(x))
        .ok_or_else(|| CheckError::new(says::no_radius(shown(text)), says::write_radius()))
}

/// The cells of a line, with names joined that a comma has split: without quotes, `L(B,S3)` comes as `L(B` and `S3)`.
fn rejoined(cells: &[&str]) -> Vec<String> {
    let mut joined: Vec<String> = Vec::new();
    for cell in cells {
        match joined.last_mut() {
            Some(last) if last.contains('(') && !last.contains(')') => {
                last.push(',');
                last.push_str(cell);
            }
            _ => joined.push((*cell).to_owned()),
        }
    }
    joined
}

fn scale(name: &str, text: &str) -> Result<f64, CheckError> {
    finite(text).ok_or_else(|| CheckError::new(says::scale_no_number(name, shown(text)), says::write_scale()))
}

fn finite(text: &str) -> Option<f64> {
    text.parse().ok().filter(|x: &f64| x.is_finite())
}
