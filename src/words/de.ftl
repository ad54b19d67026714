### Kinegon in German, with the terms of H. Kerle, B. Corves, M. Hüsing, Getriebetechnik, and J. Volmer, Getriebetechnik: Pol, Geschwindigkeitsplan, Glied,
### Gestell, Zweischlag. Sonderpunkt, the special (Assur) point, is in no German book that we know. The reader is addressed by Sie, steps stand in the infinitive.
### Names of lines (guide_of and the like) stand in the dative or without an article; all three sheets are masculine; what ends with a hyphen in English is the first
### half of a compound. docs/terms.md has the terms, `en.ftl` says how such a file is written.


## Figures, steps and reports


# Names of links and lines.

ground = Gestell
guide_of = Führung von {$slider}
normal_to_guide = der Normalen zur Führung von {$slider} durch {$point}
line_at_infinity = der unendlich fernen Geraden

# Steps that are shown together.

join_special_points = {$points}, Sonderpunkte: die Schnittpunkte ihrer Geraden.
join_lay_off = {$vectors} antragen.
join_normal = durch {$through} ⊥ {$line}
join_parallel = durch {$through} ∥ {$line}
join_at_angle = durch {$through} unter {$angle}
join_cross = Die Geraden {$first} und {$second} schneiden sich in {$point}.
join_measure = {$lengths} messen.
join_rates = {$segments} messen; nach {$unknowns} auflösen.
join_images = Bilder weiterer Punkte: {$points}.

# Steps of the construction.

choose_pole = Den Pol {$pole} und den Maßstab {$scale} wählen.
choose_pole_with = Den Pol {$pole} und den Maßstab {$scale} wählen; ruhende Punkte haben dort ihre Bilder: {$images}.
special_point = {$point}, Sonderpunkt von Glied {$link}: Schnittpunkt von {$first} und {$second}.
special_point_at_infinity = {$point}, Sonderpunkt von Glied {$link}, liegt im Unendlichen (Richtung {$direction}°) wegen der Parallelität von {$first} und {$second}.
measure_length = Die Länge von {$from} bis {$to} messen.
lay_off_velocity = Die Geschwindigkeit von {$point} normal zu {$arm} antragen, im Sinne von ω_{$link}.
lay_off_velocity_turned = Die Geschwindigkeit von {$point}, gedreht, längs {$arm} antragen: in der Richtung von {$from} nach {$to}.
lay_off_normal_acceleration = Die Beschleunigung von {$point} antragen, von {$point} nach {$pivot} gerichtet: Glied {$link} dreht sich gleichförmig.
lay_off_whole_acceleration = Die Beschleunigung von {$point} antragen: Normalanteil von {$point} nach {$pivot} gerichtet, Tangentialanteil normal zu {$arm}.
lay_off_given = Den gegebenen Vektor {$vector} vom Pol aus antragen.
lay_off_given_turned = Den gegebenen Vektor {$vector}, gedreht, vom Pol aus antragen.
lay_off_point_under = Den bekannten Vektor des Punktes von {$body} unter {$point} antragen.
ray_normal = Durch {$through} die Normale zu {$line} ziehen; {$image} liegt auf ihr.
ray_normal_to_guide = Durch {$through} die Normale zur {$line} ziehen; {$image} liegt auf ihr.
ray_parallel = Durch {$through} die Parallele zur {$line} ziehen; {$image} liegt auf ihr.
ray_parallel_to_line = Durch {$through} die Parallele zu {$line} ziehen; {$image} liegt auf ihr.
ray_at_angle = Durch {$through} die Gerade unter dem Winkel {$angle} des Gliedes ziehen, im selben Sinn; {$image} liegt auf ihr.
divide = Die Strecke von {$from} bis {$to} im Verhältnis {$part} : {$whole} teilen: dort liegt {$image}.
coincide = Glied {$link} dreht sich nicht: {$image} liegt in {$with}.
cross = {$image} im Schnittpunkt der beiden Geraden markieren.
measure_segment = Die Strecke von {$from} bis {$to} messen.
lay_off_normal_part = Die Normalbeschleunigung parallel zu {$line} nach {$centre} gerichtet antragen, von {$from} bis {$to}.
lay_off_normal_parts = Die Normalbeschleunigungen beider Glieder parallel zu {$line} antragen, von {$from} bis {$to}.
solve = Die Gleichungen der gemessenen Strecken nach {$unknowns} auflösen.
solve_wheel = Die Gleichung der gemessenen Strecke nach {$unknowns} auflösen.
solve_wheel_with_mesh = Die Gleichung der gemessenen Strecke nach {$unknowns} auflösen; die Gleichung der Zähne muss dasselbe ergeben.
solve_meshes = Die Gleichungen der Zähne nach {$unknowns} auflösen.
solve_meshes_accelerated = Die Gleichungen der Zähne nach {$unknowns} auflösen: Wo Räder sich berühren, sind die Tangentialanteile ihrer Beschleunigungen gleich, nicht die ganzen.
solve_rims = Räder haben mit dem, was sie berühren, und mit ihrem Riemen eine Geschwindigkeit; die Gleichungen dafür ergeben {$unknowns}.
pitch_at_rest = Dort berührt es ein festes Rad: {$image} liegt in {$with}.
lay_off_pitch = Mit ω_{$link}: Die Geschwindigkeit von {$point} relativ zu {$from} normal zu {$arm} antragen; dort haben beide Räder dieselbe.
lay_off_pitch_turned = Mit ω_{$link}: Die Geschwindigkeit von {$point} relativ zu {$from}, gedreht, längs {$arm} antragen; dort haben beide Räder dieselbe.
no_construction = Für diese Gruppe gibt es keine Konstruktion mit zwei Geraden: Ihre Geschwindigkeiten und Beschleunigungen folgen aus den Schleifengleichungen, und ihre Bilder werden damit Glied für Glied angetragen.
no_construction_far = {$points} im Unendlichen: Die Geraden sind parallel; Geschwindigkeiten und Beschleunigungen folgen aus den Schleifengleichungen, und die Bilder werden damit Glied für Glied angetragen.
lay_off_relative = Mit ω_{$link}: Die Geschwindigkeit von {$point} relativ zu {$from} normal zu {$arm} antragen.
lay_off_relative_turned = Mit ω_{$link}: Die Geschwindigkeit von {$point} relativ zu {$from}, gedreht, längs {$arm} antragen.
lay_off_relative_normal = Die Normalbeschleunigung von {$point} relativ zu {$from} antragen, parallel zu {$arm} nach {$from} gerichtet.
lay_off_relative_tangential = Mit α_{$link}: Die Tangentialbeschleunigung von {$point} relativ zu {$from} normal zu {$arm} antragen.
lay_off_sliding_velocity = Die Gleitgeschwindigkeit von {$slider} in Richtung der Führung antragen, von {$from} bis {$to}.
lay_off_sliding_velocity_turned = Die Gleitgeschwindigkeit von {$slider}, gedreht, normal zur Führung antragen, von {$from} bis {$to}.
lay_off_sliding_velocity_backwards = Die Gleitgeschwindigkeit von {$slider} in Richtung der Führung so antragen, dass sie in {$to} endet: Sie beginnt in {$from}.
lay_off_sliding_velocity_turned_backwards = Die Gleitgeschwindigkeit von {$slider}, gedreht, normal zur Führung so antragen, dass sie in {$to} endet: Sie beginnt in {$from}.
lay_off_sliding_acceleration = Die Gleitbeschleunigung von {$slider} in Richtung der Führung antragen, von {$from} bis {$to}.
lay_off_sliding_acceleration_backwards = Die Gleitbeschleunigung von {$slider} in Richtung der Führung so antragen, dass sie in {$to} endet: Sie beginnt in {$from}.
lay_off_coriolis = Die Coriolisbeschleunigung von {$slider} von {$from} bis {$to} antragen, in der um 90° im Sinne von ω_{$link} gedrehten Richtung der Gleitgeschwindigkeit.
lay_off_coriolis_backwards = Die Coriolisbeschleunigung von {$slider} in der um 90° im Sinne von ω_{$link} gedrehten Richtung der Gleitgeschwindigkeit so antragen, dass sie in {$to} endet: Sie beginnt in {$from}.

# Words of equations.

given = {" "}gegeben
made_from = {" "}aus{" "}
and = {" "}und{" "}
normal = normal
tangential = tangential
sliding = gleitend
coriolis = Coriolis

# The text of the steps.

scales = Maßstäbe: {$scales}
scales_by_hand = Maßstäbe des Arbeitsblatts und der folgenden Längen auf dem Papier: {$scales}
scales_of_figure = Maßstäbe der Figur: {$scales}
scale_per_mm = {$scale} = {$value} {$unit} je mm
bands = ± halten sorgfältige Handzeichnungen (±{$mm} mm, ±{$degrees}°) ein, mindestens 95 von 100.
no_band_no_construction = Ein Wert hat kein ±, wenn er von einer Gruppe ohne Konstruktion abhängt (Sonderpunkt im Unendlichen oder höhere Klasse).
no_band_no_sheet = Ein Wert hat kein ±, wenn im Bild der {$panel} fehlt und damit der Maßstab.
on_the_mechanism = Am Mechanismus
routes_differ = Die Werte dieser Konstruktion und die der Schleifengleichungen weichen um {$difference} des größten voneinander ab; die Schnitte lassen {$allowed} zu.
on_paper = {$mm} mm auf dem Papier
only_roughly = , nur grob
direction = Richtung {$degrees}°
angle_of_crossing = Schnittwinkel {$degrees}°

# Instant centres.

permanent_centers = Die bleibenden Pole markieren: {$centers}.
center_in = {$center} in {$point}
center_of_mesh = {$center} im Wälzpunkt
center_normal_to = {$center} im Unendlichen, normal zur Führung von {$guide}
center_line = {$first} und {$second} verbinden; {$center} liegt auf dieser Geraden.
center_line_towards = Durch {$first} die Gerade zu {$second} im Unendlichen ziehen; {$center} liegt auf ihr.
center_cross = {$center} auf {$first} und {$second} markieren.
center_parallel = {$center} liegt im Unendlichen: {$first} und {$second} sind parallel.
center_along = {$center} liegt im Unendlichen in Richtung von {$line}: die andere Gerade ist die unendlich ferne.
leave_out = Glied {$link} weglassen und {$first} mit {$second} starr verbinden: der Pol liegt dann in {$center}.
centers_by_rates = Keine Geraden führen zu {$centers}: aus den berechneten Geschwindigkeiten.
rate_by_centers = {$rate} berechnen: in {$center} haben die Glieder {$driver} und {$link} dieselbe Geschwindigkeit.
velocity_by_centers = {$vector} normal zum Polstrahl {$from} {$point} antragen.
rate_by_slide = {$rate} berechnen: in {$center} hat Glied {$link} die Geschwindigkeit {$velocity}, längs der Führung.
velocity_along_guide = {$vector} längs der Führung von {$guide} antragen: alle Punkte des Gliedes haben diese Geschwindigkeit.
collineation_axis = {$first} und {$second} verbinden, und die Krümmungsmittelpunkte ihrer Bahnen, {$first_center} und {$second_center}: die Geraden treffen sich in {$crossing}. Die Kollineationsachse geht von {$pole} dorthin.
pole_tangent = Die Polbahntangente t von Glied {$link} durch {$pole} ziehen: vom Polstrahl nach {$first} aus, unter dem Winkel von der Achse zum Polstrahl nach {$second} (Bobillier).
axis_of_point = Den Polstrahl von {$pole} nach {$point} ziehen und, von ihm aus, unter dem Winkel von der Tangente zum Polstrahl nach {$pin}, ihre Achse: sie trifft die Gerade durch {$point} und {$pin} in {$crossing}.
center_of_curvature = Die Gerade von dort nach {$fixed} trifft den Polstrahl in {$center}, dem Krümmungsmittelpunkt der Bahn von {$point}.
path_inflection = Die Gerade von dort nach {$fixed} ist parallel zum Polstrahl: die Bahn von {$point} hat einen Wendepunkt.
inflection_point = Die Abstände von {$pin} nach {$pole} und nach {$fixed} messen. Auf dem Polstrahl, von {$pin} nach {$fixed} hin, durchläuft J einen Wendepunkt seiner Bahn (Euler und Savary).
inflection_in_pin = {$fixed} liegt im Unendlichen: {$pin} selbst durchläuft einen Wendepunkt und ist J.
inflection_pole = Die Normale zum Polstrahl in {$point} und die Normale zur Polbahntangente in {$pole} schneiden sich in {$found}, dem Wendepol: der Kreis über {$pole} {$found} ist der Wendekreis.
inflections_differ = Die Wendepole aus diesen Geraden und aus der berechneten Bewegung unterscheiden sich um {$difference} von Durchmesser oder Getriebe; die Schnitte erlauben {$allowed}.
curvatures_differ = Die Krümmungsmittelpunkte aus diesen Geraden und aus der berechneten Bewegung weichen um {$difference} von Radius oder Getriebe ab; die Schnitte erlauben {$allowed}.
velocity_of_center = {$vector} antragen, die von {$center}: Glied {$link} dreht sich nicht.
centers_differ = Die Pole aus diesen Geraden und aus der berechneten Bewegung unterscheiden sich um {$difference} der Größe des Getriebes; die Schnitte erlauben {$allowed}.

weight_letter = G
one_link = Glied {$link}
several_links = Glieder {$links}
force_moments = Momente um {$point}, {$links}: {$force}.
force_moments_crossing = Momente um den Schnittpunkt der Wirkungslinien von {$first} und {$second}, {$links}: {$force}.
force_couple = Momente um {$point}, {$links}: {$couple}, mit dem die Kraft in der Führung von {$guide} neben {$point} wirkt.
force_begin = Krafteck, {$links}, mit {$scale}: {$force} antragen.
force_lay_off = {$force} antragen.
force_direction = Richtung von {$force} zeichnen.
force_cross = Der Schnittpunkt ergibt {$first} und {$second}.
force_close = {$force} schließt das Krafteck.
force_sum = {$force} ist die Summe der Anteile.
force_inner = {$force} schließt das Krafteck für {$links} allein.
force_push = Entlang der Führung von {$guide} schiebt der Antrieb mit {$force}.
forces_by_numbers = Für die Gelenkkräfte, {$links}, gibt es hier keine Konstruktion: sie sind aus den Gleichgewichtsbedingungen angetragen.
force_polygon = Krafteck, {$links}: {$known} antragen.
force_polygon_closed = Schließende Kräfte: {$forces}.
force_polygon_joined = Aus Ecken: {$forces}.
forces_differ = Die Kräfte aus diesen Kraftecken und aus den Gleichgewichtsbedingungen unterscheiden sich um {$difference} der größten Kraft; Rundung und Schnitte erlauben {$allowed}.
lever_turn = Den Geschwindigkeitsplan um 90° im Uhrzeigersinn drehen: er ist ein Hebel.
lever_turn_for = Die Geschwindigkeiten um 90° im Uhrzeigersinn drehen, während {$drive} mit Rate 1 läuft und die anderen Antriebe stehen: sie bilden einen Hebel.
lever_arm = {$force} wirkt im Bild ihres Punktes: den Hebelarm messen.
lever_effort = Momente um den Pol ergeben {$effort}: keine Gelenkkraft hat eines.
speeds_train = Die Mittenlinie mit Mittelpunkten und Wälzpunkten im Längenmaßstab zeichnen; Geschwindigkeiten werden normal dazu abgetragen.
speeds_given = Die Geschwindigkeiten von {$from} und {$to} abtragen: alle Geschwindigkeiten von {$link} auf der Mittenlinie enden auf der Geraden durch ihre Spitzen.
speeds_line = {$from} und {$to} haben Geschwindigkeiten, die schon da sind: die von {$link} enden auf der Geraden durch ihre Spitzen.
speeds_pole = Einen Punkt o wählen und darunter eine Grundlinie, in dem Abstand, der den Maßstab der Winkelgeschwindigkeiten rund macht.
speeds_ray = Die Parallele durch o zur Geraden von {$link} schneidet {$rate} auf der Grundlinie ab.
speeds_slides = {$link} gleitet: alle Punkte davon haben die Geschwindigkeit von {$at}.
speeds_slides_given = Die Geschwindigkeit von {$at} abtragen: {$link} gleitet, und alle Punkte davon haben sie.
speeds_belt = Der Riemen gibt beiden Scheiben eine Umfangsgeschwindigkeit: {$to} hat die Geschwindigkeit von {$from}.
speeds_turned = Im Kutzbachplan sind Mittelpunkte neben der Linie auf sie gedreht, wobei Abstände und Geschwindigkeiten bleiben: {$points}.
speeds_unsized_belt = im Kutzbachplan fehlt der Riemen von {$first} und {$second}: wie groß seine Scheiben sind, ist nicht bekannt; `radius` angeben
speeds_none = es gibt keinen Kutzbachplan: keine zwei Räder kämmen oder haben einen Riemen, und keines rollt auf einer Zahnstange
speeds_left_out = der Kutzbachplan gilt für die Mittenlinie durch {$line}; was sich in {$meshes} berührt, liegt auf einer anderen Geraden und lässt sich nicht auf sie drehen

# The figure.

title = Geschwindigkeits- und Beschleunigungsplan
scheme = Lageplan
velocity_plan = Geschwindigkeitsplan
# Its velocities are drawn turned by 90°, one way or the other.
turned_plan = {$plan}, um {$angle}° gedreht
acceleration_plan = Beschleunigungsplan
centers = Momentanpole
force_plan = Kräfteplan
lever = Hebel
speeds = Kutzbachplan
far_away = {$point}: {$distance} von {$from}
far_in_plan = bis {$point}: {$distance}
cut_at_edge = am Rand abgeschnitten
names_without_room = kein Platz für alle Namen
names_left_out = kein Platz für:
loads_without_scale = Lasten sind ohne Maßstab gezeichnet.
friction_told = Die Reibung wird mit den Kräften gefunden: F^{"{"}f{"}"} = μ |N| längs Führungen, M^{"{"}f{"}"} = ρ |R| an Zapfen, ρ der Radius des Reibungskreises.
at_infinity = {$point} im Unendlichen
paths = Marken auf der Bahn von {$points}: alle {$step} des Antriebs {$drive}.
paths_in_time = Marken auf der Bahn von {$points}: alle {$step} des Antriebs {$drive}, das heißt alle {$time}.
path_of = Bahn von {$point} in {$unit}
mode = Lage {$number}
contact_link = Glied {$link} ersetzt die Berührung von {$first} und {$second}: es verbindet ihre Krümmungsmittelpunkte {$from} und {$to}.
contact_face = Ein Bolzen in {$center}, dem Krümmungsmittelpunkt von {$first}, der entlang der ebenen Fläche von {$second} gleitet, ersetzt ihre Berührung.
contact_here = Das gilt nur in dieser Stellung.
equivalent = {$link} (Ersatz)
modes_left_out = Von den anderen Einbaulagen sind nur die ersten {$count} gezeichnet.
centrodes = Polbahnen von Glied {$links}, nahe am Mechanismus: Rastpolbahn ausgezogen, Gangpolbahn gestrichelt.
no_centrodes = Glied {$links} dreht sich um einen festen Punkt oder gar nicht: es hat keine Polbahnen.
inflection_circle = Wendekreis von Glied {$link}: Durchmesser {$diameter}, durch Momentanpol {$center} und Wendepol {$pole}.
no_inflection_circle = Glied {$link} dreht sich um einen festen Punkt oder gar nicht: Es hat keinen Wendekreis.
no_centers = {$centers}: Die Glieder ruhen gegeneinander und haben hier keinen Momentanpol.
no_velocities_by_centers = Geschwindigkeit von {$points} über Pole: nicht gefunden. Dazu gehören ein einziger Antrieb, der sich bewegt, und Pole vom Glied des Punktes, die nicht zusammenfallen.
no_curvatures = Krümmung der Bahn von {$points}: nicht gefunden. Dazu gehören zwei Gelenke des Gliedes an Kurbeln oder an Gleitsteinen im Gestell, und ein Pol des Gliedes, der nicht fest ist.
too_many_for_lines = Geraden zu Momentanpolen werden in Mechanismen mit höchstens {$most} Gliedern gesucht: diese Pole kommen aus den berechneten Geschwindigkeiten.
radius_of_curvature = Krümmungsradius der Bahn von {$point}: {$radius}.
no_radius_of_curvature = Die Bahn von {$point} hat einen Wendepunkt.
paths_beyond = Gestrichelt: jenseits der Grenzen des Antriebs.
agreement = Konstruktion und Schleifengleichungen stimmen überein: Abweichung {$difference} des größten (Schnitte lassen {$allowed} zu).
one_route_far = Ein Sonderpunkt liegt im Unendlichen: Die Werte stammen allein aus den Schleifengleichungen.
one_route = Für eine Gruppe gibt es keine Konstruktion mit zwei Geraden: Die Werte stammen allein aus den Schleifengleichungen.
printed = Bei Druck mit 100 %: mm × μ ist der Wert.
with_direction = {$size}, Richtung {$degrees}°
segment = Strecke
value = Wert
values = Werte
ruler = Bei Druck mit 100 % sind dies 50 mm

# The text that stands for a figure where it cannot be seen.

description = Felder: {$panels}. Assur-Gruppen: {$groups}.
named_scheme = Lageplan
named_velocity_plan = Geschwindigkeitsplan
named_acceleration_plan = Beschleunigungsplan
named_centers = Momentanpole
named_force_plan = Kräfteplan
named_lever = Hebel
named_speeds = Kutzbachplan
described_scheme = der Mechanismus im Maßstab
described_velocity_plan = sein Geschwindigkeitsplan
described_acceleration_plan = sein Beschleunigungsplan
described_centers = seine Momentanpole
described_force_plan = sein Kräfteplan
described_lever = sein Hebel
described_speeds = sein Kutzbachplan
described_group = Klasse {$class}, Glieder {$links}
higher = über IV

# Curves.

curves = Kurven
hodograph = Hodograph von {$vector}
willis_all = mit dem Steg
willis_turns = Umdrehungen
willis_held = Steg steht
willis_together = zusammen
angle = Winkel
angular_velocity = Winkelgeschwindigkeit
rotational_speed = Drehzahl
speed_ratio = Übersetzung
angular_acceleration = Winkelbeschleunigung
position = Position
length = Länge
velocity = Geschwindigkeit
acceleration = Beschleunigung
force = Kraft
moment = Moment
power = Leistung
in_unit = {$kind} in {$unit}
drive_angle = Antriebswinkel {$symbol} in °
drive_position = Position des Antriebs {$drive} in {$unit}

# The legend of curves.

limit = Grenzlage
change = Verzweigung
scene = Szene
dead_centre = Totlage
extremes = größter, kleinster Wert

# The text that stands for curves where they cannot be seen.

over = Über {$drive} von {$from} bis {$to}:
is_constant = {$quantity} ist {$value}
least = kleinster Wert {$value} bei {$at}
greatest = größter Wert {$value} bei {$at}
no_least = nach unten unbeschränkt
no_greatest = nach oben unbeschränkt

# Special positions in the range of a drive; `place` is the drive's value, as in `angle(1) = 30°`.

event_limit = Grenzlage bei {$place}: Die Glieder {$links} kommen nicht weiter; ihre Geschwindigkeiten und Beschleunigungen wachsen unbegrenzt
event_runs_off = Grenzlage bei {$place}: Die Glieder {$links} laufen ins Unendliche
event_change = Verzweigungslage bei {$place}: Die Glieder {$links} könnten auch in anderer Einbaulage weiterlaufen; verfolgt wird die glatte Bewegung, und Geschwindigkeiten und Beschleunigungen sind dort ausgelassen
event_singular = singuläre Lage nahe {$place}: Die Glieder {$links} lassen sich nicht durch sie hindurch verfolgen
event_turns_back = Umkehrlage bei {$place}: Glied {$link} hält bei {$angle}° an und dreht zurück
event_slides_back = Umkehrlage bei {$place}: Schieber {$slider} hält bei {$position} an und gleitet zurück
event_leaves = Ende des Weges bei {$place}: Schieber {$slider} verlässt seine Führung bei {$position}
engaged = Der Schlitz ist bei {$drive} von {$from} bis {$to} im Eingriff, {$held} einer Umdrehung; während der anderen {$free} rastet er.
events_left_out = {$count} weitere Umkehr- oder Verzweigungslagen folgen
rates_of_every_position = jede Lage hat ω und α, wie die Szene sie dem Antrieb gibt: dies ist kein Anlauf, in dem sich ω ändert

# The structure: Assur groups in solving order.

structure_freedoms = Freiheitsgrad: {$count}, gleich der Zahl der Antriebe
structure_known = bekannte Bewegungen: {$motions}
structure_drives = Antriebe: {$count}; bekannte Bewegungen: {$motions}
structure_positions = Stellungen aus {$angle}: {$groups}
structure_group = Glieder {$links}: Klasse {$class}, {$shape}
structure_special_points = Sonderpunkte {$points}
shape_second = zwei Glieder (Zweischlag)
shape_third = ein Zentralglied an drei Lenkern
shape_fourth = zwei Mitnehmerglieder, verbunden durch zwei Schlussglieder, eine geschlossene Schleife aus vier Gliedern
shape_higher = mehr Glieder, als die Klassen II bis IV haben, oder anders verbunden
structure_wheel = Glied {$link}: ein einzelnes Rad, das durch das gedreht wird, was es berührt

# The list of assembly modes.

modes = {$count ->
    [one] {$count} Einbaulage
   *[other] {$count} Einbaulagen
}
modes_at_least = mindestens {$count}
modes_listed = {$modes}, aufgeführt sind die ersten {$listed}
modes_heading = {$modes}; Koordinaten in {$unit}, Winkel in Grad
modes_of_group = Glieder {$links}: {$found} gefunden, höchstens {$most} möglich

# The report on a student's values.

