//! Sentences of the mechanism itself: its structure, its special positions, what holds a joint.

sentences! {
    Group::Mechanism =>

    // Special positions on the way of a drive; `place` is the drive's value, as in `angle(1) = 30°`.
    /// Two branches meet, and the drive can go no further.
    event_limit(place, links);
    /// A place runs off to infinity.
    event_runs_off(place, links);
    /// Two branches cross.
    event_change(place, links);
    /// A singular position of another kind.
    event_singular(place, links);
    /// A link stops at an angle, in degrees, and turns back.
    event_turns_back(place, link, angle);
    /// A slider stops at a position on its guide and slides back.
    event_slides_back(place, slider, position);
    /// That more extreme positions and change points are not listed.
    events_left_out(count);

    // The structure: Assur groups in solving order.
    /// Degrees of freedom.
    structure_freedoms(count);
    /// Known motions, separated by commas.
    structure_known(motions);
    /// Drives beside known motions.
    structure_drives(count, motions);
    /// The groups by which positions follow from a given angle.
    structure_positions(angle, groups);
    /// A group: its links, its class, of what it is made.
    structure_group(links, class, shape);
    /// The special points of a group.
    structure_special_points(points);
    /// Of what a group of class II is made.
    shape_second;
    /// Of class III.
    shape_third;
    /// Of class IV.
    shape_fourth;
    /// Of a higher class.
    shape_higher;

    // The list of assembly modes.
    /// One mode.
    modes_one(count);
    /// Several modes.
    modes_many(count);
    /// A number of modes where counting was stopped.
    modes_at_least(count);
    /// Behind the number of modes where not all are listed.
    modes_listed(modes, listed);
    /// The line above the list: the number of modes and the unit of coordinates.
    modes_heading(modes, unit);
    /// That a group's modes were found by a search.
    modes_searched(links);

    // Why a joint that is pulled does not follow the hand.
    /// The point is pinned.
    held_point(point);
    /// A length is pinned, so that the point goes on a circle.
    held_length(point, length);
    /// A link's angle is pinned, so that the point stays on its line.
    held_angle(point, link);
    /// A guide would come off what slides on it.
    held_guide(point, slider);
    /// The joint's place fits no mechanism.
    held_nowhere;
    /// Two points of a link would be in one place.
    held_in_one_place(link, point, other);
    /// Other joints would jump, as lengths are rounded.
    held_rounded;
    /// What to do instead.
    held_try;
}
