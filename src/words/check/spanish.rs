use super::{CheckWords, Line, MistakeWords, coriolis, normal, symbol};

/// Spanish, with the terms of the source paper's school.
pub(in crate::words) const SPANISH: CheckWords = CheckWords {
    counts: |right, within, off| {
        format!("Correctos: {right}; dentro de la tolerancia del lápiz: {within}; fuera: {off}")
    },
    right: "correcto",
    within: "tolerable",
    off: "FUERA",
    unjudged: "sin juicio: no tiene construcción",
    columns: ["magnitud", "medido", "esperado", "diferencia", "en papel", "en %", "admitido", "juicio"],
    tolerance: |mm, degrees| {
        format!(
            "Se admite lo que alcanza en esa magnitud una mano cuidadosa (±{mm} mm, ±{degrees}° en cada trazo): el doble de la banda que cumplen 95 de 100 de tales dibujos."
        )
    },
    probably: "Qué ocurrió probablemente",
    nothing: "No hay nada que explicar: los valores son tan próximos como los de un dibujo cuidadoso.",
    no_single: "Ningún error explica esto por sí solo. Juntos lo explican estos:",
    none: "Ningún error del catálogo explica esto.",
    step: |number| format!("Paso {number}"),
    whole: "Todo el dibujo",
    instead: "Lo correcto",
    follows: |values| format!("De ello se siguen, y son coherentes con ello: {values}."),
    follows_none: "De ello no se sigue ningún otro de los valores.",
    sure: |percent| format!("Certeza: {percent} %"),
    others: "También podría ser",
    alike: "los valores por sí solos no lo distinguen de lo anterior",
    unexplained: |values| format!("Sin explicación: {values}."),
    mirrored: |plan| {
        format!(
            "Los puntos del {plan} son la imagen especular de los correctos: todos los sentidos quedan invertidos. Si midió y hacia abajo en la hoja, mídala hacia arriba."
        )
    },

    key: ["como debe ser", "lo dibujado (con *)", "donde está el error"],
    follows_marked: |count, mark| {
        format!("De ello se siguen, y son coherentes con ello, {count} valores con la marca {mark} en la tabla.")
    },
    beyond: |point, mm| format!("{point}: {mm} mm más allá"),
    turned: |plan, degrees| format!("Los puntos del {plan} se muestran girados {degrees}°, como mejor encajan."),

    turned_ray: MistakeWords {
        done: |b| format!("la recta {} se trazó girada 90°: paralela en lugar de perpendicular, o al revés", way(b)),
        should: |_| {
            "la recta de un movimiento relativo entre dos puntos de un mismo eslabón es normal a la línea que los une; solo la de un deslizamiento es paralela a su guía".into()
        },
    },
    turned_cut_line: MistakeWords {
        done: |b| format!("la recta por {} para hallar {} se trazó a lo largo de la guía", b[0], b[1]),
        should: |b| format!("{} está sobre la normal a la guía por {}", b[1], b[0]),
    },
    ray_from_wrong_point: MistakeWords {
        done: |b| format!("la recta hacia {} se trazó por {}", b[0], b[1]),
        should: |b| format!("parte de {}, donde termina lo conocido de la ecuación vectorial", b[2]),
    },
    wrong_lines: MistakeWords {
        done: |b| format!("{} se marcó sobre {}", b[0], line(&b[1])),
        should: |b| format!("{} está sobre {}", b[0], line(&b[2])),
    },
    reversed_vector: MistakeWords {
        done: |b| format!("el vector {} se trazó con el sentido contrario", way(b)),
        should: |b| format!("va {}, en el sentido en que gira o desliza su eslabón", way(b)),
    },
    normal_outward: MistakeWords {
        done: |b| format!("la aceleración normal {}, {}, se trazó hacia fuera", normal(b), way(b)),
        should: |_| "la aceleración normal apunta hacia el punto alrededor del cual gira el eslabón".into(),
    },
    omega_not_squared: MistakeWords {
        done: |b| {
            let omega = symbol(&b[2]);
            format!("para la aceleración normal {} se tomó {omega} en lugar de su cuadrado", way(b))
        },
        should: |b| format!("la aceleración normal es {}", normal(b)),
    },
    diameter: MistakeWords {
        done: |b| format!("la aceleración normal {}, {}, resultó el doble, como con el diámetro", normal(b), way(b)),
        should: |b| {
            let [omega, radius] = [&b[2], &b[3]].map(|name| symbol(name));
            format!("la aceleración normal es {omega}² por el radio {radius}")
        },
    },
    normal_from_absolute: MistakeWords {
        done: |b| {
            format!("la aceleración normal según {}, {}, se calculó con la velocidad absoluta", symbol(&b[3]), way(b))
        },
        should: |b| format!("se calcula con la velocidad relativa: {}", normal(b)),
    },
    normal_forgotten: MistakeWords {
        done: |b| format!("se olvidó la aceleración normal {}, {}", normal(b), way(b)),
        should: |b| format!("trazar {} antes que la recta", normal(b)),
    },
    coriolis_forgotten: MistakeWords {
        done: |b| format!("se olvidó la aceleración de Coriolis, {}", way(b)),
        should: |b| format!("trazar {} normal a la guía", coriolis(b)),
    },
    coriolis_without_two: MistakeWords {
        done: |b| format!("la aceleración de Coriolis, {}, se tomó sin su factor 2", way(b)),
        should: |b| format!("es {}", coriolis(b)),
    },
    coriolis_turned: MistakeWords {
        done: |b| format!("la aceleración de Coriolis, {}, se trazó con el sentido contrario", way(b)),
        should: |b| {
            let [omega, velocity] = [&b[2], &b[3]].map(|name| symbol(name));
            format!("tiene la dirección de {velocity} girada 90° en el sentido de {omega}")
        },
    },
    coriolis_where_none: MistakeWords {
        done: |b| format!("se sumó una aceleración de Coriolis a {}, {}, donde nada desliza", normal(b), way(b)),
        should: |_| "solo hay aceleración de Coriolis donde algo desliza sobre un eslabón que gira".into(),
    },
    mirrored_image: MistakeWords {
        done: |b| format!("{} se trazó al otro lado de {} {}: la imagen del eslabón queda reflejada", b[1], b[0], b[2]),
        should: |_| "la imagen de un eslabón es semejante a él, girada pero nunca reflejada".into(),
    },
    wrong_segment: MistakeWords {
        done: |b| format!("para {} se midió el segmento de {} a {}", b[0], b[1], b[2]),
        should: |b| format!("medir {}", b[0]),
    },
    component: MistakeWords {
        done: |b| {
            let axis = if b[1] == "x" { "horizontal" } else { "vertical" };
            format!("de {} se midió solo la componente {axis}", b[0])
        },
        should: |b| format!("medir la longitud verdadera de {} a {}", b[2], b[3]),
    },
    wrong_length: MistakeWords {
        done: |b| format!("para {} se tomó la longitud de {} a {}", symbol(&b[0]), b[1], b[2]),
        should: |b| format!("tomar {}", symbol(&b[0])),
    },
    wrong_sense: MistakeWords {
        done: |b| format!("{} se tomó con el sentido contrario", symbol(&b[0])),
        should: |_| {
            "el sentido se deduce de la dirección del segmento en el plano y del lado en que queda su línea en el mecanismo".into()
        },
    },
    revolutions_for_radians: MistakeWords {
        done: |b| format!("{} no se convirtió entre revoluciones por minuto y radianes por segundo", symbol(&b[0])),
        should: |_| "rad/s = rpm · π/30".into(),
    },
    degrees_for_radians: MistakeWords {
        done: |b| format!("{} no se convirtió entre grados y radianes", symbol(&b[0])),
        should: |_| "las velocidades y aceleraciones angulares entran en todo producto en radianes".into(),
    },
    wrong_scale: MistakeWords {
        done: |b| {
            let what = if b[0].is_empty() { "todos los segmentos de la hoja" } else { &b[0] };
            if b[1].is_empty() {
                format!("{what}: se tomaron los milímetros de papel como valor, sin {}", b[2])
            } else {
                format!("{what}: se usó {} en lugar de {}", b[1], b[2])
            }
        },
        should: |b| format!("los milímetros de esta hoja por {} dan el valor", b[2]),
    },
    other_mode: MistakeWords {
        done: |_| "el mecanismo se dibujó en otra posición en que encajan sus eslabones".into(),
        should: |_| "se pide la posición que muestra la figura".into(),
    },
    swapped: MistakeWords {
        done: |b| format!("{} y {} están intercambiados", b[0], b[1]),
        should: |_| "intercambiar los dos números".into(),
    },
    digits_transposed: MistakeWords {
        done: |b| format!("{}: dos cifras están intercambiadas, {} en lugar de {}", b[0], b[1], b[2]),
        should: |b| b[2].clone(),
    },
    decimal_slipped: MistakeWords {
        done: |b| format!("{}: la coma decimal está corrida, {} en lugar de {}", b[0], b[1], b[2]),
        should: |b| b[2].clone(),
    },
    truncated: MistakeWords {
        done: |_| "los números se cortaron tras la última cifra escrita".into(),
        should: |_| "redondear hacia arriba la última cifra si la siguiente es 5 o más".into(),
    },
    wrong_unit: MistakeWords {
        done: |b| format!("{}: {} es el valor en {}, no en {}", b[0], b[1], b[3], b[2]),
        should: |b| format!("{} {}", b[1], b[3]),
    },
    other_unit: MistakeWords {
        done: |b| format!("{}: {} es el valor en {}, y ninguna unidad lo dice", b[0], b[1], b[2]),
        should: |b| format!("escribir {} al lado, o el valor en {}", b[2], b[3]),
    },
    unknown: MistakeWords {
        done: |b| format!("{} difiere por un motivo que no está en el catálogo, y se siguió con ese valor", b[0]),
        should: |b| format!("revisar {}", b[0]),
    },
};

/// On which way in a plan.
fn way(blanks: &[String]) -> String {
    format!("de {} a {}", blanks[0], blanks[1])
}

/// A line of the scheme.
fn line(name: &str) -> String {
    match Line::of(name) {
        Line::Cut(special) => format!("la recta que se trazó para hallar {special}"),
        Line::Guide(slider) => format!("la guía de {slider}"),
        Line::Through(points) => format!("la recta {points}"),
    }
}
