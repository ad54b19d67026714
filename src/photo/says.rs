//! What is said of a photograph that is of no use, or of less.

use crate::message::messages;

messages! { "photo":
    no_sheet = "no sheet with markers is found in the picture";
    one_marker = "only one of the sheet's eight markers is found in the picture";
    few_markers(count) = "only {count} of the sheet's eight markers are found together in the picture";
    whole_sheet = "take the picture from above, with the whole sheet and all eight black squares in it, sharp and without a hand over them; sheets printed without markers cannot be read";
    cut_off = "the picture ends before the sheet does: some of its eight black squares are outside";
    step_back = "take the picture from farther away, with all eight black squares in it";
    mirrored = "the picture is mirrored";
    unmirror = "take it with the camera at the back of the telephone, or switch mirroring off";
    not_even(mm) = "the sheet is not flat: its markers are {mm} mm from where they would be on an even sheet";
    bent(mm) = "the sheet is bent: its middle is {mm} mm above or below its edges";
    flatten = "press the sheet flat, under a sheet of glass or with weights on its edges, and take the picture again";
    blurred(mm) = "the picture is blurred: edges on the sheet are {mm} mm wide in it";
    nearer = "take the picture nearer, so that the sheet fills it, in more light, and hold the camera still";
    no_code = "the small code at the lower right corner of the sheet cannot be read";
    light_on_code = "take the picture nearer and sharper, with light on the code; nothing may be drawn over it; pictures sent by chat are often too small";
    other_page = "the small code is of a page that is not that of the markers: the picture shows parts of two sheets, or a sheet that was cut";
    one_whole_sheet = "photograph one whole sheet as it was printed";
    cut_short = "is cut short: the file ends in the middle of the picture";
    send_again = "copy or send the photograph once more";

    second_sheet = "the picture shows parts of another sheet, too, which is not read";
    each_by_itself = "photograph each sheet by itself";
    nothing_drawn = "no pencil lines of the plans are found in the picture";
    nothing_in_blur(mm) = "no pencil lines of the plans are found: the picture is blurred, edges on the sheet are {mm} mm wide in it";
    mark_by_hand = "take a sharper picture, or mark the points in the workbench";
    scaled(percent) = "all points that are found are {percent} % too far from the poles";
    scaled_down(percent) = "all points that are found are {percent} % too near to the poles";
    measure_ruler = "lay a ruler on the one that is printed on the sheet: is its 50 mm not 50 mm long, the sheet was printed to fit the page";
}
