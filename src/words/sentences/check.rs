//! Sentences of what is said of a student's values, and of a class.

sentences! {
    Group::Check =>

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

    // Photographs of drawings.
    /// Heading of a column: a point of a plan, by its segment from the pole.
    photo_column_point;
    /// Heading of a column: the right length of that segment on paper, in mm.
    photo_column_right;
    /// Heading of a column: its length in the picture.
    photo_column_found;
    /// Heading of a column: distance of the point from its right place.
    photo_column_off;
    /// Heading of a column: how far the point may be from where it is seen.
    photo_column_band;
    /// Verdict: the picture is not sharp enough to tell.
    photo_cannot_tell;
    /// In place of a verdict: the point is not found.
    photo_left;
    /// What a sheet is, above the table of its points.
    photo_sheet(file, number, name);

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
}
