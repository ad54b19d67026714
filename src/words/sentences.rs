//! The sentences of figures, steps and reports, each declared once: its key, its blanks and what it says in English.
//! Other languages are text files with the same keys. A declaration gives a method of [`Language`], so the compiler
//! checks that every blank is filled.

use super::catalogue::{Declared, Language};
use crate::message::filled;
use crate::sheet::Sheet;

/// Declares the sentences and a method for each: `title = "…";` gives `title(&self) -> &str`, and
/// `cross(image) = "… {image} …";` gives `cross(&self, image: &str) -> String`. Names of points are passed in
/// backticks, numbers as text.
macro_rules! sentences {
    ($($(#[$about:meta])* $key:ident $(($($blank:ident),+))? = $english:literal;)+) => {
        /// Index of each sentence in [`DECLARED`].
        #[expect(non_camel_case_types, reason = "they are the keys of the catalogues")]
        #[derive(Clone, Copy)]
        enum Key { $($key),+ }

        /// All sentences.
        pub const DECLARED: &[Declared] = &[
            $(Declared { key: stringify!($key), blanks: &[$($(stringify!($blank)),+)?], english: $english }),+
        ];

        impl Language {
            $(sentences!(@method $(#[$about])* $key $(($($blank),+))? = $english);)+
        }
    };
    (@method $(#[$about:meta])* $key:ident = $english:literal) => {
        $(#[$about])*
        #[doc = $english]
        #[must_use]
        pub fn $key(&self) -> &str {
            self.sentences[Key::$key as usize]
        }
    };
    (@method $(#[$about:meta])* $key:ident ($($blank:ident),+) = $english:literal) => {
        $(#[$about])*
        #[doc = $english]
        #[must_use]
        pub fn $key(&self, $($blank: &str),+) -> String {
            let declared = &DECLARED[Key::$key as usize];
            filled(self.sentences[Key::$key as usize], declared.blanks, &[$($blank),+])
        }
    };
}

sentences! {
    // Names of links and lines.
    /// The frame as the carrier of a guide, as in `5/ground`.
    ground = "ground";
    guide_of(slider) = "guide of {slider}";
    normal_to_guide(slider, point) = "the normal to the guide of {slider} through {point}";
    /// The cut line of a leg with two sliders, on which all directions meet.
    line_at_infinity = "the line at infinity";

    // Steps that are shown together.
    join_special_points(points) = "{points}, special points: where their cut lines cross.";
    join_lay_off(vectors) = "Lay off {vectors}.";
    join_normal(through, line) = "through {through} ⊥ {line}";
    join_parallel(through, line) = "through {through} ∥ {line}";
    join_at_angle(through, angle) = "through {through} at {angle}";
    join_cross(first, second, point) = "The rays {first} and {second} cross in {point}.";
    join_measure(lengths) = "Measure {lengths}.";
    join_rates(segments, unknowns) = "Measure {segments}; solve for {unknowns}.";
    join_images(points) = "Images of further points: {points}.";

    // Steps of the construction.
    choose_pole(pole, scale) = "Choose the pole {pole} and the scale {scale}.";
    choose_pole_with(pole, scale, images) =
        "Choose the pole {pole} and the scale {scale}; points at rest have their images there: {images}.";
    special_point(point, link, first, second) = "{point}, special point of link {link}: where {first} meets {second}.";
    special_point_at_infinity(point, link, direction, first, second) =
        "{point}, special point of link {link}, lies at infinity (direction {direction}°): {first} and {second} are \
         parallel.";
    measure_length(from, to) = "Measure the length from {from} to {to}.";
    /// Of a point of a driven link.
    lay_off_velocity(point, arm, link) = "Lay off the velocity of {point}, normal to {arm}, in the sense of ω_{link}.";
    lay_off_normal_acceleration(point, pivot, link) =
        "Lay off the acceleration of {point}, from {point} towards {pivot}: link {link} turns uniformly.";
    lay_off_whole_acceleration(point, pivot, arm) =
        "Lay off the acceleration of {point}: normal part from {point} towards {pivot}, tangential part normal to \
         {arm}.";
    lay_off_given(vector) = "Lay off the given vector {vector} from the pole.";
    lay_off_point_under(body, point) = "Lay off the known vector of the point of {body} under {point}.";
    ray_normal(through, line, image) = "Draw the ray through {through} normal to {line}; {image} lies on it.";
    ray_parallel(through, line, image) = "Draw the ray through {through} parallel to the {line}; {image} lies on it.";
    ray_at_angle(through, angle, image) =
        "Draw the ray through {through} at the angle {angle} of the link, in the same sense; {image} lies on it.";
    divide(from, to, part, whole, image) =
        "Divide the line from {from} to {to} in the ratio {part} : {whole}: there is {image}.";
    coincide(link, image, with) = "Link {link} does not turn: {image} is at {with}.";
    cross(image) = "Mark {image} where the two rays cross.";
    measure_segment(from, to) = "Measure the segment from {from} to {to}.";
    lay_off_normal_part(line, centre, from, to) =
        "Lay off the normal part along {line} towards {centre}, from {from} to {to}.";
    lay_off_normal_parts(line, from, to) = "Lay off the normal parts of both links along {line} from {from} to {to}.";
    solve(unknowns) = "Solve the equations of the measured segments for {unknowns}.";
    no_construction =
        "There is no construction by two rays for this group: its rates come from the loop equations, and its images \
         are laid off from them, link by link.";
    no_construction_far(points) =
        "{points} at infinity: its rays are parallel, so the rates come from the loop equations, and the images are \
         laid off from them, link by link.";
    lay_off_relative(link, point, from, arm) =
        "From ω_{link}: lay off the velocity of {point} relative to {from}, normal to {arm}.";
    lay_off_relative_normal(point, from, arm) =
        "Lay off the normal acceleration of {point} relative to {from}, along {arm} towards {from}.";
    lay_off_relative_tangential(link, point, from, arm) =
        "From α_{link}: lay off the tangential acceleration of {point} relative to {from}, normal to {arm}.";
    lay_off_sliding_velocity(slider, from, to) =
        "Lay off the sliding velocity of {slider} along its guide, from {from} to {to}.";
    /// Backwards, with its head at a point that is there: the chain runs from the sliding link to the guide.
    lay_off_sliding_velocity_backwards(slider, from, to) =
        "Lay off the sliding velocity of {slider} along its guide so that it ends at {to}: it begins at {from}.";
    lay_off_sliding_acceleration(slider, from, to) =
        "Lay off the sliding acceleration of {slider} along its guide, from {from} to {to}.";
    lay_off_sliding_acceleration_backwards(slider, from, to) =
        "Lay off the sliding acceleration of {slider} along its guide so that it ends at {to}: it begins at {from}.";
    lay_off_coriolis(slider, link, from, to) =
        "Lay off the Coriolis acceleration of {slider}, its sliding velocity turned by 90° in the sense of ω_{link}, \
         from {from} to {to}.";
    lay_off_coriolis_backwards(slider, link, from, to) =
        "Lay off the Coriolis acceleration of {slider}, its sliding velocity turned by 90° in the sense of ω_{link}, \
         so that it ends at {to}: it begins at {from}.";

    // Words of equations.
    given = " given";
    made_from = " from ";
    and = " and ";
    normal = "normal";
    tangential = "tangential";
    sliding = "sliding";
    coriolis = "Coriolis";

    // The text of the steps.
    scales(scales) = "Scales: {scales}";
    scale_per_mm(scale, value, unit) = "{scale} = {value} {unit} per mm";
    bands(mm, degrees) = "± is what honest hand drawings (±{mm} mm, ±{degrees}°) keep to, at least 95 of 100.";
    no_band_no_construction =
        "A value has no ± where it depends on a group without a construction (a special point at infinity, or a \
         higher class).";
    no_band_no_sheet(panel) = "A value has no ± where the figure has no {panel}, so no scale.";
    on_the_mechanism = "On the mechanism";
    routes_differ(difference, allowed) =
        "The rates from this construction and from the loop equations differ by {difference} of the largest; its \
         crossings allow {allowed}.";
    on_paper(mm) = "{mm} mm on paper";
    /// Behind a rough band.
    only_roughly = ", only roughly";
    direction(degrees) = "direction {degrees}°";
    angle_of_crossing(degrees) = "angle of crossing {degrees}°";

    // The figure.
    /// Title of a figure whose scene has none.
    title = "Velocity and acceleration plans";
    scheme = "Scheme";
    velocity_plan = "Velocity plan";
    acceleration_plan = "Acceleration plan";
    /// A special point that lies off the sheet.
    far_away(point, distance, from) = "{point}: {distance} from {from}";
    /// At the line to an image that lies off the panel.
    far_in_plan(point, distance) = "to {point}: {distance}";
    /// In a panel whose content is larger.
    cut_at_edge = "cut at the edge";
    names_without_room = "no room for all names";
    /// Before a list of them.
    names_left_out = "no room for:";
    at_infinity(point) = "{point} at infinity";
    paths(points, step, drive) = "Ticks on the path of {points}: every {step} of drive {drive}.";
    paths_in_time(points, step, drive, time) =
        "Ticks on the path of {points}: every {step} of drive {drive}, that is every {time}.";
    path_of(point, unit) = "Path of {point} in {unit}";
    /// At another assembly mode.
    mode(number) = "mode {number}";
    modes_left_out(count) = "Of the other assembly modes only the first {count} are drawn.";
    /// What is drawn of a path on other branches of the motion.
    paths_beyond = "Dashed: beyond the limits of the drive.";
    agreement(difference, allowed) =
        "Construction and loop equations agree: rates differ by {difference} of the largest (crossings allow \
         {allowed}).";
    one_route_far = "A special point lies at infinity: rates are from the loop equations alone.";
    one_route = "A group has no construction by two rays: rates are from the loop equations alone.";
    printed = "Printed at 100 %, mm × μ is the value.";
    with_direction(size, degrees) = "{size}, direction {degrees}°";
    segment = "segment";
    value = "value";
    values = "Values";
    /// Caption of the ruler of 50 mm.
    ruler = "Printed at 100 %, this is 50 mm";

    // The text that stands for a figure where it cannot be seen.
    description(panels, groups) = "Panels: {panels}. Assur groups: {groups}.";
    described_scheme = "the mechanism to scale";
    described_velocity_plan = "its velocity plan";
    described_acceleration_plan = "its acceleration plan";
    described_group(class, links) = "class {class}, links {links}";
    /// The class of a group above class IV.
    higher = "higher";

    // Curves.
    /// Title of curves whose scene has none.
    curves = "Curves";
    /// Title of the path of a vector's tip over the cycle.
    hodograph(vector) = "Hodograph of {vector}";
    angle = "Angle";
    angular_velocity = "Angular velocity";
    angular_acceleration = "Angular acceleration";
    position = "Position";
    length = "Length";
    velocity = "Velocity";
    acceleration = "Acceleration";
    in_unit(kind, unit) = "{kind} in {unit}";
    drive_angle(symbol) = "Angle {symbol} of the drive in °";
    drive_position(drive, unit) = "Position of drive {drive} in {unit}";

    // The legend of curves.
    limit = "limit";
    change = "change";
    scene = "scene";
    dead_centre = "dead centre";
    extremes = "greatest, least value";

    // The text that stands for curves where they cannot be seen.
    /// The drive's quantity, its first and its last value.
    over(drive, from, to) = "Over {drive} from {from} to {to}:";
    is_constant(quantity, value) = "{quantity} is {value}";
    least(value, at) = "least {value} at {at}";
    greatest(value, at) = "greatest {value} at {at}";
    no_least = "least without bound";
    no_greatest = "greatest without bound";

    // Special positions in the range of a drive; `place` is the drive's value, as in `angle(1) = 30°`.
    event_limit(place, links) =
        "limit position at {place}: links {links} can go no further, their rates grow without bound";
    event_runs_off(place, links) = "limit position at {place}: links {links} run off to infinity";
    event_change(place, links) =
        "change point at {place}: links {links} could go on in another mode too; the smooth motion is followed, and \
         rates are left out there";
    event_singular(place, links) = "singular position near {place}: links {links} cannot be followed through it";
    event_turns_back(place, link, angle) = "extreme position at {place}: link {link} stops at {angle}° and turns back";
    event_slides_back(place, slider, position) =
        "extreme position at {place}: slider {slider} stops at {position} and slides back";
    events_left_out(count) = "{count} more extreme or change points follow";

    // The structure: Assur groups in solving order.
    structure_freedoms(count) = "degrees of freedom: {count}, as many as drives";
    structure_known(motions) = "known motions: {motions}";
    structure_drives(count, motions) = "drives: {count}; known motions: {motions}";
    structure_positions(angle, groups) = "positions from {angle}: {groups}";
    structure_group(links, class, shape) = "links {links}: class {class}, {shape}";
    structure_special_points(points) = "special points {points}";
    shape_second = "two links";
    shape_third = "a central link on three legs";
    shape_fourth = "two drag links joined by two closure links, a closed contour of four";
    shape_higher = "more links than the classes II to IV have, or joined in another way";

    // The list of assembly modes.
    modes_one(count) = "{count} assembly mode";
    modes_many(count) = "{count} assembly modes";
    modes_at_least(count) = "at least {count}";
    modes_listed(modes, listed) = "{modes}, listed are the first {listed}";
    modes_heading(modes, unit) = "{modes}; coordinates in {unit}, angles in degrees";

    // The report on a student's values.
    check_counts(right, within, off) = "{right} right, {within} within the tolerance of a pencil, {off} off";
    check_counts_and_senses(right, within, missing, off) =
        "{right} right, {within} within the tolerance of a pencil, {missing} without a sense, {off} off";
    check_right = "right";
    check_within = "within tolerance";
    check_sense_missing = "sense missing";
    check_senses =
        "Sense missing: the size is right, but a number without a sign does not tell the sense. Write + or − before \
         it, or \"positive\": \"counter-clockwise\" into the form.";
    check_off = "OFF";
    /// The verdict on a direction.
    check_off_turned(degrees) = "OFF: turned by {degrees}°";
    check_unjudged = "not judged: it has no construction";
    check_cannot_tell = "cannot tell";
    check_missing(count, asked, values) = "Missing: {count} of {asked} that are asked for: {values}.";
    check_coarse_digits(values) = "Too few digits to tell anything: {values}. Write at least two that are not zero.";
    check_too_small(values) =
        "Too small on the sheet to be judged: {values}. An honest hand could as well find nothing there.";
    check_all_larger(percent) =
        "All lengths are {percent} % too large: was the sheet printed to fit the page? They are judged without that.";
    check_all_smaller(percent) =
        "All lengths are {percent} % too small: was the sheet printed to fit the page? They are judged without that.";
    check_all_longer(mm) =
        "All lengths are {mm} mm too long: did you read the ruler from its end, or from {mm}? They are judged without that.";
    check_all_shorter(mm) =
        "All lengths are {mm} mm too short: did you lay the end of the ruler on the point? They are judged without that.";
    check_other_scale(scale, stated, asked) =
        "{scale}: your form states {stated}, the exercise {asked}; your values are judged at yours.";
    check_no_such_scale(scale, stated, sheet, used) =
        "{scale} = {stated}: no sheet can show the {sheet} so; what is allowed is that of a drawing at {used}.";
    column_quantity = "quantity";
    check_column_written = "yours";
    check_column_expected = "expected";
    check_column_difference = "off by";
    check_column_on_paper = "on paper";
    check_column_percent = "off by";
    check_column_allowed = "allowed";
    check_column_verdict = "verdict";
    check_tolerance(mm, degrees) =
        "A careful drawing (±{mm} mm, ±{degrees}° in each act) may be off by as much as is allowed here.";
    check_accuracy(mm, degrees) =
        "Your drawing is accurate to about {mm} mm and {degrees}°, as the scatter of all values shows.";
    check_slips(percent) = "Your computed numbers are off by up to about {percent} %.";
    check_wider(mm, degrees) = "So more is allowed than for a careful hand (±{mm} mm, ±{degrees}°).";
    check_too_coarse(mm, degrees) = "A hand of ±{mm} mm and ±{degrees}° was asked for.";
    check_probably = "What probably happened";
    check_nothing = "All correct.";
    /// In place of `check_nothing` where rates have no sense.
    check_nothing_off = "Nothing is off.";
    /// In place of `check_nothing` where something is missing or tells nothing.
    check_so_far(good, asked) = "Nothing is off: {good} of {asked} values are correct, the others are not known.";
    check_tells_nothing = "These values tell nothing, right or wrong.";
    check_no_single = "No single mistake explains this. Together these do:";
    check_none(number, value) =
        "Something is wrong from step {number} on: {value} is the first value that is off. I cannot tell the cause.";
    check_step(number) = "Step {number}";
    /// In place of a step.
    check_whole = "Whole drawing";
    check_instead = "It should be";
    check_follows(values) = "These follow from it and are consistent with it: {values}.";
    check_follows_none = "No other of your values follows from it.";
    check_values_of(exercise) = "These are the values of another exercise: {exercise}.";
    check_worked(calculation) = "With your numbers: {calculation}.";
    check_worked_beside(calculation, own) = "With your numbers: {calculation}; you have {own}.";
    check_seems_left(degrees) = "It seems turned to the left by {degrees}°.";
    check_seems_right(degrees) = "It seems turned to the right by {degrees}°.";
    check_seems_longer(mm) = "It seems {mm} mm too long.";
    check_seems_shorter(mm) = "It seems {mm} mm too short.";
    check_seems_elsewhere(mm, first, one, second, other) =
        "The point seems {mm} mm from where its two lines cross: from {first} it is seen {one}° beside its line, from \
         {second} {other}°.";
    check_redo(steps) = "Do steps {steps} again; keep the rest.";
    check_redo_one(step) = "Do step {step} again; keep the rest.";
    check_redo_number = "Correct this number alone; the drawing stays.";
    check_sure(percent) = "How sure: {percent} %";
    check_others = "It could also be";
    /// In place of `check_others` where only the place of a mistake is told.
    check_perhaps = "Perhaps it was this";
    check_hint_plan(plan) = "Look at your {plan}.";
    check_hint_whole = "Look at the whole drawing: its position, its scale, its senses.";
    check_hint_value(value) = "The first value that is off is {value}.";
    /// Behind an explanation that the values cannot tell from the first.
    check_alike = "your values alone cannot tell this from the above";
    check_unexplained(values) = "Without an explanation: {values}.";
    check_not_looked = "In so large a construction no causes are looked for.";
    check_looked_at(count) = "So large a form is searched in part: only the first {count} values are looked at for causes.";
    check_mirrored(plan) =
        "The points of your {plan} are the mirror image of the right ones: all senses are turned round. If you \
         measured y downwards on the sheet, measure it upwards.";
    check_turned_left(plan, degrees) =
        "Your whole {plan} lies turned to the left by {degrees}°. If the sheet was not laid so, its first vector was.";
    check_turned_right(plan, degrees) =
        "Your whole {plan} lies turned to the right by {degrees}°. If the sheet was not laid so, its first vector was.";

    // A student's drawing over the right figure.
    check_key_right = "as it should be";
    check_key_own = "yours (names with *)";
    check_key_wrong = "where it went wrong";
    check_follows_marked(count, mark) =
        "{count} values marked {mark} in the table follow from it and are consistent with it.";
    /// A point of the student's drawing beyond the edge of its panel.
    check_beyond(point, mm) = "{point}: {mm} mm farther";
    check_turned(plan, degrees) = "The points of your {plan} are shown turned by {degrees}°, as they fit best.";

    // Photographs of drawings.
    photo_column_point = "point";
    photo_column_right = "right mm";
    photo_column_found = "seen mm";
    photo_column_off = "apart mm";
    photo_column_band = "± mm";
    photo_cannot_tell = "cannot be told from this picture";
    photo_left = "not found";
    photo_sheet(file, number, name) = "{file}: sheet {number} of {name}";

    // What fills the blanks of mistakes' sentences.
    line_cut(point) = "the line that was drawn for {point}";
    line_guide(slider) = "the guide of {slider}";
    line_through(points) = "the line {points}";
    all_segments = "all segments of the sheet";
    /// Of an x component.
    horizontal = "horizontal";
    /// Of a y component.
    vertical = "vertical";

    // Marks, and the summary of a class.
    class_marks(earned, of) = "Marks: {earned} of {of}";
    class_marks_following(earned, of, follow) =
        "Marks: {earned} of {of}, {follow} of them for values that follow from a mistake";
    class_counts_one(files, passed, off, broken) = "{files} file: {passed} passed, {off} off, {broken} not understood";
    class_counts(files, passed, off, broken) = "{files} files: {passed} passed, {off} off, {broken} not understood";
    class_incomplete(count) = "{count} without a value that is off, but not complete";
    class_common(count, of, step, done) = "{count} of {of}: step {step}, {done}";
    class_common_whole(count, of, done) = "{count} of {of}: whole drawing, {done}";
    class_unknown(count, of) = "{count} of {of}: values are off, the cause is not known";
    class_not_understood = "This form was not understood. Hand it in again when this is put right:";

    // The sheets of exercises.
    exercise_given(all) = "Given: {all}.";
    exercise_draw(scales) = "Draw the plans at {scales}. Measure, on this sheet too, and fill in the boxes.";
    exercise_guide(slider, place, degrees) = "guide of {slider} through {place} at {degrees}°";
    exercise_guide_through(slider, line) = "guide of {slider} along {line}";
    exercise_room(velocity, acceleration, paper) =
        "The velocity plan takes {velocity}, the acceleration plan {acceleration}: draw each on {paper} or larger.";
    exercise_sheets = "Sheets for the plans follow.";
    sheet_markers = "Photograph: sheet flat, all eight squares in view.";
    exercise_senses = "Signs: counter-clockwise is +.";
    exercise_senses_of_slides(slides) = "Signs: counter-clockwise is +; {slides}: + along the arrow marked +.";
    exercise_points(all) = "Points: {all}.";
    exercise_normal_ends(points) = "{points}: end of a normal part";
    exercise_coriolis_ends(points) = "{points}: end of a Coriolis part";
    exercise_sliding_ends(points) = "{points}: end of a sliding part";
    exercise_name = "Name: ………………………………… Date: ………………";
    /// Below the drawn key.
    exercise_allowed = "± is what a careful hand may be off by.";

    // Exercises in a course.
    course_digits = "Write each value with three significant digits, in the unit beside its box.";
    course_other_sense = "The size is right, the sense is wrong.";
    course_cause(told) = "Probable cause: {told}";
    /// Of a value behind a mistake that was made at an earlier step.
    course_follows = "This value follows from it.";
    course_picture = "The mechanism, true to scale";
    course_print = "Sheet to print at its true size";
    course_key = "The mechanism with both plans";
    course_if(value) = "If you found {value}:";
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

    /// Heading and description of a sheet.
    fn of_sheet(&self, sheet: Sheet) -> [&str; 2] {
        match sheet {
            Sheet::Scheme => [self.scheme(), self.described_scheme()],
            Sheet::Velocity => [self.velocity_plan(), self.described_velocity_plan()],
            Sheet::Acceleration => [self.acceleration_plan(), self.described_acceleration_plan()],
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
