//! What errors of scenes, and of other files that are read as strictly, say.

use crate::message::{Message, messages};

messages! { "scene":
    // Kinds of files.
    scene = "scene";
    study = "study";
    style = "style";
    form = "form of measured values";
    marks = "marking scheme";
    begins_with(what, start) = "a {what} begins with {start}";
    too_many_bytes(what, bytes, most, mib) = "the {what} has {bytes} bytes; at most {most} ({mib} MiB) are read";
    is_empty(what) = "the {what} is empty";
    expected_object(what, start, found) = "expected a {what} as {start}, found {found}";
    meant_key(key, other) = "did you mean `{key}` by `{other}`?";
    add_version(key, version, what) = "add \"{key}\": {version}, the version of the {what} format";
    no_version(key, what) = "`{key}` is missing, so this may be something other than a {what}";
    other_version(version, what, said) = "this program reads version {version}, the {what} says {said}";
    version_is_number(version, found) = "expected the number {version}, the version of the format, found {found}";
    write_version(key, version) = "write \"{key}\": {version}";

    // Text that is not JSON.
    not_json(what) = "this is not JSON: {what}";
    not_json_at_all = "this is not JSON";
    text_over_lines = "a text ends on the line it begins on";
    add_quote_or_n = "add the missing \", or write \\n for a line break";
    control_in_text = "a text holds a tab or another control character";
    write_t = "write \\t for a tab";
    too_deep(most) = "brackets are nested deeper than {most} levels";
    no_comments = "JSON has no comments";
    write_note = "write \"note\": \"…\", which is allowed anywhere";
    trailing_comma = "a comma stands before the closing bracket";
    remove_comma = "remove the comma";
    leading_zero = "a number does not begin with 0";
    remove_zero = "remove the leading 0";
    comma_missing = "a comma is missing here";
    brace_open = "this { is never closed";
    add_brace = "add the missing }";
    bracket_open = "this [ is never closed";
    add_bracket = "add the missing ]";
    brace_for_value = "a } stands where a value should be";
    bracket_for_value = "a ] stands where a value should be";
    comma_for_value = "a comma stands where a value should be";
    colon_for_value = "a colon stands where a value should be";
    colon_missing = "a colon is missing after this key";
    value_missing = "the value of this key is missing";
    after_end(what) = "something stands after the end of the {what}";
    one_in_a_file(what) = "a file holds one {what}, in one pair of { }";
    single_quotes = "texts stand in double quotes";
    write_double = "write \"A\" in place of 'A'";
    key_needs_quotes(word) = "the key {word} needs double quotes";
    write_key_value = "write \"key\": value";
    no_number(word) = "{word} is not a number";
    every_number_finite(what) = "every number of a {what} is finite; leave the key out where a value is not known";
    not_here(sign) = "{sign} does not belong here";
    no_value(word) = "{word} is not a value";
    leave_key_out = "leave the key out";
    write_true = "write true";
    write_false = "write false";
    names_in_quotes = "texts and names stand in double quotes";
    plus_sign = "a number has no plus sign before it";
    remove_plus = "remove the +";
    decimal_only = "numbers are decimal";
    digits_both_sides = "a decimal point needs digits on both sides";
    write_half = "write 0.5 for .5, and 5.0 for 5.";
    number_incomplete = "this number is not complete";
    no_escape = "a \\ in a text begins an escape, and this is none";
    write_backslash = "write \\\\ for the character \\";
    text_open = "this text is never closed";
    add_quote = "add the missing \"";
    null = "null is not a value here";
    key_twice(key, line) = "key `{key}` stands twice: first at line {line}";
    number_too_large(number) = "{number} is too large to compute with";
    choose_units = "choose units that make it less than 1e100";

    // Values of a wrong kind.
    nothing = "nothing";
    a_number(number) = "the number {number}";
    a_text(text) = "the text \"{text}\"";
    empty_list = "an empty list";
    list_of(count) = "a list of {count}";
    an_object = "an object { … }";
    unknown_key(key) = "unknown key `{key}`";
    the_keys_are(all) = "the keys here are {all}";
    unknown_word(word) = "unknown word \"{word}\"";
    write_one_of(all) = "write one of {all}";
    write_truth_or_one_of(all) = "write true, false or one of {all}";
    missing(key) = "`{key}` is missing";
    expected_found(expected, found) = "expected {expected}, found {found}";
    in_double_quotes(number) = "write \"{number}\" in double quotes";
    add(json) = "add {json}";
    add_on = "add \"on\", the link that carries the guide, or \"ground\"";
    add_length_unit = "add \"length\": \"m\", \"mm\", \"cm\", \"in\" or \"ft\"";
    add_time_unit = "add \"time\": \"s\" or \"min\"";
    add_speed = "add \"speed\", along the guide";
    without_quotes(number) = "write {number} without quotes";
    with_a_point(number) = "write {number} without quotes and with a point";
    or_as_rpm(number) = "write {number} without quotes, or the speed as \"rpm\"";
    in_degrees(number) = "angles are in degrees: write {number} without quotes";
    rpm_for_omega(number) = "write \"rpm\": {number} in place of \"omega\"";
    units_in_units(number) = "write {number} without quotes; units stand in `units`, angles are in degrees";
    two_numbers(count) = "expected two numbers [x, y], found a list of {count}";
    negative_size(size) = "size is {size}; a size is not negative: turn the angle by 180 instead";
    no_page(name) = "there is no page \"{name}\"";
    no_unit(name) = "there is no unit of length \"{name}\"";
    did_you_mean(name) = "did you mean `{name}`?";
    joints_out_of_scope =
        "links are joined by pins and straight sliders: gears, belts, chains, racks and cams are out of scope";
    forces_out_of_scope = "motions follow from the drives: forces, masses, springs and friction are out of scope";

    // What a form asks for.
    form_asks_nothing = "this form asks for nothing";
    form_no_quantity(name) = "{name} is no name of a quantity";
    form_no_marks(marks) = "{marks} are no marks";
    form_marks_from_0(most) = "marks are 0 to {most}";
    no_hints(count) = "{count} is no number of stages of a hint";
    hints_from_0(most) = "write 0 (no hints) to {most} (all)";
    form_names_quantities = "write names as an empty form has them: \"omega(2)\", \"vplan(p,b)\"";

    // Names.
    a_point = "a point";
    a_link = "a link";
    no_name(what) = "{what} has no name";
    write_a_name = "write a letter or a number between the quotes";
    name_too_long(what, most) = "the name of {what} has more than {most} characters";
    write_prime = "write ' for a prime";
    write_underscore = "write _ in place of -, which joins two points";
    signs_of_names = "names have letters, digits, ' and _";
    sign_in_name(name, what, sign) = "the name `{name}` of {what} contains `{sign}`";
    called_note(what) = "{what} cannot be called `note`: that key is for notes";
    called_ground = "a link cannot be called `ground`: that is the frame";
    point_twice(point) = "point {point} stands twice";
    point_twice_in_link(point, link) = "point {point} stands twice in link {link}";
    link_named(link) = "link {link}";
    point_named(point) = "point {point}";
    the_ground = "the ground";
    lacks_point(carrier, point) = "{carrier} has no point {point}; it has no points";
    lacks_point_but(carrier, point, only) = "{carrier} has no point {point}; its only point is {only}";
    lacks_point_of(carrier, point, all) = "{carrier} has no point {point}; its points are {all}";
    lengths_key(key) = "lengths key `{key}`";
    along_key(key) = "along `{key}`";
    pair_unknown(key, why) = "{key}: {why}";
    pair_ambiguous(key, a, b, c, d) = "{key} can mean {a} and {b}, or {c} and {d}";
    pair_same(key, point) = "{key} names the point {point} twice";
    write_pair(a, b, c, d) = "write \"{a}-{b}\" or \"{c}-{d}\"";
    no_link(link) = "there is no link {link}";
    the_links_are(all) = "the links are {all}";
    no_point(point) = "there is no point {point}";
    the_points_are(all) = "the points are {all}";
    name_kept(name, what) = "the name `{name}` is kept for {what}";
    other_name = "choose another name for the point";
    image_of(point) = "the image of {point} in the plans";
    special_point_of(link) = "the special point of link {link}";
    point_under(link, point) = "the point of link {link} under {point}";

    // Points, ground, known motions.
    no_coordinates = "the frame's points have no coordinates";
    write_coordinates = "write { \"A\": [x, y], … }; or give the coordinates of every point in \"points\": { … }";
    other_coordinates(point) = "point {point} has other coordinates in `points`";
    name_only = "name it only in a list: \"ground\": [\"A\", …]";
    not_in_points(point) = "point {point} has no coordinates in `points`";
    add_to_points(point) = "add \"{point}\": [x, y] to `points`";
    on_no_link(point) = "point {point} is on no link and not on the ground";
    name_in_link = "name it in the `points` of a link, or remove it";
    known_is_drawn = "known motions belong to a drawn configuration";
    points_or_drive = "give the coordinates of every point in \"points\": { … }, or drive a link";
    ground_moves_not(point) = "point {point} is on the ground, which does not move";
    remove_from_ground = "remove it here or from `ground`";
    motion_twice(point, first, second) = "the motion of point {point} is given twice: by {first} and by {second}";
    motion_already(point, by) = "the motion of point {point} is given already, by {by}";
    keep_one = "keep one of them";
    motion_of_link(link) = "the `motion` of link {link}";
    drive_of_link(link) = "the drive of link {link}";
    drive_of_slider(link) = "the drive of slider {link}";
    drive_of_its_slider = "the drive of its slider";
    drawn_needs_no_near = "a drawn configuration needs no `near`";
    /// Why a drawn configuration refuses a key.
    remove_it_drawn = "remove it: the drawing, `points`, gives it already";
    remove_drawn(key) = "remove `{key}`: the drawing, `points`, gives it already";
    near_one_number(key) = "{key} is one number, in degrees, not two";
    near_two_numbers(point) = "point {point} needs two numbers [x, y], found one";

    // Links and their drives.
    no_links = "a mechanism has at least one link";
    lengths_and_shape(link) = "link {link} has both `lengths` and `shape`";
    drive_and_motion(link) = "link {link} has both a drive and a known motion";
    two_angles(link) = "link {link} has an angle and its drive has one too";
    link_motion_is_drawn(link) = "link {link}: a known `motion` belongs to a drawn configuration";
    points_or_drive_link = "give the coordinates of every point in \"points\": { … }, or drive the link";
    link_is_drawn(link, key) = "link {link} has `{key}`, but this scene is a drawn configuration";
    remove_or_lengths(key) =
        "remove `{key}`: the drawing, `points`, gives it already; or remove `points` and give `ground` its coordinates";
    no_points(link) = "link {link} has no `points`";
    too_many_points(link, count) = "link {link} has {count} points, which lengths do not fix";
    give_shape(a, b) =
        "give coordinates in the link's own frame: \"shape\": { \"{a}\": [x, y], \"{b}\": [x, y], … }";
    no_distance(link, from, to) = "link {link} has the points {from} and {to}, but not their distance";
    three_lengths(link, from, to) =
        "link {link} has three points, which need three lengths; that of {from} and {to} is missing";
    add_lengths(key) = "add \"lengths\": { \"{key}\": … }, or give a `shape`";
    add_to_lengths(key) = "add \"{key}\": … to its lengths";
    length_twice(key, link, first) = "the length {key} of link {link} is given already, as {first}";
    length_zero(key, from, to) = "length {key} is 0: {from} and {to} would be one point";
    one_name_or_length = "use one name for both, or give a positive length";
    length_negative(key, value) = "length {key} is {value}; a length is positive";
    no_triangle(link, lengths, one, other, long) =
        "link {link}: lengths {lengths} cannot form a triangle: {one} + {other} < {long}";
    shape_empty(link) = "the shape of link {link} has no points";
    add_or_without_points = "add it to `points`, or leave `points` out";
    shape_lacks(link, point) = "the shape of link {link} does not say where {point} is";
    add_place(point) = "add \"{point}\": [x, y]";
    zero_length(link, first, second) = "link {link} has {first} and {second} in one place: a zero-length link";
    one_name_or_move = "use one name for both, or move one";
    drive_is_drawn(link, key) = "the drive of link {link} has `{key}`, but this scene is a drawn configuration";
    omega_and_rpm(link) = "the drive of link {link} has both `omega` and `rpm`";
    drive_without_speed(link) = "the drive of link {link} has no speed";
    add_omega = "add \"omega\" (radians per unit of time) or \"rpm\"; for a sliding link \"speed\"";
    pushes_and_turns(link) = "the drive of link {link} both pushes and turns";
    push_or_turn = "a drive has `position`, `speed`, `acceleration`, or `angle`, `omega`, `alpha`";
    push_without_speed(link) = "the drive of link {link} has no `speed`";

    // Sliders.
    slides_on_own(point, carrier) = "point {point} is a point of {carrier}, so it cannot slide on it";
    other_sliding_name = "use another name for the point that slides";
    no_frame(carrier) = "coordinates need a frame, and {carrier} has no `shape`";
    point_or_shape(carrier) = "name a point of {carrier}, or give the link a `shape`";
    point_or_without(carrier) =
        "name a point of {carrier}, or leave `through` out: the guide passes through the slider's point";
    no_direction = "a direction of size zero points nowhere";
    give_direction = "give [dx, dy] or degrees";
    no_axis(carrier) = "{carrier} has no points and so no axis to count degrees from";
    give_drawn_direction = "give the direction as drawn: \"along\": [dx, dy]";
    degrees_unquoted(number) = "write {number} without quotes for degrees";
    one_place(from, to) = "{from} and {to} are in one place, so they give no direction";
    two_drives(link) = "link {link} has a drive, and so has its slider";
    which_slider(link) = "link {link} has two sliders, and its drive does not say which one it pushes";
    drive_into_sliders = "move the drive into one of the entries of `sliders`";
    pushed_without_slider(link) = "link {link} is pushed by its drive, but it has no slider";
    add_slider = "add an entry to `sliders` with this `link`, or turn the link with `omega`";
    idle_link(link) = "link {link} has no points, and nothing slides on it";
    remove_or_name = "remove it, or name its points";
    guide_nowhere(carrier) = "nothing says where the guide is: {carrier} has no points";
    add_through = "add \"through\": [x, y], a place on the guide";
    name_on_guide(link) = "name a point of link {link} that is on the guide";
    turned_is_drawn = "`turned` has no place in a drawn configuration";
    position_is_drawn = "this drive has `position`, but this scene is a drawn configuration";
    nothing_slides = "this slider does not say what slides";
    give_link_or_pin = "give \"link\" and \"at\", the link and its point on the guide; or \"pin\"";
    pin_and_link = "`pin` stands in place of `link` and `at`, not beside them";
    block_or_pin = "keep `link` and `at` for a block, `pin` for a bare pin";
    add_at(link) = "add \"at\", the point of link {link} that is on the guide";
    add_link_or_pin(point) = "add \"link\", the sliding link; or write \"pin\": \"{point}\" for a pin in a slot";
    slides_on_itself(link) = "link {link} cannot slide on itself";

    // The figure.
    scale_is(key, what) = "`{key}` is {what}";
    scale_too_large(scale, most) = "{scale}; numbers are at most {most}";
    scale_not_positive(scale) = "{scale}; a scale, in units per millimetre of paper, is positive";
    next_scale = "leave it out for the next scale that fits";
    no_panels = "a figure without panels shows nothing";
    name_panels(all) = "name some of {all}, or leave `panels` out";
    panel_twice = "this panel stands twice";
    step_from_one = "steps of the construction are numbered from 1";
    steps_listed = "`kinegon steps` lists them; leave `step` out for the finished figure";
    ghosts_between(least, most, count) = "the number of ghosts is from {least} to {most}, not {count}";
    drawn_has_no_path(point) = "a drawn configuration cannot be moved, so point {point} has no path";
    drawn_has_no_ghosts = "a drawn configuration cannot be moved, so there are no other positions to draw";
    lengths_and_drive = "a scene with `lengths` or `shape` and a drive with its `angle` or `position`";
    no_drive_no_path(point) = "there is no drive to move the mechanism, so point {point} has no path";
    no_drive_no_ghosts = "there is no drive to move the mechanism, so there are no other positions to draw";
    give_drive = "give a link a \"drive\"";
    moving_points(all) = "points that move are {all}";
    ground_has_no_path(point) = "point {point} is on the ground and has no path";
    name_of_construction(name) = "{name} is a name of the construction, and no point of a link";

    // How large a scene may be.
    a_scene = "a scene";
    a_figure = "a figure";
    a_figure_with_steps = "a figure with steps";
    by_hand = "a construction by hand";
    too_many_links(what, most, count) = "{what} has at most {most} links, and here are {count}";
    too_many_points_in(what, most, count) = "{what} has at most {most} points, and here are {count}";
    divide_mechanism = "divide the mechanism: what hangs on the drives alone can be a scene of its own";

    // What stands after "expected": types say it in English to serde, which hands over nothing but text.
    expects_two_numbers = "two numbers [x, y] or { \"size\": …, \"angle\": … }";
    expects_place_on_link = "two numbers [x, y] or one number, the distance along the axis";
    expects_rough_place = "two numbers [x, y], or for an \"angle(…)\" one number, its degrees";
    expects_point_or_place = "the name of a point in double quotes, or its coordinates [x, y]";
    expects_direction = "two points as \"BE\", or a number of degrees, or [dx, dy]";
    expects_vector = "a vector as { \"size\": 150, \"angle\": 210 }";
    expects_link = "a link as { \"points\": [\"A\", \"B\"], … }, or a list of its points [\"A\", \"B\"]";
    expects_a_link = "a link";
    expects_ground = "the frame's points as { \"A\": [x, y], … }, or their names as [\"A\", …]";
    expects_drive = "a drive as { \"angle\": 70, \"omega\": -1 }";
    expects_push = "a drive as { \"position\": 40, \"speed\": 10 }";
    expects_motion = "a motion as { \"velocity\": [x, y], \"acceleration\": [x, y] }";
    expects_link_motion = "a motion as { \"at\": \"B\", \"velocity\": [x, y], \"omega\": 1 }";
    expects_slider = "a slider as { \"link\": \"3\", \"at\": \"D\", \"on\": \"2\", \"along\": \"BE\" }";
    expects_scene = "a scene as { \"kinegon\": 1, … }";
    expects_figure = "a figure as { \"panels\": [\"scheme\", \"velocity\"] }";
    expects_units = "units as { \"length\": \"mm\", \"time\": \"s\" }";
    expects_truth_or_paper = "true, false or \"paper\"";
    expects_truth_or_unit = "true, false or a unit of length";
    expects_truth = "true or false";
    expects_whole_number = "a whole number from 1 to 65535";
    expects_number = "a number";
    expects_text = "a text in double quotes";
    expects_list = "a list [ … ]";
    expects_object = "an object { … }";
}

/// What stands after "expected", as the type says it in English.
pub(super) fn expected(by_type: &str) -> Message {
    let found = DECLARED.iter().find(|known| known.key.starts_with("scene.expects_") && known.english == by_type);
    found.map_or_else(|| by_type.into(), |known| Message::of(known, Vec::new()))
}
