//! A crank-rocker put together in Rust and moved once around: `cargo run --example sweep`.
//! Prints a table of its rocker, then where the rocker turns back, then one position by name.

use kinegon::Solution;
use kinegon::cycle::{Drive, Path, Steps, Sweep};
use kinegon::quantity::{Quantity, QuantityRequest};
use kinegon::scene::{Builder, LengthUnit, NewLink, TimeUnit, Turn};
use kinegon::words::Wording;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = Builder::new(LengthUnit::Mm, TimeUnit::S)
        .ground("A", [0.0, 0.0])
        .ground("D", [160.0, 0.0])
        .link("1", NewLink::points(["A", "B"]).length("AB", 60.0).drive(Turn::omega(10.0).angle(60.0)))
        .link("2", NewLink::points(["B", "C"]).length("BC", 140.0))
        .link("3", NewLink::points(["D", "C"]).length("CD", 110.0))
        .near("C", [155.0, 110.0])
        .build()?;
    let Solution { mechanism, pose, .. } = kinegon::solve(&scene)?;

    // The branch of this pose while the crank turns, followed once around.
    let mut path = Path::new(&mechanism, &pose, Drive::new(&mechanism, Some("1"))?)?;
    path.cover(Some(0.0), Some(360.0))?;

    // A table by names; `None` stands where a position is singular.
    let names = ["angle(3)", "omega(3)", "alpha(3)", "v(C).size"].map(String::from);
    let sweep = Sweep::new(&path, Steps::new(0.0, 360.0, 30.0)?, Some(&names))?;
    let header = sweep.header();
    println!("{}", header.iter().map(|name| format!("{name:>12}")).collect::<String>());
    for row in sweep.rows(0..sweep.steps.count()).chunks(header.len()) {
        let numbers = row.iter().map(|x| x.map_or("-".into(), |x| format!("{x:.4}")));
        println!("{}", numbers.map(|x| format!("{x:>12}")).collect::<String>());
    }

    // Limit and dead centres, to 1e-12 of a turn.
    for event in path.events() {
        println!("{}", path.told(&event, &Wording::default()));
    }

    // Any position, any quantity by name; names are looked up once.
    let coupler = QuantityRequest::new("a_n(C/B)", &mechanism)?;
    let mut walker = path.walker();
    let position = walker.position(123.4).ok_or("that position is singular")?;
    if let Quantity::Vector(a) = coupler.value(&position, None, None)? {
        println!("a_n(C/B) = ({:.3}, {:.3}) mm/s² at 123.4°", a.x, a.y);
    }
    Ok(())
}
