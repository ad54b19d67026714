//! The camera of `tests/support/camera`, held against mathematics: truth that is wrong would judge readers wrongly.

use kinegon::quantity::Quantity;
use resvg::usvg::Options;
use support::camera::Photograph;
use support::camera::chance::{KINDS, Kind};
use support::camera::desk::{Desk, Surroundings, Top};
use support::camera::drawn::{Panel, drawn};
use support::camera::file::{Storage, jpeg};
use support::camera::lens::{Lens, Pose, View};
use support::camera::light::Light;
use support::camera::page::Page;
use support::camera::sheet::{begun, with_markers};
use support::camera::surface::{Shape, Surface};
use support::camera::take::{Exposure, Scene};
use support::files;
use support::photographs::decoded;
use support::random::Random;
use support::students::hand::RIGHT;
use support::students::script::kinds;
use support::students::sheet::ends_of;
use support::students::task::Task;

/// A piece of paper as large in its picture as a sheet is in one of 12 megapixels, about 11 pixels per mm.
const PIECE: [f64; 2] = [80.0, 60.0];
const SIZE: [usize; 2] = [960, 720];
/// How far an edge may be from where it is projected, in pixels.
const EDGE: f64 = 0.02;

fn plain(turn: f64, tilt: f64, radial: [f64; 2], sagitta: f64) -> (Shape, Pose, Lens) {
    let shape = Shape { sagitta, axis: 0.3, is_hollow: true, ..Shape::default() };
    let pose = Pose { turn, tilt, about: 0.7, fill: 0.93, shift: [0.3, -0.2] };
    let lens = Lens { focal_mm: 26.0, off_centre: [0.008, -0.006], radial, tangential: [4e-4, -3e-4] };
    (shape, pose, lens)
}

fn views() -> Vec<View> {
    let all = [
        plain(0.0, 0.0, [0.0, 0.0], 0.0),
        plain(0.02, 0.1, [0.02, -0.01], 0.0),
        plain(0.3, 0.4, [-0.05, 0.03], 0.0),
        plain(-0.15, 0.6, [0.06, 0.02], 0.6),
        plain(3.0, 0.3, [-0.06, -0.03], 2.0),
    ];
    all.map(|(shape, pose, lens)| View::new(PIECE, &shape, &pose, &lens, SIZE)).into()
}

/// The light of a page in an even light, without a sensor.
fn exposed(view: &View, page: &Page) -> Exposure {
    let desk = Desk { top: Top::Plain, colour: [0.0; 3], grain: 0.0, things: Vec::new() };
    let light =
        Light { ratio: 1.0, from: 0.0, cast: [1.0; 3], exposure: 1.0, vignette: 0.0, shadows: Vec::new(), glare: None };
    let around = Surroundings::new(&desk, 1);
    Scene { view, page: Some(page), mm: PIECE, around: &around, light: &light, paper: [1.0; 3] }.expose()
}

/// Where the image of a straight line of the page, given by both ends, has a coordinate (0: x, 1: y): the other one.
fn crossing(view: &View, ends: [[f64; 2]; 2], coordinate: usize, wanted: f64) -> f64 {
    let at = |t: f64| view.pixel([0, 1].map(|i| ends[0][i] + t * (ends[1][i] - ends[0][i])));
    let (mut low, mut high) = (0.0, 1.0);
    let is_rising = at(1.0)[coordinate] > at(0.0)[coordinate];
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if (at(middle)[coordinate] < wanted) == is_rising { low = middle } else { high = middle }
    }
    at(low)[1 - coordinate]
}

