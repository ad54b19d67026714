//! What errors of scenes, and of other files that are read as strictly, say.

use crate::fluent::{Sentence, english};
use crate::message::{Declared, Message, messages};

messages! { "scene":
    // Kinds of files.
    scene;
    study;
    drawing;
    style;
    form;
    marks;
    begins_with(what, start);
    too_many_bytes(what, bytes, most, mib);
    is_empty(what);
    expected_object(what, start, found);
    meant_key(key, other);
    add_version(key, version, what);
    no_version(key, what);
    other_version(version, what, said);
    version_is_number(version, found);
    write_version(key, version);

    // Text that is not JSON.
    not_json(what);
    not_json_at_all;
    text_over_lines;
    add_quote_or_n;
    control_in_text;
    write_t;
    too_deep(most);
    no_comments;
    write_note;
    trailing_comma;
    remove_comma;
    leading_zero;
    remove_zero;
    comma_missing;
    brace_open;
    add_brace;
    bracket_open;
    add_bracket;
    brace_for_value;
    bracket_for_value;
    comma_for_value;
    colon_for_value;
    colon_missing;
    value_missing;
    after_end(what);
    one_in_a_file(what);
    single_quotes;
    write_double;
    key_needs_quotes(word);
    write_key_value;
    no_number(word);
    every_number_finite(what);
    not_here(sign);
    no_value(word);
    leave_key_out;
    write_true;
    write_false;
    names_in_quotes;
    plus_sign;
    remove_plus;
    decimal_only;
    digits_both_sides;
    write_half;
    number_incomplete;
    no_escape;
    write_backslash;
    text_open;
    add_quote;
    null;
    key_twice(key, line);
    number_too_large(number);
    choose_units;

    // Values of a wrong kind.
    nothing;
    a_number(number);
    a_text(text);
    empty_list;
    list_of(count);
    an_object;
    unknown_key(key);
    the_keys_are(all);
    unknown_word(word);
    write_one_of(all);
    write_truth_or_one_of(all);
    missing(key);
    expected_found(expected, found);
    in_double_quotes(number);
    add(json);
    add_on;
    add_length_unit;
    add_time_unit;
    add_speed;
    without_quotes(number);
    with_a_point(number);
    or_as_rpm(number);
    in_degrees(number);
    rpm_for_omega(number);
    units_in_units(number);
    two_numbers(count);
    negative_size(size);
    no_page(name);
    no_unit(name);
    did_you_mean(name);
    joints_out_of_scope;
    forces_out_of_scope;

    // What a form asks for.
    form_asks_nothing;
    form_no_quantity(name);
    form_no_marks(marks);
    form_marks_from_0(most);
    no_hints(count);
    hints_from_0(most);
    form_names_quantities;

    // Names.
    a_point;
    a_link;
    no_name(what);
    write_a_name;
    name_too_long(what, most);
    write_prime;
    write_underscore;
    signs_of_names;
    sign_in_name(name, what, sign);
    called_note(what);
    called_ground;
    point_twice(point);
    point_twice_in_link(point, link);
    link_named(link);
    point_named(point);
    the_ground;
    lacks_point(carrier, point);
    lacks_point_but(carrier, point, only);
    lacks_point_of(carrier, point, all);
    lengths_key(key);
    along_key(key);
    pair_unknown(key, why);
    pair_ambiguous(key, a, b, c, d);
    pair_same(key, point);
    write_pair(a, b, c, d);
    no_link(link);
    the_links_are(all);
    no_point(point);
    the_points_are(all);
    name_kept(name, what);
    other_name;
    image_of(point);
    special_point_of(link);
    point_under(link, point);

    // Points, ground, known motions.
    no_coordinates;
    write_coordinates;
    other_coordinates(point);
    name_only;
    not_in_points(point);
    add_to_points(point);
    on_no_link(point);
    name_in_link;
    known_is_drawn;
    points_or_drive;
    ground_moves_not(point);
    remove_from_ground;
    motion_twice(point, first, second);
    motion_already(point, by);
    keep_one;
    motion_of_link(link);
    drive_of_link(link);
    drive_of_slider(link);
    drive_of_its_slider;
    drawn_needs_no_near;
    /// Why a drawn configuration refuses a key.
    remove_it_drawn;
    remove_drawn(key);
    near_one_number(key);
    near_two_numbers(point);

    // Links and their drives.
    no_links;
    lengths_and_shape(link);
    drive_and_motion(link);
    two_angles(link);
    link_motion_is_drawn(link);
    points_or_drive_link;
    link_is_drawn(link, key);
    remove_or_lengths(key);
    no_points(link);
    too_many_points(link, count);
    give_shape(a, b);
    no_distance(link, from, to);
    three_lengths(link, from, to);
    add_lengths(key);
    add_to_lengths(key);
    length_twice(key, link, first);
    length_zero(key, from, to);
    one_name_or_length;
    length_negative(key, value);
    no_triangle(link, lengths, one, other, long);
    shape_empty(link);
    add_or_without_points;
    shape_lacks(link, point);
    add_place(point);
    zero_length(link, first, second);
    one_name_or_move;
    drive_is_drawn(link, key);
    omega_and_rpm(link);
    drive_without_speed(link);
    add_omega;
    pushes_and_turns(link);
    push_or_turn;
    push_without_speed(link);

    // Sliders.
    slides_on_own(point, carrier);
    other_sliding_name;
    no_frame(carrier);
    point_or_shape(carrier);
    point_or_without(carrier);
    no_direction;
    give_direction;
    no_axis(carrier);
    give_drawn_direction;
    degrees_unquoted(number);
    one_place(from, to);
    two_drives(link);
    which_slider(link);
    drive_into_sliders;
    pushed_without_slider(link);
    add_slider;
    idle_link(link);
    remove_or_name;
    guide_nowhere(carrier);
    add_through;
    name_on_guide(link);
    turned_is_drawn;
    position_is_drawn;
    nothing_slides;
    give_link_or_pin;
    pin_and_link;
    block_or_pin;
    add_at(link);
    add_link_or_pin(point);
    slides_on_itself(link);

    // The figure.
    scale_is(key, what);
    scale_too_large(scale, most);
    scale_not_positive(scale);
    next_scale;
    no_panels;
    name_panels(all);
    panel_twice;
    step_from_one;
    steps_listed;
    frame_is_link(link);
    other_frame;
    ghosts_between(least, most, count);
    drawn_has_no_path(point);
    drawn_has_no_ghosts;
    lengths_and_drive;
    no_drive_no_path(point);
    no_drive_no_ghosts;
    give_drive;
    moving_points(all);
    ground_has_no_path(point);
    name_of_construction(name);
    no_center(name);
    name_center;
    center_twice(name);
    ground_is_at_rest(point);

    // How large a scene may be.
    a_scene;
    a_figure;
    a_figure_with_steps;
    by_hand;
    too_many_links(what, most, count);
    too_many_points_in(what, most, count);
    divide_mechanism;

    // What stands after "expected": types say it in English to serde, which hands over nothing but text.
    expects_two_numbers;
    expects_place_on_link;
    expects_rough_place;
    expects_point_or_place;
    expects_direction;
    expects_vector;
    expects_link;
    expects_a_link;
    expects_ground;
    expects_drive;
    expects_push;
    expects_motion;
    expects_link_motion;
    expects_slider;
    expects_scene;
    expects_figure;
    expects_centers;
    expects_units;
    expects_truth_or_paper;
    expects_truth_or_unit;
    expects_truth;
    expects_whole_number;
    expects_number;
    expects_text;
    expects_list;
    expects_object;
}

/// What stands after "expected", as the type says it in English.
pub(super) fn expected(by_type: &str) -> Message {
    let says = |known: &&Declared| english().sentence(known.key).and_then(Sentence::words) == Some(by_type);
    let found = DECLARED.iter().filter(|known| known.key.starts_with("scene-expects_")).find(says);
    found.map_or_else(|| by_type.into(), |known| Message::of(known, Vec::new()))
}
