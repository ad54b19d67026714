//! Shapes, texts, labels and signs on a sheet.

mod arrow {
    use kinegon::drawing::{Point, Shape, Vec2};

    #[test]
    fn heads_are_shorter_than_their_vectors() {
        for size in [1e-6, 0.01, 0.3, 1.0, 2.0, 5.2, 5.3, 40.0, 1e4] {
            for turn in 0..12 {
                let angle = f64::from(turn) * 0.55;
                let from = Point::new(20.0, 30.0);
                let to = from + Vec2::new(libm::cos(angle), libm::sin(angle)) * size;
                let [tip, left, notch, right] =
                    (Shape::Arrow { from, to, head: 2.6 }).head().expect("the arrow has length");
                assert_eq!(tip, to);
                let unit = (to - from) / size;
                for corner in [left, notch, right] {
                    let back = (to - corner).dot(unit);
                    assert!(back > 0.0 && back <= 0.5001 * size && back <= 2.6001, "{back} of {size}");
                }
                let Some(Shape::Line(start, end)) = (Shape::Arrow { from, to, head: 2.6 }).shaft() else {
                    panic!("no shaft")
                };
                assert_eq!(start, from);
                assert!((end - from).hypot2() < size * size);
            }
        }
        for from in [Point::new(1.0, 1.0), Point::new(f64::NAN, 1.0)] {
            assert_eq!((Shape::Arrow { from, to: Point::new(1.0, 1.0), head: 2.6 }).head(), None);
        }
    }

    #[test]
    fn heads_of_arcs_point_along_them() {
        for sweep in [2.0, -2.0, 0.1, -5.0] {
            let arrow = Shape::ArcArrow { center: Point::new(5.0, 5.0), radius: 8.0, start: 0.3, sweep, head: 2.6 };
            let [tip, .., right] = arrow.head().expect("the arc has length");
            let end = Point::new(5.0, 5.0) + Vec2::new(libm::cos(0.3 + sweep), libm::sin(0.3 + sweep)) * 8.0;
            assert!((tip - end).hypot2() < 1e-20);
            let tangent = Vec2::new(-libm::sin(0.3 + sweep), libm::cos(0.3 + sweep)) * sweep.signum();
            assert!((tip - right).dot(tangent) > 0.0);
            assert!(
                matches!(arrow.shaft(), Some(Shape::Arc { sweep: less, .. }) if less.abs() < sweep.abs() && less * sweep > 0.0)
            );
        }
        let none = Shape::ArcArrow { center: Point::ORIGIN, radius: 8.0, start: 0.3, sweep: 0.0, head: 2.6 };
        assert_eq!((none.head(), none.shaft()), (None, None));
    }
}

mod axis {
    use kinegon::drawing::curves::context::Axis;
    use kinegon::words::Wording;

    fn ticks(ends: [f64; 2], length: f64, degrees: bool) -> Vec<String> {
        let axis = Axis::new(Wording::default(), ends, [0.0, length], 10.0, degrees);
        axis.ticks.iter().map(|t| axis.tick(*t)).collect()
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(ticks([-0.13, 0.31], 45.0, false), ["−0.1", "0.0", "0.1", "0.2", "0.3"]);
        assert_eq!(ticks([0.0, 360.0], 60.0, true), ["0", "60", "120", "180", "240", "300", "360"]);
        assert_eq!(ticks([0.0, 360.0], 50.0, true), ["0", "90", "180", "270", "360"]);
        assert_eq!(ticks([3.0, 9.5], 40.0, true), ["4", "6", "8"]);
        assert_eq!(ticks([0.0, 4e6], 45.0, false), ["0", "1", "2", "3", "4"]);
        assert_eq!(ticks([-2e-5, 2e-5], 45.0, false), ["−20", "−10", "0", "10", "20"]);
    }
}

mod clip {
    use kinegon::drawing::clip::{TOLERANCE, clipped, clipped_chain, distance, simplified};
    use kinegon::drawing::{Point, Rect, Shape};

    const AREA: Rect = Rect::new(0.0, 0.0, 10.0, 10.0);

