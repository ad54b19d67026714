use super::closing::{Assembled, closed, places};
use super::drawn::drawn_pose;
use super::frames::Frames;
use super::truss::Truss;
use super::{Assembly, AssemblyError, Pose};
use crate::geometry::{Point, Vector, degrees_of, span};
use crate::mechanism::{BodyId, Group, LoopEquations, Mechanism, PointId, Role};
use crate::scene::{Form, Near};

/// A gap of a closed loop, relative to the mechanism's size, above which a candidate is no assembly mode.
const CLOSED: f64 = 1e-10;

/// Two assemblies whose points lie closer than this part of the mechanism's size are one.
const SAME: f64 = 1e-8;

/// Where a mechanism is: as drawn, or assembled from its lengths in the mode closest to `near`.
///
/// The modes of a fourth-class group are numbered by the angle of its first link, counter-clockwise from +x.
///
/// # Errors
/// [`AssemblyError::NoMode`] says which links do not meet, and by how much.
pub fn pose(mechanism: &Mechanism, near: &Near) -> Result<Pose, AssemblyError> {
    if mechanism.form == Form::Drawn {
        return Ok(drawn_pose(mechanism));
    }
    let mut frames = Frames::known(mechanism);
    let mut slides = vec![0.0; mechanism.sliders.len()];
    for body in &mechanism.bodies {
        if let Role::Pushed {
            slider,
            position: Some(position),
            ..
        } = body.role
        {
            slides[slider.0] = position;
        }
    }
    let mut assemblies = Vec::new();
    let mut warnings = Vec::new();
    for group in &mechanism.groups {
        let mut modes = modes(mechanism, group, &frames, &slides)?;
        let (chosen, remark) = choose(mechanism, group, &modes, near);
        warnings.extend(remark);
        assemblies.push(Some(Assembly {
            mode: chosen + 1,
            modes: modes.len(),
        }));
        let assembled = modes.swap_remove(chosen);
        (frames, slides) = (assembled.frames, assembled.slides);
    }
    let (points, guides) = places(mechanism, &frames);
    let named = |id: usize| {
        !matches!(
            mechanism.bodies[id].role,
            Role::Ground | Role::Carrier { .. }
        )
    };
    let axes = (0..mechanism.bodies.len()).map(|id| {
        let frame = frames.of(BodyId(id)).filter(|_| named(id))?;
        Some(frame.rotation * Vector::x())
    });
    Ok(Pose {
        points,
        guides,
        slides: slides.into_iter().map(Some).collect(),
        axes: axes.collect(),
        assemblies,
        warnings,
    })
}

/// Every real assembly mode of `group`, ordered by the angle of its first link from +x.
fn modes(
    mechanism: &Mechanism,
    group: &Group,
    known: &Frames,
    slides: &[f64],
) -> Result<Vec<Assembled>, AssemblyError> {
    let truss = Truss::new(mechanism, group, known).ok_or_else(|| AssemblyError::NotAvailable {
        links: group.link_names(mechanism),
    })?;
    let equations = LoopEquations::new(mechanism, group);
    let mut found: Vec<Assembled> = Vec::new();
    for start in truss.starts(known, slides) {
        let assembled = closed(mechanism, group, &equations, start);
        let new = |other: &Assembled| !same(mechanism, other, &assembled);
        if assembled.gap <= CLOSED && found.iter().all(new) {
            found.push(assembled);
        }
    }
    if found.is_empty() {
        let miss = truss.miss();
        return Err(AssemblyError::NoMode {
            links: group.link_names(mechanism),
            at: drive_angles(mechanism),
            miss,
        });
    }
    let angle = |a: &Assembled| {
        let first = a.frames.of(group.links[0]);
        first.map_or(0.0, |f| {
            degrees_of(f.rotation * Vector::x()).rem_euclid(360.0)
        })
    };
    found.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    Ok(found)
}

/// The drives' angles in words.
fn drive_angles(mechanism: &Mechanism) -> String {
    let drives = mechanism.bodies.iter().filter_map(|b| match b.role {
        Role::Driver {
            angle: Some(angle), ..
        } => Some(format!(" at angle({}) = {angle}°", b.name)),
        Role::Pushed {
            position: Some(position),
            ..
        } => Some(format!(" at position({}) = {position}", b.name)),
        _ => None,
    });
    drives.collect::<Vec<_>>().join(",")
}

