### Kinegon in Portuguese, in Brazilian spelling, with the terms of the translations of H. H. Mabie, F. W. Ocvirk, Mecanismos, and R. L. Norton, Cinemática e
### Dinâmica dos Mecanismos: elo, manivela, biela, cursor, polígono de velocidades. Ponto especial is made after the source paper. The reader is você, steps stand
### in the infinitive. Blanks that may hold an article never follow de, em, por or a; all three sheets are masculine. docs/terms.md has the terms, `en.ftl` says
### how such a file is written.


## Figures, steps and reports


# Names of links and lines.

ground = base
guide_of = guia de {$slider}
normal_to_guide = a normal à guia de {$slider} por {$point}
line_at_infinity = a reta no infinito

# Steps that are shown together.

join_special_points = {$points}, pontos especiais: onde se cruzam suas retas.
join_lay_off = Traçar {$vectors}.
join_normal = por {$through} ⊥ {$line}
join_parallel = por {$through} ∥ {$line}
join_at_angle = por {$through} com {$angle}
join_cross = As retas {$first} e {$second} se cruzam em {$point}.
join_measure = Medir {$lengths}.
join_rates = Medir {$segments}; resolver para {$unknowns}.
join_images = Imagens de outros pontos: {$points}.

# Steps of the construction.

choose_pole = Escolher o polo {$pole} e a escala {$scale}.
choose_pole_with = Escolher o polo {$pole} e a escala {$scale}; os pontos em repouso têm ali suas imagens: {$images}.
special_point = {$point}, ponto especial do elo {$link}: onde se cruzam {$first} e {$second}.
special_point_at_infinity = {$point}, ponto especial do elo {$link}, está no infinito (direção {$direction}°): {$first} e {$second} são paralelas.
measure_length = Medir o comprimento de {$from} até {$to}.
lay_off_velocity = Traçar a velocidade de {$point}, normal a {$arm}, no sentido de ω_{$link}.
lay_off_velocity_turned = Traçar a velocidade de {$point}, girada, ao longo de {$arm}: na direção de {$from} para {$to}.
lay_off_normal_acceleration = Traçar a aceleração de {$point}, de {$point} para {$pivot}: o elo {$link} gira uniformemente.
lay_off_whole_acceleration = Traçar a aceleração de {$point}: componente normal de {$point} para {$pivot}, componente tangencial normal a {$arm}.
lay_off_given = Traçar a partir do polo o vetor dado {$vector}.
lay_off_given_turned = Traçar a partir do polo o vetor dado {$vector}, girado.
lay_off_point_under = Traçar o vetor conhecido do ponto de {$body} situado sob {$point}.
ray_normal = Traçar por {$through} a reta normal a {$line}; {$image} está sobre ela.
ray_normal_to_guide = Traçar por {$through} a reta normal à {$line}; {$image} está sobre ela.
ray_parallel = Traçar por {$through} a reta paralela à {$line}; {$image} está sobre ela.
ray_parallel_to_line = Traçar por {$through} a reta paralela a {$line}; {$image} está sobre ela.
ray_at_angle = Traçar por {$through} a reta com o ângulo {$angle} do elo, no mesmo sentido; {$image} está sobre ela.
divide = Dividir a reta de {$from} até {$to} na razão {$part} : {$whole}: ali está {$image}.
coincide = O elo {$link} não gira: {$image} está em {$with}.
cross = Marcar {$image} onde as duas retas se cruzam.
measure_segment = Medir o segmento de {$from} até {$to}.
lay_off_normal_part = Traçar a componente normal segundo {$line} em direção a {$centre}, de {$from} até {$to}.
lay_off_normal_parts = Traçar as componentes normais de ambos os elos segundo {$line}, de {$from} até {$to}.
solve = Resolver as equações dos segmentos medidos para {$unknowns}.
solve_wheel = Resolver a equação do segmento medido para {$unknowns}.
solve_wheel_with_mesh = Resolver a equação do segmento medido para {$unknowns}; a equação dos dentes deve dar o mesmo.
solve_meshes = Resolver as equações dos dentes para {$unknowns}.
solve_meshes_accelerated = Resolver as equações dos dentes para {$unknowns}: onde as rodas se tocam são iguais as partes tangenciais das suas acelerações, não as acelerações inteiras.
solve_rims = As rodas têm a mesma velocidade que aquilo em que tocam e que a sua correia; essas equações dão {$unknowns}.
pitch_at_rest = Ali toca uma roda fixa: {$image} está em {$with}.
lay_off_pitch = Com ω_{$link}: traçar a velocidade de {$point} relativa a {$from}, normal a {$arm}; ali ambas as rodas têm a mesma.
lay_off_pitch_turned = Com ω_{$link}: traçar a velocidade de {$point} relativa a {$from}, girada, ao longo de {$arm}; ali ambas as rodas têm a mesma.
no_construction = Para este grupo não há construção com duas retas: suas velocidades e acelerações angulares vêm das equações de malha, e suas imagens são traçadas com elas, elo por elo.
no_construction_far = {$points} no infinito: suas retas são paralelas; as velocidades e acelerações angulares vêm das equações de malha, e as imagens são traçadas com elas, elo por elo.
lay_off_relative = Com ω_{$link}: traçar a velocidade de {$point} relativa a {$from}, normal a {$arm}.
lay_off_relative_turned = Com ω_{$link}: traçar a velocidade de {$point} relativa a {$from}, girada, ao longo de {$arm}.
lay_off_relative_normal = Traçar a aceleração normal de {$point} relativa a {$from}, segundo {$arm} em direção a {$from}.
lay_off_relative_tangential = Com α_{$link}: traçar a aceleração tangencial de {$point} relativa a {$from}, normal a {$arm}.
lay_off_sliding_velocity = Traçar a velocidade de deslizamento de {$slider} ao longo de sua guia, de {$from} até {$to}.
lay_off_sliding_velocity_turned = Traçar a velocidade de deslizamento de {$slider}, girada, normal a sua guia, de {$from} até {$to}.
lay_off_sliding_velocity_backwards = Traçar a velocidade de deslizamento de {$slider} ao longo de sua guia de modo que termine em {$to}: começa em {$from}.
lay_off_sliding_velocity_turned_backwards = Traçar a velocidade de deslizamento de {$slider}, girada, normal a sua guia de modo que termine em {$to}: começa em {$from}.
lay_off_sliding_acceleration = Traçar a aceleração de deslizamento de {$slider} ao longo de sua guia, de {$from} até {$to}.
lay_off_sliding_acceleration_backwards = Traçar a aceleração de deslizamento de {$slider} ao longo de sua guia de modo que termine em {$to}: começa em {$from}.
lay_off_coriolis = Traçar a aceleração de Coriolis de {$slider}, sua velocidade de deslizamento girada 90° no sentido de ω_{$link}, de {$from} até {$to}.
lay_off_coriolis_backwards = Traçar a aceleração de Coriolis de {$slider}, sua velocidade de deslizamento girada 90° no sentido de ω_{$link}, de modo que termine em {$to}: começa em {$from}.

# Words of equations.

given = {" "}(dado)
made_from = {" "}com{" "}
and = {" "}e{" "}
normal = normal
tangential = tangencial
sliding = deslizamento
coriolis = Coriolis

# The text of the steps.

scales = Escalas: {$scales}
scales_by_hand = Escalas da folha de trabalho e dos comprimentos no papel abaixo: {$scales}
scales_of_figure = Escalas da figura: {$scales}
scale_per_mm = {$scale} = {$value} {$unit} por mm
bands = ± é a margem que desenhos cuidadosos à mão (±{$mm} mm, ±{$degrees}°) respeitam, pelo menos 95 em 100.
no_band_no_construction = Um valor não tem ± quando depende de um grupo sem construção (um ponto especial no infinito, ou uma classe superior).
no_band_no_sheet = Um valor não tem ± quando a figura não tem {$panel} e, portanto, não tem escala.
on_the_mechanism = No mecanismo
routes_differ = Os valores desta construção e os das equações de malha diferem em {$difference} do maior; seus cruzamentos admitem {$allowed}.
on_paper = {$mm} mm no papel
only_roughly = , só aproximadamente
direction = direção {$degrees}°
angle_of_crossing = ângulo de cruzamento {$degrees}°

# Instant centres.

permanent_centers = Marcar os centros permanentes: {$centers}.
center_in = {$center} em {$point}
center_of_mesh = {$center} no ponto primitivo
center_normal_to = {$center} no infinito, normal à guia de {$guide}
center_line = Unir {$first} e {$second}; {$center} está sobre esta reta.
center_line_towards = Traçar por {$first} a reta para {$second}, no infinito; {$center} está sobre ela.
center_cross = Marcar {$center} em {$first} e {$second}.
center_parallel = {$center} está no infinito: {$first} e {$second} são paralelas.
center_along = {$center} está no infinito ao longo de {$line}: a outra reta é a do infinito.
leave_out = Retirar o elo {$link} e unir rigidamente {$first} e {$second}: o centro está então em {$center}.
centers_by_rates = Nenhuma reta leva a {$centers}: das velocidades calculadas.
rate_by_centers = Calcular {$rate}: em {$center} os elos {$driver} e {$link} têm a mesma velocidade.
velocity_by_centers = Traçar {$vector}, normal ao raio {$from} {$point}.
rate_by_slide = Calcular {$rate}: em {$center} o elo {$link} tem a velocidade {$velocity}, ao longo da guia.
velocity_along_guide = Traçar {$vector} ao longo da guia de {$guide}: todos os pontos do elo têm essa velocidade.
collineation_axis = Unir {$first} e {$second}, e os centros de curvatura das suas trajetórias, {$first_center} e {$second_center}: as retas cortam-se em {$crossing}. O eixo de colineação vai de {$pole} até lá.
pole_tangent = Traçar a tangente polar t do elo {$link} por {$pole}: a partir do raio a {$first}, com o ângulo que vai do eixo ao raio a {$second} (Bobillier).
axis_of_point = Traçar o raio de {$pole} a {$point} e, a partir dele, com o ângulo que vai da tangente ao raio a {$pin}, o eixo de ambos: corta a reta de {$point} e {$pin} em {$crossing}.
center_of_curvature = A reta dali a {$fixed} marca no raio {$center}, o centro de curvatura da trajetória de {$point}.
path_inflection = A reta dali a {$fixed} é paralela ao raio: a trajetória de {$point} tem uma inflexão.
inflection_point = Medir as distâncias de {$pin} a {$pole} e a {$fixed}. Sobre o raio, de {$pin} para {$fixed}, J passa por uma inflexão da sua trajetória (Euler e Savary).
inflection_in_pin = {$fixed} está no infinito: o próprio {$pin} passa por uma inflexão, e é J.
inflection_pole = A normal ao raio em {$point} e a normal à tangente polar em {$pole} cortam-se em {$found}, o polo de inflexões: a circunferência sobre {$pole} {$found} é a de inflexões.
inflections_differ = Os polos de inflexões destas retas e os do movimento calculado diferem em {$difference} do diâmetro ou do mecanismo; os cortes permitem {$allowed}.
curvatures_differ = Os centros de curvatura por estas retas e pelo movimento calculado diferem em {$difference} do raio ou do mecanismo; os cruzamentos permitem {$allowed}.
velocity_of_center = Traçar {$vector}, a de {$center}: o elo {$link} não gira.
centers_differ = Os centros por estas retas e os do movimento calculado diferem em {$difference} do tamanho do mecanismo; os cruzamentos permitem {$allowed}.

weight_letter = P
one_link = o elo {$link}
several_links = os elos {$links}
force_moments = Momentos em relação a {$point}, {$links}: {$force}.
force_moments_crossing = Momentos em relação ao cruzamento das linhas de {$first} e {$second}, {$links}: {$force}.
force_couple = Momentos em relação a {$point}, {$links}: {$couple}, com o qual a força na guia de {$guide} atua ao lado de {$point}.
force_begin = Polígono, {$links}, em {$scale}: traça-se {$force}.
force_lay_off = Traça-se {$force}.
force_direction = Traça-se a direção de {$force}.
force_cross = O cruzamento dá {$first} e {$second}.
force_close = {$force} fecha o polígono.
force_sum = {$force} é a soma das suas componentes.
force_inner = {$force} fecha o polígono só para {$links}.
force_push = Ao longo da guia de {$guide} o acionamento empurra com {$force}.
forces_by_numbers = Para as reações, {$links}, não há aqui construção: são traçadas a partir das equações de equilíbrio.
force_polygon = Polígono, {$links}: traçam-se {$known}.
force_polygon_closed = Fecham-no {$forces}.
force_polygon_joined = Os vértices dão {$forces}.
forces_differ = As forças destes polígonos e das equações de equilíbrio diferem em {$difference} da maior força; o arredondamento e os cruzamentos permitem {$allowed}.
lever_turn = Gira-se o plano de velocidades 90° no sentido horário: é uma alavanca.
lever_turn_for = Giram-se as velocidades 90° no sentido horário, enquanto {$drive} anda à taxa 1 e os outros acionamentos param: formam uma alavanca.
lever_arm = {$force} atua na imagem do seu ponto: mede-se o braço.
lever_effort = Os momentos em relação ao polo dão {$effort}: nenhuma reação tem momento.
speeds_train = Traça-se a linha dos centros com centros e pontos primitivos na escala dos comprimentos; as velocidades marcam-se normais a ela.
speeds_given = Marcam-se as velocidades de {$from} e {$to}: todas as velocidades de {$link} na linha dos centros terminam na reta pelas suas pontas.
speeds_line = {$from} e {$to} têm velocidades já conhecidas: as de {$link} terminam na reta pelas suas pontas.
speeds_pole = Escolhe-se um ponto o e uma base por baixo, à distância que torna redonda a escala das velocidades angulares.
speeds_ray = A paralela por o à reta de {$link} corta {$rate} na base.
speeds_slides = {$link} desliza: todos os seus pontos têm a velocidade de {$at}.
speeds_slides_given = Marca-se a velocidade de {$at}: {$link} desliza, e todos os seus pontos a têm.
speeds_belt = A correia dá às duas rodas a mesma velocidade periférica: {$to} tem a velocidade de {$from}.
speeds_turned = No diagrama de Kutzbach os centros fora da linha são rodados até ela, e distâncias e velocidades ficam como estão: {$points}.
speeds_unsized_belt = o diagrama de Kutzbach deixa de fora a correia de {$first} e {$second}: não se sabe o tamanho das suas rodas; indique o seu `radius`
speeds_none = não há diagrama de Kutzbach: não há duas rodas que engrenem ou tenham correia, e nenhuma rola sobre uma cremalheira
speeds_left_out = o diagrama de Kutzbach é o da linha dos centros por {$line}; o que se toca em {$meshes} está noutra reta e não se pode rodar até ela

# The figure.

title = Polígonos de velocidades e acelerações
scheme = Esquema
velocity_plan = Polígono de velocidades
# Its velocities are drawn turned by 90°, one way or the other.
turned_plan = {$plan}, girado de {$angle}°
acceleration_plan = Polígono de acelerações
centers = Centros instantâneos
force_plan = Plano de forças
lever = Alavanca
speeds = Diagrama de Kutzbach
far_away = {$point}: a {$distance} de {$from}
far_in_plan = até {$point}: {$distance}
cut_at_edge = cortado na borda
names_without_room = não cabem todos os nomes
names_left_out = não cabem:
loads_without_scale = As cargas são desenhadas sem escala.
friction_told = O atrito encontra-se com as forças: F^{"{"}f{"}"} = μ |N| ao longo de guias, M^{"{"}f{"}"} = ρ |R| em pinos, ρ o raio do círculo de atrito.
at_infinity = {$point} no infinito
paths = Marcas na trajetória de {$points}: a cada {$step} do acionamento {$drive}.
paths_in_time = Marcas na trajetória de {$points}: a cada {$step} do acionamento {$drive}, ou seja, a cada {$time}.
path_of = Trajetória de {$point} em {$unit}
mode = modo {$number}
contact_link = O elo {$link} equivale ao contato de {$first} e {$second}: une seus centros de curvatura {$from} e {$to}.
contact_face = Um pino em {$center}, o centro de curvatura de {$first}, que desliza ao longo da face plana de {$second} equivale ao seu contato.
contact_here = Isso vale só nesta posição.
equivalent = {$link} (equivalente)
modes_left_out = Dos outros modos de montagem só são desenhados os primeiros {$count}.
centrodes = Polares do elo {$links}, perto do mecanismo: a fixa em traço contínuo, a móvel tracejada.
no_centrodes = O elo {$links} gira em torno de um ponto fixo ou não gira: não tem polares.
inflection_circle = Circunferência de inflexões do elo {$link}: diâmetro {$diameter}, pelo centro instantâneo {$center} e pelo polo de inflexão {$pole}.
no_inflection_circle = O elo {$link} gira em torno de um ponto fixo ou não gira: não tem circunferência de inflexões.
no_centers = {$centers}: os elos estão em repouso relativo e não têm centro instantâneo aqui.
no_velocities_by_centers = Velocidade de {$points} por centros: não encontrada. São precisos um só acionamento que se mova e centros do elo do ponto que não coincidam.
no_curvatures = Curvatura da trajetória de {$points}: não encontrada. São precisos dois pinos do elo em manivelas ou em blocos no quadro, e um centro do elo que não seja fixo.
too_many_for_lines = As retas até centros instantâneos procuram-se em mecanismos de no máximo {$most} elos: estes centros vêm das velocidades calculadas.
radius_of_curvature = Raio de curvatura da trajetória de {$point}: {$radius}.
no_radius_of_curvature = A trajetória de {$point} tem uma inflexão.
paths_beyond = Tracejado: além dos limites do acionamento.
agreement = Construção e equações de malha concordam: diferem em {$difference} do maior valor (os cruzamentos admitem {$allowed}).
one_route_far = Um ponto especial está no infinito: os valores vêm só das equações de malha.
one_route = Um grupo não tem construção com duas retas: os valores vêm só das equações de malha.
printed = Impresso a 100 %, mm × μ é o valor.
with_direction = {$size}, direção {$degrees}°
segment = segmento
value = valor
values = Valores
ruler = Impresso a 100 %, isto mede 50 mm

# The text that stands for a figure where it cannot be seen.

description = Contém: {$panels}. Grupos de Assur: {$groups}.
named_scheme = esquema
named_velocity_plan = polígono de velocidades
named_acceleration_plan = polígono de acelerações
named_centers = centros instantâneos
named_force_plan = plano de forças
named_lever = alavanca
named_speeds = diagrama de Kutzbach
described_scheme = o mecanismo em escala
described_velocity_plan = seu polígono de velocidades
described_acceleration_plan = seu polígono de acelerações
described_centers = seus centros instantâneos
described_force_plan = o seu plano de forças
described_lever = a sua alavanca
described_speeds = o seu diagrama de Kutzbach
described_group = classe {$class}, elos {$links}
higher = superior

# Curves.

curves = Curvas
hodograph = Hodógrafo de {$vector}
willis_all = com o suporte
willis_turns = voltas
willis_held = suporte parado
willis_together = soma
angle = Ângulo
angular_velocity = Velocidade angular
rotational_speed = Velocidade de rotação
speed_ratio = Relação de velocidades angulares
angular_acceleration = Aceleração angular
position = Posição
length = Comprimento
velocity = Velocidade
acceleration = Aceleração
force = Força
moment = Momento
power = Potência
in_unit = {$kind} em {$unit}
drive_angle = Ângulo {$symbol} do acionamento em °
drive_position = Posição do acionamento {$drive} em {$unit}

# The legend of curves.

limit = limite
change = mudança
scene = dada
dead_centre = ponto morto
extremes = valor máximo, mínimo

# The text that stands for curves where they cannot be seen.

over = Em função de {$drive}, de {$from} até {$to}:
is_constant = {$quantity} é {$value}
least = mínimo {$value} em {$at}
greatest = máximo {$value} em {$at}
no_least = mínimo ilimitado
no_greatest = máximo ilimitado

# Special positions in the range of a drive; `place` is the drive's value, as in `angle(1) = 30°`.

event_limit = posição limite em {$place}: os elos {$links} não podem ir além; suas velocidades e acelerações crescem sem limite
event_runs_off = posição limite em {$place}: os elos {$links} se afastam até o infinito
event_change = ponto de mudança em {$place}: os elos {$links} também poderiam seguir em outro modo; segue-se o movimento suave, e ali velocidades e acelerações são omitidas
event_singular = posição singular perto de {$place}: não é possível seguir os elos {$links} através dela
event_turns_back = posição extrema em {$place}: o elo {$link} se detém em {$angle}° e inverte seu giro
event_slides_back = posição extrema em {$place}: o cursor {$slider} se detém em {$position} e inverte seu deslizamento
event_leaves = fim do curso em {$place}: o cursor {$slider} deixa sua guia em {$position}
engaged = A ranhura está engatada com {$drive} de {$from} a {$to}, {$held} de uma volta; durante os outros {$free} ela repousa.
events_left_out = seguem mais {$count} posições extremas ou pontos de mudança
rates_of_every_position = cada posição tem o ω e o α que a cena dá ao acionamento: não é uma partida, em que ω mudaria

# The structure: Assur groups in solving order.

structure_freedoms = graus de liberdade: {$count}, tantos quantos os acionamentos
structure_known = movimentos conhecidos: {$motions}
structure_drives = acionamentos: {$count}; movimentos conhecidos: {$motions}
structure_positions = posições a partir de {$angle}: {$groups}
structure_group = elos {$links}: classe {$class}, {$shape}
structure_special_points = pontos especiais {$points}
shape_second = dois elos
shape_third = um elo central sobre três pernas
shape_fourth = dois elos de arrasto unidos por dois elos de fechamento, um contorno fechado de quatro
shape_higher = mais elos do que têm as classes II a IV, ou unidos de outra forma
structure_wheel = elo {$link}: uma só roda, que gira pelo que toca

# The list of assembly modes.

modes = {$count ->
    [one] {$count} modo de montagem
   *[other] {$count} modos de montagem
}
modes_at_least = pelo menos {$count}
modes_listed = {$modes}, listam-se os primeiros {$listed}
modes_heading = {$modes}; coordenadas em {$unit}, ângulos em graus
modes_of_group = elos {$links}: {$found} achados, {$most} no máximo

# The report on a student's values.

