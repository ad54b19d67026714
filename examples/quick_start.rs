//! A four-bar linkage put together in Rust and solved at one crank angle: `cargo run --example quick_start`.
//! With a path, its figure goes there as SVG: `cargo run --example quick_start four-bar.svg`.

use kinegon::scene::{Builder, LengthUnit, NewLink, TimeUnit, Turn};
use kinegon::{drawing, format, mechanism, motion, plan, position};

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

    let mechanism = mechanism::mechanism(&scene)?;
    let pose = position::pose(&mechanism, &scene.near)?;
    let motion = motion::motion(&mechanism, &pose, motion::Order::Acceleration)?;
    let plans = plan::construction(&mechanism, &pose, &motion);

    println!("link  omega in rad/s  alpha in rad/s²");
    for (id, link) in mechanism.links() {
        let rates = motion.body(id);
        println!("{:4}  {:14.6}  {:15.6}", link.name, rates.omega, rates.alpha);
    }

    let quantity = |name| plan::quantity(name, &mechanism, &pose, &motion, &plans, None);
    if let plan::Quantity::Vector(v) = quantity("v(C)")? {
        println!("v(C) = ({:.6}, {:.6}) mm/s", v.x, v.y);
    }

    if let Some(path) = std::env::args().nth(1) {
        let figure = drawing::figure(&scene, &mechanism, &pose, &plans);
        std::fs::write(path, format::svg(&figure))?;
    }
    Ok(())
}
