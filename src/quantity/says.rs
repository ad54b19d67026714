//! What errors of quantities say.

use crate::message::messages;

messages! { "quantity":
    no_quantity(name) =
        "`{name}` is no quantity; known forms: omega(2) alpha(2) angle(2) x(D) y(D) v(D) a(D) v(D/G) a(D/G) a_n(D/G) \
         a_t(D/G) a_c(3/2) position(3/2) v_r(3/2) a_r(3/2) L(B,S3) vplan(b,s3) aplan(n_b3,s3); vectors also with .x .y \
         .size .angle, plan segments with /mu";
    no_link(quantity, name) = "`{quantity}`: there is no link `{name}` here";
    no_slider(quantity, name) = "`{quantity}`: there is no slider `{name}` here";
    no_point(quantity, name) = "`{quantity}`: there is no point `{name}` here";
    no_plan_point(quantity, name) = "`{quantity}`: there is no plan point `{name}` here";
    did_you_mean(message, name) = "{message}; did you mean `{name}`?";
    no_value(quantity, why) = "`{quantity}` has no value here: {why}";
    on_paper = "a length on paper belongs to the figure of one position";
    without_mu = "the name without `/mu`";
    no_accelerations = "accelerations were not asked for";
    no_axis = "the link has no axis";
    no_zero = "the guide has no point to count from";
    no_plan_no_scale = "the figure has no such plan, so no scale";
    scale_too_small = "the scale is too small for it";
    no_construction = "there is no construction";
    at_infinity = "the special point lies at infinity";
    not_on_one_link = "the two points are not on one link";
    no_plan = "there is no such plan";
    nowhere_in_range = "it has none at any position of the range";
    no_scale_in_table = "a table has no scale";
}
