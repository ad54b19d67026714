//! Images of links in the plans: similar to the links, turned by 90° and ω times as large in the velocity plan, turned by the angle of
//! α over −ω² and √(α² + ω⁴) times as large in the acceleration plan (Mehmke's theorem).

use super::changes::{ACCELERATION_BOUND, BOUND, Sizes, U};
use kinegon::Order;
use kinegon::Solution;
use kinegon::construction::{Plan, coincident_name, image_name};
use kinegon::format::ResultFile;
use kinegon::geometry::{Point, Vector, quarter_turn};
use kinegon::mechanism::BodyId;

/// A point of a link and its image in a plan.
struct Imaged {
    name: String,
    place: Point,
    image: Vector,
}

/// The points of a link that have images.
fn images(solution: &Solution, plan: &Plan, link: BodyId) -> Vec<Imaged> {
    let Solution { mechanism, pose, construction, .. } = solution;
    let mut points = Vec::new();
    let mut see = |name: &str, place: Point| {
        if let Some(point) = plan.points.get(&image_name(name)) {
            points.push(Imaged { name: name.to_owned(), place, image: point.vector });
        }
    };
    let body = mechanism.body(link);
    for &point in &body.points {
        see(mechanism.point_name(point), pose.point(point));
    }
    for slider in mechanism.sliders.iter().filter(|s| s.on == link) {
        let name = coincident_name(mechanism.point_name(slider.at), &body.name);
        see(&name, pose.point(slider.at));
    }
    let special = construction.special.iter();
    for special in special.filter(|s| s.link == link) {
        if let Some(place) = special.place.finite() {
            see(&special.name, place);
        }
    }
    points
}

/// How far images are from similar to their links, in parts of what rounding allows: how many pairs of points were seen, and the
/// largest part with its name.
pub fn dissimilarity(solution: &Solution, result: &ResultFile, condition: f64) -> (usize, f64, String) {
    let sizes = Sizes::of(result);
    let (mut pairs, mut worst) = (0, (0.0, String::new()));
    for plan in solution.construction.plans() {
        for (link, body) in solution.mechanism.links() {
            let Some(rates) = result.links.get(&body.name) else {
                continue;
            };
            let (omega, omega_error) = (rates.omega, rates.omega_error);
            let [alpha, alpha_error] = [rates.alpha, rates.alpha_error].map(|x| x.unwrap_or(0.0));
            let points = images(solution, plan, link);
            for (i, p) in points.iter().enumerate() {
                for q in &points[..i] {
                    let side = q.place - p.place;
                    // Joints have exact places. A special point's errs with the square of its distance.
                    let far = (side.norm() / sizes.length).max(1.0);
                    let is_special = [p, q].iter().any(|x| x.name.starts_with('S'));
                    let blur = sizes.length * if is_special { far * far } else { 0.0 };
                    let (expected, size, error, bound) = match plan.order {
                        Order::Velocity => {
                            (quarter_turn(side) * omega, sizes.velocity + 2.0 * sizes.omega * blur, omega_error, BOUND)
                        }
                        _ => (
                            quarter_turn(side) * alpha - side * (omega * omega),
                            sizes.acceleration + 2.0 * (sizes.alpha + sizes.omega * sizes.omega) * blur,
                            alpha_error + 2.0 * omega.abs() * omega_error,
                            ACCELERATION_BOUND,
                        ),
                    };
                    let gap = (q.image - p.image - expected).norm();
                    let allowed = bound * U * condition * size + error * side.norm();
                    pairs += 1;
                    let part = if gap == 0.0 { 0.0 } else { gap / allowed };
                    if part.is_nan() || part > worst.0 {
                        worst = (part, format!("{:?}, link {}, {}{}", plan.order, body.name, p.name, q.name));
                    }
                }
            }
        }
    }
    (pairs, worst.0, worst.1)
}
