//! Writes XML.

use super::error::CourseError;
use quick_xml::Writer;
use quick_xml::events::{BytesCData, BytesDecl, BytesText, Event};
use std::io;

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
