//! The form of measured values as a table: lines `quantity,value,unit`, with commas or semicolons.

use super::sheet::{CheckError, Given, Measured, PointsOf, Positive};
use crate::construction::PlanKind;
use indexmap::IndexMap;

impl Measured {
    /// The values of a table; blanks are left out. Beside quantities it may have lines `name`, `exercise`, `mu_l`,
    /// `mu_v`, `mu_a`, `positive` and `in`. A line `velocity:b,114,-2.7` gives the place of a plan point on paper, in millimetres.
    ///
    /// In a table with semicolons numbers may have decimal commas.
    ///
    /// # Errors
    /// The first line that is wrong, and why.
    pub fn read_csv(text: &str) -> Result<Measured, CheckError> {
        let text = text.trim_start_matches('\u{feff}');
        let by_semicolon = text.lines().next().is_some_and(|line| line.contains(';'));
        let mut reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .trim(csv::Trim::All)
            .delimiter(if by_semicolon { b';' } else { b',' })
            .from_reader(text.as_bytes());
        let mut measured = Measured::default();
        for record in reader.records() {
            let record = record.map_err(|error| {
                CheckError::new(
                    format!("this is no table: {error}"),
                    "write a line `quantity,value` for each value; names with a comma stand in double quotes",
                )
            })?;
            let line = record.position().map_or(0, |p| p.line());
            let place = format!("line {line}");
            let cells: Vec<&str> = record.iter().collect();
            let cells = rejoined(&cells);
            let mut cells = cells.iter().map(String::as_str);
            let (name, value) = (cells.next().unwrap_or(""), cells.next().unwrap_or(""));
            let third = cells.next().unwrap_or("");
            if let Some((kind, point)) = plan_point(name) {
                let at = [value, third].map(|c| decimal(c, by_semicolon));
                if at.iter().any(|c| !c.is_empty()) {
                    let [x, y] = at;
                    let at = [coordinate(&x), coordinate(&y)];
                    let [x, y] = at.map(|c| c.map_err(|e| e.at(&place)));
                    measured.add_place(kind, point, [x?, y?]);
                }
                continue;
            }
            if name.is_empty() || value.is_empty() || name.eq_ignore_ascii_case("quantity") {
                continue;
            }
            let value = decimal(value, by_semicolon);
            measured.line(name, value, third, &place).map_err(|e| e.at(&place))?;
        }
        Ok(measured)
    }

    /// Adds the place of a plan point on paper, in millimetres.
    fn add_place(&mut self, kind: PlanKind, point: &str, at: [f64; 2]) {
        let plan = self.points.iter().position(|p| p.kind == kind).unwrap_or_else(|| {
            self.points.push(PointsOf { kind, places: IndexMap::new() });
            self.points.len() - 1
        });
        self.points[plan].places.insert(point.to_owned(), at);
    }

    fn line(&mut self, name: &str, value: String, third: &str, place: &str) -> Result<(), CheckError> {
        match name {
            "name" => self.name = Some(value),
            "exercise" => self.exercise = Some(value),
            "mu_l" => self.mu[0] = Some(number(name, &value)?),
            "mu_v" => self.mu[1] = Some(number(name, &value)?),
            "mu_a" => self.mu[2] = Some(number(name, &value)?),
            "positive" => {
                self.positive = Some(match value.as_str() {
                    "clockwise" => Positive::Clockwise,
                    "counter-clockwise" => Positive::CounterClockwise,
                    other => {
                        return Err(CheckError::new(
                            format!("`{other}` is no sense of rotation"),
                            "write `clockwise` or `counter-clockwise`",
                        ));
                    }
                });
            }
            "in" => {
                self.in_mm = match value.as_str() {
                    "mm" => true,
                    "units" => false,
                    other => {
                        return Err(CheckError::new(
                            format!("values in `{other}` are not understood"),
                            "write `mm` for millimetres of paper, or `units` for those of the scene",
                        ));
                    }
                };
            }
            _ => self.values.push(Given {
                name: name.to_owned(),
                text: value,
                unit: (!third.is_empty()).then(|| third.to_owned()),
                place: place.to_owned(),
            }),
        }
        Ok(())
    }
}

/// The plan and the point that the name of a place means, as `velocity:b`; `None` for other names.
fn plan_point(name: &str) -> Option<(PlanKind, &str)> {
    let (plan, point) = name.split_once(':')?;
    let kind = match plan.trim() {
        "velocity" => PlanKind::Velocity,
        "acceleration" => PlanKind::Acceleration,
        _ => return None,
    };
    Some((kind, point.trim()))
}

/// A number with a decimal point and a plain minus.
fn decimal(text: &str, has_comma: bool) -> String {
    let text = text.replace('−', "-");
    if has_comma { text.replacen(',', ".", 1) } else { text }
}

fn coordinate(text: &str) -> Result<f64, CheckError> {
    let number = text.parse().ok().filter(|x: &f64| x.is_finite());
    number.ok_or_else(|| {
        CheckError::new(
            format!("`{text}` is no coordinate"),
            "write x and y in millimetres of paper, as velocity:b,114,-2.7",
        )
    })
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

fn number(name: &str, text: &str) -> Result<f64, CheckError> {
    let number = text.parse().ok().filter(|x: &f64| x.is_finite());
    number.ok_or_else(|| {
        CheckError::new(
            format!("{name} is `{text}`, which is no number"),
            "write units of the scene per millimetre of paper, as 2 or 0.5",
        )
    })
}
