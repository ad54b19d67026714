### Kinegon in Spanish, with the terms of the source paper's school: polo, plano de velocidades, eslabón, punto especial, grupo de Assur.
### `en.ftl` says how such a file is written.


## Figures, steps and reports


# Names of links and lines.

ground = bastidor
guide_of = la guía de {$slider}
normal_to_guide = la normal a la guía de {$slider} por {$point}
line_at_infinity = la recta del infinito

# Steps that are shown together.

join_special_points = {$points}, puntos especiales: donde se cortan sus rectas.
join_lay_off = Trazar {$vectors}.
join_normal = por {$through} ⊥ {$line}
join_parallel = por {$through} ∥ {$line}
join_at_angle = por {$through} con {$angle}
join_cross = Las rectas {$first} y {$second} se cortan en {$point}.
join_measure = Medir {$lengths}.
join_rates = Medir {$segments}; resolver para {$unknowns}.
join_images = Imágenes de otros puntos: {$points}.

# Steps of the construction.

choose_pole = Elegir el polo {$pole} y la escala {$scale}.
choose_pole_with = Elegir el polo {$pole} y la escala {$scale}; los puntos en reposo tienen allí sus imágenes: {$images}.
special_point = {$point}, punto especial del eslabón {$link}: donde se cortan {$first} y {$second}.
special_point_at_infinity = {$point}, punto especial del eslabón {$link}, está en el infinito (dirección {$direction}°): {$first} y {$second} son paralelas.
measure_length = Medir la longitud desde {$from} hasta {$to}.
lay_off_velocity = Trazar la velocidad de {$point}, normal a {$arm}, en el sentido de ω_{$link}.
lay_off_velocity_turned = Trazar la velocidad de {$point}, girada, a lo largo de {$arm}: en la dirección de {$from} a {$to}.
lay_off_normal_acceleration = Trazar la aceleración de {$point}, de {$point} hacia {$pivot}: el eslabón {$link} gira uniformemente.
lay_off_whole_acceleration = Trazar la aceleración de {$point}: componente normal de {$point} hacia {$pivot}, componente tangencial normal a {$arm}.
lay_off_given = Trazar desde el polo el vector dado {$vector}.
lay_off_given_turned = Trazar desde el polo el vector dado {$vector}, girado.
lay_off_point_under = Trazar el vector conocido del punto de {$body} situado bajo {$point}.
ray_normal = Trazar por {$through} la recta normal a {$line}; {$image} está sobre ella.
ray_normal_to_guide = Trazar por {$through} la recta normal a {$line}; {$image} está sobre ella.
ray_parallel = Trazar por {$through} la recta paralela a {$line}; {$image} está sobre ella.
ray_parallel_to_line = Trazar por {$through} la recta paralela a {$line}; {$image} está sobre ella.
ray_at_angle = Trazar por {$through} la recta con el ángulo {$angle} del eslabón, en el mismo sentido; {$image} está sobre ella.
divide = Dividir la recta desde {$from} hasta {$to} en la razón {$part} : {$whole}: ahí está {$image}.
coincide = El eslabón {$link} no gira: {$image} está en {$with}.
cross = Marcar {$image} donde se cortan las dos rectas.
measure_segment = Medir el segmento desde {$from} hasta {$to}.
lay_off_normal_part = Trazar la componente normal a lo largo de {$line} hacia {$centre}, desde {$from} hasta {$to}.
lay_off_normal_parts = Trazar las componentes normales de ambos eslabones a lo largo de {$line}, desde {$from} hasta {$to}.
solve = Resolver las ecuaciones de los segmentos medidos para {$unknowns}.
solve_wheel = Resolver la ecuación del segmento medido para {$unknowns}.
solve_wheel_with_mesh = Resolver la ecuación del segmento medido para {$unknowns}; la ecuación de los dientes debe dar lo mismo.
solve_meshes = Resolver las ecuaciones de los dientes para {$unknowns}.
solve_meshes_accelerated = Resolver las ecuaciones de los dientes para {$unknowns}: donde las ruedas se tocan son iguales las partes tangenciales de sus aceleraciones, no las aceleraciones enteras.
solve_rims = Las ruedas tienen una misma velocidad con lo que tocan y con su correa; esas ecuaciones dan {$unknowns}.
pitch_at_rest = Ahí toca una rueda fija: {$image} está en {$with}.
lay_off_pitch = Con ω_{$link}: trazar la velocidad de {$point} relativa a {$from}, normal a {$arm}; ahí ambas ruedas tienen la misma.
lay_off_pitch_turned = Con ω_{$link}: trazar la velocidad de {$point} relativa a {$from}, girada, a lo largo de {$arm}; ahí ambas ruedas tienen la misma.
no_construction = Para este grupo no hay construcción con dos rectas: sus velocidades y aceleraciones angulares se obtienen de las ecuaciones de lazo, y sus imágenes se trazan con ellas, eslabón por eslabón.
no_construction_far = {$points} en el infinito: sus rectas son paralelas; las velocidades y aceleraciones angulares se obtienen de las ecuaciones de lazo, y las imágenes se trazan con ellas, eslabón por eslabón.
lay_off_relative = Con ω_{$link}: trazar la velocidad de {$point} relativa a {$from}, normal a {$arm}.
lay_off_relative_turned = Con ω_{$link}: trazar la velocidad de {$point} relativa a {$from}, girada, a lo largo de {$arm}.
lay_off_relative_normal = Trazar la aceleración normal de {$point} relativa a {$from}, a lo largo de {$arm} hacia {$from}.
lay_off_relative_tangential = Con α_{$link}: trazar la aceleración tangencial de {$point} relativa a {$from}, normal a {$arm}.
lay_off_sliding_velocity = Trazar la velocidad de deslizamiento de {$slider} a lo largo de su guía, desde {$from} hasta {$to}.
lay_off_sliding_velocity_turned = Trazar la velocidad de deslizamiento de {$slider}, girada, normal a su guía, desde {$from} hasta {$to}.
lay_off_sliding_velocity_backwards = Trazar la velocidad de deslizamiento de {$slider} a lo largo de su guía de modo que termine en {$to}: empieza en {$from}.
lay_off_sliding_velocity_turned_backwards = Trazar la velocidad de deslizamiento de {$slider}, girada, normal a su guía de modo que termine en {$to}: empieza en {$from}.
lay_off_sliding_acceleration = Trazar la aceleración de deslizamiento de {$slider} a lo largo de su guía, desde {$from} hasta {$to}.
lay_off_sliding_acceleration_backwards = Trazar la aceleración de deslizamiento de {$slider} a lo largo de su guía de modo que termine en {$to}: empieza en {$from}.
lay_off_coriolis = Trazar la aceleración de Coriolis de {$slider}, su velocidad de deslizamiento girada 90° en el sentido de ω_{$link}, desde {$from} hasta {$to}.
lay_off_coriolis_backwards = Trazar la aceleración de Coriolis de {$slider}, su velocidad de deslizamiento girada 90° en el sentido de ω_{$link}, de modo que termine en {$to}: empieza en {$from}.

# Words of equations.

given = {" "}(dado)
made_from = {" "}con{" "}
and = {" "}y{" "}
normal = normal
tangential = tangencial
sliding = deslizamiento
coriolis = Coriolis

# The text of the steps.

scales = Escalas: {$scales}
scales_by_hand = Escalas de la hoja de trabajo y de las longitudes en el papel que siguen: {$scales}
scales_of_figure = Escalas de la figura: {$scales}
scale_per_mm = {$scale} = {$value} {$unit} por mm
bands = ± es lo que cumplen los dibujos a mano cuidadosos (±{$mm} mm, ±{$degrees}°), al menos 95 de 100.
no_band_no_construction = Un valor no tiene ± cuando depende de un grupo sin construcción (un punto especial en el infinito, o una clase superior).
no_band_no_sheet = Un valor no tiene ± cuando la figura carece de {$panel} y, por tanto, de escala.
on_the_mechanism = En el mecanismo
routes_differ = Los valores de esta construcción y los de las ecuaciones de lazo difieren en {$difference} del mayor; sus cortes admiten {$allowed}.
on_paper = {$mm} mm en el papel
only_roughly = , solo aproximadamente
direction = dirección {$degrees}°
angle_of_crossing = ángulo de corte {$degrees}°

# Instant centres.

permanent_centers = Marcar los centros permanentes: {$centers}.
center_in = {$center} en {$point}
center_of_mesh = {$center} en el punto primitivo
center_normal_to = {$center} en el infinito, normal a la guía de {$guide}
center_line = Unir {$first} y {$second}; {$center} está sobre esta recta.
center_line_towards = Trazar por {$first} la recta hacia {$second}, en el infinito; {$center} está sobre ella.
center_cross = Marcar {$center} en {$first} y {$second}.
center_parallel = {$center} está en el infinito: {$first} y {$second} son paralelas.
center_along = {$center} está en el infinito según {$line}: la otra recta es la del infinito.
leave_out = Quitar el eslabón {$link} y unir rígidamente {$first} y {$second}: el centro está entonces en {$center}.
centers_by_rates = Ninguna recta lleva a {$centers}: de las velocidades calculadas.
rate_by_centers = Calcular {$rate}: en {$center} los eslabones {$driver} y {$link} tienen la misma velocidad.
velocity_by_centers = Trazar {$vector}, normal al radio {$from} {$point}.
rate_by_slide = Calcular {$rate}: en {$center} el eslabón {$link} tiene la velocidad {$velocity}, a lo largo de la guía.
velocity_along_guide = Trazar {$vector} a lo largo de la guía de {$guide}: todos los puntos del eslabón tienen esa velocidad.
collineation_axis = Unir {$first} y {$second}, y los centros de curvatura de sus trayectorias, {$first_center} y {$second_center}: las rectas se cortan en {$crossing}. El eje de colineación va de {$pole} hasta allí.
pole_tangent = Trazar la tangente polar t del eslabón {$link} por {$pole}: desde el rayo a {$first}, con el ángulo que va del eje al rayo a {$second} (Bobillier).
axis_of_point = Trazar el rayo de {$pole} a {$point} y, desde él, con el ángulo que va de la tangente al rayo a {$pin}, el eje de ambos: corta la recta de {$point} y {$pin} en {$crossing}.
center_of_curvature = La recta desde allí a {$fixed} marca en el rayo {$center}, el centro de curvatura de la trayectoria de {$point}.
path_inflection = La recta desde allí a {$fixed} es paralela al rayo: la trayectoria de {$point} tiene una inflexión.
inflection_point = Medir las distancias de {$pin} a {$pole} y a {$fixed}. Sobre el rayo, desde {$pin} hacia {$fixed}, J pasa por una inflexión de su trayectoria (Euler y Savary).
inflection_in_pin = {$fixed} está en el infinito: {$pin} mismo pasa por una inflexión, y es J.
inflection_pole = La normal al rayo en {$point} y la normal a la tangente polar en {$pole} se cortan en {$found}, el polo de inflexiones: la circunferencia sobre {$pole} {$found} es la de inflexiones.
inflections_differ = Los polos de inflexiones de estas rectas y los del movimiento calculado difieren en {$difference} del diámetro o del mecanismo; los cortes permiten {$allowed}.
curvatures_differ = Los centros de curvatura según estas rectas y según el movimiento calculado difieren en {$difference} del radio o del mecanismo; los cruces permiten {$allowed}.
velocity_of_center = Trazar {$vector}, la de {$center}: el eslabón {$link} no gira.
centers_differ = Los centros por estas rectas y los del movimiento calculado difieren en {$difference} del tamaño del mecanismo; los cortes permiten {$allowed}.

weight_letter = W
one_link = el eslabón {$link}
several_links = los eslabones {$links}
force_moments = Los momentos de {$links} respecto a {$point} dan {$force}.
force_moments_crossing = Los momentos de {$links} respecto al cruce de las líneas de {$first} y {$second} dan {$force}.
force_couple = Los momentos de {$links} respecto a {$point} dan {$couple}, con el que la fuerza en la guía de {$guide} actúa al lado de {$point}.
force_begin = Polígono de {$links}, a {$scale}: se traza {$force}.
force_lay_off = Se traza {$force}.
force_direction = Se traza la dirección de {$force}.
force_cross = El cruce da {$first} y {$second}.
force_close = {$force} cierra el polígono.
force_sum = {$force} es la suma de sus componentes.
force_inner = {$force} cierra el polígono de {$links} solo.
force_push = A lo largo de la guía de {$guide} el accionamiento empuja con {$force}.
forces_by_numbers = Para las reacciones de {$links} no hay aquí construcción: se trazan a partir de las ecuaciones de equilibrio.
force_polygon = Polígono de {$links}: se trazan {$known}.
force_polygon_closed = Lo cierran {$forces}.
force_polygon_joined = Los vértices dan {$forces}.
forces_differ = Las fuerzas de estos polígonos y de las ecuaciones de equilibrio difieren en {$difference} de la fuerza mayor; el redondeo y los cruces permiten {$allowed}.
lever_turn = Se gira el plano de velocidades 90° en sentido horario: es una palanca.
lever_turn_for = Se giran las velocidades 90° en sentido horario, mientras {$drive} marcha a velocidad 1 y los demás accionamientos están parados: forman una palanca.
lever_arm = {$force} actúa en la imagen de su punto: se mide su brazo.
lever_effort = Los momentos respecto al polo dan {$effort}: ninguna reacción tiene momento.
speeds_train = Se dibuja la línea de centros con centros y puntos primitivos a la escala de longitudes; las velocidades se llevan normales a ella.
speeds_given = Se llevan las velocidades de {$from} y {$to}: todas las velocidades de {$link} en la línea de centros terminan en la recta por sus extremos.
speeds_line = {$from} y {$to} tienen velocidades ya conocidas: las de {$link} terminan en la recta por sus extremos.
speeds_pole = Se elige un punto o y una base debajo, a la distancia que hace redonda la escala de velocidades angulares.
speeds_ray = La paralela por o a la recta de {$link} corta {$rate} en la base.
speeds_slides = {$link} se desliza: todos sus puntos tienen la velocidad de {$at}.
speeds_slides_given = Se lleva la velocidad de {$at}: {$link} se desliza, y todos sus puntos la tienen.
speeds_belt = La correa da a ambas llantas una misma velocidad: {$to} tiene la velocidad de {$from}.
speeds_turned = En el diagrama de Kutzbach los centros fuera de la línea se giran hasta ella; distancias y velocidades no cambian: {$points}.
speeds_unsized_belt = el diagrama de Kutzbach omite la correa de {$first} y {$second}: no se sabe cómo son de grandes sus ruedas; indique su `radius`
speeds_none = no hay diagrama de Kutzbach: no engranan dos ruedas ni llevan correa, y ninguna rueda sobre una cremallera
speeds_left_out = el diagrama de Kutzbach es el de la línea de centros por {$line}; lo que se toca en {$meshes} está en otra recta y no se puede girar hasta ella

# The figure.

title = Planos de velocidades y aceleraciones
scheme = Esquema
velocity_plan = Plano de velocidades
# Its velocities are drawn turned by 90°, one way or the other.
turned_plan = {$plan}, girado {$angle}°
acceleration_plan = Plano de aceleraciones
centers = Centros instantáneos
force_plan = Plano de fuerzas
lever = Palanca
speeds = Diagrama de Kutzbach
far_away = {$point}: a {$distance} de {$from}
far_in_plan = hasta {$point}: {$distance}
cut_at_edge = recortado en el borde
names_without_room = no caben todos los nombres
names_left_out = no caben:
loads_without_scale = Las cargas se dibujan sin escala.
friction_told = El rozamiento se halla junto con las fuerzas: F^{"{"}f{"}"} = μ |N| a lo largo de guías, M^{"{"}f{"}"} = ρ |R| en pasadores, ρ el radio del círculo de rozamiento.
at_infinity = {$point} en el infinito
paths = Marcas en la trayectoria de {$points}: cada {$step} de la pieza motriz {$drive}.
paths_in_time = Marcas en la trayectoria de {$points}: cada {$step} de la pieza motriz {$drive}, es decir, cada {$time}.
path_of = Trayectoria de {$point} en {$unit}
mode = modo {$number}
contact_link = El eslabón {$link} equivale al contacto de {$first} y {$second}: une sus centros de curvatura {$from} y {$to}.
contact_face = Un pasador en {$center}, el centro de curvatura de {$first}, que desliza a lo largo de la cara plana de {$second} equivale a su contacto.
contact_here = Eso vale solo en esta posición.
equivalent = {$link} (equivalente)
modes_left_out = De los otros modos de montaje solo se dibujan los primeros {$count}.
centrodes = Polodias del eslabón {$links}, cerca del mecanismo: la fija en trazo continuo, la móvil a trazos.
no_centrodes = El eslabón {$links} gira alrededor de un punto fijo o no gira: no tiene polodias.
inflection_circle = Circunferencia de inflexiones del eslabón {$link}: diámetro {$diameter}, por el centro instantáneo {$center} y el polo de inflexión {$pole}.
no_inflection_circle = El eslabón {$link} gira alrededor de un punto fijo o no gira: no tiene circunferencia de inflexiones.
no_centers = {$centers}: los eslabones están en reposo relativo, así que aquí no tienen centro instantáneo.
no_velocities_by_centers = Velocidad de {$points} por centros: no se encuentra. Hacen falta un solo accionamiento que se mueva y centros del eslabón del punto que no coincidan.
no_curvatures = Curvatura de la trayectoria de {$points}: no se encuentra. Hacen falta dos pasadores del eslabón en manivelas o en correderas de la bancada, y un centro del eslabón que no sea fijo.
too_many_for_lines = Las rectas hacia centros instantáneos se buscan en mecanismos de {$most} eslabones como máximo: estos centros vienen de las velocidades calculadas.
radius_of_curvature = Radio de curvatura de la trayectoria de {$point}: {$radius}.
no_radius_of_curvature = La trayectoria de {$point} tiene una inflexión.
paths_beyond = A trazos: más allá de los límites del movimiento motriz.
agreement = Construcción y ecuaciones de lazo concuerdan: difieren en {$difference} del mayor valor (los cortes admiten {$allowed}).
one_route_far = Un punto especial está en el infinito: los valores son solo de las ecuaciones de lazo.
one_route = Un grupo no tiene construcción con dos rectas: los valores son solo de las ecuaciones de lazo.
printed = Al 100 %, mm × μ es el valor.
with_direction = {$size}, dirección {$degrees}°
segment = segmento
value = valor
values = Valores
ruler = Impreso al 100 %, esto mide 50 mm

# The text that stands for a figure where it cannot be seen.

description = Contiene: {$panels}. Grupos de Assur: {$groups}.
named_scheme = esquema
named_velocity_plan = plano de velocidades
named_acceleration_plan = plano de aceleraciones
named_centers = centros instantáneos
named_force_plan = plano de fuerzas
named_lever = palanca
named_speeds = diagrama de Kutzbach
described_scheme = el mecanismo a escala
described_velocity_plan = su plano de velocidades
described_acceleration_plan = su plano de aceleraciones
described_centers = sus centros instantáneos
described_force_plan = su plano de fuerzas
described_lever = su palanca
described_speeds = su diagrama de Kutzbach
described_group = clase {$class}, eslabones {$links}
higher = superior

# Curves.

curves = Curvas
hodograph = Hodógrafa de {$vector}
willis_all = con el portador
willis_turns = vueltas
willis_held = portador fijo
willis_together = suma
angle = Ángulo
angular_velocity = Velocidad angular
rotational_speed = Velocidad de giro
speed_ratio = Relación de velocidades angulares
angular_acceleration = Aceleración angular
position = Posición
length = Longitud
velocity = Velocidad
acceleration = Aceleración
force = Fuerza
moment = Momento
power = Potencia
in_unit = {$kind} en {$unit}
drive_angle = Ángulo {$symbol} del accionamiento en °
drive_position = Posición del accionamiento {$drive} en {$unit}

# The legend of curves.

limit = límite
change = cambio
scene = dada
dead_centre = punto muerto
extremes = valor máximo, mínimo

# The text that stands for curves where they cannot be seen.

over = Según {$drive} de {$from} a {$to}:
is_constant = {$quantity} es {$value}
least = mínimo {$value} en {$at}
greatest = máximo {$value} en {$at}
no_least = mínimo sin cota
no_greatest = máximo sin cota

# Special positions in the range of a drive; `place` is the drive's value, as in `angle(1) = 30°`.

event_limit = posición límite en {$place}: los eslabones {$links} no pueden ir más allá; sus velocidades y aceleraciones crecen sin cota
event_runs_off = posición límite en {$place}: los eslabones {$links} se alejan hasta el infinito
event_change = punto de cambio en {$place}: los eslabones {$links} podrían seguir también en otro modo; se sigue el movimiento suave, y allí se omiten velocidades y aceleraciones
event_singular = posición singular cerca de {$place}: no se puede seguir a los eslabones {$links} a través de ella
event_turns_back = posición extrema en {$place}: el eslabón {$link} se detiene a {$angle}° e invierte su giro
event_slides_back = posición extrema en {$place}: la corredera {$slider} se detiene en {$position} e invierte su deslizamiento
event_leaves = fin del recorrido en {$place}: la corredera {$slider} deja su guía en {$position}
engaged = La ranura está en contacto con {$drive} de {$from} a {$to}, {$held} de una vuelta; durante los otros {$free} reposa.
events_left_out = siguen {$count} posiciones extremas o puntos de cambio más
rates_of_every_position = cada posición tiene la ω y la α que la escena da al accionamiento: no es un arranque, en el que ω cambiaría

# The structure: Assur groups in solving order.

structure_freedoms = grados de libertad: {$count}, tantos como accionamientos
structure_known = movimientos conocidos: {$motions}
structure_drives = accionamientos: {$count}; movimientos conocidos: {$motions}
structure_positions = posiciones a partir de {$angle}: {$groups}
structure_group = eslabones {$links}: clase {$class}, {$shape}
structure_special_points = puntos especiales {$points}
shape_second = dos eslabones
shape_third = un eslabón central unido a otros tres
shape_fourth = dos eslabones de arrastre unidos por dos eslabones de cierre, un contorno cerrado de cuatro
shape_higher = más eslabones que los de las clases II a IV, o unidos de otra manera
structure_wheel = eslabón {$link}: una sola rueda, que gira por lo que toca

# The list of assembly modes.

modes = {$count ->
    [one] {$count} modo de montaje
   *[other] {$count} modos de montaje
}
modes_at_least = al menos {$count}
modes_listed = {$modes}, se muestran los primeros {$listed}
modes_heading = {$modes}; coordenadas en {$unit}, ángulos en grados
modes_of_group = eslabones {$links}: se hallaron {$found}, puede haber {$most} como máximo

# The report on a student's values.

