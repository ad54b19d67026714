//! What errors and warnings of a mechanism's structure say.

use crate::message::messages;

messages! { "mechanism":
    nothing_to_solve;
    add_links;
    over_no_slider(name);
    over_no_zero(name);
    friction_no_slider(name);
    the_sliders_are(names);
    friction_no_joint(point);
    friction_of_contact(joint);
    no_friction_of_contact;
    pin_of_several(point, links);
    write_fixed_in(link);
    pin_of_two(point);
    leave_fixed_in_out;
    angle_of_another(link);
    angle_in_drive;
    mirror_image(link, points);
    singular(links, class, pattern);
    make_revolute;

    // Too few or too many constraints.
    one_link(link);
    several_links(links);
    one_free_motion;
    free_motions(count);
    can_still_move(links, free);
    add_a_drive;
    add_drives(count);
    one_constraint;
    constraints(count);
    cannot_move(links, surplus);
    take_away;
    one_drive;
    drives(count);
    mobility(links, constraints, mobility, drives);

    // Gear pairs.
    train_without_ratio(links);
    other_teeth;
    two_radii(link, teeth, first, second);
    belt_without_room(first, second, radii, distance);

    // Guides.
    along_its_x_axis(link, points, turned);
    off_guide(slider, position, low, high);

    // Contacts.
    holds_here_alone(first, second);

    // Drives.
    one_ground_point(link, count);
    list_pivot;
    driven_link(link);
    driven_slider(slider);
    two_angles(first, second);
    remove_one;
    angle_without_drive(link);
    add_drive;
    /// `key` is the word of the scene for where the drive stands.
    angle_beside(link, driven, key);
    keep_one;
    angle_beside_all(link);
    two_open_drives(first, second, link);
    add_to_one(key);
    open_drive(driven, key);
    add_angle;
    add_position;

    // Angles that look like radians.
    angle_of_link(link);
    guide_of(slider);
    near_angle_of(link);
    radians(what, angle, degrees);

    // Places far away.
    far_origin(far, size, digits);
}
