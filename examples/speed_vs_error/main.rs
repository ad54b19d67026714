//! Measures, in one run, how long several methods take for velocities and accelerations of fourth-class groups and how wrong they are.
//! `cargo run --release --example speed_vs_error` prints a table and writes out/speed-vs-error (.svg, .png, .json) and docs/accuracy (.md, .svg, -condition.svg, -which.svg).

mod condition;
mod picture;
mod which;

use kinegon::drawing::Drawing;
use kinegon::format::{self, Text};
use std::error::Error;
use std::fs;
use support::files;
use support::speed_vs_error::document;
use support::speed_vs_error::lengths::Lengths;
use support::speed_vs_error::routes::Routes;
use support::speed_vs_error::survey::{Survey, times};
use support::speed_vs_error::which::section;

fn main() -> Result<(), Box<dyn Error>> {
    let (survey, lengths, routes) = (Survey::new(), Lengths::new(), Routes::new());
    let times = times();
    let machine = machine();
    print!("{}", document::table(&survey, &times));
    let out = files::path("out");
    fs::create_dir_all(&out)?;
    let drawing = picture::picture(&survey, &times);
    // The guide's pictures lie beside its pages.
    // Running text in another font would overlap: letters are outlines there.
    let outlined = |drawing: &Drawing| format::svg_with(drawing, Text::Outlines);
    fs::write(files::path("docs/accuracy.svg"), outlined(&drawing))?;
    fs::write(out.join("speed-vs-error.svg"), outlined(&drawing))?;
    fs::write(out.join("speed-vs-error.png"), drawing.png(200.0)?)?;
    fs::write(files::path("docs/accuracy-condition.svg"), outlined(&condition::picture(&survey, &lengths)))?;
    fs::write(files::path("docs/accuracy-which.svg"), outlined(&which::picture(&routes)))?;
    let numbers = document::numbers(&survey, &times, &machine);
    fs::write(out.join("speed-vs-error.json"), format::json(&numbers))?;
    let page = document::accuracy(&survey)
        + &section(&routes)
        + &document::from_lengths(&lengths)
        + &document::speed(&times, &machine);
    fs::write(files::path("docs/accuracy.md"), page)?;
    Ok(())
}

/// The processor's name as Linux tells it.
fn machine() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let mut lines = info.lines().filter_map(|line| line.split_once(':'));
    let name = lines.find(|(key, _)| key.trim() == "model name");
    name.map_or("an unknown processor", |(_, name)| name.trim()).to_owned()
}
