//! What the files of courses are written with: XML, and ZIP packages.

use crate::check::CheckError;
use flate2::Compression;
use flate2::write::DeflateEncoder;
use quick_xml::Writer;
use quick_xml::events::{BytesCData, BytesDecl, BytesStart, BytesText, Event};
use rawzip::time::UtcDateTime;
use rawzip::{CompressionMethod, ZipArchiveWriter};
use std::io;
use std::io::Write;

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
    Package(#[from] rawzip::Error),
}

/// The name that every package's list of contents has.
pub(super) const MANIFEST: &str = "imsmanifest.xml";

/// When the time of ZIP begins.
const BEGIN: UtcDateTime = UtcDateTime::from_components(1980, 1, 1, 0, 0, 0, 0).expect("a date");
/// A file that its owner writes and all others read.
const PERMISSIONS: u32 = 0o100_644;

/// A package of files by their names, in this order. All have the time at which those of ZIP begin, so that the same files make the same bytes.
pub(super) fn package(files: &[(String, Vec<u8>)]) -> Result<Vec<u8>, CourseError> {
    let mut package = ZipArchiveWriter::new(Vec::new());
    for (name, bytes) in files {
        let file = package.new_file(name.as_str()).compression_method(CompressionMethod::DEFLATE);
        let (mut file, sum) = file.last_modified(BEGIN).unix_permissions(PERMISSIONS).start()?;
        let mut packed = sum.wrap(DeflateEncoder::new(&mut file, Compression::default()));
        packed.write_all(bytes).map_err(rawzip::Error::from)?;
        let (packed, sum) = packed.finish()?;
        packed.finish().map_err(rawzip::Error::from)?;
        file.finish(sum)?;
    }
    Ok(package.finish()?)
}

/// An identifier of XML for what has that name: it begins with a letter.
pub(super) fn identifier(name: &str) -> String {
    format!("kinegon-{name}")
}

/// An element of XML with what is in it, as a writer takes it.
pub(super) struct Element(Vec<Event<'static>>);

/// The names and values of attributes.
pub(super) type Attributes<'a> = &'a [(&'static str, &'a str)];

/// An element with others in it, or with nothing.
pub(super) fn element(name: &'static str, attributes: Attributes<'_>, inner: Vec<Element>) -> Element {
    match inner.is_empty() {
        true => Element(vec![Event::Empty(start(name, attributes))]),
        false => Element::around(start(name, attributes), inner.into_iter().flat_map(|element| element.0)),
    }
}

/// An element with a text in it.
pub(super) fn text(name: &'static str, attributes: Attributes<'_>, text: &str) -> Element {
    Element::around(start(name, attributes), [Event::Text(BytesText::new(text).into_owned())])
}

/// An element `text` with HTML in it, which no letter of it ends.
pub(super) fn html(html: &str) -> Element {
    let parts = BytesCData::escaped(html).map(|part| Event::CData(part.into_owned()));
    Element::around(start("text", &[]), parts)
}

fn start(name: &'static str, attributes: Attributes<'_>) -> BytesStart<'static> {
    BytesStart::new(name).with_attributes(attributes.iter().copied())
}

impl Element {
    fn around(start: BytesStart<'static>, inner: impl IntoIterator<Item = Event<'static>>) -> Element {
        let end = Event::End(start.to_end().into_owned());
        Element([Event::Start(start)].into_iter().chain(inner).chain([end]).collect())
    }

    /// The document with this root.
    pub(super) fn document(self) -> Result<Vec<u8>, CourseError> {
        let mut document = Writer::new_with_indent(Vec::new(), b' ', 1);
        document.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
        self.0.into_iter().try_for_each(|event| document.write_event(event))?;
        let mut bytes = document.into_inner();
        bytes.push(b'\n');
        Ok(bytes)
    }
}
