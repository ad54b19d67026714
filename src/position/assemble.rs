use super::closing::places;
use super::modes::NoMode;
use super::nearest::nearest;
use super::reach::ranges;
use super::says;
use super::tree::{Count, Listing, Tree, WholeAssembly, counted};
use super::{Assembly, AssemblyError, Pose};
use crate::geometry::{Point, Vector, span, unit};
use crate::mechanism::{Guide, Mechanism, PointId, Role, mirrored_mechanism};
use crate::message::Message;
use crate::scene::{GivenBy, Near, Scene};

/// Most assemblies of a whole mechanism that are listed.
const MOST_LISTED: usize = 4096;

/// Most places of points in all that are listed: as many as a person can search, and some tens of megabytes.
const MOST_PLACES: usize = 400_000;

/// Most work, as [`Assembler::work`](super::modes::Assembler) counts it, for the number of all assemblies: that of a chain of 18 dyads or more.
const MOST_WORK: usize = 20_000_000;

/// Most work for a number of assemblies that only stands in a warning.
const LITTLE_WORK: usize = 2_000_000;

/// Distance of a point from its rough place, in parts of the mechanism's size, above which a person means another place.
const FAR: f64 = 0.22;

/// Number of assemblies that a warning lists.
const LISTED: usize = 8;

/// Lengths must lie between the inverse of this and this: closing a loop takes their fourth powers.
const LARGEST: f64 = 1e70;

/// Most nearly flat triangles all of whose sides are tried together; of more, one is turned over at a time.
const TOGETHER: usize = 5;

/// Ratio of the distances from `near`, root mean square, below which the choice of a side is said.
const CLEAR: f64 = 3.0;

/// The pose of a mechanism: as drawn, or assembled from its lengths in the way nearest to `near`.
///
/// Nearest is the least sum of squared distances from all rough places together; without any the first assembly is
/// taken. That no other assembly is nearer is proven, or a warning says that it is not.
pub fn pose(mechanism: &Mechanism, near: &Near) -> Result<Pose, AssemblyError> {
    if mechanism.given_by == GivenBy::Drawing {
        return Ok(drawn_pose(mechanism));
    }
    let mut tree = tree(mechanism, near)?;
    let (mut whole, remarks) =
        if tree.assembler.rough.count() == 0 { first(mechanism, &mut tree) } else { closest(mechanism, &mut tree) }?;
    if mechanism.placing.is_some() {
        let assembly = number(&mut tree, &whole);
        whole.assemblies = vec![assembly; mechanism.groups.len()];
    }
    let mut pose = whole.pose(mechanism);
    pose.warnings.extend(remarks);
    Ok(pose)
}

/// Assemblies of a mechanism, and how many there are.
#[derive(Clone, Debug)]
pub struct Listed {
    /// All assemblies; of more than 4096, or of fewer with more than 400 000 places of points, the first so many.
    pub poses: Vec<Pose>,
    /// How many there are.
    pub count: Count,
}

/// Every real assembly of a mechanism from its lengths, of more than 4096 or with more than 400 000 places of points the
/// first so many; of a drawn configuration its one pose.
///
/// The modes of a group are numbered by the angle of its first rotating link, counter-clockwise from +x; the
/// mechanism's assemblies by the modes of its groups, of which the first group's is the most significant. Where a
/// link's angle is given in place of a drive's, the groups are those of [`Placing`](crate::mechanism::Placing), and
/// each group of the pose has the number of the mechanism's assembly, unless there are too many to count.
///
/// A slotted lever with one point coincides with itself turned by 180° and counts once, with its slider on the positive
/// side of the guide's `through`; both orientations are listed where `near` gives its angle.
pub fn poses(mechanism: &Mechanism, near: &Near) -> Result<Vec<Pose>, AssemblyError> {
    Ok(counted_poses(mechanism, near)?.poses)
}

/// The assemblies that [`poses`] lists, and how many there are in all.
pub fn counted_poses(mechanism: &Mechanism, near: &Near) -> Result<Listed, AssemblyError> {
    if mechanism.given_by == GivenBy::Drawing {
        return Ok(Listed { poses: vec![drawn_pose(mechanism)], count: Count { number: 1, is_exact: true } });
    }
    let mut tree = tree(mechanism, near)?;
    let most = MOST_LISTED.min(MOST_PLACES / mechanism.points.len().max(1)).max(2);
    let (mut found, is_all) = listed(mechanism, &mut tree, most + 1)?;
    let mut count = Count { number: found.len() as u64, is_exact: is_all };
    if !is_all {
        let all = counted(&mut tree, MOST_WORK);
        count = Count { number: all.number.max(count.number), ..all };
    }
    found.truncate(most);
    if mechanism.placing.is_some() {
        let modes = usize::try_from(count.number).ok().filter(|_| count.is_exact);
        for (index, whole) in found.iter_mut().enumerate() {
            let assembly = modes.map(|modes| Assembly::of_whole(index + 1, modes));
            whole.assemblies = vec![assembly; mechanism.groups.len()];
        }
    }
    Ok(Listed { poses: found.into_iter().map(|whole| whole.pose(mechanism)).collect(), count })
}