check_counts = Correctos: {$right}; dentro de la tolerancia del lápiz: {$within}; fuera: {$off}
check_counts_and_senses = Correctos: {$right}; dentro de la tolerancia del lápiz: {$within}; sin sentido indicado: {$missing}; fuera: {$off}
check_right = correcto
check_within = tolerable
check_sense_missing = falta el sentido
check_senses = Falta el sentido: el tamaño es correcto, pero un número sin signo no dice el sentido. Escriba + o − delante, o "positive": "counter-clockwise" en el formulario.
check_off = FUERA
check_off_turned = FUERA: girado {$degrees}°
check_cannot_tell = no se puede decir
check_missing = Faltan {$count} de {$asked} valores pedidos: {$values}.
check_missing_many = Faltan {$count} de {$asked} valores pedidos: {$values} y {$more} más.
check_coarse_digits = Con tan pocas cifras no dicen nada: {$values}. Escriba al menos dos que no sean cero.
check_rough_places = Conocidos con demasiada imprecisión para juzgarlos: {$values}. Un radio detrás de un lugar cuenta hasta {$mm} mm.
check_too_small = Demasiado pequeños en la hoja para juzgarlos: {$values}. Una mano correcta podría no encontrar nada allí.
check_coarse = Sin construcción gráfica, por lo que se admite hasta el {$percent} % (en un ángulo, {$degrees}°): {$values}.
check_all_larger = Todas las longitudes son un {$percent} % demasiado grandes: ¿se imprimió la hoja ajustada a la página? Se juzgan sin eso.
check_all_smaller = Todas las longitudes son un {$percent} % demasiado pequeñas: ¿se imprimió la hoja ajustada a la página? Se juzgan sin eso.
check_all_longer = Todas las longitudes son {$mm} mm demasiado largas: ¿leyó la regla desde su borde, o desde {$mm}? Se juzgan sin eso.
check_all_shorter = Todas las longitudes son {$mm} mm demasiado cortas: ¿puso el borde de la regla en el punto? Se juzgan sin eso.
check_other_scale = {$scale}: el formulario indica {$stated}, el ejercicio {$asked}; sus valores se juzgan con la suya.
check_no_such_scale = {$scale} = {$stated}: ninguna hoja puede mostrar así {$sheet}; se admite lo de un dibujo con {$used}.
column_quantity = magnitud
check_column_written = medido
check_column_expected = esperado
check_column_difference = diferencia
check_column_on_paper = en papel
check_column_percent = en %
check_column_allowed = admitido
check_column_verdict = juicio
check_tolerance = Lo que se admite aquí es lo que puede diferir un dibujo cuidadoso (±{$mm} mm, ±{$degrees}° en cada trazo).
check_accuracy = El dibujo tiene una precisión de unos {$mm} mm y {$degrees}°, como muestra la dispersión de todos los valores.
check_slips = Los números calculados difieren hasta cerca de un {$percent} %.
check_wider = Por eso se admite más que a una mano cuidadosa (±{$mm} mm, ±{$degrees}°).
check_too_coarse = Se pedía una mano de ±{$mm} mm y ±{$degrees}°.
check_probably = Qué ocurrió probablemente
check_nothing = Todo correcto.
check_so_far = Ningún valor está fuera: {$good} de {$asked} son correctos, los demás no se conocen.
check_tells_nothing = Estos valores no dicen nada, ni correcto ni falso.
check_no_single = Ningún error explica esto por sí solo. Juntos lo explican estos:
check_none = Algo está mal a partir del paso {$number}: {$value} es el primer valor que difiere. No se puede decir la causa.
check_step = Paso {$number}
check_whole = Todo el dibujo
check_instead = Lo correcto
check_follows = De ello se siguen, y son coherentes con ello: {$values}.
check_follows_none = De ello no se sigue ningún otro de los valores.
check_values_of = Estos son los valores de otro ejercicio: {$exercise}.
check_worked = Con sus números: {$calculation}.
check_worked_beside = Con sus números: {$calculation}; usted tiene {$own}.
check_seems_left = Parece girado {$degrees}° a la izquierda.
check_seems_right = Parece girado {$degrees}° a la derecha.
check_seems_longer = Parece {$mm} mm demasiado largo.
check_seems_shorter = Parece {$mm} mm demasiado corto.
check_seems_elsewhere = El punto parece estar a {$mm} mm de donde se cortan sus dos rectas: desde {$first} se ve {$one}° al lado de su recta, desde {$second} {$other}°.
check_redo = Repita los pasos {$steps}. Conserve lo demás.
check_redo_one = Repita el paso {$step}. Conserve lo demás.
check_redo_number = Corrija solo este número; el dibujo queda.
check_sure = Certeza: {$percent} %
check_others = También podría ser
check_perhaps = Quizá fue así
check_hint_plan = Revise su {$plan}.
check_hint_whole = Revise el dibujo entero: su posición, su escala, sus sentidos.
check_hint_value = El primer valor que difiere es {$value}.
check_alike = los valores por sí solos no lo distinguen de lo anterior
check_unexplained = Sin explicación: {$values}.
check_not_looked = En una construcción tan grande no se buscan causas.
check_looked_at = Un formulario tan grande se examina en parte: las causas se buscan solo en los primeros {$count} valores.
check_mirrored = Los puntos del {$plan} son la imagen especular de los correctos: todos los sentidos quedan invertidos. Si midió y hacia abajo en la hoja, mídala hacia arriba.
check_turned_left = Todo el {$plan} está girado {$degrees}° a la izquierda. Si la hoja no se puso así, fue su primer vector.
check_turned_right = Todo el {$plan} está girado {$degrees}° a la derecha. Si la hoja no se puso así, fue su primer vector.

# A student's drawing over the right figure.

check_key_right = como debe ser
check_key_own = lo dibujado (con *)
check_key_wrong = donde está el error
check_follows_marked = De ello se siguen, y son coherentes con ello, {$count} valores con la marca {$mark} en la tabla.
check_beyond = {$point}: {$mm} mm más allá
check_turned = Los puntos del {$plan} se muestran girados {$degrees}°, como mejor encajan.

# Photographs of drawings.

photo_column_point = punto
photo_column_right = correcto mm
photo_column_found = visto mm
photo_column_off = separado mm
photo_column_band = ± mm
photo_cannot_tell = no se puede saber con esta foto
photo_left = no encontrado
photo_sheet = {$file}: hoja {$number} de {$name}

# What fills the blanks of mistakes' sentences.

line_cut = la recta que se trazó para hallar {$point}
line_guide = la guía de {$slider}
line_through = la recta {$points}
all_segments = todos los segmentos de la hoja
all_lengths = todas las longitudes
all_velocities = todas las velocidades
all_accelerations = todas las aceleraciones
all_angular_velocities = todas las velocidades angulares
all_angular_accelerations = todas las aceleraciones angulares
all_forces = todas las fuerzas
all_moments = todos los momentos
horizontal = horizontal
vertical = vertical

# Marks, and the summary of a class.

class_marks = Puntos: {$earned} de {$of}
class_marks_following = Puntos: {$earned} de {$of}, {$follow} de ellos por valores que se siguen de un error
class_counts = {$files ->
    [one] {$files} archivo: {$passed} aprobados, {$off} con errores, {$broken} no entendidos
   *[other] {$files} archivos: {$passed} aprobados, {$off} con errores, {$broken} no entendidos
}
class_incomplete = {$count} sin ningún valor fuera, pero incompletos
class_common = {$count} de {$of}: paso {$step}, {$done}
class_common_whole = {$count} de {$of}: todo el dibujo, {$done}
class_unknown = {$count} de {$of}: hay valores fuera, no se conoce la causa
class_not_understood = Este formulario no se entendió. Entréguelo de nuevo cuando esto esté corregido:

# The sheets of exercises.

exercise_given = Datos: {$all}.
exercise_draw = Dibujar los planos a {$scales}. Medir, también en esta hoja, y rellenar las casillas.
exercise_centers = Hallar los centros instantáneos a {$scales}. Medir y rellenar las casillas; las coordenadas se cuentan desde el origen de los lugares dados.
exercise_forces = Hallar las fuerzas con momentos y polígonos de fuerzas a {$scales}; los brazos se miden en esta hoja. Medir y rellenar las casillas. Una R nombra una articulación y el eslabón sobre el que actúa allí.
exercise_lever = Hallar lo que necesita el accionamiento con la palanca de Zhukovski a {$scales}: fuerzas en las imágenes de sus puntos. Medir y rellenar las casillas.
exercise_guide = guía de {$slider} por {$place} a {$degrees}°
exercise_guide_through = guía de {$slider} según {$line}
exercise_wheel = rueda {$link} ({$teeth} dientes)
exercise_ring = corona {$link} ({$teeth} dientes)
exercise_fixed_wheel = rueda fija ({$teeth} dientes)
exercise_fixed_ring = corona fija ({$teeth} dientes)
exercise_mesh = engrane de {$first} con {$second}
exercise_mesh_on = engrane de {$first} con {$second} sobre el brazo {$arm}
exercise_room = El plano de velocidades ocupa {$velocity}, el de aceleraciones {$acceleration}: dibujar cada uno en {$paper} o mayor.
exercise_sheets = Siguen las hojas para los planos.
exercise_center_sheet = Sigue una hoja para los centros instantáneos.
sheet_markers = Foto: hoja plana, los ocho cuadrados a la vista.
exercise_senses = Signos: antihorario es +.
exercise_senses_of_slides = Signos: antihorario es +; {$slides}: + según la flecha marcada con +.
exercise_points = Puntos: {$all}.
exercise_normal_ends = {$points}: extremo de una parte normal
exercise_coriolis_ends = {$points}: extremo de una parte de Coriolis
exercise_sliding_ends = {$points}: extremo de una parte de deslizamiento
exercise_name = Nombre: ………………………………… Fecha: ………………
exercise_allowed = ± es lo que puede desviarse una mano cuidadosa.

# Exercises in a course.

course_digits = Escribir cada valor con tres cifras significativas, en la unidad que está junto a su casilla.
course_other_sense = La magnitud es correcta, el sentido no.
course_cause = Causa probable: {$told}
course_follows = Este valor se deduce de ello.
course_picture = El mecanismo a escala
course_print = Hoja para imprimir a su tamaño real
course_key = El mecanismo con ambos planos
course_if = Si se obtuvo {$value}:


## Mistakes: what was probably done, and what it should be

turned_ray-done = la recta desde {$from} hasta {$to} se trazó girada 90°: paralela en lugar de perpendicular, o al revés
turned_ray-should = la recta de un movimiento relativo entre dos puntos de un mismo eslabón es normal a la línea que los une; solo la de un deslizamiento es paralela a su guía
turned_rays-done = las rectas desde {$from} hasta {$to} y desde {$other} hasta {$to} se trazaron giradas 90°: paralelas en lugar de perpendiculares, o al revés
turned_rays-should = la recta de un movimiento relativo entre dos puntos de un mismo eslabón es normal a la línea que los une; solo la de un deslizamiento es paralela a su guía
turned_cut_line-done = la recta por {$joint} para hallar {$point} se trazó a lo largo de la guía
turned_cut_line-should = {$point} está sobre la normal a la guía por {$joint}
ray_from_wrong_point-done = la recta hacia {$image} se trazó por {$wrong}
ray_from_wrong_point-should = parte de {$right}, donde termina lo conocido de la ecuación vectorial
wrong_lines-done = {$point} se marcó sobre {$wrong}
wrong_lines-should = {$point} está sobre {$right}
reversed_vector-done = el vector desde {$from} hasta {$to} se trazó con el sentido contrario
reversed_vector-should = va desde {$from} hasta {$to}, en el sentido en que gira o desliza su eslabón
turned_vector-done = el vector desde {$from} hasta {$to} se trazó girado 90°
turned_vector-should = una velocidad o una aceleración tangencial es normal a la línea que une los dos puntos; una aceleración normal sigue esa línea
turned_vectors-done = el vector desde {$from} hasta {$to} se trazó desviado {$degrees}° en ambos planos
turned_vectors-should = la velocidad es normal a la manivela; la aceleración normal sigue la manivela hacia su centro de giro
vector_from_wrong_point-done = el vector hasta {$end} se trazó desde {$wrong}
vector_from_wrong_point-should = parte de {$right}
normal_outward-done = la aceleración normal {$rate}² {$length}, desde {$from} hasta {$to}, se trazó hacia fuera
normal_outward-should = la aceleración normal apunta hacia el punto alrededor del cual gira el eslabón
normals_outward-done = las aceleraciones normales {$vectors} se trazaron hacia fuera
normals_outward-should = la aceleración normal apunta hacia el punto alrededor del cual gira el eslabón
omega_not_squared-done = para la aceleración normal desde {$from} hasta {$to} se tomó {$rate} en lugar de su cuadrado
omega_not_squared-should = la aceleración normal es {$rate}² {$length}
omegas_not_squared-done = para las aceleraciones normales {$vectors} se tomó ω en lugar de su cuadrado
omegas_not_squared-should = una aceleración normal es ω² por la longitud
omega_of_another_link-done = para el vector desde {$from} hasta {$to} se tomó {$wrong} en lugar de {$rate}
omega_of_another_link-should = al vector le corresponden {$rate} y {$factor}
omegas_interchanged-done = en las aceleraciones normales se tomaron {$rate} y {$wrong} una en lugar de otra, primero desde {$from} hasta {$to}
omegas_interchanged-should = a cada aceleración normal le corresponde la velocidad angular de su propio eslabón: a la de {$from} a {$to}, {$rate}
diameter-done = la aceleración normal {$rate}² {$length}, desde {$from} hasta {$to}, resultó el doble, como con el diámetro
diameter-should = la aceleración normal es {$rate}² por el radio {$length}
diameter_throughout-done = en velocidad y aceleración se tomó como radio el doble de {$length}, como con el diámetro o la carrera
diameter_throughout-should = tomar el radio {$length}
half_the_radius-done = en velocidad y aceleración se tomó como radio la mitad de {$length}
half_the_radius-should = {$length} es el radio, no el diámetro
normal_from_absolute-done = la aceleración normal según {$length}, desde {$from} hasta {$to}, se calculó con la velocidad {$velocity}
normal_from_absolute-should = se calcula con la velocidad relativa: {$rate}² {$length}
normal_forgotten-done = se olvidó la aceleración normal {$rate}² {$length}, desde {$from} hasta {$to}
normal_forgotten-should = trazar {$rate}² {$length} antes que la recta
normals_forgotten-done = se olvidaron las aceleraciones normales {$vectors}
normals_forgotten-should = trazar ω² por la longitud antes que cada recta
tangential_where_none-done = a la aceleración normal desde {$from} hasta {$to} se sumó una tangencial {$rate} {$length}
tangential_where_none-should = {$rate} no cambia, así que no hay aceleración tangencial: la aceleración es {$rate}² {$length}
coriolis_forgotten-done = se olvidó la aceleración de Coriolis, desde {$from} hasta {$to}
coriolis_forgotten-should = trazar 2 {$rate} {$velocity} normal a la guía
coriolis_without_two-done = la aceleración de Coriolis, desde {$from} hasta {$to}, se tomó sin su factor 2
coriolis_without_two-should = es 2 {$rate} {$velocity}
coriolis_turned-done = la aceleración de Coriolis, desde {$from} hasta {$to}, se trazó con el sentido contrario
coriolis_turned-should = tiene la dirección de {$velocity} girada 90° en el sentido de {$rate}
coriolis_along-done = la aceleración de Coriolis, desde {$from} hasta {$to}, se trazó a lo largo de la guía
coriolis_along-should = es normal a la guía: tiene la dirección de {$velocity} girada 90° en el sentido de {$rate}
coriolis_velocity-done = la aceleración de Coriolis, desde {$from} hasta {$to}, se calculó con la velocidad {$wrong}
coriolis_velocity-should = se calcula con la velocidad de deslizamiento: 2 {$rate} {$velocity}
coriolis_velocity_and_omega-done = la aceleración de Coriolis, desde {$from} hasta {$to}, se calculó con {$omega} y la velocidad {$wrong}
coriolis_velocity_and_omega-should = se calcula con el giro de la guía y la velocidad de deslizamiento: 2 {$rate} {$velocity}
coriolis_where_none-done = se sumó una aceleración de Coriolis a {$rate}² {$length}, desde {$from} hasta {$to}, donde nada desliza
coriolis_where_none-should = solo hay aceleración de Coriolis donde algo desliza sobre un eslabón que gira
coriolis_at_rest-done = se trazó una aceleración de Coriolis 2 {$rate} {$velocity} desde {$from}, antes que la recta hacia {$to}
coriolis_at_rest-should = la guía está fija: solo hay aceleración de Coriolis donde algo desliza sobre un eslabón que gira
mirrored_image-done = {$point} se trazó al otro lado de {$start} {$other}: la imagen del eslabón queda reflejada
mirrored_image-should = la imagen de un eslabón es semejante a él, girada pero nunca reflejada
beyond_end-done = {$point} se marcó al otro lado de {$start}, sobre la línea de {$start} y {$other}
beyond_end-should = las imágenes están en su línea en el mismo orden que los puntos en el eslabón
wrong_ratio-done = la recta desde {$from} hasta {$to} se dividió desde el extremo equivocado: {$point} tiene de {$from} la distancia que debería tener de {$to}
wrong_ratio-should = la imagen divide la recta de las imágenes como el punto divide la recta de los puntos
inverse_ratio-done = {$point} tiene la razón inversa: las distancias desde {$from} hasta {$point} y desde {$from} hasta {$to} están intercambiadas
inverse_ratio-should = la imagen divide la recta de las imágenes como el punto divide la recta de los puntos
distances_exchanged-done = {$point} tiene de {$from} la distancia que debería tener de {$to}, y al revés
distances_exchanged-should = la imagen de un eslabón es semejante a él: cada ángulo de su triángulo está en su propio extremo
distances_exchanged_and_mirrored-done = {$point} quedó al otro lado de la línea desde {$from} hasta {$to}, y con las distancias a ambos intercambiadas
distances_exchanged_and_mirrored-should = la imagen de un eslabón es semejante a él: cada ángulo de su triángulo está en su propio extremo
wrong_segment-done = para {$segment} se midió el segmento desde {$from} hasta {$to}
wrong_segment-should = medir {$segment}
component-done = de {$segment} se midió solo la componente {$axis}
component-should = medir la longitud verdadera desde {$from} hasta {$to}
wrong_length-done = para {$length} se tomó la longitud desde {$from} hasta {$to}
wrong_length-should = tomar {$length}
wrong_length_throughout-done = para {$length} se tomó la longitud desde {$from} hasta {$to} en todas las operaciones
wrong_length_throughout-should = tomar {$length}
omega_from_wrong_length-done = {$rate} se halló con la longitud desde {$from} hasta {$to}
omega_from_wrong_length-should = dividir entre {$length}
omega_and_normal_from_wrong_length-done = {$rate} y la aceleración normal hasta {$normal} se hallaron con la longitud desde {$from} hasta {$to}
omega_and_normal_from_wrong_length-should = tomar {$length} en ambas
alpha_from_wrong_length-done = {$rate} se halló con la longitud desde {$from} hasta {$to}
alpha_from_wrong_length-should = dividir entre {$length}
not_divided_by_length-done = para {$rate} no se dividió el segmento entre {$length}
not_divided_by_length-should = dividir entre {$length}
wrong_sense-done = {$rate} se tomó con el sentido contrario
wrong_sense-should = el sentido se deduce de la dirección del segmento en el plano y del lado en que queda su línea en el mecanismo
wrong_sense_given-done = {$rate} se tomó con el sentido contrario: el vector desde {$from} hasta {$to} apunta al revés
wrong_sense_given-should = el sentido de {$rate} es un dato
senses_reversed-done = los sentidos de todas las velocidades y aceleraciones angulares están invertidos, como si el horario fuera el positivo
senses_reversed-should = el sentido antihorario es el positivo
revolutions_for_radians-done = {$rate} no se convirtió entre revoluciones por minuto y radianes por segundo
revolutions_for_radians-should = rad/s = rpm · π/30
rate_in_other_unit-done = {$rate}: el dato es {$number} {$given}; se tomó como {$number} {$taken}
rate_in_other_unit-should = seguir con {$number} {$given}
all_in_other_unit-done = {$values}, como {$first}, están en {$unit}, y ninguna unidad lo dice
all_in_other_unit-should = escribir {$unit} al lado, o los valores en {$own}
value_for_paper-done = {$quantity}: {$number} es el valor en {$unit}; se piden milímetros de papel
value_for_paper-should = {$number} : {$scale} = {$mm} mm en el papel
values_for_paper-done = {$segments}: se escribieron valores en {$unit}; se piden milímetros de papel
values_for_paper-should = un valor dividido por {$scale} es su longitud en el papel en milímetros
common_factor_degrees-done = {$values}, como {$first}, valen {$factor} veces lo que deberían
common_factor_degrees-should = todo producto toma las velocidades angulares en radianes por segundo: 1 rad son 57,2958°
common_factor_turns-done = {$values}, como {$first}, valen {$factor} veces lo que deberían
common_factor_turns-should = todo producto toma las velocidades angulares en radianes por segundo: 1 vuelta son 2π rad
common_factor_rpm-done = {$values}, como {$first}, valen {$factor} veces lo que deberían
common_factor_rpm-should = todo producto toma las velocidades angulares en radianes por segundo: 1 rad/s son 9,5493 vueltas por minuto
common_factor_minutes-done = {$values}, como {$first}, valen {$factor} veces lo que deberían
common_factor_minutes-should = todos los tiempos van en una unidad: un minuto tiene 60 segundos
common_factor_units-done = {$values}, como {$first}, valen {$factor} veces lo que deberían
common_factor_units-should = todas las longitudes van en una unidad: 1 m son 100 cm o 1000 mm
revolutions_per_second-done = {$rate} no se convirtió entre revoluciones por segundo y radianes por segundo
revolutions_per_second-should = rad/s = rev/s · 2π
degrees_for_radians-done = {$rate} no se convirtió entre grados y radianes
degrees_for_radians-should = las velocidades y aceleraciones angulares entran en todo producto en radianes
wrong_scale-done = {$segment}: se usó {$wrong} en lugar de {$scale}
wrong_scale-should = los milímetros de esta hoja por {$scale} dan el valor
scale_forgotten-done = {$segment}: se tomaron los milímetros de papel como valor, sin {$scale}
scale_forgotten-should = los milímetros de esta hoja por {$scale} dan el valor
center_along_guide-done = {$center} se buscó a lo largo de {$guide}
center_along_guide-should = {$center} está en el infinito, normal a {$guide}: las rectas hacia él son normales a la guía
center_at_slider-done = {$center} se tomó en {$pin}, la articulación de la corredera
center_at_slider-should = {$pin} es el centro de la corredera con su otro eslabón; {$center} está en el infinito, normal a {$guide}
line_without_common_link-done = {$center} se marcó sobre {$wrong}
line_without_common_link-should = {$center} está sobre {$right}: cada una de sus rectas une dos centros que tienen en común un tercer eslabón
center_of_other_lines-done = {$center} se marcó donde se cortan las rectas de {$other}
center_of_other_lines-should = cada recta de {$center} une dos centros que tienen en común un tercer eslabón
centers_swapped-done = {$first} y {$second} se confundieron entre sí
centers_swapped-should = cada recta de {$first} une dos centros que tienen en común un tercer eslabón
ratio_inverted-done = para {$rate} se tomó al revés la razón de las distancias
ratio_inverted-should = las distancias del centro común son inversas a las velocidades angulares: multiplicar por {$over} / {$under}
mesh_sense-done = se tomó que las ruedas {$first} y {$second} giran en el mismo sentido, vistas desde su brazo
mesh_sense-should = las ruedas que se tocan por fuera giran en sentidos contrarios, vistas desde su brazo
mesh_sense_internal-done = se tomó que la corona y la rueda de {$first} y {$second} giran en sentidos contrarios, vistas desde su brazo
mesh_sense_internal-should = una corona y la rueda dentro de ella giran en el mismo sentido, vistas desde su brazo
teeth_inverted-done = para las ruedas {$first} y {$second} se tomó al revés la razón de los dientes
teeth_inverted-should = las velocidades angulares son inversas a los números de dientes
arm_forgotten-done = para las ruedas {$first} y {$second} se tomó la razón de los dientes sin el giro de {$arm}
arm_forgotten-should = la razón de los dientes vale para las velocidades angulares menos ω_{$arm}
relative_for_absolute-done = {$rate} es la relativa a {$arm}
relative_for_absolute-should = sumar ω_{$arm}
idler_counted-done = los dientes de {$idler} están en la razón de {$first} y {$last}
idler_counted-should = una rueda intermedia solo cambia el sentido; sus dientes se simplifican
rim_swapped-done = donde {$wheel} engrana con {$other} se tomaron los dientes de su otra corona dentada
rim_swapped-should = tomar los dientes de la corona dentada que toca
rims_swapped-done = las dos coronas dentadas de {$wheel} se tomaron una por otra
rims_swapped-should = tomar en cada engrane los dientes de la corona dentada que toca
pitch_on_wrong_side-done = se tomó que {$wheel} toca la corona {$ring} por el lado cercano
pitch_on_wrong_side-should = una corona toca la rueda dentro de ella más allá del centro de la rueda
accelerations_equal-done = donde {$first} y {$second} se tocan, sus aceleraciones se tomaron por iguales
accelerations_equal-should = ahí solo son iguales las velocidades y las partes tangenciales; la aceleración del centro de la rueda se sigue de su brazo
diameter_for_radius-done = para {$found} se tomó el diámetro de la rueda {$wheel} en lugar de su radio
diameter_for_radius-should = la velocidad es ω r y el momento W r, con el radio r de la rueda {$wheel}
radial_force_left_out-done = falta {$force}: la fuerza entre los dientes se tomó solo según la tangente
radial_force_left_out-should = los dientes se empujan según su línea de acción: junto a la parte según la tangente está {$force}, tan α veces mayor, que separa las ruedas
radius_left_out-done = para {$length} se tomó solo el radio de {$link}
radius_left_out-should = el eslabón equivalente une los centros de curvatura: {$length} es la suma de ambos radios, en un perfil hueco su diferencia
wrong_center_of_curvature-done = la normal común de {$first} y {$second} se trazó desde {$wrong}
wrong_center_of_curvature-should = la normal común pasa por {$right}, el centro de curvatura del perfil donde se tocan
sliding_left_out-done = {$image} se marcó en {$start}, como si los perfiles no se movieran uno a lo largo del otro
sliding_left_out-should = los perfiles que se tocan solo tienen iguales las velocidades según su normal común: desde {$start} se traza la velocidad relativa, según su tangente
face_along_wrong_line-done = la cara plana de {$link} se tomó a lo largo de {$line}
face_along_wrong_line-should = la velocidad relativa es paralela a la cara
face_normal_to_wrong_line-done = la cara plana de {$link} se tomó normal a {$line}
face_normal_to_wrong_line-should = la velocidad relativa es paralela a la cara, y la normal común es normal a la cara misma
friction_sense-done = {$friction} se tomó en el sentido del movimiento
friction_sense-should = el rozamiento se opone: lo que una guía o un perno hace a un eslabón es contrario a cómo el eslabón se mueve sobre él
angle_for_coefficient-done = para {$friction} se tomó el ángulo de rozamiento por el coeficiente, o su tangente por su seno
angle_for_coefficient-should = con el ángulo de rozamiento φ el coeficiente de una guía es μ = tan φ, y el círculo de rozamiento de un perno tiene el radio r sen φ
normal_without_lean-done = {$friction} se halló con lo que la junta soportaría sin rozamiento
normal_without_lean-should = el rozamiento cambia lo que aprieta en la junta: hay que hallar las fuerzas otra vez con {$friction} hasta que ambas concuerden
friction_circle_diameter-done = {$friction} se halló con el diámetro del perno
friction_circle_diameter-should = el círculo de rozamiento tiene el radio r sen φ, con el radio r del perno
friction_left_out-done = falta {$friction}
friction_left_out-should = {$friction} se toma con las demás fuerzas: una guía se opone con μ |N|, un perno con el par de una fuerza que toca el círculo de rozamiento
sense_by_center-done = {$rate} tiene el sentido contrario
sense_by_center-should = el sentido se invierte donde el centro común está entre los dos centros fijos, y se conserva donde está fuera
velocity_reversed-done = {$velocity} se trazó en sentido contrario
velocity_reversed-should = apunta según gira su eslabón en torno a su centro fijo
distance_from_wrong_center-done = para {$length} se tomó la distancia de {$from} a {$to}
distance_from_wrong_center-should = medir {$length}: las velocidades de un eslabón crecen con la distancia a su centro con el bastidor
not_extended-done = para {$center} las rectas no se prolongaron lo suficiente: se cortaron otras entre los centros
not_extended-should = {$center} está donde se cortan {$first} y {$second}, que hay que prolongar más allá de sus centros
velocity_along_ray-done = {$velocity} se trazó a lo largo del radio desde su centro
velocity_along_ray-should = una velocidad es normal al radio desde el centro hasta su punto
pin_of_three-done = {$center} no se tomó en {$pin}, donde se articulan sus eslabones, sino en otro lugar
pin_of_three-should = una articulación que une tres eslabones es el centro de cada par de ellos
lengths_without_scale-done = {$lengths}: se tomaron milímetros de papel como longitudes, sin {$scale}
lengths_without_scale-should = los milímetros de esta lámina por {$scale} son la longitud
inertia_along_a-done = {$load} se tomó en el sentido de la aceleración
inertia_along_a-should = una fuerza de inercia es −m a: apunta contra la aceleración del centro de masas
inertia_couple_along_alpha-done = {$load} se tomó en el sentido de la aceleración angular
inertia_couple_along_alpha-should = un par de inercia es −J α: gira contra la aceleración angular; como una sola fuerza pasa junto al centro de modo que gire igual
couple_forgotten-done = {$load} falta en los momentos
couple_forgotten-should = un par tiene el mismo momento respecto a cualquier punto y cuenta en cada suma de momentos de su eslabón
percussion_on_wrong_side-done = {$load} se puso al lado equivocado del centro de masas
percussion_on_wrong_side-should = la línea de {$load} pasa a la distancia h = J α / (m a) del centro, donde gira contra la aceleración angular
a_of_joint_for_centre-done = {$load} se halló con la aceleración de {$point}
a_of_joint_for_centre-should = una fuerza de inercia sale de la aceleración del centro de masas, no de la de una articulación
centripetal_part_left_out-done = {$load} se halló sin la parte centrípeta de la aceleración alrededor de {$point}
centripetal_part_left_out-should = la aceleración del centro de masas tiene también la parte ω² r hacia {$point}
arm_to_point-done = para {$found} se midió un brazo hasta el punto donde actúa su fuerza
arm_to_point-should = el brazo de una fuerza es la distancia a su línea de acción, medida normal a ella
arm_in_paper_mm-done = para {$found} se tomaron los brazos en milímetros de papel
arm_in_paper_mm-should = un brazo es sus milímetros por {$scale}
arms_in_paper_mm-done = los brazos se tomaron en milímetros de papel
arms_in_paper_mm-should = cada brazo es sus milímetros por {$scale}
reaction_not_reversed-done = {$force} se pasó al eslabón siguiente sin invertirla
reaction_not_reversed-should = lo que un eslabón hace a otro, este se lo hace invertido: en el eslabón siguiente {$force} actúa en sentido opuesto
negative_tangential_kept-done = {$force} se llevó en el sentido supuesto, aunque los momentos la dieron negativa
negative_tangential_kept-should = una fuerza que sale negativa actúa contra el sentido supuesto: {$force} se lleva al revés
normal_across-done = la dirección de {$force} se trazó normal a la línea de las dos articulaciones
normal_across-should = {$force} actúa a lo largo de la línea de las dos articulaciones de su eslabón
force_missing_in_polygon-done = {$force} falta en el polígono
force_missing_in_polygon-should = el polígono tiene todas las fuerzas sobre los eslabones aislados, también {$force}
force_twice-done = {$force} se llevó dos veces
force_twice-should = cada fuerza está una vez en un polígono
guide_reaction_along_rod-done = {$force} se trazó a lo largo de {$guide}
guide_reaction_along_rod-should = sin rozamiento una guía solo transmite fuerzas normales a ella
guide_reaction_through_pin-done = se tomó que la fuerza de {$guide} actúa en {$point}
guide_reaction_through_pin-should = actúa a la distancia h = M / N de {$point}, que dan los momentos del eslabón que desliza
mass_for_weight-done = para {$load} se tomó el número de la masa
mass_for_weight-should = un peso es masa por g: {$load} = m g
factor_of_thousand-done = {$load} está mal por un factor de 1000
factor_of_thousand-should = con longitudes en mm, una fuerza en N es masa en kg por aceleración en mm/s², entre 1000
moment_about_wrong_point-done = para {$found} se tomaron momentos respecto a {$wrong}
moment_about_wrong_point-should = se toman momentos respecto a {$right}: por allí pasan las líneas de las otras fuerzas desconocidas
moment_about_another_point-done = para {$found} se tomaron momentos respecto a un punto distinto de {$right}
moment_about_another_point-should = los momentos se toman respecto a {$right}: por él pasan las líneas de las otras fuerzas desconocidas
lever_not_turned-done = para {$found} se pusieron las fuerzas en el plano de velocidades sin girarlo
lever_not_turned-should = primero se gira 90° el plano de velocidades, o cada fuerza: entonces los momentos respecto al polo son potencias
couple_on_lever_unscaled-done = el par del eslabón {$link} se sumó tal cual a los momentos de la palanca
couple_on_lever_unscaled-should = en la palanca un par M son dos fuerzas M/l en las imágenes de dos puntos del eslabón {$link} a la distancia l
torque_sense-done = {$found} tiene el sentido de aquello contra lo que trabaja el accionamiento
torque_sense-should = {$found} es lo que el accionamiento hace a su eslabón: equilibra los momentos de todas las fuerzas sobre él
other_mode-done = el mecanismo se dibujó en otra posición en que encajan sus eslabones
other_mode-should = se pide la posición que muestra la figura
crank_angle-done = el mecanismo se dibujó con el eslabón {$link} a {$wrong}° en lugar de {$right}°
crank_angle-should = los ángulos se miden en sentido antihorario desde la horizontal hacia la derecha
crank_angle_in_radians-done = la calculadora tomó el ángulo del eslabón {$link}, {$right}°, como {$right} radianes, que son {$wrong}°
crank_angle_in_radians-should = la calculadora se pone en grados
swapped-done = {$first} y {$second} parecen estar cada uno en la casilla del otro
swapped-should = intercambiar los dos números
digits_transposed-done = {$quantity}: dos cifras están intercambiadas, {$written} en lugar de {$meant}
digits_transposed-should = {$meant}
decimal_slipped-done = {$quantity}: la coma decimal está corrida, {$written} en lugar de {$meant}
decimal_slipped-should = {$meant}
truncated-done = los números se cortaron tras la última cifra escrita
truncated-should = redondear hacia arriba la última cifra si la siguiente es 5 o más
wrong_unit-done = {$quantity}: {$number} es el valor en {$right}, no en {$wrong}
wrong_unit-should = {$number} {$right}
other_unit-done = {$quantity}: {$number} es el valor en {$unit}, y ninguna unidad lo dice
other_unit-should = escribir {$unit} al lado, o el valor en {$own}
unknown-done = {$quantity} difiere por un motivo que los valores no muestran; se siguió con ese valor
unknown-should = Revise {$quantity}
unknown_alone-done = solo {$quantity} difiere: se leyó, calculó o escribió mal, y no se siguió con ese valor
unknown_alone-should = Obtenga {$quantity} de nuevo
unknown_first-done = {$quantity} es el primer valor que difiere, por un motivo que los valores no muestran
unknown_first-should = Revise este primero: los valores posteriores pueden seguirse de él


