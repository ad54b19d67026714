//! What errors and warnings of figures, curves and films say.

use crate::message::messages;

messages! { "drawing":
    scheme;
    velocity_plan;
    acceleration_plan;
    centers;
    force_plan;
    lever;
    speeds;
    overflow(panel, key, given, fitting);
    no_scale;
    cost_of_list(scales);
    cost_of_names(scales);
    in_place_of(scale, now, before);
    too_many_panels(wanted, room);
    fewer_or_page;
    too_many_curves(wanted, most);
    fewer_quantities;
    no_film_of(seconds);
    at_most_seconds(most);
    no_film_at(count);
    pictures_a_second(most);
    no_motion(seconds, count);
    longer_or_more;
    film_too_long(count, most);
    film_of_turns_too_long(count, turns, most);
    less_or_fewer;
    no_sheet(number, count);
    no_step(step, count);
    drive_stands(drive);
}
