//! What errors and warnings of a mechanism's structure say.

use crate::message::messages;

messages! { "mechanism":
    nothing_to_solve = "nothing to solve: every link's motion is given";
    add_links = "add links between the driven links, the known points and the ground";
    angle_of_another(link) =
        "the angle of link {link} cannot stand in place of the drive's: it does not change with that drive";
    angle_in_drive = "say in the drive where it stands, or give the angle of a link that turns with it";
    mirror_image(link, points) =
        "link {link}: its lengths fit a triangle and its mirror image; the counter-clockwise one {points} is taken. \
         Give rough places of its points in `near` to choose";
    singular(links, class, pattern) =
        "links {links} have no definite motion in any position: a group of class {class} with its prismatic joints as in \
         {pattern} is singular by its structure";
    make_revolute = "make one of the prismatic joints revolute";

    // Too few or too many constraints.
    one_link(link) = "link {link}";
    several_links(links) = "links {links}";
    one_free_motion = "1 free motion";
    free_motions(count) = "{count} free motions";
    can_still_move(links, free) = "{links} can still move ({free} left)";
    add_a_drive = "add 1 drive or a joint there";
    add_drives(count) = "add {count} drives or a joint there";
    one_constraint = "1 constraint";
    constraints(count) = "{count} constraints";
    cannot_move(links, surplus) = "{links} cannot move as driven ({surplus} too many)";
    take_away = "take a drive or a joint away there";
    one_drive = "1 drive";
    drives(count) = "{count} drives";
    mobility(links, constraints, mobility, drives) = "mobility 3·{links} − {constraints} = {mobility} with {drives}";

    // Drives.
    one_ground_point(link, count) = "link {link} is driven, so it must have one point on the ground; it has {count}";
    list_pivot = "list the point about which it turns in `ground` and among the link's points";
    driven_link(link) = "link {link}";
    driven_slider(slider) = "slider {slider}";
    two_angles(first, second) =
        "links {first} and {second} both give an angle; that of one link can stand in place of a drive's";
    remove_one = "remove one of them; approximate angles stand in `near`";
    angle_without_drive(link) = "link {link} gives an angle, but no link has a drive";
    add_drive = "add a drive with `omega` to the link that turns about a ground point";
    /// `key` is the word of the scene for where the drive stands.
    angle_beside(link, driven, key) = "link {link} gives an angle, but the drive of {driven} gives its {key} already";
    keep_one = "keep one of them; an approximate angle stands in `near`";
    angle_beside_all(link) = "link {link} gives an angle, but every drive says already where it stands";
    two_open_drives(first, second, link) =
        "the drives of {first} and {second} do not say where they stand; the angle of link {link} stands in place of one \
         only";
    add_to_one(key) = "add \"{key}\" to one of them";
    open_drive(driven, key) = "the drive of {driven} gives no `{key}`";
    add_angle = "add \"angle\": degrees from +x to the link's axis; or give another link's `angle` in its place";
    add_position =
        "add \"position\": its distance along the guide from `through`; or give a link's `angle` in its place";

    // Angles that look like radians.
    angle_of_link(link) = "the angle of link {link}";
    guide_of(slider) = "the guide of {slider}";
    near_angle_of(link) = "`near` for angle({link})";
    radians(what, angle, degrees) =
        "{what} is taken as {angle}°, which looks like radians: angles are in degrees, so {degrees} if that is meant";

    // Places far away.
    far_origin(far, size, digits) =
        "the origin lies {far} from a mechanism of about {size}: of places with 16 digits, {digits} are left for its shape. \
         Let the origin be near";
}
