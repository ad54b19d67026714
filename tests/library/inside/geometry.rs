//! Angles, lines, crossings, linear systems, balls and registers.

mod turns {
    use kinegon::geometry::{Vector, cross, quarter_turn};
    #[test]
    fn quarter_turn_is_counter_clockwise() {
        assert_eq!(quarter_turn(Vector::new(1.0, 0.0)), Vector::new(0.0, 1.0));
        assert_eq!(cross(Vector::new(1.0, 0.0), Vector::new(0.0, 1.0)), 1.0);
    }
}

mod angle {
    use kinegon::geometry::{Vector, degrees_of, direction_of_degrees};
    #[test]
    fn quarter_turns_are_exact() {
        assert_eq!(direction_of_degrees(90.0), Vector::new(0.0, 1.0));
        assert_eq!(direction_of_degrees(-180.0), Vector::new(-1.0, 0.0));
        assert_eq!(direction_of_degrees(630.0), Vector::new(0.0, -1.0));
    }

    #[test]
    fn degrees_read_back() {
        for degrees in [-179.0, -70.0, 0.0, 33.3, 90.0, 180.0] {
            assert!((degrees_of(direction_of_degrees(degrees)) - degrees).abs() < 1e-13);
        }
        assert_eq!(degrees_of(Vector::new(-1.0, -0.0)), 180.0);
    }
}

mod numbers {
    use kinegon::geometry::{Pair, direction_near, direction_of_degrees, quarters_of};

    #[test]
    fn directions_by_polynomials_are_those_of_libm() {
        let mut worst: f64 = 0.0;
        for k in -40_000..40_000 {
            let degrees = f64::from(k) * 0.037;
            let Pair { x: c, y: s } = direction_near(degrees, quarters_of(degrees));
            let d = direction_of_degrees(degrees);
            worst = worst.max((c - d.x).abs()).max((s - d.y).abs());
        }
        assert!(worst <= f64::EPSILON, "{worst}");
        for quarter in -9..9 {
            let degrees = 90.0 * f64::from(quarter);
            let d = direction_of_degrees(degrees);
            let Pair { x, y } = direction_near(degrees, f64::from(quarter));
            assert_eq!([x + 0.0, y + 0.0], [d.x + 0.0, d.y + 0.0]);
        }
    }
}

mod line {
    use kinegon::geometry::{Line, Place, Point, Vector};
    #[test]
    fn crossing_carries_its_sine() {
        let a = Line::new(Point::new(0.0, 1.0), Vector::new(2.0, 0.0)).expect("a direction");
        let b = Line::new(Point::new(3.0, 0.0), Vector::new(1.0, 1.0)).expect("a direction");
        let c = a.crossing(&b);
        assert!((c.sine() - 0.5_f64.sqrt()).abs() < 1e-15);
        let p = c.place().finite().expect("they cross");
        assert!((p - Point::new(4.0, 1.0)).norm() < 1e-14);
    }

    #[test]
    fn parallels_meet_at_infinity() {
        let a = Line::new(Point::new(0.0, 1.0), Vector::new(3.0, 4.0)).expect("a direction");
        let b = Line::new(Point::new(9.0, 1.0), Vector::new(3.0, 4.0)).expect("a direction");
        assert!(matches!(a.crossing(&b).place(), Place::AtInfinity(_)));
        assert!(matches!(a.crossing(&Line::AtInfinity).place(), Place::AtInfinity(_)));
    }
}

mod system {
    use kinegon::geometry::LinearSystem;
    use nalgebra::DMatrix;
    #[test]
    fn solves_a_badly_scaled_system_to_the_last_digits() {
        // Rows and columns of very different size; the solution is (1, 2, −3) over the columns' sizes.
        let a = [1e-200, 2e3, 0.0, 3e-200, -4e3, 1e90, 0.0, 1e3, 2e90];
        let x = [1e200, 2e-3, -3e-90];
        let b = [1.0 + 4.0, 3.0 - 8.0 - 3.0, 2.0 - 6.0];
        let system = LinearSystem::new(DMatrix::from_row_slice(3, 3, &a)).expect("regular");
        let solved = system.solve(&b);
        for (got, want) in solved.iter().zip(&x) {
            assert!((got / want - 1.0).abs() < 1e-14, "{got} {want}");
        }
        assert!(system.condition() < 20.0);
        let bound = system.verified(&[0.0; 9]).error_bound(&solved, &b, &[0.0; 3]);
        for ((got, want), bound) in solved.iter().zip(&x).zip(&bound) {
            assert!((got - want).abs() <= *bound && *bound < 1e-13 * want.abs());
        }
    }

