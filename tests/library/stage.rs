//! The stage: one layout for all positions of a mechanism, and the places of its points on the sheet.

use kinegon::cycle::{Animation, OtherModes, Pull};
use kinegon::drawing::{Drawing, Handle, HeldLayout, Mark, Pane, Point, Positions, Rect, Shape, Steps, Vec2};
use kinegon::position::counted_poses;
use kinegon::{Sheet, Solution};
use std::collections::BTreeSet;
use support::faults::faults;
use support::files;
use support::stages::solved;
use support::survey::{KINDS, MOVED, TURN};

/// Scenes of all kinds with their names; quick runs take others in each test.
fn scenes(first: usize) -> Vec<(String, Solution)> {
    let folders = ["templates", "examples", "tests/lecture", "tests/driven_sliders"];
    let every = KINDS.now();
    let texts = folders.into_iter().flat_map(files::scenes).skip(first % every).step_by(every);
    texts.filter_map(|(name, text)| Some((name, solved(&text).ok()?))).collect()
}

/// The names of all marks but of those that tell what a panel has no room for.
fn ids(drawing: &Drawing) -> BTreeSet<String> {
    let ids = drawing.marks.iter().filter_map(|mark| mark.id.clone());
    ids.filter(|id| !id.ends_with("-cut") && !id.ends_with("-unlabelled")).collect()
}

/// Some positions on the way of the first drive.
fn positions(own: &Solution) -> Vec<Solution> {
    let Ok(mut pull) = Pull::new(own, None) else { return vec![own.clone()] };
    let start = pull.value();
    let step = if pull.drive().is_angle { 35.0 } else { 0.1 };
    let poses = (-2..=2).map(|k| pull.to_value(start + step * f64::from(k)).pose);
    poses.filter_map(|pose| own.moved(pose).ok()).collect()
}

/// The centre of the mark of that name.
fn centre(drawing: &Drawing, id: &str) -> Option<Point> {
    let mark = drawing.marks.iter().find(|mark| mark.id.as_deref() == Some(id))?;
    match mark.shape {
        Shape::Circle { center, .. } => Some(center),
        _ => None,
    }
}

#[test]
fn on_paper_the_own_position_is_the_file() {
    for (name, own) in scenes(0) {
        let held = HeldLayout::of_figure(&own, None, None).draw(&own, None);
        assert!(held.svg() == own.figure().svg(), "{name}: at rest");
        for (steps, file) in [(Steps::Fine, own.stepwise_figure()), (Steps::Coarse, own.coarse_figure())] {
            let held = HeldLayout::of_figure(&own, Some(steps), None).draw(&own, None);
            assert_eq!(held.steps, file.steps, "{name}");
            for step in [1, file.steps.len() / 2, file.steps.len()] {
                assert!(held.after_step(step).svg() == file.after_step(step).svg(), "{name}: at step {step}");
            }
        }
    }
}

/// A layout that eases over begins as one and ends as the other.
#[test]
fn a_layout_eases_over() {
    let own = solved(&files::read("templates/four-bar.json")).expect("it can be solved");
    let longer =
        solved(&files::read("templates/four-bar.json").replace("\"AB\": 60", "\"AB\": 50")).expect("it can be");
    let [before, after] = [&own, &longer].map(|one| HeldLayout::of_cycle(one, None, None, None));
    let bars = |layout: &HeldLayout| Sheet::USUAL.map(|sheet| layout.mu(sheet).expect("it has that panel"));
    let at = |share| bars(&after.eased_from(&before, share));
    assert_eq!([at(0.0), at(1.0)], [bars(&before), bars(&after)]);
    assert_eq!(after.eased_from(&before, 0.0).draw(&own, None).panels, before.draw(&own, None).panels);
    let ends = bars(&before).into_iter().zip(bars(&after));
    for (mid, (a, b)) in at(0.5).into_iter().zip(ends) {
        assert!((mid * mid - a * b).abs() < 1e-12 * a * b, "{a}, {mid}, {b}");
    }
}

