//! Films: the positions against circles and limits, the files read back picture by picture, names that stay.

use kinegon::Solution;
use kinegon::cycle::{CycleError, Drive, Path, Running};
use kinegon::drawing::{Drawing, Film, Mark, Pen, Point, Shape, Timing};
use kinegon::format::FilmFormat;
use kinegon::scene::StyleName;
use std::collections::BTreeMap;
use std::io::Cursor;
use support::files;
use support::stages::solved;
use support::survey::Size;

fn scene(name: &str) -> Solution {
    solved(&files::read(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The angles of a link in degrees, from its point to another.
fn angles(own: &Solution, running: &Running, [from, to]: [&str; 2]) -> Vec<f64> {
    let [from, to] = [from, to].map(|name| own.mechanism.point(name).expect("it is there"));
    let arms = running.poses.iter().map(|pose| pose.point(to) - pose.point(from));
    arms.map(|arm| libm::atan2(arm.y, arm.x).to_degrees()).collect()
}

/// Difference of two angles, from -180° to 180°.
fn turned(from: f64, to: f64) -> f64 {
    (to - from + 540.0).rem_euclid(360.0) - 180.0
}

#[test]
fn a_crank_turns_once_in_the_sense_of_its_speed() {
    let text = files::read("templates/four-bar.json");
    let other = text.replace("\"omega\": ", "\"omega\": -");
    for text in [text, other] {
        let own = solved(&text).expect("it moves");
        let sense = own.motion.body(own.mechanism.link("1").expect("a crank")).omega.signum();
        let running = Running::new(&own, None, 40).expect("it turns");
        assert_eq!((running.turns, running.poses.len()), (Some(1), 40));
        assert_eq!(running.poses[0].points, own.pose.points, "it begins with the scene's own");
        let angles = angles(&own, &running, ["A", "B"]);
        // The last is as far from the first as any other from the next.
        for (k, from) in angles.iter().enumerate() {
            let step = turned(*from, angles[(k + 1) % 40]);
            assert!((step - sense * 9.0).abs() < 1e-9, "{k}: {step}");
        }
    }
}

/// A cylinder's length goes up and down in equal steps between its ends, and no rate is infinite there.
#[test]
fn a_cylinder_goes_to_and_fro() {
    let own = scene("templates/hydraulic-boom.json");
    let running = Running::new(&own, None, 50).expect("it moves");
    assert_eq!((running.turns, running.poses.len()), (None, 50));
    let drive = Drive::new(&own.mechanism, None).expect("a drive");
    let mut path = Path::new(&own.mechanism, &own.pose, drive).expect("a path");
    path.cover(None, None).expect("it has two ends");
    let values: Vec<f64> = running.poses.iter().map(|pose| pose.slides.iter().flatten().sum()).collect();
    let steps: Vec<f64> = (0..50).map(|k| values[(k + 1) % 50] - values[k]).collect();
    let step = steps.iter().map(|step| step.abs()).fold(0.0, f64::max);
    let turns = steps.iter().filter(|one| (one.abs() - step).abs() > 1e-9).count();
    assert!(turns <= 2, "{steps:?}");
    let whole = path.high() - path.low();
    assert!(step * 25.0 < whole && step * 25.0 > 0.98 * whole, "{step} of {whole}");
    assert!(running.poses.iter().all(|pose| own.moved(pose.clone()).is_ok()));
}

/// Four turns of one crank are three of the other: only then the mechanism is where it began.
#[test]
fn a_film_lasts_until_all_drives_are_where_they_began() {
    let own = scene("templates/five-bar.json");
    let running = Running::new(&own, None, 30).expect("it turns");
    assert_eq!((running.turns, running.poses.len()), (Some(4), 120));
    let size = (own.pose.points[0] - own.pose.points[1]).norm();
    let apart = |a: usize, b: usize| {
        let pairs = running.poses[a].points.iter().zip(&running.poses[b].points);
        pairs.map(|(p, q)| (p - q).norm()).fold(0.0, f64::max)
    };
    let last = running.poses.len() - 1;
    assert!(apart(last, 0) < 2.0 * apart(last - 1, last) + 1e-9 * size, "a jump where it begins again");
}

/// What a film cannot be is told.
#[test]
fn what_does_not_move_has_no_film() {
    let own = scene("templates/four-bar.json");
    let refused = |timing: Timing| match Film::new(&own, None, timing) {
        Err(CycleError::Range(problem)) => problem,
        Err(other) => panic!("{other}"),
        Ok(_) => panic!("{timing:?} is a film"),
    };
    for (seconds, per_second, told) in [
        (0.0, 20, "cannot last 0 seconds"),
        (-1.0, 20, "cannot last -1 seconds"),
        (f64::NAN, 20, "cannot last NaN seconds"),
        (1e9, 20, "cannot last 1000000000 seconds"),
        (5.0, 0, "cannot have 0 pictures a second"),
        (5.0, 51, "cannot have 51 pictures a second"),
        (0.02, 50, "show no motion"),
        (120.0, 50, "would have 6000 pictures; it may have 2000"),
    ] {
        let problem = refused(Timing { seconds, per_second });
        assert!(problem.message.to_string().contains(told) && problem.hint.is_some(), "{problem}");
    }
    assert!(matches!(Film::new(&own, Some("9"), Timing::default()), Err(CycleError::NoSuchDrive { .. })));
    let drawn = scene("examples/figure-1.json");
    assert!(matches!(Film::new(&drawn, None, Timing::default()), Err(CycleError::Drawn | CycleError::NoDrive)));
}

/// Pixels row by row, of four bytes.
struct Picture {
    width: usize,
    pixels: Vec<[u8; 4]>,
}

impl Picture {
    fn blank([width, height]: [usize; 2]) -> Picture {
        Picture { width, pixels: vec![[0; 4]; width * height] }
    }

    /// What a PNG shows.
    fn of_png(bytes: &[u8]) -> Picture {
        let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().expect("it is PNG");
        let mut data = vec![0; reader.output_buffer_size().expect("it fits")];
        let info = reader.next_frame(&mut data).expect("it has pixels");
        let pixels = data.chunks_exact(3).map(|colour| [colour[0], colour[1], colour[2], 255]);
        Picture { width: info.width as usize, pixels: pixels.collect() }
    }

    /// Lays a smaller picture over it where that is not transparent.
    fn lay(&mut self, [left, top, width]: [usize; 3], pixels: &[[u8; 4]]) {
        for (index, pixel) in pixels.iter().enumerate().filter(|(_, pixel)| pixel[3] > 0) {
            self.pixels[(top + index / width) * self.width + left + index % width] = *pixel;
        }
    }

    /// The largest difference of a colour, and the mean square of all.
    fn off(&self, other: &Picture) -> (u8, f64) {
        assert_eq!((self.width, self.pixels.len()), (other.width, other.pixels.len()));
        let pairs = self.pixels.iter().flatten().zip(other.pixels.iter().flatten());
        let offs: Vec<u8> = pairs.map(|(a, b)| a.abs_diff(*b)).collect();
        let square = offs.iter().map(|off| f64::from(*off).powi(2)).sum::<f64>() / offs.len() as f64;
        (offs.into_iter().max().unwrap_or_default(), square)
    }
}

const SHORT: Timing = Timing { seconds: 1.6, per_second: 15 };
const DPI: f64 = 60.0;

/// Without loss: every picture has the pixels of its drawing's own PNG.
#[test]
fn apng_shows_every_drawing_as_it_is() {
    let own = scene("templates/slider-crank.json");
    let film = Film::new(&own, None, SHORT).expect("it moves");
    let mut heard = 0;
    let file = film.file(FilmFormat::Apng, DPI, |_| heard += 1).expect("a film");
    let mut reader = png::Decoder::new(Cursor::new(&file)).read_info().expect("it is PNG");
    let info = reader.info();
    let size = [info.width as usize, info.height as usize];
    let control = info.animation_control.expect("it is animated");
    assert_eq!((control.num_frames, control.num_plays, heard), (24, 0, 24));
    let mut data = vec![0; reader.output_buffer_size().expect("it fits")];
    let mut shown = Picture::blank(size);
    for (number, drawing) in film.drawings().enumerate() {
        let frame = reader.next_frame(&mut data).expect("another picture");
        let control = *reader.info().frame_control().expect("it says where");
        assert_eq!((control.delay_num, control.delay_den), (1, 15));
        let place = [control.x_offset, control.y_offset, control.width].map(|side| side as usize);
        shown.lay(place, data[..frame.buffer_size()].as_chunks::<4>().0);
        let expected = Picture::of_png(&drawing.png(DPI).expect("a picture"));
        assert_eq!(shown.off(&expected).0, 0, "picture {number}");
    }
}

/// In 255 colours for the whole film: paper, letters and lines keep theirs, and mixtures on edges are not far off.
#[test]
fn gif_shows_every_drawing_in_few_colours() {
    for (name, style) in
        [("templates/four-bar.json", StyleName::Paper), ("templates/whitworth.json", StyleName::Lecture)]
    {
        let mut own = scene(name);
        own.scene.figure.style = style;
        let film = Film::new(&own, None, SHORT).expect("it moves");
        let file = film.file(FilmFormat::Gif, DPI, |_| ()).expect("a film");
        let mut options = gif::DecodeOptions::new();
        options.set_color_output(gif::ColorOutput::RGBA);
        let mut reader = options.read_info(Cursor::new(&file)).expect("it is GIF");
        let size = [reader.width(), reader.height()].map(usize::from);
        let (mut shown, mut count, mut hundredths) = (Picture::blank(size), 0, 0);
        let mut drawings = film.drawings();
        while let Some(frame) = reader.read_next_frame().expect("it is whole") {
            let place = [frame.left, frame.top, frame.width].map(usize::from);
            shown.lay(place, frame.buffer.as_chunks::<4>().0);
            let drawing = drawings.next().expect("a drawing for each picture");
            let expected = Picture::of_png(&drawing.png(DPI).expect("a picture"));
            let (most, square) = shown.off(&expected);
            assert!(most <= 40 && square < 1.0, "{name}: picture {count} is off by {most}, {square:.2}");
            let ground = drawing.style.background();
            assert_eq!(shown.pixels[0], [ground.red, ground.green, ground.blue, 255], "{name}: the paper");
            count += 1;
            hundredths += u32::from(frame.delay);
        }
        assert_eq!((count, hundredths, reader.repeat()), (24, 160, gif::Repeat::Infinite), "{name}");
        assert!(drawings.next().is_none());
    }
}

/// By label: where it is.
fn places(drawing: &Drawing) -> BTreeMap<&str, Point> {
    let place = |mark: &'_ Mark| match (&mark.id, &mark.shape) {
        (Some(_), Shape::Text(text)) if mark.pen == Pen::Label => Some(text.ink_box().center()),
        _ => None,
    };
    drawing.marks.iter().filter_map(|mark| Some((mark.id.as_deref()?, place(mark)?))).collect()
}

/// What is restless in a film.
#[derive(Debug, Default)]
struct Restless {
    /// All names of all pictures.
    names: usize,
    /// Those that are elsewhere beside what they name: they move by 4 mm further, or another way, than they did before.
    hops: usize,
    /// Those that hop or come again within a third of a second.
    flickers: usize,
    /// Those that the picture before has not.
    new: usize,
    /// Enlarged details that the picture before has not.
    details: usize,
}

fn restless(film: &Film) -> Restless {
    let mut drawings: Vec<Drawing> = film.drawings().collect();
    // Over the place where it begins again.
    drawings.extend_from_within(..10);
    let places: Vec<_> = drawings.iter().map(places).collect();
    let mut found = Restless::default();
    let mut last: BTreeMap<&str, usize> = BTreeMap::new();
    for (number, three) in places.windows(3).enumerate() {
        for (&id, now) in &three[2] {
            found.names += 1;
            let is_new = !three[1].contains_key(id);
            let [a, b] = [0, 1].map(|index| three[index].get(id).copied().unwrap_or(*now));
            if !is_new && ((*now - b) - (b - a)).hypot() <= 4.0 {
                continue;
            }
            match last.insert(id, number) {
                // The same hop, seen from behind.
                Some(before) if before + 1 == number && !is_new => continue,
                Some(before) if before + 7 > number => found.flickers += 1,
                _ => {}
            }
            match (is_new, id.ends_with("-factor")) {
                (true, true) => found.details += 1,
                (true, false) => found.new += 1,
                (false, _) => found.hops += 1,
            }
        }
    }
    found
}

/// Names do not flicker: of a hundred hardly one is elsewhere or new in a picture.
#[test]
fn names_stay_where_they_were() {
    let quick = ["templates/four-bar", "templates/slider-crank", "templates/whitworth"];
    let usual =
        ["examples/figure-2", "tests/lecture/jansen", "tests/lecture/scissor-cylinder", "tests/lecture/excavator"];
    let more = if Size::asked() >= Size::Usual { usual.as_slice() } else { &[] };
    for name in quick.iter().chain(more) {
        let own = scene(&format!("{name}.json"));
        let film = Film::new(&own, None, Timing::default()).expect("it moves");
        let found = restless(&film);
        eprintln!("{name}: {found:?}");
        assert!(found.names > 500 && found.flickers == 0 && found.details == 0, "{name}: {found:?}");
        assert!(50 * (found.hops + found.new) < 3 * found.names, "{name}: {found:?}");
    }
}
