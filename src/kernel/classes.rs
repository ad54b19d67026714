use crate::geometry::{Point, Turn, Vector, turn_of_degrees};
use crate::mechanism::{GROUND, Guide, Mechanism, Role, Slider};

/// By body: its class and its turn there. The ground's class is the first; a class turns as its first body does.
pub(super) fn classes(mechanism: &Mechanism) -> Vec<(usize, Turn)> {
    let bodies = mechanism.bodies.len();
    let mut found: Vec<Option<(usize, Turn)>> = vec![None; bodies];
    let driver = |b: &usize| matches!(mechanism.bodies[*b].role, Role::Driver { .. });
    let (drivers, others): (Vec<usize>, Vec<usize>) = (0..bodies).partition(driver);
    let mut next = 0;
    for root in std::iter::once(GROUND.0).chain(drivers).chain(others) {
        if found[root].is_some() {
            continue;
        }
        found[root] = Some((next, Turn::identity()));
        while let Some((body, seat)) = mechanism.sliders.iter().find_map(|slider| {
            let turn = relative_turn(slider);
            match (found[slider.on.0], found[slider.link.0]) {
                (Some((class, on)), None) => Some((slider.link, (class, on * turn))),
                (None, Some((class, link))) => Some((slider.on, (class, link * turn.inverse()))),
                _ => None,
            }
        }) {
            found[body.0] = Some(seat);
        }
        next += 1;
    }
    found.into_iter().map(|seat| seat.unwrap_or((0, Turn::identity()))).collect()
}

/// The sliding link's frame seen from that of the guide's body.
fn relative_turn(slider: &Slider) -> Turn {
    let (_, direction) = guide(slider);
    Turn::from_cos_sin_unchecked(direction.x, direction.y) * turn_of_degrees(slider.turned)
}

/// A place of the guide and its direction, in the frame of its body.
pub(super) fn guide(slider: &Slider) -> (Point, Vector) {
    match slider.guide {
        Guide::Local { through, direction } => (through, direction),
        Guide::Drawn(direction) => (Point::origin(), direction),
        Guide::DrawnBetween(..) => (Point::origin(), Vector::x()),
    }
}

/// The sliding point in the frame of its link.
pub(super) fn at_local(mechanism: &Mechanism, slider: &Slider) -> Point {
    let local = mechanism.body(slider.link).local_of(slider.at);
    local.unwrap_or_else(Point::origin)
}
