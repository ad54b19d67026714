//! Parts of the program that no command line reaches alone: names of students' pages, forms and their exercises, help, panics.

mod caught {
    use kinegon::cli::pieces::caught;

    #[test]
    fn a_panic_becomes_a_message() {
        assert_eq!(caught(|| 7), Ok(7));
        let none: [u8; 0] = [];
        let message = caught(|| none[none.len()]).expect_err("it has no elements");
        for part in ["command_parts.rs", "index out of bounds: the len is 0", "please report"] {
            assert!(message.contains(part), "{message}");
        }
    }
}

mod exercises {
    use kinegon::cli::forms::{ExerciseFiles, ExerciseFolder};
    use kinegon::text::Untrusted;
    use std::path::{Path, PathBuf};

    fn folder(names: &[&str]) -> ExerciseFolder {
        let one = |name: &&str| ExerciseFiles { name: (*name).to_owned(), scene: PathBuf::new(), folder: None };
        ExerciseFolder { folder: "class".into(), all: names.iter().map(one).collect() }
    }

    #[test]
    fn a_form_belongs_to_the_exercise_that_it_its_file_or_its_folder_names() {
        let some = folder(&["bar-7-1", "four-bar-7-1", "four-bar-7-12", "four-bar-7-2"]);
        let of = |named: Option<&str>, path: &str| some.of_form(named.map(Untrusted::from).as_ref(), Path::new(path));
        assert_eq!(of(Some("four-bar-7-2"), "four-bar-7-1/four-bar-7-1.csv"), Ok(3));
        assert_eq!(of(Some("Four-Bar-7-2"), "x.csv"), Ok(3));
        assert_eq!(of(None, "four-bar-7-2 Ana.csv"), Ok(3));
        assert_eq!(of(None, "Ana_FOUR-BAR-7-12.json"), Ok(2));
        assert_eq!(of(None, "four-bar-7-1.json"), Ok(1));
        assert_eq!(of(None, "four-bar-7-1/four-bar-7-2 Ana.csv"), Ok(3));
        assert_eq!(of(None, "four-bar-7-1/late/Ana.csv"), Ok(1));
        assert_eq!(of(None, "Ana.four-bar-7-2.csv"), Ok(3));
    }

    #[test]
    fn what_is_not_clear_is_said() {
        let some = folder(&["four-bar-7-1", "four-bar-7-2"]);
        let of = |named: Option<&str>, path: &str| {
            some.of_form(named.map(Untrusted::from).as_ref(), Path::new(path)).expect_err("nobody can tell")
        };
        let unknown = of(Some("four-bar-7-3"), "four-bar-7-1.csv");
        assert!(unknown.contains("`four-bar-7-3` is not in class"), "{unknown}");
        assert!(unknown.contains("there are four-bar-7-1, four-bar-7-2"), "{unknown}");
        assert!(of(None, "four-bar-7-1 four-bar-7-2.csv").contains("several exercises: four-bar-7-1, four-bar-7-2"));
        assert!(of(None, "four-bar-7-13.csv").contains("does not say to which exercise"));
        assert!(of(None, "Ana.csv").contains("there are four-bar-7-1, four-bar-7-2"));
        let many: Vec<String> = (1..=30).map(|i| format!("x-{i}")).collect();
        let many: Vec<&str> = many.iter().map(String::as_str).collect();
        let none = folder(&many).of_form(None, Path::new("Ana.csv")).expect_err("nobody can tell");
        assert!(none.contains("x-6 and 24 more"), "{none}");
    }

    #[test]
    fn a_single_exercise_has_all_forms_that_name_none() {
        assert_eq!(folder(&["a-1"]).of_form(None, Path::new("Ana.csv")), Ok(0));
        assert!(folder(&["a-1"]).of_form(Some(&"a-2".into()), Path::new("Ana.csv")).is_err());
    }
}

mod help {
    use kinegon::cli::help::{GROUPS, command};

    #[test]
    fn every_command_is_in_one_group() {
        let mut grouped: Vec<&str> = GROUPS.iter().flat_map(|(_, names)| names.iter().copied()).collect();
        let command = command();
        let mut known: Vec<&str> = command.get_subcommands().map(clap::Command::get_name).collect();
        grouped.sort_unstable();
        known.sort_unstable();
        assert_eq!(grouped, known);
    }

    /// The words of a command as a shell would hand them over.
    fn words(line: &str) -> Vec<String> {
        let parts = line.split('"').enumerate();
        let quoted = parts.flat_map(|(index, part)| match index % 2 {
            0 => part.split(' ').filter(|word| !word.is_empty()).map(str::to_owned).collect(),
            _ => vec![part.to_owned()],
        });
        quoted.collect()
    }

    #[test]
    fn every_command_has_examples_that_are_understood() {
        for known in command().get_subcommands().filter(|known| known.get_name() != "help") {
            let text = known.get_after_help().expect("it has examples").to_string();
            let examples = text.split("Examples:\n").nth(1).expect("they come last");
            for line in examples.lines().filter(|line| line.starts_with("  kinegon")) {
                // Two spaces, and what it is for.
                let line = line.trim_start().split("  ").next().expect("a split has a first part");
                for part in line.split(" | ").filter(|part| part.starts_with("kinegon")) {
                    let part = part.split(" >").next().expect("a split has a first part");
                    command().try_get_matches_from(words(part)).expect(line);
                }
            }
        }
    }
}

mod pages {
    use kinegon::cli::feedback::{LONGEST, page_names};

    #[test]
    fn names_of_pages_are_safe_and_different() {
        let forms = ["Ana.csv", "Ana.json", "ana.csv", "7-1/Ben.csv", "7-1-Ben.csv", "a:b?.csv", "CON.csv", "...csv"];
        let names = page_names(&forms);
        let expected = ["Ana-csv", "Ana-json", "ana-csv-2", "7-1-Ben-csv", "7-1-Ben-csv-2", "a-b-", "CON-form", "form"];
        assert_eq!(names, expected);
        let long = format!("{}.csv", "ñ".repeat(300));
        let names = page_names(&[&long, &long]);
        assert!(names[0].len() <= LONGEST + 4 && names[0].starts_with("ñ"), "{}", names[0]);
        assert_ne!(names[0], names[1]);
    }
}
