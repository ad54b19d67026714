//! Pictures of a printed sheet, painted over and shifted: each is read or refused.

#![no_main]

use kinegon::drawing::Drawing;
use kinegon::format::{Text, svg_with};
use kinegon::photo::{Picture, read};
use kinegon::scene::Scene;
use libfuzzer_sys::fuzz_target;
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use std::sync::LazyLock;

/// Width, height and pixels of a sheet that can be read.
static SHEET: LazyLock<(usize, usize, Vec<u8>)> = LazyLock::new(|| {
    let scene = Scene::read(include_str!("../../templates/four-bar.json")).expect("a good scene");
    let solution = kinegon::solve(&scene).expect("it moves");
    let sheet: Drawing = solution.drawing_sheets("1").remove(0);
    let tree = Tree::from_str(&svg_with(&sheet, Text::Outlines), &Options::default()).expect("it can be read");
    let size = tree.size().to_int_size();
    let mut pixels = Pixmap::new(size.width(), size.height()).expect("it is small");
    pixels.fill(Color::WHITE);
    resvg::render(&tree, Transform::identity(), &mut pixels.as_mut());
    let grey = pixels.data().chunks_exact(4).map(|pixel| pixel[1]).collect();
    (size.width() as usize, size.height() as usize, grey)
});

fuzz_target!(|data: &[u8]| {
    let (width, height, mut grey) = SHEET.clone();
    for change in data.chunks_exact(8) {
        let at = |low: u8, high: u8, most: usize| usize::from(u16::from_le_bytes([low, high])) * most >> 16;
        let (x, y) = (at(change[1], change[2], width), at(change[3], change[4], height));
        let (right, below) = (width.min(x + usize::from(change[5])), height.min(y + usize::from(change[6])));
        for row in y..below {
            let shifted = (row + usize::from(change[7])) % height * width;
            for column in x..right {
                let there = row * width + column;
                grey[there] = match change[0] % 4 {
                    0 => change[7],
                    1 => 255 - grey[there],
                    2 => grey[shifted + column],
                    _ => grey[there].wrapping_mul(change[7]),
                };
            }
        }
    }
    let picture = Picture::new(width, height, grey).expect("as many pixels as before");
    if let Ok(sheet) = read(&picture, Vec::new) {
        assert!(sheet.strokes(&picture).len() < 1_000_000);
    }
});
