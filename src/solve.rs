use crate::Error;
use crate::construction::Solution;
use crate::mechanism::{Mechanism, mechanism};
use crate::position::{Pose, numbered_pose, pose, with_nearest_sides};
use crate::scene::{Scene, SizeLimit};
use crate::sheet::{Order, Sheet};

/// Solves a scene: position, velocities, accelerations and both plans.
///
/// ```
/// let scene = kinegon::Scene::read(include_str!("../examples/figure-2.json"))?;
/// let solution = kinegon::solve(&scene)?;
/// let link = solution.mechanism.link("4").expect("the scene has a link 4");
/// assert!((solution.motion.body(link).omega - -0.474663754894).abs() < 1e-12);
/// # Ok::<(), kinegon::Error>(())
/// ```
///
/// # Errors
/// It is no mechanism, cannot be assembled, or is in a singular position.
pub fn solve(scene: &Scene) -> Result<Solution, Error> {
    let (mechanism, pose) = posed(scene, SizeLimit::NUMBERS, None)?;
    Ok(Solution::new(scene.clone(), mechanism, pose, Order::Acceleration)?)
}

/// The mechanism of a scene in its position: in the assembly mode of that number, else in the one that `near` picks.
///
/// # Errors
/// The scene is too large for what is done with it, is no mechanism, or cannot be assembled.
pub fn posed(scene: &Scene, limit: SizeLimit, mode: Option<usize>) -> Result<(Mechanism, Pose), Error> {
    limit.check(scene)?;
    let mechanism = with_nearest_sides(scene, mechanism(scene)?);
    let pose = match mode {
        Some(mode) => numbered_pose(&mechanism, &scene.near, mode)?,
        None => pose(&mechanism, &scene.near)?,
    };
    Ok((mechanism, pose))
}

/// The order of the motion that a scene's figure needs: accelerations only if it shows them.
#[must_use]
pub fn order_of_figure(scene: &Scene) -> Order {
    let shows_accelerations = scene.figure.shown_panels().contains(&Sheet::Acceleration);
    let is_curved = scene.figure.shown_panels().contains(&Sheet::Centers) && !scene.figure.curvature.is_empty();
    if shows_accelerations || is_curved || !scene.figure.inflection.is_empty() {
        Order::Acceleration
    } else {
        Order::Velocity
    }
}
