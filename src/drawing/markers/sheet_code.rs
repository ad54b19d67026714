//! What the small code of a sheet says, as a text and as the black and white squares of a QR code.

use crate::scene::{Page, PageSize};
use crate::sheet::Sheet;
use qrcodegen::{Mask, QrCode, QrCodeEcc, QrSegment, Version};

/// The first sign of every text: kind and version.
const FORMAT: &str = "K1";
/// Letters of a scene's hash.
const HASH: usize = 8;
/// Most letters of a name.
const NAME: usize = 24;
/// Most letters of a text that is read.
const LONGEST: usize = 400;
/// Largest scale and place that is read; scenes have no larger numbers either.
const LARGEST: f64 = 1e100;
/// Largest code with much redundancy, of 41 modules; longer texts have less.
const ROBUST: u8 = 6;

/// Pages and their signs.
const PAGES: [(PageSize, &str); 3] = [(PageSize::A4, "A4"), (PageSize::A3, "A3"), (PageSize::Letter, "LT")];

/// What the code on a sheet says: which sheet of which scene it is, and where its panels stand at which scales.
///
/// ```
/// use kinegon::drawing::markers::SheetCode;
/// let text = "K1/A4L/2/8K3MZQ4T/V0.05:148:105+A0.5:60:90/FOUR-BAR-7-2";
/// # let text = text.replace('Z', "N");
/// let code = SheetCode::read(&text).expect("a sheet of Kinegon");
/// assert_eq!(code.number, 2);
/// assert_eq!(code.panels[1].mu, 0.5);
/// assert_eq!(code.text(), text);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SheetCode {
    /// The paper; not `16x9`, whose sheets have no code.
    pub page: Page,
    /// The sheet's number in its set, from 1.
    pub number: u16,
    /// The [fingerprint](crate::Scene::fingerprint) of its scene.
    pub scene: String,
    /// Its panels; no kind twice.
    pub panels: Vec<PlacedPanel>,
    /// The name of the exercise or scene, in signs of a QR code: capital letters, digits, some others; at most 24.
    pub name: String,
}

/// A panel's place on its sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedPanel {
    /// Scheme or plan.
    pub panel: Sheet,
    /// Its scale, in units per millimetre of paper.
    pub mu: f64,
    /// Where its origin is, in mm from the sheet's upper left corner, y down: a plan's pole; of a scheme the scene's point
    /// (0, 0), which may be off the sheet.
    pub origin: [f64; 2],
}

impl PlacedPanel {
    /// Where a place of the panel, in its own units with y up, is on the sheet, in mm.
    #[must_use]
    pub fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.origin[0] + x / self.mu, self.origin[1] - y / self.mu]
    }

    fn text(&self) -> String {
        let sign = self.panel.facts().letter;
        // To 0.01 mm; adding 0 takes the sign from −0.
        let [x, y] = self.origin.map(|mm| shortest(libm::round(100.0 * mm) / 100.0 + 0.0));
        format!("{sign}{}:{x}:{y}", shortest(self.mu))
    }

    fn read(text: &str) -> Option<PlacedPanel> {
        let first = text.chars().next()?;
        let panel = Sheet::ALL.into_iter().find(|sheet| sheet.facts().letter == first)?;
        let numbers: Vec<f64> = text[first.len_utf8()..].split(':').map(number).collect::<Option<_>>()?;
        let [mu, x, y] = numbers[..] else { return None };
        // The smallest scale keeps what is measured on paper finite.
        (mu >= 1.0 / LARGEST).then_some(PlacedPanel { panel, mu, origin: [x, y] })
    }
}

impl SheetCode {
    /// The text in the code, in letters of the alphanumeric mode of QR codes.
    #[must_use]
    pub fn text(&self) -> String {
        let panels: Vec<String> = self.panels.iter().map(|panel| panel.text()).collect();
        let page = page_sign(self.page);
        let [scene, name] = [self.scene.as_str(), &written_name(&self.name)];
        format!("{FORMAT}/{page}/{}/{scene}/{}/{name}", self.number, panels.join("+"))
    }

