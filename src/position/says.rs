//! What errors and warnings of the assembly say.

use crate::message::messages;

messages! { "position":
    /// `at` is empty, or where the drives stand.
    no_mode(links, at, miss);
    other_angle_or_lengths;
    angle_from_to(from, to);
    angle_within_or_lengths(ranges);
    /// Begins with a space: it stands behind names.
    at_value(quantity, value);
    longer(leg, by);
    shorter(leg, by);
    any_direction;
    never_meet;
    parallel_guides(links, link);
    turn_one;
    too_large(size);
    too_small(size);
    other_unit;
    no_such_mode(mode, count);
    modes_listed;
    too_many_modes(mode, count);
    rough_places_choose;
    too_much_work;
    rough_places;
    not_found(links, at, tried);
    rough_places_or_other;
    moves(links);
    none_closes(starts);
    none_closes_but(starts, gap);

    // Warnings.
    unproven;
    at_least(count);
    far_off(distance, count, size);
    point_far_off(point, x, y, off, count);
    not_chosen(links, count, listed);
    searched(links);
    searched_of(links, found, most);
    may_move(links);
    nearly_flat(link);
}