/// The first assemblies that [`poses`] lists, `most` at most.
pub(crate) fn first_poses(mechanism: &Mechanism, near: &Near, most: usize) -> Result<Vec<Pose>, AssemblyError> {
    if mechanism.given_by == GivenBy::Drawing {
        return Ok(vec![drawn_pose(mechanism)]);
    }
    let mut tree = tree(mechanism, near)?;
    let (found, _) = listed(mechanism, &mut tree, most.max(1))?;
    Ok(found.into_iter().map(|whole| whole.pose(mechanism)).collect())
}

/// The assembly of that number, counted from 1, in the order of [`poses`].
pub fn numbered_pose(mechanism: &Mechanism, near: &Near, mode: usize) -> Result<Pose, AssemblyError> {
    let none = |count, is_exact| match is_exact {
        true => AssemblyError::NoSuchMode { mode, count },
        false => AssemblyError::TooManyModes { mode, count },
    };
    if mechanism.given_by == GivenBy::Drawing {
        return if mode == 1 { Ok(drawn_pose(mechanism)) } else { Err(none(1, true)) };
    }
    let mut tree = tree(mechanism, near)?;
    let mut listing = Listing::new(&mut tree, MOST_WORK);
    let mut count = 0;
    let found = listing.by_ref().inspect(|_| count += 1).take(mode).last().filter(|_| mode > 0);
    let Some(mut whole) = found.filter(|_| count == mode) else {
        return Err(match (count, listing.is_stopped) {
            (0, _) => no_assembly(mechanism, listing),
            (_, is_stopped) => none(count, !is_stopped),
        });
    };
    if mechanism.placing.is_some() {
        let all = counted(&mut tree, MOST_WORK);
        let modes = usize::try_from(all.number).ok().filter(|_| all.is_exact);
        whole.assemblies = vec![modes.map(|modes| Assembly::of_whole(mode, modes)); mechanism.groups.len()];
    }
    Ok(whole.pose(mechanism))
}

/// Whether it can be assembled as its drives stand.
pub(super) fn can_be_assembled(mechanism: &Mechanism) -> bool {
    tree(mechanism, &Near::default()).is_ok_and(|mut tree| Listing::new(&mut tree, LITTLE_WORK).next().is_some())
}

/// The assemblies of a mechanism whose lengths are of a size to assemble from.
fn tree<'a>(mechanism: &'a Mechanism, near: &Near) -> Result<Tree<'a>, AssemblyError> {
    let bodies = mechanism.bodies.iter();
    let spans = bodies.map(|b| span(b.local.iter().copied()));
    let size = spans.fold(0.0, f64::max);
    match size == 0.0 || (1.0 / LARGEST..=LARGEST).contains(&size) {
        true => Ok(Tree::new(mechanism.for_positions(), near)),
        false => Err(AssemblyError::Size { size, is_large: size > LARGEST }),
    }
}

/// The first assembly, with a warning if it is not the only one.
fn first(mechanism: &Mechanism, tree: &mut Tree<'_>) -> Result<(WholeAssembly, Vec<Message>), AssemblyError> {
    let (found, is_all) = listed(mechanism, tree, LISTED + 1)?;
    let warning = (found.len() > 1).then(|| {
        let number = found.len() as u64;
        let count = if is_all { Count { number, is_exact: true } } else { counted(tree, LITTLE_WORK) };
        not_chosen(tree.mechanism, &found, Count { number: count.number.max(number), ..count })
    });
    let mut found = found.into_iter();
    let first = found.next().expect("a listing has at least one");
    Ok((first, warning.into_iter().collect()))
}

/// The assembly nearest to the rough places, with warnings about the choice.
fn closest(mechanism: &Mechanism, tree: &mut Tree<'_>) -> Result<(WholeAssembly, Vec<Message>), AssemblyError> {
    let Some(nearest) = nearest(tree) else {
        return match listed(mechanism, tree, 1)?.0.pop() {
            Some(whole) => Ok((whole, vec![says::unproven()])),
            None => Err(AssemblyError::TooMuchWork),
        };
    };
    let remark = far_remark(tree, &nearest.whole);
    let unproven = (!nearest.is_proven).then(says::unproven);
    Ok((nearest.whole, unproven.into_iter().chain(remark).collect()))
}

