use super::files::Source;
use crate::Error;
use crate::cycle::CycleError;
use crate::mechanism::StructureError;
use crate::scene::SceneError;
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

/// Why a command did not do its task.
#[derive(Debug)]
pub(super) enum Failure {
    /// The library's finding about a scene.
    Scene(Source, Box<Error>),
    /// A command or a file that cannot be understood: what, and what to try.
    Misuse(String, Option<String>),
    /// Something outside, such as a full disk.
    Outside(String),
    /// The work is done as far as it could be: what stands in the way of the rest.
    Partly(String),
    /// A check that is not passed; everything is said.
    NotPassed,
    /// Files of a class that are not understood; everything is said.
    NotUnderstood,
    /// The person has stopped it.
    Interrupted,
}

impl Failure {
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
            Failure::Misuse(..) | Failure::NotUnderstood => 2,
            Failure::Outside(_) | Failure::Partly(_) | Failure::NotPassed => 1,
            // As shells report a program that Ctrl-C has ended.
            Failure::Interrupted => 130,
        }
    }

    /// The failure on one line for a list that names the file `place` already.
    pub(super) fn line(&self, place: &str) -> String {
        let (message, hint) = match self {
            Failure::Scene(_, error) => (error.to_string(), None),
            Failure::Misuse(message, hint) => (message.clone(), hint.as_deref()),
            Failure::Outside(message) | Failure::Partly(message) => (message.clone(), None),
            Failure::NotPassed | Failure::NotUnderstood | Failure::Interrupted => {
                return String::new();
            }
        };
        let message = message.strip_prefix(place).unwrap_or(&message);
        let message = message.trim_start_matches([':', ' ']);
        match hint {
            Some(hint) => format!("{message} ({hint})"),
            None => message.to_owned(),
        }
    }
}

/// Shows a failure on stderr; colours only on a terminal that wants them.
pub(super) fn show(failure: &Failure) {
    let report = match failure {
        Failure::NotPassed | Failure::NotUnderstood => return,
        Failure::Scene(source, error) => shown(&source.name, &source.text, error),
        Failure::Misuse(message, hint) => plain(message, hint.as_deref()),
        Failure::Outside(message) | Failure::Partly(message) => plain(message, None),
        Failure::Interrupted => plain("stopped before the table was complete; no file was written", None),
    };
    anstream::eprintln!("{report}");
}

/// What the program shows on stderr for an error of the scene in the file `name`, with the part of its text that is meant, in the
/// colours of a terminal.
#[must_use]
pub fn shown(name: &str, text: &str, error: &Error) -> String {
    match error {
        Error::Scene(finding) | Error::Structure(StructureError::Scene(finding)) => in_place(name, text, finding),
        other => plain(&format!("{name}: {other}"), None),
    }
}

/// Shows a remark on stderr.
pub(super) fn note(text: &str) {
    let report = [Group::with_title(Level::NOTE.primary_title(text))];
    anstream::eprintln!("{}", Renderer::styled().render(&report));
}

/// Shows a warning on stderr.
pub(super) fn warn(text: &str) {
    let report = [Group::with_title(Level::WARNING.primary_title(text))];
    anstream::eprintln!("{}", Renderer::styled().render(&report));
}

fn plain(message: &str, hint: Option<&str>) -> String {
    // A hint may stand in the message itself, as the part after "try:".
    let (message, own) = match message.split_once("\n  try: ") {
        Some((message, own)) => (message, Some(own)),
        None => (message, None),
    };
    let mut group = Group::with_title(Level::ERROR.primary_title(message));
    if let Some(hint) = hint.or(own) {
        group = group.element(Level::HELP.message(hint));
    }
    Renderer::styled().render(&[group])
}

/// A finding with its place in the scene's text.
fn in_place(name: &str, text: &str, finding: &SceneError) -> String {
    let Some(place) = &finding.place else {
        return plain(&format!("{name}: {}", finding.message), finding.hint.as_deref());
    };
    let annotation = AnnotationKind::Primary.span(place.span.clone()).label(finding.path.as_str());
    let snippet = Snippet::source(text).path(name).annotation(annotation);
    let mut group = Group::with_title(Level::ERROR.primary_title(finding.message.as_str())).element(snippet);
    if let Some(hint) = &finding.hint {
        group = group.element(Level::HELP.message(hint.as_str()));
    }
    Renderer::styled().render(&[group])
}
