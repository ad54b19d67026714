### Kinegon in English.
###
### All that figures, steps, reports, messages and the workbench say, in Fluent (https://projectfluent.org): key = sentence. `{$name}` is a blank that is
### filled in; each must be there, in any order, as often as needed. `{" "}` keeps a space at an end. Where words depend on a number or a name,
### `{$count -> [one] … *[other] …}` chooses. A further language is one such file (ARCHITECTURE.md, "To add …"); `cargo test words::` and `npm test` name what it lacks.


## Figures, steps and reports


# Names of links and lines.

# The frame as the carrier of a guide, as in `5/ground`.
ground = ground
guide_of = guide of {$slider}
normal_to_guide = the normal to the guide of {$slider} through {$point}
# The cut line of a leg with two sliders, on which all directions meet.
line_at_infinity = the line at infinity

# Steps that are shown together.

join_special_points = {$points}, special points: where their cut lines cross.
join_lay_off = Lay off {$vectors}.
join_normal = through {$through} ⊥ {$line}
join_parallel = through {$through} ∥ {$line}
join_at_angle = through {$through} at {$angle}
join_cross = The rays {$first} and {$second} cross in {$point}.
join_measure = Measure {$lengths}.
join_rates = Measure {$segments}; solve for {$unknowns}.
join_images = Images of further points: {$points}.

# Steps of the construction.

choose_pole = Choose the pole {$pole} and the scale {$scale}.
choose_pole_with = Choose the pole {$pole} and the scale {$scale}; points at rest have their images there: {$images}.
special_point = {$point}, special point of link {$link}: where {$first} meets {$second}.
special_point_at_infinity = {$point}, special point of link {$link}, lies at infinity (direction {$direction}°): {$first} and {$second} are parallel.
measure_length = Measure the length from {$from} to {$to}.
# Of a point of a driven link.
lay_off_velocity = Lay off the velocity of {$point}, normal to {$arm}, in the sense of ω_{$link}.
lay_off_velocity_turned = Lay off the velocity of {$point}, turned, along {$arm}: in the direction from {$from} to {$to}.
lay_off_normal_acceleration = Lay off the acceleration of {$point}, from {$point} towards {$pivot}: link {$link} turns uniformly.
lay_off_whole_acceleration = Lay off the acceleration of {$point}: normal part from {$point} towards {$pivot}, tangential part normal to {$arm}.
lay_off_given = Lay off the given vector {$vector} from the pole.
lay_off_given_turned = Lay off the given vector {$vector}, turned, from the pole.
lay_off_point_under = Lay off the known vector of the point of {$body} under {$point}.
ray_normal = Draw the ray through {$through} normal to {$line}; {$image} lies on it.
ray_normal_to_guide = Draw the ray through {$through} normal to the {$line}; {$image} lies on it.
ray_parallel = Draw the ray through {$through} parallel to the {$line}; {$image} lies on it.
ray_parallel_to_line = Draw the ray through {$through} parallel to {$line}; {$image} lies on it.
ray_at_angle = Draw the ray through {$through} at the angle {$angle} of the link, in the same sense; {$image} lies on it.
divide = Divide the line from {$from} to {$to} in the ratio {$part} : {$whole}: there is {$image}.
coincide = Link {$link} does not turn: {$image} is at {$with}.
cross = Mark {$image} where the two rays cross.
measure_segment = Measure the segment from {$from} to {$to}.
lay_off_normal_part = Lay off the normal part along {$line} towards {$centre}, from {$from} to {$to}.
lay_off_normal_parts = Lay off the normal parts of both links along {$line} from {$from} to {$to}.
solve = Solve the equations of the measured segments for {$unknowns}.
solve_wheel = Solve the equation of the measured segment for {$unknowns}.
solve_wheel_with_mesh = Solve the equation of the measured segment for {$unknowns}; the equation of the teeth must give the same.
solve_meshes = Solve the equations of the teeth for {$unknowns}.
solve_meshes_accelerated = Solve the equations of the teeth for {$unknowns}: where wheels touch, the tangential parts of their accelerations are equal, not the whole ones.
solve_rims = Wheels have one speed with what they touch, and with their belt; the equations of that give {$unknowns}.
pitch_at_rest = It touches a wheel that is fixed: {$image} is at {$with}.
lay_off_pitch = From ω_{$link}: lay off the velocity of {$point} relative to {$from}, normal to {$arm}; there both wheels have one velocity.
lay_off_pitch_turned = From ω_{$link}: lay off the velocity of {$point} relative to {$from}, turned, along {$arm}; there both wheels have one velocity.
no_construction = There is no construction by two rays for this group: its rates come from the loop equations, and its images are laid off from them, link by link.
no_construction_far = {$points} at infinity: its rays are parallel, so the rates come from the loop equations, and the images are laid off from them, link by link.
lay_off_relative = From ω_{$link}: lay off the velocity of {$point} relative to {$from}, normal to {$arm}.
lay_off_relative_turned = From ω_{$link}: lay off the velocity of {$point} relative to {$from}, turned, along {$arm}.
lay_off_relative_normal = Lay off the normal acceleration of {$point} relative to {$from}, along {$arm} towards {$from}.
lay_off_relative_tangential = From α_{$link}: lay off the tangential acceleration of {$point} relative to {$from}, normal to {$arm}.
lay_off_sliding_velocity = Lay off the sliding velocity of {$slider} along its guide, from {$from} to {$to}.
lay_off_sliding_velocity_turned = Lay off the sliding velocity of {$slider}, turned, normal to its guide, from {$from} to {$to}.
# Backwards, with its head at a point that is there: the chain runs from the sliding link to the guide.
lay_off_sliding_velocity_backwards = Lay off the sliding velocity of {$slider} along its guide so that it ends at {$to}: it begins at {$from}.
lay_off_sliding_velocity_turned_backwards = Lay off the sliding velocity of {$slider}, turned, normal to its guide so that it ends at {$to}: it begins at {$from}.
lay_off_sliding_acceleration = Lay off the sliding acceleration of {$slider} along its guide, from {$from} to {$to}.
lay_off_sliding_acceleration_backwards = Lay off the sliding acceleration of {$slider} along its guide so that it ends at {$to}: it begins at {$from}.
lay_off_coriolis = Lay off the Coriolis acceleration of {$slider}, its sliding velocity turned by 90° in the sense of ω_{$link}, from {$from} to {$to}.
lay_off_coriolis_backwards = Lay off the Coriolis acceleration of {$slider}, its sliding velocity turned by 90° in the sense of ω_{$link}, so that it ends at {$to}: it begins at {$from}.

# Words of equations.

given = {" "}given
made_from = {" "}from{" "}
and = {" "}and{" "}
normal = normal
tangential = tangential
sliding = sliding
coriolis = Coriolis

# The text of the steps.

scales = Scales: {$scales}
scales_by_hand = Scales of the work sheet and of the lengths on paper below: {$scales}
scales_of_figure = Scales of the figure: {$scales}
scale_per_mm = {$scale} = {$value} {$unit} per mm
bands = ± is what honest hand drawings (±{$mm} mm, ±{$degrees}°) keep to, at least 95 of 100.
no_band_no_construction = A value has no ± where it depends on a group without a construction (a special point at infinity, or a higher class).
no_band_no_sheet = A value has no ± where the figure has no {$panel}, so no scale.
on_the_mechanism = On the mechanism
routes_differ = The rates from this construction and from the loop equations differ by {$difference} of the largest; its crossings allow {$allowed}.
on_paper = {$mm} mm on paper
# Behind a rough band.
only_roughly = , only roughly
direction = direction {$degrees}°
angle_of_crossing = angle of crossing {$degrees}°

# Instant centres.

permanent_centers = Mark the permanent centres: {$centers}.
center_in = {$center} in {$point}
center_of_mesh = {$center} in the pitch point
center_normal_to = {$center} at infinity, normal to the guide of {$guide}
center_line = Join {$first} and {$second}; {$center} lies on this line.
center_line_towards = Through {$first} draw the line towards {$second}, at infinity; {$center} lies on it.
center_cross = Mark {$center} on {$first} and {$second}.
center_parallel = {$center} is at infinity: {$first} and {$second} are parallel.
center_along = {$center} is at infinity along {$line}: the other line is that at infinity.
leave_out = Leave link {$link} out and glue {$first} and {$second} together: the centre is then at {$center}.
centers_by_rates = No lines lead to {$centers}: from the computed rates.
rate_by_centers = Compute {$rate}: in {$center} links {$driver} and {$link} have one velocity.
velocity_by_centers = Lay off {$vector}, normal to the ray {$from} {$point}.
rate_by_slide = Compute {$rate}: in {$center} link {$link} has the velocity {$velocity}, along the guide.
velocity_along_guide = Lay off {$vector}, along the guide of {$guide}: all points of the link have this velocity.
collineation_axis = Join {$first} and {$second}, and the centres of curvature of their paths, {$first_center} and {$second_center}: the lines meet in {$crossing}. The collineation axis runs from {$pole} to there.
pole_tangent = Draw the pole tangent t of link {$link} through {$pole}: from the ray to {$first}, at the angle from the axis to the ray to {$second} (Bobillier).
axis_of_point = Draw the ray from {$pole} to {$point} and, from it, at the angle from the tangent to the ray to {$pin}, their axis: it meets the line of {$point} and {$pin} in {$crossing}.
center_of_curvature = The line from there to {$fixed} marks {$center} on the ray, the centre of curvature of the path of {$point}.
path_inflection = The line from there to {$fixed} is parallel to the ray: the path of {$point} has an inflection.
inflection_point = Measure the distances of {$pin} from {$pole} and from {$fixed}. On the ray, from {$pin} towards {$fixed}, J passes an inflection of its path (Euler and Savary).
inflection_in_pin = {$fixed} is at infinity: {$pin} itself passes an inflection, and is J.
inflection_pole = The normal to the ray in {$point} and the normal to the pole tangent in {$pole} meet in {$found}, the inflection pole: the circle over {$pole} {$found} is the inflection circle.
inflections_differ = The inflection poles from these lines and from the computed motion differ by {$difference} of diameter or mechanism; the crossings allow {$allowed}.
curvatures_differ = The centres of curvature from these lines and from the computed motion differ by {$difference} of radius or mechanism; the crossings allow {$allowed}.
velocity_of_center = Lay off {$vector}, that of {$center}: link {$link} does not turn.
centers_differ = The centres from these lines and from the computed motion differ by {$difference} of the mechanism's size; the crossings allow {$allowed}.

weight_letter = W
one_link = link {$link}
several_links = links {$links}
force_moments = Moments of {$links} about {$point} give {$force}.
force_moments_crossing = Moments of {$links} about the crossing of the lines of {$first} and {$second} give {$force}.
force_couple = Moments of {$links} about {$point} give {$couple}, by which the force in the guide of {$guide} acts beside {$point}.
force_begin = Polygon of {$links}, at {$scale}: lay {$force} off.
force_lay_off = Lay {$force} off.
force_direction = Draw the direction of {$force}.
force_cross = The crossing gives {$first} and {$second}.
force_close = {$force} closes the polygon.
force_sum = {$force} is the sum of its parts.
force_inner = {$force} closes the polygon of {$links} alone.
force_push = Along the guide of {$guide} the drive pushes with {$force}.
forces_by_numbers = What the joints of {$links} carry has no construction here: it is laid off from the equations of equilibrium.
force_polygon = Polygon of {$links}: lay off {$known}.
force_polygon_closed = {$forces} close it.
force_polygon_joined = Corners give {$forces}.
forces_differ = The forces from these polygons and from the equations of equilibrium differ by {$difference} of the largest force; rounding and the crossings allow {$allowed}.
lever_turn = Turn the velocity plan by 90° clockwise: it is a lever.
lever_turn_for = Turn the velocities by 90° clockwise, while {$drive} runs at rate 1 and the other drives stand: they are a lever.
lever_arm = {$force} acts at the image of its point: measure its arm.
lever_effort = Moments about the pole give {$effort}: no joint's force has one.
speeds_train = Draw the line of centres with centres and pitch points at the scale of lengths; velocities are laid off normal to it.
speeds_given = Lay off the velocities of {$from} and {$to}: all velocities of {$link} along the line end on the line through their tips.
speeds_line = {$from} and {$to} have velocities that are there: those of {$link} end on the line through their tips.
speeds_pole = Choose a point o and a base below it, at the distance that makes the scale of angular velocities round.
speeds_ray = The parallel through o to the line of {$link} cuts {$rate} off the base.
speeds_slides = {$link} slides: all its points have the velocity of {$at}.
speeds_slides_given = Lay off the velocity of {$at}: {$link} slides, and all its points have it.
speeds_belt = The belt gives both rims one speed: {$to} has the velocity of {$from}.
speeds_turned = In the speed diagram centres that lie off the line are turned onto it, where distances and speeds stay as they are: {$points}.
speeds_unsized_belt = the speed diagram leaves out the belt of {$first} and {$second}: how large its wheels are is not known; give its `radius`
speeds_none = there is no speed diagram: no two wheels mesh or have a belt, and none rolls on a rack
speeds_left_out = the speed diagram is that of the line of centres through {$line}; what touches at {$meshes} lies on another line and cannot be turned onto it

# The figure.

# Title of a figure whose scene has none.
title = Velocity and acceleration plans
scheme = Scheme
velocity_plan = Velocity plan
# Its velocities are drawn turned by 90°, one way or the other.
turned_plan = {$plan}, turned by {$angle}°
acceleration_plan = Acceleration plan
centers = Instant centres
force_plan = Force plan
lever = Lever
speeds = Speed diagram
# A special point that lies off the sheet.
far_away = {$point}: {$distance} from {$from}
# At the line to an image that lies off the panel.
far_in_plan = to {$point}: {$distance}
# In a panel whose content is larger.
cut_at_edge = cut at the edge
names_without_room = no room for all names
# Before a list of them.
names_left_out = no room for:
loads_without_scale = Loads are drawn without a scale.
friction_told = Friction is found with the forces: F^{"{"}f{"}"} = μ |N| along guides, M^{"{"}f{"}"} = ρ |R| at pins, ρ the radius of the circle of friction.
at_infinity = {$point} at infinity
paths = Ticks on the path of {$points}: every {$step} of drive {$drive}.
paths_in_time = Ticks on the path of {$points}: every {$step} of drive {$drive}, that is every {$time}.
path_of = Path of {$point} in {$unit}
# At another assembly mode.
mode = mode {$number}
contact_link = Link {$link} is equivalent to the contact of {$first} and {$second}: it joins their centres of curvature {$from} and {$to}.
contact_face = A pin in {$center}, the centre of curvature of {$first}, that slides along the flat face of {$second} is equivalent to their contact.
contact_here = That holds in this position alone.
equivalent = {$link} (equivalent)
modes_left_out = Of the other assembly modes only the first {$count} are drawn.
# What is drawn of a path on other branches of the motion.
centrodes = Centrodes of link {$links}, near the mechanism: full in the frame, dashed in the link.
no_centrodes = Link {$links} turns about a fixed point or does not turn: it has no centrodes.
inflection_circle = Inflection circle of link {$link}: diameter {$diameter}, through instant centre {$center} and inflection pole {$pole}.
no_inflection_circle = Link {$link} turns about a fixed point or does not turn: it has no inflection circle.
no_centers = {$centers}: the links rest on one another, so that they have no instant centre here.
no_velocities_by_centers = Velocity of {$points} by centres: not found. It takes one drive that moves, and centres of the point's link that do not coincide.
no_curvatures = Curvature of the path of {$points}: not found. It takes two pins of the link on cranks or on blocks in the frame, and a centre of the link that is not fixed.
too_many_for_lines = Lines to instant centres are sought in mechanisms of at most {$most} links: these centres come from the computed rates.
radius_of_curvature = Radius of curvature of the path of {$point}: {$radius}.
no_radius_of_curvature = The path of {$point} has an inflection.
paths_beyond = Dashed: beyond the limits of the drive.
agreement = Construction and loop equations agree: rates differ by {$difference} of the largest (crossings allow {$allowed}).
one_route_far = A special point lies at infinity: rates are from the loop equations alone.
one_route = A group has no construction by two rays: rates are from the loop equations alone.
printed = Printed at 100 %, mm × μ is the value.
with_direction = {$size}, direction {$degrees}°
segment = segment
value = value
values = Values
# Caption of the ruler of 50 mm.
ruler = Printed at 100 %, this is 50 mm

# The text that stands for a figure where it cannot be seen.

description = Panels: {$panels}. Assur groups: {$groups}.
named_scheme = scheme
named_velocity_plan = velocity plan
named_acceleration_plan = acceleration plan
named_centers = instant centres
named_force_plan = force plan
named_lever = lever
named_speeds = speed diagram
described_scheme = the mechanism to scale
described_velocity_plan = its velocity plan
described_acceleration_plan = its acceleration plan
described_centers = its instant centres
described_force_plan = its force plan
described_lever = its lever
described_speeds = its speed diagram
described_group = class {$class}, links {$links}
# The class of a group above class IV.
higher = higher

# Curves.

# Title of curves whose scene has none.
curves = Curves
# Title of the path of a vector's tip over the cycle.
hodograph = Hodograph of {$vector}
willis_all = with the carrier
willis_turns = turns
willis_held = carrier held
willis_together = together
angle = Angle
angular_velocity = Angular velocity
rotational_speed = Rotational speed
speed_ratio = Ratio of angular velocities
angular_acceleration = Angular acceleration
position = Position
length = Length
velocity = Velocity
acceleration = Acceleration
force = Force
moment = Moment
power = Power
in_unit = {$kind} in {$unit}
drive_angle = Angle {$symbol} of the drive in °
drive_position = Position of drive {$drive} in {$unit}

# The legend of curves.

limit = limit
change = change
scene = scene
dead_centre = dead centre
extremes = greatest, least value

# The text that stands for curves where they cannot be seen.

# The drive's quantity, its first and its last value.
over = Over {$drive} from {$from} to {$to}:
is_constant = {$quantity} is {$value}
least = least {$value} at {$at}
greatest = greatest {$value} at {$at}
no_least = least without bound
no_greatest = greatest without bound

# Special positions in the range of a drive; `place` is the drive's value, as in `angle(1) = 30°`.

event_limit = limit position at {$place}: links {$links} can go no further, their rates grow without bound
event_runs_off = limit position at {$place}: links {$links} run off to infinity
event_change = change point at {$place}: links {$links} could go on in another mode too; the smooth motion is followed, and rates are left out there
event_singular = singular position near {$place}: links {$links} cannot be followed through it
event_turns_back = extreme position at {$place}: link {$link} stops at {$angle}° and turns back
event_slides_back = extreme position at {$place}: slider {$slider} stops at {$position} and slides back
event_leaves = end of travel at {$place}: slider {$slider} leaves its guide at {$position}
engaged = The slot is engaged at {$drive} from {$from} to {$to}, {$held} of a turn; for the other {$free} it dwells.
events_left_out = {$count} more extreme or change points follow
rates_of_every_position = each position is computed with the ω and α that the scene gives the drive; this is not a run-up, in which ω would change

# The structure: Assur groups in solving order.

structure_freedoms = degrees of freedom: {$count}, as many as drives
structure_known = known motions: {$motions}
structure_drives = drives: {$count}; known motions: {$motions}
structure_positions = positions from {$angle}: {$groups}
structure_group = links {$links}: class {$class}, {$shape}
structure_special_points = special points {$points}
shape_second = two links
shape_third = a central link on three legs
shape_fourth = two drag links joined by two closure links, a closed contour of four
shape_higher = more links than the classes II to IV have, or joined in another way
structure_wheel = link {$link}: one wheel, turned by what it touches

# The list of assembly modes.

modes = {$count ->
    [one] {$count} assembly mode
   *[other] {$count} assembly modes
}
modes_at_least = at least {$count}
modes_listed = {$modes}, listed are the first {$listed}
modes_heading = {$modes}; coordinates in {$unit}, angles in degrees
modes_of_group = links {$links}: {$found} found, {$most} at most

# The report on a student's values.

