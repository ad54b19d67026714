//! What errors of forms and of marking schemes say.

use crate::message::messages;

messages! { "check":
    two_values(name, one, two);
    keep_one;
    form_empty;
    write_values;
    points_without_scale(scale);
    add_scale_of(scale, sheet);
    no_pole(sheet, pole);
    no_origin(sheet, point);
    add_pole(pole);
    no_length_on_paper(name);
    write_in(unit);
    no_sheet(sheet);
    add_scale_or_panel(scale);
    no_number(text);
    write_digits;
    too_large(text);
    wrong_digit;
    paper_without_scale(name, scale);
    add_scale(scale, unit, sheet);
    unit_on_paper(name, unit);
    unit_or_mu;
    no_unit_of(text, kind);
    write_unit(unit);
    did_you_mean(name);
    template_lists;
    nearest_name(name);
    no_quantity(name);
    no_box(name);
    pi_lost(name);
    save_as_utf8;
    too_many(most, count);
    is_this_a_form;
    no_scale(scale);
    scale_is_positive;
    not_understood(count, all);

    line(number);

    // Kinds of quantities, and sheets.
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

    // Tables.
    open_quotation;
    close_quotation;
    no_table(error);
    write_lines;
    value_without_name(text);
    value_in_unit(text);
    no_sense(text);
    write_sense;
    values_in(unit);
    not_upright(text);
    no_count(text);
    whole_number;
    true_or_false;
    mm_or_units;
    no_coordinate(text);
    write_coordinates;
    no_radius(text);
    write_radius;
    scale_no_number(scale, text);
    write_scale;

    // Marks.
    no_part(number);
    part_from_0;
    no_marks(number);
    marks_from_0(most);
    marks_twice(name);
    no_marks_at_all;
    add_each;

    // Refusals of pages.
    tolerance(most);
    no_photograph;
}
