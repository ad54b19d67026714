//! Sentences of figures and curves.

use crate::sheet::Sheet;

sentences! {
    Group::Figure =>

    // The figure.
    /// Title of a figure whose scene has none.
    title;
    /// Heading of the scheme.
    scheme;
    /// Heading of the velocity plan.
    velocity_plan;
    /// Heading of the acceleration plan.
    acceleration_plan;
    /// Distance of a special point off the sheet from another point.
    far_away(point, distance, from);
    /// Distance on paper of an image off the panel, in mm, at its line.
    far_in_plan(point, distance);
    /// In a panel whose content is larger.
    cut_at_edge;
    /// In a panel with more names than it can show.
    names_without_room;
    /// Of a special point at infinity.
    at_infinity(point);
    /// The paths of these points, and the step of the drive between their ticks.
    paths(points, step, drive);
    /// The same, with the time that the step takes.
    paths_in_time(points, step, drive, time);
    /// The path of a point as a chart.
    path_of(point, unit);
    /// At another assembly mode, by its number.
    mode(number);
    /// That not all other assembly modes are drawn.
    modes_left_out(count);
    /// What is drawn of a path on other branches of the motion.
    paths_beyond;
    /// Relative difference of the rates from construction and loop equations, and the one that crossings allow.
    agreement(difference, allowed);
    /// Why rates come from the loop equations alone: a special point at infinity.
    one_route_far;
    /// Why rates come from the loop equations alone: no construction by two rays.
    one_route;
    /// A vector by size and direction, in degrees.
    with_direction(size, degrees);
    /// Heading of the names of measured segments.
    segment;
    /// Heading of their values.
    value;
    /// Heading of the table of values that have no place in the panels.
    values;
    /// Caption of the ruler of 50 mm, which shows whether a sheet was printed at 100 %.
    ruler;
    /// Alternative text of the figure.
    description(panels, groups);
    /// The scheme, in the alternative text.
    described_scheme;
    /// The velocity plan, in the alternative text.
    described_velocity_plan;
    /// The acceleration plan, in the alternative text.
    described_acceleration_plan;
    /// An Assur group, in the alternative text.
    described_group(class, links);
    /// The class of a group above class IV.
    higher;

    // Curves.
    /// Title of curves whose scene has none.
    curves;
    /// Title: the path of a vector's tip over the cycle.
    hodograph(vector);
    /// Kind of quantity: angle.
    angle;
    /// Kind of quantity: angular velocity.
    angular_velocity;
    /// Kind of quantity: angular acceleration.
    angular_acceleration;
    /// Kind of quantity: coordinate, or position along a guide.
    position;
    /// Kind of quantity: distance.
    length;
    /// Kind of quantity: velocity.
    velocity;
    /// Kind of quantity: acceleration.
    acceleration;
    /// Heading of a panel: kind of quantity and unit.
    in_unit(kind, unit);
    /// Label of the axis of a turning drive; the symbol of its angle.
    drive_angle(symbol);
    /// Label of the axis of a sliding drive.
    drive_position(drive, unit);
    /// Legend of the vertical line at a limit position.
    limit;
    /// Legend of the vertical line at a change point.
    change;
    /// Legend of the vertical line at the scene's own position.
    scene;
    /// Legend of the mark of a dead centre.
    dead_centre;
    /// Legend of the mark of an extreme value.
    extremes;
    /// Alternative text of curves: the drive's quantity, its first and last value.
    over(drive, from, to);
    /// Alternative text: a constant quantity.
    is_constant(quantity, value);
    /// Alternative text: the least value, and the drive's value there.
    least(value, at);
    /// Alternative text: the greatest value, and the drive's value there.
    greatest(value, at);
    /// Alternative text: no least value.
    no_least;
    /// Alternative text: no greatest value.
    no_greatest;
}

impl Language {
    /// Heading of a sheet.
    #[must_use]
    pub fn sheet(&self, sheet: Sheet) -> &str {
        match sheet {
            Sheet::Scheme => self.scheme(),
            Sheet::Velocity => self.velocity_plan(),
            Sheet::Acceleration => self.acceleration_plan(),
        }
    }
}
