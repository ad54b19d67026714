//! A page with markers and a code, as it is agreed, drawn without the library.

use qrcodegen::{QrCode, QrCodeEcc, QrSegment, Version};
use std::fmt::Write;

/// The side of a marker in mm.
pub const SIDE: f64 = 8.0;
/// From a marker to the sheet's edge, in mm.
const EDGE: f64 = 6.5;
/// The inner cells of the markers, row by row, the first in bit 15; 1 is black.
const CODES: [u16; 8] = [0x3f, 0x1c7, 0x1f8, 0x64b, 0x695, 0x726, 0xb1a, 0xb75];

/// Upper left corners of the markers in mm: clockwise from the sheet's upper left corner.
pub fn marker_corners([width, height]: [f64; 2]) -> [[f64; 2]; 8] {
    let (right, bottom) = (width - EDGE - SIDE, height - EDGE - SIDE);
    let (middle, half) = ((width - SIDE) / 2.0, (height - SIDE) / 2.0);
    [
        [EDGE, EDGE],
        [middle, EDGE],
        [right, EDGE],
        [right, half],
        [right, bottom],
        [middle, bottom],
        [EDGE, bottom],
        [EDGE, half],
    ]
}

/// The SVG of an otherwise empty page in mm, with more of it inside.
pub fn with_markers(mm: [f64; 2], code: &str, inside: &str) -> String {
    let mut svg = begun(mm);
    for (corner, code) in marker_corners(mm).into_iter().zip(CODES) {
        marker(&mut svg, corner, code);
    }
    let side = if mm[0].max(mm[1]) > 400.0 { 20.0 } else { 16.0 };
    qr(&mut svg, [mm[0] - 17.5 - side, mm[1] - 17.5 - side], side, code);
    svg + inside + "</svg>"
}

/// The beginning of a page's SVG, in mm.
pub fn begun([width, height]: [f64; 2]) -> String {
    format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {width} {height}' width='{width}' height='{height}'>\
         <rect width='{width}' height='{height}' fill='white'/>"
    )
}

/// A square of 6 × 6 cells with a black border.
pub fn marker(svg: &mut String, [x, y]: [f64; 2], code: u16) {
    let cell = SIDE / 6.0;
    let _ = write!(svg, "<path d='M{x} {y}h{SIDE}v{SIDE}h-{SIDE}z");
    for k in 0..16 {
        if code >> (15 - k) & 1 == 0 {
            // Against the border's sense, so that it is left out.
            let (x, y) = (x + cell * f64::from(k % 4 + 1), y + cell * f64::from(k / 4 + 1));
            let _ = write!(svg, "M{x} {y}v{cell}h{cell}v-{cell}z");
        }
    }
    svg.push_str("'/>");
}

fn qr(svg: &mut String, [x, y]: [f64; 2], side: f64, text: &str) {
    let segments = QrSegment::make_segments(text);
    let version = |n| Version::new(n);
    let code = QrCode::encode_segments_advanced(&segments, QrCodeEcc::Medium, version(1), version(6), None, false)
        .or_else(|_| QrCode::encode_text(text, QrCodeEcc::Low))
        .expect("the test's code is short");
    let cell = side / f64::from(code.size());
    svg.push_str("<path d='");
    for (row, column) in (0..code.size()).flat_map(|row| (0..code.size()).map(move |column| (row, column))) {
        if code.get_module(column, row) {
            let (x, y) = (x + cell * f64::from(column), y + cell * f64::from(row));
            let _ = write!(svg, "M{x} {y}h{cell}v{cell}h-{cell}z");
        }
    }
    svg.push_str("'/>");
}
