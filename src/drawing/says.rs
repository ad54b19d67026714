//! What errors and warnings of figures, curves and films say.

use crate::message::messages;

messages! { "drawing":
    scheme = "scheme";
    velocity_plan = "velocity plan";
    acceleration_plan = "acceleration plan";
    overflow(panel, key, given, fitting) =
        "the {panel} does not fit into its panel at {key} = {given} and is cut off there; {fitting} fits, or a larger sheet";
    no_scale = "none";
    cost_of_list(scales) = "scales leave room for the list of results: {scales}";
    cost_of_names(scales) = "scales leave room for the list of names: {scales}";
    in_place_of(scale, now, before) = "{scale} = {now} in place of {before}";
    too_many_panels(wanted, room) =
        "{wanted} kinds of quantities need {wanted} panels, and the sheet has room for {room}";
    fewer_or_page = "fewer quantities at a time, or another `page` in the scene's figure, as \"a4-portrait\"";
    too_many_curves(wanted, most) =
        "{wanted} curves in one panel are more than can be told apart, which is {most}";
    fewer_quantities = "fewer quantities at a time";
    no_film_of(seconds) = "a turn of a film cannot last {seconds} seconds";
    at_most_seconds(most) = "more than 0 and at most {most} seconds";
    no_film_at(count) = "a film cannot have {count} pictures a second";
    pictures_a_second(most) = "1 to {most} pictures a second";
    no_motion(seconds, count) = "{seconds} seconds at {count} pictures a second show no motion";
    longer_or_more = "a longer time, or more pictures a second";
    film_too_long(count, most) = "the film would have {count} pictures; it may have {most}";
    film_of_turns_too_long(count, turns, most) =
        "the film would have {count} pictures in {turns} turns of the drive; it may have {most}";
    less_or_fewer = "less time for a turn, or fewer pictures a second";
    no_sheet(number, count) = "there is no sheet {number}; there are {count}";
    no_step(step, count) = "there is no step {step}; there are steps 1 to {count}";
    drive_stands(drive) = "the drive `{drive}` cannot move";
}
