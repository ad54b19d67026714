//! What warnings of forces say.

use crate::message::messages;

messages! { "forces":
    spring_without_direction(spring);
    friction_locks;
    friction_at_rest(joints);
    friction_leaves_open(joints);
}
