use super::closing::{Assembled, closed, places};
use super::drawn::drawn_pose;
use super::frames::{Frames, Hold, local, local_guide, pinned, turned_towards};
use super::legs::{LegCondition, placements, smallest_miss};
use super::{Assembly, AssemblyError, Pose};
use crate::geometry::{Placement, Point, Vector, cross, degrees_of, span};
use crate::mechanism::{
    BodyId, Group, JointId, JointKind, LoopEquations, Mechanism, PointId, Role, SliderId,
};
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
    let truss = Truss::new(mechanism, group, known);
    let equations = LoopEquations::new(mechanism, group);
    let mut found: Vec<Assembled> = Vec::new();
    for relative in placements(truss.conditions) {
        for start in truss.assemble(mechanism, known, slides, &relative) {
            let assembled = closed(mechanism, group, &equations, start);
            let new = |other: &Assembled| !same(mechanism, other, &assembled);
            if assembled.gap <= CLOSED && found.iter().all(new) {
                found.push(assembled);
            }
        }
    }
    if found.is_empty() {
        let miss = smallest_miss(truss.conditions).filter(|m| m.abs() > 0.0);
        let miss = match miss {
            Some(m) => format!(
                "with everything else closed, {} would have to be {:.4} {}",
                truss.names[truss.first_distance()],
                m.abs(),
                if m > 0.0 { "longer" } else { "shorter" }
            ),
            None => "its guides and lengths never meet".to_owned(),
        };
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

/// A fourth-class group seen as two rigid bodies (its drag links) joined by three legs: its closure links, and the
/// known bodies between the outer joints, which stand still for this purpose.
struct Truss {
    a: BodyId,
    b: BodyId,
    /// The middle bodies of the first two legs; the third is the fixed frame.
    closures: [BodyId; 2],
    holds: [[Hold; 2]; 3],
    conditions: [LegCondition; 3],
    names: [String; 3],
    sliders: [[Option<(SliderId, BodyId)>; 2]; 3],
}

impl Truss {
    fn new(mechanism: &Mechanism, group: &Group, known: &Frames) -> Truss {
        let chains = [&group.loops[0], &group.loops[1]];
        let (a, b) = (chains[0].bodies[1], chains[0].bodies[3]);
        let closures = chains.map(|c| c.bodies[2]);
        let fixed = |joint: JointId, body: BodyId| {
            let frame = known.of(mechanism.joint(joint).other(body));
            frame.copied().unwrap_or_else(Placement::identity)
        };
        let identity = Placement::identity();
        let (outer_a, outer_b) = (chains[0].joints[0], chains[0].joints[3]);
        let ends = [
            [chains[0].joints[1], chains[0].joints[2]],
            [chains[1].joints[1], chains[1].joints[2]],
            [outer_a, outer_b],
        ];
        let hold = |joint, body, other: &Placement| Hold::new(mechanism, joint, body, other);
        let holds = std::array::from_fn(|k| {
            let [near, far] = ends[k];
            if k < 2 {
                [hold(near, a, &identity), hold(far, b, &identity)]
            } else {
                [hold(near, a, &fixed(near, a)), hold(far, b, &fixed(far, b))]
            }
        });
        let slider = |joint: JointId, body: BodyId| match mechanism.joint(joint).kind {
            JointKind::Prismatic(id) => Some((id, body)),
            JointKind::Revolute(_) => None,
        };
        let name = |[near, far]: [JointId; 2]| {
            let point = |j| mechanism.point_name(mechanism.joint_point(j));
            format!("{}{}", point(near), point(far))
        };
        Truss {
            a,
            b,
            closures,
            conditions: holds.map(condition),
            holds,
            names: ends.map(name),
            sliders: ends.map(|[near, far]| [slider(near, a), slider(far, b)]),
        }
    }

    /// Index of the leg whose length the smallest miss is about.
    fn first_distance(&self) -> usize {
        let is_distance = |c: &LegCondition| matches!(c, LegCondition::Distance { .. });
        self.conditions.iter().position(is_distance).unwrap_or(0)
    }

    /// All bodies placed for a placement of b in a's frame; two ways where a leg leaves a choice.
    fn assemble(
        &self,
        mechanism: &Mechanism,
        known: &Frames,
        slides: &[f64],
        relative: &Placement,
    ) -> Vec<Assembled> {
        // The third leg's middle is the fixed frame: where a's frame stands in it is what is looked for.
        let Some(frame_a) = middle(&self.holds[2], relative).map(|m| m.inverse()) else {
            return Vec::new();
        };
        let frame_b = frame_a * relative;
        let mut frames = known.clone();
        frames.set(self.a, frame_a);
        frames.set(self.b, frame_b);
        for (k, &closure) in self.closures.iter().enumerate() {
            let Some(in_a) = middle(&self.holds[k], relative) else {
                return Vec::new();
            };
            frames.set(closure, frame_a * in_a);
        }
        let mut slides = slides.to_vec();
        for (id, _) in self.sliders.iter().flatten().flatten() {
            let slider = mechanism.slider(*id);
            let (Some(on), Some(link)) = (frames.of(slider.on), frames.of(slider.link)) else {
                return Vec::new();
            };
            let (through, direction) = local_guide(slider);
            let at = link * local(mechanism, slider.link, slider.at);
            slides[id.0] = (on.inverse() * at - through).dot(&direction);
        }
        vec![Assembled {
            frames,
            slides,
            gap: f64::INFINITY,
        }]
    }
}

/// The condition that a leg with these holds puts on body b in a's frame.
fn condition([near, far]: [Hold; 2]) -> LegCondition {
    match (near, far) {
        (Hold::Pin { local: a, place: p }, Hold::Pin { local: b, place: q }) => {
            LegCondition::Distance {
                a,
                b,
                length: (q - p).norm(),
            }
        }
        (Hold::Slide { frame, along }, Hold::Pin { local: b, place }) => {
            let inverse = frame.inverse();
            LegCondition::OnLineOfA {
                point: inverse * place,
                direction: inverse * along,
                b,
            }
        }
        (Hold::Pin { local: a, place }, Hold::Slide { frame, along }) => {
            let inverse = frame.inverse();
            LegCondition::OnLineOfB {
                point: inverse * place,
                direction: inverse * along,
                a,
            }
        }
        (Hold::Slide { frame: a, .. }, Hold::Slide { frame: b, .. }) => {
            LegCondition::Turned(a.rotation.inverse() * b.rotation)
        }
    }
}

/// The middle body's frame in a's frame, for a placement `relative` of b in a's frame.
fn middle([near, far]: &[Hold; 2], relative: &Placement) -> Option<Placement> {
    match (near, far) {
        (Hold::Pin { local: a, place: p }, Hold::Pin { local: b, place: q }) => {
            Some(turned_towards(*p, *q, *a, relative * b))
        }
        (Hold::Slide { frame, .. }, Hold::Pin { local: b, place }) => {
            Some(pinned(frame.rotation.inverse(), *place, relative * b))
        }
        (Hold::Pin { local: a, place }, Hold::Slide { frame, .. }) => {
            let turn = relative.rotation * frame.rotation.inverse();
            Some(pinned(turn, *place, *a))
        }
        (
            Hold::Slide {
                frame: fa,
                along: ua,
            },
            Hold::Slide {
                frame: fb,
                along: ub,
            },
        ) => {
            // In the middle frame a stands at fa + s ua and b at fb + t ub, and b is a times `relative`.
            let (from, to) = (fa.translation.vector, fb.translation.vector);
            let gap = to - from - fa.rotation * relative.translation.vector;
            let s = cross(gap, *ub) / cross(*ua, *ub);
            s.is_finite()
                .then(|| Placement::from_parts((from + ua * s).into(), fa.rotation).inverse())
        }
    }
}