check_counts = {$right} richtig, {$within} innerhalb der Bleistifttoleranz, {$off} falsch
check_counts_and_senses = {$right} richtig, {$within} innerhalb der Bleistifttoleranz, {$missing} ohne Vorzeichen, {$off} falsch
check_right = richtig
check_within = in der Toleranz
check_sense_missing = Vorzeichen fehlt
check_senses = Vorzeichen fehlt: Der Betrag ist richtig, aber eine Zahl ohne Vorzeichen sagt nichts über den Drehsinn oder Richtungssinn. Schreiben Sie + oder − davor oder "positive": "counter-clockwise" in das Formular.
check_off = FALSCH
check_off_turned = FALSCH: um {$degrees}° verdreht
check_cannot_tell = nicht zu entscheiden
check_missing = Es fehlen {$count} von {$asked} verlangten Werten: {$values}.
check_missing_many = Es fehlen {$count} von {$asked} verlangten Werten: {$values} und {$more} weitere.
check_coarse_digits = Zu wenige Ziffern, um etwas zu sagen: {$values}. Schreiben Sie mindestens zwei Ziffern, die nicht null sind.
check_rough_places = Zu ungenau bekannt, um beurteilt zu werden: {$values}. Ein Radius hinter einem Ort zählt bis {$mm} mm.
check_too_small = Auf dem Blatt zu klein, um beurteilt zu werden: {$values}. Auch eine sorgfältige Hand könnte dort nichts finden.
check_coarse = Ohne zeichnerische Konstruktion, daher sind bis zu {$percent} % (bei Winkeln {$degrees}°) zugelassen: {$values}.
check_all_larger = Alle Längen sind {$percent} % zu groß: Wurde das Blatt an die Seite angepasst gedruckt? Sie werden ohne diesen Fehler beurteilt.
check_all_smaller = Alle Längen sind {$percent} % zu klein: Wurde das Blatt an die Seite angepasst gedruckt? Sie werden ohne diesen Fehler beurteilt.
check_all_longer = Alle Längen sind {$mm} mm zu lang: Haben Sie das Lineal von seiner Kante an abgelesen oder ab {$mm}? Sie werden ohne diesen Fehler beurteilt.
check_all_shorter = Alle Längen sind {$mm} mm zu kurz: Haben Sie die Kante des Lineals an den Punkt gelegt? Sie werden ohne diesen Fehler beurteilt.
check_other_scale = {$scale}: Ihr Formular nennt {$stated}, die Aufgabe {$asked}; Ihre Werte werden mit Ihrem Maßstab beurteilt.
check_no_such_scale = {$scale} = {$stated}: Kein Blatt kann den {$sheet} so zeigen; zugelassen ist, was für eine Zeichnung mit {$used} gilt.
column_quantity = Größe
check_column_written = Ihr Wert
check_column_expected = erwartet
check_column_difference = Differenz
check_column_on_paper = Papier
check_column_percent = in %
check_column_allowed = zulässig
check_column_verdict = Urteil
check_tolerance = Eine sorgfältige Zeichnung (±{$mm} mm, ±{$degrees}° je Handgriff) darf so weit abweichen, wie hier zugelassen ist.
check_accuracy = Ihre Zeichnung ist auf etwa {$mm} mm und {$degrees}° genau, wie die Streuung aller Werte zeigt.
check_slips = Ihre berechneten Zahlen weichen um bis zu etwa {$percent} % ab.
check_wider = Daher wird mehr zugelassen als bei einer sorgfältigen Hand (±{$mm} mm, ±{$degrees}°).
check_too_coarse = Verlangt war eine Hand mit ±{$mm} mm und ±{$degrees}°.
check_probably = Was wahrscheinlich geschah
check_nothing = Alles richtig.
check_so_far = Nichts ist falsch: {$good} von {$asked} Werten sind richtig, die übrigen sind nicht bekannt.
check_tells_nothing = Diese Werte sagen nichts aus, weder richtig noch falsch.
check_no_single = Kein einzelner Fehler erklärt dies. Zusammen erklären es diese:
check_none = Ab Schritt {$number} stimmt etwas nicht: {$value} ist der erste falsche Wert. Die Ursache lässt sich nicht angeben.
check_step = Schritt {$number}
check_whole = Ganze Zeichnung
check_instead = Richtig wäre
check_follows = Dies folgt daraus und passt dazu: {$values}.
check_follows_none = Keiner Ihrer anderen Werte folgt daraus.
check_values_of = Dies sind die Werte einer anderen Aufgabe: {$exercise}.
check_worked = Mit Ihren Zahlen: {$calculation}.
check_worked_beside = Mit Ihren Zahlen: {$calculation}; Sie haben {$own}.
check_seems_left = Anscheinend um {$degrees}° nach links verdreht.
check_seems_right = Anscheinend um {$degrees}° nach rechts verdreht.
check_seems_longer = Anscheinend {$mm} mm zu lang.
check_seems_shorter = Anscheinend {$mm} mm zu kurz.
check_seems_elsewhere = Der Punkt liegt anscheinend {$mm} mm neben dem Schnittpunkt seiner beiden Geraden: von {$first} aus {$one}° neben seiner Geraden, von {$second} aus {$other}°.
check_redo = Führen Sie die Schritte {$steps} neu aus; alles andere bleibt.
check_redo_one = Führen Sie Schritt {$step} neu aus; alles andere bleibt.
check_redo_number = Berichtigen Sie nur diese Zahl; die Zeichnung bleibt.
check_sure = Sicherheit: {$percent} %
check_others = Es könnte auch sein
check_perhaps = Vielleicht war es dies
check_hint_plan = Prüfen Sie Ihren {$plan}.
check_hint_whole = Prüfen Sie die ganze Zeichnung: ihre Lage, ihren Maßstab, die Drehrichtungen.
check_hint_value = Der erste falsche Wert ist {$value}.
check_alike = nach Ihren Werten allein vom Obigen nicht zu unterscheiden
check_unexplained = Ohne Erklärung: {$values}.
check_not_looked = In einer so großen Konstruktion werden keine Ursachen gesucht.
check_looked_at = Ein so großes Formular wird nur zum Teil durchsucht: Ursachen werden nur bei den ersten {$count} Werten gesucht.
check_mirrored = Die Punkte in Ihrem {$plan} sind das Spiegelbild der richtigen: Alle Drehrichtungen sind umgekehrt. Falls Sie y auf dem Blatt nach unten gemessen haben, messen Sie es nach oben.
check_turned_left = Ihr ganzer {$plan} liegt um {$degrees}° nach links verdreht. Wenn nicht das Blatt so lag, dann sein erster Vektor.
check_turned_right = Ihr ganzer {$plan} liegt um {$degrees}° nach rechts verdreht. Wenn nicht das Blatt so lag, dann sein erster Vektor.

# A student's drawing over the right figure.

check_key_right = wie es sein soll
check_key_own = Ihre Zeichnung (Namen mit *)
check_key_wrong = wo der Fehler liegt
check_follows_marked = {$count} Werte mit der Marke {$mark} in der Tabelle folgen daraus und passen dazu.
check_beyond = {$point}: {$mm} mm weiter
check_turned = Die Punkte in Ihrem {$plan} sind um {$degrees}° gedreht gezeigt, wie sie am besten passen.

# Photographs of drawings.

photo_column_point = Punkt
photo_column_right = richtig mm
photo_column_found = gesehen mm
photo_column_off = Abstand mm
photo_column_band = ± mm
photo_cannot_tell = mit diesem Foto nicht zu entscheiden
photo_left = nicht gefunden
photo_sheet = {$file}: Blatt {$number} von {$name}

# What fills the blanks of mistakes' sentences.

line_cut = der für {$point} gezogenen Geraden
line_guide = der Führung von {$slider}
line_through = der Geraden {$points}
all_segments = alle Strecken des Blattes
all_lengths = alle Längen
all_velocities = alle Geschwindigkeiten
all_accelerations = alle Beschleunigungen
all_angular_velocities = alle Winkelgeschwindigkeiten
all_angular_accelerations = alle Winkelbeschleunigungen
all_forces = alle Kräfte
all_moments = alle Momente
horizontal = waagerechte
vertical = senkrechte

# Marks, and the summary of a class.

class_marks = Wertung: {$earned} von {$of}
class_marks_following = Wertung: {$earned} von {$of}, davon {$follow} für Werte, die aus einem Fehler folgen
class_counts = {$files ->
    [one] {$files} Datei: {$passed} bestanden, {$off} mit Fehlern, {$broken} nicht verstanden
   *[other] {$files} Dateien: {$passed} bestanden, {$off} mit Fehlern, {$broken} nicht verstanden
}
class_incomplete = {$count} ohne falschen Wert, aber nicht vollständig
class_common = {$count} von {$of}: Schritt {$step}, {$done}
class_common_whole = {$count} von {$of}: ganze Zeichnung, {$done}
class_unknown = {$count} von {$of}: Werte sind falsch, die Ursache ist nicht bekannt
class_not_understood = Dieses Formular wurde nicht verstanden. Geben Sie es wieder ab, wenn Folgendes berichtigt ist:

# The sheets of exercises.

exercise_given = Gegeben: {$all}.
exercise_draw = Die Pläne mit {$scales} zeichnen. Messen, auch auf diesem Blatt, und die Kästchen ausfüllen.
exercise_centers = Die Momentanpole mit {$scales} bestimmen. Messen und die Kästchen ausfüllen; Koordinaten zählen vom Ursprung der gegebenen Orte.
exercise_forces = Die Kräfte mit Momenten und Kraftecken bei {$scales} bestimmen; Hebelarme werden auf diesem Blatt gemessen. Messen und die Kästchen ausfüllen. Ein R nennt ein Gelenk und das Glied, auf das es dort wirkt.
exercise_lever = Was der Antrieb braucht, mit dem Hebel von Schukowski bei {$scales} bestimmen: Kräfte an den Bildern ihrer Punkte. Messen und die Kästchen ausfüllen.
exercise_guide = Führung von {$slider} durch {$place} unter {$degrees}°
exercise_guide_through = Führung von {$slider} längs {$line}
exercise_wheel = Rad {$link} ({$teeth} Zähne)
exercise_ring = Hohlrad {$link} ({$teeth} Zähne)
exercise_fixed_wheel = festes Rad ({$teeth} Zähne)
exercise_fixed_ring = festes Hohlrad ({$teeth} Zähne)
exercise_mesh = Eingriff: {$first}, {$second}
exercise_mesh_on = Eingriff: {$first}, {$second}, Steg {$arm}
exercise_room = Der Geschwindigkeitsplan braucht {$velocity}, der Beschleunigungsplan {$acceleration}: jeden auf {$paper} oder größer zeichnen.
exercise_sheets = Blätter für die Pläne folgen.
exercise_center_sheet = Ein Blatt für die Momentanpole folgt.
sheet_markers = Foto: Blatt flach, alle acht Quadrate im Bild.
exercise_senses = Vorzeichen: + gegen den Uhrzeigersinn.
exercise_senses_of_slides = Vorzeichen: + gegen den Uhrzeigersinn; {$slides}: + in Richtung des Pfeils mit +.
exercise_points = Punkte: {$all}.
exercise_normal_ends = {$points}: Ende eines Normalanteils
exercise_coriolis_ends = {$points}: Ende eines Coriolisanteils
exercise_sliding_ends = {$points}: Ende eines Gleitanteils
exercise_name = Name: ………………………………… Datum: ………………
exercise_allowed = Um ± darf eine sorgfältige Hand abweichen.

# Exercises in a course.

course_digits = Jeden Wert mit drei signifikanten Ziffern schreiben, in der Einheit neben seinem Kästchen.
course_other_sense = Der Betrag ist richtig, der Richtungssinn falsch.
course_cause = Wahrscheinliche Ursache: {$told}
course_follows = Dieser Wert folgt daraus.
course_picture = Der Mechanismus, maßstäblich
course_print = Blatt zum Drucken in wahrer Größe
course_key = Der Mechanismus mit beiden Plänen
course_if = Falls Sie {$value} erhalten haben:


## Mistakes: what was probably done, and what it should be

turned_ray-done = die Gerade von {$from} nach {$to} wurde um 90° verdreht gezogen: parallel statt normal oder umgekehrt
turned_ray-should = die Gerade einer Relativbewegung zwischen zwei Punkten eines Gliedes ist normal zu ihrer Verbindungslinie; nur die einer Gleitbewegung ist parallel zu ihrer Führung
turned_rays-done = die Geraden von {$from} nach {$to} und von {$other} nach {$to} wurden beide um 90° verdreht gezogen: parallel statt normal oder umgekehrt
turned_rays-should = die Gerade einer Relativbewegung zwischen zwei Punkten eines Gliedes ist normal zu ihrer Verbindungslinie; nur die einer Gleitbewegung ist parallel zu ihrer Führung
turned_cut_line-done = die Gerade durch {$joint} für {$point} wurde längs der Führung gezogen
turned_cut_line-should = {$point} liegt auf der Normalen zur Führung durch {$joint}
ray_from_wrong_point-done = die Gerade nach {$image} wurde durch {$wrong} gezogen
ray_from_wrong_point-should = sie beginnt in {$right}, wo der bekannte Teil der Vektorgleichung endet
wrong_lines-done = {$point} wurde auf {$wrong} markiert
wrong_lines-should = {$point} liegt auf {$right}
reversed_vector-done = der Vektor von {$from} nach {$to} wurde in umgekehrtem Sinn angetragen
reversed_vector-should = er zeigt von {$from} nach {$to}, in dem Sinn, in dem sein Glied sich dreht oder gleitet
turned_vector-done = der Vektor von {$from} nach {$to} wurde um 90° verdreht angetragen
turned_vector-should = eine Geschwindigkeit oder Tangentialbeschleunigung ist normal zur Verbindungslinie der beiden Punkte, eine Normalbeschleunigung liegt in ihrer Richtung
turned_vectors-done = der Vektor von {$from} nach {$to} wurde in beiden Plänen um {$degrees}° verdreht angetragen
turned_vectors-should = die Geschwindigkeit ist normal zur Kurbel, die Normalbeschleunigung zeigt längs der Kurbel zu ihrem Drehpunkt
vector_from_wrong_point-done = der Vektor nach {$end} wurde von {$wrong} aus angetragen
vector_from_wrong_point-should = er beginnt in {$right}
normal_outward-done = die Normalbeschleunigung {$rate}² {$length} auf dem Weg von {$from} nach {$to} wurde nach außen angetragen
normal_outward-should = eine Normalbeschleunigung zeigt zu dem Punkt, um den das Glied sich dreht
normals_outward-done = die Normalbeschleunigungen {$vectors} wurden nach außen angetragen
normals_outward-should = eine Normalbeschleunigung zeigt zu dem Punkt, um den das Glied sich dreht
omega_not_squared-done = für die Normalbeschleunigung von {$from} nach {$to} wurde {$rate} statt des Quadrats genommen
omega_not_squared-should = die Normalbeschleunigung ist {$rate}² {$length}
omegas_not_squared-done = für die Normalbeschleunigungen {$vectors} wurde ω statt des Quadrats genommen
omegas_not_squared-should = eine Normalbeschleunigung ist ω² mal Länge
omega_of_another_link-done = für den Vektor von {$from} nach {$to} wurde {$wrong} statt {$rate} genommen
omega_of_another_link-should = zu dem Vektor gehören {$rate} und {$factor}
omegas_interchanged-done = für die Normalbeschleunigungen wurden {$rate} und {$wrong} vertauscht, zuerst von {$from} nach {$to}
omegas_interchanged-should = zu jeder Normalbeschleunigung gehört die Winkelgeschwindigkeit ihres eigenen Gliedes: zu der von {$from} nach {$to} gehört {$rate}
diameter-done = die Normalbeschleunigung {$rate}² {$length} von {$from} nach {$to} ergab sich doppelt so groß, wie mit dem Durchmesser
diameter-should = die Normalbeschleunigung ist {$rate}² mal Radius {$length}
diameter_throughout-done = als Radius wurde bei Geschwindigkeit und Beschleunigung das Doppelte von {$length} genommen, wie mit dem Durchmesser oder dem Hub
diameter_throughout-should = den Radius {$length} nehmen
half_the_radius-done = als Radius wurde bei Geschwindigkeit und Beschleunigung die Hälfte von {$length} genommen
half_the_radius-should = {$length} ist der Radius, nicht der Durchmesser
normal_from_absolute-done = die Normalbeschleunigung in Richtung von {$length}, von {$from} nach {$to}, wurde mit der Geschwindigkeit {$velocity} berechnet
normal_from_absolute-should = sie folgt aus der Relativgeschwindigkeit: {$rate}² {$length}
normal_forgotten-done = die Normalbeschleunigung {$rate}² {$length} auf dem Weg von {$from} nach {$to} wurde vergessen
normal_forgotten-should = {$rate}² {$length} antragen, bevor die Gerade gezogen wird
normals_forgotten-done = die Normalbeschleunigungen {$vectors} wurden vergessen
normals_forgotten-should = ω² mal Länge antragen, bevor die jeweilige Gerade gezogen wird
tangential_where_none-done = zur Normalbeschleunigung von {$from} nach {$to} wurde eine Tangentialbeschleunigung {$rate} {$length} addiert
tangential_where_none-should = {$rate} ändert sich nicht, also gibt es keine Tangentialbeschleunigung: die Beschleunigung ist {$rate}² {$length}
coriolis_forgotten-done = die Coriolisbeschleunigung auf dem Weg von {$from} nach {$to} wurde vergessen
coriolis_forgotten-should = 2 {$rate} {$velocity} normal zur Führung antragen
coriolis_without_two-done = die Coriolisbeschleunigung von {$from} nach {$to} wurde ohne den Faktor 2 genommen
coriolis_without_two-should = sie ist 2 {$rate} {$velocity}
coriolis_turned-done = die Coriolisbeschleunigung von {$from} nach {$to} wurde in falschem Sinn angetragen
coriolis_turned-should = sie hat die um 90° im Sinne von {$rate} gedrehte Richtung von {$velocity}
coriolis_along-done = die Coriolisbeschleunigung von {$from} nach {$to} wurde längs der Führung angetragen
coriolis_along-should = sie ist normal zur Führung: sie hat die um 90° im Sinne von {$rate} gedrehte Richtung von {$velocity}
coriolis_velocity-done = die Coriolisbeschleunigung von {$from} nach {$to} wurde mit der Geschwindigkeit {$wrong} berechnet
coriolis_velocity-should = sie folgt aus der Gleitgeschwindigkeit: 2 {$rate} {$velocity}
coriolis_velocity_and_omega-done = die Coriolisbeschleunigung von {$from} nach {$to} wurde mit {$omega} und der Geschwindigkeit {$wrong} berechnet
coriolis_velocity_and_omega-should = sie folgt aus der Drehung der Führung und der Gleitgeschwindigkeit: 2 {$rate} {$velocity}
coriolis_where_none-done = eine Coriolisbeschleunigung wurde zu {$rate}² {$length} auf dem Weg von {$from} nach {$to} addiert, wo nichts gleitet
coriolis_where_none-should = eine Coriolisbeschleunigung gibt es nur, wo etwas auf einem sich drehenden Glied gleitet
coriolis_at_rest-done = eine Coriolisbeschleunigung 2 {$rate} {$velocity} wurde von {$from} aus angetragen, vor der Geraden nach {$to}
coriolis_at_rest-should = die Führung ruht: eine Coriolisbeschleunigung gibt es nur, wo etwas auf einem sich drehenden Glied gleitet
mirrored_image-done = {$point} wurde auf der falschen Seite von {$start} {$other} angetragen: das Bild des Gliedes ist gespiegelt
mirrored_image-should = das Bild eines Gliedes ist dem Glied ähnlich, gedreht, aber nie gespiegelt
beyond_end-done = {$point} wurde auf der falschen Seite von {$start} markiert, auf der Geraden durch {$start} und {$other}
beyond_end-should = die Bilder liegen auf ihrer Geraden in der Reihenfolge der Punkte auf dem Glied
wrong_ratio-done = die Strecke von {$from} bis {$to} wurde vom falschen Ende aus geteilt: {$point} hat von {$from} den Abstand, den er von {$to} haben sollte
wrong_ratio-should = das Bild teilt die Strecke der Bilder wie der Punkt die Strecke der Punkte
inverse_ratio-done = {$point} hat das umgekehrte Verhältnis: die Abstände von {$from} bis {$point} und von {$from} bis {$to} sind vertauscht
inverse_ratio-should = das Bild teilt die Strecke der Bilder wie der Punkt die Strecke der Punkte
distances_exchanged-done = {$point} hat von {$from} den Abstand, den er von {$to} haben sollte, und umgekehrt
distances_exchanged-should = das Bild eines Gliedes ist dem Glied ähnlich: jeder Winkel des Dreiecks liegt an seinem eigenen Ende
distances_exchanged_and_mirrored-done = {$point} liegt auf der falschen Seite der Geraden von {$from} nach {$to}, und die Abstände von beiden sind vertauscht
distances_exchanged_and_mirrored-should = das Bild eines Gliedes ist dem Glied ähnlich: jeder Winkel des Dreiecks liegt an seinem eigenen Ende
wrong_segment-done = für {$segment} wurde die Strecke von {$from} bis {$to} gemessen
wrong_segment-should = {$segment} messen
component-done = von {$segment} wurde nur die {$axis} Komponente gemessen
component-should = die wahre Länge von {$from} bis {$to} messen
wrong_length-done = für {$length} wurde die Länge von {$from} bis {$to} genommen
wrong_length-should = {$length} nehmen
wrong_length_throughout-done = für {$length} wurde überall die Länge von {$from} bis {$to} genommen
wrong_length_throughout-should = {$length} nehmen
omega_from_wrong_length-done = {$rate} wurde mit der Länge von {$from} bis {$to} bestimmt
omega_from_wrong_length-should = durch {$length} teilen
omega_and_normal_from_wrong_length-done = {$rate} und die Normalbeschleunigung bis {$normal} wurden mit der Länge von {$from} bis {$to} bestimmt
omega_and_normal_from_wrong_length-should = {$length} für beide nehmen
alpha_from_wrong_length-done = {$rate} wurde mit der Länge von {$from} bis {$to} bestimmt
alpha_from_wrong_length-should = durch {$length} teilen
not_divided_by_length-done = für {$rate} wurde die Strecke nicht durch {$length} geteilt
not_divided_by_length-should = durch {$length} teilen
wrong_sense-done = {$rate} wurde mit falschem Drehsinn genommen
wrong_sense-should = der Drehsinn folgt aus der Richtung der Strecke im Plan und der Seite, auf der ihre Gerade am Mechanismus liegt
wrong_sense_given-done = {$rate} wurde mit falschem Drehsinn genommen: der Vektor von {$from} nach {$to} zeigt verkehrt herum
wrong_sense_given-should = der Drehsinn von {$rate} ist gegeben
senses_reversed-done = der Drehsinn aller Winkelgeschwindigkeiten und Winkelbeschleunigungen ist umgekehrt, als wäre der Uhrzeigersinn positiv
senses_reversed-should = positiv ist gegen den Uhrzeigersinn
revolutions_for_radians-done = {$rate} wurde nicht zwischen Umdrehungen je Minute und Radiant je Sekunde umgerechnet
revolutions_for_radians-should = rad/s = rpm · π/30
rate_in_other_unit-done = {$rate}: gegeben war {$number} {$given}; gerechnet wurde mit {$number} {$taken}
rate_in_other_unit-should = mit {$number} {$given} weiterrechnen
all_in_other_unit-done = {$values}, wie {$first}, stehen dort in {$unit}, und keine Einheit sagt es
all_in_other_unit-should = {$unit} daneben schreiben, oder die Werte in {$own}
value_for_paper-done = {$quantity}: {$number} ist der Wert in {$unit}; gefragt sind Millimeter auf dem Papier
value_for_paper-should = {$number} : {$scale} = {$mm} mm auf dem Papier
values_for_paper-done = {$segments}: eingetragen sind Werte in {$unit}; gefragt sind Millimeter auf dem Papier
values_for_paper-should = ein Wert durch {$scale} ist seine Länge auf dem Papier in Millimetern
common_factor_degrees-done = {$values}, wie {$first}, sind das {$factor}-Fache der richtigen
common_factor_degrees-should = in jedes Produkt gehen Winkelgeschwindigkeiten in Radiant pro Sekunde ein: 1 rad sind 57,2958°
common_factor_turns-done = {$values}, wie {$first}, sind das {$factor}-Fache der richtigen
common_factor_turns-should = in jedes Produkt gehen Winkelgeschwindigkeiten in Radiant pro Sekunde ein: 1 Umdrehung sind 2π rad
common_factor_rpm-done = {$values}, wie {$first}, sind das {$factor}-Fache der richtigen
common_factor_rpm-should = in jedes Produkt gehen Winkelgeschwindigkeiten in Radiant pro Sekunde ein: 1 rad/s sind 9,5493 Umdrehungen pro Minute
common_factor_minutes-done = {$values}, wie {$first}, sind das {$factor}-Fache der richtigen
common_factor_minutes-should = alle Zeiten stehen in einer Einheit: eine Minute hat 60 Sekunden
common_factor_units-done = {$values}, wie {$first}, sind das {$factor}-Fache der richtigen
common_factor_units-should = alle Längen stehen in einer Einheit: 1 m sind 100 cm oder 1000 mm
revolutions_per_second-done = {$rate} wurde nicht zwischen Umdrehungen je Sekunde und Radiant je Sekunde umgerechnet
revolutions_per_second-should = rad/s = rev/s · 2π
degrees_for_radians-done = {$rate} wurde nicht zwischen Grad und Radiant umgerechnet
degrees_for_radians-should = Winkelgeschwindigkeiten und Winkelbeschleunigungen gehen in jedes Produkt im Bogenmaß ein
wrong_scale-done = {$segment}: es wurde {$wrong} statt {$scale} benutzt
wrong_scale-should = Millimeter auf diesem Blatt mal {$scale} sind der Wert
scale_forgotten-done = {$segment}: Millimeter Papier wurden als Wert genommen, ohne {$scale}
scale_forgotten-should = Millimeter auf diesem Blatt mal {$scale} sind der Wert
center_along_guide-done = {$center} wurde längs {$guide} gesucht
center_along_guide-should = {$center} liegt im Unendlichen, normal zu {$guide}: Geraden dorthin sind normal zur Führung
center_at_slider-done = {$center} wurde in {$pin} angenommen, dem Gelenk des Steins
center_at_slider-should = {$pin} ist der Pol des Steins mit seinem anderen Glied; {$center} liegt im Unendlichen, normal zu {$guide}
line_without_common_link-done = {$center} wurde auf {$wrong} markiert
line_without_common_link-should = {$center} liegt auf {$right}: Jede seiner Geraden verbindet zwei Pole, die ein drittes Glied gemeinsam haben
center_of_other_lines-done = {$center} wurde markiert, wo sich die Geraden von {$other} schneiden
center_of_other_lines-should = jede Gerade von {$center} verbindet zwei Pole, die ein drittes Glied gemeinsam haben
centers_swapped-done = {$first} und {$second} wurden miteinander verwechselt
centers_swapped-should = jede Gerade von {$first} verbindet zwei Pole, die ein drittes Glied gemeinsam haben
ratio_inverted-done = für {$rate} wurde das Verhältnis der Abstände umgekehrt genommen
ratio_inverted-should = die Abstände des gemeinsamen Pols verhalten sich umgekehrt wie die Winkelgeschwindigkeiten: mit {$over} / {$under} multiplizieren
mesh_sense-done = die Räder {$first} und {$second} wurden, vom Steg aus gesehen, gleichsinnig genommen
mesh_sense-should = Räder, die sich außen berühren, drehen sich, vom Steg aus gesehen, gegensinnig
mesh_sense_internal-done = Hohlrad und Rad von {$first} und {$second} wurden, vom Steg aus gesehen, gegensinnig genommen
mesh_sense_internal-should = ein Hohlrad und das Rad darin drehen sich, vom Steg aus gesehen, gleichsinnig
teeth_inverted-done = für die Räder {$first} und {$second} wurde das Verhältnis der Zähnezahlen umgekehrt genommen
teeth_inverted-should = die Winkelgeschwindigkeiten verhalten sich umgekehrt wie die Zähnezahlen
arm_forgotten-done = für die Räder {$first} und {$second} wurde das Verhältnis der Zähnezahlen ohne die Drehung von {$arm} genommen
arm_forgotten-should = das Verhältnis der Zähnezahlen gilt für die Winkelgeschwindigkeiten abzüglich ω_{$arm}
relative_for_absolute-done = {$rate} ist die relative zu {$arm}
relative_for_absolute-should = ω_{$arm} hinzuzählen
idler_counted-done = die Zähne von {$idler} stehen im Verhältnis von {$first} und {$last}
idler_counted-should = ein Zwischenrad ändert nur den Drehsinn; seine Zähne kürzen sich
rim_swapped-done = wo {$wheel} mit {$other} kämmt, wurden die Zähne seines anderen Kranzes genommen
rim_swapped-should = die Zähne des Kranzes nehmen, der berührt
rims_swapped-done = die beiden Kränze von {$wheel} wurden verwechselt
rims_swapped-should = in jedem Eingriff die Zähne des Kranzes nehmen, der berührt
pitch_on_wrong_side-done = {$wheel} wurde so genommen, als berührte es das Hohlrad {$ring} auf der nahen Seite
pitch_on_wrong_side-should = ein Hohlrad berührt das Rad darin jenseits von dessen Mittelpunkt
accelerations_equal-done = wo {$first} und {$second} sich berühren, wurden ihre Beschleunigungen als gleich genommen
accelerations_equal-should = dort sind nur Geschwindigkeiten und Tangentialanteile gleich; die Beschleunigung des Radmittelpunkts folgt aus dem Steg
diameter_for_radius-done = für {$found} wurde der Durchmesser von Rad {$wheel} statt seines Halbmessers genommen
diameter_for_radius-should = die Geschwindigkeit ist ω r und das Moment W r, mit dem Halbmesser r von Rad {$wheel}
radial_force_left_out-done = {$force} fehlt: die Zahnkraft wurde nur längs der Tangente genommen
radial_force_left_out-should = Zähne drücken längs ihrer Eingriffslinie aufeinander: neben dem Anteil längs der Tangente gibt es {$force}, tan α mal so groß, was die Räder auseinandertreibt
radius_left_out-done = für {$length} wurde nur der Halbmesser von {$link} genommen
radius_left_out-should = das Ersatzglied verbindet die Krümmungsmittelpunkte: {$length} ist die Summe beider Halbmesser, bei einem hohlen Profil ihre Differenz
wrong_center_of_curvature-done = die gemeinsame Normale von {$first} und {$second} wurde von {$wrong} aus gezogen
wrong_center_of_curvature-should = die gemeinsame Normale geht durch {$right}, den Krümmungsmittelpunkt des Profils an der Berührstelle
sliding_left_out-done = {$image} wurde bei {$start} eingezeichnet, als bewegten sich die Profile nicht aneinander entlang
sliding_left_out-should = Profile, die sich berühren, haben nur längs ihrer gemeinsamen Normalen gleiche Geschwindigkeiten: von {$start} aus ist die Relativgeschwindigkeit längs der Tangente zu zeichnen
face_along_wrong_line-done = die ebene Fläche von {$link} wurde längs {$line} genommen
face_along_wrong_line-should = die Relativgeschwindigkeit ist parallel zur Fläche
face_normal_to_wrong_line-done = die ebene Fläche von {$link} wurde senkrecht zu {$line} genommen
face_normal_to_wrong_line-should = die Relativgeschwindigkeit ist parallel zur Fläche, und die gemeinsame Normale steht senkrecht auf der Fläche selbst
friction_sense-done = {$friction} wurde im Sinn der Bewegung genommen
friction_sense-should = Reibung hemmt: was eine Führung oder ein Zapfen an einem Glied tut, ist der Bewegung des Glieds darauf entgegengesetzt
angle_for_coefficient-done = für {$friction} wurde der Reibungswinkel als Reibungszahl genommen, oder sein Tangens als sein Sinus
angle_for_coefficient-should = mit dem Reibungswinkel φ ist die Reibungszahl einer Führung μ = tan φ, und der Reibungskreis eines Zapfens hat den Halbmesser r sin φ
normal_without_lean-done = {$friction} wurde aus dem bestimmt, was das Gelenk ohne Reibung trüge
normal_without_lean-should = Reibung ändert, was im Gelenk drückt: die Kräfte sind mit {$friction} neu zu bestimmen, bis beides zusammenpasst
friction_circle_diameter-done = {$friction} wurde mit dem Durchmesser des Zapfens bestimmt
friction_circle_diameter-should = der Reibungskreis hat den Halbmesser r sin φ, mit dem Halbmesser r des Zapfens
friction_left_out-done = {$friction} fehlt
friction_left_out-should = {$friction} gehört zu den anderen Kräften: eine Führung hemmt mit μ |N|, ein Zapfen mit dem Moment einer Kraft, die den Reibungskreis berührt
sense_by_center-done = {$rate} hat den falschen Drehsinn
sense_by_center-should = der Drehsinn kehrt sich um, wo der gemeinsame Pol zwischen den beiden Gestellpolen liegt, und bleibt, wo er außerhalb liegt
velocity_reversed-done = {$velocity} wurde verkehrt herum angetragen
velocity_reversed-should = sie zeigt so, wie sich ihr Glied um seinen Gestellpol dreht
distance_from_wrong_center-done = für {$length} wurde der Abstand von {$from} nach {$to} genommen
distance_from_wrong_center-should = {$length} messen: Geschwindigkeiten eines Gliedes wachsen mit dem Abstand von seinem Pol mit dem Gestell
not_extended-done = für {$center} wurden die Geraden nicht weit genug gezogen: andere wurden zwischen den Polen geschnitten
not_extended-should = {$center} liegt, wo sich {$first} und {$second} schneiden, die über ihre Pole hinaus zu ziehen sind
velocity_along_ray-done = {$velocity} wurde längs des Strahls vom Pol angetragen
velocity_along_ray-should = eine Geschwindigkeit ist normal zum Strahl vom Pol zu ihrem Punkt
pin_of_three-done = {$center} wurde nicht in {$pin} angenommen, wo seine Glieder verbunden sind, sondern anderswo
pin_of_three-should = ein Gelenk, das drei Glieder verbindet, ist der Pol jedes Paares von ihnen
lengths_without_scale-done = {$lengths}: Millimeter auf dem Papier wurden als Längen genommen, ohne {$scale}
lengths_without_scale-should = Millimeter auf diesem Blatt mal {$scale} sind die Länge
inertia_along_a-done = {$load} wurde in Richtung der Beschleunigung angesetzt
inertia_along_a-should = eine Trägheitskraft ist −m a: sie zeigt gegen die Beschleunigung des Schwerpunkts
inertia_couple_along_alpha-done = {$load} wurde im Sinn der Winkelbeschleunigung angesetzt
inertia_couple_along_alpha-should = ein Trägheitsmoment als Belastung ist −J α: es dreht gegen die Winkelbeschleunigung; als eine Kraft liegt sie so neben dem Schwerpunkt, dass sie ebenso dreht
couple_forgotten-done = {$load} fehlt in den Momenten
couple_forgotten-should = ein Kräftepaar hat um jeden Punkt dasselbe Moment und zählt in jeder Momentensumme seines Glieds
percussion_on_wrong_side-done = {$load} wurde auf die falsche Seite des Schwerpunkts gelegt
percussion_on_wrong_side-should = die Wirkungslinie von {$load} läuft im Abstand h = J α / (m a) neben dem Schwerpunkt, wo sie gegen die Winkelbeschleunigung dreht
a_of_joint_for_centre-done = {$load} wurde mit der Beschleunigung von {$point} bestimmt
a_of_joint_for_centre-should = eine Trägheitskraft folgt aus der Beschleunigung des Schwerpunkts, nicht aus der eines Gelenks
centripetal_part_left_out-done = {$load} wurde ohne den Normalanteil der Beschleunigung um {$point} bestimmt
centripetal_part_left_out-should = die Beschleunigung des Schwerpunkts hat auch den Anteil ω² r auf {$point} zu
arm_to_point-done = für {$found} wurde ein Hebelarm bis zum Angriffspunkt seiner Kraft gemessen
arm_to_point-should = der Hebelarm einer Kraft ist der Abstand ihrer Wirkungslinie, senkrecht zu ihr gemessen
arm_in_paper_mm-done = für {$found} wurden Hebelarme in Millimetern des Papiers eingesetzt
arm_in_paper_mm-should = ein Hebelarm ist seine Millimeter mal {$scale}
arms_in_paper_mm-done = Hebelarme wurden in Millimetern des Papiers eingesetzt
arms_in_paper_mm-should = jeder Hebelarm ist seine Millimeter mal {$scale}
reaction_not_reversed-done = {$force} wurde weitergegeben, ohne sie umzukehren
reaction_not_reversed-should = was ein Glied am anderen tut, tut dieses umgekehrt an ihm: am nächsten Glied wirkt {$force} in der Gegenrichtung
negative_tangential_kept-done = {$force} wurde in der angenommenen Richtung abgetragen, obwohl die Momente sie negativ ergaben
negative_tangential_kept-should = eine Kraft, die negativ herauskommt, wirkt gegen die angenommene Richtung: {$force} wird andersherum abgetragen
normal_across-done = die Richtung von {$force} wurde senkrecht zur Linie beider Gelenke gezeichnet
normal_across-should = {$force} wirkt längs der Linie beider Gelenke ihres Glieds
force_missing_in_polygon-done = {$force} fehlt im Krafteck
force_missing_in_polygon-should = das Polygon hat jede Kraft auf die freigeschnittenen Glieder, auch {$force}
force_twice-done = {$force} wurde zweimal abgetragen
force_twice-should = jede Kraft steht einmal in einem Polygon
guide_reaction_along_rod-done = {$force} wurde längs {$guide} gezeichnet
guide_reaction_along_rod-should = ohne Reibung überträgt eine Führung nur Kräfte senkrecht zu sich
guide_reaction_through_pin-done = die Kraft von {$guide} wurde in {$point} angesetzt
guide_reaction_through_pin-should = sie wirkt im Abstand h = M / N von {$point}; die Momente des gleitenden Glieds sagen ihn
mass_for_weight-done = für {$load} wurde die Zahl der Masse genommen
mass_for_weight-should = ein Gewicht ist Masse mal g: {$load} = m g
factor_of_thousand-done = {$load} ist um den Faktor 1000 falsch
factor_of_thousand-should = mit Längen in mm ist eine Kraft in N die Masse in kg mal Beschleunigung in mm/s², durch 1000
moment_about_wrong_point-done = für {$found} wurden Momente um {$wrong} gebildet
moment_about_wrong_point-should = Momente werden um {$right} gebildet: dort gehen die Linien der anderen unbekannten Kräfte durch
moment_about_another_point-done = für {$found} wurden Momente um einen anderen Punkt als {$right} genommen
moment_about_another_point-should = Momente werden um {$right} genommen: die Wirkungslinien der anderen unbekannten Kräfte gehen durch diesen Punkt
lever_not_turned-done = für {$found} wurden die Kräfte auf den ungedrehten Geschwindigkeitsplan gesetzt
lever_not_turned-should = der Geschwindigkeitsplan, oder jede Kraft, wird zuerst um 90° gedreht: dann sind Momente um den Pol Leistungen
couple_on_lever_unscaled-done = das Kräftepaar an Glied {$link} wurde so, wie es ist, zu den Momenten des Hebels gezählt
couple_on_lever_unscaled-should = am Hebel sind ein Kräftepaar M zwei Kräfte M/l an den Bildern zweier Punkte von Glied {$link} im Abstand l
torque_sense-done = {$found} hat den Sinn dessen, wogegen der Antrieb arbeitet
torque_sense-should = {$found} ist, was der Antrieb an seinem Glied tut: es hält den Momenten aller Kräfte darauf das Gleichgewicht
other_mode-done = der Mechanismus wurde in einer anderen Einbaulage gezeichnet, in der seine Glieder zusammenpassen
other_mode-should = verlangt ist die Stellung, die das Bild zeigt
crank_angle-done = der Mechanismus wurde mit Glied {$link} unter {$wrong}° statt {$right}° gezeichnet
crank_angle-should = Winkel werden gegen den Uhrzeigersinn von der Waagerechten nach rechts aus gemessen
crank_angle_in_radians-done = der Taschenrechner nahm den Winkel von Glied {$link}, {$right}°, als {$right} Radiant, das sind {$wrong}°
crank_angle_in_radians-should = der Taschenrechner wird auf Grad gestellt
swapped-done = {$first} und {$second} stehen anscheinend im Kästchen des jeweils anderen
swapped-should = die beiden Zahlen tauschen
digits_transposed-done = {$quantity}: zwei Ziffern sind vertauscht, {$written} statt {$meant}
digits_transposed-should = {$meant}
decimal_slipped-done = {$quantity}: das Komma ist verrutscht, {$written} statt {$meant}
decimal_slipped-should = {$meant}
truncated-done = die Zahlen wurden nach ihrer letzten Ziffer abgeschnitten
truncated-should = die letzte Ziffer aufrunden, wenn die nächste 5 oder größer ist
wrong_unit-done = {$quantity}: {$number} ist der Wert in {$right}, nicht in {$wrong}
wrong_unit-should = {$number} {$right}
other_unit-done = {$quantity}: {$number} ist der Wert in {$unit}, und keine Einheit sagt es
other_unit-should = {$unit} daneben schreiben, oder den Wert in {$own}
unknown-done = {$quantity} ist falsch, aus einem Grund, den die Werte nicht zeigen; damit wurde weitergearbeitet
unknown-should = Prüfen Sie {$quantity} noch einmal
unknown_alone-done = nur {$quantity} ist falsch: falsch abgelesen, berechnet oder geschrieben, und damit wurde nicht weitergearbeitet
unknown_alone-should = Bestimmen Sie {$quantity} neu
unknown_first-done = {$quantity} ist der erste falsche Wert, aus einem Grund, den die Werte nicht zeigen
unknown_first-should = Prüfen Sie zuerst diesen Wert: spätere können aus ihm folgen


