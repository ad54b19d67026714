//! How much is tried: little in every `cargo test`, more before a change is taken, all of it in a survey (CONTRIBUTING.md has the
//! commands). Cases are the same at every size; a larger one has more of them.

use std::thread;

/// How much is tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Size {
    /// `cargo test`: enough to fail if the code is broken.
    Quick,
    /// `.ci/run`: enough to see a share of failures change. The environment says `KINEGON_SURVEY=usual`.
    Usual,
    /// All that can be tried, for hours. The environment says `KINEGON_SURVEY=full`.
    Full,
}

impl Size {
    /// The size that the environment asks for.
    pub fn asked() -> Size {
        match std::env::var("KINEGON_SURVEY").as_deref() {
            Err(_) => Size::Quick,
            Ok("usual") => Size::Usual,
            Ok("full") => Size::Full,
            Ok(asked) => panic!("KINEGON_SURVEY is {asked:?}; `usual` and `full` ask for more than a quick try"),
        }
    }

    /// Whether something is tried that is left out of quick runs; where it is left out stderr says so.
    pub fn is_usual(what: &str) -> bool {
        let is_usual = Size::asked() >= Size::Usual;
        if !is_usual {
            eprintln!("left out: {what}; KINEGON_SURVEY=usual has it");
        }
        is_usual
    }
}

/// A number of cases, or a bound that hangs on it, by size: quick, usual, full.
pub struct By<T>(T, T, T);

impl<T: Copy> By<T> {
    /// That of the size that is asked for.
    pub fn now(&self) -> T {
        match Size::asked() {
            Size::Quick => self.0,
            Size::Usual => self.1,
            Size::Full => self.2,
        }
    }
}

// How much each test tries. Of what is told in shares, as of students, the usual size is the least that shows anything.

// Numbers and their errors.

/// Groups for each family and parameter of `accuracy`.
pub const HARD_GROUPS: By<usize> = By(20, 20, 1000);
/// Mechanisms of each kind of `error_bounds`.
pub const BOUNDED: By<u64> = By(200, 2000, 250_000);
/// Mechanisms of `whole_errors`, each from lengths and as drawn.
pub const WHOLE: By<u64> = By(50, 1000, 20_000);
/// Random mechanisms in `centers`, of which about a fifth can be assembled.
pub const CENTERS: By<u64> = By(100, 1500, 10_000);
/// Mechanisms of each class in `kennedy` whose centres are constructed.
pub const CONSTRUCTED: By<usize> = By(6, 100, 667);
/// Positions of each starting scene in `whole_errors`.
pub const WHOLE_POSITIONS: By<u32> = By(1, 2, 60);

/// Degrees between two positions of `geared_errors`.
pub const GEARED_STEP: By<usize> = By(121, 19, 1);
/// Orders of each scene of `orders`, of the scenes every so many-th there, and of their figures.
pub const ORDERS: By<usize> = By(2, 5, 25);
pub const ORDERED_SCENES: By<usize> = By(16, 1, 1);
pub const ORDERED_FIGURES: By<usize> = By(48, 4, 1);

/// Mechanisms of `free_bodies`.
pub const FREE_BODIES: By<u64> = By(15, 300, 2000);

/// Mechanisms of `forces`.
pub const FORCED: By<u64> = By(30, 600, 2000);

// Positions and cycles.

