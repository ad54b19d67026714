use kurbo::Rect;

use super::look::Look;
use super::shape::{Shape, overlap};
use super::style::Style;
use schemars::JsonSchema;
use serde::Deserialize;

/// A sheet of paper and everything drawn on it; later marks cover earlier ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Width of the sheet in mm.
    pub width: f64,
    /// Height of the sheet in mm.
    pub height: f64,
    /// What the figure is called; written into the file, not drawn.
    pub title: String,
    /// Code of the language of its texts, as in `en`; written into the file, not drawn.
    pub language: &'static str,
    /// What the figure shows, in a sentence for readers who cannot see it; written into the file,
    /// not drawn.
    pub description: String,
    /// How it looks.
    pub style: Style,
    /// Everything drawn, in drawing order.
    pub marks: Vec<Mark>,
    /// Boxes of the panels, in order, each with its name.
    pub panels: Vec<(String, Rect)>,
    /// What is done in each step of the construction, in plain words, which [`Mark::since`] counts.
    pub steps: Vec<String>,
}

impl Drawing {
    /// An empty sheet of `width` by `height` mm, in the standard style.
    pub fn new(width: f64, height: f64) -> Self {
        Self {
            width,
            height,
            title: String::new(),
            language: "en",
            description: String::new(),
            style: Style::default(),
            marks: Vec::new(),
            panels: Vec::new(),
            steps: Vec::new(),
        }
    }

    /// Draws a nameless mark on top of the others.
    pub fn draw(&mut self, pen: Pen, shape: Shape) -> &mut Mark {
        self.add(Mark::new(pen, shape))
    }

    /// Draws a mark that slide programs and scripts can find by `id`.
    pub fn draw_named(&mut self, id: impl Into<String>, pen: Pen, shape: Shape) -> &mut Mark {
        self.add(Mark { id: Some(id.into()), ..Mark::new(pen, shape) })
    }

    /// Puts a mark on top of the others.
    pub fn add(&mut self, mark: Mark) -> &mut Mark {
        self.marks.push(mark);
        self.marks.last_mut().expect("a mark was added")
    }

    /// How one of its marks looks.
    #[must_use]
    pub fn look(&self, mark: &Mark) -> Look {
        let look = self.style.look(mark.pen, mark.number);
        match mark.emphasis {
            // Words are read, not looked for.
            _ if matches!(mark.pen, Pen::Caption | Pen::Heading | Pen::Hint) => look,
            Emphasis::Plain => look,
            Emphasis::New => self.style.accented(look),
            Emphasis::Earlier => self.style.calmed(look),
        }
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
            shows.then(|| Mark { emphasis, ..mark.clone() })
        });
        let words = self.steps.get(step.wrapping_sub(1));
        Drawing {
            marks: shown.collect(),
            title: self.title.clone(),
            panels: self.panels.clone(),
            description: words.cloned().unwrap_or_default(),
            style: self.style.clone(),
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
        let below = |mark: &Mark| (mark.shape.bounds(), self.look(mark).stroke.is_some());
        let drawn: Vec<(Rect, bool)> = self.marks.iter().map(below).collect();
        let needs = self.marks.iter().enumerate().map(|(index, mark)| {
            let Shape::Text(text) = &mark.shape else {
                return false;
            };
            let halo = self.look(mark).halo;
            let area = text.ink_box().inflate(0.5 * halo, 0.5 * halo);
            let below = self.marks[..index].iter().zip(&drawn);
            halo > 0.0
                && below
                    .into_iter()
                    .any(|(other, (bounds, lines))| *lines && overlap(*bounds, area) && other.shape.lines_cross(area))
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
    /// The number of the link or the curve that it belongs to, counted from 0, by which a style picks its colour; none for a
    /// mark of neither.
    pub number: Option<usize>,
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
        Self { id: None, pen, number: None, shape, since: 0, passing: false, emphasis: Emphasis::Plain }
    }
}

/// What a mark *is*. Colour, width, dash and fill come from the drawing's [`Style`], so a figure is
/// restyled in one place. Style files write pens in small letters: `link_fill`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Pen {
    /// The border of a panel, axes, the bar of a scale.
    Frame,
    /// The line of the frame that a pivot or a guide stands on.
    Ground,
    /// The short strokes under a ground line.
    Hatch,
    /// A link drawn as a line, or the outline of one drawn as an area.
    Link,
    /// The tinted area of a link.
    LinkFill,
    /// A sliding block, or a pivot's foot: outlined.
    Slider,
    /// The straight guide that a block slides on.
    Guide,
    /// A revolute joint: a small circle.
    Joint,
    /// The path of a point over a cycle.
    Trace,
    /// A helping line of the scheme.
    Construction,
    /// A line of known direction in a plan.
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
    /// A quantity over the cycle, its name, and the dots at its greatest and least values.
    Curve,
    /// A dead centre of the link or slider: a small circle on the line at zero.
    Dead,
    /// Where a drive can go no further.
    Limit,
    /// Where the motion could go on in another assembly mode too.
    Change,
    /// Where the drive stands in the scene.
    Stand,
    /// A line of a student's drawing over the right one.
    Student,
    /// A point of such a drawing, a small cross, and its name.
    StudentPoint,
}