## Errors and warnings: scene


# Kinds of files.

scene-scene = Szenen
scene-study = Studien
scene-drawing = Zeichnung
scene-style = Stil
scene-form = Formular
scene-marks = Bewertungs
scene-begins_with = eine {$what}datei beginnt mit {$start}
scene-too_many_bytes = die {$what}datei hat {$bytes} Bytes; höchstens {$most} ({$mib} MiB) werden gelesen
scene-is_empty = die {$what}datei ist leer
scene-expected_object = erwartet ist eine {$what}datei wie {$start}, gefunden: {$found}
scene-meant_key = meinten Sie `{$key}` mit `{$other}`?
scene-add_version = ergänzen Sie "{$key}": {$version}, die Version des Formats der {$what}datei
scene-no_version = `{$key}` fehlt, also ist dies vielleicht keine {$what}datei
scene-other_version = dieses Programm liest Version {$version}, die {$what}datei nennt {$said}
scene-version_is_number = erwartet ist die Zahl {$version}, die Version des Formats, gefunden: {$found}
scene-write_version = schreiben Sie "{$key}": {$version}

# Text that is not JSON.

scene-not_json = dies ist kein JSON: {$what}
scene-not_json_at_all = dies ist kein JSON
scene-text_over_lines = ein Text endet in der Zeile, in der er beginnt
scene-add_quote_or_n = ergänzen Sie das fehlende ", oder schreiben Sie \n für einen Zeilenumbruch
scene-control_in_text = ein Text enthält einen Tabulator oder ein anderes Steuerzeichen
scene-write_t = schreiben Sie \t für einen Tabulator
scene-too_deep = Klammern sind tiefer als {$most} Ebenen verschachtelt
scene-no_comments = JSON hat keine Kommentare
scene-write_note = schreiben Sie "note": "…", das überall erlaubt ist
scene-trailing_comma = vor der schließenden Klammer steht ein Komma
scene-remove_comma = entfernen Sie das Komma
scene-leading_zero = eine Zahl beginnt nicht mit 0
scene-remove_zero = entfernen Sie die führende 0
scene-comma_missing = hier fehlt ein Komma
scene-brace_open = dieses {"{"} wird nie geschlossen
scene-add_brace = ergänzen Sie das fehlende {"}"}
scene-bracket_open = dieses [ wird nie geschlossen
scene-add_bracket = ergänzen Sie das fehlende ]
scene-brace_for_value = ein {"}"} steht, wo ein Wert stehen sollte
scene-bracket_for_value = ein ] steht, wo ein Wert stehen sollte
scene-comma_for_value = ein Komma steht, wo ein Wert stehen sollte
scene-colon_for_value = ein Doppelpunkt steht, wo ein Wert stehen sollte
scene-colon_missing = nach diesem Schlüssel fehlt ein Doppelpunkt
scene-value_missing = der Wert dieses Schlüssels fehlt
scene-after_end = nach dem Ende der {$what}datei steht noch etwas
scene-one_in_a_file = der Inhalt der {$what}datei steht in einem einzigen Paar {"{"} {"}"}
scene-single_quotes = Texte stehen in doppelten Anführungszeichen
scene-write_double = schreiben Sie "A" statt 'A'
scene-key_needs_quotes = der Schlüssel {$word} braucht doppelte Anführungszeichen
scene-write_key_value = schreiben Sie "Schlüssel": Wert
scene-no_number = {$word} ist keine Zahl
scene-every_number_finite = jede Zahl einer {$what}datei ist endlich; lassen Sie den Schlüssel weg, wenn ein Wert nicht bekannt ist
scene-not_here = {$sign} gehört nicht hierher
scene-no_value = {$word} ist kein Wert
scene-leave_key_out = lassen Sie den Schlüssel weg
scene-write_true = schreiben Sie true
scene-write_false = schreiben Sie false
scene-names_in_quotes = Texte und Namen stehen in doppelten Anführungszeichen
scene-plus_sign = vor einer Zahl steht kein Pluszeichen
scene-remove_plus = entfernen Sie das +
scene-decimal_only = Zahlen sind dezimal
scene-digits_both_sides = ein Dezimalpunkt braucht Ziffern auf beiden Seiten
scene-write_half = schreiben Sie 0.5 statt .5 und 5.0 statt 5.
scene-number_incomplete = diese Zahl ist nicht vollständig
scene-no_escape = ein \ in einem Text beginnt eine Escape-Folge, und dies ist keine
scene-write_backslash = schreiben Sie \\ für das Zeichen \
scene-text_open = dieser Text wird nie geschlossen
scene-add_quote = ergänzen Sie das fehlende "
scene-null = null ist hier kein Wert
scene-key_twice = der Schlüssel `{$key}` steht doppelt: zuerst in Zeile {$line}
scene-number_too_large = {$number} ist zu groß, um damit zu rechnen
scene-choose_units = wählen Sie Einheiten, mit denen die Zahl kleiner als 1e100 wird
scene-turns_beside_gears = {$angle} ist als Winkel neben Zahnrädern zu groß: seine ganzen Umdrehungen zählen und gingen verloren
scene-take_turns_off = schreiben Sie einen Winkel unter 1e14 Grad

# Values of a wrong kind.

scene-nothing = nichts
scene-a_number = die Zahl {$number}
scene-a_text = der Text "{$text}"
scene-empty_list = eine leere Liste
scene-list_of = eine Liste der Länge {$count}
scene-an_object = ein Objekt {"{"} … {"}"}
scene-unknown_key = unbekannter Schlüssel `{$key}`
scene-the_keys_are = die Schlüssel sind hier {$all}
scene-unknown_word = unbekanntes Wort "{$word}"
scene-write_one_of = schreiben Sie eines von {$all}
scene-write_truth_or_one_of = schreiben Sie true, false oder eines von {$all}
scene-missing = `{$key}` fehlt
scene-expected_found = erwartet: {$expected}; gefunden: {$found}
scene-in_double_quotes = schreiben Sie "{$number}" in doppelten Anführungszeichen
scene-add = ergänzen Sie {$json}
scene-add_on = ergänzen Sie "on", das Glied, das die Führung trägt, oder "ground"
scene-add_length_unit = ergänzen Sie "length": "m", "mm", "cm", "in" oder "ft"
scene-add_time_unit = ergänzen Sie "time": "s" oder "min"
scene-add_speed = ergänzen Sie "speed", in Richtung der Führung
scene-points_as_one_text = zwei Punkte als einen Text schreiben: "AB", oder "A-B", wo Namen länger sind
scene-without_quotes = schreiben Sie {$number} ohne Anführungszeichen
scene-with_a_point = schreiben Sie {$number} ohne Anführungszeichen und mit Dezimalpunkt
scene-or_as_rpm = schreiben Sie {$number} ohne Anführungszeichen, oder die Drehzahl als "rpm"
scene-in_degrees = Winkel sind in Grad: schreiben Sie {$number} ohne Anführungszeichen
scene-rpm_for_omega = schreiben Sie "rpm": {$number} statt "omega"
scene-units_in_units = schreiben Sie {$number} ohne Anführungszeichen; Einheiten stehen in `units`, Winkel sind in Grad
scene-two_numbers = erwartet sind zwei Zahlen [x, y], gefunden: eine Liste der Länge {$count}
scene-negative_size = der Betrag ist {$size}; ein Betrag ist nicht negativ: drehen Sie stattdessen den Winkel um 180
scene-no_page = es gibt kein Papierformat "{$name}"
scene-no_unit = es gibt keine Längeneinheit "{$name}"
scene-did_you_mean = meinten Sie `{$name}`?
scene-joints_out_of_scope = Glieder sind durch Drehgelenke, gerade Schubgelenke (`sliders`), Räder, Zahnstangen und Riemen (`gears`) und Profile, die sich berühren, wie die von Kurvenscheiben (`contacts`), verbunden
scene-forces_out_of_scope = Lasten sind `mass`, `inertia` und `center` eines Gliedes sowie `gravity`, `forces`, `springs` und `friction` der Szene; Dämpfer gibt es nicht

# What a form asks for.

scene-form_asks_nothing = dieses Formular fragt nach nichts
scene-form_no_quantity = {$name} ist kein Name einer Größe
scene-form_no_marks = {$marks} ist keine Punktzahl
scene-form_marks_from_0 = Punktzahlen gehen von 0 bis {$most}
scene-no_hints = {$count} ist keine Anzahl von Stufen eines Tipps
scene-hints_from_0 = schreiben Sie 0 (keine Tipps) bis {$most} (alle)
scene-form_names_quantities = schreiben Sie Namen, wie sie in einem leeren Formular stehen: "omega(2)", "vplan(p,b)"

# Names.

scene-a_point = ein Punkt
scene-a_link = ein Glied
scene-no_name = {$what} hat keinen Namen
scene-write_a_name = schreiben Sie einen Buchstaben oder eine Zahl zwischen die Anführungszeichen
scene-name_too_long = {$what} hat einen Namen mit mehr als {$most} Zeichen
scene-write_prime = schreiben Sie ' für einen Strich
scene-write_underscore = schreiben Sie _ statt -, das zwei Punkte verbindet
scene-signs_of_names = Namen bestehen aus Buchstaben, Ziffern, ' und _
scene-sign_in_name = {$what} hat den Namen `{$name}`, und der enthält `{$sign}`
scene-called_note = {$what} kann nicht `note` heißen: dieser Schlüssel ist für Notizen da
scene-called_ground = ein Glied kann nicht `ground` heißen: das ist das Gestell
scene-point_twice = Punkt {$point} steht doppelt
scene-link_twice = Glied {$link} steht doppelt
scene-point_twice_in_link = Punkt {$point} steht doppelt in Glied {$link}
scene-link_named = Glied {$link}
scene-point_named = Punkt {$point}
scene-the_ground = das Gestell
scene-lacks_point = {$carrier} hat keinen Punkt {$point}, überhaupt keine Punkte
scene-lacks_point_but = {$carrier} hat keinen Punkt {$point}, nur den Punkt {$only}
scene-lacks_point_of = {$carrier} hat keinen Punkt {$point}, nur die Punkte {$all}
scene-lengths_key = die Länge `{$key}`
scene-along_key = `along` mit `{$key}`
scene-pair_unknown = {$key}: {$why}
scene-pair_ambiguous = {$key} kann {$a} und {$b} oder {$c} und {$d} bedeuten
scene-pair_same = {$key} nennt den Punkt {$point} doppelt
scene-write_pair = schreiben Sie "{$a}-{$b}" oder "{$c}-{$d}"
scene-no_link = es gibt kein Glied {$link}
scene-the_links_are = die Glieder sind {$all}
scene-no_point = es gibt keinen Punkt {$point}
scene-the_points_are = die Punkte sind {$all}
scene-name_kept = der Name `{$name}` ist vergeben, als Name für: {$what}
scene-other_name = wählen Sie einen anderen Namen für den Punkt
scene-image_of = das Bild von {$point} in den Plänen
scene-special_point_of = der Sonderpunkt von Glied {$link}
scene-point_under = der Punkt von Glied {$link} unter {$point}

# Points, ground, known motions.

scene-no_coordinates = die Gestellpunkte haben keine Koordinaten
scene-write_coordinates = schreiben Sie {"{"} "A": [x, y], … {"}"}; oder geben Sie die Koordinaten aller Punkte in "points": {"{"} … {"}"} an
scene-other_coordinates = Punkt {$point} hat in `points` andere Koordinaten
scene-name_only = nennen Sie ihn nur in einer Liste: "ground": ["A", …]
scene-not_in_points = Punkt {$point} hat in `points` keine Koordinaten
scene-add_to_points = ergänzen Sie "{$point}": [x, y] in `points`
scene-on_no_link = Punkt {$point} gehört zu keinem Glied und nicht zum Gestell
scene-name_in_link = nennen Sie ihn in den `points` eines Gliedes, oder entfernen Sie ihn
scene-known_is_drawn = bekannte Bewegungen gehören zu einer gezeichneten Stellung
scene-points_or_drive = geben Sie die Koordinaten aller Punkte in "points": {"{"} … {"}"} an, oder treiben Sie ein Glied an
scene-ground_moves_not = Punkt {$point} gehört zum Gestell, das sich nicht bewegt
scene-remove_from_ground = entfernen Sie ihn hier oder aus `ground`
scene-motion_twice = die Bewegung von Punkt {$point} ist doppelt gegeben: {$first} und {$second}
scene-motion_already = die Bewegung von Punkt {$point} ist schon gegeben: {$by}
scene-keep_one = behalten Sie eines davon
scene-motion_of_link = `motion` von Glied {$link}
scene-drive_of_link = der Antrieb von Glied {$link}
scene-drive_of_slider = der Antrieb von Schieber {$link}
scene-drive_of_its_slider = der Antrieb seines Schiebers
scene-drawn_needs_no_near = eine gezeichnete Stellung braucht kein `near`
scene-remove_it_drawn = entfernen Sie es: die Zeichnung, `points`, gibt es schon an
scene-remove_drawn = entfernen Sie `{$key}`: die Zeichnung, `points`, gibt es schon an
scene-near_one_number = {$key} ist eine Zahl, in Grad, nicht zwei
scene-near_two_numbers = Punkt {$point} braucht zwei Zahlen [x, y], gefunden: eine

# Links and their drives.

scene-no_links = ein Mechanismus hat mindestens ein Glied
scene-lengths_and_shape = Glied {$link} hat `lengths` und `shape` zugleich
scene-drive_and_motion = Glied {$link} hat einen Antrieb und zugleich eine bekannte Bewegung
scene-two_angles = Glied {$link} hat einen Winkel, und sein Antrieb auch
scene-link_motion_is_drawn = Glied {$link}: eine bekannte Bewegung, `motion`, gehört zu einer gezeichneten Stellung
scene-points_or_drive_link = geben Sie die Koordinaten aller Punkte in "points": {"{"} … {"}"} an, oder treiben Sie das Glied an
scene-link_is_drawn = Glied {$link} hat `{$key}`, aber diese Szene ist eine gezeichnete Stellung
scene-remove_or_lengths = entfernen Sie `{$key}`: die Zeichnung, `points`, gibt es schon an; oder entfernen Sie `points` und geben Sie `ground` seine Koordinaten
scene-no_points = Glied {$link} hat kein `points`
scene-too_many_points = Glied {$link} hat {$count} Punkte, die durch Längen nicht festgelegt sind
scene-give_shape = geben Sie Koordinaten im eigenen System des Gliedes an: "shape": {"{"} "{$a}": [x, y], "{$b}": [x, y], … {"}"}
scene-no_distance = Glied {$link} hat die Punkte {$from} und {$to}, aber nicht ihren Abstand
scene-three_lengths = Glied {$link} hat drei Punkte, die drei Längen brauchen; die von {$from} und {$to} fehlt
scene-add_lengths = ergänzen Sie "lengths": {"{"} "{$key}": … {"}"}, oder geben Sie ein `shape` an
scene-add_to_lengths = ergänzen Sie "{$key}": … in den Längen
scene-length_twice = die Länge {$key} von Glied {$link} ist schon gegeben, als {$first}
scene-length_zero = die Länge {$key} ist 0: {$from} und {$to} wären ein einziger Punkt
scene-one_name_or_length = nehmen Sie einen Namen für beide, oder geben Sie eine positive Länge an
scene-length_negative = die Länge {$key} ist {$value}; eine Länge ist positiv
scene-no_triangle = Glied {$link}: die Längen {$lengths} können kein Dreieck bilden: {$one} + {$other} < {$long}
scene-shape_empty = das `shape` von Glied {$link} hat keine Punkte
scene-add_or_without_points = ergänzen Sie ihn in `points`, oder lassen Sie `points` weg
scene-shape_lacks = das `shape` von Glied {$link} sagt nicht, wo {$point} ist
scene-add_place = ergänzen Sie "{$point}": [x, y]
scene-zero_length = Glied {$link} hat {$first} und {$second} am selben Ort: seine Länge wäre null
scene-one_name_or_move = nehmen Sie einen Namen für beide, oder verschieben Sie einen
scene-drive_is_drawn = der Antrieb von Glied {$link} hat `{$key}`, aber diese Szene ist eine gezeichnete Stellung
scene-omega_and_rpm = der Antrieb von Glied {$link} hat `omega` und `rpm` zugleich
scene-drive_without_speed = der Antrieb von Glied {$link} hat keine Geschwindigkeit
scene-add_omega = ergänzen Sie "omega" (Radiant je Zeiteinheit) oder "rpm"; für ein gleitendes Glied "speed"
scene-pushes_and_turns = der Antrieb von Glied {$link} schiebt und dreht zugleich
scene-push_or_turn = ein Antrieb hat `position`, `speed`, `acceleration`, oder `angle`, `omega`, `alpha`
scene-push_without_speed = der Antrieb von Glied {$link} hat kein `speed`

# Sliders.

scene-slides_on_own = {$carrier} hat den Punkt {$point} selbst, er kann also nicht darauf gleiten
scene-other_sliding_name = nehmen Sie einen anderen Namen für den Punkt, der gleitet
scene-no_frame = Koordinaten brauchen ein Bezugssystem, und {$carrier} hat kein `shape`
scene-point_or_shape = nennen Sie einen Punkt ({$carrier}), oder geben Sie dem Glied ein `shape`
scene-point_or_without = nennen Sie einen Punkt ({$carrier}), oder lassen Sie `through` weg: die Führung geht durch den Punkt des Schiebers
scene-no_direction = eine Richtung vom Betrag null zeigt nirgendwohin
scene-give_direction = geben Sie [dx, dy] oder Grad an
scene-no_axis = {$carrier} hat keine Punkte und damit keine Achse, von der aus Grad zu zählen wären
scene-give_drawn_direction = geben Sie die Richtung an, wie sie gezeichnet ist: "along": [dx, dy]
scene-degrees_unquoted = schreiben Sie {$number} ohne Anführungszeichen für Grad
scene-one_place = {$from} und {$to} liegen am selben Ort, sie geben also keine Richtung
scene-two_drives = Glied {$link} hat einen Antrieb, und sein Schieber auch
scene-which_slider = Glied {$link} hat zwei Schieber, und sein Antrieb sagt nicht, welchen er schiebt
scene-drive_into_sliders = setzen Sie den Antrieb in einen der Einträge von `sliders`
scene-pushed_without_slider = Glied {$link} wird von seinem Antrieb geschoben, hat aber keinen Schieber
scene-add_slider = ergänzen Sie in `sliders` einen Eintrag mit diesem `link`, oder drehen Sie das Glied mit `omega`
scene-idle_link = Glied {$link} hat keine Punkte, und nichts gleitet auf ihm
scene-remove_or_name = entfernen Sie es, oder nennen Sie seine Punkte
scene-guide_nowhere = nirgends steht, wo die Führung ist: {$carrier} hat keine Punkte
scene-add_through = ergänzen Sie "through": [x, y], einen Ort auf der Führung
scene-name_on_guide = nennen Sie einen Punkt von Glied {$link}, der auf der Führung liegt
scene-turned_is_drawn = `turned` hat in einer gezeichneten Stellung keinen Platz
scene-position_is_drawn = dieser Antrieb hat `position`, aber diese Szene ist eine gezeichnete Stellung
scene-nothing_slides = dieser Schieber sagt nicht, was gleitet
scene-give_link_or_pin = geben Sie "link" und "at" an, das Glied und seinen Punkt auf der Führung; oder "pin"
scene-pin_and_link = `pin` steht anstelle von `link` und `at`, nicht daneben
scene-block_or_pin = behalten Sie `link` und `at` für einen Gleitstein, `pin` für einen bloßen Bolzen
scene-add_at = ergänzen Sie "at", den Punkt von Glied {$link}, der auf der Führung liegt
scene-add_link_or_pin = ergänzen Sie "link", das gleitende Glied; oder schreiben Sie "pin": "{$point}" für einen Bolzen in einem Schlitz
scene-slides_on_itself = Glied {$link} kann nicht auf sich selbst gleiten
scene-travel_is_drawn = eine gezeichnete Stellung ist die einzige, also haben ihre Führungen keine Enden
scene-travel_backwards = der Weg geht von {$low} bis {$high}
scene-lower_end_first = geben Sie zuerst die kleinere Lage an, als "travel": [20, 80]
scene-travel_has_two_ends = eine Führung hat zwei Enden, nicht {$count}

