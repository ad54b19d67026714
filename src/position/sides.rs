use super::nearest::nearest;
use super::rough::Rough;
use super::tree::Tree;
use crate::mechanism::{Mechanism, mirrored_mechanism};
use crate::scene::{GivenBy, Scene};

/// Most nearly flat triangles all of whose sides are tried together; of more, one is turned over at a time.
const TOGETHER: usize = 5;

/// Ratio of the distances from `near`, root mean square, below which the choice of a side is said.
const CLEAR: f64 = 3.0;

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
            chosen.warnings.push(format!(
                "link {name}: its points lie nearly on a line, and `near` fits its triangle and the mirror image almost equally well; \
                 the nearer one is taken. Give its `shape`, or places in `near` with more digits, to choose"
            ));
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
    let mechanism = mechanism.for_positions();
    let rough = Rough::new(mechanism, &scene.near);
    let nearest = nearest(&mut Tree::new(mechanism, &rough), &rough)?;
    Some(nearest.whole.distance_from(&rough, mechanism))
}
