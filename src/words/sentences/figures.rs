//! What figures, curves, structures and lists of assembly modes say.

use crate::message::Declared;
use crate::words::Language;

sentences! {
    // The figure.
    /// Title of a figure whose scene has none.
    title;
    turned_plan(plan, angle);
    /// A special point that lies off the sheet.
    far_away(point, distance, from);
    /// At the line to an image that lies off the panel.
    far_in_plan(point, distance);
    /// In a panel whose content is larger.
    cut_at_edge;
    names_without_room;
    /// Before a list of them.
    names_left_out;
    loads_without_scale;
    friction_told;
    at_infinity(point);
    paths(points, step, drive);
    paths_in_time(points, step, drive, time);
    path_of(point, unit);
    centrodes(links);
    no_centrodes(links);
    inflection_circle(link, diameter, center, pole);
    no_inflection_circle(link);
    /// Of links without relative motion.
    no_centers(centers);
    no_velocities_by_centers(points);
    no_curvatures(points);
    too_many_for_lines(most);
    radius_of_curvature(point, radius);
    no_radius_of_curvature(point);
    /// At another assembly mode.
    mode(number);
    /// What moves as two profiles that touch.
    contact_link(link, first, second, from, to);
    contact_face(first, second, center);
    contact_here;
    /// Behind the name of a link that stands for two profiles that touch.
    equivalent(link);
    modes_left_out(count);
    /// What is drawn of a path on other branches of the motion.
    paths_beyond;
    agreement(difference, allowed);
    one_route_far;
    one_route;
    printed;
    with_direction(size, degrees);
    segment;
    value;
    values;
    /// Caption of the ruler of 50 mm.
    ruler;

    // The text that stands for a figure where it cannot be seen.
    description(panels, groups);
    described_group(class, links);
    /// The class of a group above class IV.
    higher;

    // Curves.
    /// Title of curves whose scene has none.
    curves;
    /// Title of the path of a vector's tip over the cycle.
    hodograph(vector);

    // The columns of Willis' table.
    willis_all;
    willis_turns;
    willis_held;
    willis_together;
    angle;
    angular_velocity;
    rotational_speed;
    speed_ratio;
    angular_acceleration;
    position;
    length;
    velocity;
    acceleration;
    force;
    moment;
    power;
    in_unit(kind, unit);
    drive_angle(symbol);
    drive_position(drive, unit);

    // The legend of curves.
    limit;
    change;
    scene;
    dead_centre;
    extremes;

    // The text that stands for curves where they cannot be seen.
    /// The drive's quantity, its first and its last value.
    over(drive, from, to);
    is_constant(quantity, value);
    least(value, at);
    greatest(value, at);
    no_least;
    no_greatest;

    // Special positions in the range of a drive; `place` is the drive's value, as in `angle(1) = 30°`.
    event_limit(place, links);
    event_runs_off(place, links);
    event_change(place, links);
    event_singular(place, links);
    event_turns_back(place, link, angle);
    event_slides_back(place, slider, position);
    event_leaves(place, slider, position);
    /// The part of a turn in which a pin is in a slot, and that in which the slotted link rests.
    engaged(drive, from, to, held, free);
    events_left_out(count);
    rates_of_every_position;

    // The structure: Assur groups in solving order.
    structure_freedoms(count);
    structure_known(motions);
    structure_drives(count, motions);
    structure_positions(angle, groups);
    structure_group(links, class, shape);
    structure_special_points(points);
    shape_second;
    shape_third;
    shape_fourth;
    shape_higher;
    structure_wheel(link);

    // The list of assembly modes.
    modes(count);
    modes_at_least(count);
    modes_listed(modes, listed);
    modes_heading(modes, unit);
    modes_of_group(links, found, most);
}
