//! Coriolis accelerations in the plans: one notation, with the direction of the result's, and none on a guide that stands still.

use kinegon::construction::{Action, Plan, Teller, VectorOf, VectorPart};
use kinegon::geometry::Vector;
use kinegon::mechanism::{GROUND, SliderId};
use kinegon::{Order, Sheet, Solution};
use support::files;
use support::stages::solved;

/// Scenes with sliders on links that turn, on the ground, and driven ones between moving links, passed either way.
const SCENES: [&str; 8] = [
    "tests/lecture/shaper.json",
    "tests/lecture/whit.json",
    "tests/lecture/yoke.json",
    "templates/slotted-lever.json",
    "templates/hydraulic-boom.json",
    "templates/toggle-press.json",
    "templates/whitworth.json",
    "templates/dyad-rrp.json",
];

fn solution(scene: &str) -> Solution {
    solved(&files::read(scene)).unwrap_or_else(|error| panic!("{scene}: {error}"))
}

fn accelerations(solution: &Solution) -> &Plan {
    solution.construction.plan(Order::Acceleration).expect("accelerations were asked for")
}

/// 2 ω ẑ × v_r by the loop equations.
fn truth(solution: &Solution, slider: SliderId) -> Vector {
    let on = solution.mechanism.slider(slider).on;
    let (omega, guide) = (solution.motion.body(on).omega, solution.pose.guide(slider));
    let speed = solution.motion.slide(slider).velocity;
    Vector::new(-guide.y, guide.x) * (2.0 * omega * speed)
}

#[test]
fn arrows_have_the_direction_of_the_results() {
    let mut seen = 0;
    for scene in SCENES {
        let solution = solution(scene);
        let plan = accelerations(&solution);
        for arrow in solution.construction.arrows(plan.order) {
            let VectorOf::Passed(slide, VectorPart::Coriolis) = arrow.of else {
                assert_ne!(arrow.part(), VectorPart::Coriolis, "{scene}: {arrow:?}");
                continue;
            };
            let [from, to] = arrow.ends();
            let (drawn, truth) = (plan.segment(from, to).expect("both ends are there"), truth(&solution, slide.slider));
            assert!((drawn - truth).norm() <= 1e-9 * truth.norm(), "{scene}: {arrow:?}: {drawn} {truth}");
            assert_ne!(solution.mechanism.slider(slide.slider).on, GROUND, "{scene}: {arrow:?}");
            seen += 1;
        }
    }
    assert!(seen >= 5, "only {seen}");
}

#[test]
fn nothing_is_laid_off_that_is_always_zero() {
    for scene in SCENES {
        let solution = solution(scene);
        for arrow in solution.construction.arrows(Order::Acceleration) {
            let of = format!("{:?}", arrow.of);
            let length = accelerations(&solution).segment(&arrow.from, &arrow.to).expect("both ends are there").norm();
            assert!(length > 0.0, "{scene}: {of}");
        }
    }
}

/// Each step has one sentence and one equation for each part; the equation of a ray names each part once.
#[test]
fn one_symbol_stands_for_it() {
    for (notation, symbol) in [("paper", "a_c(2/3)"), ("russian", "a_k(2/3)")] {
        let mut scene: serde_json::Value =
            serde_json::from_str(&files::read("tests/lecture/shaper.json")).expect("JSON");
        scene["figure"]["notation"] = notation.into();
        let solution = solved(&scene.to_string()).expect("sound");
        let words = solution.wording();
        let teller = Teller::new(&solution, &words);
        let (mut laid, mut rays) = (Vec::new(), Vec::new());
        for step in solution.construction.numbered_steps().filter(|s| s.sheet == Sheet::Acceleration) {
            match &step.action {
                Action::LayOff(arrow) if arrow.part() == VectorPart::Coriolis => {
                    laid.push(teller.formula(&step).markup());
                }
                Action::Ray(_) => rays.push(teller.formula(&step).markup()),
                _ => {}
            }
        }
        assert_eq!(laid, [format!("{symbol} = 2 ω_3 v_r(2/3)")]);
        let with: Vec<&String> = rays.iter().filter(|equation| equation.contains(symbol)).collect();
        // A slides on link 3: a_A = a_A3 + a_r + a_c.
        assert_eq!(with, [&format!("a_{{A_3}} = a_{{A}} − {symbol} − a_r(2/3)")]);
        assert!(rays.contains(&"a_{D} = a_r(5/ground)".to_owned()), "{rays:?}");
    }
}

/// Forms and scenes that were written when every leg had one vector `n_…` keep their meaning.
#[test]
fn former_names_are_understood() {
    let solution = solution("tests/lecture/shaper.json");
    for (former, name) in [
        ("aplan(n_aA_3,a_3)", "aplan(k_a3,a_3)"),
        ("aplan(a,n_aA_3)", "aplan(a,k_a3)"),
        ("aplan(n_d_groundD,d)", "aplan(d_ground,d)"),
        ("aplan(n_oA_3,a_3)", "aplan(n_oA_3,a_3)"),
    ] {
        let [former, name] = [former, name].map(|name| solution.quantity(name).expect(name));
        assert_eq!(former, name);
    }
}
