//! The kinds of files that are read strictly, in the words of messages.

/// A kind of file: what it is called, and by which key it gives the version of its format.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FileKind {
    /// What one such file is called, as `scene`.
    pub what: &'static str,
    /// The key of the version.
    pub key: &'static str,
    /// The version that this program reads.
    pub version: u64,
}

impl FileKind {
    /// A mechanism.
    pub(super) const SCENE: FileKind = FileKind { what: "scene", key: "kinegon", version: 1 };

    /// How such a file begins, for a hint.
    pub(super) fn beginning(&self) -> String {
        format!("a {} begins with {}", self.what, self.start())
    }

    /// Its first characters.
    pub(super) fn start(&self) -> String {
        format!(r#"{{ "{}": {}, … }}"#, self.key, self.version)
    }
}