#[test]
fn layout_and_scales_are_held() {
    for (name, own) in scenes(1) {
        for steps in [None, Some(Steps::Fine)] {
            let stage = HeldLayout::of_figure(&own, steps, None);
            let drawing = stage.draw(&own, None);
            let frames = |drawing: &Drawing| -> Vec<_> {
                stage.panels(drawing).into_iter().map(|panel| (panel.panel, panel.frame)).collect()
            };
            assert_eq!(frames(&drawing).len(), drawing.panels.len());
            for moved in positions(&own) {
                let moving = stage.draw(&moved, None);
                assert_eq!(frames(&moving), frames(&drawing), "{name}");
                let bars = |drawing: &Drawing| -> Vec<Shape> {
                    let legend = drawing.panels.iter().map(|(_, frame)| frame.y1).fold(0.0, f64::max);
                    let lines = drawing.marks.iter().filter(|mark| mark.since == 0 && mark.shape.bounds().y0 > legend);
                    lines.map(|mark| mark.shape.clone()).filter(|shape| matches!(shape, Shape::Line(..))).collect()
                };
                assert_eq!(bars(&moving), bars(&drawing), "{name}: bars of the scales");
            }
        }
    }
}

#[test]
fn handles_are_where_points_are_drawn() {
    let mut checked = 0;
    for (name, own) in scenes(2) {
        let stage = HeldLayout::of_figure(&own, None, None);
        for moved in positions(&own) {
            let drawing = stage.draw(&moved, None);
            let mut same = |handle: &Handle| {
                let id = format!("{}-point-{}", handle.panel.as_str(), handle.name);
                if let Some(at) = centre(&drawing, &id) {
                    assert!((at - handle.at).hypot() < 1e-9, "{name}: {id} at {at}, not {}", handle.at);
                    checked += 1;
                }
            };
            let size = kinegon::geometry::span(moved.pose.points.iter().copied());
            for handle in stage.handles(&moved) {
                same(&handle);
                let point = moved.mechanism.point(&handle.name).expect("it has that name");
                let back = stage.place(handle.at).expect("there is a scheme");
                assert!(
                    (back - moved.pose.point(point)).norm() < 1e-11 * size.max(back.coords.norm()),
                    "{name}: {back}"
                );
            }
            for handle in stage.plan_handles(&moved) {
                same(&handle);
                let plan = moved.construction.plan_on(handle.panel).expect("there is a plan");
                let back = stage.plan_place(&moved, handle.panel, handle.at).expect("there is a panel");
                let mu = stage.mu(handle.panel).expect("there is a scale");
                let off = back * mu - plan.points[&handle.name].vector;
                assert!(off.norm() <= 1e-9 * (mu + plan.points[&handle.name].vector.norm()), "{name}: {}", handle.name);
                assert_eq!(handle.is_fixed, handle.name == plan.order.pole());
            }
        }
    }
    assert!(checked > 2000 / KINDS.now(), "{checked}");
}

#[test]
fn other_modes_have_their_numbers() {
    let mut seen = 0;
    for (name, own) in scenes(0) {
        let modes = OtherModes::of(&own).unwrap_or_else(|error| panic!("{name}: {error}"));
        let all = counted_poses(&own.mechanism, &own.scene.near).expect("it has been assembled").poses;
        assert!(modes.own.is_some() || modes.has_more, "{name}");
        assert_eq!(modes.shown.len(), (all.len() - 1).min(OtherModes::MOST), "{name}");
        for (number, pose) in &modes.shown {
            assert_eq!(pose.points, all[number - 1].points, "{name}");
        }
        let stage = HeldLayout::of_figure(&own, None, Some(&modes));
        let ids = ids(&stage.draw(&own, Some(&modes)));
        for (number, _) in &modes.shown {
            assert!(ids.iter().any(|id| id.starts_with(&format!("scheme-mode-{number}-link-"))), "{name}: {ids:?}");
            seen += 1;
        }
        // In other positions they are those of the drive there.
        for moved in positions(&own) {
            let there = OtherModes::of(&moved).unwrap_or_else(|error| panic!("{name}: {error}"));
            assert!(there.own.is_some() || there.has_more, "{name}");
        }
    }
    assert!(seen > 40 / KINDS.now(), "{seen}");
}

