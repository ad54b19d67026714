//! Prints every number of the example in Quintero et al. (2011) with a verdict.
//! Run with `cargo run --example published_numbers`.

#[path = "../columns/mod.rs"]
mod columns;
mod table;

use columns::{COLUMNS, wrap};
use std::error::Error;
use table::{Row, table};

/// Where the verdict begins.
const VERDICT: usize = 54;

fn main() -> Result<(), Box<dyn Error>> {
    println!("Numbers of the example in Quintero et al. (2011), Figure 2\n");
    println!("Eq.  quantity     printed   its drawing        exact  verdict");
    for section in table()? {
        println!("\n{}", section.title);
        for row in &section.rows {
            print_row(row);
        }
    }
    for paragraph in EXPLANATION {
        println!("\n{}", wrap(paragraph, COLUMNS).join("\n"));
    }
    Ok(())
}

fn print_row(row: &Row) {
    let (whole, decimals) = match row.printed.find('.') {
        Some(point) => row.printed.split_at(point),
        None => (row.printed, ""),
    };
    let verdict = match row.note.as_str() {
        "" => row.verdict.words().to_owned(),
        note => format!("{}: {note}", row.verdict.words()),
    };
    let verdict = wrap(&verdict, COLUMNS - VERDICT);
    println!(
        "{:<3}  {:<9}{whole:>6}{decimals:<5}  {:>10.4}  {:>12.6}   {}",
        row.equation, row.quantity, row.drawn, row.exact, verdict[0],
    );
    for line in &verdict[1..] {
        println!("{:VERDICT$}{line}", "");
    }
}

const EXPLANATION: [&str; 4] = [
    "\"Its drawing\" is what the paper's arithmetic gives on the paper's own drawing. The paper prints neither its crank \
     angle nor any coordinates; examples/figure-2-published.json is rebuilt from the lengths that it read. The crank stands \
     at 70° and every link has its length, but BE lies 0.00036° too low, so that D misses its guide by 0.00933 mm. \
     Readings are rounded to four decimals, and so are the angular velocities before they go into the accelerations.",
    "b s3 and g s3 are both 0.9998944 times what this drawing gives, as if their plan had been drawn with p b = \
     99.9894 in place of 100. That is likely, not proven.",
    "One slip costs much: for the length BS3 its horizontal component was read. The angular velocities do not depend on \
     it and the angular accelerations hardly, but the sliding velocity does, and the sliding acceleration comes out 2.3 times \
     too small. The drawing itself costs little: of the results, ω4, ω5 and α5 are one unit of the fourth decimal off.",
    "The other slips (the decimal point in v_BA, two digits in Eq. 51, the last digit of a^n_FG, the unit of a_S3S2) \
     move no other result by more than a few units of its last digit. Two last digits do not come out of this drawing: \
     that of a^n_FG and that of a_S3S2.",
];
