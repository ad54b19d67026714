//! What is done of a long table, in the folder FILE.parts: a file for each block of rows, complete or not there, and the text of what
//! the rows are of. Numbers stand there as they are in memory, little end first.

use super::files::unwritable;
use super::message::Failure;
use super::output::FileSet;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Rows of a part.
pub(super) const ROWS: u64 = 4096;

/// The file in the folder that says what its rows are of.
const NAME: &str = "study";

pub(super) struct Parts {
    folder: PathBuf,
    /// Numbers in a row.
    width: usize,
}

impl Parts {
    /// The parts of the file `output`, of rows of what `text` says; a new folder for them if there is none.
    pub(super) fn open(output: &Path, text: &str, rows: &Range<u64>, width: usize) -> Result<Parts, Failure> {
        let folder = folder(output);
        let name = folder.join(NAME);
        let own = format!("{}..{}\n{text}", rows.start, rows.end);
        if !folder.is_dir() {
            fs::create_dir(&folder).map_err(|error| unwritable(&folder, &error))?;
        }
        match fs::read(&name) {
            Ok(other) if other == own.as_bytes() => {}
            Ok(_) => {
                return Err(Failure::misuse(
                    format!("{} has rows of another study, of other rows or of another version", folder.display()),
                    "remove that folder, or choose another output",
                ));
            }
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => put(&name, own.as_bytes())?,
            Err(error) => return Err(Failure::outside(format!("{} cannot be read: {error}", name.display()))),
        }
        Ok(Parts { folder, width })
    }

    /// Whether a file has parts.
    pub(super) fn are_there(output: &Path) -> bool {
        folder(output).is_dir()
    }

    /// Rows cut into blocks, at multiples of [`ROWS`].
    pub(super) fn blocks(rows: &Range<u64>) -> impl Iterator<Item = Range<u64>> {
        let (start, end) = (rows.start, rows.end);
        (start / ROWS..end.div_ceil(ROWS)).map(move |block| start.max(block * ROWS)..end.min((block + 1) * ROWS))
    }

    fn path(&self, block: &Range<u64>) -> PathBuf {
        self.folder.join(format!("{:010}-{:010}", block.start, block.end))
    }

    fn bytes(&self, block: &Range<u64>) -> u64 {
        (block.end - block.start) * (self.width * size_of::<f64>()) as u64
    }

    /// Whether a block is there.
    pub(super) fn has(&self, block: &Range<u64>) -> bool {
        fs::metadata(self.path(block)).is_ok_and(|found| found.len() == self.bytes(block))
    }

    /// Keeps the numbers of a block.
    pub(super) fn write(&self, block: &Range<u64>, numbers: &[f64]) -> Result<(), Failure> {
        let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        put(&self.path(block), &bytes)
    }

    pub(super) fn read(&self, block: &Range<u64>) -> Result<Vec<f64>, Failure> {
        let path = self.path(block);
        let bytes =
            fs::read(&path).map_err(|error| Failure::outside(format!("{} cannot be read: {error}", path.display())))?;
        if bytes.len() as u64 != self.bytes(block) {
            let message = format!("{} is not complete; remove it and start again", path.display());
            return Err(Failure::outside(message));
        }
        let (numbers, _) = bytes.as_chunks::<8>();
        Ok(numbers.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect())
    }

    /// Removes the folder; that is no failure if somebody else has.
    pub(super) fn remove(self) {
        let _ = fs::remove_dir_all(self.folder);
    }
}

fn folder(output: &Path) -> PathBuf {
    let mut name = output.as_os_str().to_owned();
    name.push(".parts");
    name.into()
}

/// Writes one file, which is complete or not there.
fn put(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let mut files = FileSet::default();
    files.add(path, bytes)?;
    files.finish()
}
