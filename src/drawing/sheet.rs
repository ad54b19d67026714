use kurbo::Rect;

use super::look::{Look, look};
use super::shape::{Shape, overlap};

/// A sheet of paper and everything drawn on it; later marks cover earlier ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Width of the sheet in mm.
    pub width: f64,
    /// Height of the sheet in mm.
    pub height: f64,
    /// What the figure is called; written into the file, not drawn.
    pub title: String,
    /// What the figure shows, in a sentence for readers who cannot see it; written into the file,
    /// not drawn.
    pub description: String,
    /// Everything drawn, in drawing order.
    pub marks: Vec<Mark>,
    /// Boxes of the panels, in order, each with its name.
    pub panels: Vec<(String, Rect)>,
    /// What is done in each step of the construction, in plain words, which [`Mark::since`] counts.
    pub steps: Vec<String>,
}

impl Drawing {
    /// An empty sheet of `width` by `height` mm.
    pub fn new(width: f64, height: f64) -> Self {
        Self {
            width,
            height,
            title: String::new(),
            description: String::new(),
            marks: Vec::new(),
            panels: Vec::new(),
            steps: Vec::new(),
        }
    }

    /// Draws a nameless mark on top of the others.
    pub fn draw(&mut self, pen: Pen, shape: Shape) {
        self.marks.push(Mark::new(pen, shape));
    }

    /// Draws a mark that slide programs and scripts can find by `id`.
    pub fn draw_named(&mut self, id: impl Into<String>, pen: Pen, shape: Shape) {
        self.marks.push(Mark {
            id: Some(id.into()),
            ..Mark::new(pen, shape)
        });
    }

    /// The sheet as it stands after a step, from 1: what comes with the step in the accent colour, what came before it calm.
    ///
    /// Everything keeps its place from step to step. After the last step the figure is finished.
    #[must_use]
    pub fn after_step(&self, step: usize) -> Drawing {
        let shown = self.marks.iter().filter_map(|mark| {
            let since = usize::from(mark.since);
            let emphasis = match since {
                0 => Emphasis::Plain,
                _ if step > self.steps.len() => Emphasis::Plain,
                _ if since == step => Emphasis::New,
                _ => Emphasis::Earlier,
            };
            let shows = since <= step && !(mark.passing && since < step);
            shows.then(|| Mark {
                emphasis,
                ..mark.clone()
            })
        });
        let words = self.steps.get(step.wrapping_sub(1));
        Drawing {
            marks: shown.collect(),
            title: self.title.clone(),
            panels: self.panels.clone(),
            description: words.cloned().unwrap_or_default(),
            steps: Vec::new(),
            ..*self
        }
    }
}

impl Drawing {
    /// For each mark, whether it is a text that needs its halo: one with lines of earlier marks
    /// running through it.
    ///
    /// Over blank paper a halo is not seen, and over a tinted area it would be a stain.
    pub fn halos(&self) -> Vec<bool> {
        let bounds: Vec<Rect> = self.marks.iter().map(|mark| mark.shape.bounds()).collect();
        let needs = self.marks.iter().enumerate().map(|(index, mark)| {
            let halo = mark.look().halo;
            let Shape::Text(text) = &mark.shape else {
                return false;
            };
            let area = text.ink_box().inflate(0.5 * halo, 0.5 * halo);
            let below = self.marks[..index].iter().zip(&bounds);
            halo > 0.0
                && below.into_iter().any(|(other, bounds)| {
                    overlap(*bounds, area)
                        && other.look().stroke.is_some()
                        && other.shape.lines_cross(area)
                })
        });
        needs.collect()
    }
}

/// One thing drawn on the sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// A stable name such as `point-S3`, unique in its drawing, or none.
    pub id: Option<String>,
    /// What the mark is; its look follows from that.
    pub pen: Pen,
    /// Where it is.
    pub shape: Shape,
    /// With which step of the construction it comes, from 1; 0 for what stands there from the start.
    pub since: u16,
    /// Whether it is there in that step alone: words, or a hint at what is meant.
    pub passing: bool,
    /// How it stands out.
    pub emphasis: Emphasis,
}

/// How a mark stands out among the others.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Emphasis {
    /// As its pen has it.
    #[default]
    Plain,
    /// In the accent colour.
    New,
    /// Paler, so that new marks are seen first.
    Earlier,
}

impl Mark {
    /// A nameless mark that stands there from the start.
    pub fn new(pen: Pen, shape: Shape) -> Self {
        Self {
            id: None,
            pen,
            shape,
            since: 0,
            passing: false,
            emphasis: Emphasis::Plain,
        }
    }

    /// How it looks.
    #[must_use]
    pub fn look(&self) -> Look {
        let look = look(self.pen);
        match self.emphasis {
            // Words are read, not looked for.
            _ if matches!(self.pen, Pen::Caption | Pen::Heading | Pen::Hint) => look,
            Emphasis::Plain => look,
            Emphasis::New => look.accented(),
            Emphasis::Earlier => look.calmed(),
        }
    }
}