check_counts = Corretos: {$right}; dentro da tolerância do lápis: {$within}; fora: {$off}
check_counts_and_senses = Corretos: {$right}; dentro da tolerância do lápis: {$within}; sem sentido indicado: {$missing}; fora: {$off}
check_right = correto
check_within = na tolerância
check_sense_missing = falta o sentido
check_senses = Falta o sentido: o módulo está correto, mas um número sem sinal não diz o sentido. Escreva + ou − antes dele, ou "positive": "counter-clockwise" no formulário.
check_off = FORA
check_off_turned = FORA: girado {$degrees}°
check_cannot_tell = não se pode dizer
check_missing = Em falta: {$count} de {$asked} pedidos: {$values}.
check_missing_many = Em falta: {$count} de {$asked} pedidos: {$values} e mais {$more}.
check_coarse_digits = Com tão poucos algarismos não dizem nada: {$values}. Escreva pelo menos dois que não sejam zero.
check_rough_places = Conhecidos com imprecisão demais para serem julgados: {$values}. Um raio atrás de um lugar conta até {$mm} mm.
check_too_small = Pequenos demais na folha para serem julgados: {$values}. Mesmo uma mão cuidadosa poderia não encontrar nada ali.
check_coarse = Sem construção gráfica, por isso admite-se até {$percent} % (num ângulo, {$degrees}°): {$values}.
check_all_larger = Todos os comprimentos são {$percent} % grandes demais: a folha foi impressa ajustada à página? São julgados sem contar isso.
check_all_smaller = Todos os comprimentos são {$percent} % pequenos demais: a folha foi impressa ajustada à página? São julgados sem contar isso.
check_all_longer = Todos os comprimentos são {$mm} mm longos demais: a régua foi lida a partir da ponta, ou a partir de {$mm}? São julgados sem contar isso.
check_all_shorter = Todos os comprimentos são {$mm} mm curtos demais: foi a ponta da régua que ficou sobre o ponto? São julgados sem contar isso.
check_other_scale = {$scale}: seu formulário indica {$stated}, o exercício {$asked}; seus valores são julgados com a escala do formulário.
check_no_such_scale = {$scale} = {$stated}: nenhuma folha pode mostrar assim o {$sheet}; admite-se o mesmo que em um desenho com {$used}.
column_quantity = grandeza
check_column_written = medido
check_column_expected = esperado
check_column_difference = diferença
check_column_on_paper = no papel
check_column_percent = em %
check_column_allowed = admitido
check_column_verdict = veredito
check_tolerance = O que se admite aqui é o quanto um desenho cuidadoso pode se desviar (±{$mm} mm, ±{$degrees}° em cada traço).
check_accuracy = Seu desenho tem precisão de cerca de {$mm} mm e {$degrees}°, como mostra a dispersão de todos os valores.
check_slips = Seus números calculados diferem em até cerca de {$percent} %.
check_wider = Por isso se admite mais do que a uma mão cuidadosa (±{$mm} mm, ±{$degrees}°).
check_too_coarse = Pedia-se uma mão de ±{$mm} mm e ±{$degrees}°.
check_probably = O que provavelmente aconteceu
check_nothing = Tudo correto.
check_so_far = Nenhum valor está fora: {$good} de {$asked} estão corretos, os outros não são conhecidos.
check_tells_nothing = Estes valores não dizem nada, nem certo nem errado.
check_no_single = Nenhum erro sozinho explica isto. Juntos, estes explicam:
check_none = Algo está errado a partir do passo {$number}: {$value} é o primeiro valor que difere. Não é possível dizer a causa.
check_step = Passo {$number}
check_whole = Todo o desenho
check_instead = O correto
check_follows = Disso decorrem, e são coerentes com isso: {$values}.
check_follows_none = Nenhum outro dos seus valores decorre disso.
check_values_of = Estes são os valores de outro exercício: {$exercise}.
check_worked = Com os seus números: {$calculation}.
check_worked_beside = Com os seus números: {$calculation}; você tem {$own}.
check_seems_left = Parece girado {$degrees}° para a esquerda.
check_seems_right = Parece girado {$degrees}° para a direita.
check_seems_longer = Parece {$mm} mm longo demais.
check_seems_shorter = Parece {$mm} mm curto demais.
check_seems_elsewhere = O ponto parece estar a {$mm} mm de onde suas duas retas se cruzam: visto de {$first}, está {$one}° ao lado de sua reta; visto de {$second}, {$other}°.
check_redo = Refaça os passos {$steps}; mantenha o resto.
check_redo_one = Refaça o passo {$step}; mantenha o resto.
check_redo_number = Corrija só este número; o desenho fica.
check_sure = Certeza: {$percent} %
check_others = Também poderia ser
check_perhaps = Talvez tenha sido isto
check_hint_plan = Reveja o seu {$plan}.
check_hint_whole = Reveja o desenho inteiro: sua posição, sua escala, seus sentidos.
check_hint_value = O primeiro valor que difere é {$value}.
check_alike = só pelos seus valores não se distingue isto do anterior
check_unexplained = Sem explicação: {$values}.
check_not_looked = Em uma construção tão grande não se buscam causas.
check_looked_at = Um formulário tão grande é examinado em parte: só nos primeiros {$count} valores se buscam causas.
check_mirrored = Os pontos do seu {$plan} são a imagem espelhada dos corretos: todos os sentidos ficam invertidos. Se você mediu y para baixo na folha, meça para cima.
check_turned_left = Todo o seu {$plan} está girado {$degrees}° para a esquerda. Se a folha não foi posta assim, foi o primeiro vetor.
check_turned_right = Todo o seu {$plan} está girado {$degrees}° para a direita. Se a folha não foi posta assim, foi o primeiro vetor.

# A student's drawing over the right figure.

check_key_right = como deve ser
check_key_own = o seu (nomes com *)
check_key_wrong = onde está o erro
check_follows_marked = Disso decorrem, e são coerentes com isso, {$count} valores com a marca {$mark} na tabela.
check_beyond = {$point}: {$mm} mm além
check_turned = Os pontos do seu {$plan} são mostrados girados {$degrees}°, como melhor se ajustam.

# Photographs of drawings.

photo_column_point = ponto
photo_column_right = correto mm
photo_column_found = visto mm
photo_column_off = afastado mm
photo_column_band = ± mm
photo_cannot_tell = não se pode saber com esta foto
photo_left = não encontrado
photo_sheet = {$file}: folha {$number} de {$name}

# What fills the blanks of mistakes' sentences.

line_cut = a reta traçada para achar {$point}
line_guide = a guia de {$slider}
line_through = a reta {$points}
all_segments = todos os segmentos da folha
all_lengths = todos os comprimentos
all_velocities = todas as velocidades
all_accelerations = todas as acelerações
all_angular_velocities = todas as velocidades angulares
all_angular_accelerations = todas as acelerações angulares
all_forces = todas as forças
all_moments = todos os momentos
horizontal = horizontal
vertical = vertical

# Marks, and the summary of a class.

class_marks = Pontos: {$earned} de {$of}
class_marks_following = Pontos: {$earned} de {$of}, {$follow} deles por valores que decorrem de um erro
class_counts = {$files ->
    [one] {$files} arquivo: {$passed} aprovados, {$off} com erros, {$broken} não entendidos
   *[other] {$files} arquivos: {$passed} aprovados, {$off} com erros, {$broken} não entendidos
}
class_incomplete = {$count} sem nenhum valor fora, mas incompletos
class_common = {$count} de {$of}: passo {$step}, {$done}
class_common_whole = {$count} de {$of}: todo o desenho, {$done}
class_unknown = {$count} de {$of}: há valores fora, a causa não é conhecida
class_not_understood = Este formulário não foi entendido. Entregue-o de novo quando isto estiver corrigido:

# The sheets of exercises.

exercise_given = Dados: {$all}.
exercise_draw = Desenhar os polígonos com {$scales}. Medir, também nesta folha, e preencher os campos.
exercise_centers = Achar os centros instantâneos com {$scales}. Medir e preencher os campos; as coordenadas contam-se da origem dos lugares dados.
exercise_forces = Achar as forças com momentos e polígonos de forças com {$scales}; os braços medem-se nesta folha. Medir e preencher os campos. Um R indica uma junta e o elo sobre o qual atua ali.
exercise_lever = Achar o que o acionamento precisa com a alavanca de Jukovski com {$scales}: forças nas imagens dos seus pontos. Medir e preencher os campos.
exercise_guide = guia de {$slider} por {$place} a {$degrees}°
exercise_guide_through = guia de {$slider} segundo {$line}
exercise_wheel = roda {$link} ({$teeth} dentes)
exercise_ring = coroa {$link} ({$teeth} dentes)
exercise_fixed_wheel = roda fixa ({$teeth} dentes)
exercise_fixed_ring = coroa fixa ({$teeth} dentes)
exercise_mesh = engrenamento de {$first} com {$second}
exercise_mesh_on = engrenamento de {$first} com {$second} sobre o braço {$arm}
exercise_room = O polígono de velocidades ocupa {$velocity}, o de acelerações {$acceleration}: desenhar cada um em {$paper} ou maior.
exercise_sheets = Seguem as folhas para os polígonos.
exercise_center_sheet = Segue uma folha para os centros instantâneos.
sheet_markers = Foto: folha plana, os oito quadrados à vista.
exercise_senses = Sinais: anti-horário é +.
exercise_senses_of_slides = Sinais: anti-horário é +; {$slides}: + segundo a seta marcada com +.
exercise_points = Pontos: {$all}.
exercise_normal_ends = {$points}: extremo de uma componente normal
exercise_coriolis_ends = {$points}: extremo de uma componente de Coriolis
exercise_sliding_ends = {$points}: extremo de uma componente de deslizamento
exercise_name = Nome: ………………………………… Data: ………………
exercise_allowed = ± é o quanto uma mão cuidadosa pode errar.

# Exercises in a course.

course_digits = Escrever cada valor com três algarismos significativos, na unidade ao lado do seu campo.
course_other_sense = O módulo está correto, o sentido não.
course_cause = Causa provável: {$told}
course_follows = Este valor decorre disso.
course_picture = O mecanismo em escala
course_print = Folha para imprimir em tamanho real
course_key = O mecanismo com os dois polígonos
course_if = Se você obteve {$value}:


## Mistakes: what was probably done, and what it should be

turned_ray-done = a reta de {$from} até {$to} foi traçada girada 90°: paralela em vez de perpendicular, ou o contrário
turned_ray-should = a reta de um movimento relativo entre dois pontos de um mesmo elo é normal à linha que os une; só a de um deslizamento é paralela à sua guia
turned_rays-done = as retas de {$from} até {$to} e de {$other} a {$to} foram traçadas giradas 90°: paralelas em vez de perpendiculares, ou o contrário
turned_rays-should = a reta de um movimento relativo entre dois pontos de um mesmo elo é normal à linha que os une; só a de um deslizamento é paralela à sua guia
turned_cut_line-done = a reta por {$joint} para achar {$point} foi traçada ao longo da guia
turned_cut_line-should = {$point} está sobre a normal à guia por {$joint}
ray_from_wrong_point-done = a reta até {$image} foi traçada por {$wrong}
ray_from_wrong_point-should = parte de {$right}, onde termina o conhecido da equação vetorial
wrong_lines-done = {$point} foi marcado sobre {$wrong}
wrong_lines-should = {$point} está sobre {$right}
reversed_vector-done = o vetor de {$from} até {$to} foi traçado com o sentido contrário
reversed_vector-should = aponta de {$from} para {$to}, no sentido em que gira ou desliza o seu elo
turned_vector-done = o vetor de {$from} até {$to} foi traçado girado 90°
turned_vector-should = uma velocidade ou uma aceleração tangencial é normal à linha que une os dois pontos; uma aceleração normal segue essa linha
turned_vectors-done = o vetor de {$from} até {$to} foi traçado desviado {$degrees}° em ambos os polígonos
turned_vectors-should = a velocidade é normal à manivela; a aceleração normal segue a manivela até o seu centro de giro
vector_from_wrong_point-done = o vetor até {$end} foi traçado a partir de {$wrong}
vector_from_wrong_point-should = parte de {$right}
normal_outward-done = a aceleração normal {$rate}² {$length}, de {$from} até {$to}, foi traçada para fora
normal_outward-should = a aceleração normal aponta para o ponto em torno do qual o elo gira
normals_outward-done = as acelerações normais {$vectors} foram traçadas para fora
normals_outward-should = a aceleração normal aponta para o ponto em torno do qual o elo gira
omega_not_squared-done = para a aceleração normal de {$from} até {$to} foi tomado {$rate} em vez do seu quadrado
omega_not_squared-should = a aceleração normal é {$rate}² {$length}
omegas_not_squared-done = para as acelerações normais {$vectors} foi tomado ω em vez do seu quadrado
omegas_not_squared-should = uma aceleração normal é ω² vezes o comprimento
omega_of_another_link-done = para o vetor de {$from} até {$to} foi tomado {$wrong} em vez de {$rate}
omega_of_another_link-should = ao vetor correspondem {$rate} e {$factor}
omegas_interchanged-done = nas acelerações normais foram tomados {$rate} e {$wrong} um no lugar do outro, primeiro de {$from} até {$to}
omegas_interchanged-should = a cada aceleração normal corresponde a velocidade angular do seu próprio elo: à de {$from} até {$to}, {$rate}
diameter-done = a aceleração normal {$rate}² {$length}, de {$from} até {$to}, saiu com o dobro do valor, como com o diâmetro
diameter-should = a aceleração normal é {$rate}² vezes o raio {$length}
diameter_throughout-done = em velocidade e aceleração foi tomado como raio o dobro de {$length}, como com o diâmetro ou o curso
diameter_throughout-should = tomar o raio {$length}
half_the_radius-done = em velocidade e aceleração foi tomada como raio a metade de {$length}
half_the_radius-should = {$length} é o raio, não o diâmetro
normal_from_absolute-done = a aceleração normal segundo {$length}, de {$from} até {$to}, foi calculada com a velocidade {$velocity}
normal_from_absolute-should = calcula-se com a velocidade relativa: {$rate}² {$length}
normal_forgotten-done = foi esquecida a aceleração normal {$rate}² {$length}, de {$from} até {$to}
normal_forgotten-should = traçar {$rate}² {$length} antes da reta
normals_forgotten-done = foram esquecidas as acelerações normais {$vectors}
normals_forgotten-should = traçar ω² vezes o comprimento antes de cada reta
tangential_where_none-done = à aceleração normal de {$from} até {$to} foi somada uma tangencial {$rate} {$length}
tangential_where_none-should = {$rate} não muda, portanto não há aceleração tangencial: a aceleração é {$rate}² {$length}
coriolis_forgotten-done = foi esquecida a aceleração de Coriolis, de {$from} até {$to}
coriolis_forgotten-should = traçar 2 {$rate} {$velocity} normal à guia
coriolis_without_two-done = a aceleração de Coriolis, de {$from} até {$to}, foi tomada sem o seu fator 2
coriolis_without_two-should = é 2 {$rate} {$velocity}
coriolis_turned-done = a aceleração de Coriolis, de {$from} até {$to}, foi traçada com o sentido contrário
coriolis_turned-should = tem a direção de {$velocity} girada 90° no sentido de {$rate}
coriolis_along-done = a aceleração de Coriolis, de {$from} até {$to}, foi traçada ao longo da guia
coriolis_along-should = é normal à guia: tem a direção de {$velocity} girada 90° no sentido de {$rate}
coriolis_velocity-done = a aceleração de Coriolis, de {$from} até {$to}, foi calculada com a velocidade {$wrong}
coriolis_velocity-should = calcula-se com a velocidade de deslizamento: 2 {$rate} {$velocity}
coriolis_velocity_and_omega-done = a aceleração de Coriolis, de {$from} até {$to}, foi calculada com {$omega} e a velocidade {$wrong}
coriolis_velocity_and_omega-should = calcula-se com a rotação da guia e a velocidade de deslizamento: 2 {$rate} {$velocity}
coriolis_where_none-done = foi somada uma aceleração de Coriolis a {$rate}² {$length}, de {$from} até {$to}, onde nada desliza
coriolis_where_none-should = só há aceleração de Coriolis onde algo desliza sobre um elo que gira
coriolis_at_rest-done = foi traçada uma aceleração de Coriolis 2 {$rate} {$velocity} a partir de {$from}, antes da reta até {$to}
coriolis_at_rest-should = a guia está em repouso: só há aceleração de Coriolis onde algo desliza sobre um elo que gira
mirrored_image-done = {$point} foi traçado do lado errado de {$start} {$other}: a imagem do elo fica espelhada
mirrored_image-should = a imagem de um elo é semelhante ao elo, girada mas nunca espelhada
beyond_end-done = {$point} foi marcado do lado errado de {$start}, sobre a linha de {$start} e {$other}
beyond_end-should = as imagens estão na sua linha na mesma ordem que os pontos no elo
wrong_ratio-done = a reta de {$from} até {$to} foi dividida a partir do extremo errado: {$point} tem de {$from} a distância que deveria ter de {$to}
wrong_ratio-should = a imagem divide a reta das imagens como o ponto divide a reta dos pontos
inverse_ratio-done = {$point} tem a razão inversa: as distâncias de {$from} a {$point} e de {$from} até {$to} estão trocadas
inverse_ratio-should = a imagem divide a reta das imagens como o ponto divide a reta dos pontos
distances_exchanged-done = {$point} tem de {$from} a distância que deveria ter de {$to}, e vice-versa
distances_exchanged-should = a imagem de um elo é semelhante ao elo: cada ângulo do seu triângulo está no seu próprio extremo
distances_exchanged_and_mirrored-done = {$point} ficou do lado errado da linha de {$from} até {$to}, e com as distâncias a ambos trocadas
distances_exchanged_and_mirrored-should = a imagem de um elo é semelhante ao elo: cada ângulo do seu triângulo está no seu próprio extremo
wrong_segment-done = para {$segment} foi medido o segmento de {$from} até {$to}
wrong_segment-should = medir {$segment}
component-done = de {$segment} foi medida só a componente {$axis}
component-should = medir o comprimento verdadeiro de {$from} até {$to}
wrong_length-done = para {$length} foi tomado o comprimento de {$from} até {$to}
wrong_length-should = tomar {$length}
wrong_length_throughout-done = para {$length} foi tomado o comprimento de {$from} até {$to}, em todo lugar onde se usa
wrong_length_throughout-should = tomar {$length}
omega_from_wrong_length-done = {$rate} foi obtido com o comprimento de {$from} até {$to}
omega_from_wrong_length-should = dividir por {$length}
omega_and_normal_from_wrong_length-done = {$rate} e a aceleração normal até {$normal} foram obtidos com o comprimento de {$from} até {$to}
omega_and_normal_from_wrong_length-should = tomar {$length} em ambos
alpha_from_wrong_length-done = {$rate} foi obtido com o comprimento de {$from} até {$to}
alpha_from_wrong_length-should = dividir por {$length}
not_divided_by_length-done = para {$rate} o segmento não foi dividido por {$length}
not_divided_by_length-should = dividir por {$length}
wrong_sense-done = {$rate} foi tomado com o sentido contrário
wrong_sense-should = o sentido se deduz da direção do segmento no polígono e do lado em que fica a sua linha no mecanismo
wrong_sense_given-done = {$rate} foi tomado com o sentido contrário: o vetor de {$from} até {$to} aponta ao contrário
wrong_sense_given-should = o sentido de {$rate} é dado
senses_reversed-done = os sentidos de todas as velocidades e acelerações angulares estão invertidos, como se o horário fosse o positivo
senses_reversed-should = o sentido anti-horário é o positivo
revolutions_for_radians-done = {$rate} não foi convertido entre rotações por minuto e radianos por segundo
revolutions_for_radians-should = rad/s = rpm · π/30
rate_in_other_unit-done = {$rate}: o dado é {$number} {$given}; foi tomado como {$number} {$taken}
rate_in_other_unit-should = continuar com {$number} {$given}
all_in_other_unit-done = {$values}, como {$first}, estão em {$unit}, e nenhuma unidade o diz
all_in_other_unit-should = escrever {$unit} ao lado, ou os valores em {$own}
value_for_paper-done = {$quantity}: {$number} é o valor em {$unit}; pedem-se milímetros de papel
value_for_paper-should = {$number} : {$scale} = {$mm} mm no papel
values_for_paper-done = {$segments}: foram escritos valores em {$unit}; pedem-se milímetros de papel
values_for_paper-should = um valor dividido por {$scale} é seu comprimento no papel em milímetros
common_factor_degrees-done = {$values}, como {$first}, valem {$factor} vezes o que deveriam
common_factor_degrees-should = todo produto toma as velocidades angulares em radianos por segundo: 1 rad são 57,2958°
common_factor_turns-done = {$values}, como {$first}, valem {$factor} vezes o que deveriam
common_factor_turns-should = todo produto toma as velocidades angulares em radianos por segundo: 1 volta são 2π rad
common_factor_rpm-done = {$values}, como {$first}, valem {$factor} vezes o que deveriam
common_factor_rpm-should = todo produto toma as velocidades angulares em radianos por segundo: 1 rad/s são 9,5493 voltas por minuto
common_factor_minutes-done = {$values}, como {$first}, valem {$factor} vezes o que deveriam
common_factor_minutes-should = todos os tempos ficam em uma unidade: um minuto tem 60 segundos
common_factor_units-done = {$values}, como {$first}, valem {$factor} vezes o que deveriam
common_factor_units-should = todos os comprimentos ficam em uma unidade: 1 m são 100 cm ou 1000 mm
revolutions_per_second-done = {$rate} não foi convertido entre rotações por segundo e radianos por segundo
revolutions_per_second-should = rad/s = rev/s · 2π
degrees_for_radians-done = {$rate} não foi convertido entre graus e radianos
degrees_for_radians-should = velocidades e acelerações angulares entram em todo produto em radianos
wrong_scale-done = {$segment}: foi usado {$wrong} em vez de {$scale}
wrong_scale-should = os milímetros desta folha vezes {$scale} dão o valor
scale_forgotten-done = {$segment}: os milímetros de papel foram tomados como valor, sem {$scale}
scale_forgotten-should = os milímetros desta folha vezes {$scale} dão o valor
center_along_guide-done = {$center} foi procurado ao longo de {$guide}
center_along_guide-should = {$center} está no infinito, normal a {$guide}: as retas na sua direção são normais à guia
center_at_slider-done = {$center} foi tomado em {$pin}, a articulação do bloco
center_at_slider-should = {$pin} é o centro do bloco com o seu outro elo; {$center} está no infinito, normal a {$guide}
line_without_common_link-done = {$center} foi marcado sobre {$wrong}
line_without_common_link-should = {$center} está sobre {$right}: cada uma das suas retas une dois centros que têm em comum um terceiro elo
center_of_other_lines-done = {$center} foi marcado onde se cruzam as retas de {$other}
center_of_other_lines-should = cada reta de {$center} une dois centros que têm em comum um terceiro elo
centers_swapped-done = {$first} e {$second} foram trocados entre si
centers_swapped-should = cada reta de {$first} une dois centros que têm em comum um terceiro elo
ratio_inverted-done = para {$rate} a razão das distâncias foi tomada ao contrário
ratio_inverted-should = as distâncias do centro comum são inversas às velocidades angulares: multiplicar por {$over} / {$under}
mesh_sense-done = as rodas {$first} e {$second} foram tomadas como girando no mesmo sentido, vistas do seu braço
mesh_sense-should = rodas que se tocam por fora giram em sentidos contrários, vistas do seu braço
mesh_sense_internal-done = a coroa e a roda de {$first} e {$second} foram tomadas como girando em sentidos contrários, vistas do seu braço
mesh_sense_internal-should = uma coroa e a roda dentro dela giram no mesmo sentido, vistas do seu braço
teeth_inverted-done = para as rodas {$first} e {$second} a razão dos dentes foi tomada ao contrário
teeth_inverted-should = as velocidades angulares são inversas aos números de dentes
arm_forgotten-done = para as rodas {$first} e {$second} a razão dos dentes foi tomada sem a rotação de {$arm}
arm_forgotten-should = a razão dos dentes vale para as velocidades angulares menos ω_{$arm}
relative_for_absolute-done = {$rate} é a relativa a {$arm}
relative_for_absolute-should = somar ω_{$arm}
idler_counted-done = os dentes de {$idler} estão na razão de {$first} e {$last}
idler_counted-should = uma roda intermédia só muda o sentido; os seus dentes cancelam-se
rim_swapped-done = onde {$wheel} engrena com {$other} foram tomados os dentes do seu outro aro
rim_swapped-should = tomar os dentes do aro que toca
rims_swapped-done = os dois aros de {$wheel} foram tomados um pelo outro
rims_swapped-should = tomar em cada engrenamento os dentes do aro que toca
pitch_on_wrong_side-done = {$wheel} foi tomada como tocando a coroa {$ring} no lado próximo
pitch_on_wrong_side-should = uma coroa toca a roda dentro dela para além do centro da roda
accelerations_equal-done = onde {$first} e {$second} se tocam, as suas acelerações foram tomadas como iguais
accelerations_equal-should = ali só são iguais as velocidades e as partes tangenciais; a aceleração do centro da roda segue do seu braço
diameter_for_radius-done = para {$found} tomou-se o diâmetro da roda {$wheel} em vez do seu raio
diameter_for_radius-should = a velocidade é ω r e o momento W r, com o raio r da roda {$wheel}
radial_force_left_out-done = falta {$force}: a força entre os dentes foi tomada só segundo a tangente
radial_force_left_out-should = os dentes empurram-se segundo a sua linha de ação: ao lado da parte segundo a tangente há {$force}, tan α vezes maior, que afasta as rodas
radius_left_out-done = para {$length} tomou-se só o raio de {$link}
radius_left_out-should = o elo equivalente une os centros de curvatura: {$length} é a soma de ambos os raios, num perfil côncavo a sua diferença
wrong_center_of_curvature-done = a normal comum de {$first} e {$second} foi traçada a partir de {$wrong}
wrong_center_of_curvature-should = a normal comum passa por {$right}, o centro de curvatura do perfil onde se tocam
sliding_left_out-done = {$image} foi marcado em {$start}, como se os perfis não se movessem um ao longo do outro
sliding_left_out-should = perfis que se tocam só têm velocidades iguais segundo a sua normal comum: a partir de {$start} traça-se a velocidade relativa, segundo a sua tangente
face_along_wrong_line-done = a face plana de {$link} foi tomada ao longo de {$line}
face_along_wrong_line-should = a velocidade relativa é paralela à face
face_normal_to_wrong_line-done = a face plana de {$link} foi tomada normal a {$line}
face_normal_to_wrong_line-should = a velocidade relativa é paralela à face, e a normal comum é normal à própria face
friction_sense-done = {$friction} foi tomado no sentido do movimento
friction_sense-should = o atrito opõe-se: o que uma guia ou um pino faz a um elo é contrário a como o elo se move sobre ele
angle_for_coefficient-done = para {$friction} tomou-se o ângulo de atrito pelo coeficiente, ou a sua tangente pelo seu seno
angle_for_coefficient-should = com o ângulo de atrito φ o coeficiente de uma guia é μ = tan φ, e o círculo de atrito de um pino tem o raio r sen φ
normal_without_lean-done = {$friction} foi achado com o que a junta suportaria sem atrito
normal_without_lean-should = o atrito muda o que aperta na junta: acham-se as forças outra vez com {$friction} até ambas concordarem
friction_circle_diameter-done = {$friction} foi achado com o diâmetro do pino
friction_circle_diameter-should = o círculo de atrito tem o raio r sen φ, com o raio r do pino
friction_left_out-done = falta {$friction}
friction_left_out-should = {$friction} toma-se com as outras forças: uma guia opõe-se com μ |N|, um pino com o binário de uma força que toca o círculo de atrito
sense_by_center-done = {$rate} tem o sentido errado
sense_by_center-should = o sentido inverte-se onde o centro comum está entre os dois centros fixos e mantém-se onde está fora
velocity_reversed-done = {$velocity} foi traçada no sentido errado
velocity_reversed-should = aponta como o seu elo gira em torno do seu centro fixo
distance_from_wrong_center-done = para {$length} foi tomada a distância de {$from} a {$to}
distance_from_wrong_center-should = medir {$length}: as velocidades de um elo crescem com a distância ao seu centro com a base
not_extended-done = para {$center} as retas não foram prolongadas o suficiente: outras foram cruzadas entre os centros
not_extended-should = {$center} está onde se cruzam {$first} e {$second}, que é preciso prolongar para além dos seus centros
velocity_along_ray-done = {$velocity} foi traçada ao longo do raio do seu centro
velocity_along_ray-should = uma velocidade é normal ao raio do centro até o seu ponto
pin_of_three-done = {$center} não foi tomado em {$pin}, onde os seus elos se articulam, mas noutro lugar
pin_of_three-should = uma articulação que une três elos é o centro de cada par deles
lengths_without_scale-done = {$lengths}: milímetros de papel foram tomados como comprimentos, sem {$scale}
lengths_without_scale-should = os milímetros nesta folha vezes {$scale} são o comprimento
inertia_along_a-done = {$load} foi tomada no sentido da aceleração
inertia_along_a-should = uma força de inércia é −m a: aponta contra a aceleração do centro de massa
inertia_couple_along_alpha-done = {$load} foi tomado no sentido da aceleração angular
inertia_couple_along_alpha-should = um binário de inércia é −J α: gira contra a aceleração angular; como uma só força passa ao lado do centro de modo a girar igual
couple_forgotten-done = {$load} falta nos momentos
couple_forgotten-should = um binário tem o mesmo momento em relação a qualquer ponto e conta em cada soma de momentos do seu elo
percussion_on_wrong_side-done = {$load} foi posta do lado errado do centro de massa
percussion_on_wrong_side-should = a linha de {$load} passa à distância h = J α / (m a) do centro, onde gira contra a aceleração angular
a_of_joint_for_centre-done = {$load} foi achada com a aceleração de {$point}
a_of_joint_for_centre-should = uma força de inércia vem da aceleração do centro de massa, não da de uma junta
centripetal_part_left_out-done = {$load} foi achada sem a parte centrípeta da aceleração em torno de {$point}
centripetal_part_left_out-should = a aceleração do centro de massa tem também a parte ω² r em direção a {$point}
arm_to_point-done = para {$found} foi medido um braço até o ponto onde atua a sua força
arm_to_point-should = o braço de uma força é a distância da sua linha de ação, medida normal a ela
arm_in_paper_mm-done = para {$found} os braços foram tomados em milímetros de papel
arm_in_paper_mm-should = um braço são os seus milímetros vezes {$scale}
arms_in_paper_mm-done = os braços foram tomados em milímetros de papel
arms_in_paper_mm-should = cada braço são os seus milímetros vezes {$scale}
reaction_not_reversed-done = {$force} foi passada adiante sem ser invertida
reaction_not_reversed-should = o que um elo faz a outro, este faz-lhe invertido: no elo seguinte {$force} atua no sentido oposto
negative_tangential_kept-done = {$force} foi traçada no sentido suposto, embora os momentos a dessem negativa
negative_tangential_kept-should = uma força que resulta negativa atua contra o sentido suposto: {$force} traça-se ao contrário
normal_across-done = a direção de {$force} foi traçada normal à linha das duas juntas
normal_across-should = {$force} atua ao longo da linha das duas juntas do seu elo
force_missing_in_polygon-done = {$force} falta no polígono
force_missing_in_polygon-should = o polígono tem todas as forças sobre os elos isolados, também {$force}
force_twice-done = {$force} foi traçada duas vezes
force_twice-should = cada força está uma vez num polígono
guide_reaction_along_rod-done = {$force} foi traçada ao longo de {$guide}
guide_reaction_along_rod-should = sem atrito uma guia só transmite forças normais a ela
guide_reaction_through_pin-done = tomou-se que a força de {$guide} atua em {$point}
guide_reaction_through_pin-should = ela atua à distância h = M / N de {$point}, que os momentos do elo deslizante dão
mass_for_weight-done = para {$load} foi tomado o número da massa
mass_for_weight-should = um peso é massa vezes g: {$load} = m g
factor_of_thousand-done = {$load} está errada por um fator de 1000
factor_of_thousand-should = com comprimentos em mm, uma força em N é massa em kg vezes aceleração em mm/s², dividida por 1000
moment_about_wrong_point-done = para {$found} os momentos foram tomados em relação a {$wrong}
moment_about_wrong_point-should = os momentos tomam-se em relação a {$right}: por lá passam as linhas das outras forças desconhecidas
moment_about_another_point-done = para {$found} os momentos foram tomados em relação a um ponto diferente de {$right}
moment_about_another_point-should = os momentos tomam-se em relação a {$right}: por ele passam as linhas das outras forças desconhecidas
lever_not_turned-done = para {$found} as forças foram postas no plano de velocidades sem o girar
lever_not_turned-should = primeiro gira-se de 90° o plano de velocidades, ou cada força: então os momentos em relação ao polo são potências
couple_on_lever_unscaled-done = o binário do elo {$link} foi somado tal como é aos momentos da alavanca
couple_on_lever_unscaled-should = na alavanca um binário M são duas forças M/l nas imagens de dois pontos do elo {$link} à distância l
torque_sense-done = {$found} tem o sentido daquilo contra que o acionamento trabalha
torque_sense-should = {$found} é o que o acionamento faz ao seu elo: equilibra os momentos de todas as forças sobre ele
other_mode-done = o mecanismo foi desenhado em outra posição em que seus elos se encaixam
other_mode-should = pede-se a posição que a figura mostra
crank_angle-done = o mecanismo foi desenhado com o elo {$link} a {$wrong}° em vez de {$right}°
crank_angle-should = os ângulos são medidos no sentido anti-horário a partir da horizontal para a direita
crank_angle_in_radians-done = a calculadora tomou o ângulo do elo {$link}, {$right}°, como {$right} radianos, que são {$wrong}°
crank_angle_in_radians-should = a calculadora é posta em graus
swapped-done = {$first} e {$second} parecem estar cada um no campo do outro
swapped-should = trocar os dois números
digits_transposed-done = {$quantity}: dois algarismos estão trocados, {$written} em vez de {$meant}
digits_transposed-should = {$meant}
decimal_slipped-done = {$quantity}: a vírgula decimal está deslocada, {$written} em vez de {$meant}
decimal_slipped-should = {$meant}
truncated-done = os números foram cortados após o último algarismo escrito
truncated-should = arredondar para cima o último algarismo se o seguinte for 5 ou mais
wrong_unit-done = {$quantity}: {$number} é o valor em {$right}, não em {$wrong}
wrong_unit-should = {$number} {$right}
other_unit-done = {$quantity}: {$number} é o valor em {$unit}, e nenhuma unidade o diz
other_unit-should = escrever {$unit} ao lado, ou o valor em {$own}
unknown-done = {$quantity} difere por um motivo que os valores não mostram; seguiu-se com esse valor
unknown-should = Reveja {$quantity}
unknown_alone-done = só {$quantity} difere: foi lido, calculado ou escrito errado, e não se seguiu com esse valor
unknown_alone-should = Obtenha {$quantity} de novo
unknown_first-done = {$quantity} é o primeiro valor que difere, por um motivo que os valores não mostram
unknown_first-should = Reveja este primeiro: os valores posteriores podem decorrer dele