    #[test]
    fn refuses_what_has_no_solution() {
        let system = |a: [f64; 4]| LinearSystem::new(DMatrix::from_row_slice(2, 2, &a));
        assert!(system([1.0, 2.0, 2.0, 4.0]).is_none());
        assert!(system([1.0, f64::NAN, 2.0, 4.0]).is_none());
        assert!(system([0.0, 0.0, 2.0, 4.0]).is_none());
    }
}

mod exact {
    use kinegon::geometry::{Ball, Number, Pair};
    #[test]
    fn decimals_have_all_their_digits() {
        // 0.1 is 0.1000000000000000055511151231257827… in binary.
        let tenth = Ball::decimal(0.1);
        let rest = tenth.low + 5.551_115_123_125_783e-18;
        assert!(tenth.high == 0.1 && rest.abs() < 1e-31 && tenth.radius < 1e-31, "{tenth:?}");
        for exact in [0.0, 3.0, -2.5, 31.3125, 24.000_488_281_25, 1e14, 1e22, -1e15] {
            let ball = Ball::decimal(exact);
            assert!(ball.error_from(exact) <= 1e-28 * exact.abs(), "{exact} {ball:?}");
        }
        assert_eq!(Ball::decimal(1e22), Ball::within(1e22, 0.0));
        // A text of many digits: 50 and 7 · 10⁻²⁴; the two f64 of 10⁻³⁰⁰ and the next digits.
        let long = Ball::of_decimal("50.000000000000000000000007");
        assert!(long.high == 50.0 && (long.low - 7e-24).abs() <= long.radius && long.radius < 1e-28, "{long:?}");
        let small = Ball::of_decimal("-1.00e-300");
        assert!(small.error_from(-1e-300) < 1e-305, "{small:?}");
        let third = format!("0.{}", "3".repeat(60));
        let off = Ball::of_decimal(&third) - Ball::from(1) / Ball::from(3);
        assert!(off.high.abs() <= off.radius && off.radius < 1e-30, "{off:?}");
    }

    #[test]
    fn huge_angles_are_reduced_exactly() {
        use kinegon::geometry::direction_of_degrees;
        // 10²² and 2⁵⁵ are exact in f64, and leave 280 and 128 of 360.
        for (huge, small) in [(1e22, 280.0), (-1e22, -280.0), (36_028_797_018_963_968.0, 128.0)] {
            let Pair { x, y } = Pair::direction_of_degrees(Ball::within(huge, 0.0));
            let want = Pair::direction_of_degrees(Ball::within(small, 0.0));
            assert!(x == want.x && y == want.y, "{huge}");
            assert_eq!(direction_of_degrees(huge), direction_of_degrees(small));
        }
    }

    #[test]
    fn directions_have_twenty_nine_digits() {
        // cos 30° = √3/2, sin 30° = 1/2; cos 45° = √½.
        let [half, three] = [0.5, 3.0].map(|x| Ball::within(x, 0.0));
        for (degrees, cosine, sine) in [
            (30.0, half * three.sqrt(), half),
            (-330.0, half * three.sqrt(), half),
            (120.0, -half, half * three.sqrt()),
            (-135.0, -half.sqrt(), -half.sqrt()),
            (270.0, Ball::default(), Ball::from(-1)),
        ] {
            let Pair { x, y } = Pair::direction_of_degrees(Ball::within(degrees, 0.0));
            for (got, truth) in [(x, cosine), (y, sine)] {
                assert!(
                    (got - truth).error_from(0.0) < 1e-29 && got.error_from(truth.high) < 1e-15,
                    "{degrees} {got:?}"
                );
            }
        }
        let near = Pair::direction_of_degrees(Ball::within(30.0, 1e-12));
        assert!(near.y.radius > 1.7e-14 && near.y.radius < 1.8e-14);
    }
}

mod ball {
    use dashu_float::round::mode::HalfEven;
    use kinegon::geometry::{Ball, Number};
    use proptest::prelude::*;

    /// Most that one operation adds to a ball's radius, in parts of its middle.
    const ROUNDING: f64 = f64::EPSILON * f64::EPSILON * 4.0;

    /// x + y as its rounded value and what rounding lost, for |x| ≥ |y|.
    fn ordered_sum(x: f64, y: f64) -> (f64, f64) {
        let sum = x + y;
        (sum, y - (sum - x))
    }

    type Precise = dashu_float::FBig<HalfEven, 2>;

    fn precise(x: f64) -> Precise {
        let x = Precise::try_from(x).expect("it is finite");
        x.with_precision(600).value()
    }

