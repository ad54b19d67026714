//! The construction replayed act by act: without errors it is a third route to every number, with them it gives the bands of honest
//! hand drawings, which simulated drawings keep to.

use kinegon::Solution;
use kinegon::construction::{
    Change, Construction, Disturbance, ErrorUnit, NumberId, Operation, OperationKind, Product, ProductKind, Tolerance,
};
use kinegon::quantity::{
    Band, Quantity, QuantityRequest, Reading, Sense, Unread, read_by_hand, readable_names, step_names,
};
use kinegon::{PerSheet, Sheet};
use support::exact::exceeds;
use support::files;
use support::random::Random;
use support::stages::solved;

/// Every starting scene and the examples.
fn scenes() -> Vec<(String, String)> {
    let mut scenes = files::templates();
    scenes.extend(files::scenes("examples"));
    scenes
}

/// A scene as it is drawn by hand: what is read from it, and the values of the numeric solution.
struct Sheets {
    solution: Solution,
    asked: Vec<QuantityRequest>,
    drawn: Construction,
    readings: Vec<Result<Reading, Unread>>,
}

impl Sheets {
    fn of(text: &str) -> Sheets {
        let solution = solved(text).expect("a good scene");
        let mechanism = &solution.mechanism;
        let mut names = readable_names(&solution);
        let own = step_names(&solution.construction).into_iter();
        let own: Vec<String> = own.filter(|name| !names.contains(name)).collect();
        names.extend(own);
        let points = mechanism.points.clone();
        names.extend(points.iter().flat_map(|p| [format!("x({p})"), format!("y({p})")]));
        let asked = names.iter().map(|name| QuantityRequest::new(name, mechanism));
        let asked: Vec<QuantityRequest> = asked.map(|a| a.expect("a known name")).collect();
        let (drawn, readings) = read_by_hand(&solution, &asked);
        Sheets { asked, drawn, readings, solution }
    }

    fn scales(&self) -> PerSheet<f64> {
        let scales = self.solution.scales();
        // Nothing is drawn on a sheet that no panel shows.
        PerSheet::from_fn(|sheet| scales[sheet].filter(|_| Sheet::USUAL.contains(&sheet)).unwrap_or(1.0))
    }

    /// The number from which a quantity is read.
    fn number(&self, name: &str) -> NumberId {
        let index = self.asked.iter().position(|asked| asked.name() == name).expect("it is asked for");
        self.readings[index].as_ref().expect("it is read").number
    }

    fn truth(&self, asked: &QuantityRequest) -> f64 {
        let name = asked.name();
        match self.solution.quantity(name).unwrap_or_else(|error| panic!("{error}")) {
            Quantity::Number(value) => value,
            Quantity::Vector(_) => panic!("{name} is a vector"),
        }
    }

    /// The largest magnitude of a quantity's kind, by which errors of nearly vanishing ones are measured.
    fn largest(&self, asked: &QuantityRequest) -> f64 {
        let same = self.asked.iter().zip(&self.readings);
        let same = same.filter(|(a, r)| a.kind() == asked.kind() && r.is_ok());
        same.map(|(a, _)| self.truth(a).abs()).fold(0.0, f64::max)
    }
}