## Errors and warnings: scene


# Kinds of files.

scene-scene = cena
scene-study = estudo
scene-drawing = desenho
scene-style = estilo
scene-form = valores medidos
scene-marks = pontuação
scene-begins_with = um arquivo de {$what} começa com {$start}
scene-too_many_bytes = o arquivo de {$what} tem {$bytes} bytes; são lidos no máximo {$most} ({$mib} MiB)
scene-is_empty = o arquivo de {$what} está vazio
scene-expected_object = esperado: um arquivo de {$what} como {$start}; encontrado: {$found}
scene-meant_key = você quis dizer `{$key}` com `{$other}`?
scene-add_version = acrescente "{$key}": {$version}, a versão do formato de {$what}
scene-no_version = falta `{$key}`, portanto talvez isto não seja um arquivo de {$what}
scene-other_version = este programa lê a versão {$version}, e o arquivo de {$what} diz {$said}
scene-version_is_number = esperado: o número {$version}, a versão do formato; encontrado: {$found}
scene-write_version = escreva "{$key}": {$version}

# Text that is not JSON.

scene-not_json = isto não é JSON: {$what}
scene-not_json_at_all = isto não é JSON
scene-text_over_lines = um texto termina na mesma linha em que começa
scene-add_quote_or_n = acrescente a " que falta, ou escreva \n para uma quebra de linha
scene-control_in_text = um texto contém uma tabulação ou outro caractere de controle
scene-write_t = escreva \t para uma tabulação
scene-too_deep = há colchetes aninhados em mais de {$most} níveis
scene-no_comments = JSON não tem comentários
scene-write_note = escreva "note": "…", que é permitido em qualquer lugar
scene-trailing_comma = há uma vírgula antes do fechamento
scene-remove_comma = remova a vírgula
scene-leading_zero = um número não começa com 0
scene-remove_zero = remova o 0 inicial
scene-comma_missing = falta aqui uma vírgula
scene-brace_open = esta {"{"} nunca é fechada
scene-add_brace = acrescente a {"}"} que falta
scene-bracket_open = este [ nunca é fechado
scene-add_bracket = acrescente o ] que falta
scene-brace_for_value = há uma {"}"} onde deveria haver um valor
scene-bracket_for_value = há um ] onde deveria haver um valor
scene-comma_for_value = há uma vírgula onde deveria haver um valor
scene-colon_for_value = há dois-pontos onde deveria haver um valor
scene-colon_missing = faltam dois-pontos depois desta chave
scene-value_missing = falta o valor desta chave
scene-after_end = há algo depois do fim do arquivo de {$what}
scene-one_in_a_file = cada arquivo de {$what} tem um só par de {"{"} {"}"}
scene-single_quotes = os textos ficam entre aspas duplas
scene-write_double = escreva "A" em vez de 'A'
scene-key_needs_quotes = a chave {$word} precisa de aspas duplas
scene-write_key_value = escreva "chave": valor
scene-no_number = {$word} não é um número
scene-every_number_finite = todo número de um arquivo de {$what} é finito; omita a chave se o valor não é conhecido
scene-not_here = {$sign} não cabe aqui
scene-no_value = {$word} não é um valor
scene-leave_key_out = omita a chave
scene-write_true = escreva true
scene-write_false = escreva false
scene-names_in_quotes = textos e nomes ficam entre aspas duplas
scene-plus_sign = um número não leva sinal de mais na frente
scene-remove_plus = remova o +
scene-decimal_only = os números são decimais
scene-digits_both_sides = um ponto decimal precisa de algarismos dos dois lados
scene-write_half = escreva 0.5 em vez de .5, e 5.0 em vez de 5.
scene-number_incomplete = este número não está completo
scene-no_escape = uma \ em um texto começa uma sequência de escape, e esta não é uma
scene-write_backslash = escreva \\ para o caractere \
scene-text_open = este texto nunca é fechado
scene-add_quote = acrescente a " que falta
scene-null = null não é um valor aqui
scene-key_twice = a chave `{$key}` aparece duas vezes: primeiro na linha {$line}
scene-number_too_large = {$number} é grande demais para calcular com ele
scene-choose_units = escolha unidades com as quais seja menor que 1e100
scene-turns_beside_gears = {$angle} é grande demais para um ângulo junto a engrenagens: suas voltas inteiras contam e se perderiam
scene-take_turns_off = escreva um ângulo menor que 1e14 graus

# Values of a wrong kind.

scene-nothing = nada
scene-a_number = o número {$number}
scene-a_text = o texto "{$text}"
scene-empty_list = uma lista vazia
scene-list_of = uma lista de {$count}
scene-an_object = um objeto {"{"} … {"}"}
scene-unknown_key = chave desconhecida: `{$key}`
scene-the_keys_are = as chaves aqui são {$all}
scene-unknown_word = palavra desconhecida: "{$word}"
scene-write_one_of = escreva uma destas: {$all}
scene-write_truth_or_one_of = escreva true, false ou uma destas: {$all}
scene-missing = falta `{$key}`
scene-expected_found = esperado: {$expected}; encontrado: {$found}
scene-in_double_quotes = escreva "{$number}" entre aspas duplas
scene-add = acrescente {$json}
scene-add_on = acrescente "on", o elo que leva a guia, ou "ground"
scene-add_length_unit = acrescente "length": "m", "mm", "cm", "in" ou "ft"
scene-add_time_unit = acrescente "time": "s" ou "min"
scene-add_speed = acrescente "speed", ao longo da guia
scene-points_as_one_text = escrever dois pontos como um só texto: "AB", ou "A-B" se os nomes forem mais longos
scene-without_quotes = escreva {$number} sem aspas
scene-with_a_point = escreva {$number} sem aspas e com ponto
scene-or_as_rpm = escreva {$number} sem aspas, ou a velocidade como "rpm"
scene-in_degrees = os ângulos são em graus: escreva {$number} sem aspas
scene-rpm_for_omega = escreva "rpm": {$number} em vez de "omega"
scene-units_in_units = escreva {$number} sem aspas; as unidades ficam em `units`, os ângulos são em graus
scene-two_numbers = esperado: dois números [x, y]; encontrado: uma lista de {$count}
scene-negative_size = o tamanho é {$size}; um tamanho não é negativo: em vez disso, gire o ângulo 180
scene-no_page = não existe a página "{$name}"
scene-no_unit = não existe a unidade de comprimento "{$name}"
scene-did_you_mean = você quis dizer `{$name}`?
scene-joints_out_of_scope = os elos se unem por pinos, cursores retos (`sliders`), rodas, cremalheiras e correias (`gears`), e perfis que se tocam, como os de cames (`contacts`)
scene-forces_out_of_scope = as cargas são `mass`, `inertia` e `center` de um elo, e `gravity`, `forces`, `springs` e `friction` da cena; não há amortecedores

# What a form asks for.

scene-form_asks_nothing = este formulário não pede nada
scene-form_no_quantity = {$name} não é nome de nenhuma grandeza
scene-form_no_marks = {$marks} não são pontos
scene-form_marks_from_0 = os pontos vão de 0 a {$most}
scene-no_hints = {$count} não é um número de etapas de uma dica
scene-hints_from_0 = escreva de 0 (sem dicas) a {$most} (todas)
scene-form_names_quantities = escreva os nomes como em um formulário vazio: "omega(2)", "vplan(p,b)"

# Names.

scene-a_point = um ponto
scene-a_link = um elo
scene-no_name = {$what} não tem nome
scene-write_a_name = escreva uma letra ou um número entre as aspas
scene-name_too_long = o nome de {$what} tem mais de {$most} caracteres
scene-write_prime = escreva ' para o sinal de linha
scene-write_underscore = escreva _ em vez de -, que une dois pontos
scene-signs_of_names = os nomes têm letras, algarismos, ' e _
scene-sign_in_name = o nome `{$name}` de {$what} contém `{$sign}`
scene-called_note = {$what} não pode se chamar `note`: essa chave é para notas
scene-called_ground = um elo não pode se chamar `ground`: isso é a base
scene-point_twice = o ponto {$point} aparece duas vezes
scene-link_twice = o elo {$link} aparece duas vezes
scene-point_twice_in_link = o ponto {$point} aparece duas vezes no elo {$link}
scene-link_named = o elo {$link}
scene-point_named = o ponto {$point}
scene-the_ground = a base
scene-lacks_point = {$carrier} não tem o ponto {$point}; não tem pontos
scene-lacks_point_but = {$carrier} não tem o ponto {$point}; seu único ponto é {$only}
scene-lacks_point_of = {$carrier} não tem o ponto {$point}; seus pontos são {$all}
scene-lengths_key = o comprimento `{$key}`
scene-along_key = `along` com `{$key}`
scene-pair_unknown = {$key}: {$why}
scene-pair_ambiguous = {$key} pode significar {$a} e {$b}, ou {$c} e {$d}
scene-pair_same = {$key} nomeia duas vezes o ponto {$point}
scene-write_pair = escreva "{$a}-{$b}" ou "{$c}-{$d}"
scene-no_link = não existe o elo {$link}
scene-the_links_are = os elos são {$all}
scene-no_point = não existe o ponto {$point}
scene-the_points_are = os pontos são {$all}
scene-name_kept = o nome `{$name}` está reservado para {$what}
scene-other_name = escolha outro nome para o ponto
scene-image_of = a imagem de {$point} nos polígonos
scene-special_point_of = o ponto especial do elo {$link}
scene-point_under = o ponto do elo {$link} situado sob {$point}

# Points, ground, known motions.

scene-no_coordinates = os pontos da base não têm coordenadas
scene-write_coordinates = escreva {"{"} "A": [x, y], … {"}"}; ou dê as coordenadas de todos os pontos em "points": {"{"} … {"}"}
scene-other_coordinates = o ponto {$point} tem outras coordenadas em `points`
scene-name_only = só o nomeie em uma lista: "ground": ["A", …]
scene-not_in_points = o ponto {$point} não tem coordenadas em `points`
scene-add_to_points = acrescente "{$point}": [x, y] a `points`
scene-on_no_link = o ponto {$point} não está em nenhum elo nem na base
scene-name_in_link = nomeie-o nos `points` de um elo, ou remova-o
scene-known_is_drawn = movimentos conhecidos são próprios de uma configuração desenhada
scene-points_or_drive = dê as coordenadas de todos os pontos em "points": {"{"} … {"}"}, ou acione um elo
scene-ground_moves_not = o ponto {$point} está na base, que não se move
scene-remove_from_ground = remova-o daqui ou de `ground`
scene-motion_twice = o movimento do ponto {$point} está dado duas vezes: {$first} e {$second}
scene-motion_already = o movimento do ponto {$point} já está dado: {$by}
scene-keep_one = mantenha um dos dois
scene-motion_of_link = o `motion` do elo {$link}
scene-drive_of_link = o acionamento do elo {$link}
scene-drive_of_slider = o acionamento do cursor {$link}
scene-drive_of_its_slider = o acionamento do seu cursor
scene-drawn_needs_no_near = uma configuração desenhada não precisa de `near`
scene-remove_it_drawn = remova-o: o desenho, `points`, já o dá
scene-remove_drawn = remova `{$key}`: o desenho, `points`, já o dá
scene-near_one_number = {$key} é um só número, em graus, não dois
scene-near_two_numbers = o ponto {$point} precisa de dois números [x, y], e há um

# Links and their drives.

scene-no_links = um mecanismo tem pelo menos um elo
scene-lengths_and_shape = o elo {$link} tem ao mesmo tempo `lengths` e `shape`
scene-drive_and_motion = o elo {$link} tem ao mesmo tempo um acionamento e um movimento conhecido
scene-two_angles = o elo {$link} tem um ângulo, e seu acionamento também
scene-link_motion_is_drawn = elo {$link}: um `motion` conhecido é próprio de uma configuração desenhada
scene-points_or_drive_link = dê as coordenadas de todos os pontos em "points": {"{"} … {"}"}, ou acione o elo
scene-link_is_drawn = o elo {$link} tem `{$key}`, mas esta cena é uma configuração desenhada
scene-remove_or_lengths = remova `{$key}`: o desenho, `points`, já o dá; ou remova `points` e dê a `ground` suas coordenadas
scene-no_points = o elo {$link} não tem `points`
scene-too_many_points = o elo {$link} tem {$count} pontos, que os comprimentos não fixam
scene-give_shape = dê coordenadas no sistema próprio do elo: "shape": {"{"} "{$a}": [x, y], "{$b}": [x, y], … {"}"}
scene-no_distance = o elo {$link} tem os pontos {$from} e {$to}, mas não sua distância
scene-three_lengths = o elo {$link} tem três pontos, que precisam de três comprimentos; falta o de {$from} e {$to}
scene-add_lengths = acrescente "lengths": {"{"} "{$key}": … {"}"}, ou dê um `shape`
scene-add_to_lengths = acrescente "{$key}": … aos seus comprimentos
scene-length_twice = o comprimento {$key} do elo {$link} já está dado, como {$first}
scene-length_zero = o comprimento {$key} é 0: {$from} e {$to} seriam um só ponto
scene-one_name_or_length = use um só nome para ambos, ou dê um comprimento positivo
scene-length_negative = o comprimento {$key} é {$value}; um comprimento é positivo
scene-no_triangle = elo {$link}: os comprimentos {$lengths} não podem formar um triângulo: {$one} + {$other} < {$long}
scene-shape_empty = o `shape` do elo {$link} não tem pontos
scene-add_or_without_points = acrescente-o a `points`, ou omita `points`
scene-shape_lacks = o `shape` do elo {$link} não diz onde está {$point}
scene-add_place = acrescente "{$point}": [x, y]
scene-zero_length = o elo {$link} tem {$first} e {$second} em um mesmo lugar: seu comprimento seria zero
scene-one_name_or_move = use um só nome para ambos, ou mova um
scene-drive_is_drawn = o acionamento do elo {$link} tem `{$key}`, mas esta cena é uma configuração desenhada
scene-omega_and_rpm = o acionamento do elo {$link} tem ao mesmo tempo `omega` e `rpm`
scene-drive_without_speed = o acionamento do elo {$link} não tem velocidade
scene-add_omega = acrescente "omega" (radianos por unidade de tempo) ou "rpm"; para um elo que desliza, "speed"
scene-pushes_and_turns = o acionamento do elo {$link} empurra e gira ao mesmo tempo
scene-push_or_turn = um acionamento tem `position`, `speed`, `acceleration`, ou então `angle`, `omega`, `alpha`
scene-push_without_speed = o acionamento do elo {$link} não tem `speed`

# Sliders.

scene-slides_on_own = {$carrier} já contém o ponto {$point}, que por isso não pode deslizar ali
scene-other_sliding_name = use outro nome para o ponto que desliza
scene-no_frame = coordenadas precisam de um sistema, e {$carrier} não tem `shape`
scene-point_or_shape = nomeie um ponto ({$carrier}), ou dê ao elo um `shape`
scene-point_or_without = nomeie um ponto ({$carrier}), ou omita `through`: a guia passa pelo ponto do cursor
scene-no_direction = uma direção de tamanho zero não aponta para lugar nenhum
scene-give_direction = dê [dx, dy] ou graus
scene-no_axis = {$carrier} não tem pontos, nem portanto um eixo a partir do qual contar graus
scene-give_drawn_direction = dê a direção como está desenhada: "along": [dx, dy]
scene-degrees_unquoted = escreva {$number} sem aspas para graus
scene-one_place = {$from} e {$to} estão em um mesmo lugar, portanto não dão direção
scene-two_drives = o elo {$link} tem um acionamento, e seu cursor também
scene-which_slider = o elo {$link} tem dois cursores, e seu acionamento não diz qual empurra
scene-drive_into_sliders = passe o acionamento para uma das entradas de `sliders`
scene-pushed_without_slider = o acionamento empurra o elo {$link}, mas este não tem cursor
scene-add_slider = acrescente a `sliders` uma entrada com este `link`, ou gire o elo com `omega`
scene-idle_link = o elo {$link} não tem pontos, e nada desliza sobre ele
scene-remove_or_name = remova-o, ou nomeie seus pontos
scene-guide_nowhere = nada diz onde está a guia: {$carrier} não tem pontos
scene-add_through = acrescente "through": [x, y], um lugar da guia
scene-name_on_guide = nomeie um ponto do elo {$link} que esteja na guia
scene-turned_is_drawn = `turned` não tem lugar em uma configuração desenhada
scene-position_is_drawn = este acionamento tem `position`, mas esta cena é uma configuração desenhada
scene-nothing_slides = este cursor não diz o que desliza
scene-give_link_or_pin = dê "link" e "at", o elo e seu ponto na guia; ou "pin"
scene-pin_and_link = `pin` fica no lugar de `link` e `at`, não junto deles
scene-block_or_pin = mantenha `link` e `at` para um bloco, `pin` para um simples pino
scene-add_at = acrescente "at", o ponto do elo {$link} que está na guia
scene-add_link_or_pin = acrescente "link", o elo que desliza; ou escreva "pin": "{$point}" para um pino em uma ranhura
scene-slides_on_itself = o elo {$link} não pode deslizar sobre si mesmo
scene-travel_is_drawn = uma configuração desenhada tem uma só posição, portanto suas guias não têm extremos
scene-travel_backwards = o curso vai de {$low} a {$high}
scene-lower_end_first = dê primeiro a posição menor, como "travel": [20, 80]
scene-travel_has_two_ends = uma guia tem dois extremos, não {$count}