/// How far a black page's edge (along x: 0, y: 1) is from its place in the picture, at most and in the mean.
///
/// The light of a row of pixels across an edge tells where that is, whatever the blur.
fn edge_errors(view: &View, exposure: &Exposure, along: usize, at: f64) -> (f64, f64, usize) {
    let ends = [8.0, PIECE[along] - 8.0].map(|s| if along == 0 { [s, at] } else { [at, s] });
    let (from, to) = (view.pixel(ends[0]), view.pixel(ends[1]));
    // Across which coordinate of the picture the edge runs, and which side is black.
    let picture = usize::from((to[1] - from[1]).abs() > (to[0] - from[0]).abs());
    let middle = [0, 1].map(|i| f64::midpoint(ends[0][i], ends[1][i]));
    let mut beyond = middle;
    beyond[1 - along] += 1.0;
    let is_black_after = view.pixel(beyond)[1 - picture] > view.pixel(middle)[1 - picture];
    let (low, high) = (from[picture].min(to[picture]) as usize + 2, from[picture].max(to[picture]) as usize - 2);
    let (mut largest, mut sum) = (0.0_f64, 0.0);
    for k in low..high {
        let place = crossing(view, ends, picture, k as f64 + 0.5);
        let start = place as usize - 9;
        let light = (start..start + 18).map(|other| {
            let [x, y] = if picture == 0 { [k, other] } else { [other, k] };
            f64::from(exposure.light[y * SIZE[0] + x])
        });
        let white: f64 = light.sum();
        let seen = if is_black_after { start as f64 + white } else { start as f64 + 18.0 - white };
        largest = largest.max((seen - place).abs());
        sum += seen - place;
    }
    (largest, sum / (high - low) as f64, high - low)
}

/// A page that is black from a place on, to the right (1) or downwards (0), each pixel by its exact share.
fn half_black(along: usize, at: f64, per_mm: usize) -> Page {
    let [width, height] = PIECE.map(|mm| (mm * per_mm as f64) as usize);
    let value = |k: usize| {
        let position = if along == 1 { k % width } else { k / width };
        (255.0 * (at * per_mm as f64 - position as f64).clamp(0.0, 1.0)).round() as u8
    };
    Page::raster(PIECE, per_mm, (0..width * height).map(value).collect())
}

/// Black edges in each view of the camera.
const EDGES: usize = 4;

#[test]
#[ignore = "takes long"]
fn edges_are_where_they_are_projected() {
    let mut rows = 0;
    for (k, view) in views().iter().enumerate() {
        let all = [(1, 31.37), (0, 22.91), (1, 50.0), (0, 40.77)];
        for (along, at) in all.into_iter().cycle().skip(2 * k).take(EDGES) {
            for per_mm in [24, 48] {
                let exposure = exposed(view, &half_black(along, at, per_mm));
                let (largest, mean, count) = edge_errors(view, &exposure, along, at);
                println!("view {k}, edge {along} at {at}, {per_mm} per mm: largest {largest:.4}, mean {mean:.5}");
                assert!(largest < EDGE, "view {k}, edge {along} at {at}: {largest} pixels");
                assert!(mean.abs() < EDGE / 2.0, "view {k}, edge {along} at {at}: {mean} pixels in the mean");
                rows += count;
            }
        }
    }
    assert!(rows > 1250 * EDGES * 2, "only {rows} rows");
}

/// Shapes of an SVG are as exact: this is how markers come into pictures.
#[test]
#[ignore = "takes long"]
fn edges_of_drawn_shapes_are_where_they_are_projected() {
    for (k, view) in views().iter().enumerate() {
        let all = [(1, 6.5 + 8.0 / 3.0), (0, 6.5 + 16.0 / 3.0), (1, 31.37), (0, 40.77)];
        for (along, at) in all.into_iter().cycle().skip(2 * k).take(EDGES) {
            let shape = if along == 1 { format!("M{at} 0h99v99h-99z") } else { format!("M0 {at}h99v99h-99z") };
            let svg = begun(PIECE) + &format!("<path d='{shape}'/></svg>");
            let page = Page::draw(&svg, PIECE, 24, &Options::default()).finished();
            let (largest, mean, _) = edge_errors(view, &exposed(view, &page), along, at);
            println!("view {k}, edge {along} at {at}: largest {largest:.4}, mean {mean:.5}");
            // Markers' edges lie between pixels; others the rasteriser places to an eighth of one.
            let allowed = if (24.0 * at).fract() < 1e-6 { EDGE } else { 1.5 * EDGE };
            assert!(largest < allowed, "view {k}, edge {along} at {at}: {largest} pixels");
        }
    }
}

