//! What errors and warnings of the motion say.

use crate::message::messages;

messages! { "motion":
    singular(links, reason, condition);
    singular_exactly(links, reason);
    at_limit(place, links, reason);
    at_change(place, links, reason);
    move_a_joint;
    overflow(links);
    larger_units;
    near_singular(links, condition, digits);

    near_limit(links, condition, digits);

    // Why a position is singular.
    no_definite_motion;
    in_one_line(first, second);
    parallel(lines);
    in_one_point(lines);
    normal_to_guide(through, at);
    at_infinity(first, second);
}
