//! What the steps of a construction say: on the mechanism, in the plans, of instant centres and of forces.

use crate::message::Declared;
use crate::words::Language;

sentences! {
    // Names of links and lines.
    /// The frame as the carrier of a guide, as in `5/ground`.
    ground;
    guide_of(slider);
    normal_to_guide(slider, point);
    /// The cut line of a leg with two sliders, on which all directions meet.
    line_at_infinity;

    // Steps that are shown together.
    join_special_points(points);
    join_lay_off(vectors);
    join_normal(through, line);
    join_parallel(through, line);
    join_at_angle(through, angle);
    join_cross(first, second, point);
    join_measure(lengths);
    join_rates(segments, unknowns);
    join_images(points);

    // Steps of the construction.
    choose_pole(pole, scale);
    choose_pole_with(pole, scale, images);
    special_point(point, link, first, second);
    special_point_at_infinity(point, link, direction, first, second);
    measure_length(from, to);
    /// Of a point of a driven link.
    lay_off_velocity(point, arm, link);
    lay_off_velocity_turned(point, arm, from, to);
    lay_off_normal_acceleration(point, pivot, link);
    lay_off_whole_acceleration(point, pivot, arm);
    lay_off_given(vector);
    lay_off_given_turned(vector);
    lay_off_point_under(body, point);
    ray_normal(through, line, image);
    ray_normal_to_guide(through, line, image);
    ray_parallel(through, line, image);
    ray_parallel_to_line(through, line, image);
    ray_at_angle(through, angle, image);
    divide(from, to, part, whole, image);
    coincide(link, image, with);
    cross(image);
    measure_segment(from, to);
    lay_off_normal_part(line, centre, from, to);
    lay_off_normal_parts(line, from, to);
    solve(unknowns);
    solve_wheel(unknowns);
    solve_wheel_with_mesh(unknowns);
    solve_meshes(unknowns);
    solve_meshes_accelerated(unknowns);
    /// Of racks and belts.
    solve_rims(unknowns);
    pitch_at_rest(image, with);
    lay_off_pitch(link, point, from, arm);
    lay_off_pitch_turned(link, point, from, arm);
    no_construction;
    no_construction_far(points);
    lay_off_relative(link, point, from, arm);
    lay_off_relative_turned(link, point, from, arm);
    lay_off_relative_normal(point, from, arm);
    lay_off_relative_tangential(link, point, from, arm);
    lay_off_sliding_velocity(slider, from, to);
    lay_off_sliding_velocity_turned(slider, from, to);
    /// Backwards, with its head at a point that is there: the chain runs from the sliding link to the guide.
    lay_off_sliding_velocity_backwards(slider, from, to);
    lay_off_sliding_velocity_turned_backwards(slider, from, to);
    lay_off_sliding_acceleration(slider, from, to);
    lay_off_sliding_acceleration_backwards(slider, from, to);
    lay_off_coriolis(slider, link, from, to);
    lay_off_coriolis_backwards(slider, link, from, to);

    // Words of equations.
    given;
    made_from;
    and;
    normal;
    tangential;
    sliding;
    coriolis;

    // The text of the steps.
    scales(scales);
    scales_by_hand(scales);
    scales_of_figure(scales);
    scale_per_mm(scale, value, unit);
    bands(mm, degrees);
    no_band_no_construction;
    no_band_no_sheet(panel);
    on_the_mechanism;
    routes_differ(difference, allowed);
    on_paper(mm);
    /// Behind a rough band.
    only_roughly;
    direction(degrees);
    angle_of_crossing(degrees);

    // Instant centres.
    /// The list of `center_in`, `center_of_mesh` and `center_normal_to`.
    permanent_centers(centers);
    center_in(center, point);
    center_of_mesh(center);
    center_normal_to(center, guide);
    center_line(first, second, center);
    /// Where the second is at infinity.
    center_line_towards(first, second, center);
    center_cross(center, first, second);
    center_parallel(center, first, second);
    /// Where the other line is that at infinity.
    center_along(center, line);
    leave_out(link, first, second, center);
    centers_by_rates(centers);
    rate_by_centers(rate, driver, link, center);
    velocity_by_centers(vector, from, point);
    rate_by_slide(rate, link, center, velocity);
    velocity_along_guide(vector, guide);
    collineation_axis(first, second, first_center, second_center, pole, crossing);
    pole_tangent(link, pole, first, second);
    axis_of_point(pole, point, pin, crossing);
    center_of_curvature(point, fixed, center);
    path_inflection(point, fixed);
    inflection_point(pole, pin, fixed);
    inflection_in_pin(pin, fixed);
    inflection_pole(pole, found, point);
    inflections_differ(difference, allowed);
    curvatures_differ(difference, allowed);
    velocity_of_center(vector, center, link);
    centers_differ(difference, allowed);

    // The force plan.
    /// The letter of a weight.
    weight_letter;
    one_link(link);
    several_links(links);
    force_moments(links, point, force);
    force_moments_crossing(links, first, second, force);
    force_couple(links, point, couple, guide);
    force_begin(links, scale, force);
    force_lay_off(force);
    force_direction(force);
    force_cross(first, second);
    force_close(force);
    force_sum(force);
    force_inner(force, links);
    force_push(guide, force);
    forces_by_numbers(links);
    force_polygon(links, known);
    force_polygon_closed(forces);
    force_polygon_joined(forces);
    forces_differ(difference, allowed);
    lever_turn;
    /// With several drives.
    lever_turn_for(drive);
    lever_arm(force);
    lever_effort(effort);
    speeds_train;
    speeds_given(link, from, to);
    speeds_line(link, from, to);
    speeds_pole;
    speeds_ray(link, rate);
    /// Of a scene without meshes.
    speeds_none;
    /// Of meshes whose centres lie on another line.
    speeds_left_out(meshes, line);
    /// Of a rack or a carriage.
    speeds_slides(link, at);
    speeds_slides_given(link, at);
    speeds_belt(from, to);
    /// Of centres off the line.
    speeds_turned(points);
    /// Of a belt whose wheels have no radius.
    speeds_unsized_belt(first, second);
}
