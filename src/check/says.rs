//! What errors of forms and of marking schemes say.

use crate::message::messages;

messages! { "check":
    two_values(name, one, two) = "`{name}` has two values here: {one} and {two}";
    keep_one = "keep the one that you mean";
    form_empty = "the form is empty: it has no values to check";
    write_values = "write your values beside the names; `kinegon check SCENE --template` writes the form";
    points_without_scale(scale) = "places of points are in millimetres of paper, but your scale {scale} is missing";
    add_scale_of(scale, sheet) = "add {scale}, the scale of your {sheet}";
    no_pole(sheet, pole) = "the places of the {sheet} do not have its pole {pole}";
    add_pole(pole) = "add \"{pole}\": [x, y]";
    no_length_on_paper(name) = "`{name}` is no length on paper, so `/mu` cannot follow it";
    write_in(unit) = "write it in {unit}";
    no_sheet(sheet) = "the scene's figure has no {sheet}, so its scale is missing";
    add_scale_or_panel(scale) = "add {scale} to the values, or the panel to the scene's figure";
    no_number(text) = "`{text}` is no number";
    write_digits = "write digits with a decimal point, as 61.5; leave blank what you have not measured";
    too_large(text) = "`{text}` is too large";
    wrong_digit = "is a digit or an exponent wrong?";
    paper_without_scale(name, scale) = "`{name}` is in millimetres of paper, but your scale {scale} is missing";
    add_scale(scale, unit, sheet) = "add {scale}: how many {unit} are 1 mm of your {sheet}";
    unit_on_paper(name, unit) = "`{name}` is in millimetres of paper, but `{unit}` stands beside it";
    unit_or_mu = "leave the unit out, or the `/mu`";
    no_unit_of(text, kind) = "`{text}` is no unit of {kind}";
    write_unit(unit) = "write `{unit}`, or leave the unit out";
    did_you_mean(name) = "did you mean `{name}`?";
    template_lists = "`kinegon check SCENE --template` lists the names";
    nearest_name(name) = "the nearest name is `{name}`; `kinegon check SCENE --template` lists the names";
    no_quantity(name) = "`{name}` is no quantity of this scene";
    pi_lost(name) = "the letter π was lost in `{name}`";
    save_as_utf8 = "save as CSV UTF-8, or write pi";
    too_many(most, count) = "a form has at most {most} values, and here are {count}";
    is_this_a_form = "is this a form? `kinegon check` without a form prints an empty one";
    no_scale(scale) = "{scale} is no scale";
    scale_is_positive = "a scale is a positive number: units of the scene per millimetre of paper";
    not_understood(count, all) = "{count} things in this form are not understood:{all}";

    line(number) = "line {number}";

    // Kinds of quantities, and sheets.
    angle = "an angle";
    angular_velocity = "an angular velocity";
    angular_acceleration = "an angular acceleration";
    position = "a position";
    length = "a length";
    velocity = "a velocity";
    acceleration = "an acceleration";
    scheme = "scheme";
    velocity_plan = "velocity plan";
    acceleration_plan = "acceleration plan";

    // Tables.
    no_table(error) = "this is no table: {error}";
    write_lines = "write a line `quantity,value` for each value; names with a comma stand in double quotes";
    no_sense(text) = "`{text}` is no sense of rotation";
    write_sense = "write `clockwise` or `counter-clockwise`";
    values_in(unit) = "values in `{unit}` are not understood";
    not_upright(text) = "`{text}` does not say whether the sheets lie upright";
    no_count(text) = "`{text}` is no number of hints";
    whole_number = "write a whole number from 0 on, or leave the line out";
    true_or_false = "write `true` if they lie as they were printed, else `false`";
    mm_or_units = "write `mm` for millimetres of paper, or `units` for those of the scene";
    no_coordinate(text) = "`{text}` is no coordinate";
    write_coordinates = "write x and y in millimetres of paper, as velocity:b,114,-2.7";
    no_radius(text) = "`{text}` is no radius";
    write_radius =
        "behind x and y may stand how far the point may be from there, in millimetres of paper, as velocity:b,114,-2.7,0.2";
    scale_no_number(scale, text) = "{scale} is `{text}`, which is no number";
    write_scale = "write units of the scene per millimetre of paper, as 2 or 0.5";

    // Marks.
    no_part(number) = "{number} is no part of marks";
    part_from_0 = "write a number from 0 (no marks) to 1 (all marks of the quantity)";
    no_marks(number) = "{number} is no number of marks";
    marks_from_0(most) = "write a number from 0 to {most}";
    marks_twice(name) = "`{name}` is the same quantity and has its marks already";
    no_marks_at_all = "the marking scheme gives no marks for anything";
    add_each = "add \"each\": 1, or marks for the quantities that count";

    // Refusals of pages.
    tolerance(most) = "the tolerance of a pencil is from 0 to {most}";
    no_photograph = "there is no photograph";
}
