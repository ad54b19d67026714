//! Steps and rates that are computed at once, against those one after the other.

use fearless_simd::{Level, dispatch};
use kinegon::cycle::{Drive, Path};
use kinegon::geometry::{MANY, Many, OneByOne, Registers, Row};
use kinegon::kernel::{Block, Kernel, Single};
use kinegon::scene::Scene;
use kinegon::solve;
use support::files;

/// A correction, in radians, that counts as sure here.
const SURE: f64 = 1e-6;

/// Degrees by which the drive is moved from positions that are closed: less than that.
const MOVED: f64 = 1e-5;

/// Degrees from the scene's position: of the positions that are computed together.
fn around(start: f64) -> [f64; MANY] {
    std::array::from_fn(|i| start + 0.1 * i as f64)
}

/// The kernel of a scene, and two blocks of positions that are almost closed, with rates of the drive: one and many.
fn moved(text: &str) -> (Kernel, Single, Block<Many>) {
    let solution = solve(&Scene::read(text).expect("a good scene")).expect("it can be solved");
    let drive = Drive::new(&solution.mechanism, None).expect("it has a drive");
    let mut path = Path::new(&solution.mechanism, &solution.pose, drive).expect("it is regular");
    let start = 0.5 * (path.low() + path.high());
    let values = around(start);
    path.cover(Some(start), Some(values[MANY - 1])).expect("it can be reached");
    let kernel = Kernel::new(&solution.mechanism).expect("it has a drive");
    let mut one = path.walker().positions(&[start]).expect("it is on the path").clone();
    let mut many = path.many_walker().positions(&values).1.expect("they are on the path").clone();
    kernel.set_input(&mut one, 0, &[start + MOVED]);
    kernel.set_input(&mut many, 0, &Many(values.map(|value| value + MOVED)));
    kernel.set_rates(&mut one, 0, -1.5, 0.7);
    kernel.set_rates(&mut many, 0, -1.5, 0.7);
    (kernel, one, many)
}

/// The bits of all numbers in a block.
fn bits<R: Row>(block: &Block<R>) -> Vec<u64> {
    let vectors = [&block.turns, &block.points, &block.point_velocities, &block.point_accelerations];
    let numbers = [&block.slides, &block.omegas, &block.alphas, &block.speeds, &block.accelerations];
    let rows = vectors.into_iter().flatten().flatten().chain(numbers.into_iter().flatten());
    rows.flat_map(|row| row.as_ref()).map(|number| number.to_bits()).collect()
}

/// Without these shapes all numbers would be the same, and only slower.
#[test]
fn common_groups_have_their_shapes() {
    for name in ["examples/figure-2.json", "templates/four-bar.json"] {
        let (kernel, mut one, _) = moved(&files::read(name));
        assert!(kernel.begin_motions(OneByOne, &mut one, SURE, 1).is_all(), "{name}");
    }
}

/// In registers of the widest kind, of two numbers and number by number.
#[test]
fn at_once_has_the_bits_of_one_after_the_other() {
    for name in ["examples/figure-2.json", "templates/four-bar.json"] {
        let (kernel, one, many) = moved(&files::read(name));
        let [mut at_once, mut after] = [one.clone(), one];
        assert!(kernel.motions(&mut at_once, SURE).closed, "{name}");
        assert!(kernel.assemble(&mut after, SURE).closed, "{name}");
        kernel.rates(&mut after);
        assert_eq!(bits(&at_once), bits(&after), "{name}");
        let mut expected = many.clone();
        assert!(kernel.assemble_many(Level::new(), &mut expected, SURE).closed, "{name}");
        kernel.rates_many(Level::new(), &mut expected);
        for level in [Level::new(), Level::baseline()] {
            let mut block = many.clone();
            let begun = dispatch!(level, simd => kernel.begin_motions(Registers::<_, 2>(simd), &mut block, SURE, 1));
            assert!(kernel.finish_motions(level, &mut block, SURE, begun).closed, "{name}");
            assert_eq!(bits(&block), bits(&expected), "{name} {level:?}");
            kernel.rates_many(level, &mut block);
            assert_eq!(bits(&block), bits(&expected), "{name} {level:?}, the rates once more");
        }
    }
}