    #[test]
    fn lines_and_arrows_end_at_the_edge() {
        let (a, b) = (Point::new(5.0, 5.0), Point::new(25.0, 5.0));
        let from = Point::new(10.0, 5.0);
        assert_eq!(clipped(AREA, Shape::Line(a, b)), [Shape::Line(a, from)]);
        // A vector that runs on beyond the edge has its head there.
        let cut = clipped(AREA, Shape::Arrow { from: a, to: b, head: 2.6 });
        assert_eq!(cut, [Shape::Arrow { from: a, to: from, head: 2.6 }]);
        let back = clipped(AREA, Shape::Arrow { from: b, to: a, head: 2.6 });
        assert_eq!(back, [Shape::Arrow { from, to: a, head: 2.6 }]);
        let away = Shape::Line(Point::new(11.0, 0.0), Point::new(12.0, 9.0));
        assert!(clipped(AREA, away).is_empty());
        let within = Shape::Line(a, Point::new(6.0, 6.0));
        assert_eq!(clipped(AREA, within.clone()), [within]);
    }

    #[test]
    fn polygons_keep_what_is_inside() {
        let corner = |x: f64, y: f64| Point::new(x, y);
        let triangle = vec![corner(5.0, 5.0), corner(15.0, 5.0), corner(5.0, 15.0)];
        let shapes = clipped(AREA, Shape::Polygon(triangle));
        let [Shape::Polygon(corners)] = shapes.as_slice() else {
            panic!("{shapes:?}");
        };
        // The square from (5, 5) to (10, 10), whose corner (10, 10) the long side just meets.
        for want in [corner(5.0, 5.0), corner(10.0, 5.0), corner(10.0, 10.0), corner(5.0, 10.0)] {
            let near = corners.iter().any(|c| (*c - want).hypot() < 1e-9);
            assert!(near, "{want:?} in {corners:?}");
        }
        let all = corners.iter().all(|c| AREA.inflate(1e-9, 1e-9).contains(*c));
        assert!(all, "{corners:?}");
    }

    /// Of what begins 1e300 mm away the cut would be lost in rounding: renderers fail on such a mark.
    #[test]
    fn what_comes_from_far_ends_at_the_edge_too() {
        for far in [1e12, 1e150, 1e300] {
            let (a, b) = (Point::new(-far, -0.3 * far), Point::new(far, 0.7 * far));
            let triangle = vec![a, b, Point::new(5.0, 5.0)];
            let shapes = [Shape::Line(Point::new(5.0, 5.0), b), Shape::Polygon(triangle)];
            for shape in shapes.into_iter().flat_map(|shape| clipped(AREA, shape)) {
                let corners = match &shape {
                    Shape::Line(a, b) => vec![*a, *b],
                    Shape::Polygon(corners) => corners.clone(),
                    other => panic!("{other:?}"),
                };
                let is_inside = |p: &Point| (0.0..=10.0).contains(&p.x) && (0.0..=10.0).contains(&p.y);
                assert!(corners.iter().all(is_inside), "{shape:?}");
            }
            assert!(!Shape::Line(Point::ORIGIN, b).is_drawable());
        }
    }

    #[test]
    fn chains_are_cut_at_the_border() {
        let area = Rect::new(0.0, 0.0, 10.0, 10.0);
        let points = [(1.0, 5.0), (3.0, 15.0), (5.0, 5.0), (6.0, 5.0)].map(Point::from);
        let parts = clipped_chain(area, &points);
        let cut = [vec![(1.0, 5.0), (2.0, 10.0)], vec![(4.0, 10.0), (5.0, 5.0), (6.0, 5.0)]];
        let cut = cut.map(|part| part.into_iter().map(Point::from).collect::<Vec<_>>());
        assert_eq!(parts, cut);
    }

    #[test]
    fn what_is_left_out_is_not_seen() {
        let on = |k: i32| {
            let x = f64::from(k) / 10.0;
            Point::new(x, 20.0 * libm::sin(x / 10.0))
        };
        let points: Vec<Point> = (0..=2000).map(on).collect();
        let few = simplified(&points);
        assert!(few.len() < 400, "{}", few.len());
        for p in &points {
            let off = few.windows(2).map(|w| distance(*p, w[0], w[1]));
            assert!(off.fold(f64::INFINITY, f64::min) <= TOLERANCE);
        }
    }
}

mod grid {
    use kinegon::drawing::grid::Grid;
    use kinegon::drawing::{Point, Rect};
    use kinegon::geometry::Random;

    const AREA: Rect = Rect::new(10.0, 20.0, 110.0, 90.0);

    /// A point within or around the area.
    fn point(lot: &mut Random) -> Point {
        Point::new(140.0 * lot.unit(), 120.0 * lot.unit())
    }

