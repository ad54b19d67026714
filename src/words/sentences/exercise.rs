//! Sentences of the sheets of exercises.

sentences! {
    Group::Exercise =>

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
    /// Where the plans are drawn, if sheets for them follow.
    exercise_sheets;
    /// What a photograph of a sheet needs, on the sheets for the plans.
    sheet_markers;
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

    // Exercises in a course.
    /// How many digits are asked for.
    course_digits;
    /// Of a rate whose size is right.
    course_other_sense;
    /// Of a value that a known mistake gives: what the check says of it.
    course_cause(told);
    /// Of a value behind a mistake that was made at an earlier step.
    course_follows;
    /// What the picture of the student's sheet shows.
    course_picture;
    /// The link to the sheet that is printed.
    course_print;
    /// What the picture of the key shows.
    course_key;
    /// Before the mistake that gives a wrong value.
    course_if(value);
}
