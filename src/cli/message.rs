use super::tables::{Given, Told};
use crate::Message;
use crate::check::CheckError;
use crate::cycle::CycleError;
use crate::mechanism::StructureError;
use crate::scene::SceneError;
use crate::text;
use crate::{Error, Problem};
use annotate_snippets::{Annotation, AnnotationKind, Group, Level, Renderer, Snippet};
use std::io::{self, Write};
use std::path::Path;

/// The text of a file that was read.
#[derive(Clone, Debug)]
pub struct Source {
    /// The file's name, or `stdin`.
    pub name: String,
    /// The whole text.
    pub text: String,
    /// What stands in the file, where tables from other files were written into the text.
    pub given: Option<Box<Given>>,
}

impl Source {
    pub(super) fn new(name: String, text: String) -> Source {
        Source { name, text, given: None }
    }

    /// The failure of an error in this text.
    pub(super) fn fail(&self, error: impl Into<Error>) -> Failure {
        let error = error.into();
        let Some(given) = &self.given else { return Failure::Scene(self.clone(), Box::new(error)) };
        let error = match error.in_scene().map(|finding| given.told(finding, &self.text)) {
            Some(Told::InTable(problem)) => return Failure::Misuse(problem),
            Some(Told::InScene(finding)) => finding.into(),
            None => error,
        };
        Failure::Scene(Source::new(self.name.clone(), given.text().to_owned()), Box::new(error))
    }

    /// What comes of this text, or its failure.
    pub(super) fn checked<T>(&self, done: Result<T, impl Into<Error>>) -> Result<T, Failure> {
        done.map_err(|error| self.fail(error))
    }

    /// The failure of an error in it that has no place there.
    pub(super) fn misuse(&self, error: &CheckError) -> Failure {
        Failure::Misuse(Problem { message: format!("{}: {error}", self.name).into(), hint: error.hint.clone() })
    }
}

/// Why a command did not do its task.
#[derive(Debug)]
pub enum Failure {
    /// An error of the library about a scene, or about a file that is read as strictly.
    Scene(Source, Box<Error>),
    /// A command or a file that is not understood.
    Misuse(Problem),
    /// A cause outside the program, such as a full disk; or a result that covers only a part of what was asked for.
    Outside(Problem),
    /// What the report itself says: the exit code.
    Reported(u8),
}

impl From<CheckError> for Failure {
    fn from(error: CheckError) -> Failure {
        Failure::Misuse(Problem { message: error.to_string().into(), hint: error.hint })
    }
}

impl Failure {
    /// A command or a file that is not understood: what is wrong, and what to try.
    pub(super) fn misuse(message: impl Into<Message>, hint: impl Into<Message>) -> Failure {
        Failure::Misuse(Problem::new(message).hint(hint))
    }

    /// A command or a file that is not understood, where nothing is known that could be tried.
    pub(super) fn unclear(message: impl ToString) -> Failure {
        Failure::Misuse(message.to_string().into())
    }

    /// What is asked for by an option, or in another file, does not fit the scene.
    pub(super) fn of_option(option: &str, SceneError { message, hint, .. }: SceneError) -> Failure {
        Failure::Misuse(Problem { message: format!("{option}: {message}").into(), hint })
    }

    /// A cause outside the program.
    pub(super) fn outside(message: impl ToString) -> Failure {
        Failure::Outside(message.to_string().into())
    }

    /// The failure to write an output.
    pub(super) fn unwritable(place: &Path, error: &io::Error) -> Failure {
        Failure::outside(format!("{} cannot be written: {error}", place.display()))
    }

    pub(super) fn exit_code(&self) -> u8 {
        match self {
            Failure::Scene(_, error) => match error.as_ref() {
                Error::Scene(_)
                | Error::Structure(StructureError::Scene(_))
                | Error::Quantity(_)
                | Error::Curves(_) => 2,
                Error::Structure(StructureError::Singular { .. }) | Error::Assembly(_) | Error::Motion(_) => 1,
                Error::Cycle(error) => match error {
                    CycleError::Singular { .. } | CycleError::OutOfReach { .. } => 1,
                    _ => 2,
                },
            },
            Failure::Misuse(_) => 2,
            Failure::Outside(_) => 1,
            Failure::Reported(code) => *code,
        }
    }