impl Pen {
    /// How many pens there are.
    pub(super) const COUNT: usize = Pen::StudentPoint as usize + 1;
}

#[cfg(test)]
mod tests {
    use super::super::text::{PlacedText, RichText};
    use super::*;
    use kurbo::Point;

    #[test]
    fn halos_only_where_lines_run_through() {
        let mut drawing = Drawing::new(100.0, 100.0);
        let text = |x, y| Shape::Text(PlacedText::new(RichText::math("S_3"), 4.0, Point::new(x, y)));
        drawing.draw(Pen::Link, Shape::Line(Point::new(0.0, 0.0), Point::new(100.0, 100.0)));
        drawing.draw(
            Pen::LinkFill,
            Shape::Polygon(vec![Point::new(60.0, 0.0), Point::new(90.0, 0.0), Point::new(75.0, 40.0)]),
        );
        drawing.draw(Pen::Joint, Shape::Circle { center: Point::new(20.0, 80.0), radius: 10.0 });
        drawing.draw(Pen::Label, text(50.0, 51.0));
        drawing.draw(Pen::Label, text(10.0, 51.0));
        drawing.draw(Pen::Label, text(59.0, 1.0));
        drawing.draw(Pen::Label, text(29.0, 81.0));
        drawing.draw(Pen::Label, text(18.0, 81.0));
        drawing.draw(Pen::Caption, text(50.0, 51.0));
        drawing.draw(Pen::Link, Shape::Line(Point::new(0.0, 51.0), Point::new(30.0, 51.0)));
        assert_eq!(drawing.halos()[3..9], [true, false, false, true, false, false]);
    }

    #[test]
    fn numbers_that_are_not_finite_do_no_harm() {
        let mut drawing = Drawing::new(f64::NAN, -1.0);
        for wrong in [f64::NAN, f64::INFINITY, -3.0] {
            let (center, radius) = (Point::new(wrong, 1.0), wrong);
            drawing.draw(Pen::Joint, Shape::Circle { center, radius });
            drawing.draw(Pen::Turning, Shape::ArcArrow { center, radius, start: wrong, sweep: wrong });
            drawing.draw(Pen::Velocity, Shape::Arrow { from: center, to: Point::ORIGIN });
            drawing.draw(Pen::Link, Shape::Polygon(vec![]));
            let text = PlacedText::new(RichText::math("S_3"), wrong, center);
            drawing.draw(Pen::Label, Shape::Text(text));
        }
        assert_eq!(drawing.halos().len(), drawing.marks.len());
        assert!(!drawing.svg().contains("NaN"));
    }
}
