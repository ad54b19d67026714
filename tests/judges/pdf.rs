//! Figures as PDF: true size, letters that are found, fonts that come with the file, the same bytes every time.

use kinegon::drawing::{Drawing, Pen, PlacedText, Point, RichText, Shape};
use kinegon::format::PdfError;
use lopdf::{Dictionary, Document, Object};
use std::sync::OnceLock;
use support::stages::solved;
use support::{files, tools};

/// Every starting scene and example by its name, drawn.
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
    drawn.collect()
}

fn written(drawing: &Drawing) -> (Vec<u8>, Document) {
    let bytes = drawing.pdf().expect("the sheet has a size");
    let read = Document::load_mem(&bytes).expect("it is PDF");
    (bytes, read)
}

/// What the texts of a drawing say, in drawing order, without white space.
fn texts(drawing: &Drawing) -> Vec<String> {
    let texts = drawing.marks.iter().filter_map(|mark| match &mark.shape {
        Shape::Text(text) => Some(stripped(&text.text.content())),
        _ => None,
    });
    texts.collect()
}

fn stripped(text: &str) -> String {
    text.chars().filter(|letter| !letter.is_whitespace()).collect()
}

/// A sheet with one text on it.
fn sheet(text: RichText) -> Drawing {
    let mut drawing = Drawing::new(100.0, 50.0);
    let text = PlacedText::new(text, 4.0, Point::new(10.0, 20.0));
    drawing.draw(Pen::Label, Shape::Text(text));
    drawing
}

/// The page's dictionary.
fn page(document: &Document) -> &Dictionary {
    let pages = document.get_pages();
    assert_eq!(pages.len(), 1);
    document.get_dictionary(pages[&1]).expect("the page is there")
}

#[test]
fn a_page_is_as_large_as_its_sheet() {
    for (name, drawing) in drawings() {
        let (_, document) = written(drawing);
        let sides = page(&document).get(b"MediaBox").and_then(Object::as_array).expect("a page has a size");
        let sides: Vec<f64> = sides.iter().map(|side| f64::from(side.as_float().expect("a number"))).collect();
        let expected = [0.0, 0.0, drawing.width * 72.0 / 25.4, drawing.height * 72.0 / 25.4];
        for (side, expected) in sides.iter().zip(expected) {
            // 0.1 micrometres.
            assert!((side - expected).abs() < 3e-4, "{name}: {sides:?}");
        }
    }
}

/// The content of the page says every text once, in drawing order: halos are no letters, and no letter is left out.
#[test]
fn every_text_stands_there_once() {
    for (name, drawing) in drawings() {
        let (_, document) = written(drawing);
        let found = stripped(&document.extract_text(&[1]).expect("its fonts say what their glyphs mean"));
        assert_eq!(found, texts(drawing).concat(), "{name}");
    }
}

#[test]
#[ignore = "needs Poppler"]
fn names_are_found_by_another_program() {
    let pdftotext = tools::find("pdftotext");
    for (name, drawing) in drawings() {
        let file = tools::leave(&format!("found-{name}.pdf"), &written(drawing).0);
        let output = tools::run(&pdftotext, [file.as_os_str(), "-".as_ref()]);
        let text = String::from_utf8(output).expect("it writes UTF-8");
        let words: Vec<&str> = text.split_whitespace().collect();
        let all = words.concat();
        for text in texts(drawing) {
            assert!(all.contains(&text), "{name}: {text} is not in {words:?}");
        }
        // A name with a subscript is one word, not two.
        for mark in &drawing.marks {
            if let (Pen::Label, Shape::Text(text)) = (mark.pen, &mark.shape) {
                let runs = text.text.runs();
                if runs.len() == 2 && !runs[1].scripts.is_empty() {
                    let name = text.text.content();
                    assert!(words.contains(&name.as_str()), "{name} is no word of {words:?}");
                }
            }
        }
    }
}

/// Letters of all kinds, as they are written and as they are read.
const LETTERS: [(&str, &str); 6] = [
    ("ω_2", "ω2"),
    ("α^{n}_{CB}", "αCBn"),
    ("π, a, b'", "π, a, b′"),
    ("d''_{S_{3b}}", "d″S3b"),
    ("v_{CB} ⊥ BC", "vCB ⊥ BC"),
    ("first 漢字 ▒", "first 漢字 ▒"),
];

#[test]
#[ignore = "needs Poppler"]
fn letters_of_all_kinds_are_found_by_another_program() {
    let pdftotext = tools::find("pdftotext");
    for (source, reads) in LETTERS {
        let file = tools::leave("letters.pdf", &written(&sheet(RichText::math(source))).0);
        let output = tools::run(&pdftotext, [file.as_os_str(), "-".as_ref()]);
        assert_eq!(String::from_utf8_lossy(&output).trim(), reads, "{source}");
    }
}