check_counts = {$right} right, {$within} within the tolerance of a pencil, {$off} off
check_counts_and_senses = {$right} right, {$within} within the tolerance of a pencil, {$missing} without a sense, {$off} off
check_right = right
check_within = within tolerance
check_sense_missing = sense missing
check_senses = Sense missing: the size is right, but a number without a sign does not tell the sense. Write + or − before it, or "positive": "counter-clockwise" into the form.
check_off = OFF
# The verdict on a direction.
check_off_turned = OFF: turned by {$degrees}°
check_cannot_tell = cannot tell
check_missing = Missing: {$count} of {$asked} that are asked for: {$values}.
check_missing_many = Missing: {$count} of {$asked} that are asked for: {$values} and {$more} more.
check_coarse_digits = Too few digits to tell anything: {$values}. Write at least two that are not zero.
check_rough_places = Known too roughly to be judged: {$values}. A radius behind a place counts up to {$mm} mm.
check_too_small = Too small on the sheet to be judged: {$values}. An honest hand could as well find nothing there.
check_coarse = Without a construction by hand, so up to {$percent} % (of an angle {$degrees}°) is allowed: {$values}.
check_all_larger = All lengths are {$percent} % too large: was the sheet printed to fit the page? They are judged without that.
check_all_smaller = All lengths are {$percent} % too small: was the sheet printed to fit the page? They are judged without that.
check_all_longer = All lengths are {$mm} mm too long: did you read the ruler from its end, or from {$mm}? They are judged without that.
check_all_shorter = All lengths are {$mm} mm too short: did you lay the end of the ruler on the point? They are judged without that.
check_other_scale = {$scale}: your form states {$stated}, the exercise {$asked}; your values are judged at yours.
check_no_such_scale = {$scale} = {$stated}: no sheet can show the {$sheet} so; what is allowed is that of a drawing at {$used}.
column_quantity = quantity
check_column_written = yours
check_column_expected = expected
check_column_difference = off by
check_column_on_paper = on paper
check_column_percent = off by
check_column_allowed = allowed
check_column_verdict = verdict
check_tolerance = A careful drawing (±{$mm} mm, ±{$degrees}° in each act) may be off by as much as is allowed here.
check_accuracy = Your drawing is accurate to about {$mm} mm and {$degrees}°, as the scatter of all values shows.
check_slips = Your computed numbers are off by up to about {$percent} %.
check_wider = So more is allowed than for a careful hand (±{$mm} mm, ±{$degrees}°).
check_too_coarse = A hand of ±{$mm} mm and ±{$degrees}° was asked for.
check_probably = What probably happened
check_nothing = All correct.
# In place of `check_nothing` where something is missing or tells nothing.
check_so_far = Nothing is off: {$good} of {$asked} values are correct, the others are not known.
check_tells_nothing = These values tell nothing, right or wrong.
check_no_single = No single mistake explains this. Together these do:
check_none = Something is wrong from step {$number} on: {$value} is the first value that is off. I cannot tell the cause.
check_step = Step {$number}
# In place of a step.
check_whole = Whole drawing
check_instead = It should be
check_follows = These follow from it and are consistent with it: {$values}.
check_follows_none = No other of your values follows from it.
check_values_of = These are the values of another exercise: {$exercise}.
check_worked = With your numbers: {$calculation}.
check_worked_beside = With your numbers: {$calculation}; you have {$own}.
check_seems_left = It seems turned to the left by {$degrees}°.
check_seems_right = It seems turned to the right by {$degrees}°.
check_seems_longer = It seems {$mm} mm too long.
check_seems_shorter = It seems {$mm} mm too short.
check_seems_elsewhere = The point seems {$mm} mm from where its two lines cross: from {$first} it is seen {$one}° beside its line, from {$second} {$other}°.
check_redo = Do steps {$steps} again; keep the rest.
check_redo_one = Do step {$step} again; keep the rest.
check_redo_number = Correct this number alone; the drawing stays.
check_sure = How sure: {$percent} %
check_others = It could also be
# In place of `check_others` where only the place of a mistake is told.
check_perhaps = Perhaps it was this
check_hint_plan = Look at your {$plan}.
check_hint_whole = Look at the whole drawing: its position, its scale, its senses.
check_hint_value = The first value that is off is {$value}.
# Behind an explanation that the values cannot tell from the first.
check_alike = your values alone cannot tell this from the above
check_unexplained = Without an explanation: {$values}.
check_not_looked = In so large a construction no causes are looked for.
check_looked_at = So large a form is searched in part: only the first {$count} values are looked at for causes.
check_mirrored = The points of your {$plan} are the mirror image of the right ones: all senses are turned round. If you measured y downwards on the sheet, measure it upwards.
check_turned_left = Your whole {$plan} lies turned to the left by {$degrees}°. If the sheet was not laid so, its first vector was.
check_turned_right = Your whole {$plan} lies turned to the right by {$degrees}°. If the sheet was not laid so, its first vector was.

# A student's drawing over the right figure.

check_key_right = as it should be
check_key_own = yours (names with *)
check_key_wrong = where it went wrong
check_follows_marked = {$count} values marked {$mark} in the table follow from it and are consistent with it.
# A point of the student's drawing beyond the edge of its panel.
check_beyond = {$point}: {$mm} mm farther
check_turned = The points of your {$plan} are shown turned by {$degrees}°, as they fit best.

# Photographs of drawings.

photo_column_point = point
photo_column_right = right mm
photo_column_found = seen mm
photo_column_off = apart mm
photo_column_band = ± mm
photo_cannot_tell = cannot be told from this picture
photo_left = not found
photo_sheet = {$file}: sheet {$number} of {$name}

# What fills the blanks of mistakes' sentences.

line_cut = the line that was drawn for {$point}
line_guide = the guide of {$slider}
line_through = the line {$points}
all_segments = all segments of the sheet
all_lengths = all lengths
all_velocities = all velocities
all_accelerations = all accelerations
all_angular_velocities = all angular velocities
all_angular_accelerations = all angular accelerations
all_forces = all forces
all_moments = all moments
# Of an x component.
horizontal = horizontal
# Of a y component.
vertical = vertical

# Marks, and the summary of a class.

class_marks = Marks: {$earned} of {$of}
class_marks_following = Marks: {$earned} of {$of}, {$follow} of them for values that follow from a mistake
class_counts = {$files ->
    [one] {$files} file: {$passed} passed, {$off} off, {$broken} not understood
   *[other] {$files} files: {$passed} passed, {$off} off, {$broken} not understood
}
class_incomplete = {$count} without a value that is off, but not complete
class_common = {$count} of {$of}: step {$step}, {$done}
class_common_whole = {$count} of {$of}: whole drawing, {$done}
class_unknown = {$count} of {$of}: values are off, the cause is not known
class_not_understood = This form was not understood. Hand it in again when this is put right:

# The sheets of exercises.

exercise_given = Given: {$all}.
exercise_draw = Draw the plans at {$scales}. Measure, on this sheet too, and fill in the boxes.
exercise_centers = Find the instant centres at {$scales}. Measure, and fill in the boxes; coordinates count from the origin of the given places.
exercise_forces = Find the forces by moments and force polygons at {$scales}; arms are measured on this sheet. Measure, and fill in the boxes. An R names a pin and the link on which it acts there.
exercise_lever = Find what the drive needs by Zhukovsky's lever at {$scales}: forces at images of their points. Measure, and fill in the boxes.
exercise_guide = guide of {$slider} through {$place} at {$degrees}°
exercise_guide_through = guide of {$slider} along {$line}
exercise_wheel = wheel {$link} ({$teeth} teeth)
exercise_ring = ring {$link} ({$teeth} teeth)
exercise_fixed_wheel = the fixed wheel ({$teeth} teeth)
exercise_fixed_ring = the fixed ring ({$teeth} teeth)
exercise_mesh = {$first} meshes with {$second}
exercise_mesh_on = {$first} meshes with {$second} on arm {$arm}
exercise_room = The velocity plan takes {$velocity}, the acceleration plan {$acceleration}: draw each on {$paper} or larger.
exercise_sheets = Sheets for the plans follow.
exercise_center_sheet = A sheet for the instant centres follows.
sheet_markers = Photograph: sheet flat, all eight squares in view.
exercise_senses = Signs: counter-clockwise is +.
exercise_senses_of_slides = Signs: counter-clockwise is +; {$slides}: + along the arrow marked +.
exercise_points = Points: {$all}.
exercise_normal_ends = {$points}: end of a normal part
exercise_coriolis_ends = {$points}: end of a Coriolis part
exercise_sliding_ends = {$points}: end of a sliding part
exercise_name = Name: ………………………………… Date: ………………
# Below the drawn key.
exercise_allowed = ± is what a careful hand may be off by.

# Exercises in a course.

course_digits = Write each value with three significant digits, in the unit beside its box.
course_other_sense = The size is right, the sense is wrong.
course_cause = Probable cause: {$told}
# Of a value behind a mistake that was made at an earlier step.
course_follows = This value follows from it.
course_picture = The mechanism, true to scale
course_print = Sheet to print at its true size
course_key = The mechanism with both plans
course_if = If you found {$value}:


## Mistakes: what was probably done, and what it should be

turned_ray-done = the ray from {$from} to {$to} was drawn turned by 90°: parallel in place of perpendicular, or the other way round
turned_ray-should = a ray of a relative motion between two points of one link is normal to the line between them; only the ray of a sliding motion is parallel to its guide
turned_rays-done = the rays from {$from} to {$to} and from {$other} to {$to} were both drawn turned by 90°: parallel in place of perpendicular, or the other way round
turned_rays-should = a ray of a relative motion between two points of one link is normal to the line between them; only the ray of a sliding motion is parallel to its guide
turned_cut_line-done = the line through {$joint} for {$point} was drawn along the guide
turned_cut_line-should = {$point} lies on the normal to the guide through {$joint}
ray_from_wrong_point-done = the ray to {$image} was drawn through {$wrong}
ray_from_wrong_point-should = it starts at {$right}, where the known part of the vector equation ends
wrong_lines-done = {$point} was marked on {$wrong}
wrong_lines-should = {$point} lies on {$right}
reversed_vector-done = the vector from {$from} to {$to} was laid off reversed
reversed_vector-should = it points from {$from} to {$to}, in the sense in which its link turns or slides
turned_vector-done = the vector from {$from} to {$to} was laid off turned by 90°
turned_vector-should = a velocity or a tangential acceleration is normal to the line between the two points, a normal acceleration lies along it
turned_vectors-done = the vector from {$from} to {$to} was laid off {$degrees}° off its direction in both plans
turned_vectors-should = the velocity is normal to the crank, the normal acceleration points along it to its pivot
vector_from_wrong_point-done = the vector to {$end} was laid off from {$wrong}
vector_from_wrong_point-should = it starts at {$right}
normal_outward-done = the normal acceleration {$rate}² {$length} on the way from {$from} to {$to} was laid off outward
normal_outward-should = a normal acceleration points towards the point about which the link turns
normals_outward-done = the normal accelerations {$vectors} were laid off outward
normals_outward-should = a normal acceleration points towards the point about which the link turns
omega_not_squared-done = for the normal part from {$from} to {$to}, {$rate} was taken in place of its square
omega_not_squared-should = the normal part is {$rate}² {$length}
omegas_not_squared-done = for the normal parts {$vectors}, ω was taken in place of its square
omegas_not_squared-should = a normal part is ω² times the length
omega_of_another_link-done = for the vector from {$from} to {$to}, {$wrong} was taken in place of {$rate}
omega_of_another_link-should = the vector goes with {$rate} and {$factor}
omegas_interchanged-done = for the normal parts, {$rate} and {$wrong} were taken in place of each other, first from {$from} to {$to}
omegas_interchanged-should = each normal part goes with the rate of its own link: that from {$from} to {$to} with {$rate}
diameter-done = the normal part {$rate}² {$length} from {$from} to {$to} came out twice as large, as with the diameter
diameter-should = the normal part is {$rate}² times the radius {$length}
diameter_throughout-done = twice {$length} was taken for the radius in velocity and acceleration, as with the diameter or the stroke
diameter_throughout-should = take the radius {$length}
half_the_radius-done = half of {$length} was taken for the radius in velocity and acceleration
half_the_radius-should = {$length} is the radius, not the diameter
normal_from_absolute-done = the normal part along {$length} from {$from} to {$to} was computed from the velocity {$velocity}
normal_from_absolute-should = it takes the relative velocity: {$rate}² {$length}
normal_forgotten-done = the normal part {$rate}² {$length} was forgotten on the way from {$from} to {$to}
normal_forgotten-should = lay off {$rate}² {$length} before the ray is drawn
normals_forgotten-done = the normal parts {$vectors} were forgotten
normals_forgotten-should = lay off ω² times the length before each ray is drawn
tangential_where_none-done = a tangential part {$rate} {$length} was added to the normal part from {$from} to {$to}
tangential_where_none-should = {$rate} does not change, so there is no tangential part: the acceleration is {$rate}² {$length}
coriolis_forgotten-done = the Coriolis acceleration was forgotten on the way from {$from} to {$to}
coriolis_forgotten-should = lay off 2 {$rate} {$velocity} normal to the guide
coriolis_without_two-done = the Coriolis acceleration from {$from} to {$to} was taken without its 2
coriolis_without_two-should = it is 2 {$rate} {$velocity}
coriolis_turned-done = the Coriolis acceleration from {$from} to {$to} was laid off the wrong way
coriolis_turned-should = it has the direction of {$velocity} turned by 90° in the sense of {$rate}
coriolis_along-done = the Coriolis acceleration from {$from} to {$to} was laid off along the guide
coriolis_along-should = it is normal to the guide: it has the direction of {$velocity} turned by 90° in the sense of {$rate}
coriolis_velocity-done = the Coriolis acceleration from {$from} to {$to} was computed from the velocity {$wrong}
coriolis_velocity-should = it takes the sliding velocity: 2 {$rate} {$velocity}
coriolis_velocity_and_omega-done = the Coriolis acceleration from {$from} to {$to} was computed from {$omega} and the velocity {$wrong}
coriolis_velocity_and_omega-should = it takes the rotation of the guide and the sliding velocity: 2 {$rate} {$velocity}
coriolis_where_none-done = a Coriolis acceleration was added to {$rate}² {$length} on the way from {$from} to {$to}, where nothing slides
coriolis_where_none-should = there is a Coriolis acceleration only where something slides on a link that turns
coriolis_at_rest-done = a Coriolis acceleration 2 {$rate} {$velocity} was laid off from {$from}, before the ray to {$to}
coriolis_at_rest-should = the guide is at rest: there is a Coriolis acceleration only where something slides on a link that turns
mirrored_image-done = {$point} was laid off on the wrong side of {$start} {$other}: the image of the link is mirrored
mirrored_image-should = the image of a link is similar to the link, turned but never mirrored
beyond_end-done = {$point} was marked on the wrong side of {$start}, on the line through {$start} and {$other}
beyond_end-should = the images lie on their line in the order in which the points lie on the link
wrong_ratio-done = the line from {$from} to {$to} was divided from its wrong end: {$point} has the distance from {$from} that it should have from {$to}
wrong_ratio-should = the image divides the line of the images as the point divides the line of the points
inverse_ratio-done = {$point} has the inverse of its ratio: the distances from {$from} to {$point} and from {$from} to {$to} are exchanged
inverse_ratio-should = the image divides the line of the images as the point divides the line of the points
distances_exchanged-done = {$point} has the distance from {$from} that it should have from {$to}, and the other way round
distances_exchanged-should = the image of a link is similar to the link: each angle of its triangle stands at its own end
distances_exchanged_and_mirrored-done = {$point} is on the wrong side of the line from {$from} to {$to}, and its distances from both are exchanged
distances_exchanged_and_mirrored-should = the image of a link is similar to the link: each angle of its triangle stands at its own end
wrong_segment-done = for {$segment} the segment from {$from} to {$to} was measured
wrong_segment-should = measure {$segment}
component-done = for {$segment} its {$axis} component was measured
component-should = measure the true length from {$from} to {$to}
wrong_length-done = for {$length} the length from {$from} to {$to} was taken
wrong_length-should = take {$length}
wrong_length_throughout-done = for {$length} the length from {$from} to {$to} was taken, wherever it is used
wrong_length_throughout-should = take {$length}
omega_from_wrong_length-done = {$rate} was found with the length from {$from} to {$to}
omega_from_wrong_length-should = divide by {$length}
omega_and_normal_from_wrong_length-done = {$rate} and the normal part to {$normal} were found with the length from {$from} to {$to}
omega_and_normal_from_wrong_length-should = take {$length} for both
alpha_from_wrong_length-done = {$rate} was found with the length from {$from} to {$to}
alpha_from_wrong_length-should = divide by {$length}
not_divided_by_length-done = for {$rate} the segment was not divided by {$length}
not_divided_by_length-should = divide by {$length}
wrong_sense-done = {$rate} was taken with the wrong sense
wrong_sense-should = the sense follows from the direction of the segment in the plan and the side on which its line lies
wrong_sense_given-done = {$rate} was taken with the wrong sense: the vector from {$from} to {$to} points the wrong way
wrong_sense_given-should = the sense of {$rate} is given
senses_reversed-done = the senses of all rates of rotation are reversed, as if clockwise were positive
senses_reversed-should = counter-clockwise is positive
revolutions_for_radians-done = {$rate} was not converted between revolutions per minute and radians per second
revolutions_for_radians-should = rad/s = rpm · π/30
rate_in_other_unit-done = {$rate}: {$number} {$given} was given; it was taken as {$number} {$taken}
rate_in_other_unit-should = go on with {$number} {$given}
all_in_other_unit-done = {$values}, such as {$first}, are in {$unit}, but no unit is written beside them
all_in_other_unit-should = write {$unit} beside them, or the values in {$own}
value_for_paper-done = {$quantity}: {$number} is the value in {$unit}; the box asks for millimetres of paper
value_for_paper-should = {$number} : {$scale} = {$mm} mm on paper
values_for_paper-done = {$segments}: values in {$unit} are written; the boxes ask for millimetres of paper
values_for_paper-should = a value divided by {$scale} is its length on paper in millimetres
common_factor_degrees-done = {$values}, such as {$first}, are {$factor} times what they should be
common_factor_degrees-should = every product takes angular velocities in radians per second: 1 rad is 57.2958°
common_factor_turns-done = {$values}, such as {$first}, are {$factor} times what they should be
common_factor_turns-should = every product takes angular velocities in radians per second: 1 revolution is 2π rad
common_factor_rpm-done = {$values}, such as {$first}, are {$factor} times what they should be
common_factor_rpm-should = every product takes angular velocities in radians per second: 1 rad/s is 9.5493 revolutions per minute
common_factor_minutes-done = {$values}, such as {$first}, are {$factor} times what they should be
common_factor_minutes-should = all times are in one unit: a minute has 60 seconds
common_factor_units-done = {$values}, such as {$first}, are {$factor} times what they should be
common_factor_units-should = all lengths are in one unit: 1 m is 100 cm or 1000 mm
revolutions_per_second-done = {$rate} was not converted between revolutions per second and radians per second
revolutions_per_second-should = rad/s = rev/s · 2π
degrees_for_radians-done = {$rate} was not converted between degrees and radians
degrees_for_radians-should = a rate of rotation enters every product in radians
wrong_scale-done = {$segment}: {$wrong} was used in place of {$scale}
wrong_scale-should = millimetres on this sheet times {$scale} are the value
scale_forgotten-done = {$segment}: millimetres of paper were taken for the value, without {$scale}
scale_forgotten-should = millimetres on this sheet times {$scale} are the value
center_along_guide-done = {$center} was sought along {$guide}
center_along_guide-should = {$center} lies at infinity, normal to {$guide}: lines towards it are normal to the guide
center_at_slider-done = {$center} was taken in {$pin}, the pin of the block
center_at_slider-should = {$pin} is the centre of the block with its other link; {$center} lies at infinity, normal to {$guide}
line_without_common_link-done = {$center} was marked on {$wrong}
line_without_common_link-should = {$center} lies on {$right}: each of its lines joins two centres that have one third link in common
center_of_other_lines-done = {$center} was marked where the lines of {$other} cross
center_of_other_lines-should = each line of {$center} joins two centres that have one third link in common
centers_swapped-done = {$first} and {$second} were taken for each other
centers_swapped-should = each line of {$first} joins two centres that have one third link in common
ratio_inverted-done = for {$rate} the ratio of the distances was taken upside down
ratio_inverted-should = the distances of the common centre are inversely as the angular velocities: multiply by {$over} / {$under}
mesh_sense-done = wheels {$first} and {$second} were taken to turn the same way, seen from their carrier
mesh_sense-should = wheels that touch from outside turn opposite ways, seen from their carrier
mesh_sense_internal-done = the ring and the wheel of {$first} and {$second} were taken to turn opposite ways, seen from their carrier
mesh_sense_internal-should = a ring and the wheel in it turn the same way, seen from their carrier
teeth_inverted-done = for wheels {$first} and {$second} the ratio of the teeth was taken upside down
teeth_inverted-should = angular velocities are inversely as the numbers of teeth
arm_forgotten-done = for wheels {$first} and {$second} the ratio of the teeth was taken without the turning of {$arm}
arm_forgotten-should = the ratio of the teeth holds for the angular velocities less ω_{$arm}
relative_for_absolute-done = {$rate} is that relative to {$arm}
relative_for_absolute-should = add ω_{$arm}
idler_counted-done = the teeth of {$idler} stand in the ratio of {$first} and {$last}
idler_counted-should = a wheel between two others changes the sense alone; its teeth cancel
rim_swapped-done = where {$wheel} meshes with {$other}, the teeth of its other rim were taken
rim_swapped-should = take the teeth of the rim that touches
rims_swapped-done = the two rims of {$wheel} were taken for each other
rims_swapped-should = take in each mesh the teeth of the rim that touches
pitch_on_wrong_side-done = {$wheel} was taken to touch the ring {$ring} on its near side
pitch_on_wrong_side-should = a ring touches the wheel in it beyond the wheel's centre
accelerations_equal-done = where {$first} and {$second} touch, their accelerations were taken as equal
accelerations_equal-should = there velocities and tangential parts are equal alone; the acceleration of the wheel's centre follows from its carrier
diameter_for_radius-done = for {$found} the diameter of wheel {$wheel} was taken in place of its radius
diameter_for_radius-should = velocity is ω r and moment is W r, with the radius r of wheel {$wheel}
radial_force_left_out-done = {$force} was left out: the force between the teeth was taken along the tangent alone
radial_force_left_out-should = teeth push each other along their line of action: beside the part along the tangent there is {$force}, tan α times as large, which drives the wheels apart
radius_left_out-done = for {$length} the radius of {$link} alone was taken
radius_left_out-should = the equivalent link joins the centres of curvature: {$length} is the sum of both radii, of a hollow profile their difference
wrong_center_of_curvature-done = the common normal of {$first} and {$second} was drawn from {$wrong}
wrong_center_of_curvature-should = the common normal runs through {$right}, the centre of curvature of the profile where they touch
sliding_left_out-done = {$image} was marked at {$start}, as if the profiles did not move along each other
sliding_left_out-should = profiles that touch have equal velocities only along their common normal: draw the relative velocity from {$start}, along their tangent
face_along_wrong_line-done = the flat face of {$link} was taken along {$line}
face_along_wrong_line-should = the relative velocity is parallel to the face
face_normal_to_wrong_line-done = the flat face of {$link} was taken normal to {$line}
face_normal_to_wrong_line-should = the relative velocity is parallel to the face, and the common normal is normal to the face itself
friction_sense-done = {$friction} was taken in the sense of the motion
friction_sense-should = friction resists: what a guide or a pin does to a link is opposite to how the link moves on it
angle_for_coefficient-done = for {$friction} the angle of friction was taken for the coefficient, or its tangent for its sine
angle_for_coefficient-should = with the angle of friction φ the coefficient of a guide is μ = tan φ, and the circle of friction of a pin has the radius r sin φ
normal_without_lean-done = {$friction} was found by what the joint would carry without friction
normal_without_lean-should = friction changes what presses in the joint: find forces again with {$friction} until both fit
friction_circle_diameter-done = {$friction} was found with the diameter of the journal
friction_circle_diameter-should = the circle of friction has the radius r sin φ, with the radius r of the journal
friction_left_out-done = {$friction} was left out
friction_left_out-should = take {$friction} with the other forces: a guide resists with μ |N|, a pin with the couple of a force that touches the circle of friction
sense_by_center-done = {$rate} has the wrong sense
sense_by_center-should = the sense is reversed where the common centre lies between the two fixed centres, and kept where it lies outside
velocity_reversed-done = {$velocity} was laid off the wrong way
velocity_reversed-should = it points as its link turns about its fixed centre
distance_from_wrong_center-done = for {$length} the distance from {$from} to {$to} was taken
distance_from_wrong_center-should = measure {$length}: velocities of a link grow with the distance from its centre with the frame
not_extended-done = for {$center} the lines were not drawn far enough: other lines were crossed between the centres
not_extended-should = {$center} lies where {$first} and {$second} cross, which must be drawn beyond their centres
velocity_along_ray-done = {$velocity} was laid off along the ray from its centre
velocity_along_ray-should = a velocity is normal to the ray from the centre to its point
pin_of_three-done = {$center} was not taken in {$pin}, where its links are joined, but elsewhere
pin_of_three-should = a pin that joins three links is the centre of each pair of them
lengths_without_scale-done = {$lengths}: millimetres of paper were taken for lengths, without {$scale}
lengths_without_scale-should = millimetres on this sheet times {$scale} are the length
inertia_along_a-done = {$load} was taken along the acceleration
inertia_along_a-should = a force of inertia is −m a: it points against the acceleration of the centre of mass
inertia_couple_along_alpha-done = {$load} was taken in the sense of the angular acceleration
inertia_couple_along_alpha-should = a couple of inertia is −J α: it turns against the angular acceleration; as one force it stands beside the centre so that it turns the same way
couple_forgotten-done = {$load} was left out of the moments
couple_forgotten-should = a couple has the same moment about every point, and counts in every sum of moments of its link
percussion_on_wrong_side-done = {$load} was put on the wrong side of the centre of mass
percussion_on_wrong_side-should = the line of {$load} runs at the distance h = J α / (m a) beside the centre, where it turns against the angular acceleration
a_of_joint_for_centre-done = {$load} was found with the acceleration of {$point}
a_of_joint_for_centre-should = a force of inertia follows from the acceleration of the centre of mass, not of a joint
centripetal_part_left_out-done = {$load} was found without the centripetal part of the acceleration about {$point}
centripetal_part_left_out-should = the acceleration of the centre of mass has the part ω² r towards {$point}, too
arm_to_point-done = for {$found} an arm was measured to the point where its force acts
arm_to_point-should = the arm of a force is the distance of its line of action, measured normal to it
arm_in_paper_mm-done = for {$found} arms were taken in millimetres of paper
arm_in_paper_mm-should = an arm is its millimetres times {$scale}
arms_in_paper_mm-done = arms were taken in millimetres of paper
arms_in_paper_mm-should = every arm is its millimetres times {$scale}
reaction_not_reversed-done = {$force} was handed on without being reversed
reaction_not_reversed-should = what one link does to another, that does to it reversed: on the next link {$force} acts in the opposite direction
negative_tangential_kept-done = {$force} was laid off in the direction that was assumed, though the moments gave it negative
negative_tangential_kept-should = a force that comes out negative acts against the assumed direction: {$force} is laid off the other way
normal_across-done = the direction of {$force} was drawn normal to the line of the two joints
normal_across-should = {$force} acts along the line of both joints of its link
force_missing_in_polygon-done = {$force} is missing in the polygon
force_missing_in_polygon-should = the polygon has every force on the links that are cut free, {$force} among them
force_twice-done = {$force} was laid off twice
force_twice-should = each force stands once in a polygon
guide_reaction_along_rod-done = {$force} was drawn along {$guide}
guide_reaction_along_rod-should = without friction a guide carries forces normal to itself only
guide_reaction_through_pin-done = what {$guide} does was taken to act in {$point}
guide_reaction_through_pin-should = it acts at the distance h = M / N from {$point}, which the moments of the sliding link tell
mass_for_weight-done = the number of the mass was taken for {$load}
mass_for_weight-should = a weight is mass times g: {$load} = m g
factor_of_thousand-done = {$load} is wrong by a factor of 1000
factor_of_thousand-should = with lengths in mm a force in N is mass in kg times acceleration in mm/s², over 1000
moment_about_wrong_point-done = for {$found} moments were taken about {$wrong}
moment_about_wrong_point-should = moments are taken about {$right}: the lines of the other unknown forces pass through it
moment_about_another_point-done = for {$found} moments were taken about another point than {$right}
moment_about_another_point-should = moments are taken about {$right}: the lines of the other unknown forces pass through it
lever_not_turned-done = for {$found} the forces were put on the velocity plan without turning it
lever_not_turned-should = the velocity plan, or every force, is first turned by 90°: then moments about the pole are powers
couple_on_lever_unscaled-done = the couple on link {$link} was added to the moments of the lever as it is
couple_on_lever_unscaled-should = on the lever a couple M is two forces M/l at the images of two points of link {$link}, l apart
torque_sense-done = {$found} has the sense of what the drive works against
torque_sense-should = {$found} is what the drive does to its link: it balances the moments of all forces on it
other_mode-done = the mechanism was drawn in another position in which its links fit together
other_mode-should = the scene asks for the position shown in the figure
crank_angle-done = the mechanism was drawn with link {$link} at {$wrong}° in place of {$right}°
crank_angle-should = angles are measured counter-clockwise from the horizontal to the right
crank_angle_in_radians-done = the calculator took the angle of link {$link}, {$right}°, as {$right} radians, which are {$wrong}°
crank_angle_in_radians-should = the calculator is set to degrees
swapped-done = {$first} and {$second} seem to stand in each other's boxes
swapped-should = swap the two numbers
digits_transposed-done = {$quantity}: two digits stand in each other's place, {$written} for {$meant}
digits_transposed-should = {$meant}
decimal_slipped-done = {$quantity}: the decimal point slipped, {$written} for {$meant}
decimal_slipped-should = {$meant}
truncated-done = the numbers were cut off after their last digit
truncated-should = round the last digit up where the next is 5 or more
wrong_unit-done = {$quantity}: {$number} is the value in {$right}, not in {$wrong}
wrong_unit-should = {$number} {$right}
other_unit-done = {$quantity}: {$number} is the value in {$unit}, and no unit says so
other_unit-should = write {$unit} beside it, or the value in {$own}
unknown-done = {$quantity} is off for a reason that the values do not show; it was gone on with
unknown-should = Look at {$quantity} again
unknown_alone-done = {$quantity} alone is off: it was read, computed or written wrongly, and not gone on with
unknown_alone-should = Find {$quantity} again
unknown_first-done = {$quantity} is the first value that is off, for a reason that the values do not show
unknown_first-should = Look at it first: values that come later may follow from it