    #[test]
    fn nothing_that_touches_a_box_is_missed() {
        let mut lot = Random(5);
        let mut grid = Grid::new(AREA);
        let lines: Vec<(Point, Point)> = (0..300).map(|_| (point(&mut lot), point(&mut lot))).collect();
        for (index, line) in lines.iter().enumerate() {
            grid.add_line(index, *line);
        }
        for _ in 0..300 {
            let corner = point(&mut lot);
            let area = Rect::from_origin_size(corner, (6.0 * lot.unit(), 6.0 * lot.unit()));
            let found = grid.near(area);
            assert!(found.is_sorted_by(|a, b| a < b));
            for (index, (a, b)) in lines.iter().enumerate() {
                // A thousand points of the line stand for it.
                let touches = (0..=1000).any(|k| {
                    let at = a.lerp(*b, f64::from(k) / 1000.0);
                    area.x0 <= at.x && at.x <= area.x1 && area.y0 <= at.y && at.y <= area.y1
                });
                assert!(!touches || found.contains(&index), "line {index} of {area:?}");
            }
            // Most of the others are not looked at.
            assert!(found.len() < 60, "{}", found.len());
        }
    }

    #[test]
    fn what_is_taken_out_is_gone() {
        let mut grid = Grid::new(AREA);
        let area = Rect::new(30.0, 30.0, 41.0, 33.0);
        grid.add(3, area);
        grid.add(4, area);
        grid.remove(3, area);
        assert_eq!(grid.near(AREA), [4]);
    }

    #[test]
    fn odd_numbers_do_no_harm() {
        for area in [Rect::ZERO, Rect::new(0.0, 0.0, f64::NAN, 1.0), Rect::new(5.0, 5.0, -5.0, f64::INFINITY)] {
            let mut grid = Grid::new(area);
            grid.add(0, Rect::new(f64::NAN, 0.0, f64::INFINITY, 1e300));
            grid.add_line(1, (Point::new(f64::NAN, 0.0), Point::ORIGIN));
            grid.add_line(2, (Point::new(1e30, 0.0), Point::ORIGIN));
            assert!(grid.near(Rect::new(0.0, 0.0, 1.0, 1.0)).ends_with(&[1, 2]));
        }
    }
}

mod labels {
    use kinegon::drawing::{LabelRequest, Obstacles, PlacedLabel, Point, Rect, RichText, Vec2, place};

    /// Whether two boxes are nearer to each other than this, beside each other and one above the other.
    fn touch(a: Rect, b: Rect, [x, y]: [f64; 2]) -> bool {
        a.x0 < b.x1 + x && b.x0 < a.x1 + x && a.y0 < b.y1 + y && b.y0 < a.y1 + y
    }

    /// The distance of a point from a box; 0 inside.
    fn gap(area: Rect, point: Point) -> f64 {
        let x = (area.x0 - point.x).max(point.x - area.x1).max(0.0);
        let y = (area.y0 - point.y).max(point.y - area.y1).max(0.0);
        (x * x + y * y).sqrt()
    }