/// By point with a name: where the name is from the point.
fn offsets(drawing: &Drawing) -> Vec<(String, Vec2)> {
    let offset = |mark: &Mark| {
        let (panel, name) = mark.id.as_deref()?.split_once("-label-")?;
        let at = centre(drawing, &format!("{panel}-point-{}", name.trim_end_matches('-')))?;
        Some((format!("{panel} {name}"), mark.shape.bounds().center() - at))
    };
    drawing.marks.iter().filter_map(offset).collect()
}

/// How many names are elsewhere beside their points than in the drawing before.
fn jumps(before: &Drawing, after: &Drawing) -> usize {
    let before = offsets(before);
    let is_elsewhere = |(name, offset): &(String, Vec2)| {
        let was = before.iter().find(|(other, _)| other == name);
        was.is_some_and(|(_, was)| (*offset - *was).hypot() > 2.0)
    };
    offsets(after).iter().filter(|offset| is_elsewhere(offset)).count()
}

#[test]
fn names_stay_while_a_hand_moves_the_mechanism() {
    let (mut held, mut free) = (0, 0);
    for name in ["templates/third-class", "templates/watt-1", "templates/stephenson-3", "tests/lecture/jansen"] {
        let own = solved(&files::read(&format!("{name}.json"))).expect("it can be solved");
        let mut pull = Pull::new(&own, None).expect("it can be moved");
        let mut stage = HeldLayout::of_figure(&own, None, None);
        let mut last = [stage.drag(&own, None, None), stage.draw(&own, None)];
        assert_eq!(last[0].marks, last[1].marks, "{name}");
        let start = pull.value();
        for k in 1..=MOVED.now() {
            let moved = own.moved(pull.to_value(start + 1.5 * f64::from(k)).pose).expect("it has a motion");
            let next = [stage.drag(&moved, None, None), stage.draw(&moved, None)];
            let differing: Vec<String> = ids(&next[0]).symmetric_difference(&ids(&next[1])).cloned().collect();
            // A name that has no place where it was is left out; drawn anew it may have one. So may the value of what is cut.
            let is_text = |id: &String| id.contains("-label-") || id.contains("-value-");
            assert!(differing.len() <= 2 && differing.iter().all(is_text), "{name}: {differing:?}");
            assert!(faults(&next[0]).len() <= faults(&next[1]).len(), "{name}: {:?}", faults(&next[0]));
            held += jumps(&last[0], &next[0]);
            free += jumps(&last[1], &next[1]);
            last = next;
        }
        // Only the words of the step that is seen are written.
        let mut stage = HeldLayout::of_figure(&own, Some(Steps::Fine), None);
        let step = stage.drag(&own, None, Some(9));
        let whole = stage.draw(&own, None).after_step(9);
        assert_eq!((step.marks, step.description), (whole.marks, whole.description), "{name}");
        let mut stage = HeldLayout::of_figure(&own, Some(Steps::Coarse), None);
        assert_eq!(stage.drag(&own, None, Some(2)).marks, stage.draw(&own, None).after_step(2).marks, "{name}");
    }
    assert!(2 * held < free, "{held} jumps, {free} without");
}

