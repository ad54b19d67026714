//! Numbers with few digits, rules of pulled joints, figures put into a text, places of one.

mod figure {
    use kinegon::Sheet;
    use kinegon::editing::with_figure;
    use kinegon::scene::{Scene, StyleName};

    const SCENE: &str = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" },
    "note": "a < b",   "ground": { "A": [0, 0], "D": [160.000000000000000001, 0] },
    "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": 60, "omega": 10 } },
      "2": { "points": ["B", "C"], "lengths": { "BC": 140 } }, "3": { "points": ["D", "C"], "lengths": { "CD": 110 } } } }"#;

    #[test]
    fn a_figure_is_put_in_and_taken_out() {
        let mut figure = Scene::read(SCENE).expect("it is good").figure;
        assert_eq!(with_figure(SCENE, &figure).as_deref(), Ok(SCENE));
        (figure.style, figure.mu[Sheet::Velocity]) = (StyleName::Lecture, Some(2.5));
        figure.labels.insert("B".into(), "\"B₁\" </script>".into());
        let put = with_figure(SCENE, &figure).expect("it is good");
        assert_eq!(Scene::read(&put).expect("it is good").figure, figure);
        let rest = [r#"160.000000000000000001, 0] },"#, r#""note": "a < b",   "ground""#];
        assert!(rest.iter().all(|kept| put.contains(kept)), "{put}");
        (figure.style, figure.mu[Sheet::Velocity]) = (StyleName::Paper, Some(5.0));
        let back = with_figure(&put, &figure).expect("it is good");
        assert_eq!(Scene::read(&back).expect("it is good").figure, figure);
        assert!(!back.contains("style"), "{back}");
    }
}

mod number {
    use kinegon::editing::measure::Decimals;

    #[test]
    fn a_thousandth_of_the_size_or_finer() {
        for (size, decimals) in [(300.0, 1), (1000.0, 0), (999.0, 1), (3.0, 3), (20_000.0, -1), (0.2, 4)] {
            assert_eq!(Decimals::of_size(size), Decimals(decimals), "{size}");
        }
    }

    #[test]
    fn rounded_numbers_are_short() {
        assert_eq!(Decimals(1).json(12.3456).to_string(), "12.3");
        assert_eq!(Decimals(1).json(-0.01).to_string(), "0");
        assert_eq!(Decimals(-1).json(1234.0).to_string(), "1230");
        assert_eq!(Decimals(3).json(1e20).to_string(), "1e+20");
    }
}

mod places {
    use kinegon::editing::places;
    use kinegon::scene::SceneError;

    #[test]
    fn places_of_a_whole_scene_are_those_of_its_position_and_of_a_part_those_that_it_says() -> Result<(), SceneError> {
        let whole = places(include_str!("../../../templates/four-bar.json"))?;
        assert_eq!(whole.keys().collect::<Vec<_>>(), ["A", "D", "B", "C"]);
        let [x, y] = whole["B"];
        assert!((x - 30.0).abs() < 1e-9 && (y - 51.961_524).abs() < 1e-6, "{x}, {y}");
        let part = places(r#"{ "ground": { "A": [1, 2] }, "near": { "B": [3, 4], "angle(1)": 5 } }"#)?;
        assert_eq!(part.into_iter().collect::<Vec<_>>(), [("B".to_owned(), [3.0, 4.0]), ("A".to_owned(), [1.0, 2.0])]);
        Ok(())
    }
}

mod rules {
    use kinegon::editing::reshape::held::{Rule, allowed};
    use kinegon::geometry::{Point, Vector};

    #[test]
    fn rules_hold_and_the_nearest_place_is_taken() {
        let now = Point::new(3.0, 4.0);
        let center = Point::origin();
        let wanted = Point::new(0.0, -8.0);
        assert_eq!(allowed(now, &[], wanted), wanted);
        assert_eq!(allowed(now, &[Rule::Line(Vector::x())], wanted), Point::new(0.0, 4.0));
        assert_eq!(allowed(now, &[Rule::Circle(center)], wanted), Point::new(0.0, -5.0));
        assert_eq!(
            allowed(now, &[Rule::Circle(center), Rule::Circle(Point::new(6.0, 0.0))], wanted),
            Point::new(3.0, -4.0)
        );
        assert_eq!(allowed(now, &[Rule::Line(Vector::y()), Rule::Circle(center)], wanted), Point::new(3.0, -4.0));
        assert_eq!(allowed(now, &[Rule::Line(Vector::y()), Rule::Line(Vector::x())], wanted), now);
    }
}
