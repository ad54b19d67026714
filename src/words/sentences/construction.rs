//! Sentences of the construction: what its steps say to do, its equations, and the text of the steps.

sentences! {
    Group::Construction =>

    // Names of lines.
    /// The guide of a slider.
    guide_of(slider);
    /// A cut line of a leg with a slider: through `point`, normal to the guide.
    normal_to_guide(slider, point);
    /// The cut line of a leg with two sliders, on which all directions meet.
    line_at_infinity;

    // Steps that are shown together.
    /// Several special points.
    join_special_points(points);
    /// Several vectors, each by its ends.
    join_lay_off(vectors);
    /// A ray normal to a line, within `join_cross`.
    join_normal(through, line);
    /// A ray parallel to a line, likewise.
    join_parallel(through, line);
    /// A ray at an angle, likewise.
    join_at_angle(through, angle);
    /// Two rays and where they cross.
    join_cross(first, second, point);
    /// Several lengths or segments, each by its ends.
    join_measure(lengths);
    /// The rates that follow from measured segments.
    join_rates(segments, unknowns);
    /// Images of further points.
    join_images(points);

    // Steps of the construction.
    /// The pole of a plan and its scale.
    choose_pole(pole, scale);
    /// The pole of a plan, its scale, and the images of points at rest, which lie at the pole.
    choose_pole_with(pole, scale, images);
    /// A special point, where two cut lines meet.
    special_point(point, link, first, second);
    /// A special point at infinity, where two cut lines are parallel; their direction in degrees.
    special_point_at_infinity(point, link, direction, first, second);
    /// The length between two points of the scheme.
    measure_length(from, to);
    /// The velocity of a point of a driven link; `arm` is the line to which it is normal.
    lay_off_velocity(point, arm, link);
    /// The acceleration of a point of a driven link that turns uniformly.
    lay_off_normal_acceleration(point, pivot, link);
    /// The acceleration of a point of a driven link with angular acceleration.
    lay_off_whole_acceleration(point, pivot, arm);
    /// A velocity or acceleration that the scene gives.
    lay_off_given(vector);
    /// The vector of the point of a known body that coincides with a point of another link.
    lay_off_point_under(body, point);
    /// A ray normal to a line: the plan point on it, the line, the image that is sought.
    ray_normal(through, line, image);
    /// A ray parallel to a line: the plan point on it, the line, the image that is sought.
    ray_parallel(through, line, image);
    /// A ray at the angle that two lines of the mechanism make: the plan point on it, the angle, the image that is sought.
    ray_at_angle(through, angle, image);
    /// The image of a point on the line of two others: their images, the ratio of two lengths, the image.
    divide(from, to, part, whole, image);
    /// The image of a point of a link that does not turn: the link, the image, the image with which it coincides.
    coincide(link, image, with);
    /// The crossing of two rays, which is the image.
    cross(image);
    /// The segment between two points of a plan.
    measure_segment(from, to);
    /// The normal part along a cut line, between two points of the acceleration plan.
    lay_off_normal_part(line, centre, from, to);
    /// The normal parts of both links of a leg, laid off as one.
    lay_off_normal_parts(line, from, to);
    /// The equations that give the rates of a group.
    solve(unknowns);
    /// For a group without a construction by two rays.
    no_construction;
    /// For a group whose special points lie at infinity.
    no_construction_far(points);
    /// The velocity of a point of a link of known rotation, relative to another of its points.
    lay_off_relative(link, point, from, arm);
    /// The normal acceleration of one point of a link relative to another: the point, the other, their line.
    lay_off_relative_normal(point, from, arm);
    /// The tangential acceleration of one point of a link relative to another: the link, the point, the other, their line.
    lay_off_relative_tangential(link, point, from, arm);
    /// The sliding velocity of a slider, between two points of the plan.
    lay_off_sliding_velocity(slider, from, to);
    /// The same backwards, with its head at a point that is there: the chain runs from the sliding link to the guide.
    lay_off_sliding_velocity_backwards(slider, from, to);
    /// The sliding acceleration of a slider, between two points of the plan.
    lay_off_sliding_acceleration(slider, from, to);
    /// The same backwards.
    lay_off_sliding_acceleration_backwards(slider, from, to);
    /// The Coriolis acceleration of a slider, the link that carries its guide, two points of the plan.
    lay_off_coriolis(slider, link, from, to);
    /// The same backwards.
    lay_off_coriolis_backwards(slider, link, from, to);

    // Words of equations.
    /// Behind a given vector.
    given;
    /// Before the first product of which a vector is made.
    made_from;
    /// Before each further product.
    and;
    /// Name of the normal part of an acceleration.
    normal;
    /// Name of the tangential part of an acceleration.
    tangential;
    /// Name of the sliding part of a vector.
    sliding;
    /// Name of the Coriolis part of an acceleration.
    coriolis;

    // The text of the steps.
    /// All scales of the figure.
    scales(scales);
    /// One scale, in units per mm of paper.
    scale_per_mm(scale, value, unit);
    /// What the bands ± mean, with the limits of a hand's errors.
    bands(mm, degrees);
    /// Why a value has no band: no construction.
    no_band_no_construction;
    /// Why a value has no band: the figure lacks the panel.
    no_band_no_sheet(panel);
    /// Heading of the steps on the scheme.
    on_the_mechanism;
    /// Relative difference of the rates from construction and loop equations, and the one that crossings allow.
    routes_differ(difference, allowed);
    /// A length on paper, in mm.
    on_paper(mm);
    /// Behind a rough band.
    only_roughly;
    /// Direction of a ray, in degrees.
    direction(degrees);
    /// Angle between two rays, in degrees.
    angle_of_crossing(degrees);
}