#[test]
fn paper_is_bent_and_not_stretched() {
    let page = [297.0, 210.0];
    let mut random = Random(5);
    for k in 0..40 {
        let crease = (k % 2 == 0).then(|| [random.within(40.0), random.within(0.2)]);
        let (sagitta, axis) = (random.between(0.0, 10.0), random.angle());
        let shape = Shape { sagitta, axis, is_hollow: k % 3 == 0, crease, ear: None };
        let surface = Surface::new(page, &shape);
        for _ in 0..20 {
            let mm = [random.unit() * page[0], random.unit() * page[1]];
            let step = 1e-3;
            let at = surface.place(mm);
            let [x, y] = [[mm[0] + step, mm[1]], [mm[0], mm[1] + step]].map(|mm| {
                let place = surface.place(mm);
                [0, 1, 2].map(|i| (place[i] - at[i]) / step)
            });
            let dot = |a: [f64; 3], b: [f64; 3]| (0..3).map(|i| a[i] * b[i]).sum::<f64>();
            let errors = [dot(x, x) - 1.0, dot(y, y) - 1.0, dot(x, y)];
            // Differences over a bend of 6 mm are chords.
            assert!(errors.iter().all(|error| error.abs() < 1e-6), "{shape:?} at {mm:?}: {errors:?}");
            assert!(at[2] < 0.05, "{shape:?} at {mm:?} lies {} mm under the desk", at[2]);
        }
        if crease.is_none() {
            let (sin, cos) = libm::sincos(axis);
            let half = (page[0] * sin.abs() + page[1] * cos.abs()) / 2.0;
            let height = |u: f64| -surface.place([page[0] / 2.0 - u * sin, page[1] / 2.0 + u * cos])[2];
            let (middle, ends) = (height(0.0), [height(-half), height(half)]);
            assert!((ends[0] - ends[1]).abs() < 1e-9, "{shape:?}: its ends are not equally high");
            let sense = if shape.is_hollow { 1.0 } else { -1.0 };
            assert!(((ends[0] - middle) * sense - sagitta).abs() < 1e-9, "{shape:?}: {middle} and {ends:?}");
        }
    }
}

/// A pinhole keeps the cross ratio of four points on a line, whatever the pose.
#[test]
fn a_pinhole_keeps_cross_ratios() {
    let mut random = Random(6);
    for _ in 0..50 {
        let pose = Pose {
            turn: random.angle(),
            tilt: random.between(0.0, 0.8),
            about: random.angle(),
            fill: random.between(0.5, 0.95),
            shift: [random.within(0.9), random.within(0.9)],
        };
        let lens = Lens {
            focal_mm: random.between(24.0, 35.0),
            off_centre: [0.01, 0.0],
            radial: [0.0; 2],
            tangential: [0.0; 2],
        };
        let view = View::new(PIECE, &Shape::default(), &pose, &lens, SIZE);
        let (a, b) = (random.place().map(|x| 30.0 + 25.0 * x), random.place().map(|x| 30.0 + 25.0 * x));
        let pixels = [0.0, 0.3, 0.55, 1.0].map(|t| view.pixel([0, 1].map(|i| a[i] + t * (b[i] - a[i]))));
        let apart = |i: usize, j: usize| libm::hypot(pixels[i][0] - pixels[j][0], pixels[i][1] - pixels[j][1]);
        let ratio = apart(0, 2) * apart(1, 3) / (apart(1, 2) * apart(0, 3));
        assert!((ratio - 0.55 * 0.7 / 0.25).abs() < 1e-9, "{pose:?}: {ratio}");
        let back = view.desk(view.desk_pixel(a));
        assert!((0..2).all(|i| (back[i] - a[i]).abs() < 1e-6), "{pose:?}: {back:?}, not {a:?}");
    }
}

#[test]
fn exif_turns_the_stored_picture_upright() {
    let size = [96, 64];
    let pixels: Vec<u8> =
        (0..size[0] * size[1]).flat_map(|k| [(2 * (k % size[0])) as u8, (3 * (k / size[0])) as u8, 100]).collect();
    let grey = |pixel: &[u8]| 0.299 * f64::from(pixel[0]) + 0.587 * f64::from(pixel[1]) + 0.114 * f64::from(pixel[2]);
    for orientation in 1..=8 {
        let storage = Storage { quality: 95, is_subsampled: orientation % 2 == 0, orientation: Some(orientation) };
        let read = decoded(&jpeg(&pixels, size, storage));
        assert_eq!([read.width(), read.height()], size, "orientation {orientation}");
        let off = read.grey().iter().zip(pixels.chunks(3)).map(|(read, pixel)| (f64::from(*read) - grey(pixel)).abs());
        let worst = off.fold(0.0, f64::max);
        assert!(worst < 8.0, "orientation {orientation}: {worst}");
    }
}