/// Groups of each class of `planted_modes`.
pub const PLANTED_GROUPS: By<usize> = By(50, 800, 4000);
/// Random groups of `higher_class`.
pub const HIGHER_CLASS: By<usize> = By(3, 6, 120);
/// Of the larger trusses of `mode_counts` every so many-th is counted.
pub const COUNTED_TRUSSES: By<usize> = By(59, 7, 1);
/// Random groups there, each in three orders and turns, and further turns of one group.
pub const TURNED_GROUPS: By<u64> = By(9, 90, 3000);
pub const LOST_TURNS: By<usize> = By(2, 10, 40);
/// Four-bars of each kind of `cycle::four_bars`.
pub const FOUR_BARS: By<usize> = By(5, 10, 50);
/// Positions on the path of each of them.
pub const FOUR_BAR_POSITIONS: By<u32> = By(100, 300, 3000);
/// Mechanisms of each class of `cycle::branches`.
pub const BRANCHES: By<usize> = By(20, 60, 400);
/// The drive's step there, in turns or sizes of the mechanism.
pub const BRANCH_STEP: By<f64> = By(1.0 / 360.0, 1.0 / 360.0, 0.5 / 360.0);
/// One of so many mechanisms there has a limit of its drive, and one a drive that turns.
pub const BRANCH_ENDS: By<usize> = By(10, 4, 4);
/// Of how many positions of such branches one at most is unclear: few mechanisms may have one that is mostly so.
pub const BRANCH_UNCLEAR: By<usize> = By(10, 20, 20);
/// Pulls of each point of `pull`.
pub const PULLS: By<usize> = By(3, 12, 12);
/// Linkages in one scene that is drawn whole.
pub const DRAWN_LINKAGES: By<usize> = By(80, 150, 334);
/// Linkages of the smaller of two scenes whose times are compared.
pub const LINKAGES: By<usize> = By(30, 30, 60);
/// Positions of each drive in `editing::driven`.
pub const DRIVEN_POSITIONS: By<u32> = By(2, 24, 72);
/// Of the ways that each joint is pulled in `editing::pulled` every so many-th, by turns.
pub const PULLED: By<usize> = By(6, 1, 1);
/// Scenes of each of the `properties`; PROPTEST_CASES asks for another number.
pub const PROPERTIES: By<u32> = By(8, 48, 256);
/// Pictures of each animation in `hall`.
pub const HALL: By<usize> = By(3, 12, 36);
/// Of the sheets of all scenes there every so many-th; it shares no factor with the 8 of each scene.
pub const HALL_SHEETS: By<usize> = By(5, 1, 1);
/// Pictures of a cycle whose scales hold all of it.
pub const SCALES_OF_A_CYCLE: By<usize> = By(12, 72, 72);
/// Of the three units of `values` every so many-th, by turns.
pub const LISTED_UNITS: By<usize> = By(3, 1, 1);
/// Positions of a hand that moves a mechanism in `stage`, and those of a turn there.
pub const MOVED: By<u32> = By(8, 24, 40);
pub const TURN: By<usize> = By(4, 12, 72);
/// Positions of each scene in `gallery_measured`.
pub const GALLERY: By<usize> = By(4, 8, 12);
/// Of the six pages of each work sheet every so many-th, by turns.
pub const PAGES_EACH: By<usize> = By(3, 1, 1);
/// Of the sheets of `legible` every so many-th.
pub const LEGIBLE: By<usize> = By(199, 7, 1);
/// The most texts there that run together beside each other and above each other, that are struck through, that have no
/// room, and that are not listed either. The steps of the excavator on 16:9 alone, where a sample has them, leave out some 190.
pub const MISREAD: By<[usize; 5]> = By([0, 0, 0, 60, 0], [0, 0, 0, 400, 0], [0, 0, 0, 1000, 0]);

/// One in so many cases, where a test has many that are alike.
pub const ALIKE: By<usize> = By(5, 1, 1);
/// Every so many-th kind of mechanism, where each takes long and what is looked at hangs little on the kind.
pub const KINDS: By<usize> = By(6, 1, 1);

// Students.

