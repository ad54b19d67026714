//! Values asked for on the command line: their unit, those without room, and what is refused.

use support::files;
use support::program::{kinegon, scratch, stderr};

fn run(arguments: &[&str]) -> std::process::Output {
    kinegon().args(arguments).current_dir(files::path(".")).output().expect("the program runs")
}

#[test]
fn values_have_the_unit_asked_for() {
    let svg = |values: &str| {
        let output = run(&["draw", "tests/lecture/shaper.json", values, "-o", "-"]);
        assert!(output.status.success(), "{}", stderr(&output));
        String::from_utf8(output.stdout).expect("SVG is text")
    };
    assert!(svg("--values").contains("mm/s"));
    // The scales keep the scene's unit.
    assert!(svg("--values=m").matches(" m/s").count() > 4);
    assert!(!svg("--values=none").contains("-value-"));
}

/// What stands nowhere is named, once and with what helps.
#[test]
fn values_without_room_are_named() {
    let folder = scratch("values-without-room");
    let [svg, next] = ["valve.svg", "valve-2.svg"].map(|name| folder.join(name));
    let output = run(&["draw", "tests/lecture/valve.json", "--values", "-o", svg.to_str().expect("UTF-8")]);
    assert!(output.status.success(), "{}", stderr(&output));
    let said = stderr(&output);
    let notes: Vec<&str> = said.lines().filter(|line| line.contains("no room for the values of")).collect();
    assert_eq!(notes.len(), 1, "{said}");
    assert!(notes[0].contains("next sheet"), "{said}");
    let [svg, next] = [svg, next].map(|path| std::fs::read_to_string(path).expect("a sheet"));
    let names = notes[0].split("of ").nth(1).and_then(|rest| rest.split(';').next()).expect("names");
    // Values that are the same have one label.
    let first = |names: &str| names.split(" = ").next().unwrap_or_default().to_owned();
    for name in names.split(", ").map(first).filter(|name| name.starts_with("v_") && !name.contains('(')) {
        assert!(!svg.contains(&format!("id=\"velocity-value-{name}\"")), "{name}");
        assert!(next.contains(&format!("listed-velocity-value-{name}-name")), "{name}");
    }
    assert!(!stderr(&run(&["draw", "tests/lecture/valve.json", "-o", "-"])).contains("no room for the values"));
}

#[test]
fn a_unit_that_is_none_is_refused() {
    let output = run(&["draw", "tests/lecture/valve.json", "--values=furlong", "-o", "-"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("furlong"), "{}", stderr(&output));
}