    /// Numbers between 0 and 1 from a seed (Steele, Lea and Flood, "Fast Splittable Pseudorandom
    /// Number Generators", 2014).
    fn random(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = *seed;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn crowd(seed: u64, labels: usize, lines: usize, size: (f64, f64)) -> (Vec<LabelRequest>, Obstacles) {
        let mut seed = seed;
        let bounds = Rect::new(10.0, 10.0, 10.0 + size.0, 10.0 + size.1);
        let at = |seed: &mut u64| {
            let (x, y) = (random(seed), random(seed));
            Point::new(bounds.x0 + 2.0 + (size.0 - 4.0) * x, bounds.y0 + 2.0 + (size.1 - 4.0) * y)
        };
        let names = ["A", "S_3", "n_{s3b}", "v_{CB} ⊥ CB", "a^n_{DG}", "ω_2", "b'"];
        let anchors: Vec<Point> = (0..labels).map(|_| at(&mut seed)).collect();
        let request = |(index, &anchor): (usize, &Point)| LabelRequest {
            text: RichText::math(names[index % names.len()]),
            size: 3.5,
            anchor,
            clearance: 1.6,
            prefer: (index % 3 == 0).then_some(Vec2::new(1.0, -0.2)),
            priority: 0,
            may_stand_apart: true,
            short: None,
        };
        let requests = anchors.iter().enumerate().map(request).collect();
        let mut obstacles = Obstacles::new(bounds);
        obstacles.add_boxes(anchors.iter().map(|&anchor| Rect::from_center_size(anchor, (2.2, 2.2))));
        obstacles.add_lines((0..lines).map(|_| (at(&mut seed), at(&mut seed))));
        (requests, obstacles)
    }

    /// Half an em, and a fifth of one, of labels as figures have them, in mm.
    const WHITE: [f64; 2] = [0.5 * 4.7, 0.2 * 4.7];

    fn check(placed: Vec<Option<PlacedLabel>>, obstacles: &Obstacles) -> Vec<PlacedLabel> {
        let all: Vec<PlacedLabel> = placed.into_iter().map(|label| label.expect("a place for each")).collect();
        for (index, label) in all.iter().enumerate() {
            let ink = label.text.ink_box();
            assert_eq!(ink.union(obstacles.bounds), obstacles.bounds, "label {index} leaves the panel");
            assert!(
                !obstacles.boxes.iter().any(|&other| touch(ink, other, [0.0; 2])),
                "label {index} touches an obstacle"
            );
            for (other_index, other) in all[..index].iter().enumerate() {
                assert!(!touch(ink, other.text.ink_box(), WHITE), "labels {other_index} and {index} read as one");
            }
        }
        all
    }

    /// Off few lines most labels have a place; off a hundred those that have one keep apart.
    #[test]
    fn labels_keep_apart_in_crowds() {
        let placed = |(requests, obstacles): (Vec<LabelRequest>, Obstacles)| {
            let found = place(&requests, &obstacles, None).into_iter().filter(Option::is_some).collect();
            [check(found, &obstacles).len(), requests.len()]
        };
        let (mut count, mut asked) = (0, 0);
        for seed in 0..60 {
            placed(crowd(seed, 40, 100, (140.0, 100.0)));
            for crowd in [crowd(seed, 40, 6, (140.0, 100.0)), crowd(1000 + seed, 24, 3, (60.0, 50.0))] {
                let [own, all] = placed(crowd);
                (count, asked) = (count + own, asked + all);
            }
        }
        assert!(4 * count > 3 * asked, "{count} of {asked}");
    }

    #[test]
    fn the_same_labels_get_the_same_places() {
        let (requests, obstacles) = crowd(7, 40, 100, (140.0, 100.0));
        assert_eq!(place(&requests, &obstacles, None), place(&requests, &obstacles, None));
    }

    #[test]
    fn a_lone_label_stands_where_it_likes() {
        let obstacles = Obstacles::new(Rect::new(0.0, 0.0, 100.0, 100.0));
        for (x, y) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (1.0, 1.0), (-1.0, -1.0)] {
            let wish = Vec2::new(x, y);
            let anchor = Point::new(50.0, 50.0);
            let request = LabelRequest {
                text: RichText::math("S_3"),
                size: 4.0,
                anchor,
                clearance: 1.5,
                prefer: Some(wish),
                priority: 0,
                may_stand_apart: true,
                short: None,
            };
            let placed = check(place(&[request], &obstacles, None), &obstacles);
            let away = placed[0].text.ink_box().center() - anchor;
            assert!(away.dot(wish) > 0.7 * away.hypot2().sqrt() * wish.hypot2().sqrt(), "{away:?} for {wish:?}");
            assert!((gap(placed[0].text.ink_box(), anchor) - 1.5).abs() < 1e-9);
            assert_eq!(placed[0].leader, None);
        }
    }

    #[test]
    fn a_label_without_room_beside_its_point_gets_a_leader() {
        let anchor = Point::new(50.0, 50.0);
        let mut obstacles = Obstacles::new(Rect::new(0.0, 0.0, 100.0, 100.0));
        obstacles.add_boxes([Rect::from_center_size(anchor, (14.0, 14.0))]);
        let request = LabelRequest {
            text: RichText::math("S_3"),
            size: 4.0,
            anchor,
            clearance: 1.5,
            prefer: None,
            priority: 0,
            may_stand_apart: true,
            short: None,
        };
        let placed = check(place(&[request], &obstacles, None), &obstacles);
        assert!(placed[0].leader.is_some());
    }

