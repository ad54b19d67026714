use crate::Error;
use crate::construction::Solution;
use crate::mechanism::mechanism;
use crate::motion::Order;
use crate::position::{pose, with_nearest_sides};
use crate::scene::Scene;

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
    let mechanism = with_nearest_sides(scene, mechanism(scene)?);
    let pose = pose(&mechanism, &scene.near)?;
    Ok(Solution::new(scene.clone(), mechanism, pose, Order::Acceleration)?)
}
