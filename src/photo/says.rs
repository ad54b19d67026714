//! What is said of a photograph that is of no use, or of less.

use crate::message::messages;

messages! { "photo":
    no_sheet;
    one_marker;
    few_markers(count);
    whole_sheet;
    cut_off;
    step_back;
    mirrored;
    unmirror;
    not_even(mm);
    bent(mm);
    flatten;
    blurred(mm);
    nearer;
    no_code;
    light_on_code;
    other_page;
    one_whole_sheet;
    cut_short;
    send_again;

    second_sheet;
    each_by_itself;
    nothing_drawn;
    nothing_in_blur(mm);
    mark_by_hand;
    scaled(percent);
    scaled_down(percent);
    measure_ruler;
}
