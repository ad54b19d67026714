//! A scene put together in Rust is the scene that its file says: every key of the format, the same checks, the same messages.

use kinegon::scene::{
    Belt, Builder, ConstructionShown, CoriolisName, DecimalMark, Figure, ForceUnit, FrameName, Friction, Grip, Guide,
    LanguageName, LengthUnit, LinkMotion, MassUnit, Mesh, NewLink, NewLoad, NotationName, Page, PageSize, PointMotion,
    Push, RubbingJoint, ScalesFor, Scene, SlidingName, StyleName, TimeUnit, Turn, TurnedName, polar,
};
use kinegon::{PerSheet, Sheet};
use support::files;

/// The scene in a file of the repository.
fn file(path: &str) -> Scene {
    Scene::read(&files::read(path)).expect("a good scene")
}

/// Everything that a scene says, in words; its text is another matter.
fn said(scene: &Scene) -> String {
    let Scene { title, units, given_by, ground, coordinates, known, links, sliders, near, figure, want, .. } = scene;
    format!(
        "{title:?} {units:?} {given_by:?} {ground:?} {known:#?} {links:#?} {sliders:#?} {near:#?} {figure:#?} {want:?} {:#?}",
        // The order of points is not said by a frame's coordinates and a drawing's together.
        coordinates.iter().collect::<std::collections::BTreeMap<_, _>>()
    )
}

/// Checks that the builder says what the scene says, and that its text, saved and read, does too.
fn is_the_same(builder: &Builder, scene: &Scene) {
    let built = builder.build().unwrap_or_else(|error| panic!("{error}\n{}", builder.text()));
    assert_eq!(said(&built), said(scene));
    let again = Scene::read(&builder.text()).expect("it was read before");
    assert_eq!(built, again);
}

fn mm() -> Builder {
    Builder::new(LengthUnit::Mm, TimeUnit::S)
}

/// A link of two points with their distance.
fn bar(ends: [&str; 2], key: &str, length: f64) -> NewLink {
    NewLink::points(ends).length(key, length)
}

#[test]
fn four_bar_linkage() {
    let crank = Turn::omega(10.0).angle(60.0).alpha(0.0);
    let builder = mm()
        .title("Four-bar linkage")
        .ground("A", [0.0, 0.0])
        .ground("D", [160.0, 0.0])
        .link("1", bar(["A", "B"], "AB", 60.0).drive(crank))
        .link("2", bar(["B", "C"], "BC", 140.0))
        .link("3", bar(["D", "C"], "CD", 110.0))
        .near("C", [155.0, 110.0]);
    is_the_same(&builder, &file("templates/four-bar.json"));
}

#[test]
fn slider_crank_whose_guide_passes_through_a_place() {
    let builder = mm()
        .title("Offset slider-crank")
        .ground("A", [0.0, 0.0])
        .link("1", bar(["A", "B"], "AB", 50.0).drive(Turn::omega(10.0).angle(60.0)))
        .link("2", bar(["B", "C"], "BC", 150.0))
        .link("3", NewLink::points(["C"]))
        .slider("3", "C", Guide::on("ground").through([0.0, -20.0]).along(0.0))
        .near("C", [160.0, -20.0]);
    is_the_same(&builder, &file("templates/slider-crank.json"));
}

#[test]
fn whitworth_quick_return_whose_guides_pass_through_points() {
    let builder = mm()
        .title("Whitworth quick return")
        .ground("A", [0.0, 0.0])
        .ground("D", [0.0, -40.0])
        .link("1", bar(["A", "B"], "AB", 100.0).drive(Turn::omega(10.0).angle(60.0)))
        .link("2", NewLink::points(["B"]))
        .link("3", bar(["E", "D"], "DE", 60.0))
        .link("4", bar(["E", "F"], "EF", 220.0))
        .link("5", NewLink::points(["F"]))
        .slider("2", "B", Guide::on("3").through("D").along("ED"))
        .slider("5", "F", Guide::on("ground").through("D").along(0.0))
        .near("E", [-20.0, -95.0])
        .near("F", [190.0, -40.0]);
    is_the_same(&builder, &file("templates/whitworth.json"));
}