## Errors and warnings: scene


# Kinds of files.

scene-scene = escena
scene-study = estudio
scene-drawing = dibujo
scene-style = estilo
scene-form = valores medidos
scene-marks = baremo
scene-begins_with = un archivo de {$what} empieza por {$start}
scene-too_many_bytes = el archivo de {$what} tiene {$bytes} bytes; se leen como máximo {$most} ({$mib} MiB)
scene-is_empty = el archivo de {$what} está vacío
scene-expected_object = aquí va un archivo de {$what} como {$start}, y hay {$found}
scene-meant_key = ¿quiso decir `{$key}` con `{$other}`?
scene-add_version = añada "{$key}": {$version}, la versión del formato de {$what}
scene-no_version = falta `{$key}`, así que puede que esto no sea un archivo de {$what}
scene-other_version = este programa lee la versión {$version}, y el archivo de {$what} dice {$said}
scene-version_is_number = aquí va el número {$version}, la versión del formato, y hay {$found}
scene-write_version = escriba "{$key}": {$version}

# Text that is not JSON.

scene-not_json = esto no es JSON: {$what}
scene-not_json_at_all = esto no es JSON
scene-text_over_lines = un texto termina en la misma línea en que empieza
scene-add_quote_or_n = añada la " que falta, o escriba \n para un salto de línea
scene-control_in_text = un texto contiene un tabulador u otro carácter de control
scene-write_t = escriba \t para un tabulador
scene-too_deep = hay corchetes anidados a más de {$most} niveles
scene-no_comments = JSON no tiene comentarios
scene-write_note = escriba "note": "…", que se admite en cualquier lugar
scene-trailing_comma = hay una coma delante del corchete de cierre
scene-remove_comma = quite la coma
scene-leading_zero = un número no empieza por 0
scene-remove_zero = quite el 0 inicial
scene-comma_missing = falta aquí una coma
scene-brace_open = esta {"{"} no se cierra nunca
scene-add_brace = añada la {"}"} que falta
scene-bracket_open = este [ no se cierra nunca
scene-add_bracket = añada el ] que falta
scene-brace_for_value = hay una {"}"} donde debería haber un valor
scene-bracket_for_value = hay un ] donde debería haber un valor
scene-comma_for_value = hay una coma donde debería haber un valor
scene-colon_for_value = hay dos puntos donde debería haber un valor
scene-colon_missing = faltan dos puntos después de esta clave
scene-value_missing = falta el valor de esta clave
scene-after_end = hay algo después del final de: {$what}
scene-one_in_a_file = cada archivo de {$what} tiene un solo par de {"{"} {"}"}
scene-single_quotes = los textos van entre comillas dobles
scene-write_double = escriba "A" en lugar de 'A'
scene-key_needs_quotes = la clave {$word} necesita comillas dobles
scene-write_key_value = escriba "clave": valor
scene-no_number = {$word} no es un número
scene-every_number_finite = todo número de un archivo de {$what} es finito; omita la clave si no se conoce el valor
scene-not_here = {$sign} no corresponde aquí
scene-no_value = {$word} no es un valor
scene-leave_key_out = omita la clave
scene-write_true = escriba true
scene-write_false = escriba false
scene-names_in_quotes = los textos y los nombres van entre comillas dobles
scene-plus_sign = un número no lleva delante el signo más
scene-remove_plus = quite el +
scene-decimal_only = los números son decimales
scene-digits_both_sides = un punto decimal necesita cifras a ambos lados
scene-write_half = escriba 0.5 en lugar de .5, y 5.0 en lugar de 5.
scene-number_incomplete = este número no está completo
scene-no_escape = una \ en un texto empieza una secuencia de escape, y esta no lo es
scene-write_backslash = escriba \\ para el carácter \
scene-text_open = este texto no se cierra nunca
scene-add_quote = añada la " que falta
scene-null = null no es aquí un valor
scene-key_twice = la clave `{$key}` está dos veces: primero en la línea {$line}
scene-number_too_large = {$number} es demasiado grande para calcular con él
scene-choose_units = elija unidades con las que sea menor que 1e100
scene-turns_beside_gears = {$angle} es demasiado grande para un ángulo junto a engranajes: cuentan sus vueltas enteras y se perderían
scene-take_turns_off = escriba un ángulo menor que 1e14 grados

# Values of a wrong kind.

scene-nothing = nada
scene-a_number = el número {$number}
scene-a_text = el texto "{$text}"
scene-empty_list = una lista vacía
scene-list_of = una lista de {$count}
scene-an_object = un objeto {"{"} … {"}"}
scene-unknown_key = clave desconocida: `{$key}`
scene-the_keys_are = las claves son aquí {$all}
scene-unknown_word = palabra desconocida: "{$word}"
scene-write_one_of = escriba una de estas: {$all}
scene-write_truth_or_one_of = escriba true, false o una de estas: {$all}
scene-missing = falta `{$key}`
scene-expected_found = aquí va {$expected}, y hay {$found}
scene-in_double_quotes = escriba "{$number}" entre comillas dobles
scene-add = añada {$json}
scene-add_on = añada "on", el eslabón que lleva la guía, o "ground"
scene-add_length_unit = añada "length": "m", "mm", "cm", "in" o "ft"
scene-add_time_unit = añada "time": "s" o "min"
scene-add_speed = añada "speed", a lo largo de la guía
scene-points_as_one_text = escribir dos puntos como un solo texto: "AB", o "A-B" si los nombres son más largos
scene-without_quotes = escriba {$number} sin comillas
scene-with_a_point = escriba {$number} sin comillas y con punto
scene-or_as_rpm = escriba {$number} sin comillas, o la velocidad como "rpm"
scene-in_degrees = los ángulos van en grados: escriba {$number} sin comillas
scene-rpm_for_omega = escriba "rpm": {$number} en lugar de "omega"
scene-units_in_units = escriba {$number} sin comillas; las unidades van en `units`, los ángulos en grados
scene-two_numbers = aquí van dos números [x, y], y hay una lista de {$count}
scene-negative_size = el tamaño es {$size}; un tamaño no es negativo: en su lugar gire el ángulo 180
scene-no_page = no existe la página "{$name}"
scene-no_unit = no existe la unidad de longitud "{$name}"
scene-did_you_mean = ¿quiso decir `{$name}`?
scene-joints_out_of_scope = los eslabones se unen por articulaciones, correderas rectas (`sliders`), ruedas, cremalleras y correas (`gears`), y perfiles que se tocan, como los de levas (`contacts`)
scene-forces_out_of_scope = las cargas son `mass`, `inertia` y `center` de un eslabón, y `gravity`, `forces`, `springs` y `friction` de la escena; no hay amortiguadores

# What a form asks for.

scene-form_asks_nothing = este formulario no pide nada
scene-form_no_quantity = {$name} no es nombre de ninguna magnitud
scene-form_no_marks = {$marks} no son puntos
scene-form_marks_from_0 = los puntos van de 0 a {$most}
scene-no_hints = {$count} no es un número de etapas de una pista
scene-hints_from_0 = escriba de 0 (sin pistas) a {$most} (todas)
scene-form_names_quantities = escriba los nombres como en un formulario vacío: "omega(2)", "vplan(p,b)"

# Names.

scene-a_point = un punto
scene-a_link = un eslabón
scene-no_name = {$what} no tiene nombre
scene-write_a_name = escriba una letra o un número entre las comillas
scene-name_too_long = el nombre de {$what} tiene más de {$most} caracteres
scene-write_prime = escriba ' para una prima
scene-write_underscore = escriba _ en lugar de -, que une dos puntos
scene-signs_of_names = los nombres tienen letras, cifras, ' y _
scene-sign_in_name = el nombre `{$name}` de {$what} contiene `{$sign}`
scene-called_note = {$what} no puede llamarse `note`: esa clave es para notas
scene-called_ground = un eslabón no puede llamarse `ground`: eso es el bastidor
scene-point_twice = el punto {$point} está dos veces
scene-link_twice = el eslabón {$link} está dos veces
scene-point_twice_in_link = el punto {$point} está dos veces en el eslabón {$link}
scene-link_named = el eslabón {$link}
scene-point_named = el punto {$point}
scene-the_ground = el bastidor
scene-lacks_point = {$carrier} no tiene un punto {$point}; no tiene puntos
scene-lacks_point_but = {$carrier} no tiene un punto {$point}; su único punto es {$only}
scene-lacks_point_of = {$carrier} no tiene un punto {$point}; sus puntos son {$all}
scene-lengths_key = la longitud `{$key}`
scene-along_key = `along` con `{$key}`
scene-pair_unknown = {$key}: {$why}
scene-pair_ambiguous = {$key} puede significar {$a} y {$b}, o {$c} y {$d}
scene-pair_same = {$key} nombra dos veces el punto {$point}
scene-write_pair = escriba "{$a}-{$b}" o "{$c}-{$d}"
scene-no_link = no existe el eslabón {$link}
scene-the_links_are = los eslabones son {$all}
scene-no_point = no existe el punto {$point}
scene-the_points_are = los puntos son {$all}
scene-name_kept = el nombre `{$name}` está reservado para {$what}
scene-other_name = elija otro nombre para el punto
scene-image_of = la imagen de {$point} en los planos
scene-special_point_of = el punto especial del eslabón {$link}
scene-point_under = el punto del eslabón {$link} situado bajo {$point}

# Points, ground, known motions.

scene-no_coordinates = los puntos del bastidor no tienen coordenadas
scene-write_coordinates = escriba {"{"} "A": [x, y], … {"}"}; o dé las coordenadas de todos los puntos en "points": {"{"} … {"}"}
scene-other_coordinates = el punto {$point} tiene otras coordenadas en `points`
scene-name_only = nómbrelo solo en una lista: "ground": ["A", …]
scene-not_in_points = el punto {$point} no tiene coordenadas en `points`
scene-add_to_points = añada "{$point}": [x, y] a `points`
scene-on_no_link = el punto {$point} no está en ningún eslabón ni en el bastidor
scene-name_in_link = nómbrelo en los `points` de un eslabón, o quítelo
scene-known_is_drawn = los movimientos conocidos son propios de una configuración dibujada
scene-points_or_drive = dé las coordenadas de todos los puntos en "points": {"{"} … {"}"}, o accione un eslabón
scene-ground_moves_not = el punto {$point} está en el bastidor, que no se mueve
scene-remove_from_ground = quítelo de aquí o de `ground`
scene-motion_twice = el movimiento del punto {$point} está dado dos veces: por {$first} y por {$second}
scene-motion_already = el movimiento del punto {$point} ya está dado, por {$by}
scene-keep_one = conserve uno de los dos
scene-motion_of_link = el `motion` del eslabón {$link}
scene-drive_of_link = el accionamiento del eslabón {$link}
scene-drive_of_slider = el accionamiento de la corredera {$link}
scene-drive_of_its_slider = el accionamiento de su corredera
scene-drawn_needs_no_near = una configuración dibujada no necesita `near`
scene-remove_it_drawn = quítelo: el dibujo, `points`, ya lo da
scene-remove_drawn = quite `{$key}`: el dibujo, `points`, ya lo da
scene-near_one_number = {$key} es un solo número, en grados, no dos
scene-near_two_numbers = el punto {$point} necesita dos números [x, y], y hay uno

# Links and their drives.

scene-no_links = un mecanismo tiene al menos un eslabón
scene-lengths_and_shape = el eslabón {$link} tiene a la vez `lengths` y `shape`
scene-drive_and_motion = el eslabón {$link} tiene a la vez un accionamiento y un movimiento conocido
scene-two_angles = el eslabón {$link} tiene un ángulo, y su accionamiento también
scene-link_motion_is_drawn = eslabón {$link}: un `motion` conocido es propio de una configuración dibujada
scene-points_or_drive_link = dé las coordenadas de todos los puntos en "points": {"{"} … {"}"}, o accione el eslabón
scene-link_is_drawn = el eslabón {$link} tiene `{$key}`, pero esta escena es una configuración dibujada
scene-remove_or_lengths = quite `{$key}`: el dibujo, `points`, ya lo da; o quite `points` y dé a `ground` sus coordenadas
scene-no_points = el eslabón {$link} no tiene `points`
scene-too_many_points = el eslabón {$link} tiene {$count} puntos, que las longitudes no fijan
scene-give_shape = dé coordenadas en el sistema propio del eslabón: "shape": {"{"} "{$a}": [x, y], "{$b}": [x, y], … {"}"}
scene-no_distance = el eslabón {$link} tiene los puntos {$from} y {$to}, pero no su distancia
scene-three_lengths = el eslabón {$link} tiene tres puntos, que necesitan tres longitudes; falta la de {$from} y {$to}
scene-add_lengths = añada "lengths": {"{"} "{$key}": … {"}"}, o dé un `shape`
scene-add_to_lengths = añada "{$key}": … a sus longitudes
scene-length_twice = la longitud {$key} del eslabón {$link} ya está dada, como {$first}
scene-length_zero = la longitud {$key} es 0: {$from} y {$to} serían un solo punto
scene-one_name_or_length = use un solo nombre para ambos, o dé una longitud positiva
scene-length_negative = la longitud {$key} es {$value}; una longitud es positiva
scene-no_triangle = eslabón {$link}: las longitudes {$lengths} no pueden formar un triángulo: {$one} + {$other} < {$long}
scene-shape_empty = el `shape` del eslabón {$link} no tiene puntos
scene-add_or_without_points = añádalo a `points`, u omita `points`
scene-shape_lacks = el `shape` del eslabón {$link} no dice dónde está {$point}
scene-add_place = añada "{$point}": [x, y]
scene-zero_length = el eslabón {$link} tiene {$first} y {$second} en un mismo lugar: su longitud sería cero
scene-one_name_or_move = use un solo nombre para ambos, o mueva uno
scene-drive_is_drawn = el accionamiento del eslabón {$link} tiene `{$key}`, pero esta escena es una configuración dibujada
scene-omega_and_rpm = el accionamiento del eslabón {$link} tiene a la vez `omega` y `rpm`
scene-drive_without_speed = el accionamiento del eslabón {$link} no tiene velocidad
scene-add_omega = añada "omega" (radianes por unidad de tiempo) o "rpm"; para un eslabón que desliza, "speed"
scene-pushes_and_turns = el accionamiento del eslabón {$link} empuja y gira a la vez
scene-push_or_turn = un accionamiento tiene `position`, `speed`, `acceleration`, o bien `angle`, `omega`, `alpha`
scene-push_without_speed = el accionamiento del eslabón {$link} no tiene `speed`

# Sliders.

scene-slides_on_own = el punto {$point} pertenece a {$carrier}, así que no puede deslizar sobre él
scene-other_sliding_name = use otro nombre para el punto que desliza
scene-no_frame = las coordenadas necesitan un sistema, y {$carrier} no tiene `shape`
scene-point_or_shape = nombre un punto ({$carrier}), o dé al eslabón un `shape`
scene-point_or_without = nombre un punto ({$carrier}), u omita `through`: la guía pasa por el punto de la corredera
scene-no_direction = una dirección de tamaño cero no apunta a ningún lado
scene-give_direction = dé [dx, dy] o grados
scene-no_axis = {$carrier} no tiene puntos, ni por tanto un eje desde el que contar grados
scene-give_drawn_direction = dé la dirección como está dibujada: "along": [dx, dy]
scene-degrees_unquoted = escriba {$number} sin comillas para grados
scene-one_place = {$from} y {$to} están en un mismo lugar, así que no dan ninguna dirección
scene-two_drives = el eslabón {$link} tiene un accionamiento, y su corredera también
scene-which_slider = el eslabón {$link} tiene dos correderas, y su accionamiento no dice cuál empuja
scene-drive_into_sliders = pase el accionamiento a una de las entradas de `sliders`
scene-pushed_without_slider = el accionamiento empuja el eslabón {$link}, pero este no tiene corredera
scene-add_slider = añada a `sliders` una entrada con este `link`, o gire el eslabón con `omega`
scene-idle_link = el eslabón {$link} no tiene puntos, y nada desliza sobre él
scene-remove_or_name = quítelo, o nombre sus puntos
scene-guide_nowhere = nada dice dónde está la guía: {$carrier} no tiene puntos
scene-add_through = añada "through": [x, y], un lugar de la guía
scene-name_on_guide = nombre un punto del eslabón {$link} que esté en la guía
scene-turned_is_drawn = `turned` no tiene lugar en una configuración dibujada
scene-position_is_drawn = este accionamiento tiene `position`, pero esta escena es una configuración dibujada
scene-nothing_slides = esta corredera no dice qué desliza
scene-give_link_or_pin = dé "link" y "at", el eslabón y su punto en la guía; o "pin"
scene-pin_and_link = `pin` va en lugar de `link` y `at`, no junto a ellos
scene-block_or_pin = conserve `link` y `at` para un bloque, `pin` para un simple perno
scene-add_at = añada "at", el punto del eslabón {$link} que está en la guía
scene-add_link_or_pin = añada "link", el eslabón que desliza; o escriba "pin": "{$point}" para un perno en una ranura
scene-slides_on_itself = el eslabón {$link} no puede deslizar sobre sí mismo
scene-travel_is_drawn = una configuración dibujada tiene una sola posición, así que sus guías no tienen extremos
scene-travel_backwards = el recorrido va de {$low} a {$high}
scene-lower_end_first = dé primero la posición menor, como "travel": [20, 80]
scene-travel_has_two_ends = una guía tiene dos extremos, no {$count}

