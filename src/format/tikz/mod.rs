use super::number::{number, push_number};
use crate::drawing::{
    Anchor, Cap, Colour, Drawing, Emphasis, Look, Mark, Outline, OutlinePart, PlacedText, Point, Shape, Vec2,
};
use crate::text::tex_comment;
use std::collections::BTreeMap;
use std::fmt::Write;

mod words;

impl Drawing {
    /// The drawing as the text of a LaTeX file: a TikZ picture, true to scale in mm.
    ///
    /// The file compiles by itself; a document that loads the package `tikz` can read it with `\input` and gets the
    /// picture alone. Colours and styles have names, one for each pen; definitions that the document makes before take
    /// precedence. Texts are LaTeX text and formulas in the document's own fonts; each keeps the place of its left end,
    /// middle or right end, because those fonts are not the measured one. A text with a letter that plain LaTeX lacks
    /// is drawn by the outlines of the bundled font. Marks whose numbers are not finite, or too large for TeX, are left
    /// out.
    pub fn tikz(&self) -> String {
        let marks = self.marks.iter().zip(self.halos());
        let marks: Vec<(&Mark, bool)> = marks.filter(|(mark, _)| fits(&mark.shape)).collect();
        let mut file = head(self);
        let mut used: BTreeMap<String, (Look, Used)> = BTreeMap::new();
        for (mark, _) in &marks {
            let used = used.entry(name(self, mark));
            let (_, used) = used.or_insert_with(|| (self.look(mark), Used::default()));
            let is_text = matches!(mark.shape, Shape::Text(_));
            used.texts |= is_text;
            used.lines |= !is_text;
        }
        let background = self.style.background();
        write_colour(&mut file, "background", background);
        for (name, (look, used)) in used {
            write_style(&mut file, &name, &look, used);
        }
        let [width, height] = [self.width, self.height].map(number);
        let _ = write!(
            file,
            "\\begin{{tikzpicture}}[x=1mm,y=-1mm]\n\\useasboundingbox (0,0) rectangle ({width},{height});\n"
        );
        if background != Colour::new(0xffffff) {
            let _ = writeln!(file, "\\fill[kinegon-background] (0,0) rectangle ({width},{height});");
        }
        // Consecutive marks of one pen, as in SVG: all halos come before all letters, so that none covers a neighbour.
        for marks in marks.chunk_by(|a, b| a.0.pen == b.0.pen) {
            for (mark, _) in marks.iter().filter(|mark| mark.1) {
                write_mark(&mut file, self, mark, true);
            }
            for (mark, _) in marks {
                write_mark(&mut file, self, mark, false);
            }
        }
        file.push_str("\\end{tikzpicture}%\n\\kinegonend\n");
        file
    }
}

/// Whether a shape's coordinates are finite and below 5 m: TeX's lengths end at 5.7 m.
fn fits(shape: &Shape) -> bool {
    let bounds = shape.bounds();
    let sides = [bounds.x0, bounds.y0, bounds.x1, bounds.y1];
    shape.is_drawable() && sides.iter().all(|side| side.abs() < 5000.0)
}

/// The text before the styles: comments, the document around a picture that is compiled by itself, and macros common to
/// all figures.
fn head(drawing: &Drawing) -> String {
    let mut head = String::new();
    for text in [drawing.title.for_tex_comment(), tex_comment(&drawing.description)] {
        if !text.trim().is_empty() {
            let _ = writeln!(head, "% {text}");
        }
    }
    head.push_str(ABOUT);
    let [width, height] = [drawing.width, drawing.height].map(number);
    head.push_str(&ALONE.replace("WIDTH", &width).replace("HEIGHT", &height));
    head.push_str(SHARED);
    head
}

