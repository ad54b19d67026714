//! What is said where there is no exercise.

use crate::message::messages;

messages! { "exercise":
    no_construction;
    nothing_to_find;
    gave_up(tries, percent, most);
    numbers;
    assembly;
    singular;
    no_plans;
    routes;
    crossing;
    sheet;
    short;
    unsure;
    center_far;
    centers_close;
    center_distance;
    center_unsure;
    forces_cross;
    force_short;
    arm_short;
    forces_unequal;
    forces_unequal_as(small, large);
    force_unsure;
    evened(changes);
    same;
    numbered(most);
    no_such;
    whole_seed;
}
