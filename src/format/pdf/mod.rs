use krilla::Document;
use krilla::color::rgb;
use krilla::geom::Transform;
use krilla::metadata::Metadata;
use krilla::num::NormalizedF32;
use krilla::page::PageSettings;
use krilla::paint::{Fill, FillRule, LineCap, LineJoin, Stroke, StrokeDash};
use krilla::surface::Surface;
use krilla::tagging::{Artifact, ContentTag, Tag, TagGroup, TagTree};

mod shapes;

use crate::drawing::{Cap, Colour, Dash, Drawing, Look, Mark, Point, Shape};
use shapes::{chain, draw_path, outlines, path, write_text};

/// Points of PDF in a millimetre.
const POINTS: f64 = 72.0 / 25.4;
/// Longest side of a page that PDF readers accept, in mm.
const MOST_MM: f64 = 14_400.0 / POINTS;

/// Why a drawing could not be written as PDF.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PdfError {
    /// The sheet has no size that a page can have.
    #[error("a sheet of {width} x {height} mm: a page of PDF has sides of more than 0 and up to {MOST_MM} mm")]
    Size {
        /// Width in mm.
        width: f64,
        /// Height in mm.
        height: f64,
    },
    /// The PDF library refuses the drawing.
    #[error("the drawing cannot be written as PDF: {0}")]
    Writing(String),
}

impl Drawing {
    /// The bytes of a PDF file of one page, as large as the sheet, in lines and letters; the letters used of the
    /// bundled fonts are embedded.
    ///
    /// Texts can be searched and copied. Title, language and, for readers who cannot see the figure, its description
    /// are metadata; there is no date, so that the same drawing gives the same bytes. A letter that the bundled font
    /// lacks is an empty box, but search finds it. Marks whose numbers are not finite are left out.
    pub fn pdf(&self) -> Result<Vec<u8>, PdfError> {
        pdf_pages(std::slice::from_ref(self), None)
    }

    /// The bytes of a PDF file of one page: the drawing over a picture as large as its sheet.
    ///
    /// # Errors
    /// The page cannot be that large, or the file cannot be made.
    #[cfg(feature = "cli")]
    pub fn pdf_over(&self, backdrop: &super::Backdrop) -> Result<Vec<u8>, PdfError> {
        let [width, height] = backdrop.size;
        let image = krilla::image::Image::from_rgba8(backdrop.colours(), width, height);
        let size = krilla::geom::Size::from_wh(self.width as f32, self.height as f32);
        let size = size.ok_or(PdfError::Size { width: self.width, height: self.height })?;
        pages(std::slice::from_ref(self), None, Some(&|surface| surface.draw_image(image.clone(), size)))
    }

    /// Draws the sheet on a new page; returns its tags.
    fn draw_page(&self, document: &mut Document, picture: Option<DrawPicture<'_>>) -> Result<TagGroup, PdfError> {
        let (width, height) = (self.width, self.height);
        let fits = |side: f64| side > 0.0 && side <= MOST_MM;
        if !(fits(width) && fits(height)) {
            return Err(PdfError::Size { width, height });
        }
        let page = PageSettings::from_wh((width * POINTS) as f32, (height * POINTS) as f32);
        let page = page.ok_or(PdfError::Size { width, height })?;

        let mut figure = TagGroup::new(Tag::Figure(Some(self.description.clone())));
        let mut page = document.start_page_with(page);
        let mut surface = page.surface();
        let millimetres = POINTS as f32;
        surface.push_transform(&Transform::from_scale(millimetres, millimetres));
        if let Some(draw_picture) = picture {
            surface.start_tagged(ContentTag::Artifact(Artifact::default()));
            draw_picture(&mut surface);
            surface.end_tagged();
            // As on a film: where the drawing is white the picture stays as it is.
            surface.push_blend_mode(krilla::blend::BlendMode::Multiply);
        }
        let marks: Vec<(&Mark, bool)> = self.marks.iter().zip(self.halos()).collect();
        let background = self.style.background();
        if background != Colour::new(0xffffff) {
            let (x, y) = (width, height);
            let corners = [(0.0, 0.0), (x, 0.0), (x, y), (0.0, y)].map(Point::from);
            surface.start_tagged(ContentTag::Artifact(Artifact::default()));
            pens(&mut surface, None, Some(fill(background)));
            draw_path(&mut surface, chain(&corners, true));
            surface.end_tagged();
        }
        // Consecutive marks of one pen, as in SVG: all halos come before all letters, so that none covers a neighbour.
        for marks in marks.chunk_by(|a, b| a.0.pen == b.0.pen && is_text(a.0) == is_text(b.0)) {
            for (mark, _) in marks.iter().filter(|mark| mark.1) {
                surface.start_tagged(ContentTag::Artifact(Artifact::default()));
                halo(&mut surface, background, &self.look(mark), &mark.shape);
                surface.end_tagged();
            }
            for (mark, _) in marks.iter().filter(|(mark, _)| mark.shape.is_drawable()) {
                let look = self.look(mark);
                if let Shape::Text(text) = &mark.shape {
                    pens(&mut surface, None, Some(fill(look.ink)));
                    figure.push(write_text(&mut surface, text));
                } else {
                    figure.push(surface.start_tagged(ContentTag::Other));
                    draw(&mut surface, &look, &mark.shape);
                    surface.end_tagged();
                }
            }
        }
        if picture.is_some() {
            surface.pop();
        }
        surface.pop();
        surface.finish();
        page.finish();

        Ok(figure)
    }
}