/// The first assemblies, `most` at most, and whether these are all.
fn listed(
    mechanism: &Mechanism,
    tree: &mut Tree<'_>,
    most: usize,
) -> Result<(Vec<WholeAssembly>, bool), AssemblyError> {
    let mut listing = Listing::new(tree, MOST_WORK);
    let found: Vec<WholeAssembly> = listing.by_ref().take(most).collect();
    if found.is_empty() {
        return Err(no_assembly(mechanism, listing));
    }
    let is_all = found.len() < most && !listing.is_stopped;
    Ok((found, is_all))
}

/// The error that a listing is empty.
fn no_assembly(whole: &Mechanism, listing: Listing<'_, '_>) -> AssemblyError {
    match listing.failure {
        Some((group, no_mode)) if !listing.is_stopped => {
            let mechanism = whole.for_positions();
            let (links, at) = (mechanism.groups[group].link_names(mechanism), given_angles(whole));
            match no_mode {
                NoMode::Apart(miss) => AssemblyError::NoMode { links, at, miss, ranges: ranges(whole) },
                NoMode::Parallel(link) => AssemblyError::ParallelGuides { links, link },
                NoMode::Moves => AssemblyError::Moves { links },
                NoMode::NotFound(tried) => AssemblyError::NotFound { links, at, tried },
            }
        }
        _ => AssemblyError::TooMuchWork,
    }
}

/// The number of an assembly among all; none where these are too many to count.
fn number(tree: &mut Tree<'_>, whole: &WholeAssembly) -> Option<Assembly> {
    let mut listing = Listing::new(tree, LITTLE_WORK);
    let same = |other: &WholeAssembly| other.assemblies == whole.assemblies;
    let mode = listing.position(|other| same(&other))? + 1;
    let rest = listing.by_ref().count();
    (!listing.is_stopped).then_some(Assembly::of_whole(mode, mode + rest))
}

/// The given drive angles and positions, as ` at angle(1) = 70°`.
fn given_angles(mechanism: &Mechanism) -> Message {
    let turned = mechanism.bodies.iter().filter_map(|b| match b.role {
        Role::Driver { angle: Some(angle), .. } => {
            Some(says::at_value(format!("angle({})", b.name), format!("{angle}°")))
        }
        _ => None,
    });
    let pushed = mechanism.slider_ids().filter_map(|id| {
        let position = mechanism.slider(id).drive?.position?;
        let name = mechanism.push_name(id);
        Some(says::at_value(format!("position({name})"), position))
    });
    let placed = mechanism.placing.iter().map(|placing| {
        let name = &mechanism.body(placing.link).name;
        says::at_value(format!("angle({name})"), format!("{}°", placing.angle))
    });
    Message::list(turned.chain(pushed).chain(placed), ",")
}

/// The warning that the nearest assembly is far from `near`: as a whole, or else in one of its places.
fn far_remark(tree: &mut Tree<'_>, nearest: &WholeAssembly) -> Option<Message> {
    let mechanism = tree.mechanism;
    let (points, _) = places(mechanism, &nearest.frames);
    let size = span(points.iter().copied());
    let distance = tree.distance(nearest);
    if distance > 0.5 * size {
        let count = counted(tree, LITTLE_WORK).told();
        return Some(says::far_off(format!("{distance:.4}"), count, format!("{size:.4}")));
    }
    let off = |&(p, rough): &(PointId, Point)| (p, (points[p.0] - rough).norm());
    let (point, off) = tree.assembler.rough.points.iter().map(off).max_by(|a, b| a.1.total_cmp(&b.1))?;
    (off > FAR * size).then(|| {
        let (name, place) = (mechanism.point_name(point), points[point.0]);
        let [x, y, off] = [place.x, place.y, off].map(|number| format!("{number:.4}"));
        says::point_far_off(name, x, y, off, counted(tree, LITTLE_WORK).told())
    })
}

/// The warning that `near` does not choose, with the first assemblies listed.
fn not_chosen(mechanism: &Mechanism, first: &[WholeAssembly], count: Count) -> Message {
    let listed = first.iter().take(LISTED).enumerate().map(|(index, whole)| {
        let (points, _) = places(mechanism, &whole.frames);
        let places = mechanism.inner_points().into_iter().map(|p| {
            let q = points[p.0];
            format!("{} ({:.2}, {:.2})", mechanism.point_name(p), q.x, q.y)
        });
        format!("{}: {}", index + 1, places.collect::<Vec<_>>().join(" "))
    });
    let listed = listed.collect::<Vec<_>>().join("; ");
    let more = if first.len() > LISTED { "; …" } else { "" };
    let links: Vec<String> = mechanism.groups.iter().map(|g| g.link_names(mechanism)).collect();
    says::not_chosen(links.join(", "), count.told(), listed + more)
}

