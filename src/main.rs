use kinegon::{
    format,
    mechanism::mechanism,
    motion::{Order, motion},
    plan::construction,
    position::pose,
    scene::Scene,
};
fn main() {
    let path = std::env::args().nth(2).unwrap();
    let text = if path == "-" {
        std::io::read_to_string(std::io::stdin()).unwrap()
    } else {
        std::fs::read_to_string(path).unwrap()
    };
    let run = || -> Result<String, Box<dyn std::error::Error>> {
        let scene = Scene::read(&text)?;
        let m = mechanism(&scene)?;
        let p = pose(&m, &scene.near)?;
        let mo = motion(&m, &p, Order::Acceleration)?;
        let c = construction(&m, &p, &mo);
        if std::env::args().nth(1).unwrap() == "draw" {
            let d = kinegon::drawing::figure(&scene, &m, &p, &c);
            let s = format::svg(&d);
            std::fs::write("/tmp/fig.png", format::png(&s, 150.0)?)?;
            return Ok(s);
        }
        let r = format::result(format::Solved {
            units: scene.units,
            mechanism: &m,
            pose: &p,
            motion: &mo,
            construction: &c,
        });
        Ok(serde_json::to_string(&r)?)
    };
    match run() {
        Ok(s) => println!("{s}"),
        Err(e) => {
            eprintln!("{e}");
            std::process::exit(1)
        }
    }
}
