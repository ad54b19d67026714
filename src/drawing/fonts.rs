use std::ops::Range;
use std::str::Chars;
use std::sync::{LazyLock, OnceLock};

use kurbo::{BezPath, PathEl, Point, Rect, Shape};
use skrifa::charmap::Charmap;
use skrifa::metrics::GlyphMetrics;
use skrifa::outline::DrawSettings;
use skrifa::outline::pen::PathElement;
use skrifa::prelude::{LocationRef, Size};
use skrifa::raw::tables::gpos::{PairPos, PositionSubtables};
use skrifa::raw::tables::gsub::SubstitutionSubtables;
use skrifa::raw::tables::layout::FeatureList;
use skrifa::raw::{ReadError, TableProvider};
use skrifa::{FontRef, GlyphId, MetadataProvider, OutlineGlyphCollection, Tag};

/// The upright face: Libertinus Serif Regular, subset, SIL Open Font License 1.1 (see
/// `fonts/OFL-1.1.txt`).
pub static REGULAR: &[u8] = include_bytes!("fonts/LibertinusSerif-Regular.sub.otf");

/// The slanted face: Libertinus Serif Italic, subset, under the same licence.
pub static ITALIC: &[u8] = include_bytes!("fonts/LibertinusSerif-Italic.sub.otf");

/// Width and ink of a stretch of text, in em, y down, from the left end of its baseline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TextExtent {
    pub(super) advance: f64,
    /// The box around the ink; none for spaces.
    pub(super) ink: Option<Rect>,
}

/// The extent assumed for a letter that the face lacks: about a capital, so that labels keep off what a viewer may draw.
const UNKNOWN: TextExtent = TextExtent { advance: 0.6, ink: Some(Rect::new(0.0, -0.75, 0.6, 0.15)) };

/// Letters before this code point (Latin, basic signs) have their glyphs looked up when a face is parsed.
const COMMON: u32 = 0x80;

/// A face of the bundled fonts, parsed for measuring.
pub(super) struct Face {
    letters: Charmap<'static>,
    metrics: GlyphMetrics<'static>,
    shapes: OutlineGlyphCollection<'static>,
    em: f64,
    /// By glyph: its outline and extent, once read; reading takes far longer than looking them up.
    glyphs: Vec<OnceLock<Glyph>>,
    /// By letter below [`COMMON`]: its glyph, none where the face lacks it.
    indices: Vec<Option<GlyphId>>,
    /// Kerning by script. Values of all tables are added, because in these fonts each lookup has one table.
    kerning: [Vec<Kerning>; 3],
    ligatures: Vec<Ligature>,
}

/// A glyph as it is drawn, in em, y down.
#[derive(Clone)]
struct Glyph {
    outline: BezPath,
    extent: TextExtent,
}

/// Kerning of pairs, by classes of glyphs (OpenType GPOS, pair adjustment format 2).
struct Kerning {
    /// By glyph: its class as the left one of a pair, none without a rule.
    left: Vec<Option<u16>>,
    /// By glyph: its class as the right one of a pair.
    right: Vec<u16>,
    /// By class of the left and of the right glyph: displacement of the right one, in em.
    moves: Vec<Vec<f64>>,
}

/// A ligature: the glyph that replaces several ones.
struct Ligature {
    first: GlyphId,
    following: Vec<GlyphId>,
    glyph: GlyphId,
}

/// The scripts with kerning rules of their own.
#[derive(Clone, Copy, PartialEq)]
enum Alphabet {
    Latin,
    Greek,
    Cyrillic,
}

/// The slanted or the upright face, parsed on first use.
pub(super) fn face(italic: bool) -> &'static Face {
    static FACES: [LazyLock<Face>; 2] = [LazyLock::new(|| Face::parse(REGULAR)), LazyLock::new(|| Face::parse(ITALIC))];
    &FACES[usize::from(italic)]
}

