//! `web/engine/schema.json` is the schema of the engine's types. `KINEGON_WRITE=1 cargo test -p kinegon-web --features types --test types`
//! makes it anew, `web/build --types` the page's types from it.

#[test]
fn the_schema_is_current() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/schema.json");
    let now = format!("{:#}\n", kinegon_web::schema());
    // A checkout may have turned the line ends.
    if std::fs::read_to_string(path).unwrap_or_default().replace("\r\n", "\n") == now {
        return;
    }
    assert!(std::env::var_os("KINEGON_WRITE").is_some(), "{path} is not of the types: KINEGON_WRITE=1 makes it anew");
    std::fs::write(path, now).expect("it can be written");
}