    /// A random ball of about 106 bits, and a number within it.
    fn ball() -> impl Strategy<Value = (Ball, Precise)> {
        // Often at the very edge, where a radius rounded to nearest is too small.
        let within = prop_oneof![-1.0..1.0, Just(-1.0), Just(1.0)];
        let numbers = (-1.0..1.0, -0.5..0.5, 0.0..1.0, -60..60, -20..-5, within);
        numbers.prop_map(|(high, low, radius, exponent, narrow, within)| {
            let size = libm::exp2(f64::from(exponent));
            let (high, low) = ordered_sum(high * size, low * size * f64::EPSILON);
            let radius = radius * size * libm::pow(10.0, f64::from(narrow));
            let number = precise(high) + precise(low) + precise(radius) * precise(within);
            (Ball { high, low, radius }, number)
        })
    }

    /// Whether the number lies in the ball.
    fn holds(ball: Ball, number: &Precise) -> bool {
        // Where nothing is known, anything may be.
        if !ball.is_known() {
            return true;
        }
        let off = number - (precise(ball.high) + precise(ball.low));
        let radius = precise(ball.radius);
        off <= radius && -off <= radius
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        #[test]
        fn results_hold_those_of_numbers_within(
            (a, x) in ball(),
            (b, y) in ball(),
        ) {
            for (name, result, number) in [
                ("sum", a + b, &x + &y),
                ("difference", a - b, &x - &y),
                ("product", a * b, &x * &y),
                ("double", a.twice(), &x + &x),
                ("quotient", a / b, &x / &y),
                ("root", (a * a).sqrt(), if x < precise(0.0) { -&x } else { x.clone() }),
                ("middle widened", a.middle().widened(a.radius), x.clone()),
            ] {
                prop_assert!(holds(result, &number), "{name}: {a:?}, {b:?} give {result:?}");
            }
        }

        /// For exact numbers, also where they nearly cancel.
        #[test]
        fn rounding_stays_below_its_bound((a, _) in ball(), (b, _) in ball(), digits in 0..30) {
            let exact = |ball: Ball| (Ball { radius: 0.0, ..ball }, precise(ball.high) + precise(ball.low));
            let (a, x) = exact(a);
            let small = libm::exp2(f64::from(-4 * digits));
            let (b, y) = exact(a + b * Ball::within(small, 0.0));
            for (result, number) in [(a - b, &x - &y), (a + b, &x + &y), (a * b, &x * &y)] {
                prop_assert!(holds(result, &number), "{a:?}, {b:?} give {result:?}");
                prop_assert!(result.radius <= ROUNDING * result.high.abs() * (1.0 + 16.0 * f64::EPSILON));
            }
            // Below the range of f64 rests are lost, and radii say so.
            let tiny = |ball: Ball, by: f64| Ball { high: ball.high * by, low: ball.low * by, radius: 0.0 };
            let at = |ball: Ball| precise(ball.high) + precise(ball.low);
            let (c, d) = (tiny(a, 1e-150), tiny(b, 1e-160));
            for (result, number) in [(c * d, at(c) * at(d)), (c * c, at(c) * at(c))] {
                prop_assert!(holds(result, &number), "{c:?}, {d:?} give {result:?}");
            }
            let difference = Ball::difference(a.high, b.high);
            let exact = precise(a.high) - precise(b.high);
            prop_assert_eq!(precise(difference.high) + precise(difference.low), exact);
        }
    }
}

mod lanes {
    use fearless_simd::{Level, dispatch};
    use kinegon::geometry::{Lanes, MANY, Many, Number, Random, Registers, Row};

    /// The bits of a + b c and a − b c in each register of some numbers.
    #[inline(always)]
    fn products<L: Lanes>(lanes: L, [a, b, c]: &[Many; 3]) -> Vec<u64> {
        let mut made = [Many::splat(0.0); 2];
        for k in 0..MANY / L::COUNT {
            let [a, b, c] = [a, b, c].map(|row| lanes.load(row, k));
            lanes.store(&mut made[0], k, a.plus_product(b, c));
            lanes.store(&mut made[1], k, a.minus_product(b, c));
        }
        made.iter().flat_map(|row| row.0.map(f64::to_bits)).collect()
    }

    #[test]
    fn sums_of_products_are_rounded_once_in_all_registers() {
        let mut random = Random(1);
        for _ in 0..100 {
            let rows = [0; 3].map(|_| Many([0; MANY].map(|_: i32| 10.0 * random.within())));
            let [a, b, c] = &rows;
            let sums = (0..MANY).map(|k| b[k].mul_add(c[k], a[k]));
            let expected: Vec<u64> =
                sums.chain((0..MANY).map(|k| (-b[k]).mul_add(c[k], a[k]))).map(f64::to_bits).collect();
            for level in [Level::new(), Level::baseline()] {
                assert_eq!(dispatch!(level, simd => products(Registers::<_, 2>(simd), &rows)), expected, "{level:?}");
            }
        }
    }
}
