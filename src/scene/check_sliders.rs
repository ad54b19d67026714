//! Sliders: who slides on what, by which point, along which guide.

use std::collections::HashSet;

use indexmap::IndexMap;

use super::Form;
use super::check_links::{DRAWN, Pushes};
use super::error::SceneError;
use super::file::{SliderDriveFile, SliderFile};
use super::forms::{Direction, NameOrPlace};
use super::link::{At, Link, Shape};
use super::names::{Names, no_point, pair};
use super::place::Source;
use super::slider::{Along, On, Slider, SliderDrive};

/// The sliders; `pushes` are the drives that stand in sliding links, which are moved to their sliders.
pub(super) fn sliders(
    source: Source<'_>,
    form: Form,
    names: &Names<'_>,
    coordinates: &IndexMap<String, [f64; 2]>,
    file: Vec<SliderFile>,
    mut pushes: Pushes,
) -> Result<Vec<Slider>, SceneError> {
    let mut sliders: Vec<Slider> = Vec::with_capacity(file.len());
    let mut pushed: IndexMap<String, usize> = IndexMap::new();
    for (index, given) in file.into_iter().enumerate() {
        let index = index.to_string();
        let check = Check { source, form, names, coordinates, index: &index };
        let mut slider = check.slider(given)?;
        if let Some((link, push)) = slider.link.as_ref().and_then(|link| pushes.swap_remove_entry(link)) {
            if slider.drive.is_some() {
                let message = format!("link {link} has a drive, and so has its slider");
                return Err(check.key_error(&["drive"], message).hint("keep one of them"));
            }
            slider.drive = Some(push);
            pushed.insert(link, sliders.len());
        } else if let Some(link) = slider.link.as_ref().filter(|link| pushed.contains_key(*link)) {
            let message = format!("link {link} has two sliders, and its drive does not say which one it pushes");
            let hint = "move the drive into one of the entries of `sliders`";
            return Err(source.key_error(&["links", link, "drive"], message).hint(hint));
        }
        sliders.push(slider);
    }
    if let Some(link) = pushes.keys().next() {
        let message = format!("link {link} is pushed by its drive, but it has no slider");
        let hint = "add an entry to `sliders` with this `link`, or turn the link with `omega`";
        return Err(source.key_error(&["links", link, "drive"], message).hint(hint));
    }
    let carriers: HashSet<&On> = sliders.iter().map(|slider| &slider.on).collect();
    for (name, link) in names.links() {
        let idle = link.points.is_empty() && link.motion.is_none();
        if idle && !carriers.contains(&On::Link(name.clone())) {
            let message = format!("link {name} has no points, and nothing slides on it");
            return Err(source.error(&["links", name], message).hint("remove it, or name its points"));
        }
    }
    Ok(sliders)
}

/// What the checks of one slider read.
struct Check<'a> {
    source: Source<'a>,
    form: Form,
    names: &'a Names<'a>,
    coordinates: &'a IndexMap<String, [f64; 2]>,
    index: &'a str,
}