/// The pose of a drawn configuration: the scene's coordinates, unchanged.
fn drawn_pose(mechanism: &Mechanism) -> Pose {
    // Reading the scene has checked that every point has a place.
    let places = mechanism.given.iter();
    let points: Vec<Point> = places.map(|p| p.unwrap_or_else(Point::origin)).collect();
    let guides: Vec<Vector> = mechanism
        .sliders
        .iter()
        .map(|slider| match slider.guide {
            Guide::DrawnBetween(a, b) => unit(points[b.0] - points[a.0]).unwrap_or_else(Vector::x),
            Guide::Drawn(direction) | Guide::Local { direction, .. } => direction,
        })
        .collect();
    let axes = mechanism.bodies.iter().enumerate();
    let axes = axes.map(|(index, body)| match body.points.as_slice() {
        _ if body.role == Role::Ground || body.is_nameless() => None,
        [a, b, ..] => Some(points[b.0] - points[a.0]),
        // The axis of a link with one point is its guide.
        _ => {
            let mut sliders = mechanism.sliders.iter().zip(&guides);
            let guide = sliders.find(|(s, _)| s.on.0 == index || s.link.0 == index);
            guide.map(|(_, direction)| *direction)
        }
    });
    let slides = mechanism.sliders.iter().zip(&guides).map(|(slider, along)| {
        let from = slider.counted_from?;
        Some((points[slider.at.0] - points[from.0]).dot(along))
    });
    Pose {
        slides: slides.collect(),
        axes: axes.collect(),
        assemblies: vec![None; mechanism.groups.len()],
        points,
        guides,
        warnings: Vec::new(),
    }
}

/// The mechanism of a scene with its nearly flat triangles on the sides on which the nearest assembly is nearest to
/// `near`, with a warning where the other side is nearly as good.
///
/// Three lengths fit a triangle and its mirror image. Rough places of all three points tell which, unless the triangle is
/// so flat that a small error of theirs turns it over: then all of `near` decides.
pub fn with_nearest_sides(scene: &Scene, mechanism: Mechanism) -> Mechanism {
    if mechanism.doubtful_sides.is_empty() || mechanism.given_by == GivenBy::Drawing {
        return mechanism;
    }
    let names: Vec<String> = mechanism.doubtful_sides.iter().map(|&id| mechanism.body(id).name.clone()).collect();
    let trials: Vec<(Vec<bool>, f64)> = trials(names.len())
        .map(|turned| {
            let mechanism = turned_over(scene, &names, &turned);
            let distance = mechanism.and_then(|mechanism| distance(scene, &mechanism));
            (turned, distance.unwrap_or(f64::INFINITY))
        })
        .collect();
    let Some((best, least)) = trials.iter().min_by(|a, b| a.1.total_cmp(&b.1)) else {
        return mechanism;
    };
    let mut chosen = match best.contains(&true) {
        true => turned_over(scene, &names, best).unwrap_or(mechanism),
        false => mechanism,
    };
    for (link, name) in names.iter().enumerate() {
        let others = trials.iter().filter(|(turned, _)| turned[link] != best[link]).map(|(_, distance)| *distance);
        if others.fold(f64::INFINITY, f64::min) < CLEAR * least {
            chosen.warnings.push(says::nearly_flat(name));
        }
    }
    chosen
}

/// The mechanism with some of these links turned over.
fn turned_over(scene: &Scene, names: &[String], turned: &[bool]) -> Option<Mechanism> {
    let links = names.iter().zip(turned).filter(|(_, turned)| **turned);
    let links: Vec<&str> = links.map(|(name, _)| name.as_str()).collect();
    mirrored_mechanism(scene, &links).ok()
}

/// Which links are turned over in one trial after another: none in the first.
fn trials(links: usize) -> impl Iterator<Item = Vec<bool>> {
    let count = if links <= TOGETHER { 1 << links } else { 1 + links };
    (0..count).map(move |trial| match links <= TOGETHER {
        true => (0..links).map(|link| trial >> link & 1 == 1).collect(),
        false => (1..=links).map(|link| link == trial).collect(),
    })
}

/// The distance of a mechanism's nearest assembly from `near`; none if it has none.
fn distance(scene: &Scene, mechanism: &Mechanism) -> Option<f64> {
    let mut tree = Tree::new(mechanism.for_positions(), &scene.near);
    let nearest = nearest(&mut tree)?;
    Some(tree.distance(&nearest.whole))
}
