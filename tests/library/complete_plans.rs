//! Every point of every link has its image in both plans: at the end of its velocity and its acceleration, and so that
//! the image of a link is similar to the link.

use kinegon::Order;
use kinegon::Solution;
use kinegon::construction::{Plan, image_name};
use kinegon::geometry::Vector;
use kinegon::mechanism::BodyId;
use support::files::{list, read, scenes};
use support::planted::{Planted, pattern};
use support::random::Random;
use support::stages::solved;

/// Largest error, in parts of the largest vector of the plan.
const MOST: f64 = 1e-12;

/// Random groups of each of the classes II to IV; every link has a point that no joint holds.
const GROUPS: usize = 170;

/// Largest condition number of a random group's position: there the numbers to compare with have all digits asked for.
const CONDITION: f64 = 1e3;

/// Templates, examples, worked cases, scenes of a lecture, random mechanisms. All with whole plans.
fn all_scenes() -> Vec<(String, String)> {
    let folders = ["templates", "examples", "tests/templates", "tests/driven_sliders", "tests/lecture"];
    let mut all: Vec<(String, String)> = folders.iter().flat_map(|folder| scenes(folder)).collect();
    for (_, text) in &mut all {
        *text = text.replace("\"construction\": \"paper\"", "\"construction\": true");
    }
    for case in list("tests/worked") {
        for scene in ["scene", "drawn"] {
            let file = format!("tests/worked/{case}/{scene}.json");
            if support::files::path(&file).exists() {
                all.push((file.clone(), read(&file)));
            }
        }
    }
    for (class, seed) in [("II", 0x21), ("III", 0x31), ("IV", 0x41)] {
        all.extend(random_groups(class, Random(seed)));
    }
    all
}

/// Random groups of a class on a crank, in half of them a link that a driven slider cuts in two.
fn random_groups(class: &str, mut random: Random) -> Vec<(String, String)> {
    let mut groups = Vec::new();
    while groups.len() < GROUPS {
        let (kinds, joints) = pattern(&mut random, class);
        let mut planted = Planted::new(&mut random, &kinds, &joints);
        if groups.len() % 2 == 1 {
            planted.cut(&mut random);
        }
        if planted.condition() <= CONDITION {
            groups.push((format!("{class} {kinds} {}", groups.len()), planted.scene()));
        }
    }
    groups
}

/// The images of a link's points with their true vectors and their places; the names of those that have none.
struct Image {
    places: Vec<Vector>,
    images: Vec<Vector>,
    missing: Vec<String>,
    worst: f64,
}

fn image(solution: &Solution, plan: &Plan, link: BodyId) -> Image {
    let Solution { mechanism, pose, motion, .. } = solution;
    let size = plan.points.values().map(|p| p.vector.norm()).fold(0.0, f64::max);
    let mut image = Image { places: Vec::new(), images: Vec::new(), missing: Vec::new(), worst: 0.0 };
    for &point in &mechanism.body(link).points {
        let (name, place) = (mechanism.point_name(point), pose.point(point));
        let Some(drawn) = plan.points.get(&image_name(name)) else {
            image.missing.push(name.to_owned());
            continue;
        };
        let rates = motion.body(link);
        let truth = match plan.order {
            Order::Velocity => rates.velocity_at(place),
            _ => rates.acceleration_at(place),
        };
        let error = (drawn.vector - truth).norm();
        image.worst = image.worst.max(if size > 0.0 { error / size } else { error });
        image.places.push(place.coords);
        image.images.push(drawn.vector);
    }
    image
}

#[test]
fn every_point_has_an_image_at_the_end_of_its_vector() {
    let (mut points, mut faults) = (0, Vec::new());
    for (name, text) in all_scenes() {
        let Ok(solution) = solved(&text) else { continue };
        for plan in solution.construction.plans() {
            for (link, body) in solution.mechanism.links() {
                let image = image(&solution, plan, link);
                points += image.images.len();
                if !image.missing.is_empty() {
                    faults
                        .push(format!("{name}, {:?}, link {}: no image of {:?}", plan.order, body.name, image.missing));
                }
                if image.worst > MOST || image.worst.is_nan() {
                    faults.push(format!("{name}, {:?}, link {}: off by {:e}", plan.order, body.name, image.worst));
                }
            }
        }
    }
    println!("{points} images");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(points > 6000, "{points}");
}

#[test]
fn the_image_of_a_link_is_similar_to_it() {
    let (mut links, mut faults) = (0, Vec::new());
    for (name, text) in all_scenes() {
        let Ok(solution) = solved(&text) else { continue };
        for plan in solution.construction.plans() {
            let size = plan.points.values().map(|p| p.vector.norm()).fold(0.0, f64::max);
            for (link, body) in solution.mechanism.links() {
                let Image { places, images, .. } = image(&solution, plan, link);
                // As complex numbers: (c' − a') (b − a) = (b' − a') (c − a), where all sides turn and grow alike.
                let (Some(a), Some(b)) = (places.first(), places.get(1)) else { continue };
                let times = |p: Vector, q: Vector| Vector::new(p.x * q.x - p.y * q.y, p.x * q.y + p.y * q.x);
                for (c, image) in places.iter().zip(&images).skip(2) {
                    let [whole, part] = [times(image - images[0], b - a), times(images[1] - images[0], c - a)];
                    let (off, allowed) = ((whole - part).norm(), MOST * size * ((b - a).norm() + (c - a).norm()));
                    links += 1;
                    if off > allowed {
                        faults.push(format!(
                            "{name}, {:?}, link {}: {off:e}, allowed {allowed:e}",
                            plan.order, body.name
                        ));
                    }
                }
            }
        }
    }
    println!("{links} images of three points");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(links > 1500, "{links}");
}