#[test]
fn platform_with_three_drives_and_long_names() {
    let drive = |angle, omega, alpha| Turn::omega(omega).angle(angle).alpha(alpha);
    let platform =
        NewLink::points(["C1", "C2", "C3"]).length("C1-C2", 90.0).length("C2-C3", 90.0).length("C1-C3", 90.0);
    let builder = mm()
        .title("3-RRR platform")
        .ground("A1", [0.0, 0.0])
        .ground("A2", [320.0, 0.0])
        .ground("A3", [160.0, 280.0])
        .link("1", bar(["A1", "B1"], "A1-B1", 60.0).drive(drive(50.0, 2.0, 3.0)))
        .link("2", bar(["A2", "B2"], "A2-B2", 60.0).drive(drive(170.0, 1.0, -2.0)))
        .link("3", bar(["A3", "B3"], "A3-B3", 60.0).drive(drive(-70.0, -1.0, 4.0)))
        .link("4", bar(["B1", "C1"], "B1-C1", 130.0))
        .link("5", bar(["B2", "C2"], "B2-C2", 130.0))
        .link("6", bar(["B3", "C3"], "B3-C3", 130.0))
        .link("7", platform)
        .near("C1", [130.0, 140.0])
        .near("C2", [135.0, 50.0])
        .near("C3", [210.0, 95.0]);
    is_the_same(&builder, &file("templates/platform-3rrr.json"));
}

#[test]
fn the_papers_mechanism_with_labels_of_its_own() {
    let labels = [
        ("ground", "6"),
        ("k_b3", ""),
        ("n_b3", "n_{s3b}"),
        ("n_g3", "n_{s3g}"),
        ("n_b5", "n_{s5b}"),
        ("n_g5", "n_{s5g}"),
    ];
    let link_4 = NewLink::points(["G", "D", "F"]).length("GD", 300.0).length("FG", 150.0).length("FD", 180.0);
    let builder = mm()
        .title("Quintero et al. (2011), Figure 2")
        .ground("A", [0.0, 0.0])
        .ground("G", [275.0, 0.0])
        .link("1", bar(["A", "B"], "AB", 100.0).drive(Turn::omega(-1.0).angle(70.0)))
        .link("2", bar(["B", "E"], "BE", 500.0))
        .link("3", NewLink::points(["D"]))
        .link("4", link_4)
        .link("5", bar(["E", "F"], "EF", 300.0))
        .slider("3", "D", Guide::on("2").along("BE"))
        .near("D", [263.0, 300.0])
        .near("E", [406.0, 428.0])
        .near("F", [338.0, 136.0])
        .figure(Figure {
            labels: labels.map(|(name, label)| (name.to_owned(), label.into())).into(),
            construction: ConstructionShown::Paper,
            scales: ScalesFor::Sheet,
            ..Figure::default()
        });
    is_the_same(&builder, &file("examples/figure-2.json"));
}

#[test]
fn the_papers_group_as_drawn_with_motions_by_size_and_angle() {
    let motion = |(size, angle), (size_a, angle_a)| PointMotion {
        velocity: polar(size, angle),
        acceleration: polar(size_a, angle_a),
    };
    let builder = mm()
        .title("Quintero et al. (2011), Figure 1: a fourth-class Assur group")
        .point("B", [0.0, 0.0])
        .point("E", [300.0, 50.0])
        .point("C", [70.0, 150.0])
        .point("D", [190.0, 240.0])
        .point("G", [120.0, -170.0])
        .point("F", [250.0, -80.0])
        .known("B", motion((200.0, 75.0), (150.0, 210.0)))
        .known("E", motion((250.0, 300.0), (300.0, 345.0)))
        .link("1", NewLink::points(["B"]))
        .link("2", NewLink::points(["B", "C", "G"]))
        .link("3", NewLink::points(["C", "D"]))
        .link("4", NewLink::points(["E", "D", "F"]))
        .link("5", NewLink::points(["G", "F"]))
        .link("6", NewLink::points(["E"]))
        .figure(Figure { construction: ConstructionShown::Paper, ..Figure::default() });
    is_the_same(&builder, &file("examples/figure-1.json"));
}

#[test]
fn drawn_dyad_on_a_link_of_known_motion() {
    let link_1 = NewLink::points(["A", "B"]).motion(LinkMotion {
        at: "A".into(),
        velocity: [30.0, 40.0],
        acceleration: [50.0, -100.0],
        omega: 2.0,
        alpha: -3.0,
    });
    let builder = mm()
        .title("Dyad PRP: two blocks on one pin")
        .point("A", [0.0, 0.0])
        .point("B", [110.0, 110.0])
        .point("C", [70.0, 70.0])
        .link("1", link_1)
        .link("2", NewLink::points(["C"]))
        .link("3", NewLink::points(["C"]))
        .slider("2", "C", Guide::on("1").along("AB"))
        .slider("3", "C", Guide::on("ground").along([1.0, 0.0]));
    is_the_same(&builder, &file("templates/dyad-prp.json"));
}

