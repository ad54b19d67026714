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
                Error::Structure(StructureError::Singular { .. })
                | Error::Assembly(_)
                | Error::Motion(_) => 1,
                Error::Cycle(error) => match error {
                    CycleError::Singular { .. } | CycleError::OutOfReach { .. } => 1,
                    _ => 2,
                },
            },
            Failure::Misuse(..) => 2,
            Failure::Outside(_) | Failure::Partly(_) => 1,
            // As shells report a program that Ctrl-C has ended.
            Failure::Interrupted => 130,
        }
    }
}

/// Shows a failure on stderr; colours only on a terminal that wants them.
pub(super) fn show(failure: &Failure) {
    match failure {
        Failure::Scene(source, error) => match error.as_ref() {
            Error::Scene(finding) | Error::Structure(StructureError::Scene(finding)) => {
                show_place(source, finding);
            }
            other => show_plain(&format!("{}: {other}", source.name), None),
        },
        Failure::Misuse(message, hint) => show_plain(message, hint.as_deref()),
        Failure::Outside(message) | Failure::Partly(message) => show_plain(message, None),
        Failure::Interrupted => show_plain(
            "stopped before the table was complete; no file was written",
            None,
        ),
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

fn show_plain(message: &str, hint: Option<&str>) {
    // A hint may stand in the message itself, as the part after "try:".
    let (message, own) = match message.split_once("\n  try: ") {
        Some((message, own)) => (message, Some(own)),
        None => (message, None),
    };
    let mut group = Group::with_title(Level::ERROR.primary_title(message));
    if let Some(hint) = hint.or(own) {
        group = group.element(Level::HELP.message(hint));
    }
    anstream::eprintln!("{}", Renderer::styled().render(&[group]));
}

/// Shows the place of a finding in the scene's text.
fn show_place(source: &Source, finding: &SceneError) {
    let Some(place) = &finding.place else {
        return show_plain(
            &format!("{}: {}", source.name, finding.message),
            finding.hint.as_deref(),
        );
    };
    let annotation = AnnotationKind::Primary
        .span(place.span.clone())
        .label(finding.path.as_str());
    let snippet = Snippet::source(source.text.as_str())
        .path(source.name.as_str())
        .annotation(annotation);
    let mut group =
        Group::with_title(Level::ERROR.primary_title(finding.message.as_str())).element(snippet);
    if let Some(hint) = &finding.hint {
        group = group.element(Level::HELP.message(hint.as_str()));
    }
    anstream::eprintln!("{}", Renderer::styled().render(&[group]));
}