impl Face {
    fn parse(data: &'static [u8]) -> Self {
        let sound = "the bundled fonts are sound";
        let font = FontRef::new(data).expect(sound);
        let metrics = font.glyph_metrics(Size::unscaled(), LocationRef::default());
        let letters = font.charmap();
        let glyphs = metrics.glyph_count() as usize;
        Self {
            indices: (0..COMMON).map(|code| letters.map(code)).collect(),
            em: f64::from(font.head().expect(sound).units_per_em()),
            glyphs: vec![OnceLock::new(); glyphs],
            kerning: [b"latn", b"grek", b"cyrl"].map(|script| kerning(&font, Tag::new(script)).expect(sound)),
            ligatures: ligatures(&font).expect(sound),
            shapes: font.outline_glyphs(),
            letters,
            metrics,
        }
    }

    /// Whether the face can draw a letter.
    pub(super) fn has(&self, letter: char) -> bool {
        self.index(letter).is_some()
    }

    fn index(&self, letter: char) -> Option<GlyphId> {
        match self.indices.get(letter as usize) {
            Some(known) => *known,
            None => self.letters.map(letter),
        }
    }

    /// Width and ink of a text, with the font's kerning and ligatures, as renderers set it.
    pub(super) fn measure(&self, text: &str) -> TextExtent {
        let mut ink: Option<Rect> = None;
        let advance = self.set(text, |glyph, _, pen| {
            if let Some(glyph_ink) = self.glyph(glyph).extent.ink {
                let glyph_ink = glyph_ink + kurbo::Vec2::new(pen, 0.0);
                ink = Some(ink.map_or(glyph_ink, |all| all.union(glyph_ink)));
            }
        });
        TextExtent { advance, ink }
    }

