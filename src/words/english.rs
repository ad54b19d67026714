use super::language::{Language, NormalParts, PageWords};

/// English, the language that others fall back to.
pub(super) const ENGLISH: Language = Language {
    code: "en",

    guide_of: |slider| format!("guide of {slider}"),
    normal_to_guide: |slider, point| format!("the normal to the guide of {slider} through {point}"),
    line_at_infinity: "the line at infinity",

    choose_pole: |pole, scale| format!("Choose the pole {pole} and the scale {scale}."),
    choose_pole_with: |pole, scale, images| {
        format!("Choose the pole {pole} and the scale {scale}; points at rest have their images there: {images}.")
    },
    special_point: |point, link, first, second| {
        format!("{point}, special point of link {link}: where {first} meets {second}.")
    },
    special_point_at_infinity: |point, link, direction, first, second| {
        format!(
            "{point}, special point of link {link}, lies at infinity (direction {direction}°): {first} and {second} are parallel."
        )
    },
    measure_length: |from, to| format!("Measure the length from {from} to {to}."),
    lay_off_velocity: |point, arm, link| {
        format!("Lay off the velocity of {point}, normal to {arm}, in the sense of ω_{link}.")
    },
    lay_off_normal_acceleration: |point, pivot, link| {
        format!("Lay off the acceleration of {point}, from {point} towards {pivot}: link {link} turns uniformly.")
    },
    lay_off_whole_acceleration: |point, pivot, arm| {
        format!(
            "Lay off the acceleration of {point}: normal part from {point} towards {pivot}, tangential part normal to {arm}."
        )
    },
    lay_off_given: |vector| format!("Lay off the given vector {vector} from the pole."),
    lay_off_point_under: |body, point| format!("Lay off the known vector of the point of {body} under {point}."),
    ray_normal: |through, line, on_it| format!("Draw the ray through {through} normal to {line}; {on_it} lies on it."),
    ray_parallel: |through, line, on_it| {
        format!("Draw the ray through {through} parallel to the {line}; {on_it} lies on it.")
    },
    cross: |image| format!("Mark {image} where the two rays cross."),
    measure_segment: |from, to| format!("Measure the segment from {from} to {to}."),
    lay_off_normal: |parts, line, from, to| {
        let parts = match parts {
            NormalParts::One => "the normal part",
            NormalParts::Both => "the normal parts of both links",
            NormalParts::WithCoriolis => "the normal and the Coriolis part",
            NormalParts::Coriolis => "the Coriolis part",
        };
        format!("Lay off {parts} along {line} from {from} to {to}.")
    },
    solve: |unknowns| format!("Solve the equations of the measured segments for {unknowns}."),
    no_construction: "There is no construction by two rays for this group; the rates come from the loop equations alone.",
    no_construction_far: |points| {
        format!(
            "{points} at infinity: its rays are parallel, so the construction stops and the rates come from the loop equations alone."
        )
    },
    lay_off_relative: |link, point, from, arm| {
        format!("From ω_{link}: lay off the velocity of {point} relative to {from}, normal to {arm}.")
    },
    lay_off_sliding_velocity: |slider, backwards, from, to| {
        let reversed = reversed(backwards);
        format!("Lay off the sliding velocity of {slider}{reversed} along its guide, from {from} to {to}.")
    },
    lay_off_sliding_acceleration: |slider, backwards, from, to| {
        let reversed = reversed(backwards);
        format!("Lay off the sliding acceleration of {slider}{reversed} along its guide, from {from} to {to}.")
    },
    lay_off_coriolis: |slider, backwards, from, to| {
        let reversed = reversed(backwards);
        format!("Lay off the Coriolis acceleration of {slider}{reversed}, normal to its guide, from {from} to {to}.")
    },

    given: " given",
    made_from: " from ",
    and: " and ",
    coriolis_word: "Coriolis ",
    normal: "normal",
    tangential: "tangential",
    sliding: "sliding",
    coriolis: "Coriolis",

    title: "Velocity and acceleration plans",
    scheme: "Scheme",
    velocity_plan: "Velocity plan",
    acceleration_plan: "Acceleration plan",
    far_away: |point, distance, from| format!("{point}: {distance} from {from}"),
    at_infinity: |point| format!("{point} at infinity"),
    agreement: |difference, allowed| {
        format!(
            "Construction and loop equations agree: rates differ by {difference} of the largest (crossings allow {allowed}). Printed at 100 %, mm × μ is the value."
        )
    },
    one_route_far: "A special point lies at infinity: rates are from the loop equations alone. Printed at 100 %, mm × μ is the value.",
    one_route: "A group has no construction by two rays: rates are from the loop equations alone. Printed at 100 %, mm × μ is the value.",
    with_direction: |size, degrees| format!("{size}, direction {degrees}°"),
    segment: "segment",
    value: "value",
    ruler: "Print test: this is 50 mm",
    description: |panels, groups| format!("Panels: {panels}. Assur groups: {groups}."),
    described_scheme: "the mechanism to scale",
    described_velocity_plan: "its velocity plan",
    described_acceleration_plan: "its acceleration plan",
    described_group: |class, links| format!("class {class}, links {links}"),
    higher: "higher",

    curves: "Curves",
    hodograph: |vector| format!("Hodograph of {vector}"),
    angle: "Angle",
    angular_velocity: "Angular velocity",
    angular_acceleration: "Angular acceleration",
    position: "Position",
    length: "Length",
    velocity: "Velocity",
    acceleration: "Acceleration",
    in_unit: |kind, unit| format!("{kind} in {unit}"),
    drive_angle: ["Angle", "of the drive in °"],
    drive_position: |drive, unit| format!("Position of drive {drive} in {unit}"),
    limit: "limit",
    change: "change",
    scene: "scene",
    dead_position: "dead position",
    extremes: "greatest, least value",
    over: |drive, from, to| format!("Over {drive} from {from} to {to}:"),
    is_constant: |quantity, value| format!("{quantity} is {value}"),
    least: |value, at| format!("least {value} at {at}"),
    greatest: |value, at| format!("greatest {value} at {at}"),
    no_least: "least without bound",
    no_greatest: "greatest without bound",

    scales: |scales| format!("Scales: {scales}"),
    scale_per_mm: |scale, value, unit| format!("{scale} = {value} {unit} per mm"),
    bands: |mm, degrees| format!("± is what honest hand drawings (±{mm} mm, ±{degrees}°) keep to, at least 95 of 100."),
    no_band_no_construction: "A value has no ± where it depends on a group without a construction (a special point at infinity, or a higher class).",
    no_band_no_sheet: |panel| format!("A value has no ± where the figure has no {panel}, so no scale."),
    on_the_mechanism: "On the mechanism",
    routes_differ: |difference, allowed| {
        format!(
            "The rates from this construction and from the loop equations differ by {difference} of the largest; its crossings allow {allowed}."
        )
    },
    on_paper: |mm| format!("{mm} mm on paper"),
    only_roughly: ", only roughly",
    direction: |degrees| format!("direction {degrees}°"),
    angle_of_crossing: |degrees| format!("angle of crossing {degrees}°"),

    page: PageWords {
        figure: "Figure",
        panels: "Panels",
        all: "All",
        steps: "Steps of the construction",
        first: "First step (Home)",
        back: "Step back (←)",
        forward: "Step forward (→)",
        finished: "Finished figure (End)",
        count: "steps",
        motion: "Motion",
        play: "Play (space)",
        pause: "Pause (space)",
        own: "The scene's own position (0)",
        speed: "Speed",
        look: "Look",
        dark: "Dark or light (d)",
        print: "Print",
        to_scale: "Print true to scale (p)",
        no_script: "This page needs JavaScript to go step by step and to move. It loads nothing from anywhere.",
        too_old: "This browser is too old to unpack the steps and the motion; the finished figure is shown.",
    },

    check: &super::check::ENGLISH,
    class: &super::class::ENGLISH,
    exercise: &super::exercise::ENGLISH,
};

fn reversed(backwards: bool) -> &'static str {
    if backwards { " reversed" } else { "" }
}