#[test]
fn pictures_of_a_kind_show_what_they_are_to_show() {
    let page = [297.0, 210.0];
    for kind in KINDS {
        for seed in 0..30 {
            let picture = Photograph::random(seed, kind, page);
            assert_eq!(picture, Photograph::random(seed, kind, page));
            let seen = picture.truth().markers().iter().filter(|seen| **seen).count();
            match kind {
                Kind::Hard => {}
                Kind::Cropped => assert!((4..8).contains(&seen), "seed {seed}: {seen} markers"),
                _ => assert_eq!(seen, 8, "{kind:?} {seed}"),
            }
            // The picture at another size shows the same.
            let (large, small) = (picture.truth(), picture.clone().with_edge(800).truth());
            let (a, b) = (large.pixel([50.0, 60.0]), small.pixel([50.0, 60.0]));
            let part = |pixel: [f64; 2], view: &View| pixel[0] / view.size[0] as f64;
            assert!((part(a, &large.view) - part(b, &small.view)).abs() < 2e-3, "{kind:?} {seed}");
        }
    }
}

/// White paper with black squares is bright with dark squares, in each of the picture's markers.
#[test]
fn a_picture_shows_its_markers() {
    let page = [297.0, 210.0];
    let svg = with_markers(page, "K1/A4L/1/00000000/V1:100:100/TEST", "");
    let drawn = Page::draw(&svg, page, 12, &Options::default()).printed(&[], 3);
    let picture = Photograph::random(4, Kind::Flat, page).with_edge(900);
    let shot = picture.take(Some(&drawn));
    let grey = |mm: [f64; 2]| {
        let [x, y] = shot.truth.pixel(mm).map(|x| x as usize);
        shot.pixels[3 * (y * shot.truth.view.size[0] + x) + 1]
    };
    let corners = support::camera::sheet::marker_corners(page);
    for [x, y] in corners {
        let (ring, beside) = (grey([x + 0.7, y + 4.0]), grey([x - 1.0, y + 4.0]));
        assert!(u32::from(ring) + 60 < u32::from(beside), "at {x}, {y}: {ring} and {beside}");
    }
}

/// A student without errors has all lengths of the form on the page.
#[test]
fn drawn_plans_have_the_lengths_of_the_form() {
    let mut lengths = 0;
    for kind in kinds() {
        let folder = if kind.starts_with("figure") { "examples" } else { "templates" };
        let task = Task::new(kind, &files::read(&format!("{folder}/{kind}.json"))).expect("a scene");
        let panels = [1, 2].map(|plan| {
            let mu = task.scheme.scales[plan] * 1.25;
            Panel { plan, pole: [120.0, 90.0 * plan as f64], mu: Some(mu), has_pole: true }
        });
        let drawing = drawn(&task, None, RIGHT, 1, &panels);
        assert!(drawing.mistakes.is_empty() && drawing.strokes.len() > 10, "{kind}");
        for name in &task.scheme.form {
            let Some((plan @ 1..=2, from, to)) = ends_of(name) else { continue };
            let at = |point: &str| drawing.place(plan, point).unwrap_or(panels[plan - 1].pole);
            let (a, b) = (at(from), at(to));
            let drawn = libm::hypot(a[0] - b[0], a[1] - b[1]) * task.scheme.scales[plan] * 1.25;
            let Ok(Quantity::Number(right)) = task.solution.quantity(name) else { panic!("{name} is no number") };
            assert!((drawn - right).abs() < 1e-6 * right.abs() + 1e-9, "{kind} {name}: {drawn}, not {right}");
            lengths += 1;
        }
    }
    assert!(lengths > 100, "only {lengths} lengths");
}
