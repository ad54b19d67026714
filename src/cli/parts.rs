//! What is kept of a study's table until all rows are there: the folder FILE.parts has a file for each block of rows, complete or
//! not there, and the text of what the rows are of. Numbers stand there as they are in memory, little end first, and behind them
//! their sum, by which one that has changed since is told.

use super::files::{Unread, read_unnamed};
use super::message::{Failure, refuse};
use super::output::write_file;
use crate::Problem;
use std::fs::{self, File, TryLockError};
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Rows of a part.
pub(super) const ROWS: u64 = 4096;

/// The file in the folder that says what its rows are of.
const NAME: &str = "study";
/// The file in the folder that a run holds while it is at work.
const LOCK: &str = "lock";

/// What a run does with the parts of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Use {
    /// It computes some, beside others that do so.
    Some,
    /// It computes what is missing, joins all and removes them.
    All,
}

pub(super) struct Parts {
    folder: PathBuf,
    /// Numbers in a row.
    width: usize,
    /// Held until the run ends, where the file system can do that.
    lock: Option<File>,
}

impl Parts {
    /// The parts of the file `output`, of rows of what `text` says; a new folder for them if there is none. While a run joins them
    /// no other is at work on them.
    pub(super) fn open(output: &Path, text: &str, rows: &Range<u64>, width: usize, by: Use) -> Result<Parts, Failure> {
        let folder = folder(output);
        let name = folder.join(NAME);
        let own = format!("{}..{}\n{text}", rows.start, rows.end);
        match fs::create_dir(&folder) {
            Err(error) if error.kind() != io::ErrorKind::AlreadyExists || !folder.is_dir() => {
                return Err(Failure::unwritable(&folder, &error));
            }
            _ => {}
        }
        let lock = locked(&folder, by)?;
        match read_unnamed(&name, None, own.len() as u64) {
            Ok(other) if other == own.as_bytes() => {}
            Ok(_) | Err(Unread::Large(_)) => {
                let folder = folder.display();
                let message = format!("{folder} has rows of another study, of other rows or of another version");
                return refuse(message, "remove that folder, or choose another output");
            }
            Err(Unread::Failed(error)) if error.kind() == io::ErrorKind::NotFound => {
                write_file(&name, own.as_bytes())?;
            }
            Err(why) => return Err(unreadable(&name, &why)),
        }
        Ok(Parts { folder, width, lock })
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
        fs::metadata(self.path(block)).is_ok_and(|found| found.is_file() && found.len() == self.bytes(block) + SUM)
    }

    /// Keeps the numbers of a block.
    pub(super) fn write(&self, block: &Range<u64>, numbers: &[f64]) -> Result<(), Failure> {
        let mut bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        bytes.extend(sum(&bytes).to_le_bytes());
        let path = self.path(block);
        // A pipe in its place would be written to, and wait for its other end.
        if fs::metadata(&path).is_ok_and(|found| !found.is_file()) {
            fs::remove_file(&path).map_err(|error| Failure::unwritable(&path, &error))?;
        }
        write_file(&path, &bytes)
    }

    pub(super) fn read(&self, block: &Range<u64>) -> Result<Vec<f64>, Failure> {
        let path = self.path(block);
        let bytes = match read_unnamed(&path, None, self.bytes(block) + SUM) {
            Err(Unread::Large(_)) => Vec::new(),
            read => read.map_err(|why| unreadable(&path, &why))?,
        };
        let whole = bytes.split_last_chunk().filter(|(numbers, _)| numbers.len() as u64 == self.bytes(block));
        let Some((numbers, _)) = whole.filter(|(numbers, told)| sum(numbers) == u64::from_le_bytes(**told)) else {
            let problem =
                format!("{} is not as it was written: the disk or somebody else has changed it", path.display());
            let hint = "remove that file and start again: its rows alone are computed anew";
            return Err(Failure::Outside(Problem::new(problem).hint(hint)));
        };
        let (numbers, _) = numbers.as_chunks::<8>();
        Ok(numbers.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect())
    }

    /// Removes the folder; that is no failure if somebody else has.
    pub(super) fn remove(self) {
        // Some systems remove no file that is open.
        drop(self.lock);
        let _ = fs::remove_dir_all(self.folder);
    }
}

/// Holds the folder against runs that could not go on beside this one; nothing where the file system cannot do that.
fn locked(folder: &Path, by: Use) -> Result<Option<File>, Failure> {
    let path = folder.join(LOCK);
    // To open a pipe would wait for its other end.
    let is_special = fs::metadata(&path).is_ok_and(|found| !found.is_file());
    let opened = (!is_special).then(|| File::options().append(true).create(true).open(path));
    let Some(Ok(file)) = opened else { return Ok(None) };
    let held = match by {
        Use::Some => file.try_lock_shared(),
        Use::All => file.try_lock(),
    };
    match held {
        Err(TryLockError::WouldBlock) => {
            let message = format!("another run is at work on {}", folder.display());
            Err(Failure::Outside(Problem::new(message).hint("wait until it has ended, or choose another output")))
        }
        held => Ok(held.is_ok().then_some(file)),
    }
}

/// Bytes of a sum.
const SUM: u64 = 8;

/// The sum of bytes: FNV-1a of 64 bits, which any change of one byte changes.
fn sum(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3))
}

/// The folder for the parts of a file.
pub(super) fn folder(output: &Path) -> PathBuf {
    let mut name = output.as_os_str().to_owned();
    name.push(".parts");
    name.into()
}

fn unreadable(path: &Path, why: &Unread) -> Failure {
    Failure::outside(format!("{} {why}", path.display()))
}
