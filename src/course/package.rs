//! ZIP packages.

use super::error::CourseError;
use std::io::{Cursor, Write};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// The name that every package's list of contents has.
pub(super) const MANIFEST: &str = "imsmanifest.xml";

/// A package of files by their names, in this order. All have the time at which those of ZIP begin, so that the same files make the same bytes.
pub(super) fn package(files: &[(String, Vec<u8>)]) -> Result<Vec<u8>, CourseError> {
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .last_modified_time(DateTime::default())
        .unix_permissions(0o644);
    let mut package = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in files {
        package.start_file(name.as_str(), options)?;
        package.write_all(bytes)?;
    }
    Ok(package.finish()?.into_inner())
}

/// An identifier of XML for what has that name: it begins with a letter.
pub(super) fn identifier(name: &str) -> String {
    format!("kinegon-{name}")
}
