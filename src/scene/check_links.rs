//! Links: their points, what the form allows on them, their drives and motions.

use std::collections::HashSet;
use std::f64::consts::{PI, TAU};

use indexmap::IndexMap;

use super::Form;
use super::check_lengths::{lengths, local};
use super::error::SceneError;
use super::file::{LinkDriveFile, LinkFields, LinkMotionFile};
use super::forms::{LinkForm, NameOrPlace};
use super::link::{At, Drive, Link, LinkMotion, Shape};
use super::names::{Names, check_name};
use super::place::{Source, Spot};
use super::slider::SliderDrive;
use super::units::TimeUnit;

/// The hint of everything that the drawn form has no room for.
pub(super) const DRAWN: &str = "the drawing, `points`, gives it already";

/// Drives that push a sliding link, by the name of the link.
pub(super) type Pushes = IndexMap<String, SliderDrive>;

/// The links, and the drives written in links that push sliders, by the name of the link.
pub(super) fn links(
    source: Source<'_>,
    form: Form,
    time: TimeUnit,
    file: IndexMap<String, LinkForm>,
) -> Result<(IndexMap<String, Link>, Pushes), SceneError> {
    let mut links = IndexMap::with_capacity(file.len());
    let mut pushes = Pushes::new();
    if file.is_empty() {
        return Err(source.error(&["links"], "a mechanism has at least one link"));
    }
    for (name, LinkForm(fields)) in file {
        check_name("a link", &name)
            .map_err(|(message, hint)| source.error_with(&["links", &name], Spot::Key, message, hint))?;
        let (link, push) = link(source, form, time, &name, fields)?;
        if let Some(push) = push {
            pushes.insert(name.clone(), push);
        }
        links.insert(name, link);
    }
    Ok((links, pushes))
}

fn link(
    source: Source<'_>,
    form: Form,
    time: TimeUnit,
    name: &str,
    fields: LinkFields,
) -> Result<(Link, Option<SliderDrive>), SceneError> {
    check_form(source, form, name, &fields)?;
    let points = points(source, name, &fields)?;
    let shape = match (fields.shape, fields.lengths) {
        (Some(_), Some(_)) => {
            let message = format!("link {name} has both `lengths` and `shape`");
            return Err(source.key_error(&["links", name, "lengths"], message).hint("keep one of them"));
        }
        (Some(shape), None) => local(source, name, &points, shape)?,
        (None, given) if form == Form::Lengths => lengths(source, name, &points, given)?,
        (None, _) => Shape::Bare,
    };
    let (mut drive, mut push) = (None, None);
    let mut angle_deg = fields.angle;
    if let Some(given) = fields.drive {
        if fields.motion.is_some() {
            let message = format!("link {name} has both a drive and a known motion");
            return Err(source.key_error(&["links", name, "drive"], message).hint("keep one of them"));
        }
        if given.position.is_some() || given.speed.is_some() || given.acceleration.is_some() {
            push = Some(pushing(source, name, &given)?);
        } else {
            drive = Some(turning(source, time, name, &given)?);
        }
    }
    if fields.angle.is_some() && drive.as_ref().is_some_and(|drive| drive.angle_deg.is_some()) {
        let message = format!("link {name} has an angle and its drive has one too");
        return Err(source.error(&["links", name, "angle"], message).hint("keep one of them"));
    }
    if let Some(drive) = &mut drive {
        drive.angle_deg = drive.angle_deg.or(angle_deg.take());
    }
    let motion = fields.motion.map(motion);
    Ok((Link { points, shape, drive, angle_deg, motion }, push))
}

/// Errors at the keys that belong to the other form.
fn check_form(source: Source<'_>, form: Form, name: &str, fields: &LinkFields) -> Result<(), SceneError> {
    if form == Form::Lengths {
        if fields.motion.is_some() {
            let message = format!("link {name}: a known `motion` belongs to a drawn configuration");
            let hint = r#"give the coordinates of every point in "points": { … }, or drive the link"#;
            return Err(source.key_error(&["links", name, "motion"], message).hint(hint));
        }
        return Ok(());
    }
    let given =
        [("lengths", fields.lengths.is_some()), ("shape", fields.shape.is_some()), ("angle", fields.angle.is_some())];
    if let Some((key, _)) = given.iter().find(|(_, given)| *given) {
        let message = format!("link {name} has `{key}`, but this scene is a drawn configuration");
        let hint = format!("remove `{key}`: {DRAWN}; or remove `points` and give `ground` its coordinates");
        return Err(source.key_error(&["links", name, key], message).hint(hint));
    }
    let drive = fields.drive.as_ref();
    let given = [
        ("angle", drive.is_some_and(|d| d.angle.is_some())),
        ("position", drive.is_some_and(|d| d.position.is_some())),
    ];
    if let Some((key, _)) = given.iter().find(|(_, given)| *given) {
        let message = format!("the drive of link {name} has `{key}`, but this scene is a drawn configuration");
        return Err(source.key_error(&["links", name, "drive", key], message).hint(format!("remove `{key}`: {DRAWN}")));
    }
    Ok(())
}