# Pares de engrenagens.

scene-two_wheels = um par tem duas rodas, não {$count}
scene-meshed_twice = {$first} e {$second} engrenam duas vezes
scene-remove_one_mesh = remova um dos dois pares; de duas coroas de um elo cada uma engrena com outra roda
scene-no_train = nenhuma roda engrena: não há trem para a tabela de Willis
scene-add_gears = omita-a ou dê `gears`
scene-meshes_with_itself = {$wheel} não pode engrenar consigo mesmo
scene-wheel_carries_itself = {$wheel} é uma roda deste par e não pode levá-lo
scene-name_the_carrier = `on` nomeia o elo em cujos pinos giram as duas rodas, ou "ground"
scene-wheels_on_one_axis = {$first} e {$second} giram em torno de um mesmo eixo e não podem engrenar
scene-mesh_over_a_wheel = dê um par para cada lugar onde dentes se tocam: solar e planeta, planeta e coroa
scene-phase_is_drawn = `phase` não tem lugar em uma configuração desenhada
scene-no_pressure = um ângulo de pressão de {$degrees}° não é de dentes
scene-usual_pressure = o usual é 20; de 0 a {$most}
scene-no_teeth = {$teeth} não é um número de dentes
scene-teeth_up_to = dê um número inteiro até {$most}, negativo para uma coroa interna; de rodas sem dentes números inteiros na razão dos seus raios
scene-two_rings = duas coroas internas não podem engrenar
scene-one_ring = uma coroa engrena com uma roda no seu interior, de dentes positivos
scene-ring_of_the_same_size = coroa e roda têm o mesmo número de dentes: seriam uma só
scene-ring_smaller = a coroa tem {$ring} dentes, a roda dentro dela {$wheel}
scene-ring_larger = uma coroa tem mais dentes que a roda no seu interior
scene-wheel_not_on_carrier = {$wheel} não tem pino em {$carrier}, que leva o par
scene-pin_the_wheel = nomeie o centro da roda em ambos: um ponto da roda e do suporte
scene-two_wheel_pins = {$wheel} e {$carrier} têm em comum {$first} e {$second}, portanto são rígidos
scene-one_wheel_pin = uma roda gira em torno de um ponto do seu suporte
scene-two_racks = duas cremalheiras não podem engrenar
scene-one_rack = uma cremalheira engrena com uma roda; escreva o número de dentes da roda em lugar de um "rack"
scene-rack_without_slider = nada deixa {$rack}, a cremalheira, deslizar em relação a {$carrier}, que leva a roda
scene-rack_not_parallel = {$rack}, a cremalheira, e {$carrier}, que leva a roda, deslizam na base em duas direções
scene-let_rack_slide = dê um cursor com a cremalheira sobre o portador, ou com o portador sobre a cremalheira; ou um de cada sobre a base, por guias paralelas
scene-teeth_of_pinion = dê um número inteiro de 1 a {$most}: uma roda sobre uma cremalheira tem os dentes por fora
scene-no_radius = {$radius} não é um raio
scene-give_radius = dê o raio da circunferência primitiva, um comprimento acima de 0
scene-give_larger_radius = dê o raio da circunferência primitiva, na unidade de comprimento da cena e não inferior a {$least}
scene-radius_without_rack = `radius` é de uma roda sobre uma cremalheira ou com uma correia: outras rodas têm seus raios pela distância entre centros
scene-position_without_rack = `position` é de uma roda sobre uma cremalheira
scene-give_phase = o ângulo de uma roda em relação a outra é `phase`
scene-phase_of_rack = `phase` é de duas rodas: uma cremalheira não tem ângulo
scene-give_position_of_rack = `position` diz onde a cremalheira está quando a roda está em 0
scene-belt_on_rack = nenhuma correia envolve uma cremalheira
scene-belt_without_teeth = uma correia não tem ângulo de pressão
scene-teeth_of_belt = dê um número inteiro de 1 a {$most}: dentes de rodas de corrente, ou números inteiros na razão dos raios
scene-no_forces_of_belts = não se sabe quanto uma correia está tensionada; por isso não se calculam forças de mecanismos com correias
scene-remove_belts_or_loads = tire da cena massas, `gravity`, `forces` e `springs`, ou suas correias
scene-two_touch = um contato é entre dois corpos, não {$count}
scene-touches_itself = {$body} não pode tocar a si mesmo
scene-through_without_face = `through` é um lugar de um perfil plano, mas o segundo é redondo
scene-give_face = dê a direção do perfil plano como `along`, ou omita `through`
scene-one_center_of_face = um perfil redondo sobre um plano tem um centro de curvatura, não {$count}
scene-face_has_no_center = nomeie só o centro do primeiro perfil; se ambos são redondos, omita `along`
scene-two_centers = dois perfis redondos têm dois centros de curvatura, não {$count}
scene-center_or_face = nomeie um ponto de cada corpo; de um perfil plano dê a direção como `along`
scene-center_on_body = um centro de curvatura é um ponto do corpo a que o perfil pertence, na ordem de `links`
scene-center_of_both = um centro de curvatura é um ponto de ambos, {$first} e {$second}: estariam unidos ali
scene-face_without_link = um pino sobre um perfil plano não precisa de um elo equivalente, portanto não há nenhum a nomear
scene-flat_roller = um rolete é redondo, mas `along` diz que o segundo perfil é plano
scene-give_radii = dê os raios de curvatura na ordem de `centers`, como "radii": [40, 10]
scene-radii_as_centers = são precisos tantos raios quantos centros: {$wanted}, não {$count}
scene-hollow_on_face = um perfil côncavo não toca um plano
scene-turn_face = o raio é positivo; para o outro lado da face gire `along` 180
scene-two_hollows = dois perfis côncavos não podem se tocar
scene-hollow_and_round = só o raio de um perfil côncavo é negativo, e o outro está dentro dele
scene-give_roller = o segundo raio é o do rolete
scene-centers_in_one_place = com estes raios os dois centros estão em um só lugar
scene-hollow_smaller = um perfil redondo de raio {$round} não cabe em um côncavo de raio {$hollow}
scene-hollow_larger = o perfil côncavo tem o raio maior, com um menos à frente
scene-radii_not_as_drawn = {$first} e {$second} estão desenhados a {$distance}, mas os raios dão {$radii}
scene-radii_as_drawn = a soma dos raios é a distância dos centros; um desenho dispensa raios
scene-face_not_as_drawn = {$center} está desenhado a {$distance} do perfil plano, mas o raio é {$radius}
scene-face_as_drawn = o raio é a distância do centro de curvatura ao perfil plano; um desenho dispensa-o
scene-face_on_other_side = {$center} está desenhado do lado errado do perfil plano: o primeiro corpo fica à direita de `along`
scene-face_the_other_way = gire `along` em 180, ou nomeie os seus pontos na outra ordem
scene-equivalent_taken = o elo equivalente se chamaria {$link}, mas há um elo com esse nome
scene-name_equivalent = dê-lhe outro `name`

# Masses and loads.

scene-mass_and_weight = o elo {$link} tem massa e peso
scene-without_mass = o elo {$link} tem `{$key}`, mas não massa
scene-no_unit_of_mass = o elo {$link} tem massa, mas a cena não tem unidade de massa
scene-add_unit_of_mass = acrescente `"mass": "kg"` a `units`
scene-weight_without_gravity = o elo {$link} tem peso, mas a cena não tem gravidade: a sua massa não é conhecida
scene-add_gravity = acrescente `"gravity": [0, -9810]` (em mm e s), ou dê uma massa
scene-no_center_of_mass = o elo {$link} tem massa, mas não centro de massa
scene-add_center = acrescente `"center"`: um ponto como "C", coordenadas [x, y] no sistema do elo, ou uma distância ao longo do seu eixo
scene-below_zero = `{$key}` é {$value}, menor que zero
scene-no_unit_of_force = há cargas, mas a cena não tem unidade de força
scene-add_unit_of_force = acrescente `"force": "N"` a `units`
scene-distance_is_drawn = uma distância ao longo do eixo do elo {$link}, mas esta cena é uma configuração desenhada
scene-place_as_drawn = dê as coordenadas [x, y] como estão desenhadas
scene-neither_force_nor_couple = uma carga é uma força, um binário, ou ambos
scene-force_nowhere = uma força atua num lugar
scene-add_at_of_force = acrescente `"at"`: um ponto como "C", coordenadas [x, y] no sistema do elo, ou uma distância ao longo do seu eixo
scene-couple_turns = um binário é o mesmo, gire ou não
scene-turns_is_drawn = numa configuração desenhada uma força é como está desenhada
scene-spring_within_link = ambas as extremidades da mola estão num mesmo corpo: não puxa nada
scene-spring_between_links = nomeie dois corpos, como [["3", "C"], ["ground", "A"]]
scene-no_point_of_ground = a base não tem o ponto {$point}
scene-distance_on_ground = a base não tem eixo; dê um ponto ou coordenadas [x, y]
scene-load_name = `{$name}` não pode ser o nome de uma carga: um nome não é vazio e não tem ( ) nem vírgula
scene-load_name_twice = duas cargas têm o nome {$name}
scene-other_load_name = escolha outro nome para a carga
scene-over_what = uma carga não pode mudar com {$name}
scene-over_angle_or_position = dê o ângulo de um elo como "angle(1)", ou a posição de um cursor como "position(3/ground)"
scene-over_short = uma tabela tem pelo menos duas linhas
scene-over_two_lines = dê pares de um lugar e um fator, como [[0, 0], [90, 1500], [180, 0]]
scene-over_back = {$after} está depois de {$before}
scene-over_in_order = ordene as linhas da tabela pelo seu primeiro número
scene-over_more_than_a_turn = uma tabela sobre um ângulo repete-se em cada volta, e esta é mais longa
scene-over_one_turn = dê no máximo 360°
scene-spring_ends = uma mola tem duas extremidades, não {$count}
scene-pin_and_guide = o atrito está num pino ou numa guia, não em ambos
scene-friction_nowhere = o atrito está numa junta
scene-pin_or_guide = acrescente `"pin": "B"` para o pino de um ponto, ou `"guide": "3/ground"` para a guia de um cursor
scene-friction_without_radius = o atrito no pino {$point} tem um momento que cresce com o munhão, cujo raio falta
scene-add_radius = acrescente `"radius"`, o do munhão, na unidade de comprimento da cena
scene-guide_has_no_radius = uma guia não tem munhão
scene-guide_has_no_pin = uma guia não tem pino que possa estar fixo num elo
scene-friction_twice = {$joint} tem atrito duas vezes
scene-coefficient_and_angle = o atrito tem um coeficiente e um ângulo, que dizem o mesmo
scene-no_coefficient = falta quanto atrito há
scene-angle_of_friction = um ângulo de atrito de {$angle}° não é menor que 90°
scene-below_right_angle = são comuns 3° a 30°, como os de coeficientes de 0.05 a 0.6

# The figure.

scene-scale_is = `{$key}` é {$what}
scene-scale_too_large = {$scale}; os números são no máximo {$most}
scene-scale_not_positive = {$scale}; uma escala, em unidades por milímetro de papel, é positiva
scene-next_scale = omita-a para tomar a próxima escala que caiba
scene-no_panels = uma figura sem painéis não mostra nada
scene-name_panels = nomeie alguns de {$all}, ou omita `panels`
scene-panel_twice = este painel aparece duas vezes
scene-step_from_one = os passos da construção são numerados a partir de 1
scene-steps_listed = `kinegon steps` os lista; omita `step` para a figura pronta
scene-frame_is_link = o elo {$link} já tem esse nome
scene-other_frame = dê à base o outro número, ou um texto próprio em `labels`: {"{"} "ground": "…" {"}"}
scene-ghosts_between = o número de posições-fantasma vai de {$least} a {$most}, e não {$count}
scene-drawn_has_no_path = uma configuração desenhada não pode ser movida, portanto o ponto {$point} não tem trajetória
scene-drawn_has_no_centrodes = uma configuração desenhada não pode ser movida, portanto o elo {$link} não tem polares
scene-drawn_has_no_ghosts = uma configuração desenhada não pode ser movida, portanto não há outras posições a desenhar
scene-lengths_and_drive = uma cena com `lengths` ou `shape` e um acionamento com seu `angle` ou `position`
scene-at_contact_alone = os perfis que se tocam são conhecidos só em seu contato, portanto não há outra posição
scene-say_circular = escreva "circular": true no contato, se ambos os perfis são círculos em torno destes centros, ou um círculo e uma reta
scene-no_drive_no_path = não há acionamento que mova o mecanismo, portanto o ponto {$point} não tem trajetória
scene-no_drive_no_centrodes = não há acionamento que mova o mecanismo, portanto o elo {$link} não tem polares
scene-no_drive_no_ghosts = não há acionamento que mova o mecanismo, portanto não há outras posições a desenhar
scene-give_drive = dê a um elo um "drive"
scene-moving_points = os pontos que se movem são {$all}
scene-ground_has_no_path = o ponto {$point} está na base e não tem trajetória
scene-name_of_construction = {$name} é um nome da construção, e não um ponto de um elo
scene-no_center = "{$name}" não nomeia nenhum centro instantâneo
scene-name_center = um centro é nomeado por dois elos, como P(1,3), ou P(2,ground) com a base
scene-center_twice = o centro {$name} está duas vezes
scene-ground_is_at_rest = o ponto {$point} está na base e não se move

# How large a scene may be.

scene-a_scene = uma cena
scene-a_figure = uma figura
scene-a_figure_with_steps = uma figura com passos
scene-a_drawing_judged = um desenho a conferir
scene-by_hand = uma construção à mão
scene-too_many_links = {$what} tem no máximo {$most} elos, e aqui há {$count}
scene-too_many_points_in = {$what} tem no máximo {$most} pontos, e aqui há {$count}
scene-too_many_loads = {$what} tem no máximo {$most} forças, binários e molas, e aqui há {$count}
scene-divide_mechanism = divida o mecanismo: o que depende só dos acionamentos pode ser uma cena à parte
scene-replace_loads = substitua as cargas de um mesmo elo pela sua resultante

# What stands after "expected": types say it in English to serde, which hands over nothing but text.

scene-expects_two_numbers = dois números [x, y] ou {"{"} "size": …, "angle": … {"}"}
scene-expects_place_on_link = dois números [x, y] ou um só, a distância ao longo do eixo
scene-expects_rough_place = dois números [x, y], ou para um "angle(…)" um só, seus graus
scene-expects_point_or_place = o nome de um ponto entre aspas duplas, ou suas coordenadas [x, y]
scene-expects_direction = dois pontos como "BE", ou um número de graus, ou [dx, dy]
scene-expects_vector = um vetor como {"{"} "size": 150, "angle": 210 {"}"}
scene-expects_link = um elo como {"{"} "points": ["A", "B"], … {"}"}, ou uma lista dos seus pontos ["A", "B"]
scene-expects_link_place = o nome de um ponto entre aspas duplas, as suas coordenadas [x, y], ou uma distância ao longo do eixo do elo
scene-expects_table_line = dois números, um lugar e um fator, como [90, 1500]
scene-expects_load = uma carga como {"{"} "on": "3", "at": "C", "force": [-150, 0] {"}"}
scene-expects_spring = uma mola como {"{"} "between": [["3", "C"], ["ground", "A"]], "rate": 1.5, "length": 120 {"}"}
scene-expects_spring_end = uma extremidade de uma mola como ["3", "C"], um elo e um lugar nele
scene-expects_friction = um atrito como {"{"} "pin": "B", "coefficient": 0.1, "radius": 12 {"}"} ou {"{"} "guide": "3/ground", "coefficient": 0.1 {"}"}
scene-expects_a_link = um elo
scene-expects_ground = os pontos da base como {"{"} "A": [x, y], … {"}"}, ou seus nomes como ["A", …]
scene-expects_drive = um acionamento como {"{"} "angle": 70, "omega": -1 {"}"}
scene-expects_push = um acionamento como {"{"} "position": 40, "speed": 10 {"}"}
scene-expects_motion = um movimento como {"{"} "velocity": [x, y], "acceleration": [x, y] {"}"}
scene-expects_link_motion = um movimento como {"{"} "at": "B", "velocity": [x, y], "omega": 1 {"}"}
scene-expects_slider = um cursor como {"{"} "link": "3", "at": "D", "on": "2", "along": "BE" {"}"}
scene-expects_gear = um par de engrenagens como {"{"} "mesh": ["1", "2"], "teeth": [20, 40], "on": "ground" {"}"}
scene-expects_contact = um contato como {"{"} "links": ["1", "3"], "centers": ["K", "C"], "radii": [40, 10] {"}"}
scene-expects_teeth = um número de dentes, ou "rack"
scene-expects_scene = uma cena como {"{"} "kinegon": 1, … {"}"}
scene-expects_figure = uma figura como {"{"} "panels": ["scheme", "velocity"] {"}"}
scene-expects_centers = "all", ou centros como ["P(2,ground)", "P(1,3)"]
scene-expects_units = unidades como {"{"} "length": "mm", "time": "s" {"}"}
scene-expects_truth_or_paper = true, false ou "paper"
scene-expects_truth_or_unit = true, false ou uma unidade de comprimento
scene-expects_truth = true ou false
scene-expects_whole_number = um número inteiro de 1 a 65535
scene-expects_number = um número
scene-expects_text = um texto entre aspas duplas
scene-expects_list = uma lista [ … ]
scene-expects_object = um objeto {"{"} … {"}"}


## Errors and warnings: mechanism

mechanism-nothing_to_solve = não há nada a resolver: o movimento de todos os elos está dado
mechanism-add_links = acrescente elos entre os acionados, os pontos conhecidos e a base
mechanism-over_no_slider = não há nenhum cursor {$name} com cuja posição uma carga pudesse mudar
mechanism-over_no_zero = a posição de {$name} não se conta a partir de nenhum ponto, pelo que nenhuma carga pode mudar com ela
mechanism-friction_no_slider = não há nenhum cursor {$name} em cuja guia pudesse haver atrito
mechanism-the_sliders_are = os cursores são: {$names}
mechanism-friction_no_joint = em {$point} não se unem elos, pelo que nada roça ali
mechanism-friction_of_contact = {$joint} representa perfis que se tocam, que atritam onde se tocam e não ali
mechanism-no_friction_of_contact = o atrito dos contatos não é conhecido: omita-o
mechanism-pin_of_several = o pino {$point} une vários elos, {$links}: o seu atrito depende daquele em que está fixo
mechanism-write_fixed_in = escreva `"fixed_in": "{$link}"`, ou outro destes
mechanism-pin_of_two = o pino {$point} une dois elos: o seu atrito é o mesmo em qualquer dos dois em que esteja fixo
mechanism-leave_fixed_in_out = omita `fixed_in`
mechanism-angle_of_another = o ângulo do elo {$link} não pode substituir o do acionamento: não muda com ele
mechanism-angle_in_drive = diga no acionamento onde ele está, ou dê o ângulo de um elo que gire com ele
mechanism-mirror_image = elo {$link}: seus comprimentos servem para um triângulo e para sua imagem espelhada; toma-se o anti-horário {$points}. Para escolher, dê lugares aproximados dos seus pontos em `near`
mechanism-singular = os elos {$links} não têm movimento definido em nenhuma posição: um grupo de classe {$class} com as juntas prismáticas como em {$pattern} é singular por sua estrutura
mechanism-make_revolute = transforme uma das juntas prismáticas em junta de rotação
mechanism-train_without_ratio = os dentes não dão os ângulos dos elos {$links}: as rodas giram do mesmo modo faça o que fizer o braço, portanto nada o move
mechanism-other_teeth = dê outros números de dentes, de modo que a relação básica do trem não seja 1, ou acione o braço
mechanism-two_radii = a roda {$link} de {$teeth} dentes teria dois raios primitivos, {$first} e {$second}: confira dentes e distâncias entre centros
mechanism-belt_without_room = as rodas {$first} e {$second}, com raios {$radii}, estão a uma distância de {$distance}: assim uma correia não pode passar em volta delas; verifique o raio e a distância
mechanism-along_its_x_axis = corrediça {$link}: ao longo da guia fica o eixo x de sua forma, e não seus pontos {$points}, que nas formas têm a direção da guia: se ambas as formas são lugares de um mesmo desenho, acrescentar "turned": {$turned}
mechanism-off_guide = o cursor {$slider} não está em sua guia: está em {$position}, e a guia vai de {$low} a {$high}; o que disso segue não vale aqui
mechanism-holds_here_alone = o contato de {$first} e {$second} é conhecido só nesta posição: seu mecanismo equivalente dá aqui velocidades, acelerações e forças, e nada em outra parte

# Too few or too many constraints.

mechanism-one_link = elo {$link}
mechanism-several_links = elos {$links}
mechanism-one_free_motion = 1 movimento livre
mechanism-free_motions = {$count} movimentos livres
mechanism-can_still_move = {$links}: movimento ainda não determinado ({$free})
mechanism-add_a_drive = acrescente ali 1 acionamento ou uma junta
mechanism-add_drives = acrescente ali {$count} acionamentos ou uma junta
mechanism-one_constraint = 1 restrição
mechanism-constraints = {$count} restrições
mechanism-cannot_move = {$links}: sem movimento possível com esse acionamento (em excesso: {$surplus})
mechanism-take_away = retire dali um acionamento ou uma junta
mechanism-one_drive = 1 acionamento
mechanism-drives = {$count} acionamentos
mechanism-mobility = mobilidade 3·{$links} − {$constraints} = {$mobility} com {$drives}

# Drives.

mechanism-one_ground_point = o elo {$link} está acionado, portanto deve ter um ponto na base; tem {$count}
mechanism-list_pivot = ponha o ponto em torno do qual ele gira em `ground` e entre os pontos do elo
mechanism-driven_link = o elo {$link}
mechanism-driven_slider = o cursor {$slider}
mechanism-two_angles = os elos {$first} e {$second} dão ambos um ângulo; só o de um elo pode substituir o de um acionamento
mechanism-remove_one = remova um dos dois; ângulos aproximados ficam em `near`
mechanism-angle_without_drive = o elo {$link} dá um ângulo, mas nenhum elo tem acionamento
mechanism-add_drive = acrescente um acionamento com `omega` ao elo que gira em torno de um ponto da base
mechanism-angle_beside = o elo {$link} dá um ângulo, mas o acionamento que move {$driven} já dá `{$key}`
mechanism-keep_one = mantenha um dos dois; um ângulo aproximado fica em `near`
mechanism-angle_beside_all = o elo {$link} dá um ângulo, mas todos os acionamentos já dizem onde estão
mechanism-two_open_drives = os acionamentos que movem {$first} e {$second} não dizem onde estão; o ângulo do elo {$link} só substitui um
mechanism-add_to_one = acrescente "{$key}" a um deles
mechanism-open_drive = o acionamento que move {$driven} não dá `{$key}`
mechanism-add_angle = acrescente "angle": graus de +x até o eixo do elo; ou dê em seu lugar o `angle` de outro elo
mechanism-add_position = acrescente "position": sua distância ao longo da guia a partir de `through`; ou dê em seu lugar o `angle` de um elo

# Angles that look like radians.

mechanism-angle_of_link = o ângulo do elo {$link}
mechanism-guide_of = a guia de {$slider}
mechanism-near_angle_of = `near` para angle({$link})
mechanism-radians = {$what}: toma-se {$angle}°, que parece estar em radianos: os ângulos são em graus, portanto {$degrees} se é isso o desejado

# Places far away.

