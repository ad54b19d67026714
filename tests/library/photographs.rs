//! Photographs of sheets, taken by the camera of `tests/support/camera`, which shares nothing with the reader: where points are on paper, what is refused, which points are proposed.

use kinegon::Sheet;
use kinegon::check::{self, PointVerdict, Proposal, common_scale};
use kinegon::drawing::markers::SheetCode;
use kinegon::photo::{self, Picture, Refusal};
use support::camera::Photograph;
use support::camera::chance::{KINDS, Kind};
use support::camera::drawn::drawn;
use support::camera::page::Page;
use support::camera::wrong::WRONGS;
use support::photographs::{Tally, by_lot, decoded, given, panels, photographed, tally};
use support::random::Random;
use support::students::hand::SKILLS;
use support::survey::{
    ANY_PIXELS, OTHER_THINGS, PLACE_KINDS, PLACES, PROPOSED, TAPPED_LESS, UNEVEN, WITHIN_BANDS, WRONGLY_PROPOSED,
    on_all_cores,
};

/// What photographs of one kind come to.
#[derive(Clone, Debug, Default)]
struct Found {
    photographs: usize,
    /// With all markers in sight.
    whole: usize,
    found: usize,
    /// Errors of places on paper, in mm, of sheets that were found.
    errors: Vec<f64>,
    covered: usize,
    refused: Vec<String>,
}

impl Found {
    fn rms(&self) -> f64 {
        libm::sqrt(self.errors.iter().map(|error| error * error).sum::<f64>() / self.errors.len().max(1) as f64)
    }

    fn join(&mut self, other: Found) {
        self.photographs += other.photographs;
        self.whole += other.whole;
        self.found += other.found;
        self.errors.extend(other.errors);
        self.covered += other.covered;
        self.refused.extend(other.refused);
    }

    fn part(&self, part: f64) -> f64 {
        let mut errors = self.errors.clone();
        errors.sort_by(f64::total_cmp);
        errors.get((part * errors.len() as f64) as usize).copied().unwrap_or(0.0)
    }
}

/// Photographs a sheet of an exercise and adds what is found.
fn photograph(kind: Kind, number: u64, edge: usize, all: &mut Found) {
    let Some(given) = given(number) else { return };
    let codes: Vec<SheetCode> = given.sheets.iter().map(|sheet| sheet.0.clone()).collect();
    let sheet = &given.sheets[number as usize % given.sheets.len()];
    let drawing = drawn(&given.task, None, SKILLS[1], number, &panels(&sheet.0));
    let shot = photographed(sheet, &drawing, &by_lot(sheet, kind, number, edge));
    let is_whole = shot.truth.markers().iter().all(|seen| *seen);
    all.photographs += 1;
    all.whole += usize::from(is_whole);
    match photo::read(&decoded(&shot.jpeg), || codes.clone()) {
        Ok(found) => {
            assert_eq!(found.code.text(), sheet.0.text(), "{kind:?} {number} is read as another sheet");
            all.found += usize::from(is_whole);
            let [width, height] = sheet.0.page.size_mm();
            for i in 0..8 {
                for j in 0..6 {
                    let mm = [18.0 + (width - 36.0) * f64::from(i) / 7.0, 18.0 + (height - 36.0) * f64::from(j) / 5.0];
                    if !shot.truth.sees(mm) {
                        continue;
                    }
                    let paper = found.paper(shot.truth.pixel(mm)).expect("it is on the sheet");
                    let error = libm::hypot(paper[0] - mm[0], paper[1] - mm[1]);
                    all.covered += usize::from(error <= found.band(mm));
                    all.errors.push(error);
                }
            }
        }
        Err(refusal) if is_whole => all.refused.push(format!("{kind:?} {number}: {refusal}")),
        Err(_) => {}
    }
}

/// The errors that were simulated for eight markers and a camera with distortion, in mm: root of the mean square, and the 95th percentile.
fn allowed(kind: Kind) -> Option<[f64; 2]> {
    match kind {
        Kind::Flat | Kind::Blurred => Some([0.07, 0.12]),
        Kind::Curl1 => Some([0.11, 0.25]),
        Kind::Curl3 | Kind::Curl6 => Some([0.32, 0.71]),
        Kind::Chat1600 => Some([0.08, 0.14]),
        Kind::Hard | Kind::Cropped => None,
    }
}