# Pares de engranajes.

scene-two_wheels = un par tiene dos ruedas, no {$count}
scene-meshed_twice = {$first} y {$second} engranan dos veces
scene-remove_one_mesh = quite uno de los dos pares; de dos coronas de un eslabón cada una engrana con otra rueda
scene-no_train = no engrana ninguna rueda: no hay tren para la tabla de Willis
scene-add_gears = omítala o dé `gears`
scene-meshes_with_itself = {$wheel} no puede engranar consigo mismo
scene-wheel_carries_itself = {$wheel} es una rueda de este par y no puede llevarlo
scene-name_the_carrier = `on` nombra el eslabón en cuyos pasadores giran ambas ruedas, o "ground"
scene-wheels_on_one_axis = {$first} y {$second} giran sobre un mismo eje y no pueden engranar
scene-mesh_over_a_wheel = dé un par por cada lugar donde se tocan dientes: sol y planeta, planeta y corona
scene-phase_is_drawn = `phase` no tiene lugar en una configuración dibujada
scene-no_pressure = un ángulo de presión de {$degrees}° no es de dientes
scene-usual_pressure = lo usual es 20; de 0 a {$most}
scene-no_teeth = {$teeth} no es un número de dientes
scene-teeth_up_to = dé un número entero hasta {$most}, negativo para una corona interior; de ruedas sin dientes números enteros en la razón de sus radios
scene-two_rings = dos coronas interiores no pueden engranar
scene-one_ring = una corona engrana con una rueda en su interior, de dientes positivos
scene-ring_of_the_same_size = corona y rueda tienen el mismo número de dientes: serían una
scene-ring_smaller = la corona tiene {$ring} dientes, la rueda en ella {$wheel}
scene-ring_larger = una corona tiene más dientes que la rueda en su interior
scene-wheel_not_on_carrier = {$wheel} no tiene pasador en {$carrier}, que lleva el par
scene-pin_the_wheel = nombre el centro de la rueda en ambos: un punto de la rueda y del portador
scene-two_wheel_pins = {$wheel} y {$carrier} tienen en común {$first} y {$second}, así que son rígidos
scene-one_wheel_pin = una rueda gira sobre un punto de su portador
scene-two_racks = dos cremalleras no pueden engranar
scene-one_rack = una cremallera engrana con una rueda; escriba el número de dientes de la rueda en lugar de un "rack"
scene-rack_without_slider = nada deja deslizar {$rack}, la cremallera, respecto a {$carrier}, que lleva la rueda
scene-rack_not_parallel = {$rack}, la cremallera, y {$carrier}, que lleva la rueda, deslizan sobre el bastidor en dos direcciones
scene-let_rack_slide = dé una corredera con la cremallera sobre el portador, o con el portador sobre la cremallera; o una de cada uno sobre el bastidor, por guías paralelas
scene-teeth_of_pinion = dé un número entero de 1 a {$most}: una rueda sobre una cremallera tiene los dientes por fuera
scene-no_radius = {$radius} no es un radio
scene-give_radius = dé el radio de la circunferencia primitiva, una longitud mayor que 0
scene-give_larger_radius = dé el radio de la circunferencia primitiva, en la unidad de longitud de la escena y no menor que {$least}
scene-radius_without_rack = `radius` es de una rueda sobre una cremallera o con una correa: otras ruedas tienen sus radios por la distancia entre centros
scene-position_without_rack = `position` es de una rueda sobre una cremallera
scene-give_phase = el ángulo de una rueda respecto a otra es `phase`
scene-phase_of_rack = `phase` es de dos ruedas: una cremallera no tiene ángulo
scene-give_position_of_rack = `position` dice dónde está la cremallera cuando la rueda está a 0
scene-belt_on_rack = ninguna correa rodea una cremallera
scene-belt_without_teeth = una correa no tiene ángulo de presión
scene-teeth_of_belt = dé un número entero de 1 a {$most}: dientes de ruedas de cadena, o números enteros en la razón de los radios
scene-no_forces_of_belts = no se sabe cuánto está tensada una correa; por eso no se calculan fuerzas de mecanismos con correas
scene-remove_belts_or_loads = quite de la escena masas, `gravity`, `forces` y `springs`, o sus correas
scene-two_touch = un contacto es entre dos cuerpos, no {$count}
scene-touches_itself = {$body} no puede tocarse a sí mismo
scene-through_without_face = `through` es un lugar de un perfil plano, pero el segundo es redondo
scene-give_face = dé la dirección del perfil plano como `along`, u omita `through`
scene-one_center_of_face = un perfil redondo sobre uno plano tiene un centro de curvatura, no {$count}
scene-face_has_no_center = nombre solo el centro del primer perfil; si ambos son redondos, omita `along`
scene-two_centers = dos perfiles redondos tienen dos centros de curvatura, no {$count}
scene-center_or_face = nombre un punto de cada cuerpo; de un perfil plano dé la dirección como `along`
scene-center_on_body = un centro de curvatura es un punto del cuerpo al que pertenece el perfil, en el orden de `links`
scene-center_of_both = un centro de curvatura es un punto de ambos, {$first} y {$second}: estarían unidos allí
scene-face_without_link = un pasador sobre un perfil plano no necesita eslabón equivalente, así que no hay ninguno que nombrar
scene-flat_roller = un rodillo es redondo, pero `along` dice que el segundo perfil es plano
scene-give_radii = dé los radios de curvatura en el orden de `centers`, como "radii": [40, 10]
scene-radii_as_centers = hacen falta tantos radios como centros: {$wanted}, no {$count}
scene-hollow_on_face = un perfil cóncavo no toca uno plano
scene-turn_face = el radio es positivo; para el otro lado de la cara gire `along` 180
scene-two_hollows = dos perfiles cóncavos no pueden tocarse
scene-hollow_and_round = solo el radio de un perfil cóncavo es negativo, y el otro está dentro de él
scene-give_roller = el segundo radio es el del rodillo
scene-centers_in_one_place = con estos radios ambos centros están en un mismo lugar
scene-hollow_smaller = un perfil redondo de radio {$round} no cabe en uno cóncavo de radio {$hollow}
scene-hollow_larger = el perfil cóncavo tiene el radio mayor, con un menos delante
scene-radii_not_as_drawn = {$first} y {$second} están dibujados a {$distance}, pero los radios dan {$radii}
scene-radii_as_drawn = la suma de los radios es la distancia de los centros; un dibujo no necesita radios
scene-face_not_as_drawn = {$center} está dibujado a {$distance} del perfil plano, pero el radio es {$radius}
scene-face_as_drawn = el radio es la distancia del centro de curvatura al perfil plano; un dibujo no lo necesita
scene-face_on_other_side = {$center} está dibujado en el lado equivocado del perfil plano: el primer cuerpo queda a la derecha de `along`
scene-face_the_other_way = gire `along` 180, o nombre sus puntos en el otro orden
scene-equivalent_taken = el eslabón equivalente se llamaría {$link}, pero hay un eslabón con ese nombre
scene-name_equivalent = dele otro `name`

# Masses and loads.

scene-mass_and_weight = el eslabón {$link} tiene masa y peso
scene-without_mass = el eslabón {$link} tiene `{$key}`, pero no masa
scene-no_unit_of_mass = el eslabón {$link} tiene masa, pero la escena no tiene unidad de masa
scene-add_unit_of_mass = añada `"mass": "kg"` a `units`
scene-weight_without_gravity = el eslabón {$link} tiene peso, pero la escena no tiene gravedad: su masa no se conoce
scene-add_gravity = añada `"gravity": [0, -9810]` (en mm y s), o dé una masa
scene-no_center_of_mass = el eslabón {$link} tiene masa, pero no centro de masa
scene-add_center = añada `"center"`: un punto como "C", coordenadas [x, y] en el sistema del eslabón, o una distancia a lo largo de su eje
scene-below_zero = `{$key}` es {$value}, menor que cero
scene-no_unit_of_force = hay cargas, pero la escena no tiene unidad de fuerza
scene-add_unit_of_force = añada `"force": "N"` a `units`
scene-distance_is_drawn = una distancia a lo largo del eje del eslabón {$link}, pero esta escena es una configuración dibujada
scene-place_as_drawn = dé las coordenadas [x, y] como están dibujadas
scene-neither_force_nor_couple = una carga es una fuerza, un par, o ambos
scene-force_nowhere = una fuerza actúa en un lugar
scene-add_at_of_force = añada `"at"`: un punto como "C", coordenadas [x, y] en el sistema del eslabón, o una distancia a lo largo de su eje
scene-couple_turns = un par es el mismo gire o no
scene-turns_is_drawn = en una configuración dibujada una fuerza es como está dibujada
scene-spring_within_link = ambos extremos del resorte están en un mismo cuerpo: no tira de nada
scene-spring_between_links = nombre dos cuerpos, como [["3", "C"], ["ground", "A"]]
scene-no_point_of_ground = el bastidor no tiene el punto {$point}
scene-distance_on_ground = el bastidor no tiene eje; dé un punto o coordenadas [x, y]
scene-load_name = `{$name}` no puede ser el nombre de una carga: un nombre no está vacío y no tiene ( ) ni coma
scene-load_name_twice = dos cargas tienen el nombre {$name}
scene-other_load_name = elija otro nombre para la carga
scene-over_what = una carga no puede cambiar según {$name}
scene-over_angle_or_position = da el ángulo de un eslabón como "angle(1)", o la posición de una corredera como "position(3/ground)"
scene-over_short = una tabla tiene al menos dos líneas
scene-over_two_lines = da pares de un lugar y un factor, como [[0, 0], [90, 1500], [180, 0]]
scene-over_back = {$after} está después de {$before}
scene-over_in_order = ordena las líneas de la tabla por su primer número
scene-over_more_than_a_turn = una tabla según un ángulo se repite en cada vuelta, y esta es más larga
scene-over_one_turn = da 360° como mucho
scene-spring_ends = un resorte tiene dos extremos, no {$count}
scene-pin_and_guide = el rozamiento está en un pasador o en una guía, no en ambos
scene-friction_nowhere = el rozamiento está en un par cinemático
scene-pin_or_guide = añada `"pin": "B"` para el pasador de un punto, o `"guide": "3/ground"` para la guía de una corredera
scene-friction_without_radius = el rozamiento en el pasador {$point} tiene un momento que crece con el muñón, cuyo radio falta
scene-add_radius = añada `"radius"`, el del muñón, en la unidad de longitud de la escena
scene-guide_has_no_radius = una guía no tiene muñón
scene-guide_has_no_pin = una guía no tiene pasador que pueda estar fijo en un eslabón
scene-friction_twice = {$joint} tiene rozamiento dos veces
scene-coefficient_and_angle = el rozamiento tiene un coeficiente y un ángulo, que dicen lo mismo
scene-no_coefficient = falta cuánto rozamiento hay
scene-angle_of_friction = un ángulo de rozamiento de {$angle}° no es menor que 90°
scene-below_right_angle = son habituales de 3° a 30°, como los de coeficientes de 0.05 a 0.6

# The figure.

scene-scale_is = `{$key}` es {$what}
scene-scale_too_large = {$scale}; los números son como máximo {$most}
scene-scale_not_positive = {$scale}; una escala, en unidades por milímetro de papel, es positiva
scene-next_scale = omítala para tomar la siguiente escala que quepa
scene-no_panels = una figura sin paneles no muestra nada
scene-name_panels = nombre algunos de {$all}, u omita `panels`
scene-panel_twice = este panel está dos veces
scene-step_from_one = los pasos de la construcción se numeran desde 1
scene-steps_listed = `kinegon steps` los enumera; omita `step` para la figura acabada
scene-frame_is_link = ya se llama así el eslabón {$link}
scene-other_frame = dé al bastidor el otro número, o un texto propio en `labels`: {"{"} "ground": "…" {"}"}
scene-ghosts_between = el número de posiciones fantasma va de {$least} a {$most}, y no {$count}
scene-drawn_has_no_path = una configuración dibujada no puede moverse, así que el punto {$point} no tiene trayectoria
scene-drawn_has_no_centrodes = una configuración dibujada no puede moverse, así que el eslabón {$link} no tiene polodias
scene-drawn_has_no_ghosts = una configuración dibujada no puede moverse, así que no hay otras posiciones que dibujar
scene-lengths_and_drive = una escena con `lengths` o `shape` y un accionamiento con su `angle` o `position`
scene-at_contact_alone = los perfiles que se tocan solo se conocen en su contacto, así que no hay otra posición
scene-say_circular = escriba "circular": true en el contacto, si ambos perfiles son círculos alrededor de estos centros, o un círculo y una recta
scene-no_drive_no_path = no hay accionamiento que mueva el mecanismo, así que el punto {$point} no tiene trayectoria
scene-no_drive_no_centrodes = no hay accionamiento que mueva el mecanismo, así que el eslabón {$link} no tiene polodias
scene-no_drive_no_ghosts = no hay accionamiento que mueva el mecanismo, así que no hay otras posiciones que dibujar
scene-give_drive = dé a un eslabón un "drive"
scene-moving_points = los puntos que se mueven son {$all}
scene-ground_has_no_path = el punto {$point} está en el bastidor y no tiene trayectoria
scene-name_of_construction = {$name} es un nombre de la construcción, y no un punto de un eslabón
scene-no_center = "{$name}" no nombra ningún centro instantáneo
scene-name_center = un centro se nombra por dos eslabones, como P(1,3), o P(2,ground) con el bastidor
scene-center_twice = el centro {$name} está dos veces
scene-ground_is_at_rest = el punto {$point} está en el bastidor y no se mueve

# How large a scene may be.

scene-a_scene = una escena
scene-a_figure = una figura
scene-a_figure_with_steps = una figura con pasos
scene-a_drawing_judged = un dibujo que se comprueba
scene-by_hand = una construcción a mano
scene-too_many_links = {$what} tiene como máximo {$most} eslabones, y aquí hay {$count}
scene-too_many_points_in = {$what} tiene como máximo {$most} puntos, y aquí hay {$count}
scene-too_many_loads = {$what} tiene como máximo {$most} fuerzas, pares y resortes, y aquí hay {$count}
scene-divide_mechanism = divida el mecanismo: lo que depende solo de los accionamientos puede ser una escena aparte
scene-replace_loads = sustituya las cargas de un mismo eslabón por su resultante

# What stands after "expected": types say it in English to serde, which hands over nothing but text.

scene-expects_two_numbers = dos números [x, y] o {"{"} "size": …, "angle": … {"}"}
scene-expects_place_on_link = dos números [x, y] o uno solo, la distancia a lo largo del eje
scene-expects_rough_place = dos números [x, y], o para un "angle(…)" uno solo, sus grados
scene-expects_point_or_place = el nombre de un punto entre comillas dobles, o sus coordenadas [x, y]
scene-expects_direction = dos puntos como "BE", o un número de grados, o [dx, dy]
scene-expects_vector = un vector como {"{"} "size": 150, "angle": 210 {"}"}
scene-expects_link = un eslabón como {"{"} "points": ["A", "B"], … {"}"}, o una lista de sus puntos ["A", "B"]
scene-expects_link_place = el nombre de un punto entre comillas dobles, sus coordenadas [x, y], o una distancia a lo largo del eje del eslabón
scene-expects_table_line = dos números, un lugar y un factor, como [90, 1500]
scene-expects_load = una carga como {"{"} "on": "3", "at": "C", "force": [-150, 0] {"}"}
scene-expects_spring = un resorte como {"{"} "between": [["3", "C"], ["ground", "A"]], "rate": 1.5, "length": 120 {"}"}
scene-expects_spring_end = un extremo de un resorte como ["3", "C"], un eslabón y un lugar en él
scene-expects_friction = un rozamiento como {"{"} "pin": "B", "coefficient": 0.1, "radius": 12 {"}"} o {"{"} "guide": "3/ground", "coefficient": 0.1 {"}"}
scene-expects_a_link = un eslabón
scene-expects_ground = los puntos del bastidor como {"{"} "A": [x, y], … {"}"}, o sus nombres como ["A", …]
scene-expects_drive = un accionamiento como {"{"} "angle": 70, "omega": -1 {"}"}
scene-expects_push = un accionamiento como {"{"} "position": 40, "speed": 10 {"}"}
scene-expects_motion = un movimiento como {"{"} "velocity": [x, y], "acceleration": [x, y] {"}"}
scene-expects_link_motion = un movimiento como {"{"} "at": "B", "velocity": [x, y], "omega": 1 {"}"}
scene-expects_slider = una corredera como {"{"} "link": "3", "at": "D", "on": "2", "along": "BE" {"}"}
scene-expects_gear = un par de engranajes como {"{"} "mesh": ["1", "2"], "teeth": [20, 40], "on": "ground" {"}"}
scene-expects_contact = un contacto como {"{"} "links": ["1", "3"], "centers": ["K", "C"], "radii": [40, 10] {"}"}
scene-expects_teeth = un número de dientes, o "rack"
scene-expects_scene = una escena como {"{"} "kinegon": 1, … {"}"}
scene-expects_figure = una figura como {"{"} "panels": ["scheme", "velocity"] {"}"}
scene-expects_centers = "all", o centros como ["P(2,ground)", "P(1,3)"]
scene-expects_units = unidades como {"{"} "length": "mm", "time": "s" {"}"}
scene-expects_truth_or_paper = true, false o "paper"
scene-expects_truth_or_unit = true, false o una unidad de longitud
scene-expects_truth = true o false
scene-expects_whole_number = un número entero de 1 a 65535
scene-expects_number = un número
scene-expects_text = un texto entre comillas dobles
scene-expects_list = una lista [ … ]
scene-expects_object = un objeto {"{"} … {"}"}


## Errors and warnings: mechanism

mechanism-nothing_to_solve = no hay nada que resolver: está dado el movimiento de todos los eslabones
mechanism-add_links = añada eslabones entre los accionados, los puntos conocidos y el bastidor
mechanism-over_no_slider = no hay ninguna corredera {$name} según cuya posición pudiera cambiar una carga
mechanism-over_no_zero = la posición de {$name} no se cuenta desde ningún punto, así que ninguna carga puede cambiar según ella
mechanism-friction_no_slider = no hay ninguna corredera {$name} en cuya guía pudiera haber rozamiento
mechanism-the_sliders_are = las correderas son: {$names}
mechanism-friction_no_joint = en {$point} no se unen eslabones, así que allí nada roza
mechanism-friction_of_contact = {$joint} representa perfiles que se tocan, que rozan donde se tocan y no allí
mechanism-no_friction_of_contact = el rozamiento de los contactos no se conoce: omítalo
mechanism-pin_of_several = el pasador {$point} une varios eslabones, {$links}: su rozamiento depende de en cuál de ellos está fijo
mechanism-write_fixed_in = escriba `"fixed_in": "{$link}"`, u otro de ellos
mechanism-pin_of_two = el pasador {$point} une dos eslabones: su rozamiento es el mismo en cualquiera de los dos que esté fijo
mechanism-leave_fixed_in_out = omita `fixed_in`
mechanism-angle_of_another = el ángulo del eslabón {$link} no puede sustituir al del accionamiento: no cambia con este
mechanism-angle_in_drive = diga en el accionamiento dónde está, o dé el ángulo de un eslabón que gire con él
mechanism-mirror_image = eslabón {$link}: sus longitudes valen para un triángulo y para su imagen especular; se toma el antihorario {$points}. Para elegir, dé lugares aproximados de sus puntos en `near`
mechanism-singular = los eslabones {$links} no tienen un movimiento definido en ninguna posición: un grupo de clase {$class} con los pares prismáticos como en {$pattern} es singular por su estructura
mechanism-make_revolute = convierta uno de los pares prismáticos en rotatorio
mechanism-train_without_ratio = los dientes no dan los ángulos de los eslabones {$links}: las ruedas giran igual haga lo que haga el brazo, así que nada lo mueve
mechanism-other_teeth = dé otros números de dientes, de modo que la relación básica del tren no sea 1, o accione el brazo
mechanism-two_radii = la rueda {$link} de {$teeth} dientes tendría dos radios primitivos, {$first} y {$second}: revise dientes y distancias entre centros
mechanism-belt_without_room = las ruedas {$first} y {$second}, con radios {$radii}, están a una distancia de {$distance}: así no puede rodearlas una correa; revise el radio y la distancia
mechanism-along_its_x_axis = corredera {$link}: a lo largo de la guía va el eje x de su forma, y no sus puntos {$points}, que en las formas tienen la dirección de la guía: si ambas formas son lugares de un mismo dibujo, añadir "turned": {$turned}
mechanism-off_guide = la corredera {$slider} no está en su guía: está en {$position}, y la guía va de {$low} a {$high}; lo que de ello se sigue no vale aquí
mechanism-holds_here_alone = el contacto de {$first} y {$second} solo se conoce en esta posición: su mecanismo equivalente da aquí velocidades, aceleraciones y fuerzas, y nada en otra parte

# Too few or too many constraints.

mechanism-one_link = eslabón {$link}
mechanism-several_links = eslabones {$links}
mechanism-one_free_motion = 1 movimiento libre
mechanism-free_motions = {$count} movimientos libres
mechanism-can_still_move = {$links}: aún sin determinar (quedan: {$free})
mechanism-add_a_drive = añada ahí 1 accionamiento o un par
mechanism-add_drives = añada ahí {$count} accionamientos o un par
mechanism-one_constraint = 1 restricción
mechanism-constraints = {$count} restricciones
mechanism-cannot_move = {$links}: sin movimiento posible con ese accionamiento (sobran: {$surplus})
mechanism-take_away = quite de ahí un accionamiento o un par
mechanism-one_drive = 1 accionamiento
mechanism-drives = {$count} accionamientos
mechanism-mobility = movilidad 3·{$links} − {$constraints} = {$mobility} con {$drives}

# Drives.

mechanism-one_ground_point = el eslabón {$link} está accionado, así que debe tener un punto en el bastidor; tiene {$count}
mechanism-list_pivot = ponga el punto alrededor del cual gira en `ground` y entre los puntos del eslabón
mechanism-driven_link = el eslabón {$link}
mechanism-driven_slider = la corredera {$slider}
mechanism-two_angles = los eslabones {$first} y {$second} dan ambos un ángulo; solo el de un eslabón puede sustituir al de un accionamiento
mechanism-remove_one = quite uno de los dos; los ángulos aproximados van en `near`
mechanism-angle_without_drive = el eslabón {$link} da un ángulo, pero ningún eslabón tiene accionamiento
mechanism-add_drive = añada un accionamiento con `omega` al eslabón que gira alrededor de un punto del bastidor
mechanism-angle_beside = el eslabón {$link} da un ángulo, pero ya da `{$key}` el accionamiento que mueve {$driven}
mechanism-keep_one = conserve uno de los dos; un ángulo aproximado va en `near`
mechanism-angle_beside_all = el eslabón {$link} da un ángulo, pero todos los accionamientos dicen ya dónde están
mechanism-two_open_drives = los accionamientos que mueven {$first} y {$second} no dicen dónde están; el ángulo del eslabón {$link} solo sustituye a uno
mechanism-add_to_one = añada "{$key}" a uno de ellos
mechanism-open_drive = el accionamiento que mueve {$driven} no da `{$key}`
mechanism-add_angle = añada "angle": grados desde +x hasta el eje del eslabón; o dé en su lugar el `angle` de otro eslabón
mechanism-add_position = añada "position": su distancia a lo largo de la guía desde `through`; o dé en su lugar el `angle` de un eslabón

# Angles that look like radians.

mechanism-angle_of_link = el ángulo del eslabón {$link}
mechanism-guide_of = la guía de {$slider}
mechanism-near_angle_of = `near` para angle({$link})
mechanism-radians = {$what} se toma como {$angle}°, que parece estar en radianes: los ángulos van en grados, así que {$degrees} si es lo que se quiere

# Places far away.

mechanism-far_origin = el origen está a {$far} de un mecanismo de unos {$size}: de los lugares con 16 cifras, quedan {$digits} para su forma. Ponga el origen cerca


## Errors and warnings: position