# Zahnradpaare.

scene-two_wheels = ein Paar hat zwei Räder, nicht {$count}
scene-meshed_twice = {$first} und {$second} greifen zweimal ineinander
scene-remove_one_mesh = entfernen Sie eines der beiden Paare; von zwei Kränzen eines Glieds greift jeder in ein anderes Rad
scene-no_train = keine Räder greifen ineinander: es gibt kein Getriebe für die Tabelle von Willis
scene-add_gears = lassen Sie sie weg oder geben Sie `gears` an
scene-meshes_with_itself = {$wheel} kann nicht in sich selbst eingreifen
scene-wheel_carries_itself = {$wheel} ist ein Rad dieses Paars und kann es nicht tragen
scene-name_the_carrier = `on` nennt das Glied, auf dessen Zapfen sich beide Räder drehen, oder "ground"
scene-wheels_on_one_axis = {$first} und {$second} drehen sich um eine Achse und können nicht ineinander greifen
scene-mesh_over_a_wheel = geben Sie ein Paar für jede Stelle an, an der sich Zähne berühren: Sonne und Planet, Planet und Hohlrad
scene-phase_is_drawn = `phase` hat in einer gezeichneten Stellung keinen Platz
scene-no_pressure = ein Eingriffswinkel von {$degrees}° ist keiner von Zähnen
scene-usual_pressure = üblich ist 20; von 0 bis {$most}
scene-no_teeth = {$teeth} ist keine Zähnezahl
scene-teeth_up_to = geben Sie eine ganze Zahl bis {$most} an, negativ für ein Hohlrad; bei Rädern ohne Zähne ganze Zahlen im Verhältnis der Radien
scene-two_rings = zwei Hohlräder können nicht ineinander greifen
scene-one_ring = ein Hohlrad greift in ein Rad in seinem Innern, dessen Zähnezahl positiv ist
scene-ring_of_the_same_size = Hohlrad und Rad haben gleich viele Zähne: sie wären eins
scene-ring_smaller = das Hohlrad hat {$ring} Zähne, das Rad darin {$wheel}
scene-ring_larger = ein Hohlrad hat mehr Zähne als das Rad in seinem Innern
scene-wheel_not_on_carrier = {$wheel} hat keinen Zapfen auf {$carrier}, das Glied trägt das Paar
scene-pin_the_wheel = nennen Sie die Mitte des Rads auf beiden: einen Punkt des Rads und des Trägers
scene-two_wheel_pins = {$wheel} und {$carrier} haben {$first} und {$second} gemeinsam, sind also starr verbunden
scene-one_wheel_pin = ein Rad dreht sich um einen Punkt seines Trägers
scene-two_racks = zwei Zahnstangen können nicht kämmen
scene-one_rack = eine Zahnstange kämmt mit einem Rad; schreiben Sie anstelle eines "rack" die Zähnezahl des Rads
scene-rack_without_slider = nichts lässt {$rack}, die Zahnstange, gegen {$carrier} gleiten, das Glied mit dem Rad
scene-rack_not_parallel = {$rack}, die Zahnstange, und {$carrier}, das Glied mit dem Rad, gleiten auf dem Gestell in zwei Richtungen
scene-let_rack_slide = geben Sie einen Schieber mit der Zahnstange auf dem Steg an, oder mit dem Steg auf der Zahnstange; oder je einen auf dem Gestell, längs paralleler Führungen
scene-teeth_of_pinion = geben Sie eine ganze Zahl von 1 bis {$most} an: Ein Rad auf einer Zahnstange hat seine Zähne außen
scene-no_radius = {$radius} ist kein Radius
scene-give_radius = geben Sie den Radius des Wälzkreises an, eine Länge über 0
scene-give_larger_radius = geben Sie den Radius des Wälzkreises an, in der Längeneinheit der Szene und nicht unter {$least}
scene-radius_without_rack = `radius` gehört zu einem Rad auf einer Zahnstange oder mit einem Riemen: Andere Räder haben ihre Radien vom Abstand ihrer Mitten
scene-position_without_rack = `position` gehört zu einem Rad auf einer Zahnstange
scene-give_phase = der Winkel eines Rads gegen ein anderes ist `phase`
scene-phase_of_rack = `phase` gehört zu zwei Rädern: Eine Zahnstange hat keinen Winkel
scene-give_position_of_rack = `position` sagt, wo die Zahnstange ist, wenn das Rad auf 0 steht
scene-belt_on_rack = um eine Zahnstange läuft kein Riemen
scene-belt_without_teeth = ein Riemen hat keinen Eingriffswinkel
scene-teeth_of_belt = geben Sie eine ganze Zahl von 1 bis {$most} an: Zähne von Kettenrädern, oder ganze Zahlen im Verhältnis der Radien
scene-no_forces_of_belts = wie stark ein Riemen gespannt ist, ist nicht bekannt; deshalb werden Kräfte von Getrieben mit Riemen nicht berechnet
scene-remove_belts_or_loads = entfernen Sie Massen, `gravity`, `forces` und `springs` aus der Szene, oder ihre Riemen
scene-two_touch = eine Berührung ist zwischen zwei Körpern, nicht {$count}
scene-touches_itself = {$body} kann sich nicht selbst berühren
scene-through_without_face = `through` ist eine Stelle auf einem ebenen Profil, aber das zweite ist rund
scene-give_face = geben Sie die Richtung des ebenen Profils als `along` an, oder lassen Sie `through` weg
scene-one_center_of_face = ein rundes Profil auf einem ebenen hat einen Krümmungsmittelpunkt, nicht {$count}
scene-face_has_no_center = nennen Sie nur den Mittelpunkt des ersten Profils; wo beide rund sind, lassen Sie `along` weg
scene-two_centers = zwei runde Profile haben zwei Krümmungsmittelpunkte, nicht {$count}
scene-center_or_face = nennen Sie einen Punkt jedes Körpers; von einem ebenen Profil geben Sie die Richtung als `along` an
scene-center_on_body = ein Krümmungsmittelpunkt ist ein Punkt des Körpers, zu dem das Profil gehört, in der Reihenfolge von `links`
scene-center_of_both = ein Krümmungsmittelpunkt ist ein Punkt von beiden, {$first} und {$second}: sie wären dort verbunden
scene-face_without_link = ein Bolzen auf einem ebenen Profil braucht kein Ersatzglied, also ist keines zu benennen
scene-flat_roller = eine Rolle ist rund, aber nach `along` ist das zweite Profil eben
scene-give_radii = geben Sie die Krümmungsradien in der Reihenfolge von `centers` an, als "radii": [40, 10]
scene-radii_as_centers = es braucht so viele Radien wie Mittelpunkte: {$wanted}, nicht {$count}
scene-hollow_on_face = ein hohles Profil berührt kein ebenes
scene-turn_face = der Radius ist positiv; für die andere Seite der Ebene drehen Sie `along` um 180
scene-two_hollows = zwei hohle Profile können sich nicht berühren
scene-hollow_and_round = nur der Radius eines hohlen Profils ist negativ, und das andere liegt in ihm
scene-give_roller = der zweite Radius ist der der Rolle
scene-centers_in_one_place = mit diesen Radien liegen beide Mittelpunkte an einer Stelle
scene-hollow_smaller = ein rundes Profil mit dem Radius {$round} liegt nicht in einem hohlen mit dem Radius {$hollow}
scene-hollow_larger = das hohle Profil hat den größeren Radius, mit einem Minus davor
scene-radii_not_as_drawn = {$first} und {$second} sind {$distance} voneinander entfernt gezeichnet, aber die Radien ergeben {$radii}
scene-radii_as_drawn = die Summe der Radien ist der Abstand der Mittelpunkte; eine Zeichnung kommt ohne Radien aus
scene-face_not_as_drawn = {$center} ist {$distance} vom ebenen Profil entfernt gezeichnet, aber der Radius ist {$radius}
scene-face_as_drawn = der Radius ist der Abstand des Krümmungsmittelpunkts vom ebenen Profil; eine Zeichnung kommt ohne ihn aus
scene-face_on_other_side = {$center} ist auf der falschen Seite des ebenen Profils gezeichnet: der erste Körper liegt rechts von `along`
scene-face_the_other_way = drehen Sie `along` um 180, oder nennen Sie seine Punkte in der anderen Reihenfolge
scene-equivalent_taken = das Ersatzglied würde {$link} heißen, aber es gibt ein Glied dieses Namens
scene-name_equivalent = geben Sie ihm einen anderen `name`

# Masses and loads.

scene-mass_and_weight = Glied {$link} hat eine Masse und ein Gewicht
scene-without_mass = Glied {$link} hat `{$key}`, aber keine Masse
scene-no_unit_of_mass = Glied {$link} hat eine Masse, aber die Szene hat keine Masseneinheit
scene-add_unit_of_mass = ergänzen Sie `"mass": "kg"` in `units`
scene-weight_without_gravity = Glied {$link} hat ein Gewicht, aber die Szene keine Schwerkraft, so dass seine Masse nicht bekannt ist
scene-add_gravity = ergänzen Sie `"gravity": [0, -9810]` (in mm und s), oder geben Sie eine Masse an
scene-no_center_of_mass = Glied {$link} hat eine Masse, aber keinen Schwerpunkt
scene-add_center = ergänzen Sie `"center"`: einen Punkt wie "C", Koordinaten [x, y] im System des Glieds, oder einen Abstand entlang seiner Achse
scene-below_zero = `{$key}` ist {$value}, kleiner als null
scene-no_unit_of_force = es gibt Lasten, aber die Szene hat keine Krafteinheit
scene-add_unit_of_force = ergänzen Sie `"force": "N"` in `units`
scene-distance_is_drawn = ein Abstand entlang der Achse von Glied {$link}, aber diese Szene ist eine gezeichnete Stellung
scene-place_as_drawn = geben Sie die Koordinaten [x, y] an, wie sie gezeichnet sind
scene-neither_force_nor_couple = eine Last ist eine Kraft, ein Moment, oder beides
scene-force_nowhere = eine Kraft greift an einer Stelle an
scene-add_at_of_force = ergänzen Sie `"at"`: einen Punkt wie "C", Koordinaten [x, y] im System des Glieds, oder einen Abstand entlang seiner Achse
scene-couple_turns = ein Moment ist dasselbe, ob es sich mitdreht oder nicht
scene-turns_is_drawn = in einer gezeichneten Stellung ist eine Kraft, wie sie gezeichnet ist
scene-spring_within_link = beide Enden der Feder sind an einem Körper, sie zieht also an nichts
scene-spring_between_links = nennen Sie zwei Körper, wie [["3", "C"], ["ground", "A"]]
scene-no_point_of_ground = das Gestell hat keinen Punkt {$point}
scene-distance_on_ground = das Gestell hat keine Achse; geben Sie einen Punkt oder Koordinaten [x, y] an
scene-load_name = `{$name}` kann nicht der Name einer Last sein: ein Name ist nicht leer und hat kein ( ) und kein Komma
scene-load_name_twice = zwei Lasten haben den Namen {$name}
scene-other_load_name = wählen Sie einen anderen Namen für die Last
scene-over_what = eine Last kann sich nicht über {$name} ändern
scene-over_angle_or_position = nenne den Winkel eines Glieds als "angle(1)" oder die Lage eines Gleitsteins als "position(3/ground)"
scene-over_short = eine Tabelle hat mindestens zwei Zeilen
scene-over_two_lines = gib Paare aus Stelle und Faktor an, wie [[0, 0], [90, 1500], [180, 0]]
scene-over_back = {$after} steht nach {$before}
scene-over_in_order = ordne die Zeilen der Tabelle nach ihrer ersten Zahl
scene-over_more_than_a_turn = eine Tabelle über einem Winkel wiederholt sich mit jeder Umdrehung, und diese ist länger
scene-over_one_turn = gib höchstens 360° an
scene-spring_ends = eine Feder hat zwei Enden, nicht {$count}
scene-pin_and_guide = Reibung ist in einem Zapfen oder in einer Führung, nicht in beiden
scene-friction_nowhere = Reibung ist in einem Gelenk
scene-pin_or_guide = `"pin": "B"` ergänzen für den Zapfen eines Punktes oder `"guide": "3/ground"` für die Führung eines Gleitsteins
scene-friction_without_radius = die Reibung am Zapfen {$point} hat ein Moment, das mit dem Zapfen wächst, dessen Radius fehlt
scene-add_radius = `"radius"` ergänzen, den des Zapfens, in der Längeneinheit der Szene
scene-guide_has_no_radius = eine Führung hat keinen Zapfen
scene-guide_has_no_pin = eine Führung hat keinen Zapfen, der in einem Glied fest sein könnte
scene-friction_twice = {$joint} hat zweimal Reibung
scene-coefficient_and_angle = die Reibung hat eine Reibungszahl und einen Winkel, die dasselbe sagen
scene-no_coefficient = es fehlt, wie groß die Reibung ist
scene-angle_of_friction = ein Reibungswinkel von {$angle}° liegt nicht unter 90°
scene-below_right_angle = üblich sind 3° bis 30°, wie bei Reibungszahlen von 0.05 bis 0.6

# The figure.

scene-scale_is = `{$key}` ist {$what}
scene-scale_too_large = {$scale}; Zahlen sind höchstens {$most}
scene-scale_not_positive = {$scale}; ein Maßstab, in Einheiten je Millimeter Papier, ist positiv
scene-next_scale = lassen Sie ihn weg, um den nächsten passenden Maßstab zu erhalten
scene-no_panels = ein Bild ohne Felder zeigt nichts
scene-name_panels = nennen Sie einige von {$all}, oder lassen Sie `panels` weg
scene-panel_twice = dieses Feld steht doppelt
scene-step_from_one = Konstruktionsschritte sind von 1 an nummeriert
scene-steps_listed = `kinegon steps` führt sie auf; lassen Sie `step` weg für das fertige Bild
scene-frame_is_link = so heißt schon das Glied {$link}
scene-other_frame = geben Sie dem Gestell die andere Nummer oder in `labels` einen eigenen Text: {"{"} "ground": "…" {"}"}
scene-ghosts_between = die Anzahl der blassen Stellungen geht von {$least} bis {$most}, nicht {$count}
scene-drawn_has_no_path = eine gezeichnete Stellung lässt sich nicht bewegen, also hat Punkt {$point} keine Bahn
scene-drawn_has_no_centrodes = eine gezeichnete Stellung lässt sich nicht bewegen, also hat Glied {$link} keine Polbahnen
scene-drawn_has_no_ghosts = eine gezeichnete Stellung lässt sich nicht bewegen, also gibt es keine anderen Stellungen zu zeichnen
scene-lengths_and_drive = eine Szene mit `lengths` oder `shape` und einem Antrieb mit seinem `angle` oder `position`
scene-at_contact_alone = die Profile, die sich berühren, sind nur an ihrer Berührung bekannt, also gibt es keine andere Stellung
scene-say_circular = schreiben Sie "circular": true in die Berührung, wenn beide Profile Kreise um diese Mittelpunkte sind, oder ein Kreis und eine Gerade
scene-no_drive_no_path = kein Antrieb bewegt den Mechanismus, also hat Punkt {$point} keine Bahn
scene-no_drive_no_centrodes = kein Antrieb bewegt den Mechanismus, also hat Glied {$link} keine Polbahnen
scene-no_drive_no_ghosts = kein Antrieb bewegt den Mechanismus, also gibt es keine anderen Stellungen zu zeichnen
scene-give_drive = geben Sie einem Glied ein "drive"
scene-moving_points = bewegte Punkte sind {$all}
scene-ground_has_no_path = Punkt {$point} gehört zum Gestell und hat keine Bahn
scene-name_of_construction = {$name} ist ein Name der Konstruktion und kein Punkt eines Gliedes
scene-no_center = "{$name}" benennt keinen Momentanpol
scene-name_center = ein Pol heißt nach zwei Gliedern, wie P(1,3), oder P(2,ground) mit dem Gestell
scene-center_twice = der Pol {$name} steht zweimal da
scene-ground_is_at_rest = Punkt {$point} gehört zum Gestell und bewegt sich nicht

# How large a scene may be.

scene-a_scene = eine Szene
scene-a_figure = ein Bild
scene-a_figure_with_steps = ein Bild mit Schritten
scene-a_drawing_judged = eine Zeichnung, die geprüft wird,
scene-by_hand = eine Konstruktion von Hand
scene-too_many_links = {$what} hat höchstens {$most} Glieder, und hier sind {$count}
scene-too_many_points_in = {$what} hat höchstens {$most} Punkte, und hier sind {$count}
scene-too_many_loads = {$what} hat höchstens {$most} Kräfte, Kräftepaare und Federn, und hier sind {$count}
scene-divide_mechanism = teilen Sie den Mechanismus: was allein an den Antrieben hängt, kann eine eigene Szene sein
scene-replace_loads = ersetzen Sie Lasten am selben Glied durch ihre Resultierende

# What stands after "expected": types say it in English to serde, which hands over nothing but text.

scene-expects_two_numbers = zwei Zahlen [x, y] oder {"{"} "size": …, "angle": … {"}"}
scene-expects_place_on_link = zwei Zahlen [x, y] oder eine Zahl, der Abstand längs der Achse
scene-expects_rough_place = zwei Zahlen [x, y], oder für einen "angle(…)" eine Zahl, seine Grad
scene-expects_point_or_place = der Name eines Punktes in doppelten Anführungszeichen, oder seine Koordinaten [x, y]
scene-expects_direction = zwei Punkte wie "BE", oder eine Zahl in Grad, oder [dx, dy]
scene-expects_vector = ein Vektor wie {"{"} "size": 150, "angle": 210 {"}"}
scene-expects_link = ein Glied wie {"{"} "points": ["A", "B"], … {"}"}, oder eine Liste seiner Punkte ["A", "B"]
scene-expects_link_place = den Namen eines Punkts in doppelten Anführungszeichen, seine Koordinaten [x, y], oder einen Abstand entlang der Achse des Glieds
scene-expects_table_line = zwei Zahlen, eine Stelle und einen Faktor, wie [90, 1500]
scene-expects_load = eine Last wie {"{"} "on": "3", "at": "C", "force": [-150, 0] {"}"}
scene-expects_spring = eine Feder wie {"{"} "between": [["3", "C"], ["ground", "A"]], "rate": 1.5, "length": 120 {"}"}
scene-expects_spring_end = ein Ende einer Feder wie ["3", "C"], ein Glied und ein Ort auf ihm
scene-expects_friction = Reibung wie {"{"} "pin": "B", "coefficient": 0.1, "radius": 12 {"}"} oder {"{"} "guide": "3/ground", "coefficient": 0.1 {"}"}
scene-expects_a_link = ein Glied
scene-expects_ground = die Gestellpunkte wie {"{"} "A": [x, y], … {"}"}, oder ihre Namen wie ["A", …]
scene-expects_drive = ein Antrieb wie {"{"} "angle": 70, "omega": -1 {"}"}
scene-expects_push = ein Antrieb wie {"{"} "position": 40, "speed": 10 {"}"}
scene-expects_motion = eine Bewegung wie {"{"} "velocity": [x, y], "acceleration": [x, y] {"}"}
scene-expects_link_motion = eine Bewegung wie {"{"} "at": "B", "velocity": [x, y], "omega": 1 {"}"}
scene-expects_slider = ein Schieber wie {"{"} "link": "3", "at": "D", "on": "2", "along": "BE" {"}"}
scene-expects_gear = ein Zahnradpaar wie {"{"} "mesh": ["1", "2"], "teeth": [20, 40], "on": "ground" {"}"}
scene-expects_contact = eine Berührung als {"{"} "links": ["1", "3"], "centers": ["K", "C"], "radii": [40, 10] {"}"}
scene-expects_teeth = eine Zähnezahl, oder "rack"
scene-expects_scene = eine Szene wie {"{"} "kinegon": 1, … {"}"}
scene-expects_figure = ein Bild wie {"{"} "panels": ["scheme", "velocity"] {"}"}
scene-expects_centers = "all", oder Pole wie ["P(2,ground)", "P(1,3)"]
scene-expects_units = Einheiten wie {"{"} "length": "mm", "time": "s" {"}"}
scene-expects_truth_or_paper = true, false oder "paper"
scene-expects_truth_or_unit = true, false oder eine Längeneinheit
scene-expects_truth = true oder false
scene-expects_whole_number = eine ganze Zahl von 1 bis 65535
scene-expects_number = eine Zahl
scene-expects_text = ein Text in doppelten Anführungszeichen
scene-expects_list = eine Liste [ … ]
scene-expects_object = ein Objekt {"{"} … {"}"}


## Errors and warnings: mechanism

mechanism-nothing_to_solve = nichts zu lösen: die Bewegung aller Glieder ist gegeben
mechanism-add_links = ergänzen Sie Glieder zwischen den angetriebenen Gliedern, den bekannten Punkten und dem Gestell
mechanism-over_no_slider = es gibt keinen Gleitstein {$name}, über dessen Lage sich eine Last ändern könnte
mechanism-over_no_zero = die Lage von {$name} zählt von keinem Punkt an, so dass sich keine Last über ihr ändern kann
mechanism-friction_no_slider = es gibt keinen Gleitstein {$name}, in dessen Führung Reibung sein könnte
mechanism-the_sliders_are = die Gleitsteine sind: {$names}
mechanism-friction_no_joint = in {$point} sind keine Glieder verbunden, dort reibt also nichts
mechanism-friction_of_contact = {$joint} steht für Profile, die sich berühren; sie reiben an der Berührung und nicht dort
mechanism-no_friction_of_contact = Reibung von Berührungen ist nicht bekannt: lassen Sie sie weg
mechanism-pin_of_several = der Zapfen {$point} verbindet mehrere Glieder, {$links}: seine Reibung hängt davon ab, in welchem er fest ist
mechanism-write_fixed_in = schreiben Sie `"fixed_in": "{$link}"` oder ein anderes von diesen
mechanism-pin_of_two = der Zapfen {$point} verbindet zwei Glieder: seine Reibung ist dieselbe, in welchem von beiden er auch fest ist
mechanism-leave_fixed_in_out = lassen Sie `fixed_in` weg
mechanism-angle_of_another = der Winkel von Glied {$link} kann den des Antriebs nicht ersetzen: er ändert sich nicht mit diesem Antrieb
mechanism-angle_in_drive = geben Sie im Antrieb an, wo er steht, oder den Winkel eines Gliedes, das sich mit ihm dreht
mechanism-mirror_image = Glied {$link}: seine Längen passen zu einem Dreieck und zu dessen Spiegelbild; genommen wird {$points}, gegen den Uhrzeigersinn. Um zu wählen, geben Sie in `near` ungefähre Orte seiner Punkte an
mechanism-singular = Glieder {$links} haben in keiner Stellung eine bestimmte Bewegung: eine Gruppe der Klasse {$class} mit Schubgelenken wie in {$pattern} ist durch ihre Struktur singulär
mechanism-make_revolute = machen Sie eines der Schubgelenke zum Drehgelenk
mechanism-train_without_ratio = aus den Zähnezahlen folgen die Winkel der Glieder {$links} nicht: die Räder drehen sich gleich, was auch der Steg tut, so dass nichts ihn antreibt
mechanism-other_teeth = geben Sie andere Zähnezahlen an, so dass die Standübersetzung nicht 1 ist, oder treiben Sie den Steg an
mechanism-two_radii = Rad {$link} mit {$teeth} Zähnen hätte zwei Wälzkreisradien, {$first} und {$second}: prüfen Sie Zähnezahlen und Achsabstände
mechanism-belt_without_room = die Räder {$first} und {$second} mit den Radien {$radii} haben den Abstand {$distance}: so kann kein Riemen um sie laufen; prüfen Sie Radius und Abstand
mechanism-along_its_x_axis = Schieber {$link}: längs der Führung liegt die x-Achse seiner Form, nicht seine Punkte {$points}, die in den Formen die Richtung der Führung haben: sind beide Formen Orte einer Zeichnung, so gehört "turned": {$turned} dazu
mechanism-off_guide = Schieber {$slider} ist nicht auf seiner Führung: er steht bei {$position}, und sie geht von {$low} bis {$high}; was daraus folgt, gilt hier nicht
mechanism-holds_here_alone = die Berührung von {$first} und {$second} ist nur in dieser Stellung bekannt: ihr Ersatzgetriebe gibt hier Geschwindigkeiten, Beschleunigungen und Kräfte, und anderswo nichts

# Too few or too many constraints.

mechanism-one_link = Glied {$link}
mechanism-several_links = Glieder {$links}
mechanism-one_free_motion = 1 freie Bewegung
mechanism-free_motions = {$count} freie Bewegungen
mechanism-can_still_move = {$links}: noch beweglich (übrig: {$free})
mechanism-add_a_drive = ergänzen Sie dort 1 Antrieb oder ein Gelenk
mechanism-add_drives = ergänzen Sie dort {$count} Antriebe oder ein Gelenk
mechanism-one_constraint = 1 Bedingung
mechanism-constraints = {$count} Bedingungen
mechanism-cannot_move = {$links}: so angetrieben nicht beweglich (zu viel: {$surplus})
mechanism-take_away = nehmen Sie dort einen Antrieb oder ein Gelenk weg
mechanism-one_drive = 1 Antrieb
mechanism-drives = {$count} Antriebe
mechanism-mobility = Freiheitsgrad 3·{$links} − {$constraints} = {$mobility}; dazu {$drives}

# Drives.

mechanism-one_ground_point = Glied {$link} ist angetrieben und muss daher genau einen Punkt am Gestell haben; es hat {$count}
mechanism-list_pivot = führen Sie den Punkt, um den es sich dreht, in `ground` und unter den Punkten des Gliedes auf
mechanism-driven_link = Glied {$link}
mechanism-driven_slider = Schieber {$slider}
mechanism-two_angles = Glied {$first} und Glied {$second} geben beide einen Winkel an; nur der Winkel eines Gliedes kann den eines Antriebs ersetzen
mechanism-remove_one = entfernen Sie einen davon; ungefähre Winkel stehen in `near`
mechanism-angle_without_drive = Glied {$link} gibt einen Winkel an, aber kein Glied hat einen Antrieb
mechanism-add_drive = ergänzen Sie einen Antrieb mit `omega` an dem Glied, das sich um einen Gestellpunkt dreht
mechanism-angle_beside = Glied {$link} gibt einen Winkel an, aber `{$key}` steht schon im Antrieb von {$driven}
mechanism-keep_one = behalten Sie eines davon; ein ungefährer Winkel steht in `near`
mechanism-angle_beside_all = Glied {$link} gibt einen Winkel an, aber jeder Antrieb gibt schon an, wo er steht
mechanism-two_open_drives = die Antriebe von {$first} und {$second} geben nicht an, wo sie stehen; der Winkel von Glied {$link} ersetzt nur einen davon
mechanism-add_to_one = ergänzen Sie "{$key}" in einem davon
mechanism-open_drive = der Antrieb von {$driven} gibt kein `{$key}` an
mechanism-add_angle = ergänzen Sie "angle": Grad von +x bis zur Achse des Gliedes; oder geben Sie stattdessen das `angle` eines anderen Gliedes an
mechanism-add_position = ergänzen Sie "position": seinen Abstand von `through` längs der Führung; oder geben Sie stattdessen das `angle` eines Gliedes an