#[test]
fn without_errors_it_is_a_third_route_to_every_number() {
    let mut wrong = Vec::new();
    let mut compared = 0;
    for (scene, text) in scenes() {
        compared += compare(&scene, &Sheets::of(&text), 1e-9, &mut wrong);
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(compared > 900, "only {compared} numbers compared");
}

/// Groups of every class with revolute and prismatic joints in every pattern, on links of any motion.
#[test]
fn of_every_pattern_of_joints_too() {
    let mut wrong = Vec::new();
    let mut compared = 0;
    for set in ["class4", "class4_prismatic", "dyads", "triads"] {
        let text = files::read(&format!("tests/reference/{set}.jsonl"));
        for (index, line) in text.lines().enumerate() {
            let sheets = Sheets::of(files::scene_text(line));
            let agreement = &sheets.solution.construction.agreement;
            // The two routes must meet where the third is to meet them.
            let worst = agreement.iter().map(|a| a.map(|a| a.allowed));
            let Some(worst) = worst.reduce(|a, b| Some(a?.max(b?))).flatten() else {
                continue;
            };
            let scene = format!("{set} {index}");
            compared += compare(&scene, &sheets, 1e-9 + 100.0 * worst, &mut wrong);
        }
    }
    let mut others = files::scenes("tests/driven_sliders");
    let worked = files::list("tests/worked").into_iter();
    for case in worked.filter(|file| !file.ends_with(".md")) {
        let own = files::scenes(&format!("tests/worked/{case}")).into_iter();
        let own = own.filter(|(file, _)| file != "expect");
        others.extend(own.map(|(file, text)| (format!("{case} {file}"), text)));
    }
    for (scene, text) in others {
        let sheets = Sheets::of(&text);
        // Higher classes have no construction.
        let agreement = &sheets.solution.construction.agreement;
        if agreement.iter().all(Option::is_some) {
            compared += compare(&scene, &sheets, 1e-9, &mut wrong);
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(compared > 5000, "only {compared} numbers compared");
}

/// Compares every number and every plan point of the undisturbed replay with the plans and the numeric solution; how many there were.
fn compare(scene: &str, sheets: &Sheets, within: f64, wrong: &mut Vec<String>) -> usize {
    let scales = PerSheet::from_fn(|_| 1.0);
    let values = sheets.drawn.run(scales, &[]);
    let mut compared = 0;
    for (asked, reading) in sheets.asked.iter().zip(&sheets.readings) {
        let name = asked.name();
        let reading = match reading {
            Ok(reading) => reading,
            // A given rate, a point at rest, the angle of a block.
            Err(Unread::Given | Unread::NotDrawn) => continue,
            Err(why) => {
                wrong.push(format!("{scene}: {name}: {why}"));
                continue;
            }
        };
        let truth = sheets.truth(asked);
        // A vector of nothing has no direction.
        let size = name.strip_suffix(".angle").map(|n| format!("{n}.size"));
        let size = size.and_then(|size| sheets.asked.iter().find(|a| a.name() == size));
        if size.is_some_and(|size| sheets.truth(size) < 1e-9 * sheets.largest(size)) {
            continue;
        }
        let off = if reading.sense == Sense::Magnitude {
            reading.value(&values) - truth.abs()
        } else {
            reading.difference(&values, truth)
        };
        let scale = if reading.sense == Sense::Angle { 180.0 } else { sheets.largest(asked) };
        compared += 1;
        if exceeds(off.abs(), within * scale) {
            let value = reading.value(&values);
            wrong.push(format!("{scene}: {name} = {value}, not {truth}"));
        }
    }
    for plan in sheets.solution.construction.plans() {
        let size = plan.points.values().map(|p| p.vector.norm());
        let size = size.fold(0.0, f64::max);
        let sheet = plan.sheet();
        for (name, point) in &plan.points {
            let Some(place) = sheets.drawn.place(sheet, name) else {
                wrong.push(format!("{scene}: no {name} in the {}", sheet.name()));
                continue;
            };
            let off = (values.place(place) - point.vector).norm();
            if exceeds(off, within * size) {
                let sheet = sheet.name();
                wrong.push(format!("{scene}: {name} in the {sheet} is off by {off}"));
            }
        }
    }
    compared
}

/// The share of simulated drawings inside each band is at least 95 %, and no band is wider than twice what 95 % keep to.
#[test]
fn honest_drawings_keep_to_the_bands() {
    const DRAWINGS: usize = 4000;
    let tolerance = Tolerance::default();
    let mut random = Random(20_111_121);
    let mut wrong = Vec::new();
    let (mut firm, mut rough, mut liars) = (0, 0, 0);
    for (scene, text) in scenes() {
        let sheets = Sheets::of(&text);
        let scales = sheets.scales();
        let there = sheets.asked.iter().zip(&sheets.readings);
        let there: Vec<(&QuantityRequest, Reading)> =
            there.filter_map(|(asked, reading)| Some((asked, *reading.as_ref().ok()?))).collect();
        let readings: Vec<Reading> = there.iter().map(|t| t.1).collect();
        let bands = sheets.drawn.bands(scales, &tolerance, &readings);
        let exact = sheets.drawn.run(scales, &[]);
        let errors: Vec<(usize, usize, ErrorUnit)> = sheets
            .drawn
            .operations
            .iter()
            .enumerate()
            .flat_map(|(index, operation)| {
                let errors = operation.kind.errors().iter().enumerate();
                errors.map(move |(which, error)| (index, which, *error))
            })
            .collect();
        let mut off = vec![Vec::with_capacity(DRAWINGS); readings.len()];
        for _ in 0..DRAWINGS {
            let disturbances: Vec<Disturbance> = errors
                .iter()
                .map(|&(operation, which, error)| {
                    let size = error.limit(&tolerance) * random.within(1.0);
                    Disturbance { operation, change: Change::Error(which, size) }
                })
                .collect();
            let values = sheets.drawn.run(scales, &disturbances);
            for (reading, off) in readings.iter().zip(&mut off) {
                let exact = exact.number(reading.number);
                off.push(reading.difference(&values, exact).abs());
            }
        }
        for (((asked, _), band), mut off) in there.iter().zip(&bands).zip(off) {
            let Band { value, band, is_rough } = *band;
            off.sort_by(f64::total_cmp);
            let inside = off.partition_point(|x| *x <= band) as f64 / DRAWINGS as f64;
            let quantile = off[DRAWINGS * 95 / 100];
            if is_rough {
                rough += 1;
                liars += usize::from(inside < 0.95);
                continue;
            }
            firm += 1;
            if inside < 0.95 || band > 2.0 * quantile {
                wrong.push(format!(
                    "{scene}: {} = {value} ± {band}: {inside} of the drawings inside, {:.2} of the quantile",
                    asked.name(),
                    band / quantile
                ));
            }
        }
    }
    assert!(liars > 0, "nothing here needs to be called rough");
    assert!(20 * rough < firm, "{rough} rough bands beside {firm}");
    assert!(wrong.is_empty(), "{} of {firm} ({rough} rough):\n{}", wrong.len(), wrong.join("\n"));
}

/// The one given velocity laid off the wrong way round turns every velocity and every ω round; what is squared stays.
#[test]
fn a_vector_laid_off_backwards_propagates() {
    let sheets = Sheets::of(&files::read("examples/figure-2.json"));
    let scales = PerSheet::from_fn(|_| 1.0);
    let drawn = &sheets.drawn;
    let b = drawn.place(Sheet::Velocity, "b").expect("v_B is there");
    let laid = |operation: &Operation| operation.kind.place() == Some(b);
    let operation = drawn.operations.iter().position(laid).expect("it is laid off");
    let mut backwards = drawn.operations[operation].kind.clone();
    if let OperationKind::LayOff { along, .. } = &mut backwards {
        *along = along.turned(2);
    }
    let mistake = Disturbance { operation, change: Change::Instead(backwards.into()) };
    let right = drawn.run(scales, &[]);
    let wrong = drawn.run(scales, &[mistake]);
    for (name, sign) in
        [("omega(2)", -1.0), ("omega(4)", -1.0), ("v_r(3/2)", -1.0), ("alpha(4)", 1.0), ("a_r(3/2)", 1.0)]
    {
        let number = sheets.number(name);
        let [right, wrong] = [&right, &wrong].map(|values| values.number(number));
        assert!((wrong - sign * right).abs() < 1e-9 * right.abs(), "{name}: {wrong}, not {right}");
    }
}

/// A crank and slotted lever whose Coriolis acceleration is forgotten: the lever's α is off by 2 ω v_r / L.
#[test]
fn a_forgotten_coriolis_part_propagates() {
    let sheets = Sheets::of(&files::read("templates/slotted-lever.json"));
    let scales = PerSheet::from_fn(|_| 1.0);
    let drawn = &sheets.drawn;
    let coriolis = |p: &Product| p.kind == ProductKind::Coriolis;
    let is_twice = |operation: &Operation| match &operation.kind {
        OperationKind::Compute { sum, .. } => sum.iter().any(coriolis),
        _ => false,
    };
    let operation = drawn.operations.iter().position(is_twice).expect("2 ω v_r is computed");
    let mut forgotten = drawn.operations[operation].kind.clone();
    if let OperationKind::Compute { sum, .. } = &mut forgotten {
        sum.retain(|p| !coriolis(p));
    }
    let mistake = Disturbance { operation, change: Change::Instead(forgotten.into()) };
    let alpha = sheets.number("alpha(3)");
    let [right, wrong] = [vec![], vec![mistake]].map(|m| drawn.run(scales, &m).number(alpha));
    let Solution { mechanism, pose, motion, .. } = &sheets.solution;
    let lever = mechanism.link("3").expect("the lever");
    let [b, d] = ["B", "D"].map(|p| mechanism.point(p).expect("a joint"));
    let slide = motion.slides[0].velocity;
    let missing = 2.0 * motion.body(lever).omega * slide / pose.arm(d, b).norm();
    assert!(((wrong - right).abs() / missing.abs() - 1.0).abs() < 1e-9, "{right} {wrong} {missing}");
}