    /// What a text says; none if it is not that of a sheet.
    #[must_use]
    pub fn read(text: &str) -> Option<SheetCode> {
        if text.len() > LONGEST {
            return None;
        }
        let fields: Vec<&str> = text.split('/').collect();
        let [FORMAT, page, number, scene, panels, name] = fields[..] else { return None };
        let is_hash = scene.len() == HASH && scene.bytes().all(|sign| matches!(sign, b'0'..=b'9' | b'A'..=b'V'));
        let is_name = name.chars().count() <= NAME && name == written_name(name);
        if !(is_hash && is_name) {
            return None;
        }
        let panels: Vec<PlacedPanel> = panels.split('+').map(PlacedPanel::read).collect::<Option<_>>()?;
        let is_twice = |(index, panel): (usize, &PlacedPanel)| panels[..index].iter().any(|p| p.panel == panel.panel);
        if panels.iter().enumerate().any(is_twice) {
            return None;
        }
        // Without sign and zeros before it.
        let number = number.parse().ok().filter(|read: &u16| *read > 0 && read.to_string() == number)?;
        let page = pages().find(|known| page_sign(*known) == page)?;
        Some(SheetCode { page, number, scene: scene.to_owned(), panels, name: name.to_owned() })
    }

    /// The black and white squares of the code, by rows from above, without the white around it; true is black. None
    /// for a text that no code holds.
    ///
    /// The smallest code that holds the text with a seventh of its words spoilt; where that would have more than 41
    /// squares along a side, with fewer.
    #[must_use]
    pub fn modules(&self) -> Option<Vec<Vec<bool>>> {
        let text = self.text();
        if !text.chars().all(is_sign) {
            return None;
        }
        let segments = [QrSegment::make_alphanumeric(&text)];
        let encoded = |level, most: Version, raised| {
            QrCode::encode_segments_advanced(&segments, level, Version::MIN, most, None::<Mask>, raised).ok()
        };
        let robust = encoded(QrCodeEcc::Medium, Version::new(ROBUST), true);
        let code = robust.or_else(|| encoded(QrCodeEcc::Low, Version::MAX, false))?;
        let row = |y| (0..code.size()).map(|x| code.get_module(x, y)).collect();
        Some((0..code.size()).map(row).collect())
    }
}

/// A name in signs of a QR code that part no fields, cut to its length.
pub(super) fn written_name(name: &str) -> String {
    let sign = |sign: char| if is_sign(sign) && sign != '/' { sign } else { '-' };
    name.chars().flat_map(char::to_uppercase).map(sign).take(NAME).collect()
}

/// Whether a sign is of the alphanumeric mode.
fn is_sign(sign: char) -> bool {
    matches!(sign, '0'..='9' | 'A'..='Z' | ' ' | '$' | '%' | '*' | '+' | '-' | '.' | '/' | ':')
}

fn page_sign(page: Page) -> String {
    let size = PAGES.into_iter().find(|(size, _)| *size == page.size).map_or("", |(_, sign)| sign);
    format!("{size}{}", if page.landscape { 'L' } else { 'P' })
}

/// The pages on which sheets with a code are printed.
pub fn pages() -> impl Iterator<Item = Page> {
    PAGES.into_iter().flat_map(|(size, _)| [true, false].map(|landscape| Page { size, landscape }))
}

/// The shortest text from which the same number is read back.
fn shortest(x: f64) -> String {
    let [plain, power] = [x.to_string(), format!("{x:E}")];
    if power.len() < plain.len() { power } else { plain }
}

/// A finite number as it is written in a code.
fn number(text: &str) -> Option<f64> {
    let is_plain = text.bytes().all(|sign| matches!(sign, b'0'..=b'9' | b'.' | b'-' | b'E'));
    let number: f64 = text.parse().ok().filter(|_| is_plain)?;
    (number.abs() <= LARGEST).then_some(number)
}