/// What a mark *is*. Colour, width, dash and fill come from [`look`](super::look()), so a figure is
/// restyled in one place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Pen {
    /// The border of a panel, axes, the bar of a scale.
    Frame,
    /// The line of the frame that a pivot or a guide stands on.
    Ground,
    /// The short strokes under a ground line.
    Hatch,
    /// A link drawn as a line, or the outline of one drawn as an area.
    Link,
    /// The tinted area of a link; the number picks the tint (four of them, repeating).
    LinkFill(u8),
    /// A sliding block: outlined and white inside.
    Slider,
    /// The straight guide that a block slides on.
    Guide,
    /// A revolute joint: a small circle, white inside.
    Joint,
    /// The path of a point over a cycle.
    Trace,
    /// A helping line: thin, grey, dashed.
    Construction,
    /// A line of known direction in a plan: thin, coloured, dash-dotted.
    Ray,
    /// A vector that is neither of the kinds below.
    Vector,
    /// A velocity.
    Velocity,
    /// A total acceleration.
    Acceleration,
    /// A normal part of an acceleration, known before the plan is closed.
    Normal,
    /// A tangential part, found by closing the plan.
    Tangential,
    /// A Coriolis part.
    Coriolis,
    /// The pole of a plan.
    Pole,
    /// The outline of the image of a link in a plan.
    Image,
    /// The area of such an image.
    ImageFill,
    /// The end of a vector in a plan, the image of a point: a small dot.
    ImagePoint,
    /// A special (Assur) point and what belongs to it.
    Special,
    /// The sense of turning: curved arrows of ω and α.
    Turning,
    /// The line from a label to what it names when it had to stand apart.
    Leader,
    /// The name of a point, a link or a vector; haloed, so that it reads across lines.
    Label,
    /// What a step is about, in that step alone: a broad pale line under a length or a direction.
    Hint,
    /// Running text: scales, equations, captions.
    Caption,
    /// The heading of a panel or a sheet.
    Heading,
    /// A line at a round value of an axis.
    Grid,
    /// The line at zero.
    Zero,
    /// A quantity over the cycle, its name, and the dots at its greatest and least values; the number picks the style (twelve of
    /// them, repeating).
    Curve(u8),
    /// A dead position of the link or slider: a small circle on the line at zero.
    Dead(u8),
    /// Where a drive can go no further.
    Limit,
    /// Where the motion could go on in another assembly mode too.
    Change,
    /// Where the drive stands in the scene.
    Stand,
}

#[cfg(test)]
mod tests {
    use super::super::text::{PlacedText, RichText};
    use super::*;
    use kurbo::Point;

    #[test]
    fn halos_only_where_lines_run_through() {
        let mut drawing = Drawing::new(100.0, 100.0);
        let text = |x, y| {
            Shape::Text(PlacedText::new(
                RichText::math("S_3"),
                4.0,
                Point::new(x, y),
            ))
        };
        drawing.draw(
            Pen::Link,
            Shape::Line(Point::new(0.0, 0.0), Point::new(100.0, 100.0)),
        );
        drawing.draw(
            Pen::LinkFill(0),
            Shape::Polygon(vec![
                Point::new(60.0, 0.0),
                Point::new(90.0, 0.0),
                Point::new(75.0, 40.0),
            ]),
        );
        drawing.draw(
            Pen::Joint,
            Shape::Circle {
                center: Point::new(20.0, 80.0),
                radius: 10.0,
            },
        );
        drawing.draw(Pen::Label, text(50.0, 51.0));
        drawing.draw(Pen::Label, text(10.0, 51.0));
        drawing.draw(Pen::Label, text(59.0, 1.0));
        drawing.draw(Pen::Label, text(29.0, 81.0));
        drawing.draw(Pen::Label, text(18.0, 81.0));
        drawing.draw(Pen::Caption, text(50.0, 51.0));
        drawing.draw(
            Pen::Link,
            Shape::Line(Point::new(0.0, 51.0), Point::new(30.0, 51.0)),
        );
        assert_eq!(
            drawing.halos()[3..9],
            [true, false, false, true, false, false]
        );
    }

    #[test]
    fn numbers_that_are_not_finite_do_no_harm() {
        let mut drawing = Drawing::new(f64::NAN, -1.0);
        for wrong in [f64::NAN, f64::INFINITY, -3.0] {
            let (center, radius) = (Point::new(wrong, 1.0), wrong);
            drawing.draw(Pen::Joint, Shape::Circle { center, radius });
            drawing.draw(
                Pen::Turning,
                Shape::ArcArrow {
                    center,
                    radius,
                    start: wrong,
                    sweep: wrong,
                },
            );
            drawing.draw(
                Pen::Velocity,
                Shape::Arrow {
                    from: center,
                    to: Point::ORIGIN,
                },
            );
            drawing.draw(Pen::Link, Shape::Polygon(vec![]));
            let text = PlacedText::new(RichText::math("S_3"), wrong, center);
            drawing.draw(Pen::Label, Shape::Text(text));
        }
        assert_eq!(drawing.halos().len(), drawing.marks.len());
        assert!(!crate::format::svg(&drawing).contains("NaN"));
    }
}
