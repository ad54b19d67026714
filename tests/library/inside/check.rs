//! How finely values are written, what moves together, and by how much a student's sheet is turned.

mod precision {
    use kinegon::check::written::{Precision, whole_rounding};

    #[test]
    fn zeros_that_a_file_has_dropped_count() {
        let texts = ["61.53", "100", "7.5", "248.06"];
        let precision = Precision::of(texts.into_iter());
        assert_eq!(precision.rounding("100"), 0.005);
        assert_eq!(precision.rounding("7.5"), 0.005);
    }

    #[test]
    fn so_do_significant_digits_where_decimals_differ() {
        let texts = ["33.2", "0.4746", "-1.105", "0.08613"];
        let precision = Precision::of(texts.into_iter());
        assert_eq!(precision.rounding("33.2"), 0.005);
        assert_eq!(precision.rounding("0.4746"), 0.00005);
    }

    #[test]
    fn one_slipped_point_makes_no_other_number_finer() {
        let texts = ["61.5", "4.85", "138.2", "59.4"];
        let precision = Precision::of(texts.into_iter());
        assert_eq!(precision.rounding("61.5"), 0.05);
        assert_eq!(precision.rounding("48.5"), 0.05);
        assert_eq!(precision.rounding("4.85"), 0.005);
    }

    #[test]
    fn a_short_whole_number_has_the_digits_of_the_others() {
        let digits = Precision::of(["8.364", "110", "3"].into_iter()).digits;
        assert_eq!(whole_rounding("3", digits), 0.005);
        assert_eq!(whole_rounding("110", digits), 0.5);
        assert_eq!(whole_rounding("3.0", digits), f64::INFINITY);
    }

    #[test]
    fn powers_of_ten_say_their_last_digit() {
        let precision = Precision::of(["1.5e3"].into_iter());
        assert_eq!(precision.rounding("1.5e3"), 50.0);
    }
}

mod together {
    use kinegon::check::model::ways_together;

    /// Where no joint is plotted nothing moves together.
    #[test]
    fn a_construction_without_joints_has_no_joint_errors() {
        let text = include_str!("../../../templates/four-bar.json");
        let solution = kinegon::solve(&kinegon::scene::Scene::read(text).expect("a scene")).expect("it can be solved");
        let (mut construction, _) = kinegon::quantity::read_by_hand(&solution, &[]);
        let scales = kinegon::PerSheet::from_fn(|_| 1.0);
        let exact = construction.run(scales, &[]);
        assert!(!ways_together(&construction, &exact, &solution.mechanism).is_empty());
        construction.operations.clear();
        assert!(ways_together(&construction, &exact, &solution.mechanism).is_empty());
    }
}

mod sheets {
    use kinegon::check::redrawn::sheets::best_turn;
    use kinegon::geometry::{Vector, turn_of_degrees};

    #[test]
    fn one_wrong_point_does_not_turn_the_others() {
        let right = [[80.0, 0.0], [10.0, 60.0], [-30.0, 20.0], [50.0, 40.0]];
        let mut pairs = right.map(|r| {
            let r = Vector::from(r);
            (turn_of_degrees(-25.0).transform_vector(&r), r)
        });
        assert!((best_turn(&pairs, 0.3) - 25.0).abs() < 1e-9);
        pairs[1].0 += Vector::new(14.0, 9.0);
        assert!((best_turn(&pairs, 0.3) - 25.0).abs() < 0.1);
    }
}
