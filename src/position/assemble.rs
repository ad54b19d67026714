use super::count::{Count, counted};
use super::drawn::drawn_pose;
use super::listing::Listing;
use super::modes::NoMode;
use super::nearest::nearest;
use super::rough::{LISTED, Rough, not_chosen};
use super::tree::{Tree, Way};
use super::{Assembly, AssemblyError, Pose};
use crate::geometry::span;
use crate::mechanism::{Mechanism, Role, SliderId};
use crate::scene::{GivenBy, Near};

/// Most assemblies of a whole mechanism that are listed.
const MOST_LISTED: usize = 4096;

/// Most work, as [`Tree::work`] counts it, for the number of all assemblies: that of a chain of 18 dyads or more.
const MOST_WORK: usize = 20_000_000;

/// The same for a number that only stands in a warning.
const LITTLE_WORK: usize = 2_000_000;

/// Lengths must lie between the inverse of this and this: closing a loop takes their fourth powers.
const LARGEST: f64 = 1e70;

/// The pose of a mechanism: as drawn, or assembled from its lengths in the way nearest to `near`.
///
/// Nearest is the least sum of squared distances from all rough places together; without any the first assembly is
/// taken. That no other assembly is nearer is proven, or a warning says that it is not.
pub fn pose(mechanism: &Mechanism, near: &Near) -> Result<Pose, AssemblyError> {
    if mechanism.given_by == GivenBy::Drawing {
        return Ok(drawn_pose(mechanism));
    }
    check_size(mechanism)?;
    let rough = Rough::new(mechanism.for_positions(), near);
    let mut tree = Tree::new(mechanism.for_positions(), &rough);
    let (mut way, remarks) =
        if rough.is_empty() { first(mechanism, &mut tree) } else { closest(mechanism, &mut tree, &rough) }?;
    if mechanism.placing.is_some() {
        let assembly = number(&mut tree, &way);
        way.assemblies = vec![assembly; mechanism.groups.len()];
    }
    let mut pose = way.pose(mechanism);
    pose.warnings.extend(remarks);
    Ok(pose)
}

/// Assemblies of a mechanism, and how many there are.
#[derive(Clone, Debug)]
pub struct Listed {
    /// All assemblies; of more than 4096 the first so many.
    pub poses: Vec<Pose>,
    /// How many there are.
    pub count: Count,
}

/// Every real assembly of a mechanism from its lengths, of more than 4096 the first so many; of a drawn configuration
/// its one pose.
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
    check_size(mechanism)?;
    let rough = Rough::new(mechanism.for_positions(), near);
    let mut tree = Tree::new(mechanism.for_positions(), &rough);
    let (mut ways, is_all) = listed(mechanism, &mut tree, MOST_LISTED + 1)?;
    let mut count = Count { number: ways.len() as u64, is_exact: is_all };
    if !is_all {
        let all = counted(&mut tree, MOST_WORK);
        count = Count { number: all.number.max(count.number), ..all };
    }
    ways.truncate(MOST_LISTED);
    if mechanism.placing.is_some() {
        let modes = usize::try_from(count.number).ok().filter(|_| count.is_exact);
        for (index, way) in ways.iter_mut().enumerate() {
            let assembly = modes.map(|modes| Assembly { mode: index + 1, modes });
            way.assemblies = vec![assembly; mechanism.groups.len()];
        }
    }
    Ok(Listed { poses: ways.into_iter().map(|way| way.pose(mechanism)).collect(), count })
}

/// The first assemblies that [`poses`] lists, `most` at most.
pub fn first_poses(mechanism: &Mechanism, near: &Near, most: usize) -> Result<Vec<Pose>, AssemblyError> {
    if mechanism.given_by == GivenBy::Drawing {
        return Ok(vec![drawn_pose(mechanism)]);
    }
    check_size(mechanism)?;
    let rough = Rough::new(mechanism.for_positions(), near);
    let mut tree = Tree::new(mechanism.for_positions(), &rough);
    let (ways, _) = listed(mechanism, &mut tree, most.max(1))?;
    Ok(ways.into_iter().map(|way| way.pose(mechanism)).collect())
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
    check_size(mechanism)?;
    let rough = Rough::new(mechanism.for_positions(), near);
    let mut tree = Tree::new(mechanism.for_positions(), &rough);
    let mut listing = Listing::new(&mut tree, MOST_WORK);
    let mut count = 0;
    let found = listing.by_ref().inspect(|_| count += 1).take(mode).last().filter(|_| mode > 0);
    let Some(mut way) = found.filter(|_| count == mode) else {
        return Err(match (count, listing.is_stopped) {
            (0, _) => no_assembly(mechanism, listing),
            (_, is_stopped) => none(count, !is_stopped),
        });
    };
    if mechanism.placing.is_some() {
        let modes = exact_number(&mut tree);
        way.assemblies = vec![modes.map(|modes| Assembly { mode, modes }); mechanism.groups.len()];
    }
    Ok(way.pose(mechanism))
}

