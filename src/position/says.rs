//! What errors and warnings of the assembly say.

use crate::message::messages;

messages! { "position":
    /// `at` is empty, or where the drives stand.
    no_mode(links, at, miss) = "links {links} cannot be assembled{at}: {miss}";
    other_angle_or_lengths = "another drive angle, or other lengths";
    /// Begins with a space: it stands behind names.
    at_value(quantity, value) = " at {quantity} = {value}";
    longer(leg, by) = "with everything else closed, {leg} would have to be {by} longer";
    shorter(leg, by) = "with everything else closed, {leg} would have to be {by} shorter";
    any_direction =
        "its outer joints lie in one place and its lengths are equal, so it can turn there by any angle";
    never_meet = "its guides and lengths never meet";
    parallel_guides(links, link) =
        "links {links} cannot be assembled: the two guides that meet at link {link} are parallel";
    turn_one =
        "`turned` of one of its sliders, the degrees from the guide to the link's axis, sets them at an angle";
    too_large(size) =
        "lengths of about {size} are too large to assemble from: their fourth powers leave the range of numbers";
    too_small(size) =
        "lengths of about {size} are too small to assemble from: their fourth powers leave the range of numbers";
    other_unit = "another unit of length";
    no_such_mode(mode, count) = "there is no assembly mode {mode}: there are {count}";
    modes_listed = "`kinegon modes` lists them";
    too_many_modes(mode, count) = "assembly mode {mode} is too far on: counting was stopped after {count}";
    rough_places_choose = "rough places in `near`, which choose without counting";
    too_much_work = "no way to assemble all links was found: the first ones can be put together in too many ways";
    rough_places = "rough places of their points in `near`";
    not_found(links, at, tried) = "no way to assemble links {links}{at} was found: {tried}";
    rough_places_or_other = "rough places of their points in `near`, another drive angle, or other lengths";
    none_closes(starts) = "none of {starts} starts closes";
    none_closes_but(starts, gap) =
        "none of {starts} starts closes, the nearest leaves a gap of {gap} of the mechanism's size";

    // Warnings.
    unproven =
        "`near` leaves too many assemblies open to compare them all, and the one taken may not be the nearest: give rough \
         places of more points in it";
    at_least(count) = "at least {count}";
    far_off(distance, count, size) =
        "`near` is {distance} away (root mean square) from the closest of {count} assembly modes, more than half the \
         mechanism's size {size}: check its coordinates";
    point_far_off(point, x, y, off, count) =
        "point {point} is at [{x}, {y}], {off} away from its place in `near`, in the closest of {count} assembly modes: \
         check its coordinates";
    not_chosen(links, count, listed) =
        "links {links} can be assembled in {count} ways and `near` is not given, so mode 1 is taken: {listed}";
    searched(links) =
        "links {links} form a group of higher class: its assembly modes were found by a search, and there may be more";
    nearly_flat(link) =
        "link {link}: its points lie nearly on a line, and `near` fits its triangle and the mirror image almost equally \
         well; the nearer one is taken. Give its `shape`, or places in `near` with more digits, to choose";
}
