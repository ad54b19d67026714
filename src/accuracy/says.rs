//! What is said of numbers without a stated error.

use crate::message::messages;

messages! { "accuracy":
    unproved(links) = "links {links}: nothing is proved of their position or motion, so their numbers have no stated error";
}