position-no_mode = los eslabones {$links} no se pueden montar{$at}: {$miss}
position-other_angle_or_lengths = otro ángulo del accionamiento, u otras longitudes
position-angle_from_to = de {$from}° a {$to}°
position-angle_within_or_lengths = un ángulo del accionamiento {$ranges}, donde se puede ensamblar, u otras longitudes
position-at_value = {" "}con {$quantity} = {$value}
position-longer = con todo lo demás cerrado, {$leg} tendría que ser {$by} más larga
position-shorter = con todo lo demás cerrado, {$leg} tendría que ser {$by} más corta
position-any_direction = sus pares exteriores están en un mismo lugar y sus longitudes son iguales, así que puede girar ahí cualquier ángulo
position-never_meet = sus guías y longitudes no se encuentran nunca
position-parallel_guides = los eslabones {$links} no se pueden montar: las dos guías que coinciden en el eslabón {$link} son paralelas
position-turn_one = `turned` de una de sus correderas, los grados desde la guía hasta el eje del eslabón, las pone en ángulo
position-too_large = longitudes de unas {$size} son demasiado grandes para montar con ellas: sus cuartas potencias salen del intervalo de los números
position-too_small = longitudes de unas {$size} son demasiado pequeñas para montar con ellas: sus cuartas potencias salen del intervalo de los números
position-other_unit = otra unidad de longitud
position-no_such_mode = no existe el modo de montaje {$mode}: hay {$count}
position-modes_listed = `kinegon modes` los enumera
position-too_many_modes = el modo de montaje {$mode} está demasiado lejos: se dejó de contar tras {$count}
position-rough_places_choose = lugares aproximados en `near`, que eligen sin contar
position-too_much_work = no se encontró ninguna manera de montar todos los eslabones: los primeros se pueden unir de demasiadas maneras
position-rough_places = lugares aproximados de sus puntos en `near`
position-not_found = no se encontró ninguna manera de montar los eslabones {$links}{$at}: {$tried}
position-rough_places_or_other = lugares aproximados de sus puntos en `near`, otro ángulo del accionamiento, u otras longitudes
position-moves = los eslabones {$links} pueden moverse con los accionamientos parados, aunque su movilidad es 0: ninguno de los montajes hallados es un modo de montaje
position-none_closes = ninguno de los {$starts} comienzos cierra
position-none_closes_but = ninguno de los {$starts} comienzos cierra; el más próximo deja un hueco de {$gap} del tamaño del mecanismo

# Warnings.

position-unproven = `near` deja abiertos demasiados montajes para compararlos todos, y puede que el tomado no sea el más próximo: dé en él lugares aproximados de más puntos
position-at_least = al menos {$count}
position-far_off = `near` está a {$distance} (media cuadrática) del más próximo de los modos de montaje (en total {$count}), más de la mitad del tamaño del mecanismo, {$size}: compruebe sus coordenadas
position-point_far_off = el punto {$point} está en [{$x}, {$y}], a {$off} de su lugar en `near`, en el más próximo de los modos de montaje (en total {$count}): compruebe sus coordenadas
position-not_chosen = los eslabones {$links} se pueden montar de {$count} maneras y no se da `near`, así que se toma el modo 1: {$listed}
position-searched = los eslabones {$links} forman un grupo de clase superior: sus modos de montaje se hallaron por búsqueda, y puede haber más; no se sabe cuántos puede haber
position-searched_of = los eslabones {$links} forman un grupo de clase superior: {$found} de sus modos de montaje se hallaron por búsqueda, y puede haber más, pero {$most} como máximo
position-may_move = los eslabones {$links} pueden moverse con los accionamientos parados, aunque su movilidad es 0: además de los modos de montaje hay toda una curva de posiciones
position-nearly_flat = eslabón {$link}: sus puntos están casi en línea recta, y `near` vale casi igual para su triángulo y para la imagen especular; se toma el más próximo. Para elegir, dé su `shape`, o lugares en `near` con más cifras


## Errors and warnings: motion

motion-singular = los eslabones {$links} están en una posición singular: {$reason} (condición {$condition})
motion-singular_exactly = los eslabones {$links} están en una posición singular: {$reason} (exactamente)
motion-at_limit = posición límite en {$place}: los eslabones {$links} no pueden ir más allá; sus velocidades y aceleraciones crecen sin cota: {$reason}
motion-at_change = punto de cambio en {$place}: los eslabones {$links} podrían seguir también en otro modo, así que sus velocidades no están determinadas: {$reason}
motion-move_a_joint = otro ángulo de la manivela, o saque una de estas articulaciones de la recta o del punto común
motion-overflow = eslabones {$links}: una distancia, una velocidad o una aceleración es demasiado grande para representarla
motion-larger_units = unidades de longitud mayores, o accionamientos más lentos
motion-near_singular = los eslabones {$links} están cerca de una posición singular (condición {$condition}): con coordenadas de 16 cifras quedan determinadas unas {$digits} cifras de sus velocidades
motion-near_limit = los eslabones {$links} están en una posición límite o junto a una (condición {$condition}): con longitudes y ángulos de 16 cifras quedan determinadas unas {$digits} cifras de sus velocidades

# Why a position is singular.

motion-no_definite_motion = sus lazos no tienen un movimiento definido
motion-in_one_line = {$first} y {$second} están en una misma recta
motion-parallel = las rectas {$lines} son paralelas
motion-in_one_point = las rectas {$lines} se cortan en un mismo punto
motion-normal_to_guide = por {$through} normal a la guía en {$at}
motion-at_infinity = en el infinito (guías en {$first} y {$second})


## Errors and warnings: accuracy

accuracy-unproved = eslabones {$links}: de su posición o de su movimiento no se demuestra nada, así que sus números no llevan error
accuracy-pulls = los perfiles del contacto {$contact} tendrían que tirar uno del otro aquí: se separan, si nada los mantiene unidos
accuracy-unbounded = {$names}: no se puede dar ninguna cota del error, pues aquello de lo que se leen puede ser cero, o unas rectas paralelas
accuracy-at_limit = posición límite en {$place}: los eslabones {$links} no pueden ir más allá; sus velocidades y aceleraciones crecen sin cota, así que sus números no llevan error
accuracy-at_change = punto de cambio en {$place}: los eslabones {$links} podrían seguir también en otro modo, así que sus velocidades no están determinadas y sus números no llevan error


## Errors and warnings: quantity

quantity-no_quantity = `{$name}` no es una magnitud; formas conocidas: omega(2) alpha(2) omega(2/1) alpha(2/1) i(3,1) rpm(2) angle(2) x(D) y(D) v(D) a(D) v(D/G) a(D/G) a_n(D/G) a_t(D/G) a_c(3/2) position(3/2) v_r(3/2) a_r(3/2) L(B,S3) vplan(b,s3) aplan(n_b3,s3) P(1,3) W(2) G(2) d_i(2) rho(D) R(B,2) R_n(B,2) R_t(B,2) N(3/2) M(3/2) h(3/2) T(1) F(3/2) F_i(2) M_i(2) a_cm(2) moment(F1,S3) power(F1) shaking shaking(A); los vectores también con .x .y .size .angle, los segmentos de los planos con /mu
quantity-no_link = `{$quantity}`: no existe aquí el eslabón `{$name}`
quantity-no_slider = `{$quantity}`: no existe aquí la corredera `{$name}`
quantity-no_point = `{$quantity}`: no existe aquí el punto `{$name}`
quantity-no_load = `{$quantity}`: aquí no hay ninguna carga `{$name}`
quantity-no_plan_point = `{$quantity}`: no existe aquí el punto `{$name}` del plano
quantity-did_you_mean = {$message}; ¿quiso decir `{$name}`?
quantity-no_value = `{$quantity}` no tiene valor aquí: {$why}
quantity-on_paper = una longitud en el papel es propia de la figura de una posición
quantity-without_mu = el nombre sin `/mu`
quantity-no_accelerations = no se pidieron aceleraciones
quantity-no_axis = el eslabón no tiene eje
quantity-no_zero = la guía no tiene un punto desde el que contar
quantity-no_plan_no_scale = la figura no tiene ese plano y, por tanto, tampoco escala
quantity-scale_too_small = la escala es demasiado pequeña para ello
quantity-no_construction = no hay construcción
quantity-at_infinity = el punto especial está en el infinito
quantity-not_on_one_link = los dos puntos no están en un mismo eslabón
quantity-no_plan = no existe ese plano
quantity-no_force_plan = no hay plano de fuerzas: la figura necesita el panel "forces"
quantity-two_polygons = sus extremos son vértices de dos polígonos, que están uno junto a otro sin más
quantity-routes_differ = los polígonos y las ecuaciones de equilibrio difieren en más de lo que ambos permiten
quantity-no_way = entre estos vértices no hay fuerzas con nombre propio; pida la fuerza misma, como R(B,2) o R_n(B,2)
quantity-centre_at_infinity = el centro está en el infinito y solo tiene dirección: `.angle`
quantity-centre_at_place = el centro está en un lugar: `.x`, `.y`
quantity-rest_on_another = los eslabones están en reposo uno respecto del otro
quantity-link_turns_not = el eslabón no gira
quantity-ratio_to_rest = `{$link}` no gira, así que no hay relación con él
quantity-path_is_straight = la trayectoria es recta ahí, o el punto está en reposo
quantity-place_has_no_size = `{$name}` es un lugar y no tiene módulo; pida su `.x` o su `.y`
quantity-no_loads = la escena no tiene masas, fuerzas ni resortes
quantity-no_mass = ese eslabón no tiene masa
quantity-no_inertia = la inercia no se tiene en cuenta: `"analysis": "static"`
quantity-no_line_of_joints = ese eslabón no tiene allí dos pares cuya línea se pudiera entender
quantity-no_normal_force = no hay fuerza transversal a la guía
quantity-no_line_of_action = la fuerza no tiene aquí línea de acción, o ninguna a distancia finita
quantity-not_driven = no está accionado
quantity-not_at_pin = ese eslabón no tiene articulación en ese perno
quantity-no_forces = sus cargas salen del rango de los números, la posición es singular o el rozamiento lo bloquea
quantity-nowhere_in_range = no lo tiene en ninguna posición del intervalo
quantity-no_scale_in_table = una tabla no tiene escala


## Errors and warnings: forces

forces-spring_without_direction = los extremos del resorte {$spring} coinciden en esta posición, de modo que su fuerza no tiene dirección: no se muestran fuerzas
forces-friction_locks = el rozamiento bloquea el mecanismo en esta posición: ningún accionamiento lo mueve en este sentido, así que no se muestran fuerzas
forces-friction_at_rest = en reposo el rozamiento puede ser cualquiera hasta su límite: en {$joints} cuenta como nulo, y los errores indicados lo admiten entero
forces-friction_leaves_open = en reposo el rozamiento puede ser cualquiera hasta su límite, y el de {$joints} deja abierto lo que llevan los pares: no se muestran fuerzas


## Errors and warnings: cycle

cycle-drawn = una configuración dibujada no puede moverse: no tiene longitudes
cycle-lengths_and_drive = una escena con `lengths` o `shape` y un accionamiento con su `angle` o `position`
cycle-at_contact = los perfiles que se tocan solo se conocen en su contacto, así que el mecanismo no puede moverse
cycle-say_circular = "circular": true en el contacto, si ambos perfiles son círculos alrededor de estos centros, o un círculo y una recta
cycle-off_guide = la corredera {$slider} no está en su guía aquí, así que nada la mueve
cycle-on_guide = empiece donde esté dentro de su `travel`
cycle-other_kind = el mecanismo {$number} no es del tipo del mecanismo 0
cycle-same_kind = los mismos eslabones, pares y accionamientos en el mismo orden; solo pueden diferir longitudes, lugares y accionamientos
cycle-no_drive = no hay ningún accionamiento que mover
cycle-give_drive = dé a un eslabón un "drive"
cycle-no_such_drive = no existe el accionamiento `{$name}`; los accionamientos son: {$known}
cycle-singular = los eslabones {$links} están en una posición singular con {$at}, así que no está decidido por dónde siguen
cycle-at_limit = posición límite en {$place}: los eslabones {$links} no pueden ir más allá; sus velocidades y aceleraciones crecen sin cota; por cuál de dos caminos vuelven no está decidido
cycle-at_change = punto de cambio en {$place}: los eslabones {$links} podrían seguir también en otro modo; por cuál siguen no está decidido
cycle-other_position = una escena en otra posición del accionamiento; el recorrido encuentra el camino desde ahí
cycle-out_of_reach = no se puede alcanzar el intervalo de {$from} a {$to}: {$stop}
cycle-within_reach = un intervalo que contenga una parte de {$low} a {$high}
cycle-no_vector = `{$name}` no es un vector
cycle-vectors = v(D), v(D/G), a(D), a_n(D/G), a_t(D/G), a_c(3/2) con nombres de esta escena
cycle-no_path = `{$name}` no es un punto de un eslabón que se mueva, así que no tiene trayectoria
cycle-not_finite = los extremos del intervalo deben ser números finitos
cycle-too_many_turns = el intervalo llega más allá de cien vueltas
cycle-too_far = el intervalo llega más allá de cien veces el tamaño del mecanismo
cycle-values_between = valores entre {$low} y {$high}
cycle-no_range = no está dado el intervalo de {$quantity}
cycle-both_ends = tanto --from como --to: esta corredera no da una vuelta completa ni tiene dos extremos
cycle-no_step = el paso no puede ser {$step}
cycle-distance_of_rows = la distancia de una fila a la siguiente, como 1
cycle-step_leads_away = un paso de {$step} se aleja del final del intervalo
cycle-positive_step = un paso positivo; su signo se sigue del intervalo
cycle-too_many_steps = hay más de {$most} pasos de {$step} de {$from} a {$to}
cycle-larger_step = un paso mayor
cycle-no_room = de {$from} a {$to} no hay espacio para una curva
cycle-table_too_long = la tabla tendría {$rows} filas de {$columns} números
cycle-sweep_or_fewer = escríbala con `kinegon sweep`, o nombre menos magnitudes en el `want` de la escena
cycle-more_room = un intervalo con más espacio entre --from y --to


## Errors and warnings: editing

editing-no_object = una escena es un objeto {"{"} … {"}"}
editing-no_entry = esta lista tiene {$count} entradas, y no existe la {$key}
editing-no_room = no hay aquí lugar para {$key}
editing-not_all = una escena no se puede quitar de su texto
editing-point_twice = el punto {$point} está dos veces en el nuevo eslabón
editing-no_points = un nuevo eslabón no tiene puntos
editing-name_one = nombre al menos uno
editing-point_on_link = el eslabón {$link} ya tiene un punto {$point}
editing-link_unknown = no se sabe dónde está el eslabón {$link} en la posición presente
editing-point_unknown = no se sabe dónde está el punto {$point} en la posición presente
editing-rough_places = dé lugares aproximados en `near`
editing-slides_on_own = el punto {$point} pertenece a {$on}, así que no puede deslizar sobre él
editing-other_point = elija otro punto, u otro portador de la guía
editing-in_one_place = el eslabón {$link} tendría {$first} y {$second} en un mismo lugar
editing-one_name_or_move = use un solo nombre para ambos, o mueva uno
editing-no_place = esto no es un lugar
editing-drawn = una configuración dibujada no puede moverse
editing-give_lengths = dé el mecanismo por longitudes, con un accionamiento
editing-no_position = la posición no se puede escribir con valores de los accionamientos
editing-other_position = tome otra posición
editing-near_cannot_choose = los lugares aproximados no pueden elegir el modo {$mode}
editing-point_there = ya existe un punto {$name}
editing-link_there = ya existe un eslabón {$name}
editing-other_name = elija otro nombre
editing-no_point = no existe el punto {$name}
editing-no_link = no existe el eslabón {$name}
editing-table_no_number = línea {$line}, columna {$column}: no hay un número
editing-table_one_column = no hay segunda columna
editing-table_line = escriba un lugar y un factor en cada línea, como `90,1500`
editing-table_first = escriba números solos, un lugar y un factor, como `90,1500`; una primera línea que nombra las columnas no tiene números
editing-table_more_cells = la línea {$line} tiene {$cells} celdas, y la primera línea {$first}
editing-table_marks = separe las celdas con punto y coma si los números tienen coma decimal
editing-table_unnamed = hay más de dos columnas, y la primera línea no las nombra
editing-table_head = nombre las columnas en la primera línea, las de cargas como la escena las nombra
editing-table_no_column = no hay columna para `{$load}`
editing-table_nameless = no hay columna para esta carga, que no tiene nombre
editing-table_name = nombre una columna en la primera línea como la escena nombra la carga
editing-table_long = hay más de {$most} líneas
editing-table_shorten = omita las líneas que una recta da igual de bien

# Why a joint that is pulled does not follow the hand.

editing-held_point = {$point} está fijado
editing-held_length = {$point} se mueve en una circunferencia: {$length} está fijada
editing-held_angle = {$point} se mueve en una recta: el ángulo del eslabón {$link} está fijado
editing-held_guide = {$point} se mueve en una recta: la guía de {$slider}
editing-held_rack = {$point} se mueve a través de su guía: a lo largo de ella la cremallera va con su rueda
editing-held_nowhere = la articulación no puede ir ahí
editing-held_rounded = con la articulación ahí, las longitudes redondeadas no dejan a las demás articulaciones un lugar cerca del suyo
editing-held_try = arrastre la articulación a otro lugar


## Errors and warnings: drawing

drawing-scheme = el esquema
drawing-velocity_plan = el plano de velocidades
drawing-acceleration_plan = el plano de aceleraciones
drawing-centers = la figura de centros instantáneos
drawing-force_plan = plano de fuerzas
drawing-lever = palanca
drawing-speeds = diagrama de Kutzbach
drawing-overflow = {$panel} no cabe en su panel con {$key} = {$given} y queda recortado; cabe con {$fitting}, o en una hoja mayor
drawing-no_scale = ninguna
drawing-cost_of_list = las escalas dejan espacio para la lista de resultados: {$scales}
drawing-cost_of_names = las escalas dejan espacio para la lista de nombres: {$scales}
drawing-in_place_of = {$scale} = {$now} en lugar de {$before}
drawing-too_many_panels = {$wanted} tipos de magnitudes necesitan {$wanted} paneles, y la hoja tiene espacio para {$room}
drawing-fewer_or_page = menos magnitudes a la vez, u otra `page` en la figura de la escena, como "a4-portrait"
drawing-too_many_curves = {$wanted} curvas en un panel son más de las que se pueden distinguir, que son {$most}
drawing-fewer_quantities = menos magnitudes a la vez
drawing-no_film_of = una vuelta de una película no puede durar {$seconds} segundos
drawing-at_most_seconds = más de 0 y como máximo {$most} segundos
drawing-no_film_at = una película no puede tener {$count} imágenes por segundo
drawing-pictures_a_second = de 1 a {$most} imágenes por segundo
drawing-no_motion = {$seconds} segundos a {$count} imágenes por segundo no muestran movimiento
drawing-longer_or_more = más tiempo, o más imágenes por segundo
drawing-film_too_long = la película tendría {$count} imágenes; puede tener {$most}
drawing-film_of_turns_too_long = la película tendría {$count} imágenes en {$turns} vueltas del accionamiento; puede tener {$most}
drawing-less_or_fewer = menos tiempo por vuelta, o menos imágenes por segundo
drawing-no_sheet = no existe la hoja {$number}; hay {$count}
drawing-no_step = no existe el paso {$step}; hay pasos de 1 a {$count}
drawing-drive_stands = el accionamiento `{$drive}` no puede moverse


## Errors and warnings: check

check-two_values = `{$name}` tiene aquí dos valores: {$one} y {$two}
check-keep_one = conserve el que quiera decir
check-form_empty = el formulario está vacío: no tiene valores que comprobar
check-write_values = escriba sus valores junto a los nombres; `kinegon check SCENE --template` escribe el formulario
check-points_without_scale = los lugares de los puntos están en milímetros de papel, pero falta su escala {$scale}
check-add_scale_of = añada {$scale}, la escala de su {$sheet}
check-no_pole = los lugares del {$sheet} no tienen su polo {$pole}
check-no_origin = {$sheet}: falta el lugar de {$point}, desde el que se miden los demás
check-add_pole = añada "{$pole}": [x, y]
check-no_length_on_paper = `{$name}` no es una longitud en el papel, así que no puede llevar `/mu`
check-write_in = escríbalo en {$unit}
check-no_sheet = a la figura de la escena le falta su {$sheet} y, por tanto, la escala
check-add_scale_or_panel = añada {$scale} a los valores, o el panel a la figura de la escena
check-no_number = `{$text}` no es un número
check-write_digits = escriba cifras con punto decimal, como 61.5; deje en blanco lo que no haya medido
check-too_large = `{$text}` es demasiado grande
check-wrong_digit = ¿está mal una cifra o un exponente?
check-paper_without_scale = `{$name}` está en milímetros de papel, pero falta su escala {$scale}
check-add_scale = añada {$scale}: cuántas {$unit} es 1 mm de su {$sheet}
check-unit_on_paper = `{$name}` está en milímetros de papel, pero al lado dice `{$unit}`
check-unit_or_mu = omita la unidad, o el `/mu`
check-no_unit_of = `{$text}` no es una unidad de {$kind}
check-write_unit = escriba `{$unit}`, u omita la unidad
check-did_you_mean = ¿quiso decir `{$name}`?
check-template_lists = `kinegon check SCENE --template` enumera los nombres
check-nearest_name = el nombre más parecido es `{$name}`; `kinegon check SCENE --template` enumera los nombres
check-no_quantity = `{$name}` no es una magnitud de esta escena
check-no_box = ningún paso halla `{$name}`, así que un formulario no tiene casilla para ello
check-pi_lost = se perdió la letra π en `{$name}`
check-save_as_utf8 = guarde como CSV UTF-8, o escriba pi
check-too_many = un formulario tiene como máximo {$most} valores, y aquí hay {$count}
check-is_this_a_form = ¿es esto un formulario? `kinegon check` sin formulario imprime uno vacío
check-no_scale = {$scale} no es una escala
check-scale_is_positive = una escala es un número positivo: unidades de la escena por milímetro de papel
check-not_understood = no se entienden {$count} cosas de este formulario:{$all}
check-line = línea {$number}

# Kinds of quantities, and sheets.

check-angle = ángulo
check-angular_velocity = velocidad angular
check-rotational_speed = una velocidad de giro
check-speed_ratio = una relación de velocidades angulares
check-angular_acceleration = aceleración angular
check-position = posición
check-length = longitud
check-velocity = velocidad
check-acceleration = aceleración
check-force = una fuerza
check-moment = un momento
check-power = una potencia

# Tables.

check-open_quotation = aquí se abren comillas que no se cierran en esta línea: las líneas siguientes se perderían
check-close_quotation = ciérrelas, o quítelas
check-no_table = esto no es una tabla: {$error}
check-write_lines = escriba una línea `quantity,value` por valor; los nombres con coma van entre comillas dobles
check-value_without_name = `{$text}` está aquí sin el nombre de una magnitud
check-value_in_unit = `{$text}` está en el lugar de la unidad, sin ningún valor delante
check-no_sense = `{$text}` no es un sentido de giro
check-write_sense = escriba `clockwise` o `counter-clockwise`
check-values_in = no se entienden valores en `{$unit}`
check-not_upright = `{$text}` no dice si las hojas están derechas
check-no_count = `{$text}` no es un número de pistas
check-whole_number = escriba un número entero desde 0, o quite la línea
check-true_or_false = escriba `true` si están como se imprimieron, si no `false`
check-mm_or_units = escriba `mm` para milímetros de papel, o `units` para las unidades de la escena
check-no_coordinate = `{$text}` no es una coordenada
check-write_coordinates = escriba x e y en milímetros de papel, como velocity:b,114,-2.7
check-no_radius = `{$text}` no es un radio
check-write_radius = detrás de x e y puede estar a qué distancia de ahí puede hallarse el punto, en milímetros de papel, como velocity:b,114,-2.7,0.2
check-scale_no_number = {$scale} es `{$text}`, que no es un número
check-write_scale = escriba unidades de la escena por milímetro de papel, como 2 o 0.5

# Marks.

check-no_part = {$number} no es una parte de los puntos
check-part_from_0 = escriba un número de 0 (ningún punto) a 1 (todos los puntos de la magnitud)
check-no_marks = {$number} no es un número de puntos
check-marks_from_0 = escriba un número de 0 a {$most}
check-marks_twice = `{$name}` es la misma magnitud y ya tiene sus puntos
check-no_marks_at_all = el baremo no da puntos por nada
check-add_each = añada "each": 1, o puntos para las magnitudes que cuentan

# Refusals of pages.

check-tolerance = la tolerancia de un lápiz va de 0 a {$most}
check-no_photograph = no hay ninguna fotografía


## Errors and warnings: exercise

