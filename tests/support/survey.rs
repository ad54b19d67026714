//! How much is tried: a sample in every `cargo test`, all of it where the environment says `KINEGON_SURVEY=full` (CONTRIBUTING.md has the command).

use std::thread;

/// `sample`, or `all` in a full survey.
pub fn tried<T>(sample: T, all: T) -> T {
    match std::env::var("KINEGON_SURVEY") {
        Err(_) => sample,
        Ok(asked) if asked == "full" => all,
        Ok(asked) => panic!("KINEGON_SURVEY is {asked:?}; `full` asks for all that can be tried"),
    }
}

/// Cases by number on all cores: what each core has seen, in no order that means anything.
pub fn on_all_cores<T: Default + Send>(count: u64, case: impl Fn(u64, &mut T) + Sync) -> Vec<T> {
    let cores = thread::available_parallelism().map_or(1, |n| n.get() as u64);
    thread::scope(|scope| {
        let work = |core: u64| {
            let case = &case;
            scope.spawn(move || {
                let mut seen = T::default();
                (core..count).step_by(cores as usize).for_each(|number| case(number, &mut seen));
                seen
            })
        };
        let threads: Vec<_> = (0..cores).map(work).collect();
        threads.into_iter().map(|thread| thread.join().expect("a case went through")).collect()
    })
}
