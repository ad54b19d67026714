//! What is said to students and teachers: reports, photographs, marks, the sheets of exercises, courses.

use crate::message::Declared;
use crate::words::Language;

sentences! {
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
    check_cannot_tell;
    check_missing(count, asked, values);
    /// In place of `check_missing` where only the first are named.
    check_missing_many(count, asked, values, more);
    check_coarse_digits(values);
    /// Places with large radii.
    check_rough_places(values, mm);
    check_too_small(values);
    /// Values without a construction by hand.
    check_coarse(values, percent, degrees);
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
    all_lengths;
    all_velocities;
    all_accelerations;
    all_angular_velocities;
    all_angular_accelerations;
    all_forces;
    all_moments;
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