const ABOUT: &str = r"% A figure of Kinegon, in mm. It compiles by itself; a document that loads the package tikz takes it with \input.
% Before \input, \definecolor{kinegon-velocity}{HTML}{...} or \tikzset{kinegon/velocity/.style={...}} gives a pen another look.
% Texts are set at \kinegonscale (0.92) of the drawing's size, because Computer Modern is wide, and narrower where they would not fit.
% Where a language of babel makes ; or : active: \usetikzlibrary{babel}.
";

/// The document around a picture that is compiled by itself; it expands to nothing inside another document.
const ALONE: &str = r"\expandafter\ifx\csname @twoclasseserror\endcsname\documentclass
  \def\kinegonend{\endinput}%
\else
  \documentclass{article}
  \usepackage[paperwidth=WIDTHmm,paperheight=HEIGHTmm,margin=0mm]{geometry}
  \usepackage{tikz}
  % The picture is as high as the page, and rounding must not push it off.
  \addtolength{\textheight}{1mm}
  \setlength{\topskip}{0pt}
  \setlength{\parindent}{0pt}
  \pagestyle{empty}
  \def\kinegonend{\end{document}}
  \begin{document}
\fi
";

/// Macros that define pens' styles unless the document has, and that set texts.
///
/// Texts are set at 10 pt, which every font has, and scaled. In Computer Modern prose is 11 % wider than the drawing
/// measured it in the bundled font, and labels 19 % (over all texts of the starting scenes). So letters are set
/// somewhat smaller, and a text that is still too wide is made narrower; no text covers a place that the drawing has
/// kept free.
const SHARED: &str = r"\providecommand\kinegonstyle[2]{\pgfkeysifdefined{/tikz/kinegon/#1/.@cmd}{}{\tikzset{kinegon/#1/.style={#2}}}}%
\providecommand\kinegonscale{0.92}%
\providecommand\kinegontext[2]{\setbox0\hbox{#2}\pgfmathsetlengthmacro\kinegonwidth{#1*10pt/\kinegonscale}%
  \ifdim\wd0>\kinegonwidth\relax\resizebox{\kinegonwidth}{\height}{\box0}\else\box0\fi}%
\kinegonstyle{text}{draw=none,fill=none,inner sep=0pt,outer sep=0pt,font=\fontsize{10}{12}\selectfont,scale={\kinegonscale*#1/3.5146}}%
\kinegonstyle{left}{kinegon/text=#1,anchor=base west}%
\kinegonstyle{middle}{kinegon/text=#1,anchor=base}%
\kinegonstyle{right}{kinegon/text=#1,anchor=base east}%
\providecommand\kinegonhalo[4]{\foreach\kinegonangle in {0,30,...,330}%
  {\node[#2,text=kinegon-background] at ([shift={(\kinegonangle:#1)}]#3) {#4};}}%
";

/// Excess of a text's width over the measured one up to which it is not made narrower, in em: about the halo of a
/// label, which is kept free.
const SLACK: f64 = 0.15;

/// Writes a mark; or, with `halo`, the line in the background's colour around the letters of a text.
fn write_mark(file: &mut String, drawing: &Drawing, mark: &Mark, halo: bool) {
    let (name, look) = (name(drawing, mark), drawing.look(mark));
    match &mark.shape {
        Shape::Text(text) => write_text(file, &name, &look, text, halo),
        shape @ (Shape::Arrow { .. } | Shape::ArcArrow { .. }) => {
            if let Some(shaft) = shape.shaft() {
                write_line(file, &name, &look, &shaft);
            }
            if let Some(head) = shape.head() {
                let _ = write!(file, "\n\\fill[kinegon-{name}] ");
                write_path(file, &Shape::Polygon(head.to_vec()));
                file.push(';');
            }
        }
        shape => write_line(file, &name, &look, shape),
    }
    if let (Some(id), false) = (&mark.id, halo) {
        let _ = write!(file, " % {}", tex_comment(id));
    }
    file.push('\n');
}

fn write_line(file: &mut String, name: &str, look: &Look, shape: &Shape) {
    // An open line is never filled, even with a pen that fills areas.
    let open = matches!(shape, Shape::Line(..) | Shape::Polyline(_) | Shape::Arc { .. });
    let clear = if open && look.fill.is_some() { ",fill=none" } else { "" };
    let _ = write!(file, "\\path[kinegon/{name}{clear}] ");
    write_path(file, shape);
    file.push(';');
}

fn write_text(file: &mut String, name: &str, look: &Look, text: &PlacedText, halo: bool) {
    let Some(words) = words::latex(text.text.runs()) else {
        return write_outlines(file, name, look, text, halo);
    };
    let place = text.text.width(1.0).max(text.text.ink_box(1.0).width()) + SLACK;
    let words = format!("\\kinegontext{{{}}}{{{words}}}", number(place));
    let (anchor, share) = match text.anchor {
        Anchor::Start => ("left", 0.0),
        Anchor::Middle => ("middle", 0.5),
        Anchor::End => ("right", 1.0),
    };
    let [x, y] = [text.origin.x + share * text.text.width(text.size), text.origin.y].map(number);
    let options = format!("kinegon/{name},kinegon/{anchor}={}", number(text.size));
    let _ = if halo {
        let around = number(0.5 * look.halo);
        write!(file, "\\kinegonhalo{{{around}mm}}{{{options}}}{{{x},{y}}}{{{words}}}")
    } else {
        write!(file, "\\node[{options}] at ({x},{y}) {{{words}}};")
    };
}

/// Writes a text that LaTeX cannot set, as outlines.
fn write_outlines(file: &mut String, name: &str, look: &Look, text: &PlacedText, halo: bool) {
    let _ = if halo {
        write!(
            file,
            "\\path[fill=kinegon-background,draw=kinegon-background,line width={}mm,line join=round]",
            number(look.halo)
        )
    } else {
        write!(file, "\\fill[kinegon-{name}]")
    };
    for run in text.runs() {
        run.outline(|glyph, origin| write_outline(file, glyph, origin, run.size));
    }
    file.push(';');
}

/// Whether a pen draws lines and texts in a figure.
#[derive(Clone, Copy, Default)]
struct Used {
    lines: bool,
    texts: bool,
}

/// Writes the definitions of a look's colours and style, which take effect unless the document has its own.
fn write_style(file: &mut String, name: &str, look: &Look, used: Used) {
    let mut style: Vec<String> = Vec::new();
    // The main colour is that of lines; of an area without outline that of its inside.
    let main = if used.lines { look.stroke.or(look.fill).unwrap_or(look.ink) } else { look.ink };
    write_colour(file, name, main);
    if used.texts {
        // The colour of texts has a name of its own where it is not that of lines.
        let is_other = used.lines && look.ink != main;
        let ink = if is_other { format!("{name}-ink") } else { name.to_owned() };
        if is_other {
            write_colour(file, &ink, look.ink);
        }
        style.push(format!("text=kinegon-{ink}"));
    }
    if used.lines {
        if look.stroke.is_some() {
            style.push(format!("draw=kinegon-{name},line width={}mm,line join=round", number(look.width)));
            if look.cap == Cap::Round {
                style.push("line cap=round".into());
            }
            if !look.dash.is_empty() {
                let dashes = look.dash.iter().zip(["on", "off"].into_iter().cycle());
                let dashes: Vec<String> =
                    dashes.map(|(length, state)| format!("{state} {}mm", number(*length))).collect();
                style.push(format!("dash pattern={}", dashes.join(" ")));
            }
        }
        match (look.stroke, look.fill) {
            (Some(_), Some(fill)) => {
                write_colour(file, &format!("{name}-inside"), fill);
                style.push(format!("fill=kinegon-{name}-inside"));
            }
            (None, Some(_)) => style.push(format!("fill=kinegon-{name}")),
            (_, None) => {}
        }
    }
    let _ = writeln!(file, "\\kinegonstyle{{{name}}}{{{}}}%", style.join(","));
}

fn write_colour(file: &mut String, name: &str, Colour { red, green, blue }: Colour) {
    let _ = writeln!(file, "\\providecolor{{kinegon-{name}}}{{HTML}}{{{red:02X}{green:02X}{blue:02X}}}%");
}

/// The name of a mark's look in styles and colours: its pen, a number where the drawing's style gives links or curves
/// looks of their own, and its emphasis.
fn name(drawing: &Drawing, mark: &Mark) -> String {
    let mut name = mark.pen.name().replace('_', "-");
    let look = |number| drawing.style.look(mark.pen, number);
    if let Some(number) = mark.number.filter(|&n| look(Some(n)) != look(None)) {
        let _ = write!(name, "-{}", number + 1);
    }
    name.push_str(match mark.emphasis {
        Emphasis::Plain => "",
        Emphasis::New => "-new",
        Emphasis::Earlier => "-earlier",
    });
    name
}

/// Writes a shape as a path; nothing for a text or an arrow.
fn write_path(file: &mut String, shape: &Shape) {
    match *shape {
        Shape::Line(from, to) => write_chain(file, &[from, to]),
        Shape::Polyline(ref points) => write_chain(file, points),
        Shape::Polygon(ref points) => {
            write_chain(file, points);
            file.push_str("--cycle");
        }
        Shape::Area(ref chains) => {
            for points in chains {
                write_chain(file, points);
                file.push_str("--cycle");
            }
        }
        Shape::Circle { center, radius } => {
            write_point(file, center);
            file.push_str("circle[radius=");
            push_number(file, radius.abs());
            file.push(']');
        }
        Shape::Arc { center, radius, start, sweep } => {
            let sweep = sweep.clamp(-std::f64::consts::TAU, std::f64::consts::TAU);
            let (sin, cos) = (libm::sin(start), libm::cos(start));
            write_point(file, center + Vec2::new(cos, sin) * radius);
            for (name, value) in [
                ("arc[start angle=", start.to_degrees()),
                (",end angle=", (start + sweep).to_degrees()),
                (",radius=", radius),
            ] {
                file.push_str(name);
                push_number(file, value);
            }
            file.push(']');
        }
        Shape::Arrow { .. } | Shape::ArcArrow { .. } | Shape::Text(_) => {}
    }
}

fn write_chain(file: &mut String, points: &[Point]) {
    for (index, &point) in points.iter().enumerate() {
        file.push_str(if index == 0 { "" } else { "--" });
        write_point(file, point);
    }
}

fn write_point(file: &mut String, point: Point) {
    file.push('(');
    push_number(file, point.x);
    file.push(',');
    push_number(file, point.y);
    file.push(')');
}

/// Writes the outline of a glyph, one closed curve per line; it is in em, `origin` and `size` are in mm.
fn write_outline(file: &mut String, glyph: &Outline, origin: Point, size: f64) {
    let at = |point: Point| origin + point.to_vec2() * size;
    let mut pen = Point::ORIGIN;
    for element in glyph {
        let [first, second, to] = match element {
            OutlinePart::MoveTo(to) | OutlinePart::LineTo(to) => {
                file.push_str(if matches!(element, OutlinePart::MoveTo(_)) { "\n  " } else { "--" });
                write_point(file, at(to));
                pen = to;
                continue;
            }
            // The control points of the same curve as a cubic one.
            OutlinePart::QuadTo(by, to) => [pen.lerp(by, 2.0 / 3.0), to.lerp(by, 2.0 / 3.0), to],
            OutlinePart::CurveTo(first, second, to) => [first, second, to],
            OutlinePart::ClosePath => {
                file.push_str("--cycle");
                continue;
            }
        };
        file.push_str("..controls");
        write_point(file, at(first));
        file.push_str("and");
        write_point(file, at(second));
        file.push_str("..");
        write_point(file, at(to));
        pen = to;
    }
}
