use super::language::{Language, NormalParts, PageWords};

/// Spanish, with the terms of the source paper's school: polo, plano de velocidades, eslabón, punto especial, grupo de Assur.
pub(super) const SPANISH: Language = Language {
    code: "es",

    guide_of: |slider| format!("la guía de {slider}"),
    normal_to_guide: |slider, point| format!("la normal a la guía de {slider} por {point}"),
    line_at_infinity: "la recta del infinito",

    choose_pole: |pole, scale| format!("Elegir el polo {pole} y la escala {scale}."),
    choose_pole_with: |pole, scale, images| {
        format!("Elegir el polo {pole} y la escala {scale}; los puntos en reposo tienen allí sus imágenes: {images}.")
    },
    special_point: |point, link, first, second| {
        format!("{point}, punto especial del eslabón {link}: donde se cortan {first} y {second}.")
    },
    special_point_at_infinity: |point, link, direction, first, second| {
        format!(
            "{point}, punto especial del eslabón {link}, está en el infinito (dirección {direction}°): {first} y {second} son paralelas."
        )
    },
    measure_length: |from, to| format!("Medir la longitud de {from} a {to}."),
    lay_off_velocity: |point, arm, link| {
        format!("Trazar la velocidad de {point}, normal a {arm}, en el sentido de ω_{link}.")
    },
    lay_off_normal_acceleration: |point, pivot, link| {
        format!("Trazar la aceleración de {point}, de {point} hacia {pivot}: el eslabón {link} gira uniformemente.")
    },
    lay_off_whole_acceleration: |point, pivot, arm| {
        format!(
            "Trazar la aceleración de {point}: componente normal de {point} hacia {pivot}, componente tangencial normal a {arm}."
        )
    },
    lay_off_given: |vector| format!("Trazar desde el polo el vector dado {vector}."),
    lay_off_point_under: |body, point| format!("Trazar el vector conocido del punto de {body} situado bajo {point}."),
    ray_normal: |through, line, on_it| {
        format!("Trazar por {through} la recta normal a {line}; {on_it} está sobre ella.")
    },
    ray_parallel: |through, line, on_it| {
        format!("Trazar por {through} la recta paralela a {line}; {on_it} está sobre ella.")
    },
    cross: |image| format!("Marcar {image} donde se cortan las dos rectas."),
    measure_segment: |from, to| format!("Medir el segmento de {from} a {to}."),
    lay_off_normal: |parts, line, from, to| {
        let parts = match parts {
            NormalParts::One => "la componente normal",
            NormalParts::Both => "las componentes normales de ambos eslabones",
            NormalParts::WithCoriolis => "la componente normal y la de Coriolis",
            NormalParts::Coriolis => "la componente de Coriolis",
        };
        format!("Trazar {parts} a lo largo de {line}, de {from} a {to}.")
    },
    solve: |unknowns| format!("Resolver las ecuaciones de los segmentos medidos para {unknowns}."),
    no_construction: "Para este grupo no hay construcción con dos rectas; sus velocidades y aceleraciones se obtienen solo de las ecuaciones de lazo.",
    no_construction_far: |points| {
        format!(
            "{points} en el infinito: sus rectas son paralelas, la construcción se detiene y las velocidades y aceleraciones se obtienen solo de las ecuaciones de lazo."
        )
    },
    lay_off_relative: |link, point, from, arm| {
        format!("Con ω_{link}: trazar la velocidad de {point} relativa a {from}, normal a {arm}.")
    },
    lay_off_sliding_velocity: |slider, backwards, from, to| {
        let reversed = reversed(backwards);
        format!("Trazar la velocidad de deslizamiento de {slider}{reversed} a lo largo de su guía, de {from} a {to}.")
    },
    lay_off_sliding_acceleration: |slider, backwards, from, to| {
        let reversed = reversed(backwards);
        format!("Trazar la aceleración de deslizamiento de {slider}{reversed} a lo largo de su guía, de {from} a {to}.")
    },
    lay_off_coriolis: |slider, backwards, from, to| {
        let reversed = reversed(backwards);
        format!("Trazar la aceleración de Coriolis de {slider}{reversed}, normal a su guía, de {from} a {to}.")
    },

    given: " (dado)",
    made_from: " con ",
    and: " y ",
    coriolis_word: "Coriolis ",
    normal: "normal",
    tangential: "tangencial",
    sliding: "deslizamiento",
    coriolis: "Coriolis",

    title: "Planos de velocidades y aceleraciones",
    scheme: "Esquema",
    velocity_plan: "Plano de velocidades",
    acceleration_plan: "Plano de aceleraciones",
    far_away: |point, distance, from| format!("{point}: a {distance} de {from}"),
    at_infinity: |point| format!("{point} en el infinito"),
    agreement: |difference, allowed| {
        format!(
            "Construcción y ecuaciones de lazo concuerdan: difieren en {difference} del mayor valor (los cortes admiten {allowed}). Al 100 %, mm × μ es el valor."
        )
    },
    one_route_far: "Un punto especial está en el infinito: los valores son solo de las ecuaciones de lazo. Impreso al 100 %, mm × μ es el valor.",
    one_route: "Un grupo no tiene construcción con dos rectas: los valores son solo de las ecuaciones de lazo. Impreso al 100 %, mm × μ es el valor.",
    with_direction: |size, degrees| format!("{size}, dirección {degrees}°"),
    segment: "segmento",
    value: "valor",
    ruler: "Prueba: esto mide 50 mm",
    description: |panels, groups| format!("Contiene: {panels}. Grupos de Assur: {groups}."),
    described_scheme: "el mecanismo a escala",
    described_velocity_plan: "su plano de velocidades",
    described_acceleration_plan: "su plano de aceleraciones",
    described_group: |class, links| format!("clase {class}, eslabones {links}"),
    higher: "superior",

    curves: "Curvas",
    hodograph: |vector| format!("Hodógrafa de {vector}"),
    angle: "Ángulo",
    angular_velocity: "Velocidad angular",
    angular_acceleration: "Aceleración angular",
    position: "Posición",
    length: "Longitud",
    velocity: "Velocidad",
    acceleration: "Aceleración",
    in_unit: |kind, unit| format!("{kind} en {unit}"),
    drive_angle: ["Ángulo", "del accionamiento en °"],
    drive_position: |drive, unit| format!("Posición del accionamiento {drive} en {unit}"),
    limit: "límite",
    change: "cambio",
    scene: "dada",
    dead_position: "posición muerta",
    extremes: "valor máximo, mínimo",
    over: |drive, from, to| format!("Según {drive} de {from} a {to}:"),
    is_constant: |quantity, value| format!("{quantity} es {value}"),
    least: |value, at| format!("mínimo {value} en {at}"),
    greatest: |value, at| format!("máximo {value} en {at}"),
    no_least: "mínimo sin cota",
    no_greatest: "máximo sin cota",

    scales: |scales| format!("Escalas: {scales}"),
    scale_per_mm: |scale, value, unit| format!("{scale} = {value} {unit} por mm"),
    bands: |mm, degrees| {
        format!("± es lo que cumplen los dibujos a mano cuidadosos (±{mm} mm, ±{degrees}°), al menos 95 de 100.")
    },
    no_band_no_construction: "Un valor no tiene ± cuando depende de un grupo sin construcción (un punto especial en el infinito, o una clase superior).",
    no_band_no_sheet: |panel| {
        format!("Un valor no tiene ± cuando la figura carece de {panel} y, por tanto, de escala.")
    },
    on_the_mechanism: "En el mecanismo",
    routes_differ: |difference, allowed| {
        format!(
            "Los valores de esta construcción y los de las ecuaciones de lazo difieren en {difference} del mayor; sus cortes admiten {allowed}."
        )
    },
    on_paper: |mm| format!("{mm} mm en el papel"),
    only_roughly: ", solo aproximadamente",
    direction: |degrees| format!("dirección {degrees}°"),
    angle_of_crossing: |degrees| format!("ángulo de corte {degrees}°"),

    page: PageWords {
        figure: "Figura",
        panels: "Paneles",
        all: "Todo",
        steps: "Pasos de la construcción",
        first: "Primer paso (Inicio)",
        back: "Paso atrás (←)",
        forward: "Paso adelante (→)",
        finished: "Figura terminada (Fin)",
        count: "pasos",
        motion: "Movimiento",
        play: "Reproducir (espacio)",
        pause: "Pausa (espacio)",
        own: "La posición propia de la escena (0)",
        speed: "Velocidad",
        look: "Aspecto",
        dark: "Oscuro o claro (d)",
        print: "Imprimir",
        to_scale: "Imprimir a escala (p)",
        no_script: "Esta página necesita JavaScript para avanzar paso a paso y moverse. No carga nada de ninguna parte.",
        too_old: "Este navegador es demasiado antiguo para desempaquetar los pasos y el movimiento; se muestra la figura terminada.",
    },

    check: &super::check::SPANISH,
    class: &super::class::SPANISH,
    exercise: &super::exercise::SPANISH,
};

fn reversed(backwards: bool) -> &'static str {
    if backwards { " invertida" } else { "" }
}