## Errors and warnings: scene


# Kinds of files.

scene-scene = scene
scene-study = study
scene-drawing = drawing
scene-style = style
scene-form = form of measured values
scene-marks = marking scheme
scene-begins_with = a {$what} begins with {$start}
scene-too_many_bytes = the {$what} has {$bytes} bytes; at most {$most} ({$mib} MiB) are read
scene-is_empty = the {$what} is empty
scene-expected_object = expected a {$what} as {$start}, found {$found}
scene-meant_key = did you mean `{$key}` by `{$other}`?
scene-add_version = add "{$key}": {$version}, the version of the {$what} format
scene-no_version = `{$key}` is missing, so this may be something other than a {$what}
scene-other_version = this program reads version {$version}, the {$what} says {$said}
scene-version_is_number = expected the number {$version}, the version of the format, found {$found}
scene-write_version = write "{$key}": {$version}

# Text that is not JSON.

scene-not_json = this is not JSON: {$what}
scene-not_json_at_all = this is not JSON
scene-text_over_lines = a text ends on the line it begins on
scene-add_quote_or_n = add the missing ", or write \n for a line break
scene-control_in_text = a text holds a tab or another control character
scene-write_t = write \t for a tab
scene-too_deep = brackets are nested deeper than {$most} levels
scene-no_comments = JSON has no comments
scene-write_note = write "note": "…", which is allowed anywhere
scene-trailing_comma = a comma stands before the closing bracket
scene-remove_comma = remove the comma
scene-leading_zero = a number does not begin with 0
scene-remove_zero = remove the leading 0
scene-comma_missing = a comma is missing here
scene-brace_open = this {"{"} is never closed
scene-add_brace = add the missing {"}"}
scene-bracket_open = this [ is never closed
scene-add_bracket = add the missing ]
scene-brace_for_value = a {"}"} stands where a value should be
scene-bracket_for_value = a ] stands where a value should be
scene-comma_for_value = a comma stands where a value should be
scene-colon_for_value = a colon stands where a value should be
scene-colon_missing = a colon is missing after this key
scene-value_missing = the value of this key is missing
scene-after_end = something stands after the end of the {$what}
scene-one_in_a_file = a file holds one {$what}, in one pair of {"{"} {"}"}
scene-single_quotes = texts stand in double quotes
scene-write_double = write "A" in place of 'A'
scene-key_needs_quotes = the key {$word} needs double quotes
scene-write_key_value = write "key": value
scene-no_number = {$word} is not a number
scene-every_number_finite = every number of a {$what} is finite; leave the key out where a value is not known
scene-not_here = {$sign} does not belong here
scene-no_value = {$word} is not a value
scene-leave_key_out = leave the key out
scene-write_true = write true
scene-write_false = write false
scene-names_in_quotes = texts and names stand in double quotes
scene-plus_sign = a number has no plus sign before it
scene-remove_plus = remove the +
scene-decimal_only = numbers are decimal
scene-digits_both_sides = a decimal point needs digits on both sides
scene-write_half = write 0.5 for .5, and 5.0 for 5.
scene-number_incomplete = this number is not complete
scene-no_escape = a \ in a text begins an escape, and this is none
scene-write_backslash = write \\ for the character \
scene-text_open = this text is never closed
scene-add_quote = add the missing "
scene-null = null is not a value here
scene-key_twice = key `{$key}` stands twice: first at line {$line}
scene-number_too_large = {$number} is too large to compute with
scene-choose_units = choose units that make it less than 1e100
scene-turns_beside_gears = {$angle} is too large for an angle beside gears: its whole turns count, and they would be lost
scene-take_turns_off = write an angle below 1e14 degrees

# Values of a wrong kind.

scene-nothing = nothing
scene-a_number = the number {$number}
scene-a_text = the text "{$text}"
scene-empty_list = an empty list
scene-list_of = a list of {$count}
scene-an_object = an object {"{"} … {"}"}
scene-unknown_key = unknown key `{$key}`
scene-the_keys_are = the keys here are {$all}
scene-unknown_word = unknown word "{$word}"
scene-write_one_of = write one of {$all}
scene-write_truth_or_one_of = write true, false or one of {$all}
scene-missing = `{$key}` is missing
scene-expected_found = expected {$expected}, found {$found}
scene-in_double_quotes = write "{$number}" in double quotes
scene-add = add {$json}
scene-add_on = add "on", the link that carries the guide, or "ground"
scene-add_length_unit = add "length": "m", "mm", "cm", "in" or "ft"
scene-add_time_unit = add "time": "s" or "min"
scene-add_speed = add "speed", along the guide
scene-points_as_one_text = write two points as one text: "AB", or "A-B" where names are longer
scene-without_quotes = write {$number} without quotes
scene-with_a_point = write {$number} without quotes and with a point
scene-or_as_rpm = write {$number} without quotes, or the speed as "rpm"
scene-in_degrees = angles are in degrees: write {$number} without quotes
scene-rpm_for_omega = write "rpm": {$number} in place of "omega"
scene-units_in_units = write {$number} without quotes; units stand in `units`, angles are in degrees
scene-two_numbers = expected two numbers [x, y], found a list of {$count}
scene-negative_size = size is {$size}; a size is not negative: turn the angle by 180 instead
scene-no_page = there is no page "{$name}"
scene-no_unit = there is no unit of length "{$name}"
scene-did_you_mean = did you mean `{$name}`?
scene-joints_out_of_scope = links are joined by pins, straight sliders (`sliders`), wheels, racks and belts (`gears`), and profiles that touch, as those of cams (`contacts`)
scene-forces_out_of_scope = loads are `mass`, `inertia` and `center` of a link, and `gravity`, `forces`, `springs` and `friction` of the scene; there are no dampers

# What a form asks for.

scene-form_asks_nothing = this form asks for nothing
scene-form_no_quantity = {$name} is no name of a quantity
scene-form_no_marks = {$marks} are no marks
scene-form_marks_from_0 = marks are 0 to {$most}
scene-no_hints = {$count} is no number of stages of a hint
scene-hints_from_0 = write 0 (no hints) to {$most} (all)
scene-form_names_quantities = write names as an empty form has them: "omega(2)", "vplan(p,b)"

# Names.

scene-a_point = a point
scene-a_link = a link
scene-no_name = {$what} has no name
scene-write_a_name = write a letter or a number between the quotes
scene-name_too_long = the name of {$what} has more than {$most} characters
scene-write_prime = write ' for a prime
scene-write_underscore = write _ in place of -, which joins two points
scene-signs_of_names = names have letters, digits, ' and _
scene-sign_in_name = the name `{$name}` of {$what} contains `{$sign}`
scene-called_note = {$what} cannot be called `note`: that key is for notes
scene-called_ground = a link cannot be called `ground`: that is the frame
scene-point_twice = point {$point} stands twice
scene-link_twice = link {$link} stands twice
scene-point_twice_in_link = point {$point} stands twice in link {$link}
scene-link_named = link {$link}
scene-point_named = point {$point}
scene-the_ground = the ground
scene-lacks_point = {$carrier} has no point {$point}; it has no points
scene-lacks_point_but = {$carrier} has no point {$point}; its only point is {$only}
scene-lacks_point_of = {$carrier} has no point {$point}; its points are {$all}
scene-lengths_key = lengths key `{$key}`
scene-along_key = along `{$key}`
scene-pair_unknown = {$key}: {$why}
scene-pair_ambiguous = {$key} can mean {$a} and {$b}, or {$c} and {$d}
scene-pair_same = {$key} names the point {$point} twice
scene-write_pair = write "{$a}-{$b}" or "{$c}-{$d}"
scene-no_link = there is no link {$link}
scene-the_links_are = the links are {$all}
scene-no_point = there is no point {$point}
scene-the_points_are = the points are {$all}
scene-name_kept = the name `{$name}` is kept for {$what}
scene-other_name = choose another name for the point
scene-image_of = the image of {$point} in the plans
scene-special_point_of = the special point of link {$link}
scene-point_under = the point of link {$link} under {$point}

# Points, ground, known motions.

scene-no_coordinates = the frame's points have no coordinates
scene-write_coordinates = write {"{"} "A": [x, y], … {"}"}; or give the coordinates of every point in "points": {"{"} … {"}"}
scene-other_coordinates = point {$point} has other coordinates in `points`
scene-name_only = name it only in a list: "ground": ["A", …]
scene-not_in_points = point {$point} has no coordinates in `points`
scene-add_to_points = add "{$point}": [x, y] to `points`
scene-on_no_link = point {$point} is on no link and not on the ground
scene-name_in_link = name it in the `points` of a link, or remove it
scene-known_is_drawn = known motions belong to a drawn configuration
scene-points_or_drive = give the coordinates of every point in "points": {"{"} … {"}"}, or drive a link
scene-ground_moves_not = point {$point} is on the ground, which does not move
scene-remove_from_ground = remove it here or from `ground`
scene-motion_twice = the motion of point {$point} is given twice: by {$first} and by {$second}
scene-motion_already = the motion of point {$point} is given already, by {$by}
scene-keep_one = keep one of them
scene-motion_of_link = the `motion` of link {$link}
scene-drive_of_link = the drive of link {$link}
scene-drive_of_slider = the drive of slider {$link}
scene-drive_of_its_slider = the drive of its slider
scene-drawn_needs_no_near = a drawn configuration needs no `near`
# Why a drawn configuration refuses a key.
scene-remove_it_drawn = remove it: the drawing, `points`, gives it already
scene-remove_drawn = remove `{$key}`: the drawing, `points`, gives it already
scene-near_one_number = {$key} is one number, in degrees, not two
scene-near_two_numbers = point {$point} needs two numbers [x, y], found one

# Links and their drives.