# Angles that look like radians.

mechanism-angle_of_link = der Winkel von Glied {$link}
mechanism-guide_of = die Führung von {$slider}
mechanism-near_angle_of = `near` für angle({$link})
mechanism-radians = {$what} gilt als {$angle}°, sieht aber nach Radiant aus: Winkel sind in Grad, also {$degrees}, falls das gemeint ist

# Places far away.

mechanism-far_origin = der Ursprung liegt {$far} von einem etwa {$size} großen Mechanismus entfernt: von Orten mit 16 Ziffern bleiben {$digits} für seine Form. Legen Sie den Ursprung in die Nähe


## Errors and warnings: position

position-no_mode = Glieder {$links} lassen sich{$at} nicht zusammensetzen: {$miss}
position-other_angle_or_lengths = ein anderer Antriebswinkel oder andere Längen
position-angle_from_to = von {$from}° bis {$to}°
position-angle_within_or_lengths = ein Antriebswinkel {$ranges}, wo es zusammengesetzt werden kann, oder andere Längen
position-at_value = {" "}bei {$quantity} = {$value}
position-longer = wenn alles Übrige geschlossen ist, müsste {$leg} um {$by} länger sein
position-shorter = wenn alles Übrige geschlossen ist, müsste {$leg} um {$by} kürzer sein
position-any_direction = die äußeren Gelenke liegen am selben Ort und die Längen sind gleich, sodass sich alles dort um beliebige Winkel drehen kann
position-never_meet = die Führungen und Längen treffen sich nie
position-parallel_guides = Glieder {$links} lassen sich nicht zusammensetzen: die beiden Führungen, die sich an Glied {$link} treffen, sind parallel
position-turn_one = `turned` eines der Schieber, die Grad von der Führung bis zur Achse des Gliedes, stellt sie unter einen Winkel
position-too_large = Längen von etwa {$size} sind zu groß, um damit zusammenzusetzen: ihre vierten Potenzen verlassen den Zahlenbereich
position-too_small = Längen von etwa {$size} sind zu klein, um damit zusammenzusetzen: ihre vierten Potenzen verlassen den Zahlenbereich
position-other_unit = eine andere Längeneinheit
position-no_such_mode = es gibt keine Einbaulage {$mode}: vorhanden sind {$count}
position-modes_listed = `kinegon modes` führt sie auf
position-too_many_modes = Einbaulage {$mode} liegt zu weit hinten: nach {$count} wurde nicht weiter gezählt
position-rough_places_choose = ungefähre Orte in `near`, die ohne Zählen auswählen
position-too_much_work = es wurde kein Weg gefunden, alle Glieder zusammenzusetzen: schon die ersten passen auf zu viele Arten zusammen
position-rough_places = ungefähre Orte ihrer Punkte in `near`
position-not_found = es wurde kein Weg gefunden, die Glieder {$links}{$at} zusammenzusetzen: {$tried}
position-rough_places_or_other = ungefähre Orte ihrer Punkte in `near`, ein anderer Antriebswinkel oder andere Längen
position-moves = Glieder {$links} können sich bei stehenden Antrieben bewegen, obwohl ihr Freiheitsgrad 0 ist: keine der gefundenen Lagen ist eine Einbaulage
position-none_closes = von {$starts} Startwerten schließt keiner
position-none_closes_but = von {$starts} Startwerten schließt keiner, der nächste lässt eine Lücke vom {$gap}-Fachen der Größe des Mechanismus

# Warnings.

position-unproven = `near` lässt zu viele Einbaulagen offen, um alle zu vergleichen, und die gewählte ist vielleicht nicht die nächste: geben Sie darin ungefähre Orte weiterer Punkte an
position-at_least = mindestens {$count}
position-far_off = `near` ist im quadratischen Mittel {$distance} von der nächsten Einbaulage entfernt (Anzahl: {$count}), mehr als die halbe Größe des Mechanismus, {$size}: prüfen Sie die Koordinaten
position-point_far_off = Punkt {$point} liegt bei [{$x}, {$y}], {$off} von seinem Ort in `near` entfernt, in der nächsten Einbaulage (Anzahl: {$count}): prüfen Sie die Koordinaten
position-not_chosen = Glieder {$links} lassen sich auf {$count} Arten zusammensetzen, und `near` ist nicht gegeben; genommen wird Einbaulage 1: {$listed}
position-searched = Glieder {$links} bilden eine Gruppe höherer Klasse: ihre Einbaulagen wurden durch Suche gefunden, es kann weitere geben; wie viele es geben kann, ist nicht bekannt
position-searched_of = Glieder {$links} bilden eine Gruppe höherer Klasse: {$found} ihrer Einbaulagen wurden durch Suche gefunden, es kann weitere geben, aber höchstens {$most}
position-may_move = Glieder {$links} können sich bei stehenden Antrieben bewegen, obwohl ihr Freiheitsgrad 0 ist: neben den Einbaulagen gibt es eine ganze Kurve von Lagen
position-nearly_flat = Glied {$link}: seine Punkte liegen fast auf einer Geraden, und `near` passt zu seinem Dreieck und zum Spiegelbild fast gleich gut; genommen wird das nähere. Um zu wählen, geben Sie `shape` an, oder Orte in `near` mit mehr Ziffern


## Errors and warnings: motion

motion-singular = Glieder {$links} sind in singulärer Lage: {$reason} (Kondition {$condition})
motion-singular_exactly = Glieder {$links} sind in singulärer Lage: {$reason} (genau)
motion-at_limit = Grenzlage bei {$place}: Glieder {$links} kommen nicht weiter; ihre Geschwindigkeiten und Beschleunigungen wachsen unbegrenzt: {$reason}
motion-at_change = Verzweigungslage bei {$place}: Glieder {$links} könnten auch in anderer Einbaulage weiterlaufen, daher sind ihre Geschwindigkeiten nicht bestimmt: {$reason}
motion-move_a_joint = ein anderer Kurbelwinkel, oder rücken Sie eines dieser Gelenke von der gemeinsamen Geraden oder dem gemeinsamen Punkt weg
motion-overflow = Glieder {$links}: ein Abstand, eine Geschwindigkeit oder eine Beschleunigung ist zu groß, um dargestellt zu werden
motion-larger_units = größere Längeneinheiten oder langsamere Antriebe
motion-near_singular = Glieder {$links} sind nahe einer singulären Lage (Kondition {$condition}): Koordinaten mit 16 Ziffern bestimmen etwa {$digits} Ziffern ihrer Geschwindigkeiten
motion-near_limit = Glieder {$links} sind in einer Grenzlage oder dicht daneben (Kondition {$condition}): Längen und Winkel mit 16 Ziffern bestimmen etwa {$digits} Ziffern ihrer Geschwindigkeiten

# Why a position is singular.

motion-no_definite_motion = ihre Schleifen haben keine bestimmte Bewegung
motion-in_one_line = {$first} und {$second} liegen auf einer Geraden
motion-parallel = die Geraden {$lines} sind parallel
motion-in_one_point = die Geraden {$lines} schneiden sich in einem Punkt
motion-normal_to_guide = durch {$through} normal zur Führung in {$at}
motion-at_infinity = im Unendlichen (Führungen in {$first} und {$second})


## Errors and warnings: accuracy

accuracy-unproved = Glieder {$links}: über ihre Stellung oder Bewegung ist nichts bewiesen, daher haben ihre Zahlen keine Fehlerangabe
accuracy-pulls = die Profile der Berührung {$contact} müssten hier aneinander ziehen: sie trennen sich, wenn nichts sie zusammenhält
accuracy-unbounded = {$names}: für den Fehler lässt sich keine Schranke angeben, weil das, woraus sie abgelesen werden, null sein kann oder Geraden parallel sein können
accuracy-at_limit = Grenzlage bei {$place}: Glieder {$links} kommen nicht weiter; ihre Geschwindigkeiten und Beschleunigungen wachsen unbegrenzt, daher haben ihre Zahlen keine Fehlerangabe
accuracy-at_change = Verzweigungslage bei {$place}: Glieder {$links} könnten auch in anderer Einbaulage weiterlaufen, daher sind ihre Geschwindigkeiten nicht bestimmt und ihre Zahlen haben keine Fehlerangabe


## Errors and warnings: quantity

quantity-no_quantity = `{$name}` ist keine Größe; bekannte Formen: omega(2) alpha(2) omega(2/1) alpha(2/1) i(3,1) rpm(2) angle(2) x(D) y(D) v(D) a(D) v(D/G) a(D/G) a_n(D/G) a_t(D/G) a_c(3/2) position(3/2) v_r(3/2) a_r(3/2) L(B,S3) vplan(b,s3) aplan(n_b3,s3) P(1,3) W(2) G(2) d_i(2) rho(D) R(B,2) R_n(B,2) R_t(B,2) N(3/2) M(3/2) h(3/2) T(1) F(3/2) F_i(2) M_i(2) a_cm(2) moment(F1,S3) power(F1) shaking shaking(A); Vektoren auch mit .x .y .size .angle, Strecken der Pläne mit /mu
quantity-no_link = `{$quantity}`: es gibt hier kein Glied `{$name}`
quantity-no_slider = `{$quantity}`: es gibt hier keinen Schieber `{$name}`
quantity-no_point = `{$quantity}`: es gibt hier keinen Punkt `{$name}`
quantity-no_load = `{$quantity}`: hier gibt es keine Last `{$name}`
quantity-no_plan_point = `{$quantity}`: es gibt hier keinen Planpunkt `{$name}`
quantity-did_you_mean = {$message}; meinten Sie `{$name}`?
quantity-no_value = `{$quantity}` hat hier keinen Wert: {$why}
quantity-on_paper = eine Länge auf dem Papier gehört zum Bild einer einzigen Stellung
quantity-without_mu = der Name ohne `/mu`
quantity-no_accelerations = nach Beschleunigungen war nicht gefragt
quantity-no_axis = das Glied hat keine Achse
quantity-no_zero = die Führung hat keinen Punkt, von dem aus zu zählen wäre
quantity-no_plan_no_scale = das Bild hat keinen solchen Plan und damit keinen Maßstab
quantity-scale_too_small = der Maßstab ist dafür zu klein
quantity-no_construction = es gibt keine Konstruktion
quantity-at_infinity = der Sonderpunkt liegt im Unendlichen
quantity-not_on_one_link = die beiden Punkte gehören nicht zu einem Glied
quantity-no_plan = es gibt keinen solchen Plan
quantity-no_force_plan = es gibt keinen Kräfteplan: die Figur braucht das Feld "forces"
quantity-two_polygons = seine Enden sind Ecken zweier Kraftecke, die beliebig nebeneinander stehen
quantity-routes_differ = Kraftecke und Gleichgewichtsgleichungen weichen stärker voneinander ab, als beide erlauben
quantity-no_way = von einer dieser Ecken zur anderen führen keine Kräfte mit eigenen Namen; die Kraft selbst hat einen Namen, etwa R(B,2) oder R_n(B,2)
quantity-centre_at_infinity = der Momentanpol liegt im Unendlichen und hat nur eine Richtung: `.angle`
quantity-centre_at_place = der Momentanpol liegt an einem Ort: `.x`, `.y`
quantity-rest_on_another = die Glieder ruhen gegeneinander
quantity-link_turns_not = das Glied dreht sich nicht
quantity-ratio_to_rest = `{$link}` dreht sich nicht, sodass es kein Verhältnis zu ihm gibt
quantity-path_is_straight = die Bahn ist dort gerade, oder der Punkt ruht
quantity-place_has_no_size = `{$name}` ist ein Ort und hat keinen Betrag; fragen Sie nach `.x` oder `.y`
quantity-no_loads = die Szene hat keine Massen, Kräfte oder Federn
quantity-no_mass = dieses Glied hat keine Masse
quantity-no_inertia = die Trägheit bleibt außer Betracht: `"analysis": "static"`
quantity-no_line_of_joints = dieses Glied hat dort nicht zwei Gelenke, deren Linie gemeint wäre
quantity-no_normal_force = quer zur Führung wirkt keine Kraft
quantity-no_line_of_action = die Kraft hat hier keine Wirkungslinie, oder keine in endlichem Abstand
quantity-not_driven = es ist nicht angetrieben
quantity-not_at_pin = dieses Glied hat kein Gelenk an diesem Bolzen
quantity-no_forces = seine Lasten liegen außerhalb des Zahlenbereichs, die Stellung ist singulär, oder Reibung sperrt
quantity-nowhere_in_range = in keiner Stellung des Bereichs
quantity-no_scale_in_table = eine Tabelle hat keinen Maßstab


## Errors and warnings: forces

forces-spring_without_direction = die Enden der Feder {$spring} fallen in dieser Stellung zusammen, so dass ihre Kraft keine Richtung hat: es werden keine Kräfte gezeigt
forces-friction_locks = die Reibung sperrt das Getriebe in dieser Lage: kein Antrieb bewegt es in diese Richtung, daher gibt es keine Kräfte
forces-friction_at_rest = in Ruhe kann die Reibung alles bis zu ihrer Grenze sein: in {$joints} zählt sie nicht, und die angegebenen Fehler lassen sie ganz zu
forces-friction_leaves_open = in Ruhe kann die Reibung alles bis zu ihrer Grenze sein, und die in {$joints} lässt offen, was Gelenke tragen: es gibt keine Kräfte


## Errors and warnings: cycle

cycle-drawn = eine gezeichnete Stellung lässt sich nicht bewegen: sie hat keine Längen
cycle-lengths_and_drive = eine Szene mit `lengths` oder `shape` und einem Antrieb mit seinem `angle` oder `position`
cycle-at_contact = die Profile, die sich berühren, sind nur an ihrer Berührung bekannt, also lässt sich das Getriebe nicht bewegen
cycle-say_circular = "circular": true in der Berührung, wenn beide Profile Kreise um diese Mittelpunkte sind, oder ein Kreis und eine Gerade
cycle-off_guide = Schieber {$slider} ist hier nicht auf seiner Führung, also bewegt ihn nichts
cycle-on_guide = beginnen Sie dort, wo er innerhalb von `travel` ist
cycle-other_kind = Mechanismus {$number} ist nicht von der Art von Mechanismus 0
cycle-same_kind = dieselben Glieder, Gelenke und Antriebe in derselben Reihenfolge; nur Längen, Orte und Antriebe dürfen sich unterscheiden
cycle-no_drive = es gibt keinen Antrieb, der zu bewegen wäre
cycle-give_drive = geben Sie einem Glied ein "drive"
cycle-no_such_drive = es gibt keinen Antrieb `{$name}`; die Antriebe sind: {$known}
cycle-singular = Glieder {$links} sind bei {$at} in singulärer Lage, also ist nicht entschieden, wie sie weiterlaufen
cycle-at_limit = Grenzlage bei {$place}: Glieder {$links} kommen nicht weiter; ihre Geschwindigkeiten und Beschleunigungen wachsen unbegrenzt; auf welchem von zwei Wegen sie zurückkommen, ist nicht entschieden
cycle-at_change = Verzweigungslage bei {$place}: Glieder {$links} könnten auch in anderer Einbaulage weiterlaufen; welchen Weg sie nehmen, ist nicht entschieden
cycle-other_position = eine Szene in einer anderen Stellung des Antriebs; von dort aus wird der Weg gefunden
cycle-out_of_reach = der Bereich von {$from} bis {$to} ist nicht erreichbar: {$stop}
cycle-within_reach = ein Bereich, der einen Teil von {$low} bis {$high} enthält
cycle-no_vector = `{$name}` ist kein Vektor
cycle-vectors = v(D), v(D/G), a(D), a_n(D/G), a_t(D/G), a_c(3/2) mit Namen dieser Szene
cycle-no_path = `{$name}` ist kein Punkt eines bewegten Gliedes und hat daher keine Bahn
cycle-not_finite = die Enden des Bereichs müssen endliche Zahlen sein
cycle-too_many_turns = der Bereich reicht weiter als hundert Umdrehungen
cycle-too_far = der Bereich reicht weiter als das Hundertfache der Größe des Mechanismus
cycle-values_between = Werte zwischen {$low} und {$high}
cycle-no_range = der Bereich von {$quantity} ist nicht gegeben
cycle-both_ends = sowohl --from als auch --to: dieser Schieber hat keinen vollen Umlauf und keine zwei Enden
cycle-no_step = die Schrittweite kann nicht {$step} sein
cycle-distance_of_rows = der Abstand von einer Zeile zur nächsten, wie 1
cycle-step_leads_away = eine Schrittweite von {$step} führt vom Ende des Bereichs weg
cycle-positive_step = eine positive Schrittweite; ihr Vorzeichen folgt aus dem Bereich
cycle-too_many_steps = von {$from} bis {$to} sind es mehr als {$most} Schritte zu je {$step}
cycle-larger_step = eine größere Schrittweite
cycle-no_room = von {$from} bis {$to} ist kein Platz für eine Kurve
cycle-table_too_long = die Tabelle hätte {$rows} Zeilen zu {$columns} Zahlen
cycle-sweep_or_fewer = schreiben Sie sie mit `kinegon sweep`, oder nennen Sie weniger Größen im `want` der Szene
cycle-more_room = ein Bereich mit mehr Platz zwischen --from und --to


## Errors and warnings: editing

editing-no_object = eine Szene ist ein Objekt {"{"} … {"}"}
editing-no_entry = diese Liste (Einträge: {$count}) hat kein {$key}
editing-no_room = hier ist kein Platz für {$key}
editing-not_all = eine Szene lässt sich nicht aus ihrem Text entfernen
editing-point_twice = Punkt {$point} steht doppelt im neuen Glied
editing-no_points = ein neues Glied hat keine Punkte
editing-name_one = nennen Sie mindestens einen
editing-point_on_link = Glied {$link} hat schon einen Punkt {$point}
editing-link_unknown = es ist nicht bekannt, wo Glied {$link} in der jetzigen Stellung ist
editing-point_unknown = es ist nicht bekannt, wo Punkt {$point} in der jetzigen Stellung ist
editing-rough_places = geben Sie ungefähre Orte in `near` an
editing-slides_on_own = Punkt {$point} gehört zu {$on} und kann daher nicht darauf gleiten
editing-other_point = wählen Sie einen anderen Punkt oder einen anderen Träger der Führung
editing-in_one_place = Glied {$link} hätte {$first} und {$second} am selben Ort
editing-one_name_or_move = nehmen Sie einen Namen für beide, oder verschieben Sie einen
editing-no_place = dies ist kein Ort
editing-drawn = eine gezeichnete Stellung lässt sich nicht bewegen
editing-give_lengths = geben Sie den Mechanismus durch Längen an, mit einem Antrieb
editing-no_position = die Stellung lässt sich nicht als Werte der Antriebe schreiben
editing-other_position = nehmen Sie eine andere Stellung
editing-near_cannot_choose = ungefähre Orte können Einbaulage {$mode} nicht auswählen
editing-point_there = einen Punkt {$name} gibt es schon
editing-link_there = ein Glied {$name} gibt es schon
editing-other_name = wählen Sie einen anderen Namen
editing-no_point = es gibt keinen Punkt {$name}
editing-no_link = es gibt kein Glied {$name}
editing-table_no_number = Zeile {$line}, Spalte {$column}: da steht keine Zahl
editing-table_one_column = es gibt keine zweite Spalte
editing-table_line = schreiben Sie in jede Zeile einen Ort und einen Faktor, als `90,1500`
editing-table_first = schreiben Sie bloße Zahlen, einen Ort und einen Faktor, als `90,1500`; eine erste Zeile, die die Spalten benennt, hat keine Zahlen
editing-table_more_cells = Zeile {$line} hat {$cells} Zellen, die erste Zeile {$first}
editing-table_marks = trennen Sie Zellen durch Semikolons, wenn Zahlen Dezimalkommas haben
editing-table_unnamed = es gibt mehr als zwei Spalten, und die erste Zeile benennt sie nicht
editing-table_head = benennen Sie die Spalten in der ersten Zeile, die von Lasten so wie die Szene
editing-table_no_column = es gibt keine Spalte für `{$load}`
editing-table_nameless = es gibt keine Spalte für diese Last, die keinen Namen hat
editing-table_name = benennen Sie in der ersten Zeile eine Spalte so wie die Szene die Last
editing-table_long = es gibt mehr als {$most} Zeilen
editing-table_shorten = lassen Sie Zeilen weg, die eine Gerade ebenso gibt

# Why a joint that is pulled does not follow the hand.

editing-held_point = {$point} ist festgehalten
editing-held_length = {$point} bewegt sich auf einem Kreis: {$length} ist festgehalten
editing-held_angle = {$point} bewegt sich auf einer Geraden: der Winkel von Glied {$link} ist festgehalten
editing-held_guide = {$point} bewegt sich auf einer Geraden: der Führung von {$slider}
editing-held_rack = {$point} bewegt sich quer zur Führung: längs geht die Zahnstange mit ihrem Rad
editing-held_nowhere = das Gelenk kann nicht dorthin
editing-held_rounded = mit dem Gelenk an diesem Ort lassen gerundete Längen den anderen Gelenken keinen Platz nahe ihrem eigenen
editing-held_try = ziehen Sie das Gelenk an einen anderen Ort


## Errors and warnings: drawing

drawing-scheme = der Lageplan
drawing-velocity_plan = der Geschwindigkeitsplan
drawing-acceleration_plan = der Beschleunigungsplan
drawing-centers = die Figur der Momentanpole
drawing-force_plan = Kräfteplan
drawing-lever = Hebel
drawing-speeds = Kutzbachplan
drawing-overflow = {$panel} passt bei {$key} = {$given} nicht in sein Feld und ist dort abgeschnitten; {$fitting} passt, oder ein größeres Blatt
drawing-no_scale = keiner
drawing-cost_of_list = die Maßstäbe lassen Platz für die Ergebnisliste: {$scales}
drawing-cost_of_names = die Maßstäbe lassen Platz für die Namensliste: {$scales}
drawing-in_place_of = {$scale} = {$now} statt {$before}
drawing-too_many_panels = {$wanted} Arten von Größen brauchen {$wanted} Felder, und das Blatt hat Platz für {$room}
drawing-fewer_or_page = weniger Größen auf einmal, oder eine andere `page` im Bild der Szene, wie "a4-portrait"
drawing-too_many_curves = {$wanted} Kurven in einem Feld sind mehr, als sich unterscheiden lassen, nämlich {$most}
drawing-fewer_quantities = weniger Größen auf einmal
drawing-no_film_of = eine Umdrehung eines Films kann nicht {$seconds} Sekunden dauern
drawing-at_most_seconds = mehr als 0 und höchstens {$most} Sekunden
drawing-no_film_at = ein Film kann nicht {$count} Bilder je Sekunde haben
drawing-pictures_a_second = 1 bis {$most} Bilder je Sekunde
drawing-no_motion = {$seconds} Sekunden mit {$count} Bildern je Sekunde zeigen keine Bewegung
drawing-longer_or_more = längere Zeit oder mehr Bilder je Sekunde
drawing-film_too_long = der Film hätte {$count} Bilder; zulässig sind {$most}
drawing-film_of_turns_too_long = der Film hätte {$count} Bilder in {$turns} Umdrehungen des Antriebs; zulässig sind {$most}
drawing-less_or_fewer = weniger Zeit je Umdrehung oder weniger Bilder je Sekunde
drawing-no_sheet = es gibt kein Blatt {$number}; vorhanden sind {$count}
drawing-no_step = es gibt keinen Schritt {$step}; die Schritte gehen von 1 bis {$count}
drawing-drive_stands = der Antrieb `{$drive}` kann sich nicht bewegen


## Errors and warnings: check

check-two_values = `{$name}` hat hier zwei Werte: {$one} und {$two}
check-keep_one = behalten Sie den, den Sie meinen
check-form_empty = das Formular ist leer: es hat keine Werte zu prüfen
check-write_values = schreiben Sie Ihre Werte neben die Namen; `kinegon check SCENE --template` schreibt das Formular
check-points_without_scale = die Orte der Punkte sind in Millimetern Papier, aber Ihr Maßstab {$scale} fehlt
check-add_scale_of = ergänzen Sie {$scale}, den Maßstab von Ihrem {$sheet}
check-no_pole = bei den Orten im {$sheet} fehlt sein Pol {$pole}
check-no_origin = {$sheet}: es fehlt der Ort von {$point}, von dem aus die anderen gemessen sind
check-add_pole = ergänzen Sie "{$pole}": [x, y]
check-no_length_on_paper = `{$name}` ist keine Länge auf dem Papier, daher kann `/mu` nicht folgen
check-write_in = schreiben Sie es in {$unit}
check-no_sheet = dem Bild der Szene fehlt der {$sheet} und damit dessen Maßstab
check-add_scale_or_panel = ergänzen Sie {$scale} bei den Werten, oder das Feld im Bild der Szene
check-no_number = `{$text}` ist keine Zahl
check-write_digits = schreiben Sie Ziffern mit Dezimalpunkt, wie 61.5; lassen Sie leer, was Sie nicht gemessen haben
check-too_large = `{$text}` ist zu groß
check-wrong_digit = ist eine Ziffer oder ein Exponent falsch?
check-paper_without_scale = `{$name}` ist in Millimetern Papier, aber Ihr Maßstab {$scale} fehlt
check-add_scale = ergänzen Sie {$scale}: wie viele {$unit} 1 mm in Ihrem {$sheet} bedeutet
check-unit_on_paper = `{$name}` ist in Millimetern Papier, aber `{$unit}` steht daneben
check-unit_or_mu = lassen Sie die Einheit weg, oder das `/mu`
check-no_unit_of = `{$text}` ist keine Einheit für {$kind}
check-write_unit = schreiben Sie `{$unit}`, oder lassen Sie die Einheit weg
check-did_you_mean = meinten Sie `{$name}`?
check-template_lists = `kinegon check SCENE --template` führt die Namen auf
check-nearest_name = der nächstliegende Name ist `{$name}`; `kinegon check SCENE --template` führt die Namen auf
check-no_quantity = `{$name}` ist keine Größe dieser Szene
check-no_box = kein Schritt findet `{$name}`; deshalb hat ein Formular kein Kästchen dafür
check-pi_lost = in `{$name}` ging der Buchstabe π verloren
check-save_as_utf8 = speichern Sie als CSV UTF-8, oder schreiben Sie pi
check-too_many = ein Formular hat höchstens {$most} Werte, und hier sind {$count}
check-is_this_a_form = ist dies ein Formular? `kinegon check` ohne Formular gibt ein leeres aus
check-no_scale = {$scale} ist kein Maßstab
check-scale_is_positive = ein Maßstab ist eine positive Zahl: Einheiten der Szene je Millimeter Papier
check-not_understood = nicht verstandene Angaben in diesem Formular ({$count}):{$all}
check-line = Zeile {$number}

# Kinds of quantities, and sheets.

check-angle = einen Winkel
check-angular_velocity = eine Winkelgeschwindigkeit
check-rotational_speed = eine Drehzahl
check-speed_ratio = eine Übersetzung
check-angular_acceleration = eine Winkelbeschleunigung
check-position = eine Position
check-length = eine Länge
check-velocity = eine Geschwindigkeit
check-acceleration = eine Beschleunigung
check-force = eine Kraft
check-moment = ein Moment
check-power = eine Leistung

# Tables.

check-open_quotation = hier beginnt ein Anführungszeichen, das in dieser Zeile nicht endet: die Zeilen darunter gingen verloren
check-close_quotation = schließen Sie es, oder lassen Sie es weg
check-no_table = dies ist keine Tabelle: {$error}
check-write_lines = schreiben Sie für jeden Wert eine Zeile `quantity,value`; Namen mit Komma stehen in doppelten Anführungszeichen
check-value_without_name = `{$text}` steht hier ohne den Namen einer Größe
check-value_in_unit = `{$text}` steht an der Stelle der Einheit, und davor kein Wert
check-no_sense = `{$text}` ist kein Drehsinn
check-write_sense = schreiben Sie `clockwise` oder `counter-clockwise`
check-values_in = Werte in `{$unit}` werden nicht verstanden
check-not_upright = `{$text}` sagt nicht, ob die Blätter aufrecht liegen
check-no_count = `{$text}` ist keine Anzahl von Tipps
check-whole_number = schreiben Sie eine ganze Zahl ab 0, oder lassen Sie die Zeile weg
check-true_or_false = schreiben Sie `true`, wenn sie liegen, wie sie gedruckt wurden, sonst `false`
check-mm_or_units = schreiben Sie `mm` für Millimeter Papier, oder `units` für die Einheiten der Szene
check-no_coordinate = `{$text}` ist keine Koordinate
check-write_coordinates = schreiben Sie x und y in Millimetern Papier, wie velocity:b,114,-2.7
check-no_radius = `{$text}` ist kein Radius
check-write_radius = hinter x und y darf stehen, wie weit der Punkt davon entfernt sein kann, in Millimetern Papier, wie velocity:b,114,-2.7,0.2
check-scale_no_number = {$scale} ist `{$text}`, und das ist keine Zahl
check-write_scale = schreiben Sie Einheiten der Szene je Millimeter Papier, wie 2 oder 0.5

