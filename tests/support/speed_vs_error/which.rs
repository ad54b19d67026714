//! The ways from lengths to rates in words: which to take when.

use super::document::{duration, relative, spread};
use super::routes::{CLASSES, Hardness, Route, Routes};
use std::fmt::Write;

/// What is measured, and what follows from it.
const INTRODUCTION: &str = "
## Which to take when

From a scene's text to every ω and α, for mechanisms of all classes by lot (`tests/support/speed_vs_error/routes.rs`): with pins only and with sliders, ordinary ones and such as are
hard for one reason. The truth has 256 bits and starts from the decimals as they are written. Errors are parts of the largest ω or α of the mechanism.

![Error against time, by class and way](accuracy-which.svg)

- **Many positions** (curves, films, studies, a joint that is pulled): f64. A row costs a fraction of a microsecond, and of ordinary mechanisms twelve digits or more are right; nothing says how many of a hard one.
- **One position whose number decides something** (what is printed, a student's mark): proved. It costs some hundreds of rows, far less than a keystroke takes, and every stated error holds whatever the mechanism.
  `--errors` of `kinegon sweep` gives the same for each row of a table, at that price.
- **f64 with bound** is the step on the way to it: its condition says how much errors of the given numbers grow, its bound only what its own computation loses at the position as rounded.
- **256 bits** are for holding the others to the truth. Nobody needs them for a mechanism: where twice the digits prove nothing, the position is singular.
";

/// The section of the page.
pub fn section(routes: &Routes) -> String {
    let mut text = String::from(INTRODUCTION);
    text.push_str("\nTime for one position, the mean of ordinary mechanisms; of higher class nearly all is the search for the assembly nearest to `near`:\n\n| way |");
    CLASSES.iter().for_each(|class| text.push_str(&format!(" {class} |")));
    text.push_str(" what it is |\n|---|---:|---:|---:|---:|---|\n");
    for route in Route::ALL {
        let _ = write!(text, "| {} |", route.name());
        routes.times.iter().for_each(|times| text.push_str(&format!(" {} |", duration(times[route as usize]))));
        let _ = writeln!(text, " {} |", route.says());
    }
    text.push_str(
        "\nErrors are told by median and largest; \"stated\" is the proved bound. A bound over the true error (the last column: the median of all rates that err) says how many times too wide it is.\n\n\
         | class | joints | hard by | proved | condition, median | f64 | one position | stated | stated over true |\n\
         |---|---|---|---:|---:|---:|---:|---:|---:|\n",
    );
    for class in CLASSES {
        for cell in Hardness::ALL.into_iter().flat_map(|hardness| routes.of(class, hardness)) {
            let joints = if cell.sliders { "sliders" } else { "pins" };
            let [table, position, stated] = [0, 1, 2].map(|way| spread(cell.errors.iter().map(|errors| errors[way])));
            let _ = writeln!(
                text,
                "| {class} | {joints} | {} | {} of {} | {} | {table} | {position} | {stated} | {} |",
                cell.hardness.name(),
                cell.proved,
                cell.solved,
                relative(cell.condition),
                relative(super::survey::median(cell.pessimism.iter().copied()).unwrap_or(f64::NAN)),
            );
        }
    }
    text
}