scene-no_links = a mechanism has at least one link
scene-lengths_and_shape = link {$link} has both `lengths` and `shape`
scene-drive_and_motion = link {$link} has both a drive and a known motion
scene-two_angles = link {$link} has an angle and its drive has one too
scene-link_motion_is_drawn = link {$link}: a known `motion` belongs to a drawn configuration
scene-points_or_drive_link = give the coordinates of every point in "points": {"{"} … {"}"}, or drive the link
scene-link_is_drawn = link {$link} has `{$key}`, but this scene is a drawn configuration
scene-remove_or_lengths = remove `{$key}`: the drawing, `points`, gives it already; or remove `points` and give `ground` its coordinates
scene-no_points = link {$link} has no `points`
scene-too_many_points = link {$link} has {$count} points, which lengths do not fix
scene-give_shape = give coordinates in the link's own frame: "shape": {"{"} "{$a}": [x, y], "{$b}": [x, y], … {"}"}
scene-no_distance = link {$link} has the points {$from} and {$to}, but not their distance
scene-three_lengths = link {$link} has three points, which need three lengths; that of {$from} and {$to} is missing
scene-add_lengths = add "lengths": {"{"} "{$key}": … {"}"}, or give a `shape`
scene-add_to_lengths = add "{$key}": … to its lengths
scene-length_twice = the length {$key} of link {$link} is given already, as {$first}
scene-length_zero = length {$key} is 0: {$from} and {$to} would be one point
scene-one_name_or_length = use one name for both, or give a positive length
scene-length_negative = length {$key} is {$value}; a length is positive
scene-no_triangle = link {$link}: lengths {$lengths} cannot form a triangle: {$one} + {$other} < {$long}
scene-shape_empty = the shape of link {$link} has no points
scene-add_or_without_points = add it to `points`, or leave `points` out
scene-shape_lacks = the shape of link {$link} does not say where {$point} is
scene-add_place = add "{$point}": [x, y]
scene-zero_length = link {$link} has {$first} and {$second} in one place: a zero-length link
scene-one_name_or_move = use one name for both, or move one
scene-drive_is_drawn = the drive of link {$link} has `{$key}`, but this scene is a drawn configuration
scene-omega_and_rpm = the drive of link {$link} has both `omega` and `rpm`
scene-drive_without_speed = the drive of link {$link} has no speed
scene-add_omega = add "omega" (radians per unit of time) or "rpm"; for a sliding link "speed"
scene-pushes_and_turns = the drive of link {$link} both pushes and turns
scene-push_or_turn = a drive has `position`, `speed`, `acceleration`, or `angle`, `omega`, `alpha`
scene-push_without_speed = the drive of link {$link} has no `speed`

# Sliders.

scene-slides_on_own = point {$point} is a point of {$carrier}, so it cannot slide on it
scene-other_sliding_name = use another name for the point that slides
scene-no_frame = coordinates need a frame, and {$carrier} has no `shape`
scene-point_or_shape = name a point of {$carrier}, or give the link a `shape`
scene-point_or_without = name a point of {$carrier}, or leave `through` out: the guide passes through the slider's point
scene-no_direction = a direction of size zero points nowhere
scene-give_direction = give [dx, dy] or degrees
scene-no_axis = {$carrier} has no points and so no axis to count degrees from
scene-give_drawn_direction = give the direction as drawn: "along": [dx, dy]
scene-degrees_unquoted = write {$number} without quotes for degrees
scene-one_place = {$from} and {$to} are in one place, so they give no direction
scene-two_drives = link {$link} has a drive, and so has its slider
scene-which_slider = link {$link} has two sliders, and its drive does not say which one it pushes
scene-drive_into_sliders = move the drive into one of the entries of `sliders`
scene-pushed_without_slider = link {$link} is pushed by its drive, but it has no slider
scene-add_slider = add an entry to `sliders` with this `link`, or turn the link with `omega`
scene-idle_link = link {$link} has no points, and nothing slides on it
scene-remove_or_name = remove it, or name its points
scene-guide_nowhere = nothing says where the guide is: {$carrier} has no points
scene-add_through = add "through": [x, y], a place on the guide
scene-name_on_guide = name a point of link {$link} that is on the guide
scene-turned_is_drawn = `turned` has no place in a drawn configuration
scene-position_is_drawn = this drive has `position`, but this scene is a drawn configuration
scene-nothing_slides = this slider does not say what slides
scene-give_link_or_pin = give "link" and "at", the link and its point on the guide; or "pin"
scene-pin_and_link = `pin` stands in place of `link` and `at`, not beside them
scene-block_or_pin = keep `link` and `at` for a block, `pin` for a bare pin
scene-add_at = add "at", the point of link {$link} that is on the guide
scene-add_link_or_pin = add "link", the sliding link; or write "pin": "{$point}" for a pin in a slot
scene-slides_on_itself = link {$link} cannot slide on itself
scene-travel_is_drawn = a drawn configuration has one position, so its guides have no ends
scene-travel_backwards = travel goes from {$low} to {$high}
scene-lower_end_first = give the lower position first, as "travel": [20, 80]
scene-travel_has_two_ends = a guide has two ends, not {$count}

# Gear pairs.

scene-two_wheels = a pair has two wheels, not {$count}
scene-meshed_twice = {$first} and {$second} mesh twice
scene-remove_one_mesh = remove one of the two pairs; of two rims on one link each meshes with another wheel
scene-no_train = no wheels mesh: there is no train for Willis' table
scene-add_gears = leave it out, or give `gears`
scene-meshes_with_itself = {$wheel} cannot mesh with itself
scene-wheel_carries_itself = {$wheel} is a wheel of this pair and cannot carry it
scene-name_the_carrier = `on` names the link on whose pins both wheels turn, or "ground"
scene-wheels_on_one_axis = {$first} and {$second} turn about one axis, so they cannot mesh
scene-mesh_over_a_wheel = give a pair for each place where teeth touch: sun and planet, planet and ring
scene-phase_is_drawn = `phase` has no place in a drawn configuration
scene-no_pressure = a pressure angle of {$degrees}° is none of teeth
scene-usual_pressure = usual is 20; from 0 to {$most}
scene-no_teeth = {$teeth} is no number of teeth
scene-teeth_up_to = give a whole number up to {$most}, negative for a ring with inner teeth; of wheels without teeth whole numbers in the ratio of their radii
scene-two_rings = two rings with inner teeth cannot mesh
scene-one_ring = a ring meshes with a wheel inside of it, whose teeth are positive
scene-ring_of_the_same_size = ring and wheel have the same number of teeth: they would be one
scene-ring_smaller = the ring has {$ring} teeth, the wheel in it {$wheel}
scene-ring_larger = a ring has more teeth than the wheel inside of it
scene-wheel_not_on_carrier = {$wheel} has no pin on {$carrier}, which carries the pair
scene-pin_the_wheel = name the wheel's centre on both: a point of the wheel and of the carrier
scene-two_wheel_pins = {$wheel} and {$carrier} have both {$first} and {$second} in common, so they are rigid
scene-one_wheel_pin = a wheel turns about one point of its carrier
scene-two_racks = two racks cannot mesh
scene-one_rack = a rack meshes with a wheel; write the wheel's number of teeth in place of one "rack"
scene-rack_without_slider = nothing lets {$rack}, the rack, slide against {$carrier}, which carries the wheel
scene-rack_not_parallel = {$rack}, the rack, and {$carrier}, which carries the wheel, slide along the ground in two directions
scene-let_rack_slide = give a slider with the rack on the carrier, or with the carrier on the rack; or one of each on the ground, along parallel guides
scene-teeth_of_pinion = give a whole number from 1 to {$most}: a wheel on a rack has its teeth outside
scene-no_radius = {$radius} is no radius
scene-give_radius = give the radius of the wheel's pitch circle, a length above 0
scene-give_larger_radius = give the radius of the wheel's pitch circle, in the scene's unit of length and not below {$least}
scene-radius_without_rack = `radius` belongs to a wheel on a rack or with a belt: other wheels have their radii from the distance of their centres
scene-position_without_rack = `position` belongs to a wheel on a rack
scene-give_phase = the angle of one wheel against another is `phase`
scene-phase_of_rack = `phase` belongs to two wheels: a rack has no angle
scene-give_position_of_rack = `position` says where the rack is when the wheel stands at 0
scene-belt_on_rack = no belt runs around a rack
scene-belt_without_teeth = a belt has no pressure angle
scene-teeth_of_belt = give a whole number from 1 to {$most}: teeth of a chain's wheels, or whole numbers in the ratio of the radii
scene-no_forces_of_belts = how hard a belt is strained is not known, so forces are not computed of mechanisms with belts
scene-remove_belts_or_loads = remove masses, `gravity`, `forces` and `springs` from the scene, or its belts
scene-two_touch = a contact is between two bodies, not {$count}
scene-touches_itself = {$body} cannot touch itself
scene-through_without_face = `through` is a place on a flat profile, but the second one is round
scene-give_face = give the direction of the flat profile as `along`, or leave `through` out
scene-one_center_of_face = a round profile on a flat one has one centre of curvature, not {$count}
scene-face_has_no_center = name the centre of the first profile alone; where both are round leave `along` out
scene-two_centers = two round profiles have two centres of curvature, not {$count}
scene-center_or_face = name a point of each body; of a flat profile give the direction as `along`
scene-center_on_body = a centre of curvature is a point of the body whose profile it belongs to, in the order of `links`
scene-center_of_both = a centre of curvature is a point of both, {$first} and {$second}: they would be joined there
scene-face_without_link = a pin on a flat profile needs no equivalent link, so there is none to name
scene-flat_roller = a roller is round, but `along` says that the second profile is flat
scene-give_radii = give the radii of curvature in the order of `centers`, as "radii": [40, 10]
scene-radii_as_centers = as many radii as centres are needed: {$wanted}, not {$count}
scene-hollow_on_face = a hollow profile does not touch a flat one
scene-turn_face = the radius is positive; for the other side of the face turn `along` by 180
scene-two_hollows = two hollow profiles cannot touch
scene-hollow_and_round = only the radius of a hollow profile is negative, and the other one lies in it
scene-give_roller = the second radius is that of the roller
scene-centers_in_one_place = with these radii both centres are in one place
scene-hollow_smaller = a round profile of radius {$round} does not lie in a hollow one of radius {$hollow}
scene-hollow_larger = the hollow profile has the larger radius, and stands with a minus
scene-radii_not_as_drawn = {$first} and {$second} are drawn {$distance} apart, but the radii make {$radii}
scene-radii_as_drawn = the sum of the radii is the distance of the centres; a drawing does without radii
scene-face_not_as_drawn = {$center} is drawn {$distance} from the flat profile, but the radius is {$radius}
scene-face_as_drawn = the radius is the distance from the centre of curvature to the flat profile; a drawing does without it
scene-face_on_other_side = {$center} is drawn on the wrong side of the flat profile: the first body lies to the right of `along`
scene-face_the_other_way = turn `along` by 180, or name its points in the other order
scene-equivalent_taken = the equivalent link would be called {$link}, but there is a link of that name
scene-name_equivalent = give it another `name`

# Masses and loads.

scene-mass_and_weight = link {$link} has a mass and a weight
scene-without_mass = link {$link} has `{$key}`, but no mass
scene-no_unit_of_mass = link {$link} has a mass, but the scene has no unit of mass
scene-add_unit_of_mass = add `"mass": "kg"` to `units`
scene-weight_without_gravity = link {$link} has a weight, but the scene has no gravity, so its mass is not known
scene-add_gravity = add `"gravity": [0, -9810]` (in mm and s), or give a mass
scene-no_center_of_mass = link {$link} has a mass, but no centre of mass
scene-add_center = add `"center"`: a point as "C", coordinates [x, y] in the frame of the link, or a distance along its axis
scene-below_zero = `{$key}` is {$value}, below zero
scene-no_unit_of_force = there are loads, but the scene has no unit of force
scene-add_unit_of_force = add `"force": "N"` to `units`
scene-distance_is_drawn = a distance along the axis of link {$link}, but this scene is a drawn configuration
scene-place_as_drawn = give the coordinates [x, y] as drawn
scene-neither_force_nor_couple = a load is a force, a couple, or both
scene-force_nowhere = a force acts at a place
scene-add_at_of_force = add `"at"`: a point as "C", coordinates [x, y] in the frame of the link, or a distance along its axis
scene-couple_turns = a couple is the same whether it turns or not
scene-turns_is_drawn = in a drawn configuration a force is as it is drawn
scene-spring_within_link = both ends of the spring are on one body, so it pulls nothing
scene-spring_between_links = name two bodies, as [["3", "C"], ["ground", "A"]]
scene-no_point_of_ground = the ground has no point {$point}
scene-distance_on_ground = the ground has no axis; give a point or coordinates [x, y]
scene-load_name = `{$name}` cannot be the name of a load: a name is not empty and has no ( ) or comma
scene-load_name_twice = two loads have the name {$name}
scene-other_load_name = choose another name for the load
scene-over_what = a load cannot change over {$name}
scene-over_angle_or_position = give the angle of a link as "angle(1)", or the position of a slider as "position(3/ground)"
scene-over_short = a table has at least two lines
scene-over_two_lines = give pairs of a place and a factor, as [[0, 0], [90, 1500], [180, 0]]
scene-over_back = {$after} stands after {$before}
scene-over_in_order = order the lines of the table by their first number
scene-over_more_than_a_turn = a table over an angle repeats with every turn, and this one is longer than that
scene-over_one_turn = give 360° at most
scene-spring_ends = a spring has two ends, not {$count}
scene-pin_and_guide = friction is in a pin or in a guide, not in both
scene-friction_nowhere = friction is in a joint
scene-pin_or_guide = add `"pin": "B"` for the pin of a point, or `"guide": "3/ground"` for the guide of a slider
scene-friction_without_radius = friction at pin {$point} has a moment that grows with the journal, whose radius is missing
scene-add_radius = add `"radius"`, that of the journal, in the scene's unit of length
scene-guide_has_no_radius = a guide has no journal
scene-guide_has_no_pin = a guide has no pin that could be fixed in a link
scene-friction_twice = {$joint} has friction twice
scene-coefficient_and_angle = friction has a coefficient and an angle, which say the same
scene-no_coefficient = how much friction there is is missing
scene-angle_of_friction = an angle of friction of {$angle}° is not below 90°
scene-below_right_angle = common angles are 3° to 30°, as those of coefficients 0.05 to 0.6

# The figure.

scene-scale_is = `{$key}` is {$what}
scene-scale_too_large = {$scale}; numbers are at most {$most}
scene-scale_not_positive = {$scale}; a scale, in units per millimetre of paper, is positive
scene-next_scale = leave it out for the next scale that fits
scene-no_panels = a figure without panels shows nothing
scene-name_panels = name some of {$all}, or leave `panels` out
scene-panel_twice = this panel stands twice
scene-step_from_one = steps of the construction are numbered from 1
scene-steps_listed = `kinegon steps` lists them; leave `step` out for the finished figure
scene-frame_is_link = link {$link} has this name
scene-other_frame = give the frame the other number, or a text of your own in `labels`: {"{"} "ground": "…" {"}"}
scene-ghosts_between = the number of ghosts is from {$least} to {$most}, not {$count}
scene-drawn_has_no_path = a drawn configuration cannot be moved, so point {$point} has no path
scene-drawn_has_no_centrodes = a drawn configuration cannot be moved, so link {$link} has no centrodes
scene-drawn_has_no_ghosts = a drawn configuration cannot be moved, so there are no other positions to draw
scene-lengths_and_drive = a scene with `lengths` or `shape` and a drive with its `angle` or `position`
scene-at_contact_alone = the profiles that touch are known at their contact alone, so there is no other position
scene-say_circular = say "circular": true in the contact, if both profiles are circles about these centres, or a circle and a straight line
scene-no_drive_no_path = there is no drive to move the mechanism, so point {$point} has no path
scene-no_drive_no_centrodes = there is no drive to move the mechanism, so link {$link} has no centrodes
scene-no_drive_no_ghosts = there is no drive to move the mechanism, so there are no other positions to draw
scene-give_drive = give a link a "drive"
scene-moving_points = points that move are {$all}
scene-ground_has_no_path = point {$point} is on the ground and has no path
scene-name_of_construction = {$name} is a name of the construction, and no point of a link
scene-no_center = "{$name}" names no instant centre
scene-name_center = a centre is named by two links, as P(1,3), or P(2,ground) with the frame
scene-center_twice = the centre {$name} stands twice
scene-ground_is_at_rest = point {$point} is on the ground and does not move

# How large a scene may be.

scene-a_scene = a scene
scene-a_figure = a figure
scene-a_figure_with_steps = a figure with steps
scene-a_drawing_judged = a drawing to be checked
scene-by_hand = a construction by hand
scene-too_many_links = {$what} has at most {$most} links, and here are {$count}
scene-too_many_points_in = {$what} has at most {$most} points, and here are {$count}
scene-too_many_loads = {$what} has at most {$most} forces, couples and springs, and here are {$count}
scene-divide_mechanism = divide the mechanism: what hangs on the drives alone can be a scene of its own
scene-replace_loads = replace loads on the same link by their resultant

# What stands after "expected": types say it in English to serde, which hands over nothing but text.

scene-expects_two_numbers = two numbers [x, y] or {"{"} "size": …, "angle": … {"}"}
scene-expects_place_on_link = two numbers [x, y] or one number, the distance along the axis
scene-expects_rough_place = two numbers [x, y], or for an "angle(…)" one number, its degrees
scene-expects_point_or_place = the name of a point in double quotes, or its coordinates [x, y]
scene-expects_direction = two points as "BE", or a number of degrees, or [dx, dy]
scene-expects_vector = a vector as {"{"} "size": 150, "angle": 210 {"}"}
scene-expects_link = a link as {"{"} "points": ["A", "B"], … {"}"}, or a list of its points ["A", "B"]
scene-expects_link_place = the name of a point in double quotes, its coordinates [x, y], or a distance along the link's axis
scene-expects_table_line = two numbers, a place and a factor, as [90, 1500]
scene-expects_load = a load as {"{"} "on": "3", "at": "C", "force": [-150, 0] {"}"}
scene-expects_spring = a spring as {"{"} "between": [["3", "C"], ["ground", "A"]], "rate": 1.5, "length": 120 {"}"}
scene-expects_spring_end = an end of a spring as ["3", "C"], a link and a place on it
scene-expects_friction = friction as {"{"} "pin": "B", "coefficient": 0.1, "radius": 12 {"}"} or {"{"} "guide": "3/ground", "coefficient": 0.1 {"}"}
scene-expects_a_link = a link
scene-expects_ground = the frame's points as {"{"} "A": [x, y], … {"}"}, or their names as ["A", …]
scene-expects_drive = a drive as {"{"} "angle": 70, "omega": -1 {"}"}
scene-expects_push = a drive as {"{"} "position": 40, "speed": 10 {"}"}
scene-expects_motion = a motion as {"{"} "velocity": [x, y], "acceleration": [x, y] {"}"}
scene-expects_link_motion = a motion as {"{"} "at": "B", "velocity": [x, y], "omega": 1 {"}"}
scene-expects_slider = a slider as {"{"} "link": "3", "at": "D", "on": "2", "along": "BE" {"}"}
scene-expects_gear = a gear pair as {"{"} "mesh": ["1", "2"], "teeth": [20, 40], "on": "ground" {"}"}
scene-expects_contact = a contact as {"{"} "links": ["1", "3"], "centers": ["K", "C"], "radii": [40, 10] {"}"}
scene-expects_teeth = a number of teeth, or "rack"
scene-expects_scene = a scene as {"{"} "kinegon": 1, … {"}"}
scene-expects_figure = a figure as {"{"} "panels": ["scheme", "velocity"] {"}"}
scene-expects_centers = "all", or centres as ["P(2,ground)", "P(1,3)"]
scene-expects_units = units as {"{"} "length": "mm", "time": "s" {"}"}
scene-expects_truth_or_paper = true, false or "paper"
scene-expects_truth_or_unit = true, false or a unit of length
scene-expects_truth = true or false
scene-expects_whole_number = a whole number from 1 to 65535
scene-expects_number = a number
scene-expects_text = a text in double quotes
scene-expects_list = a list [ … ]
scene-expects_object = an object {"{"} … {"}"}


## Errors and warnings: mechanism

