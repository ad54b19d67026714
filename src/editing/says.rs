//! What errors of changes say, and why a joint that is pulled does not follow the hand.

use crate::message::messages;

messages! { "editing":
    no_object = "a scene is an object { … }";
    no_entry(count, key) = "this list has {count} entries, and no {key}";
    no_room(key) = "there is no place for {key} here";
    not_all = "a scene cannot be removed from its text";
    point_twice(point) = "point {point} stands twice in the new link";
    no_points = "a new link has no points";
    name_one = "name at least one";
    point_on_link(link, point) = "link {link} has a point {point} already";
    link_unknown(link) = "it is not known where link {link} is in the present position";
    point_unknown(point) = "it is not known where point {point} is in the present position";
    rough_places = "give rough places in `near`";
    slides_on_own(point, on) = "point {point} is a point of {on}, so it cannot slide on it";
    other_point = "choose another point, or another carrier of the guide";
    in_one_place(link, first, second) = "link {link} would have {first} and {second} in one place";
    one_name_or_move = "use one name for both, or move one";
    no_place = "this is no place";
    drawn = "a drawn configuration cannot be moved";
    give_lengths = "give the mechanism by lengths, with a drive";
    no_position = "the position cannot be written as values of the drives";
    other_position = "take another position";
    near_cannot_choose(mode) = "rough places cannot choose mode {mode}";
    point_there(name) = "there is a point {name} already";
    link_there(name) = "there is a link {name} already";
    other_name = "choose another name";
    no_point(name) = "there is no point {name}";
    no_link(name) = "there is no link {name}";

    // Why a joint that is pulled does not follow the hand.
    held_point(point) = "{point} is pinned";
    held_length(point, length) = "{point} moves on a circle: {length} is pinned";
    held_angle(point, link) = "{point} moves on a line: the angle of link {link} is pinned";
    held_guide(point, slider) = "{point} moves on a line: the guide of {slider}";
    held_nowhere = "the joint cannot go there";
    held_rounded = "with the joint there, rounded lengths leave the other joints no place near their own";
    held_try = "pull the joint to another place";
}