/// Exercises of each kind that are drawn rightly.
pub const RIGHT_EXERCISES: By<usize> = By(1, 1, 12);
/// Exercises of each kind in which mistakes are made.
pub const WRONG_EXERCISES: By<usize> = By(1, 1, 4);
/// Sheets with mistakes, and honest ones.
pub const SHEETS: By<usize> = By(30, 30, 1500);
/// Drawings of each mistake of `planted_mistakes`.
pub const PLANTED_MISTAKES: By<usize> = By(1, 1, 40);
/// Drawings without a mistake there.
pub const CLEAN: By<usize> = By(10, 20, 400);
/// Of each published set every number, or this many.
pub const PUBLISHED_NUMBERS: By<usize> = By(1, 2, usize::MAX);
/// Of the changes of a published number every so many-th.
pub const PUBLISHED_CHANGES: By<usize> = By(3, 3, 1);
/// Sets with a wrong number, at least.
pub const PUBLISHED_TRIES: By<usize> = By(15, 30, 500);
/// Forms of each scene of `cheats` that are filled in by somebody who knows nothing.
pub const CHEATS: By<usize> = By(9, 90, 2000);
/// Exercises of each of the seven kinds of `strategies`.
pub const HANDED_IN: By<usize> = By(2, 3, 12);
/// Keys of each kind of exercise that must not be cut.
pub const KEYS: By<u64> = By(1, 2, 16);

// Photographs.

/// Sheets of each kind, and pixels of the longer edge.
pub const PLACES: By<(u64, usize)> = By((1, 1600), (1, 1600), (130, 4032));
/// Every so many-th kind of photograph: from flat sheets to hard ones.
pub const PLACE_KINDS: By<usize> = By(7, 1, 1);
/// The share of places that lie within their bands.
pub const WITHIN_BANDS: By<f64> = By(0.9, 0.9, 0.95);
/// Uneven and blurred sheets.
pub const UNEVEN: By<(u64, usize)> = By((2, 1200), (4, 1200), (100, 2400));
/// Pictures of other things.
pub const OTHER_THINGS: By<u64> = By(1, 3, 200);
/// Pictures of any pixels.
pub const ANY_PIXELS: By<u64> = By(30, 30, 3000);
/// Drawings of which points are proposed.
pub const PROPOSED: By<(u64, usize)> = By((1, 1200), (4, 1600), (300, 2400));
/// The share of points that may be proposed elsewhere.
pub const WRONGLY_PROPOSED: By<f64> = By(0.03, 0.03, 0.01);
/// By how much fewer sheets with a mistake are told of all than from the typed form.
pub const TAPPED_LESS: By<f64> = By(0.2, 0.2, 0.05);
/// Photographs with broken bytes.
pub const BROKEN_BYTES: By<usize> = By(3, 6, 400);

// The page.

/// Series of random gestures.
pub const GESTURES: By<u64> = By(1, 1, 20);
/// Looks in which axe goes through all panels: light, dark, on a telephone.
pub const LOOKS: By<usize> = By(1, 3, 3);
/// Of all scenes every so many-th plays in the page.
pub const PLAYED: By<usize> = By(24, 12, 1);
/// Of a scene's text every so many-th beginning is typed.
pub const BEGINNINGS: By<usize> = By(5, 1, 1);

// Other programs.

/// Figures of `rasters` that another program draws.
pub const RASTERS: By<usize> = By(2, 5, 5);
/// Every so many-th figure is given to LaTeX alone.
pub const TYPESET: By<usize> = By(4, 1, 1);

/// Cases by number on all cores: what each core has seen, in no order that means anything.
pub fn on_all_cores<T: Default + Send>(count: u64, case: impl Fn(u64, &mut T) + Sync) -> Vec<T> {
    let cores = thread::available_parallelism().map_or(1, |n| n.get() as u64);
    thread::scope(|scope| {
        let work = |core: u64| {
            let case = &case;
            scope.spawn(move || {
                let mut seen = T::default();
                (core..count).step_by(cores as usize).for_each(|number| case(number, &mut seen));
                seen
            })
        };
        let threads: Vec<_> = (0..cores).map(work).collect();
        threads.into_iter().map(|thread| thread.join().expect("a case went through")).collect()
    })
}