    #[test]
    fn a_panel_without_room_says_so() {
        let obstacles = Obstacles::new(Rect::new(0.0, 0.0, 4.0, 4.0));
        let request = |x| LabelRequest {
            text: RichText::math("v_{CB} ⊥ CB"),
            size: 4.0,
            anchor: Point::new(x, 2.0),
            clearance: 1.0,
            prefer: None,
            priority: 0,
            may_stand_apart: true,
            short: None,
        };
        let placed = place(&[request(1.0), request(f64::NAN)], &obstacles, None);
        assert_eq!(placed, [None, None]);
        assert!(place(&[], &obstacles, None).is_empty());
    }
}

mod markup {
    use kinegon::drawing::{Rect, RichText};

    fn contents(text: &RichText) -> Vec<(&str, bool)> {
        text.runs().iter().map(|run| (run.content.as_str(), run.italic)).collect()
    }

    #[test]
    fn letters_slant_and_signs_stand_alone() {
        let text = RichText::math("v_{CB} ⊥ (B'C) 2ω");
        let expected = [
            ("v", true),
            ("CB", true),
            ("⊥", false),
            ("(", false),
            ("B", true),
            ("′", false),
            ("C", true),
            (") 2", false),
            ("ω", true),
        ];
        assert_eq!(contents(&text), expected);
        assert_eq!(contents(&RichText::plain("v = 2 mm")), [("v = 2 mm", false)]);
        assert_eq!(contents(&RichText::verbatim("a_b^{c}")), [("a_b^{c}", false)]);
        assert_eq!(contents(&RichText::math("d''")), [("d", true), ("″", false)]);
    }

    #[test]
    fn scripts_of_one_base_stand_one_above_the_other() {
        for source in ["a^{n}_{CB}", "a_{CB}^n"] {
            let text = RichText::math(source);
            let find = |content: &str| text.runs().iter().find(|run| run.content == content).expect("it was set");
            let (above, below) = (find("n"), find("CB"));
            assert!(above.y < 0.0 && below.y > 0.0 && above.scale == 0.7);
            assert!((above.x - below.x).abs() < 0.15);
        }
    }

    #[test]
    fn odd_markup_is_literal() {
        for (source, content) in
            [("a_", "a_"), ("a_{b", "a_{b"), ("_", "_"), ("a__b", "a_b"), ("a_{}", "a"), ("", ""), ("a}", "a}")]
        {
            assert_eq!(RichText::plain(source).content(), content, "{source}");
        }
        let deep = RichText::plain(&"a_{".repeat(40));
        assert!(deep.width(1.0).is_finite());
        assert_eq!(RichText::plain("a\u{0}\u{7}b\tc").content(), "ab c");
        assert_eq!(RichText::plain("   ").ink_box(4.0), Rect::ZERO);
    }
}

mod notes {
    use kinegon::drawing::overlay::notes::typeset;

    #[test]
    fn underscores_become_low_letters() {
        for (text, markup) in [
            ("v_r(3/2) and n_b3.", "v_{r}(3/2) and n_{b3}."),
            ("ω_2² L_BS3", "ω_{2}² L_{BS3}"),
            ("n_b_rodC", "n_{b_{rodC}}"),
            ("vplan(b,s3)", "vplan(b,s3)"),
        ] {
            assert_eq!(typeset(text), markup);
        }
    }
}

mod sheet {
    use kinegon::drawing::{Drawing, Pen, PlacedText, Point, RichText, Shape};

    #[test]
    fn halos_only_where_lines_run_through() {
        let mut drawing = Drawing::new(100.0, 100.0);
        let text = |x, y| Shape::Text(PlacedText::new(RichText::math("S_3"), 4.0, Point::new(x, y)));
        drawing.draw(Pen::Link, Shape::Line(Point::new(0.0, 0.0), Point::new(100.0, 100.0)));
        drawing.draw(
            Pen::LinkFill,
            Shape::Polygon(vec![Point::new(60.0, 0.0), Point::new(90.0, 0.0), Point::new(75.0, 40.0)]),
        );
        drawing.draw(Pen::Joint, Shape::Circle { center: Point::new(20.0, 80.0), radius: 10.0 });
        drawing.draw(Pen::Label, text(50.0, 51.0));
        drawing.draw(Pen::Label, text(10.0, 51.0));
        drawing.draw(Pen::Label, text(59.0, 1.0));
        drawing.draw(Pen::Label, text(29.0, 81.0));
        drawing.draw(Pen::Label, text(18.0, 81.0));
        drawing.draw(Pen::Caption, text(50.0, 51.0));
        drawing.draw(Pen::Link, Shape::Line(Point::new(0.0, 51.0), Point::new(30.0, 51.0)));
        assert_eq!(drawing.halos()[3..9], [true, false, false, true, false, false]);
    }

