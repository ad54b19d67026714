//! A four-bar linkage put together in Rust and solved at one crank angle: `cargo run --example quick_start`.
//! With a path, its figure goes there as SVG: `cargo run --example quick_start four-bar.svg`.

use kinegon::quantity::Quantity;
use kinegon::scene::{Builder, LengthUnit, NewLink, TimeUnit, Turn};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let crank = Turn::omega(10.0).angle(60.0);
    let scene = Builder::new(LengthUnit::Mm, TimeUnit::S)
        .title("Four-bar linkage")
        .ground("A", [0.0, 0.0])
        .ground("D", [160.0, 0.0])
        .link("1", NewLink::points(["A", "B"]).length("AB", 60.0).drive(crank))
        .link("2", NewLink::points(["B", "C"]).length("BC", 140.0))
        .link("3", NewLink::points(["D", "C"]).length("CD", 110.0))
        .near("C", [155.0, 110.0])
        .build()?;

    let solution = kinegon::solve(&scene)?;
    println!("link  omega in rad/s  alpha in rad/s²");
    for (id, link) in solution.mechanism.links() {
        let rates = solution.motion.body(id);
        println!("{:4}  {:14.6}  {:15.6}", link.name, rates.omega, rates.alpha);
    }
    if let Quantity::Vector(v) = solution.quantity("v(C)")? {
        println!("v(C) = ({:.6}, {:.6}) mm/s", v.x, v.y);
    }
    if let Some(path) = std::env::args().nth(1) {
        std::fs::write(path, solution.figure().svg())?;
    }
    Ok(())
}