exercise-no_construction = sus planos no tienen una construcción que dibujar a mano: un punto especial está en el infinito, o un grupo es de clase superior a la IV
exercise-nothing_to_find = en la figura de los centros instantáneos no hay nada que hallar: los centros que muestra están en articulaciones y guías; indique otros en `figure.centers`, o puntos en `figure.velocities`
exercise-gave_up = ninguna de {$tries} variantes se puede dibujar bien a mano; con más frecuencia ({$percent} %) porque {$most}
exercise-numbers = los números no son compatibles
exercise-assembly = los eslabones no se alcanzan
exercise-singular = la posición está demasiado cerca de una singular
exercise-no_plans = no hay construcción de los planos
exercise-routes = la construcción no es bastante exacta
exercise-crossing = hay rectas que se cortan con menos de 20°
exercise-sheet = un punto especial o un plano no cabe en la hoja
exercise-short = un segmento es demasiado corto: uno que medir de menos de 5 mm, o uno que trazar de menos de 4 mm
exercise-unsure = una velocidad o aceleración no se puede hallar a mano con un 15 %
exercise-center_far = un centro instantáneo queda demasiado lejos para la hoja
exercise-centers_close = dos centros instantáneos distan menos de 6 mm
exercise-center_distance = una distancia de la que se obtiene una velocidad mide menos de 15 mm
exercise-center_unsure = un centro instantáneo no se puede hallar a mano con 2 mm
exercise-forces_cross = las direcciones de fuerzas se cortan con menos de 15°
exercise-force_short = una fuerza mide menos de 8 mm
exercise-arm_short = un brazo mide menos de 10 mm
exercise-forces_unequal = una fuerza es menos de la cuadragésima parte de otra
exercise-forces_unequal_as = una fuerza es menos de la cuadragésima parte de otra, como {$small} de {$large} en la escena tal como está: quite lo que es tan pequeño (la gravedad, una masa, la inercia con "analysis": "static") o haga las cargas más parecidas
exercise-force_unsure = una fuerza o un momento no se puede hallar al 8 % a mano
exercise-evened = algunas fuerzas de la escena son demasiado pequeñas junto a otras para dibujarse con ellas; los ejercicios tienen otras cargas: {$changes}
exercise-same = sus números ya salieron antes
exercise-numbered = los ejercicios se numeran de 1 a {$most}
exercise-no_such = no existe ese ejercicio
exercise-whole_seed = una semilla es un número entero


## Errors and warnings: photo

photo-no_sheet = en la imagen no se encuentra ninguna hoja con marcas
photo-one_marker = en la imagen solo se encuentra una de las ocho marcas de la hoja
photo-few_markers = en la imagen solo se encuentran juntas {$count} de las ocho marcas de la hoja
photo-whole_sheet = haga la foto desde arriba, con toda la hoja y sus ocho cuadrados negros, nítida y sin una mano encima; las hojas impresas sin marcas no se pueden leer
photo-cut_off = la imagen acaba antes que la hoja: algunos de sus ocho cuadrados negros quedan fuera
photo-step_back = haga la foto desde más lejos, con los ocho cuadrados negros dentro
photo-mirrored = la imagen está reflejada como en un espejo
photo-unmirror = hágala con la cámara trasera del teléfono, o desactive el efecto espejo
photo-not_even = la hoja no está plana: sus marcas están a {$mm} mm de donde estarían en una hoja plana
photo-bent = la hoja está curvada: su centro está {$mm} mm por encima o por debajo de sus bordes
photo-flatten = apriete la hoja, bajo un cristal o con pesos en sus bordes, y repita la foto
photo-blurred = la foto está borrosa: los bordes sobre la hoja tienen {$mm} mm de ancho
photo-nearer = acérquese, que la hoja llene la foto, con más luz y la cámara quieta
photo-no_code = no se puede leer el código pequeño de la esquina inferior derecha de la hoja
photo-light_on_code = haga la foto más cerca y más nítida, con luz en el código; nada puede estar dibujado encima; las imágenes enviadas por chat suelen ser demasiado pequeñas
photo-other_page = el código pequeño es de otro formato que las marcas: la imagen muestra partes de dos hojas, o una hoja cortada
photo-one_whole_sheet = fotografíe una hoja entera, como se imprimió
photo-cut_short = está cortado: el archivo acaba en medio de la imagen
photo-send_again = copie o envíe la fotografía otra vez
photo-second_sheet = la imagen muestra también partes de otra hoja, que no se lee
photo-each_by_itself = fotografíe cada hoja por separado
photo-nothing_drawn = en la imagen no se encuentran líneas de lápiz de los planos
photo-nothing_in_blur = no se encuentran líneas de lápiz de los planos: la foto está borrosa, los bordes sobre la hoja tienen {$mm} mm de ancho
photo-mark_by_hand = haga una foto más nítida, o marque los puntos en el banco de trabajo
photo-scaled = todos los puntos encontrados están un {$percent} % demasiado lejos de los polos
photo-scaled_down = todos los puntos encontrados están un {$percent} % demasiado cerca de los polos
photo-measure_ruler = ponga una regla sobre la que está impresa en la hoja: si sus 50 mm no miden 50 mm, la hoja se imprimió ajustada a la página


## Errors and warnings: board

board-too_many = un dibujo tiene como máximo {$most} entradas, y aquí hay {$count}
board-sheet_too_large = con {$mu} por mm el {$sheet} mediría {$metres} m; se dibujan hojas de hasta {$most} m
board-other_scale = escriba la escala de su hoja, como {$mu}, u omita {$key}
board-no_formula = `{$text}` no es una fórmula: no se entiende a partir de la letra {$place}
board-no_equation = `{$text}` no es una ecuación: falta el =
board-not_linear = `{$text}` no es lineal en los números buscados
board-no_value = `{$text}` no tiene valor
board-no_solution = las ecuaciones no tienen solución, o tienen muchas
board-taken = `{$name}` no sirve de nombre: ya está dado, o no es un nombre
board-no_point = todavía no hay un punto {$name}
board-no_line = no hay una línea {$name}
board-no_number = {$name} todavía no se conoce
board-no_direction = {$name} no tiene dirección
board-no_reference = `{$name}` no da dirección: no es línea, eslabón ni guía; dos puntos se escriben como "B,C"
board-which_points = el eslabón {$link} no tiene justo dos puntos: diga entre cuáles, como "B,C"
board-which_sheet = diga en qué hoja, como "on": "velocity"
board-two_sheets = las líneas {$one} y {$two} están en dos hojas
board-no_crossing = las líneas {$one} y {$two} son paralelas
board-line_misses = {$point} no está sobre esta línea
board-lines_of_others = {$point} no está donde se cortan estas líneas
board-point_elsewhere = {$point} no está ahí
board-no_force_of_polygon = el vector hasta {$point} no es ninguna fuerza que falte en su polígono
board-no_direction_of_force = {$line} no tiene la dirección de ninguna fuerza que cierre su polígono
board-polygon_not_closed = el polígono no se cierra en {$point}
board-number_wrong = esto no es {$name}
board-nothing_leads_to = nada de lo dibujado lleva a {$name}: dibuje o mida aquello de lo que resulta
board-equation_wrong = la ecuación {$number} no se cumple
board-leads_wrong = con esto, {$name} sale mal
board-drawn_off = esta línea está dibujada a {$mm} mm y {$degrees}° de lo que se quería
board-point_off = este punto está marcado a {$mm} mm de lo que se quería
board-misread = {$name} se leyó a {$mm} mm de lo dibujado
board-join = línea {$name} por {$one} y {$two}
board-line = línea {$name} por {$point}, {$direction}
board-line_by_eye = línea {$name} a ojo
board-cross = {$name} donde se cortan {$one} y {$two}
board-lay_off = {$name}: {$size} llevado desde {$point}, {$direction}
board-like = {$name} sobre {$ends} como en el triángulo {$points}
board-mark = {$name} marcado a ojo
board-measure = {$name} medido de {$one} a {$two}
board-compute = {$name} = {$formula}
board-typed = {$name} = {$number}, escrito
board-solve = {$names} de ecuaciones
board-undo = {$count ->
    [one] retirada la última entrada
   *[other] retiradas las últimas {$count} entradas
}
board-parallel = paralela a {$to}
board-normal = perpendicular a {$to}
board-turned = en {$base} con el ángulo de {$from} a {$to}
board-angle = a {$degrees}°
board-link = eslabón {$name}
board-guide = guía {$name}
board-load = fuerza {$name}
board-drawn_line = línea {$name}
board-ccw = antihorario
board-cw = horario
board-right = correcto
board-wrong = incorrecto
board-follows = se deriva de ello
board-unused = sin uso
board-undone = retirado
board-all_right = Todas las operaciones son correctas.
board-right_so_far = Hasta aquí cada operación es correcta.
board-asked_missing = Todavía se pide: {$names}.
board-asked_missing_many = Todavía se pide: {$names} y {$more} más.
board-nothing_drawn = Todavía no hay nada dibujado.
board-first_wrong = La primera operación incorrecta es la número {$number}.
board-should = Debería ser: {$what}
board-no_sheet = la escena no tiene ese plano
board-free_hand = Mano libre: ±{$mm} mm y ±{$degrees}° valen como correctos
board-all_there = Está todo.
board-next_line = Lo siguiente es una línea: {$sheet}.
board-next_point = Lo siguiente es {$name}: {$sheet}.
board-next_number = Lo siguiente es {$name}.

## The workbench: layout

page-layout-described = La figura en palabras
page-layout-notices = Lo que otros han hecho, con sus licencias
page-layout-back_to_picture = Volver a la figura
page-layout-is_fixed = Puntos fijos: {$points}.
page-layout-is_link = Eslabón {$name}: {$points}
page-layout-is_driven = conductor, en {$place}
page-layout-is_slider = La corredera {$name} desliza sobre {$on}.
page-layout-is_pin = El perno {$name} desliza en una ranura de {$on}.
page-layout-is_ground = el bastidor
page-layout-is_through = Su guía pasa por {$place}.
page-layout-is_known = Movimientos conocidos: {$points}.
page-layout-means_pole_v = {$name}, el polo: aquí empiezan todas las velocidades, y aquí tiene su imagen lo que está quieto.
page-layout-means_pole_a = {$name}, el polo: aquí empiezan todas las aceleraciones, y aquí tiene su imagen lo que no tiene ninguna.
page-layout-means_image_v = {$name}, la imagen de {$point}: la flecha del polo hasta aquí es la velocidad de {$point}.
page-layout-means_image_a = {$name}, la imagen de {$point}: la flecha del polo hasta aquí es la aceleración de {$point}.
page-layout-means_special = {$name}, el punto especial del eslabón {$link}: donde se cortan sus rectas. Da al plano su siguiente imagen.
page-layout-means_special_image = {$name}, la imagen del punto especial del eslabón {$link}.
page-layout-means_under = {$name}, la imagen del punto del eslabón {$link} que está ahora bajo {$point}.
page-layout-means_normal = {$name}, el extremo de una componente normal ω²·l. Aquí empieza la tangencial.
page-layout-means_coriolis = {$name}, el extremo de una componente de Coriolis 2·ω·v.
page-layout-means_sliding = {$name}, el extremo de una componente a lo largo de una guía.
page-layout-means_omega = {$name}, la velocidad angular del eslabón {$link}.
page-layout-means_alpha = {$name}, la aceleración angular del eslabón {$link}.
page-layout-tour = Una visita corta
page-layout-tour_pull = Tira de una articulación: el mecanismo se mueve y los planos de sus velocidades y aceleraciones lo siguen, a escala.
page-layout-tour_steps = Pasos muestra cómo se dibujan los planos a mano, línea por línea.
page-layout-tour_own = Mecanismo tiene cada número para escribirlo, y otros mecanismos para empezar. Los otros paneles dibujan, comprueban y guardan.
page-layout-tour_next = Siguiente
page-layout-tour_leave = Salir
page-layout-tour_done = Empezar
page-layout-skips = Saltar
page-layout-skip_picture = A la figura
page-layout-skip_panels = A los paneles
page-layout-skip_motion = Al movimiento
page-layout-toolbar = Escena y herramientas
page-layout-picture = Figura
page-layout-panels = Paneles
page-layout-untitled = Escena
page-layout-documents = Escenas y archivos
page-layout-open_file = Abrir una escena o un formulario…
page-layout-lesson = La escena de este archivo
page-layout-recent = Trabajos anteriores
page-layout-forget = Olvidarlos
page-layout-undo = Deshacer (Ctrl+Z)
page-layout-redo = Rehacer (Ctrl+Y)
page-layout-undone = Deshecho.
page-layout-redone = Rehecho.
page-layout-hand = Qué hace tirar de un punto
page-layout-move = Mover
page-layout-move_long = Mover: al tirar de un punto se mueve el mecanismo
page-layout-shape = Formar
page-layout-shape_long = Formar: al tirar de un punto cambian las longitudes
page-layout-build = Construir
page-layout-build_long = Construir: componer un mecanismo, completo o no
page-layout-zoom = Tamaño
page-layout-all = Todo
page-layout-zoom_in = Más grande (+)
page-layout-zoom_out = Más pequeño (−)
page-layout-fit = Ajustar (0)
page-layout-motion = Movimiento
page-layout-play = Reproducir (espacio)
page-layout-play_together = Reproducir (espacio): todos los accionamientos se mueven juntos, en proporción a sus velocidades
page-layout-together = Todos los accionamientos se mueven juntos, en proporción a sus velocidades. Un deslizador mueve uno solo.
page-layout-stuck = El accionamiento no puede moverse desde donde está.
page-layout-pause = Pausa (espacio)
page-layout-speed = Rapidez
page-layout-link = Eslabón {$name}
page-layout-slider = Corredera {$name}
page-layout-drive_at = {$name} está en
page-layout-drive_unread = «{$typed}» no es un número aquí. Escriba uno, si quiere con unidad: 60°, 0,5 rad, 12 cm.
page-layout-steps = Pasos
page-layout-steps_long = Pasos de la construcción
page-layout-first = Primer paso (Inicio)
page-layout-back = Paso atrás (←)
page-layout-forward = Paso adelante (→)
page-layout-last = Figura terminada (Fin)
page-layout-step = Paso
page-layout-step_of = Paso {$number} de {$count}
page-layout-finished = Figura terminada, {$count} pasos
page-layout-coarse = Pasos grandes
page-layout-language = Idioma
page-layout-full = Pantalla completa (p)
page-layout-leave_full = Salir de la pantalla completa (Esc)
page-layout-dark = Oscuro o claro (d)
page-layout-help = Ayuda (?)
page-layout-help_title = ¿Qué es esto y qué hago ahora?
page-layout-way_new = ¿Nunca vio un plano?
page-layout-way_new_how = Cada flecha desde el polo es la velocidad (o la aceleración) de un punto, a escala: el doble de larga es el doble de rápida. Tire de una articulación y mire las flechas. Deténgase sobre una letra, o tóquela, para leer qué significa. Los números están en Valores; lo que hacen en una vuelta, en Curvas.
page-layout-way_lecture = Una figura para clase
page-layout-way_lecture_how = Elija un mecanismo parecido al suyo y escriba sus números, o compóngalo con Construir. Figura elige la hoja, su idioma y su estilo. Pasos dibuja los planos línea por línea; P llena la pantalla. Guardar tiene PDF, SVG, TikZ, una película y un enlace para estudiantes.
page-layout-way_student = Un ejercicio
page-layout-way_student_how = Dibuje los dos planos en papel a las escalas dadas, mida y escriba lo medido en Comprobar, o fotografíe su hoja. Dice en qué paso hubo un error.
page-layout-way_go = Abrir {$panel}
page-layout-letters = Letras en los planos (notación usual)
page-layout-letter_poles = polos: en p empiezan todas las velocidades, en π todas las aceleraciones
page-layout-letter_images = imágenes de los puntos B, C: la flecha del polo a b es la velocidad de B (en el otro plano, su aceleración)
page-layout-letter_normal = extremo de una parte normal ω²·l; allí empieza la tangencial
page-layout-letter_coriolis = extremo de una parte de Coriolis 2·ω·v
page-layout-letter_special = puntos especiales de grupos de tercera y cuarta clase, y sus imágenes
page-layout-letter_scale = escalas: una longitud en mm en la hoja, por μ, es el valor
page-layout-more = Más
page-layout-keys = Teclas
page-layout-keys_letters = Las letras sirven de teclas
page-layout-close = Cerrar
page-layout-key_steps = paso atrás, paso adelante
page-layout-key_ends = primer paso, figura terminada
page-layout-key_drive = girar la entrada 1° (con Mayús 0,1°)
page-layout-key_play = reproducir, pausa
page-layout-key_panels = esquema, velocidades, aceleraciones, todo
page-layout-key_zoom = más grande, más pequeño, ajustar
page-layout-key_hand = mover, formar, construir
page-layout-key_full = pantalla completa
page-layout-key_dark = oscuro o claro
page-layout-key_undo = deshacer, rehacer
page-layout-key_joint = sobre un punto: moverlo 1 mm de la hoja (con Mayús 0,1 mm)
page-layout-key_escape = devolver a su sitio lo que se arrastra; de un panel a su pestaña
page-layout-joint = Punto {$name}
page-layout-fixed_joint = Punto fijo {$name}
page-layout-joint_hint = Las flechas lo mueven, con Mayús más fino. Escape lo devuelve a su sitio.
page-layout-mend_first = La escena tiene un error. Corríjalo antes de mover algo.
page-layout-no_picture = Todavía no hay figura. El mensaje de arriba dice por qué.
page-layout-to_text = Mostrarlo en el texto
page-layout-go_on = Seguir construyendo
page-layout-warning = 1 advertencia
page-layout-warnings = {$count} advertencias
page-layout-busy = Calculando…
page-layout-put_back = Devuelto a su sitio.
page-layout-stop = Detener
page-layout-stopped = Detenido. La escena sigue igual.
page-layout-too_slow = Esto tardó más de {$seconds} s y se detuvo. La escena sigue igual.
page-layout-fell = El motor se detuvo de forma inesperada y se volvió a iniciar. La escena sigue igual.
page-layout-link_broken = El enlace está dañado o incompleto y no se pudo leer ninguna escena. Lo que había sigue aquí.
page-layout-link_newer = El enlace es de una versión más nueva de Kinegon. Pida la escena como archivo o abra el enlace con esa versión.
page-layout-link_too_large = El enlace contiene más texto del que puede tener una escena y no se leyó.
page-layout-file_too_large = El archivo «{$name}» tiene más de 4 MB, más de lo que puede tener una escena o un formulario.
page-layout-unread_file = No se puede leer el archivo «{$name}».
page-layout-forms_first = De los {$count} formularios solo está abierto «{$name}»: esta página toma uno a la vez. Para un grupo entero, pon los formularios en una carpeta y ejecuta: kinegon check scene.json forms/
page-layout-forms_left = Los dibujos están en el tablero; los formularios quedaron fuera. Para un grupo entero, pon los formularios en una carpeta y ejecuta: kinegon check scene.json forms/
page-layout-files_first = De los {$count} archivos solo está abierto «{$name}»: esta página toma uno a la vez.
page-layout-opened_file = Se abrió «{$name}». Deshacer devuelve lo que había.
page-layout-exam_open = En un examen solo se puede abrir un dibujo propio.
page-layout-no_storage = Este navegador no guarda nada de esta página. Guarde la escena en un archivo antes de cerrarla.
page-layout-restored = Aquí está de nuevo su última escena.
page-layout-course_deaf = El curso no recibe la calificación en este momento. Lo que usted escriba queda en esta página; guarde además el formulario en el panel Comprobar, para poder entregarlo de otro modo.
page-layout-course_again = Enviar de nuevo
page-layout-course_hears = El curso ya tiene la calificación.
page-layout-worked_before = Esta es la escena del archivo. Usted ya trabajó con ella: «{$title}», {$when}.
page-layout-take_up = Seguir con eso
page-layout-as_paper = Papel
page-layout-as_paper_long = Papel: la hoja que se guarda y se imprime, con sus escalas. Sin él la figura llena la pantalla, con escalas propias de la pantalla.
page-layout-below = Curvas
page-layout-splitter = Ancho del panel
page-layout-start_failed = Kinegon no pudo iniciarse: {$why}. Hace falta un navegador de 2023 o posterior.


## The workbench: build

page-build-stage = Construir: {$count} puntos
page-build-tools = Qué hacer
page-build-tool_select = Elegir
page-build-tool_link = Eslabón
page-build-tool_third = Punto en un eslabón
page-build-tool_fixed = Punto fijo
page-build-tool_slider = Corredera
page-build-tool_cylinder = Cilindro
page-build-tool_drive = Accionar
page-build-tool_drop = Quitar
page-build-tool_load = Carga
page-build-hint_select = Arrastre un punto o un eslabón para moverlo. Un clic muestra sus números, dos permiten escribirlos. Mayús añade a lo elegido.
page-build-hint_link = Arrastre de articulación a articulación, o de un lugar vacío a otro.
page-build-hint_third = Arrastre desde un eslabón hasta donde debe estar su nuevo punto.
page-build-hint_fixed = Pulse un punto para fijarlo o soltarlo; un lugar vacío recibe uno nuevo.
page-build-hint_slider = Arrastre desde el punto que desliza: hasta un eslabón que lo guía, o en la dirección de una guía del bastidor.
page-build-hint_cylinder = Arrastre de articulación a articulación: un cilindro y su vástago, que un accionamiento separa.
page-build-hint_drive = Pulse un eslabón con un punto fijo, o una corredera: se acciona, o deja de accionarse.
page-build-hint_drop = Pulse un punto o un eslabón para quitarlo.
page-build-hint_load = Arrastre desde un eslabón hacia donde apunta la fuerza: un paso de la cuadrícula son 10 unidades. Un toque pone un par en el eslabón. La punta de una flecha cambia su fuerza, su asta la mueve; un arco se arrastra para cambiar su par.
page-build-second = Ahora el otro extremo.
page-build-key = Tecla {$key}
page-build-what_slides = Qué desliza
page-build-slides_block = Corredera en el perno
page-build-slides_itself = El propio eslabón
page-build-slides_pin = Perno en una ranura
page-build-on_link = La guía en un eslabón
page-build-guided_along = A lo largo
page-build-guided_across = En ángulo recto
page-build-snap = Cuadrícula
page-build-fit = Ajustar
page-build-smaller = Más pequeño
page-build-larger = Más grande
page-build-photo = Fotografía…
page-build-photo_scale = Su escala
page-build-photo_away = Sin fotografía
page-build-photo_two = Pulse dos lugares de la fotografía cuya distancia conozca y escríbala después.
page-build-photo_length = distancia entre los dos
page-build-photo_number = Escríbala como un número de {$unit}, por ejemplo 120.
page-build-photo_unread = Este archivo no es una imagen que el navegador pueda mostrar.
page-build-begin = Aún no hay nada. Arrastre un primer eslabón.
page-build-complete = Completo. La mano Mover (m) lo mueve.
page-build-incomplete = Aún incompleto: {$why}
page-build-wants_ground = Aún incompleto: nada está quieto. Fije puntos o dé una guía en el bastidor.
page-build-wants_one = Aún incompleto: queda un movimiento libre. Falta un accionamiento, o un eslabón o punto fijo más.
page-build-wants_more = Aún incompleto: quedan {$count} movimientos libres. Faltan articulaciones, puntos fijos o accionamientos.
page-build-too_held = Aún incompleto: sobran {$count} articulaciones, puntos fijos o accionamientos.
page-build-mobility = (3·{$links} − {$taken} = {$free}, accionamientos: {$drives})
page-build-needs_point = Empiece en un punto que ya esté.
page-build-needs_link = Empiece en un eslabón.
page-build-needs_pivot = Un accionamiento gira un eslabón con un punto fijo o empuja una corredera en su guía: este eslabón no tiene ninguno.
page-build-needs_way = Arrastre un poco más lejos: los dos extremos están en un mismo lugar.
page-build-joined_already = Un eslabón ya tiene estos dos puntos.
page-build-at_link = eslabón {$name}
page-build-at_load = carga {$name}
page-build-taken_up = Tomado: las flechas lo mueven, Intro lo deja.
page-build-put_down = Dejado.
page-build-put_back = Devuelto a su lugar.
page-build-removed = Quitado.
page-build-copied = {$count} puntos copiados.
page-build-numbers = Números
page-build-rename = Nombre
page-build-fix_it = Fijarlo
page-build-free_it = Soltarlo
page-build-drive_it = Poner o quitar accionamiento
page-build-copy = Copiar
page-build-paste = Pegar
page-build-remove = Quitar


## The workbench: mechanism

