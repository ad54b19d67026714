//! Names of plan points, and their subscripts.

use crate::mechanism::{BodyId, Mechanism, PointId};

/// Name of the image of a point: in lower case, but for a link's name after `_`, as in `d_2` for `D_2`.
///
/// `p` and `π` are the poles: the image of P is `p'`, that of P' is `p''`.
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

/// Name of the end of the normal part laid off from the image of `start` towards special point `special`, as in `n_b3`.
#[must_use]
pub fn normal_name(start: &str, special: &str) -> String {
    let link = special.strip_prefix('S').unwrap_or(special);
    format!("n_{}{link}", image_name(start))
}

/// Name of the end of a driven slider's relative velocity or acceleration, laid off from plan point `start`, as in
/// `r_a3` for link 3. `entered` are the names of the links that the driven sliders lead to, one after another.
pub(super) fn slide_name(start: &str, entered: &str) -> String {
    format!("r_{start}{entered}")
}

/// Name of the end of a driven slider's Coriolis acceleration, laid off after its relative acceleration, as in `k_a3`.
pub(super) fn coriolis_name(start: &str, entered: &str) -> String {
    format!("k_{start}{entered}")
}

/// Name of the point of `body` that coincides with `point`, as in `D_2`.
#[must_use]
pub fn coincident_name(point: &str, body: &str) -> String {
    format!("{point}_{body}")
}

/// Name of a body's point at `point`: `B` where the body has that point, else `B_2`.
pub(crate) fn point_on(mechanism: &Mechanism, body: BodyId, point: PointId) -> String {
    let (name, body) = (mechanism.point_name(point), mechanism.body(body));
    if body.has(point) { name.to_owned() } else { coincident_name(name, &body.name) }
}
