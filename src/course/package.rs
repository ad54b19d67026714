//! What the files of courses are written with: XML, and ZIP packages.

use crate::check::CheckError;
use quick_xml::Writer;
use quick_xml::events::{BytesCData, BytesDecl, BytesText, Event};
use std::io;
use std::io::{Cursor, Write};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// Why a file of a course could not be made.
#[derive(Debug, thiserror::Error)]
pub enum CourseError {
    /// The exercise cannot be asked.
    #[error(transparent)]
    Exercise(#[from] CheckError),
    /// A sheet cannot be written as PDF.
    #[cfg(feature = "pdf")]
    #[error(transparent)]
    Pdf(#[from] crate::format::PdfError),
    /// The XML could not be written.
    #[error("the XML of the course cannot be written: {0}")]
    Xml(#[from] io::Error),
    /// The package could not be put together.
    #[error("the package of the course cannot be put together: {0}")]
    Package(#[from] zip::result::ZipError),
}

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

/// A document that is being written.
pub(super) type Document = Writer<Vec<u8>>;

/// A document with that root element.
pub(super) fn document(
    root: &str,
    attributes: &[(&str, &str)],
    inner: impl FnOnce(&mut Document) -> io::Result<()>,
) -> Result<Vec<u8>, CourseError> {
    let mut document = Writer::new_with_indent(Vec::new(), b' ', 1);
    document.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    element(&mut document, root, attributes, inner)?;
    let mut bytes = document.into_inner();
    bytes.push(b'\n');
    Ok(bytes)
}

/// An element with others in it.
pub(super) fn element(
    document: &mut Document,
    name: &str,
    attributes: &[(&str, &str)],
    inner: impl FnOnce(&mut Document) -> io::Result<()>,
) -> io::Result<()> {
    document.create_element(name).with_attributes(attributes.iter().copied()).write_inner_content(inner)?;
    Ok(())
}

/// An element without anything in it.
pub(super) fn empty(document: &mut Document, name: &str, attributes: &[(&str, &str)]) -> io::Result<()> {
    document.create_element(name).with_attributes(attributes.iter().copied()).write_empty()?;
    Ok(())
}

/// An element with a text in it.
pub(super) fn text(document: &mut Document, name: &str, attributes: &[(&str, &str)], text: &str) -> io::Result<()> {
    let element = document.create_element(name).with_attributes(attributes.iter().copied());
    element.write_text_content(BytesText::new(text))?;
    Ok(())
}

/// An element `text` with HTML in it, which no letter of the HTML ends.
pub(super) fn html(document: &mut Document, html: &str) -> io::Result<()> {
    element(document, "text", &[], |document| {
        BytesCData::escaped(html).try_for_each(|part| document.write_event(Event::CData(part)))
    })
}