page-mechanism-panel_title = Mecanismo
page-mechanism-about = General
page-mechanism-title = Título
page-mechanism-untitled = Sin título
page-mechanism-length_unit = Longitudes en
page-mechanism-time_unit = Tiempos en
page-mechanism-ground = Puntos fijos
page-mechanism-ground_help = Apoyos en el bastidor. x a la derecha, y hacia arriba.
page-mechanism-fixed_point = Punto fijo
page-mechanism-add_fixed = Punto fijo
page-mechanism-no_longer_there = Quitar el punto {$name}
page-mechanism-links = Eslabones
page-mechanism-links_help = Un punto en dos eslabones los articula.
page-mechanism-link = Eslabón
page-mechanism-link_name = Nombre del eslabón {$name}
page-mechanism-add_link = Eslabón
page-mechanism-from = Desde el punto
page-mechanism-to = Hasta el punto
page-mechanism-new_point = {$name} nuevo
page-mechanism-points = Puntos
page-mechanism-point_name = Nombre del punto {$name}
page-mechanism-drop_link = Quitar el eslabón {$name}
page-mechanism-take_off = Quitar {$name} del eslabón
page-mechanism-add_point = Punto
page-mechanism-places_on_link = Lugares en el propio eslabón; x va a lo largo de él
page-mechanism-give_place = y
page-mechanism-drive_it = Accionar este eslabón
page-mechanism-drop_drive = Quitar el accionamiento de {$name}
page-mechanism-drive = Accionamiento
page-mechanism-angle = Ángulo
page-mechanism-speed = Velocidad
page-mechanism-turns = Unidad de la velocidad
page-mechanism-acceleration = Aceleración
page-mechanism-position = Posición
page-mechanism-axis_angle = Ángulo de su eje
page-mechanism-block = corredera
page-mechanism-unsized = Cuatro puntos o más necesitan una forma: quite puntos y añádalos de nuevo.
page-mechanism-moves_as_known = movimiento conocido
page-mechanism-sliders = Correderas
page-mechanism-sliders_help = Correderas en guías rectas y pernos en ranuras.
page-mechanism-slides_on = {$point} sobre {$on}
page-mechanism-pin_in_slot = perno en ranura
page-mechanism-what_slides = Lo que desliza
page-mechanism-sliding_link = Eslabón
page-mechanism-at = en
page-mechanism-pin = Perno
page-mechanism-on = Desliza sobre
page-mechanism-ground_word = bastidor
page-mechanism-through = Guía por
page-mechanism-through_usual = su propio punto
page-mechanism-through_place = un lugar x, y
page-mechanism-offset = y (descentrado)
page-mechanism-along = Guía según
page-mechanism-along_usual = su eje
page-mechanism-along_degrees = un ángulo
page-mechanism-along_direction = una dirección x, y
page-mechanism-degrees = Ángulo
page-mechanism-turned = Girada
page-mechanism-drop_slider = Quitar la corredera {$name}
page-mechanism-add_slider = Corredera
page-mechanism-new_block = corredera nueva en {$name}
page-mechanism-link_at = eslabón {$link} en {$name}
page-mechanism-pin_at = perno {$name} en una ranura
page-mechanism-rolling = Ruedas, correas y levas
page-mechanism-rolling_help = Dos ruedas que ruedan una sobre otra, una rueda sobre una cremallera, ruedas con una correa; dos perfiles que se tocan, por sus centros y radios de curvatura.
page-mechanism-add_gear = Par de ruedas
page-mechanism-wheel = Rueda
page-mechanism-runs_on = Rueda sobre
page-mechanism-new_wheel = una rueda nueva
page-mechanism-new_rack = una cremallera nueva
page-mechanism-pair_of = {$first} con {$second}
page-mechanism-carried_by = sobre {$name}
page-mechanism-first_wheel = Primera
page-mechanism-second_wheel = Segunda
page-mechanism-carrier = La lleva
page-mechanism-teeth_of = Dientes de {$name}
page-mechanism-pitch_radius = Radio primitivo
page-mechanism-touch = Contacto
page-mechanism-touch_outside = dientes por fuera
page-mechanism-touch_ring_first = la primera es corona
page-mechanism-touch_ring_second = la segunda es corona
page-mechanism-touch_rack_first = la primera es cremallera
page-mechanism-touch_rack_second = la segunda es cremallera
page-mechanism-touch_open = correa abierta
page-mechanism-touch_crossed = correa cruzada
page-mechanism-rack_at_zero = Posición con la rueda a 0
page-mechanism-second_at_zero = Segunda rueda con la primera a 0
page-mechanism-pressure = Ángulo de presión
page-mechanism-add_contact = Contacto
page-mechanism-first_center = Centro de curvatura del primero
page-mechanism-second_center = Centro de curvatura del segundo
page-mechanism-contact_of = {$first} sobre {$second}
page-mechanism-first_profile = Primero
page-mechanism-second_profile = Segundo
page-mechanism-center_at = Centro de curvatura
page-mechanism-radius_of = Radio de curvatura de {$name}
page-mechanism-add_radii = Radios
page-mechanism-second_is = El segundo es
page-mechanism-profile_round = redondo
page-mechanism-profile_roller = un rodillo
page-mechanism-profile_flat = plano
page-mechanism-circular = círculos en toda posición
page-mechanism-equivalent = Eslabón equivalente
page-mechanism-face_through = Cara por
page-mechanism-face_along = Cara según
page-mechanism-travel = Extremos de la ranura
page-mechanism-travel_from = de
page-mechanism-travel_to = a
page-mechanism-drop_travel = Quitar los extremos de la corredera {$name}
page-mechanism-loads = Masas y fuerzas
page-mechanism-loads_help = De ellas sigue lo que llevan las articulaciones y lo que piden los accionamientos. Las cargas se dibujan junto al plano de fuerzas.
page-mechanism-add_force = Fuerza
page-mechanism-add_couple = Par
page-mechanism-add_mass = Masa
page-mechanism-add_spring = Resorte
page-mechanism-add_friction = Rozamiento
page-mechanism-pin_of = Pasador {$name}
page-mechanism-guide_of = Guía {$name}
page-mechanism-friction_of = Rozamiento: {$name}
page-mechanism-coefficient = Coeficiente de rozamiento
page-mechanism-friction_angle = Ángulo de rozamiento
page-mechanism-journal = Radio del muñón
page-mechanism-joint = Par
page-mechanism-acts_at = Actúa en
page-mechanism-acts_on = Actúa sobre
page-mechanism-gravity = Gravedad
page-mechanism-drop_gravity = Quitar la gravedad
page-mechanism-analysis = Inercia
page-mechanism-with_inertia = cuenta
page-mechanism-without_inertia = no cuenta
page-mechanism-mass_unit = Masas en
page-mechanism-force_unit = Fuerzas en
page-mechanism-mass = Masa
page-mechanism-weight = Peso
page-mechanism-inertia = Momento de inercia respecto al centro de masas
page-mechanism-mass_of = Masa de {$name}
page-mechanism-center = Centro de masas
page-mechanism-drop_mass = Quitar la masa del eslabón {$name}
page-mechanism-on_axis = x a lo largo del eslabón
page-mechanism-load_name = Nombre
page-mechanism-force = Fuerza
page-mechanism-couple = Par
page-mechanism-turns_with_link = gira con el eslabón
page-mechanism-changes_over = Cambia con
page-mechanism-add_over = Según el movimiento
page-mechanism-table_lines = Lugar y factor, una línea cada uno
page-mechanism-position_of = posición de {$name}
page-mechanism-drop_over = Quitar la tabla de {$name}
page-mechanism-drop_load = Quitar {$name}
page-mechanism-rate = Fuerza por longitud
page-mechanism-free_length = Longitud sin fuerza
page-mechanism-near = De qué modo se arma
page-mechanism-near_help = Lugares aproximados de puntos o ángulos de eslabones. Kinegon toma el montaje más cercano.
page-mechanism-add_near = Lugar aproximado
page-mechanism-angle_of = ángulo de {$name}
page-mechanism-drop_near = Quitar el lugar aproximado de {$name}
page-mechanism-drawn_points = Puntos como en el dibujo
page-mechanism-drawn_help = Esta escena está dibujada: da coordenadas en vez de longitudes y no se puede mover.
page-mechanism-fixed = Fijo
page-mechanism-known = Movimientos conocidos
page-mechanism-known_help = Puntos cuya velocidad y aceleración se conocen.
page-mechanism-add_known = Movimiento conocido
page-mechanism-drop_known = Quitar el movimiento conocido de {$name}
page-mechanism-velocity = Velocidad
page-mechanism-by_parts = como x, y
page-mechanism-by_size = como módulo, ángulo
page-mechanism-size = módulo
page-mechanism-known_motion = Su movimiento se conoce
page-mechanism-drop_motion = Quitar el movimiento conocido del eslabón {$name}
page-mechanism-add_acceleration = Aceleración
page-mechanism-drop_acceleration = Quitar la aceleración
page-mechanism-stub = tocón
page-mechanism-moving = móvil
page-mechanism-change_kind = Otros mecanismos
page-mechanism-empty = Nuevo, vacío
page-mechanism-open_file = Abrir…
page-mechanism-groups_bars = Un lazo
page-mechanism-groups_more = Seis eslabones
page-mechanism-groups_drives = Varios accionamientos
page-mechanism-groups_wheels = Ruedas y levas
page-mechanism-groups_class = Tercera y cuarta clase
page-mechanism-groups_drawn = Grupos como en un libro
page-mechanism-groups_paper = Del artículo


## The workbench: curves

page-curves-panel_title = Curvas
page-curves-what = Qué se dibuja
page-curves-curves = Curvas
page-curves-hodograph = Hodógrafas
page-curves-path = Trayectorias
page-curves-choose = Elegir
page-curves-clear = Ninguna
page-curves-beyond = También más allá de los límites motrices, a trazos
page-curves-none = Elija al menos una.
page-curves-drawn = Esta escena da sus puntos tal como están dibujados. No puede moverse; no hay nada a lo largo de un ciclo.
page-curves-waits = Dibujando …
page-curves-save = Guardar como {$format}
page-curves-table = Tabla como CSV
page-curves-events = Posiciones especiales
page-curves-no_events = Ninguna en este intervalo.


## The workbench: figure

page-figure-language_name = Español
page-figure-panel_title = Figura
page-figure-shown = Qué se muestra
page-figure-panels = Paneles
page-figure-focus = Grande
page-figure-none = Todos igual
page-figure-scales = Escalas
page-figure-scales_help = De la hoja que se guarda y se imprime («Papel» la muestra); en la pantalla las escalas son propias de ella. Vacía, se toma la siguiente escala redonda que cabe.
page-figure-automatic = automática
page-figure-take = Mantener la escala actual {$value}
page-figure-as_before = Automática de nuevo
page-figure-scales_for = Las automáticas valen para
page-figure-position = esta posición
page-figure-sheet = cada hoja por sí
page-figure-cycle = todo el ciclo
page-figure-look = Aspecto
page-figure-style = Estilo
page-figure-paper = Artículo
page-figure-print = Imprenta
page-figure-lecture = Aula
page-figure-board = Pizarra
page-figure-notation = Notación
page-figure-n_paper = Artículo
page-figure-english = Inglesa
page-figure-russian = Rusa
page-figure-german = Alemana
page-figure-sliding = En las guías
page-figure-coriolis = Índice de Coriolis
page-figure-as_notation = como en la notación
page-figure-frame = Bastidor
page-figure-word = con palabra
page-figure-turned = Velocidades
page-figure-not_turned = como son
page-figure-turned_by = giradas {$angle}°
page-figure-language = Idioma
page-figure-decimal = Decimales
page-figure-point = 2.5
page-figure-comma = 2,5
page-figure-page = Hoja
page-figure-page_size = Tamaño
page-figure-landscape = Horizontal
page-figure-portrait = Vertical
page-figure-direction = Orientación
page-figure-worksheet = Hoja de trabajo con tabla y regla
page-figure-yes = Sí
page-figure-no = No
page-figure-contents = En la figura
page-figure-values = Valores
page-figure-usual = según el estilo
page-figure-with_unit = longitudes en {$unit}
page-figure-construction = Construcción
page-figure-whole = Entera
page-figure-as_paper = Como el artículo
page-figure-hidden = Oculta
page-figure-special = Puntos especiales
page-figure-paths = Trayectorias y posiciones
page-figure-trace = Trayectorias de puntos en el ciclo
page-figure-no_trace = Este mecanismo no tiene ciclo con trayectorias.
page-figure-beyond = Las trayectorias siguen más allá de los límites
page-figure-ghosts = Posiciones pálidas de los eslabones
page-figure-ghosts_unit = en el ciclo
page-figure-centers = Centros instantáneos
page-figure-centers_help = El panel de centros instantáneos se elige en «Qué se muestra».
page-figure-wanted_centers = Centros
page-figure-usual_centers = los usuales
page-figure-all_centers = todos
page-figure-these_centers = estos
page-figure-velocities = Velocidades por centros
page-figure-curvature = Curvatura de trayectorias de puntos
page-figure-centrodes = Polodias de eslabones, en el esquema
page-figure-inflection = Circunferencias de inflexiones, en el esquema
page-figure-labels = Otras letras
page-figure-labels_help = Se muestran en vez del nombre. B_1 escribe un subíndice.
page-figure-label_of = Texto para {$name}
page-figure-drop_label = Mostrar de nuevo el nombre de {$name}
page-figure-projector = Proyector 16:9
page-figure-own_name = Nombre que se sustituye
page-figure-add_label = Texto


## The workbench: text

page-text-panel_title = Texto
page-text-editor = Texto de la escena
page-text-good = El texto es una escena completa.
page-text-go = Ir allí
page-text-long = Este texto está en una línea demasiado larga para mostrarla.
page-text-lay_out = Repartirlo en líneas
page-text-help = Este texto es todo el documento: un archivo de escena del programa. Ctrl+Espacio ofrece claves, Ctrl+F busca, Esc y Tab sale.


## The workbench: exercise

page-exercise-panel_title = Ejercicio
page-exercise-intro = Un mecanismo con otros números redondos, elegidos para que se dibuje bien a mano. La misma semilla da los mismos ejercicios, aquí y con kinegon exercise.
page-exercise-kind = Mecanismo
page-exercise-own = La escena abierta: {$title}
page-exercise-seed = Semilla
page-exercise-number = Número
page-exercise-page = Hoja
page-exercise-page_auto = A4, o A3 donde haga falta
page-exercise-page_name = {$size} {$way}
page-exercise-landscape = apaisada
page-exercise-portrait = vertical
page-exercise-back = Ejercicio anterior
page-exercise-forward = Ejercicio siguiente
page-exercise-large = Vista grande
page-exercise-small = Volver a la imagen
page-exercise-making = Buscando un ejercicio…
page-exercise-student = Para los estudiantes
page-exercise-print = Imprimir al 100 %
page-exercise-print_hint = En la ventana de impresión elige 100 % o tamaño real, nunca «ajustar a la página». La regla de la lámina muestra si es exacta.
page-exercise-link = Enlace para estudiantes
page-exercise-allow_steps = Con los pasos de la construcción, en palabras
page-exercise-allow_more = Con los ejercicios siguientes de esta semilla
page-exercise-link_hint = Tiene la lámina para imprimir, el formulario, la fotografía y su comprobación, también en un teléfono. Abre el mecanismo sin sus planos, con el formulario al lado. Quien quiera puede sacar las respuestas de la escena: para poner nota, recoge los formularios.
page-exercise-sheet = Lámina
page-exercise-form = Formulario
page-exercise-scene = Escena
page-exercise-teacher = Para el profesor
page-exercise-show_key = Mostrar la solución
page-exercise-print_key = Imprimir la solución
page-exercise-key = Solución
page-exercise-key_values = Valores
page-exercise-open = Abrir en el banco de trabajo
page-exercise-opened = El ejercicio {$name} está abierto; deshacer recupera la escena anterior.
page-exercise-sheet_of = Lámina del ejercicio {$name}
page-exercise-key_of = Solución del ejercicio {$name}
page-exercise-board_paper = Los planos se dibujan en papel
page-exercise-board_practice = En el tablero: práctica
page-exercise-board_at_once = En el tablero: se avisa enseguida de una recta equivocada
page-exercise-board_exam = En el tablero: examen, no se dice nada
page-exercise-board_demonstration = En el tablero: ver cómo se dibuja
page-exercise-board_snap = Con qué se ayuda a la mano
page-exercise-board_snap_all = Puntos y rectas encajan
page-exercise-board_snap_points = Solo los puntos encajan
page-exercise-board_snap_none = A mano libre


## The workbench: values

page-values-panel_title = Valores
page-values-find = Buscar una magnitud
page-values-digits = Cifras
page-values-certain = cifras seguras
page-values-few = {$count} cifras
page-values-copy = Copiar
page-values-save = CSV
page-values-copied = La tabla está en el portapapeles.
page-values-not_copied = Este navegador no deja que la página use el portapapeles. Guarde la tabla como CSV.
page-values-quantity = Magnitud
page-values-value = Valor
page-values-unit = Unidad
page-values-error = ±
page-values-count = {$count} de {$all} magnitudes
page-values-none = Ninguna magnitud tiene esto en su nombre.
page-values-about = Toda cifra que se muestra es segura; ± dice cuánto puede distar el valor del verdadero de la escena.
page-values-about_few = Redondeado. «Cifras seguras» muestra toda cifra segura y cuánto puede distar el valor del verdadero de la escena.
page-values-groups = Grupos de Assur
page-values-warnings = Advertencias


## The workbench: modes

page-modes-panel_title = Modos
page-modes-ghosts = Mostrar los demás, pálidos, en la figura
page-modes-single = El mecanismo solo puede montarse de una manera.
page-modes-drawn = Esta escena da sus puntos tal como están dibujados. Solo pueden montarse de esta manera.
page-modes-count = Con estas longitudes y esta posición motriz hay {$count} maneras de montarlo. La escena guarda la que usted elija.
page-modes-mode = Modo {$number}
page-modes-chosen = Se ha elegido el modo {$number}.
page-modes-list = Modos de montaje


## The workbench: parts

page-parts-needed = Aquí hace falta un número.
page-parts-unread = No es un número. Escriba 60, 2,5, 1/3, 2*pi o sqrt(2), si quiere con unidad: 15 cm.
page-parts-other_unit = {$unit} no se puede convertir a {$own}.
page-parts-least = Al menos {$least}.
page-parts-nameless = Hace falta un nombre.
page-parts-pin_point = Sujetar {$name} al dar forma
page-parts-pin_length = Sujetar la longitud {$name} al dar forma
page-parts-unreadable = El texto de la escena tiene un error y el formulario espera. Corríjalo en el texto o deshaga.
page-parts-mend = Mostrar en el texto
page-parts-more = {$title}: todo
page-parts-table_file = Archivo (CSV)…


## The workbench: save

page-save-panel_title = Guardar
page-save-old_text = El texto de la escena tiene un error. Las figuras, los números y lo impreso son los del último texto correcto; el archivo de escena, la página y el enlace llevan el texto tal como está.
page-save-pictures = Figuras
page-save-figure = Figura
page-save-worksheet = Hoja de trabajo
page-save-this_step = Paso {$number}
page-save-png_width = Ancho del PNG, en píxeles
page-save-as = {$what} como {$format}
page-save-steps = Construcción
page-save-coarse = En una hoja los pasos que van juntos
page-save-sheets = {$count} hojas, {$format} (ZIP)
page-save-steps_text = Texto de los pasos
page-save-packing = Hoja {$number} de {$count} …
page-save-film = Película
page-save-film_turn = Una vuelta del accionamiento
page-save-film_about = El navegador graba la figura mientras los accionamientos se mueven como dice la escena: seis segundos, o seis por vuelta hasta que el mecanismo está donde empezó. Deje la página a la vista; tirar de un punto, reproducir o cambiar la escena interrumpe la grabación. El programa hace GIF, para presentaciones y mensajes: kinegon draw escena.json -o película.gif
page-save-filming = Grabando …
page-save-film_taken = La grabación se interrumpió: algo se movió o cambió.
page-save-film_hidden = La grabación se interrumpió: la página no estaba a la vista.
page-save-film_stuck = No hay película: el accionamiento no puede moverse desde donde está.
page-save-cannot_film = Este navegador no graba películas. El programa las hace: kinegon draw escena.json -o película.gif
page-save-numbers = Números
page-save-motion = Movimiento a lo largo del ciclo (CSV)
page-save-results = Resultados (JSON)
page-save-scene = Escena
page-save-scene_about = El archivo vuelve a entrar en esta página y en el programa. La página en un solo archivo lo lleva todo dentro y no necesita red: póngala en una memoria, en la página del curso, en un correo.
page-save-scene_file = Archivo de escena
page-save-page_file = Esta página con la escena
page-save-page_about = La página no se cargó entera y no puede guardarse. Vuelva a cargarla.
page-save-copy_link = Copiar el enlace
page-save-print = Imprimir al 100 %
page-save-print_now = Imprimir …
page-save-size = {$name} {$width} mm × {$height} mm
page-save-on = Hoja {$number} de {$count}
page-save-preview = La hoja tal como se imprime
page-save-to_scale = En el diálogo de impresión elija 100 % (tamaño real), este papel y ningún margen.
page-save-ruler = La hoja de trabajo tiene una regla. Si mide 50 mm en el papel, todo está a escala.
page-save-saved = Guardado: {$name}


## The workbench: links

page-link-of = Enlace con la escena dentro, {$size} caracteres
page-link-copied = El enlace está en el portapapeles: {$size} caracteres.
page-link-not_copied = Este navegador no deja que la página use el portapapeles. El enlace está seleccionado: cópielo con Ctrl+C.
page-link-long = Con {$size} caracteres este enlace es demasiado largo para algunos programas de correo y chats. El archivo de escena o la página en un solo archivo son más seguros.
page-link-local = Esta página se abrió desde un archivo de este ordenador: sus enlaces solo valen aquí. Ábrala desde la web para compartir enlaces, o comparta la página en un solo archivo.


## The workbench: check

page-check-panel_title = Comprobar
page-check-check = Comprobar
page-check-task = Ejercicio {$name}
page-check-task_intro = Imprime la lámina al 100 %, dibuja los planos en ella con sus escalas y escribe abajo lo que leas, o fotografíala.
page-check-task_sheet = Lámina del ejercicio
page-check-task_print = Imprimir al 100 %
page-check-task_large = Leer la lámina
page-check-task_small = Volver al mecanismo
page-check-task_drag = Arrastra la lámina para ver el resto; con dos toques se ve entera.
page-check-task_next = Ejercicio siguiente
page-check-task_is = Este es el ejercicio {$name}. Deshacer devuelve el anterior.
page-check-task_steps = Pasos de la construcción
page-check-task_making = Se prepara la lámina…
page-check-intro = Escribe lo que has leído en tu dibujo, valor por valor. Cada uno se comprueba en cuanto está escrito.
page-check-exam = Esto es un examen: dibuja en el tablero y entrega allí. Antes no se corrige ni se muestra nada.
page-check-no_scene = Esta escena no tiene formulario: no se puede resolver.
page-check-no_boxes = Esta escena no tiene construcción a mano; su formulario no tiene casillas.
page-check-file = Formulario
page-check-open = Abrir…
page-check-save_json = Guardar
page-check-save_csv = CSV
page-check-clear = Vaciar
page-check-marks_open = Baremo…
page-check-marks_drop = Sin baremo
page-check-marks_of = Puntos según {$name}
page-check-opened = El formulario {$name} está abierto: {$count} valores.
page-check-cleared = Se han borrado todos los valores; deshacer los recupera.
page-check-name = Tu nombre
page-check-scales = 1 mm de tu papel es
page-check-open_long = Abrir un formulario: JSON, o el CSV de una hoja de cálculo
page-check-save_json_long = Guardar el formulario como lo lee kinegon check
page-check-save_csv_long = Guardar el formulario para una hoja de cálculo
page-check-clear_long = Vaciar todas las casillas
page-check-marks_open_long = Abrir un baremo: los valores ganan puntos
page-check-marks_drop_long = Comprobar sin baremo
page-check-in = Longitudes y segmentos en
page-check-in_mm = mm de papel
page-check-in_units = valores
page-check-further = También en este formulario
page-check-unknown = No se entiende
page-check-remove = Quitar {$name}
page-check-unit_of = Unidad de {$name}
page-check-on_paper = mm de papel
page-check-is_on_paper = = {$value} mm en el papel
page-check-sense_of = Sentido de {$name}
page-check-ccw = antihorario
page-check-cw = horario
page-check-along = según la guía
page-check-against = contra la guía
page-check-choose_sense = elige el sentido
page-check-choose_senses = Algunas velocidades o aceleraciones tienen el tamaño correcto, pero no el sentido: elige ↺ o ↻, en un deslizamiento + o −.
page-check-from_points = de tus puntos
page-check-typing = …
page-check-not_understood = no se entiende
page-check-step = Paso {$step}
page-check-by_points = Marcar puntos de un plano
page-check-points_intro = Pulsa donde están los puntos de tu plano, primero el polo, o en centros instantáneos la primera articulación de la lista; o escribe sus lugares en mm, x hacia la derecha, y hacia arriba. El papel puede estar girado.
page-check-plan = Plano
page-check-points_sheet = Lámina del plano, cuadros de 5 mm. Las flechas mueven la cruz 1 mm, con Mayús 0,1 mm; Intro pone el punto elegido.
page-check-point = Punto
page-check-place = Poner {$name}
page-check-chosen = Ahora: {$name}
page-check-all_placed = Todos los puntos tienen su lugar. Arrastra uno para moverlo.
page-check-x_of = x de {$name} en mm
page-check-y_of = y de {$name} en mm
page-check-take_away = Quitar {$name}
page-check-placed = {$name} en {$x} mm, {$y} mm
page-check-scale_first = Escribe antes, arriba, la escala de este plano.
page-check-result = Lo que dice la comprobación
page-check-nothing_yet = Aún no hay valores.
page-check-to_result = Qué pasó
page-check-should = Cómo debe ser
page-check-show_step = Ver este paso
page-check-hint = Una pista
page-check-next_hint = Otra pista
page-check-follows = Qué se sigue
page-check-hand = Lo exacto que es tu dibujo
page-check-filled = {$filled} de {$all} casillas escritas
page-check-first_off = Primer ✗
page-check-overlay = Mostrar mi dibujo sobre el correcto
page-check-overlay_none = No hay nada que dibujar: nada está mal.
page-check-overlay_shown = La imagen muestra tu dibujo sobre el correcto: el tuyo, a trazos.
page-check-overlay_hide = Volver a la imagen
page-check-right_values = Mostrar los valores correctos
page-check-right_plan = Mostrar el plano correcto
page-check-right_plan_later = El plano correcto se puede ver cuando en cada casilla hay un valor que se puede leer.
page-check-right_plan_counts = Cuenta como todas las pistas, y así queda en el formulario.
page-check-right_plan_shown = Ahora se ven el plano correcto y todos los valores.
page-check-feedback = Guardar el informe como página
page-check-mm = mm