/// Keys that no template has: shapes, pins in slots, driven sliders, turned ones, turns per minute, angles.
#[test]
fn every_other_key() {
    let text = r#"{ "kinegon": 1, "units": { "length": "ft", "time": "min" },
        "ground": { "A": [0, 0], "H": [-30, 0.1] },
        "links": {
          "1": { "points": ["A", "B"], "lengths": { "AB": 1e-7 }, "drive": { "rpm": 90 }, "angle": 45 },
          "2": { "shape": { "D": [0, 0], "E": [25, 0], "F": [10, -40.5] } },
          "3": { "points": ["F"] } },
        "sliders": [
          { "pin": "B", "on": "2", "through": [5, 0], "along": [1, 2] },
          { "link": "3", "at": "F", "on": "ground", "through": "H", "along": 90, "turned": -15,
            "drive": { "position": 40, "speed": 3e20, "acceleration": -2 } } ],
        "near": { "E": [1, 2], "angle(2)": 12.5 },
        "figure": { "panels": ["velocity", "scheme"], "mu_l": 1, "mu_v": 2.5, "mu_a": 0.1, "page": "letter-portrait", "worksheet": true,
                    "style": "board", "notation": "german", "sliding": "points", "coriolis": "C", "frame": "0", "turned": "clockwise", "language": "es",
                    "decimal": "comma", "special_points": false, "construction": false, "step": 7 },
        "want": ["omega(2)", "v(E)"] }"#;
    let push = Push::speed(3e20).position(40.0).acceleration(-2.0);
    let builder = Builder::new(LengthUnit::Ft, TimeUnit::Min)
        .ground("A", [0.0, 0.0])
        .ground("H", [-30.0, 0.1])
        .link("1", bar(["A", "B"], "AB", 1e-7).drive(Turn::rpm(90.0)).angle(45.0))
        .link("2", NewLink::shape([("D", [0.0, 0.0]), ("E", [25.0, 0.0]), ("F", [10.0, -40.5])]))
        .link("3", NewLink::points(["F"]))
        .pin("B", Guide::on("2").through([5.0, 0.0]).along([1.0, 2.0]))
        .slider("3", "F", Guide::on("ground").through("H").along(90.0).turned(-15.0).drive(push))
        .near("E", [1.0, 2.0])
        .near_angle("2", 12.5)
        .figure(Figure {
            panels: vec![Sheet::Velocity, Sheet::Scheme],
            mu: PerSheet::from_fn(|sheet| [1.0, 2.5, 0.1].get(sheet as usize).copied()),
            page: Page { size: PageSize::Letter, landscape: false },
            style: StyleName::Board,
            notation: NotationName::German,
            sliding: SlidingName::Points,
            coriolis: Some(CoriolisName::Capital),
            frame: Some(FrameName::Zero),
            turned: Some(TurnedName::Clockwise),
            language: LanguageName::Spanish,
            decimal: DecimalMark::Comma,
            worksheet: true,
            special_points: false,
            construction: ConstructionShown::Hidden,
            step: Some(7),
            ..Figure::default()
        })
        .want(["omega(2)", "v(E)"]);
    is_the_same(&builder, &Scene::read(text).expect("a good scene"));
}

#[test]
fn mistakes_are_told_as_in_a_file() {
    let crank = || bar(["A", "B"], "AB", 60.0).drive(Turn::omega(1.0).angle(0.0));
    let start = || mm().ground("A", [0.0, 0.0]);
    let told = |builder: Builder| builder.build().unwrap_err().to_string();
    for (builder, says) in [
        (
            start().link("1", crank()).link("1", crank()),
            "7:5: links.1: key `1` stands twice: first at line 6; hint: keep one of them",
        ),
        (start().link("1", crank().drive(Turn::rpm(3.0))), "key `drive` stands twice"),
        (
            start().link("1", crank().angle(3.0).angle(4.0)),
            "links.1.angle: key `angle` stands twice: first at line 6; hint: keep one of them",
        ),
        (
            start().link("1", crank()).pin("B", Guide::on("2").turned(1.0).turned(2.0)),
            "sliders[0].turned: key `turned` stands",
        ),
        (
            start().link("1", crank()).figure(Figure { step: Some(70_000), ..Figure::default() }),
            "figure.step: expected a whole number from 1 to 65535, found the number 70000",
        ),
        (start().link("1", bar(["A", "B"], "AB", f64::NAN).drive(Turn::omega(1.0).angle(0.0))), "NaN is not a number"),
        (start().link("1", crank()).near("C", [f64::NEG_INFINITY, 0.0]), "8:20: inf is not a number"),
        (start().link("1", bar(["A", "B"], "AC", 60.0)), "links.1.lengths.AC: "),
        (start(), "links: a mechanism has at least one link"),
        (
            start().title("quotes \" and \\ and\nlines").link("1", crank()).near("C", [0.0, 0.0]),
            "9:13: near.C: there is no point C",
        ),
    ] {
        let told = told(builder);
        assert!(told.contains(says), "{told}\nis not\n{says}");
    }
}