#[test]
fn places_on_paper_are_found() {
    let (count, edge) = PLACES.now();
    let mut all = Found::default();
    for kind in KINDS.into_iter().step_by(PLACE_KINDS.now()) {
        let mut own = Found::default();
        for seen in on_all_cores(count, |number, seen| photograph(kind, number + 1, edge, seen)) {
            own.join(seen);
        }
        let covered = own.covered as f64 / own.errors.len().max(1) as f64;
        println!(
            "{kind:?}: {} photographs, {} with all markers, {} of these found; rms {:.3} mm, 95 % {:.3} mm, largest {:.3} mm; within their bands {:.1} %; {:?}",
            own.photographs,
            own.whole,
            own.found,
            own.rms(),
            own.part(0.95),
            own.part(1.0 - 1e-9),
            100.0 * covered,
            own.refused
        );
        if let Some([rms, most]) = allowed(kind) {
            assert!(own.rms() <= rms && own.part(0.95) <= most, "{kind:?}: {:.3} {:.3}", own.rms(), own.part(0.95));
            assert!(covered >= WITHIN_BANDS.now(), "{kind:?}: only {covered:.3} are within their bands");
        }
        all.whole += own.whole;
        all.found += own.found;
        all.refused.extend(own.refused);
    }
    println!("{} of {} found", all.found, all.whole);
    assert!(all.found as f64 >= 0.99 * all.whole as f64, "{:?}", all.refused);
}

/// Largest residual of a sheet that is read, in mm (docs/photographs.md).
const EVEN: f64 = 0.18;

#[test]
fn uneven_and_blurred_sheets_are_refused() {
    let (count, edge) = UNEVEN.now();
    let (mut read, mut uneven, mut blurred, mut worst) = (0, 0, 0, 0.0_f64);
    for number in 1..=count {
        let Some(given) = given(number) else { continue };
        let codes: Vec<SheetCode> = given.sheets.iter().map(|sheet| sheet.0.clone()).collect();
        let sheet = &given.sheets[0];
        let drawing = drawn(&given.task, None, SKILLS[1], number, &panels(&sheet.0));
        let mut random = Random(number);
        let mut picture = by_lot(sheet, Kind::Flat, number, edge);
        if number % 2 == 0 {
            // Folded once, not through its middle, and with a corner up.
            picture.shape.crease = Some([random.between(20.0, 60.0), random.between(0.1, 0.4)]);
            picture.shape.ear = Some((random.below(4), 25.0, 0.4));
        } else {
            picture.sensor.motion[0] = random.between(0.002, 0.008) * edge as f64;
            picture.sensor.defocus = random.between(0.001, 0.002) * edge as f64;
        }
        match photo::read(&decoded(&photographed(sheet, &drawing, &picture).jpeg), || codes.clone()) {
            Ok(found) => {
                read += 1;
                worst = worst.max(found.residual());
            }
            Err(Refusal::NotEven(_) | Refusal::Bent(_)) => uneven += 1,
            Err(Refusal::Blurred(_) | Refusal::FewMarkers(_) | Refusal::NoCode) => blurred += 1,
            Err(other) => panic!("{number}: {other}"),
        }
    }
    println!("{read} read, with residuals up to {worst:.3} mm; {uneven} refused as not even, {blurred} as blurred");
    assert!(worst <= EVEN && uneven > 0 && blurred > 0, "{uneven} {blurred} {worst}");
}

#[test]
fn no_sheet_is_seen_in_other_things() {
    for number in 0..OTHER_THINGS.now() {
        let wrong = WRONGS[number as usize % WRONGS.len()];
        let mm = [297.0, 210.0];
        let page =
            wrong.svg(mm, &mut Random(number + 5)).map(|svg| Page::draw(&svg, mm, 12, &Default::default()).finished());
        let shot = Photograph::random(number, Kind::Hard, mm).with_edge(1400).take(page.as_ref());
        let read = photo::read(&decoded(&shot.jpeg), Vec::new);
        assert!(matches!(read, Err(Refusal::FewMarkers(_))), "{wrong:?} {number}: {read:?}");
    }
}

/// A picture of that size, with the brightness that a function gives.
fn made(width: usize, height: usize, grey: impl Fn(usize, usize) -> u8) -> Picture {
    let grey = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| grey(x, y)).collect();
    Picture::new(width, height, grey).expect("as many pixels")
}