/// Whether two assemblies put every point in the same place.
fn same(mechanism: &Mechanism, a: &Assembled, b: &Assembled) -> bool {
    let ((a, _), (b, _)) = (places(mechanism, &a.frames), places(mechanism, &b.frames));
    let size = span(a.iter().copied());
    a.iter().zip(&b).all(|(p, q)| (p - q).norm() <= SAME * size)
}

/// The mode closest to `near`, and what to say about the choice.
fn choose(
    mechanism: &Mechanism,
    group: &Group,
    modes: &[Assembled],
    near: &Near,
) -> (usize, Option<String>) {
    let of_group = |p: PointId| {
        let mut links = group.links.iter();
        links.any(|&l| mechanism.body(l).points.contains(&p))
    };
    let rough: Vec<(PointId, Point)> = near
        .points
        .iter()
        .filter_map(|(name, &p)| Some((mechanism.point(name)?, Point::from(p))))
        .filter(|(p, _)| of_group(*p))
        .collect();
    let turned: Vec<(BodyId, f64)> = near
        .angles_deg
        .iter()
        .filter_map(|(name, &angle)| Some((mechanism.link(name)?, angle)))
        .filter(|(link, _)| group.links.contains(link))
        .collect();
    let count = rough.len() + turned.len();
    if count == 0 {
        return (
            0,
            (modes.len() > 1).then(|| list_modes(mechanism, group, modes)),
        );
    }
    let size = span(places(mechanism, &modes[0].frames).0);
    let distance = |mode: &Assembled| {
        let (points, _) = places(mechanism, &mode.frames);
        let mut sum: f64 = rough
            .iter()
            .map(|(p, q)| (points[p.0] - q).norm_squared())
            .sum();
        for (link, angle) in &turned {
            let now = mode
                .frames
                .of(*link)
                .map_or(0.0, |f| degrees_of(f.rotation * Vector::x()));
            let chord = 2.0 * libm::sin(0.5 * (now - angle).to_radians()) * size;
            sum += chord * chord;
        }
        (sum / count as f64).sqrt()
    };
    let distances: Vec<f64> = modes.iter().map(distance).collect();
    let by_distance = |a: &usize, b: &usize| distances[*a].total_cmp(&distances[*b]);
    let chosen = (0..modes.len()).min_by(by_distance).unwrap_or(0);
    let far = distances[chosen] > 0.5 * size;
    let remark = far.then(|| {
        format!(
            "`near` is {:.4} away (root mean square) from the closest of {} assembly modes, more than half the mechanism's size {:.4}: \
             check its coordinates",
            distances[chosen],
            modes.len(),
            size
        )
    });
    (chosen, remark)
}

/// The modes in words, where `near` says nothing.
fn list_modes(mechanism: &Mechanism, group: &Group, modes: &[Assembled]) -> String {
    let known = |p: &PointId| {
        let bodies = mechanism.bodies.iter();
        bodies
            .clone()
            .any(|b| b.role.is_known() && b.points.contains(p))
    };
    let mut inner: Vec<PointId> = Vec::new();
    for &link in &group.links {
        let points = mechanism.body(link).points.iter();
        inner.extend(
            points
                .filter(|p| !known(p) && !inner.contains(p))
                .copied()
                .collect::<Vec<_>>(),
        );
    }
    let described = modes.iter().enumerate().map(|(index, mode)| {
        let (points, _) = places(mechanism, &mode.frames);
        let places = inner.iter().map(|p| {
            let q = points[p.0];
            format!("{} ({:.2}, {:.2})", mechanism.point_name(*p), q.x, q.y)
        });
        format!("{}: {}", index + 1, places.collect::<Vec<_>>().join(" "))
    });
    format!(
        "links {} can be assembled in {} ways and `near` is not given, so mode 1 is taken: {}",
        group.link_names(mechanism),
        modes.len(),
        described.collect::<Vec<_>>().join("; ")
    )
}