impl Check<'_> {
    fn path<'b>(&'b self, rest: &[&'b str]) -> Vec<&'b str> {
        [&["sliders", self.index], rest].concat()
    }

    fn error(&self, rest: &[&str], message: impl Into<String>) -> SceneError {
        self.source.error(&self.path(rest), message)
    }

    fn key_error(&self, rest: &[&str], message: impl Into<String>) -> SceneError {
        self.source.key_error(&self.path(rest), message)
    }

    fn slider(&self, given: SliderFile) -> Result<Slider, SceneError> {
        let on = match given.on.as_str() {
            "ground" => On::Ground,
            name => {
                self.names.link(&self.path(&["on"]), name)?;
                On::Link(given.on)
            }
        };
        self.check_who(&on, given.link.as_deref(), given.at.as_deref(), given.pin.as_deref())?;
        let through = given.through.map(|through| self.through(&on, through)).transpose()?;
        let along = self.along(&on, given.along)?;
        let placed = through.is_some() || matches!(along, Along::Points(..)) || !self.points_of(&on).is_empty();
        if self.form == Form::Lengths && !placed {
            let message = format!("nothing says where the guide is: {} has no points", carrier(&on));
            let hint = match on {
                On::Ground => r#"add "through": [x, y], a place on the guide"#.into(),
                On::Link(link) => format!("name a point of link {link} that is on the guide"),
            };
            return Err(self.error(&[], message).hint(hint));
        }
        if self.form == Form::Drawn && given.turned.is_some() {
            let message = "`turned` has no place in a drawn configuration";
            return Err(self.key_error(&["turned"], message).hint(format!("remove it: {DRAWN}")));
        }
        if self.form == Form::Drawn && given.drive.as_ref().is_some_and(|drive| drive.position.is_some()) {
            let message = "this drive has `position`, but this scene is a drawn configuration";
            return Err(self.key_error(&["drive", "position"], message).hint(format!("remove `position`: {DRAWN}")));
        }
        let drive = given.drive.map(|SliderDriveFile { position, speed, acceleration }| SliderDrive {
            position,
            speed,
            acceleration: acceleration.unwrap_or(0.0),
        });
        let turned_deg = given.turned.unwrap_or(0.0);
        Ok(Slider { link: given.link, at: given.at, pin: given.pin, on, through, along, turned_deg, drive })
    }

    /// Errors at a link, point or pin that cannot slide on `on`.
    fn check_who(&self, on: &On, link: Option<&str>, at: Option<&str>, pin: Option<&str>) -> Result<(), SceneError> {
        match (link, at, pin) {
            (Some(link), Some(at), None) => {
                self.names.link(&self.path(&["link"]), link)?;
                if matches!(on, On::Link(on) if on == link) {
                    return Err(self.error(&["on"], format!("link {link} cannot slide on itself")));
                }
                self.names.point_of_link(&self.path(&["at"]), link, at)?;
                self.check_free(on, "at", at)
            }
            (None, None, Some(pin)) => {
                self.names.point(&self.path(&["pin"]), pin)?;
                self.check_free(on, "pin", pin)
            }
            (None, None, None) => {
                let hint = r#"give "link" and "at", the link and its point on the guide; or "pin""#;
                Err(self.error(&[], "this slider does not say what slides").hint(hint))
            }
            (_, _, Some(_)) => {
                let message = "`pin` stands in place of `link` and `at`, not beside them";
                Err(self.key_error(&["pin"], message).hint("keep `link` and `at` for a block, `pin` for a bare pin"))
            }
            (Some(link), None, None) => {
                let hint = format!(r#"add "at", the point of link {link} that is on the guide"#);
                Err(self.error(&[], "`at` is missing").hint(hint))
            }
            (None, Some(at), None) => {
                let hint = format!(r#"add "link", the sliding link; or write "pin": "{at}" for a pin in a slot"#);
                Err(self.error(&[], "`link` is missing").hint(hint))
            }
        }
    }

    /// An error if the sliding point is fixed to what it should slide on.
    fn check_free(&self, on: &On, key: &str, point: &str) -> Result<(), SceneError> {
        let carrier = carrier(on);
        if self.is_point_of(on, point) {
            let message = format!("point {point} is a point of {carrier}, so it cannot slide on it");
            return Err(self.error(&[key], message).hint("use another name for the point that slides"));
        }
        Ok(())
    }

    fn is_point_of(&self, on: &On, point: &str) -> bool {
        match on {
            On::Ground => self.names.on_ground(point),
            On::Link(link) => self.names.on_link(link, point),
        }
    }

    fn points_of(&self, on: &On) -> &[String] {
        match on {
            On::Ground => self.names.ground(),
            On::Link(link) => self.names.get(link).map_or(&[], |link| &link.points),
        }
    }

    fn through(&self, on: &On, given: NameOrPlace) -> Result<At, SceneError> {
        match given {
            NameOrPlace::Name(point) if self.is_point_of(on, &point) => Ok(At::Point(point)),
            NameOrPlace::Name(point) => {
                let message = no_point(&carrier(on), &point, self.points_of(on));
                Err(self.error(&["through"], message))
            }
            NameOrPlace::Place(place) => {
                let shape = |link: &Link| matches!(link.shape, Shape::Local(_));
                if let On::Link(name) = on
                    && !self.names.get(name).is_some_and(shape)
                {
                    let message = format!("coordinates need a frame, and link {name} has no `shape`");
                    let hint = match self.form {
                        Form::Lengths => {
                            format!("name a point of link {name}, or give the link a `shape`")
                        }
                        Form::Drawn => format!(
                            "name a point of link {name}, or leave `through` out: the guide passes through the slider's point"
                        ),
                    };
                    return Err(self.error(&["through"], message).hint(hint));
                }
                Ok(At::Place(place))
            }
        }
    }

    fn along(&self, on: &On, given: Option<Direction>) -> Result<Along, SceneError> {
        let absent = given.is_none();
        match given.unwrap_or(Direction::Degrees(0.0)) {
            Direction::Points(key) => self.along_points(on, &key),
            Direction::Vector([0.0, 0.0]) => {
                Err(self.error(&["along"], "a direction of size zero points nowhere").hint("give [dx, dy] or degrees"))
            }
            Direction::Vector(direction) => Ok(Along::Direction(direction)),
            Direction::Degrees(degrees) => {
                let axis = match on {
                    On::Ground => true,
                    On::Link(link) => {
                        self.form == Form::Lengths || self.names.get(link).is_some_and(|l| !l.points.is_empty())
                    }
                };
                if axis {
                    return Ok(Along::Degrees(degrees));
                }
                let message = format!("{} has no points and so no axis to count degrees from", carrier(on));
                let rest: &[&str] = if absent { &[] } else { &["along"] };
                Err(self.error(rest, message).hint(r#"give the direction as drawn: "along": [dx, dy]"#))
            }
        }
    }

    fn along_points(&self, on: &On, key: &str) -> Result<Along, SceneError> {
        let (from, to) = pair(key, |point| self.is_point_of(on, point)).map_err(|wrong| {
            let (message, hint) = wrong.explain("along", key, &carrier(on), self.points_of(on));
            let degrees =
                key.trim().parse::<f64>().is_ok().then(|| format!("write {} without quotes for degrees", key.trim()));
            self.error(&["along"], message).maybe_hint(degrees.or(hint))
        })?;
        if let (Some(a), Some(b)) = (self.coordinates.get(&from), self.coordinates.get(&to))
            && a == b
        {
            let message = format!("{from} and {to} are in one place, so they give no direction");
            return Err(self.error(&["along"], message));
        }
        Ok(Along::Points(from, to))
    }
}

/// "link 2" or "the ground".
fn carrier(on: &On) -> String {
    match on {
        On::Ground => "the ground".into(),
        On::Link(link) => format!("link {link}"),
    }
}