    /// Calls `show` with the outline of each glyph of a text and its left end, in em, y down, set as
    /// [`measure`](Face::measure) measures. A letter that the face lacks is an empty box.
    pub(super) fn outline(&'static self, text: &str, mut show: impl FnMut(&'static BezPath, f64)) {
        self.set(text, |glyph, _, pen| show(&self.glyph(glyph).outline, pen));
    }

    /// Calls `show` for each glyph of a text with its number, 0 for a letter that the face lacks, the bytes of the text
    /// that it draws, and its left end in em. Returns the advance of the pen.
    pub(super) fn glyphs(&self, text: &str, mut show: impl FnMut(u16, Range<usize>, f64)) -> f64 {
        self.set(text, |glyph, letters, pen| {
            // Numbers of glyphs in a font have 16 bits.
            show(glyph.map_or(0, |glyph| glyph.to_u32() as u16), letters, pen);
        })
    }

    /// Sets a text: calls `put` for each glyph, none for a letter that the face lacks, with the bytes of the text that
    /// it draws and its left end in em. Returns the advance of the pen.
    fn set(&self, text: &str, mut put: impl FnMut(Option<GlyphId>, Range<usize>, f64)) -> f64 {
        let mut pen = 0.0;
        let mut previous: Option<GlyphId> = None;
        let mut script = Alphabet::Latin;
        let mut letters = text.chars();
        loop {
            let start = text.len() - letters.as_str().len();
            let Some(letter) = letters.next() else {
                return pen;
            };
            let Some(mut glyph) = self.index(letter) else {
                put(None, start..start + letter.len_utf8(), pen);
                pen += UNKNOWN.advance;
                previous = None;
                continue;
            };
            // Kerning does not cross scripts; signs and digits belong to the script before them.
            if let Some(own) = script_of(letter)
                && own != script
            {
                script = own;
                previous = None;
            }
            if let Some((joined, more)) = self.ligature(glyph, &letters) {
                glyph = joined;
                letters.by_ref().take(more).for_each(drop);
            }
            if let Some(before) = previous {
                pen += self.kern(script, before, glyph);
            }
            put(Some(glyph), start..text.len() - letters.as_str().len(), pen);
            pen += self.glyph(Some(glyph)).extent.advance;
            previous = Some(glyph);
        }
    }

    /// A glyph; for none the empty box that stands for a letter that the face lacks.
    fn glyph(&self, id: Option<GlyphId>) -> &Glyph {
        static EMPTY_BOX: LazyLock<Glyph> = LazyLock::new(|| Glyph { outline: empty_box(), extent: UNKNOWN });
        let known = id.and_then(|id| Some((id, self.glyphs.get(id.to_u32() as usize)?)));
        known.map_or(&EMPTY_BOX, |(id, known)| known.get_or_init(|| self.read(id)))
    }

    /// Reads a glyph; one without ink has an empty outline.
    fn read(&self, id: GlyphId) -> Glyph {
        let mut elements: Vec<PathElement> = Vec::new();
        if let Some(shape) = self.shapes.get(id) {
            let settings = DrawSettings::unhinted(Size::unscaled(), LocationRef::default());
            shape.draw(settings, &mut elements).expect("outlines of the bundled fonts are sound");
        }
        let at = |x: f32, y: f32| Point::new(f64::from(x) / self.em, -f64::from(y) / self.em);
        let part = |element: PathElement| match element {
            PathElement::MoveTo { x, y } => PathEl::MoveTo(at(x, y)),
            PathElement::LineTo { x, y } => PathEl::LineTo(at(x, y)),
            PathElement::QuadTo { cx0, cy0, x, y } => PathEl::QuadTo(at(cx0, cy0), at(x, y)),
            PathElement::CurveTo { cx0, cy0, cx1, cy1, x, y } => PathEl::CurveTo(at(cx0, cy0), at(cx1, cy1), at(x, y)),
            PathElement::Close => PathEl::ClosePath,
        };
        let outline: BezPath = elements.into_iter().map(part).collect();
        let advance = f64::from(self.metrics.advance_width(id).unwrap_or(0.0)) / self.em;
        let ink = (!outline.is_empty()).then(|| outline.control_box());
        Glyph { outline, extent: TextExtent { advance, ink } }
    }

    fn kern(&self, script: Alphabet, left: GlyphId, right: GlyphId) -> f64 {
        let moved = |kerning: &Kerning| {
            let row = kerning.moves.get(usize::from((*kerning.left.get(left.to_u32() as usize)?)?))?;
            row.get(usize::from(*kerning.right.get(right.to_u32() as usize)?)).copied()
        };
        self.kerning[script as usize].iter().filter_map(moved).sum()
    }

    /// The ligature that a glyph forms with the letters after it, as f with i, and the number of these letters.
    fn ligature(&self, first: GlyphId, next: &Chars<'_>) -> Option<(GlyphId, usize)> {
        let forms = |ligature: &&Ligature| {
            let mut letters = next.clone();
            let mut following = ligature.following.iter();
            ligature.first == first
                && following.all(|part| letters.next().and_then(|letter| self.index(letter)) == Some(*part))
        };
        let found = self.ligatures.iter().find(forms)?;
        Some((found.glyph, found.following.len()))
    }
}

/// The outline for a letter that the face lacks: a box of a capital's size.
fn empty_box() -> BezPath {
    let outer = Rect::new(0.06, -0.66, 0.54, 0.0);
    let mut path = outer.to_path(0.0);
    // Wound in the opposite sense, so that the inside stays clear.
    path.extend(outer.inset(-0.05).to_path(0.0).reverse_subpaths());
    path
}

/// The script of a letter; none for signs and digits.
fn script_of(letter: char) -> Option<Alphabet> {
    match letter {
        'A'..='Z' | 'a'..='z' | '\u{C0}'..='\u{24F}' => Some(Alphabet::Latin),
        '\u{370}'..='\u{3FF}' | '\u{1F00}'..='\u{1FFF}' => Some(Alphabet::Greek),
        '\u{400}'..='\u{52F}' => Some(Alphabet::Cyrillic),
        _ => None,
    }
}