mechanism-nothing_to_solve = nothing to solve: every link's motion is given
mechanism-add_links = add links between the driven links, the known points and the ground
mechanism-over_no_slider = there is no slider {$name} over whose position a load could change
mechanism-over_no_zero = the position of {$name} counts from no point, so that no load can change over it
mechanism-friction_no_slider = there is no slider {$name} in whose guide there could be friction
mechanism-the_sliders_are = the sliders are: {$names}
mechanism-friction_no_joint = no links are joined at {$point}, so nothing rubs there
mechanism-friction_of_contact = {$joint} stands for profiles that touch, which rub where they touch and not there
mechanism-no_friction_of_contact = friction of contacts is not known: leave it out
mechanism-pin_of_several = pin {$point} joins several links, {$links}: its friction depends on the one in which the pin is fixed
mechanism-write_fixed_in = write `"fixed_in": "{$link}"`, or another of these
mechanism-pin_of_two = pin {$point} joins two links: its friction is the same in whichever of them it is fixed
mechanism-leave_fixed_in_out = leave out `fixed_in`
mechanism-angle_of_another = the angle of link {$link} cannot stand in place of the drive's: it does not change with that drive
mechanism-angle_in_drive = say in the drive where it stands, or give the angle of a link that turns with it
mechanism-mirror_image = link {$link}: its lengths fit a triangle and its mirror image; the counter-clockwise one {$points} is taken. Give rough places of its points in `near` to choose
mechanism-singular = links {$links} have no definite motion in any position: a group of class {$class} with its prismatic joints as in {$pattern} is singular by its structure
mechanism-make_revolute = make one of the prismatic joints revolute
mechanism-train_without_ratio = the teeth do not tell the angles of links {$links}: the wheels turn alike whatever the arm does, so nothing drives it
mechanism-other_teeth = give other numbers of teeth, so that the basic ratio of the train is not 1, or drive the arm
mechanism-two_radii = wheel {$link} with {$teeth} teeth would have two pitch radii, {$first} and {$second}: check teeth and centre distances
mechanism-belt_without_room = wheels {$first} and {$second}, with radii {$radii}, are {$distance} apart: a belt cannot run around them like that; check radius and distance
mechanism-along_its_x_axis = link {$link}: the x axis of its shape lies along the guide, not the line {$points}, which is parallel to the guide in the coordinates of the shapes. If both shapes are taken from one drawing, add "turned": {$turned}
mechanism-off_guide = slider {$slider} is not on its guide: it stands at {$position}, and the guide goes from {$low} to {$high}; what follows from it does not hold here
mechanism-holds_here_alone = the contact of {$first} and {$second} is known in this position alone: its equivalent linkage gives velocities, accelerations and forces here, and nothing elsewhere

# Too few or too many constraints.

mechanism-one_link = link {$link}
mechanism-several_links = links {$links}
mechanism-one_free_motion = 1 free motion
mechanism-free_motions = {$count} free motions
mechanism-can_still_move = {$links} can still move ({$free} left)
mechanism-add_a_drive = add 1 drive or a joint there
mechanism-add_drives = add {$count} drives or a joint there
mechanism-one_constraint = 1 constraint
mechanism-constraints = {$count} constraints
mechanism-cannot_move = {$links} cannot move as driven ({$surplus} too many)
mechanism-take_away = take a drive or a joint away there
mechanism-one_drive = 1 drive
mechanism-drives = {$count} drives
mechanism-mobility = mobility 3·{$links} − {$constraints} = {$mobility} with {$drives}

# Drives.

mechanism-one_ground_point = link {$link} is driven, so it must have one point on the ground; it has {$count}
mechanism-list_pivot = list the point about which it turns in `ground` and among the link's points
mechanism-driven_link = link {$link}
mechanism-driven_slider = slider {$slider}
mechanism-two_angles = links {$first} and {$second} both give an angle; that of one link can stand in place of a drive's
mechanism-remove_one = remove one of them; approximate angles stand in `near`
mechanism-angle_without_drive = link {$link} gives an angle, but no link has a drive
mechanism-add_drive = add a drive with `omega` to the link that turns about a ground point
# `key` is the word of the scene for where the drive stands.
mechanism-angle_beside = link {$link} gives an angle, but the drive of {$driven} gives its {$key} already
mechanism-keep_one = keep one of them; an approximate angle stands in `near`
mechanism-angle_beside_all = link {$link} gives an angle, but every drive says already where it stands
mechanism-two_open_drives = the drives of {$first} and {$second} do not say where they stand; the angle of link {$link} stands in place of one only
mechanism-add_to_one = add "{$key}" to one of them
mechanism-open_drive = the drive of {$driven} gives no `{$key}`
mechanism-add_angle = add "angle": degrees from +x to the link's axis; or give another link's `angle` in its place
mechanism-add_position = add "position": its distance along the guide from `through`; or give a link's `angle` in its place

# Angles that look like radians.

mechanism-angle_of_link = the angle of link {$link}
mechanism-guide_of = the guide of {$slider}
mechanism-near_angle_of = `near` for angle({$link})
mechanism-radians = {$what} is taken as {$angle}°, which looks like radians: angles are in degrees, so {$degrees} if that is meant

# Places far away.

mechanism-far_origin = the origin lies {$far} from a mechanism of about {$size}: of places with 16 digits, {$digits} are left for its shape. Let the origin be near


## Errors and warnings: position

# `at` is empty, or where the drives stand.
position-no_mode = links {$links} cannot be assembled{$at}: {$miss}
position-other_angle_or_lengths = another drive angle, or other lengths
position-angle_from_to = from {$from}° to {$to}°
position-angle_within_or_lengths = a drive angle {$ranges}, where it can be assembled, or other lengths
# Begins with a space: it stands behind names.
position-at_value = {" "}at {$quantity} = {$value}
position-longer = with everything else closed, {$leg} would have to be {$by} longer
position-shorter = with everything else closed, {$leg} would have to be {$by} shorter
position-any_direction = its outer joints lie in one place and its lengths are equal, so it can turn there by any angle
position-never_meet = its guides and lengths never meet
position-parallel_guides = links {$links} cannot be assembled: the two guides that meet at link {$link} are parallel
position-turn_one = `turned` of one of its sliders, the degrees from the guide to the link's axis, sets them at an angle
position-too_large = lengths of about {$size} are too large to assemble from: their fourth powers leave the range of numbers
position-too_small = lengths of about {$size} are too small to assemble from: their fourth powers leave the range of numbers
position-other_unit = another unit of length
position-no_such_mode = there is no assembly mode {$mode}: there are {$count}
position-modes_listed = `kinegon modes` lists them
position-too_many_modes = assembly mode {$mode} is too far on: counting was stopped after {$count}
position-rough_places_choose = rough places in `near`, which choose without counting
position-too_much_work = no way to assemble all links was found: the first ones can be put together in too many ways
position-rough_places = rough places of their points in `near`
position-not_found = no way to assemble links {$links}{$at} was found: {$tried}
position-rough_places_or_other = rough places of their points in `near`, another drive angle, or other lengths
position-moves = links {$links} may move while the drives stand still, although their mobility is 0: none of the assemblies found is an assembly mode
position-none_closes = none of {$starts} starts closes
position-none_closes_but = none of {$starts} starts closes, the nearest leaves a gap of {$gap} of the mechanism's size

# Warnings.

position-unproven = `near` leaves too many assemblies open to compare them all, and the one taken may not be the nearest: give rough places of more points in it
position-at_least = at least {$count}
position-far_off = `near` is {$distance} away (root mean square) from the closest of {$count} assembly modes, more than half the mechanism's size {$size}: check its coordinates
position-point_far_off = point {$point} is at [{$x}, {$y}], {$off} away from its place in `near`, in the closest of {$count} assembly modes: check its coordinates
position-not_chosen = links {$links} can be assembled in {$count} ways and `near` is not given, so mode 1 is taken: {$listed}
position-searched = links {$links} form a group of higher class: its assembly modes were found by a search, and there may be more; how many there can be is not known
position-searched_of = links {$links} form a group of higher class: {$found} of its assembly modes were found by a search, and there may be more, but {$most} at most
position-may_move = links {$links} may move while the drives stand still, although their mobility is 0: besides the assembly modes there is a whole curve of positions
position-nearly_flat = link {$link}: its points lie nearly on a line, and `near` fits its triangle and the mirror image almost equally well; the nearer one is taken. Give its `shape`, or places in `near` with more digits, to choose


## Errors and warnings: motion

motion-singular = links {$links} are in a singular position: {$reason} (condition {$condition})
motion-singular_exactly = links {$links} are in a singular position: {$reason} (exactly)
motion-at_limit = limit position at {$place}: links {$links} can go no further, their rates grow without bound: {$reason}
motion-at_change = change point at {$place}: links {$links} could go on in another mode too, so their rates are not determined: {$reason}
motion-move_a_joint = another crank angle, or move one of these joints off the common line or point
motion-overflow = links {$links}: a distance, a velocity or an acceleration is too large to be represented
motion-larger_units = larger units of length, or slower drives
motion-near_singular = links {$links} are near a singular position (condition {$condition}): coordinates of 16 digits determine about {$digits} digits of their rates
motion-near_limit = links {$links} are at a limit position or next to one (condition {$condition}): lengths and angles of 16 digits determine about {$digits} digits of their rates

# Why a position is singular.

motion-no_definite_motion = its loops have no definite motion
motion-in_one_line = {$first} and {$second} lie in one line
motion-parallel = the lines {$lines} are parallel
motion-in_one_point = the lines {$lines} meet in one point
motion-normal_to_guide = through {$through} normal to the guide at {$at}
motion-at_infinity = at infinity (guides at {$first} and {$second})


## Errors and warnings: accuracy

accuracy-unproved = links {$links}: nothing is proved of their position or motion, so their numbers have no stated error
accuracy-pulls = the profiles of contact {$contact} would have to pull at each other here: they part, unless something holds them together
accuracy-unbounded = {$names}: no bound of the error can be given, as what they are read from may be zero, or lines parallel
accuracy-at_limit = limit position at {$place}: links {$links} can go no further, their rates grow without bound, so their numbers have no stated error
accuracy-at_change = change point at {$place}: links {$links} could go on in another mode too, so their rates are not determined and their numbers have no stated error


## Errors and warnings: quantity

quantity-no_quantity = `{$name}` is no quantity; known forms: omega(2) alpha(2) omega(2/1) alpha(2/1) i(3,1) rpm(2) angle(2) x(D) y(D) v(D) a(D) v(D/G) a(D/G) a_n(D/G) a_t(D/G) a_c(3/2) position(3/2) v_r(3/2) a_r(3/2) L(B,S3) vplan(b,s3) aplan(n_b3,s3) P(1,3) W(2) G(2) d_i(2) rho(D) R(B,2) R_n(B,2) R_t(B,2) N(3/2) M(3/2) h(3/2) T(1) F(3/2) F_i(2) M_i(2) a_cm(2) moment(F1,S3) power(F1) shaking shaking(A); vectors also with .x .y .size .angle, plan segments with /mu
quantity-no_link = `{$quantity}`: there is no link `{$name}` here
quantity-no_slider = `{$quantity}`: there is no slider `{$name}` here
quantity-no_point = `{$quantity}`: there is no point `{$name}` here
quantity-no_load = `{$quantity}`: there is no load `{$name}` here
quantity-no_plan_point = `{$quantity}`: there is no plan point `{$name}` here
quantity-did_you_mean = {$message}; did you mean `{$name}`?
quantity-no_value = `{$quantity}` has no value here: {$why}
quantity-on_paper = a length on paper belongs to the figure of one position
quantity-without_mu = the name without `/mu`
quantity-no_accelerations = accelerations were not asked for
quantity-no_axis = the link has no axis
quantity-no_zero = the guide has no point to count from
quantity-no_plan_no_scale = the figure has no such plan, so no scale
quantity-scale_too_small = the scale is too small for it
quantity-no_construction = there is no construction
quantity-at_infinity = the special point lies at infinity
quantity-not_on_one_link = the two points are not on one link
quantity-no_plan = there is no such plan
quantity-no_force_plan = there is no force plan: the figure needs the panel "forces"
quantity-two_polygons = its ends are corners of two polygons, which stand side by side anyhow
quantity-routes_differ = polygons and equations of equilibrium differ by more than both allow
quantity-no_way = no forces with names of their own lead from one of these corners to the other; ask for the force itself, as R(B,2) or R_n(B,2)
quantity-centre_at_infinity = the centre lies at infinity, and has a direction alone: `.angle`
quantity-centre_at_place = the centre lies at a place: `.x`, `.y`
quantity-rest_on_another = the links rest on one another
quantity-link_turns_not = the link does not turn
quantity-ratio_to_rest = `{$link}` does not turn, so that no ratio to it can be given
quantity-path_is_straight = the path is straight there, or the point is at rest
quantity-place_has_no_size = `{$name}` is a place, which has no size; ask for its `.x` or `.y`
quantity-no_loads = the scene has no masses, forces or springs
quantity-no_mass = that link has no mass
quantity-no_inertia = inertia is left out: `"analysis": "static"`
quantity-no_line_of_joints = that link has not two joints there, whose line would be meant
quantity-no_normal_force = no force across the guide
quantity-no_line_of_action = the force has no line of action here, or none that runs at a finite distance
quantity-not_driven = it is not driven
quantity-not_at_pin = that link has no joint at that pin
quantity-no_forces = its loads leave the range of numbers, the position is singular, or friction locks it
quantity-nowhere_in_range = it has none at any position of the range
quantity-no_scale_in_table = a table has no scale


## Errors and warnings: forces

forces-spring_without_direction = the ends of spring {$spring} meet in this position, so that its force has no direction: no forces are shown
forces-friction_locks = friction locks the mechanism in this position: no drive moves it this way, so no forces are shown
forces-friction_at_rest = at rest, friction may be anything up to its limit: it counts as nothing in {$joints}, and the stated errors allow all of it
forces-friction_leaves_open = at rest, friction may be anything up to its limit, and that of {$joints} leaves open what joints carry: no forces are shown


## Errors and warnings: cycle

cycle-drawn = a drawn configuration cannot be moved: it has no lengths
cycle-lengths_and_drive = a scene with `lengths` or `shape` and a drive with its `angle` or `position`
cycle-at_contact = the profiles that touch are known at their contact alone, so the mechanism cannot be moved
cycle-say_circular = "circular": true in the contact, if both profiles are circles about these centres, or a circle and a straight line
cycle-off_guide = slider {$slider} is not on its guide here, so nothing moves it
cycle-on_guide = begin where it is within its `travel`
cycle-other_kind = mechanism {$number} is not of the kind of mechanism 0
cycle-same_kind = the same links, joints and drives in the same order; only lengths, places and drives may differ
cycle-no_drive = there is no drive to move
cycle-give_drive = give a link a "drive"
cycle-no_such_drive = there is no drive `{$name}`; the drives are: {$known}
cycle-singular = links {$links} are in a singular position at {$at}, so which way they go on is not decided
cycle-at_limit = limit position at {$place}: links {$links} can go no further, their rates grow without bound; which of two ways they come back is not decided
cycle-at_change = change point at {$place}: links {$links} could go on in another mode too; which way they go on is not decided
cycle-other_position = a scene at another position of the drive; the sweep finds its way from there
cycle-out_of_reach = the range from {$from} to {$to} cannot be reached: {$stop}
cycle-within_reach = a range that holds a part of {$low} to {$high}
cycle-no_vector = `{$name}` is no vector
cycle-vectors = v(D), v(D/G), a(D), a_n(D/G), a_t(D/G), a_c(3/2) with names of this scene
cycle-no_path = `{$name}` is no point of a link that moves, so it has no path
cycle-not_finite = the ends of the range must be finite numbers
cycle-too_many_turns = the range reaches further than a hundred turns
cycle-too_far = the range reaches further than a hundred times the mechanism's size
cycle-values_between = values between {$low} and {$high}
cycle-no_range = the range of {$quantity} is not given
cycle-both_ends = both --from and --to: this slider has no full turn and no two ends
cycle-no_step = the step cannot be {$step}
cycle-distance_of_rows = the distance from one row to the next, as 1
cycle-step_leads_away = a step of {$step} leads away from the end of the range
cycle-positive_step = a positive step; its sign follows from the range
cycle-too_many_steps = there are more than {$most} steps of {$step} from {$from} to {$to}
cycle-larger_step = a larger step
cycle-no_room = from {$from} to {$to} there is no room for a curve
cycle-table_too_long = the table would have {$rows} rows of {$columns} numbers
cycle-sweep_or_fewer = write it with `kinegon sweep`, or name fewer quantities in the scene's `want`
cycle-more_room = a range with more room between --from and --to


## Errors and warnings: editing

editing-no_object = a scene is an object {"{"} … {"}"}
editing-no_entry = this list has {$count} entries, and no {$key}
editing-no_room = there is no place for {$key} here
editing-not_all = a scene cannot be removed from its text
editing-point_twice = point {$point} stands twice in the new link
editing-no_points = a new link has no points
editing-name_one = name at least one
editing-point_on_link = link {$link} has a point {$point} already
editing-link_unknown = it is not known where link {$link} is in the present position
editing-point_unknown = it is not known where point {$point} is in the present position
editing-rough_places = give rough places in `near`
editing-slides_on_own = point {$point} is a point of {$on}, so it cannot slide on it
editing-other_point = choose another point, or another carrier of the guide
editing-in_one_place = link {$link} would have {$first} and {$second} in one place
editing-one_name_or_move = use one name for both, or move one
editing-no_place = this is no place
editing-drawn = a drawn configuration cannot be moved
editing-give_lengths = give the mechanism by lengths, with a drive
editing-no_position = the position cannot be written as values of the drives
editing-other_position = take another position
editing-near_cannot_choose = rough places cannot choose mode {$mode}
editing-point_there = there is a point {$name} already
editing-link_there = there is a link {$name} already
editing-other_name = choose another name
editing-no_point = there is no point {$name}
editing-no_link = there is no link {$name}
editing-table_no_number = line {$line}, column {$column}: there is no number
editing-table_one_column = there is no second column
editing-table_line = write a place and a factor in every line, as `90,1500`
editing-table_first = write plain numbers, a place and a factor, as `90,1500`; a first line that names the columns has no numbers
editing-table_more_cells = line {$line} has {$cells} cells, and the first line {$first}
editing-table_marks = separate cells by semicolons where numbers have decimal commas
editing-table_unnamed = there are more than two columns, and the first line does not name them
editing-table_head = name the columns in the first line, those of loads as the scene names these
editing-table_no_column = there is no column for `{$load}`
editing-table_nameless = there is no column for this load, which has no name
editing-table_name = name a column in the first line as the scene names the load
editing-table_long = there are more than {$most} lines
editing-table_shorten = leave out lines that a straight line gives as well

# Why a joint that is pulled does not follow the hand.

editing-held_point = {$point} is pinned
editing-held_length = {$point} moves on a circle: {$length} is pinned
editing-held_angle = {$point} moves on a line: the angle of link {$link} is pinned
editing-held_guide = {$point} moves on a line: the guide of {$slider}
editing-held_rack = {$point} moves across its guide: along it the rack goes with its wheel
editing-held_nowhere = the joint cannot go there
editing-held_rounded = with the joint there, rounded lengths leave the other joints no place near their own
editing-held_try = pull the joint to another place


## Errors and warnings: drawing

drawing-scheme = scheme
drawing-velocity_plan = velocity plan
drawing-acceleration_plan = acceleration plan
drawing-centers = figure of instant centres
drawing-force_plan = force plan
drawing-lever = lever
drawing-speeds = speed diagram
drawing-overflow = the {$panel} does not fit into its panel at {$key} = {$given} and is cut off there; {$fitting} fits, or a larger sheet
drawing-no_scale = none
drawing-cost_of_list = scales leave room for the list of results: {$scales}
drawing-cost_of_names = scales leave room for the list of names: {$scales}
drawing-in_place_of = {$scale} = {$now} in place of {$before}
drawing-too_many_panels = {$wanted} kinds of quantities need {$wanted} panels, and the sheet has room for {$room}
drawing-fewer_or_page = fewer quantities at a time, or another `page` in the scene's figure, as "a4-portrait"
drawing-too_many_curves = {$wanted} curves in one panel are more than can be told apart, which is {$most}
drawing-fewer_quantities = fewer quantities at a time
drawing-no_film_of = a turn of a film cannot last {$seconds} seconds
drawing-at_most_seconds = more than 0 and at most {$most} seconds
drawing-no_film_at = a film cannot have {$count} pictures a second
drawing-pictures_a_second = 1 to {$most} pictures a second
drawing-no_motion = {$seconds} seconds at {$count} pictures a second show no motion
drawing-longer_or_more = a longer time, or more pictures a second
drawing-film_too_long = the film would have {$count} pictures; it may have {$most}
drawing-film_of_turns_too_long = the film would have {$count} pictures in {$turns} turns of the drive; it may have {$most}
drawing-less_or_fewer = less time for a turn, or fewer pictures a second
drawing-no_sheet = there is no sheet {$number}; there are {$count}
drawing-no_step = there is no step {$step}; there are steps 1 to {$count}
drawing-drive_stands = the drive `{$drive}` cannot move


## Errors and warnings: check

