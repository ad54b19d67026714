use super::number::number;
use crate::drawing::{Anchor, Colour, Drawing, Look, Mark, PlacedText, Shape};
use std::collections::BTreeMap;
use std::fmt::Write;

mod paths;
mod style;
mod words;

use paths::write_path;
use style::{Used, name, write_colour, write_style};

impl Drawing {
    /// The drawing as the text of a LaTeX file: a TikZ picture, true to scale in mm.
    ///
    /// The file compiles by itself and can be read with `\input` into a document that loads the package `tikz`; then only the picture is taken.
    /// Colours and styles have names, one for each pen, and keep to what the document has set before. Texts are LaTeX text and formulas in the
    /// document's own fonts; each keeps its left end, middle or right end, because those fonts are not the measured one. A text with a letter that plain LaTeX lacks is drawn by the outlines of the bundled font. Marks whose numbers are not finite,
    /// or beyond what TeX counts to, are left out.
    pub fn tikz(&self) -> String {
        let marks = self.marks.iter().zip(self.halos());
        let marks: Vec<(&Mark, bool)> = marks.filter(|(mark, _)| fits(&mark.shape)).collect();
        let mut file = head(self);
        let mut used: BTreeMap<String, (Look, Used)> = BTreeMap::new();
        for (mark, _) in &marks {
            let used = used.entry(name(self, mark));
            let (_, used) = used.or_insert_with(|| (self.look(mark), Used::default()));
            used.count(&mark.shape);
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
        // Stretches of one pen, as in SVG: all halos come before all letters, so that none covers a neighbour.
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

/// Whether TeX can count as far as a shape reaches: to 5.7 m.
fn fits(shape: &Shape) -> bool {
    let bounds = shape.bounds();
    let sides = [bounds.x0, bounds.y0, bounds.x1, bounds.y1];
    shape.is_finite() && sides.iter().all(|side| side.abs() < 5000.0)
}

/// What stands before the styles: comments, the document around a picture that is compiled by itself, and what all figures share.
fn head(drawing: &Drawing) -> String {
    let mut head = String::new();
    for text in [&drawing.title, &drawing.description] {
        if !text.is_empty() {
            let _ = writeln!(head, "% {}", comment(text));
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

/// The document of a picture that is compiled by itself; nothing inside another document.
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

/// How pens get their styles unless they have them; how texts are set.
///
/// Texts are set at 10 pt, which every font has, and scaled. In Computer Modern prose comes out 11 % wider than the drawing measured it in the
/// bundled font, labels 19 % (over all texts of the starting scenes): so letters are somewhat smaller, and a text that is still wider than
/// its place is made narrower. None covers what the drawing has kept free.
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

/// By how much a text may be wider than measured before it is made narrower, in em: about the halo of a label, which is kept free.
const SLACK: f64 = 0.15;

/// Text in one line of a comment.
fn comment(text: &str) -> String {
    let plain = |letter: char| if letter.is_control() { ' ' } else { letter };
    text.chars().map(plain).collect()
}

/// One mark, or the line in the background's colour around the letters of one.
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
        let _ = write!(file, " % {}", comment(id));
    }
    file.push('\n');
}

fn write_line(file: &mut String, name: &str, look: &Look, shape: &Shape) {
    // An open line stays clear inside whatever its pen does to areas.
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

/// A text that LaTeX cannot set.
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
        run.outline(|glyph, origin| paths::write_outline(file, glyph, origin, run.size));
    }
    file.push(';');
}