#[test]
fn letters_of_all_kinds_are_found() {
    for (source, reads) in LETTERS {
        let (_, document) = written(&sheet(RichText::math(source)));
        let text = document.extract_text(&[1]).expect("its fonts say what their glyphs mean");
        // A letter that the font lacks has no glyph of its own; the file says beside it what it is.
        if !source.contains('漢') {
            assert_eq!(stripped(&text), stripped(reads), "{source}");
        }
    }
}

#[test]
fn the_same_drawing_gives_the_same_bytes() {
    for (name, drawing) in drawings() {
        let (first, second) = (written(drawing).0, written(&drawing.clone()).0);
        assert!(first == second, "{name}");
        let has = |word: &[u8]| first.windows(word.len()).any(|part| part == word);
        assert!(!has(b"CreationDate") && !has(b"ModDate") && !has(b"CreateDate"), "{name}");
    }
}

#[test]
fn fonts_come_with_the_file_and_only_the_letters_that_it_uses() {
    for (name, drawing) in drawings() {
        let (bytes, document) = written(drawing);
        let mut fonts = 0;
        for object in document.objects.values() {
            let Ok(font) = object.as_dict() else { continue };
            if font.has_type(b"FontDescriptor") {
                let program = font.get(b"FontFile3").and_then(Object::as_reference);
                let program = document.get_object(program.expect("it is in the file")).and_then(Object::as_stream);
                assert!(program.expect("it is a stream").content.len() < 12_000, "{name}");
                fonts += 1;
            }
        }
        // Upright and slanted.
        assert_eq!(fonts, 2, "{name}");
        assert!(bytes.len() < 60_000, "{name}: {} bytes", bytes.len());
    }
}

#[test]
fn title_language_and_description_are_written_in() {
    let mut drawing = sheet(RichText::plain("x"));
    drawing.title = "Großer Träger: α & (b) \\ %".into();
    drawing.description = "Panels: none.".into();
    let (_, document) = written(&drawing);
    let about = document.trailer.get(b"Info").and_then(Object::as_reference).expect("it is there");
    let about = document.get_dictionary(about).expect("it is a dictionary");
    let said = |key: &[u8]| lopdf::decode_text_string(about.get(key).expect("it is said")).expect("a text");
    assert_eq!(said(b"Title"), drawing.title.for_pdf());
    assert_eq!(said(b"Subject"), drawing.description);
    let catalog = document.catalog().expect("it has one");
    assert_eq!(lopdf::decode_text_string(catalog.get(b"Lang").expect("it is said")).expect("a text"), "en");
    // For readers who cannot see it, the description stands for the whole figure.
    let figure = document.objects.values().filter_map(|object| object.as_dict().ok());
    let mut figure =
        figure.filter(|element| element.get(b"S").and_then(Object::as_name).is_ok_and(|name| name == b"Figure"));
    let stands = figure.next().and_then(|figure| figure.get(b"Alt").ok()).expect("it is there");
    assert_eq!(lopdf::decode_text_string(stands).expect("a text"), drawing.description);
}

#[test]
fn what_cannot_be_a_page_is_refused() {
    for (width, height) in [(f64::NAN, 10.0), (0.0, 10.0), (10.0, -1.0), (10.0, f64::INFINITY), (6000.0, 10.0)] {
        let error = Drawing::new(width, height).pdf().expect_err("it has no size");
        assert!(matches!(error, PdfError::Size { .. }), "{error}");
    }
    assert!(
        PdfError::Size { width: 0.0, height: 10.0 }
            .to_string()
            .starts_with("a sheet of 0 x 10 mm: a page of PDF has sides")
    );
}

#[test]
fn numbers_that_are_not_finite_are_left_out() {
    let mut drawing = sheet(RichText::plain("stays"));
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let (center, radius) = (Point::new(wrong, 1.0), wrong);
        drawing.draw(Pen::Joint, Shape::Circle { center, radius });
        drawing.draw(Pen::Link, Shape::Polyline(vec![center, Point::ORIGIN]));
        let text = PlacedText::new(RichText::math("S_3"), wrong, Point::ORIGIN);
        drawing.draw(Pen::Label, Shape::Text(text));
    }
    drawing.draw(Pen::Link, Shape::Polygon(Vec::new()));
    let (_, document) = written(&drawing);
    assert_eq!(document.extract_text(&[1]).expect("text").trim(), "stays");
    let content = document.get_page_content(document.get_pages()[&1]);
    let content = String::from_utf8_lossy(&content);
    assert!(!content.contains("NaN") && !content.contains("inf"), "{content}");
}