/// Over a turn nothing leaves its panel, and scales, panels and poles stand still, on paper as on a part of a screen.
#[test]
fn nothing_is_cut_and_poles_stand_still_over_a_turn() {
    let desk = Pane { width: 780.0, height: 590.0, letters: 14.0, words: true };
    let telephone = Pane { width: 378.0, height: 620.0, letters: 12.0, words: false };
    let panes = [(None, Some(Steps::Coarse)), (Some(desk), Some(Steps::Fine)), (Some(telephone), None)];
    let mut turns = 0;
    for (name, own) in scenes(1) {
        let Ok(animation) = Animation::new(&own, None, TURN.now()) else { continue };
        let positions = Positions::of(&own);
        for (pane, steps) in panes {
            let stage = HeldLayout::of_positions(&own, &positions, steps, None, pane);
            let seen = |solution: &Solution| {
                let drawing = stage.draw(solution, None);
                let panels = stage.panels(&drawing);
                let frames: Vec<Rect> = panels.iter().map(|panel| panel.frame).collect();
                let is_cut = panels.iter().any(|panel| panel.is_cut);
                assert!(!panels.iter().any(|panel| panel.is_cut && panel.panel == Sheet::Scheme), "{name}: the scheme");
                let poles = stage.plan_handles(solution).into_iter().filter(|handle| handle.is_fixed);
                (is_cut, frames, poles.map(|pole| pole.at).collect::<Vec<_>>())
            };
            let (_, frames, poles) = seen(&own);
            for position in &animation.positions {
                let (is_cut, now, held) = seen(position);
                assert!(!is_cut || !animation.is_round, "{name} on {pane:?}: cut");
                assert_eq!(now, frames, "{name}: the panels");
                let wander = held.iter().zip(&poles).map(|(now, own)| (*now - *own).hypot()).fold(0.0, f64::max);
                assert!(held.len() < poles.len() || wander < 1e-9, "{name}: a pole wanders by {wander} mm");
            }
            turns += usize::from(animation.is_round);
        }
    }
    assert!(turns > 10 / KINDS.now(), "{turns}");
}

/// At rest a plan is as large as its panel allows about its pole; from there nothing is cut while the mechanism moves, poles and
/// the mechanism stay, and after some pictures the scales are those of the whole cycle.
#[test]
fn plans_are_large_at_rest_and_ease_over_to_their_cycle() {
    let pane = Pane { width: 780.0, height: 590.0, letters: 14.0, words: true };
    let (mut larger, mut all) = (0, 0);
    for (name, own) in scenes(0) {
        let Ok(mut pull) = Pull::new(&own, None) else { continue };
        let positions = Positions::of(&own);
        let cycle = HeldLayout::of_positions(&own, &positions, None, None, Some(pane));
        let mut now = cycle.clone().at_rest(&own);
        let bars = |layout: &HeldLayout| Sheet::ALL.map(|sheet| layout.mu(sheet));
        let fixed = |layout: &HeldLayout, solution: &Solution| -> Vec<Point> {
            let poles = layout.plan_handles(solution).into_iter().filter(|handle| handle.is_fixed);
            poles.chain(layout.handles(solution)).map(|handle| handle.at).collect()
        };
        let frame = |panels: &[kinegon::drawing::HeldPanel], sheet| {
            panels.iter().find(|panel| panel.panel == sheet).map(|panel| panel.frame)
        };
        let drawing = now.draw(&own, None);
        let panels = now.panels(&drawing);
        assert!(panels.iter().all(|panel| !panel.is_cut), "{name}: cut at rest");
        for sheet in [Sheet::Velocity, Sheet::Acceleration] {
            let (Some(mu), Some(most), Some(frame)) = (now.mu(sheet), cycle.mu(sheet), frame(&panels, sheet)) else {
                continue;
            };
            all += 1;
            larger += usize::from(mu < 0.8 * most);
            // White for labels and the heading are all that is left beside it.
            let ends = now.plan_handles(&own).into_iter().filter(|end| end.panel == sheet);
            let left =
                |at: Point| (at.x - frame.x0).min(frame.x1 - at.x).min(at.y - frame.y0 - 17.0).min(frame.y1 - at.y);
            let least = ends.map(|end| left(end.at)).fold(f64::INFINITY, f64::min);
            assert!(mu >= most || mu <= 0.11 * most || least < 9.0, "{name}: {sheet:?} has {least} mm to its edge");
        }
        let start = pull.value();
        // A click on a slider goes far at once.
        let step = if pull.drive().is_angle { 37.0 } else { 0.05 * start.abs().max(1e-3) };
        for k in 1..=20 {
            let before = bars(&now);
            let Ok(moved) = own.moved(pull.to_value(start + step * f64::from(k)).pose) else { continue };
            now.in_motion(&moved);
            let drawing = now.drag(&moved, None, None);
            let panels = now.panels(&drawing);
            if panels.iter().any(|panel| panel.is_cut) {
                let whole = cycle.panels(&cycle.draw(&moved, None));
                let cut = panels.iter().zip(&whole).filter(|(now, whole)| now.is_cut && !whole.is_cut);
                assert_eq!(cut.count(), 0, "{name}: cut in picture {k}");
            }
            let finer = bars(&now).into_iter().zip(before).filter(|(now, before)| now < before);
            assert_eq!(finer.count(), 0, "{name}: {k}");
            let off = fixed(&now, &moved).into_iter().zip(fixed(&cycle, &moved)).map(|(a, b)| (a - b).hypot());
            assert!(off.fold(0.0, f64::max) < 1e-9, "{name}: poles and joints stay");
        }
        assert_eq!(bars(&now), bars(&cycle), "{name}");
    }
    assert!(2 * larger > all, "{larger} of {all} plans are larger at rest");
}