fn check_size(mechanism: &Mechanism) -> Result<(), AssemblyError> {
    let bodies = mechanism.bodies.iter();
    let spans = bodies.map(|b| span(b.local.iter().copied()));
    let size = spans.fold(0.0, f64::max);
    let way = if size > LARGEST { "large" } else { "small" };
    match size == 0.0 || (1.0 / LARGEST..=LARGEST).contains(&size) {
        true => Ok(()),
        false => Err(AssemblyError::Size { size, way }),
    }
}

/// The first assembly, with a warning if it is not the only one.
fn first(mechanism: &Mechanism, tree: &mut Tree<'_>) -> Result<(Way, Vec<String>), AssemblyError> {
    let (ways, is_all) = listed(mechanism, tree, LISTED + 1)?;
    let warning = (ways.len() > 1).then(|| {
        let number = ways.len() as u64;
        let count = if is_all { Count { number, is_exact: true } } else { counted(tree, LITTLE_WORK) };
        not_chosen(tree.mechanism, &ways, Count { number: count.number.max(number), ..count })
    });
    let mut ways = ways.into_iter();
    let first = ways.next().expect("a listing has at least one");
    Ok((first, warning.into_iter().collect()))
}

/// The assembly nearest to the rough places, with warnings about the choice.
fn closest(mechanism: &Mechanism, tree: &mut Tree<'_>, rough: &Rough) -> Result<(Way, Vec<String>), AssemblyError> {
    let Some(nearest) = nearest(tree, rough) else {
        return match listed(mechanism, tree, 1)?.0.pop() {
            Some(way) => Ok((way, vec![unproven()])),
            None => Err(AssemblyError::TooMuchWork),
        };
    };
    let remark = rough.remark(tree.mechanism, &nearest.way, || counted(tree, LITTLE_WORK));
    let unproven = (!nearest.is_proven).then(unproven);
    Ok((nearest.way, unproven.into_iter().chain(remark).collect()))
}

fn unproven() -> String {
    "`near` leaves too many assemblies open to compare them all, and the one taken may not be the nearest: give rough places of more points in it"
        .to_owned()
}

/// The first assemblies, `most` at most, and whether these are all.
fn listed(mechanism: &Mechanism, tree: &mut Tree<'_>, most: usize) -> Result<(Vec<Way>, bool), AssemblyError> {
    let mut listing = Listing::new(tree, MOST_WORK);
    let ways: Vec<Way> = listing.by_ref().take(most).collect();
    if ways.is_empty() {
        return Err(no_assembly(mechanism, listing));
    }
    let is_all = ways.len() < most && !listing.is_stopped;
    Ok((ways, is_all))
}

/// The error that a listing is empty.
fn no_assembly(whole: &Mechanism, listing: Listing<'_, '_>) -> AssemblyError {
    let is_stopped = listing.is_stopped;
    match listing.failure() {
        Some((group, no_mode)) if !is_stopped => {
            let mechanism = whole.for_positions();
            let (links, at) = (mechanism.groups[group].link_names(mechanism), given_angles(whole));
            match no_mode {
                NoMode::Apart(miss) => AssemblyError::NoMode { links, at, miss },
                NoMode::NotFound(tried) => AssemblyError::NotFound { links, at, tried },
            }
        }
        _ => AssemblyError::TooMuchWork,
    }
}

/// The number of an assembly among all; none where these are too many to count.
fn number(tree: &mut Tree<'_>, way: &Way) -> Option<Assembly> {
    let mut listing = Listing::new(tree, LITTLE_WORK);
    let same = |other: &Way| other.assemblies == way.assemblies;
    let mode = listing.position(|other| same(&other))? + 1;
    let rest = listing.by_ref().count();
    (!listing.is_stopped).then_some(Assembly { mode, modes: mode + rest })
}

/// The number of all assemblies, if they are not too many to count.
fn exact_number(tree: &mut Tree<'_>) -> Option<usize> {
    let count = counted(tree, MOST_WORK);
    usize::try_from(count.number).ok().filter(|_| count.is_exact)
}

/// The given drive angles and positions in words, as in ` at angle(1) = 70°`.
fn given_angles(mechanism: &Mechanism) -> String {
    let turned = mechanism.bodies.iter().filter_map(|b| match b.role {
        Role::Driver { angle: Some(angle), .. } => Some(format!(" at angle({}) = {angle}°", b.name)),
        _ => None,
    });
    let pushed = (0..mechanism.sliders.len()).map(SliderId).filter_map(|id| {
        let position = mechanism.slider(id).drive?.position?;
        let name = mechanism.push_name(id);
        Some(format!(" at position({name}) = {position}"))
    });
    let placed = mechanism.placing.iter().map(|placing| {
        let name = &mechanism.body(placing.link).name;
        format!(" at angle({name}) = {}°", placing.angle)
    });
    turned.chain(pushed).chain(placed).collect::<Vec<_>>().join(",")
}
