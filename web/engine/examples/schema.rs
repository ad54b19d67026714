//! Prints the JSON Schema of all that goes into the engine and comes out of it: `web/engine/schema.json`.

fn main() {
    println!("{:#}", kinegon_web::schema());
}