/// A vector of a swinging drive that runs off its panel has its size at its head, the speed of its point.
#[test]
fn what_runs_off_has_its_size_at_the_edge() {
    let pane = Pane { width: 780.0, height: 590.0, letters: 14.0, words: true };
    let mut seen = 0;
    for name in ["templates/hydraulic-boom", "tests/lecture/peau", "tests/lecture/trammel"] {
        let own = solved(&files::read(&format!("{name}.json"))).expect("it can be solved");
        let layout = HeldLayout::of_cycle(&own, None, None, Some(pane));
        let mut pull = Pull::new(&own, None).expect("it can be moved");
        let [low, high] = pull.ends().map(|end| end.expect("it swings").at);
        for share in [0.003, 0.01, 0.99, 0.997] {
            let moved = own.moved(pull.to_value(low + share * (high - low)).pose).expect("it has a motion");
            let drawing = layout.draw(&moved, None);
            let panels = layout.panels(&drawing);
            let velocities = panels.iter().find(|panel| panel.panel == Sheet::Velocity).expect("there is a plan");
            let ends = layout.plan_handles(&moved).into_iter().filter(|end| end.panel == Sheet::Velocity);
            for end in ends.filter(|end| !velocities.frame.contains(end.at)) {
                let called = moved.mechanism.points.iter().find(|point| point.to_lowercase() == end.name);
                let Some(point) = called.and_then(|called| moved.mechanism.point(called)) else { continue };
                let (link, _) = moved.mechanism.links().find(|(_, link)| link.has(point)).expect("a link has it");
                let speed = moved.motion.body(link).velocity_at(moved.pose.point(point)).norm();
                let sizes = drawing.marks.iter().filter(|mark| velocities.frame.contains(mark.shape.bounds().center()));
                let sizes = sizes.filter(|mark| mark.id.as_ref().is_some_and(|id| id.contains("-value-")));
                let texts = sizes.filter_map(|mark| match &mark.shape {
                    Shape::Text(text) => Some(text.text.content()),
                    _ => None,
                });
                let texts: Vec<String> = texts.collect();
                let is_near = |text: &String| {
                    let written = text.split("= ").last().and_then(|text| text.split(' ').next());
                    let number: Option<f64> = written.and_then(|number| number.parse().ok());
                    number.is_some_and(|number| (number - speed).abs() <= 0.006 * speed)
                };
                assert!(texts.iter().any(is_near), "{name} at {share}: {} has {speed}, not {texts:?}", end.name);
                seen += 1;
            }
        }
    }
    assert!(seen > 4, "{seen}");
}

/// On a surface wider than high the scheme stands beside the plan in focus, not above it.
#[test]
fn the_companion_stands_beside() {
    let pane = Pane { width: 780.0, height: 590.0, letters: 14.0, words: true };
    for (name, mut own) in scenes(2) {
        own.scene.figure.focus = Some(Sheet::Velocity);
        let layout = HeldLayout::of_cycle(&own, None, None, Some(pane));
        let frames: Vec<Rect> = layout.panels(&layout.draw(&own, None)).iter().map(|panel| panel.frame).collect();
        if let [scheme, plan] = frames.as_slice() {
            assert!(scheme.x1 < plan.x0 && scheme.y0 == plan.y0, "{name}: {frames:?}");
        }
    }
}