check-two_values = `{$name}` has two values here: {$one} and {$two}
check-keep_one = keep the one that you mean
check-form_empty = the form is empty: it has no values to check
check-write_values = write your values beside the names; `kinegon check SCENE --template` writes the form
check-points_without_scale = places of points are in millimetres of paper, but your scale {$scale} is missing
check-add_scale_of = add {$scale}, the scale of your {$sheet}
check-no_pole = the places of the {$sheet} do not have its pole {$pole}
check-no_origin = {$sheet}: the place of {$point} is missing, from which the others are measured
check-add_pole = add "{$pole}": [x, y]
check-no_length_on_paper = `{$name}` is no length on paper, so `/mu` cannot follow it
check-write_in = write it in {$unit}
check-no_sheet = the scene's figure has no {$sheet}, so its scale is missing
check-add_scale_or_panel = add {$scale} to the values, or the panel to the scene's figure
check-no_number = `{$text}` is no number
check-write_digits = write digits with a decimal point, as 61.5; leave blank what you have not measured
check-too_large = `{$text}` is too large
check-wrong_digit = is a digit or an exponent wrong?
check-paper_without_scale = `{$name}` is in millimetres of paper, but your scale {$scale} is missing
check-add_scale = add {$scale}: how many {$unit} are 1 mm of your {$sheet}
check-unit_on_paper = `{$name}` is in millimetres of paper, but `{$unit}` stands beside it
check-unit_or_mu = leave the unit out, or the `/mu`
check-no_unit_of = `{$text}` is no unit of {$kind}
check-write_unit = write `{$unit}`, or leave the unit out
check-did_you_mean = did you mean `{$name}`?
check-template_lists = `kinegon check SCENE --template` lists the names
check-nearest_name = the nearest name is `{$name}`; `kinegon check SCENE --template` lists the names
check-no_quantity = `{$name}` is no quantity of this scene
check-no_box = no step finds `{$name}`, so a form has no box for it
check-pi_lost = the letter π was lost in `{$name}`
check-save_as_utf8 = save as CSV UTF-8, or write pi
check-too_many = a form has at most {$most} values, and here are {$count}
check-is_this_a_form = is this a form? `kinegon check` without a form prints an empty one
check-no_scale = {$scale} is no scale
check-scale_is_positive = a scale is a positive number: units of the scene per millimetre of paper
check-not_understood = {$count} things in this form are not understood:{$all}
check-line = line {$number}

# Kinds of quantities, and sheets.

check-angle = an angle
check-angular_velocity = an angular velocity
check-rotational_speed = a rotational speed
check-speed_ratio = a ratio of angular velocities
check-angular_acceleration = an angular acceleration
check-position = a position
check-length = a length
check-velocity = a velocity
check-acceleration = an acceleration
check-force = a force
check-moment = a moment
check-power = a power

# Tables.

check-open_quotation = a double quote opens here and does not close on this line, so that the lines below would be lost
check-close_quotation = close it, or leave it out
check-no_table = this is no table: {$error}
check-write_lines = write a line `quantity,value` for each value; names with a comma stand in double quotes
check-value_without_name = `{$text}` stands here without the name of a quantity
check-value_in_unit = `{$text}` stands in the place of the unit, and no value before it
check-no_sense = `{$text}` is no sense of rotation
check-write_sense = write `clockwise` or `counter-clockwise`
check-values_in = values in `{$unit}` are not understood
check-not_upright = `{$text}` does not say whether the sheets lie upright
check-no_count = `{$text}` is no number of hints
check-whole_number = write a whole number from 0 on, or leave the line out
check-true_or_false = write `true` if they lie as they were printed, else `false`
check-mm_or_units = write `mm` for millimetres of paper, or `units` for those of the scene
check-no_coordinate = `{$text}` is no coordinate
check-write_coordinates = write x and y in millimetres of paper, as velocity:b,114,-2.7
check-no_radius = `{$text}` is no radius
check-write_radius = behind x and y may stand how far the point may be from there, in millimetres of paper, as velocity:b,114,-2.7,0.2
check-scale_no_number = {$scale} is `{$text}`, which is no number
check-write_scale = write units of the scene per millimetre of paper, as 2 or 0.5

# Marks.

check-no_part = {$number} is no part of marks
check-part_from_0 = write a number from 0 (no marks) to 1 (all marks of the quantity)
check-no_marks = {$number} is no number of marks
check-marks_from_0 = write a number from 0 to {$most}
check-marks_twice = `{$name}` is the same quantity and has its marks already
check-no_marks_at_all = the marking scheme gives no marks for anything
check-add_each = add "each": 1, or marks for the quantities that count

# Refusals of pages.

check-tolerance = the tolerance of a pencil is from 0 to {$most}
check-no_photograph = there is no photograph


## Errors and warnings: exercise

exercise-no_construction = its plans have no construction to be drawn by hand: a special point lies at infinity, or a group is of higher class than IV
exercise-nothing_to_find = the figure of instant centres has nothing to find: the centres that it shows stand in pins and guides; name others in `figure.centers`, or points in `figure.velocities`
exercise-gave_up = none of {$tries} variants can be drawn well by hand; most often ({$percent} %) {$most}
exercise-numbers = the numbers do not fit together
exercise-assembly = the links do not reach each other
exercise-singular = the position is too near a singular one
exercise-no_plans = there is no construction of the plans
exercise-routes = the construction is not exact enough
exercise-crossing = lines cross at less than 20°
exercise-sheet = a special point or a plan does not fit on the sheet
exercise-short = a segment is too short: one to be measured shorter than 5 mm, or one to be laid off shorter than 4 mm
exercise-unsure = a rate cannot be found to 15 % by hand
exercise-center_far = an instant centre is too far away for the sheet
exercise-centers_close = two instant centres are nearer than 6 mm to each other
exercise-center_distance = a distance from which a velocity is found is shorter than 15 mm
exercise-center_unsure = an instant centre cannot be found to 2 mm by hand
exercise-forces_cross = directions of forces cross at less than 15°
exercise-force_short = a force is shorter than 8 mm
exercise-arm_short = an arm is shorter than 10 mm
exercise-forces_unequal = a force is less than a fortieth of another
exercise-forces_unequal_as = a force is less than a fortieth of another, as {$small} of {$large} in the scene as it stands: leave out what is so small (gravity, a mass, inertia by "analysis": "static"), or make the loads more alike
exercise-force_unsure = a force or a moment cannot be found to 8 % by hand
exercise-evened = some forces of the scene are too small beside others to be drawn with them; exercises have other loads: {$changes}
exercise-same = its numbers came before
exercise-numbered = exercises are numbered from 1 to {$most}
exercise-no_such = there is no such exercise
exercise-whole_seed = a seed is a whole number


## Errors and warnings: photo

photo-no_sheet = no sheet with markers is found in the picture
photo-one_marker = only one of the sheet's eight markers is found in the picture
photo-few_markers = only {$count} of the sheet's eight markers are found together in the picture
photo-whole_sheet = take the picture from above, with the whole sheet and all eight black squares in it, sharp and without a hand over them; sheets printed without markers cannot be read
photo-cut_off = the picture ends before the sheet does: some of its eight black squares are outside
photo-step_back = take the picture from farther away, with all eight black squares in it
photo-mirrored = the picture is mirrored
photo-unmirror = take it with the camera at the back of the telephone, or switch mirroring off
photo-not_even = the sheet is not flat: its markers are {$mm} mm from where they would be on an even sheet
photo-bent = the sheet is bent: its middle is {$mm} mm above or below its edges
photo-flatten = press the sheet flat, under a sheet of glass or with weights on its edges, and take the picture again
photo-blurred = the picture is blurred: edges on the sheet are {$mm} mm wide in it
photo-nearer = take the picture nearer, so that the sheet fills it, in more light, and hold the camera still
photo-no_code = the small code at the lower right corner of the sheet cannot be read
photo-light_on_code = take the picture nearer and sharper, with light on the code; nothing may be drawn over it; pictures sent by chat are often too small
photo-other_page = the small code is of a page that is not that of the markers: the picture shows parts of two sheets, or a sheet that was cut
photo-one_whole_sheet = photograph one whole sheet as it was printed
photo-cut_short = is cut short: the file ends in the middle of the picture
photo-send_again = copy or send the photograph once more
photo-second_sheet = the picture shows parts of another sheet, too, which is not read
photo-each_by_itself = photograph each sheet by itself
photo-nothing_drawn = no pencil lines of the plans are found in the picture
photo-nothing_in_blur = no pencil lines of the plans are found: the picture is blurred, edges on the sheet are {$mm} mm wide in it
photo-mark_by_hand = take a sharper picture, or mark the points in the workbench
photo-scaled = all points that are found are {$percent} % too far from the poles
photo-scaled_down = all points that are found are {$percent} % too near to the poles
photo-measure_ruler = lay a ruler on the one that is printed on the sheet: is its 50 mm not 50 mm long, the sheet was printed to fit the page


## Errors and warnings: board

board-too_many = a drawing has at most {$most} entries, and here are {$count}
board-sheet_too_large = at {$mu} per mm the {$sheet} would be {$metres} m large; sheets of up to {$most} m are drawn
board-other_scale = write the scale of your sheet, as {$mu}, or leave {$key} out
board-no_formula = `{$text}` is no formula: it is not understood from letter {$place} on
board-no_equation = `{$text}` is no equation: it has no =
board-not_linear = `{$text}` is not linear in the numbers that are sought
board-no_value = `{$text}` has no value
board-no_solution = the equations have no solution, or many
board-taken = `{$name}` cannot be the name: it is taken, or no name
board-no_point = there is no point {$name} yet
board-no_line = there is no line {$name}
board-no_number = {$name} is not known yet
board-no_direction = {$name} has no direction
board-no_reference = `{$name}` gives no direction: it is no line, link or guide; two points are written as "B,C"
board-which_points = link {$link} has more than two points, or fewer: say between which, as "B,C"
board-which_sheet = say on which sheet, as "on": "velocity"
board-two_sheets = lines {$one} and {$two} are on two sheets
board-no_crossing = lines {$one} and {$two} are parallel
board-line_misses = {$point} does not lie on this line
board-lines_of_others = {$point} is not where these lines cross
board-point_elsewhere = {$point} is not there
board-no_force_of_polygon = the vector to {$point} is no force that its polygon still lacks
board-no_direction_of_force = {$line} has the direction of no force that closes its polygon
board-polygon_not_closed = the polygon does not close in {$point}
board-number_wrong = this is not {$name}
board-nothing_leads_to = nothing that is drawn leads to {$name}: draw or measure what gives it
board-equation_wrong = equation {$number} does not hold
board-leads_wrong = with this, {$name} comes out wrong
board-drawn_off = this line is drawn {$mm} mm and {$degrees}° off what was meant
board-point_off = this point is marked {$mm} mm off what was meant
board-misread = {$name} was read {$mm} mm off what was drawn
board-join = line {$name} through {$one} and {$two}
board-line = line {$name} through {$point}, {$direction}
board-line_by_eye = line {$name} by eye
board-cross = {$name} where {$one} and {$two} cross
board-lay_off = {$name}: {$size} laid off from {$point}, {$direction}
board-like = {$name} on {$ends} as in the triangle {$points}
board-mark = {$name} marked by eye
board-measure = {$name} measured from {$one} to {$two}
board-compute = {$name} = {$formula}
board-typed = {$name} = {$number}, typed
board-solve = {$names} from equations
board-undo = {$count ->
    [one] the last entry taken back
   *[other] the last {$count} entries taken back
}
board-parallel = parallel to {$to}
board-normal = normal to {$to}
board-turned = at {$base} by the angle from {$from} to {$to}
board-angle = at {$degrees}°
board-link = link {$name}
board-guide = guide {$name}
board-load = force {$name}
board-drawn_line = line {$name}
board-ccw = counter-clockwise
board-cw = clockwise
board-right = right
board-wrong = wrong
board-follows = follows from it
board-unused = unused
board-undone = taken back
board-all_right = Every operation is right.
board-right_so_far = Every operation is right so far.
board-asked_missing = Still asked for: {$names}.
board-asked_missing_many = Still asked for: {$names} and {$more} more.
board-nothing_drawn = Nothing is drawn yet.
board-first_wrong = The first wrong operation is number {$number}.
board-should = It should be: {$what}
board-no_sheet = the scene has no such plan
board-free_hand = Free hand: ±{$mm} mm and ±{$degrees}° are right
board-all_there = Everything is there.
board-next_line = Next comes a line on the {$sheet}.
board-next_point = Next comes {$name} on the {$sheet}.
board-next_number = Next comes {$name}.

## The workbench: layout

page-layout-described = The picture in words
page-layout-notices = What others have made, and its licences
page-layout-back_to_picture = Back to the picture
page-layout-is_fixed = Fixed points: {$points}.
page-layout-is_link = Link {$name}: {$points}
page-layout-is_driven = driven, at {$place}
page-layout-is_slider = Block {$name} slides on {$on}.
page-layout-is_pin = Pin {$name} slides in a slot of {$on}.
page-layout-is_ground = the ground
page-layout-is_through = Its guide goes through {$place}.
page-layout-is_known = Known motions: {$points}.
page-layout-means_pole_v = {$name}, the pole: all velocities begin here, and what stands still has its image here.
page-layout-means_pole_a = {$name}, the pole: all accelerations begin here, and what has none has its image here.
page-layout-means_image_v = {$name}, the image of {$point}: the arrow from the pole to here is the velocity of {$point}.
page-layout-means_image_a = {$name}, the image of {$point}: the arrow from the pole to here is the acceleration of {$point}.
page-layout-means_special = {$name}, the special point of link {$link}: where its cut lines meet. It gives the plan its next image.
page-layout-means_special_image = {$name}, the image of the special point of link {$link}.
page-layout-means_under = {$name}, the image of the point of link {$link} that lies under {$point} now.
page-layout-means_normal = {$name}, the end of a normal part ω²·l. The tangential part begins here.
page-layout-means_coriolis = {$name}, the end of a Coriolis part 2·ω·v.
page-layout-means_sliding = {$name}, the end of a part along a guide.
page-layout-means_omega = {$name}, the angular velocity of link {$link}.
page-layout-means_alpha = {$name}, the angular acceleration of link {$link}.
page-layout-tour = A short tour
page-layout-tour_pull = Pull a joint: the mechanism moves, and the plans of its velocities and accelerations follow, to scale.
page-layout-tour_steps = Steps shows how the plans are drawn by hand, line by line.
page-layout-tour_own = Mechanism has every number to type, and other mechanisms to start from. The other panels draw, check and save.
page-layout-tour_next = Next
page-layout-tour_leave = Leave
page-layout-tour_done = Begin
page-layout-skips = Skip
page-layout-skip_picture = To the picture
page-layout-skip_panels = To the panels
page-layout-skip_motion = To the motion
page-layout-toolbar = Scene and tools
page-layout-picture = Picture
page-layout-panels = Panels
page-layout-untitled = Scene
page-layout-documents = Scenes and files
page-layout-open_file = Open a scene or a form…
page-layout-lesson = The scene of this file
page-layout-recent = Worked on before
page-layout-forget = Forget these
page-layout-undo = Undo (Ctrl+Z)
page-layout-redo = Redo (Ctrl+Y)
page-layout-undone = Undone.
page-layout-redone = Done again.
page-layout-hand = What pulling a joint does
page-layout-move = Move
page-layout-move_long = Move: pulling a joint moves the mechanism
page-layout-shape = Shape
page-layout-shape_long = Shape: pulling a joint changes lengths
page-layout-build = Build
page-layout-build_long = Build: put a mechanism together, complete or not
page-layout-zoom = Zoom
page-layout-all = All
page-layout-zoom_in = Larger (+)
page-layout-zoom_out = Smaller (−)
page-layout-fit = Fit (0)
page-layout-motion = Motion
page-layout-play = Play (space)
page-layout-play_together = Play (space): all drives run together, in proportion to their speeds
page-layout-together = All drives run together, in proportion to their speeds. A slider moves one alone.
page-layout-stuck = The drive cannot move from where it stands.
page-layout-pause = Pause (space)
page-layout-speed = Speed
page-layout-link = Link {$name}
page-layout-slider = Slider {$name}
page-layout-drive_at = {$name} stands at
page-layout-drive_unread = “{$typed}” is not a number here. Type one, with a unit if you like: 60°, 0.5 rad, 12 cm.
page-layout-steps = Steps
page-layout-steps_long = Steps of the construction
page-layout-first = First step (Home)
page-layout-back = Step back (←)
page-layout-forward = Step forward (→)
page-layout-last = Finished figure (End)
page-layout-step = Step
page-layout-step_of = Step {$number} of {$count}
page-layout-finished = Finished figure, {$count} steps
page-layout-coarse = Coarse steps
page-layout-language = Language
page-layout-full = Full screen (p)
page-layout-leave_full = Leave full screen (Esc)
page-layout-dark = Dark or light (d)
page-layout-help = Help (?)
page-layout-help_title = What is this, and what next?
page-layout-way_new = Never seen a plan?
page-layout-way_new_how = Each arrow from the pole is the velocity (or the acceleration) of one point, to scale: twice as long is twice as fast. Pull a joint and watch the arrows. Rest on a letter, or tap it, to read what it means. The numbers stand in Values, what they do over a turn in Curves.
page-layout-way_lecture = A figure for a lecture
page-layout-way_lecture_how = Choose a mechanism that is like yours and type your numbers, or put it together with Build. Figure chooses the sheet, its language and style. Steps draws the plans line by line; P fills the screen. Save has PDF, SVG, TikZ, a film, and a link for students.
page-layout-way_student = An exercise
page-layout-way_student_how = Draw both plans on paper at the scales that are given, measure, and type what you have measured into Check, or photograph your sheet. It names the step where something went wrong.
page-layout-way_go = Open {$panel}
page-layout-letters = Letters in the plans (usual notation)
page-layout-letter_poles = poles: from p all velocities begin, from π all accelerations
page-layout-letter_images = images of the points B, C: the arrow from the pole to b is the velocity of B (in the other plan, its acceleration)
page-layout-letter_normal = end of a normal part ω²·l; the tangential part begins there
page-layout-letter_coriolis = end of a Coriolis part 2·ω·v
page-layout-letter_special = special points of groups of third and fourth class, and their images
page-layout-letter_scale = scales: a length in mm on the sheet, times μ, is the value
page-layout-more = More
page-layout-keys = Keys
page-layout-keys_letters = Letters work as keys
page-layout-close = Close
page-layout-key_steps = step back, step forward
page-layout-key_ends = first step, finished figure
page-layout-key_drive = turn the drive by 1° (with Shift 0.1°)
page-layout-key_play = play, pause
page-layout-key_panels = scheme, velocities, accelerations, all
page-layout-key_zoom = larger, smaller, fit
page-layout-key_hand = move, shape, build
page-layout-key_full = full screen
page-layout-key_dark = dark or light
page-layout-key_undo = undo, redo
page-layout-key_joint = on a joint: move it by 1 mm of the sheet (with Shift 0.1 mm)
page-layout-key_escape = put back what is being dragged; out of a panel to its tab
page-layout-joint = Joint {$name}
page-layout-fixed_joint = Fixed point {$name}
page-layout-joint_hint = Arrow keys move it, with Shift finer. Escape puts it back.
page-layout-mend_first = The scene has a mistake. Mend it before you move anything.
page-layout-no_picture = There is no picture yet. The message above says why.
page-layout-to_text = Show it in the text
page-layout-go_on = Go on building
page-layout-warning = 1 warning
page-layout-warnings = {$count} warnings
page-layout-busy = Working…
page-layout-put_back = Put back.
page-layout-stop = Stop
page-layout-stopped = Stopped. The scene is untouched.
page-layout-too_slow = This took longer than {$seconds} s and was stopped. The scene is untouched.
page-layout-fell = The engine stopped unexpectedly and was started again. The scene is untouched.
page-layout-link_broken = The link is damaged or cut off, so no scene could be read from it. What was here before has stayed.
page-layout-link_newer = The link was made by a newer version of Kinegon. Ask for the scene as a file, or open the link with that version.
page-layout-link_too_large = The link holds more text than a scene may have, so it was not read.
page-layout-file_too_large = The file “{$name}” has more than 4 MB, more than a scene or a form may have.
page-layout-unread_file = The file “{$name}” cannot be read.
page-layout-forms_first = Only “{$name}” of the {$count} forms is open: this page takes one at a time. For a whole class, put the forms into a folder and run: kinegon check scene.json forms/
page-layout-forms_left = The drawings are on the board; the forms among the files were left out. For a whole class, put the forms into a folder and run: kinegon check scene.json forms/
page-layout-files_first = Only “{$name}” of the {$count} files is open: this page takes one at a time.
page-layout-opened_file = Opened “{$name}”. Undo brings back what was there.
page-layout-exam_open = In an exam only a drawing of your own can be opened.
page-layout-no_storage = This browser keeps nothing for this page. Save the scene as a file before you close it.
page-layout-restored = Your last scene is back.
page-layout-course_deaf = The course does not take the marks just now. What you write stays on this page; save the form in the panel Check as well, so that you can hand it in another way.
page-layout-course_again = Send again
page-layout-course_hears = The course has the marks now.
page-layout-worked_before = This is the scene of the file. You have worked on it before: “{$title}”, {$when}.
page-layout-take_up = Go on with that
page-layout-as_paper = Paper
page-layout-as_paper_long = Paper: the sheet that is saved and printed, at its scales. Without it the picture fills the screen, at scales of the screen's own.
page-layout-below = Curves
page-layout-splitter = Width of the panel
page-layout-start_failed = Kinegon could not start: {$why}. A browser from 2023 or later is needed.


