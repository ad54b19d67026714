//! What errors of a motion that is followed say.

use crate::message::messages;

messages! { "cycle":
    drawn;
    lengths_and_drive;
    at_contact;
    say_circular;
    off_guide(slider);
    on_guide;
    other_kind(number);
    same_kind;
    no_drive;
    give_drive;
    no_such_drive(name, known);
    singular(links, at);
    at_limit(place, links);
    at_change(place, links);
    other_position;
    out_of_reach(from, to, stop);
    within_reach(low, high);
    no_vector(name);
    vectors;
    no_path(name);
    not_finite;
    too_many_turns;
    too_far;
    values_between(low, high);
    no_range(quantity);
    both_ends;
    no_step(step);
    distance_of_rows;
    step_leads_away(step);
    positive_step;
    too_many_steps(most, step, from, to);
    larger_step;
    no_room(from, to);
    table_too_long(rows, columns);
    sweep_or_fewer;
    more_room;
}
