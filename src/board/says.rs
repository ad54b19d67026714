//! What is said of drawings: what cannot be carried out, and what is wrong.

use crate::message::messages;

messages! { "board":
    too_many(most, count);
    sheet_too_large(mu, sheet, metres, most);
    other_scale(mu, key);

    // Formulas.
    no_formula(text, place);
    no_equation(text);
    not_linear(text);
    no_value(text);
    no_solution;

    // What cannot be carried out.
    taken(name);
    no_point(name);
    no_line(name);
    no_number(name);
    no_direction(name);
    no_reference(name);
    which_points(link);
    which_sheet;
    two_sheets(one, two);
    no_crossing(one, two);

    // What is wrong.
    line_misses(point);
    lines_of_others(point);
    point_elsewhere(point);
    no_force_of_polygon(point);
    no_direction_of_force(line);
    polygon_not_closed(point);
    number_wrong(name);
    nothing_leads_to(name);
    equation_wrong(number);
    leads_wrong(name);
    drawn_off(mm, degrees);
    point_off(mm);
    misread(name, mm);

    // What the entries say.
    join(name, one, two);
    line(name, point, direction);
    line_by_eye(name);
    cross(name, one, two);
    lay_off(name, point, size, direction);
    like(name, ends, points);
    mark(name);
    measure(name, one, two);
    compute(name, formula);
    typed(name, number);
    solve(names);
    undo(count);
    parallel(to);
    normal(to);
    turned(base, from, to);
    angle(degrees);
    link(name);
    guide(name);
    load(name);
    drawn_line(name);
    ccw;
    cw;

    // The report.
    right;
    wrong;
    follows;
    unused;
    undone;
    all_right;
    right_so_far;
    asked_missing(names);
    asked_missing_many(names, more);
    nothing_drawn;
    first_wrong(number);
    should(what);

    // Hints.
    all_there;
    next_line(sheet);
    next_point(name, sheet);
    next_number(name);
    no_sheet;

    // The sheets.
    free_hand(mm, degrees);
}
