//! Names of plan points and how they are written.

use crate::mechanism::{BodyId, Mechanism, PointId};

/// The image of a point: its name in lower case, but for a link's name after `_`, as in `d_2` for `D_2`.
///
/// The poles' own names are taken: the image of P is `p'`, that of P' is `p''`.
#[must_use]
pub fn image_name(point: &str) -> String {
    let (point, link) = match point.split_once('_') {
        Some((point, link)) => (point, Some(link)),
        None => (point, None),
    };
    let mut image = point.to_lowercase();
    if link.is_none() && matches!(image.trim_end_matches('\''), "p" | "π") {
        image.push('\'');
    }
    match link {
        Some(link) => format!("{image}_{link}"),
        None => image,
    }
}

/// The end of the normal part laid off from the image of `start` on the way to special point `special`, as in `n_b3`.
#[must_use]
pub fn normal_name(start: &str, special: &str) -> String {
    let link = special.strip_prefix('S').unwrap_or(special);
    format!("n_{}{link}", image_name(start))
}

/// The end of what a driven slider adds along its guide, laid off from plan point `start`, as in `r_a3`: sliding velocity or
/// acceleration of link 3. `entered` are the names of the links that the driven sliders lead to, one after the other.
#[must_use]
pub fn slide_name(start: &str, entered: &str) -> String {
    format!("r_{start}{entered}")
}

/// The end of the Coriolis acceleration of a driven slider, laid off after its sliding acceleration, as in `k_a3`.
#[must_use]
pub fn coriolis_name(start: &str, entered: &str) -> String {
    format!("k_{start}{entered}")
}

/// The point of `body` that lies under `point`, as in `D_2`.
#[must_use]
pub fn coincident_name(point: &str, body: &str) -> String {
    format!("{point}_{body}")
}

/// The point of a body at `point`, as it is called: `B` where it is the body's own, else `B_2`.
#[must_use]
pub fn point_on(mechanism: &Mechanism, body: BodyId, point: PointId) -> String {
    let (name, body) = (mechanism.point_name(point), mechanism.body(body));
    if body.points.contains(&point) { name.to_owned() } else { coincident_name(name, &body.name) }
}

/// A name as it is written: what follows the first `_` and trailing digits are set low, as in `n_{b3}`, `S_{3}`.
#[must_use]
pub fn display(name: &str) -> String {
    let (base, low) = match name.split_once('_') {
        Some((base, low)) => (base, low),
        None => {
            let digits = name.trim_end_matches(|c: char| c.is_ascii_digit()).len();
            name.split_at(digits)
        }
    };
    if low.is_empty() || base.is_empty() { name.to_owned() } else { format!("{base}_{{{low}}}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_as_on_the_blackboard() {
        assert_eq!(image_name("S3"), "s3");
        assert_eq!(image_name("P"), "p'");
        assert_eq!(image_name("P'"), "p''");
        assert_eq!(image_name("P_3"), "p_3");
        assert_eq!(normal_name("B", "S3"), "n_b3");
        assert_eq!(display("n_b3"), "n_{b3}");
        assert_eq!(display("S3"), "S_{3}");
        assert_eq!(display("B"), "B");
        assert_eq!(display("12"), "12");
    }
}
