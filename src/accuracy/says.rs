//! What is said of numbers without a stated error.

use crate::message::messages;

messages! { "accuracy":
    unproved(links);
    pulls(contact);
    unbounded(names);
    at_limit(place, links);
    at_change(place, links);
}