## The workbench: photo

page-photo-title = Fotografía de tu dibujo
page-photo-photograph = Fotografía de tu dibujo…
page-photo-take = Fotografía tu dibujo
page-photo-choose = Elegir una imagen…
page-photo-intro = Dibuja en la hoja impresa y fotografíala, o suelta aquí la imagen: el plano correcto queda encima y tú marcas tus puntos. La imagen no sale de este dispositivo.
page-photo-again = Volver a la fotografía
page-photo-another = Otra fotografía…
page-photo-close = Cerrar la fotografía
page-photo-back = Volver
page-photo-sheet_of = {$name}, hoja {$number}
page-photo-right_plan = Plano correcto
page-photo-right_later = El plano correcto se puede ver cuando todos los puntos de esta hoja están marcados.
page-photo-larger = Más grande
page-photo-smaller = Más pequeño
page-photo-fit = Ajustar
page-photo-undo = Deshacer
page-photo-opening = Abriendo la imagen…
page-photo-reading = Leyendo la hoja…
page-photo-tap = Toca el punto {$name}
page-photo-tap_in = Toca el punto {$name} del {$plan}
page-photo-tap_how = Va al cruce de tus líneas de lápiz. Mantén el dedo para ver el lugar ampliado.
page-photo-tap_mouse = Va al cruce de tus líneas de lápiz. Mantén el botón para ver el lugar ampliado.
page-photo-tap_none = Elige un punto abajo y toca dónde está.
page-photo-at_printed = {$name} está donde está impreso
page-photo-move_how = Arrástralo o toca su lugar; las flechas lo mueven 0,1 mm.
page-photo-move_touch = Arrástralo o toca su lugar.
page-photo-outside = Eso no está en la hoja. Toca el papel.
page-photo-is_right = {$name} está bien
page-photo-is_off = {$name} está a {$mm} mm de su lugar
page-photo-is_open = {$name}: no se puede saber con esta imagen
page-photo-open_how = Está a {$mm} mm de su lugar, y la imagen no da para más. Haz otra más cerca y más nítida, o mide con una regla.
page-photo-not_snapped = Ahí no se cruzan líneas de lápiz: el lugar se conoce a {$mm} mm. Ampliado, o manteniendo pulsado, apuntas mejor.
page-photo-leave_out = Omitir {$name}
page-photo-take_away = Quitar {$name}
page-photo-accept = Aceptar {$name}
page-photo-accept_all = Aceptar los {$count}
page-photo-is_here = ¿Es este tu punto {$name}?
page-photo-is_here_in = ¿Es este tu punto {$name} del {$plan}?
page-photo-proposed_how = Ahí parecen llevarlo tus líneas de lápiz. Acéptalo, o toca dónde está el tuyo.
page-photo-next = Siguiente
page-photo-looking = Buscando tus líneas de lápiz…
page-photo-all_marked = Todos los puntos están marcados
page-photo-none_left = No quedan puntos por marcar
page-photo-count_right = {$count} bien
page-photo-count_off = {$count} mal
page-photo-count_open = {$count} no se pueden saber con esta imagen
page-photo-count_out = {$count} omitidos
page-photo-see_check = Ver la comprobación
page-photo-on_board = Seguir con ellos en el tablero
page-photo-other_plan = Fotografiar el {$plan}…
page-photo-points = Puntos del {$plan}
page-photo-state_none = sin marcar
page-photo-state_printed = como está impreso
page-photo-state_out = omitido
page-photo-state_right = bien
page-photo-state_off = mal
page-photo-state_open = no se puede saber con esta imagen
page-photo-state_proposed = propuesto
page-photo-aim = Lugar de {$name}. Las flechas lo mueven 0,1 mm, con Mayús 1 mm; Intro lo marca.
page-photo-picture = La fotografía
page-photo-moved = {$name} a {$x} mm, {$y} mm de {$origin}
page-photo-bent = La hoja está curvada {$mm} mm: apriétala para que los lugares sean más seguros.
page-photo-no_decode = Este navegador no puede abrir «{$name}» como imagen.
page-photo-no_decode_hint = Usa una imagen JPEG o PNG. Si el teléfono guarda HEIC: haz la foto desde esta página, o elige «Más compatible» en Cámara, Formatos.
page-photo-no_scene = La escena tiene un error; no hay plano con que comparar.
page-photo-no_scene_hint = Corrige antes la escena, o deshaz el cambio.
page-photo-other_sheet = Esta es la hoja {$number} de {$name}, no de esta escena.
page-photo-other_sheet_hint = Abre aquí ese ejercicio, o fotografía la hoja de este. Si la escena ha cambiado desde que se imprimió la hoja, deshaz el cambio.
page-photo-nameless = otra escena
page-photo-no_plan = Esta hoja tiene el esquema y ningún plano.
page-photo-no_plan_hint = Fotografía la hoja de dibujo, en la que has dibujado el plano.


## The workbench: el tablero de dibujo

page-board-title = Tablero de dibujo
page-board-begin = Dibujar aquí
page-board-go_on = Seguir dibujando
page-board-intro = Dibuje los planos en la pantalla con escuadra, compás de puntas y lápiz. Se nombra la primera recta equivocada.
page-board-close = Volver
page-board-undo = Deshacer (Ctrl+Z)
page-board-redo = Rehacer (Ctrl+Y)
page-board-undone = Deshecho.
page-board-redone = Rehecho.
page-board-fit = Ver toda la lámina
page-board-more = Más
page-board-tools = Herramientas
page-board-sheets = Láminas
page-board-all_sheets = Todas
page-board-sheet = Tablero: {$name}. Las letras eligen herramientas, N va al siguiente lugar posible, Intro pulsa.
page-board-list = Operaciones
page-board-list_none = Todavía no hay nada dibujado.
page-board-class = Clase: {$count} dibujos
page-board-class_minutes = {$minutes} min
page-board-class_away = Guardar la clase
page-board-back_to_here = Deshacer desde aquí
page-board-nothing_here = Aquí no hay nada para esta herramienta.
page-board-write = Dibujar
page-board-own = propio
page-board-hint = Pista
page-board-check = Comprobar
page-board-hand_in = Entregar
page-board-into_form = Al formulario
page-board-handed_in = Los valores están en el formulario.
page-board-handed_in_file = Guardado como {$file}, entre tus descargas. Entrega este archivo a tu profesor. Los valores están en el formulario.
page-board-hand_in_drawn = { $count ->
    [one] Hay {$count} operación dibujada.
   *[other] Hay {$count} operaciones dibujadas.
  }
page-board-hand_in_name = Tu nombre
page-board-hand_in_what = El dibujo se guarda como el archivo {$file}. Entrega ese archivo a tu profesor. Después se corrigen tus valores.
page-board-save = Guardar el dibujo
page-board-open = Abrir un dibujo…
page-board-sheets_pdf = Láminas en papel (PDF)
page-board-no_drawing = «{$name}» no es un dibujo: no tiene `kinegon_drawing`.
page-board-opened = «{$name}» está en el tablero.
page-board-put_back = Volver al anterior
page-board-replay = Reproducir
page-board-end_replay = Volver a dibujar
page-board-look_on = Reproducir lo dibuja operación por operación; el deslizador va a cualquiera de ellas.
page-board-play = Reproducir
page-board-pause = Pausa
page-board-speed = Velocidad de reproducción
page-board-own_construction = Mostrar la construcción
page-board-own_drawing = Volver al dibujo propio
page-board-first_wrong = Primera equivocada: la operación {$number}
page-board-all_right = Está todo, y todo es correcto.
page-board-right_so_far = Hasta aquí, correcto.
page-board-all_there = Está todo lo que se pide.
page-board-leads_nowhere = { $count ->
    [one] La operación {$numbers} no lleva todavía a ningún punto del plano.
   *[other] Las operaciones {$numbers} no llevan todavía a ningún punto del plano.
  }
page-board-others_right = Todas las demás son correctas.
page-board-is_right = correcta
page-board-is_wrong = equivocada
page-board-is_follows = se sigue de una equivocada
page-board-is_unused = no lleva a nada todavía
page-board-is_undone = deshecha
page-board-normal = perpendicular a
page-board-parallel = paralela a
page-board-turned = girada el ángulo
page-board-at_base = desde
page-board-angle = con el ángulo
page-board-other_way = En sentido contrario
page-board-quarter = Girar un cuarto: a lo largo o a través (T)
page-board-as_it_comes = como sale
page-board-sign_back = Quitar la última parte
page-board-ccw = antihorario
page-board-cw = horario
page-board-rubbed = {$name} está borrado, con lo que dependía de él.
page-board-tool_lay_off = Compás de puntas: llevar un vector
page-board-tool_line = Escuadra: recta de dirección conocida
page-board-tool_join = Regla: recta por dos puntos
page-board-tool_cross = Lápiz: punto donde se cortan dos rectas
page-board-tool_like = Imagen: triángulo semejante
page-board-tool_measure = Medir una distancia
page-board-tool_compute = Calculadora
page-board-tool_solve = Resolver ecuaciones
page-board-tool_mark = Lápiz: punto a ojo
page-board-tool_rub = Goma: una cosa y lo que depende de ella
page-board-short_lay_off = Compás
page-board-short_line = Escuadra
page-board-short_join = Regla
page-board-short_cross = Lápiz
page-board-short_like = Imagen
page-board-short_measure = Medir
page-board-short_compute = Calcular
page-board-short_solve = Resolver
page-board-short_mark = Punto
page-board-short_rub = Goma
page-board-form_lay_off = En el {$on} llevar {$size} desde {$from} {$how} {$reference} hasta {$name}
page-board-form_line = En el {$on} recta {$how} {$reference} por {$through} con nombre {$name}
page-board-form_join = En el {$on} recta por {$first} y {$second} con nombre {$name}
page-board-form_cross = {$first} y {$second} se cortan en {$name}
page-board-form_like = En el {$on} como está {$three} respecto de {$one} y {$two} está respecto de {$first} y {$second} el punto {$name}
page-board-form_measure = En el {$on} medir de {$from} a {$to} como {$name}
page-board-form_compute = {$name} = {$as} {$sense}
page-board-form_solve = Para {$solve} resolver {$equations}
page-board-form_mark = En el {$on} punto {$name}
page-board-form_rub = Borrar {$name}
page-board-how_lay_off = Elija el tamaño, pulse el punto donde empieza y luego la barra o recta que da su dirección.
page-board-how_line = Pulse una barra o recta: la escuadra se apoya en ella. Luego pulse el punto por el que pasa la recta. T la gira.
page-board-how_join = Pulse dos puntos.
page-board-how_cross = Pulse donde se cortan dos rectas y elija el nombre del punto.
page-board-how_like = Pulse tres puntos de una barra en el esquema y luego las imágenes de los dos primeros.
page-board-how_measure = Pulse dos puntos.
page-board-how_compute = Elija qué es y escriba cómo se calcula.
page-board-how_solve = Nombre las incógnitas y escriba una ecuación por renglón.
page-board-how_mark = Pulse donde está el punto y elija su nombre.
page-board-how_rub = Pulse la recta o el punto.
page-board-slot_sheet = Lámina
page-board-slot_point = Punto
page-board-slot_scheme = Punto del esquema
page-board-slot_line = Recta
page-board-slot_direction = Barra, guía o recta que da la dirección
page-board-slot_how = Cómo está
page-board-slot_angle = Ángulo desde +x en grados
page-board-slot_formula = Fórmula
page-board-slot_formulas = Ecuaciones, una por renglón
page-board-slot_point_name = Nombre del punto
page-board-slot_line_name = Nombre de la recta
page-board-slot_number_name = Nombre del número
page-board-slot_names = Incógnitas
page-board-slot_sense = Sentido
page-board-slot_base = Recta del plano donde empieza el ángulo, como b,c
page-board-slot_made = Lo dibujado
page-board-which_of = Aquí hay {$count} puntos muy juntos: ¿cuál?
page-board-which_direction = Aquí se cruzan {$count} direcciones: ¿cuál?
page-board-wants_sheet = ¿En qué lámina?
page-board-wants_point = Falta un punto: púlselo o elíjalo.
page-board-wants_scheme = Falta un punto del esquema.
page-board-wants_line = Falta una recta: pulse el cruce o elija dos.
page-board-wants_direction = Falta la dirección: pulse una barra o una recta.
page-board-wants_how = ¿Cómo está?
page-board-wants_angle = Falta el ángulo.
page-board-wants_formula = Falta un número o una fórmula.
page-board-wants_formulas = Faltan las ecuaciones.
page-board-wants_point_name = ¿Qué punto es? Elija su nombre.
page-board-wants_line_name = La recta necesita un nombre.
page-board-wants_number_name = ¿Qué número es? Elija su nombre.
page-board-wants_names = ¿Cuáles son las incógnitas?
page-board-wants_sense = ¿Qué sentido?
page-board-wants_base = ¿En qué recta del plano empieza el ángulo?
page-board-wants_made = Pulse lo que debe irse.


## The workbench: sheets

page-sheets-scheme_short = Esquema
page-sheets-scheme_scaled = Esquema
page-sheets-scheme_panel = Esquema
page-sheets-scheme_name = esquema
page-sheets-scheme_title = Esquema
page-sheets-scheme_from = En el esquema
page-sheets-velocity_short = Velocidad
page-sheets-velocity_scaled = Velocidades
page-sheets-velocity_panel = Plan de velocidades
page-sheets-velocity_name = plano de velocidades
page-sheets-velocity_title = Plano de velocidades
page-sheets-velocity_from = Del plano de velocidades
page-sheets-acceleration_short = Aceleración
page-sheets-acceleration_scaled = Aceleraciones
page-sheets-acceleration_panel = Plan de aceleraciones
page-sheets-acceleration_name = plano de aceleraciones
page-sheets-acceleration_title = Plano de aceleraciones
page-sheets-acceleration_from = Del plano de aceleraciones
page-sheets-centers_short = Centros
page-sheets-centers_scaled = Centros
page-sheets-centers_panel = Centros instantáneos
page-sheets-centers_name = figura de centros instantáneos
page-sheets-centers_title = Centros instantáneos
page-sheets-centers_from = De los centros
page-sheets-forces_short = Fuerzas
page-sheets-forces_scaled = Fuerzas
page-sheets-forces_panel = Plano de fuerzas
page-sheets-forces_name = plano de fuerzas
page-sheets-forces_title = Plano de fuerzas
page-sheets-forces_from = Del plano de fuerzas
page-sheets-lever_short = Palanca
page-sheets-lever_scaled = Palanca
page-sheets-lever_panel = Palanca
page-sheets-lever_name = palanca
page-sheets-lever_title = Palanca
page-sheets-lever_from = De la palanca
page-sheets-speeds_short = Kutzbach
page-sheets-speeds_scaled = Kutzbach
page-sheets-speeds_panel = Diagrama de Kutzbach
page-sheets-speeds_name = diagrama de Kutzbach
page-sheets-speeds_title = Diagrama de Kutzbach
page-sheets-speeds_from = Del diagrama de Kutzbach


## The workbench: refused

page-refused-line = Línea {$line}: {$message}


## The workbench: subject

page-subject-link = Eslabón {$name}
page-subject-slider = Corredera {$name}
page-subject-point = Punto {$name}
page-subject-others = Otras


## The workbench: kinds

page-kinds-title-four-bar = Cuadrilátero articulado
page-kinds-title-slider-crank = Biela-manivela descentrado
page-kinds-title-slotted-lever = Manivela y palanca ranurada (retorno rápido)
page-kinds-title-hydraulic-boom = Pluma con cilindro hidráulico
page-kinds-title-watt-1 = Watt I, seis eslabones
page-kinds-title-stephenson-3 = Stephenson III, seis eslabones
page-kinds-title-whitworth = Retorno rápido de Whitworth
page-kinds-title-toggle-press = Prensa de rodillera
page-kinds-title-five-bar = Cinco eslabones con dos accionamientos
page-kinds-title-platform-3rrr = Plataforma 3-RRR
page-kinds-title-third-class = Grupo de tercera clase
page-kinds-title-fourth-class = Grupo de cuarta clase
page-kinds-title-paper-figure-1 = Quintero et al. (2011), figura 1
page-kinds-title-paper-figure-2 = Quintero et al. (2011), figura 2
page-kinds-title-dyad-rrr = Díada RRR: dos eslabones, tres pernos
page-kinds-title-dyad-rrp = Díada RRP: biela y corredera
page-kinds-title-dyad-rpr = Díada RPR: corredera en la ranura de una palanca
page-kinds-title-dyad-prp = Díada PRP: dos correderas en un perno
page-kinds-title-dyad-rpp = Díada RPP: corredera en la ranura de otra
page-kinds-title-gear-train = Tren de ruedas con rueda loca
page-kinds-title-planetary = Tren planetario
page-kinds-title-planetary-sun-fixed = Tren planetario con el sol fijo
page-kinds-title-planetary-carrier-fixed = Tren planetario con el portador fijo
page-kinds-title-differential = Diferencial con dos accionamientos
page-kinds-title-reverted-train = Tren compuesto revertido
page-kinds-title-sun-and-planet = Engranaje de sol y planeta
page-kinds-title-rack-and-pinion = Piñón y cremallera
page-kinds-title-geared-five-bar = Cinco eslabones con ruedas
page-kinds-title-geneva = Cruz de Malta
page-kinds-title-eccentric-cam = Leva excéntrica con rodillo
page-kinds-title-flat-follower = Leva excéntrica con palanca plana
page-kinds-note-dyad-prp = Como se dibuja en la pizarra. El perno C une las correderas 2 y 3: la 2 desliza sobre el eslabón 1, cuyo movimiento se conoce por entero; la 3, en una guía fija.
page-kinds-note-dyad-rpp = Como se dibuja en la pizarra: un yugo escocés. La corredera 2, articulada en B a una manivela, desliza en el yugo 3, que desliza sobre el bastidor.
page-kinds-note-dyad-rpr = Como se dibuja en la pizarra: «points» da cada coordenada, «known» el movimiento de los pernos exteriores B y D. El plano de aceleraciones tiene un término de Coriolis.
page-kinds-note-dyad-rrp = Como se dibuja en la pizarra: «points» da cada coordenada, «known» el movimiento del perno exterior B. La guía es fija.
page-kinds-note-dyad-rrr = Como se dibuja en la pizarra: «points» da cada coordenada, «known» el movimiento de los pernos exteriores B y D. Los eslabones 1 y 4 son los vecinos, dibujados como tocones.
page-kinds-note-five-bar = Dos grados de libertad y por eso dos accionamientos: las manivelas 1 y 4 mueven el punto C, cada una con su ángulo, su omega y su alpha.
page-kinds-note-four-bar = La manivela 1 mueve el balancín 3 por medio de la biela 2. Los puntos nombrados en dos eslabones son articulaciones entre ellos.
page-kinds-note-fourth-class = Los eslabones 2 y 4 están unidos por los eslabones 3 y 5, que forman el contorno cerrado C-D-F-G. Los planos necesitan un punto especial (de Assur) del eslabón 3 o 5.
page-kinds-note-hydraulic-boom = El cilindro 2 y el vástago 3 son un eslabón entre los pernos A y C cuya longitud cambia el accionamiento: giran juntos, y con la pluma forman una díada.
page-kinds-note-platform-3rrr = Tres grados de libertad, tres accionamientos: las manivelas 1, 2, 3 colocan y giran la plataforma 7 por las patas 4, 5, 6. Plataforma y patas son un grupo de tercera clase.
page-kinds-note-slider-crank = La manivela 1 mueve la corredera 3 por medio de la biela 2.
page-kinds-note-slotted-lever = La manivela 1 gira uniformemente; su perno B lleva la corredera 2, que desliza en la palanca oscilante 3. El plano de aceleraciones tiene un término de Coriolis.
page-kinds-note-stephenson-3 = El punto E de la biela del cuadrilátero A-B-C-D mueve el balancín 5 por el eslabón 4: dos díadas que se resuelven una tras otra.
page-kinds-note-third-class = El eslabón ternario 3 cuelga de tres patas: 2 del perno de la manivela, 4 y 5 del bastidor. Ninguna díada se puede resolver primero: los planos necesitan un punto especial (de Assur) del eslabón 3.
page-kinds-note-toggle-press = La manivela 1 y la biela 2 estiran los eslabones 3 y 4 de la rodillera, que empujan el carro 5 hacia abajo: despacio y con fuerza cerca del final. C es un perno por tres eslabones.
page-kinds-note-watt-1 = Un cuadrilátero A-B-C-D cuya biela 2 y cuyo balancín 3 llevan el segundo lazo C-E-G-F: dos díadas que se resuelven una tras otra.
page-kinds-note-whitworth = La manivela 1 gira uniformemente; la corredera 2 en su perno hace girar del todo la palanca ranurada 3; la biela 4 mueve el carro 5.
page-kinds-note-gear-train = La rueda 1 mueve la rueda 3 por medio de la rueda loca 2, que solo cambia el sentido.
page-kinds-note-planetary = El brazo 1 acciona. El planeta 2 rueda en la corona fija y mueve el sol 3.
page-kinds-note-planetary-sun-fixed = Una sobremarcha: el brazo 1 acciona, el planeta 2 rueda sobre el sol fijo y mueve la corona 3.
page-kinds-note-planetary-carrier-fixed = El sol 1 acciona. El eje de la rueda 2 está quieto, y la corona 3 gira al revés.
page-kinds-note-differential = El sol 3 y la corona 4 accionan; el planeta 2 rueda entre ellos y arrastra el brazo 1.
page-kinds-note-reverted-train = El planeta 2 tiene dos dentados: uno rueda sobre el sol fijo, el otro mueve el sol 3. El brazo 1 acciona.
page-kinds-note-sun-and-planet = James Watt, 1781: la rueda 2 está fija a la biela y rodea la rueda 4, que da dos vueltas por cada vuelta del brazo 1.
page-kinds-note-rack-and-pinion = La manivela 1 y la biela 2 empujan un carro cuya rueda 4 rueda sobre una cremallera fija y mueve la cremallera 5 al doble de la velocidad del carro.
page-kinds-note-geared-five-bar = Las manivelas 1 y 4 son ruedas que engranan: la segunda gira al doble de velocidad y al revés.
page-kinds-note-geneva = Cuatro ranuras. `travel` dice dónde acaba una ranura: la cruz se mueve durante un cuarto de vuelta de la manivela y luego reposa.
page-kinds-note-eccentric-cam = Un disco cuyo centro K está a 20 mm del eje; el eslabón 2, de K al centro C del rodillo, se mueve como el contacto.
page-kinds-note-flat-follower = El disco toca una cara recta de la palanca 2: su centro K se mueve por una recta junto a esa cara, a la distancia del radio del disco.


## The workbench: editor

page-editor-Find = Buscar
page-editor-Replace = Reemplazar
page-editor-next = siguiente
page-editor-previous = anterior
page-editor-all = todos
page-editor-match_case = mayúsculas
page-editor-by_word = palabra entera
page-editor-regexp = expresión regular
page-editor-replace = reemplazar
page-editor-replace_all = reemplazar todos
page-editor-close = cerrar
page-editor-current_match = coincidencia actual
page-editor-on_line = en la línea
page-editor-Fold_line = Plegar
page-editor-Unfold_line = Desplegar
page-editor-folded_code = texto plegado
page-editor-unfold = desplegar
page-editor-Completions = Propuestas
page-editor-Diagnostics = Mensajes
page-editor-No_diagnostics = Sin mensajes


## The component <kinegon-plan>

page-component-none = El plano no tiene escena: dé su dirección en src, o escríbala entre las etiquetas en un script de tipo application/json.
page-component-unread = No se pudo leer {$src} ({$why}).
page-component-from_file = Una página abierta desde un archivo no puede leer otros: escriba la escena entre las etiquetas.
