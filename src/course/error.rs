use crate::check::CheckError;
use std::io;

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
