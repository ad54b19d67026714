use super::number::number;
use super::svg::{FONTS, Text, layers};
use super::template::filled;
use crate::drawing::{Drawing, ITALIC, Pen, REGULAR, Rect};
use crate::text::xml;
use crate::words::Language;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use flate2::{Compression, GzBuilder};
use indexmap::IndexSet;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::io::Write;

/// The template of the page, with `{{name}}` for its contents.
const PAGE: &str = include_str!("../../templates/page.html");

/// The contents of a page for the classroom.
#[derive(Clone, Copy, Debug)]
pub struct WebPage<'a> {
    /// The stepwise figure in each position, all on the same panels, as [`frames`](crate::drawing::frames) gives them;
    /// at least one.
    pub frames: &'a [Drawing],
    /// The drive's value in each position, in words.
    pub values: &'a [String],
    /// Index of the position that is shown first: the scene's own.
    pub own: usize,
    /// Whether the first position follows the last.
    pub is_round: bool,
    /// The name of the drive's value, as in `angle(1)`.
    pub quantity: &'a str,
    /// The figure's language.
    pub language: &'a Language,
    /// Letters with the fonts that the page brings along, or outlines.
    pub text: Text,
}

/// One self-contained HTML file: the figure with its steps, in all positions, to be shown, stepped through, moved and
/// printed.
///
/// Every position is drawn here, as for SVG; the page's script only chooses lines of SVG. Lines that are the same in
/// several positions are stored once, and all are compressed. Without frames the file is empty.
#[must_use]
pub fn html(page: &WebPage<'_>) -> String {
    let Some(first) = page.frames.get(page.own) else {
        return String::new();
    };
    let finished = first.after_step(first.steps.len() + 1);
    let sheet: String = layers(&finished, page.text).into_iter().map(|layer| layer.svg).collect();
    let title = if first.title.is_blank() { "Kinegon".into() } else { first.title.for_xml() };
    let words = page.language;
    let said = [
        ("figure", words.page_figure()),
        ("panels", words.page_panels()),
        ("steps", words.page_steps()),
        ("first", words.page_first()),
        ("back", words.page_back()),
        ("forward", words.page_forward()),
        ("finished", words.page_finished()),
        ("motion", words.page_motion()),
        ("play", words.page_play()),
        ("own", words.page_own()),
        ("speed", words.page_speed()),
        ("look", words.page_look()),
        ("dark", words.page_dark()),
        ("print", words.page_print()),
        ("to_scale", words.page_to_scale()),
        ("no_script", words.page_no_script()),
        ("too_old", words.page_too_old()),
        ("language", words.code),
    ];
    let hint = first.style.look(Pen::Hint, None).stroke;
    let contents = [
        ("title", title),
        ("width", number(first.width)),
        ("height", number(first.height)),
        ("fonts", FONTS.to_owned()),
        ("background", first.style.background().to_string()),
        ("accent", first.style.accent().to_string()),
        ("class", (if first.style.is_dark() { "dark board" } else { "" }).to_owned()),
        ("quantity", xml(page.quantity)),
        ("sheet", sheet),
        ("data", packed(script_data(page, first).to_string().as_bytes())),
        ("font_data", if page.text == Text::Letters { packed(&font_data()) } else { String::new() }),
        ("hint", hint.map(|colour| colour.to_string()).unwrap_or_default()),
    ];
    let said = said.map(|(name, text)| (name, xml(text)));
    let contents: Vec<(&str, String)> = contents.into_iter().chain(said).collect();
    filled(PAGE, &contents)
}

/// A layer's place in the pile: whether above, step, whether passing, until when.
type LayerKey = (bool, u16, bool, Option<u16>);

/// The data for the page's script.
fn script_data(page: &WebPage<'_>, first: &Drawing) -> Value {
    let said = page.language;
    let mut lines: IndexSet<String> = IndexSet::new();
    // The layers of all frames, from the lowest to the highest: whether above, step, whether passing, until when.
    let mut pile: BTreeMap<LayerKey, Vec<Vec<usize>>> = BTreeMap::new();
    for (frame, drawing) in page.frames.iter().enumerate() {
        for layer in layers(drawing, page.text) {
            let here = (!layer.below, layer.step, layer.passing, layer.until);
            let layers = pile.entry(here).or_insert_with(|| vec![Vec::new(); page.frames.len()]);
            let written = layer.svg.lines().filter(|line| !line.is_empty());
            layers[frame] = written.map(|line| lines.insert_full(line.to_owned()).0).collect();
        }
    }
    pile.retain(|_, layers| layers.iter().any(|lines| !lines.is_empty()));
    let layers =
        pile.keys().map(|(_, step, passing, until)| json!({ "step": step, "passing": passing, "until": until }));
    let frames =
        (0..page.frames.len()).map(|frame| pile.values().map(|frames| frames[frame].clone()).collect::<Vec<_>>());
    let boxed = |r: Rect| [r.x0, r.y0, r.width(), r.height()];
    let panel = |(name, frame): &(String, Rect)| json!({ "name": name, "box": boxed(frame.inflate(1.0, 1.0)) });
    let panels = first.panels.iter().map(panel);
    let below = first.panels.iter().map(|p| p.1.y1).fold(0.0, f64::max);
    let words = Rect::new(0.0, below, first.width, first.height);
    json!({
        "title": first.title,
        "said": { "all": said.page_all(), "count": said.page_count(), "play": said.page_play(), "pause": said.page_pause() },
        "width": first.width,
        "height": first.height,
        "panels": panels.collect::<Vec<_>>(),
        "words": boxed(words),
        "steps": first.steps,
        "values": page.values,
        "own": page.own,
        "round": page.is_round,
        "layers": layers.collect::<Vec<_>>(),
        "frames": frames.collect::<Vec<_>>(),
        "lines": lines,
    })
}

/// The fonts of the letters, one after the other: the upright one, with its length in four bytes before it, lowest
/// first, and the italic one. Without them letters would stand where those of other fonts should.
fn font_data() -> Vec<u8> {
    let length = REGULAR.len() as u32;
    [&length.to_le_bytes()[..], REGULAR, ITALIC].concat()
}

/// Bytes compressed, in Base64; the same on every platform.
fn packed(bytes: &[u8]) -> String {
    let mut encoder = GzBuilder::new().write(Vec::new(), Compression::best());
    let written = encoder.write_all(bytes);
    let packed = written.and_then(|()| encoder.finish());
    BASE64_STANDARD.encode(packed.expect("memory can be written to"))
}
