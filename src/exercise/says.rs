//! What is said where there is no exercise.

use crate::message::messages;

messages! { "exercise":
    no_construction =
        "its plans have no construction to be drawn by hand: a special point lies at infinity, or a group is of higher class \
         than IV";
    gave_up(tries, percent, most) =
        "none of {tries} variants can be drawn well by hand; most often ({percent} %) {most}";
    numbers = "the numbers do not fit together";
    assembly = "the links do not reach each other";
    singular = "the position is too near a singular one";
    no_plans = "there is no construction of the plans";
    routes = "the construction is not exact enough";
    crossing = "lines cross at less than 20°";
    sheet = "a special point or a plan does not fit on the sheet";
    short =
        "a segment is too short: one to be measured shorter than 5 mm, or one to be laid off shorter than 4 mm";
    unsure = "a rate cannot be found to 15 % by hand";
    same = "its numbers came before";
    numbered(most) = "exercises are numbered from 1 to {most}";
    no_such = "there is no such exercise";
    whole_seed = "a seed is a whole number";
}