# Marks.

check-no_part = {$number} ist kein Anteil der Punktzahl
check-part_from_0 = schreiben Sie eine Zahl von 0 (nichts) bis 1 (volle Punktzahl der Größe)
check-no_marks = {$number} ist keine Punktzahl
check-marks_from_0 = schreiben Sie eine Zahl von 0 bis {$most}
check-marks_twice = `{$name}` ist dieselbe Größe und hat schon ihre Punktzahl
check-no_marks_at_all = die Bewertung gibt für nichts eine Punktzahl
check-add_each = ergänzen Sie "each": 1, oder Punktzahlen für die Größen, die zählen

# Refusals of pages.

check-tolerance = die Toleranz eines Bleistifts geht von 0 bis {$most}
check-no_photograph = es gibt kein Foto


## Errors and warnings: exercise

exercise-no_construction = ihre Pläne haben keine Konstruktion, die von Hand zu zeichnen wäre: ein Sonderpunkt liegt im Unendlichen, oder eine Gruppe ist von höherer Klasse als IV
exercise-nothing_to_find = im Bild der Momentanpole ist nichts zu finden: die gezeigten Pole liegen in Gelenken und Führungen; nennen Sie andere in `figure.centers`, oder Punkte in `figure.velocities`
exercise-gave_up = keine von {$tries} Varianten lässt sich gut von Hand zeichnen; am häufigsten ({$percent} %): {$most}
exercise-numbers = die Zahlen passen nicht zusammen
exercise-assembly = die Glieder erreichen einander nicht
exercise-singular = die Stellung ist zu nahe an einer singulären
exercise-no_plans = es gibt keine Konstruktion der Pläne
exercise-routes = die Konstruktion ist nicht genau genug
exercise-crossing = Geraden schneiden sich unter weniger als 20°
exercise-sheet = ein Sonderpunkt oder ein Plan passt nicht auf das Blatt
exercise-short = eine Strecke ist zu kurz: eine zu messende kürzer als 5 mm, oder eine anzutragende kürzer als 4 mm
exercise-unsure = eine Geschwindigkeit oder Beschleunigung lässt sich von Hand nicht auf 15 % bestimmen
exercise-center_far = ein Momentanpol liegt zu weit weg für das Blatt
exercise-centers_close = zwei Momentanpole sind einander näher als 6 mm
exercise-center_distance = ein Abstand, aus dem eine Geschwindigkeit folgt, ist kürzer als 15 mm
exercise-center_unsure = ein Momentanpol lässt sich von Hand nicht auf 2 mm bestimmen
exercise-forces_cross = Richtungen von Kräften schneiden sich unter weniger als 15°
exercise-force_short = eine Kraft ist kürzer als 8 mm
exercise-arm_short = ein Hebelarm ist kürzer als 10 mm
exercise-forces_unequal = eine Kraft ist kleiner als ein Vierzigstel einer anderen
exercise-forces_unequal_as = eine Kraft ist kleiner als ein Vierzigstel einer anderen, so {$small} neben {$large} in der Szene, wie sie ist: lassen Sie weg, was so klein ist (Schwerkraft, eine Masse, die Trägheit durch "analysis": "static"), oder machen Sie die Lasten ähnlicher
exercise-force_unsure = eine Kraft oder ein Moment ist von Hand nicht auf 8 % zu finden
exercise-evened = einige Kräfte der Szene sind neben anderen zu klein, um mit ihnen gezeichnet zu werden; die Übungen haben andere Lasten: {$changes}
exercise-same = ihre Zahlen kamen schon vor
exercise-numbered = Aufgaben sind von 1 bis {$most} nummeriert
exercise-no_such = es gibt keine solche Aufgabe
exercise-whole_seed = ein Startwert ist eine ganze Zahl


## Errors and warnings: photo

photo-no_sheet = im Bild ist kein Blatt mit Marken zu finden
photo-one_marker = im Bild ist nur eine der acht Marken des Blattes zu finden
photo-few_markers = im Bild sind nur {$count} der acht Marken des Blattes zusammen zu finden
photo-whole_sheet = nehmen Sie das Foto von oben auf, mit dem ganzen Blatt und allen acht schwarzen Quadraten, scharf und ohne Hand darüber; ohne Marken gedruckte Blätter lassen sich nicht lesen
photo-cut_off = das Bild endet vor dem Blatt: einige seiner acht schwarzen Quadrate liegen außerhalb
photo-step_back = nehmen Sie das Foto aus größerem Abstand auf, mit allen acht schwarzen Quadraten
photo-mirrored = das Bild ist gespiegelt
photo-unmirror = nehmen Sie es mit der Rückkamera des Telefons auf, oder schalten Sie die Spiegelung aus
photo-not_even = das Blatt ist nicht eben: seine Marken liegen {$mm} mm neben ihrem Ort auf einem ebenen Blatt
photo-bent = das Blatt ist gewölbt: seine Mitte liegt {$mm} mm über oder unter den Rändern
photo-flatten = drücken Sie das Blatt flach, unter einer Glasscheibe oder mit Gewichten auf den Rändern, und wiederholen Sie das Foto
photo-blurred = das Bild ist unscharf: Kanten auf dem Blatt sind darin {$mm} mm breit
photo-nearer = gehen Sie näher heran, sodass das Blatt das Bild füllt, bei mehr Licht, und halten Sie die Kamera ruhig
photo-no_code = der kleine Code in der rechten unteren Ecke des Blattes ist nicht lesbar
photo-light_on_code = nehmen Sie das Foto aus der Nähe und scharf auf, mit Licht auf dem Code; nichts darf darübergezeichnet sein; im Chat verschickte Bilder sind oft zu klein
photo-other_page = der kleine Code gehört zu einem anderen Format als die Marken: das Bild zeigt Teile von zwei Blättern, oder ein zerschnittenes Blatt
photo-one_whole_sheet = fotografieren Sie ein ganzes Blatt, wie es gedruckt wurde
photo-cut_short = ist unvollständig: die Datei endet mitten im Bild
photo-send_again = kopieren oder senden Sie das Foto noch einmal
photo-second_sheet = das Bild zeigt auch Teile eines anderen Blattes, das nicht gelesen wird
photo-each_by_itself = fotografieren Sie jedes Blatt einzeln
photo-nothing_drawn = im Bild sind keine Bleistiftlinien der Pläne zu finden
photo-nothing_in_blur = Bleistiftlinien der Pläne sind nicht zu finden: das Bild ist unscharf, Kanten auf dem Blatt sind darin {$mm} mm breit
photo-mark_by_hand = nehmen Sie ein schärferes Foto auf, oder markieren Sie die Punkte auf der Werkbank
photo-scaled = alle gefundenen Punkte liegen {$percent} % zu weit von den Polen entfernt
photo-scaled_down = alle gefundenen Punkte liegen {$percent} % zu nahe an den Polen
photo-measure_ruler = legen Sie ein Lineal an das auf dem Blatt gedruckte: wenn dessen 50 mm nicht 50 mm lang sind, wurde das Blatt an die Seite angepasst gedruckt


## Errors and warnings: board

board-too_many = eine Zeichnung hat höchstens {$most} Einträge, und hier sind es {$count}
board-sheet_too_large = mit {$mu} je mm wäre der {$sheet} {$metres} m groß; gezeichnet werden Blätter bis {$most} m
board-other_scale = geben Sie den Maßstab Ihres Blattes an, etwa {$mu}, oder lassen Sie {$key} weg
board-no_formula = `{$text}` ist keine Formel: ab Zeichen {$place} ist sie nicht zu verstehen
board-no_equation = `{$text}` ist keine Gleichung: es fehlt das =
board-not_linear = `{$text}` ist nicht linear in den gesuchten Zahlen
board-no_value = `{$text}` hat keinen Wert
board-no_solution = die Gleichungen haben keine Lösung, oder viele
board-taken = `{$name}` geht nicht als Name: er ist vergeben, oder keiner
board-no_point = einen Punkt {$name} gibt es noch nicht
board-no_line = eine Linie {$name} gibt es nicht
board-no_number = {$name} ist noch nicht bekannt
board-no_direction = {$name} hat keine Richtung
board-no_reference = `{$name}` gibt keine Richtung: es ist keine Linie, kein Glied und keine Führung; zwei Punkte schreibt man als "B,C"
board-which_points = Glied {$link} hat mehr oder weniger als zwei Punkte: sagen Sie, zwischen welchen, etwa "B,C"
board-which_sheet = sagen Sie, auf welchem Blatt, etwa "on": "velocity"
board-two_sheets = die Linien {$one} und {$two} liegen auf zwei Blättern
board-no_crossing = die Linien {$one} und {$two} sind parallel
board-line_misses = {$point} liegt nicht auf dieser Linie
board-lines_of_others = {$point} liegt nicht dort, wo sich diese Linien schneiden
board-point_elsewhere = {$point} liegt nicht dort
board-no_force_of_polygon = der Vektor nach {$point} ist keine Kraft, die im Krafteck noch fehlt
board-no_direction_of_force = {$line} hat die Richtung keiner Kraft, die das Krafteck schließt
board-polygon_not_closed = das Krafteck schließt sich in {$point} nicht
board-number_wrong = das ist nicht {$name}
board-nothing_leads_to = nichts Gezeichnetes führt zu {$name}: zeichnen oder messen Sie, woraus es folgt
board-equation_wrong = Gleichung {$number} gilt nicht
board-leads_wrong = damit wird {$name} falsch
board-drawn_off = diese Linie ist {$mm} mm und {$degrees}° neben dem Gemeinten gezeichnet
board-point_off = dieser Punkt ist {$mm} mm neben dem Gemeinten markiert
board-misread = {$name} ist {$mm} mm neben dem Gezeichneten abgelesen
board-join = Linie {$name} durch {$one} und {$two}
board-line = Linie {$name} durch {$point}, {$direction}
board-line_by_eye = Linie {$name} nach Augenmaß
board-cross = {$name}, wo sich {$one} und {$two} schneiden
board-lay_off = {$name}: {$size} von {$point} aus abgetragen, {$direction}
board-like = {$name} auf {$ends} wie im Dreieck {$points}
board-mark = {$name} nach Augenmaß markiert
board-measure = {$name} von {$one} nach {$two} gemessen
board-compute = {$name} = {$formula}
board-typed = {$name} = {$number}, eingetippt
board-solve = {$names} aus Gleichungen
board-undo = {$count ->
    [one] der letzte Eintrag zurückgenommen
   *[other] die letzten {$count} Einträge zurückgenommen
}
board-parallel = parallel zu {$to}
board-normal = senkrecht zu {$to}
board-turned = an {$base} unter dem Winkel von {$from} nach {$to}
board-angle = unter {$degrees}°
board-link = Glied {$name}
board-guide = Führung {$name}
board-load = Kraft {$name}
board-drawn_line = Linie {$name}
board-ccw = gegen den Uhrzeigersinn
board-cw = im Uhrzeigersinn
board-right = richtig
board-wrong = falsch
board-follows = folgt daraus
board-unused = ungenutzt
board-undone = zurückgenommen
board-all_right = Jeder Schritt ist richtig.
board-right_so_far = Bis hierher ist jeder Schritt richtig.
board-asked_missing = Noch verlangt: {$names}.
board-asked_missing_many = Noch verlangt: {$names} und {$more} weitere.
board-nothing_drawn = Noch ist nichts gezeichnet.
board-first_wrong = Der erste falsche Schritt ist Nummer {$number}.
board-should = Richtig wäre: {$what}
board-no_sheet = die Szene hat keinen solchen Plan
board-free_hand = Freie Hand: ±{$mm} mm und ±{$degrees}° gelten als richtig
board-all_there = Es ist alles da.
board-next_line = Als Nächstes kommt eine Linie: {$sheet}.
board-next_point = Als Nächstes kommt {$name}: {$sheet}.
board-next_number = Als Nächstes kommt {$name}.

## The workbench: layout

page-layout-described = Das Bild in Worten
page-layout-notices = Was andere gemacht haben, und seine Lizenzen
page-layout-back_to_picture = Zurück zum Bild
page-layout-is_fixed = Feste Punkte: {$points}.
page-layout-is_link = Glied {$name}: {$points}
page-layout-is_driven = angetrieben, bei {$place}
page-layout-is_slider = Gleitstein {$name} gleitet auf {$on}.
page-layout-is_pin = Bolzen {$name} gleitet in einem Schlitz von {$on}.
page-layout-is_ground = dem Gestell
page-layout-is_through = Die Führung geht durch {$place}.
page-layout-is_known = Bekannte Bewegungen: {$points}.
page-layout-means_pole_v = {$name}, der Pol: Hier beginnen alle Geschwindigkeiten, und was ruht, hat hier sein Bild.
page-layout-means_pole_a = {$name}, der Pol: Hier beginnen alle Beschleunigungen, und was keine hat, hat hier sein Bild.
page-layout-means_image_v = {$name}, das Bild von {$point}: Der Pfeil vom Pol bis hierher ist die Geschwindigkeit von {$point}.
page-layout-means_image_a = {$name}, das Bild von {$point}: Der Pfeil vom Pol bis hierher ist die Beschleunigung von {$point}.
page-layout-means_special = {$name}, der Sonderpunkt von Glied {$link}: der Schnittpunkt seiner Geraden. Er gibt dem Plan das nächste Bild.
page-layout-means_special_image = {$name}, das Bild des Sonderpunkts von Glied {$link}.
page-layout-means_under = {$name}, das Bild des Punktes von Glied {$link}, der gerade unter {$point} liegt.
page-layout-means_normal = {$name}, das Ende eines Normalanteils ω²·l. Hier beginnt der Tangentialanteil.
page-layout-means_coriolis = {$name}, das Ende eines Coriolisanteils 2·ω·v.
page-layout-means_sliding = {$name}, das Ende eines Anteils längs einer Führung.
page-layout-means_omega = {$name}, die Winkelgeschwindigkeit von Glied {$link}.
page-layout-means_alpha = {$name}, die Winkelbeschleunigung von Glied {$link}.
page-layout-tour = Kurzer Rundgang
page-layout-tour_pull = Ziehen Sie an einem Gelenk: Der Mechanismus bewegt sich, und die Pläne seiner Geschwindigkeiten und Beschleunigungen folgen maßstäblich.
page-layout-tour_steps = „Schritte“ zeigt, wie die Pläne von Hand gezeichnet werden, Linie für Linie.
page-layout-tour_own = „Mechanismus“ hat jede Zahl zum Eintippen und andere Mechanismen als Anfang. Die übrigen Bereiche zeichnen, prüfen und sichern.
page-layout-tour_next = Weiter
page-layout-tour_leave = Ende
page-layout-tour_done = Los
page-layout-skips = Sprungmarken
page-layout-skip_picture = Zum Bild
page-layout-skip_panels = Zu den Bereichen
page-layout-skip_motion = Zur Bewegung
page-layout-toolbar = Szene und Werkzeuge
page-layout-picture = Bild
page-layout-panels = Bereiche
page-layout-untitled = Szene
page-layout-documents = Szenen und Dateien
page-layout-open_file = Szene oder Formular öffnen…
page-layout-lesson = Die Szene dieser Datei
page-layout-recent = Früher bearbeitet
page-layout-forget = Liste leeren
page-layout-undo = Rückgängig (Strg+Z)
page-layout-redo = Wiederholen (Strg+Y)
page-layout-undone = Rückgängig gemacht.
page-layout-redone = Wiederholt.
page-layout-hand = Was Ziehen am Gelenk bewirkt
page-layout-move = Bewegen
page-layout-move_long = Bewegen: Ziehen an einem Gelenk bewegt den Mechanismus
page-layout-shape = Formen
page-layout-shape_long = Formen: Ziehen an einem Gelenk ändert Längen
page-layout-build = Bauen
page-layout-build_long = Bauen: einen Mechanismus zusammenstellen, vollständig oder nicht
page-layout-zoom = Zoom
page-layout-all = Alle
page-layout-zoom_in = Größer (+)
page-layout-zoom_out = Kleiner (−)
page-layout-fit = Einpassen (0)
page-layout-motion = Bewegung
page-layout-play = Abspielen (Leertaste)
page-layout-play_together = Abspielen (Leertaste): Alle Antriebe laufen zusammen, im Verhältnis ihrer Geschwindigkeiten
page-layout-together = Alle Antriebe laufen zusammen, im Verhältnis ihrer Geschwindigkeiten. Ein Regler bewegt einen allein.
page-layout-stuck = Der Antrieb kann sich von seinem jetzigen Ort aus nicht bewegen.
page-layout-pause = Pause (Leertaste)
page-layout-speed = Tempo
page-layout-link = Glied {$name}
page-layout-slider = Schieber {$name}
page-layout-drive_at = {$name} steht bei
page-layout-drive_unread = „{$typed}“ ist hier keine Zahl. Tippen Sie eine, gern mit Einheit: 60°, 0,5 rad, 12 cm.
page-layout-steps = Schritte
page-layout-steps_long = Schritte der Konstruktion
page-layout-first = Erster Schritt (Pos1)
page-layout-back = Schritt zurück (←)
page-layout-forward = Schritt vor (→)
page-layout-last = Fertiges Bild (Ende)
page-layout-step = Schritt
page-layout-step_of = Schritt {$number} von {$count}
page-layout-finished = Fertiges Bild, Schritte: {$count}
page-layout-coarse = Große Schritte
page-layout-language = Sprache
page-layout-full = Vollbild (p)
page-layout-leave_full = Vollbild verlassen (Esc)
page-layout-dark = Dunkel oder hell (d)
page-layout-help = Hilfe (?)
page-layout-help_title = Was ist das, und wie weiter?
page-layout-way_new = Noch nie einen Plan gesehen?
page-layout-way_new_how = Jeder Pfeil vom Pol aus ist die Geschwindigkeit (oder die Beschleunigung) eines Punktes, maßstäblich: doppelt so lang ist doppelt so schnell. Ziehen Sie an einem Gelenk und beobachten Sie die Pfeile. Verweilen Sie auf einem Buchstaben oder tippen Sie ihn an, um zu lesen, was er bedeutet. Die Zahlen stehen unter „Werte“, ihr Verlauf über eine Umdrehung unter „Kurven“.
page-layout-way_lecture = Ein Bild für die Vorlesung
page-layout-way_lecture_how = Wählen Sie einen Mechanismus, der Ihrem ähnlich ist, und tippen Sie Ihre Zahlen ein, oder stellen Sie ihn mit „Bauen“ zusammen. „Bild“ wählt das Blatt, seine Sprache und seinen Stil. „Schritte“ zeichnet die Pläne Linie für Linie; P füllt den Bildschirm. „Sichern“ hat PDF, SVG, TikZ, einen Film und einen Link für Studierende.
page-layout-way_student = Eine Aufgabe
page-layout-way_student_how = Zeichnen Sie beide Pläne auf Papier in den gegebenen Maßstäben, messen Sie und tippen Sie das Gemessene unter „Prüfen“ ein, oder fotografieren Sie Ihr Blatt. Genannt wird der Schritt, in dem etwas falsch wurde.
page-layout-way_go = {$panel} öffnen
page-layout-letters = Buchstaben in den Plänen (übliche Schreibweise)
page-layout-letter_poles = Pole: von p aus beginnen alle Geschwindigkeiten, von π aus alle Beschleunigungen
page-layout-letter_images = Bilder der Punkte B, C: Der Pfeil vom Pol bis b ist die Geschwindigkeit von B (im anderen Plan seine Beschleunigung)
page-layout-letter_normal = Ende eines Normalanteils ω²·l; dort beginnt der Tangentialanteil
page-layout-letter_coriolis = Ende eines Coriolisanteils 2·ω·v
page-layout-letter_special = Sonderpunkte von Gruppen dritter und vierter Klasse und ihre Bilder
page-layout-letter_scale = Maßstäbe: eine Länge in mm auf dem Blatt mal μ ist der Wert
page-layout-more = Mehr
page-layout-keys = Tasten
page-layout-keys_letters = Buchstaben wirken als Tasten
page-layout-close = Schließen
page-layout-key_steps = Schritt zurück, Schritt vor
page-layout-key_ends = erster Schritt, fertiges Bild
page-layout-key_drive = Antrieb um 1° drehen (mit Umschalt 0,1°)
page-layout-key_play = abspielen, Pause
page-layout-key_panels = Lageplan, Geschwindigkeiten, Beschleunigungen, alle
page-layout-key_zoom = größer, kleiner, einpassen
page-layout-key_hand = bewegen, formen, bauen
page-layout-key_full = Vollbild
page-layout-key_dark = dunkel, hell
page-layout-key_undo = rückgängig, wiederholen
page-layout-key_joint = auf einem Gelenk: um 1 mm des Blattes verschieben (mit Umschalt 0,1 mm)
page-layout-key_escape = Gezogenes zurücklegen; aus einem Bereich zu seinem Reiter
page-layout-joint = Gelenk {$name}
page-layout-fixed_joint = Fester Punkt {$name}
page-layout-joint_hint = Pfeiltasten verschieben es, mit Umschalt feiner. Esc legt es zurück.
page-layout-mend_first = Die Szene hat einen Fehler. Beheben Sie ihn, bevor Sie etwas bewegen.
page-layout-no_picture = Noch gibt es kein Bild. Die Meldung oben sagt, warum.
page-layout-to_text = Im Text zeigen
page-layout-go_on = Weiterbauen
page-layout-warning = 1 Warnung
page-layout-warnings = {$count} Warnungen
page-layout-busy = Rechnet…
page-layout-put_back = Zurückgelegt.
page-layout-stop = Stopp
page-layout-stopped = Angehalten. Die Szene ist unverändert.
page-layout-too_slow = Dies dauerte länger als {$seconds} s und wurde angehalten. Die Szene ist unverändert.
page-layout-fell = Das Rechenwerk hielt unerwartet an und wurde neu gestartet. Die Szene ist unverändert.
page-layout-link_broken = Der Link ist beschädigt oder abgeschnitten, es ließ sich keine Szene daraus lesen. Was vorher hier war, ist geblieben.
page-layout-link_newer = Der Link stammt von einer neueren Version von Kinegon. Bitten Sie um die Szene als Datei, oder öffnen Sie den Link mit jener Version.
page-layout-link_too_large = Der Link enthält mehr Text, als eine Szene haben darf, und wurde nicht gelesen.
page-layout-file_too_large = Die Datei „{$name}“ hat mehr als 4 MB, mehr als eine Szene oder ein Formular haben darf.
page-layout-unread_file = Die Datei „{$name}“ lässt sich nicht lesen.
page-layout-forms_first = Von den {$count} Formularen ist nur „{$name}“ offen: Die Seite nimmt eines auf einmal. Für eine ganze Klasse legen Sie die Formulare in einen Ordner und rufen auf: kinegon check scene.json forms/
page-layout-forms_left = Die Zeichnungen sind am Zeichenbrett; die Formulare unter den Dateien blieben weg. Für eine ganze Klasse legen Sie die Formulare in einen Ordner und rufen auf: kinegon check scene.json forms/
page-layout-files_first = Von den {$count} Dateien ist nur „{$name}“ offen: Die Seite nimmt eine auf einmal.
page-layout-opened_file = „{$name}“ ist geöffnet. „Rückgängig“ holt zurück, was da war.
page-layout-exam_open = In einer Prüfung lässt sich nur eine eigene Zeichnung öffnen.
page-layout-no_storage = Dieser Browser merkt sich nichts für diese Seite. Sichern Sie die Szene als Datei, bevor Sie sie schließen.
page-layout-restored = Ihre letzte Szene ist wieder da.
page-layout-course_deaf = Der Kurs nimmt die Bewertung gerade nicht an. Was Sie schreiben, bleibt auf dieser Seite; sichern Sie das Formular auch im Bereich „Prüfen“, damit Sie es auf anderem Weg abgeben können.
page-layout-course_again = Neu senden
page-layout-course_hears = Der Kurs hat die Bewertung jetzt.
page-layout-worked_before = Dies ist die Szene der Datei. Sie haben schon an ihr gearbeitet: „{$title}“, {$when}.
page-layout-take_up = Damit fortfahren
page-layout-as_paper = Blatt
page-layout-as_paper_long = Blatt: wie gesichert und gedruckt, mit seinen Maßstäben. Sonst füllt das Bild den Bildschirm, mit dessen eigenen Maßstäben.
page-layout-below = Kurven
page-layout-splitter = Breite des Bereichs
page-layout-start_failed = Kinegon konnte nicht starten: {$why}. Nötig ist ein Browser von 2023 oder später.


## The workbench: build

page-build-stage = Bauen, Punkte: {$count}
page-build-tools = Werkzeuge
page-build-tool_select = Wählen
page-build-tool_link = Glied
page-build-tool_third = Punkt am Glied
page-build-tool_fixed = Festpunkt
page-build-tool_slider = Schieber
page-build-tool_cylinder = Zylinder
page-build-tool_drive = Antrieb
page-build-tool_drop = Löschen
page-build-tool_load = Last
page-build-hint_select = Ziehen Sie einen Punkt oder ein Glied, um es zu verschieben. Ein Klick zeigt die Zahlen, mit zweien tippen Sie sie ein. Umschalt fügt zur Auswahl hinzu.
page-build-hint_link = Ziehen Sie von Gelenk zu Gelenk, oder von einem leeren Ort zu einem anderen.
page-build-hint_third = Ziehen Sie von einem Glied dorthin, wo sein weiterer Punkt liegen soll.
page-build-hint_fixed = Klicken Sie einen Punkt an, um ihn zu fixieren oder zu lösen; ein leerer Ort erhält einen neuen.
page-build-hint_slider = Ziehen Sie von dem Punkt, der gleitet: auf ein Glied, das ihn führt, oder in Richtung einer Führung am Gestell.
page-build-hint_cylinder = Ziehen Sie von Gelenk zu Gelenk: ein Zylinder und seine Kolbenstange, die ein Antrieb auseinanderschiebt.
page-build-hint_drive = Klicken Sie ein Glied mit festem Punkt oder einen Gleitstein an: Es wird angetrieben, oder nicht mehr.
page-build-hint_drop = Klicken Sie einen Punkt oder ein Glied an, um es zu löschen.
page-build-hint_load = Ziehen Sie vom Glied dorthin, wohin die Kraft zeigt: ein Schritt des Gitters sind 10 Einheiten. Tippen legt ein Moment auf das Glied. Die Spitze eines Pfeils ändert seine Kraft, sein Schaft verschiebt ihn; am Bogen gezogen, ändert sich das Moment.
page-build-second = Nun das andere Ende.
page-build-key = Taste {$key}
page-build-what_slides = Was gleitet
page-build-slides_block = Gleitstein am Bolzen
page-build-slides_itself = Das Glied selbst
page-build-slides_pin = Bolzen im Schlitz
page-build-on_link = Führung am Glied
page-build-guided_along = Längs des Gliedes
page-build-guided_across = Quer dazu
page-build-snap = Raster
page-build-fit = Ganz
page-build-smaller = Kleiner
page-build-larger = Größer
page-build-photo = Foto…
page-build-photo_scale = Maßstab
page-build-photo_away = Ohne Foto
page-build-photo_two = Klicken Sie zwei Orte im Foto an, deren Abstand Sie kennen, und tippen Sie ihn ein.
page-build-photo_length = Abstand der beiden
page-build-photo_number = Tippen Sie ihn als Zahl in {$unit} ein, etwa 120.
page-build-photo_unread = Diese Datei ist kein Bild, das der Browser zeigen kann.
page-build-begin = Noch nichts da. Ziehen Sie ein erstes Glied.
page-build-complete = Vollständig. „Bewegen“ (m) bewegt ihn.
page-build-incomplete = Noch nicht vollständig: {$why}
page-build-wants_ground = Noch nicht vollständig: Nichts steht fest. Fixieren Sie Punkte, oder geben Sie eine Führung am Gestell an.
page-build-wants_one = Noch nicht vollständig: Eine Bewegung ist frei. Es fehlt ein Antrieb, oder ein Glied oder fester Punkt mehr.
page-build-wants_more = Noch nicht vollständig: {$count} Bewegungen sind frei. Es fehlen Gelenke, feste Punkte oder Antriebe.
page-build-too_held = Noch nicht vollständig: zu viele Gelenke, feste Punkte oder Antriebe, Überzahl {$count}.
page-build-mobility = (3·{$links} − {$taken} = {$free}, Antriebe: {$drives})
page-build-needs_point = Beginnen Sie an einem vorhandenen Punkt.
page-build-needs_link = Beginnen Sie an einem Glied.
page-build-needs_pivot = Ein Antrieb dreht ein Glied mit festem Punkt oder schiebt einen Gleitstein auf seiner Führung: Dieses Glied hat keines davon.
page-build-needs_way = Ziehen Sie etwas weiter: Beide Enden liegen am selben Ort.
page-build-joined_already = Ein Glied hat diese beiden Punkte schon.
page-build-at_link = Glied {$name}
page-build-at_load = Last {$name}
page-build-taken_up = Aufgenommen: Pfeiltasten verschieben, die Eingabetaste legt ab.
page-build-put_down = Abgelegt.
page-build-put_back = Zurückgelegt.
page-build-removed = Gelöscht.
page-build-copied = Punkte kopiert: {$count}.
page-build-numbers = Zahlen
page-build-rename = Name
page-build-fix_it = Fixieren
page-build-free_it = Lösen
page-build-drive_it = Antrieb ein/aus
page-build-copy = Kopieren
page-build-paste = Einfügen
page-build-remove = Löschen