mechanism-far_origin = a origem está a {$far} de um mecanismo de cerca de {$size}: dos lugares com 16 algarismos, restam {$digits} para sua forma. Ponha a origem perto


## Errors and warnings: position

position-no_mode = os elos {$links} não podem ser montados{$at}: {$miss}
position-other_angle_or_lengths = outro ângulo do acionamento, ou outros comprimentos
position-angle_from_to = de {$from}° a {$to}°
position-angle_within_or_lengths = um ângulo do acionamento {$ranges}, onde pode ser montado, ou outros comprimentos
position-at_value = {" "}com {$quantity} = {$value}
position-longer = com todo o resto fechado, {$leg} teria de medir {$by} a mais
position-shorter = com todo o resto fechado, {$leg} teria de medir {$by} a menos
position-any_direction = suas juntas externas estão em um mesmo lugar e seus comprimentos são iguais, portanto pode girar ali qualquer ângulo
position-never_meet = suas guias e comprimentos nunca se encontram
position-parallel_guides = os elos {$links} não podem ser montados: as duas guias que se encontram no elo {$link} são paralelas
position-turn_one = `turned` de um de seus cursores, os graus da guia até o eixo do elo, as põe em ângulo
position-too_large = comprimentos de cerca de {$size} são grandes demais para montar com eles: suas quartas potências saem do intervalo dos números
position-too_small = comprimentos de cerca de {$size} são pequenos demais para montar com eles: suas quartas potências saem do intervalo dos números
position-other_unit = outra unidade de comprimento
position-no_such_mode = não existe o modo de montagem {$mode}: há {$count}
position-modes_listed = `kinegon modes` os lista
position-too_many_modes = o modo de montagem {$mode} está longe demais: a contagem parou em {$count}
position-rough_places_choose = lugares aproximados em `near`, que escolhem sem contar
position-too_much_work = não se encontrou nenhuma forma de montar todos os elos: os primeiros podem ser unidos de um número excessivo de formas
position-rough_places = lugares aproximados dos seus pontos em `near`
position-not_found = não se encontrou nenhuma forma de montar os elos {$links}{$at}: {$tried}
position-rough_places_or_other = lugares aproximados dos seus pontos em `near`, outro ângulo do acionamento, ou outros comprimentos
position-moves = os elos {$links} podem se mover com os acionamentos parados, embora sua mobilidade seja 0: nenhuma das montagens achadas é um modo de montagem
position-none_closes = nenhum dos {$starts} começos fecha
position-none_closes_but = nenhum dos {$starts} começos fecha; o mais próximo deixa uma folga de {$gap} do tamanho do mecanismo

# Warnings.

position-unproven = `near` deixa abertas montagens demais para comparar todas, e a que foi tomada talvez não seja a mais próxima: dê nele lugares aproximados de mais pontos
position-at_least = pelo menos {$count}
position-far_off = `near` está a {$distance} (média quadrática) do mais próximo dos modos de montagem (ao todo {$count}), mais da metade do tamanho do mecanismo, {$size}: confira suas coordenadas
position-point_far_off = o ponto {$point} está em [{$x}, {$y}], a {$off} do seu lugar em `near`, no mais próximo dos modos de montagem (ao todo {$count}): confira suas coordenadas
position-not_chosen = os elos {$links} podem ser montados de {$count} formas e `near` não é dado, portanto toma-se o modo 1: {$listed}
position-searched = os elos {$links} formam um grupo de classe superior: seus modos de montagem foram achados por busca, e pode haver mais; não se sabe quantos pode haver
position-searched_of = os elos {$links} formam um grupo de classe superior: {$found} dos seus modos de montagem foram achados por busca, e pode haver mais, mas {$most} no máximo
position-may_move = os elos {$links} podem se mover com os acionamentos parados, embora sua mobilidade seja 0: além dos modos de montagem há toda uma curva de posições
position-nearly_flat = elo {$link}: seus pontos estão quase em linha reta, e `near` serve quase igualmente para seu triângulo e para a imagem espelhada; toma-se o mais próximo. Para escolher, dê seu `shape`, ou lugares em `near` com mais algarismos


## Errors and warnings: motion

motion-singular = os elos {$links} estão em uma posição singular: {$reason} (condição {$condition})
motion-singular_exactly = os elos {$links} estão em uma posição singular: {$reason} (exatamente)
motion-at_limit = posição limite em {$place}: os elos {$links} não podem ir além; suas velocidades e acelerações crescem sem limite: {$reason}
motion-at_change = ponto de mudança em {$place}: os elos {$links} também poderiam seguir em outro modo, portanto suas velocidades não estão determinadas: {$reason}
motion-move_a_joint = outro ângulo da manivela, ou tire uma destas juntas da reta ou do ponto comum
motion-overflow = elos {$links}: uma distância, uma velocidade ou uma aceleração é grande demais para ser representada
motion-larger_units = unidades de comprimento maiores, ou acionamentos mais lentos
motion-near_singular = os elos {$links} estão perto de uma posição singular (condição {$condition}): coordenadas com 16 algarismos determinam cerca de {$digits} algarismos de suas velocidades
motion-near_limit = os elos {$links} estão em uma posição limite ou junto a uma (condição {$condition}): comprimentos e ângulos com 16 algarismos determinam cerca de {$digits} algarismos de suas velocidades

# Why a position is singular.

motion-no_definite_motion = suas malhas não têm movimento definido
motion-in_one_line = {$first} e {$second} estão em uma mesma reta
motion-parallel = as retas {$lines} são paralelas
motion-in_one_point = as retas {$lines} se cruzam em um mesmo ponto
motion-normal_to_guide = por {$through} normal à guia em {$at}
motion-at_infinity = no infinito (guias em {$first} e {$second})


## Errors and warnings: accuracy

accuracy-unproved = elos {$links}: nada se demonstra de sua posição ou de seu movimento, portanto seus números não levam erro
accuracy-pulls = os perfis do contato {$contact} teriam de puxar um ao outro aqui: eles se separam, se nada os mantém juntos
accuracy-unbounded = {$names}: não se pode dar nenhum limite do erro, pois aquilo de que são lidos pode ser zero, ou retas paralelas
accuracy-at_limit = posição limite em {$place}: os elos {$links} não podem ir além; suas velocidades e acelerações crescem sem limite, portanto seus números não levam erro
accuracy-at_change = ponto de mudança em {$place}: os elos {$links} também poderiam seguir em outro modo, portanto suas velocidades não estão determinadas e seus números não levam erro


## Errors and warnings: quantity

quantity-no_quantity = `{$name}` não é uma grandeza; formas conhecidas: omega(2) alpha(2) omega(2/1) alpha(2/1) i(3,1) rpm(2) angle(2) x(D) y(D) v(D) a(D) v(D/G) a(D/G) a_n(D/G) a_t(D/G) a_c(3/2) position(3/2) v_r(3/2) a_r(3/2) L(B,S3) vplan(b,s3) aplan(n_b3,s3) P(1,3) W(2) G(2) d_i(2) rho(D) R(B,2) R_n(B,2) R_t(B,2) N(3/2) M(3/2) h(3/2) T(1) F(3/2) F_i(2) M_i(2) a_cm(2) moment(F1,S3) power(F1) shaking shaking(A); vetores também com .x .y .size .angle, segmentos dos polígonos com /mu
quantity-no_link = `{$quantity}`: não existe aqui o elo `{$name}`
quantity-no_slider = `{$quantity}`: não existe aqui o cursor `{$name}`
quantity-no_point = `{$quantity}`: não existe aqui o ponto `{$name}`
quantity-no_load = `{$quantity}`: aqui não há nenhuma carga `{$name}`
quantity-no_plan_point = `{$quantity}`: não existe aqui o ponto `{$name}` do polígono
quantity-did_you_mean = {$message}; você quis dizer `{$name}`?
quantity-no_value = `{$quantity}` não tem valor aqui: {$why}
quantity-on_paper = um comprimento no papel é próprio da figura de uma posição
quantity-without_mu = o nome sem `/mu`
quantity-no_accelerations = não foram pedidas acelerações
quantity-no_axis = o elo não tem eixo
quantity-no_zero = a guia não tem um ponto a partir do qual contar
quantity-no_plan_no_scale = a figura não tem esse polígono e, portanto, nem escala
quantity-scale_too_small = a escala é pequena demais para isso
quantity-no_construction = não há construção
quantity-at_infinity = o ponto especial está no infinito
quantity-not_on_one_link = os dois pontos não estão em um mesmo elo
quantity-no_plan = não existe esse polígono
quantity-no_force_plan = não há polígono de forças: a figura precisa do painel "forces"
quantity-two_polygons = as suas pontas são vértices de dois polígonos, que estão lado a lado sem mais
quantity-routes_differ = os polígonos e as equações de equilíbrio diferem mais do que ambos permitem
quantity-no_way = entre estes vértices não há forças com nome próprio; peça a própria força, como R(B,2) ou R_n(B,2)
quantity-centre_at_infinity = o centro está no infinito e tem apenas direção: `.angle`
quantity-centre_at_place = o centro está em um lugar: `.x`, `.y`
quantity-rest_on_another = os elos estão em repouso um em relação ao outro
quantity-link_turns_not = o elo não gira
quantity-ratio_to_rest = `{$link}` não gira, de modo que não há relação com ele
quantity-path_is_straight = a trajetória é reta ali, ou o ponto está em repouso
quantity-place_has_no_size = `{$name}` é um lugar e não tem módulo; peça o seu `.x` ou `.y`
quantity-no_loads = a cena não tem massas, forças nem molas
quantity-no_mass = essa barra não tem massa
quantity-no_inertia = a inércia não é considerada: `"analysis": "static"`
quantity-no_line_of_joints = essa barra não tem ali duas juntas cuja linha se pudesse entender
quantity-no_normal_force = não há força transversal à guia
quantity-no_line_of_action = a força não tem aqui linha de ação, ou nenhuma a distância finita
quantity-not_driven = não é acionado
quantity-not_at_pin = esse elo não tem junta nesse pino
quantity-no_forces = as suas cargas saem do domínio dos números, a posição é singular ou o atrito bloqueia-o
quantity-nowhere_in_range = não o tem em nenhuma posição do intervalo
quantity-no_scale_in_table = uma tabela não tem escala


## Errors and warnings: forces

forces-spring_without_direction = as extremidades da mola {$spring} coincidem nesta posição, de modo que a sua força não tem direção: não se mostram forças
forces-friction_locks = o atrito bloqueia o mecanismo nesta posição: nenhum acionamento o move neste sentido, pelo que não se mostram forças
forces-friction_at_rest = em repouso o atrito pode ser qualquer um até ao seu limite: em {$joints} conta como nulo, e os erros indicados admitem-no todo
forces-friction_leaves_open = em repouso o atrito pode ser qualquer um até ao seu limite, e o de {$joints} deixa em aberto o que as juntas suportam: não se mostram forças


## Errors and warnings: cycle

cycle-drawn = uma configuração desenhada não pode ser movida: não tem comprimentos
cycle-lengths_and_drive = uma cena com `lengths` ou `shape` e um acionamento com seu `angle` ou `position`
cycle-at_contact = os perfis que se tocam são conhecidos só em seu contato, portanto o mecanismo não pode ser movido
cycle-say_circular = "circular": true no contato, se ambos os perfis são círculos em torno destes centros, ou um círculo e uma reta
cycle-off_guide = o cursor {$slider} não está em sua guia aqui, portanto nada o move
cycle-on_guide = comece onde ele está dentro do seu `travel`
cycle-other_kind = o mecanismo {$number} não é do tipo do mecanismo 0
cycle-same_kind = os mesmos elos, juntas e acionamentos na mesma ordem; só podem diferir comprimentos, lugares e acionamentos
cycle-no_drive = não há nenhum acionamento a mover
cycle-give_drive = dê a um elo um "drive"
cycle-no_such_drive = não existe o acionamento `{$name}`; os acionamentos são: {$known}
cycle-singular = os elos {$links} estão em uma posição singular com {$at}, portanto não está decidido por onde seguem
cycle-at_limit = posição limite em {$place}: os elos {$links} não podem ir além; suas velocidades e acelerações crescem sem limite; por qual de dois caminhos voltam não está decidido
cycle-at_change = ponto de mudança em {$place}: os elos {$links} também poderiam seguir em outro modo; por qual seguem não está decidido
cycle-other_position = uma cena em outra posição do acionamento; o percurso acha o caminho a partir dali
cycle-out_of_reach = não se pode alcançar o intervalo de {$from} até {$to}: {$stop}
cycle-within_reach = um intervalo que contenha uma parte de {$low} a {$high}
cycle-no_vector = `{$name}` não é um vetor
cycle-vectors = v(D), v(D/G), a(D), a_n(D/G), a_t(D/G), a_c(3/2) com nomes desta cena
cycle-no_path = `{$name}` não é um ponto de um elo que se mova, portanto não tem trajetória
cycle-not_finite = os extremos do intervalo devem ser números finitos
cycle-too_many_turns = o intervalo vai além de cem voltas
cycle-too_far = o intervalo vai além de cem vezes o tamanho do mecanismo
cycle-values_between = valores entre {$low} e {$high}
cycle-no_range = o intervalo de {$quantity} não está dado
cycle-both_ends = tanto --from como --to: este cursor não dá uma volta completa nem tem dois extremos
cycle-no_step = o passo não pode ser {$step}
cycle-distance_of_rows = a distância de uma linha à seguinte, como 1
cycle-step_leads_away = um passo de {$step} se afasta do fim do intervalo
cycle-positive_step = um passo positivo; seu sinal decorre do intervalo
cycle-too_many_steps = há mais de {$most} passos de {$step} de {$from} até {$to}
cycle-larger_step = um passo maior
cycle-no_room = de {$from} até {$to} não há espaço para uma curva
cycle-table_too_long = a tabela teria {$rows} linhas de {$columns} números
cycle-sweep_or_fewer = escreva-a com `kinegon sweep`, ou nomeie menos grandezas no `want` da cena
cycle-more_room = um intervalo com mais espaço entre --from e --to


## Errors and warnings: editing

editing-no_object = uma cena é um objeto {"{"} … {"}"}
editing-no_entry = esta lista tem {$count} entradas, e não existe a {$key}
editing-no_room = não há aqui lugar para {$key}
editing-not_all = uma cena não pode ser removida do seu texto
editing-point_twice = o ponto {$point} aparece duas vezes no novo elo
editing-no_points = um novo elo não tem pontos
editing-name_one = nomeie pelo menos um
editing-point_on_link = o elo {$link} já tem um ponto {$point}
editing-link_unknown = não se sabe onde está o elo {$link} na posição presente
editing-point_unknown = não se sabe onde está o ponto {$point} na posição presente
editing-rough_places = dê lugares aproximados em `near`
editing-slides_on_own = o ponto {$point} já é um ponto de {$on}, portanto não pode deslizar ali
editing-other_point = escolha outro ponto, ou outro portador da guia
editing-in_one_place = o elo {$link} teria {$first} e {$second} em um mesmo lugar
editing-one_name_or_move = use um só nome para ambos, ou mova um
editing-no_place = isto não é um lugar
editing-drawn = uma configuração desenhada não pode ser movida
editing-give_lengths = dê o mecanismo por comprimentos, com um acionamento
editing-no_position = a posição não pode ser escrita com valores dos acionamentos
editing-other_position = tome outra posição
editing-near_cannot_choose = os lugares aproximados não podem escolher o modo {$mode}
editing-point_there = já existe um ponto {$name}
editing-link_there = já existe um elo {$name}
editing-other_name = escolha outro nome
editing-no_point = não existe o ponto {$name}
editing-no_link = não existe o elo {$name}
editing-table_no_number = linha {$line}, coluna {$column}: não há um número
editing-table_one_column = não há segunda coluna
editing-table_line = escreva um lugar e um fator em cada linha, como `90,1500`
editing-table_first = escreva números simples, um lugar e um fator, como `90,1500`; uma primeira linha que nomeia as colunas não tem números
editing-table_more_cells = a linha {$line} tem {$cells} células, e a primeira linha {$first}
editing-table_marks = separe as células por ponto e vírgula se os números têm vírgula decimal
editing-table_unnamed = há mais de duas colunas, e a primeira linha não as nomeia
editing-table_head = nomeie as colunas na primeira linha, as de cargas como a cena as nomeia
editing-table_no_column = não há coluna para `{$load}`
editing-table_nameless = não há coluna para esta carga, que não tem nome
editing-table_name = nomeie uma coluna na primeira linha como a cena nomeia a carga
editing-table_long = há mais de {$most} linhas
editing-table_shorten = omita linhas que uma reta dá igualmente

# Why a joint that is pulled does not follow the hand.

editing-held_point = {$point} está fixado
editing-held_length = {$point} se move em uma circunferência: {$length} está fixado
editing-held_angle = {$point} se move em uma reta: o ângulo do elo {$link} está fixado
editing-held_guide = {$point} se move em uma reta: a guia de {$slider}
editing-held_rack = {$point} move-se através da sua guia: ao longo dela a cremalheira vai com a sua roda
editing-held_nowhere = a junta não pode ir até ali
editing-held_rounded = com a junta ali, os comprimentos arredondados não deixam às outras juntas um lugar perto do seu
editing-held_try = puxe a junta para outro lugar


## Errors and warnings: drawing

drawing-scheme = esquema
drawing-velocity_plan = polígono de velocidades
drawing-acceleration_plan = polígono de acelerações
drawing-centers = a figura de centros instantâneos
drawing-force_plan = plano de forças
drawing-lever = alavanca
drawing-speeds = diagrama de Kutzbach
drawing-overflow = o {$panel} não cabe no seu painel com {$key} = {$given} e fica cortado ali; cabe com {$fitting}, ou em uma folha maior
drawing-no_scale = nenhuma
drawing-cost_of_list = as escalas deixam espaço para a lista de resultados: {$scales}
drawing-cost_of_names = as escalas deixam espaço para a lista de nomes: {$scales}
drawing-in_place_of = {$scale} = {$now} em vez de {$before}
drawing-too_many_panels = {$wanted} tipos de grandezas precisam de {$wanted} painéis, e a folha tem espaço para {$room}
drawing-fewer_or_page = menos grandezas de uma vez, ou outra `page` na figura da cena, como "a4-portrait"
drawing-too_many_curves = {$wanted} curvas em um painel são mais do que se podem distinguir, que são {$most}
drawing-fewer_quantities = menos grandezas de uma vez
drawing-no_film_of = uma volta de um filme não pode durar {$seconds} segundos
drawing-at_most_seconds = mais de 0 e no máximo {$most} segundos
drawing-no_film_at = um filme não pode ter {$count} imagens por segundo
drawing-pictures_a_second = de 1 a {$most} imagens por segundo
drawing-no_motion = {$seconds} segundos com {$count} imagens por segundo não mostram movimento
drawing-longer_or_more = mais tempo, ou mais imagens por segundo
drawing-film_too_long = o filme teria {$count} imagens; pode ter {$most}
drawing-film_of_turns_too_long = o filme teria {$count} imagens em {$turns} voltas do acionamento; pode ter {$most}
drawing-less_or_fewer = menos tempo por volta, ou menos imagens por segundo
drawing-no_sheet = não existe a folha {$number}; há {$count}
drawing-no_step = não existe o passo {$step}; há passos de 1 a {$count}
drawing-drive_stands = o acionamento `{$drive}` não pode se mover


## Errors and warnings: check

check-two_values = `{$name}` tem aqui dois valores: {$one} e {$two}
check-keep_one = mantenha o que você quer dizer
check-form_empty = o formulário está vazio: não tem valores a conferir
check-write_values = escreva seus valores ao lado dos nomes; `kinegon check SCENE --template` escreve o formulário
check-points_without_scale = os lugares dos pontos estão em milímetros de papel, mas falta sua escala {$scale}
check-add_scale_of = acrescente {$scale}, a escala do seu {$sheet}
check-no_pole = os lugares do {$sheet} não têm seu polo {$pole}
check-no_origin = {$sheet}: falta o lugar de {$point}, a partir do qual os outros são medidos
check-add_pole = acrescente "{$pole}": [x, y]
check-no_length_on_paper = `{$name}` não é um comprimento no papel, portanto não pode levar `/mu`
check-write_in = escreva-o em {$unit}
check-no_sheet = à figura da cena falta seu {$sheet} e, portanto, a escala
check-add_scale_or_panel = acrescente {$scale} aos valores, ou o painel à figura da cena
check-no_number = `{$text}` não é um número
check-write_digits = escreva algarismos com ponto decimal, como 61.5; deixe em branco o que não mediu
check-too_large = `{$text}` é grande demais
check-wrong_digit = há um algarismo ou um expoente errado?
check-paper_without_scale = `{$name}` está em milímetros de papel, mas falta sua escala {$scale}
check-add_scale = acrescente {$scale}: quantos {$unit} vale 1 mm do seu {$sheet}
check-unit_on_paper = `{$name}` está em milímetros de papel, mas ao lado diz `{$unit}`
check-unit_or_mu = omita a unidade, ou o `/mu`
check-no_unit_of = `{$text}` não é uma unidade de {$kind}
check-write_unit = escreva `{$unit}`, ou omita a unidade
check-did_you_mean = você quis dizer `{$name}`?
check-template_lists = `kinegon check SCENE --template` lista os nomes
check-nearest_name = o nome mais parecido é `{$name}`; `kinegon check SCENE --template` lista os nomes
check-no_quantity = `{$name}` não é uma grandeza desta cena
check-no_box = nenhum passo acha `{$name}`, por isso um formulário não tem campo para isso
check-pi_lost = a letra π se perdeu em `{$name}`
check-save_as_utf8 = salve como CSV UTF-8, ou escreva pi
check-too_many = um formulário tem no máximo {$most} valores, e aqui há {$count}
check-is_this_a_form = isto é um formulário? `kinegon check` sem formulário imprime um vazio
check-no_scale = {$scale} não é uma escala
check-scale_is_positive = uma escala é um número positivo: unidades da cena por milímetro de papel
check-not_understood = {$count} coisas deste formulário não são entendidas:{$all}
check-line = linha {$number}

# Kinds of quantities, and sheets.

check-angle = ângulo
check-angular_velocity = velocidade angular
check-rotational_speed = uma velocidade de rotação
check-speed_ratio = uma relação de velocidades angulares
check-angular_acceleration = aceleração angular
check-position = posição
check-length = comprimento
check-velocity = velocidade
check-acceleration = aceleração
check-force = uma força
check-moment = um momento
check-power = uma potência

# Tables.

check-open_quotation = aqui abrem-se aspas que não se fecham nesta linha: as linhas seguintes perder-se-iam
check-close_quotation = feche-as, ou retire-as
check-no_table = isto não é uma tabela: {$error}
check-write_lines = escreva uma linha `quantity,value` por valor; nomes com vírgula ficam entre aspas duplas
check-value_without_name = `{$text}` está aqui sem o nome de uma grandeza
check-value_in_unit = `{$text}` está no lugar da unidade, sem nenhum valor antes
check-no_sense = `{$text}` não é um sentido de rotação
check-write_sense = escreva `clockwise` ou `counter-clockwise`
check-values_in = valores em `{$unit}` não são entendidos
check-not_upright = `{$text}` não diz se as folhas estão na posição de impressão
check-no_count = `{$text}` não é um número de dicas
check-whole_number = escreva um número inteiro a partir de 0, ou remova a linha
check-true_or_false = escreva `true` se estão como foram impressas, senão `false`
check-mm_or_units = escreva `mm` para milímetros de papel, ou `units` para as unidades da cena
check-no_coordinate = `{$text}` não é uma coordenada
check-write_coordinates = escreva x e y em milímetros de papel, como velocity:b,114,-2.7
check-no_radius = `{$text}` não é um raio
check-write_radius = depois de x e y pode estar a que distância dali o ponto pode ficar, em milímetros de papel, como velocity:b,114,-2.7,0.2
check-scale_no_number = {$scale} é `{$text}`, que não é um número
check-write_scale = escreva unidades da cena por milímetro de papel, como 2 ou 0.5

# Marks.

check-no_part = {$number} não é uma parte dos pontos
check-part_from_0 = escreva um número de 0 (nenhum ponto) a 1 (todos os pontos da grandeza)
check-no_marks = {$number} não é um número de pontos
check-marks_from_0 = escreva um número de 0 a {$most}
check-marks_twice = `{$name}` é a mesma grandeza e já tem seus pontos
check-no_marks_at_all = a pontuação não dá pontos por nada
check-add_each = acrescente "each": 1, ou pontos para as grandezas que contam

# Refusals of pages.

check-tolerance = a tolerância de um lápis vai de 0 a {$most}
check-no_photograph = não há nenhuma fotografia


