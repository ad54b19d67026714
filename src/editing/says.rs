//! What errors of changes say, and why a joint that is pulled does not follow the hand.

use crate::message::messages;

messages! { "editing":
    no_object;
    no_entry(count, key);
    no_room(key);
    not_all;
    point_twice(point);
    no_points;
    name_one;
    point_on_link(link, point);
    link_unknown(link);
    point_unknown(point);
    rough_places;
    slides_on_own(point, on);
    other_point;
    in_one_place(link, first, second);
    one_name_or_move;
    no_place;
    drawn;
    give_lengths;
    no_position;
    other_position;
    near_cannot_choose(mode);
    point_there(name);
    link_there(name);
    other_name;
    no_point(name);
    no_link(name);

    // Tables of loads in files.
    table_no_number(line, column);
    table_one_column;
    table_line;
    table_first;
    table_more_cells(line, cells, first);
    table_marks;
    table_unnamed;
    table_head;
    table_no_column(load);
    table_nameless;
    table_name;
    table_long(most);
    table_shorten;

    // Why a joint that is pulled does not follow the hand.
    held_point(point);
    held_length(point, length);
    held_angle(point, link);
    held_guide(point, slider);
    held_rack(point);
    held_nowhere;
    held_rounded;
    held_try;
}
