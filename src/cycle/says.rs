//! What errors of a motion that is followed say.

use crate::message::messages;

messages! { "cycle":
    drawn = "a drawn configuration cannot be moved: it has no lengths";
    lengths_and_drive = "a scene with `lengths` or `shape` and a drive with its `angle` or `position`";
    other_kind(number) = "mechanism {number} is not of the kind of mechanism 0";
    same_kind = "the same links, joints and drives in the same order; only lengths, places and drives may differ";
    no_drive = "there is no drive to move";
    give_drive = "give a link a \"drive\"";
    no_such_drive(name, known) = "there is no drive `{name}`; the drives are: {known}";
    singular(links, at) =
        "links {links} are in a singular position at {at}, so which way they go on is not decided";
    at_limit(place, links) =
        "limit position at {place}: links {links} can go no further, their rates grow without bound; which of two ways they \
         come back is not decided";
    at_change(place, links) =
        "change point at {place}: links {links} could go on in another mode too; which way they go on is not decided";
    other_position = "a scene at another position of the drive; the sweep finds its way from there";
    out_of_reach(from, to, stop) = "the range from {from} to {to} cannot be reached: {stop}";
    within_reach(low, high) = "a range that holds a part of {low} to {high}";
    no_vector(name) = "`{name}` is no vector";
    vectors = "v(D), v(D/G), a(D), a_n(D/G), a_t(D/G), a_c(3/2) with names of this scene";
    no_path(name) = "`{name}` is no point of a link that moves, so it has no path";
    not_finite = "the ends of the range must be finite numbers";
    too_many_turns = "the range reaches further than a hundred turns";
    too_far = "the range reaches further than a hundred times the mechanism's size";
    values_between(low, high) = "values between {low} and {high}";
    no_range(quantity) = "the range of {quantity} is not given";
    both_ends = "both --from and --to: this slider has no full turn and no two ends";
    no_step(step) = "the step cannot be {step}";
    distance_of_rows = "the distance from one row to the next, as 1";
    step_leads_away(step) = "a step of {step} leads away from the end of the range";
    positive_step = "a positive step; its sign follows from the range";
    too_many_steps(most, step, from, to) = "there are more than {most} steps of {step} from {from} to {to}";
    larger_step = "a larger step";
    no_room(from, to) = "from {from} to {to} there is no room for a curve";
    table_too_long(rows, columns) = "the table would have {rows} rows of {columns} numbers";
    sweep_or_fewer = "write it with `kinegon sweep`, or name fewer quantities in the scene's `want`";
    more_room = "a range with more room between --from and --to";
}