    /// The failure on one line, without the name of the file `place`; empty if it has no message.
    pub fn line(&self, place: &str) -> String {
        let (message, hint) = match self {
            Failure::Scene(_, error) => (error.to_string(), None),
            Failure::Misuse(problem) => (problem.message.to_string(), problem.hint.as_ref()),
            Failure::Outside(problem) => (problem.to_string(), None),
            Failure::Reported(_) => return String::new(),
        };
        let message = message.strip_prefix(place).unwrap_or(&message);
        let message = message.trim_start_matches([':', ' ']);
        // Several errors stand on lines of their own.
        let message = text::first_lines(message).replace(":\n  ", ": ").replace("\n  ", "; ");
        match hint {
            Some(hint) => format!("{message} ({hint})"),
            None => message,
        }
    }
}

/// Refuses a command or a file that is not understood: what is wrong, and what to try.
pub(super) fn refuse<T>(message: impl Into<Message>, hint: impl Into<Message>) -> Result<T, Failure> {
    Err(Failure::misuse(message, hint))
}

/// The outcome of a check whose report says the rest: how many forms or drawings are not passed, and how many not understood.
pub(super) fn passed(off: usize, broken: usize) -> Result<(), Failure> {
    match (off, broken) {
        (0, 0) => Ok(()),
        (_, 0) => Err(Failure::Reported(1)),
        _ => Err(Failure::Reported(2)),
    }
}

/// Shows a failure on stderr, in colours only on a terminal that supports them.
pub(super) fn show(failure: &Failure) {
    say(&match failure {
        Failure::Reported(_) => return,
        Failure::Scene(source, error) => shown(&source.name, &source.text, error),
        Failure::Misuse(problem) | Failure::Outside(problem) => rendered(Level::ERROR, problem, None),
    });
}

/// Shows on stderr that a signal has ended the program.
pub(super) fn stopped(is_complete: bool) {
    let message = match is_complete {
        false => "stopped before the files were complete; none was written",
        true => "stopped; the files are complete",
    };
    say(&rendered(Level::ERROR, &message.into(), None));
}

pub(super) fn note(text: &str) {
    say(&rendered(Level::NOTE, &text.into(), None));
}

pub(super) fn warn(text: &str) {
    say(&rendered(Level::WARNING, &text.into(), None));
}

/// Writes a report to stderr. Where that is closed, as behind a terminal that is gone, nobody can be told.
fn say(report: &str) {
    let _ = writeln!(anstream::stderr(), "{report}");
}

/// The message that the program shows on stderr for an error of the scene in the file `name`, with the lines of `text`
/// that are meant, in the colours of a terminal.
#[must_use]
pub fn shown(name: &str, text: &str, error: &Error) -> String {
    let problem = error.problem();
    let Some((finding, place)) = error.in_scene().and_then(|finding| Some((finding, finding.place.as_ref()?))) else {
        let message = format!("{name}: {}", problem.message).into();
        return rendered(Level::ERROR, &Problem { message, ..problem }, None);
    };
    let annotation = AnnotationKind::Primary.span(place.span.clone()).label(text::message(&finding.path));
    let snippet = Snippet::source(text::source(text)).path(text::shown(name)).annotation(annotation);
    rendered(Level::ERROR, &problem, Some(snippet))
}

/// A problem as a report, with the lines of a text that it is about.
fn rendered(level: Level<'_>, problem: &Problem, lines: Option<Snippet<'_, Annotation<'_>>>) -> String {
    let mut group = Group::with_title(level.primary_title(text::message(&problem.message.to_string()))).elements(lines);
    if let Some(hint) = &problem.hint {
        group = group.element(Level::HELP.message(text::message(&hint.to_string())));
    }
    Renderer::styled().render(&[group])
}
