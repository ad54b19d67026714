//! What errors and warnings of the motion say.

use crate::message::messages;

messages! { "motion":
    singular(links, reason, condition) =
        "links {links} are in a singular position: {reason} (condition {condition})";
    singular_exactly(links, reason) = "links {links} are in a singular position: {reason} (exactly)";
    at_limit(place, links, reason) =
        "limit position at {place}: links {links} can go no further, their rates grow without bound: {reason}";
    at_change(place, links, reason) =
        "change point at {place}: links {links} could go on in another mode too, so their rates are not determined: {reason}";
    move_a_joint = "another crank angle, or move one of these joints off the common line or point";
    overflow(links) = "links {links}: a distance, a velocity or an acceleration is too large to be represented";
    larger_units = "larger units of length, or slower drives";
    near_singular(links, condition, digits) =
        "links {links} are near a singular position (condition {condition}): coordinates of 16 digits determine about \
         {digits} digits of their rates";

    near_limit(links, condition, digits) =
        "links {links} are at a limit position or next to one (condition {condition}): lengths and angles of 16 digits \
         determine about {digits} digits of their rates";

    // Why a position is singular.
    no_definite_motion = "its loops have no definite motion";
    in_one_line(first, second) = "{first} and {second} lie in one line";
    parallel(lines) = "the lines {lines} are parallel";
    in_one_point(lines) = "the lines {lines} meet in one point";
    normal_to_guide(through, at) = "through {through} normal to the guide at {at}";
    at_infinity(first, second) = "at infinity (guides at {first} and {second})";
}