## The workbench: mechanism

page-mechanism-panel_title = Mechanismus
page-mechanism-about = Allgemein
page-mechanism-title = Titel
page-mechanism-untitled = Ohne Titel
page-mechanism-length_unit = Längen in
page-mechanism-time_unit = Zeiten in
page-mechanism-ground = Feste Punkte
page-mechanism-ground_help = Drehpunkte am Gestell. x nach rechts, y nach oben.
page-mechanism-fixed_point = Fester Punkt
page-mechanism-add_fixed = Fester Punkt
page-mechanism-no_longer_there = Punkt {$name} entfernen
page-mechanism-links = Glieder
page-mechanism-links_help = Ein Punkt in zwei Gliedern ist ein Drehgelenk zwischen ihnen.
page-mechanism-link = Glied
page-mechanism-link_name = Name von Glied {$name}
page-mechanism-add_link = Glied
page-mechanism-from = Von Punkt
page-mechanism-to = Bis Punkt
page-mechanism-new_point = neu: {$name}
page-mechanism-points = Punkte
page-mechanism-point_name = Name von Punkt {$name}
page-mechanism-drop_link = Glied {$name} entfernen
page-mechanism-take_off = {$name} vom Glied nehmen
page-mechanism-add_point = Punkt
page-mechanism-places_on_link = Orte auf dem Glied selbst; x läuft längs des Gliedes
page-mechanism-give_place = y
page-mechanism-drive_it = Glied antreiben
page-mechanism-drop_drive = Antrieb von {$name} entfernen
page-mechanism-drive = Antrieb
page-mechanism-angle = Winkel
page-mechanism-speed = Geschw.
page-mechanism-turns = Einheit
page-mechanism-acceleration = Beschleunigung
page-mechanism-position = Position
page-mechanism-axis_angle = Winkel seiner Achse
page-mechanism-block = Stein
page-mechanism-unsized = Vier oder mehr Punkte brauchen eine Form: Nehmen Sie Punkte weg und fügen Sie sie wieder hinzu.
page-mechanism-moves_as_known = bekannte Bewegung
page-mechanism-sliders = Schieber
page-mechanism-sliders_help = Gleitsteine auf geraden Führungen und Bolzen in Schlitzen.
page-mechanism-slides_on = {$point} auf {$on}
page-mechanism-pin_in_slot = Bolzen im Schlitz
page-mechanism-what_slides = Was gleitet
page-mechanism-sliding_link = Stein
page-mechanism-at = in
page-mechanism-pin = Bolzen
page-mechanism-on = Gleitet auf
page-mechanism-ground_word = Gestell
page-mechanism-through = Führung durch
page-mechanism-through_usual = eigenen Punkt
page-mechanism-through_place = Ort x, y
page-mechanism-offset = y (Versatz)
page-mechanism-along = Führung längs
page-mechanism-along_usual = der Achse
page-mechanism-along_degrees = Winkel
page-mechanism-along_direction = Richtung x, y
page-mechanism-degrees = Winkel
page-mechanism-turned = Gedreht um
page-mechanism-drop_slider = Schieber {$name} entfernen
page-mechanism-add_slider = Schieber
page-mechanism-new_block = neuer Stein in {$name}
page-mechanism-link_at = Glied {$link} in {$name}
page-mechanism-pin_at = Bolzen {$name} im Schlitz
page-mechanism-rolling = Räder, Riemen und Kurvenscheiben
page-mechanism-rolling_help = Zwei Räder, die aufeinander rollen, ein Rad auf einer Zahnstange, Räder mit einem Riemen; zwei Profile, die sich berühren, mit Krümmungsmittelpunkten und Krümmungsradien.
page-mechanism-add_gear = Räderpaar
page-mechanism-wheel = Rad
page-mechanism-runs_on = Läuft auf
page-mechanism-new_wheel = neuem Rad
page-mechanism-new_rack = neuer Zahnstange
page-mechanism-pair_of = {$first} mit {$second}
page-mechanism-carried_by = auf {$name}
page-mechanism-first_wheel = Erstes
page-mechanism-second_wheel = Zweites
page-mechanism-carrier = Träger
page-mechanism-teeth_of = Zähnezahl von {$name}
page-mechanism-pitch_radius = Teilkreisradius
page-mechanism-touch = Eingriff
page-mechanism-touch_outside = Zähne außen
page-mechanism-touch_ring_first = das erste ist ein Hohlrad
page-mechanism-touch_ring_second = das zweite ist ein Hohlrad
page-mechanism-touch_rack_first = das erste ist eine Zahnstange
page-mechanism-touch_rack_second = das zweite ist eine Zahnstange
page-mechanism-touch_open = offener Riemen
page-mechanism-touch_crossed = gekreuzter Riemen
page-mechanism-rack_at_zero = Lage, wenn das Rad auf 0 steht
page-mechanism-second_at_zero = Zweites Rad, wenn das erste auf 0 steht
page-mechanism-pressure = Eingriffswinkel
page-mechanism-add_contact = Berührung
page-mechanism-first_center = Krümmungsmittelpunkt des ersten
page-mechanism-second_center = Krümmungsmittelpunkt des zweiten
page-mechanism-contact_of = {$first} an {$second}
page-mechanism-first_profile = Erstes
page-mechanism-second_profile = Zweites
page-mechanism-center_at = Krümmungsmittelpunkt
page-mechanism-radius_of = Krümmungsradius von {$name}
page-mechanism-add_radii = Radien
page-mechanism-second_is = Das zweite ist
page-mechanism-profile_round = rund
page-mechanism-profile_roller = eine Rolle
page-mechanism-profile_flat = eben
page-mechanism-circular = Kreise in jeder Stellung
page-mechanism-equivalent = Ersatzglied
page-mechanism-face_through = Fläche durch
page-mechanism-face_along = Fläche längs
page-mechanism-travel = Enden des Schlitzes
page-mechanism-travel_from = von
page-mechanism-travel_to = bis
page-mechanism-drop_travel = Enden von Schieber {$name} entfernen
page-mechanism-loads = Massen und Kräfte
page-mechanism-loads_help = Daraus folgt, was Gelenke tragen und Antriebe brauchen. Lasten sind neben dem Kräfteplan eingezeichnet.
page-mechanism-add_force = Kraft
page-mechanism-add_couple = Moment
page-mechanism-add_mass = Masse
page-mechanism-add_spring = Feder
page-mechanism-add_friction = Reibung
page-mechanism-pin_of = Zapfen {$name}
page-mechanism-guide_of = Führung {$name}
page-mechanism-friction_of = Reibung: {$name}
page-mechanism-coefficient = Reibungszahl
page-mechanism-friction_angle = Reibungswinkel
page-mechanism-journal = Radius des Zapfens
page-mechanism-joint = Gelenk
page-mechanism-acts_at = Wirkt an
page-mechanism-acts_on = Wirkt auf
page-mechanism-gravity = Schwerkraft
page-mechanism-drop_gravity = Schwerkraft entfernen
page-mechanism-analysis = Trägheit
page-mechanism-with_inertia = zählt
page-mechanism-without_inertia = bleibt weg
page-mechanism-mass_unit = Massen in
page-mechanism-force_unit = Kräfte in
page-mechanism-mass = Masse
page-mechanism-weight = Gewicht
page-mechanism-inertia = Massenträgheitsmoment um den Schwerpunkt
page-mechanism-mass_of = Masse von {$name}
page-mechanism-center = Schwerpunkt
page-mechanism-drop_mass = Masse von Glied {$name} entfernen
page-mechanism-on_axis = x längs des Gliedes
page-mechanism-load_name = Name
page-mechanism-force = Kraft
page-mechanism-couple = Moment
page-mechanism-turns_with_link = dreht sich mit dem Glied
page-mechanism-changes_over = Ändert sich mit
page-mechanism-add_over = Über der Bewegung
page-mechanism-table_lines = Ort und Faktor, je eine Zeile
page-mechanism-position_of = Lage von {$name}
page-mechanism-drop_over = Tabelle von {$name} entfernen
page-mechanism-drop_load = {$name} entfernen
page-mechanism-rate = Kraft je Länge
page-mechanism-free_length = Länge ohne Kraft
page-mechanism-near = Einbaulage
page-mechanism-near_help = Ungefähre Orte von Punkten oder Winkel von Gliedern. Kinegon nimmt die nächste Einbaulage.
page-mechanism-add_near = Ungefährer Ort
page-mechanism-angle_of = Winkel von {$name}
page-mechanism-drop_near = Ungefähren Ort von {$name} entfernen
page-mechanism-drawn_points = Punkte der Zeichnung
page-mechanism-drawn_help = Diese Szene ist gezeichnet: Sie gibt Koordinaten statt Längen an und lässt sich nicht bewegen.
page-mechanism-fixed = Fest
page-mechanism-known = Bekannte Bewegungen
page-mechanism-known_help = Punkte, deren Geschwindigkeit und Beschleunigung bekannt sind.
page-mechanism-add_known = Bekannte Bewegung
page-mechanism-drop_known = Bekannte Bewegung von {$name} entfernen
page-mechanism-velocity = Geschwindigkeit
page-mechanism-by_parts = als x, y
page-mechanism-by_size = als Betrag, Winkel
page-mechanism-size = Betrag
page-mechanism-known_motion = Bewegung bekannt
page-mechanism-drop_motion = Bekannte Bewegung von Glied {$name} entfernen
page-mechanism-add_acceleration = Beschleunigung
page-mechanism-drop_acceleration = Beschleunigung entfernen
page-mechanism-stub = Stummel
page-mechanism-moving = bewegt
page-mechanism-change_kind = Andere Mechanismen
page-mechanism-empty = Neu, leer
page-mechanism-open_file = Öffnen…
page-mechanism-groups_bars = Eine Schleife
page-mechanism-groups_more = Sechs Glieder
page-mechanism-groups_drives = Mehrere Antriebe
page-mechanism-groups_wheels = Räder und Kurven
page-mechanism-groups_class = Dritte und vierte Klasse
page-mechanism-groups_drawn = Gruppen wie im Lehrbuch
page-mechanism-groups_paper = Aus dem Artikel


## The workbench: curves

page-curves-panel_title = Kurven
page-curves-what = Was gezeichnet wird
page-curves-curves = Kurven
page-curves-hodograph = Hodographen
page-curves-path = Bahnen
page-curves-choose = Wählen
page-curves-clear = Keine
page-curves-beyond = Auch jenseits der Grenzen des Antriebs, gestrichelt
page-curves-none = Wählen Sie mindestens eine.
page-curves-drawn = Diese Szene gibt ihre Punkte an, wie sie gezeichnet sind. Sie lässt sich nicht bewegen, über einen Zyklus gibt es also nichts.
page-curves-waits = Zeichnet …
page-curves-save = Als {$format} sichern
page-curves-table = Tabelle als CSV
page-curves-events = Besondere Lagen
page-curves-no_events = Keine in diesem Bereich.


## The workbench: figure

page-figure-language_name = Deutsch
page-figure-panel_title = Bild
page-figure-shown = Was gezeigt wird
page-figure-panels = Felder
page-figure-focus = Groß
page-figure-none = Alle gleich
page-figure-scales = Maßstäbe
page-figure-scales_help = Für das Blatt, das gesichert und gedruckt wird („Blatt“ zeigt es); auf dem Bildschirm gelten dessen eigene Maßstäbe. Leer: der nächste runde Maßstab, der passt.
page-figure-automatic = automatisch
page-figure-take = Den jetzigen Maßstab {$value} behalten
page-figure-as_before = Wieder automatisch
page-figure-scales_for = Automatische passen für
page-figure-position = diese Stellung
page-figure-sheet = jedes Blatt für sich
page-figure-cycle = den ganzen Zyklus
page-figure-look = Aussehen
page-figure-style = Stil
page-figure-paper = Artikel
page-figure-print = Druck
page-figure-lecture = Vorlesung
page-figure-board = Tafel
page-figure-notation = Notation
page-figure-n_paper = Artikel
page-figure-english = Englisch
page-figure-russian = Russisch
page-figure-german = Deutsch
page-figure-sliding = An Führungen
page-figure-coriolis = Coriolis-Index
page-figure-as_notation = wie die Notation
page-figure-frame = Gestell
page-figure-word = als Wort
page-figure-turned = Geschwindigkeiten
page-figure-not_turned = wie sie sind
page-figure-turned_by = um {$angle}° gedreht
page-figure-language = Sprache
page-figure-decimal = Dezimalen
page-figure-point = 2.5
page-figure-comma = 2,5
page-figure-page = Blatt
page-figure-page_size = Größe
page-figure-landscape = Querformat
page-figure-portrait = Hochformat
page-figure-direction = Ausrichtung
page-figure-worksheet = Arbeitsblatt mit Tabelle und Lineal
page-figure-yes = Ja
page-figure-no = Nein
page-figure-contents = Im Bild
page-figure-values = Werte
page-figure-usual = wie im Stil
page-figure-with_unit = Längen in {$unit}
page-figure-construction = Konstruktion
page-figure-whole = Ganz
page-figure-as_paper = Wie im Artikel
page-figure-hidden = Keine
page-figure-special = Sonderpunkte
page-figure-paths = Bahnen und Stellungen
page-figure-trace = Bahnen von Punkten über den Zyklus
page-figure-no_trace = Dieser Mechanismus hat keinen Zyklus, dessen Bahnen zu zeichnen wären.
page-figure-beyond = Bahnen auch jenseits der Grenzen
page-figure-ghosts = Blasse Stellungen der Glieder
page-figure-ghosts_unit = je Zyklus
page-figure-centers = Momentanpole
page-figure-centers_help = Das Feld der Momentanpole wird unter „Was gezeigt wird“ gewählt.
page-figure-wanted_centers = Pole
page-figure-usual_centers = die üblichen
page-figure-all_centers = alle
page-figure-these_centers = diese
page-figure-velocities = Geschwindigkeiten über Pole
page-figure-curvature = Krümmung der Bahnen von Punkten
page-figure-centrodes = Polbahnen von Gliedern, im Lageplan
page-figure-inflection = Wendekreise von Gliedern, im Lageplan
page-figure-labels = Andere Buchstaben
page-figure-labels_help = Stehen anstelle eines Namens. B_1 schreibt einen Index.
page-figure-label_of = Text für {$name}
page-figure-drop_label = Wieder den Namen {$name} zeigen
page-figure-projector = Beamer 16:9
page-figure-own_name = Ersetzter Name
page-figure-add_label = Text


## The workbench: text

page-text-panel_title = Text
page-text-editor = Text der Szene
page-text-good = Der Text ist eine vollständige Szene.
page-text-go = Dorthin
page-text-long = Dieser Text steht in einer Zeile, die zu lang ist, um gezeigt zu werden.
page-text-lay_out = In Zeilen gliedern
page-text-help = Dieser Text ist das ganze Dokument: eine Szenendatei des Programms. Strg+Leertaste bietet Schlüssel an, Strg+F sucht, Esc und dann Tab führt hinaus.


## The workbench: exercise

page-exercise-panel_title = Aufgabe
page-exercise-intro = Ein Mechanismus mit anderen runden Zahlen, so gewählt, dass er sich gut von Hand zeichnen lässt. Derselbe Startwert gibt dieselben Aufgaben, hier und mit kinegon exercise.
page-exercise-kind = Mechanismus
page-exercise-own = Die offene Szene: {$title}
page-exercise-seed = Startwert
page-exercise-number = Nummer
page-exercise-page = Format
page-exercise-page_auto = A4, oder A3, wo nötig
page-exercise-page_name = {$size} {$way}
page-exercise-landscape = quer
page-exercise-portrait = hoch
page-exercise-back = Vorige Aufgabe
page-exercise-forward = Nächste Aufgabe
page-exercise-large = Große Ansicht
page-exercise-small = Zurück zum Bild
page-exercise-making = Sucht eine Aufgabe…
page-exercise-student = Für die Studierenden
page-exercise-print = Drucken mit 100 %
page-exercise-print_hint = Wählen Sie im Druckfenster 100 % oder tatsächliche Größe, nie „an Seite anpassen“. Das Lineal auf dem Blatt zeigt, ob es stimmt.
page-exercise-link = Link für Studierende
page-exercise-allow_steps = Mit den Schritten der Konstruktion, in Worten
page-exercise-allow_more = Mit den nächsten Aufgaben dieses Startwerts
page-exercise-link_hint = Er hat das Blatt zum Drucken, das Formular, das Foto und dessen Prüfung, auch auf einem Telefon. Er öffnet den Mechanismus ohne seine Pläne, mit dem Formular daneben. Wer will, kann die Lösung trotzdem aus der Szene ermitteln: Für eine Note sammeln Sie die Formulare ein.
page-exercise-sheet = Blatt
page-exercise-form = Formular
page-exercise-scene = Szene
page-exercise-teacher = Für Lehrende
page-exercise-show_key = Lösung zeigen
page-exercise-print_key = Lösung drucken
page-exercise-key = Lösung
page-exercise-key_values = Werte
page-exercise-open = Auf der Werkbank öffnen
page-exercise-opened = Die Aufgabe {$name} ist offen; „Rückgängig“ holt die vorige Szene zurück.
page-exercise-sheet_of = Blatt der Aufgabe {$name}
page-exercise-key_of = Lösung der Aufgabe {$name}
page-exercise-board_paper = Pläne werden auf Papier gezeichnet
page-exercise-board_practice = Am Zeichenbrett: Übung
page-exercise-board_at_once = Am Zeichenbrett: Falsches wird sofort gesagt
page-exercise-board_exam = Am Zeichenbrett: Prüfung, nichts wird gesagt
page-exercise-board_demonstration = Am Zeichenbrett: zusehen, wie gezeichnet wird
page-exercise-board_snap = Womit der Hand geholfen wird
page-exercise-board_snap_all = Punkte und Geraden rasten ein
page-exercise-board_snap_points = Nur Punkte rasten ein
page-exercise-board_snap_none = Freihand


## The workbench: values

page-values-panel_title = Werte
page-values-find = Größe suchen
page-values-digits = Ziffern
page-values-certain = alle sicheren Ziffern
page-values-few = {$count} Ziffern
page-values-copy = Kopieren
page-values-save = CSV
page-values-copied = Die Tabelle ist in der Zwischenablage.
page-values-not_copied = Dieser Browser lässt die Seite nicht in die Zwischenablage schreiben. Sichern Sie die Tabelle als CSV.
page-values-quantity = Größe
page-values-value = Wert
page-values-unit = Einheit
page-values-error = ±
page-values-count = {$count} von {$all} Größen
page-values-none = Keine Größe hat dies in ihrem Namen.
page-values-about = Jede gezeigte Ziffer ist sicher; ± sagt, wie weit der Wert vom wahren Wert der Szene entfernt sein kann.
page-values-about_few = Gerundet. „Alle sicheren Ziffern“ zeigt jede sichere Ziffer und wie weit der Wert vom wahren Wert der Szene entfernt sein kann.
page-values-groups = Assur-Gruppen
page-values-warnings = Warnungen


## The workbench: modes

page-modes-panel_title = Lagen
page-modes-ghosts = Die anderen blass im Bild zeigen
page-modes-single = Der Mechanismus lässt sich nur auf eine Art zusammensetzen.
page-modes-drawn = Diese Szene gibt ihre Punkte an, wie sie gezeichnet sind. Sie lassen sich nur auf diese Art zusammensetzen.
page-modes-count = Mit diesen Längen und dieser Stellung des Antriebs gibt es {$count} Einbaulagen. Die Szene behält die, die Sie wählen.
page-modes-mode = Lage {$number}
page-modes-chosen = Lage {$number} ist gewählt.
page-modes-list = Einbaulagen


## The workbench: parts

page-parts-needed = Hier wird eine Zahl gebraucht.
page-parts-unread = Keine Zahl. Tippen Sie 60, 2,5, 1/3, 2*pi oder sqrt(2), gern mit einer Einheit: 15 cm.
page-parts-other_unit = {$unit} lässt sich nicht in {$own} umrechnen.
page-parts-least = Mindestens {$least}.
page-parts-nameless = Ein Name wird gebraucht.
page-parts-pin_point = {$name} beim Formen festhalten
page-parts-pin_length = Länge {$name} beim Formen festhalten
page-parts-unreadable = Der Text der Szene hat einen Fehler, darum wartet das Formular. Beheben Sie ihn im Text, oder machen Sie rückgängig.
page-parts-mend = Im Text zeigen
page-parts-more = {$title}: alles
page-parts-table_file = Datei (CSV)…


## The workbench: save

page-save-panel_title = Sichern
page-save-old_text = Der Text der Szene hat einen Fehler. Bilder, Zahlen und Drucke sind die des letzten fehlerfreien Textes; Szenendatei, Seite und Link haben den Text, wie er ist.
page-save-pictures = Bilder
page-save-figure = Bild
page-save-worksheet = Arbeitsblatt
page-save-this_step = Schritt {$number}
page-save-png_width = Breite des PNG, in Pixel
page-save-as = {$what} als {$format}
page-save-steps = Konstruktion
page-save-coarse = Zusammengehörige Schritte auf einem Blatt
page-save-sheets = {$count} Blätter, {$format} (ZIP)
page-save-steps_text = Text der Schritte
page-save-packing = Blatt {$number} von {$count} …
page-save-film = Film
page-save-film_turn = Umdrehung des Antriebs
page-save-film_about = Der Browser nimmt das Bild auf, während die Antriebe laufen, wie die Szene es sagt: sechs Sekunden lang, oder sechs je Umdrehung, bis der Mechanismus wieder am Anfang ist. Lassen Sie die Seite sichtbar; Ziehen, Abspielen oder eine Änderung der Szene bricht die Aufnahme ab. Ein GIF, für Folien und Nachrichten, macht das Programm: kinegon draw scene.json -o film.gif
page-save-filming = Nimmt auf …
page-save-film_taken = Der Film wurde abgebrochen: Etwas wurde bewegt oder geändert.
page-save-film_hidden = Der Film wurde abgebrochen: Die Seite war nicht sichtbar.
page-save-film_stuck = Es gibt keinen Film: Der Antrieb kann sich von seinem jetzigen Ort aus nicht bewegen.
page-save-cannot_film = Dieser Browser nimmt keine Filme auf. Das Programm macht sie: kinegon draw scene.json -o film.gif
page-save-numbers = Zahlen
page-save-motion = Bewegung über den Zyklus (CSV)
page-save-results = Ergebnisse (JSON)
page-save-scene = Szene
page-save-scene_about = Die Datei lässt sich in dieser Seite und im Programm wieder öffnen. Die Seite als eine Datei enthält alles und braucht kein Netz: auf einem Stick, einer Kursseite, in einer Mail.
page-save-scene_file = Szenendatei
page-save-page_file = Diese Seite mit der Szene
page-save-page_about = Die Seite wurde nicht vollständig geladen und lässt sich nicht sichern. Laden Sie sie neu.
page-save-copy_link = Link kopieren
page-save-print = Drucken mit 100 %
page-save-print_now = Drucken …
page-save-size = {$name} {$width} mm × {$height} mm
page-save-on = Blatt {$number} von {$count}
page-save-preview = Das Blatt, wie es gedruckt wird
page-save-to_scale = Wählen Sie im Druckfenster 100 % (tatsächliche Größe), dieses Papier und keine Ränder.
page-save-ruler = Das Arbeitsblatt hat ein Lineal. Misst es im Ausdruck 50 mm, ist alles maßstäblich.
page-save-saved = Gesichert: {$name}


## The workbench: links

page-link-of = Link mit der Szene darin, {$size} Zeichen
page-link-copied = Der Link ist in der Zwischenablage: {$size} Zeichen.
page-link-not_copied = Dieser Browser lässt die Seite nicht in die Zwischenablage schreiben. Der Link ist markiert: Kopieren Sie ihn mit Strg+C.
page-link-long = Mit {$size} Zeichen ist dieser Link für manche Mailprogramme und Chats zu lang. Die Szenendatei oder die Seite als eine Datei ist sicherer.
page-link-local = Diese Seite wurde aus einer Datei dieses Rechners geöffnet: Ihre Links gelten nur hier. Öffnen Sie sie von einer Webseite, um Links weiterzugeben, oder geben Sie die Seite als eine Datei weiter.


## The workbench: check

page-check-panel_title = Prüfen
page-check-check = Prüfen
page-check-task = Aufgabe {$name}
page-check-task_intro = Drucken Sie das Blatt mit 100 %, zeichnen Sie darauf die Pläne in seinen Maßstäben und schreiben Sie unten, was Sie ablesen, oder fotografieren Sie es.
page-check-task_sheet = Blatt der Aufgabe
page-check-task_print = Drucken mit 100 %
page-check-task_large = Blatt lesen
page-check-task_small = Zum Mechanismus
page-check-task_drag = Ziehen Sie das Blatt, um den Rest zu sehen; zweimal tippen zeigt es ganz.
page-check-task_next = Nächste Aufgabe
page-check-task_is = Dies ist Aufgabe {$name}. „Rückgängig“ holt die vorige zurück.
page-check-task_steps = Schritte der Konstruktion
page-check-task_making = Das Blatt wird erstellt…
page-check-intro = Schreiben Sie, was Sie an Ihrer Zeichnung abgelesen haben, Wert für Wert. Jeder wird geprüft, sobald er dasteht.
page-check-exam = Dies ist eine Prüfung: Zeichnen Sie am Zeichenbrett und geben Sie dort ab. Vorher wird nichts beurteilt und nichts gezeigt.
page-check-no_scene = Diese Szene hat kein Formular zu prüfen: Sie ist nicht lösbar.
page-check-no_boxes = Diese Szene hat keine Konstruktion von Hand, daher hat ihr Formular keine Kästchen.
page-check-file = Formular
page-check-open = Öffnen…
page-check-save_json = Sichern
page-check-save_csv = CSV
page-check-clear = Leeren
page-check-marks_open = Wertung…
page-check-marks_drop = Ohne Wertung
page-check-marks_of = Wertung: {$name}
page-check-opened = Das Formular {$name} ist offen, Werte: {$count}.
page-check-cleared = Alle Werte sind gelöscht; „Rückgängig“ holt sie zurück.
page-check-name = Ihr Name
page-check-scales = 1 mm auf Ihrem Papier ist
page-check-open_long = Formular öffnen: JSON, oder CSV aus einer Tabellenkalkulation
page-check-save_json_long = Formular sichern, wie kinegon check es liest
page-check-save_csv_long = Formular für eine Tabellenkalkulation sichern
page-check-clear_long = Alle Kästchen leeren
page-check-marks_open_long = Bewertungsdatei öffnen: Werte zählen dann für die Punktzahl
page-check-marks_drop_long = Ohne Bewertung prüfen
page-check-in = Längen und Strecken in
page-check-in_mm = mm Papier
page-check-in_units = Werten
page-check-further = Auch im Formular
page-check-unknown = Nicht verstanden
page-check-remove = {$name} entfernen
page-check-unit_of = Einheit von {$name}
page-check-on_paper = mm Papier
page-check-is_on_paper = = {$value} mm auf dem Papier
page-check-sense_of = Richtungssinn von {$name}
page-check-ccw = gegen Uhrzeigersinn
page-check-cw = im Uhrzeigersinn
page-check-along = längs der Führung
page-check-against = gegen die Führung
page-check-choose_sense = Vorzeichen wählen
page-check-choose_senses = Einige Werte haben den richtigen Betrag, aber kein Vorzeichen: Wählen Sie daneben ↺ oder ↻, beim Gleiten + oder −.
page-check-from_points = aus Ihren Punkten
page-check-typing = …
page-check-not_understood = nicht verstanden
page-check-step = Schritt {$step}
page-check-by_points = Planpunkte markieren
page-check-points_intro = Klicken Sie an, wo die Punkte Ihres Planes liegen, zuerst den Pol, bei Momentanpolen das erste Gelenk der Liste; oder tippen Sie ihre Orte in mm ein, x nach rechts, y nach oben. Das Papier darf beliebig liegen.
page-check-plan = Plan
page-check-points_sheet = Planblatt, Quadrate von 5 mm. Pfeiltasten verschieben das Kreuz um 1 mm, mit Umschalt um 0,1 mm; die Eingabetaste setzt den gewählten Punkt.
page-check-point = Punkt
page-check-place = {$name} setzen
page-check-chosen = Nächster: {$name}
page-check-all_placed = Alle Punkte haben ihren Ort. Ziehen Sie einen, um ihn zu verschieben.
page-check-x_of = x von {$name} in mm
page-check-y_of = y von {$name} in mm
page-check-take_away = {$name} wegnehmen
page-check-placed = {$name} bei {$x} mm, {$y} mm
page-check-scale_first = Schreiben Sie zuerst oben den Maßstab dieses Planes.
page-check-result = Was die Prüfung sagt
page-check-nothing_yet = Noch kein Wert.
page-check-to_result = Was geschah
page-check-should = Wie es sein soll
page-check-show_step = Schritt zeigen
page-check-hint = Ein Tipp
page-check-next_hint = Nächster Tipp
page-check-follows = Folgen daraus
page-check-hand = Genauigkeit Ihrer Zeichnung
page-check-filled = {$filled} von {$all} Kästchen gefüllt
page-check-first_off = Erstes ✗
page-check-overlay = Meine Zeichnung über der richtigen zeigen
page-check-overlay_none = Nichts zu zeichnen: Nichts ist falsch.
page-check-overlay_shown = Das Bild zeigt Ihre Zeichnung über der richtigen: Ihre ist gestrichelt.
page-check-overlay_hide = Zurück zum Bild
page-check-right_values = Richtige Werte zeigen
page-check-right_plan = Richtigen Plan zeigen
page-check-right_plan_later = Der richtige Plan lässt sich zeigen, wenn in jedem Kästchen ein lesbarer Wert steht.
page-check-right_plan_counts = Das zählt als alle Tipps und steht so im Formular.
page-check-right_plan_shown = Der richtige Plan und alle Werte sind jetzt zu sehen.
page-check-feedback = Bericht als Seite sichern
page-check-mm = mm