    #[test]
    fn numbers_that_are_not_finite_do_no_harm() {
        let mut drawing = Drawing::new(f64::NAN, -1.0);
        for wrong in [f64::NAN, f64::INFINITY, -3.0] {
            let (center, radius) = (Point::new(wrong, 1.0), wrong);
            drawing.draw(Pen::Joint, Shape::Circle { center, radius });
            drawing.draw(Pen::Turning, Shape::ArcArrow { center, radius, start: wrong, sweep: wrong, head: 2.6 });
            drawing.draw(Pen::Velocity, Shape::Arrow { from: center, to: Point::ORIGIN, head: wrong });
            drawing.draw(Pen::Link, Shape::Polygon(vec![]));
            let text = PlacedText::new(RichText::math("S_3"), wrong, center);
            drawing.draw(Pen::Label, Shape::Text(text));
        }
        assert_eq!(drawing.halos().len(), drawing.marks.len());
        assert!(!drawing.svg().contains("NaN"));
    }
}

mod text {
    use kinegon::drawing::{Drawing, Pen, PlacedText, Point, RichText, Shape};
    use kinegon::format::{Text, svg_with};
    use support::ink::ink_in;

    #[test]
    fn spaces_widen_a_text_wherever_they_stand() {
        let width = |source| RichText::plain(source).width(1.0);
        let space = width("a b") - width("ab");
        assert!(space > 0.15);
        for source in [" ab", "ab ", "a  b"] {
            let spaces = source.matches(' ').count() as f64;
            assert!((width(source) - width("ab") - spaces * space).abs() < 0.03, "{source}");
        }
        assert!(RichText::plain(" a  b ").runs().iter().all(|run| run.content.trim() == run.content));
    }

    /// The renderer's own box around the ink is the judge.
    #[test]
    fn boxes_are_where_the_renderer_puts_the_ink() {
        let mut worst: f64 = 0.0;
        let texts = [
            "A",
            "S_3",
            "n_{s3b}",
            "a^{n}_{CB}",
            "v_{CB} ⊥ BC",
            "ω_2×v_r",
            "π",
            "B''",
            "−ω_2^2(BS_3 + 1)",
            "AVATAR To Wy",
            "μ_v = 2.5 mm/s",
            "v_{S_{3b}}^t ∥ ∠ABC",
            "first official affine flow",
            "Скорость Гул",
            "αβ, ΔΑ Vω",
        ];
        for source in texts {
            for text in [RichText::math(source), RichText::plain(source)] {
                let placed = PlacedText::new(text, 4.0, Point::new(20.0, 20.0));
                let mut drawing = Drawing::new(120.0, 40.0);
                drawing.draw(Pen::Caption, Shape::Text(placed.clone()));
                let ink = placed.ink_box();
                let drawn = [Text::Letters, Text::Outlines, Text::Glyphs]
                    .map(|mode| ink_in(&svg_with(&drawing, mode)))
                    .into_iter()
                    .flat_map(|drawn| drawn.into_iter().zip([ink.x0, ink.y0, ink.x1, ink.y1]));
                for (drawn, ours) in drawn {
                    worst = worst.max((drawn - ours).abs());
                    assert!((drawn - ours).abs() < 0.1, "{source}: drawn at {drawn}, expected {ours}");
                }
            }
        }
        // Kerning and ligatures are followed: what remains is rounding.
        assert!(worst < 0.02, "{worst} mm");
    }
}

mod view {
    use kinegon::drawing::{Extent, Rect, fitting_scale};

    fn scale(size: f64, paper: f64) -> f64 {
        let extent = Extent::of([kinegon::geometry::Point::origin(), kinegon::geometry::Point::new(size, 0.0)]);
        fitting_scale(&extent, Rect::new(0.0, 0.0, paper, paper))
    }

    #[test]
    fn scales_are_round() {
        assert_eq!(scale(100.0, 100.0), 1.0);
        assert_eq!(scale(101.0, 100.0), 2.0);
        assert_eq!(scale(2.3, 100.0), 0.025);
        assert_eq!(scale(3e7, 100.0), 5e5);
    }
}