## The workbench: build

page-build-stage = Build: {$count} points
page-build-tools = What to do
page-build-tool_select = Select
page-build-tool_link = Link
page-build-tool_third = Point on a link
page-build-tool_fixed = Fixed point
page-build-tool_slider = Slider
page-build-tool_cylinder = Cylinder
page-build-tool_drive = Drive
page-build-tool_drop = Remove
page-build-tool_load = Load
page-build-hint_select = Drag a point or a link to move it. Click it for its numbers, twice to type them. Shift adds to the choice.
page-build-hint_link = Drag from joint to joint, or from one empty place to another.
page-build-hint_third = Drag from a link to where its further point is to be.
page-build-hint_fixed = Click a point to fix it, or to free it; an empty place gets a new one.
page-build-hint_slider = Drag from the point that slides: onto a link that guides it, or in the direction of a guide on the ground.
page-build-hint_cylinder = Drag from joint to joint: a cylinder and its rod, which a drive pushes apart.
page-build-hint_drive = Click a link with a fixed point, or a block: it is driven, or no longer.
page-build-hint_drop = Click a point or a link to remove it.
page-build-hint_load = Drag from a link to where a force points: a step of the grid is 10 units. A tap puts a couple on the link. The tip of an arrow changes its force, its shaft moves it; an arc is dragged to change its couple.
page-build-second = Now the other end.
page-build-key = Key {$key}
page-build-what_slides = What slides
page-build-slides_block = Block on the pin
page-build-slides_itself = The link itself
page-build-slides_pin = Pin in a slot
page-build-on_link = The guide on a link
page-build-guided_along = Along the link
page-build-guided_across = At right angles
page-build-snap = Grid
page-build-fit = Fit
page-build-smaller = Smaller
page-build-larger = Larger
page-build-photo = Photograph…
page-build-photo_scale = Its scale
page-build-photo_away = Without photograph
page-build-photo_two = Click two places of the photograph whose distance you know, then type it.
page-build-photo_length = distance of the two
page-build-photo_number = Type it as a number of {$unit}, such as 120.
page-build-photo_unread = This file is no picture that the browser can show.
page-build-begin = Nothing there yet. Drag a first link.
page-build-complete = Complete. The hand Move (m) moves it.
page-build-incomplete = Not complete yet: {$why}
page-build-wants_ground = Not complete yet: nothing stands still. Fix points, or give a guide on the ground.
page-build-wants_one = Not complete yet: one motion is free. It wants a drive, or one link or fixed point more.
page-build-wants_more = Not complete yet: {$count} motions are free. It wants joints, fixed points or drives.
page-build-too_held = Not complete yet: {$count} too many joints, fixed points or drives.
page-build-mobility = (3·{$links} − {$taken} = {$free}, drives: {$drives})
page-build-needs_point = Begin at a point that is there.
page-build-needs_link = Begin at a link.
page-build-needs_pivot = A drive turns a link that has a fixed point, or pushes a block on its guide: this link has neither.
page-build-needs_way = Drag a little farther: both ends are in one place.
page-build-joined_already = A link has both of these points already.
page-build-at_link = link {$name}
page-build-at_load = load {$name}
page-build-taken_up = Taken up: arrows move it, Enter puts it down.
page-build-put_down = Put down.
page-build-put_back = Put back.
page-build-removed = Removed.
page-build-copied = {$count} points copied.
page-build-numbers = Numbers
page-build-rename = Name
page-build-fix_it = Fix it
page-build-free_it = Free it
page-build-drive_it = Drive on or off
page-build-copy = Copy
page-build-paste = Paste
page-build-remove = Remove


## The workbench: mechanism

page-mechanism-panel_title = Mechanism
page-mechanism-about = About it
page-mechanism-title = Title
page-mechanism-untitled = No title
page-mechanism-length_unit = Lengths in
page-mechanism-time_unit = Times in
page-mechanism-ground = Fixed points
page-mechanism-ground_help = Pivots on the ground. x to the right, y up.
page-mechanism-fixed_point = Fixed point
page-mechanism-add_fixed = Fixed point
page-mechanism-no_longer_there = Remove point {$name}
page-mechanism-links = Links
page-mechanism-links_help = A point in two links is a pin joint between them.
page-mechanism-link = Link
page-mechanism-link_name = Name of link {$name}
page-mechanism-add_link = Link
page-mechanism-from = From point
page-mechanism-to = To point
page-mechanism-new_point = new {$name}
page-mechanism-points = Points
page-mechanism-point_name = Name of point {$name}
page-mechanism-drop_link = Remove link {$name}
page-mechanism-take_off = Take {$name} off the link
page-mechanism-add_point = Point
page-mechanism-places_on_link = Places on the link itself; x runs along it
page-mechanism-give_place = y
page-mechanism-drive_it = Drive this link
page-mechanism-drop_drive = Remove the drive of {$name}
page-mechanism-drive = Drive
page-mechanism-angle = Angle
page-mechanism-speed = Speed
page-mechanism-turns = Unit of speed
page-mechanism-acceleration = Acceleration
page-mechanism-position = Position
page-mechanism-axis_angle = Angle of its axis
page-mechanism-block = block
page-mechanism-unsized = Four points or more need a shape: take points off and add them again.
page-mechanism-moves_as_known = known motion
page-mechanism-sliders = Sliders
page-mechanism-sliders_help = Blocks on straight guides, and pins in slots.
page-mechanism-slides_on = {$point} on {$on}
page-mechanism-pin_in_slot = pin in a slot
page-mechanism-what_slides = What slides
page-mechanism-sliding_link = Block
page-mechanism-at = at
page-mechanism-pin = Pin
page-mechanism-on = Slides on
page-mechanism-ground_word = ground
page-mechanism-through = Guide through
page-mechanism-through_usual = its own point
page-mechanism-through_place = a place x, y
page-mechanism-offset = y (offset)
page-mechanism-along = Guide along
page-mechanism-along_usual = its axis
page-mechanism-along_degrees = an angle
page-mechanism-along_direction = a direction x, y
page-mechanism-degrees = Angle
page-mechanism-turned = Turned by
page-mechanism-drop_slider = Remove slider {$name}
page-mechanism-add_slider = Slider
page-mechanism-new_block = new block at {$name}
page-mechanism-link_at = link {$link} at {$name}
page-mechanism-pin_at = pin {$name} in a slot
page-mechanism-rolling = Gears, belts and cams
page-mechanism-rolling_help = Two wheels that roll on each other, a wheel on a rack, wheels with a belt; two profiles that touch, by their centers and radii of curvature.
page-mechanism-add_gear = Pair of wheels
page-mechanism-wheel = Wheel
page-mechanism-runs_on = Runs on
page-mechanism-new_wheel = a new wheel
page-mechanism-new_rack = a new rack
page-mechanism-pair_of = {$first} with {$second}
page-mechanism-carried_by = on {$name}
page-mechanism-first_wheel = First
page-mechanism-second_wheel = Second
page-mechanism-carrier = Carried by
page-mechanism-teeth_of = Teeth of {$name}
page-mechanism-pitch_radius = Radius of the pitch circle
page-mechanism-touch = Touch
page-mechanism-touch_outside = teeth outside
page-mechanism-touch_ring_first = the first is a ring
page-mechanism-touch_ring_second = the second is a ring
page-mechanism-touch_rack_first = the first is a rack
page-mechanism-touch_rack_second = the second is a rack
page-mechanism-touch_open = open belt
page-mechanism-touch_crossed = crossed belt
page-mechanism-rack_at_zero = Position where the wheel stands at 0
page-mechanism-second_at_zero = Second wheel where the first stands at 0
page-mechanism-pressure = Pressure angle
page-mechanism-add_contact = Contact
page-mechanism-first_center = Center of curvature of the first
page-mechanism-second_center = Center of curvature of the second
page-mechanism-contact_of = {$first} on {$second}
page-mechanism-first_profile = First
page-mechanism-second_profile = Second
page-mechanism-center_at = Center of curvature
page-mechanism-radius_of = Radius of curvature of {$name}
page-mechanism-add_radii = Radii
page-mechanism-second_is = The second is
page-mechanism-profile_round = round
page-mechanism-profile_roller = a roller
page-mechanism-profile_flat = flat
page-mechanism-circular = circles in every position
page-mechanism-equivalent = Equivalent link
page-mechanism-face_through = Face through
page-mechanism-face_along = Face along
page-mechanism-travel = Ends of the slot
page-mechanism-travel_from = from
page-mechanism-travel_to = to
page-mechanism-drop_travel = Remove the ends of slider {$name}
page-mechanism-loads = Masses and forces
page-mechanism-loads_help = What joints carry and drives need follows from these. Loads are drawn beside the force plan.
page-mechanism-add_force = Force
page-mechanism-add_couple = Couple
page-mechanism-add_mass = Mass
page-mechanism-add_spring = Spring
page-mechanism-add_friction = Friction
page-mechanism-pin_of = Pin {$name}
page-mechanism-guide_of = Guide {$name}
page-mechanism-friction_of = Friction: {$name}
page-mechanism-coefficient = Coefficient of friction
page-mechanism-friction_angle = Angle of friction
page-mechanism-journal = Radius of the journal
page-mechanism-joint = Joint
page-mechanism-acts_at = Acts at
page-mechanism-acts_on = Acts on
page-mechanism-gravity = Gravity
page-mechanism-drop_gravity = Remove gravity
page-mechanism-analysis = Inertia
page-mechanism-with_inertia = counts
page-mechanism-without_inertia = is left out
page-mechanism-mass_unit = Masses in
page-mechanism-force_unit = Forces in
page-mechanism-mass = Mass
page-mechanism-weight = Weight
page-mechanism-inertia = Moment of inertia about the center of mass
page-mechanism-mass_of = Mass of {$name}
page-mechanism-center = Center of mass
page-mechanism-drop_mass = Remove the mass of link {$name}
page-mechanism-on_axis = x along the link
page-mechanism-load_name = Name
page-mechanism-force = Force
page-mechanism-couple = Couple
page-mechanism-turns_with_link = turns with the link
page-mechanism-changes_over = Changes over
page-mechanism-add_over = Over the motion
page-mechanism-table_lines = Place and factor, a line each
page-mechanism-position_of = position of {$name}
page-mechanism-drop_over = Remove the table of {$name}
page-mechanism-drop_load = Remove {$name}
page-mechanism-rate = Force per length
page-mechanism-free_length = Length without a force
page-mechanism-near = Which way it is put together
page-mechanism-near_help = Rough places of points, or angles of links. Kinegon takes the assembly that is nearest.
page-mechanism-add_near = Rough place
page-mechanism-angle_of = angle of {$name}
page-mechanism-drop_near = Remove the rough place of {$name}
page-mechanism-drawn_points = Points as drawn
page-mechanism-drawn_help = This scene is drawn: it gives coordinates in place of lengths and cannot be moved.
page-mechanism-fixed = Fixed
page-mechanism-known = Known motions
page-mechanism-known_help = Points whose velocity and acceleration are known.
page-mechanism-add_known = Known motion
page-mechanism-drop_known = Remove the known motion of {$name}
page-mechanism-velocity = Velocity
page-mechanism-by_parts = as x, y
page-mechanism-by_size = as size, angle
page-mechanism-size = size
page-mechanism-known_motion = Its motion is known
page-mechanism-drop_motion = Remove the known motion of link {$name}
page-mechanism-add_acceleration = Acceleration
page-mechanism-drop_acceleration = Remove the acceleration
page-mechanism-stub = stub
page-mechanism-moving = moving
page-mechanism-change_kind = Other mechanisms
page-mechanism-empty = New, empty
page-mechanism-open_file = Open…
page-mechanism-groups_bars = One loop
page-mechanism-groups_more = Six links
page-mechanism-groups_drives = Several drives
page-mechanism-groups_wheels = Wheels and cams
page-mechanism-groups_class = Third and fourth class
page-mechanism-groups_drawn = Groups as a textbook draws them
page-mechanism-groups_paper = From the paper


## The workbench: curves

page-curves-panel_title = Curves
page-curves-what = What is drawn
page-curves-curves = Curves
page-curves-hodograph = Hodographs
page-curves-path = Paths
page-curves-choose = Choose
page-curves-clear = None
page-curves-beyond = Beyond the limits of the drive, too, dashed
page-curves-none = Choose at least one.
page-curves-drawn = This scene gives its points as they are drawn. It cannot be moved, so there is nothing over a cycle.
page-curves-waits = Drawing …
page-curves-save = Save as {$format}
page-curves-table = Table as CSV
page-curves-events = Special positions
page-curves-no_events = None over this range.


## The workbench: figure

page-figure-language_name = English
page-figure-panel_title = Figure
page-figure-shown = What is shown
page-figure-panels = Panels
page-figure-focus = Large
page-figure-none = All alike
page-figure-scales = Scales
page-figure-scales_help = Of the sheet that is saved and printed (“Paper” shows it); on the screen scales are the screen's own. Left empty, the next round scale that fits is taken.
page-figure-automatic = automatic
page-figure-take = Keep the present scale {$value}
page-figure-as_before = Automatic again
page-figure-scales_for = Automatic scales fit
page-figure-position = this position
page-figure-sheet = each sheet by itself
page-figure-cycle = the whole cycle
page-figure-look = How it looks
page-figure-style = Style
page-figure-paper = Paper
page-figure-print = Print
page-figure-lecture = Lecture
page-figure-board = Board
page-figure-notation = Notation
page-figure-n_paper = Paper
page-figure-english = English
page-figure-russian = Russian
page-figure-german = German
page-figure-sliding = Along guides
page-figure-coriolis = Coriolis index
page-figure-as_notation = as the notation has it
page-figure-frame = Frame
page-figure-word = by a word
page-figure-turned = Velocities
page-figure-not_turned = as they are
page-figure-turned_by = turned by {$angle}°
page-figure-language = Language
page-figure-decimal = Decimals
page-figure-point = 2.5
page-figure-comma = 2,5
page-figure-page = Sheet
page-figure-page_size = Size
page-figure-landscape = Landscape
page-figure-portrait = Portrait
page-figure-direction = Direction
page-figure-worksheet = Work sheet with table and ruler
page-figure-yes = Yes
page-figure-no = No
page-figure-contents = On the figure
page-figure-values = Values
page-figure-usual = as the style has it
page-figure-with_unit = lengths in {$unit}
page-figure-construction = Construction
page-figure-whole = Whole
page-figure-as_paper = As the paper
page-figure-hidden = Hidden
page-figure-special = Special points
page-figure-paths = Paths and positions
page-figure-trace = Paths of points over the cycle
page-figure-no_trace = This mechanism has no cycle to draw paths of.
page-figure-beyond = Paths go on beyond limits
page-figure-ghosts = Pale positions of the links
page-figure-ghosts_unit = over the cycle
page-figure-centers = Instant centres
page-figure-centers_help = The panel of instant centres is chosen under “What is shown”.
page-figure-wanted_centers = Centres
page-figure-usual_centers = the usual ones
page-figure-all_centers = all
page-figure-these_centers = these
page-figure-velocities = Velocities by centres
page-figure-curvature = Curvature of the paths of points
page-figure-centrodes = Centrodes of links, on the scheme
page-figure-inflection = Inflection circles of links, on the scheme
page-figure-labels = Other letters
page-figure-labels_help = Shown in place of a name. B_1 writes a subscript.
page-figure-label_of = Text for {$name}
page-figure-drop_label = Show the name of {$name} again
page-figure-projector = Projector 16:9
page-figure-own_name = Name to replace
page-figure-add_label = Text


## The workbench: text

page-text-panel_title = Text
page-text-editor = Text of the scene
page-text-good = The text is a complete scene.
page-text-go = Go there
page-text-long = This text stands in a line that is too long to be shown.
page-text-lay_out = Lay it out in lines
page-text-help = This text is the whole document: a scene file of the program. Ctrl+Space offers keys, Ctrl+F searches, Esc then Tab leaves.


## The workbench: exercise

page-exercise-panel_title = Exercise
page-exercise-intro = A mechanism with other round numbers, chosen so that it can be drawn well by hand. The same seed gives the same exercises, here and with kinegon exercise.
page-exercise-kind = Mechanism
page-exercise-own = The scene that is open: {$title}
page-exercise-seed = Seed
page-exercise-number = Number
page-exercise-page = Page
page-exercise-page_auto = A4, or A3 where it must be
page-exercise-page_name = {$size} {$way}
page-exercise-landscape = landscape
page-exercise-portrait = portrait
page-exercise-back = Exercise before
page-exercise-forward = Next exercise
page-exercise-large = Large view
page-exercise-small = Back to the picture
page-exercise-making = Looking for an exercise…
page-exercise-student = For the students
page-exercise-print = Print at 100 %
page-exercise-print_hint = In the print window choose 100 % or actual size, never “fit to page”. The ruler on the sheet shows whether it is true.
page-exercise-link = Link for students
page-exercise-allow_steps = With the steps of the construction, in words
page-exercise-allow_more = With the next exercises of this seed
page-exercise-link_hint = It has the sheet to print, the form, the photograph and its check, also on a telephone. It opens the mechanism without its plans, with the form beside it. Whoever wants to can still work the answers out of the scene: for marks, collect the forms.
page-exercise-sheet = Sheet
page-exercise-form = Form
page-exercise-scene = Scene
page-exercise-teacher = For the teacher
page-exercise-show_key = Show the key
page-exercise-print_key = Print the key
page-exercise-key = Key
page-exercise-key_values = Values
page-exercise-open = Open in the workbench
page-exercise-opened = The exercise {$name} is open; undo brings the scene before back.
page-exercise-sheet_of = Sheet of the exercise {$name}
page-exercise-key_of = Key of the exercise {$name}
page-exercise-board_paper = Plans are drawn on paper
page-exercise-board_practice = On the drawing board: practice
page-exercise-board_at_once = On the drawing board: a wrong line is told at once
page-exercise-board_exam = On the drawing board: exam, nothing is told
page-exercise-board_demonstration = On the drawing board: look on while it is drawn
page-exercise-board_snap = What the hand is helped with
page-exercise-board_snap_all = Points and lines snap
page-exercise-board_snap_points = Points alone snap
page-exercise-board_snap_none = Free hand


## The workbench: values

page-values-panel_title = Values
page-values-find = Find a quantity
page-values-digits = Digits
page-values-certain = all certain digits
page-values-few = {$count} digits
page-values-copy = Copy
page-values-save = CSV
page-values-copied = The table is on the clipboard.
page-values-not_copied = This browser does not let the page use the clipboard. Save the table as CSV.
page-values-quantity = Quantity
page-values-value = Value
page-values-unit = Unit
page-values-error = ±
page-values-count = {$count} of {$all} quantities
page-values-none = No quantity has this in its name.
page-values-about = Every digit shown is certain; ± is how far the value can be from the scene’s true one.
page-values-about_few = Rounded. “All certain digits” shows every digit that is certain, and how far the value can be from the scene’s true one.
page-values-groups = Assur groups
page-values-warnings = Warnings


## The workbench: modes

page-modes-panel_title = Modes
page-modes-ghosts = Show the others pale in the picture
page-modes-single = The mechanism can be assembled in one way only.
page-modes-drawn = This scene gives its points as they are drawn. They can be assembled in this one way.
page-modes-count = With these lengths and this position of the drive there are {$count} ways to assemble it. The scene keeps the one that you choose.
page-modes-mode = Mode {$number}
page-modes-chosen = Mode {$number} is chosen.
page-modes-list = Assembly modes


## The workbench: parts

page-parts-needed = A number is needed here.
page-parts-unread = Not a number. Type 60, 2.5, 1/3, 2*pi or sqrt(2), with a unit if you like: 15 cm.
page-parts-other_unit = {$unit} cannot be converted to {$own}.
page-parts-least = At least {$least}.
page-parts-nameless = A name is needed.
page-parts-pin_point = Hold {$name} while shaping
page-parts-pin_length = Hold length {$name} while shaping
page-parts-unreadable = The scene’s text has a mistake, so the form waits. Mend it in the text, or undo.
page-parts-mend = Show in the text
page-parts-more = {$title}: all of it
page-parts-table_file = File (CSV)…


