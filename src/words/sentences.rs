//! All sentences, each declared once: its key in the catalogues, and the names of its blanks. From every line comes a method of
//! [`Language`]; so the compiler sees that no blank is left open.

use super::catalogue::{Declared, Language};

/// Makes the list of sentences, and a method for each: `title;` gives `title(&self) -> &str`, and `cross(image);` gives
/// `cross(&self, image: &str) -> String`.
macro_rules! sentences {
    ($($(#[$about:meta])+ $key:ident $(($($blank:ident),+))?;)+) => {
        /// The place of every sentence in the list, under its key.
        #[expect(non_camel_case_types, reason = "they are the keys of the catalogues")]
        #[derive(Clone, Copy)]
        enum Key { $($key),+ }

        /// The keys and blanks that every catalogue has.
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

// Names of points come in backticks, numbers written out.
sentences! {
    // Names of lines.
    /// The guide of a slider.
    guide_of(slider);
    /// A cut line.
    normal_to_guide(slider, point);
    /// The line on which all directions meet.
    line_at_infinity;

    // What a step says to do.
    /// Where a plan begins.
    choose_pole(pole, scale);
    /// The same, with the images of points at rest.
    choose_pole_with(pole, scale, images);
    /// The cut lines of a link meet.
    special_point(point, link, first, second);
    /// They are parallel; the direction in degrees.
    special_point_at_infinity(point, link, direction, first, second);
    /// Between two points of the mechanism.
    measure_length(from, to);
    /// Of a point of a driven link; `arm` is the line that it is normal to.
    lay_off_velocity(point, arm, link);
    /// Of a point of a driven link that turns uniformly.
    lay_off_normal_acceleration(point, pivot, link);
    /// Of a point of a driven link that does not.
    lay_off_whole_acceleration(point, pivot, arm);
    /// A vector that the scene gives.
    lay_off_given(vector);
    /// Of a known body, below another's point.
    lay_off_point_under(body, point);
    /// A ray: the point that it goes through, the line, the image that it leads to.
    ray_normal(through, line, image);
    /// The same.
    ray_parallel(through, line, image);
    /// Two rays.
    cross(image);
    /// Between two points of a plan.
    measure_segment(from, to);
    /// The normal part along a cut line, between two points of the plan.
    lay_off_normal_part(line, from, to);
    /// The same, of both links on the way.
    lay_off_normal_parts(line, from, to);
    /// The same, with the Coriolis part.
    lay_off_normal_and_coriolis(line, from, to);
    /// The Coriolis part alone.
    lay_off_coriolis_part(line, from, to);
    /// A group's equations.
    solve(unknowns);
    /// Where there is none.
    no_construction;
    /// Where special points lie at infinity.
    no_construction_far(points);
    /// The velocity of a point of a link that turns, relative to another one.
    lay_off_relative(link, point, from, arm);
    /// Of a slider, between two points of the plan.
    lay_off_sliding_velocity(slider, from, to);
    /// The same, where the way goes from the sliding link to the guide.
    lay_off_sliding_velocity_reversed(slider, from, to);
    /// Of a slider, between two points of the plan.
    lay_off_sliding_acceleration(slider, from, to);
    /// The same, where the way goes from the sliding link to the guide.
    lay_off_sliding_acceleration_reversed(slider, from, to);
    /// Of a slider, between two points of the plan.
    lay_off_coriolis(slider, from, to);
    /// The same, where the way goes from the sliding link to the guide.
    lay_off_coriolis_reversed(slider, from, to);

    // Words of equations.
    /// Behind a vector.
    given;
    /// Before the first of what a vector is made of.
    made_from;
    /// Before the next.
    and;
    /// Before the Coriolis part.
    coriolis_word;
    /// The name of a part.
    normal;
    /// The name of a part.
    tangential;
    /// The name of a part.
    sliding;
    /// The name of a part.
    coriolis;

    // The figure.
    /// Its title where the scene has none.
    title;
    /// Heading of a panel.
    scheme;
    /// Heading of a panel.
    velocity_plan;
    /// Heading of a panel.
    acceleration_plan;
    /// How far from another point a special point lies.
    far_away(point, distance, from);
    /// Of a special point.
    at_infinity(point);
    /// The difference of both routes, and the one allowed.
    agreement(difference, allowed);
    /// Why there is only one route.
    one_route_far;
    /// Why there is only one route.
    one_route;
    /// A vector; the direction in degrees.
    with_direction(size, degrees);
    /// Above the names of measured segments.
    segment;
    /// Above what they are worth.
    value;
    /// Above the ruler of 50 mm that shows whether a sheet was printed at 100 %.
    ruler;
    /// The figure, for those who cannot see it.
    description(panels, groups);
    /// A panel in that sentence.
    described_scheme;
    /// A panel in that sentence.
    described_velocity_plan;
    /// A panel in that sentence.
    described_acceleration_plan;
    /// A group in that sentence.
    described_group(class, links);
    /// The class of a group above the fourth.
    higher;

    // Curves.
    /// Their title where the scene has none.
    curves;
    /// The way of a vector's tip over the cycle.
    hodograph(vector);
    /// A kind of quantity.
    angle;
    /// A kind of quantity.
    angular_velocity;
    /// A kind of quantity.
    angular_acceleration;
    /// A kind of quantity.
    position;
    /// A kind of quantity.
    length;
    /// A kind of quantity.
    velocity;
    /// A kind of quantity.
    acceleration;
    /// What a panel shows.
    in_unit(kind, unit);
    /// What the axis of a drive that turns shows; the symbol of its angle.
    drive_angle(symbol);
    /// What the axis of a drive that slides shows.
    drive_position(drive, unit);
    /// A vertical line.
    limit;
    /// A vertical line.
    change;
    /// A vertical line: where the scene stands.
    scene;
    /// A mark.
    dead_centre;
    /// A mark.
    extremes;
    /// For those who cannot see it: the drive's quantity, its first and last value.
    over(drive, from, to);
    /// The same: a quantity that does not change.
    is_constant(quantity, value);
    /// The same: a value, and the drive's there.
    least(value, at);
    /// The same.
    greatest(value, at);
    /// Without a least value.
    no_least;
    /// Without a greatest value.
    no_greatest;

    // The text of the steps.
    /// All scales.
    scales(scales);
    /// A scale.
    scale_per_mm(scale, value, unit);
    /// What bands are: the errors of a hand.
    bands(mm, degrees);
    /// Why a value has no band.
    no_band_no_construction;
    /// Why a value has no band.
    no_band_no_sheet(panel);
    /// Heading.
    on_the_mechanism;
    /// The difference of both routes, and the one allowed.
    routes_differ(difference, allowed);
    /// A length.
    on_paper(mm);
    /// Behind a band that is a rough one.
    only_roughly;
    /// Of a ray.
    direction(degrees);
    /// Of two rays.
    angle_of_crossing(degrees);

    // What stands on the buttons of a page for the classroom, or is read out for them; names of keys are in brackets.
    /// The whole row of buttons.
    page_figure;
    /// Which panels show.
    page_panels;
    /// All panels.
    page_all;
    /// The steps of the construction.
    page_steps;
    /// To the first step.
    page_first;
    /// A step back.
    page_back;
    /// A step forward.
    page_forward;
    /// To the finished figure.
    page_finished;
    /// Behind the number of steps.
    page_count;
    /// The motion.
    page_motion;
    /// Sets it going.
    page_play;
    /// Stops it.
    page_pause;
    /// Back to the scene's own position.
    page_own;
    /// How fast.
    page_speed;
    /// Colours and paper.
    page_look;
    /// Dark or light.
    page_dark;
    /// Prints.
    page_print;
    /// What printing does.
    page_to_scale;
    /// Where scripts are off.
    page_no_script;
    /// Where the browser is too old.
    page_too_old;

    // The report on a student's values.
    /// Heading: how many values are right, within the tolerance, off.
    check_counts(right, within, off);
    /// Verdict.
    check_right;
    /// Verdict.
    check_within;
    /// Verdict.
    check_off;
    /// Verdict.
    check_unjudged;
    /// Heading of a column: the quantity.
    check_column_quantity;
    /// Heading of a column: the value that was written.
    check_column_written;
    /// Heading of a column: the right value.
    check_column_expected;
    /// Heading of a column: the difference of both.
    check_column_difference;
    /// Heading of a column: the difference on the sheet.
    check_column_on_paper;
    /// Heading of a column: the difference in per cent.
    check_column_percent;
    /// Heading of a column: the difference allowed.
    check_column_allowed;
    /// Heading of a column: the verdict.
    check_column_verdict;
    /// The limits of a hand.
    check_tolerance(mm, degrees);
    /// Heading.
    check_probably;
    /// Heading where nothing is to be explained.
    check_nothing;
    /// Where no single mistake explains the values.
    check_no_single;
    /// Where nothing in the catalogue does.
    check_none;
    /// A step.
    check_step(number);
    /// Before the first step.
    check_whole;
    /// Before what it should be.
    check_instead;
    /// Values that follow.
    check_follows(values);
    /// Where no value follows.
    check_follows_none;
    /// Probability.
    check_sure(percent);
    /// Heading of other explanations.
    check_others;
    /// Behind one that values cannot tell from the first.
    check_alike;
    /// Values without an explanation.
    check_unexplained(values);
    /// A plan whose places are the mirror image of the right ones.
    check_mirrored(plan);

    // A student's drawing over the right figure.
    /// Its lines: as it should be.
    check_key_right;
    /// Its lines: the student's.
    check_key_own;
    /// Its lines: where it went wrong.
    check_key_wrong;
    /// How many values follow, and how they are marked in the table.
    check_follows_marked(count, mark);
    /// How far from the panel's edge a point lies.
    check_beyond(point, mm);
    /// How far a student's points were turned to lie over the right ones.
    check_turned(plan, degrees);

    // What fills the blanks of mistakes' sentences.
    /// A line of the scheme: a cut line, by its special point.
    line_cut(point);
    /// A line of the scheme: a guide.
    line_guide(slider);
    /// A line of the scheme, by two of its points.
    line_through(points);
    /// All that was measured on a sheet.
    all_segments;
    /// Of a component.
    horizontal;
    /// Of a component.
    vertical;

    // Marks, and what is said of a whole class.
    /// Marks earned, of how many.
    class_marks(earned, of);
    /// The same, with those among them for values that follow from a mistake.
    class_marks_following(earned, of, follow);
    /// A class of one file.
    class_counts_one(files, passed, off, broken);
    /// How many files there are; of them passed, off, not understood.
    class_counts(files, passed, off, broken);
    /// How many of how many files that were understood begin with a mistake, at which step, what was done.
    class_common(count, of, step, done);
    /// The same of the whole drawing.
    class_common_whole(count, of, done);

    // The sheets of exercises.
    /// All that is given, parted by commas.
    exercise_given(all);
    /// The scales of the plans, parted by commas.
    exercise_draw(scales);
    /// What a teacher finds below the drawn key: all rates, parted by commas.
    exercise_rates(all);
    /// Above the names of what is to be found.
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