fn kerning(font: &FontRef<'static>, script: Tag) -> Result<Vec<Kerning>, ReadError> {
    let table = font.gpos()?;
    let scripts = table.script_list()?;
    let Some(script) = scripts.script_records().iter().find(|record| record.script_tag() == script) else {
        return Ok(Vec::new());
    };
    let Some(language) = script.script(scripts.offset_data())?.default_lang_sys().transpose()? else {
        return Ok(Vec::new());
    };
    let features: Vec<u16> = language.feature_indices().iter().map(|index| index.get()).collect();
    let mut found = Vec::new();
    for index in lookups(&table.feature_list()?, Tag::new(b"kern"), |feature| features.contains(&feature))? {
        if let PositionSubtables::Pair(subtables) = table.lookup_list()?.lookups().get(index.into())?.subtables()? {
            for subtable in subtables.iter() {
                found.push(Kerning::read(font, &subtable?)?);
            }
        }
    }
    Ok(found)
}

impl Kerning {
    fn read(font: &FontRef<'static>, subtable: &PairPos<'static>) -> Result<Self, ReadError> {
        let PairPos::Format2(subtable) = subtable else {
            return Err(ReadError::InvalidFormat(subtable.pos_format().into()));
        };
        let glyphs = usize::from(font.maxp()?.num_glyphs());
        let em = f64::from(font.head()?.units_per_em());
        let (mut left, mut right) = (vec![None; glyphs], vec![0; glyphs]);
        for glyph in subtable.coverage()?.iter() {
            left[glyph.to_u32() as usize] = Some(0);
        }
        for (glyph, class) in subtable.class_def1()?.iter() {
            left[glyph.to_u32() as usize] = left[glyph.to_u32() as usize].and(Some(class));
        }
        for (glyph, class) in subtable.class_def2()?.iter() {
            right[glyph.to_u32() as usize] = class;
        }
        let mut moves = Vec::new();
        for row in subtable.class1_records().iter() {
            let moved = row?.class2_records.iter().map(|record| Ok(record?.value_record1.x_advance().unwrap_or(0)));
            let moved: Result<Vec<i16>, ReadError> = moved.collect();
            moves.push(moved?.into_iter().map(|units| f64::from(units) / em).collect());
        }
        Ok(Self { left, right, moves })
    }
}

/// The standard ligatures of the face (OpenType GSUB, lookup type 4); they are the same for all
/// scripts of the bundled fonts.
fn ligatures(font: &FontRef<'static>) -> Result<Vec<Ligature>, ReadError> {
    let table = font.gsub()?;
    let mut found = Vec::new();
    for index in lookups(&table.feature_list()?, Tag::new(b"liga"), |_| true)? {
        let SubstitutionSubtables::Ligature(subtables) =
            table.lookup_list()?.lookups().get(index.into())?.subtables()?
        else {
            continue;
        };
        for subtable in subtables.iter() {
            let subtable = subtable?;
            for (first, set) in subtable.coverage()?.iter().zip(subtable.ligature_sets().iter()) {
                for ligature in set?.ligatures().iter() {
                    let ligature = ligature?;
                    let following = ligature.component_glyph_ids().iter().map(|glyph| glyph.get().into());
                    found.push(Ligature {
                        first: first.into(),
                        following: following.collect(),
                        glyph: ligature.ligature_glyph().into(),
                    });
                }
            }
        }
    }
    Ok(found)
}

/// The lookups of the features with a tag whose indices are `asked` for.
fn lookups(features: &FeatureList<'_>, tag: Tag, asked: impl Fn(u16) -> bool) -> Result<Vec<u16>, ReadError> {
    let mut found = Vec::new();
    for (number, record) in (0..).zip(features.feature_records()) {
        if record.feature_tag() == tag && asked(number) {
            let feature = record.feature(features.offset_data())?;
            found.extend(feature.lookup_list_indices().iter().map(|index| index.get()));
        }
    }
    Ok(found)
}
