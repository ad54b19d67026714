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

/// Ways to assemble a whole mechanism beyond which each group is decided by itself.
const MOST_WAYS: usize = 4096;

/// Where a mechanism is: as drawn, or assembled from its lengths in the way closest to `near`.
///
/// Least squares over all given places together decide; without any the first way is taken.
///
/// # Errors
/// [`AssemblyError::NoMode`] says which links do not meet, and by how much.
pub fn pose(mechanism: &Mechanism, near: &Near) -> Result<Pose, AssemblyError> {
    if mechanism.form == Form::Drawn {
        return Ok(drawn_pose(mechanism));
    }
    let rough = Rough::new(mechanism, near);
    let mut ways = ways(mechanism, Some(&rough))?;
    let (chosen, remark) = rough.choose(mechanism, &ways);
    let mut pose = ways.swap_remove(chosen).pose(mechanism);
    pose.warnings.extend(remark);
    Ok(pose)
}

/// Every real way to assemble a mechanism from its lengths; of a drawn configuration the one pose that it is.
///
/// The modes of a group are numbered by the angle of its first link, counter-clockwise from +x; a mechanism's ways by the modes
/// of its groups, the first group's counting most.
///
/// # Errors
/// As for [`pose()`].
pub fn poses(mechanism: &Mechanism) -> Result<Vec<Pose>, AssemblyError> {
    if mechanism.form == Form::Drawn {
        return Ok(vec![drawn_pose(mechanism)]);
    }
    let ways = ways(mechanism, None)?;
    Ok(ways.into_iter().map(|way| way.pose(mechanism)).collect())
}

/// A whole mechanism put together.
#[derive(Clone)]
struct Way {
    frames: Frames,
    slides: Vec<f64>,
    assemblies: Vec<Assembly>,
}

impl Way {
    fn pose(self, mechanism: &Mechanism) -> Pose {
        let (points, guides) = places(mechanism, &self.frames);
        let named = |id: usize| {
            !matches!(
                mechanism.bodies[id].role,
                Role::Ground | Role::Carrier { .. }
            )
        };
        let axes = (0..mechanism.bodies.len()).map(|id| {
            let frame = self.frames.of(BodyId(id)).filter(|_| named(id))?;
            Some(frame.rotation * Vector::x())
        });
        Pose {
            axes: axes.collect(),
            points,
            guides,
            slides: self.slides.into_iter().map(Some).collect(),
            assemblies: self.assemblies.into_iter().map(Some).collect(),
            warnings: Vec::new(),
        }
    }
}

