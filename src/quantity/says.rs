//! What errors of quantities say.

use crate::message::messages;

messages! { "quantity":
    no_quantity(name);
    no_link(quantity, name);
    no_slider(quantity, name);
    no_point(quantity, name);
    no_load(quantity, name);
    no_plan_point(quantity, name);
    did_you_mean(message, name);
    no_value(quantity, why);
    on_paper;
    without_mu;
    no_accelerations;
    no_axis;
    no_zero;
    no_plan_no_scale;
    scale_too_small;
    no_construction;
    at_infinity;
    not_on_one_link;
    no_plan;
    no_force_plan;
    two_polygons;
    routes_differ;
    no_way;
    centre_at_infinity;
    centre_at_place;
    rest_on_another;
    link_turns_not;
    ratio_to_rest(link);
    path_is_straight;
    place_has_no_size(name);
    no_loads;
    no_mass;
    no_inertia;
    no_line_of_joints;
    no_normal_force;
    no_line_of_action;
    not_driven;
    not_at_pin;
    no_forces;
    nowhere_in_range;
    no_scale_in_table;
}