## The workbench: save

page-save-panel_title = Save
page-save-old_text = The scene’s text has a mistake. Pictures, numbers and prints are those of the last good text; scene file, page and link have the text as it is.
page-save-pictures = Pictures
page-save-figure = Figure
page-save-worksheet = Work sheet
page-save-this_step = Step {$number}
page-save-png_width = Width of PNG, in pixels
page-save-as = {$what} as {$format}
page-save-steps = Construction
page-save-coarse = Steps that belong together on one sheet
page-save-sheets = {$count} sheets, {$format} (ZIP)
page-save-steps_text = Text of the steps
page-save-packing = Sheet {$number} of {$count} …
page-save-film = Film
page-save-film_turn = One turn of the drive
page-save-film_about = The browser records the picture while the drives run as the scene says: for six seconds, or for each turn until the mechanism is where it began. Keep the page in sight; pulling, Play or a change of the scene breaks it off. GIF, for slides and messages, is made by the program: kinegon draw scene.json -o film.gif
page-save-filming = Recording …
page-save-film_taken = The film was broken off: something was moved or changed.
page-save-film_hidden = The film was broken off: the page was not in sight.
page-save-film_stuck = There is no film: the drive cannot move from where it stands.
page-save-cannot_film = This browser records no films. The program makes them: kinegon draw scene.json -o film.gif
page-save-numbers = Numbers
page-save-motion = Motion over the cycle (CSV)
page-save-results = Results (JSON)
page-save-scene = Scene
page-save-scene_about = The file goes back into this page and into the program. The page as one file has everything inside and needs no network: put it on a stick, a course page, a mail.
page-save-scene_file = Scene file
page-save-page_file = This page with the scene
page-save-page_about = The page was not loaded whole, so it cannot be saved. Reload it.
page-save-copy_link = Copy the link
page-save-print = Print at 100 %
page-save-print_now = Print …
page-save-size = {$name} {$width} mm × {$height} mm
page-save-on = Sheet {$number} of {$count}
page-save-preview = The sheet as it is printed
page-save-to_scale = In the print dialogue choose 100 % (actual size), this paper, and no margins.
page-save-ruler = The work sheet has a ruler. If it measures 50 mm on the print, everything is true to scale.
page-save-saved = Saved: {$name}


## The workbench: links

page-link-of = Link with the scene in it, {$size} characters
page-link-copied = The link is on the clipboard: {$size} characters.
page-link-not_copied = This browser does not let the page use the clipboard. The link is selected: copy it with Ctrl+C.
page-link-long = At {$size} characters this link is too long for some mail programs and chats. The scene file or the page as one file is safer.
page-link-local = This page was opened from a file of this computer: its links work only here. Open it from a web page to share links, or share the page as one file.


## The workbench: check

page-check-panel_title = Check
page-check-check = Check
page-check-task = Exercise {$name}
page-check-task_intro = Print the sheet at 100 %, draw the plans on it at its scales, then write below what you read off, or photograph it.
page-check-task_sheet = Sheet of the exercise
page-check-task_print = Print at 100 %
page-check-task_large = Read the sheet
page-check-task_small = Back to the mechanism
page-check-task_drag = Drag the sheet to see the rest of it; a double tap shows it whole.
page-check-task_next = Next exercise
page-check-task_is = This is exercise {$name}. Undo brings the one before back.
page-check-task_steps = Steps of the construction
page-check-task_making = The sheet is being made…
page-check-intro = Write what you have read off your drawing, value by value. Each is checked as soon as it stands there.
page-check-exam = This is an exam: draw on the board and hand in your drawing there. Nothing is judged or shown before that.
page-check-no_scene = This scene has no form to check: it cannot be solved.
page-check-no_boxes = This scene has no construction by hand, so its form has no boxes.
page-check-file = Form
page-check-open = Open…
page-check-save_json = Save
page-check-save_csv = CSV
page-check-clear = Clear
page-check-marks_open = Marks…
page-check-marks_drop = Without marks
page-check-marks_of = Marks by {$name}
page-check-opened = The form {$name} is open: {$count} values.
page-check-cleared = All values are gone; undo brings them back.
page-check-name = Your name
page-check-scales = 1 mm on your paper is
page-check-open_long = Open a form: JSON, or the CSV of a spreadsheet
page-check-save_json_long = Save the form as kinegon check reads it
page-check-save_csv_long = Save the form for a spreadsheet
page-check-clear_long = Empty all boxes
page-check-marks_open_long = Open a marking scheme: the values then earn marks
page-check-marks_drop_long = Check without marks
page-check-in = Lengths and segments in
page-check-in_mm = mm of paper
page-check-in_units = values
page-check-further = Also in this form
page-check-unknown = Not understood
page-check-remove = Remove {$name}
page-check-unit_of = Unit of {$name}
page-check-on_paper = mm of paper
page-check-is_on_paper = = {$value} mm on paper
page-check-sense_of = Sense of {$name}
page-check-ccw = counter-clockwise
page-check-cw = clockwise
page-check-along = along the guide
page-check-against = against the guide
page-check-choose_sense = choose the sense
page-check-choose_senses = Some rates have the right size, but no sense: choose ↺ or ↻ beside them, + or − for a slide.
page-check-from_points = from your points
page-check-typing = …
page-check-not_understood = not understood
page-check-step = Step {$step}
page-check-by_points = Mark points of a plan
page-check-points_intro = Click where the points of your plan lie, the pole first, of instant centres the first joint of the list; or type their places in mm, x to the right, y up. The paper may lie as it likes.
page-check-plan = Plan
page-check-points_sheet = Plan sheet, squares of 5 mm. Arrows move the cross by 1 mm, with Shift by 0.1 mm; Enter places the point that is chosen.
page-check-point = Point
page-check-place = Place {$name}
page-check-chosen = Next: {$name}
page-check-all_placed = All points have their places. Drag one to move it.
page-check-x_of = x of {$name} in mm
page-check-y_of = y of {$name} in mm
page-check-take_away = Take {$name} away
page-check-placed = {$name} at {$x} mm, {$y} mm
page-check-scale_first = Write the scale of this plan above first.
page-check-result = What the check says
page-check-nothing_yet = No value yet.
page-check-to_result = What happened
page-check-should = What it should be
page-check-show_step = Show this step
page-check-hint = A hint
page-check-next_hint = Another hint
page-check-follows = What follows
page-check-hand = How exact your drawing is
page-check-filled = {$filled} of {$all} boxes filled
page-check-first_off = First ✗
page-check-overlay = Show my drawing over the right one
page-check-overlay_none = There is nothing to draw: nothing is off.
page-check-overlay_shown = The picture shows your drawing over the right one: yours is dashed.
page-check-overlay_hide = Back to the picture
page-check-right_values = Show the right values
page-check-right_plan = Show the right plan
page-check-right_plan_later = The right plan can be shown when every box has a value that can be read.
page-check-right_plan_counts = This counts as taking every hint, and your form says so.
page-check-right_plan_shown = The right plan and all values are shown now.
page-check-feedback = Save the report as a page
page-check-mm = mm


## The workbench: photo

page-photo-title = Photograph of your drawing
page-photo-photograph = Photograph of your drawing…
page-photo-take = Photograph your drawing
page-photo-choose = Choose a picture…
page-photo-intro = Draw on the printed drawing sheet and photograph it, or drop the picture here: the right plan lies over it, and you mark your points. The picture stays on this device.
page-photo-again = Back to the photograph
page-photo-another = Another photograph…
page-photo-close = Close the photograph
page-photo-back = Back
page-photo-sheet_of = {$name}, sheet {$number}
page-photo-right_plan = Right plan
page-photo-right_later = The right plan can be shown when all points on this sheet are marked.
page-photo-larger = Larger
page-photo-smaller = Smaller
page-photo-fit = Fit
page-photo-undo = Undo
page-photo-opening = Opening the picture…
page-photo-reading = Reading the sheet…
page-photo-tap = Tap the point {$name}
page-photo-tap_in = Tap the point {$name} of the {$plan}
page-photo-tap_how = It goes to the crossing of your pencil lines. Hold the finger to see the place magnified.
page-photo-tap_mouse = It goes to the crossing of your pencil lines. Hold the button to see the place magnified.
page-photo-tap_none = Choose a point below, then tap where it is.
page-photo-at_printed = {$name} is where it is printed
page-photo-move_how = Drag it, or tap its right place; arrow keys move it by 0.1 mm.
page-photo-move_touch = Drag it, or tap its right place.
page-photo-outside = That is not on the sheet. Tap on the paper.
page-photo-is_right = {$name} is right
page-photo-is_off = {$name} is off by {$mm} mm
page-photo-is_open = {$name}: it cannot be told from this picture
page-photo-open_how = It is {$mm} mm from its place, and the picture is not sharp enough for more. Take a nearer, sharper one, or measure with a ruler.
page-photo-not_snapped = No pencil lines cross there: the place is known within {$mm} mm. Larger, or held and magnified, you aim better.
page-photo-leave_out = Leave {$name} out
page-photo-take_away = Take {$name} away
page-photo-accept = Accept {$name}
page-photo-accept_all = Accept all {$count}
page-photo-is_here = Is this your point {$name}?
page-photo-is_here_in = Is this your point {$name} of the {$plan}?
page-photo-proposed_how = Your pencil lines seem to have it there. Accept it, or tap where yours is.
page-photo-next = Next
page-photo-looking = Looking for your pencil lines…
page-photo-all_marked = All points are marked
page-photo-none_left = No more points to mark
page-photo-count_right = {$count} right
page-photo-count_off = {$count} off
page-photo-count_open = {$count} cannot be told from this picture
page-photo-count_out = {$count} left out
page-photo-see_check = See the check
page-photo-on_board = Go on with them on the board
page-photo-other_plan = Photograph the {$plan}…
page-photo-points = Points of the {$plan}
page-photo-state_none = not marked
page-photo-state_printed = as printed
page-photo-state_out = left out
page-photo-state_right = right
page-photo-state_off = off
page-photo-state_open = cannot be told from this picture
page-photo-state_proposed = proposed
page-photo-aim = Place of {$name}. Arrow keys move it by 0.1 mm, with Shift by 1 mm; Enter marks it.
page-photo-picture = The photograph
page-photo-moved = {$name} at {$x} mm, {$y} mm from {$origin}
page-photo-bent = The sheet is bent by {$mm} mm: press it flat for surer places.
page-photo-no_decode = This browser cannot open “{$name}” as a picture.
page-photo-no_decode_hint = Use a JPEG or PNG picture. A telephone that saves HEIC: take the picture from this page, or choose “Most Compatible” under Camera, Formats.
page-photo-no_scene = The scene has a mistake, so there is no plan to compare with.
page-photo-no_scene_hint = Mend the scene first, or undo.
page-photo-other_sheet = This is sheet {$number} of {$name}, not of this scene.
page-photo-other_sheet_hint = Open that exercise here, or photograph the sheet of this one. If the scene was changed since the sheet was printed, undo the change.
page-photo-nameless = another scene
page-photo-no_plan = This sheet has the scheme and no plan.
page-photo-no_plan_hint = Photograph the drawing sheet, on which you have drawn the plan.


## The workbench: the drawing board

page-board-title = Drawing board
page-board-begin = Draw here
page-board-go_on = Go on drawing
page-board-intro = Draw the plans on the screen with set square, dividers and pencil. The first wrong line is named.
page-board-close = Back
page-board-undo = Undo (Ctrl+Z)
page-board-redo = Redo (Ctrl+Y)
page-board-undone = Undone.
page-board-redone = Redone.
page-board-fit = Show all of the sheet
page-board-more = More
page-board-tools = Tools
page-board-sheets = Sheets
page-board-all_sheets = All
page-board-sheet = Drawing board: {$name}. Letters choose tools, N goes to the next possible place, Enter presses.
page-board-list = Operations
page-board-list_none = Nothing is drawn yet.
page-board-class = Class: {$count} drawings
page-board-class_minutes = {$minutes} min
page-board-class_away = Put the class away
page-board-back_to_here = Take back from here on
page-board-nothing_here = Nothing here for this tool.
page-board-write = Draw
page-board-own = own
page-board-hint = Hint
page-board-check = Check
page-board-hand_in = Hand in
page-board-into_form = Into the form
page-board-handed_in = The values are in the form.
page-board-handed_in_file = Your drawing is saved as {$file}, in your downloads. Give that file to your teacher. The values are in the form.
page-board-hand_in_drawn = { $count ->
    [one] {$count} operation is drawn.
   *[other] {$count} operations are drawn.
  }
page-board-hand_in_name = Your name
page-board-hand_in_what = Your drawing is saved as the file {$file}. Give that file to your teacher. Only then are your values judged.
page-board-save = Save the drawing
page-board-open = Open a drawing…
page-board-sheets_pdf = Sheets of paper (PDF)
page-board-no_drawing = “{$name}” is no drawing: it has no `kinegon_drawing`.
page-board-opened = “{$name}” is on the board.
page-board-put_back = Put the one before back
page-board-replay = Replay
page-board-end_replay = Back to drawing
page-board-look_on = Play draws it operation by operation; the slider goes to any of them.
page-board-play = Play
page-board-pause = Pause
page-board-speed = Speed
page-board-own_construction = Show the construction
page-board-own_drawing = Back to the own drawing
page-board-first_wrong = First wrong: operation {$number}
page-board-all_right = All is there, and all is right.
page-board-right_so_far = Right so far.
page-board-all_there = All that is asked for is there.
page-board-leads_nowhere = { $count ->
    [one] Operation {$numbers} leads to no point of the plan yet.
   *[other] Operations {$numbers} lead to no point of the plan yet.
  }
page-board-others_right = All others are right.
page-board-is_right = right
page-board-is_wrong = wrong
page-board-is_follows = follows from a wrong one
page-board-is_unused = leads nowhere yet
page-board-is_undone = taken back
page-board-normal = at right angles to
page-board-parallel = parallel to
page-board-turned = turned by the angle
page-board-at_base = from
page-board-angle = at the angle
page-board-other_way = The other way round
page-board-quarter = Turn by a quarter: along or across (T)
page-board-as_it_comes = as it comes
page-board-sign_back = Take back the last part
page-board-ccw = counter-clockwise
page-board-cw = clockwise
page-board-rubbed = {$name} is rubbed out, with what hung on it.
page-board-tool_lay_off = Dividers: lay off a vector
page-board-tool_line = Set square: line of known direction
page-board-tool_join = Ruler: line through two points
page-board-tool_cross = Pencil: point where two lines cross
page-board-tool_like = Image: similar triangle
page-board-tool_measure = Measure a distance
page-board-tool_compute = Calculator
page-board-tool_solve = Solve equations
page-board-tool_mark = Pencil: point by eye
page-board-tool_rub = Rubber: a thing and what hangs on it
page-board-short_lay_off = Dividers
page-board-short_line = Square
page-board-short_join = Ruler
page-board-short_cross = Pencil
page-board-short_like = Image
page-board-short_measure = Measure
page-board-short_compute = Reckon
page-board-short_solve = Solve
page-board-short_mark = Point
page-board-short_rub = Rubber
page-board-form_lay_off = In the {$on} lay off {$size} from {$from} {$how} {$reference} to {$name}
page-board-form_line = In the {$on} line {$how} {$reference} through {$through} named {$name}
page-board-form_join = In the {$on} line through {$first} and {$second} named {$name}
page-board-form_cross = {$first} and {$second} cross at {$name}
page-board-form_like = In the {$on} as {$three} lies to {$one} and {$two} so to {$first} and {$second} lies {$name}
page-board-form_measure = In the {$on} measure from {$from} to {$to} as {$name}
page-board-form_compute = {$name} = {$as} {$sense}
page-board-form_solve = For {$solve} solve {$equations}
page-board-form_mark = In the {$on} point {$name}
page-board-form_rub = Rub out {$name}
page-board-how_lay_off = The size; then press the point where it begins, and the link or line with its direction.
page-board-how_line = Press a link or a line: the square lies on it. Then press the point through which the line goes. T turns it.
page-board-how_join = Press two points.
page-board-how_cross = Press where two lines cross, and choose the point’s name.
page-board-how_like = Press three points of a link on the scheme, then the images of the first two.
page-board-how_measure = Press two points.
page-board-how_compute = Choose what it is, and write how it is reckoned.
page-board-how_solve = Name the unknowns, and write one equation a line.
page-board-how_mark = Press where the point is, and choose its name.
page-board-how_rub = Press the line or the point.
page-board-slot_sheet = Sheet
page-board-slot_point = Point
page-board-slot_scheme = Point of the scheme
page-board-slot_line = Line
page-board-slot_direction = Link, guide or line that gives the direction
page-board-slot_how = How it lies
page-board-slot_angle = Angle from +x in degrees
page-board-slot_formula = Formula
page-board-slot_formulas = Equations, one a line
page-board-slot_point_name = Name of the point
page-board-slot_line_name = Name of the line
page-board-slot_number_name = Name of the number
page-board-slot_names = Unknowns
page-board-slot_sense = Sense
page-board-slot_base = Line of the plan where the angle begins, such as b,c
page-board-slot_made = What was drawn
page-board-which_of = {$count} points are close together here: which one?
page-board-which_direction = {$count} directions meet here: which one?
page-board-wants_sheet = Which sheet?
page-board-wants_point = A point is missing: press one, or choose it.
page-board-wants_scheme = A point of the scheme is missing.
page-board-wants_line = A line is missing: press the crossing, or choose two.
page-board-wants_direction = The direction is missing: press a link or a line.
page-board-wants_how = How does it lie?
page-board-wants_angle = The angle is missing.
page-board-wants_formula = A number or a formula is missing.
page-board-wants_formulas = The equations are missing.
page-board-wants_point_name = Which point is it? Choose its name.
page-board-wants_line_name = The line needs a name.
page-board-wants_number_name = Which number is it? Choose its name.
page-board-wants_names = Which are the unknowns?
page-board-wants_sense = Which sense?
page-board-wants_base = At which line of the plan does the angle begin?
page-board-wants_made = Press what is to go.


## The workbench: sheets

page-sheets-scheme_short = Scheme
page-sheets-scheme_scaled = Scheme
page-sheets-scheme_panel = Scheme
page-sheets-scheme_name = scheme
page-sheets-scheme_title = Scheme
page-sheets-scheme_from = On the scheme
page-sheets-velocity_short = Velocity
page-sheets-velocity_scaled = Velocity
page-sheets-velocity_panel = Velocity plan
page-sheets-velocity_name = velocity plan
page-sheets-velocity_title = Velocity plan
page-sheets-velocity_from = From the velocity plan
page-sheets-acceleration_short = Acceleration
page-sheets-acceleration_scaled = Acceleration
page-sheets-acceleration_panel = Acceleration plan
page-sheets-acceleration_name = acceleration plan
page-sheets-acceleration_title = Acceleration plan
page-sheets-acceleration_from = From the acceleration plan
page-sheets-centers_short = Centres
page-sheets-centers_scaled = Centres
page-sheets-centers_panel = Instant centres
page-sheets-centers_name = figure of instant centres
page-sheets-centers_title = Instant centres
page-sheets-centers_from = From the centres
page-sheets-forces_short = Forces
page-sheets-forces_scaled = Forces
page-sheets-forces_panel = Force plan
page-sheets-forces_name = force plan
page-sheets-forces_title = Force plan
page-sheets-forces_from = From the force plan
page-sheets-lever_short = Lever
page-sheets-lever_scaled = Lever
page-sheets-lever_panel = Lever
page-sheets-lever_name = lever
page-sheets-lever_title = Lever
page-sheets-lever_from = From the lever
page-sheets-speeds_short = Speeds
page-sheets-speeds_scaled = Speeds
page-sheets-speeds_panel = Speed diagram
page-sheets-speeds_name = speed diagram
page-sheets-speeds_title = Speed diagram
page-sheets-speeds_from = From the speed diagram


## The workbench: refused

page-refused-line = Line {$line}: {$message}


## The workbench: subject

page-subject-link = Link {$name}
page-subject-slider = Slider {$name}
page-subject-point = Point {$name}
page-subject-others = Others


## The workbench: kinds


## The workbench: editor


## The component <kinegon-plan>

page-component-none = The plan has no scene: give it the address of one in src, or write one between its tags in a script of the type application/json.
page-component-unread = {$src} could not be read ({$why}).
page-component-from_file = A page that is opened from a file may not read others: write the scene between the tags.