/// All ways, group after group. With `rough` places, and more ways than can be listed, the closest are kept after each group.
fn ways(mechanism: &Mechanism, rough: Option<&Rough>) -> Result<Vec<Way>, AssemblyError> {
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
    let mut ways = vec![Way {
        frames: Frames::known(mechanism),
        slides,
        assemblies: Vec::new(),
    }];
    for group in &mechanism.groups {
        let mut longer: Vec<Way> = Vec::new();
        let mut failure = None;
        for way in &ways {
            match modes(mechanism, group, &way.frames, &way.slides) {
                Ok(found) => {
                    let modes = found.len();
                    longer.extend(found.into_iter().enumerate().map(|(index, assembled)| {
                        let mut assemblies = way.assemblies.clone();
                        let mode = index + 1;
                        assemblies.push(Assembly { mode, modes });
                        Way {
                            frames: assembled.frames,
                            slides: assembled.slides,
                            assemblies,
                        }
                    }));
                }
                Err(error) => failure = failure.or(Some(error)),
            }
        }
        if let (true, Some(error)) = (longer.is_empty(), failure) {
            return Err(error);
        }
        if longer.len() > MOST_WAYS {
            if let Some(rough) = rough {
                longer.sort_by(|a, b| {
                    rough
                        .distance(mechanism, a)
                        .total_cmp(&rough.distance(mechanism, b))
                });
            }
            longer.truncate(MOST_WAYS);
        }
        ways = longer;
    }
    Ok(ways)
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

/// Rough places of points and angles of links, by which a way to assemble is chosen.
struct Rough {
    points: Vec<(PointId, Point)>,
    angles: Vec<(BodyId, f64)>,
}

impl Rough {
    fn new(mechanism: &Mechanism, near: &Near) -> Rough {
        let member = |link: BodyId| mechanism.body(link).role == Role::Member;
        let of_group = |p: PointId| {
            let mut links = mechanism.links();
            links.any(|(id, body)| member(id) && body.points.contains(&p))
        };
        let points = near.points.iter();
        let points = points.filter_map(|(name, &p)| Some((mechanism.point(name)?, Point::from(p))));
        let angles = near.angles_deg.iter();
        let angles = angles.filter_map(|(name, &angle)| Some((mechanism.link(name)?, angle)));
        Rough {
            points: points.filter(|(p, _)| of_group(*p)).collect(),
            angles: angles.filter(|(link, _)| member(*link)).collect(),
        }
    }

    /// Root mean square of the distances from the rough places that the way has reached; an angle counts by the chord that it
    /// makes at the mechanism's size.
    fn distance(&self, mechanism: &Mechanism, way: &Way) -> f64 {
        let (points, _) = places(mechanism, &way.frames);
        let size = span(points.iter().copied());
        let placed = |p: PointId| {
            let mut links = mechanism.links();
            links.any(|(id, body)| way.frames.of(id).is_some() && body.points.contains(&p))
        };
        let mut sum = 0.0;
        for (p, rough) in self.points.iter().filter(|(p, _)| placed(*p)) {
            sum += (points[p.0] - rough).norm_squared();
        }
        for (link, angle) in &self.angles {
            if let Some(frame) = way.frames.of(*link) {
                let now = degrees_of(frame.rotation * Vector::x());
                let chord = 2.0 * libm::sin(0.5 * (now - angle).to_radians()) * size;
                sum += chord * chord;
            }
        }
        (sum / self.count().max(1) as f64).sqrt()
    }

    fn count(&self) -> usize {
        self.points.len() + self.angles.len()
    }

    /// The closest way, and what to say about the choice.
    fn choose(&self, mechanism: &Mechanism, ways: &[Way]) -> (usize, Option<String>) {
        if self.count() == 0 {
            return (0, (ways.len() > 1).then(|| list_ways(mechanism, ways)));
        }
        let distances: Vec<f64> = ways.iter().map(|w| self.distance(mechanism, w)).collect();
        let by_distance = |a: &usize, b: &usize| distances[*a].total_cmp(&distances[*b]);
        let chosen = (0..ways.len()).min_by(by_distance).unwrap_or(0);
        let size = span(places(mechanism, &ways[chosen].frames).0);
        let far = distances[chosen] > 0.5 * size;
        let remark = far.then(|| {
            format!(
                "`near` is {:.4} away (root mean square) from the closest of {} assembly modes, more than half the mechanism's size {:.4}: \
                 check its coordinates",
                distances[chosen],
                ways.len(),
                size
            )
        });
        (chosen, remark)
    }
}

/// The ways in words, where `near` says nothing.
fn list_ways(mechanism: &Mechanism, ways: &[Way]) -> String {
    const LISTED: usize = 8;
    let listed = ways.iter().take(LISTED).enumerate().map(|(index, way)| {
        let (points, _) = places(mechanism, &way.frames);
        let places = mechanism.inner_points().into_iter().map(|p| {
            let q = points[p.0];
            format!("{} ({:.2}, {:.2})", mechanism.point_name(p), q.x, q.y)
        });
        format!("{}: {}", index + 1, places.collect::<Vec<_>>().join(" "))
    });
    let listed = listed.collect::<Vec<_>>().join("; ");
    let more = if ways.len() > LISTED { "; …" } else { "" };
    let links: Vec<String> = mechanism
        .groups
        .iter()
        .map(|g| g.link_names(mechanism))
        .collect();
    format!(
        "links {} can be assembled in {} ways and `near` is not given, so mode 1 is taken: {listed}{more}",
        links.join(", "),
        ways.len(),
    )
}