## Errors and warnings: exercise

exercise-no_construction = seus polígonos não têm uma construção que se desenhe à mão: um ponto especial está no infinito, ou um grupo é de classe superior à IV
exercise-nothing_to_find = na figura dos centros instantâneos não há nada a achar: os centros que ela mostra estão em articulações e guias; indique outros em `figure.centers`, ou pontos em `figure.velocities`
exercise-gave_up = nenhuma de {$tries} variantes se desenha bem à mão; na maioria das vezes ({$percent} %) porque {$most}
exercise-numbers = os números não são compatíveis
exercise-assembly = os elos não se alcançam
exercise-singular = a posição está perto demais de uma singular
exercise-no_plans = não há construção dos polígonos
exercise-routes = a construção não é exata o bastante
exercise-crossing = há retas que se cruzam com menos de 20°
exercise-sheet = um ponto especial ou um polígono não cabe na folha
exercise-short = um segmento é curto demais: um a medir com menos de 5 mm, ou um a traçar com menos de 4 mm
exercise-unsure = uma velocidade ou aceleração não se acha à mão com erro de até 15 %
exercise-center_far = um centro instantâneo fica longe demais para a folha
exercise-centers_close = dois centros instantâneos distam menos de 6 mm
exercise-center_distance = uma distância de que se obtém uma velocidade mede menos de 15 mm
exercise-center_unsure = um centro instantâneo não se acha à mão com 2 mm
exercise-forces_cross = direções de forças cruzam-se a menos de 15°
exercise-force_short = uma força mede menos de 8 mm
exercise-arm_short = um braço mede menos de 10 mm
exercise-forces_unequal = uma força é menos de um quadragésimo de outra
exercise-forces_unequal_as = uma força é menos de um quadragésimo de outra, como {$small} de {$large} na cena tal como está: tire o que é tão pequeno (a gravidade, uma massa, a inércia com "analysis": "static") ou torne as cargas mais parecidas
exercise-force_unsure = uma força ou um momento não se acha a 8 % à mão
exercise-evened = algumas forças da cena são pequenas demais ao lado de outras para serem desenhadas com elas; os exercícios têm outras cargas: {$changes}
exercise-same = seus números já apareceram antes
exercise-numbered = os exercícios são numerados de 1 a {$most}
exercise-no_such = não existe esse exercício
exercise-whole_seed = uma semente é um número inteiro


## Errors and warnings: photo

photo-no_sheet = não se encontra na foto nenhuma folha com marcas
photo-one_marker = só se encontra na foto uma das oito marcas da folha
photo-few_markers = só se encontram juntas na foto {$count} das oito marcas da folha
photo-whole_sheet = tire a foto de cima, com toda a folha e seus oito quadrados pretos, nítida e sem a mão na frente; folhas impressas sem marcas não podem ser lidas
photo-cut_off = a foto acaba antes da folha: alguns dos seus oito quadrados pretos ficam de fora
photo-step_back = tire a foto de mais longe, com os oito quadrados pretos dentro
photo-mirrored = a foto está espelhada
photo-unmirror = tire-a com a câmera traseira do telefone, ou desligue o espelhamento
photo-not_even = a folha não está plana: suas marcas estão a {$mm} mm de onde estariam em uma folha plana
photo-bent = a folha está curvada: seu centro está {$mm} mm acima ou abaixo das bordas
photo-flatten = aperte a folha, sob um vidro ou com pesos nas bordas, e tire a foto de novo
photo-blurred = a foto está desfocada: as bordas sobre a folha têm {$mm} mm de largura
photo-nearer = chegue mais perto, para que a folha encha a foto, com mais luz e a câmera parada
photo-no_code = não se consegue ler o código pequeno do canto inferior direito da folha
photo-light_on_code = tire a foto mais de perto e mais nítida, com luz no código; nada pode estar desenhado sobre ele; fotos enviadas por chat costumam ser pequenas demais
photo-other_page = o código pequeno é de outro formato que o das marcas: a foto mostra partes de duas folhas, ou uma folha cortada
photo-one_whole_sheet = fotografe uma folha inteira, como foi impressa
photo-cut_short = está cortado: o arquivo acaba no meio da imagem
photo-send_again = copie ou envie a fotografia outra vez
photo-second_sheet = a foto mostra também partes de outra folha, que não é lida
photo-each_by_itself = fotografe cada folha separadamente
photo-nothing_drawn = não se encontram na foto linhas de lápis dos polígonos
photo-nothing_in_blur = não se encontram linhas de lápis dos polígonos: a foto está desfocada, as bordas sobre a folha têm {$mm} mm de largura
photo-mark_by_hand = tire uma foto mais nítida, ou marque os pontos na bancada
photo-scaled = todos os pontos encontrados estão {$percent} % longe demais dos polos
photo-scaled_down = todos os pontos encontrados estão {$percent} % perto demais dos polos
photo-measure_ruler = ponha uma régua sobre a que está impressa na folha: se os 50 mm dela não medem 50 mm, a folha foi impressa ajustada à página


## Errors and warnings: board

board-too_many = um desenho tem no máximo {$most} entradas, e aqui há {$count}
board-sheet_too_large = com {$mu} por mm o {$sheet} teria {$metres} m; desenham-se folhas de até {$most} m
board-other_scale = escreva a escala da sua folha, como {$mu}, ou omita {$key}
board-no_formula = `{$text}` não é uma fórmula: não se entende a partir da letra {$place}
board-no_equation = `{$text}` não é uma equação: falta o =
board-not_linear = `{$text}` não é linear nos números procurados
board-no_value = `{$text}` não tem valor
board-no_solution = as equações não têm solução, ou têm muitas
board-taken = `{$name}` não serve de nome: já está dado, ou não é um nome
board-no_point = ainda não há um ponto {$name}
board-no_line = não há uma linha {$name}
board-no_number = {$name} ainda não é conhecido
board-no_direction = {$name} não tem direção
board-no_reference = `{$name}` não dá direção: não é linha, elo nem guia; dois pontos escrevem-se como "B,C"
board-which_points = o elo {$link} não tem exatamente dois pontos: diga entre quais, como "B,C"
board-which_sheet = diga em que folha, como "on": "velocity"
board-two_sheets = as linhas {$one} e {$two} estão em duas folhas
board-no_crossing = as linhas {$one} e {$two} são paralelas
board-line_misses = {$point} não está sobre esta linha
board-lines_of_others = {$point} não está onde estas linhas se cruzam
board-point_elsewhere = {$point} não está aí
board-no_force_of_polygon = o vetor até {$point} não é nenhuma força que falte no polígono
board-no_direction_of_force = {$line} não tem a direção de nenhuma força que feche o polígono
board-polygon_not_closed = o polígono não fecha em {$point}
board-number_wrong = isto não é {$name}
board-nothing_leads_to = nada do que está desenhado leva a {$name}: desenhe ou meça aquilo de que resulta
board-equation_wrong = a equação {$number} não se verifica
board-leads_wrong = com isto, {$name} sai errado
board-drawn_off = esta linha está desenhada a {$mm} mm e {$degrees}° do que se queria
board-point_off = este ponto está marcado a {$mm} mm do que se queria
board-misread = {$name} foi lido a {$mm} mm do desenhado
board-join = linha {$name} por {$one} e {$two}
board-line = linha {$name} por {$point}, {$direction}
board-line_by_eye = linha {$name} a olho
board-cross = {$name} onde se cruzam {$one} e {$two}
board-lay_off = {$name}: {$size} marcado a partir de {$point}, {$direction}
board-like = {$name} sobre {$ends} como no triângulo {$points}
board-mark = {$name} marcado a olho
board-measure = {$name} medido de {$one} a {$two}
board-compute = {$name} = {$formula}
board-typed = {$name} = {$number}, digitado
board-solve = {$names} de equações
board-undo = {$count ->
    [one] desfeita a última entrada
   *[other] desfeitas as últimas {$count} entradas
}
board-parallel = paralela a {$to}
board-normal = perpendicular a {$to}
board-turned = em {$base} com o ângulo de {$from} a {$to}
board-angle = a {$degrees}°
board-link = elo {$name}
board-guide = guia {$name}
board-load = força {$name}
board-drawn_line = linha {$name}
board-ccw = anti-horário
board-cw = horário
board-right = certo
board-wrong = errado
board-follows = decorre disso
board-unused = sem uso
board-undone = desfeito
board-all_right = Todas as operações estão certas.
board-right_so_far = Até aqui cada operação está correta.
board-asked_missing = Ainda se pede: {$names}.
board-asked_missing_many = Ainda se pede: {$names} e mais {$more}.
board-nothing_drawn = Ainda não há nada desenhado.
board-first_wrong = A primeira operação errada é a número {$number}.
board-should = Deveria ser: {$what}
board-no_sheet = a cena não tem esse plano
board-free_hand = Mão livre: ±{$mm} mm e ±{$degrees}° valem como certos
board-all_there = Está tudo.
board-next_line = A seguir vem uma linha: {$sheet}.
board-next_point = A seguir vem {$name}: {$sheet}.
board-next_number = A seguir vem {$name}.

## The workbench: layout

page-layout-described = A figura em palavras
page-layout-notices = O que outros fizeram, e suas licenças
page-layout-back_to_picture = Voltar à figura
page-layout-is_fixed = Pontos fixos: {$points}.
page-layout-is_link = Elo {$name}: {$points}
page-layout-is_driven = acionado, em {$place}
page-layout-is_slider = O bloco {$name} desliza sobre {$on}.
page-layout-is_pin = O pino {$name} desliza sobre {$on}, em uma ranhura.
page-layout-is_ground = a base
page-layout-is_through = Sua guia passa por {$place}.
page-layout-is_known = Movimentos conhecidos: {$points}.
page-layout-means_pole_v = {$name}, o polo: aqui começam todas as velocidades, e aqui tem sua imagem o que está parado.
page-layout-means_pole_a = {$name}, o polo: aqui começam todas as acelerações, e aqui tem sua imagem o que não tem nenhuma.
page-layout-means_image_v = {$name}, a imagem de {$point}: a seta do polo até aqui é a velocidade de {$point}.
page-layout-means_image_a = {$name}, a imagem de {$point}: a seta do polo até aqui é a aceleração de {$point}.
page-layout-means_special = {$name}, o ponto especial do elo {$link}: onde suas retas se cruzam. Ele dá ao polígono sua próxima imagem.
page-layout-means_special_image = {$name}, a imagem do ponto especial do elo {$link}.
page-layout-means_under = {$name}, a imagem do ponto do elo {$link} que está agora sob {$point}.
page-layout-means_normal = {$name}, o extremo de uma componente normal ω²·l. Aqui começa a tangencial.
page-layout-means_coriolis = {$name}, o extremo de uma componente de Coriolis 2·ω·v.
page-layout-means_sliding = {$name}, o extremo de uma componente ao longo de uma guia.
page-layout-means_omega = {$name}, a velocidade angular do elo {$link}.
page-layout-means_alpha = {$name}, a aceleração angular do elo {$link}.
page-layout-tour = Visita rápida
page-layout-tour_pull = Puxe uma junta: o mecanismo se move, e os polígonos das suas velocidades e acelerações o seguem, em escala.
page-layout-tour_steps = Passos mostra como os polígonos são desenhados à mão, linha por linha.
page-layout-tour_own = Mecanismo tem cada número para digitar, e outros mecanismos para começar. Os outros painéis desenham, conferem e salvam.
page-layout-tour_next = Próximo
page-layout-tour_leave = Sair
page-layout-tour_done = Começar
page-layout-skips = Saltar
page-layout-skip_picture = Para a figura
page-layout-skip_panels = Para os painéis
page-layout-skip_motion = Para o movimento
page-layout-toolbar = Cena e ferramentas
page-layout-picture = Figura
page-layout-panels = Painéis
page-layout-untitled = Cena
page-layout-documents = Cenas e arquivos
page-layout-open_file = Abrir uma cena ou um formulário…
page-layout-lesson = A cena deste arquivo
page-layout-recent = Trabalhos anteriores
page-layout-forget = Esquecê-los
page-layout-undo = Desfazer (Ctrl+Z)
page-layout-redo = Refazer (Ctrl+Y)
page-layout-undone = Desfeito.
page-layout-redone = Refeito.
page-layout-hand = O que faz puxar uma junta
page-layout-move = Mover
page-layout-move_long = Mover: puxar uma junta move o mecanismo
page-layout-shape = Moldar
page-layout-shape_long = Moldar: puxar uma junta muda comprimentos
page-layout-build = Montar
page-layout-build_long = Montar: compor um mecanismo, completo ou não
page-layout-zoom = Zoom
page-layout-all = Tudo
page-layout-zoom_in = Maior (+)
page-layout-zoom_out = Menor (−)
page-layout-fit = Ajustar (0)
page-layout-motion = Movimento
page-layout-play = Animar (espaço)
page-layout-play_together = Animar (espaço): todos os acionamentos se movem juntos, em proporção às suas velocidades
page-layout-together = Todos os acionamentos se movem juntos, em proporção às suas velocidades. Um controle deslizante move um sozinho.
page-layout-stuck = O acionamento não pode se mover de onde está.
page-layout-pause = Pausar (espaço)
page-layout-speed = Ritmo
page-layout-link = Elo {$name}
page-layout-slider = Cursor {$name}
page-layout-drive_at = {$name} está em
page-layout-drive_unread = “{$typed}” não é um número aqui. Escreva um, se quiser com unidade: 60°, 0,5 rad, 12 cm.
page-layout-steps = Passos
page-layout-steps_long = Passos da construção
page-layout-first = Primeiro passo (Home)
page-layout-back = Passo atrás (←)
page-layout-forward = Passo à frente (→)
page-layout-last = Figura pronta (End)
page-layout-step = Passo
page-layout-step_of = Passo {$number} de {$count}
page-layout-finished = Figura pronta, {$count} passos
page-layout-coarse = Passos grandes
page-layout-language = Idioma
page-layout-full = Tela cheia (p)
page-layout-leave_full = Sair da tela cheia (Esc)
page-layout-dark = Escuro ou claro (d)
page-layout-help = Ajuda (?)
page-layout-help_title = O que é isto, e o que fazer agora?
page-layout-way_new = Nunca viu um polígono?
page-layout-way_new_how = Cada seta a partir do polo é a velocidade (ou a aceleração) de um ponto, em escala: duas vezes mais longa é duas vezes mais rápido. Puxe uma junta e observe as setas. Pare sobre uma letra, ou toque nela, para ler o que significa. Os números estão em Valores; o que fazem em uma volta, em Curvas.
page-layout-way_lecture = Uma figura para a aula
page-layout-way_lecture_how = Escolha um mecanismo parecido com o seu e digite seus números, ou componha-o com Montar. Figura escolhe a folha, seu idioma e seu estilo. Passos desenha os polígonos linha por linha; P enche a tela. Salvar tem PDF, SVG, TikZ, um filme e um link para estudantes.
page-layout-way_student = Um exercício
page-layout-way_student_how = Desenhe os dois polígonos em papel com as escalas dadas, meça e digite o que mediu em Conferir, ou fotografe sua folha. A conferência diz em que passo algo deu errado.
page-layout-way_go = Abrir {$panel}
page-layout-letters = Letras nos polígonos (notação usual)
page-layout-letter_poles = polos: em p começam todas as velocidades, em π todas as acelerações
page-layout-letter_images = imagens dos pontos B, C: a seta do polo até b é a velocidade de B (no outro polígono, sua aceleração)
page-layout-letter_normal = extremo de uma componente normal ω²·l; ali começa a tangencial
page-layout-letter_coriolis = extremo de uma componente de Coriolis 2·ω·v
page-layout-letter_special = pontos especiais de grupos de terceira e quarta classe, e suas imagens
page-layout-letter_scale = escalas: um comprimento em mm na folha, vezes μ, é o valor
page-layout-more = Mais
page-layout-keys = Teclas
page-layout-keys_letters = As letras servem de teclas
page-layout-close = Fechar
page-layout-key_steps = passo atrás, passo à frente
page-layout-key_ends = primeiro passo, figura pronta
page-layout-key_drive = girar o acionamento 1° (com Shift 0,1°)
page-layout-key_play = animar, pausar
page-layout-key_panels = esquema, velocidades, acelerações, tudo
page-layout-key_zoom = maior, menor, ajustar
page-layout-key_hand = mover, moldar, montar
page-layout-key_full = tela cheia
page-layout-key_dark = escuro ou claro
page-layout-key_undo = desfazer, refazer
page-layout-key_joint = em uma junta: movê-la 1 mm da folha (com Shift 0,1 mm)
page-layout-key_escape = devolver ao lugar o que se arrasta; de um painel para sua aba
page-layout-joint = Junta {$name}
page-layout-fixed_joint = Ponto fixo {$name}
page-layout-joint_hint = As setas a movem, com Shift mais fino. Esc a devolve ao lugar.
page-layout-mend_first = A cena tem um erro. Corrija-o antes de mover algo.
page-layout-no_picture = Ainda não há figura. A mensagem acima diz por quê.
page-layout-to_text = Mostrar no texto
page-layout-go_on = Continuar montando
page-layout-warning = 1 aviso
page-layout-warnings = {$count} avisos
page-layout-busy = Calculando…
page-layout-put_back = Devolvido.
page-layout-stop = Parar
page-layout-stopped = Parado. A cena não mudou.
page-layout-too_slow = Isto levou mais de {$seconds} s e foi parado. A cena não mudou.
page-layout-fell = O motor de cálculo parou de repente e foi reiniciado. A cena não mudou.
page-layout-link_broken = O link está danificado ou cortado, portanto nenhuma cena pôde ser lida dele. O que havia aqui ficou.
page-layout-link_newer = O link foi feito por uma versão mais nova do Kinegon. Peça a cena como arquivo, ou abra o link com essa versão.
page-layout-link_too_large = O link contém mais texto do que uma cena pode ter, portanto não foi lido.
page-layout-file_too_large = O arquivo “{$name}” tem mais de 4 MB, mais do que uma cena ou um formulário pode ter.
page-layout-unread_file = O arquivo “{$name}” não pode ser lido.
page-layout-forms_first = Dos {$count} formulários só “{$name}” está aberto: esta página aceita um de cada vez. Para uma turma inteira, ponha os formulários numa pasta e execute: kinegon check scene.json forms/
page-layout-forms_left = Os desenhos estão na prancheta; os formulários ficaram de fora. Para uma turma inteira, ponha os formulários numa pasta e execute: kinegon check scene.json forms/
page-layout-files_first = Dos {$count} arquivos só “{$name}” está aberto: esta página aceita um de cada vez.
page-layout-opened_file = “{$name}” foi aberto. Desfazer traz de volta o que havia.
page-layout-exam_open = Numa prova só se pode abrir um desenho próprio.
page-layout-no_storage = Este navegador não guarda nada desta página. Salve a cena em um arquivo antes de fechá-la.
page-layout-restored = Sua última cena está de volta.
page-layout-course_deaf = O curso não está recebendo a nota agora. O que você escreve fica nesta página; salve também o formulário no painel Conferir, para poder entregá-lo de outro modo.
page-layout-course_again = Reenviar
page-layout-course_hears = O curso já tem a nota.
page-layout-worked_before = Esta é a cena do arquivo. Você já trabalhou nela antes: “{$title}”, {$when}.
page-layout-take_up = Continuar com ela
page-layout-as_paper = Papel
page-layout-as_paper_long = Papel: a folha que é salva e impressa, com as suas escalas. Sem ele a figura enche a tela, com escalas próprias da tela.
page-layout-below = Curvas
page-layout-splitter = Largura do painel
page-layout-start_failed = O Kinegon não pôde iniciar: {$why}. É preciso um navegador de 2023 ou posterior.


## The workbench: build

page-build-stage = Montar: {$count} pontos
page-build-tools = O que fazer
page-build-tool_select = Escolher
page-build-tool_link = Elo
page-build-tool_third = Ponto em um elo
page-build-tool_fixed = Ponto fixo
page-build-tool_slider = Cursor
page-build-tool_cylinder = Cilindro
page-build-tool_drive = Acionar
page-build-tool_drop = Remover
page-build-tool_load = Carga
page-build-hint_select = Arraste um ponto ou um elo para movê-lo. Um clique mostra seus números, dois permitem digitá-los. Shift acrescenta à escolha.
page-build-hint_link = Arraste de junta a junta, ou de um lugar vazio a outro.
page-build-hint_third = Arraste de um elo até onde deve ficar seu novo ponto.
page-build-hint_fixed = Clique em um ponto para fixá-lo ou soltá-lo; um lugar vazio recebe um novo.
page-build-hint_slider = Arraste do ponto que desliza: até um elo que o guia, ou na direção de uma guia na base.
page-build-hint_cylinder = Arraste de junta a junta: um cilindro e sua haste, que um acionamento afasta.
page-build-hint_drive = Clique em um elo com um ponto fixo, ou em um bloco: ele passa a ser acionado, ou deixa de ser.
page-build-hint_drop = Clique em um ponto ou em um elo para removê-lo.
page-build-hint_load = Arraste do elo para onde a força aponta: um passo da grade são 10 unidades. Um toque põe um binário no elo. A ponta de uma seta muda a sua força, a haste desloca-a; um arco arrasta-se para mudar o binário.
page-build-second = Agora o outro extremo.
page-build-key = Tecla {$key}
page-build-what_slides = O que desliza
page-build-slides_block = Bloco no pino
page-build-slides_itself = O próprio elo
page-build-slides_pin = Pino em ranhura
page-build-on_link = A guia em um elo
page-build-guided_along = Ao longo do elo
page-build-guided_across = Em ângulo reto
page-build-snap = Grade
page-build-fit = Ajustar
page-build-smaller = Menor
page-build-larger = Maior
page-build-photo = Fotografia…
page-build-photo_scale = Sua escala
page-build-photo_away = Sem fotografia
page-build-photo_two = Clique em dois lugares da fotografia cuja distância você conhece, e depois digite-a.
page-build-photo_length = distância dos dois
page-build-photo_number = Digite-a como um número de {$unit}, por exemplo 120.
page-build-photo_unread = Este arquivo não é uma imagem que o navegador possa mostrar.
page-build-begin = Ainda não há nada. Arraste um primeiro elo.
page-build-complete = Completo. A mão Mover (m) o move.
page-build-incomplete = Ainda incompleto: {$why}
page-build-wants_ground = Ainda incompleto: nada está parado. Fixe pontos, ou dê uma guia na base.
page-build-wants_one = Ainda incompleto: um movimento está livre. Falta um acionamento, ou mais um elo ou ponto fixo.
page-build-wants_more = Ainda incompleto: {$count} movimentos estão livres. Faltam juntas, pontos fixos ou acionamentos.
page-build-too_held = Ainda incompleto: juntas, pontos fixos ou acionamentos a mais: {$count}.
page-build-mobility = (3·{$links} − {$taken} = {$free}, acionamentos: {$drives})
page-build-needs_point = Comece em um ponto que já exista.
page-build-needs_link = Comece em um elo.
page-build-needs_pivot = Um acionamento gira um elo que tem um ponto fixo, ou empurra um bloco na sua guia: este elo não tem nenhum dos dois.
page-build-needs_way = Arraste um pouco mais longe: os dois extremos estão em um mesmo lugar.
page-build-joined_already = Um elo já tem estes dois pontos.
page-build-at_link = elo {$name}
page-build-at_load = carga {$name}
page-build-taken_up = Pego: as setas o movem, Enter o solta.
page-build-put_down = Solto.
page-build-put_back = Devolvido.
page-build-removed = Removido.
page-build-copied = {$count} pontos copiados.
page-build-numbers = Números
page-build-rename = Nome
page-build-fix_it = Fixar
page-build-free_it = Soltar
page-build-drive_it = Acionar ou não
page-build-copy = Copiar
page-build-paste = Colar
page-build-remove = Remover


## The workbench: mechanism