/// Words in a corner stay in their panel, also where that is narrower than they are.
#[test]
fn words_in_a_corner_fit_a_telephone() {
    let mut scene: serde_json::Value = serde_json::from_str(&files::read("templates/watt-1.json")).expect("JSON");
    scene["units"]["force"] = "N".into();
    scene["forces"] = serde_json::json!([{ "on": "5", "at": "G", "force": [0, -100] }]);
    scene["figure"]["panels"] = serde_json::json!(["scheme", "velocity", "acceleration", "forces"]);
    let own = solved(&scene.to_string()).expect("it can be solved");
    let telephone = Pane { width: 352.0, height: 190.0, letters: 12.0, words: false };
    let layout = HeldLayout::of_positions(&own, &Positions::of(&own), None, None, Some(telephone));
    let drawing = layout.draw(&own, None);
    let frames: Vec<Rect> = layout.panels(&drawing).iter().map(|panel| panel.frame).collect();
    let words = drawing.marks.iter().filter_map(|mark| match &mark.shape {
        Shape::Text(text) if format!("{:?}", text.text).contains("without a scale") => Some(text.ink_box()),
        _ => None,
    });
    let words: Vec<Rect> = words.collect();
    assert_eq!(words.len(), 1);
    assert!(frames.iter().any(|frame| frame.x0 <= words[0].x0 && words[0].x1 <= frame.x1), "{words:?} {frames:?}");
}

/// A press that carries only its weights for most of its turn: polygons of small forces are seen at rest, nothing of them is cut on the
/// way to the scale of the cycle, and then they are as in the cycle.
#[test]
fn small_forces_are_large_at_rest() {
    let mut scene: serde_json::Value = serde_json::from_str(&files::read("templates/slider-crank.json")).expect("JSON");
    scene["units"]["mass"] = "kg".into();
    scene["units"]["force"] = "N".into();
    scene["gravity"] = serde_json::json!([0, -9810]);
    scene["links"]["3"]["mass"] = 1.into();
    scene["links"]["3"]["center"] = "C".into();
    let table = serde_json::json!([[0, 0], [80, 0], [90, -40000], [120, -40000], [130, 0]]);
    let over = serde_json::json!({ "of": "angle(1)", "table": table });
    scene["forces"] = serde_json::json!([{ "on": "3", "at": "C", "force": [1, 0], "over": over }]);
    scene["figure"]["panels"] = serde_json::json!(["scheme", "forces"]);
    let own = solved(&scene.to_string()).expect("it can be solved");
    let pane = Pane { width: 780.0, height: 590.0, letters: 14.0, words: true };
    let cycle = HeldLayout::of_cycle(&own, None, None, Some(pane));
    let height = |drawing: &Drawing| {
        let sides =
            drawing.marks.iter().filter(|mark| mark.id.as_ref().is_some_and(|id| id.starts_with("forces-force-")));
        let arrows = sides.filter(|mark| matches!(mark.shape, Shape::Arrow { .. }));
        let all = arrows.map(|mark| mark.shape.bounds()).reduce(|all, one| all.union(one)).expect("there are forces");
        all.width().max(all.height())
    };
    let mut layout = cycle.clone().at_rest(&own);
    let (large, small) = (height(&layout.draw(&own, None)), height(&cycle.draw(&own, None)));
    assert!(large > 30.0 * small && large > 50.0, "{large} at rest, {small} in the cycle");
    let mut pull = Pull::new(&own, None).expect("it can be moved");
    let start = pull.value();
    for k in 1..=40 {
        let moved = own.moved(pull.to_value(start + f64::from(k)).pose).expect("it has a motion");
        layout.in_motion(&moved);
        let drawing = layout.draw(&moved, None);
        assert!(layout.panels(&drawing).iter().all(|panel| !panel.is_cut), "cut after {k} pictures");
        if k == 40 {
            assert_eq!(drawing.svg(), cycle.draw(&moved, None).svg());
        }
    }
}
