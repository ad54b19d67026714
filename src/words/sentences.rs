//! The sentences of figures and reports, each declared once: its key in the catalogues and the names of its blanks.
//! Each declaration gives a method of [`Language`], so the compiler checks that every blank is filled.

use super::catalogue::{Declared, Language};

/// Declares the sentences and a method for each: `title;` gives `title(&self) -> &str`, and `cross(image);` gives
/// `cross(&self, image: &str) -> String`.
macro_rules! sentences {
    ($($(#[$about:meta])+ $key:ident $(($($blank:ident),+))?;)+) => {
        /// Index of each sentence in [`SENTENCES`].
        #[expect(non_camel_case_types, reason = "they are the keys of the catalogues")]
        #[derive(Clone, Copy)]
        enum Key { $($key),+ }

        /// The keys and blanks of every catalogue; behind them are those of mistakes.
        pub(super) const SENTENCES: &[Declared] =
            &[$(Declared { key: stringify!($key), blanks: &[$($(stringify!($blank)),+)?], needs_all: true }),+];

        impl Language {
            $(sentences!(@method $(#[$about])+ $key $(($($blank),+))?);)+
        }
    };
    (@method $(#[$about:meta])+ $key:ident) => {
        $(#[$about])+
        #[must_use]
        pub fn $key(&self) -> &str {
            self.sentences[Key::$key as usize].plain()
        }
    };
    (@method $(#[$about:meta])+ $key:ident ($($blank:ident),+)) => {
        $(#[$about])+
        #[must_use]
        pub fn $key(&self, $($blank: &str),+) -> String {
            self.sentences[Key::$key as usize].filled(&[$($blank),+])
        }
    };
}

// Names of points are passed in backticks, numbers as text.
sentences! {
    // Names of lines.
    /// The guide of a slider.
    guide_of(slider);
    /// A cut line of a leg with a slider: through `point`, normal to the guide.
    normal_to_guide(slider, point);
    /// The cut line of a leg with two sliders, on which all directions meet.
    line_at_infinity;

    // Steps that are shown together.
    /// Several special points.
    join_special_points(points);
    /// Several vectors, each by its ends.
    join_lay_off(vectors);
    /// A ray normal to a line, within `join_cross`.
    join_normal(through, line);
    /// A ray parallel to a line, likewise.
    join_parallel(through, line);
    /// A ray at an angle, likewise.
    join_at_angle(through, angle);
    /// Two rays and where they cross.
    join_cross(first, second, point);
    /// Several lengths or segments, each by its ends.
    join_measure(lengths);
    /// The rates that follow from measured segments.
    join_rates(segments, unknowns);
    /// Images of further points.
    join_images(points);

    // Steps of the construction.
    /// The pole of a plan and its scale.
    choose_pole(pole, scale);
    /// The pole of a plan, its scale, and the images of points at rest, which lie at the pole.
    choose_pole_with(pole, scale, images);
    /// A special point, where two cut lines meet.
    special_point(point, link, first, second);
    /// A special point at infinity, where two cut lines are parallel; their direction in degrees.
    special_point_at_infinity(point, link, direction, first, second);
    /// The length between two points of the scheme.
    measure_length(from, to);
    /// The velocity of a point of a driven link; `arm` is the line to which it is normal.
    lay_off_velocity(point, arm, link);
    /// The acceleration of a point of a driven link that turns uniformly.
    lay_off_normal_acceleration(point, pivot, link);
    /// The acceleration of a point of a driven link with angular acceleration.
    lay_off_whole_acceleration(point, pivot, arm);
    /// A velocity or acceleration that the scene gives.
    lay_off_given(vector);
    /// The vector of the point of a known body that coincides with a point of another link.
    lay_off_point_under(body, point);
    /// A ray normal to a line: the plan point on it, the line, the image that is sought.
    ray_normal(through, line, image);
    /// A ray parallel to a line: the plan point on it, the line, the image that is sought.
    ray_parallel(through, line, image);
    /// A ray at the angle that two lines of the mechanism make: the plan point on it, the angle, the image that is sought.
    ray_at_angle(through, angle, image);
    /// The image of a point on the line of two others: their images, the ratio of two lengths, the image.
    divide(from, to, part, whole, image);
    /// The image of a point of a link that does not turn: the link, the image, the image with which it coincides.
    coincide(link, image, with);
    /// The crossing of two rays, which is the image.
    cross(image);
    /// The segment between two points of a plan.
    measure_segment(from, to);
    /// The normal part along a cut line, between two points of the acceleration plan.
    lay_off_normal_part(line, centre, from, to);
    /// The normal parts of both links of a leg, laid off as one.
    lay_off_normal_parts(line, from, to);
    /// The equations that give the rates of a group.
    solve(unknowns);
    /// For a group without a construction by two rays.
    no_construction;
    /// For a group whose special points lie at infinity.
    no_construction_far(points);
    /// The velocity of a point of a link of known rotation, relative to another of its points.
    lay_off_relative(link, point, from, arm);
    /// The normal acceleration of one point of a link relative to another: the point, the other, their line.
    lay_off_relative_normal(point, from, arm);
    /// The tangential acceleration of one point of a link relative to another: the link, the point, the other, their line.
    lay_off_relative_tangential(link, point, from, arm);
    /// The sliding velocity of a slider, between two points of the plan.
    lay_off_sliding_velocity(slider, from, to);
    /// The same backwards, with its head at a point that is there: the chain runs from the sliding link to the guide.
    lay_off_sliding_velocity_backwards(slider, from, to);
    /// The sliding acceleration of a slider, between two points of the plan.
    lay_off_sliding_acceleration(slider, from, to);
    /// The same backwards.
    lay_off_sliding_acceleration_backwards(slider, from, to);
    /// The Coriolis acceleration of a slider, the link that carries its guide, two points of the plan.
    lay_off_coriolis(slider, link, from, to);
    /// The same backwards.
    lay_off_coriolis_backwards(slider, link, from, to);

    // Words of equations.
    /// Behind a given vector.
    given;
    /// Before the first product of which a vector is made.
    made_from;
    /// Before each further product.
    and;
    /// Name of the normal part of an acceleration.
    normal;
    /// Name of the tangential part of an acceleration.
    tangential;
    /// Name of the sliding part of a vector.
    sliding;
    /// Name of the Coriolis part of an acceleration.
    coriolis;

    // The figure.
    /// Title of a figure whose scene has none.
    title;
    /// Heading of the scheme.
    scheme;
    /// Heading of the velocity plan.
    velocity_plan;
    /// Heading of the acceleration plan.
    acceleration_plan;
    /// Distance of a special point off the sheet from another point.
    far_away(point, distance, from);
    /// Distance on paper of an image off the panel, in mm, at its line.
    far_in_plan(point, distance);
    /// In a panel whose content is larger.
    cut_at_edge;
    /// In a panel with more names than it can show.
    names_without_room;
    /// Of a special point at infinity.
    at_infinity(point);
    /// The paths of these points, and the step of the drive between their ticks.
    paths(points, step, drive);
    /// The same, with the time that the step takes.
    paths_in_time(points, step, drive, time);
    /// The path of a point as a chart.
    path_of(point, unit);
    /// At another assembly mode, by its number.
    mode(number);
    /// That not all other assembly modes are drawn.
    modes_left_out(count);
    /// What is drawn of a path on other branches of the motion.
    paths_beyond;
    /// Relative difference of the rates from construction and loop equations, and the one that crossings allow.
    agreement(difference, allowed);
    /// Why rates come from the loop equations alone: a special point at infinity.
    one_route_far;
    /// Why rates come from the loop equations alone: no construction by two rays.
    one_route;
    /// A vector by size and direction, in degrees.
    with_direction(size, degrees);
    /// Heading of the names of measured segments.
    segment;
    /// Heading of their values.
    value;
    /// Heading of the table of values that have no place in the panels.
    values;
    /// Caption of the ruler of 50 mm, which shows whether a sheet was printed at 100 %.
    ruler;
    /// Alternative text of the figure.
    description(panels, groups);
    /// The scheme, in the alternative text.
    described_scheme;
    /// The velocity plan, in the alternative text.
    described_velocity_plan;
    /// The acceleration plan, in the alternative text.
    described_acceleration_plan;
    /// An Assur group, in the alternative text.
    described_group(class, links);
    /// The class of a group above class IV.
    higher;

    // Curves.
    /// Title of curves whose scene has none.
    curves;
    /// Title: the path of a vector's tip over the cycle.
    hodograph(vector);
    /// Kind of quantity: angle.
    angle;
    /// Kind of quantity: angular velocity.
    angular_velocity;
    /// Kind of quantity: angular acceleration.
    angular_acceleration;
    /// Kind of quantity: coordinate, or position along a guide.
    position;
    /// Kind of quantity: distance.
    length;
    /// Kind of quantity: velocity.
    velocity;
    /// Kind of quantity: acceleration.
    acceleration;
    /// Heading of a panel: kind of quantity and unit.
    in_unit(kind, unit);
    /// Label of the axis of a turning drive; the symbol of its angle.
    drive_angle(symbol);
    /// Label of the axis of a sliding drive.
    drive_position(drive, unit);
    /// Legend of the vertical line at a limit position.
    limit;
    /// Legend of the vertical line at a change point.
    change;
    /// Legend of the vertical line at the scene's own position.
    scene;
    /// Legend of the mark of a dead centre.
    dead_centre;
    /// Legend of the mark of an extreme value.
    extremes;
    /// Alternative text of curves: the drive's quantity, its first and last value.
    over(drive, from, to);
    /// Alternative text: a constant quantity.
    is_constant(quantity, value);
    /// Alternative text: the least value, and the drive's value there.
    least(value, at);
    /// Alternative text: the greatest value, and the drive's value there.
    greatest(value, at);
    /// Alternative text: no least value.
    no_least;
    /// Alternative text: no greatest value.
    no_greatest;

    // The text of the steps.
    /// All scales of the figure.
    scales(scales);
    /// One scale, in units per mm of paper.
    scale_per_mm(scale, value, unit);
    /// What the bands ± mean, with the limits of a hand's errors.
    bands(mm, degrees);
    /// Why a value has no band: no construction.
    no_band_no_construction;
    /// Why a value has no band: the figure lacks the panel.
    no_band_no_sheet(panel);
    /// Heading of the steps on the scheme.
    on_the_mechanism;
    /// Relative difference of the rates from construction and loop equations, and the one that crossings allow.
    routes_differ(difference, allowed);
    /// A length on paper, in mm.
    on_paper(mm);
    /// Behind a rough band.
    only_roughly;
    /// Direction of a ray, in degrees.
    direction(degrees);
    /// Angle between two rays, in degrees.
    angle_of_crossing(degrees);

    // The report on a student's values.
    /// Heading: numbers of values that are right, within tolerance, off.
    check_counts(right, within, off);
    /// The same where rates have no sense: their number before that of the values that are off.
    check_counts_and_senses(right, within, missing, off);
    /// Verdict: right.
    check_right;
    /// Verdict: within tolerance.
    check_within;
    /// Verdict: a rate of the right size without a sense.
    check_sense_missing;
    /// What to do about rates without a sense.
    check_senses;
    /// Verdict: off.
    check_off;
    /// Verdict: not judged.
    check_unjudged;
    /// Heading of a column: the quantity.
    check_column_quantity;
    /// Heading of a column: the student's value.
    check_column_written;
    /// Heading of a column: the right value.
    check_column_expected;
    /// Heading of a column: the difference in units.
    check_column_difference;
    /// Heading of a column: the difference on paper.
    check_column_on_paper;
    /// Heading of a column: the difference in per cent.
    check_column_percent;
    /// Heading of a column: the difference allowed.
    check_column_allowed;
    /// Heading of a column: the verdict.
    check_column_verdict;
    /// The limits of a hand's errors.
    check_tolerance(mm, degrees);
    /// How accurate the drawing is.
    check_accuracy(mm, degrees);
    /// How accurate computed numbers are.
    check_slips(percent);
    /// More is allowed than to a careful hand.
    check_wider(mm, degrees);
    /// The hand is worse than was asked for.
    check_too_coarse(mm, degrees);
    /// Heading of the explanation.
    check_probably;
    /// In place of an explanation: no value is off.
    check_nothing;
    /// The same where rates have no sense.
    check_nothing_off;
    /// Where several mistakes together explain the values.
    check_no_single;
    /// Where no cause can be told: the step and the first value that is off.
    check_none(number, value);
    /// The same where no other value is off.
    check_none_alone(number, value);
    /// The step of a mistake.
    check_step(number);
    /// In place of a step: the whole drawing.
    check_whole;
    /// Before what should have been done.
    check_instead;
    /// Values that follow from a mistake.
    check_follows(values);
    /// Where no value follows from a mistake.
    check_follows_none;
    /// Probability of an explanation.
    check_sure(percent);
    /// Heading of other explanations.
    check_others;
    /// Behind an explanation that the values cannot tell from the first.
    check_alike;
    /// Values without an explanation.
    check_unexplained(values);
    /// A plan whose places are the mirror image of the right ones.
    check_mirrored(plan);

    // A student's drawing over the right figure.
    /// Legend of lines as they should be.
    check_key_right;
    /// Legend of the student's lines.
    check_key_own;
    /// Legend of the first wrong lines.
    check_key_wrong;
    /// Number of values that follow from a mistake, and their mark in the table.
    check_follows_marked(count, mark);
    /// Distance of a point beyond the panel's edge, in mm.
    check_beyond(point, mm);
    /// Angle by which a student's plan was turned to fit the right one.
    check_turned(plan, degrees);

    // Texts that fill the blanks of mistakes' sentences.
    /// A cut line, by its special point.
    line_cut(point);
    /// A guide, by its slider.
    line_guide(slider);
    /// A line of the scheme, by two of its points.
    line_through(points);
    /// All segments of a sheet.
    all_segments;
    /// Of an x component.
    horizontal;
    /// Of a y component.
    vertical;

    // Marks, and the summary of a class.
    /// Marks earned, and the most that could be.
    class_marks(earned, of);
    /// The same, with the marks for values that follow from a mistake.
    class_marks_following(earned, of, follow);
    /// The counts of a class of one file.
    class_counts_one(files, passed, off, broken);
    /// Numbers of files: all, passed, off, not understood.
    class_counts(files, passed, off, broken);
    /// A common first mistake: in how many of the files that were understood, its step, what was done.
    class_common(count, of, step, done);
    /// A common mistake of the whole drawing.
    class_common_whole(count, of, done);
    /// In how many of the files that were understood values are off without a known cause.
    class_unknown(count, of);
    /// Before the message about a form that was not understood.
    class_not_understood;

    // The sheets of exercises.
    /// All that is given, separated by commas.
    exercise_given(all);
    /// The scales of the plans, separated by commas.
    exercise_draw(scales);
    /// Where the guide of a slider on the ground is, among the given numbers: a place on it, its direction in degrees.
    exercise_guide(slider, place, degrees);
    /// The same of a guide along a line of two points.
    exercise_guide_through(slider, line);
    /// The sizes of both plans on paper, and the paper on which each has room.
    exercise_room(velocity, acceleration, paper);
    /// Which sense is positive.
    exercise_senses;
    /// The same where slides are asked for: their symbols, separated by commas.
    exercise_senses_of_slides(slides);
    /// What the auxiliary points of the plans are, separated by semicolons.
    exercise_points(all);
    /// Ends of normal parts, separated by commas.
    exercise_normal_ends(points);
    /// Ends of Coriolis accelerations.
    exercise_coriolis_ends(points);
    /// Ends of sliding velocities or accelerations.
    exercise_sliding_ends(points);
    /// Lines for the student's name and the date.
    exercise_name;
    /// Below the drawn key: what ± means.
    exercise_allowed;
    /// Heading of the names of quantities to be found.
    exercise_quantity;
}

impl Language {
    /// Headings of the columns in the report on a student's values.
    #[must_use]
    pub fn check_columns(&self) -> [&str; 8] {
        [
            self.check_column_quantity(),
            self.check_column_written(),
            self.check_column_expected(),
            self.check_column_difference(),
            self.check_column_on_paper(),
            self.check_column_percent(),
            self.check_column_allowed(),
            self.check_column_verdict(),
        ]
    }
}