page-mechanism-panel_title = Mecanismo
page-mechanism-about = Geral
page-mechanism-title = Título
page-mechanism-untitled = Sem título
page-mechanism-length_unit = Comprimentos em
page-mechanism-time_unit = Tempos em
page-mechanism-ground = Pontos fixos
page-mechanism-ground_help = Apoios na base. x para a direita, y para cima.
page-mechanism-fixed_point = Ponto fixo
page-mechanism-add_fixed = Ponto fixo
page-mechanism-no_longer_there = Remover o ponto {$name}
page-mechanism-links = Elos
page-mechanism-links_help = Um ponto em dois elos é uma articulação entre eles.
page-mechanism-link = Elo
page-mechanism-link_name = Nome do elo {$name}
page-mechanism-add_link = Elo
page-mechanism-from = Do ponto
page-mechanism-to = Até o ponto
page-mechanism-new_point = novo {$name}
page-mechanism-points = Pontos
page-mechanism-point_name = Nome do ponto {$name}
page-mechanism-drop_link = Remover o elo {$name}
page-mechanism-take_off = Tirar {$name} do elo
page-mechanism-add_point = Ponto
page-mechanism-places_on_link = Lugares no próprio elo; x corre ao longo dele
page-mechanism-give_place = y
page-mechanism-drive_it = Acionar este elo
page-mechanism-drop_drive = Remover o acionamento de {$name}
page-mechanism-drive = Acionamento
page-mechanism-angle = Ângulo
page-mechanism-speed = Velocidade
page-mechanism-turns = Unidade da velocidade
page-mechanism-acceleration = Aceleração
page-mechanism-position = Posição
page-mechanism-axis_angle = Ângulo do eixo
page-mechanism-block = bloco
page-mechanism-unsized = Quatro pontos ou mais precisam de uma forma: tire pontos e acrescente-os de novo.
page-mechanism-moves_as_known = movimento dado
page-mechanism-sliders = Cursores
page-mechanism-sliders_help = Blocos em guias retas e pinos em ranhuras.
page-mechanism-slides_on = {$point} sobre {$on}
page-mechanism-pin_in_slot = pino em ranhura
page-mechanism-what_slides = O que desliza
page-mechanism-sliding_link = Bloco
page-mechanism-at = em
page-mechanism-pin = Pino
page-mechanism-on = Desliza sobre
page-mechanism-ground_word = base
page-mechanism-through = Guia por
page-mechanism-through_usual = seu próprio ponto
page-mechanism-through_place = um lugar x, y
page-mechanism-offset = y (excentr.)
page-mechanism-along = Guia segundo
page-mechanism-along_usual = seu eixo
page-mechanism-along_degrees = um ângulo
page-mechanism-along_direction = uma direção x, y
page-mechanism-degrees = Ângulo
page-mechanism-turned = Girado
page-mechanism-drop_slider = Remover o cursor {$name}
page-mechanism-add_slider = Cursor
page-mechanism-new_block = novo bloco em {$name}
page-mechanism-link_at = elo {$link} em {$name}
page-mechanism-pin_at = pino {$name} em uma ranhura
page-mechanism-rolling = Rodas, correias e cames
page-mechanism-rolling_help = Duas rodas que rolam uma sobre a outra, uma roda sobre uma cremalheira, rodas com uma correia; dois perfis que se tocam, por seus centros e raios de curvatura.
page-mechanism-add_gear = Par de rodas
page-mechanism-wheel = Roda
page-mechanism-runs_on = Rola sobre
page-mechanism-new_wheel = uma roda nova
page-mechanism-new_rack = uma cremalheira nova
page-mechanism-pair_of = {$first} com {$second}
page-mechanism-carried_by = sobre {$name}
page-mechanism-first_wheel = Primeira
page-mechanism-second_wheel = Segunda
page-mechanism-carrier = Quem leva
page-mechanism-teeth_of = Dentes de {$name}
page-mechanism-pitch_radius = Raio primitivo
page-mechanism-touch = Contato
page-mechanism-touch_outside = dentes por fora
page-mechanism-touch_ring_first = a primeira é coroa
page-mechanism-touch_ring_second = a segunda é coroa
page-mechanism-touch_rack_first = a primeira é cremalheira
page-mechanism-touch_rack_second = a segunda é cremalheira
page-mechanism-touch_open = correia aberta
page-mechanism-touch_crossed = correia cruzada
page-mechanism-rack_at_zero = Posição com a roda em 0
page-mechanism-second_at_zero = Segunda roda com a primeira em 0
page-mechanism-pressure = Ângulo de pressão
page-mechanism-add_contact = Contato
page-mechanism-first_center = Centro de curvatura do primeiro
page-mechanism-second_center = Centro de curvatura do segundo
page-mechanism-contact_of = {$first} sobre {$second}
page-mechanism-first_profile = Primeiro
page-mechanism-second_profile = Segundo
page-mechanism-center_at = Centro de curvatura
page-mechanism-radius_of = Raio de curvatura de {$name}
page-mechanism-add_radii = Raios
page-mechanism-second_is = O segundo é
page-mechanism-profile_round = redondo
page-mechanism-profile_roller = um rolete
page-mechanism-profile_flat = plano
page-mechanism-circular = círculos em toda posição
page-mechanism-equivalent = Elo equivalente
page-mechanism-face_through = Face por
page-mechanism-face_along = Face segundo
page-mechanism-travel = Extremos da ranhura
page-mechanism-travel_from = de
page-mechanism-travel_to = a
page-mechanism-drop_travel = Remover os extremos do cursor {$name}
page-mechanism-loads = Massas e forças
page-mechanism-loads_help = Delas segue o que as articulações suportam e o que os acionamentos pedem. As cargas são desenhadas junto ao plano de forças.
page-mechanism-add_force = Força
page-mechanism-add_couple = Binário
page-mechanism-add_mass = Massa
page-mechanism-add_spring = Mola
page-mechanism-add_friction = Atrito
page-mechanism-pin_of = Pino {$name}
page-mechanism-guide_of = Guia {$name}
page-mechanism-friction_of = Atrito: {$name}
page-mechanism-coefficient = Coeficiente de atrito
page-mechanism-friction_angle = Ângulo de atrito
page-mechanism-journal = Raio do munhão
page-mechanism-joint = Junta
page-mechanism-acts_at = Atua em
page-mechanism-acts_on = Atua sobre
page-mechanism-gravity = Gravidade
page-mechanism-drop_gravity = Remover a gravidade
page-mechanism-analysis = Inércia
page-mechanism-with_inertia = conta
page-mechanism-without_inertia = não conta
page-mechanism-mass_unit = Massas em
page-mechanism-force_unit = Forças em
page-mechanism-mass = Massa
page-mechanism-weight = Peso
page-mechanism-inertia = Momento de inércia em relação ao centro de massa
page-mechanism-mass_of = Massa de {$name}
page-mechanism-center = Centro de massa
page-mechanism-drop_mass = Remover a massa do elo {$name}
page-mechanism-on_axis = x ao longo do elo
page-mechanism-load_name = Nome
page-mechanism-force = Força
page-mechanism-couple = Binário
page-mechanism-turns_with_link = gira com o elo
page-mechanism-changes_over = Muda com
page-mechanism-add_over = Ao longo do movimento
page-mechanism-table_lines = Lugar e fator, uma linha cada
page-mechanism-position_of = posição de {$name}
page-mechanism-drop_over = Remover a tabela de {$name}
page-mechanism-drop_load = Remover {$name}
page-mechanism-rate = Força por comprimento
page-mechanism-free_length = Comprimento sem força
page-mechanism-near = De que forma se monta
page-mechanism-near_help = Lugares aproximados de pontos, ou ângulos de elos. O Kinegon toma a montagem mais próxima.
page-mechanism-add_near = Lugar aprox.
page-mechanism-angle_of = ângulo de {$name}
page-mechanism-drop_near = Remover o lugar aproximado de {$name}
page-mechanism-drawn_points = Pontos no desenho
page-mechanism-drawn_help = Esta cena está desenhada: dá coordenadas em vez de comprimentos e não pode ser movida.
page-mechanism-fixed = Fixo
page-mechanism-known = Movimentos dados
page-mechanism-known_help = Pontos cuja velocidade e aceleração são conhecidas.
page-mechanism-add_known = Movimento dado
page-mechanism-drop_known = Remover o movimento conhecido de {$name}
page-mechanism-velocity = Velocidade
page-mechanism-by_parts = como x, y
page-mechanism-by_size = módulo, ângulo
page-mechanism-size = módulo
page-mechanism-known_motion = Seu movimento é conhecido
page-mechanism-drop_motion = Remover o movimento conhecido do elo {$name}
page-mechanism-add_acceleration = Aceleração
page-mechanism-drop_acceleration = Remover a aceleração
page-mechanism-stub = toco
page-mechanism-moving = móvel
page-mechanism-change_kind = Outros mecanismos
page-mechanism-empty = Novo, vazio
page-mechanism-open_file = Abrir…
page-mechanism-groups_bars = Uma malha
page-mechanism-groups_more = Seis elos
page-mechanism-groups_drives = Vários acionamentos
page-mechanism-groups_wheels = Rodas e cames
page-mechanism-groups_class = Terceira e quarta classe
page-mechanism-groups_drawn = Grupos como em um livro-texto
page-mechanism-groups_paper = Do artigo


## The workbench: curves

page-curves-panel_title = Curvas
page-curves-what = O que se desenha
page-curves-curves = Curvas
page-curves-hodograph = Hodógrafos
page-curves-path = Trajetórias
page-curves-choose = Escolher
page-curves-clear = Nenhuma
page-curves-beyond = Também além dos limites do acionamento, tracejado
page-curves-none = Escolha pelo menos uma.
page-curves-drawn = Esta cena dá seus pontos como estão desenhados. Ela não pode ser movida, portanto não há nada ao longo de um ciclo.
page-curves-waits = Desenhando…
page-curves-save = Salvar como {$format}
page-curves-table = Tabela em CSV
page-curves-events = Posições especiais
page-curves-no_events = Nenhuma neste intervalo.


## The workbench: figure

page-figure-language_name = Português
page-figure-panel_title = Figura
page-figure-shown = O que se mostra
page-figure-panels = Painéis
page-figure-focus = Grande
page-figure-none = Todos iguais
page-figure-scales = Escalas
page-figure-scales_help = Da folha que é salva e impressa (“Papel” a mostra); na tela as escalas são próprias dela. Vazia, toma-se a próxima escala redonda que caiba.
page-figure-automatic = automática
page-figure-take = Manter a escala atual {$value}
page-figure-as_before = De novo automática
page-figure-scales_for = As automáticas servem para
page-figure-position = esta posição
page-figure-sheet = cada folha por si
page-figure-cycle = todo o ciclo
page-figure-look = Aspecto
page-figure-style = Estilo
page-figure-paper = Artigo
page-figure-print = Impresso
page-figure-lecture = Aula
page-figure-board = Quadro
page-figure-notation = Notação
page-figure-n_paper = Artigo
page-figure-english = Inglesa
page-figure-russian = Russa
page-figure-german = Alemã
page-figure-sliding = Nas guias
page-figure-coriolis = Índice de Coriolis
page-figure-as_notation = como na notação
page-figure-frame = Base
page-figure-word = por palavra
page-figure-turned = Velocidades
page-figure-not_turned = como são
page-figure-turned_by = giradas de {$angle}°
page-figure-language = Idioma
page-figure-decimal = Decimais
page-figure-point = 2.5
page-figure-comma = 2,5
page-figure-page = Folha
page-figure-page_size = Tamanho
page-figure-landscape = Paisagem
page-figure-portrait = Retrato
page-figure-direction = Orientação
page-figure-worksheet = Folha de trabalho com tabela e régua
page-figure-yes = Sim
page-figure-no = Não
page-figure-contents = Na figura
page-figure-values = Valores
page-figure-usual = conforme o estilo
page-figure-with_unit = comprimentos em {$unit}
page-figure-construction = Construção
page-figure-whole = Inteira
page-figure-as_paper = Como o artigo
page-figure-hidden = Oculta
page-figure-special = Pontos especiais
page-figure-paths = Trajetórias e posições
page-figure-trace = Trajetórias de pontos no ciclo
page-figure-no_trace = Este mecanismo não tem ciclo do qual desenhar trajetórias.
page-figure-beyond = As trajetórias seguem além dos limites
page-figure-ghosts = Posições pálidas dos elos
page-figure-ghosts_unit = no ciclo
page-figure-centers = Centros instantâneos
page-figure-centers_help = O painel dos centros instantâneos escolhe-se em «O que se mostra».
page-figure-wanted_centers = Centros
page-figure-usual_centers = os usuais
page-figure-all_centers = todos
page-figure-these_centers = estes
page-figure-velocities = Velocidades por centros
page-figure-curvature = Curvatura das trajetórias de pontos
page-figure-centrodes = Polares de elos, no esquema
page-figure-inflection = Circunferências de inflexões, no esquema
page-figure-labels = Outras letras
page-figure-labels_help = Mostradas no lugar de um nome. B_1 escreve um subscrito.
page-figure-label_of = Texto para {$name}
page-figure-drop_label = Mostrar de novo o nome {$name}
page-figure-projector = Projetor 16:9
page-figure-own_name = Nome a substituir
page-figure-add_label = Texto


## The workbench: text

page-text-panel_title = Texto
page-text-editor = Texto da cena
page-text-good = O texto é uma cena completa.
page-text-go = Ir até lá
page-text-long = Este texto está em uma linha longa demais para ser mostrada.
page-text-lay_out = Dividir em linhas
page-text-help = Este texto é o documento inteiro: um arquivo de cena do programa. Ctrl+Espaço oferece chaves, Ctrl+F busca, Esc e depois Tab sai.


## The workbench: exercise

page-exercise-panel_title = Exercício
page-exercise-intro = Um mecanismo com outros números redondos, escolhidos para que se desenhe bem à mão. A mesma semente dá os mesmos exercícios, aqui e com kinegon exercise.
page-exercise-kind = Mecanismo
page-exercise-own = A cena aberta: {$title}
page-exercise-seed = Semente
page-exercise-number = Número
page-exercise-page = Folha
page-exercise-page_auto = A4, ou A3 onde for preciso
page-exercise-page_name = {$size} {$way}
page-exercise-landscape = paisagem
page-exercise-portrait = retrato
page-exercise-back = Exercício anterior
page-exercise-forward = Exercício seguinte
page-exercise-large = Vista grande
page-exercise-small = Voltar à figura
page-exercise-making = Buscando um exercício…
page-exercise-student = Para os estudantes
page-exercise-print = Imprimir a 100 %
page-exercise-print_hint = Na janela de impressão, escolha 100 % ou tamanho real, nunca “ajustar à página”. A régua da folha mostra se está certo.
page-exercise-link = Link para estudantes
page-exercise-allow_steps = Com os passos da construção, em palavras
page-exercise-allow_more = Com os próximos exercícios desta semente
page-exercise-link_hint = Ele tem a folha para imprimir, o formulário, a fotografia e sua conferência, também em um telefone. Abre o mecanismo sem os seus polígonos, com o formulário ao lado. Quem quiser ainda pode tirar as respostas da cena: para dar nota, recolha os formulários.
page-exercise-sheet = Folha
page-exercise-form = Formulário
page-exercise-scene = Cena
page-exercise-teacher = Para o professor
page-exercise-show_key = Ver a solução
page-exercise-print_key = Imprimir a solução
page-exercise-key = Solução
page-exercise-key_values = Valores
page-exercise-open = Abrir na bancada
page-exercise-opened = O exercício {$name} está aberto; desfazer traz de volta a cena anterior.
page-exercise-sheet_of = Folha do exercício {$name}
page-exercise-key_of = Solução do exercício {$name}
page-exercise-board_paper = Os polígonos são desenhados em papel
page-exercise-board_practice = Na prancheta: prática
page-exercise-board_at_once = Na prancheta: o erro é avisado na hora
page-exercise-board_exam = Na prancheta: prova, nada é dito
page-exercise-board_demonstration = Na prancheta: ver como se desenha
page-exercise-board_snap = Com que a mão é ajudada
page-exercise-board_snap_all = Pontos e retas encaixam
page-exercise-board_snap_points = Só os pontos encaixam
page-exercise-board_snap_none = Mão livre


## The workbench: values

page-values-panel_title = Valores
page-values-find = Buscar uma grandeza
page-values-digits = Dígitos
page-values-certain = todos os dígitos certos
page-values-few = {$count} dígitos
page-values-copy = Copiar
page-values-save = CSV
page-values-copied = A tabela está na área de transferência.
page-values-not_copied = Este navegador não deixa a página usar a área de transferência. Salve a tabela em CSV.
page-values-quantity = Grandeza
page-values-value = Valor
page-values-unit = Unidade
page-values-error = ±
page-values-count = {$count} de {$all} grandezas
page-values-none = Nenhuma grandeza tem isto no nome.
page-values-about = Todo dígito mostrado é certo; ± diz a que distância o valor pode estar do verdadeiro da cena.
page-values-about_few = Arredondado. “Todos os dígitos certos” mostra cada dígito certo, e a que distância o valor pode estar do verdadeiro da cena.
page-values-groups = Grupos de Assur
page-values-warnings = Avisos


## The workbench: modes

page-modes-panel_title = Modos
page-modes-ghosts = Mostrar os outros, pálidos, na figura
page-modes-single = O mecanismo só pode ser montado de uma forma.
page-modes-drawn = Esta cena dá seus pontos como estão desenhados. Eles só podem ser montados desta forma.
page-modes-count = Com estes comprimentos e esta posição do acionamento há {$count} formas de montá-lo. A cena guarda a que você escolher.
page-modes-mode = Modo {$number}
page-modes-chosen = O modo {$number} foi escolhido.
page-modes-list = Modos de montagem


## The workbench: parts

page-parts-needed = Aqui é preciso um número.
page-parts-unread = Não é um número. Escreva 60, 2,5, 1/3, 2*pi ou sqrt(2), se quiser com unidade: 15 cm.
page-parts-other_unit = {$unit} não pode ser convertida para {$own}.
page-parts-least = Pelo menos {$least}.
page-parts-nameless = É preciso um nome.
page-parts-pin_point = Fixar {$name} ao moldar
page-parts-pin_length = Fixar o comprimento {$name} ao moldar
page-parts-unreadable = O texto da cena tem um erro, por isso o formulário espera. Corrija-o no texto, ou desfaça.
page-parts-mend = Mostrar no texto
page-parts-more = {$title}: tudo
page-parts-table_file = Arquivo (CSV)…


## The workbench: save

page-save-panel_title = Salvar
page-save-old_text = O texto da cena tem um erro. Figuras, números e impressões são os do último texto correto; arquivo de cena, página e link levam o texto como está.
page-save-pictures = Figuras
page-save-figure = Figura
page-save-worksheet = Folha de trabalho
page-save-this_step = Passo {$number}
page-save-png_width = Largura do PNG, em pixels
page-save-as = {$what} em {$format}
page-save-steps = Construção
page-save-coarse = Em uma folha os passos que vão juntos
page-save-sheets = {$count} folhas, {$format} (ZIP)
page-save-steps_text = Texto dos passos
page-save-packing = Folha {$number} de {$count}…
page-save-film = Filme
page-save-film_turn = Uma volta do acionamento
page-save-film_about = O navegador grava a figura enquanto os acionamentos se movem como diz a cena: por seis segundos, ou por seis a cada volta até que o mecanismo esteja onde começou. Mantenha a página à vista; puxar, Animar ou uma mudança da cena interrompe a gravação. GIF, para slides e mensagens, é feito pelo programa: kinegon draw cena.json -o filme.gif
page-save-filming = Gravando…
page-save-film_taken = A gravação foi interrompida: algo foi movido ou mudado.
page-save-film_hidden = A gravação foi interrompida: a página não estava à vista.
page-save-film_stuck = Não há filme: o acionamento não pode se mover de onde está.
page-save-cannot_film = Este navegador não grava filmes. O programa os faz: kinegon draw cena.json -o filme.gif
page-save-numbers = Números
page-save-motion = Movimento ao longo do ciclo (CSV)
page-save-results = Resultados (JSON)
page-save-scene = Cena
page-save-scene_about = O arquivo volta a entrar nesta página e no programa. A página em um só arquivo tem tudo dentro e não precisa de rede: ponha-a em um pendrive, na página do curso, em um e-mail.
page-save-scene_file = Arquivo de cena
page-save-page_file = Esta página com a cena
page-save-page_about = A página não foi carregada inteira e por isso não pode ser salva. Recarregue-a.
page-save-copy_link = Copiar o link
page-save-print = Imprimir a 100 %
page-save-print_now = Imprimir…
page-save-size = {$name} {$width} mm × {$height} mm
page-save-on = Folha {$number} de {$count}
page-save-preview = A folha como é impressa
page-save-to_scale = Na janela de impressão escolha 100 % (tamanho real), este papel e nenhuma margem.
page-save-ruler = A folha de trabalho tem uma régua. Se ela mede 50 mm na impressão, tudo está em escala.
page-save-saved = Salvo: {$name}


## The workbench: links

page-link-of = Link com a cena dentro, {$size} caracteres
page-link-copied = O link está na área de transferência: {$size} caracteres.
page-link-not_copied = Este navegador não deixa a página usar a área de transferência. O link está selecionado: copie-o com Ctrl+C.
page-link-long = Com {$size} caracteres este link é longo demais para alguns programas de e-mail e chats. O arquivo de cena ou a página em um só arquivo são mais seguros.
page-link-local = Esta página foi aberta de um arquivo deste computador: seus links só funcionam aqui. Abra-a na web para compartilhar links, ou compartilhe a página em um só arquivo.


## The workbench: check

page-check-panel_title = Conferir
page-check-check = Conferir
page-check-task = Exercício {$name}
page-check-task_intro = Imprima a folha a 100 %, desenhe nela os polígonos com as suas escalas e depois escreva abaixo o que leu, ou fotografe-a.
page-check-task_sheet = Folha do exercício
page-check-task_print = Imprimir a 100 %
page-check-task_large = Ler a folha
page-check-task_small = Voltar ao mecanismo
page-check-task_drag = Arraste a folha para ver o resto; com dois toques ela aparece inteira.
page-check-task_next = Exercício seguinte
page-check-task_is = Este é o exercício {$name}. Desfazer traz de volta o anterior.
page-check-task_steps = Passos da construção
page-check-task_making = A folha está sendo feita…
page-check-intro = Escreva o que leu no seu desenho, valor por valor. Cada um é conferido assim que está escrito.
page-check-exam = Isto é uma prova: desenhe na prancheta e entregue ali. Antes disso nada é corrigido nem mostrado.
page-check-no_scene = Esta cena não tem formulário a conferir: não pode ser resolvida.
page-check-no_boxes = Esta cena não tem construção à mão; seu formulário não tem campos.
page-check-file = Formulário
page-check-open = Abrir…
page-check-save_json = Salvar
page-check-save_csv = CSV
page-check-clear = Limpar
page-check-marks_open = Pontos…
page-check-marks_drop = Sem pontos
page-check-marks_of = Pontos por {$name}
page-check-opened = O formulário {$name} está aberto: {$count} valores.
page-check-cleared = Todos os valores foram apagados; desfazer os traz de volta.
page-check-name = Seu nome
page-check-scales = 1 mm no seu papel é
page-check-open_long = Abrir um formulário: JSON, ou o CSV de uma planilha
page-check-save_json_long = Salvar o formulário como kinegon check o lê
page-check-save_csv_long = Salvar o formulário para uma planilha
page-check-clear_long = Esvaziar todos os campos
page-check-marks_open_long = Abrir uma pontuação: os valores passam a valer pontos
page-check-marks_drop_long = Conferir sem pontos
page-check-in = Comprimentos e segmentos em
page-check-in_mm = mm de papel
page-check-in_units = valores
page-check-further = Também neste formulário
page-check-unknown = Não entendido
page-check-remove = Remover {$name}
page-check-unit_of = Unidade de {$name}
page-check-on_paper = mm de papel
page-check-is_on_paper = = {$value} mm no papel
page-check-sense_of = Sentido de {$name}
page-check-ccw = anti-horário
page-check-cw = horário
page-check-along = segundo a guia
page-check-against = contra a guia
page-check-choose_sense = escolha o sentido
page-check-choose_senses = Algumas velocidades ou acelerações têm o módulo correto, mas não o sentido: escolha ↺ ou ↻ ao lado delas, + ou − para um deslizamento.
page-check-from_points = dos seus pontos
page-check-typing = …
page-check-not_understood = não entendido
page-check-step = Passo {$step}
page-check-by_points = Marcar pontos do polígono
page-check-points_intro = Clique onde estão os pontos do seu polígono, primeiro o polo, ou nos centros instantâneos a primeira articulação da lista; ou escreva seus lugares em mm, x para a direita, y para cima. O papel pode estar girado.
page-check-plan = Polígono
page-check-points_sheet = Folha do polígono, quadrados de 5 mm. As setas movem a cruz 1 mm, com Shift 0,1 mm; Enter põe o ponto escolhido.
page-check-point = Ponto
page-check-place = Pôr {$name}
page-check-chosen = Agora: {$name}
page-check-all_placed = Todos os pontos têm seu lugar. Arraste um para movê-lo.
page-check-x_of = x de {$name} em mm
page-check-y_of = y de {$name} em mm
page-check-take_away = Tirar {$name}
page-check-placed = {$name} em {$x} mm, {$y} mm
page-check-scale_first = Escreva antes, acima, a escala deste polígono.
page-check-result = O que diz a conferência
page-check-nothing_yet = Ainda nenhum valor.
page-check-to_result = O que houve
page-check-should = Como deve ser
page-check-show_step = Mostrar este passo
page-check-hint = Uma dica
page-check-next_hint = Outra dica
page-check-follows = O que decorre
page-check-hand = Quão exato é seu desenho
page-check-filled = {$filled} de {$all} campos escritos
page-check-first_off = Primeiro ✗
page-check-overlay = Mostrar meu desenho sobre o correto
page-check-overlay_none = Não há o que desenhar: nada está fora.
page-check-overlay_shown = A figura mostra seu desenho sobre o correto: o seu é o tracejado.
page-check-overlay_hide = Voltar à figura
page-check-right_values = Ver os valores corretos
page-check-right_plan = Ver o polígono correto
page-check-right_plan_later = O polígono correto pode ser visto quando em cada campo há um valor que se pode ler.
page-check-right_plan_counts = Isto conta como todas as dicas, e assim fica no formulário.
page-check-right_plan_shown = Agora se veem o polígono correto e todos os valores.
page-check-feedback = Salvar o relatório como página
page-check-mm = mm


