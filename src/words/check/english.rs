use super::{CheckWords, Line, MistakeWords, coriolis, normal, symbol};

/// English.
pub(in crate::words) const ENGLISH: CheckWords = CheckWords {
    counts: |right, within, off| format!("{right} right, {within} within the tolerance of a pencil, {off} off"),
    right: "right",
    within: "within tolerance",
    off: "OFF",
    unjudged: "not judged: it has no construction",
    columns: ["quantity", "yours", "expected", "off by", "on paper", "off by", "allowed", "verdict"],
    tolerance: |mm, degrees| {
        format!(
            "Allowed is what a careful hand (±{mm} mm, ±{degrees}° in each act) comes to at that quantity: twice the band that 95 of 100 such drawings keep."
        )
    },
    probably: "What probably happened",
    nothing: "Nothing needs to be explained: the values are as near as a careful drawing comes.",
    no_single: "No single mistake explains this. Together these do:",
    none: "No mistake of the catalogue explains this.",
    step: |number| format!("Step {number}"),
    whole: "Whole drawing",
    instead: "It should be",
    follows: |values| format!("These follow from it and are consistent with it: {values}."),
    follows_none: "No other of your values follows from it.",
    sure: |percent| format!("How sure: {percent} %"),
    others: "It could also be",
    alike: "your values alone cannot tell this from the above",
    unexplained: |values| format!("Without an explanation: {values}."),
    mirrored: |plan| {
        format!(
            "The points of your {plan} are the mirror image of the right ones: all senses are turned round. If you measured y downwards on the sheet, measure it upwards."
        )
    },

    key: ["as it should be", "yours (names with *)", "where it went wrong"],
    follows_marked: |count, mark| {
        format!("{count} values marked {mark} in the table follow from it and are consistent with it.")
    },
    beyond: |point, mm| format!("{point}: {mm} mm farther"),
    turned: |plan, degrees| format!("The points of your {plan} are shown turned by {degrees}°, as they fit best."),

    turned_ray: MistakeWords {
        done: |b| {
            format!(
                "the ray from {} to {} was drawn turned by 90°: parallel in place of perpendicular, or the other way round",
                b[0], b[1]
            )
        },
        should: |_| {
            "a ray of a relative motion between two points of one link is normal to the line between them; only the ray of a sliding motion is parallel to its guide".into()
        },
    },
    turned_cut_line: MistakeWords {
        done: |b| format!("the line through {} for {} was drawn along the guide", b[0], b[1]),
        should: |b| format!("{} lies on the normal to the guide through {}", b[1], b[0]),
    },
    ray_from_wrong_point: MistakeWords {
        done: |b| format!("the ray to {} was drawn through {}", b[0], b[1]),
        should: |b| format!("it starts at {}, where the known part of the vector equation ends", b[2]),
    },
    wrong_lines: MistakeWords {
        done: |b| format!("{} was marked on {}", b[0], line(&b[1])),
        should: |b| format!("{} lies on {}", b[0], line(&b[2])),
    },
    reversed_vector: MistakeWords {
        done: |b| format!("the vector from {} to {} was laid off reversed", b[0], b[1]),
        should: |b| format!("it points from {} to {}, in the sense in which its link turns or slides", b[0], b[1]),
    },
    normal_outward: MistakeWords {
        done: |b| format!("the normal acceleration {} on the way {} was laid off outward", normal(b), way(b)),
        should: |_| "a normal acceleration points towards the point about which the link turns".into(),
    },
    omega_not_squared: MistakeWords {
        done: |b| {
            let omega = symbol(&b[2]);
            format!("for the normal part {}, {omega} was taken in place of its square", way(b))
        },
        should: |b| format!("the normal part is {}", normal(b)),
    },
    diameter: MistakeWords {
        done: |b| format!("the normal part {} {} came out twice as large, as with the diameter", normal(b), way(b)),
        should: |b| {
            let [omega, radius] = [&b[2], &b[3]].map(|name| symbol(name));
            format!("the normal part is {omega}² times the radius {radius}")
        },
    },
    normal_from_absolute: MistakeWords {
        done: |b| format!("the normal part along {} {} was computed from the absolute velocity", symbol(&b[3]), way(b)),
        should: |b| format!("it takes the relative velocity: {}", normal(b)),
    },
    normal_forgotten: MistakeWords {
        done: |b| format!("the normal part {} was forgotten on the way {}", normal(b), way(b)),
        should: |b| format!("lay off {} before the ray is drawn", normal(b)),
    },
    coriolis_forgotten: MistakeWords {
        done: |b| format!("the Coriolis acceleration was forgotten on the way {}", way(b)),
        should: |b| format!("lay off {} normal to the guide", coriolis(b)),
    },
    coriolis_without_two: MistakeWords {
        done: |b| format!("the Coriolis acceleration {} was taken without its 2", way(b)),
        should: |b| format!("it is {}", coriolis(b)),
    },
    coriolis_turned: MistakeWords {
        done: |b| format!("the Coriolis acceleration {} was laid off the wrong way", way(b)),
        should: |b| {
            let [omega, velocity] = [&b[2], &b[3]].map(|name| symbol(name));
            format!("it has the direction of {velocity} turned by 90° in the sense of {omega}")
        },
    },
    coriolis_where_none: MistakeWords {
        done: |b| {
            format!("a Coriolis acceleration was added to {} on the way {}, where nothing slides", normal(b), way(b))
        },
        should: |_| "there is a Coriolis acceleration only where something slides on a link that turns".into(),
    },
    mirrored_image: MistakeWords {
        done: |b| {
            format!("{} was laid off on the wrong side of {} {}: the image of the link is mirrored", b[1], b[0], b[2])
        },
        should: |_| "the image of a link is similar to the link, turned but never mirrored".into(),
    },
    wrong_segment: MistakeWords {
        done: |b| format!("for {} the segment from {} to {} was measured", b[0], b[1], b[2]),
        should: |b| format!("measure {}", b[0]),
    },
    component: MistakeWords {
        done: |b| {
            format!("for {} its {} component was measured", b[0], if b[1] == "x" { "horizontal" } else { "vertical" })
        },
        should: |b| format!("measure the true length from {} to {}", b[2], b[3]),
    },
    wrong_length: MistakeWords {
        done: |b| format!("for {} the length from {} to {} was taken", symbol(&b[0]), b[1], b[2]),
        should: |b| format!("take {}", symbol(&b[0])),
    },
    wrong_sense: MistakeWords {
        done: |b| format!("{} was taken with the wrong sense", symbol(&b[0])),
        should: |_| {
            "the sense follows from the direction of the segment in the plan and the side on which its line lies".into()
        },
    },
    revolutions_for_radians: MistakeWords {
        done: |b| format!("{} was not converted between revolutions per minute and radians per second", symbol(&b[0])),
        should: |_| "rad/s = rpm · π/30".into(),
    },
    degrees_for_radians: MistakeWords {
        done: |b| format!("{} was not converted between degrees and radians", symbol(&b[0])),
        should: |_| "a rate of rotation enters every product in radians".into(),
    },
    wrong_scale: MistakeWords {
        done: |b| {
            let what = if b[0].is_empty() { "all segments of the sheet" } else { &b[0] };
            if b[1].is_empty() {
                format!("{what}: millimetres of paper were taken for the value, without {}", b[2])
            } else {
                format!("{what}: {} was used in place of {}", b[1], b[2])
            }
        },
        should: |b| format!("millimetres on this sheet times {} are the value", b[2]),
    },
    other_mode: MistakeWords {
        done: |_| "the mechanism was drawn in another position in which its links fit together".into(),
        should: |_| "the scene asks for the position shown in the figure".into(),
    },
    swapped: MistakeWords {
        done: |b| format!("{} and {} stand in each other's place", b[0], b[1]),
        should: |_| "swap the two numbers".into(),
    },
    digits_transposed: MistakeWords {
        done: |b| format!("{}: two digits stand in each other's place, {} for {}", b[0], b[1], b[2]),
        should: |b| b[2].clone(),
    },
    decimal_slipped: MistakeWords {
        done: |b| format!("{}: the decimal point slipped, {} for {}", b[0], b[1], b[2]),
        should: |b| b[2].clone(),
    },
    truncated: MistakeWords {
        done: |_| "the numbers were cut off after their last digit".into(),
        should: |_| "round the last digit up where the next is 5 or more".into(),
    },
    wrong_unit: MistakeWords {
        done: |b| format!("{}: {} is the value in {}, not in {}", b[0], b[1], b[3], b[2]),
        should: |b| format!("{} {}", b[1], b[3]),
    },
    other_unit: MistakeWords {
        done: |b| format!("{}: {} is the value in {}, and no unit says so", b[0], b[1], b[2]),
        should: |b| format!("write {} beside it, or the value in {}", b[2], b[3]),
    },
    unknown: MistakeWords {
        done: |b| format!("{} is off for a reason that is not in the catalogue, and was used as it is", b[0]),
        should: |b| format!("look at {} again", b[0]),
    },
};

/// On which way in a plan.
fn way(blanks: &[String]) -> String {
    format!("from {} to {}", blanks[0], blanks[1])
}

/// A line of the scheme.
fn line(name: &str) -> String {
    match Line::of(name) {
        Line::Cut(special) => format!("the line that was drawn for {special}"),
        Line::Guide(slider) => format!("the guide of {slider}"),
        Line::Through(points) => format!("the line {points}"),
    }
}
