use crate::check::CheckError;
use crate::cycle::CycleError;
use crate::mechanism::StructureError;
use crate::scene::SceneError;
use crate::text;
use crate::{Error, Problem};
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use std::io::Write;

/// The text of a file that was read.
#[derive(Clone, Debug)]
pub struct Source {
    /// The file's name, or `stdin`.
    pub name: String,
    /// The whole text.
    pub text: String,
}

impl Source {
    /// The failure of an error in this text.
    pub(super) fn fail(&self, error: impl Into<crate::Error>) -> Failure {
        Failure::Scene(self.clone(), Box::new(error.into()))
    }

    /// The failure of an error in it that has no place there.
    pub(super) fn misuse(&self, error: &CheckError) -> Failure {
        Failure::Misuse(Problem { message: format!("{}: {error}", self.name), hint: error.hint.clone() })
    }
}

/// Why a command did not do its task.
#[derive(Debug)]
pub enum Failure {
    /// An error of the library about a scene, or about a file that is read as strictly.
    Scene(Source, Box<Error>),
    /// A command or a file that is not understood.
    Misuse(Problem),
    /// A cause outside the program, such as a full disk.
    Outside(Problem),
    /// A result that covers only a part of what was asked for: why.
    Partly(Problem),
    /// A check that is not passed; the report says why.
    NotPassed,
    /// A class with files that are not understood; the report says which.
    NotUnderstood,
}

impl From<CheckError> for Failure {
    fn from(error: CheckError) -> Failure {
        Failure::Misuse(Problem { message: error.to_string(), hint: error.hint })
    }
}

impl Failure {
    /// A command or a file that is not understood: what is wrong, and what to try.
    pub(super) fn misuse(message: impl Into<String>, hint: impl Into<String>) -> Failure {
        Failure::Misuse(Problem::new(message).hint(hint))
    }

    /// A command or a file that is not understood, where nothing is known that could be tried.
    pub(super) fn unclear(message: impl ToString) -> Failure {
        Failure::Misuse(message.to_string().into())
    }

    /// What is asked for by an option does not fit the scene.
    pub(super) fn of_option(option: &str, SceneError { message, hint, .. }: SceneError) -> Failure {
        Failure::Misuse(Problem { message: format!("{option}: {message}"), hint })
    }

    /// A cause outside the program.
    pub(super) fn outside(message: impl ToString) -> Failure {
        Failure::Outside(message.to_string().into())
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
            Failure::Misuse(_) | Failure::NotUnderstood => 2,
            Failure::Outside(_) | Failure::Partly(_) | Failure::NotPassed => 1,
        }
    }

    /// The failure on one line, without the name of the file `place`; empty if it has no message.
    pub fn line(&self, place: &str) -> String {
        let (message, hint) = match self {
            Failure::Scene(_, error) => (error.to_string(), None),
            Failure::Misuse(problem) => (problem.message.clone(), problem.hint.as_deref()),
            Failure::Outside(problem) | Failure::Partly(problem) => (problem.to_string(), None),
            Failure::NotPassed | Failure::NotUnderstood => return String::new(),
        };
        let message = message.strip_prefix(place).unwrap_or(&message);
        let message = message.trim_start_matches([':', ' ']);
        // Several errors stand on lines of their own.
        let message = message.replace(":\n  ", ": ").replace("\n  ", "; ");
        match hint {
            Some(hint) => format!("{message} ({hint})"),
            None => message,
        }
    }
}

/// Shows a failure on stderr, in colours only on a terminal that supports them.
pub(super) fn show(failure: &Failure) {
    let report = match failure {
        Failure::NotPassed | Failure::NotUnderstood => return,
        Failure::Scene(source, error) => shown(&source.name, &source.text, error),
        Failure::Misuse(problem) | Failure::Outside(problem) | Failure::Partly(problem) => {
            without_place(&problem.message, problem.hint.as_deref())
        }
    };
    say(&report);
}

/// Shows on stderr that a signal has ended the program.
pub(super) fn stopped(is_complete: bool) {
    let message = match is_complete {
        false => "stopped before the files were complete; none was written",
        true => "stopped; the files are complete",
    };
    say(&without_place(message, None));
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
    match error.in_scene() {
        Some(finding) => with_place(name, text, finding),
        None => without_place(&format!("{name}: {}", problem.message), problem.hint.as_deref()),
    }
}

pub(super) fn note(text: &str) {
    let report = [Group::with_title(Level::NOTE.primary_title(text::message(text)))];
    say(&Renderer::styled().render(&report));
}

pub(super) fn warn(text: &str) {
    let report = [Group::with_title(Level::WARNING.primary_title(text::message(text)))];
    say(&Renderer::styled().render(&report));
}

fn without_place(message: &str, hint: Option<&str>) -> String {
    let mut group = Group::with_title(Level::ERROR.primary_title(text::message(message)));
    if let Some(hint) = hint {
        group = group.element(Level::HELP.message(text::message(hint)));
    }
    Renderer::styled().render(&[group])
}

/// A finding with the lines of the scene's text that it is about.
fn with_place(name: &str, text: &str, finding: &SceneError) -> String {
    let Some(place) = &finding.place else {
        return without_place(&format!("{name}: {}", finding.message), finding.hint.as_deref());
    };
    let annotation = AnnotationKind::Primary.span(place.span.clone()).label(text::message(&finding.path));
    let snippet = Snippet::source(text::source(text)).path(text::shown(name)).annotation(annotation);
    let mut group = Group::with_title(Level::ERROR.primary_title(text::message(&finding.message))).element(snippet);
    if let Some(hint) = &finding.hint {
        group = group.element(Level::HELP.message(text::message(hint)));
    }
    Renderer::styled().render(&[group])
}
