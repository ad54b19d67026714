//! Figures as TikZ: every one compiles alone and inside a document, texts are formulas, nothing of a title reaches LaTeX as a command.

use kinegon::Solution;
use kinegon::cycle::{Curves, Drive, Path};
use kinegon::drawing::{self, Drawing, Pen, PlacedText, Point, RichText, Shape};
use std::path::PathBuf;
use std::sync::OnceLock;
use support::stages::solved;
use support::survey::TYPESET;
use support::{files, tools};

/// Every starting scene and example by its name, drawn; and curves.
fn drawings() -> &'static [(String, Drawing)] {
    static DRAWINGS: OnceLock<Vec<(String, Drawing)>> = OnceLock::new();
    DRAWINGS.get_or_init(drawn)
}

fn drawn() -> Vec<(String, Drawing)> {
    let scenes = files::templates().into_iter().chain(files::scenes("examples"));
    let drawn = scenes.map(|(name, text)| {
        let solution = solved(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
        (name, solution.figure())
    });
    drawn.chain([("curves".to_owned(), curves())]).collect()
}

fn curves() -> Drawing {
    let Solution { scene, mechanism, pose, .. } = solved(&files::read("examples/figure-2.json")).expect("a good scene");
    let drive = Drive::new(&mechanism, None).expect("it has a drive");
    let mut path = Path::new(&mechanism, &pose, drive).expect("it is not singular");
    let range = path.cover(None, None).expect("it moves");
    let curves = Curves::new(&path, range, None).expect("it has quantities");
    drawing::curves(&scene, &curves, None).expect("it fits")
}

/// What LaTeX is given for a text.
fn latex(text: RichText) -> String {
    let mut drawing = Drawing::new(100.0, 50.0);
    let text = PlacedText::new(text, 4.0, Point::new(10.0, 20.0));
    drawing.draw(Pen::Caption, Shape::Text(text));
    let file = drawing.tikz();
    let node = file
        .lines()
        .find_map(|line| line.split_once("\\kinegontext{").filter(|(before, _)| before.starts_with("\\node")));
    let Some((_, node)) = node else {
        assert!(file.contains("\\fill[kinegon-caption]\n"), "{file}");
        return "outlines".to_owned();
    };
    let (_, words) = node.split_once("}{").expect("its place stands before it");
    words.strip_suffix("}};").expect("the node ends").to_owned()
}

#[test]
fn labels_are_formulas() {
    for (source, expected) in [
        ("ω_2", "$\\omega_{2}$"),
        ("b'", "$b'$"),
        ("s_3", "$s_{3}$"),
        ("a^{n}_{DG}", "$a_{DG}^{n}$"),
        ("p, a, g", "$p$, $a$, $g$"),
        ("d''_2", "$d''_{2}$"),
        ("b_2'", "$b_{2}'$"),
        // A letter has one superscript.
        ("b'^n", "$b'{}^{n}$"),
        ("b^n'", "$b^{n}{}'$"),
        ("v_{S_{3b}}^t", "$v_{S_{3b}}^{t}$"),
        ("a_{b^{c_d}}_e", "$a_{b^{c_{d}}e}$"),
        ("v_{CB} ⊥ BC", "$v_{CB}$ $\\perp$ $BC$"),
        ("ω_2×v_r", "$\\omega_{2}{\\times}v_{r}$"),
        ("αβ", "$\\alpha\\beta$"),
        ("αb", "$\\alpha b$"),
        ("Crank_1", "$\\mathit{Crank}_{1}$"),
        ("−3", "$-$3"),
        ("_3", "$_{3}$"),
        ("v_r(3/2)", "$v_{r}$(3/2)"),
        ("n_{a-b}", "$n_{a-b}$"),
        ("é", "\\textit{é}"),
    ] {
        assert_eq!(latex(RichText::math(source)), expected, "{source}");
    }
}

#[test]
fn prose_is_text() {
    for (source, expected) in [
        ("(b) Velocity plan", "(b) Velocity plan"),
        ("= 2 (mm/s²)/mm, 8·10^{−14}", "= 2 (mm/s$^{2}$)/mm, 8$\\cdot$10$^{-14}$"),
        ("mm × μ, 5°", "mm $\\times$ $\\mu$, 5$^{\\circ}$"),
        ("Angle φ_1 of", "Angle $\\varphi_{1}$ of"),
        ("v_{max}", "v$_{\\mathrm{max}}$"),
        ("Mécanisme à çà Größe Łódź", "Mécanisme à çà Größe Łódź"),
    ] {
        assert_eq!(latex(RichText::plain(source)), expected, "{source}");
    }
}

/// Letters with a meaning for LaTeX, and letters that it lacks.
const HOSTILE: [(&str, &str); 6] = [
    ("100 % & #1 _ $x$ ~ ^", "100 \\% \\& \\#1 \\_ \\$x\\$ \\textasciitilde{} \\textasciicircum{}"),
    ("\\input{/etc/passwd}", "\\textbackslash{}input\\{/etc/passwd\\}"),
    ("\"a\" <b> |c| `d` e--f ''", "''a'' $<$b$>$ $|$c$|$ \\`{}d\\`{} e-{}-f '{}'"),
    ("]]; \\end{document}", "]]; \\textbackslash{}end\\{document\\}"),
    ("Скорость 漢", "outlines"),
    ("Đą", "outlines"),
];

#[test]
fn titles_are_no_commands() {
    for (source, expected) in HOSTILE {
        assert_eq!(latex(RichText::verbatim(source)), expected, "{source}");
    }
    let mut drawing = Drawing::new(10.0, 10.0);
    drawing.title = "first\n\\input{x}\r\u{85}".into();
    drawing.draw_named("a\nb", Pen::Link, Shape::Line(Point::ORIGIN, Point::new(1.0, 1.0)));
    let file = drawing.tikz();
    assert!(file.starts_with("% first \\input{x}  \n"), "{file}");
    assert!(file.contains("; % a b\n"), "{file}");
}

#[test]
fn marks_keep_their_places_and_styles() {
    for (name, drawing) in drawings() {
        let file = drawing.tikz();
        // Every style and colour that is used has been given before.
        let (styles, picture) = file.split_once("\\begin{tikzpicture}").expect("there is a picture");
        for line in picture.lines().filter(|line| line.contains("[kinegon")) {
            let (_, rest) = line.split_once("[kinegon").expect("it is there");
            let used = &rest[1..rest.find([',', ']']).expect("options end")];
            let given = if rest.starts_with('/') {
                format!("\\kinegonstyle{{{used}}}{{")
            } else {
                format!("\\providecolor{{kinegon-{used}}}{{")
            };
            assert!(styles.contains(&given), "{name}: {line}");
        }
        for mark in &drawing.marks {
            let number = |mm: f64| {
                let text = format!("{mm:.3}");
                text.trim_end_matches('0').trim_end_matches('.').to_owned()
            };
            match &mark.shape {
                Shape::Line(a, b) => {
                    // What lies between two numbers of three digits may be written as either.
                    let has = |off: f64| {
                        let [x, y, u, v] = [a.x, a.y, b.x, b.y].map(|mm| number(mm + off));
                        picture.contains(&format!("({x},{y})--({u},{v});").replace("-0,", "0,"))
                    };
                    assert!([0.0, 1e-9, -1e-9].into_iter().any(has), "{name}: {mark:?}");
                }
                Shape::Text(_) if mark.id.is_some() => {
                    let id = format!(" % {}\n", mark.id.as_deref().unwrap_or_default());
                    assert_eq!(picture.matches(&id).count(), 1, "{name}: {mark:?}");
                }
                _ => {}
            }
        }
    }
}

#[test]
fn numbers_that_tex_cannot_take_are_left_out() {
    let mut drawing = Drawing::new(297.0, 210.0);
    for wrong in [f64::NAN, f64::INFINITY, 1e300, -6000.0] {
        let (center, radius) = (Point::new(wrong, 1.0), wrong);
        drawing.draw(Pen::Joint, Shape::Circle { center, radius });
        drawing.draw(Pen::Link, Shape::Polyline(vec![center, Point::ORIGIN]));
        let text = PlacedText::new(RichText::math("S_3"), 4.0, center);
        drawing.draw(Pen::Label, Shape::Text(text));
    }
    let (_, picture) =
        drawing.tikz().split_once("(297,210);\n").map(|(a, b)| (a.to_owned(), b.to_owned())).expect("its size");
    assert_eq!(picture, "\\end{tikzpicture}%\n\\kinegonend\n");
}

/// Compiles files in a folder of their own and returns what LaTeX says of the last.
fn compile(folder: &str, files: &[(&str, &str)]) -> (PathBuf, String) {
    let program = tools::find("pdflatex");
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(folder);
    std::fs::create_dir_all(&folder).expect("the test's folder can be written");
    for (name, text) in files {
        std::fs::write(folder.join(name), text).expect("the test's folder can be written");
    }
    let (last, _) = files.last().expect("there is one");
    let said = tools::run_in(&folder, &program, ["-interaction=nonstopmode", "-halt-on-error", last]);
    (folder.join(last).with_extension("pdf"), String::from_utf8_lossy(&said).into_owned())
}

/// Nothing sticks out, and LaTeX has every letter.
fn assert_clean(name: &str, said: &str) {
    for trouble in ["Warning", "Overfull", "Underfull", "Missing character", "undefined"] {
        assert!(!said.contains(trouble), "{name}: {said}");
    }
    assert!(said.contains("(1 page"), "{name}: {said}");
}

#[test]
#[ignore = "needs LaTeX"]
fn every_figure_compiles_alone() {
    for (name, drawing) in drawings().iter().step_by(TYPESET.now()) {
        let (file, said) = compile("tikz-alone", &[(&format!("{name}.tex"), &drawing.tikz())]);
        assert_clean(name, &said);
        let document = lopdf::Document::load(&file).expect("it is PDF");
        let page = document.get_dictionary(document.get_pages()[&1]).expect("the page is there");
        let sides = page.get(b"MediaBox").and_then(lopdf::Object::as_array).expect("a page has a size");
        for (side, mm) in sides[2..].iter().zip([drawing.width, drawing.height]) {
            let side = f64::from(side.as_float().expect("a number"));
            assert!((side * 25.4 / 72.0 - mm).abs() < 1e-3, "{name}: {sides:?}");
        }
    }
}

#[test]
#[ignore = "needs LaTeX"]
fn every_letter_that_is_no_outline_compiles() {
    let latin = ('!'..='~').chain('¡'..='ɏ');
    let others = "′″−×·±÷°²³¹⊥∥∠≈≠≤≥→←↔√∞∈¬“”‘’–—…".chars().chain('Ͱ'..='Ͽ');
    let set = latin.chain(others).filter(|letter| latex(RichText::verbatim(letter.to_string())) != "outlines");
    let letters: Vec<char> = set.collect();
    assert!(letters.len() > 300, "{}", letters.len());
    let mut drawing = Drawing::new(297.0, 420.0);
    let texts = HOSTILE.iter().map(|(source, _)| (*source).to_owned());
    let rows = letters.chunks(12).map(|letters| letters.iter().collect());
    let texts: Vec<String> = texts.chain(rows).collect();
    for (row, source) in texts.iter().enumerate() {
        for (column, text) in
            [RichText::verbatim(source), RichText::math(source), RichText::plain(&format!("a_{{{source}}}"))]
                .into_iter()
                .enumerate()
        {
            let at = Point::new(10.0 + 95.0 * column as f64, 10.0 + 7.0 * row as f64);
            drawing.draw(Pen::Caption, Shape::Text(PlacedText::new(text, 4.0, at)));
        }
    }
    drawing.title = "100 % \\end{document} {".into();
    let (_, said) = compile("tikz-hostile", &[("hostile.tex", &drawing.tikz())]);
    assert_clean("hostile", &said);
}

/// A document takes the picture alone, with the looks that it has set before.
#[test]
#[ignore = "needs LaTeX"]
fn a_document_takes_the_picture_in() {
    let (_, drawing) = drawings().iter().find(|(name, _)| name == "figure-2").expect("it is there");
    let document = r"\documentclass[a4paper,landscape]{article}
\usepackage{tikz}
\definecolor{kinegon-velocity}{HTML}{00FF00}
\tikzset{kinegon/link/.style={draw=cyan,line width=1mm}}
\begin{document}
before\begin{figure}[h]\centering\resizebox{10cm}{!}{\input{picture}}\caption{A picture.}\end{figure}after
\setbox0\hbox{\input{picture}}\typeout{It is \the\wd0; \the\ht0; large.}
\end{document}
";
    let (file, said) = compile("tikz-input", &[("picture.tex", &drawing.tikz()), ("document.tex", document)]);
    assert_clean("document", &said);
    // 297 mm and 210 mm in TeX's points; nothing but the picture, not even a space.
    let size = said.split_once("It is ").and_then(|(_, rest)| rest.split_once("; large.")).expect("it is said").0;
    let size: Vec<f64> = size.split("; ").map(|part| part.trim_end_matches("pt").parse().expect("a number")).collect();
    for (size, mm) in size.iter().zip([297.0, 210.0]) {
        assert!((size * 25.4 / 72.27 - mm).abs() < 0.01, "{size}");
    }
    let pdf = lopdf::Document::load(&file).expect("it is PDF");
    let content = String::from_utf8_lossy(&pdf.get_page_content(pdf.get_pages()[&1])).into_owned();
    assert!(content.contains("0 1 0 rg") || content.contains("0 1 0 RG"), "the document's green is not there");
    assert!(!content.contains("0.04314 0.3098 0.54118"), "the drawing's blue is there");
    let text = pdf.extract_text(&[1]).expect("text");
    assert!(text.contains("before") && text.contains("after"), "{text}");
}
