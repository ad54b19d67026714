//! The sentences of figures, steps and reports, each declared once: its key and its blanks. What they say stands in `*.ftl` under the same
//! keys. A declaration gives a method of [`Language`], so the compiler checks that every blank is filled.

use super::Language;
use crate::message::{Declared, Message};
use crate::sheet::Sheet;

/// Declares the sentences and a method for each: `title;` gives `title(&self) -> &str`, and `cross(image);` gives
/// `cross(&self, image: &str) -> String`. Names of points are passed in backticks, numbers as text.
macro_rules! sentences {
    ($($(#[$about:meta])* $key:ident $(($($blank:ident),+))?;)+) => {
        /// Index of each sentence in [`DECLARED`].
        #[expect(non_camel_case_types, reason = "they are the keys of the catalogues")]
        #[derive(Clone, Copy)]
        enum Key { $($key),+ }

        /// All sentences.
        pub static DECLARED: &[Declared] = &[
            $(Declared { key: stringify!($key), blanks: &[$($(stringify!($blank)),+)?] }),+
        ];

        impl Language {
            $(sentences!(@method $(#[$about])* $key $(($($blank),+))?);)+
        }
    };
    (@method $(#[$about:meta])* $key:ident) => {
        $(#[$about])*
        #[doc = concat!("`", stringify!($key), "` of the catalogues.")]
        #[must_use]
        pub fn $key(&self) -> &str {
            self.words(Key::$key as usize)
        }
    };
    (@method $(#[$about:meta])* $key:ident ($($blank:ident),+)) => {
        $(#[$about])*
        #[doc = concat!("`", stringify!($key), "` of the catalogues.")]
        #[must_use]
        pub fn $key(&self, $($blank: &str),+) -> String {
            self.filled(Key::$key as usize, &[$($blank),+])
        }
    };
}

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
    /// Of a rack or a carriage.
    speeds_slides(link, at);
    speeds_slides_given(link, at);
    speeds_belt(from, to);
    /// Of centres off the line.
    speeds_turned(points);
    /// Of a belt whose wheels have no radius.
    speeds_unsized_belt(first, second);
    /// Of a scene without meshes.
    speeds_none;
    /// Of meshes whose centres lie on another line.
    speeds_left_out(meshes, line);

    // The figure.
    /// Title of a figure whose scene has none.
    title;
    scheme;
    velocity_plan;
    turned_plan(plan, angle);
    acceleration_plan;
    centers;
    force_plan;
    lever;
    speeds;
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
    named_scheme;
    named_velocity_plan;
    named_acceleration_plan;
    named_centers;
    named_force_plan;
    named_lever;
    named_speeds;
    described_scheme;
    described_velocity_plan;
    described_acceleration_plan;
    described_centers;
    described_force_plan;
    described_lever;
    described_speeds;
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

    // The list of assembly modes.
    modes(count);
    modes_at_least(count);
    modes_listed(modes, listed);
    modes_heading(modes, unit);

    // The report on a student's values.
    check_counts(right, within, off);
    check_counts_and_senses(right, within, missing, off);
    check_right;
    check_within;
    check_sense_missing;
    check_senses;
    check_off;
    /// The verdict on a direction.
    check_off_turned(degrees);
    check_unjudged;
    check_cannot_tell;
    check_missing(count, asked, values);
    check_coarse_digits(values);
    check_too_small(values);
    check_all_larger(percent);
    check_all_smaller(percent);
    check_all_longer(mm);
    check_all_shorter(mm);
    check_other_scale(scale, stated, asked);
    check_no_such_scale(scale, stated, sheet, used);
    column_quantity;
    check_column_written;
    check_column_expected;
    check_column_difference;
    check_column_on_paper;
    check_column_percent;
    check_column_allowed;
    check_column_verdict;
    check_tolerance(mm, degrees);
    check_accuracy(mm, degrees);
    check_slips(percent);
    check_wider(mm, degrees);
    check_too_coarse(mm, degrees);
    check_probably;
    check_nothing;
    /// In place of `check_nothing` where rates have no sense.
    check_nothing_off;
    /// In place of `check_nothing` where something is missing or tells nothing.
    check_so_far(good, asked);
    check_tells_nothing;
    check_no_single;
    check_none(number, value);
    check_step(number);
    /// In place of a step.
    check_whole;
    check_instead;
    check_follows(values);
    check_follows_none;
    check_values_of(exercise);
    check_worked(calculation);
    check_worked_beside(calculation, own);
    check_seems_left(degrees);
    check_seems_right(degrees);
    check_seems_longer(mm);
    check_seems_shorter(mm);
    check_seems_elsewhere(mm, first, one, second, other);
    check_redo(steps);
    check_redo_one(step);
    check_redo_number;
    check_sure(percent);
    check_others;
    /// In place of `check_others` where only the place of a mistake is told.
    check_perhaps;
    check_hint_plan(plan);
    check_hint_whole;
    check_hint_value(value);
    /// Behind an explanation that the values cannot tell from the first.
    check_alike;
    check_unexplained(values);
    check_not_looked;
    check_looked_at(count);
    check_mirrored(plan);
    check_turned_left(plan, degrees);
    check_turned_right(plan, degrees);

    // A student's drawing over the right figure.
    check_key_right;
    check_key_own;
    check_key_wrong;
    check_follows_marked(count, mark);
    /// A point of the student's drawing beyond the edge of its panel.
    check_beyond(point, mm);
    check_turned(plan, degrees);

    // Photographs of drawings.
    photo_column_point;
    photo_column_right;
    photo_column_found;
    photo_column_off;
    photo_column_band;
    photo_cannot_tell;
    photo_left;
    photo_sheet(file, number, name);

    // What fills the blanks of mistakes' sentences.
    line_cut(point);
    line_guide(slider);
    line_through(points);
    all_segments;
    /// Of an x component.
    horizontal;
    /// Of a y component.
    vertical;

    // Marks, and the summary of a class.
    class_marks(earned, of);
    class_marks_following(earned, of, follow);
    class_counts(files, passed, off, broken);
    class_incomplete(count);
    class_common(count, of, step, done);
    class_common_whole(count, of, done);
    class_unknown(count, of);
    class_not_understood;

    // The sheets of exercises.
    exercise_given(all);
    exercise_draw(scales);
    exercise_centers(scales);
    exercise_forces(scales);
    exercise_lever(scales);
    exercise_guide(slider, place, degrees);
    exercise_guide_through(slider, line);
    exercise_wheel(link, teeth);
    exercise_ring(link, teeth);
    exercise_fixed_wheel(teeth);
    exercise_fixed_ring(teeth);
    exercise_mesh(first, second);
    exercise_mesh_on(first, second, arm);
    exercise_room(velocity, acceleration, paper);
    exercise_sheets;
    exercise_center_sheet;
    sheet_markers;
    exercise_senses;
    exercise_senses_of_slides(slides);
    exercise_points(all);
    exercise_normal_ends(points);
    exercise_coriolis_ends(points);
    exercise_sliding_ends(points);
    exercise_name;
    /// Below the drawn key.
    exercise_allowed;

    // Exercises in a course.
    course_digits;
    course_other_sense;
    course_cause(told);
    /// Of a value behind a mistake that was made at an earlier step.
    course_follows;
    course_picture;
    course_print;
    course_key;
    course_if(value);
}

impl Language {
    /// Heading of a sheet.
    #[must_use]
    pub fn sheet(&self, sheet: Sheet) -> &str {
        self.of_sheet(sheet)[0]
    }

    /// A sheet in the description of a figure, for readers who cannot see it.
    #[must_use]
    pub fn described_sheet(&self, sheet: Sheet) -> &str {
        self.of_sheet(sheet)[1]
    }

    /// A sheet within a sentence.
    #[must_use]
    pub fn named_sheet(&self, sheet: Sheet) -> &str {
        self.words(named_sheet(sheet) as usize)
    }

    /// Heading and description of a sheet.
    fn of_sheet(&self, sheet: Sheet) -> [&str; 2] {
        match sheet {
            Sheet::Scheme => [self.scheme(), self.described_scheme()],
            Sheet::Velocity => [self.velocity_plan(), self.described_velocity_plan()],
            Sheet::Acceleration => [self.acceleration_plan(), self.described_acceleration_plan()],
            Sheet::Centers => [self.centers(), self.described_centers()],
            Sheet::Forces => [self.force_plan(), self.described_force_plan()],
            Sheet::Lever => [self.lever(), self.described_lever()],
            Sheet::Speeds => [self.speeds(), self.described_speeds()],
        }
    }

    /// Headings of the columns in the report on a student's values.
    #[must_use]
    pub fn check_columns(&self) -> [&str; 8] {
        [
            self.column_quantity(),
            self.check_column_written(),
            self.check_column_expected(),
            self.check_column_difference(),
            self.check_column_on_paper(),
            self.check_column_percent(),
            self.check_column_allowed(),
            self.check_column_verdict(),
        ]
    }

    /// Headings of the columns in the table of points in a photograph.
    #[must_use]
    pub fn photo_columns(&self) -> [&str; 6] {
        [
            self.photo_column_point(),
            self.photo_column_right(),
            self.photo_column_found(),
            self.photo_column_off(),
            self.photo_column_band(),
            self.check_column_verdict(),
        ]
    }
}

fn named_sheet(sheet: Sheet) -> Key {
    match sheet {
        Sheet::Scheme => Key::named_scheme,
        Sheet::Velocity => Key::named_velocity_plan,
        Sheet::Acceleration => Key::named_acceleration_plan,
        Sheet::Centers => Key::named_centers,
        Sheet::Forces => Key::named_force_plan,
        Sheet::Lever => Key::named_lever,
        Sheet::Speeds => Key::named_speeds,
    }
}

/// A sheet within a message.
pub fn sheet_told(sheet: Sheet) -> Message {
    Message::of(&DECLARED[named_sheet(sheet) as usize], Vec::new())
}