#[test]
fn what_is_wrong_with_a_picture_is_told() {
    let given = given(8).expect("an exercise");
    let sheet = &given.sheets[0];
    let drawing = drawn(&given.task, None, SKILLS[1], 8, &panels(&sheet.0));
    let picture = decoded(&photographed(sheet, &drawing, &by_lot(sheet, Kind::Flat, 8, 1200)).jpeg);
    let (width, height) = (picture.width(), picture.height());
    let grey = |x: usize, y: usize| picture.grey()[y * width + x];
    assert!(photo::read(&picture, Vec::new).expect("a sheet").is_alone);
    let mirrored = made(width, height, |x, y| grey(width - 1 - x, y));
    assert_eq!(photo::read(&mirrored, Vec::new).expect_err("no sheet"), Refusal::Mirrored);
    for part in [0.35, 0.6] {
        let cut = made((part * width as f64) as usize, height, grey);
        assert_eq!(photo::read(&cut, Vec::new).expect_err("no whole sheet"), Refusal::CutOff, "{part}");
    }
    let two = made(2 * width, height, |x, y| grey(x % width, y));
    assert!(!photo::read(&two, Vec::new).expect("one of the sheets").is_alone);
}

/// Points that were found at these places, in mm, in place of (60, 0), (0, 80) and (−50, 30).
fn found_at(places: [[f64; 2]; 3]) -> Vec<Proposal> {
    let rights = [[60.0, 0.0], [0.0, 80.0], [-50.0, 30.0]];
    let found = |at| Some(check::Found { at, band: 0.3, verdict: PointVerdict::Off });
    let point =
        |(right, at)| Proposal { sheet: Sheet::Velocity, name: "b".into(), right, tolerance: 0.5, found: found(at) };
    rights.into_iter().zip(places).map(point).collect()
}

#[test]
fn a_sheet_that_was_printed_to_fit_is_told_by_its_points() {
    // 3 % larger, within 0.3 mm; a hand's errors; one point that is elsewhere.
    let larger = common_scale(&found_at([[61.9, 0.2], [-0.2, 82.4], [-51.6, 30.8]])).expect("a scale");
    assert!((larger - 1.03).abs() < 0.004, "{larger}");
    assert_eq!(common_scale(&found_at([[60.3, 0.2], [-0.2, 79.8], [-50.2, 30.1]])), None);
    assert_eq!(common_scale(&found_at([[61.9, 0.2], [-0.2, 82.4], [-40.0, 30.8]])), None);
}

#[test]
fn any_pixels_are_refused_or_read() {
    let mut random = Random(77);
    for number in 0..ANY_PIXELS.now() {
        let (width, height) = (random.below(400), random.below(400));
        let is_noise = number % 2 == 0;
        let shade = random.below(256) as u8;
        let grey = (0..width * height).map(|_| if is_noise { random.below(256) as u8 } else { shade }).collect();
        let picture = Picture::new(width, height, grey).expect("as many pixels");
        assert!(photo::read(&picture, Vec::new).is_err());
    }
}

#[test]
fn points_are_proposed_where_they_are() {
    let (count, edge) = PROPOSED.now();
    let mut all = Tally::default();
    for seen in on_all_cores(count, |number, seen| tally(number + 1, Kind::Flat, edge, seen)) {
        all.join(seen);
    }
    let points = (all.right + all.wrong + all.left).max(1) as f64;
    println!(
        "{} of {} photographs read; of {points} points {:.1} % are proposed right, {:.1} % wrong, {:.1} % left; {:.1} % of those proposed within their bands; {} misjudged, {} that cannot be told",
        all.read,
        all.photographs,
        100.0 * all.right as f64 / points,
        100.0 * all.wrong as f64 / points,
        100.0 * all.left as f64 / points,
        100.0 * all.covered as f64 / (all.right + all.wrong).max(1) as f64,
        all.misjudged,
        all.untold,
    );
    let [typed, proposed, tapped] = all.named;
    println!(
        "of {} sheets with mistakes in the drawing all are told from the typed form of {typed}, from proposed points of {proposed}, with the others tapped of {tapped}",
        all.planted
    );
    assert!(all.wrong as f64 <= WRONGLY_PROPOSED.now() * points, "{:?}", all.told);
    assert!(all.right as f64 >= 0.4 * points, "only {} of {points} points are proposed", all.right);
    assert!(all.misjudged as f64 <= 0.01 * points);
    // As often as from the typed form, within five of a hundred.
    assert!(tapped as f64 >= typed as f64 - TAPPED_LESS.now() * all.planted as f64);
}