#[test]
fn a_negative_zero_is_read_back() {
    let crank = bar(["A", "B"], "AB", 60.0).drive(Turn::omega(1.0).angle(0.0));
    let builder = mm().ground("A", [0.0, 0.0]).link("1", crank).near("B", [-0.0, 0.0]);
    for scene in [builder.build(), Scene::read(&builder.text())] {
        let [x, y] = scene.expect("a good scene").near.points["B"];
        assert!(x.is_sign_negative() && y.is_sign_positive());
    }
}

/// What rolls, runs and rubs.
#[test]
fn racks_belts_loads_and_friction_are_as_in_their_file() {
    let rolling = mm()
        .ground("O", [0.0, 0.0])
        .link("1", NewLink::points(["C"]))
        .link("2", NewLink::points(["C", "Q"]).length("CQ", 20.0))
        .slider("1", "C", Guide::on("ground").through([0.0, 20.0]).along(0.0).drive(Push::speed(40.0).position(45.0)))
        .gear(["2", "ground"], Mesh::on("1").rack(20, 20.0));
    let read = Scene::read(
        r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "O": [0, 0] },
             "links": { "1": { "points": ["C"] }, "2": { "points": ["C", "Q"], "lengths": { "CQ": 20 } } },
             "sliders": [{ "link": "1", "at": "C", "on": "ground", "through": [0, 20], "along": 0,
                           "drive": { "position": 45, "speed": 40 } }],
             "gears": [{ "mesh": ["2", "ground"], "teeth": [20, "rack"], "radius": 20, "on": "1" }] }"#,
    )
    .expect("a good scene");
    is_the_same(&rolling, &read);
    assert_eq!(rolling.build().expect("a scene").gears, read.gears);

    let wheels = |belt: Option<Belt>| {
        let mesh = Mesh::on("ground").teeth([20, 40]);
        mm().ground("A", [0.0, 0.0])
            .ground("D", [90.0, 0.0])
            .link("1", NewLink::points(["A", "B"]).length("AB", 10.0).drive(Turn::omega(8.0).angle(30.0)))
            .link("2", NewLink::points(["D", "E"]).length("DE", 10.0))
            .gear(["1", "2"], belt.map_or(mesh.clone(), |belt| mesh.belt(belt)))
    };
    for (belt, omega) in [(None, -4.0), (Some(Belt::Open), 4.0), (Some(Belt::Crossed), -4.0)] {
        let solution = kinegon::solve(&wheels(belt).build().expect("a scene")).expect("it turns");
        assert_eq!(solution.motion.body(solution.mechanism.link("2").expect("a wheel")).omega, omega);
    }

    let loaded = mm()
        .mass_and_force(MassUnit::Kg, ForceUnit::N)
        .ground("A", [0.0, 0.0])
        .link("1", NewLink::points(["A", "B"]).length("AB", 60.0).drive(Turn::omega(10.0).angle(40.0)))
        .link("2", NewLink::points(["B", "C"]).length("BC", 180.0))
        .link("3", NewLink::points(["C"]))
        .slider("3", "C", Guide::on("ground").through([0.0, 0.0]).along(0.0))
        .load("3", NewLoad::force("C", [-400.0, 0.0]))
        .friction_at_pin("B", 0.1, 12.0)
        .friction_in_guide("3/ground", 0.2)
        .build()
        .expect("a scene");
    let friction = &loaded.loads.as_ref().expect("loads").friction;
    let pin = RubbingJoint::Pin { point: "B".to_owned(), radius: 12.0, fixed_in: None };
    assert_eq!(friction[0], Friction { joint: pin, grip: Grip::Coefficient(0.1) });
    assert_eq!(friction[1].joint, RubbingJoint::Guide("3/ground".to_owned()));
}
