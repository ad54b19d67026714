//! How much is tried: a sample in every `cargo test`, all of it where the environment says `KINEGON_SURVEY=full` (CONTRIBUTING.md has the command).

/// `sample`, or `all` in a full survey.
pub fn tried<T>(sample: T, all: T) -> T {
    match std::env::var("KINEGON_SURVEY") {
        Err(_) => sample,
        Ok(asked) if asked == "full" => all,
        Ok(asked) => panic!("KINEGON_SURVEY is {asked:?}; `full` asks for all that can be tried"),
    }
}