/// The bytes of a PDF file with a page for each sheet, as [`Drawing::pdf`] writes one; title, language and description
/// are those of the first sheet. `keyword` is metadata by which programs know the file.
///
/// # Errors
/// A sheet has no size that a page can have, or there is no sheet.
pub fn pdf_pages(sheets: &[Drawing], keyword: Option<&str>) -> Result<Vec<u8>, PdfError> {
    pages(sheets, keyword, None)
}

/// Draws what lies under a sheet.
type DrawPicture<'a> = &'a dyn Fn(&mut Surface<'_>);

/// A page for each sheet, the same under all of them.
fn pages(sheets: &[Drawing], keyword: Option<&str>, picture: Option<DrawPicture<'_>>) -> Result<Vec<u8>, PdfError> {
    let first = sheets.first().ok_or_else(|| PdfError::Writing("it has no sheet".to_owned()))?;
    let mut document = Document::new();
    let mut tags = TagTree::new();
    for sheet in sheets {
        tags.push(sheet.draw_page(&mut document, picture)?);
    }
    document.set_tag_tree(tags);
    let mut about = Metadata::new().language(first.language.into());
    if !first.title.is_blank() {
        about = about.title(first.title.for_pdf());
    }
    about = about.description(first.description.clone()).creator("Kinegon".into());
    if let Some(keyword) = keyword {
        about = about.keywords(vec![keyword.to_owned()]);
    }
    document.set_metadata(about);
    document.finish().map_err(|error| PdfError::Writing(format!("{error:?}")))
}

fn is_text(mark: &Mark) -> bool {
    matches!(mark.shape, Shape::Text(_))
}

/// Draws a shape that is not a text, in the look of its pen.
fn draw(surface: &mut Surface<'_>, look: &Look, shape: &Shape) {
    match shape {
        // `write_text` writes texts.
        Shape::Text(_) => {}
        Shape::Arrow { .. } | Shape::ArcArrow { .. } => {
            if let Some(shaft) = shape.shaft() {
                draw(surface, look, &shaft);
            }
            if let Some(head) = shape.head() {
                // Without a stroke, which would move the tip beyond the vector's end.
                pens(surface, None, Some(fill(look.stroke.unwrap_or(look.ink))));
                draw_path(surface, chain(&head, true));
            }
        }
        // An open line is never filled, even with a pen that fills areas.
        Shape::Line(..) | Shape::Polyline(_) | Shape::Arc { .. } => {
            pens(surface, stroke(look), None);
            draw_path(surface, path(shape));
        }
        Shape::Polygon(_) | Shape::Area(_) | Shape::Circle { .. } => {
            pens(surface, stroke(look), look.fill.map(fill));
            draw_path(surface, path(shape));
        }
    }
}

/// Draws the line in the background's colour around the letters of a text; as outlines, so that a search finds the
/// letters only once.
fn halo(surface: &mut Surface<'_>, background: Colour, look: &Look, shape: &Shape) {
    let Shape::Text(text) = shape else { return };
    let around = Look { stroke: Some(background), width: look.halo, dash: Dash::new(), ..look.clone() };
    pens(surface, stroke(&around), Some(fill(background)));
    draw_path(surface, outlines(text));
}

fn pens(surface: &mut Surface<'_>, stroke: Option<Stroke>, fill: Option<Fill>) {
    surface.set_stroke(stroke);
    surface.set_fill(fill);
}

fn paint(Colour { red, green, blue }: Colour) -> krilla::paint::Paint {
    rgb::Color::new(red, green, blue).into()
}

fn fill(colour: Colour) -> Fill {
    Fill { paint: paint(colour), opacity: NormalizedF32::ONE, rule: FillRule::NonZero }
}

/// The stroke of a look; `None` for areas without outline.
fn stroke(look: &Look) -> Option<Stroke> {
    let dash = StrokeDash { array: look.dash.iter().map(|&length| length as f32).collect(), offset: 0.0 };
    Some(Stroke {
        paint: paint(look.stroke?),
        width: look.width as f32,
        line_cap: match look.cap {
            Cap::Flat => LineCap::Butt,
            Cap::Round => LineCap::Round,
        },
        line_join: LineJoin::Round,
        dash: (!look.dash.is_empty()).then_some(dash),
        ..Stroke::default()
    })
}