/// The names of a link's points: those of `points`, or else of `shape`.
fn points(source: Source<'_>, name: &str, fields: &LinkFields) -> Result<Vec<String>, SceneError> {
    let invalid = |path: &[&str], (message, hint)| source.error_with(path, Spot::Key, message, hint);
    for point in fields.shape.iter().flat_map(IndexMap::keys) {
        check_name("a point", point).map_err(|wrong| invalid(&["links", name, "shape", point], wrong))?;
    }
    let Some(points) = &fields.points else {
        return match (&fields.shape, &fields.motion) {
            (Some(shape), _) => Ok(shape.keys().cloned().collect()),
            (None, Some(_)) => Ok(Vec::new()),
            (None, None) => {
                let hint = r#"add "points": ["A", "B"]"#;
                Err(source.error(&["links", name], format!("link {name} has no `points`")).hint(hint))
            }
        };
    };
    let mut seen = HashSet::new();
    for (index, point) in points.iter().enumerate() {
        let index = index.to_string();
        let path = ["links", name, "points", &index];
        check_name("a point", point).map_err(|wrong| invalid(&path, wrong))?;
        if !seen.insert(point) {
            return Err(source.error(&path, format!("point {point} stands twice in link {name}")));
        }
    }
    Ok(points.clone())
}

/// A drive that turns its link.
fn turning(source: Source<'_>, time: TimeUnit, name: &str, given: &LinkDriveFile) -> Result<Drive, SceneError> {
    let path = ["links", name, "drive"];
    let omega = match (given.omega, given.rpm) {
        (Some(omega), None) => omega,
        (None, Some(rpm)) => match time {
            TimeUnit::S => rpm * (PI / 30.0),
            TimeUnit::Min => rpm * TAU,
        },
        (Some(_), Some(_)) => {
            let message = format!("the drive of link {name} has both `omega` and `rpm`");
            return Err(source.key_error(&["links", name, "drive", "rpm"], message).hint("keep one of them"));
        }
        (None, None) => {
            let message = format!("the drive of link {name} has no speed");
            let hint = r#"add "omega" (radians per unit of time) or "rpm"; for a sliding link "speed""#;
            return Err(source.error(&path, message).hint(hint));
        }
    };
    Ok(Drive { angle_deg: given.angle, omega, alpha: given.alpha.unwrap_or(0.0) })
}

/// A drive that pushes its link along a guide.
fn pushing(source: Source<'_>, name: &str, given: &LinkDriveFile) -> Result<SliderDrive, SceneError> {
    let turns = [
        ("angle", given.angle.is_some()),
        ("omega", given.omega.is_some()),
        ("rpm", given.rpm.is_some()),
        ("alpha", given.alpha.is_some()),
    ];
    if let Some((key, _)) = turns.iter().find(|(_, given)| *given) {
        let message = format!("the drive of link {name} both pushes and turns");
        let hint = "a drive has `position`, `speed`, `acceleration`, or `angle`, `omega`, `alpha`";
        return Err(source.key_error(&["links", name, "drive", key], message).hint(hint));
    }
    let Some(speed) = given.speed else {
        let message = format!("the drive of link {name} has no `speed`");
        return Err(source.error(&["links", name, "drive"], message).hint(r#"add "speed", along the guide"#));
    };
    Ok(SliderDrive { position: given.position, speed, acceleration: given.acceleration.unwrap_or(0.0) })
}

fn motion(given: LinkMotionFile) -> LinkMotion {
    LinkMotion {
        at: match given.at {
            NameOrPlace::Name(name) => At::Point(name),
            NameOrPlace::Place(place) => At::Place(place),
        },
        velocity: given.velocity.0,
        acceleration: given.acceleration.map_or([0.0; 2], |vector| vector.0),
        omega: given.omega.unwrap_or(0.0),
        alpha: given.alpha.unwrap_or(0.0),
    }
}

/// Errors at motions that are given at a point there is not.
pub(super) fn check_motions(names: &Names<'_>, links: &IndexMap<String, Link>) -> Result<(), SceneError> {
    for (name, link) in links {
        if let Some(LinkMotion { at: At::Point(point), .. }) = &link.motion {
            names.point(&["links", name, "motion", "at"], point)?;
        }
    }
    Ok(())
}
