//! Kinds of files that are read strictly, for messages.

/// A kind of file: its name in messages and the key with the version of its format.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FileKind {
    /// Its name, as `scene`.
    pub what: &'static str,
    /// The key of the version.
    pub key: &'static str,
    /// The version that is read.
    pub version: u64,
}

impl FileKind {
    /// A scene.
    pub(super) const SCENE: FileKind = FileKind { what: "scene", key: "kinegon", version: 1 };

    /// How such a file begins, in a sentence for a hint.
    pub(super) fn beginning(&self) -> String {
        format!("a {} begins with {}", self.what, self.start())
    }

    /// How such a file begins, as JSON.
    pub(super) fn start(&self) -> String {
        format!(r#"{{ "{}": {}, … }}"#, self.key, self.version)
    }
}