## The workbench: photo

page-photo-title = Foto Ihrer Zeichnung
page-photo-photograph = Foto Ihrer Zeichnung…
page-photo-take = Zeichnung fotografieren
page-photo-choose = Bild wählen…
page-photo-intro = Zeichnen Sie auf dem gedruckten Zeichenblatt und fotografieren Sie es, oder legen Sie das Bild hier ab: Der richtige Plan liegt darüber, und Sie markieren Ihre Punkte. Das Bild bleibt auf diesem Gerät.
page-photo-again = Zurück zum Foto
page-photo-another = Anderes Foto…
page-photo-close = Foto schließen
page-photo-back = Zurück
page-photo-sheet_of = {$name}, Blatt {$number}
page-photo-right_plan = Richtiger Plan
page-photo-right_later = Der richtige Plan lässt sich zeigen, wenn alle Punkte auf diesem Blatt markiert sind.
page-photo-larger = Größer
page-photo-smaller = Kleiner
page-photo-fit = Ganz
page-photo-undo = Rückgängig
page-photo-opening = Öffnet das Bild…
page-photo-reading = Liest das Blatt…
page-photo-tap = Punkt {$name} antippen
page-photo-tap_in = Punkt {$name} im {$plan} antippen
page-photo-tap_how = Er rückt auf den Schnitt Ihrer Bleistiftlinien. Halten Sie den Finger, um den Ort vergrößert zu sehen.
page-photo-tap_mouse = Er rückt auf den Schnitt Ihrer Bleistiftlinien. Halten Sie die Maustaste, um den Ort vergrößert zu sehen.
page-photo-tap_none = Wählen Sie unten einen Punkt und tippen Sie an, wo er liegt.
page-photo-at_printed = {$name} liegt am gedruckten Ort
page-photo-move_how = Ziehen Sie ihn, oder tippen Sie auf den richtigen Ort; Pfeiltasten verschieben um 0,1 mm.
page-photo-move_touch = Ziehen Sie ihn, oder tippen Sie auf den richtigen Ort.
page-photo-outside = Das liegt nicht auf dem Blatt. Tippen Sie auf das Papier.
page-photo-is_right = {$name} ist richtig
page-photo-is_off = {$name} liegt {$mm} mm daneben
page-photo-is_open = {$name}: mit diesem Bild nicht zu entscheiden
page-photo-open_how = Er liegt {$mm} mm neben seinem Ort, und für mehr ist das Bild nicht scharf genug. Nehmen Sie ein näheres, schärferes auf, oder messen Sie mit einem Lineal.
page-photo-not_snapped = Dort schneiden sich keine Bleistiftlinien: Der Ort ist auf {$mm} mm bekannt. Größer, oder gehalten und vergrößert, zielen Sie besser.
page-photo-leave_out = {$name} auslassen
page-photo-take_away = {$name} wegnehmen
page-photo-accept = {$name} annehmen
page-photo-accept_all = Alle {$count} annehmen
page-photo-is_here = Ist dies Ihr Punkt {$name}?
page-photo-is_here_in = Ist dies Ihr Punkt {$name} im {$plan}?
page-photo-proposed_how = Ihre Bleistiftlinien haben ihn anscheinend dort. Nehmen Sie ihn an, oder tippen Sie an, wo Ihrer liegt.
page-photo-next = Weiter
page-photo-looking = Sucht Ihre Bleistiftlinien…
page-photo-all_marked = Alle Punkte sind markiert
page-photo-none_left = Keine Punkte mehr übrig
page-photo-count_right = {$count} richtig
page-photo-count_off = {$count} falsch
page-photo-count_open = {$count} mit diesem Bild nicht zu entscheiden
page-photo-count_out = {$count} ausgelassen
page-photo-see_check = Zur Prüfung
page-photo-on_board = Mit ihnen am Zeichenbrett weiterzeichnen
page-photo-other_plan = {$plan} fotografieren…
page-photo-points = Punkte im {$plan}
page-photo-state_none = nicht markiert
page-photo-state_printed = wie gedruckt
page-photo-state_out = ausgelassen
page-photo-state_right = richtig
page-photo-state_off = falsch
page-photo-state_open = mit diesem Bild nicht zu entscheiden
page-photo-state_proposed = vorgeschlagen
page-photo-aim = Ort von {$name}. Pfeiltasten verschieben ihn um 0,1 mm, mit Umschalt um 1 mm; die Eingabetaste markiert ihn.
page-photo-picture = Das Foto
page-photo-moved = {$name} bei {$x} mm, {$y} mm von {$origin}
page-photo-bent = Das Blatt ist um {$mm} mm gewölbt: Drücken Sie es flach, dann werden die Orte sicherer.
page-photo-no_decode = Dieser Browser kann „{$name}“ nicht als Bild öffnen.
page-photo-no_decode_hint = Nehmen Sie ein Bild in JPEG oder PNG. Speichert das Telefon HEIC: Nehmen Sie das Foto von dieser Seite aus auf, oder wählen Sie unter Kamera, Formate „Maximale Kompatibilität“.
page-photo-no_scene = Die Szene hat einen Fehler, es gibt also keinen Plan zum Vergleich.
page-photo-no_scene_hint = Beheben Sie zuerst den Fehler der Szene, oder machen Sie die Änderung rückgängig.
page-photo-other_sheet = Dies ist Blatt {$number} von {$name}, nicht von dieser Szene.
page-photo-other_sheet_hint = Öffnen Sie hier jene Aufgabe, oder fotografieren Sie das Blatt von dieser. Wurde die Szene seit dem Druck des Blattes geändert, machen Sie die Änderung rückgängig.
page-photo-nameless = einer anderen Szene
page-photo-no_plan = Dieses Blatt hat den Lageplan und keinen v- oder a-Plan.
page-photo-no_plan_hint = Fotografieren Sie das Zeichenblatt, auf dem Sie den Plan gezeichnet haben.


## The workbench: das Zeichenbrett

page-board-title = Zeichenbrett
page-board-begin = Hier zeichnen
page-board-go_on = Weiterzeichnen
page-board-intro = Zeichnen Sie die Pläne auf dem Bildschirm mit Geodreieck, Stechzirkel und Bleistift. Die erste falsche Linie wird genannt.
page-board-close = Zurück
page-board-undo = Rückgängig (Strg+Z)
page-board-redo = Wiederholen (Strg+Y)
page-board-undone = Rückgängig gemacht.
page-board-redone = Wiederholt.
page-board-fit = Ganzes Blatt zeigen
page-board-more = Mehr
page-board-tools = Werkzeuge
page-board-sheets = Blätter
page-board-all_sheets = Alle
page-board-sheet = Zeichenbrett: {$name}. Buchstaben wählen Werkzeuge, N geht zur nächsten möglichen Stelle, die Eingabetaste drückt.
page-board-list = Schritte
page-board-list_none = Noch ist nichts gezeichnet.
page-board-class = Klasse: {$count} Zeichnungen
page-board-class_minutes = {$minutes} min
page-board-class_away = Klasse weglegen
page-board-back_to_here = Ab hier zurücknehmen
page-board-nothing_here = Hier ist nichts für dieses Werkzeug.
page-board-write = Zeichnen
page-board-own = eigener
page-board-hint = Tipp
page-board-check = Prüfen
page-board-hand_in = Abgeben
page-board-into_form = Ins Formular
page-board-handed_in = Die Werte stehen im Formular.
page-board-handed_in_file = Gespeichert als {$file}, bei Ihren Downloads. Geben Sie diese Datei Ihrer Lehrkraft. Die Werte stehen im Formular.
page-board-hand_in_drawn = { $count ->
    [one] {$count} Schritt ist gezeichnet.
   *[other] {$count} Schritte sind gezeichnet.
  }
page-board-hand_in_name = Ihr Name
page-board-hand_in_what = Die Zeichnung wird als Datei {$file} gespeichert. Geben Sie diese Datei Ihrer Lehrkraft. Danach werden Ihre Werte beurteilt.
page-board-save = Zeichnung speichern
page-board-open = Zeichnung öffnen…
page-board-sheets_pdf = Blätter auf Papier (PDF)
page-board-no_drawing = „{$name}“ ist keine Zeichnung: Es fehlt `kinegon_drawing`.
page-board-opened = „{$name}“ liegt auf dem Zeichenbrett.
page-board-put_back = Vorherige zurückholen
page-board-replay = Abspielen
page-board-end_replay = Zurück zum Zeichnen
page-board-look_on = Abspielen zeichnet Schritt für Schritt; der Schieber geht zu jedem davon.
page-board-play = Abspielen
page-board-pause = Pause
page-board-speed = Tempo
page-board-own_construction = Die Konstruktion zeigen
page-board-own_drawing = Zurück zur eigenen Zeichnung
page-board-first_wrong = Zuerst falsch: Schritt {$number}
page-board-all_right = Alles ist da, und alles ist richtig.
page-board-right_so_far = Bis hierher richtig.
page-board-all_there = Alles Gefragte ist da.
page-board-leads_nowhere = { $count ->
    [one] Schritt {$numbers} führt noch zu keinem Punkt des Plans.
   *[other] Die Schritte {$numbers} führen noch zu keinem Punkt des Plans.
  }
page-board-others_right = Alle anderen sind richtig.
page-board-is_right = richtig
page-board-is_wrong = falsch
page-board-is_follows = folgt aus einem falschen
page-board-is_unused = führt noch nirgendwohin
page-board-is_undone = zurückgenommen
page-board-normal = senkrecht zu
page-board-parallel = parallel zu
page-board-turned = gedreht um den Winkel
page-board-at_base = von
page-board-angle = unter dem Winkel
page-board-other_way = Andersherum
page-board-quarter = Um ein Viertel drehen: längs oder quer (T)
page-board-as_it_comes = wie es herauskommt
page-board-sign_back = Den letzten Teil wegnehmen
page-board-ccw = gegen den Uhrzeiger
page-board-cw = im Uhrzeigersinn
page-board-rubbed = {$name} ist ausradiert, mit dem, was daran hing.
page-board-tool_lay_off = Stechzirkel: Vektor abtragen
page-board-tool_line = Geodreieck: Gerade bekannter Richtung
page-board-tool_join = Lineal: Gerade durch zwei Punkte
page-board-tool_cross = Bleistift: Schnittpunkt zweier Geraden
page-board-tool_like = Abbild: ähnliches Dreieck
page-board-tool_measure = Strecke messen
page-board-tool_compute = Taschenrechner
page-board-tool_solve = Gleichungen lösen
page-board-tool_mark = Bleistift: Punkt nach Augenmaß
page-board-tool_rub = Radiergummi: ein Ding und was daran hängt
page-board-short_lay_off = Zirkel
page-board-short_line = Dreieck
page-board-short_join = Lineal
page-board-short_cross = Stift
page-board-short_like = Abbild
page-board-short_measure = Messen
page-board-short_compute = Rechnen
page-board-short_solve = Lösen
page-board-short_mark = Punkt
page-board-short_rub = Radieren
page-board-form_lay_off = Im {$on} {$size} abtragen von {$from} {$how} {$reference} bis {$name}
page-board-form_line = Im {$on} Gerade {$how} {$reference} durch {$through} namens {$name}
page-board-form_join = Im {$on} Gerade durch {$first} und {$second} namens {$name}
page-board-form_cross = {$first} und {$second} schneiden sich in {$name}
page-board-form_like = Im {$on} wie {$three} zu {$one} und {$two} so liegt zu {$first} und {$second} der Punkt {$name}
page-board-form_measure = Im {$on} messen von {$from} bis {$to} als {$name}
page-board-form_compute = {$name} = {$as} {$sense}
page-board-form_solve = Für {$solve} lösen {$equations}
page-board-form_mark = Im {$on} Punkt {$name}
page-board-form_rub = {$name} ausradieren
page-board-how_lay_off = Größe wählen, dann den Anfangspunkt drücken, dann das Glied oder die Gerade mit der Richtung.
page-board-how_line = Glied oder Gerade drücken: Das Dreieck liegt daran. Dann den Punkt drücken, durch den die Gerade geht. T dreht es.
page-board-how_join = Zwei Punkte drücken.
page-board-how_cross = Drücken, wo sich zwei Geraden schneiden, und den Namen wählen.
page-board-how_like = Drei Punkte eines Glieds im Schema drücken, dann die Bilder der ersten beiden.
page-board-how_measure = Zwei Punkte drücken.
page-board-how_compute = Wählen, was es ist, und schreiben, wie es berechnet wird.
page-board-how_solve = Unbekannte nennen und je Zeile eine Gleichung schreiben.
page-board-how_mark = Drücken, wo der Punkt ist, und den Namen wählen.
page-board-how_rub = Die Gerade oder den Punkt drücken.
page-board-slot_sheet = Blatt
page-board-slot_point = Punkt
page-board-slot_scheme = Punkt des Schemas
page-board-slot_line = Gerade
page-board-slot_direction = Glied, Führung oder Gerade mit der Richtung
page-board-slot_how = Wie es liegt
page-board-slot_angle = Winkel von +x in Grad
page-board-slot_formula = Formel
page-board-slot_formulas = Gleichungen, je Zeile eine
page-board-slot_point_name = Name des Punkts
page-board-slot_line_name = Name der Geraden
page-board-slot_number_name = Name der Zahl
page-board-slot_names = Unbekannte
page-board-slot_sense = Drehsinn
page-board-slot_base = Linie des Plans, an der der Winkel beginnt, etwa b,c
page-board-slot_made = Was gezeichnet wurde
page-board-which_of = {$count} Punkte liegen hier dicht beieinander: welcher?
page-board-which_direction = {$count} Richtungen treffen sich hier: welche?
page-board-wants_sheet = Auf welchem Blatt?
page-board-wants_point = Ein Punkt fehlt: drücken oder wählen.
page-board-wants_scheme = Ein Punkt des Schemas fehlt.
page-board-wants_line = Eine Gerade fehlt: Schnittpunkt drücken oder zwei wählen.
page-board-wants_direction = Die Richtung fehlt: ein Glied oder eine Gerade drücken.
page-board-wants_how = Wie liegt es?
page-board-wants_angle = Der Winkel fehlt.
page-board-wants_formula = Eine Zahl oder eine Formel fehlt.
page-board-wants_formulas = Die Gleichungen fehlen.
page-board-wants_point_name = Welcher Punkt ist es? Name wählen.
page-board-wants_line_name = Die Gerade braucht einen Namen.
page-board-wants_number_name = Welche Zahl ist es? Name wählen.
page-board-wants_names = Welches sind die Unbekannten?
page-board-wants_sense = Welcher Drehsinn?
page-board-wants_base = An welcher Linie des Plans beginnt der Winkel?
page-board-wants_made = Drücken, was weg soll.


## The workbench: sheets

page-sheets-scheme_short = Lageplan
page-sheets-scheme_scaled = Lageplan
page-sheets-scheme_panel = Lageplan
page-sheets-scheme_name = Lageplan
page-sheets-scheme_title = Lageplan
page-sheets-scheme_from = Aus dem Lageplan
page-sheets-velocity_short = v-Plan
page-sheets-velocity_scaled = v-Plan
page-sheets-velocity_panel = Geschwindigkeitsplan
page-sheets-velocity_name = Geschwindigkeitsplan
page-sheets-velocity_title = Geschwindigkeitsplan
page-sheets-velocity_from = Aus dem Geschwindigkeitsplan
page-sheets-acceleration_short = a-Plan
page-sheets-acceleration_scaled = a-Plan
page-sheets-acceleration_panel = Beschleunigungsplan
page-sheets-acceleration_name = Beschleunigungsplan
page-sheets-acceleration_title = Beschleunigungsplan
page-sheets-acceleration_from = Aus dem Beschleunigungsplan
page-sheets-centers_short = Pole
page-sheets-centers_scaled = Pole
page-sheets-centers_panel = Momentanpole
page-sheets-centers_name = Figur der Momentanpole
page-sheets-centers_title = Momentanpole
page-sheets-centers_from = Aus den Polen
page-sheets-forces_short = Kräfte
page-sheets-forces_scaled = Kräfte
page-sheets-forces_panel = Kräfteplan
page-sheets-forces_name = Kräfteplan
page-sheets-forces_title = Kräfteplan
page-sheets-forces_from = Aus dem Kräfteplan
page-sheets-lever_short = Hebel
page-sheets-lever_scaled = Hebel
page-sheets-lever_panel = Hebel
page-sheets-lever_name = Hebel
page-sheets-lever_title = Hebel
page-sheets-lever_from = Aus dem Hebel
page-sheets-speeds_short = Kutzbach
page-sheets-speeds_scaled = Kutzbachplan
page-sheets-speeds_panel = Kutzbachplan
page-sheets-speeds_name = Kutzbachplan
page-sheets-speeds_title = Kutzbachplan
page-sheets-speeds_from = Aus dem Kutzbachplan


## The workbench: refused

page-refused-line = Zeile {$line}: {$message}


## The workbench: subject

page-subject-link = Glied {$name}
page-subject-slider = Schieber {$name}
page-subject-point = Punkt {$name}
page-subject-others = Andere


## The workbench: kinds

page-kinds-title-four-bar = Viergelenk (Kurbelschwinge)
page-kinds-title-slider-crank = Versetzte Schubkurbel
page-kinds-title-slotted-lever = Schwingende Kurbelschleife (Eilrücklauf)
page-kinds-title-hydraulic-boom = Ausleger mit Hydraulikzylinder
page-kinds-title-watt-1 = Watt I, sechs Glieder
page-kinds-title-stephenson-3 = Stephenson III, sechs Glieder
page-kinds-title-whitworth = Umlaufende Kurbelschleife (Whitworth)
page-kinds-title-toggle-press = Kniehebelpresse
page-kinds-title-five-bar = Fünfgelenk mit zwei Antrieben
page-kinds-title-platform-3rrr = 3-RRR-Plattform
page-kinds-title-third-class = Kurbel mit Gruppe III. Klasse
page-kinds-title-fourth-class = Kurbel mit Gruppe IV. Klasse
page-kinds-title-paper-figure-1 = Quintero et al. (2011), Bild 1
page-kinds-title-paper-figure-2 = Quintero et al. (2011), Bild 2
page-kinds-title-dyad-rrr = Zweischlag RRR: zwei Glieder, drei Drehgelenke
page-kinds-title-dyad-rrp = Zweischlag RRP: Koppel und Gleitstein
page-kinds-title-dyad-rpr = Zweischlag RPR: Gleitstein im Schlitz eines Hebels
page-kinds-title-dyad-prp = Zweischlag PRP: zwei Gleitsteine an einem Bolzen
page-kinds-title-dyad-rpp = Zweischlag RPP: Gleitstein im Schlitz eines Schiebers
page-kinds-title-gear-train = Rädergetriebe mit Zwischenrad
page-kinds-title-planetary = Planetengetriebe
page-kinds-title-planetary-sun-fixed = Planetengetriebe mit festem Sonnenrad
page-kinds-title-planetary-carrier-fixed = Planetengetriebe mit festem Steg
page-kinds-title-differential = Differential mit zwei Antrieben
page-kinds-title-reverted-train = Rückkehrendes Getriebe
page-kinds-title-sun-and-planet = Sonnen- und Planetenrad von Watt
page-kinds-title-rack-and-pinion = Zahnstange und Ritzel
page-kinds-title-geared-five-bar = Räderkoppelgetriebe mit fünf Gliedern
page-kinds-title-geneva = Malteserrad
page-kinds-title-eccentric-cam = Exzenter mit Rolle
page-kinds-title-flat-follower = Exzenter mit ebenem Hebel
page-kinds-note-dyad-prp = Wie an der Tafel gezeichnet. Bolzen C verbindet die Gleitsteine 2 und 3: Gleitstein 2 gleitet auf Glied 1, dessen ganze Bewegung bekannt ist, Gleitstein 3 auf einer festen Führung.
page-kinds-note-dyad-rpp = Wie an der Tafel gezeichnet: eine Kreuzschubkurbel. Gleitstein 2, in B an einer Kurbel gelagert, gleitet in der Kreuzschleife 3, die am Gestell gleitet.
page-kinds-note-dyad-rpr = Wie an der Tafel gezeichnet: „points“ gibt alle Koordinaten an, „known“ die Bewegung der äußeren Gelenke B und D. Der Beschleunigungsplan hat einen Coriolisanteil.
page-kinds-note-dyad-rrp = Wie an der Tafel gezeichnet: „points“ gibt alle Koordinaten an, „known“ die Bewegung des äußeren Gelenks B. Die Führung ist fest.
page-kinds-note-dyad-rrr = Wie an der Tafel gezeichnet: „points“ gibt alle Koordinaten an, „known“ die Bewegung der äußeren Gelenke B und D. Die Glieder 1 und 4 sind die Nachbarn, als Stummel gezeichnet.
page-kinds-note-five-bar = Zwei Freiheitsgrade und daher zwei Antriebe: Die Kurbeln 1 und 4 bewegen Punkt C, jede mit eigenem Winkel, omega und alpha.
page-kinds-note-four-bar = Kurbel 1 treibt über Koppel 2 die Schwinge 3 an. Punkte, die an zwei Gliedern genannt sind, sind Gelenke zwischen ihnen.
page-kinds-note-fourth-class = Die Glieder 2 und 4 sind durch die Schlussglieder 3 und 5 verbunden, die die geschlossene Schleife C-D-F-G bilden. Die Pläne brauchen einen Sonderpunkt (Assurschen Punkt) von Glied 3 oder 5.
page-kinds-note-hydraulic-boom = Zylinder 2 und Kolbenstange 3 sind ein Glied zwischen den Gelenken A und C, dessen Länge der Antrieb ändert: Sie drehen sich gemeinsam und bilden mit dem Ausleger einen Zweischlag.
page-kinds-note-platform-3rrr = Drei Freiheitsgrade, drei Antriebe: Die Kurbeln 1, 2, 3 verschieben und drehen die Plattform 7 über die Lenker 4, 5, 6. Plattform und Lenker sind eine Gruppe III. Klasse.
page-kinds-note-slider-crank = Kurbel 1 bewegt über Koppel 2 den Schieber 3.
page-kinds-note-slotted-lever = Kurbel 1 dreht sich gleichförmig; ihr Bolzen B trägt Gleitstein 2, der auf der Schwinge 3 gleitet. Der Beschleunigungsplan hat einen Coriolisanteil.
page-kinds-note-stephenson-3 = Der Koppelpunkt E des Viergelenks A-B-C-D treibt über Glied 4 die Schwinge 5 an: zwei Zweischläge, nacheinander gelöst.
page-kinds-note-third-class = Das ternäre Glied 3 hängt an drei Lenkern: 2 am Kurbelzapfen, 4 und 5 am Gestell. Kein Zweischlag lässt sich zuerst lösen: Die Pläne brauchen einen Sonderpunkt (Assurschen Punkt) von Glied 3.
page-kinds-note-toggle-press = Kurbel 1 und Koppel 2 strecken die Kniehebel 3 und 4, die den Stößel 5 nach unten drücken: langsam und kräftig nahe dem Ende. C ist ein Bolzen durch drei Glieder.
page-kinds-note-watt-1 = Ein Viergelenk A-B-C-D, dessen Koppel 2 und Schwinge 3 die zweite Schleife C-E-G-F tragen: zwei Zweischläge, nacheinander gelöst.
page-kinds-note-whitworth = Kurbel 1 dreht sich gleichförmig; Gleitstein 2 an ihrem Bolzen treibt die Kulisse 3 ganz herum; Koppel 4 treibt den Stößel 5 an.
page-kinds-note-gear-train = Rad 1 treibt Rad 3 über das Zwischenrad 2, das nur den Drehsinn ändert.
page-kinds-note-planetary = Steg 1 treibt an. Planet 2 rollt im festen Hohlrad und treibt Sonnenrad 3.
page-kinds-note-planetary-sun-fixed = Ein Schnellgang: Steg 1 treibt an, Planet 2 rollt auf dem festen Sonnenrad und nimmt Hohlrad 3 mit.
page-kinds-note-planetary-carrier-fixed = Sonnenrad 1 treibt an. Der Zapfen von Rad 2 steht still, und Hohlrad 3 dreht sich anders herum.
page-kinds-note-differential = Sonnenrad 3 und Hohlrad 4 treiben an; Planet 2 rollt zwischen ihnen und nimmt Steg 1 mit.
page-kinds-note-reverted-train = Planet 2 hat zwei Verzahnungen: die eine rollt auf dem festen Sonnenrad, die andere treibt Sonnenrad 3. Steg 1 treibt an.
page-kinds-note-sun-and-planet = James Watt, 1781: Rad 2 sitzt fest an der Stange und umläuft Rad 4, das sich bei jeder Umdrehung von Steg 1 zweimal dreht.
page-kinds-note-rack-and-pinion = Kurbel 1 und Koppel 2 schieben einen Wagen, dessen Rad 4 auf einer festen Zahnstange rollt und Zahnstange 5 doppelt so schnell wie den Wagen treibt.
page-kinds-note-geared-five-bar = Die Kurbeln 1 und 4 sind Räder im Eingriff: die zweite dreht sich doppelt so schnell und anders herum.
page-kinds-note-geneva = Vier Schlitze. `travel` sagt, wo ein Schlitz endet: das Rad bewegt sich eine Viertelumdrehung der Kurbel lang und ruht dann.
page-kinds-note-eccentric-cam = Eine Scheibe, deren Mitte K 20 mm von der Welle liegt; Glied 2 von K zur Rollenmitte C bewegt sich wie die Berührung.
page-kinds-note-flat-follower = Die Scheibe berührt eine gerade Fläche von Hebel 2: ihre Mitte K bewegt sich auf einer Geraden neben dieser Fläche, im Abstand des Halbmessers.


## The workbench: editor

page-editor-Find = Suchen
page-editor-Replace = Ersetzen
page-editor-next = nächstes
page-editor-previous = voriges
page-editor-all = alle
page-editor-match_case = Groß/klein
page-editor-by_word = ganzes Wort
page-editor-regexp = regulärer Ausdruck
page-editor-replace = ersetzen
page-editor-replace_all = alle ersetzen
page-editor-close = schließen
page-editor-current_match = jetziger Treffer
page-editor-on_line = in Zeile
page-editor-Fold_line = Zuklappen
page-editor-Unfold_line = Aufklappen
page-editor-folded_code = zugeklappter Text
page-editor-unfold = aufklappen
page-editor-Completions = Vorschläge
page-editor-Diagnostics = Meldungen
page-editor-No_diagnostics = Keine Meldungen


## The component <kinegon-plan>

page-component-none = Der Plan hat keine Szene: geben Sie deren Adresse in src an, oder schreiben Sie sie zwischen die Tags in ein script vom Typ application/json.
page-component-unread = {$src} konnte nicht gelesen werden ({$why}).
page-component-from_file = Eine Seite, die aus einer Datei geöffnet ist, darf keine anderen lesen: schreiben Sie die Szene zwischen die Tags.
