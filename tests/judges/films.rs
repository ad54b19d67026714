//! Films as Chromium sees them: how many pictures, how long each, how often, and what is on them.

use kinegon::drawing::{Film, Timing};
use kinegon::format::FilmFormat;
use serde_json::json;
use support::browser::Browser;
use support::files;
use support::program::scratch;
use support::stages::solved;

/// What the browser says of a film that stands in an image element: pictures, milliseconds of each, whether it is shown for ever, its
/// size, and for some pictures the share of pixels that are not white.
const SEEN: &str = "(async () => { \
    const bytes = await new Promise((done) => { const asked = new XMLHttpRequest(); asked.open('GET', document.images[0].src); \
        asked.responseType = 'arraybuffer'; asked.onload = () => done(asked.response); asked.send(); }); \
    const decoder = new ImageDecoder({ data: bytes, type: document.images[0].dataset.type }); \
    await decoder.completed; await decoder.tracks.ready; \
    const { frameCount: count, repetitionCount: times } = decoder.tracks.selectedTrack; \
    const canvas = Object.assign(document.createElement('canvas'), { width: 1, height: 1 }); \
    const lengths = [], ink = []; \
    for (let frameIndex = 0; frameIndex < count; frameIndex += 1) { \
        const { image } = await decoder.decode({ frameIndex }); \
        lengths.push(image.duration / 1000); \
        [canvas.width, canvas.height] = [image.displayWidth, image.displayHeight]; \
        const context = canvas.getContext('2d'); context.drawImage(image, 0, 0); image.close(); \
        const { data } = context.getImageData(0, 0, canvas.width, canvas.height); \
        let dark = 0; for (let at = 0; at < data.length; at += 4) dark += data[at] < 128 && data[at + 3] === 255; \
        ink.push(dark); \
    } \
    return { count, times: String(times), lengths, size: [canvas.width, canvas.height], ink }; })()";

#[test]
#[ignore = "needs Chromium"]
fn chromium_shows_every_picture_of_a_film() {
    let folder = scratch("films-judged");
    let mut browser = Browser::start(&folder, [800, 600]);
    let own = solved(&files::read("templates/four-bar.json")).expect("it moves");
    let film = Film::new(&own, None, Timing { seconds: 1.5, per_second: 8 }).expect("it moves");
    let mut inks = Vec::new();
    for (format, name, kind) in
        [(FilmFormat::Gif, "film.gif", "image/gif"), (FilmFormat::Apng, "film.apng", "image/png")]
    {
        let served = [
            (name.to_owned(), film.file(format, 48.0, |_| ()).expect("a film")),
            ("film.html".to_owned(), format!("<img src='{name}' data-type='{kind}'>").into_bytes()),
        ];
        browser.visit(served.into(), "film.html", "document.images[0]?.complete === true");
        let seen = browser.value(SEEN);
        assert_eq!(seen["count"], 12, "{name}: {seen}");
        assert_eq!(seen["times"], "Infinity", "{name}");
        let sum: f64 = seen["lengths"].as_array().expect("a list").iter().filter_map(|ms| ms.as_f64()).sum();
        assert!((sum - 1500.0).abs() < 1.0, "{name}: {}", seen["lengths"]);
        // A4, upright or not.
        let [across, down] = own.scene.figure.page.size_mm().map(|mm| (mm * 48.0 / 25.4).round() as u32);
        assert_eq!(seen["size"], json!([across, down]), "{name}");
        inks.push(seen["ink"].as_array().expect("a list").iter().filter_map(|ink| ink.as_f64()).collect::<Vec<_>>());
    }
    // The same drawings in both, all with about as much ink.
    for (a, b) in inks[0].iter().zip(&inks[1]) {
        assert!(*b > 500.0 && (a - b).abs() < 0.03 * b, "{inks:?}");
    }
}
