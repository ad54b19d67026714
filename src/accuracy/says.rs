//! What is said of numbers without a stated error.

use crate::message::messages;

messages! { "accuracy":
    unproved(links) = "links {links}: nothing is proved of their position or motion, so their numbers have no stated error";
    unbounded(names) =
        "{names}: no bound of the error can be given, as what they are read from may be zero, or lines parallel";
    at_limit(place, links) =
        "limit position at {place}: links {links} can go no further, their rates grow without bound, so their numbers have no \
         stated error";
    at_change(place, links) =
        "change point at {place}: links {links} could go on in another mode too, so their rates are not determined and their \
         numbers have no stated error";
}