## The workbench: photo

page-photo-title = Foto do seu desenho
page-photo-photograph = Foto do seu desenho…
page-photo-take = Fotografe seu desenho
page-photo-choose = Escolher uma foto…
page-photo-intro = Desenhe na folha impressa e fotografe-a, ou solte a foto aqui: o polígono correto fica por cima, e você marca seus pontos. A foto não sai deste aparelho.
page-photo-again = Voltar à fotografia
page-photo-another = Outra fotografia…
page-photo-close = Fechar a fotografia
page-photo-back = Voltar
page-photo-sheet_of = {$name}, folha {$number}
page-photo-right_plan = Polígono certo
page-photo-right_later = O polígono correto pode ser visto quando todos os pontos desta folha estão marcados.
page-photo-larger = Maior
page-photo-smaller = Menor
page-photo-fit = Ajustar
page-photo-undo = Desfazer
page-photo-opening = Abrindo a foto…
page-photo-reading = Lendo a folha…
page-photo-tap = Toque no ponto {$name}
page-photo-tap_in = Toque no ponto {$name} do {$plan}
page-photo-tap_how = Ele vai para o cruzamento das suas linhas de lápis. Mantenha o dedo para ver o lugar ampliado.
page-photo-tap_mouse = Ele vai para o cruzamento das suas linhas de lápis. Mantenha o botão para ver o lugar ampliado.
page-photo-tap_none = Escolha um ponto abaixo e toque onde ele está.
page-photo-at_printed = {$name} está onde está impresso
page-photo-move_how = Arraste-o, ou toque no lugar certo; as setas o movem 0,1 mm.
page-photo-move_touch = Arraste-o, ou toque no lugar certo.
page-photo-outside = Isso não está na folha. Toque no papel.
page-photo-is_right = {$name} está certo
page-photo-is_off = {$name} está fora por {$mm} mm
page-photo-is_open = {$name}: não se pode saber com esta foto
page-photo-open_how = Está a {$mm} mm do seu lugar, e a foto não é nítida o bastante para mais. Tire uma mais de perto e mais nítida, ou meça com uma régua.
page-photo-not_snapped = Ali não se cruzam linhas de lápis: o lugar é conhecido com {$mm} mm. Com a foto maior, ou segurando e ampliando, você mira melhor.
page-photo-leave_out = Omitir {$name}
page-photo-take_away = Tirar {$name}
page-photo-accept = Aceitar {$name}
page-photo-accept_all = Aceitar os {$count}
page-photo-is_here = Este é o seu ponto {$name}?
page-photo-is_here_in = Este é o seu ponto {$name} do {$plan}?
page-photo-proposed_how = Suas linhas de lápis parecem tê-lo ali. Aceite-o, ou toque onde está o seu.
page-photo-next = Próximo
page-photo-looking = Buscando suas linhas de lápis…
page-photo-all_marked = Todos os pontos estão marcados
page-photo-none_left = Não há mais pontos a marcar
page-photo-count_right = certos: {$count}
page-photo-count_off = fora: {$count}
page-photo-count_open = não se pode saber com esta foto: {$count}
page-photo-count_out = omitidos: {$count}
page-photo-see_check = Ver a conferência
page-photo-on_board = Continuar com eles na prancheta
page-photo-other_plan = Fotografar o {$plan}…
page-photo-points = Pontos do {$plan}
page-photo-state_none = não marcado
page-photo-state_printed = como impresso
page-photo-state_out = omitido
page-photo-state_right = certo
page-photo-state_off = fora
page-photo-state_open = não se pode saber com esta foto
page-photo-state_proposed = proposto
page-photo-aim = Lugar de {$name}. As setas o movem 0,1 mm, com Shift 1 mm; Enter o marca.
page-photo-picture = A fotografia
page-photo-moved = {$name} a {$x} mm, {$y} mm de {$origin}
page-photo-bent = A folha está curvada {$mm} mm: aperte-a para ter lugares mais seguros.
page-photo-no_decode = Este navegador não consegue abrir “{$name}” como imagem.
page-photo-no_decode_hint = Use uma imagem JPEG ou PNG. Se o telefone salva em HEIC: tire a foto a partir desta página, ou escolha “Mais Compatível” em Câmera, Formatos.
page-photo-no_scene = A cena tem um erro, portanto não há polígono com que comparar.
page-photo-no_scene_hint = Corrija antes a cena, ou desfaça.
page-photo-other_sheet = Esta é a folha {$number} de {$name}, não desta cena.
page-photo-other_sheet_hint = Abra aqui aquele exercício, ou fotografe a folha deste. Se a cena mudou desde que a folha foi impressa, desfaça a mudança.
page-photo-nameless = outra cena
page-photo-no_plan = Esta folha tem o esquema e nenhum polígono.
page-photo-no_plan_hint = Fotografe a folha de desenho, na qual você desenhou o polígono.


## The workbench: a prancheta

page-board-title = Prancheta
page-board-begin = Desenhar aqui
page-board-go_on = Continuar o desenho
page-board-intro = Desenhe os polígonos na tela com esquadro, compasso de pontas e lápis. A primeira linha errada é indicada.
page-board-close = Voltar
page-board-undo = Desfazer (Ctrl+Z)
page-board-redo = Refazer (Ctrl+Y)
page-board-undone = Desfeito.
page-board-redone = Refeito.
page-board-fit = Mostrar toda a folha
page-board-more = Mais
page-board-tools = Ferramentas
page-board-sheets = Folhas
page-board-all_sheets = Todas
page-board-sheet = Prancheta: {$name}. Letras escolhem ferramentas, N vai ao próximo lugar possível, Enter pressiona.
page-board-list = Operações
page-board-list_none = Ainda não há nada desenhado.
page-board-class = Turma: {$count} desenhos
page-board-class_minutes = {$minutes} min
page-board-class_away = Guardar a turma
page-board-back_to_here = Desfazer a partir daqui
page-board-nothing_here = Nada aqui para esta ferramenta.
page-board-write = Desenhar
page-board-own = próprio
page-board-hint = Dica
page-board-check = Conferir
page-board-hand_in = Entregar
page-board-into_form = Para o formulário
page-board-handed_in = Os valores estão no formulário.
page-board-handed_in_file = Salvo como {$file}, entre os seus downloads. Entregue este arquivo ao professor. Os valores estão no formulário.
page-board-hand_in_drawn = { $count ->
    [one] Há {$count} operação desenhada.
   *[other] Há {$count} operações desenhadas.
  }
page-board-hand_in_name = Seu nome
page-board-hand_in_what = O desenho é salvo como o arquivo {$file}. Entregue esse arquivo ao professor. Depois os seus valores são corrigidos.
page-board-save = Salvar o desenho
page-board-open = Abrir um desenho…
page-board-sheets_pdf = Folhas em papel (PDF)
page-board-no_drawing = “{$name}” não é um desenho: falta `kinegon_drawing`.
page-board-opened = “{$name}” está na prancheta.
page-board-put_back = Voltar ao anterior
page-board-replay = Reproduzir
page-board-end_replay = Voltar a desenhar
page-board-look_on = Reproduzir desenha operação por operação; o controle deslizante vai a qualquer uma delas.
page-board-play = Reproduzir
page-board-pause = Pausa
page-board-speed = Ritmo
page-board-own_construction = Mostrar a construção
page-board-own_drawing = Voltar ao próprio desenho
page-board-first_wrong = Primeira errada: a operação {$number}
page-board-all_right = Está tudo lá, e tudo certo.
page-board-right_so_far = Certo até aqui.
page-board-all_there = Está tudo o que se pede.
page-board-leads_nowhere = { $count ->
    [one] A operação {$numbers} ainda não leva a nenhum ponto do polígono.
   *[other] As operações {$numbers} ainda não levam a nenhum ponto do polígono.
  }
page-board-others_right = Todas as outras estão certas.
page-board-is_right = certa
page-board-is_wrong = errada
page-board-is_follows = decorre de uma errada
page-board-is_unused = ainda não leva a nada
page-board-is_undone = desfeita
page-board-normal = perpendicular a
page-board-parallel = paralela a
page-board-turned = girada do ângulo
page-board-at_base = desde
page-board-angle = com o ângulo
page-board-other_way = No sentido contrário
page-board-quarter = Girar um quarto: ao longo ou através (T)
page-board-as_it_comes = como sai
page-board-sign_back = Tirar a última parte
page-board-ccw = anti-horário
page-board-cw = horário
page-board-rubbed = {$name} foi apagado, com o que dependia dele.
page-board-tool_lay_off = Compasso de pontas: marcar um vetor
page-board-tool_line = Esquadro: reta de direção conhecida
page-board-tool_join = Régua: reta por dois pontos
page-board-tool_cross = Lápis: ponto onde duas retas se cruzam
page-board-tool_like = Imagem: triângulo semelhante
page-board-tool_measure = Medir uma distância
page-board-tool_compute = Calculadora
page-board-tool_solve = Resolver equações
page-board-tool_mark = Lápis: ponto a olho
page-board-tool_rub = Borracha: uma coisa e o que depende dela
page-board-short_lay_off = Compasso
page-board-short_line = Esquadro
page-board-short_join = Régua
page-board-short_cross = Lápis
page-board-short_like = Imagem
page-board-short_measure = Medir
page-board-short_compute = Calcular
page-board-short_solve = Resolver
page-board-short_mark = Ponto
page-board-short_rub = Borracha
page-board-form_lay_off = No {$on} marcar {$size} desde {$from} {$how} {$reference} até {$name}
page-board-form_line = No {$on} reta {$how} {$reference} por {$through} de nome {$name}
page-board-form_join = No {$on} reta por {$first} e {$second} de nome {$name}
page-board-form_cross = {$first} e {$second} se cruzam em {$name}
page-board-form_like = No {$on} como {$three} está para {$one} e {$two} está para {$first} e {$second} o ponto {$name}
page-board-form_measure = No {$on} medir de {$from} a {$to} como {$name}
page-board-form_compute = {$name} = {$as} {$sense}
page-board-form_solve = Para {$solve} resolver {$equations}
page-board-form_mark = No {$on} ponto {$name}
page-board-form_rub = Apagar {$name}
page-board-how_lay_off = Escolha o tamanho, toque o ponto onde começa e depois a barra ou reta que dá a direção.
page-board-how_line = Toque uma barra ou reta: o esquadro se apoia nela. Depois toque o ponto por onde passa a reta. T gira.
page-board-how_join = Toque dois pontos.
page-board-how_cross = Toque onde duas retas se cruzam e escolha o nome do ponto.
page-board-how_like = Toque três pontos de uma barra no esquema e depois as imagens dos dois primeiros.
page-board-how_measure = Toque dois pontos.
page-board-how_compute = Escolha o que é e escreva como se calcula.
page-board-how_solve = Nomeie as incógnitas e escreva uma equação por linha.
page-board-how_mark = Toque onde está o ponto e escolha o nome.
page-board-how_rub = Toque a reta ou o ponto.
page-board-slot_sheet = Folha
page-board-slot_point = Ponto
page-board-slot_scheme = Ponto do esquema
page-board-slot_line = Reta
page-board-slot_direction = Barra, guia ou reta que dá a direção
page-board-slot_how = Como fica
page-board-slot_angle = Ângulo desde +x em graus
page-board-slot_formula = Fórmula
page-board-slot_formulas = Equações, uma por linha
page-board-slot_point_name = Nome do ponto
page-board-slot_line_name = Nome da reta
page-board-slot_number_name = Nome do número
page-board-slot_names = Incógnitas
page-board-slot_sense = Sentido
page-board-slot_base = Reta do polígono onde o ângulo começa, como b,c
page-board-slot_made = O que foi desenhado
page-board-which_of = Aqui há {$count} pontos muito juntos: qual?
page-board-which_direction = Aqui cruzam-se {$count} direções: qual?
page-board-wants_sheet = Em que folha?
page-board-wants_point = Falta um ponto: toque ou escolha.
page-board-wants_scheme = Falta um ponto do esquema.
page-board-wants_line = Falta uma reta: toque o cruzamento ou escolha duas.
page-board-wants_direction = Falta a direção: toque uma barra ou reta.
page-board-wants_how = Como fica?
page-board-wants_angle = Falta o ângulo.
page-board-wants_formula = Falta um número ou uma fórmula.
page-board-wants_formulas = Faltam as equações.
page-board-wants_point_name = Que ponto é? Escolha o nome.
page-board-wants_line_name = A reta precisa de um nome.
page-board-wants_number_name = Que número é? Escolha o nome.
page-board-wants_names = Quais são as incógnitas?
page-board-wants_sense = Que sentido?
page-board-wants_base = Em que reta do polígono começa o ângulo?
page-board-wants_made = Toque o que deve sair.


## The workbench: sheets

page-sheets-scheme_short = Esquema
page-sheets-scheme_scaled = Esquema
page-sheets-scheme_panel = Esquema
page-sheets-scheme_name = esquema
page-sheets-scheme_title = Esquema
page-sheets-scheme_from = No esquema
page-sheets-velocity_short = Velocidade
page-sheets-velocity_scaled = Velocidades
page-sheets-velocity_panel = Velocidades
page-sheets-velocity_name = polígono de velocidades
page-sheets-velocity_title = Polígono de velocidades
page-sheets-velocity_from = Do polígono de velocidades
page-sheets-acceleration_short = Aceleração
page-sheets-acceleration_scaled = Acelerações
page-sheets-acceleration_panel = Acelerações
page-sheets-acceleration_name = polígono de acelerações
page-sheets-acceleration_title = Polígono de acelerações
page-sheets-acceleration_from = Do polígono de acelerações
page-sheets-centers_short = Centros
page-sheets-centers_scaled = Centros
page-sheets-centers_panel = Centros instantâneos
page-sheets-centers_name = figura de centros instantâneos
page-sheets-centers_title = Centros instantâneos
page-sheets-centers_from = Dos centros
page-sheets-forces_short = Forças
page-sheets-forces_scaled = Forças
page-sheets-forces_panel = Plano de forças
page-sheets-forces_name = plano de forças
page-sheets-forces_title = Plano de forças
page-sheets-forces_from = Do plano de forças
page-sheets-lever_short = Alavanca
page-sheets-lever_scaled = Alavanca
page-sheets-lever_panel = Alavanca
page-sheets-lever_name = alavanca
page-sheets-lever_title = Alavanca
page-sheets-lever_from = Da alavanca
page-sheets-speeds_short = Kutzbach
page-sheets-speeds_scaled = Kutzbach
page-sheets-speeds_panel = Diagrama de Kutzbach
page-sheets-speeds_name = diagrama de Kutzbach
page-sheets-speeds_title = Diagrama de Kutzbach
page-sheets-speeds_from = Do diagrama de Kutzbach


## The workbench: refused

page-refused-line = Linha {$line}: {$message}


## The workbench: subject

page-subject-link = Elo {$name}
page-subject-slider = Cursor {$name}
page-subject-point = Ponto {$name}
page-subject-others = Outras


## The workbench: kinds

page-kinds-title-four-bar = Mecanismo de quatro barras
page-kinds-title-slider-crank = Biela-manivela excêntrico
page-kinds-title-slotted-lever = Manivela e alavanca ranhurada (retorno rápido)
page-kinds-title-hydraulic-boom = Lança com cilindro hidráulico
page-kinds-title-watt-1 = Watt I, seis barras
page-kinds-title-stephenson-3 = Stephenson III, seis barras
page-kinds-title-whitworth = Retorno rápido de Whitworth
page-kinds-title-toggle-press = Prensa de joelho
page-kinds-title-five-bar = Cinco barras com dois acionamentos
page-kinds-title-platform-3rrr = Plataforma 3-RRR
page-kinds-title-third-class = Manivela com grupo de terceira classe
page-kinds-title-fourth-class = Manivela com grupo de quarta classe
page-kinds-title-paper-figure-1 = Quintero et al. (2011), figura 1
page-kinds-title-paper-figure-2 = Quintero et al. (2011), figura 2
page-kinds-title-dyad-rrr = Díade RRR: dois elos, três pinos
page-kinds-title-dyad-rrp = Díade RRP: biela e cursor em uma guia
page-kinds-title-dyad-rpr = Díade RPR: bloco na ranhura de uma alavanca
page-kinds-title-dyad-prp = Díade PRP: dois blocos em um pino
page-kinds-title-dyad-rpp = Díade RPP: bloco na ranhura de um cursor
page-kinds-title-gear-train = Trem de engrenagens com roda intermediária
page-kinds-title-planetary = Trem planetário
page-kinds-title-planetary-sun-fixed = Trem planetário com o sol fixo
page-kinds-title-planetary-carrier-fixed = Trem planetário com o braço fixo
page-kinds-title-differential = Diferencial com dois acionamentos
page-kinds-title-reverted-train = Trem composto revertido
page-kinds-title-sun-and-planet = Sol e planeta de Watt
page-kinds-title-rack-and-pinion = Pinhão e cremalheira
page-kinds-title-geared-five-bar = Cinco barras com engrenagens
page-kinds-title-geneva = Cruz de Malta
page-kinds-title-eccentric-cam = Came excêntrico com rolete
page-kinds-title-flat-follower = Came excêntrico com alavanca plana
page-kinds-note-dyad-prp = Como se desenha no quadro. O pino C une os blocos 2 e 3: o bloco 2 desliza sobre o elo 1, cujo movimento é todo conhecido; o bloco 3, em uma guia fixa.
page-kinds-note-dyad-rpp = Como se desenha no quadro: um garfo escocês. O bloco 2, articulado em B a uma manivela, desliza no garfo 3, que desliza sobre a base.
page-kinds-note-dyad-rpr = Como se desenha no quadro: "points" dá cada coordenada, "known" o movimento dos pinos externos B e D. O polígono de acelerações tem um termo de Coriolis.
page-kinds-note-dyad-rrp = Como se desenha no quadro: "points" dá cada coordenada, "known" o movimento do pino externo B. A guia é fixa.
page-kinds-note-dyad-rrr = Como se desenha no quadro: "points" dá cada coordenada, "known" o movimento dos pinos externos B e D. Os elos 1 e 4 são os vizinhos, mostrados como tocos.
page-kinds-note-five-bar = Dois graus de liberdade, portanto dois acionamentos: as manivelas 1 e 4 movem o ponto C, cada uma com seu ângulo, seu omega e seu alpha.
page-kinds-note-four-bar = A manivela 1 move o balancim 3 por meio da biela 2. Pontos nomeados em dois elos são juntas entre eles.
page-kinds-note-fourth-class = Os elos 2 e 4 estão unidos pelos elos de fechamento 3 e 5, que formam o contorno fechado C-D-F-G. Os polígonos precisam de um ponto especial (de Assur) do elo 3 ou 5.
page-kinds-note-hydraulic-boom = O cilindro 2 e a haste 3 são um elo entre os pinos A e C cujo comprimento o acionamento muda: giram juntos, e com a lança formam uma díade.
page-kinds-note-platform-3rrr = Três graus de liberdade, três acionamentos: as manivelas 1, 2, 3 posicionam e giram a plataforma 7 por meio das pernas 4, 5, 6. Plataforma e pernas são um grupo de terceira classe.
page-kinds-note-slider-crank = A manivela 1 move o cursor 3 por meio da biela 2.
page-kinds-note-slotted-lever = A manivela 1 gira uniformemente; seu pino B leva o bloco 2, que desliza na alavanca oscilante 3. O polígono de acelerações tem um termo de Coriolis.
page-kinds-note-stephenson-3 = O ponto E da biela do mecanismo de quatro barras A-B-C-D move o balancim 5 por meio do elo 4: duas díades, resolvidas uma depois da outra.
page-kinds-note-third-class = O elo ternário 3 está preso a três pernas: 2 no pino da manivela, 4 e 5 na base. Nenhuma díade pode ser resolvida antes: os polígonos precisam de um ponto especial (de Assur) do elo 3.
page-kinds-note-toggle-press = A manivela 1 e a biela 2 esticam os elos 3 e 4 do joelho, que empurram o martelo 5 para baixo: devagar e com força perto do fim. C é um pino por três elos.
page-kinds-note-watt-1 = Um mecanismo de quatro barras A-B-C-D cuja biela 2 e cujo balancim 3 levam a segunda malha C-E-G-F: duas díades, resolvidas uma depois da outra.
page-kinds-note-whitworth = A manivela 1 gira uniformemente; o bloco 2 no seu pino faz a alavanca ranhurada 3 dar voltas completas; a biela 4 move o carro 5.
page-kinds-note-gear-train = A roda 1 aciona a roda 3 pela roda intermediária 2, que só muda o sentido.
page-kinds-note-planetary = O braço 1 aciona. O planeta 2 rola na coroa fixa e move o sol 3.
page-kinds-note-planetary-sun-fixed = Uma sobremarcha: o braço 1 aciona, o planeta 2 rola sobre o sol fixo e move a coroa 3.
page-kinds-note-planetary-carrier-fixed = O sol 1 aciona. O eixo da roda 2 está parado, e a coroa 3 gira ao contrário.
page-kinds-note-differential = O sol 3 e a coroa 4 acionam; o planeta 2 rola entre eles e arrasta o braço 1.
page-kinds-note-reverted-train = O planeta 2 tem dois dentados: um rola sobre o sol fixo, o outro move o sol 3. O braço 1 aciona.
page-kinds-note-sun-and-planet = James Watt, 1781: a roda 2 é fixa à biela e contorna a roda 4, que dá duas voltas por volta do braço 1.
page-kinds-note-rack-and-pinion = A manivela 1 e a biela 2 empurram um carro cuja roda 4 rola sobre uma cremalheira fixa e move a cremalheira 5 com o dobro da velocidade do carro.
page-kinds-note-geared-five-bar = As manivelas 1 e 4 são rodas engrenadas: a segunda gira com o dobro da velocidade e ao contrário.
page-kinds-note-geneva = Quatro ranhuras. `travel` diz onde uma ranhura termina: a cruz move-se durante um quarto de volta da manivela e depois repousa.
page-kinds-note-eccentric-cam = Um disco cujo centro K está a 20 mm do eixo; o elo 2, de K ao centro C do rolete, move-se como o contato.
page-kinds-note-flat-follower = O disco toca uma face reta da alavanca 2: seu centro K move-se numa reta ao lado dessa face, à distância do raio do disco.


## The workbench: editor

page-editor-Find = Localizar
page-editor-Replace = Substituir
page-editor-next = próximo
page-editor-previous = anterior
page-editor-all = todos
page-editor-match_case = maiúsculas
page-editor-by_word = palavra inteira
page-editor-regexp = expressão regular
page-editor-replace = substituir
page-editor-replace_all = substituir todos
page-editor-close = fechar
page-editor-current_match = ocorrência atual
page-editor-on_line = na linha
page-editor-Fold_line = Recolher
page-editor-Unfold_line = Expandir
page-editor-folded_code = texto recolhido
page-editor-unfold = expandir
page-editor-Completions = Sugestões
page-editor-Diagnostics = Mensagens
page-editor-No_diagnostics = Sem mensagens


## The component <kinegon-plan>

page-component-none = O plano não tem cena: dê o endereço dela em src, ou escreva-a entre as etiquetas em um script do tipo application/json.
page-component-unread = Não foi possível ler {$src} ({$why}).
page-component-from_file = Uma página aberta de um arquivo não pode ler outros: escreva a cena entre as etiquetas.
